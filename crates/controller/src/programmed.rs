//! What the program says of a move: its line or arc, its feed, how far the path may leave it. For those who
//! compare motion with it.

use ferrocut_geometry::{Arc, Axis, Position, SAME_POINT_MM};
use ferrocut_toolpath::{Op, PathMode};
use std::f64::consts::TAU;

/// A move as it was programmed.
#[derive(Clone, Copy, PartialEq, Debug)]
pub struct Programmed {
    /// Counts up from move to move.
    pub number: u64,
    /// Along what it goes.
    pub way: Way,
    /// Whether it is positioning, which has limits of its own.
    pub is_rapid: bool,
    /// Speed along the path, mm/s; positioning has none unless the program gives one.
    pub feed: Option<f64>,
    /// How far the path may leave this move at its end, mm, where the program says so.
    pub tolerance: Option<f64>,
}

/// What a move goes along.
#[derive(Clone, Copy, PartialEq, Debug)]
pub enum Way {
    /// From one point to the other, every axis as fast as it can: no line is programmed.
    Apart,
    /// A straight line.
    Line(Position, Position),
    /// A circle or helix.
    Arc(Arc),
}

impl Programmed {
    /// The move that `op` makes from `from`, with the feed that motion was given for it; `None` where it is none.
    pub fn new(op: &Op, from: Position, feed: Option<f64>, number: u64) -> Option<Programmed> {
        let to = *op.target()?;
        let way = match *op {
            Op::Rapid { straight: false, .. } => Way::Apart,
            Op::Arc { .. } => Way::Arc(op.arc(from)?),
            _ => Way::Line(from, to),
        };
        let tolerance = match op.path() {
            Some(PathMode::ContinuousWithin(most)) => Some(most),
            Some(PathMode::WithinBlock(most)) => most,
            _ => None,
        };
        Some(Programmed { number, way, is_rapid: matches!(op, Op::Rapid { .. }), feed, tolerance })
    }

    /// The share of the move behind `point`, which is on it, where `travelled` mm were run of `length`.
    pub fn left(&self, point: Position, travelled: f64, length: f64) -> f64 {
        let Way::Arc(arc) = &self.way else { return 1.0 };
        let Some(share) = share_of(arc, point) else { return 1.0 };
        let run = if length > 0.0 { (travelled / length).clamp(0.0, 1.0) } else { 0.0 };
        // A point at the seam of a full circle, or before its start by a rounding, may be either end.
        let turn = TAU / arc.sweep.abs();
        let share = share - ((share - run) / turn).round() * turn;
        (1.0 - share).clamp(0.0, 1.0)
    }

    /// How far `point` lies from the move, over the linear axes, mm; `None` where no line is programmed.
    pub fn distance(&self, point: Position) -> Option<f64> {
        match &self.way {
            Way::Apart => None,
            Way::Line(from, to) => {
                let way = *to - *from;
                let square = dot(way, way);
                let t = if square > 0.0 { dot(point - *from, way) / square } else { 0.0 };
                Some(gap(point, from.lerp(*to, t.clamp(0.0, 1.0))))
            }
            Way::Arc(arc) => Some(arc_distance(arc, point)),
        }
    }
}

/// Product over the linear axes; degrees are no distance.
fn dot(a: Position, b: Position) -> f64 {
    Axis::ALL.into_iter().filter(|axis| axis.is_linear()).map(|axis| a[axis] * b[axis]).sum()
}

fn gap(a: Position, b: Position) -> f64 {
    dot(a - b, a - b).sqrt()
}

/// Steps from the point in the same direction to the nearest one: each leaves a share of about the square of
/// the climb, and of a circle there is nothing to leave.
const REFINEMENTS: usize = 4;

fn arc_distance(arc: &Arc, point: Position) -> f64 {
    let ends = gap(point, arc.start).min(gap(point, arc.end));
    match share_of(arc, point) {
        Some(share) => ends.min(refined(arc, point, share)),
        None => ends,
    }
}

/// The share of an arc that lies before the place of it that is in the direction of `point`.
fn share_of(arc: &Arc, point: Position) -> Option<f64> {
    let turned = arc.sweep.abs();
    if turned <= 0.0 {
        return None;
    }
    let [a, b] = arc.plane.of(point);
    let (a, b) = (a - arc.center[0], b - arc.center[1]);
    // What was turned from the start, in the sense of the arc and within the first turn.
    let first = ((b.atan2(a) - arc.start_angle()) * arc.sweep.signum()).rem_euclid(TAU);
    let normal = arc.plane.normal();
    let (climb, growth) = (arc.end[normal] - arc.start[normal], arc.end_radius() - arc.start_radius());
    // The turn, by what changes from one to the next: the height of a helix, else the radius of a spiral.
    let progress = if climb.abs() > SAME_POINT_MM {
        (point[normal] - arc.start[normal]) / climb
    } else if growth.abs() > SAME_POINT_MM {
        (a.hypot(b) - arc.start_radius()) / growth
    } else {
        0.0
    };
    // No turn more than the arc has in that direction: a radius that ends a little off its start says nothing beside a blend.
    let most = ((turned - first) / TAU).floor().max(0.0);
    let turn = ((progress.clamp(0.0, 1.0) * turned - first) / TAU).round().clamp(0.0, most);
    Some((first + turn * TAU) / turned)
}

/// Parts of an arc closer than this are the same place.
const SAME_PLACE: f64 = 1e-12;

/// Distance of `point` from the place of the arc that is nearest to it, beginning at `t`.
fn refined(arc: &Arc, point: Position, t: f64) -> f64 {
    let mut t = t.clamp(0.0, 1.0);
    for _ in 0..REFINEMENTS {
        let growth = arc.end_radius() - arc.start_radius();
        let radius = arc.start_radius() + growth * t;
        let (sin, cos) = (arc.start_angle() + arc.sweep * t).sin_cos();
        let mut along = arc.end - arc.start;
        along[arc.plane.first()] = growth * cos - radius * arc.sweep * sin;
        along[arc.plane.second()] = growth * sin + radius * arc.sweep * cos;
        let square = dot(along, along);
        if square <= 0.0 {
            break;
        }
        let before = t;
        t = (t + dot(point - arc.at(t), along) / square).clamp(0.0, 1.0);
        // A circle is there at once.
        if (t - before).abs() < SAME_PLACE {
            break;
        }
    }
    gap(point, arc.at(t))
}

#[cfg(test)]
mod tests {
    use super::*;
    use ferrocut_geometry::{Plane, Turn};

    fn away(way: Way, x: f64, y: f64, z: f64) -> f64 {
        let programmed = Programmed { number: 1, way, is_rapid: false, feed: None, tolerance: None };
        programmed.distance(Position::xyz(x, y, z)).unwrap()
    }

    #[test]
    fn a_line_is_left_sideways_and_beyond_its_ends() {
        let line = Way::Line(Position::xyz(0.0, 0.0, 0.0), Position::xyz(10.0, 0.0, 0.0));
        for (x, y, z, far) in [(5.0, 3.0, 4.0, 5.0), (13.0, 4.0, 0.0, 5.0), (-3.0, 0.0, 4.0, 5.0)] {
            assert_eq!(away(line, x, y, z), far);
        }
        let nowhere = Way::Line(Position::default(), Position::default());
        assert_eq!(away(nowhere, 3.0, 4.0, 0.0), 5.0);
    }

    #[test]
    fn a_quarter_of_a_circle_ends_where_it_ends() {
        // From (10, 0) about the origin to (0, 10).
        let (from, to) = (Position::xyz(10.0, 0.0, 0.0), Position::xyz(0.0, 10.0, 0.0));
        let arc = Way::Arc(Arc::about(Plane::Xy, from, to, [0.0; 2], Turn::CounterClockwise));
        // 3-4-5: radius 15 and 5 on the arc; (6, −8) is not on it, and 8.944 = √(4² + 8²) from its start.
        for (x, y, far) in [(9.0, 12.0, 5.0), (3.0, 4.0, 5.0), (6.0, -8.0, 80.0_f64.sqrt())] {
            assert!((away(arc, x, y, 0.0) - far).abs() < 1e-12, "{x} {y}");
        }
    }

    #[test]
    fn a_blend_beside_an_arc_of_rounded_numbers_is_near_it() {
        // Nearly a turn about (10, −0.5): the end is 1e-3 off its circle.
        let (from, to) = (Position::xyz(10.0, 0.0, 0.0), Position::xyz(9.97, 0.0, 0.0));
        let arc = Arc::about(Plane::Xy, from, to, [10.0, -0.5], Turn::Clockwise);
        for degrees in (0..350).step_by(7) {
            let (sin, cos) = f64::from(degrees).to_radians().sin_cos();
            for off in [-0.02, 0.015] {
                let (x, y) = (10.0 + (0.5 + off) * sin, -0.5 + (0.5 + off) * cos);
                let far = away(Way::Arc(arc), x, y, 0.0);
                assert!((far - off.abs()).abs() < 1.1e-3, "{degrees} {off}: {far}");
            }
        }
    }

    #[test]
    fn the_turn_of_a_helix_is_found_by_its_height() {
        // Ten turns of radius 5, 1 mm a turn: after four turns and a half it is at (−5, 0, 4.5).
        let arc = Arc {
            plane: Plane::Xy,
            center: [0.0; 2],
            start: Position::xyz(5.0, 0.0, 0.0),
            end: Position::xyz(5.0, 0.0, 10.0),
            sweep: 10.0 * TAU,
        };
        assert!(away(Way::Arc(arc), -5.0, 0.0, 4.5) < 1e-9);
        assert!((away(Way::Arc(arc), -5.1, 0.0, 4.5) - 0.1).abs() < 1e-9);
        // 0.1 above: nearer by the cosine of the climb of 1 mm on 10π mm, less what the curve bends: 1e-5.
        let cosine = 1.0 / (1.0 + (1.0 / (10.0 * std::f64::consts::PI)).powi(2)).sqrt();
        assert!((away(Way::Arc(arc), -5.0, 0.0, 4.6) - 0.1 * cosine).abs() < 1e-5);
    }
}
