//! The order in which a drawing is cut.
//!
//! As drawn, a PLT drawing says itself what the pen does; of a DXF drawing each curve that does not go on
//! where the one before it ended is led to by itself. Otherwise curves are joined into chains
//! ([`chains`]), a chain waits for what lies inside of it ([`nest`]), tools come in the order with the fewest
//! changes ([`tools`]), and the nearest one that is free comes next ([`order`]).

pub mod chains;
pub mod nest;
pub mod order;
pub mod tools;

use crate::curve::Curve;
use crate::drawing::{Action, Drawing, Move};
use crate::settings::{Format, Order};
use ferrocut_geometry::vector::distance;
use ferrocut_program::Span;

/// Ends of curves that are no further apart meet, mm.
pub const MEET: f64 = 0.001;

/// A curve of the drawing with its layer and place.
#[derive(Clone, Copy, PartialEq, Debug)]
pub struct Cut {
    /// The curve.
    pub curve: Curve,
    /// Number of the layer.
    pub layer: u32,
    /// The piece of the drawing.
    pub span: Span,
}

/// What the pen does, in the order asked for.
pub fn plan(drawing: &Drawing, order: Order) -> Vec<Move> {
    // Ways of a raised pen have no other order than their own.
    let order = if drawing.cuts() { order } else { Order::AsDrawn };
    match (order, drawing.format) {
        (Order::AsDrawn, Format::Plt) => drawing.moves.clone(),
        (Order::AsDrawn, Format::Dxf) => {
            let mut moves = Moves::default();
            cuts(drawing).for_each(|cut| moves.cut(cut));
            moves.finish()
        }
        (Order::Shortest, _) => {
            let cuts: Vec<Cut> = cuts(drawing).collect();
            let chains = chains::join(&cuts);
            drop(cuts);
            let nest = nest::Nest::of(&chains);
            let mut moves = Moves::default();
            order::shortest(&chains, nest.as_ref(), drawing, |cut| moves.cut(cut));
            moves.finish()
        }
    }
}

/// The curves of a drawing. A pen set down and raised again in one place is a curve without length.
pub fn cuts(drawing: &Drawing) -> impl Iterator<Item = Cut> {
    let mut at = [0.0; 2];
    let mut dot: Option<Move> = None;
    drawing.moves.iter().filter_map(move |m| {
        match m.action {
            Action::Travel(to) => at = to,
            Action::Lower => dot = Some(*m),
            Action::Raise => {
                let m = dot.take()?;
                return Some(Cut { curve: Curve::line(at, at), layer: m.layer, span: m.span });
            }
            Action::Cut(curve) => {
                dot = None;
                at = curve.to;
                return Some(Cut { curve, layer: m.layer, span: m.span });
            }
        }
        None
    })
}

/// Cuts with the ways between them.
#[derive(Default)]
struct Moves {
    moves: Vec<Move>,
    last: Option<Cut>,
}

impl Moves {
    /// Adds a cut: without raising where it goes on from the last one.
    fn cut(&mut self, cut: Cut) {
        let Cut { curve, layer, span } = cut;
        let mut push = |action| self.moves.push(Move { action, z: None, layer, span });
        let goes_on =
            self.last.is_some_and(|last| last.layer == layer && distance(last.curve.to, curve.from) <= MEET);
        if !goes_on {
            push(Action::Raise);
            push(Action::Travel(curve.from));
            push(Action::Lower);
        }
        push(Action::Cut(curve));
        self.last = Some(cut);
    }

    fn finish(mut self) -> Vec<Move> {
        if let Some(Cut { layer, span, .. }) = self.last {
            self.moves.push(Move { action: Action::Raise, z: None, layer, span });
        }
        self.moves
    }
}
