//! The sheet of paper: a canvas with the inks, line widths and text sizes of the whole picture.
//!
//! Lengths are given in units of a picture 1600 wide and grow with the width.

use super::canvas::{Canvas, Lines, Pen, Point, Rect};
use super::font::{self, Align};
use super::labels::Labels;
use super::ramp::Colour;

/// Ground of the sheet.
pub const PAPER: Colour = [0xfb, 0xfb, 0xfc];
/// Ground of the panels.
pub const PANEL: Colour = [0xff, 0xff, 0xff];
/// Titles, numbers of the part.
pub const INK: Colour = [0x22, 0x28, 0x31];
/// Labels, scales.
pub const SOFT: Colour = [0x5c, 0x65, 0x72];
/// Frames, boxes.
pub const FAINT: Colour = [0xc4, 0xca, 0xd2];
/// The grid.
pub const GRID: Colour = [0xec, 0xee, 0xf1];

/// Size of labels, units.
pub const LABEL: f64 = 13.0;

/// Width of a picture of unit 1.
const FULL_WIDTH: f64 = 1600.0;
/// Part of the text's size that its strokes are wide.
const STROKE: f64 = 0.085;

/// A canvas being drawn on.
pub struct Sheet<'a, C> {
    /// The canvas itself.
    pub canvas: &'a mut C,
    /// What its labels say.
    pub labels: &'a Labels,
    unit: f64,
}

impl<'a, C: Canvas> Sheet<'a, C> {
    /// A canvas of this width, pixels.
    pub fn new(canvas: &'a mut C, labels: &'a Labels, width: u32) -> Sheet<'a, C> {
        Sheet { canvas, labels, unit: f64::from(width) / FULL_WIDTH }
    }

    /// Pixels of a length in units.
    pub fn px(&self, units: f64) -> f64 {
        units * self.unit
    }

    /// A rectangle in pixels, given in units.
    pub fn area(&self, x: f64, y: f64, width: f64, height: f64) -> Rect {
        Rect { x: self.px(x), y: self.px(y), width: self.px(width), height: self.px(height) }
    }

    /// An unbroken line of a width in units; never thinner than can be seen.
    pub fn pen(&self, colour: Colour, width: f64) -> Pen {
        const THINNEST_PX: f64 = 0.6;
        Pen::solid(colour, self.px(width).max(THINNEST_PX))
    }

    /// Writes a text; `at` in pixels, `size` in units.
    pub fn text(&mut self, text: &str, at: Point, size: f64, align: Align, colour: Colour) {
        self.sloped(text, at, size, align, colour, 0.0);
    }

    /// Writes a text turned about its place, radians, counter-clockwise.
    pub fn sloped(&mut self, text: &str, at: Point, size: f64, align: Align, colour: Colour, slope: f64) {
        let px = self.px(size);
        if !font::has(text) && self.canvas.letters(text, at, px, align, slope, colour) {
            return;
        }
        let mut lines = Lines::default();
        font::write(&mut lines, text, at, self.px(size), align, slope);
        let pen = self.pen(colour, size * STROKE);
        self.canvas.stroke(&lines, &pen);
    }

    /// Width of a text of a size in units, pixels.
    pub fn text_width(&self, text: &str, size: f64) -> f64 {
        font::width(text, self.px(size))
    }

    /// Draws a line that ends in an arrow head; `head` in units.
    pub fn arrow(&mut self, from: Point, to: Point, colour: Colour, width: f64, head: f64) {
        let d = [to[0] - from[0], to[1] - from[1]];
        let length = d[0].hypot(d[1]);
        if length <= 0.0 {
            return;
        }
        let (along, half) = (self.px(head) / length, self.px(head) * 0.32 / length);
        let neck = [to[0] - d[0] * along, to[1] - d[1] * along];
        let pen = self.pen(colour, width);
        self.canvas.line(from, neck, &pen);
        let wings = [
            [neck[0] - d[1] * half, neck[1] + d[0] * half],
            to,
            [neck[0] + d[1] * half, neck[1] - d[0] * half],
        ];
        self.canvas.fill(&wings, colour);
    }
}
