//! Leaves out the points of a polyline that nobody could see.
//!
//! From the last kept point (the anchor) a ray is laid through the first point that lies further away
//! than the tolerance. Points are passed over while they stay within the tolerance of this ray and go
//! forward on it; the furthest of them is kept when the path leaves the strip or turns back. So a
//! line that runs out and returns keeps its far end, and what is left out lies within twice the
//! tolerance of what is kept: one tolerance to the ray, one more from the ray to the kept chord.
//! (After Reumann and Witkam 1974, with the rule for turning back.)

use super::extent::{Point3, zip};

/// Thins one polyline, point by point, in constant memory.
pub struct Thinner {
    tolerance: f64,
    anchor: Point3,
    /// Unit vector of the ray and how far along it the path has come.
    ray: Option<(Point3, f64)>,
    /// The furthest point on the ray.
    furthest: Point3,
    last: Point3,
}

impl Thinner {
    /// Starts a polyline at `first`, which the caller keeps.
    pub fn new(first: Point3, tolerance: f64) -> Thinner {
        Thinner { tolerance, anchor: first, ray: None, furthest: first, last: first }
    }

    /// Takes the next point; returns the point to keep before it, if there is one.
    pub fn push(&mut self, p: Point3) -> Option<Point3> {
        self.last = p;
        let Some((direction, reach)) = self.ray else {
            self.aim(p);
            return None;
        };
        let v = zip(p, self.anchor, |a, b| a - b);
        let along = dot(v, direction);
        let aside = zip(v, direction, |a, d| a - along * d);
        if dot(aside, aside) <= self.tolerance * self.tolerance && along > reach - self.tolerance {
            if along > reach {
                self.ray = Some((direction, along));
                self.furthest = p;
            }
            return None;
        }
        let kept = self.furthest;
        self.anchor = kept;
        self.ray = None;
        self.aim(p);
        Some(kept)
    }

    /// Thins by another tolerance from here on.
    pub fn set_tolerance(&mut self, tolerance: f64) {
        self.tolerance = tolerance;
    }

    /// The points to keep if the polyline ends here.
    pub fn pending(&self) -> impl Iterator<Item = Point3> + use<> {
        let turn = (self.ray.is_some() && self.furthest != self.last).then_some(self.furthest);
        let end = (self.last != self.anchor).then_some(self.last);
        turn.into_iter().chain(end)
    }

    /// Lays the ray through `p` if it is far enough from the anchor.
    fn aim(&mut self, p: Point3) {
        let v = zip(p, self.anchor, |a, b| a - b);
        let length = dot(v, v).sqrt();
        if length > self.tolerance && length > 0.0 {
            self.ray = Some((v.map(|c| c / length), length));
            self.furthest = p;
        }
    }
}

fn dot(a: Point3, b: Point3) -> f64 {
    a[0] * b[0] + a[1] * b[1] + a[2] * b[2]
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::view::extent::Extent;
    use proptest::prelude::*;

    fn thin(points: &[Point3], tolerance: f64) -> Vec<Point3> {
        let mut kept = vec![points[0]];
        let mut thinner = Thinner::new(points[0], tolerance);
        for p in &points[1..] {
            kept.extend(thinner.push(*p));
        }
        kept.extend(thinner.pending());
        kept
    }

    #[test]
    fn a_straight_line_keeps_its_ends() {
        let line: Vec<_> = (0..=1000).map(|i| [f64::from(i), f64::from(i) * 2.0, 0.0]).collect();
        assert_eq!(thin(&line, 0.1), [[0.0, 0.0, 0.0], [1000.0, 2000.0, 0.0]]);
    }

    #[test]
    fn a_line_there_and_back_keeps_its_far_end() {
        let x = [0.0, 4.0, 10.0, 9.9, 3.0, 0.0];
        let line: Vec<_> = x.iter().map(|x| [*x, 0.0, 0.0]).collect();
        assert!(thin(&line, 0.5).contains(&[10.0, 0.0, 0.0]));
        assert_eq!(thin(&line, 0.5).last(), Some(&[0.0, 0.0, 0.0]));
    }

    #[test]
    fn a_point_that_stays_is_one_point() {
        assert_eq!(thin(&[[1.0; 3]; 5], 0.1), [[1.0; 3]]);
    }

    fn distance_to(kept: &[Point3], p: Point3) -> f64 {
        let length = |v: Point3| dot(v, v).sqrt();
        let minus = |a, b| zip(a, b, |a, b| a - b);
        kept.windows(2)
            .map(|w| {
                let d = minus(w[1], w[0]);
                let t = (dot(minus(p, w[0]), d) / dot(d, d).max(1e-300)).clamp(0.0, 1.0);
                length(minus(p, zip(w[0], d, |a, d| a + d * t)))
            })
            .fold(length(minus(p, kept[0])), f64::min)
    }

    proptest! {
        #[test]
        fn what_is_left_out_is_near_what_is_kept(
            steps in prop::collection::vec([-2.0..2.0f64, -2.0..2.0f64, -0.5..0.5f64], 1..200),
            tolerance in 0.01..2.0f64,
        ) {
            let mut at = [0.0; 3];
            let mut points = vec![at];
            for s in steps {
                at = zip(at, s, |a, b| a + b);
                points.push(at);
            }
            let kept = thin(&points, tolerance);
            prop_assert_eq!(kept.last(), points.last());
            let (mut all, mut few) = (Extent::EMPTY, Extent::EMPTY);
            points.iter().for_each(|p| all.add(*p));
            kept.iter().for_each(|p| few.add(*p));
            for i in 0..3 {
                prop_assert!(few.min[i] - all.min[i] <= 2.0 * tolerance);
                prop_assert!(all.max[i] - few.max[i] <= 2.0 * tolerance);
            }
            for p in points {
                prop_assert!(distance_to(&kept, p) <= 2.0 * tolerance + 1e-9);
            }
        }
    }
}
