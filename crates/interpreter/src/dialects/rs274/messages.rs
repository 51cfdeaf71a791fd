//! Comments that are commands: `MSG`, `print` and `debug` (LinuxCNC, messages). Files are not written: `log`
//! and its like are refused.

use crate::Fallible;
use crate::interpreter::Interpreter;
use ferrocut_machine::Fault;
use ferrocut_program::{Block, FIRST_NAMED, Page, Value};
use ferrocut_toolpath::Op;
use std::fmt::Write;

/// Characters of a text for the operator at most.
const LONGEST_TEXT: usize = 1024;

impl Interpreter {
    /// Carries out the last comment of a block, where it is a command.
    pub(super) fn ngc_comment(&mut self, page: &Page, block: &Block) -> Fallible<()> {
        let Some(word) = page.words(block).iter().rev().find(|word| word.letter == b'(') else {
            return Ok(());
        };
        let Value::Text(text) = word.value() else { return Ok(()) };
        let span = page.span(block, text.at, text.len);
        let said = self.programs.slice(span);
        let (command, rest) = said.split_once(',').unwrap_or((&said, ""));
        match command.to_ascii_lowercase().as_str() {
            "msg" => self.emit(Op::Message(rest.trim().into())),
            "print" => {
                let shown = self.with_parameters(rest);
                self.emit(Op::Message(shown.trim().into()));
            }
            "debug" if self.ngc_system_parameter(super::parameters::SHOWS_DEBUG) == Some(0.0) => {}
            "debug" => {
                let shown = self.with_parameters(rest);
                self.emit(Op::Message(shown.trim().into()));
            }
            _ => return Err(self.alarm(Fault::FilesNotWritten, span)),
        }
        Ok(())
    }

    /// A text in which `#1` and `#<name>` stand for their values, with six digits behind the point; behind `%d`
    /// as whole numbers, behind `%f` and `%.2f` with so many digits. One without a value is shown as it is
    /// written.
    fn with_parameters(&mut self, text: &str) -> String {
        let mut shown = String::new();
        let mut digits = 6;
        let mut rest = text;
        while let Some(sign) = rest.chars().next() {
            if shown.len() > LONGEST_TEXT {
                break;
            }
            let read = match sign {
                '#' => self.parameter_in_text(rest),
                '%' => {
                    if let Some((places, len)) = places(rest) {
                        digits = places;
                        rest = rest.get(len..).unwrap_or("");
                        continue;
                    }
                    None
                }
                _ => None,
            };
            match read {
                Some((value, len)) => {
                    // Writing to a text does not fail.
                    let _ = write!(shown, "{value:.digits$}");
                    rest = rest.get(len..).unwrap_or("");
                }
                None => {
                    shown.push(sign);
                    rest = rest.get(sign.len_utf8()..).unwrap_or("");
                }
            }
        }
        shown
    }

    /// The value of the parameter that a text begins with, and its length in the text.
    fn parameter_in_text(&mut self, text: &str) -> Option<(f64, usize)> {
        let name = text.strip_prefix('#')?;
        if let Some(name) = name.strip_prefix('<') {
            let (name, _) = name.split_once('>')?;
            let clean: String =
                name.chars().filter(|c| !c.is_whitespace()).collect::<String>().to_lowercase();
            let value = match self.programs.names().known(&clean) {
                Some(number) => self.ngc_parameter(FIRST_NAMED.checked_add(number)?).ok(),
                None => self.ngc_predefined(&clean),
            };
            return Some((value?, name.len() + 3));
        }
        let digits = name.bytes().take_while(u8::is_ascii_digit).count();
        let number = name.get(..digits)?.parse().ok()?;
        Some((self.ngc_parameter(number).ok()?, digits + 1))
    }
}

/// Digits behind the point of `%d`, `%f` or `%.2f`, and the length of what says so.
fn places(text: &str) -> Option<(usize, usize)> {
    match text.as_bytes() {
        [b'%', b'd', ..] => Some((0, 2)),
        [b'%', b'f', ..] => Some((4, 2)),
        [b'%', b'.', digit @ b'0'..=b'9', b'f', ..] => Some((usize::from(digit - b'0'), 4)),
        _ => None,
    }
}
