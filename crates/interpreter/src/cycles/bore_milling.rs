//! Bores widened on a helix (Fagor 1.10, 4.5).
//!
//! ```text
//! path radius  ρ = J/2 − r
//! helix        one pitch |B| a turn, from the entry level to the bottom: sweep = 2π·depth/|B|
//! ```
//!
//! The tool enters in air, on a half circle from the middle that runs into the helix, and leaves on one
//! that ends over the middle.

use super::parameter::{WrongParameter, positive, refuse};
use super::tool::{Take, Tool};
use ferrocut_geometry::SAME_POINT_MM;
use ferrocut_machine::Fault;
use std::f64::consts::{PI, TAU};

/// Most turns of a helix.
pub(super) const MAX_TURNS: f64 = 10_000.0;

/// A bore to mill. Lengths in mm; levels are coordinates of the tool axis.
#[derive(Clone, Copy, PartialEq, Debug)]
pub struct BoreMilling {
    /// Where the first rapid ends.
    pub reference: f64,
    /// Surface of the part.
    pub surface: f64,
    /// Where the bore ends.
    pub bottom: f64,
    /// Where the tool returns to.
    pub top: f64,
    /// Its diameter.
    pub diameter: f64,
    /// Diameter that is there already; 0 for none.
    pub drilled: f64,
    /// Pitch of the helix.
    pub pitch: f64,
    /// The bottom is milled once round.
    pub mills_bottom: bool,
    /// Radius of the tool.
    pub tool_radius: f64,
    /// Feed.
    pub feed: f64,
}

/// What a control calls the parameters.
#[derive(Clone, Copy, PartialEq, Eq, Debug)]
pub struct BoreNames {
    /// Diameter.
    pub diameter: &'static str,
    /// Diameter that is there already.
    pub drilled: &'static str,
    /// Pitch.
    pub pitch: &'static str,
    /// Depth.
    pub depth: &'static str,
}

impl BoreMilling {
    /// Whether the tool can mill the bore: r < J/2, and r ≥ (J−K)/4 lest a core stand (1.10).
    pub fn check(&self, names: BoreNames) -> Result<(), WrongParameter> {
        let diameter = positive(self.diameter, names.diameter)?;
        let radius = self.tool_radius;
        refuse(!(radius > 0.0), Fault::MillToolMissing, "T")?;
        if !(radius < diameter / 2.0) {
            return Err(WrongParameter::beyond(Fault::CycleToolTooLarge, "T", radius, diameter / 2.0));
        }
        refuse(!(self.drilled >= 0.0 && self.drilled.is_finite()), Fault::CycleParameter, names.drilled)?;
        let least = (diameter - self.drilled) / 4.0;
        if radius < least - SAME_POINT_MM {
            return Err(WrongParameter::beyond(Fault::CycleToolTooSmall, "T", radius, least));
        }
        positive(self.pitch, names.pitch)?;
        let depth = (self.reference - self.bottom).abs();
        refuse(!(depth > 0.0 && depth.is_finite()), Fault::CycleNoDepth, names.depth)?;
        refuse(!(depth / self.pitch <= MAX_TURNS), Fault::CycleParameter, names.pitch)
    }

    /// Mills the bore about the origin of the frame, over which the tool stands.
    pub fn mill<T: Take>(&self, tool: &mut Tool<'_, T>) -> Result<(), T::Error> {
        let radius = self.diameter / 2.0 - self.tool_radius;
        tool.set_feed(self.feed);
        tool.rapid_z(self.reference)?;
        // 1 mm above the surface, or on the reference level where that is nearer.
        let entry = tool.above(self.surface, 1.0);
        let entry = if tool.height(entry, self.reference) > 0.0 { self.reference } else { entry };
        tool.rapid_z(entry)?;
        tool.half_circle([radius, 0.0], [radius / 2.0, 0.0], 1.0, entry)?;
        let sweep = TAU * tool.height(entry, self.bottom) / self.pitch;
        let (sin, cos) = sweep.sin_cos();
        let end = [radius * cos, radius * sin];
        // A helix of whole turns ends over its start, and is a move all the same.
        match (sweep / TAU).fract() == 0.0 {
            true => tool.turns([0.0; 2], sweep / TAU, self.bottom)?,
            false => tool.helix(end, [0.0; 2], sweep, self.bottom)?,
        }
        if self.mills_bottom {
            tool.turns([0.0; 2], 1.0, self.bottom)?;
        }
        tool.helix([0.0; 2], [end[0] / 2.0, end[1] / 2.0], PI, self.bottom)?;
        tool.rapid_z(self.top)
    }
}
