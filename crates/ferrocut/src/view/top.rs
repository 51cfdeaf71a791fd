//! What belongs to the top view alone: grid and numbers along X and Y, lengths of the part.

use super::canvas::{Canvas, Point, Rect};
use super::extent::{Extent, Point3};
use super::font::{self, Align};
use super::projection::Projection;
use super::scale;
use super::sheet::{FAINT, GRID, LABEL, PANEL, SOFT, Sheet};

/// Distance between two numbers at least, units.
const TICK_SPACING: f64 = 62.0;

/// Draws grid lines and the numbers outside the frame, counted from `zero`.
pub fn grid<C: Canvas>(sheet: &mut Sheet<'_, C>, projection: &Projection, frame: Rect, zero: Point3) {
    let across = [projection.across_at(frame.x) - zero[0], projection.across_at(frame.right()) - zero[0]];
    let up = [projection.up_at(frame.bottom()) - zero[1], projection.up_at(frame.y) - zero[1]];
    let spacing = sheet.px(TICK_SPACING) / projection.scale;
    // Long numbers need more room side by side.
    let longest = across.map(|v| sheet.text_width(&scale::fixed(v, scale::decimals(spacing)), LABEL));
    let room = (longest[0].max(longest[1]) + sheet.px(14.0)) / projection.scale;
    let step = [scale::round_up(spacing.max(room)), scale::round_up(spacing)];
    let (faint, tick) = (sheet.pen(GRID, 1.0), sheet.pen(SOFT, 1.0));
    let (mark, gap) = (sheet.px(5.0), sheet.px(9.0));
    let height = font::capital(sheet.px(LABEL));
    let near = |v: f64, step: f64| v.abs() < step * 1e-6;
    for x in scale::ticks(across[0], across[1], step[0]) {
        let px = projection.pixel([x + zero[0], 0.0, 0.0])[0];
        let pen = if near(x, step[0]) { sheet.pen(FAINT, 1.0) } else { faint };
        sheet.canvas.line([px, frame.y], [px, frame.bottom()], &pen);
        sheet.canvas.line([px, frame.bottom()], [px, frame.bottom() + mark], &tick);
        let text = scale::fixed(x, scale::decimals(step[0]));
        sheet.text(&text, [px, frame.bottom() + gap + height], LABEL, Align::Middle, SOFT);
    }
    for y in scale::ticks(up[0], up[1], step[1]) {
        let py = projection.pixel([0.0, y + zero[1], 0.0])[1];
        let pen = if near(y, step[1]) { sheet.pen(FAINT, 1.0) } else { faint };
        sheet.canvas.line([frame.x, py], [frame.right(), py], &pen);
        sheet.canvas.line([frame.x - mark, py], [frame.x, py], &tick);
        let text = scale::fixed(y, scale::decimals(step[1]));
        // A number too long for the margin is written smaller.
        let size = LABEL * (sheet.px(54.0) / sheet.text_width(&text, LABEL).max(1.0)).min(1.0);
        sheet.text(&text, [frame.x - gap, py + height / 2.0], size, Align::Right, SOFT);
    }
}

/// Draws the lengths of the part in X above it and in Y beside it, as on a drawing.
pub fn lengths<C: Canvas>(sheet: &mut Sheet<'_, C>, projection: &Projection, frame: Rect, part: &Extent) {
    let (low, high) = (projection.pixel(part.min), projection.pixel(part.max));
    let [wide, deep, _] = part.size();
    let border = sheet.px(24.0);
    if wide > 0.0 {
        let y = frame.y + border;
        length(sheet, [low[0], y], [high[0], y], high[1], &scale::short(wide));
    }
    if deep > 0.0 {
        let x = frame.right() - border;
        length(sheet, [x, low[1]], [x, high[1]], high[0], &scale::short(deep));
    }
}

/// Draws a measure from `a` to `b`; its extension lines begin near `part`.
fn length<C: Canvas>(sheet: &mut Sheet<'_, C>, a: Point, b: Point, part: f64, text: &str) {
    const HEAD: f64 = 8.0;
    let upright = a[0] == b[0];
    let (thin, over, off) = (sheet.pen(FAINT, 1.0), sheet.px(5.0), sheet.px(6.0));
    for [x, y] in [a, b] {
        let (from, to) =
            if upright { ([part + off, y], [x + over, y]) } else { ([x, part - off], [x, y - over]) };
        sheet.canvas.line(from, to, &thin);
    }
    let long = (b[0] - a[0]).hypot(b[1] - a[1]);
    let room = sheet.text_width(text, LABEL) + sheet.px(12.0);
    let height = font::capital(sheet.px(LABEL));
    let middle = [(a[0] + b[0]) / 2.0, (a[1] + b[1]) / 2.0];
    if long > sheet.px(2.0 * HEAD) {
        sheet.arrow(middle, a, SOFT, 1.0, HEAD);
        sheet.arrow(middle, b, SOFT, 1.0, HEAD);
    }
    if long > room + sheet.px(2.0 * HEAD) {
        // The text stands in a gap of the line, read from the right where the line is upright.
        let half = [room / 2.0, height / 2.0 + sheet.px(3.0)];
        let half = if upright { [half[1], half[0]] } else { half };
        let gap = Rect {
            x: middle[0] - half[0],
            y: middle[1] - half[1],
            width: 2.0 * half[0],
            height: 2.0 * half[1],
        };
        sheet.canvas.rect(gap, PANEL);
        let (at, slope) = if upright {
            ([middle[0] + height / 2.0, middle[1]], std::f64::consts::FRAC_PI_2)
        } else {
            ([middle[0], middle[1] + height / 2.0], 0.0)
        };
        sheet.sloped(text, at, LABEL, Align::Middle, SOFT, slope);
    } else if upright {
        sheet.text(text, [middle[0], a[1].min(b[1]) - sheet.px(8.0)], LABEL, Align::Middle, SOFT);
    } else {
        let right = a[0].max(b[0]) + sheet.px(10.0);
        sheet.text(text, [right, middle[1] + height / 2.0], LABEL, Align::Left, SOFT);
    }
}
