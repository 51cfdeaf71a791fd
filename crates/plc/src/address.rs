//! Signal addresses: `X0008.4`, `R120`, `D0010`.
//!
//! Every byte of every area has a place in one flat memory of 64 KiB, so that a place is a `u16` and
//! looking it up cannot fail. Areas and their sizes are those of the Fanuc 0i PMC-SB7; the GSK990MC names
//! X Y F G R K T C D A and leaves the sizes to its manual of the PLC.

use std::fmt;

/// What a signal belongs to.
#[derive(Clone, Copy, PartialEq, Eq, Hash, Debug)]
pub enum Area {
    /// Machine to PLC.
    X,
    /// PLC to machine.
    Y,
    /// NC to PLC.
    F,
    /// PLC to NC.
    G,
    /// Internal relays; R9000 on belongs to the system.
    R,
    /// Keep relays.
    K,
    /// Times of variable timers, a word each.
    T,
    /// Counters, a word of preset and a word of count each.
    C,
    /// Data table.
    D,
    /// Requests for messages.
    A,
}

/// A run of bytes of an area.
#[derive(Clone, Copy)]
pub struct Room {
    /// The area.
    pub area: Area,
    /// Number of its first byte.
    pub first: u16,
    /// Bytes.
    pub len: u16,
    /// Place of its first byte in the flat memory.
    pub place: u16,
    /// Whether it keeps its value while power is off.
    pub is_kept: bool,
}

const fn room(area: Area, first: u16, len: u16, place: u16, is_kept: bool) -> Room {
    Room { area, first, len, place, is_kept }
}

/// Every byte there is. Behind each room a few bytes belong to none, so that two bytes at its last one reach
/// no other.
pub const ROOMS: &[Room] = &[
    room(Area::X, 0, 128, 0x0000, false),
    room(Area::Y, 0, 128, 0x0100, false),
    room(Area::A, 0, 250, 0x0200, false),
    room(Area::K, 0, 100, 0x0300, true),
    room(Area::F, 0, 768, 0x0400, false),
    room(Area::G, 0, 768, 0x0800, false),
    room(Area::R, 9000, 118, SYSTEM, false),
    room(Area::T, 0, 500, TIMES, true),
    room(Area::C, 0, 400, COUNTERS, true),
    room(Area::R, 0, 8000, 0x1800, false),
    room(Area::D, 0, 10000, 0x4000, true),
];

/// R9000: flags of operations, rest of divisions, system timers.
pub const SYSTEM: u16 = 0x0C00;
/// T0.
pub const TIMES: u16 = 0x1000;
/// C0.
pub const COUNTERS: u16 = 0x1400;
/// The inputs as level 2 sees them, copied when it begins: X from here on, F behind.
pub const IMAGE_X: u16 = 0x8000;
/// F of the image.
pub const IMAGE_F: u16 = 0x8400;
/// A byte that is always 0.
pub const ZERO: u16 = 0xFFF0;
/// Results of a network that wait on its stack, a byte each from here on.
pub const WAITING: u16 = 0xFFE0;

/// Why a text is no address.
#[derive(Clone, Copy, PartialEq, Eq, Debug)]
pub enum AddressError {
    /// It is not written as one.
    Form,
    /// There is no such byte.
    Range,
}

/// A byte, or a bit of one.
#[derive(Clone, Copy, PartialEq, Eq, Hash, Debug)]
pub struct Address {
    /// The area.
    pub area: Area,
    /// Number of the byte in the area.
    pub byte: u16,
    /// Bit 0 to 7; `None` means the byte.
    pub bit: Option<u8>,
}

impl Area {
    /// The area of a letter.
    pub fn from_letter(letter: char) -> Option<Area> {
        Some(match letter.to_ascii_uppercase() {
            'X' => Area::X,
            'Y' => Area::Y,
            'F' => Area::F,
            'G' => Area::G,
            'R' => Area::R,
            'K' => Area::K,
            'T' => Area::T,
            'C' => Area::C,
            'D' => Area::D,
            'A' => Area::A,
            _ => return None,
        })
    }

    /// Whether the ladder only reads it.
    pub fn is_input(self) -> bool {
        matches!(self, Area::X | Area::F)
    }
}

impl Address {
    /// Reads `X0008.4` or `R120`.
    pub fn parse(text: &str) -> Result<Address, AddressError> {
        let mut letters = text.chars();
        let area = letters.next().and_then(Area::from_letter).ok_or(AddressError::Form)?;
        let rest = letters.as_str();
        let (byte, bit) = match rest.split_once('.') {
            Some((byte, bit)) => (byte, Some(bit)),
            None => (rest, None),
        };
        if byte.is_empty() || byte.len() > 5 || !byte.bytes().all(|b| b.is_ascii_digit()) {
            return Err(AddressError::Form);
        }
        let bit = match bit.map(str::as_bytes) {
            None => None,
            Some([digit @ b'0'..=b'7']) => Some(digit - b'0'),
            Some(_) => return Err(AddressError::Form),
        };
        let byte = byte.parse().map_err(|_| AddressError::Range)?;
        let address = Address { area, byte, bit };
        address.holds(1).then_some(address).ok_or(AddressError::Range)
    }

    /// Whether `bytes` from here on are one run of the area.
    pub fn holds(self, bytes: u32) -> bool {
        self.room().is_some_and(|r| u32::from(self.byte - r.first) + bytes <= u32::from(r.len))
    }

    /// Whether it belongs to the system: R9000 on.
    pub fn is_system(self) -> bool {
        self.area == Area::R && self.byte >= 9000
    }

    /// Place of the byte in the flat memory; a byte that does not exist is the one that is always 0.
    pub fn place(self) -> u16 {
        self.room().map_or(ZERO, |r| r.place + (self.byte - r.first))
    }

    /// The place that level 2 reads it from.
    pub fn synchronised(self) -> u16 {
        match self.area {
            Area::X if self.holds(1) => IMAGE_X + self.byte,
            Area::F if self.holds(1) => IMAGE_F + self.byte,
            _ => self.place(),
        }
    }

    /// The place behind the last byte of its room.
    pub fn end(self) -> u16 {
        self.room().map_or(ZERO, |r| r.place + r.len)
    }

    fn room(self) -> Option<&'static Room> {
        ROOMS.iter().find(|r| {
            r.area == self.area && self.byte >= r.first && u32::from(self.byte - r.first) < u32::from(r.len)
        })
    }
}

/// `X0008.4`, as the control's pages write it.
impl fmt::Display for Address {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        write!(f, "{:?}{:04}", self.area, self.byte)?;
        self.bit.map_or(Ok(()), |bit| write!(f, ".{bit}"))
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn addresses_are_read_and_written() {
        for (text, shown) in [
            ("X0008.4", "X0008.4"),
            ("x8.4", "X0008.4"),
            ("R120", "R0120"),
            ("R9117.7", "R9117.7"),
            ("D9999", "D9999"),
            ("K99.0", "K0099.0"),
            ("F767.7", "F0767.7"),
        ] {
            assert_eq!(Address::parse(text).unwrap().to_string(), shown);
        }
    }

    #[test]
    fn what_is_no_address_is_refused() {
        for text in ["", "X", "X.1", "Q0.0", "X8.8", "X8.", "X8.12", "X-1", "X8,4", "8.4", "X000008.4"] {
            assert_eq!(Address::parse(text), Err(AddressError::Form), "{text}");
        }
        for text in ["X128.0", "Y128", "F768.0", "G768", "R8000", "R9118", "K100", "T500", "C400", "D10000"] {
            assert_eq!(Address::parse(text), Err(AddressError::Range), "{text}");
        }
        assert_eq!(Address::parse("A250.0"), Err(AddressError::Range));
        assert_eq!(Address::parse("X99999"), Err(AddressError::Range));
        assert!(Address::parse("D9998").unwrap().holds(2) && !Address::parse("D9999").unwrap().holds(2));
    }

    #[test]
    fn a_byte_that_does_not_exist_is_always_0() {
        for area in [Area::X, Area::F, Area::R, Area::D] {
            let none = Address { area, byte: u16::MAX, bit: None };
            assert_eq!(
                (none.place(), none.synchronised(), none.end(), none.holds(1)),
                (ZERO, ZERO, ZERO, false)
            );
        }
    }

    #[test]
    fn no_two_rooms_share_a_place() {
        let mut taken = vec![false; 1 << 16];
        let images = [room(Area::X, 0, 128, IMAGE_X, false), room(Area::F, 0, 768, IMAGE_F, false)];
        for r in ROOMS.iter().chain(&images) {
            for place in r.place..r.place + r.len {
                assert!(!std::mem::replace(&mut taken[usize::from(place)], true));
            }
        }
        assert!(!taken[usize::from(ZERO)]);
        assert!(taken[usize::from(WAITING)..usize::from(ZERO)].iter().all(|taken| !taken));
    }
}
