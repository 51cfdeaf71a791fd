//! What the parameters set.

use super::codes::G_CODES;
use crate::coordinates::{self, SetPosition};
use crate::cycles::{self, NoDepth, Repeat, Restart, RigidSpeeds, Tapping};
use crate::dialect::{ResetRules, Rules, ScalingRules};
use crate::dialects::fanuc;
use crate::modal::Modal;
use crate::motion;
use crate::stages::cutter;
use crate::stages::polar::PoleRule;
use crate::stroke::{STROKE_AXES, StrokeRules};
use ferrocut_geometry::{Axis, AxisSet};
use ferrocut_machine::{ParameterKey, Parameters};
use ferrocut_toolpath::CornerRule;

/// Subprograms nested in the main program (3.2.2 note 3).
const CALL_DEPTH: usize = 4;

/// Macro calls nested (4.9.3 note 4).
const MACRO_DEPTH: usize = 5;

/// The axes that are scaled.
const LINEAR: [Axis; 3] = [Axis::X, Axis::Y, Axis::Z];

/// P257, P294 to P297 and the gears (P246 to P248, bits 1#2 and 38#5).
fn rigid_speeds(parameters: &Parameters) -> RigidSpeeds {
    let p = |number| parameters.data(number);
    let up_to =
        |speed: u16| if p(speed + 1) > 0.0 && !parameters.bit(1, 2) { p(speed) } else { f64::INFINITY };
    RigidSpeeds {
        highest: p(257),
        in_gear: [294, 295, 296, 297].map(p),
        gear_up_to: (!parameters.bit(38, 5)).then(|| [246, 247].map(up_to)),
    }
}

/// 15#2, P144, P146: which corners are slowed down for.
pub fn corner_rule(parameters: &Parameters) -> CornerRule {
    match parameters.bit(15, 2) {
        true => CornerRule::SpeedDifference(parameters.data(146)),
        false => CornerRule::Angle(parameters.data(144)),
    }
}

/// Reads the rules.
pub fn rules(parameters: &Parameters) -> Rules {
    let p = |number| parameters.data(number);
    let order = axis_order(parameters);
    let number = |axis| order.iter().take(3).position(|other| *other == axis);
    let min_feed = p(97);
    Rules {
        default_feed: p(87),
        min_feed,
        // Inconsistent limits are an alarm of the parameter page (0080); the upper one goes before.
        max_feed: p(96).max(min_feed),
        // 7.2.2 note 2.
        max_feed_per_revolution: 500.0,
        max_spindle_rpm: p(258),
        // 6.2.
        speed_is_gear: parameters.bit(1, 2),
        rapid_is_straight: parameters.bit(12, 1),
        single_in_macros: parameters.bit(51, 5),
        // 4.2.3 B.
        helix_feed_along_circle: true,
        arc_tolerance: p(214),
        // Table 4-2-5-2: P counts 0.001 s, with 5#1 0.0001 s.
        dwell_letter: b'X',
        // 4.2.5: where both stand X is valid.
        dwell_p_decides: false,
        dwell_p_unit_s: if parameters.bit(5, 1) { 0.0001 } else { 0.001 },
        dwell_in_revolutions: parameters.bit(34, 0),
        length_on_plane_normal: parameters.bit(39, 0),
        // 4.7.1, 4.
        h00_waits: true,
        length_not_with: &[],
        repeats_are_alarms: parameters.bit(32, 6),
        // Table 4-9-2-5 note 1: each letter once.
        arguments_in_sets: false,
        distance_is_exclusive: false,
        // 3.1.2 note.
        data_has_number: true,
        sequence_takes_expression: false,
        m_codes_in_block: if parameters.bit(33, 7) { 3 } else { 1 },
        max_call_depth: CALL_DEPTH,
        max_macro_depth: MACRO_DEPTH,
        max_repeats: 9999.0,
        // Table 3-1-3-1.
        counts_take_any_number: false,
        cycles: cycles(parameters),
        motion: motion::Rules {
            near_way: if parameters.bit(9, 0) { axes_by_kind(parameters, true) } else { AxisSet::EMPTY },
            ..motion::Rules::default()
        },
        coordinates: coordinates::Rules {
            set_position: SetPosition::OwnSystem,
            ..coordinates::Rules::default()
        },
        cutter: cutter::Rules {
            start_up: if parameters.bit(40, 0) { cutter::StartUp::B } else { cutter::StartUp::A },
            interference: parameters.bit(41, 6),
            corner_limit: p(266),
            // 4.7.3, 8 b: what one block without movement leaves as it is two do not.
            blind_from: Some(2),
            ..cutter::Rules::default()
        },
        // 4.8.2, 2; limit 1: not where cutting is accelerated before interpolation, which look-ahead does too.
        corner_override: (parameters.bit(16, 7) && parameters.bit(17, 0) && !parameters.bit(15, 0))
            .then(|| (corner_rule(parameters), p(145))),
        stroke: stroke(parameters),
        max_coordinate: 99_999.999_9,
        // 1.2: three axes together, four with 9#1.
        // 0#7: high-speed mode moves three together whatever 9#1 says.
        max_moving_axes: if parameters.bit(9, 1) && !parameters.bit(0, 7) { 4 } else { 3 },
        // 1#2: a spindle switched by I/O points cannot stop at an angle.
        spindle_has_position: !parameters.bit(1, 2),
        // 7.2.2: 13#1 tells of an encoder, 13#0 allows G95 without.
        feed_per_revolution: parameters.bit(13, 1) || parameters.bit(13, 0),
        max_tool: digits(p(206)),
        tool_chooses_offsets: false,
        end_stops_spindle: true,
        fixed_point: None,
        orients_to_speed_word: false,
        max_speed_word: digits(p(205)),
        max_m_code: digits(p(204)),
        radius_is_diameter: parameters.bit(40, 7),
        corner_arc: parameters.bit(41, 5),
        scaling: ScalingRules {
            enabled: parameters.bit(60, 5),
            factors_by_axis: parameters.bit(47, 6),
            factor: p(330),
            // Parameters are of the first to the third axis, whatever their names.
            axis_factors: LINEAR.map(|axis| number(axis).map_or(1.0, |n| p(331 + n as u16))),
            axes: LINEAR.map(|axis| number(axis).is_some_and(|n| parameters.bit(47, 3 + n as u8))),
        },
        rotation_angle: p(329),
        rotation_follows_g91: parameters.bit(47, 0),
        max_rotation: f64::INFINITY,
        pole: PoleRule::Radius,
        // Alarms 0160 and 0161; 0216 to 0220.
        polar_is_strict: true,
        transforms_are_strict: true,
        // 4.2.17 note 6.
        units_stand_alone: true,
        one_way_overshoot: [p(335), p(336), p(337), p(338), p(339)],
        one_way_dwell_s: p(334),
        one_way_is_modal: parameters.bit(48, 0),
        surface_speed: parameters.bit(61, 0),
        skip_needs_signal: false,
        surface_min_rpm: p(255),
        // The coding of P254 is not printed: 1 for the first axis, 0 too, as on Fanuc.
        surface_axis: order.get((p(254) as usize).saturating_sub(1)).copied().unwrap_or(Axis::X),
        // Table 4-7-1-1.
        max_offset: 999.999,
        tools_carry_offsets: false,
        functions_before_point: false,
        plane_ends_cycle: false,
        max_wear: p(267),
        // Range of P10 to P44 (4.2.7 note 3).
        max_zero: 9_999.999_9,
        reference_keeps_cutter: !parameters.bit(40, 2),
        axes: order.into_iter().take(controlled_axes(parameters)).collect(),
        linear_axes: axes_by_kind(parameters, false),
        axis_order: order,
    }
}

/// The canned cycles (4.4 to 4.6).
fn cycles(parameters: &Parameters) -> cycles::Rules {
    let p = |number| parameters.data(number);
    cycles::Rules {
        repeat_letter: b'K',
        other_repeat_letter: None,
        repeat: Repeat::Block,
        // Table 4-4-1, K.
        repeats_lose_sign: true,
        in_any_plane: false,
        chip_break_retract: p(270),
        peck_clearance: p(271),
        // 4.4.1 note 2.
        no_depth: if parameters.bit(43, 1) { NoDepth::Alarm } else { NoDepth::Position },
        // 42#5 chooses the axis, 42#4 the direction (4.4.6).
        shift: (
            axis_order(parameters)[usize::from(parameters.bit(42, 5))],
            if parameters.bit(42, 4) { -1.0 } else { 1.0 },
        ),
        default_shift: 0.0,
        restart: Restart::AsBefore,
        restart_aside: false,
        tapping: Tapping::Feed {
            rigid: parameters.bit(46, 1),
            rigid_speeds: rigid_speeds(parameters),
            // 44#4, P283 in steps of 1 % or with 45#3 of 10 %.
            rigid_retract: match parameters.bit(44, 4) {
                true => p(283).max(1.0) * if parameters.bit(45, 3) { 0.1 } else { 0.01 },
                false => 1.0,
            },
            rigid_orients: parameters.bit(46, 5),
            steps_are_fast: parameters.bit(44, 5),
            retract: p(284),
        },
        max_tapping_rpm: p(257),
        dwell: (p(281) / 1000.0, p(282) / 1000.0),
        // Milliseconds, also where 5#1 makes G04 count finer (4.4, table 4-4-2).
        dwell_p_unit_s: 0.001,
        needs_speed: true,
        length_at_start_only: false,
        stand_beside_motion: false,
        // 4.4.6 to 4.4.11.
        boring_needs_axis: true,
        pocket_helix_factor: p(269),
    }
}

/// The largest number of some digits.
fn digits(count: f64) -> f64 {
    10f64.powi(count.clamp(1.0, 9.0) as i32) - 1.0
}

/// Axes that a program may name: X, Y, Z and one more (1.2), five where P5 says so. A smaller P5 counts
/// the axes of the machine at hand, which the machine file does here.
fn controlled_axes(parameters: &Parameters) -> usize {
    if parameters.data(5) >= 5.0 { 5 } else { 4 }
}

/// The axes that are rotary, or those that are linear (8#0 to 8#4).
fn axes_by_kind(parameters: &Parameters, rotary: bool) -> AxisSet {
    let order = (0u8..).zip(axis_order(parameters));
    order.filter(|(i, _)| parameters.bit(8, *i) == rotary).map(|(_, axis)| axis).collect()
}

/// Axes 1 to 5; a fifth that has no name of its own is one that no program can name.
fn axis_order(parameters: &Parameters) -> [Axis; 5] {
    let named = parameters.axis_names();
    let spare = Axis::ALL.into_iter().find(|axis| !named.contains(axis)).unwrap_or(Axis::W);
    std::array::from_fn(|i| named.get(i).copied().unwrap_or(spare))
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

/// Parameters that G10 cannot set: the mode 0#7 and the unit of input 0#2 (4.2.7 notes 6 and 9), and what
/// acts from the next power-on (note 5): number, kind and names of the axes.
pub fn is_fixed(key: &ParameterKey) -> bool {
    matches!(
        key,
        ParameterKey::Bit { number: 0, bit: 2 | 7 }
            | ParameterKey::Bit { number: 8, bit: 0..=4 }
            | ParameterKey::Data(5 | 175..=179)
    )
}

/// Parameters that are work zeros: those of the external system and of G54 to G59, five axes each.
pub fn is_work_zero(key: &ParameterKey) -> bool {
    matches!(key, ParameterKey::Data(10..=44))
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
    Modal::new(&fanuc::CYCLE_OFF, codes.map(|tenths| fanuc::row(&G_CODES, tenths)))
}
