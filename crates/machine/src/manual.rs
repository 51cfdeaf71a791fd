//! How fast axes are moved by hand.

use crate::config_error::{ConfigError, not_negative};
use serde::Deserialize;

/// Moving by hand, of the machine file. Speeds in mm/min (degrees/min); those of the axes hold besides.
#[derive(Clone, Debug, PartialEq, Deserialize)]
#[serde(default, deny_unknown_fields)]
pub struct ManualConfig {
    /// Continuous jog at a feed override of 100 %.
    pub jog: f64,
    /// Highest speed of steps.
    pub step: f64,
    /// Highest speed of the handwheel.
    pub handwheel: f64,
    /// Whether an axis runs all counts of the handwheel, also those that it cannot follow at once.
    pub handwheel_keeps: bool,
    /// Whether axes move against the sense of the handwheel.
    pub handwheel_reversed: bool,
    /// Rapid jog at the lowest rapid override, F0; 0 stands still.
    pub rapid_f0: f64,
}

impl Default for ManualConfig {
    fn default() -> ManualConfig {
        ManualConfig {
            jog: 2000.0,
            step: 1000.0,
            handwheel: 2000.0,
            handwheel_keeps: false,
            handwheel_reversed: false,
            rapid_f0: 30.0,
        }
    }
}

impl ManualConfig {
    pub(crate) fn check(&self) -> Result<(), ConfigError> {
        let speeds = [
            ("jog", self.jog),
            ("step", self.step),
            ("handwheel", self.handwheel),
            ("rapid_f0", self.rapid_f0),
        ];
        speeds.iter().try_for_each(|(key, speed)| not_negative(&format!("manual: {key}"), *speed))
    }
}
