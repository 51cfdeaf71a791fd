//! Areas proved by cutting them: a block of material in cells of 0.05 mm, and the swept tool.
//!
//! What is checked: nothing beyond the wall is cut; nothing that the tool can reach is left above the floor
//! but the stock; no rapid meets material; a way in under an angle keeps it, and does not plunge.
#![allow(clippy::unwrap_used, clippy::panic)]

use super::boss::check_boss;
use super::pocket::check_corner;
use super::*;
use crate::cycles::depth::Levels;
use crate::cycles::operation::{Operation, Work};
use crate::cycles::tool::{Act, Frame};
use ferrocut_geometry::Turn;
use proptest::prelude::{
    Just, ProptestConfig, Strategy as Any, TestCaseError, any, prop, prop_assert, prop_assert_eq,
    prop_assume, prop_oneof, proptest,
};
use std::f64::consts::TAU;

/// Size of a cell, mm.
const CELL: f64 = 0.05;

/// Material as the height of every cell; it begins as a block with its top at 0.
struct Block {
    low: [f64; 2],
    size: [usize; 2],
    heights: Vec<f32>,
}

impl Block {
    /// A block about the origin with these half sizes; nothing beyond it.
    fn new(half: [f64; 2]) -> Block {
        let size = half.map(|h| (2.0 * h / CELL).ceil() as usize);
        Block { low: half.map(|h| -h), size, heights: vec![0.0; size[0] * size[1]] }
    }

    fn place(&self, i: usize, j: usize) -> [f64; 2] {
        [self.low[0] + (i as f64 + 0.5) * CELL, self.low[1] + (j as f64 + 0.5) * CELL]
    }

    /// Calls `see` with the height of every cell whose middle is nearer than `radius` to a place, as far as
    /// `distance` tells, within a box.
    fn within(
        &mut self,
        [low, high]: [[f64; 2]; 2],
        radius: f64,
        distance: impl Fn([f64; 2]) -> f64,
        mut see: impl FnMut(&mut f32),
    ) {
        let index =
            |v: f64, axis: usize| ((v - self.low[axis]) / CELL).floor().clamp(0.0, self.size[axis] as f64);
        let from = [index(low[0] - radius, 0) as usize, index(low[1] - radius, 1) as usize];
        let to = [index(high[0] + radius + CELL, 0) as usize, index(high[1] + radius + CELL, 1) as usize];
        for j in from[1]..to[1].min(self.size[1]) {
            for i in from[0]..to[0].min(self.size[0]) {
                if distance(self.place(i, j)) <= radius {
                    see(&mut self.heights[j * self.size[0] + i]);
                }
            }
        }
    }

    fn cells(&self) -> impl Iterator<Item = ([f64; 2], f64)> + '_ {
        (0..self.size[1]).flat_map(move |j| {
            (0..self.size[0]).map(move |i| (self.place(i, j), f64::from(self.heights[j * self.size[0] + i])))
        })
    }
}

fn apart(a: [f64; 2], b: [f64; 2]) -> f64 {
    (a[0] - b[0]).hypot(a[1] - b[1])
}

/// The tool at work.
struct Mill {
    block: Block,
    radius: f64,
    at: [f64; 3],
    /// Angle under which it goes in, degrees, where it has one.
    angle: Option<f64>,
    /// The first rule that was broken.
    broken: Option<String>,
}

impl Mill {
    fn new(block: Block, radius: f64, at: [f64; 3], angle: Option<f64>) -> Mill {
        Mill { block, radius, at, angle, broken: None }
    }

    fn breaks(&mut self, rule: String) {
        self.broken.get_or_insert(rule);
    }

    /// The highest material under the tool, as far in as a cell lets it be told.
    fn under(&mut self, [x, y]: [f64; 2]) -> f64 {
        let mut highest = f32::NEG_INFINITY;
        let radius = self.radius - CELL;
        self.block.within([[x, y], [x, y]], radius, |p| apart(p, [x, y]), |h| highest = highest.max(*h));
        f64::from(highest)
    }

    fn sink(&mut self, [x, y, z]: [f64; 3]) {
        let radius = self.radius;
        self.block.within([[x, y], [x, y]], radius, |p| apart(p, [x, y]), |h| *h = h.min(z as f32));
    }

    fn take(&mut self, act: Act) {
        let from = self.at;
        match act {
            Act::Rapid { to } => {
                let way = apart([from[0], from[1]], [to[0], to[1]]).max((to[2] - from[2]).abs());
                let count = (way / 0.4).ceil().max(1.0) as usize;
                for n in 0..=count {
                    let t = n as f64 / count as f64;
                    let p: [f64; 3] = std::array::from_fn(|k| from[k] + (to[k] - from[k]) * t);
                    let high = self.under([p[0], p[1]]);
                    if high > p[2] + 1e-4 {
                        self.breaks(format!("rapid at {p:?} through material up to {high}"));
                        break;
                    }
                }
                self.at = to;
            }
            Act::Feed { to, .. } => self.cut_line(from, to),
            Act::Arc { to, center, sweep, .. } => self.cut_arc(from, to, center, sweep),
            other => self.breaks(format!("{other:?} in an area")),
        }
    }

    fn cut_line(&mut self, from: [f64; 3], to: [f64; 3]) {
        let way = apart([from[0], from[1]], [to[0], to[1]]);
        let drop = from[2] - to[2];
        if drop.abs() < 1e-9 {
            let (a, b) = ([from[0], from[1]], [to[0], to[1]]);
            let low = [a[0].min(b[0]), a[1].min(b[1])];
            let high = [a[0].max(b[0]), a[1].max(b[1])];
            let distance = |p: [f64; 2]| {
                let d = [b[0] - a[0], b[1] - a[1]];
                let l = d[0] * d[0] + d[1] * d[1];
                let t = (((p[0] - a[0]) * d[0] + (p[1] - a[1]) * d[1]) / l).clamp(0.0, 1.0);
                apart(p, [a[0] + t * d[0], a[1] + t * d[1]])
            };
            let (radius, z) = (self.radius, to[2] as f32);
            self.block.within([low, high], radius, distance, |h| *h = h.min(z));
        } else {
            if let Some(angle) = self.angle {
                if way < 1e-9 && drop > 0.0 && self.under([to[0], to[1]]) > to[2] + 1e-4 {
                    self.breaks(format!("plunges at {to:?}"));
                }
                if way > 1e-9 && (drop / way).atan().to_degrees() > angle + 1e-6 {
                    self.breaks(format!("goes in at {} degrees", (drop / way).atan().to_degrees()));
                }
            }
            let count = (way / CELL).ceil().max(1.0) as usize;
            for n in 0..=count {
                let t = n as f64 / count as f64;
                self.sink(std::array::from_fn(|k| from[k] + (to[k] - from[k]) * t));
            }
        }
        self.at = to;
    }

    fn cut_arc(&mut self, from: [f64; 3], to: [f64; 3], center: [f64; 2], sweep: f64) {
        let r = apart([from[0], from[1]], center);
        let start = (from[1] - center[1]).atan2(from[0] - center[0]);
        let end = [center[0] + r * (start + sweep).cos(), center[1] + r * (start + sweep).sin()];
        if apart(end, [to[0], to[1]]) > 1e-6 {
            self.breaks(format!("an arc ends at {end:?} and not {to:?}"));
        }
        let drop = from[2] - to[2];
        if drop.abs() < 1e-9 {
            let low = [center[0] - r, center[1] - r];
            let high = [center[0] + r, center[1] + r];
            let ends = [[from[0], from[1]], [to[0], to[1]]];
            let distance = |p: [f64; 2]| {
                let angle = (p[1] - center[1]).atan2(p[0] - center[0]);
                let turned = ((angle - start) * sweep.signum()).rem_euclid(TAU);
                match turned <= sweep.abs() {
                    true => (apart(p, center) - r).abs(),
                    false => apart(p, ends[0]).min(apart(p, ends[1])),
                }
            };
            let (radius, z) = (self.radius, to[2] as f32);
            self.block.within([low, high], radius, distance, |h| *h = h.min(z));
        } else {
            let slope = (drop / (r * sweep.abs())).atan().to_degrees();
            if self.angle.is_some_and(|angle| slope > angle + 1e-6) {
                self.breaks(format!("goes in at {slope} degrees"));
            }
            let count = (r * sweep.abs() / CELL).ceil().max(1.0) as usize;
            for n in 0..=count {
                let t = n as f64 / count as f64;
                let angle = start + sweep * t;
                self.sink([center[0] + r * angle.cos(), center[1] + r * angle.sin(), from[2] - drop * t]);
            }
        }
        self.at = to;
    }

    /// Cuts an operation from over its start; the block is about the origin, its top at 0.
    fn run(&mut self, work: Work, frame: Frame) {
        let operation = Operation { work, frame, up: 1.0, reference: None };
        assert!(!operation.is_endless());
        let [x, y] = operation.start([0.0; 2]).unwrap();
        let at = [x, y, 5.0];
        self.at = at;
        let mut acts = Vec::new();
        operation
            .run([0.0; 2], at, &mut |act: Act| {
                acts.push(act);
                Ok::<(), ()>(())
            })
            .unwrap();
        for act in acts {
            self.take(act);
        }
    }
}

/// Distance of a point from an outline, below 0 within it.
fn outside(outline: &Outline, [x, y]: [f64; 2]) -> f64 {
    let [a, b] = outline.half;
    let (x, y) = (x.abs(), y.abs());
    match outline.corner {
        Corner::Sharp | Corner::Round(_) => {
            let r = if let Corner::Round(r) = outline.corner { r } else { 0.0 };
            let (qx, qy) = (x - a + r, y - b + r);
            qx.max(0.0).hypot(qy.max(0.0)) + qx.max(qy).min(0.0) - r
        }
        Corner::Chamfer(c) => {
            // Corners of the octagon's part in the first quadrant, and the lines between them.
            let (p, q) = ([a, b - c], [a - c, b]);
            let cut = (x + y - (a + b - c)) / std::f64::consts::SQRT_2;
            let inside = (x - a).max(y - b).max(cut);
            if inside <= 0.0 {
                return inside;
            }
            let along = |from: [f64; 2], to: [f64; 2]| {
                let d = [to[0] - from[0], to[1] - from[1]];
                let l = d[0] * d[0] + d[1] * d[1];
                let t = if l > 0.0 { ((x - from[0]) * d[0] + (y - from[1]) * d[1]) / l } else { 0.0 };
                let t = t.clamp(0.0, 1.0);
                apart([x, y], [from[0] + t * d[0], from[1] + t * d[1]])
            };
            along(p, q).min(along([a, 0.0], p)).min(along([0.0, b], q))
        }
    }
}

fn corner() -> impl Any<Value = u8> {
    0u8..3
}

fn made(half: [f64; 2], corner: u8, share: f64) -> Outline {
    let most = half[0].min(half[1]);
    let corner = match corner {
        0 => Corner::Sharp,
        1 => Corner::Round(share * most),
        _ => Corner::Chamfer(share * most),
    };
    Outline { half, corner }
}

const PLANES: Planes = Planes { safety: 5.0, approach: 1.0, surface: 0.0 };

/// As many cases as a property wants, or as PROPTEST_CASES asks for.
fn cases(cases: u32) -> ProptestConfig {
    let asked = std::env::var("PROPTEST_CASES").ok().and_then(|asked| asked.parse().ok());
    let cases = asked.unwrap_or(cases);
    ProptestConfig { cases, failure_persistence: None, ..ProptestConfig::default() }
}

fn turn() -> impl Any<Value = Turn> {
    prop_oneof![Just(Turn::Clockwise), Just(Turn::CounterClockwise)]
}

/// What a pocket's cells must look like.
fn check_pocket(mill: &Mill, wall: &Outline, stock: f64, floor: f64) -> Result<(), TestCaseError> {
    prop_assert_eq!(&mill.broken, &None);
    let reach = wall.inset(mill.radius + stock);
    for (p, height) in mill.block.cells() {
        let beyond = outside(wall, p) + stock;
        prop_assert!(beyond <= CELL || height == 0.0, "cut at {p:?}, {beyond} beyond the wall");
        prop_assert!(height >= floor - 1e-4, "too deep at {p:?}");
        // Where the tool can stand within a radius of the cell.
        if outside(&reach, p) <= mill.radius - CELL {
            prop_assert!(height <= floor + 1e-4, "{height} left at {p:?}");
        }
    }
    Ok(())
}

proptest! {
    #![proptest_config(cases(48))]

    /// G287, G289, G87: roughed, then finished with another tool.
    #[test]
    fn rectangular_pockets(
        (a, b) in (3.0..9.0f64, 3.0..9.0f64),
        (kind, share) in (corner(), 0.05..1.0f64),
        (tool, fine) in (0.25..0.95f64, 0.3..0.95f64),
        (step, stock, floor_stock) in (0.1..1.0f64, 0.0..0.5f64, 0.0..0.4f64),
        angle in prop::option::of(4.0..30.0f64),
        (turn, exact) in (turn(), any::<bool>()),
    ) {
        let wall = made([a.max(b), a.min(b)], kind, share);
        check_corner(&wall, "r").unwrap();
        let short = a.min(b) - stock;
        let radius = (tool * short).max(0.5);
        let entry = |wall: &Outline, radius: f64| match angle {
            None => Entry::Straight,
            Some(angle) => Entry::Zigzag { angle, reach: wall.inset(radius + stock).half[0] },
        };
        let cut = |radius: f64, step: f64| Cut { radius, step, feed: 1.0, plunge: 0.5 }.check("step").unwrap();
        let depth = 2.0;
        let levels = Levels::by_step(depth - floor_stock, if exact { -0.9 } else { 0.9 }, "I").unwrap();
        let rough = PocketRough {
            wall, emptied: 0.0, planes: PLANES, levels, cut: cut(radius, step * 2.0 * radius), stock,
            clears: true, wall_feed: None, entry: entry(&wall, radius), between: PocketSteps::AboveLevel,
        };
        prop_assume!(rough.check("beta").is_ok());
        let frame = Frame::new([0.0; 2], 0.0, turn);
        let mut mill = Mill::new(Block::new(wall.half.map(|h| h + 1.0)), radius, [0.0, 0.0, 5.0], angle);
        mill.run(Work::PocketRough(rough), frame);
        check_pocket(&mill, &wall, stock, -(depth - floor_stock))?;
        let fine = (fine * radius).max(0.4);
        let finish = PocketFinish {
            wall, planes: PLANES, above_floor: -(depth - floor_stock) + 1.0, depth,
            wall_levels: Levels::equal(depth, 2.0), cut: cut(fine, step * 2.0 * fine), stock,
            entry: entry(&wall, fine),
        };
        prop_assume!(finish.check("theta").is_ok());
        mill.radius = fine;
        mill.run(Work::PocketFinish(finish), frame);
        check_pocket(&mill, &wall, 0.0, -depth)?;
    }

    /// G288, G296, G88: round ones, with a helix in, or an open middle.
    #[test]
    fn round_pockets(
        (r, tool, fine) in (3.0..8.0f64, 0.2..0.95f64, 0.3..1.0f64),
        (step, stock) in (0.1..1.0f64, 0.0..0.5f64),
        angle in prop::option::of(3.0..30.0f64),
        (turn, emptied) in (turn(), prop::option::of(0.3..0.9f64)),
    ) {
        let wall = Outline::circle(r);
        let radius = (tool * (r - stock)).max(0.5);
        let emptied = emptied.map_or(0.0, |share| (share * r).max(radius));
        prop_assume!(emptied < r - stock);
        let open = emptied > 0.0;
        let entry = |radius: f64| match angle {
            Some(angle) => {
                let path = wall.inset(radius + stock).half[0];
                Entry::Helix { angle, reach: (path / 2.0).min(radius) }
            }
            None => Entry::Straight,
        };
        let cut = |radius: f64| Cut { radius, step: step * 2.0 * radius, feed: 1.0, plunge: 0.5 }.check("step").unwrap();
        let depth = 2.0;
        let rough = PocketRough {
            wall, emptied, planes: PLANES, levels: Levels::by_step(depth, 0.8, "I").unwrap(),
            cut: cut(radius), stock, clears: true, wall_feed: None,
            entry: if open { Entry::Straight } else { entry(radius) }, between: PocketSteps::AboveLevel,
        };
        prop_assume!(rough.check("beta").is_ok());
        let frame = Frame::new([0.0; 2], 0.0, turn);
        let mut mill = Mill::new(Block::new([r + 1.0; 2]), radius, [0.0, 0.0, 5.0], angle);
        if open {
            mill.block.within([[0.0; 2], [0.0; 2]], emptied, |p| apart(p, [0.0; 2]), |h| *h = -2.0);
        }
        mill.run(Work::PocketRough(rough), frame);
        check_pocket(&mill, &wall, stock, -depth)?;
        let fine = (fine * radius).max(0.4);
        let finish = PocketFinish {
            wall, planes: PLANES, above_floor: -depth + 1.0, depth, wall_levels: Levels::equal(depth, 1.0),
            cut: cut(fine), stock, entry: entry(fine),
        };
        prop_assume!(finish.check("theta").is_ok());
        mill.radius = fine;
        mill.run(Work::PocketFinish(finish), frame);
        check_pocket(&mill, &wall, 0.0, -depth)?;
    }

    /// The pockets and bosses of the editor as programs: what their words make is judged in the same way.
    #[test]
    fn programs_of_the_editor(
        cycle in prop::sample::select(vec!["G287", "G288", "G289", "G291", "G292"]),
        (a, b, q) in (3.0..8.0f64, 3.0..8.0f64, 0.6..4.0f64),
        (kind, share) in (corner(), 0.05..1.0f64),
        (radius, fine, step) in (0.6..4.0f64, 0.6..4.0f64, 0.1..1.0f64),
        (stock, floor_stock, i) in (0.0..0.4f64, 0.0..0.4f64, prop_oneof![Just(0.8), Just(-0.9), Just(0.0)]),
        (angle, ccw) in (prop::option::of(4.0..30.0f64), any::<bool>()),
    ) {
        let is_round = matches!(cycle, "G288" | "G292");
        let is_boss = matches!(cycle, "G291" | "G292");
        let wall = match cycle {
            "G289" => made([a, b], 0, 0.0),
            _ if is_round => Outline::circle(a),
            _ => made([a, b], kind, share),
        };
        let (l, h) = (2.0 * a, 2.0 * b);
        let corner = match wall.corner {
            Corner::Round(r) if !is_round => format!("corner=round, r={r}"),
            Corner::Chamfer(c) => format!("corner=chamfer, r={c}"),
            _ => "corner=sharp".to_owned(),
        };
        let dir = if ccw { "ccw" } else { "cw" };
        let planes = "Z=0, ZS=5, P=2";
        let cut = |tool: u32, r: f64| format!("T={tool}, F=600, S=1000, dir={dir}, step={}", step * 2.0 * r);
        let beta = angle.filter(|_| !is_boss).unwrap_or(0.0);
        let (entry, exit) = match is_boss {
            true => (String::new(), String::new()),
            false => (format!(", beta={beta}"), format!(", step={}, theta={beta}", step * 2.0 * fine)),
        };
        let head = match cycle {
            "G287" => format!("X=0, Y=0, start=centre, L={l}, H={h}, {corner}, {planes}"),
            "G288" => format!("XC=0, YC=0, R={a}, {planes}"),
            "G289" => format!("X={}, Y={}, L={l}, H={h}, {planes}, I={i}, delta={stock}, {}", -a, -b, cut(1, radius)),
            "G291" => format!("X={}, Y={}, L={l}, H={h}, Q={q}, {corner}, {planes}", -a, -b),
            _ => format!("XC=0, YC=0, R={a}, Q={q}, {planes}"),
        };
        let stages = match cycle {
            "G289" => String::new(),
            _ => format!(
                "#ROUGH [{}, I={i}{entry}]\n#FINISH [T=2, F=300, S=1000, dir={dir}, delta={stock}, \
                 deltaz={floor_stock}, N=2{exit}]\n",
                cut(1, radius)
            ),
        };
        let program = format!("#CYCLE {cycle} [{head}]\n{stages}M30\n");
        let setup = format!(
            "[start]\nx = 30\ny = 30\nz = 50\n[tools.1]\nradius = {radius}\ncutting_length = 2\n\
             [tools.2]\nradius = {fine}\ncutting_length = 2\n"
        );
        let stages = match crate::cycles::programs::stages(&program, &setup) {
            Ok(stages) => stages,
            Err(alarm) => {
                // What does not fit is refused, for that reason alone.
                let no_room = [Fault::CycleToolTooLarge, Fault::CycleEntryAngle, Fault::CycleParameter, Fault::CycleStepTooWide];
                prop_assert!(no_room.contains(&alarm.fault), "{:?} {program}", alarm);
                prop_assume!(false);
                return Ok(());
            }
        };
        let beyond = if is_boss { q } else { 1.0 };
        let half = wall.half.map(|h| h + beyond);
        let mut block = Block::new(half);
        if cycle == "G292" {
            // A round blank.
            for j in 0..block.size[1] {
                for i in 0..block.size[0] {
                    if apart(block.place(i, j), [0.0; 2]) > a + q {
                        block.heights[j * block.size[0] + i] = -50.0;
                    }
                }
            }
        }
        let no_plunge = if is_boss { Some(1.0) } else { angle.filter(|_| cycle != "G289") };
        let mut mill = Mill::new(block, radius, [0.0; 3], no_plunge);
        let left = if cycle == "G289" { [0.0; 2] } else { [stock, floor_stock] };
        let tools = [(radius, left), (fine, [0.0; 2])];
        prop_assert_eq!(stages.len(), if cycle == "G289" { 1 } else { 2 });
        for ((start, acts), (radius, [stock, floor_stock])) in stages.into_iter().zip(tools) {
            (mill.radius, mill.at) = (radius, start);
            acts.into_iter().for_each(|act| mill.take(act));
            let floor = floor_stock - 2.0;
            match is_boss {
                true => check_around(&mill, &wall, stock, floor)?,
                false => check_pocket(&mill, &wall, stock, floor)?,
            }
        }
    }

    /// G289 and G87 with a pass along the wall at every level, and the wall alone.
    #[test]
    fn walls_level_by_level(
        (a, b, tool) in (3.0..7.0f64, 3.0..7.0f64, 0.3..0.9f64),
        (stock, turn, approach) in (0.05..0.5f64, turn(), any::<bool>()),
    ) {
        let wall = made([a.max(b), a.min(b)], 0, 0.0);
        let radius = tool * (a.min(b) - stock);
        let cut = Cut { radius, step: 0.0, feed: 1.0, plunge: 0.5 }.check("step").unwrap();
        let between = if approach { PocketSteps::Approach } else { PocketSteps::AboveLevel };
        let rough = PocketRough {
            wall, emptied: 0.0, planes: PLANES, levels: Levels::by_step(2.0, 0.7, "I").unwrap(), cut, stock,
            clears: true, wall_feed: Some(2.0), entry: Entry::Straight, between,
        };
        rough.check("V").unwrap();
        let mut mill = Mill::new(Block::new(wall.half.map(|h| h + 1.0)), radius, [0.0, 0.0, 5.0], None);
        mill.run(Work::PocketRough(rough), Frame::new([0.0; 2], 0.0, turn));
        check_pocket(&mill, &wall, 0.0, -2.0)?;
        // A tool as wide as half the pocket cuts all of it along the wall.
        let wide = Cut { radius: a.min(b) / 2.0 + 0.01, ..cut };
        let mut mill = Mill::new(Block::new(wall.half.map(|h| h + 1.0)), wide.radius, [0.0, 0.0, 5.0], None);
        let alone = PocketRough { cut: wide, clears: false, ..rough };
        mill.run(Work::PocketRough(alone), Frame::new([0.0; 2], 0.0, turn));
        prop_assert_eq!(&mill.broken, &None);
    }

    /// G291 and G292.
    #[test]
    fn bosses(
        (a, b, is_round) in (1.5..5.0f64, 1.5..5.0f64, any::<bool>()),
        (kind, share, q) in (corner(), 0.05..1.0f64, 0.5..5.0f64),
        (radius, fine, step) in (0.6..2.5f64, 0.3..1.0f64, 0.1..1.0f64),
        (stock, floor_stock, turn) in (0.0..0.4f64, 0.0..0.4f64, turn()),
    ) {
        let boss = if is_round { Outline::circle(a) } else { made([a.max(b), a.min(b)], kind, share) };
        check_boss(&boss, ["r", "Q", "delta"], q, stock).unwrap();
        prop_assume!(q > stock);
        let cut = |radius: f64| Cut { radius, step: step * 2.0 * radius, feed: 1.0, plunge: 0.5 }.check("step").unwrap();
        let depth = 2.0;
        let rough = BossRough {
            boss, around: q, planes: PLANES, cut: cut(radius), stock,
            levels: Levels::by_step(depth - floor_stock, 0.9, "I").unwrap(),
        };
        let frame = Frame::new([0.0; 2], 0.0, turn);
        let half = boss.half.map(|h| h + q);
        let mut block = Block::new(half);
        if is_round {
            let round = a + q;
            block.within([half.map(|h| -h), half], f64::INFINITY, |_| 0.0, |_| {});
            for j in 0..block.size[1] {
                for i in 0..block.size[0] {
                    if apart(block.place(i, j), [0.0; 2]) > round {
                        let at = j * block.size[0] + i;
                        block.heights[at] = -50.0;
                    }
                }
            }
        }
        let mut mill = Mill::new(block, radius, [0.0, 0.0, 5.0], Some(1.0));
        mill.run(Work::BossRough(rough), frame);
        check_around(&mill, &boss, stock, -(depth - floor_stock))?;
        let fine = (fine * radius).max(0.4);
        let finish = BossFinish {
            boss, around: q, planes: PLANES, above_floor: -(depth - floor_stock) + 1.0, depth,
            wall_levels: Levels::equal(depth, 2.0), cut: cut(fine), stock,
        };
        mill.radius = fine;
        mill.run(Work::BossFinish(finish), frame);
        check_around(&mill, &boss, 0.0, -depth)?;
    }

    /// G290.
    #[test]
    fn faces(
        (along, across) in (3.0..14.0f64, 3.0..14.0f64),
        (radius, step, overrun) in (0.6..4.0f64, 0.1..1.0f64, 0.0..2.0f64),
        strategy in prop_oneof![Just(Strategy::Both), Just(Strategy::One), Just(Strategy::Spiral)],
        exact in any::<bool>(),
    ) {
        let cut = Cut { radius, step: step * 2.0 * radius, feed: 1.0, plunge: 0.5 }.check("step").unwrap();
        let facing = Facing {
            size: [along, across], planes: PLANES, cut, overrun, strategy, first: 1.0, returns: true,
            levels: Levels::by_step(1.7, if exact { -0.6 } else { 0.6 }, "I").unwrap(),
        };
        facing.check(["L", "H", "E"]).unwrap();
        // The corner where milling begins is a corner of the block, which is about the origin.
        let frame = Frame::new([-along / 2.0, -across / 2.0], 0.0, Turn::CounterClockwise);
        let mut mill = Mill::new(Block::new([along / 2.0, across / 2.0]), radius, [0.0, 0.0, 5.0], Some(1.0));
        mill.run(Work::Facing(facing), frame);
        prop_assert_eq!(&mill.broken, &None);
        for (p, height) in mill.block.cells() {
            prop_assert!((height + 1.7).abs() < 1e-4, "{height} at {p:?}");
        }
    }

    /// G295.
    #[test]
    fn slots(
        (u, v) in (3.0..10.0f64, 3.0..10.0f64),
        (radius, fine, step, overrun) in (0.5..2.5f64, 0.3..1.0f64, 0.1..1.0f64, 0.0..1.5f64),
        (stock, floor_stock) in (0.0..0.4f64, 0.0..0.4f64),
        (through, reversed) in (any::<bool>(), any::<bool>()),
    ) {
        let kind = if through { SlotKind::Through } else { SlotKind::Corner };
        let depth = 2.0;
        let slot = |radius: f64, levels: Levels, first: f64, walls: Option<Levels>| Slot {
            kind, size: [u, v], planes: PLANES, first, levels, walls, stock, overrun, reversed,
            cut: Cut { radius, step: step * 2.0 * radius, feed: 1.0, plunge: 0.5 }.check("step").unwrap(),
        };
        let rough = slot(radius, Levels::by_step(depth - floor_stock, 0.9, "I").unwrap(), 1.0, None);
        prop_assume!(rough.check(["L", "H", "E", "delta"]).is_ok());
        // The part: for a slot through it as long as that; for one at a corner it goes on beyond its walls.
        let more = 2.0;
        let (half, frame) = match kind {
            SlotKind::Through => ([u / 2.0, v / 2.0 + more], [-u / 2.0, -v / 2.0]),
            SlotKind::Corner => {
                ([(u + more) / 2.0, (v + more) / 2.0], [-(u + more) / 2.0, -(v + more) / 2.0])
            }
        };
        let frame = Frame::new(frame, 0.0, Turn::CounterClockwise);
        let mut mill = Mill::new(Block::new(half), radius, [0.0, 0.0, 5.0], Some(1.0));
        // In the slot's own coordinates.
        let own = |p: [f64; 2]| match kind {
            SlotKind::Through => [p[0] + u / 2.0, p[1] + v / 2.0],
            SlotKind::Corner => [p[0] + (u + more) / 2.0, p[1] + (v + more) / 2.0],
        };
        let check = |mill: &Mill, stock: f64, floor: f64| -> Result<(), TestCaseError> {
            prop_assert_eq!(&mill.broken, &None);
            for (p, height) in mill.block.cells() {
                let [x, y] = own(p);
                // How far beyond the walls, and from where the tool centre can be.
                let (beyond, apart) = match kind {
                    SlotKind::Through => {
                        let beyond = (-y).max(y - v) + stock;
                        (beyond, (mill.radius + stock - y).max(y - v + mill.radius + stock).max(0.0))
                    }
                    SlotKind::Corner => {
                        let (dx, dy) = (x - u + mill.radius + stock, y - v + mill.radius + stock);
                        ((x - u).max(y - v) + stock, dx.max(0.0).hypot(dy.max(0.0)))
                    }
                };
                prop_assert!(beyond <= CELL || height == 0.0, "cut at {x} {y}");
                if apart <= mill.radius - CELL {
                    prop_assert!((height - floor).abs() < 1e-4, "{height} at {x} {y}");
                }
            }
            Ok(())
        };
        mill.run(Work::Slot(rough), frame);
        check(&mill, stock, -(depth - floor_stock))?;
        let fine = (fine * radius).max(0.4);
        let walls = Some(Levels::equal(depth, 2.0));
        let finish = slot(fine, Levels::equal(depth, 1.0), -(depth - floor_stock) + 1.0, walls);
        mill.radius = fine;
        mill.run(Work::Slot(finish), frame);
        check(&mill, 0.0, -depth)?;
    }
}

/// What the cells around a boss must look like.
fn check_around(mill: &Mill, boss: &Outline, stock: f64, floor: f64) -> Result<(), TestCaseError> {
    prop_assert_eq!(&mill.broken, &None);
    // Beside a chamfer the paths meet in points: at its corners the stock is up to 1/cos 22.5° as thick.
    let thick = if matches!(boss.corner, Corner::Chamfer(_)) { 1.09 * stock } else { stock };
    for (p, height) in mill.block.cells() {
        let away = outside(boss, p);
        prop_assert!(away >= stock - CELL || height == 0.0, "cut at {p:?}, {away} from the boss");
        if away >= thick + CELL {
            prop_assert!(height <= floor + 1e-4, "{height} left at {p:?}, {away} from the boss");
        }
    }
    Ok(())
}
