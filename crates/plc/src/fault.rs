//! What can be wrong with a ladder, and where.
//!
//! Numbers are those of GSK990MC appendix 2 (1001 to 1042); whoever shows them has the texts.

/// A broken rule of ladders; its number is the control's.
#[derive(Clone, Copy, PartialEq, Eq, Hash, Debug)]
#[repr(u16)]
pub enum Fault {
    /// A contact or coil without an address.
    NoAddress = 1001,
    /// An instruction that does not exist.
    UnknownFunction = 1002,
    /// COM and COME do not pair, or a function stands between them.
    ComWrong = 1003,
    /// More steps than the control holds.
    TooLarge = 1004,
    /// END1 or END2 is missing or misplaced.
    EndWrong = 1005,
    /// An output that cannot be one.
    IllegalOutput = 1006,
    /// A function with fewer conditions before it than it has inputs.
    NotConnected = 1008,
    /// A network that begins at no line.
    LineOpen = 1009,
    /// An address or value of a kind that the function does not take.
    WrongFormat = 1011,
    /// An address or value that is not written as one.
    WrongEntry = 1012,
    /// A character that may not stand there, or an address that does not exist.
    OutOfRange = 1013,
    /// A counter used twice.
    CounterTwice = 1014,
    /// JMP, JMPE, labels and their jumps do not pair.
    JumpWrong = 1015,
    /// A network that leads to no output.
    Incomplete = 1016,
    /// A network of a form that cannot be carried out.
    Unsupported = 1017,
    /// A timer used twice.
    TimerTwice = 1019,
    /// A function lacks a parameter.
    ParameterMissing = 1020,
    /// The ladder took too long and was stopped.
    TimeOut = 1021,
    /// SUB without its number.
    NoFunctionName = 1022,
    /// A parameter of a function beyond its range.
    ParameterRange = 1023,
    /// Contacts that lead nowhere.
    Superfluous = 1024,
    /// A function whose output is not connected.
    NoOutput = 1025,
    /// A network of more rows than are taken.
    TooManyRows = 1026,
    /// The same output at two places.
    OutputTwice = 1027,
    /// A file that is no ladder.
    FileFormat = 1028,
    /// A ladder file that cannot be read.
    FileMissing = 1029,
    /// Branches joined where there are none.
    VerticalLine = 1030,
    /// Tables larger than the room for them.
    TablesFull = 1031,
    /// The first level is too large for a period.
    FirstLevelTooLong = 1032,
    /// Too many SFT.
    TooManyShifts = 1033,
    /// The number of a DIFU or DIFD used twice.
    EdgeTwice = 1034,
    /// An instruction where none is carried out.
    OutsideLevels = 1039,
    /// CALL, SP and SPE do not pair, or stand in the wrong place.
    CallWrong = 1040,
    /// A line around a contact, without a contact in it.
    ParallelLine = 1041,
}

impl Fault {
    /// The control's number.
    pub fn number(self) -> u16 {
        self as u16
    }
}

/// A piece of a ladder's text.
#[derive(Clone, Copy, PartialEq, Eq, Debug, Default)]
pub struct Span {
    /// First byte, from the start of the file.
    pub offset: usize,
    /// Bytes.
    pub len: usize,
    /// Line, from 1; 0 where no line is meant.
    pub line: u32,
}

/// A fault at a place.
#[derive(Clone, PartialEq, Eq, Debug)]
pub struct Error {
    /// What is wrong.
    pub fault: Fault,
    /// Where.
    pub span: Span,
    /// The name, address or element that it is about, where the text there does not say it.
    pub about: Option<Box<str>>,
}

impl Error {
    /// A fault at a place.
    pub fn new(fault: Fault, span: Span) -> Error {
        Error { fault, span, about: None }
    }

    /// A fault of something that has a name.
    pub fn about(fault: Fault, span: Span, about: impl Into<Box<str>>) -> Error {
        Error { fault, span, about: Some(about.into()) }
    }
}
