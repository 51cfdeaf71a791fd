//! Rectangular and circular pockets (4.11 to 4.14).

use super::*;
use crate::cycles::area::pocket::{check_corner, check_stock};
use crate::cycles::area::{Corner, Outline, PocketFinish, PocketRough, PocketSteps};
use crate::cycles::parameter::positive;

/// Point and sizes of a rectangle.
const RECTANGLE: [Parameter; 3] = [length("L"), length("H"), words("start", &["corner", "centre"])];

/// Roughing.
const ROUGH: [Parameter; 14] =
    joined(&[&TOOL, &DIRECTION, &[length("step"), length("I"), length("FZ"), number("beta")]]);

/// Finishing.
const FINISH: [Parameter; 15] = joined(&[
    &TOOL,
    &DIRECTION,
    &[length("delta"), length("deltaz"), length("step"), number("N"), number("theta")],
]);

/// 4.11.
pub const SIMPLE: DescribedCycle = DescribedCycle {
    id: "G289",
    parts: &[(
        Part::Main,
        &joined::<23>(&[
            &POINT,
            &PLANES,
            &TOOL,
            &DIRECTION,
            &RECTANGLE,
            &[length("step"), length("delta"), length("I"), length("FZ")],
        ]),
    )],
    repeats: true,
    build: simple,
};

/// 4.12.
pub const RECTANGULAR: DescribedCycle = DescribedCycle {
    id: "G287",
    parts: &[
        (
            Part::Main,
            &joined::<12>(&[
                &POINT,
                &PLANES,
                &RECTANGLE,
                &[number("alpha"), words("corner", &["sharp", "round", "chamfer"]), length("r")],
            ]),
        ),
        (Part::Rough, &ROUGH),
        (Part::Finish, &FINISH),
    ],
    repeats: true,
    build: rectangular,
};

/// 4.13.
pub const CIRCULAR: DescribedCycle = DescribedCycle {
    id: "G288",
    parts: &[
        (Part::Main, &joined::<7>(&[&CENTRE, &PLANES, &[length("R")]])),
        (Part::Rough, &ROUGH),
        (Part::Finish, &FINISH),
    ],
    repeats: true,
    build: circular,
};

/// 4.14. The middle is open, so that roughing needs no way in.
pub const PRE_EMPTIED: DescribedCycle = DescribedCycle {
    id: "G296",
    parts: &[
        (Part::Main, &joined::<8>(&[&CENTRE, &PLANES, &[length("R"), length("r")]])),
        (Part::Rough, &joined::<12>(&[&TOOL, &DIRECTION, &[length("step"), length("I")]])),
        (
            Part::Finish,
            &joined::<16>(&[
                &TOOL,
                &DIRECTION,
                &[
                    length("delta"),
                    length("deltaz"),
                    length("step"),
                    number("N"),
                    number("theta"),
                    length("FZ"),
                ],
            ]),
        ),
    ],
    repeats: true,
    build: pre_emptied,
};

/// Corners of a rectangle.
pub fn corner(main: &Section) -> Corner {
    match main.word("corner", "sharp") {
        "round" => Corner::Round(main.number("r")),
        "chamfer" => Corner::Chamfer(main.number("r")),
        _ => Corner::Sharp,
    }
}

fn simple(description: &Description<'_>) -> Made {
    let main = description.part(Part::Main);
    let placed = Placed::of(main)?;
    let is_centre = main.word("start", "corner") == "centre";
    let (frame, half) = rectangle(main, is_centre, turn(main, "dir"))?;
    let data = tool(description, main);
    let outline = Outline { half, corner: Corner::Sharp };
    let milling = feed(main)?;
    let cut = cut(main, &data, plunge(main, "FZ", milling)?)?;
    let stock = main.number("delta");
    check_stock(stock, "delta")?;
    let rough = PocketRough {
        wall: outline.lengthwise(),
        emptied: 0.0,
        planes: placed.planes,
        levels: Levels::within(placed.depth, main.number("I"), data.cutting_length, "I")?,
        cut,
        stock,
        clears: true,
        wall_feed: (stock > 0.0).then_some(milling),
        entry: Entry::Straight,
        between: PocketSteps::Approach,
    };
    rough.check("FZ")?;
    let operation = Operation::new(Work::PocketRough(rough), outline.frame(frame), placed.up);
    plan(main, ["X", "Y"], &placed, vec![stage(main, operation)])
}

/// What the wall of a pocket is, and how it is entered at an angle.
#[derive(Clone, Copy)]
struct Shape {
    wall: Outline,
    emptied: f64,
    is_round: bool,
}

impl Shape {
    /// The way in at an angle: to and fro in a rectangle, on a helix in a circle.
    fn entry(&self, radius: f64, stock: f64) -> impl Fn(f64) -> Entry + use<> {
        let [long, short] = self.wall.inset(radius + stock).half;
        let is_round = self.is_round;
        move |angle| match is_round {
            // No wider than the tool, lest a core stand.
            true => Entry::Helix { angle, reach: (short / 2.0).min(radius) },
            false => Entry::Zigzag { angle, reach: long },
        }
    }
}

fn rectangular(description: &Description<'_>) -> Made {
    let main = description.part(Part::Main);
    let is_centre = main.word("start", "corner") == "centre";
    let (_, half) = rectangle(main, is_centre, Turn::Clockwise)?;
    let wall = Outline { half, corner: corner(main) };
    check_corner(&wall, "r")?;
    let frame = |turn| rectangle(main, is_centre, turn).map(|(frame, _)| frame);
    staged(description, ["X", "Y"], Shape { wall, emptied: 0.0, is_round: false }, frame)
}

fn circular(description: &Description<'_>) -> Made {
    let main = description.part(Part::Main);
    let wall = Outline::circle(positive(main.number("R"), "R")?);
    let frame = |turn| Ok(Frame::new([0.0; 2], 0.0, turn));
    staged(description, ["XC", "YC"], Shape { wall, emptied: 0.0, is_round: true }, frame)
}

fn pre_emptied(description: &Description<'_>) -> Made {
    let main = description.part(Part::Main);
    let wall = Outline::circle(positive(main.number("R"), "R")?);
    let emptied = positive(main.number("r"), "r")?;
    if !(emptied < wall.half[0]) {
        return Err(WrongParameter::beyond(Fault::CycleParameter, "r", emptied, wall.half[0]));
    }
    let frame = |turn| Ok(Frame::new([0.0; 2], 0.0, turn));
    staged(description, ["XC", "YC"], Shape { wall, emptied, is_round: true }, frame)
}

/// Roughing and finishing of a pocket.
fn staged(
    description: &Description<'_>,
    point: [&'static str; 2],
    shape: Shape,
    frame: impl Fn(Turn) -> Result<Frame, WrongParameter>,
) -> Made {
    let main = description.part(Part::Main);
    let (rough, finish) = (description.part(Part::Rough), description.part(Part::Finish));
    let placed = Placed::of(main)?;
    let (stock, floor_stock) = (finish.number("delta"), finish.number("deltaz"));
    of_finish(check_stock(stock, "delta").and_then(|()| check_stock(floor_stock, "deltaz")))?;
    let is_open = shape.emptied > 0.0;
    let mut stages = Vec::with_capacity(2);
    let mut rough_levels = None;
    if works(rough) {
        let data = tool(description, rough);
        let made = rough_stage(rough, &data, &placed, shape, [stock, floor_stock]);
        let work = of_rough(made)?;
        rough_levels = Some((rough, work.levels));
        let frame = frame(turn(rough, "dir"))?;
        stages.push(pocket_stage(rough, Work::PocketRough, work, shape.wall, frame, placed.up));
    }
    if works(finish) {
        let data = tool(description, finish);
        let made = (|| {
            let milling = feed(finish)?;
            let plunge_of = if is_open { finish } else { rough };
            let cut = cut(finish, &data, plunge(plunge_of, "FZ", milling)?)?;
            let wall = shape.wall.lengthwise();
            let work = PocketFinish {
                wall,
                planes: placed.planes,
                above_floor: placed.above_floor(works(rough), floor_stock),
                depth: placed.depth,
                wall_levels: wall_levels(finish, placed.depth, &data, rough_levels)?,
                cut,
                stock,
                entry: entry(finish, "theta", &data, Shape { wall, ..shape }.entry(data.radius, stock))?,
            };
            work.check("theta")?;
            Ok(work)
        })();
        let work = of_finish(made)?;
        let frame = frame(turn(finish, "dir"))?;
        stages.push(pocket_stage(finish, Work::PocketFinish, work, shape.wall, frame, placed.up));
    }
    // Roughing has a way in through the open middle.
    let entering: &[Part] = if is_open { &[Part::Finish] } else { &[Part::Rough, Part::Finish] };
    let warnings = straight_down(description, entering, false);
    Ok(Plan { warnings, ..plan(main, point, &placed, stages)? })
}

fn rough_stage(
    rough: &Section,
    data: &ToolData,
    placed: &Placed,
    shape: Shape,
    [stock, floor_stock]: [f64; 2],
) -> Result<PocketRough, WrongParameter> {
    let milling = feed(rough)?;
    let is_open = shape.emptied > 0.0;
    // In an open middle the tool goes down in air: at F.
    let down = if is_open { milling } else { plunge(rough, "FZ", milling)? };
    let wall = shape.wall.lengthwise();
    let way = Shape { wall, ..shape }.entry(data.radius, stock);
    let work = PocketRough {
        wall,
        emptied: shape.emptied,
        planes: placed.planes,
        levels: Levels::within(placed.depth - floor_stock, rough.number("I"), data.cutting_length, "I")?,
        cut: cut(rough, data, down)?,
        stock,
        clears: true,
        wall_feed: None,
        entry: if is_open { Entry::Straight } else { entry(rough, "beta", data, way)? },
        between: PocketSteps::AboveLevel,
    };
    work.check("beta")?;
    Ok(work)
}

fn pocket_stage<W>(
    section: &Section,
    kind: impl Fn(W) -> Work,
    work: W,
    wall: Outline,
    frame: Frame,
    up: f64,
) -> Stage {
    stage(section, Operation::new(kind(work), wall.frame(frame), up))
}
