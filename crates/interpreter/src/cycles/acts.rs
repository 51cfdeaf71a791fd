//! Acts of cycles to steps: from the plane's axes to programmed points, through the stages.

use super::operation::Operation;
use super::tool::Act;
use super::zone::Travel;
use crate::Fallible;
use crate::interpreter::Interpreter;
use ferrocut_geometry::{Plane, Position, Turn};
use ferrocut_machine::Fault;
use ferrocut_toolpath::{Dwell, Feed, FeedAlong, Op, SpindleState};

/// What the feeds of an operation are measured by.
#[derive(Clone, Copy, PartialEq, Eq, Debug)]
pub enum FeedUnit {
    /// mm/min.
    Minute,
    /// mm a turn of the spindle.
    Turn,
}

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

    /// What F is measured by.
    fn unit_of_feed(&self) -> FeedUnit {
        if self.modal.is_feed_per_revolution() { FeedUnit::Turn } else { FeedUnit::Minute }
    }

    /// Makes an operation at a point. Its feeds are measured as F is.
    pub(crate) fn make(&mut self, operation: &Operation, at: [f64; 2]) -> Fallible<()> {
        let from = self.in_plane_axes();
        let unit = self.unit_of_feed();
        operation.run(at, from, &mut |act| self.act(act, unit))
    }

    /// Makes what follows the first `made` acts of an operation that began at `from`, up to as many as fit
    /// the memory well: a pocket may take millions. The acts made then; none where it is done.
    pub(crate) fn make_portion(
        &mut self,
        operation: &Operation,
        at: [f64; 2],
        from: [f64; 3],
        made: u32,
        unit: FeedUnit,
    ) -> Fallible<Option<u32>> {
        let until = made.saturating_add(PORTION);
        let mut number = 0u32;
        let done = operation.run(at, from, &mut |act| {
            number = number.saturating_add(1);
            match number {
                _ if number <= made => Ok(()),
                _ if number > until => Err(None),
                _ => self.act(act, unit).map_err(Some),
            }
        });
        match done {
            Ok(()) => Ok(None),
            Err(None) => Ok(Some(until)),
            Err(Some(alarm)) => Err(alarm),
        }
    }

    fn act(&mut self, act: Act, unit: FeedUnit) -> Fallible<()> {
        // Cutter compensation is left aside in cycles, which know the tool's radius themselves.
        self.output.suspend_cutter();
        match act {
            Act::Rapid { to } => self.rapid(self.plane_point(to)),
            Act::Feed { to, feed } => {
                let (to, feed) = (self.plane_point(to), feed_of(feed, unit));
                self.cut_at(to, feed)
            }
            Act::Arc { to, center, sweep, feed } => {
                let (to, feed) = (self.plane_point(to), feed_of(feed, unit));
                self.arc_at(to, center, sweep, feed)
            }
            Act::Tap { to, pitch, rpm } => self.tap_at(self.plane_point(to), pitch, rpm),
            Act::Dwell(seconds) => {
                self.emit(Op::Dwell(Dwell::Seconds(seconds)));
                Ok(())
            }
            Act::Stop => {
                // Said even where the program has it stopped: a tap in step may have turned it.
                self.technology.spindle = SpindleState::Off;
                self.emit(Op::Spindle(SpindleState::Off));
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
        let feed = feed_of(feed, self.unit_of_feed());
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

fn feed_of(feed: f64, unit: FeedUnit) -> Feed {
    match unit {
        FeedUnit::Turn => Feed::PerRevolution(feed),
        FeedUnit::Minute => Feed::PerMinute(feed),
    }
}
