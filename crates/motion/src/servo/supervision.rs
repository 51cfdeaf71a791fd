//! What is watched every period: that an axis stays inside its software limits, follows its command and comes
//! to its place.
//!
//! The limits of the way are checked before a move begins. Here they are the last guard: no axis goes on beyond
//! them, whatever the reason.

use super::Kind;
use ferrocut_geometry::Axis;
use ferrocut_machine::AxisConfig;

/// What is wrong with an axis.
#[derive(Clone, Copy, PartialEq, Debug)]
pub struct ServoFault {
    /// The axis.
    pub axis: Axis,
    /// What.
    pub kind: ServoFaultKind,
    /// What was measured, mm (degrees): the machine position of the axis, or its distance from the command.
    pub value: f64,
    /// What it must not pass.
    pub limit: f64,
}

/// What can be wrong with an axis in a period.
#[derive(Clone, Copy, PartialEq, Eq, Debug)]
pub enum ServoFaultKind {
    /// Beyond its lower software limit and going on.
    BelowLimit,
    /// Beyond its upper software limit and going on.
    AboveLimit,
    /// Too far behind its command (GSK990MC alarm 0121).
    FollowingError,
    /// Not in position in time after a stop.
    NotInPosition,
    /// Where the control has no point of pitch-error compensation (GSK990MC alarm 0016).
    BesidePitchPoints,
}

/// How far the axes may pass a limit before the guard acts, mm (degrees), in addition to the path tolerance:
/// more than what sums of decimals leave at a move that ends on the limit.
const MARGIN: f64 = 1e-3;

/// The limits of one axis.
#[derive(Clone, Copy, Debug)]
pub(crate) struct Watch {
    min: f64,
    max: f64,
    /// Whether they hold: not before the machine knows where the axis is.
    limited: bool,
    pub following_error: f64,
    /// Width of being in position after positioning and moving by hand, and after cutting.
    in_position: [f64; 2],
}

impl Watch {
    /// The limits of an axis whose path may leave the programmed one by `tolerance`. A following error of 0 is not
    /// watched.
    pub fn new(axis: &AxisConfig, tolerance: f64) -> Watch {
        let margin = tolerance + MARGIN;
        let cutting = axis.in_position_cutting.unwrap_or(axis.in_position);
        Watch {
            min: axis.min - margin,
            max: axis.max + margin,
            limited: true,
            following_error: axis.following_error,
            in_position: [axis.in_position, cutting],
        }
    }

    /// Whether the software limits hold.
    pub fn set_travel(&mut self, holds: bool) {
        self.limited = holds;
    }

    /// Distance from the command within which an axis is in position; 0 is not watched.
    #[inline]
    pub fn width(&self, kind: Kind) -> f64 {
        let [other, cutting] = self.in_position;
        if matches!(kind, Kind::Cutting | Kind::Tapping) { cutting } else { other }
    }

    /// An axis that moved by `d` to `at`. Beyond a limit only moves back are let pass.
    #[inline]
    pub fn travel(&self, d: f64, at: f64) -> Option<(ServoFaultKind, f64)> {
        if !self.limited {
            None
        } else if at > self.max && d > 0.0 {
            Some((ServoFaultKind::AboveLimit, self.max))
        } else if at < self.min && d < 0.0 {
            Some((ServoFaultKind::BelowLimit, self.min))
        } else {
            None
        }
    }

    /// An axis at a distance from its command; one that is no number has failed too.
    #[inline]
    pub fn follows(&self, distance: f64) -> bool {
        self.following_error == 0.0 || distance <= self.following_error
    }

    /// Whether an axis at a distance from its command is in position after a movement of this kind.
    #[inline]
    pub fn is_in_position(&self, distance: f64, kind: Kind) -> bool {
        let width = self.width(kind);
        width == 0.0 || distance <= width
    }
}
