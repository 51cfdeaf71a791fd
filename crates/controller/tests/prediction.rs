//! The time that a desk tells and the one that the whole control takes, with its ladder and simulated machine.
#![allow(missing_docs, clippy::unwrap_used, clippy::panic)]

mod common;
#[path = "common/panel.rs"]
#[allow(dead_code)]
mod panel;

use common::{HANGS, in_language};
use ferrocut_controller::api::{Activity, Command};
use ferrocut_controller::{Cnc, State};
use ferrocut_machine::Machine;
use panel::Mill;

/// Corners, arcs, short lines, exact stops, dwells and positioning; no code that the ladder has to finish between them.
fn part() -> String {
    let mut text = String::from("O1\nG21 G90 G17\nM3 S1000\nG0 X-20 Y-30 Z-10\nG1 Z-20 F1200\nF3000\n");
    for k in 0..200 {
        let u = f64::from(k) * 0.05;
        text += &format!("X{:.3} Y{:.3}\n", -20.0 - 10.0 * u.sin(), -30.0 + 4.0 * u);
    }
    text += "G4 X0.25\nG61 X-60\nY-60\nG64 X-30\nG3 X-20 Y-50 R10\nG1 X-80 Y-10\nG0 Z-5\nX-10 Y-10\nG4 P100\nG1 X-40 F6000\n";
    text + "M30\n"
}

/// Periods from the first in which an axis moves to the last, and how often the axes stood between.
fn moving(moving: Vec<bool>) -> (usize, usize) {
    let (first, last) = (moving.iter().position(|m| *m).unwrap(), moving.iter().rposition(|m| *m).unwrap());
    let run = &moving[first..=last];
    (run.len(), run.windows(2).filter(|w| w[0] && !w[1]).count())
}

#[test]
fn the_whole_control_takes_the_time_that_was_told() {
    let mut mill = Mill::power_on();
    mill.home();
    mill.press("KEY_EDIT");
    mill.say(Command::Store { program: "O0001".into(), text: part() });
    mill.say(Command::Select { program: "O1".into() });
    mill.press("KEY_AUTO");
    // A cycle begins as the key is let go.
    mill.key("KEY_START", true);
    mill.say(Command::Key { key: "KEY_START".into(), down: false });
    let mut run = Vec::new();
    while run.len() < HANGS {
        run.push(mill.control.tick().velocity > 0.0);
        let is_over = || mill.control.status().activity == Activity::Idle;
        if run.len() > 1000 && run.len().is_multiple_of(100) && is_over() {
            break;
        }
    }
    let (taken, stops) = moving(run);

    let mut cnc = Cnc::new(&Machine::demo_mill(), in_language("gsk990mc", &part()));
    cnc.cycle_start();
    let mut told = Vec::new();
    while cnc.state() != &State::Ended {
        told.push(cnc.tick().velocity > 0.0);
    }
    let (told, told_stops) = moving(told);
    println!("{taken} {told} {stops} {told_stops}");
    assert!(stops > 5 && stops == told_stops, "{stops} {told_stops}");
    assert!(taken.abs_diff(told) <= stops, "{taken} periods, {told} told, {stops} stops");
}
