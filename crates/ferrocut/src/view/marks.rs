//! Small signs in a panel: axes, scale bar, start, end and work zero.

use super::canvas::{Canvas, Point, Rect, circle};
use super::extent::Point3;
use super::font::{self, Align};
use super::path::PathModel;
use super::projection::{Projection, View};
use super::ramp::Colour;
use super::scale;
use super::sheet::{INK, LABEL, PANEL, SOFT, Sheet};
use std::f64::consts::FRAC_PI_2;

/// Colour of the start: go.
const START: Colour = [0x1a, 0x8a, 0x5a];
/// Colour of the end: stop.
const END: Colour = [0xc8, 0x3a, 0x32];
/// Names and directions of the axes.
const AXES: [(&str, Point3); 3] = [("X", [1.0, 0.0, 0.0]), ("Y", [0.0, 1.0, 0.0]), ("Z", [0.0, 0.0, 1.0])];

/// A sign on the path.
#[derive(Clone, Copy, PartialEq, Eq, Debug)]
pub enum Mark {
    /// Where the axes stood first.
    Start,
    /// Where they stand at the end.
    End,
    /// The zero that coordinates count from.
    WorkZero,
}

impl Mark {
    /// Every mark.
    pub const ALL: [Mark; 3] = [Mark::Start, Mark::End, Mark::WorkZero];

    /// Where it is, if the path has it.
    pub fn place(self, model: &PathModel) -> Option<Point3> {
        match self {
            Mark::Start => Some(model.start()),
            Mark::End => Some(model.end()),
            Mark::WorkZero => model.work_zero(),
        }
    }

    /// Draws it: a ring, a square that fits into the ring, the quartered circle of a datum.
    pub fn draw<C: Canvas>(self, sheet: &mut Sheet<'_, C>, at: Point) {
        let [x, y] = at;
        match self {
            Mark::Start => {
                let (halo, ring) = (sheet.pen(PANEL, 5.0), sheet.pen(START, 2.2));
                let border = circle(at, sheet.px(7.0));
                sheet.canvas.outline(&border, &halo);
                sheet.canvas.outline(&border, &ring);
            }
            Mark::End => {
                let square =
                    |half: f64| Rect { x: x - half, y: y - half, width: 2.0 * half, height: 2.0 * half };
                let (halo, inner) = (square(sheet.px(5.2)), square(sheet.px(3.8)));
                sheet.canvas.rect(halo, PANEL);
                sheet.canvas.rect(inner, END);
            }
            Mark::WorkZero => {
                let radius = sheet.px(7.5);
                let disc = circle(at, radius);
                sheet.canvas.fill(&disc, PANEL);
                let quarter = |first: f64| -> Vec<Point> {
                    let on = |i: u32| (first + FRAC_PI_2 * f64::from(i) / 8.0).sin_cos();
                    let arc = (0..=8).map(on).map(|(sin, cos)| [x + radius * cos, y + radius * sin]);
                    std::iter::once(at).chain(arc).collect()
                };
                sheet.canvas.fill(&quarter(0.0), INK);
                sheet.canvas.fill(&quarter(2.0 * FRAC_PI_2), INK);
                let pen = sheet.pen(INK, 1.3);
                sheet.canvas.outline(&disc, &pen);
            }
        }
    }
}

/// Draws the marks that lie within the frame. The zero comes first, the end last: it fits into the
/// ring of a start at the same place.
pub fn marks<C: Canvas>(sheet: &mut Sheet<'_, C>, model: &PathModel, projection: &Projection, frame: Rect) {
    for mark in [Mark::WorkZero, Mark::Start, Mark::End] {
        if let Some(p) = mark.place(model).map(|p| projection.pixel(p)).filter(|p| frame.contains(*p)) {
            mark.draw(sheet, p);
        }
    }
}

/// Draws the directions of the axes in the lower left corner of a frame.
pub fn axes<C: Canvas>(sheet: &mut Sheet<'_, C>, view: View, frame: Rect) {
    const LENGTH: f64 = 34.0;
    let inset = sheet.px(18.0);
    // In the isometric view X also goes down.
    let rise = if view == View::Isometric { sheet.px(LENGTH * 0.5 + 6.0) } else { 0.0 };
    let zero = [frame.x + inset, frame.bottom() - inset - rise];
    for (name, direction) in AXES {
        let [right, up] = view.flat(direction).map(|c| c / view.foreshortening());
        if right == 0.0 && up == 0.0 {
            continue;
        }
        let at = |length: f64| [zero[0] + right * length, zero[1] - up * length];
        let (tip, label) = (at(sheet.px(LENGTH)), at(sheet.px(LENGTH + 10.0)));
        sheet.arrow(zero, tip, INK, 1.4, 8.0);
        let down = font::capital(sheet.px(LABEL)) / 2.0;
        sheet.text(name, [label[0], label[1] + down], LABEL, Align::Middle, INK);
    }
}

/// Draws a bar of a round number of millimetres that ends at `right` on the base line `y`.
pub fn scale_bar<C: Canvas>(sheet: &mut Sheet<'_, C>, projection: &Projection, right: f64, y: f64) {
    const LONGEST: f64 = 140.0;
    let mm = scale::round_down(sheet.px(LONGEST) / projection.along_axis());
    let length = mm * projection.along_axis();
    let text = match projection.view {
        View::Isometric => sheet.labels.along_axes(&scale::short(mm)),
        View::Top => sheet.labels.length(&scale::short(mm)),
    };
    let (left, middle) = (right - length, y - font::capital(sheet.px(LABEL)) / 2.0);
    let pen = sheet.pen(SOFT, 1.6);
    sheet.canvas.line([left, middle], [right, middle], &pen);
    for x in [left, right] {
        let half = sheet.px(4.0);
        sheet.canvas.line([x, middle - half], [x, middle + half], &pen);
    }
    let gap = sheet.px(10.0);
    sheet.text(&text, [left - gap, y], LABEL, Align::Right, SOFT);
}
