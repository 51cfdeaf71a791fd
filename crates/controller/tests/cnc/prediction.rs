//! What a program is said to take at a desk is what the running control takes: to a period for each stop, inputs, mode, memory

//! and thread beside it included (GSK990MC has no such figure; `ferrocut time` plans with this code).

use crate::common::panel::Mill;
use crate::common::shop::Shop;
use crate::common::{HANGS, Run, cnc, ended, machine, run};
use ferrocut_controller::Parts;
use ferrocut_controller::api::{Activity, Command};
use ferrocut_machine::Machine;

/// Positioning, cutting, exact stops, a rounded corner, short lines, a dwell and arcs; how often the axes stop.
fn part() -> (String, usize) {
    let short: String = (1..400)
        .map(|k| format!("X{:.3} Y{:.3}\n", 70.0 - 0.1 * f64::from(k), 10.0 + (0.05 * f64::from(k)).sin()))
        .collect();
    let text = format!(
        "G90 G0 X30 Y10\nG1 Z-5 F900\nG61 X50\nX70\nG64\n{short}G2 X20 Y20 R15 F1800\nG4 X0.5\nG1 X30\nY40\nG0 Z0\nX0 Y0\nM30\n"
    );
    (text, 9)
}

#[test]
fn the_control_takes_as_long_as_was_predicted() {
    let (text, stops) = part();
    let predicted = run(&mut cnc(&machine(), &text)).ticks.len();
    assert!(predicted > 8_000, "{predicted}");
    let mut shop = Shop::of(&machine(), Parts::default());
    shop.store("O0001", &text);
    shop.select("O1");
    shop.inputs.cycle_start = true;
    shop.wait(5);
    // It starts as the key is let go.
    shop.inputs.cycle_start = false;
    let running = |shop: &mut Shop| shop.wait(1).activity == Activity::Running;
    assert!((0..10).any(|_| running(&mut shop)));
    let mut taken: usize = 1;
    while running(&mut shop) {
        taken += 1;
    }
    assert_eq!(shop.control.status().counters.parts, 1);
    assert!(taken.abs_diff(predicted) <= stops, "{taken} periods, {predicted} predicted");
}

/// Periods from the first in which an axis moves to the last, and how often the axes stood between.
fn moving(moving: Vec<bool>) -> (usize, usize) {
    let (first, last) = (moving.iter().position(|m| *m).unwrap(), moving.iter().rposition(|m| *m).unwrap());
    let run = &moving[first..=last];
    (run.len(), run.windows(2).filter(|w| w[0] && !w[1]).count())
}

/// With the standard ladder and the simulated machine too. What the ladder has to finish stands before the first move, and
/// is not counted.
#[test]
fn the_control_with_its_ladder_moves_as_long_as_was_predicted() {
    let text = format!("O1\nM3 S1000\nG90\nG10 L2 P1 X-100 Y-60 Z-20\n{}", part().0);
    let (_, Run { ticks, .. }) = ended(&Machine::demo_mill(), &text);
    let (predicted, stops) = moving(ticks.iter().map(|tick| tick.velocity > 0.0).collect());
    let mut mill = Mill::power_on();
    mill.home();
    mill.press("KEY_EDIT");
    mill.say(Command::Store { program: "O0001".into(), text });
    mill.say(Command::Select { program: "O1".into() });
    mill.press("KEY_AUTO");
    // It starts as the key is let go.
    mill.key("KEY_START", true);
    mill.say(Command::Key { key: "KEY_START".into(), down: false });
    let mut ticks = Vec::new();
    while mill.control.status().counters.parts == 0 {
        assert!(ticks.len() < HANGS, "does not end");
        ticks.extend((0..100).map(|_| mill.control.tick().velocity > 0.0));
    }
    let (taken, stood) = moving(ticks);
    assert!(stops > 5 && stood == stops, "{stood} stops, {stops} predicted");
    assert!(taken.abs_diff(predicted) <= stops, "{taken} periods, {predicted} predicted");
}
