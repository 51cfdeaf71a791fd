//! What a machine is and what it remembers.
//!
//! In: machine files, set-up files and the controls' own tables. Out: plain data that the rest of the
//! system reads, and [`alarm::Alarm`], the one type for everything that can be wrong.
//!
//! Read [`config`] first (the machine file), then [`memory`] (what a control remembers) and [`setup`]
//! (the file that fills it).

pub mod alarm;
pub mod alarm_table;
pub mod config;
pub mod config_error;
pub mod drives;
pub mod handshake;
pub mod homing;
pub mod manual;
pub mod memory;
pub mod memory_changes;
pub mod messages;
pub mod offsets;
pub mod parameter_checks;
pub mod parameter_csv;
pub mod parameter_file;
pub mod parameters;
pub mod path;
pub mod plant;
pub mod reference;
mod reference_texts;
pub mod restart;
pub mod servo;
pub mod setup;
pub mod tool_library;

pub use alarm::{Alarm, AlarmId, Argument, Fault, Severity};
pub use alarm_table::{AlarmClass, AlarmRow, alarm_table};
pub use config::{AxisConfig, AxisKind, Machine};
pub use config_error::ConfigError;
pub use drives::{DrivesConfig, LinkAt, PulseAxis, PulseConfig};
pub use handshake::{GearConfig, HandshakeConfig};
pub use homing::{AxisHoming, HomingConfig};
pub use memory::{Memory, Place, VariableError, Variables};
pub use memory_changes::MemoryChange;
pub use messages::{Catalogue, Language};
pub use offsets::{ToolOffset, ToolTable, WorkOffset, WorkOffsets};
pub use parameter_file::ParameterFile;
pub use parameters::{Meaning, ParameterDef, ParameterError, ParameterKey, ParameterTable, Parameters};
pub use path::{ArcSlowdown, CornerSlowdown, PathConfig, Ramp};
pub use plant::{PlantAxis, PlantBlock, PlantConfig};
pub use reference::{GCodeRow, MCodeRow, Reference, Subject, VariableRow, g_code_name};
pub use servo::{Backlash, PITCH_POINTS, PitchErrors, ServoConfig, Smoothing};
pub use setup::{AxisValues, CuttingSetup, ImportSetup, Setup, SkipSignal};
pub use tool_library::{Tool, ToolLibrary};
