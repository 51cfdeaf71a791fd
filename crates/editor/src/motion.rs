//! What a run does, in a form in which two texts of different languages can be compared: moves that go on in the
//! same direction are one, moves of no length none, and each cut knows how the spindle turns.

use crate::run::{feed_a_minute, xyz};
use ferrocut_geometry::{Plane, Position, Turn};
use ferrocut_toolpath::{Dwell, Feed, FeedAlong, Op, SpindleState, Step};

/// How far apart two places may be that are the same, mm: controls write four decimals.
pub const SAME_PLACE: f64 = 1e-3;
/// How much two feeds may differ that are the same.
const SAME_FEED: f64 = 1e-3;
/// How much two angles may differ that are the same, radians, where the radius does not say it.
const SAME_ANGLE: f64 = 1e-6;

/// A motion, from where the one before ended.
#[derive(Clone, PartialEq, Debug)]
pub enum Motion {
    /// At rapid.
    Rapid {
        /// End, mm.
        to: [f64; 3],
    },
    /// A straight cut.
    Cut {
        /// End, mm.
        to: [f64; 3],
        /// mm/min.
        feed: f64,
        /// How the spindle turns.
        spindle: SpindleState,
    },
    /// An arc or helix in XY.
    Arc {
        /// End, mm.
        to: [f64; 3],
        /// Centre, mm.
        center: [f64; 2],
        /// Angle turned, radians, counter-clockwise positive.
        sweep: f64,
        /// Along the path, mm/min.
        feed: f64,
        /// How the spindle turns.
        spindle: SpindleState,
    },
    /// In step with the spindle.
    Tap {
        /// End, mm.
        to: [f64; 3],
        /// mm a turn.
        pitch: f64,
        /// r/min.
        rpm: f64,
    },
    /// Waits, s.
    Dwell(f64),
    /// A tool is changed.
    Tool(u32),
}

impl Motion {
    /// Where it ends; none where nothing moves.
    pub fn to(&self) -> Option<[f64; 3]> {
        match self {
            Motion::Rapid { to }
            | Motion::Cut { to, .. }
            | Motion::Arc { to, .. }
            | Motion::Tap { to, .. } => Some(*to),
            Motion::Dwell(_) | Motion::Tool(_) => None,
        }
    }
}

fn distance(a: [f64; 3], b: [f64; 3]) -> f64 {
    ((a[0] - b[0]).powi(2) + (a[1] - b[1]).powi(2) + (a[2] - b[2]).powi(2)).sqrt()
}

/// Whether `b` lies on the straight way from `a` to `c`.
fn is_between(a: [f64; 3], b: [f64; 3], c: [f64; 3]) -> bool {
    distance(a, b) + distance(b, c) - distance(a, c) < 1e-9 * (1.0 + distance(a, c))
}

/// A feed in mm/min along the path, with the spindle's speed for feeds a turn.
fn per_minute(feed: Feed, length: f64, spindle: SpindleState) -> f64 {
    match feed {
        Feed::Duration(seconds) => length / seconds * 60.0,
        Feed::PerRevolution(turn) => feed_a_minute(feed, Some(spindle)).unwrap_or(turn),
        Feed::PerMinute(minute) | Feed::Held { at: minute, .. } => minute,
    }
}

/// Spindle at no speed is at rest.
fn turning(state: SpindleState) -> SpindleState {
    match state.speed() {
        Some(ferrocut_toolpath::Speed::Rpm(rpm)) if rpm > 0.0 => state,
        _ => SpindleState::Off,
    }
}

/// The motions of steps that begin at a place. None where a step is of a kind that no cycle makes.
pub fn motions(steps: &[Step], start: Position) -> Option<Vec<Motion>> {
    let mut list = List { motions: Vec::new(), from: Vec::new(), at: xyz(&start) };
    let mut spindle = SpindleState::Off;
    for step in steps {
        match &step.op {
            Op::Rapid { to, .. } => list.push(Motion::Rapid { to: xyz(to) }),
            Op::Feed { to, feed, .. } => {
                let to = xyz(to);
                let feed = per_minute(*feed, distance(list.at, to), spindle);
                list.push(Motion::Cut { to, feed, spindle: turning(spindle) });
            }
            Op::Arc { to, plane: Plane::Xy, center, sweep, feed, feed_along, .. } => {
                let to = xyz(to);
                let radius = (list.at[0] - center[0]).hypot(list.at[1] - center[1]);
                let circle = radius * sweep.abs();
                let path = circle.hypot(to[2] - list.at[2]);
                let along = match feed_along {
                    FeedAlong::Circle if circle > 0.0 => path / circle,
                    _ => 1.0,
                };
                let feed = per_minute(*feed, path, spindle) * along;
                let spindle = turning(spindle);
                list.push(Motion::Arc { to, center: *center, sweep: *sweep, feed, spindle });
            }
            Op::Tap { to, pitch, rpm, .. } => {
                list.push(Motion::Tap { to: xyz(to), pitch: *pitch, rpm: *rpm })
            }
            Op::Dwell(Dwell::Seconds(seconds)) => list.push(Motion::Dwell(*seconds)),
            Op::Spindle(state) => spindle = *state,
            Op::Orient(_) => spindle = SpindleState::Off,
            Op::Change(tool) => list.push(Motion::Tool(*tool)),
            Op::Select(_)
            | Op::Machine(_)
            | Op::MachineNumber { .. }
            | Op::Coolant(_)
            | Op::Message(_)
            | Op::Barrier => {}
            _ => return None,
        }
    }
    Some(list.motions)
}

struct List {
    motions: Vec<Motion>,
    /// Where each began.
    from: Vec<[f64; 3]>,
    at: [f64; 3],
}

impl List {
    fn push(&mut self, next: Motion) {
        let Some(to) = next.to() else {
            if next != Motion::Dwell(0.0) {
                self.from.push(self.at);
                self.motions.push(next);
            }
            return;
        };
        let at = self.at;
        let is_circle = matches!(next, Motion::Arc { sweep, .. } if sweep.abs() > 1.0);
        if distance(at, to) < 1e-9 && !is_circle {
            return;
        }
        self.at = to;
        let from = self.from.last().copied().unwrap_or(at);
        match (self.motions.last_mut(), &next) {
            (Some(Motion::Rapid { to: last }), Motion::Rapid { to }) if is_between(from, at, *to) => {
                *last = *to
            }
            (Some(Motion::Cut { to: last, feed: f, spindle: s }), Motion::Cut { to, feed, spindle })
                if f == feed && s == spindle && is_between(from, at, *to) =>
            {
                *last = *to
            }
            (
                Some(Motion::Arc { to: last, center: c, sweep: turned, feed: f, spindle: s }),
                Motion::Arc { to, center, sweep, feed, spindle },
            ) if (f.max(*feed) / f.min(*feed) - 1.0) < SAME_FEED
                && s == spindle
                && (c[0] - center[0]).hypot(c[1] - center[1]) < SAME_PLACE
                && turned.signum() == sweep.signum()
                // The same climb an angle.
                && ((last[2] - from[2]) / *turned - (to[2] - at[2]) / sweep).abs() < SAME_PLACE =>
            {
                *last = *to;
                *turned += sweep;
            }
            _ => {
                self.from.push(at);
                self.motions.push(next);
            }
        }
    }
}

/// The first motion in which two lists differ; none where they are the same.
pub fn difference(a: &[Motion], b: &[Motion]) -> Option<usize> {
    let differs = |(a, b): (&Motion, &Motion)| !is_same(a, b);
    let first = a.iter().zip(b).position(differs);
    first.or((a.len() != b.len()).then_some(a.len().min(b.len())))
}

fn same_turn(a: SpindleState, b: SpindleState) -> bool {
    let speed = |state: SpindleState| match state.speed() {
        Some(ferrocut_toolpath::Speed::Rpm(rpm)) => rpm,
        _ => 0.0,
    };
    let turn = |state: SpindleState| state.turn().map(|turn| turn == Turn::Clockwise);
    turn(a) == turn(b) && (speed(a) - speed(b)).abs() < 0.51
}

fn is_same(a: &Motion, b: &Motion) -> bool {
    let feeds = |a: f64, b: f64| (a - b).abs() <= SAME_FEED * a.abs().max(b.abs()) + 1e-3;
    let places = match (a.to(), b.to()) {
        (Some(a), Some(b)) => distance(a, b) < SAME_PLACE,
        (None, None) => true,
        _ => false,
    };
    places
        && match (a, b) {
            (Motion::Rapid { .. }, Motion::Rapid { .. }) => true,
            (Motion::Cut { feed: f, spindle: s, .. }, Motion::Cut { feed: g, spindle: t, .. }) => {
                feeds(*f, *g) && same_turn(*s, *t)
            }
            (
                Motion::Arc { to, center: c, sweep: u, feed: f, spindle: s },
                Motion::Arc { center: d, sweep: v, feed: g, spindle: t, .. },
            ) => {
                let radius = (to[0] - c[0]).hypot(to[1] - c[1]);
                (c[0] - d[0]).hypot(c[1] - d[1]) < SAME_PLACE
                    && (u - v).abs() < 2.0 * SAME_PLACE / radius.max(SAME_PLACE) + SAME_ANGLE
                    && feeds(*f, *g)
                    && same_turn(*s, *t)
            }
            (Motion::Tap { pitch: p, rpm: n, .. }, Motion::Tap { pitch: q, rpm: m, .. }) => {
                (p - q).abs() < 1e-4 && (n - m).abs() < 0.51
            }
            (Motion::Dwell(s), Motion::Dwell(t)) => (s - t).abs() < 2e-3,
            (Motion::Tool(a), Motion::Tool(b)) => a == b,
            _ => false,
        }
}
