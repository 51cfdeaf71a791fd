//! Weihong NcStudio, the milling and engraving control of Shanghai Weihong.
//!
//! Sources in comments are sections of its programming manual. It gives alarms no numbers, so that they have
//! those of this system. Where it is silent the language is that of the Fanuc 0i-M.

mod codes;
mod rules;
mod syntax;
mod variables;

use crate::dialect::{CustomPrograms, Dialect};
use crate::dialects::fanuc;
use crate::evaluate::{Angles, Arithmetic};
use ferrocut_machine::WorkOffset;

/// The Weihong control.
pub static DIALECT: Dialect = Dialect {
    name: "weihong",
    extensions: &["mmg", "eng"],
    syntax: &syntax::SYNTAX,
    // 4.5.
    arithmetic: Arithmetic { angles: Angles::Radians, ..Arithmetic::EXACT },
    g_codes: codes::G_CODES,
    m_codes: codes::M_CODES,
    other_m_codes: &[],
    cycle_off: &fanuc::CYCLE_OFF,
    length_off: &fanuc::LENGTH_OFF,
    one_way_modal: &fanuc::ONE_WAY_MODAL,
    is_fixed_parameter: |_| false,
    is_work_zero: |_| false,
    parameter_switch: false,
    // G65 shares the variables of its caller (4.3, arrays by G992) and is a code of the table.
    macro_call: u16::MAX,
    // 5: variables that were never set are 0.
    unset_variable: Some(0.0),
    custom: Some(CUSTOM),
    directives: &[],
    described_cycles: &[],
    described_figures: &[],
    blocks: None,
    variable: variables::variable,
    argument: fanuc::argument,
    addresses: codes::ADDRESSES,
    alarms: &[],
    axis_alarm: |_, _, _| None,
    machine_parameters: |_, _| {},
    program_alarms: None,
    rules: rules::rules,
    power_on: rules::power_on,
    reset: rules::reset,
    power_on_work_offset: WorkOffset::Standard(1),
};

/// 6: subprograms 200 to 599 stand for M codes, 600 to 999 for G codes. O202 is run at every S word, as the
/// example there says of it; M02 has none. 5: what the words of a cycle are called. P, I and J are not in
/// that list: they take the numbers that it leaves free, in the order of the alphabet.
const CUSTOM: CustomPrograms = CustomPrograms {
    m: 200,
    g: 600,
    count: 400,
    speed: 202,
    arguments: &[
        (b'X', variables::fc(1)),
        (b'Y', variables::fc(2)),
        (b'Z', variables::fc(3)),
        (b'R', variables::fc(4)),
        (b'Q', variables::fc(5)),
        (b'P', variables::fc(6)),
        (b'F', variables::fc(7)),
        (b'I', variables::fc(9)),
        (b'J', variables::fc(10)),
        (b'K', variables::fc(11)),
    ],
    returns_to_r: variables::fc(12),
    incremental: variables::fc(13),
    initial: variables::fc(14),
};
