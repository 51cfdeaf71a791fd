//! The stages a programmed point passes on its way to the axes, in this order, one file each:
//!
//! `words → inch/metric → absolute/incremental → work offset → tool length → machine axes`
//!
//! The first, [`words`](crate::words), is shared by everything a block says.

pub mod distance;
pub mod tool_length;
pub mod units;
pub mod work_offset;
