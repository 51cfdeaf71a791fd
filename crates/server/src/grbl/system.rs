//! `$` commands (Grbl 1.1, commands).

use super::codes::{AlarmCode, Error};
use super::front::{Grbl, Lock};
use super::machine::{Doing, Machine};
use super::report::{self, PLANNER, RECEIVE};
use std::fmt::Write;

/// `$`
const HELP: &str = "[HLP:$$ $# $G $I $N $x=val $Nx=line $J=line $SLP $C $X $H ~ ! ? ctrl-x]\r\n";

impl Grbl {
    /// Does a command, which stands behind `$`; `None` where it is answered later.
    pub(super) fn command(&mut self, command: &[u8], machine: &mut dyn Machine) -> Option<Result<(), Error>> {
        let doing = machine.status().doing;
        if self.lock == Lock::Sleep {
            return Some(Err(Error::LOCKED));
        }
        if matches!(self.lock, Lock::Alarm(code) if code.is_critical()) {
            // Only a reset is taken.
            return Some(Err(Error::LOCKED));
        }
        let is_moving = !matches!(doing, Doing::Idle | Doing::Alarm);
        Some(match command {
            b"" => {
                self.out.push_str(HELP);
                Ok(())
            }
            b"$" if is_moving => Err(Error::NOT_IDLE),
            b"$" => {
                self.settings.list(&mut self.out);
                Ok(())
            }
            b"G" => {
                let is_inch = self.settings.is_inch();
                report::codes(&mut self.out, &machine.status().modal, self.tool, is_inch);
                Ok(())
            }
            b"C" if self.lock == Lock::Check => {
                // The answer stands before the greeting of the reset.
                self.out.push_str("[MSG:Disabled]\r\nok\r\n");
                self.reset(machine);
                return None;
            }
            b"C" if self.lock != Lock::Free || doing != Doing::Idle => Err(Error::NOT_IDLE),
            b"C" => {
                machine.end_check();
                self.lock = Lock::Check;
                self.out.push_str("[MSG:Enabled]\r\n");
                Ok(())
            }
            b"X" | b"H" if self.pins.door => Err(Error::DOOR),
            b"X" => {
                if let Lock::Alarm(_) = self.lock {
                    self.out.push_str("[MSG:Caution: Unlocked]\r\n");
                    self.unlock(machine);
                }
                Ok(())
            }
            [b'J', b'=', jog @ ..] => self.jog(jog, machine),
            [b'J', ..] => Err(Error::JOG),
            _ if is_moving || matches!(self.lock, Lock::Check | Lock::Door { .. }) => Err(Error::NOT_IDLE),
            b"H" => {
                self.home(machine);
                return None;
            }
            b"SLP" => {
                self.out.push_str("[MSG:Sleeping]\r\n");
                machine.stop_spindle(true);
                self.lock = Lock::Sleep;
                Ok(())
            }
            b"#" => {
                self.reporter.offsets(&mut self.out, machine.status(), &self.settings);
                Ok(())
            }
            b"I" => {
                let name = &self.settings.name;
                let _ = write!(self.out, "[VER:1.1h.20190830:{name}]\r\n[OPT:VNM,{PLANNER},{RECEIVE}]\r\n");
                Ok(())
            }
            [b'I', b'=', name @ ..] => self.settings.set_name(&String::from_utf8_lossy(name)),
            b"N" => {
                for (number, line) in self.settings.start_lines.iter().enumerate() {
                    let _ = write!(self.out, "$N{number}={line}\r\n");
                }
                Ok(())
            }
            [b'N', number @ b'0'..=b'1', b'=', line @ ..] => {
                self.set_start_line(usize::from(*number - b'0'), line)
            }
            b"RST=#" | b"RST=*" if doing != Doing::Idle => Err(Error::NOT_IDLE),
            b"RST=$" | b"RST=#" | b"RST=*" => {
                if command != b"RST=#" {
                    self.settings.restore();
                }
                if command == b"RST=*" {
                    self.settings.forget_texts();
                }
                if command != b"RST=$" {
                    self.clear_offsets(machine);
                }
                self.out.push_str("[MSG:Restoring defaults]\r\n");
                Ok(())
            }
            setting => self.set(setting),
        })
    }

    fn set_start_line(&mut self, number: usize, line: &[u8]) -> Result<(), Error> {
        if matches!(self.lock, Lock::Alarm(code) if code != AlarmCode::NotHomed) {
            return Err(Error::NOT_IDLE);
        }
        self.checks(line)?;
        self.settings.set_start_line(number, String::from_utf8_lossy(line).into_owned())
    }

    /// `$number=value`
    fn set(&mut self, setting: &[u8]) -> Result<(), Error> {
        let text = std::str::from_utf8(setting).map_err(|_| Error::NO_COMMAND)?;
        let (number, value) = text.split_once('=').ok_or(Error::NO_COMMAND)?;
        let number = number.parse().map_err(|_| Error::NO_COMMAND)?;
        let value = value.parse::<f64>().ok().filter(|v| v.is_finite()).ok_or(Error::NO_NUMBER)?;
        self.settings.set(number, value)
    }
}
