//! Paths of the tool centre round a rectangle or circle about the origin.

use crate::cycles::tool::{Frame, Take, Tool};
use ferrocut_geometry::SAME_POINT_MM;

/// What the corners of a rectangle are like.
#[derive(Clone, Copy, PartialEq, Debug)]
pub enum Corner {
    /// Sharp.
    Sharp,
    /// Round, with this radius.
    Round(f64),
    /// Cut off, so much along either side.
    Chamfer(f64),
}

/// A rectangle; with round corners as large as its halves, a circle. mm.
#[derive(Clone, Copy, PartialEq, Debug)]
pub struct Outline {
    /// Half the sizes in u and v.
    pub half: [f64; 2],
    /// Its corners.
    pub corner: Corner,
}

/// By how much a chamfer gets shorter, along either side, when the sides move in by 1: both it and its
/// neighbours move, and they meet at 135°: 2 − √2.
const CHAMFER: f64 = 2.0 - std::f64::consts::SQRT_2;

impl Outline {
    /// A circle.
    pub fn circle(radius: f64) -> Outline {
        Outline { half: [radius; 2], corner: Corner::Round(radius) }
    }

    /// Whether it is a circle.
    pub fn is_circle(&self) -> bool {
        let [a, b] = self.half;
        matches!(self.corner, Corner::Round(r) if (a - r).abs() <= SAME_POINT_MM && (b - r).abs() <= SAME_POINT_MM)
    }

    /// The path inside it at a distance. A corner that gets too small for the distance is sharp then.
    pub fn inset(&self, distance: f64) -> Outline {
        let corner = match self.corner {
            Corner::Sharp => Corner::Sharp,
            Corner::Round(r) if r - distance > SAME_POINT_MM => Corner::Round(r - distance),
            Corner::Chamfer(c) if c - CHAMFER * distance > SAME_POINT_MM => {
                Corner::Chamfer(c - CHAMFER * distance)
            }
            _ => Corner::Sharp,
        };
        let half = self.half.map(|h| (h - distance).max(0.0));
        let Corner::Chamfer(c) = corner else { return Outline { half, corner } };
        // Chamfers close on each other before the sides do where they leave little of a side.
        let sum = (half[0] + half[1] - c).max(0.0);
        let half = half.map(|h| h.min(sum));
        Outline { half, corner: Corner::Chamfer(half[0] + half[1] - sum) }
    }

    /// The largest circle within it, by its radius.
    pub fn room(&self) -> f64 {
        let [a, b] = self.half;
        match self.corner {
            Corner::Chamfer(c) => a.min(b).min((a + b - c) / std::f64::consts::SQRT_2),
            _ => a.min(b),
        }
    }

    /// The path round it at a distance, whose sides go out by `side` at most: beyond that only its corners
    /// grow, until they are sharp. A sharp corner is gone round on an arc.
    ///
    /// On the diagonal of a corner consecutive paths lie as far apart as their distances, whatever `side` is:
    /// so passes may go on until they have covered the square corner of a block around the outline.
    pub fn outset(&self, distance: f64, side: f64) -> Outline {
        let out = distance.min(side);
        let sqrt2 = std::f64::consts::SQRT_2;
        let rounded = |r: f64| r + (sqrt2 * out - distance) / (sqrt2 - 1.0);
        let corner = match self.corner {
            Corner::Sharp => Corner::Round(rounded(0.0)),
            Corner::Round(r) => Corner::Round(rounded(r)),
            Corner::Chamfer(c) => Corner::Chamfer(c + 2.0 * out - sqrt2 * distance),
        };
        let corner = match corner {
            Corner::Round(r) | Corner::Chamfer(r) if r <= SAME_POINT_MM => Corner::Sharp,
            corner => corner,
        };
        Outline { half: self.half.map(|h| h + out), corner }
    }

    /// The distance at which [`outset`](Self::outset) with this `side` has sharp corners.
    pub fn sharp_at(&self, side: f64) -> f64 {
        let sqrt2 = std::f64::consts::SQRT_2;
        match self.corner {
            Corner::Sharp => sqrt2 * side,
            Corner::Round(r) => sqrt2 * side + r * (sqrt2 - 1.0),
            Corner::Chamfer(c) => (c + 2.0 * side) / sqrt2,
        }
    }

    /// The same in [its own frame](Self::frame): u along the longer side.
    pub fn lengthwise(&self) -> Outline {
        let [a, b] = self.half;
        if self.is_lengthwise() { *self } else { Outline { half: [b, a], ..*self } }
    }

    /// The frame whose u lies along the longer side, from the one that the outline is given in.
    pub fn frame(&self, given: Frame) -> Frame {
        if self.is_lengthwise() { given } else { given.quarter_turned() }
    }

    fn is_lengthwise(&self) -> bool {
        let [a, b] = self.half;
        a >= b
    }

    /// Where [`contour`](Self::contour) begins and ends: the middle of the side in −v.
    pub fn start(&self) -> [f64; 2] {
        [0.0, -self.half[1]]
    }

    /// Once round from [`start`](Self::start), counter-clockwise in the frame. A circle is one arc.
    pub fn contour<T: Take>(&self, tool: &mut Tool<'_, T>) -> Result<(), T::Error> {
        if self.is_circle() {
            let z = tool.z();
            return tool.turns([0.0; 2], 1.0, z);
        }
        let [a, b] = self.half;
        // Corner, direction towards it, direction away from it.
        let corners = [
            ([a, -b], [1.0, 0.0], [0.0, 1.0]),
            ([a, b], [0.0, 1.0], [-1.0, 0.0]),
            ([-a, b], [-1.0, 0.0], [0.0, -1.0]),
            ([-a, -b], [0.0, -1.0], [1.0, 0.0]),
        ];
        for ([x, y], [ix, iy], [ox, oy]) in corners {
            let size = match self.corner {
                Corner::Sharp => 0.0,
                Corner::Round(size) | Corner::Chamfer(size) => size,
            };
            let (before, after) = ([x - ix * size, y - iy * size], [x + ox * size, y + oy * size]);
            tool.feed(before)?;
            match self.corner {
                Corner::Sharp => {}
                Corner::Round(_) => {
                    tool.quarter(after, [x - ix * size + ox * size, y - iy * size + oy * size])?;
                }
                Corner::Chamfer(_) => tool.feed(after)?,
            }
        }
        tool.feed(self.start())
    }

    /// Radius of a quarter circle that runs into the middle of the side in −v from inside: no more than half of the way to there, or
    /// where it begins would lie on the contour itself.
    pub fn lead_inside(&self, wanted: f64) -> f64 {
        let [a, b] = self.half;
        let room = match self.corner {
            // The circle must clear the cut-off corners too.
            Corner::Chamfer(c) => (0.5 * b).min((a - c) * (1.0 + std::f64::consts::SQRT_2)),
            _ => 0.5 * b,
        };
        wanted.min(room).max(0.0)
    }

    /// Once round, entered and left tangentially from inside.
    pub fn finish_inside<T: Take>(&self, tool: &mut Tool<'_, T>, lead: f64) -> Result<(), T::Error> {
        let lead = self.lead_inside(lead);
        let [_, v] = self.start();
        tool.feed([-lead, v + lead])?;
        tool.quarter([0.0, v], [0.0, v + lead])?;
        self.contour(tool)?;
        tool.quarter([lead, v + lead], [0.0, v + lead])
    }

    /// Once round, entered and left tangentially from outside, from and to a point `lead` off its start.
    pub fn finish_outside<T: Take>(&self, tool: &mut Tool<'_, T>, lead: f64) -> Result<(), T::Error> {
        let [_, v] = self.start();
        let quarter = std::f64::consts::FRAC_PI_2;
        tool.feed([-lead, v - lead])?;
        tool.arc([0.0, v], [0.0, v - lead], -quarter)?;
        self.contour(tool)?;
        tool.arc([lead, v - lead], [0.0, v - lead], -quarter)
    }
}
