//! The running control, a file for each of what it does. All are one program: its tests run beside one another, and it is
//! linked once. What counts allocations has a program of its own.
#![allow(missing_docs, clippy::unwrap_used, clippy::panic, clippy::indexing_slicing)]

#[path = "../common/mod.rs"]
mod common;

mod aborts;
mod awaited_inputs;
mod beside;
mod block_end;
mod control;
mod control_capture;
mod control_machine;
mod control_restart;
mod control_trace;
mod dnc;
mod examples;
mod feeds;
mod homing;
mod interruptions;
mod kept;
mod ladder;
mod limits;
mod machine_data;
mod manual;
mod measuring;
mod messages;
mod panel;
mod path_modes;
mod planning;
mod power;
mod prediction;
mod program_outputs;
mod program_reading;
mod reckoning;
mod refusals;
mod reset_bits;
mod restart;
mod retracing;
mod rights;
mod runs;
mod sent;
mod servo;
mod skip;
mod strokes;
mod taken_up;
mod tapping;
mod way_back;
mod weihong;
