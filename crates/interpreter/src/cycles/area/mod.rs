//! Areas cut level by level with the side of a tool: pockets, bosses, faces, slots, profiles.
//!
//! Each family is two stages, roughing and finishing, so that a tool can be changed between them. What they
//! have in common: [`outline`] the path of the tool centre round a wall, [`clear`] covering what lies
//! within or around it, [`enter`] the way into solid material.
//!
//! ```text
//! parameters ──check──▶ Rough, Finish ──▶ acts, from over the part on the safety level and back to it
//! ```

pub mod boss;
pub mod clear;
pub mod enter;
pub mod facing;
pub mod outline;
pub mod pocket;
pub mod profile;
pub mod slot;

pub use boss::{BossFinish, BossRough};
pub use enter::Entry;
pub use facing::{Facing, Strategy};
pub use outline::{Corner, Outline};
pub use pocket::{PocketFinish, PocketRough, PocketSteps};
pub use profile::{Element, Profile, ProfileError};
pub use slot::{Slot, SlotKind};

use super::milling::steps;
use super::parameter::{WrongParameter, refuse};
use super::tool::{Take, Tool};
use ferrocut_geometry::SAME_POINT_MM;
use ferrocut_machine::Fault;

/// Above material and levels already cut, rapid ends so far away, mm (Fagor 1.8, 4.1.2).
pub const CLEAR: f64 = 1.0;

/// Levels of the tool axis that the stages of an area have in common, mm.
#[derive(Clone, Copy, PartialEq, Debug)]
pub struct Planes {
    /// Where the tool travels between operations.
    pub safety: f64,
    /// Where the first rapid towards the part ends.
    pub approach: f64,
    /// Surface of the part.
    pub surface: f64,
}

/// The tool of a stage, and how it cuts. Lengths in mm, angles in degrees.
#[derive(Clone, Copy, PartialEq, Debug)]
pub struct Cut {
    /// Radius.
    pub radius: f64,
    /// Greatest width of a pass.
    pub step: f64,
    /// Feed.
    pub feed: f64,
    /// Feed along the tool axis.
    pub plunge: f64,
}

impl Cut {
    /// Whether these can cut: the width of a pass at most the diameter; 0 stands for ¾ of it.
    pub fn check(mut self, step: &'static str) -> Result<Cut, WrongParameter> {
        refuse(!(self.radius > 0.0 && self.radius.is_finite()), Fault::MillToolMissing, "T")?;
        refuse(!(self.step >= 0.0), Fault::CycleParameter, step)?;
        if self.step == 0.0 {
            self.step = self.radius * 1.5;
        }
        if self.step > 2.0 * self.radius + SAME_POINT_MM {
            return Err(WrongParameter::beyond(Fault::CycleStepTooWide, step, self.step, 2.0 * self.radius));
        }
        refuse(!(self.feed > 0.0 && self.feed.is_finite()), Fault::CycleNoFeed, "F")?;
        refuse(!(self.plunge > 0.0 && self.plunge.is_finite()), Fault::CycleNoFeed, "F")?;
        Ok(self)
    }
}

/// Passes beyond which nobody counts: far more than an operation may have acts.
const MOST_PASSES: f64 = 1e6;

/// Passes of equal width, none wider than `step`, that cover `width`: how many, and how wide.
pub(crate) fn passes(width: f64, step: f64) -> (u32, f64) {
    if width <= SAME_POINT_MM {
        return (0, 0.0);
    }
    let count = steps(width, step).min(MOST_PASSES);
    (count as u32, width / count)
}

/// Away from a level just cut and over a point in the plane.
pub(crate) fn retreat<T: Take>(tool: &mut Tool<'_, T>, over: [f64; 2]) -> Result<(), T::Error> {
    let z = tool.above(tool.z(), CLEAR);
    tool.rapid_z(z)?;
    tool.rapid(over)
}

#[cfg(test)]
mod tests;
