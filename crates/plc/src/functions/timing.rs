//! TMR, TMRB, CTR, DIFU, DIFD: what remembers from scan to scan, by its number.
//!
//! Numbers outlive the ladder: when another is put in its place while it runs, a timer goes on where it was.

use super::Line;
use crate::address::{COUNTERS, TIMES};
use crate::instruction;
use crate::memory::{Memory, Width};

/// Unit of the times in T of the first timers, µs, and how many have it (Fanuc: 48 ms for timers 1 to 8).
const COARSE: (u16, u64) = (8, 48_000);
/// Unit of all other times in T, µs.
const FINE: u64 = 8_000;

/// Never: a timer that does not run.
const IDLE: u64 = u64::MAX;

/// What functions remember.
#[derive(Clone, Debug)]
pub(crate) struct State {
    /// Time at which this period began, µs.
    pub now_us: u64,
    /// Steps that functions took beyond those of their list.
    pub cost: u32,
    /// When each timer began, µs.
    timers: Box<[u64]>,
    fixed_timers: Box<[u64]>,
    /// ACT of each counter in the scan before.
    counters: Box<[bool]>,
    /// The input of each edge in the scan before.
    edges: Box<[bool]>,
}

impl State {
    pub(crate) fn new() -> State {
        let room = |most: i64| usize::try_from(most).unwrap_or(0) + 1;
        State {
            now_us: 0,
            cost: 0,
            timers: vec![IDLE; room(instruction::TIMERS)].into(),
            fixed_timers: vec![IDLE; room(instruction::FIXED_TIMERS)].into(),
            counters: vec![false; room(instruction::COUNTERS)].into(),
            edges: vec![false; room(instruction::EDGES)].into(),
        }
    }

    pub(super) fn timer(&mut self, memory: &Memory, number: u16, act: bool) -> bool {
        let at = TIMES.wrapping_add(number.wrapping_sub(1).wrapping_mul(2));
        let unit = if number <= COARSE.0 { COARSE.1 } else { FINE };
        // A negative time is none.
        let time_us = u64::try_from(memory.read(at, Width::Two)).unwrap_or(0) * unit;
        run(self.timers.get_mut(usize::from(number)), self.now_us, time_us, act)
    }

    pub(super) fn fixed_timer(&mut self, number: u16, time_us: u64, act: bool) -> bool {
        run(self.fixed_timers.get_mut(usize::from(number)), self.now_us, time_us, act)
    }

    /// CN0 ST3, UPDOWN ST2, RST ST1, ACT ST0. A ring: the count behind the last is the first again.
    pub(super) fn counter(&mut self, memory: &mut Memory, number: u16, line: Line) -> bool {
        let Some(before) = self.counters.get_mut(usize::from(number)) else { return false };
        let at = COUNTERS.wrapping_add(number.wrapping_sub(1).wrapping_mul(4));
        let (preset, count) = (memory.read(at, Width::Two), memory.read(at.wrapping_add(2), Width::Two));
        let is_counted = line.st(0) && !*before;
        *before = line.st(0);
        let (lowest, is_down) = (i32::from(line.st(3)), line.st(2));
        let (first, last) = if is_down { (preset, lowest) } else { (lowest, preset) };
        let count = match (line.st(1), is_counted) {
            (true, _) => first,
            (false, false) => count,
            (false, true) if is_down && count > last => count - 1,
            (false, true) if !is_down && count < last => count + 1,
            (false, true) => first,
        };
        memory.write(at.wrapping_add(2), Width::Two, count);
        // Reset turns W1 off, also where the first count is the last.
        !line.st(1) && count == last
    }

    pub(super) fn edge(&mut self, number: u16, rising: bool, act: bool) -> bool {
        let Some(before) = self.edges.get_mut(usize::from(number)) else { return false };
        let was = std::mem::replace(before, act);
        if rising { act && !was } else { !act && was }
    }
}

/// An on-delay: W1 is on once ACT was on for the time.
fn run(begun: Option<&mut u64>, now_us: u64, time_us: u64, act: bool) -> bool {
    let Some(begun) = begun else { return false };
    if !act {
        *begun = IDLE;
        return false;
    }
    if *begun == IDLE {
        *begun = now_us;
    }
    now_us.saturating_sub(*begun) >= time_us
}
