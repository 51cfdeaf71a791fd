//! Surface milling and slots (4.19, 4.22).

use super::*;
use crate::cycles::area::pocket::check_stock;
use crate::cycles::area::{Facing, Slot, SlotKind, Strategy};

const RECTANGLE: [Parameter; 3] = [length("L"), length("H"), number("alpha")];

const ROUGH: [Parameter; 4] = [length("step"), length("E"), length("FZ"), length("I")];

/// 4.19.
pub const SURFACE: DescribedCycle = DescribedCycle {
    id: "G290",
    parts: &[
        (
            Part::Main,
            &joined::<11>(&[
                &POINT,
                &PLANES,
                &RECTANGLE,
                &[
                    words(
                        "strategy",
                        &["bidir_x", "bidir_y", "unidir_x", "unidir_y", "spiral_x", "spiral_y"],
                    ),
                    words("begin", &["ll", "lr", "ur", "ul"]),
                ],
            ]),
        ),
        (Part::Rough, &joined::<13>(&[&TOOL, &ROUGH])),
        (Part::Finish, &joined::<11>(&[&TOOL, &[length("deltaz"), length("step")]])),
    ],
    repeats: false,
    build: surface,
};

/// 4.22.
pub const SLOT: DescribedCycle = DescribedCycle {
    id: "G295",
    parts: &[
        (
            Part::Main,
            &joined::<10>(&[
                &POINT,
                &PLANES,
                &RECTANGLE,
                &[words(
                    "kind",
                    &["corner_ll", "corner_lr", "corner_ur", "corner_ul", "through_x", "through_y"],
                )],
            ]),
        ),
        (Part::Rough, &joined::<14>(&[&TOOL, &DIRECTION, &ROUGH])),
        (
            Part::Finish,
            &joined::<14>(&[
                &TOOL,
                &DIRECTION,
                &[length("delta"), length("deltaz"), length("step"), number("N")],
            ]),
        ),
    ],
    repeats: false,
    build: slot,
};

fn surface(description: &Description<'_>) -> Made {
    let main = description.part(Part::Main);
    let (rough, finish) = (description.part(Part::Rough), description.part(Part::Finish));
    let placed = Placed::of(main)?;
    let floor_stock = finish.number("deltaz");
    of_finish(check_stock(floor_stock, "deltaz"))?;
    let (right, upper) = match main.word("begin", "ll") {
        "lr" => (true, false),
        "ur" => (true, true),
        "ul" => (false, true),
        _ => (false, false),
    };
    let (frame, size) = corner_frame(main, right, upper)?;
    let (strategy, along_y) = match main.word("strategy", "bidir_x") {
        "bidir_y" => (Strategy::Both, true),
        "unidir_x" => (Strategy::One, false),
        "unidir_y" => (Strategy::One, true),
        "spiral_x" => (Strategy::Spiral, false),
        "spiral_y" => (Strategy::Spiral, true),
        _ => (Strategy::Both, false),
    };
    let [x, y] = size;
    let (frame, size) = if along_y { (frame.exchanged(), [y, x]) } else { (frame, size) };
    let overrun = rough.number("E");
    let face = |section: &Section, levels: Levels, first: f64, returns: bool| {
        let data = tool(description, section);
        let down = plunge(rough, "FZ", feed(section)?)?;
        let cut = cut(section, &data, down)?;
        let facing = Facing { size, planes: placed.planes, levels, cut, overrun, strategy, first, returns };
        facing.check(["L", "H", "E"])?;
        Ok(stage(section, Operation::new(Work::Facing(facing), frame, placed.up)))
    };
    let mut stages = Vec::with_capacity(2);
    if works(rough) {
        let cutting_length = tool(description, rough).cutting_length;
        let levels = Levels::within(placed.depth - floor_stock, rough.number("I"), cutting_length, "I");
        stages.push(of_rough(levels.and_then(|levels| face(rough, levels, placed.planes.approach, true)))?);
    }
    if works(finish) {
        let first = placed.above_floor(works(rough), floor_stock);
        stages.push(of_finish(face(finish, Levels::equal(placed.depth, 1.0), first, false))?);
    }
    plan(main, ["X", "Y"], &placed, stages)
}

fn slot(description: &Description<'_>) -> Made {
    let main = description.part(Part::Main);
    let (rough, finish) = (description.part(Part::Rough), description.part(Part::Finish));
    let placed = Placed::of(main)?;
    let (stock, floor_stock) = (finish.number("delta"), finish.number("deltaz"));
    of_finish(check_stock(floor_stock, "deltaz"))?;
    // The open sides are those of the part's corner.
    let (kind, right, upper, along_y) = match main.word("kind", "corner_ll") {
        "corner_lr" => (SlotKind::Corner, true, false, false),
        "corner_ur" => (SlotKind::Corner, true, true, false),
        "corner_ul" => (SlotKind::Corner, false, true, false),
        "through_x" => (SlotKind::Through, false, false, false),
        "through_y" => (SlotKind::Through, false, false, true),
        _ => (SlotKind::Corner, false, false, false),
    };
    let (frame, [x, y]) = corner_frame(main, right, upper)?;
    let (frame, size) = if along_y { (frame.exchanged(), [y, x]) } else { (frame, [x, y]) };
    // From the corner upwards and away it leads counter-clockwise in a frame that is not mirrored.
    let mirrored = (right != upper) != along_y;
    let made = |section: &Section, levels: Levels, first: f64, walls: Option<Levels>| {
        let data = tool(description, section);
        let down = plunge(rough, "FZ", feed(section)?)?;
        let slot = Slot {
            kind,
            size,
            planes: placed.planes,
            first,
            levels,
            walls,
            cut: cut(section, &data, down)?,
            stock,
            overrun: rough.number("E"),
            reversed: (turn(section, "dir") == Turn::Clockwise) != mirrored,
        };
        slot.check(["L", "H", "E", "delta"])?;
        Ok(stage(section, Operation::new(Work::Slot(slot), frame, placed.up)))
    };
    let mut stages = Vec::with_capacity(2);
    let mut rough_levels = None;
    if works(rough) {
        let cutting_length = tool(description, rough).cutting_length;
        let levels = Levels::within(placed.depth - floor_stock, rough.number("I"), cutting_length, "I");
        let levels = of_rough(levels)?;
        rough_levels = Some((rough, levels));
        stages.push(of_rough(made(rough, levels, placed.planes.approach, None))?);
    }
    if works(finish) {
        let data = tool(description, finish);
        let walls = of_finish(wall_levels(finish, placed.depth, &data, rough_levels))?;
        let first = placed.above_floor(works(rough), floor_stock);
        stages.push(of_finish(made(finish, Levels::equal(placed.depth, 1.0), first, Some(walls)))?);
    }
    plan(main, ["X", "Y"], &placed, stages)
}
