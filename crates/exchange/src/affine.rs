//! Placing in space: the transforms that blocks and tilted entities of a DXF drawing bring along.

/// A point or vector of space.
pub type Vector = [f64; 3];

/// `p ↦ x·p₀ + y·p₁ + z·p₂ + origin`.
#[derive(Clone, Copy, PartialEq, Debug)]
pub struct Affine {
    /// Where the unit vectors go.
    pub axes: [Vector; 3],
    /// Where the zero goes.
    pub origin: Vector,
}

impl Affine {
    /// Leaves everything where it is.
    pub const IDENTITY: Affine =
        Affine { axes: [[1.0, 0.0, 0.0], [0.0, 1.0, 0.0], [0.0, 0.0, 1.0]], origin: [0.0; 3] };

    /// Stretches each axis.
    pub fn scale(by: Vector) -> Affine {
        let [x, y, z] = by;
        Affine { axes: [[x, 0.0, 0.0], [0.0, y, 0.0], [0.0, 0.0, z]], origin: [0.0; 3] }
    }

    /// Moves.
    pub fn shift(by: Vector) -> Affine {
        Affine { origin: by, ..Affine::IDENTITY }
    }

    /// Turns about Z, degrees. Whole quarters are exact.
    pub fn turn(degrees: f64) -> Affine {
        let (sin, cos) = sin_cos(degrees);
        Affine { axes: [[cos, sin, 0.0], [-sin, cos, 0.0], [0.0, 0.0, 1.0]], origin: [0.0; 3] }
    }

    /// The coordinate system of an entity with this extrusion direction (the "arbitrary axis" rule of
    /// the DXF reference: X lies in the XY plane, or where the direction is nearly Z, square to Y).
    pub fn extrusion(normal: Vector) -> Affine {
        const NEARLY_Z: f64 = 1.0 / 64.0;
        let length = norm(normal);
        if length == 0.0 || normal == [0.0, 0.0, 1.0] {
            return Affine::IDENTITY;
        }
        let z = normal.map(|c| c / length);
        let helper =
            if z[0].abs() < NEARLY_Z && z[1].abs() < NEARLY_Z { [0.0, 1.0, 0.0] } else { [0.0, 0.0, 1.0] };
        let x = vector_product(helper, z);
        let length = norm(x);
        let x = x.map(|c| c / length);
        Affine { axes: [x, vector_product(z, x), z], origin: [0.0; 3] }
    }

    /// A vector, which has no place.
    pub fn vector(&self, v: Vector) -> Vector {
        let [x, y, z] = self.axes;
        std::array::from_fn(|i| x[i] * v[0] + y[i] * v[1] + z[i] * v[2])
    }

    /// A point.
    pub fn point(&self, p: Vector) -> Vector {
        let v = self.vector(p);
        std::array::from_fn(|i| v[i] + self.origin[i])
    }

    /// First `inner`, then this.
    pub fn after(&self, inner: &Affine) -> Affine {
        Affine { axes: inner.axes.map(|axis| self.vector(axis)), origin: self.point(inner.origin) }
    }
}

/// Sine and cosine of degrees, exact for whole quarters.
pub fn sin_cos(degrees: f64) -> (f64, f64) {
    let turned = degrees % 360.0;
    match turned {
        0.0 => (0.0, 1.0),
        90.0 | -270.0 => (1.0, 0.0),
        180.0 | -180.0 => (0.0, -1.0),
        270.0 | -90.0 => (-1.0, 0.0),
        _ => turned.to_radians().sin_cos(),
    }
}

/// The length of a vector.
pub fn norm(v: Vector) -> f64 {
    v[0].hypot(v[1]).hypot(v[2])
}

/// The vector square to both.
pub fn vector_product(a: Vector, b: Vector) -> Vector {
    [a[1] * b[2] - a[2] * b[1], a[2] * b[0] - a[0] * b[2], a[0] * b[1] - a[1] * b[0]]
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn the_order_of_transforms() {
        let both = Affine::shift([1.0, 2.0, 0.0]).after(&Affine::turn(90.0));
        assert_eq!(both.point([3.0, 0.0, 5.0]), [1.0, 5.0, 5.0]);
        let both = Affine::turn(-90.0).after(&Affine::scale([2.0, -1.0, 1.0]));
        assert_eq!(both.point([1.0, 1.0, 0.0]), [-1.0, -2.0, 0.0]);
    }

    #[test]
    fn looked_at_from_below_x_is_mirrored() {
        let below = Affine::extrusion([0.0, 0.0, -1.0]);
        assert_eq!(below.point([3.0, 4.0, 5.0]), [-3.0, 4.0, -5.0]);
    }
}
