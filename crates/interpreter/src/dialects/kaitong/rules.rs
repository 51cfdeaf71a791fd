//! What the parameters set, and what is fixed.

use super::codes::{CYCLE_GROUP, G_CODES, POLAR_GROUP};
use crate::cycles::{self, NoDepth, Repeat, Restart, Tapping};
use crate::dialect::{ResetRules, Rules};
use crate::dialects::fanuc;
use crate::modal::Modal;
use ferrocut_geometry::Axis;
use ferrocut_machine::{Fault, Parameters};

/// Depth of cut and distance aside where Q is missing or 0, mm (appendix 7, 2.1, 2.3, 2.6, 2.10).
const DEFAULT_Q: f64 = 0.1;

/// Seconds that P1 stands for (appendix 8, example: P2000).
const DWELL_UNIT_S: f64 = 0.001;

/// Codes that may not stand in a block with tool length (appendix 8, note 1).
const LENGTH_NOT_WITH: &[(u16, Fault)] = &[
    (20, Fault::LengthInArc),
    (30, Fault::LengthInArc),
    (40, Fault::LengthWithCode),
    (310, Fault::LengthWithCode),
    (920, Fault::LengthWithCoordinateSet),
    (1420, Fault::LengthWithCode),
    (1430, Fault::LengthWithCode),
];

/// Reads the rules.
pub fn rules(parameters: &Parameters) -> Rules {
    Rules {
        max_feed_per_revolution: 500.0,
        max_spindle_rpm: 99_999.0,
        rapid_is_straight: false,
        helix_feed_along_circle: true,
        arc_tolerance: 0.05,
        dwell_p_unit_s: DWELL_UNIT_S,
        // Appendix 8, 1.1.1.
        length_on_plane_normal: true,
        // Appendix 8, 1.1.4.
        h00_waits: false,
        length_not_with: LENGTH_NOT_WITH,
        distance_is_exclusive: false,
        // The appendices leave G65 to the main manual; Fanuc 0i-M.
        arguments_in_sets: true,
        m_codes_in_block: 3,
        max_call_depth: 4,
        max_macro_depth: 4,
        max_repeats: 9999.0,
        cycles: cycles(parameters),
        max_coordinate: 99_999.999,
        max_moving_axes: 4,
        max_speed_word: 99_999.0,
        max_m_code: 999.0,
        // Appendix 10, "repeated rotation".
        rotation_follows_g91: parameters.bit(24, 0),
        // Appendix 10, R.
        max_rotation: 360.0,
        // Appendix 11: P021.3.
        skip_needs_signal: parameters.bit(21, 3),
        // Appendix 8, 1.1.3: ±9999999 of the least input unit, 0.001 mm.
        max_offset: 9999.999,
        max_wear: 9999.999,
        max_zero: 99_999.999,
        axes: [Axis::X, Axis::Y, Axis::Z, Axis::A].into_iter().collect(),
        linear_axes: [Axis::X, Axis::Y, Axis::Z].into_iter().collect(),
        ..Rules::default()
    }
}

/// The canned cycles (appendix 7).
fn cycles(parameters: &Parameters) -> cycles::Rules {
    // P230 is in 0.001 mm.
    let retract = parameters.data(230) / 1000.0;
    cycles::Rules {
        // 1.7.
        repeat_letter: b'L',
        repeat: Repeat::Line,
        in_any_plane: false,
        chip_break_retract: retract,
        peck_clearance: retract,
        no_depth: NoDepth::Depth(DEFAULT_Q),
        // 2.3 and 2.10 name the bits and not what they say: as 42#5 and 42#4 of the GSK990MC, whose cycles
        // are the same.
        shift: (
            if parameters.bit(18, 5) { Axis::Y } else { Axis::X },
            if parameters.bit(18, 4) { -1.0 } else { 1.0 },
        ),
        default_shift: DEFAULT_Q,
        // 2.3, 2.9 to 2.11: M03 whatever the spindle did.
        restart: Restart::Clockwise,
        // 2.2, 2.7.
        tapping: Tapping::Pitch { pitch: (0.001, 500.0), threads: (0.06, 25_400.0) },
        // Table 7: P is that of G04.
        dwell_p_unit_s: DWELL_UNIT_S,
        // Appendix 8, note 2.
        length_at_start_only: true,
        ..cycles::Rules::default()
    }
}

/// What a reset clears: polar coordinates (appendix 9) and, as on Fanuc, canned cycles.
pub fn reset(_: &Parameters) -> ResetRules {
    ResetRules {
        groups: 1 << POLAR_GROUP | 1 << CYCLE_GROUP,
        feed_and_offsets: false,
        locals: false,
        commons: false,
    }
}

/// Modal state at power-on. P021.5 (appendix 11) chooses G99, which is the return to R in this language.
pub fn power_on(parameters: &Parameters) -> Modal {
    let level = if parameters.bit(21, 5) { 990 } else { 980 };
    let codes = [0, 170, 900, 940, 540, 210, 400, 490, 800, level, 150, 690, 640];
    Modal::new(&fanuc::CYCLE_OFF, codes.map(|tenths| fanuc::row(&G_CODES, tenths)))
}
