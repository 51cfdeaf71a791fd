//! Arcs instead of a smooth curve, within a tolerance.
//!
//! In: points of the curve in order with its directions there, so close that the curve leaves the chord
//! between two of them by `c` at most (whoever makes them sees to that, as [`spline`](crate::spline) does). Out: arcs and lines from the first point to the last.
//!
//! # The arcs
//!
//! Between two of the points, `p₀` with the direction `t₀` and `p₁` with `t₁` (unit vectors), stands a
//! biarc: two arcs that begin and end in these directions and meet without a corner. With
//! `v = p₁ − p₀` and arms of equal length `d` the joint is
//!
//! ```text
//! pₘ = (p₀ + p₁ + d (t₀ − t₁)) / 2        v·v = 2 d v·(t₀ + t₁) + 2 d² (1 − t₀·t₁)
//! ```
//!
//! It reaches as many points ahead as the tolerance allows: the reach is doubled until a biarc fails and
//! then halved in (about `2 log₂ n` trials for `n` points).
//!
//! # The bound
//!
//! A biarc is taken only if the chords that it replaces stay within `room` of it, checked exactly:
//!
//! - The chords are divided where they cross the line through `pₘ` square to the path; that crossing
//!   belongs to both sides.
//! - On each side every corner lies within the sector of the arc, in rising order of the angle about the
//!   centre (the arc turns less than 180°). So the ray from the centre through any point of the chords
//!   meets the arc once, and the other way round.
//! - The distance from the centre is convex along a chord: it is largest at a corner and smallest at the
//!   foot of the perpendicular or at a corner. All of these must lie between `r − room` and `r + room`.
//!
//! Hence every point of the chords is within `room` of the arc and every point of the arc within `room`
//! of the chords, and arcs and curve are nowhere further apart than `room + c`. Where even a biarc
//! between neighbouring points fails (a cusp, a direction that is not known), the chord itself is
//! taken, which is within `c`.

use crate::curve::{Bend, Curve};
use crate::vector::{Point, cross, distance, dot, sub};

/// A point of a smooth curve.
#[derive(Clone, Copy, PartialEq, Debug)]
pub struct Sample {
    /// Where, mm.
    pub at: Point,
    /// Unit vector of the direction there; 0 where there is none.
    pub along: Point,
}

/// An arc of a biarc turns less than this, radians: a little under half a turn.
const MOST_SWEEP: f64 = 3.0;

/// Chords that leave a straight line by no more than this are that line, mm: what the finest
/// increment of the controls could not show.
const STRAIGHT: f64 = 1e-4;

/// Angles about a centre may fall back by this much from rounding, mm² of a cross product a mm.
const ROUNDING: f64 = 1e-9;

/// Gives lines and arcs through `samples` to `out`, within `room` of the chords between them.
pub fn fit(samples: &[Sample], room: f64, out: &mut Vec<Curve>) {
    let mut rest = samples;
    while let [from, next, ..] = rest {
        let (taken, first, second) = furthest(rest, room).unwrap_or((1, Curve::line(from.at, next.at), None));
        out.push(first);
        out.extend(second);
        rest = rest.get(taken..).unwrap_or(&[]);
    }
}

type Fitted = (usize, Curve, Option<Curve>);

/// The biarc or line that replaces most chords: how many, and its pieces.
fn furthest(samples: &[Sample], room: f64) -> Option<Fitted> {
    let last = samples.len().checked_sub(1)?;
    let try_to = |to: usize| {
        let (first, second) = replace(samples.get(..=to)?, room)?;
        Some((to, first, second))
    };
    let mut good = try_to(1)?;
    let mut bad = last + 1;
    while good.0 < last {
        let to = (good.0 * 2).min(last);
        match try_to(to) {
            Some(better) => good = better,
            None => {
                bad = to;
                break;
            }
        }
    }
    while bad - good.0 > 1 {
        let to = good.0 + (bad - good.0) / 2;
        match try_to(to) {
            Some(better) => good = better,
            None => bad = to,
        }
    }
    Some(good)
}

/// The line or biarc from the first sample to the last, if the chords stay within `room` of it.
fn replace(samples: &[Sample], room: f64) -> Option<(Curve, Option<Curve>)> {
    let ([first, ..], [.., last]) = (samples, samples) else { return None };
    let line = Curve::line(first.at, last.at);
    // Arcs that leave the ends in their directions would be as flat as that.
    let chord = sub(last.at, first.at);
    let leaves = |s: &Sample| dot(s.along, chord) >= 0.0 && cross(s.along, chord).abs() <= 4.0 * STRAIGHT;
    if leaves(first) && leaves(last) && follows(&line, samples.iter().map(|s| s.at), room.min(STRAIGHT)) {
        return Some((line, None));
    }
    let joint = joint(first, last)?;
    let arc = Curve::tangent(first.at, first.along, joint);
    // Run from the end, since only there the second arc's direction is given.
    let back = Curve::tangent(last.at, last.along.map(|c| -c), joint).reversed();
    let turned = arc.bend.map_or(0.0, |bend| bend.sweep);
    if turned.abs() > MOST_SWEEP || back.bend.is_some_and(|bend| bend.sweep.abs() > MOST_SWEEP) {
        return None;
    }
    let (sin, cos) = turned.sin_cos();
    let along = [first.along[0] * cos - first.along[1] * sin, first.along[0] * sin + first.along[1] * cos];
    let ahead = |s: &Sample| dot(sub(s.at, joint), along);
    let split = samples.iter().position(|s| ahead(s) >= 0.0)?;
    let (before, after) = (samples.get(..split)?, samples.get(split..)?);
    if after.iter().any(|s| ahead(s) < 0.0) {
        return None;
    }
    let (a, b) = (before.last()?, after.first()?);
    let share = ahead(a) / (ahead(a) - ahead(b));
    let crossing = Curve::line(a.at, b.at).at(share.clamp(0.0, 1.0));
    let fits = follows(&arc, before.iter().map(|s| s.at).chain([crossing]), room)
        && follows(&back, [crossing].into_iter().chain(after.iter().map(|s| s.at)), room);
    fits.then_some((arc, Some(back)))
}

/// Where the two arcs of a biarc meet.
fn joint(first: &Sample, last: &Sample) -> Option<Point> {
    let v = sub(last.at, first.at);
    let (t0, t1) = (first.along, last.along);
    if t0 == [0.0; 2] || t1 == [0.0; 2] {
        return None;
    }
    let along = dot(v, [t0[0] + t1[0], t0[1] + t1[1]]);
    // 1 − t₀·t₁ without cancellation.
    let turn = { dot(sub(t1, t0), sub(t1, t0)) / 2.0 };
    let square = dot(v, v);
    // The positive root in the form that also holds for parallel directions. Nothing ahead: no biarc.
    let d = square / (along + (along * along + 2.0 * turn * square).sqrt());
    if !(d.is_finite() && d > 0.0) {
        return None;
    }
    Some([
        (first.at[0] + last.at[0] + d * (t0[0] - t1[0])) / 2.0,
        (first.at[1] + last.at[1] + d * (t0[1] - t1[1])) / 2.0,
    ])
}

/// Whether chords through `corners` and the curve are nowhere further apart than `room` (see the bound
/// above). `corners` begin and end at its ends or square off them.
fn follows(curve: &Curve, corners: impl Iterator<Item = Point>, room: f64) -> bool {
    match curve.bend {
        None => follow_line(curve, corners, room),
        Some(bend) => follow_arc(curve, bend, corners, room),
    }
}

fn follow_line(line: &Curve, corners: impl Iterator<Item = Point>, room: f64) -> bool {
    let v = sub(line.to, line.from);
    let length = v[0].hypot(v[1]);
    if length == 0.0 {
        return false;
    }
    let mut reached = 0.0;
    for corner in corners {
        let w = sub(corner, line.from);
        let along = dot(v, w) / length;
        if cross(v, w).abs() > room * length || along < reached - ROUNDING || along > length + ROUNDING {
            return false;
        }
        reached = along;
    }
    true
}

fn follow_arc(arc: &Curve, bend: Bend, corners: impl Iterator<Item = Point>, room: f64) -> bool {
    let radius = distance(bend.center, arc.from);
    let sense = bend.sweep.signum();
    let (start, end) = (sub(arc.from, bend.center), sub(arc.to, bend.center));
    let slack = -ROUNDING * radius.max(1.0);
    let mut before: Option<Point> = None;
    for corner in corners {
        let arm = sub(corner, bend.center);
        let rising = before.is_none_or(|b| sense * cross(b, arm) >= slack);
        let within = sense * cross(start, arm) >= slack && sense * cross(arm, end) >= slack;
        if !rising || !within || (arm[0].hypot(arm[1]) - radius).abs() > room {
            return false;
        }
        if let Some(b) = before {
            // The foot of the perpendicular from the centre, where it lies on the chord.
            let v = sub(arm, b);
            let square = dot(v, v);
            let foot = -dot(b, v);
            if foot > 0.0 && foot < square && radius - cross(b, arm).abs() / square.sqrt() > room {
                return false;
            }
        }
        before = Some(arm);
    }
    true
}

#[cfg(test)]
mod tests {
    use super::*;
    use std::f64::consts::TAU;

    fn circle(n: usize, turn: f64) -> Vec<Sample> {
        (0..=n)
            .map(|i| {
                let (sin, cos) = (turn * i as f64 / n as f64).sin_cos();
                Sample { at: [10.0 * cos, 10.0 * sin], along: [-sin, cos].map(|c| c * turn.signum()) }
            })
            .collect()
    }

    #[test]
    fn samples_of_a_circle_become_few_arcs_of_it() {
        for turn in [TAU, -TAU, 1.0, -0.1] {
            let mut out = Vec::new();
            fit(&circle(400, turn), 0.01, &mut out);
            assert!(out.len() <= 6, "{} arcs of a turn of {turn}", out.len());
            for curve in &out {
                let bend = curve.bend.unwrap();
                assert!(bend.center[0].hypot(bend.center[1]) < 1e-9, "{curve:?}");
            }
            let turned: f64 = out.iter().map(|c| c.bend.unwrap().sweep).sum();
            assert!((turned - turn).abs() < 1e-9, "{turned}");
        }
    }

    #[test]
    fn a_straight_row_is_one_line() {
        let row: Vec<Sample> =
            (0..50).map(|i| Sample { at: [f64::from(i), 0.0], along: [1.0, 0.0] }).collect();
        let mut out = Vec::new();
        fit(&row, 0.01, &mut out);
        assert_eq!(out, [Curve::line([0.0, 0.0], [49.0, 0.0])]);
    }

    #[test]
    fn without_directions_the_chords_are_left() {
        let row: Vec<Sample> = [[0.0, 0.0], [1.0, 1.0], [2.0, 0.0], [1.0, -1.0]]
            .into_iter()
            .map(|at| Sample { at, along: [0.0; 2] })
            .collect();
        let mut out = Vec::new();
        fit(&row, 0.01, &mut out);
        assert_eq!(out.len(), 3);
        assert!(out.iter().all(|c| c.bend.is_none()));
    }
}
