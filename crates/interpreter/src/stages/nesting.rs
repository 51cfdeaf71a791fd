//! Stage of transformations that nest: rotation, scaling and mirror of a control that keeps them as a stack
//! (Weihong 4.3, G68: "an earlier rotation acts on a later one").
//!
//! A point goes through the latest first: `p' = T1(T2(…Tn(p)))`. Each is affine on X, Y, Z,
//! `x → A·x + b`, and so is what they come to together, which is kept beside its inverse.

use crate::stages::rotation::{Rotation, sin_cos_degrees};
use ferrocut_geometry::{Plane, Position};

/// One transformation. Centres are programmed coordinates under the transformations before it, mm.
#[derive(Clone, Copy, PartialEq, Debug)]
pub enum Transform {
    /// G68.
    Rotation(Rotation),
    /// G51: factors and centre of X, Y, Z; an axis that is not scaled has factor 1.
    Scaling {
        /// Never 0.
        factors: [f64; 3],
        /// Centre.
        center: [f64; 3],
    },
    /// G51.1 of one axis, counted from X.
    Mirror {
        /// 0 to 2.
        axis: usize,
        /// Where it is mirrored.
        center: f64,
    },
}

/// `x → matrix·x + offset` on X, Y, Z.
#[derive(Clone, Copy, PartialEq, Debug)]
struct Affine {
    matrix: [[f64; 3]; 3],
    offset: [f64; 3],
}

const UNIT: Affine = Affine { matrix: [[1.0, 0.0, 0.0], [0.0, 1.0, 0.0], [0.0, 0.0, 1.0]], offset: [0.0; 3] };

impl Affine {
    fn vector(&self, v: [f64; 3]) -> [f64; 3] {
        self.matrix.map(|row| row[0] * v[0] + row[1] * v[1] + row[2] * v[2])
    }

    fn apply(&self, mut p: Position) -> Position {
        let [x, y, z, ..] = p.0;
        let v = self.vector([x, y, z]);
        for ((c, v), b) in p.0.iter_mut().zip(v).zip(self.offset) {
            *c = v + b;
        }
        p
    }

    /// What `inner` and then this one come to.
    fn after(&self, inner: &Affine) -> Affine {
        let [a, b, c] = [
            self.vector(inner.matrix.map(|[x, _, _]| x)),
            self.vector(inner.matrix.map(|[_, y, _]| y)),
            self.vector(inner.matrix.map(|[_, _, z]| z)),
        ];
        let moved = self.vector(inner.offset);
        Affine {
            matrix: [[a[0], b[0], c[0]], [a[1], b[1], c[1]], [a[2], b[2], c[2]]],
            offset: [moved[0] + self.offset[0], moved[1] + self.offset[1], moved[2] + self.offset[2]],
        }
    }

    /// A matrix that leaves `center` where it is.
    fn about(matrix: [[f64; 3]; 3], center: [f64; 3]) -> Affine {
        let linear = Affine { matrix, offset: [0.0; 3] };
        let c = linear.vector(center);
        Affine { matrix, offset: [center[0] - c[0], center[1] - c[1], center[2] - c[2]] }
    }

    fn diagonal(factors: [f64; 3], center: [f64; 3]) -> Affine {
        let [x, y, z] = factors;
        Affine::about([[x, 0.0, 0.0], [0.0, y, 0.0], [0.0, 0.0, z]], center)
    }

    fn rotation(rotation: &Rotation, degrees: f64) -> Affine {
        let (sin, cos) = sin_cos_degrees(degrees);
        let (matrix, center) = match (rotation.plane, rotation.center) {
            (Plane::Xy, [a, b]) => ([[cos, -sin, 0.0], [sin, cos, 0.0], [0.0, 0.0, 1.0]], [a, b, 0.0]),
            (Plane::Zx, [a, b]) => ([[cos, 0.0, sin], [0.0, 1.0, 0.0], [-sin, 0.0, cos]], [b, 0.0, a]),
            (Plane::Yz, [a, b]) => ([[1.0, 0.0, 0.0], [0.0, cos, -sin], [0.0, sin, cos]], [0.0, a, b]),
        };
        Affine::about(matrix, center)
    }
}

impl Transform {
    fn affine(&self) -> Affine {
        match self {
            Transform::Rotation(rotation) => Affine::rotation(rotation, rotation.degrees),
            Transform::Scaling { factors, center } => Affine::diagonal(*factors, *center),
            Transform::Mirror { .. } => self.inverse(),
        }
    }

    fn inverse(&self) -> Affine {
        match self {
            Transform::Rotation(rotation) => Affine::rotation(rotation, -rotation.degrees),
            Transform::Scaling { factors, center } => Affine::diagonal(factors.map(|f| 1.0 / f), *center),
            Transform::Mirror { axis, center } => {
                let (mut factors, mut at) = ([1.0; 3], [0.0; 3]);
                if let (Some(factor), Some(at)) = (factors.get_mut(*axis), at.get_mut(*axis)) {
                    *factor = -1.0;
                    *at = *center;
                }
                Affine::diagonal(factors, at)
            }
        }
    }
}

/// What transformations come to together.
#[derive(Clone, Copy, PartialEq, Debug)]
pub struct Nested {
    forward: Affine,
    back: Affine,
}

impl Nested {
    /// Of a stack, the outermost first; `None` of an empty one.
    pub fn of(transforms: &[Transform]) -> Option<Nested> {
        if transforms.is_empty() {
            return None;
        }
        let forward = transforms.iter().fold(UNIT, |all, t| all.after(&t.affine()));
        let back = transforms.iter().fold(UNIT, |all, t| t.inverse().after(&all));
        Some(Nested { forward, back })
    }

    /// The transformed point.
    pub fn apply(&self, p: Position) -> Position {
        self.forward.apply(p)
    }

    /// The point that is transformed to `p`.
    pub fn undo(&self, p: Position) -> Position {
        self.back.apply(p)
    }

    /// A vector in a plane, transformed.
    pub fn vector(&self, plane: Plane, v: [f64; 2]) -> [f64; 2] {
        let [[aa, ab], [ba, bb]] = self.in_plane(plane);
        [aa * v[0] + ab * v[1], ba * v[0] + bb * v[1]]
    }

    /// The part that acts within a plane.
    fn in_plane(&self, plane: Plane) -> [[f64; 2]; 2] {
        let (a, b) = (plane.first().index(), plane.second().index());
        let at = |row: usize, column: usize| {
            self.forward.matrix.get(row).and_then(|row| row.get(column)).copied().unwrap_or(0.0)
        };
        [[at(a, a), at(a, b)], [at(b, a), at(b, b)]]
    }

    /// Whether the sense of arcs in a plane is reversed.
    pub fn reverses(&self, plane: Plane) -> bool {
        let [[aa, ab], [ba, bb]] = self.in_plane(plane);
        aa * bb - ab * ba < 0.0
    }

    /// The larger of the factors on the two axes of a plane, as arcs given by their radius take it.
    pub fn factor(&self, plane: Plane) -> f64 {
        let [[aa, ab], [ba, bb]] = self.in_plane(plane);
        aa.hypot(ba).max(ab.hypot(bb))
    }

    /// Whether a plane is turned out of itself.
    pub fn tilts(&self, plane: Plane) -> bool {
        let (a, b, n) = (plane.first().index(), plane.second().index(), plane.normal().index());
        let row = self.forward.matrix.get(n);
        [a, b].into_iter().any(|at| row.and_then(|row| row.get(at)).is_some_and(|v| v.abs() > LEVEL))
    }
}

/// Sine of a tilt that is rounding alone.
const LEVEL: f64 = 1e-12;

#[cfg(test)]
mod tests {
    use super::*;
    use proptest::prelude::*;

    fn rotation(x: f64, y: f64, degrees: f64) -> Transform {
        Transform::Rotation(Rotation { plane: Plane::Xy, center: [x, y], degrees })
    }

    #[test]
    fn the_latest_acts_first_and_its_centre_is_turned_too() {
        let both = Nested::of(&[rotation(0.0, 0.0, 90.0), rotation(10.0, 0.0, -90.0)]).unwrap();
        assert_eq!(both.apply(Position::xyz(20.0, 5.0, 3.0)), Position::xyz(10.0, 15.0, 3.0));
        let mirror = Nested::of(&[Transform::Mirror { axis: 0, center: 10.0 }]).unwrap();
        assert_eq!(mirror.apply(Position::xyz(15.0, 2.0, 0.0)), Position::xyz(5.0, 2.0, 0.0));
        assert!(mirror.reverses(Plane::Xy) && !mirror.reverses(Plane::Yz));
    }

    #[test]
    fn rotations_in_other_planes_follow_the_right_hand() {
        let turn =
            |plane| Nested::of(&[Transform::Rotation(Rotation { plane, center: [0.0; 2], degrees: 90.0 })]);
        assert_eq!(
            turn(Plane::Zx).unwrap().apply(Position::xyz(0.0, 0.0, 1.0)),
            Position::xyz(1.0, 0.0, 0.0)
        );
        assert_eq!(
            turn(Plane::Yz).unwrap().apply(Position::xyz(0.0, 1.0, 0.0)),
            Position::xyz(0.0, 0.0, 1.0)
        );
        assert!(turn(Plane::Zx).unwrap().tilts(Plane::Xy) && !turn(Plane::Zx).unwrap().tilts(Plane::Zx));
    }

    fn transform() -> impl Strategy<Value = Transform> {
        let center = || -100.0..100.0;
        prop_oneof![
            (center(), center(), -360.0..360.0).prop_map(|(x, y, d)| rotation(x, y, d)),
            (0.1..10.0, 0.1..10.0, center(), center())
                .prop_map(|(a, b, x, y)| Transform::Scaling { factors: [a, b, 1.0], center: [x, y, 0.0] }),
            (0usize..3, center()).prop_map(|(axis, center)| Transform::Mirror { axis, center }),
        ]
    }

    proptest! {
        #[test]
        fn undoing_brings_every_point_back(
            transforms in prop::collection::vec(transform(), 1..6),
            (x, y, z) in (-500.0..500.0, -500.0..500.0, -500.0..500.0),
        ) {
            let nested = Nested::of(&transforms).unwrap();
            let p = Position::xyz(x, y, z);
            prop_assert!(nested.undo(nested.apply(p)).distance(p) < 1e-6);
        }
    }
}
