//! Faces (Fagor 4.19).
//!
//! Passes lie along u from the corner where milling begins, which is the origin; v leads across them into
//! the face. Beyond the face the tool runs until its edge is clear of it by the overrun, so that it comes
//! down beside the material.

use super::{CLEAR, Cut, Planes, passes};
use crate::cycles::depth::Levels;
use crate::cycles::parameter::{WrongParameter, positive, refuse};
use crate::cycles::tool::{Take, Tool};
use ferrocut_machine::Fault;

/// The order of the passes.
#[derive(Clone, Copy, PartialEq, Eq, Debug)]
pub enum Strategy {
    /// To and fro.
    Both,
    /// All the same way; back at rapid on the safety level.
    One,
    /// Round and round, inwards.
    Spiral,
}

/// A face to mill.
#[derive(Clone, Copy, PartialEq, Debug)]
pub struct Facing {
    /// Its sizes along the passes and across them.
    pub size: [f64; 2],
    /// Levels.
    pub planes: Planes,
    /// Passes in depth.
    pub levels: Levels,
    /// The tool.
    pub cut: Cut,
    /// How far the tool's edge runs beyond the face.
    pub overrun: f64,
    /// The order of the passes.
    pub strategy: Strategy,
    /// Where the first rapid ends.
    pub first: f64,
    /// It ends over its start, as roughing does; finishing ends where it leaves the face (4.19.1, 4 and 7).
    pub returns: bool,
}

impl Facing {
    /// Whether the face can be milled.
    pub fn check(&self, words: [&'static str; 3]) -> Result<(), WrongParameter> {
        let [along, across, overrun] = words;
        positive(self.size[0], along)?;
        positive(self.size[1], across)?;
        refuse(!(self.overrun >= 0.0 && self.overrun.is_finite()), Fault::CycleParameter, overrun)
    }

    /// How far the tool centre runs beyond the face.
    fn beyond(&self) -> f64 {
        self.cut.radius + self.overrun
    }

    /// Width of the passes, and how many, across the face; of a spiral on either side of its middle.
    fn widths(&self) -> (u32, f64) {
        let [along, across] = self.size;
        match self.strategy {
            // Its outer corner is cut only for s/√2 ≤ r.
            Strategy::Spiral => {
                let widest = self.cut.radius * std::f64::consts::SQRT_2;
                passes(along.min(across) / 2.0, self.cut.step.min(widest))
            }
            _ => passes(across, self.cut.step),
        }
    }

    /// Where the tool goes down first.
    pub fn start(&self) -> [f64; 2] {
        [-self.beyond(), self.widths().1 / 2.0]
    }

    /// Mills from over the start, and ends on the safety level.
    pub fn cut<T: Take>(&self, tool: &mut Tool<'_, T>) -> Result<(), T::Error> {
        tool.rapid_z(self.first)?;
        for depth in self.levels.depths() {
            let level = tool.above(self.planes.surface, -depth);
            self.level(tool, level)?;
            tool.rapid_z(self.planes.safety)?;
            let is_last = depth == self.levels.deepest();
            if !is_last || self.returns {
                tool.rapid(self.start())?;
            }
            let near = tool.above(level, CLEAR);
            if !is_last && tool.height(tool.z(), near) > 0.0 {
                tool.rapid_z(near)?;
            }
        }
        Ok(())
    }

    fn level<T: Take>(&self, tool: &mut Tool<'_, T>, level: f64) -> Result<(), T::Error> {
        let [along, across] = self.size;
        let (count, width) = self.widths();
        let beyond = self.beyond();
        tool.set_feed(self.cut.plunge);
        tool.feed_z(level)?;
        tool.set_feed(self.cut.feed);
        if self.strategy == Strategy::Spiral {
            for ring in 0..count {
                let low = width * (f64::from(ring) + 0.5);
                let (right, high) = (along - low, across - low);
                let corners = [[right, low], [right, high], [low, high], [low, low + width]];
                for corner in corners {
                    tool.feed(corner)?;
                }
            }
            return Ok(());
        }
        for pass in 0..count {
            let v = width * (f64::from(pass) + 0.5);
            let back = self.strategy == Strategy::Both && pass % 2 == 1;
            let (from, to) = if back { (along + beyond, -beyond) } else { (-beyond, along + beyond) };
            if self.strategy == Strategy::One && pass > 0 {
                tool.rapid_z(self.planes.safety)?;
                tool.rapid([from, v])?;
                super::pocket::down(tool, level, self.cut.plunge)?;
                tool.set_feed(self.cut.feed);
            }
            tool.feed([from, v])?;
            tool.feed([to, v])?;
        }
        Ok(())
    }
}
