//! The macro language beside its functions: precision, system variables, calls. Numbers are sections of
//! "GSK990MC programming and operation".
#![allow(missing_docs, clippy::unwrap_used, clippy::panic)]

mod common;

use common::{holds, holds_with};
use ferrocut_interpreter::Options;

/// The value that a program leaves in #500.
fn leaves(program: &str) -> Option<f64> {
    leaves_with("", program)
}

fn leaves_with(setup: &str, program: &str) -> Option<f64> {
    let text = format!("{program}\nM30\n");
    let mut interpreter = common::interpreter(text.as_bytes(), setup, Options::default()).unwrap();
    for step in &mut interpreter {
        step.unwrap_or_else(|alarm| panic!("{program}: {alarm:?}"));
    }
    interpreter.memory().variables.get(500)
}

#[test]
fn values_are_told_apart_by_ten_thousandths() {
    // 4.9.2, 5.
    for (program, value) in [
        ("#1=0\n#500=0\nWHILE[#1LT1]DO1\n#1=#1+0.1\n#500=#500+1\nEND1", 10.0),
        ("#1=0\nN1 #1=#1+0.1\nG65 H84 P1 Q#1 R1\n#500=#1", 1.0),
        ("#1=0\nN1 #1=#1+0.1\nIF[#1NE0.8]GOTO1\n#500=#1", 0.8),
        ("#500=FIX[SIN[30]*10]", 5.0),
        ("#500=FIX[0.6/0.2]", 3.0),
        ("#500=FIX[0.29*100]", 29.0),
        ("#500=FUP[0.1*3*10]", 3.0),
        ("#500=0.3/0.1AND3", 3.0),
        ("#3=7\n#1=0.3/0.1\n#500=#[#1]", 7.0),
        ("#1=1.1*100\nGOTO#1\n#500=1\nN110", f64::NAN),
        ("#500=1/3", 0.3333),
        // What is put in may have fifteen digits, a result nine before the point, in between as many as it has.
        ("#500=123456789012345", 123_456_789_012_345.0),
        ("#500=999999998.5+1", 999_999_999.5),
        ("#500=100000*100000/100000", 100_000.0),
        ("#500=SQRT[40000*40000+30000*30000]", 50_000.0),
        ("#500=[100000*100000GT1]*2", 2.0),
        ("#500=100000\nG65 H26 P#500 Q100000 R100000", 100_000.0),
        // Table 4-9-5-2: up to about 11.5129.
        ("#500=FIX[EXP[11.5129]]", 99_997.0),
        // An empty index is that of #0, which is empty; with another value it takes part as 0 (4.9.2, 7).
        ("#500=#[#1]", f64::NAN),
        ("#500=#[#1]+2", 2.0),
    ] {
        assert_eq!(leaves(program), Some(value).filter(|v| !v.is_nan()), "{program}");
    }
    // A code is as whole as its neighbour.
    holds(&[("#1=0.3/0.1\nG#1 X10 R5", &["xy X10 about 5 0 by 180 F300"])]);
}

#[test]
fn positions_and_feed_are_in_the_unit_of_the_program() {
    assert_eq!(leaves("G20 G0 X1 A9\n#500=#5001"), Some(1.0));
    assert_eq!(leaves("G20 G0 X1\n#500=#5006"), Some(1.0));
    assert_eq!(leaves("G20 G0 A9\n#500=#5004"), Some(9.0));
    assert_eq!(leaves("G20 F10\n#500=#4024"), Some(10.0));
    // Offsets and work zeros are written and read in it too (4.2.17), as G10 has them.
    assert_eq!(leaves("G20 G0 X1\n#5206=#5001\nG0 X0\n#500=#5206"), Some(1.0));
    assert_eq!(leaves("G20\n#5206=1\nG21\n#500=#5206"), Some(25.4));
    assert_eq!(leaves("G20\nG10 L10 P1 R1\n#1=#1501\nG21\n#500=#1501+#1"), Some(26.4));
    assert_eq!(leaves("G20\n#2101=0.4\nG21\n#500=#2101"), Some(10.16));
    // As programmed, whatever the control's limits make of it.
    assert_eq!(leaves("F8000\n#500=#4024"), Some(8000.0));
    assert_eq!(leaves("S9000\n#500=#4026"), Some(9000.0));
}

#[test]
fn variables_of_what_is_in_force() {
    // Table 4-9-2-2.
    assert_eq!(leaves("#500=#4000"), Some(11.0));
    assert_eq!(leaves("G10 L2 P1 X0\n#500=#4000"), Some(10.0));
    assert_eq!(leaves("G10 L51\nG11\n#500=#4000"), Some(11.0));
    assert_eq!(leaves("O12\nM98 P77\n#500=#4029\nM30\nO77\nG0 X1\nM99"), Some(12.0));
    assert_eq!(leaves("N15 #1=1\n#500=#4028"), Some(15.0));
    assert_eq!(leaves("N16 G65 H01 P#1 Q1\n#500=#4028"), Some(16.0));
    assert_eq!(leaves("H5\n#500=#4023"), Some(5.0));
    // Table 4-9-2-3: without a signal the end of the block.
    assert_eq!(leaves("G31 X90 F100\n#500=#5016"), Some(90.0));
    // The tool's place, compensation included.
    let radius = "[tools.1]\nradius = 5\n[parameters]\n\"NO40.7\" = 0";
    assert_eq!(leaves_with(radius, "G41 D1 G1 X20 F100\nX40\n#500=#5007\nX50\nG40 X60"), Some(5.0));
}

#[test]
fn an_empty_variable_takes_its_address_with_it() {
    // 4.9.2, 7 a: the sign too.
    holds(&[("G0 X50\nX-#1 Y5", &["rapid X50", "rapid Y5"])]);
    holds(&[("#1=3\nG0 X-#1", &["rapid X-3"])]);
    holds_with("", "G65 P77 X-#1 Y-#1\nM30\nO77\nIF[#24EQ#0]GOTO9\nG0 X1\nN9 M99", &[]);
}

#[test]
fn words_of_an_operation_stand_on_either_side_of_its_code() {
    // 4.9.2 note 3: whatever their size.
    assert_eq!(leaves("P#500 H01 G65 Q4"), Some(4.0));
    assert_eq!(leaves("Q1000000000 H01 G65 P#500"), Some(1e9));
}

#[test]
fn interface_signals_and_the_table_of_the_builder() {
    let value = |program: &str| {
        let text = format!("{program}\nM30\n");
        let setup = "[variables]\n\"#3500\" = 7";
        let mut interpreter = common::interpreter(text.as_bytes(), setup, Options::default()).unwrap();
        for input in [1000, 1003] {
            interpreter.set_input(input, 1.0);
        }
        assert!(interpreter.all(|step| step.is_ok()), "{program}");
        interpreter.memory().variables.get(500)
    };
    assert_eq!(value("#500=#1003"), Some(1.0));
    assert_eq!(value("#500=#1032"), Some(9.0));
    assert_eq!(value("#1100=1\n#500=#1100"), Some(1.0));
    assert_eq!(value("#500=#3500"), Some(7.0));
}
