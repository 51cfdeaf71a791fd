//! Skip moves on a machine with a probe: they end where it touches (GSK990MC 4.2.16), or where it comes free (LinuxCNC,
//! G38.4 and G38.5).
//!
//! The drives keep where the axes were when the signal came; the move is braked from there within the limits of the
//! axes, the rest of it is forgotten. The program is told both. A signal that is there already ends the move where
//! it begins. Without a probe a skip move is run as the program gives it out, as at a desk.
//!
//! A move until an input of the program has a state (Weihong 4.4: G904) is the same with a ladder: the input is looked at in
//! every period.

use super::{Cnc, State};
use crate::drives::Contact;
use ferrocut_geometry::Position;
use ferrocut_interpreter::AtRest;
use ferrocut_toolpath::{Op, Step};

/// A signal that came this near to where the move began was there before, mm: drives that answer later than they are armed
/// say so by the place alone, and axes at rest stand within some counts of their encoders.
const STANDS_MM: f64 = 0.005;

/// A skip move.
#[derive(Clone, Copy, Debug)]
pub(super) struct Probing {
    /// Its mark in motion.
    tag: u64,
    from: Position,
    until: Contact,
    /// The input of programs whose signal it is; the probe's without one.
    input: Option<u16>,
    /// It is being run, and the drives wait for the signal.
    armed: bool,
    /// The signal was there as it was armed.
    was_there: bool,
    /// Where the signal came: where the probe touched, or was free.
    touched: Option<Position>,
}

impl Probing {
    /// Whether it ends where it is braked now.
    pub fn has_touched(&self) -> bool {
        self.touched.is_some()
    }
}

impl Cnc {
    /// A skip move was given to motion. From rest the probe is looked at before anything is planned: a move that was
    /// not begun is forgotten, while one on its way takes some periods to be stopped.
    pub(super) fn begin_probing(&mut self, tag: u64, from: Position, away: bool, input: Option<u16>) {
        let is_there = if input.is_some() { self.auxiliary.is_some() } else { self.drives.has_probe() };
        if !is_there {
            return;
        }
        let until = if away { Contact::Lost } else { Contact::Made };
        self.probing =
            Some(Probing { tag, from, until, input, armed: false, was_there: false, touched: None });
        if self.given.len() == 1 && self.motion.is_still() {
            self.arm_probe(tag);
            self.watch_probe();
        }
    }

    /// The skip move of a block behind another one that ended early: as far beside what is programmed.
    pub(super) fn shift_skip(&self, step: &mut Step) {
        if let Op::Skip { to, .. } = &mut step.op {
            *to = *to + self.skip_shift;
        }
    }

    /// Before the drives are asked: their probe is armed once the move begins.
    pub(super) fn arm_probe(&mut self, running: u64) {
        if let Some(probing) =
            self.probing.as_mut().filter(|probing| !probing.armed && probing.tag == running)
        {
            probing.armed = true;
            if probing.input.is_none() {
                self.drives.arm_probe(probing.until);
                probing.was_there = self.drives.probe().is_some();
            }
        }
    }

    /// After it: has the probe touched, the move is braked.
    pub(super) fn watch_probe(&mut self) {
        let Some(probing) = self.probing.filter(|p| p.armed && p.touched.is_none()) else { return };
        let touched = match probing.input {
            Some(input) => {
                let is_so = self.program_input(input) == Some(probing.until == Contact::Made);
                is_so.then_some(self.actual)
            }
            None => self.drives.probe().map(|touched| touched - self.servo.added()),
        };
        if touched.is_some() {
            self.probing = Some(Probing { touched, ..probing });
            self.motion.abort();
        }
    }

    /// The move ended, at its end or where it was braked: the program is told.
    pub(super) fn end_probing(&mut self) {
        let Some(probing) = self.probing.take() else { return };
        let at = self.motion.position();
        self.skip_shift = self.skip_shift + at - self.commanded;
        self.commanded = at;
        self.supervisor.moved_to(at);
        if self.touches.is_some() {
            return self.end_touch(probing.touched);
        }
        let missed = match probing.touched {
            Some(touched) if probing.was_there || touched.distance(probing.from) < STANDS_MM => {
                self.interpreter.own().signal_before()
            }
            Some(_) => None,
            None => self.interpreter.own().missed_signal(),
        };
        self.tell_program(&AtRest { skip: probing.touched, ..AtRest::new(at, self.actual) });
        if let Some(alarm) = missed {
            self.span = alarm.span;
            self.state = State::Alarmed(alarm);
        }
    }

    /// The way that a skip move really went: where it began and where it was braked.
    pub(super) fn braked_way(&self, tag: u64) -> Option<(Position, Position)> {
        let probing = self.probing.filter(|probing| probing.tag == tag && probing.touched.is_some())?;
        Some((probing.from, self.motion.position()))
    }
}
