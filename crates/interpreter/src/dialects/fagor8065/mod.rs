//! Fagor 8060 and 8065 for milling: the ISO language with its canned cycles, and the cycles of its editor.
//!
//! Sources in comments are sections of the manual of canned cycles, M model (ref. 1402). It describes the
//! cycles alone; what stands around them is the control's common language. The editor keeps its cycles in a
//! dialogue; here they are written as `#CYCLE` blocks ([`editor`]).
//!
//! The control gives alarms no numbers in that manual, so that they have those of this system.

mod codes;
pub mod editor;
mod figures;
mod iso;
mod rules;
mod syntax;
mod variables;

use crate::dialect::Dialect;
use crate::dialects::fanuc;
use crate::directives::Directive;
use crate::evaluate::Arithmetic;
use ferrocut_machine::WorkOffset;

/// The Fagor control.
pub static DIALECT: Dialect = Dialect {
    name: "fagor8065",
    extensions: &[],
    syntax: &syntax::SYNTAX,
    arithmetic: Arithmetic::EXACT,
    g_codes: codes::G_CODES,
    m_codes: &codes::M_CODES,
    other_m_codes: &fanuc::MACHINE_M,
    cycle_off: &fanuc::CYCLE_OFF,
    length_off: &fanuc::LENGTH_OFF,
    one_way_modal: &fanuc::ONE_WAY_MODAL,
    is_fixed_parameter: |_| false,
    is_work_zero: |_| false,
    parameter_switch: false,
    macro_call: u16::MAX,
    // A parameter that was never set is 0.
    unset_variable: Some(0.0),
    custom: None,
    directives: DIRECTIVES,
    described_cycles: editor::CYCLES,
    described_figures: editor::FIGURES,
    blocks: None,
    variable: variables::variable,
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

/// Axes and cycles (1.1, 1.1.4), and what prepares the path, which machines here do by themselves (4.11).
const DIRECTIVES: &[(&str, Directive)] = &[
    ("TOOL", Directive::ToolAxis),
    ("SET", Directive::SetAxes),
    ("CYCLE", Directive::Cycle),
    ("DRILL", Directive::Part(crate::cycles::described::Part::Drill)),
    ("ROUGH", Directive::Part(crate::cycles::described::Part::Rough)),
    ("SEMI", Directive::Part(crate::cycles::described::Part::Semi)),
    ("FINISH", Directive::Part(crate::cycles::described::Part::Finish)),
    ("MULTI", Directive::Figure),
    ("PROFILE", Directive::Profile),
    ("ENDPROFILE", Directive::EndProfile),
    ("MSG", Directive::Message),
    ("HSC", Directive::NoEffect),
    ("ROUNDPAR", Directive::NoEffect),
    ("MILLCY", Directive::NoEffect),
    ("LATHECY", Directive::OtherCycles),
];
