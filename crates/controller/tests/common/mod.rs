//! A control with a program, run tick by tick and judged by what its axes did.
#![allow(dead_code, missing_docs, clippy::unwrap_used, clippy::panic)]

pub mod mill;
pub mod panel;
pub mod parts;
pub mod random;
pub mod shop;

use ferrocut_controller::{Activity, Cnc, Event, State, Tick};
use ferrocut_geometry::{AXES, Axis, Position};
use ferrocut_interpreter::{Interpreter, Options, dialects};
use ferrocut_machine::{Alarm, Machine, Memory, Setup};
use ferrocut_program::{ProgramMemory, Text};

/// The machine of the tests: the demo mill.
pub fn machine() -> Machine {
    Machine::from_toml(Machine::DEMO_MILL).unwrap()
}

pub fn cnc(machine: &Machine, program: &str) -> Cnc {
    cnc_with(machine, program, "")
}

pub fn cnc_with(machine: &Machine, program: &str, setup: &str) -> Cnc {
    Cnc::new(machine, interpreter(program, setup))
}

pub fn interpreter(program: &str, setup: &str) -> Interpreter {
    interpreter_with(program, setup, |_| {})
}

/// The same with other options.
pub fn interpreter_with(program: &str, setup: &str, change: impl FnOnce(&mut Options)) -> Interpreter {
    let dialect = &dialects::gsk990mc::DIALECT;
    let text = Text::from_bytes(program.as_bytes().to_vec()).unwrap();
    let programs = ProgramMemory::new("test.nc", text, dialect.syntax);
    let setup = Setup::from_toml(setup).unwrap();
    let mut memory = Memory::new(dialect.name);
    setup.apply(&mut memory).unwrap();
    let mut options = Options {
        start: setup.start.position(),
        optional_stop: setup.options.optional_stop,
        ..Options::default()
    };
    change(&mut options);
    Interpreter::new(dialect, programs, memory, options)
}

/// A program in a language.
pub fn in_language(name: &str, program: &str) -> Interpreter {
    let dialect = dialects::ALL.iter().find(|dialect| dialect.name == name).copied().unwrap();
    let text = Text::from_bytes(program.as_bytes().to_vec()).unwrap();
    let programs = ProgramMemory::new("test.nc", text, dialect.syntax);
    Interpreter::new(dialect, programs, Memory::new(dialect.name), Options::default())
}

/// Ticks after which a run is taken as hanging: twenty minutes of machine time.
pub const HANGS: usize = 1_200_000;

/// A run, tick by tick, the axes at rest before the first.
pub struct Run {
    pub start: Position,
    pub ticks: Vec<Tick>,
    pub events: Vec<Event>,
}

/// What the operator does at a tick.
#[derive(Clone, Copy, Debug)]
pub enum Hand {
    Hold,
    CycleStart,
    Reset,
    Override(f64, f64),
}

/// Starts the program and goes on until it is neither running, held nor resetting, `hands` at work at
/// their ticks.
pub fn run_with(cnc: &mut Cnc, hands: &[(usize, Hand)]) -> Run {
    let start = cnc.tick().position;
    cnc.cycle_start();
    let mut run = Run { start, ticks: Vec::new(), events: Vec::new() };
    for tick in 0..HANGS {
        for (_, hand) in hands.iter().filter(|(at, _)| *at == tick) {
            match *hand {
                Hand::Hold => cnc.feed_hold(),
                Hand::CycleStart => cnc.cycle_start(),
                Hand::Reset => cnc.reset(),
                Hand::Override(feed, rapid) => cnc.set_override(feed, rapid),
            }
        }
        run.ticks.push(cnc.tick());
        run.events.extend(cnc.events());
        let is_over = !matches!(cnc.state(), State::Running | State::Held | State::Resetting);
        if is_over {
            return run;
        }
        // Nobody will ever press cycle start.
        let waits = cnc.state() == &State::Held && hands.iter().all(|(at, _)| *at <= tick);
        assert!(!waits, "held for ever");
    }
    panic!("does not end: {:?} {:?}", cnc.state(), run.ticks.last());
}

pub fn run(cnc: &mut Cnc) -> Run {
    run_with(cnc, &[])
}

/// A program run to its end.
pub fn ended(machine: &Machine, program: &str) -> (Cnc, Run) {
    let mut cnc = cnc(machine, program);
    let run = run(&mut cnc);
    assert_eq!(cnc.state(), &State::Ended, "{program}");
    (cnc, run)
}

/// The alarm that a program ends with.
pub fn alarmed(cnc: &mut Cnc) -> (Alarm, Run) {
    let run = run(cnc);
    match cnc.state() {
        State::Alarmed(alarm) => ((**alarm).clone(), run),
        state => panic!("{state:?} instead of an alarm"),
    }
}

pub const ACTIVITIES: [Activity; 5] =
    [Activity::Cutting, Activity::Rapid, Activity::Dwell, Activity::ToolChange, Activity::Spindle];

/// Finite differences are means of the true derivative and never overstate it; this pays for what is
/// lost by rounding.
const SLACK: f64 = 1.001;

impl Run {
    pub fn end(&self) -> Position {
        self.ticks.last().unwrap().position
    }

    /// Setpoints with the axes at rest before and after.
    fn padded(&self) -> Vec<Position> {
        let positions = self.ticks.iter().map(|t| t.position);
        let end = self.end();
        [self.start, self.start].into_iter().chain(positions).chain([end, end]).collect()
    }

    /// No axis above its velocity (`rapid` where the program positions, `velocity` where it only cuts)
    /// and acceleration, the stand-still at both ends counted in.
    pub fn check_limits(&self, machine: &Machine, only_cuts: bool) {
        let t = machine.servo_period_ms / 1000.0;
        let all = self.padded();
        for (k, w) in all.windows(3).enumerate() {
            for axis in &machine.axes {
                let [a, b, c] = [w[0][axis.name], w[1][axis.name], w[2][axis.name]];
                let top = if only_cuts { axis.velocity } else { axis.velocity.max(axis.rapid) } / 60.0;
                let velocity = (c - b).abs() / t;
                assert!(
                    velocity <= top * SLACK + 1e-6,
                    "tick {k}: {} at {velocity} mm/s",
                    axis.name.letter()
                );
                let acceleration = (c - 2.0 * b + a).abs() / (t * t);
                let most = axis.acceleration * SLACK + 1e-3;
                assert!(acceleration <= most, "tick {k}: {} at {acceleration} mm/s²", axis.name.letter());
            }
            // An axis that the machine lacks never moves.
            for i in (0..AXES).filter(|i| machine.axes.iter().all(|a| a.name.index() != *i)) {
                assert_eq!(w[0].0[i], w[2].0[i]);
            }
        }
        for tick in &self.ticks {
            assert_eq!(tick.position, tick.actual, "ideal drives are where they are commanded to be");
        }
    }

    /// Every setpoint lies within `bound` of the way of `other`, in its order, and the last one as far as it goes.
    pub fn follows(&self, other: &Run, bound: f64) {
        let way = other.padded();
        let mut from = 0;
        for (k, tick) in self.ticks.iter().enumerate() {
            let p = tick.position;
            let near = (from..way.len() - 1)
                .take(400)
                .map(|i| (distance(p, way[i], way[i + 1]), i))
                .min_by(|a, b| a.0.total_cmp(&b.0))
                .unwrap();
            assert!(near.0 < bound, "tick {k}: {p:?} is {} mm beside the way", near.0);
            from = near.1;
        }
    }
}

/// Distance from `p` to the straight piece from `a` to `b`, mm.
fn distance(p: Position, a: Position, b: Position) -> f64 {
    let d = b - a;
    let dot = |x: Position, y: Position| x.0.iter().zip(&y.0).map(|(x, y)| x * y).sum::<f64>();
    let length = dot(d, d);
    let s = if length > 0.0 { (dot(p - a, d) / length).clamp(0.0, 1.0) } else { 0.0 };
    let rest = Axis::ALL.iter().map(|i| p[*i] - (a[*i] + s * d[*i])).map(|v| v * v).sum::<f64>();
    rest.sqrt()
}
