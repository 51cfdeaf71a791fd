//! RS274/NGC as LinuxCNC 2.9 reads it.
//!
//! Sources in comments: `NGC` is the definition of RS274/NGC (NIST IR 6556), `LinuxCNC` the user manual's chapters
//! of G codes and O codes. Where both are silent the program `rs274` of that version was asked.
//!
//! The language executes a block in an order of its own, checks it before anything is done, and keeps its
//! positions in one formula (`state`), so that its blocks are run here (`blocks`) and not by the common
//! order of the Fanuc-like controls. Behind the move stand the common pieces: steps, offsets, tools,
//! variables, geometry. Read `blocks` first.

mod arcs;
mod blocks;
mod codes;
mod coordinates;
mod cutter;
mod cycles;
mod expressions;
mod flow;
mod messages;
mod motion;
mod moves;
mod parameters;
mod polar;
mod probe;
mod refused;
mod rules;
mod saved;
mod splines;
mod state;
mod syntax;
mod technology;
mod threads;
mod tools;

pub(crate) use coordinates::system_name;
pub(crate) use state::State;
pub use state::Turned;

use crate::dialect::Dialect;
use crate::dialects::fanuc;
use crate::evaluate::Arithmetic;
use ferrocut_machine::WorkOffset;

/// The language of LinuxCNC.
pub static DIALECT: Dialect = Dialect {
    name: "rs274",
    extensions: &["ngc"],
    syntax: &syntax::SYNTAX,
    arithmetic: Arithmetic::EXACT,
    g_codes: codes::G_CODES,
    m_codes: codes::M_CODES,
    other_m_codes: &[],
    cycle_off: &codes::CYCLE_OFF,
    length_off: &codes::LENGTH_OFF,
    one_way_modal: &fanuc::ONE_WAY_MODAL,
    is_fixed_parameter: |_| false,
    is_work_zero: |_| false,
    parameter_switch: false,
    macro_call: u16::MAX,
    // A parameter that was never set is 0 (NGC 3.2.1).
    unset_variable: Some(0.0),
    custom: None,
    directives: &[],
    described_cycles: &[],
    described_figures: &[],
    blocks: Some(blocks::run),
    variable: |number| {
        (1..=rules::LAST_PARAMETER).contains(&number).then_some(crate::dialect::Variable::Plain)
    },
    argument: |_| None,
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
