//! Meeting a wall without a mark: half circles onto the contour and off it.
//!
//! The contour is passed in +v at the point (w, 0). From a start at (s, 0) beside it a half circle on
//! the diameter between the two arrives there in +v, whichever side it comes from, and its mirror image
//! leads back:
//!
//! ```text
//!   inside, s < w: turns as the contour does        outside, s > w: turns against it
//!
//!        ╭─4─╮ │                                         │ ╭─4─╮
//!        s     w ▲                                       w     s
//!        ╰─1─╯ │                                         │ ╰─1─╯
//! ```
//!
//! This is how the GSK990MC describes it: the same sense inside (4.6.2), the opposite outside (4.6.3:
//! "transition arcs and finishing arc differ in direction").

use super::cutter::{Cutter, CycleMove};
use crate::cycles::tool::Take;

/// The way from a start beside a wall onto it and back.
#[derive(Clone, Copy, PartialEq, Debug)]
pub struct Tangent {
    /// u of the start.
    pub start: f64,
    /// u of the contour.
    pub wall: f64,
    /// Largest radius of the half circles, mm. Where the start lies further off, a straight line leads
    /// to them.
    pub largest: f64,
}

impl Tangent {
    /// From the start onto the contour.
    pub fn approach<S: Take<CycleMove>>(&self, cutter: &mut Cutter<'_, S>) -> Result<(), S::Error> {
        let foot = self.foot();
        cutter.feed([foot, 0.0])?;
        cutter.half_circle([self.wall, 0.0], [(foot + self.wall) / 2.0, 0.0], self.wall - foot)
    }

    /// From the contour back to the start.
    pub fn departure<S: Take<CycleMove>>(&self, cutter: &mut Cutter<'_, S>) -> Result<(), S::Error> {
        let foot = self.foot();
        cutter.half_circle([foot, 0.0], [(foot + self.wall) / 2.0, 0.0], self.wall - foot)?;
        cutter.feed([self.start, 0.0])
    }

    /// u where line and half circle meet.
    fn foot(&self) -> f64 {
        let away = self.start - self.wall;
        if away.abs() <= 2.0 * self.largest {
            self.start
        } else {
            self.wall + (2.0 * self.largest).copysign(away)
        }
    }
}
