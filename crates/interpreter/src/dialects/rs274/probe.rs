//! Probing (LinuxCNC, G38.2 to G38.5): a straight cut that ends where the probe comes into contact, or loses it.

use crate::Fallible;
use crate::dialect::Meaning;
use crate::interpreter::Interpreter;
use crate::modal::Group;
use ferrocut_geometry::{Axis, AxisSet, Position, SAME_POINT_MM};
use ferrocut_machine::Fault;
use ferrocut_toolpath::{Feed, Op};

/// Parameter of the probed X; the other axes follow.
const PROBED: u32 = 5061;

/// Parameter that is 1 after a probe that found something, else 0.
const FOUND: u32 = 5070;

impl Interpreter {
    /// Probes to the point that the block leads to, until the probe touches or, `away`, is free.
    pub(super) fn ngc_probe(&mut self, axes: AxisSet, away: bool, needs_contact: bool) -> Fallible<()> {
        if self.output.in_cutter_mode() {
            return Err(self.ngc_alarm(Fault::NotInCutter));
        }
        // Of inverse-time feed the last one given counts.
        let feed = match self.modal.meaning(Group::FeedMode) {
            Meaning::InverseTime if self.ngc.feed > 0.0 => Feed::Duration(60.0 / self.ngc.feed),
            _ => self.ngc_feed()?,
        };
        if self.modal.is_feed_per_revolution() {
            return Err(self.ngc_alarm(Fault::CodesContradict));
        }
        let to = self.ngc_end_point(axes);
        let way = to - self.ngc.at;
        if way.0.iter().all(|c| c.abs() < SAME_POINT_MM) {
            return Err(self.ngc_alarm(Fault::ProbeTooClose));
        }
        let (from, aim) = (self.location.machine, self.ngc.machine_of(to));
        self.ngc_check_reach(aim)?;
        if needs_contact
            && self.machine_waits.is_some()
            && self.probe.is_none()
            && self.options.skip.is_none()
        {
            // A machine without a probe.
            return Err(self.ngc_alarm(Fault::ProbeMissing));
        }
        // Where the simulated signal comes on the way, as a fraction of it.
        let at = self.options.skip.and_then(|(axis, at)| {
            let t = (at - from[axis]) / (aim[axis] - from[axis]);
            (0.0..=1.0).contains(&t).then_some(t)
        });
        let reached = at.map_or(aim, |t| from.lerp(aim, t));
        self.location.machine = reached;
        self.ngc.at = self.ngc.program_of(reached);
        self.emit(Op::Skip { to: reached, feed, hit: at.is_some(), away, input: None });
        self.ngc_note_probe(reached, at.is_some())?;
        self.emit_barrier()?;
        // At a desk where no one simulates a probe there is none to miss.
        match needs_contact && at.is_none() && (self.options.skip.is_some() || self.probe.is_some()) {
            true => self.miss_signal(self.words.block_span()),
            false => Ok(()),
        }
    }

    /// The machine came to rest at a barrier, which may have ended a probing move.
    pub(crate) fn ngc_came_to_rest(&mut self, skip: Option<Position>) {
        self.ngc.at = self.ngc.program_of(self.location.machine);
        if let Some(at) = skip {
            // The parameters exist.
            let _ = self.ngc_note_probe(at, true);
        }
    }

    /// Where a probe ended: in the machine, and for the program in its units and its coordinate system.
    fn ngc_note_probe(&mut self, machine: Position, found: bool) -> Fallible<()> {
        self.ngc.probed = Some((machine, found));
        let point = self.ngc.program_of(machine);
        let unit = self.ngc_unit();
        for (number, axis) in (PROBED..).zip(Axis::ALL) {
            let at = point[axis];
            let value = if axis.is_linear() { at / unit } else { at };
            self.ngc_set(number, value).map_err(|fault| self.ngc_alarm(fault))?;
        }
        let found = if found { 1.0 } else { 0.0 };
        self.ngc_set(FOUND, found).map_err(|fault| self.ngc_alarm(fault))
    }
}
