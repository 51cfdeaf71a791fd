//! The way of a milling tool into solid material, from over the middle of what it is to cut.
//!
//! ```text
//! way in the plane = depth / tan(angle)
//! ```

use crate::cycles::milling::steps;
use crate::cycles::parameter::WrongParameter;
use crate::cycles::tool::{Take, Tool};
use ferrocut_geometry::SAME_POINT_MM;
use ferrocut_machine::Fault;
use std::f64::consts::TAU;

/// Most turns or strokes of an entry.
const MAX_STROKES: f64 = 10_000.0;

/// How the tool goes in. Angles in degrees, lengths in mm.
#[derive(Clone, Copy, PartialEq, Debug)]
pub enum Entry {
    /// Along its axis.
    Straight,
    /// To and fro along u, beginning and ending over the middle.
    Zigzag {
        /// Angle against the plane.
        angle: f64,
        /// How far out at most.
        reach: f64,
    },
    /// On a helix through the middle.
    Helix {
        /// Angle against the plane.
        angle: f64,
        /// Its largest radius.
        reach: f64,
    },
}

impl Entry {
    /// The angle of a cycle and of the tool table: 0 in the cycle is that of the table, which also limits it;
    /// 0 in both is straight down (Fagor 4.1.3).
    pub fn angle(cycle: f64, table: f64, word: &'static str) -> Result<Option<f64>, WrongParameter> {
        if !(0.0..=90.0).contains(&cycle) {
            return Err(WrongParameter::new(Fault::CycleEntryAngle, word));
        }
        let angle = match (cycle, table) {
            (_, table) if table <= 0.0 => cycle,
            (0.0, table) => table,
            (cycle, table) => cycle.min(table),
        };
        Ok((angle > 0.0 && angle < 90.0).then_some(angle))
    }

    /// Whether there is room for it, and an end.
    pub fn check(&self, depth: f64, word: &'static str) -> Result<(), WrongParameter> {
        let (Entry::Zigzag { angle, reach } | Entry::Helix { angle, reach }) = *self else { return Ok(()) };
        let way = depth / angle.to_radians().tan();
        // Without room there is no angle but straight down, which the tool is not made for.
        if !(reach > SAME_POINT_MM) || !(way / reach <= MAX_STROKES) {
            return Err(WrongParameter::new(Fault::CycleEntryAngle, word));
        }
        Ok(())
    }

    /// Takes the tool from over the origin down to `bottom` there.
    pub fn enter<T: Take>(&self, tool: &mut Tool<'_, T>, bottom: f64) -> Result<(), T::Error> {
        let top = tool.z();
        let depth = tool.height(top, bottom);
        let (angle, reach) = match *self {
            Entry::Zigzag { angle, reach } | Entry::Helix { angle, reach } if depth > SAME_POINT_MM => {
                (angle, reach)
            }
            _ => return tool.feed_z(bottom),
        };
        let way = depth / angle.to_radians().tan();
        match self {
            Entry::Helix { .. } => {
                let turns = steps(way, TAU * reach);
                let radius = way / (TAU * turns);
                tool.turns([radius, 0.0], turns, bottom)
            }
            _ => {
                let strokes = steps(way, 2.0 * reach);
                let out = way / (2.0 * strokes);
                for stroke in 1..=(2.0 * strokes) as u32 {
                    let z = tool.above(top, -depth * f64::from(stroke) / (2.0 * strokes));
                    let z = if f64::from(stroke) == 2.0 * strokes { bottom } else { z };
                    tool.ramp([if stroke % 2 == 1 { out } else { 0.0 }, 0.0], z)?;
                }
                Ok(())
            }
        }
    }
}
