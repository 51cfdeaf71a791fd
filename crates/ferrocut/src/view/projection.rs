//! Points of space onto the picture.
//!
//! In the top view X goes right and Y up. In the isometric view the eye stands in front, to the right
//! and above, 35.264° over the table: X goes to the right and down, Y to the right and up, Z up, and
//! equal lengths along the three axes look equal (ISO 5456-3).

use super::canvas::{Point, Rect};
use super::extent::{Extent, Point3};

/// Where the eye stands.
#[derive(Clone, Copy, PartialEq, Eq, Debug)]
pub enum View {
    /// Above, looking down on X and Y.
    Top,
    /// In front, to the right and above.
    Isometric,
}

/// cos 45°.
const COS_45: f64 = std::f64::consts::FRAC_1_SQRT_2;
/// sin 35.264° = 1/√3: how much of a length along the table goes up the picture, after the 45°.
const SIN_TILT: f64 = 0.577_350_269_189_625_8;
/// cos 35.264° = √(2/3): how much of a height is seen.
const COS_TILT: f64 = 0.816_496_580_927_726;

impl View {
    /// The point on the picture's plane, mm; second coordinate up.
    pub fn flat(self, [x, y, z]: Point3) -> Point {
        match self {
            View::Top => [x, y],
            View::Isometric => [(x + y) * COS_45, (y - x) * COS_45 * SIN_TILT + z * COS_TILT],
        }
    }

    /// How long a millimetre along an axis is in the picture's plane, mm.
    pub fn foreshortening(self) -> f64 {
        match self {
            View::Top => 1.0,
            View::Isometric => COS_TILT,
        }
    }
}

/// A view at a scale.
#[derive(Clone, Copy, Debug)]
pub struct Projection {
    /// Where the eye stands.
    pub view: View,
    /// Pixels of a millimetre of the picture's plane.
    pub scale: f64,
    middle: Point,
    at: Point,
}

/// Side of the box shown where there is but a point in space, mm. Where there is but a point in this
/// view, the box is as wide as it is deep.
const SMALLEST: f64 = 1.0;

impl Projection {
    /// The largest picture of `extent` that fits into `area`, in its middle.
    pub fn fit(view: View, extent: &Extent, area: Rect) -> Projection {
        let (mut low, mut high) = ([f64::INFINITY; 2], [f64::NEG_INFINITY; 2]);
        for corner in extent.corners() {
            let p = view.flat(corner);
            low = [low[0].min(p[0]), low[1].min(p[1])];
            high = [high[0].max(p[0]), high[1].max(p[1])];
        }
        let size = [high[0] - low[0], high[1] - low[1]];
        // What f64 cannot tell apart at this distance from zero cannot be shown larger either.
        let finest = low.iter().chain(&high).fold(0.0, |m: f64, c| m.max(c.abs())) * 1e-12;
        let room = if extent.longest() > 0.0 { extent.longest() } else { SMALLEST };
        let smallest = if size[0].max(size[1]) > finest { 0.0 } else { room.max(finest) };
        let size = size.map(|s| s.max(smallest).max(f64::MIN_POSITIVE));
        let scale = (area.width / size[0]).min(area.height / size[1]);
        let middle = [(low[0] + high[0]) / 2.0, (low[1] + high[1]) / 2.0];
        let at = [area.x + area.width / 2.0, area.y + area.height / 2.0];
        Projection { view, scale, middle, at }
    }

    /// The pixel of a point.
    pub fn pixel(&self, p: Point3) -> Point {
        let flat = self.view.flat(p);
        let right = (flat[0] - self.middle[0]) * self.scale;
        let up = (flat[1] - self.middle[1]) * self.scale;
        [self.at[0] + right, self.at[1] - up]
    }

    /// The first coordinate (of the top view: X) at a pixel column.
    pub fn across_at(&self, x: f64) -> f64 {
        self.middle[0] + (x - self.at[0]) / self.scale
    }

    /// The second coordinate (of the top view: Y) at a pixel row.
    pub fn up_at(&self, y: f64) -> f64 {
        self.middle[1] - (y - self.at[1]) / self.scale
    }

    /// Pixels of a millimetre along an axis.
    pub fn along_axis(&self) -> f64 {
        self.scale * self.view.foreshortening()
    }
}

#[cfg(test)]
mod tests {
    use super::*;
    use proptest::prelude::*;

    fn near(a: Point, b: Point) -> bool {
        (a[0] - b[0]).hypot(a[1] - b[1]) < 1e-12
    }

    #[test]
    fn isometric_axes_look_equally_long_and_stand_at_30_degrees() {
        let (sin, cos) = 30_f64.to_radians().sin_cos();
        let long = COS_TILT;
        assert!(near(View::Isometric.flat([1.0, 0.0, 0.0]), [cos * long, -sin * long]));
        assert!(near(View::Isometric.flat([0.0, 1.0, 0.0]), [cos * long, sin * long]));
        assert!(near(View::Isometric.flat([0.0, 0.0, 1.0]), [0.0, long]));
    }

    const AREA: Rect = Rect { x: 100.0, y: 50.0, width: 300.0, height: 200.0 };

    #[test]
    fn the_top_view_has_x_to_the_right_and_y_up() {
        let extent = Extent { min: [0.0; 3], max: [30.0, 10.0, 5.0] };
        let top = Projection::fit(View::Top, &extent, AREA);
        assert_eq!(top.scale, 10.0);
        assert_eq!(top.pixel([0.0, 0.0, 0.0]), [100.0, 200.0]);
        assert_eq!(top.pixel([30.0, 10.0, 9.0]), [400.0, 100.0]);
        assert_eq!((top.across_at(400.0), top.up_at(100.0)), (30.0, 10.0));
    }

    #[test]
    fn a_point_is_shown_in_the_middle() {
        for p in [[0.0; 3], [1e8, -1e8, 1e8], [1e15; 3]] {
            let point = Extent { min: p, max: p };
            for view in [View::Top, View::Isometric] {
                let projection = Projection::fit(view, &point, AREA);
                assert!(projection.scale.is_finite());
                assert_eq!(projection.pixel(p), [250.0, 150.0]);
            }
        }
    }

    proptest! {
        #[test]
        fn everything_fits(
            a in [-1e9..1e9f64, -1e9..1e9f64, -1e9..1e9f64],
            b in [-1e9..1e9f64, -1e9..1e9f64, -1e9..1e9f64],
        ) {
            let mut extent = Extent::EMPTY;
            extent.add(a);
            extent.add(b);
            for view in [View::Top, View::Isometric] {
                let projection = Projection::fit(view, &extent, AREA);
                for corner in extent.corners() {
                    let [x, y] = projection.pixel(corner);
                    prop_assert!(x > AREA.x - 0.01 && x < AREA.x + AREA.width + 0.01);
                    prop_assert!(y > AREA.y - 0.01 && y < AREA.y + AREA.height + 0.01);
                }
            }
        }
    }
}
