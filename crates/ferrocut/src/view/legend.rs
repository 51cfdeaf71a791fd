//! What the lines, colours and signs mean.

use super::canvas::{Canvas, Pen, Point, Rect};
use super::font::{self, Align};
use super::layers::{RAPID, Widths};
use super::marks::Mark;
use super::path::PathModel;
use super::ramp::{self, BANDS, Depths};
use super::scale;
use super::sheet::{FAINT, INK, LABEL, SOFT, Sheet};

/// Draws the colours of depth as a bar with numbers, counted from the work zero `zero_z`.
pub fn depth_bar<C: Canvas>(sheet: &mut Sheet<'_, C>, bar: Rect, depths: &Depths, zero_z: f64) {
    let height = font::capital(sheet.px(LABEL));
    let labels = sheet.labels;
    sheet.text(&labels.depth, [bar.x, bar.y - sheet.px(12.0)], LABEL, Align::Left, INK);
    let (mark, gap) = (sheet.px(4.0), sheet.px(9.0));
    let room = sheet.px(58.0);
    let border = sheet.pen(FAINT, 1.0);
    let number = |sheet: &mut Sheet<'_, C>, text: &str, y: f64| {
        sheet.canvas.line([bar.right(), y], [bar.right() + mark, y], &border);
        let size = LABEL * (room / sheet.text_width(text, LABEL).max(1.0)).min(1.0);
        sheet.text(text, [bar.right() + gap, y + height / 2.0], size, Align::Left, SOFT);
    };
    if depths.is_flat() {
        let swatch = Rect { height: bar.width, ..bar };
        sheet.canvas.rect(swatch, ramp::of_band(BANDS - 1));
        let text = format!("{}{}", if depths.above { "≥ " } else { "" }, scale::short(depths.deep - zero_z));
        return number(sheet, &text, bar.y + bar.width / 2.0);
    }
    for band in 0..BANDS {
        // Each reaches down to the end and is covered by the next: no seams.
        let top = bar.y + bar.height * band as f64 / BANDS as f64;
        let rest = Rect { y: top, height: bar.bottom() - top, ..bar };
        sheet.canvas.rect(rest, ramp::of_band(band));
    }
    let (low, high) = (depths.deep - zero_z, depths.shallow - zero_z);
    let at = |z: f64| bar.y + bar.height * (high - z) / (high - low);
    let above = if depths.above { "≥ " } else { "" };
    number(sheet, &format!("{above}{}", scale::short(high)), bar.y);
    number(sheet, &scale::short(low), bar.bottom());
    let step = scale::round_up((high - low) * sheet.px(44.0) / bar.height);
    let clear = 2.0 * height;
    for z in scale::ticks(low, high, step) {
        let y = at(z);
        if y - bar.y > clear && bar.bottom() - y > clear {
            number(sheet, &scale::fixed(z, scale::decimals(step)), y);
        }
    }
}

/// Draws the meaning of the lines and marks that there are, in a row from `at`.
pub fn key<C: Canvas>(
    sheet: &mut Sheet<'_, C>,
    at: Point,
    widths: &Widths,
    model: &PathModel,
    depths: &Depths,
    marks: &[Mark],
) {
    const SAMPLE: f64 = 44.0;
    let labels = sheet.labels;
    let [mut x, y] = at;
    let (sample, gap, apart) = (sheet.px(SAMPLE), sheet.px(10.0), sheet.px(30.0));
    let base = y + font::capital(sheet.px(LABEL)) / 2.0;
    let word = |sheet: &mut Sheet<'_, C>, text: &str, x: f64| {
        sheet.text(text, [x, base], LABEL, Align::Left, INK);
        x + sheet.text_width(text, LABEL) + apart
    };
    if !model.rapid_extent().is_empty() {
        let pen = Pen { colour: RAPID, width: widths.rapid, dash: Some(widths.dash) };
        sheet.canvas.line([x, y], [x + sample, y], &pen);
        x = word(sheet, &labels.rapid, x + sample + gap);
    }
    if !model.cut_extent().is_empty() {
        let first = if depths.is_flat() { BANDS - 1 } else { 0 };
        for band in first..BANDS {
            let part = |i: usize| x + sample * (i - first) as f64 / (BANDS - first) as f64;
            let pen = Pen::solid(ramp::of_band(band), 1.6 * widths.cut);
            sheet.canvas.line([part(band), y], [part(band + 1), y], &pen);
        }
        let name = if depths.is_flat() { &labels.cut } else { &labels.depths };
        x = word(sheet, name, x + sample + gap);
    }
    for mark in marks {
        let half = sheet.px(8.0);
        mark.draw(sheet, [x + half, y]);
        x = word(sheet, labels.mark(*mark), x + 2.0 * half + gap);
    }
}
