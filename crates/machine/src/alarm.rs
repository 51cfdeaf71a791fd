//! Everything that can be wrong, as data.
//!
//! A [`Fault`] is a rule that was broken, in terms common to all controls. A dialect gives many
//! faults a number of its own (GSK990MC appendix 2); the others keep the number of this table,
//! `FC-nnnn`. Texts live in the catalogues under `messages/`, keyed by [`AlarmId`]'s text form.

use ferrocut_program::Span;
use smallvec::SmallVec;
use std::fmt;

macro_rules! faults {
    ($($(#[doc = $doc:literal])+ $name:ident = $code:literal,)+) => {
        /// A broken rule, in terms common to all controls.
        #[derive(Clone, Copy, PartialEq, Eq, Hash, Debug)]
        #[repr(u16)]
        pub enum Fault {
            $($(#[doc = $doc])+ $name = $code,)+
        }

        impl Fault {
            /// Every fault.
            pub const ALL: &'static [Fault] = &[$(Fault::$name,)+];
        }
    };
}

faults! {
    // 100: text
    /// A character that no block may hold.
    IllegalCharacter = 101,
    /// A number without an address before it.
    NumberWithoutAddress = 102,
    /// An address without a value behind it.
    AddressWithoutNumber = 103,
    /// A sign where none may stand.
    MisplacedSign = 104,
    /// A decimal point where none may stand, or two.
    MisplacedPoint = 105,
    /// A line longer than the control takes.
    LineTooLong = 106,
    /// Brackets that do not pair.
    UnbalancedBracket = 107,
    /// Brackets nested too deep.
    BracketsTooDeep = 108,
    /// An expression that cannot be read.
    MalformedExpression = 109,
    /// A comment that is opened and not closed.
    UnclosedComment = 110,
    /// A statement of the macro language that cannot be read.
    MalformedStatement = 111,
    /// A function name that the control does not know.
    UnknownFunction = 112,
    /// A number too large to be meant.
    NumberTooLarge = 113,
    /// Words and a macro statement in one block.
    MixedStatement = 114,
    /// Text whose quote or bracket is not closed.
    UnclosedText = 115,

    // 200: words
    /// A G code that the control does not have.
    UnknownGCode = 201,
    /// An M code that the control does not have.
    UnknownMCode = 202,
    /// An address that the control does not use.
    UnknownAddress = 203,
    /// An address given twice in a block.
    RepeatedAddress = 204,
    /// Two G codes of one modal group in a block.
    RepeatedGroup = 205,
    /// A word whose value is outside its range.
    WordOutOfRange = 206,
    /// A word that must be whole and is not.
    WordNotWhole = 207,
    /// A word that must not be negative and is.
    WordNegative = 208,
    /// A code that must stand alone in its block.
    NeedsOwnBlock = 209,
    /// Program-control M codes together in a block.
    ProgramCodesTogether = 210,
    /// More M codes in a block than the control takes.
    TooManyMCodes = 211,
    /// An axis that the machine or control does not have.
    UnknownAxis = 212,
    /// More axes in a block than may move together.
    TooManyAxes = 213,
    /// A tool number beyond the digits of T.
    ToolNumber = 214,
    /// A word that the code needs is missing.
    WordMissing = 215,
    /// A word that no code of its block uses.
    WordUnused = 216,
    /// Axis words without a code that moves them.
    AxesWithoutCode = 217,
    /// A code that needs axis words without any.
    AxesMissing = 218,
    /// Codes that cannot stand in one block, or not in the state in force.
    CodesContradict = 219,
    /// A code that would take the limits of the axes away, which stay.
    LimitsStay = 220,
    /// A code for encoders that latch their counts.
    NoLatches = 221,

    // 300: motion
    /// A cutting move without a feed.
    NoFeed = 301,
    /// Start and end of an arc at different distances from its centre.
    ArcRadiusMismatch = 302,
    /// An arc with neither radius nor centre.
    ArcWithoutCentre = 303,
    /// An arc whose end cannot be reached with its radius.
    ArcRadiusTooSmall = 304,
    /// An arc about its own start.
    ArcWithoutRadius = 305,
    /// A negative dwell.
    NegativeDwell = 306,
    /// Too many axes beside the circle of a helix.
    TooManyHelicalAxes = 307,
    /// A coordinate beyond what the control can hold.
    CoordinateTooLarge = 308,
    /// A feed that is zero, negative or beyond the control's range.
    FeedOutOfRange = 309,
    /// A chamfer or corner arc that is written wrongly.
    CornerForm = 310,
    /// A chamfer or corner arc without a cutting move behind it.
    CornerWithoutMove = 311,
    /// A chamfer or corner arc longer than the moves beside it.
    CornerTooLong = 312,
    /// A chamfer or corner arc beside a move out of the plane.
    CornerPlane = 313,
    /// Feed per revolution without an encoder on the spindle.
    NoFeedPerRevolution = 314,
    /// A coordinate that scaling makes too large.
    ScaledTooLarge = 315,
    /// An arc that moves an axis which is neither of its plane nor square to it.
    ArcAxisBesidePlane = 316,
    /// A climb along a helix whose circle has no length.
    HelixWithoutArc = 317,
    /// An arc in machine coordinates.
    ArcInMachine = 318,
    /// Feed per revolution with a spindle speed of 0.
    SpindleAtRest = 319,
    /// A chamfer or corner arc before a move out of the plane.
    CornerPlaneBehind = 320,
    /// An arc that starts on its centre in cutter compensation.
    ArcWithoutRadiusInCutter = 321,
    /// An arc by its radius that ends where it begins: nothing moves.
    ArcOfNoLength = 322,
    /// An arc in a plane of U, V, W.
    ArcInUvwPlane = 330,
    /// An arc with both a radius and a centre.
    ArcRadiusAndCentre = 331,
    /// A centre word of the axis square to the plane.
    ArcCentreLetter = 332,
    /// An arc by its radius that ends where it starts.
    ArcEndIsStart = 333,
    /// A spline in another plane than XY.
    SplinePlane = 334,
    /// A spline with a move of another axis.
    SplineAxis = 335,
    /// A spline with fewer control points than its order.
    NurbsTooFew = 336,
    /// The end of a NURBS that was not begun.
    NurbsEndAlone = 337,
    /// A spline of more points than can be meant.
    SplineTooLong = 338,
    /// A probing move of no length.
    ProbeTooClose = 339,

    // 400: offsets and coordinate systems
    /// An offset number beyond the table.
    OffsetNumber = 401,
    /// A work coordinate system that does not exist.
    WorkOffsetNumber = 402,
    /// Length compensation in a block with G92.
    LengthWithCoordinateSet = 403,
    /// Tool length changed by a block with an arc.
    LengthInArc = 404,
    /// Scaling that the control is not set up for.
    ScalingDisabled = 405,
    /// A scale factor outside its range.
    ScaleFactor = 406,
    /// A code that scaling does not allow.
    CodeInScaling = 407,
    /// A code that rotation does not allow.
    CodeInRotation = 408,
    /// A code that polar coordinates do not allow.
    CodeInPolar = 409,
    /// A plane other than that of the rotation.
    PlaneInRotation = 410,
    /// An arc of polar coordinates that is not given by R.
    ArcInPolar = 411,
    /// Units changed while points are transformed.
    UnitsInTransform = 412,
    /// Skip while points are transformed.
    SkipInTransform = 413,
    /// A reference return without an axis.
    ReferenceWithoutAxis = 414,
    /// A reference point that does not exist.
    ReferenceNumber = 415,
    /// A check that does not end on the reference point.
    NotAtReference = 416,
    /// Data set while a canned cycle is active.
    DataSettingInCycle = 417,
    /// A form of data setting that does not exist.
    DataForm = 418,
    /// The number of what is to be set is missing or too large.
    DataNumber = 419,
    /// The value to be set is missing or too large.
    DataValue = 420,
    /// Number, bit or value of a parameter is missing or out of range.
    DataParameter = 421,
    /// A parameter that the program cannot set.
    ParameterFixed = 422,
    /// A command while parameters are being set.
    CommandInDataSetting = 423,
    /// Cutter compensation: the offsets of two blocks do not cross.
    CutterNoIntersection = 424,
    /// Cutter compensation started or cancelled by an arc.
    CutterStartInArc = 425,
    /// Skip in cutter compensation.
    SkipInCutter = 426,
    /// Plane changed in cutter compensation.
    PlaneInCutter = 427,
    /// Cutter compensation: an arc's end falls on its centre.
    CutterArcCenter = 428,
    /// Work coordinate system changed in cutter compensation.
    WorkOffsetInCutter = 429,
    /// Cutter compensation would cut into the part.
    CutterInterference = 430,
    /// Cutter compensation: too many blocks without motion.
    CutterIdleBlocks = 431,
    /// An arc about a corner outside cutter compensation, or not fitted.
    CornerArcForm = 432,
    /// Cutter compensation: a block runs exactly back.
    CutterReversal = 433,
    /// An offset value beyond what the control takes.
    OffsetTooLarge = 434,
    /// An intermediate point too far away.
    IntermediateTooLarge = 435,
    /// A skipped block while points are transformed.
    SkipBlockInTransform = 436,
    /// An offset changed while points are transformed.
    OffsetInTransform = 437,
    /// A stored stroke check that shares its block.
    StrokeNotAlone = 438,
    /// Corners of a stored stroke check that make no box.
    StrokeCorners = 439,
    /// A move into the area that stored stroke check 2 forbids.
    StoredStroke = 440,
    /// An axis that surface speed cannot be reckoned by.
    SurfaceSpeedAxis = 441,
    /// Length compensation in the block of a code that does not allow it.
    LengthWithCode = 442,
    /// Scaling set in cutter compensation.
    ScalingInCutter = 443,
    /// Scaling without an axis or factor, or with both kinds of factor.
    ScaleForm = 444,
    /// A mirror without an axis.
    MirrorForm = 445,
    /// More transformations in force than can be meant.
    TooManyTransforms = 446,
    /// A skip move reached its end without the signal, where the control needs one.
    SkipWithoutSignal = 447,
    /// A tool changed in cutter compensation.
    ToolInCutter = 448,
    /// The shift of all coordinate systems changed in cutter compensation.
    ShiftInCutter = 449,
    /// A reference return in cutter compensation.
    ReferenceInCutter = 450,
    /// A probing move was to begin with the probe as it is to end: touching, or free.
    SignalBefore = 451,
    /// A return from a reference point through an intermediate point that was never given.
    IntermediateMissing = 452,
    /// A tool length that changes where a canned cycle leaves it as it is.
    LengthInCycle = 453,
    /// Cutter compensation: the entry move is not longer than the tool radius.
    CutterEntryTooShort = 470,
    /// Cutter compensation: the tool does not fit into an arc.
    CutterArcTooSmall = 471,
    /// The first move after cutter compensation is an arc.
    CutterArcAfterCancel = 472,
    /// Cutter compensation in a plane that it does not work in.
    CutterPlane = 473,
    /// Cutter compensation started while it is on.
    CutterAlreadyOn = 474,
    /// A code that may not stand in cutter compensation.
    NotInCutter = 475,
    /// Cutter compensation with a lathe tool.
    CutterLatheTool = 476,
    /// An arc, rotation, compensation or figure in a plane with an axis that turns.
    RotaryInPlane = 477,

    // 500: canned cycles
    /// A cycle in a plane that it does not work in.
    CyclePlane = 501,
    /// Hole bottom not below the R level.
    CycleDepthAboveR = 502,
    /// A peck cycle without its depth of cut.
    CycleNoPeck = 503,
    /// A plane change while a cycle is active.
    PlaneInCycle = 504,
    /// A cycle although no spindle speed was ever given.
    CycleNoSpindle = 505,
    /// Reference-point code while a cycle is active.
    ReferenceInCycle = 506,
    /// Hole bottom not above the R level, for boring from below.
    CycleDepthBelowR = 507,
    /// A spindle speed that tapping cannot have.
    TappingSpeed = 508,
    /// Rigid tapping called while a cycle is active.
    RigidInCycle = 509,
    /// Rigid tapping without a feed.
    TappingFeed = 510,
    /// A speed between the call of rigid tapping and the cycle.
    RigidMisplaced = 511,
    /// A plane change in rigid tapping.
    PlaneInRigidTapping = 512,
    /// A cycle that orients a spindle which cannot.
    NoOrientation = 513,
    /// A milling cycle while an axis is mirrored.
    MillMirrored = 514,
    /// Step over, or distance of the start, too small.
    MillStepTooSmall = 515,
    /// Step over, or distance of the start, too large.
    MillStepTooLarge = 516,
    /// A tool, or its helix, that does not fit.
    MillToolTooLarge = 517,
    /// Corner radius beyond half a side.
    MillCornerTooLarge = 518,
    /// Corner radius below the tool radius.
    MillCornerTooSmall = 519,
    /// Gap of the rapid above uncut material missing.
    MillGapMissing = 520,
    /// First depth of cut missing.
    MillFirstDepthMissing = 521,
    /// Depth of cut missing.
    MillDepthMissing = 522,
    /// Radius or first size missing.
    MillSizeMissing = 523,
    /// Second size, or distance of the start, missing.
    MillSecondSizeMissing = 524,
    /// Tool radius missing.
    MillToolMissing = 525,
    /// A cycle of more moves than can be meant.
    MillTooManyMoves = 526,
    /// Rigid tapping before a spindle speed was given.
    TappingNoSpeed = 527,
    /// A tapping cycle whose pitch was never given.
    TappingPitchMissing = 528,
    /// A pitch given twice in a block, in mm and by threads per inch.
    TappingPitchTwice = 529,
    /// Holes on a figure without a cycle in force.
    PatternWithoutCycle = 530,
    /// A canned cycle while the tool axis is scaled.
    CycleScaled = 531,
    /// A milling cycle while X and Y are scaled by different factors.
    MillScaledUnevenly = 532,
    /// A tapping whose feed is held below what it is programmed with.
    TappingFeedHeld = 533,
    /// The shortest dwell of a cycle, by parameter, is not below the longest.
    DwellLimits = 534,
    /// A cycle for holes without a level R or a depth: nothing is cut.
    NoHole = 535,
    /// A boring that does not move the tool aside in the hole.
    NoShift = 536,
    /// A cycle that makes no hole since another code of its block goes before it.
    CycleBesideCode = 537,
    /// A parameter of a cycle has a value that it cannot have.
    CycleParameter = 540,
    /// A parameter of a cycle is missing.
    CycleParameterMissing = 541,
    /// A cycle that would cut nothing: no depth.
    CycleNoDepth = 542,
    /// A tool too large for what it is to cut.
    CycleToolTooLarge = 543,
    /// A tool so small that a core would be left standing.
    CycleToolTooSmall = 544,
    /// Passes wider than the tool.
    CycleStepTooWide = 545,
    /// A step of 0 for a tool without a cutting length.
    CycleNoCuttingLength = 546,
    /// Wall passes of 0 for a finishing tool without a cutting length that is not the roughing tool.
    CycleToolsDiffer = 547,
    /// An entry angle that is no angle, or for which there is no room.
    CycleEntryAngle = 548,
    /// A cycle without a feed.
    CycleNoFeed = 549,
    /// Lengths and distances of a figure that do not make a whole number of points.
    PatternNotWhole = 550,
    /// Points left out of a figure that do not rise.
    PatternOrder = 551,
    /// A figure given by too few parameters, or by ones that contradict each other.
    PatternForm = 552,
    /// The parameter of a cycle written or read without a cycle.
    NoCycleParameter = 553,
    /// A directive that the control does not have.
    UnknownDirective = 554,
    /// A parameter that the cycle does not have.
    UnknownParameter = 555,
    /// A word where a number is wanted, or a word that the parameter does not take.
    ParameterKind = 556,
    /// A part of a cycle without the cycle, or not for this one, or twice.
    DirectiveMisplaced = 557,
    /// A profile that does not exist.
    ProfileMissing = 558,
    /// A block that a profile cannot hold, or a profile that is not ended.
    ProfileForm = 559,
    /// A profile that is open and must be closed.
    ProfileOpen = 560,
    /// A profile that crosses itself or another.
    ProfileCrosses = 561,
    /// A rounding or chamfer without room, or without two elements beside it.
    ProfileCorner = 562,
    /// A tangential way in or out whose radius is too large.
    ProfileWay = 563,
    /// An axis that a plane or tool cannot have, or an arc in a plane that has none.
    PlaneAxes = 564,
    /// A contour of a pocket without an area.
    ProfileEmpty = 565,
    /// An island that is not inside the outer contour of its pocket.
    IslandOutside = 566,
    /// A depth profile that does not begin on its contour, or turns back.
    DepthProfile = 567,
    /// Sloping walls that meet above the floor.
    WallsMeet = 568,
    /// Walls beside which no path can be computed exactly enough.
    PocketPath = 569,
    /// An axis that does not move in a cycle.
    CycleAxis = 570,
    /// A cycle in inverse-time feed.
    CycleInverseTime = 571,
    /// A code that needs a turning spindle.
    SpindleNotTurning = 572,
    /// A tapping cycle with the spindle turning out of the thread.
    SpindleWrongWay = 573,
    /// Depths of a thread that do not fit each other.
    ThreadDepths = 574,
    /// A way straight down into solid material, for want of an entry angle.
    NoEntryAngle = 575,

    // 600: programs
    /// A call without a program number.
    CallWithoutProgram = 601,
    /// A called program that does not exist.
    ProgramMissing = 602,
    /// Calls nested deeper than the control allows.
    CallsTooDeep = 603,
    /// A call repeated more often than the control allows.
    TooManyRepeats = 604,
    /// A program number that no program can have.
    ProgramNumber = 605,
    /// The end of the text without an end of program.
    NoProgramEnd = 606,
    /// The end mark `%` reached by execution.
    EndMarkReached = 607,
    /// Blocks run without end.
    EndlessProgram = 608,
    /// A jump to a sequence number that does not exist.
    SequenceMissing = 609,
    /// A subprogram call inside a macro.
    CallInMacro = 610,
    /// A return in the block of a macro call.
    ReturnWithMacro = 611,
    /// An O word beyond the numbers of programs.
    ProgramNumberTooLarge = 612,
    /// A jump of macro A to a sequence number that the program does not have.
    JumpTargetMissing = 613,
    /// A label of a loop, condition or subprogram that was given before.
    LabelRepeated = 614,
    /// An end or branch whose loop or condition was not met.
    LabelMissing = 615,
    /// A return outside a subprogram.
    OutsideSubprogram = 616,
    /// A subprogram within another.
    SubprogramNested = 617,
    /// A program called in the way of the other kind.
    CallForm = 618,
    /// More labels than can be meant.
    TooManyLabels = 619,
    /// A state restored that was not saved.
    NothingSaved = 620,
    /// A comment that writes a file.
    FilesNotWritten = 621,
    /// A tool change that no program does in this language, and no ladder by itself.
    NobodyChangesTool = 622,
    /// Two programs of a file have one number or name.
    ProgramRepeated = 623,

    // 700: variables and arithmetic
    /// A division by zero.
    DivisionByZero = 701,
    /// A function outside the values that it is defined for.
    FunctionDomain = 702,
    /// A variable that does not exist.
    UnknownVariable = 703,
    /// A variable that cannot be written.
    VariableNotWritable = 704,
    /// A result beyond the numbers of the control.
    ResultTooLarge = 705,
    /// The variable that is always empty cannot be set.
    NullVariable = 706,
    /// An operation of the macro language that the control does not have.
    UnknownOperation = 707,
    /// An address that passes no argument.
    ArgumentAddress = 708,
    /// Macro calls nested deeper than the control allows.
    MacrosTooDeep = 709,
    /// A loop that cannot be run: a label that does not exist, or none.
    InvalidLoop = 710,
    /// Loops that cross, or a beginning or end of a loop without the other.
    LoopMismatch = 711,
    /// A jump into a loop.
    JumpIntoLoop = 712,
    /// An alarm that the program sets itself.
    ProgramAlarm = 713,
    /// A program or sequence number that is a variable.
    VariableInNumber = 714,

    // 800: machine
    /// An axis would leave its software limits.
    SoftLimit = 801,
    /// Cutting with the spindle at rest.
    CuttingSpindleStopped = 802,
    /// A tool that the magazine does not hold.
    ToolMissing = 803,
    /// A spindle speed that the machine does not reach.
    SpindleTooFast = 804,
    /// Cutting move along no machine axis can be run at the programmed feed.
    FeedNotReachable = 805,
    /// An input that a program waits for did not come in time.
    InputMissing = 806,
    /// An axis too far from its command.
    FollowingError = 807,
    /// An axis that does not come into position after its stop.
    NotInPosition = 808,
    /// An axis where the control has no point of pitch-error compensation.
    PitchPoint = 809,

    // 900: files
    /// A file that cannot be read.
    FileUnreadable = 901,
    /// A file that is no program text.
    FileNotText = 902,
    /// A file without a single block.
    FileEmpty = 903,
    /// A set-up or machine file that cannot be used.
    ConfigUnusable = 904,
    /// A language of the file that Ferrocut does not know.
    UnknownDialect = 905,
    /// A code or form that this version does not carry out.
    NotSupported = 906,
    /// A file that a result cannot be written to.
    FileUnwritable = 907,
    /// A picture in a format that there is not.
    PictureFormat = 908,
    /// A setting of a plot that does not fit.
    PlotSetting = 909,
    /// A result that would be written over what the command reads.
    OutputIsInput = 910,

    // 1000: drawings
    /// A drawing that ends in the middle.
    DrawingTruncated = 1001,
    /// A drawing with more in it than is taken.
    DrawingTooLarge = 1002,
    /// A drawing without a line to cut.
    DrawingEmpty = 1003,
    /// A place of a drawing further away than any machine reaches.
    DrawingTooFar = 1004,
    /// DXF: no group code where one must stand.
    DxfGroupCode = 1005,
    /// DXF: a value that is no number where one must stand.
    DxfValue = 1006,
    /// DXF in the form that is no text.
    DxfBinary = 1007,
    /// DXF: an entity that the reader gave up on.
    DxfEntity = 1008,
    /// A block of a drawing that holds itself.
    BlockInItself = 1009,
    /// A spline whose degree, knots, weights and points do not fit each other.
    SplineForm = 1010,
    /// PLT: no instruction where one must stand.
    PltInstruction = 1011,
    /// PLT: a number of arguments that the instruction cannot have.
    PltArguments = 1012,
    /// Entities of a kind that is not cut.
    EntityLeftOut = 1013,
    /// Entities on a layer that is not cut.
    LayerLeftOut = 1014,
    /// Entities that lie in paper space or are invisible.
    HiddenLeftOut = 1015,
    /// An inserted block that the drawing does not hold.
    BlockMissing = 1016,
    /// PLT: an instruction that is not carried out.
    PltLeftOut = 1017,
    /// A setting of the import that cannot be used.
    ImportSetting = 1018,
    /// A control language that drawings are not written in.
    NoWriter = 1019,
    /// A file that is no drawing where one is asked for.
    NoDrawing = 1020,
    /// A layer or pen that the drawing has nothing on.
    NothingOnLayer = 1021,
    /// PLT: an instruction that is not known, or that would change what is drawn.
    PltUnknown = 1022,

    // 1100: ladders
    /// A rule of ladders that is broken; the control's number says which.
    Ladder = 1101,
    /// A setting of a ladder's run that cannot be used.
    LadderSetting = 1102,

    // 1200: the durable memory and its rights
    /// The memory is damaged.
    MemoryDamaged = 1201,
    /// Another process has the memory open.
    MemoryBusy = 1202,
    /// The memory was written by later software.
    MemoryNewer = 1203,
    /// The memory is that of another control.
    MemoryOfOther = 1204,
    /// The disk refuses the memory.
    MemoryDisk = 1205,
    /// A value that the memory does not take.
    MemoryValue = 1206,
    /// No room for more of a kind.
    MemoryFull = 1207,
    /// There is no memory in the folder.
    MemoryMissing = 1208,
    /// A file that is no backup, or one of a later version.
    NotABackup = 1209,
    /// A backup that is damaged.
    BackupDamaged = 1210,
    /// A backup of the memory of another control.
    BackupOfOther = 1211,
    /// A backup does not hold an item that is to be restored.
    NotInBackup = 1212,
    /// A level of rights that may not do this.
    RightMissing = 1213,
    /// A parameter forbids the change.
    ChangeProtected = 1214,
    /// A program is locked by a higher level.
    ProgramLocked = 1215,
    /// A change that a part program may not make.
    ChangeNotByProgram = 1216,
    /// A level without a password, which nobody has.
    LevelWithoutPassword = 1217,
    /// A wrong password.
    PasswordWrong = 1218,
    /// A password that is too short or too long.
    PasswordLength = 1219,
    /// Too many wrong passwords.
    PasswordWait = 1220,
    /// The position of a backup for a control that runs, which knows its own.
    PositionInUse = 1221,

    // 1400: the running control
    /// Something that another mode is for.
    ControlMode = 1400,
    /// Something that cannot be while a program is under way.
    ControlBusy = 1401,
    /// Cycle start in another mode than that of the program that is under way.
    ControlInterrupted = 1402,
    /// Cycle start without a program.
    NothingToRun = 1403,
    /// Cycle start, or a key of an axis, that the ladder forbids.
    StartLocked = 1404,
    /// Something that cannot be while an alarm stands.
    ControlAlarmed = 1405,
    /// Something that this control has no part for.
    NotFitted = 1406,
    /// A name that nothing has.
    NoSuchName = 1407,
    /// A change to the program that is under way.
    ProgramInUse = 1408,
    /// A value that cannot be.
    ValueImpossible = 1409,
    /// The emergency stop is pressed.
    EmergencyStop = 1410,
    /// A block that was not found in the program.
    NoSuchLine = 1411,
    /// The ladder stands still.
    LadderStopped = 1412,
    /// What was put on the way to the durable memory is not there.
    NotKept = 1413,
    /// A restart with axes whose reference points were not found.
    RestartNotReferenced = 1414,
    /// A restart of another program than the one that is selected.
    RestartOtherProgram = 1415,
    /// A restart whose program or data were changed since.
    RestartChanged = 1416,
    /// A restart with another tool or a spindle that does not turn as the program has it; a program that is to go on
    /// with such a spindle.
    RestartNotAsProgram = 1417,
    /// No room for more of a program that is sent, until blocks are done.
    NoRoomYet = 1418,
    /// A parameter is changed while the parameter switch is off.
    ParametersClosed = 1419,

    // 1420: the ladder and the codes that are handed to it
    /// A code is not done in time.
    CodeNotFinished = 1420,
    /// Rigid tapping that the ladder does not take part in.
    RigidTappingOff = 1421,
    /// A waveform that cannot be captured.
    CaptureSetting = 1422,
    /// The parameter switch is on.
    ParametersOpen = 1423,
    /// Another ladder than the machine's own runs: one that was put in its place.
    LadderKept = 1424,
    /// The ladder that was kept cannot be run.
    LadderUnusable = 1425,
    /// A ladder that was exchanged stopped before it had run through, and was taken out again.
    LadderTakenOut = 1426,
    /// A program is changed while the program switch is off.
    ProgramsClosed = 1427,
    /// A signal that is no data of the ladder is to be set.
    SignalNotData = 1428,
    /// The axes cannot go back along the path.
    NoWayBack = 1429,

    // 1430: reference points and travel switches
    /// Homing did not meet the home switch, or did not leave it.
    HomeSwitch = 1430,
    /// Homing met no marker of the encoder behind the home switch.
    HomeMarker = 1431,
    /// An emergency stop while an axis was homing.
    HomingStopped = 1432,
    /// A program moves an axis whose reference point was not found.
    NotReferenced = 1433,
    /// A code needs the reference point of an axis, which was not found.
    ReferenceNeeded = 1434,
    /// A program is to find a reference point, which the control is set not to do.
    ReferenceByProgram = 1435,
    /// An axis is on its travel switch.
    HardLimit = 1436,

    // 1460: programs and commands over a connection
    /// A jump, loop or search in a program of which only the next lines are kept.
    LinesNotKept = 1460,
    /// A port, socket or terminal that cannot be opened.
    CannotServe = 1461,

    // 1470: measuring
    /// Measuring without a probe or tool setter.
    ProbeMissing = 1470,
    /// The probe touches where it should be free.
    ProbeTouches = 1471,
    /// The probe met nothing within its limit.
    ProbeMissed = 1472,
    /// Points that give no shape.
    PointsUnusable = 1473,
    /// Measuring with axes whose reference points were not found.
    MeasureNotReferenced = 1474,
    /// A size that was measured lies outside its tolerance.
    MeasuredSize = 1475,
    /// A value without which nothing can be measured.
    MeasureSetting = 1476,
    /// Measuring while something forbids it: a lock, dry run, a spindle that turns.
    MeasureForbidden = 1477,
    /// The tool setter was not met where the tool should have touched it.
    SetterMissed = 1478,

    // 1500: the panel in a browser
    /// The panel was not built into the program.
    PanelMissing = 1500,
    /// A check that was ended before the program was.
    CheckEnded = 1501,
    /// A panel for other computers without encryption.
    PanelNotEncrypted = 1502,
    /// A panel for other computers that nobody has a password for.
    PanelWithoutPassword = 1503,
    /// A certificate or key that cannot be used.
    Certificate = 1504,
    /// A control that is served without a memory.
    NothingKept = 1505,

    // 1440: program restart
    /// No block on a line or below it.
    RestartBlockMissing = 1440,
    /// The program does not reach the block as often as asked for.
    RestartNotReached = 1441,
    /// The order of the axes on the way to a restart does not name each once.
    RestartOrder = 1442,
    /// Nothing was interrupted that could be taken up again.
    RestartNothing = 1443,
    /// A restart while the axes are under way.
    RestartMoving = 1444,
    /// What the machine told the program in the first run is not known.
    RestartUnknown = 1445,

    // 1446: what the machine says through its ladder
    /// A message of the ladder has come.
    MachineMessage = 1446,
    /// A parameter was changed that holds from the next power-on.
    PowerOffNeeded = 1447,

    // 1480: the drives of a real machine
    /// Nobody answers where the drives are said to be.
    DrivesSilent = 1480,
    /// Nothing is heard of the drives any more.
    DrivesLost = 1481,
    /// The connection to the drives is broken.
    DrivesCut = 1482,
    /// The drives cannot do what the machine file asks for.
    DrivesUnsuited = 1483,
    /// The highest speed of an axis needs more steps a second than can be made.
    StepRate = 1484,
    /// The drives heard nothing for too long and stopped.
    DriveWatchdog = 1485,
    /// A setpoint was not there in time.
    DriveStarved = 1486,
    /// A setpoint was lost on the way.
    DriveFrameLost = 1487,
    /// A setpoint asked for more steps a second than agreed.
    DriveTooFast = 1488,
    /// The emergency stop at the drives.
    DriveEmergencyStop = 1489,
    /// An amplifier reports a fault.
    DriveAmplifier = 1490,
    /// The drives stopped for another reason.
    DriveStopped = 1491,
    /// The spindle has a speed and no angle: it cannot be oriented, nor tap in step with the axes.
    SpindleNotLed = 1492,
    /// What would move a simulated machine alone.
    DrivesNotMeant = 1493,
    /// Machine lock is on.
    MachineLocked = 1494,
    /// Blocks were read ahead with a value that was changed since.
    ReadBefore = 1495,
    // 1520: forms of cycles
    /// A cycle that the editor does not have.
    CycleUnknown = 1520,
    /// A value of a form out of its range.
    CycleValue = 1521,
    /// A word that a choice of a form does not have.
    CycleChoice = 1522,
    /// A name of a profile or pocket that cannot stand in a program.
    CycleName = 1523,
    /// Positions that a cycle cannot be repeated on.
    CyclePositions = 1524,
    /// A profile that a cycle cannot have, or that it lacks.
    CycleProfile = 1525,
    /// A cycle whose text would be too long.
    CycleTooLong = 1526,
    /// A cycle that moves in step with the spindle, in a language whose own cycles move otherwise.
    CycleSynchronised = 1527,
    /// A cycle that cannot be written in a language.
    CycleNotWritten = 1528,
}

/// How bad it is.
#[derive(Clone, Copy, PartialEq, Eq, Debug, PartialOrd, Ord)]
pub enum Severity {
    /// Worth knowing; the program runs.
    Warning,
    /// The program stops here.
    Error,
}

impl Severity {
    /// The word for it in machine-readable output.
    pub fn name(self) -> &'static str {
        match self {
            Severity::Warning => "warning",
            Severity::Error => "error",
        }
    }
}

/// Which alarm: the dialect's own number, or one of this system's table.
#[derive(Clone, Copy, PartialEq, Eq, Hash, Debug)]
pub enum AlarmId {
    /// Number in the manual of a dialect.
    Dialect(&'static str, u16),
    /// Number in the table of [`Fault`].
    Core(Fault),
}

impl AlarmId {
    /// The dialect's own number, where it has one.
    pub fn number(self) -> Option<u16> {
        match self {
            AlarmId::Dialect(_, number) => Some(number),
            AlarmId::Core(_) => None,
        }
    }
}

/// `gsk990mc:0045` or `FC-0302`.
impl fmt::Display for AlarmId {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        match self {
            AlarmId::Dialect(dialect, number) => write!(f, "{dialect}:{number:04}"),
            AlarmId::Core(fault) => write!(f, "FC-{:04}", *fault as u16),
        }
    }
}

/// A value that an alarm's text may name.
#[derive(Clone, PartialEq, Debug)]
pub enum Argument {
    /// A number, shown as short as it is exact to 0.0001.
    Number(f64),
    /// A piece of text, such as the word at fault.
    Text(Box<str>),
}

impl From<f64> for Argument {
    fn from(v: f64) -> Argument {
        Argument::Number(v)
    }
}

impl From<&str> for Argument {
    fn from(v: &str) -> Argument {
        Argument::Text(v.into())
    }
}

impl From<String> for Argument {
    fn from(v: String) -> Argument {
        Argument::Text(v.into())
    }
}

/// Something is wrong: what, where, how bad, and the values that its text names.
#[derive(Clone, PartialEq, Debug)]
pub struct Alarm {
    /// Which alarm.
    pub id: AlarmId,
    /// The rule that was broken.
    pub fault: Fault,
    /// The words at fault; line 0 where no text is meant.
    pub span: Span,
    /// How bad it is.
    pub severity: Severity,
    /// Named values for the text.
    pub arguments: SmallVec<[(&'static str, Argument); 2]>,
}

impl Alarm {
    /// An alarm that stops the program.
    pub fn new(id: AlarmId, fault: Fault, span: Span) -> Alarm {
        Alarm { id, fault, span, severity: Severity::Error, arguments: SmallVec::new() }
    }

    /// An alarm under this system's own number.
    pub fn core(fault: Fault, span: Span) -> Alarm {
        Alarm::new(AlarmId::Core(fault), fault, span)
    }

    /// The alarm with a value for its text.
    pub fn with(mut self, name: &'static str, value: impl Into<Argument>) -> Alarm {
        self.arguments.push((name, value.into()));
        self
    }

    /// The same as a warning.
    pub fn as_warning(mut self) -> Alarm {
        self.severity = Severity::Warning;
        self
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn ids_read_as_documented() {
        assert_eq!(AlarmId::Dialect("gsk990mc", 45).to_string(), "gsk990mc:0045");
        assert_eq!(AlarmId::Core(Fault::ArcRadiusMismatch).to_string(), "FC-0302");
    }
}
