//! Outputs that programs set, in step with motion and at rest: when they change, and what becomes of the path (LinuxCNC

//! M codes: M62 to M65, M67, M68).

use crate::common::{HANGS, in_language, machine};
use ferrocut_controller::api::{Activity, Command};
use ferrocut_controller::restart::{At, How};
use ferrocut_controller::{Cnc, Control, Mode, Outputs, Plant, State, Tick};
use ferrocut_geometry::{Axis, Position};
use ferrocut_interpreter::Interpreter;
use ferrocut_machine::Machine;
use ferrocut_plc::Address;
use ferrocut_program::{FileId, ProgramMemory, Text};
use std::fmt::Write;

/// A servo period, and the outputs at its end.
#[derive(Clone, Debug)]
struct Seen {
    tick: Tick,
    digital: [bool; 4],
    analog: f64,
}

fn cnc(program: &str) -> Cnc {
    Cnc::new(&machine(), in_language("rs274", program))
}

fn tick(cnc: &mut Cnc) -> Seen {
    let tick = cnc.tick();
    Seen { tick, digital: [0, 1, 2, 3].map(|n| cnc.digital_output(n)), analog: cnc.analog_output(0) }
}

/// Starts, and goes on until it is neither running nor being stopped.
fn go_on(cnc: &mut Cnc) -> Vec<Seen> {
    cnc.cycle_start();
    to_stop(cnc)
}

fn to_stop(cnc: &mut Cnc) -> Vec<Seen> {
    let mut seen = Vec::new();
    for _ in 0..HANGS {
        seen.push(tick(cnc));
        if !matches!(cnc.state(), State::Running | State::Resetting) {
            return seen;
        }
    }
    panic!("does not end: {:?} {:?}", cnc.state(), seen.last());
}

fn ended(program: &str) -> Vec<Seen> {
    let mut cnc = cnc(program);
    let seen = go_on(&mut cnc);
    assert_eq!(cnc.state(), &State::Ended, "{program}");
    seen
}

/// Until X is beyond a place.
fn to_beyond(cnc: &mut Cnc, x: f64) {
    let hangs = (0..HANGS).all(|_| tick(cnc).tick.position[Axis::X] < x);
    assert!(!hangs);
}

/// The axes stand where they are.
fn settle(cnc: &mut Cnc) -> Position {
    let mut still = 0;
    let mut at = cnc.tick().position;
    for _ in 0..HANGS {
        let next = cnc.tick().position;
        still = if next == at { still + 1 } else { 0 };
        at = next;
        if still > 60 {
            return at;
        }
    }
    panic!("never at rest");
}

/// Two runs are alike in something, period by period.
fn same<T: PartialEq + std::fmt::Debug>(a: &[Seen], b: &[Seen], what: impl Fn(&Seen) -> T) {
    for (n, (a, b)) in a.iter().zip(b).enumerate() {
        assert_eq!(what(a), what(b), "period {n}");
    }
    assert_eq!(a.len(), b.len());
}

/// The first period in which something is so.
fn first(seen: &[Seen], is_so: impl Fn(&Seen) -> bool) -> usize {
    seen.iter().position(is_so).unwrap()
}

/// How often the axes come to rest before the last period.
fn stops(seen: &[Seen]) -> usize {
    let moving = |seen: &Seen| seen.tick.velocity > 0.0;
    seen.windows(2).filter(|pair| moving(&pair[0]) && !moving(&pair[1])).count()
}

/// Sharp corners, arcs, positioning, an exact stop and short lines, with outputs between them, within a block too.
fn part() -> String {
    let mut program = "G21 G90 G64 P0.05\nM62 P0\nG1 X20 F3000\nM62 P1\nM63 P0\nX40 Y20\nM67 E0 Q12.5\n\
                       G2 X60 Y0 R20\nM63 P1\nG3 X80 Y20 R20\nM62 P2\nG0 X90 Y20\nM63 P2\nX95\nM62 P3 G1 X100\n\
                       G61\nM63 P3\nG1 Y30\nG64 P0.05\n"
        .to_owned();
    for k in 1..400 {
        let t = f64::from(k) * 0.01;
        writeln!(program, "M67 E0 Q{k}\nG1 X{:.4} Y{:.4}", 100.0 - 15.0 * t, 30.0 + 4.0 * (2.0 * t).sin())
            .unwrap();
    }
    program + "M62 P0\nG0 X0 Y0\nM2\n"
}

/// The same without what sets outputs, line by line.
fn without(program: &str) -> String {
    let is_code = |word: &&str| !["M62", "M63", "M67", "E0"].contains(word);
    let mut text = String::new();
    for line in program.lines() {
        let sets = ["M62", "M63", "M67"].iter().any(|code| line.starts_with(code));
        let is_word_of_it = |word: &&str| sets && (word.starts_with('P') || word.starts_with('Q'));
        let words = line.split(' ').filter(|word| is_code(word) && !is_word_of_it(word));
        writeln!(text, "{}", words.collect::<Vec<_>>().join(" ")).unwrap();
    }
    text
}

#[test]
fn the_path_is_that_of_the_program_without_them() {
    let program = part();
    let (with, plain) = (ended(&program), ended(&without(&program)));
    assert!(plain.len() > 3000 && plain.iter().all(|seen| seen.digital == [false; 4] && seen.analog == 0.0));
    same(&with, &plain, |seen| {
        let Tick { position, actual, velocity, span, moving } = seen.tick;
        (position, actual, velocity.to_bits(), span.line, moving)
    });
    // Those that are set at once rest.
    let at_once = program.replace("M62", "M64").replace("M63", "M65").replace("M67", "M68");
    let at_once = ended(&at_once);
    assert!(stops(&at_once) > 390, "{}", stops(&at_once));
}

#[test]
fn nor_do_they_change_a_compensated_path() {
    let program = "G21 G64 P0.05\nG41.1 D4 G1 X10 Y5 F3000\nM62 P0\nX40\nM63 P0\nM67 E0 Q3\nY30\nM62 P1\nG3 X30 Y40 R10\n\
                   G1 X10\nM63 P1\nG40 Y20\nM2\n";
    let (with, plain) = (ended(program), ended(&without(program)));
    same(&with, &plain, |seen| (seen.tick.position, seen.tick.velocity.to_bits(), seen.tick.span.line));
    // Each is there from the first move behind it.
    for (line, output) in [(4, true), (7, false), (9, false)] {
        let begins = first(&with, |seen| seen.tick.span.line == line);
        assert_eq!(with[begins].digital[0], output, "line {line}");
        assert_eq!(with[begins - 1].digital[0], !output && line == 7, "line {line}");
    }
    assert_eq!(with[first(&with, |seen| seen.analog == 3.0)].tick.span.line, 7);
    assert_eq!(with[first(&with, |seen| seen.digital[1])].tick.span.line, 9);
}

#[test]
fn each_changes_as_the_next_move_begins() {
    let program = part();
    // What each line leaves, once a move from it or from one behind it has begun.
    let mut states = vec![([false; 4], 0.0)];
    for line in program.lines() {
        let (mut digital, mut analog) = *states.last().unwrap();
        let words: Vec<&str> = line.split(' ').collect();
        if let ["M62" | "M63", port, ..] = words[..] {
            digital[port[1..].parse::<usize>().unwrap()] = words[0] == "M62";
        }
        if let ["M67", "E0", value] = words[..] {
            analog = value[1..].parse().unwrap();
        }
        states.push((digital, analog));
    }
    let seen = ended(&program);
    let runs: Vec<&Seen> = seen.iter().filter(|seen| seen.tick.moving && seen.tick.velocity > 0.0).collect();
    assert!(runs.len() > 3000);
    let mut lines = 0;
    for pair in runs.windows(2) {
        let line = pair[1].tick.span.line as usize;
        lines += usize::from(pair[0].tick.span.line as usize != line);
        assert_eq!((pair[1].digital, pair[1].analog), states[line], "line {line}, {:?}", pair[1].tick);
    }
    assert!(lines > 390, "{lines}");
    // The last one stays.
    assert!(seen.last().unwrap().digital[0]);
}

#[test]
fn at_a_corner_it_changes_in_the_middle_of_the_round() {
    let seen = ended("G21 G64 P0.5\nG1 X40 F6000\nM62 P1\nY30\nM2\n");
    let change = first(&seen, |seen| seen.digital[1]);
    let (before, behind) = (seen[change - 1].tick, seen[change].tick);
    // No rest, and round the corner.
    assert!(before.velocity > 20.0 && behind.velocity > 20.0, "{before:?} {behind:?}");
    // The bisector is where X is as far from the corner as Y.
    let past = |tick: Tick| tick.position[Axis::Y] - (40.0 - tick.position[Axis::X]);
    let way = before.position.distance(behind.position);
    assert!(past(before) < way && past(behind) > -way, "{} {} {way}", past(before), past(behind));
    assert!(past(behind) - past(before) > 0.0);
}

#[test]
fn among_short_lines_each_changes_at_its_place() {
    let (step, moves) = (0.1, 600);
    let mut program = "G21 G64 P0.01\nG1 F2400\n".to_owned();
    for k in 1..=moves {
        writeln!(program, "M67 E0 Q{k}\nX{:.4}", f64::from(k) * step).unwrap();
    }
    let seen = ended(&(program + "M2\n"));
    assert_eq!((stops(&seen), seen.last().unwrap().analog), (1, f64::from(moves)));
    for pair in seen.windows(2) {
        let (x, way) = (pair[1].tick.position[Axis::X], pair[1].tick.velocity * 0.001 + 1e-9);
        // Move k goes from (k − 1) steps to k.
        let from = (pair[1].analog - 1.0) * step;
        assert!(pair[1].analog == 0.0 || x > from - 1e-6, "early: {} at {x}", pair[1].analog);
        let is_late = x > from + step + way;
        assert!(!is_late, "late: {} at {x}", pair[1].analog);
    }
}

#[test]
fn behind_an_exact_stop_it_does_not_change_before_the_axes_move_on() {
    let seen = ended("G21 G61.1\nG1 X10 F3000\nM62 P0\nX20\nM2\n");
    let change = first(&seen, |seen| seen.digital[0]);
    assert!(seen[change].tick.position[Axis::X] > 10.0);
    assert_eq!(seen[change - 1].tick.position[Axis::X], 10.0);
}

#[test]
fn one_without_a_move_behind_it_never_changes() {
    for end in ["M2\n", "%\n", "G1 X10\nM2\n", "G4 P0.1\nM30\n"] {
        let mut cnc = cnc(&format!("%\nG21 G64\nG1 X10 F3000\nM62 P0\nM67 E0 Q5\n{end}"));
        let seen = go_on(&mut cnc);
        assert!(seen.iter().all(|seen| !seen.digital[0] && seen.analog == 0.0), "{end:?}");
        // Nor with the first move of another program, or of the same again.
        assert!(cnc.rewind(None).unwrap());
        assert!(go_on(&mut cnc).iter().all(|seen| !seen.digital[0] && seen.analog == 0.0));
        let text = Text::from_bytes(b"G1 X20 F1000\nM2\n".to_vec()).unwrap();
        let next = ProgramMemory::new("next.nc", text, cnc.interpreter().dialect().syntax);
        cnc.load_programs(next).unwrap();
        let seen = go_on(&mut cnc);
        assert_eq!(seen.last().unwrap().tick.position[Axis::X], 20.0);
        assert!(seen.iter().all(|seen| !seen.digital[0] && seen.analog == 0.0));
    }
}

#[test]
fn a_move_that_goes_nowhere_and_a_dwell_are_none() {
    let seen = ended("G21 G64\nG1 X10 F3000\nM62 P0\nX10\nG4 P0.2\nX10\nX20\nM2\n");
    let change = first(&seen, |seen| seen.digital[0]);
    assert!(seen[change].tick.position[Axis::X] > 10.0 && seen[change].tick.position[Axis::X] < 11.0);
    assert_eq!(seen[change - 1].tick.position[Axis::X], 10.0);
}

#[test]
fn a_reset_before_the_move_begins_leaves_it_as_it_was() {
    let mut cnc = cnc("G21 G64\nM64 P1\nG1 X50 F3000\nM62 P0\nM63 P1\nX100\nM2\n");
    cnc.cycle_start();
    to_beyond(&mut cnc, 25.0);
    cnc.reset();
    let seen = to_stop(&mut cnc);
    assert_eq!(cnc.state(), &State::Reset);
    assert!(seen.iter().all(|seen| seen.digital == [false, true, false, false]));
    // While it brakes it may pass into the move: it is given up all the same.
    assert!(cnc.rewind(None).unwrap());
    cnc.cycle_start();
    to_beyond(&mut cnc, 49.9);
    cnc.reset();
    let seen = to_stop(&mut cnc);
    assert!(seen.last().unwrap().tick.position[Axis::X] > 50.0);
    assert!(seen.iter().all(|seen| !seen.digital[0] && seen.digital[1]));
    // Nor do they change in what runs next.
    let text = Text::from_bytes(b"G1 X0 F3000\nM2\n".to_vec()).unwrap();
    let next = ProgramMemory::new("next.nc", text, cnc.interpreter().dialect().syntax);
    cnc.load_programs(next).unwrap();
    assert!(go_on(&mut cnc).iter().all(|seen| !seen.digital[0] && seen.digital[1]));
}

#[test]
fn an_alarm_before_the_move_leaves_it_as_it_was() {
    let mut cnc = cnc("G21 G64\nG1 X20 F3000\nM62 P0\nX9000\nM2\n");
    let seen = go_on(&mut cnc);
    assert!(matches!(cnc.state(), State::Alarmed(_)), "{:?}", cnc.state());
    assert!(seen.iter().all(|seen| !seen.digital[0]));
    cnc.reset();
    assert!(to_stop(&mut cnc).iter().all(|seen| !seen.digital[0]));
}

#[test]
fn held_it_waits_with_its_move() {
    let mut cnc = cnc("G21 G64\nG1 X50 F3000\nM62 P0\nX100\nM2\n");
    cnc.cycle_start();
    to_beyond(&mut cnc, 30.0);
    cnc.feed_hold();
    let held = settle(&mut cnc);
    assert!(held[Axis::X] < 50.0 && !cnc.digital_output(0));
    cnc.cycle_start();
    let seen = to_stop(&mut cnc);
    let change = first(&seen, |seen| seen.digital[0]);
    let at = seen[change].tick.position[Axis::X];
    assert!((50.0..50.1).contains(&at) && seen[change].tick.velocity > 40.0, "{at}");
    assert_eq!(stops(&seen), 1);
}

#[test]
fn back_along_the_path_it_stays_and_is_not_set_twice() {
    let mut cnc = cnc("G21 G64\nG1 X30 F3000\nM62 P0\nX60\nM63 P0\nX100\nM62 P1\nX120\nM2\n");
    cnc.cycle_start();
    to_beyond(&mut cnc, 80.0);
    cnc.feed_hold();
    settle(&mut cnc);
    assert!(!cnc.digital_output(0) && cnc.retrace());
    for _ in 0..HANGS {
        let seen = tick(&mut cnc);
        assert_eq!(seen.digital, [false; 4]);
        if seen.tick.position[Axis::X] < 10.0 {
            break;
        }
    }
    // Over both of them and forward again.
    assert!(settle(&mut cnc)[Axis::X] < 10.0);
    cnc.cycle_start();
    let seen = to_stop(&mut cnc);
    assert_eq!(cnc.state(), &State::Ended);
    assert!(seen.iter().all(|seen| !seen.digital[0]));
    let change = first(&seen, |seen| seen.digital[1]);
    assert!((100.0..100.1).contains(&seen[change].tick.position[Axis::X]));
}

#[test]
fn with_single_block_its_block_is_one_to_stop_behind() {
    let mut cnc = cnc("G21 G64\nM62 P0\nG1 X10 F3000\nM63 P0\nM62 P1\nG1 X20\nM62 P2\nM2\n");
    cnc.set_single_block(true);
    let mut lines = Vec::new();
    for _ in 0..20 {
        let seen = go_on(&mut cnc);
        let last = seen.last().unwrap();
        lines.push((last.tick.span.line, last.digital));
        if cnc.state() == &State::Ended {
            break;
        }
        assert_eq!(cnc.state(), &State::BlockEnd);
    }
    let (off, on) = ([false; 4], [false, true, false, false]);
    let first_on = [true, false, false, false];
    assert_eq!(lines, [(2, off), (3, first_on), (4, first_on), (5, first_on), (6, on), (7, on), (8, on)]);
    // Switched on while the path runs, it stops there too, and the output waits.
    cnc.set_single_block(false);
    assert!(cnc.rewind(None).unwrap());
    cnc.cycle_start();
    to_beyond(&mut cnc, 4.0);
    cnc.set_single_block(true);
    let seen = to_stop(&mut cnc);
    let last = seen.last().unwrap();
    assert_eq!((cnc.state(), last.tick.position[Axis::X]), (&State::BlockEnd, 10.0));
    assert_eq!(last.digital, [true, true, false, false]);
    cnc.set_single_block(false);
    let seen = go_on(&mut cnc);
    assert_eq!((cnc.state(), seen.last().unwrap().digital), (&State::Ended, on));
}

/// The restart at a line, run to its end.
fn taken_up(program: &str, line: u32) -> Vec<Seen> {
    let mut cnc = cnc(program);
    let journal = ferrocut_controller::restart::Journal::begin(cnc.interpreter(), Position::ZERO);
    let at = At::Line { file: FileId(0), line, pass: 1 };
    let restart = journal.find(at, cnc.interpreter().memory()).unwrap();
    let how = How { sends: true, axis_by_axis: false };
    let lead_in = restart.lead_in(&cnc.present(), &machine(), how).unwrap();
    cnc.restart(restart, lead_in).unwrap();
    let seen = go_on(&mut cnc);
    assert_eq!(cnc.state(), &State::Ended);
    seen
}

#[test]
fn a_restart_has_them_as_a_full_run() {
    let program =
        "G21 G64\nG1 X10 F3000\nM62 P0\nM67 E0 Q3\nX20\nM63 P0\nM62 P1\nM62 P2\nM63 P2\nX30\nM62 P3\nM2\n";
    let full = ended(program);
    // At the block of the output, between it and its move, at the move, and behind that.
    for (line, before) in [
        (3, ([false; 4], 0.0)),
        (4, ([false; 4], 0.0)),
        (5, ([false; 4], 0.0)),
        (6, ([true, false, false, false], 3.0)),
        (9, ([true, false, false, false], 3.0)),
        (10, ([true, false, false, false], 3.0)),
    ] {
        let seen = taken_up(program, line);
        // The way there is a move of the restart and not of the program.
        let place = if line <= 5 { 10.0 } else { 20.0 };
        let there = first(&seen, |seen| seen.tick.position[Axis::X] == place);
        assert_eq!((seen[there].digital, seen[there].analog), before, "line {line}");
        assert!(seen[..there].iter().filter(|seen| seen.tick.moving).all(|seen| seen.digital == before.0));
        // From there on the same at the same place.
        for seen in &seen[there..] {
            let x = seen.tick.position[Axis::X];
            let same = full
                .iter()
                .find(|seen| seen.tick.position[Axis::X] > x + 0.1)
                .unwrap_or(full.last().unwrap());
            let near = (x - 20.0).abs() < 0.2 || (x - 10.0).abs() < 0.2;
            assert!(near || (seen.digital, seen.analog) == (same.digital, same.analog), "line {line}, {x}");
        }
    }
    // One that has no move behind it is not set by one either.
    let seen = taken_up(program, 12);
    assert!(seen.iter().all(|seen| !seen.digital[3]));
    assert_eq!(seen.last().unwrap().digital, [false, true, false, false]);
}

#[test]
fn under_auxiliary_lock_none_changes_and_under_machine_lock_all_do() {
    let program = "G21 G64\nM64 P0\nG1 X10 F3000\nM62 P1\nX20\nM2\n";
    let mut locked = cnc(program);
    locked.set_auxiliary_lock(true);
    assert!(go_on(&mut locked).iter().all(|seen| seen.digital == [false; 4]));
    let mut locked = cnc(program);
    assert!(locked.set_machine_lock(true));
    let seen = go_on(&mut locked);
    assert_eq!((locked.state(), seen.last().unwrap().digital), (&State::Ended, [true, true, false, false]));
}

#[test]
fn nor_does_one_change_with_a_ladder_under_auxiliary_lock() {
    for is_locked in [true, false] {
        let mut cnc = cnc("G21 G64\nM64 P1\nM62 P2\nG1 X10 F3000\nM2\n");
        cnc.connect_ladder(&machine());
        cnc.cycle_start();
        for _ in 0..2000 {
            let mut heard = Control::free_inputs(Mode::Auto);
            heard.auxiliary_lock = is_locked;
            cnc.hear(&heard);
            cnc.tick();
        }
        assert_eq!([1, 2].map(|port| cnc.digital_output(port)), [!is_locked; 2]);
    }
}

#[test]
fn of_many_before_one_move_the_last_counts() {
    let mut program = "G21 G64\nG1 X10 F3000\n".to_owned();
    for k in 0..20_000 {
        // Moves to where the axes are change nothing of it.
        writeln!(program, "M67 E0 Q{k}\nX10").unwrap();
    }
    let seen = ended(&(program + "X20\nM2\n"));
    assert_eq!(seen.last().unwrap().tick.position[Axis::X], 20.0);
    let mut values: Vec<f64> = seen.iter().map(|seen| seen.analog).collect();
    values.dedup();
    assert_eq!(values, [0.0, 19_999.0]);
    assert_eq!(stops(&seen), 1);
}

#[test]
fn more_than_are_kept_come_in_time_too() {
    // All of them before each of some short moves: more than there is room for.
    let mut program = "G21 G64 P0.01\nG1 F600\n".to_owned();
    let moves = 150;
    for k in 1..=moves {
        for port in 0..64 {
            writeln!(program, "M6{} P{port}\nM67 E{port} Q{k}", 2 + (k + port) % 2).unwrap();
        }
        writeln!(program, "X{:.3}", 0.05 * f64::from(k)).unwrap();
    }
    let seen = ended(&(program + "M2\n"));
    let mut values: Vec<f64> = seen.iter().map(|seen| seen.analog).collect();
    values.dedup();
    assert_eq!(values, (1..=moves).map(f64::from).collect::<Vec<_>>());
    for seen in &seen {
        let x = seen.tick.position[Axis::X];
        assert!(seen.analog == 0.0 || x > 0.05 * (seen.analog - 1.0) - 1e-6, "{x}: {}", seen.analog);
        assert!(seen.analog == 0.0 || seen.digital[0] == (seen.analog % 2.0 == 0.0), "{}", seen.analog);
    }
}

#[test]
fn planned_and_read_beside_they_change_in_the_same_period() {
    let program = part();
    let there = ended(&program);
    let mut cnc = cnc(&program);
    cnc.work_beside().unwrap();
    cnc.cycle_start();
    let mut here = Vec::new();
    for _ in 0..HANGS {
        cnc.await_beside();
        here.push(tick(&mut cnc));
        if cnc.state() != &State::Running {
            break;
        }
    }
    assert_eq!((cnc.state(), cnc.late_plans()), (&State::Ended, 0));
    // Where nothing moves it may be some periods longer.
    let state = |seen: &Seen| (seen.tick.position, seen.digital, seen.analog);
    let [here, there] = [here, there].map(|seen| {
        let mut seen: Vec<Seen> = seen.into_iter().skip_while(|seen| seen.tick.velocity == 0.0).collect();
        seen.dedup_by(|next, seen| state(next) == state(seen));
        seen
    });
    same(&here, &there, state);
}

#[test]
fn the_ladder_has_the_digital_ones() {
    let mut cnc = cnc("G21 G64\nM64 P15\nM64 P16\nM68 E63 Q2.5\nG1 X10 F3000\nM62 P3\nX20\nM2\n");
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
    assert_eq!(words, [(0x8000, false), (0x8008, true)]);
    assert_eq!((cnc.digital_output(16), cnc.digital_output(17)), (true, false));
    assert_eq!((cnc.analog_output(63), cnc.analog_output(64)), (2.5, 0.0));
}

/// Periods of a run of the whole control on the simulated machine: places, speed along the path mm/min, and UO3.
fn on_the_machine(program: &str) -> Vec<([f64; 2], f64, bool)> {
    let machine = Machine { dialect: "rs274".into(), ..Machine::demo_mill() };
    let mut mill =
        crate::common::panel::Mill::of(&machine, Plant::new(&machine, Position::ZERO, Position::ZERO), None);
    mill.home();
    mill.press("KEY_AUTO");
    mill.say(Command::Store { program: "part.ngc".into(), text: program.into() });
    mill.say(Command::Select { program: "part.ngc".into() });
    mill.key("KEY_START", true);
    mill.say(Command::Key { key: "KEY_START".into(), down: false });
    let uo = Address::parse("F54.3").unwrap();
    let (mut seen, mut has_begun) = (Vec::new(), false);
    for _ in 0..HANGS {
        let status = mill.wait(1);
        has_begun |= status.activity == Activity::Running;
        if has_begun && status.activity != Activity::Running {
            assert_eq!(status.activity, Activity::Idle, "{:?}", mill.events);
            return seen;
        }
        let at = ['X', 'Y'].map(|axis| status.position.machine[&axis]);
        let is_on = mill.control.plc_mut().unwrap().memory().bit(uo);
        seen.push((at, status.feed.actual, is_on));
    }
    panic!("does not end");
}

#[test]
fn on_the_simulated_machine_the_ladder_sees_it_at_the_corner() {
    let program = "G21 G91 G64 P0.2\nG1 X-30 F3000\nM62 P3\nY-20\nM63 P3\nX-10\nM2\n";
    let (with, plain) = (on_the_machine(program), on_the_machine(&without(program)));
    let moving = |seen: &[([f64; 2], f64, bool)]| seen.iter().filter(|seen| seen.1 > 0.0).count();
    assert_eq!((moving(&with), with.len()), (moving(&plain), plain.len()));
    let start = with[0].0;
    let changes: Vec<_> = with.windows(2).filter(|pair| pair[0].2 != pair[1].2).map(|pair| pair[1]).collect();
    assert_eq!(changes.iter().map(|change| change.2).collect::<Vec<_>>(), [true, false]);
    for ((at, feed, _), corner) in changes.into_iter().zip([[-30.0, 0.0], [-30.0, -20.0]]) {
        let off = [0, 1].map(|k| at[k] - start[k] - corner[k]);
        assert!(off[0].hypot(off[1]) < 0.5 && feed > 100.0, "{off:?} at {feed} mm/min");
    }
    assert!(plain.iter().all(|seen| !seen.2));
}

/// A thread that the spindle leads is a move too.
#[test]
fn it_changes_as_a_thread_begins() {
    let program = "G21 G90 S600 M3\nG0 Z5\nM62 P0\nG33.1 Z-5 K1\nM62 P1\nG0 Z10\nM2\n";
    let seen = ended(program);
    let change = first(&seen, |seen| seen.digital[0]);
    let moves = first(&seen[change..], |seen| seen.tick.position[Axis::Z] < 5.0);
    assert!(seen[change].tick.position[Axis::Z] <= 5.0 && moves < 20, "{moves}: {:?}", seen[change].tick);
    assert!(first(&seen, |seen| seen.digital[1]) > change + moves);
}

#[test]
fn an_interpreter_gives_them_before_their_move() {
    let interpreter: Interpreter =
        in_language("rs274", "M62 P1\nM63 P2\nM67 E3 Q4\nM64 P5\nM65 P6\nM68 E7\nM2\n");
    let outputs: Vec<String> = interpreter
        .filter_map(|step| match step.unwrap().op {
            ferrocut_toolpath::Op::Output { port, value, with_next_move } => {
                Some(format!("{port} {value} {with_next_move}"))
            }
            _ => None,
        })
        .collect();
    assert_eq!(
        outputs,
        [
            "digital 1 1 true",
            "digital 2 0 true",
            "analog 3 4 true",
            "digital 5 1 false",
            "digital 6 0 false",
            "analog 7 -1 false"
        ]
    );
}
