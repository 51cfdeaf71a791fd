//! The `$` settings (Grbl 1.1, settings): some are how this connection reports, the others what the machine file says.
//!
//! A sender cannot change the machine: what its file says is shown and stays. Setting it to what it is already is
//! taken, so that a sender can write back what it read.

use super::codes::Error;
use ferrocut_machine::Machine;
use std::fmt::Write;

/// Settings that a sender may change. None of them moves an axis.
const OWN: &[(u16, f64)] = &[
    // Of step pulses and pins; there are none here.
    (0, 10.0),
    (1, 255.0),
    (2, 0.0),
    (3, 0.0),
    (4, 0.0),
    (5, 0.0),
    (6, 0.0),
    (10, 1.0),
    (11, 0.01),
    (12, 0.002),
    (13, 0.0),
];

/// `$10`: machine positions, else work positions.
const MACHINE_POSITIONS: u16 = 1;

/// `$10`: the room in the buffers.
const BUFFERS: u16 = 2;

/// Characters of a start line.
const LONGEST_START_LINE: usize = 70;

/// The settings of a connection.
#[derive(Clone, PartialEq, Debug)]
pub struct Settings {
    own: Vec<(u16, f64)>,
    machine: Vec<(u16, f64)>,
    /// `$N0` and `$N1`.
    pub start_lines: [String; 2],
    /// `$I=`
    pub name: String,
}

impl Settings {
    /// Those of a machine, whose axes are shown in this order.
    pub fn new(machine: &Machine, axes: &[u8]) -> Settings {
        let homing = machine.axes.iter().map(|axis| axis.rapid).fold(f64::INFINITY, f64::min);
        let mut all = vec![
            // Software limits and homing are on, always.
            (20, 1.0),
            (21, 1.0),
            (22, 1.0),
            (23, 0.0),
            (24, homing / 10.0),
            (25, homing),
            (26, 0.0),
            (27, 0.0),
            (30, machine.spindle.max_rpm),
            (31, 0.0),
            (32, 0.0),
        ];
        let of = |letter: u8| machine.axes.iter().find(|axis| axis.name.letter() as u32 == u32::from(letter));
        for (at, letter) in (0u16..).zip(axes) {
            let Some(axis) = of(*letter) else { continue };
            all.push((100 + at, 1000.0));
            all.push((110 + at, axis.rapid));
            all.push((120 + at, axis.acceleration));
            all.push((130 + at, axis.max - axis.min));
        }
        all.sort_by_key(|(number, _)| *number);
        Settings { own: OWN.to_vec(), machine: all, start_lines: Default::default(), name: String::new() }
    }

    /// The value of a setting.
    pub fn get(&self, number: u16) -> Option<f64> {
        self.own.iter().chain(&self.machine).find(|(own, _)| *own == number).map(|(_, value)| *value)
    }

    /// Sets one (`$number=value`).
    pub fn set(&mut self, number: u16, value: f64) -> Result<(), Error> {
        if value < 0.0 {
            return Err(Error::NEGATIVE);
        }
        if let Some((_, own)) = self.own.iter_mut().find(|(own, _)| *own == number) {
            *own = value;
            return Ok(());
        }
        match self.machine.iter().find(|(own, _)| *own == number) {
            // As far as it is shown.
            Some((_, own)) if (own - value).abs() < 0.001 => Ok(()),
            Some(_) => Err(Error::SETTING),
            None => Err(Error::NO_COMMAND),
        }
    }

    /// Back to what they were (`$RST=`).
    pub fn restore(&mut self) {
        self.own = OWN.to_vec();
    }

    /// No start lines and no name (`$RST=*`).
    pub fn forget_texts(&mut self) {
        self.start_lines = Default::default();
        self.name.clear();
    }

    /// Sets a start line (`$N0=`), which was found right.
    pub fn set_start_line(&mut self, number: usize, line: String) -> Result<(), Error> {
        match self.start_lines.get_mut(number) {
            Some(_) if line.len() > LONGEST_START_LINE => Err(Error::START_LINE),
            Some(place) => {
                *place = line;
                Ok(())
            }
            None => Err(Error::NO_COMMAND),
        }
    }

    /// Sets the name shown by `$I`.
    pub fn set_name(&mut self, name: &str) -> Result<(), Error> {
        if name.len() > LONGEST_START_LINE {
            return Err(Error::START_LINE);
        }
        self.name = name.to_owned();
        Ok(())
    }

    fn mask(&self) -> u16 {
        self.get(10).unwrap_or(0.0) as u16
    }

    /// Positions are those of the machine.
    pub fn shows_machine(&self) -> bool {
        self.mask() & MACHINE_POSITIONS != 0
    }

    /// The room in the buffers is shown.
    pub fn shows_buffers(&self) -> bool {
        self.mask() & BUFFERS != 0
    }

    /// Lengths are shown in inches.
    pub fn is_inch(&self) -> bool {
        self.get(13).is_some_and(|value| value != 0.0)
    }

    /// `$$`: one a line.
    pub fn list(&self, out: &mut String) {
        let mut all: Vec<_> = self.own.iter().chain(&self.machine).copied().collect();
        all.sort_by_key(|(number, _)| *number);
        for (number, value) in all {
            // Whole ones have no point, but for those that are measures (Grbl 1.1, interface).
            let _ = match number {
                11 | 12 | 24 | 25 | 27 | 100.. => write!(out, "${number}={value:.3}\r\n"),
                _ => write!(out, "${number}={}\r\n", value.round()),
            };
        }
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn the_machine_is_as_its_file_says_and_stays_so() {
        let mut settings = Settings::new(&Machine::demo_mill(), b"XYZ");
        let mut list = String::new();
        settings.list(&mut list);
        for line in ["$10=1\r\n", "$11=0.010\r\n", "$13=0\r\n", "$22=1\r\n", "$100=1000.000\r\n"] {
            assert!(list.contains(line), "{line} {list}");
        }
        let rapid = Machine::demo_mill().axes[0].rapid;
        assert_eq!(settings.get(110), Some(rapid));
        assert_eq!((settings.set(110, rapid), settings.set(110, 1.0)), (Ok(()), Err(Error::SETTING)));
        assert_eq!((settings.set(10, -1.0), settings.set(77, 1.0)), (Err(Error(4)), Err(Error(3))));
        settings.set(10, 2.0).unwrap();
        assert!(!settings.shows_machine() && settings.shows_buffers());
        settings.restore();
        assert!(settings.shows_machine());
    }
}
