//! What is wrong with the board or the way to it, and the alarms of it.

use ferrocut_geometry::Axis;
use ferrocut_machine::{Alarm, Fault, LinkAt};
use ferrocut_program::Span;
use std::io::{Error, ErrorKind};

/// Something wrong.
#[derive(Clone, Copy, PartialEq, Debug)]
pub(super) enum PulseFault {
    /// Nobody answers.
    Silent,
    /// Nobody answers any more.
    Lost {
        /// Since when, ms.
        ms: f64,
    },
    /// The link is broken.
    Cut(ErrorKind),
    /// A key of the machine file asks for too much.
    Unsuited {
        /// The key.
        key: &'static str,
        /// What it asks for, and what is possible.
        wanted: f64,
        /// See above.
        possible: f64,
    },
    /// The highest speed of an axis is too high, steps/s.
    StepRate {
        /// Which.
        axis: Axis,
        /// What it needs, and what is possible.
        needed: f64,
        /// See above.
        possible: f64,
    },
    /// The board has stopped by itself.
    Board {
        /// Why (docs/pulse-protocol.md).
        code: u8,
        /// The axis that it is about.
        axis: Option<Axis>,
        /// Frames that it could not read.
        unreadable: u16,
    },
}

/// Why boards stop, by their numbers.
const CODES: [Fault; 6] = [
    Fault::DriveWatchdog,
    Fault::DriveStarved,
    Fault::DriveFrameLost,
    Fault::DriveTooFast,
    Fault::DriveEmergencyStop,
    Fault::DriveAmplifier,
];

impl PulseFault {
    pub fn alarm(self, at: &LinkAt, span: Span) -> Box<Alarm> {
        let core = |fault| Alarm::core(fault, span);
        Box::new(match self {
            PulseFault::Silent => core(Fault::DrivesSilent).with("place", at.to_string()),
            PulseFault::Lost { ms } => core(Fault::DrivesLost).with("time", ms.round()),
            PulseFault::Cut(kind) => {
                let reason = Error::from(kind).to_string();
                core(Fault::DrivesCut).with("place", at.to_string()).with("reason", reason)
            }
            PulseFault::Unsuited { key, wanted, possible } => {
                let alarm = core(Fault::DrivesUnsuited).with("name", key);
                alarm.with("value", wanted).with("limit", possible)
            }
            PulseFault::StepRate { axis, needed, possible } => {
                let alarm = core(Fault::StepRate).with("axis", axis.letter().to_string());
                alarm.with("value", needed.ceil()).with("limit", possible.floor())
            }
            PulseFault::Board { code, axis, unreadable } => {
                let fault = CODES.get(usize::from(code).wrapping_sub(1)).copied();
                let alarm = core(fault.unwrap_or(Fault::DriveStopped)).with("code", f64::from(code));
                let alarm = alarm.with("count", f64::from(unreadable));
                match axis {
                    Some(axis) => alarm.with("axis", axis.letter().to_string()),
                    None => alarm,
                }
            }
        })
    }
}
