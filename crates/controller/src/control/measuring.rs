//! Measuring at the control (GSK990MC part 2, 3.4.3): points by hand, work zeros and tools by skip signal. What is
//! prepared in AUTO is done by cycle start, and stored as if somebody had typed it.

use super::commands::outside;
use super::{Control, Loaded, alarm};
use crate::api::{
    ByAxis, Event, MeasureForm, MeasurePace, MeasureTool, MeasureWork, Measurement, Reply, ToolMode,
};
use crate::measure::work::{Form, Work, centre_of};
use crate::measure::{Pace, Touching, Unusable, tool, work};
use crate::signals::Mode;
use ferrocut_geometry::{Axis, Position};
use ferrocut_machine::{Alarm, Fault, ParameterKey, ToolOffset};
use ferrocut_memory::rights::needed_for_parameter;
use ferrocut_memory::{Author, Change};
use ferrocut_toolpath::{Speed, SpindleState};
use std::collections::BTreeMap;

/// Points that are taken by hand.
const MOST_POINTS: u8 = 8;

/// P387 to P389: the setter, machine positions of X, Y and Z; P391: diameter of probe and setter.
const SETTER: [u16; 3] = [387, 388, 389];
const PROBE_DIAMETER: u16 = 391;

/// P390: estimated length of a tool, from its tip to the holder.
const LENGTH_ESTIMATE: u16 = 390;

/// How far a setter is searched whose height nobody knows, mm.
const UNKNOWN_HEIGHT: f64 = 50.0;

/// What is measured, prepared or under way.
enum What {
    Work(MeasureWork, Work),
    Tool(MeasureTool, tool::Tool),
}

/// The measuring of a control.
#[derive(Default)]
pub(super) struct Measuring {
    points: BTreeMap<u8, Position>,
    prepared: Option<Box<(What, Author)>>,
    runs: Option<Box<(What, Author)>>,
    last: Option<Measurement>,
}

impl Measuring {
    /// Whether cycle start measures.
    pub fn is_ready(&self) -> bool {
        self.prepared.is_some()
    }
}

fn setting(Unusable(name): Unusable) -> Box<Alarm> {
    Box::new(alarm(Fault::MeasureSetting).with("name", name))
}

fn pace_of(pace: MeasurePace) -> Result<Pace, Unusable> {
    let usual = Pace::default();
    let of = |value: Option<f64>, usual: f64, name| match value {
        None => Ok(usual),
        Some(value) if value.is_finite() && value > 0.0 => Ok(value),
        Some(_) => Err(Unusable(name)),
    };
    Ok(Pace {
        way: of(pace.way, usual.way, "way")?,
        search: of(pace.search, usual.search, "search")?,
        fine: of(pace.fine, usual.fine, "fine")?,
        back_off: of(pace.back_off, usual.back_off, "back_off")?,
    })
}

/// How far a size may be from its nominal one: 0 or more.
fn may_tolerate(tolerance: Option<f64>) -> Result<(), Unusable> {
    match tolerance.is_some_and(|tolerance| tolerance.is_nan() || tolerance < 0.0) {
        true => Err(Unusable("tolerance")),
        false => Ok(()),
    }
}

impl Control {
    // By hand.

    pub(super) fn touch_point(&mut self, number: u8) -> Result<Reply, Box<Alarm>> {
        if self.tick.moving || self.cnc.is_under_way() {
            return Err(Box::new(alarm(Fault::ControlBusy)));
        }
        if !(1..=MOST_POINTS).contains(&number) {
            return Err(Box::new(outside(number.to_string(), &(1.0..=f64::from(MOST_POINTS)))));
        }
        self.measuring.points.insert(number, self.tick.position);
        Ok(Reply::Done)
    }

    pub(super) fn points(&self) -> Reply {
        let points = self.measuring.points.iter();
        Reply::Points { points: points.map(|(number, at)| (*number, self.by_axis(*at))).collect() }
    }

    pub(super) fn clear_points(&mut self) -> Reply {
        self.measuring.points.clear();
        Reply::Done
    }

    /// The centre of the points that were taken (3.4.3.1, manual).
    pub(super) fn centre(
        &mut self,
        is_circle: bool,
        system: Option<String>,
        values: &ByAxis,
        author: &Author,
    ) -> Result<Reply, Box<Alarm>> {
        let points = &self.measuring.points;
        let taken: Vec<Position> = match is_circle {
            true => points.values().copied().collect(),
            false => (1..=4).filter_map(|number| points.get(&number).copied()).collect(),
        };
        let unusable = || alarm(Fault::PointsUnusable).with("name", points.len().to_string());
        let found = centre_of(&taken, is_circle).ok_or_else(unusable)?;
        let measured = self.store_place(&found, system.as_deref(), values, 0.0, author)?;
        self.tell_measured(measured.clone());
        Ok(Reply::Measured { measured: Some(measured), ready: self.measuring.is_ready() })
    }

    // By skip signal.

    pub(super) fn prepare_work(&mut self, asked: MeasureWork, author: &Author) -> Result<Reply, Box<Alarm>> {
        self.may_measure()?;
        may_tolerate(asked.tolerance).map_err(setting)?;
        let form = self.form_of(asked.form)?;
        let zero = self.cnc.program_zero();
        let from = self.tick.position;
        let place = |value: Option<f64>, axis: Axis| match value {
            Some(value) if !value.is_finite() => Err(Unusable("centre")),
            Some(value) => Ok(zero[axis] + value),
            None => Ok(from[axis]),
        };
        let centre = [place(asked.x, Axis::X).map_err(setting)?, place(asked.y, Axis::Y).map_err(setting)?];
        let depth = asked.z.map(|_| place(asked.z, Axis::Z)).transpose().map_err(setting)?;
        if let Some(system) = &asked.system {
            self.zero_of(system)?;
        }
        self.length_of(asked.h)?;
        let ball = asked.probe.unwrap_or_else(|| self.parameter(PROBE_DIAMETER));
        let work = Work {
            form,
            from,
            centre,
            depth,
            clearance: asked.clearance.unwrap_or(8.0),
            overtravel: asked.overtravel.unwrap_or(10.0),
            ball,
            pace: pace_of(asked.pace).map_err(setting)?,
        };
        work.touching().map_err(setting)?;
        self.ready_to_measure(What::Work(asked, work), author)
    }

    pub(super) fn prepare_tool(&mut self, asked: MeasureTool, author: &Author) -> Result<Reply, Box<Alarm>> {
        // Said before anything moves: what calibration finds are parameters, and the memory judges who sets them.
        let calibrates = matches!(asked.mode, ToolMode::CalibrateLength | ToolMode::CalibrateDiameter);
        if calibrates && self.keeping.is_some() {
            let table = self.cnc.interpreter().memory().parameters.table();
            self.needs_level(needed_for_parameter(table, &ParameterKey::Data(SETTER[0])), author)?;
        }
        self.may_measure()?;
        // NO4.0 (TMES): a tool setter is fitted.
        let key = ParameterKey::Bit { number: 4, bit: 0 };
        let parameters = &self.cnc.interpreter().memory().parameters;
        if parameters.table().get(&key).is_some() && !self.bit(4, 0) {
            return Err(self.own(Fault::ProbeMissing, "name", "NO4.0"));
        }
        may_tolerate(asked.tolerance).map_err(setting)?;
        let mode = match asked.mode {
            ToolMode::Length => tool::Mode::Length,
            ToolMode::Diameter => tool::Mode::Diameter,
            ToolMode::Both => tool::Mode::Both,
            ToolMode::CalibrateLength => tool::Mode::CalibrateLength,
            ToolMode::CalibrateDiameter => tool::Mode::CalibrateDiameter,
        };
        let calibrates = mode == tool::Mode::CalibrateLength;
        let (length, radius) = (self.offset(asked.h)?, self.offset(asked.d)?);
        // 3.4.3.2, A 6 note 1: to calibrate it must be given.
        let estimates = [length.map(|of| of.length + of.length_wear), Some(self.parameter(LENGTH_ESTIMATE))];
        let mut estimates = estimates.into_iter().flatten().filter(|length| !calibrates && *length != 0.0);
        let length = asked.length.or_else(|| estimates.next());
        let as_diameter = if self.radius_is_diameter() { 1.0 } else { 2.0 };
        let diameter = asked.diameter.or(radius.map(|of| (of.radius + of.radius_wear) * as_diameter));
        let spindle = asked.rpm.filter(|rpm| *rpm != 0.0).map(|rpm| match rpm > 0.0 {
            true => SpindleState::Clockwise(Speed::Rpm(rpm)),
            false => SpindleState::CounterClockwise(Speed::Rpm(-rpm)),
        });
        if asked.rpm.is_some_and(|rpm| !rpm.is_finite()) {
            return Err(setting(Unusable("rpm")));
        }
        if asked.adjust.is_some_and(|by| !by.is_finite()) {
            return Err(setting(Unusable("adjust")));
        }
        // 3.4.3.2, A 9: a free number, and a tool is called broken by its tolerance alone.
        if let Some(mark) = asked.mark
            && (self.offset(mark)?.is_none()
                || [asked.h, asked.d].contains(&mark)
                || asked.tolerance.is_none())
        {
            return Err(setting(Unusable("mark")));
        }
        let tool = tool::Tool {
            mode,
            from: self.tick.position,
            setter: SETTER.map(|number| self.parameter(number)),
            stylus: asked.stylus.unwrap_or_else(|| self.parameter(PROBE_DIAMETER)),
            length: length.ok_or(Unusable("length")).map_err(setting)?,
            diameter: diameter.unwrap_or(0.0),
            depth: asked.depth.unwrap_or(5.0),
            overtravel: asked.overtravel.unwrap_or(if calibrates { UNKNOWN_HEIGHT } else { 4.0 }),
            pace: pace_of(asked.pace).map_err(setting)?,
            spindle,
        };
        tool.touching().map_err(setting)?;
        self.ready_to_measure(What::Tool(asked, tool), author)
    }

    fn ready_to_measure(&mut self, what: What, author: &Author) -> Result<Reply, Box<Alarm>> {
        self.forget_prepared();
        self.measuring.prepared = Some(Box::new((what, author.clone())));
        Ok(Reply::Done)
    }

    pub(super) fn cancel_measure(&mut self) -> Reply {
        self.measuring.prepared = None;
        Reply::Done
    }

    pub(super) fn measured(&self) -> Reply {
        Reply::Measured { measured: self.measuring.last.clone(), ready: self.measuring.is_ready() }
    }

    /// Whether something may be measured now, in AUTO (3.4.3.1).
    fn may_measure(&self) -> Result<(), Box<Alarm>> {
        if !self.cnc.is_idle() || self.tick.moving {
            return Err(Box::new(alarm(Fault::ControlBusy)));
        }
        if self.mode != Mode::Auto {
            return Err(Box::new(alarm(Fault::ControlMode).with("mode", super::name_of(self.mode))));
        }
        if !self.cnc.has_probe() {
            return Err(self.own(Fault::ProbeMissing, "name", "SKIP"));
        }
        self.must_be_homed(Fault::MeasureNotReferenced)?;
        let forbids = [
            (self.inputs.dry_run, "dry run"),
            (self.inputs.machine_lock || self.cnc.is_locked(), "machine lock"),
            (self.inputs.auxiliary_lock, "auxiliary lock"),
            (self.cnc.spindle().told() != 0.0, "spindle"),
        ];
        match forbids.into_iter().find(|(is, _)| *is) {
            Some((_, name)) => Err(Box::new(alarm(Fault::MeasureForbidden).with("name", name))),
            None => Ok(()),
        }
    }

    /// An alarm by the control's own number, where it has one.
    fn own(&self, fault: Fault, name: &'static str, value: &str) -> Box<Alarm> {
        Box::new(self.own_alarm(fault).with(name, value))
    }

    /// Cycle start with a measuring prepared. The way begins where the axes stand now.
    pub(super) fn start_measuring(&mut self) -> Result<(), Box<Alarm>> {
        self.may_measure()?;
        let Some(prepared) = &mut self.measuring.prepared else { return Ok(()) };
        let from = self.tick.position;
        let plan: Result<Touching, Unusable> = match &mut prepared.0 {
            What::Work(asked, work) => {
                // Where no centre was given it is where the probe stands.
                let given = [(asked.x, Axis::X), (asked.y, Axis::Y)];
                for (place, (given, axis)) in work.centre.iter_mut().zip(given) {
                    if given.is_none() {
                        *place = from[axis];
                    }
                }
                work.from = from;
                work.touching()
            }
            What::Tool(_, tool) => {
                tool.from = from;
                tool.touching()
            }
        };
        if !self.cnc.touch(plan.map_err(setting)?) {
            return Err(Box::new(alarm(Fault::ControlBusy)));
        }
        self.measuring.runs = self.measuring.prepared.take();
        self.loaded = Loaded::Measuring;
        Ok(())
    }

    /// All places were touched: what they come to is stored. What is wrong is an alarm, and nothing is stored.
    pub(super) fn end_measuring(&mut self) {
        let Some(runs) = self.measuring.runs.take() else { return };
        let (what, author) = *runs;
        let touched = self.cnc.touched().to_vec();
        let done = match what {
            What::Work(asked, work) => self.end_work(&asked, &work, &touched, &author),
            What::Tool(asked, tool) => self.end_tool(&asked, &tool, &touched, &author),
        };
        match done {
            Ok(measured) => self.tell_measured(measured),
            Err(why) => self.raise(*why),
        }
    }

    fn end_work(
        &mut self,
        asked: &MeasureWork,
        work: &Work,
        touched: &[Position],
        author: &Author,
    ) -> Result<Measurement, Box<Alarm>> {
        let unusable = || alarm(Fault::PointsUnusable).with("name", touched.len().to_string());
        let found = work.found(touched).ok_or_else(unusable)?;
        within(&found.sizes, asked.tolerance)?;
        let length = self.length_of(asked.h)?;
        self.store_place(&found, asked.system.as_deref(), &asked.values, length, author)
    }

    fn end_tool(
        &mut self,
        asked: &MeasureTool,
        tool: &tool::Tool,
        touched: &[Position],
        author: &Author,
    ) -> Result<Measurement, Box<Alarm>> {
        let unusable = || alarm(Fault::PointsUnusable).with("name", touched.len().to_string());
        let found = tool.found(touched).ok_or_else(unusable)?;
        let sizes: Vec<(f64, f64)> = [(found.length, tool.length), (found.diameter, tool.diameter)]
            .into_iter()
            .filter_map(|(size, nominal)| Some((size?, nominal)))
            .collect();
        let judged = within(&sizes, asked.tolerance);
        if let Some((mark, row)) = asked.mark.zip(self.offset(asked.mark.unwrap_or(0))?) {
            let length = if judged.is_err() { 1.0 } else { 0.0 };
            self.change(author, Change::Offset { number: mark, offset: ToolOffset { length, ..row } })?;
        }
        judged?;
        let mut measured =
            Measurement { sizes: sizes.iter().map(|(size, _)| *size).collect(), ..Measurement::default() };
        // What was measured now has no wear yet.
        if let (Some(length), Some(row)) = (found.length, self.offset(asked.h)?) {
            let offset = ToolOffset { length, length_wear: 0.0, ..row };
            self.change(author, Change::Offset { number: asked.h, offset })?;
            measured.stored.push(format!("H{}", asked.h));
        }
        if let (Some(diameter), Some(row)) = (found.diameter, self.offset(asked.d)?) {
            // 3.4.3.2, A 10: a positive adjustment makes the radius so much smaller.
            let diameter = diameter - 2.0 * asked.adjust.unwrap_or(0.0);
            let radius = if self.radius_is_diameter() { diameter } else { diameter / 2.0 };
            let offset = ToolOffset { radius, radius_wear: 0.0, ..row };
            self.change(author, Change::Offset { number: asked.d, offset })?;
            measured.stored.push(format!("D{}", asked.d));
        }
        let setter = found.setter.into_iter().flat_map(|places| SETTER.into_iter().zip(places));
        let mut calibrated = Vec::new();
        for (number, value) in setter.chain(found.stylus.map(|stylus| (PROBE_DIAMETER, stylus))) {
            measured.sizes.push(value);
            let key = ParameterKey::Data(number);
            let check = self.cnc.interpreter().memory().parameters.check(&key, value);
            check.map_err(|error| error.alarm())?;
            calibrated.push(Change::Parameter { key, value: Some(value) });
            measured.stored.push(format!("P{number}"));
        }
        if !calibrated.is_empty() {
            self.change_together(author, calibrated)?;
        }
        Ok(measured)
    }

    /// A place becomes the zero of a work coordinate system, so that it has these coordinates there.
    fn store_place(
        &mut self,
        found: &work::Found,
        system: Option<&str>,
        values: &ByAxis,
        length: f64,
        author: &Author,
    ) -> Result<Measurement, Box<Alarm>> {
        let mut measured = Measurement {
            place: found.place.iter().map(|(axis, at)| (axis.letter(), *at)).collect(),
            sizes: found.sizes.iter().map(|(size, _)| *size).collect(),
            out_of_round: found.out_of_round,
            stored: Vec::new(),
        };
        if let Some(system) = system {
            let coordinates = found.place.iter().map(|(axis, at)| {
                let value = values.get(&axis.letter()).copied().unwrap_or(0.0);
                // A tool of this length touched with its tip.
                let tip = if *axis == Axis::Z { length } else { 0.0 };
                (axis.letter(), at - tip - value)
            });
            let zeros = self.without_external(system, coordinates.collect())?;
            self.set_zero(system, &zeros, false, author)?;
            measured.stored.push(system.to_owned());
        }
        Ok(measured)
    }

    fn tell_measured(&mut self, measured: Measurement) {
        self.measuring.last = Some(measured.clone());
        self.event(Event::Measured { measured });
    }

    fn form_of(&self, form: MeasureForm) -> Result<Form, Box<Alarm>> {
        Ok(match form {
            MeasureForm::Hole { diameter } => Form::Circle { inside: true, diameter },
            MeasureForm::Boss { diameter } => Form::Circle { inside: false, diameter },
            MeasureForm::Slot { lx, ly } => Form::Walls { inside: true, x: lx, y: ly },
            MeasureForm::Web { lx, ly } => Form::Walls { inside: false, x: lx, y: ly },
            MeasureForm::VectorHole { diameter, angles } => {
                Form::VectorCircle { inside: true, diameter, angles }
            }
            MeasureForm::VectorBoss { diameter, angles } => {
                Form::VectorCircle { inside: false, diameter, angles }
            }
            MeasureForm::VectorSlot { width, angle } => Form::VectorWalls { inside: true, width, angle },
            MeasureForm::VectorWeb { width, angle } => Form::VectorWalls { inside: false, width, angle },
            MeasureForm::Edge { axis, positive, distance } => {
                let axis = self.axis_named(axis)?;
                match axis {
                    Axis::X | Axis::Y | Axis::Z => Form::Edge { axis, positive, distance },
                    _ => return Err(setting(Unusable("axis"))),
                }
            }
        })
    }

    /// A tool offset; none for number 0.
    fn offset(&self, number: u16) -> Result<Option<ToolOffset>, Box<Alarm>> {
        if number == 0 {
            return Ok(None);
        }
        // Length and radius of one row are stored one after the other.
        let row = self.offset_asked(number);
        row.map(Some).ok_or_else(|| Box::new(alarm(Fault::NoSuchName).with("name", number.to_string())))
    }

    fn length_of(&self, number: Option<u16>) -> Result<f64, Box<Alarm>> {
        let row = self.offset(number.unwrap_or(0))?;
        Ok(row.map_or(0.0, |row| row.length + row.length_wear))
    }

    /// Whether radius offsets are entered as diameters (40#7).
    fn radius_is_diameter(&self) -> bool {
        self.cnc.interpreter().rules().radius_is_diameter
    }
}

/// Whether sizes lie within a tolerance of their nominal ones.
fn within(sizes: &[(f64, f64)], tolerance: Option<f64>) -> Result<(), Box<Alarm>> {
    let Some(tolerance) = tolerance else { return Ok(()) };
    let fits = |(size, nominal): &(f64, f64)| (size - nominal).abs() <= tolerance;
    match sizes.iter().find(|pair| !fits(pair)) {
        None => Ok(()),
        Some((size, nominal)) => {
            let alarm = alarm(Fault::MeasuredSize).with("value", *size).with("nominal", *nominal);
            Err(Box::new(alarm.with("limit", tolerance)))
        }
    }
}
