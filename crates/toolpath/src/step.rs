//! Steps: what the machine is told to do, one at a time.

use ferrocut_geometry::{Arc, Axis, AxisSet, Plane, Position, Turn};
use ferrocut_program::Span;
use std::fmt;

/// One thing the machine is told to do, and the piece of program that caused it.
#[derive(Clone, PartialEq, Debug)]
pub struct Step {
    /// What to do.
    pub op: Op,
    /// The block that caused it; for the moves of a canned cycle, the cycle's block.
    pub span: Span,
    /// How many blocks had been begun with its own: tells the passes of one line apart. 0 where no program
    /// was run.
    pub block: u64,
    /// Which part of its block it is of. With single block the control stops behind each: on the intermediate point of
    /// G28 (GSK990MC part 2, 7.6), and behind the positioning of a canned cycle and on level R (part 1, 4).
    /// [`PASSED`](Self::PASSED) where it does not stop behind it.
    pub section: u32,
    /// Line of its block in the main program, counted from 1: within a subprogram that of the call. 0 where there is none.
    pub main_line: u32,
}

impl Step {
    /// The [`section`](Self::section) of what is no block to single block: what it waits for the machine with, and macro
    /// statements, unless a parameter says that they are (GSK990MC 51#5).
    pub const PASSED: u32 = u32::MAX;

    /// A step that no line of a main program gives: of block `block`, 0 for none.
    pub fn new(op: Op, span: Span, block: u64) -> Step {
        Step { op, span, block, section: 0, main_line: 0 }
    }
}

/// Feed of a cutting move.
#[derive(Clone, Copy, PartialEq, Debug)]
pub enum Feed {
    /// Along the path, mm/min (degrees/min where only rotary axes move). G94.
    PerMinute(f64),
    /// The same beyond a limit of the control, which holds for the speed that overrides make of it (GSK990MC 4.2.2, P96 and
    /// P97).
    Held {
        /// The feed of the program.
        programmed: f64,
        /// The limit: so it is run without an override.
        at: f64,
    },
    /// Per spindle revolution, mm/rev. G95.
    PerRevolution(f64),
    /// This move takes this many seconds, whatever its length. Inverse-time feed G93.
    Duration(f64),
}

impl Feed {
    /// The feed that is run without an override, mm/min, where it is one per minute.
    pub fn per_minute(self) -> Option<f64> {
        match self {
            Feed::PerMinute(feed) | Feed::Held { at: feed, .. } => Some(feed),
            Feed::PerRevolution(_) | Feed::Duration(_) => None,
        }
    }
}

/// What the feed of a helix is measured along; for an arc in its plane both are the same.
#[derive(Clone, Copy, PartialEq, Eq, Debug, Default)]
pub enum FeedAlong {
    /// The path in space (RS274/NGC).
    #[default]
    Path,
    /// The circle in its plane, the climb going on beside it (GSK990MC 4.2.3 B).
    Circle,
}

/// How the path runs from this move into the next one.
#[derive(Clone, Copy, PartialEq, Debug, Default)]
pub enum PathMode {
    /// Come to rest on the end point (G61, G09).
    ExactStop,
    /// Run on (G64). `tolerance` is how far the path may leave the programmed one at the joint,
    /// mm; `None` takes the machine's own.
    #[default]
    Continuous,
    /// Run on, staying within this distance of the programmed path, mm (G64 P).
    ContinuousWithin(f64),
    /// Run on into the next piece of the same block, within this distance, mm, whatever is in force between blocks:
    /// a curve is cut along many pieces. `None` takes the machine's own.
    WithinBlock(Option<f64>),
    /// Run on, slowed down about inner corners of a compensated path (G62).
    InnerCorners(InnerCorners),
    /// Run on, with feed override and feed hold without effect (G63).
    Tapping,
    /// Run on, with feed override without effect (Weihong G903).
    FullFeed,
}

impl PathMode {
    /// Run on where that leaves the path nowhere; what positioning does in most languages.
    pub const ON_PATH: PathMode = PathMode::ContinuousWithin(0.0);
}

/// Where a cutter-compensated path slows down, and how far (GSK990MC 4.8.2): in the last and the first stretch beside
/// a corner to the side of the tool, together 2 mm at most.
#[derive(Clone, Copy, PartialEq, Debug)]
pub struct InnerCorners {
    /// Plane of the compensation.
    pub plane: Plane,
    /// The tool runs left of the programmed path, so that corners to the left are inner ones.
    pub left: bool,
    /// Which of these corners count.
    pub rule: CornerRule,
    /// Feed below which it does not slow down, mm/min.
    pub lowest_feed: f64,
}

/// Which corners are slowed down for, and how slow.
#[derive(Clone, Copy, PartialEq, Debug)]
pub enum CornerRule {
    /// Those whose moves are at no more than this angle, degrees, 180 being straight on; to the lowest feed.
    Angle(f64),
    /// Those at which an axis would change its speed by more than this, mm/min; until none does.
    SpeedDifference(f64),
}

/// How long to wait.
#[derive(Clone, Copy, PartialEq, Debug)]
pub enum Dwell {
    /// Seconds.
    Seconds(f64),
    /// Turns of the spindle.
    Revolutions(f64),
}

/// Speed of the spindle.
#[derive(Clone, Copy, PartialEq, Debug)]
pub enum Speed {
    /// Turns, r/min.
    Rpm(f64),
    /// Constant surface speed (G96): the turns follow the distance of an axis from a centre.
    Surface {
        /// Speed at the circumference, mm/min.
        mm_per_min: f64,
        /// Lowest turns, r/min.
        min_rpm: f64,
        /// Highest turns, r/min, where the program sets them.
        max_rpm: Option<f64>,
        /// The axis.
        axis: Axis,
        /// Machine position of the axis at which the radius is 0, mm.
        center: f64,
    },
}

impl Speed {
    /// Turns with the axes at `at`, r/min.
    pub fn rpm(self, at: &Position) -> f64 {
        match self {
            Speed::Rpm(rpm) => rpm,
            Speed::Surface { mm_per_min: 0.0, .. } => 0.0,
            Speed::Surface { mm_per_min, min_rpm, max_rpm, axis, center } => {
                let radius = (at[axis] - center).abs();
                let rpm = mm_per_min / (std::f64::consts::TAU * radius);
                // On the centre any speed is too slow; without a limit it stays at rest there.
                let rpm = if rpm.is_finite() { rpm.max(min_rpm) } else { max_rpm.unwrap_or(0.0) };
                rpm.min(max_rpm.unwrap_or(f64::MAX))
            }
        }
    }
}

/// What the spindle is told.
#[derive(Clone, Copy, PartialEq, Debug, Default)]
pub enum SpindleState {
    /// M05.
    #[default]
    Off,
    /// Turning clockwise (M03).
    Clockwise(Speed),
    /// Turning counter-clockwise (M04).
    CounterClockwise(Speed),
}

impl SpindleState {
    /// Turning this way.
    pub fn turning(turn: Turn, speed: Speed) -> SpindleState {
        match turn {
            Turn::Clockwise => SpindleState::Clockwise(speed),
            Turn::CounterClockwise => SpindleState::CounterClockwise(speed),
        }
    }

    /// Which way it turns; `None` at rest.
    pub fn turn(self) -> Option<Turn> {
        match self {
            SpindleState::Off => None,
            SpindleState::Clockwise(_) => Some(Turn::Clockwise),
            SpindleState::CounterClockwise(_) => Some(Turn::CounterClockwise),
        }
    }

    /// The speed; `None` at rest.
    pub fn speed(self) -> Option<Speed> {
        match self {
            SpindleState::Off => None,
            SpindleState::Clockwise(speed) | SpindleState::CounterClockwise(speed) => Some(speed),
        }
    }
}

/// An output that programs set themselves, or an input that they wait for.
#[derive(Clone, PartialEq, Eq, Debug)]
pub enum Port {
    /// A digital one, counted from 0; off at value 0 (LinuxCNC M codes: M62 to M66).
    Digital(i64),
    /// An analog one, counted from 0 (LinuxCNC M codes: M67, M68).
    Analog(i64),
    /// One by the name that the program has for it: a variable, a port.
    Named(Box<str>),
}

impl Port {
    /// The number of a digital one: counted, or the one that its name is (Weihong 4.4: `PLC[04]`).
    pub fn number(&self) -> Option<u16> {
        match self {
            Port::Digital(number) => u16::try_from(*number).ok(),
            Port::Analog(_) => None,
            Port::Named(name) => {
                let number: f64 = name.trim().parse().ok()?;
                (number.fract() == 0.0 && (0.0..=f64::from(u16::MAX)).contains(&number))
                    .then_some(number as u16)
            }
        }
    }
}

impl fmt::Display for Port {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        match self {
            Port::Digital(number) => write!(f, "digital {number}"),
            Port::Analog(number) => write!(f, "analog {number}"),
            Port::Named(name) => f.write_str(name),
        }
    }
}

/// What a [`Step`] does. Positions are machine coordinates of every axis: mm, degrees.
#[derive(Clone, PartialEq, Debug)]
pub enum Op {
    /// Positioning (G00).
    Rapid {
        /// End point.
        to: Position,
        /// Along a straight line; else each axis runs at its own rapid rate and ends when it ends.
        straight: bool,
        /// Highest speed along a straight line, mm/min, where the program gives one.
        speed: Option<f64>,
        /// Joint with the next move.
        path: PathMode,
    },
    /// Straight cut (G01).
    Feed {
        /// End point.
        to: Position,
        /// Feed along the path.
        feed: Feed,
        /// Joint with the next move.
        path: PathMode,
    },
    /// Circular or helical cut (G02, G03). The start is where the step before ended.
    Arc {
        /// End point.
        to: Position,
        /// Plane of the circle.
        plane: Plane,
        /// Centre on the plane's axes, mm.
        center: [f64; 2],
        /// Signed angle turned, radians, counter-clockwise positive; beyond ±2π for several turns.
        sweep: f64,
        /// Feed.
        feed: Feed,
        /// What the feed of a helix is measured along.
        feed_along: FeedAlong,
        /// Joint with the next move.
        path: PathMode,
    },
    /// Spindle-synchronised straight move (rigid tapping, threading).
    Tap {
        /// End point.
        to: Position,
        /// Travel a revolution, mm; right-hand thread positive.
        pitch: f64,
        /// Spindle speed, r/min.
        rpm: f64,
        /// Behind the thread the spindle turns again as it did before it; else it stands still.
        goes_on: bool,
    },
    /// Feed until the skip signal comes (G31), or goes. The next step is a [`Barrier`](Op::Barrier), so that the
    /// interpreter learns where motion stopped before it goes on.
    Skip {
        /// Where motion ends: where the simulated signal comes, or without one the end point.
        to: Position,
        /// Feed along the path.
        feed: Feed,
        /// Whether the signal comes.
        hit: bool,
        /// The signal is that the probe is free, not that it touches; or that the input is off.
        away: bool,
        /// The input whose signal it is; the probe's without one.
        input: Option<Port>,
    },
    /// Nothing is done; the block behind it reads what only a machine at rest knows. Whoever runs steps
    /// lets the axes come to rest on the end of the move before, tells the interpreter where they are,
    /// and only then asks for the next step. At a desk there is nothing to wait for.
    Barrier,
    /// Pause.
    Dwell(Dwell),
    /// The spindle's new state.
    Spindle(SpindleState),
    /// Stop the spindle at an angle, degrees (M19).
    Orient(f64),
    /// Flood coolant on (M08) or off (M09).
    Coolant(bool),
    /// Tool chosen, not yet in the spindle (T).
    Select(u32),
    /// Chosen tool put into the spindle (M06).
    Change(u32),
    /// The tool in the spindle has this number from here on; nothing is changed (Weihong M903).
    ToolNumber(u32),
    /// Any other M code, handed to the machine.
    Machine(u32),
    /// An M code that hands a number to the machine (Weihong M802).
    MachineNumber {
        /// The code.
        code: u32,
        /// The number.
        number: u32,
    },
    /// An output that the program sets itself.
    Output {
        /// Which one.
        port: Port,
        /// What it is set to.
        value: f64,
        /// It changes as the next move begins, and the path runs on into that; without a next move it does not change
        /// (LinuxCNC M codes: M62, M63, M67). Else the axes rest where it changes.
        with_next_move: bool,
    },
    /// The control waits until an input has a state.
    Wait {
        /// Which one.
        port: Port,
        /// The state, 0 or 1.
        value: f64,
        /// It is to come to that state, and not to have it already.
        is_edge: bool,
        /// How long at most, s; without end where not given.
        timeout: Option<f64>,
        /// If it does not come in time that is an alarm. Else the program goes on, and is told at the barrier behind.
        must_come: bool,
    },
    /// Nothing moves; from here on the place where the axes stand is called by these machine positions.
    Datum {
        /// Machine position of every axis.
        at: Position,
    },
    /// Reference-point return of these axes; the moves that lead there are steps before it.
    Home(AxisSet),
    /// Program stop, continued by cycle start: M00, or M01 where optional stop is on.
    Stop(u32),
    /// End of the program: M02, M30, or M99 where the control ends on it.
    End(u32),
    /// Text for the operator.
    Message(Box<str>),
}

impl Op {
    /// Where the axes are commanded to be after this step, if it moves them.
    #[inline]
    pub fn target(&self) -> Option<&Position> {
        match self {
            Op::Rapid { to, .. }
            | Op::Feed { to, .. }
            | Op::Arc { to, .. }
            | Op::Tap { to, .. }
            | Op::Skip { to, .. } => Some(to),
            _ => None,
        }
    }

    /// How the path runs into the next move; `None` where that is no choice of the program.
    pub fn path(&self) -> Option<PathMode> {
        match *self {
            Op::Rapid { path, .. } | Op::Feed { path, .. } | Op::Arc { path, .. } => Some(path),
            _ => None,
        }
    }

    /// Whether material may be cut: any move but positioning.
    pub fn is_cutting(&self) -> bool {
        self.target().is_some() && !matches!(self, Op::Rapid { .. })
    }

    /// The arc this step describes when it starts at `from`.
    pub fn arc(&self, from: Position) -> Option<Arc> {
        match *self {
            Op::Arc { to, plane, center, sweep, .. } => {
                Some(Arc { plane, center, start: from, end: to, sweep })
            }
            _ => None,
        }
    }

    /// Smallest and largest coordinates of the move that starts at `from`; `None` if it is no move.
    pub fn extent(&self, from: Position) -> Option<(Position, Position)> {
        match self.arc(from) {
            Some(arc) => Some(arc.extent()),
            None => self.target().map(|to| (from.min(*to), from.max(*to))),
        }
    }

    /// Whether it moves an axis that is at `from` when it starts. A move to where the axes are is none.
    pub fn moves_from(&self, from: Position) -> bool {
        self.extent(from).is_some_and(|(min, max)| min != max)
    }

    /// Length of the move that starts at `from`, mm (degrees where only rotary axes move).
    pub fn length(&self, from: Position) -> f64 {
        match self.arc(from) {
            Some(arc) => arc.length(),
            None => self.target().map_or(0.0, |to| from.distance(*to)),
        }
    }
}
