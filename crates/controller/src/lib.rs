//! The running CNC.
//!
//! In: an interpreter's steps and the operator's commands (cycle start, feed hold, reset, overrides).
//! Out: a setpoint for every axis each servo period, what the machine does beside, and a report.
//!
//! [`Cnc::tick`] is one servo period. It runs on a virtual clock as fast as it can, and on a real one
//! at true speed, by the same code and with the same setpoints.
//!
//! Read [`cnc`] first; [`supervision`] is what the machine refuses before anything moves.

pub mod api;
mod auxiliary;
pub mod capture;
pub mod clock;
pub mod cnc;
pub mod control;
pub mod diagnosis;
pub mod drives;
pub mod handshake;
mod homing;
pub mod manual;
pub mod measure;
pub mod programmed;
pub mod report;
pub mod restart;
pub mod signals;
pub mod spindle;
pub mod spindle_control;
pub mod supervision;

pub use clock::Clock;
pub use cnc::{Cnc, DryRun, Event, Interruption, State, Tick};
pub use control::{Control, Parts};
pub use drives::{Drives, Plant, Switches};
pub use manual::{JogSpeed, JogWay};
pub use programmed::{Programmed, Way};
pub use report::{Activity, Report};
pub use restart::{Journal, Restart};
pub use signals::{Inputs, Mode, Outputs};
pub use supervision::Supervisor;
