//! Planner and interpolator in a thread each: the same setpoints as together, and at rest within the limits where the
//! planner is late, hangs or is gone.
#![allow(clippy::unwrap_used)]

mod common;
#[path = "common/demanding.rs"]
mod demanding;

use assert_no_alloc::{AllocDisabler, assert_no_alloc};
use common::{Run, demo, line};
use demanding::{Asked, Blocks, Chance, Hands};
use ferrocut_geometry::Position;
use ferrocut_motion::{Interpolator, Motion, Move, Planner, Sample, Setpoint, State};
use ferrocut_toolpath::{Op, PathMode};
use std::sync::atomic::{AtomicBool, AtomicU64, Ordering};
use std::time::{Duration, Instant};

#[global_allocator]
static ALLOCATOR: AllocDisabler = AllocDisabler;

/// Lets the planner go through a period: fills it up, does what is asked for in it.
fn go(planner: &mut Planner, moves: &mut impl Iterator<Item = Move>, asked: Option<Asked>) {
    while planner.free() > 0 {
        match moves.next() {
            Some(m) => planner.push(&m).unwrap(),
            None => {
                planner.finish();
                break;
            }
        }
    }
    match asked {
        Some(Asked::Override(feed, rapid)) => planner.set_override(feed, rapid),
        Some(Asked::Hold) => planner.hold(),
        Some(Asked::Resume) => planner.resume(),
        None => {}
    }
    planner.tick();
}

/// A program of the nine axes with an end.
fn program(seed: u64, count: u64) -> impl Iterator<Item = Move> {
    let mut blocks = Blocks::new(seed);
    (0..count).filter_map(move |_| blocks.next())
}

const COUNT: u64 = 9000;
const PERIODS: usize = 60_000;

#[test]
fn two_threads_give_the_setpoints_of_one() {
    let machine = demanding::machine();
    let (mut planner, mut interpolator) = Motion::halves(&machine, Position::ZERO);
    let (mut moves, mut hands) = (program(3, COUNT), Hands::new(4));
    let mut expected: Vec<Sample> = Vec::with_capacity(PERIODS);
    for _ in 0..PERIODS {
        while planner.is_due() {
            let asked = hands.next();
            assert_no_alloc(|| go(&mut planner, &mut moves, asked));
        }
        let sample = assert_no_alloc(|| interpolator.tick());
        expected.push(sample);
    }
    assert_eq!(planner.late(), 0);
    assert!(expected.iter().filter(|s| s.velocity > 0.0).count() > PERIODS / 4);

    let (planner, mut interpolator) = Motion::halves(&machine, Position::ZERO);
    // The first period that is not decided yet, as the interpolator may know it.
    let decided = AtomicU64::new(0);
    let is_over = AtomicBool::new(false);
    let mut found: Vec<Sample> = Vec::with_capacity(PERIODS);
    let planner = std::thread::scope(|scope| {
        let planning = scope.spawn(|| {
            let (mut moves, mut hands, mut planner) = (program(3, COUNT), Hands::new(4), planner);
            while !is_over.load(Ordering::Relaxed) {
                while planner.is_due() {
                    let asked = hands.next();
                    assert_no_alloc(|| go(&mut planner, &mut moves, asked));
                    decided.store(planner.front(), Ordering::Relaxed);
                }
                std::thread::yield_now();
            }
            planner
        });
        let mut chance = Chance(5);
        for k in 0..PERIODS as u64 {
            // Never so far that a change could come too late, but anywhere within that.
            let waited = Instant::now();
            while decided.load(Ordering::Relaxed) <= k {
                assert!(waited.elapsed() < Duration::from_secs(60), "the planner stands still");
                std::thread::yield_now();
            }
            for _ in 0..chance.below(8) {
                std::thread::yield_now();
            }
            let sample = assert_no_alloc(|| interpolator.tick());
            found.push(sample);
        }
        is_over.store(true, Ordering::Relaxed);
        planning.join().unwrap()
    });
    assert_eq!(planner.late(), 0);
    let first = expected.iter().zip(&found).position(|(a, b)| a != b);
    assert_eq!(first, None, "{:?} {:?}", expected[first.unwrap_or(0)], found[first.unwrap_or(0)]);
}

/// A run that takes this long hangs.
const LONGEST: Duration = Duration::from_secs(120);

/// Corners, short blocks and exact stops, judged by the limits.
fn judged() -> Vec<Op> {
    let mut ops = Vec::new();
    for k in 0..1500 {
        let phi = f64::from(k) * 0.01;
        ops.push(line(30.0 * phi.cos() - 30.0, 20.0 * phi.sin(), 0.2 * phi, 5000.0, PathMode::Continuous));
    }
    for k in 0..40 {
        let mode = if k % 5 == 0 { PathMode::ExactStop } else { PathMode::Continuous };
        ops.push(line(f64::from(k % 3) * 8.0, f64::from(k % 4) * 5.0, 1.0, 6000.0, mode));
    }
    ops.push(Op::Rapid {
        to: Position::xyz(100.0, 50.0, 0.0),
        straight: false,
        speed: None,
        path: PathMode::ON_PATH,
    });
    ops.push(Op::Rapid {
        to: Position::xyz(0.0, 20.0, 30.0),
        straight: true,
        speed: None,
        path: PathMode::ON_PATH,
    });
    ops
}

fn moves(ops: &[Op]) -> Vec<Move> {
    let mut at = Position::ZERO;
    let mut moves = Vec::new();
    for (i, op) in ops.iter().enumerate() {
        moves.extend(Move::from_step(op, at, 0.0, i as u64));
        at = *op.target().unwrap();
    }
    moves
}

fn run_of(ops: Vec<Op>, samples: &[Sample], period: f64) -> Run {
    let state = State::Running;
    let samples = samples
        .iter()
        .map(|s| Setpoint { position: s.position, velocity: s.velocity, tag: s.tag, state })
        .collect();
    Run { start: Position::ZERO, ops, samples, period, aborted: false }
}

/// The interpolator goes its way at 100 µs a period, the planner often sleeps for longer than its lead.
#[test]
fn a_planner_that_is_late_moves_within_the_limits_and_to_the_end() {
    let machine = demo();
    let ops = judged();
    let all = moves(&ops);
    let mut late = 0;
    for seed in 0..2 {
        let (planner, mut interpolator) = Motion::halves(&machine, Position::ZERO);
        let is_over = AtomicBool::new(false);
        let mut samples = Vec::with_capacity(2_000_000);
        let planner = std::thread::scope(|scope| {
            let planning = scope.spawn(|| {
                let (mut planner, mut left) = (planner, all.iter().copied());
                let (mut hands, mut chance) = (Hands::new(seed), Chance(seed));
                // Until the axes are at the end, and nobody holds them.
                let mut ticks = 0u32;
                let began = Instant::now();
                while (ticks < 200 || !planner.is_empty()) && began.elapsed() < LONGEST {
                    while planner.is_due() {
                        let asked = if ticks < 5000 { hands.next() } else { Some(Asked::Resume) };
                        go(&mut planner, &mut left, asked);
                        ticks += 1;
                    }
                    let nap = if chance.below(100) == 0 { chance.below(5000) } else { 50 };
                    std::thread::sleep(Duration::from_micros(u64::from(nap)));
                }
                is_over.store(true, Ordering::Relaxed);
                planner
            });
            while !is_over.load(Ordering::Relaxed) {
                let due = Instant::now() + Duration::from_micros(100);
                samples.push(interpolator.tick());
                while Instant::now() < due {
                    std::thread::yield_now();
                }
            }
            planning.join().unwrap()
        });
        late += planner.late();
        let run = run_of(ops.clone(), &samples, machine.servo_period_ms / 1e3);
        run.check_limits(&machine);
        run.check_path(0.01 + 1e-6);
        assert_eq!(samples.last().unwrap().position, Position::xyz(0.0, 20.0, 30.0), "seed {seed}");
    }
    assert!(late > 0, "the planner was never late");
}

/// At any moment the planner is gone for ever.
#[test]
fn without_its_planner_the_interpolator_comes_to_rest_on_the_path() {
    let machine = demo();
    let ops = judged();
    let all = moves(&ops);
    let at_rest = |interpolator: &Interpolator| interpolator.at_rest();
    let mut went = 0.0_f64;
    for gone in (0..9000).step_by(331) {
        let (mut planner, mut interpolator) = Motion::halves(&machine, Position::ZERO);
        let (mut left, mut hands) = (all.iter().copied(), Hands::new(7));
        let mut samples = Vec::new();
        for _ in 0..gone {
            while planner.is_due() {
                go(&mut planner, &mut left, hands.next());
            }
            samples.push(interpolator.tick());
        }
        drop(planner);
        let gone_at = interpolator.sample().position;
        for _ in 0..60_000 {
            samples.push(interpolator.tick());
        }
        assert!(at_rest(&interpolator));
        went = went.max(gone_at.distance(interpolator.sample().position));
        let run = run_of(ops.clone(), &samples, machine.servo_period_ms / 1e3);
        run.check_limits(&machine);
        run.check_path(0.01 + 1e-6);
    }
    assert!(went > 1.0);
}
