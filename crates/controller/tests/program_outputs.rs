//! Outputs that programs set (LinuxCNC M codes: M62 to M65, M67, M68).
#![allow(missing_docs, clippy::unwrap_used, clippy::panic)]

mod common;

use common::{in_language, machine};
use ferrocut_controller::{Cnc, Control, Mode, Outputs};
use ferrocut_geometry::Axis;

#[test]
fn the_ladder_has_the_digital_ones() {
    let program = "G21 G64\nM64 P15\nM64 P16\nM68 E63 Q2.5\nG1 X10 F3000\nM64 P3\nX20\nM2\n";
    let mut cnc = Cnc::new(&machine(), in_language("rs274", program));
    cnc.connect_ladder(&machine());
    let mut outputs = Outputs::default();
    let mut words = Vec::new();
    cnc.cycle_start();
    for _ in 0..5000 {
        cnc.hear(&Control::free_inputs(Mode::Auto));
        let x = cnc.tick().position[Axis::X];
        cnc.tell(&mut outputs);
        words.push((outputs.macro_outputs, x > 10.0));
    }
    words.dedup();
    assert_eq!(words.last(), Some(&(0x8008, true)));
    assert!(words.contains(&(0x8000, false)), "{words:?}");
    assert_eq!((cnc.digital_output(16), cnc.digital_output(17)), (true, false));
    assert_eq!((cnc.analog_output(63), cnc.analog_output(64)), (2.5, 0.0));
}
