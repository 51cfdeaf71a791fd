//! Outputs that programs set themselves: by variables (GSK990MC 4.9.2), or by number (LinuxCNC M codes: M62 to M65, M67,
//! M68).

use super::Cnc;
use ferrocut_toolpath::Port;

/// Outputs of each kind (LinuxCNC, motmod: num_dio and num_aio are 64 at most). Others change nothing.
const PORTS: usize = 64;

/// One output, or the word of all that have variables.
#[derive(Clone, Copy, PartialEq, Eq, Debug)]
enum Place {
    Digital(usize),
    Analog(usize),
    /// Digital outputs 0 to 15 at once.
    Word,
}

impl Place {
    /// Where an output stands; none for one that the machine does not have. #1100 to #1115 are the digital outputs from 0
    /// on, and #1132 is all of these (GSK990MC 4.9.2).
    fn of(port: &Port) -> Option<Place> {
        let number = |number: i64| usize::try_from(number).ok().filter(|number| *number < PORTS);
        match port {
            Port::Digital(digital) => number(*digital).map(Place::Digital),
            Port::Analog(analog) => number(*analog).map(Place::Analog),
            Port::Named(name) => match name.strip_prefix('#')?.parse().ok()? {
                variable @ 1100..=1115 => Some(Place::Digital(variable - 1100)),
                1132 => Some(Place::Word),
                _ => None,
            },
        }
    }
}

/// The outputs. A reset leaves them as they are.
#[derive(Debug)]
pub(super) struct ProgramOutputs {
    digital: u64,
    analog: [f64; PORTS],
}

impl Default for ProgramOutputs {
    fn default() -> ProgramOutputs {
        ProgramOutputs { digital: 0, analog: [0.0; PORTS] }
    }
}

impl ProgramOutputs {
    /// Digital outputs 0 to 15 from bit 0 on.
    pub fn word(&self) -> u16 {
        self.digital as u16
    }

    /// Sets an output now.
    pub fn set(&mut self, port: &Port, value: f64) {
        match Place::of(port) {
            None => {}
            Some(Place::Digital(number)) if value == 0.0 => self.digital &= !(1 << number),
            Some(Place::Digital(number)) => self.digital |= 1 << number,
            Some(Place::Analog(number)) => {
                if let Some(analog) = self.analog.get_mut(number) {
                    *analog = value;
                }
            }
            Some(Place::Word) => {
                let word = value.clamp(0.0, f64::from(u16::MAX)) as u16;
                self.digital = self.digital & !u64::from(u16::MAX) | u64::from(word);
            }
        }
    }
}

impl Cnc {
    /// Whether a digital output of programs is on, counted from 0.
    pub fn digital_output(&self, number: usize) -> bool {
        number < PORTS && self.program_outputs.digital >> number & 1 == 1
    }

    /// Value of an analog output of programs, counted from 0.
    pub fn analog_output(&self, number: usize) -> f64 {
        self.program_outputs.analog.get(number).copied().unwrap_or(0.0)
    }
}
