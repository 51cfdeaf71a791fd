//! What a control keeps while its power is off: programs, parameters, offsets with wear, work zeros, variables,
//! pitch tables, what the ladder keeps, counters, histories, the last position; and who may change it.
//!
//! In: [`Change`]s with their [`Author`]. Out: the same values at any later time, whatever happened between:
//! a commit that returned survives a kill and a power cut, and damage is found and never read as a value.
//!
//! The way of the data: [`items`] (what there is) → `apply` (may it, and what is logged) → `rows` →
//! `database` (the only SQL). Read [`items`] first, then [`store`]; `docs/memory.md` has it for the shop.

mod apply;
pub mod author;
pub mod backup;
pub mod control;
pub mod damage;
mod database;
pub mod error;
pub mod items;
mod mark;
mod migrate;
pub mod password;
pub mod rights;
mod rows;
mod snapshot;
pub mod store;
mod table;
mod writer;

pub use author::{Author, Session};
pub use backup::{Backup, BackupEntry};
pub use damage::{Damage, GoodState, Source};
pub use error::{Error, Finding};
pub use items::{
    AlarmEntry, Change, Contents, Counter, InterruptedRun, Item, LastPosition, LogEntry, PlcArea, Program,
    ProgramEntry, SessionNote, SignalSize, Time, is_program_name,
};
pub use password::Seat;
pub use rights::Level;
pub use store::{OpenError, Pending, Reader, Settings, Store};
