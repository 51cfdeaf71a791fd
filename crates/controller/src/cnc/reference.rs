//! Reference points in the control: who sends axes there, and what the places are called afterwards.

use super::{Cnc, State};
use crate::drives::Switches;
use ferrocut_geometry::{Axis, AxisSet, Position};
use ferrocut_interpreter::Unreferenced;
use ferrocut_machine::{Alarm, Fault};

impl Cnc {
    /// Sends an axis to its reference point, as its key in the mode HOME does: axes at their limits come to rest and
    /// find it by their switches, or are positioned on it where it is known and that is set, or no switch comes any more.
    /// Whether it goes: not
    /// while a program is under way, nor while the axis moves, nor beside another where one at a time may home, nor
    /// under machine lock, where no axis comes to its place.
    pub fn home(&mut self, axis: Axis) -> bool {
        let may = matches!(self.state, State::Ready | State::Ended | State::Reset) && !self.is_locked();
        if !may || !self.machine_axes.contains(axis) || !self.take_by_hand() || !self.manual.stands(axis) {
            return false;
        }
        self.begin_homing(axis, true)
    }

    /// Why an axis may not be sent to its reference point straight on, as one goes there that knows it: an area that is
    /// forbidden lies between (GSK990MC part 2, 2.6).
    pub fn home_alarm(&self, axis: Axis) -> Option<Box<Alarm>> {
        let at = self.place_by_hand();
        let mut to = at;
        to[axis] = self.reference()[axis];
        if !self.homing.goes_straight(axis, at[axis], to[axis], &self.switches()) {
            return None;
        }
        let check = self.frame().stroke_check;
        // Others that are on their way may be anywhere.
        let moves =
            |other: &Axis| self.manual.is_active && !self.manual.stands(*other) || self.homing.moves(*other);
        let others = self.machine_axes.iter().filter(|other| *other != axis && moves(other)).collect();
        let (low, high) = self.interpreter.stroke_room(axis, at, others, check);
        self.interpreter.stroke_between(at, to, check).or_else(|| {
            let is_free = (low..=high).contains(&to[axis]);
            let id = self.interpreter.dialect().alarm_id(Fault::StoredStroke);
            (!is_free).then(|| Box::new(Alarm::new(id, Fault::StoredStroke, self.span)))
        })
    }

    /// The places where axes stand are their reference points, as if they had been found there: machine zero set by
    /// hand, on a machine that has encoders and no switches for it (GSK990MC part 2, 3.3.5; 20#7). Whether they are:
    /// not while a program is under way or an axis moves, nor under machine lock.
    pub fn set_machine_zero(&mut self, axes: AxisSet) -> bool {
        let may = matches!(self.state, State::Ready | State::Ended | State::Reset)
            && !self.manual.is_active
            && !self.is_locked()
            && !self.homing.is_active();
        if !may || !self.take_by_hand() {
            return false;
        }
        // They get their names at the end of this period of moving by hand.
        self.manual.is_active = true;
        for axis in axes.and(self.machine_axes).iter() {
            self.homing.found_at(axis, self.manual.at(axis));
        }
        true
    }

    /// The key of an axis in the mode HOME was let go.
    pub fn release_home(&mut self, axis: Axis) {
        self.homing.let_go(axis, &mut self.manual);
    }

    /// Axes that home by hand come to rest where they are, as when another mode is chosen.
    pub fn stop_homing_by_hand(&mut self) {
        if matches!(self.state, State::Ready | State::Ended | State::Reset) && self.homing.abort().is_some() {
            self.manual.stop();
        }
    }

    /// Axes whose reference points are known.
    pub fn referenced(&self) -> AxisSet {
        self.homing.referenced()
    }

    /// Axes that stand on their reference points: the lamps.
    pub fn at_reference(&self) -> AxisSet {
        self.homing.arrived()
    }

    /// Whether an axis is on its way to its reference point.
    pub fn is_homing(&self) -> bool {
        self.homing.is_active()
    }

    /// Whether the reference points are to be kept while power is off (GSK990MC 6#4): whoever starts the control next
    /// starts it where the axes were, and sets them as referenced.
    pub fn remembers_reference(&self) -> bool {
        self.homing.config().remembers || self.homing.config().absolute
    }

    /// Says whose reference points are known: at power-on with encoders that know, or with points that were kept.
    pub fn set_referenced(&mut self, axes: AxisSet) {
        self.homing.set_referenced(axes.and(self.machine_axes));
        for axis in self.machine_axes.iter() {
            self.apply_travel(axis);
        }
        self.tell_unreferenced();
    }

    /// The switches as the ladder says that they stand. Without it the control takes what drives read themselves.
    pub fn set_switches(&mut self, switches: Option<Switches>) {
        self.wired = switches;
    }

    /// Whether the home switches are to go through the ladder (GSK990MC 6#5).
    pub fn homes_through_ladder(&self) -> bool {
        self.homing.config().through_ladder
    }

    pub(super) fn switches(&self) -> Switches {
        self.wired.unwrap_or_else(|| self.drives.switches())
    }

    fn reference(&self) -> Position {
        self.interpreter.memory().reference_points.first().copied().unwrap_or_default()
    }

    /// What a new interpreter is told of the machine.
    pub(super) fn fit_interpreter(&mut self) {
        let (min, max) = self.travel;
        if self.auxiliary.is_some() {
            self.interpreter.own().leave_waits_to_machine(min, max);
        }
        if self.drives.has_probe() {
            self.interpreter.own().fit_probe(min, max);
        }
        self.tell_unreferenced();
    }

    fn begin_homing(&mut self, axis: Axis, by_hand: bool) -> bool {
        let reference = self.reference()[axis];
        let (at, switches) = (self.manual.at(axis), self.switches());
        let begins = self.homing.begin(axis, by_hand, at, reference, &switches);
        if begins {
            self.apply_travel(axis);
        }
        begins
    }

    /// Software limits hold where the axis is known, and rapid by hand is possible there, unless parameters say
    /// otherwise.
    fn apply_travel(&mut self, axis: Axis) {
        let config = self.homing.config();
        let known = self.homing.referenced().contains(axis);
        let holds = (known || config.limits_before) && !self.homing.searches(axis);
        let rapid = known || config.rapid_before;
        self.manual.set_travel(axis, holds, rapid);
        self.servo.set_travel(axis, holds);
        self.supervisor.set_travel(axis, holds);
    }

    /// An axis that is about to be moved by hand stays out of stored strokes, as it stays within its software limits
    /// (GSK990MC part 2, 2.6). Only places that are known are judged.
    pub(super) fn keep_out(&mut self, axis: Axis) {
        self.keep_out_beside(axis, AxisSet::default());
    }

    /// Where the axes are, whoever has them.
    pub(super) fn place_by_hand(&self) -> Position {
        match self.manual.is_active {
            true => Position(Axis::ALL.map(|axis| self.manual.at(axis))),
            false => self.beside(self.motion.position()),
        }
    }

    /// The same of an axis beside `others` that are about to be moved too.
    pub(super) fn keep_out_beside(&mut self, axis: Axis, others: AxisSet) {
        let holds = self.homing.referenced().contains(axis) || self.homing.config().limits_before;
        if !holds || self.homing.searches(axis) {
            return;
        }
        let at = Position(Axis::ALL.map(|axis| self.manual.at(axis)));
        let moves = |other: &Axis| !self.manual.stands(*other) || others.contains(*other);
        let moving = self.machine_axes.iter().filter(moves).collect();
        self.manual.set_room(axis, self.interpreter.stroke_room(axis, at, moving, self.frame().stroke_check));
    }

    /// Tells the interpreter which axes are to be homed yet.
    pub(super) fn tell_unreferenced(&mut self) {
        let config = self.homing.config();
        let referenced = self.homing.referenced();
        let unreferenced = Unreferenced {
            axes: self.machine_axes.iter().filter(|axis| !referenced.contains(*axis)).collect(),
            stand: config.needed,
            not_by_program: config.not_by_program,
            limits_before: config.limits_before,
        };
        self.interpreter.own().set_unreferenced(unreferenced);
    }

    /// A program sent axes to their reference points: those that are not known are searched from where they stand. Under
    /// machine lock none gets there: no lamp comes (GSK990MC 4.3.4, 2), and none is found.
    pub(super) fn home_by_program(&mut self, axes: AxisSet) {
        if self.is_locked() {
            return;
        }
        let referenced = self.homing.referenced();
        self.homing.stand(axes);
        let axes = axes.and(self.machine_axes);
        for axis in axes.iter().filter(|axis| !referenced.contains(*axis)) {
            self.manual.take(self.beside(self.motion.position()));
            self.begin_homing(axis, false);
        }
    }

    /// A period of homing.
    pub(super) fn home_on(&mut self) {
        if !self.homing.is_active() {
            return;
        }
        let held = self.state == State::Held || !self.may_move();
        let (switches, added) = (self.switches(), self.servo.added());
        let drives = self.drives.as_mut();
        let wrong = self.homing.tick(&mut self.manual, drives, &switches, &self.actual, &added, held);
        if let Some((axis, fault)) = wrong {
            let alarm = self.axis_alarm(fault, axis, false);
            self.come_to_rest();
            self.failed = Some(Box::new(alarm));
        }
    }

    /// The alarm of a fault of an axis.
    pub(super) fn axis_alarm(&self, fault: Fault, axis: Axis, upper: bool) -> Alarm {
        let id = self.interpreter.dialect().axis_alarm_id(fault, self.servo.number(axis), upper);
        Alarm::new(id, fault, self.span).with("axis", axis.letter().to_string())
    }

    /// All axes stand at `at`: the places of those that were homed get the names of their reference points. What
    /// `at` is called then.
    pub(super) fn name_homed(&mut self, at: Position) -> Position {
        let found = self.homing.take_arrived();
        let reference = self.reference();
        let mut named = at;
        for (axis, place) in Axis::ALL.into_iter().zip(found) {
            if let Some(place) = place {
                // The axis came onto its place but for what counting in units leaves.
                named[axis] = reference[axis] + (at[axis] - place);
                // What the handwheel put the axis aside by is gone (part 2, 6.2.2).
                self.aside.shift[axis] = 0.0;
            }
        }
        if found.iter().any(Option::is_some) {
            self.renamed = self.renamed + named - at;
            self.servo.rename(named);
            self.drives.rename(&(named + self.servo.added()));
            self.actual = self.actual + named - at;
            self.tell_unreferenced();
            if !matches!(self.state, State::Running | State::Held) {
                self.interpreter.own().homed_by_hand();
            }
        }
        // The generator of manual motion takes the names with its limits.
        self.manual.rename(named);
        for axis in self.machine_axes.iter() {
            self.apply_travel(axis);
        }
        named
    }

    /// Notes where the axes are commanded to be, for the lamps.
    pub(super) fn note_reference(&mut self, at: &Position) {
        let reference = self.reference();
        self.homing.note(at, &reference);
    }

    /// An emergency stop gives up homing: the alarm of it, where an axis was on its way.
    pub(super) fn stop_homing(&mut self) -> Option<Box<Alarm>> {
        let axis = self.homing.abort()?;
        Some(Box::new(self.axis_alarm(Fault::HomingStopped, axis, false)))
    }
}
