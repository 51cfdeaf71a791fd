//! What the parameters set.

use super::codes::{CYCLE_OFF, G_CODES};
use crate::dialect::{GCode, ResetRules, Rules, ScalingRules};
use crate::modal::Modal;
use crate::stages::cutter;
use crate::stroke::{STROKE_AXES, StrokeRules};
use ferrocut_geometry::Axis;
use ferrocut_machine::{ParameterKey, Parameters};

/// Subprograms nested in the main program (3.2.2 note 3).
const CALL_DEPTH: usize = 4;

/// Macro calls nested (4.9.3 note 4).
const MACRO_DEPTH: usize = 5;

/// Reads the rules.
pub fn rules(parameters: &Parameters) -> Rules {
    let p = |number| parameters.data(number);
    let min_feed = p(97);
    Rules {
        default_feed: p(87),
        min_feed,
        // Inconsistent limits are an alarm of the parameter page (0080); the upper one goes before.
        max_feed: p(96).max(min_feed),
        // 7.2.2 note 2.
        max_feed_per_revolution: 500.0,
        max_spindle_rpm: p(258),
        rapid_is_straight: parameters.bit(12, 1),
        // 4.2.3 B.
        helix_feed_along_circle: true,
        arc_tolerance: p(214),
        // Table 4-2-5-2: P counts 0.001 s, with 5#1 0.0001 s.
        dwell_p_unit_s: if parameters.bit(5, 1) { 0.0001 } else { 0.001 },
        dwell_in_revolutions: parameters.bit(34, 0),
        length_on_plane_normal: parameters.bit(39, 0),
        repeats_are_alarms: parameters.bit(32, 6),
        m_codes_in_block: if parameters.bit(33, 7) { 3 } else { 1 },
        max_call_depth: CALL_DEPTH,
        max_macro_depth: MACRO_DEPTH,
        max_repeats: 9999.0,
        chip_break_retract: p(270),
        peck_clearance: p(271),
        peck_needs_depth: parameters.bit(43, 1),
        // 42#5 chooses the axis, 42#4 the direction (4.4.6).
        shift: (
            if parameters.bit(42, 5) { Axis::Y } else { Axis::X },
            if parameters.bit(42, 4) { -1.0 } else { 1.0 },
        ),
        pocket_helix_factor: p(269),
        cutter: cutter::Rules {
            start_up: if parameters.bit(40, 0) { cutter::StartUp::B } else { cutter::StartUp::A },
            interference: parameters.bit(41, 6),
            corner_limit: p(266).max(cutter::Rules::default().corner_limit),
            ..cutter::Rules::default()
        },
        // 16#7, P144, P145 (4.8.2).
        corner_override: parameters.bit(16, 7).then(|| (p(144), p(145))),
        stroke: stroke(parameters),
        max_coordinate: 99_999.999_9,
        // 1.2: three axes together, four with 9#1.
        max_moving_axes: if parameters.bit(9, 1) { 4 } else { 3 },
        // 1#2: a spindle switched by I/O points has no encoder.
        spindle_has_position: !parameters.bit(1, 2),
        max_tool: 10f64.powi(p(206).clamp(1.0, 8.0) as i32) - 1.0,
        radius_is_diameter: parameters.bit(40, 7),
        corner_arc: parameters.bit(41, 5),
        rigid_tapping: parameters.bit(46, 1),
        max_tapping_rpm: p(257),
        peck_tapping_is_fast: parameters.bit(44, 5),
        peck_tapping_retract: p(284),
        scaling: ScalingRules {
            enabled: parameters.bit(60, 5),
            factors_by_axis: parameters.bit(47, 6),
            factor: p(330),
            axis_factors: [p(331), p(332), p(333)],
            axes: [parameters.bit(47, 3), parameters.bit(47, 4), parameters.bit(47, 5)],
        },
        rotation_angle: p(329),
        rotation_follows_g91: parameters.bit(47, 0),
        one_way_overshoot: [p(335), p(336), p(337), p(338)],
        one_way_dwell_s: p(334),
        one_way_is_modal: parameters.bit(48, 0),
        surface_speed: parameters.bit(61, 0),
        // Table 4-7-1-1.
        max_offset: 999.999,
        cycle_dwell: (p(281) / 1000.0, p(282) / 1000.0),
        cycle_needs_speed: true,
        axes: axis_order(parameters).into_iter().take(CONTROLLED_AXES).collect(),
        axis_order: axis_order(parameters),
    }
}

/// Axes that a program may name: X, Y, Z and one more (1.2). P5 counts those of the machine at hand,
/// which the machine file does here.
const CONTROLLED_AXES: usize = 4;

/// The names of axes 1 to 5 (P175 to P179); names that repeat fall back to X, Y, Z, A (2.2).
fn axis_order(parameters: &Parameters) -> [Axis; 5] {
    let named: [Option<Axis>; 5] =
        std::array::from_fn(|i| Axis::ALL.get(parameters.data(175 + i as u16) as usize).copied());
    let distinct = (0..5).all(|i| named[i].is_some() && !named[..i].contains(&named[i]));
    let standard = [Axis::X, Axis::Y, Axis::Z, Axis::A, Axis::B];
    if distinct { std::array::from_fn(|i| named[i].unwrap_or(standard[i])) } else { standard }
}

/// Bounds of the stored stroke checks, P66 to P75 and P76 to P85: lower and upper by axis.
fn stroke(parameters: &Parameters) -> StrokeRules {
    let bounds = |from: u16| {
        std::array::from_fn(|axis| {
            let number = from + 2 * axis as u16;
            (parameters.data(number), parameters.data(number + 1))
        })
    };
    let first: [(f64, f64); STROKE_AXES] = bounds(66);
    // The standard setting of ±9999 is no bound.
    let is_bound = |(lower, upper): &(f64, f64)| *lower > -9999.0 || *upper < 9999.0;
    StrokeRules {
        first_is_set: first.iter().any(is_bound),
        first,
        second: bounds(76),
        second_forbids_outside: parameters.bit(11, 0),
        second_parameter: 76,
    }
}

/// Parameters that G10 cannot set: the mode 0#7 and the unit of input 0#2 (4.2.7 notes 6 and 9).
pub fn is_fixed(key: &ParameterKey) -> bool {
    matches!(key, ParameterKey::Bit { number: 0, bit: 2 | 7 })
}

fn code(tenths: u16) -> &'static GCode {
    let found = G_CODES.binary_search_by_key(&tenths, |g| g.tenths).ok().and_then(|at| G_CODES.get(at));
    found.unwrap_or(&CYCLE_OFF)
}

/// What a reset clears: groups 1 to 7 by 35#1 to 35#7, groups 8 to 15 by 36#0 to 36#7 (4.1 note 7).
pub fn reset(parameters: &Parameters) -> ResetRules {
    let group = |n: u8| if n < 8 { parameters.bit(35, n) } else { parameters.bit(36, n - 8) };
    ResetRules {
        groups: (1..=15).filter(|n| group(*n)).fold(0, |bits, n| bits | 1 << n),
        feed_and_offsets: parameters.bit(34, 7),
        locals: parameters.bit(52, 7),
        commons: parameters.bit(52, 6),
    }
}

/// Modal state at power-on (table 4-1-2, bits 31#0, 31#1, 31#2, 31#4, 0#2).
pub fn power_on(parameters: &Parameters) -> Modal {
    let bit = |number, bit| parameters.bit(number, bit);
    let plane = match (bit(31, 1), bit(31, 2)) {
        (_, true) => 190,
        (true, false) => 180,
        (false, false) => 170,
    };
    let codes = [
        if bit(31, 0) { 10 } else { 0 },
        plane,
        if bit(31, 4) { 910 } else { 900 },
        940,
        540,
        if bit(0, 2) { 200 } else { 210 },
        400,
        490,
        800,
        980,
        150,
        500,
        690,
        640,
        970,
        if bit(31, 5) { 130 } else { 120 },
    ];
    Modal::new(&CYCLE_OFF, codes.map(code))
}
