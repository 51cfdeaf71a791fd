//! Centre and size of touched points. Lengths are mm, angles degrees counted from X+ to Y+.

/// A point of a plane.
pub type Point = [f64; 2];

/// A circle.
#[derive(Clone, Copy, PartialEq, Debug)]
pub struct Circle {
    /// Its centre.
    pub centre: Point,
    /// Its diameter.
    pub diameter: f64,
    /// The farthest that a point lies beside it.
    pub out_of_round: f64,
}

/// Points of which none stands out more than this from a line give no circle: 1 µm, as for three touches of one wall.
const STRAIGHT: f64 = 1e-3;

/// Two points closer than this are one.
const SAME: f64 = 1e-3;

fn distance(a: Point, b: Point) -> f64 {
    (a[0] - b[0]).hypot(a[1] - b[1])
}

/// The circle through three points, or with the least sum of squared distances from more (Kåsa's algebraic fit, exact
/// where all lie on a circle). Points that are all one are their own centre (3.4.3.1, A 4); points on a line give none.
pub fn circle(points: &[Point]) -> Option<Circle> {
    let first = *points.first()?;
    if points.len() < 3 || points.iter().flatten().any(|value| !value.is_finite()) {
        return None;
    }
    if points.iter().all(|point| distance(*point, first) < SAME) {
        return Some(Circle { centre: first, diameter: 0.0, out_of_round: 0.0 });
    }
    let count = points.len() as f64;
    let mean = |of: &dyn Fn(&Point) -> f64| points.iter().map(of).sum::<f64>() / count;
    let middle = [mean(&|p| p[0]), mean(&|p| p[1])];
    let local: Vec<Point> = points.iter().map(|p| [p[0] - middle[0], p[1] - middle[1]]).collect();
    let sum = |of: &dyn Fn(&Point) -> f64| local.iter().map(of).sum::<f64>();
    let (xx, yy, xy) = (sum(&|p| p[0] * p[0]), sum(&|p| p[1] * p[1]), sum(&|p| p[0] * p[1]));
    // Spread across the line that fits best: the smaller eigenvalue of the second moments.
    let across = ((xx + yy) - ((xx - yy).hypot(2.0 * xy))) / 2.0;
    if (across.max(0.0) / count).sqrt() < STRAIGHT {
        return None;
    }
    let square = |p: &Point| p[0] * p[0] + p[1] * p[1];
    let (right_x, right_y) = (sum(&|p| p[0] * square(p)) / 2.0, sum(&|p| p[1] * square(p)) / 2.0);
    let determinant = xx * yy - xy * xy;
    let at = [(right_x * yy - right_y * xy) / determinant, (right_y * xx - right_x * xy) / determinant];
    let radius = (at[0] * at[0] + at[1] * at[1] + (xx + yy) / count).sqrt();
    let centre = [middle[0] + at[0], middle[1] + at[1]];
    let beside = |p: &Point| (distance(*p, centre) - radius).abs();
    let out_of_round = points.iter().map(beside).fold(0.0, f64::max);
    (radius.is_finite() && out_of_round.is_finite()).then_some(Circle {
        centre,
        diameter: 2.0 * radius,
        out_of_round,
    })
}

/// The middle of two walls that face each other along an angle, beside `near`: the place on the line through `near`
/// along the angle, and how far the points are apart along it.
pub fn middle(near: Point, angle: f64, a: Point, b: Point) -> (Point, f64) {
    let (sin, cos) = angle.to_radians().sin_cos();
    let along = |p: Point| (p[0] - near[0]) * cos + (p[1] - near[1]) * sin;
    let (a, b) = (along(a), along(b));
    let offset = (a + b) / 2.0;
    ([near[0] + offset * cos, near[1] + offset * sin], (a - b).abs())
}

/// The surface that the middle of a ball touched on its way in the direction `sign` of an axis.
pub fn surface(touched: f64, sign: f64, ball: f64) -> f64 {
    touched + sign * ball / 2.0
}

/// The smallest angle between two directions, degrees.
pub fn between(a: f64, b: f64) -> f64 {
    let apart = (a - b).rem_euclid(360.0);
    apart.min(360.0 - apart)
}

#[cfg(test)]
mod tests {
    use super::*;

    fn on(centre: Point, radius: f64, degrees: f64) -> Point {
        let (sin, cos) = degrees.to_radians().sin_cos();
        [centre[0] + radius * cos, centre[1] + radius * sin]
    }

    #[test]
    fn three_points_of_a_circle_give_its_centre() {
        for (centre, radius, angles) in [
            ([0.0, 0.0], 5.0, [0.0, 90.0, 180.0]),
            ([120.5, -340.25], 12.5, [10.0, 100.0, 200.0]),
            ([-500.0, 800.0], 0.5, [0.0, 5.0, 300.0]),
            // A sixth of a large bore.
            ([1000.0, 1000.0], 250.0, [20.0, 50.0, 80.0]),
        ] {
            let found = circle(&angles.map(|angle| on(centre, radius, angle))).unwrap();
            assert!(distance(found.centre, centre) < 1e-6, "{found:?}");
            assert!((found.diameter - 2.0 * radius).abs() < 1e-6 && found.out_of_round < 1e-6, "{found:?}");
        }
    }

    #[test]
    fn more_points_are_fitted_and_tell_how_round_they_are() {
        let mut points: Vec<Point> = (0..8).map(|n| on([3.0, 4.0], 20.0, 45.0 * f64::from(n))).collect();
        assert!(circle(&points).unwrap().out_of_round < 1e-9);
        // Opposite points 0.02 outwards: an oval, the centre stays.
        points[0][0] += 0.02;
        points[4][0] -= 0.02;
        let found = circle(&points).unwrap();
        assert!(distance(found.centre, [3.0, 4.0]) < 1e-6, "{found:?}");
        assert!(found.out_of_round > 0.009 && found.out_of_round < 0.02, "{found:?}");
    }

    #[test]
    fn one_point_is_a_centre_and_a_line_is_none() {
        let same = circle(&[[7.0, 8.0]; 3]).unwrap();
        assert_eq!((same.centre, same.diameter), ([7.0, 8.0], 0.0));
        assert_eq!(circle(&[[0.0, 0.0], [5.0, 5.0], [9.0, 9.0]]), None);
        assert_eq!(circle(&[[0.0, 0.0], [0.0, 0.0], [9.0, 9.0]]), None);
        assert_eq!(circle(&[[0.0, 0.0], [1.0, 0.0]]), None);
        assert_eq!(circle(&[[0.0, 0.0], [f64::NAN, 0.0], [0.0, 1.0]]), None);
    }

    #[test]
    fn two_walls_have_a_middle_along_their_angle() {
        let (at, apart) = middle([10.0, 20.0], 0.0, [42.0, 20.5], [-18.0, 19.0]);
        assert_eq!((at, apart), ([12.0, 20.0], 60.0));
        // At 30°: walls 25 and 35 from the place that was guessed.
        let (a, b) = (on([10.0, 20.0], 25.0, 30.0), on([10.0, 20.0], 35.0, 210.0));
        let (at, apart) = middle([10.0, 20.0], 30.0, a, b);
        assert!(distance(at, on([10.0, 20.0], 5.0, 210.0)) < 1e-9 && (apart - 60.0).abs() < 1e-9);
    }

    #[test]
    fn a_ball_is_half_its_diameter_before_the_surface() {
        assert_eq!((surface(10.0, 1.0, 6.0), surface(10.0, -1.0, 6.0)), (13.0, 7.0));
        assert_eq!((between(350.0, 10.0), between(10.0, 190.0), between(-5.0, 355.0)), (20.0, 180.0, 0.0));
    }
}
