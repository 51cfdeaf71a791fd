//! Profile pockets: any outer contour with any islands, walls upright or sloping (Fagor 4.15, 4.16).
//!
//! In: the parameters of a pocket in millimetres and degrees, profiles as chains of lines and arcs
//! ([`Pocket2d`], [`Pocket3d`]). Out: a plan, or the [`PocketFault`] that forbids it. The plan makes the moves
//! of each stage one by one, with a tool change in between, and can be kept as bytes ([`Plan2d::save`]).
//!
//! ```text
//! drawing ─corner─▶ Profile ─contours─▶ walls ─paths at a distance, judged─▶ rings ─order─▶ chains
//!                                          │                                                 │
//!                                          └──────────▶ finish, slopes                       └─▶ clear: by levels
//! ```
//!
//! *Geometry*: `segment`, `meet`, `index`, [`corner`], `profile`, `contours`. *Paths*: `walls` offsets and
//! judges, `polygons` is its way out, `ring`, `rings` and `chains` make an area's concentric paths and their
//! order. *Cutting*: `passes` (widths and levels), `descent` (entry under an angle), `clear` (an area),
//! `finish` (an upright wall), `depth_profile` and `slopes` (a sloping one). On top the two sequences, and
//! `store`. `cut` hands a stage on as acts of a cycle, and `kept` is the door to where stored pockets lie.
//!
//! Points are of the tool centre at its tip, in the two axes of the plane and the tool axis: the tool radius
//! has been taken into account. Nothing here knows of programs, tool tables or files.
//!
//! Read [`Pocket2d`] first, then `walls`.

pub mod corner;

mod chains;
mod clear;
mod contours;
mod cut;
mod depth_profile;
mod descent;
mod finish;
mod index;
mod kept;
mod meet;
mod passes;
mod pen;
mod pocket2d;
mod pocket3d;
mod polygons;
mod problem;
mod profile;
mod ring;
mod rings;
mod segment;
mod slopes;
mod store;
mod tool;
mod walls;

pub use cut::{PocketCut, PocketPlan};
pub use depth_profile::DepthProfile;
pub use kept::{KeptPockets, Planning, PocketKind};
pub use pen::{PocketFeed, PocketSink};
pub use pocket2d::{Finish2d, Plan2d, Pocket2d, Rough2d};
pub use pocket3d::{Finish3d, Plan3d, Pocket3d, Rough3d, Semi3d};
pub use problem::{MAX_MOVES, PocketFault, Problem, Stage};
pub use profile::Profile;
pub use segment::Segment;
pub use slopes::WallDirection;
pub use store::is_stored;
pub use tool::Tool;

#[cfg(test)]
mod tests;
