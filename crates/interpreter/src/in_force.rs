//! What is in force behind the blocks that were run, for whoever shows it.

use crate::interpreter::Interpreter;
use ferrocut_geometry::Position;
use ferrocut_toolpath::SpindleState;

/// Words in force.
#[derive(Clone, Copy, PartialEq, Debug)]
pub struct InForce {
    /// What the spindle was told.
    pub spindle: SpindleState,
    /// S, r/min.
    pub speed: f64,
    /// F, in units of the program; per minute, per revolution or inverse time as its code says.
    pub feed: f64,
    /// T.
    pub tool: u32,
    /// M08.
    pub flood: bool,
    /// M07.
    pub mist: bool,
    /// Machine position of the programmed zero: coordinate system, shifts and tool length.
    pub zero: Position,
    /// Tool length in force along the axes, mm.
    pub length: Position,
    /// G92 and G52 of RS274/NGC, mm.
    pub shift: Position,
    /// Machine position where the last probe of RS274/NGC ended, and whether it found something.
    pub probed: Option<(Position, bool)>,
}

impl Interpreter {
    /// Words in force behind the blocks that were run. G codes are [`codes_in_force`](Self::codes_in_force).
    pub fn words_in_force(&self) -> InForce {
        let technology = &self.technology;
        let is_ngc = self.dialect.blocks.is_some();
        let per_revolution = self.modal.is_feed_per_revolution();
        InForce {
            spindle: technology.spindle,
            speed: technology.speed.unwrap_or(0.0),
            feed: match (is_ngc, per_revolution) {
                (true, _) => self.ngc.feed,
                (false, true) => technology.feed_per_revolution,
                (false, false) => technology.feed_per_minute,
            },
            tool: technology.tool,
            flood: technology.coolant,
            mist: self.ngc.mist,
            zero: match is_ngc {
                true => self.ngc.machine_of(Position::ZERO),
                false => self.location.machine_of(Position::ZERO),
            },
            length: if is_ngc { self.ngc.length } else { self.location.length.vector },
            shift: if is_ngc { self.ngc.shift } else { Position::ZERO },
            probed: self.ngc.probed,
        }
    }
}
