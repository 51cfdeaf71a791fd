//! How long periods and scans take: what the diagnosis of a control says of itself.

use super::Control;
use crate::api::Reply;
use std::time::{Duration, Instant};

/// The longest times since power-on, or since they were forgotten.
#[derive(Default)]
pub(super) struct Timing {
    periods: u64,
    /// When the period before began.
    began: Option<Instant>,
    period: Duration,
    work: Duration,
}

impl Timing {
    /// A period begins.
    pub fn begin(&mut self) {
        let now = Instant::now();
        if let Some(before) = self.began.replace(now) {
            self.period = self.period.max(now.saturating_duration_since(before));
        }
        self.periods += 1;
    }

    /// Its work is done.
    pub fn end(&mut self) {
        let work = self.began.map_or(Duration::ZERO, |began| began.elapsed());
        self.work = self.work.max(work);
    }
}

impl Control {
    /// The longest times; with `forget` they are taken anew from here.
    pub(super) fn timing(&mut self, forget: bool) -> Reply {
        let us = |time: Duration| time.as_secs_f64() * 1e6;
        let scan = self.plc.as_ref().map(|plc| plc.longest()).unwrap_or_default();
        let reply = Reply::Timing {
            periods: self.timing.periods,
            period_us: self.machine.servo_period_ms * 1000.0,
            worst_period_us: us(self.timing.period),
            worst_work_us: us(self.timing.work),
            worst_level_1_us: us(scan.first),
            worst_level_2_us: us(scan.second),
            level_2_periods: scan.second_periods,
        };
        if forget {
            self.timing = Timing { began: self.timing.began, ..Timing::default() };
            if let Some(plc) = &mut self.plc {
                plc.forget_longest();
            }
        }
        reply
    }
}
