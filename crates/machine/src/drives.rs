//! The drives of a real machine: where they are, and what each axis of them is like. Plain data; the controller's
//! `drives/pulse` speaks with them.
//!
//! Without `[drives]` the machine is simulated.

use crate::config::{AxisConfig, axis_letter};
use crate::config_error::{ConfigError, within};
use ferrocut_geometry::Axis;
use serde::Deserialize;
use std::fmt;
use std::str::FromStr;

/// `[drives]` of the machine file.
#[derive(Clone, Debug, PartialEq, Deserialize)]
#[serde(tag = "kind", rename_all = "lowercase")]
pub enum DrivesConfig {
    /// Step and direction, made by a board that is told positions (`docs/pulse-protocol.md`).
    Pulse(PulseConfig),
}

/// A board that makes step and direction signals.
#[derive(Clone, Debug, PartialEq, Deserialize)]
#[serde(deny_unknown_fields)]
pub struct PulseConfig {
    /// Where it is.
    pub link: LinkAt,
    /// Setpoints that wait in the board before the first is run: so many periods may be late.
    #[serde(default = "default_buffer")]
    pub buffer: u16,
    /// Time without a word after which either side stops, ms.
    #[serde(default = "default_watchdog")]
    pub watchdog_ms: f64,
    /// The places of the axes are known when power comes.
    #[serde(default)]
    pub absolute: bool,
    /// A probe is connected.
    #[serde(default)]
    pub probe: bool,
    /// Its input carries current while it touches nothing; else while it touches. What is not said is as the parameters
    /// have it.
    #[serde(default)]
    pub probe_opens: Option<bool>,
    /// Bytes X that the general inputs of the board are, its first eight first.
    #[serde(default)]
    pub inputs: Vec<u16>,
    /// Bytes Y that its general outputs are.
    #[serde(default)]
    pub outputs: Vec<u16>,
    /// Its axes, in the order of its connectors.
    pub axes: Vec<PulseAxis>,
}

/// An axis that is stepped.
#[derive(Clone, Debug, PartialEq, Deserialize)]
#[serde(deny_unknown_fields)]
pub struct PulseAxis {
    /// Its letter.
    #[serde(deserialize_with = "axis_letter")]
    pub name: Axis,
    /// Steps in a mm or degree.
    pub steps: f64,
    /// The direction signal is the other way round.
    #[serde(default)]
    pub reversed: bool,
    /// Least length of a step pulse, ns.
    #[serde(default = "default_pulse")]
    pub pulse_ns: u32,
    /// Least time between two of them, ns.
    #[serde(default = "default_pulse")]
    pub space_ns: u32,
    /// Least time from a change of direction to the next step, ns.
    #[serde(default = "default_setup")]
    pub setup_ns: u32,
    /// Least time from a step to a change of direction, ns.
    #[serde(default = "default_setup")]
    pub hold_ns: u32,
    /// Travel switches are connected, which open where they are reached.
    #[serde(default)]
    pub limits: bool,
}

/// Where a board is.
#[derive(Clone, Debug, PartialEq, Eq)]
pub enum LinkAt {
    /// `udp:HOST:PORT`
    Udp(String),
    /// `tcp:HOST:PORT`
    Tcp(String),
    /// `serial:PATH:BAUD`
    Serial(String, u32),
}

/// Most axes of a board.
pub const PULSE_AXES: usize = 9;
/// Most bytes of general inputs, and of outputs.
pub const PULSE_BYTES: usize = 8;
/// Longest buffer, periods.
const LONGEST_BUFFER: u16 = 1000;

fn default_buffer() -> u16 {
    4
}

fn default_watchdog() -> f64 {
    20.0
}

/// What most drives are content with.
fn default_pulse() -> u32 {
    2_500
}

fn default_setup() -> u32 {
    5_000
}

impl FromStr for LinkAt {
    type Err = String;

    fn from_str(text: &str) -> Result<LinkAt, String> {
        let wrong = || {
            format!("{text:?} is no link: use \"udp:HOST:PORT\", \"tcp:HOST:PORT\" or \"serial:PATH:BAUD\"")
        };
        let (kind, place) = text.split_once(':').ok_or_else(wrong)?;
        let (host, number) = place.rsplit_once(':').filter(|(host, _)| !host.is_empty()).ok_or_else(wrong)?;
        let is_port = number.parse::<u16>().is_ok_and(|port| port > 0);
        match kind {
            "udp" if is_port => Ok(LinkAt::Udp(place.to_owned())),
            "tcp" if is_port => Ok(LinkAt::Tcp(place.to_owned())),
            "serial" => {
                let baud = number.parse().ok().filter(|baud| *baud > 0).ok_or_else(wrong)?;
                Ok(LinkAt::Serial(host.to_owned(), baud))
            }
            _ => Err(wrong()),
        }
    }
}

impl fmt::Display for LinkAt {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        match self {
            LinkAt::Udp(place) => write!(f, "udp:{place}"),
            LinkAt::Tcp(place) => write!(f, "tcp:{place}"),
            LinkAt::Serial(path, baud) => write!(f, "serial:{path}:{baud}"),
        }
    }
}

impl<'de> Deserialize<'de> for LinkAt {
    fn deserialize<D: serde::Deserializer<'de>>(from: D) -> Result<LinkAt, D::Error> {
        String::deserialize(from)?.parse().map_err(serde::de::Error::custom)
    }
}

impl AxisConfig {
    /// Highest speed at which it is ever moved, mm/s or degrees/s.
    pub fn top_speed(&self) -> f64 {
        self.rapid.max(self.velocity).max(self.manual_rapid.unwrap_or(0.0)) / 60.0
    }
}

impl DrivesConfig {
    /// Whether it fits a machine with these axes and this servo period.
    pub(crate) fn check(&self, axes: &[AxisConfig], period_ms: f64) -> Result<(), ConfigError> {
        let DrivesConfig::Pulse(pulse) = self;
        pulse.check(axes, period_ms)
    }
}

impl PulseConfig {
    fn check(&self, axes: &[AxisConfig], period_ms: f64) -> Result<(), ConfigError> {
        within("drives: buffer", f64::from(self.buffer), 1.0, f64::from(LONGEST_BUFFER))?;
        within("drives: watchdog_ms", self.watchdog_ms, 2.0 * period_ms, 10_000.0)?;
        if self.axes.is_empty() || self.axes.len() > PULSE_AXES {
            return Err(ConfigError::count("drives: axes", self.axes.len(), 1, PULSE_AXES));
        }
        for (key, bytes) in [("inputs", &self.inputs), ("outputs", &self.outputs)] {
            if bytes.len() > PULSE_BYTES {
                return Err(ConfigError::count(format!("drives: {key}"), bytes.len(), 0, PULSE_BYTES));
            }
        }
        for (number, pulse) in self.axes.iter().enumerate() {
            let name = format!("drives: axes {}", pulse.name.letter());
            let Some(axis) = axes.iter().find(|axis| axis.name == pulse.name) else {
                return Err(ConfigError::label("label-config-no-axis").with("what", name));
            };
            if self.axes.iter().take(number).any(|other| other.name == pulse.name) {
                return Err(ConfigError::twice(name));
            }
            within(&format!("{name}: steps"), pulse.steps, 1e-3, 1e7)?;
            for (key, ns) in [
                ("pulse_ns", pulse.pulse_ns),
                ("space_ns", pulse.space_ns),
                ("setup_ns", pulse.setup_ns),
                ("hold_ns", pulse.hold_ns),
            ] {
                within(&format!("{name}: {key}"), f64::from(ns), 0.0, 1e7)?;
            }
            // What is told and what was done differ by a step, and by what waits in the board.
            let step = 1.0 / pulse.steps;
            let window = axis.in_position_cutting.map_or(axis.in_position, |c| c.min(axis.in_position));
            if window < step {
                let in_position = format!("axes {}: in_position", pulse.name.letter());
                let error = ConfigError::label("label-config-step").with("what", in_position);
                return Err(error.with("value", window).with("min", step));
            }
            let lag = axis.top_speed() * period_ms / 1000.0 * f64::from(self.buffer + 2) + step;
            if axis.following_error > 0.0 && axis.following_error < lag {
                let following_error = format!("axes {}: following_error", pulse.name.letter());
                let error = ConfigError::label("label-config-lag").with("what", following_error);
                return Err(error.with("value", axis.following_error).with("min", lag));
            }
        }
        Ok(())
    }
}

#[cfg(test)]
mod tests {
    use crate::Machine;
    use crate::drives::{DrivesConfig, LinkAt};

    const AXIS: &str = "name = \"m\"\n[[axes]]\nname = \"X\"\nmin = 0.0\nmax = 1.0\nrapid = 6000.0\n\
                        velocity = 1.0\nacceleration = 1.0\nin_position = 0.01\nfollowing_error = 1.0\n";
    const DRIVES: &str = "[drives]\nkind = \"pulse\"\nlink = \"udp:10.0.0.2:7070\"\n\
                          axes = [{ name = \"X\", steps = 400.0 }]\n";

    #[test]
    fn a_board_is_described() {
        let machine = Machine::from_toml(&format!("{AXIS}{DRIVES}")).unwrap();
        let Some(DrivesConfig::Pulse(pulse)) = machine.drives else { panic!() };
        assert_eq!((pulse.buffer, pulse.watchdog_ms, pulse.axes[0].setup_ns), (4, 20.0, 5000));
        assert_eq!(pulse.link, LinkAt::Udp("10.0.0.2:7070".into()));
        for text in ["serial:/dev/ttyACM0:2000000", "tcp:[::1]:7070", "udp:board:1"] {
            assert_eq!(text.parse::<LinkAt>().unwrap().to_string(), text);
        }
    }

    #[test]
    fn what_cannot_be_is_refused() {
        for (from, to, says) in [
            ("udp:10.0.0.2:7070", "usb:1:2", "\"usb:1:2\" is no link"),
            ("udp:10.0.0.2:7070", "udp:7070", "is no link"),
            ("udp:10.0.0.2:7070", "serial:/dev/ttyACM0:0", "is no link"),
            ("\"pulse\"", "\"laser\"", "unknown variant `laser`"),
            ("kind =", "buffer = 0\nkind =", "buffer is 0"),
            ("kind =", "watchdog_ms = 1.0\nkind =", "watchdog_ms is 1: it must be 2 to 10000"),
            (
                "kind =",
                "inputs = [0, 1, 2, 3, 4, 5, 6, 7, 8]\nkind =",
                "inputs: there are 9, there may be 0 to 8",
            ),
            ("steps = 400.0", "steps = 0.0", "axes X: steps is 0"),
            ("steps = 400.0", "steps = 50.0", "in_position is 0.01: it must be a step, 0.02"),
            ("steps = 400.0", "steps = 400.0, hold_ns = 20000000", "hold_ns is 20000000"),
            ("steps = 400.0", "steps = 400.0, colour = 1", "unknown field"),
            ("{ name = \"X\"", "{ name = \"Y\"", "axes Y: the machine has no such axis"),
            ("}]", "}, { name = \"X\", steps = 1e3 }]", "axes X stands twice"),
            // 100 mm/s, 12 periods.
            ("kind =", "buffer = 10\nkind =", "following_error is 1: at its highest speed the axis is 1.2"),
        ] {
            let text = format!("{AXIS}{}", DRIVES.replace(from, to));
            let error = Machine::from_toml(&text).unwrap_err().to_string();
            assert!(error.contains(says), "{error}");
        }
    }
}
