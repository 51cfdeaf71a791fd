//! A stroke font: every letter is a few lines, as a plotter draws it.
//!
//! Both kinds of picture draw their labels with it, so that they need no font file and look alike
//! everywhere. A letter is written as points `x,y` on a grid whose capitals are 12 high and whose
//! small letters are 8; `/` lifts the pen. A point after `~` is not passed through: it draws the line
//! into a curve, as the off-curve points of TrueType do (between two of them the curve passes
//! through their middle).

use super::canvas::{Lines, Point};
use super::letters::LETTERS;

/// Height of a capital, grid units.
const CAPITAL: f64 = 12.0;
/// Height of a capital as part of the size of the text.
const CAPITAL_OF_SIZE: f64 = 0.72;
/// Space between two letters, grid units.
const SPACING: f64 = 3.0;
/// Chords of a curve: what 100 px letters need to look round.
const CHORDS: u32 = 5;

/// A letter, its width in grid units and its lines.
pub type Glyph = (char, f64, &'static str);

/// Width of a letter as wide as the text is high, grid units: of scripts that the font does not have.
const SQUARE: f64 = CAPITAL / CAPITAL_OF_SIZE - SPACING;

/// Where scripts of such letters begin.
const SQUARE_FROM: char = '\u{2e80}';

/// The letters.
#[rustfmt::skip]
const GLYPHS: &[Glyph] = &[
    (' ', 2.5, ""),
    ('0', 7.5, "3.75,12 ~0,12 ~0,0 ~7.5,0 ~7.5,12 3.75,12"),
    ('1', 7.5, "1.4,9.6 4.4,12 4.4,0"),
    ('2', 7.5, "0.3,9 ~0.3,12 ~3.8,12 ~7.2,12 ~7.2,8.9 ~7.2,7 5.4,5.2 0.2,0 7.5,0"),
    ('3', 7.5, "0.4,9.8 ~0.8,12 ~3.7,12 ~7,12 ~7,6.4 3.2,6.4 ~7.5,6.4 ~7.5,0 ~3.6,0 ~0.6,0 0,2.4"),
    ('4', 7.5, "5.6,0 5.6,12 0,3.5 7.5,3.5"),
    ('5', 7.5, "6.8,12 1.1,12 0.7,6.5 ~2,7.7 ~3.9,7.7 ~7.5,7.7 ~7.5,0 ~3.6,0 ~0.8,0 0,2.2"),
    ('6', 7.5, "6.8,10.6 ~5.9,12 ~4.2,12 ~0.2,12 0.2,4.4 ~0.2,0 ~3.8,0 ~7.5,0 ~7.5,7.6 ~3.9,7.6 ~0.8,7.6 0.2,4.4"),
    ('7', 7.5, "0,12 7.5,12 2.8,0"),
    ('8', 7.5, "3.75,6.5 ~0.5,6.5 ~0.5,12 ~7,12 ~7,6.5 3.75,6.5 ~0,6.5 ~0,0 ~7.5,0 ~7.5,6.5 3.75,6.5"),
    ('9', 7.5, "0.7,1.4 ~1.6,0 ~3.3,0 ~7.3,0 7.3,7.6 ~7.3,12 ~3.7,12 ~0,12 ~0,4.4 ~3.6,4.4 ~6.7,4.4 7.3,7.6"),
    ('A', 9.0, "0,0 4.5,12 9,0 / 1.6,4 7.4,4"),
    ('B', 8.0, "0,6.3 4.3,6.3 ~7.4,6.3 ~7.4,12 4.3,12 0,12 0,0 4.4,0 ~8,0 ~8,6.3 4.4,6.3"),
    ('C', 8.6, "8.5,9.4 ~7.6,12 ~4.7,12 ~0,12 ~0,0 ~4.7,0 ~7.6,0 8.6,2.6"),
    ('D', 8.6, "0,0 0,12 3.4,12 ~8.6,12 ~8.6,0 3.4,0 0,0"),
    ('E', 7.0, "7,12 0,12 0,0 7,0 / 0,6.3 6,6.3"),
    ('F', 6.8, "6.8,12 0,12 0,0 / 0,6 5.8,6"),
    ('G', 9.0, "8.5,9.4 ~7.6,12 ~4.7,12 ~0,12 ~0,0 ~4.7,0 ~9,0 9,4 9,5.6 5.2,5.6"),
    ('H', 8.4, "0,0 0,12 / 8.4,0 8.4,12 / 0,6.2 8.4,6.2"),
    ('I', 1.0, "0.5,0 0.5,12"),
    ('J', 5.6, "5.6,12 5.6,3.6 ~5.6,0 ~0.9,0 0,2.5"),
    ('K', 8.0, "0,0 0,12 / 7.4,12 0,4.6 / 2.7,7.3 8,0"),
    ('L', 6.4, "0,12 0,0 6.4,0"),
    ('M', 10.0, "0,0 0,12 5,4 10,12 10,0"),
    ('N', 8.5, "0,0 0,12 8.5,0 8.5,12"),
    ('O', 9.6, "4.8,12 ~0,12 ~0,0 ~9.6,0 ~9.6,12 4.8,12"),
    ('P', 7.6, "0,0 0,12 4,12 ~7.6,12 ~7.6,5.4 4,5.4 0,5.4"),
    ('Q', 9.6, "4.8,12 ~0,12 ~0,0 ~9.6,0 ~9.6,12 4.8,12 / 6,3 9.6,-0.8"),
    ('R', 8.0, "0,0 0,12 4,12 ~7.6,12 ~7.6,5.6 4,5.6 0,5.6 / 4,5.6 8,0"),
    ('S', 7.6, "7.2,9.8 ~6.4,12 ~3.8,12 ~0.4,12 ~0.4,6.7 ~3.8,6.3 ~7.6,5.9 ~7.6,0 ~3.8,0 ~0.8,0 0,2.4"),
    ('T', 8.0, "0,12 8,12 / 4,12 4,0"),
    ('U', 8.4, "0,12 0,4.5 ~0,0 ~8.4,0 8.4,4.5 8.4,12"),
    ('V', 8.5, "0,12 4.25,0 8.5,12"),
    ('W', 12.0, "0,12 3,0 6,10 9,0 12,12"),
    ('X', 8.0, "0,12 8,0 / 8,12 0,0"),
    ('Y', 8.0, "0,12 4,5.8 8,12 / 4,5.8 4,0"),
    ('Z', 7.6, "0,12 7.6,12 0,0 7.6,0"),
    ('a', 6.4, "6.4,8 6.4,0 / 6.4,4 ~6.4,8 ~3.2,8 ~0,8 ~0,0 ~3.2,0 ~6.4,0 6.4,4"),
    ('b', 6.6, "0,12 0,0 / 0,4 ~0,8 ~3.3,8 ~6.6,8 ~6.6,0 ~3.3,0 ~0,0 0,4"),
    ('c', 6.0, "5.9,6.3 ~5.2,8 ~3.3,8 ~0,8 ~0,0 ~3.3,0 ~5.2,0 6,1.7"),
    ('d', 6.6, "6.6,12 6.6,0 / 6.6,4 ~6.6,8 ~3.3,8 ~0,8 ~0,0 ~3.3,0 ~6.6,0 6.6,4"),
    ('e', 6.6, "0.1,4.2 6.6,4.2 ~6.6,8 ~3.4,8 ~0,8 ~0,0 ~3.6,0 ~5.6,0 6.3,1.6"),
    ('f', 4.4, "4.4,12 3.8,12 ~1.7,12 1.7,9.7 1.7,0 / 0,8 4.1,8"),
    ('g', 6.6, "6.6,8 6.6,-0.8 ~6.6,-4 ~3.3,-4 ~1.2,-4 0.5,-2.7 / 6.6,4 ~6.6,8 ~3.3,8 ~0,8 ~0,0 ~3.3,0 ~6.6,0 6.6,4"),
    ('h', 6.2, "0,12 0,0 / 0,4.4 ~0,8 ~3.3,8 ~6.2,8 6.2,4.8 6.2,0"),
    ('i', 1.0, "0.5,8 0.5,0 / 0.5,10.9 0.5,11.3"),
    ('j', 2.5, "2,8 2,-1.7 ~2,-4 0,-4 / 2,10.9 2,11.3"),
    ('k', 6.0, "0,12 0,0 / 5.6,8 0,2.9 / 2.2,4.9 6,0"),
    ('l', 2.2, "0.5,12 0.5,2 ~0.5,0 2.2,0"),
    ('m', 10.0, "0,8 0,0 / 0,4.8 ~0,8 ~2.7,8 ~5,8 5,5.2 5,0 / 5,4.8 ~5,8 ~7.7,8 ~10,8 10,5.2 10,0"),
    ('n', 6.2, "0,8 0,0 / 0,4.4 ~0,8 ~3.3,8 ~6.2,8 6.2,4.8 6.2,0"),
    ('o', 6.8, "3.4,8 ~0,8 ~0,0 ~6.8,0 ~6.8,8 3.4,8"),
    ('p', 6.6, "0,8 0,-4 / 0,4 ~0,8 ~3.3,8 ~6.6,8 ~6.6,0 ~3.3,0 ~0,0 0,4"),
    ('q', 6.6, "6.6,8 6.6,-4 / 6.6,4 ~6.6,8 ~3.3,8 ~0,8 ~0,0 ~3.3,0 ~6.6,0 6.6,4"),
    ('r', 4.0, "0,8 0,0 / 0,4.4 ~0,8 ~2.8,8 4,7.8"),
    ('s', 5.8, "5.5,6.6 ~4.8,8 ~3,8 ~0.3,8 ~0.3,4.5 ~3,4.2 ~5.8,3.9 ~5.8,0 ~2.9,0 ~0.6,0 0,1.5"),
    ('t', 4.4, "1.7,11 1.7,2.2 ~1.7,0 ~3.1,0 4.4,0.3 / 0,8 4.2,8"),
    ('u', 6.2, "0,8 0,3.4 ~0,0 ~2.9,0 ~6.2,0 6.2,3.6 / 6.2,8 6.2,0"),
    ('v', 6.6, "0,8 3.3,0 6.6,8"),
    ('w', 9.6, "0,8 2.4,0 4.8,7 7.2,0 9.6,8"),
    ('x', 6.2, "0,8 6.2,0 / 6.2,8 0,0"),
    ('y', 6.6, "0,8 3.4,0 / 6.6,8 2.8,-1.8 ~1.9,-4 0.2,-4"),
    ('z', 6.0, "0,8 6,8 0,0 6,0"),
    ('.', 1.4, "0.7,0 0.7,0.3"),
    (',', 1.6, "1,0.3 1,-0.2 0.2,-2.2"),
    (':', 1.4, "0.7,0.6 0.7,0.9 / 0.7,6.4 0.7,6.7"),
    (';', 1.6, "1,0.3 1,-0.2 0.2,-2.2 / 1,6.4 1,6.7"),
    ('-', 5.0, "0,5 5,5"),
    ('\u{2212}', 6.0, "0,5 6,5"),
    ('+', 7.0, "0,5 7,5 / 3.5,8.5 3.5,1.5"),
    ('=', 7.0, "0,6.6 7,6.6 / 0,3.4 7,3.4"),
    ('±', 7.0, "0,6.6 7,6.6 / 3.5,10 3.5,3.2 / 0,0.6 7,0.6"),
    ('×', 6.0, "0.3,7.7 5.7,2.3 / 5.7,7.7 0.3,2.3"),
    ('(', 3.0, "3,13.2 ~0,10 0,5.2 ~0,0.4 3,-2.8"),
    (')', 3.0, "0,13.2 ~3,10 3,5.2 ~3,0.4 0,-2.8"),
    ('[', 3.0, "3,13 0,13 0,-2.5 3,-2.5"),
    (']', 3.0, "0,13 3,13 3,-2.5 0,-2.5"),
    ('{', 4.0, "4,13 ~2,13 2,10.5 2,7.5 ~2,5.3 0,5.3 ~2,5.3 2,3 2,0 ~2,-2.5 4,-2.5"),
    ('}', 4.0, "0,13 ~2,13 2,10.5 2,7.5 ~2,5.3 4,5.3 ~2,5.3 2,3 2,0 ~2,-2.5 0,-2.5"),
    ('<', 6.6, "6.6,8.6 0,5 6.6,1.4"),
    ('>', 6.6, "0,8.6 6.6,5 0,1.4"),
    ('≥', 6.6, "0,10 6.6,6.6 0,3.2 / 0,0.4 6.6,0.4"),
    ('/', 5.0, "0,-1.5 5,13"),
    ('\\', 5.0, "0,13 5,-1.5"),
    ('|', 1.0, "0.5,13 0.5,-2.5"),
    ('_', 7.0, "0,-1.5 7,-1.5"),
    ('%', 10.0, "9,12 1,0 / 2.2,12 ~0,12 ~0,6.8 ~4.4,6.8 ~4.4,12 2.2,12 / 7.8,5.2 ~5.6,5.2 ~5.6,0 ~10,0 ~10,5.2 7.8,5.2"),
    ('°', 4.0, "2,12 ~0,12 ~0,8 ~4,8 ~4,12 2,12"),
    ('#', 8.0, "2,0 3.4,12 / 5.2,0 6.6,12 / 0.4,8 8,8 / 0,4 7.6,4"),
    ('*', 5.4, "2.7,12 2.7,6.6 / 0.3,10.7 5.1,7.9 / 5.1,10.7 0.3,7.9"),
    ('\'', 1.0, "0.5,12 0.5,9"),
    ('"', 3.4, "0.5,12 0.5,9 / 2.9,12 2.9,9"),
    ('`', 2.0, "0,12 2,10"),
    ('^', 6.0, "0,8 3,12 6,8"),
    ('~', 7.0, "0,4.4 ~1.5,6.8 3.5,5 ~5.5,3.2 7,5.6"),
    ('!', 1.4, "0.7,12 0.7,3.6 / 0.7,0 0.7,0.3"),
    ('?', 6.4, "0,9.8 ~0.6,12 ~3.2,12 ~6.4,12 ~6.4,9.2 ~6.4,7.4 ~3.2,6.4 3.2,3.6 / 3.2,0 3.2,0.3"),
    ('&', 9.4, "9.4,0 2,9 ~1,10.2 ~2,12 ~3.8,12 ~6,12 ~6.2,8 ~3.6,7 ~0,5.6 ~0,0 ~4,0 ~8,0 8.6,5.4"),
    ('@', 11.0, "7.8,6.6 ~7,8 ~5.4,8 ~3,8 ~3,2.6 ~5.2,2.6 ~7.8,2.6 7.8,5.4 8,8 / 7.8,5.4 ~7.8,2.4 ~9.4,2.4 ~11,2.4 ~11,12 ~5.6,12 ~0,12 ~0,-1.6 ~5.6,-1.6 8.4,-0.8"),
    ('$', 7.6, "7.2,9.4 ~6.4,11.2 ~3.8,11.2 ~0.4,11.2 ~0.4,6.5 ~3.8,6.1 ~7.6,5.7 ~7.6,0.8 ~3.8,0.8 ~0.8,0.8 0,2.8 / 3.8,13 3.8,-1"),
    ('…', 9.0, "0.7,0 0.7,0.3 / 4.5,0 4.5,0.3 / 8.3,0 8.3,0.3"),
    ('→', 9.0, "0,5 9,5 / 6,8 9,5 6,2"),
];

/// What stands for a letter that the font does not have.
const UNKNOWN: Glyph = ('\u{fffd}', 7.0, "0,0 0,12 7,12 7,0 0,0");

fn glyph(c: char) -> &'static Glyph {
    GLYPHS.iter().chain(LETTERS).find(|g| g.0 == c).unwrap_or(&UNKNOWN)
}

/// Width of a letter, grid units.
fn advance(c: char) -> f64 {
    let glyph = glyph(c);
    if glyph.0 != c && c >= SQUARE_FROM { SQUARE } else { glyph.1 }
}

/// Whether the font has every letter of a text.
pub fn has(text: &str) -> bool {
    text.chars().all(|c| glyph(c).0 == c)
}

/// Which point of a text stands at its place; vertically it is the base line.
#[derive(Clone, Copy, PartialEq, Eq, Debug)]
pub enum Align {
    /// The left end.
    Left,
    /// The middle.
    Middle,
    /// The right end.
    Right,
}

/// Width of a text of this size, pixels.
pub fn width(text: &str, size: f64) -> f64 {
    let letters: f64 = text.chars().map(|c| advance(c) + SPACING).sum();
    (letters - SPACING).max(0.0) * unit(size)
}

/// Height of a capital of this size, pixels.
pub fn capital(size: f64) -> f64 {
    CAPITAL_OF_SIZE * size
}

/// Adds the strokes of a text to `lines`. `slope` turns it about its place, radians, counter-clockwise.
pub fn write(lines: &mut Lines, text: &str, at: Point, size: f64, align: Align, slope: f64) {
    let unit = unit(size);
    let mut x = match align {
        Align::Left => 0.0,
        Align::Middle => -width(text, size) / 2.0,
        Align::Right => -width(text, size),
    };
    let (sin, cos) = slope.sin_cos();
    for c in text.chars() {
        let (_, _, strokes) = glyph(c);
        for stroke in strokes.split('/') {
            lines.polyline(flatten(stroke).into_iter().map(|[gx, gy]| {
                let (right, up) = (x + gx * unit, gy * unit);
                [at[0] + right * cos - up * sin, at[1] - right * sin - up * cos]
            }));
        }
        x += (advance(c) + SPACING) * unit;
    }
}

/// `text` cut to a width, with an ellipsis where it was cut.
pub fn shortened(text: &str, size: f64, room: f64) -> String {
    // A line of text longer than this is cut anyhow; titles may be of any length.
    const LONG: usize = 400;
    let mut short: String = text.chars().take(LONG).collect();
    let mut cut = text.chars().nth(LONG).is_some();
    while !short.is_empty() && width(&short, size) + if cut { width("…", size) } else { 0.0 } > room {
        short.pop();
        cut = true;
    }
    if cut {
        short.push('…');
    }
    short
}

fn unit(size: f64) -> f64 {
    capital(size) / CAPITAL
}

/// The points of one stroke, curves as chords.
fn flatten(stroke: &str) -> Vec<Point> {
    let mut points: Vec<Point> = Vec::new();
    let mut pull: Option<Point> = None;
    for word in stroke.split_whitespace() {
        let off = word.starts_with('~');
        let Some(p) = parse(word.trim_start_matches('~')) else { continue };
        match (pull, off) {
            (None, false) => points.push(p),
            (None, true) => pull = Some(p),
            (Some(control), false) => {
                curve(&mut points, control, p);
                pull = None;
            }
            (Some(control), true) => {
                curve(&mut points, control, [(control[0] + p[0]) / 2.0, (control[1] + p[1]) / 2.0]);
                pull = Some(p);
            }
        }
    }
    points
}

/// Adds a quadratic Bézier curve from the last point.
fn curve(points: &mut Vec<Point>, control: Point, end: Point) {
    let start = points.last().copied().unwrap_or(control);
    for i in 1..=CHORDS {
        let t = f64::from(i) / f64::from(CHORDS);
        let mix = |a: f64, b: f64, c: f64| (1.0 - t) * (1.0 - t) * a + 2.0 * t * (1.0 - t) * b + t * t * c;
        points.push([mix(start[0], control[0], end[0]), mix(start[1], control[1], end[1])]);
    }
}

fn parse(word: &str) -> Option<Point> {
    let (x, y) = word.split_once(',')?;
    Some([x.parse().ok()?, y.parse().ok()?])
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn every_letter_is_well_written_and_inside_its_width() {
        for (c, width, strokes) in GLYPHS.iter().chain(LETTERS) {
            for word in strokes.split(['/', ' ']).filter(|w| !w.is_empty()) {
                assert!(parse(word.trim_start_matches('~')).is_some(), "{c}: {word}");
            }
            for [x, y] in strokes.split('/').flat_map(flatten) {
                assert!((-0.01..=width + 0.01).contains(&x) && (-4.01..=15.5).contains(&y), "{c}: {x},{y}");
            }
            assert!(strokes.split('/').all(|s| !s.trim_start().starts_with('~')), "{c} begins off the curve");
        }
    }

    #[test]
    fn every_printable_ascii_letter_is_there_once() {
        for c in ' '..='~' {
            assert_eq!(GLYPHS.iter().filter(|g| g.0 == c).count(), 1, "{c:?}");
        }
        for (c, _, _) in LETTERS {
            assert_eq!(GLYPHS.iter().chain(LETTERS).filter(|g| g.0 == *c).count(), 1, "{c:?}");
        }
    }

    #[test]
    fn text_is_aligned_and_turned() {
        let mut lines = Lines::default();
        write(&mut lines, "I", [100.0, 50.0], 12.0 / CAPITAL_OF_SIZE, Align::Right, 0.0);
        let points: Vec<_> = lines.iter().flatten().copied().collect();
        assert!(points.iter().all(|p| (p[0] - 99.5).abs() < 1e-9));
        let mut turned = Lines::default();
        write(&mut turned, "I", [0.0, 0.0], 12.0 / CAPITAL_OF_SIZE, Align::Left, std::f64::consts::FRAC_PI_2);
        let points: Vec<_> = turned.iter().flatten().copied().collect();
        assert!(points.iter().all(|p| (p[1] + 0.5).abs() < 1e-9 && p[0] < 1e-9));
    }

    #[test]
    fn long_text_is_cut_to_its_room() {
        let cut = shortened("a rather long program name.nc", 20.0, 120.0);
        assert!(cut.ends_with('…') && width(&cut, 20.0) <= 120.0);
        assert_eq!(shortened("short", 20.0, 500.0), "short");
    }
}
