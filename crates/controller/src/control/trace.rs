//! Signals of the ladder over time for a front: sampled at each scan, so that no pulse is missed, and read in parts.

use super::{Control, alarm};
use crate::api::{Reply, TraceEdge, TraceTrigger};
use ferrocut_machine::{Alarm, Fault};
use ferrocut_plc::trace::MOST_SIGNALS;
use ferrocut_plc::{Address, TraceSettings, Trigger};

/// Samples that are kept at most: the room is made between two periods.
const MOST_SAMPLES: u32 = 100_000;

/// Samples that one answer holds at most: what is written between two periods.
const MOST_IN_ANSWER: usize = 2000;

/// What a front asks for.
pub(super) struct Wanted {
    pub signals: Vec<String>,
    pub samples: u32,
    pub trigger: Option<TraceTrigger>,
    pub behind: Option<u32>,
    pub changes_only: bool,
}

fn refused(value: impl ToString) -> Box<Alarm> {
    Box::new(alarm(Fault::CaptureSetting).with("value", value.to_string()))
}

impl Control {
    /// Begins a trace in place of the one before.
    pub(super) fn begin_trace(&mut self, wanted: &Wanted) -> Result<Reply, Box<Alarm>> {
        let bit = |name: &String| {
            let address = self.address(name)?;
            if address.bit.is_some() { Ok(address) } else { Err(refused(name)) }
        };
        let signals: Vec<Address> = match (1..=MOST_SIGNALS).contains(&wanted.signals.len()) {
            true => wanted.signals.iter().map(bit).collect::<Result<_, _>>()?,
            false => return Err(refused(wanted.signals.len())),
        };
        let behind = wanted.behind.unwrap_or(wanted.samples / 2);
        if !(1..=MOST_SAMPLES).contains(&wanted.samples) || behind >= wanted.samples {
            return Err(refused(wanted.samples));
        }
        let trigger = match &wanted.trigger {
            None => None,
            Some(TraceTrigger { signal, edge }) => Some(match edge {
                TraceEdge::Rising => Trigger::Rising(bit(signal)?),
                TraceEdge::Falling => Trigger::Falling(bit(signal)?),
                TraceEdge::Change => Trigger::Change(bit(signal)?),
            }),
        };
        let settings = TraceSettings {
            signals,
            samples: wanted.samples as usize,
            trigger,
            behind: behind as usize,
            changes_only: wanted.changes_only,
        };
        if let Some(plc) = &mut self.plc {
            plc.set_trace(Some(&settings));
        }
        Ok(Reply::Done)
    }

    pub(super) fn traced(&self, from: u32, most: u32) -> Result<Reply, Box<Alarm>> {
        let trace = self.plc.as_ref().and_then(|plc| plc.trace());
        let trace = trace.ok_or_else(|| alarm(Fault::NoSuchName).with("name", "trace"))?;
        let seconds = |us: u64| us as f64 / 1e6;
        let rows = trace.samples().skip(from as usize).take((most as usize).min(MOST_IN_ANSWER));
        Ok(Reply::Traced {
            done: trace.is_done(),
            triggered: trace.triggered_us().map(seconds),
            signals: trace.signals().iter().map(ToString::to_string).collect(),
            samples: u32::try_from(trace.len()).unwrap_or(u32::MAX),
            rows: rows.map(|sample| (seconds(sample.time_us), sample.bits)).collect(),
        })
    }

    pub(super) fn end_trace(&mut self) -> Reply {
        if let Some(plc) = &mut self.plc {
            plc.set_trace(None);
        }
        Reply::Done
    }
}
