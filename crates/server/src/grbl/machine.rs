//! What the protocol needs of a machine.

use ferrocut_geometry::{AxisSet, Position};
use ferrocut_machine::Fault;

/// What a machine does.
#[derive(Clone, Copy, PartialEq, Eq, Debug, Default)]
pub enum Doing {
    /// Nothing, and nothing is left to do.
    #[default]
    Idle,
    /// A program.
    Run,
    /// Coming to rest by feed hold.
    Holding,
    /// At rest by feed hold or M0.
    Held,
    /// A jog.
    Jog,
    /// Homing.
    Home,
    /// Coming to rest by reset.
    Resetting,
    /// Stopped by an alarm.
    Alarm,
}

/// The machine at one moment. Positions are machine coordinates: mm, degrees.
#[derive(Clone, PartialEq, Debug, Default)]
pub struct Status {
    /// Every command that was given is in this status.
    pub is_current: bool,
    /// What it does.
    pub doing: Doing,
    /// Where the axes are.
    pub position: Position,
    /// Speed along the path, mm/min.
    pub feed: f64,
    /// Speed of the spindle, r/min.
    pub rpm: f64,
    /// Line of the blocks being run, by the count of those that were given; 0 for none.
    pub line: u32,
    /// The last line that is taken: its moves are with motion, all else of it is done.
    pub lines_done: u32,
    /// Lines that motion has room for.
    pub room: usize,
    /// All axes know where they are.
    pub is_homed: bool,
    /// What is in force behind the lines taken.
    pub modal: Modal,
    /// Offsets.
    pub offsets: Offsets,
    /// Where the last probe ended, and whether it met something.
    pub probe: (Position, bool),
    /// Inputs that are on.
    pub pins: Pins,
}

/// Inputs of the machine that are on.
#[derive(Clone, Copy, PartialEq, Eq, Debug, Default)]
pub struct Pins {
    /// The probe touches.
    pub probe: bool,
    /// Axes beyond a travel switch.
    pub limits: AxisSet,
    /// The safety door is open.
    pub door: bool,
    /// The emergency stop is pressed. Grbl's input for it is that of reset.
    pub reset: bool,
}

/// What is in force behind the lines taken.
#[derive(Clone, PartialEq, Debug)]
pub struct Modal {
    /// G codes in tenths, in the order in which they are shown.
    pub codes: [u16; 6],
    /// M3, M4 or M5.
    pub spindle: u8,
    /// M8.
    pub flood: bool,
    /// M7.
    pub mist: bool,
    /// F in units of the program.
    pub feed: f64,
    /// S, r/min.
    pub speed: f64,
    /// Machine position of the programmed zero, tool length included, mm.
    pub zero: Position,
}

impl Default for Modal {
    fn default() -> Modal {
        Modal {
            codes: [0, 540, 170, 210, 900, 940],
            spindle: 5,
            flood: false,
            mist: false,
            feed: 0.0,
            speed: 0.0,
            zero: Position::ZERO,
        }
    }
}

impl Modal {
    /// G20.
    pub fn is_inch(&self) -> bool {
        self.codes.contains(&200)
    }

    /// G91.
    pub fn is_incremental(&self) -> bool {
        self.codes.contains(&910)
    }
}

/// Offsets, mm.
#[derive(Clone, PartialEq, Debug, Default)]
pub struct Offsets {
    /// G54 to G59.
    pub systems: [Position; 6],
    /// G28 and G30.
    pub references: [Position; 2],
    /// G92.
    pub shift: Position,
    /// Tool length along Z.
    pub length: f64,
}

/// What happened beside the status.
#[derive(Clone, PartialEq, Debug)]
pub enum Event {
    /// A line was refused: its count, and why.
    Refused(u32, Fault),
    /// The machine stopped by an alarm.
    Alarm(Fault),
    /// A program ended (M2, M30).
    Ended,
    /// Text of the program.
    Message(Box<str>),
}

/// A machine, as a sender sees it. No call waits for anything to end.
pub trait Machine {
    /// How it is now.
    fn status(&mut self) -> &Status;

    /// The next thing that happened.
    fn event(&mut self) -> Option<Event>;

    /// Runs a block behind those given before. Lines are counted from 1 on.
    fn append(&mut self, block: &str);

    /// What the interpreter has against a block if it came now; nothing moves. The first call behind a reset of the
    /// check begins with what is in force.
    fn check(&mut self, block: &str) -> Option<Fault>;

    /// Ends checking.
    fn end_check(&mut self);

    /// Axes to rest on the path.
    fn hold(&mut self);

    /// Goes on behind a hold or M0.
    fn start(&mut self);

    /// Axes to rest, and forgets what was given.
    fn reset(&mut self);

    /// A move by hand in a line to a machine position, mm/min.
    fn jog(&mut self, to: Position, feed: f64);

    /// Ends jogs at once.
    fn cancel_jog(&mut self);

    /// To the home position of all axes.
    fn home(&mut self);

    /// Overrides, percent.
    fn set_overrides(&mut self, overrides: Overrides);

    /// Stops the spindle in a hold, or starts it as it was.
    fn stop_spindle(&mut self, stops: bool);
}

/// Overrides, percent.
#[derive(Clone, Copy, PartialEq, Eq, Debug)]
pub struct Overrides {
    /// Of the feed, 10 to 200.
    pub feed: u16,
    /// Of positioning, 25, 50 or 100.
    pub rapid: u16,
    /// Of the spindle, 10 to 200.
    pub spindle: u16,
}

impl Default for Overrides {
    fn default() -> Overrides {
        Overrides { feed: 100, rapid: 100, spindle: 100 }
    }
}
