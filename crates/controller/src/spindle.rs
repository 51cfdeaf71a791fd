//! The simulated spindle: runs up and brakes at a constant rate, has an encoder, and follows angles as its drive does.
//!
//! On a machine whose file describes a plant the position loop of the drive lags: it commands the speed
//! `Kv·(c − x) + F·c'`, so that the lag `e = c − x` obeys `e' = (1 − F)·c' − Kv·e`. While the command goes straight through
//! a period of `T` it comes nearer to `(1 − F)·c'/Kv` by `1 − exp(−Kv·T)`.

use crate::drives::plant::kept;
use ferrocut_geometry::Position;
use ferrocut_machine::{Machine, PlantConfig};
use ferrocut_toolpath::SpindleState;

/// What the encoder of a spindle says.
#[derive(Clone, Copy, PartialEq, Debug)]
pub struct Encoder {
    /// Angle since power-on in whole counts, turns; clockwise positive.
    pub turns: f64,
    /// The marker was passed in the last period, once a turn.
    pub marker: bool,
}

/// The position loop of a drive that is not ideal.
#[derive(Clone, Copy, Debug)]
struct Following {
    /// Part of the lag that a period leaves of what it is above the steady one.
    kept: f64,
    /// The steady lag at a speed of a turn a period, turns.
    steady: f64,
    /// Angle commanded last, turns.
    command: f64,
}

/// A spindle with its speed and angle.
#[derive(Clone, Copy, Debug)]
pub struct Spindle {
    /// Speed that was asked for, r/min; clockwise positive.
    asked: f64,
    /// What that is multiplied by.
    factor: f64,
    /// Speed that it was told, r/min; clockwise positive.
    told: f64,
    /// Speed that it has, r/min.
    speed: f64,
    /// turns.
    angle: f64,
    /// Angle at which it is to come to rest, parts of a turn.
    rest_at: Option<f64>,
    /// Whether the last period passed the marker.
    marker: bool,
    rate: f64,
    max: f64,
    counts: f64,
    following: Option<Following>,
}

impl Following {
    fn new(plant: &PlantConfig, period_ms: f64) -> Option<Following> {
        let (gain, period) = (plant.spindle_gain, period_ms / 1000.0);
        (gain > 0.0).then(|| Following {
            kept: kept(gain, period),
            steady: (1.0 - plant.spindle_feed_forward) / (gain * period),
            command: 0.0,
        })
    }
}

impl Spindle {
    /// The spindle of a machine, at rest.
    pub fn new(machine: &Machine) -> Spindle {
        Spindle {
            asked: 0.0,
            factor: 1.0,
            told: 0.0,
            speed: 0.0,
            angle: 0.0,
            rest_at: None,
            marker: false,
            rate: machine.spindle.acceleration_rpm_s,
            max: machine.spindle.max_rpm,
            counts: machine.spindle.encoder_counts,
            following: machine
                .plant
                .as_ref()
                .and_then(|plant| Following::new(plant, machine.servo_period_ms)),
        }
    }

    /// Another gear is engaged, in which the encoder has so many counts in a turn of the spindle.
    pub fn set_encoder(&mut self, counts: f64) {
        self.counts = counts.max(1.0);
    }

    /// Speed without its sense, r/min.
    pub fn rpm(&self) -> f64 {
        self.told.abs()
    }

    /// Speed that it has, r/min; clockwise positive.
    pub fn actual_rpm(&self) -> f64 {
        self.speed
    }

    /// Whether it has the speed that it was told.
    pub fn has_its_speed(&self) -> bool {
        self.speed == self.told
    }

    /// Whether it stands at the angle that it was to come to.
    pub fn is_oriented(&self) -> bool {
        self.told == 0.0 && self.speed == 0.0 && self.rest_at.is_none()
    }

    /// What its encoder says.
    pub fn encoder(&self) -> Encoder {
        Encoder { turns: (self.angle * self.counts).floor() / self.counts, marker: self.marker }
    }

    /// Commands a state with the axes at `at`; the time until it is reached, s. A surface speed is
    /// turned into the speed that it means there.
    pub fn command(&mut self, state: SpindleState, at: &Position) -> f64 {
        let rpm = state.speed().map_or(0.0, |speed| speed.rpm(at));
        self.tell(if matches!(state, SpindleState::CounterClockwise(_)) { -rpm } else { rpm })
    }

    /// What speeds are multiplied by that are asked for, the one in force too. One that follows angles has none.
    pub fn set_override(&mut self, factor: f64) {
        if self.factor != factor {
            self.factor = factor;
            if self.asked != 0.0 {
                self.tell(self.asked);
            }
        }
    }

    /// Speed that was asked for, without the override, r/min; clockwise positive.
    pub fn asked(&self) -> f64 {
        self.asked
    }

    /// Speed that it was told, r/min; clockwise positive.
    pub fn told(&self) -> f64 {
        self.told
    }

    /// Asks it for a speed, r/min, clockwise positive; the time until it has it, s.
    pub fn tell(&mut self, rpm: f64) -> f64 {
        self.asked = rpm;
        let target = (rpm * self.factor).clamp(-self.max, self.max);
        let change = (target - self.told).abs();
        self.told = target;
        self.rest_at = None;
        change / self.rate
    }

    /// Brings it to rest at an angle from the marker, degrees; the time until then, s. A spindle at rest turns on
    /// to the angle, with half of the way to run up and half to brake.
    pub fn orient(&mut self, degrees: f64) -> f64 {
        let seconds = self.command(SpindleState::Off, &Position::ZERO);
        let part = (degrees / 360.0).rem_euclid(1.0);
        if !part.is_finite() {
            return seconds;
        }
        self.rest_at = Some(part);
        if seconds > 0.0 { seconds } else { 2.0 * (self.way_to(part) * 60.0 / self.rate).sqrt() }
    }

    /// Whether it stands at its marker.
    pub fn is_at_marker(&self) -> bool {
        let way = self.way_to(0.0);
        self.told == 0.0 && way.min(1.0 - way) <= 1.0 / self.counts
    }

    /// How far it is on to an angle, in parts of a turn from 0 to 1.
    fn way_to(&self, part: f64) -> f64 {
        (part - self.angle).rem_euclid(1.0)
    }

    /// Goes on by a period of `seconds`, turning at a speed.
    pub fn tick(&mut self, seconds: f64) {
        let before = self.speed;
        let most = self.rate * seconds;
        let left = self.told - before;
        self.speed = if left.abs() <= most { self.told } else { before + most.copysign(left) };
        let mut angle = self.angle + (before + self.speed) / 120.0 * seconds;
        if self.speed == 0.0
            && let Some(part) = self.rest_at.take()
        {
            // On to the angle; a spindle that is there but for a rounding stays.
            let on = angle.floor() + part;
            let least = 1.0 / self.counts;
            angle = if on >= angle - least { on } else { on + 1.0 };
        }
        self.turn_to(angle);
        if let Some(following) = &mut self.following {
            following.command = angle;
        }
    }

    /// Follows a commanded angle for a period, turns, as an axis does.
    pub fn follow(&mut self, angle: f64) {
        (self.asked, self.told, self.speed, self.rest_at) = (0.0, 0.0, 0.0, None);
        let lag = self.following.as_mut().map_or(0.0, |following| {
            let steady = following.steady * (angle - following.command);
            let lag = following.command - self.angle;
            following.command = angle;
            steady + (lag - steady) * following.kept
        });
        self.turn_to(angle - lag);
    }

    fn turn_to(&mut self, angle: f64) {
        self.marker = angle.floor() != self.angle.floor();
        self.angle = angle;
    }

    /// The angle, turns.
    pub fn angle(&self) -> f64 {
        self.angle
    }
}

#[cfg(test)]
mod tests {
    use super::*;
    use ferrocut_toolpath::Speed;

    #[test]
    fn its_drive_lags_as_the_gain_says_and_comes_to_its_angle() {
        let plant = PlantConfig { spindle_gain: 40.0, spindle_feed_forward: 0.9, ..PlantConfig::default() };
        let mut spindle = Spindle::new(&Machine { plant: Some(plant), ..Machine::demo_mill() });
        // 10 turns a second: a tenth of them in 1/40 s is 0.025 turns behind.
        for k in 1..=1000 {
            spindle.follow(f64::from(k) * 0.01);
            let after = 1.0 - (-0.04 * f64::from(k)).exp();
            assert!((f64::from(k) * 0.01 - spindle.angle() - 0.025 * after).abs() < 1e-9, "{k}");
        }
        (0..1000).for_each(|_| spindle.follow(10.0));
        assert!((spindle.angle() - 10.0).abs() < 1e-12);
    }

    #[test]
    fn the_encoder_counts_turns_and_passes_its_marker_once_in_each() {
        let mut spindle = Spindle::new(&Machine::demo_mill());
        // 600 r/min at 4000 r/min per second: 0.15 s and 0.75 turns, then 10 turns a second.
        let seconds = spindle.command(SpindleState::Clockwise(Speed::Rpm(600.0)), &Position::ZERO);
        assert!((seconds - 0.15).abs() < 1e-12);
        let mut markers = 0;
        for k in 1..=1150 {
            spindle.tick(0.001);
            markers += u32::from(spindle.encoder().marker);
            let counts = spindle.encoder().turns * 4096.0;
            assert!(counts == counts.round() && spindle.angle() - spindle.encoder().turns < 1.0 / 4096.0);
            if k == 150 {
                assert!((spindle.angle() - 0.75).abs() < 1e-9, "{}", spindle.angle());
            }
        }
        assert!((spindle.angle() - 10.75).abs() < 1e-9 && markers == 10);
        spindle.orient(90.0);
        for _ in 0..200 {
            spindle.tick(0.001);
        }
        assert!((spindle.angle().fract() - 0.25).abs() < 1e-12 && spindle.rpm() == 0.0);
    }
}
