//! How a machine with a ladder hands its codes over and tells its spindle a speed. Plain data; `ferrocut-controller`
//! has what it does.
//!
//! A control that has parameters for these things writes them over what the machine file says
//! (`Dialect::machine_parameters` of the interpreter).

use crate::config_error::{ConfigError, within};
use serde::Deserialize;

/// How M, S, T and B codes are handed to the ladder.
#[derive(Clone, Debug, PartialEq, Deserialize)]
#[serde(default, deny_unknown_fields)]
pub struct HandshakeConfig {
    /// Time from a code to its strobe, ms (Fanuc 3010).
    pub strobe_delay_ms: f64,
    /// How long FIN must be on to count, ms (GSK990MC P202, Fanuc 3011).
    pub finish_width_ms: f64,
    /// How long a code may take, s; longer is an alarm. 0 waits for ever.
    pub time_out_s: f64,
    /// Each change of a strobe is a code, and its own finish signal follows it (Fanuc 3001#7).
    pub high_speed: bool,
    /// M codes that the ladder knows and the language does not: they are handed over as they are, up to 999.
    pub m_codes: Vec<u16>,
}

impl Default for HandshakeConfig {
    fn default() -> HandshakeConfig {
        // 16 ms are what the Fanuc 0i takes where its parameter is 0.
        HandshakeConfig {
            strobe_delay_ms: 16.0,
            finish_width_ms: 0.0,
            time_out_s: 60.0,
            high_speed: false,
            m_codes: Vec::new(),
        }
    }
}

impl HandshakeConfig {
    /// What cannot be.
    pub(crate) fn check(&self) -> Result<(), ConfigError> {
        let values = [
            ("strobe_delay_ms", self.strobe_delay_ms, 1e4),
            ("finish_width_ms", self.finish_width_ms, 1e4),
            ("time_out_s", self.time_out_s, 1e5),
        ];
        let codes = self.m_codes.iter().map(|code| ("m_codes", f64::from(*code), 999.0));
        let mut values = values.into_iter().chain(codes);
        values.try_for_each(|(key, value, most)| within(&format!("handshake: {key}"), value, 0.0, most))
    }
}

/// Gears of the spindle, and what becomes of its speed on the way to the drive.
#[derive(Clone, Debug, PartialEq, Deserialize)]
#[serde(default, deny_unknown_fields)]
pub struct GearConfig {
    /// Highest speed in each gear, r/min, the lowest gear first; a gear of 0 is not there (GSK990MC P246 to P249).
    pub max_rpm: [f64; 4],
    /// The ladder says which gear is engaged; else the NC chooses it by the speed (GSK990MC 38#5).
    pub chosen_by_ladder: bool,
    /// S is the number of a gear, and no speed is told (GSK990MC 1#2).
    pub switched: bool,
    /// Speed of spindle jog, r/min (GSK990MC P242).
    pub jog_rpm: f64,
    /// Lowest spindle override, as a factor (GSK990MC P262).
    pub least_override: f64,
    /// Cutting waits until the ladder says that the spindle has its speed (GSK990MC 38#0).
    pub cutting_waits: bool,
    /// The highest speed of G96 holds behind the override; else before it (GSK990MC 37#3).
    pub clamped_behind_override: bool,
    /// In positioning the speed of G96 follows the axes; else it is that of the end point (GSK990MC 37#2).
    pub surface_follows_rapid: bool,
}

impl Default for GearConfig {
    fn default() -> GearConfig {
        GearConfig {
            max_rpm: [0.0; 4],
            chosen_by_ladder: false,
            switched: false,
            jog_rpm: 50.0,
            least_override: 0.5,
            cutting_waits: false,
            clamped_behind_override: false,
            surface_follows_rapid: false,
        }
    }
}

impl GearConfig {
    /// The gear for a speed in r/min: the lowest one that has it (GSK990MC part 2, 4.2.4: three of them are chosen by
    /// speed), or the number that S is (part 1, 6.2: its last two digits). None where the ladder chooses,
    /// and for an S that is no gear.
    pub fn of_speed(&self, rpm: f64) -> Option<u8> {
        let [first, second, third, _] = self.max_rpm;
        match rpm {
            _ if self.chosen_by_ladder => None,
            _ if self.switched => Some((rpm.max(0.0) % 100.0) as u8).filter(|gear| (1..=3).contains(gear)),
            _ if rpm <= first || second <= 0.0 => Some(1),
            _ if rpm <= second || third <= 0.0 => Some(2),
            _ => Some(3),
        }
    }

    /// What cannot be.
    pub(crate) fn check(&self) -> Result<(), ConfigError> {
        self.max_rpm.into_iter().try_for_each(|rpm| within("spindle: gears: max_rpm", rpm, 0.0, 1e6))?;
        within("spindle: gears: jog_rpm", self.jog_rpm, 0.0, 1e6)?;
        within("spindle: gears: least_override", self.least_override, 0.0, 1.0)
    }
}
