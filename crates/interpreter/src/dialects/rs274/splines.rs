//! Splines and NURBS (LinuxCNC, G5 to G5.3). They are cut along arcs, tangent to each other, that stay within
//! [`TOLERANCE`] of the curve.

use crate::Fallible;
use crate::dialect::Meaning;
use crate::interpreter::Interpreter;
use crate::modal::Group;
use ferrocut_geometry::curve::Curve;
use ferrocut_geometry::spline::Spline;
use ferrocut_geometry::{Axis, AxisSet, Plane, Position};
use ferrocut_machine::Fault;
use ferrocut_toolpath::{Feed, FeedAlong, Op, PathMode};

/// How far the arcs may leave the curve, mm: half of what the finest words of a metric program show. As far their joints
/// may leave them where the path is exact.
pub(super) const TOLERANCE: f64 = 0.0005;

/// Points that one curve may be divided into: metres of curve at the tolerance.
const MOST_POINTS: usize = 200_000;

/// Control points of one curve.
const MOST_CONTROL_POINTS: usize = 10_000;

/// Order of a NURBS that gives none, and the least there is.
const ORDER: f64 = 3.0;

/// Splines as they are being programmed. Lengths in mm.
#[derive(Clone, Debug, Default)]
pub(crate) struct Splines {
    /// I and J for a G5 that gives none: the end of the one before goes on straight.
    lead: [f64; 2],
    /// Control points of G5.2 with their weights.
    points: Vec<([f64; 2], f64)>,
    order: f64,
}

impl Interpreter {
    /// G5 and G5.1.
    pub(super) fn ngc_spline(&mut self, axes: AxisSet, meaning: Meaning) -> Fallible<()> {
        if self.output.in_cutter_mode() {
            return Err(self.ngc_alarm(Fault::NotInCutter));
        }
        let feed = self.ngc_feed()?;
        if self.ngc_uvw_plane() || self.modal.plane() != Plane::Xy {
            return Err(self.ngc_alarm(Fault::SplinePlane));
        }
        let beside = AxisSet::EMPTY.with(Axis::Z).with(Axis::A).with(Axis::B).with(Axis::C);
        if let Some(axis) = axes.and(beside).iter().next() {
            return Err(self.alarm_at(Fault::SplineAxis, axis.letter() as u8));
        }
        let (from, to) = (self.ngc.at, self.ngc_end_point(axes));
        let (start, end) = (Plane::Xy.of(from), Plane::Xy.of(to));
        let lead = [self.ngc_length_word(b'I'), self.ngc_length_word(b'J')];
        let mut points = vec![start];
        if meaning == Meaning::QuadraticSpline {
            let [Some(i), Some(j)] = lead else {
                return Err(Box::new(self.ngc_alarm(Fault::WordMissing).with("word", "I J")));
            };
            points.push([start[0] + i, start[1] + j]);
        } else {
            let [i, j] = match lead {
                [Some(i), Some(j)] => [i, j],
                [None, None] => self.ngc.splines.lead,
                _ => return Err(Box::new(self.ngc_alarm(Fault::WordMissing).with("word", "I J"))),
            };
            let [Some(p), Some(q)] = [self.ngc_length_word(b'P'), self.ngc_length_word(b'Q')] else {
                return Err(Box::new(self.ngc_alarm(Fault::WordMissing).with("word", "P Q")));
            };
            points.push([start[0] + i, start[1] + j]);
            points.push([end[0] + p, end[1] + q]);
            self.ngc.splines.lead = [-p, -q];
        }
        points.push(end);
        let order = points.len();
        let weights = Vec::new();
        self.ngc_cut_spline(order, points, weights, to, feed)
    }

    /// G5.2: one control point more. The first is where the tool stands.
    pub(super) fn ngc_nurbs(&mut self) -> Fallible<()> {
        if self.output.in_cutter_mode() {
            return Err(self.ngc_alarm(Fault::NotInCutter));
        }
        let point = [Axis::X, Axis::Y].map(|axis| self.words.has(axis.letter() as u8));
        let weight = self.words.get(b'P');
        let is_first = self.ngc.splines.points.is_empty();
        match point {
            [true, false] | [false, true] => {
                return Err(Box::new(self.ngc_alarm(Fault::WordMissing).with("word", "X Y")));
            }
            [false, false] if !is_first && weight.is_some_and(|p| p > 0.0) => {
                return Err(Box::new(self.ngc_alarm(Fault::WordMissing).with("word", "X Y")));
            }
            _ => {}
        }
        match weight {
            None if !is_first => {
                return Err(self.ngc_missing(b'P'));
            }
            Some(p) if p <= 0.0 && !is_first => return Err(self.alarm_at(Fault::WordOutOfRange, b'P')),
            _ => {}
        }
        self.ngc_feed()?;
        let weight = weight.filter(|p| *p > 0.0).unwrap_or(1.0);
        if is_first {
            let own = if point == [false, false] { weight } else { 1.0 };
            self.ngc.splines.points.push((Plane::Xy.of(self.ngc.at), own));
            self.ngc.splines.order = ORDER;
        }
        if let Some(order) = self.words.get(b'L').filter(|l| *l > ORDER) {
            self.ngc.splines.order = order.round();
        }
        if point == [true, true] {
            if self.ngc.splines.points.len() >= MOST_CONTROL_POINTS {
                let alarm = self.ngc_alarm(Fault::SplineTooLong);
                return Err(Box::new(alarm.with("limit", MOST_CONTROL_POINTS as f64)));
            }
            let end = self.ngc_end_point(AxisSet::EMPTY.with(Axis::X).with(Axis::Y));
            self.ngc.splines.points.push((Plane::Xy.of(end), weight));
        }
        Ok(())
    }

    /// G5.3: cuts the NURBS that the blocks before described.
    pub(super) fn ngc_nurbs_end(&mut self) -> Fallible<()> {
        if self.modal.meaning(Group::Motion) != Meaning::Nurbs {
            return Err(self.ngc_alarm(Fault::NurbsEndAlone));
        }
        let order = self.ngc.splines.order;
        let described = std::mem::take(&mut self.ngc.splines.points);
        if (described.len() as f64) < order || described.len() < 2 {
            let alarm = self.ngc_alarm(Fault::NurbsTooFew);
            return Err(Box::new(alarm.with("number", described.len() as f64).with("least", order)));
        }
        let feed = self.ngc_feed()?;
        let (points, weights): (Vec<[f64; 2]>, Vec<f64>) = described.into_iter().unzip();
        let mut to = self.ngc.at;
        if let Some([x, y]) = points.last() {
            (to[Axis::X], to[Axis::Y]) = (*x, *y);
        }
        self.modal.set(self.dialect.cycle_off);
        self.ngc_cut_spline(order as usize, points, weights, to, feed)
    }

    /// Another motion code than G5.2 forgets the control points.
    pub(super) fn ngc_forget_nurbs(&mut self) {
        self.ngc.splines.points.clear();
    }

    /// Cuts along arcs of a spline in the XY plane.
    fn ngc_cut_spline(
        &mut self,
        order: usize,
        points: Vec<[f64; 2]>,
        weights: Vec<f64>,
        to: Position,
        feed: Feed,
    ) -> Fallible<()> {
        let machine = self.ngc.machine_of(to);
        self.ngc_check_reach(machine)?;
        let mut control = Vec::with_capacity(points.len());
        for point in points {
            let [x, y] = self.ngc_machine_plane_point(point);
            if !(x.abs() <= super::motion::LARGEST_COORDINATE && y.abs() <= super::motion::LARGEST_COORDINATE)
            {
                return Err(self.ngc_alarm(Fault::CoordinateTooLarge));
            }
            control.push([x, y, 0.0]);
        }
        let still = control.windows(2).all(|pair| pair.first() == pair.last());
        let Some(spline) = Spline::clamped(order, control, weights) else {
            return Err(self.ngc_alarm(Fault::SplineForm));
        };
        let mut curves: Vec<Curve> = Vec::new();
        let mut left = MOST_POINTS;
        let more = |_| -> Result<(), ()> {
            left = usize::checked_sub(left, 1).ok_or(())?;
            Ok(())
        };
        if !still && spline.curves(TOLERANCE, more, &mut curves).is_err() {
            let alarm = self.ngc_alarm(Fault::SplineTooLong);
            return Err(Box::new(alarm.with("limit", MOST_POINTS as f64)));
        }
        let feed = match feed {
            // The whole curve takes the time.
            Feed::Duration(seconds) => {
                let length: f64 = curves.iter().map(Curve::length).sum();
                Feed::PerMinute(length / seconds * 60.0)
            }
            feed => feed,
        };
        let path = self.ngc_path();
        let inside = PathMode::WithinBlock(match path {
            PathMode::Continuous => None,
            PathMode::ContinuousWithin(tolerance) => Some(tolerance.max(TOLERANCE)),
            _ => Some(TOLERANCE),
        });
        let count = curves.len();
        for (number, curve) in (1..).zip(curves) {
            let mut next = self.location.machine;
            (next[Axis::X], next[Axis::Y]) = (curve.to[0], curve.to[1]);
            // The last one ends where it is programmed, other axes with it.
            let (next, path) = if number == count { (machine, path) } else { (next, inside) };
            self.location.machine = next;
            match curve.bend {
                None => self.emit(Op::Feed { to: next, feed, path }),
                Some(bend) => self.emit(Op::Arc {
                    to: next,
                    plane: Plane::Xy,
                    center: bend.center,
                    sweep: bend.sweep,
                    feed,
                    feed_along: FeedAlong::Path,
                    path,
                }),
            }
        }
        self.ngc.at = to;
        self.location.machine = machine;
        Ok(())
    }
}
