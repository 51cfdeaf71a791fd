//! A canvas of pixels, saved as PNG.

use super::ViewError;
use super::canvas::{Canvas, Lines, Pen, Point};
use super::ramp::Colour;
use tiny_skia::{
    Color, FillRule, LineCap, LineJoin, Paint, PathBuilder, Pixmap, Stroke, StrokeDash, Transform,
};

/// A picture of pixels.
pub struct PngCanvas {
    pixels: Pixmap,
}

/// Points in one path. Filling a path takes time with the lines that cross each row, so many short
/// paths are faster than a long one.
const LONG_PATH: usize = 512;

impl PngCanvas {
    /// An empty picture.
    pub fn new(width: u32, height: u32) -> Result<PngCanvas, ViewError> {
        let mut pixels = Pixmap::new(width, height).ok_or(ViewError::Memory)?;
        pixels.fill(Color::WHITE);
        Ok(PngCanvas { pixels })
    }

    /// The file.
    pub fn finish(self) -> Result<Vec<u8>, ViewError> {
        self.pixels.encode_png().map_err(|e| ViewError::Encoding(e.to_string()))
    }

    fn stroke_path(&mut self, path: PathBuilder, paint: &Paint<'_>, stroke: &Stroke) {
        // A path without an extent is none.
        if let Some(path) = path.finish() {
            self.pixels.stroke_path(&path, paint, stroke, Transform::identity(), None);
        }
    }
}

impl Canvas for PngCanvas {
    fn stroke(&mut self, lines: &Lines, pen: &Pen) {
        let paint = paint(pen.colour);
        let stroke = Stroke {
            width: pen.width as f32,
            line_cap: if pen.dash.is_some() { LineCap::Butt } else { LineCap::Round },
            line_join: LineJoin::Round,
            dash: pen.dash.and_then(|[dash, gap]| StrokeDash::new(vec![dash as f32, gap as f32], 0.0)),
            ..Stroke::default()
        };
        let mut path = PathBuilder::new();
        for polyline in lines.iter() {
            if let [[x, y]] = polyline {
                path.move_to(*x as f32, *y as f32);
                path.line_to(*x as f32, *y as f32);
                continue;
            }
            let mut begun = false;
            for p in polyline {
                let [x, y] = p.map(|c| c as f32);
                if begun {
                    path.line_to(x, y);
                } else {
                    path.move_to(x, y);
                    begun = true;
                }
                // A broken line must stay whole: its dashes go on over the corners.
                if path.len() >= LONG_PATH && pen.dash.is_none() {
                    let full = std::mem::replace(&mut path, PathBuilder::new());
                    self.stroke_path(full, &paint, &stroke);
                    path.move_to(x, y);
                }
            }
            if path.len() >= LONG_PATH {
                let full = std::mem::replace(&mut path, PathBuilder::new());
                self.stroke_path(full, &paint, &stroke);
            }
        }
        self.stroke_path(path, &paint, &stroke);
    }

    fn fill(&mut self, polygon: &[Point], colour: Colour) {
        let mut path = PathBuilder::new();
        let mut points = polygon.iter().map(|p| p.map(|c| c as f32));
        let Some([x, y]) = points.next() else { return };
        path.move_to(x, y);
        points.for_each(|[x, y]| path.line_to(x, y));
        path.close();
        if let Some(path) = path.finish() {
            self.pixels.fill_path(&path, &paint(colour), FillRule::Winding, Transform::identity(), None);
        }
    }
}

fn paint([r, g, b]: Colour) -> Paint<'static> {
    let mut paint = Paint { anti_alias: true, ..Paint::default() };
    paint.set_color_rgba8(r, g, b, 255);
    paint
}
