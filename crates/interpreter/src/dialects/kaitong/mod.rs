//! Kaitong, a milling control of Nanjing Kaitong.
//!
//! Sources in comments are the appendices 7 to 11 of its manual: canned cycles, tool length, polar
//! coordinates, rotation, changes of parameters. P230 is a data parameter, P018.4 bit 4 of a bit parameter.
//! Of all else the appendices say nothing; there the language is that of the Fanuc 0i-M. What is an option
//! or a matter of parameters there (scaling, one-way positioning, surface speed, corner arcs) is left out.

mod codes;
mod rules;
mod variables;

use crate::dialect::Dialect;
use crate::dialects::fanuc;
use crate::evaluate::Arithmetic;
use ferrocut_machine::WorkOffset;
use ferrocut_program::Syntax;

/// A block ends at `;`, in either width, and what follows it is a remark, as in the examples of appendices 8 to
/// 10.
static SYNTAX: Syntax = Syntax { line_comments: &[b";", "；".as_bytes(), b"\xA3\xBB"], ..fanuc::SYNTAX };

/// The Kaitong control.
pub static DIALECT: Dialect = Dialect {
    name: "kaitong",
    extensions: &[],
    syntax: &SYNTAX,
    arithmetic: Arithmetic::EXACT,
    g_codes: &codes::G_CODES,
    m_codes: &codes::M_CODES,
    other_m_codes: &fanuc::MACHINE_M,
    cycle_off: &fanuc::CYCLE_OFF,
    length_off: &fanuc::LENGTH_OFF,
    one_way_modal: &fanuc::ONE_WAY_MODAL,
    is_fixed_parameter: |_| false,
    is_work_zero: |_| false,
    parameter_switch: false,
    macro_call: 650,
    unset_variable: None,
    custom: None,
    directives: &[],
    described_cycles: &[],
    described_figures: &[],
    blocks: None,
    variable: variables::variable,
    argument: fanuc::argument,
    addresses: codes::ADDRESSES,
    // The appendices give alarms no numbers.
    alarms: &[],
    axis_alarm: |_, _, _| None,
    machine_parameters: |_, _| {},
    program_alarms: None,
    rules: rules::rules,
    power_on: rules::power_on,
    reset: rules::reset,
    power_on_work_offset: WorkOffset::Standard(1),
};
