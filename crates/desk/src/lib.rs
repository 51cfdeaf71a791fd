//! What people ask of a control at a desk.
//!
//! In: words that somebody asks about, or a program that is checked. Out: pages that explain, and findings with the
//! words at fault, as data and as text. [`Book`] has all that is known of a control; read it first. Nothing here reads
//! a file: whoever asks about a place of a program brings the program.

pub mod asked;
mod book;
mod describe;
pub mod finding;
pub mod layout;
pub mod names;
pub mod page;
mod place;
mod word;

pub use asked::Asked;
pub use book::{Book, memory_of};
pub use finding::Finding;
pub use page::Page;
