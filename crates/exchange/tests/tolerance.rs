//! Arcs stay within the tolerance of the curves that they stand for, and the other way round, whatever
//! the ellipse or spline.
#![allow(missing_docs, clippy::unwrap_used, clippy::panic)]

use ferrocut_exchange::curve::Curve;
use ferrocut_exchange::ellipse::Ellipse;
use ferrocut_exchange::limits::Limits;
use ferrocut_exchange::spline::{self, Spline};
use ferrocut_geometry::vector::{Point, distance};
use proptest::prelude::*;
use std::f64::consts::TAU;

/// Distance of a point from a line or arc, ends included.
fn off(curve: &Curve, p: Point) -> f64 {
    let ends = distance(curve.from, p).min(distance(curve.to, p));
    let Some(bend) = curve.bend else {
        let v = [curve.to[0] - curve.from[0], curve.to[1] - curve.from[1]];
        let square = v[0] * v[0] + v[1] * v[1];
        if square == 0.0 {
            return ends;
        }
        let t = ((p[0] - curve.from[0]) * v[0] + (p[1] - curve.from[1]) * v[1]) / square;
        return distance(curve.at(t.clamp(0.0, 1.0)), p);
    };
    let angle = |q: Point| (q[1] - bend.center[1]).atan2(q[0] - bend.center[0]);
    let turned = (angle(p) - angle(curve.from)) * bend.sweep.signum();
    match turned.rem_euclid(TAU) <= bend.sweep.abs() {
        true => (distance(bend.center, p) - curve.radius()).abs(),
        false => ends,
    }
}

fn off_any(curves: &[Curve], p: Point) -> f64 {
    curves.iter().map(|curve| off(curve, p)).fold(f64::INFINITY, f64::min)
}

/// `fine` are points of the true curve, nowhere further from it than `slack` in between.
fn check(curves: &[Curve], fine: &[Point], tolerance: f64, slack: f64) -> Result<(), TestCaseError> {
    let (first, last) = (curves.first().unwrap(), curves.last().unwrap());
    prop_assert!(distance(first.from, fine[0]) < 1e-9, "starts at {:?}", first.from);
    prop_assert!(distance(last.to, fine[fine.len() - 1]) < 1e-9, "ends at {:?}", last.to);
    for pair in curves.windows(2) {
        prop_assert_eq!(pair[0].to, pair[1].from, "the path is in one piece");
    }
    for p in fine.iter().step_by(7) {
        let off = off_any(curves, *p);
        prop_assert!(off <= tolerance + 1e-9, "{:?} of the curve is {} away", p, off);
    }
    let chords: Vec<Curve> = fine.windows(2).map(|pair| Curve::line(pair[0], pair[1])).collect();
    for curve in curves.iter().step_by(1 + curves.len() / 40) {
        for i in 0..=10 {
            let p = curve.at(f64::from(i) / 10.0);
            let off = off_any(&chords, p);
            prop_assert!(off <= tolerance + slack + 1e-9, "{:?} of the path is {} away", p, off);
        }
    }
    Ok(())
}

fn coordinate() -> impl Strategy<Value = f64> {
    prop_oneof![4 => -100.0..100.0f64, 1 => -1.0..1.0f64, 1 => (-5i32..=5).prop_map(f64::from)]
}

fn vector() -> impl Strategy<Value = [f64; 3]> {
    prop::array::uniform3(coordinate())
}

/// De Boor's algorithm in the plain form, for comparison.
fn evaluate(degree: usize, knots: &[f64], points: &[[f64; 3]], weights: &[f64], t: f64) -> Point {
    let last = points.len() - 1;
    let k = (degree..=last).rev().find(|k| knots[*k] <= t && knots[*k] < knots[*k + 1]).unwrap_or(degree);
    let mut d: Vec<[f64; 3]> = (0..=degree)
        .map(|j| {
            let i = k - degree + j;
            [points[i][0] * weights[i], points[i][1] * weights[i], weights[i]]
        })
        .collect();
    for r in 1..=degree {
        for j in (r..=degree).rev() {
            let i = k - degree + j;
            let a = (t - knots[i]) / (knots[i + degree + 1 - r] - knots[i]);
            let before = d[j - 1];
            for (c, v) in d[j].iter_mut().enumerate() {
                *v = before[c] * (1.0 - a) + *v * a;
            }
        }
    }
    [d[degree][0] / d[degree][2], d[degree][1] / d[degree][2]]
}

proptest! {
    #![proptest_config(ProptestConfig { failure_persistence: None, ..ProptestConfig::with_cases(60) })]

    #[test]
    fn ellipses(
        center in vector(), u in vector(), v in vector(),
        from in -7.0..7.0f64,
        sweep in prop_oneof![Just(TAU), 0.01..TAU, -TAU..-0.01f64],
        tolerance in prop::sample::select(vec![0.001, 0.01, 0.1, 2.0]),
    ) {
        let ellipse = Ellipse { center, u, v, from, sweep };
        let mut curves = Vec::new();
        ellipse.curves(tolerance, &mut Limits::new(), &mut curves).unwrap();
        prop_assume!(!curves.is_empty());
        let fine: Vec<Point> = (0..=8000)
            .map(|i| {
                let t = from + sweep * f64::from(i) / 8000.0;
                [0, 1].map(|c| center[c] + u[c] * t.cos() + v[c] * t.sin())
            })
            .collect();
        // h²/8 times the largest second derivative.
        let slack = (TAU / 8000.0f64).powi(2) / 8.0 * 500.0;
        check(&curves, &fine, tolerance, slack)?;
    }

    #[test]
    fn splines(
        degree in 1usize..=5,
        points in prop::collection::vec(vector(), 6..14),
        steps in prop::collection::vec(prop_oneof![3 => 0.1..2.0f64, 1 => Just(0.0)], 20),
        weights in prop::collection::vec(0.2..5.0f64, 14),
        is_rational in any::<bool>(),
        tolerance in prop::sample::select(vec![0.001, 0.01, 0.1, 2.0]),
    ) {
        // Clamped ends, inner knots at random distances; equal ones make corners and less.
        let mut knots = vec![0.0; degree + 1];
        let mut knot = 0.0;
        for step in steps.iter().take(points.len() - degree - 1) {
            knot += step;
            knots.push(knot);
        }
        knots.extend(std::iter::repeat_n(knot + 1.0, degree + 1));
        let weights: Vec<f64> = match is_rational {
            true => weights[..points.len()].to_vec(),
            false => vec![1.0; points.len()],
        };
        // More equal knots than the degree tear the curve apart; the reader takes it as it stands.
        prop_assume!(knots[1..].windows(degree + 1).skip(degree).all(|w| w[0] < w[degree] || w[0] > knot));
        let spline = Spline::new(degree, knots.clone(), points.clone(), weights.clone()).unwrap();
        let mut curves = Vec::new();
        spline::curves(&spline, tolerance, &mut Limits::new(), &mut curves).unwrap();
        let end = knot + 1.0;
        let fine: Vec<Point> = (0..=6000)
            .map(|i| evaluate(degree, &knots, &points, &weights, end * f64::from(i) / 6000.0))
            .collect();
        // Points of the true curve are close; what lies between them is checked by the first half.
        let slack = fine.windows(2).map(|p| distance(p[0], p[1])).fold(0.0, f64::max);
        check(&curves, &fine, tolerance, slack)?;
    }

    #[test]
    fn curves_through_points(
        points in prop::collection::vec(vector(), 2..12),
        start in prop::option::of(vector()),
        tolerance in prop::sample::select(vec![0.001, 0.01, 0.1]),
    ) {
        let mut distinct = points.clone();
        distinct.dedup();
        prop_assume!(distinct.len() > 1);
        let spline = Spline::through(&points, start, None).unwrap();
        let mut curves = Vec::new();
        spline::curves(&spline, tolerance, &mut Limits::new(), &mut curves).unwrap();
        for p in &points {
            let off = off_any(&curves, [p[0], p[1]]);
            prop_assert!(off <= tolerance + 1e-9, "{:?} is {} away", p, off);
        }
    }
}

/// Biarcs need far fewer pieces than chords: an ellipse of a hundred millimetres.
#[test]
fn arcs_are_few() {
    let ellipse =
        Ellipse { center: [0.0; 3], u: [50.0, 0.0, 0.0], v: [0.0, 10.0, 0.0], from: 0.0, sweep: TAU };
    let mut curves = Vec::new();
    ellipse.curves(0.01, &mut Limits::new(), &mut curves).unwrap();
    assert!(curves.len() < 60, "{}", curves.len());
    let turned: f64 = curves.iter().map(|curve| curve.bend.unwrap().sweep).sum();
    assert!((turned - TAU).abs() < 1e-6, "{turned}");
    for pair in curves.windows(2) {
        // The direction at a joint is that of both sides.
        let tangent = |curve: &Curve, at: Point| {
            let bend = curve.bend.unwrap();
            let arm = [at[0] - bend.center[0], at[1] - bend.center[1]];
            (arm[0] * bend.sweep.signum()).atan2(-arm[1] * bend.sweep.signum())
        };
        let corner = (tangent(&pair[0], pair[0].to) - tangent(&pair[1], pair[1].from)).rem_euclid(TAU);
        assert!(corner.min(TAU - corner) < 1e-6, "a corner of {corner}");
    }
}
