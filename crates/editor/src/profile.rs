//! Contours from drawings.

use crate::block::MOST_ELEMENTS;
use crate::finding::Wrong;
use crate::request::{Contour, Element};
use ferrocut_exchange::plan::chains::{Chain, join};
use ferrocut_exchange::plan::cuts;
use ferrocut_exchange::{Format, Settings};
use ferrocut_machine::Fault;
use ferrocut_program::FileId;

/// What a drawing holds.
#[derive(Clone, PartialEq, Debug, Default)]
pub struct FromDrawing {
    /// Its contours, the one with the largest extent first; mm.
    pub contours: Vec<Contour>,
    /// Whether each ends where it begins.
    pub closed: Vec<bool>,
    /// What is wrong, or was left out.
    pub wrong: Vec<Wrong>,
}

/// Reads the contours of a DXF drawing: curves that meet are joined, splines and ellipses become arcs within
/// 0.01 mm.
pub fn from_dxf(bytes: &[u8]) -> FromDrawing {
    let settings = Settings::default();
    let drawing = match ferrocut_exchange::read(bytes, Format::Dxf, FileId(1), &settings) {
        Ok(drawing) => drawing,
        Err(alarm) => return FromDrawing { wrong: vec![Wrong::of(*alarm)], ..FromDrawing::default() },
    };
    let mut from = FromDrawing {
        wrong: drawing.warnings.iter().cloned().map(|alarm| Wrong::of(alarm.as_warning())).collect(),
        ..FromDrawing::default()
    };
    let cuts: Vec<_> = cuts(&drawing).filter(|cut| cut.curve.length() > 0.0).collect();
    if cuts.len() > MOST_ELEMENTS {
        from.wrong.push(Wrong::new(Fault::CycleProfile, "profile"));
        return from;
    }
    let chains = join(&cuts);
    let mut all: Vec<(f64, Contour, bool)> = chains
        .iter()
        .map(|chain| {
            let [low, high] = chain.extent();
            ((high[0] - low[0]) * (high[1] - low[1]), contour(&chain), chain.is_closed)
        })
        .collect();
    all.sort_by(|(a, ..), (b, ..)| b.total_cmp(a));
    for (_, contour, is_closed) in all {
        from.contours.push(contour);
        from.closed.push(is_closed);
    }
    from
}

/// The elements of a chain. Ends that meet within a micrometre are one, and a closed chain ends where it begins.
fn contour(chain: &Chain<'_>) -> Contour {
    let start = chain.from();
    let last = chain.cuts.len().saturating_sub(1);
    let element = |(number, cut): (usize, &ferrocut_exchange::plan::Cut)| {
        let to = if number == last && chain.is_closed { start } else { cut.curve.to };
        match cut.curve.bend {
            None => Element::Line { to, corner: None },
            Some(bend) => Element::Arc { to, center: bend.center, clockwise: bend.sweep < 0.0, corner: None },
        }
    };
    let elements = chain.cuts.iter().enumerate().map(element).collect();
    Contour { start, elements, entry: 0.0, exit: 0.0 }
}
