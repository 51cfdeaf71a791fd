//! Axes moved by hand: which speed a key stands for, and who has the axes (GSK990MC part 2, 4.1, 5.1, 6.1).
//!
//! The manual's control moves one axis at a time; here any number may move at once. Steps and the handwheel do
//! not follow the overrides (5.1.3).

use ferrocut_geometry::{AXES, Axis, Position};
use ferrocut_machine::Machine;
use ferrocut_machine::manual::ManualConfig;
use ferrocut_motion::Jog;
use ferrocut_motion::jog::{Surplus, Travel};
use ferrocut_motion::servo::Kind;

/// Which way a jog key leads.
#[derive(Clone, Copy, PartialEq, Eq, Debug)]
pub enum JogWay {
    /// Upwards.
    Plus,
    /// Downwards.
    Minus,
    /// Nowhere: the key is released.
    Stop,
}

/// How fast a jog key leads there.
#[derive(Clone, Copy, PartialEq, Debug)]
pub enum JogSpeed {
    /// The jog feed, under the feed override.
    Feed,
    /// The manual rapid speed, under the rapid override.
    Rapid,
    /// This speed, mm/min or degrees/min, under the feed override.
    Of(f64),
}

/// Speeds of an axis, mm/s.
#[derive(Clone, Copy, Debug, Default)]
struct Speeds {
    velocity: f64,
    /// With the rapid key.
    rapid: f64,
    /// As the program positions.
    positioning: f64,
    /// Software limits, mm.
    travel: Travel,
    /// Whether the rapid key is dead: before homing, where a parameter says so (GSK990MC 12#0).
    no_rapid: bool,
    /// Whether the software limits hold.
    holds: bool,
}

/// Axes moved by hand.
#[derive(Clone, Debug)]
pub(crate) struct Manual {
    jog: Jog,
    config: ManualConfig,
    speeds: [Speeds; AXES],
    /// The keys that are held.
    held: [Option<(JogWay, JogSpeed)>; AXES],
    feed: f64,
    rapid: f64,
    /// The handwheel was what moved an axis last.
    by_wheel: bool,
    /// Whether it has the axes.
    pub is_active: bool,
}

impl Manual {
    pub fn new(machine: &Machine, start: Position) -> Manual {
        let mut speeds = [Speeds::default(); AXES];
        for axis in &machine.axes {
            if let Some(place) = speeds.get_mut(axis.name.index()) {
                let rapid = axis.manual_rapid.unwrap_or(axis.rapid).min(axis.rapid);
                *place = Speeds {
                    velocity: axis.velocity / 60.0,
                    rapid: rapid / 60.0,
                    positioning: axis.rapid / 60.0,
                    travel: (axis.min, axis.max),
                    no_rapid: false,
                    holds: true,
                };
            }
        }
        Manual {
            jog: Jog::new(machine, start),
            config: machine.manual.clone(),
            speeds,
            held: [None; AXES],
            feed: 1.0,
            rapid: 1.0,
            by_wheel: false,
            is_active: false,
        }
    }

    /// Takes the axes, which stand at `at`, unless it has them.
    pub fn take(&mut self, at: Position) {
        if !self.is_active {
            self.is_active = true;
            self.jog.rename(at);
        }
    }

    /// A jog key.
    pub fn jog(&mut self, axis: Axis, way: JogWay, speed: JogSpeed) {
        if let Some(held) = self.held.get_mut(axis.index()) {
            *held = (way != JogWay::Stop).then_some((way, speed));
        }
        self.run(axis, way, speed);
    }

    fn run(&mut self, axis: Axis, way: JogWay, speed: JogSpeed) {
        self.moves_by(false);
        let Speeds { velocity, rapid, no_rapid, .. } = self.of(axis);
        let speed = match speed {
            JogSpeed::Rapid if no_rapid => (self.config.jog / 60.0 * self.feed).min(velocity),
            JogSpeed::Feed => (self.config.jog / 60.0 * self.feed).min(velocity),
            JogSpeed::Of(speed) => (speed.abs() / 60.0 * self.feed).min(velocity),
            JogSpeed::Rapid => self.under_rapid_override(rapid),
        };
        self.jog.run(
            axis,
            match way {
                JogWay::Plus => speed,
                JogWay::Minus => -speed,
                JogWay::Stop => 0.0,
            },
        );
    }

    /// The overrides in force.
    pub fn overrides(&self) -> (f64, f64) {
        (self.feed, self.rapid)
    }

    /// Feed override 0 to 2 and rapid override 0 to 1; keys that are held follow.
    pub fn set_override(&mut self, feed: f64, rapid: f64) {
        let within = |value: f64, most: f64| if value.is_nan() { 0.0 } else { value.clamp(0.0, most) };
        self.feed = within(feed, ferrocut_motion::MAX_FEED_OVERRIDE);
        self.rapid = within(rapid, 1.0);
        for (axis, held) in Axis::ALL.into_iter().zip(self.held) {
            if let Some((way, speed)) = held {
                self.run(axis, way, speed);
            }
        }
    }

    /// Steps of an increment, mm or degrees.
    pub fn step(&mut self, axis: Axis, steps: i64, increment: f64) {
        let speed = (self.config.step / 60.0).min(self.of(axis).velocity);
        self.let_go(axis);
        self.moves_by(false);
        self.jog.step(axis, steps, increment, speed);
    }

    /// Counts of the handwheel as the axis follows them: the other way round where a parameter says so.
    pub fn way_of_wheel(&self, counts: i64) -> i64 {
        if self.config.handwheel_reversed { counts.saturating_neg() } else { counts }
    }

    /// Counts of the handwheel as the axis follows them, each an increment, mm or degrees.
    pub fn wheel(&mut self, axis: Axis, counts: i64, increment: f64) {
        let speed = (self.config.handwheel / 60.0).min(self.of(axis).velocity);
        let surplus = if self.config.handwheel_keeps { Surplus::Kept } else { Surplus::Dropped };
        self.let_go(axis);
        self.moves_by(true);
        self.jog.wheel(axis, counts, increment, speed, surplus);
    }

    /// Axes that move on keep the acceleration that they began with.
    fn moves_by(&mut self, wheel: bool) {
        if self.jog.is_at_rest() {
            self.by_wheel = wheel;
        }
    }

    /// What the axes move for, by which they are accelerated (GSK990MC 17#3, 17#5).
    pub fn kind(&self) -> Kind {
        if self.by_wheel { Kind::Wheel } else { Kind::Jog }
    }

    /// Whether software limits of an axis hold, and whether it may be jogged at rapid speed. An axis that moves keeps
    /// the limits that it has.
    pub fn set_travel(&mut self, axis: Axis, holds: bool, rapid: bool) {
        if let Some(speeds) = self.speeds.get_mut(axis.index()) {
            speeds.no_rapid = !rapid;
            speeds.holds = holds;
            self.jog.set_travel(axis, holds.then_some(speeds.travel));
        }
    }

    /// Areas that are forbidden leave an axis this room, lower and upper machine position, within its software limits.
    /// An axis that moves keeps what it has.
    pub fn set_room(&mut self, axis: Axis, (low, high): (f64, f64)) {
        let Speeds { travel, holds, .. } = self.of(axis);
        let (least, most) = if holds { travel } else { (f64::NEG_INFINITY, f64::INFINITY) };
        let (least, most) = (least.max(low), most.min(high));
        // Bounds that leave no room leave the axis where it is.
        let room = if least <= most { (least, most) } else { (self.at(axis), self.at(axis)) };
        self.jog.set_travel(axis, Some(room));
    }

    /// Moves an axis on at a speed, mm/s with sign; 0 stops it.
    pub fn drive(&mut self, axis: Axis, speed: f64) {
        self.moves_by(false);
        self.jog.run(axis, speed);
    }

    /// Moves an axis to a place at a speed, mm/s; 0 stops it on the way.
    pub fn go(&mut self, axis: Axis, place: f64, speed: f64) {
        self.moves_by(false);
        match speed > 0.0 {
            true => self.jog.go(axis, place, speed),
            false => self.jog.run(axis, 0.0),
        }
    }

    /// Its speed, mm/s.
    pub fn velocity(&self, axis: Axis) -> f64 {
        self.jog.velocity()[axis]
    }

    /// The axes stand at `at` from here on.
    pub fn rename(&mut self, at: Position) {
        self.jog.rename(at);
    }

    /// Where an axis is commanded to be.
    pub fn at(&self, axis: Axis) -> f64 {
        self.jog.position()[axis]
    }

    /// Whether an axis stands where it was told to.
    pub fn stands(&self, axis: Axis) -> bool {
        self.jog.stands(axis)
    }

    /// The limit at which an axis stands although it was told to go on: whether it is the upper one.
    pub fn is_cut_short(&self, axis: Axis) -> Option<bool> {
        self.jog.is_cut_short(axis)
    }

    /// The software limits of an axis, where they hold.
    pub fn travel(&self, axis: Axis) -> Option<Travel> {
        let Speeds { travel, holds, .. } = self.of(axis);
        holds.then_some(travel)
    }

    /// A speed under the rapid override, mm/s. Its lowest step is a speed (4.1.3).
    pub fn under_rapid_override(&self, speed: f64) -> f64 {
        match self.rapid == 0.0 {
            true => (self.config.rapid_f0 / 60.0).min(speed),
            false => speed * self.rapid,
        }
    }

    /// Goes to a place as positioning does, under the rapid override.
    pub fn go_at_rapid(&mut self, axis: Axis, place: f64) {
        let speed = self.under_rapid_override(self.of(axis).positioning);
        self.let_go(axis);
        if place != self.at(axis) {
            self.moves_by(false);
            self.jog.go(axis, place, speed);
        }
    }

    /// Whether a key is held, also one that moves nothing now.
    pub fn is_held(&self) -> bool {
        self.held.iter().any(Option::is_some)
    }

    /// Whether the key of an axis is held.
    pub fn holds(&self, axis: Axis) -> bool {
        self.held.get(axis.index()).is_some_and(Option::is_some)
    }

    /// Stops all axes; keys must be pressed anew.
    pub fn stop(&mut self) {
        self.held = [None; AXES];
        self.jog.stop();
    }

    /// Goes on by a period: where the axes shall be, and their speed together, mm/s.
    pub fn tick(&mut self) -> (Position, f64) {
        let at = self.jog.tick();
        let speed = self.jog.velocity().0.iter().map(|v| v * v).sum::<f64>().sqrt();
        (at, speed)
    }

    /// Whether all axes stand where they were told to.
    pub fn is_at_rest(&self) -> bool {
        self.jog.is_at_rest()
    }

    fn let_go(&mut self, axis: Axis) {
        if let Some(held) = self.held.get_mut(axis.index()) {
            *held = None;
        }
    }

    fn of(&self, axis: Axis) -> Speeds {
        self.speeds.get(axis.index()).copied().unwrap_or_default()
    }
}
