//! Numbers of errors and alarms (Grbl 1.1, interface, error and alarm codes).

use ferrocut_machine::Fault;

/// Why a line was refused: `error:N`.
#[derive(Clone, Copy, PartialEq, Eq, Debug)]
pub struct Error(pub u8);

impl Error {
    /// A word without its letter.
    pub const NO_LETTER: Error = Error(1);
    /// A word without its number.
    pub const NO_NUMBER: Error = Error(2);
    /// A `$` command that there is not.
    pub const NO_COMMAND: Error = Error(3);
    /// A negative value where none may be.
    pub const NEGATIVE: Error = Error(4);
    /// Only while the machine is idle.
    pub const NOT_IDLE: Error = Error(8);
    /// Programs are locked in alarm and while jogging.
    pub const LOCKED: Error = Error(9);
    /// A line too long.
    pub const LINE_TOO_LONG: Error = Error(11);
    /// The safety door is open.
    pub const DOOR: Error = Error(13);
    /// A start line too long to be kept.
    pub const START_LINE: Error = Error(14);
    /// A jog that would leave the machine's travel.
    pub const TRAVEL: Error = Error(15);
    /// A jog that is written wrongly.
    pub const JOG: Error = Error(16);
    /// A setting that the machine does not have.
    pub const SETTING: Error = Error(17);
    /// A code or letter that Grbl does not have.
    pub const UNSUPPORTED: Error = Error(20);
    /// Two codes of one modal group.
    pub const GROUP: Error = Error(21);
    /// No feed.
    pub const NO_FEED: Error = Error(22);
    /// A value that must be whole.
    pub const NOT_WHOLE: Error = Error(23);
    /// Two codes that want the axis words.
    pub const AXES_TWICE: Error = Error(24);
    /// A word given twice.
    pub const REPEATED: Error = Error(25);
    /// A code that needs axis words.
    pub const NO_AXES: Error = Error(26);
    /// A line number beyond 9,999,999.
    pub const LINE_NUMBER: Error = Error(27);
    /// A word that the code needs.
    pub const MISSING: Error = Error(28);
    /// A coordinate system that Grbl does not have.
    pub const NO_SYSTEM: Error = Error(29);
    /// G53 with another move than G0 and G1.
    pub const MACHINE_MOVE: Error = Error(30);
    /// Axis words that nothing uses.
    pub const AXES_UNUSED: Error = Error(31);
    /// A move that cannot be.
    pub const TARGET: Error = Error(33);
    /// An arc whose radius cannot be.
    pub const RADIUS: Error = Error(34);
    /// An arc without centre.
    pub const NO_CENTRE: Error = Error(35);
    /// A word that nothing uses.
    pub const UNUSED: Error = Error(36);
    /// Tool length along another axis than Z.
    pub const LENGTH_AXIS: Error = Error(37);
    /// A tool number too large.
    pub const TOOL: Error = Error(38);

    /// The number for what the interpreter found in a block. `in_machine`: it has G53, which is at fault itself
    /// where another move than G0 and G1 is in force.
    pub fn of_block(fault: Fault, in_machine: bool) -> Error {
        match fault {
            Fault::CodesContradict | Fault::AxesWithoutCode if in_machine => Error::MACHINE_MOVE,
            fault => Error::of(fault),
        }
    }

    /// The number for what the interpreter found.
    pub fn of(fault: Fault) -> Error {
        match fault {
            Fault::NumberWithoutAddress | Fault::IllegalCharacter => Error::NO_LETTER,
            Fault::AddressWithoutNumber | Fault::MisplacedSign | Fault::MisplacedPoint => Error::NO_NUMBER,
            Fault::WordNegative | Fault::NegativeDwell => Error::NEGATIVE,
            Fault::LineTooLong => Error::LINE_TOO_LONG,
            Fault::UnknownGCode | Fault::UnknownMCode | Fault::UnknownAddress | Fault::NotSupported => {
                Error::UNSUPPORTED
            }
            Fault::RepeatedGroup => Error::GROUP,
            Fault::NoFeed | Fault::FeedOutOfRange => Error::NO_FEED,
            Fault::WordNotWhole => Error::NOT_WHOLE,
            Fault::CodesContradict => Error::AXES_TWICE,
            Fault::RepeatedAddress => Error::REPEATED,
            Fault::AxesMissing => Error::NO_AXES,
            Fault::WordMissing => Error::MISSING,
            Fault::WorkOffsetNumber => Error::NO_SYSTEM,
            Fault::ArcInMachine => Error::MACHINE_MOVE,
            Fault::AxesWithoutCode => Error::AXES_UNUSED,
            Fault::ArcRadiusTooSmall | Fault::ArcWithoutRadius => Error::RADIUS,
            Fault::ArcWithoutCentre => Error::NO_CENTRE,
            Fault::WordUnused => Error::UNUSED,
            Fault::ToolNumber | Fault::ToolMissing => Error::TOOL,
            _ => Error::TARGET,
        }
    }
}

/// Why the machine is locked: `ALARM:N`.
#[derive(Clone, Copy, PartialEq, Eq, Debug)]
pub enum AlarmCode {
    /// A hard limit, or an axis that went wrong.
    HardLimit = 1,
    /// A move beyond the travel of the machine.
    SoftLimit = 2,
    /// Reset while axes moved.
    Abort = 3,
    /// The probe was in contact before it began.
    ProbeBefore = 4,
    /// The probe met nothing.
    ProbeMissed = 5,
    /// Homing was reset.
    HomingReset = 6,
    /// The safety door was opened while homing.
    HomingDoor = 7,
    /// Homing failed.
    HomingFailed = 8,
    /// Not homed since the machine was switched on. It has no number: no `ALARM` line is sent.
    NotHomed = 0,
}

impl AlarmCode {
    /// The number for a fault of the machine.
    pub fn of(fault: Fault) -> AlarmCode {
        match fault {
            Fault::SoftLimit => AlarmCode::SoftLimit,
            Fault::SkipWithoutSignal => AlarmCode::ProbeMissed,
            Fault::SignalBefore => AlarmCode::ProbeBefore,
            Fault::HardLimit | Fault::FollowingError | Fault::NotInPosition => AlarmCode::HardLimit,
            _ => AlarmCode::Abort,
        }
    }

    /// Whether a probe failed.
    pub fn is_of_probe(self) -> bool {
        matches!(self, AlarmCode::ProbeBefore | AlarmCode::ProbeMissed)
    }

    /// Whether nothing but a reset is taken behind it.
    pub fn is_critical(self) -> bool {
        matches!(self, AlarmCode::HardLimit | AlarmCode::SoftLimit)
    }
}
