//! Codes that act in their block alone: dwell, reference points, data setting, coordinate systems.

use crate::Fallible;
use crate::dialect::{GCode, MFunction, Meaning};
use crate::interpreter::Interpreter;
use crate::words::Code;
use ferrocut_geometry::AxisSet;
use ferrocut_machine::{Alarm, Fault};
use ferrocut_toolpath::{Dwell, Op};

impl Interpreter {
    pub(crate) fn non_modal(
        &mut self,
        code: Code<GCode>,
        axes: AxisSet,
        length: Option<Meaning>,
    ) -> Fallible<()> {
        let Code { row, span } = code;
        self.refuse_beside_cycle(row.meaning, axes, span)?;
        let reference = matches!(
            row.meaning,
            Meaning::ReferenceCheck
                | Meaning::ReferenceReturn
                | Meaning::FurtherReferenceReturn
                | Meaning::ReturnFromReference
        );
        let sets_position = row.meaning == Meaning::SetPosition && !axes.is_empty();
        let system = sets_position || row.meaning == Meaning::LocalZero;
        if reference || row.meaning == Meaning::MachinePosition || system {
            self.refuse_in_transform(span)?;
        }
        // Compensation is to be cancelled first (4.2.11 note 2); the manual gives no number.
        if sets_position && self.output.in_cutter_mode() {
            return Err(self.alarm(Fault::WorkOffsetInCutter, span));
        }
        if self.rules.coordinates.transforms_nest
            && (reference || system || row.meaning == Meaning::MachinePosition)
        {
            self.refuse_in_nested_scaling(span)?;
        }
        if reference && self.cycle_kind().is_some() && !self.rules.coordinates.reference_in_cycle {
            return Err(self.alarm(Fault::ReferenceInCycle, span));
        }
        self.take_up_waiting_length(row.meaning, axes)?;
        match row.meaning {
            Meaning::Dwell => self.dwell(),
            Meaning::MachinePosition => self.machine_position(axes),
            Meaning::SetPosition => {
                if length.is_some() {
                    return Err(self.alarm(Fault::LengthWithCoordinateSet, self.words.block_span()));
                }
                if !axes.is_empty() {
                    self.refuse_in_corner()?;
                }
                if let Some(s) = self.words.get(b'S').filter(|_| self.rules.surface_speed) {
                    self.technology.surface_max_rpm = Some(s);
                    self.tell_speed();
                }
                self.set_position(axes);
                Ok(())
            }
            Meaning::LocalZero => {
                self.local_zero(axes);
                Ok(())
            }
            Meaning::SetPositionOfOne => self.set_position_of_one(axes),
            Meaning::SetPositionForNow => {
                self.set_position_for_now(axes);
                Ok(())
            }
            Meaning::SetWorkZero => self.set_zero_word(axes),
            Meaning::SetToolLength => self.set_tool_length(),
            Meaning::Call => self.g_call(span),
            Meaning::Pattern(pattern) => self.pattern(pattern, axes, span),
            Meaning::Figure(format) => self.repeat_on_figure(format, span),
            Meaning::ChooseAxes => self.choose_axes(axes),
            Meaning::HomeSearch => self.home_search(axes),
            Meaning::PolarOrigin => {
                self.set_polar_origin();
                Ok(())
            }
            // Corners and ways of profiles stand in profiles alone.
            Meaning::ProfileRound
            | Meaning::ProfileChamfer
            | Meaning::ProfileEntry
            | Meaning::ProfileExit => Err(self.alarm(Fault::ProfileForm, span)),
            Meaning::MoveUntilInput => self.move_until_input(span),
            Meaning::Undescribed => Err(self.alarm(Fault::NotSupported, span)),
            Meaning::ReferenceCheck => self.reference_check(axes),
            Meaning::ReferenceReturn => self.reference_return(axes, 1),
            Meaning::FurtherReferenceReturn => self.further_reference_return(axes),
            Meaning::ReturnFromReference => self.return_from_reference(axes),
            Meaning::Skip if self.output.in_cutter_mode() => Err(self.alarm(Fault::SkipInCutter, span)),
            Meaning::Skip => self.skip(axes, span),
            Meaning::CornerArc => self.corner_arc(span),
            Meaning::OneWay => self.position_one_way(axes),
            Meaning::DataSetting => self.set_data(axes, span),
            _ => Ok(()),
        }
    }

    /// G04 (GSK990MC 4.2.5): X, or another letter, in seconds goes before P; neither is no pause.
    pub(crate) fn dwell(&mut self) -> Fallible<()> {
        let seconds = self.rules.dwell_letter;
        let by_p = self.rules.dwell_p_decides && self.words.has(b'P');
        let (letter, unit) = match self.words.has(seconds) && !by_p {
            true => (seconds, 1.0),
            false => (b'P', self.rules.dwell_p_unit_s),
        };
        if !self.leaves_point_to_block(Meaning::Dwell) {
            self.tell_unused((*b"XYZABCIJKLPQR").into_iter().filter(|other| *other != letter));
        }
        let Some(value) = self.words.get(letter) else {
            // S is the speed of the spindle and no number of turns to wait for.
            if self.words.has(b'S') {
                let alarm = Alarm::core(Fault::WordMissing, self.words.block_span());
                self.tell(alarm.with("word", char::from(letter).to_string()));
            }
            return Ok(());
        };
        for letter in [letter, seconds, b'P'] {
            if self.words.get(letter).is_some_and(|value| value < 0.0) {
                return Err(self.alarm_at(Fault::NegativeDwell, letter));
            }
        }
        if value == 0.0 {
            return Ok(());
        }
        let turns = self.rules.dwell_in_revolutions && self.modal.is_feed_per_revolution();
        let amount = value * unit;
        self.emit(Op::Dwell(if turns { Dwell::Revolutions(amount) } else { Dwell::Seconds(amount) }));
        Ok(())
    }

    /// After a faulty block, for a checker: takes its end point as reached and its end of program as
    /// meant, so that the blocks behind it are judged as the author meant them.
    pub(crate) fn recover(&mut self) -> Fallible<()> {
        if !self.words.stands_for_motion() {
            let axes = self.words.axes(self.rules.axes);
            let to = self.end_point(axes);
            if to.is_finite() {
                self.location.programmed = to;
                self.location.machine = self.location.machine_of(to);
                self.output.jump_to(self.location.machine);
            }
        }
        for at in 0..self.words.m.len() {
            if let Some(Code { row, span }) = self.words.m.get(at).copied()
                && matches!(row.function, MFunction::End | MFunction::Return)
            {
                return self.m_function(row, span);
            }
        }
        Ok(())
    }
}
