//! The electronic gear: axes that follow the angle of the spindle, as in rigid tapping and threading.
//!
//! In: a thread to cut ([`Thread`]), and every period what the encoder of the spindle says. Out: every period the
//! angle that the spindle is commanded, and where the axes shall be.
//!
//! ```text
//! axis = start + pitch · turns of the spindle since the start
//! ```
//!
//! holds at every moment, while the spindle runs up, while it brakes, and through its reversal. So the spindle is
//! moved like an axis: from rest to rest over the turns of the thread, within what its own acceleration and
//! the limits of every axis, divided by the pitch, allow (`stroke.rs`). It comes to rest exactly at depth,
//! and turns back in a stroke of its own. Overrides and feed hold have no say in it (GSK990MC 4.5.1).
//!
//! The axes follow what is **measured**. An encoder counts, and steps of a count are steps of acceleration to
//! an axis; so what the encoder says beyond the commanded angle is let through where it is more than a count and a
//! half, and spread over `3h` seconds by three means. `h` is 6 ms, or as much more
//! that counts take a tenth of the acceleration and jerk of every axis. With `e` the lag of the spindle behind its command, the axes are beside the measured angle by
//!
//! ```text
//! pitch · (1.5 counts + 1.5·h·|de/dt|)  at most.
//! ```

use crate::limits::Limits;
use crate::servo::average::Average;
use crate::stroke::{RampLimits, Stroke};
use ferrocut_geometry::Position;
use ferrocut_machine::Machine;

/// Parts of velocity, acceleration and jerk of the axes that a stroke is planned with. A tenth is that of counts,
/// the rest is for making up the spindle's lag, which comes late by the means: with a lag of the time `τ` it is
/// `1.5·τ/h` of the planned jerk, and where the lag grows above a count and a half, another sixth of the limit.
const VELOCITY_SHARE: f64 = 0.99;
const ACCELERATION_SHARE: f64 = 0.8;
const JERK_SHARE: f64 = 0.5;
const COUNT_SHARE: f64 = 0.1;

/// Shortest `h`, s: three times the lag of a spindle in position control, 2 ms.
const SHORTEST_MEAN: f64 = 0.006;

/// Counts by which the encoder may differ from the commanded angle at rest: one that counts down to whole ones
/// is behind by one, and by what the angle is rounded.
const NO_ERROR: f64 = 1.5;

/// Longest `h`, s: that of a coarse encoder and a large pitch.
const LONGEST_MEAN: f64 = 0.05;

/// More turns than any thread has.
const MOST_TURNS: f64 = 1e7;

/// One stroke of a thread.
#[derive(Clone, Copy, PartialEq, Debug)]
pub struct Thread {
    /// Where it ends, mm and degrees.
    pub to: Position,
    /// Travel a revolution, mm, without sign.
    pub pitch: f64,
    /// Speed of the spindle, r/min.
    pub rpm: f64,
    /// Whether the spindle turns clockwise.
    pub is_clockwise: bool,
    /// Highest acceleration of the spindle, r/min per second.
    pub acceleration_rpm_s: f64,
    /// Counts of its encoder in a turn of it, in the gear that is engaged.
    pub encoder_counts: f64,
}

/// The gear.
#[derive(Debug)]
pub struct Synchron {
    limits: Limits,
    period: f64,
    /// Counts of the encoder in a turn.
    counts: f64,
    from: Position,
    /// Where the stroke ends; none where it was stopped.
    to: Option<Position>,
    /// Travel a turn.
    per_turn: Position,
    /// mm a turn along the path.
    pitch: f64,
    /// 1 clockwise, −1 not.
    sense: f64,
    /// Angle of the spindle at the start, turns.
    angle: f64,
    gear_limits: RampLimits,
    stroke: Stroke,
    time: f64,
    /// What the encoder says beyond the commanded angle, less what is no error, turns.
    beyond: f64,
    means: [(Average, f64); 3],
    position: Position,
    turned: f64,
    speed: f64,
}

impl Synchron {
    /// The gear of a machine at rest at `at`. All memory is taken here.
    pub fn new(machine: &Machine, at: Position) -> Synchron {
        let period = machine.servo_period_ms / 1000.0;
        let longest = (LONGEST_MEAN / period).ceil();
        let mean = || (Average::with_capacity(longest), 0.0);
        Synchron {
            limits: Limits::new(machine),
            period,
            counts: machine.spindle.encoder_counts.max(1.0),
            from: at,
            to: Some(at),
            per_turn: Position::ZERO,
            pitch: 0.0,
            sense: 1.0,
            angle: 0.0,
            gear_limits: RampLimits { velocity: 0.0, acceleration: 1.0, jerk: f64::INFINITY },
            stroke: Stroke::default(),
            time: 0.0,
            beyond: 0.0,
            means: [mean(), mean(), mean()],
            position: at,
            turned: 0.0,
            speed: 0.0,
        }
    }

    /// Begins a stroke at `from`, the spindle at rest at `angle` turns. `false` if it is none: without pitch,
    /// speed or way.
    pub fn begin(&mut self, from: Position, angle: f64, thread: &Thread) -> bool {
        let turns = from.distance(thread.to) / thread.pitch;
        let is_thread =
            turns > 0.0 && turns < MOST_TURNS && thread.rpm > 0.0 && thread.acceleration_rpm_s > 0.0;
        self.counts = thread.encoder_counts.max(1.0);
        if !is_thread || !thread.pitch.is_finite() || !angle.is_finite() {
            return false;
        }
        let per_turn = from.zip(thread.to, |a, b| (b - a) / turns);
        // The limits of the axes in turns.
        let of_axes = |limits: &[f64]| {
            let axes = per_turn.0.iter().zip(limits).filter(|(d, _)| **d != 0.0);
            axes.fold(f64::INFINITY, |least: f64, (d, limit)| least.min(limit / d.abs()))
        };
        let acceleration = of_axes(&self.limits.acceleration);
        let jerk = of_axes(&self.limits.jerk);
        self.gear_limits = RampLimits {
            velocity: (thread.rpm / 60.0).min(of_axes(&self.limits.velocity) * VELOCITY_SHARE),
            acceleration: (thread.acceleration_rpm_s / 60.0).min(acceleration * ACCELERATION_SHARE),
            jerk: jerk * JERK_SHARE,
        };
        self.stroke = Stroke::rest_to_rest(turns, &self.gear_limits);
        let count = self.counts.recip();
        let h = (2.0 * count / (acceleration * COUNT_SHARE))
            .sqrt()
            .max((4.0 * count / (jerk * COUNT_SHARE)).cbrt())
            .clamp(SHORTEST_MEAN, LONGEST_MEAN);
        for (mean, lag) in &mut self.means {
            mean.set_window((h / self.period).ceil());
            *lag = 0.0;
        }
        (self.from, self.to, self.position) = (from, Some(thread.to), from);
        (self.per_turn, self.pitch) = (per_turn, thread.pitch);
        (self.angle, self.sense) = (angle, if thread.is_clockwise { 1.0 } else { -1.0 });
        (self.time, self.beyond, self.turned, self.speed) = (0.0, 0.0, 0.0, 0.0);
        true
    }

    /// Goes on by a period: the angle that the spindle shall have at its end, turns.
    pub fn advance(&mut self) -> f64 {
        self.time += self.period;
        self.angle + self.sense * self.stroke.at(self.time).s
    }

    /// Where the axes shall be, now that the encoder says `measured` turns.
    pub fn follow(&mut self, measured: f64) -> Position {
        let planned = self.stroke.at(self.time);
        let error = (measured - self.angle) * self.sense - planned.s;
        let least = NO_ERROR / self.counts;
        let beyond = if error.abs() > least { error - least.copysign(error) } else { 0.0 };
        let mut moved = beyond - self.beyond;
        self.beyond = beyond;
        let mut turned = planned.s + beyond;
        for (mean, lag) in &mut self.means {
            let grown = mean.push(moved) - *lag;
            *lag += grown;
            moved -= grown;
            turned -= *lag;
        }
        self.speed = (turned - self.turned).abs() * self.pitch / self.period;
        self.turned = turned;
        self.position = match self.to {
            Some(to) if self.is_done() => to,
            _ => self.from.zip(self.per_turn, |from, d| from + d * turned),
        };
        self.position
    }

    /// Both come to rest as soon as the limits allow, in step.
    pub fn stop(&mut self) {
        if self.to.is_some() {
            let end = self.stroke.at(f64::INFINITY).s;
            self.stroke = Stroke::stop(self.stroke.at(self.time), end, &self.gear_limits);
            (self.time, self.to) = (0.0, None);
        }
    }

    /// Whether the spindle has come to rest, and the axes with it.
    pub fn is_done(&self) -> bool {
        self.time >= self.stroke.duration()
            && self.beyond == 0.0
            && self.means.iter().all(|(mean, _)| mean.is_at_rest())
    }

    /// For how long the spindle should have been at rest by now, s.
    pub fn overdue(&self) -> f64 {
        (self.time - self.stroke.duration()).max(0.0)
    }

    /// Where the axes are commanded to be.
    pub fn position(&self) -> Position {
        self.position
    }

    /// Speed along the path, mm/s.
    pub fn speed(&self) -> f64 {
        self.speed
    }

    /// How far the axes may be beside the measured angle while the lag of the spindle changes by `rate` turns/s,
    /// mm along the path.
    pub fn error_bound(&self, rate: f64) -> f64 {
        let window =
            self.means.iter().map(|(mean, _)| (mean.window() - 1.0) / 2.0 * self.period).sum::<f64>();
        self.pitch * (NO_ERROR / self.counts + window * rate)
    }
}
