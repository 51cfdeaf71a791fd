//! Back along the path, and forward again, from holds at random: limits, path, blocks and ends.
#![allow(missing_docs, clippy::unwrap_used, clippy::panic)]

mod common;
#[path = "common/demanding.rs"]
mod demanding;

use common::{Run, arc, demo, line, round_machine, run};
use demanding::Chance;
use ferrocut_geometry::Position;
use ferrocut_machine::Machine;
use ferrocut_motion::{Motion, Move, State};
use ferrocut_toolpath::{Op, PathMode};
use std::f64::consts::PI;

const GO: PathMode = PathMode::Continuous;

/// Lines, corners, exact stops, arcs, a curve of short lines, positioning.
fn program() -> Vec<Op> {
    let mut ops = vec![
        line(8.0, 0.0, 0.0, 4000.0, GO),
        line(8.0, 6.0, 1.0, 4000.0, GO),
        line(12.0, 6.0, 1.0, 4000.0, PathMode::ExactStop),
        arc(Position::xyz(12.0, 10.0, 1.0), [12.0, 8.0], PI, 3000.0),
        arc(Position::xyz(18.0, 10.0, 1.0), [15.0, 10.0], PI, 3000.0),
    ];
    for k in 1..300 {
        let phi = f64::from(k) * 0.01;
        let y = 10.0 + 8.0 * (1.0 - phi.cos());
        ops.push(line(18.0 + 8.0 * phi.sin(), y, 1.0 + 0.1 * phi, 5000.0, GO));
    }
    // Rows with a short line between them.
    let Position([x, y, z, ..]) = *ops[ops.len() - 1].target().unwrap();
    let rows = [(6.0, 0.0), (6.0, 0.3), (0.0, 0.3), (0.0, 0.6), (6.0, 0.6)];
    ops.extend(rows.map(|(u, v)| line(x + u, y + v, z, 5000.0, GO)));
    let at = |x: f64, y: f64, z: f64| Position::xyz(x, y, z);
    ops.push(Op::Rapid { to: at(40.0, 20.0, 5.0), straight: true, speed: None, path: PathMode::ON_PATH });
    ops.push(Op::Rapid { to: at(30.0, 40.0, 9.0), straight: false, speed: None, path: PathMode::ON_PATH });
    ops.push(line(30.0, 30.0, 9.0, 2000.0, PathMode::ExactStop));
    ops.push(line(25.0, 30.0, 9.0, 2000.0, GO));
    ops
}

/// What is done, at which of the periods.
#[derive(Clone, Copy, Debug, PartialEq)]
enum Act {
    Hold,
    Resume,
    /// Turns back or forward; only at rest.
    Turn(bool),
    Override(f64),
}

/// Runs `ops`; `act` says what is done before a period, from whether the axes are held.
fn run_acting(
    machine: &Machine,
    ops: &[Op],
    mut act: impl FnMut(usize, &mut Motion) -> Option<Act>,
) -> (Run, Motion) {
    let mut motion = Motion::new(machine, Position::ZERO);
    let mut moves = Vec::new();
    let mut at = Position::ZERO;
    for (i, op) in ops.iter().enumerate() {
        moves.extend(Move::from_step(op, at, 1000.0, i as u64));
        at = *op.target().unwrap();
    }
    let mut left = moves.iter().peekable();
    let mut samples = Vec::new();
    let mut is_finished = false;
    for tick in 0..200_000 {
        while motion.free() > 0 && left.peek().is_some() {
            motion.push(left.next().unwrap()).unwrap();
        }
        if left.peek().is_none() && !is_finished {
            motion.finish();
            is_finished = true;
        }
        match act(tick, &mut motion) {
            Some(Act::Hold) => motion.hold(),
            Some(Act::Resume) => motion.resume(),
            Some(Act::Turn(back)) => {
                let _ = motion.retrace(back);
            }
            Some(Act::Override(share)) => motion.set_override(share, share.min(1.0)),
            None => {}
        }
        let setpoint = motion.tick();
        samples.push(setpoint);
        if setpoint.state == State::Idle && is_finished {
            let period = machine.servo_period_ms / 1e3;
            let run = Run { start: Position::ZERO, ops: ops.to_vec(), samples, period, aborted: false };
            return (run, motion);
        }
    }
    panic!("does not end: {:?}", samples.last());
}

#[test]
fn back_to_the_start_and_forward_to_the_end() {
    let machine = demo();
    let ops = program();
    let plain = run(&machine, Position::ZERO, &ops);
    for hold in [60, 300, 777, plain.samples.len() - 60] {
        let mut was_at_start = None;
        let (run, _) = run_acting(&machine, &ops, |tick, motion| {
            let is_held = motion.is_still() && tick > hold;
            match tick {
                _ if tick == hold => Some(Act::Hold),
                _ if is_held && was_at_start.is_none() && !motion.is_back() => {
                    assert!(motion.retrace(true));
                    Some(Act::Resume)
                }
                // What was passed is behind: nothing to be done any more.
                _ if motion.is_back() && motion.is_still() && motion.position() == Position::ZERO => {
                    assert_eq!(motion.free(), 0);
                    was_at_start = Some(tick);
                    Some(Act::Turn(false))
                }
                _ => None,
            }
        });
        run.check_limits(&machine);
        run.check_path(0.01 + 1e-6);
        assert!(was_at_start.is_some());
        assert_eq!(run.samples.last().unwrap().position, *ops.last().unwrap().target().unwrap());
        // Through the points of exact stops in both directions.
        let point = *ops[2].target().unwrap();
        let rests =
            run.samples.windows(2).filter(|w| w[0].position != point && w[1].position == point).count();
        let is_behind = run.samples[hold].tag > 2;
        assert_eq!(rests, if is_behind { 3 } else { 1 }, "held at {hold}");
        // The way back takes as long as the way there, but for holding and rounding.
        let back = run.samples.iter().filter(|s| s.velocity > 0.0).count();
        assert!(back > plain.samples.len() + hold, "{back}");
    }
}

#[test]
fn to_and_fro_at_random_within_the_limits_and_to_the_same_end() {
    let ops = program();
    for seed in 0..12 {
        let mut machine = if seed % 2 == 0 { demo() } else { round_machine() };
        machine.servo_period_ms = [1.0, 0.25, 2.0][seed as usize % 3];
        let mut chance = Chance(seed);
        let mut backs = 0;
        let (run, motion) = run_acting(&machine, &ops, |tick, motion| {
            if tick > 12_000 {
                // Forward to the end.
                return match () {
                    () if motion.is_back() && motion.is_still() => Some(Act::Turn(false)),
                    () if motion.is_back() => Some(Act::Hold),
                    () if tick % 10 == 0 => Some(Act::Resume),
                    () => (tick % 10 == 1).then_some(Act::Override(1.0)),
                };
            }
            match chance.below(150) {
                0..3 => Some(Act::Hold),
                3..6 => Some(Act::Resume),
                6 => Some(Act::Override(0.1 * f64::from(1 + chance.below(15)))),
                7..40 if motion.is_still() => {
                    let back = chance.below(2) == 0;
                    backs += u32::from(back && !motion.is_back());
                    Some(Act::Turn(back))
                }
                _ => None,
            }
        });
        run.check_limits(&machine);
        run.check_path(0.01 + 1e-6);
        assert!(backs > 2, "seed {seed}: {backs}");
        assert!(!motion.is_back());
        assert_eq!(run.samples.last().unwrap().position, *ops.last().unwrap().target().unwrap());
    }
}

#[test]
fn it_goes_back_from_the_end_and_no_farther_than_a_tapping_move() {
    let machine = demo();
    let ops = [
        line(0.0, 0.0, -5.0, 600.0, PathMode::Tapping),
        line(10.0, 0.0, -5.0, 2000.0, GO),
        line(10.0, 10.0, -5.0, 2000.0, GO),
    ];
    let (_, mut motion) = run_acting(&machine, &ops, |_, _| None);
    assert!(motion.is_empty() && motion.retrace(true) && !motion.is_empty());
    for _ in 0..20_000 {
        motion.tick();
    }
    let begin = motion.position();
    assert!(motion.is_back() && begin.distance(Position::xyz(0.0, 0.0, -5.0)) < 0.2 && begin.0[2] < -4.99);
    // No further, and forward to the end again.
    assert!(motion.retrace(false));
    assert!((0..20_000).any(|_| motion.tick().state == State::Idle));
    assert_eq!(motion.position(), Position::xyz(10.0, 10.0, -5.0));
    // Only at rest.
    motion.push(&Move::line(Position::ZERO, 20.0, GO, 9).unwrap()).unwrap();
    motion.finish();
    for _ in 0..100 {
        motion.tick();
    }
    assert!(!motion.retrace(true) && !motion.is_back());
    // What was aborted is not gone back over.
    motion.abort();
    assert!((0..20_000).any(|_| motion.tick().state == State::Idle));
    assert!(!motion.retrace(true));
}

#[test]
fn a_long_program_is_gone_back_over_as_far_as_it_is_known() {
    let machine = round_machine();
    let at = |k: u32| {
        let phi = f64::from(k) * 0.002;
        Position::xyz(25.0 * phi.cos() - 25.0, 25.0 * phi.sin(), 0.0)
    };
    let ops: Vec<Op> = (1..30_000).map(|k| line(at(k).0[0], at(k).0[1], 0.0, 9000.0, GO)).collect();
    let mut turned = None;
    let (mut way, mut last) = (0.0, Position::ZERO);
    let (run, _) = run_acting(&machine, &ops, |tick, motion| {
        if motion.is_back() {
            way += motion.position().distance(last);
        }
        last = motion.position();
        match tick {
            9000 => Some(Act::Hold),
            _ if tick > 9000 && motion.is_still() && turned.is_none() => {
                turned = Some(tick);
                assert!(motion.retrace(true));
                Some(Act::Resume)
            }
            _ if motion.is_back()
                && motion.is_still()
                && turned.is_some_and(|turned| tick > turned + 100) =>
            {
                Some(Act::Turn(false))
            }
            _ => None,
        }
    });
    run.check_limits(&machine);
    run.check_path(0.01 + 1e-6);
    assert!(way > 100.0, "{way} mm back");
    assert_eq!(run.samples.last().unwrap().position, *ops.last().unwrap().target().unwrap());
}
