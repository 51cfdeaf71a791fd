//! After `new`, nothing is allocated: any allocation inside the guard ends the test program.
#![allow(clippy::unwrap_used)]

mod common;
use assert_no_alloc::{AllocDisabler, assert_no_alloc};
use common::*;
use ferrocut_geometry::Position;
use ferrocut_motion::{Motion, Move, State};
use ferrocut_toolpath::{Op, PathMode};

#[global_allocator]
static ALLOCATOR: AllocDisabler = AllocDisabler;

#[test]
fn push_and_tick_allocate_nothing() {
    let machine = demo();
    let mut ops = vec![Op::Rapid {
        to: Position::xyz(10.0, 0.0, 0.0),
        straight: false,
        speed: None,
        path: PathMode::ON_PATH,
    }];
    for k in 1..5000 {
        let phi = k as f64 * 0.01;
        ops.push(line(10.0 * phi.cos(), 10.0 * phi.sin(), -phi, 3000.0, PathMode::Continuous));
    }
    let end = *ops[ops.len() - 1].target().unwrap();
    let end_of_arc = Position::xyz(end.0[0], end.0[1], 0.0);
    ops.push(arc(end_of_arc, [0.0, 0.0], 600.0, 3000.0));
    let mut at = Position::ZERO;
    let moves: Vec<Move> = ops
        .iter()
        .map(|op| {
            let m = Move::from_step(op, at, 0.0, 0).unwrap();
            at = *op.target().unwrap();
            m
        })
        .collect();
    let mut motion = Motion::new(&machine, Position::ZERO);
    assert_no_alloc(|| {
        let mut left = moves.iter();
        for tick in 0.. {
            while motion.free() > 0 {
                match left.next() {
                    Some(m) => assert_eq!(motion.push(m), Ok(())),
                    None => {
                        motion.finish();
                        break;
                    }
                }
            }
            match tick % 1000 {
                300 => motion.hold(),
                500 => motion.resume(),
                700 => motion.set_override(1.7, 0.5),
                _ => {}
            }
            if motion.tick().state == State::Idle {
                break;
            }
        }
        motion.abort();
    });
    assert!(motion.is_empty());
}
