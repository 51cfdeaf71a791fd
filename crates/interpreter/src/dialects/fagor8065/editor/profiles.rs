//! Profiles point by point and free ones (4.20, 4.21).

use super::*;
use crate::cycles::area::pocket::check_stock;
use crate::cycles::area::profile::{Element, Profile, ProfileError, ProfileMilling, Ways};
use crate::directives::ProfileAxes;
use crate::stages::cutter::{Offset, Side};
use ferrocut_program::Span;

const ROUGH: [Parameter; 12] =
    joined(&[&TOOL, &[length("FZ"), length("I"), words("comp", &["none", "left", "right"])]]);

const FINISH: [Parameter; 10] = joined(&[&TOOL, &[length("delta")]]);

/// 4.20.
pub const POINT_TO_POINT: DescribedCycle = DescribedCycle {
    id: "G293",
    parts: &[
        (
            Part::Main,
            &joined::<35>(&[
                &[length("X1"), length("Y1"), length("R1")],
                &POINTS,
                &[length("RN"), length("XN"), length("YN")],
                &PLANES,
            ]),
        ),
        (Part::Rough, &ROUGH),
        (Part::Finish, &FINISH),
    ],
    repeats: false,
    build: point_to_point,
};

/// 4.21.
pub const FREE: DescribedCycle = DescribedCycle {
    id: "G294",
    parts: &[
        (Part::Main, &joined::<7>(&[&POINT, &PLANES, &[name("profile")]])),
        (Part::Rough, &ROUGH),
        (Part::Finish, &FINISH),
    ],
    repeats: false,
    build: free,
};

/// What a profile cannot be, told of the parameters of its cycle.
fn wrong(error: ProfileError, profile: &'static str, [entry, exit]: [&'static str; 2]) -> WrongParameter {
    match error {
        ProfileError::Empty => WrongParameter::new(Fault::ProfileForm, profile),
        ProfileError::Corner(_) => WrongParameter::new(Fault::ProfileCorner, profile),
        ProfileError::Entry => WrongParameter::new(Fault::ProfileWay, entry),
        ProfileError::Exit => WrongParameter::new(Fault::ProfileWay, exit),
        ProfileError::Beside(fault) => WrongParameter::new(fault, profile),
    }
}

/// P1 to P25: the first point that is not used repeats the last one that is.
fn points(main: &Section) -> Result<Profile, WrongParameter> {
    let mut start = None;
    let mut elements = Vec::new();
    let mut at = [0.0; 2];
    for parameter in POINTS {
        let Some((to, corner)) = main.point(parameter.name) else {
            check_no_gap(main, &POINTS, parameter.name)?;
            break;
        };
        if start.is_none() {
            refuse(corner.is_some(), Fault::ProfileCorner, parameter.name)?;
            start = Some(to);
        } else {
            if (to[0] - at[0]).hypot(to[1] - at[1]) <= SAME_POINT_MM {
                break;
            }
            let corner = corner.map(|(kind, size)| (kind, size, Span::default()));
            elements.push((Element::Line { to }, corner));
        }
        at = to;
    }
    let start = start.ok_or(WrongParameter::new(Fault::CycleParameterMissing, "P1"))?;
    Profile::new(start, elements).map_err(|error| wrong(error, "P2", ["R1", "RN"]))
}

fn point_to_point(description: &Description<'_>) -> Made {
    let main = description.part(Part::Main);
    let profile = points(main)?;
    let ways = Ways {
        from: [main.number("X1"), main.number("Y1")],
        entry: main.number("R1"),
        to: both(main, ["XN", "YN"], Fault::CycleParameterMissing)?,
        exit: main.number("RN"),
    };
    refuse(!(ways.entry >= 0.0), Fault::CycleParameter, "R1")?;
    refuse(!(ways.exit >= 0.0), Fault::CycleParameter, "RN")?;
    // Without compensation there is no finishing.
    follow(description, &profile, ways, ["P1", "R1", "RN"], false)
}

fn free(description: &Description<'_>) -> Made {
    let main = description.part(Part::Main);
    let name = main.name("profile").ok_or(WrongParameter::new(Fault::CycleParameterMissing, "profile"))?;
    let missing = WrongParameter::new(Fault::ProfileMissing, "profile");
    let recorded = description.profiles.get(name).ok_or(missing)?;
    let [contour] = recorded.contours.as_slice() else {
        return Err(WrongParameter::new(Fault::ProfileForm, "profile"));
    };
    refuse(recorded.axes != ProfileAxes::Plane, Fault::ProfileForm, "profile")?;
    // What is followed from a start to an end has no corner between the two.
    refuse(contour.closing.is_some(), Fault::ProfileCorner, "profile")?;
    let ways = Ways {
        from: [main.number("X"), main.number("Y")],
        entry: contour.entry,
        to: None,
        exit: contour.exit,
    };
    // Without compensation finishing runs along the same path.
    follow(description, &contour.profile, ways, ["profile"; 3], true)
}

fn follow(
    description: &Description<'_>,
    profile: &Profile,
    ways: Ways,
    [name, entry, exit]: [&'static str; 3],
    finishes_without: bool,
) -> Made {
    let main = description.part(Part::Main);
    let (rough, finish) = (description.part(Part::Rough), description.part(Part::Finish));
    let placed = Placed::of(main)?;
    let stock = finish.number("delta");
    of_finish(check_stock(stock, "delta"))?;
    let side = match rough.word("comp", "none") {
        "left" => Some(Side::Left),
        "right" => Some(Side::Right),
        _ => None,
    };
    let made = |section: &Section, levels: Levels, stock: f64, returns: bool| {
        let radius = tool(description, section).radius;
        refuse(side.is_some() && !(radius > 0.0), Fault::MillToolMissing, "T")?;
        let milling = feed(section)?;
        let offset = side.map(|side| Offset { side, radius: radius + stock });
        let path = ways.path(profile, offset).map_err(|error| wrong(error, name, [entry, exit]))?;
        let feeds = [milling, plunge(rough, "FZ", milling)?];
        let work = ProfileMilling { path, planes: placed.planes, levels, feeds, returns };
        Ok(stage(section, Operation::plain(Work::Profile(work), placed.up)))
    };
    let mut stages = Vec::with_capacity(2);
    if works(rough) {
        let cutting_length = tool(description, rough).cutting_length;
        let levels = of_rough(Levels::within(placed.depth, rough.number("I"), cutting_length, "I"))?;
        stages.push(of_rough(made(rough, levels, stock, true))?);
    }
    if works(finish) && (side.is_some() || finishes_without) {
        stages.push(of_finish(made(finish, Levels::equal(placed.depth, 1.0), 0.0, false))?);
    }
    plan_at([0.0; 2], main, &placed, stages)
}
