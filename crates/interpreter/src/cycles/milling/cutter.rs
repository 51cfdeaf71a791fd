//! Drawing with the tool centre in a frame that turns and mirrors.
//!
//! Every shape is written once: counter-clockwise, about the origin, beginning on the +u side. A
//! clockwise cycle is the same shape seen in a mirrored frame, one with its long side in Y the same in
//! a frame turned by a quarter.

use crate::cycles::tool::{Frame, Take};
use ferrocut_geometry::SAME_POINT_MM;
use std::f64::consts::{PI, TAU};

/// One move of a cycle, from where the last one ended. Programmed X, Y, Z, mm, of the tool centre.
#[derive(Clone, Copy, PartialEq, Debug)]
pub enum CycleMove {
    /// At rapid, along one axis or within the XY plane.
    Rapid {
        /// End point.
        to: [f64; 3],
    },
    /// Straight at the programmed feed.
    Feed {
        /// End point.
        to: [f64; 3],
    },
    /// Circular at the programmed feed in the XY plane; a helix where Z changes.
    Arc {
        /// End point.
        to: [f64; 3],
        /// Centre in X and Y.
        center: [f64; 2],
        /// Angle turned, radians, counter-clockwise positive; never more than one turn.
        sweep: f64,
    },
}

/// The tool centre, and where its moves go.
pub struct Cutter<'a, S> {
    frame: Frame,
    at: [f64; 3],
    sink: &'a mut S,
}

impl<'a, S: Take<CycleMove>> Cutter<'a, S> {
    /// A cutter over the local point `at`, at the level `z`.
    pub fn new(frame: Frame, at: [f64; 2], z: f64, sink: &'a mut S) -> Self {
        let [x, y] = frame.world(at);
        Cutter { frame, at: [x, y, z], sink }
    }

    /// The level of the tool tip.
    pub fn z(&self) -> f64 {
        self.at[2]
    }

    /// Draws in the frame turned by some quarters; the origin stays where it is.
    pub fn turned(
        &mut self,
        quarters: u32,
        draw: impl FnOnce(&mut Self) -> Result<(), S::Error>,
    ) -> Result<(), S::Error> {
        let frame = self.frame;
        self.frame = (0..quarters).fold(frame, |turned, _| turned.quarter_turned());
        let result = draw(self);
        self.frame = frame;
        result
    }

    /// Rapid along Z. A rapid to where the tool is already is left out, here and below.
    pub fn rapid_z(&mut self, z: f64) -> Result<(), S::Error> {
        let [x, y, _] = self.at;
        self.put([x, y, z], |to| CycleMove::Rapid { to })
    }

    /// Rapid in the plane.
    pub fn rapid(&mut self, point: [f64; 2]) -> Result<(), S::Error> {
        let to = self.level(point);
        self.put(to, |to| CycleMove::Rapid { to })
    }

    /// Feed along Z.
    pub fn feed_z(&mut self, z: f64) -> Result<(), S::Error> {
        let [x, y, _] = self.at;
        self.put([x, y, z], |to| CycleMove::Feed { to })
    }

    /// Feed in the plane.
    pub fn feed(&mut self, point: [f64; 2]) -> Result<(), S::Error> {
        let to = self.level(point);
        self.put(to, |to| CycleMove::Feed { to })
    }

    /// Arc in the plane about `center` to `end`, over `sweep` radians as seen in the frame. For arcs
    /// that do not close: one whose ends coincide has vanished.
    pub fn arc(&mut self, end: [f64; 2], center: [f64; 2], sweep: f64) -> Result<(), S::Error> {
        let to = self.level(end);
        let center = self.frame.world(center);
        let sweep = sweep * self.frame.handedness();
        self.put(to, |to| CycleMove::Arc { to, center, sweep })
    }

    /// Half circle in the plane to `end`, opposite on the circle.
    pub fn half_circle(&mut self, end: [f64; 2], center: [f64; 2], side: f64) -> Result<(), S::Error> {
        self.arc(end, center, PI.copysign(side))
    }

    /// One whole turn about `center`, ending over the same point at the level `z`. A level turn on the
    /// centre itself is left out.
    pub fn turn(&mut self, center: [f64; 2], z: f64) -> Result<(), S::Error> {
        let [x, y, _] = self.at;
        let (to, center) = ([x, y, z], self.frame.world(center));
        let [cx, cy] = center;
        if (x - cx).hypot(y - cy) <= SAME_POINT_MM && (z - self.at[2]).abs() <= SAME_POINT_MM {
            return Ok(());
        }
        self.at = to;
        self.sink.take(CycleMove::Arc { to, center, sweep: TAU * self.frame.handedness() })
    }

    fn level(&self, point: [f64; 2]) -> [f64; 3] {
        let [x, y] = self.frame.world(point);
        [x, y, self.at[2]]
    }

    fn put(&mut self, to: [f64; 3], step: impl FnOnce([f64; 3]) -> CycleMove) -> Result<(), S::Error> {
        let [dx, dy, dz] = [to[0] - self.at[0], to[1] - self.at[1], to[2] - self.at[2]];
        if dx.abs() <= SAME_POINT_MM && dy.abs() <= SAME_POINT_MM && dz.abs() <= SAME_POINT_MM {
            return Ok(());
        }
        self.at = to;
        self.sink.take(step(to))
    }
}
