//! A run that was broken off is taken up again on the machine: what the control tells, sends and moves first

//! (GSK990MC part 2, 10.1.9).

use crate::common::{HANGS, cnc_with, interpreter, machine};
use ferrocut_controller::restart::{At, Compared, How, Journal, Origin, Restart, Setting};
use ferrocut_controller::{Cnc, State};
use ferrocut_geometry::{Axis, Position};
use ferrocut_interpreter::{Fallible, Interpreter};
use ferrocut_machine::{AlarmId, Fault, MemoryChange};
use ferrocut_program::FileId;
use ferrocut_toolpath::Op;

const SENDS: How = How { sends: true, axis_by_axis: false };
const BY_HAND: How = How { sends: false, axis_by_axis: false };

fn at(line: u32, pass: u64) -> At {
    At::Line { file: FileId(0), line, pass }
}

fn find(interpreter: &Interpreter, place: At) -> Fallible<Restart> {
    Journal::begin(interpreter, Position::ZERO).find(place, interpreter.memory())
}

/// Runs until the axes come to a place, then resets.
fn broken_off(cnc: &mut Cnc, beyond: impl Fn(Position) -> bool) {
    cnc.cycle_start();
    let hangs = (0..HANGS).all(|_| {
        let tick = cnc.tick();
        assert_eq!(cnc.state(), &State::Running);
        !beyond(tick.position)
    });
    assert!(!hangs);
    cnc.reset();
    to_rest(cnc);
    assert_eq!(cnc.state(), &State::Reset);
}

fn to_rest(cnc: &mut Cnc) {
    let hangs = (0..HANGS).all(|_| {
        cnc.tick();
        matches!(cnc.state(), State::Running | State::Resetting)
    });
    assert!(!hangs);
}

/// Takes the interrupted block up again and runs to the end.
fn taken_up(cnc: &mut Cnc) {
    let journal = cnc.journal().unwrap().clone();
    let restart = journal.find(At::Interrupted, cnc.interpreter().memory()).unwrap();
    let lead_in = restart.lead_in(&cnc.present(), &machine(), SENDS).unwrap();
    cnc.restart(restart, lead_in).unwrap();
    cnc.cycle_start();
    to_rest(cnc);
    assert_eq!(cnc.state(), &State::Ended);
}

fn variable(cnc: &Cnc, number: u32) -> Option<f64> {
    cnc.interpreter().memory().variables.get(number)
}

const PART: &str = "O1
G90 G54 G00 X0 Y0 Z-10
T2 M06
S1200 M03 M08
M35
#500=#500+1
G91 G01 X10 F3000
Y10
G90 G00 X0 Y0
M30
";

#[test]
fn the_interrupted_block_is_run_again_from_its_start() {
    let mut cnc = cnc_with(&machine(), PART, "[start]\nz = -5.0");
    // In the midst of Y10, line 8.
    broken_off(&mut cnc, |p| p[Axis::Y] > 4.0);
    let stopped = cnc.present().position;
    assert!(stopped[Axis::Y] > 4.0 && stopped[Axis::X] == 10.0);
    let journal = cnc.journal().unwrap().clone();
    assert_eq!(journal.interrupted().unwrap().span.line, 8);
    let restart = journal.find(At::Interrupted, cnc.interpreter().memory()).unwrap();
    assert_eq!((restart.span.line, restart.origin()), (8, Origin::Kept));
    assert_eq!(restart.position, Position::xyz(10.0, 0.0, -10.0));
    // The tool is still there; what reset ended is sent.
    let present = cnc.present();
    let sent = restart.functions(&present.state);
    assert!(matches!(sent.as_slice(), [Op::Machine(35), Op::Spindle(_), Op::Coolant(true)]), "{sent:?}");
    assert_eq!(restart.differences(&present.state).len(), 2, "spindle and coolant");
    let lead_in = restart.lead_in(&present, &machine(), SENDS).unwrap();
    let moves: Vec<Position> = lead_in.iter().filter_map(|step| step.op.target().copied()).collect();
    assert_eq!(moves, [Position::xyz(10.0, 0.0, -10.0)]);
    taken_up(&mut cnc);
    assert_eq!(cnc.present().position, Position::xyz(0.0, 0.0, -10.0));
    // The part counts once.
    assert_eq!(variable(&cnc, 500), Some(1.0));
    assert_eq!(cnc.report().parts, 1);
}

#[test]
fn from_the_present_state_the_program_writes_again_and_it_is_told() {
    let mut cnc = cnc_with(&machine(), PART, "");
    broken_off(&mut cnc, |p| p[Axis::Y] > 4.0);
    let present = cnc.interpreter();
    let restart = Journal::of_present(present, Position::ZERO).find(at(8, 1), present.memory()).unwrap();
    assert_eq!(restart.origin(), Origin::Present);
    assert_eq!(restart.changes(present.memory()), [MemoryChange::Variable(500, Some(2.0))]);
    // Until it is accepted nothing of it is done.
    assert_eq!(variable(&cnc, 500), Some(1.0));
}

#[test]
fn what_was_changed_by_hand_holds() {
    let program = "O1\nG54 G00 X0 Y0\nG10 L2 P2 X5 Y0 Z0\n#500=#500+1\nG01 X20 F2000\nG43 H1 Z0\nX0\nM30\n";
    let mut cnc = cnc_with(&machine(), program, "[tools.1]\nlength = 30.0");
    broken_off(&mut cnc, |p| p[Axis::X] > 10.0);
    let journal = cnc.journal().unwrap().clone();
    let mut memory = cnc.interpreter().memory().clone();
    memory.tools.get_mut(1).unwrap().length_wear = -0.5;
    memory.work.standard[0][Axis::Y] = 3.0;
    memory.variables.set(500, Some(100.0)).unwrap();
    let restart = journal.find(at(7, 1), &memory).unwrap();
    assert_eq!(restart.position, Position::xyz(20.0, 3.0, 29.5));
    let found = restart.interpreter().memory();
    // By hand 100, then the program counts; what it wrote to G55 the first time is no change by hand.
    assert_eq!(found.variables.get(500), Some(101.0));
    assert_eq!(found.work.standard[1], Position::xyz(5.0, 0.0, 0.0));
}

#[test]
fn what_the_machine_told_is_told_again() {
    // The lag is of the moment: at a desk there is none.
    let program = "O1\nG00 X10\n#510=#5026\n#511=#5021\nG01 X30 F1000\nX[#511+5]\nM30\n";
    let interpreter = interpreter(program, "");
    let mut journal = Journal::begin(&interpreter, Position::ZERO);
    let mut run = interpreter.clone();
    while let Some(step) = run.next() {
        let step = step.unwrap();
        if step.op == Op::Barrier {
            let commanded = run.position();
            let actual = commanded - Position::xyz(0.25, 0.0, 0.0);
            let at_rest = ferrocut_interpreter::AtRest::new(commanded, actual);
            run.came_to_rest(&at_rest);
            journal.answer(step.block, at_rest);
        }
    }
    let told = run.memory().variables.get(510);
    assert_eq!(told, Some(0.25));
    let restart = journal.find(at(6, 1), interpreter.memory()).unwrap();
    assert_eq!(restart.interpreter().memory().variables.get(510), told);
    assert!(restart.warning().is_none());
    // Without the answers the commanded position stands for it, and a warning says so.
    let restart = find(&interpreter, at(6, 1)).unwrap();
    assert_eq!(restart.interpreter().memory().variables.get(510), Some(0.0));
    assert_eq!(restart.warning().unwrap().fault, Fault::RestartUnknown);
}

#[test]
fn axes_move_one_by_one_in_the_order_of_the_parameters() {
    let program = "O1\nG00 X10 Y20 Z-30\nA40\nM30\n";
    let ways = |setup: &str| {
        let from = Position::ZERO;
        let restart = find(&interpreter(program, setup), at(4, 1)).unwrap();
        restart.approach(from, &machine())
    };
    let letters = |setup: &str| {
        let mut at = Position::ZERO;
        let axis = |op: Op| {
            let to = *op.target().unwrap();
            let moved: Vec<char> =
                Axis::ALL.into_iter().filter(|a| at[*a] != to[*a]).map(|a| a.letter()).collect();
            at = to;
            assert_eq!(moved.len(), 1);
            moved[0]
        };
        ways(setup).unwrap().into_iter().map(axis).collect::<String>()
    };
    assert_eq!(letters(""), "XYZA");
    assert_eq!(letters("[parameters]\nP376 = 42130"), "AYXZ");
    // At the speed of dry run, Z as 49#0 says.
    let is_rapid = |op: &Op| matches!(op, Op::Rapid { speed: Some(700.0), straight: true, .. });
    let ops = ways("[parameters]\nP86 = 700").unwrap();
    assert!(ops.iter().all(is_rapid), "{ops:?}");
    let ops = ways("[parameters]\nP86 = 700\n\"NO49.0\" = 1").unwrap();
    assert_eq!(ops.iter().map(is_rapid).collect::<Vec<_>>(), [true, true, false, true]);
    assert!(matches!(&ops[2], Op::Feed { feed: ferrocut_toolpath::Feed::PerMinute(700.0), .. }), "{ops:?}");
    let alarm = ways("[parameters]\nP376 = 11111").unwrap_err();
    assert_eq!((alarm.id, alarm.fault), (AlarmId::Dialect("gsk990mc", 236), Fault::RestartOrder));
}

#[test]
fn no_axis_leaves_its_limits_on_the_way() {
    let machine = machine();
    let far = machine.axis(Axis::X).unwrap().max + 1.0;
    // The program comes back inside before line 4; a restart within it would stand outside.
    let text = format!("O1\nG00 X{far}\nG00 Y5\nG00 X0\nM30\n");
    let restart = find(&interpreter(&text, ""), at(3, 1)).unwrap();
    assert_eq!(restart.approach(Position::ZERO, &machine).unwrap_err().fault, Fault::SoftLimit);
    let restart = find(&interpreter(&text, ""), at(5, 1)).unwrap();
    assert!(restart.approach(Position::ZERO, &machine).is_ok());
    // A forbidden box of stored stroke check 2 in the way of one axis after the other.
    let text = "O1\nG12 X30 Y30 Z10 I10 J10 K-10\nG00 Z50\nX20 Y50\nZ0\nG01 Y40 F500\nM30\n";
    let restart = find(&interpreter(text, "[parameters]\n\"NO11.0\" = 0"), at(7, 1)).unwrap();
    assert_eq!(restart.position, Position::xyz(20.0, 40.0, 0.0));
    assert_eq!(restart.approach(Position::xyz(0.0, 50.0, 0.0), &machine).unwrap().len(), 2);
    for y in [0.0, 20.0] {
        let refused = restart.approach(Position::xyz(0.0, y, 0.0), &machine).unwrap_err();
        assert_eq!(refused.fault, Fault::StoredStroke, "Y{y}");
    }
}

#[test]
fn each_axis_waits_for_cycle_start_where_it_shall() {
    let mut cnc = cnc_with(&machine(), PART, "");
    let restart = find(cnc.interpreter(), at(8, 1)).unwrap();
    let how = How { sends: false, axis_by_axis: true };
    let lead_in = restart.lead_in(&cnc.present(), &machine(), how).unwrap();
    cnc.restart(restart, lead_in).unwrap();
    assert_eq!(cnc.state(), &State::Ready);
    let mut places = Vec::new();
    for _ in 0..2 {
        cnc.cycle_start();
        to_rest(&mut cnc);
        assert!(matches!(cnc.state(), State::Stopped(0)));
        places.push(cnc.present().position);
    }
    assert_eq!(places, [Position::xyz(10.0, 0.0, 0.0), Position::xyz(10.0, 0.0, -10.0)]);
    cnc.cycle_start();
    to_rest(&mut cnc);
    assert_eq!((cnc.state(), cnc.report().parts), (&State::Ended, 1));
}

#[test]
fn a_restart_that_is_broken_off_is_taken_up_again() {
    let mut cnc = cnc_with(&machine(), PART, "");
    broken_off(&mut cnc, |p| p[Axis::Y] > 4.0);
    let journal = cnc.journal().unwrap().clone();
    let restart = journal.find(At::Interrupted, cnc.interpreter().memory()).unwrap();
    let lead_in = restart.lead_in(&cnc.present(), &machine(), SENDS).unwrap();
    cnc.restart(restart, lead_in).unwrap();
    // On the way back to Y0, and once more in the block itself.
    broken_off(&mut cnc, |p| p[Axis::Y] < 3.0);
    let restart = cnc.journal().unwrap().find(At::Interrupted, cnc.interpreter().memory()).unwrap();
    assert_eq!((restart.span.line, restart.position), (8, Position::xyz(10.0, 0.0, -10.0)));
    let lead_in = restart.lead_in(&cnc.present(), &machine(), SENDS).unwrap();
    cnc.restart(restart, lead_in).unwrap();
    broken_off(&mut cnc, |p| p[Axis::Y] > 6.0);
    taken_up(&mut cnc);
    assert_eq!(variable(&cnc, 500), Some(1.0));
    assert_eq!(cnc.present().position, Position::xyz(0.0, 0.0, -10.0));
}

#[test]
fn passes_of_loops_and_subprograms_are_counted() {
    let program =
        "O1\nG90 G00 X0 Y0\n#1=0\nWHILE[#1 LT 5]DO1\n#1=#1+1\nM98 P2 L2\nEND1\nM30\nO2\nG91 G00 X1\nM99\n";
    let interpreter = interpreter(program, "");
    for (pass, x, count) in [(1, 0.0, 1.0), (2, 1.0, 1.0), (3, 2.0, 2.0), (10, 9.0, 5.0)] {
        let restart = find(&interpreter, at(10, pass)).unwrap();
        assert_eq!(restart.position[Axis::X], x, "pass {pass}");
        assert_eq!(restart.interpreter().memory().variables.get(1), Some(count), "pass {pass}");
        assert_eq!(restart.in_force.calls, 1);
    }
    let alarm = find(&interpreter, at(10, 11)).err().unwrap();
    assert_eq!(alarm.fault, Fault::RestartNotReached);
    assert!(alarm.arguments.contains(&("passes", 10.0.into())), "{alarm:?}");
    assert_eq!(find(&interpreter, at(99, 1)).err().unwrap().fault, Fault::RestartBlockMissing);
    assert_eq!(find(&interpreter, At::Interrupted).err().unwrap().fault, Fault::RestartNothing);
}

#[test]
fn a_program_that_repeats_itself_is_searched_to_the_pass_and_no_further() {
    let forever = |text: &str| {
        let mut interpreter = interpreter(text, "");
        interpreter.set_loops_forever(true);
        interpreter
    };
    let repeats = forever("O1\nG90 G00 X0\nG00 X5\nM99\n");
    // At a desk the second pass would be the last.
    let restart = find(&repeats, at(3, 700)).unwrap();
    assert_eq!((restart.pass, restart.position[Axis::X]), (700, 0.0));
    assert!(restart.interpreter().loops_forever());
    let never = forever("O1\nG90 G00 X0\nGOTO 9\nG00 X5\nN9 M99\n");
    assert_eq!(find(&never, at(4, 1)).err().unwrap().fault, Fault::RestartNotReached);
    let once = forever("O1\nG90 G00 X0\nIF[#1 EQ 1]GOTO 9\nG00 X5\n#1=1\nN9 M99\n");
    assert_eq!(find(&once, at(4, 1)).unwrap().position[Axis::X], 0.0);
    assert_eq!(find(&once, at(4, 2)).err().unwrap().fault, Fault::RestartNotReached);
}

#[test]
fn an_alarm_before_the_place_is_raised() {
    let text = "O1\nG00 X1\nG00 X[1/0]\nG00 X3\nM30\n";
    let alarm = find(&interpreter(text, ""), at(4, 1)).err().unwrap();
    assert_eq!((alarm.fault, alarm.span.line), (Fault::DivisionByZero, 3));
    assert!(find(&interpreter(text, ""), at(3, 1)).is_ok());
}

#[test]
fn only_while_the_axes_stand() {
    let mut cnc = cnc_with(&machine(), PART, "");
    let restart = find(cnc.interpreter(), at(8, 1)).unwrap();
    cnc.cycle_start();
    (0..50).for_each(|_| _ = cnc.tick());
    let refused = cnc.restart(restart, Default::default()).unwrap_err();
    assert_eq!((refused.fault, cnc.state()), (Fault::RestartMoving, &State::Running));
}

#[test]
fn m_codes_are_sent_in_the_order_in_which_they_came_last() {
    let text = "O1\nT3 M06\nT4\nM35\nM36\nM35\nG00 X0 Y0 Z5\nM29 S300\nG84 Z-5 R1 F300\nG80\nS900 M04\nG00 X9\nM30\n";
    let interpreter = interpreter(text, "");
    let restart = find(&interpreter, at(12, 1)).unwrap();
    // Rigid tapping ended with its cycle.
    assert_eq!(restart.m_codes().collect::<Vec<_>>(), [Op::Machine(36), Op::Machine(35)]);
    let present = interpreter.program_state();
    let sent = restart.functions(&present);
    let [Op::Select(3), Op::Change(3), Op::Select(4), Op::Machine(36), Op::Machine(35), Op::Spindle(_)] =
        sent.as_slice()
    else {
        panic!("{sent:?}");
    };
    let differences = restart.differences(&present);
    let of = |of: Compared| differences.iter().find(|d| d.of == of).map(|d| (d.program, d.machine));
    assert_eq!(of(Compared::Tool), Some((Setting::Number(4.0), Setting::Number(0.0))));
    assert_eq!(of(Compared::InSpindle), Some((Setting::Number(3.0), Setting::Number(0.0))));
    assert_eq!(of(Compared::Speed), Some((Setting::Number(900.0), Setting::None)));
    // By hand nothing is sent.
    let cnc = cnc_with(&machine(), text, "");
    let lead_in = restart.lead_in(&cnc.present(), &machine(), BY_HAND).unwrap();
    assert!(lead_in.iter().all(|step| step.op.target().is_some()), "{lead_in:?}");
}
