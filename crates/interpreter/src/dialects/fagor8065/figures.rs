//! Multiple machining G160 to G165 (2.1 to 2.6).

use crate::cycles::parameter::{WrongParameter, refuse};
use crate::cycles::positions::{Figure, Omitted, Path, PathNames, whole};
use crate::cycles::zone::{FigureFormat, Repetition, Travel};
use crate::words::WordValues;
use ferrocut_geometry::SAME_POINT_MM;
use ferrocut_machine::Fault;

type Made = Result<Repetition, WrongParameter>;

/// How far from whole a number of operations may be (2.1).
const TOLERANCE: f64 = 0.001;

const ALONG: PathNames = PathNames { length: "X", distance: "I", count: "K", tolerance: TOLERANCE };
const ACROSS: PathNames = PathNames { length: "Y", distance: "J", count: "D", tolerance: TOLERANCE };

/// G160.
pub static LINE: FigureFormat = FigureFormat { letters: b"AXIKPQRSTUV", lengths: b"XI", build: line };

/// G161.
pub static PARALLELOGRAM: FigureFormat =
    FigureFormat { letters: b"ABXIKYJDPQRSTUV", lengths: b"XIYJ", build: parallelogram };

/// G162.
pub static GRID: FigureFormat = FigureFormat { letters: b"ABXIKYJDPQRSTUV", lengths: b"XIYJ", build: grid };

/// G163.
pub static CIRCLE: FigureFormat = FigureFormat { letters: b"XYIKCFPQRSTUV", lengths: b"XYF", build: circle };

/// G164.
pub static ARC: FigureFormat = FigureFormat { letters: b"XYBIKCFPQRSTUV", lengths: b"XYF", build: arc };

/// G165. I is a length here.
pub static CHORD: FigureFormat = FigureFormat { letters: b"XYAICF", lengths: b"XYIF", build: chord };

fn omitted(words: &WordValues) -> Result<Omitted, WrongParameter> {
    let letters = [("P", b'P'), ("Q", b'Q'), ("R", b'R'), ("S", b'S'), ("T", b'T'), ("U", b'U'), ("V", b'V')];
    Omitted::read(letters.map(|(name, letter)| (name, words.get(letter))))
}

fn path(
    words: &WordValues,
    [length, distance, count]: [u8; 3],
    names: PathNames,
) -> Result<(f64, u32), WrongParameter> {
    Path { length: words.get(length), distance: words.get(distance), count: words.get(count) }.steps(names)
}

/// 2.1.
fn line(words: &WordValues, from: [f64; 2]) -> Made {
    let (distance, count) = path(words, *b"XIK", ALONG)?;
    let figure = Figure::line(from, words.get(b'A').unwrap_or(0.0), distance, count);
    Ok(Repetition { figure, omitted: omitted(words)?, travel: Travel::Rapid, feed: None })
}

fn rows(words: &WordValues, from: [f64; 2], outline: bool) -> Made {
    let sides = [path(words, *b"XIK", ALONG)?, path(words, *b"YJD", ACROSS)?];
    let angles = [words.get(b'A').unwrap_or(0.0), words.get(b'B').unwrap_or(90.0)];
    let figure = Figure::rows(from, sides, angles, outline)?;
    Ok(Repetition { figure, omitted: omitted(words)?, travel: Travel::Rapid, feed: None })
}

/// 2.2.
fn parallelogram(words: &WordValues, from: [f64; 2]) -> Made {
    rows(words, from, true)
}

/// 2.3.
fn grid(words: &WordValues, from: [f64; 2]) -> Made {
    rows(words, from, false)
}

/// Centre: its distances from where the tool is.
fn center(words: &WordValues, [a, b]: [f64; 2]) -> Result<[f64; 2], WrongParameter> {
    let (x, y) = (words.get(b'X').unwrap_or(0.0), words.get(b'Y').unwrap_or(0.0));
    refuse(x.hypot(y) <= SAME_POINT_MM, Fault::CycleParameter, "X")?;
    Ok([a + x, b + y])
}

/// C and F: the way between points, and which way round it leads where it is an arc.
fn travel(words: &WordValues) -> Result<(Travel, Option<f64>, Option<f64>), WrongParameter> {
    let (travel, sense) = match words.get(b'C').unwrap_or(0.0) {
        0.0 => (Travel::Rapid, None),
        1.0 => (Travel::Line, None),
        2.0 => (Travel::Arc, Some(-1.0)),
        3.0 => (Travel::Arc, Some(1.0)),
        _ => return Err(WrongParameter::new(Fault::CycleParameter, "C")),
    };
    let feed = words.get(b'F');
    refuse(feed.is_some_and(|feed| !(feed > 0.0)), Fault::CycleParameter, "F")?;
    Ok((travel, sense, feed))
}

/// Points over `total` degrees by I or K; all round, the last one is not the first again.
fn round(words: &WordValues, from: [f64; 2], total: f64, closed: bool) -> Made {
    let (travel, sense, feed) = travel(words)?;
    let spaces = match (words.get(b'I'), words.get(b'K')) {
        (Some(step), None) => {
            refuse(step == 0.0, Fault::CycleParameter, "I")?;
            f64::from(whole((total / step).abs(), TOLERANCE, "I")?)
        }
        (None, Some(count)) => {
            let count = f64::from(whole(count, TOLERANCE, "K")?);
            if closed { count } else { (count - 1.0).max(1.0) }
        }
        (None, None) => return Err(WrongParameter::new(Fault::PatternForm, "I")),
        (Some(_), Some(_)) => return Err(WrongParameter::new(Fault::PatternForm, "K")),
    };
    // An arc of travel says the way round, else the sign of I; K goes counter-clockwise over a positive angle.
    let sign = sense.or(words.get(b'I').map(f64::signum)).unwrap_or(total.signum());
    let count = match words.get(b'K') {
        Some(count) => whole(count, TOLERANCE, "K")?,
        None => spaces as u32 + u32::from(!closed),
    };
    let figure = Figure::round(from, center(words, from)?, sign * total.abs() / spaces, count);
    Ok(Repetition { figure, omitted: omitted(words)?, travel, feed })
}

/// 2.4.
fn circle(words: &WordValues, from: [f64; 2]) -> Made {
    round(words, from, 360.0, true)
}

/// 2.5.
fn arc(words: &WordValues, from: [f64; 2]) -> Made {
    let total = words.get(b'B').ok_or(WrongParameter::new(Fault::CycleParameterMissing, "B"))?;
    refuse(total == 0.0, Fault::CycleParameter, "B")?;
    round(words, from, total, false)
}

/// 2.6: one point, the other end of a chord. A is the angle of its perpendicular bisector, about which the
/// start is mirrored; I its length.
fn chord(words: &WordValues, from: [f64; 2]) -> Made {
    let (travel, sense, feed) = travel(words)?;
    let center = center(words, from)?;
    let (x, y) = (from[0] - center[0], from[1] - center[1]);
    let turned = match (words.get(b'A'), words.get(b'I')) {
        (Some(bisector), None) => {
            let turned = 2.0 * (bisector - y.atan2(x).to_degrees());
            // The way there: as C says, else the shorter one.
            let near = turned.rem_euclid(360.0);
            match sense {
                Some(sense) if sense < 0.0 => near - 360.0,
                Some(_) => near,
                None if near > 180.0 => near - 360.0,
                None => near,
            }
        }
        (None, Some(length)) => {
            let half = length.abs() / (2.0 * x.hypot(y));
            refuse(!(half > 0.0 && half <= 1.0), Fault::CycleParameter, "I")?;
            (2.0 * half.asin()).to_degrees() * sense.unwrap_or(length.signum())
        }
        (None, None) => return Err(WrongParameter::new(Fault::PatternForm, "A")),
        (Some(_), Some(_)) => return Err(WrongParameter::new(Fault::PatternForm, "I")),
    };
    let figure = Figure::round(from, center, turned, 2);
    Ok(Repetition { figure, omitted: Omitted::default(), travel, feed })
}
