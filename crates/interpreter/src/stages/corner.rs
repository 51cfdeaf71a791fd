//! Stage chamfer and corner rounding: `,L` and `,R` at the end of a cutting block (GSK990MC 4.2.18).
//!
//! A block with such a word is held until the next move is known. Then both are shortened and a
//! straight piece or an arc is put between them.
//!
//! ```text
//! ,L  the piece joins the points at distance L from the corner on both moves
//! ,R  the arc of radius R touches both moves: its centre lies R beside each of them, on the side to
//!     which the path turns
//! ```
//!
//! Beside a line that is a parallel line, beside an arc of radius r a circle of radius r ± R, so that the
//! centre is a crossing of lines and circles, and the arc's ends are its feet on the two moves.

use ferrocut_geometry::vector::{along, cross, dot, sub, unit};
use ferrocut_geometry::{Arc, Plane, Position, Turn};
use ferrocut_machine::Fault;
use ferrocut_program::Span;
use ferrocut_toolpath::{FeedAlong, Op, Step};

/// Lengths below this are nothing, mm.
const NOTHING: f64 = 1e-9;

/// Moves that turn by less than this have no corner to round: the sine of 1°, as on Fanuc.
const STRAIGHT_ON: f64 = 0.017_452_406_437_283_51;

/// What is put between two moves.
#[derive(Clone, Copy, PartialEq, Debug)]
pub enum CornerKind {
    /// A straight piece.
    Chamfer,
    /// A tangent arc.
    Round,
}

/// What a block asks to be put between its move and the next.
#[derive(Clone, Copy, PartialEq, Debug)]
pub struct CornerRequest {
    /// Chamfer or arc.
    pub kind: CornerKind,
    /// Distance from the corner, or radius, mm, above 0.
    pub size: f64,
    /// Plane in force.
    pub plane: Plane,
    /// The word.
    pub span: Span,
}

/// A move that waits for the next one.
#[derive(Clone, Debug)]
struct Held {
    from: Position,
    step: Step,
    request: CornerRequest,
}

/// The stage: at most one move is held.
#[derive(Clone, Debug, Default)]
pub struct Corner {
    held: Option<Held>,
}

/// A broken rule and the words at fault.
pub type Refused = (Fault, Span);

impl Corner {
    /// Whether nothing is held, so that steps may pass by.
    #[inline]
    pub fn is_empty(&self) -> bool {
        self.held.is_none()
    }

    /// Forgets a held move and gives it back as it is.
    pub fn release(&mut self) -> Option<(Position, Step)> {
        self.held.take().map(|held| (held.from, held.step))
    }

    /// Takes a move that starts at `from`. Moves that are finished go to `out` with their starts.
    pub fn push(
        &mut self,
        from: Position,
        step: Step,
        request: Option<CornerRequest>,
        mut out: impl FnMut(Position, Step),
    ) -> Result<(), Refused> {
        let (from, step) = match self.held.take() {
            None => (from, step),
            Some(held) => {
                let joined = join(&held, from, &step)?;
                let mut at = held.from;
                for piece in [Some(joined.before), joined.between].into_iter().flatten() {
                    let end = piece.op.target().copied().unwrap_or(at);
                    out(at, piece);
                    at = end;
                }
                (at, joined.after)
            }
        };
        match request {
            None => out(from, step),
            Some(request) => match step.op {
                Op::Feed { .. } | Op::Arc { .. } => self.held = Some(Held { from, step, request }),
                _ => return Err((Fault::CornerForm, request.span)),
            },
        }
        Ok(())
    }

    /// Something other than a move comes, or the program ends: the move after the corner is missing.
    pub fn interrupted(&mut self) -> Option<Refused> {
        self.held.as_ref().map(|held| (Fault::CornerWithoutMove, held.request.span))
    }
}

/// A curve in the plane.
#[derive(Clone, Copy, Debug)]
enum Curve {
    Line { from: [f64; 2], to: [f64; 2] },
    Arc { center: [f64; 2], radius: f64, from: [f64; 2], to: [f64; 2], sweep: f64 },
}

impl Curve {
    /// The move from `from` as a curve; `None` if it is no cut in the plane.
    fn of(plane: Plane, from: Position, op: &Op) -> Option<Curve> {
        let to = op.target()?;
        let stays = |axis: ferrocut_geometry::Axis| {
            axis == plane.first() || axis == plane.second() || from[axis] == to[axis]
        };
        if !ferrocut_geometry::Axis::ALL.into_iter().all(stays) {
            return None;
        }
        let (start, end) = (plane.of(from), plane.of(*to));
        match *op {
            Op::Feed { .. } => Some(Curve::Line { from: start, to: end }),
            Op::Arc { plane: own, center, sweep, .. } if own == plane => {
                let v = sub(start, center);
                Some(Curve::Arc { center, radius: v[0].hypot(v[1]), from: start, to: end, sweep })
            }
            _ => None,
        }
    }

    /// Direction of travel at the start or at the end.
    fn direction(&self, at_end: bool) -> Option<[f64; 2]> {
        match *self {
            Curve::Line { from, to } => unit(sub(to, from)),
            Curve::Arc { center, from, to, sweep, .. } => {
                let v = unit(sub(if at_end { to } else { from }, center))?;
                Some(if sweep > 0.0 { [-v[1], v[0]] } else { [v[1], -v[0]] })
            }
        }
    }

    /// Signed radius of the curve `r` to the left of this one, for arcs; lines have none.
    fn beside(&self, left: f64) -> Curve {
        match *self {
            Curve::Line { from, to } => {
                let d = unit(sub(to, from)).unwrap_or([1.0, 0.0]);
                let normal = [-d[1] * left, d[0] * left];
                Curve::Line { from: along(from, normal, 1.0), to: along(to, normal, 1.0) }
            }
            Curve::Arc { center, radius, from, to, sweep } => {
                // Left of a counter-clockwise arc is towards its centre.
                let radius = if sweep > 0.0 { radius - left } else { radius + left };
                Curve::Arc { center, radius, from, to, sweep }
            }
        }
    }

    /// The point of the curve nearest to `p`, the curve carried on beyond its ends.
    fn foot(&self, p: [f64; 2]) -> Option<[f64; 2]> {
        match *self {
            Curve::Line { from, to } => {
                let d = unit(sub(to, from))?;
                Some(along(from, d, dot(sub(p, from), d)))
            }
            Curve::Arc { center, radius, .. } => Some(along(center, unit(sub(p, center))?, radius)),
        }
    }

    /// Whether a point on the carried-on curve lies between its ends.
    fn contains(&self, p: [f64; 2]) -> bool {
        match *self {
            Curve::Line { from, to } => {
                let d = sub(to, from);
                let t = dot(sub(p, from), d);
                (-NOTHING..=dot(d, d) + NOTHING).contains(&t)
            }
            Curve::Arc { center, from, to, sweep, .. } => {
                let turned = |q: [f64; 2]| {
                    let (u, v) = (sub(from, center), sub(q, center));
                    let angle = cross(u, v).atan2(dot(u, v)) * sweep.signum();
                    if angle < 0.0 { angle + std::f64::consts::TAU } else { angle }
                };
                turned(p) <= sweep.abs() + NOTHING || sub(p, to).iter().all(|d| d.abs() < NOTHING)
            }
        }
    }
}

/// Crossings of two carried-on curves.
fn crossings(a: &Curve, b: &Curve) -> Vec<[f64; 2]> {
    match (a, b) {
        (Curve::Line { from: p, to: q }, Curve::Line { from: r, to: s }) => {
            let (d, e) = (sub(*q, *p), sub(*s, *r));
            let det = cross(d, e);
            if det.abs() < NOTHING * NOTHING {
                return Vec::new();
            }
            vec![along(*p, d, cross(sub(*r, *p), e) / det)]
        }
        (Curve::Line { from, to }, Curve::Arc { center, radius, .. })
        | (Curve::Arc { center, radius, .. }, Curve::Line { from, to }) => {
            let Some(d) = unit(sub(*to, *from)) else { return Vec::new() };
            let foot = along(*from, d, dot(sub(*center, *from), d));
            let v = sub(foot, *center);
            let rest = radius * radius - dot(v, v);
            if rest < 0.0 {
                return Vec::new();
            }
            vec![along(foot, d, rest.sqrt()), along(foot, d, -rest.sqrt())]
        }
        (Curve::Arc { center: p, radius: r, .. }, Curve::Arc { center: q, radius: s, .. }) => {
            let v = sub(*q, *p);
            let Some(d) = unit(v) else { return Vec::new() };
            let distance = v[0].hypot(v[1]);
            let t = (distance * distance + r * r - s * s) / (2.0 * distance);
            let rest = r * r - t * t;
            if rest < 0.0 {
                return Vec::new();
            }
            let middle = along(*p, d, t);
            let normal = [-d[1], d[0]];
            vec![along(middle, normal, rest.sqrt()), along(middle, normal, -rest.sqrt())]
        }
    }
}

struct Joined {
    before: Step,
    between: Option<Step>,
    after: Step,
}

/// Shortens two moves and puts the corner piece between them.
fn join(held: &Held, corner: Position, next: &Step) -> Result<Joined, Refused> {
    let request = &held.request;
    let plane = request.plane;
    let size = request.size;
    let refuse = |fault| (fault, request.span);
    if !matches!(next.op, Op::Feed { .. } | Op::Arc { .. }) {
        return Err(refuse(Fault::CornerWithoutMove));
    }
    let a = Curve::of(plane, held.from, &held.step.op).ok_or(refuse(Fault::CornerPlane))?;
    // Alarm 0058 is about the block of the corner, 0051 about the one behind it.
    let b = Curve::of(plane, corner, &next.op).ok_or(refuse(Fault::CornerPlaneBehind))?;
    let point = plane.of(corner);
    let (Some(inward), Some(outward)) = (a.direction(true), b.direction(false)) else {
        return Err(refuse(Fault::CornerWithoutMove));
    };
    let turn = cross(inward, outward);
    let (p, q, center) = match request.kind {
        CornerKind::Chamfer => {
            let around = Curve::Arc { center: point, radius: size, from: point, to: point, sweep: 0.0 };
            let on = |curve: &Curve| {
                crossings(curve, &around)
                    .into_iter()
                    .filter(|x| curve.contains(*x))
                    .max_by(|x, y| near(*x, curve, point).total_cmp(&near(*y, curve, point)))
            };
            match (on(&a), on(&b)) {
                (Some(p), Some(q)) => (p, q, None),
                _ => return Err(refuse(Fault::CornerTooLong)),
            }
        }
        CornerKind::Round => {
            if turn.abs() < STRAIGHT_ON && dot(inward, outward) > 0.0 {
                return Ok(Joined { before: held.step.clone(), between: None, after: next.clone() });
            }
            if turn.abs() < NOTHING {
                return Err(refuse(Fault::CornerTooLong));
            }
            let left = size * turn.signum();
            let found = crossings(&a.beside(left), &b.beside(left)).into_iter().filter_map(|center| {
                let (p, q) = (a.foot(center)?, b.foot(center)?);
                (a.contains(p) && b.contains(q)).then_some((p, q, center))
            });
            let distance = |c: &([f64; 2], [f64; 2], [f64; 2])| {
                let v = sub(c.2, point);
                dot(v, v)
            };
            match found.min_by(|x, y| distance(x).total_cmp(&distance(y))) {
                Some((p, q, center)) => (p, q, Some(center)),
                None => return Err(refuse(Fault::CornerTooLong)),
            }
        }
    };
    let place = |at: [f64; 2]| {
        let mut to = corner;
        to[plane.first()] = at[0];
        to[plane.second()] = at[1];
        to
    };
    let (start, end) = (place(p), place(q));
    let before = shortened(&held.step, held.from, start, plane);
    let (feed, path) = match before.op {
        Op::Feed { feed, path, .. } | Op::Arc { feed, path, .. } => (feed, path),
        _ => return Err(refuse(Fault::CornerForm)),
    };
    let between = match center {
        None => Op::Feed { to: end, feed, path },
        Some(center) => {
            let sense = if turn > 0.0 { Turn::CounterClockwise } else { Turn::Clockwise };
            let sweep = Arc::about(plane, start, end, center, sense).sweep;
            Op::Arc { to: end, plane, center, sweep, feed, feed_along: FeedAlong::Path, path }
        }
    };
    let to = next.op.target().copied().unwrap_or(end);
    let after = shortened(next, end, to, plane);
    let between = Some(Step { op: between, ..held.step.clone() });
    Ok(Joined { before, between, after })
}

/// How far a point lies on the side of the curve: its own travel towards or away from the corner.
fn near(x: [f64; 2], curve: &Curve, corner: [f64; 2]) -> f64 {
    // Of two points at one distance from the corner the one nearer to the middle of the curve counts.
    let middle = match *curve {
        Curve::Line { from, to } => along(from, sub(to, from), 0.5),
        Curve::Arc { from, to, .. } => {
            if sub(from, corner).iter().all(|d| d.abs() < NOTHING) {
                to
            } else {
                from
            }
        }
    };
    let v = sub(x, middle);
    -dot(v, v)
}

/// The same move between other ends on its curve.
fn shortened(step: &Step, from: Position, to: Position, plane: Plane) -> Step {
    let mut step = step.clone();
    match &mut step.op {
        Op::Feed { to: end, .. } => *end = to,
        Op::Arc { to: end, center, sweep, .. } => {
            let sense = if *sweep > 0.0 { Turn::CounterClockwise } else { Turn::Clockwise };
            *sweep = Arc::about(plane, from, to, *center, sense).sweep;
            *end = to;
        }
        _ => {}
    }
    step
}
