//! Where: the curves of the moves, and what replaces them at joints and along runs of short blocks.

pub(crate) mod corner;
pub(crate) mod fit;
pub(crate) mod joint;
pub(crate) mod link;
pub(crate) mod pace;
pub(crate) mod piece;
pub(crate) mod shape;
pub(crate) mod slow;
pub(crate) mod smooth;
pub(crate) mod swing;
