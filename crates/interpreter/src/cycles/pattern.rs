//! Holes on a figure, each as the cycle in force makes it (Weihong 4.3, "special canned cycles").
//!
//! A figure makes one hole at a time, like a repeated cycle.

use crate::Fallible;
use crate::interpreter::Interpreter;
use crate::stages::rotation::sin_cos_degrees;
use crate::stages::units;
use ferrocut_geometry::{Axis, AxisSet, Plane, Position};
use ferrocut_machine::Fault;
use ferrocut_program::Span;

/// Kinds of figures.
#[derive(Clone, Copy, PartialEq, Eq, Debug)]
pub enum Pattern {
    /// All round a circle: I radius, J angle of the first, K holes, clockwise where positive (G34).
    Circle,
    /// On a line: I distance, J angle, K holes (G35).
    Line,
    /// On an arc: as the circle, P the angle between two (G36).
    Arc,
    /// In rows to and fro along X: I and P distance and holes along X, J and K along Y (G37).
    Grid,
}

/// Most holes that a word may ask for.
const MOST: f64 = 9999.0;

/// The places of a figure, mm and degrees.
#[derive(Clone, Copy, PartialEq, Debug)]
pub(super) struct Places {
    figure: Figure,
    /// Centre or first hole.
    at: [f64; 2],
    holes: u32,
}

#[derive(Clone, Copy, PartialEq, Debug)]
enum Figure {
    Round { radius: f64, first: f64, step: f64 },
    Line { step: [f64; 2] },
    Grid { step: [f64; 2], columns: u32 },
}

impl Places {
    /// The hole with so many behind it, at the level of `here`.
    pub(super) fn hole(&self, left: u32, here: Position) -> Position {
        let n = self.holes.saturating_sub(left).saturating_sub(1);
        let [a, b] = match self.figure {
            Figure::Round { radius, first, step } => {
                let (sin, cos) = sin_cos_degrees(first + f64::from(n) * step);
                [radius * cos, radius * sin]
            }
            Figure::Line { step: [x, y] } => [f64::from(n) * x, f64::from(n) * y],
            Figure::Grid { step: [x, y], columns } => {
                let (row, column) = (n / columns.max(1), n % columns.max(1));
                let column = if row % 2 == 0 { column } else { columns.saturating_sub(column + 1) };
                [f64::from(column) * x, f64::from(row) * y]
            }
        };
        let mut to = here;
        to[Axis::X] = self.at[0] + a;
        to[Axis::Y] = self.at[1] + b;
        to
    }
}

impl Interpreter {
    /// G34 to G37.
    pub(crate) fn pattern(&mut self, pattern: Pattern, axes: AxisSet, span: Span) -> Fallible<()> {
        if !self.cycle.is_active() || self.cycle_kind().is_none() {
            return Err(self.alarm(Fault::PatternWithoutCycle, span));
        }
        if self.is_nested_on_z() {
            return Err(self.alarm(Fault::CycleScaled, span));
        }
        self.refuse_rotary_plane(Plane::Xy, span)?;
        let plane: AxisSet = axes.iter().filter(|a| matches!(a, Axis::X | Axis::Y)).collect();
        let at = self.straight_end_point(plane);
        let inch = self.modal.is_inch();
        let length = |letter| self.words.get(letter).map(|v| units::length_mm(v, inch));
        let missing = |letter: u8| {
            let alarm = self.alarm(Fault::WordMissing, span);
            Box::new(alarm.with("word", char::from(letter).to_string()))
        };
        let length_of = |letter| length(letter).ok_or_else(|| missing(letter));
        let angle = self.words.get(b'J').unwrap_or(0.0);
        let (figure, holes) = match pattern {
            Pattern::Circle => {
                let holes = self.holes_word(b'K', -MOST, span)?;
                (Figure::Round { radius: length_of(b'I')?, first: angle, step: -360.0 / holes }, holes)
            }
            Pattern::Arc => {
                let holes = self.holes_word(b'K', -MOST, span)?;
                let step = self.words.get(b'P').ok_or_else(|| missing(b'P'))?;
                let radius = length_of(b'I')?;
                (Figure::Round { radius, first: angle, step: -step * holes.signum() }, holes)
            }
            Pattern::Line => {
                let holes = self.holes_word(b'K', 1.0, span)?;
                let (distance, (sin, cos)) = (length_of(b'I')?, sin_cos_degrees(angle));
                (Figure::Line { step: [distance * cos, distance * sin] }, holes)
            }
            Pattern::Grid => {
                let columns = self.holes_word(b'P', 1.0, span)?;
                let rows = self.holes_word(b'K', 1.0, span)?;
                let step = [length_of(b'I')?, length_of(b'J')?];
                (Figure::Grid { step, columns: columns as u32 }, columns * rows)
            }
        };
        // The data of its cycle stay as they are.
        let has_p = matches!(pattern, Pattern::Arc | Pattern::Grid);
        self.tell_unused((*b"ABCZLPQR").into_iter().filter(|letter| *letter != b'P' || !has_p));
        let holes = holes.abs() as u32;
        self.cycle.pattern = Some(Places { figure, at: [at[Axis::X], at[Axis::Y]], holes });
        self.cycle.line = None;
        self.cycle.holes_left = holes;
        Ok(())
    }

    /// A word that counts holes: whole, not 0, from `least` to 9999.
    fn holes_word(&self, letter: u8, least: f64, span: Span) -> Fallible<f64> {
        let Some(holes) = self.words.get(letter) else {
            let alarm = self.alarm(Fault::WordMissing, span);
            return Err(Box::new(alarm.with("word", char::from(letter).to_string())));
        };
        if holes == 0.0 || holes.fract() != 0.0 || !(least..=MOST).contains(&holes) {
            let alarm = self.alarm_at(Fault::WordOutOfRange, letter);
            return Err(Box::new(alarm.with("min", least).with("max", MOST)));
        }
        Ok(holes)
    }
}
