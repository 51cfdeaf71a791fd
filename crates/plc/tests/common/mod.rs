//! Ladders under test.
#![allow(dead_code, missing_docs, clippy::unwrap_used, clippy::panic)]

use ferrocut_plc::{Address, Error, Limits, Pace, Plc, Program};

pub fn at(text: &str) -> Address {
    Address::parse(text).unwrap()
}

/// A ladder of 1 ms periods that each carry out all of it.
pub fn plc(text: &str) -> Plc {
    match Program::from_text(text.as_bytes(), &Limits::default()) {
        Ok(program) => Plc::new(program, Pace::default()),
        Err(errors) => panic!("{}\n{text}", shown(&errors).join("\n")),
    }
}

/// Networks as level 2 of a ladder.
pub fn second(networks: &str) -> Plc {
    plc(&format!("END1\n{networks}\nEND2\n"))
}

/// Number and line of each fault.
pub fn faults(text: &str) -> Vec<(u16, u32)> {
    match Program::from_text(text.as_bytes(), &Limits::default()) {
        Ok(_) => Vec::new(),
        Err(errors) => errors.iter().map(|e| (e.fault.number(), e.span.line)).collect(),
    }
}

pub fn shown(errors: &[Error]) -> Vec<String> {
    errors.iter().map(|e| format!("{e:?}")).collect()
}

pub fn set(plc: &mut Plc, signal: &str, on: bool) {
    plc.memory_mut().set_bit(at(signal), on);
}

pub fn get(plc: &Plc, signal: &str) -> bool {
    plc.memory().bit(at(signal))
}

/// Bytes from an address on.
pub fn put(plc: &mut Plc, first: &str, bytes: &[u8]) {
    let mut address = at(first);
    for byte in bytes {
        plc.memory_mut().set_byte(address, *byte);
        address.byte += 1;
    }
}

pub fn bytes(plc: &Plc, first: &str, count: u16) -> Vec<u8> {
    let address = at(first);
    (0..count).map(|n| plc.memory().byte(Address { byte: address.byte + n, ..address })).collect()
}

/// Scans for a time, ms.
pub fn run(plc: &mut Plc, ms: u32) {
    for _ in 0..ms {
        let scanned = plc.scan();
        assert_eq!(scanned.stop, None);
    }
}
