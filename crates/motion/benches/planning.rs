//! How many short segments a second are planned: path and speed, without the setpoints between.
//!
//! A servo period of 1 s takes hundreds of segments at once, so what is measured is smoothing and look-ahead with jerk
//! limits. Beside it the same moves go through the textbook's planner ([`Trapezoids`]), which keeps acceleration alone
//! and goes through every point: the least that any look-ahead does.

use ferrocut_geometry::{AXES, Plane, Position};
use ferrocut_machine::Machine;
use ferrocut_motion::{Limits, Motion, Move, State};
use ferrocut_toolpath::PathMode;
use std::collections::VecDeque;
use std::f64::consts::PI;
use std::hint::black_box;
use std::time::Instant;

const COUNT: usize = 1_000_000;
const FEED: f64 = 100.0;

/// Moves that are given at once.
const BATCH: usize = 1000;

/// Runs of which the quickest counts.
const RUNS: usize = 3;

fn main() {
    let shapes: [(&str, Vec<Move>); 5] = [
        ("curve of 0.1 mm chords", lines(curve(COUNT))),
        ("raster, rows of 100 mm", lines(raster(COUNT))),
        ("raster, half circles between", linked(COUNT)),
        ("3D finishing, noise of 1 um", lines(finishing(COUNT, 1e-3))),
        ("3D finishing, 0.02 mm blocks", lines(fine(COUNT))),
    ];
    println!("{COUNT} segments           planned, M/s   trapezoids, M/s   ratio");
    // `cargo bench … -- raster` runs the shapes of which the name has this word.
    let words: Vec<String> = std::env::args().skip(1).filter(|word| !word.starts_with('-')).collect();
    for (name, moves) in shapes {
        if !words.is_empty() && !words.iter().any(|word| name.contains(word.as_str())) {
            continue;
        }
        let machine = Machine::demo_mill();
        let ours = rate(&moves, || Planned::new(&machine), Planned::take, Planned::end);
        let peer = rate(&moves, || Trapezoids::new(&machine), Trapezoids::take, Trapezoids::end);
        println!("{name:<30} {:>8.3} {:>17.2} {:>9.3}", ours / 1e6, peer / 1e6, ours / peer);
    }
}

/// Segments a second of the quickest run of what is `new`, takes moves and ends.
///
/// It is given so many at once as an interpreter is ahead by: from where a million of them lie they would come more slowly than
/// they are planned. The time that this takes does not count.
fn rate<P, T>(
    moves: &[Move],
    new: impl Fn() -> P,
    take: impl Fn(&mut P, &[Move]),
    end: impl Fn(P) -> T,
) -> f64 {
    let mut batch = Vec::with_capacity(BATCH);
    let mut time = |_| {
        let began = Instant::now();
        let mut planner = new();
        let mut took = began.elapsed();
        for some in moves.chunks(BATCH) {
            batch.clear();
            batch.extend_from_slice(some);
            let began = Instant::now();
            take(&mut planner, &batch);
            took += began.elapsed();
        }
        let began = Instant::now();
        black_box(end(planner));
        (took + began.elapsed()).as_secs_f64()
    };
    COUNT as f64 / (0..RUNS).map(&mut time).fold(f64::INFINITY, f64::min)
}

fn rounded(p: [f64; 3], to: f64) -> Position {
    let [x, y, z] = p.map(|c| (c / to).round() * to);
    Position::xyz(x, y, z)
}

/// Straight cuts from point to point.
fn lines(points: Vec<Position>) -> Vec<Move> {
    let line = |(k, to)| Move::line(to, FEED, PathMode::Continuous, k as u64);
    points.into_iter().enumerate().filter_map(line).collect()
}

/// A closed curve with bends of 5 mm radius and straighter stretches, run again and again; 0.1 µm coordinates.
fn curve(count: usize) -> Vec<Position> {
    let (mut points, mut at, mut heading) = (Vec::with_capacity(count), [0.0_f64; 2], 0.0_f64);
    for k in 1..=count {
        let s = k as f64 * 0.1;
        heading += 0.1 * (0.02 + 0.15 * (s / 12.0).sin());
        at = [at[0] + 0.1 * heading.cos(), at[1] + 0.1 * heading.sin()];
        points.push(rounded([at[0], at[1], 0.0], 1e-4));
    }
    points
}

/// Rows of 100 mm to and fro over a gently curved surface, 0.5 mm apart, in steps of 0.25 mm.
fn raster(count: usize) -> Vec<Position> {
    const ROW: usize = 400;
    let point = |k: usize| {
        let (row, column) = (k / ROW, k % ROW);
        let column = if row.is_multiple_of(2) { column } else { ROW - 1 - column };
        let (x, y) = (column as f64 * 0.25, row as f64 * 0.5);
        rounded([x, y, 3.0 * (x * 0.08).sin() * (y * 0.05).cos()], 1e-4)
    };
    (1..=count).map(point).collect()
}

/// Rows over a steeper surface, with half circles from one to the next as a CAM system links them.
fn linked(count: usize) -> Vec<Move> {
    const ROW: usize = 401;
    let block = |k: usize| {
        let (row, step) = (k / ROW, k % ROW);
        let goes_back = !row.is_multiple_of(2);
        let column = if goes_back { ROW - 1 - step } else { step };
        let (x, y) = (column as f64 * 0.25, row as f64 * 0.5);
        let to = rounded([x, y, 6.0 * (x * 0.111).sin() * (y * 0.05).cos()], 1e-4);
        if step > 0 {
            return Move::line(to, FEED, PathMode::Continuous, k as u64);
        }
        let turn = if goes_back { PI } else { -PI };
        Move::arc(to, Plane::Xy, [x, y - 0.25], turn, FEED, PathMode::Continuous, k as u64)
    };
    (1..=count).filter_map(block).collect()
}

/// A waterline spiral about a wavy body in blocks of about 0.15 mm, as a CAM system writes it: every coordinate is off
/// by up to `noise` and rounded to it.
fn finishing(count: usize, noise: f64) -> Vec<Position> {
    let mut seed = 0x2545_f491_4f6c_dd1d_u64;
    let mut off = || {
        seed ^= seed << 13;
        seed ^= seed >> 7;
        seed ^= seed << 17;
        noise * ((seed >> 11) as f64 / (1u64 << 53) as f64 - 0.5)
    };
    let point = |k: usize| {
        let angle = k as f64 * 0.15 / 40.0;
        let r = 40.0 + 2.0 * (angle * 7.0).sin();
        let p = [r * angle.cos(), r * angle.sin(), -0.05 * angle + 0.5 * (angle * 5.0).cos()];
        rounded(p.map(|c| c + off()), noise)
    };
    (1..=count).map(point).collect()
}

/// The same in blocks of 0.02 mm with coordinates of 1 µm: directions are off by degrees.
fn fine(count: usize) -> Vec<Position> {
    let point = |k: usize| {
        let angle = k as f64 * 0.02 / 40.0;
        let r = 40.0 + 2.0 * (angle * 7.0).sin();
        rounded([r * angle.cos(), r * angle.sin(), -0.05 * angle + 0.5 * (angle * 5.0).cos()], 1e-3)
    };
    (1..=count).map(point).collect()
}

/// The planner, with a period of a second.
struct Planned {
    motion: Motion,
    periods: usize,
}

impl Planned {
    fn new(machine: &Machine) -> Planned {
        let machine = Machine { servo_period_ms: 1000.0, ..machine.clone() };
        Planned { motion: Motion::new(&machine, Position::ZERO), periods: 0 }
    }

    fn take(&mut self, moves: &[Move]) {
        for next in moves {
            while self.motion.free() == 0 {
                self.tick();
            }
            let _ = self.motion.push(next);
        }
    }

    fn tick(&mut self) -> State {
        self.periods += 1;
        black_box(self.motion.tick()).state
    }

    fn end(mut self) -> usize {
        self.motion.finish();
        while self.tick() != State::Idle {}
        self.periods
    }
}

/// A block of the textbook's planner: everything in mm and s.
struct Block {
    len: f64,
    direction: [f64; AXES],
    /// Acceleration and speed that the axes allow in its direction.
    a: f64,
    top: f64,
    /// Square of the highest speed at its start by the corner, and as planned.
    corner: f64,
    entry: f64,
}

/// Look-ahead as in any textbook: junction deviation, a backward sweep over the blocks that are known, a forward sweep
/// when they are handed out as trapezoids of speed.
struct Trapezoids {
    blocks: VecDeque<Block>,
    limits: Limits,
    deviation: f64,
    /// Where the newest block ends.
    at: Position,
    /// The oldest block of which the entry can still rise.
    open: usize,
    time: f64,
}

/// Blocks that are looked ahead over.
const AHEAD: usize = 1024;

impl Trapezoids {
    fn new(machine: &Machine) -> Trapezoids {
        Trapezoids {
            blocks: VecDeque::with_capacity(AHEAD + 1),
            limits: Limits::new(machine),
            deviation: machine.path.tolerance,
            at: Position::ZERO,
            open: 0,
            time: 0.0,
        }
    }

    fn take(&mut self, moves: &[Move]) {
        for to in moves.iter().map(Move::to) {
            self.push(to);
        }
    }

    fn end(mut self) -> f64 {
        self.sweep();
        while !self.blocks.is_empty() {
            self.hand_out();
        }
        self.time
    }

    fn push(&mut self, to: Position) {
        let d = to - self.at;
        self.at = to;
        let len = d.0.iter().map(|c| c * c).sum::<f64>().sqrt();
        if len == 0.0 {
            return;
        }
        let direction = d.0.map(|c| c / len);
        let least = |limits: &[f64; AXES]| {
            limits.iter().zip(direction).map(|(l, d)| l / d.abs()).fold(f64::INFINITY, f64::min)
        };
        let (a, top) = (least(&self.limits.acceleration), least(&self.limits.velocity).min(FEED));
        let corner = self.blocks.back().map_or(0.0, |before| {
            let cos: f64 = before.direction.iter().zip(direction).map(|(a, b)| -a * b).sum();
            let half = (0.5 * (1.0 - cos)).max(0.0).sqrt();
            let square = a.min(before.a) * self.deviation * half / (1.0 - half).max(1e-12);
            square.min(top * top).min(before.top * before.top)
        });
        self.blocks.push_back(Block { len, direction, a, top, corner, entry: 0.0 });
        if self.blocks.len() >= AHEAD {
            self.sweep();
            // Half of what is known is kept, so that every block is swept over about twice.
            for _ in 0..AHEAD / 2 {
                self.hand_out();
            }
        }
    }

    fn sweep(&mut self) {
        let mut exit = 0.0;
        for block in self.blocks.iter_mut().skip(self.open + 1).rev() {
            block.entry = block.corner.min(exit + 2.0 * block.a * block.len);
            exit = block.entry;
        }
    }

    fn hand_out(&mut self) {
        let Some(block) = self.blocks.pop_front() else { return };
        let reach = block.entry + 2.0 * block.a * block.len;
        let mut exit = 0.0;
        if let Some(next) = self.blocks.front_mut() {
            next.entry = next.entry.min(reach);
            exit = next.entry;
        }
        // Up to the summit, steady, and down.
        let square = (0.5 * (block.entry + exit) + block.a * block.len).min(block.top * block.top);
        let (v0, v, v1) = (block.entry.sqrt(), square.sqrt(), exit.sqrt());
        let steady = block.len - (2.0 * square - block.entry - exit) / (2.0 * block.a);
        self.time += (2.0 * v - v0 - v1) / block.a + steady.max(0.0) / v;
    }
}
