//! How fast: ramps between speeds, look-ahead over the cells, interpolation in time.

pub(crate) mod axes;
pub(crate) mod beside;
pub(crate) mod brake;
pub(crate) mod chain;
pub(crate) mod grid;
pub(crate) mod interpolate;
pub(crate) mod overrides;
pub(crate) mod piece;
pub(crate) mod plan;
pub(crate) mod queue;
pub(crate) mod ramp;
pub(crate) mod valley;
