//! What is wrong with the words of a milling cycle.

/// Why a cycle cannot be cut. The number in brackets is the alarm of the GSK990MC.
#[derive(Clone, Copy, PartialEq, Eq, Debug)]
pub enum Problem {
    /// Step over that does not advance, or a start nearer to the wall than the tool radius (185).
    StepTooSmall,
    /// Step over beyond the tool diameter, or a start outside the pocket (186).
    StepTooLarge,
    /// The tool, or its helix, does not fit (187).
    ToolTooLarge,
    /// Corner radius beyond half a side (188).
    CornerTooLarge,
    /// Corner radius below the tool radius (189).
    CornerTooSmall,
    /// Clearance of the rapid above uncut material absent or not above 0 (190).
    GapMissing,
    /// First depth of cut absent or not above 0 (191).
    FirstDepthMissing,
    /// Depth of cut absent or not above 0 (192).
    DepthMissing,
    /// Radius, or size in X, absent or 0 (193).
    SizeMissing,
    /// Size in Y, or distance of the start, absent or 0 (194).
    SecondSizeMissing,
    /// Tool radius absent or 0 (195).
    ToolMissing,
    /// The bottom does not lie below the R level (49).
    BottomNotBelowR,
    /// Beyond what any word can say, or not a number.
    OutOfRange,
    /// The cycle would take more moves than [`MAX_MOVES`].
    TooManyMoves,
}

/// Most moves of one cycle. A step or depth that needs more is a slip of the pen, and must be an alarm
/// rather than an hour of thousandth cuts.
pub const MAX_MOVES: f64 = 200_000.0;

/// A problem and the word to blame for it.
#[derive(Clone, Copy, PartialEq, Eq, Debug)]
pub struct CycleFault {
    /// What is wrong.
    pub problem: Problem,
    /// Address of the word at fault, `b'L'` and the like; it may be absent from the block, being
    /// missing or modal. Nothing where a machine parameter is to blame.
    pub letter: Option<u8>,
}

impl Problem {
    /// The fault that blames a word.
    pub(crate) const fn of(self, letter: u8) -> CycleFault {
        CycleFault { problem: self, letter: Some(letter) }
    }

    /// An error where `wrong`.
    pub(crate) fn when(self, wrong: bool, letter: u8) -> Result<(), CycleFault> {
        if wrong { Err(self.of(letter)) } else { Ok(()) }
    }
}
