//! How far the mean of the last positions lags behind the position: the one filter of this room.
//!
//! With the positions `x₀` (now), `x₁` … of the periods before, and a window of `L = n + f` periods, 0 < f ≤ 1,
//!
//! ```text
//! mean = (x₀ + … + xₙ₋₁ + f·xₙ) / L        lag = x₀ − mean
//! ```
//!
//! The mean of a position that moves at constant speed moves at that speed, `v·(L − 1)/2` periods behind. A step
//! of speed becomes a ramp of `L` periods. As its weights are positive and sum up to 1, the mean is nowhere
//! faster than the position, nor is its acceleration or jerk higher.
//!
//! Positions are counted in whole units of 2⁻³⁶ mm: a running sum of whole numbers has no drift, and once the
//! position has stood still for the window the lag is 0, not nearly 0.

/// Units in a millimetre (a degree).
const UNITS: f64 = (1u64 << 36) as f64;

/// Longer than any that a machine file may ask for, periods.
const LONGEST_WINDOW: f64 = 100_000.0;

/// The filter, fed with movements.
#[derive(Clone, Debug)]
pub(crate) struct Average {
    /// The last `n + 1` positions in units; they wrap round, their differences do not.
    ring: Vec<i64>,
    /// Place of the newest.
    at: usize,
    /// Sum of the newest `n`.
    sum: i64,
    /// What of the movements so far is less than a unit, units.
    carry: f64,
    fraction: f64,
    /// 1/(L·units).
    scale: f64,
    /// Periods until every position of the window is the same.
    unsettled: usize,
}

impl Average {
    /// A filter over `window` periods; `None` where that is no more than one, which changes nothing.
    pub fn new(window: f64) -> Option<Average> {
        if window.is_nan() || window <= 1.0 {
            return None;
        }
        let window = window.min(LONGEST_WINDOW);
        let whole = window.ceil() - 1.0;
        Some(Average {
            ring: vec![0; whole as usize + 1],
            at: 0,
            sum: 0,
            carry: 0.0,
            fraction: window - whole,
            scale: (window * UNITS).recip(),
            unsettled: 0,
        })
    }

    /// A filter for windows of up to so many periods, which changes nothing yet.
    pub fn with_capacity(periods: f64) -> Average {
        let mut ring = Vec::with_capacity(periods.clamp(1.0, LONGEST_WINDOW) as usize + 1);
        ring.push(0);
        Average { ring, at: 0, sum: 0, carry: 0.0, fraction: 1.0, scale: UNITS.recip(), unsettled: 0 }
    }

    /// Goes on with another window, from rest. It gets no longer than there is memory for, and no shorter than
    /// a period, which changes nothing.
    pub fn set_window(&mut self, periods: f64) {
        let window = periods.max(1.0).min(self.ring.capacity() as f64);
        let whole = window.ceil() - 1.0;
        self.ring.clear();
        self.ring.resize(whole as usize + 1, 0);
        (self.at, self.sum, self.carry, self.unsettled) = (0, 0, 0.0, 0);
        (self.fraction, self.scale) = (window - whole, (window * UNITS).recip());
    }

    /// Periods of the window.
    pub fn window(&self) -> f64 {
        (self.ring.len() - 1) as f64 + self.fraction
    }

    /// Goes on by one period in which the position moves by `d`; the lag at its end.
    #[inline]
    pub fn push(&mut self, d: f64) -> f64 {
        if d != 0.0 {
            self.unsettled = self.ring.len();
        } else if self.unsettled == 0 {
            return 0.0;
        }
        self.unsettled = self.unsettled.saturating_sub(1);
        let exact = d * UNITS + self.carry;
        let units = exact.round();
        let carry = exact - units;
        // What is no number must not stay.
        self.carry = if carry.abs() <= 1.0 { carry } else { 0.0 };
        let whole = self.ring.len() - 1;
        let newest = self.ring.get(self.at).copied().unwrap_or(0).wrapping_add(units as i64);
        self.at = if self.at < whole { self.at + 1 } else { 0 };
        let Some(place) = self.ring.get_mut(self.at) else { return 0.0 };
        *place = newest;
        // The oldest is the one behind the newest.
        let next = if self.at < whole { self.at + 1 } else { 0 };
        let oldest = self.ring.get(next).copied().unwrap_or(newest);
        self.sum = self.sum.wrapping_add(newest).wrapping_sub(oldest);
        let lag = newest.wrapping_mul(whole as i64).wrapping_sub(self.sum);
        (lag as f64 + self.fraction * newest.wrapping_sub(oldest) as f64) * self.scale
    }

    /// Whether the lag is 0 and stays so.
    pub fn is_at_rest(&self) -> bool {
        self.unsettled == 0
    }

    /// Forgets what is behind: the position stands still from here on.
    pub fn rest(&mut self) {
        let whole = self.ring.len() - 1;
        let newest = self.ring.get(self.at).copied().unwrap_or(0);
        self.ring.fill(newest);
        self.sum = newest.wrapping_mul(whole as i64);
        self.unsettled = 0;
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn a_window_of_one_period_or_less_is_no_filter() {
        for window in [1.0, 0.3, 0.0, -1.0, f64::NAN] {
            assert!(Average::new(window).is_none(), "{window}");
        }
        assert!(Average::new(f64::INFINITY).is_some());
    }

    #[test]
    fn a_step_of_speed_becomes_a_ramp_of_the_window() {
        for (window, periods) in [(4.0, 3), (2.5, 2)] {
            let mut filter = Average::new(window).unwrap();
            let (mut x, mut y) = (0.0, 0.0);
            for k in 1..20 {
                x += 1.0;
                let next = x - filter.push(1.0);
                // The speed after k periods, in parts of the whole: k/L, then 1.
                let speed = (f64::from(k) / window).min(1.0);
                assert!((next - y - speed).abs() < 1e-9, "window {window}, period {k}: {}", next - y);
                y = next;
            }
            assert!((x - y - (window - 1.0) / 2.0 - fraction_lag(window)).abs() < 1e-9);
            // And back to rest, exactly.
            for _ in 0..periods {
                assert!(!filter.is_at_rest());
                y = x - filter.push(0.0);
            }
            assert_eq!((y, filter.push(0.0), filter.is_at_rest()), (x, 0.0, true));
        }
    }

    /// What a window that is no whole number of periods lags beside (L − 1)/2: f(1 − f)/2L.
    fn fraction_lag(window: f64) -> f64 {
        let f = window.fract();
        f * (1.0 - f) / (2.0 * window)
    }

    #[test]
    fn whatever_is_fed_the_end_is_exact() {
        let mut filter = Average::new(7.3).unwrap();
        for k in 0..100_000u32 {
            let lag = filter.push((f64::from(k) * 0.7).sin() * 1e3);
            assert!(lag.abs() < 1e4);
        }
        filter.push(f64::MAX);
        filter.push(f64::NAN);
        for _ in 0..8 {
            filter.push(0.0);
        }
        assert_eq!((filter.push(0.0), filter.is_at_rest()), (0.0, true));
    }
}
