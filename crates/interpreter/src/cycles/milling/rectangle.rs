//! Clearing a rectangular area, and its contour with round or sharp corners.

use super::count::steps;
use super::cutter::{Cutter, CycleMove};
use crate::cycles::tool::Take;
use ferrocut_geometry::SAME_POINT_MM;
use std::f64::consts::{FRAC_1_SQRT_2, FRAC_PI_2};

/// The path of the tool centre around a rectangle about the origin.
#[derive(Clone, Copy, PartialEq, Debug)]
pub struct Rectangle {
    /// Half the sizes in u and v, mm.
    pub half: [f64; 2],
    /// Radius of the corners, 0 for sharp ones, at most the smaller half, mm.
    pub corner: f64,
}

impl Rectangle {
    /// Once round, from (half u, 0) on the +u side.
    pub fn contour<S: Take<CycleMove>>(&self, cutter: &mut Cutter<'_, S>) -> Result<(), S::Error> {
        let [a, b] = self.half;
        let c = self.corner;
        for [u, v] in [[1.0, 1.0], [-1.0, 1.0], [-1.0, -1.0], [1.0, -1.0]] {
            let center = [u * (a - c), v * (b - c)];
            let (beside, above) = ([u * a, v * (b - c)], [u * (a - c), v * b]);
            // Upward along a side of u, in quadrants 1 and 3, the corner begins beside its centre.
            let (start, end) = if u == v { (beside, above) } else { (above, beside) };
            cutter.feed(start)?;
            cutter.arc(end, center, FRAC_PI_2)?;
        }
        cutter.feed([a, 0.0])
    }

    /// Takes the tool centre from the origin over the whole area.
    ///
    /// First along the middle line, then round rectangles that lie `step` further out each time
    /// (GSK990MC 4.6.4 ⑸). Their corners grow in proportion from sharp to [`Rectangle::corner`]: half
    /// way out they have half its radius, as in figure 4-6-4-1. The way from one to the next is
    /// straight, at the middle of a short side.
    pub fn clear<S: Take<CycleMove>>(&self, cutter: &mut Cutter<'_, S>, step: f64) -> Result<(), S::Error> {
        let [a, b] = self.half;
        if a < b {
            let turned = Rectangle { half: [b, a], corner: self.corner };
            return cutter.turned(1, |cutter| turned.clear_along(cutter, step));
        }
        // A tool that came to the middle from −u goes on to +u first.
        cutter.turned(2, |cutter| self.clear_along(cutter, step))
    }

    fn clear_along<S: Take<CycleMove>>(&self, cutter: &mut Cutter<'_, S>, step: f64) -> Result<(), S::Error> {
        let [a, b] = self.half;
        let line = a - b;
        cutter.feed([-line, 0.0])?;
        cutter.feed([line, 0.0])?;
        let rings = rings(b, step) as u32;
        for n in 1..=rings {
            let out = if n == rings { b } else { f64::from(n) * step };
            let ring = Rectangle { half: [line + out, out], corner: self.corner * (out / b) };
            cutter.feed([line + out, 0.0])?;
            ring.contour(cutter)?;
        }
        Ok(())
    }

    /// Number of moves that [`Rectangle::clear`] takes at most.
    pub fn moves(&self, step: f64) -> f64 {
        let [a, b] = self.half;
        2.0 + 10.0 * rings(a.min(b), step)
    }
}

/// The widest step at which [`Rectangle::clear`] leaves nothing standing.
///
/// Along a side passes may lie a diameter 2r apart. At the corners they lie √2 further, and between a
/// ring with corner radius c₁ and the next with c₂, a step s apart, the whole diagonal is cut only if
///
/// ```text
/// s − r ≤ r/√2 − c₁(1 − 1/√2) + max(c₂ − r, 0)·(1 − 1/√2)
/// ```
///
/// which, as the corners grow outward, holds for s ≤ r(1 + 1/√2) − min(c, r)(1 − 1/√2): between 1.41 and
/// 1.71 of the tool radius. A wider step, though legal, would leave an island on every diagonal.
pub fn widest_step(tool_radius: f64, corner: f64) -> f64 {
    tool_radius * (1.0 + FRAC_1_SQRT_2) - corner.min(tool_radius) * (1.0 - FRAC_1_SQRT_2)
}

fn rings(out: f64, step: f64) -> f64 {
    if out <= SAME_POINT_MM { 0.0 } else { steps(out, step) }
}
