//! What the axes do over time, for tuning a machine.
//!
//! In: the periods of a run, one by one ([`Gauge`]). Out: an SVG ([`draw()`]) and the highest values. However long
//! the run is, the memory stays the same: `series` keeps columns of lowest and highest, `path_error` the moves
//! about the axes.

mod draw;
mod gauge;
mod path_error;
mod series;

pub use draw::draw;
pub use gauge::{Gauge, Peak, QUANTITIES};
