//! What is wrong with the parameters of a profile pocket.

/// Why a pocket cannot be cut.
#[derive(Clone, Copy, PartialEq, Eq, Debug)]
pub enum Problem {
    /// Two elements of a profile do not join, or it does not end where it began.
    ProfileOpen,
    /// A profile has no elements, or no area.
    ProfileEmpty,
    /// A profile crosses or touches itself.
    ProfileCrossesItself,
    /// The ends of an arc do not lie about its centre.
    ArcEnds,
    /// A corner, or a tangential entry or exit, does not fit between its elements.
    CornerTooLarge,
    /// An island does not lie inside the outer profile.
    IslandOutside,
    /// An island crosses or touches another profile, or lies inside another island.
    IslandCrosses,
    /// More contours with depth profiles than four (Fagor 4.16).
    TooManyDepthProfiles,
    /// A depth profile does not begin on its contour and at its level: the surface for the outer one, the
    /// floor for an island.
    DepthProfileStart,
    /// A depth profile turns back, or does not run from surface to floor.
    DepthProfileTurnsBack,
    /// The pocket is closed before it reaches its depth: sloping walls meet.
    WallsMeet,
    /// The tool has no radius, or a tip radius beyond its radius.
    ToolMissing,
    /// The tool fits nowhere.
    ToolTooLarge,
    /// The drill is larger than the tool allows that goes down where it drilled (Fagor 4.15).
    DrillTooLarge,
    /// The pass is wider than the tool.
    StepTooLarge,
    /// Below zero where that has no meaning.
    Negative,
    /// Total depth of 0.
    DepthMissing,
    /// Neither a depth of pass nor a cutting length of the tool.
    DepthStepMissing,
    /// An entry angle beyond 90 degrees.
    EntryAngle,
    /// Not a number, or beyond what any word can say.
    OutOfRange,
    /// The pocket would take more moves than [`MAX_MOVES`].
    TooManyMoves,
    /// The paths beside these walls cannot be computed to the accuracy that is asked for.
    NoPath,
}

/// Most moves of one pocket. A step or angle that needs more is a slip of the pen.
pub const MAX_MOVES: f64 = 4_000_000.0;

/// Most concentric passes; beyond it a step is a slip of the pen.
pub(crate) const MAX_PASSES: f64 = 5_000.0;

/// Largest magnitude of any parameter, mm.
pub(crate) const LARGEST: f64 = 99_999.0;

/// A problem and the parameter to blame for it.
#[derive(Clone, Copy, PartialEq, Eq, Debug)]
pub struct PocketFault {
    /// What is wrong.
    pub problem: Problem,
    /// The manual's symbol of the parameter, in the letters of the language: `profile`, `step`, `I`, `beta`,
    /// `P`, `T`, `delta`, `deltaz`, `theta`, `N`, `I1`, `I2`, `eps`, `Z1`…`Z4`, `drill`, `Z`, `ZS`.
    pub parameter: &'static str,
    /// Which profile, where one is to blame: 0 is the outer one, then the islands in their order.
    pub contour: Option<usize>,
    /// Whose parameter it is, where a stage has its own.
    pub stage: Option<Stage>,
}

/// A stage of a pocket, with its own tool and data.
#[derive(Clone, Copy, PartialEq, Eq, Debug)]
pub enum Stage {
    /// Roughing.
    Rough,
    /// Semi-finishing (3D pockets).
    Semi,
    /// Finishing.
    Finish,
}

impl PocketFault {
    /// The same fault, in a stage.
    pub(crate) fn in_stage(self, stage: Stage) -> PocketFault {
        PocketFault { stage: Some(stage), ..self }
    }
}

impl Problem {
    /// The fault that blames a parameter.
    pub(crate) const fn of(self, parameter: &'static str) -> PocketFault {
        PocketFault { problem: self, parameter, contour: None, stage: None }
    }

    /// The fault that blames a profile.
    pub(crate) const fn of_contour(self, contour: usize) -> PocketFault {
        PocketFault { problem: self, parameter: "profile", contour: Some(contour), stage: None }
    }

    /// An error where `wrong`.
    pub(crate) const fn when(self, wrong: bool, parameter: &'static str) -> Result<(), PocketFault> {
        if wrong { Err(self.of(parameter)) } else { Ok(()) }
    }
}

/// A length of 0 or more.
pub(crate) fn not_negative(value: f64, parameter: &'static str) -> Result<f64, PocketFault> {
    let value = in_range(value, parameter)?;
    Problem::Negative.when(value < 0.0, parameter)?;
    Ok(value)
}

/// A number that a word can say.
pub(crate) fn in_range(value: f64, parameter: &'static str) -> Result<f64, PocketFault> {
    // Not-a-number is in no range.
    if value.abs() <= LARGEST { Ok(value) } else { Err(Problem::OutOfRange.of(parameter)) }
}
