//! Operations along the tool axis (4.2 to 4.10).

use super::*;
use crate::cycles::bore_milling::{BoreMilling, BoreNames};
use crate::cycles::boring::{Aside, Bore, Way};
use crate::cycles::drilling::{Back, Hole, Leave, Pecks};
use crate::cycles::parameter::positive;
use crate::cycles::tapping::{Holder, TappedHole};
use crate::cycles::thread_milling::{ThreadMilling, ThreadNames};

/// Approach distance and dwell.
const HOLE: [Parameter; 2] = [length("DP"), number("t")];

const fn hole<const N: usize>(own: &[Parameter]) -> [Parameter; N] {
    joined(&[&POINT, &PLANES, &TOOL, &HOLE, own])
}

/// 4.2.
pub const CENTRE_PUNCHING: DescribedCycle = DescribedCycle {
    id: "G281",
    parts: &[(
        Part::Main,
        &hole::<20>(&[words("mode", &["depth", "angle"]), number("alpha"), length("phi")]),
    )],
    repeats: true,
    build: centre_punching,
};

/// 4.3.
pub const DRILLING: DescribedCycle = DescribedCycle {
    id: "G282",
    parts: &[(Part::Main, &hole::<19>(&[length("I"), length("ZR")]))],
    repeats: true,
    build: drilling,
};

/// 4.4.
pub const DEEP_DRILLING: DescribedCycle = DescribedCycle {
    id: "G283",
    parts: &[(Part::Main, &hole::<19>(&[length("I"), length("B")]))],
    repeats: true,
    build: deep_drilling,
};

/// 4.6.
pub const TAPPING: DescribedCycle = DescribedCycle {
    id: "G284",
    parts: &[(
        Part::Main,
        &hole::<20>(&[number("KF"), words("type", &["float", "rigid"]), words("feedtype", &["min", "rev"])]),
    )],
    repeats: true,
    build: tapping,
};

/// 4.8.
pub const REAMING: DescribedCycle =
    DescribedCycle { id: "G285", parts: &[(Part::Main, &hole::<17>(&[]))], repeats: true, build: reaming };

/// 4.9.
pub const BORING: DescribedCycle = DescribedCycle {
    id: "G286",
    parts: &[(Part::Main, &hole::<18>(&[words("retract", &["feed", "rapid"])]))],
    repeats: true,
    build: boring,
};

/// 4.10.
pub const ORIENTED_BORING: DescribedCycle = DescribedCycle {
    id: "G297",
    parts: &[(Part::Main, &hole::<20>(&[number("beta"), length("dx"), length("dy")]))],
    repeats: true,
    build: oriented_boring,
};

/// 4.5.
pub const BORE_MILLING: DescribedCycle = DescribedCycle {
    id: "G298",
    parts: &[(
        Part::Main,
        &hole::<22>(&[
            length("phi"),
            length("phiK"),
            length("B"),
            words("dir", SENSES),
            words("bottom", &["yes", "no"]),
        ]),
    )],
    repeats: true,
    build: bore_milling,
};

/// 4.7.
pub const THREAD_MILLING: DescribedCycle = DescribedCycle {
    id: "G299",
    parts: &[(
        Part::Main,
        &hole::<29>(&[
            length("phi"),
            length("K"),
            length("B"),
            length("DS"),
            number("alpha"),
            number("N"),
            length("step"),
            length("delta"),
            words("side", &["internal", "external"]),
            words("dir", SENSES),
            words("cut", &["down", "up"]),
            words("tool", &["full", "single", "multi"]),
        ]),
    )],
    repeats: true,
    build: thread_milling,
};

fn placed(main: &Section, depth: f64) -> Result<Placed, WrongParameter> {
    Placed::new(main, main.given("DP").unwrap_or(CLEAR), depth)
}

fn dwell(main: &Section) -> Result<f64, WrongParameter> {
    let seconds = main.number("t");
    refuse(!(seconds >= 0.0 && seconds.is_finite()), Fault::CycleParameter, "t")?;
    Ok(seconds)
}

fn drilled(main: &Section, placed: &Placed, pecks: Option<Pecks>, leave: Leave) -> Made {
    let hole = Hole {
        reference: placed.planes.approach,
        bottom: placed.at(placed.depth),
        top: placed.planes.safety,
        pecks,
        dwell: dwell(main)?,
        leave,
        feed: feed(main)?,
    };
    hole.check("I")?;
    plan(main, ["X", "Y"], placed, vec![stage(main, Operation::plain(Work::Hole(hole), placed.up))])
}

fn centre_punching(description: &Description<'_>) -> Made {
    let main = description.part(Part::Main);
    let depth = match main.word("mode", "depth") {
        "angle" => {
            let angle = main.number("alpha");
            refuse(!(angle > 0.0 && angle < 180.0), Fault::CycleParameter, "alpha")?;
            positive(main.number("phi"), "phi")? / 2.0 / (angle / 2.0).to_radians().tan()
        }
        // Where Z and ZS are one it always goes towards minus.
        _ => main.number("P").abs(),
    };
    drilled(main, &placed(main, depth)?, None, Leave::Rapid)
}

/// The peck, 0 for the cutting length.
fn peck(description: &Description<'_>, main: &Section) -> Result<f64, WrongParameter> {
    match main.number("I") {
        0.0 => {
            let own = tool(description, main).cutting_length;
            refuse(!(own > 0.0), Fault::CycleNoCuttingLength, "I")?;
            Ok(own)
        }
        step if step.is_finite() => Ok(step.abs()),
        _ => Err(WrongParameter::new(Fault::CycleParameter, "I")),
    }
}

fn pecked(description: &Description<'_>, main: &Section, back: impl Fn(&Placed) -> Back) -> Made {
    let placed = placed(main, main.number("P"))?;
    let first = peck(description, main)?;
    let surface = placed.planes.surface;
    let pecks = Pecks { surface, first, factor: 1.0, least: 0.0, back: back(&placed), gap: CLEAR };
    pecks.check("I", "I")?;
    drilled(main, &placed, Some(pecks), Leave::Rapid)
}

fn drilling(description: &Description<'_>) -> Made {
    drilled_with(description, description.part(Part::Main))
}

/// Drilling with the parameters of a section.
pub fn drilled_with(description: &Description<'_>, main: &Section) -> Made {
    let level = main.given("ZR");
    pecked(description, main, |placed| {
        let before = placed.planes.approach;
        level.map_or(Back::To(before), |level| Back::Once { level, before })
    })
}

fn deep_drilling(description: &Description<'_>) -> Made {
    let main = description.part(Part::Main);
    let distance = main.number("B");
    refuse(!(distance >= 0.0 && distance.is_finite()), Fault::CycleParameter, "B")?;
    pecked(description, main, |placed| match distance {
        0.0 => Back::To(placed.planes.approach),
        distance => Back::By(distance),
    })
}

fn tapping(description: &Description<'_>) -> Made {
    let main = description.part(Part::Main);
    let placed = placed(main, main.number("P"))?;
    let (rpm, f) = (main.number("S"), feed(main)?);
    let per_turn = main.word("feedtype", "min") == "rev";
    refuse(!(rpm > 0.0 && rpm.is_finite()), Fault::TappingSpeed, "S")?;
    let rigid = main.word("type", "float") == "rigid";
    let holder = match rigid {
        true => {
            let back = positive(main.given("KF").filter(|k| *k != 0.0).unwrap_or(1.0), "KF")?;
            Holder::Rigid { pitch: if per_turn { f } else { f / rpm }, rpm, back, orients_first: true }
        }
        false => Holder::Floating { feed: f },
    };
    let thread = TappedHole {
        reference: placed.planes.approach,
        bottom: placed.at(placed.depth),
        top: placed.planes.safety,
        dwell: dwell(main)?,
        turn: turn(main, "spindle"),
        holder,
    };
    thread.check("S")?;
    let mut made = stage(main, Operation::plain(Work::TappedHole(thread), placed.up));
    if rigid {
        // 4.6.1: M19 first.
        made.turn = None;
    } else if per_turn {
        made.unit = FeedUnit::Turn;
    }
    plan(main, ["X", "Y"], &placed, vec![made])
}

fn reaming(description: &Description<'_>) -> Made {
    let main = description.part(Part::Main);
    drilled(main, &placed(main, main.number("P"))?, None, Leave::Feed)
}

fn bored(main: &Section, way: impl Fn(&Placed) -> Way) -> Made {
    let placed = placed(main, main.number("P"))?;
    let bore = Bore {
        reference: placed.planes.approach,
        bottom: placed.at(placed.depth),
        top: placed.planes.safety,
        dwell: dwell(main)?,
        feed: feed(main)?,
        turn: turn(main, "spindle"),
        way: way(&placed),
    };
    plan(main, ["X", "Y"], &placed, vec![stage(main, Operation::plain(Work::Bore(bore), placed.up))])
}

fn boring(description: &Description<'_>) -> Made {
    let main = description.part(Part::Main);
    bored(main, |placed| match main.word("retract", "feed") {
        "rapid" => Way::OutStopped,
        _ => Way::OutAtFeed(placed.planes.approach),
    })
}

fn oriented_boring(description: &Description<'_>) -> Made {
    let main = description.part(Part::Main);
    let aside = Aside { angle: Some(main.number("beta")), by: [main.number("dx"), main.number("dy")] };
    bored(main, |placed| Way::OutAside { aside, back_at: placed.planes.approach })
}

fn bore_milling(description: &Description<'_>) -> Made {
    let main = description.part(Part::Main);
    let placed = placed(main, main.number("P"))?;
    let bore = BoreMilling {
        reference: placed.planes.approach,
        surface: placed.planes.surface,
        bottom: placed.at(placed.depth),
        top: placed.planes.safety,
        diameter: main.number("phi"),
        drilled: main.number("phiK"),
        // Only a positive pitch mills the bottom, as with G210 (1.10).
        pitch: main.number("B").abs(),
        mills_bottom: main.word("bottom", "yes") == "yes" && main.number("B") > 0.0,
        tool_radius: tool(description, main).radius,
        feed: feed(main)?,
    };
    bore.check(BoreNames { diameter: "phi", drilled: "phiK", pitch: "B", depth: "P" })?;
    let frame = Frame::new([0.0; 2], 0.0, turn(main, "dir"));
    let operation = Operation::new(Work::BoreMilling(bore), frame, placed.up);
    plan(main, ["X", "Y"], &placed, vec![stage(main, operation)])
}

fn thread_milling(description: &Description<'_>) -> Made {
    let main = description.part(Part::Main);
    let placed = placed(main, main.number("P"))?;
    let edges = match main.word("tool", "full") {
        "single" => 1,
        "multi" => {
            let edges = main.number("N");
            refuse(edges.fract() != 0.0 || !(1.0..=1000.0).contains(&edges), Fault::CycleParameter, "N")?;
            edges as u32
        }
        _ => 0,
    };
    let thread = ThreadMilling {
        reference: placed.planes.approach,
        surface: placed.planes.surface,
        bottom: placed.at(placed.depth),
        top: placed.planes.safety,
        internal: main.word("side", "internal") == "internal",
        diameter: main.number("phi"),
        depth: main.number("K"),
        pitch: main.number("B"),
        downwards: main.word("cut", "down") == "down",
        edges,
        stock: main.number("delta"),
        step: main.number("step"),
        approach: main.given("DS").filter(|distance| *distance != 0.0),
        angle: main.number("alpha"),
        tool_radius: tool(description, main).radius,
        feed: feed(main)?,
    };
    let (step, approach, length) = ("step", "DS", "P");
    thread.check(ThreadNames {
        diameter: "phi",
        depth: "K",
        pitch: "B",
        stock: "delta",
        step,
        approach,
        length,
    })?;
    let frame = Frame::new([0.0; 2], thread.angle, turn(main, "dir"));
    let operation = Operation::new(Work::ThreadMilling(thread), frame, placed.up);
    plan(main, ["X", "Y"], &placed, vec![stage(main, operation)])
}
