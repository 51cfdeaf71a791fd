//! The cycles of the editor, G281 to G299 with the profile pockets (4.2 to 4.22), and the positions associated with them (4.23 to
//! 4.27).
//!
//! The control keeps them in a dialogue. As text a cycle is a `#CYCLE` block, its stages `#ROUGH` and
//! `#FINISH`, its positions `#MULTI`; the manual's symbols are the names of parameters, Greek letters in
//! words. Lengths and feeds are in the units of the program, feeds always a minute.
//!
//! One file a group of the editor: `holes`, `pockets`, `bosses`, `milling`, `profiles`, `profile_pockets`,
//! `positions`. This one has what they share: the planes of 4.1.2 and the values that stand for 0 (4.1.3).

mod bosses;
mod holes;
mod milling;
mod pockets;
mod positions;
mod profile_pockets;
mod profiles;

pub use positions::FIGURES;

use crate::cycles::acts::FeedUnit;
use crate::cycles::area::{CLEAR, Cut, Entry, Planes};
use crate::cycles::depth::{Levels, MAX_LEVELS};
use crate::cycles::described::{DescribedCycle, Description, Kind, Parameter, Part, Plan, Section, Stage};
use crate::cycles::milling::steps;
use crate::cycles::operation::{Operation, Work};
use crate::cycles::parameter::{WrongParameter, refuse};
use crate::cycles::tool::Frame;
use crate::cycles::zone::ToolData;
use ferrocut_geometry::{SAME_POINT_MM, Turn};
use ferrocut_machine::Fault;

type Made = Result<Plan, WrongParameter>;

const fn length(name: &'static str) -> Parameter {
    Parameter { name, kind: Kind::Length }
}

const fn number(name: &'static str) -> Parameter {
    Parameter { name, kind: Kind::Number }
}

const fn words(name: &'static str, of: &'static [&'static str]) -> Parameter {
    Parameter { name, kind: Kind::Word(of) }
}

const fn name(name: &'static str) -> Parameter {
    Parameter { name, kind: Kind::Name }
}

const fn point(name: &'static str) -> Parameter {
    Parameter { name, kind: Kind::Point }
}

const SENSES: &[&str] = &["cw", "ccw"];

/// The parameters of a list of lists, in one.
const fn joined<const N: usize>(lists: &[&[Parameter]]) -> [Parameter; N] {
    let mut all = [number(""); N];
    let (mut at, mut list) = (0, 0);
    while list < lists.len() {
        let mut place = 0;
        while place < lists[list].len() {
            all[at] = lists[list][place];
            at += 1;
            place += 1;
        }
        list += 1;
    }
    assert!(at == N);
    all
}

/// Tool and spindle of a stage, and M functions before it (3.1).
const TOOL: [Parameter; 9] = [
    length("F"),
    number("S"),
    number("T"),
    number("D"),
    words("spindle", SENSES),
    number("M1"),
    number("M2"),
    number("M3"),
    number("M4"),
];

/// Direction of machining.
const DIRECTION: [Parameter; 1] = [words("dir", SENSES)];

/// The tool that is prepared (3.1).
const NEXT: Parameter = Parameter { name: "next", kind: Kind::NextTool };

/// Planes of 4.1.2, and that tool.
const PLANES: [Parameter; 4] = [length("Z"), length("ZS"), length("P"), NEXT];

/// The point.
const POINT: [Parameter; 2] = [length("X"), length("Y")];

/// The same where the manual calls it a centre.
const CENTRE: [Parameter; 2] = [length("XC"), length("YC")];

/// P1 to P25, each with the corner made there.
const POINTS: [Parameter; 25] = [
    point("P1"),
    point("P2"),
    point("P3"),
    point("P4"),
    point("P5"),
    point("P6"),
    point("P7"),
    point("P8"),
    point("P9"),
    point("P10"),
    point("P11"),
    point("P12"),
    point("P13"),
    point("P14"),
    point("P15"),
    point("P16"),
    point("P17"),
    point("P18"),
    point("P19"),
    point("P20"),
    point("P21"),
    point("P22"),
    point("P23"),
    point("P24"),
    point("P25"),
];

/// A list of points has no gap: none is given behind `missing`, which is not.
fn check_no_gap(section: &Section, list: &[Parameter], missing: &'static str) -> Result<(), WrongParameter> {
    let behind = list.iter().skip_while(|parameter| parameter.name != missing);
    let is_gap = behind.into_iter().any(|parameter| section.point(parameter.name).is_some());
    refuse(is_gap, Fault::CycleParameterMissing, missing)
}

/// Both coordinates of a point; none where neither is given.
fn both(
    section: &Section,
    [x, y]: [&'static str; 2],
    fault: Fault,
) -> Result<Option<[f64; 2]>, WrongParameter> {
    match (section.given(x), section.given(y)) {
        (Some(x), Some(y)) => Ok(Some([x, y])),
        (None, None) => Ok(None),
        (None, Some(_)) => Err(WrongParameter::new(fault, x)),
        (Some(_), None) => Err(WrongParameter::new(fault, y)),
    }
}

/// Every cycle.
pub static CYCLES: &[DescribedCycle] = &[
    holes::CENTRE_PUNCHING,
    holes::DRILLING,
    holes::DEEP_DRILLING,
    holes::TAPPING,
    holes::REAMING,
    holes::BORING,
    pockets::RECTANGULAR,
    pockets::CIRCULAR,
    pockets::SIMPLE,
    milling::SURFACE,
    bosses::RECTANGULAR,
    bosses::CIRCULAR,
    profiles::POINT_TO_POINT,
    profiles::FREE,
    milling::SLOT,
    pockets::PRE_EMPTIED,
    holes::ORIENTED_BORING,
    holes::BORE_MILLING,
    holes::THREAD_MILLING,
    profile_pockets::FLAT,
    profile_pockets::DEEP,
];

/// The planes of a cycle, which way is up, and its depth (4.1.2).
struct Placed {
    planes: Planes,
    up: f64,
    depth: f64,
}

impl Placed {
    /// From the surface Z, the safety plane ZS and the depth: the part lies on the far side of Z from ZS; where
    /// both are one, the sign of the depth says so. The approach plane is never beyond the safety plane.
    fn new(main: &Section, approach: f64, depth: f64) -> Result<Placed, WrongParameter> {
        let (surface, safety) = (main.number("Z"), main.number("ZS"));
        let up = match safety - surface {
            above if above > 0.0 => 1.0,
            above if above < 0.0 => -1.0,
            _ if depth < 0.0 => -1.0,
            _ => 1.0,
        };
        refuse(!(approach >= 0.0 && approach.is_finite()), Fault::CycleParameter, "DP")?;
        // A depth below what an axis can tell is none.
        refuse(!(depth.abs() > SAME_POINT_MM && depth.is_finite()), Fault::CycleNoDepth, "P")?;
        let near = approach.min((safety - surface).abs());
        let planes = Planes { safety, approach: surface + up * near, surface };
        Ok(Placed { planes, up, depth: depth.abs() })
    }

    /// Those of a milling cycle, whose approach plane is 1 mm above the surface.
    fn of(main: &Section) -> Result<Placed, WrongParameter> {
        Placed::new(main, CLEAR, main.number("P"))
    }

    /// The level at a depth.
    fn at(&self, depth: f64) -> f64 {
        self.planes.surface - self.up * depth
    }

    /// Where the first rapid of a finishing stage ends: 1 mm above the roughed floor, or, where this cycle does
    /// not rough, on the approach plane, since what lies below is not known.
    fn above_floor(&self, roughs: bool, floor_stock: f64) -> f64 {
        if !roughs {
            return self.planes.approach;
        }
        let above = self.at(self.depth - floor_stock - CLEAR);
        let beyond = (above - self.planes.approach) * self.up > 0.0;
        if beyond { self.planes.approach } else { above }
    }
}

/// A word of the cycle that says which way round.
fn turn(section: &Section, name: &str) -> Turn {
    match section.word(name, "cw") {
        "ccw" => Turn::CounterClockwise,
        _ => Turn::Clockwise,
    }
}

/// A feed; none given is an alarm.
fn feed(section: &Section) -> Result<f64, WrongParameter> {
    let feed = section.number("F");
    refuse(!(feed > 0.0 && feed.is_finite()), Fault::CycleNoFeed, "F")?;
    Ok(feed)
}

/// A feed of which 0 stands for half the milling feed (4.1.3).
fn plunge(section: &Section, name: &'static str, milling: f64) -> Result<f64, WrongParameter> {
    match section.number(name) {
        0.0 => Ok(milling / 2.0),
        feed if feed > 0.0 && feed.is_finite() => Ok(feed),
        _ => Err(WrongParameter::new(Fault::CycleParameter, name)),
    }
}

/// The tool of a stage with its offset, the first where none is given.
fn tool(description: &Description<'_>, section: &Section) -> ToolData {
    description.tool(section.number("T"), edge(section))
}

fn edge(section: &Section) -> f64 {
    section.given("D").unwrap_or(1.0)
}

/// A stage with the tool and spindle of a section.
fn stage(section: &Section, operation: Operation) -> Stage {
    Stage {
        tool: section.number("T"),
        edge: edge(section),
        speed: section.number("S"),
        turn: Some(turn(section, "spindle")),
        m: ["M1", "M2", "M3", "M4"].map(|name| section.given(name)),
        operation,
        unit: FeedUnit::Minute,
    }
}

/// The tool prepared for afterwards.
fn next_tool(main: &Section) -> Result<Option<u32>, WrongParameter> {
    let Some(number) = main.given("next") else { return Ok(None) };
    refuse(number.fract() != 0.0 || !(0.0..=9999.0).contains(&number), Fault::CycleParameter, "next")?;
    Ok((number > 0.0).then_some(number as u32))
}

/// A plan at a point given by two names.
fn plan(main: &Section, [x, y]: [&str; 2], placed: &Placed, stages: Vec<Stage>) -> Made {
    plan_at([main.number(x), main.number(y)], main, placed, stages)
}

/// A plan at a point. That of a profile is the origin: its points are coordinates themselves.
fn plan_at(at: [f64; 2], main: &Section, placed: &Placed, stages: Vec<Stage>) -> Made {
    let (safety, next_tool) = (placed.planes.safety, next_tool(main)?);
    Ok(Plan { at, safety, stages, next_tool, warnings: Vec::new() })
}

/// How a stage cuts. `step` is the section's parameter, `plunge` its feed into the material.
fn cut(section: &Section, data: &ToolData, plunge: f64) -> Result<Cut, WrongParameter> {
    let step = section.number("step");
    Cut { radius: data.radius, step, feed: feed(section)?, plunge }.check("step")
}

/// Passes in depth along a wall: N, 0 for the fewest that the cutting length allows, which limits them in any
/// case (4.1.3). Without a cutting length, 0 is one for each roughing pass, of the same tool.
fn wall_levels(
    finish: &Section,
    depth: f64,
    data: &ToolData,
    rough: Option<(&Section, Levels)>,
) -> Result<Levels, WrongParameter> {
    let passes = finish.number("N");
    refuse(passes.fract() != 0.0 || !(0.0..=10_000.0).contains(&passes), Fault::CycleParameter, "N")?;
    let least = if data.cutting_length > 0.0 { steps(depth, data.cutting_length) } else { 0.0 };
    refuse(!(least <= MAX_LEVELS), Fault::MillTooManyMoves, "N")?;
    if passes > 0.0 || least > 0.0 {
        return Ok(Levels::equal(depth, passes.max(least)));
    }
    match rough {
        Some((section, levels)) if section.number("T") == finish.number("T") => Ok(levels.down_to(depth)),
        _ => Err(WrongParameter::new(Fault::CycleToolsDiffer, "N")),
    }
}

/// Whether a stage is done: its tool is not 0.
fn works(section: &Section) -> bool {
    section.number("T") != 0.0
}

/// The angle of an entry, and the way it is made.
fn entry(
    section: &Section,
    name: &'static str,
    data: &ToolData,
    way: impl Fn(f64) -> Entry,
) -> Result<Entry, WrongParameter> {
    let angle = Entry::angle(section.number(name), data.entry_angle, name)?;
    Ok(angle.map_or(Entry::Straight, way))
}

/// What is to be said of those of these stages that go down through solid material and find no entry angle in
/// the cycle nor for their tool: they go straight down (4.1.3), which many a mill does not stand. Finishing does so where nothing
/// was roughed, and where roughing `left` something.
fn straight_down(description: &Description<'_>, stages: &[Part], left: bool) -> Vec<WrongParameter> {
    let of = |stage: &Part| {
        let is_drilled = description.has(Part::Drill) && works(description.part(Part::Drill));
        let (angle, is_solid) = match stage {
            Part::Finish if works(description.part(Part::Rough)) => ("theta", left),
            Part::Finish => ("theta", !is_drilled),
            _ => ("beta", !is_drilled),
        };
        let section = description.part(*stage);
        let is_given = || section.number(angle) != 0.0 || tool(description, section).entry_angle != 0.0;
        let is_straight = is_solid && works(section) && !is_given();
        is_straight.then(|| WrongParameter::new(Fault::NoEntryAngle, angle).of_part(directive(*stage)))
    };
    stages.iter().filter_map(of).collect()
}

/// The directive that describes a part.
fn directive(part: Part) -> &'static str {
    match part {
        Part::Main => "#CYCLE",
        Part::Drill => "#DRILL",
        Part::Rough => "#ROUGH",
        Part::Semi => "#SEMI",
        Part::Finish => "#FINISH",
    }
}

/// Parameters of the roughing of an area.
fn of_rough<T>(made: Result<T, WrongParameter>) -> Result<T, WrongParameter> {
    made.map_err(|wrong| wrong.of_part(directive(Part::Rough)))
}

/// The same of its finishing.
fn of_finish<T>(made: Result<T, WrongParameter>) -> Result<T, WrongParameter> {
    made.map_err(|wrong| wrong.of_part(directive(Part::Finish)))
}

/// Where a rectangle lies from its point: the frame about its middle and half its sizes. With a corner given
/// it lies on the side that the signs of L and H say; it turns about the point.
fn rectangle(main: &Section, is_centre: bool, turn: Turn) -> Result<(Frame, [f64; 2]), WrongParameter> {
    let (l, h) = (main.number("L"), main.number("H"));
    for (size, name) in [(l, "L"), (h, "H")] {
        refuse(!(size != 0.0 && size.is_finite()), Fault::CycleParameter, name)?;
    }
    let angle = main.number("alpha");
    let about = Frame::new([0.0; 2], angle, Turn::CounterClockwise);
    let middle = if is_centre { [0.0; 2] } else { about.world([l / 2.0, h / 2.0]) };
    Ok((Frame::new(middle, angle, turn), [l.abs() / 2.0, h.abs() / 2.0]))
}

/// The frame about a corner of a rectangle given by a point and signed sizes: u and v lead into it.
fn corner_frame(main: &Section, right: bool, upper: bool) -> Result<(Frame, [f64; 2]), WrongParameter> {
    let (frame, half) = rectangle(main, false, Turn::CounterClockwise)?;
    let sign = |positive: bool| if positive { 1.0 } else { -1.0 };
    let corner = frame.about([sign(right) * half[0], sign(upper) * half[1]]);
    Ok((corner.flipped([right, upper]), [2.0 * half[0], 2.0 * half[1]]))
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn every_cycle_of_the_manual_is_there_once() {
        let ids: Vec<&str> = CYCLES.iter().map(|cycle| cycle.id).collect();
        let expected: Vec<String> = (281..=299).map(|number| format!("G{number}")).collect();
        let mut sorted = ids.clone();
        sorted.sort_unstable();
        assert_eq!(
            sorted.iter().filter(|id| id.starts_with('G')).collect::<Vec<_>>(),
            expected.iter().collect::<Vec<_>>()
        );
    }

    #[test]
    fn names_of_parameters_are_their_own() {
        for cycle in CYCLES {
            for (part, parameters) in cycle.parts {
                for (place, parameter) in parameters.iter().enumerate() {
                    let twice = parameters.iter().skip(place + 1).any(|p| p.name == parameter.name);
                    assert!(!twice, "{} {part:?} {}", cycle.id, parameter.name);
                }
            }
            assert!(cycle.parts.iter().any(|(part, _)| *part == Part::Main), "{}", cycle.id);
        }
    }
}
