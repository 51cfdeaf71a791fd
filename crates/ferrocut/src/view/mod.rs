//! The picture of a tool path.
//!
//! In: the steps of a program, one by one ([`PathModel`]). Out: a PNG or SVG with the path from
//! above and in isometric view ([`render`]). Positioning is dashed and grey; cuts are coloured by
//! their depth. Nothing here reads programs or writes files.
//!
//! The way of a point: `path` keeps it (thinned by `thin`), `projection` puts it on the picture,
//! `layers` sorts it by colour (`ramp`) and leaves
//! out what is hidden (`cover`), `canvas` draws it (`png`, `svg`). `top` and `isometric` add what one
//! view needs, `marks` and `legend` what explains it, `sheet` holds the inks and sizes of all.

mod canvas;
mod cover;
mod extent;
mod font;
mod isometric;
mod labels;
mod layers;
mod legend;
mod letters;
mod marks;
mod path;
mod png;
mod projection;
mod ramp;
pub mod scale;
mod sheet;
pub mod svg;
mod thin;
mod top;

pub use labels::Labels;
pub use path::PathModel;

use canvas::{Canvas, Rect};
use extent::{Extent, zip};
use ferrocut_machine::Catalogue;
use font::Align;
use layers::{Layers, Widths};
use marks::Mark;
use projection::{Projection, View};
use ramp::Depths;
use sheet::{FAINT, INK, LABEL, PANEL, PAPER, SOFT, Sheet};

/// Kind of picture file.
#[derive(Clone, Copy, PartialEq, Eq, Debug)]
pub enum Picture {
    /// Pixels.
    Png,
    /// Lines, for printing and for drawing programs.
    Svg,
}

/// Why there is no picture.
#[derive(Clone, PartialEq, Eq, Debug)]
pub enum ViewError {
    /// There is no memory for this many pixels.
    Memory,
    /// The pixels could not be written as PNG.
    Encoding(String),
}

impl ViewError {
    /// What is said of it.
    pub fn told(&self, catalogue: Catalogue) -> String {
        match self {
            ViewError::Memory => catalogue.label("label-view-memory", &[]),
            ViewError::Encoding(why) => {
                catalogue.label("label-view-encoding", &[("reason", why.as_str().into())])
            }
        }
    }
}

/// Widths of a picture, pixels. Its height is half the width.
pub const WIDTHS: std::ops::RangeInclusive<i64> = 400..=10_000;

/// Width of a picture when none is asked for, pixels.
pub const DEFAULT_WIDTH: u32 = 1600;

/// Draws the path as a picture file, with labels in the language of a catalogue. `title` is the name of the program.
pub fn render(
    model: &PathModel,
    title: &str,
    width: u32,
    format: Picture,
    catalogue: Catalogue,
) -> Result<Vec<u8>, ViewError> {
    match format {
        Picture::Png => {
            let mut canvas = png::PngCanvas::new(width, width / 2)?;
            draw(&mut canvas, &Labels::drawn(catalogue), model, title, width);
            canvas.finish()
        }
        Picture::Svg => {
            let mut canvas = svg::SvgCanvas::new(width, width / 2, title);
            draw(&mut canvas, &Labels::of(catalogue), model, title, width);
            Ok(canvas.finish())
        }
    }
}

/// Draws the whole sheet.
fn draw(canvas: &mut impl Canvas, labels: &Labels, model: &PathModel, title: &str, width: u32) {
    let mut sheet = Sheet::new(canvas, labels, width);
    let whole = sheet.area(0.0, 0.0, 1600.0, 801.0);
    sheet.canvas.rect(whole, PAPER);
    let part = part(model);
    header(&mut sheet, model, title, &part);
    let shallow = model.highest_run().unwrap_or(part.max[2]).clamp(part.min[2], part.max[2]);
    let depths = Depths { deep: part.min[2], shallow, above: part.max[2] > shallow };
    let shown = shown(model, &part);
    let frames = [
        (View::Top, sheet.area(72.0, 112.0, 690.0, 600.0)),
        (View::Isometric, sheet.area(800.0, 112.0, 680.0, 600.0)),
    ];
    let mut visible = Vec::new();
    for (view, frame) in frames {
        // Room for the lengths beside the part.
        let border = sheet.px(if view == View::Top { 58.0 } else { 76.0 });
        let projection = Projection::fit(view, &shown, frame.inset(border));
        panel(&mut sheet, model, &projection, frame, &part, &depths);
        if moved(model) {
            visible.extend(
                Mark::ALL
                    .into_iter()
                    .filter(|mark| mark.place(model).is_some_and(|p| frame.contains(projection.pixel(p)))),
            );
        }
    }
    if !model.cut_extent().is_empty() && moved(model) {
        let bar = sheet.area(1508.0, 136.0, 16.0, 576.0);
        let zero = model.work_zero().unwrap_or_default();
        legend::depth_bar(&mut sheet, bar, &depths, zero[2]);
    }
    let key: Vec<_> = Mark::ALL.into_iter().filter(|mark| visible.contains(mark)).collect();
    let (at, widths) = ([sheet.px(72.0), sheet.px(770.0)], widths(&sheet));
    if moved(model) {
        legend::key(&mut sheet, at, &widths, model, &depths, &key);
    }
    let counted = if model.work_zero().is_some() { &labels.from_work } else { &labels.from_machine };
    let at = [sheet.px(1576.0), sheet.px(770.0) + font::capital(sheet.px(LABEL)) / 2.0];
    sheet.text(counted, at, LABEL, Align::Right, SOFT);
}

/// Name of the program, extents and number of moves.
fn header<C: Canvas>(sheet: &mut Sheet<'_, C>, model: &PathModel, title: &str, part: &Extent) {
    const TITLE: f64 = 23.0;
    let left = sheet.px(24.0);
    let title = font::shortened(title, sheet.px(TITLE), sheet.px(1552.0));
    let at = [left, sheet.px(38.0)];
    sheet.text(&title, at, TITLE, Align::Left, INK);
    let tally = model.tally();
    let mut line = Vec::new();
    if moved(model) {
        let zero = model.work_zero().unwrap_or_default();
        let (low, high) = (zip(part.min, zero, |a, z| a - z), zip(part.max, zero, |a, z| a - z));
        for (name, (low, high)) in ["X", "Y", "Z"].into_iter().zip(low.into_iter().zip(high)) {
            let (low, high) = (scale::short(low), scale::short(high));
            line.push(if low == high { format!("{name} {low}") } else { format!("{name} {low} … {high}") });
        }
    }
    let moves = tally.rapids + tally.cuts;
    line.push(sheet.labels.moves(moves));
    if moves > 0 {
        line.push(sheet.labels.rapids(tally.rapids));
        line.push(sheet.labels.cuts(tally.cuts, tally.cut_mm));
    }
    let line = font::shortened(&line.join("     "), sheet.px(14.0), sheet.px(1552.0));
    let at = [left, sheet.px(64.0)];
    sheet.text(&line, at, 14.0, Align::Left, SOFT);
}

/// One view of the path in its frame.
fn panel<C: Canvas>(
    sheet: &mut Sheet<'_, C>,
    model: &PathModel,
    projection: &Projection,
    frame: Rect,
    part: &Extent,
    depths: &Depths,
) {
    let view = projection.view;
    let labels = sheet.labels;
    let name = if view == View::Top { &labels.top } else { &labels.isometric };
    sheet.canvas.rect(frame, PANEL);
    let base = frame.y - sheet.px(10.0);
    sheet.text(name, [frame.x, base], LABEL, Align::Left, INK);
    let border = sheet.pen(FAINT, 1.0);
    if !moved(model) {
        sheet.canvas.outline(&frame.corners(), &border);
        let tally = model.tally();
        let none = if tally.rapids + tally.cuts == 0 { &labels.nothing } else { &labels.no_axes };
        let middle = [frame.x + frame.width / 2.0, frame.y + frame.height / 2.0];
        return sheet.text(none, middle, 20.0, Align::Middle, SOFT);
    }
    marks::scale_bar(sheet, projection, frame.right(), base);
    match view {
        View::Top => {
            top::grid(sheet, projection, frame, model.work_zero().unwrap_or_default());
            top::lengths(sheet, projection, frame, part);
        }
        View::Isometric => isometric::part_box(sheet, projection, part),
    }
    let widths = widths(sheet);
    Layers::of(model, projection, frame, depths).draw(sheet.canvas, &widths);
    if view == View::Isometric {
        isometric::lengths(sheet, projection, frame, part);
    }
    marks::axes(sheet, view, frame);
    marks::marks(sheet, model, projection, frame);
    sheet.canvas.outline(&frame.corners(), &border);
}

fn widths<C: Canvas>(sheet: &Sheet<'_, C>) -> Widths {
    Widths {
        cut: sheet.px(1.6).max(0.8),
        rapid: sheet.px(1.1).max(0.7),
        dash: [sheet.px(6.0), sheet.px(4.5)],
        dot: sheet.px(5.0),
    }
}

/// Whether there is anything to see: a move of X, Y or Z.
fn moved(model: &PathModel) -> bool {
    model.cut_extent().union(model.rapid_extent()).longest() > 0.0
}

/// The box that is measured: of the cuts, or of everything where nothing is cut.
fn part(model: &PathModel) -> Extent {
    let all = model.cut_extent().union(model.rapid_extent());
    let part = if model.cut_extent().longest() > 0.0 { *model.cut_extent() } else { all };
    if part.is_empty() { Extent { min: model.start(), max: model.start() } } else { part }
}

/// The box that is shown: the part and as much of the positioning as does not make the part small.
/// A way from a far tool change is cut off at the frame.
fn shown(model: &PathModel, part: &Extent) -> Extent {
    // As parts of the part's longest side: up to where rapids are shown whole, and how far when not.
    const NEAR: f64 = 0.6;
    const FAR: f64 = 0.15;
    let longest = part.longest();
    let reach = |room: f64| if room <= NEAR * longest { room } else { FAR * longest };
    if model.rapid_extent().is_empty() {
        return *part;
    }
    let all = part.union(model.rapid_extent());
    Extent {
        min: zip(part.min, all.min, |part, all| part - reach(part - all)),
        max: zip(part.max, all.max, |part, all| part + reach(all - part)),
    }
}

#[cfg(test)]
mod tests;
