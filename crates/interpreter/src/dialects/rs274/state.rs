//! What blocks change: where the tool is, what its coordinates count from, and the values of named parameters.
//!
//! One formula leads from a programmed point to the machine (LinuxCNC, coordinate systems):
//! machine = turned(point + shift) + zero + length.

use super::cycles::Cycles;
use super::expressions::Named;
use super::flow::OWords;
use super::polar::PolarWords;
use super::saved::Saved;
use super::splines::Splines;
use super::technology::Overrides;
use crate::stages::rotation::sin_cos_degrees;
use ferrocut_geometry::{Axis, Position};

/// State of an interpreter of this language. Lengths are mm whatever the units of the program.
#[derive(Clone)]
pub(crate) struct State {
    /// The state that M66 waited for last.
    pub awaited_input: f64,
    /// The block has given out its wait, and is run again behind it.
    pub awaits_input: bool,
    /// The programmed point in force, in the coordinate system in force.
    pub at: Position,
    /// G92 or G52.
    pub shift: Position,
    /// Machine position of the zero of the coordinate system.
    pub zero: Position,
    /// Turn of the coordinate system about Z.
    pub turn: Turned,
    /// Tool length in force.
    pub length: Position,
    /// Coordinate system in force: 1 is G54, 9 is G59.3.
    pub system: u8,
    /// The F word in force as programmed.
    pub feed: f64,
    /// mm in a unit of it: F is a speed where it is given, and a change of units does not change that.
    pub feed_unit: f64,
    /// The block has an F word.
    pub has_feed_word: bool,
    /// The block has G53.
    pub in_machine: bool,
    /// Canned cycles.
    pub cycles: Cycles,
    /// Splines.
    pub splines: Splines,
    /// Polar words of the block.
    pub polar: PolarWords,
    /// Values of parameters with names.
    pub named: Named,
    /// Subprograms, loops and conditions.
    pub o_words: OWords,
    /// What the last subprogram returned.
    pub returned: Option<f64>,
    /// Saved states, one a level of calls at most.
    pub saved: Vec<Saved>,
    /// Machine position where the last probe ended, and whether it found something.
    pub probed: Option<(Position, bool)>,
    /// Mist coolant is on.
    pub mist: bool,
    /// How far a path may leave the programmed one (G64 P), mm.
    pub tolerance: Option<f64>,
    /// Overrides that have effect.
    pub overrides: Overrides,
    /// Stack of expressions, kept to spare its allocation.
    pub stack: Vec<f64>,
    /// Parameters that the block sets, once all its words are read.
    pub settings: Vec<(u32, f64)>,
}

/// A turn about Z.
#[derive(Clone, Copy, PartialEq, Debug)]
pub struct Turned {
    /// Counter-clockwise, degrees.
    pub degrees: f64,
    sin: f64,
    cos: f64,
}

impl Turned {
    /// A turn by an angle in degrees.
    pub fn by(degrees: f64) -> Turned {
        let (sin, cos) = sin_cos_degrees(degrees);
        Turned { degrees, sin, cos }
    }

    /// A point, turned.
    #[inline]
    pub fn apply(&self, mut p: Position) -> Position {
        if self.degrees != 0.0 {
            let (x, y) = (p[Axis::X], p[Axis::Y]);
            p[Axis::X] = x * self.cos - y * self.sin;
            p[Axis::Y] = x * self.sin + y * self.cos;
        }
        p
    }

    /// A point, turned back.
    #[inline]
    pub fn undo(&self, mut p: Position) -> Position {
        if self.degrees != 0.0 {
            let (x, y) = (p[Axis::X], p[Axis::Y]);
            p[Axis::X] = x * self.cos + y * self.sin;
            p[Axis::Y] = y * self.cos - x * self.sin;
        }
        p
    }
}

impl State {
    /// At rest at a machine position, with nothing shifted but the zero in force.
    pub fn new(zero: Position, machine: Position) -> State {
        let mut state = State {
            awaited_input: 0.0,
            awaits_input: false,
            at: Position::ZERO,
            shift: Position::ZERO,
            zero,
            turn: Turned::by(0.0),
            length: Position::ZERO,
            system: 1,
            feed: 0.0,
            feed_unit: 1.0,
            has_feed_word: false,
            in_machine: false,
            cycles: Cycles::default(),
            splines: Splines::default(),
            polar: PolarWords::default(),
            named: Named::default(),
            o_words: OWords::default(),
            returned: None,
            saved: Vec::new(),
            probed: None,
            mist: false,
            tolerance: None,
            overrides: Overrides::START,
            stack: Vec::new(),
            settings: Vec::new(),
        };
        state.at = state.program_of(machine);
        state
    }

    /// Reset with the axes at rest at `machine`: offsets and parameters stay, what a program opened is closed.
    pub fn reset(&mut self, machine: Position) {
        self.o_words = OWords::default();
        self.named.leave_all();
        self.saved.clear();
        self.returned = None;
        self.mist = false;
        self.feed = 0.0;
        self.at = self.program_of(machine);
    }

    /// A program ended where another may follow: its subprograms and loops are not those of the next.
    pub fn end_calls(&mut self) {
        self.o_words = OWords::default();
        self.named.leave_all();
        self.saved.clear();
    }

    /// Machine position of a programmed point.
    #[inline]
    pub fn machine_of(&self, point: Position) -> Position {
        self.turn.apply(point + self.shift) + self.zero + self.length
    }

    /// The programmed point of a machine position.
    #[inline]
    pub fn program_of(&self, machine: Position) -> Position {
        self.turn.undo(machine - self.zero - self.length) - self.shift
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn machine_and_program_are_inverse() {
        let mut state = State::new(Position::xyz(10.0, 20.0, 30.0), Position::ZERO);
        state.turn = Turned::by(90.0);
        state.shift = Position::xyz(1.0, 2.0, 3.0);
        state.length = Position::xyz(0.0, 0.0, 5.0);
        // (4 + 1, 5 + 2) turned by a quarter is (-7, 5).
        let machine = state.machine_of(Position::xyz(4.0, 5.0, 6.0));
        assert_eq!(machine, Position::xyz(3.0, 25.0, 44.0));
        assert_eq!(state.program_of(machine), Position::xyz(4.0, 5.0, 6.0));
    }
}
