//! What is no ladder is told by the control's alarm and the line.
#![allow(missing_docs, clippy::unwrap_used)]

mod common;

use common::faults;

const OK: &str = "RD X0.0\nWRT R0.0\n";

/// The faults of networks in level 2, lines counted from the first of them.
fn second(networks: &str) -> Vec<(u16, u32)> {
    faults(&format!("END1\n{networks}\nEND2\n")).into_iter().map(|(n, line)| (n, line - 1)).collect()
}

#[test]
fn each_fault_has_its_alarm_and_line() {
    let table: &[(&str, u16, u32)] = &[
        ("RD X0.0\nAND\nWRT R0.0", 1001, 2),
        ("RD X0.0\nWRT", 1001, 2),
        ("RD X0.0\nFOO R0.0", 1002, 2),
        ("RD X0.0\nSUB 99 1\nWRT R0.0", 1002, 2),
        ("RD X0.0\nWRTT R0.0", 1002, 2),
        ("RD X0.0\nCOM\nRD X0.1\nWRT R0.0", 1003, 2),
        ("RD X0.0\nWRT R0.0\nCOME", 1003, 3),
        ("RD X0.0\nCOM\nRD X0.1\nMOVB R1 R2\nCOME", 1003, 4),
        ("RD X0.1\nJMP\nRD X0.0\nCOM\nRD X0.1\nWRT R0.0\nJMPE\nCOME", 1003, 7),
        ("RD X0.0\nCOM\nRD X0.0\nCOM\nRD X0.1\nWRT R0.0\nCOME", 1003, 4),
        ("RD X0.0\nCOM 2\nRD X0.1\nWRT R0.0", 1003, 2),
        ("END1", 1005, 1),
        ("RD X0.0\nWRT X1.0", 1006, 2),
        ("RD X0.0\nSET F1.0", 1006, 2),
        ("RD X0.0\nWRT R9091.0", 1006, 2),
        ("RD X0.0\nMOVB R1 R2\nWRT R0.0", 1006, 3),
        ("RD X0.0\nRD.STK X0.1\nCTR 1\nWRT R0.0", 1008, 3),
        ("RD X0.0\nWRT R0.0\nTMR 1\nWRT R0.1", 1008, 3),
        ("MOVB R1 R2", 1008, 1),
        ("AND X0.0\nWRT R0.0", 1009, 1),
        ("WRT R0.0", 1009, 1),
        ("RD X0.0\nMOVE 11 0000 R1 R2", 1011, 2),
        ("RD X0.0\nMOVE 1111 0020 R1 R2", 1011, 2),
        ("RD X0.0\nMOVB R1.0 R2", 1011, 2),
        ("RD X0.0\nMOVB 5 R2", 1011, 2),
        ("RD X0.0\nMOVB R1 X2", 1011, 2),
        ("RD X0.0\nMOVB R1 R2 R3", 1011, 2),
        ("RD X0.0\nNUMEB 3 1 R2", 1011, 2),
        ("RD X0.0\nCOMPB 1003 R1 R2", 1011, 2),
        ("RD X0.0\nTMR R1\nWRT R0.0", 1011, 2),
        ("RD X0.0\nRD.STK X0.1\nAND.STK R1.0\nWRT R0.0", 1011, 3),
        ("RD X0.0 X0.1\nWRT R0.0", 1011, 1),
        ("RD X0.8\nWRT R0.0", 1012, 1),
        ("RD X0\nWRT R0.0", 1012, 1),
        ("RD START\nWRT R0.0", 1012, 1),
        ("RD 5\nWRT R0.0", 1012, 1),
        ("RD X0.0\nNUMEB 1 1.5 R2", 1012, 2),
        ("START = X0.9\nRD X0.0\nWRT R0.0", 1012, 1),
        ("R0.0 = X0.0\nRD X0.0\nWRT R0.0", 1012, 1),
        ("RD X200.0\nWRT R0.0", 1013, 1),
        ("RD X0.0\nWRT R8000.0", 1013, 2),
        ("RD X0.0 !\nWRT R0.0", 1013, 1),
        (
            "RD X0.0\nRD.STK X0.0\nRD.STK X0.0\nRD.STK X0.0\nCTR 1\nRD X0.0\nRD.STK X0.0\nRD.STK X0.0\nRD.STK X0.0\nCTR 1",
            1014,
            10,
        ),
        ("RD X0.0\nJMP\nRD X0.1\nWRT R0.0", 1015, 2),
        ("RD X0.0\nWRT R0.0\nJMPE", 1015, 3),
        ("RD X0.0\nJMP\nRD X0.1\nJMP\nRD X0.1\nWRT R0.0\nJMPE", 1015, 4),
        ("RD X0.0\nJMP 2\nRD X0.1\nWRT R0.0", 1015, 2),
        ("RD X0.0\nJMPB L1", 1015, 2),
        ("LBL 1\nLBL 1", 1015, 2),
        ("LBL 1\nRD X0.0\nJMPC L1", 1015, 3),
        ("RD X0.0\nRD X0.1\nWRT R0.0", 1016, 1),
        ("RD X0.0\nRD.STK X0.1\nWRT R0.0", 1016, 3),
        ("RD X0.0\nWRT R0.0\nAND X0.1\nRD X0.0\nWRT R0.1", 1016, 1),
        ("RD X0.0\nWRT R0.0\nAND X0.1", 1024, 1),
        ("RD X0.0\nTMR 1\nWRT R0.0\nRD X0.0\nTMR 1\nWRT R0.1", 1019, 5),
        ("RD X0.0\nTMRB 1 8\nWRT R0.0\nRD X0.0\nTMRB 1 9\nWRT R0.1", 1019, 5),
        ("RD X0.0\nMOVB R1", 1020, 2),
        ("RD X0.0\nTMR\nWRT R0.0", 1020, 2),
        ("RD X0.0\nRD.STK X0.0\nCODB 1 3 R0 R1\n1 2", 1020, 3),
        ("RD X0.0\nSUB", 1022, 2),
        ("RD X0.0\nTMR 251\nWRT R0.0", 1023, 2),
        ("RD X0.0\nTMR 0\nWRT R0.0", 1023, 2),
        ("RD X0.0\nMOVD R7997 R2", 1023, 2),
        ("RD X0.0\nMOVN 100 D9901 R2", 1023, 2),
        ("RD X0.0\nNUMEB 1 256 R2", 1023, 2),
        ("RD X0.0\nNUMEB 4 99999999999999999999 R2", 1023, 2),
        ("RD X0.0\nLBL 1", 1024, 1),
        ("RD X0.0\nRD.STK X0.1\nMOVB R1 R2", 1024, 1),
        ("RD X0.0\nTMR 1\nRD X0.0\nWRT R0.0", 1025, 2),
        ("RD X0.0\nDIFU 1\nAND X0.1\nWRT R0.0", 1025, 2),
        ("RD X0.0\nWRT R0.0\nRD X0.1\nWRT R0.0", 1027, 4),
        ("RD X0.0\nWRT R0.0\nRD X0.1\nWRT.NOT R0.0", 1027, 4),
        ("RD X0.0\nAND.STK\nWRT R0.0", 1030, 2),
        ("RD X0.0\nDIFU 7\nWRT R0.0\nRD X0.1\nDIFD 7\nWRT R0.1", 1034, 5),
        ("RD X0.0\nCALL P1", 1040, 2),
        ("SP 1\nRD X0.0\nWRT R0.0\nSPE", 1040, 1),
    ];
    for (networks, number, line) in table {
        let found = second(networks);
        assert!(found.contains(&(*number, *line)), "{number} in line {line}: {found:?}\n{networks}");
        assert!(found.len() <= 2, "{found:?}\n{networks}");
    }
}

#[test]
fn what_surrounds_the_levels_is_told() {
    for (text, number, line) in [
        (format!("{OK}END2\n"), 1005, 3),
        (format!("{OK}END1\n"), 1005, 3),
        (OK.to_owned(), 1005, 2),
        (format!("END1\nEND2\n{OK}"), 1039, 3),
        (format!("END1\nEND2\nEND\n{OK}"), 1039, 4),
        (format!("END1\nEND2\nSP 1\n{OK}SPE\n"), 1005, 6),
        (format!("END1\nEND2\nSP 1\n{OK}END\n"), 1040, 6),
        (format!("END1\nEND2\nSP 1\n{OK}SPE\nSP 1\nSPE\nEND\n"), 1040, 7),
        (format!("END1\nEND2\nSP 1\n{OK}SP 2\nSPE\nEND\n"), 1040, 6),
        ("END1\nCALLU 1\nEND2\nSP 1\nCALLU 1\nSPE\nEND\n".to_owned(), 1040, 2),
        ("END1\nCALLU 1\nEND2\nSP 1\nCALLU 2\nSPE\nSP 2\nCALLU 1\nSPE\nEND\n".to_owned(), 1040, 2),
        // A label of the other level.
        ("CALLU 1\nEND1\nLBL 1\nEND2\nSP 1\nRD X0.0\nJMPC 1\nSPE\nEND\n".to_owned(), 1015, 7),
        (String::new(), 1028, 1),
        ("; nothing\n".to_owned(), 1028, 1),
        ("RD X0.0\n\0\0\n".to_owned(), 1028, 2),
    ] {
        let found = faults(&text);
        assert!(found.contains(&(number, line)), "{number} in line {line}: {found:?}\n{text}");
    }
}

#[test]
fn what_is_too_large_is_told() {
    let many = |n: u32, network: &dyn Fn(u32) -> String| (0..n).map(network).collect::<String>();
    // 2,501 steps of level 1: two a network, and END1 is none.
    let coils = many(1251, &|n| format!("RD X0.0\nWRT R{}.{}\n", n / 8, n % 8));
    assert_eq!(faults(&format!("{coils}END1\nEND2\n")), [(1032, 2503)]);
    assert_eq!(faults(&format!("END1\n{coils}END2\n")), []);
    // 24,000 steps in all.
    let coils = many(12_001, &|n| format!("RD X0.0\nWRT R{}.{}\n", n / 8, n % 8));
    assert_eq!(faults(&format!("END1\n{coils}END2\n")), [(1004, 24_004)]);
    let shifts = many(257, &|_| "RD X0.0\nRD.STK X0.0\nRD.STK X0.0\nRD.STK X0.0\nSFT R0\n".to_owned());
    assert_eq!(second(&shifts), [(1033, 257 * 5)]);
    let table = "1 ".repeat(256);
    let tables = many(17, &|_| format!("RD X0.0\nRD.STK X0.0\nCODB 1 256 R0 R1 {table}\n"));
    assert_eq!(second(&tables), [(1031, 17 * 3)]);
    let rows = many(256, &|_| "OR X0.1\n".to_owned());
    assert_eq!(second(&format!("RD X0.0\n{rows}WRT R0.0\n")), [(1026, 257)]);
    // ST0 and eight that wait.
    let deep =
        |n: usize| format!("RD X0.0\n{}{}WRT R0.0\n", "RD.STK X0.1\n".repeat(n), "AND.STK\n".repeat(n));
    assert_eq!(second(&deep(8)), []);
    assert_eq!(second(&deep(9)), [(1017, 10), (1030, 19)]);
    // Nine subprograms that call one another.
    let nested = |n: u32| {
        let subprograms = many(n, &|k| match k + 1 < n {
            true => format!("SP {}\nCALLU {}\nSPE\n", k + 1, k + 2),
            false => format!("SP {}\n{OK}SPE\n", k + 1),
        });
        format!("END1\nCALLU 1\nEND2\n{subprograms}END\n")
    };
    assert_eq!(faults(&nested(8)), []);
    assert_eq!(faults(&nested(9)), [(1040, 2)]);
}

#[test]
fn texts_beyond_all_measure_are_refused_at_once() {
    let begun = std::time::Instant::now();
    for line in ["SP 1\nSPE\n", "1\n", "RD X0.0\n", "RD X0.9\n", "A = X0.0\n", "TMR 1 1 1 1 1\n", "LBL 1\n"] {
        let most = (4 << 20) / line.len();
        assert!(!faults(&format!("END1\n{}", line.repeat(most - 10))).is_empty());
    }
    assert_eq!(faults(&"RD X0.0\n".repeat(1 << 20)), [(1028, 1)]);
    // No measure of speed: what grows with the square of the text would take hours.
    assert!(begun.elapsed().as_secs() < 300);
}

#[test]
fn signals_may_have_names() {
    let text = "START = X20.3 ; cycle start\nST = G7.2\nEND1\nRD START\nWRT ST\nEND2\n";
    let mut plc = common::plc(text);
    common::set(&mut plc, "X20.3", true);
    plc.scan();
    assert!(common::get(&plc, "G7.2"));
    let program = plc.program();
    assert_eq!(program.signal("ST"), Some(common::at("G7.2")));
    assert_eq!(program.signal("X20.3"), Some(common::at("X20.3")));
    assert_eq!((program.signal("START2"), program.symbols()[0].meaning.as_str()), (None, "cycle start"));
    assert_eq!(faults("A = X0.0\nA = X0.1\nEND1\nEND2\n"), [(1012, 2)]);
    assert_eq!(faults("TMR = X0.0\nEND1\nEND2\n"), [(1012, 1)]);
    assert_eq!(faults("A = X0.0 X0.1\nEND1\nEND2\n"), [(1012, 1)]);
}

#[test]
fn every_fault_of_a_text_is_told_in_order() {
    let text = "RD X0.9\nWRT R0.0\nFOO\nEND1\nRD X0.0\nTMR 999\nWRT R0.1\nRD X0.0\nWRT F0.0\nEND2\n";
    assert_eq!(faults(text), [(1012, 1), (1002, 3), (1023, 6), (1006, 9)]);
}
