//! Motion whose planner works in the thread of the servo period, or in one beside it.
//!
//! The planner takes milliseconds at times. Beside, it is handed over as soon as a period is to be planned, and taken
//! back when it is done: a period neither waits for it nor shares anything with it while it is away. It is ahead of the
//! axes by [`LEAD_S`](ferrocut_motion::LEAD_S), so that what it plans is in time although it comes some periods later;
//! setpoints are the same. Joining moves into a path takes its time too, so they lie in a ring until the planner takes
//! them where it plans. While it is away motion counts as busy, and what is asked of it (a hold, an override) waits until
//! it is back.

use super::lent::Beside;
use ferrocut_geometry::Position;
use ferrocut_machine::Machine;
use ferrocut_motion::{Interpolator, Motion, Move, Planner, Sample};
use rtrb::{Consumer, Producer, RingBuffer};

/// Moves and ends that lie on their way to the planner at most.
const WAY: usize = 256;

/// What the planner is given on its way.
#[derive(Clone, Copy)]
enum Given {
    Move(Move),
    /// Nothing follows for now.
    Finish,
}

/// The planner with what lies on its way to it.
struct Work {
    planner: Planner,
    way: Consumer<Given>,
}

impl Work {
    /// Takes what lies there, as far as there is room.
    fn take(&mut self) {
        while let Ok(given) = self.way.peek() {
            match given {
                Given::Move(m) if self.planner.push(m).is_err() => return,
                Given::Move(_) => {}
                Given::Finish => self.planner.finish(),
            }
            let _ = self.way.pop();
        }
    }

    /// Whether it has something to do.
    fn is_due(&self) -> bool {
        self.planner.is_due() || !self.way.is_empty() && self.planner.free() > 0
    }

    fn plan(&mut self) {
        self.take();
        while self.planner.is_due() {
            self.planner.tick();
            self.take();
        }
    }

    fn abort(&mut self) {
        while self.way.pop().is_ok() {}
        self.planner.abort();
    }
}

/// What was asked for while the planner was away.
#[derive(Clone, Copy, Default)]
struct Asked {
    overrides: Option<(f64, f64)>,
    rapid_speed: Option<f64>,
    spindle: Option<f64>,
    hold: Option<bool>,
    abort: bool,
}

/// Motion.
pub(super) struct Planning {
    /// The planner, while it is here.
    work: Option<Box<Work>>,
    /// The way to it, which is used where it plans beside.
    way: Producer<Given>,
    /// What was put there last is that nothing follows.
    is_finished: bool,
    interpolator: Interpolator,
    beside: Option<Beside<Box<Work>>>,
    asked: Asked,
    /// Periods that the planner did not decide in time, and the room that it had, when it went.
    late: u64,
    room: usize,
}

impl Planning {
    pub fn new(machine: &Machine, start: Position) -> Planning {
        let (planner, interpolator) = Motion::halves(machine, start);
        let (producer, way) = RingBuffer::new(WAY);
        Planning {
            room: planner.free(),
            work: Some(Box::new(Work { planner, way })),
            way: producer,
            is_finished: false,
            interpolator,
            beside: None,
            asked: Asked::default(),
            late: 0,
        }
    }

    /// From now on the planner works in a thread of its own, which has the priority of this one.
    pub fn plan_beside(&mut self) -> std::io::Result<()> {
        if self.beside.is_some() {
            return Ok(());
        }
        self.beside = Some(Beside::start("planner", |work: &mut Box<Work>| work.plan())?);
        Ok(())
    }

    fn planner(&self) -> Option<&Planner> {
        self.work.as_ref().map(|work| &work.planner)
    }

    /// Takes the planner back, if it is done: at the beginning of each period.
    pub fn fetch(&mut self) {
        if self.work.is_none()
            && let Some(beside) = &mut self.beside
            && let Some(work) = beside.fetch()
        {
            self.late = work.planner.late();
            self.work = Some(work);
            self.ask();
        }
    }

    /// Waits until the planner is back: at rest, and for clocks that do not wait themselves.
    pub fn await_planner(&mut self) {
        while self.work.is_none() && self.beside.as_ref().is_some_and(|beside| !beside.is_gone()) {
            self.fetch();
            std::thread::yield_now();
        }
    }

    /// Tells the planner what it was asked for meanwhile.
    fn ask(&mut self) {
        let Some(work) = &mut self.work else { return };
        let asked = std::mem::take(&mut self.asked);
        if let Some((feed, rapid)) = asked.overrides {
            work.planner.set_override(feed, rapid);
        }
        if let Some(speed) = asked.rapid_speed {
            work.planner.set_rapid_speed(speed);
        }
        if let Some(rpm) = asked.spindle {
            work.planner.set_spindle(rpm);
        }
        match asked.hold {
            Some(true) => work.planner.hold(),
            Some(false) => work.planner.resume(),
            None => {}
        }
        if asked.abort {
            work.abort();
        }
    }

    /// How many moves may be given now. What is aborted has no room, so nothing comes behind that while it is away.
    pub fn free(&self) -> usize {
        if self.asked.abort {
            return 0;
        }
        let room = self.room();
        match self.beside {
            None => room,
            // Behind each move may lie that nothing follows.
            Some(_) => room.saturating_sub(WAY - self.way.slots()).min(self.way.slots() / 2),
        }
    }

    /// The room that there is, or was when the planner went: for whoever shows it.
    pub fn room(&self) -> usize {
        self.planner().map_or(self.room, |planner| planner.free())
    }

    /// Whether the move was taken. Whoever asked [`free`](Self::free) before is sure of it.
    pub fn push(&mut self, m: &Move) -> bool {
        self.is_finished = false;
        match (&mut self.work, &self.beside) {
            (Some(work), None) => work.planner.push(m).is_ok(),
            _ => self.way.push(Given::Move(*m)).is_ok(),
        }
    }

    pub fn finish(&mut self) {
        match (&mut self.work, &self.beside) {
            (Some(work), None) => work.planner.finish(),
            _ if self.is_finished => {}
            _ => self.is_finished = self.way.push(Given::Finish).is_ok(),
        }
    }

    pub fn set_override(&mut self, feed: f64, rapid: f64) {
        self.asked.overrides = Some((feed, rapid));
        self.ask();
    }

    /// Speed that no axis exceeds in positioning, mm/s or degrees/s.
    pub fn set_rapid_speed(&mut self, speed: f64) {
        self.asked.rapid_speed = Some(speed);
        self.ask();
    }

    /// Speed of the spindle that feeds per revolution follow, r/min.
    pub fn set_spindle(&mut self, rpm: f64) {
        self.asked.spindle = Some(rpm);
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
        self.is_finished = false;
        self.ask();
    }

    /// Turns the path back, or forward again; whether it is ([`Planner::retrace`]). `None` while the planner is away.
    pub fn retrace(&mut self, back: bool) -> Option<bool> {
        let work = self.work.as_mut()?;
        if back {
            work.take();
        }
        Some(work.planner.retrace(back))
    }

    /// Whether the path was run back as far as it is known, and the axes stand there.
    pub fn is_at_back_end(&self) -> bool {
        self.planner().is_some_and(Planner::is_at_back_end)
    }

    /// What was passed up to here is not run back over; only at rest.
    pub fn forget_passed(&mut self) {
        self.await_planner();
        if let Some(work) = &mut self.work {
            work.planner.forget_passed();
        }
    }

    /// Calls the place where the axes stand by another position; only at rest.
    pub fn rename(&mut self, at: Position) {
        self.await_planner();
        let Some(work) = &mut self.work else { return };
        work.take();
        if work.planner.rename(at) {
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
        self.planner().is_some_and(|planner| planner.is_still())
    }

    pub fn is_empty(&self) -> bool {
        self.work.as_ref().is_some_and(|work| work.planner.is_empty() && work.way.is_empty())
    }

    /// Periods that were not planned in time: the axes ran on as they did, or stood.
    pub fn late(&self) -> u64 {
        self.planner().map_or(self.late, |planner| planner.late())
    }

    /// Plans what is due, here or beside.
    pub fn plan(&mut self) {
        match (self.work.take(), &mut self.beside) {
            (Some(mut work), None) => {
                work.plan();
                self.work = Some(work);
            }
            (Some(work), Some(beside)) if work.is_due() => {
                self.room = work.planner.free();
                // It is never full, as there is one planner.
                self.work = beside.lend(work).err();
            }
            (work, _) => self.work = work,
        }
    }

    /// Goes on by one servo period.
    pub fn tick(&mut self) -> Sample {
        self.plan();
        self.interpolator.tick()
    }
}
