//! Milling cycles: one block that clears a pocket or finishes a wall.
//!
//! In: the words of the cycle in millimetres, absent ones as `None`. Out: a [`Plan`], or the
//! [`CycleFault`] that forbids it. The plan says where the cycle begins and makes its moves one by one.
//!
//! ```text
//! words ──check──▶ Plan ──start()──▶ the caller's rapid over the start, at the initial level
//!                       ──moves()──▶ rapid to R … the work … rapid to the return level
//! ```
//!
//! Two layers. *Neutral shapes*: [`depths`], [`helix`], [`tangent`], [`circle`], [`rectangle`] know no
//! control and draw through a [`Cutter`], always counter-clockwise and starting on the +u side of a
//! local frame, which turns and mirrors them. *Sequences of the GSK990MC* on top ([`plan`]): roughing
//! (G22, G23, G33, G34) and finishing (G24–G26, G32, G35–G38), with one file per pair of codes for
//! the words and what is legal.
//!
//! Points are programmed X, Y, Z, millimetres, of the tool centre: the cycle has taken the tool radius
//! into account, cutter radius compensation must not do so again.
//!
//! Read [`plan`] first, then [`round_pocket`](RoundPocket).

pub mod circle;
pub mod cutter;
pub mod depths;
pub mod helix;
pub mod plan;
pub mod rectangle;
pub mod tangent;

mod circle_finish;
pub(crate) mod count;
mod fault;
mod rect_finish;
mod rect_pocket;
mod round_pocket;
mod words;

pub use circle_finish::CircleFinish;
pub(crate) use count::steps;
pub use cutter::{Cutter, CycleMove};
pub use fault::{CycleFault, MAX_MOVES, Problem};
pub use plan::Plan;
pub use rect_finish::RectFinish;
pub use rect_pocket::RectPocket;
pub use round_pocket::RoundPocket;
pub use words::{Roughing, Side};

#[cfg(test)]
mod tests;
