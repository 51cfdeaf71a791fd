//! Ladders: text to code, and the scan that runs it.
//!
//! In: ladder text ([`Program::from_text`]) or PLCopen XML ([`plcopen`]), and the signals of machine and NC.
//! Out: the signals that the ladder gives them ([`Plc::scan`], once a period).
//!
//! The way of the data: [`lexer`] (words with their places) → [`list`] (instructions) → [`check`] (networks,
//! levels, numbers) → [`compile`] (flat code) → [`scan`]. Read [`instruction`] first, which has the whole
//! language as a table; [`address`] has the signals. What the crate knows of an NC is nothing.

pub mod address;
mod bits;
pub mod check;
pub mod compile;
pub mod fault;
mod functions;
pub mod instruction;
pub mod lexer;
pub mod list;
pub mod memory;
pub mod monitor;
pub mod plcopen;
pub mod scan;
pub mod trace;

pub use address::{Address, AddressError, Area};
pub use check::Limits;
pub use compile::Program;
pub use fault::{Error, Fault, Span};
pub use memory::Memory;
pub use monitor::Flow;
pub use scan::{Longest, Maintenance, Pace, Plc, Scanned, Stop};
pub use trace::{Sample, Trace, TraceSettings, Trigger};
