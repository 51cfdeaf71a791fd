//! Each function on its own, with results worked out by hand from its description.
#![allow(missing_docs, clippy::unwrap_used)]

mod common;

use common::{at, bytes, get, put, run, second, set};

/// One scan of a function: its text, its conditions from the first stacked to ACT (`1010`), whether its coil was
/// on before, bytes before, whether W1 is on, bytes after.
struct Case(&'static str, &'static str, bool, &'static [Bytes], bool, &'static [Bytes]);
type Bytes = (&'static str, &'static [u8]);

/// Runs the cases of functions that have a W1.
fn with_w1(cases: &[Case]) {
    check(cases, "WRT R0.0\n");
}

/// Runs the cases of functions that have none.
fn without_w1(cases: &[Case]) {
    check(cases, "");
}

fn check(cases: &[Case], coil: &str) {
    for Case(function, conditions, held, before, w1, after) in cases {
        let stacked = (0..conditions.len()).map(|n| match n {
            0 => "RD X0.0\n".to_owned(),
            _ => format!("RD.STK X0.{n}\n"),
        });
        let mut plc = second(&format!("{}{function}\n{coil}", stacked.collect::<String>()));
        for (n, on) in conditions.bytes().enumerate() {
            set(&mut plc, &format!("X0.{n}"), on == b'1');
        }
        set(&mut plc, "R0.0", *held);
        for (first, bytes) in *before {
            put(&mut plc, first, bytes);
        }
        assert!(plc.scan().is_round);
        assert_eq!(get(&plc, "R0.0"), *w1, "{function} {conditions} {before:?}");
        for (first, wanted) in *after {
            let is = bytes(&plc, first, wanted.len() as u16);
            assert_eq!(is, *wanted, "{function} {conditions} {first}");
        }
    }
}

#[test]
fn timers_turn_on_after_their_time_and_off_at_once() {
    // Timer 9 counts in 8 ms: 5 are 40 ms. Timer 8 in 48 ms: 2 are 96 ms.
    let mut plc =
        second("RD X0.0\nTMR 9\nWRT Y0.0\nRD X0.0\nTMR 8\nWRT Y0.1\nRD X0.0\nTMRB 9 25\nWRT Y0.2\n");
    put(&mut plc, "T16", &[5, 0]);
    put(&mut plc, "T14", &[2, 0]);
    run(&mut plc, 10);
    set(&mut plc, "X0.0", true);
    for ms in 0..200 {
        plc.scan();
        let on = [get(&plc, "Y0.0"), get(&plc, "Y0.1"), get(&plc, "Y0.2")];
        assert_eq!(on, [ms >= 40, ms >= 96, ms >= 25], "{ms}");
    }
    set(&mut plc, "X0.0", false);
    plc.scan();
    assert_eq!(bytes(&plc, "Y0", 1), [0]);
    // A pause begins the time anew.
    for on in [true, false, true] {
        set(&mut plc, "X0.0", on);
        run(&mut plc, 20);
        assert!(!get(&plc, "Y0.2"));
    }
    run(&mut plc, 6);
    assert!(get(&plc, "Y0.2"));
    // A time of 0, and one that is negative, are none.
    let mut plc = second("RD X0.0\nTMR 10\nWRT Y0.0\nRD X0.0\nTMR 11\nWRT Y0.1\n");
    put(&mut plc, "T20", &[0xFF, 0xFF]);
    set(&mut plc, "X0.0", true);
    plc.scan();
    assert!(get(&plc, "Y0.0") && get(&plc, "Y0.1"));
}

#[test]
fn timers_with_their_time_in_signals() {
    for (accuracy, unit) in [(0u32, 8u32), (1, 48), (2, 1_000), (3, 10_000), (4, 60_000)] {
        let mut plc = second(&format!("RD X0.0\nTMRC {accuracy} D10 R20\nWRT Y0.0\n"));
        put(&mut plc, "D10", &[2, 0]);
        run(&mut plc, 10);
        for _ in 0..2 {
            set(&mut plc, "X0.0", true);
            run(&mut plc, 2 * unit);
            assert!(!get(&plc, "Y0.0"), "{accuracy}");
            run(&mut plc, 1);
            assert!(get(&plc, "Y0.0"), "{accuracy}");
            run(&mut plc, 3 * unit);
            assert!(get(&plc, "Y0.0"), "{accuracy}");
            set(&mut plc, "X0.0", false);
            run(&mut plc, 1);
            assert!(!get(&plc, "Y0.0"), "{accuracy}");
        }
        assert_eq!(bytes(&plc, "R20", 4), [0; 4]);
    }
    // From the first scan on, and without a time.
    let mut plc = second("RD R9091.1\nTMRC 0 D10 R20\nWRT Y0.0\nRD R9091.1\nTMRC 0 D12 R24\nWRT Y0.1\n");
    put(&mut plc, "D10", &[1, 0]);
    run(&mut plc, 1);
    assert_eq!(bytes(&plc, "Y0", 1), [0b10]);
    run(&mut plc, 9);
    assert_eq!(bytes(&plc, "Y0", 1), [0b11]);
}

#[test]
fn counters_are_rings() {
    // Preset in C4 or D4, count in C6 or R6.
    counts("CTR 2", "C4", "C6");
    counts("CTRC D4 R6", "D4", "R6");
}

fn counts(function: &str, preset: &str, count_at: &str) {
    // Conditions CN0 X0.0, UPDOWN X0.1, RST X0.2, ACT X0.3; preset 3.
    let text = &format!("RD X0.0\nRD.STK X0.1\nRD.STK X0.2\nRD.STK X0.3\n{function}\nWRT Y0.0\n");
    /// Conditions, the first count, and the counts that follow with W1.
    type Counts = (u8, u8, &'static [(u8, bool)]);
    let table: &[Counts] = &[
        // Up from 0: 1, 2, 3 and W1, then 0.
        (0b00, 0, &[(1, false), (2, false), (3, true), (0, false), (1, false)]),
        // Up from 1.
        (0b01, 1, &[(2, false), (3, true), (1, false), (2, false)]),
        // Down to 0.
        (0b10, 3, &[(2, false), (1, false), (0, true), (3, false)]),
        // Down to 1.
        (0b11, 3, &[(2, false), (1, true), (3, false)]),
    ];
    for (conditions, start, counts) in table {
        let mut plc = second(text);
        put(&mut plc, preset, &[3, 0]);
        put(&mut plc, count_at, &[9, 9]);
        put(&mut plc, "X0", &[conditions | 0b0100]);
        plc.scan();
        assert_eq!((bytes(&plc, count_at, 2), get(&plc, "Y0.0")), (vec![*start, 0], false), "{conditions}");
        for (count, w1) in *counts {
            put(&mut plc, "X0", &[conditions | 0b1000]);
            run(&mut plc, 3);
            assert_eq!((bytes(&plc, count_at, 2), get(&plc, "Y0.0")), (vec![*count, 0], *w1), "{conditions}");
            put(&mut plc, "X0", &[*conditions]);
            plc.scan();
            assert_eq!(get(&plc, "Y0.0"), *w1);
        }
    }
}

#[test]
fn edges_last_one_scan() {
    let mut plc = second("RD X0.0\nDIFU 1\nWRT Y0.0\nRD X0.0\nDIFD 2\nWRT Y0.1\n");
    let inputs = [false, true, true, false, false, true, false];
    let edges = [0, 1, 0, 2, 0, 1, 2];
    for (input, edge) in inputs.into_iter().zip(edges) {
        set(&mut plc, "X0.0", input);
        plc.scan();
        assert_eq!(bytes(&plc, "Y0", 1), [edge]);
    }
}

#[test]
fn moves() {
    without_w1(&[
        // 1011 0110 by 1111 0010.
        Case("MOVE 1111 0010 R10 R20", "1", false, &[("R10", &[0xB6])], false, &[("R20", &[0xB2])]),
        Case("MOVE 0000 1111 R10 R20", "1", false, &[("R10", &[0xB6])], false, &[("R20", &[0x06])]),
        Case("MOVE 1111 1111 R10 R20", "0", false, &[("R10", &[1]), ("R20", &[9])], false, &[("R20", &[9])]),
        Case("MOVB R10 R20", "1", false, &[("R10", &[1, 2])], false, &[("R20", &[1, 0])]),
        Case("MOVW R10 R20", "1", false, &[("R10", &[1, 2, 3])], false, &[("R20", &[1, 2, 0])]),
        Case("MOVD R10 R20", "1", false, &[("R10", &[1, 2, 3, 4, 5])], false, &[("R20", &[1, 2, 3, 4, 0])]),
        Case("MOVN 3 R10 R20", "1", false, &[("R10", &[1, 2, 3, 4])], false, &[("R20", &[1, 2, 3, 0])]),
        // Over itself, up and down.
        Case("MOVN 3 R10 R11", "1", false, &[("R10", &[1, 2, 3, 4])], false, &[("R10", &[1, 1, 2, 3])]),
        Case("MOVN 3 R11 R10", "1", false, &[("R10", &[1, 2, 3, 4])], false, &[("R10", &[2, 3, 4, 4])]),
        Case("MOVN 3 R10 R20", "0", false, &[("R10", &[1, 2, 3, 4])], false, &[("R20", &[0, 0, 0])]),
    ]);
}

#[test]
fn comparisons_in_bcd() {
    // BYT, ACT. COMP: W1 where the value is not above the other.
    with_w1(&[
        Case("COMP 0 24 R10", "01", false, &[("R10", &[0x25])], true, &[]),
        Case("COMP 0 25 R10", "01", false, &[("R10", &[0x25])], true, &[]),
        Case("COMP 0 26 R10", "01", true, &[("R10", &[0x25])], false, &[]),
        Case("COMP 0 1024 R10", "11", true, &[("R10", &[0x23, 0x10])], false, &[]),
        Case("COMP 0 1023 R10", "11", false, &[("R10", &[0x23, 0x10])], true, &[]),
        Case("COMP 1 R12 R10", "11", false, &[("R10", &[0, 0x10, 0x99, 0x09])], true, &[]),
        Case("COIN 0 25 R10", "01", false, &[("R10", &[0x25])], true, &[]),
        Case("COIN 0 24 R10", "01", true, &[("R10", &[0x25])], false, &[]),
        Case("COIN 1 R12 R10", "11", false, &[("R10", &[0x34, 0x12, 0x34, 0x12])], true, &[]),
        // ACT off: W1 stays.
        Case("COMP 0 26 R10", "00", true, &[("R10", &[0x25])], true, &[]),
        Case("COIN 0 25 R10", "00", false, &[("R10", &[0x25])], false, &[]),
        // 0x2F is no BCD: W1 stays.
        Case("COIN 0 25 R10", "01", true, &[("R10", &[0x2F])], true, &[]),
    ]);
}

#[test]
fn comparison_in_binary_tells_in_r9000() {
    // Bit 0: equal; bit 1: below; bit 5: the difference does not fit.
    for (format, value, with, told) in [
        ("COMPB 1 5 R10", &[][..], &[5][..], 0b01),
        ("COMPB 1 -5 R10", &[], &[5], 0b10),
        ("COMPB 2 300 R10", &[], &[44, 1], 0b01),
        ("COMPB 1002 R12 R10", &[0x2D, 1], &[0x2C, 1], 0),
        ("COMPB 1002 R12 R10", &[0xFF, 0xFF], &[0, 0], 0b10),
        ("COMPB 1004 R16 R10", &[0, 0, 0, 0, 1, 0, 0, 0x80], &[2, 0, 0, 0], 0b10_0010),
    ] {
        let mut plc = second(&format!(
            "RD X0.0\n{format}\nRD R9000.0\nWRT R0.0\nRD R9000.1\nWRT R0.1\nRD R9000.5\nWRT R0.5\n"
        ));
        set(&mut plc, "X0.0", true);
        put(&mut plc, "R10", with);
        put(&mut plc, "R12", value);
        plc.scan();
        assert_eq!(bytes(&plc, "R0", 1), [told], "{format}");
    }
}

#[test]
fn arithmetic_in_bcd() {
    // BYT, RST, ACT.
    let numbers: &[Bytes] = &[("R10", &[0x47, 0x12]), ("R12", &[0x58, 0x09])];
    with_w1(&[
        // 47 + 35 = 82; 47 + 58 = 105, of which 05 has room.
        Case("ADD 0 R10 35 R20", "001", true, numbers, false, &[("R20", &[0x82, 0])]),
        Case("ADD 1 R10 R12 R20", "001", false, numbers, true, &[("R20", &[0x05, 0])]),
        // 1247 + 958 = 2205.
        Case("ADD 1 R10 R12 R20", "101", true, numbers, false, &[("R20", &[0x05, 0x22])]),
        Case("ADD 0 R10 9000 R20", "101", false, numbers, true, &[("R20", &[0x47, 0x02])]),
        // 1247 - 958 = 289; 958 - 1247 = -289, whose complement is 9711.
        Case("SUB 20 1 R10 R12 R20", "101", true, numbers, false, &[("R20", &[0x89, 0x02])]),
        Case("SUB 20 1 R12 R10 R20", "101", false, numbers, true, &[("R20", &[0x11, 0x97])]),
        // 47 * 2 = 94; 47 * 3 = 141.
        Case("MUL 0 R10 2 R20", "001", true, numbers, false, &[("R20", &[0x94, 0])]),
        Case("MUL 0 R10 3 R20", "001", false, numbers, true, &[("R20", &[0x41, 0])]),
        Case("MUL 0 R10 8 R20", "101", true, numbers, false, &[("R20", &[0x76, 0x99])]),
        // 1247 / 10 = 124; by 0 there is none.
        Case("DIV 0 R10 10 R20", "101", true, numbers, false, &[("R20", &[0x24, 0x01])]),
        Case("DIV 0 R10 0 R20", "101", false, &[("R10", &[1]), ("R20", &[7])], true, &[("R20", &[7])]),
        // RST before ACT; without ACT nothing changes.
        Case("ADD 0 R10 1 R20", "011", true, numbers, false, &[("R20", &[0])]),
        Case("ADD 0 R10 1 R20", "000", true, numbers, true, &[("R20", &[0])]),
        Case("ADD 0 R10 1 R20", "001", false, &[("R10", &[0xA0])], true, &[("R20", &[0])]),
    ]);
    without_w1(&[
        Case("NUME 1995 R20", "11", false, &[], false, &[("R20", &[0x95, 0x19])]),
        Case("NUME 1995 R20", "01", false, &[], false, &[("R20", &[0x95, 0])]),
        Case("NUME 1995 R20", "10", false, &[], false, &[("R20", &[0, 0])]),
    ]);
}

#[test]
fn arithmetic_in_binary() {
    // RST, ACT.
    let numbers: &[Bytes] = &[("R10", &[100]), ("R14", &[0xF4, 0x01]), ("R16", &[0x9C, 0xFF, 0xFF, 0xFF])];
    with_w1(&[
        // 100 + 27 = 127; 100 + 28 = 128, which is -128 in a byte.
        Case("ADDB 1 R10 27 R20", "01", true, numbers, false, &[("R20", &[127])]),
        Case("ADDB 1 R10 28 R20", "01", false, numbers, true, &[("R20", &[0x80])]),
        // 500 + 500 = 1000.
        Case("ADDB 1002 R14 R14 R20", "01", true, numbers, false, &[("R20", &[0xE8, 0x03, 0])]),
        // -100 + 1 = -99.
        Case("ADDB 4 R16 1 R20", "01", false, numbers, false, &[("R20", &[0x9D, 0xFF, 0xFF, 0xFF])]),
        Case("SUBB 1 R10 101 R20", "01", true, numbers, false, &[("R20", &[0xFF])]),
        Case("SUBB 2 R14 -100 R20", "01", true, numbers, false, &[("R20", &[0x58, 0x02])]),
        Case("MULB 2 R14 65 R20", "01", true, numbers, false, &[("R20", &[0xF4, 0x7E])]),
        Case("MULB 2 R14 66 R20", "01", false, numbers, true, &[("R20", &[0xE8, 0x80])]),
        // 500 / 7 = 71 rest 3; -100 / 7 = -14 rest -2.
        Case("DIVB 2 R14 7 R20", "01", true, numbers, false, &[("R20", &[71, 0])]),
        Case("DIVB 4 R16 7 R20", "01", false, numbers, false, &[("R20", &[0xF2, 0xFF, 0xFF, 0xFF])]),
        Case("DIVB 2 R14 0 R20", "01", false, numbers, true, &[("R20", &[0, 0])]),
        Case("ADDB 1 R10 28 R20", "11", true, numbers, false, &[("R20", &[0])]),
        Case("ADDB 1 R10 28 R20", "00", true, numbers, true, &[("R20", &[0])]),
    ]);
}

#[test]
fn flags_and_rest_of_binary_arithmetic() {
    for (function, told, rest) in [
        ("DIVB 2 R14 7 R20", 0, [3, 0]),
        ("DIVB 2 R16 7 R20", 0b10, [0xFE, 0xFF]),
        ("SUBB 2 R14 500 R20", 0b01, [0, 0]),
        ("MULB 2 R14 -66 R20", 0b10_0010, [0, 0]),
    ] {
        let text =
            format!("RD X0.0\nRD.STK X0.1\n{function}\nRD X0.1\nMOVB R9000 R30\nRD X0.1\nMOVW R9002 R32\n");
        let mut plc = second(&text);
        put(&mut plc, "R14", &[0xF4, 0x01, 0x9C, 0xFF]);
        put(&mut plc, "X0", &[0b10]);
        plc.scan();
        assert_eq!((bytes(&plc, "R30", 1), bytes(&plc, "R32", 2)), (vec![told], rest.to_vec()), "{function}");
    }
}

#[test]
fn definitions_in_binary() {
    without_w1(&[
        Case("NUMEB 1 -5 R20", "1", false, &[], false, &[("R20", &[0xFB, 0])]),
        Case("NUMEB 2 1000 R20", "1", false, &[], false, &[("R20", &[0xE8, 0x03, 0])]),
        Case("NUMEB 4 -2 R20", "1", false, &[], false, &[("R20", &[0xFE, 0xFF, 0xFF, 0xFF, 0])]),
        Case("NUMEB 1 255 R20", "1", false, &[], false, &[("R20", &[0xFF, 0])]),
        Case("NUMEB 2 1000 R20", "0", false, &[], false, &[("R20", &[0, 0])]),
    ]);
}

#[test]
fn conversions() {
    with_w1(&[
        // BYT, CNV, RST, ACT: 0x4D is 77; 0x64 is 100, three digits.
        Case("DCNV R10 R20", "0001", true, &[("R10", &[0x4D])], false, &[("R20", &[0x77])]),
        Case("DCNV R10 R20", "0001", false, &[("R10", &[0x64]), ("R20", &[5])], true, &[("R20", &[5])]),
        Case("DCNV R10 R20", "1001", true, &[("R10", &[0xCB, 0x07])], false, &[("R20", &[0x95, 0x19])]),
        Case("DCNV R10 R20", "0101", true, &[("R10", &[0x77])], false, &[("R20", &[0x4D])]),
        Case("DCNV R10 R20", "1101", true, &[("R10", &[0x95, 0x19])], false, &[("R20", &[0xCB, 0x07])]),
        Case("DCNV R10 R20", "0101", false, &[("R10", &[0x7A])], true, &[("R20", &[0])]),
        Case("DCNV R10 R20", "0111", true, &[("R10", &[0x7A])], false, &[("R20", &[0])]),
        Case("DCNV R10 R20", "0100", true, &[("R10", &[0x77])], true, &[("R20", &[0])]),
        // SIN, CNV, RST, ACT.
        Case("DCNVB 1 R10 R20", "0001", true, &[("R10", &[0xB3])], false, &[("R20", &[0x77])]),
        Case("DCNVB 2 R10 R20", "0101", true, &[("R10", &[0x95, 0x19])], false, &[("R20", &[0xCB, 0x07])]),
        Case("DCNVB 2 R10 R20", "1101", true, &[("R10", &[0x95, 0x19])], false, &[("R20", &[0x35, 0xF8])]),
        Case(
            "DCNVB 4 R10 R20",
            "0001",
            true,
            &[("R10", &[0x15, 0xCD, 0x5B, 0x00])],
            false,
            // 0x5BCD15 is 6016277.
            &[("R20", &[0x77, 0x62, 0x01, 0x06])],
        ),
        Case("DCNVB 1 R10 R20", "0001", false, &[("R10", &[0x64])], true, &[("R20", &[0])]),
    ]);
    // The sign of what became BCD.
    let mut plc = second(
        "RD X0.0\nRD.STK X0.0\nRD.STK X0.0\nRD.STK X0.1\nDCNVB 1 R10 R20\nWRT R0.0\nRD X0.1\nMOVB R9000 R30\n",
    );
    put(&mut plc, "R10", &[0xB3]);
    put(&mut plc, "X0", &[0b10]);
    plc.scan();
    assert_eq!(bytes(&plc, "R30", 1), [0b10]);
}

#[test]
fn rotation() {
    let positions: &[Bytes] = &[("R10", &[0x02]), ("R12", &[0x11])];
    with_w1(&[
        // RN0, BYT, DIR, POS, INC, ACT; 12 pockets from 1, at 2, to 11.
        // The shorter way to the goal is 3 back.
        Case("ROT 12 R10 R12 R20", "101011", false, positions, true, &[("R20", &[0x03])]),
        // Forward always: 9 steps.
        Case("ROT 12 R10 R12 R20", "100011", true, positions, false, &[("R20", &[0x09])]),
        // The position before the goal: 12 backward, 10 forward.
        Case("ROT 12 R10 R12 R20", "101101", false, positions, true, &[("R20", &[0x12])]),
        Case("ROT 12 R10 R12 R20", "100101", true, positions, false, &[("R20", &[0x10])]),
        Case("ROT 12 R10 R12 R20", "101111", false, positions, true, &[("R20", &[0x02])]),
        Case("ROT 12 R10 R12 R20", "101001", false, positions, true, &[("R20", &[0x11])]),
        // From 0: 0 to 6 of 12 is as far both ways; forward.
        Case(
            "ROT 12 R10 R12 R20",
            "001011",
            true,
            &[("R10", &[0]), ("R12", &[0x06])],
            false,
            &[("R20", &[6])],
        ),
        // There already.
        Case("ROT 12 R10 R12 R20", "101111", true, &[("R10", &[3]), ("R12", &[3])], false, &[("R20", &[0])]),
        // Four digits: 300 positions, 1 to 290 is 11 back.
        Case(
            "ROT 300 R10 R12 R20",
            "111011",
            false,
            &[("R10", &[1, 0, 0x90, 2])],
            true,
            &[("R20", &[0x11, 0])],
        ),
        // Position 13 does not exist; without ACT nothing changes.
        Case(
            "ROT 12 R10 R12 R20",
            "101011",
            true,
            &[("R10", &[2]), ("R12", &[0x13])],
            true,
            &[("R20", &[0])],
        ),
        Case("ROT 12 R10 R12 R20", "101010", false, positions, false, &[("R20", &[0])]),
        // RN0, DIR, POS, INC, ACT in binary; the number of positions is D0.
        Case(
            "ROTB 1 D0 R10 R12 R20",
            "11011",
            false,
            &[("D0", &[12]), ("R10", &[2]), ("R12", &[11])],
            true,
            &[("R20", &[3])],
        ),
        Case(
            "ROTB 2 D0 R10 R12 R20",
            "01101",
            true,
            &[("D0", &[0x2C, 1]), ("R10", &[0x2B, 1, 4, 0])],
            false,
            &[("R20", &[3, 0])],
        ),
        Case("ROTB 1 D0 R10 R12 R20", "11011", true, &[("D0", &[0])], true, &[("R20", &[0])]),
    ]);
}

#[test]
fn tables_in_the_ladder() {
    with_w1(&[
        // BYT, RST, ACT.
        Case("COD 3 R10 R20 10 20 99", "001", true, &[("R10", &[0x02])], false, &[("R20", &[0x99, 0])]),
        Case("COD 3 R10 R20 10 20 1234", "101", true, &[("R10", &[0x02])], false, &[("R20", &[0x34, 0x12])]),
        Case("COD 3 R10 R20 10 20 99", "001", false, &[("R10", &[0x03])], true, &[("R20", &[0])]),
        Case("COD 3 R10 R20 10 20 99", "011", true, &[("R10", &[0x03])], false, &[("R20", &[0])]),
        // RST, ACT.
        Case("CODB 2 3 R10 R20\n100\n-1\n3000", "01", true, &[("R10", &[1])], false, &[("R20", &[255, 255])]),
        Case(
            "CODB 2 3 R10 R20\n100 -1\n3000",
            "01",
            true,
            &[("R10", &[2])],
            false,
            &[("R20", &[0xB8, 0x0B])],
        ),
        Case("CODB 1 3 R10 R20 1 2 3", "01", false, &[("R10", &[3])], true, &[("R20", &[0])]),
        Case("CODB 1 3 R10 R20 1 2 3", "00", true, &[("R10", &[1])], true, &[("R20", &[0])]),
    ]);
}

#[test]
fn decoding() {
    with_w1(&[
        Case("DEC F10 0311", "1", false, &[("F10", &[0x03])], true, &[]),
        Case("DEC F10 3011", "1", false, &[("F10", &[0x30])], true, &[]),
        Case("DEC F10 311", "1", true, &[("F10", &[0x13])], false, &[]),
        Case("DEC F10 0301", "1", false, &[("F10", &[0x13])], true, &[]),
        Case("DEC F10 1310", "1", false, &[("F10", &[0x15])], true, &[]),
        Case("DEC F10 0311", "0", true, &[("F10", &[0x03])], false, &[]),
    ]);
    without_w1(&[
        // Bit n is on where the value is 3 + n.
        Case("DECB 1 F10 3 R20", "1", false, &[("F10", &[3])], false, &[("R20", &[0x01])]),
        Case("DECB 1 F10 3 R20", "1", false, &[("F10", &[10])], false, &[("R20", &[0x80])]),
        Case("DECB 1 F10 3 R20", "1", false, &[("F10", &[11]), ("R20", &[1])], false, &[("R20", &[0, 0])]),
        Case("DECB 1 F10 3 R20", "1", false, &[("F10", &[2])], false, &[("R20", &[0])]),
        Case("DECB 2 F10 300 R20", "1", false, &[("F10", &[0x2E, 1])], false, &[("R20", &[4])]),
        Case("DECB 4 F10 3 R20", "1", false, &[("F10", &[4, 0, 0, 0])], false, &[("R20", &[2])]),
        Case("DECB 4 F10 3 R20", "1", false, &[("F10", &[4, 0, 1, 0])], false, &[("R20", &[0])]),
        // Two groups of eight.
        Case("DECB 24 F10 3 R20", "1", false, &[("F10", &[12])], false, &[("R20", &[0, 2])]),
        Case("DECB 1 F10 3 R20", "0", false, &[("F10", &[3]), ("R20", &[1])], false, &[("R20", &[0])]),
    ]);
}

#[test]
fn tables_in_the_signals() {
    let table: &[Bytes] = &[("D10", &[5, 0x12, 7, 0x12, 9]), ("D20", &[0x12]), ("D30", &[1])];
    let words: &[Bytes] =
        &[("D10", &[1, 0, 2, 0, 3, 0]), ("D20", &[3, 0]), ("D40", &[3, 0]), ("D42", &[2, 0])];
    with_w1(&[
        // BYT, RST, ACT: 12 is number 1.
        Case("DSCH 5 D10 D20 R20", "001", true, table, false, &[("R20", &[0x01])]),
        Case("DSCH 1 D10 D20 R20", "001", false, table, true, &[("R20", &[0])]),
        Case("DSCH 3 D10 D20 R20", "101", true, words, false, &[("R20", &[2, 0])]),
        Case("DSCH 5 D10 D20 R20", "011", true, table, false, &[("R20", &[0])]),
        // RST, ACT; the number of values is D40.
        Case("DSCHB 2 D40 D10 D20 R20", "01", true, words, false, &[("R20", &[2, 0])]),
        Case("DSCHB 2 D44 D10 D20 R20", "01", false, words, true, &[("R20", &[0, 0])]),
        // BYT, RW, RST, ACT: D30 is the number.
        Case("XMOV 5 D10 R20 D30", "0001", true, table, false, &[("R20", &[0x12])]),
        Case("XMOV 1 D10 R20 D30", "0001", false, table, true, &[("R20", &[0])]),
        Case(
            "XMOV 5 D10 D20 D30",
            "0101",
            true,
            &[("D20", &[7]), ("D30", &[4])],
            false,
            &[("D10", &[0, 0, 0, 0, 7])],
        ),
        // RW, RST, ACT.
        Case("XMOVB 2 D40 D10 R20 D42", "001", true, words, false, &[("R20", &[3, 0])]),
        Case("XMOVB 2 D42 D10 R20 D42", "001", false, words, true, &[("R20", &[0, 0])]),
        Case("XMOVB 2 D40 D10 D20 D44", "101", true, words, false, &[("D10", &[3, 0, 2, 0])]),
        // A table beyond its area has no such value: number 1 of words at D9999.
        Case(
            "XMOVB 1 D42 D9999 R20 D30",
            "001",
            false,
            &[("D42", &[2]), ("D30", &[1])],
            true,
            &[("R20", &[0])],
        ),
    ]);
}

#[test]
fn shifts_and_parity() {
    with_w1(&[
        // DIR, CONT, RST, ACT: 0x8001 to the left.
        Case("SFT R10", "0001", false, &[("R10", &[0x01, 0x80])], true, &[("R10", &[0x02, 0])]),
        Case("SFT R10", "1001", false, &[("R10", &[0x01, 0x80])], true, &[("R10", &[0, 0x40])]),
        Case("SFT R10", "0001", true, &[("R10", &[0x02, 0])], false, &[("R10", &[0x04, 0])]),
        // Bits that are on stay on.
        Case("SFT R10", "0101", true, &[("R10", &[0x05, 0])], false, &[("R10", &[0x0F, 0])]),
        Case("SFT R10", "0011", true, &[("R10", &[0x05, 0])], false, &[("R10", &[0x05, 0])]),
        Case("SFT R10", "0000", true, &[("R10", &[0x05, 0])], true, &[("R10", &[0x05, 0])]),
        // O.E, RST, ACT: three ones are wrong where they must be even.
        Case("PARI R10", "001", false, &[("R10", &[0x07])], true, &[]),
        Case("PARI R10", "001", true, &[("R10", &[0x03])], false, &[]),
        Case("PARI R10", "101", true, &[("R10", &[0x07])], false, &[]),
        Case("PARI R10", "101", false, &[("R10", &[0x03])], true, &[]),
        Case("PARI R10", "011", true, &[("R10", &[0x07])], false, &[]),
        Case("PARI R10", "000", true, &[("R10", &[0x03])], true, &[]),
    ]);
}

#[test]
fn operations_on_bits() {
    let numbers: &[Bytes] = &[("R10", &[0b1100, 0xF0]), ("R12", &[0b1010, 0x0F])];
    without_w1(&[
        Case("EOR 1001 R10 R12 R20", "1", false, numbers, false, &[("R20", &[0b0110, 0])]),
        Case("EOR 1002 R10 R12 R20", "1", false, numbers, false, &[("R20", &[0b0110, 0xFF])]),
        Case("AND 1001 R10 R12 R20", "1", false, numbers, false, &[("R20", &[0b1000])]),
        Case("AND 1 R10 4 R20", "1", false, numbers, false, &[("R20", &[0b0100])]),
        Case("SUB 60\n1\nR10\n4\nR20", "1", false, numbers, false, &[("R20", &[0b0100])]),
        Case("OR 1002 R10 R12 R20", "1", false, numbers, false, &[("R20", &[0b1110, 0xFF])]),
        Case("OR 1 R10 240 R20", "1", false, numbers, false, &[("R20", &[0xFC])]),
        Case("NOT 2 R10 R20", "1", false, numbers, false, &[("R20", &[0xF3, 0x0F])]),
        Case("NOT 2 R10 R20", "0", false, numbers, false, &[("R20", &[0, 0])]),
    ]);
}

#[test]
fn jumps_leave_coils_as_they_were() {
    let text = "RD X0.0\nJMP\nRD X0.1\nWRT Y0.0\nJMPE\nRD X0.1\nWRT Y0.1\n";
    let mut plc = second(text);
    put(&mut plc, "X0", &[0b10]);
    plc.scan();
    assert_eq!(bytes(&plc, "Y0", 1), [0b11]);
    put(&mut plc, "X0", &[0b01]);
    plc.scan();
    assert_eq!(bytes(&plc, "Y0", 1), [0b01]);
    // Over two coils.
    let mut plc = second("RD X0.0\nJMP 2\nRD X0.1\nWRT Y0.0\nRD X0.1\nWRT Y0.1\nRD X0.1\nWRT Y0.2\n");
    put(&mut plc, "X0", &[0b11]);
    plc.scan();
    assert_eq!(bytes(&plc, "Y0", 1), [0b100]);
}

#[test]
fn com_turns_its_coils_off() {
    let inside = "RD X0.1\nWRT Y0.0\nRD X0.1\nWRT.NOT Y0.1\nRD X0.1\nSET Y0.2\nRD X0.1\nRST Y0.3\n";
    for text in [format!("RD X0.0\nCOM\n{inside}COME\n"), format!("RD X0.0\nCOM 4\n{inside}")] {
        let mut plc = second(&format!("{text}RD X0.1\nWRT Y0.4\n"));
        put(&mut plc, "Y0", &[0b1000]);
        put(&mut plc, "X0", &[0b11]);
        plc.scan();
        assert_eq!(bytes(&plc, "Y0", 1), [0b1_0101]);
        put(&mut plc, "Y0", &[0b1_1101]);
        put(&mut plc, "X0", &[0b10]);
        plc.scan();
        // Off, the turned one on, SET and RST as they were; outside as ever.
        assert_eq!(bytes(&plc, "Y0", 1), [0b1_1110]);
    }
}

#[test]
fn labels_are_jumped_to_forward_and_back() {
    // Adds 1 to D0 until it is 5.
    let text = "RD X0.0\nJMPB L2\nRD.NOT R9091.1\nRD.STK R9091.1\n\
        LBL L1\nRD.NOT R9091.1\nRD.STK R9091.1\nADDB 1 D0 1 D0\nRD R9091.1\nCOMPB 1 5 D0\nRD.NOT R9000.0\nJMPB 1\n\
        LBL L2\nRD X0.0\nWRT Y0.0\n";
    let text = text.replacen("RD.NOT R9091.1\nRD.STK R9091.1\n", "", 1);
    let mut plc = second(&text);
    assert!(plc.scan().is_round);
    assert_eq!(bytes(&plc, "D0", 1), [5]);
    set(&mut plc, "X0.0", true);
    put(&mut plc, "D0", &[1]);
    plc.scan();
    assert_eq!((bytes(&plc, "D0", 1), get(&plc, "Y0.0")), (vec![1], true));
}

#[test]
fn subprograms_are_called_and_left() {
    let text = "END1\nRD X0.0\nCALL P1\nCALLU P2\nLBL 7\nRD X0.0\nWRT Y0.0\nEND2\n\
        SP P1\nRD X0.1\nWRT Y0.1\nCALLU P3\nRD X0.1\nWRT Y0.2\nSPE\n\
        SP 2\nRD X0.1\nWRT Y0.3\nSPE\n\
        SP 3\nRD X0.1\nWRT Y0.4\nRD X0.2\nJMPC L7\nRD X0.1\nWRT Y0.5\nSPE\nEND\n";
    let mut plc = common::plc(text);
    put(&mut plc, "X0", &[0b010]);
    plc.scan();
    assert_eq!(bytes(&plc, "Y0", 1), [0b00_1000]);
    put(&mut plc, "X0", &[0b011]);
    plc.scan();
    assert_eq!(bytes(&plc, "Y0", 1), [0b11_1111]);
    // Out of P3 and P1 to the label behind both calls.
    let mut plc = common::plc(text);
    put(&mut plc, "X0", &[0b111]);
    plc.scan();
    assert_eq!(bytes(&plc, "Y0", 1), [0b01_0011]);
    assert!(get(&plc, &at("Y0.0").to_string()));
}

#[test]
fn nop_leaves_line_and_signals_as_they_are() {
    let mut plc = second("RD X0.0\nWRT Y0.0\nNOP\nRD.NOT X0.0\nWRT Y0.1\nSUB 70");
    for on in [false, true] {
        set(&mut plc, "X0.0", on);
        run(&mut plc, 1);
        assert_eq!((get(&plc, "Y0.0"), get(&plc, "Y0.1")), (on, !on));
    }
}

#[test]
fn every_function_has_its_row_in_the_manual() {
    let manual = include_str!("../../../docs/plc.md");
    for row in ferrocut_plc::instruction::FUNCTIONS {
        let conditions = if row.conditions.is_empty() { "–".to_owned() } else { row.conditions.join(" ") };
        let line = format!("| `{}` | {} | {conditions} |", row.text, row.number);
        let found = manual.lines().find(|l| l.starts_with(&line));
        // Parameters are told of those that have any.
        let told = found.and_then(|l| l.split('|').nth(4)).map(str::trim);
        assert_eq!(told.map(|t| t == "–"), Some(row.parameters.is_empty()), "{line}");
    }
}
