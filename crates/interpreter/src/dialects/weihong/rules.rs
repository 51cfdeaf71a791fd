//! What the named parameters set, and what is fixed.

use super::codes::G_CODES;
use crate::coordinates::{self, SetPosition};
use crate::cycles::{self, Restart};
use crate::dialect::{ResetRules, Rules};
use crate::dialects::fanuc;
use crate::modal::Modal;
use crate::motion::{self, RotaryY};
use crate::stages::cutter;
use ferrocut_geometry::Axis;
use ferrocut_machine::Parameters;

/// Levels of subprograms, those that stand for codes included; the manual gives no number.
const CALL_DEPTH: usize = 32;

/// P of G04 and of cycles is in ms (4.3).
const DWELL_UNIT_S: f64 = 0.001;

/// Reads the rules.
pub fn rules(parameters: &Parameters) -> Rules {
    let p = |name| parameters.named(name).unwrap_or(0.0);
    let y_turns = p("ISYREVAXIS") != 0.0;
    Rules {
        default_feed: p("DEFAULT_FEED"),
        // 4.3, G00: a straight track.
        rapid_is_straight: true,
        arc_tolerance: 0.05,
        dwell_p_unit_s: DWELL_UNIT_S,
        // 4.3, G04.
        dwell_p_decides: true,
        // 4.3, G43: Z.
        length_on_plane_normal: false,
        // 4.3, G90.
        distance_is_exclusive: true,
        // 4.5.
        sequence_takes_expression: true,
        max_call_depth: CALL_DEPTH,
        max_repeats: 999_999_999.0,
        counts_take_any_number: true,
        cycles: cycles(parameters),
        motion: motion::Rules {
            // 4.3, G00, and 4.1.
            rapid_moves_z_apart: true,
            rapid_takes_feed: true,
            // 4.3, G02.
            short_radius_is_half_circle: true,
            centre_is_absolute: p("IJK_INCREMENTAL") == 0.0,
            helix_has_pitch: true,
            polar_words: false,
            rotary_y: y_turns.then(|| rotary_y(p("UNIT.YR"), p("WPREVDIAM"))),
            ..motion::Rules::default()
        },
        coordinates: coordinates::Rules {
            transforms_nest: true,
            set_position: SetPosition::Table,
            machine_position_by_motion: true,
            reference_keeps_length: true,
            reference_in_cycle: true,
        },
        cutter: cutter::Rules {
            // 4.3, G40: neither in compensation nor when it is cancelled.
            reversal: cutter::Reversal::Fault,
            ..cutter::Rules::default()
        },
        max_coordinate: 1e7,
        feed_per_revolution: false,
        max_m_code: 999.0,
        // 4.1, T.
        tool_chooses_offsets: true,
        // 5, parameter 13.
        end_stops_spindle: p("AUTOSTOPSPINDLE") != 0.0,
        // 19 to 22.
        fixed_point: (p("ENABLE_CTP") != 0.0).then(|| ["CTP_POS.X", "CTP_POS.Y", "CTP_POS.Z"].map(p)),
        max_offset: 9_999_999.0,
        max_wear: 9_999_999.0,
        max_zero: 9_999_999.0,
        axes: [Axis::X, Axis::Y, Axis::Z, Axis::A, Axis::B, Axis::C].into_iter().collect(),
        linear_axes: match y_turns {
            true => [Axis::X, Axis::Z].into_iter().collect(),
            false => [Axis::X, Axis::Y, Axis::Z].into_iter().collect(),
        },
        ..Rules::default()
    }
}

/// 5, parameters 10 to 12: angles are in radians there, lengths on the surface in mm. Without a diameter
/// there is no surface, and lengths are taken as degrees.
fn rotary_y(unit: f64, diameter: f64) -> RotaryY {
    match (unit != 0.0, diameter > 0.0) {
        (false, _) => RotaryY { degrees_per_unit: 1f64.to_degrees(), is_length: false },
        (true, true) => {
            let circumference = std::f64::consts::PI * diameter;
            RotaryY { degrees_per_unit: 360.0 / circumference, is_length: true }
        }
        (true, false) => RotaryY { degrees_per_unit: 1.0, is_length: false },
    }
}

/// The canned cycles (4.3).
fn cycles(parameters: &Parameters) -> cycles::Rules {
    let p = |name| parameters.named(name).unwrap_or(0.0);
    // Where the nose points, in the XY plane whatever the plane of the program is; the tool moves the other
    // way (G87, step 2).
    let shift = match p("FIXEDCYCLE_OSS") {
        0.0 => (Axis::X, -1.0),
        1.0 => (Axis::X, 1.0),
        2.0 => (Axis::Y, -1.0),
        _ => (Axis::Y, 1.0),
    };
    cycles::Rules {
        // 4.7, example 4, N04: L2.
        other_repeat_letter: Some(b'L'),
        chip_break_retract: p("FIXEDCYCLE_BACK"),
        peck_clearance: p("FIXEDCYCLE_BACK"),
        shift,
        // G87 and G88, last step; 5, example 2, of G86.
        restart: Restart::Clockwise,
        // G87, step 8.
        restart_aside: true,
        dwell_p_unit_s: DWELL_UNIT_S,
        ..cycles::Rules::default()
    }
}

/// What a reset clears: transformations and cycles, as the end of a program does (4.3, G51, G68).
pub fn reset(_: &Parameters) -> ResetRules {
    ResetRules {
        groups: 1 << 9 | 1 << 11 | 1 << 16 | 1 << 22,
        feed_and_offsets: false,
        locals: false,
        commons: false,
    }
}

/// Modal state at power-on: G54, G90, G17, G50 and metric are said in 4.3; the others are Fanuc's.
pub fn power_on(_: &Parameters) -> Modal {
    let codes = [0, 170, 900, 540, 210, 400, 490, 800, 980, 500, 501, 690];
    Modal::new(&fanuc::CYCLE_OFF, codes.map(|tenths| fanuc::row(G_CODES, tenths)))
}
