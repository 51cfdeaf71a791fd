//! What the machine refuses or warns of, step by step and before anything moves.
//!
//! `check` at a desk and the running control ask the same supervisor, so that what the check says is
//! what the machine does.

use ferrocut_geometry::{Axis, AxisSet, Position};
use ferrocut_interpreter::{Dialect, Interpreter};
use ferrocut_machine::{Alarm, Fault, Machine};
use ferrocut_program::Span;
use ferrocut_toolpath::{Op, Speed, Step};

/// Coordinates this little beyond a limit are on it: what sums of decimals leave, mm or degrees.
pub(crate) const ON_LIMIT: f64 = 1e-6;

/// Follows the steps of a program and tells what the machine has against them.
#[derive(Clone, Debug)]
pub struct Supervisor {
    dialect: &'static Dialect,
    axes: Vec<AxisLimits>,
    /// Axes that the machine lacks and of which nothing was told yet.
    lacking: AxisSet,
    tools: u32,
    max_rpm: f64,
    at: Position,
    turning: bool,
    /// Whether cutting with the spindle at rest was told since it stopped.
    told_spindle: bool,
    /// What goes farther beyond a limit is told each time: nothing of it is to be run.
    runs: bool,
}

/// Software limits of one axis, and on which side the tool already is beyond them.
#[derive(Clone, Copy, Debug)]
struct AxisLimits {
    axis: Axis,
    /// Place of the axis in the machine file, which alarm numbers count by.
    number: usize,
    min: f64,
    max: f64,
    /// Whether they hold: not before the machine knows where the axis is.
    holds: bool,
    beyond: Option<bool>,
}

impl AxisLimits {
    /// Whether a position is beyond the upper limit, or the lower one.
    fn side(&self, position: f64) -> Option<bool> {
        let upper = position > self.max + ON_LIMIT;
        (upper || position < self.min - ON_LIMIT).then_some(upper)
    }

    /// The alarm of a path that comes to `position`, beyond the upper limit or the lower one.
    fn alarm(&self, dialect: &Dialect, upper: bool, position: f64, span: Span) -> Alarm {
        let alarm = Alarm::new(dialect.soft_limit_id(self.number, upper), Fault::SoftLimit, span);
        let limit = if upper { self.max } else { self.min };
        alarm.with("axis", self.axis.letter().to_string()).with("position", position).with("limit", limit)
    }
}

impl Supervisor {
    /// A supervisor of a machine that stands at `start`.
    pub fn new(machine: &Machine, dialect: &'static Dialect, start: Position) -> Supervisor {
        let axes = machine.axes.iter().enumerate().map(|(number, a)| AxisLimits {
            axis: a.name,
            number,
            min: a.min,
            max: a.max,
            holds: true,
            beyond: None,
        });
        Supervisor {
            dialect,
            axes: axes.collect(),
            lacking: Axis::ALL.into_iter().filter(|a| machine.axis(*a).is_none()).collect(),
            tools: machine.tool_change.tools,
            max_rpm: machine.spindle.max_rpm,
            at: start,
            turning: false,
            told_spindle: false,
            runs: false,
        }
    }

    /// From now on for a machine that runs the steps: a tool that is beyond a limit may stay there and come back, and each
    /// step that goes farther is told. Whoever only reads a program tells it once.
    pub fn runs(mut self) -> Supervisor {
        self.runs = true;
        self
    }

    /// Notes where the axes are after a block that made no steps, as a checker takes a faulty one. Steps that were
    /// refused did not bring them beyond a limit.
    pub fn moved_to(&mut self, at: Position) {
        self.at = at;
        for limits in &mut self.axes {
            limits.beyond = limits.beyond.filter(|upper| limits.side(at[limits.axis]) == Some(*upper));
        }
    }

    /// Whether the software limits of an axis hold; from the start they do.
    pub fn set_travel(&mut self, axis: Axis, holds: bool) {
        for limits in self.axes.iter_mut().filter(|limits| limits.axis == axis) {
            limits.holds = holds;
        }
    }

    /// What the machine has against a move by hand from `from`, which nothing is noted of.
    pub fn refusal(&self, from: Position, step: &Step) -> Option<Box<Alarm>> {
        let mut asked = self.clone();
        asked.moved_to(from);
        let mut refused = None;
        asked.travel(step, &mut |alarm| refused = refused.take().or(Some(Box::new(alarm))));
        refused
    }

    /// Notes that axes and spindle stand still, the axes at `at`.
    pub fn comes_to_rest(&mut self, at: Position) {
        self.moved_to(at);
        (self.turning, self.told_spindle) = (false, false);
    }

    /// Notes whether the spindle turns before a program begins.
    pub fn finds_spindle(&mut self, turns: bool) {
        (self.turning, self.told_spindle) = (turns, false);
    }

    /// Follows a program that is only read by its next step: adds what its language and the machine have against it.
    /// Whether there was a step.
    pub fn follow(&mut self, interpreter: &mut Interpreter, found: &mut Vec<Alarm>) -> bool {
        match interpreter.next() {
            Some(Ok(step)) => self.step(&step, |alarm| found.push(alarm)),
            Some(Err(alarm)) => {
                // An iterator has a method of that name too.
                self.moved_to(Interpreter::position(interpreter));
                found.push(*alarm);
            }
            None => return false,
        }
        true
    }

    /// Tells each thing that the machine has against a step. A tool that stays beyond a limit, or a
    /// spindle that stays at rest, is told once.
    #[inline]
    pub fn step(&mut self, step: &Step, mut tell: impl FnMut(Alarm)) {
        match &step.op {
            Op::Datum { at } => self.at = *at,
            Op::Rapid { .. } | Op::Feed { .. } | Op::Arc { .. } | Op::Tap { .. } | Op::Skip { .. } => {
                self.travel(step, &mut tell);
                if let Op::Tap { goes_on, .. } = step.op {
                    // The spindle turns with the tap, and after it as before, or not at all.
                    self.turning &= goes_on;
                    self.told_spindle = false;
                } else if !self.turning && !self.told_spindle && step.op.is_cutting() {
                    self.told_spindle = true;
                    tell(self.alarm(Fault::CuttingSpindleStopped, step).as_warning());
                }
            }
            Op::Spindle(state) => {
                self.turning = matches!(state.speed(), Some(Speed::Surface { .. }))
                    || matches!(state.speed(), Some(Speed::Rpm(rpm)) if rpm > 0.0);
                let rpm = state.speed().map_or(0.0, |speed| speed.rpm(&self.at));
                self.told_spindle = false;
                if rpm > self.max_rpm {
                    let alarm = self.alarm(Fault::SpindleTooFast, step);
                    tell(alarm.with("speed", rpm).with("limit", self.max_rpm));
                }
            }
            Op::Orient(_) => {
                self.turning = false;
                self.told_spindle = false;
            }
            Op::Select(tool) | Op::ToolNumber(tool) if self.tools > 0 && *tool > self.tools => {
                tell(self.alarm(Fault::ToolMissing, step).with("tool", f64::from(*tool)));
            }
            _ => {}
        }
    }

    /// Axes that the machine lacks, and software limits; arcs by their true extent.
    #[inline]
    fn travel(&mut self, step: &Step, tell: &mut impl FnMut(Alarm)) {
        let Some((min, max)) = step.op.extent(self.at) else { return };
        for axis in self.lacking.iter().filter(|a| min[*a] != max[*a]) {
            tell(Alarm::core(Fault::UnknownAxis, step.span).with("axis", axis.letter().to_string()));
            // Told once.
            self.lacking = self.lacking.iter().filter(|a| *a != axis).collect();
        }
        let from = self.at;
        if let Some(to) = step.op.target() {
            self.at = *to;
        }
        for limits in self.axes.iter_mut().filter(|limits| limits.holds) {
            let axis = limits.axis;
            // Only what ends beyond the limit stays there: the move back inside begins there.
            let ends = limits.side(self.at[axis]);
            let known = std::mem::replace(&mut limits.beyond, ends);
            let begins = limits.side(from[axis]);
            for (upper, farthest) in [(true, max[axis]), (false, min[axis])] {
                if limits.side(farthest) != Some(upper) {
                    continue;
                }
                let is_known = match self.runs {
                    true => begins == Some(upper) && farthest == from[axis],
                    false => known == Some(upper),
                };
                if !is_known {
                    tell(limits.alarm(self.dialect, upper, farthest, step.span));
                }
            }
        }
    }

    /// The software limit that a path passes which is run `shift` beside the place for which it was judged. It lies between
    /// `min` and `max`, `shift` aside.
    pub fn beside(
        &self,
        (min, max): (Position, Position),
        shift: Position,
        span: Span,
    ) -> Option<Box<Alarm>> {
        let moved =
            self.axes.iter().filter(|a| a.holds && shift[a.axis] != 0.0 && min[a.axis] != max[a.axis]);
        moved
            .filter_map(|limits| {
                let (low, high) =
                    (min[limits.axis] + shift[limits.axis], max[limits.axis] + shift[limits.axis]);
                let upper = limits.side(high) == Some(true);
                let passes = upper || limits.side(low) == Some(false);
                passes.then(|| {
                    Box::new(limits.alarm(self.dialect, upper, if upper { high } else { low }, span))
                })
            })
            .next()
    }

    fn alarm(&self, fault: Fault, step: &Step) -> Alarm {
        Alarm::new(self.dialect.alarm_id(fault), fault, step.span)
    }
}
