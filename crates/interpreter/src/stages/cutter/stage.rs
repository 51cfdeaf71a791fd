//! The stage in the way that a control has it: one front for the methods of [`Method`].

use super::{Compensator, Done, FaultAt, Method, Offset, OneAhead, Out, PlaneMove, Rules};

/// The stage.
#[expect(clippy::large_enum_variant, reason = "a run has one of it")]
#[derive(Clone, Debug)]
pub enum Stage<T> {
    /// Vectors at the crossings of offset curves.
    Vectors(Compensator<T>),
    /// One move ahead.
    OneAhead(OneAhead<T>),
}

impl<T: Clone> Stage<T> {
    /// A stage in the cancelled state.
    pub fn new(rules: Rules) -> Stage<T> {
        match rules.method {
            Method::Vectors => Stage::Vectors(Compensator::new(rules)),
            Method::OneAhead => Stage::OneAhead(OneAhead::new()),
        }
    }

    /// Other rules, from the next corner on.
    pub fn set_rules(&mut self, rules: Rules) {
        if let Stage::Vectors(stage) = self {
            stage.set_rules(rules);
        }
    }

    /// G41, G42, G40, D: valid from the next move on.
    pub fn set(&mut self, offset: Option<Offset>) {
        match self {
            Stage::Vectors(stage) => stage.set(offset),
            Stage::OneAhead(stage) => stage.set(offset),
        }
    }

    /// How much longer a trimmed arc may be than it was, rad ([`OneAhead::set_longer`]).
    pub fn set_longer(&mut self, longer: f64) {
        if let Stage::OneAhead(stage) = self {
            stage.set_longer(longer);
        }
    }

    /// The next move runs without compensation, the one after it starts up again.
    pub fn suspend(&mut self) {
        if let Stage::Vectors(stage) = self {
            stage.suspend();
        }
    }

    /// Whether a vector stands or waits.
    #[inline]
    pub fn in_mode(&self) -> bool {
        match self {
            Stage::Vectors(stage) => stage.in_mode(),
            Stage::OneAhead(stage) => stage.in_mode(),
        }
    }

    /// Whether a move to the end of the path counts ([`OneAhead::takes_still_moves`]).
    #[inline]
    pub fn takes_still_moves(&self) -> bool {
        match self {
            Stage::Vectors(_) => false,
            Stage::OneAhead(stage) => stage.takes_still_moves(),
        }
    }

    /// Whether moves that stand still in the plane are given to [`Self::push`] too.
    #[inline]
    pub fn takes_every_move(&self) -> bool {
        matches!(self, Stage::OneAhead(_))
    }

    /// The vector is gone: the next move is the first. [`Self::flush`] first what waits.
    pub fn forget(&mut self) {
        match self {
            Stage::Vectors(stage) => stage.forget(),
            Stage::OneAhead(stage) => stage.forget(),
        }
    }

    /// The next move in the plane.
    pub fn push(&mut self, m: PlaneMove, payload: T, out: &mut impl FnMut(Out<T>)) -> Done<T> {
        match self {
            Stage::Vectors(stage) => stage.push(m, payload, out),
            Stage::OneAhead(stage) => stage.push(m, payload, out),
        }
    }

    /// Anything that does not move in the plane; it keeps its place.
    pub fn pass(&mut self, payload: T, counts_as_idle: bool, out: &mut impl FnMut(Out<T>)) -> Done<T> {
        match self {
            Stage::Vectors(stage) => stage.pass(payload, counts_as_idle, out),
            Stage::OneAhead(stage) => stage.pass(payload, out),
        }
    }

    /// A block that made nothing ([`Compensator::idle`]).
    pub fn idle(
        &mut self,
        is_zero_move: bool,
        out: &mut impl FnMut(Out<T>),
    ) -> Result<(), Option<FaultAt<T>>> {
        match self {
            Stage::Vectors(stage) => stage.idle(is_zero_move, out),
            Stage::OneAhead(_) => Ok(()),
        }
    }

    /// G39 ([`Compensator::corner_arc`]).
    pub fn corner_arc(&mut self, payload: T) -> Done<T> {
        match self {
            Stage::Vectors(stage) => stage.corner_arc(payload),
            Stage::OneAhead(_) => {
                Err(FaultAt { fault: super::Fault::CornerArcOutsideMode, at: payload, before: None })
            }
        }
    }

    /// Hands out all that waits before compensation is cancelled.
    pub fn finish(&mut self, out: &mut impl FnMut(Out<T>)) -> Done<T> {
        match self {
            Stage::Vectors(stage) => stage.flush(out),
            Stage::OneAhead(stage) => stage.finish(out),
        }
    }

    /// Hands out all that waits.
    pub fn flush(&mut self, out: &mut impl FnMut(Out<T>)) -> Done<T> {
        match self {
            Stage::Vectors(stage) => stage.flush(out),
            Stage::OneAhead(stage) => stage.flush(out),
        }
    }
}
