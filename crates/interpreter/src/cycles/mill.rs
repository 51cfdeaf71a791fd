//! Milling cycles: the words of a block into a plan of [`milling`](super::milling), and its moves through
//! the stages.

use super::milling::{
    CircleFinish, CycleFault, CycleMove, Plan, Problem, RectFinish, RectPocket, Roughing, RoundPocket, Side,
};
use crate::Fallible;
use crate::interpreter::Interpreter;
use crate::stages::units;
use ferrocut_geometry::{Axis, Plane, Position, SAME_POINT_MM, Turn};
use ferrocut_machine::Fault;

/// What a milling cycle cuts.
#[derive(Clone, Copy, PartialEq, Eq, Debug)]
pub enum MillShape {
    /// A round pocket, roughed (G22, G23).
    RoundPocket,
    /// A circle, finished (G24, G25 inside; G26, G32 outside).
    Circle(Side),
    /// A rectangular pocket, roughed (G33, G34).
    RectPocket,
    /// A rectangle, finished (G35, G36 inside; G37, G38 outside).
    Rectangle(Side),
}

/// Words of the active milling cycle, kept until it is cancelled, mm.
#[derive(Clone, Copy, PartialEq, Debug, Default)]
pub(crate) struct MillWords {
    i: Option<f64>,
    j: Option<f64>,
    l: Option<f64>,
    w: Option<f64>,
    q: Option<f64>,
    v: Option<f64>,
    u: Option<f64>,
    d: Option<f64>,
    /// The last one cut.
    last: Option<Cut>,
}

/// Where a milling cycle was, and where it left the tool, programmed and on the machine. Words left out and increments of the next
/// block count from its place as long as the tool has not moved and the coordinates are the same.
#[derive(Clone, Copy, PartialEq, Debug)]
struct Cut {
    at: [f64; 2],
    left: [[f64; 2]; 2],
}

impl Interpreter {
    /// Keeps the words of the block.
    pub(super) fn store_mill_words(&mut self) {
        let inch = self.modal.is_inch();
        let words = &self.words;
        let keep = |slot: &mut Option<f64>, letter: u8| {
            if let Some(value) = words.get(letter) {
                *slot = Some(units::length_mm(value, inch));
            }
        };
        let calls = self.words.calls();
        let mill = &mut self.cycle.mill;
        keep(&mut mill.i, b'I');
        keep(&mut mill.j, b'J');
        // L of a call is its repeats.
        if !calls {
            keep(&mut mill.l, b'L');
        }
        keep(&mut mill.w, b'W');
        keep(&mut mill.q, b'Q');
        keep(&mut mill.v, b'V');
        keep(&mut mill.u, b'U');
        if let Some(number) = self.words.get(b'D') {
            self.cycle.mill.d = Some(number);
        }
    }

    /// Cuts one pocket or wall.
    pub(super) fn mill(&mut self, shape: MillShape, turn: Turn) -> Fallible<()> {
        let [x, y, _] = self.location.scaling.map_or([1.0; 3], |scaling| scaling.factors);
        if x < 0.0 || y < 0.0 {
            return Err(self.alarm(Fault::MillMirrored, self.cycle_span()));
        }
        if x != y {
            return Err(self.alarm(Fault::MillScaledUnevenly, self.cycle_span()));
        }
        if let Some(last) = self.cycle.mill.last.filter(|last| self.is_at(last.left)) {
            let [x, y] = last.at;
            self.location.programmed[Axis::X] = x;
            self.location.programmed[Axis::Y] = y;
        }
        let to = self.place_of_hole();
        let (Some(r), Some(z)) = (self.cycle.r, self.cycle.z) else { return self.position_at(to) };
        let at = Plane::Xy.of(to);
        let plan = self.mill_plan(shape, turn, at, r, z, x);
        let plan = plan.map_err(|fault| self.mill_alarm(fault))?;
        let [x, y] = plan.start();
        let mut start = to;
        start[Axis::X] = x;
        start[Axis::Y] = y;
        self.position_at(start)?;
        self.take_up_length()?;
        plan.moves(self.top(r), &mut |m| self.mill_move(m))?;
        self.cycle.mill.last = Some(Cut { at, left: self.places() });
        Ok(())
    }

    /// X and Y where the tool stands, programmed and on the machine.
    fn places(&self) -> [[f64; 2]; 2] {
        [self.location.programmed, self.location.machine].map(|place| Plane::Xy.of(place))
    }

    /// Whether it stands there, but for what rounding makes of sums.
    fn is_at(&self, places: [[f64; 2]; 2]) -> bool {
        let here = self.places();
        here.iter().flatten().zip(places.iter().flatten()).all(|(a, b)| (a - b).abs() <= SAME_POINT_MM)
    }

    /// Scaling by `factor` is none of the tool, whose path it scales with the rest (GSK990MC 4.2.14, 7).
    fn mill_plan(
        &self,
        shape: MillShape,
        turn: Turn,
        at: [f64; 2],
        r: f64,
        bottom: f64,
        factor: f64,
    ) -> Result<Plan, CycleFault> {
        let words = &self.cycle.mill;
        let roughing = Roughing {
            step: words.l,
            first_depth: words.w,
            depth: words.q,
            gap: words.v,
            helix_factor: self.rules.cycles.pocket_helix_factor,
        };
        let tool_radius = words.d.filter(|number| *number != 0.0).and_then(|number| {
            self.memory.tools.get(number as u16).map(|row| self.tool_radius(row) / factor)
        });
        let sizes = [words.i, words.j];
        match shape {
            MillShape::RoundPocket => {
                RoundPocket { center: at, r, bottom, radius: words.i, roughing, tool_radius, turn }.plan()
            }
            MillShape::Circle(side) => {
                let (radius, start) = (words.i, words.j);
                CircleFinish { side, center: at, r, bottom, radius, start, tool_radius, turn }.plan()
            }
            MillShape::RectPocket => {
                let corner = words.u;
                RectPocket { center: at, r, bottom, sizes, roughing, corner, tool_radius, turn }.plan()
            }
            MillShape::Rectangle(side) => {
                let (distance, corner) = (words.l, words.u);
                RectFinish { side, start: at, r, bottom, sizes, distance, corner, tool_radius, turn }.plan()
            }
        }
    }

    /// A move of a plan, in programmed coordinates.
    fn mill_move(&mut self, m: CycleMove) -> Fallible<()> {
        let place = |from: Position, [x, y, z]: [f64; 3]| {
            let mut to = from;
            to[Axis::X] = x;
            to[Axis::Y] = y;
            to[Axis::Z] = z;
            to
        };
        let from = self.location.programmed;
        match m {
            CycleMove::Rapid { to } => self.rapid(place(from, to)),
            CycleMove::Feed { to } => self.cut(place(from, to)),
            CycleMove::Arc { to, center, sweep } => {
                let feed = self.feed()?;
                self.arc_about(Plane::Xy, place(from, to), center, sweep, feed)
            }
        }
    }

    fn mill_alarm(&self, fault: CycleFault) -> Box<ferrocut_machine::Alarm> {
        let rule = match fault.problem {
            Problem::StepTooSmall => Fault::MillStepTooSmall,
            Problem::StepTooLarge => Fault::MillStepTooLarge,
            Problem::ToolTooLarge => Fault::MillToolTooLarge,
            Problem::CornerTooLarge => Fault::MillCornerTooLarge,
            Problem::CornerTooSmall => Fault::MillCornerTooSmall,
            Problem::GapMissing => Fault::MillGapMissing,
            Problem::FirstDepthMissing => Fault::MillFirstDepthMissing,
            Problem::DepthMissing => Fault::MillDepthMissing,
            Problem::SizeMissing => Fault::MillSizeMissing,
            Problem::SecondSizeMissing => Fault::MillSecondSizeMissing,
            Problem::ToolMissing => Fault::MillToolMissing,
            Problem::BottomNotBelowR => Fault::CycleDepthAboveR,
            Problem::OutOfRange => Fault::WordOutOfRange,
            Problem::TooManyMoves => Fault::MillTooManyMoves,
        };
        match fault.letter {
            Some(letter) if self.words.has(letter) => self.alarm_at(rule, letter),
            _ => self.alarm(rule, self.cycle_span()),
        }
    }
}
