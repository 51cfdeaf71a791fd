//! Runs programs through the planner and judges the setpoints by finite differences and true distances.
#![allow(dead_code, missing_docs, clippy::unwrap_used, clippy::panic)]

use ferrocut_geometry::{AXES, Arc, Position};
use ferrocut_machine::Machine;
use ferrocut_motion::{Limits, Motion, Move, Setpoint, State};
use ferrocut_toolpath::{Feed, FeedAlong, Op, PathMode};

pub fn demo() -> Machine {
    Machine::from_toml(Machine::DEMO_MILL).unwrap()
}

/// Every axis of the demo mill brought to the same round numbers: 10 m/min, 2000 mm/s².
pub fn round_machine() -> Machine {
    let mut machine = demo();
    for axis in &mut machine.axes {
        (axis.rapid, axis.velocity, axis.acceleration) = (15000.0, 10000.0, 2000.0);
    }
    machine
}

pub fn line(x: f64, y: f64, z: f64, f: f64, path: PathMode) -> Op {
    Op::Feed { to: Position::xyz(x, y, z), feed: Feed::PerMinute(f), path }
}

pub fn arc(to: Position, center: [f64; 2], sweep: f64, f: f64) -> Op {
    Op::Arc {
        to,
        plane: ferrocut_geometry::Plane::Xy,
        center,
        sweep,
        feed: Feed::PerMinute(f),
        feed_along: FeedAlong::Path,
        path: PathMode::Continuous,
    }
}

#[derive(Clone, Copy, Debug, PartialEq)]
pub enum Event {
    Override(f64, f64),
    Hold,
    Resume,
    Abort,
}

/// What a run gave.
pub struct Run {
    pub start: Position,
    pub ops: Vec<Op>,
    pub samples: Vec<Setpoint>,
    pub period: f64,
    pub aborted: bool,
}

/// Ticks after which a run is taken as hanging.
pub const HANGS: usize = 2_000_000;

/// Runs `ops`, filling the planner before every tick, with `events` at ticks. `rhythm` is how many moves
/// may be pushed before each tick, in turn; empty is as many as fit.
pub fn run_with(
    machine: &Machine,
    start: Position,
    ops: &[Op],
    events: &[(usize, Event)],
    rhythm: &[usize],
) -> Run {
    let mut motion = Motion::new(machine, start);
    let mut moves = Vec::new();
    let mut at = start;
    for (i, op) in ops.iter().enumerate() {
        moves.extend(Move::from_step(op, at, 1000.0, i as u64));
        at = *op.target().unwrap();
    }
    let mut next = 0;
    let mut finished = false;
    let mut run = Run {
        start,
        ops: ops.to_vec(),
        samples: Vec::new(),
        period: machine.servo_period_ms / 1e3,
        aborted: false,
    };
    for tick in 0..HANGS {
        let most = if rhythm.is_empty() { usize::MAX } else { rhythm[tick % rhythm.len()] };
        for _ in 0..most {
            if next == moves.len() || motion.free() == 0 {
                break;
            }
            motion.push(&moves[next]).unwrap();
            next += 1;
        }
        if next == moves.len() && !finished {
            motion.finish();
            finished = true;
        }
        for (_, event) in events.iter().filter(|(t, _)| *t == tick) {
            match event {
                Event::Override(feed, rapid) => motion.set_override(*feed, *rapid),
                Event::Hold => motion.hold(),
                Event::Resume => motion.resume(),
                Event::Abort => {
                    motion.abort();
                    next = moves.len();
                    finished = true;
                    run.aborted = true;
                }
            }
        }
        let setpoint = motion.tick();
        run.samples.push(setpoint);
        let more_events = events.iter().any(|(t, _)| *t > tick);
        if setpoint.state == State::Idle && next == moves.len() && (finished || run.aborted) && !more_events {
            assert!(motion.is_empty() && motion.at_rest());
            assert_eq!(motion.position(), setpoint.position);
            return run;
        }
    }
    panic!("does not end: {:?}", run.samples.last());
}

pub fn run(machine: &Machine, start: Position, ops: &[Op]) -> Run {
    run_with(machine, start, ops, &[], &[])
}

impl Run {
    /// Time from the first to the last moment of motion, s.
    pub fn time(&self) -> f64 {
        let moving = |s: &Setpoint| s.velocity > 0.0;
        let first = self.samples.iter().position(moving).unwrap_or(0);
        let last = self.samples.iter().rposition(moving).unwrap_or(0);
        // The motion began one sample before the first that shows it and ended at the one after the last.
        (last + 2 - first) as f64 * self.period
    }

    fn is_rapid(&self, tag: u64) -> bool {
        matches!(self.ops.get(tag as usize), Some(Op::Rapid { .. }))
    }

    /// Velocity, acceleration and jerk of every axis by finite differences over one, two and three periods: means of
    /// the true derivative, which never overstate it.
    pub fn check_limits(&self, machine: &Machine) {
        let limits = Limits::new(machine);
        let t = self.period;
        let rest = Setpoint { position: self.start, velocity: 0.0, tag: 0, state: State::Idle };
        let end = *self.samples.last().unwrap();
        let all: Vec<Setpoint> =
            [rest, rest].into_iter().chain(self.samples.iter().copied()).chain([end, end, end]).collect();
        for (k, w) in all.windows(4).enumerate() {
            for i in 0..AXES {
                let [a, b, c] = [0, 1, 2].map(|j: usize| w[j].position.0[i]);
                let v = (c - b) / t;
                let rapid = self.is_rapid(w[1].tag) || self.is_rapid(w[2].tag);
                let top = if rapid { limits.rapid[i].max(limits.velocity[i]) } else { limits.velocity[i] };
                assert!(v.abs() <= top * 1.001 + 1e-9, "tick {k} axis {i}: velocity {v} above {top}: {w:?}");
                let acc = ((c - b) - (b - a)) / (t * t);
                let top = limits.acceleration[i];
                assert!(
                    acc.abs() <= top * 1.001 + 1e-6,
                    "tick {k} axis {i}: acceleration {acc} above {top}: {w:?}"
                );
                let d = w[3].position.0[i];
                let jerk = ((d - c) - 2.0 * (c - b) + (b - a)) / (t * t * t);
                // Positions of some hundred millimetres are known to 1e-13.
                let top = limits.jerk[i] * 1.001 + 8.0 * (1.0 + d.abs()) * 4e-16 / (t * t * t);
                assert!(jerk.abs() <= top, "tick {k} axis {i}: jerk {jerk} above {top}: {w:?}");
            }
        }
    }

    /// Speed over X, Y, Z within the programmed feed; for runs at 100 %.
    pub fn check_feed(&self) {
        let top = |tag: u64| match self.ops.get(tag as usize) {
            Some(Op::Feed { feed: Feed::PerMinute(f), .. }) => f / 60.0,
            Some(op @ Op::Arc { feed: Feed::PerMinute(f), feed_along, .. }) => {
                let arc = op.arc(self.from(tag as usize)).unwrap();
                let climb =
                    if *feed_along == FeedAlong::Circle { arc.length() / arc.plane_length() } else { 1.0 };
                f / 60.0 * climb
            }
            _ => f64::INFINITY,
        };
        for (k, w) in self.samples.windows(2).enumerate() {
            let v = {
                let d = (w[1].position - w[0].position).0;
                d[0].hypot(d[1]).hypot(d[2]) / self.period
            };
            // Moves that lie between two samples have feeds of their own.
            let allowed = (w[0].tag..=w[1].tag).map(top).fold(0.0, f64::max);
            assert!(v <= allowed * 1.0001 + 1e-9, "tick {k}: {v} mm/s above {allowed}: {w:?}");
        }
    }

    /// Where move `i` begins.
    pub fn from(&self, i: usize) -> Position {
        if i == 0 { self.start } else { *self.ops[i - 1].target().unwrap() }
    }

    /// Every sample lies within `tolerance` of the move it belongs to or one beside it.
    pub fn check_path(&self, tolerance: f64) {
        self.check_path_within(|_| tolerance);
    }

    /// The same by the tolerance of the move that each sample belongs to, by its number.
    pub fn check_path_within(&self, tolerance: impl Fn(usize) -> f64) {
        for (k, s) in self.samples.iter().enumerate() {
            let tag = s.tag as usize;
            let tolerance = tolerance(tag);
            let mut best = f64::INFINITY;
            // The joint may be with a move further on where moves between go nowhere, and where they are far shorter than the
            // tolerance not each has a mark of its own.
            for i in self.about(tag, tolerance) {
                best = best.min(distance(&self.ops[i], self.from(i), s.position));
                if best <= tolerance {
                    break;
                }
            }
            assert!(best <= tolerance, "tick {k}: {best} from the path: {s:?}");
        }
    }

    /// The moves beside this one: three on either side, and those on as much of the way as the tolerance is.
    fn about(&self, tag: usize, tolerance: f64) -> std::ops::Range<usize> {
        let length = |i: usize| self.ops[i].length(self.from(i));
        let (mut first, mut last) = (tag.saturating_sub(3), (tag + 4).min(self.ops.len()));
        let mut way = 0.0;
        while first > 0 && way < tolerance {
            first -= 1;
            way += length(first);
        }
        way = 0.0;
        while last < self.ops.len() && way < tolerance {
            way += length(last);
            last += 1;
        }
        first..last
    }

    /// Every move is gone through: its points lie within the tolerance of its number of the way between the samples. What
    /// the axes can bend it by between two of them, `acceleration` in mm/s², is no fault.
    pub fn check_reach_within(&self, acceleration: f64, tolerance: impl Fn(usize) -> f64) {
        let sagitta = acceleration * self.period * self.period / 8.0;
        for (i, op) in self.ops.iter().enumerate() {
            let (from, to) = (self.from(i), *op.target().unwrap());
            if op.length(from) < 1e-5 {
                continue;
            }
            let most = tolerance(i).max(tolerance(i + 1)) + sagitta;
            // Short moves lie between two samples, and those shorter than the tolerance beside others of it.
            let reach = |moves: &mut dyn Iterator<Item = usize>| {
                let mut length = 0.0;
                let is_near = |n: &usize| {
                    let is_near = length < 2.0 * most;
                    length += self.ops[*n].length(self.from(*n));
                    is_near
                };
                moves.take_while(is_near).count()
            };
            let before = reach(&mut (0..i).rev()).max(3);
            let behind = reach(&mut (i + 1..self.ops.len())).max(4);
            let tags = i.saturating_sub(before) as u64..=(i + behind) as u64;
            let first = self.samples.partition_point(|s| s.tag < *tags.start()).saturating_sub(2);
            let last = (self.samples.partition_point(|s| s.tag <= *tags.end()) + 2).min(self.samples.len());
            for t in [0.25, 0.5, 0.75, 1.0] {
                let point = op.arc(from).map_or_else(|| from + scaled(to - from, t), |arc| arc.at(t));
                let off = |w: &[Setpoint]| {
                    let (a, d) = (w[0].position, w[1].position - w[0].position);
                    let square: f64 = d.0.iter().map(|c| c * c).sum();
                    let along: f64 = (point - a).0.iter().zip(d.0).map(|(p, c)| p * c).sum();
                    let share = if square > 0.0 { (along / square).clamp(0.0, 1.0) } else { 0.0 };
                    norm(point - a - scaled(d, share))
                };
                let off = self.samples[first..last].windows(2).map(off).fold(f64::INFINITY, f64::min);
                let is_apart = matches!(op, Op::Rapid { straight: false, .. }) && t < 1.0;
                assert!(
                    is_apart || off <= most,
                    "move {i} at {t}: {off} mm from the way of the axes, {most} allowed"
                );
            }
        }
    }

    /// Whether one setpoint is exactly this point.
    pub fn rests_on(&self, p: Position) -> bool {
        self.samples.iter().any(|s| s.position == p && s.velocity == 0.0)
    }

    /// Whether the motion stands still between its start and its end.
    pub fn stops_inside(&self) -> bool {
        let moving = |s: &Setpoint| s.velocity > 0.0;
        let first = self.samples.iter().position(moving).unwrap();
        let last = self.samples.iter().rposition(moving).unwrap();
        self.samples[first..=last].iter().any(|s| s.velocity == 0.0)
    }
}

fn scaled(p: Position, by: f64) -> Position {
    Position(p.0.map(|c| c * by))
}

fn norm(p: Position) -> f64 {
    p.0.iter().map(|c| c * c).sum::<f64>().sqrt()
}

/// Distance of `p` from the programmed move, over all axes.
pub fn distance(op: &Op, from: Position, p: Position) -> f64 {
    let to = *op.target().unwrap();
    if let Op::Rapid { straight: false, .. } = op {
        // Inside the box of the move.
        return norm(
            p.zip(from.max(to), |p, m| (p - m).max(0.0)) + from.min(to).zip(p, |m, p| (m - p).max(0.0)),
        );
    }
    if let Some(arc) = op.arc(from) {
        return arc_distance(&arc, p);
    }
    let d = to - from;
    let square: f64 = d.0.iter().map(|c| c * c).sum();
    let along: f64 = d.0.iter().zip((p - from).0).map(|(a, b)| a * b).sum();
    let t = if square > 0.0 { (along / square).clamp(0.0, 1.0) } else { 0.0 };
    norm(p - from.lerp(to, t))
}

fn arc_distance(arc: &Arc, p: Position) -> f64 {
    let steps = (arc.sweep.abs() * 8.0).ceil().max(8.0) as usize;
    let f = |t: f64| norm(p - arc.at(t));
    let at = |k: usize| f(k as f64 / steps as f64);
    let mut nearest = f64::INFINITY;
    for k in 0..=steps {
        let valley = at(k) <= at(k.saturating_sub(1)) && at(k) <= at((k + 1).min(steps));
        if !valley {
            continue;
        }
        let (mut low, mut high) =
            (k.saturating_sub(1) as f64 / steps as f64, (k + 1).min(steps) as f64 / steps as f64);
        for _ in 0..60 {
            let (a, b) = (low + (high - low) * 0.382, low + (high - low) * 0.618);
            if f(a) < f(b) { high = b } else { low = a }
        }
        nearest = nearest.min(f((low + high) / 2.0)).min(at(k));
    }
    nearest
}
