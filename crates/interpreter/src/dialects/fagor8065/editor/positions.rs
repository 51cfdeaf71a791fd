//! Positions associated with a cycle, by their formats (4.23 to 4.27). A format is told by the names that are
//! there.

use super::{POINTS, both, check_no_gap, length, number};
use crate::cycles::described::{DescribedFigure, Parameter, Section};
use crate::cycles::parameter::{WrongParameter, refuse};
use crate::cycles::positions::{Figure, Path, PathNames, whole};
use ferrocut_geometry::SAME_POINT_MM;
use ferrocut_machine::Fault;

/// How far from whole a number of operations may be: the numbers of the manual's examples are rounded.
const TOLERANCE: f64 = 0.01;

const ROWS: &[Parameter] = &[
    length("LX"),
    length("LY"),
    number("NX"),
    number("NY"),
    length("IX"),
    length("IY"),
    number("alpha"),
    number("beta"),
];

/// P2 to P12.
const LISTED: &[Parameter] = POINTS.split_at(12).0.split_at(1).1;

/// Every figure.
pub static FIGURES: &[DescribedFigure] = &[
    DescribedFigure {
        name: "LINE",
        parameters: &[length("XN"), length("YN"), number("alpha"), length("L"), number("N"), length("I")],
        build: line,
    },
    DescribedFigure {
        name: "ARC",
        parameters: &[
            length("XA"),
            length("YA"),
            length("R"),
            number("N"),
            number("alpha"),
            number("tau"),
            number("beta"),
        ],
        build: arc,
    },
    DescribedFigure { name: "RECT", parameters: ROWS, build: rectangle },
    DescribedFigure { name: "GRID", parameters: ROWS, build: grid },
    DescribedFigure { name: "POINTS", parameters: LISTED, build: points },
];

type Made = Result<Figure, WrongParameter>;

fn form(word: &'static str) -> WrongParameter {
    WrongParameter::new(Fault::PatternForm, word)
}

/// 4.23.
fn line(section: &Section, from: [f64; 2]) -> Made {
    let (count, distance) = (section.given("N"), section.given("I"));
    if let Some([x, y]) = both(section, ["XN", "YN"], Fault::PatternForm)? {
        let names = PathNames { length: "XN", distance: "I", count: "N", tolerance: TOLERANCE };
        let total = (x - from[0]).hypot(y - from[1]);
        let (_, count) = Path { length: Some(total), distance, count }.steps(names)?;
        return Ok(Figure::between(from, [x, y], count));
    }
    let names = PathNames { length: "L", distance: "I", count: "N", tolerance: TOLERANCE };
    let angle = section.given("alpha").ok_or(form("alpha"))?;
    let (distance, count) = Path { length: section.given("L"), distance, count }.steps(names)?;
    Ok(Figure::line(from, angle, distance, count))
}

/// 4.24. The cycle's own point is point 1; where centre, radius and angle of it are given as well, the others
/// lie on that circle.
fn arc(section: &Section, from: [f64; 2]) -> Made {
    let given_center = both(section, ["XA", "YA"], Fault::PatternForm)?;
    let arm = match section.given("R").zip(section.given("alpha")) {
        Some((radius, first)) => {
            refuse(!(radius > 0.0 && radius.is_finite()), Fault::CycleParameter, "R")?;
            let (sin, cos) = crate::stages::rotation::sin_cos_degrees(first);
            Some([radius * cos, radius * sin])
        }
        None => None,
    };
    let center = match (given_center, section.given("R"), arm) {
        (Some(center), _, _) => center,
        (None, Some(_), Some([x, y])) => [from[0] - x, from[1] - y],
        (None, None, _) => return Err(form("XA")),
        (None, Some(_), None) => return Err(form("alpha")),
    };
    let begins = arm.map_or(from, |[x, y]| [center[0] + x, center[1] + y]);
    let (x, y) = (begins[0] - center[0], begins[1] - center[1]);
    refuse(x.hypot(y) <= SAME_POINT_MM, Fault::CycleParameter, "XA")?;
    let first = section.given("alpha").unwrap_or_else(|| y.atan2(x).to_degrees());
    let (count, step, last) = (section.given("N"), section.given("beta"), section.given("tau"));
    let (step, count) = match (count, step, last) {
        (Some(count), Some(step), None) => (step, whole(count, TOLERANCE, "N")?),
        (Some(count), None, Some(last)) => {
            let count = whole(count, TOLERANCE, "N")?;
            // Counter-clockwise, where no angle between says otherwise.
            (span(first, last, 1.0) / f64::from(count - 1).max(1.0), count)
        }
        (given, Some(step), Some(last)) => {
            refuse(step == 0.0, Fault::CycleParameter, "beta")?;
            let total = span(first, last, step.signum());
            let count = whole((total / step).abs() + 1.0, TOLERANCE, "beta")?;
            // No format has all three; where they agree they say the same.
            let agrees = match given {
                Some(given) => whole(given, TOLERANCE, "N")? == count,
                None => true,
            };
            refuse(!agrees, Fault::PatternForm, "N")?;
            (total / f64::from(count - 1).max(1.0), count)
        }
        (None, None, _) => return Err(form("N")),
        (_, None, None) => return Err(form("tau")),
        (None, Some(_), None) => return Err(form("N")),
    };
    Ok(Figure::on_circle(from, center, begins, step, count))
}

/// The way from one angle to another in a sense, at most a turn.
fn span(first: f64, last: f64, sense: f64) -> f64 {
    let turned = ((last - first) * sense).rem_euclid(360.0);
    // The same angle again is once round.
    sense * if turned < 1e-9 { 360.0 } else { turned }
}

/// By length and distance, a negative distance too says that the first point is not the lower left one (4.25).
fn rows(section: &Section, from: [f64; 2], outline: bool) -> Made {
    let side = |length: &'static str, distance: &'static str, count: &'static str| {
        let names = PathNames { length, distance, count, tolerance: TOLERANCE };
        let path = Path {
            length: section.given(length),
            distance: section.given(distance),
            count: section.given(count),
        };
        let (step, number) = path.steps(names)?;
        let turns = path.length.is_some_and(|length| length > 0.0) && path.distance.is_some_and(|d| d < 0.0);
        Ok((if turns { -step } else { step }, number))
    };
    let sides = [side("LX", "IX", "NX")?, side("LY", "IY", "NY")?];
    let angles = [section.number("alpha"), section.given("beta").unwrap_or(90.0)];
    Figure::rows(from, sides, angles, outline)
}

/// 4.25.
fn rectangle(section: &Section, from: [f64; 2]) -> Made {
    rows(section, from, true)
}

/// 4.26.
fn grid(section: &Section, from: [f64; 2]) -> Made {
    rows(section, from, false)
}

/// 4.27: P2 to P12; the first that is not used repeats the last one that is.
fn points(section: &Section, from: [f64; 2]) -> Made {
    let mut listed = vec![from];
    let mut at = from;
    for parameter in LISTED {
        let Some((to, corner)) = section.point(parameter.name) else {
            check_no_gap(section, LISTED, parameter.name)?;
            break;
        };
        refuse(corner.is_some(), Fault::ParameterKind, parameter.name)?;
        if (to[0] - at[0]).hypot(to[1] - at[1]) <= SAME_POINT_MM {
            break;
        }
        listed.push(to);
        at = to;
    }
    Ok(Figure::listed(listed))
}
