//! Interpolation: the cell being run, one servo period after another.
//!
//! The oldest cell of the queue is run by a [`Profile`] made when it is entered, and made again from the
//! state at hand whenever something changes: a better plan, an override, hold, resume. Whatever changes,
//! position and velocity go on from where they are and no acceleration above the cell's bound is used, so
//! no moment is a bad one.
//!
//! Why it can always brake: the speed at a joint is never above what braking from there needs (see
//! [`crate::plan`]). When the override is lowered the machine may be above the new plan; it then brakes as
//! hard as the bound allows, which keeps it under every plan that ever let it get there.

use crate::limits::{Bound, Limits};
use crate::plan::{Cell, Queue, Shape};
use crate::profile::Profile;
use ferrocut_geometry::{AXES, Position};

/// What became of a period.
#[derive(Clone, Copy, PartialEq, Debug)]
pub(crate) enum Outcome {
    /// Still inside the cell.
    Inside,
    /// The cell ended with this much of the period left, s, and the path goes on.
    Left(f64),
    /// The cell ended at rest.
    Rest,
}

/// Runs the oldest cell of the queue.
#[derive(Debug)]
pub(crate) struct Interpolator {
    limits: Limits,
    /// Whether the oldest cell of the queue is being run.
    is_begun: bool,
    /// Along the path the first; where every axis runs on its own, one for each over its distance.
    profiles: [Profile; AXES],
    /// Speed squared at which the next cell is entered.
    w: f64,
    stopping: bool,
    position: Position,
    speed: f64,
    tag: u64,
}

impl Interpolator {
    pub fn new(limits: Limits, start: Position) -> Interpolator {
        Interpolator {
            limits,
            is_begun: false,
            profiles: [Profile::default(); AXES],
            w: 0.0,
            stopping: false,
            position: start,
            speed: 0.0,
            tag: 0,
        }
    }

    /// Calls the place where the axes stand by another position.
    pub fn rename(&mut self, at: Position) {
        self.position = at;
    }

    pub fn position(&self) -> Position {
        self.position
    }

    /// Speed along the path; of a move of every axis on its own, along the line it draws. mm/s.
    pub fn speed(&self) -> f64 {
        self.speed
    }

    pub fn tag(&self) -> u64 {
        self.tag
    }

    /// Whether a cell is begun.
    pub fn is_begun(&self) -> bool {
        self.is_begun
    }

    /// Forgets the cell being run; only at rest.
    pub fn clear(&mut self) {
        self.is_begun = false;
        self.w = 0.0;
        self.stopping = false;
    }

    /// Enters the oldest cell.
    pub fn enter(&mut self, queue: &Queue, stopping: bool) {
        self.stopping = stopping;
        self.is_begun = true;
        match queue.front() {
            Some((Cell { shape: Shape::Axes { from, to }, .. }, _)) => {
                for i in 0..AXES {
                    self.profiles[i] = self.axis_profile(queue, i, (to.0[i] - from.0[i]).abs(), (0.0, 0.0));
                }
            }
            Some(_) => self.profiles[0] = self.path_profile(queue, 0.0, self.w),
            None => self.is_begun = false,
        }
    }

    /// Plans the rest of the cell again from the state at hand.
    pub fn retarget(&mut self, queue: &Queue, stopping: bool) {
        self.stopping = stopping;
        match queue.front() {
            Some((Cell { shape: Shape::Axes { from, to }, .. }, _)) => {
                for i in 0..AXES {
                    let state = self.profiles[i].state();
                    self.profiles[i] = self.axis_profile(queue, i, (to.0[i] - from.0[i]).abs(), state);
                }
            }
            Some(_) => {
                let (s, v) = self.profiles[0].state();
                self.profiles[0] = self.path_profile(queue, s, v * v);
            }
            None => {}
        }
    }

    fn path_profile(&self, queue: &Queue, s: f64, w: f64) -> Profile {
        let Some((cell, node)) = queue.front() else { return Profile::default() };
        let len = (node.len - s).max(0.0);
        let bound = &node.bound;
        let lowest = if cell.rest.is_some() { 0.0 } else { bound.brake(w, len) };
        if self.stopping {
            return Profile::stop(s, w, len, lowest, bound);
        }
        let planned = if cell.rest.is_some() { 0.0 } else { queue.exit() };
        let cap = node.cap(queue.overrides());
        let end = planned.min(cap).min(bound.reach(w, len)).max(lowest);
        Profile::ramps(s, w, len, cap, end, bound)
    }

    /// Axis `i` on its own over a distance, of which it has run `s` and has the speed `v`.
    fn axis_profile(&self, queue: &Queue, i: usize, distance: f64, (s, v): (f64, f64)) -> Profile {
        // An axis without limits still takes a moment.
        let speed = self.limits.rapid[i].min(UNLIMITED);
        let a0 = self.limits.acceleration[i].min(UNLIMITED);
        let bound = Bound { w_max: speed * speed, feed: speed, a0, fade: 0.0 };
        let len = (distance - s).max(0.0);
        if self.stopping {
            return Profile::stop(s, v * v, len, 0.0, &bound);
        }
        let cap = (speed * queue.overrides().rapid).powi(2);
        Profile::ramps(s, v * v, len, cap, 0.0, &bound)
    }

    /// Goes on in the cell by `time` seconds.
    pub fn advance(&mut self, queue: &Queue, time: f64) -> Outcome {
        let Some((cell, _)) = queue.front() else { return Outcome::Rest };
        if let Shape::Axes { .. } = cell.shape {
            for profile in &mut self.profiles {
                let _ = profile.advance(time);
            }
            return if self.profiles.iter().all(Profile::has_arrived) {
                Outcome::Rest
            } else {
                Outcome::Inside
            };
        }
        let profile = &mut self.profiles[0];
        match profile.advance(time) {
            None => Outcome::Inside,
            Some(_) if !profile.has_arrived() => Outcome::Inside,
            Some(_) if cell.rest.is_some() => Outcome::Rest,
            Some(left) => {
                self.w = profile.end_w();
                Outcome::Left(left)
            }
        }
    }

    /// The path came to rest at the end of the cell.
    pub fn arrive(&mut self, queue: &Queue) {
        if let Some((cell, _)) = queue.front() {
            self.position = cell.rest.unwrap_or(self.position);
            self.tag = cell.tags[1];
        }
        self.speed = 0.0;
        self.clear();
    }

    /// Takes position and speed from the state inside the cell.
    pub fn sample(&mut self, queue: &Queue) {
        let Some((cell, node)) = queue.front() else { return };
        let (s, v) = self.profiles[0].state();
        if let Shape::Axes { from, to } = cell.shape {
            let mut squares = 0.0;
            for (i, profile) in self.profiles.iter().enumerate() {
                let (s, v) = profile.state();
                let way = to.0[i] - from.0[i];
                let on_the_way = from.0[i] + s.copysign(way);
                self.position.0[i] = if profile.has_arrived() { to.0[i] } else { on_the_way };
                squares += v * v;
            }
            self.speed = squares.sqrt();
        } else {
            self.position = cell.shape.at(s);
            self.speed = v;
        }
        self.tag = cell.tags[usize::from(s > node.len / 2.0)];
    }
}

/// Speed and acceleration of an axis that the machine file does not limit.
const UNLIMITED: f64 = 1e6;
