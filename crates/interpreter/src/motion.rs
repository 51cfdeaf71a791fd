//! Moves: straight ones, arcs and helices, from programmed end points to steps in machine axes.

use crate::Fallible;
use crate::dialect::Meaning;
use crate::execute::RotaryBlock;
use crate::interpreter::Interpreter;
use crate::modal::Group;
use crate::stages::corner::{CornerKind, CornerRequest};
use crate::stages::rotation::sin_cos_degrees;
use crate::stages::units;
use crate::words::letters;
use ferrocut_geometry::{Arc, Axis, AxisSet, MM_PER_INCH, Plane, Position, RadiusError, SAME_POINT_MM, Turn};
use ferrocut_machine::Fault;
use ferrocut_program::Span;
use ferrocut_toolpath::{Feed, FeedAlong, InnerCorners, Op, PathMode};
use std::f64::consts::TAU;

/// Largest machine coordinate, mm or degrees: a thousand times the range of any control, and small
/// enough that `f64` still resolves a tenth of a micrometre there.
const LARGEST_COORDINATE: f64 = 1e8;

/// Addresses that make an arc of a block without end point.
const CENTRE_LETTERS: u32 = letters(b"IJK");

/// Addresses of an end point by radius and angle.
const POLAR_LETTERS: u32 = letters(b"RQ");

/// What controls do differently in moves. The default is Fanuc's.
#[derive(Clone, Copy, PartialEq, Debug, Default)]
pub struct Rules {
    /// Positioning that moves Z moves it alone: upwards first, downwards last.
    pub rapid_moves_z_apart: bool,
    /// F in a block of positioning is its speed, and no feed.
    pub rapid_takes_feed: bool,
    /// R shorter than half the chord is taken as half the chord; else it is an alarm.
    pub short_radius_is_half_circle: bool,
    /// I, J, K are the centre in the work coordinate system; else from the start.
    pub centre_is_absolute: bool,
    /// K of an arc in the XY plane that climbs is its pitch, for more turns than one.
    pub helix_has_pitch: bool,
    /// Y turns.
    pub rotary_y: Option<RotaryY>,
    /// R and Q are radius and angle of an end point in the plane.
    pub polar_words: bool,
    /// Axes that turn the near way to where a program sends them with G90.
    pub near_way: AxisSet,
}

/// A rotary axis called Y.
#[derive(Clone, Copy, PartialEq, Debug)]
pub struct RotaryY {
    /// Degrees that 1 in a Y word stands for.
    pub degrees_per_unit: f64,
    /// Y words are lengths, which inches multiply.
    pub is_length: bool,
}

impl RotaryY {
    /// Degrees that 1 in a Y word stands for. Of the axis itself, which turns, no inch is made.
    fn degrees(&self, inch: bool) -> f64 {
        self.degrees_per_unit * if self.is_length && inch { MM_PER_INCH } else { 1.0 }
    }
}

/// Most turns of a helix.
const MAX_TURNS: f64 = 9999.0;

/// The angle that the near way from another one leads to: the same but for whole turns. Half a turn goes in the positive
/// direction.
pub(crate) fn near_way(from: f64, to: f64) -> f64 {
    to + 360.0 * (((from - to - 180.0) / 360.0).floor() + 1.0)
}

/// Turns that a helix may miss by rounding alone.
const TURN_ROUNDING: f64 = 1e-9;

impl Interpreter {
    /// The block's move by the motion code in force.
    pub(crate) fn motion_block(&mut self, axes: AxisSet, length_moves: bool) -> Fallible<()> {
        let motion = self.modal.meaning(Group::Motion);
        let turn = match motion {
            Meaning::ArcClockwise => Some(Turn::Clockwise),
            Meaning::ArcCounterClockwise => Some(Turn::CounterClockwise),
            _ => None,
        };
        let polar = self.has_polar_words(turn.is_some());
        if axes.is_empty() && !polar && !(turn.is_some() && self.words.has_any(CENTRE_LETTERS)) {
            if !length_moves {
                return Ok(());
            }
            // The code of an arc is in force from an earlier block: the axis moves straight.
            if turn.is_some() && !self.words.g.iter().any(|code| code.row.group == Group::Motion) {
                return self.cut(self.location.programmed);
            }
            if turn.is_some() {
                return Err(self.alarm(Fault::LengthInArc, self.words.block_span()));
            }
        }
        match motion {
            Meaning::OneWay => return self.position_one_way(axes),
            _ if turn.is_some() && length_moves => {
                return Err(self.alarm(Fault::LengthInArc, self.words.block_span()));
            }
            _ => {}
        }
        self.corner_word()?;
        let mut to = self.end_point(axes);
        if polar {
            self.radius_and_angle_point(&mut to, turn.is_some());
        }
        match turn {
            Some(_) if !self.has_own_axes() => Err(self.alarm(Fault::PlaneAxes, self.words.block_span())),
            Some(turn) => self.arc(to, axes, turn, polar),
            None if motion == Meaning::Rapid => self.rapid(to),
            None => self.cut(to),
        }
    }

    /// Whether the block moves an axis, or is an arc.
    pub(crate) fn block_moves(&self, axes: AxisSet) -> bool {
        let is_arc =
            matches!(self.modal.meaning(Group::Motion), Meaning::ArcClockwise | Meaning::ArcCounterClockwise);
        !axes.is_empty() || self.has_polar_words(is_arc) || is_arc && self.words.has_any(CENTRE_LETTERS)
    }

    /// Whether the block gives its end point by radius and angle. Beside coordinates of the plane, R of an arc
    /// is its radius.
    fn has_polar_words(&self, is_arc: bool) -> bool {
        if !self.rules.motion.polar_words || !self.words.has_any(POLAR_LETTERS) {
            return false;
        }
        let [a, b, _] = self.plane_axes();
        !is_arc || self.words.has(b'Q') && ![a, b].into_iter().any(|axis| self.words.has(axis.letter() as u8))
    }

    /// R and Q of the block, from the polar origin, or of an arc with a centre of its own from that; with G91
    /// added to those of where the tool is.
    fn radius_and_angle_point(&self, to: &mut Position, is_arc: bool) {
        let [a, b, _] = self.plane_axes();
        let here = [a, b].map(|axis| self.location.programmed[axis]);
        let [oa, ob] = if is_arc && self.words.has_any(CENTRE_LETTERS) {
            let (i, j) = center_letters(self.modal.plane());
            let word = |letter| units::length_mm(self.words.get(letter).unwrap_or(0.0), self.modal.is_inch());
            let from = if self.rules.motion.centre_is_absolute { [0.0; 2] } else { here };
            [from[0] + word(i), from[1] + word(j)]
        } else {
            self.polar_origin
        };
        let (x, y) = (here[0] - oa, here[1] - ob);
        let (radius, degrees) =
            (x.hypot(y), if x == 0.0 && y == 0.0 { 0.0 } else { y.atan2(x).to_degrees() });
        let incremental = self.modal.is_incremental();
        let word = |letter: u8, was: f64, inch: bool| match self.words.get(letter) {
            Some(value) if incremental => was + units::length_mm(value, inch),
            Some(value) => units::length_mm(value, inch),
            None => was,
        };
        let radius = word(b'R', radius, self.modal.is_inch());
        let (sin, cos) = sin_cos_degrees(word(b'Q', degrees, false));
        to[a] = oa + radius * cos;
        to[b] = ob + radius * sin;
    }

    /// G30: the polar origin, by I and J; without them where the tool is.
    pub(crate) fn set_polar_origin(&mut self) {
        let inch = self.modal.is_inch();
        let [a, b, _] = self.plane_axes();
        let here = [a, b].map(|axis| self.location.programmed[axis]);
        if !self.words.has(b'I') && !self.words.has(b'J') {
            self.polar_origin = here;
            return;
        }
        for ((slot, letter), at) in self.polar_origin.iter_mut().zip([b'I', b'J']).zip(here) {
            if let Some(value) = self.words.get(letter).map(|v| units::length_mm(v, inch)) {
                *slot = if self.modal.is_incremental() { at + value } else { value };
            }
        }
    }

    /// `,L` and `,R` (GSK990MC 4.2.18): a negative value is taken as positive.
    fn corner_word(&mut self) -> Fallible<()> {
        let Some((letter, value, span)) = self.words.comma else { return Ok(()) };
        let kind = match letter {
            b'L' => CornerKind::Chamfer,
            b'R' => CornerKind::Round,
            _ => return Err(self.alarm(Fault::CornerForm, span)),
        };
        // The programmed shape is scaled, its corners with it (4.2.14).
        let size = units::length_mm(value, self.modal.is_inch()).abs() * self.radius_factor();
        if size > 0.0 {
            self.output.request_corner(CornerRequest { kind, size, plane: self.modal.plane(), span });
        }
        Ok(())
    }

    /// Positions to a programmed point.
    pub(crate) fn rapid(&mut self, to: Position) -> Fallible<()> {
        let machine = self.location.machine_of(to);
        self.rapid_machine(machine)?;
        self.location.programmed = to;
        Ok(())
    }

    /// Positions to a machine point with cutter compensation left aside for this move (GSK990MC 4.7.2, 5). A
    /// move of other axes than those of its plane leaves the vector as it is.
    pub(crate) fn rapid_uncompensated(&mut self, to: Position) -> Fallible<()> {
        let plane = self.modal.plane();
        if plane.of(to) != plane.of(self.location.machine) {
            self.output.suspend_cutter();
        }
        self.rapid_machine(to)
    }

    /// Positions to a machine point. The programmed point is the caller's to set.
    pub(crate) fn rapid_machine(&mut self, to: Position) -> Fallible<()> {
        self.check_reach(to)?;
        if self.rules.motion.rapid_moves_z_apart {
            // Weihong 4.3, G00: out of the part before crossing it, and across before going down.
            let (from, mut corner) = (self.location.machine, to);
            if to[Axis::Z] > from[Axis::Z] {
                corner = from;
                corner[Axis::Z] = to[Axis::Z];
            } else {
                corner[Axis::Z] = from[Axis::Z];
            }
            self.rapid_to(corner);
        }
        self.rapid_to(to);
        Ok(())
    }

    #[inline]
    fn rapid_to(&mut self, to: Position) {
        if to != self.location.machine || self.output.takes_still_moves() {
            self.location.machine = to;
            let speed = self.technology.rapid_feed;
            self.emit(Op::Rapid {
                to,
                straight: self.rules.rapid_is_straight,
                speed,
                path: PathMode::ON_PATH,
            });
        }
    }

    /// Cuts straight to a machine point. The programmed point is the caller's to set.
    pub(crate) fn cut_machine(&mut self, to: Position) -> Fallible<()> {
        self.check_reach(to)?;
        let feed = self.feed_to(to)?;
        if to != self.location.machine || self.output.takes_still_moves() {
            self.location.machine = to;
            self.emit(Op::Feed { to, feed, path: self.path_mode() });
        }
        Ok(())
    }

    /// The Y word of a rotary axis, as degrees (Weihong 4.4, G907 and G908; 5, parameters 10 to 12).
    pub(crate) fn rotary_word(&mut self, rotary: RotaryY, block: RotaryBlock) {
        let Some(word) = self.words.get(b'Y') else { return };
        let mut degrees = if block.degrees { word } else { word * rotary.degrees(self.modal.is_inch()) };
        if block.shortest && !self.modal.is_incremental() {
            degrees = near_way(self.location.programmed[Axis::Y], degrees);
        }
        self.words.put(b'Y', degrees);
    }

    /// A coordinate in mm or degrees as the program would write it.
    pub(crate) fn in_words(&self, axis: Axis, value: f64) -> f64 {
        match self.rules.motion.rotary_y {
            Some(rotary) if axis == Axis::Y => value / rotary.degrees(self.modal.is_inch()),
            _ => units::in_words(axis, value, self.inch_axes()),
        }
    }

    /// A shape in a plane with an axis that turns would be made of mm and degrees.
    pub(crate) fn refuse_rotary_plane(&self, plane: Plane, span: Span) -> Fallible<()> {
        let turns = self.rules.motion.rotary_y.is_some() && plane.normal() != Axis::Y;
        if turns { Err(self.alarm(Fault::RotaryInPlane, span)) } else { Ok(()) }
    }

    /// Cuts straight to a programmed point.
    pub(crate) fn cut(&mut self, to: Position) -> Fallible<()> {
        self.cut_as(to, self.path_mode())
    }

    /// The same whatever path mode is in force.
    pub(crate) fn cut_as(&mut self, to: Position, path: PathMode) -> Fallible<()> {
        let machine = self.location.machine_of(to);
        self.check_reach(machine)?;
        let feed = self.feed_to(machine)?;
        self.location.programmed = to;
        if machine != self.location.machine || self.output.takes_still_moves() {
            self.location.machine = machine;
            self.emit(Op::Feed { to: machine, feed, path });
        }
        Ok(())
    }

    /// How the path runs into the next move (G61 to G64).
    pub(crate) fn path_mode(&self) -> PathMode {
        if self.full_feed {
            return PathMode::FullFeed;
        }
        match self.modal.meaning(Group::PathControl) {
            Meaning::ExactStop => PathMode::ExactStop,
            Meaning::TappingMode => PathMode::Tapping,
            // A block with a code of compensation has no inner corner (4.8.2 limits).
            Meaning::CornerOverride if self.words.g.iter().any(|code| code.row.group == Group::Cutter) => {
                PathMode::Continuous
            }
            Meaning::CornerOverride => match (self.rules.corner_override, self.output.tool_is_left()) {
                (Some((rule, lowest_feed)), Some(left)) => {
                    let plane = self.modal.plane();
                    PathMode::InnerCorners(InnerCorners { plane, left, rule, lowest_feed })
                }
                _ => PathMode::Continuous,
            },
            _ => PathMode::Continuous,
        }
    }

    /// The feed in force, per minute with the control's limit where it is beyond one (GSK990MC 4.2.2 note 1, P96, P97); an
    /// alarm where there is none. The speed that overrides and the spindle make of it is held by motion.
    pub(crate) fn feed(&self) -> Fallible<Feed> {
        self.feed_in(1.0)
    }

    /// That of a straight cut to a machine point: degrees where nothing but rotary axes moves, which have no inch (GSK990MC
    /// 0#2).
    pub(crate) fn feed_to(&self, machine: Position) -> Fallible<Feed> {
        let unit = self.technology.feed_unit;
        let stands = |axis: Axis| machine[axis] == self.location.machine[axis];
        let turns = unit != 1.0 && self.rules.linear_axes.iter().all(stands);
        self.feed_in(if turns { unit } else { 1.0 })
    }

    /// The feed in a unit of so many millimetres.
    fn feed_in(&self, unit: f64) -> Fallible<Feed> {
        let technology = &self.technology;
        let (value, feed) = match self.modal.is_feed_per_revolution() {
            true => {
                let feed = technology.feed_per_revolution / unit;
                (feed, Feed::PerRevolution(feed))
            }
            false => {
                let programmed = technology.feed_per_minute / unit;
                let at = programmed.clamp(self.rules.min_feed, self.rules.max_feed);
                let is_within = at == programmed;
                (programmed, if is_within { Feed::PerMinute(at) } else { Feed::Held { programmed, at } })
            }
        };
        if value > 0.0 { Ok(feed) } else { Err(self.alarm(Fault::NoFeed, self.words.block_span())) }
    }

    pub(crate) fn check_reach(&self, machine: Position) -> Fallible<()> {
        if self.location.scaling.is_some() {
            let point = machine - self.location.work.shift - self.location.length.vector;
            if point.0.iter().any(|c| c.abs() > self.rules.max_coordinate) {
                return Err(self.alarm(Fault::ScaledTooLarge, self.words.block_span()));
            }
        }
        // The comparison is false for NaN too.
        if machine.0.iter().all(|c| c.abs() <= LARGEST_COORDINATE) {
            return Ok(());
        }
        Err(self.alarm(Fault::CoordinateTooLarge, self.words.block_span()))
    }

    /// Cuts along an arc or helix to a programmed point (GSK990MC 4.2.3).
    ///
    /// Centre and radius are judged after scaling and rotation, so that an arc that unequal factors pull
    /// out of shape is found (4.2.14, 6). It starts where the tool is.
    fn arc(&mut self, to: Position, axes: AxisSet, turn: Turn, polar: bool) -> Fallible<()> {
        let plane = self.modal.plane();
        self.refuse_rotary_plane(plane, self.words.block_span())?;
        if self.location.polar.is_some() && self.rules.polar_is_strict && !self.words.has(b'R') {
            return Err(self.alarm(Fault::ArcInPolar, self.words.block_span()));
        }
        let machine = self.location.machine_of(to);
        let offset = self.location.work.shift + self.location.length.vector;
        let (from, end) = (self.location.in_work(), machine - offset);
        let mut mirrored = self.location.scaling.is_some_and(|scaling| scaling.reverses(plane));
        if let Some(nested) = &self.location.nested {
            if nested.tilts(plane) {
                return Err(self.alarm(Fault::PlaneInRotation, self.words.block_span()));
            }
            mirrored ^= nested.reverses(plane);
        }
        let turn = if mirrored { turn.reversed() } else { turn };
        let center = match self.words.get(b'R').filter(|_| !polar) {
            Some(r) => match self.center_by_radius(from, end, r, turn)? {
                Some(center) => center,
                // Start and end coincide: a radius says nothing then (4.2.3 limits 3 and 5), and no other
                // axis can climb.
                None if machine != self.location.machine => {
                    return Err(self.alarm(Fault::HelixWithoutArc, self.words.block_span()));
                }
                None => {
                    self.tell(*self.alarm_at(Fault::ArcOfNoLength, b'R'));
                    return Ok(());
                }
            },
            // About the polar origin, where no centre is given.
            None if polar && !self.words.has_any(CENTRE_LETTERS) => {
                let mut middle = self.location.programmed;
                middle[plane.first()] = self.polar_origin[0];
                middle[plane.second()] = self.polar_origin[1];
                let center = plane.of(self.location.machine_of(middle) - offset);
                self.check_radii(plane.of(from), plane.of(end), center, b'Q')?;
                center
            }
            None => self.center_by_vector(from, end)?,
        };
        let in_plane = |a: Axis| a == plane.first() || a == plane.second();
        let mut beside = axes.iter().filter(|a| !in_plane(*a) && from[*a] != end[*a]);
        // One axis climbs in a helix, and it is one of the first three (GSK990MC alarms 0232, 0021).
        match (beside.next(), beside.next()) {
            (Some(_), Some(_)) => {
                return Err(self.alarm(Fault::TooManyHelicalAxes, self.words.block_span()));
            }
            (Some(axis), None) if !self.rules.axis_order.iter().take(3).any(|a| *a == axis) => {
                let alarm = self.alarm_at(Fault::ArcAxisBesidePlane, axis.letter() as u8);
                return Err(Box::new(alarm.with("axis", axis.letter().to_string())));
            }
            _ => {}
        }
        let mut shape = Arc::about(plane, from, end, center, turn);
        if self.rules.motion.helix_has_pitch && plane == Plane::Xy {
            // Both as they are programmed: scaling changes neither the one nor the other alone.
            let climb = (to[Axis::Z] - self.location.programmed[Axis::Z]).abs();
            self.add_turns(&mut shape, climb)?;
        }
        let feed = self.feed()?;
        self.check_reach(machine)?;
        // Work offset and tool length move the arc as a whole.
        let [a, b] = plane.of(offset);
        self.location.programmed = to;
        self.location.machine = machine;
        let feed_along = match self.rules.helix_feed_along_circle {
            true => FeedAlong::Circle,
            false => FeedAlong::Path,
        };
        self.emit(Op::Arc {
            to: machine,
            plane,
            center: [center[0] + a, center[1] + b],
            sweep: shape.sweep,
            feed,
            feed_along,
            path: self.path_mode(),
        });
        Ok(())
    }

    /// What a programmed radius is multiplied by: the larger of the plane's factors of scaling.
    fn radius_factor(&self) -> f64 {
        let plane = self.modal.plane();
        let scaled = self.location.scaling.map_or(1.0, |scaling| {
            let [a, b] = scaling.in_plane(plane);
            a.abs().max(b.abs())
        });
        self.location.nested.map_or(scaled, |nested| scaled * nested.factor(plane))
    }

    /// K as pitch (Weihong 4.3, G02): as many more full turns as the climb has room for. Its sign is left
    /// aside.
    fn add_turns(&self, shape: &mut Arc, climb: f64) -> Fallible<()> {
        let inch = self.modal.is_inch();
        let Some(pitch) = self.words.get(b'K').map(|k| units::length_mm(k, inch).abs()) else {
            return Ok(());
        };
        if pitch == 0.0 || climb == 0.0 {
            return Ok(());
        }
        let more = (climb / pitch - shape.sweep.abs() / TAU + TURN_ROUNDING).floor().max(0.0);
        if more > MAX_TURNS {
            return Err(self.alarm_at(Fault::WordOutOfRange, b'K'));
        }
        shape.sweep += (more * TAU).copysign(shape.sweep);
        Ok(())
    }

    /// The centre that R gives; `None` where start and end coincide. A radius is scaled by the larger of
    /// the plane's factors (GSK990MC 4.2.14, 6).
    fn center_by_radius(
        &self,
        from: Position,
        to: Position,
        r: f64,
        turn: Turn,
    ) -> Fallible<Option<[f64; 2]>> {
        let plane = self.modal.plane();
        let r = units::length_mm(r, self.modal.is_inch()) * self.radius_factor();
        let slack = match self.rules.motion.short_radius_is_half_circle {
            true => f64::INFINITY,
            false => self.rules.arc_tolerance,
        };
        match Arc::center_from_radius(plane.of(from), plane.of(to), r, turn, slack) {
            Ok(center) => Ok(Some(center)),
            Err(RadiusError::SamePoint) => Ok(None),
            Err(RadiusError::TooFarApart(gap)) => {
                let mut alarm = self.alarm_at(Fault::ArcRadiusTooSmall, b'R');
                alarm.arguments.push(("radius", r.abs().into()));
                alarm.arguments.push(("least", (r.abs() + gap / 2.0).into()));
                Err(alarm)
            }
        }
    }

    /// The centre that I, J, K give from the start; both radii must agree (GSK990MC P214, alarm 20).
    fn center_by_vector(&self, from: Position, to: Position) -> Fallible<[f64; 2]> {
        let plane = self.modal.plane();
        let (i, j) = center_letters(plane);
        if !self.words.has(i) && !self.words.has(j) {
            return Err(self.alarm(Fault::ArcWithoutCentre, self.words.block_span()));
        }
        let inch = self.modal.is_inch();
        let word = |letter| units::length_mm(self.words.get(letter).unwrap_or(0.0), inch);
        let mut vector = [word(i), word(j)];
        if self.rules.motion.centre_is_absolute {
            let [a, b] = plane.of(self.location.programmed);
            vector = [vector[0] - a, vector[1] - b];
        }
        if let Some(nested) = &self.location.nested {
            vector = nested.vector(plane, vector);
        }
        if let Some(scaling) = &self.location.scaling {
            let [a, b] = scaling.in_plane(plane);
            vector = [vector[0] * a, vector[1] * b];
        }
        if let Some(rotation) = &self.location.rotation {
            vector = rotation.apply_vector(vector);
        }
        let [a, b] = plane.of(from);
        let center = [a + vector[0], b + vector[1]];
        self.check_radii([a, b], plane.of(to), center, i)?;
        Ok(center)
    }

    /// An arc has a radius, and the same one at both ends. `letter` is at fault where it has none.
    fn check_radii(&self, from: [f64; 2], to: [f64; 2], center: [f64; 2], letter: u8) -> Fallible<()> {
        let start_radius = (from[0] - center[0]).hypot(from[1] - center[1]);
        let end_radius = (to[0] - center[0]).hypot(to[1] - center[1]);
        if start_radius < SAME_POINT_MM {
            // In compensation there is a number for it of its own (GSK990MC 0038).
            let fault = if self.output.in_cutter_mode() {
                Fault::ArcWithoutRadiusInCutter
            } else {
                Fault::ArcWithoutRadius
            };
            return Err(self.alarm_at(fault, letter));
        }
        let difference = (start_radius - end_radius).abs();
        // Rounding of the programmed decimals must not decide at the limit itself.
        if difference > self.rules.arc_tolerance + SAME_POINT_MM {
            let mut alarm = self.alarm(Fault::ArcRadiusMismatch, self.words.block_span());
            alarm.arguments.push(("start", start_radius.into()));
            alarm.arguments.push(("end", end_radius.into()));
            alarm.arguments.push(("limit", self.rules.arc_tolerance.into()));
            return Err(alarm);
        }
        Ok(())
    }
}

/// Addresses of the centre on the first and second axis of a plane.
fn center_letters(plane: Plane) -> (u8, u8) {
    match plane {
        Plane::Xy => (b'I', b'J'),
        Plane::Zx => (b'K', b'I'),
        Plane::Yz => (b'J', b'K'),
    }
}
