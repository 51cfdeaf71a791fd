//! What is fixed: the manual names no parameters of the control.

use super::codes::G_CODES;
use crate::cycles::{self};
use crate::dialect::{ResetRules, Rules};
use crate::dialects::fanuc;
use crate::modal::Modal;
use crate::motion;
use ferrocut_machine::Parameters;

/// Reads the rules.
pub fn rules(_: &Parameters) -> Rules {
    Rules {
        dwell_letter: b'K',
        cycles: cycles(),
        motion: motion::Rules { polar_words: true, helix_has_pitch: true, ..motion::Rules::default() },
        orients_to_speed_word: true,
        tools_carry_offsets: true,
        functions_before_point: true,
        // 1.1.1.
        plane_ends_cycle: true,
        ..Rules::default()
    }
}

/// What the cycles of other controls read has no bearing here, except that cycles stand beside motion codes.
fn cycles() -> cycles::Rules {
    cycles::Rules {
        // 1.1.1: G90 G01 X85 in the zone of influence.
        stand_beside_motion: true,
        ..cycles::Rules::default()
    }
}

/// A reset ends cycles (1.1.1).
pub fn reset(_: &Parameters) -> ResetRules {
    ResetRules { groups: 1 << 9, feed_and_offsets: false, locals: false, commons: false }
}

/// Modal state at power-on: G98 (1.1.2); the others are the common ones.
pub fn power_on(_: &Parameters) -> Modal {
    let codes = [0, 170, 710, 900, 940, 400, 540, 500, 800, 980];
    Modal::new(&fanuc::LENGTH_OFF, codes.into_iter().map(|tenths| fanuc::row(G_CODES, tenths)))
}
