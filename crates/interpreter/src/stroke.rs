//! Stored stroke checks 1 and 2 (GSK990MC part 2, 2.6): areas that the tool may not enter.
//!
//! Check 1 bounds the machine: outside of it is forbidden. Check 2, on with G12 and off with G13, forbids
//! the inside or the outside of a box (11#0). Both are in machine coordinates and judged before a move.

use crate::Fallible;
use crate::interpreter::Interpreter;
use crate::stages::units;
use ferrocut_geometry::{Axis, AxisSet, Position};
use ferrocut_machine::{Alarm, Fault, ParameterKey};
use ferrocut_program::Span;
use ferrocut_toolpath::Op;

/// Axes that the checks have bounds for.
pub const STROKE_AXES: usize = 5;

/// Coordinates this little beyond a bound are on it, mm: what sums of decimals leave.
const ON_BOUND: f64 = 1e-6;

/// Chords that an arc is judged by, a turn; they leave its inside by a thousandth of its radius.
const CHORDS_A_TURN: f64 = 72.0;

/// What the parameters set for the checks.
#[derive(Clone, Copy, PartialEq, Debug)]
pub struct StrokeRules {
    /// Bounds of check 1 by axis: lower, upper, mm or degrees.
    pub first: [(f64, f64); STROKE_AXES],
    /// Bounds of check 2.
    pub second: [(f64, f64); STROKE_AXES],
    /// Check 2 forbids the outside; else the inside.
    pub second_forbids_outside: bool,
    /// Number of the data parameter with the lower bound of check 2 on the first axis; the others follow,
    /// lower and upper in turn.
    pub second_parameter: u16,
    /// Whether check 1 forbids anything that a program can reach.
    pub first_is_set: bool,
}

/// Neither check forbids anything.
impl Default for StrokeRules {
    fn default() -> StrokeRules {
        let unbounded = [(f64::NEG_INFINITY, f64::INFINITY); STROKE_AXES];
        StrokeRules {
            first: unbounded,
            second: unbounded,
            second_forbids_outside: false,
            second_parameter: 0,
            first_is_set: false,
        }
    }
}

impl Interpreter {
    /// G12 X Y Z I J K: sets the box and turns check 2 on. It stays on where that is an alarm.
    pub(crate) fn stroke_check_on(&mut self, span: Span) -> Fallible<()> {
        if self.words.g.len() > 1 {
            return Err(self.alarm(Fault::StrokeNotAlone, span));
        }
        let inch = self.modal.is_inch();
        let corners = [(b'X', b'I'), (b'Y', b'J'), (b'Z', b'K')];
        for (index, (upper, lower)) in (0u16..).zip(corners) {
            let parameter = self.rules.stroke.second_parameter + 2 * index;
            for (letter, number) in [(lower, parameter), (upper, parameter + 1)] {
                let Some(value) = self.words.get(letter) else { continue };
                let value = units::length_mm(value, inch);
                if self.memory.set_parameter(&ParameterKey::Data(number), value).is_err() {
                    return Err(self.alarm_at(Fault::WordOutOfRange, letter));
                }
            }
        }
        self.rules = (self.dialect.rules)(&self.memory.parameters);
        let is_box = |(lower, upper): &(f64, f64)| lower < upper;
        if !self.rules.stroke.second.iter().take(3).all(is_box) {
            return Err(self.alarm(Fault::StrokeCorners, self.words.block_span()));
        }
        // Places that are not known yet are not judged (2.6, 5).
        match self.stands_in_second(self.output.path_end, self.unreferenced.axes) {
            true => Err(self.alarm(Fault::StoredStroke, self.words.block_span())),
            false => Ok(()),
        }
    }

    /// The alarm of axes that stand where check 2 forbids it, if it is on, as power comes on with 11#6 = 1 (2.6, 5), or until
    /// they are moved out (2.6, 6): known or not, the places are taken for what they are.
    pub fn stroke_alarm_at(&self, at: Position) -> Option<Box<Alarm>> {
        let is_forbidden = self.stroke_check_2 && self.stands_in_second(at, AxisSet::EMPTY);
        is_forbidden.then(|| self.alarm(Fault::StoredStroke, self.words.block_span()))
    }

    /// Whether axes that stand there are where check 2 forbids it, an alarm as soon as it is on (2.6, 7), but those `unknown`.
    fn stands_in_second(&self, at: Position, unknown: AxisSet) -> bool {
        let stroke = &self.rules.stroke;
        let is_known = |axis: Axis| self.rules.axes.contains(axis) && !unknown.contains(axis);
        let mut bounds = self.rules.axis_order.iter().zip(&stroke.second);
        match stroke.second_forbids_outside {
            true => bounds.any(|(axis, (lower, upper))| {
                is_known(*axis) && !(lower - ON_BOUND..=upper + ON_BOUND).contains(&at[*axis])
            }),
            false => bounds.take(3).all(|(axis, (lower, upper))| {
                is_known(*axis) && at[*axis] > lower + ON_BOUND && at[*axis] < upper - ON_BOUND
            }),
        }
    }

    /// The alarm of a move from `from`, if it enters a forbidden area.
    pub fn stroke_alarm(&self, from: Position, op: &Op) -> Option<Box<Alarm>> {
        self.stroke_alarm_of(from, op, self.stroke_check_2)
    }

    /// The same where stored stroke check 2 is on or off.
    pub(crate) fn stroke_alarm_of(&self, from: Position, op: &Op, check_2: bool) -> Option<Box<Alarm>> {
        let stroke = &self.rules.stroke;
        let (min, max) = op.extent(from)?;
        if let Some(alarm) = self.first_stroke_alarm(min, max) {
            return Some(alarm);
        }
        if !check_2 {
            return None;
        }
        let enters = match stroke.second_forbids_outside {
            true => self.outside(&stroke.second, min, max).is_some(),
            false => self.knows_box() && self.crosses(&stroke.second, from, op),
        };
        enters.then(|| self.alarm(Fault::StoredStroke, self.words.block_span()))
    }

    /// Whether stored stroke check 2 holds for the block read last (G12, G13).
    pub fn stroke_check(&self) -> bool {
        self.stroke_check_2
    }

    /// The alarm of a way on which each axis goes by itself, so that all between two places may be passed: of the box that
    /// they span.
    /// `check_2` is whether stored stroke check 2 holds there ([`stroke_check`](Self::stroke_check)).
    pub fn stroke_between(&self, one: Position, other: Position, check_2: bool) -> Option<Box<Alarm>> {
        let stroke = &self.rules.stroke;
        let min = Position(std::array::from_fn(|n| one.0[n].min(other.0[n])));
        let max = Position(std::array::from_fn(|n| one.0[n].max(other.0[n])));
        if let Some(alarm) = self.first_stroke_alarm(min, max) {
            return Some(alarm);
        }
        let is_inside = |(axis, (lower, upper)): (&Axis, &(f64, f64))| {
            max[*axis] > lower + ON_BOUND && min[*axis] < upper - ON_BOUND
        };
        let enters = check_2
            && match stroke.second_forbids_outside {
                true => self.outside(&stroke.second, min, max).is_some(),
                false => {
                    self.knows_box()
                        && self.rules.axis_order.iter().zip(&stroke.second).take(3).all(is_inside)
                }
            };
        enters.then(|| self.alarm(Fault::StoredStroke, self.words.block_span()))
    }

    /// The alarm of stored stroke check 1 for what lies between these places.
    fn first_stroke_alarm(&self, min: Position, max: Position) -> Option<Box<Alarm>> {
        let stroke = &self.rules.stroke;
        let (index, upper) = stroke.first_is_set.then(|| self.outside(&stroke.first, min, max)).flatten()?;
        let id = self.dialect.soft_limit_id(index, upper);
        let mut alarm = Alarm::new(id, Fault::SoftLimit, self.words.block_span());
        if let (Some(axis), Some((low, high))) = (self.rules.axis_order.get(index), stroke.first.get(index)) {
            let (position, limit) = if upper { (max[*axis], *high) } else { (min[*axis], *low) };
            alarm =
                alarm.with("axis", axis.letter().to_string()).with("position", position).with("limit", limit);
        }
        Some(Box::new(alarm))
    }

    /// How far an axis may be moved by hand from `at`, lower and upper machine position. Axes that are `moving` may be
    /// anywhere. Within an area that is forbidden an axis may go on, so that it comes out of it (2.6).
    pub fn stroke_room(&self, axis: Axis, at: Position, moving: AxisSet, check_2: bool) -> (f64, f64) {
        let stroke = &self.rules.stroke;
        let (mut low, mut high) = (f64::NEG_INFINITY, f64::INFINITY);
        let Some(index) = self.rules.axis_order.iter().position(|other| *other == axis) else {
            return (low, high);
        };
        let mut within = |bounds: &[(f64, f64); STROKE_AXES]| {
            if let Some((lower, upper)) = bounds.get(index) {
                (low, high) = (low.max(*lower), high.min(*upper));
            }
        };
        if stroke.first_is_set {
            within(&stroke.first);
        }
        if check_2 && stroke.second_forbids_outside {
            within(&stroke.second);
        }
        let box_of = |n: usize| stroke.second.get(n).copied();
        if let Some((lower, upper)) = box_of(index).filter(|_| index < 3)
            && check_2
            && !stroke.second_forbids_outside
        {
            let others = self.rules.axis_order.iter().enumerate().take(3).filter(|(n, _)| *n != index);
            let mut others = others.filter_map(|(n, other)| Some((*other, box_of(n)?)));
            let is_beside = others.all(|(other, (lower, upper))| {
                let place = at[other];
                moving.contains(other) || place > lower + ON_BOUND && place < upper - ON_BOUND
            });
            if is_beside && at[axis] <= lower + ON_BOUND {
                high = high.min(lower);
            } else if is_beside && at[axis] >= upper - ON_BOUND {
                low = low.max(upper);
            }
        }
        (low, high)
    }

    /// Whether the places of the three axes are judged of which a box is made.
    fn knows_box(&self) -> bool {
        let unknown = self.unreferenced.not_judged();
        !self.rules.axis_order.iter().take(3).any(|axis| unknown.contains(*axis))
    }

    /// The first axis that leaves its bounds, and on which side.
    fn outside(
        &self,
        bounds: &[(f64, f64); STROKE_AXES],
        min: Position,
        max: Position,
    ) -> Option<(usize, bool)> {
        for (index, (axis, (lower, upper))) in self.rules.axis_order.iter().zip(bounds).enumerate() {
            if !self.rules.axes.contains(*axis) || self.unreferenced.not_judged().contains(*axis) {
                continue;
            }
            if min[*axis] < lower - ON_BOUND {
                return Some((index, false));
            }
            if max[*axis] > upper + ON_BOUND {
                return Some((index, true));
            }
        }
        None
    }

    /// Whether a move touches the inside of a box over the first three axes.
    fn crosses(&self, bounds: &[(f64, f64); STROKE_AXES], from: Position, op: &Op) -> bool {
        let Some(to) = op.target() else { return false };
        let Some(arc) = op.arc(from) else { return self.line_crosses(bounds, from, *to) };
        let chords = (arc.sweep.abs() / std::f64::consts::TAU * CHORDS_A_TURN).ceil().clamp(1.0, 100_000.0);
        let mut at = from;
        for chord in 1..=chords as u32 {
            let next = arc.at(f64::from(chord) / chords);
            if self.line_crosses(bounds, at, next) {
                return true;
            }
            at = next;
        }
        false
    }

    /// Slab method: the stretch of the line within the bounds of every axis at once.
    fn line_crosses(&self, bounds: &[(f64, f64); STROKE_AXES], from: Position, to: Position) -> bool {
        let (mut first, mut last) = (0.0f64, 1.0f64);
        for (axis, (lower, upper)) in self.rules.axis_order.iter().zip(bounds).take(3) {
            let (start, way) = (from[*axis], to[*axis] - from[*axis]);
            let (lower, upper) = (lower + ON_BOUND, upper - ON_BOUND);
            if way == 0.0 {
                if start <= lower || start >= upper {
                    return false;
                }
                continue;
            }
            let (a, b) = ((lower - start) / way, (upper - start) / way);
            first = first.max(a.min(b));
            last = last.min(a.max(b));
        }
        first < last
    }
}
