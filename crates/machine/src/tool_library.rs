//! The tool table of LinuxCNC: which tools there are, where they stand, and how far each reaches on every axis.
//!
//! A file has a line for each tool, of words as in a program: `T1 P1 D6 Z52.5 ;end mill`. T is the number of
//! the tool, P its pocket, D its diameter; X Y Z A B C U V W are its length on these axes; I and J are front
//! and back angle and Q the orientation of a lathe tool (LinuxCNC, tool table). Lengths are in the units of the
//! machine, which is metric here.

use crate::config_error::ConfigError;
use ferrocut_geometry::{Axis, Position};
use std::collections::BTreeMap;

/// A tool.
#[derive(Clone, Copy, PartialEq, Debug, Default)]
pub struct Tool {
    /// The place in the magazine; 0 where not given.
    pub pocket: u32,
    /// Diameter, mm.
    pub diameter: f64,
    /// Length on every axis, mm and degrees.
    pub length: Position,
    /// Front angle of a lathe tool, degrees.
    pub front_angle: f64,
    /// Back angle of a lathe tool, degrees.
    pub back_angle: f64,
    /// Orientation of a lathe tool, 0 to 9.
    pub orientation: u8,
}

/// The tools that there are, by number.
#[derive(Clone, PartialEq, Debug, Default)]
pub struct ToolLibrary {
    tools: BTreeMap<u32, Tool>,
}

impl ToolLibrary {
    /// Highest number of a tool and of a pocket (LinuxCNC, tool table).
    pub const LARGEST: u32 = 99_999;

    /// Most tools of a table (LinuxCNC, tool table: pockets 1 to 1000).
    const MOST: usize = 1000;

    /// Reads a tool table. The error names the line and the word.
    pub fn from_tbl(text: &str) -> Result<ToolLibrary, ConfigError> {
        let mut library = ToolLibrary::default();
        for (number, line) in (1usize..).zip(text.lines()) {
            let words = line.split(';').next().unwrap_or_default();
            let at_line = |error: ConfigError| error.with("line", number);
            let Some((tool, row)) = tool(words).map_err(at_line)? else { continue };
            if library.tools.insert(tool, row).is_some() {
                return Err(at_line(ConfigError::label("label-config-tool-twice").with("tool", tool)));
            }
            if library.tools.len() > ToolLibrary::MOST {
                return Err(at_line(ConfigError::label("label-config-tools").with("max", ToolLibrary::MOST)));
            }
        }
        Ok(library)
    }

    /// A tool; none where the table has no such number.
    pub fn get(&self, number: u32) -> Option<&Tool> {
        self.tools.get(&number)
    }

    /// A tool to be written; none where the table has no such number.
    pub fn get_mut(&mut self, number: u32) -> Option<&mut Tool> {
        self.tools.get_mut(&number)
    }

    /// Puts a tool in the place of the one with its number; none takes it out. A table that is full takes no more.
    pub fn put(&mut self, number: u32, tool: Option<Tool>) {
        match tool {
            None => drop(self.tools.remove(&number)),
            Some(tool) if self.tools.len() < ToolLibrary::MOST || self.tools.contains_key(&number) => {
                self.tools.insert(number, tool);
            }
            Some(_) => {}
        }
    }

    /// The tools with their numbers, in order.
    pub fn iter(&self) -> impl Iterator<Item = (u32, &Tool)> {
        self.tools.iter().map(|(number, tool)| (*number, tool))
    }
}

/// The tool of a line; none of a line without words.
fn tool(line: &str) -> Result<Option<(u32, Tool)>, ConfigError> {
    let mut tool = Tool::default();
    let mut number = None;
    let mut is_empty = true;
    for word in line.split_whitespace() {
        is_empty = false;
        let wrong = || ConfigError::label("label-config-tool-word").with("word", format!("{word:?}"));
        let mut letters = word.chars();
        let letter = letters.next().ok_or_else(wrong)?.to_ascii_uppercase();
        let value = letters.as_str();
        let whole = |largest| value.parse::<u32>().ok().filter(|v| *v <= largest).ok_or_else(wrong);
        let real = || value.parse::<f64>().ok().filter(|v| v.is_finite()).ok_or_else(wrong);
        match letter {
            'T' => number = Some(whole(ToolLibrary::LARGEST)?),
            'P' => tool.pocket = whole(ToolLibrary::LARGEST)?,
            'D' => tool.diameter = real()?,
            'I' => tool.front_angle = real()?,
            'J' => tool.back_angle = real()?,
            'Q' => tool.orientation = u8::try_from(whole(9)?).map_err(|_| wrong())?,
            _ => {
                let axis = u8::try_from(letter).ok().and_then(Axis::from_letter).ok_or_else(wrong)?;
                tool.length[axis] = real()?;
            }
        }
    }
    match number {
        Some(number) => Ok(Some((number, tool))),
        None if is_empty => Ok(None),
        None => Err(ConfigError::label("label-config-no-tool")),
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn a_table_is_read_word_by_word() {
        let text = "; tools of the mill\n\
            T1 P1 D+6.000000 Z+52.500000 ;end mill\n\
            \n\
            t20 p3 x1 y-2 z3 a4 u5 v6 w7 i95 j155 q2 ; everything\r\n\
            T5 P4 Z1 Q0";
        let library = ToolLibrary::from_tbl(text).unwrap();
        assert_eq!(library.iter().map(|(number, _)| number).collect::<Vec<_>>(), [1, 5, 20]);
        let mill = library.get(1).unwrap();
        assert_eq!((mill.pocket, mill.diameter, mill.length), (1, 6.0, Position::xyz(0.0, 0.0, 52.5)));
        let lathe = library.get(20).unwrap();
        assert_eq!(lathe.length[Axis::W], 7.0);
        assert_eq!((lathe.front_angle, lathe.back_angle, lathe.orientation), (95.0, 155.0, 2));
        assert!(library.get(2).is_none());
    }

    #[test]
    fn what_is_no_table_is_told_with_its_line() {
        for (text, part) in [
            ("T1 P1\nP2 D3", "line 2: no T word"),
            ("T1 P1 E3", "line 1: \"E3\""),
            ("T1 Pone", "\"Pone\""),
            ("T1 D1e999", "\"D1e999\""),
            ("T-1", "\"T-1\""),
            ("T1 Q10", "\"Q10\""),
            ("T1\nT1", "line 2: tool T1 stands twice"),
            ("T100000", "\"T100000\""),
            ("T1 \u{e9}3", "line 1"),
        ] {
            let error = ToolLibrary::from_tbl(text).unwrap_err().to_string();
            assert!(error.contains(part), "{text:?}: {error}");
        }
    }
}
