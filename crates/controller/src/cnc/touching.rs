//! A probe or tool is led to touches outside of any program (`measure`): guarded moves, searches, slow touches.
//!
//! It is run as a program is: cycle start begins and goes on, feed hold holds, reset gives it up, the overrides hold. Its
//! steps are made one by one, since each touch says where the next move begins.

use super::{Cnc, State};
use crate::measure::Touching;
use ferrocut_geometry::Position;
use ferrocut_interpreter::AtRest;
use ferrocut_machine::{Alarm, Fault};
use ferrocut_program::Span;
use ferrocut_toolpath::{Feed, Op, PathMode, SpindleState, Step};

/// Two touches nearer than this are one: the probe was not free in between, mm.
const NOT_FREE: f64 = 1e-3;

/// What comes next of a touch.
#[derive(Clone, Copy, PartialEq, Debug)]
enum Stage {
    /// The guarded move with this number.
    Via(usize),
    /// The search.
    Search,
    /// Back from where the probe touched.
    BackOff,
    /// The touch that counts.
    Fine,
    /// Back to where the search began.
    Return,
}

/// What comes next of all.
#[derive(Clone, Copy, PartialEq, Debug)]
enum Next {
    Spindle,
    Touch(usize, Stage),
    End(usize),
    SpindleOff,
    /// The interpreter is told where the axes stand.
    Tell,
    Done,
}

/// Touches that are under way.
#[derive(Debug)]
pub(super) struct Touches {
    plan: Touching,
    next: Next,
    /// The skip move that is under way.
    runs: Option<Next>,
    /// Where the search of the touch under way began.
    began: Position,
    /// Where it touched, and where the slow move began.
    searched: Position,
    backed: Position,
    touched: Vec<Position>,
}

impl Touches {
    fn new(plan: Touching, from: Position) -> Touches {
        let touched = Vec::with_capacity(plan.touches.len());
        let mut touches = Touches {
            plan,
            next: Next::Spindle,
            runs: None,
            began: from,
            searched: from,
            backed: from,
            touched,
        };
        if touches.plan.spindle.is_none() {
            touches.next = touches.first_of(0);
        }
        touches
    }

    fn first_of(&self, touch: usize) -> Next {
        match self.plan.touches.get(touch) {
            Some(found) if found.via.is_empty() => Next::Touch(touch, Stage::Search),
            Some(_) => Next::Touch(touch, Stage::Via(0)),
            None => self.end(0),
        }
    }

    fn end(&self, number: usize) -> Next {
        match (number < self.plan.end.len(), self.plan.spindle.is_some()) {
            (true, _) => Next::End(number),
            (false, true) => Next::SpindleOff,
            (false, false) => Next::Tell,
        }
    }

    /// The next operation; none once all is done. `at` is where the axes stand or will stand before it.
    fn step(&mut self, at: Position) -> Option<Op> {
        let pace = self.plan.pace;
        let skip = |to: Position, speed: f64| Op::Skip {
            to,
            feed: Feed::PerMinute(speed),
            hit: true,
            away: false,
            input: None,
        };
        let back =
            |to: Position| Op::Rapid { to, straight: true, speed: Some(pace.way), path: PathMode::ON_PATH };
        let now = self.next;
        let (op, next) = match now {
            Next::Spindle => (Op::Spindle(self.plan.spindle.unwrap_or(SpindleState::Off)), self.first_of(0)),
            Next::Touch(n, stage) => {
                let touch = self.plan.touches.get(n)?;
                match stage {
                    Stage::Via(k) => {
                        let stage = if k + 1 < touch.via.len() { Stage::Via(k + 1) } else { Stage::Search };
                        (skip(*touch.via.get(k)?, pace.way), Next::Touch(n, stage))
                    }
                    Stage::Search => {
                        self.began = at;
                        (skip(touch.limit, pace.search), Next::Touch(n, Stage::BackOff))
                    }
                    Stage::BackOff => {
                        self.backed = back_off(self.searched, self.began, pace.back_off);
                        (back(self.backed), Next::Touch(n, Stage::Fine))
                    }
                    Stage::Fine => (skip(touch.limit, pace.fine), Next::Touch(n, Stage::Return)),
                    Stage::Return => (back(self.began), self.first_of(n + 1)),
                }
            }
            Next::End(n) => (skip(*self.plan.end.get(n)?, pace.way), self.end(n + 1)),
            Next::SpindleOff => (Op::Spindle(SpindleState::Off), Next::Tell),
            Next::Tell => (Op::Barrier, Next::Done),
            Next::Done => return None,
        };
        self.next = next;
        self.runs = matches!(op, Op::Skip { .. }).then_some(now);
        Some(op)
    }

    /// A skip move ended at `at`, where the probe touched or without a touch. What is wrong with that.
    fn ended(&mut self, touched: Option<Position>, at: Position) -> Result<(), Box<Alarm>> {
        let alarm = |fault: Fault| Alarm::core(fault, Span::default());
        match (self.runs.take(), touched) {
            (Some(Next::Touch(_, Stage::Search)), Some(touched)) => {
                // A probe that touches where it should be free yet.
                if touched.distance(self.began) < NOT_FREE {
                    return Err(Box::new(alarm(Fault::ProbeTouches)));
                }
                self.searched = touched;
            }
            (Some(Next::Touch(_, Stage::Fine)), Some(touched)) => {
                if touched.distance(self.backed) < NOT_FREE {
                    return Err(Box::new(alarm(Fault::ProbeTouches)));
                }
                self.touched.push(touched);
            }
            (Some(Next::Touch(_, Stage::Search | Stage::Fine)), None) => {
                let way = at - self.began;
                let axis = ferrocut_geometry::Axis::ALL
                    .into_iter()
                    .max_by(|a, b| way[*a].abs().total_cmp(&way[*b].abs()))
                    .unwrap_or(ferrocut_geometry::Axis::X);
                let missed = alarm(self.plan.missed).with("axis", axis.letter().to_string());
                return Err(Box::new(missed.with("position", at[axis])));
            }
            (_, Some(_)) => return Err(Box::new(alarm(Fault::ProbeTouches))),
            (_, None) => {}
        }
        Ok(())
    }
}

/// The place `distance` before `touched` on the way from `began`, no farther back than that.
fn back_off(touched: Position, began: Position, distance: f64) -> Position {
    let way = touched.distance(began);
    let part = if way > distance { distance / way } else { 1.0 };
    Position(std::array::from_fn(|i| {
        let at = |place: &Position| place.0.get(i).copied().unwrap_or_default();
        at(&touched) + (at(&began) - at(&touched)) * part
    }))
}

impl Cnc {
    /// Leads a probe to touches: they are begun by cycle start. Not while a program is under way, an axis moves, or
    /// without a probe; whether they wait for cycle start now. The program that was loaded is to be loaded anew.
    pub fn touch(&mut self, plan: Touching) -> bool {
        let may = self.is_idle() && self.motion.at_rest() && self.drives.has_probe();
        if may {
            self.wait_for_start();
            self.forget_journal();
            self.skip_shift = Position::ZERO;
            self.taking_up.at = (self.interpreter.blocks_begun() + 1, Span::default());
            self.touches = Some(Box::new(Touches::new(plan, self.motion.position())));
        }
        may
    }

    /// Whether there is a probe.
    pub fn has_probe(&self) -> bool {
        self.drives.has_probe()
    }

    /// Machine positions that were touched, in their order; all of them once the state is [`State::Ended`].
    pub fn touched(&self) -> &[Position] {
        self.touches.as_ref().map_or(&[], |touches| &touches.touched)
    }

    /// Whether a probe is led to touches, or waits for cycle start to be.
    pub fn touches(&self) -> bool {
        self.touches.is_some()
    }

    /// The step of theirs that comes; none where they are done.
    pub(super) fn next_of_touches(&mut self) -> Option<Result<Step, Box<Alarm>>> {
        let (block, at) = (self.taking_up.at.0, self.commanded);
        let op = self.touches.as_mut()?.step(at)?;
        // Areas that are forbidden to programs are so to a probe.
        if let Some(alarm) = self.interpreter.stroke_alarm(at, &op) {
            return Some(Err(Box::new(Alarm { span: Span::default(), ..*alarm })));
        }
        Some(Ok(Step::new(op, Span::default(), block)))
    }

    /// A skip move of theirs ended.
    pub(super) fn end_touch(&mut self, touched: Option<Position>) {
        let at = self.motion.position();
        self.skip_shift = Position::ZERO;
        let Some(touches) = &mut self.touches else { return };
        if let Err(mut alarm) = touches.ended(touched, at) {
            alarm.id = self.interpreter.dialect().alarm_id(alarm.fault);
            self.state = State::Alarmed(alarm);
        }
    }

    /// They are given up or another program comes: the interpreter goes on where the axes stand.
    pub(super) fn forget_touches(&mut self) {
        if self.touches.take().is_some() {
            let commanded = self.motion.position();
            self.interpreter.own().came_to_rest(&AtRest::new(commanded, self.actual));
        }
    }
}
