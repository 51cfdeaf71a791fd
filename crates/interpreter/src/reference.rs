//! Reference points G27 to G30, skip G31, one-way positioning G60.

use crate::Fallible;
use crate::interpreter::Interpreter;
use crate::modal::Group;
use crate::output::OneWay;
use crate::stages::units;
use ferrocut_geometry::{Axis, AxisSet, Position};
use ferrocut_machine::Fault;
use ferrocut_program::Span;
use ferrocut_toolpath::{Dwell, Op};

/// Half the least unit of metric commands: an inch word meets a reference point in mm no closer (GSK990MC 4.2.17 note 3).
const AT_REFERENCE_MM: f64 = 0.0005;

/// The intermediate points that G28 and G30 leave behind for G29.
#[derive(Clone, Copy, PartialEq, Debug, Default)]
pub(crate) struct Intermediate {
    /// Coordinates in the work coordinate system in force (GSK990MC 4.3.1 example: they follow a
    /// change of it).
    point: Position,
    /// Axes that the last G28 or G30 named.
    axes: AxisSet,
    /// Axes that any did, and whose coordinates are known therefore.
    known: AxisSet,
}

impl Interpreter {
    /// G28, or G30 to point `number` (1 is the first): through the intermediate point.
    pub(crate) fn reference_return(&mut self, axes: AxisSet, number: usize) -> Fallible<()> {
        let span = self.words.block_span();
        if axes.is_empty() {
            return Err(self.alarm(Fault::ReferenceWithoutAxis, span));
        }
        // The words of these codes are no polar ones (Fanuc).
        let through = self.straight_end_point(axes);
        for axis in axes.iter() {
            if through[axis].abs() > self.rules.max_coordinate {
                return Err(self.alarm_at(Fault::IntermediateTooLarge, axis.letter() as u8));
            }
            self.intermediate.point[axis] = through[axis];
        }
        self.intermediate.axes = axes;
        self.intermediate.known = self.intermediate.known.iter().chain(axes.iter()).collect();
        match self.rules.reference_keeps_cutter {
            true => self.rapid(through)?,
            false => self.rapid_uncompensated(self.location.machine_of(through))?,
        }
        self.location.programmed = through;
        self.flow.begin_section();
        let (to, searched) = self.at_reference(axes, number);
        self.rapid_uncompensated(to)?;
        // G28 ends tool length compensation by itself (4.3.1).
        let ends_length = !self.rules.coordinates.reference_keeps_length;
        let has_length = |axis: Axis| axis == self.length_axis() || self.location.length.vector[axis] != 0.0;
        if ends_length && axes.iter().any(has_length) {
            self.location.length.cancel();
            // A code of the block is in force behind it (4.1 note 1).
            if !self.words.g.iter().any(|code| code.row.group == Group::Length) {
                self.modal.set(self.dialect.length_off);
            }
        }
        self.location.take_machine();
        self.home(axes, searched)
    }

    /// Where axes are at reference point `number`, but for those that the machine has to search first, and which these are.
    fn at_reference(&mut self, axes: AxisSet, number: usize) -> (Position, AxisSet) {
        let reference =
            self.memory.reference_points.get(number.saturating_sub(1)).copied().unwrap_or_default();
        let searched = self.take_unreferenced(axes);
        let mut to = self.location.machine;
        for axis in axes.iter().filter(|axis| !searched.contains(*axis)) {
            to[axis] = reference[axis];
        }
        (to, searched)
    }

    /// Axes go to their reference points; those that the machine has to search are at the first one behind it, wherever they
    /// were taken to be.
    fn home(&mut self, axes: AxisSet, searched: AxisSet) -> Fallible<()> {
        self.emit(Op::Home(axes));
        if !searched.is_empty() {
            let reference = self.memory.reference_points.first().copied().unwrap_or_default();
            for axis in searched.iter() {
                self.location.machine[axis] = reference[axis];
            }
            self.output.flush().map_err(|(fault, span)| self.alarm(fault, span))?;
            self.output.jump_to(self.location.machine);
            self.location.take_machine();
        }
        Ok(())
    }

    /// G74 (Fagor 1.1.1): each axis named goes to its first reference point. A cycle ends.
    pub(crate) fn home_search(&mut self, axes: AxisSet) -> Fallible<()> {
        if axes.is_empty() {
            return Err(self.alarm(Fault::ReferenceWithoutAxis, self.words.block_span()));
        }
        self.cancel_cycle();
        let (to, searched) = self.at_reference(axes, 1);
        self.output.suspend_cutter();
        self.rapid_machine(to)?;
        self.location.take_machine();
        self.home(axes, searched)
    }

    /// G30 Pn.
    pub(crate) fn further_reference_return(&mut self, axes: AxisSet) -> Fallible<()> {
        let number = self.words.get(b'P').unwrap_or(2.0);
        if !(2.0..=4.0).contains(&number) || number.fract() != 0.0 {
            return Err(self.alarm_at(Fault::ReferenceNumber, b'P'));
        }
        self.reference_return(axes, number as usize)
    }

    /// G29: back through the intermediate point (GSK990MC 4.3.3). An axis that no G28 or G30 named has none; the manual warns
    /// of what its control takes then (4.3.1), and the zero of the work coordinate system is nothing to go through.
    pub(crate) fn return_from_reference(&mut self, axes: AxisSet) -> Fallible<()> {
        let intermediate = self.intermediate;
        if let Some(axis) = axes.iter().find(|axis| !intermediate.known.contains(*axis)) {
            let alarm = self.alarm_at(Fault::IntermediateMissing, axis.letter() as u8);
            return Err(Box::new(alarm.with("axis", axis.letter().to_string())));
        }
        if intermediate.axes.is_empty() {
            return Err(self.alarm(Fault::IntermediateMissing, self.words.block_span()));
        }
        let mut through = self.location.programmed;
        for axis in intermediate.axes.iter().chain(axes.iter()) {
            through[axis] = intermediate.point[axis];
        }
        self.rapid_uncompensated(self.location.machine_of(through))?;
        self.location.programmed = through;
        // An incremental target counts from the intermediate point, where the tool now stands.
        let to = self.straight_end_point(axes);
        self.rapid(to)
    }

    /// G27: rapid to a machine position, which must be the reference point (GSK990MC 4.3.4).
    pub(crate) fn reference_check(&mut self, axes: AxisSet) -> Fallible<()> {
        let span = self.words.block_span();
        if axes.is_empty() {
            return Err(self.alarm(Fault::ReferenceWithoutAxis, span));
        }
        let inch_axes = self.inch_axes();
        let incremental = self.modal.is_incremental();
        let mut to = self.location.machine;
        for axis in axes.iter() {
            let Some(value) = self.words.get(axis.letter() as u8) else { continue };
            let value = units::coordinate(axis, value, inch_axes);
            // Compensation in force counts (4.3.4, 3).
            to[axis] = if incremental { to[axis] + value } else { value + self.location.length.vector[axis] };
        }
        self.rapid_machine(to)?;
        self.location.take_machine();
        // So does the vector of the cutter: what the stages hold ends here.
        self.output.flush().map_err(|(fault, span)| self.alarm(fault, span))?;
        let reached = self.output.commanded();
        let reference = self.memory.reference_points.first().copied().unwrap_or_default();
        match axes.iter().find(|axis| (reached[*axis] - reference[*axis]).abs() > AT_REFERENCE_MM) {
            None => Ok(()),
            Some(axis) => {
                let mut alarm = self.alarm_at(Fault::NotAtReference, axis.letter() as u8);
                alarm.arguments.push(("axis", axis.letter().to_string().into()));
                Err(alarm)
            }
        }
    }

    /// G31: a straight cut that ends where the skip signal comes (GSK990MC 4.2.16).
    pub(crate) fn skip(&mut self, axes: AxisSet, span: Span) -> Fallible<()> {
        if self.is_strictly_transformed() {
            return Err(self.alarm(Fault::SkipInTransform, span));
        }
        let to = self.end_point(axes);
        let from = self.location.machine;
        let aim = self.location.machine_of(to);
        let feed = self.feed_to(aim)?;
        self.check_reach(aim)?;
        // Where the simulated signal comes on the way, as a fraction of it.
        let at = self.options.skip.and_then(|(axis, at)| {
            let t = (at - from[axis]) / (aim[axis] - from[axis]);
            (0.0..=1.0).contains(&t).then_some(t)
        });
        let reached = at.map_or(aim, |t| from.lerp(aim, t));
        self.location.machine = reached;
        self.location.take_machine();
        // Without a signal the end of the block, as on Fanuc.
        self.location.skip = reached - self.location.work.shift;
        if reached != from || at.is_some() {
            self.emit(Op::Skip { to: reached, feed, hit: at.is_some(), away: false, input: None });
        }
        self.emit_barrier()?;
        match self.rules.skip_needs_signal && at.is_none() {
            true => self.miss_signal(span),
            false => Ok(()),
        }
    }

    /// G60: the end point is always reached from one side (GSK990MC 4.2.6).
    pub(crate) fn position_one_way(&mut self, axes: AxisSet) -> Fallible<()> {
        let to = self.end_point(axes);
        let mut beyond = Position::ZERO;
        for axis in axes.iter() {
            let index = self.rules.axis_order.iter().position(|a| *a == axis);
            let overshoot = index.and_then(|i| self.rules.one_way_overshoot.get(i)).copied().unwrap_or(0.0);
            beyond[axis] -= overshoot;
        }
        let dwell_s = self.rules.one_way_dwell_s;
        let machine = self.location.machine_of(to);
        if beyond != Position::ZERO && self.output.in_cutter_mode() && machine != self.location.machine {
            self.output.arrive_one_way(self.words.block_span(), OneWay { beyond, dwell_s });
        } else if beyond != Position::ZERO {
            self.rapid_machine(machine + beyond)?;
            if dwell_s > 0.0 {
                self.emit(Op::Dwell(Dwell::Seconds(dwell_s)));
            }
        }
        self.rapid(to)
    }
}
