//! What of the machine a front reads and changes: reference points, tables of pitch errors. Who may is judged by the
//! durable memory.

use super::{Control, alarm};
use crate::api::{ByAxis, Reply};
use ferrocut_geometry::{Axis, AxisSet};
use ferrocut_machine::servo::{PITCH_POINTS, PitchErrors};
use ferrocut_machine::{Alarm, Fault, Machine, ParameterKey};
use ferrocut_memory::{Author, Change, Level};
use std::collections::BTreeMap;

/// Tables of pitch errors by axis and point, mm.
pub(super) type Pitch = BTreeMap<(Axis, u16), f64>;

/// Most points that one command sets: what is committed together.
const MOST_POINTS: usize = 10_000;

/// The tables of a machine file, with what was set at the control over them.
pub(super) fn with_pitch(machine: &Machine, set: &Pitch) -> Machine {
    let mut machine = machine.clone();
    for axis in &mut machine.axes {
        for ((_, point), value) in set.range((axis.name, 0)..=(axis.name, u16::MAX)) {
            let point = usize::from(*point);
            if point >= PITCH_POINTS {
                continue;
            }
            let table = axis.pitch_errors.get_or_insert_with(PitchErrors::default);
            if table.corrections.len() <= point {
                table.corrections.resize(point + 1, 0.0);
            }
            if let Some(place) = table.corrections.get_mut(point) {
                *place = *value;
            }
        }
    }
    machine
}

/// The points of the tables of a machine file.
pub(super) fn points_of(machine: &Machine) -> Pitch {
    let points = machine.axes.iter().flat_map(|axis| {
        let table = axis.pitch_errors.iter().flat_map(|table| &table.corrections);
        (0u16..).zip(table).map(|(point, value)| ((axis.name, point), *value))
    });
    points.collect()
}

fn impossible(name: String) -> Box<Alarm> {
    Box::new(alarm(Fault::ValueImpossible).with("name", name))
}

impl Control {
    pub(super) fn reference_points(&self) -> Reply {
        let points = self.cnc.interpreter().memory().reference_points;
        Reply::ReferencePoints { points: (1u8..).zip(points.map(|point| self.by_axis(point))).collect() }
    }

    pub(super) fn set_reference_point(
        &mut self,
        number: u8,
        axes: &ByAxis,
        author: &Author,
    ) -> Result<Reply, Box<Alarm>> {
        self.may_set_parameters(author)?;
        let missing = || alarm(Fault::NoSuchName).with("name", number.to_string());
        let mut position = self.reference_point_asked(number).ok_or_else(missing)?;
        for (letter, value) in axes {
            let axis = self.axis_named(*letter)?;
            if !value.is_finite() {
                return Err(impossible(letter.to_string()));
            }
            position[axis] = *value;
        }
        self.change_data(author, Change::ReferencePoint { number, position })
    }

    /// GSK990MC 20#7: machine zero may be set by hand.
    pub(super) fn set_machine_zero(&mut self, axes: &[char], author: &Author) -> Result<Reply, Box<Alarm>> {
        self.needs_level(Level::Commissioning, author)?;
        self.may_set_parameters(author)?;
        let parameters = &self.cnc.interpreter().memory().parameters;
        let key = ParameterKey::Bit { number: 20, bit: 7 };
        if parameters.table().get(&key).is_none() || !self.bit(20, 7) {
            return Err(Box::new(alarm(Fault::NotFitted).with("name", "NO20.7")));
        }
        let axes = axes.iter().map(|letter| self.axis_named(*letter)).collect::<Result<AxisSet, _>>()?;
        if let Some(alarm) = self.locked_alarm() {
            return Err(alarm);
        }
        let (from, to) = (self.tick.position, self.reference_point_asked(1).unwrap_or_default());
        if !self.cnc.set_machine_zero(axes) {
            return Err(Box::new(alarm(Fault::ControlBusy)));
        }
        if let Some(keeping) = &mut self.keeping {
            let axes = axes.and(self.machine.axis_set());
            let set = |axis: Axis| Change::MachineZero { axis, from: from[axis], to: to[axis] };
            keeping.put(author, axes.iter().map(set).collect());
        }
        Ok(Reply::Done)
    }

    pub(super) fn pitch(&self, letter: char) -> Result<Reply, Box<Alarm>> {
        let axis = self.axis_named(letter)?;
        // What was set here lies over what the machine file has. The tables of the drives may be others until the next
        // start.
        let mut points = BTreeMap::new();
        for of in [&self.own_pitch, &self.pitch] {
            let of_axis = of.range((axis, 0)..=(axis, u16::MAX));
            points.extend(of_axis.map(|((_, point), value)| (*point, *value)));
        }
        points.retain(|_, value| *value != 0.0);
        Ok(Reply::Pitch { axis: letter, points })
    }

    pub(super) fn set_pitch(
        &mut self,
        letter: char,
        points: &BTreeMap<u16, f64>,
        author: &Author,
    ) -> Result<Reply, Box<Alarm>> {
        self.may_set_machine(author)?;
        let axis = self.axis_named(letter)?;
        let is_good = |(point, value): (&u16, &f64)| usize::from(*point) < PITCH_POINTS && value.is_finite();
        if let Some((point, _)) = points.iter().find(|point| !is_good(*point)) {
            return Err(impossible(format!("{letter} {point}")));
        }
        if points.len() > MOST_POINTS {
            return Err(impossible(points.len().to_string()));
        }
        let change = |(point, value): (&u16, &f64)| Change::Pitch { axis, point: *point, value: *value };
        match self.change_together(author, points.iter().map(change).collect())? {
            true => Ok(Reply::Done),
            false => Ok(Reply::OnItsWay),
        }
    }
}
