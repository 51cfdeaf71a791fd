//! What a cycle makes the machine do, and the tool that does it in a frame of its own.
//!
//! The families of cycles beside this file are pure: from parameters to [`Act`]s, which a [`Take`] carries
//! out, writes down or counts. They draw with a [`Tool`]: counter-clockwise, about the origin of a
//! [`Frame`], which turns and mirrors what they draw, and with "up" away from the part, whichever way the
//! tool axis points. Points are of the tool centre, programmed [abscissa, ordinate, tool axis], mm.

use crate::stages::rotation::sin_cos_degrees;
use ferrocut_geometry::{SAME_POINT_MM, Turn};
use std::f64::consts::{FRAC_PI_2, PI, TAU};

/// One thing that a cycle does, from where the last one ended. Feeds are in the unit of the program's F.
#[derive(Clone, Copy, PartialEq, Debug)]
pub enum Act {
    /// At rapid.
    Rapid {
        /// End point.
        to: [f64; 3],
    },
    /// Straight at a feed.
    Feed {
        /// End point.
        to: [f64; 3],
        /// The feed.
        feed: f64,
    },
    /// Along a circle in the plane; a helix where the end lies on another level.
    Arc {
        /// End point.
        to: [f64; 3],
        /// Centre in the plane.
        center: [f64; 2],
        /// Angle turned, radians, counter-clockwise positive; beyond a turn for a helix of several.
        sweep: f64,
        /// The feed.
        feed: f64,
    },
    /// Straight and in step with the spindle.
    Tap {
        /// End point.
        to: [f64; 3],
        /// Travel a turn, mm; right-hand thread positive.
        pitch: f64,
        /// Spindle speed, r/min.
        rpm: f64,
    },
    /// Waits, s.
    Dwell(f64),
    /// Stops the spindle.
    Stop,
    /// Turns the spindle this way at the speed in force.
    Start(Turn),
    /// Stops the spindle at an angle, degrees.
    Orient(f64),
}

/// Takes what a cycle does, act by act or move by move; an error ends the cycle there.
pub trait Take<M = Act> {
    /// What the taker may refuse with.
    type Error;
    /// The next one.
    fn take(&mut self, next: M) -> Result<(), Self::Error>;
}

impl<M, E, F: FnMut(M) -> Result<(), E>> Take<M> for F {
    type Error = E;
    fn take(&mut self, next: M) -> Result<(), E> {
        self(next)
    }
}

/// Which way "up" is, away from the bottom: +1 where it lies towards minus of the reference level, −1 where
/// towards plus.
pub fn up(bottom: f64, reference: f64) -> f64 {
    if bottom > reference { -1.0 } else { 1.0 }
}

/// A frame u, v in the plane.
#[derive(Clone, Copy, PartialEq, Debug)]
pub struct Frame {
    origin: [f64; 2],
    u: [f64; 2],
    v: [f64; 2],
}

impl Frame {
    /// u lies `degrees` from the abscissa, and counter-clockwise in u, v turns as `turn` says. By whole quarters
    /// coordinates change places and signs, and nothing is rounded.
    pub fn new(origin: [f64; 2], degrees: f64, turn: Turn) -> Frame {
        let side = match turn {
            Turn::CounterClockwise => 1.0,
            Turn::Clockwise => -1.0,
        };
        let (sin, cos) = sin_cos_degrees(degrees);
        Frame { origin, u: [cos, sin], v: [-side * sin, side * cos] }
    }

    /// The frame whose u is this one's v; the sense of rotation stays.
    pub fn quarter_turned(self) -> Frame {
        let Frame { origin, u: [a, b], v } = self;
        Frame { origin, u: v, v: [-a, -b] }
    }

    /// The frame about another of its points.
    pub fn about(self, point: [f64; 2]) -> Frame {
        Frame { origin: self.world(point), ..self }
    }

    /// The same frame elsewhere.
    pub fn shifted(self, [a, b]: [f64; 2]) -> Frame {
        Frame { origin: [self.origin[0] + a, self.origin[1] + b], ..self }
    }

    /// The frame with u, v or both the other way.
    pub fn flipped(self, [u, v]: [bool; 2]) -> Frame {
        let turn = |flips: bool, [a, b]: [f64; 2]| if flips { [-a, -b] } else { [a, b] };
        Frame { u: turn(u, self.u), v: turn(v, self.v), ..self }
    }

    /// The frame with u and v exchanged.
    pub fn exchanged(self) -> Frame {
        Frame { u: self.v, v: self.u, ..self }
    }

    /// Abscissa and ordinate of a point.
    pub fn world(&self, [u, v]: [f64; 2]) -> [f64; 2] {
        let [a, b] = self.origin;
        [a + u * self.u[0] + v * self.v[0], b + u * self.u[1] + v * self.v[1]]
    }

    /// +1 where the sense of rotation is kept, −1 in a mirrored frame.
    pub fn handedness(&self) -> f64 {
        (self.u[0] * self.v[1] - self.u[1] * self.v[0]).signum()
    }
}

/// The tool centre, and what its moves go to.
pub struct Tool<'a, T> {
    frame: Frame,
    at: [f64; 3],
    feed: f64,
    /// +1 where the part lies towards minus, −1 where it lies towards plus.
    up: f64,
    taker: &'a mut T,
}

impl<'a, T: Take> Tool<'a, T> {
    /// A tool that stands at `at`.
    pub fn new(frame: Frame, at: [f64; 3], up: f64, taker: &'a mut T) -> Self {
        Tool { frame, at, feed: 0.0, up, taker }
    }

    /// The feed from here on.
    pub fn set_feed(&mut self, feed: f64) {
        self.feed = feed;
    }

    /// Draws in another frame from here on.
    pub fn set_frame(&mut self, frame: Frame) {
        self.frame = frame;
    }

    /// The frame.
    pub fn frame(&self) -> Frame {
        self.frame
    }

    /// Where the tool stands: abscissa, ordinate, tool axis.
    pub fn at(&self) -> [f64; 3] {
        self.at
    }

    /// The level of the tool tip.
    pub fn z(&self) -> f64 {
        self.at[2]
    }

    /// The level that lies `distance` above another, away from the part.
    pub fn above(&self, z: f64, distance: f64) -> f64 {
        z + self.up * distance
    }

    /// How far a level lies above another.
    pub fn height(&self, z: f64, over: f64) -> f64 {
        (z - over) * self.up
    }

    /// Rapid along the tool axis. A move to where the tool is already is left out, here and below.
    pub fn rapid_z(&mut self, z: f64) -> Result<(), T::Error> {
        let [a, b, _] = self.at;
        self.put([a, b, z], |to| Act::Rapid { to })
    }

    /// Rapid in the plane.
    pub fn rapid(&mut self, point: [f64; 2]) -> Result<(), T::Error> {
        let to = self.level(point);
        self.put(to, |to| Act::Rapid { to })
    }

    /// Rapid in the plane and along the tool axis, so that neither move passes through the part: away from
    /// it first, towards it last.
    pub fn rapid_over(&mut self, point: [f64; 2], z: f64) -> Result<(), T::Error> {
        if self.height(z, self.z()) > 0.0 {
            self.rapid_z(z)?;
            return self.rapid(point);
        }
        self.rapid(point)?;
        self.rapid_z(z)
    }

    /// Feed along the tool axis.
    pub fn feed_z(&mut self, z: f64) -> Result<(), T::Error> {
        let [a, b, _] = self.at;
        let feed = self.feed;
        self.put([a, b, z], |to| Act::Feed { to, feed })
    }

    /// Feed in the plane.
    pub fn feed(&mut self, point: [f64; 2]) -> Result<(), T::Error> {
        self.ramp(point, self.z())
    }

    /// Feed straight to a point on another level.
    pub fn ramp(&mut self, point: [f64; 2], z: f64) -> Result<(), T::Error> {
        let [a, b] = self.frame.world(point);
        let feed = self.feed;
        self.put([a, b, z], |to| Act::Feed { to, feed })
    }

    /// Arc in the plane about `center` to `end`, over `sweep` radians as seen in the frame, which does not
    /// close: one whose ends coincide has vanished.
    pub fn arc(&mut self, end: [f64; 2], center: [f64; 2], sweep: f64) -> Result<(), T::Error> {
        self.helix(end, center, sweep, self.z())
    }

    /// The same, ending on another level.
    pub fn helix(&mut self, end: [f64; 2], center: [f64; 2], sweep: f64, z: f64) -> Result<(), T::Error> {
        let [a, b] = self.frame.world(end);
        let center = self.frame.world(center);
        let sweep = sweep * self.frame.handedness();
        let feed = self.feed;
        self.put([a, b, z], |to| Act::Arc { to, center, sweep, feed })
    }

    /// A quarter circle to `end`, counter-clockwise in the frame.
    pub fn quarter(&mut self, end: [f64; 2], center: [f64; 2]) -> Result<(), T::Error> {
        self.arc(end, center, FRAC_PI_2)
    }

    /// A half circle to `end`, opposite on it; counter-clockwise in the frame for a positive `side`.
    pub fn half_circle(
        &mut self,
        end: [f64; 2],
        center: [f64; 2],
        side: f64,
        z: f64,
    ) -> Result<(), T::Error> {
        self.helix(end, center, PI.copysign(side), z)
    }

    /// Turns about `center` that end over the same point, so many, on the level `z`. None about the tool's
    /// own place, and none so small a part of a turn that it has vanished.
    pub fn turns(&mut self, center: [f64; 2], turns: f64, z: f64) -> Result<(), T::Error> {
        let [a, b, _] = self.at;
        let center = self.frame.world(center);
        let radius = (a - center[0]).hypot(b - center[1]);
        if radius.min(radius * turns.abs() * TAU) <= SAME_POINT_MM {
            return self.feed_z(z);
        }
        let act =
            Act::Arc { to: [a, b, z], center, sweep: turns * TAU * self.frame.handedness(), feed: self.feed };
        self.at = [a, b, z];
        self.taker.take(act)
    }

    /// Feed in step with the spindle.
    pub fn tap_z(&mut self, z: f64, pitch: f64, rpm: f64) -> Result<(), T::Error> {
        let [a, b, _] = self.at;
        self.put([a, b, z], |to| Act::Tap { to, pitch, rpm })
    }

    /// Waits; not at all for 0.
    pub fn dwell(&mut self, seconds: f64) -> Result<(), T::Error> {
        if seconds > 0.0 { self.taker.take(Act::Dwell(seconds)) } else { Ok(()) }
    }

    /// Does what is no move.
    pub fn act(&mut self, act: Act) -> Result<(), T::Error> {
        self.taker.take(act)
    }

    fn level(&self, point: [f64; 2]) -> [f64; 3] {
        let [a, b] = self.frame.world(point);
        [a, b, self.at[2]]
    }

    fn put(&mut self, to: [f64; 3], act: impl FnOnce([f64; 3]) -> Act) -> Result<(), T::Error> {
        let moves = to.iter().zip(self.at).any(|(to, at)| (to - at).abs() > SAME_POINT_MM);
        if !moves {
            return Ok(());
        }
        self.at = to;
        self.taker.take(act(to))
    }
}

/// Counts acts; more than can be meant are refused.
pub struct Count {
    left: u32,
}

impl Count {
    /// So many.
    pub fn of(most: u32) -> Count {
        Count { left: most }
    }
}

impl Take for Count {
    type Error = ();
    fn take(&mut self, _: Act) -> Result<(), ()> {
        self.left = self.left.checked_sub(1).ok_or(())?;
        Ok(())
    }
}
