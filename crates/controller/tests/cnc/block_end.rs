//! Single block, blocks that are finished on demand, locks, dry run, and axes moved by hand on the way.

use crate::common::{cnc, cnc_with, ended, in_language, machine};
use ferrocut_controller::{Cnc, DryRun, Interruption, State, Tick};
use ferrocut_geometry::{Axis, Position};
use ferrocut_machine::Ramp;
use ferrocut_program::FileId;

/// Goes on until the program stops or ends.
fn until_it_stops(cnc: &mut Cnc) -> Vec<Tick> {
    let mut ticks = Vec::new();
    for _ in 0..200_000 {
        ticks.push(cnc.tick());
        if !matches!(cnc.state(), State::Running | State::Resetting) {
            return ticks;
        }
    }
    panic!("does not stop: {:?}", cnc.state());
}

fn settle(cnc: &mut Cnc) -> Position {
    for _ in 0..100_000 {
        let tick = cnc.tick();
        if !tick.moving {
            return tick.position;
        }
    }
    panic!("never at rest");
}

/// X of the stops, cycle start pressed at each.
fn stops(cnc: &mut Cnc) -> Vec<(f64, f64)> {
    let mut found = Vec::new();
    for _ in 0..100 {
        cnc.cycle_start();
        until_it_stops(cnc);
        if cnc.state() != &State::BlockEnd {
            return found;
        }
        let at = cnc.tick().position;
        found.push((at[Axis::X], at[Axis::Y]));
    }
    panic!("never ends");
}

const CORNERS: &str = "G90 G1 X10 F3000\nX20 Y10\nG2 X30 Y0 R10\nG4 X0.1\nG1 X40\nM30\n";

#[test]
fn single_block_stops_on_the_end_of_every_block() {
    let mut cnc = cnc(&machine(), CORNERS);
    cnc.set_single_block(true);
    let expected = [(10.0, 0.0), (20.0, 10.0), (30.0, 0.0), (30.0, 0.0), (40.0, 0.0)];
    assert_eq!(stops(&mut cnc), expected);
    assert_eq!(cnc.state(), &State::Ended);
}

#[test]
fn g28_stops_at_its_intermediate_point_too() {
    let mut cnc = cnc(&machine(), "G90 G0 X30 Y5\nG28 X40 Y20\nG1 X5 F3000\nM30\n");
    cnc.set_single_block(true);
    assert_eq!(stops(&mut cnc), [(30.0, 5.0), (40.0, 20.0), (0.0, 0.0), (5.0, 0.0)]);
}

/// GSK990MC 51#5: with single block macro statements are blocks of their own, in both forms of the language, where no
/// cutter compensation looks ahead over them.
#[test]
fn single_block_stops_behind_macro_statements_where_a_parameter_says_so() {
    let program = "#1=1\nG1 X5 F3000\n/#2=0\nIF [#1 EQ 1] GOTO 9\nX9\nN9 G65 H01 P#3 Q0\nWHILE [#3 LT 2] DO 1\n\
        #3=#3+1\nX[10+#3]\nEND 1\nG41 D1 X20\n#4=1\nX30\nG40 X40\nM30\n";
    let lines = |bit: u8, single: bool| {
        let setup = format!("[parameters]\n\"NO51.5\" = {bit}\n[tools.1]\nradius = 1.0");
        let mut cnc = cnc_with(&machine(), program, &setup);
        cnc.set_block_skip(true, false);
        cnc.set_single_block(single);
        let mut found = Vec::new();
        for _ in 0..40 {
            cnc.cycle_start();
            let line = until_it_stops(&mut cnc).last().map(|tick| tick.span.line);
            match cnc.state() {
                State::BlockEnd => found.extend(line),
                state => {
                    assert_eq!(state, &State::Ended);
                    return found;
                }
            }
        }
        panic!("never ends: {found:?}");
    };
    assert_eq!(lines(0, true), [2, 9, 9, 11, 13, 14]);
    assert_eq!(lines(1, true), [1, 2, 4, 6, 7, 8, 9, 10, 7, 8, 9, 10, 7, 11, 13, 14]);
    assert_eq!(lines(1, false), [0; 0]);
}

/// GSK990MC part 2, 7.6: behind each block, also one that only sets what is in force. One that leads elsewhere, or has
/// nothing but numbers, is none.
#[test]
fn single_block_stops_behind_blocks_that_make_no_step() {
    let program = "O1\nG90 G54\n(note)\nN10\nF3000\nG1 X5\nM98 P2\n/G91\nG41 D1\nG1 X10\nG90\nG40 X20\nM30\nO2\nG17\nM99\n";
    let mut cnc = cnc_with(&machine(), program, "[tools.1]\nradius = 1.0");
    cnc.set_block_skip(true, false);
    // Compensation looks ahead over the blocks without a move.
    assert_eq!(stop_lines(cnc), (vec![2, 5, 6, 15, 10, 12], State::Ended));
}

/// Lines that single block stops behind, and how the program ended.
fn stop_lines(mut cnc: Cnc) -> (Vec<u32>, State) {
    cnc.set_single_block(true);
    let mut lines = Vec::new();
    loop {
        cnc.cycle_start();
        let line = until_it_stops(&mut cnc).last().map(|tick| tick.span.line);
        match cnc.state() {
            State::BlockEnd => lines.extend(line),
            state => return (lines, state.clone()),
        }
    }
}

/// What is only described, left out or wrong is no block that was done.
#[test]
fn single_block_passes_what_is_not_done() {
    let of = |language: &str, program: &str| stop_lines(Cnc::new(&machine(), in_language(language, program)));
    let guarded = "#1=5\nIF(#1==0) G0 X3\nIF(#1==5) G01 X2 F900\nM30\n";
    assert_eq!(of("weihong", guarded), (vec![3], State::Ended));
    let profile = "#PROFILE R [XY]\nG0 X0 Y0\nG1 X10\nY6\nX0\nY0\n#ENDPROFILE\nG1 X3 F900\nM30\n";
    assert_eq!(of("fagor8065", profile), (vec![8], State::Ended));
    let (lines, state) = of("gsk990mc", "G1 X12 F3000\nN10 G777\nM30\n");
    assert_eq!(lines, [1]);
    assert!(matches!(state, State::Alarmed(alarm) if alarm.span.line == 2));
}

/// A reset behind a block that only set what is in force leaves that in force.
#[test]
fn a_reset_at_such_a_stop_keeps_what_was_set() {
    let mut cnc = cnc(&machine(), "G54\nG1 X6 F3000\nG55\nG91\nG1 X1\nM30\n");
    cnc.set_single_block(true);
    for _ in 0..4 {
        cnc.cycle_start();
        until_it_stops(&mut cnc);
    }
    let in_force = |cnc: &Cnc| {
        let codes: Vec<u16> = cnc.interpreter().codes_in_force().collect();
        [540, 550, 900, 910].map(|code| codes.contains(&code))
    };
    assert_eq!(in_force(&cnc), [false, true, false, true]);
    cnc.reset();
    settle(&mut cnc);
    assert_eq!(in_force(&cnc), [false, true, false, true]);
}

/// The line to stop at is stopped behind, and not only a part of its cycle.
#[test]
fn a_line_to_stop_at_is_not_used_up_by_a_part_of_its_cycle() {
    let mut cnc = cnc(&machine(), "M3 S1000\nG90 G98 G81 X5 Z-3 R-1 F3000\nG80 G1 X9\nM30\n");
    cnc.set_single_block(true);
    cnc.stop_behind(Some((FileId(0), 2)));
    for _ in 0..2 {
        cnc.cycle_start();
        until_it_stops(&mut cnc);
    }
    assert_eq!((cnc.tick().position[Axis::X], cnc.stops_behind()), (5.0, Some((FileId(0), 2))));
    cnc.set_single_block(false);
    cnc.cycle_start();
    until_it_stops(&mut cnc);
    let at = cnc.tick().position;
    assert_eq!((at[Axis::X], at[Axis::Z], cnc.state()), (5.0, 0.0, &State::BlockEnd));
    assert_eq!(cnc.stops_behind(), None);
}

/// 3.4.1, stop number: also behind a line that moves nothing, a statement, and a call.
#[test]
fn a_line_to_stop_at_need_not_move_anything() {
    let program = "#1=2\nG90 G1 X5 F3000\nF2000\n#1=7\nM98 P7\nG1 X#1\nM30\nO7\nG1 X6\nM99\n";
    for (line, x) in [(1, 0.0), (3, 5.0), (4, 5.0), (5, 5.0), (9, 6.0), (10, 6.0)] {
        let mut cnc = cnc(&machine(), program);
        cnc.stop_behind(Some((FileId(0), line)));
        cnc.cycle_start();
        until_it_stops(&mut cnc);
        assert_eq!((cnc.tick().position[Axis::X], cnc.state()), (x, &State::BlockEnd), "line {line}");
        assert_eq!(cnc.stops_behind(), None);
        cnc.cycle_start();
        until_it_stops(&mut cnc);
        assert_eq!((cnc.tick().position[Axis::X], cnc.state()), (7.0, &State::Ended), "line {line}");
    }
}

/// 51#5: a statement is no block, also where it waits for the machine or sets an output.
#[test]
fn single_block_runs_through_statements_that_wait() {
    let program = "G90 G1 X5 F3000\n#1=#5006+1\n#1100=1\nIF[#5006 GT 9] GOTO 9\nG1 X#1\nN9 M30\n";
    for (setup, starts) in [("", 3), ("[parameters]\n\"NO51.5\" = 1\n", 6)] {
        let mut cnc = Cnc::new(&machine(), crate::common::interpreter(program, setup));
        cnc.set_single_block(true);
        let mut count = 0;
        while cnc.state() != &State::Ended {
            cnc.cycle_start();
            until_it_stops(&mut cnc);
            count += 1;
            assert!(count < 9, "{:?}", cnc.state());
        }
        assert_eq!((count, cnc.tick().position[Axis::X]), (starts, 6.0));
    }
}

/// GSK990MC 4.3.4, 2.
#[test]
fn under_machine_lock_no_axis_comes_to_its_reference_point() {
    for locked in [false, true] {
        let mut cnc = Cnc::new(&machine(), crate::common::interpreter("G0 X5\nG28 X5\nM30\n", ""));
        cnc.set_referenced([Axis::X].into_iter().collect());
        assert!(cnc.set_machine_lock(locked));
        cnc.cycle_start();
        until_it_stops(&mut cnc);
        assert_eq!(cnc.at_reference().contains(Axis::X), !locked);
    }
}

/// GSK990MC part 1, 4: a canned cycle is done in three parts, the positioning, the way to level R and the rest.
#[test]
fn single_block_stops_behind_the_parts_of_a_canned_cycle() {
    let stops = |program: &str| {
        let mut cnc = cnc(&machine(), program);
        cnc.set_single_block(true);
        let mut found = Vec::new();
        loop {
            cnc.cycle_start();
            until_it_stops(&mut cnc);
            let at = cnc.tick().position;
            found.push((at[Axis::X], at[Axis::Z]));
            if cnc.state() != &State::BlockEnd {
                assert_eq!(cnc.state(), &State::Ended);
                return found;
            }
        }
    };
    let hole = [(0.0, 0.0), (5.0, 0.0), (5.0, -1.0), (5.0, 0.0), (9.0, 0.0), (9.0, -1.0)];
    let with_end = |end: (f64, f64)| hole.into_iter().chain([end, end]).collect::<Vec<_>>();
    let drill = "M3 S1000\nG90 G98 G83 X5 Z-3 R-1 Q1 F3000\nG99 X9\nM30\n";
    assert_eq!(stops(drill), with_end((9.0, -1.0)));
    let bore = "M3 S1000\nG90 G98 G89 X5 Z-3 R-1 P10 F3000\nX9\nM30\n";
    assert_eq!(stops(bore), with_end((9.0, 0.0)));
    // What the block does beside belongs to the first.
    let start = "G90 G98 G81 X5 Z-3 R-1 F3000 M3 S1000\nM30\n";
    assert_eq!(stops(start), [(5.0, 0.0), (5.0, -1.0), (5.0, 0.0), (5.0, 0.0)]);
    // Each of several holes has its own, and a tool over its hole is not positioned.
    let repeated = "M3 S1000\nG91 G99 G81 X5 Z-2 R-1 F3000 K2\nM30\n";
    let places = [(0.0, 0.0), (5.0, 0.0), (5.0, -1.0), (5.0, -1.0), (10.0, -1.0), (10.0, -1.0), (10.0, -1.0)];
    assert_eq!(stops(repeated), places);
    assert_eq!(
        stops("M3 S1000\nG90 G81 Z-2 R-1 F3000\nM30\n"),
        [(0.0, 0.0), (0.0, -1.0), (0.0, 0.0), (0.0, 0.0)]
    );
}

/// A loop that consists of one and the same block, in every form that a program can have one: each pass is a block of its
/// own, also where single block is asked for in its midst, and a canned cycle that makes several holes is one.
#[test]
fn single_block_stops_behind_every_pass_of_one_and_the_same_block() {
    let xs = |text: &str| {
        let mut cnc = cnc(&machine(), text);
        cnc.set_single_block(true);
        stops(&mut cnc).iter().map(|(x, _)| *x).collect::<Vec<_>>()
    };
    let pass = "#1=0\nWHILE [#1 LT 3] DO 1\n#1=#1+1\nG91 G1 X5 F3000\nEND 1\nM30\n";
    assert_eq!(xs(pass), [5.0, 10.0, 15.0]);
    assert_eq!(xs("M98 P2 L3\nM30\nO2\nG91 G1 X5 F3000\nM99\n"), [5.0, 10.0, 15.0]);
    assert_eq!(xs("#1=0\nN5 G91 G1 X5 F3000\n#1=#1+1\nIF [#1 LT 3] GOTO 5\nM30\n"), [5.0, 10.0, 15.0]);
    // A dwell goes nowhere.
    assert_eq!(xs("#1=0\nWHILE [#1 LT 3] DO 1\n#1=#1+1\nG4 X0.01\nEND 1\nM30\n"), [0.0; 3]);

    let mut cnc = cnc(&machine(), "#1=0\nG91\nWHILE [#1 LT 200] DO 1\n#1=#1+1\nG1 X0.5 F3000\nEND 1\nM30\n");
    cnc.cycle_start();
    for _ in 0..500 {
        cnc.tick();
    }
    assert_eq!(cnc.next_span().map(|span| span.line), Some(5), "the same block once more");
    cnc.set_single_block(true);
    until_it_stops(&mut cnc);
    let stop = cnc.tick().position[Axis::X];
    assert!(
        cnc.state() == &State::BlockEnd && stop < 60.0 && (stop * 2.0 - (stop * 2.0).round()).abs() < 1e-9
    );
    for k in 1..4 {
        cnc.cycle_start();
        until_it_stops(&mut cnc);
        assert!((cnc.tick().position[Axis::X] - stop - 0.5 * f64::from(k)).abs() < 1e-9);
    }
    cnc.set_single_block(false);
    // And the mode that is left finishes the pass under way, not the loop.
    cnc.cycle_start();
    (0..100).for_each(|_| _ = cnc.tick());
    cnc.finish_block();
    until_it_stops(&mut cnc);
    assert!(cnc.state() == &State::BlockEnd && cnc.tick().position[Axis::X] < 80.0);
}

#[test]
fn a_block_is_finished_exactly_whenever_that_is_asked_for() {
    let machine = machine();
    let (_, through) = ended(&machine, CORNERS);
    let ends = [(10.0, 0.0), (20.0, 10.0), (30.0, 0.0), (40.0, 0.0)];
    for at in (0..through.ticks.len()).step_by(37) {
        let mut cnc = cnc(&machine, CORNERS);
        let start = cnc.tick().position;
        cnc.cycle_start();
        let mut ticks: Vec<_> = (0..at).map(|_| cnc.tick()).collect();
        cnc.finish_block();
        ticks.extend(until_it_stops(&mut cnc));
        if cnc.state() == &State::Ended {
            continue;
        }
        assert_eq!(cnc.state(), &State::BlockEnd, "{at}");
        let stop = cnc.tick().position;
        let found = ends.iter().position(|(x, y)| (stop[Axis::X], stop[Axis::Y]) == (*x, *y));
        assert!(found.is_some(), "asked at tick {at}: stopped at {stop:?}");
        cnc.cycle_start();
        ticks.extend(until_it_stops(&mut cnc));
        assert_eq!(cnc.state(), &State::Ended, "{at}");
        let run = crate::common::Run { start, ticks, events: Vec::new() };
        run.follows(&through, 0.02);
        assert_eq!(cnc.report().moves, 4);
    }
}

#[test]
fn single_block_in_the_middle_of_short_blocks_stops_on_one_of_them() {
    let machine = machine();
    let line = |i: i32| format!("G1 X{:.3} Y{:.3} F6000\n", f64::from(i) * 0.1, (f64::from(i) * 0.05).sin());
    let text: String = (1..300).map(line).collect();
    let program = format!("G90\n{text}M30\n");
    for at in [20, 60, 111, 180, 260] {
        let mut cnc = cnc(&machine, &program);
        cnc.cycle_start();
        let mut from = 0.0;
        for _ in 0..at {
            from = cnc.tick().position[Axis::X] * 10.0;
        }
        cnc.set_single_block(true);
        until_it_stops(&mut cnc);
        assert_eq!(cnc.state(), &State::BlockEnd);
        let x = cnc.tick().position[Axis::X] * 10.0;
        assert!((x - x.round()).abs() < 1e-9 && x > from && x < from + 120.0, "{from} {x}");
        cnc.cycle_start();
        until_it_stops(&mut cnc);
        let next = cnc.tick().position[Axis::X] * 10.0;
        assert!((next - x - 1.0).abs() < 1e-9, "{x} {next}");
        cnc.set_single_block(false);
        cnc.cycle_start();
        until_it_stops(&mut cnc);
        assert_eq!((cnc.state(), cnc.report().moves), (&State::Ended, 299));
    }
}

#[test]
fn a_program_stops_once_behind_the_line_that_was_named() {
    let mut cnc = cnc(&machine(), CORNERS);
    cnc.stop_behind(Some((FileId(0), 2)));
    cnc.cycle_start();
    until_it_stops(&mut cnc);
    assert_eq!((cnc.state(), cnc.stops_behind()), (&State::BlockEnd, None));
    assert_eq!(cnc.tick().position, Position::xyz(20.0, 10.0, 0.0));
    cnc.cycle_start();
    until_it_stops(&mut cnc);
    assert_eq!(cnc.state(), &State::Ended);
}

#[test]
fn manual_intervention_returns_and_a_shift_stays() {
    let machine = machine();
    for (kind, end) in [(Interruption::Return, 50.0), (Interruption::Shift, 53.0)] {
        let mut cnc = cnc(&machine, "G90 G1 X50 F3000\nM30\n");
        cnc.cycle_start();
        for _ in 0..400 {
            cnc.tick();
        }
        cnc.feed_hold();
        let held = settle(&mut cnc);
        assert!(!cnc.jog_step(Axis::X, 3, 1.0), "nobody may unless it is said");
        cnc.set_interruption(kind);
        assert!(cnc.jog_step(Axis::X, 3, 1.0) && cnc.jog_step(Axis::Z, 2, 1.0));
        let aside = settle(&mut cnc);
        assert!((aside[Axis::X] - held[Axis::X] - 3.0).abs() < 1e-9 && aside[Axis::Z] == 2.0);
        assert_eq!(cnc.state(), &State::Held);
        cnc.cycle_start();
        let mut back = false;
        for _ in 0..20_000 {
            let tick = cnc.tick();
            back |= (tick.position - held).0.iter().all(|d| d.abs() < 1e-5);
            if cnc.state() == &State::Ended {
                break;
            }
        }
        assert_eq!(cnc.state(), &State::Ended);
        assert_eq!(back, kind == Interruption::Return);
        let at = cnc.tick().position;
        assert!((at[Axis::X] - end).abs() < 1e-9, "{at:?}");
        // The work coordinates do not know of a shift.
        assert_eq!(cnc.interpreter().position()[Axis::X], 50.0);
        if kind == Interruption::Shift {
            assert!((cnc.handwheel_shift()[Axis::X] - 3.0).abs() < 1e-9);
            assert!(cnc.clear_handwheel_shift(None));
            assert!((cnc.interpreter().position()[Axis::X] - 53.0).abs() < 1e-9);
            assert!((cnc.tick().position[Axis::X] - 53.0).abs() < 1e-9);
        }
    }
}

#[test]
fn reset_after_an_intervention_leaves_the_axes_and_their_coordinates_in_agreement() {
    for kind in [Interruption::Return, Interruption::Shift] {
        let mut cnc = cnc(&machine(), "G90 G1 X50 F3000\nM30\n");
        cnc.set_interruption(kind);
        cnc.cycle_start();
        for _ in 0..400 {
            cnc.tick();
        }
        cnc.feed_hold();
        settle(&mut cnc);
        cnc.jog_step(Axis::Y, 7, 1.0);
        let aside = settle(&mut cnc);
        cnc.reset();
        for _ in 0..100 {
            assert_eq!(cnc.tick().position, aside);
        }
        assert_eq!((cnc.state(), cnc.interpreter().position()), (&State::Reset, aside));
        assert_eq!(cnc.handwheel_shift(), Position::ZERO);
    }
}

#[test]
fn locked_axes_stand_while_positions_go_on_and_nothing_is_lost_after() {
    use std::sync::{Arc, Mutex};
    struct Told(Arc<Mutex<Position>>);
    impl ferrocut_controller::Drives for Told {
        fn exchange(&mut self, commanded: &Position) -> Position {
            *self.0.lock().unwrap() = *commanded;
            *commanded
        }
    }
    let told = Arc::new(Mutex::new(Position::ZERO));
    let interpreter = crate::common::interpreter("G90 G1 X50 F3000\nM30\n", "");
    let mut cnc = Cnc::with_drives(&machine(), interpreter, Box::new(Told(told.clone())));
    cnc.jog_step(Axis::X, 2, 1.0);
    settle(&mut cnc);
    assert!(cnc.set_machine_lock(true));
    cnc.cycle_start();
    for _ in 0..300 {
        cnc.tick();
        assert!(!cnc.set_machine_lock(false), "not while a program runs");
    }
    let ticks = until_it_stops(&mut cnc);
    assert_eq!(ticks.last().unwrap().position[Axis::X], 50.0);
    assert_eq!(told.lock().unwrap()[Axis::X], 2.0);
    assert!(cnc.set_machine_lock(false));
    assert_eq!(cnc.tick().position[Axis::X], 2.0);
    assert_eq!((told.lock().unwrap()[Axis::X], cnc.interpreter().position()[Axis::X]), (2.0, 2.0));
}

/// Drives that count for themselves, as those of a board do, and where their axes are physically.
#[derive(Clone, Copy, Default)]
struct Counting {
    told: Position,
    zero: Position,
}

struct Counts(std::sync::Arc<std::sync::Mutex<Counting>>);

impl ferrocut_controller::Drives for Counts {
    fn exchange(&mut self, commanded: &Position) -> Position {
        self.0.lock().unwrap().told = *commanded;
        *commanded
    }

    fn rename(&mut self, at: &Position) {
        let mut counting = self.0.lock().unwrap();
        counting.zero = counting.told + counting.zero - *at;
        counting.told = *at;
    }
}

#[test]
fn under_machine_lock_no_place_gets_another_name_at_the_drives() {
    let counting = std::sync::Arc::new(std::sync::Mutex::new(Counting::default()));
    let physical = || {
        let counting = *counting.lock().unwrap();
        counting.told + counting.zero
    };
    let reference = "[reference_points]\nfirst = { x = 10.0 }\n";
    for parameters in ["\"NO5.4\" = 1", "\"NO6.4\" = 1"] {
        let setup = format!("{reference}[parameters]\n{parameters}\n");
        let interpreter = crate::common::interpreter("G28 X0\nM30\n", &setup);
        let mut cnc = Cnc::with_drives(&machine(), interpreter, Box::new(Counts(counting.clone())));
        cnc.jog_step(Axis::X, 2, 1.0);
        settle(&mut cnc);
        assert!(cnc.set_machine_lock(true));
        let from = physical();
        let stands = |cnc: &mut Cnc, what: &str| {
            for _ in 0..3000 {
                cnc.tick();
                assert_eq!(physical(), from, "{what} {parameters}");
            }
        };
        let x = [Axis::X].into_iter().collect();
        assert!(!cnc.home(Axis::X) && !cnc.set_machine_zero(x));
        stands(&mut cnc, "asked for by hand");
        cnc.set_referenced(Default::default());
        cnc.cycle_start();
        stands(&mut cnc, "by a program");
        cnc.reset();
        stands(&mut cnc, "reset");
        assert!(cnc.set_machine_lock(false));
        stands(&mut cnc, "unlocked");
        assert!(cnc.set_machine_zero(x), "as soon as it is off");
    }
    // A program that gives the place another name: the name goes with the lock.
    let interpreter = crate::common::in_language("weihong", "G91 G0 X5\nM902 H0\nG91 X1\nM30\n");
    let mut cnc = Cnc::with_drives(&machine(), interpreter, Box::new(Counts(counting.clone())));
    cnc.tick();
    assert!(cnc.set_machine_lock(true));
    let from = physical();
    let renamed = cnc.renamed();
    cnc.cycle_start();
    for _ in 0..5000 {
        cnc.tick();
        assert_eq!(physical(), from);
    }
    assert_eq!((cnc.state(), cnc.renamed() == renamed), (&State::Ended, false));
    assert!(cnc.set_machine_lock(false));
    cnc.tick();
    assert_eq!((physical(), cnc.renamed()), (from, renamed));
}

#[test]
fn dry_run_sets_the_speed_of_what_it_holds_for_and_takes_effect_on_the_way() {
    let machine = machine();
    let top = |ticks: &[Tick]| (ticks.iter().map(|t| t.velocity).fold(0.0, f64::max) * 60.0).round();
    let dry = DryRun { speed: 4000.0 / 60.0, cutting: true, rapid: false, tapping: false };
    let mut control = cnc(&machine, "G1 X60 F1000\nM30\n");
    control.set_dry_run(Some(dry));
    control.cycle_start();
    assert_eq!(top(&until_it_stops(&mut control)), 4000.0);
    let mut control = cnc(&machine, "G1 X60 F1000\nM30\n");
    control.cycle_start();
    let before: Vec<_> = (0..500).map(|_| control.tick()).collect();
    assert_eq!(top(&before), 1000.0);
    control.set_dry_run(Some(dry));
    assert_eq!(top(&until_it_stops(&mut control)), 4000.0);
    assert_eq!(control.tick().position[Axis::X], 60.0);
    let mut control = cnc_with(&machine, "G0 X60\nM30\n", "[parameters]\n\"NO12.1\" = 1");
    control.set_dry_run(Some(DryRun { rapid: true, cutting: false, tapping: false, speed: 50.0 }));
    control.cycle_start();
    assert_eq!(top(&until_it_stops(&mut control)), 3000.0);
}

#[test]
fn an_interlock_holds_the_axes_and_the_program_goes_on_after_it() {
    let mut cnc = cnc(&machine(), "G1 X60 F3000\nM30\n");
    cnc.cycle_start();
    for _ in 0..200 {
        cnc.tick();
    }
    cnc.set_may_move(false);
    for _ in 0..500 {
        cnc.tick();
    }
    let at = cnc.tick().position;
    assert_eq!((cnc.tick().position, cnc.state()), (at, &State::Running));
    assert!(at[Axis::X] < 60.0);
    cnc.set_may_move(true);
    until_it_stops(&mut cnc);
    assert_eq!(cnc.state(), &State::Ended);
    assert_eq!(cnc.tick().position[Axis::X], 60.0);
}

/// A line may be named when motion has long planned it: its end is met, or the program stops as soon as it can.
#[test]
fn a_line_that_short_blocks_are_about_to_come_to_is_stopped_behind() {
    let line = |i: i32| format!("G1 X{:.3} Y{:.3} F6000\n", f64::from(i) * 0.1, (f64::from(i) * 0.05).sin());
    let text: String = (1..1500).map(line).collect();
    let program = format!("G90\n{text}M30\n");
    for ahead in [1, 5, 50, 110, 500] {
        let mut cnc = cnc(&machine(), &program);
        cnc.cycle_start();
        let x = |cnc: &mut Cnc| cnc.tick().position[Axis::X] * 10.0;
        while x(&mut cnc) < 600.0 {}
        // Line 1 is G90: block `i` is on line `i + 1`.
        let block = x(&mut cnc).ceil() as u32 + ahead;
        cnc.stop_behind(Some((FileId(0), block + 1)));
        until_it_stops(&mut cnc);
        assert_eq!((cnc.state(), cnc.stops_behind()), (&State::BlockEnd, None), "{ahead}");
        let stop = x(&mut cnc);
        assert!((stop - stop.round()).abs() < 1e-9, "{ahead}: {stop}");
        let late = stop - f64::from(block);
        match ahead > 110 {
            true => assert_eq!(late, 0.0, "{ahead}"),
            false => assert!((0.0..120.0).contains(&late), "{ahead}: {late} behind"),
        }
        cnc.cycle_start();
        until_it_stops(&mut cnc);
        assert_eq!((cnc.state(), cnc.report().moves), (&State::Ended, 1499), "{ahead}");
    }
}

/// Parameters that make the path brake more slowly than the axes could: the end of a block is met all the same.
#[test]
fn a_block_ends_where_it_ends_with_slow_ramps_too() {
    let slow = Ramp { acceleration: 250.0, jerk: 0.0 };
    for what in 0..2 {
        let mut machine = machine();
        match what {
            0 => machine.path.ramp = Some(slow),
            _ => machine.axes.iter_mut().for_each(|axis| axis.before_cutting = Some(slow)),
        }
        let text = "G90\nG1 X60 F6000\nX120\nX180\nM30\n";
        for at in (50..1700).step_by(83) {
            let mut cnc = cnc(&machine, text);
            cnc.cycle_start();
            for _ in 0..at {
                cnc.tick();
            }
            let from = cnc.tick().position[Axis::X];
            cnc.set_single_block(true);
            until_it_stops(&mut cnc);
            let stop = cnc.tick().position[Axis::X];
            assert!([60.0, 120.0, 180.0].contains(&stop), "{what} at {at}: {stop}");
            // The next end that it can come to rest at: 100 mm/s need 20 mm, the program is told of it somewhat before.
            assert!(stop - from < 60.0 + 45.0, "{what} at {at}: {from} {stop}");
        }
    }
}
