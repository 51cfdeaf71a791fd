//! The cube root: planning takes some for every cell, and the exact one of the library takes half as long as all else there.

/// Where the iteration is good without a closer look at the exponent.
const LEAST: f64 = 1e-290;
const MOST: f64 = 1e290;

/// `∛x`, better than to 1e-13 of itself.
///
/// A third of the exponent is within 5 % (Kahan); each iteration of Halley's takes the third power of what is missing.
#[inline]
pub(crate) fn cube_root(x: f64) -> f64 {
    if !(LEAST..MOST).contains(&x) {
        return x.cbrt();
    }
    let mut root = f64::from_bits(x.to_bits() / 3 + 0x2a9f_7893_0000_0000);
    for _ in 0..2 {
        let cube = root * root * root;
        root *= (cube + 2.0 * x) / (2.0 * cube + x);
    }
    root
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn it_is_the_cube_root() {
        let mut x = 1e-320;
        while x < 1e308 {
            let (root, exact) = (cube_root(x), x.cbrt());
            assert!((root - exact).abs() <= 1e-13 * exact, "{x:e}: {root:e} {exact:e}");
            x *= 1.003;
        }
        for x in [0.0, f64::INFINITY, -8.0] {
            assert_eq!(cube_root(x), x.cbrt());
        }
        assert!(cube_root(f64::NAN).is_nan());
    }
}
