//! The frames of the pulse protocol: what the control says to the board, what it hears, and how both stand in bytes
//! (`docs/pulse-protocol.md`).
//!
//! A frame is its kind, its fields, and a CRC-32 of both; numbers have their low byte first. In the stream of bytes it
//! is written without zeros (COBS), and a zero ends it, so that a reader who lost his place finds it at the next one.

use ferrocut_machine::drives::{PULSE_AXES, PULSE_BYTES};

/// The version of the protocol that is spoken.
pub const VERSION: u8 = 1;

/// Parts of a step in which positions are told.
pub const PARTS: f64 = 256.0;

/// Longest frame with its CRC: so short that COBS adds one byte.
pub const LONGEST: usize = 250;

/// Longest frame in the stream.
pub const LONGEST_CODED: usize = LONGEST + 2;

const HELLO: u8 = 0x01;
const SETUP: u8 = 0x02;
const MOVE: u8 = 0x03;
const STOP: u8 = 0x04;
const WELCOME: u8 = 0x81;
const READY: u8 = 0x82;
const STATE: u8 = 0x83;

/// What an axis of the board is told at the start.
#[derive(Clone, Copy, PartialEq, Eq, Debug, Default)]
pub struct AxisSetup {
    /// Times of its signals, ns: pulse, space, set-up of the direction, its hold.
    pub times: [u32; 4],
    /// Highest rate that will be asked for, steps/s.
    pub rate: u32,
    /// Rate of change with which it is brought to rest when something is wrong, steps/s².
    pub stop: u32,
    /// The direction signal is the other way round.
    pub reversed: bool,
}

/// What the board is told at the start.
#[derive(Clone, Copy, PartialEq, Eq, Debug, Default)]
pub struct Setup {
    /// Number of the conversation.
    pub session: u16,
    /// Servo period, ns.
    pub period_ns: u32,
    /// Setpoints that wait before the first is run.
    pub buffer: u16,
    /// Time without a frame after which the board stops, ms.
    pub watchdog_ms: u16,
    /// How many axes there are.
    pub axes: usize,
    /// What they are like.
    pub of: [AxisSetup; PULSE_AXES],
}

/// A setpoint, with everything else of a period.
#[derive(Clone, Copy, PartialEq, Eq, Debug, Default)]
pub struct Setpoint {
    /// Number of the conversation.
    pub session: u16,
    /// Number of the setpoint, from 0.
    pub number: u32,
    /// The amplifiers are on.
    pub enable: bool,
    /// Speed of the spindle in parts of 32767 of its highest; clockwise positive.
    pub spindle: i16,
    /// The touch of the probe that is waited for; 0 is none.
    pub probe: u8,
    /// It is that the probe's input carries no current.
    pub until_open: bool,
    /// General outputs.
    pub outputs: [u8; PULSE_BYTES],
    /// How many axes there are.
    pub axes: usize,
    /// Where they shall be at the end of the period, in parts of a step.
    pub positions: [i32; PULSE_AXES],
    /// The markers that are waited for; 0 is none.
    pub markers: [u8; PULSE_AXES],
}

/// What the board is able to do.
#[derive(Clone, Copy, PartialEq, Eq, Debug, Default)]
pub struct Welcome {
    /// The version that it speaks.
    pub version: u8,
    /// Number of the conversation.
    pub session: u16,
    /// Axes that it has.
    pub axes: u8,
    /// Bytes of general inputs and outputs.
    pub inputs: u8,
    /// The same of outputs.
    pub outputs: u8,
    /// Longest buffer.
    pub buffer: u16,
    /// Shortest and longest servo period, ns.
    pub period_ns: [u32; 2],
    /// Highest rate of an axis, steps/s.
    pub rate: u32,
}

/// Where the axes are at the start.
#[derive(Clone, Copy, PartialEq, Eq, Debug, Default)]
pub struct Ready {
    /// Number of the conversation.
    pub session: u16,
    /// What cannot be; 0 is nothing.
    pub refused: u8,
    /// Where the axes are, in parts of a step.
    pub positions: [i32; PULSE_AXES],
}

/// What an axis says of itself.
#[derive(Clone, Copy, PartialEq, Eq, Debug, Default)]
pub struct AxisState {
    /// Where it is; where its home switch changed last; where it passed the marker; where it was when the probe
    /// touched. In parts of a step.
    pub position: i32,
    /// See above.
    pub edge: i32,
    /// See above.
    pub marker: i32,
    /// See above.
    pub touch: i32,
    /// Which marker that was.
    pub passed: u8,
    /// Its switches ([`HOME_CLOSED`] and the others).
    pub switches: u8,
}

/// The input of the probe carries current.
const PROBE_CLOSED: u8 = 1;
/// The circuit of the emergency stop does.
const EMERGENCY_CLOSED: u8 = 2;

/// The home switch is closed.
pub const HOME_CLOSED: u8 = 1;
/// The upper travel switch is closed.
pub const UPPER_CLOSED: u8 = 2;
/// The lower travel switch is closed.
pub const LOWER_CLOSED: u8 = 4;
/// The home switch has changed since the start.
pub const EDGE_SEEN: u8 = 8;

/// How the board stands.
#[derive(Clone, Copy, PartialEq, Eq, Debug, Default)]
pub struct State {
    /// Number of the conversation.
    pub session: u16,
    /// Setpoints that were run, and those that wait.
    pub run: u32,
    /// See above.
    pub waiting: u16,
    /// What it does.
    pub doing: u8,
    /// Why it stopped; 0 is nothing.
    pub fault: u8,
    /// The axis that it is about, or 255.
    pub axis: u8,
    /// Frames that could not be read.
    pub unreadable: u16,
    /// The input of the probe carries current.
    pub probe_closed: bool,
    /// The circuit of the emergency stop carries current: the button is out.
    pub emergency_closed: bool,
    /// Which touch was met; 0 is none.
    pub touched: u8,
    /// General inputs.
    pub inputs: [u8; PULSE_BYTES],
    /// The axes.
    pub axes: [AxisState; PULSE_AXES],
}

/// Something heard from the board.
#[derive(Clone, Copy, PartialEq, Eq, Debug)]
pub enum Heard {
    /// It is there.
    Welcome(Welcome),
    /// It is set up.
    Ready(Ready),
    /// How it stands.
    State(State),
}

/// A frame in the making.
pub struct Frame {
    bytes: [u8; LONGEST],
    length: usize,
}

impl Frame {
    fn new(kind: u8) -> Frame {
        let mut frame = Frame { bytes: [0; LONGEST], length: 0 };
        frame.put(&[kind]);
        frame
    }

    /// Puts bytes behind the others. All frames are shorter than the room for them, which a test holds.
    fn put(&mut self, bytes: &[u8]) {
        for byte in bytes {
            if let Some(place) = self.bytes.get_mut(self.length) {
                *place = *byte;
                self.length += 1;
            }
        }
    }

    /// Looks for a board.
    pub fn hello(session: u16) -> Frame {
        let mut frame = Frame::new(HELLO);
        frame.put(&[VERSION]);
        frame.put(&session.to_le_bytes());
        frame
    }

    /// Sets it up.
    pub fn setup(setup: &Setup) -> Frame {
        let mut frame = Frame::new(SETUP);
        frame.put(&setup.session.to_le_bytes());
        frame.put(&setup.period_ns.to_le_bytes());
        frame.put(&setup.buffer.to_le_bytes());
        frame.put(&setup.watchdog_ms.to_le_bytes());
        frame.put(&[setup.axes as u8]);
        for axis in setup.of.iter().take(setup.axes) {
            axis.times.iter().for_each(|time| frame.put(&time.to_le_bytes()));
            frame.put(&axis.rate.to_le_bytes());
            frame.put(&axis.stop.to_le_bytes());
            frame.put(&[u8::from(axis.reversed)]);
        }
        frame
    }

    /// A setpoint.
    pub fn setpoint(setpoint: &Setpoint) -> Frame {
        let mut frame = Frame::new(MOVE);
        frame.put(&setpoint.session.to_le_bytes());
        frame.put(&setpoint.number.to_le_bytes());
        frame.put(&[u8::from(setpoint.enable) | u8::from(setpoint.until_open) << 1]);
        frame.put(&setpoint.spindle.to_le_bytes());
        frame.put(&[setpoint.probe]);
        frame.put(&setpoint.outputs);
        for (position, marker) in setpoint.positions.iter().zip(setpoint.markers).take(setpoint.axes) {
            frame.put(&position.to_le_bytes());
            frame.put(&[marker]);
        }
        frame
    }

    /// Bring the axes to rest.
    pub fn stop(session: u16) -> Frame {
        let mut frame = Frame::new(STOP);
        frame.put(&session.to_le_bytes());
        frame
    }

    /// Writes it as it goes into the stream, CRC, COBS and the zero at its end, and gives what was written.
    pub fn coded(mut self, into: &mut [u8; LONGEST_CODED]) -> &[u8] {
        let crc = crc32(self.bytes.get(..self.length).unwrap_or(&[]));
        self.put(&crc.to_le_bytes());
        // Each zero becomes the way to the next one; the first byte is the way to the first.
        let mut zero = 0;
        let mut at = 1;
        let set = |into: &mut [u8; LONGEST_CODED], place: usize, value: u8| {
            if let Some(byte) = into.get_mut(place) {
                *byte = value;
            }
        };
        for byte in self.bytes.iter().take(self.length) {
            if *byte == 0 {
                set(into, zero, (at - zero) as u8);
                zero = at;
            } else {
                set(into, at, *byte);
            }
            at += 1;
        }
        set(into, zero, (at - zero) as u8);
        set(into, at, 0);
        into.get(..=at).unwrap_or(&[])
    }
}

/// Finds frames in a stream of bytes.
pub struct Reader {
    coded: [u8; LONGEST_CODED],
    length: usize,
    /// What is read is too long: nothing of it counts up to the next zero.
    skips: bool,
}

impl Reader {
    /// A reader at the start of a stream.
    pub fn new() -> Reader {
        Reader { coded: [0; LONGEST_CODED], length: 0, skips: false }
    }

    /// Takes a byte; the frame that it ends. What cannot be read is left out.
    pub fn take(&mut self, byte: u8) -> Option<Heard> {
        if byte != 0 {
            match self.coded.get_mut(self.length) {
                Some(place) => {
                    *place = byte;
                    self.length += 1;
                }
                None => self.skips = true,
            }
            return None;
        }
        let (length, skips) = (self.length, self.skips);
        (self.length, self.skips) = (0, false);
        if skips {
            return None;
        }
        let mut bytes = [0; LONGEST];
        let length = uncoded(self.coded.get(..length)?, &mut bytes)?;
        let (content, crc) = bytes.get(..length)?.split_last_chunk::<4>()?;
        if crc32(content).to_le_bytes() != *crc {
            return None;
        }
        heard(content)
    }
}

/// Undoes COBS; the length. `None` for what is none.
fn uncoded(coded: &[u8], into: &mut [u8; LONGEST]) -> Option<usize> {
    let (first, rest) = coded.split_first()?;
    let mut left = *first;
    let mut length = 0;
    for byte in rest {
        left -= 1;
        let put = if left == 0 {
            left = *byte;
            0
        } else {
            *byte
        };
        *into.get_mut(length)? = put;
        length += 1;
    }
    (left == 1).then_some(length)
}

/// Fields of a frame, one after the other.
struct Fields<'a>(&'a [u8]);

impl Fields<'_> {
    fn bytes<const N: usize>(&mut self) -> Option<[u8; N]> {
        let (field, rest) = self.0.split_first_chunk()?;
        self.0 = rest;
        Some(*field)
    }

    fn u8(&mut self) -> Option<u8> {
        self.bytes().map(|[byte]| byte)
    }

    fn u16(&mut self) -> Option<u16> {
        self.bytes().map(u16::from_le_bytes)
    }

    fn u32(&mut self) -> Option<u32> {
        self.bytes().map(u32::from_le_bytes)
    }

    fn i32(&mut self) -> Option<i32> {
        self.bytes().map(i32::from_le_bytes)
    }
}

/// The frame of these bytes. Fields that a later version puts behind those of this one are left out.
fn heard(content: &[u8]) -> Option<Heard> {
    let mut from = Fields(content);
    match from.u8()? {
        WELCOME => Some(Heard::Welcome(Welcome {
            version: from.u8()?,
            session: from.u16()?,
            axes: from.u8()?,
            inputs: from.u8()?,
            outputs: from.u8()?,
            buffer: from.u16()?,
            period_ns: [from.u32()?, from.u32()?],
            rate: from.u32()?,
        })),
        READY => {
            let (session, refused, axes) = (from.u16()?, from.u8()?, from.u8()?);
            let mut positions = [0; PULSE_AXES];
            for position in positions.iter_mut().take(usize::from(axes)) {
                *position = from.i32()?;
            }
            Some(Heard::Ready(Ready { session, refused, positions }))
        }
        STATE => {
            let (session, run, waiting) = (from.u16()?, from.u32()?, from.u16()?);
            let (doing, fault, axis, unreadable) = (from.u8()?, from.u8()?, from.u8()?, from.u16()?);
            let closed = from.u8()?;
            let mut state = State {
                session,
                run,
                waiting,
                doing,
                fault,
                axis,
                unreadable,
                probe_closed: closed & PROBE_CLOSED != 0,
                emergency_closed: closed & EMERGENCY_CLOSED != 0,
                touched: from.u8()?,
                inputs: from.bytes()?,
                axes: [AxisState::default(); PULSE_AXES],
            };
            let axes = from.u8()?;
            for axis in state.axes.iter_mut().take(usize::from(axes)) {
                *axis = AxisState {
                    position: from.i32()?,
                    edge: from.i32()?,
                    marker: from.i32()?,
                    touch: from.i32()?,
                    passed: from.u8()?,
                    switches: from.u8()?,
                };
            }
            Some(Heard::State(state))
        }
        _ => None,
    }
}

/// The CRC-32 of Ethernet and zip: 0x04C11DB7 reflected, from all ones, inverted.
fn crc32(bytes: &[u8]) -> u32 {
    !bytes.iter().fold(u32::MAX, |crc, byte| {
        let at = usize::from(crc as u8 ^ byte);
        (crc >> 8) ^ CRC_TABLE.get(at).copied().unwrap_or(0)
    })
}

const CRC_TABLE: [u32; 256] = {
    let mut table = [0; 256];
    let mut n = 0;
    while n < 256 {
        let mut crc = n as u32;
        let mut bit = 0;
        while bit < 8 {
            crc = if crc & 1 == 1 { (crc >> 1) ^ 0xEDB8_8320 } else { crc >> 1 };
            bit += 1;
        }
        table[n] = crc;
        n += 1;
    }
    table
};

#[cfg(test)]
mod tests {
    use super::*;
    use proptest::prelude::*;

    /// Content that a board would send, coded as the control codes its own.
    fn coded(content: &[u8]) -> Vec<u8> {
        let mut frame = Frame { bytes: [0; LONGEST], length: 0 };
        frame.put(content);
        frame.coded(&mut [0; LONGEST_CODED]).to_vec()
    }

    #[test]
    fn bytes_are_those_of_the_document() {
        // The CRC's own check value.
        assert_eq!(crc32(b"123456789"), 0xCBF4_3926);
        // docs/pulse-protocol.md has this example.
        let mut into = [0; LONGEST_CODED];
        let hello = Frame::hello(0x0102).coded(&mut into).to_vec();
        assert_eq!(hello, [0x09, 0x01, 0x01, 0x02, 0x01, 0x5A, 0x80, 0x0B, 0xDD, 0x00]);
        // Zeros: 11 00 00 22 -> 02 11 01 02 22 and the CRC behind.
        assert_eq!(coded(&[0x11, 0, 0, 0x22])[..4], [0x02, 0x11, 0x01, 0x06]);
    }

    #[test]
    fn the_longest_frames_have_room() {
        let setup = Setup { axes: PULSE_AXES, ..Setup::default() };
        assert_eq!(Frame::setup(&setup).length, 237);
        let setpoint = Setpoint { axes: PULSE_AXES, ..Setpoint::default() };
        assert_eq!(Frame::setpoint(&setpoint).length, 64);
    }

    #[test]
    fn a_reader_finds_its_place_again() {
        let welcome = [WELCOME, 1, 2, 0, 4, 1, 1, 16, 0, 0, 0, 0, 0, 1, 0, 0, 0, 2, 0, 0, 0];
        let mut reader = Reader::new();
        let mut count = 0;
        let good = coded(&welcome);
        let mut bad = good.clone();
        bad[7] ^= 4;
        for stream in [&good[5..], &good, &bad, &[7; 600], &[0, 0, 0], &good] {
            for byte in stream {
                count += u32::from(matches!(reader.take(*byte), Some(Heard::Welcome(w)) if w.buffer == 16));
            }
        }
        // The half, the wrong one and the one without end do not count.
        assert_eq!(count, 2);
    }

    proptest! {
        #[test]
        fn whatever_comes_is_read_or_left_out(bytes in prop::collection::vec(any::<u8>(), 0..2000)) {
            let mut reader = Reader::new();
            for byte in bytes {
                reader.take(byte);
            }
        }

        #[test]
        fn frames_come_back_as_they_went(content in prop::collection::vec(0u8..4, 1..240)) {
            let coded = coded(&content);
            prop_assert_eq!(coded.iter().filter(|byte| **byte == 0).count(), 1);
            let mut into = [0; LONGEST];
            let length = uncoded(&coded[..coded.len() - 1], &mut into).unwrap();
            prop_assert_eq!(&into[..length - 4], &content[..]);
            prop_assert_eq!(&into[length - 4..length], &crc32(&content).to_le_bytes());
        }

        #[test]
        fn a_frame_with_content_of_chance_is_no_danger(content in prop::collection::vec(any::<u8>(), 0..240), kind in 0x81u8..0x84) {
            let mut all = vec![kind];
            all.extend(content);
            let mut reader = Reader::new();
            for byte in coded(&all) {
                reader.take(byte);
            }
        }
    }
}
