//! How GSK990MC programs are written: sections 3.1 and 4.9.

use crate::dialects::fanuc;
use ferrocut_program::Syntax;

/// That of all Fanuc-like languages; a line of more than 1024 bytes is alarm 0026, a condition that compares nothing 0125 (4.9.5).
pub static SYNTAX: Syntax = Syntax { max_line: 1024, conditions_compare: true, ..fanuc::SYNTAX };
