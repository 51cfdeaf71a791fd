//! TMR, TMRB, CTR, DIFU, DIFD: what remembers from scan to scan, by its number. TMRC and CTRC remember in signals that
//! the ladder gives them.
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

/// In the register of a TMRC: it does not run, and its time is over. Else the time at which it began, ms.
const STOPPED: u32 = 0;
const OVER: u32 = u32::MAX;

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

    /// TMRC: a time of two bytes and a register of four.
    pub(super) fn timer_at(
        &self,
        memory: &mut Memory,
        unit_ms: u32,
        (time, register): (u16, u16),
        act: bool,
    ) -> bool {
        let now = (self.now_us / 1000) as u32;
        let time_ms = u32::try_from(memory.read(time, Width::Two)).unwrap_or(0) * unit_ms;
        let begun = match (act, memory.read(register, Width::Four).cast_unsigned()) {
            (false, _) => STOPPED,
            (true, STOPPED) => now.clamp(STOPPED + 1, OVER - 1),
            (true, begun) => begun,
        };
        // The longest time is less than half of what 32 bits hold, so that those that begin before the count is 0 again
        // end behind it.
        let elapsed = u32::try_from(now.wrapping_sub(begun).cast_signed()).unwrap_or(0);
        let is_over = act && (begun == OVER || elapsed >= time_ms);
        memory.write(register, Width::Four, if is_over { OVER } else { begun }.cast_signed());
        is_over
    }

    /// CN0 ST3, UPDOWN ST2, RST ST1, ACT ST0.
    pub(super) fn counter(&mut self, memory: &mut Memory, number: u16, line: Line) -> bool {
        let Some(before) = self.counters.get_mut(usize::from(number)) else { return false };
        let was = std::mem::replace(before, line.st(0));
        let at = COUNTERS.wrapping_add(number.wrapping_sub(1).wrapping_mul(4));
        count(memory, at, at.wrapping_add(2), was, line)
    }

    pub(super) fn edge(&mut self, number: u16, rising: bool, act: bool) -> bool {
        let Some(before) = self.edges.get_mut(usize::from(number)) else { return false };
        let was = std::mem::replace(before, act);
        if rising { act && !was } else { !act && was }
    }
}

/// CTRC: a preset of two bytes and a register of four, the count and what ACT was.
pub(super) fn counter_at(memory: &mut Memory, preset: u16, register: u16, line: Line) -> bool {
    let at_act = register.wrapping_add(2);
    let was = memory.read(at_act, Width::Two) != 0;
    memory.write(at_act, Width::Two, i32::from(line.st(0)));
    count(memory, preset, register, was, line)
}

/// A ring: the count behind the last is the first again. `was`: ACT of the scan before.
fn count(memory: &mut Memory, preset: u16, at: u16, was: bool, line: Line) -> bool {
    let (preset, count) = (memory.read(preset, Width::Two), memory.read(at, Width::Two));
    let is_counted = line.st(0) && !was;
    let (lowest, is_down) = (i32::from(line.st(3)), line.st(2));
    let (first, last) = if is_down { (preset, lowest) } else { (lowest, preset) };
    let count = match (line.st(1), is_counted) {
        (true, _) => first,
        (false, false) => count,
        (false, true) if is_down && count > last => count - 1,
        (false, true) if !is_down && count < last => count + 1,
        (false, true) => first,
    };
    memory.write(at, Width::Two, count);
    // Reset turns W1 off, also where the first count is the last.
    !line.st(1) && count == last
}

/// The unit of a time of TMRC, ms: 8 ms, 48 ms, 1 s, 10 s, 1 min (Fanuc).
pub(super) fn unit_ms(accuracy: u32) -> u32 {
    match accuracy {
        0 => 8,
        1 => 48,
        2 => 1_000,
        3 => 10_000,
        _ => 60_000,
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
