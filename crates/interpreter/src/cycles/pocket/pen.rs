//! The tool centre over the pocket, in heights above the part surface.
//!
//! A pocket is cut away from the surface, towards minus or plus as the planes say (Fagor 4.1.2). Here heights
//! count from the surface against the depth, so that −3 is 3 mm deep in either case.

use super::segment::Segment;
use crate::cycles::milling::CycleMove;
use ferrocut_geometry::SAME_POINT_MM;
use ferrocut_geometry::vector::distance;
use std::f64::consts::PI;

/// At which feed a move of a pocket cuts.
#[derive(Clone, Copy, PartialEq, Eq, Debug)]
pub enum PocketFeed {
    /// Fz: downwards.
    Plunge,
    /// F: along.
    Mill,
}

/// Takes the moves of a pocket one by one; an error ends it there. The feed of a rapid has no meaning.
pub trait PocketSink {
    /// What the taker may refuse with.
    type Error;
    /// The next move; its arcs turn at most once.
    fn take(&mut self, step: CycleMove, feed: PocketFeed) -> Result<(), Self::Error>;
}

impl<E, F: FnMut(CycleMove, PocketFeed) -> Result<(), E>> PocketSink for F {
    type Error = E;
    fn take(&mut self, step: CycleMove, feed: PocketFeed) -> Result<(), E> {
        self(step, feed)
    }
}

/// Surface and safety plane, and which way is up.
#[derive(Clone, Copy, PartialEq, Debug)]
pub(crate) struct Planes {
    /// Part surface Z, mm.
    pub surface: f64,
    /// Height of the safety plane Zs above the surface, mm.
    pub safety: f64,
    /// +1 where depth goes towards minus, else −1.
    pub up: f64,
}

/// Height of the approach plane above the surface, and of every rapid above uncut material, mm (4.1.2).
pub(crate) const APPROACH: f64 = 1.0;

impl Planes {
    /// The planes and the depth, which is positive: the sign of P counts only where both planes are one
    /// (4.1.2).
    pub fn new(surface: f64, safety: f64, depth: f64) -> Planes {
        let up = match safety - surface {
            d if d > 0.0 => 1.0,
            d if d < 0.0 => -1.0,
            _ if depth < 0.0 => -1.0,
            _ => 1.0,
        };
        Planes { surface, safety: (safety - surface).abs(), up }
    }

    /// The height of the approach plane; with both planes in one there is none above it.
    pub fn approach(&self) -> f64 {
        APPROACH.min(self.safety.max(0.0))
    }
}

/// The tool tip, and where its moves go.
pub(crate) struct Pen<'a, S> {
    planes: Planes,
    at: [f64; 2],
    height: f64,
    sink: &'a mut S,
}

impl<'a, S: PocketSink> Pen<'a, S> {
    /// A tool that stands at a position: plane coordinates and the coordinate of the tool axis.
    pub fn new(planes: Planes, at: [f64; 3], sink: &'a mut S) -> Self {
        let [x, y, z] = at;
        Pen { planes, at: [x, y], height: (z - planes.surface) * planes.up, sink }
    }

    pub fn at(&self) -> [f64; 2] {
        self.at
    }

    pub fn planes(&self) -> Planes {
        self.planes
    }

    fn world(&self, [x, y]: [f64; 2], height: f64) -> [f64; 3] {
        [x, y, self.planes.surface + self.planes.up * height]
    }

    fn moves(&self, p: [f64; 2], height: f64) -> bool {
        distance(p, self.at) > SAME_POINT_MM || (height - self.height).abs() > SAME_POINT_MM
    }

    fn put(&mut self, p: [f64; 2], height: f64, step: CycleMove, feed: PocketFeed) -> Result<(), S::Error> {
        (self.at, self.height) = (p, height);
        self.sink.take(step, feed)
    }

    fn rapid_to(&mut self, p: [f64; 2], height: f64) -> Result<(), S::Error> {
        if !self.moves(p, height) {
            return Ok(());
        }
        let to = self.world(p, height);
        self.put(p, height, CycleMove::Rapid { to }, PocketFeed::Mill)
    }

    /// Rapid along the tool axis.
    pub fn rapid_height(&mut self, height: f64) -> Result<(), S::Error> {
        self.rapid_to(self.at, height)
    }

    /// Rapid in the plane.
    pub fn rapid(&mut self, p: [f64; 2]) -> Result<(), S::Error> {
        self.rapid_to(p, self.height)
    }

    /// Rapid over a point in the safety plane: from above it first in the plane, from below first to it
    /// (4.1.2).
    pub fn over(&mut self, p: [f64; 2]) -> Result<(), S::Error> {
        if self.height < self.planes.safety {
            self.rapid_height(self.planes.safety)?;
        }
        self.rapid(p)?;
        self.rapid_height(self.planes.safety)
    }

    /// Rapid to a point at a height: at that height where the way there is `clear`, else over the safety
    /// plane.
    pub fn travel(&mut self, p: [f64; 2], height: f64, clear: bool) -> Result<(), S::Error> {
        if clear {
            self.rapid_height(height)?;
            self.rapid(p)
        } else {
            self.over(p)?;
            self.rapid_height(height)
        }
    }

    /// Feed along the tool axis.
    pub fn plunge(&mut self, height: f64) -> Result<(), S::Error> {
        if !self.moves(self.at, height) {
            return Ok(());
        }
        let to = self.world(self.at, height);
        self.put(self.at, height, CycleMove::Feed { to }, PocketFeed::Plunge)
    }

    /// Along a segment, which begins where the tool is, to another height.
    pub fn along(&mut self, segment: &Segment, height: f64, feed: PocketFeed) -> Result<(), S::Error> {
        match *segment {
            Segment::Line { to, .. } => {
                if !self.moves(to, height) {
                    return Ok(());
                }
                let end = self.world(to, height);
                self.put(to, height, CycleMove::Feed { to: end }, feed)
            }
            Segment::Arc { to, center, sweep, .. } => {
                // One that does not go anywhere, and not once round either, has vanished.
                if !self.moves(to, height) && sweep.abs() < PI {
                    return Ok(());
                }
                let end = self.world(to, height);
                self.put(to, height, CycleMove::Arc { to: end, center, sweep }, feed)
            }
        }
    }

    /// Straight in the plane at a feed.
    pub fn feed(&mut self, to: [f64; 2]) -> Result<(), S::Error> {
        self.along(&Segment::Line { from: self.at, to }, self.height, PocketFeed::Mill)
    }

    /// Along a path on the present level.
    pub fn path(&mut self, path: &[Segment]) -> Result<(), S::Error> {
        path.iter().try_for_each(|segment| self.along(segment, self.height, PocketFeed::Mill))
    }

    /// Straight to a point at another height, at the milling feed.
    pub fn slope(&mut self, to: [f64; 2], height: f64) -> Result<(), S::Error> {
        self.along(&Segment::Line { from: self.at, to }, height, PocketFeed::Mill)
    }
}
