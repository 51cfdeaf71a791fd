//! The interpolator: what runs in the servo period.
//!
//! It owns what the planner has handed over, and a place in it. A period costs the evaluation of one polynomial in
//! time and one piece of path, whatever the planner does meanwhile: nothing is allocated or freed, nothing is locked,
//! nobody is waited for. What it has always ends at rest within all limits. So a planner that hangs, or is gone, stops
//! the machine on the path.

use crate::handover::{Receiver, Strip};
use crate::timing::interpolate::{Outcome, Track, Walk};
use crate::timing::plan::Stretch;
use ferrocut_geometry::Position;
use ferrocut_machine::Machine;

/// Where the axes shall be at the end of one servo period.
#[derive(Clone, Copy, PartialEq, Debug)]
pub struct Sample {
    /// Commanded position of every axis: mm, degrees.
    pub position: Position,
    /// Speed along the path, mm/s (degrees/s where only rotary axes move).
    pub velocity: f64,
    /// Mark of the move being run at the end of the period, or of the last one run.
    pub tag: u64,
}

/// The interpolator's half of motion.
#[derive(Debug)]
pub struct Interpolator {
    period: f64,
    receiver: Receiver,
    walk: Walk,
    tag: u64,
}

impl Track for Receiver {
    fn stretch(&mut self) -> Option<Stretch> {
        Receiver::stretch(self)
    }

    fn go_on(&mut self) {
        Receiver::go_on(self);
    }

    fn pass(&mut self, s: f64) -> u64 {
        Receiver::pass(self, s)
    }

    fn pass_to(&mut self, cell: u64) {
        Receiver::pass_to(self, cell);
    }

    fn cell<R>(&mut self, number: u64, look: impl FnOnce(&Strip) -> R) -> Option<R> {
        Receiver::cell(self, number, look)
    }
}

impl Interpolator {
    pub(crate) fn new(machine: &Machine, start: Position, receiver: Receiver) -> Interpolator {
        Interpolator { period: machine.servo_period_ms / 1000.0, receiver, walk: Walk::new(start), tag: 0 }
    }

    /// Goes on by one servo period.
    pub fn tick(&mut self) -> Sample {
        let (number, news) = self.receiver.begin();
        if news.begins {
            self.walk.clear();
        }
        if let Some(axes) = news.axes {
            self.walk.axes = axes;
        }
        let mut time = self.period;
        while let (Outcome::Moves, left) = self.walk.advance(&mut self.receiver, time)
            && left > 0.0
        {
            time = left;
        }
        self.walk.look(&mut self.receiver);
        if let Some(tag) = self.walk.mark().and_then(|s| self.receiver.tag_at(s)) {
            self.tag = tag;
        }
        self.receiver.end(number);
        self.sample()
    }

    /// Where the axes are commanded to be.
    pub fn sample(&self) -> Sample {
        Sample { position: self.walk.position(), velocity: self.walk.speed(), tag: self.tag }
    }

    /// Whether the axes stand still.
    pub fn at_rest(&self) -> bool {
        self.walk.speed() == 0.0
    }

    /// Calls the place where the axes stand by another position, after the planner did
    /// ([`Planner::rename`](crate::Planner::rename)).
    pub fn rename(&mut self, at: Position) {
        self.walk.rename(at);
    }
}
