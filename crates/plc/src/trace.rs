//! Signals over time, with a trigger.
//!
//! Up to 32 signals are sampled at the end of each scan into a ring that was made before. The trigger divides
//! it: samples before are kept as far as there is room, a number of samples behind ends the trace.

use crate::address::Address;
use crate::memory::Memory;

/// Signals of a trace.
pub const MOST_SIGNALS: usize = 32;
/// Samples of a trace.
pub const MOST_SAMPLES: usize = 1 << 20;

/// What sets off the end of a trace.
#[derive(Clone, Copy, PartialEq, Eq, Debug)]
pub enum Trigger {
    /// The signal turns on.
    Rising(Address),
    /// It turns off.
    Falling(Address),
    /// It changes.
    Change(Address),
}

/// What is traced.
#[derive(Clone, Debug)]
pub struct TraceSettings {
    /// The signals; those beyond [`MOST_SIGNALS`] are left out.
    pub signals: Vec<Address>,
    /// Samples that are kept, up to [`MOST_SAMPLES`].
    pub samples: usize,
    /// What sets off the end; without it the last samples are kept until someone looks.
    pub trigger: Option<Trigger>,
    /// Samples behind the trigger.
    pub behind: usize,
    /// Whether only samples that differ from the one before are kept.
    pub changes_only: bool,
}

/// A sample.
#[derive(Clone, Copy, PartialEq, Eq, Debug, Default)]
pub struct Sample {
    /// Begin of the scan, µs.
    pub time_us: u64,
    /// Bit n is signal n.
    pub bits: u32,
}

/// A trace being made.
#[derive(Clone, Debug)]
pub struct Trace {
    signals: Vec<Address>,
    ring: Box<[Sample]>,
    /// Where the next sample goes, and how many there are.
    next: usize,
    len: usize,
    trigger: Option<Trigger>,
    behind: usize,
    changes_only: bool,
    /// The state of the trigger's signal, and the samples before.
    before: Option<bool>,
    last: Option<u32>,
    triggered_us: Option<u64>,
    /// Samples left until the end.
    left: Option<usize>,
}

impl Trace {
    /// A trace with all its room.
    pub fn new(settings: &TraceSettings) -> Trace {
        let signals: Vec<Address> = settings.signals.iter().copied().take(MOST_SIGNALS).collect();
        Trace {
            signals,
            ring: vec![Sample::default(); settings.samples.clamp(1, MOST_SAMPLES)].into(),
            next: 0,
            len: 0,
            trigger: settings.trigger,
            behind: settings.behind,
            changes_only: settings.changes_only,
            before: None,
            last: None,
            triggered_us: None,
            left: None,
        }
    }

    /// Takes a sample of the signals.
    pub(crate) fn sample(&mut self, time_us: u64, memory: &Memory) {
        if self.is_done() {
            return;
        }
        let bits = self
            .signals
            .iter()
            .enumerate()
            .fold(0, |bits, (n, signal)| bits | u32::from(memory.bit(*signal)) << n);
        let is_set_off = self.is_set_off(memory);
        if !self.changes_only || self.last != Some(bits) || is_set_off {
            self.last = Some(bits);
            if let Some(place) = self.ring.get_mut(self.next) {
                *place = Sample { time_us, bits };
            }
            self.next = (self.next + 1) % self.ring.len().max(1);
            self.len = (self.len + 1).min(self.ring.len());
            self.left = self.left.map(|left| left.saturating_sub(1));
        }
        if is_set_off && self.triggered_us.is_none() {
            self.triggered_us = Some(time_us);
            self.left = Some(self.behind);
        }
    }

    fn is_set_off(&mut self, memory: &Memory) -> bool {
        let Some(trigger) = self.trigger else { return false };
        let (Trigger::Rising(signal) | Trigger::Falling(signal) | Trigger::Change(signal)) = trigger;
        let now = memory.bit(signal);
        let Some(before) = self.before.replace(now) else { return false };
        match trigger {
            Trigger::Rising(_) => now && !before,
            Trigger::Falling(_) => before && !now,
            Trigger::Change(_) => now != before,
        }
    }

    /// Whether the samples behind the trigger are complete.
    pub fn is_done(&self) -> bool {
        self.left == Some(0)
    }

    /// When the trigger came, µs.
    pub fn triggered_us(&self) -> Option<u64> {
        self.triggered_us
    }

    /// The signals, in the order of the bits.
    pub fn signals(&self) -> &[Address] {
        &self.signals
    }

    /// How many samples there are.
    pub fn len(&self) -> usize {
        self.len
    }

    /// Whether there is none yet.
    pub fn is_empty(&self) -> bool {
        self.len == 0
    }

    /// The samples, oldest first.
    pub fn samples(&self) -> impl Iterator<Item = Sample> {
        let (newer, older) = self.ring.split_at(self.next.min(self.ring.len()));
        let older = if self.len < self.ring.len() { &[] } else { older };
        older.iter().chain(newer).copied()
    }
}
