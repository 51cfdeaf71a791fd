//! What is run slower than the feed: corners between moves, inner corners of a compensated path, arcs.
//!
//! With directions `d₁` and `d₂` the angle `θ` between two moves is 180° where the path goes straight on and 0° where
//! it turns back. A corner is slowed down for by one of two rules (GSK990MC 15#2, P144 to P146; Fanuc 1777 to 1780):
//!
//! - *angle*: if `θ ≤ θₚ` it is run at the lowest feed;
//! - *speed difference*: it is run at `D / max|d₂ − d₁|`, where no axis changes its speed by more than `D`.
//!
//! Inner corners (4.8.2) are those that turn towards the tool. They are slowed down for by the same rules, but not only
//! at the corner: in the last and the first [`REACH`] of the two moves.

use crate::limits::peak;
use ferrocut_geometry::{AXES, Plane, Position};
use ferrocut_machine::{ArcSlowdown, CornerSlowdown};
use ferrocut_toolpath::{CornerRule, InnerCorners};

/// How long an inner corner is slowed down for before it and behind it, mm (4.8.2: together 2 mm at most).
pub(crate) const REACH: f64 = 1.0;

/// On an arc no further than to the next quadrant: this part of a turn (4.8.2, 5).
pub(crate) const QUADRANT: f64 = std::f64::consts::FRAC_PI_2;

/// A path that turns by less than this goes straight on: `2°` less than half a turn is no inner corner (4.8.2, 3).
const LEAST_TURN: f64 = 2.0;

/// Which corners are slowed down for.
#[derive(Clone, Copy, Debug, PartialEq)]
pub(crate) struct Slowdown {
    rule: CornerRule,
    /// mm/s.
    lowest: f64,
}

impl Slowdown {
    pub fn new(corner: &CornerSlowdown) -> Slowdown {
        let rule = match (corner.angle, corner.speed_difference) {
            (_, Some(difference)) => CornerRule::SpeedDifference(difference),
            (angle, None) => CornerRule::Angle(angle.unwrap_or(0.0)),
        };
        Slowdown { rule, lowest: corner.lowest_feed / 60.0 }
    }

    /// Highest speed at a corner between these directions, mm/s; infinite where it is not slowed down for.
    pub fn speed(&self, before: &Position, after: &Position) -> f64 {
        match self.rule {
            CornerRule::Angle(most) if between(before, after) <= most * (1.0 + ROUNDING) => self.lowest,
            CornerRule::Angle(_) => f64::INFINITY,
            CornerRule::SpeedDifference(difference) => {
                let most = peak(&(*after - *before).0, &[1.0; AXES]);
                if most <= SAME_DIRECTION {
                    f64::INFINITY
                } else {
                    (difference / 60.0 / most).max(self.lowest)
                }
            }
        }
    }
}

/// Of an angle, so that 90° count as 90°.
const ROUNDING: f64 = 1e-9;

/// Directions that differ by less are the same but for rounding.
const SAME_DIRECTION: f64 = 1e-6;

/// Highest speed beside the corner between two moves of a compensated path, mm/s, if it is an inner corner that
/// counts.
pub(crate) fn inner_corner(corners: &InnerCorners, before: &Position, after: &Position) -> Option<f64> {
    let turns_left = cross(corners.plane, before, after) > 0.0;
    let angle = between(before, after);
    if turns_left != corners.left || !(LEAST_TURN..=180.0 - LEAST_TURN).contains(&angle) {
        return None;
    }
    let slowdown = Slowdown { rule: corners.rule, lowest: corners.lowest_feed / 60.0 };
    Some(slowdown.speed(before, after)).filter(|speed| speed.is_finite())
}

/// Highest speed on an arc of this radius, mm/s.
pub(crate) fn on_arc(arc: &ArcSlowdown, radius: f64) -> f64 {
    (arc.acceleration * radius).sqrt().max(arc.lowest_feed / 60.0)
}

/// The angle between two moves with these directions, degrees.
fn between(before: &Position, after: &Position) -> f64 {
    let (a, b) = (unit(before), unit(after));
    let (Some(a), Some(b)) = (a, b) else { return 180.0 };
    let (mut apart, mut together) = (0.0_f64, 0.0_f64);
    for i in 0..3 {
        apart += (b[i] - a[i]).powi(2);
        together += (b[i] + a[i]).powi(2);
    }
    // Good for small angles and large ones.
    180.0 - 2.0 * apart.sqrt().atan2(together.sqrt()).to_degrees()
}

/// X, Y, Z of a direction at unit length.
fn unit(d: &Position) -> Option<[f64; 3]> {
    let [x, y, z, ..] = d.0;
    let len = x.hypot(y).hypot(z);
    (len > 0.0).then(|| [x / len, y / len, z / len])
}

/// Above 0 where the path turns left, seen onto the plane.
fn cross(plane: Plane, before: &Position, after: &Position) -> f64 {
    let ([a, b], [c, d]) = (plane.of(*before), plane.of(*after));
    a * d - b * c
}

#[cfg(test)]
mod tests {
    use super::*;

    fn at(degrees: f64) -> Position {
        Position::xyz(degrees.to_radians().cos(), degrees.to_radians().sin(), 0.0)
    }

    #[test]
    fn straight_on_is_half_a_turn() {
        for turn in [0.0, 1e-4, 30.0, 90.0, 179.0, 180.0] {
            assert!((between(&at(20.0), &at(20.0 + turn)) - (180.0 - turn)).abs() < 1e-9, "{turn}");
        }
    }

    #[test]
    fn a_corner_is_slowed_down_for_by_angle_or_by_speed_difference() {
        let by_angle = Slowdown { rule: CornerRule::Angle(90.0), lowest: 2.0 };
        assert_eq!(by_angle.speed(&at(0.0), &at(90.0)), 2.0);
        assert_eq!(by_angle.speed(&at(0.0), &at(89.0)), f64::INFINITY);
        // A turn of 90° changes X and Y by the whole speed each; one of 60° X by a half and Y by 0.866.
        let by_difference = Slowdown { rule: CornerRule::SpeedDifference(600.0), lowest: 2.0 };
        assert!((by_difference.speed(&at(0.0), &at(90.0)) - 10.0).abs() < 1e-9);
        assert!((by_difference.speed(&at(0.0), &at(60.0)) - 10.0 / 0.75_f64.sqrt()).abs() < 1e-9);
        assert_eq!(by_difference.speed(&at(0.0), &at(0.0)), f64::INFINITY);
        let slow = Slowdown { rule: CornerRule::SpeedDifference(60.0), lowest: 2.0 };
        assert_eq!(slow.speed(&at(0.0), &at(90.0)), 2.0);
    }

    #[test]
    fn inner_corners_turn_towards_the_tool() {
        let rule = CornerRule::Angle(100.0);
        let left = InnerCorners { plane: Plane::Xy, left: true, rule, lowest_feed: 120.0 };
        let right = InnerCorners { left: false, ..left };
        assert_eq!(inner_corner(&left, &at(0.0), &at(90.0)), Some(2.0));
        assert_eq!(inner_corner(&left, &at(0.0), &at(-90.0)), None);
        assert_eq!(inner_corner(&right, &at(0.0), &at(-90.0)), Some(2.0));
        assert_eq!(inner_corner(&left, &at(0.0), &at(79.0)), None);
        // Less than 2° or more than 178° count for nothing.
        let all = InnerCorners { rule: CornerRule::Angle(178.0), ..left };
        let turns = [1.0, 3.0, 177.0, 179.0].map(|turn| inner_corner(&all, &at(0.0), &at(turn)).is_some());
        assert_eq!(turns, [false, true, true, false]);
        // In the ZX plane the first axis is Z.
        let zx = InnerCorners { plane: Plane::Zx, ..left };
        let (x, z) = (Position::xyz(1.0, 0.0, 0.0), Position::xyz(0.0, 0.0, 1.0));
        assert_eq!(inner_corner(&zx, &z, &x), Some(2.0));
        assert_eq!(inner_corner(&zx, &x, &z), None);
    }

    #[test]
    fn arcs_have_an_acceleration_towards_their_centre() {
        let arc = ArcSlowdown { acceleration: 1000.0, lowest_feed: 600.0 };
        assert_eq!(on_arc(&arc, 10.0), 100.0);
        assert_eq!(on_arc(&arc, 0.001), 10.0);
    }
}
