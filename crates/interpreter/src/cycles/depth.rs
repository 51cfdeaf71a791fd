//! Levels of a depth that is cut in passes (Fagor 1.8, 4.11).

use super::milling::steps;
use super::parameter::{WrongParameter, refuse};
use ferrocut_machine::Fault;

/// Most passes of a depth; a step that needs more is a slip of the pen.
pub const MAX_LEVELS: f64 = 10_000.0;

/// How a depth is divided.
#[derive(Clone, Copy, PartialEq, Debug)]
pub struct Levels {
    depth: f64,
    /// Depth of a pass that is kept exactly, the last one taking the rest; else all are equal.
    exact: Option<f64>,
    count: f64,
}

impl Levels {
    /// Passes of at most `step`: positive, it is recalculated so that all are equal; negative, it is kept.
    pub fn by_step(depth: f64, step: f64, word: &'static str) -> Result<Levels, WrongParameter> {
        let size = step.abs();
        refuse(!(size > 0.0 && size.is_finite()), Fault::CycleParameter, word)?;
        refuse(!(depth > 0.0 && depth.is_finite()), Fault::CycleNoDepth, word)?;
        let levels = Levels::fewest(depth, size, step < 0.0);
        refuse(!(levels.count <= MAX_LEVELS), Fault::MillTooManyMoves, word)?;
        Ok(levels)
    }

    /// The fewest passes of at most `size`: all equal, or each but the last of just that size. How many that
    /// may be is the caller's to check.
    pub fn fewest(depth: f64, size: f64, is_kept: bool) -> Levels {
        Levels { depth, exact: is_kept.then_some(size), count: steps(depth, size) }
    }

    /// The same limited to the cutting length of the tool, which also stands for a step of 0 (4.1.3).
    pub fn within(
        depth: f64,
        step: f64,
        cutting_length: f64,
        word: &'static str,
    ) -> Result<Levels, WrongParameter> {
        if step == 0.0 {
            refuse(cutting_length <= 0.0, Fault::CycleNoCuttingLength, word)?;
            return Levels::by_step(depth, cutting_length, word);
        }
        let limited = if cutting_length > 0.0 { step.abs().min(cutting_length) } else { step.abs() };
        Levels::by_step(depth, limited.copysign(step), word)
    }

    /// So many equal passes, [`MAX_LEVELS`] at most.
    pub fn equal(depth: f64, count: f64) -> Levels {
        Levels { depth, exact: None, count: count.clamp(1.0, MAX_LEVELS) }
    }

    /// Depth of the last pass.
    pub fn deepest(&self) -> f64 {
        self.depth
    }

    /// The same passes, the last one to this depth.
    pub fn down_to(self, depth: f64) -> Levels {
        let step = self.exact.unwrap_or(self.depth / self.count);
        Levels { depth, exact: Some(step), count: self.count }
    }

    /// Number of passes.
    pub fn count(&self) -> f64 {
        self.count
    }

    /// Depths of the passes, from the top.
    pub fn depths(self) -> impl Iterator<Item = f64> {
        let count = self.count as u32;
        (1..=count).map(move |pass| match (self.exact, pass == count) {
            (_, true) => self.depth,
            // Products and not sums, so that a thousand passes end where the drawing says.
            (Some(step), _) => f64::from(pass) * step,
            (None, _) => self.depth * f64::from(pass) / f64::from(count),
        })
    }
}

#[cfg(test)]
mod tests {
    #![allow(clippy::unwrap_used)]
    use super::*;

    fn depths(levels: Levels) -> Vec<f64> {
        levels.depths().collect()
    }

    #[test]
    fn a_positive_step_is_recalculated_and_a_negative_one_kept() {
        assert_eq!(depths(Levels::by_step(10.0, 4.0, "B").unwrap()), [10.0 / 3.0, 20.0 / 3.0, 10.0]);
        assert_eq!(depths(Levels::by_step(13.0, -5.0, "B").unwrap()), [5.0, 10.0, 13.0]);
        assert_eq!(depths(Levels::by_step(12.0, -4.0, "B").unwrap()), [4.0, 8.0, 12.0]);
        assert_eq!(depths(Levels::by_step(3.0, 0.1 * 10.0, "B").unwrap()), [1.0, 2.0, 3.0]);
        assert_eq!(depths(Levels::equal(10.0, 2.0)), [5.0, 10.0]);
        assert_eq!(depths(Levels::by_step(9.5, -4.0, "B").unwrap().down_to(10.0)), [4.0, 8.0, 10.0]);
        assert_eq!(depths(Levels::by_step(9.0, 4.0, "B").unwrap().down_to(10.0)), [3.0, 6.0, 10.0]);
    }

    #[test]
    fn the_cutting_length_limits_a_step_and_stands_for_none() {
        assert_eq!(depths(Levels::within(7.5, 0.0, 5.0, "I").unwrap()), [3.75, 7.5]);
        assert_eq!(depths(Levels::within(7.5, -9.0, 5.0, "I").unwrap()), [5.0, 7.5]);
        assert_eq!(depths(Levels::within(7.5, 9.0, 0.0, "I").unwrap()), [7.5]);
        let missing = Levels::within(7.5, 0.0, 0.0, "I").unwrap_err();
        assert_eq!((missing.fault, missing.word), (Fault::CycleNoCuttingLength, "I"));
        assert!(Levels::by_step(0.0, 1.0, "I").is_err());
        assert!(Levels::by_step(1.0, f64::NAN, "I").is_err());
        assert_eq!(Levels::by_step(5.0, 1e-9, "I").unwrap_err().fault, Fault::MillTooManyMoves);
    }
}
