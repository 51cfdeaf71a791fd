//! What is asked for: a cycle with its values, positions and profiles, and what is known of the tools.

use serde::{Deserialize, Serialize};
use std::collections::BTreeMap;

/// A value of a field.
#[derive(Clone, PartialEq, Debug, Deserialize, Serialize)]
#[cfg_attr(feature = "typescript", derive(ts_rs::TS))]
#[serde(untagged)]
pub enum Value {
    /// A number.
    Number(f64),
    /// A word or name.
    Text(String),
}

/// A cycle as a form was filled in.
#[derive(Clone, PartialEq, Debug, Default, Deserialize, Serialize)]
#[cfg_attr(feature = "typescript", derive(ts_rs::TS))]
#[serde(deny_unknown_fields)]
pub struct Request {
    /// The cycle, `G287`.
    pub cycle: String,
    /// Values by the name of their field. What is left out is what the control takes for it.
    #[serde(default)]
    pub values: BTreeMap<String, Value>,
    /// The figure that it is repeated on: none or one.
    #[serde(default)]
    pub positions: Vec<Positions>,
    /// The profile, where the cycle follows or clears one.
    #[serde(default)]
    pub profile: Option<Profile>,
    /// Profiles of depth, of the outer contour and of islands (4.16).
    #[serde(default)]
    pub depths: Vec<Depth>,
    /// What is to be taken for tools instead of the machine's table.
    #[serde(default)]
    pub tools: Vec<ToolData>,
}

/// A figure of positions.
#[derive(Clone, PartialEq, Debug, Default, Deserialize, Serialize)]
#[cfg_attr(feature = "typescript", derive(ts_rs::TS))]
#[serde(deny_unknown_fields)]
pub struct Positions {
    /// `LINE`, `ARC`, `RECT`, `GRID` or `POINTS`.
    pub kind: String,
    /// Values by name.
    #[serde(default)]
    pub values: BTreeMap<String, Value>,
    /// The points behind the first, mm; of `POINTS` alone.
    #[serde(default)]
    pub points: Vec<[f64; 2]>,
}

/// A profile in the plane.
#[derive(Clone, PartialEq, Debug, Default, Deserialize, Serialize)]
#[cfg_attr(feature = "typescript", derive(ts_rs::TS))]
#[serde(deny_unknown_fields)]
pub struct Profile {
    /// The outer contour, then islands.
    pub contours: Vec<Contour>,
}

/// A profile of depth: its abscissa, and the tool axis.
#[derive(Clone, PartialEq, Debug, Deserialize, Serialize)]
#[cfg_attr(feature = "typescript", derive(ts_rs::TS))]
#[serde(deny_unknown_fields)]
pub struct Depth {
    /// `XZ` or `YZ`.
    pub plane: DepthPlane,
    /// What it looks like.
    pub contour: Contour,
}

/// The plane of a profile of depth.
#[derive(Clone, Copy, PartialEq, Eq, Debug, Deserialize, Serialize)]
#[cfg_attr(feature = "typescript", derive(ts_rs::TS))]
pub enum DepthPlane {
    /// X and Z.
    #[serde(rename = "XZ")]
    Xz,
    /// Y and Z.
    #[serde(rename = "YZ")]
    Yz,
}

/// A contour.
#[derive(Clone, PartialEq, Debug, Default, Deserialize, Serialize)]
#[cfg_attr(feature = "typescript", derive(ts_rs::TS))]
#[serde(deny_unknown_fields)]
pub struct Contour {
    /// Where it begins, mm.
    pub start: [f64; 2],
    /// Its elements, each from where the one before ends.
    pub elements: Vec<Element>,
    /// Radius of a tangential way in, mm; 0 for none (4.21).
    #[serde(default)]
    pub entry: f64,
    /// The same of the way out.
    #[serde(default)]
    pub exit: f64,
}

/// An element of a contour.
#[derive(Clone, PartialEq, Debug, Deserialize, Serialize)]
#[cfg_attr(feature = "typescript", derive(ts_rs::TS))]
#[serde(tag = "kind", rename_all = "lowercase", deny_unknown_fields)]
pub enum Element {
    /// A straight line.
    Line {
        /// End point, mm.
        to: [f64; 2],
        /// What is made of the corner at its end.
        #[serde(default)]
        corner: Option<Corner>,
    },
    /// An arc; a circle where it ends where it begins.
    Arc {
        /// End point, mm.
        to: [f64; 2],
        /// Centre, mm.
        center: [f64; 2],
        /// The way round.
        clockwise: bool,
        /// What is made of the corner at its end.
        #[serde(default)]
        corner: Option<Corner>,
    },
}

impl Element {
    /// Where it ends.
    pub fn to(&self) -> [f64; 2] {
        match self {
            Element::Line { to, .. } | Element::Arc { to, .. } => *to,
        }
    }

    /// The corner at its end.
    pub fn corner(&self) -> Option<Corner> {
        match self {
            Element::Line { corner, .. } | Element::Arc { corner, .. } => *corner,
        }
    }
}

/// A corner that is not sharp.
#[derive(Clone, Copy, PartialEq, Debug, Deserialize, Serialize)]
#[cfg_attr(feature = "typescript", derive(ts_rs::TS))]
#[serde(deny_unknown_fields)]
pub struct Corner {
    /// What is made of it.
    pub kind: CornerKind,
    /// Radius, or length along each side, mm.
    pub size: f64,
}

/// What is made of a corner.
#[derive(Clone, Copy, PartialEq, Eq, Debug, Deserialize, Serialize)]
#[cfg_attr(feature = "typescript", derive(ts_rs::TS))]
#[serde(rename_all = "lowercase")]
pub enum CornerKind {
    /// An arc.
    Round,
    /// A straight piece.
    Chamfer,
}

/// What is known of a tool; what is missing is as the machine's table has it.
#[derive(Clone, Copy, PartialEq, Debug, Default, Deserialize, Serialize)]
#[cfg_attr(feature = "typescript", derive(ts_rs::TS))]
#[serde(deny_unknown_fields)]
pub struct ToolData {
    /// Its number.
    pub number: u16,
    /// Its diameter, mm.
    #[serde(default)]
    pub diameter: Option<f64>,
    /// Length of its cutting edge, mm; 0 where not known.
    #[serde(default)]
    pub cutting_length: Option<f64>,
    /// Steepest angle at which it may enter the material, degrees; 0 where not known.
    #[serde(default)]
    pub entry_angle: Option<f64>,
    /// Radius of its rounded tip, mm.
    #[serde(default)]
    pub tip_radius: Option<f64>,
}
