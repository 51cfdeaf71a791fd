//! Steps in, setpoints out every servo period.
//!
//! In: [`Move`]s, made from the steps of the toolpath, pushed as long as there is room. Out: one
//! [`Setpoint`] a [`Motion::tick`], within the velocity and acceleration of every axis whatever the path,
//! the overrides and the moment of a feed hold. Units are mm, degrees and seconds.
//!
//! ```text
//! Move ─▶ assemble ─▶ cells ─▶ plan ─▶ interpolate ─▶ Setpoint
//!          piece       line,    how fast   where and how
//!          blend       blend,   a cell may  fast now
//!                      slice    be entered
//! ```
//!
//! 1. A move is a curve `q(s)` over all axes (`piece`). Joints that turn by no more than 20° are replaced
//!    by parabolas inside the path tolerance, so that `q'` is continuous and `q''` bounded (`blend`).
//! 2. Lines between blends, blends and slices of arcs are cells. For each the limits of all axes become two
//!    numbers: `v ≤ v_max` and `|a| ≤ a₀ − fade·v²` (`limits`).
//! 3. A sweep backwards in `v²` gives the speed at which each cell may be entered (`plan`).
//! 4. Inside a cell speed goes up, cruises and goes down, in phases of constant acceleration evaluated in
//!    closed form from their start (`profile`, `interpolate`).
//!
//! As velocity is continuous and acceleration within limits at every moment, their means over a servo
//! period are too, however many cells end inside one.
//!
//! [`Motion::tick`] and [`Motion::push`] allocate nothing, take no lock and do not fail. The same calls
//! give the same setpoints, bit by bit.
//!
//! What it does not do yet: limit jerk; round corners sharper than 20°; smooth many short blocks at once.
//!
//! What lies between setpoint and drive, axis by axis, is [`servo`]. Moves in step with the spindle do not go
//! through the planner: they are [`synchron`].
//!
//! Read `motion.rs` first (the front and its rules), then `plan.rs` (look-ahead) and `limits.rs` (its
//! mathematics).

mod assemble;
mod blend;
mod interpolate;
mod limits;
mod motion;
mod moves;
mod piece;
mod plan;
mod profile;
pub mod servo;
mod stroke;
pub mod synchron;

pub use limits::{Limits, MAX_FEED_OVERRIDE};
pub use motion::{Full, Motion, Setpoint, State};
pub use moves::Move;
pub use servo::Servo;
