//! What belongs to the isometric view alone: the box of the part with the lengths of its sides.

use super::canvas::{Canvas, Lines, Point, Rect};
use super::extent::{Extent, Point3};
use super::font::{self, Align};
use super::projection::Projection;
use super::scale;
use super::sheet::{FAINT, LABEL, SOFT, Sheet};
use std::f64::consts::FRAC_PI_2;

/// Draws the box; the path is drawn over it.
pub fn part_box<C: Canvas>(sheet: &mut Sheet<'_, C>, projection: &Projection, part: &Extent) {
    let corners = part.corners().map(|c| projection.pixel(c));
    let mut lines = Lines::default();
    for (i, a) in corners.iter().enumerate() {
        // Corners are numbered by one bit an axis: an edge joins two that differ in one bit.
        for bit in [1, 2, 4] {
            if let (0, Some(b)) = (i & bit, corners.get(i | bit)) {
                lines.polyline([*a, *b]);
            }
        }
    }
    let pen = sheet.pen(FAINT, 1.0);
    sheet.canvas.stroke(&lines, &pen);
}

/// Writes the lengths along three edges of the outline, where there is nothing beside the box: the two
/// nearest to the eye at the floor, and the left upright one.
pub fn lengths<C: Canvas>(sheet: &mut Sheet<'_, C>, projection: &Projection, frame: Rect, part: &Extent) {
    let ([x0, y0, z0], [x1, y1, z1]) = (part.min, part.max);
    let edges: [(&str, Point3, Point3); 3] = [
        ("X", [x0, y0, z0], [x1, y0, z0]),
        ("Y", [x1, y0, z0], [x1, y1, z0]),
        ("Z", [x0, y0, z0], [x0, y0, z1]),
    ];
    let height = font::capital(sheet.px(LABEL));
    let off = sheet.px(10.0);
    for ((name, from, to), length) in edges.into_iter().zip(part.size()) {
        if length <= 0.0 {
            continue;
        }
        let text = format!("{name} {}", scale::short(length));
        let (a, b) = (projection.pixel(from), projection.pixel(to));
        let middle = [(a[0] + b[0]) / 2.0, (a[1] + b[1]) / 2.0];
        let room = sheet.text_width(&text, LABEL);
        let long = (b[0] - a[0]).hypot(b[1] - a[1]);
        let (at, align, slope): (Point, _, _) = match name {
            "Z" if middle[0] - 2.0 * off - room > frame.x => {
                ([middle[0] - off, middle[1] + height / 2.0], Align::Right, 0.0)
            }
            "Z" => ([middle[0] - off, middle[1]], Align::Middle, FRAC_PI_2),
            _ if long > room => {
                // Parallel to the edge, below it.
                let slope = (a[1] - b[1]).atan2(b[0] - a[0]);
                let (sin, cos) = slope.sin_cos();
                let down = off + height;
                ([middle[0] + down * sin, middle[1] + down * cos], Align::Middle, slope)
            }
            "X" => ([middle[0] - off, middle[1] + off + height], Align::Right, 0.0),
            _ => ([middle[0] + off, middle[1] + off + height], Align::Left, 0.0),
        };
        sheet.sloped(&text, at, LABEL, align, SOFT, slope);
    }
}
