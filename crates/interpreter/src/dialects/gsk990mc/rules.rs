//! What the parameters set.

use super::codes::{CYCLE_OFF, G_CODES};
use crate::dialect::{GCode, Rules};
use crate::modal::Modal;
use ferrocut_geometry::{Axis, AxisSet};
use ferrocut_machine::Parameters;

/// Subprograms nested in the main program (3.2.2 note 3).
const CALL_DEPTH: usize = 4;

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
        max_repeats: 9999.0,
        chip_break_retract: p(270),
        peck_clearance: p(271),
        peck_needs_depth: parameters.bit(43, 1),
        cycle_dwell: (p(281) / 1000.0, p(282) / 1000.0),
        cycle_needs_speed: true,
        axes: axes(parameters),
    }
}

/// X, Y, Z and the fourth axis that the machine has. The names of P175 to P179 come with axes that
/// are renamed.
fn axes(_parameters: &Parameters) -> AxisSet {
    [Axis::X, Axis::Y, Axis::Z, Axis::A].into_iter().collect()
}

fn code(tenths: u16) -> &'static GCode {
    let found = G_CODES.binary_search_by_key(&tenths, |g| g.tenths).ok().and_then(|at| G_CODES.get(at));
    found.unwrap_or(&CYCLE_OFF)
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
    ];
    Modal::new(&CYCLE_OFF, codes.map(code))
}
