//! The walls of a pocket, and the paths at a distance from them.
//!
//! The path at the distance d is the set of points of the pocket whose nearest wall is d away: parallel
//! lines, arcs about the centres of the walls' arcs, and arcs of radius d about outer corners. A tool centre
//! on it touches the wall with radius d and gouges nothing.
//!
//! **Only walls as drawn are offset, never a path**: the path at k·s is computed from the walls at the
//! distance k·s, and not from the one before it, whose joints differ from exact ones by rounding that no
//! drawing has.
//!
//! **No computed path is trusted.** Drawings in round numbers make walls whose offsets touch without
//! crossing, and one in a thousand comes out wrong. Each result is judged by distances alone:
//!
//! ```text
//! keeps off    every segment, exactly:   min |p − wall| ≥ d − ε
//! keeps to     ends and three points:        |p − wall| ≤ d + ε
//! is whole     points d beside each wall that have no nearer wall lie on some path
//! ```
//!
//! What does not pass is tried again at d + 1.3 µm and d − 1.7 µm, where nothing touches any more, and then
//! made of straight pieces with chords of a micrometre.

use super::index::{Piece, envelope, index};
use super::meet::closest;
use super::polygons;
use super::problem::Problem;
use super::profile::Profile;
use super::ring::Ring;
use super::segment::{Bounds, Segment};
use cavalier_contours::polyline::{PlineCreation, PlineSource, PlineSourceMut, Polyline};
use cavalier_contours::shape_algorithms::{Shape, ShapeOffsetOptions};
use ferrocut_geometry::vector::{along, cross, distance, left, sub, unit};
use rstar::RTree;
use std::f64::consts::PI;
use std::panic::{AssertUnwindSafe, catch_unwind};

/// ε of the module documentation, mm: the ends of a path are exact to 0.1 µm.
const KEPT: f64 = 0.5e-3;

/// Changes of distance at which a path is tried again, mm.
const SHIFTS: [f64; 3] = [0.0, 1.3e-3, -1.7e-3];

/// ε for a path of straight pieces, mm: chords of the wall and of the path.
const KEPT_BY_CHORDS: f64 = 2.2e-3;

/// Walls that enclose a pocket, exact and judged.
#[derive(Debug)]
pub(crate) struct Walls {
    /// Outer wall counter-clockwise, islands clockwise: the pocket on the left.
    pub contours: Vec<Profile>,
    pub bounds: Bounds,
    tree: RTree<Piece>,
    shape: Shape<f64>,
}

impl Walls {
    /// The outer wall and the islands in it, none touching another.
    pub fn new<'a>(outer: impl IntoIterator<Item = &'a Profile>, islands: &[Profile]) -> Walls {
        let turned = |profile: &Profile, ccw: bool| {
            if (profile.area() > 0.0) == ccw { profile.clone() } else { profile.reversed() }
        };
        let mut contours: Vec<Profile> = outer.into_iter().map(|o| turned(o, true)).collect();
        contours.extend(islands.iter().map(|i| turned(i, false)));
        let mut bounds = Bounds::NONE;
        for contour in &contours {
            let own = contour.bounds();
            bounds.take(own.low);
            bounds.take(own.high);
        }
        let tree = index(contours.iter().flat_map(|c| &c.segments));
        let shape = Shape::from_plines(contours.iter().map(|c| polyline(&c.segments)));
        Walls { contours, bounds, tree, shape }
    }

    /// Distance of a point from the nearest wall, mm.
    pub fn distance(&self, p: [f64; 2]) -> f64 {
        self.tree.nearest_neighbor(p).map_or(f64::INFINITY, |piece| piece.segment.distance(p))
    }

    /// Whether some wall is nearer than that.
    fn is_within(&self, p: [f64; 2], d: f64) -> bool {
        self.tree.locate_within_distance(p, d * d).next().is_some()
    }

    /// The nearest point of the walls.
    pub fn foot(&self, p: [f64; 2]) -> [f64; 2] {
        self.tree.nearest_neighbor(p).map_or(p, |piece| piece.segment.foot(p))
    }

    /// The paths at a distance from the walls.
    pub fn paths(&self, d: f64) -> Result<Vec<Ring>, Problem> {
        for shift in SHIFTS {
            let rings = self.offset(d + shift);
            if self.judge(&rings, d + shift, KEPT) && self.is_whole(&rings, d + shift) {
                return Ok(rings);
            }
        }
        let rings = polygons::paths(&self.contours, d);
        if self.judge(&rings, d, KEPT_BY_CHORDS) { Ok(rings) } else { Err(Problem::NoPath) }
    }

    /// Whether a point lies in the pocket, that far from every wall.
    pub fn has(&self, p: [f64; 2], d: f64) -> bool {
        self.distance(p) >= d - KEPT
            && self
                .contours
                .iter()
                .map(|c| c.segments.iter().map(|s| s.seen_from(p)).sum::<f64>())
                .sum::<f64>()
                > PI
    }

    /// Whether there is any room at that distance.
    pub fn has_room(&self, d: f64) -> bool {
        2.0 * d < self.bounds.width() + 1e-3 && !self.offset(d).is_empty()
    }

    /// Whether the straight way between two points keeps the distance `d` from the walls.
    pub fn is_clear(&self, from: [f64; 2], to: [f64; 2], d: f64) -> bool {
        /// More steps than this is a way along a wall, for which nothing is promised.
        const STEPS: u32 = 200;
        let Some(direction) = unit(sub(to, from)) else { return self.distance(from) >= d - KEPT };
        let whole = distance(from, to);
        let mut gone = 0.0;
        // From a point that is c clear, c further on nothing can be in the way.
        for _ in 0..STEPS {
            let clear = self.distance(along(from, direction, gone)) - d;
            if clear < -KEPT_BY_CHORDS {
                return false;
            }
            gone += clear.max(0.01);
            if gone >= whole {
                return self.distance(to) >= d - KEPT_BY_CHORDS;
            }
        }
        false
    }

    pub(super) fn offset(&self, d: f64) -> Vec<Ring> {
        // The library checks its own working with assertions; one that fails is a path that is missing, and
        // judged as that.
        let offset = || self.shape.parallel_offset(d, &ShapeOffsetOptions::default());
        let Ok(shape) = catch_unwind(AssertUnwindSafe(offset)) else { return Vec::new() };
        let loops = shape.ccw_plines.iter().chain(&shape.cw_plines);
        loops.filter_map(|l| Ring::new(segments(&l.polyline))).collect()
    }

    /// Whether paths keep off the walls by `d` and stay there.
    pub(super) fn judge(&self, rings: &[Ring], d: f64, slack: f64) -> bool {
        rings.iter().flat_map(|r| &r.segments).all(|s| {
            let near = envelope(s.bounds().grown(d));
            let mut walls = self.tree.locate_in_envelope_intersecting(near);
            [0.0, 0.25, 0.5, 0.75].iter().all(|t| self.is_within(s.point(*t), d + slack))
                && walls.all(|wall| closest(s, &wall.segment).0 >= d - slack)
        })
    }

    /// Whether no path is missing: points beside a wall that are nearest to it must lie on one.
    pub(super) fn is_whole(&self, rings: &[Ring], d: f64) -> bool {
        let paths = index(rings.iter().flat_map(|r| &r.segments));
        let lies_on_one = |p: [f64; 2]| {
            self.is_within(p, d - KEPT)
                || paths.nearest_neighbor(p).is_some_and(|piece| piece.segment.distance(p) < 4.0 * KEPT)
        };
        self.contours.iter().all(|contour| {
            let before = contour.segments.iter().cycle().skip(contour.segments.len().saturating_sub(1));
            before.zip(&contour.segments).all(|(before, s)| {
                let (heading, d0) = (before.direction(1.0), s.direction(0.0));
                // About an outer corner the path is an arc.
                let about = unit([heading[1] + d0[1], -heading[0] - d0[0]]);
                let corner =
                    cross(heading, d0) >= -1e-9 || about.is_none_or(|n| lies_on_one(along(s.from(), n, -d)));
                corner
                    && [0.2, 0.5, 0.8]
                        .iter()
                        .all(|t| lies_on_one(along(s.point(*t), left(s.direction(*t)), d)))
            })
        })
    }
}

/// A chain for the offsetting library, in which an arc turns half a circle at most.
fn polyline(chain: &[Segment]) -> Polyline<f64> {
    let mut line = Polyline::with_capacity(chain.len() + 1, true);
    for segment in chain {
        match *segment {
            Segment::Line { from, .. } => line.add(from[0], from[1], 0.0),
            Segment::Arc { sweep, .. } => {
                let pieces = if sweep.abs() <= PI { 1.0 } else { 2.0 };
                let mut at = 0.0;
                while at < pieces {
                    let [x, y] = segment.point(at / pieces);
                    line.add(x, y, (sweep / pieces / 4.0).tan());
                    at += 1.0;
                }
            }
        }
    }
    line
}

fn segments(line: &Polyline<f64>) -> Vec<Segment> {
    let vertices: Vec<_> = line.iter_vertexes().collect();
    let next = vertices.iter().cycle().skip(1);
    let segment = |(a, b): (&cavalier_contours::polyline::PlineVertex<f64>, _)| {
        let b: &cavalier_contours::polyline::PlineVertex<f64> = b;
        let (from, to) = ([a.x, a.y], [b.x, b.y]);
        if a.bulge.abs() < 1e-12 || distance(from, to) < 1e-12 {
            Segment::Line { from, to }
        } else {
            Segment::arc(from, to, 4.0 * a.bulge.atan())
        }
    };
    vertices.iter().zip(next).map(segment).collect()
}
