//! What happens, as it happens.

use super::{Activity, AlarmInfo, Measurement};
use crate::signals::Mode;
use serde::{Deserialize, Serialize};

/// What happens, as it happens.
#[derive(Clone, PartialEq, Debug, Serialize, Deserialize)]
#[cfg_attr(feature = "typescript", derive(ts_rs::TS))]
#[serde(tag = "event", rename_all = "snake_case")]
pub enum Event {
    /// Something worth knowing, or that stands until reset.
    Alarm {
        /// What.
        alarm: AlarmInfo,
    },
    /// No alarm stands any more.
    AlarmsCleared,
    /// A key was pressed that does nothing now, and why.
    Refused {
        /// Why.
        alarm: AlarmInfo,
    },
    /// Text of the program for the operator.
    Message {
        /// The text.
        text: String,
    },
    /// A message of the machine comes or goes.
    MachineMessage {
        /// Its name in the ladder.
        name: String,
        /// Whether it comes.
        on: bool,
    },
    /// Another mode is in force.
    Mode {
        /// Which.
        mode: Mode,
    },
    /// A program was selected.
    Selected {
        /// Its name.
        program: String,
    },
    /// The control does something else.
    Activity {
        /// What.
        activity: Activity,
    },
    /// A part is done.
    Part {
        /// Parts since the count was set.
        parts: u64,
    },
    /// A tool was put into the spindle.
    ToolChange {
        /// Its number.
        tool: u32,
    },
    /// Data were changed.
    Changed {
        /// What kind: the name of an item of the memory, `forced`, `backups` or `mdi`.
        item: String,
    },
    /// Somebody has other rights.
    Level {
        /// 1 to 5.
        level: u8,
    },
    /// A restart is ready for cycle start, or no longer.
    Restart {
        /// Whether it is ready.
        ready: bool,
        /// The line of its block, from 1.
        line: u32,
    },
    /// Something was measured.
    Measured {
        /// What.
        measured: Measurement,
    },
    /// A run was broken off: it can be taken up again.
    Interrupted {
        /// The program.
        program: String,
        /// The line of the block, from 1.
        line: u32,
    },
}
