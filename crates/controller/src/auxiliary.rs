//! What the control does by way of the ladder: M, S, T codes, and the spindle.
//!
//! A step that is a code for the machine is handed to the ladder, and the next block waits until it is done; the
//! moves of its own block run beside it (GSK990MC part 1, chapter 5). Under auxiliary lock no code is handed out
//! but stops and ends (part 2, 7.8). Without a ladder, at a desk, none of this is there.

use crate::handshake::{Codes, Handshake, Progress};
use crate::signals::{Inputs, Outputs, SIGNAL_AXES};
use crate::spindle::Spindle;
use crate::spindle_control::SpindleControl;
use ferrocut_geometry::{Axis, Position, Turn};
use ferrocut_machine::Machine;
use ferrocut_toolpath::{Feed, Op, Speed, SpindleState, Step};

/// What became of a step.
#[derive(Clone, Copy, PartialEq, Eq, Debug)]
pub(crate) enum Handing {
    /// It is none for the ladder.
    Nothing,
    /// It was handed over.
    Begun,
    /// Nothing more is to be done: it is locked.
    Done,
}

/// Where the machine is, for the ladder and the spindle.
#[derive(Clone, Copy, Debug)]
pub(crate) struct Now {
    /// Commanded positions.
    pub at: Position,
    /// End of the positioning under way.
    pub rapid_to: Option<Position>,
    /// A thread is being tapped.
    pub taps: bool,
}

/// The ladder as the control sees it.
#[derive(Debug)]
pub(crate) struct Auxiliary {
    inputs: Inputs,
    handshake: Handshake,
    spindle: SpindleControl,
    axes: Vec<Axis>,
    /// The step that is handed over.
    handed: Option<Step>,
    /// The ladder finished it.
    is_done: bool,
    /// The step that waits for it.
    next: Option<Step>,
    /// The speed that was handed over last.
    s_told: Option<u32>,
    /// The speed under auxiliary lock, for a feed per revolution, r/min.
    locked_rpm: f64,
    /// M29 is in force.
    rigid: bool,
    /// Where the axes were in the last period, and in which way they went.
    last: Option<Position>,
    moving: [bool; SIGNAL_AXES],
    downwards: [bool; SIGNAL_AXES],
}

impl Auxiliary {
    pub fn new(machine: &Machine) -> Auxiliary {
        Auxiliary {
            inputs: Inputs::default(),
            handshake: Handshake::new(&machine.handshake, machine.servo_period_ms / 1000.0),
            spindle: SpindleControl::new(machine),
            axes: machine.axes.iter().map(|axis| axis.name).collect(),
            handed: None,
            is_done: false,
            next: None,
            s_told: None,
            locked_rpm: 0.0,
            rigid: false,
            last: None,
            moving: [false; SIGNAL_AXES],
            downwards: [false; SIGNAL_AXES],
        }
    }

    /// The gear of the spindle that is engaged, counted from 1.
    pub fn gear(&self) -> u8 {
        self.spindle.engaged()
    }

    /// What the ladder says in this period. Auxiliary lock is in force or not whatever its switch says by now.
    pub fn hear(&mut self, inputs: &Inputs, is_locked: bool) {
        self.inputs.clone_from(inputs);
        self.inputs.auxiliary_lock = is_locked;
    }

    /// The switch of the spindle override counts as 100 % in this period.
    pub fn ignore_spindle_override(&mut self) {
        self.inputs.spindle_override = 1.0;
    }

    /// Goes on by a period. `true` where a code takes too long.
    pub fn tick(&mut self, now: &Now, spindle: &mut Spindle) -> bool {
        self.spindle.tick(&self.inputs, now.taps, &now.at, now.rapid_to, spindle);
        if let Some(last) = self.last {
            for ((moving, downwards), axis) in self.moving.iter_mut().zip(&mut self.downwards).zip(&self.axes)
            {
                let way = now.at[*axis] - last[*axis];
                *moving = way != 0.0;
                if *moving {
                    *downwards = way < 0.0;
                }
            }
        }
        self.last = Some(now.at);
        match self.handshake.tick(&self.inputs) {
            Progress::Done => self.is_done = true,
            Progress::Late => return true,
            Progress::Idle | Progress::Waits => {}
        }
        false
    }

    /// Hands a step to the ladder, if it is for it. The end of a program hands the speed `in_force` over, too, which
    /// no code may have told: keys will turn the spindle at it (GSK990MC part 2, 4.2).
    pub fn hand_over(&mut self, step: &Step, in_force: Speed) -> Handing {
        let Some(mut codes) = codes_of(&step.op) else { return Handing::Nothing };
        let is_locked = self.inputs.auxiliary_lock && !matches!(step.op, Op::Stop(_) | Op::End(_));
        if let Op::Spindle(state) = step.op
            && let Some(speed) = state.speed()
        {
            if is_locked {
                let at = self.last.unwrap_or_default();
                self.locked_rpm = speed.rpm(&at);
            } else {
                codes.s = self.speed(speed);
            }
        }
        if is_locked {
            return Handing::Done;
        }
        // A rigid thread may be cut at a speed that the spindle was never told: its gear is to be engaged before.
        if matches!(step.op, Op::End(_) | Op::Machine(29)) && !self.inputs.auxiliary_lock {
            codes.s = self.speed(in_force);
        }
        match step.op {
            Op::Orient(degrees) => self.spindle.set_angle(degrees),
            Op::Machine(29) => self.rigid = true,
            Op::Machine(28) | Op::End(_) => self.rigid = false,
            _ => {}
        }
        self.begin(codes, step.clone());
        Handing::Begun
    }

    /// Inputs of programs, UI from bit 0 on: #1000 to #1015, or ports of these numbers.
    pub fn macro_inputs(&self) -> u16 {
        self.inputs.macro_inputs
    }

    /// S at the end of a program that did not turn the spindle: keys will. Whether it is handed over.
    pub fn hand_over_speed(&mut self, speed: Speed, step: &Step) -> bool {
        if self.inputs.auxiliary_lock {
            return false;
        }
        let s = self.speed(speed);
        if s.is_some() {
            self.begin(Codes { s, ..Codes::default() }, step.clone());
        }
        s.is_some()
    }

    fn begin(&mut self, codes: Codes, step: Step) {
        self.handshake.begin(codes);
        (self.handed, self.is_done) = (Some(step), false);
    }

    /// The speed of the program from now on; its code where it is another.
    fn speed(&mut self, speed: Speed) -> Option<u32> {
        self.spindle.set_speed(speed);
        // A surface speed is the NC's own (Fanuc 0i).
        let Speed::Rpm(rpm) = speed else { return None };
        let code = rpm.round().clamp(0.0, f64::from(u32::MAX)) as u32;
        (self.s_told != Some(code)).then(|| {
            self.s_told = Some(code);
            code
        })
    }

    /// The step that is handed over and not done.
    pub fn handed(&self) -> Option<&Step> {
        self.handed.as_ref()
    }

    /// The codes under way.
    pub fn codes(&self) -> Codes {
        self.handshake.codes()
    }

    /// The step that the ladder has finished, once.
    pub fn take_done(&mut self) -> Option<Step> {
        match std::mem::take(&mut self.is_done) {
            true => self.handed.take(),
            false => None,
        }
    }

    /// Whether a step has to wait until the one that is handed over is done; it is kept then.
    pub fn keeps(&mut self, step: &Step) -> bool {
        let waits = self.handed.as_ref().is_some_and(|handed| !runs_beside(handed, step));
        if waits {
            self.next = Some(step.clone());
        }
        waits
    }

    /// Whether a step is kept that must still wait.
    pub fn is_full(&self) -> bool {
        self.handed.is_some() && self.next.is_some()
    }

    /// The step that was kept.
    pub fn take_next(&mut self) -> Option<Step> {
        self.next.take()
    }

    /// Which way the ladder lets the spindle turn.
    pub fn spindle_turns(&self) -> Option<Turn> {
        self.spindle.turns(&self.inputs)
    }

    /// Whether cutting waits for the speed of the spindle.
    pub fn cutting_waits(&self) -> bool {
        !self.inputs.auxiliary_lock && self.spindle.cutting_waits(&self.inputs)
    }

    /// Whether the ladder lacks its signal of rigid tapping (GSK990MC alarm 0205).
    pub fn lacks_rigid_tapping(&self) -> bool {
        self.rigid && !self.inputs.rigid_tapping
    }

    /// The speed for a feed per revolution where codes are locked, r/min.
    pub fn locked_rpm(&self) -> Option<f64> {
        self.inputs.auxiliary_lock.then_some(self.locked_rpm)
    }

    /// Forgets what was handed over: reset.
    pub fn cancel(&mut self) {
        self.handshake.cancel();
        (self.handed, self.is_done, self.next, self.s_told) = (None, false, None, None);
        self.rigid = false;
    }

    /// Tells the ladder of codes, spindle and axes.
    pub fn tell(&self, spindle: &Spindle, is_settled: bool, outputs: &mut Outputs) {
        self.handshake.tell(outputs);
        self.spindle.tell(&self.inputs, spindle, outputs);
        (outputs.moving, outputs.downwards) = (self.moving, self.downwards);
        let in_position = self.moving.iter().zip(&mut outputs.in_position).take(self.axes.len());
        for (moving, in_position) in in_position {
            *in_position = !moving && is_settled;
        }
    }
}

/// The code of a tool that gets another number (Weihong 4.2).
const TOOL_NUMBER: u32 = 903;

/// The codes that a step is to the ladder; `None` where it is none.
fn codes_of(op: &Op) -> Option<Codes> {
    Some(match *op {
        Op::Spindle(SpindleState::Clockwise(_)) => Codes::m(3),
        Op::Spindle(SpindleState::CounterClockwise(_)) => Codes::m(4),
        Op::Spindle(SpindleState::Off) => Codes::m(5),
        Op::Orient(_) => Codes::m(19),
        Op::Coolant(true) => Codes::m(8),
        Op::Coolant(false) => Codes::m(9),
        Op::Select(tool) => Codes { t: Some(tool), ..Codes::default() },
        Op::Change(_) => Codes::m(6),
        Op::Machine(code) | Op::Stop(code) => Codes::m(code),
        // The number that an M code hands over is shown as a B code beside it.
        Op::MachineNumber { code, number } => Codes { b: Some(number), ..Codes::m(code) },
        Op::ToolNumber(tool) => Codes { b: Some(tool), ..Codes::m(TOOL_NUMBER) },
        // M99 is not handed out (GSK990MC part 2, 7.8).
        Op::End(code) if code != 99 => Codes::m(code),
        _ => return None,
    })
}

/// Whether a step is a move of the same block, which runs beside its codes. A tool change, and a feed that needs
/// the spindle, wait.
fn runs_beside(handed: &Step, step: &Step) -> bool {
    let is_move = match step.op {
        Op::Rapid { .. } => true,
        Op::Feed { feed, .. } | Op::Arc { feed, .. } => !matches!(feed, Feed::PerRevolution(_)),
        _ => false,
    };
    let alone = matches!(handed.op, Op::Change(_) | Op::ToolNumber(_) | Op::Stop(_) | Op::End(_));
    is_move && !alone && step.span == handed.span
}
