//! The running CNC.
pub mod supervision;
pub use supervision::Supervisor;
