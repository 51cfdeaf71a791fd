//! The running ladder: one scan a period.
//!
//! Each period level 1 is carried out whole, then as much of level 2 as the period's steps allow; level 2 is
//! left between two networks and goes on there in the next period. It sees X and F as they were when it began
//! (Fanuc: synchronised inputs), level 1 sees them as they are. A scan allocates nothing and takes no more
//! than its steps, whatever the ladder jumps.

use crate::address::{Address, SYSTEM};
use crate::bits;
use crate::compile::{NOWHERE, Program, Segment, Then};
use crate::functions::State;
use crate::memory::{CLOCKS, Memory, STARTED};
use crate::monitor::{self, Flow};
use crate::trace::{Trace, TraceSettings};
use std::time::{Duration, Instant};

/// Subprograms that wait for others.
const CALLS: usize = crate::check::CALLS;

/// Bytes of R9000 that belong to a level: flags, and the rest of a division.
const OWN: usize = 6;

/// How a ladder is run.
#[derive(Clone, Copy, PartialEq, Eq, Debug)]
pub struct Pace {
    /// Length of a period, µs.
    pub period_us: u32,
    /// Steps in a period; what level 1 leaves of them, a quarter at least, is level 2's.
    pub steps: u32,
    /// Steps that level 2 may take to come to its end. More is a loop: alarm 1021.
    pub cycle_steps: u32,
}

impl Default for Pace {
    /// The servo period of the demo mill. 5,000 steps take some 12 µs of it, and the 4,700 of the largest
    /// ladder of the GSK990MC are carried out in each period. 1,000,000 are 3 s at the 3 µs of that control.
    fn default() -> Pace {
        Pace { period_us: 1_000, steps: 5_000, cycle_steps: 1_000_000 }
    }
}

/// Why the ladder stands still.
#[derive(Clone, Copy, PartialEq, Eq, Debug)]
pub enum Stop {
    /// Level 1 does not come to its end within a period (1021).
    FirstLevel,
    /// Level 2 does not come to its end (1021).
    SecondLevel,
}

/// What a scan did.
#[derive(Clone, Copy, PartialEq, Eq, Debug)]
pub struct Scanned {
    /// Steps carried out.
    pub steps: u32,
    /// Whether level 2 began, and took in its inputs.
    pub has_begun: bool,
    /// Whether level 2 came to its end.
    pub is_round: bool,
    /// Why the ladder was stopped, in the scan that stopped it and all after.
    pub stop: Option<Stop>,
    /// Whether a ladder that had just been put in was taken out again, since it did not come to its end.
    pub rolled_back: bool,
}

/// Who may force signals. Whoever guards the rights of users makes one.
#[derive(Clone, Copy, Debug)]
pub struct Maintenance(());

impl Maintenance {
    /// The right, for a user of whom it was proved.
    pub fn granted() -> Maintenance {
        Maintenance(())
    }
}

/// The longest times of a ladder, since it was made or they were forgotten.
#[derive(Clone, Copy, PartialEq, Eq, Debug, Default)]
pub struct Longest {
    /// Level 1.
    pub first: Duration,
    /// What was carried out of level 2 in one period.
    pub second: Duration,
    /// Periods from the beginning of level 2 to its end.
    pub second_periods: u32,
}

/// Where a level stands.
#[derive(Clone, Copy, Debug)]
struct Place {
    segment: u32,
    /// 0 or 1.
    st0: u8,
    calls: [u32; CALLS],
    depth: usize,
}

impl Place {
    fn at(segment: u32) -> Place {
        Place { segment, st0: 0, calls: [0; CALLS], depth: 0 }
    }
}

/// How carrying out a level ended.
enum Ended {
    Finished,
    /// Before a network, since the steps were used up.
    Left,
}

/// A ladder with its signals, running.
#[derive(Debug)]
pub struct Plc {
    program: Box<Program>,
    previous: Option<Box<Program>>,
    /// How often another ladder was put in, or the one before put back.
    exchanges: u64,
    /// Until level 2 came to its end once, a ladder that was put in is taken out again if it is stopped.
    on_trial: bool,
    memory: Memory,
    state: State,
    pace: Pace,
    second: Place,
    /// Whether level 2 begins anew in the next period.
    begins: bool,
    /// Steps of level 2 since it began, and whether its scans are the first ones.
    cycle_steps: u32,
    cycle_periods: u32,
    longest: Longest,
    is_first_round: bool,
    /// R9000 of the two levels.
    own: [[u8; OWN]; 2],
    stop: Option<Stop>,
    is_watched: bool,
    /// Until when the flow is recorded without `is_watched`, µs of the ladder's time.
    watched_until_us: u64,
    trace: Option<Trace>,
}

impl Plc {
    /// A ladder before its first scan; all signals are 0.
    pub fn new(program: Program, pace: Pace) -> Plc {
        let second = Place::at(program.second_level);
        Plc {
            program: Box::new(program),
            previous: None,
            exchanges: 0,
            on_trial: false,
            memory: Memory::new(),
            state: State::new(),
            pace,
            second,
            begins: true,
            cycle_steps: 0,
            cycle_periods: 0,
            longest: Longest::default(),
            is_first_round: true,
            own: [[0; OWN]; 2],
            stop: None,
            is_watched: false,
            watched_until_us: 0,
            trace: None,
        }
    }

    /// The signals.
    pub fn memory(&self) -> &Memory {
        &self.memory
    }

    /// The signals, to write inputs and kept data.
    pub fn memory_mut(&mut self) -> &mut Memory {
        &mut self.memory
    }

    /// The ladder that is running.
    pub fn program(&self) -> &Program {
        &self.program
    }

    /// Time of the last scan's begin, µs.
    pub fn now_us(&self) -> u64 {
        self.state.now_us.saturating_sub(u64::from(self.pace.period_us))
    }

    /// Why the ladder stands still; `None` while it runs.
    pub fn stopped(&self) -> Option<Stop> {
        self.stop
    }

    /// The longest times until now.
    pub fn longest(&self) -> Longest {
        self.longest
    }

    /// Times are taken anew.
    pub fn forget_longest(&mut self) {
        self.longest = Longest::default();
    }

    /// Starts a ladder that was stopped, from its beginning.
    pub fn restart(&mut self) {
        self.stop = None;
        self.is_first_round = true;
        self.begin();
    }

    fn begin(&mut self) {
        self.begins = true;
        self.cycle_steps = 0;
        self.cycle_periods = 0;
        self.second = Place::at(self.program.second_level);
    }

    /// Carries out one period.
    pub fn scan(&mut self) -> Scanned {
        let mut scanned =
            Scanned { steps: 0, has_begun: false, is_round: false, stop: self.stop, rolled_back: false };
        if self.stop.is_none() {
            scanned.has_begun = self.begins;
            self.system_signals();
            let done = if self.records_flow() { self.levels::<true>() } else { self.levels::<false>() };
            match done {
                Ok((steps, is_round)) => {
                    (scanned.steps, scanned.is_round) = (steps, is_round);
                    if is_round {
                        self.is_first_round = false;
                        self.on_trial = false;
                    }
                }
                Err(_) if self.on_trial => {
                    (scanned.rolled_back, scanned.has_begun) = (true, false);
                    self.roll_back();
                    // It ran before; were it taken out too, both would come in turn for ever.
                    self.on_trial = false;
                }
                Err(stop) => {
                    // A PLC that stands still holds no output on: emergency stop and interlocks among G are
                    // on where they are 0.
                    self.memory.clear_outputs();
                    self.stop = Some(stop);
                    scanned.stop = Some(stop);
                }
            }
        }
        if let Some(trace) = &mut self.trace {
            trace.sample(self.state.now_us, &self.memory);
        }
        self.state.now_us = self.state.now_us.saturating_add(u64::from(self.pace.period_us));
        scanned
    }

    /// R9015 and R9091.
    fn system_signals(&mut self) {
        let now_ms = self.state.now_us / 1000;
        // Fanuc: bit 1 is always on, bit 5 is on for 104 of 200 ms, bit 6 for 504 of 1,000 ms.
        let clocks = 0b10 | u8::from(now_ms % 200 < 104) << 5 | u8::from(now_ms % 1000 < 504) << 6;
        self.memory.put(CLOCKS, clocks);
        self.memory.put(STARTED, u8::from(self.is_first_round));
    }

    /// Both levels of a period: steps, and whether level 2 came to its end.
    fn levels<const WATCH: bool>(&mut self) -> Result<(u32, bool), Stop> {
        let began = Instant::now();
        let mut first = Place::at(self.program.first_level);
        let mut left = self.pace.steps;
        self.owned(0);
        let ended = self.run::<WATCH>(&mut first, &mut left);
        self.owns(0);
        let Ended::Finished = ended else { return Err(Stop::FirstLevel) };
        let steps = self.pace.steps - left;
        let between = Instant::now();
        self.longest.first = self.longest.first.max(between.saturating_duration_since(began));
        let share = left.max(self.pace.steps / 4);
        let mut left = share;
        if self.begins {
            self.memory.synchronise();
            self.begins = false;
        }
        let mut second = self.second;
        self.owned(1);
        let ended = self.run::<WATCH>(&mut second, &mut left);
        self.owns(1);
        self.second = second;
        self.longest.second = self.longest.second.max(between.elapsed());
        self.cycle_periods = self.cycle_periods.saturating_add(1);
        let used = share - left;
        self.cycle_steps = self.cycle_steps.saturating_add(used.max(1));
        let is_round = matches!(ended, Ended::Finished);
        if is_round {
            self.longest.second_periods = self.longest.second_periods.max(self.cycle_periods);
            self.begin();
        } else if self.cycle_steps > self.pace.cycle_steps {
            return Err(Stop::SecondLevel);
        }
        Ok((steps + used, is_round))
    }

    /// Puts a level's own R9000 in place.
    fn owned(&mut self, level: usize) {
        let own = self.own.get(level).copied().unwrap_or_default();
        for (at, byte) in (SYSTEM..).zip(own) {
            self.memory.put(at, byte);
        }
    }

    /// Keeps it.
    fn owns(&mut self, level: usize) {
        let now = std::array::from_fn(|n| self.memory.get(SYSTEM.wrapping_add(n as u16)));
        if let Some(own) = self.own.get_mut(level) {
            *own = now;
        }
    }

    /// Carries out a level from a place on until it ends or `left` steps are used up.
    fn run<const WATCH: bool>(&mut self, place: &mut Place, left: &mut u32) -> Ended {
        let Plc { program, memory, state, .. } = self;
        let Program { ops, sources, segments, functions, tables, flow, .. } = &mut **program;
        let mut st0 = place.st0;
        loop {
            let Some(segment) = segments.get(place.segment as usize) else { return Ended::Finished };
            if *left < segment.steps && segment.is_network {
                place.st0 = st0;
                // A network of more steps than a whole period is carried out all the same.
                if *left < segment.steps.min(self.pace.steps / 4) {
                    return Ended::Left;
                }
            }
            *left = left.saturating_sub(segment.steps);
            let Segment { first, end, then, source, depth, .. } = *segment;
            let range = first as usize..end as usize;
            let run = ops.get(range.clone()).unwrap_or_default();
            if WATCH {
                for (op, source) in run.iter().zip(sources.get(range).unwrap_or_default()) {
                    let is_on = op.is_on(memory);
                    st0 = op.run(memory, st0);
                    monitor::record(flow, *source, st0 == 1, is_on);
                }
            } else {
                for op in run {
                    st0 = op.run(memory, st0);
                }
            }
            let condition = st0 == 1;
            let mut next = place.segment + 1;
            match then {
                Then::Next => {}
                Then::Do(index) => {
                    if let Some(function) = functions.get(index as usize) {
                        let conditions = bits::conditions(memory, st0, depth);
                        st0 = u8::from(function.run(memory, state, tables, conditions));
                        *left = left.saturating_sub(std::mem::take(&mut state.cost));
                    }
                }
                Then::Jump { when, to } => {
                    if when.is_none_or(|when| when == condition) {
                        next = to;
                    }
                }
                Then::Leave { to } => {
                    place.depth = 0;
                    next = to;
                }
                Then::Call { when, to } => {
                    if when.is_none_or(|when| when == condition)
                        && let Some(back) = place.calls.get_mut(place.depth)
                    {
                        *back = next;
                        place.depth += 1;
                        next = to;
                    }
                }
                Then::Return => match place.depth.checked_sub(1) {
                    Some(depth) => {
                        place.depth = depth;
                        next = place.calls.get(depth).copied().unwrap_or(u32::MAX);
                    }
                    None => return Ended::Finished,
                },
                Then::Finish => return Ended::Finished,
            }
            if WATCH && source != NOWHERE {
                monitor::record(flow, source, st0 == 1, condition);
            }
            place.segment = next;
        }
    }

    /// Has the powered flow recorded, or no longer; it costs about as much again as the scan.
    pub fn watch(&mut self, on: bool) {
        self.is_watched = on;
        self.program.flow.fill(0);
    }

    /// Has the powered flow recorded for this time from now on, µs of the ladder's time: for those who ask for it
    /// again and again. What was recorded before stays if recording has not ended since.
    pub fn watch_for(&mut self, time_us: u32) {
        if !self.records_flow() {
            self.program.flow.fill(0);
        }
        self.watched_until_us = self.state.now_us.saturating_add(u64::from(time_us));
    }

    fn records_flow(&self) -> bool {
        self.is_watched || self.state.now_us < self.watched_until_us
    }

    /// The powered flow of each instruction of the ladder, as of its last scan.
    pub fn flow(&self) -> impl Iterator<Item = Flow> {
        self.program.flow.iter().map(|bits| Flow::of(*bits))
    }

    /// Forces a bit, or all bits of a byte: neither inputs nor the ladder change it until it is released.
    pub fn force(&mut self, _: &Maintenance, address: Address, value: bool) {
        self.memory.force(address, value);
    }

    /// Releases a bit, or all bits of a byte.
    pub fn release(&mut self, _: &Maintenance, address: Address) {
        self.memory.release(address);
    }

    /// Puts another ladder in the place of the running one, between two scans. Signals, timers, counters and
    /// edges stay as they are; level 2 begins anew. Gives what the exchange put out of reach, to be dropped
    /// where time does not matter.
    pub fn exchange(&mut self, program: Box<Program>) -> Option<Box<Program>> {
        let old = self.previous.replace(std::mem::replace(&mut self.program, program));
        self.exchanges += 1;
        self.on_trial = self.stop.is_none();
        self.begin();
        self.stop = None;
        old
    }

    /// Puts the ladder of before the last exchange back; again, and the newer one is back. Like one that is exchanged it
    /// is on trial at first: one that was taken out because it stopped is taken out again. `false` where there was no
    /// exchange.
    pub fn roll_back(&mut self) -> bool {
        let Some(previous) = &mut self.previous else { return false };
        std::mem::swap(previous, &mut self.program);
        self.exchanges += 1;
        self.on_trial = self.stop.is_none();
        self.begin();
        self.stop = None;
        true
    }

    /// Whether a ladder that was exchanged has not run through yet: the first stop takes it out again.
    pub fn is_on_trial(&self) -> bool {
        self.on_trial
    }

    /// How often another ladder came, by [`exchange`](Plc::exchange), by [`roll_back`](Plc::roll_back), or because one
    /// on trial was taken out again: what is remembered of a ladder holds while this stays.
    pub fn exchanges(&self) -> u64 {
        self.exchanges
    }

    /// Begins to trace signals, with all room that it takes; `None` ends it.
    pub fn set_trace(&mut self, settings: Option<&TraceSettings>) {
        self.trace = settings.map(Trace::new);
    }

    /// What was traced.
    pub fn trace(&self) -> Option<&Trace> {
        self.trace.as_ref()
    }
}
