//! COD CODB, DEC DECB, DSCH DSCHB, XMOV XMOVB: values by their number and numbers by their value.

use super::{Held, Line, Table};
use crate::memory::{Memory, Width};

/// BYT ST2 (on: the values have four digits), RST ST1, ACT ST0. The number has two digits of BCD. W1: there is
/// no such value.
pub(super) fn code(memory: &mut Memory, values: &[i32], from: u16, to: u16, held: Held, line: Line) -> bool {
    line.act(memory, held, |memory| {
        let number = memory.read_bcd(from, Width::One);
        let Some(value) = number.and_then(|n| values.get(n as usize)) else { return true };
        memory.write_bcd(to, line.digits(2), value.cast_unsigned());
        false
    })
}

/// RST ST1, ACT ST0. The number is a byte in binary. W1: there is no such value.
pub(super) fn code_binary(
    memory: &mut Memory,
    width: Width,
    values: &[i32],
    (from, to): (u16, u16),
    held: Held,
    line: Line,
) -> bool {
    line.act(memory, held, |memory| {
        let Some(value) = values.get(usize::from(memory.get(from))) else { return true };
        memory.write(to, width, *value);
        false
    })
}

/// ACT ST0. W1: the two digits are those of `nnll`, of which `ll` says which count: 01 the lower, 10 the
/// upper, 11 both.
pub(super) fn decode(memory: &mut Memory, from: u16, digits: u16, line: Line) -> bool {
    let (wanted, which) = (digits / 100, digits % 100);
    let byte = u16::from(memory.get(from));
    let upper = which < 10 || byte >> 4 == wanted / 10;
    let lower = which % 10 == 0 || byte & 0xF == wanted % 10;
    line.st(0) && upper && lower
}

/// ACT ST0. Of eight bits, or eight for each byte of the result, the one whose number the value is; none while
/// it does not act.
pub(super) fn decode_binary(
    memory: &mut Memory,
    width: Width,
    from: u16,
    first: i32,
    (bytes, to): (u16, u16),
    line: Line,
) -> bool {
    let found = i64::from(memory.read(from, width)) - i64::from(first);
    for n in 0..bytes {
        let bit = found - i64::from(n) * 8;
        let on = line.st(0) && (0..8).contains(&bit);
        memory.put(to.wrapping_add(n), if on { 1 << (bit & 7) } else { 0 });
    }
    line.st(0)
}

/// BYT ST2, RST ST1, ACT ST0. W1: no value of the table is the one that is looked for; else the result is the
/// number of the first.
pub(super) fn search(
    memory: &mut Memory,
    values: u32,
    table: Table,
    (key, to): (u16, u16),
    held: Held,
    line: Line,
) -> bool {
    line.act(memory, held, |memory| {
        let digits = line.digits(2);
        let wanted = memory.read(key, digits);
        let places = (0..values).map_while(|n| table.place(n, digits));
        let found = places.map(|at| memory.read(at, digits)).position(|value| value == wanted);
        let Some(found) = found.and_then(|n| u32::try_from(n).ok()) else { return true };
        memory.write_bcd(to, digits, found);
        false
    })
}

/// RST ST1, ACT ST0. As DSCH, in binary.
pub(super) fn search_binary(
    memory: &mut Memory,
    width: Width,
    values: u32,
    table: Table,
    (key, to): (u16, u16),
    held: Held,
    line: Line,
) -> bool {
    line.act(memory, held, |memory| {
        let wanted = memory.read(key, width);
        let places = (0..values).map_while(|n| table.place(n, width));
        let found = places.map(|at| memory.read(at, width)).position(|value| value == wanted);
        let Some(found) = found.and_then(|n| i32::try_from(n).ok()) else { return true };
        memory.write(to, width, found);
        false
    })
}

/// BYT ST3, RW ST2 (on: into the table), RST ST1, ACT ST0. W1: the table has no value of that number.
pub(super) fn transfer(
    memory: &mut Memory,
    values: u32,
    table: Table,
    (data, index): (u16, u16),
    held: Held,
    line: Line,
) -> bool {
    line.act(memory, held, |memory| {
        let digits = line.digits(3);
        let number = memory.read_bcd(index, digits).filter(|n| *n < values);
        exchange(memory, number.and_then(|n| table.place(n, digits)), data, digits, line.st(2))
    })
}

/// RW ST2 (on: into the table), RST ST1, ACT ST0. As XMOV, in binary.
pub(super) fn transfer_binary(
    memory: &mut Memory,
    width: Width,
    values: u16,
    table: Table,
    (data, index): (u16, u16),
    held: Held,
    line: Line,
) -> bool {
    line.act(memory, held, |memory| {
        let values = u32::try_from(memory.read(values, width)).unwrap_or(0);
        let number = u32::try_from(memory.read(index, width)).ok().filter(|n| *n < values);
        exchange(memory, number.and_then(|n| table.place(n, width)), data, width, line.st(2))
    })
}

fn exchange(memory: &mut Memory, place: Option<u16>, data: u16, width: Width, is_into: bool) -> bool {
    let Some(place) = place else { return true };
    let (from, to) = if is_into { (data, place) } else { (place, data) };
    memory.write(to, width, memory.read(from, width));
    false
}
