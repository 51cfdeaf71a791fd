//! Drawings as input: PLT and DXF to part programs.
//!
//! In: the bytes of a drawing and how it is to be cut ([`Settings`]). Out: a part program in the words of
//! a control, and for each of its lines the piece of the drawing that caused it ([`Program`]).
//!
//! The way of the data: [`plt`] or [`dxf`] (the file to a [`Drawing`]: what the pen does, lines and
//! arcs in mm) → [`plan`] (chains, inner before outer, short ways between) → [`write`](mod@write) (blocks).
//! Curves that are no arcs become arcs within a tolerance: [`ellipse`] and [`spline`] say how they are
//! divided, [`fit`](mod@fit) how arcs are laid through. Read [`drawing`] first.

pub mod affine;
pub mod drawing;
pub mod dxf;
pub mod ellipse;
pub mod limits;
pub mod plan;
pub mod plt;
pub mod recognise;
pub mod settings;
pub mod spline;
pub mod write;

pub use drawing::Drawing;
pub use ferrocut_geometry::{curve, fit};
pub use recognise::{By, recognise};
pub use settings::{Change, Cutting, Format, Order, Settings};
pub use write::{Program, Style, Summary};

use ferrocut_machine::{Alarm, Fault};
use ferrocut_program::{FileId, Span};

fn alarm(fault: Fault, span: Span) -> Box<Alarm> {
    Box::new(Alarm::core(fault, span))
}

/// Reads a drawing. Spans in it are of `file`.
pub fn read(bytes: &[u8], format: Format, file: FileId, settings: &Settings) -> Result<Drawing, Box<Alarm>> {
    settings.check()?;
    let whole = Span { line: 1, file, ..Span::default() };
    if bytes.len() as u64 > limits::MOST_BYTES {
        let most = (limits::MOST_BYTES >> 20) as f64;
        return Err(limits::Refused::TooMany("megabytes", most).at(whole));
    }
    let drawing = match format {
        Format::Plt => plt::read(bytes, file, settings)?,
        Format::Dxf => dxf::read(bytes, file, settings)?,
    };
    if drawing.is_empty() {
        return Err(alarm(Fault::DrawingEmpty, whole));
    }
    Ok(drawing)
}
