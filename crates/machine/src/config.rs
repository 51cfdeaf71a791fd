//! The machine file: axes with their limits, spindle, tool changer, path control.

use crate::config_error::{ConfigError, finite, not_negative, positive, within};
use crate::drives::DrivesConfig;
use crate::handshake::{GearConfig, HandshakeConfig};
use crate::homing::{AxisHoming, HomingConfig};
use crate::manual::ManualConfig;
use crate::path::{PathConfig, Ramp};
use crate::plant::PlantConfig;
use crate::restart::RestartConfig;
use crate::servo::{Backlash, PitchErrors, ServoConfig, Smoothing};
use ferrocut_geometry::{Axis, AxisSet, Position};
use serde::Deserialize;

/// A machine as its file describes it.
#[derive(Clone, Debug, PartialEq, Deserialize)]
#[serde(deny_unknown_fields)]
pub struct Machine {
    /// Name shown to people.
    pub name: String,
    /// Control language of programs that do not show their own.
    #[serde(default = "default_dialect")]
    pub dialect: String,
    /// Time between two setpoints, ms.
    #[serde(default = "default_period")]
    pub servo_period_ms: f64,
    /// File of programs that come with the machine, beside its own file: they can be called, and on controls
    /// that have such, stand for codes.
    #[serde(default)]
    pub public_programs: Option<String>,
    /// The axes, each at most once.
    pub axes: Vec<AxisConfig>,
    /// The spindle.
    #[serde(default)]
    pub spindle: SpindleConfig,
    /// The tool changer.
    #[serde(default)]
    pub tool_change: ToolChangeConfig,
    /// How joints of moves are run.
    #[serde(default)]
    pub path: PathConfig,
    /// The drives as a whole.
    #[serde(default)]
    pub servo: ServoConfig,
    /// Moving by hand.
    #[serde(default)]
    pub manual: ManualConfig,
    /// Machine zero return.
    #[serde(default)]
    pub homing: HomingConfig,
    /// The simulated machine, where the drives are not ideal.
    #[serde(default)]
    pub plant: Option<PlantConfig>,
    /// The drives of a real machine; simulated ones where it says nothing of them.
    #[serde(default)]
    pub drives: Option<DrivesConfig>,
    /// How codes are handed to the ladder.
    #[serde(default)]
    pub handshake: HandshakeConfig,
    /// The way to a restart.
    #[serde(default)]
    pub restart: RestartConfig,
    /// The control's own parameters that differ from its factory setting, by their own names.
    #[serde(default)]
    pub parameters: std::collections::BTreeMap<String, f64>,
}

/// One axis of the machine file.
#[derive(Clone, Debug, PartialEq, Deserialize)]
#[serde(deny_unknown_fields)]
pub struct AxisConfig {
    /// Letter of the axis.
    #[serde(deserialize_with = "axis_letter")]
    pub name: Axis,
    /// Linear or rotary.
    #[serde(default)]
    pub kind: AxisKind,
    /// Lower software limit, machine position, mm or degrees.
    pub min: f64,
    /// Upper software limit, machine position, mm or degrees.
    pub max: f64,
    /// Positioning speed, mm/min or degrees/min.
    pub rapid: f64,
    /// The same by hand with the rapid key; no more than `rapid`, which it is where it is missing.
    #[serde(default)]
    pub manual_rapid: Option<f64>,
    /// Highest speed while cutting, mm/min or degrees/min.
    pub velocity: f64,
    /// Highest acceleration, mm/s² or degrees/s².
    pub acceleration: f64,
    /// Highest jerk, mm/s³ or degrees/s³; 0 is not limited.
    #[serde(default)]
    pub jerk: f64,
    /// Play that is taken up when the axis turns back.
    #[serde(default)]
    pub backlash: Backlash,
    /// Pitch errors of its screw.
    #[serde(default)]
    pub pitch_errors: Option<PitchErrors>,
    /// Acceleration before interpolation while positioning, where it is not the axis's own.
    #[serde(default)]
    pub before_rapid: Option<Ramp>,
    /// The same while cutting.
    #[serde(default)]
    pub before_cutting: Option<Ramp>,
    /// Acceleration after interpolation while positioning.
    #[serde(default)]
    pub after_rapid: Smoothing,
    /// The same while cutting.
    #[serde(default)]
    pub after_cutting: Smoothing,
    /// The same while the axis is moved by hand.
    #[serde(default)]
    pub after_jog: Smoothing,
    /// The same while it follows the handwheel, where that is another.
    #[serde(default)]
    pub after_wheel: Option<Smoothing>,
    /// Distance between command and axis that is an alarm, mm or degrees; 0 is not supervised.
    #[serde(default)]
    pub following_error: f64,
    /// Distance within which the axis is in position after a stop, mm or degrees; 0 is not waited for.
    #[serde(default)]
    pub in_position: f64,
    /// The same after a cutting move, where it is another.
    #[serde(default)]
    pub in_position_cutting: Option<f64>,
    /// How the axis finds its reference point.
    #[serde(default)]
    pub homing: AxisHoming,
}

impl AxisConfig {
    /// Acceleration after interpolation, by the names of the machine file: positioning, cutting, by hand, by handwheel.
    pub fn smoothing(&self) -> [(&'static str, Smoothing); 4] {
        [
            ("after_rapid", self.after_rapid),
            ("after_cutting", self.after_cutting),
            ("after_jog", self.after_jog),
            ("after_wheel", self.after_wheel.unwrap_or(self.after_jog)),
        ]
    }
}

/// What an axis moves along.
#[derive(Clone, Copy, PartialEq, Eq, Debug, Default, Deserialize)]
#[serde(rename_all = "lowercase")]
pub enum AxisKind {
    /// A line; positions in mm.
    #[default]
    Linear,
    /// A circle; positions in degrees.
    Rotary,
}

/// The spindle of the machine file.
#[derive(Clone, Debug, PartialEq, Deserialize)]
#[serde(deny_unknown_fields)]
pub struct SpindleConfig {
    /// Highest speed, r/min.
    pub max_rpm: f64,
    /// Change of speed while it runs up or brakes, r/min per second.
    pub acceleration_rpm_s: f64,
    /// The same while a thread is tapped; the one above where it is lower.
    #[serde(default = "unlimited")]
    pub tapping_rpm_s: f64,
    /// The same on the way out of the hole.
    #[serde(default = "unlimited")]
    pub tapping_retract_rpm_s: f64,
    /// Counts of its encoder in a turn.
    #[serde(default = "default_counts")]
    pub encoder_counts: f64,
    /// How it is told its speed on a machine with a ladder.
    #[serde(default)]
    pub gears: GearConfig,
    /// Rigid tapping in each gear, the first one first; empty where the keys above hold for all of them.
    #[serde(skip)]
    pub tapping: Vec<TappingGear>,
}

/// Rigid tapping in a gear of the spindle.
#[derive(Clone, Copy, PartialEq, Debug)]
pub struct TappingGear {
    /// Highest speed, r/min.
    pub max_rpm: f64,
    /// Counts of the encoder in a turn of the spindle.
    pub encoder_counts: f64,
    /// Acceleration on the way in and on the way out, r/min per second.
    pub rpm_s: [f64; 2],
}

impl SpindleConfig {
    /// Rigid tapping in a gear, counted from 1. A gear that is not known taps as the first.
    pub fn tapping_in(&self, gear: u8) -> TappingGear {
        let of_keys = TappingGear {
            max_rpm: f64::INFINITY,
            encoder_counts: self.encoder_counts,
            rpm_s: [self.tapping_rpm_s, self.tapping_retract_rpm_s],
        };
        let of_gear =
            usize::from(gear).checked_sub(1).and_then(|n| self.tapping.get(n)).or(self.tapping.first());
        let found = of_gear.copied().unwrap_or(of_keys);
        TappingGear { rpm_s: found.rpm_s.map(|rate| rate.min(self.acceleration_rpm_s)), ..found }
    }
}

impl Default for SpindleConfig {
    fn default() -> SpindleConfig {
        SpindleConfig {
            max_rpm: 6000.0,
            acceleration_rpm_s: 4000.0,
            tapping_rpm_s: unlimited(),
            tapping_retract_rpm_s: unlimited(),
            encoder_counts: default_counts(),
            gears: GearConfig::default(),
            tapping: Vec::new(),
        }
    }
}

/// The tool changer of the machine file.
#[derive(Clone, Debug, PartialEq, Deserialize)]
#[serde(deny_unknown_fields)]
pub struct ToolChangeConfig {
    /// Time of a tool change with the spindle at rest, s.
    pub time_s: f64,
    /// Places in the magazine; 0 is not checked.
    #[serde(default)]
    pub tools: u32,
    /// Number of the program that M06 runs on a machine with a ladder; 0 where the ladder itself changes the tool by M06.
    #[serde(default)]
    pub program: Option<u32>,
    /// File with that program as it comes with the machine, beside its own file.
    #[serde(default)]
    pub file: Option<String>,
}

impl Default for ToolChangeConfig {
    fn default() -> ToolChangeConfig {
        ToolChangeConfig { time_s: 5.0, tools: 0, program: None, file: None }
    }
}

fn default_dialect() -> String {
    "gsk990mc".to_owned()
}

fn default_period() -> f64 {
    1.0
}

/// 1024 lines, four counts each (GSK990MC P261).
fn default_counts() -> f64 {
    4096.0
}

fn unlimited() -> f64 {
    f64::INFINITY
}

pub(crate) fn axis_letter<'de, D: serde::Deserializer<'de>>(from: D) -> Result<Axis, D::Error> {
    let name = String::deserialize(from)?;
    let axis = match name.as_bytes() {
        [letter] => Axis::from_letter(*letter),
        _ => None,
    };
    axis.ok_or_else(|| serde::de::Error::custom(format!("{name:?} is no axis: use one of X Y Z A B C U V W")))
}

impl Machine {
    /// Text of the machine used where none is named.
    pub const DEMO_MILL: &'static str = include_str!("../../../machines/demo-mill.toml");

    /// Text of the programs that come with it.
    pub const DEMO_PROGRAMS: &'static str = include_str!("../../../machines/public.dat");

    /// Reads a machine file and checks that every number makes a machine.
    pub fn from_toml(text: &str) -> Result<Machine, ConfigError> {
        let keys = ["[", "name", "dialect", "servo_period_ms", "public_programs", "axes"];
        let is_one = || text.lines().any(|line| keys.iter().any(|key| line.trim_start().starts_with(key)));
        let machine: Machine = toml::from_str(text).map_err(|e| match is_one() {
            true => ConfigError::toml(&e),
            // Such as a part program: what TOML has against it says nothing.
            false => ConfigError::label("label-config-no-machine"),
        })?;
        machine.check()?;
        Ok(machine)
    }

    fn check(&self) -> Result<(), ConfigError> {
        within("servo_period_ms", self.servo_period_ms, 0.25, 4.0)?;
        if self.axes.is_empty() {
            return Err(ConfigError::count("axes", 0, 1, Axis::ALL.len()));
        }
        let mut seen = AxisSet::EMPTY;
        for axis in &self.axes {
            let name = axis.name.letter();
            if seen.contains(axis.name) {
                return Err(ConfigError::twice(format!("axes {name}")));
            }
            seen = seen.with(axis.name);
            finite(&format!("axes {name}: min"), axis.min)?;
            finite(&format!("axes {name}: max"), axis.max)?;
            if axis.min >= axis.max {
                let error = ConfigError::label("label-config-order").with("what", format!("axes {name}"));
                return Err(error.with("min", axis.min).with("max", axis.max));
            }
            positive(&format!("axes {name}: rapid"), axis.rapid)?;
            positive(&format!("axes {name}: manual_rapid"), axis.manual_rapid.unwrap_or(axis.rapid))?;
            positive(&format!("axes {name}: velocity"), axis.velocity)?;
            positive(&format!("axes {name}: acceleration"), axis.acceleration)?;
            not_negative(&format!("axes {name}: jerk"), axis.jerk)?;
            not_negative(&format!("axes {name}: following_error"), axis.following_error)?;
            not_negative(&format!("axes {name}: in_position"), axis.in_position)?;
            let cutting = axis.in_position_cutting.unwrap_or(0.0);
            not_negative(&format!("axes {name}: in_position_cutting"), cutting)?;
            axis.backlash.check(&format!("axes {name}: backlash"))?;
            for (key, smoothing) in axis.smoothing() {
                smoothing.check(&format!("axes {name}: {key}"))?;
            }
            for (key, ramp) in [("before_rapid", axis.before_rapid), ("before_cutting", axis.before_cutting)]
            {
                if let Some(ramp) = ramp {
                    ramp.check(&format!("axes {name}: {key}"))?;
                }
            }
            axis.homing.check(&format!("axes {name}: homing"))?;
            if let Some(table) = &axis.pitch_errors {
                table.check(&format!("axes {name}: pitch_errors"))?;
            }
        }
        positive("spindle: max_rpm", self.spindle.max_rpm)?;
        positive("spindle: acceleration_rpm_s", self.spindle.acceleration_rpm_s)?;
        positive("spindle: encoder_counts", self.spindle.encoder_counts)?;
        for (key, rate) in [
            ("tapping_rpm_s", self.spindle.tapping_rpm_s),
            ("tapping_retract_rpm_s", self.spindle.tapping_retract_rpm_s),
        ] {
            // Without a bound of its own it is infinite.
            if rate != f64::INFINITY {
                positive(&format!("spindle: {key}"), rate)?;
            }
        }
        self.manual.check()?;
        self.homing.check()?;
        self.plant.iter().try_for_each(PlantConfig::check)?;
        self.drives.iter().try_for_each(|drives| drives.check(&self.axes, self.servo_period_ms))?;
        self.handshake.check()?;
        self.spindle.gears.check()?;
        self.restart.check()?;
        not_negative("servo: in_position_ms", self.servo.in_position_ms)?;
        not_negative("tool_change: time_s", self.tool_change.time_s)?;
        self.path.check()
    }

    /// The demo mill.
    pub fn demo_mill() -> Machine {
        // A test holds that the built-in file is good; an unreadable one leaves a machine without axes.
        Machine::from_toml(Machine::DEMO_MILL).unwrap_or_else(|_| Machine {
            name: String::new(),
            dialect: default_dialect(),
            servo_period_ms: default_period(),
            public_programs: None,
            axes: Vec::new(),
            spindle: SpindleConfig::default(),
            tool_change: ToolChangeConfig::default(),
            path: PathConfig::default(),
            servo: ServoConfig::default(),
            manual: ManualConfig::default(),
            homing: HomingConfig::default(),
            plant: None,
            drives: None,
            handshake: HandshakeConfig::default(),
            restart: RestartConfig::default(),
            parameters: Default::default(),
        })
    }

    /// The axis called `axis`, if the machine has it.
    pub fn axis(&self, axis: Axis) -> Option<&AxisConfig> {
        self.axes.iter().find(|a| a.name == axis)
    }

    /// The axes that the machine has.
    pub fn axis_set(&self) -> AxisSet {
        self.axes.iter().map(|a| a.name).collect()
    }

    /// Lower and upper software limits of every axis; infinite for axes that it lacks.
    pub fn limits(&self) -> (Position, Position) {
        let mut min = Position([f64::NEG_INFINITY; 9]);
        let mut max = Position([f64::INFINITY; 9]);
        for axis in &self.axes {
            min[axis.name] = axis.min;
            max[axis.name] = axis.max;
        }
        (min, max)
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn the_demo_mill_is_a_good_file() {
        let machine = Machine::from_toml(Machine::DEMO_MILL).unwrap();
        assert_eq!(machine.axes.len(), 4);
        assert_eq!(machine.limits().1[Axis::X], 500.0);
    }

    #[test]
    fn a_bad_file_says_what_to_change() {
        let axis = |body: &str| format!("name = \"m\"\n[[axes]]\nname = \"X\"\n{body}");
        let good = "min = 0.0\nmax = 1.0\nrapid = 1.0\nvelocity = 1.0\nacceleration = 1.0\n";
        assert!(Machine::from_toml(&axis(good)).is_ok());
        for (text, says) in [
            (axis(&good.replace("max = 1.0", "max = -1.0")), "axes X: min 0 must be below max -1"),
            (axis(&good.replace("rapid = 1.0", "rapid = 0.0")), "axes X: rapid is 0"),
            (axis(&good.replace("rapid", "rapids")), "unknown field `rapids`"),
            (axis(good).replace("\"X\"", "\"Q\""), "\"Q\" is no axis"),
            (axis(good) + "[[axes]]\nname = \"x\"\n" + good, "axes X stands twice"),
            ("name = \"m\"\naxes = []".to_owned(), "axes: there are 0"),
            (
                axis(good) + "backlash = { cutting = 7.0 }",
                "axes X: backlash: cutting is 7: it must be -5 to 5",
            ),
            (
                axis(good) + "after_cutting = { kind = \"linear\", time_ms = 2e3 }",
                "after_cutting: time_ms is 2000",
            ),
            (axis(good) + "after_jog = { kind = \"cubic\", time_ms = 2.0 }", "unknown variant `cubic`"),
            (axis(good) + "pitch_errors = { corrections = [] }", "pitch_errors: corrections: there are 0"),
            (
                axis(good) + "pitch_errors = { corrections = [0.0], opposite = [0.0, 0.1] }",
                "corrections: there are 1, and 2 of opposite",
            ),
            (axis(good) + "pitch_errors = { corrections = [nan] }", "pitch_errors: corrections is NaN"),
            (axis(good) + "following_error = -1.0", "following_error is -1"),
            (axis(good) + "before_rapid = { acceleration = 0.0 }", "before_rapid: acceleration is 0"),
            (axis(good) + "[path]\nramp = { acceleration = 1.0, jerk = -1.0 }", "path: ramp: jerk is -1"),
            (axis(good) + "[path]\ncorner = { lowest_feed = 1.0 }", "either angle or speed_difference"),
            (axis(good) + "[path]\ncorner = { angle = 200.0, lowest_feed = 1.0 }", "angle is 200"),
            (axis(good) + "[path]\narc = { acceleration = nan }", "path: arc: acceleration is NaN"),
        ] {
            let error = Machine::from_toml(&text).unwrap_err().to_string();
            assert!(error.contains(says), "{error}");
        }
    }
}
