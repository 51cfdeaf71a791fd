//! Codes of the Weihong control on a machine: what M802 and M903 hand over (Weihong 4.2, 4.4).

use crate::common::{HANGS, in_language, machine};
use ferrocut_controller::restart::At;
use ferrocut_controller::signals::{Inputs, Outputs};
use ferrocut_controller::{Cnc, Control, Mode, State};
use ferrocut_geometry::Axis;
use ferrocut_machine::Machine;
use ferrocut_program::FileId;
use ferrocut_toolpath::Op;

/// Runs a program to its end. In how many periods X stood where, in the order in which it came to rest there.
fn rests(program: &str) -> Vec<f64> {
    let mut cnc = Cnc::new(&machine(), in_language("weihong", program));
    cnc.cycle_start();
    let mut rests = Vec::new();
    let mut before = 0.0;
    let mut moved = false;
    for _ in 0..HANGS {
        let x = cnc.tick().position[Axis::X];
        if x == before && moved {
            rests.push(x);
        }
        moved = x != before;
        before = x;
        if *cnc.state() == State::Ended {
            return rests;
        }
    }
    panic!("does not end: {:?}", cnc.state());
}

#[test]
fn with_the_buffer_off_each_block_is_run_to_its_end() {
    let blocks = "G01 X10 F2000\nX20\nX30\n";
    assert_eq!(rests(&format!("{blocks}M30\n")), [30.0]);
    assert_eq!(rests(&format!("M802 P196609\n{blocks}M30\n")), [10.0, 20.0, 30.0]);
    let on_again = format!("M802 P196609\n{blocks}M802 P196608\nX40\nX50\nM30\n");
    assert_eq!(rests(&on_again), [10.0, 20.0, 30.0, 50.0]);
}

/// What the ladder is handed beside an M code, until it has finished `count` of them.
fn handed(program: &str, count: usize) -> (Vec<(u32, Option<u32>)>, Cnc) {
    let mut cnc = Cnc::new(&machine(), in_language("weihong", program));
    cnc.connect_ladder(&Machine { dialect: "weihong".into(), ..machine() });
    cnc.cycle_start();
    let mut heard: Inputs = Control::free_inputs(Mode::Auto);
    let mut codes: Vec<(u32, Option<u32>)> = Vec::new();
    for _ in 0..HANGS {
        cnc.hear(&heard);
        cnc.tick();
        let mut told = Outputs::default();
        cnc.tell(&mut told);
        let asks = told.m.strobe;
        if asks && !heard.finished {
            codes.push((told.m.code, told.b.strobe.then_some(told.b.code)));
        }
        heard.finished = asks;
        if codes.len() == count && !asks {
            return (codes, cnc);
        }
    }
    panic!("{codes:?}: {:?}", cnc.state());
}

#[test]
fn the_ladder_is_handed_the_number_beside_the_code() {
    let program = "M802 P458752\nM10\nM802 P196611\nM11\nM903 P4\nG04 P10000\nM30\n";
    let (codes, cnc) = handed(program, 4);
    assert_eq!(codes, [(10, None), (802, Some(196_611)), (11, None), (903, Some(4))]);
    // The control has the tool in the spindle by its number from here on.
    assert_eq!(cnc.present().state.in_spindle, 4);
    // A restart sends the number again.
    let journal = cnc.journal().unwrap();
    let restart =
        journal.find(At::Line { file: FileId(0), line: 6, pass: 1 }, cnc.interpreter().memory()).unwrap();
    let codes: Vec<Op> = restart.m_codes().collect();
    let number = Op::MachineNumber { code: 802, number: 196_611 };
    assert_eq!(codes, [Op::Machine(10), number, Op::Machine(11)]);
    assert_eq!(restart.functions(&cnc.present().state)[..3], codes);
}
