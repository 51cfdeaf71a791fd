//! Acts of cycles to steps: from the plane's axes to programmed points, through the stages.

use super::operation::Operation;
use super::tool::Act;
use super::zone::Travel;
use crate::Fallible;
use crate::interpreter::Interpreter;
use ferrocut_geometry::{Plane, Position, Turn};
use ferrocut_machine::Fault;
use ferrocut_toolpath::{Dwell, Feed, FeedAlong, Op, SpindleState};

/// Acts of an operation that are made at a time.
const PORTION: u32 = 50_000;

impl Interpreter {
    /// Abscissa, ordinate and tool axis of where the tool is.
    pub(crate) fn in_plane_axes(&self) -> [f64; 3] {
        self.plane_axes().map(|axis| self.location.programmed[axis])
    }

    /// The programmed point with these coordinates.
    fn plane_point(&self, coordinates: [f64; 3]) -> Position {
        let mut to = self.location.programmed;
        for (axis, value) in self.plane_axes().into_iter().zip(coordinates) {
            to[axis] = value;
        }
        to
    }

    /// Makes an operation at a point. Its feeds are mm/min, or with `per_minute` false as F is.
    pub(crate) fn make(&mut self, operation: &Operation, at: [f64; 2], per_minute: bool) -> Fallible<()> {
        let from = self.in_plane_axes();
        operation.run(at, from, &mut |act| self.act(act, per_minute))
    }

    /// Makes what follows the first `made` acts of an operation that began at `from`, up to as many as fit
    /// the memory well: a pocket may take millions. The acts made then; none where it is done.
    pub(crate) fn make_portion(
        &mut self,
        operation: &Operation,
        at: [f64; 2],
        from: [f64; 3],
        made: u32,
    ) -> Fallible<Option<u32>> {
        let until = made.saturating_add(PORTION);
        let mut number = 0u32;
        let done = operation.run(at, from, &mut |act| {
            number = number.saturating_add(1);
            match number {
                _ if number <= made => Ok(()),
                _ if number > until => Err(None),
                _ => self.act(act, true).map_err(Some),
            }
        });
        match done {
            Ok(()) => Ok(None),
            Err(None) => Ok(Some(until)),
            Err(Some(alarm)) => Err(alarm),
        }
    }

    fn act(&mut self, act: Act, per_minute: bool) -> Fallible<()> {
        // Cutter compensation is left aside in cycles, which know the tool's radius themselves.
        self.output.suspend_cutter();
        match act {
            Act::Rapid { to } => self.rapid(self.plane_point(to)),
            Act::Feed { to, feed } => {
                let (to, feed) = (self.plane_point(to), self.feed_of(feed, per_minute));
                self.cut_at(to, feed)
            }
            Act::Arc { to, center, sweep, feed } => {
                let (to, feed) = (self.plane_point(to), self.feed_of(feed, per_minute));
                self.arc_at(to, center, sweep, feed)
            }
            Act::Tap { to, pitch, rpm } => self.tap_at(self.plane_point(to), pitch, rpm),
            Act::Dwell(seconds) => {
                self.emit(Op::Dwell(Dwell::Seconds(seconds)));
                Ok(())
            }
            Act::Stop => {
                self.spindle(SpindleState::Off);
                Ok(())
            }
            Act::Start(turn) => {
                self.turn_spindle(turn);
                Ok(())
            }
            Act::Orient(degrees) => {
                self.technology.spindle = SpindleState::Off;
                self.emit(Op::Orient(degrees));
                Ok(())
            }
        }
    }

    /// Turns the spindle at the speed in force.
    pub(crate) fn turn_spindle(&mut self, turn: Turn) {
        let speed = self.speed();
        self.spindle(SpindleState::turning(turn, speed));
    }

    fn feed_of(&self, feed: f64, per_minute: bool) -> Feed {
        match !per_minute && self.modal.is_feed_per_revolution() {
            true => Feed::PerRevolution(feed),
            false => Feed::PerMinute(feed),
        }
    }

    fn cut_at(&mut self, to: Position, feed: Feed) -> Fallible<()> {
        let machine = self.location.machine_of(to);
        self.check_reach(machine)?;
        self.location.programmed = to;
        if machine != self.location.machine {
            self.location.machine = machine;
            self.emit(Op::Feed { to: machine, feed, path: self.path_mode() });
        }
        Ok(())
    }

    /// The plane of arcs in the plane's axes, and whether they are its axes in the other order.
    fn arc_plane(&self) -> Fallible<(Plane, bool)> {
        let [a, b, tool] = self.plane_axes();
        for plane in [Plane::Xy, Plane::Zx, Plane::Yz] {
            let (first, second) = (plane.first(), plane.second());
            if tool != first && tool != second && ((first, second) == (a, b) || (first, second) == (b, a)) {
                return Ok((plane, first == b));
            }
        }
        let alarm = self.alarm(Fault::PlaneAxes, self.words.block_span());
        Err(Box::new(alarm.with("axis", format!("{} {}", a.letter(), b.letter()))))
    }

    fn arc_at(&mut self, to: Position, [a, b]: [f64; 2], sweep: f64, feed: Feed) -> Fallible<()> {
        match self.arc_plane()? {
            (plane, false) => self.arc_about(plane, to, [a, b], sweep, feed),
            (plane, true) => self.arc_about(plane, to, [b, a], -sweep, feed),
        }
    }

    /// Cuts along an arc to a programmed point. The centre is programmed coordinates of the plane.
    pub(super) fn arc_about(
        &mut self,
        plane: Plane,
        to: Position,
        center: [f64; 2],
        sweep: f64,
        feed: Feed,
    ) -> Fallible<()> {
        let machine = self.location.machine_of(to);
        self.check_reach(machine)?;
        let mut middle = to;
        middle[plane.first()] = center[0];
        middle[plane.second()] = center[1];
        let center = plane.of(self.location.machine_of(middle));
        self.location.programmed = to;
        self.location.machine = machine;
        let feed_along = FeedAlong::Path;
        self.emit(Op::Arc { to: machine, plane, center, sweep, feed, feed_along, path: self.path_mode() });
        Ok(())
    }

    /// Goes to a point of a figure; along a circle by so many degrees about its centre.
    pub(crate) fn travel(
        &mut self,
        [a, b]: [f64; 2],
        travel: Travel,
        center: Option<[f64; 2]>,
        degrees: f64,
        feed: f64,
    ) -> Fallible<()> {
        let [_, _, level] = self.in_plane_axes();
        let to = self.plane_point([a, b, level]);
        self.output.suspend_cutter();
        let feed = self.feed_of(feed, false);
        match (travel, center) {
            (Travel::Rapid, _) => self.rapid(to),
            (Travel::Arc, Some(center)) => self.arc_at(to, center, degrees.to_radians(), feed),
            _ => self.cut_at(to, feed),
        }
    }

    /// Goes in the plane and to a level of the tool axis at rapid: away from the part first, and in the plane
    /// above all levels (Fagor 4.1.2).
    pub(crate) fn rapid_over(&mut self, [a, b]: [f64; 2], level: f64, up: f64) -> Fallible<()> {
        let [x, y, z] = self.in_plane_axes();
        self.output.suspend_cutter();
        let first = if (z - level) * up > 0.0 { [a, b, z] } else { [x, y, level] };
        self.rapid(self.plane_point(first))?;
        self.rapid(self.plane_point([a, b, level]))
    }
}
