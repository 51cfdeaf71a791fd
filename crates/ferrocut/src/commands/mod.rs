//! The commands, one file each.

pub mod check;
pub mod run;
pub mod time;
pub mod trace;
pub mod view;
