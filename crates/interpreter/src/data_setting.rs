//! G10 and G11: offsets, work zeros and parameters set by the program (GSK990MC 4.2.7).

use crate::Fallible;
use crate::interpreter::Interpreter;
use crate::stages::units;
use crate::words;
use ferrocut_geometry::AxisSet;
use ferrocut_machine::{Fault, ParameterError, ParameterKey, WorkOffset};
use ferrocut_program::Span;

/// What the blocks between G10 L50 or L51 and G11 set.
#[derive(Clone, Copy, PartialEq, Eq, Debug)]
pub(crate) enum DataSetting {
    /// L50: N parameter, P bit, R value.
    Bits,
    /// L51: N parameter, R value.
    Data,
}

impl Interpreter {
    /// A block with G10.
    pub(crate) fn set_data(&mut self, axes: AxisSet, span: Span) -> Fallible<()> {
        if self.cycle_kind().is_some() {
            return Err(self.alarm(Fault::DataSettingInCycle, span));
        }
        if self.words.g.len() > 1 {
            return Err(self.alarm(Fault::NeedsOwnBlock, span));
        }
        let form = self.words.get(b'L');
        // Axes have work zeros alone (4.2.7 note 2).
        if !axes.is_empty() && matches!(form, Some(10.0..=13.0 | 50.0 | 51.0)) {
            return Err(self.alarm(Fault::NeedsOwnBlock, self.words.block_span()));
        }
        // Parameters may be set: those of the coordinate systems are looked at one by one.
        if !matches!(form, Some(50.0 | 51.0)) {
            self.refuse_in_corner()?;
            if self.is_strictly_transformed() {
                return Err(self.alarm(Fault::OffsetInTransform, span));
            }
        }
        self.technology.data_code = 10.0;
        match form.map(|l| l as i64) {
            Some(2) => {
                let name = match self.offset_number(0.0, 6.0)? {
                    0 => WorkOffset::External,
                    n => WorkOffset::Standard(n as u8),
                };
                self.set_work_zero(name, axes)
            }
            Some(20) => {
                let last = self.memory.work.additional.len() as f64;
                let number = self.offset_number(1.0, last)?;
                self.set_work_zero(WorkOffset::Additional(number), axes)
            }
            Some(form @ 10..=13) => self.set_tool_offset(form),
            Some(50) => self.start_parameters(DataSetting::Bits),
            Some(51) => self.start_parameters(DataSetting::Data),
            _ => Err(self.alarm(Fault::DataForm, if form.is_some() { self.words.span(b'L') } else { span })),
        }
    }

    /// P of G10: the number of what is set.
    fn offset_number(&self, min: f64, max: f64) -> Fallible<u16> {
        match self.words.get(b'P') {
            Some(p) if (min..=max).contains(&p) && p.fract() == 0.0 => Ok(p as u16),
            _ => Err(self.alarm_at(Fault::DataNumber, b'P')),
        }
    }

    /// G10 L2 and L20: G90 replaces, G91 adds (4.2.7 note 7).
    fn set_work_zero(&mut self, name: WorkOffset, axes: AxisSet) -> Fallible<()> {
        let (inch_axes, incremental) = (self.inch_axes(), self.modal.is_incremental());
        let Some(mut zero) = self.memory.work.get(name) else {
            return Err(self.alarm_at(Fault::DataNumber, b'P'));
        };
        if axes.is_empty() {
            return Err(self.alarm(Fault::DataValue, self.words.block_span()));
        }
        for axis in axes.iter() {
            let Some(value) = self.words.get(axis.letter() as u8) else { continue };
            let value = units::coordinate(axis, value, inch_axes);
            zero[axis] = if incremental { zero[axis] + value } else { value };
            if zero[axis].abs() > self.rules.max_zero {
                return Err(self.alarm_at(Fault::DataValue, axis.letter() as u8));
            }
        }
        if let Some(slot) = self.memory.work.get_mut(name) {
            *slot = zero;
        }
        self.variable_writes += 1;
        self.work_zero_changed();
        Ok(())
    }

    /// G10 L10 to L13: length, its wear, radius, its wear. It acts when its H or D is next called.
    fn set_tool_offset(&mut self, form: i64) -> Fallible<()> {
        let number = self.offset_number(1.0, f64::from(self.memory.tools.last()))?;
        let Some(value) = self.words.get(b'R') else {
            return Err(self.alarm_at(Fault::DataValue, b'R'));
        };
        let value = units::length_mm(value, self.modal.is_inch());
        let incremental = self.modal.is_incremental();
        let limit = if matches!(form, 11 | 13) { self.rules.max_wear } else { self.rules.max_offset };
        let Some(row) = self.memory.tools.get_mut(number) else {
            return Err(self.alarm_at(Fault::DataNumber, b'P'));
        };
        let slot = match form {
            10 => &mut row.length,
            11 => &mut row.length_wear,
            12 => &mut row.radius,
            _ => &mut row.radius_wear,
        };
        let value = if incremental { *slot + value } else { value };
        if value.abs() > limit {
            return Err(self.alarm_at(Fault::DataValue, b'R'));
        }
        *slot = value;
        self.variable_writes += 1;
        Ok(())
    }

    fn start_parameters(&mut self, what: DataSetting) -> Fallible<()> {
        self.data_setting = Some(what);
        // The block of G10 itself may hold the first parameter. N before G10 is none: editors number every line.
        match self.words.has(b'R') || self.words.has(b'P') || self.words.sequence_of_data {
            true => self.set_parameter(what),
            false => Ok(()),
        }
    }

    /// A block between G10 L50 or L51 and G11.
    pub(crate) fn data_block(&mut self, what: DataSetting) -> Fallible<()> {
        let own = words::letters(b"NPR");
        if !self.words.g.is_empty() || !self.words.m.is_empty() || self.words.has_any(!own) {
            return Err(self.alarm(Fault::CommandInDataSetting, self.words.block_span()));
        }
        if self.words.sequence.is_none() && !self.words.has(b'R') && !self.words.has(b'P') {
            return Ok(());
        }
        self.set_parameter(what)
    }

    /// N, P and R of a parameter. N is no sequence number here (GSK990MC 3.1.2).
    fn set_parameter(&mut self, what: DataSetting) -> Fallible<()> {
        let span = self.words.block_span();
        let whole = |v: f64, max: f64| (v.fract() == 0.0 && (0.0..=max).contains(&v)).then_some(v as u16);
        let number = self.words.sequence.and_then(|n| whole(n, 9999.0));
        let bit = self.words.get(b'P').and_then(|p| whole(p, 7.0)).and_then(|p| u8::try_from(p).ok());
        let key = match (what, number, bit) {
            (DataSetting::Data, Some(number), _) => ParameterKey::Data(number),
            (DataSetting::Bits, Some(number), Some(bit)) => ParameterKey::Bit { number, bit },
            _ => return Err(self.alarm(Fault::DataParameter, span)),
        };
        let Some(value) = self.words.get(b'R') else {
            return Err(self.alarm(Fault::DataParameter, span));
        };
        if self.is_strictly_transformed() && (self.dialect.is_work_zero)(&key) {
            return Err(self.alarm(Fault::OffsetInTransform, span));
        }
        if (self.dialect.is_fixed_parameter)(&key) {
            return Err(self.alarm(Fault::ParameterFixed, span));
        }
        // 4.2.7 note 5: nor what acts from the next power-on.
        let mut asked = self.memory.parameters.clone();
        let may = asked.set(&key, value).is_err()
            || !self.dialect.builds_another(&self.machine, &self.memory.parameters, &asked);
        if !may {
            return Err(self.alarm(Fault::ParameterFixed, span));
        }
        let set = self.memory.set_parameter(&key, value);
        if let Err(error) = set {
            let mut alarm = self.alarm(Fault::DataParameter, span);
            alarm.arguments.push(("detail", ParameterError::to_string(&error).into()));
            return Err(alarm);
        }
        self.rules = (self.dialect.rules)(&self.memory.parameters);
        self.output.set_rules(self.rules.cutter);
        self.variable_writes += 1;
        self.work_zero_changed();
        Ok(())
    }
}
