//! What a machine is and what it remembers.
//!
//! In: machine files, set-up files and the controls' own tables. Out: plain data that the rest of the
//! system reads, and [`alarm::Alarm`], the one type for everything that can be wrong.
//!
//! Read [`config`] first (the machine file).

pub mod alarm;
pub mod config;

pub use alarm::{Alarm, AlarmId, Argument, Fault, Severity};
pub use config::{AxisConfig, AxisKind, ConfigError, Machine};
