//! Length and diameter of a tool by a setter on the table (GSK990MC part 2, 3.4.3.2).
//!
//! Lengths count from the gauge line of the spindle to the tip: the setter is at the machine height at which a tool of
//! no length would touch it (P389), so a tool of length L touches at P389 + L.

use super::{Pace, Touch, Touching, Unusable, size};
use ferrocut_geometry::{Axis, Position};
use ferrocut_machine::Fault;
use ferrocut_toolpath::SpindleState;

/// What is measured.
#[derive(Clone, Copy, PartialEq, Eq, Debug)]
pub enum Mode {
    /// The length.
    Length,
    /// The diameter.
    Diameter,
    /// Both.
    Both,
    /// The height of the setter, by a tool of known length that stands over it.
    CalibrateLength,
    /// The diameter of the setter, by a tool of known diameter.
    CalibrateDiameter,
}

/// Where and how a tool is measured. Machine positions, mm.
#[derive(Clone, Copy, PartialEq, Debug)]
pub struct Tool {
    /// What.
    pub mode: Mode,
    /// Where the spindle stands when measuring begins.
    pub from: Position,
    /// The setter: X and Y of its middle, Z where a tool of no length touches it (P387 to P389).
    pub setter: [f64; 3],
    /// Diameter of the setter.
    pub stylus: f64,
    /// Length of the tool: estimated, or exact to calibrate.
    pub length: f64,
    /// Diameter of the tool: estimated, or exact to calibrate.
    pub diameter: f64,
    /// How far below the top of the setter its side is touched (Z of the manual, without its sign).
    pub depth: f64,
    /// From where and how far behind the estimate is searched (R and Q of the manual).
    pub overtravel: f64,
    /// How fast.
    pub pace: Pace,
    /// What the spindle does while the diameter is measured.
    pub spindle: Option<SpindleState>,
}

/// What was found.
#[derive(Clone, Copy, PartialEq, Debug, Default)]
pub struct Found {
    /// Length.
    pub length: Option<f64>,
    /// Diameter.
    pub diameter: Option<f64>,
    /// The setter, as calibrated: X, Y and Z.
    pub setter: Option<[f64; 3]>,
    /// Diameter of the setter, as calibrated.
    pub stylus: Option<f64>,
}

impl Tool {
    fn at(&self, x: f64, z: f64) -> Position {
        let mut place = self.from;
        place[Axis::X] = x;
        place[Axis::Y] = self.setter[1];
        place[Axis::Z] = z;
        place
    }

    /// The way of the tool.
    pub fn touching(&self) -> Result<Touching, Unusable> {
        let overtravel = size(Some(self.overtravel), "overtravel")?;
        if !self.setter.iter().all(|value| value.is_finite()) {
            return Err(Unusable("setter"));
        }
        let length = match self.length.is_finite() && self.length >= 0.0 {
            true => self.length,
            false => return Err(Unusable("length")),
        };
        let [x, _, z] = self.setter;
        let tip = z + length;
        let mut touches = Vec::new();
        if self.mode == Mode::CalibrateLength {
            // The tool stands over the setter: nobody knows yet how high that is.
            let mut limit = self.from;
            limit[Axis::Z] -= overtravel;
            touches.push(Touch { via: Vec::new(), limit });
            let (end, pace, missed) = (vec![self.from], self.pace, Fault::SetterMissed);
            return Ok(Touching { touches, end, pace, spindle: None, missed });
        }
        // Over the setter at a height at which it is free of it, the one where it stands if that is higher.
        let top = self.from[Axis::Z].max(tip + overtravel);
        let mut up = self.from;
        up[Axis::Z] = top;
        let mut via = vec![up];
        if matches!(self.mode, Mode::Length | Mode::Both) {
            via.extend([self.at(x, top), self.at(x, tip + overtravel)]);
            touches.push(Touch { via: std::mem::take(&mut via), limit: self.at(x, tip - overtravel) });
        }
        if self.mode != Mode::Length {
            let reach = (size(Some(self.diameter), "diameter")? + self.stylus_of()?) / 2.0;
            let side = tip - size(Some(self.depth), "depth")?;
            for sign in [1.0, -1.0] {
                let beside = x + sign * (reach + overtravel);
                let before = touches.last().and_then(|touch: &Touch| touch.via.last()).copied();
                // Up from where the touch before began, and over.
                via.extend(before.map(|before| self.at(before[Axis::X], top)));
                via.extend([self.at(beside, top), self.at(beside, side)]);
                let limit = self.at(x + sign * (reach - overtravel).max(0.0), side);
                touches.push(Touch { via: std::mem::take(&mut via), limit });
            }
        }
        let last = touches.last().and_then(|touch| touch.via.last()).copied();
        let end = last.map(|last| self.at(last[Axis::X], top)).into_iter().collect();
        let spindle = if self.mode == Mode::Length { None } else { self.spindle };
        Ok(Touching { touches, end, pace: self.pace, spindle, missed: Fault::SetterMissed })
    }

    fn stylus_of(&self) -> Result<f64, Unusable> {
        match self.mode {
            // What is to be found; the way is made for one that is usual.
            Mode::CalibrateDiameter => Ok(self.stylus.max(0.0)),
            _ => size(Some(self.stylus), "stylus"),
        }
    }

    /// What the touches come to.
    pub fn found(&self, touched: &[Position]) -> Option<Found> {
        let mut found = Found::default();
        let mut touched = touched.iter();
        match self.mode {
            Mode::CalibrateLength => {
                let z = touched.next()?[Axis::Z] - self.length;
                found.setter = Some([self.from[Axis::X], self.from[Axis::Y], z]);
                return Some(found);
            }
            Mode::Length | Mode::Both => found.length = Some(touched.next()?[Axis::Z] - self.setter[2]),
            _ => {}
        }
        if self.mode != Mode::Length {
            let apart = touched.next()?[Axis::X] - touched.next()?[Axis::X];
            match self.mode {
                Mode::CalibrateDiameter => found.stylus = Some(apart - self.diameter),
                _ => found.diameter = Some(apart - self.stylus),
            }
        }
        Some(found)
    }
}
