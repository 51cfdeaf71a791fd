//! The interference check (GSK990MC 4.7.3 point 10, NO41.6; alarm 41).
//!
//! A block interferes where its offset runs against it: the way from the last tip of the corner before to the
//! first tip of the corner after differs in direction by more than 90° from a line, or nothing is left of an
//! arc's sweep. As on Fanuc, such a pair of tips is left out, and the next pair is tried, until a pair runs the
//! right way; the last tip of a corner always stays. What two last tips cannot repair is an alarm. Where tips
//! were left out the tool goes straight from one to the other, also for an arc (point 12 d 3).
//!
//! Beyond Fanuc, a shortcut that would cut one of the three blocks is an alarm too.

use super::corner::Corner;
use super::offset::Element;
use super::{Fault, OverTurn, Rules, Shape};
use ferrocut_geometry::vector::{Point, along, angle, cross, distance, dot, sub, unit};
use std::f64::consts::TAU;

/// Offsets that shrink to nothing may run back by rounding, mm.
const BACK_MM: f64 = 1e-6;

/// A shortcut may come nearer than the radius by this, mm.
const SHORTCUT_CUT_MM: f64 = 5e-4;

/// A turn more than this beyond 2π is beyond a full turn, rad.
const OVER_TURN_RAD: f64 = 1e-9;

/// Checks block `b` between its corners and repairs them. True where the tool goes straight along it.
pub(super) fn check(
    a: Option<&Element>,
    b: &Element,
    c: &Element,
    before: &mut Corner,
    after: &mut Corner,
    rules: &Rules,
) -> Result<bool, Fault> {
    over_turn(b, before, after, rules)?;
    if !rules.interference || forward(b, before, after) {
        return Ok(false);
    }
    loop {
        let (left_out, right_out) = (before.drop_exit(), after.drop_entry());
        if !left_out && !right_out {
            return Err(Fault::Interference);
        }
        let (from, to) = (before.exit(), after.entry());
        if dot(sub(to, from), sub(b.to, b.from)) >= 0.0 {
            let clear = |e: &Element| way_to(from, to, e) >= b.radius - SHORTCUT_CUT_MM;
            let fine = a.is_none_or(clear) && clear(b) && clear(c);
            return if fine { Ok(true) } else { Err(Fault::Interference) };
        }
    }
}

/// What the corners leave of an arc's sweep, as a signed angle, rad.
pub(super) fn sweep_left(sweep: f64, before: &Corner, after: &Corner) -> f64 {
    sweep - sweep.signum() * (before.trim_after + after.trim_before)
}

fn forward(b: &Element, before: &Corner, after: &Corner) -> bool {
    let way = sub(after.entry(), before.exit());
    match b.shape {
        Shape::Line => dot(way, b.start) >= -BACK_MM,
        Shape::Arc { center, sweep } => {
            let left = sweep_left(sweep, before, after) * sweep.signum();
            left * distance(before.exit(), center) >= -BACK_MM
        }
    }
}

/// A change of side can lengthen an arc beyond a full turn (4.7.3 point 5 vi).
fn over_turn(b: &Element, before: &Corner, after: &mut Corner, rules: &Rules) -> Result<(), Fault> {
    if let Shape::Arc { sweep, .. } = b.shape {
        let over = sweep_left(sweep, before, after).abs() > TAU + OVER_TURN_RAD;
        if over && (before.crosses || after.crosses) && sweep.abs() <= TAU + OVER_TURN_RAD {
            match rules.over_turn {
                OverTurn::Fault => return Err(Fault::Interference),
                OverTurn::Shorten => after.trim_before += TAU,
            }
        }
    }
    Ok(())
}

/// Distance of the straight way from `p` to `q` from a programmed block, mm.
fn way_to(p: Point, q: Point, e: &Element) -> f64 {
    match e.shape {
        Shape::Line => segments(p, q, e.from, e.to),
        Shape::Arc { center, sweep } => segment_arc(p, q, e, center, sweep),
    }
}

fn point_segment(p: Point, a: Point, b: Point) -> f64 {
    let v = sub(b, a);
    let k = (dot(sub(p, a), v) / dot(v, v)).clamp(0.0, 1.0);
    distance(p, along(a, v, if k.is_nan() { 0.0 } else { k }))
}

fn segments(p: Point, q: Point, a: Point, b: Point) -> f64 {
    let (v, w) = (sub(q, p), sub(b, a));
    let apart = |x: Point, u: Point, y: Point, z: Point| cross(u, sub(y, x)) * cross(u, sub(z, x)) > 0.0;
    if !apart(p, v, a, b) && !apart(a, w, p, q) && cross(v, w) != 0.0 {
        return 0.0;
    }
    point_segment(p, a, b).min(point_segment(q, a, b)).min(point_segment(a, p, q)).min(point_segment(b, p, q))
}

/// The nearest points of a segment and an arc are ends of either, lie on the perpendicular from the centre to
/// the segment, or are crossings.
fn segment_arc(p: Point, q: Point, e: &Element, center: Point, sweep: f64) -> f64 {
    let radius = distance(e.from, center);
    let faces = |x: Point| {
        let a = sweep.signum() * angle(sub(e.from, center), sub(x, center));
        (if a < 0.0 { a + TAU } else { a }) <= sweep.abs()
    };
    let to_arc = |x: Point| {
        let ends = distance(x, e.from).min(distance(x, e.to));
        if faces(x) { ends.min((distance(x, center) - radius).abs()) } else { ends }
    };
    let ends = point_segment(e.from, p, q).min(point_segment(e.to, p, q)).min(to_arc(p)).min(to_arc(q));
    let Some(t) = unit(sub(q, p)) else { return ends };
    let (l, foot) = (distance(p, q), dot(sub(center, p), t));
    let off = cross(t, sub(center, p));
    let half = (radius * radius - off * off).max(0.0).sqrt();
    [foot, foot - half, foot + half]
        .into_iter()
        .filter(|k| (0.0..=l).contains(k))
        .map(|k| to_arc(along(p, t, k)))
        .fold(ends, f64::min)
}
