//! Moves: what the planner is fed with.
//!
//! A [`Move`] is made from a step of the toolpath by [`Move::from_step`], the one place where minutes
//! become seconds and the kinds of feed become one: mm/s along the path. A move is finite by
//! construction.

use ferrocut_geometry::{AXES, Arc, Plane, Position, SAME_POINT_MM};
use ferrocut_toolpath::{Feed, FeedAlong, Op, PathMode};

/// One move of the axes, from where the move before it ended.
#[derive(Clone, Copy, PartialEq, Debug)]
pub struct Move {
    pub(crate) tag: u64,
    pub(crate) to: Position,
    pub(crate) kind: Kind,
    /// Speed of the spindle that a feed per revolution was worked out with, r/min; 0 where the feed is none.
    pub(crate) rpm: f64,
    /// How far beside its programmed path it begins, mm: of what the path may leave it this is gone.
    pub(crate) beside: f64,
}

/// A straight cut: what is asked of most moves, in a third of their room.
#[derive(Clone, Copy, Debug)]
pub(crate) struct Cut {
    pub tag: u64,
    pub to: Position,
    pub asked: Asked,
}

/// What is asked of a cut besides where it goes.
#[derive(Clone, Copy, PartialEq, Debug)]
pub(crate) struct Asked {
    /// mm/s.
    pub feed: f64,
    pub path: PathMode,
    /// Speed of the spindle that the feed was worked out with, r/min; 0 where it does not follow it.
    pub rpm: f64,
}

/// How a move gets to its end.
#[derive(Clone, Copy, PartialEq, Debug)]
pub(crate) enum Kind {
    /// Every axis on its own, as fast as it can.
    RapidAxes,
    /// On a straight line, as fast as the slowest axis can, `speed` mm/s at most.
    RapidStraight { speed: f64, path: PathMode },
    /// On a straight line; `feed` mm/s.
    Line { feed: f64, path: PathMode },
    /// On a circle or helix; `feed` mm/s.
    Arc { plane: Plane, center: [f64; 2], sweep: f64, feed: f64, path: PathMode },
}

/// Slowest feed, mm/s: a move with feed 0 would never end. Interpreters refuse it before.
const LEAST_FEED: f64 = 1e-6;

/// Coordinates, angles and feeds beyond this are refused as not finite: no machine is a thousand kilometres
/// long, and what is planned stays far from the ends of `f64`.
const FARTHEST: f64 = 1e9;

/// How far X, Y and Z, how far U, V and W (mm) and how far A, B and C (degrees) go.
#[inline]
pub(crate) fn ways(d: &[f64; AXES]) -> [f64; 3] {
    let [x, y, z, a, b, c, u, v, w] = *d;
    let norm = |x: f64, y: f64, z: f64| (x * x + y * y + z * z).sqrt();
    [norm(x, y, z), norm(u, v, w), norm(a, b, c)]
}

/// What the feed of the straight move by `d` is measured along, as in [`Position::distance`], save that axes which only move by
/// rounding do not set the length of a move of the others. `None` where nothing moves.
pub(crate) fn measured(d: &Position) -> Option<f64> {
    ways(&d.0).into_iter().find(|length| *length > SAME_POINT_MM).or_else(|| {
        // Squares of lengths below 1e-160 vanish; hypot keeps them.
        let [x, y, z, a, b, c, u, v, w] = d.0;
        let any = [[x, y, z], [u, v, w], [a, b, c]].map(|d| d.iter().fold(0.0, |h: f64, c| h.hypot(*c)));
        any.into_iter().find(|length| *length > f64::MIN_POSITIVE)
    })
}

impl Move {
    /// The move that `op` makes from `from`; `None` if it is no move or not finite. `rpm` is the speed of
    /// the spindle for feeds per revolution, r/min; those follow the speed that the planner is told later
    /// ([`Planner::set_spindle`](crate::Planner::set_spindle)). `tag` comes back with the setpoints of the move.
    ///
    /// A tapping step becomes the straight move of its feed, with override and hold without effect; a skip
    /// step a move that stops exactly, which the caller ends with
    /// [`Motion::abort`](crate::Motion::abort) when the signal comes.
    pub fn from_step(op: &Op, from: Position, rpm: f64, tag: u64) -> Option<Move> {
        let to = *op.target()?;
        let speed = |feed: Feed, length: f64| match feed {
            // Motion has the machine's limits.
            Feed::PerMinute(f) | Feed::Held { programmed: f, .. } => f / 60.0,
            Feed::PerRevolution(f) => f * rpm / 60.0,
            Feed::Duration(t) => length / t,
        };
        let straight = || measured(&(to - from)).unwrap_or(0.0);
        let kind = match *op {
            Op::Rapid { straight: true, speed, path, .. } => {
                Kind::RapidStraight { speed: speed.map_or(f64::INFINITY, |s| s / 60.0), path }
            }
            Op::Rapid { straight: false, .. } => Kind::RapidAxes,
            Op::Feed { feed, path, .. } => Kind::Line { feed: speed(feed, straight()), path },
            Op::Skip { feed, .. } => Kind::Line { feed: speed(feed, straight()), path: PathMode::ExactStop },
            Op::Tap { pitch, rpm, .. } => {
                Kind::Line { feed: (pitch * rpm / 60.0).abs(), path: PathMode::Tapping }
            }
            Op::Arc { plane, center, sweep, feed, feed_along, path, .. } => {
                let arc = op.arc(from)?;
                let mut feed = match feed {
                    Feed::Duration(_) => speed(feed, arc.length()),
                    _ => speed(feed, 0.0),
                };
                // In inverse time the time holds for the whole move, along whatever it is measured.
                let timed = matches!(op, Op::Arc { feed: Feed::Duration(_), .. });
                if feed_along == FeedAlong::Circle && !timed && arc.plane_length() > 0.0 {
                    feed *= arc.length() / arc.plane_length();
                }
                Kind::Arc { plane, center, sweep, feed, path }
            }
            _ => return None,
        };
        let turns = matches!(
            op,
            Op::Feed { feed: Feed::PerRevolution(_), .. }
                | Op::Arc { feed: Feed::PerRevolution(_), .. }
                | Op::Skip { feed: Feed::PerRevolution(_), .. }
        );
        Move { tag, to, kind, rpm: if turns { rpm } else { 0.0 }, beside: 0.0 }.checked()
    }

    /// Positioning to `to`: on a straight line, or every axis on its own.
    pub fn rapid(to: Position, straight: bool, tag: u64) -> Option<Move> {
        let line = Kind::RapidStraight { speed: f64::INFINITY, path: PathMode::ON_PATH };
        let kind = if straight { line } else { Kind::RapidAxes };
        Move { tag, to, kind, rpm: 0.0, beside: 0.0 }.checked()
    }

    /// Whether it cuts a thread beside the spindle (G63): no override and no hold acts on it.
    pub fn is_tapping(&self) -> bool {
        matches!(
            self.kind,
            Kind::Line { path: PathMode::Tapping, .. } | Kind::Arc { path: PathMode::Tapping, .. }
        )
    }

    /// Straight cut to `to` at `feed` mm/s (degrees/s where only rotary axes move).
    #[inline]
    pub fn line(to: Position, feed: f64, path: PathMode, tag: u64) -> Option<Move> {
        Move { tag, to, kind: Kind::Line { feed, path }, rpm: 0.0, beside: 0.0 }.checked()
    }

    /// Circular or helical cut to `to` at `feed` mm/s along the path, `sweep` radians about `center`.
    pub fn arc(
        to: Position,
        plane: Plane,
        center: [f64; 2],
        sweep: f64,
        feed: f64,
        path: PathMode,
        tag: u64,
    ) -> Option<Move> {
        Move { tag, to, kind: Kind::Arc { plane, center, sweep, feed, path }, rpm: 0.0, beside: 0.0 }
            .checked()
    }

    /// The parts of it up to the shares `cuts` of its way from `from`, one behind the other.
    pub(crate) fn parts<const N: usize>(&self, from: Position, cuts: [f64; N]) -> [Move; N] {
        let mut done = 0.0;
        cuts.map(|share| {
            let to = if share >= 1.0 { self.to } else { self.at(from, share) };
            let mut kind = self.kind;
            if let Kind::Arc { sweep, .. } = &mut kind {
                *sweep *= share - done;
            }
            done = share;
            Move { to, kind, ..*self }
        })
    }

    /// The point at the share `share` of its way from `from`.
    fn at(&self, from: Position, share: f64) -> Position {
        match self.kind {
            Kind::Arc { plane, center, sweep, .. } => {
                Arc { plane, center, start: from, end: self.to, sweep }.at(share)
            }
            _ => from.lerp(self.to, share),
        }
    }

    /// Speed along the path that is asked for, mm/s; none where positioning is as fast as the axes can.
    pub fn feed(&self) -> Option<f64> {
        match self.kind {
            Kind::RapidAxes => None,
            Kind::RapidStraight { speed: feed, .. } | Kind::Line { feed, .. } | Kind::Arc { feed, .. } => {
                Some(feed).filter(|feed| feed.is_finite())
            }
        }
    }

    /// The last part of the move, where a `share` of it is left (0 to 1).
    pub fn last(mut self, share: f64) -> Move {
        if let Kind::Arc { sweep, .. } = &mut self.kind
            && (0.0..=1.0).contains(&share)
        {
            *sweep *= share;
        }
        self
    }

    /// The same move, begun so far beside its programmed path, mm: a move that was left and is taken up again.
    pub fn beside(self, beside: f64) -> Move {
        Move { beside: beside.max(0.0), ..self }
    }

    /// The same move at another speed along the path, mm/s, whatever the spindle does; positioning at a speed goes on
    /// a straight line.
    pub fn at_speed(mut self, speed: f64) -> Move {
        self.rpm = 0.0;
        match &mut self.kind {
            Kind::RapidAxes => {
                self.kind = Kind::RapidStraight { speed: speed.max(LEAST_FEED), path: PathMode::ON_PATH };
            }
            Kind::RapidStraight { speed: feed, .. } | Kind::Line { feed, .. } | Kind::Arc { feed, .. } => {
                if !speed.is_nan() {
                    *feed = speed.clamp(LEAST_FEED, FARTHEST);
                }
            }
        }
        self
    }

    /// What it asks for, if it is a straight cut.
    #[inline]
    pub(crate) fn cut(&self) -> Option<Cut> {
        let Kind::Line { feed, path } = self.kind else { return None };
        Some(Cut { tag: self.tag, to: self.to, asked: Asked { feed, path, rpm: self.rpm } })
    }

    /// Whether it is an arc, which may end where it begins.
    pub(crate) fn is_arc(&self) -> bool {
        matches!(self.kind, Kind::Arc { .. })
    }

    /// Where it ends.
    pub fn to(&self) -> Position {
        self.to
    }

    /// The caller's mark.
    pub fn tag(&self) -> u64 {
        self.tag
    }

    #[inline]
    fn checked(mut self) -> Option<Move> {
        let good = |x: &f64| x.abs() <= FARTHEST;
        let possible = match &mut self.kind {
            Kind::RapidAxes => true,
            Kind::RapidStraight { speed, .. } => {
                *speed = speed.max(LEAST_FEED);
                !speed.is_nan()
            }
            Kind::Line { feed, .. } => clamp_feed(feed),
            Kind::Arc { center, sweep, feed, .. } => {
                clamp_feed(feed) && good(sweep) && center.iter().all(good)
            }
        };
        (possible && self.to.0.iter().all(good) && good(&self.rpm)).then_some(self)
    }
}

/// Brings a feed into what can be run; `false` if it is no number.
fn clamp_feed(feed: &mut f64) -> bool {
    let is_number = !feed.is_nan();
    *feed = feed.clamp(LEAST_FEED, FARTHEST);
    is_number
}
