//! How the axes come back to the place where a program is taken up again.

use crate::config::Machine;
use crate::config_error::{ConfigError, not_negative};
use ferrocut_geometry::Axis;
use serde::{Deserialize, Deserializer};

/// The way to a restart, of the machine file.
#[derive(Clone, Debug, PartialEq, Default, Deserialize)]
#[serde(default, deny_unknown_fields)]
pub struct RestartConfig {
    /// Letters of the axes, the first to move first; where none are given the tool comes down last: all others
    /// as the machine file has them, then Z.
    #[serde(deserialize_with = "letters")]
    pub order: Vec<Axis>,
    /// Speed, mm/min or degrees/min, within that of the axis; 0 is that of positioning.
    pub speed: f64,
    /// Z moves at cutting feed, under the feed override; else it is positioned.
    pub cuts_z: bool,
}

fn letters<'de, D: Deserializer<'de>>(deserializer: D) -> Result<Vec<Axis>, D::Error> {
    let text = String::deserialize(deserializer)?;
    let wrong = |c: char| serde::de::Error::custom(format!("{c:?} is no axis"));
    text.chars()
        .map(|c| Axis::from_letter(c as u8).filter(|_| c.is_ascii()).ok_or_else(|| wrong(c)))
        .collect()
}

impl RestartConfig {
    pub(crate) fn check(&self) -> Result<(), ConfigError> {
        not_negative("restart: speed", self.speed)
    }

    /// The machine's axes in their order; none where one is left out or comes twice.
    pub fn order_of(&self, machine: &Machine) -> Option<Vec<Axis>> {
        let own = || machine.axes.iter().map(|axis| axis.name);
        if self.order.is_empty() {
            return Some(own().filter(|a| *a != Axis::Z).chain(own().filter(|a| *a == Axis::Z)).collect());
        }
        let order: Vec<Axis> =
            self.order.iter().copied().filter(|axis| machine.axis(*axis).is_some()).collect();
        let once = |axis| order.iter().filter(|other| **other == axis).count() == 1;
        own().all(once).then_some(order)
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn each_axis_of_the_machine_moves_once() {
        let machine = Machine::demo_mill();
        let order = |letters: &str| {
            let order = letters.bytes().filter_map(Axis::from_letter).collect();
            let config = RestartConfig { order, ..RestartConfig::default() };
            config.order_of(&machine).map(|axes| axes.iter().map(|a| a.letter()).collect::<String>())
        };
        let all: String = machine.axes.iter().map(|a| a.name.letter()).collect();
        assert_eq!(order("").map(|o| o.chars().last()), Some(Some('Z')));
        assert_eq!(order("").map(|o| o.len()), Some(all.len()));
        let turned: String = all.chars().rev().collect();
        assert_eq!(order(&turned), Some(turned.clone()));
        // Letters of axes that the machine lacks are nothing.
        assert_eq!(order(&format!("W{turned}")), Some(turned.clone()));
        assert_eq!(order(&format!("{turned}X")), None);
        assert_eq!(order("X"), None);
    }

    #[test]
    fn the_machine_file_has_it() {
        let with = |text: &str| Machine::from_toml(&format!("{}\n{text}", Machine::DEMO_MILL));
        let restart = with("[restart]\norder = \"ZXY\"\nspeed = 2000\ncuts_z = true").unwrap().restart;
        assert_eq!(
            restart,
            RestartConfig { order: vec![Axis::Z, Axis::X, Axis::Y], speed: 2000.0, cuts_z: true }
        );
        for wrong in ["order = \"XQ\"", "order = \"XÄ\"", "speed = -1", "speed = nan", "other = 1"] {
            assert!(with(&format!("[restart]\n{wrong}")).is_err(), "{wrong}");
        }
    }
}
