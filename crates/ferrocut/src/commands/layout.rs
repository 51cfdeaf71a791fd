//! Text in columns, and how it is printed.

pub use crate::stdout::print;
pub use ferrocut_desk::layout::*;
