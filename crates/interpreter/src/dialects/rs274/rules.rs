//! Choices of the language.

use super::arcs::SPIRAL_INCH;
use super::codes::{G_CODES, LENGTH_OFF};
use crate::coordinates;
use crate::cycles::{self, NoDepth, Repeat, Restart, Tapping};
use crate::dialect::{ResetRules, Rules, ScalingRules};
use crate::dialects::fanuc;
use crate::modal::Modal;
use crate::motion;
use crate::stages::cutter;
use crate::stages::polar::PoleRule;
use crate::stroke::{STROKE_AXES, StrokeRules};
use ferrocut_geometry::{Axis, MM_PER_INCH};
use ferrocut_machine::Parameters;

/// Parameters have numbers from 1 to this one (LinuxCNC, parameters).
pub const LAST_PARAMETER: u32 = 5601;

/// Reads the rules.
pub fn rules(_: &Parameters) -> Rules {
    let unbounded = [(f64::NEG_INFINITY, f64::INFINITY); STROKE_AXES];
    Rules {
        default_feed: 0.0,
        min_feed: 0.0,
        max_feed: f64::INFINITY,
        max_feed_per_revolution: f64::INFINITY,
        max_spindle_rpm: f64::INFINITY,
        rapid_is_straight: true,
        helix_feed_along_circle: false,
        // The widest of its own rule (`arcs`): that of inch programs.
        arc_tolerance: SPIRAL_INCH * MM_PER_INCH,
        dwell_letter: b'P',
        dwell_p_unit_s: 1.0,
        dwell_in_revolutions: false,
        length_on_plane_normal: true,
        h00_waits: false,
        length_not_with: &[],
        repeats_are_alarms: true,
        distance_is_exclusive: true,
        m_codes_in_block: 4,
        max_call_depth: 0,
        max_macro_depth: 0,
        max_repeats: 0.0,
        cycles: cycles(),
        motion: motion::Rules::default(),
        coordinates: coordinates::Rules::default(),
        cutter: cutter::Rules { method: cutter::Method::OneAhead, ..cutter::Rules::default() },
        radius_is_diameter: false,
        corner_override: None,
        stroke: StrokeRules {
            first: unbounded,
            second: unbounded,
            second_forbids_outside: false,
            second_parameter: 0,
            first_is_set: false,
        },
        max_coordinate: 1e8,
        max_moving_axes: 9,
        spindle_has_position: true,
        feed_per_revolution: true,
        max_tool: 9999.0,
        max_speed_word: f64::INFINITY,
        max_m_code: 9999.0,
        tool_chooses_offsets: false,
        end_stops_spindle: true,
        orients_to_speed_word: false,
        corner_arc: false,
        scaling: ScalingRules {
            enabled: false,
            factors_by_axis: false,
            factor: 1.0,
            axis_factors: [1.0; 3],
            axes: [false; 3],
        },
        rotation_angle: 0.0,
        rotation_follows_g91: false,
        max_rotation: f64::INFINITY,
        pole: PoleRule::Code,
        polar_is_strict: false,
        transforms_are_strict: false,
        one_way_overshoot: [0.0; 5],
        one_way_dwell_s: 0.0,
        one_way_is_modal: false,
        surface_speed: true,
        surface_min_rpm: 0.0,
        surface_axis: Axis::X,
        max_offset: 99_999_999.0,
        max_wear: 99_999_999.0,
        skip_needs_signal: false,
        max_zero: 99_999_999.0,
        reference_keeps_cutter: false,
        tools_carry_offsets: false,
        plane_ends_cycle: true,
        axes: Axis::ALL.into_iter().collect(),
        linear_axes: Axis::ALL.into_iter().filter(|axis| axis.is_linear()).collect(),
        axis_order: [Axis::X, Axis::Y, Axis::Z, Axis::A, Axis::B],
    }
}

/// What the cycles of other controls read has no bearing here.
fn cycles() -> cycles::Rules {
    cycles::Rules {
        repeat_letter: b'K',
        other_repeat_letter: None,
        repeat: Repeat::Block,
        in_any_plane: true,
        chip_break_retract: 0.0,
        peck_clearance: 0.0,
        no_depth: NoDepth::Alarm,
        shift: (Axis::X, 1.0),
        default_shift: 0.0,
        restart: Restart::AsBefore,
        tapping: Tapping::Floating,
        max_tapping_rpm: f64::INFINITY,
        dwell: (0.0, f64::INFINITY),
        dwell_p_unit_s: 1.0,
        needs_speed: false,
        length_at_start_only: false,
        stand_beside_motion: false,
        pocket_helix_factor: 0.0,
    }
}

/// An abort leaves the codes in force as they are.
pub fn reset(_: &Parameters) -> ResetRules {
    ResetRules { groups: 0, feed_and_offsets: false, locals: true, commons: false }
}

/// Modal state at power-on (LinuxCNC, G-code overview, defaults; a machine is metric here).
pub fn power_on(_: &Parameters) -> Modal {
    let codes = [800, 170, 900, 911, 940, 210, 400, 490, 540, 640, 970, 990, 80];
    Modal::new(&LENGTH_OFF, codes.into_iter().map(|tenths| fanuc::row(G_CODES, tenths)))
}
