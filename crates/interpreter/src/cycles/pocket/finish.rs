//! Finishing a wall: onto it and off it without a mark.
//!
//! The path touches the wall with the tool's radius r. At a point w of it, with the heading t and the normal
//! n into the pocket, lies the centre c = w + ρn. Where c is r + ρ away from every wall the whole disc of
//! radius ρ about it is free, and quarter circles in it lead onto the path and off again:
//!
//! ```text
//!            c − ρt ─╮   c   ╭─ c + ρt
//!                    ╰── w ──╯              ── path ▶ ──
//!        wall  ────────────────────────────────────────────
//! ```
//!
//! The tool comes down over c, where the floor has been cleared. The middle of a straight piece is tried
//! first, then joints without a corner, so that arcs of the path are not broken.

use super::descent::{Descent, Slope};
use super::pen::{APPROACH, Pen, PocketFeed, PocketSink};
use super::problem::Problem;
use super::ring::{Place, Ring};
use super::segment::Segment;
use super::walls::Walls;
use crate::cycles::depth::Levels;
use ferrocut_geometry::vector::{along, dot, left};
use std::f64::consts::FRAC_PI_2;

/// Once round a wall.
#[derive(Clone, PartialEq, Debug)]
pub(crate) struct Finish {
    /// The way on and off; without room for one the tool goes down on the path.
    pub tangent: Option<Tangent>,
    /// The path, back to where it begins.
    pub path: Vec<Segment>,
}

/// The ways onto a path and off it.
#[derive(Clone, Copy, PartialEq, Debug)]
pub(crate) struct Tangent {
    /// Where the tool comes down.
    pub center: [f64; 2],
    /// Quarter circle onto the path.
    pub on: Segment,
    /// Quarter circle off the path.
    pub off: Segment,
}

/// Places tried on one ring.
const TRIED: usize = 48;

/// The paths along walls, which still have `stock` on them: there the tool may come down.
pub(crate) fn finishes(
    walls: &Walls,
    clockwise: bool,
    radius: f64,
    stock: f64,
) -> Result<Vec<Finish>, Problem> {
    finishes_in(walls, clockwise, radius, 0.0, stock, &|_| true)
}

/// The paths that leave `leaves` on the walls, which still have `stock` more on them, where the tool may come
/// down on points that are `open`.
pub(crate) fn finishes_in(
    walls: &Walls,
    clockwise: bool,
    radius: f64,
    leaves: f64,
    stock: f64,
    open: &dyn Fn([f64; 2]) -> bool,
) -> Result<Vec<Finish>, Problem> {
    let nearest = radius + leaves;
    let rings = walls.paths(nearest)?;
    let finish = |ring: Ring| {
        let ring = if clockwise { ring.reversed() } else { ring };
        let side = if clockwise { -1.0 } else { 1.0 };
        let room = Room { walls, nearest, side, open };
        let (place, tangent) = begin(&room, &ring, radius, stock);
        Finish { tangent, path: ring.once_round(place) }
    };
    Ok(rings.into_iter().map(finish).collect())
}

/// What a way onto a path must keep to.
struct Room<'a> {
    walls: &'a Walls,
    nearest: f64,
    side: f64,
    open: &'a dyn Fn([f64; 2]) -> bool,
}

fn begin(room: &Room<'_>, ring: &Ring, radius: f64, stock: f64) -> (Place, Option<Tangent>) {
    let side = room.side;
    let places = places(ring);
    let sizes = [radius.max(1.1 * stock), radius / 2.0, radius / 4.0, radius / 8.0];
    for size in sizes.into_iter().filter(|size| *size >= stock) {
        for place in &places {
            let (w, heading) = (ring.point(*place), heading(ring, *place));
            let center = along(w, left(heading), side * size);
            if room.walls.distance(center) >= room.nearest + size - 1e-3 && (room.open)(center) {
                let ends = [along(center, heading, -size), along(center, heading, size)];
                let quarter = FRAC_PI_2 * side;
                let tangent = Tangent {
                    center,
                    on: Segment::arc(ends[0], w, quarter),
                    off: Segment::arc(w, ends[1], quarter),
                };
                return (*place, Some(tangent));
            }
        }
    }
    (ring.middle(), None)
}

fn heading(ring: &Ring, at: Place) -> [f64; 2] {
    ring.segments.get(at.segment).map_or([1.0, 0.0], |s| s.direction(at.t))
}

/// Where a path may begin: middles of straight pieces, smooth joints, middles of arcs; long ones first.
fn places(ring: &Ring) -> Vec<Place> {
    let mut found: Vec<(u32, f64, Place)> = Vec::new();
    let before = ring.segments.iter().cycle().skip(ring.segments.len().saturating_sub(1));
    for (segment, (own, before)) in ring.segments.iter().zip(before).enumerate() {
        let kind = if matches!(own, Segment::Line { .. }) { 0 } else { 2 };
        found.push((kind, -own.length(), Place { segment, t: 0.5 }));
        if dot(before.direction(1.0), own.direction(0.0)) > 1.0 - 1e-9 {
            found.push((1, -own.length().min(before.length()), Place { segment, t: 0.0 }));
        }
    }
    found.sort_by(|a, b| (a.0, a.1).partial_cmp(&(b.0, b.1)).unwrap_or(std::cmp::Ordering::Equal));
    let mut places = Vec::new();
    for kind in 0..3 {
        places.extend(found.iter().filter(|f| f.0 == kind).take(TRIED / 3).map(|f| f.2));
    }
    places
}

impl Finish {
    /// Moves that it takes on all levels.
    pub fn moves(&self, levels: Levels, height: f64, slope: Slope) -> f64 {
        let down = match self.tangent {
            Some(_) => 4.0,
            None => Descent::new(&self.path, height, slope).moves(),
        };
        levels.count() * (self.path.len() as f64 + down + 4.0)
    }

    /// Finishes the wall level by level. `cleared` is the distance from the walls from which on the tool
    /// may stand at any depth.
    pub fn cut<S: PocketSink>(
        &self,
        pen: &mut Pen<'_, S>,
        walls: &Walls,
        levels: Levels,
        slope: Slope,
        cleared: f64,
    ) -> Result<(), S::Error> {
        let approach = pen.planes().approach();
        let Some(tangent) = self.tangent else { return self.cut_from_above(pen, levels, slope) };
        let clear = walls.is_clear(pen.at(), tangent.center, cleared);
        pen.travel(tangent.center, approach, clear)?;
        for depth in levels.depths() {
            self.round(pen, &tangent, -depth)?;
        }
        pen.rapid_height(approach)
    }

    /// Goes round on one level, from anywhere to the approach plane.
    pub fn cut_level<S: PocketSink>(
        &self,
        pen: &mut Pen<'_, S>,
        height: f64,
        slope: Slope,
    ) -> Result<(), S::Error> {
        let approach = pen.planes().approach();
        match self.tangent {
            Some(tangent) => {
                pen.travel(tangent.center, approach, false)?;
                self.round(pen, &tangent, height)?;
            }
            None => {
                let descent = Descent::new(&self.path, approach - height, slope);
                pen.travel(descent.start(), approach, false)?;
                descent.go(pen, approach, height)?;
                pen.path(&self.path)?;
            }
        }
        pen.rapid_height(approach)
    }

    /// Moves of one level at most.
    pub fn level_moves(&self, height: f64, slope: Slope) -> f64 {
        12.0 + self.path.len() as f64 + Descent::new(&self.path, height, slope).moves()
    }

    /// Down over the centre, on, round, off.
    fn round<S: PocketSink>(
        &self,
        pen: &mut Pen<'_, S>,
        tangent: &Tangent,
        height: f64,
    ) -> Result<(), S::Error> {
        pen.rapid_height((height + APPROACH).min(pen.planes().approach()))?;
        pen.plunge(height)?;
        pen.feed(tangent.on.from())?;
        pen.along(&tangent.on, height, PocketFeed::Mill)?;
        pen.path(&self.path)?;
        pen.along(&tangent.off, height, PocketFeed::Mill)?;
        pen.feed(tangent.center)
    }

    /// Where nothing is cleared beside the wall: down along it under the entry angle.
    fn cut_from_above<S: PocketSink>(
        &self,
        pen: &mut Pen<'_, S>,
        levels: Levels,
        slope: Slope,
    ) -> Result<(), S::Error> {
        let approach = pen.planes().approach();
        let mut open = approach;
        for depth in levels.depths() {
            let descent = Descent::new(&self.path, open + depth, slope);
            pen.travel(descent.start(), open, false)?;
            descent.go(pen, open, -depth)?;
            pen.path(&self.path)?;
            open = (APPROACH - depth).min(approach);
        }
        pen.rapid_height(approach)
    }
}
