//! The stages a programmed point passes on its way to the axes, in this order, one file each:
//!
//! `words → polar → inch/metric → absolute/incremental → scaling and mirror → rotation → work offset →
//! chamfer and corner rounding → cutter radius compensation → tool length → machine axes`
//!
//! The first, [`words`](crate::words), is shared by everything a block says. Inch/metric stands inside
//! polar and absolute/incremental, because an angle has no inch. A control that keeps transformations as a
//! stack has [`nesting`] in the place of scaling, mirror and rotation.

pub mod corner;
pub mod cutter;
pub mod distance;
pub mod nesting;
pub mod polar;
pub mod rotation;
pub mod scaling;
pub mod tool_length;
pub mod units;
pub mod work_offset;
