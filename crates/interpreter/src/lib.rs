//! Blocks to steps of the tool.
//!
//! In: a [`ProgramMemory`](ferrocut_program::ProgramMemory), what the machine remembers
//! ([`Memory`](ferrocut_machine::Memory)) and a [`Dialect`]. Out: an iterator of
//! `Result<Step, Box<Alarm>>` that runs ahead of motion.
//!
//! The way of a block: [`words`] collects its words and looks its codes up in the dialect's tables;
//! [`execute`] changes modal state and decides what the block does; a move then goes through the
//! [`stages`], each of which turns one kind of coordinate into the next, down to machine axes.
//! [`cycles`] expand canned cycles into moves. [`flow`] is the order of blocks: subprograms and the
//! end of the program.
//!
//! What a control language is made of stands in its folder under [`dialects`], as tables.
//! Read [`interpreter`] first.

mod barrier;
pub mod coordinates;
mod custom;
mod cutter_words;
pub mod cycles;
mod data_setting;
pub mod dialect;
pub mod dialects;
pub mod directives;
pub mod evaluate;
pub mod execute;
pub mod flow;
mod in_force;
pub mod interpreter;
mod length_words;
mod loading;
mod look_back;
mod m_functions;
mod machine_words;
mod macros;
pub mod modal;
pub mod motion;
mod non_modal;
pub mod origins;
mod output;
pub mod program_state;
mod reference;
mod referenced;
pub mod search;
mod sent;
pub mod stages;
pub mod stroke;
mod technology;
mod tool_axes;
mod transforms;
pub mod words;

pub use barrier::AtRest;
pub use dialect::{Dialect, Rules};
pub use dialects::rs274::Turned;
pub use in_force::{InForce, Shown};
pub use interpreter::{Interpreter, MachineCodes, Options};
pub use macros::place_variables;
pub use origins::Origins;
pub use referenced::Unreferenced;
pub use search::Until;

use ferrocut_machine::Alarm;

/// What can stop with an alarm.
pub type Fallible<T> = Result<T, Box<Alarm>>;
