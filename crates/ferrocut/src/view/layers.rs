//! The path as lines of the picture: projected, cut at the frame, thinned to what a pixel shows, and
//! sorted by colour.

use super::canvas::{Canvas, Lines, Pen, Point, Rect};
use super::cover::Cover;
use super::extent::Point3;
use super::path::{Kind, PathModel};
use super::projection::{Projection, View};
use super::ramp::{self, BANDS, Colour, Depths};
use super::thin::Thinner;
use std::collections::{BTreeMap, HashSet};

/// How far a line may leave the path, pixels: half of it to either side of the thinner's ray.
const TOLERANCE_PX: f64 = 0.25;
/// Pixels that a band of depth counts for when points are thinned: a change of colour is kept.
const PX_A_BAND: f64 = 0.5;
/// A line that changes its colour has no more pieces than one for this many pixels.
const PIECE_PX: f64 = 3.0;
/// A cut that stays within this many pixels is drawn as a dot: a drilled hole seen from above.
const DOT_PX: f64 = 1.5;

/// Side of a square of the picture in which one dot stands for all, pixels: less than half a dot.
const DOT_SQUARE_PX: f64 = 2.0;

/// Points of a picture that is looked through for hidden lines.
const CROWDED: usize = 100_000;

/// Colour of positioning moves.
pub const RAPID: Colour = [0x98, 0x9e, 0xa8];

/// A place on the picture, to the pixel.
type Pixel = (i32, i32);

/// Everything of the path that a panel shows.
pub struct Layers {
    rapids: Lines,
    cuts: Vec<Lines>,
    /// Ends of the positioning moves drawn. Where one is run again, as between pecks, its dashes would
    /// fill the gaps of the first.
    drawn: HashSet<[Pixel; 2]>,
    /// The deepest hole of each square of the picture: its band and its place.
    dots: BTreeMap<Pixel, (usize, Point)>,
    frame: Rect,
    top: bool,
}

/// Widths of the lines, pixels, in a picture that is not crowded.
#[derive(Clone, Copy, Debug)]
pub struct Widths {
    /// Of cuts.
    pub cut: f64,
    /// Of positioning moves.
    pub rapid: f64,
    /// Of a dash and the gap after it.
    pub dash: [f64; 2],
    /// Of a hole's dot.
    pub dot: f64,
}

impl Layers {
    /// The path of `model` seen through `projection`, within `frame`.
    pub fn of(model: &PathModel, projection: &Projection, frame: Rect, depths: &Depths) -> Layers {
        let mut layers = Layers {
            rapids: Lines::default(),
            cuts: vec![Lines::default(); BANDS],
            drawn: HashSet::new(),
            dots: BTreeMap::new(),
            frame,
            top: projection.view == View::Top,
        };
        for (kind, points) in model.runs() {
            let mut seen = points.map(|p| {
                let [x, y] = projection.pixel(p);
                let depth = if kind == Kind::Cut { depths.in_bands(p[2]) } else { 0.0 };
                [x, y, depth * PX_A_BAND]
            });
            let Some(first) = seen.next() else { continue };
            let mut pen = Stretch { layers: &mut layers, frame, kind, at: first, low: first, high: first };
            let mut thinner = Thinner::new(first, TOLERANCE_PX);
            for p in seen {
                if let Some(kept) = thinner.push(p) {
                    pen.to(kept);
                }
            }
            thinner.pending().for_each(|p| pen.to(p));
            pen.end();
        }
        layers
    }

    /// Draws positioning moves, then cuts. From above the deepest is drawn last: what is left of the
    /// part. In the isometric view the highest is: it is the nearest to the eye.
    pub fn draw(mut self, canvas: &mut impl Canvas, widths: &Widths) {
        let points: usize = self.cuts.iter().map(Lines::len).sum();
        let rapid_width = widths.rapid / crowding(self.rapids.len());
        let cut_width = widths.cut / crowding(points);
        // Bands from the nearest to the furthest.
        let mut order: Vec<usize> = (0..BANDS).collect();
        if self.top {
            order.reverse();
        }
        if points + self.rapids.len() > CROWDED {
            let mut cover = Cover::new(self.frame);
            for band in &order {
                if let Some(cuts) = self.cuts.get_mut(*band) {
                    *cuts = cover.visible(cuts);
                }
            }
            self.rapids = cover.visible(&self.rapids);
        }
        let mut dots = vec![Lines::default(); BANDS];
        for (band, place) in self.dots.values() {
            if let Some(lines) = dots.get_mut(*band) {
                lines.polyline([*place]);
            }
        }
        let rapid = Pen { colour: RAPID, width: rapid_width, dash: Some(widths.dash) };
        canvas.stroke(&self.rapids, &rapid);
        for band in order.into_iter().rev() {
            let colour = ramp::of_band(band);
            if let (Some(cuts), Some(dots)) = (self.cuts.get(band), dots.get(band)) {
                canvas.stroke(cuts, &Pen::solid(colour, cut_width));
                canvas.stroke(dots, &Pen::solid(colour, widths.dot));
            }
        }
    }
}

/// How much thinner lines are drawn where there are many points: 1 up to a few thousand, 1.6 from
/// a hundred thousand on.
fn crowding(points: usize) -> f64 {
    const FEW: f64 = 5e3;
    const MANY: f64 = 1e5;
    let part = ((points as f64 / FEW).max(1.0).ln() / (MANY / FEW).ln()).min(1.0);
    1.0 + 0.6 * part
}

/// A stretch of the path being drawn; the third coordinate is depth.
struct Stretch<'a> {
    layers: &'a mut Layers,
    frame: Rect,
    kind: Kind,
    at: Point3,
    low: Point3,
    high: Point3,
}

impl Stretch<'_> {
    fn to(&mut self, to: Point3) {
        let from = std::mem::replace(&mut self.at, to);
        for ((low, high), c) in self.low.iter_mut().zip(&mut self.high).zip(to) {
            *low = low.min(c);
            *high = high.max(c);
        }
        let (a, b) = ([from[0], from[1]], [to[0], to[1]]);
        if self.kind == Kind::Rapid {
            if let Some((a, b)) = self.frame.clip(a, b) {
                let (p, q) = (pixel(a), pixel(b));
                if self.layers.drawn.insert([p.min(q), p.max(q)]) {
                    self.layers.rapids.segment(a, b);
                }
            }
            return;
        }
        let (start, end) = (from[2] / PX_A_BAND, to[2] / PX_A_BAND);
        let bands = ramp::band(start).abs_diff(ramp::band(end)) as f64;
        let length = (b[0] - a[0]).hypot(b[1] - a[1]);
        let pieces = (length / PIECE_PX).ceil().clamp(1.0, bands + 1.0);
        let point = |t: f64| -> Point { [a[0] + (b[0] - a[0]) * t, a[1] + (b[1] - a[1]) * t] };
        let mut i = 0.0;
        let mut p = a;
        while i < pieces {
            let q = if i + 1.0 < pieces { point((i + 1.0) / pieces) } else { b };
            let band = ramp::band(start + (end - start) * (i + 0.5) / pieces);
            if let (Some(lines), Some((p, q))) = (self.layers.cuts.get_mut(band), self.frame.clip(p, q)) {
                lines.segment(p, q);
            }
            p = q;
            i += 1.0;
        }
    }

    /// Ends the stretch: one that is too small to be seen as a line becomes a dot.
    fn end(self) {
        let size = (self.high[0] - self.low[0]).max(self.high[1] - self.low[1]);
        if self.kind == Kind::Cut && size < DOT_PX && self.frame.contains([self.at[0], self.at[1]]) {
            let band = ramp::band(self.high[2] / PX_A_BAND);
            let place = [self.at[0], self.at[1]];
            let square = pixel(place.map(|c| c / DOT_SQUARE_PX));
            let deepest = self.layers.dots.entry(square).or_insert((band, place));
            if band > deepest.0 {
                *deepest = (band, place);
            }
        }
    }
}

fn pixel(p: Point) -> Pixel {
    (p[0].round() as i32, p[1].round() as i32)
}
