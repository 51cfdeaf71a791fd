//! A canvas that writes SVG.

use super::canvas::{Canvas, Lines, Pen, Point};
use super::font::Align;
use super::ramp::Colour;
use std::fmt::Write;

/// An SVG picture being written. Every call makes one path element, or a few where it is long.
pub struct SvgCanvas {
    out: String,
}

/// Bytes of path data in one element: readers refuse attributes above ten megabytes (libxml2).
const LONG_PATH: usize = 1 << 20;

impl SvgCanvas {
    /// An empty picture with a title for readers that show or speak one.
    pub fn new(width: u32, height: u32, title: &str) -> SvgCanvas {
        let mut out = String::new();
        // Writing to a String cannot fail, here and below.
        let _ = writeln!(
            out,
            "<svg xmlns=\"http://www.w3.org/2000/svg\" width=\"{width}\" height=\"{height}\" \
             viewBox=\"0 0 {width} {height}\">"
        );
        out.push_str("<title>");
        escape(&mut out, title);
        out.push_str("</title>\n<g fill=\"none\" stroke-linecap=\"round\" stroke-linejoin=\"round\">\n");
        SvgCanvas { out }
    }

    /// The file.
    pub fn finish(mut self) -> Vec<u8> {
        self.out.push_str("</g>\n</svg>\n");
        self.out.into_bytes()
    }

    fn open_stroke(&mut self, pen: &Pen) {
        self.out.push_str("<path stroke=\"");
        colour(&mut self.out, pen.colour);
        self.out.push_str("\" stroke-width=\"");
        hundredths(&mut self.out, to_hundredths(pen.width));
        if let Some([dash, gap]) = pen.dash {
            self.out.push_str("\" stroke-linecap=\"butt\" stroke-dasharray=\"");
            hundredths(&mut self.out, to_hundredths(dash));
            self.out.push(' ');
            hundredths(&mut self.out, to_hundredths(gap));
        }
        self.out.push_str("\" d=\"");
    }
}

impl Canvas for SvgCanvas {
    fn letters(&mut self, text: &str, at: Point, size: f64, align: Align, slope: f64, fill: Colour) -> bool {
        let [x, y] = at;
        let anchor = match align {
            Align::Left => "start",
            Align::Middle => "middle",
            Align::Right => "end",
        };
        self.out.push_str("<text xml:space=\"preserve\" fill=\"");
        colour(&mut self.out, fill);
        let _ = write!(
            self.out,
            "\" font-family=\"sans-serif\" font-size=\"{size:.2}\" text-anchor=\"{anchor}\" x=\"{x:.2}\" y=\"{y:.2}\""
        );
        if slope != 0.0 {
            let _ = write!(self.out, " transform=\"rotate({:.2} {x:.2} {y:.2})\"", -slope.to_degrees());
        }
        self.out.push('>');
        escape(&mut self.out, text);
        self.out.push_str("</text>\n");
        true
    }

    fn stroke(&mut self, lines: &Lines, pen: &Pen) {
        if lines.is_empty() {
            return;
        }
        self.open_stroke(pen);
        let mut first = self.out.len();
        for polyline in lines.iter() {
            path_data(&mut self.out, polyline);
            if self.out.len() - first > LONG_PATH {
                self.out.push_str("\"/>\n");
                self.open_stroke(pen);
                first = self.out.len();
            }
        }
        self.out.push_str("\"/>\n");
    }

    fn fill(&mut self, polygon: &[Point], fill: Colour) {
        self.out.push_str("<path fill=\"");
        colour(&mut self.out, fill);
        self.out.push_str("\" d=\"");
        path_data(&mut self.out, polygon);
        self.out.push_str("z\"/>\n");
    }
}

/// Writes a polyline as one absolute point and steps from it. Steps are differences of rounded
/// coordinates, so that rounding does not add up.
pub fn path_data(out: &mut String, polyline: &[Point]) {
    let mut before: Option<[i64; 2]> = None;
    let mut moved = false;
    for p in polyline {
        let p = p.map(to_hundredths);
        match before {
            None => {
                out.push('M');
                pair(out, p);
            }
            Some(b) if b == p => continue,
            Some(b) => {
                let separator = if !moved {
                    "l"
                } else if p[0] >= b[0] {
                    " "
                } else {
                    ""
                };
                out.push_str(separator);
                pair(out, [p[0] - b[0], p[1] - b[1]]);
                moved = true;
            }
        }
        before = Some(p);
    }
    if before.is_some() && !moved {
        // A dot: a line of no length with round ends.
        out.push_str("h0");
    }
}

fn pair(out: &mut String, [x, y]: [i64; 2]) {
    hundredths(out, x);
    if y >= 0 {
        out.push(' ');
    }
    hundredths(out, y);
}

fn to_hundredths(v: f64) -> i64 {
    (v * 100.0).round() as i64
}

/// Writes hundredths as a number, as short as it goes.
fn hundredths(out: &mut String, v: i64) {
    if v < 0 {
        out.push('-');
    }
    let v = v.unsigned_abs();
    let (whole, part) = (v / 100, v % 100);
    if whole > 0 || part == 0 {
        let _ = write!(out, "{whole}");
    }
    if part > 0 {
        let _ = if part % 10 == 0 { write!(out, ".{}", part / 10) } else { write!(out, ".{part:02}") };
    }
}

fn colour(out: &mut String, [r, g, b]: Colour) {
    let _ = write!(out, "#{r:02x}{g:02x}{b:02x}");
}

/// Text as XML: marks escaped, characters that XML does not allow left out.
pub fn escape(out: &mut String, text: &str) {
    for c in text.chars() {
        match c {
            '&' => out.push_str("&amp;"),
            '<' => out.push_str("&lt;"),
            '>' => out.push_str("&gt;"),
            '\u{fffe}' | '\u{ffff}' => {}
            c if c < ' ' && !matches!(c, '\t' | '\n') => {}
            c => out.push(c),
        }
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    fn data(polyline: &[Point]) -> String {
        let mut out = String::new();
        path_data(&mut out, polyline);
        out
    }

    #[test]
    fn coordinates_are_short_and_do_not_drift() {
        assert_eq!(data(&[[10.0, 5.5], [10.5, 5.25], [9.0, 5.25]]), "M10 5.5l.5-.25-1.5 0");
        let third: Vec<Point> = (0..=3000).map(|i| [f64::from(i) / 3.0, 0.0]).collect();
        let sum: f64 =
            data(&third).split('l').nth(1).unwrap().split(' ').map(|v| v.parse::<f64>().unwrap()).sum();
        assert!((sum - 1000.0).abs() < 1e-6);
    }

    #[test]
    fn a_point_is_a_dot() {
        assert_eq!(data(&[[1.0, 2.0], [1.0, 2.001]]), "M1 2h0");
    }

    #[test]
    fn titles_cannot_break_the_file() {
        let svg = String::from_utf8(SvgCanvas::new(10, 5, "<a>&\u{1}b").finish()).unwrap();
        assert!(svg.contains("<title>&lt;a&gt;&amp;b</title>"));
    }
}
