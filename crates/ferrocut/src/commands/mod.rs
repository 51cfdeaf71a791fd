//! The commands, one file each.

pub mod check;
pub mod explain;
pub mod import;
pub mod layout;
pub mod machine;
pub mod memory;
pub mod names;
pub mod plc;
pub mod plot;
pub mod restart;
pub mod run;
pub mod serve;
pub mod time;
pub mod trace;
pub mod view;
