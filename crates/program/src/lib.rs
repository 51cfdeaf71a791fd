//! Part program text to blocks.
pub mod span;
pub use span::{FileId, Span};
