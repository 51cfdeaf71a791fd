//! A period of a program in the midst of its moves: any allocation inside the guard ends the test program.
#![allow(missing_docs, clippy::unwrap_used, clippy::panic)]

mod common;

use assert_no_alloc::{AllocDisabler, assert_no_alloc};
use common::{HANGS, cnc, machine};
use ferrocut_controller::State;
use ferrocut_geometry::Position;

#[global_allocator]
static ALLOCATOR: AllocDisabler = AllocDisabler;

/// Short blocks, arcs, positioning, and fewer of them than motion looks ahead.
fn program() -> String {
    let mut text = String::from("M3 S1000\nG0 X0 Y0 Z5\nG1 Z0 F600\nF1500\n");
    for row in 0..6 {
        let y = f64::from(row) * 2.0;
        for k in 0..60 {
            let x = 0.5 * f64::from(if row % 2 == 0 { k } else { 60 - k });
            text += &format!("X{x} Y{:.3} Z{:.3}\n", y + 0.3 * (x / 4.0).sin(), 0.2 * (x / 3.0).cos());
        }
        text += &format!("G3 Y{} R1\nG0 Z3\nG1 Z0\n", y + 2.0);
    }
    text + "G0 X0 Y0 Z5\nM30\n"
}

#[test]
fn a_period_in_the_midst_of_moves_allocates_nothing() {
    let mut cnc = cnc(&machine(), &program());
    cnc.work_beside().unwrap();
    cnc.tick();
    cnc.cycle_start();
    let (mut moved, mut guarded) = (0, 0);
    for k in 0..HANGS {
        // What is planned and read beside is here, as it is in time on a clock.
        cnc.await_beside();
        match k % 1000 {
            300 => cnc.feed_hold(),
            500 => cnc.cycle_start(),
            700 => cnc.set_override(1.7, 0.5),
            900 => cnc.set_override(1.0, 1.0),
            _ => {}
        }
        // Once all of it is read; what reads it copies itself for whoever looks at it meanwhile. The last moves end with
        // what waits for their end.
        let is_amidst = moved > 500 && cnc.moves().count() > 5;
        let tick = if is_amidst { assert_no_alloc(|| cnc.tick()) } else { cnc.tick() };
        moved += usize::from(tick.velocity > 0.0);
        guarded += usize::from(is_amidst && tick.velocity > 0.0);
        cnc.prepare();
        drop(cnc.events());
        if cnc.state() == &State::Ended {
            assert_eq!(tick.position, Position::xyz(0.0, 0.0, 5.0));
            assert!(guarded > 5000, "{guarded} of {moved}");
            return;
        }
    }
    panic!("does not end: {:?}", cnc.state());
}
