//! Switches that change how a program is run: locks, dry run, optional stop, interlock.

use super::tapping::ThreadKind;
use super::{Cnc, Given, State};
use ferrocut_geometry::Position;
use ferrocut_interpreter::AtRest;
use ferrocut_motion::Move;
use ferrocut_toolpath::{Op, SpindleState};

/// Dry run (GSK990MC part 2, 7.5): speed of what it holds for, mm/s. The overrides hold besides.
#[derive(Clone, Copy, PartialEq, Debug)]
pub struct DryRun {
    /// Speed along the path, mm/s (P86).
    pub speed: f64,
    /// It holds for cutting (12#6).
    pub cutting: bool,
    /// It holds for positioning (12#7).
    pub rapid: bool,
    /// It holds for tapping (12#5): the spindle turns as the pitch asks.
    pub tapping: bool,
}

impl DryRun {
    /// Whether it holds for a move.
    fn holds_for(&self, given: &Given) -> bool {
        match (given.motion.is_tapping(), given.programmed.is_rapid) {
            (true, _) => self.tapping,
            (false, true) => self.rapid,
            (false, false) => self.cutting,
        }
    }
}

/// Where the axes stand while positions go on.
#[derive(Clone, Copy, Debug)]
pub(super) struct Locked {
    /// By the control.
    position: Position,
    /// As the drives were told.
    drive: Position,
    /// What places were renamed by before: a name that a place gets under the lock goes with it.
    renamed: Position,
}

/// How the switches stand.
#[derive(Clone, Copy, Debug)]
pub(super) struct Switches {
    dry_run: Option<DryRun>,
    pub optional_stop: bool,
    may_move: bool,
    locked: Option<Locked>,
    /// What the drives were told last.
    drive: Position,
    /// A factor.
    spindle_override: f64,
}

impl Switches {
    pub fn new(at: Position) -> Switches {
        Switches {
            dry_run: None,
            optional_stop: true,
            may_move: true,
            locked: None,
            drive: at,
            spindle_override: 1.0,
        }
    }

    /// What the drives are told for a command.
    pub fn drive(&mut self, drive: Position) -> Position {
        match &self.locked {
            Some(locked) => locked.drive,
            None => {
                self.drive = drive;
                drive
            }
        }
    }

    /// Whether the axes are locked.
    pub fn is_locked(&self) -> bool {
        self.locked.is_some()
    }
}

impl Cnc {
    /// Dry run on or off, as the switch stands in each period. Moves that wait follow too, after a stop; so in a thread
    /// that the spindle cuts beside it changes nothing yet.
    pub fn set_dry_run(&mut self, dry_run: Option<DryRun>) {
        if !self.is_in(ThreadKind::Beside) && self.switches.dry_run != dry_run {
            self.switches.dry_run = dry_run;
            self.renew_moves();
        }
    }

    /// The speed of the spindle, r/min, at which the axes tap a thread of this pitch in a dry run that holds for it.
    pub(super) fn dry_tapping(&self, pitch: f64) -> Option<f64> {
        let dry = self.switches.dry_run.filter(|dry| dry.tapping && dry.speed > 0.0);
        dry.map(|dry| dry.speed * 60.0 / pitch.abs())
    }

    /// Whether dry run is in force.
    pub(super) fn is_dry_run(&self) -> bool {
        self.switches.dry_run.is_some()
    }

    /// Auxiliary lock: S, T and M codes have no effect, save those of the program's flow (7.8). It comes and goes as the
    /// switch does, but not in the midst of the program of a tool change, which would leave the change half done.
    pub fn set_auxiliary_lock(&mut self, on: bool) {
        self.interpreter.set_auxiliary_lock(on);
    }

    /// Whether auxiliary lock is in force.
    pub fn is_auxiliary_locked(&self) -> bool {
        self.interpreter.is_auxiliary_locked()
    }

    /// Under auxiliary lock a tool that was called or changed to was neither: blocks that were read before it came may
    /// have said so.
    pub(super) fn keep_tools(&mut self, op: &Op) {
        if self.is_auxiliary_locked() && matches!(op, Op::Select(_) | Op::Change(_) | Op::ToolNumber(_)) {
            let tools = self.taking_up.tools;
            self.interpreter.own().set_tools(tools);
        }
    }

    /// Whether M01 stops, where the interpreter was told to give it out.
    pub fn set_optional_stop(&mut self, on: bool) {
        self.switches.optional_stop = on;
    }

    /// Interlock: without the permission the axes come to rest, and go on with it. Axes moved by hand must be moved
    /// anew.
    pub fn set_may_move(&mut self, may: bool) {
        if self.switches.may_move != may {
            self.switches.may_move = may;
            self.hold_motion();
            if !may {
                self.hold_return();
                self.stop_homing_by_hand();
                self.manual.stop();
            }
        }
    }

    pub(super) fn may_move(&self) -> bool {
        self.switches.may_move
    }

    /// Machine lock (7.7): positions go on and the axes stand still. It comes and goes only while no program is
    /// under way and no axis moves; whether it is as wanted. When it goes, positions are those of the axes again, so
    /// that no zero is lost.
    pub fn set_machine_lock(&mut self, on: bool) -> bool {
        if on == self.switches.locked.is_some() {
            return true;
        }
        if !self.is_idle() {
            return false;
        }
        if on {
            let position = self.beside(self.motion.position());
            self.switches.locked =
                Some(Locked { position, drive: self.switches.drive, renamed: self.renamed });
        } else if let Some(locked) = self.switches.locked.take() {
            self.aside.shift = Position::ZERO;
            self.renamed = locked.renamed;
            self.stand_at(locked.position);
        }
        true
    }

    /// Whether machine lock is in force.
    pub fn is_locked(&self) -> bool {
        self.switches.is_locked()
    }

    /// The place where the axes stand at rest is this one.
    pub(super) fn stand_at(&mut self, at: Position) {
        self.motion.rename(at);
        self.servo.rename(self.beside(at));
        self.commanded = at;
        self.actual = self.beside(at);
        self.supervisor.moved_to(at);
        self.interpreter.own().came_to_rest(&AtRest::new(at, at));
    }

    /// A move as it is run now.
    pub(super) fn paced(&self, given: &Given) -> Move {
        let dry = self.switches.dry_run.filter(|dry| dry.holds_for(given));
        dry.map_or(given.motion, |dry| given.motion.at_speed(dry.speed)).last(given.left).beside(given.beside)
    }

    /// Holds motion or lets it go on, whoever asks for it.
    pub(super) fn hold_motion(&mut self) {
        // A program that is held may be on its way back.
        let holds = self.hold && !self.retrace.goes_back() || self.retrace.holds();
        if holds || !self.switches.may_move || self.blocks.is_braking() {
            self.motion.hold();
        } else {
            self.motion.resume();
        }
    }

    /// Whether a switch keeps a step from the machine. What a ladder is handed under auxiliary lock is judged there.
    pub(super) fn is_kept_back(&self, op: &Op) -> bool {
        let is_auxiliary = matches!(
            op,
            Op::Spindle(_)
                | Op::Orient(_)
                | Op::Coolant(_)
                | Op::Select(_)
                | Op::Change(_)
                | Op::ToolNumber(_)
                | Op::Machine(_)
                | Op::MachineNumber { .. }
                // With the next move, it is judged as that begins.
                | Op::Output { with_next_move: false, .. }
        );
        match op {
            Op::Stop(1) => !self.switches.optional_stop,
            // A ladder judges codes itself, and no output.
            _ => {
                let is_judged = self.auxiliary.is_some() && !matches!(op, Op::Output { .. });
                is_auxiliary && self.is_auxiliary_locked() && !is_judged
            }
        }
    }

    /// Spindle override as a factor, of a machine without a ladder: with one, its signal counts.
    pub fn set_spindle_override(&mut self, factor: f64) {
        self.switches.spindle_override = factor;
    }

    /// Once a period, where there is no ladder. In a thread that the spindle cuts beside it is as at 100 %.
    pub(super) fn override_spindle(&mut self) {
        if self.auxiliary.is_none() {
            let factor = if self.is_in(ThreadKind::Beside) { 1.0 } else { self.switches.spindle_override };
            self.spindle.set_override(factor);
        }
    }

    /// Tells the spindle what a key asks for (4.2); not while a program runs.
    pub fn turn_spindle(&mut self, state: SpindleState) -> bool {
        let may = self.may_turn_spindle();
        if may {
            self.spindle.command(state, &self.commanded);
        }
        may
    }

    fn may_turn_spindle(&self) -> bool {
        let runs = matches!(self.state, State::Running | State::Resetting);
        !runs && self.stroke.is_none() && !self.goes_back()
    }

    /// Brings the spindle to rest at its marker; not while a program runs.
    pub fn orient_spindle(&mut self) -> bool {
        let may = self.may_turn_spindle();
        if may {
            self.spindle.orient(0.0);
        }
        may
    }
}
