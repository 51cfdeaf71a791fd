//! Inputs that programs wait for and read on a machine with a ladder (LinuxCNC M codes: M66; Weihong 4.4: G906).
#![allow(missing_docs, clippy::unwrap_used, clippy::panic)]

mod common;

use common::{HANGS, in_language, machine};
use ferrocut_controller::{Cnc, Control, Mode, State};
use ferrocut_geometry::Axis;
use ferrocut_machine::{Fault, Machine};

/// A run of a program of moves of X with these inputs, a word for each period from the start on; the last one stays.
struct Run {
    cnc: Cnc,
    /// In how many periods X stood where, in the order in which it came to rest there.
    stood: Vec<(f64, usize)>,
}

fn run_on(mut cnc: Cnc, inputs: impl Fn(usize) -> u16) -> Run {
    let mut stood: Vec<(f64, usize)> = Vec::new();
    cnc.cycle_start();
    for period in 0..HANGS {
        let mut heard = Control::free_inputs(Mode::Auto);
        heard.macro_inputs = inputs(period);
        cnc.hear(&heard);
        cnc.prepare();
        let x = cnc.tick().position[Axis::X];
        match stood.last_mut() {
            Some((at, periods)) if *at == x => *periods += 1,
            _ => stood.push((x, 1)),
        }
        // The ladder does nothing, so that the end of the program is never done.
        if cnc.waits_for_ladder() || *cnc.state() != State::Running {
            stood.retain(|(_, periods)| *periods > 1);
            return Run { cnc, stood };
        }
    }
    panic!("does not end: {:?}", cnc.state());
}

fn run(language: &str, program: &str, inputs: impl Fn(usize) -> u16) -> Run {
    let mut cnc = Cnc::new(&machine(), in_language(language, program));
    cnc.connect_ladder(&Machine { dialect: language.into(), ..machine() });
    run_on(cnc, inputs)
}

fn places(run: &Run) -> Vec<f64> {
    run.stood.iter().map(|(x, _)| *x).collect()
}

/// What #5399 is, as the place that X goes to behind the wait, and for how long it was waited.
fn waited(wait: &str, inputs: impl Fn(usize) -> u16) -> (f64, usize) {
    let run = run("rs274", &format!("G21\n{wait}\nG0 X[#5399+5]\nM2\n"), inputs);
    assert_eq!(*run.cnc.state(), State::Running, "{wait}");
    let &[(0.0, periods), (x, _)] = run.stood.as_slice() else { panic!("{wait}: {:?}", run.stood) };
    (x - 5.0, periods)
}

/// A period is a millisecond; what begins and ends a wait takes a few.
fn assert_about(waited: (f64, usize), (result, periods): (f64, usize)) {
    assert_eq!(waited.0, result, "{waited:?}");
    assert!((periods..periods + 6).contains(&waited.1), "{waited:?}");
}

#[test]
fn an_input_is_waited_for_until_it_comes() {
    let from = |period| move |now: usize| if now >= period { 0b1000 } else { 0 };
    assert_about(waited("M66 P3 L3 Q2", from(700)), (1.0, 700));
    assert_about(waited("M66 P3 L1 Q2", from(700)), (1.0, 700));
    // One that is there is not waited for.
    assert_about(waited("M66 P3 L3 Q2", |_| 0b1000), (1.0, 0));
    assert_about(waited("M66 P3 L4 Q2", |_| 0), (0.0, 0));
    let until = |now: usize| if now >= 300 { 0 } else { 0b1000 };
    assert_about(waited("M66 P3 L4 Q2", until), (0.0, 300));
    assert_about(waited("M66 P3 L2 Q2", until), (0.0, 300));
}

#[test]
fn an_edge_is_no_state() {
    assert_about(waited("M66 P3 L1 Q0.5", |_| 0b1000), (-1.0, 500));
    assert_about(waited("M66 P3 L2 Q0.5", |_| 0), (-1.0, 500));
    // It goes and comes again.
    let blinks = |now: usize| if (200..250).contains(&now) { 0 } else { 0b1000 };
    assert_about(waited("M66 P3 L1 Q0.5", blinks), (1.0, 250));
}

#[test]
fn the_time_is_over_and_the_program_is_told() {
    assert_about(waited("M66 P3 L3 Q0.5", |_| 0b0111), (-1.0, 500));
    assert_about(waited("M66 P3 L4 Q0.5", |_| 0b1000), (-1.0, 500));
    // There is no such input.
    assert_about(waited("M66 P16 L3 Q0.5", |_| 0xFFFF), (-1.0, 500));
    // Two waits of a program, of which the first one comes.
    let program = "G21\nM66 P0 L3 Q1\nG0 X[#5399+5]\nM66 P1 L3 Q1\nG0 X[#5399+20]\nM2\n";
    assert_eq!(places(&run("rs274", program, |now| u16::from(now > 100))), [0.0, 6.0, 19.0]);
}

#[test]
fn an_input_is_read_at_once() {
    let read =
        |word| run("rs274", "G21\nM66 P3 L0\nG0 X[#5399+5]\nM2\n", move |_| word).stood.pop().unwrap().0;
    assert_eq!([read(0b1000), read(0b0111)], [6.0, 5.0]);
    // As it is when the axes are there, and not when the block is read.
    let program = "G21\nG1 X50 F3000\nM66 P2 L0\nG0 X[#5399+5]\nM2\n";
    assert_eq!(places(&run("rs274", program, |now| if now > 500 { 4 } else { 0 })), [50.0, 6.0]);
}

#[test]
fn read_beside_it_is_the_same() {
    let mut cnc = Cnc::new(&machine(), in_language("rs274", "G21\nM66 P3 L3 Q0.2\nG0 X[#5399+5]\nM2\n"));
    cnc.connect_ladder(&machine());
    cnc.work_beside().unwrap();
    let run = run_on(cnc, |_| 0);
    assert_eq!(places(&run), [0.0, 4.0]);
}

#[test]
fn hold_stops_the_wait_and_reset_ends_it() {
    let mut cnc = Cnc::new(&machine(), in_language("rs274", "G21\nM66 P3 L3 Q1\nG0 X[#5399+5]\nM2\n"));
    cnc.connect_ladder(&machine());
    cnc.cycle_start();
    let tick = |cnc: &mut Cnc, word| {
        let mut heard = Control::free_inputs(Mode::Auto);
        heard.macro_inputs = word;
        cnc.hear(&heard);
        cnc.tick().position[Axis::X]
    };
    (0..100).for_each(|_| assert_eq!(tick(&mut cnc, 0), 0.0));
    cnc.feed_hold();
    // It comes and goes unseen, and time stands still.
    (0..3000).for_each(|n| assert_eq!(tick(&mut cnc, if n == 1000 { 8 } else { 0 }), 0.0));
    assert_eq!(*cnc.state(), State::Held);
    cnc.cycle_start();
    (0..800).for_each(|_| assert_eq!(tick(&mut cnc, 0), 0.0));
    assert!((0..3000).any(|_| tick(&mut cnc, 8) > 0.0));
    let mut cnc = Cnc::new(&machine(), in_language("rs274", "G21\nM66 P3 L3 Q1\nG0 X[#5399+5]\nM2\n"));
    cnc.connect_ladder(&machine());
    cnc.cycle_start();
    (0..100).for_each(|_| assert_eq!(tick(&mut cnc, 0), 0.0));
    cnc.reset();
    (0..3000).for_each(|_| assert_eq!(tick(&mut cnc, 8), 0.0));
    assert_eq!(*cnc.state(), State::Reset);
}

#[test]
fn one_that_must_come_is_an_alarm_where_it_does_not() {
    let program = "G0 X1\nG906 PLC[3] LEVEL1 P500\nX2\nM30";
    let coming = run("weihong", program, |now| if now > 400 { 8 } else { 0 });
    assert_eq!(places(&coming), [1.0, 2.0]);
    let late = run("weihong", program, |_| 7);
    let State::Alarmed(alarm) = late.cnc.state() else { panic!("{:?}", late.cnc.state()) };
    assert_eq!((alarm.fault, alarm.span.line), (Fault::InputMissing, 2));
    assert!(matches!(late.stood.as_slice(), [(1.0, 500..506)]), "{:?}", late.stood);
    // Without a bound it waits for as long as it takes; for one that the machine does not have it does not.
    let without = "G0 X1\nG906 PLC[3] LEVEL1\nX2\nM30";
    assert_eq!(places(&run("weihong", without, |now| if now > 20_000 { 8 } else { 0 })), [1.0, 2.0]);
    let unknown = run("weihong", "G0 X1\nG906 PLC[99] LEVEL1\nX2\nM30", |_| 0);
    assert!(matches!(unknown.cnc.state(), State::Alarmed(alarm) if alarm.fault == Fault::InputMissing));
}
