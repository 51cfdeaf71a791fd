//! How axes find their reference points. Plain data; the controller has what it does.
//!
//! A control that has parameters for these things writes them over what the machine file says
//! (`Dialect::machine_parameters` of the interpreter).

use crate::config_error::{ConfigError, positive, within};
use serde::Deserialize;

/// Machine zero return of all axes, of the machine file.
#[derive(Clone, Debug, PartialEq, Deserialize)]
#[serde(default, deny_unknown_fields)]
pub struct HomingConfig {
    /// The reference point is a marker of the encoder; else an edge of the home switch.
    pub marker: bool,
    /// It is searched on the near side of the switch, for which the axis turns back; else behind the switch.
    pub before: bool,
    /// An edge is met a second time, slowly and from the other side. Without meaning with a marker.
    pub twice: bool,
    /// One axis at a time by hand.
    pub one_at_a_time: bool,
    /// A reference point that was found is kept while power is off.
    pub remembers: bool,
    /// An axis whose reference point is known is positioned on it; else it is searched anew each time.
    pub known_at_rapid: bool,
    /// It is positioned at the manual rapid speed; else at that of positioning.
    pub at_manual_rapid: bool,
    /// The encoders are absolute: no axis is ever without its reference point.
    pub absolute: bool,
    /// Software limits hold before the reference point is found.
    pub limits_before: bool,
    /// Manual rapid is possible before it is found.
    pub rapid_before: bool,
    /// No program moves an axis before it is found, except to find it.
    pub needed: bool,
    /// Nor does a program find it.
    pub not_by_program: bool,
    /// The axis key is held until the axis has arrived; else a press is enough.
    pub key_held: bool,
    /// Travel switches stop nothing.
    pub ignores_switches: bool,
    /// The home switches go through the ladder; else the control reads their inputs itself.
    pub through_ladder: bool,
    /// Axes by letter: each waits until those before it have arrived. Those that are not named wait for
    /// nobody.
    pub order: String,
    /// Farthest way from the switch to a marker, mm or degrees.
    pub marker_way: f64,
}

impl Default for HomingConfig {
    fn default() -> HomingConfig {
        HomingConfig {
            marker: true,
            before: false,
            twice: true,
            one_at_a_time: false,
            remembers: false,
            known_at_rapid: false,
            at_manual_rapid: false,
            absolute: false,
            limits_before: false,
            rapid_before: false,
            needed: false,
            not_by_program: false,
            key_held: false,
            ignores_switches: false,
            through_ladder: false,
            order: String::new(),
            marker_way: 40.0,
        }
    }
}

/// Machine zero return of one axis, of the machine file.
#[derive(Clone, Debug, PartialEq, Deserialize)]
#[serde(default, deny_unknown_fields)]
pub struct AxisHoming {
    /// Speed to the switch, mm/min (degrees/min).
    pub fast: f64,
    /// Speed on the switch and off it.
    pub slow: f64,
    /// Speed to the reference point.
    pub search: f64,
    /// The axis homes downwards; else upwards.
    pub negative: bool,
    /// The home switch is on where it is reached; else off.
    pub closes: bool,
    /// The reference point lies so far from the marker or edge, mm or degrees upwards.
    pub shift: f64,
}

impl Default for AxisHoming {
    fn default() -> AxisHoming {
        AxisHoming { fast: 4000.0, slow: 200.0, search: 40.0, negative: false, closes: false, shift: 0.0 }
    }
}

impl HomingConfig {
    pub(crate) fn check(&self) -> Result<(), ConfigError> {
        positive("homing: marker_way", self.marker_way)
    }
}

impl AxisHoming {
    pub(crate) fn check(&self, what: &str) -> Result<(), ConfigError> {
        let speeds = [("fast", self.fast), ("slow", self.slow), ("search", self.search)];
        speeds.iter().try_for_each(|(key, speed)| positive(&format!("{what}: {key}"), *speed))?;
        within(&format!("{what}: shift"), self.shift, -1e3, 1e3)
    }
}
