//! GSK990MC, a milling control of Guangzhou CNC.
//!
//! Sources in comments are sections of its manual, "GSK990MC programming and operation"; numbers like
//! 31#0 are its bit parameters, P87 its data parameters.

mod acceleration;
mod alarms;
mod codes;
mod drives;
mod rules;
mod syntax;
mod variables;

use crate::dialect::Dialect;
use crate::dialects::fanuc;
use crate::evaluate::{Angles, Arithmetic};
use ferrocut_machine::WorkOffset;

/// The GSK990MC control.
pub static DIALECT: Dialect = Dialect {
    name: "gsk990mc",
    extensions: &[],
    syntax: &syntax::SYNTAX,
    // 4.9.2, 5: results are precise to 0.0001 and have no more than nine digits before the point; alarm 0111 is of results that
    // are too large, the bounds in its text are Fanuc's. Table 4-9-5-2: EXP to 99997.453535, which is that of 11.5129 in
    // eleven digits.
    arithmetic: Arithmetic {
        angles: Angles::Degrees,
        steps: 10_000.0,
        largest_power: 99_997.453_535_5,
        largest_result: 999_999_999.999_9,
    },
    g_codes: &codes::G_CODES,
    m_codes: &codes::M_CODES,
    other_m_codes: &[],
    cycle_off: &fanuc::CYCLE_OFF,
    length_off: &fanuc::LENGTH_OFF,
    one_way_modal: &fanuc::ONE_WAY_MODAL,
    is_fixed_parameter: rules::is_fixed,
    is_work_zero: rules::is_work_zero,
    // Part 2, 3.4.1.
    parameter_switch: true,
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
    alarms: alarms::ALARMS,
    axis_alarm: alarms::of_axis,
    machine_parameters: drives::machine_parameters,
    // 4.9.4.
    program_alarms: Some(3000),
    rules: rules::rules,
    power_on: rules::power_on,
    reset: rules::reset,
    // The manual restores the system in force at power-off; a desk knows none and takes the first.
    power_on_work_offset: WorkOffset::Standard(1),
};
