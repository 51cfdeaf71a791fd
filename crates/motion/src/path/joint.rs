//! Joints: how one move runs into the next.
//!
//! At a joint the direction `q′` may jump by `Δ` and the curvature `q″` by `K`. Run through at speed `v`, the axes
//! would have to change their velocity by `Δ·v` and their acceleration by `K·v²` in no time. There are five ways:
//!
//! - **Rest** where the program asks for it, between positioning and cutting that may not leave their corner, and where
//!   the path turns back.
//! - **Through** where `Δ` and `K` are no more than rounding: the jump is lost in the margin that planning keeps.
//! - **Ease**: over a length `h` on both sides a correction is added to the programmed curve that takes up both
//!   jumps. With `x` the distance from the joint
//!
//!   ```text
//!   e(x) = Δ·(h−x)³/6h²  ±  K·x·(h−x)³/12h²        (+ behind the joint, − before it)
//!   ```
//!
//!   `e`, `e′`, `e″` are 0 at `x = h`; at the joint `e′` jumps by `−Δ` and `e″` by `−K`. The path is then C² with
//!   bounded `q‴`, and the same length `s` on both paths lies at most `|Δ|·h/6 + 0.00879·|K|·h²` apart: that is
//!   kept within the tolerance, and holds for the missed vertex too. Between lines this is the jerk-limited
//!   blend of constant speed, `Δv = |Δ|·v = (36·δ²·J)^⅓`.
//! - **Chain**: lines are smoothed as a whole ([`crate::path::smooth`]); where two of them meet alone, that is the
//!   same as an ease.
//! - **Corner**, rounded in time ([`crate::path::corner`]): beside an arc where the path turns by more than 20° and
//!   easing would cost time, between lines where that is quicker.

use crate::limits::{Class, Drive, Inverse, Inverses, MAX_FEED_OVERRIDE, MAX_SPINDLE_OVERRIDE, Rates, peak};
use crate::moves::{Asked, Cut, Kind, Move};
use crate::path::corner::{Corner, Far, Lines, Side, norm, valley_loss};
use crate::path::piece::Piece;
use crate::path::shape::moves_others;
use crate::path::slow::{self, Slowdown, on_arc};
use ferrocut_geometry::{AXES, Position};
use ferrocut_machine::{ArcSlowdown, Machine};
use ferrocut_toolpath::{InnerCorners, PathMode};

/// Joints with an arc that turn by more than 20° are corners, where easing them would be slower than the feed. This is
/// 2·sin(20°/2).
const ARC_CHORD: f64 = 0.347_296_355_333_860_7;

/// A path that turns by more than 175° turns back and comes to rest: 2·sin(175°/2).
const BACK_CHORD: f64 = 1.998_096;

/// Share of acceleration and jerk, over one servo period, that the jumps at joints run through may take. With the
/// share that the path takes (see [`crate::limits`]) it stays under the whole.
const JOINT_SHARE: f64 = 0.0004;

/// Share of the jerk and the acceleration that easing a joint shall take; a shorter ease keeps more of the programmed path.
const EASE_SHARE: f64 = 0.1;

/// Joints that would have to be run through slower than this come to rest, mm/s.
const CRAWL: f64 = 1.0;

/// Two lines are smoothed together where a corner rounded in time would take more than this share of the shorter one, `8δ/|d₂ − d₁|`:
/// beside a long line it is quicker to slow down for the corner alone, among short ones to run one curve through all of them.
/// Behind a line that is smoothed nearly all are: where a curve ends and a corner begins both are slow. Behind anything else
/// gentle corners are, and in general where a corner would leave no room for the next.
///
/// The shares are those with which 400 random and regular polygons of lines from 0.3 to 60 mm, within 3 to 50 um at F2000 to F18000,
/// take the least time; where each corner of each of them is chosen by trial, they take another half a percent less.
const CHAIN_BEHIND_CHAIN: f64 = 0.025;
const CHAIN_OF_GENTLE: f64 = 0.085;
const CHAIN_ROOM: f64 = 0.15;

/// Gentle corners turn by up to 67°: 2·sin(67°/2).
const GENTLE_CHORD: f64 = 1.1;

/// Where no jerk is limited a curve is quicker however far apart corners are, up to 74°: 2·sin(74°/2).
const FREE_CHORD: f64 = 1.2;

/// A short line beside one at least so many times as long, into which it turns by more than 60°, may be what joins two rows
/// ([`crate::path::link`]); a curve through all of it is quicker only where the tolerance is more than this share of it.
const ROW: f64 = 12.0;
const ROW_CURVE: f64 = 0.6;
const ROW_CHORD: f64 = 1.0;

/// What is left of the tolerance of a move that begins beside its programmed path, at least: its end is still rounded.
const LEAST_LEFT: f64 = 0.05;

/// Share of the shorter line that a corner takes at most.
const CORNER_ROOM: f64 = 0.4;

/// Share of the tolerance that chords of a short arc take.
const CHORD_SHARE: f64 = 0.03;

/// An arc is short if it is no longer than this many eases.
const SHORT_ARC: f64 = 4.0;

/// Arcs that would take more chords are eased.
pub(crate) const MOST_CHORDS: f64 = 96.0;

/// Shortest ease, mm.
const LEAST_EASE: f64 = 1e-7;

/// What easing a corner without a limit of jerk takes, times what is worked out: the spline is the one of least third
/// derivative, not of least curvature.
const FREE_EASE: f64 = 1.25;

/// Share of what running the whole of an ease at its speed costs.
const EASE_COST: f64 = 0.25;

/// Directions that differ by less meet smoothly: 2·sin(0.1°/2).
const SMOOTH_CHORD: f64 = 1.745e-3;

/// Lines shorter than this, or with less tolerance, are looked at in full, mm.
const LEAST_RUN: f64 = 1e-5;

/// Two directions that differ by less than this, by every triple of axes, do not turn back: 2·sin(150°/2).
const RUN_CHORD: f64 = 1.93;

/// Largest of `x·(1−x)³`, over 12.
const BEND_MISS: f64 = 0.008_789_1;

/// A move whose end is still open: its curve and what is needed to join the next one.
#[derive(Clone, Copy, Debug)]
pub(crate) struct Member {
    pub tag: u64,
    pub piece: Piece,
    pub class: Class,
    /// Programmed speed along `s`, mm/s; infinite for rapids.
    pub feed: f64,
    /// How far the joint after it may leave the programmed path, mm; `None` is an exact stop.
    pub tolerance: Option<f64>,
    /// It is a piece of a block and not the last one.
    pub within_block: bool,
    /// The first part of a line, of which the next is the rest.
    pub is_part: bool,
    /// Speed of the spindle that the feed holds at, r/min; 0 where it does not follow the spindle.
    pub rpm: f64,
    /// Highest speed whatever the override, mm/s: of cutting, of an arc; infinite where there is none.
    pub most: f64,
    /// Inner corners at its ends are slowed down for (G62).
    pub inner: Option<InnerCorners>,
    /// What was asked for, where that has been looked at and is smoothed with what asks for the same.
    asked: Option<Asked>,
}

/// How a move meets the one before it.
#[derive(Clone, Copy, PartialEq, Eq, Debug)]
pub(crate) enum Behind {
    /// It is smoothed with it.
    Chain,
    /// By a corner rounded in time.
    Corner,
    Other,
}

impl Behind {
    /// What share of the shorter line a corner takes at least where both are smoothed together instead; `angle` is the distance of
    /// their directions.
    fn chain_room(self, angle: f64) -> f64 {
        match self {
            Behind::Chain => CHAIN_BEHIND_CHAIN,
            Behind::Other if angle < GENTLE_CHORD => CHAIN_OF_GENTLE,
            Behind::Corner | Behind::Other => CHAIN_ROOM,
        }
    }
}

/// How two moves are joined.
#[derive(Clone, Copy, Debug)]
#[expect(clippy::large_enum_variant, reason = "there is one of it at a time")]
pub(crate) enum Joint {
    /// Comes to rest.
    Rest,
    /// Runs through at no more than this speed.
    Through(f64),
    /// Eased over this length on both sides, mm.
    Ease(Ease),
    /// Rounded in time; between lines it may swing out ([`Corner::swinging`]).
    Corner(Corner, Option<Lines>),
    /// The two lines are smoothed together.
    Chain,
}

/// Settings of the machine that joints depend on.
#[derive(Clone, Copy, Debug)]
pub(crate) struct JointRules {
    pub tolerance: f64,
    pub exact_stop: bool,
    /// Slowest and fastest cutting, overrides included, mm/s.
    pub feeds: [f64; 2],
    /// Servo period, s.
    pub period: f64,
    corner: Option<Slowdown>,
    arc: Option<ArcSlowdown>,
}

impl JointRules {
    pub fn new(machine: &Machine) -> JointRules {
        let path = &machine.path;
        JointRules {
            tolerance: path.tolerance,
            exact_stop: path.exact_stop,
            feeds: [path.lowest_feed / 60.0, path.highest_feed.map_or(f64::INFINITY, |most| most / 60.0)],
            period: machine.servo_period_ms / 1000.0,
            corner: path.corner.as_ref().map(Slowdown::new),
            arc: path.arc,
        }
    }

    /// The feed below which no override and no spindle leads to more than the slowest, and the fastest, mm/s: neither
    /// holds for positioning, nor beside a spindle that cuts a thread.
    #[inline]
    fn feeds_of(&self, class: Class, rpm: f64) -> [f64; 2] {
        let [slowest, fastest] = self.feeds;
        let holds = matches!(class, Class::Cut | Class::Full);
        if holds { [slowest / highest_share(rpm), fastest] } else { [0.0, f64::INFINITY] }
    }

    /// How far the joint behind a move may leave the path, mm; `None` is an exact stop.
    fn tolerance_of(&self, path: PathMode) -> Option<f64> {
        let within = |t: f64| if t.is_finite() { t.max(0.0) } else { self.tolerance };
        match path {
            PathMode::WithinBlock(t) => Some(t.map_or(self.tolerance, within)),
            _ if self.exact_stop => None,
            PathMode::ExactStop => None,
            PathMode::Continuous | PathMode::InnerCorners(_) | PathMode::Tapping | PathMode::FullFeed => {
                Some(self.tolerance)
            }
            PathMode::ContinuousWithin(t) => Some(within(t)),
        }
    }
}

impl Member {
    /// The move `m` from `from`; `None` where nothing moves.
    pub fn new(from: Position, m: &Move, rules: &JointRules) -> Option<Member> {
        let piece = Piece::new(from, m)?;
        let (feed, path) = match m.kind {
            Kind::RapidAxes => (f64::INFINITY, PathMode::ON_PATH),
            Kind::RapidStraight { speed: feed, path }
            | Kind::Line { feed, path }
            | Kind::Arc { feed, path, .. } => (feed, path),
        };
        let class = match m.kind {
            Kind::RapidAxes | Kind::RapidStraight { .. } => Class::Rapid,
            Kind::Line { .. } | Kind::Arc { .. } => cutting_class(path),
        };
        let left = |tolerance: f64| (tolerance - m.beside).max(LEAST_LEFT * tolerance);
        let tolerance = rules.tolerance_of(path).map(left);
        let inner = if let PathMode::InnerCorners(corners) = path { Some(corners) } else { None };
        let [lowest, highest] = rules.feeds_of(class, m.rpm);
        let most = match (&piece, &rules.arc) {
            (Piece::Arc(turn), Some(arc)) => on_arc(arc, turn.radius()).min(highest),
            _ => highest,
        };
        let most = most * piece.pace();
        let feed = feed.max(lowest) * piece.pace();
        let within_block = matches!(path, PathMode::WithinBlock(_));
        Some(Member {
            tag: m.tag,
            piece,
            class,
            feed,
            tolerance,
            within_block,
            is_part: false,
            rpm: m.rpm,
            most,
            inner,
            asked: None,
        })
    }

    /// Goes on with the line `m`, if both are smoothed together and nothing asks for a closer look: then it is that line.
    /// The same as [`Member::new`] and [`join`](Self::join) would say, without a copy; nearly all moves of programs of
    /// short lines go this way. `s` is the length of the path up to there; the length of the line, or `None`.
    #[inline]
    pub fn run_on(&mut self, m: &Cut, rules: &JointRules, s: f64) -> Option<f64> {
        let Piece::Line(line) = &mut self.piece else { return None };
        let Asked { feed, path, rpm } = m.asked;
        let tolerance = self.tolerance?;
        let is_asked = self.asked == Some(m.asked);
        if !is_asked {
            let is_other = rules.corner.is_some()
                || matches!(path, PathMode::InnerCorners(_))
                || self.class != cutting_class(path)
                || self.rpm != rpm
                || moves_others(&line.dir);
            if is_other || !(tolerance > 0.0) || rules.tolerance_of(path) == Some(0.0) {
                return None;
            }
        }
        let (dir, len) = line.next(&m.to)?;
        let shorter = line.len.min(len);
        if !turns_little(&line.dir.0, &dir, shorter, tolerance)
            || ends_row(line.len, len, chord(&line.dir.0[..3], &dir), tolerance)
            || is_lost(shorter, s + len)
        {
            return None;
        }
        line.go_on(&m.to, dir, len);
        self.tag = m.tag;
        if !is_asked {
            let [lowest, highest] = rules.feeds_of(self.class, rpm);
            (self.feed, self.most) = (feed.max(lowest), highest);
            (self.tolerance, self.inner, self.asked) = (rules.tolerance_of(path), None, Some(m.asked));
            self.within_block = matches!(path, PathMode::WithinBlock(_));
        }
        Some(len)
    }

    /// Where the inner corners at its ends begin and end to act, as shares of its length (G62).
    pub fn reaches(&self) -> Option<[f64; 2]> {
        self.inner?;
        let len = self.piece.len();
        let quadrant = match &self.piece {
            Piece::Arc(turn) => slow::QUADRANT * turn.radius(),
            _ => f64::INFINITY,
        };
        let share = (slow::REACH.min(quadrant) * self.piece.pace() / len).min(0.5);
        Some([share, 1.0 - share])
    }

    /// Slows both moves down if there is an inner corner between them. To which speed.
    pub fn slow_inner_corner(&mut self, next: &mut Member) -> Option<f64> {
        let corners = self.inner.filter(|_| next.inner.is_some())?;
        let (before, after) = (self.piece.tangent(self.piece.len()), next.piece.tangent(0.0));
        let speed = slow::inner_corner(&corners, &before, &after)?;
        for member in [self, next] {
            member.feed = member.feed.min(speed);
        }
        Some(speed)
    }

    /// How this move runs into `next`.
    pub fn join(&self, next: &Member, behind: Behind, rules: &JointRules, inverses: &Inverses) -> Joint {
        if self.is_part {
            return Joint::Through(f64::INFINITY);
        }
        let inverse = inverses.beside(self.class, next.class);
        let Some(tolerance) = self.tolerance else { return Joint::Rest };
        // What is beside a joint is of both moves. An exact stop has a tolerance at its end alone, and so has the last piece
        // of a block.
        let tolerance = match next.tolerance {
            Some(next) if !self.within_block => tolerance.min(next),
            _ => tolerance,
        };
        let is_rapid = self.class == Class::Rapid || next.class == Class::Rapid;
        // Between positioning and cutting the path rests, unless it may leave its corner.
        let may_run_on = self.class == next.class || !is_rapid || self.blends_with(next, tolerance);
        let is_path = |piece: &Piece| !matches!(piece, Piece::Axes { .. });
        if !may_run_on || !is_path(&self.piece) || !is_path(&next.piece) {
            return Joint::Rest;
        }
        let (len, next_len) = (self.piece.len(), next.piece.len());
        let is_chain =
            !is_rapid && self.class == next.class && tolerance > 0.0 && next.tolerance != Some(0.0);
        let is_chain = is_chain && self.rpm == next.rpm;
        let is_chain = is_chain && self.piece.is_line() && next.piece.is_line();
        let (before, after) = (self.piece.tangent(len), next.piece.tangent(0.0));
        let cap = match rules.corner {
            Some(corner) if matches!(self.class, Class::Cut | Class::Full) => corner.speed(&before, &after),
            _ => f64::INFINITY,
        };
        let drive = || inverse.straight(&before.0).min(inverse.straight(&after.0));
        let top = || self.top(inverse, len).min(next.top(inverse, 0.0));
        let [row, link] =
            if behind == Behind::Corner && next_len > len { [next_len, len] } else { [len, next_len] };
        let corner = || {
            let room = CORNER_ROOM * len.min(next_len);
            let corner = Corner::new(&self.piece, &next.piece, tolerance, room, inverse);
            corner.map(|corner| corner.capped(cap))
        };
        // At a slow feed a curve is run without slowing down.
        let is_row = is_chain
            && ends_row(row, link, chord(&before.0, &after.0), tolerance)
            && corner().is_some_and(|corner| {
                corner.foot.top(drive().j) <= top().min(self.feed).min(next.feed).min(cap)
            });
        let is_simple = is_chain && !is_row && cap == f64::INFINITY;
        if is_simple && runs_on(&before, &after, len.min(next_len), tolerance) {
            return Joint::Chain;
        }
        let jump = after - before;
        let bend = next.piece.bend(0.0) - self.piece.bend(len);
        // Rotary axes that turn beside X, Y, Z would hide a reversal of these.
        let mut angle = turn(&before.0, &after.0);
        if self.piece.pace() == 1.0 && next.piece.pace() == 1.0 && !(self.turns_alone() || next.turns_alone())
        {
            angle = angle.max(turn(&before.0[..3], &after.0[..3]));
        }
        let top = top();
        let is_slow = cap < top;
        let top = top.min(cap);
        // Several joints may fall into the periods that jerk is seen over.
        let crowd = (3.0 * top * rules.period / len.min(next_len)).max(1.0);
        let share = JOINT_SHARE * rules.period / crowd;
        let step = inverse.change_time(&jump.0).max(peak(&jump.0, &inverse.jerk) / rules.period);
        let through =
            (share / step.max(1e-300)).min((share / peak(&bend.0, &inverse.jerk).max(1e-300)).sqrt());
        let is_chain = is_chain && !is_slow;
        if through >= top {
            return if is_chain { Joint::Chain } else { Joint::Through(cap) };
        }
        let or_through =
            |through: f64| if through >= CRAWL { Joint::Through(through.min(cap)) } else { Joint::Rest };
        if is_rapid && !(tolerance > 0.0) || angle > BACK_CHORD {
            return or_through(through);
        }
        let room = 0.5 * len.min(next_len);
        let ease = Ease::new(len, jump, bend, tolerance, room, top, inverse).map(|ease| Ease { cap, ..ease });
        let drive = drive();
        let feed = top.min(self.feed).min(next.feed);
        let (Piece::Line(_), Piece::Line(_)) = (&self.piece, &next.piece) else {
            return match ease {
                Some(ease) if angle <= ARC_CHORD || ease.speed(inverse) >= feed => Joint::Ease(ease),
                _ if angle <= ARC_CHORD => or_through(through),
                _ => corner().map_or(Joint::Rest, |corner| Joint::Corner(corner, None)),
            };
        };
        let least = len.min(next_len);
        let is_other = self.inner.is_some() || next.inner.is_some();
        let is_free = !is_other && angle < FREE_CHORD && inverse.is_free_of_jerk(&jump.0);
        let room = if is_other { CHAIN_ROOM } else { behind.chain_room(angle) } * least;
        let is_better = |corner: &Corner| is_row || !is_free && corner.reach < room;
        let corner = corner().filter(|corner| !is_chain || is_better(corner));
        let ease = ease.filter(|_| !is_row || corner.is_none());
        match choose(ease, corner, feed, drive, inverse) {
            Some(Joint::Ease(_)) if is_chain => Joint::Chain,
            // Between lines alone.
            Some(Joint::Corner(corner, _)) if tolerance > 0.0 && !is_rapid => {
                let side = |member: &Member, at: f64, direction: &Position| {
                    let (len, drive) = (member.piece.len(), inverse.straight(&direction.0));
                    let feed = member.top(inverse, at).min(member.feed);
                    Side { len, feed, drive, end: Far::Other }
                };
                let sides = [side(self, len, &before), side(next, 0.0, &after)];
                Joint::Corner(corner, Some(Lines { tolerance, sides }))
            }
            Some(joint) => joint,
            None => or_through(through),
        }
    }

    /// Whether X, Y and Z stand.
    fn turns_alone(&self) -> bool {
        matches!(&self.piece, Piece::Line(line) if line.dir.0[..3] == [0.0; 3])
    }

    /// Whether positioning and cutting run into each other: within a tolerance, and where the feed can be held.
    fn blends_with(&self, next: &Member, tolerance: f64) -> bool {
        let may = |class| matches!(class, Class::Rapid | Class::Cut);
        tolerance > 0.0 && may(self.class) && may(next.class)
    }

    /// In how many chords the move is smoothed; 1 is not at all. Arcs so short that easing them at both ends within
    /// the tolerance would take all of them are smoothed with the lines beside them.
    pub fn chords(&self) -> usize {
        let (Piece::Arc(turn), Some(tolerance)) = (&self.piece, self.tolerance) else { return 1 };
        // Without a limit of jerk the curvature may jump.
        if !(tolerance > 0.0) {
            return 1;
        }
        let bend = norm(&self.piece.bend(0.5 * turn.len).0);
        let ease = (tolerance / (BEND_MISS * bend)).sqrt();
        // The sagitta of a chord of angle φ is φ²/8 of the radius.
        let chord = (8.0 * CHORD_SHARE * tolerance / bend).sqrt();
        let count = (turn.len / chord).ceil();
        if turn.len < SHORT_ARC * ease && count < MOST_CHORDS { (count as usize).max(8) } else { 1 }
    }

    /// Whether this move, an arc, and the one behind it meet in one direction and without a limit of jerk: then it is run as
    /// it is, because its curvature may jump.
    pub fn meets_smoothly(&self, next: &Member, inverses: &Inverses) -> bool {
        let (before, after) = (self.piece.tangent(self.piece.len()), next.piece.tangent(0.0));
        inverses.of(self.class).is_free_of_jerk(&before.0) && norm(&(after - before).0) < SMOOTH_CHORD
    }

    /// The chord of this move between two points of it.
    pub fn chord(&self, from: Position, to: Position) -> Option<Member> {
        let tolerance = self.tolerance.map(|tolerance| tolerance * (1.0 - CHORD_SHARE));
        let piece = Piece::line(from, to)?;
        let more = piece.pace() / self.piece.pace();
        let (feed, most) = (self.feed * more, self.most * more);
        Some(Member { piece, tolerance, feed, most, ..*self })
    }

    /// Highest speed that feed and axes allow at length `s`, mm/s.
    pub fn top(&self, inverse: &Inverse, s: f64) -> f64 {
        let rates = Rates { first: self.piece.tangent(s).0, second: [0.0; AXES], third: [0.0; AXES] };
        let speed = inverse.speed(&rates).min(self.most);
        if self.feed.is_finite() { speed.min(self.feed * highest_share(self.rpm)) } else { speed }
    }
}

/// How many times its feed a move is run at most, where it holds at this speed of the spindle, r/min.
fn highest_share(rpm: f64) -> f64 {
    if rpm > 0.0 { MAX_FEED_OVERRIDE * MAX_SPINDLE_OVERRIDE } else { MAX_FEED_OVERRIDE }
}

/// Under which limits and override a cut is.
fn cutting_class(path: PathMode) -> Class {
    match path {
        PathMode::Tapping => Class::Locked,
        PathMode::FullFeed => Class::Full,
        _ => Class::Cut,
    }
}

/// Of a path that is so many times as long, a shorter line is lost in rounding.
const LEAST_SHARE: f64 = 1e-8;

/// Whether a line of this length is lost in rounding behind the path `s`.
pub(crate) fn is_lost(len: f64, s: f64) -> bool {
    len < LEAST_SHARE * s
}

/// Whether two lines, the shorter `len` long, need no closer look to be smoothed together: they do not turn back, and a
/// corner rounded in time would take more of them than there is.
fn runs_on(before: &Position, after: &Position, len: f64, tolerance: f64) -> bool {
    let is_other = |p: &Position| p.0[3..].iter().any(|c| *c != 0.0);
    let [x, y, z, ..] = after.0;
    !is_other(before) && !is_other(after) && turns_little(&before.0, &[x, y, z], len, tolerance)
}

/// The same for directions of X, Y and Z alone.
#[inline]
fn turns_little(before: &[f64; AXES], after: &[f64; 3], len: f64, tolerance: f64) -> bool {
    let square: f64 = (0..3).map(|i| (after[i] - before[i]) * (after[i] - before[i])).sum();
    let (room, most) = (CORNER_ROOM * len, 8.0 * tolerance);
    len >= LEAST_RUN
        && tolerance >= LEAST_RUN
        && square <= RUN_CHORD * RUN_CHORD
        && square * (room * room) <= most * most
}

/// Whether `link` is a line between two rows, of which the one beside it is `row` long, so that a curve through both is slower
/// than corners; they turn by so much, as the distance of their directions.
#[inline]
fn ends_row(row: f64, link: f64, chord: f64, tolerance: f64) -> bool {
    row >= ROW * link && tolerance <= ROW_CURVE * link && chord > ROW_CHORD
}

/// The distance of two directions.
#[inline]
fn chord(a: &[f64], b: &[f64]) -> f64 {
    a.iter().zip(b).map(|(a, b)| (a - b) * (a - b)).sum::<f64>().sqrt()
}

/// The quicker of both.
fn choose(
    ease: Option<Ease>,
    corner: Option<Corner>,
    feed: f64,
    drive: Drive,
    inverse: &Inverse,
) -> Option<Joint> {
    match (ease, corner) {
        (Some(ease), Some(corner)) => {
            let v = ease.speed(inverse);
            let mut loss = valley_loss(v, feed, drive);
            // Where the jerk is not limited, the ease itself is run at a steady speed.
            if peak(&ease.jump.0, &inverse.jerk) == 0.0 {
                loss = FREE_EASE * (loss + 2.0 * ease.h * (1.0 / v - 1.0 / feed));
            } else {
                loss += EASE_COST * 2.0 * ease.h * (1.0 / v - 1.0 / feed);
            }
            let is_eased = v >= feed || loss <= corner.loss(feed, drive);
            Some(if is_eased { Joint::Ease(ease) } else { Joint::Corner(corner, None) })
        }
        (Some(ease), None) => Some(Joint::Ease(ease)),
        (None, Some(corner)) => Some(Joint::Corner(corner, None)),
        (None, None) => None,
    }
}

/// How much two directions differ: the distance of their unit vectors, which keeps the small angles that
/// `acos` loses. 0 if both vectors vanish; 2 if one does.
fn turn(a: &[f64], b: &[f64]) -> f64 {
    let (na, nb) = (norm(a), norm(b));
    if na == 0.0 || nb == 0.0 {
        return if na == nb { 0.0 } else { 2.0 };
    }
    a.iter().zip(b).map(|(a, b)| (a / na - b / nb).powi(2)).sum::<f64>().sqrt()
}

/// The correction that takes up the jumps at a joint.
#[derive(Clone, Copy, Debug)]
pub(crate) struct Ease {
    /// Jump of `q′` over `6h²`.
    jump: Position,
    /// Jump of `q″` over `12h²`, with the sign of the side.
    bend: Position,
    /// Length on either side, mm.
    pub h: f64,
    /// Where the joint is along the move, mm.
    joint: f64,
    /// Highest speed at the joint, mm/s, by the rules of corners.
    pub cap: f64,
}

impl Ease {
    /// Before the joint at the length `joint` of a move. `None` where there is no room or no tolerance.
    fn new(
        joint: f64,
        jump: Position,
        bend: Position,
        tolerance: f64,
        room: f64,
        top: f64,
        inverse: &Inverse,
    ) -> Option<Ease> {
        if !(tolerance > 0.0) {
            return None;
        }
        let (d, k) = (norm(&jump.0) / 6.0, norm(&bend.0) * BEND_MISS);
        let h = 2.0 * tolerance / (d + (d * d + 4.0 * k * tolerance).sqrt());
        let (d, k) = (peak(&jump.0, &inverse.jerk), 1.5 * peak(&bend.0, &inverse.jerk));
        let cube = top * top * top / EASE_SHARE;
        let enough = 0.5 * (k * cube + (k * k * cube * cube + 4.0 * d * cube).sqrt());
        // The bend that takes up the jump is |Δ|/h.
        let enough = enough.max(peak(&jump.0, &inverse.acceleration) * top * top / EASE_SHARE);
        let h = h.min(room).min(enough.max(0.5 * tolerance));
        if !(h > LEAST_EASE) {
            return None;
        }
        let (d, k) = (1.0 / (6.0 * h * h), 1.0 / (12.0 * h * h));
        Some(Ease {
            jump: Position(jump.0.map(|c| c * d)),
            bend: Position(bend.0.map(|c| -c * k)),
            h,
            joint,
            cap: top,
        })
    }

    /// With these jumps, over the length `h`.
    #[cfg(test)]
    pub fn example(joint: f64, jump: Position, bend: Position, h: f64) -> Ease {
        Ease { jump, bend, h, joint, cap: f64::INFINITY }
    }

    /// The same behind the joint, where the next move begins.
    pub fn behind(&self) -> Ease {
        Ease { bend: Position(self.bend.0.map(|c| -c)), joint: 0.0, ..*self }
    }

    /// −1 before the joint, 1 behind it: on the joint itself the derivatives are those of the move.
    fn side(&self) -> f64 {
        if self.joint > 0.0 { -1.0 } else { 1.0 }
    }

    /// Highest speed at which it alone keeps acceleration and jerk.
    pub fn speed(&self, inverse: &Inverse) -> f64 {
        let rates = self.rates(self.joint, self.joint);
        inverse.speed(&Rates { first: [0.0; AXES], ..rates }).min(self.cap)
    }

    /// The correction at length `s` of the move.
    pub fn at(&self, s: f64) -> Position {
        let x = (s - self.joint).abs();
        let cube = (self.h - x).max(0.0).powi(3);
        self.jump.zip(self.bend, |d, k| cube * (d + k * x))
    }

    /// Its first derivative at length `s` of the move.
    pub fn slope(&self, s: f64) -> Position {
        let x = (s - self.joint).abs();
        let left = (self.h - x).max(0.0);
        let square = self.side() * left * left;
        self.jump.zip(self.bend, |d, k| square * (k * (self.h - 4.0 * x) - 3.0 * d))
    }

    /// Whether it moves other axes than X, Y and Z.
    pub fn moves_others(&self) -> bool {
        moves_others(&self.jump) || moves_others(&self.bend)
    }

    /// Its second and third derivative at length `s` of the move, no further from the joint than it reaches.
    pub fn bends(&self, s: f64) -> [Position; 2] {
        let x = (s - self.joint).abs();
        let left = (self.h - x).max(0.0);
        let side = self.side();
        [
            self.jump.zip(self.bend, |d, k| 6.0 * left * (d + k * (2.0 * x - self.h))),
            self.jump.zip(self.bend, |d, k| side * (k * (18.0 * self.h - 24.0 * x) - 6.0 * d)),
        ]
    }

    /// Bounds of its derivatives over `from`…`to`.
    pub fn rates(&self, from: f64, to: f64) -> Rates {
        let h = self.h;
        let (x0, x1) = ((from - self.joint).abs(), (to - self.joint).abs());
        let (x0, x1) = (x0.min(x1).min(h), x0.max(x1).min(h));
        let y = h - x0;
        // Of x·(h−x)³: where its derivatives have their extremes.
        let most = |f: &dyn Fn(f64) -> f64, at: f64| {
            let inside = if x0 < at && at < x1 { f(at).abs() } else { 0.0 };
            f(x0).abs().max(f(x1).abs()).max(inside)
        };
        let first = most(&|x| (h - x) * (h - x) * (h - 4.0 * x), 0.5 * h);
        let second = most(&|x| 6.0 * (h - x) * (2.0 * x - h), 0.75 * h);
        let third = most(&|x| 18.0 * h - 24.0 * x, h);
        let sum =
            |d: f64, k: f64| std::array::from_fn(|i| d * self.jump.0[i].abs() + k * self.bend.0[i].abs());
        Rates { first: sum(3.0 * y * y, first), second: sum(6.0 * y, second), third: sum(6.0, third) }
    }
}

/// The sum of both, bound by bound.
pub(crate) fn add(a: &Rates, b: &Rates) -> Rates {
    let sum = |x: &[f64; AXES], y: &[f64; AXES]| std::array::from_fn(|i| x[i].abs() + y[i].abs());
    Rates {
        first: sum(&a.first, &b.first),
        second: sum(&a.second, &b.second),
        third: sum(&a.third, &b.third),
    }
}
