//! Inputs that programs wait for and read on a machine with a ladder (LinuxCNC M codes: M66; Weihong 4.4: G906).

use crate::common::{HANGS, in_language, machine};
use ferrocut_controller::restart::{At, How};
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

/// The setpoints of a program, each once.
fn way(program: &str, inputs: u16) -> Vec<[f64; 2]> {
    let mut cnc = Cnc::new(&machine(), in_language("rs274", program));
    cnc.connect_ladder(&machine());
    cnc.cycle_start();
    let mut way = vec![[0.0; 2]];
    for _ in 0..HANGS {
        let mut heard = Control::free_inputs(Mode::Auto);
        heard.macro_inputs = inputs;
        cnc.hear(&heard);
        let position = cnc.tick().position;
        way.push([position[Axis::X], position[Axis::Y]]);
        if cnc.waits_for_ladder() {
            way.dedup();
            return way;
        }
    }
    panic!("does not end: {:?}", cnc.state());
}

#[test]
fn what_is_in_the_block_comes_behind_the_wait() {
    for (wait, inputs, result) in
        [("M66 P1 L3 Q0.1", 0b10, "1"), ("M66 P1 L3 Q0.1", 0, "-1"), ("M66 P1 L0", 0b10, "1")]
    {
        for program in [
            "G21 G61.1\nG1 F3000\nWAIT X10\nY10\nX[#5399+20]\nM2\n",
            "G21 G91 G61.1\nG1 F3000\nWAIT X10\nY10\nX[#5399+20]\nM2\n",
            "G21 G61.1\nG1 F3000 X5\nWAIT G3 X15 I5 J0\nG1 Y10\nX[#5399+20]\nM2\n",
        ] {
            let waiting = way(&program.replace("WAIT", wait), inputs);
            let free = way(&program.replace("WAIT", "").replace("#5399", result), inputs);
            assert!(free.len() > 500);
            let far = |(a, b): (&[f64; 2], &[f64; 2])| (a[0] - b[0]).abs().max((a[1] - b[1]).abs());
            let farthest = waiting.iter().zip(&free).map(far).fold(0.0, f64::max);
            assert!(waiting.len() == free.len() && farthest < 1e-9, "{wait} {program}: {farthest}");
        }
    }
}

/// Goes on with a word of inputs until X is above a place and not below any more.
fn go_on_to(cnc: &mut Cnc, inputs: u16, x: f64) {
    let hangs = (0..HANGS).all(|_| {
        let mut heard = Control::free_inputs(Mode::Auto);
        heard.macro_inputs = inputs;
        cnc.hear(&heard);
        cnc.tick().position[Axis::X] < x
    });
    assert!(!hangs, "{:?}", cnc.state());
}

fn break_off(cnc: &mut Cnc) {
    cnc.reset();
    go_on_to(cnc, 0, f64::NEG_INFINITY);
    while *cnc.state() == State::Resetting {
        go_on_to(cnc, 0, f64::NEG_INFINITY);
    }
}

/// Where the program goes on: its line, and #5399 there.
fn taken_up(cnc: &mut Cnc) -> (u32, Option<f64>) {
    let journal = cnc.journal().unwrap().clone();
    let restart = journal.find(At::Interrupted, cnc.interpreter().memory()).unwrap();
    let found = (restart.span.line, restart.interpreter().memory().variables.get(5399));
    let how = How { sends: false, axis_by_axis: false };
    let lead_in = restart.lead_in(&cnc.present(), &machine(), how).unwrap();
    cnc.restart(restart, lead_in).unwrap();
    cnc.cycle_start();
    found
}

#[test]
fn a_restart_knows_what_came() {
    let program = "G21 G61.1\nG1 X10 F3000\nM66 P3 L4 Q0.2\nM66 P2 L0\n#1=#5399\nX[20+5*#1]\nX90\nM2\n";
    let start = |inputs: u16| {
        let mut cnc = Cnc::new(&machine(), in_language("rs274", program));
        cnc.connect_ladder(&machine());
        cnc.cycle_start();
        go_on_to(&mut cnc, inputs, 9.0);
        cnc
    };
    // Input 2 is off as the run begins, and on as it is read; input 3 does not go off in time.
    let mut cnc = start(0);
    go_on_to(&mut cnc, 0b1100, 60.0);
    break_off(&mut cnc);
    assert_eq!(taken_up(&mut cnc), (7, Some(1.0)));
    go_on_to(&mut cnc, 0, 89.0);

    // Broken off within the wait, and again behind it.
    let waits = "G21 G61.1\nG1 X10 F3000\nM66 P3 L4 Q0.2\nX[20+5*#5399]\nX90\nM2\n";
    let mut cnc = Cnc::new(&machine(), in_language("rs274", waits));
    cnc.connect_ladder(&machine());
    cnc.cycle_start();
    go_on_to(&mut cnc, 0, 10.0);
    for _ in 0..50 {
        go_on_to(&mut cnc, 0b1000, 10.0);
    }
    break_off(&mut cnc);
    taken_up(&mut cnc);
    go_on_to(&mut cnc, 0b1000, 60.0);
    break_off(&mut cnc);
    assert_eq!(taken_up(&mut cnc), (5, Some(-1.0)));
}

#[test]
fn a_move_of_g904_ends_where_its_input_comes_or_goes() {
    // 10 mm/s.
    let program = |level: u8| format!("G904 FX600 PX=3 LX{level}\nG4 X0.1\nG91 X5\nG4 X0.1\nM30");
    for level in [0, 1] {
        let found =
            run("weihong", &program(level), move |now| if (now > 1000) == (level == 1) { 8 } else { 0 });
        let &[(at, _), (behind, _)] = found.stood.as_slice() else { panic!("{:?}", found.stood) };
        assert!((9.0..11.0).contains(&at) && (behind - at - 5.0).abs() < 1e-9, "{level} {:?}", found.stood);
    }
    // It does not come: no further than is said.
    let short = run("weihong", "G904 X-3 FX-600 PX=3 LX1\nG4 X0.1\nM30", |_| 0);
    assert_eq!(places(&short), [-3.0]);
    // There is no such input.
    let none = run("weihong", "G904 X3 FX600 PX=16 LX1\nM30", |_| 0);
    assert!(matches!(none.cnc.state(), State::Alarmed(alarm) if alarm.fault == Fault::InputMissing));
}

#[test]
fn a_probe_that_is_not_there_is_no_contact() {
    let probes = run("rs274", "G21\nG38.2 X5 F100\nG0 X20\nM2\n", |_| 0);
    assert!(matches!(probes.cnc.state(), State::Alarmed(alarm) if alarm.fault == Fault::ProbeMissing));
    assert_eq!(places(&probes).last().copied().unwrap_or(0.0), 0.0);
    // One that need not touch moves on.
    assert_eq!(places(&run("rs274", "G21\nG38.3 X5 F100\nG4 P0.1\nM2\n", |_| 0)), [5.0]);
}
