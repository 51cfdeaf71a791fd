//! The Grbl 1.1 protocol, so that senders made for it (UGS, CNCjs, bCNC) can use the machine.
//!
//! In: bytes of a connection, and a [`Machine`]. Out: bytes of answers. [`Grbl`] is a state machine that waits for
//! nothing: [`Grbl::receive`] takes bytes, [`Grbl::poll`] does what can be done by now.
//!
//! The way of a line: [`realtime`] bytes are taken out and act at once; what is left becomes lines ([`front`]); `$`
//! commands are done there and in `system`, jogs in `jog`, and blocks are checked by Grbl's rules and written
//! anew for the interpreter in [`words`]. Answers come in the order of the lines. Sources in comments name the chapter
//! of Grbl's published documents.

pub mod checker;
pub mod codes;
pub mod front;
pub mod jog;
pub mod machine;
pub mod realtime;
pub mod report;
pub mod settings;
mod system;
pub mod words;

pub use front::Grbl;
pub use machine::{Doing, Event, Machine, Modal, Offsets, Overrides, Pins, Status};
