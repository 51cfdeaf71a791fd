//! How many passes a width or a depth takes.
//!
//! ```text
//! width   n = ⌈span/Δ⌉ passes of span/n: all equal, none above Δ              (Fagor 4.15)
//! depth   I > 0: n = ⌈P/I⌉ levels of P/n;  I < 0: levels of |I|, the last takes the rest
//! ```
//!
//! Neither goes deeper at once than the cutting length of the tool; I = 0 stands for it (4.1.3).

use super::problem::{MAX_PASSES, PocketFault, Problem, in_range};
use crate::cycles::depth::Levels;
use crate::cycles::milling::steps;

/// Number and width of the equal passes over a span.
pub(crate) fn equal(span: f64, widest: f64) -> (u32, f64) {
    let count = if span > 0.0 { steps(span, widest).min(MAX_PASSES) } else { 1.0 };
    (count as u32, span.max(0.0) / count)
}

/// The width of a pass Δ: 0 stands for three quarters of the tool's diameter (4.15); not above it.
pub(crate) fn width(step: f64, radius: f64, parameter: &'static str) -> Result<f64, PocketFault> {
    let step = in_range(step, parameter)?;
    Problem::Negative.when(step < 0.0, parameter)?;
    Problem::StepTooLarge.when(step > 2.0 * radius + 1e-7, parameter)?;
    Ok(if step == 0.0 { 1.5 * radius } else { step })
}

/// Levels of I over a depth.
pub(crate) fn levels(
    depth: f64,
    step: f64,
    cutting_length: f64,
    parameter: &'static str,
) -> Result<Levels, PocketFault> {
    let step = in_range(step, parameter)?;
    let longest = if cutting_length > 0.0 { cutting_length } else { f64::INFINITY };
    let wanted = if step == 0.0 { longest } else { step.abs().min(longest) };
    Problem::DepthStepMissing.when(!wanted.is_finite(), parameter)?;
    let levels = Levels::fewest(depth, wanted, step < 0.0);
    Problem::TooManyMoves.when(levels.count() > MAX_PASSES, parameter)?;
    Ok(levels)
}

/// N equal levels; 0 stands for the fewest that the cutting length allows, which also bounds the others
/// (4.1.3, 4.15).
pub(crate) fn equal_levels(
    depth: f64,
    count: f64,
    cutting_length: f64,
    parameter: &'static str,
) -> Result<Levels, PocketFault> {
    let count = in_range(count, parameter)?;
    Problem::Negative.when(count < 0.0, parameter)?;
    let fewest = if cutting_length > 0.0 { steps(depth, cutting_length) } else { 1.0 };
    let count = count.round().max(fewest);
    Problem::TooManyMoves.when(count > MAX_PASSES, parameter)?;
    Ok(Levels::equal(depth, count))
}

#[cfg(test)]
mod tests {
    use super::*;

    fn depths(depth: f64, step: f64, cutting_length: f64) -> Vec<f64> {
        levels(depth, step, cutting_length, "I").unwrap().depths().collect()
    }

    #[test]
    fn levels_by_hand() {
        assert_eq!(depths(9.5, 5.0, 30.0), [4.75, 9.5]);
        assert_eq!(depths(8.0, -3.0, 30.0), [3.0, 6.0, 8.0]);
        assert_eq!(depths(20.0, 0.0, 8.0), [20.0 / 3.0, 40.0 / 3.0, 20.0]);
        assert_eq!(depths(9.0, -5.0, 3.0), [3.0, 6.0, 9.0]);
        assert_eq!(depths(1.1, 0.1, 0.0).len(), 11);
        assert_eq!(depths(3.0, 9.0, 0.0), [3.0]);
        assert_eq!(levels(3.0, 0.0, 0.0, "I").unwrap_err().problem, Problem::DepthStepMissing);
        let walls = |n, cl| equal_levels(8.0, n, cl, "N").unwrap().depths().collect::<Vec<_>>();
        assert_eq!(walls(2.0, 30.0), [4.0, 8.0]);
        assert_eq!(walls(0.0, 3.0).len(), 3);
        assert_eq!(walls(0.0, 0.0), [8.0]);
        assert_eq!(walls(2.0, 2.0), [2.0, 4.0, 6.0, 8.0]);
    }

    #[test]
    fn widths() {
        assert_eq!(equal(20.0, 7.0), (3, 20.0 / 3.0));
        assert_eq!(equal(0.0, 7.0), (1, 0.0));
        assert_eq!(width(0.0, 4.0, "step").unwrap(), 6.0);
        assert_eq!(width(8.0, 4.0, "step").unwrap(), 8.0);
        assert_eq!(width(8.1, 4.0, "step").unwrap_err().problem, Problem::StepTooLarge);
    }
}
