//! The signals: one flat memory of bytes, and which of its bits are forced.

use crate::address::{Address, Area, IMAGE_F, IMAGE_X, ROOMS, SYSTEM, ZERO};

/// Bytes that a `u16` can name.
pub const PLACES: usize = 1 << 16;

/// R9000: what the last operation in binary gave.
pub mod flags {
    /// It was zero, or both values were equal.
    pub const ZERO: u8 = 1 << 0;
    /// It was negative, or the first value was the smaller one.
    pub const SIGN: u8 = 1 << 1;
    /// It did not fit.
    pub const OVERFLOW: u8 = 1 << 5;
}

/// R9002: rest of a division in binary.
pub const REST: u16 = SYSTEM + 2;
/// R9015.0: the first scan after the ladder was started.
pub const STARTED: u16 = SYSTEM + 15;
/// R9091: system timers.
pub const CLOCKS: u16 = SYSTEM + 91;

/// How many bytes a value has.
#[derive(Clone, Copy, PartialEq, Eq, Debug)]
pub enum Width {
    /// One byte.
    One,
    /// A word.
    Two,
    /// A double word.
    Four,
}

impl Width {
    /// The width of 1, 2 or 4 bytes; any other number is one.
    pub fn of(bytes: u32) -> Width {
        match bytes {
            2 => Width::Two,
            4 => Width::Four,
            _ => Width::One,
        }
    }

    /// Bytes.
    pub fn bytes(self) -> u16 {
        match self {
            Width::One => 1,
            Width::Two => 2,
            Width::Four => 4,
        }
    }
}

/// All signals.
#[derive(Clone, Debug)]
pub struct Memory {
    /// The bytes. Public to the scan, which writes its bits without a call.
    pub(crate) bytes: Box<[u8; PLACES]>,
    /// For each byte the bits that are not forced.
    pub(crate) free: Box<[u8; PLACES]>,
}

impl Default for Memory {
    fn default() -> Memory {
        Memory::new()
    }
}

fn page(value: u8) -> Box<[u8; PLACES]> {
    // Made on the heap: 64 KiB do not belong on the stack of a thread.
    match vec![value; PLACES].into_boxed_slice().try_into() {
        Ok(page) => page,
        Err(_) => Box::new([value; PLACES]),
    }
}

impl Memory {
    /// All signals 0, none forced.
    pub fn new() -> Memory {
        let mut free = page(0xFF);
        free[usize::from(ZERO)] = 0;
        Memory { bytes: page(0), free }
    }

    /// The byte at a place.
    pub fn get(&self, at: u16) -> u8 {
        self.bytes[usize::from(at)]
    }

    /// Sets the byte at a place; forced bits stay.
    pub fn put(&mut self, at: u16, value: u8) {
        let at = usize::from(at);
        let old = self.bytes[at];
        self.bytes[at] = old ^ ((old ^ value) & self.free[at]);
    }

    /// A byte.
    pub fn byte(&self, address: Address) -> u8 {
        self.get(address.place())
    }

    /// Sets a byte; forced bits stay.
    pub fn set_byte(&mut self, address: Address, value: u8) {
        self.put(address.place(), value);
    }

    /// A bit; of a whole byte whether any is 1.
    pub fn bit(&self, address: Address) -> bool {
        self.byte(address) & mask(address) != 0
    }

    /// Sets a bit, or all of a byte; forced bits stay.
    pub fn set_bit(&mut self, address: Address, value: bool) {
        let mask = mask(address);
        let old = self.byte(address);
        self.set_byte(address, if value { old | mask } else { old & !mask });
    }

    /// A value in binary, with its sign; the byte of lowest address is the lowest.
    pub fn read(&self, at: u16, width: Width) -> i32 {
        let byte = |n: u16| self.get(at.wrapping_add(n));
        match width {
            Width::One => i32::from(byte(0).cast_signed()),
            Width::Two => i32::from(i16::from_le_bytes([byte(0), byte(1)])),
            Width::Four => i32::from_le_bytes([byte(0), byte(1), byte(2), byte(3)]),
        }
    }

    /// Writes the low bytes of a value.
    pub fn write(&mut self, at: u16, width: Width, value: i32) {
        for (n, byte) in (0..width.bytes()).zip(value.to_le_bytes()) {
            self.put(at.wrapping_add(n), byte);
        }
    }

    /// A value in BCD, two digits a byte; `None` where a digit is above 9.
    pub fn read_bcd(&self, at: u16, width: Width) -> Option<u32> {
        (0..width.bytes()).rev().try_fold(0, |value: u32, n| {
            let byte = u32::from(self.get(at.wrapping_add(n)));
            let (high, low) = (byte >> 4, byte & 0xF);
            (high <= 9 && low <= 9).then(|| value.wrapping_mul(100).wrapping_add(high * 10 + low))
        })
    }

    /// Writes the low digits of a value in BCD.
    pub fn write_bcd(&mut self, at: u16, width: Width, mut value: u32) {
        for n in 0..width.bytes() {
            let two = value % 100;
            value /= 100;
            // Below 0x9A.
            self.put(at.wrapping_add(n), (((two / 10) << 4) | (two % 10)) as u8);
        }
    }

    /// Copies X and F for level 2, which sees them unchanged while it goes round once.
    pub(crate) fn synchronise(&mut self) {
        for room in ROOMS {
            let to = match room.area {
                Area::X => IMAGE_X,
                Area::F => IMAGE_F,
                _ => continue,
            };
            let from = usize::from(room.place);
            self.bytes.copy_within(from..from + usize::from(room.len), usize::from(to));
        }
    }

    /// Sets all outputs, Y and G, to 0: the state of a PLC that stands still.
    pub(crate) fn clear_outputs(&mut self) {
        for room in ROOMS.iter().filter(|r| matches!(r.area, Area::Y | Area::G)) {
            for at in room.place..room.place + room.len {
                self.put(at, 0);
            }
        }
    }

    /// Forces a bit, or all of a byte: nothing writes it until it is released.
    pub(crate) fn force(&mut self, address: Address, value: bool) {
        let (at, mask) = (usize::from(address.place()), mask(address));
        let old = self.bytes[at];
        self.bytes[at] = if value { old | mask } else { old & !mask };
        self.free[at] &= !mask;
    }

    /// Releases a bit, or all of a byte.
    pub(crate) fn release(&mut self, address: Address) {
        self.free[usize::from(address.place())] |= mask(address);
    }

    /// Whether a bit, or any of a byte, is forced.
    pub fn is_forced(&self, address: Address) -> bool {
        !self.free[usize::from(address.place())] & mask(address) != 0
    }

    /// The bits that are forced, in the order of their areas.
    pub fn forced(&self) -> impl Iterator<Item = Address> {
        let bytes = ROOMS.iter().flat_map(|r| (0..r.len).map(move |n| (r, n)));
        bytes.flat_map(move |(r, n)| {
            let held = !self.free[usize::from(r.place + n)];
            (0..8u8).filter(move |bit| held & 1 << bit != 0).map(move |bit| Address {
                area: r.area,
                byte: r.first + n,
                bit: Some(bit),
            })
        })
    }

    /// Areas that keep their value while power is off, byte by byte.
    pub fn kept(&self) -> impl Iterator<Item = (Address, u8)> {
        ROOMS.iter().filter(|r| r.is_kept).flat_map(move |r| {
            (0..r.len)
                .map(move |n| (Address { area: r.area, byte: r.first + n, bit: None }, self.get(r.place + n)))
        })
    }
}

fn mask(address: Address) -> u8 {
    address.bit.map_or(0xFF, |bit| 1 << (bit & 7))
}

#[cfg(test)]
mod tests {
    use super::*;

    fn at(text: &str) -> Address {
        Address::parse(text).unwrap()
    }

    #[test]
    fn values_have_their_low_byte_first() {
        let mut memory = Memory::new();
        let d = at("D10").place();
        memory.write(d, Width::Four, -2);
        assert_eq!(memory.byte(at("D10")), 0xFE);
        assert_eq!(memory.read(d, Width::Four), -2);
        memory.write(d, Width::Two, 0x1234);
        assert_eq!((memory.byte(at("D10")), memory.byte(at("D11"))), (0x34, 0x12));
        assert_eq!(memory.read(d, Width::One), 0x34);
        memory.write_bcd(d, Width::Two, 1995);
        assert_eq!((memory.byte(at("D10")), memory.byte(at("D11"))), (0x95, 0x19));
        assert_eq!(memory.read_bcd(d, Width::Two), Some(1995));
        memory.write_bcd(d, Width::Four, 87_654_321);
        assert_eq!(memory.read_bcd(d, Width::Four), Some(87_654_321));
        memory.set_byte(at("D10"), 0x1A);
        assert_eq!(memory.read_bcd(d, Width::One), None);
    }

    #[test]
    fn what_is_forced_stays_until_it_is_released() {
        let mut memory = Memory::new();
        memory.force(at("Y3.2"), true);
        memory.set_byte(at("Y3"), 0x01);
        assert_eq!(memory.byte(at("Y3")), 0x05);
        assert_eq!(memory.forced().map(|address| address.to_string()).collect::<Vec<_>>(), ["Y0003.2"]);
        assert!(memory.is_forced(at("Y3.2")) && memory.is_forced(at("Y3")) && !memory.is_forced(at("Y3.0")));
        memory.release(at("Y3.2"));
        memory.set_byte(at("Y3"), 0x01);
        assert_eq!(memory.byte(at("Y3")), 0x01);
    }

    #[test]
    fn kept_are_k_t_c_and_d() {
        let kept: usize = Memory::new().kept().count();
        assert_eq!(kept, 100 + 500 + 400 + 10_000);
    }
}
