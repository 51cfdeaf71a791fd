//! Offsets, zeros, variables, parameters, relative coordinates and the spindle speed.

use super::super::status::counter_of;
use super::super::{Control, Standing, alarm};
use super::{Answer, MOST_VALUES, finite, named, within};
use crate::api::{ByAxis, OffsetValues, RelativeTo, Reply};
use ferrocut_geometry::{Axis, Position};
use ferrocut_interpreter::Shown;
use ferrocut_machine::{Alarm, Fault, ParameterKey, ToolOffset, WorkOffset};
use ferrocut_memory::{Author, Change};
use std::collections::BTreeSet;
use std::ops::RangeInclusive;

impl Control {
    pub(super) fn offsets(&self, from: u16, to: u16) -> Reply {
        let table = &self.cnc.interpreter().memory().tools;
        let values = |row: &ToolOffset| OffsetValues {
            length: Some(row.length),
            length_wear: Some(row.length_wear),
            radius: Some(row.radius),
            radius_wear: Some(row.radius_wear),
            cutting_length: Some(row.cutting_length),
            entry_angle: Some(row.entry_angle),
            tip_radius: Some(row.tip_radius),
        };
        let rows = (from..=to.min(table.last())).take(MOST_VALUES);
        let offsets = rows.filter_map(|number| Some((number, values(table.get(number)?)))).collect();
        Reply::Offsets { offsets }
    }

    pub(super) fn set_offset(
        &mut self,
        number: u16,
        values: OffsetValues,
        add: bool,
        author: &Author,
    ) -> Answer {
        let row = self.offset_asked(number).filter(|_| number > 0);
        let mut offset = row.ok_or_else(|| named(Fault::NoSuchName, number.to_string()))?;
        // P267.
        let most_wear = self.cnc.interpreter().rules().max_wear.min(MOST_ENTERED);
        let wear = || -most_wear..=most_wear;
        for (slot, value, range) in [
            (&mut offset.length, values.length, ENTERED),
            (&mut offset.length_wear, values.length_wear, wear()),
            (&mut offset.radius, values.radius, ENTERED),
            (&mut offset.radius_wear, values.radius_wear, wear()),
            (&mut offset.cutting_length, values.cutting_length, 0.0..=MOST_ENTERED),
            (&mut offset.entry_angle, values.entry_angle, 0.0..=90.0),
            (&mut offset.tip_radius, values.tip_radius, 0.0..=MOST_ENTERED),
        ] {
            if let Some(value) = value {
                let value = if add { *slot + value } else { value };
                *slot = within(value, range)?;
            }
        }
        let was = row.unwrap_or_default();
        let is_longer = (offset.length, offset.length_wear) != (was.length, was.length_wear);
        let is_wider = (offset.radius, offset.radius_wear) != (was.radius, was.radius_wear);
        let reply = self.change_data(author, Change::Offset { number, offset })?;
        self.tell_read_before(true, |shown| {
            is_longer && shown.length == Some(number) || is_wider && shown.radius == Some(f64::from(number))
        });
        Ok(reply)
    }

    /// A value was changed that blocks read ahead have as it was: whoever changed it is told up to where. One of an offset is in
    /// force as it was taken until it is programmed anew.
    fn tell_read_before(&mut self, takes: bool, uses: impl Fn(&Shown) -> bool) {
        if let Some(span) = self.cnc.read_with(takes, uses) {
            let warning = Alarm { span, ..alarm(Fault::ReadBefore) };
            self.tell_of(&warning.with("line", f64::from(span.line)).as_warning());
        }
    }

    pub(super) fn zeros(&self) -> Reply {
        let work = &self.cnc.interpreter().memory().work;
        let additional = u16::try_from(work.additional.len()).unwrap_or(u16::MAX);
        let names = [WorkOffset::External]
            .into_iter()
            .chain((1..=6).map(WorkOffset::Standard))
            .chain((1..=additional).map(WorkOffset::Additional));
        let zeros = names.filter_map(|name| Some((name.to_string(), self.by_axis(work.get(name)?))));
        Reply::Zeros { zeros: zeros.collect() }
    }

    pub(in crate::control) fn set_zero(
        &mut self,
        system: &str,
        axes: &ByAxis,
        add: bool,
        author: &Author,
    ) -> Answer {
        // 7.2: not while a program runs.
        if self.cnc.is_under_way() && self.standing() != Standing::Stopped {
            return Err(Box::new(alarm(Fault::ControlBusy)));
        }
        // 29#4 IWZ: nor while it is stopped.
        if self.cnc.is_under_way() && self.bit(29, 4) && matches!(author, Author::Person { .. }) {
            return Err(Box::new(alarm(Fault::ControlBusy)));
        }
        let (name, mut zero) = self.zero_of(system)?;
        // P10 to P44, as G10 L2 has it.
        let most = self.cnc.interpreter().rules().max_zero.min(*PLACES.end());
        for (letter, value) in axes {
            let axis = self.axis_named(*letter)?;
            zero[axis] = within(if add { zero[axis] + value } else { *value }, -most..=most)?;
        }
        let reply = self.change_data(author, Change::WorkZero { name, zero })?;
        self.tell_read_before(false, |shown| name == WorkOffset::External || shown.system == Some(name));
        Ok(reply)
    }

    pub(in crate::control) fn zero_of(&self, system: &str) -> Result<(WorkOffset, Position), Box<Alarm>> {
        let missing = || named(Fault::NoSuchName, system);
        let name: WorkOffset = system.parse().map_err(|_| missing())?;
        Ok((name, self.zero_asked(name).ok_or_else(missing)?))
    }

    /// The axis at rest has this coordinate in the system, other shifts aside, but in RS274/NGC, which has its own touch off. Or the
    /// value is `typed` as the page of the zeros takes it: X10 is the machine coordinate + 10 (3.4.2), with 10#5 it is taken off.
    pub(super) fn zero_here(&mut self, system: &str, axes: &ByAxis, typed: bool, author: &Author) -> Answer {
        if self.tick.moving {
            return Err(Box::new(alarm(Fault::ControlBusy)));
        }
        if !typed && let Some(zero) = self.touched_off(system, axes)? {
            return self.set_zero(system, &zero, false, author);
        }
        let adds = typed && !self.bit(10, 5);
        let mut wanted = ByAxis::new();
        for (letter, value) in axes {
            let axis = self.axis_named(*letter)?;
            let value = if adds { *value } else { -value };
            wanted.insert(*letter, self.tick.position[axis] + value);
        }
        let wanted = self.without_external(system, wanted)?;
        self.set_zero(system, &wanted, false, author)
    }

    /// The zero with which the axes have these coordinates, tool length, turn and G92 included, where the language has it so.
    fn touched_off(&self, system: &str, axes: &ByAxis) -> Result<Option<ByAxis>, Box<Alarm>> {
        let (name, _) = self.zero_of(system)?;
        let mut coordinates = Vec::with_capacity(axes.len());
        for (letter, value) in axes {
            coordinates.push((self.axis_named(*letter)?, *value));
        }
        let free = self.tick.position - self.cnc.tool_length();
        let interpreter = self.cnc.interpreter();
        let before = interpreter.memory().work.get(name).unwrap_or_default();
        let Some(zero) = interpreter.touched_off(name, free, &coordinates) else { return Ok(None) };
        // What is not named and stays may be on its way to another value.
        let sets = |axis: Axis| axes.contains_key(&axis.letter()) || zero[axis] != before[axis];
        let own = self.machine.axes.iter().map(|axis| axis.name).filter(|axis| sets(*axis));
        Ok(Some(own.map(|axis| (axis.letter(), zero[axis])).collect()))
    }

    /// Machine positions of a zero, as the zero of a system that the external one is added to.
    pub(in crate::control) fn without_external(
        &self,
        system: &str,
        zeros: ByAxis,
    ) -> Result<ByAxis, Box<Alarm>> {
        let (name, _) = self.zero_of(system)?;
        let external = self.zero_asked(WorkOffset::External).unwrap_or_default();
        let external = if name == WorkOffset::External { Position::ZERO } else { external };
        let less = |(letter, at)| Ok((letter, at - external[self.axis_named(letter)?]));
        zeros.into_iter().map(less).collect()
    }

    pub(super) fn variables(&self, from: u32, to: u32) -> Reply {
        let all = self.cnc.interpreter().memory().variables.iter();
        let within = all.filter(|(number, _)| (from..=to).contains(number));
        Reply::Variables { variables: within.take(MOST_VALUES).collect() }
    }

    pub(super) fn parameters(&mut self, names: &[String]) -> Answer {
        // Who asks for some wants their values, at any time.
        let left: BTreeSet<ParameterKey> = match names.is_empty() {
            true => self.left_to_file().into_iter().collect(),
            false => BTreeSet::new(),
        };
        let memory = self.cnc.interpreter().memory();
        let table = memory.parameters.table();
        // By the names that they were asked for by.
        let mut asked: Vec<(ParameterKey, String)> = Vec::new();
        if names.is_empty() {
            asked.extend(table.iter().map(|row| (row.key.clone(), table.name(&row.key))));
        }
        for name in names.iter().take(MOST_VALUES) {
            let key: ParameterKey = name.parse().map_err(|_| named(Fault::NoSuchName, name.as_str()))?;
            if table.get(&key).is_none() {
                return Err(Box::new(named(Fault::NoSuchName, name.as_str())));
            }
            asked.push((key, name.clone()));
        }
        let of = |is: &dyn Fn(&ParameterKey) -> bool| -> Vec<String> {
            asked.iter().filter(|(key, _)| is(key)).map(|(_, name)| name.clone()).collect()
        };
        let (given, left_to_file) =
            (of(&|key| memory.parameters.is_given(key)), of(&|key| left.contains(key)));
        let parameters = asked.iter().map(|(key, name)| (name.clone(), memory.parameter(key))).collect();
        Ok(Reply::Parameters { parameters, given, left_to_file })
    }

    pub(super) fn set_parameter(&mut self, name: &str, value: Option<f64>, author: &Author) -> Answer {
        let key: ParameterKey = name.parse().map_err(|_| named(Fault::NoSuchName, name))?;
        match self.is_setting(&key) {
            true => self.may_set_machine(author)?,
            false => self.may_set_parameters(author)?,
        }
        if let Some(value) = finite(value)? {
            let parameters = &self.cnc.interpreter().memory().parameters;
            parameters.check(&key, value).map_err(|error| error.alarm())?;
        }
        let mut changes = vec![Change::Parameter { key: key.clone(), value }];
        if let Some((counter, unit)) = counter_of(&key) {
            // The counter is what is kept of it.
            changes.push(Change::Counter { counter, value: value.unwrap_or_default() * unit });
        }
        self.change_data_together(author, changes)
    }

    pub(in crate::control) fn axis_named(&self, letter: char) -> Result<Axis, Box<Alarm>> {
        let axis = u8::try_from(letter).ok().and_then(Axis::from_letter);
        let axis = axis.filter(|axis| self.machine.axis(*axis).is_some());
        axis.ok_or_else(|| Box::new(alarm(Fault::UnknownAxis).with("axis", letter.to_string())))
    }

    /// 4.1.5: where the axis stands becomes 0, half, or a value.
    pub(super) fn set_relative(&mut self, letter: char, to: RelativeTo) -> Answer {
        let axis = self.axis_named(letter)?;
        let place = self.tick.position[axis] - self.cnc.handwheel_shift()[axis];
        let relative = match to {
            RelativeTo::Zero => 0.0,
            RelativeTo::Half => (place - self.origin[axis]) / 2.0,
            RelativeTo::Value(value) => within(value, PLACES)?,
        };
        self.origin[axis] = place - relative;
        Ok(Reply::Done)
    }

    /// 3.1.2: S from 0 to P258 is set at the cursor of the page, which the manual binds to no mode. A program under way
    /// has its own.
    pub(super) fn set_spindle_speed(&mut self, speed: f64) -> Answer {
        let interpreter = self.cnc.interpreter();
        let highest = match interpreter.is_surface_speed() {
            true => HIGHEST_SURFACE_SPEED,
            false => interpreter.max_spindle_rpm(),
        };
        let speed = within(speed, 0.0..=highest)?;
        match self.cnc.set_spindle_speed(speed) {
            true => Ok(Reply::Done),
            false => Err(Box::new(alarm(Fault::ControlBusy))),
        }
    }
}

/// What an offset is at most, mm (GSK990MC part 2, 3.4.3.2): more is a decimal point that was forgotten.
const MOST_ENTERED: f64 = 9_999.999_9;
const ENTERED: RangeInclusive<f64> = -MOST_ENTERED..=MOST_ENTERED;

/// Where a relative coordinate may lie: the range of positions, mm and degrees (GSK990MC part 1, 1.2).
const PLACES: RangeInclusive<f64> = -99_999.999_9..=99_999.999_9;

/// The highest S under G96, mm/min or inch/min.
const HIGHEST_SURFACE_SPEED: f64 = 99_999_999.0;
