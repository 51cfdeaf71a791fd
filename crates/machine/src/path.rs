//! How paths are run: tolerance, acceleration before interpolation, corners and arcs that are slowed down for. Plain
//! data; `ferrocut-motion` has what it does.
//!
//! A control that has parameters for these things writes them over what the machine file says
//! (`Dialect::machine_parameters` of the interpreter).

use crate::config_error::{ConfigError, not_negative, positive, within};
use serde::Deserialize;

/// Path control of the machine file.
#[derive(Clone, Debug, PartialEq, Deserialize)]
#[serde(default, deny_unknown_fields)]
pub struct PathConfig {
    /// How far the path may leave the programmed one at joints where the program sets nothing, mm.
    pub tolerance: f64,
    /// Come to rest at the end of every move.
    pub exact_stop: bool,
    /// Cutting is no slower than this, whatever the feed override is above 0, mm/min.
    pub lowest_feed: f64,
    /// Cutting is no faster than this, whatever the overrides are, mm/min.
    pub highest_feed: Option<f64>,
    /// Acceleration before interpolation along the path while cutting, where it is limited besides the axes' own.
    pub ramp: Option<Ramp>,
    /// Corners between cutting moves that are slowed down for.
    pub corner: Option<CornerSlowdown>,
    /// Arcs that are slowed down for.
    pub arc: Option<ArcSlowdown>,
}

impl Default for PathConfig {
    fn default() -> PathConfig {
        PathConfig {
            tolerance: 0.01,
            exact_stop: false,
            lowest_feed: 0.0,
            highest_feed: None,
            ramp: None,
            corner: None,
            arc: None,
        }
    }
}

/// Acceleration before interpolation: how a speed is built up and taken back.
#[derive(Clone, Copy, Debug, PartialEq, Deserialize)]
#[serde(deny_unknown_fields)]
pub struct Ramp {
    /// Highest acceleration, mm/s² or degrees/s².
    pub acceleration: f64,
    /// Highest jerk, mm/s³ or degrees/s³: a ramp like an S. 0 is not limited: a linear one.
    #[serde(default)]
    pub jerk: f64,
}

/// Corners that are run through slower than the feed. One of the two rules says which, and how slow.
#[derive(Clone, Copy, Debug, PartialEq, Deserialize)]
#[serde(deny_unknown_fields)]
pub struct CornerSlowdown {
    /// A corner is slowed down for if the angle between its two moves is no more than this, degrees: 180 is straight
    /// on, 0 back. It is run at the lowest feed.
    #[serde(default)]
    pub angle: Option<f64>,
    /// At a corner no axis changes its speed by more than this, mm/min.
    #[serde(default)]
    pub speed_difference: Option<f64>,
    /// No corner is slowed down for below this feed, mm/min.
    pub lowest_feed: f64,
}

/// Arcs that are run slower than the feed.
#[derive(Clone, Copy, Debug, PartialEq, Deserialize)]
#[serde(deny_unknown_fields)]
pub struct ArcSlowdown {
    /// Highest acceleration towards the centre, mm/s².
    pub acceleration: f64,
    /// No arc is slowed down for below this feed, mm/min.
    #[serde(default)]
    pub lowest_feed: f64,
}

impl PathConfig {
    pub(crate) fn check(&self) -> Result<(), ConfigError> {
        not_negative("path: tolerance", self.tolerance)?;
        not_negative("path: lowest_feed", self.lowest_feed)?;
        if let Some(highest) = self.highest_feed {
            positive("path: highest_feed", highest)?;
        }
        if let Some(ramp) = self.ramp {
            ramp.check("path: ramp")?;
        }
        if let Some(corner) = self.corner {
            corner.check()?;
        }
        if let Some(arc) = self.arc {
            positive("path: arc: acceleration", arc.acceleration)?;
            not_negative("path: arc: lowest_feed", arc.lowest_feed)?;
        }
        Ok(())
    }
}

impl Ramp {
    pub(crate) fn check(&self, what: &str) -> Result<(), ConfigError> {
        positive(&format!("{what}: acceleration"), self.acceleration)?;
        not_negative(&format!("{what}: jerk"), self.jerk)
    }
}

impl CornerSlowdown {
    fn check(&self) -> Result<(), ConfigError> {
        not_negative("path: corner: lowest_feed", self.lowest_feed)?;
        match (self.angle, self.speed_difference) {
            (Some(angle), None) => within("path: corner: angle", angle, 0.0, 180.0),
            (None, Some(difference)) => positive("path: corner: speed_difference", difference),
            _ => {
                let error = ConfigError::label("label-config-either").with("what", "path: corner");
                Err(error.with("one", "angle").with("other", "speed_difference"))
            }
        }
    }
}
