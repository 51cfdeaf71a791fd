//! The simulated machine behind the drives: what its axes, switches, spindle and magazine are like. Plain data;
//! the controller's `drives/plant.rs` is the machine.
//!
//! Places are physical: where a machine that was homed says that the axis is.

use crate::config::axis_letter;
use crate::config_error::{self, ConfigError};
use ferrocut_geometry::Axis;
use serde::Deserialize;
use std::collections::BTreeMap;

/// `[plant]` of the machine file.
#[derive(Clone, Debug, PartialEq, Deserialize)]
#[serde(default, deny_unknown_fields)]
pub struct PlantConfig {
    /// Axes, where they differ from the usual; each at most once.
    pub axes: Vec<PlantAxis>,
    /// Gain of the position loop of the spindle, in which it taps in step with the axes, 1/s; 0 is an ideal one.
    pub spindle_gain: f64,
    /// Share of its commanded speed that is fed forward.
    pub spindle_feed_forward: f64,
    /// Pockets of the magazine.
    pub pockets: u32,
    /// Time from one pocket to the next, ms.
    pub pocket_ms: f64,
    /// Time of the magazine to the spindle and back, ms.
    pub magazine_ms: f64,
    /// Time to release and to clamp a tool or an axis, ms.
    pub clamp_ms: f64,
    /// Time until the lubrication has pressure, and has lost it, ms.
    pub lube_ms: f64,
    /// The probe is on while it touches nothing; else while it touches. What is not said is as the parameters have it.
    pub probe_opens: Option<bool>,
    /// What the probe can touch.
    pub blocks: Vec<PlantBlock>,
    /// Addresses of signals that are wired otherwise than in the standard ladder, by name.
    pub wiring: BTreeMap<String, String>,
}

impl Default for PlantConfig {
    fn default() -> PlantConfig {
        PlantConfig {
            axes: Vec::new(),
            spindle_gain: 50.0,
            spindle_feed_forward: 0.95,
            pockets: 16,
            pocket_ms: 400.0,
            magazine_ms: 800.0,
            clamp_ms: 300.0,
            lube_ms: 500.0,
            probe_opens: None,
            blocks: Vec::new(),
            wiring: BTreeMap::new(),
        }
    }
}

/// A block that a probe touches, a piece of stock or a tool setter: the physical places of X, Y and Z of its lower and
/// upper corner. A plane is a block that is large enough.
#[derive(Clone, Copy, PartialEq, Debug, Deserialize)]
#[serde(deny_unknown_fields)]
pub struct PlantBlock {
    /// Lower corner.
    pub min: [f64; 3],
    /// Upper corner.
    pub max: [f64; 3],
}

/// An axis of the simulated machine. Lengths are mm, of rotary axes degrees.
#[derive(Clone, Debug, PartialEq, Deserialize)]
#[serde(deny_unknown_fields)]
pub struct PlantAxis {
    /// Its letter.
    #[serde(deserialize_with = "axis_letter")]
    pub name: Axis,
    /// Gain of the position loop, 1/s.
    #[serde(default = "default_gain")]
    pub gain: f64,
    /// Time constant of the speed loop, ms; 0 is an ideal one.
    #[serde(default = "default_lag")]
    pub lag_ms: f64,
    /// Share of the commanded speed that is fed forward; with 1 the axis does not lag at constant speed.
    #[serde(default = "default_feed_forward")]
    pub feed_forward: f64,
    /// What the encoder resolves; 0 is everything.
    #[serde(default = "default_resolution")]
    pub resolution: f64,
    /// Way from marker to marker, a turn of the screw.
    #[serde(default = "default_pitch")]
    pub pitch: f64,
    /// Place of one of the markers; the reference point where it is missing.
    #[serde(default)]
    pub marker: Option<f64>,
    /// Where the home switch is reached, from and to; where it is missing, so that homing upwards or downwards
    /// finds the marker at the reference point.
    #[serde(default)]
    pub home: Option<[f64; 2]>,
    /// Where the travel switches open; 10 mm outside the software limits where they are missing.
    #[serde(default)]
    pub limits: Option<[f64; 2]>,
    /// Where the axis stands when power comes.
    #[serde(default)]
    pub at: Option<f64>,
}

impl PlantAxis {
    /// The usual axis.
    pub fn new(name: Axis) -> PlantAxis {
        PlantAxis {
            name,
            gain: default_gain(),
            lag_ms: default_lag(),
            feed_forward: default_feed_forward(),
            resolution: default_resolution(),
            pitch: default_pitch(),
            marker: None,
            home: None,
            limits: None,
            at: None,
        }
    }
}

fn default_gain() -> f64 {
    50.0
}

fn default_lag() -> f64 {
    2.0
}

fn default_feed_forward() -> f64 {
    0.98
}

fn default_resolution() -> f64 {
    1e-4
}

fn default_pitch() -> f64 {
    10.0
}

impl PlantConfig {
    pub(crate) fn check(&self) -> Result<(), ConfigError> {
        let within = |what: &str, value: f64, min: f64, max: f64| {
            config_error::within(&format!("plant: {what}"), value, min, max)
        };
        for (k, axis) in self.axes.iter().enumerate() {
            let name = axis.name.letter();
            if self.axes.iter().take(k).any(|other| other.name == axis.name) {
                return Err(ConfigError::twice(format!("plant: axes {name}")));
            }
            within(&format!("axes {name}: gain"), axis.gain, 0.1, 1e4)?;
            within(&format!("axes {name}: lag_ms"), axis.lag_ms, 0.0, 1e3)?;
            within(&format!("axes {name}: feed_forward"), axis.feed_forward, 0.0, 1.0)?;
            within(&format!("axes {name}: resolution"), axis.resolution, 0.0, 1.0)?;
            within(&format!("axes {name}: pitch"), axis.pitch, 1e-3, 1e6)?;
            for (key, switch) in [("home", axis.home), ("limits", axis.limits)] {
                if let Some([from, to]) = switch {
                    within(&format!("axes {name}: {key}"), from, -1e6, 1e6)?;
                    within(&format!("axes {name}: {key}"), to, from, 1e6)?;
                }
            }
            for (key, place) in [("marker", axis.marker), ("at", axis.at)] {
                within(&format!("axes {name}: {key}"), place.unwrap_or(0.0), -1e6, 1e6)?;
            }
        }
        for block in &self.blocks {
            for (min, max) in block.min.into_iter().zip(block.max) {
                within("blocks: min", min, -1e6, 1e6)?;
                within("blocks: max", max, min, 1e6)?;
            }
        }
        within("spindle_gain", self.spindle_gain, 0.0, 1e4)?;
        within("spindle_feed_forward", self.spindle_feed_forward, 0.0, 1.0)?;
        within("pockets", f64::from(self.pockets), 1.0, 1000.0)?;
        for (key, ms) in [
            ("pocket_ms", self.pocket_ms),
            ("magazine_ms", self.magazine_ms),
            ("clamp_ms", self.clamp_ms),
            ("lube_ms", self.lube_ms),
        ] {
            within(key, ms, 0.0, 1e6)?;
        }
        Ok(())
    }
}
