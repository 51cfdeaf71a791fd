//! Decimal numbers as programs write them: digits, at most one point, no exponent.

/// Powers of ten that `f64` holds exactly.
const POWERS: [f64; 23] = [
    1e0, 1e1, 1e2, 1e3, 1e4, 1e5, 1e6, 1e7, 1e8, 1e9, 1e10, 1e11, 1e12, 1e13, 1e14, 1e15, 1e16, 1e17, 1e18,
    1e19, 1e20, 1e21, 1e22,
];

/// An unsigned decimal found at the start of some text.
#[derive(Clone, Copy, PartialEq, Debug)]
pub struct Decimal {
    /// Nearest `f64` to what is written.
    pub value: f64,
    /// Whether a decimal point was written.
    pub point: bool,
    /// Bytes read.
    pub len: usize,
}

/// Reads `12`, `12.5`, `.5` or `5.`; `None` if no digit stands there.
///
/// Up to 15 digits make an integer below 2⁵³ and a power of ten that `f64` holds exactly, so that
/// their quotient is the one rounding (Clinger 1990, the fast path). Longer ones go to the standard
/// library, which rounds correctly too.
#[inline]
pub fn decimal(text: &[u8]) -> Option<Decimal> {
    let mut mantissa = 0u64;
    let mut digits = 0usize;
    let mut fraction = 0usize;
    let mut point = false;
    let mut at = 0;
    while let Some(&byte) = text.get(at) {
        let digit = byte.wrapping_sub(b'0');
        if digit < 10 {
            mantissa = mantissa.wrapping_mul(10).wrapping_add(u64::from(digit));
            digits += 1;
            fraction += usize::from(point);
        } else if byte == b'.' && !point {
            point = true;
        } else {
            break;
        }
        at += 1;
    }
    if digits == 0 {
        return None;
    }
    let value = match POWERS.get(fraction) {
        Some(power) if digits <= 15 => mantissa as f64 / power,
        _ => text.get(..at).and_then(|t| std::str::from_utf8(t).ok()).and_then(|t| t.parse().ok())?,
    };
    Some(Decimal { value, point, len: at })
}

#[cfg(test)]
mod tests {
    use super::*;
    use proptest::prelude::*;

    #[test]
    fn every_form_is_read() {
        for (text, value, point, len) in [
            ("12", 12.0, false, 2),
            ("12.5 ", 12.5, true, 4),
            (".5X", 0.5, true, 2),
            ("5.", 5.0, true, 2),
            ("1.2.3", 1.2, true, 3),
            ("1E5", 1.0, false, 1),
            ("123456789012345678901234567890", 123456789012345678901234567890.0, false, 30),
        ] {
            assert_eq!(decimal(text.as_bytes()), Some(Decimal { value, point, len }), "{text}");
        }
        for text in ["", ".", "X", "-1"] {
            assert_eq!(decimal(text.as_bytes()), None, "{text}");
        }
    }

    proptest! {
        #![proptest_config(ProptestConfig::with_cases(20_000))]
        #[test]
        fn no_number_is_off_by_a_bit(text in "[0-9]{0,12}\\.?[0-9]{0,12}") {
            let std: Option<f64> = text.parse().ok();
            prop_assert_eq!(decimal(text.as_bytes()).map(|d| d.value.to_bits()), std.map(f64::to_bits));
        }
    }
}
