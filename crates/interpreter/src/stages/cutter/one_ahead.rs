//! Compensation that looks one move ahead, as LinuxCNC has it for RS274/NGC (user manual, "Cutter
//! Compensation").
//!
//! The tool centre stands at the end of the programmed path, off it by the radius, square to the last move.
//! That last move waits, with what stands behind it and does not move in the plane, until the next one says what
//! their corner is. With `β` the angle that the path turns away from the tool:
//!
//! | corner | what the tool does |
//! |---|---|
//! | outside, `β` above 0.05 rad | goes round the corner on an arc, at rapid straight across |
//! | nearly straight | goes on |
//! | inside | ends the waiting move where the two offset curves cross |
//!
//! An arc that the tool follows on its outside and that ends in a turn back by half a turn counts as an inside
//! corner: the tool stays above the "h".
//!
//! The entry move ends square to itself; a line must be longer than the radius, and an arc is run tangent to
//! itself at its end. G40 takes the vector away: the next move leads from where the tool stands to its programmed
//! end, and must be straight.
//!
//! A move that an inside corner leaves nothing of, or turns round, would gouge: [`Fault::Interference`]. As in
//! LinuxCNC it is looked for where an inside corner or an arc about a corner of two lines follows it, and at G40.

use super::{Done, Fault, Offset, Out, PlaneMove, Shape, WAITING_LIMIT, at, offset};
use ferrocut_geometry::vector::{Point, add, along, angle, distance, dot, left, scale, sub, unit};
use std::collections::VecDeque;
use std::f64::consts::{FRAC_PI_2, PI, TAU};

/// A path that turns by less than this goes straight on, rad.
const STRAIGHT_RAD: f64 = 0.05;

/// A trimmed arc may be longer by this than it was, where nothing else was set: behind a path that goes nearly
/// straight on it begins earlier, rad.
const LONGER_RAD: f64 = 0.001;

/// An entry arc whose chord is this near to square to its radius has no centre: the cosine.
const SQUARE: f64 = 1e-6;

/// A turn of no more than this is a full one, rad.
const FULL_TURN_RAD: f64 = 1e-9;

/// Offsets that cross may miss each other by less than this over the radius, by rounding.
const TOUCH: f64 = 1e-9;

/// A move in the plane whose end the next corner may move.
#[derive(Clone, Copy, Debug)]
struct Waited {
    /// Where the tool begins it.
    start: Point,
    /// Whether what is left of it is held against the programmed move; not of an entry arc.
    is_held: bool,
    way: Way,
}

/// The tool's way along a move.
#[derive(Clone, Copy, Debug)]
enum Way {
    /// With the direction that it must keep.
    Line(Point),
    /// About a centre.
    Round(Round),
}

#[derive(Clone, Copy, Debug)]
struct Round {
    center: Point,
    /// Of the tool's way.
    radius: f64,
    /// +1 counter-clockwise, −1 clockwise.
    sense: f64,
    turns: f64,
    /// Angle of the programmed arc, rad.
    programmed: f64,
    /// The tool runs between the arc and its centre.
    inside: bool,
}

/// What waits: the move in the plane first, then what stands still in the plane.
#[derive(Clone, Debug)]
enum Queued<T> {
    Move(T),
    Other(T),
}

/// The stage. It owns its queue and nothing else.
#[derive(Clone, Debug)]
pub struct OneAhead<T> {
    offset: Option<Offset>,
    /// How much longer a trimmed arc may be than it was, rad.
    longer: f64,
    in_mode: bool,
    /// Compensation was just taken away.
    must_go_straight: bool,
    /// The end of the last move, square to it.
    tool: Point,
    /// The move that waits; none before the entry and once it was handed out.
    last: Option<Waited>,
    queue: VecDeque<Queued<T>>,
}

/// A programmed move and the directions at its ends.
#[derive(Clone)]
struct Programmed {
    from: Point,
    to: Point,
    way: Shape,
    start: Point,
    end: Point,
}

impl<T: Clone> OneAhead<T> {
    /// A stage in the cancelled state.
    pub fn new() -> OneAhead<T> {
        OneAhead {
            offset: None,
            longer: LONGER_RAD,
            in_mode: false,
            must_go_straight: false,
            tool: [0.0; 2],
            last: None,
            queue: VecDeque::with_capacity(WAITING_LIMIT),
        }
    }

    /// G41 and G42: the next move is the entry. A radius of 0 compensates nothing. `None` is G40;
    /// [`Self::finish`] first.
    pub fn set(&mut self, offset: Option<Offset>) {
        self.offset = offset.filter(|o| o.radius != 0.0);
        if self.offset.is_none() {
            self.must_go_straight |= self.in_mode;
            self.forget();
        }
    }

    /// How much longer a trimmed arc may be than it was, rad.
    pub fn set_longer(&mut self, longer: f64) {
        self.longer = longer;
    }

    /// Whether a vector stands.
    pub fn in_mode(&self) -> bool {
        self.in_mode
    }

    /// Whether a move to the end of the path, where the tool stands in the program, counts: it is the entry, or
    /// leaves the vector that was taken away.
    pub fn takes_still_moves(&self) -> bool {
        self.must_go_straight || self.offset.is_some() && !self.in_mode
    }

    /// Forgets the vector and what waits.
    pub fn forget(&mut self) {
        self.last = None;
        self.in_mode = false;
        self.queue.clear();
    }

    /// The next move; of one that stands still in the plane `from` is `to`.
    ///
    /// # Errors
    /// Every [`Fault`] of the geometry. What waited is dropped then, and the next move is the entry.
    pub fn push(&mut self, m: PlaneMove, payload: T, out: &mut impl FnMut(Out<T>)) -> Done<T> {
        let done = match self.offset {
            _ if !offset::is_finite(&m) || self.offset.is_some_and(|o| !o.radius.is_finite()) => {
                Err(Fault::NotFinite)
            }
            _ if std::mem::take(&mut self.must_go_straight) && m.shape != Shape::Line => {
                Err(Fault::ArcAfterCancel)
            }
            None => {
                self.tool = m.to;
                out(Out::Move { to: m.to, shape: m.shape, payload: payload.clone(), inserted: false });
                Ok(())
            }
            Some(o) if self.in_mode => self.go_on(m, o, &payload, out),
            Some(o) => self.enter(m, o, &payload),
        };
        done.map_err(|fault| {
            self.forget();
            at(fault, payload)
        })
    }

    /// Anything that is no move; it keeps its place.
    pub fn pass(&mut self, payload: T, out: &mut impl FnMut(Out<T>)) -> Done<T> {
        if self.queue.is_empty() {
            out(Out::Other(payload));
            return Ok(());
        }
        let waits = self.wait(Queued::Other(payload.clone()));
        waits.map_err(|fault| at(fault, payload))
    }

    /// Hands out all that waits; the last move ends square to itself, and the next corner cannot change that: an
    /// inside one is not seen.
    pub fn flush(&mut self, out: &mut impl FnMut(Out<T>)) -> Done<T> {
        self.end(false, out)
    }

    /// The same before G40, where a last move that runs backwards is a fault.
    pub fn finish(&mut self, out: &mut impl FnMut(Out<T>)) -> Done<T> {
        self.end(true, out)
    }

    fn end(&mut self, is_checked: bool, out: &mut impl FnMut(Out<T>)) -> Done<T> {
        let Some(Queued::Move(first) | Queued::Other(first)) = self.queue.front() else { return Ok(()) };
        let first = first.clone();
        self.end_at(self.tool, is_checked, out).map_err(|fault| {
            self.forget();
            at(fault, first)
        })
    }

    fn wait(&mut self, queued: Queued<T>) -> Result<(), Fault> {
        if self.queue.len() >= WAITING_LIMIT {
            return Err(Fault::TooManyIdleBlocks);
        }
        self.queue.push_back(queued);
        Ok(())
    }

    /// The entry move, from where the tool stands to square off its end.
    fn enter(&mut self, m: PlaneMove, o: Offset, payload: &T) -> Result<(), Fault> {
        let (r, d) = (o.radius.abs(), o.signed());
        if distance(m.from, m.to) <= r {
            return Err(Fault::EntryTooShort);
        }
        let m = Programmed::new(&m)?;
        let tip = along(m.to, left(m.end), d);
        let (way, is_held) = match m.way {
            // What an inside corner leaves of it must end on the tool's side of its start.
            Shape::Line => (Way::Line(scale(left(m.end), d.signum())), true),
            Shape::Arc { center, sweep } => {
                let round = entry_arc(m.from, m.to, tip, center, sweep, d)?;
                (Way::Round(round), false)
            }
        };
        self.last = Some(Waited { start: m.from, is_held, way });
        self.in_mode = true;
        self.tool = tip;
        self.wait(Queued::Move(payload.clone()))
    }

    /// A move in the mode: its corner ends the move that waits, and it waits itself.
    fn go_on(
        &mut self,
        m: PlaneMove,
        o: Offset,
        payload: &T,
        out: &mut impl FnMut(Out<T>),
    ) -> Result<(), Fault> {
        if offset::is_zero(&m) {
            return self.stand_still(payload, out);
        }
        let (r, d) = (o.radius.abs(), o.signed());
        let m = Programmed::new(&m)?;
        // The tool stands square to the last move.
        let before = scale(left(sub(self.tool, m.from)), -1.0 / d);
        let away = -d.signum() * angle(before, m.start);
        let beta = if away < -FRAC_PI_2 { away + TAU } else { away };
        let tip = along(m.to, left(m.end), d);
        let (way, is_inside) = match m.way {
            Shape::Line => {
                let hugs = matches!(&self.last, Some(Waited { way: Way::Round(arc), .. }) if !arc.inside);
                (Way::Line(sub(m.to, m.from)), beta > PI - STRAIGHT_RAD && hugs)
            }
            Shape::Arc { center, sweep } => {
                let sense = sweep.signum();
                let inside = sense * d > 0.0;
                if inside && distance(center, m.to) <= r {
                    return Err(Fault::ArcTooSmall);
                }
                let (radius, turns) = (distance(center, tip), turns(sweep));
                let round = Round { center, radius, sense, turns, programmed: sweep, inside };
                (Way::Round(round), (beta - PI).abs() < STRAIGHT_RAD && !inside)
            }
        };
        let is_inside = is_inside || !(-STRAIGHT_RAD..=PI + STRAIGHT_RAD).contains(&beta);
        let is_held = !is_inside || self.last.is_some();
        let start = if is_inside && is_held {
            let crossing = self.crossing(&m, &way, before, beta, d)?;
            self.end_at(crossing, true, out)?;
            crossing
        } else if !is_inside && beta > STRAIGHT_RAD {
            self.end_at(self.tool, m.way == Shape::Line, out)?;
            let to = along(m.from, left(m.start), d);
            let shape = Shape::Arc { center: m.from, sweep: -d.signum() * beta };
            out(Out::Corner { to, shape, payload: payload.clone() });
            to
        } else {
            self.end_at(self.tool, false, out)?;
            self.tool
        };
        self.last = Some(Waited { start, is_held, way });
        self.tool = tip;
        self.wait(Queued::Move(payload.clone()))
    }

    /// A move of other axes alone.
    fn stand_still(&mut self, payload: &T, out: &mut impl FnMut(Out<T>)) -> Result<(), Fault> {
        if self.queue.is_empty() {
            let payload = payload.clone();
            out(Out::Move { to: self.tool, shape: Shape::Line, payload, inserted: false });
            return Ok(());
        }
        self.wait(Queued::Move(payload.clone()))
    }

    /// Hands out what waits, the moves ended at `p`. `is_checked`: a move that runs backwards then is a fault.
    fn end_at(&mut self, p: Point, is_checked: bool, out: &mut impl FnMut(Out<T>)) -> Result<(), Fault> {
        let mut shape = Shape::Line;
        if let Some(last) = self.last.take() {
            let is_checked = is_checked && last.is_held;
            match last.way {
                Way::Line(direction) => {
                    let way = sub(p, last.start);
                    let back = -dot(direction, way);
                    if is_checked && back > TOUCH * distance(direction, [0.0; 2]) {
                        return Err(Fault::Interference);
                    }
                }
                Way::Round(arc) => {
                    let sweep = arc.sweep(last.start, p);
                    if is_checked && sweep.abs() > arc.programmed.abs() + self.longer {
                        return Err(Fault::Interference);
                    }
                    shape = Shape::Arc { center: arc.center, sweep };
                }
            }
        }
        for queued in self.queue.drain(..) {
            match queued {
                Queued::Move(payload) => out(Out::Move { to: p, shape, payload, inserted: false }),
                Queued::Other(payload) => out(Out::Other(payload)),
            }
            shape = Shape::Line;
        }
        Ok(())
    }

    /// Where the tool's way along the last move meets that along the next, whose direction at the corner is `m`'s
    /// and which turns towards the tool.
    fn crossing(&self, m: &Programmed, way: &Way, before: Point, beta: f64, d: f64) -> Result<Point, Fault> {
        let Some(last) = &self.last else { return Err(Fault::NoIntersection) };
        match (&last.way, way) {
            (Way::Line(_), Way::Line(_)) => Ok(along(self.tool, before, d.abs() * (beta / 2.0).tan())),
            (Way::Round(arc), Way::Line(_)) => {
                // Into the circle from outside it, or out of the circle.
                let on_line = along(m.from, left(m.start), d);
                arc.meets(on_line, m.start, !arc.inside, arc.center)
            }
            (Way::Line(_), Way::Round(arc)) => {
                // The arc counts by the radius at its end.
                let to_center = unit(sub(arc.center, m.from)).ok_or(Fault::ArcCenterOvercut)?;
                let center = along(m.from, to_center, distance(arc.center, m.to));
                arc.meets(self.tool, before, arc.inside, center)
            }
            (Way::Round(old), Way::Round(new)) => old.meets_arc(new),
        }
    }
}

impl<T: Clone> Default for OneAhead<T> {
    fn default() -> OneAhead<T> {
        OneAhead::new()
    }
}

impl Programmed {
    fn new(m: &PlaneMove) -> Result<Programmed, Fault> {
        let (start, end) = match m.shape {
            Shape::Line => {
                let t = unit(sub(m.to, m.from)).ok_or(Fault::NoIntersection)?;
                (t, t)
            }
            Shape::Arc { center, sweep } => {
                let tangent = |p: Point| unit(sub(p, center)).map(|u| scale(left(u), sweep.signum()));
                match (tangent(m.from), tangent(m.to)) {
                    (Some(start), Some(end)) => (start, end),
                    _ => return Err(Fault::ArcCenterOvercut),
                }
            }
        };
        Ok(Programmed { from: m.from, to: m.to, way: m.shape, start, end })
    }
}

impl Round {
    /// The angle turned from `from` to `to`.
    fn sweep(&self, from: Point, to: Point) -> f64 {
        let a = self.sense * angle(sub(from, self.center), sub(to, self.center));
        let a = if a <= FULL_TURN_RAD { a + TAU } else { a };
        self.sense * (a + (self.turns - 1.0) * TAU)
    }

    /// Where a line through `p` along `t` leaves the circle, or enters it; `center` is where the line counts the
    /// centre to be.
    fn meets(&self, p: Point, t: Point, leaves: bool, center: Point) -> Result<Point, Fault> {
        let foot = sub(along(p, t, dot(sub(center, p), t)), center);
        let share = distance(foot, [0.0; 2]) / self.radius;
        if share.is_nan() || share > 1.0 + TOUCH {
            return Err(Fault::NoIntersection);
        }
        let half = self.radius * ((1.0 - share) * (1.0 + share)).max(0.0).sqrt();
        Ok(add(self.center, along(foot, t, if leaves { half } else { -half })))
    }

    /// Where this arc of the tool meets the next.
    fn meets_arc(&self, next: &Round) -> Result<Point, Fault> {
        let apart = sub(next.center, self.center);
        let gap = distance(next.center, self.center);
        let u = unit(apart).ok_or(Fault::NoIntersection)?;
        let cosine =
            (self.radius * self.radius + gap * gap - next.radius * next.radius) / (2.0 * self.radius * gap);
        if cosine.is_nan() || cosine.abs() > 1.0 + TOUCH {
            return Err(Fault::NoIntersection);
        }
        let cosine = cosine.clamp(-1.0, 1.0);
        let sine = ((1.0 - cosine) * (1.0 + cosine)).sqrt();
        let sine = if (next.sense > 0.0) == self.inside { sine } else { -sine };
        Ok(along(self.center, add(scale(u, cosine), scale(left(u), sine)), self.radius))
    }
}

/// The tool's entry arc from `from` to `tip`, square off the end `to` of the programmed arc about `center`: it has
/// the direction of that arc at its end.
fn entry_arc(from: Point, to: Point, tip: Point, center: Point, sweep: f64, d: f64) -> Result<Round, Fault> {
    let sense = sweep.signum();
    let inside = sense * d > 0.0;
    if inside && distance(center, from) <= d.abs() {
        return Err(Fault::ArcTooSmall);
    }
    let to_center = unit(sub(center, to)).ok_or(Fault::ArcCenterOvercut)?;
    let chord = distance(from, tip);
    let cosine = dot(sub(from, tip), to_center) / chord;
    if cosine.is_nan() || cosine.abs() < SQUARE {
        return Err(Fault::ArcTooSmall);
    }
    let center = along(tip, to_center, chord / (2.0 * cosine));
    let mut round =
        Round { center, radius: distance(center, tip), sense, turns: turns(sweep), programmed: 0.0, inside };
    round.programmed = round.sweep(from, tip);
    Ok(round)
}

/// Whole and begun turns of an arc.
fn turns(sweep: f64) -> f64 {
    ((sweep.abs() - FULL_TURN_RAD) / TAU).ceil().max(1.0)
}
