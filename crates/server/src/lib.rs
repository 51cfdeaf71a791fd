//! The machine for others.
//!
//! In: bytes of whoever connects. Out: answers, and what the machine is told.
//!
//! [`grbl`] is the protocol of Grbl 1.1 as a state machine without a connection; read it first. [`mill`] is the machine
//! that it drives. [`web`] is the panel in a browser.

pub mod grbl;
mod helm;
pub mod hub;
pub mod lines;
pub mod link;
pub mod mill;
pub mod panel;
pub mod remote;
pub mod runner;
pub mod service;
pub mod signals;
pub mod told;
pub mod web;
