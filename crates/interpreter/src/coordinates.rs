//! Codes that change how a programmed point becomes a machine point: polar coordinates, scaling,
//! rotation, work coordinate systems, G92.

use crate::Fallible;
use crate::dialect::Meaning;
use crate::interpreter::Interpreter;
use crate::modal::Group;
use crate::motion::near_way;
use crate::stages::polar::{self, Polar};
use crate::stages::rotation::Rotation;
use crate::stages::scaling::Scaling;
use crate::stages::work_offset::{System, WorkSystem};
use crate::stages::{distance, units};
use crate::words::letters;
use ferrocut_geometry::{Axis, AxisSet, Position, SAME_POINT_MM};
use ferrocut_machine::{Alarm, Fault, WorkOffset};
use ferrocut_program::Span;
use std::ops::RangeInclusive;

/// Smallest and largest factor of scaling (GSK990MC table 3-1-3-1, P330).
const FACTOR: RangeInclusive<f64> = 0.0001..=9999.9999;

const CENTER_LETTERS: u32 = letters(b"IJK");

/// What G92 moves so that the tool stands at the given point.
#[derive(Clone, Copy, PartialEq, Eq, Debug, Default)]
pub enum SetPosition {
    /// Every system, until G92 again or power-off (Fanuc).
    #[default]
    EverySystem,
    /// Nothing: it makes a system of its own, which the call of another ends (GSK990MC 4.2.11).
    OwnSystem,
    /// The table of systems, for good (Weihong 4.3).
    Table,
}

/// What controls do differently with coordinate systems and transformations. The default is Fanuc's.
#[derive(Clone, Copy, PartialEq, Eq, Debug, Default)]
pub struct Rules {
    /// Scaling, mirror and rotation are a stack; else each is in force once, scaling before rotation.
    pub transforms_nest: bool,
    /// What G92 moves.
    pub set_position: SetPosition,
    /// G53 moves by the motion code in force; else at rapid, and with G91 not at all.
    pub machine_position_by_motion: bool,
    /// G28 leaves tool length compensation in force.
    pub reference_keeps_length: bool,
    /// G28 may stand while a canned cycle is in force.
    pub reference_in_cycle: bool,
}

impl Interpreter {
    /// The axes whose words are inches.
    #[inline]
    pub(crate) fn inch_axes(&self) -> AxisSet {
        if self.modal.is_inch() { self.rules.linear_axes } else { AxisSet::EMPTY }
    }

    /// The end point of the block as one of X, Y, Z, also where polar coordinates are in force.
    pub(crate) fn straight_end_point(&self, axes: AxisSet) -> Position {
        let incremental = self.modal.is_incremental();
        distance::end_point(&self.words, axes, self.location.programmed, incremental, self.inch_axes())
    }

    /// The programmed end point of the block.
    #[inline]
    pub(crate) fn end_point(&mut self, axes: AxisSet) -> Position {
        let incremental = self.modal.is_incremental();
        let mut to = self.location.programmed;
        distance::go_on(&mut to, &self.words, axes, incremental, self.inch_axes());
        if !incremental {
            let from = self.location.programmed;
            for axis in axes.and(self.rules.motion.near_way).iter() {
                to[axis] = near_way(from[axis], to[axis]);
            }
        }
        if self.location.polar.is_some() {
            self.polar_end_point(&mut to, incremental);
        }
        to
    }

    fn polar_end_point(&mut self, to: &mut Position, incremental: bool) {
        let (from, plane) = (self.location.programmed, self.modal.plane());
        let Some(polar) = &mut self.location.polar else { return };
        let (radius, angle) = polar::addresses(plane);
        let radius = self.words.get(radius).map(|r| units::length_mm(r, self.modal.is_inch()));
        let angle = self.words.get(angle);
        if radius.is_some() || angle.is_some() {
            let [a, b] = polar.point(plane.of(from), radius, angle, incremental);
            to[plane.first()] = a;
            to[plane.second()] = b;
        }
    }

    /// G16 and G15.
    pub(crate) fn polar(&mut self, meaning: Meaning) {
        self.location.polar = match meaning {
            Meaning::PolarOn => {
                let here = self.modal.plane().of(self.location.programmed);
                Some(Polar::new(self.rules.pole, here, self.modal.is_incremental()))
            }
            _ => None,
        };
    }

    /// The given coordinates of a centre, those of `here` where they are not given. They are work
    /// coordinates, also with G91 and in polar mode.
    fn center(&self, here: Position) -> Position {
        let axes = self.words.axes(self.rules.axes);
        distance::end_point(&self.words, axes, here, false, self.inch_axes())
    }

    /// G51 (GSK990MC 4.2.14).
    pub(crate) fn scale(&mut self, span: Span) -> Fallible<()> {
        if !self.rules.scaling.enabled {
            return Err(self.alarm(Fault::ScalingDisabled, span));
        }
        let by_axis = match (self.words.has(b'P'), self.words.has_any(CENTER_LETTERS)) {
            (true, false) => false,
            (false, true) => true,
            _ => self.rules.scaling.factors_by_axis,
        };
        // Where the tool is (4.2.14, 1), also while scaling is in force; rotation comes behind it.
        let here = self.location.in_work();
        let here = self.location.rotation.map_or(here, |rotation| rotation.undo(here));
        let [x, y, z, ..] = self.center(here).0;
        let mut factors = [1.0; 3];
        for (index, letter) in (0..).zip([b'I', b'J', b'K']) {
            let given = self.words.get(if by_axis { letter } else { b'P' });
            let standard = match by_axis {
                true => self.rules.scaling.axis_factors.get(index).copied().unwrap_or(1.0),
                false => self.rules.scaling.factor,
            };
            let factor = given.unwrap_or(standard);
            if !FACTOR.contains(&factor.abs()) {
                return Err(self.scale_factor(if by_axis { letter } else { b'P' }, &FACTOR));
            }
            let acts = self.rules.scaling.axes.get(index).copied().unwrap_or(false);
            if let Some(slot) = factors.get_mut(index).filter(|_| acts) {
                *slot = factor;
            }
        }
        self.location.scaling = Some(Scaling { center: [x, y, z], factors });
        Ok(())
    }

    /// A factor outside the control's range.
    pub(crate) fn scale_factor(&self, letter: u8, range: &RangeInclusive<f64>) -> Box<Alarm> {
        // As text: the smallest have more places than numbers are shown with.
        let alarm = self.alarm_at(Fault::ScaleFactor, letter);
        Box::new(alarm.with("min", range.start().to_string()).with("max", range.end().to_string()))
    }

    /// G50: the tool stands where it stands.
    pub(crate) fn scale_off(&mut self) {
        if self.location.scaling.take().is_some() {
            self.location.take_machine();
        }
    }

    /// G68 (GSK990MC 4.2.15, Kaitong appendix 10).
    pub(crate) fn rotate(&mut self) -> Fallible<()> {
        let plane = self.modal.plane();
        // Where the tool is, also while rotation is in force (Kaitong appendix 10).
        let here = self.location.in_work();
        let here = self.location.scaling.map_or(here, |scaling| scaling.undo(here));
        let center = self.center(here);
        // The centre is scaled too, the angle is not.
        let center = plane.of(self.location.scaling.map_or(center, |scaling| scaling.apply(center)));
        let given = self.words.get(b'R').unwrap_or(self.rules.rotation_angle);
        let limit = self.rules.max_rotation;
        if given.abs() > limit {
            let alarm = self.alarm_at(Fault::WordOutOfRange, b'R');
            return Err(Box::new(alarm.with("min", -limit).with("max", limit)));
        }
        // One axis mirrored in the plane turns the other way round (4.2.14 note 2).
        let mirrored = self.location.scaling.is_some_and(|scaling| scaling.reverses(plane));
        let given = if mirrored { -given } else { given };
        let adds = self.rules.rotation_follows_g91 && self.modal.is_incremental();
        let before = self.location.rotation.map_or(0.0, |rotation| rotation.degrees);
        let degrees = if adds { before + given } else { given };
        self.location.rotation = Some(Rotation { plane, center, degrees });
        Ok(())
    }

    /// Behind G51 or G68 the tool is not on the changed shape yet. A block that names no axis of the plane moves none of them, as on a
    /// Fanuc: a plunge, and a tool length that comes or goes, lead straight along the tool axis. Nor does that axis move unnamed.
    pub(crate) fn stay_where_not_named(&mut self, axes: AxisSet, length_changes: bool) {
        let plane = match (self.location.rotation, self.location.scaling) {
            (Some(rotation), _) => rotation.plane,
            (None, Some(_)) => self.modal.plane(),
            (None, None) => return,
        };
        let acts = !axes.is_empty() || length_changes || self.cycle_kind().is_some() || self.words.has(b'H');
        if !acts {
            return;
        }
        let (aimed, here) = (self.location.machine_of(self.location.programmed), self.location.machine);
        for together in [&[plane.first(), plane.second()][..], &[plane.normal()]] {
            let is_named = together.iter().any(|axis| axes.contains(*axis));
            let is_off = together.iter().any(|axis| (aimed[*axis] - here[*axis]).abs() > SAME_POINT_MM);
            if is_off && !is_named {
                self.location.take_machine_of(together);
            }
        }
    }

    /// G69: the tool stands where it stands.
    pub(crate) fn rotate_off(&mut self) {
        if self.location.rotation.take().is_some() {
            self.location.take_machine();
        }
    }

    /// Codes of reference points and coordinate systems are not allowed while scaling or rotation is in
    /// force, nor on some controls while polar coordinates are.
    pub(crate) fn refuse_in_transform(&self, span: Span) -> Fallible<()> {
        let location = &self.location;
        if location.scaling.is_some() {
            return Err(self.alarm(Fault::CodeInScaling, span));
        }
        if location.rotation.is_some() {
            return Err(self.alarm(Fault::CodeInRotation, span));
        }
        if location.polar.is_some() && self.rules.polar_is_strict {
            return Err(self.alarm(Fault::CodeInPolar, span));
        }
        Ok(())
    }

    /// G54 to G59 and G54 P.
    pub(crate) fn select_work_offset(&mut self, meaning: Meaning, span: Span) -> Fallible<()> {
        let Meaning::WorkOffset(standard) = meaning else { return Ok(()) };
        self.refuse_in_transform(span)?;
        if self.output.in_cutter_mode() {
            return Err(self.alarm(Fault::WorkOffsetInCutter, span));
        }
        let name = match self.words.get(b'P') {
            Some(number)
                if standard == 1 && !self.p_is_taken(meaning) && !self.memory.work.additional.is_empty() =>
            {
                self.words.take(b'P');
                if !(1.0..=f64::from(u16::MAX)).contains(&number) || number.fract() != 0.0 {
                    return Err(self.alarm(Fault::WorkOffsetNumber, span));
                }
                WorkOffset::Additional(number as u16)
            }
            _ => WorkOffset::Standard(standard),
        };
        let Some(system) = WorkSystem::select(name, &self.memory.work, &self.location.work) else {
            return Err(self.alarm(Fault::WorkOffsetNumber, span));
        };
        if system != self.location.work {
            self.refuse_in_corner()?;
        }
        self.location.work = system;
        // The axes stand still; their coordinates are those of the new system (GSK990MC 4.2.8).
        self.location.take_machine();
        Ok(())
    }

    /// Whether another code of the block than `by` has P for its own: a call, a dwell, a cycle, G30, G51, G96, and what only
    /// Weihong has (4.3).
    pub(crate) fn p_is_taken(&self, by: Meaning) -> bool {
        let takes = |meaning| {
            use Meaning::{Call, Cycle, Dwell, FurtherReferenceReturn, Pattern, ScalingOn};
            use Meaning::{SetToolLength, SetWorkZero, SurfaceSpeed};
            meaning != by
                && match meaning {
                    Cycle(kind) => kind.takes_p(),
                    Dwell | FurtherReferenceReturn | ScalingOn | SurfaceSpeed => true,
                    Call | Pattern(_) | SetToolLength | SetWorkZero => true,
                    _ => false,
                }
        };
        self.words.calls() || self.words.g.iter().any(|code| takes(code.row.meaning))
    }

    /// Between a corner and its second move the coordinates stay (GSK990MC alarm 0051, Fanuc).
    pub(crate) fn refuse_in_corner(&mut self) -> Fallible<()> {
        self.output.move_is_missing().map_err(|(fault, span)| self.alarm(fault, span))
    }

    /// G92 (GSK990MC 4.2.11): the point where the tool stands, tool length left aside, gets the given
    /// coordinates.
    pub(crate) fn set_position(&mut self, axes: AxisSet) {
        if axes.is_empty() {
            return;
        }
        if self.rules.coordinates.set_position == SetPosition::Table {
            let moved = self.moved_zero(axes);
            for zero in &mut self.memory.work.standard {
                *zero = *zero + moved;
            }
            self.variable_writes += 1;
            return self.work_zero_changed();
        }
        let inch_axes = self.inch_axes();
        let location = &mut self.location;
        let here = distance::end_point(&self.words, axes, location.programmed, false, inch_axes);
        let at = location.machine - location.length.vector;
        location.work = match self.rules.coordinates.set_position {
            SetPosition::EverySystem => location.work.move_every_system(at, here, axes),
            _ => location.work.set_position(at, here, axes),
        };
        location.take_machine();
    }

    /// How far the zero has to move for the point where the tool stands, tool length left aside, to get the
    /// given coordinates.
    fn moved_zero(&self, axes: AxisSet) -> Position {
        let location = &self.location;
        let here = distance::end_point(&self.words, axes, location.programmed, false, self.inch_axes());
        let here = location.nested.map_or(here, |nested| nested.apply(here));
        location.in_work() - here
    }

    /// G921 (Weihong 4.3): as G92, for the system in force alone.
    pub(crate) fn set_position_of_one(&mut self, axes: AxisSet) -> Fallible<()> {
        let System::Table(name) = self.location.work.system else { return Ok(()) };
        let moved = self.moved_zero(axes);
        if let Some(zero) = self.memory.work.get_mut(name) {
            *zero = *zero + moved;
        }
        self.variable_writes += 1;
        self.work_zero_changed();
        Ok(())
    }

    /// G992 (Weihong 4.3): X, Y, Z as G92, I, J, K move the zeros by themselves; of every system, and for
    /// this program alone.
    pub(crate) fn set_position_for_now(&mut self, axes: AxisSet) {
        let mut moved = self.moved_zero(axes);
        let inch = self.modal.is_inch();
        for (axis, letter) in [(Axis::X, b'I'), (Axis::Y, b'J'), (Axis::Z, b'K')] {
            moved[axis] += self.words.get(letter).map_or(0.0, |v| units::length_mm(v, inch));
        }
        let work = self.location.work;
        self.location.work = work.with_local(work.local + moved);
        self.location.take_machine();
    }

    /// G922 (Weihong 4.3): machine position of a zero. P-4 is the external offset, P-1 or none the system in
    /// force, P0 to P5 G54 to G59.
    pub(crate) fn set_zero_word(&mut self, axes: AxisSet) -> Fallible<()> {
        let number = self.words.get(b'P').unwrap_or(-1.0);
        let name = match (number, self.location.work.system) {
            (-4.0, _) => Some(WorkOffset::External),
            (-1.0, System::Table(name)) => Some(name),
            (n, _) if (0.0..=5.0).contains(&n) && n.fract() == 0.0 => Some(WorkOffset::Standard(n as u8 + 1)),
            _ => None,
        };
        let inch = self.inch_axes();
        let Some(zero) = name.and_then(|name| self.memory.work.get_mut(name)) else {
            return Err(self.alarm_at(Fault::DataNumber, b'P'));
        };
        *zero = distance::end_point(&self.words, axes, *zero, false, inch);
        self.variable_writes += 1;
        self.work_zero_changed();
        self.tell_unused(*b"IJKLQR");
        if axes.is_empty() {
            self.tell_unused(*b"P");
        }
        Ok(())
    }

    /// G923 (Weihong 4.3): length of tool P, or of the one in use. It acts when its number is called next.
    /// X and Y have nothing to act on: G43 and G44 know Z alone.
    pub(crate) fn set_tool_length(&mut self) -> Fallible<()> {
        let number = self.words.get(b'P').unwrap_or(f64::from(self.technology.tool));
        self.tell_unused(*b"ABCIJKLQR");
        let Some(z) = self.words.get(b'Z') else {
            self.tell_unused(*b"P");
            return Ok(());
        };
        let length = units::length_mm(z, self.modal.is_inch());
        if length.abs() > self.rules.max_offset {
            return Err(self.alarm_at(Fault::OffsetTooLarge, b'Z'));
        }
        let whole =
            (number.fract() == 0.0 && (0.0..=f64::from(u16::MAX)).contains(&number)).then_some(number as u16);
        let Some(row) = whole.and_then(|number| self.memory.tools.get_mut(number)) else {
            return Err(self.alarm_at(Fault::OffsetNumber, b'P'));
        };
        row.length = length;
        row.length_wear = 0.0;
        self.variable_writes += 1;
        Ok(())
    }

    /// G52 (Fanuc): the zero of every work coordinate system is moved by the given coordinates, whatever it
    /// was moved by before. The axes stand still.
    pub(crate) fn local_zero(&mut self, axes: AxisSet) {
        let inch_axes = self.inch_axes();
        let location = &mut self.location;
        let local = distance::end_point(&self.words, axes, location.work.local, false, inch_axes);
        location.work = location.work.with_local(local);
        location.take_machine();
    }

    /// G53 (GSK990MC 4.2.10): rapid to a machine position, tool length left aside. With G91 the block
    /// does nothing, as on Fanuc, and a check tells so.
    pub(crate) fn machine_position(&mut self, axes: AxisSet) -> Fallible<()> {
        if self.rules.coordinates.machine_position_by_motion {
            return self.machine_move(axes);
        }
        if self.modal.is_incremental() {
            self.tell_unused(axes.iter().map(|axis| axis.letter() as u8));
            return Ok(());
        }
        let machine = self.location.machine;
        let to = distance::end_point(&self.words, axes, machine, false, self.inch_axes());
        self.rapid_uncompensated(to)?;
        self.location.take_machine();
        Ok(())
    }

    /// G53 (Weihong 4.3): the block's move without work offset, transformations and tool length, straight
    /// and by the motion code in force. An arc has no such form.
    fn machine_move(&mut self, axes: AxisSet) -> Fallible<()> {
        let (machine, incremental) = (self.location.machine, self.modal.is_incremental());
        let to = distance::end_point(&self.words, axes, machine, incremental, self.inch_axes());
        self.output.suspend_cutter();
        match self.modal.meaning(Group::Motion) {
            Meaning::Rapid => self.rapid_machine(to)?,
            Meaning::Linear => self.cut_machine(to)?,
            _ => return Err(self.alarm(Fault::ArcInMachine, self.words.block_span())),
        }
        self.location.take_machine();
        Ok(())
    }

    /// Scaling leaves the tool axis of a canned cycle alone (GSK990MC 4.2.14 limit 1, 4.4 note 2): from
    /// here to [`scale_tool_axis_again`](Self::scale_tool_axis_again) the factor of Z is 1.
    pub(crate) fn leave_tool_axis_unscaled(&mut self) {
        if let Some(scaling) = &mut self.location.scaling {
            let [.., z] = &mut scaling.factors;
            if *z != 1.0 {
                self.cycle.z_factor = Some(*z);
                *z = 1.0;
                self.location.take_machine_of(&[Axis::Z]);
            }
        }
    }

    /// Puts the factor of Z back.
    pub(crate) fn scale_tool_axis_again(&mut self) {
        if let Some(factor) = self.cycle.z_factor.take()
            && let Some(scaling) = &mut self.location.scaling
        {
            let [.., z] = &mut scaling.factors;
            *z = factor;
            self.location.take_machine_of(&[Axis::Z]);
        }
    }

    /// Whether a plane change must be refused, and with which rule.
    pub(crate) fn plane_change_fault(&self) -> Option<Fault> {
        if self.technology.rigid_tapping {
            return Some(Fault::PlaneInRigidTapping);
        }
        if self.cycle.is_active() && !self.rules.cycles.in_any_plane {
            return Some(Fault::PlaneInCycle);
        }
        if self.output.in_cutter_mode() {
            return Some(Fault::PlaneInCutter);
        }
        if self.location.rotation.is_some() {
            return Some(Fault::PlaneInRotation);
        }
        // A block that begins them again has its own plane (Kaitong appendix 9).
        let begins_again = !self.rules.polar_is_strict
            && self.words.g.iter().any(|code| code.row.meaning == Meaning::PolarOn);
        (self.location.polar.is_some() && !begins_again).then_some(Fault::CodeInPolar)
    }

    /// The tool axis of cycles and of tool length method A.
    pub(crate) fn length_axis(&self) -> Axis {
        match self.rules.length_on_plane_normal {
            true => self.modal.plane().normal(),
            false => Axis::Z,
        }
    }

    /// Whether the control refuses what would change the points that are being transformed.
    pub(crate) fn is_strictly_transformed(&self) -> bool {
        self.rules.transforms_are_strict && (self.is_transformed() || self.location.polar.is_some())
    }

    /// Whether any transformation beyond offsets is in force.
    pub(crate) fn is_transformed(&self) -> bool {
        self.location.scaling.is_some() || self.location.rotation.is_some() || self.location.nested.is_some()
    }

    /// Whether the group's code in force is this one.
    pub(crate) fn in_force(&self, group: Group, meaning: Meaning) -> bool {
        self.modal.meaning(group) == meaning
    }
}
