//! Positioning with every axis on its own: each from rest to rest in its shortest time.

use crate::limits::{Drive, Ramps};
use crate::timing::ramp::{Foot, Phases, distance, summit};
use ferrocut_geometry::{AXES, Position};

/// Speed, acceleration and jerk of an axis that the machine file does not limit.
const UNLIMITED: [f64; 3] = [1e6, 1e6, 1e9];

/// A piece of the motion of one axis over its distance.
#[derive(Clone, Copy, Debug)]
enum Leg {
    Ramp { foot: Foot, v: f64, drive: Drive, is_down: bool },
    Steady { v: f64, time: f64 },
}

/// Length, speed and acceleration within a motion.
#[derive(Clone, Copy, Debug)]
struct State {
    s: f64,
    v: f64,
    a: f64,
}

impl Leg {
    fn time(&self) -> f64 {
        match *self {
            Leg::Ramp { foot, v, drive, .. } => Phases::new(foot, v, drive).total(),
            Leg::Steady { time, .. } => time,
        }
    }

    /// Way from its start, speed and acceleration after `t`.
    fn at(&self, t: f64) -> State {
        match *self {
            Leg::Steady { v, .. } => State { s: v * t, v, a: 0.0 },
            Leg::Ramp { foot, v, drive, is_down: false } => {
                let (s, v, a) = Phases::new(foot, v, drive).at(foot, t);
                State { s, v, a }
            }
            Leg::Ramp { foot, v, drive, is_down: true } => {
                let phases = Phases::new(foot, v, drive);
                let total = phases.total();
                let (whole, ..) = phases.at(foot, total);
                let (s, v, a) = phases.at(foot, (total - t).max(0.0));
                State { s: whole - s, v, a: -a }
            }
        }
    }
}

/// The most legs a motion has: taking the acceleration back, to the new speed, steady, and to rest.
const LEGS: usize = 4;

/// The motion of one axis.
#[derive(Clone, Copy, Debug)]
struct Single {
    legs: [Option<Leg>; LEGS],
    current: usize,
    t: f64,
    /// Way up to the current leg, mm.
    done: f64,
    drive: Drive,
}

impl Single {
    const NONE: Single = Single { legs: [None; LEGS], current: 0, t: 0.0, done: 0.0, drive: Drive::MOST };

    /// From the steady speed `v` over `len` to rest, not faster than `top`.
    fn legs(v: f64, len: f64, top: f64, drive: Drive) -> [Option<Leg>; 3] {
        let rest = Foot::default();
        if top < v {
            let slow = distance(top, v, drive);
            let left = len - slow - distance(0.0, top, drive);
            if left >= 0.0 {
                return [
                    Some(Leg::Ramp { foot: Foot::still(top), v, drive, is_down: true }),
                    Some(Leg::Steady { v: top, time: left / top }),
                    Some(Leg::Ramp { foot: rest, v: top, drive, is_down: true }),
                ];
            }
        }
        let peak = summit(Foot::still(v), rest, len, v, top.max(v), drive).unwrap_or(v);
        let left = (len - distance(v, peak, drive) - distance(0.0, peak, drive)).max(0.0);
        [
            Some(Leg::Ramp { foot: Foot::still(v), v: peak, drive, is_down: false }),
            (peak > 0.0).then_some(Leg::Steady { v: peak, time: left / peak }),
            Some(Leg::Ramp { foot: rest, v: peak, drive, is_down: true }),
        ]
    }

    fn state(&self) -> State {
        match self.legs.get(self.current).copied().flatten() {
            Some(leg) => {
                let state = leg.at(self.t);
                State { s: self.done + state.s, ..state }
            }
            None => State { s: self.done, v: 0.0, a: 0.0 },
        }
    }

    /// Goes on by `time`. Whether it is still under way.
    fn advance(&mut self, time: f64) -> bool {
        self.t += time;
        while self.current < LEGS {
            if let Some(leg) = self.legs[self.current] {
                let whole = leg.time();
                if self.t < whole {
                    return true;
                }
                self.t -= whole;
                self.done += leg.at(whole).s;
            }
            self.current += 1;
        }
        false
    }

    /// Takes the acceleration back where it goes up; then `then` from the steady speed. A ramp down is run to its end.
    fn renew(&mut self, then: impl Fn(f64, f64) -> [Option<Leg>; 3]) {
        let state = self.state();
        let (first, v, s) = match self.legs.get(self.current).copied().flatten() {
            None => return,
            Some(leg @ Leg::Ramp { foot, is_down: true, .. }) => {
                // It is run to its end.
                if foot.v > 0.0 {
                    let [a, b, c] = then(foot.v, self.done + leg.at(leg.time()).s);
                    *self = Single { legs: [Some(leg), a, b, c], current: 0, ..*self };
                }
                return;
            }
            Some(Leg::Steady { v, .. }) => (None, v, state.s),
            Some(Leg::Ramp { drive, .. }) => {
                let foot = Foot { v: state.v, a: state.a.max(0.0) };
                let leg = Leg::Ramp { foot, v: foot.top(drive.j), drive, is_down: false };
                (Some(leg), foot.top(drive.j), state.s + leg.at(leg.time()).s)
            }
        };
        let [a, b, c] = then(v, s);
        let current = usize::from(first.is_none());
        *self = Single { legs: [first, a, b, c], current, t: 0.0, done: state.s, drive: self.drive };
    }
}

/// A move of every axis on its own.
#[derive(Clone, Copy, Debug)]
pub(crate) struct AxesRun {
    from: Position,
    to: Position,
    singles: [Single; AXES],
    under_way: bool,
    stopped: bool,
}

impl AxesRun {
    pub const NONE: AxesRun = AxesRun {
        from: Position::ZERO,
        to: Position::ZERO,
        singles: [Single::NONE; AXES],
        under_way: false,
        stopped: false,
    };

    /// Begins at rest at `from`; `speeds` are the highest of the axes, mm/s or degrees/s.
    pub fn begin(&mut self, from: Position, to: Position, ramps: &Ramps, speeds: &[f64; AXES]) {
        *self = AxesRun { from, to, under_way: true, ..AxesRun::NONE };
        for (i, speed) in speeds.iter().enumerate() {
            let len = (to.0[i] - from.0[i]).abs();
            let drive =
                Drive { a: ramps.acceleration[i].min(UNLIMITED[1]), j: ramps.jerk[i].min(UNLIMITED[2]) };
            let [a, b, c] = Single::legs(0.0, len, speed.min(UNLIMITED[0]), drive);
            let legs = if len > 0.0 { [a, b, c, None] } else { [None; LEGS] };
            self.singles[i] = Single { legs, drive, ..Single::NONE };
        }
    }

    /// Where it ends unless it is stopped.
    pub fn to(&self) -> Position {
        self.to
    }

    /// Whether it has begun and not ended.
    pub fn is_under_way(&self) -> bool {
        self.under_way
    }

    /// Another rapid override: other highest speeds of the axes, mm/s or degrees/s.
    pub fn set_speeds(&mut self, speeds: &[f64; AXES]) {
        if self.stopped {
            return;
        }
        for (i, speed) in speeds.iter().enumerate() {
            let len = (self.to.0[i] - self.from.0[i]).abs();
            let single = &mut self.singles[i];
            let (top, drive) = (speed.min(UNLIMITED[0]), single.drive);
            single.renew(|v, s| Single::legs(v, len - s, top, drive));
        }
    }

    /// Every axis comes to rest.
    pub fn stop(&mut self) {
        if self.stopped {
            return;
        }
        self.stopped = true;
        for single in &mut self.singles {
            let drive = single.drive;
            single.renew(|v, _| {
                [Some(Leg::Ramp { foot: Foot::default(), v, drive, is_down: true }), None, None]
            });
        }
    }

    /// Goes on by `time`; position and speed then. The move is over when all axes stand, on its end or stopped.
    pub fn advance(&mut self, time: f64) -> (Position, f64) {
        let mut under_way = false;
        let mut position = self.to;
        let mut squares = 0.0;
        for (i, single) in self.singles.iter_mut().enumerate() {
            let moves = single.advance(time);
            under_way |= moves;
            let way = self.to.0[i] - self.from.0[i];
            let state = single.state();
            // An axis whose last ramp ends short of its end was stopped.
            if moves || (self.stopped && state.s < way.abs() - 1e-9) {
                position.0[i] = self.from.0[i] + state.s.min(way.abs()).copysign(way);
            }
            squares += state.v * state.v;
        }
        self.under_way = under_way;
        (position, if under_way { squares.sqrt() } else { 0.0 })
    }
}
