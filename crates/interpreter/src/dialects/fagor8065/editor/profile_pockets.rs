//! Pockets of any profile with islands: 2D (4.15) and 3D (4.16).
//!
//! Their points are coordinates themselves, and the direction of machining is that of the profiles, so that
//! they have neither a point nor a direction of their own.

use super::*;
use crate::cycles::area::profile::{self, Element};
use crate::cycles::described::Entry as Value;
use crate::cycles::pocket::{
    self, DepthProfile, Finish2d, Finish3d, Plan2d, Plan3d, Planning, Pocket2d, Pocket3d, PocketCut,
    PocketFault, PocketKind, PocketPlan, Problem, Rough2d, Rough3d, Segment, Semi3d, WallDirection, corner,
};
use crate::directives::{Contour, ProfileAxes, RecordedProfile};
use crate::stages::corner::CornerKind;
use std::sync::Arc;

/// What a pocket is called, and its contours.
const NAMES: [Parameter; 2] = [name("pocket"), name("profile")];

/// The drilling of 4.3 without its point: those are the pocket's to find.
const DRILL: [Parameter; 16] = joined(&[
    &TOOL,
    &[length("Z"), length("ZS"), length("P"), length("DP"), number("t")],
    &[length("I"), length("ZR")],
]);

/// 4.15.
pub const FLAT: DescribedCycle = DescribedCycle {
    id: "P2D",
    parts: &[
        (Part::Main, &joined::<6>(&[&NAMES, &PLANES])),
        (Part::Drill, &DRILL),
        (Part::Rough, &joined::<13>(&[&TOOL, &[length("step"), length("I"), length("FZ"), number("beta")]])),
        (
            Part::Finish,
            &joined::<14>(&[
                &TOOL,
                &[length("delta"), length("deltaz"), length("step"), number("N"), number("theta")],
            ]),
        ),
    ],
    repeats: false,
    build: flat,
};

/// 4.16.
pub const DEEP: DescribedCycle = DescribedCycle {
    id: "P3D",
    parts: &[
        (Part::Main, &joined::<10>(&[&NAMES, &PLANES, &[name("Z1"), name("Z2"), name("Z3"), name("Z4")]])),
        (Part::Rough, &joined::<13>(&[&TOOL, &[length("step"), length("I1"), length("FZ"), number("beta")]])),
        (Part::Semi, &joined::<10>(&[&TOOL, &[length("I2")]])),
        (
            Part::Finish,
            &joined::<12>(&[
                &TOOL,
                &[length("delta"), length("eps"), words("wall", &["down", "up", "zigzag"])],
            ]),
        ),
    ],
    repeats: false,
    build: deep,
};

/// The profile that a parameter names.
fn recorded<'a>(
    description: &Description<'a>,
    parameter: &'static str,
) -> Result<Option<&'a RecordedProfile>, WrongParameter> {
    let Some(name) = description.part(Part::Main).name(parameter) else { return Ok(None) };
    let missing = WrongParameter::new(Fault::ProfileMissing, parameter);
    description.profiles.get(name).map(Some).ok_or(missing)
}

/// The elements of a profile as segments, nothing of no length among them.
fn segments(profile: &profile::Profile) -> Vec<Segment> {
    let of = |(from, element): ([f64; 2], &Element)| match *element {
        Element::Line { to } => Segment::Line { from, to },
        Element::Arc { to, center, sweep } => Segment::Arc { from, to, center, sweep },
    };
    profile.pieces().map(of).filter(|segment| segment.length() > SAME_POINT_MM).collect()
}

/// A closed contour with the corner between its end and its start.
fn contour(contour: &Contour, number: usize) -> Result<pocket::Profile, WrongParameter> {
    let segments = segments(&contour.profile);
    let Some((kind, size)) = contour.closing else { return Ok(pocket::Profile { segments }) };
    let closing = match kind {
        CornerKind::Round => corner::Corner::Round(size),
        CornerKind::Chamfer => corner::Corner::Chamfer(size),
    };
    let last = segments.len().saturating_sub(1);
    let of = |(n, segment)| corner::Drawn {
        segment,
        corner: if n == last { closing } else { corner::Corner::Sharp },
    };
    let drawn: Vec<corner::Drawn> = segments.into_iter().enumerate().map(of).collect();
    let no_room =
        |_| WrongParameter { contour: Some(number), ..WrongParameter::new(Fault::ProfileCorner, "profile") };
    corner::profile(&drawn).map_err(no_room)
}

/// The outer contour and the islands.
fn contours(
    description: &Description<'_>,
) -> Result<(pocket::Profile, Vec<pocket::Profile>), WrongParameter> {
    let missing = WrongParameter::new(Fault::CycleParameterMissing, "profile");
    let recorded = recorded(description, "profile")?.ok_or(missing)?;
    refuse(recorded.axes != ProfileAxes::Plane, Fault::ProfileForm, "profile")?;
    let all: Vec<pocket::Profile> = recorded
        .contours
        .iter()
        .enumerate()
        .map(|(number, drawn)| contour(drawn, number))
        .collect::<Result<_, _>>()?;
    let mut all = all.into_iter();
    let outer = all.next().ok_or(WrongParameter::new(Fault::ProfileForm, "profile"))?;
    Ok((outer, all.collect()))
}

/// P.Z1 to P.Z4, of so many contours.
fn depth_profiles(
    description: &Description<'_>,
    contours: usize,
) -> Result<Vec<Option<DepthProfile>>, WrongParameter> {
    let one = |(number, parameter): (usize, &'static str)| {
        let Some(recorded) = recorded(description, parameter)? else { return Ok(None) };
        let form = || WrongParameter::new(Fault::ProfileForm, parameter);
        let ProfileAxes::Depth(axis) = recorded.axes else { return Err(form()) };
        let [drawn] = recorded.contours.as_slice() else { return Err(form()) };
        refuse(number >= contours || drawn.closing.is_some(), Fault::DepthProfile, parameter)?;
        Ok(Some(DepthProfile { segments: segments(&drawn.profile), axis }))
    };
    ["Z1", "Z2", "Z3", "Z4"].into_iter().enumerate().map(one).collect()
}

/// What forbids a pocket, told of the parameters of its cycle.
fn wrong(description: &Description<'_>, fault: PocketFault) -> WrongParameter {
    let is_profile = matches!(fault.parameter, "profile" | "Z1" | "Z2" | "Z3" | "Z4");
    let stage = match fault.stage {
        _ if is_profile => None,
        Some(pocket::Stage::Rough) => Some(Part::Rough),
        Some(pocket::Stage::Semi) => Some(Part::Semi),
        Some(pocket::Stage::Finish) => Some(Part::Finish),
        None => match fault.parameter {
            "delta" | "deltaz" => Some(Part::Finish),
            "beta" => Some(Part::Rough),
            "drill" => Some(Part::Drill),
            _ => None,
        },
    };
    let is_angle = matches!(fault.parameter, "beta" | "theta");
    let kind = match fault.problem {
        Problem::ProfileOpen => Fault::ProfileOpen,
        Problem::ProfileEmpty => Fault::ProfileEmpty,
        Problem::ProfileCrossesItself | Problem::IslandCrosses => Fault::ProfileCrosses,
        Problem::ArcEnds => Fault::ProfileForm,
        Problem::CornerTooLarge => Fault::ProfileCorner,
        Problem::IslandOutside => Fault::IslandOutside,
        Problem::TooManyDepthProfiles | Problem::DepthProfileStart | Problem::DepthProfileTurnsBack => {
            Fault::DepthProfile
        }
        Problem::WallsMeet => Fault::WallsMeet,
        Problem::ToolMissing => Fault::MillToolMissing,
        Problem::ToolTooLarge | Problem::DrillTooLarge => Fault::CycleToolTooLarge,
        Problem::StepTooLarge => Fault::CycleStepTooWide,
        Problem::DepthMissing => Fault::CycleNoDepth,
        Problem::DepthStepMissing => Fault::CycleNoCuttingLength,
        Problem::EntryAngle => Fault::CycleEntryAngle,
        Problem::Negative | Problem::OutOfRange if is_angle => Fault::CycleEntryAngle,
        Problem::Negative | Problem::OutOfRange => Fault::CycleParameter,
        Problem::TooManyMoves => Fault::MillTooManyMoves,
        Problem::NoPath => Fault::PocketPath,
    };
    let word = if fault.parameter == "drill" { "T" } else { fault.parameter };
    let mut wrong = WrongParameter { contour: fault.contour, ..WrongParameter::new(kind, word) };
    if let Some(part) = stage {
        let section = description.part(part);
        let radius = tool(description, section).radius;
        wrong.values = match fault.problem {
            Problem::StepTooLarge => Some([section.number("step"), 2.0 * radius]),
            Problem::DrillTooLarge => {
                let mill = if works(description.part(Part::Rough)) { Part::Rough } else { Part::Finish };
                Some([radius, Plan2d::largest_drill(tool(description, description.part(mill)).radius)])
            }
            _ => None,
        };
        wrong = wrong.of_part(directive(part));
    }
    wrong
}

/// What a pocket asks of the tool of a stage.
fn pocket_tool(description: &Description<'_>, section: &Section) -> pocket::Tool {
    let ToolData { radius, cutting_length, entry_angle, tip_radius } = tool(description, section);
    pocket::Tool { radius, tip_radius, cutting_length, entry_angle }
}

/// A stage of a pocket. Down it goes at the roughing FZ, or at half the feed of the stage (4.1.3, 4.15).
fn cut(
    description: &Description<'_>,
    section: &Section,
    plan: &Arc<PocketPlan>,
    of: pocket::Stage,
    up: f64,
) -> Result<Stage, WrongParameter> {
    let feed = feed(section)?;
    let down = of_rough(plunge(description.part(Part::Rough), "FZ", feed))?;
    let cut = PocketCut { plan: Arc::clone(plan), stage: of, feed, plunge: down };
    Ok(stage(section, Operation::plain(Work::ProfilePocket(cut), up)))
}

fn flat(description: &Description<'_>) -> Made {
    let main = description.part(Part::Main);
    let (rough, finish) = (description.part(Part::Rough), description.part(Part::Finish));
    let placed = Placed::of(main)?;
    let (outer, islands) = contours(description)?;
    let pocket = Pocket2d {
        outer,
        islands,
        surface: main.number("Z"),
        safety: main.number("ZS"),
        depth: main.number("P"),
        wall_stock: finish.number("delta"),
        floor_stock: finish.number("deltaz"),
        rough: works(rough).then(|| Rough2d {
            tool: pocket_tool(description, rough),
            step: rough.number("step"),
            depth_step: rough.number("I"),
            entry_angle: rough.number("beta"),
        }),
        finish: works(finish).then(|| Finish2d {
            tool: pocket_tool(description, finish),
            step: finish.number("step"),
            passes: finish.number("N"),
            entry_angle: finish.number("theta"),
        }),
    };
    if works(finish) {
        // A number of passes is whole.
        let passes = finish.number("N");
        of_finish(refuse(passes.fract() != 0.0, Fault::CycleParameter, "N"))?;
    }
    let planning =
        Planning { load: &|bytes| pocket.load(bytes), plan: &|| pocket.plan(), save: Plan2d::save };
    let plan = planning
        .with(description.kept, main.name("pocket"), PocketKind::Flat)
        .map_err(|fault| wrong(description, fault))?;
    let mut stages = drilling(description, &plan)?;
    let left = plan.finish_enters_solid();
    let plan = Arc::new(PocketPlan::Flat(plan));
    for (section, of) in [(rough, pocket::Stage::Rough), (finish, pocket::Stage::Finish)] {
        if works(section) {
            let made = cut(description, section, &plan, of, placed.up);
            stages.push(if of == pocket::Stage::Rough { of_rough(made)? } else { of_finish(made)? });
        }
    }
    let warnings = straight_down(description, &[Part::Rough, Part::Finish], left);
    Ok(Plan { warnings, ..plan_at([0.0; 2], main, &placed, stages)? })
}

/// The holes where the tool is to go down (4.15). Planes and depth that the drilling does not give are the
/// pocket's; it ends on the floor that roughing leaves.
fn drilling(description: &Description<'_>, plan: &Plan2d) -> Result<Vec<Stage>, WrongParameter> {
    let main = description.part(Part::Main);
    let drill = description.part(Part::Drill);
    if !works(drill) {
        return Ok(Vec::new());
    }
    let radius = tool(description, drill).radius;
    let points = plan.drilling(radius).map_err(|fault| wrong(description, fault))?;
    let left = if works(description.part(Part::Rough)) {
        description.part(Part::Finish).number("deltaz")
    } else {
        0.0
    };
    let depth = main.number("P");
    let mut section = drill.clone();
    for (name, value) in
        [("Z", main.number("Z")), ("ZS", main.number("ZS")), ("P", depth - left.copysign(depth))]
    {
        section.put(name, Value::Number(value));
    }
    let hole =
        holes::drilled_with(description, &section).map_err(|wrong| wrong.of_part(directive(Part::Drill)))?;
    let Some(hole) = hole.stages.into_iter().next() else { return Ok(Vec::new()) };
    let at = |(number, point): (usize, [f64; 2])| {
        let mut stage = hole.clone();
        stage.operation.frame = Frame::new(point, 0.0, Turn::CounterClockwise);
        if number > 0 {
            stage.m = [None; 4];
        }
        stage
    };
    Ok(points.into_iter().enumerate().map(at).collect())
}

fn deep(description: &Description<'_>) -> Made {
    let main = description.part(Part::Main);
    let [rough, semi, finish] = [Part::Rough, Part::Semi, Part::Finish].map(|part| description.part(part));
    let placed = Placed::of(main)?;
    let (outer, islands) = contours(description)?;
    let depth_profiles = depth_profiles(description, 1 + islands.len())?;
    let pocket = Pocket3d {
        outer,
        islands,
        depth_profiles,
        surface: main.number("Z"),
        safety: main.number("ZS"),
        depth: main.number("P"),
        wall_stock: finish.number("delta"),
        rough: works(rough).then(|| Rough3d {
            tool: pocket_tool(description, rough),
            step: rough.number("step"),
            depth_step: rough.number("I1"),
            entry_angle: rough.number("beta"),
        }),
        semi: works(semi)
            .then(|| Semi3d { tool: pocket_tool(description, semi), depth_step: semi.number("I2") }),
        finish: works(finish).then(|| Finish3d {
            tool: pocket_tool(description, finish),
            width: finish.number("eps"),
            direction: match finish.word("wall", "down") {
                "up" => WallDirection::Up,
                "zigzag" => WallDirection::Zigzag,
                _ => WallDirection::Down,
            },
        }),
    };
    let planning =
        Planning { load: &|bytes| pocket.load(bytes), plan: &|| pocket.plan(), save: Plan3d::save };
    let plan = planning
        .with(description.kept, main.name("pocket"), PocketKind::Deep)
        .map_err(|fault| wrong(description, fault))?;
    let plan = Arc::new(PocketPlan::Deep(plan));
    let mut stages = Vec::with_capacity(3);
    let all = [
        (rough, pocket::Stage::Rough, Part::Rough),
        (semi, pocket::Stage::Semi, Part::Semi),
        (finish, pocket::Stage::Finish, Part::Finish),
    ];
    for (section, of, part) in all {
        if works(section) {
            let made = cut(description, section, &plan, of, placed.up);
            stages.push(made.map_err(|wrong| wrong.part.map_or(wrong.of_part(directive(part)), |_| wrong))?);
        }
    }
    let warnings = straight_down(description, &[Part::Rough], false);
    Ok(Plan { warnings, ..plan_at([0.0; 2], main, &placed, stages)? })
}
