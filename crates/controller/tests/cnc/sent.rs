//! A program that is sent while it runs: joined as far as it comes in time, at rest when it fails to, and jogs in

//! lines beside it.

use crate::common::machine;
use ferrocut_controller::{Cnc, State, Tick};
use ferrocut_geometry::{Axis, Position};
use ferrocut_interpreter::{Interpreter, Options, dialects};
use ferrocut_machine::{Fault, Memory};
use ferrocut_program::{ProgramMemory, Text};

fn sent(keep_going: bool) -> Cnc {
    let dialect = &dialects::rs274::DIALECT;
    let programs = ProgramMemory::new("sent", Text::sent(), dialect.syntax);
    let options = Options { keep_going, ..Options::default() };
    let mut cnc = Cnc::new(&machine(), Interpreter::new(dialect, programs, Memory::new("rs274"), options));
    cnc.cycle_start();
    cnc
}

/// Ticks until all that came is done.
fn settle(cnc: &mut Cnc) -> Vec<Tick> {
    let mut ticks = Vec::new();
    for _ in 0..200_000 {
        ticks.push(cnc.tick());
        if cnc.awaits_work() {
            return ticks;
        }
    }
    panic!("never done: {:?}", cnc.state());
}

fn wait(cnc: &mut Cnc, periods: usize) {
    for _ in 0..periods {
        cnc.tick();
    }
}

fn seconds(program: &str, every: Option<usize>) -> (f64, Position) {
    let mut cnc = sent(false);
    let mut ticks = 0;
    for line in program.lines() {
        cnc.append(format!("{line}\n").as_bytes()).unwrap();
        for _ in 0..every.unwrap_or(0) {
            cnc.tick();
            ticks += 1;
        }
    }
    let rest = settle(&mut cnc);
    (f64::from(ticks + rest.len() as i32) / 1000.0, rest[rest.len() - 1].position)
}

/// A circle of short lines, 40 mm across.
fn circle() -> String {
    let mut program = "G21 G90 G94 G64 P0.01 F3000\n".to_owned();
    for k in 0..=360 {
        let angle = f64::from(k).to_radians();
        program += &format!("G1 X{:.4} Y{:.4}\n", 20.0 - 20.0 * angle.cos(), 20.0 * angle.sin());
    }
    program
}

#[test]
fn lines_that_come_in_time_are_joined() {
    let (at_once, end) = seconds(&circle(), None);
    let (in_time, same) = seconds(&circle(), Some(2));
    let (too_late, also) = seconds(&circle(), Some(400));
    assert!(end.distance(same) < 1e-9 && end.distance(also) < 1e-9);
    // 125.7 mm at 50 mm/s, and the ramps.
    assert!((2.5..3.2).contains(&at_once), "{at_once}");
    // All 361 lines wait for their end: 0.72 s.
    assert!(in_time < at_once + 0.8, "{in_time} {at_once}");
    // Each line is a move from rest to rest, and waits for the next: 361 times 0.4 s.
    assert!(too_late > 140.0, "{too_late}");
}

#[test]
fn a_program_that_fails_to_come_is_at_rest_on_its_path_and_goes_on() {
    let mut cnc = sent(false);
    cnc.append(b"G1 X10 F600\nG1 X20\n").unwrap();
    let ticks = settle(&mut cnc);
    let last = ticks[ticks.len() - 1];
    assert_eq!((last.position[Axis::X], last.velocity, cnc.state()), (20.0, 0.0, &State::Running));
    for _ in 0..100_000 {
        assert!(!cnc.tick().moving);
    }
    cnc.append(b"G1 X30\nM2\n").unwrap();
    let ticks = settle(&mut cnc);
    assert_eq!((ticks[ticks.len() - 1].position[Axis::X], cnc.state()), (30.0, &State::Ended));
    cnc.append(b"G1 X40\n").unwrap();
    cnc.cycle_start();
    settle(&mut cnc);
    assert_eq!(cnc.tick().position[Axis::X], 40.0);
}

#[test]
fn an_output_in_step_with_motion_waits_for_a_move_that_comes_later_and_for_no_jog() {
    let mut cnc = sent(false);
    cnc.append(b"G21 G1 X10 F3000\nM62 P0\n").unwrap();
    settle(&mut cnc);
    assert_eq!((cnc.lines_done(), cnc.digital_output(0)), (2, false));
    assert!(cnc.jog_to(Position::xyz(15.0, 0.0, 0.0), 3000.0).unwrap());
    let ticks = settle(&mut cnc);
    assert_eq!((ticks[ticks.len() - 1].position[Axis::X], cnc.digital_output(0)), (15.0, false));
    // Nor for one that is cancelled.
    assert!(cnc.jog_to(Position::xyz(60.0, 0.0, 0.0), 3000.0).unwrap());
    wait(&mut cnc, 300);
    cnc.cancel_jog();
    let ticks = settle(&mut cnc);
    let at = ticks[ticks.len() - 1].position[Axis::X];
    assert!(at > 16.0 && at < 59.0 && !cnc.digital_output(0), "{at}");
    cnc.append(b"G4 P0.1\nM62 P1\n").unwrap();
    settle(&mut cnc);
    assert!(!cnc.digital_output(0) && !cnc.digital_output(1));
    cnc.append(b"G1 X0\n").unwrap();
    while cnc.tick().velocity == 0.0 {}
    assert!(cnc.digital_output(0) && cnc.digital_output(1));
    settle(&mut cnc);
}

#[test]
fn a_line_is_done_once_its_moves_are_given_and_what_waits_is_over() {
    let mut cnc = sent(false);
    cnc.append(b"G1 X10 F600\nG4 P0.5\nG1 X20\n").unwrap();
    cnc.tick();
    assert_eq!(cnc.lines_done(), 1, "the dwell waits for the move of a second");
    let mut ticks = 1;
    while cnc.lines_done() < 2 {
        cnc.tick();
        ticks += 1;
    }
    assert!((1500..1800).contains(&ticks), "{ticks}");
    settle(&mut cnc);
    assert_eq!(cnc.lines_done(), 3);
}

#[test]
fn a_refused_line_is_told_and_the_others_go_on() {
    let mut cnc = sent(true);
    cnc.refuse_blocks(true);
    cnc.append(b"G1 X10 F600\nG1 X5 X6\nG1 X20\n").unwrap();
    settle(&mut cnc);
    let refused: Vec<_> = cnc.refused().iter().map(|alarm| (alarm.fault, alarm.span.line)).collect();
    assert_eq!(refused, [(Fault::RepeatedAddress, 2)]);
    assert_eq!((cnc.tick().position[Axis::X], cnc.lines_done()), (20.0, 3));
}

#[test]
fn a_hold_and_a_reset_act_on_what_was_sent() {
    let mut cnc = sent(true);
    cnc.append(b"G1 X100 F6000\nG1 X200\n").unwrap();
    wait(&mut cnc, 600);
    cnc.feed_hold();
    wait(&mut cnc, 600);
    let held = cnc.tick();
    assert!(held.velocity == 0.0 && (1.0..199.0).contains(&held.position[Axis::X]) && !cnc.awaits_work());
    cnc.reset();
    // What was planned ahead is taken back first.
    wait(&mut cnc, 20);
    assert_eq!(cnc.state(), &State::Reset);
    assert!(!cnc.tick().moving);
}

fn at(x: f64, y: f64) -> Position {
    Position::xyz(x, y, 0.0)
}

#[test]
fn a_jog_goes_in_a_straight_line_and_leaves_the_program_as_it_was() {
    let mut cnc = sent(true);
    cnc.append(b"G91 G1 F100\nG92 X0 Y0\n").unwrap();
    settle(&mut cnc);
    let start = cnc.tick().position;
    assert_eq!(cnc.jog_to(start + at(30.0, 40.0), 3000.0), Ok(true));
    let ticks = settle(&mut cnc);
    for tick in &ticks {
        let way = tick.position - start;
        assert!((way[Axis::X] * 40.0 - way[Axis::Y] * 30.0).abs() < 1e-6);
    }
    let fastest = ticks.iter().map(|tick| tick.velocity).fold(0.0, f64::max);
    assert!((fastest - 50.0).abs() < 1e-6, "{fastest}");
    // G91 and F100 are still in force, from where the jog ended.
    cnc.append(b"X-5\n").unwrap();
    let ticks = settle(&mut cnc);
    assert!((ticks[ticks.len() - 1].position - start - at(25.0, 40.0)).0.iter().all(|d| d.abs() < 1e-9));
}

#[test]
fn jogs_join_are_refused_beyond_limits_and_end_at_once() {
    let mut cnc = sent(true);
    let start = cnc.tick().position;
    for k in 1..=10 {
        assert_eq!(cnc.jog_to(start + at(f64::from(k), 0.0), 3000.0), Ok(true));
    }
    let slow = settle(&mut cnc).len();
    assert!(slow < 500, "ten millimetres at 50 mm/s are one move, not ten: {slow} ms");
    let alarm = cnc.jog_to(at(1e6, 0.0), 1000.0).unwrap_err();
    assert_eq!(alarm.fault, Fault::SoftLimit);
    assert!(cnc.awaits_work() && cnc.events().is_empty(), "nothing of it is begun or noted");
    cnc.jog_to(start + at(100.0, 0.0), 6000.0).unwrap();
    wait(&mut cnc, 600);
    assert!(cnc.is_jogging());
    cnc.cancel_jog();
    let ticks = settle(&mut cnc);
    assert!(ticks.len() < 300 && cnc.tick().position[Axis::X] < 99.0, "{}", ticks.len());
    // A program runs on from there, and no jog while it does.
    cnc.append(b"G90 G1 X0 F1000\n").unwrap();
    wait(&mut cnc, 100);
    assert_eq!(cnc.jog_to(start, 1000.0), Ok(false));
    settle(&mut cnc);
    assert_eq!(cnc.tick().position[Axis::X], 0.0);
}
