//! Arcs and helices (LinuxCNC, G2 and G3).

use crate::Fallible;
use crate::dialect::Meaning;
use crate::interpreter::Interpreter;
use crate::modal::Group;
use ferrocut_geometry::{Arc, Axis, AxisSet, MM_PER_INCH, Plane, Position, RadiusError, Turn};
use ferrocut_machine::Fault;
use ferrocut_toolpath::{FeedAlong, Op};
use std::f64::consts::{SQRT_2, TAU};

/// A radius below this is none, and by so much may a chord exceed the diameter of R, on each side, inches. In
/// metric programs the same, converted.
const LEAST_RADIUS_INCH: f64 = 0.000_05;

/// How far the radii at start and end may differ, where they differ by more than a thousandth: what coordinates
/// of three decimals in inches, or two in metric programs, make of an exact arc.
pub(super) const SPIRAL_INCH: f64 = 2.0 * 0.001 * SQRT_2;
const SPIRAL_MM: f64 = 2.0 * 0.01 * SQRT_2;

/// Radii that differ by less than this of them are one.
const SPIRAL_SHARE: f64 = 0.001;

/// Beyond so many times the difference above even an arc that is large enough is at fault.
const MOST_SPIRAL: f64 = 100.0;

/// Most turns of a helix.
const MOST_TURNS: f64 = 1e6;

/// A whole number may be written with this error.
const WHOLE: f64 = 0.001;

impl Interpreter {
    /// An arc to the point that the block leads to.
    pub(super) fn ngc_arc(&mut self, axes: AxisSet, turn: Turn) -> Fallible<()> {
        if self.ngc_uvw_plane() {
            return Err(self.ngc_alarm(Fault::ArcInUvwPlane));
        }
        let turns = self.ngc_turns()?;
        let plane = self.modal.plane();
        let has_centre = [b'I', b'J', b'K'].into_iter().any(|letter| self.words.has(letter));
        match (self.words.has(b'R'), has_centre) {
            (false, false) => return Err(self.ngc_alarm(Fault::ArcWithoutCentre)),
            (true, true) => return Err(self.ngc_alarm(Fault::ArcRadiusAndCentre)),
            _ => {}
        }
        let feed = self.ngc_feed()?;
        let (from, to) = (self.ngc.at, self.ngc_end_point(axes));
        let center = match self.ngc_length_word(b'R') {
            Some(radius) => self.ngc_centre_of_radius(axes, from, to, radius, turn)?,
            None => self.ngc_centre_of_words(from, to)?,
        };
        let mut arc = Arc::about(plane, from, to, center, turn);
        arc.sweep += (turns - 1.0) * TAU.copysign(arc.sweep);
        let machine = self.ngc.machine_of(to);
        self.ngc_check_reach(machine)?;
        if plane != Plane::Xy && self.ngc.turn.degrees != 0.0 {
            // Its plane would be none of the machine's.
            return Err(self.ngc_alarm(Fault::NotSupported));
        }
        let center = self.ngc_machine_plane_point(center);
        self.ngc.at = to;
        self.location.machine = machine;
        let path = self.ngc_path();
        let sweep = arc.sweep;
        self.emit(Op::Arc { to: machine, plane, center, sweep, feed, feed_along: FeedAlong::Path, path });
        Ok(())
    }

    /// Whether the plane is one of U, V, W.
    pub(super) fn ngc_uvw_plane(&self) -> bool {
        matches!(self.modal.meaning(Group::Plane), Meaning::PlaneOfUvw(_))
    }

    /// A point of the plane, on the machine's axes.
    pub(super) fn ngc_machine_plane_point(&self, [a, b]: [f64; 2]) -> [f64; 2] {
        let plane = self.modal.plane();
        let mut point = self.ngc.at;
        point[plane.first()] = a;
        point[plane.second()] = b;
        plane.of(self.ngc.machine_of(point))
    }

    /// P: whole and begun turns.
    fn ngc_turns(&self) -> Fallible<f64> {
        let Some(turns) = self.words.get(b'P') else { return Ok(1.0) };
        if (turns - turns.round()).abs() > WHOLE {
            return Err(self.alarm_at(Fault::WordNotWhole, b'P'));
        }
        match turns.round() {
            turns @ 1.0..=MOST_TURNS => Ok(turns),
            _ => {
                let alarm = self.alarm_at(Fault::WordOutOfRange, b'P');
                Err(Box::new(alarm.with("min", 1.0).with("max", MOST_TURNS)))
            }
        }
    }

    fn ngc_least_radius(&self) -> f64 {
        LEAST_RADIUS_INCH * MM_PER_INCH
    }

    /// The centre of an arc by its radius; the block must say where it ends.
    fn ngc_centre_of_radius(
        &self,
        axes: AxisSet,
        from: Position,
        to: Position,
        radius: f64,
        turn: Turn,
    ) -> Fallible<[f64; 2]> {
        let plane = self.modal.plane();
        let [a, b] = [plane.first(), plane.second()];
        if !axes.contains(a) && !axes.contains(b) {
            let alarm = self.ngc_alarm(Fault::WordMissing);
            return Err(Box::new(alarm.with("word", format!("{} {}", a.letter(), b.letter()))));
        }
        // The tolerance is that of half the chord against the radius.
        let slack = 2.0 * self.ngc_least_radius();
        Arc::center_from_radius(plane.of(from), plane.of(to), radius, turn, slack).map_err(
            |error| match error {
                RadiusError::SamePoint => self.ngc_alarm(Fault::ArcEndIsStart),
                RadiusError::TooFarApart(gap) => {
                    let alarm = self.alarm_at(Fault::ArcRadiusTooSmall, b'R');
                    Box::new(alarm.with("radius", radius.abs()).with("least", radius.abs() + gap / 2.0))
                }
            },
        )
    }

    /// The centre by I, J, K: from the start, or with G90.1 in the coordinate system.
    fn ngc_centre_of_words(&self, from: Position, to: Position) -> Fallible<[f64; 2]> {
        let plane = self.modal.plane();
        let foreign = centre_letter(plane.normal());
        if self.words.has(foreign) {
            return Err(self.alarm_at(Fault::ArcCentreLetter, foreign));
        }
        let absolute = self.modal.meaning(Group::CentreDistance) == Meaning::CentreAbsolute;
        let mut center = plane.of(from);
        for (slot, axis) in center.iter_mut().zip([plane.first(), plane.second()]) {
            let letter = centre_letter(axis);
            match self.ngc_length_word(letter) {
                Some(value) if absolute => *slot = value,
                Some(value) => *slot += value,
                None if absolute => {
                    return Err(self.ngc_missing(letter));
                }
                None => {}
            }
        }
        let [ca, cb] = center;
        let radius = |p: Position| {
            let [a, b] = plane.of(p);
            (a - ca).hypot(b - cb)
        };
        let (start, end) = (radius(from), radius(to));
        if !(start >= self.ngc_least_radius() && end >= self.ngc_least_radius()) {
            return Err(self.ngc_alarm(Fault::ArcWithoutRadius));
        }
        let limit = if self.modal.is_inch() { SPIRAL_INCH * MM_PER_INCH } else { SPIRAL_MM };
        let difference = (start - end).abs();
        let is_spiral = difference > limit && difference > SPIRAL_SHARE * start.max(end);
        if is_spiral || difference > MOST_SPIRAL * limit {
            let alarm = self.ngc_alarm(Fault::ArcRadiusMismatch);
            return Err(Box::new(alarm.with("start", start).with("end", end).with("limit", limit)));
        }
        Ok(center)
    }
}

/// Letter of the centre on an axis.
fn centre_letter(axis: Axis) -> u8 {
    match axis {
        Axis::X => b'I',
        Axis::Y => b'J',
        _ => b'K',
    }
}
