//! What is added to the command of an axis for the errors of its screw.
//!
//! GSK990MC 37#0, P216 to P220 and P226 to P230: points at an even interval, with a number at the reference point.
//! Between two points it is interpolated; beyond the points of the table it stays as it is there, as far as the
//! control has numbers (alarm 0016).
//!
//! With 37#1 there are two tables, one for each direction. An axis that turns back goes from one to the other with
//! acceleration: what is added is `on + w·(back − on)`, and `w` follows a ramp from 0 to 1.

use super::ramp::Ramp;
use crate::stroke::RampLimits;
use ferrocut_machine::{PITCH_POINTS, PitchErrors};

/// Pitch-error compensation of one axis.
#[derive(Clone, Debug)]
pub(crate) struct PitchTable {
    start: f64,
    /// Points a millimetre.
    density: f64,
    /// What is added moving in the positive and in the negative direction, mm.
    points: Box<[[f64; 2]]>,
    /// Where there are two: how much of the second holds.
    back: Option<Ramp>,
}

/// Places that belong to no point: half an interval before the first number and behind the last.
const HALF: f64 = 0.5;

impl PitchTable {
    /// The table within the limits of an axis that moved last in the positive direction, or not. `time` is that
    /// for going from one direction to the other, s; `period` in s. `None` where it has no place or no point.
    pub fn new(
        errors: &PitchErrors,
        is_positive: bool,
        time: f64,
        limits: &RampLimits,
        period: f64,
    ) -> Option<PitchTable> {
        let (start, interval) = (errors.start?, errors.interval.filter(|i| *i > 0.0)?);
        if errors.corrections.is_empty() {
            return None;
        }
        let opposite = if errors.opposite.is_empty() { &errors.corrections } else { &errors.opposite };
        let points: Box<[[f64; 2]]> =
            errors.corrections.iter().zip(opposite).map(|(on, back)| [*on, *back]).collect();
        let widest = points.iter().fold(0.0, |most: f64, [on, back]| most.max((back - on).abs()));
        // The ramp runs from 0 to 1; its limits are those of the axis in parts of the widest difference.
        let parts = RampLimits {
            velocity: limits.velocity / widest,
            acceleration: limits.acceleration / widest,
            jerk: limits.jerk / widest,
        };
        let weight = weight_of(if is_positive { 1.0 } else { -1.0 });
        let back = (widest > 0.0).then(|| Ramp::new(weight, time, 1.0, &parts, period));
        Some(PitchTable { start, density: interval.recip(), points, back })
    }

    /// Goes on by a period to an axis at `at` that moves in the direction `side`, 1 or −1; what is added there.
    #[inline]
    pub fn tick(&mut self, at: f64, side: f64) -> f64 {
        if let Some(ramp) = &mut self.back {
            ramp.tick(weight_of(side));
        }
        self.added(at)
    }

    /// What is added to an axis at `at`.
    #[inline]
    pub fn added(&self, at: f64) -> f64 {
        let last = self.points.len() - 1;
        let place = ((at - self.start) * self.density).clamp(0.0, last as f64);
        let below = (place as usize).min(last);
        let rest = place - below as f64;
        let point = |i: usize| self.points.get(i).copied().unwrap_or_default();
        let ([on, back], [next_on, next_back]) = (point(below), point((below + 1).min(last)));
        let on = on + rest * (next_on - on);
        let back = back + rest * (next_back - back);
        let weight = self.back.as_ref().map_or(0.0, Ramp::value);
        on + weight * (back - on)
    }

    /// Whether the control has no number of a point at `at`.
    #[inline]
    pub fn is_beside(&self, at: f64) -> bool {
        let number = (at - self.start) * self.density;
        number < -HALF || number > PITCH_POINTS as f64 - HALF
    }

    /// The nearest place to 0 at which the numbers end: machine position, mm.
    pub fn end(&self) -> f64 {
        let (first, last) = (self.start, self.start + (PITCH_POINTS as f64 - 1.0) / self.density);
        if first.abs() < last.abs() { first } else { last }
    }
}

/// How much of the table of the negative direction holds while an axis moves in the direction `side`.
fn weight_of(side: f64) -> f64 {
    if side < 0.0 { 1.0 } else { 0.0 }
}

#[cfg(test)]
mod tests {
    use super::*;

    const LIMITS: RampLimits = RampLimits { velocity: 100.0, acceleration: 1000.0, jerk: 1e5 };

    fn errors(opposite: &[f64]) -> PitchErrors {
        PitchErrors {
            start: Some(-10.0),
            interval: Some(10.0),
            corrections: vec![0.01, 0.03, -0.01],
            opposite: opposite.to_vec(),
        }
    }

    #[test]
    fn between_points_it_is_interpolated_and_beyond_them_constant() {
        let mut table = PitchTable::new(&errors(&[]), true, 0.02, &LIMITS, 0.001).unwrap();
        // Before the first point the numbers end; a quarter of an interval is still its own.
        for (at, added) in
            [(-12.5, 0.01), (-10.0, 0.01), (-5.0, 0.02), (0.0, 0.03), (7.5, 0.0), (10.0, -0.01)]
        {
            let found = table.tick(at, 1.0);
            assert!((found - added).abs() < 1e-15 && !table.is_beside(at), "{at}: {found:?}");
            assert_eq!(table.tick(at, -1.0), found);
        }
        assert_eq!((table.tick(500.0, 1.0), table.is_beside(500.0)), (-0.01, false));
        // 0016: number −0.6, and number 9999.6.
        assert_eq!((table.tick(-16.0, 1.0), table.is_beside(-16.0)), (0.01, true));
        assert!(table.is_beside(-10.0 + 99_996.0) && !table.is_beside(-10.0 + 99_990.0));
        assert_eq!(table.end(), -10.0);
    }

    #[test]
    fn the_other_direction_has_a_table_of_its_own() {
        let errors = errors(&[0.02, 0.05, 0.0]);
        let mut table = PitchTable::new(&errors, true, 0.02, &LIMITS, 0.001).unwrap();
        assert_eq!(table.tick(0.0, 1.0), 0.03);
        let mut before = 0.03;
        for _ in 0..60 {
            let added = table.tick(0.0, -1.0);
            assert!(added >= before && added <= 0.05, "{added}");
            before = added;
        }
        assert_eq!(before, 0.05);
        assert_eq!(PitchTable::new(&errors, false, 0.02, &LIMITS, 0.001).unwrap().added(0.0), 0.05);
    }

    #[test]
    fn a_table_without_place_is_none() {
        for errors in [
            PitchErrors { start: None, ..errors(&[]) },
            PitchErrors { interval: None, ..errors(&[]) },
            PitchErrors { corrections: Vec::new(), ..errors(&[]) },
        ] {
            assert!(PitchTable::new(&errors, true, 0.02, &LIMITS, 0.001).is_none());
        }
    }
}
