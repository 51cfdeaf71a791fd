//! Messages of programs: when they are told, and that the path runs on over them.

use crate::common::{HANGS, in_language, machine};
use ferrocut_controller::{Cnc, Event, State};
use ferrocut_geometry::Axis;

/// X of every period, the texts with the X that they were told at, and how the program ended.
fn run(language: &'static str, program: &str, single: bool) -> (Vec<f64>, Vec<(String, f64)>) {
    let mut cnc = Cnc::new(&machine(), in_language(language, program));
    cnc.set_single_block(single);
    let (mut xs, mut told) = (Vec::new(), Vec::new());
    cnc.cycle_start();
    for _ in 0..HANGS {
        let x = cnc.tick().position[Axis::X];
        xs.push(x);
        for event in cnc.events() {
            if let Event::Message(text) = event {
                told.push((text.to_string(), x));
            }
        }
        match cnc.state() {
            State::Running => {}
            State::BlockEnd => cnc.cycle_start(),
            State::Ended => return (xs, told),
            state => panic!("{state:?}"),
        }
    }
    panic!("does not end");
}

fn stops(xs: &[f64]) -> usize {
    xs.windows(3).filter(|x| x[0] != x[1] && x[1] == x[2]).count()
}

#[test]
fn one_between_two_moves_is_told_as_the_second_begins_and_stops_nothing() {
    let program = "G21 G90 G64 P0.05\n(MSG, first)\nG1 X10 F3000\n(MSG, second)\n(DEBUG, third)\nX20\n(MSG, fourth)\nM2\n";
    let (xs, told) = run("rs274", program, false);
    let texts: Vec<&str> = told.iter().map(|(text, _)| text.as_str()).collect();
    assert_eq!(texts, ["first", "second", "third", "fourth"]);
    assert!(told[0].1 < 1e-3 && told[3].1 == 20.0, "{told:?}");
    for (text, x) in &told[1..3] {
        assert!((10.0..10.2).contains(x), "{text} at {x}");
    }
    assert_eq!(stops(&xs), 1);
    let plain = "G21 G90 G64 P0.05\nG1 X10 F3000\nX20\nM2\n";
    let way = |xs: &[f64]| {
        xs.iter().copied().skip_while(|x| *x == 0.0).take_while(|x| *x < 20.0).collect::<Vec<_>>()
    };
    assert_eq!(way(&xs), way(&run("rs274", plain, false).0));
    // Block by block it is one to stop behind.
    let (xs, told) = run("rs274", program, true);
    assert_eq!((told[1].1, told[2].1, stops(&xs)), (10.0, 10.0, 2));
}

/// More than wait at once, and as many before one move.
#[test]
fn many_are_told_in_their_order() {
    let mut program = "G21 G90 G64 P0.05\nG1 X10 F3000\n".to_owned();
    program.extend((0..200).map(|k| format!("(MSG, {k})\n")));
    program.push_str("X20\n(MSG, 200)\nX30\nM2\n");
    let (xs, told) = run("rs274", &program, false);
    assert!(told.iter().enumerate().all(|(k, (text, _))| *text == k.to_string()) && told.len() == 201);
    assert_eq!(xs.last(), Some(&30.0));
}
