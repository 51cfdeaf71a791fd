//! Lines that a program goes in parts: the same motion as of the whole lines.
#![allow(missing_docs, clippy::unwrap_used, clippy::panic)]

mod common;

use common::{Run, arc, demo, line, run};
use ferrocut_geometry::Position;
use ferrocut_toolpath::{Op, PathMode};
use std::f64::consts::PI;

const GO: PathMode = PathMode::Continuous;
const FEED: f64 = 9000.0;

/// A path of points and half circles (about the middle, to the left where it is true).
enum To {
    Line(f64, f64),
    Half(f64, f64, bool),
}

fn path(way: &[To], parts: usize, feed: impl Fn(usize) -> f64) -> Vec<Op> {
    let (mut x, mut y) = (0.0, 0.0);
    let mut ops = Vec::new();
    for (k, to) in way.iter().enumerate() {
        match *to {
            To::Line(a, b) => {
                ops.extend((1..=parts).map(|i| {
                    let share = i as f64 / parts as f64;
                    line(x + (a - x) * share, y + (b - y) * share, 0.0, feed(k), GO)
                }));
                (x, y) = (a, b);
            }
            To::Half(a, b, left) => {
                let sweep = if left { PI } else { -PI };
                ops.push(arc(Position::xyz(a, b, 0.0), [(x + a) / 2.0, (y + b) / 2.0], sweep, feed(k)));
                (x, y) = (a, b);
            }
        }
    }
    ops
}

/// Judges the run of a path in so many parts by the whole lines.
fn judged(way: &[To], parts: usize) -> Run {
    let machine = demo();
    let mut run = run(&machine, Position::ZERO, &path(way, parts, |_| FEED));
    run.check_limits(&machine);
    run.check_feed();
    assert!(run.samples.windows(2).all(|w| w[0].tag <= w[1].tag));
    let end = *run.ops.last().unwrap().target().unwrap();
    assert_eq!(run.samples.last().unwrap().position, end);
    // Parts are passed as the axes come to their ends, also where a corner is over many of them.
    for w in run.samples.windows(2).filter(|w| w[0].tag < w[1].tag) {
        let ends = *run.ops[w[0].tag as usize].target().unwrap();
        let off = (w[1].position - ends).0.iter().map(|c| c * c).sum::<f64>().sqrt();
        assert!(off < 1.0, "{off} from the end of part {}", w[0].tag);
    }
    // A corner may be over parts that are shorter than it: the path is that of the whole.
    let whole = path(way, 1, |_| FEED);
    let mut of_part = Vec::new();
    for (k, to) in way.iter().enumerate() {
        of_part.extend(std::iter::repeat_n(k as u64, if let To::Line(..) = to { parts } else { 1 }));
    }
    run.samples.iter_mut().for_each(|s| s.tag = of_part[s.tag as usize]);
    run.ops = whole;
    run.check_path(machine.path.tolerance + 1e-6);
    run
}

#[test]
fn a_line_in_parts_is_run_as_the_whole() {
    let zigzag: Vec<To> = (1..12).map(|k| To::Line(7.0 * f64::from(k), 7.0 * f64::from(k % 2))).collect();
    let raster: Vec<To> = (0..10)
        .flat_map(|k| {
            let x = if k % 2 == 0 { 30.0 } else { 0.0 };
            [To::Line(x, 0.5 * f64::from(k)), To::Line(x, 0.5 * f64::from(k + 1))]
        })
        .collect();
    let round: Vec<To> = (0..6)
        .flat_map(|k| {
            let (x, y) = (if k % 2 == 0 { 40.0 } else { 0.0 }, 5.0 * f64::from(k));
            [To::Line(x, y), To::Half(x, y + 5.0, k % 2 == 0)]
        })
        .collect();
    for (name, way) in [("zigzag", zigzag), ("raster", raster), ("half circles", round)] {
        let whole = judged(&way, 1).time();
        for parts in [2, 5, 16, 100, 400] {
            let time = judged(&way, parts).time();
            assert!((time - whole).abs() < 2.5e-3, "{name} in {parts} parts: {time} s, {whole} s as a whole");
        }
    }
}

#[test]
fn a_long_line_in_parts_takes_as_long_as_the_whole() {
    let way = [To::Line(300.0, 120.0), To::Line(300.0, 0.0)];
    let whole = judged(&way, 1).time();
    for parts in [3000, 20_000] {
        let time = judged(&way, parts).time();
        assert!((time / whole - 1.0).abs() < 4e-3, "{parts} parts: {time} s, {whole} s as a whole");
    }
}

/// Rows that are too long to be kept back as a whole turn on half circles as whole rows do.
#[test]
fn a_turn_beside_a_long_line_in_parts_is_that_beside_the_whole() {
    let radius = 0.5;
    let way: Vec<To> = (0..6)
        .flat_map(|k| {
            let (x, y) = (if k % 2 == 0 { 80.0 } else { 0.0 }, 2.0 * radius * f64::from(k));
            [To::Line(x, y), To::Half(x, y + 2.0 * radius, k % 2 == 0)]
        })
        .collect();
    let whole = judged(&way, 1).time();
    for parts in [40, 160, 3000] {
        let time = judged(&way, parts).time();
        assert!((time / whole - 1.0).abs() < 3e-3, "rows in {parts} parts: {time} s, {whole} s as a whole");
    }
}

#[test]
fn parts_with_a_feed_of_their_own_keep_it() {
    let way = [To::Line(20.0, 0.0), To::Line(40.0, 0.0), To::Line(60.0, 0.0), To::Line(60.0, 20.0)];
    for parts in [1, 10] {
        let feed = |k: usize| [6000.0, 1500.0, 9000.0, 3000.0][k];
        let machine = demo();
        let run = run(&machine, Position::ZERO, &path(&way, parts, feed));
        run.check_limits(&machine);
        run.check_feed();
        run.check_path(machine.path.tolerance + 1e-6);
        for (k, feed) in [6000.0, 1500.0, 9000.0].into_iter().enumerate() {
            let tags = (k * parts) as u64..((k + 1) * parts) as u64;
            let of = run.samples.iter().filter(|s| tags.contains(&s.tag));
            let top = of.map(|s| s.velocity).fold(0.0, f64::max);
            assert!((top - feed / 60.0).abs() < 1e-3, "line {k} in {parts} parts: {top} mm/s");
        }
    }
}

/// A chain of many short lines in many parts each is run, though its marks are many before it has a cell.
#[test]
fn a_chain_of_lines_in_many_parts_is_run() {
    let to = |k: u32| To::Line(0.05 * f64::from(k), 0.001 * f64::from(k % 2));
    let way: Vec<To> = (1..700).map(to).collect();
    let whole = judged(&way, 1).time();
    for parts in [18, 40, 300] {
        let time = judged(&way, parts).time();
        assert!(time < 1.01 * whole, "{parts} parts: {time} s, {whole} s as a whole");
    }
}

/// Nor does it matter where a line is cut.
#[test]
fn a_short_part_before_a_long_one_makes_no_difference() {
    let ops = |cuts: &[f64]| {
        let mut ops = Vec::new();
        for k in 0..8 {
            let (y, from, to) = (8.0 * f64::from(k), 40.0 * f64::from(k % 2), 40.0 * f64::from((k + 1) % 2));
            ops.extend(cuts.iter().chain(&[1.0]).map(|c| line(from + (to - from) * c, y, 0.0, 6000.0, GO)));
            ops.extend(cuts.iter().chain(&[1.0]).map(|c| line(to, y + 8.0 * c, 0.0, 6000.0, GO)));
        }
        ops
    };
    let machine = demo();
    let time = |cuts: &[f64]| {
        let run = run(&machine, Position::ZERO, &ops(cuts));
        run.check_limits(&machine);
        run.time()
    };
    let whole = time(&[]);
    for cuts in [&[0.0025][..], &[0.025], &[0.3], &[0.99], &[0.002, 0.998], &[0.1, 0.11, 0.5]] {
        let time = time(cuts);
        assert!((time / whole - 1.0).abs() < 2e-3, "{cuts:?}: {time} s, {whole} s as a whole");
    }
}
