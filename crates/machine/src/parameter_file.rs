//! The parameter file of LinuxCNC: what its numbered parameters hold when a program starts.
//!
//! A line is a number and a value, parted by blanks. Some parameters are other names of what every control
//! remembers: 5161 to 5169 and 5181 to 5189 the positions of G28 and G30, 5221 to 5390 the zeros of G54 to
//! G59.3, ten for each: XYZABCUVW and the rotation (LinuxCNC, numbered parameters). They are lengths in the
//! units of the machine, which is metric here.

use crate::config_error::ConfigError;
use crate::memory::Memory;
use crate::offsets::WorkOffset;
use ferrocut_geometry::{Axis, Position};

/// Numbers are 1 to this one.
const LAST: u32 = 5602;

/// Axes in the order of their parameters.
const AXES: [Axis; 9] = [Axis::X, Axis::Y, Axis::Z, Axis::A, Axis::B, Axis::C, Axis::U, Axis::V, Axis::W];

/// Distance of the first parameters of two coordinate systems.
const STEP: u32 = 20;

/// A parameter file.
#[derive(Clone, PartialEq, Debug, Default)]
pub struct ParameterFile {
    values: Vec<(u32, f64)>,
}

impl ParameterFile {
    /// Reads a parameter file. The error names the line.
    pub fn from_var(text: &str) -> Result<ParameterFile, ConfigError> {
        let mut values = Vec::new();
        let wrong =
            |line: usize| ConfigError::label("label-config-var-line").with("line", line).with("max", LAST);
        for (number, line) in (1usize..).zip(text.lines()) {
            let mut words = line.split_whitespace();
            let (Some(name), value, None) = (words.next(), words.next(), words.next()) else {
                if line.trim().is_empty() {
                    continue;
                }
                return Err(wrong(number));
            };
            let name = name.parse::<u32>().ok().filter(|n| (1..=LAST).contains(n));
            let value = value.and_then(|v| v.parse::<f64>().ok()).filter(|v| v.is_finite());
            let (Some(name), Some(value)) = (name, value) else {
                return Err(wrong(number));
            };
            values.push((name, value));
        }
        Ok(ParameterFile { values })
    }

    /// Enters the parameters into the memory of a control.
    pub fn apply(&self, memory: &mut Memory) -> Result<(), ConfigError> {
        for &(number, value) in &self.values {
            memory
                .variables
                .set(number, Some(value))
                .map_err(|error| ConfigError::variable(format!("#{number}"), error))?;
            if let Some((place, axis)) = place(memory, number) {
                place[axis] = value;
            }
        }
        Ok(())
    }
}

/// The position that a parameter is another name of, and its axis.
fn place(memory: &mut Memory, number: u32) -> Option<(&mut Position, Axis)> {
    let (first, position) = match number {
        5161..=5169 => (5161, memory.reference_points.first_mut()?),
        5181..=5189 => (5181, memory.reference_points.get_mut(1)?),
        5221..=5389 => {
            let system = (number - 5221) / STEP;
            let name = match u8::try_from(system + 1).ok()? {
                standard @ 1..=6 => WorkOffset::Standard(standard),
                further => WorkOffset::Additional(u16::from(further) - 6),
            };
            (5221 + system * STEP, memory.work.get_mut(name)?)
        }
        _ => return None,
    };
    let axis = AXES.get(usize::try_from(number - first).ok()?)?;
    Some((position, *axis))
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn parameters_and_what_they_are_other_names_of() {
        let text =
            "31\t1.5\n5161\t-3.000000\r\n5183 2\n\n5220\t2.0\n5221\t10.5\n5230\t30\n5243\t-7\n5389 4\n";
        let mut memory = Memory::new("rs274");
        ParameterFile::from_var(text).unwrap().apply(&mut memory).unwrap();
        assert_eq!(memory.variables.get(31), Some(1.5));
        assert_eq!(memory.variables.get(5230), Some(30.0));
        assert_eq!(memory.reference_points[0][Axis::X], -3.0);
        assert_eq!(memory.reference_points[1][Axis::Z], 2.0);
        assert_eq!(memory.work.standard[0], Position::xyz(10.5, 0.0, 0.0));
        assert_eq!(memory.work.standard[1], Position::xyz(0.0, 0.0, -7.0));
        assert_eq!(memory.work.additional[2][Axis::W], 4.0);
    }

    #[test]
    fn what_is_no_parameter_file_is_told_with_its_line() {
        for text in ["\n5221", "\n0 1", "\n5603 1", "\n5221 x", "\n5221 1 2", "\n5221 inf", "\n-1 2"] {
            let error = ParameterFile::from_var(text).unwrap_err().to_string();
            assert!(error.starts_with("line 2:"), "{text:?}: {error}");
        }
    }
}
