//! What a program is said to take at a desk is what the running control takes: to a period for each stop, inputs, mode, memory
//! and thread beside it included (GSK990MC has no such figure; `ferrocut time` plans with this code).
#![allow(missing_docs, clippy::unwrap_used, clippy::panic, clippy::indexing_slicing)]

mod common;

use common::shop::Shop;
use common::{cnc, machine, run};
use ferrocut_controller::Parts;
use ferrocut_controller::api::Activity;

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
