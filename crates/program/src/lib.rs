//! Part program text to blocks.
//!
//! In: the bytes of files. Out: blocks of words and statements, every one with the span of text that
//! it came from, and the programs found in them by number or name. Nothing here knows what a word
//! means; what differs between control languages is data in a [`Syntax`].
//!
//! The way of the data: [`text`] (bytes of a file, whole or in windows) → [`lexer`] (one page of
//! text at a time) → [`page`] (blocks, words, expression nodes, flat) → [`memory`] (the programs, and
//! reading them block by block). Read [`page`] first.
//!
//! Flat programs stream: a file is lexed page by page, and only the pages last used are kept. A main program
//! may also be sent bit by bit ([`Text::sent`]): it is read as far as it came, and lines that are done are given
//! back.

pub mod encoding;
pub mod expression;
pub mod lexer;
pub mod memory;
pub mod names;
pub mod number;
pub mod page;
mod sent;
pub mod span;
pub mod syntax;
pub mod text;

pub use encoding::{Decoder, Encoding};
pub use expression::{Binary, Function, Node, Unary};
pub use lexer::NGC_OPERATORS;
pub use memory::{Place, ProgramId, ProgramMemory, Source};
pub use names::{FIRST_NAMED, Names};
pub use page::{
    Argument, Block, Defect, DefectKind, Directive, ExprRange, Label, OKeyword, OWord, Page, Statement,
    TextRange, Value, Word,
};
pub use sent::{MOST_KEPT, Refused};
pub use span::{FileId, Span};
pub use syntax::{Keyword, Syntax, numbered_axis, numbered_axis_name};
pub use text::{OpenError, Text};
