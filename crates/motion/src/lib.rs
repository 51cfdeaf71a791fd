//! Steps in, setpoints out every servo period.
//!
//! In: [`Move`]s, made from the steps of the toolpath, pushed as long as there is room. Out: one
//! [`Setpoint`] a [`Motion::tick`], within the velocity, acceleration and jerk of every axis whatever the path,
//! the overrides and the moment of a feed hold. Units are mm, degrees and seconds.
//!
//! ```text
//! Move ─▶ assemble ─▶ cells ─▶ plan ─▶ hand over ─▶ interpolate ─▶ Setpoint
//!          path/       timing/queue      handover    timing/
//!          piece, joint, slow,           plan, grid, piece, ramp, interpolate, axes
//!          corner, smooth
//!         └───────── Planner ─────────┘           └ Interpolator ┘
//! ```
//!
//! 1. A move is a curve `q(s)` over all axes (`path/piece`). Runs of lines become one smooth curve inside the
//!    tolerance (`path/smooth`), joints with arcs are eased (`path/joint`), sharp corners rounded in time
//!    (`path/corner`). The path then has a continuous `q″` and a bounded `q‴`.
//! 2. Stretches of it are cells (`timing/queue`), each with bounds of its three derivatives (`limits`).
//! 3. Look-ahead goes section by section (`timing/plan`): on a single line in closed form (`timing/ramp`), else by
//!    passes over steps of a few milliseconds (`timing/grid`), and curves between fast stretches once more (`timing/valley`). The plan is a list of pieces (`timing/piece`).
//! 4. They are handed over some periods before they are run (`planner`, `handover`).
//! 5. They are evaluated in closed form every period (`interpolator`, `timing/interpolate`).
//!
//! Steps 1 to 4 are the [`Planner`], which may take milliseconds; step 5 is the [`Interpolator`], which runs in the
//! servo period. [`Motion`] is both in one thread. None of them allocates, takes a lock or fails, and the same calls
//! give the same setpoints, bit by bit, in one thread or in two.
//!
//! What was passed can be run back, as far as it is still known (`retrace`).
//!
//! What lies between setpoint and drive, axis by axis, is [`servo`]. Moves in step with the spindle do not go
//! through the planner: they are [`synchron`].
//!
//! Read `motion.rs` first (the front and its rules), then `planner.rs` and `handover.rs` (who runs when),
//! `timing/plan.rs` (look-ahead), `limits.rs` (its mathematics) and `path/smooth.rs`.

mod assemble;
mod handover;
mod interpolator;
pub mod jog;
mod limits;
mod motion;
mod moves;
mod path;
mod planner;
mod quick;
mod retrace;
pub mod servo;
mod stroke;
pub mod synchron;
mod timing;

pub use interpolator::{Interpolator, Sample};
pub use jog::Jog;
pub use limits::{Limits, MAX_FEED_OVERRIDE, MAX_SPINDLE_OVERRIDE, Ramps};
pub use motion::{Full, Motion, Setpoint, State};
pub use moves::Move;
pub use planner::{LEAD_S, Planner};
pub use servo::Servo;
