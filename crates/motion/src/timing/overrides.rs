//! Overrides: what the operator makes of the programmed speed, and the highest speed of a cell with them.

use crate::limits::{Class, Limits, MAX_SPINDLE_OVERRIDE};
use crate::quick::{larger, smaller};
use crate::timing::queue::Node;
use ferrocut_geometry::AXES;

/// Slower than this nothing is planned, mm/s.
pub const LEAST_SPEED: f64 = 1e-6;

/// What is planned with while the override is 0.
const HELD_SHARE: f64 = 0.05;

/// Overrides as factors, and what else the programmed speed depends on as it is run.
#[derive(Clone, Copy, PartialEq, Debug)]
pub(crate) struct Overrides {
    pub feed: f64,
    pub rapid: f64,
    /// No axis positions faster than this, mm/s or degrees/s.
    pub rapid_speed: f64,
    /// Speed of the spindle, r/min, which feeds per revolution follow; as they were given where it is not known.
    pub rpm: Option<f64>,
    /// Slowest cutting, mm/s.
    pub lowest: f64,
}

impl Overrides {
    /// The factor that holds for `class`.
    pub fn of(&self, class: Class) -> f64 {
        match class {
            Class::Rapid => self.rapid,
            Class::Cut => self.feed,
            Class::Full | Class::Locked => 1.0,
        }
    }

    /// Highest speed of each axis that positions on its own, mm/s or degrees/s.
    pub fn rapid_speeds(&self, limits: &Limits) -> [f64; AXES] {
        limits.rapid.map(|rapid| (rapid * self.rapid).min(self.rapid_speed))
    }

    /// The factor of the programmed speed of a cell.
    #[inline]
    pub fn share(&self, node: &Node) -> f64 {
        let turns = match self.rpm {
            Some(rpm) if node.follows_spindle() => (rpm / node.basis).min(MAX_SPINDLE_OVERRIDE),
            _ => 1.0,
        };
        self.of(node.class) * turns
    }

    /// Highest speed in a cell, mm/s.
    #[inline]
    pub fn cap(&self, node: &Node) -> f64 {
        larger(LEAST_SPEED, smaller(node.top, self.feed(node)))
    }

    /// The same, curves aside.
    pub fn most(&self, node: &Node) -> f64 {
        larger(LEAST_SPEED, smaller(node.most, self.feed(node)))
    }

    /// The programmed speed as it is now.
    #[inline]
    fn feed(&self, node: &Node) -> f64 {
        let feed = if node.feed.is_finite() { node.feed } else { node.most };
        // At override 0 the path is held, or passes what it cannot be stopped before.
        let share = Some(self.share(node)).filter(|share| *share > 0.0).unwrap_or(HELD_SHARE);
        match node.class {
            Class::Rapid => (feed * share).min(self.rapid_speed / node.basis),
            Class::Cut | Class::Full => larger(self.lowest, feed * share),
            Class::Locked => feed * share,
        }
    }
}
