//! Blocks that take long, on drives that need a setpoint each period: they are read beside, and no period waits for them.

use crate::common::{HANGS, ended, interpreter, machine};
use ferrocut_controller::drives::Drives;
use ferrocut_controller::restart::{At, How};
use ferrocut_controller::{Cnc, State, Tick};
use ferrocut_geometry::Position;
use ferrocut_interpreter::{Interpreter, Options, dialects};
use ferrocut_machine::{Memory, MemoryChange};
use ferrocut_program::{ProgramId, ProgramMemory, Source, Text};
use std::sync::mpsc::{Receiver, Sender, channel};
use std::time::{Duration, Instant};

/// Whatever else the computer does, what is waited for comes within this.
const DEADLINE: Duration = Duration::from_secs(120);

/// Ideal drives that need a setpoint each period.
struct Timed;

impl Drives for Timed {
    fn exchange(&mut self, commanded: &Position) -> Position {
        *commanded
    }

    fn keeps_time(&self) -> bool {
        true
    }
}

/// A subprogram that is found once the test lets it: a block as long as that.
#[derive(Debug)]
struct Slow {
    asked: Sender<()>,
    found: Receiver<()>,
}

impl Source for Slow {
    fn find(&mut self, _: &ProgramId) -> Option<(String, Text)> {
        let _ = self.asked.send(());
        // It is found too where nobody keeps it back any more.
        let _ = self.found.recv();
        let text = Text::from_bytes(b"O1000\nG1 Y5 F3000\nM99\n".to_vec()).ok()?;
        Some(("sub".to_owned(), text))
    }
}

/// A run whose interpreter is within the block that calls a subprogram, with a long way before it.
struct Away {
    // Goes first, so that a test that fails does not wait for it.
    let_go: Sender<()>,
    cnc: Cnc,
}

const PROGRAM: &str = "G1 X50 F1500\nG0 Z5\nM98 P1000\nG1 X40 F3000\nM30\n";

impl Away {
    fn new() -> Away {
        let (asked, is_asked) = channel();
        let (let_go, found) = channel();
        let dialect = &dialects::gsk990mc::DIALECT;
        let text = Text::from_bytes(PROGRAM.as_bytes().to_vec()).unwrap();
        let mut programs = ProgramMemory::new("test.nc", text, dialect.syntax);
        programs.set_source(Box::new(Slow { asked, found }));
        let interpreter = Interpreter::new(dialect, programs, Memory::new(dialect.name), Options::default());
        let mut cnc = Cnc::with_drives(&machine(), interpreter, Box::new(Timed));
        cnc.keep_time().unwrap();
        cnc.cycle_start();
        let mut away = Away { let_go, cnc };
        away.tick_until("the subprogram is asked for", |_, _| is_asked.try_recv().is_ok());
        assert!(away.cnc.is_reading());
        away
    }

    /// Periods at about their pace, until something is so.
    fn tick_until(&mut self, what: &str, mut is_so: impl FnMut(&Cnc, &Tick) -> bool) -> Tick {
        let began = Instant::now();
        loop {
            let tick = self.cnc.tick();
            self.cnc.prepare();
            if is_so(&self.cnc, &tick) {
                return tick;
            }
            assert!(began.elapsed() < DEADLINE, "{what}: {:?} {tick:?}", self.cnc.state());
            std::thread::sleep(Duration::from_millis(1));
        }
    }

    /// Periods in which the axes moved while the block is read.
    fn move_on(&mut self, periods: usize) {
        let (mut last, mut moved) = (None, 0);
        self.tick_until("the axes move", |cnc, tick| {
            assert!(cnc.is_reading());
            moved += usize::from(last.is_some_and(|last| last != tick.position));
            last = Some(tick.position);
            moved >= periods
        });
    }
}

#[test]
fn setpoints_go_on_while_a_block_takes_long() {
    let mut away = Away::new();
    away.move_on(100);
    // Whoever looks at the interpreter does not wait for it either.
    assert_eq!(away.cnc.interpreter().position().0[1], 0.0);
    assert_eq!(away.cnc.state(), &State::Running);
    away.let_go.send(()).unwrap();
    let end = away.tick_until("it ends", |cnc, _| cnc.state() == &State::Ended);
    assert_eq!(end.position.0[..3], [40.0, 5.0, 5.0]);
    assert_eq!((away.cnc.report().parts, away.cnc.report().moves), (1, 4));
}

#[test]
fn axes_that_come_to_the_end_of_what_was_read_stand_there_and_go_on() {
    let mut away = Away::new();
    // How positioning ends is not known before what follows.
    let at = |tick: &Tick| (tick.position.0[0], tick.position.0[2]);
    away.tick_until("the way before it is run", |_, tick| at(tick) == (50.0, 0.0));
    for _ in 0..50 {
        assert_eq!(at(&away.cnc.tick()), (50.0, 0.0));
        assert!(away.cnc.is_reading() && away.cnc.state() == &State::Running);
    }
    away.let_go.send(()).unwrap();
    away.tick_until("it ends", |cnc, tick| cnc.state() == &State::Ended && tick.position.0[0] == 40.0);
}

#[test]
fn a_reset_stops_the_axes_at_once_and_forgets_the_program_when_the_block_is_read() {
    let mut away = Away::new();
    away.move_on(20);
    away.cnc.reset();
    let rest = away.tick_until("the axes stand", |_, tick| !tick.moving).position;
    assert!(rest.0[0] < 50.0);
    for _ in 0..100 {
        assert_eq!(away.cnc.tick().position, rest);
        assert_eq!((away.cnc.state(), away.cnc.is_reading()), (&State::Resetting, true));
    }
    away.let_go.send(()).unwrap();
    away.tick_until("it is reset", |cnc, _| cnc.state() == &State::Reset);
    (0..50).for_each(|_| assert_eq!(away.cnc.tick().position, rest));
    assert_eq!(away.cnc.interpreter().position(), rest);
    // The same program from its first block, with nothing left of the run before.
    drop(std::mem::replace(&mut away.let_go, channel().0));
    assert!(away.cnc.rewind(None).unwrap());
    away.cnc.cycle_start();
    let end = away.tick_until("it ends", |cnc, _| cnc.state() == &State::Ended);
    assert_eq!((end.position.0[..3].to_vec(), away.cnc.report().parts), (vec![40.0, 5.0, 5.0], 1));
}

#[test]
fn a_hold_and_an_emergency_stop_act_while_a_block_takes_long() {
    let mut away = Away::new();
    away.move_on(20);
    away.cnc.feed_hold();
    let held = away.tick_until("the axes stand", |_, tick| !tick.moving).position;
    assert!(away.cnc.is_reading() && held.0[0] < 50.0);
    away.cnc.cycle_start();
    away.move_on(20);
    away.cnc.emergency_stop();
    away.tick_until("the axes stand", |_, tick| !tick.moving);
    assert!(away.cnc.is_reading());
    away.let_go.send(()).unwrap();
    away.tick_until("it is reset", |cnc, _| cnc.state() == &State::Reset);
}

#[test]
fn a_program_that_is_sent_is_read_in_the_period_and_takes_more_at_any_time() {
    let dialect = &dialects::gsk990mc::DIALECT;
    let programs = ProgramMemory::new("sent", Text::sent(), dialect.syntax);
    let options = Options { open_end: true, ..Options::default() };
    let interpreter = Interpreter::new(dialect, programs, Memory::new(dialect.name), options);
    let mut away =
        Away { let_go: channel().0, cnc: Cnc::with_drives(&machine(), interpreter, Box::new(Timed)) };
    away.cnc.keep_time().unwrap();
    for round in 0..3 {
        for x in [5.0, 8.0, 2.0] {
            away.cnc.append(format!("G1 X{x} F6000\n").as_bytes()).unwrap();
            if away.cnc.state() != &State::Running {
                away.cnc.cycle_start();
            }
            away.tick_until("it is run", |cnc, tick| {
                assert!(!cnc.is_reading());
                tick.position.0[0] == x && cnc.awaits_work()
            });
        }
        // A reset of one leaves the next as free.
        away.cnc.append(b"G1 X100 F600\n").unwrap();
        away.tick_until("it moves", |_, tick| tick.position.0[0] > 2.1);
        away.cnc.reset();
        away.tick_until("it is reset", |cnc, _| cnc.state() == &State::Reset);
        assert!(away.cnc.append(b"\n").is_ok(), "{round}");
    }
    away.cnc.end_text();
}

/// Values of the moment, jumps, M codes and a thread, each of which the interpreter waits for.
const ASKING: &str = "S600 M3\n#1=0\nWHILE[#1 LT 20]DO1\nG1 X[#1] Y[#5022+1] F4000\n#1=#1+1\nEND1\nG4 X0.05\n\
                      M8\nG0 X0 Y0 Z5\nM29 S300\nG84 X5 Y5 Z-5 R2 F300\nG80\nG92 X0 Y0\nG1 X#5021 Y-3 F2000\nM9\nM30\n";

/// Its setpoints on drives that keep time, in single block where that is so.
fn beside(program: &str, single: bool) -> (Cnc, Vec<Position>) {
    let mut cnc = Cnc::with_drives(&machine(), interpreter(program, ""), Box::new(Timed));
    cnc.keep_time().unwrap();
    let ends = run(&mut cnc, single);
    (cnc, ends)
}

fn run(cnc: &mut Cnc, single: bool) -> Vec<Position> {
    cnc.set_single_block(single);
    let mut at = vec![cnc.tick().position];
    cnc.cycle_start();
    for _ in 0..HANGS {
        cnc.await_beside();
        at.push(cnc.tick().position);
        match cnc.state() {
            State::Running => {}
            State::BlockEnd => cnc.cycle_start(),
            state => {
                assert_eq!(state, &State::Ended);
                at.dedup();
                return at;
            }
        }
    }
    panic!("does not end: {:?}", cnc.state());
}

#[test]
fn what_waits_for_the_machine_gets_the_same_answers() {
    let (plain, _) = ended(&machine(), ASKING);
    for single in [false, true] {
        let mut here = crate::common::cnc(&machine(), ASKING);
        let there = run(&mut here, single);
        let (cnc, at) = beside(ASKING, single);
        assert_eq!(at, there, "single: {single}");
        assert_eq!((cnc.report().moves, cnc.report().parts), (plain.report().moves, 1));
    }
}

/// What a run is taken up from is begun beside, before its first block is read: a reset finds it whenever it comes, and a
/// value that is changed by hand right behind the start counts from there.
#[test]
fn a_run_that_is_broken_off_at_once_is_taken_up_from_its_start() {
    let program = "#500=#500+1\nG1 X50 F3000\n#501=#500\nM30\n";
    for (periods, by_hand) in (0..8).map(|periods| (periods, periods % 2 == 1)) {
        let interpreter = interpreter(program, "[variables]\n\"#500\" = 3.0\n");
        let mut cnc = Cnc::with_drives(&machine(), interpreter, Box::new(Timed));
        cnc.keep_time().unwrap();
        cnc.tick();
        cnc.cycle_start();
        (0..periods).for_each(|_| _ = cnc.tick());
        if by_hand {
            cnc.change_memory(MemoryChange::Variable(502, Some(7.0)));
        }
        cnc.reset();
        let begun = Instant::now();
        while cnc.state() != &State::Reset {
            cnc.tick();
            assert!(begun.elapsed() < DEADLINE);
        }
        let journal = cnc.journal().unwrap().clone();
        assert!(journal.interrupted().is_some(), "{periods}");
        let restart = journal.find(At::Interrupted, cnc.interpreter().memory()).unwrap();
        let lead_in = restart.lead_in(&cnc.present(), &machine(), How { sends: true, axis_by_axis: false });
        cnc.restart(restart, lead_in.unwrap()).unwrap();
        cnc.cycle_start();
        while cnc.state() != &State::Ended {
            cnc.await_beside();
            cnc.tick();
            assert!(begun.elapsed() < DEADLINE);
        }
        let variables = &cnc.interpreter().memory().variables;
        let found = [500, 501, 502].map(|number| variables.get(number));
        assert_eq!(found, [Some(4.0), Some(4.0), by_hand.then_some(7.0)], "{periods}");
        assert_eq!(cnc.interpreter().position(), Position::xyz(50.0, 0.0, 0.0), "{periods}");
    }
}
