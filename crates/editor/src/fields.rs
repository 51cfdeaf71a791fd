//! What each parameter of a cycle is to a person: its symbol in the manual, what it measures, what it may be and
//! what stands in a fresh form.
//!
//! Which parameters a cycle has, and which words a choice has, is the interpreter's table alone; a row here says
//! what a name means, in all cycles or in some. A test holds that no parameter is without a row and no row
//! without a parameter. Sources are sections of the Fagor manual of canned cycles.

/// What a field measures.
#[derive(Clone, Copy, PartialEq, Eq, Debug)]
pub enum Measure {
    /// mm.
    Length,
    /// Degrees.
    Angle,
    /// mm/min; of a tap by its feed type also mm/turn.
    Feed,
    /// r/min.
    Speed,
    /// s.
    Time,
    /// A whole number.
    Count,
    /// A factor.
    Factor,
    /// Number of a tool.
    Tool,
    /// Number of a tool's offset, or of an M function.
    Number,
    /// One of some words.
    Choice,
    /// A name.
    Name,
    /// A point of the profile.
    Point,
}

impl Measure {
    /// Its name for a form.
    pub fn name(self) -> &'static str {
        match self {
            Measure::Length => "length",
            Measure::Angle => "angle",
            Measure::Feed => "feed",
            Measure::Speed => "speed",
            Measure::Time => "time",
            Measure::Count => "count",
            Measure::Factor => "factor",
            Measure::Tool => "tool",
            Measure::Number => "number",
            Measure::Choice => "choice",
            Measure::Name => "name",
            Measure::Point => "point",
        }
    }

    /// The sign of its unit; empty where it has none.
    pub fn unit(self) -> &'static str {
        match self {
            Measure::Length => "mm",
            Measure::Angle => "°",
            Measure::Feed => "mm/min",
            Measure::Speed => "r/min",
            Measure::Time => "s",
            _ => "",
        }
    }

    /// Whether only whole numbers are meant.
    pub fn is_whole(self) -> bool {
        matches!(self, Measure::Count | Measure::Tool | Measure::Number)
    }
}

/// What a form shows together.
#[derive(Clone, Copy, PartialEq, Eq, Debug)]
pub enum Group {
    /// Where.
    Place,
    /// Which shape.
    Shape,
    /// Planes and depth.
    Planes,
    /// How it is cut.
    Cutting,
    /// Tool, spindle, M functions.
    Tool,
}

impl Group {
    /// Its name for a form.
    pub fn name(self) -> &'static str {
        match self {
            Group::Place => "place",
            Group::Shape => "shape",
            Group::Planes => "planes",
            Group::Cutting => "cutting",
            Group::Tool => "tool",
        }
    }
}

/// What a fresh form holds.
#[derive(Clone, Copy, PartialEq, Debug)]
pub enum Standard {
    /// Nothing.
    Empty,
    /// A number.
    Number(f64),
    /// A word or name.
    Word(&'static str),
}

/// A row.
#[derive(Debug)]
pub struct Field {
    /// Name in a `#CYCLE` block.
    pub name: &'static str,
    /// The cycles and figures that it is this in; all where empty.
    pub of: &'static [&'static str],
    /// The manual's symbol.
    pub symbol: &'static str,
    /// Key of its meaning in the catalogue.
    pub key: &'static str,
    /// What it measures.
    pub measure: Measure,
    /// What it stands with.
    pub group: Group,
    /// Least and greatest value.
    pub range: (f64, f64),
    /// What a fresh form holds.
    pub standard: Standard,
}

use Group::{Cutting, Place, Planes, Shape, Tool};
use Measure::{Angle, Choice, Count, Factor, Feed, Length, Name, Number, Point, Speed, Time};
use Standard::{Empty, Number as Value, Word};

/// Longest coordinate, mm: the longest words of controls hold 99999.9999.
pub const FURTHEST: f64 = 99_999.0;
/// Any coordinate.
const ANY: (f64, f64) = (-FURTHEST, FURTHEST);
/// A size that may be nothing.
const SIZE: (f64, f64) = (0.0, FURTHEST);
/// A size that must be something.
const SOME: (f64, f64) = (0.001, FURTHEST);
const TURN: (f64, f64) = (-360.0, 360.0);
const FEEDS: (f64, f64) = (0.001, 100_000.0);
/// 0 stands for half the milling feed (4.1.3).
const PLUNGE: (f64, f64) = (0.0, 100_000.0);
/// Steepest entry into material: straight down.
const ENTRY: (f64, f64) = (0.0, 90.0);
const NONE: (f64, f64) = (0.0, 0.0);

#[allow(clippy::too_many_arguments)]
const fn row(
    name: &'static str,
    of: &'static [&'static str],
    symbol: &'static str,
    key: &'static str,
    measure: Measure,
    group: Group,
    range: (f64, f64),
    standard: Standard,
) -> Field {
    Field { name, of, symbol, key, measure, group, range, standard }
}

const POINT_AND_GO: &[&str] = &["G293"];
const POCKETS: &[&str] = &["G287", "G288", "G296", "P2D", "G291", "G292", "G290", "G295"];

/// Every field, in the order in which a form shows them; of two that fit the first holds.
pub const FIELDS: &[Field] = &[
    // Where.
    row("X", &["G294"], "X", "entry-point-x", Length, Place, ANY, Value(0.0)),
    row("Y", &["G294"], "Y", "entry-point-y", Length, Place, ANY, Value(0.0)),
    row("X", &[], "X", "point-x", Length, Place, ANY, Value(0.0)),
    row("Y", &[], "Y", "point-y", Length, Place, ANY, Value(0.0)),
    row("XC", &[], "Xc", "centre-x", Length, Place, ANY, Value(0.0)),
    row("YC", &[], "Yc", "centre-y", Length, Place, ANY, Value(0.0)),
    row("X1", POINT_AND_GO, "X1", "entry-point-x", Length, Place, ANY, Value(0.0)),
    row("Y1", POINT_AND_GO, "Y1", "entry-point-y", Length, Place, ANY, Value(0.0)),
    row("R1", POINT_AND_GO, "R1", "entry-radius", Length, Place, SIZE, Value(0.0)),
    row("RN", POINT_AND_GO, "Rn", "exit-radius", Length, Place, SIZE, Value(0.0)),
    row("XN", POINT_AND_GO, "Xn", "exit-point-x", Length, Place, ANY, Empty),
    row("YN", POINT_AND_GO, "Yn", "exit-point-y", Length, Place, ANY, Empty),
    // Which shape.
    row("profile", &[], "P.XY", "profile", Name, Shape, NONE, Word("CONTOUR")),
    row("pocket", &[], "P", "pocket", Name, Shape, NONE, Word("POCKET")),
    row("start", &[], "", "start", Choice, Shape, NONE, Word("centre")),
    row("kind", &[], "", "slot-kind", Choice, Shape, NONE, Word("corner_ll")),
    row("L", &["LINE"], "L", "figure-length", Length, Shape, ANY, Empty),
    row("L", &[], "L", "length", Length, Shape, ANY, Value(80.0)),
    row("H", &[], "H", "width", Length, Shape, ANY, Value(50.0)),
    row("alpha", &["G281"], "α", "point-angle", Angle, Shape, (0.0, 179.0), Value(90.0)),
    row("alpha", &["G299"], "α", "thread-angle", Angle, Cutting, TURN, Value(0.0)),
    row("alpha", &["LINE"], "α", "figure-angle", Angle, Shape, TURN, Value(0.0)),
    row("alpha", &["ARC"], "α", "first-angle", Angle, Shape, TURN, Empty),
    row("alpha", &["RECT", "GRID"], "α", "figure-angle", Angle, Shape, TURN, Value(0.0)),
    row("alpha", &[], "α", "turned", Angle, Shape, TURN, Value(0.0)),
    row("R", &["ARC"], "R", "figure-radius", Length, Shape, SOME, Empty),
    row("R", &[], "R", "radius", Length, Shape, SOME, Value(30.0)),
    row("corner", &[], "", "corner", Choice, Shape, NONE, Word("sharp")),
    row("r", &["G296"], "r", "emptied-radius", Length, Shape, SOME, Value(15.0)),
    row("r", &[], "r", "corner-size", Length, Shape, SIZE, Value(0.0)),
    row("Q", &[], "Q", "around", Length, Shape, SIZE, Value(10.0)),
    row("mode", &[], "", "punch-mode", Choice, Shape, NONE, Word("depth")),
    row("phi", &["G281"], "φ", "punch-diameter", Length, Shape, SIZE, Value(6.0)),
    row("phi", &["G299"], "φ", "thread-diameter", Length, Shape, SOME, Value(24.0)),
    row("phi", &[], "φ", "bore-diameter", Length, Shape, SOME, Value(16.0)),
    row("phiK", &[], "φK", "drilled-diameter", Length, Shape, SIZE, Value(0.0)),
    row("K", &["G299"], "K", "thread-depth", Length, Shape, SOME, Value(0.92)),
    row("B", &["G283"], "B", "retract-distance", Length, Cutting, SIZE, Value(0.0)),
    row("B", &["G299"], "B", "thread-pitch", Length, Shape, SOME, Value(1.5)),
    row("B", &[], "B", "helix-pitch", Length, Cutting, ANY, Value(2.0)),
    row("side", &[], "", "thread-side", Choice, Shape, NONE, Word("internal")),
    row("beta", &["G297"], "β", "orientation", Angle, Shape, TURN, Value(0.0)),
    row("dx", &[], "Δx", "clear-x", Length, Shape, ANY, Value(0.5)),
    row("dy", &[], "Δy", "clear-y", Length, Shape, ANY, Value(0.0)),
    row("Z1", &[], "P.Z1", "depth-profile", Name, Shape, NONE, Empty),
    row("Z2", &[], "P.Z2", "depth-profile", Name, Shape, NONE, Empty),
    row("Z3", &[], "P.Z3", "depth-profile", Name, Shape, NONE, Empty),
    row("Z4", &[], "P.Z4", "depth-profile", Name, Shape, NONE, Empty),
    // Planes (4.1.2).
    row("Z", &[], "Z", "surface", Length, Planes, ANY, Value(0.0)),
    row("ZS", &[], "Zs", "safety", Length, Planes, ANY, Value(5.0)),
    row("DP", &[], "Dp", "approach", Length, Planes, SIZE, Value(1.0)),
    row("P", &["G281"], "P", "depth", Length, Planes, ANY, Value(3.0)),
    row("P", &[], "P", "depth", Length, Planes, ANY, Value(10.0)),
    row("ZR", &[], "Zr", "retract-level", Length, Planes, ANY, Empty),
    // How it is cut.
    row("strategy", &[], "", "strategy", Choice, Cutting, NONE, Word("bidir_x")),
    row("begin", &[], "", "begin", Choice, Cutting, NONE, Word("ll")),
    row("I", &["LINE"], "I", "figure-distance", Length, Shape, ANY, Value(20.0)),
    row("I", &["G282", "G283"], "I", "peck", Length, Cutting, SIZE, Value(5.0)),
    row("I", &[], "I", "level", Length, Cutting, ANY, Value(5.0)),
    row("I1", &[], "I1", "level", Length, Cutting, ANY, Value(5.0)),
    row("I2", &[], "I2", "semi-level", Length, Cutting, ANY, Value(2.0)),
    row("step", &["G299"], "Δ", "radial-step", Length, Cutting, SIZE, Value(0.5)),
    row("step", &[], "Δ", "step", Length, Cutting, SIZE, Value(0.0)),
    row("E", &[], "E", "overrun", Length, Cutting, SIZE, Value(2.0)),
    row("delta", &[], "δ", "wall-stock", Length, Cutting, SIZE, Value(0.2)),
    row("deltaz", &[], "δz", "floor-stock", Length, Cutting, SIZE, Value(0.1)),
    row("eps", &[], "ε", "wall-width", Length, Cutting, SIZE, Value(1.0)),
    row("N", &["LINE", "ARC"], "N", "figure-count", Count, Shape, (1.0, 9999.0), Value(3.0)),
    row("N", &["G299"], "N", "edges", Count, Cutting, (1.0, 1000.0), Value(1.0)),
    row("N", POCKETS, "N", "wall-passes", Count, Cutting, (0.0, 10_000.0), Value(1.0)),
    row("beta", &["ARC"], "β", "angle-between", Angle, Shape, TURN, Value(30.0)),
    row("beta", &["RECT", "GRID"], "β", "rows-angle", Angle, Shape, (1.0, 179.0), Value(90.0)),
    row("beta", &[], "β", "rough-entry", Angle, Cutting, ENTRY, Value(5.0)),
    row("theta", &[], "θ", "finish-entry", Angle, Cutting, ENTRY, Value(5.0)),
    row("FZ", &[], "Fz", "plunge", Feed, Cutting, PLUNGE, Value(0.0)),
    row("wall", &[], "", "wall-way", Choice, Cutting, NONE, Word("down")),
    row("comp", &[], "", "compensation", Choice, Cutting, NONE, Word("none")),
    row("dir", &[], "", "direction", Choice, Cutting, NONE, Word("ccw")),
    row("bottom", &[], "", "bottom", Choice, Cutting, NONE, Word("yes")),
    row("cut", &[], "", "thread-cut", Choice, Cutting, NONE, Word("down")),
    row("tool", &[], "", "thread-tool", Choice, Cutting, NONE, Word("full")),
    row("DS", &[], "Ds", "thread-approach", Length, Cutting, SIZE, Value(0.0)),
    row("retract", &[], "", "bore-retract", Choice, Cutting, NONE, Word("feed")),
    row("type", &[], "", "tap-type", Choice, Cutting, NONE, Word("rigid")),
    row("feedtype", &[], "", "tap-feed", Choice, Cutting, NONE, Word("rev")),
    row("KF", &[], "Kf", "tap-factor", Factor, Cutting, (0.01, 10.0), Value(1.0)),
    row("t", &[], "t", "dwell", Time, Cutting, (0.0, 9999.0), Value(0.0)),
    // With which tool.
    row("T", &[], "T", "tool-number", Measure::Tool, Tool, (0.0, 9999.0), Value(1.0)),
    row("D", &[], "D", "offset-number", Number, Tool, (0.0, 9999.0), Value(1.0)),
    row("F", &["G284"], "F", "tap-pitch", Feed, Tool, FEEDS, Value(1.5)),
    row("F", &[], "F", "feed", Feed, Tool, FEEDS, Value(300.0)),
    row("S", &["G284"], "S", "speed", Speed, Tool, (1.0, 100_000.0), Value(300.0)),
    row("S", &[], "S", "speed", Speed, Tool, (0.0, 100_000.0), Value(2000.0)),
    row("spindle", &[], "", "spindle", Choice, Tool, NONE, Word("cw")),
    row("M1", &[], "M", "m-function", Number, Tool, (0.0, 999.0), Empty),
    row("M2", &[], "M", "m-function", Number, Tool, (0.0, 999.0), Empty),
    row("M3", &[], "M", "m-function", Number, Tool, (0.0, 999.0), Empty),
    row("M4", &[], "M", "m-function", Number, Tool, (0.0, 999.0), Empty),
    row("next", &[], "", "next-tool", Measure::Tool, Tool, (0.0, 9999.0), Empty),
    // Figures (4.23 to 4.27).
    row("XN", &["LINE"], "Xn", "last-x", Length, Shape, ANY, Empty),
    row("YN", &["LINE"], "Yn", "last-y", Length, Shape, ANY, Empty),
    row("XA", &[], "Xa", "figure-centre-x", Length, Shape, ANY, Value(30.0)),
    row("YA", &[], "Ya", "figure-centre-y", Length, Shape, ANY, Value(0.0)),
    row("tau", &[], "τ", "last-angle", Angle, Shape, TURN, Empty),
    row("LX", &[], "Lx", "row-length-x", Length, Shape, ANY, Empty),
    row("NX", &[], "Nx", "row-count-x", Count, Shape, (1.0, 9999.0), Value(3.0)),
    row("IX", &[], "Ix", "row-distance-x", Length, Shape, ANY, Value(20.0)),
    row("LY", &[], "Ly", "row-length-y", Length, Shape, ANY, Empty),
    row("NY", &[], "Ny", "row-count-y", Count, Shape, (1.0, 9999.0), Value(2.0)),
    row("IY", &[], "Iy", "row-distance-y", Length, Shape, ANY, Value(20.0)),
    // P1 to P25 of a profile point by point, P2 to P12 of a figure.
    row("P#", &[], "P", "points", Point, Shape, NONE, Empty),
];

/// The row of a parameter, with its place among them.
pub fn field(of: &str, name: &str) -> Option<(usize, &'static Field)> {
    let numbered =
        name.strip_prefix('P').is_some_and(|n| !n.is_empty() && n.bytes().all(|b| b.is_ascii_digit()));
    let name = if numbered { "P#" } else { name };
    FIELDS.iter().enumerate().find(|(_, f)| f.name == name && (f.of.is_empty() || f.of.contains(&of)))
}
