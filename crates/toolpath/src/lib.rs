//! The vocabulary between the interpreter and everything below it.
//!
//! In: what the interpreter decided. Out: the same, for motion, simulation, conversion and people.
//! A [`Step`] is one thing the machine is told to do, in machine coordinates and after every
//! compensation, with the piece of program it comes from. [`trace`] writes steps as JSON lines.
//!
//! Read [`step`] first.

pub mod step;
pub mod trace;

pub use step::{
    CornerRule, Dwell, Feed, FeedAlong, InnerCorners, Op, PathMode, Port, Speed, SpindleState, Step,
};
pub use trace::TraceWriter;
