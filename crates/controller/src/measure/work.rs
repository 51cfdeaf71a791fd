//! The work zero by a probe: where it is sent, and what its touches come to (GSK990MC part 2, 3.4.3.1).

use super::shape::{self, Circle, Point};
use super::{Pace, Touch, Touching, Unusable, size};
use ferrocut_geometry::{Axis, Position};
use ferrocut_machine::Fault;

/// Least angle between two of three touches of a circle, degrees (3.4.3.1, D; `#5` of program O9729 there).
pub const LEAST_ANGLE: f64 = 5.0;

/// What is measured. Sizes are mm, angles degrees from X+.
#[derive(Clone, Copy, PartialEq, Debug)]
pub enum Form {
    /// A hole (from inside) or a boss (from outside), touched in X+ X- Y+ Y-.
    Circle {
        /// From inside.
        inside: bool,
        /// Nominal diameter.
        diameter: f64,
    },
    /// A slot or a web: the axes of which a size is given.
    Walls {
        /// From inside.
        inside: bool,
        /// Nominal width along X.
        x: Option<f64>,
        /// Nominal width along Y.
        y: Option<f64>,
    },
    /// A hole or boss of which only parts can be reached, touched at three angles.
    VectorCircle {
        /// From inside.
        inside: bool,
        /// Nominal diameter.
        diameter: f64,
        /// Where it is touched.
        angles: [f64; 3],
    },
    /// A slot or web that lies at an angle, touched along it on both sides.
    VectorWalls {
        /// From inside.
        inside: bool,
        /// Nominal width.
        width: f64,
        /// The direction across.
        angle: f64,
    },
    /// One surface.
    Edge {
        /// The axis along which it is touched.
        axis: Axis,
        /// In its positive direction.
        positive: bool,
        /// How far it is searched.
        distance: f64,
    },
}

/// Where and how it is measured. Machine positions, mm.
#[derive(Clone, Copy, PartialEq, Debug)]
pub struct Work {
    /// The form.
    pub form: Form,
    /// Where the probe stands when measuring begins. What is outside is passed over at this height.
    pub from: Position,
    /// The rough centre; of an edge where its search begins.
    pub centre: Point,
    /// The height at which it touches; none is that of `from`.
    pub depth: Option<f64>,
    /// From the surface of an outer form to where the probe goes down (R of the manual).
    pub clearance: f64,
    /// How far behind the nominal surface is searched (Q of the manual).
    pub overtravel: f64,
    /// Diameter of the probe's ball.
    pub ball: f64,
    /// How fast.
    pub pace: Pace,
}

/// What was found.
#[derive(Clone, PartialEq, Debug, Default)]
pub struct Found {
    /// Machine positions of the zero, on the axes that were measured.
    pub place: Vec<(Axis, f64)>,
    /// Sizes with their nominal ones.
    pub sizes: Vec<(f64, f64)>,
    /// The farthest that a touch lies beside the circle.
    pub out_of_round: f64,
}

/// A direction in which it is touched, and from which distance of the centre to which.
struct Ray {
    angle: f64,
    from: f64,
    to: f64,
}

impl Work {
    /// The way of the probe.
    pub fn touching(&self) -> Result<Touching, Unusable> {
        let ball = size(Some(self.ball), "probe")? / 2.0;
        for (value, name) in [(self.clearance, "clearance"), (self.overtravel, "overtravel")] {
            size(Some(value), name)?;
        }
        if let Form::Edge { axis, positive, distance } = self.form {
            return self.edge(axis, positive, size(Some(distance), "distance")?);
        }
        let (inside, rays) = self.rays(ball)?;
        let depth = self.depth.unwrap_or(self.from[Axis::Z]);
        // An outer form is passed over at the height where the probe stands.
        if !inside && depth >= self.from[Axis::Z] {
            return Err(Unusable("z"));
        }
        let at = |distance: f64, angle: f64, z: f64| {
            let (sin, cos) = angle.to_radians().sin_cos();
            let mut place = self.from;
            place[Axis::X] = self.centre[0] + distance * cos;
            place[Axis::Y] = self.centre[1] + distance * sin;
            place[Axis::Z] = z;
            place
        };
        let top = self.from[Axis::Z];
        let mut touches = Vec::with_capacity(rays.len());
        for (n, Ray { angle, from, to }) in rays.iter().enumerate() {
            let down = [at(*from, *angle, top), at(*from, *angle, depth)];
            let via = match (inside, n) {
                (true, 0) => down.to_vec(),
                // From the centre, where the touch before has returned to.
                (true, _) => vec![at(*from, *angle, depth)],
                (false, 0) => down.to_vec(),
                (false, _) => {
                    let before = rays.get(n - 1).map_or(0.0, |ray| ray.angle);
                    [&[at(*from, before, top)], &down[..]].concat()
                }
            };
            touches.push(Touch { via, limit: at(*to, *angle, depth) });
        }
        let last = rays.last().map_or((0.0, 0.0), |ray| (ray.from, ray.angle));
        let end = vec![at(last.0, last.1, top)];
        Ok(Touching { touches, end, pace: self.pace, spindle: None, missed: Fault::ProbeMissed })
    }

    /// Directions and distances of the touches.
    fn rays(&self, ball: f64) -> Result<(bool, Vec<Ray>), Unusable> {
        let (clearance, overtravel) = (self.clearance, self.overtravel);
        let rays = |inside: bool, half: f64, angles: &[f64]| -> Result<Vec<Ray>, Unusable> {
            let ray = |angle: &f64| match inside {
                true => Ray { angle: *angle, from: 0.0, to: half - ball + overtravel },
                false => Ray {
                    angle: *angle,
                    from: half + ball + clearance,
                    to: (half + ball - overtravel).max(0.0),
                },
            };
            // The probe has to fit in.
            match inside && half <= ball {
                true => Err(Unusable("size")),
                false => Ok(angles.iter().map(ray).collect()),
            }
        };
        Ok(match self.form {
            Form::Circle { inside, diameter } => {
                let half = size(Some(diameter), "diameter")? / 2.0;
                (inside, rays(inside, half, &[0.0, 180.0, 90.0, 270.0])?)
            }
            Form::VectorCircle { inside, diameter, angles } => {
                let half = size(Some(diameter), "diameter")? / 2.0;
                let [a, b, c] = angles;
                let apart = [shape::between(a, b), shape::between(b, c), shape::between(c, a)];
                match angles.iter().all(|angle| angle.is_finite()) && apart.iter().all(|d| *d >= LEAST_ANGLE)
                {
                    true => (inside, rays(inside, half, &angles)?),
                    false => return Err(Unusable("angles")),
                }
            }
            Form::VectorWalls { inside, width, angle } => {
                let half = size(Some(width), "width")? / 2.0;
                match angle.is_finite() {
                    true => (inside, rays(inside, half, &[angle, angle + 180.0])?),
                    false => return Err(Unusable("angle")),
                }
            }
            Form::Walls { inside, x, y } => {
                // 3.4.3.1, C: an axis without a size is not measured.
                let given = |value: Option<f64>| value.filter(|value| *value != 0.0);
                let mut all = Vec::new();
                for (value, name, angles) in [(x, "x", [0.0, 180.0]), (y, "y", [90.0, 270.0])] {
                    if let Some(value) = given(value) {
                        all.extend(rays(inside, size(Some(value), name)? / 2.0, &angles)?);
                    }
                }
                match all.is_empty() {
                    true => return Err(Unusable("x")),
                    false => (inside, all),
                }
            }
            Form::Edge { .. } => (true, Vec::new()),
        })
    }

    fn edge(&self, axis: Axis, positive: bool, distance: f64) -> Result<Touching, Unusable> {
        let depth = self.depth.unwrap_or(self.from[Axis::Z]);
        // It is passed over at the height where the probe stands.
        let mut above = self.from;
        [above[Axis::X], above[Axis::Y]] = self.centre;
        let mut start = above;
        if axis == Axis::Z && positive {
            return Err(Unusable("axis"));
        }
        if axis != Axis::Z {
            start[Axis::Z] = depth;
        }
        let mut limit = start;
        limit[axis] += if positive { distance } else { -distance };
        let via = if start == above { vec![above] } else { vec![above, start] };
        let touches = vec![Touch { via, limit }];
        Ok(Touching { touches, end: vec![above], pace: self.pace, spindle: None, missed: Fault::ProbeMissed })
    }

    /// What the touches come to, in the order of the way; none where they give no shape.
    pub fn found(&self, touched: &[Position]) -> Option<Found> {
        let points: Vec<Point> = touched.iter().map(|at| [at[Axis::X], at[Axis::Y]]).collect();
        // The middle of the ball is half its diameter inside or outside of the surface.
        let sized = |apart: f64, inside: bool| if inside { apart + self.ball } else { apart - self.ball };
        let place = |at: Point| vec![(Axis::X, at[0]), (Axis::Y, at[1])];
        match self.form {
            Form::Circle { inside, diameter } | Form::VectorCircle { inside, diameter, .. } => {
                let Circle { centre, diameter: apart, out_of_round } = shape::circle(&points)?;
                let sizes = vec![(sized(apart, inside), diameter)];
                Some(Found { place: place(centre), sizes, out_of_round })
            }
            Form::VectorWalls { inside, width, angle } => {
                let [a, b] = points.as_slice() else { return None };
                let (at, apart) = shape::middle(self.centre, angle, *a, *b);
                // An axis across the direction is not measured.
                let (sine, cosine) = angle.to_radians().sin_cos();
                let shares = [(Axis::X, cosine), (Axis::Y, sine)];
                let is_measured =
                    |axis: &Axis| shares.iter().any(|(a, share)| a == axis && share.abs() > 1e-6);
                Some(Found {
                    place: place(at).into_iter().filter(|(axis, _)| is_measured(axis)).collect(),
                    sizes: vec![(sized(apart, inside), width)],
                    out_of_round: 0.0,
                })
            }
            Form::Walls { inside, x, y } => {
                let mut found = Found::default();
                let mut pairs = points.chunks_exact(2);
                for (n, (axis, width)) in [(Axis::X, x), (Axis::Y, y)].into_iter().enumerate() {
                    let Some(width) = width.filter(|width| *width != 0.0) else { continue };
                    let [a, b] = pairs.next()? else { return None };
                    let (a, b) = (a.get(n)?, b.get(n)?);
                    found.place.push((axis, (a + b) / 2.0));
                    found.sizes.push((sized((a - b).abs(), inside), width));
                }
                Some(found)
            }
            Form::Edge { axis, positive, .. } => {
                let at = touched.first()?[axis];
                // A probe touches the table with its tip, to which its length is measured.
                let ball = if axis == Axis::Z { 0.0 } else { self.ball };
                let at = shape::surface(at, if positive { 1.0 } else { -1.0 }, ball);
                Some(Found { place: vec![(axis, at)], ..Found::default() })
            }
        }
    }
}

/// The centre of points that were taken by hand (3.4.3.1, A 4): of a circle through three or more, or of four points of
/// which the first two lie on walls across X, the others on walls across Y.
pub fn centre_of(points: &[Position], is_circle: bool) -> Option<Found> {
    let flat: Vec<Point> = points.iter().map(|at| [at[Axis::X], at[Axis::Y]]).collect();
    if is_circle {
        let Circle { centre, diameter, out_of_round } = shape::circle(&flat)?;
        let place = vec![(Axis::X, centre[0]), (Axis::Y, centre[1])];
        return Some(Found { place, sizes: vec![(diameter, diameter)], out_of_round });
    }
    let [a, b, c, d] = flat.as_slice() else { return None };
    let (x, y) = ((a[0] + b[0]) / 2.0, (c[1] + d[1]) / 2.0);
    let sizes = [(a[0] - b[0]).abs(), (c[1] - d[1]).abs()].map(|size| (size, size)).to_vec();
    Some(Found { place: vec![(Axis::X, x), (Axis::Y, y)], sizes, out_of_round: 0.0 })
}
