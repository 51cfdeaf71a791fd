//! Interpolation: how far the path is at the end of every servo period.
//!
//! The plan is a list of stretches with closed forms in time ([`crate::timing::plan`]). Each is evaluated from its
//! own start, and the remainder of a period is carried over into the next one: nothing is summed up from period to
//! period. Where the path rests the programmed point itself is put out.
//!
//! Planner and interpolator walk along the same stretches by this code, the planner some periods ahead: so it knows
//! to the bit what will be run when a change takes over. Only the interpolator needs the point at the end of every
//! period, so [`Walk::look`] is a step of its own.

use crate::handover::Strip;
use crate::path::shape::Shape;
use crate::timing::axes::AxesRun;
use crate::timing::plan::Stretch;
use ferrocut_geometry::Position;

/// What became of a period.
#[derive(Clone, Copy, PartialEq, Eq, Debug)]
pub(crate) enum Outcome {
    /// Under way.
    Moves,
    /// At rest on the end of a run, or inside a move of every axis on its own that was stopped.
    Rests,
    /// There is nothing more in the plan, or a move of every axis on its own that has not begun: at rest.
    Out,
}

/// What is walked along.
pub(crate) trait Track {
    /// The stretch being run.
    fn stretch(&mut self) -> Option<Stretch>;
    /// Goes on to the next one.
    fn go_on(&mut self);
    /// The cell in which the length `s` lies; those before it are passed.
    fn pass(&mut self, s: f64) -> u64;
    /// Cells before this one are passed.
    fn pass_to(&mut self, cell: u64);
    /// Looks at a cell.
    fn cell<R>(&mut self, number: u64, look: impl FnOnce(&Strip) -> R) -> Option<R>;
}

/// Where the axes are, as it is known before the point is worked out.
#[derive(Clone, Copy, Debug)]
enum Place {
    /// Where they were.
    Same,
    Point(Position),
    Path {
        cell: u64,
        s: f64,
    },
    Corner {
        cell: u64,
        x: f64,
        pace: f64,
    },
}

/// A walk along the plan.
#[derive(Debug)]
pub(crate) struct Walk {
    /// Time since the start of the stretch being run.
    t: f64,
    /// Length on the path.
    s: f64,
    place: Place,
    position: Position,
    speed: f64,
    /// The length on the path that decides which block is run.
    mark: Option<f64>,
    pub axes: AxesRun,
}

impl Walk {
    pub fn new(start: Position) -> Walk {
        let place = Place::Same;
        Walk { t: 0.0, s: 0.0, place, position: start, speed: 0.0, mark: None, axes: AxesRun::NONE }
    }

    /// Calls the place where the axes stand by another position.
    pub fn rename(&mut self, at: Position) {
        (self.place, self.position) = (Place::Same, at);
    }

    /// Where the axes are, as it was last looked at.
    pub fn position(&self) -> Position {
        self.position
    }

    /// Speed along the path; of a move of every axis on its own, along the line it draws. mm/s.
    pub fn speed(&self) -> f64 {
        self.speed
    }

    /// The same place is another length on the path; only at rest.
    pub fn set_s(&mut self, s: f64) {
        self.s = s;
    }

    /// Time inside the stretch being run.
    pub fn t(&self) -> f64 {
        self.t
    }

    /// Where it is on the path.
    pub fn s(&self) -> f64 {
        self.s
    }

    /// Where on the path the block ends or goes on that this period was in; `None` if it is the one before.
    pub fn mark(&mut self) -> Option<f64> {
        self.mark.take()
    }

    /// Forgets where it is on the path; only at rest.
    pub fn clear(&mut self) {
        (self.t, self.s) = (0.0, 0.0);
        self.axes = AxesRun::NONE;
    }

    /// Begins with the current stretch of the plan.
    pub fn enter(&mut self) {
        self.t = 0.0;
    }

    /// Goes on by `time` within the stretch being run; the time that is left behind its end.
    pub fn advance(&mut self, track: &mut impl Track, time: f64) -> (Outcome, f64) {
        let Some(stretch) = track.stretch() else {
            self.speed = 0.0;
            return (Outcome::Out, 0.0);
        };
        if let Stretch::Axes { cell, .. } = stretch {
            return self.advance_axes(track, cell, time);
        }
        let duration = stretch.duration();
        self.t += time;
        if self.t < duration {
            self.locate(&stretch, track);
            return (Outcome::Moves, 0.0);
        }
        let left = self.t - duration;
        if left == 0.0 {
            // The period ends with the stretch.
            self.t = duration;
            self.locate(&stretch, track);
        }
        self.s = stretch.end();
        match stretch {
            Stretch::Corner { cell, .. } => track.pass_to(cell + 1),
            Stretch::Rest { cell, .. } => {
                if let Some(point) = track.cell(cell, |strip| strip.cell.rest).flatten() {
                    self.place = Place::Point(point);
                }
                self.mark = Some(self.s);
                self.speed = 0.0;
                track.pass_to(cell + 1);
                track.go_on();
                self.enter();
                return (Outcome::Rests, 0.0);
            }
            // A stop on the path ends at rest.
            Stretch::Piece(piece) if piece.to.v == 0.0 => {
                self.t = duration;
                self.locate(&stretch, track);
                self.s = stretch.end();
            }
            _ => {}
        }
        track.go_on();
        self.enter();
        (Outcome::Moves, left)
    }

    fn advance_axes(&mut self, track: &mut impl Track, cell: u64, time: f64) -> (Outcome, f64) {
        if !self.axes.is_under_way() {
            self.speed = 0.0;
            return (Outcome::Out, 0.0);
        }
        let (position, speed) = self.axes.advance(time);
        (self.place, self.speed) = (Place::Point(position), speed);
        self.mark = track.cell(cell, |strip| strip.s + strip.len).or(self.mark);
        if self.axes.is_under_way() {
            return (Outcome::Moves, 0.0);
        }
        self.speed = 0.0;
        if position == self.axes.to() {
            track.pass_to(cell + 1);
            track.go_on();
            self.enter();
        }
        (Outcome::Rests, 0.0)
    }

    /// Where it is inside a stretch.
    fn locate(&mut self, stretch: &Stretch, track: &mut impl Track) {
        match *stretch {
            Stretch::Piece(piece) => {
                (self.s, self.speed) = piece.at(self.t);
                self.place = Place::Path { cell: track.pass(self.s), s: self.s };
            }
            Stretch::Corner { s, end, cell, pace, time, .. } => {
                track.pass_to(cell);
                let x = self.t * pace / time;
                self.place = Place::Corner { cell, x, pace };
                // The speed itself is worked out with the point.
                self.speed = pace;
                self.s = s + (end - s) * x;
            }
            Stretch::Axes { .. } | Stretch::Rest { .. } => return,
        }
        self.mark = Some(self.s);
    }

    /// Works out where the axes are.
    pub fn look(&mut self, track: &mut impl Track) {
        let found = match std::mem::replace(&mut self.place, Place::Same) {
            Place::Same => None,
            Place::Point(point) => Some((point, self.speed)),
            Place::Path { cell, s } => {
                let look = |strip: &Strip| {
                    let s = (s - strip.s).clamp(0.0, strip.len);
                    (strip.cell.at(s, strip.len), strip.cell.stretch(s, strip.len))
                };
                track.cell(cell, look).map(|(point, stretch)| (point, self.speed * stretch))
            }
            Place::Corner { cell, x, pace } => track
                .cell(cell, |strip| match &strip.cell.shape {
                    Shape::Corner(corner) => {
                        let x = if strip.cell.is_back { 1.0 - x } else { x };
                        Some((corner.at(x), corner.speed(x) * pace))
                    }
                    _ => None,
                })
                .flatten(),
        };
        if let Some((position, speed)) = found {
            (self.position, self.speed) = (position, speed);
        }
    }
}
