//! A program that asks much of the servo period: nine axes, short blocks, circles, corners, positioning.
#![allow(dead_code)]

use ferrocut_geometry::{AXES, Axis, Plane, Position};
use ferrocut_machine::{AxisConfig, Backlash, Machine, PITCH_POINTS, PitchErrors, Smoothing};
use ferrocut_motion::Move;
use ferrocut_toolpath::PathMode;

/// Nine axes like the X axis of the demo mill, each changed.
pub fn nine_axes(period_ms: f64, change: impl Fn(&mut AxisConfig)) -> Machine {
    let mut machine = Machine::demo_mill();
    machine.servo_period_ms = period_ms;
    let model = machine.axes.first().cloned();
    machine.axes = Axis::ALL
        .iter()
        .flat_map(|name| model.clone().map(|axis| AxisConfig { name: *name, ..axis }))
        .collect();
    machine.axes.iter_mut().for_each(change);
    machine
}

/// An axis with backlash, and pitch errors in both directions.
pub fn compensate(axis: &mut AxisConfig) {
    axis.backlash = Backlash { cutting: 0.01, rapid: Some(0.02), time_ms: 400.0, ..Backlash::default() };
    axis.pitch_errors = Some(PitchErrors {
        start: Some(-500.0),
        interval: Some(0.1),
        corrections: (0..PITCH_POINTS).map(|k| (k as f64 * 0.01).sin() * 0.01).collect(),
        opposite: (0..PITCH_POINTS).map(|k| (k as f64 * 0.01).cos() * 0.01).collect(),
    });
}

/// Nine axes with everything that there is between path and drives.
pub fn machine() -> Machine {
    nine_axes(1.0, |axis| {
        axis.after_rapid = Smoothing::Linear { time_ms: 8.0 };
        axis.after_cutting = Smoothing::Linear { time_ms: 16.0 };
        compensate(axis);
        axis.following_error = 50.0;
    })
}

/// Numbers without order that are the same every time (a linear congruential generator, the constants of Knuth's MMIX).
#[derive(Clone, Debug)]
pub struct Chance(pub u64);

impl Chance {
    /// From 0 up to 1.
    pub fn next(&mut self) -> f64 {
        self.0 = self.0.wrapping_mul(6_364_136_223_846_793_005).wrapping_add(1_442_695_040_888_963_407);
        (self.0 >> 11) as f64 / (1u64 << 53) as f64
    }

    /// A whole number below `most`.
    pub fn below(&mut self, most: u32) -> u32 {
        (self.next() * f64::from(most)) as u32
    }
}

/// The program, block by block without end; `tag` counts.
#[derive(Clone, Debug)]
pub struct Blocks {
    chance: Chance,
    at: Position,
    tag: u64,
    kind: u32,
    left: u32,
    phase: f64,
}

impl Blocks {
    pub fn new(seed: u64) -> Blocks {
        Blocks { chance: Chance(seed), at: Position::ZERO, tag: 0, kind: 0, left: 0, phase: 0.0 }
    }

    /// The next block.
    pub fn next(&mut self) -> Option<Move> {
        if self.left == 0 {
            self.kind = self.chance.below(5);
            self.left = match self.kind {
                0 | 1 => 2000,
                2 => 12,
                3 => 40,
                _ => 3,
            };
        }
        self.left -= 1;
        self.tag += 1;
        let tag = self.tag;
        let place = |chance: &mut Chance, reach: f64| {
            Position(std::array::from_fn::<f64, AXES, _>(|_| (chance.next() - 0.5) * reach))
        };
        let made = match self.kind {
            // Blocks of 0.05 mm on a curve of all axes, as a CAM system rounds them.
            0 | 1 => {
                self.phase += 0.002;
                let phase = self.phase;
                let step = |i: usize| 0.025 * (phase * (1.0 + i as f64 * 0.37) + i as f64).cos();
                let to = Position(std::array::from_fn(|i| ((self.at.0[i] + step(i)) * 1e3).round() / 1e3));
                let feed = if self.kind == 0 { 100.0 } else { 40.0 };
                Move::line(to, feed, PathMode::Continuous, tag)
            }
            // Circles and helices.
            2 => {
                let to = self.at + Position::xyz(0.0, 0.0, self.chance.next() - 0.5);
                let r = 1.0 + 20.0 * self.chance.next();
                let center = [self.at.0[0] - r, self.at.0[1]];
                let turns = std::f64::consts::TAU * f64::from(1 + self.chance.below(3));
                let sweep = if self.chance.next() < 0.5 { turns } else { -turns };
                Move::arc(to, Plane::Xy, center, sweep, 120.0, PathMode::Continuous, tag)
            }
            // Corners, some exact.
            3 => {
                let to = self.at + place(&mut self.chance, 12.0);
                let mode = if self.chance.next() < 0.2 { PathMode::ExactStop } else { PathMode::Continuous };
                Move::line(to, 80.0, mode, tag)
            }
            // Positioning, every axis on its own or straight.
            _ => {
                let to = place(&mut self.chance, 200.0);
                Move::rapid(to, self.chance.next() < 0.3, tag)
            }
        };
        self.at = made.map_or(self.at, |m| m.to());
        made
    }
}

/// What an operator does, at random.
#[derive(Clone, Debug)]
pub struct Hands {
    chance: Chance,
    held: bool,
}

/// What is asked for.
#[derive(Clone, Copy, PartialEq, Debug)]
pub enum Asked {
    Override(f64, f64),
    Hold,
    Resume,
}

impl Hands {
    pub fn new(seed: u64) -> Hands {
        Hands { chance: Chance(seed), held: false }
    }

    /// What is asked for in a period; something in about one of 500, a hold is short.
    pub fn next(&mut self) -> Option<Asked> {
        if self.held {
            self.held = self.chance.below(200) != 0;
            return (!self.held).then_some(Asked::Resume);
        }
        if self.chance.below(500) != 0 {
            return None;
        }
        if self.chance.below(3) == 0 {
            self.held = true;
            return Some(Asked::Hold);
        }
        let feed = 0.1 * f64::from(1 + self.chance.below(15));
        Some(Asked::Override(feed, 0.25 * f64::from(1 + self.chance.below(4))))
    }
}

/// Times of periods, counted in steps of 50 ns, so that nothing is taken while measuring.
#[derive(Clone, Debug)]
pub struct Times {
    counts: Vec<u32>,
    worst: u64,
    total: u64,
}

const STEP_NS: u64 = 50;

impl Default for Times {
    fn default() -> Times {
        Times { counts: vec![0; 200_000], worst: 0, total: 0 }
    }
}

impl Times {
    /// Adds a time, ns.
    pub fn add(&mut self, ns: u64) {
        let place = usize::try_from(ns / STEP_NS).unwrap_or(usize::MAX).min(self.counts.len() - 1);
        if let Some(count) = self.counts.get_mut(place) {
            *count += 1;
        }
        self.worst = self.worst.max(ns);
        self.total += 1;
    }

    /// The time that this share of all stays within, µs.
    pub fn within(&self, share: f64) -> f64 {
        let most = (self.total as f64 * share).ceil() as u64;
        let mut sum = 0;
        let place = self.counts.iter().position(|count| {
            sum += u64::from(*count);
            sum >= most
        });
        (place.unwrap_or(0) as u64 + 1) as f64 * STEP_NS as f64 / 1e3
    }

    /// In words.
    pub fn text(&self) -> String {
        format!(
            "median {:.2} µs, 99.99th percentile {:.2} µs, worst {:.2} µs of {}",
            self.within(0.5),
            self.within(0.9999),
            self.worst as f64 / 1e3,
            self.total
        )
    }
}
