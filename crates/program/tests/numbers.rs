//! Numbers in every form that the manuals allow, and as exact as `f64` can be.

#![allow(missing_docs, clippy::unwrap_used, clippy::panic)]

mod common;

use common::{MACRO_B, page, show};
use ferrocut_program::Value;
use proptest::prelude::*;

#[test]
fn every_form() {
    for (written, value, point) in [
        ("5", "5", ""),
        ("05", "5", ""),
        ("5.", "5", " point"),
        (".5", "0.5", " point"),
        ("-.5", "-0.5", " point"),
        ("-0.5", "-0.5", " point"),
        ("+1", "1", ""),
        ("+.25", "0.25", " point"),
        ("-5.", "-5", " point"),
        ("-0", "-0", ""),
        ("- 7", "-7", ""),
        (" 7", "7", ""),
        ("99999.9999", "99999.9999", " point"),
        ("0.1234567890123456789", "0.12345678901234568", " point"),
        ("123456789012345678901", "123456789012345680000", ""),
    ] {
        for letter in ["X", "x"] {
            let text = format!("{letter}{written}");
            assert_eq!(show(text.as_bytes(), &MACRO_B), [format!("1 «{text}» X={value}{point} «{text}»")]);
        }
        let text = format!("X{written}Y1");
        let words = format!("X={value}{point} «X{written}» Y=1 «Y1»");
        assert_eq!(show(text.as_bytes(), &MACRO_B), [format!("1 «{text}» {words}")]);
    }
}

#[test]
fn there_is_no_exponent() {
    assert_eq!(show(b"X1E5", &MACRO_B), ["1 «X1E5» X=1 «X1» E=5 «E5»"]);
    assert_eq!(show(b"X1e-5", &MACRO_B), ["1 «X1e-5» X=1 «X1» E=-5 «e-5»"]);
    assert_eq!(show(b"Xinf", &MACRO_B)[0].matches("AddressWithoutNumber").count(), 4);
}

proptest! {
    #![proptest_config(ProptestConfig::with_cases(10_000))]
    #[test]
    fn the_nearest_value_is_read(sign in "[+-]?", digits in "[0-9]{1,20}(\\.[0-9]{0,20})?|\\.[0-9]{1,30}") {
        let text = format!("X{sign}{digits}");
        let page = page(text.as_bytes(), &MACRO_B);
        let expected: f64 = format!("{sign}{digits}").parse().unwrap();
        let Value::Number(found) = page.words[0].value() else { panic!("{text}") };
        prop_assert_eq!(found.to_bits(), expected.to_bits());
        prop_assert_eq!(page.words[0].has_point(), digits.contains('.'));
        prop_assert_eq!(usize::from(page.words[0].len), text.len());
    }
}
