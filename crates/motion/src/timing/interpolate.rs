//! Interpolation: where the axes are at the end of every servo period.
//!
//! The plan is a list of stretches with closed forms in time ([`crate::timing::plan`]). Each is evaluated from its
//! own start, and the remainder of a period is carried over into the next one: nothing is summed up from period to
//! period. Where the path rests the programmed point itself is put out.

use crate::limits::{Class, Limits};
use crate::path::shape::Shape;
use crate::timing::axes::AxesRun;
use crate::timing::plan::{Plan, Stretch};
use crate::timing::queue::Queue;
use ferrocut_geometry::Position;

/// What became of a period.
#[derive(Clone, Copy, PartialEq, Eq, Debug)]
pub(crate) enum Outcome {
    /// Under way.
    Moves,
    /// At rest on the end of a run, or inside a move of every axis on its own that was stopped.
    Rests,
    /// There is nothing more in the plan: at rest on the path.
    Out,
}

/// Runs the plan.
#[derive(Debug)]
pub(crate) struct Interpolator {
    limits: Limits,
    /// Time since the start of the stretch being run.
    t: f64,
    /// Length on the path.
    s: f64,
    position: Position,
    speed: f64,
    tag: u64,
    axes: AxesRun,
}

impl Interpolator {
    pub fn new(limits: Limits, start: Position) -> Interpolator {
        Interpolator { limits, t: 0.0, s: 0.0, position: start, speed: 0.0, tag: 0, axes: AxesRun::NONE }
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

    /// Time inside the stretch being run.
    pub fn t(&self) -> f64 {
        self.t
    }

    /// Where it is on the path.
    pub fn s(&self) -> f64 {
        self.s
    }

    /// Forgets where it is on the path; only at rest.
    pub fn clear(&mut self) {
        self.t = 0.0;
        self.s = 0.0;
        self.axes = AxesRun::NONE;
    }

    /// Brings the path to rest as soon as the bounds allow. Whether that is under way.
    pub fn stop(&mut self, plan: &mut Plan, queue: &Queue) -> bool {
        if self.axes.is_under_way() {
            self.axes.stop();
            return true;
        }
        plan.stop(queue, self.t)
    }

    /// The plan behind the stretch being run is another one.
    pub fn renewed(&mut self, plan: &Plan) {
        if self.axes.is_under_way() {
            self.axes.set_share(&self.limits, plan.overrides().of(Class::Rapid));
        }
    }

    /// Begins with the current stretch of the plan.
    pub fn enter(&mut self) {
        self.t = 0.0;
    }

    /// Goes on by `time` within the stretch being run; the time that is left behind its end.
    pub fn advance(&mut self, plan: &mut Plan, queue: &mut Queue, time: f64) -> (Outcome, f64) {
        let Some(stretch) = plan.current().copied() else {
            self.speed = 0.0;
            return (Outcome::Out, 0.0);
        };
        let duration = match stretch {
            Stretch::Axes { cell, .. } => return self.advance_axes(plan, queue, cell, time),
            _ => stretch.duration(),
        };
        self.t += time;
        if self.t < duration {
            self.sample(&stretch, queue);
            return (Outcome::Moves, 0.0);
        }
        let left = self.t - duration;
        if left == 0.0 {
            // The period ends with the stretch.
            self.t = duration;
            self.sample(&stretch, queue);
        }
        self.s = stretch.end();
        match stretch {
            Stretch::Corner { cell, .. } => self.retire_to(queue, cell + 1),
            Stretch::Rest { cell, .. } => {
                self.position = queue.cell(cell).rest.unwrap_or(self.position);
                self.tag = queue.tag_at(self.s).unwrap_or(self.tag);
                self.speed = 0.0;
                self.retire_to(queue, cell + 1);
                plan.advance();
                self.enter();
                return (Outcome::Rests, 0.0);
            }
            // A stop on the path ends at rest.
            Stretch::Piece(piece) if piece.to.v == 0.0 => {
                self.t = duration;
                self.sample(&stretch, queue);
                self.s = stretch.end();
            }
            _ => {}
        }
        plan.advance();
        self.enter();
        (Outcome::Moves, left)
    }

    fn advance_axes(&mut self, plan: &mut Plan, queue: &mut Queue, cell: u64, time: f64) -> (Outcome, f64) {
        let Shape::Axes { to, .. } = queue.cell(cell).shape else { return (Outcome::Out, 0.0) };
        if !self.axes.is_under_way() {
            // From where it is: it may have been stopped on the way.
            self.axes.begin(self.position, to, &self.limits, plan.overrides().of(Class::Rapid));
        }
        (self.position, self.speed) = self.axes.advance(time);
        self.tag = queue.tag_at(queue.node(cell).end()).unwrap_or(self.tag);
        if self.axes.is_under_way() {
            return (Outcome::Moves, 0.0);
        }
        self.speed = 0.0;
        if self.position == to {
            self.retire_to(queue, cell + 1);
            plan.advance();
            self.enter();
        }
        (Outcome::Rests, 0.0)
    }

    fn retire_to(&mut self, queue: &mut Queue, number: u64) {
        while queue.head() < number && queue.len() > 0 {
            queue.retire();
        }
    }

    /// Position and speed inside a stretch.
    fn sample(&mut self, stretch: &Stretch, queue: &mut Queue) {
        match *stretch {
            Stretch::Piece(piece) => (self.s, self.speed) = piece.at(self.t),
            Stretch::Corner { s, end, cell, pace, time, .. } => {
                self.retire_to(queue, cell);
                let x = self.t * pace / time;
                if let Shape::Corner(corner) = &queue.cell(cell).shape {
                    self.position = corner.at(x);
                    self.speed = corner.speed(x) * pace;
                }
                self.s = s + (end - s) * x;
                self.tag = queue.tag_at(self.s).unwrap_or(self.tag);
                return;
            }
            Stretch::Axes { .. } | Stretch::Rest { .. } => return,
        }
        while queue.len() > 1 && queue.node(queue.head()).end() < self.s && !queue.node(queue.head()).rests {
            queue.retire();
        }
        let head = queue.head();
        let node = queue.node(head);
        let within = (self.s - node.s).clamp(0.0, node.len);
        self.position = queue.cell(head).shape.at(within);
        self.tag = queue.tag_at(self.s).unwrap_or(self.tag);
    }
}
