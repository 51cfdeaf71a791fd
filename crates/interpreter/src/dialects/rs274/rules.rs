//! Choices of the language.

use super::arcs::SPIRAL_INCH;
use super::codes::{G_CODES, LENGTH_OFF};
use crate::dialect::{ResetRules, Rules};
use crate::dialects::fanuc;
use crate::modal::Modal;
use crate::stages::cutter;
use ferrocut_geometry::MM_PER_INCH;
use ferrocut_machine::Parameters;

/// Parameters have numbers from 1 to this one (LinuxCNC, parameters).
pub const LAST_PARAMETER: u32 = 5601;

/// Reads the rules.
pub fn rules(_: &Parameters) -> Rules {
    Rules {
        // The widest of its own rule (`arcs`): that of inch programs.
        arc_tolerance: SPIRAL_INCH * MM_PER_INCH,
        dwell_letter: b'P',
        repeats_are_alarms: true,
        m_codes_in_block: 4,
        cutter: cutter::Rules { method: cutter::Method::OneAhead, ..cutter::Rules::default() },
        surface_speed: true,
        plane_ends_cycle: true,
        ..Rules::default()
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
