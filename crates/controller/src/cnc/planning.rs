//! Motion whose planner works in the thread of the servo period, or in one beside it.
//!
//! The planner takes milliseconds at times. Beside, it is handed over as soon as a period is to be planned, and taken
//! back when it is done: a period neither waits for it nor shares anything with it while it is away. It is ahead of the
//! axes by [`LEAD_S`](ferrocut_motion::LEAD_S), so that what it plans is in time although it comes some periods later;
//! setpoints are the same. While it is away motion takes no moves and counts as busy, and what is asked of it (a hold, an
//! override) waits until it is back.

use ferrocut_geometry::Position;
use ferrocut_machine::Machine;
use ferrocut_motion::{Interpolator, Motion, Move, Planner, Sample};
use rtrb::{Consumer, Producer, RingBuffer};
use std::thread::JoinHandle;
use std::time::Duration;

/// How long the thread sleeps before it looks for work again: far less than the planner is ahead. It is not woken, since
/// that takes the system longer than all else in a period.
const NAP: Duration = Duration::from_micros(500);

/// The thread beside.
struct Beside {
    give: Producer<Box<Planner>>,
    take: Consumer<Box<Planner>>,
    thread: JoinHandle<()>,
}

/// What was asked for while the planner was away.
#[derive(Clone, Copy, Default)]
struct Asked {
    finish: bool,
    overrides: Option<(f64, f64)>,
    hold: Option<bool>,
    abort: bool,
}

/// Motion.
pub(super) struct Planning {
    /// The planner, while it is here.
    planner: Option<Box<Planner>>,
    interpolator: Interpolator,
    beside: Option<Beside>,
    asked: Asked,
    /// Periods that the planner did not decide in time, and the room that it had, when it went.
    late: u64,
    room: usize,
}

impl Planning {
    pub fn new(machine: &Machine, start: Position) -> Planning {
        let (planner, interpolator) = Motion::halves(machine, start);
        let planner = Some(Box::new(planner));
        Planning { planner, interpolator, beside: None, asked: Asked::default(), late: 0, room: 0 }
    }

    /// From now on the planner works in a thread of its own, which has the priority of this one.
    pub fn plan_beside(&mut self) -> std::io::Result<()> {
        if self.beside.is_some() {
            return Ok(());
        }
        let (give, mut given) = RingBuffer::<Box<Planner>>::new(1);
        let (mut done, take) = RingBuffer::new(1);
        let thread = std::thread::Builder::new().name("planner".to_owned()).spawn(move || {
            while !given.is_abandoned() {
                let Ok(mut planner) = given.pop() else {
                    std::thread::park_timeout(NAP);
                    continue;
                };
                while planner.is_due() {
                    planner.tick();
                }
                // There is room: it is the only one.
                let _ = done.push(planner);
            }
        })?;
        self.beside = Some(Beside { give, take, thread });
        Ok(())
    }

    /// Takes the planner back, if it is done: at the beginning of each period.
    pub fn fetch(&mut self) {
        if self.planner.is_none()
            && let Some(beside) = &mut self.beside
            && let Ok(planner) = beside.take.pop()
        {
            self.late = planner.late();
            self.planner = Some(planner);
            self.ask();
        }
    }

    /// Waits until the planner is back: at rest, and for clocks that do not wait themselves.
    pub fn await_planner(&mut self) {
        while self.planner.is_none() && self.beside.as_ref().is_some_and(|beside| !beside.take.is_abandoned())
        {
            self.fetch();
            std::thread::yield_now();
        }
    }

    /// Tells the planner what it was asked for meanwhile.
    fn ask(&mut self) {
        let Some(planner) = &mut self.planner else { return };
        let asked = std::mem::take(&mut self.asked);
        if let Some((feed, rapid)) = asked.overrides {
            planner.set_override(feed, rapid);
        }
        match asked.hold {
            Some(true) => planner.hold(),
            Some(false) => planner.resume(),
            None => {}
        }
        if asked.finish {
            planner.finish();
        }
        if asked.abort {
            planner.abort();
        }
    }

    pub fn free(&self) -> usize {
        self.planner.as_ref().map_or(0, |planner| planner.free())
    }

    /// The room that there is, or was when the planner went: for whoever shows it.
    pub fn room(&self) -> usize {
        self.planner.as_ref().map_or(self.room, |planner| planner.free())
    }

    /// Whether the move was taken. Whoever asked [`free`](Self::free) before is sure of it.
    pub fn push(&mut self, m: &Move) -> bool {
        self.planner.as_mut().is_some_and(|planner| planner.push(m).is_ok())
    }

    pub fn finish(&mut self) {
        self.asked.finish = true;
        self.ask();
    }

    pub fn set_override(&mut self, feed: f64, rapid: f64) {
        self.asked.overrides = Some((feed, rapid));
        self.ask();
    }

    pub fn hold(&mut self) {
        self.asked.hold = Some(true);
        self.ask();
    }

    pub fn resume(&mut self) {
        self.asked.hold = Some(false);
        self.ask();
    }

    pub fn abort(&mut self) {
        self.asked.abort = true;
        self.ask();
    }

    /// Calls the place where the axes stand by another position; only at rest.
    pub fn rename(&mut self, at: Position) {
        self.await_planner();
        if self.planner.as_mut().is_some_and(|planner| planner.rename(at)) {
            self.interpolator.rename(at);
        }
    }

    pub fn position(&self) -> Position {
        self.interpolator.sample().position
    }

    pub fn at_rest(&self) -> bool {
        self.interpolator.at_rest()
    }

    pub fn is_still(&self) -> bool {
        self.planner.as_ref().is_some_and(|planner| planner.is_still())
    }

    pub fn is_empty(&self) -> bool {
        self.planner.as_ref().is_some_and(|planner| planner.is_empty())
    }

    /// Periods that were not planned in time: the axes ran on as they did, or stood.
    pub fn late(&self) -> u64 {
        self.planner.as_ref().map_or(self.late, |planner| planner.late())
    }

    /// Plans what is due, here or beside.
    pub fn plan(&mut self) {
        match (self.planner.take(), &mut self.beside) {
            (Some(mut planner), None) => {
                while planner.is_due() {
                    planner.tick();
                }
                self.planner = Some(planner);
            }
            (Some(planner), Some(beside)) if planner.is_due() => {
                self.room = planner.free();
                // It is never full, as there is one planner.
                if let Err(rtrb::PushError::Full(planner)) = beside.give.push(planner) {
                    self.planner = Some(planner);
                }
            }
            (planner, _) => self.planner = planner,
        }
    }

    /// Goes on by one servo period.
    pub fn tick(&mut self) -> Sample {
        self.plan();
        self.interpolator.tick()
    }
}

impl Drop for Planning {
    fn drop(&mut self) {
        if let Some(Beside { give, thread, .. }) = self.beside.take() {
            drop(give);
            thread.thread().unpark();
            let _ = thread.join();
        }
    }
}
