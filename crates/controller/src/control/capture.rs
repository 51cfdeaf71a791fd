//! Waveforms for a front: begun with names and a trigger, sampled in each period, read back in parts.

use super::{Control, alarm};
use crate::api::{CaptureTrigger, Reply};
use crate::capture::{Capture, CaptureSettings, Present, Quantity, Trigger};
use ferrocut_machine::{Alarm, Fault};

/// Values that one answer holds at most: what is written between two periods.
const MOST_IN_ANSWER: usize = 4000;

/// What a front asks for.
pub(super) struct Wanted {
    pub quantities: Vec<String>,
    pub seconds: f64,
    pub every: u32,
    pub trigger: Option<CaptureTrigger>,
    pub before: f64,
}

fn refused(value: impl Into<String>) -> Box<Alarm> {
    Box::new(alarm(Fault::CaptureSetting).with("value", value.into()))
}

impl Control {
    /// Begins a recording in place of the one before.
    pub(super) fn begin_capture(&mut self, wanted: Wanted) -> Result<Reply, Box<Alarm>> {
        let Wanted { quantities, seconds, every, trigger, before } = wanted;
        let ladder = self.plc.as_ref().map(|plc| plc.program());
        let mut named = Vec::with_capacity(quantities.len().min(crate::capture::MOST_QUANTITIES));
        for name in quantities {
            let is_there = |quantity: &Quantity| match quantity.axis() {
                Some(axis) => self.machine.axis(axis).is_some(),
                None => true,
            };
            let quantity = Quantity::parse(&name, ladder).filter(is_there);
            named.push((name.clone(), quantity.ok_or_else(|| refused(name))?));
        }
        let period = self.machine.servo_period_ms / 1000.0;
        let step = period * f64::from(every.max(1));
        let samples = |seconds: f64| match seconds.is_finite() && seconds >= 0.0 {
            // What is too much is refused by the capture.
            true => Ok((seconds / step).round() as usize),
            false => Err(refused(format!("{seconds} s"))),
        };
        let (all, before) = (samples(seconds)?, samples(before)?);
        let trigger = match trigger {
            None => None,
            Some(CaptureTrigger { quantity, level, rises }) => {
                let place = named.iter().position(|(name, _)| *name == quantity);
                Some(Trigger { quantity: place.ok_or_else(|| refused(quantity))?, level, rises })
            }
        };
        let behind = all.saturating_sub(before);
        let settings = CaptureSettings { quantities: named, samples: all, every, trigger, behind };
        self.capture = Some(Box::new(Capture::new(&settings, period)?));
        Ok(Reply::Done)
    }

    /// Takes the values of this period. Allocates nothing.
    pub(super) fn sample(&mut self) {
        if let Some(capture) = &mut self.capture {
            let signals = self.plc.as_ref().map(|plc| plc.memory());
            let spindle_rpm = self.cnc.spindle().actual_rpm();
            let chain = &self.cnc.chain();
            capture.sample(&Present { tick: &self.tick, chain, spindle_rpm, signals });
        }
    }

    pub(super) fn captured(&self, from: u32, most: u32) -> Result<Reply, Box<Alarm>> {
        let capture =
            self.capture.as_ref().ok_or_else(|| alarm(Fault::NoSuchName).with("name", "capture"))?;
        let rows = MOST_IN_ANSWER / (capture.quantities() + 1);
        let (from, most) = (from as usize, (most as usize).min(rows));
        let mut csv = Vec::new();
        // Into memory: nothing can fail.
        let _ = capture.write_rows(&mut csv, from, most);
        Ok(Reply::Captured {
            done: capture.is_done(),
            triggered: capture.triggered_s(),
            samples: u32::try_from(capture.len()).unwrap_or(u32::MAX),
            csv: String::from_utf8(csv).unwrap_or_default(),
        })
    }

    pub(super) fn end_capture(&mut self) -> Result<Reply, Box<Alarm>> {
        if let Some(capture) = &mut self.capture {
            capture.end();
        }
        Ok(Reply::Done)
    }
}
