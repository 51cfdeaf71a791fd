//! What every axis can do, and what that allows on a piece of path.
//!
//! On a path `q(s)` run at speed `v` and path acceleration `a`, axis `i` has the velocity `q'ᵢ·v` and the
//! acceleration `q''ᵢ·v² + q'ᵢ·a`. With `w = v²`, `Dᵢ ≥ |q'ᵢ|` and `Qᵢ ≥ |q''ᵢ|` over the whole piece, the
//! limits hold at every point of it if
//!
//! ```text
//! v ≤ min velocityᵢ / Dᵢ          |a| ≤ a(w) = min (accelerationᵢ − Qᵢ·w) / Dᵢ
//! ```
//!
//! `a(w)` is a minimum of straight lines, hence concave, hence never below its chord. A [`Bound`] keeps
//! the chord: two numbers that stand for all axes, and a look-ahead that costs one division a piece. This
//! is the velocity-squared form of time-optimal path following (Bobrow 1985; TOPP-RA, Pham and Pham
//! 2018), with worst cases taken over a piece in place of values at its ends.

use ferrocut_geometry::AXES;
use ferrocut_machine::Machine;

/// Limits of every axis in mm/s, mm/s², mm/s³ (degrees for rotary axes), in the order of
/// [`Axis::ALL`](ferrocut_geometry::Axis::ALL). An axis that the machine lacks is not limited.
#[derive(Clone, PartialEq, Debug)]
pub struct Limits {
    /// Highest speed while cutting.
    pub velocity: [f64; AXES],
    /// Positioning speed.
    pub rapid: [f64; AXES],
    /// Highest acceleration.
    pub acceleration: [f64; AXES],
    /// Highest jerk; infinite where the machine file has 0. Not used yet.
    pub jerk: [f64; AXES],
}

/// A limit below this would never let an axis arrive; machine files are checked to be above 0.
const LEAST_LIMIT: f64 = 1e-6;

impl Limits {
    /// The limits of `machine`, brought from minutes to seconds.
    pub fn new(machine: &Machine) -> Limits {
        let mut limits = Limits {
            velocity: [f64::INFINITY; AXES],
            rapid: [f64::INFINITY; AXES],
            acceleration: [f64::INFINITY; AXES],
            jerk: [f64::INFINITY; AXES],
        };
        for axis in &machine.axes {
            let i = axis.name.index();
            limits.velocity[i] = (axis.velocity / 60.0).max(LEAST_LIMIT);
            limits.rapid[i] = (axis.rapid / 60.0).max(LEAST_LIMIT);
            limits.acceleration[i] = axis.acceleration.max(LEAST_LIMIT);
            if axis.jerk > 0.0 {
                limits.jerk[i] = axis.jerk;
            }
        }
        limits
    }
}

/// Highest feed override; what is planned stays valid up to it.
pub const MAX_FEED_OVERRIDE: f64 = 2.0;

/// Share of the acceleration that the path may use. The rest pays for joints that are run through although
/// their directions differ by rounding (see [`crate::blend`]).
const PATH_SHARE: f64 = 0.999;

/// Share of the acceleration that following the curve may use; what remains can always brake, so that feed
/// hold and a lower feed take effect in a curve that is run as fast as it allows.
const CURVE_SHARE: f64 = 0.95;

/// Slowest thing worth dividing by: 1/this is the speed of a path on which no axis has a limit, mm/s.
const LEAST_INVERSE: f64 = 1e-6;

/// Which limits and which override a piece of path is under.
#[derive(Clone, Copy, PartialEq, Eq, Debug)]
pub(crate) enum Class {
    /// Positioning: rapid limits, rapid override.
    Rapid,
    /// Cutting: velocity limits, feed override.
    Cut,
    /// Cutting with override without effect.
    Full,
    /// Cutting with override and hold without effect (G63).
    Locked,
}

/// What a piece of path allows, whatever its direction and curvature.
#[derive(Clone, Copy, PartialEq, Debug)]
pub(crate) struct Bound {
    /// Highest speed squared, by the axes and by the feed at the highest override, mm²/s².
    pub w_max: f64,
    /// Programmed speed along the path, mm/s.
    pub feed: f64,
    /// Path acceleration available at standstill, mm/s².
    pub a0: f64,
    /// How much of it every mm²/s² of speed squared takes, 1/mm.
    pub fade: f64,
}

impl Bound {
    /// Highest path acceleration at speed squared `w`, mm/s².
    #[inline]
    pub fn acceleration(&self, w: f64) -> f64 {
        (self.a0 - self.fade * w).max(0.0)
    }

    /// Highest speed squared from which a piece of length `len` brakes to `w`; by symmetry also the highest
    /// that is reached from `w`. Solves `(x − w)/(2·len) = a(x)`.
    #[inline]
    pub fn reach(&self, w: f64, len: f64) -> f64 {
        (w + 2.0 * len * self.a0) / (1.0 + 2.0 * len * self.fade)
    }

    /// Lowest speed squared after `len` of braking from `w`.
    #[inline]
    pub fn brake(&self, w: f64, len: f64) -> f64 {
        (w - 2.0 * len * self.acceleration(w)).max(0.0)
    }
}

/// The limits in the form that planning multiplies with.
#[derive(Clone, Debug)]
pub(crate) struct Inverse {
    velocity: [f64; AXES],
    rapid: [f64; AXES],
    acceleration: [f64; AXES],
}

/// Largest of `|xᵢ|·yᵢ`.
#[inline]
fn peak(x: &[f64; AXES], y: &[f64; AXES]) -> f64 {
    x.iter().zip(y).fold(0.0, |m, (x, y)| (x.abs() * y).max(m))
}

impl Inverse {
    pub fn new(limits: &Limits) -> Inverse {
        Inverse {
            velocity: limits.velocity.map(f64::recip),
            rapid: limits.rapid.map(f64::recip),
            acceleration: limits.acceleration.map(|a| (a * PATH_SHARE).recip()),
        }
    }

    /// What a straight piece with direction `d` allows. A rapid has no feed: give infinity.
    pub fn straight(&self, class: Class, d: &[f64; AXES], feed: f64) -> Bound {
        let speed = self.speed(class, d);
        let feed = if feed.is_finite() { feed } else { speed };
        let top = speed.min(feed * MAX_FEED_OVERRIDE);
        let a0 = peak(d, &self.acceleration).max(LEAST_INVERSE).recip();
        Bound { w_max: top * top, feed, a0, fade: 0.0 }
    }

    /// What a curved piece allows on which `|q'|` stays within `d` and `|q''|` within `q`.
    pub fn curved(&self, class: Class, d: &[f64; AXES], q: &[f64; AXES], feed: f64) -> Bound {
        let mut bound = self.straight(class, d, feed);
        let bend = peak(q, &self.acceleration);
        if bend * bound.w_max > CURVE_SHARE {
            bound.w_max = CURVE_SHARE / bend;
        }
        let mut worst = LEAST_INVERSE;
        for i in 0..AXES {
            // 1 − q·w ≥ 1 − CURVE_SHARE by the line above.
            let left = 1.0 - q[i].abs() * self.acceleration[i] * bound.w_max;
            worst = worst.max(d[i].abs() * self.acceleration[i] / left);
        }
        bound.fade = (bound.a0 - worst.recip()).max(0.0) / bound.w_max;
        bound
    }

    /// Highest speed along direction `d`, mm/s.
    fn speed(&self, class: Class, d: &[f64; AXES]) -> f64 {
        let inverse = if class == Class::Rapid { &self.rapid } else { &self.velocity };
        peak(d, inverse).max(LEAST_INVERSE).recip()
    }

    /// Time that the axes need at least to change their velocity by `d`, s.
    pub fn change_time(&self, d: &[f64; AXES]) -> f64 {
        peak(d, &self.acceleration)
    }
}
