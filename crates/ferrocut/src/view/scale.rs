//! Round numbers of millimetres: for scale bars, ticks and labels.

/// The largest of 1, 2, 5 · 10ⁿ that is not above `limit`; 1 where `limit` is not a positive number.
pub fn round_down(limit: f64) -> f64 {
    if !(limit > 0.0 && limit.is_finite()) {
        return 1.0;
    }
    let decade = 10_f64.powf(limit.log10().floor());
    // A limit that is meant to be 5 may come as 4.999…: half a part in a million decides for it.
    let slack = 1.0 + 5e-7;
    [10.0, 5.0, 2.0, 1.0].into_iter().map(|m| m * decade).find(|v| *v <= limit * slack).unwrap_or(decade)
}

/// The smallest of 1, 2, 5 · 10ⁿ that is not below `limit`.
pub fn round_up(limit: f64) -> f64 {
    let low = round_down(limit);
    [1.0, 2.0, 2.5, 5.0].into_iter().map(|m| round_down(low * m)).find(|v| *v >= limit).unwrap_or(low)
}

/// Most ticks on one axis, whatever its numbers.
const MOST_TICKS: u32 = 200;

/// The multiples of `step` from `low` to `high`.
pub fn ticks(low: f64, high: f64, step: f64) -> impl Iterator<Item = f64> {
    let first = (low / step - 1e-9).ceil();
    let last = high / step + 1e-9;
    (0..MOST_TICKS).map(move |i| first + f64::from(i)).take_while(move |n| *n <= last).map(move |n| n * step)
}

/// Decimals that tell multiples of `step` apart.
pub fn decimals(step: f64) -> usize {
    (0..6).find(|d| step * 10_f64.powi(*d) >= 0.999_999).unwrap_or(6) as usize
}

/// `v` with this many decimals; very large numbers by their power of ten. The minus is as long as a
/// plus, no hyphen.
pub fn fixed(v: f64, decimals: usize) -> String {
    if v.abs() >= 1e9 {
        return format!("{v:.4e}").replace('-', "−");
    }
    let text = format!("{v:.decimals$}");
    match text.strip_prefix('-') {
        // No minus before a zero that rounding left.
        Some(digits) if digits.bytes().all(|b| matches!(b, b'0' | b'.')) => digits.to_owned(),
        Some(digits) => format!("−{digits}"),
        None => text,
    }
}

/// `v` with up to three decimals and no trailing zeros.
pub fn short(v: f64) -> String {
    let text = fixed(v, 3);
    if !text.contains('.') || text.contains('e') {
        return text;
    }
    text.trim_end_matches('0').trim_end_matches('.').to_owned()
}

/// A count with its thousands set apart.
pub fn grouped(n: u64) -> String {
    let digits = n.to_string();
    let mut text = String::new();
    for (i, c) in digits.chars().enumerate() {
        if i > 0 && (digits.len() - i).is_multiple_of(3) {
            text.push(' ');
        }
        text.push(c);
    }
    text
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn round_numbers_are_of_the_1_2_5_series() {
        for (limit, down, up) in [
            (1.0, 1.0, 1.0),
            (1.9, 1.0, 2.0),
            (3.0, 2.0, 5.0),
            (7.0, 5.0, 10.0),
            (99.0, 50.0, 100.0),
            (0.03, 0.02, 0.05),
            (4.5e8, 2e8, 5e8),
        ] {
            assert!((round_down(limit) / down - 1.0).abs() < 1e-9, "down {limit}");
            assert!((round_up(limit) / up - 1.0).abs() < 1e-9, "up {limit}");
        }
        for strange in [0.0, -1.0, f64::NAN, f64::INFINITY] {
            assert_eq!(round_down(strange), 1.0);
        }
    }

    #[test]
    fn ticks_are_few_and_within() {
        assert_eq!(ticks(-1.0, 25.0, 10.0).collect::<Vec<_>>(), [0.0, 10.0, 20.0]);
        assert!(ticks(0.0, 1e12, 1.0).count() <= 200);
        assert_eq!(ticks(f64::NAN, f64::NAN, 1.0).count(), 0);
    }

    #[test]
    fn numbers_are_written_short() {
        assert_eq!(short(12.0), "12");
        assert_eq!(short(100.0), "100");
        assert_eq!(short(-0.125), "−0.125");
        assert_eq!(short(-0.0001), "0");
        assert_eq!(fixed(0.5, decimals(0.05)), "0.50");
        assert_eq!(grouped(1_234_567), "1 234 567");
        assert_eq!(grouped(999), "999");
    }
}
