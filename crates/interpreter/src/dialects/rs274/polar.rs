//! `@` and `^`: an end point by its distance and angle from the zero, in the XY plane (LinuxCNC, polar
//! coordinates). They become the X and Y words that they stand for.

use super::blocks::Codes;
use crate::Fallible;
use crate::dialect::Meaning;
use crate::interpreter::Interpreter;
use crate::modal::Group;
use crate::stages::rotation::sin_cos_degrees;
use ferrocut_geometry::{Axis, MM_PER_INCH, Plane};
use ferrocut_machine::Fault;

/// Distance and angle of a block, as programmed.
#[derive(Clone, Copy, Default, Debug)]
pub(crate) struct PolarWords {
    pub distance: Option<f64>,
    pub angle: Option<f64>,
}

impl PolarWords {
    /// The point so much further out and round than another; none of a block without polar words.
    pub(super) fn step(&self, [x, y]: [f64; 2]) -> Option<[f64; 2]> {
        if self.distance.is_none() && self.angle.is_none() {
            return None;
        }
        let distance = x.hypot(y) + self.distance.unwrap_or(0.0);
        let (sin, cos) = sin_cos_degrees(y.atan2(x).to_degrees() + self.angle.unwrap_or(0.0));
        Some([distance * cos, distance * sin])
    }
}

impl Interpreter {
    /// Puts the X and Y words in whose place the block has polar ones.
    pub(super) fn ngc_polar(&mut self, codes: &Codes) -> Fallible<()> {
        let polar = self.ngc.polar;
        if polar.distance.is_none() && polar.angle.is_none() {
            return Ok(());
        }
        let in_force = |group: Group| codes.g(group).map_or(self.modal.meaning(group), |row| row.meaning);
        if in_force(Group::Plane) != Meaning::Plane(Plane::Xy) {
            return Err(self.ngc_alarm(Fault::CyclePlane));
        }
        let only_moves = codes.g(Group::NonModal).is_none_or(|row| row.meaning == Meaning::Dwell);
        if !only_moves || self.words.has(b'X') || self.words.has(b'Y') {
            return Err(self.ngc_alarm(Fault::CodesContradict));
        }
        let unit = if in_force(Group::Units) == Meaning::Inch { MM_PER_INCH } else { 1.0 };
        let (x, y) = (self.ngc.at[Axis::X] / unit, self.ngc.at[Axis::Y] / unit);
        let (distance, angle) = (x.hypot(y), y.atan2(x).to_degrees());
        let is_incremental = in_force(Group::Distance) == Meaning::Incremental;
        // From the zero there is no direction to go on in; a cycle takes that of X.
        let needs_direction =
            is_incremental || polar.angle.is_none() && !matches!(in_force(Group::Motion), Meaning::Cycle(_));
        if needs_direction && x == 0.0 && y == 0.0 {
            return Err(self.ngc_missing(b'^'));
        }
        let word = |word: Option<f64>, was: f64| match word {
            Some(value) if is_incremental => was + value,
            Some(value) => value,
            None => was,
        };
        let distance = word(polar.distance, distance);
        let (sin, cos) = sin_cos_degrees(word(polar.angle, angle));
        let from = if is_incremental { (x, y) } else { (0.0, 0.0) };
        let diameter = if in_force(Group::Diameter) == Meaning::DiameterMode { 2.0 } else { 1.0 };
        self.words.add(b'X', (distance * cos - from.0) * diameter);
        self.words.add(b'Y', distance * sin - from.1);
        Ok(())
    }
}
