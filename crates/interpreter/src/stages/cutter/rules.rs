//! What controls do differently: data, chosen by the dialect and its parameters.

/// How the vector is built up and taken away again (GSK990MC 4.7.3 points 1 and 4, NO40.0; Fanuc SUP).
/// Only outside corners differ; inside both types stand square to the block in the mode.
#[derive(Clone, Copy, PartialEq, Eq, Debug)]
pub enum StartUp {
    /// Straight to the point square to the block in the mode.
    A,
    /// Round the corner as in the mode, so that no corner of the workpiece is cut.
    B,
}

/// The way round an outside corner in the mode.
#[derive(Clone, Copy, PartialEq, Eq, Debug)]
pub enum Outside {
    /// Straight pieces (Fanuc, GSK990MC): at corners of 90° and more the offset lines (of arcs: the
    /// tangents) run on to their crossing, below 90° both run on by the radius and are joined.
    Lines,
    /// An arc about the corner point.
    Arc,
}

/// A block that runs exactly back along the one before.
#[derive(Clone, Copy, PartialEq, Eq, Debug)]
pub enum Reversal {
    /// Round the end of the slit as round any acute corner.
    Around,
    /// [`Fault::Reversal`](super::Fault::Reversal).
    Fault,
}

/// A block in the mode whose movement in the plane is zero (GSK990MC 4.7.3 point 8 b).
#[derive(Clone, Copy, PartialEq, Eq, Debug)]
pub enum ZeroMove {
    /// The block before ends square, as before a block that cannot be seen ahead.
    Square,
    /// As any other block without movement.
    Idle,
}

/// An arc that a change of side lengthens beyond a full turn (GSK990MC 4.7.3 point 5 vi).
#[derive(Clone, Copy, PartialEq, Eq, Debug)]
pub enum OverTurn {
    /// [`Fault::Interference`](super::Fault::Interference), as GSK990MC says.
    Fault,
    /// The short arc between the two crossings, as Fanuc does.
    Shorten,
}

/// How far a control looks ahead, and with it what it does at a corner.
#[derive(Clone, Copy, PartialEq, Eq, Debug)]
pub enum Method {
    /// Vectors at the crossings of the offset curves ([`Compensator`](super::Compensator)), by the rules below.
    Vectors,
    /// One move ([`OneAhead`](super::OneAhead)), which asks none of them.
    OneAhead,
}

/// The policy of one control.
#[derive(Clone, Copy, PartialEq, Debug)]
pub struct Rules {
    /// The type of compensation.
    pub method: Method,
    /// NO40.0.
    pub start_up: StartUp,
    /// Outside corners in the mode.
    pub outside: Outside,
    /// Whether interference is looked for at all (NO41.6). The faults of impossible geometry remain.
    pub interference: bool,
    /// Whether a start-up block shorter than the radius counts as interference
    /// (GSK990MC 4.7.3 point 10, condition 1).
    pub long_start_up: bool,
    /// Blocks that run exactly back.
    pub reversal: Reversal,
    /// Blocks of zero length.
    pub zero_move: ZeroMove,
    /// Arcs lengthened beyond a full turn.
    pub over_turn: OverTurn,
    /// So many blocks without movement may stand between two moves in the mode; one more is
    /// [`Fault::TooManyIdleBlocks`](super::Fault::TooManyIdleBlocks).
    pub idle_blocks: usize,
    /// From so many blocks without movement on, the control no longer sees the next move: the block
    /// before ends square. None: it sees past all it allows.
    pub blind_from: Option<usize>,
    /// ΔV of GSK990MC 4.7.3 point 9: of vectors at an outside corner whose ends differ by no more than this on
    /// both axes the later is ignored, mm.
    pub corner_limit: f64,
}

impl Default for Rules {
    /// Fanuc 0i-M and GSK990MC with their standard parameters.
    fn default() -> Rules {
        Rules {
            method: Method::Vectors,
            start_up: StartUp::A,
            outside: Outside::Lines,
            interference: true,
            long_start_up: true,
            reversal: Reversal::Around,
            zero_move: ZeroMove::Square,
            over_turn: OverTurn::Fault,
            idle_blocks: 10,
            blind_from: None,
            corner_limit: 0.0,
        }
    }
}
