//! How many steps a distance takes.

/// A quotient this little above a whole number is that number: 1.1 / 0.1 is eleven steps, not twelve.
const ROUNDING: f64 = 1e-9;

/// Steps of at most `step` that cover `distance`, at least 1; a float, since nonsense words ask for more
/// than any integer holds.
pub(crate) fn steps(distance: f64, step: f64) -> f64 {
    (distance / step - ROUNDING).ceil().max(1.0)
}
