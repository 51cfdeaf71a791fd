//! What the NC reads from the ladder and tells it, as plain fields, and at which signals each of them stands.
//!
//! [`Inputs`] and [`Outputs`] are all that the NC knows of the ladder; a test may fill them in without one.
//! [`ROWS`] alone knows addresses. They are those of the Fanuc 0i-M, signals marked *ours* in `docs/plc.md` stand
//! where it has none. A ladder that stands still has all of G off: the NC then reads an emergency stop, a feed
//! hold, overrides of 0 and every axis at its limits.

use ferrocut_plc::memory::Width;
use ferrocut_plc::{Address, Area, Memory};
use serde::{Deserialize, Serialize};

/// Axes that have signals: one bit each of a byte, in the order of the machine file.
pub const SIGNAL_AXES: usize = 8;

/// The mode of the control (GSK990MC part 2, 1.2.4).
#[derive(Clone, Copy, PartialEq, Eq, Hash, Debug, Default, Serialize, Deserialize)]
#[cfg_attr(feature = "typescript", derive(ts_rs::TS))]
#[serde(rename_all = "snake_case")]
pub enum Mode {
    /// Programs are written; nothing runs.
    #[default]
    Edit,
    /// Programs of the memory run.
    Auto,
    /// Blocks that were typed in run.
    Mdi,
    /// Axes go to their reference points.
    Home,
    /// Axes move while their key is held.
    Jog,
    /// Axes move by an increment a key.
    Step,
    /// Axes follow the handwheel.
    Handle,
    /// A program runs that comes from outside.
    Dnc,
}

impl Mode {
    /// Every mode.
    pub const ALL: [Mode; 8] =
        [Mode::Edit, Mode::Auto, Mode::Mdi, Mode::Home, Mode::Jog, Mode::Step, Mode::Handle, Mode::Dnc];

    /// Whether programs run in it.
    pub fn is_automatic(self) -> bool {
        matches!(self, Mode::Auto | Mode::Mdi | Mode::Dnc)
    }

    /// Whether axes are moved by hand in it, homing aside.
    pub fn is_manual(self) -> bool {
        matches!(self, Mode::Jog | Mode::Step | Mode::Handle)
    }

    /// MD4 MD2 MD1, with DNCI above them, then STEPI and ZRN (Fanuc 0i). A code of no mode is EDIT, in which
    /// nothing moves.
    fn decoded(bits: u32) -> Mode {
        let is = |bit: u32| bits & bit != 0;
        match bits & 0b111 {
            0b000 => Mode::Mdi,
            0b001 if is(DNCI) => Mode::Dnc,
            0b001 => Mode::Auto,
            0b100 if is(STEPI) => Mode::Step,
            0b100 => Mode::Handle,
            0b101 if is(ZRN) => Mode::Home,
            0b101 => Mode::Jog,
            _ => Mode::Edit,
        }
    }
}

const DNCI: u32 = 1 << 3;
const STEPI: u32 = 1 << 4;
const ZRN: u32 = 1 << 5;

/// Both ways of an axis.
#[derive(Clone, Copy, PartialEq, Eq, Debug, Default)]
pub struct Ways {
    /// Upwards.
    pub plus: bool,
    /// Downwards.
    pub minus: bool,
}

impl Ways {
    /// 1 upwards, -1 downwards, 0 where neither or both are asked for.
    pub fn sign(self) -> i8 {
        i8::from(self.plus) - i8::from(self.minus)
    }
}

/// The step of the rapid override switch.
#[derive(Clone, Copy, PartialEq, Eq, Debug, Default)]
pub enum RapidOverride {
    /// 100 %.
    #[default]
    Full,
    /// 50 %.
    Half,
    /// 25 %.
    Quarter,
    /// F0: the speed of a parameter (GSK990MC P93), or none (12#4).
    Lowest,
}

impl RapidOverride {
    /// As a factor; `None` for F0.
    pub fn factor(self) -> Option<f64> {
        match self {
            RapidOverride::Full => Some(1.0),
            RapidOverride::Half => Some(0.5),
            RapidOverride::Quarter => Some(0.25),
            RapidOverride::Lowest => None,
        }
    }
}

/// What the NC reads from the ladder in a period. Arrays go by the machine's axes, in the order of its file.
#[derive(Clone, PartialEq, Debug, Default)]
pub struct Inputs {
    /// The mode that is chosen.
    pub mode: Mode,
    /// Cycle start; the NC starts when it turns off.
    pub cycle_start: bool,
    /// Feed hold is asked for.
    pub feed_hold: bool,
    /// Emergency stop, by its own input or by the ladder.
    pub emergency_stop: bool,
    /// Reset from outside.
    pub reset: bool,
    /// Reset from outside, and the program goes back to its head.
    pub rewind: bool,
    /// Cycle start has no effect, and what runs is held.
    pub start_lock: bool,
    /// Axes may move: no interlock.
    pub axes_may_move: bool,
    /// Single block.
    pub single_block: bool,
    /// Blocks with a slash are skipped.
    pub block_skip: bool,
    /// M01 stops.
    pub optional_stop: bool,
    /// Dry run.
    pub dry_run: bool,
    /// With dry run the handwheel drives the program.
    pub handwheel_drive: bool,
    /// Axes do not move, positions go on.
    pub machine_lock: bool,
    /// M, S, T and B codes are not handed out.
    pub auxiliary_lock: bool,
    /// Program restart.
    pub restart: bool,
    /// Feed override, 0 to 2.54 as a factor.
    pub feed_override: f64,
    /// Rapid override.
    pub rapid_override: RapidOverride,
    /// Override of the jog feed, 0 to 6.5534 as a factor.
    pub manual_override: f64,
    /// Axes are jogged at rapid speed.
    pub manual_rapid: bool,
    /// Spindle override, 0 to 2.55 as a factor.
    pub spindle_override: f64,
    /// Keys of the axes.
    pub jog: [Ways; SIGNAL_AXES],
    /// The axis that the handwheel moves, counted from 0.
    pub handwheel_axis: Option<usize>,
    /// Increment of step and handwheel: 0 to 3 for 1, 10, 100 and 1000 least input increments.
    pub increment: u8,
    /// The spindle turns forward.
    pub spindle_forward: bool,
    /// The spindle turns in reverse.
    pub spindle_reverse: bool,
    /// The spindle is jogged: it turns at the speed for that.
    pub spindle_jog: bool,
    /// The spindle is to come to its angle and hold it.
    pub spindle_orient: bool,
    /// The spindle drive is on.
    pub spindle_drive_on: bool,
    /// Emergency stop of the spindle drive.
    pub spindle_emergency_stop: bool,
    /// The spindle may turn.
    pub spindle_may_turn: bool,
    /// The ladder says that the spindle has its speed: cutting may begin.
    pub spindle_at_speed: bool,
    /// Rigid tapping is asked for.
    pub rigid_tapping: bool,
    /// The gear that is engaged, 1 to 4 (gear selection T).
    pub gear: u8,
    /// FIN: what was handed out is done, whatever it was.
    pub finished: bool,
    /// MFIN: the M code is done.
    pub m_finished: bool,
    /// SFIN: the S code is done.
    pub s_finished: bool,
    /// TFIN: the T code is done.
    pub t_finished: bool,
    /// BFIN: the B code is done.
    pub b_finished: bool,
    /// Axes that are on their limit switches.
    pub at_limit: [Ways; SIGNAL_AXES],
    /// Ways that an axis may not go.
    pub no_motion: [Ways; SIGNAL_AXES],
    /// Axes that are on their home switches.
    pub on_home_switch: [bool; SIGNAL_AXES],
    /// Axes of which the ladder says so.
    pub on_home_switch_by_ladder: [bool; SIGNAL_AXES],
    /// The skip signal: a probe touches.
    pub skip: bool,
    /// The tool in the spindle as the ladder knows it, 0 for none; where it tells that.
    pub tool_in_spindle: Option<u32>,
    /// Inputs of macro programs, #1000 to #1015 from bit 0 on.
    pub macro_inputs: u16,
}

impl Inputs {
    /// Increment of step and handwheel for a least input increment, mm or degrees.
    pub fn increment_of(&self, least: f64) -> f64 {
        least * [1.0, 10.0, 100.0, 1000.0].get(usize::from(self.increment)).copied().unwrap_or(1.0)
    }

    /// What the ladder says.
    pub fn read(memory: &Memory) -> Inputs {
        let mut raw = Raw::default();
        for row in ROWS {
            let Link::Reads(set) = row.link else { continue };
            for (n, value) in row.values(memory) {
                set(&mut raw, n, value);
            }
        }
        let mut inputs = raw.inputs;
        inputs.mode = Mode::decoded(raw.mode);
        inputs.rapid_override = match raw.rapid {
            0 => RapidOverride::Full,
            1 => RapidOverride::Half,
            2 => RapidOverride::Quarter,
            _ => RapidOverride::Lowest,
        };
        inputs.handwheel_axis = (raw.wheel as usize).checked_sub(1);
        inputs.increment = raw.increment as u8;
        inputs.gear = raw.gear as u8 + 1;
        inputs
    }
}

/// [`Inputs`], and what several signals say together.
#[derive(Default)]
struct Raw {
    inputs: Inputs,
    mode: u32,
    rapid: u32,
    wheel: u32,
    increment: u32,
    gear: u32,
}

/// A code that is handed to the ladder.
#[derive(Clone, Copy, PartialEq, Eq, Debug, Default)]
pub struct Code {
    /// It is there.
    pub strobe: bool,
    /// Its number. It stays until the next one.
    pub code: u32,
}

/// What the NC tells the ladder in a period. Arrays go by the machine's axes, in the order of its file.
#[derive(Clone, PartialEq, Debug, Default)]
pub struct Outputs {
    /// The mode that is in force.
    pub mode: Mode,
    /// The NC works.
    pub ready: bool,
    /// The drives of the axes are on.
    pub servo_ready: bool,
    /// An alarm stands.
    pub alarm: bool,
    /// Reset, for the time of its parameter (GSK990MC P203).
    pub reset: bool,
    /// The program is being brought to its head.
    pub rewinding: bool,
    /// Automatic operation: a program runs, or is held or stopped and may go on.
    pub automatic: bool,
    /// A program runs.
    pub running: bool,
    /// Feed hold.
    pub held: bool,
    /// All moves of the block are done.
    pub distribution_end: bool,
    /// The spindle is told a speed other than 0.
    pub spindle_enabled: bool,
    /// A tapping cycle is in force, or G63.
    pub tapping: bool,
    /// A positioning move is being run.
    pub rapid: bool,
    /// A cutting move is being run.
    pub cutting: bool,
    /// A thread is being cut.
    pub threading: bool,
    /// Constant surface speed is in force.
    pub surface_speed: bool,
    /// Program restart goes on.
    pub restarting: bool,
    /// Dry run is in force.
    pub dry_run: bool,
    /// Block skip is in force.
    pub block_skip: bool,
    /// Machine lock is in force.
    pub machine_lock: bool,
    /// Single block is in force.
    pub single_block: bool,
    /// Auxiliary lock is in force.
    pub auxiliary_lock: bool,
    /// M code.
    pub m: Code,
    /// S code.
    pub s: Code,
    /// T code.
    pub t: Code,
    /// B code.
    pub b: Code,
    /// M00 is being done.
    pub m00: bool,
    /// M01 is being done.
    pub m01: bool,
    /// M02 is being done.
    pub m02: bool,
    /// M30 is being done.
    pub m30: bool,
    /// The gear that the spindle needs, 1 to 3; 0 for none (gear selection M).
    pub gear: u8,
    /// Speed of the spindle, r/min.
    pub spindle_rpm: u16,
    /// The spindle drive has an alarm.
    pub spindle_alarm: bool,
    /// The spindle stands still.
    pub spindle_zero: bool,
    /// The spindle has the speed that it was told.
    pub spindle_at_speed: bool,
    /// The spindle is at its angle.
    pub spindle_oriented: bool,
    /// Rigid tapping is in force.
    pub rigid_tapping: bool,
    /// The parts that are wanted are made.
    pub parts_reached: bool,
    /// Axes at their reference point.
    pub at_reference: [bool; SIGNAL_AXES],
    /// Axes at their second, third and fourth reference point.
    pub at_further_reference: [[bool; SIGNAL_AXES]; 3],
    /// Axes whose reference point is established.
    pub referenced: [bool; SIGNAL_AXES],
    /// Axes that move.
    pub moving: [bool; SIGNAL_AXES],
    /// Axes that move downwards, or did last.
    pub downwards: [bool; SIGNAL_AXES],
    /// Axes that are in position.
    pub in_position: [bool; SIGNAL_AXES],
    /// Outputs of programs, #1100 to #1115 or the digital outputs 0 to 15 of RS274 from bit 0 on.
    pub macro_outputs: u16,
}

impl Outputs {
    /// Tells the ladder.
    pub fn write(&self, memory: &mut Memory) {
        for row in ROWS {
            let Link::Tells(get) = row.link else { continue };
            for n in 0..row.names.len() {
                let address = row.address(n);
                match row.bytes {
                    0 => memory.set_bit(address, get(self, n) != 0),
                    bytes => {
                        let value = get(self, n).cast_signed();
                        memory.write(address.place(), Width::of(bytes.into()), value);
                    }
                }
            }
        }
    }
}

/// What a row of signals is to the NC.
#[derive(Clone, Copy)]
enum Link {
    /// The NC reads it: the number of the signal in its row, and its value.
    Reads(fn(&mut Raw, usize, u32)),
    /// The NC tells it.
    Tells(fn(&Outputs, usize) -> u32),
}

/// Signals of one meaning: one, or one for each axis at successive bits.
pub struct Row {
    /// Their names.
    pub names: &'static [&'static str],
    area: Area,
    byte: u16,
    bit: u8,
    /// How many bytes the value has; 0 for a bit.
    bytes: u8,
    link: Link,
}

impl Row {
    /// The address of a signal of the row.
    pub fn address(&self, n: usize) -> Address {
        // A row has eight bits at most.
        let bit = (self.bytes == 0).then_some(self.bit + n as u8);
        Address { area: self.area, byte: self.byte, bit }
    }

    /// Bytes of its value; 0 for a bit.
    pub fn bytes(&self) -> u8 {
        self.bytes
    }

    /// Whether the NC reads it.
    pub fn is_read(&self) -> bool {
        matches!(self.link, Link::Reads(_))
    }

    fn values<'a>(&'a self, memory: &'a Memory) -> impl Iterator<Item = (usize, u32)> + 'a {
        (0..self.names.len()).map(move |n| {
            let address = self.address(n);
            let value = match self.bytes {
                0 => u32::from(memory.bit(address)),
                1 => u32::from(memory.byte(address)),
                bytes => memory.read(address.place(), Width::of(bytes.into())).cast_unsigned(),
            };
            (n, value)
        })
    }
}

/// A signal that the NC reads or tells.
#[derive(Clone, Copy, PartialEq, Eq, Debug)]
pub struct Signal {
    /// Its name.
    pub name: &'static str,
    /// Its address; of a value, that of its first byte.
    pub address: Address,
    /// Bytes of its value; 0 for a bit.
    pub bytes: u8,
    /// Whether the NC reads it; else the NC tells it.
    pub is_read: bool,
}

/// Every signal of the NC.
pub fn signals() -> impl Iterator<Item = Signal> {
    ROWS.iter().flat_map(|row| {
        row.names.iter().enumerate().map(|(n, name)| Signal {
            name,
            address: row.address(n),
            bytes: row.bytes,
            is_read: row.is_read(),
        })
    })
}

/// The signal of a name.
pub fn signal(name: &str) -> Option<Signal> {
    signals().find(|signal| signal.name == name)
}

const fn bit(names: &'static [&'static str], area: Area, byte: u16, bit: u8, link: Link) -> Row {
    Row { names, area, byte, bit, bytes: 0, link }
}

const fn value(names: &'static [&'static str], area: Area, byte: u16, bytes: u8, link: Link) -> Row {
    Row { names, area, byte, bit: 0, bytes, link }
}

/// A bit that the NC reads from G.
const fn g(names: &'static [&'static str], byte: u16, at: u8, set: fn(&mut Raw, usize, u32)) -> Row {
    bit(names, Area::G, byte, at, Link::Reads(set))
}

/// A bit that the NC tells in F.
const fn f(names: &'static [&'static str], byte: u16, at: u8, get: fn(&Outputs, usize) -> u32) -> Row {
    bit(names, Area::F, byte, at, Link::Tells(get))
}

/// A percentage that is inverted; all bits off, as all bits on, are 0 (Fanuc 0i).
fn inverted(value: u32, most: u32, unit: f64) -> f64 {
    let value = value & most;
    if value == 0 { 0.0 } else { f64::from(most - value) * unit }
}

/// One of an axis.
fn of(axes: &[bool; SIGNAL_AXES], n: usize) -> u32 {
    u32::from(axes.get(n).copied().unwrap_or_default())
}

fn set(axes: &mut [bool; SIGNAL_AXES], n: usize, on: bool) {
    if let Some(axis) = axes.get_mut(n) {
        *axis = on;
    }
}

fn plus(axes: &mut [Ways; SIGNAL_AXES], n: usize, on: bool) {
    if let Some(axis) = axes.get_mut(n) {
        axis.plus = on;
    }
}

fn minus(axes: &mut [Ways; SIGNAL_AXES], n: usize, on: bool) {
    if let Some(axis) = axes.get_mut(n) {
        axis.minus = on;
    }
}

/// The button of the emergency stop, closed while it is out: byte and bit of X.
pub(crate) const ESP_BUTTON: (&str, (u16, u8)) = ("*ESP_BUTTON", (8, 4));

/// Every signal that passes between ladder and NC.
#[rustfmt::skip]
pub const ROWS: &[Row] = &[
    // Inputs at addresses that the NC reads itself.
    bit(&["SKIP"], Area::X, 4, 7, Link::Reads(|r, _, v| r.inputs.skip = v != 0)),
    bit(&[ESP_BUTTON.0], Area::X, ESP_BUTTON.1.0, ESP_BUTTON.1.1,
        Link::Reads(|r, _, v| r.inputs.emergency_stop |= v == 0)),
    bit(&["*DEC_X", "*DEC_Y", "*DEC_Z", "*DEC_A", "*DEC_5", "*DEC_6", "*DEC_7", "*DEC_8"], Area::X, 9, 0,
        Link::Reads(|r, n, v| set(&mut r.inputs.on_home_switch, n, v == 0))),
    // The ladder to the NC.
    g(&["FIN"], 4, 3, |r, _, v| r.inputs.finished = v != 0),
    g(&["MFIN"], 5, 0, |r, _, v| r.inputs.m_finished = v != 0),
    g(&["SFIN"], 5, 2, |r, _, v| r.inputs.s_finished = v != 0),
    g(&["TFIN"], 5, 3, |r, _, v| r.inputs.t_finished = v != 0),
    g(&["AFL"], 5, 6, |r, _, v| r.inputs.auxiliary_lock = v != 0),
    g(&["BFIN"], 5, 7, |r, _, v| r.inputs.b_finished = v != 0),
    g(&["SRN"], 6, 0, |r, _, v| r.inputs.restart = v != 0),
    g(&["STLK"], 7, 1, |r, _, v| r.inputs.start_lock = v != 0),
    g(&["ST"], 7, 2, |r, _, v| r.inputs.cycle_start = v != 0),
    g(&["*IT"], 8, 0, |r, _, v| r.inputs.axes_may_move = v != 0),
    g(&["*ESP"], 8, 4, |r, _, v| r.inputs.emergency_stop |= v == 0),
    g(&["*SP"], 8, 5, |r, _, v| r.inputs.feed_hold = v == 0),
    g(&["RRW"], 8, 6, |r, _, v| r.inputs.rewind = v != 0),
    g(&["ERS"], 8, 7, |r, _, v| r.inputs.reset = v != 0),
    value(&["*JV"], Area::G, 10, 2, Link::Reads(|r, _, v| r.inputs.manual_override = inverted(v, 0xFFFF, 1e-4))),
    value(&["*FV"], Area::G, 12, 1, Link::Reads(|r, _, v| r.inputs.feed_override = inverted(v, 0xFF, 0.01))),
    g(&["ROV1", "ROV2"], 14, 0, |r, n, v| r.rapid |= v << n),
    g(&["HS1A", "HS1B", "HS1C", "HS1D"], 18, 0, |r, n, v| r.wheel |= v << n),
    g(&["MP1", "MP2"], 19, 4, |r, n, v| r.increment |= v << n),
    g(&["RT"], 19, 7, |r, _, v| r.inputs.manual_rapid = v != 0),
    g(&["GR1", "GR2"], 28, 1, |r, n, v| r.gear |= v << n),
    g(&["SJOG"], 28, 7, |r, _, v| r.inputs.spindle_jog = v != 0),
    g(&["SAR"], 29, 4, |r, _, v| r.inputs.spindle_at_speed = v != 0),
    g(&["SOR"], 29, 5, |r, _, v| r.inputs.spindle_orient |= v != 0),
    g(&["*SSTP"], 29, 6, |r, _, v| r.inputs.spindle_may_turn = v != 0),
    value(&["SOV"], Area::G, 30, 1, Link::Reads(|r, _, v| r.inputs.spindle_override = f64::from(v & 0xFF) / 100.0)),
    g(&["HDRV"], 42, 0, |r, _, v| r.inputs.handwheel_drive = v != 0),
    g(&["MD1", "MD2", "MD4"], 43, 0, |r, n, v| r.mode |= v << n),
    g(&["DNCI"], 43, 5, |r, _, v| r.mode |= v * DNCI),
    g(&["STEPI"], 43, 6, |r, _, v| r.mode |= v * STEPI),
    g(&["ZRN"], 43, 7, |r, _, v| r.mode |= v * ZRN),
    g(&["BDT"], 44, 0, |r, _, v| r.inputs.block_skip = v != 0),
    g(&["MLK"], 44, 1, |r, _, v| r.inputs.machine_lock = v != 0),
    g(&["OPTS"], 44, 7, |r, _, v| r.inputs.optional_stop = v != 0),
    g(&["SBK"], 46, 1, |r, _, v| r.inputs.single_block = v != 0),
    g(&["DRN"], 46, 7, |r, _, v| r.inputs.dry_run = v != 0),
    value(&["UI"], Area::G, 54, 2, Link::Reads(|r, _, v| r.inputs.macro_inputs = (v & 0xFFFF) as u16)),
    g(&["RGTAP"], 61, 0, |r, _, v| r.inputs.rigid_tapping = v != 0),
    g(&["SRVA"], 70, 4, |r, _, v| r.inputs.spindle_reverse = v != 0),
    g(&["SFRA"], 70, 5, |r, _, v| r.inputs.spindle_forward = v != 0),
    g(&["ORCMA"], 70, 6, |r, _, v| r.inputs.spindle_orient |= v != 0),
    g(&["MRDYA"], 70, 7, |r, _, v| r.inputs.spindle_drive_on = v != 0),
    g(&["*ESPA"], 71, 1, |r, _, v| r.inputs.spindle_emergency_stop = v == 0),
    g(&["JX+", "JY+", "JZ+", "JA+", "J5+", "J6+", "J7+", "J8+"], 100, 0, |r, n, v| plus(&mut r.inputs.jog, n, v != 0)),
    g(&["JX-", "JY-", "JZ-", "JA-", "J5-", "J6-", "J7-", "J8-"], 102, 0, |r, n, v| minus(&mut r.inputs.jog, n, v != 0)),
    g(&["*L1+", "*L2+", "*L3+", "*L4+", "*L5+", "*L6+", "*L7+", "*L8+"], 114, 0,
        |r, n, v| plus(&mut r.inputs.at_limit, n, v == 0)),
    g(&["*L1-", "*L2-", "*L3-", "*L4-", "*L5-", "*L6-", "*L7-", "*L8-"], 116, 0,
        |r, n, v| minus(&mut r.inputs.at_limit, n, v == 0)),
    g(&["MIT1+", "MIT2+", "MIT3+", "MIT4+", "MIT5+", "MIT6+", "MIT7+", "MIT8+"], 132, 0,
        |r, n, v| plus(&mut r.inputs.no_motion, n, v != 0)),
    g(&["MIT1-", "MIT2-", "MIT3-", "MIT4-", "MIT5-", "MIT6-", "MIT7-", "MIT8-"], 134, 0,
        |r, n, v| minus(&mut r.inputs.no_motion, n, v != 0)),
    g(&["*DEC1", "*DEC2", "*DEC3", "*DEC4", "*DEC5", "*DEC6", "*DEC7", "*DEC8"], 196, 0,
        |r, n, v| set(&mut r.inputs.on_home_switch_by_ladder, n, v == 0)),
    value(&["TSP"], Area::G, 204, 2, Link::Reads(|r, _, v| r.inputs.tool_in_spindle = (v & 0xFFFF).checked_sub(1))),
    // The NC to the ladder.
    f(&["RWD"], 0, 0, |o, _| o.rewinding.into()),
    f(&["SPL"], 0, 4, |o, _| o.held.into()),
    f(&["STL"], 0, 5, |o, _| o.running.into()),
    f(&["SA"], 0, 6, |o, _| o.servo_ready.into()),
    f(&["OP"], 0, 7, |o, _| o.automatic.into()),
    f(&["AL"], 1, 0, |o, _| o.alarm.into()),
    f(&["RESET"], 1, 1, |o, _| o.reset.into()),
    f(&["DEN"], 1, 3, |o, _| o.distribution_end.into()),
    f(&["ENB"], 1, 4, |o, _| o.spindle_enabled.into()),
    f(&["TAP"], 1, 5, |o, _| o.tapping.into()),
    f(&["MA"], 1, 7, |o, _| o.ready.into()),
    f(&["RPDO"], 2, 1, |o, _| o.rapid.into()),
    f(&["CSS"], 2, 2, |o, _| o.surface_speed.into()),
    f(&["THRD"], 2, 3, |o, _| o.threading.into()),
    f(&["SRNMV"], 2, 4, |o, _| o.restarting.into()),
    f(&["CUT"], 2, 6, |o, _| o.cutting.into()),
    f(&["MDRN"], 2, 7, |o, _| o.dry_run.into()),
    f(&["MINC"], 3, 0, |o, _| (o.mode == Mode::Step).into()),
    f(&["MH"], 3, 1, |o, _| (o.mode == Mode::Handle).into()),
    f(&["MJ"], 3, 2, |o, _| (o.mode == Mode::Jog).into()),
    f(&["MMDI"], 3, 3, |o, _| (o.mode == Mode::Mdi).into()),
    f(&["MRMT"], 3, 4, |o, _| (o.mode == Mode::Dnc).into()),
    f(&["MMEM"], 3, 5, |o, _| (o.mode == Mode::Auto).into()),
    f(&["MEDT"], 3, 6, |o, _| (o.mode == Mode::Edit).into()),
    f(&["MBDT"], 4, 0, |o, _| o.block_skip.into()),
    f(&["MMLK"], 4, 1, |o, _| o.machine_lock.into()),
    f(&["MSBK"], 4, 3, |o, _| o.single_block.into()),
    f(&["MAFL"], 4, 4, |o, _| o.auxiliary_lock.into()),
    f(&["MREF"], 4, 5, |o, _| (o.mode == Mode::Home).into()),
    f(&["MF"], 7, 0, |o, _| o.m.strobe.into()),
    f(&["SF"], 7, 2, |o, _| o.s.strobe.into()),
    f(&["TF"], 7, 3, |o, _| o.t.strobe.into()),
    f(&["BF"], 7, 7, |o, _| o.b.strobe.into()),
    f(&["DM30"], 9, 4, |o, _| o.m30.into()),
    f(&["DM02"], 9, 5, |o, _| o.m02.into()),
    f(&["DM01"], 9, 6, |o, _| o.m01.into()),
    f(&["DM00"], 9, 7, |o, _| o.m00.into()),
    value(&["M_CODE"], Area::F, 10, 4, Link::Tells(|o, _| o.m.code)),
    value(&["S_CODE"], Area::F, 22, 4, Link::Tells(|o, _| o.s.code)),
    value(&["T_CODE"], Area::F, 26, 4, Link::Tells(|o, _| o.t.code)),
    value(&["B_CODE"], Area::F, 30, 4, Link::Tells(|o, _| o.b.code)),
    f(&["GR1O", "GR2O", "GR3O"], 34, 0, |o, n| (usize::from(o.gear) == n + 1).into()),
    value(&["AR"], Area::F, 40, 2, Link::Tells(|o, _| o.spindle_rpm.into())),
    f(&["ALMA"], 45, 0, |o, _| o.spindle_alarm.into()),
    f(&["SSTA"], 45, 1, |o, _| o.spindle_zero.into()),
    f(&["SARA"], 45, 3, |o, _| o.spindle_at_speed.into()),
    f(&["ORARA"], 45, 7, |o, _| o.spindle_oriented.into()),
    value(&["UO"], Area::F, 54, 2, Link::Tells(|o, _| o.macro_outputs.into())),
    f(&["PRTSF"], 62, 7, |o, _| o.parts_reached.into()),
    f(&["RTAP"], 76, 3, |o, _| o.rigid_tapping.into()),
    f(&["ZP_X", "ZP_Y", "ZP_Z", "ZP_A", "ZP_5", "ZP_6", "ZP_7", "ZP_8"], 94, 0, |o, n| of(&o.at_reference, n)),
    f(&["ZP2_X", "ZP2_Y", "ZP2_Z", "ZP2_A", "ZP2_5", "ZP2_6", "ZP2_7", "ZP2_8"], 96, 0,
        |o, n| of(&o.at_further_reference[0], n)),
    f(&["ZP3_X", "ZP3_Y", "ZP3_Z", "ZP3_A", "ZP3_5", "ZP3_6", "ZP3_7", "ZP3_8"], 98, 0,
        |o, n| of(&o.at_further_reference[1], n)),
    f(&["ZP4_X", "ZP4_Y", "ZP4_Z", "ZP4_A", "ZP4_5", "ZP4_6", "ZP4_7", "ZP4_8"], 100, 0,
        |o, n| of(&o.at_further_reference[2], n)),
    f(&["MV_X", "MV_Y", "MV_Z", "MV_A", "MV_5", "MV_6", "MV_7", "MV_8"], 102, 0, |o, n| of(&o.moving, n)),
    f(&["INP_X", "INP_Y", "INP_Z", "INP_A", "INP_5", "INP_6", "INP_7", "INP_8"], 104, 0, |o, n| of(&o.in_position, n)),
    f(&["MVD_X", "MVD_Y", "MVD_Z", "MVD_A", "MVD_5", "MVD_6", "MVD_7", "MVD_8"], 106, 0, |o, n| of(&o.downwards, n)),
    f(&["ZRF_X", "ZRF_Y", "ZRF_Z", "ZRF_A", "ZRF_5", "ZRF_6", "ZRF_7", "ZRF_8"], 120, 0, |o, n| of(&o.referenced, n)),
];

#[cfg(test)]
mod tests {
    use super::*;

    /// Every bit of a signal.
    fn bits(signal: &Signal) -> Vec<Address> {
        match signal.bytes {
            0 => vec![signal.address],
            bytes => (0..u16::from(bytes))
                .flat_map(|n| (0..8).map(move |bit| (n, bit)))
                .map(|(n, bit)| Address { byte: signal.address.byte + n, bit: Some(bit), ..signal.address })
                .collect(),
        }
    }

    #[test]
    fn no_two_signals_share_a_place_or_a_name() {
        let (mut places, mut names) = (Vec::new(), Vec::new());
        for signal in signals() {
            assert!(!names.contains(&signal.name), "{}", signal.name);
            names.push(signal.name);
            for address in bits(&signal) {
                assert!(address.holds(1) && !places.contains(&address), "{} at {address:?}", signal.name);
                places.push(address);
            }
            let area = signal.address.area;
            assert!(if signal.is_read { area != Area::F } else { area == Area::F }, "{}", signal.name);
        }
        assert!(names.len() > 200 && signal("FIN").is_some_and(|s| s.is_read) && signal("NOPE").is_none());
    }

    #[test]
    fn every_bit_that_is_read_says_something() {
        // Over a memory of zeros, of ones, or of modes that others may change.
        let filled = |byte: u8| {
            let mut memory = Memory::new();
            signals().for_each(|signal| bits(&signal).iter().for_each(|a| memory.set_byte(*a, byte)));
            memory
        };
        let mut grounds = vec![filled(0), filled(0xFF)];
        for mode in 0..8 {
            let mut memory = filled(0);
            memory.set_byte(Address::parse("G43").unwrap(), mode);
            grounds.push(memory);
        }
        for signal in signals().filter(|signal| signal.is_read) {
            for address in bits(&signal) {
                let speaks = grounds.iter().any(|ground| {
                    let mut memory = ground.clone();
                    memory.set_bit(address, !memory.bit(address));
                    Inputs::read(&memory) != Inputs::read(ground)
                });
                assert!(speaks, "{} at {address:?} is not read", signal.name);
            }
        }
    }

    #[test]
    fn a_ladder_that_stands_still_lets_nothing_move() {
        let inputs = Inputs::read(&Memory::new());
        assert!(inputs.emergency_stop && inputs.feed_hold && inputs.spindle_emergency_stop);
        assert!(!inputs.axes_may_move && !inputs.spindle_may_turn && !inputs.cycle_start);
        assert_eq!([inputs.feed_override, inputs.manual_override, inputs.spindle_override], [0.0; 3]);
        assert!(inputs.at_limit.iter().all(|ways| ways.plus && ways.minus));
        assert!(inputs.jog.iter().all(|ways| ways.sign() == 0));
    }

    #[test]
    fn modes_are_those_of_their_codes() {
        let mode = |bits: u8| {
            let mut memory = Memory::new();
            memory.set_byte(Address::parse("G43").unwrap(), bits);
            Inputs::read(&memory).mode
        };
        // ZRN 7, STEPI 6, DNCI 5, MD4 2, MD2 1, MD1 0.
        for (bits, wanted) in [
            (0b0000_0000, Mode::Mdi),
            (0b0000_0001, Mode::Auto),
            (0b0010_0001, Mode::Dnc),
            (0b0000_0011, Mode::Edit),
            (0b0000_0100, Mode::Handle),
            (0b0100_0100, Mode::Step),
            (0b0000_0101, Mode::Jog),
            (0b1000_0101, Mode::Home),
            (0b0000_0010, Mode::Edit),
        ] {
            assert_eq!(mode(bits), wanted, "{bits:08b}");
        }
    }

    #[test]
    fn values_have_their_units() {
        let mut memory = Memory::new();
        let at = |text: &str| Address::parse(text).unwrap();
        memory.set_byte(at("G12"), !120);
        memory.write(at("G10").place(), Width::Two, !15_000);
        memory.set_byte(at("G30"), 80);
        memory.set_byte(at("G14"), 0b10);
        memory.set_byte(at("G18"), 0b011);
        memory.set_byte(at("G19"), 0b0011_0000);
        memory.set_byte(at("G28"), 0b100);
        memory.write(at("G54").place(), Width::Two, 0x8001);
        let inputs = Inputs::read(&memory);
        let near = |a: f64, b: f64| (a - b).abs() < 1e-12;
        assert!(near(inputs.feed_override, 1.2) && near(inputs.manual_override, 1.5));
        assert!(near(inputs.spindle_override, 0.8) && near(inputs.increment_of(0.001), 1.0));
        assert_eq!((inputs.rapid_override, inputs.handwheel_axis), (RapidOverride::Quarter, Some(2)));
        assert_eq!((inputs.gear, inputs.macro_inputs), (3, 0x8001));
        // All bits on are 0, too.
        memory.set_byte(at("G12"), 0xFF);
        assert!(near(Inputs::read(&memory).feed_override, 0.0));
    }

    /// What of F is on for some outputs, by name.
    fn told(outputs: &Outputs) -> Vec<&'static str> {
        let mut memory = Memory::new();
        outputs.write(&mut memory);
        let is_on = |signal: &Signal| bits(signal).iter().any(|address| memory.bit(*address));
        signals().filter(|signal| !signal.is_read && is_on(signal)).map(|signal| signal.name).collect()
    }

    #[test]
    fn each_output_is_told_by_its_signal() {
        let base = || Outputs { mode: Mode::Edit, ..Outputs::default() };
        assert_eq!(told(&base()), ["MEDT"]);
        let code = Code { strobe: true, code: 7 };
        let table: Vec<(Outputs, Vec<&str>)> = vec![
            (Outputs { rewinding: true, ..base() }, vec!["RWD"]),
            (Outputs { held: true, ..base() }, vec!["SPL"]),
            (Outputs { running: true, ..base() }, vec!["STL"]),
            (Outputs { servo_ready: true, ..base() }, vec!["SA"]),
            (Outputs { automatic: true, ..base() }, vec!["OP"]),
            (Outputs { alarm: true, ..base() }, vec!["AL"]),
            (Outputs { reset: true, ..base() }, vec!["RESET"]),
            (Outputs { distribution_end: true, ..base() }, vec!["DEN"]),
            (Outputs { spindle_enabled: true, ..base() }, vec!["ENB"]),
            (Outputs { tapping: true, ..base() }, vec!["TAP"]),
            (Outputs { ready: true, ..base() }, vec!["MA"]),
            (Outputs { rapid: true, ..base() }, vec!["RPDO"]),
            (Outputs { surface_speed: true, ..base() }, vec!["CSS"]),
            (Outputs { threading: true, ..base() }, vec!["THRD"]),
            (Outputs { restarting: true, ..base() }, vec!["SRNMV"]),
            (Outputs { cutting: true, ..base() }, vec!["CUT"]),
            (Outputs { dry_run: true, ..base() }, vec!["MDRN"]),
            (Outputs { block_skip: true, ..base() }, vec!["MBDT"]),
            (Outputs { machine_lock: true, ..base() }, vec!["MMLK"]),
            (Outputs { single_block: true, ..base() }, vec!["MSBK"]),
            (Outputs { auxiliary_lock: true, ..base() }, vec!["MAFL"]),
            (Outputs { m: code, ..base() }, vec!["MF", "M_CODE"]),
            (Outputs { s: code, ..base() }, vec!["SF", "S_CODE"]),
            (Outputs { t: code, ..base() }, vec!["TF", "T_CODE"]),
            (Outputs { b: code, ..base() }, vec!["BF", "B_CODE"]),
            (Outputs { m00: true, ..base() }, vec!["DM00"]),
            (Outputs { m01: true, ..base() }, vec!["DM01"]),
            (Outputs { m02: true, ..base() }, vec!["DM02"]),
            (Outputs { m30: true, ..base() }, vec!["DM30"]),
            (Outputs { gear: 1, ..base() }, vec!["GR1O"]),
            (Outputs { gear: 3, ..base() }, vec!["GR3O"]),
            (Outputs { spindle_rpm: 1, ..base() }, vec!["AR"]),
            (Outputs { spindle_alarm: true, ..base() }, vec!["ALMA"]),
            (Outputs { spindle_zero: true, ..base() }, vec!["SSTA"]),
            (Outputs { spindle_at_speed: true, ..base() }, vec!["SARA"]),
            (Outputs { spindle_oriented: true, ..base() }, vec!["ORARA"]),
            (Outputs { macro_outputs: 2, ..base() }, vec!["UO"]),
            (Outputs { parts_reached: true, ..base() }, vec!["PRTSF"]),
            (Outputs { rigid_tapping: true, ..base() }, vec!["RTAP"]),
        ];
        for (outputs, wanted) in table {
            let mut found = told(&outputs);
            found.retain(|name| *name != "MEDT");
            assert_eq!(found, wanted);
        }
        let second = [false, true, false, false, false, false, false, false];
        let axes = Outputs {
            at_reference: second,
            at_further_reference: [second, [false; SIGNAL_AXES], second],
            referenced: second,
            moving: second,
            downwards: second,
            in_position: second,
            ..base()
        };
        assert_eq!(told(&axes)[1..], ["ZP_Y", "ZP2_Y", "ZP4_Y", "MV_Y", "INP_Y", "MVD_Y", "ZRF_Y"]);
        for (mode, name) in
            Mode::ALL.into_iter().zip(["MEDT", "MMEM", "MMDI", "MREF", "MJ", "MINC", "MH", "MRMT"])
        {
            assert_eq!(told(&Outputs { mode, ..base() }), [name]);
        }
    }
}
