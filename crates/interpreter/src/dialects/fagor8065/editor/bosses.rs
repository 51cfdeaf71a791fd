//! Rectangular and circular bosses (4.17, 4.18).

use super::pockets::corner;
use super::*;
use crate::cycles::area::boss::check_boss;
use crate::cycles::area::pocket::check_stock;
use crate::cycles::area::{BossFinish, BossRough, Outline};
use crate::cycles::parameter::positive;

const ROUGH: [Parameter; 13] = joined(&[&TOOL, &DIRECTION, &[length("step"), length("I"), length("FZ")]]);

const FINISH: [Parameter; 13] =
    joined(&[&TOOL, &DIRECTION, &[length("delta"), length("deltaz"), number("N")]]);

/// 4.17.
pub const RECTANGULAR: DescribedCycle = DescribedCycle {
    id: "G291",
    parts: &[
        (
            Part::Main,
            &joined::<12>(&[
                &POINT,
                &PLANES,
                &[length("L"), length("H"), number("alpha"), length("Q")],
                &[words("corner", &["sharp", "round", "chamfer"]), length("r")],
            ]),
        ),
        (Part::Rough, &ROUGH),
        (Part::Finish, &FINISH),
    ],
    repeats: true,
    build: rectangular,
};

/// 4.18.
pub const CIRCULAR: DescribedCycle = DescribedCycle {
    id: "G292",
    parts: &[
        (Part::Main, &joined::<8>(&[&CENTRE, &PLANES, &[length("R"), length("Q")]])),
        (Part::Rough, &ROUGH),
        (Part::Finish, &FINISH),
    ],
    repeats: true,
    build: circular,
};

fn rectangular(description: &Description<'_>) -> Made {
    let main = description.part(Part::Main);
    let (_, half) = rectangle(main, false, Turn::Clockwise)?;
    let boss = Outline { half, corner: corner(main) };
    let frame = |turn| rectangle(main, false, turn).map(|(frame, _)| frame);
    staged(description, ["X", "Y"], boss, frame)
}

fn circular(description: &Description<'_>) -> Made {
    let boss = Outline::circle(positive(description.part(Part::Main).number("R"), "R")?);
    staged(description, ["XC", "YC"], boss, |turn| Ok(Frame::new([0.0; 2], 0.0, turn)))
}

fn staged(
    description: &Description<'_>,
    point: [&'static str; 2],
    boss: Outline,
    frame: impl Fn(Turn) -> Result<Frame, WrongParameter>,
) -> Made {
    let main = description.part(Part::Main);
    let (rough, finish) = (description.part(Part::Rough), description.part(Part::Finish));
    let placed = Placed::of(main)?;
    let (stock, floor_stock) = (finish.number("delta"), finish.number("deltaz"));
    let around = main.number("Q");
    check_boss(&boss, ["r", "Q", "delta"], around, stock)?;
    of_finish(check_stock(floor_stock, "deltaz"))?;
    let mut stages = Vec::with_capacity(2);
    let mut rough_levels = None;
    let longer = boss.lengthwise();
    let mut add = |section: &Section, work: Work| -> Result<(), WrongParameter> {
        let frame = boss.frame(frame(turn(section, "dir"))?);
        stages.push(stage(section, Operation::new(work, frame, placed.up)));
        Ok(())
    };
    if works(rough) {
        let data = tool(description, rough);
        let made = (|| {
            let down = plunge(rough, "FZ", feed(rough)?)?;
            let depth = placed.depth - floor_stock;
            Ok(BossRough {
                boss: longer,
                around,
                planes: placed.planes,
                levels: Levels::within(depth, rough.number("I"), data.cutting_length, "I")?,
                cut: cut(rough, &data, down)?,
                stock,
            })
        })();
        let work = of_rough(made)?;
        rough_levels = Some((rough, work.levels));
        add(rough, Work::BossRough(work))?;
    }
    if works(finish) {
        let data = tool(description, finish);
        let made = (|| {
            let milling = feed(finish)?;
            let down = plunge(rough, "FZ", milling)?;
            // The floor is finished with the roughing step (4.17.1), as far as the tool is as wide.
            let step = rough.number("step").min(2.0 * data.radius);
            let cut = Cut { radius: data.radius, step, feed: milling, plunge: down }.check("step")?;
            Ok(BossFinish {
                boss: longer,
                around,
                planes: placed.planes,
                above_floor: placed.above_floor(works(rough), floor_stock),
                depth: placed.depth,
                wall_levels: wall_levels(finish, placed.depth, &data, rough_levels)?,
                cut,
                stock,
            })
        })();
        add(finish, Work::BossFinish(of_finish(made)?))?;
    }
    plan(main, point, &placed, stages)
}
