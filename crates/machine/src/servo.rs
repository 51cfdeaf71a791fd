//! What lies between the path and the drive of an axis: backlash, pitch errors, acceleration after
//! interpolation, supervision. Plain data; `ferrocut-motion` has what it does.
//!
//! Lengths are mm, of rotary axes degrees. A control that has parameters for these things writes them over
//! what the machine file says (`Dialect::machine_parameters` of the interpreter).

use crate::config_error::{ConfigError, within};
use serde::Deserialize;

/// Most points of a pitch-error table (GSK990MC P216: numbers 0 to 9999).
pub const PITCH_POINTS: usize = 10_000;

/// Longest time over which a movement is spread, ms. Controls stop at 400 (GSK990MC P115 to P128, P200).
const LONGEST_MS: f64 = 1000.0;

/// Backlash that is known, mm; wider play is a damaged drive. GSK990MC P190 has 0.5.
const LARGEST_BACKLASH: f64 = 5.0;

/// Play of an axis that is taken up when it turns back.
#[derive(Clone, Debug, PartialEq, Deserialize)]
#[serde(default, deny_unknown_fields)]
pub struct Backlash {
    /// What is taken up while cutting.
    pub cutting: f64,
    /// What is taken up while positioning; the same where it is not given.
    pub rapid: Option<f64>,
    /// Take it up at this rate, mm/min; 0: with acceleration, within `time_ms`.
    pub rate: f64,
    /// Time within which it is taken up with acceleration, ms. It becomes longer where the limits of the
    /// axis ask for that.
    pub time_ms: f64,
    /// An axis has turned back once it moves back by more than this in one period,
    pub reversal_step: f64,
    /// or by more than this altogether.
    pub reversal_way: f64,
    /// The axis was homed in the negative direction: moving there it needs no compensation.
    pub homes_negative: bool,
    /// The next move waits until it is taken up.
    pub waits: bool,
}

impl Default for Backlash {
    fn default() -> Backlash {
        Backlash {
            cutting: 0.0,
            rapid: None,
            rate: 0.0,
            time_ms: 20.0,
            // Above what rounding moves an axis by that stands still.
            reversal_step: 1e-6,
            reversal_way: 1e-4,
            homes_negative: false,
            waits: false,
        }
    }
}

/// A table of pitch errors: what is added to the commanded position at evenly spaced points. Between two
/// points it is interpolated, before the first and behind the last it stays as it is there.
#[derive(Clone, Debug, Default, PartialEq, Deserialize)]
#[serde(deny_unknown_fields)]
pub struct PitchErrors {
    /// Machine position of the first point; where it is not given, the parameters of the control say.
    #[serde(default)]
    pub start: Option<f64>,
    /// Distance of two points; the same holds.
    #[serde(default)]
    pub interval: Option<f64>,
    /// What is added, point by point.
    pub corrections: Vec<f64>,
    /// What is added while the axis moves in the negative direction; the same where it is empty.
    #[serde(default)]
    pub opposite: Vec<f64>,
}

/// Acceleration after interpolation: how a change of speed is spread over time, axis by axis.
#[derive(Clone, Copy, Debug, Default, PartialEq, Deserialize)]
#[serde(tag = "kind", rename_all = "lowercase", deny_unknown_fields)]
pub enum Smoothing {
    /// It is not.
    #[default]
    None,
    /// A change of speed takes this time, ms, at constant acceleration.
    Linear {
        /// The time.
        time_ms: f64,
    },
    /// After this time, ms, a change of speed is done but for 37 %.
    Exponential {
        /// The time.
        time_ms: f64,
        /// Speed at which what is left is run, mm/min (GSK990MC P129, FL).
        #[serde(default)]
        least: f64,
    },
}

/// The drives as a whole.
#[derive(Clone, Debug, PartialEq, Deserialize)]
#[serde(default, deny_unknown_fields)]
pub struct ServoConfig {
    /// Whether acceleration before and after interpolation is what the parameters of the control select, on controls
    /// that have such, or what stands at the axes. Where neither is said the parameters select it for what some of
    /// them were changed of: positioning, cutting, arcs, moving by hand.
    pub acceleration_by_parameters: Option<bool>,
    /// An axis that is not in position this long after its stop is an alarm, ms.
    pub in_position_ms: f64,
}

impl Default for ServoConfig {
    fn default() -> ServoConfig {
        ServoConfig { acceleration_by_parameters: None, in_position_ms: 1000.0 }
    }
}

impl Smoothing {
    /// Its time constant, ms; 0 where there is none.
    pub fn time_ms(self) -> f64 {
        match self {
            Smoothing::None => 0.0,
            Smoothing::Linear { time_ms } | Smoothing::Exponential { time_ms, .. } => time_ms,
        }
    }

    pub(crate) fn check(self, what: &str) -> Result<(), ConfigError> {
        within(&format!("{what}: time_ms"), self.time_ms(), 0.0, LONGEST_MS)?;
        match self {
            Smoothing::Exponential { least, .. } => within(&format!("{what}: least"), least, 0.0, 1e4),
            _ => Ok(()),
        }
    }
}

impl Backlash {
    pub(crate) fn check(&self, what: &str) -> Result<(), ConfigError> {
        let most = LARGEST_BACKLASH;
        within(&format!("{what}: cutting"), self.cutting, -most, most)?;
        within(&format!("{what}: rapid"), self.rapid.unwrap_or(0.0), -most, most)?;
        within(&format!("{what}: rate"), self.rate, 0.0, 1e5)?;
        within(&format!("{what}: time_ms"), self.time_ms, 0.0, LONGEST_MS)?;
        within(&format!("{what}: reversal_step"), self.reversal_step, 0.0, 1.0)?;
        within(&format!("{what}: reversal_way"), self.reversal_way, 0.0, 1.0)
    }
}

impl PitchErrors {
    pub(crate) fn check(&self, what: &str) -> Result<(), ConfigError> {
        let points = self.corrections.len();
        if points == 0 || points > PITCH_POINTS {
            return Err(ConfigError::count(format!("{what}: corrections"), points, 1, PITCH_POINTS));
        }
        if !self.opposite.is_empty() && self.opposite.len() != points {
            let error =
                ConfigError::label("label-config-unequal").with("what", format!("{what}: corrections"));
            let error = error.with("value", points).with("other", "opposite");
            return Err(error.with("count", self.opposite.len()));
        }
        within(&format!("{what}: start"), self.start.unwrap_or(0.0), -1e6, 1e6)?;
        if let Some(interval) = self.interval {
            within(&format!("{what}: interval"), interval, 1e-3, 1e6)?;
        }
        let all = self.corrections.iter().chain(&self.opposite);
        all.into_iter().try_for_each(|c| within(&format!("{what}: corrections"), *c, -10.0, 10.0))
    }
}
