//! How things stand, and the counters.

use super::Control;
use crate::api::{
    AlarmInfo, ByAxis, Counters, Event, FeedStatus, NextBlock, Positions, ProgramStatus, SpindleStatus,
    Status, StopAt, SwitchStatus,
};
use crate::cnc::State;
use crate::report::Activity;
use ferrocut_geometry::{Axis, Position};
use ferrocut_machine::{Fault, ParameterKey, g_code_name};
use ferrocut_memory::Counter;

/// P356: parts machined, and P357: parts to be machined (GSK990MC part 2, 3.1.2 note 4).
const PARTS_MACHINED: ParameterKey = ParameterKey::Data(356);
const PARTS_REQUIRED: ParameterKey = ParameterKey::Data(357);

/// An hour and a day, s.
const HOUR: f64 = 3600.0;
const DAY: f64 = 24.0 * HOUR;

/// Parameters that show a counter, and what one of them is of it: P355 starts of the control, P356 parts, P358 and P359
/// hours and days of power on, P360 hours of cutting (appendix 1). Each is the whole of it.
static SHOWN: [(ParameterKey, Counter, f64); 5] = [
    (ParameterKey::Data(355), Counter::Starts, 1.0),
    (PARTS_MACHINED, Counter::Parts, 1.0),
    (ParameterKey::Data(358), Counter::PowerOnTime, HOUR),
    (ParameterKey::Data(359), Counter::PowerOnTime, DAY),
    (ParameterKey::Data(360), Counter::AllCuttingTime, HOUR),
];

/// The counter that a parameter shows, and what one of it is of that.
pub(super) fn counter_of(key: &ParameterKey) -> Option<(Counter, f64)> {
    SHOWN.iter().find(|row| row.0 == *key).map(|(_, counter, unit)| (*counter, *unit))
}

/// What the parameters of [`SHOWN`] have, and the most that they can have; none that the control lacks.
pub(super) type Shown = [Option<(f64, f64)>; 5];

/// Counters as they are kept: pieces, s, and starts.
#[derive(Clone, Copy, PartialEq, Debug, Default)]
pub(super) struct Count {
    pub parts: f64,
    pub all_parts: f64,
    pub run_time: f64,
    pub cutting_time: f64,
    pub all_cutting_time: f64,
    pub power_on_time: f64,
    pub starts: f64,
}

impl Count {
    /// Each with its name.
    pub fn named(&self) -> impl Iterator<Item = (Counter, f64)> {
        [
            (Counter::Parts, self.parts),
            (Counter::AllParts, self.all_parts),
            (Counter::RunTime, self.run_time),
            (Counter::CuttingTime, self.cutting_time),
            (Counter::AllCuttingTime, self.all_cutting_time),
            (Counter::PowerOnTime, self.power_on_time),
            (Counter::Starts, self.starts),
        ]
        .into_iter()
    }

    fn of(&self, counter: Counter) -> f64 {
        match counter {
            Counter::Parts => self.parts,
            Counter::AllParts => self.all_parts,
            Counter::RunTime => self.run_time,
            Counter::CuttingTime => self.cutting_time,
            Counter::AllCuttingTime => self.all_cutting_time,
            Counter::PowerOnTime => self.power_on_time,
            Counter::Starts => self.starts,
        }
    }

    /// Sets one.
    pub fn set(&mut self, counter: Counter, value: f64) {
        match counter {
            Counter::Parts => self.parts = value,
            Counter::AllParts => self.all_parts = value,
            Counter::RunTime => self.run_time = value,
            Counter::CuttingTime => self.cutting_time = value,
            Counter::AllCuttingTime => self.all_cutting_time = value,
            Counter::PowerOnTime => self.power_on_time = value,
            Counter::Starts => self.starts = value,
        }
    }
}

impl Control {
    /// Counts parts and times (3.1.2: parts by M30 and M02).
    pub(super) fn count(&mut self) {
        self.take_written();
        let seconds = self.machine.servo_period_ms / 1000.0;
        self.counters.power_on_time += seconds;
        if self.cnc.state() == &State::Running {
            self.counters.run_time += seconds;
        }
        let cutting = self.cnc.report().time(Activity::Cutting);
        self.counters.cutting_time += cutting - self.cutting_before;
        self.counters.all_cutting_time += cutting - self.cutting_before;
        self.cutting_before = cutting;
        let made = self.cnc.report().parts.saturating_sub(self.parts);
        self.parts = self.cnc.report().parts;
        // Blocks typed in MDI make no parts.
        if made > 0 && self.program_mode() != crate::signals::Mode::Mdi {
            self.counters.parts += f64::from(made);
            self.counters.all_parts += f64::from(made);
            self.show_counts();
            let parts = self.counters.parts as u64;
            self.event(Event::Part { parts });
        } else if self.is_another_shown() && !self.cnc.is_reading() {
            self.show_counts();
        }
    }

    /// A program or a person wrote a parameter that shows a counter.
    fn take_written(&mut self) {
        for ((key, counter, unit), shown) in SHOWN.iter().zip(&mut self.shown) {
            let Some((shown, _)) = shown else { continue };
            let written = self.cnc.interpreter().memory().parameters.get(key);
            if written != *shown {
                *shown = written;
                self.counters.set(*counter, written * unit);
            }
        }
    }

    /// What a parameter shows of its counter, as far as it goes.
    fn due(counters: &Count, (_, counter, unit): &(ParameterKey, Counter, f64), most: f64) -> f64 {
        (counters.of(*counter) / unit).floor().min(most)
    }

    fn is_another_shown(&self) -> bool {
        let mut shown = SHOWN.iter().zip(&self.shown);
        shown
            .any(|(row, shown)| shown.is_some_and(|(is, most)| is != Control::due(&self.counters, row, most)))
    }

    /// 55#0 CANT: the times of a part begin anew with it.
    pub(super) fn begin_part(&mut self) {
        if self.bit(55, 0) {
            (self.counters.run_time, self.counters.cutting_time) = (0.0, 0.0);
        }
    }

    /// What was counted is the value of its parameter.
    pub(super) fn show_counts(&mut self) {
        for (place, row) in SHOWN.iter().enumerate() {
            let key = &row.0;
            let Some(of_table) = self.cnc.interpreter().memory().parameters.table().get(key) else {
                continue;
            };
            let most = of_table.max.unwrap_or(f64::MAX);
            let due = Control::due(&self.counters, row, most);
            // Within its range; nobody has set it.
            self.cnc.interpreter_mut().memory_mut().parameters.take_back(key, due);
            if let Some(keeping) = &mut self.keeping {
                keeping.has(key, due);
            }
            if let Some(shown) = self.shown.get_mut(place) {
                *shown = Some((due, most));
            }
        }
    }

    /// The parts that were wanted are made.
    pub(super) fn parts_are_made(&self) -> bool {
        let wanted = self.cnc.interpreter().memory().parameters.get(&PARTS_REQUIRED);
        wanted > 0.0 && self.counters.parts >= wanted
    }

    /// How things stand.
    pub fn status(&self) -> Status {
        let interpreter = self.cnc.interpreter();
        let inputs = &self.inputs;
        let shown = self.cnc.shown();
        let is_loaded = !matches!(self.loaded, super::Loaded::Nothing);
        let mut alarms = Vec::new();
        let emergency = self.emergency.then(|| self.own_alarm(Fault::EmergencyStop));
        // One that broke homing off has the same number.
        let is_told =
            |alarm: &&ferrocut_machine::Alarm| self.active.as_ref().is_some_and(|own| own.id == alarm.id);
        alarms.extend(emergency.as_ref().filter(|alarm| !is_told(alarm)).map(AlarmInfo::of));
        alarms.extend(self.active.as_ref().map(AlarmInfo::of));
        alarms.extend(self.at_limits.iter().map(|(_, _, alarm)| AlarmInfo::of(alarm)));
        alarms.extend(self.parameter_alarm().as_ref().map(AlarmInfo::of));
        alarms.extend(self.power_off_alarm().as_ref().map(AlarmInfo::of));
        Status {
            periods: self.periods,
            mode: self.mode,
            program_mode: self.cnc.is_under_way().then(|| self.program_mode()),
            activity: self.activity(),
            finishing_block: self.cnc.finishes_block(),
            alarms,
            position: self.positions(),
            feed: FeedStatus {
                actual: self.tick.velocity * 60.0,
                components: self.components(),
                programmed: shown.feed,
                feed_override: inputs.feed_override,
                rapid_override: inputs.rapid_override.factor().unwrap_or(0.0),
                manual_override: inputs.manual_override,
            },
            spindle: SpindleStatus {
                programmed: shown.speed,
                told: self.cnc.spindle().rpm(),
                actual: self.cnc.spindle().actual_rpm(),
                spindle_override: inputs.spindle_override,
                tool: shown.tool,
                called_tool: shown.called_tool,
            },
            program: ProgramStatus {
                selected: self.selected.clone(),
                cursor: self.cursor,
                running: Some(self.running_program()).filter(|name| is_loaded && !name.is_empty()),
                line: self.tick.span.line,
                block: interpreter.programs().slice(self.tick.span),
                g_codes: shown.g_codes().map(g_code_name).collect(),
                h: shown.h,
                d: shown.d,
                next: self.next_block(),
                retraced: self.cnc.is_retraced(),
                stop_at: self.stop_at.as_ref().map(|(program, sequence)| StopAt {
                    program: program.clone().or_else(|| self.selected.clone()),
                    sequence: *sequence,
                }),
            },
            dnc: self.dnc_status(),
            switches: SwitchStatus {
                single_block: inputs.single_block,
                block_skip: inputs.block_skip,
                optional_stop: inputs.optional_stop,
                dry_run: inputs.dry_run,
                machine_lock: self.cnc.is_locked(),
                auxiliary_lock: inputs.auxiliary_lock,
                parameters: self.parameters_open(),
                programs: self.programs_open(),
            },
            counters: Counters {
                parts: self.counters.parts as u64,
                all_parts: self.counters.all_parts as u64,
                run_time: self.counters.run_time,
                cutting_time: self.counters.cutting_time,
                power_on_time: self.counters.power_on_time,
            },
            interrupted: self.taking_up.interrupted(),
            restart_ready: self.taking_up.is_ready(),
            measure_ready: self.measuring.is_ready(),
            referenced: self.cnc.referenced().iter().map(Axis::letter).collect(),
            messages: self.ladder_names.standing().map(str::to_owned).collect(),
            program_message: self.program_message.clone(),
            lamps: self.plc.as_ref().map(|plc| self.ladder_names.lit(plc)).unwrap_or_default(),
            panel: self.plc.as_ref().map(|plc| self.ladder_names.switches(plc)).unwrap_or_default(),
            level: None,
        }
    }

    /// The block behind the one being run that the machine does something for, as far as the program was read.
    fn next_block(&self) -> Option<NextBlock> {
        let span = self.cnc.next_span()?;
        let programs = self.cnc.interpreter().programs();
        Some(NextBlock {
            file: programs.file_name(span.file).to_owned(),
            line: span.line,
            text: programs.slice(span),
        })
    }

    /// Speeds of the axes, mm/min and degrees/min, as they are commanded.
    fn components(&self) -> ByAxis {
        let mut speeds = self.by_axis(self.tick.position - self.came_from);
        let a_minute = 60_000.0 / self.machine.servo_period_ms;
        speeds.values_mut().for_each(|speed| *speed *= a_minute);
        speeds
    }

    fn positions(&self) -> Positions {
        let path = self.tick.position - self.cnc.handwheel_shift();
        // 6.2.2: a handwheel interruption changes neither this nor relative coordinates.
        let work = self.cnc.in_work(path);
        // 22#6 DAL.
        let absolute = if self.bit(22, 6) { work + self.cnc.tool_length() } else { work };
        Positions {
            machine: self.by_axis(self.tick.position),
            actual: self.by_axis(self.tick.actual),
            work: self.by_axis(work),
            absolute: self.by_axis(absolute),
            relative: self.by_axis(path - self.origin),
            to_go: self.by_axis(self.cnc.to_go()),
            interruption: self.by_axis(self.cnc.handwheel_shift()),
            system: self.cnc.shown().system.map(|name| name.to_string()),
        }
    }

    /// The axes of the machine.
    pub(super) fn by_axis(&self, position: Position) -> ByAxis {
        self.machine.axes.iter().map(|axis| (axis.name.letter(), position[axis.name])).collect()
    }
}
