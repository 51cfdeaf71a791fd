//! Arcs and helices (LinuxCNC, G2 and G3).

use crate::Fallible;
use crate::dialect::Meaning;
use crate::interpreter::Interpreter;
use crate::modal::Group;
use ferrocut_geometry::{Arc, Axis, AxisSet, Plane, Turn};
use ferrocut_machine::Fault;
use ferrocut_toolpath::{FeedAlong, Op};
use std::f64::consts::TAU;

/// How far start and end may differ in their distance from the centre, mm.
const RADIUS_TOLERANCE: f64 = 0.0127;

impl Interpreter {
    /// An arc to the point that the block leads to.
    pub(super) fn ngc_arc(&mut self, axes: AxisSet, turn: Turn) -> Fallible<()> {
        let span = self.words.block_span();
        let plane = self.modal.plane();
        let (from, to) = (self.ngc.at, self.ngc_end_point(axes));
        let feed = self.ngc_feed()?;
        let (start, end) = (plane.of(from), plane.of(to));
        let center = match self.ngc_length_word(b'R') {
            Some(radius) => Arc::center_from_radius(start, end, radius, turn, RADIUS_TOLERANCE)
                .map_err(|_| self.alarm(Fault::ArcRadiusTooSmall, span))?,
            None => {
                let absolute = self.modal.meaning(Group::CentreDistance) == Meaning::CentreAbsolute;
                let [a, b] = offset_letters(plane);
                if !self.words.has(a) && !self.words.has(b) {
                    return Err(self.alarm(Fault::ArcWithoutCentre, span));
                }
                let of = |letter, start| match self.ngc_length_word(letter) {
                    Some(value) if absolute => value,
                    value => start + value.unwrap_or(0.0),
                };
                [of(a, start[0]), of(b, start[1])]
            }
        };
        let mut arc = Arc::about(plane, from, to, center, turn);
        if (arc.start_radius() - arc.end_radius()).abs() > RADIUS_TOLERANCE {
            return Err(self.alarm(Fault::ArcRadiusMismatch, span));
        }
        let turns = self.words.get(b'P').unwrap_or(1.0).round().max(1.0);
        arc.sweep += (turns - 1.0) * TAU.copysign(arc.sweep);
        let machine = self.ngc.machine_of(to);
        self.ngc_check_reach(machine)?;
        // The coordinate system may be turned about Z.
        let mut middle = to;
        (middle[plane.first()], middle[plane.second()]) = (center[0], center[1]);
        let center = plane.of(self.ngc.machine_of(middle));
        if plane != Plane::Xy && self.ngc.turn.degrees != 0.0 {
            return Err(self.alarm(Fault::NotSupported, span));
        }
        self.ngc.at = to;
        self.location.machine = machine;
        let path = self.ngc_path();
        let sweep = arc.sweep;
        self.emit(Op::Arc { to: machine, plane, center, sweep, feed, feed_along: FeedAlong::Path, path });
        Ok(())
    }
}

/// Letters of the centre in a plane, first and second axis.
fn offset_letters(plane: Plane) -> [u8; 2] {
    [plane.first(), plane.second()].map(|axis| match axis {
        Axis::X => b'I',
        Axis::Y => b'J',
        _ => b'K',
    })
}
