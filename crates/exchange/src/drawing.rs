//! A drawing once it is read: what the pen does, in order, in mm.

use crate::curve::Curve;
use crate::limits::{Limits, MOST_CURVES, Refused};
use crate::settings::{Cutting, Format};
use ferrocut_geometry::vector::Point;
use ferrocut_machine::Alarm;
use ferrocut_program::Span;
use rustc_hash::FxHashMap;

/// What the pen does.
#[derive(Clone, Copy, PartialEq, Debug)]
pub enum Action {
    /// Comes out of the work.
    Raise,
    /// Goes to the depth of its layer.
    Lower,
    /// Moves in the air, in a straight line.
    Travel(Point),
    /// Cuts along a curve.
    Cut(Curve),
}

/// What the pen does, and what in the drawing says so.
#[derive(Clone, Copy, PartialEq, Debug)]
pub struct Move {
    /// What it does.
    pub action: Action,
    /// Work Z at its end, mm, where the drawing gives one.
    pub z: Option<f64>,
    /// Number of the layer or pen in the drawing's list.
    pub layer: u32,
    /// The piece of the drawing.
    pub span: Span,
}

/// A layer of a DXF drawing or a pen of a PLT drawing.
#[derive(Clone, PartialEq, Debug)]
pub struct Layer {
    /// Its name or number.
    pub name: Box<str>,
    /// How it is cut; `None` if it is left out.
    pub cutting: Option<Cutting>,
}

/// A drawing.
#[derive(Clone, PartialEq, Debug)]
pub struct Drawing {
    /// What it was read from.
    pub format: Format,
    /// Layers or pens that something lies on.
    pub layers: Vec<Layer>,
    /// What the pen does. A PLT drawing says when it is raised and lowered; a DXF drawing has cuts alone.
    pub moves: Vec<Move>,
    /// Where the drawing ends.
    pub end: Span,
    /// What was left out and should be known.
    pub warnings: Vec<Alarm>,
    /// What was passed over because it has no bearing on the path, such as the speed of a plotter's pen.
    pub notes: Vec<Alarm>,
    /// How many of the moves are cuts.
    cuts: usize,
}

/// Beyond this radius an arc is written as chords, mm: the words for its centre would be longer than
/// controls take.
const LARGEST_RADIUS: f64 = 10_000.0;

/// Chords of an arc too large for its centre to be written at most.
const MOST_CHORDS: f64 = 100_000.0;

/// Moves of a drawing at most: every cut may be raised, led to and lowered by itself.
const MOST_MOVES: usize = 4 * MOST_CURVES;

impl Drawing {
    /// An empty drawing.
    pub fn new(format: Format) -> Drawing {
        Drawing {
            format,
            layers: Vec::new(),
            moves: Vec::new(),
            end: Span::default(),
            warnings: Vec::new(),
            notes: Vec::new(),
            cuts: 0,
        }
    }

    /// Adds a move that is no cut.
    pub fn push(&mut self, action: Action, z: Option<f64>, layer: u32, span: Span) -> Result<(), Box<Alarm>> {
        self.add(Move { action, z, layer, span })
    }

    /// Adds a cut: a line or arc of any size, within `tolerance` of it where it must be divided.
    pub fn cut(
        &mut self,
        curve: Curve,
        tolerance: f64,
        layer: u32,
        span: Span,
        limits: &Limits,
    ) -> Result<(), Box<Alarm>> {
        let [low, high] = curve.extent();
        for corner in [low, high] {
            limits.reach(corner).map_err(|refused| refused.at(span))?;
        }
        let cut = |curve| Move { action: Action::Cut(curve), z: None, layer, span };
        let Some(bend) = curve.bend.filter(|_| curve.radius() > LARGEST_RADIUS) else {
            return self.add(cut(curve));
        };
        // A chord over the angle w leaves the arc by r (1 − cos(w/2)), at most r w²/8.
        let angle = (8.0 * tolerance / curve.radius()).sqrt();
        let count = (bend.sweep.abs() / angle).ceil().clamp(1.0, MOST_CHORDS) as usize;
        let mut from = curve.from;
        for i in 1..=count {
            let to = curve.at(i as f64 / count as f64);
            self.add(cut(Curve::line(from, to)))?;
            from = to;
        }
        Ok(())
    }

    fn add(&mut self, m: Move) -> Result<(), Box<Alarm>> {
        self.cuts += usize::from(matches!(m.action, Action::Cut(_)));
        if self.moves.len() >= MOST_MOVES || self.cuts > MOST_CURVES {
            return Err(Refused::TooMany("curves", MOST_CURVES as f64).at(m.span));
        }
        self.moves.push(m);
        Ok(())
    }

    /// Whether there is nothing to do: nothing is cut, and no way of a raised pen is all that was asked for.
    pub fn is_empty(&self) -> bool {
        let goes = self.moves.iter().any(|m| matches!(m.action, Action::Travel(_)));
        !self.cuts() && (!goes || self.layers.iter().any(|layer| layer.cutting.is_none()))
    }

    /// Whether anything is cut.
    pub fn cuts(&self) -> bool {
        self.moves.iter().any(|m| matches!(m.action, Action::Cut(_) | Action::Lower))
    }
}

/// Numbers layers by their names.
#[derive(Default)]
pub struct LayerNames {
    numbers: FxHashMap<Box<str>, u32>,
}

impl LayerNames {
    /// The number of a layer, which is added to the drawing when it comes first.
    pub fn number(
        &mut self,
        name: &str,
        drawing: &mut Drawing,
        cutting: impl FnOnce() -> Option<Cutting>,
    ) -> u32 {
        if let Some(number) = self.numbers.get(name) {
            return *number;
        }
        let number = u32::try_from(drawing.layers.len()).unwrap_or(u32::MAX);
        drawing.layers.push(Layer { name: name.into(), cutting: cutting() });
        self.numbers.insert(name.into(), number);
        number
    }
}
