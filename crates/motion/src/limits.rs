//! What every axis can do, and what that allows on a piece of path.
//!
//! On a path `q(s)` run with speed `v`, acceleration `a` and jerk `j` along it, axis `i` has
//!
//! ```text
//! velocity      q′ᵢ·v
//! acceleration  q″ᵢ·v² + q′ᵢ·a
//! jerk          q‴ᵢ·v³ + 3·q″ᵢ·v·a + q′ᵢ·j
//! ```
//!
//! With bounds `Dᵢ ≥ |q′ᵢ|`, `Qᵢ ≥ |q″ᵢ|`, `Rᵢ ≥ |q‴ᵢ|` over a whole piece ([`Rates`]) all limits hold if the
//! sums of the three products hold. A speed that the piece is run at steadily needs the first terms alone. A ramp
//! up to `v` with jerk `J` and acceleration `A` is fastest where it accelerates least: as it takes its acceleration
//! back speed is `v − a²/2J`. [`Load::room`] finds `A` and `J` with which the whole ramp stays inside; less of
//! either does too, so a ramp over several pieces takes the least of theirs.

// One loop over the four places of shares is what compilers make vectors of.
#![allow(clippy::needless_range_loop)]

use crate::quick::{cube_root, larger, smaller};
use ferrocut_geometry::AXES;
use ferrocut_machine::{AxisConfig, Machine, Ramp};

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
    /// Highest jerk; infinite where the machine file has 0.
    pub jerk: [f64; AXES],
    /// What the path uses of both while positioning.
    pub positioning: Ramps,
    /// What the path uses of both while cutting.
    pub cutting: Ramps,
    /// Highest acceleration and jerk along the path while cutting, mm/s² and mm/s³; infinite where there is none.
    pub along: [f64; 2],
}

/// Acceleration before interpolation, axis by axis.
#[derive(Clone, PartialEq, Debug)]
pub struct Ramps {
    /// Highest acceleration, mm/s².
    pub acceleration: [f64; AXES],
    /// Highest jerk, mm/s³.
    pub jerk: [f64; AXES],
}

/// A limit below this would never let an axis arrive; machine files are checked to be above 0.
const LEAST_LIMIT: f64 = 1e-6;

impl Ramps {
    const NONE: Ramps = Ramps { acceleration: [f64::INFINITY; AXES], jerk: [f64::INFINITY; AXES] };

    /// `ramp` for axis `i`: never more than its own acceleration; its jerk is given up only by a linear ramp.
    fn set(&mut self, i: usize, axis: &AxisConfig, ramp: Option<Ramp>) {
        let jerk_of = |jerk: f64| if jerk > 0.0 { jerk } else { f64::INFINITY };
        self.acceleration[i] = axis.acceleration.max(LEAST_LIMIT);
        self.jerk[i] = jerk_of(axis.jerk);
        if let Some(ramp) = ramp {
            self.acceleration[i] = self.acceleration[i].min(ramp.acceleration.max(LEAST_LIMIT));
            self.jerk[i] = if ramp.jerk > 0.0 { self.jerk[i].min(ramp.jerk) } else { f64::INFINITY };
        }
    }
}

impl Limits {
    /// The limits of `machine`, brought from minutes to seconds.
    pub fn new(machine: &Machine) -> Limits {
        let mut limits = Limits {
            velocity: [f64::INFINITY; AXES],
            rapid: [f64::INFINITY; AXES],
            acceleration: [f64::INFINITY; AXES],
            jerk: [f64::INFINITY; AXES],
            positioning: Ramps::NONE,
            cutting: Ramps::NONE,
            along: [f64::INFINITY; 2],
        };
        for axis in &machine.axes {
            let i = axis.name.index();
            limits.velocity[i] = (axis.velocity / 60.0).max(LEAST_LIMIT);
            limits.rapid[i] = (axis.rapid / 60.0).max(LEAST_LIMIT);
            limits.acceleration[i] = axis.acceleration.max(LEAST_LIMIT);
            if axis.jerk > 0.0 {
                limits.jerk[i] = axis.jerk;
            }
            limits.positioning.set(i, axis, axis.before_rapid);
            limits.cutting.set(i, axis, axis.before_cutting);
        }
        if let Some(ramp) = machine.path.ramp {
            let jerk = if ramp.jerk > 0.0 { ramp.jerk } else { f64::INFINITY };
            limits.along = [ramp.acceleration.max(LEAST_LIMIT), jerk];
        }
        limits
    }
}

/// Highest feed override.
pub const MAX_FEED_OVERRIDE: f64 = 2.0;

/// How many times the speed that a feed per revolution was given at the spindle may turn: highest spindle override, 2, and
/// a fifth for moves that are given for a somewhat lower speed than they were asked at, so that they are alike.
pub const MAX_SPINDLE_OVERRIDE: f64 = 2.4;

/// Share of the acceleration and of the jerk that the path may use. The rest pays for joints that are run
/// through although their directions differ by rounding (see [`crate::path::joint`]), and for rounding itself.
const PATH_SHARE: f64 = 0.999;

/// Share of the acceleration that following a curve may use at its highest speed; the rest is for speeding up
/// and slowing down on it.
const CURVE_SHARE: f64 = 0.995;

/// The same share of the jerk.
const TWIST_SHARE: f64 = 0.85;

/// Least inverses: on a path on which no axis has a limit speed is 10⁶ mm/s, and so on. Jerk that a machine does
/// not limit reaches the full acceleration within microseconds.
const LEAST_INVERSE: [f64; 3] = [1e-6, 1e-7, 1e-10];

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

/// Bounds of the first three derivatives of a piece of path, for every axis of those in front that move: 1, 1/mm, 1/mm².
#[derive(Clone, Copy, PartialEq, Debug)]
pub(crate) struct Rates<const N: usize = AXES> {
    pub first: [f64; N],
    pub second: [f64; N],
    pub third: [f64; N],
}

/// Highest acceleration and jerk along the path.
#[derive(Clone, Copy, PartialEq, Debug)]
pub(crate) struct Drive {
    /// mm/s².
    pub a: f64,
    /// mm/s³.
    pub j: f64,
}

impl Drive {
    /// What both allow.
    #[inline]
    pub fn min(self, other: Drive) -> Drive {
        Drive { a: smaller(self.a, other.a), j: smaller(self.j, other.j) }
    }

    /// More than any machine has.
    pub const MOST: Drive = Drive { a: 1e7, j: 1e10 };
}

/// The axes and the path itself.
const SHARES: usize = AXES + 1;

/// Shares are worked with so many at once.
const FOUR: usize = 4;

/// Four shares: of three axes and the path there are no more.
type Four = [f32; FOUR];

/// The derivatives of a piece of four axes in shares of the limits.
#[derive(Clone, Copy, Debug, Default)]
struct Shares {
    /// `Dᵢ / accelerationᵢ`.
    along: Four,
    /// `Qᵢ / accelerationᵢ`.
    bend: Four,
    /// `Dᵢ / jerkᵢ`.
    push: Four,
    /// `3·Qᵢ / jerkᵢ`.
    swing: Four,
    /// `Rᵢ / jerkᵢ`.
    twist: Four,
}

/// The derivatives of a piece in shares of the limits, in the form that look-ahead multiplies with. Kept as
/// `f32`, rounded up: it is read for every cell on every sweep. The planner leaves more of every bound than that rounds.
///
/// A limit along the path is that of one more axis, which the path is straight in.
#[derive(Clone, Copy, Debug)]
pub(crate) struct Load {
    shares: [Shares; SHARES.div_ceil(FOUR)],
    /// How many have a share: axes that move, and the path where it has limits itself.
    count: usize,
    /// On a straight piece the drive is the same at every speed.
    straight: Option<Drive>,
}

impl Load {
    /// Of nothing.
    pub const NONE: Load = Load {
        shares: [Shares {
            along: [0.0; FOUR],
            bend: [0.0; FOUR],
            push: [0.0; FOUR],
            swing: [0.0; FOUR],
            twist: [0.0; FOUR],
        }; SHARES.div_ceil(FOUR)],
        count: 0,
        straight: Some(Drive::MOST),
    };

    /// The place of one more share.
    #[inline]
    fn next(&mut self) -> (&mut Shares, usize) {
        let n = self.count;
        self.count += 1;
        (&mut self.shares[n / FOUR], n % FOUR)
    }

    /// Those that there are.
    #[inline]
    fn shares(&self) -> &[Shares] {
        &self.shares[..self.count.div_ceil(FOUR).min(SHARES.div_ceil(FOUR))]
    }

    /// What is left to the path at rest: more than any ramp uses.
    pub fn most(&self) -> Drive {
        if let Some(drive) = self.straight {
            return drive;
        }
        let (mut along, mut push) = ([LEAST_INVERSE[1] as f32; FOUR], [LEAST_INVERSE[2] as f32; FOUR]);
        for shares in self.shares() {
            for i in 0..FOUR {
                along[i] = larger(along[i], shares.along[i]);
                push[i] = larger(push[i], shares.push[i]);
            }
        }
        Drive { a: f64::from(most_of(along)).recip(), j: f64::from(most_of(push)).recip() }
    }

    /// Whether no axis is accelerated at a steady speed.
    #[inline]
    pub fn is_straight(&self) -> bool {
        self.straight.is_some()
    }

    /// What is left to the path at the speed `v`.
    ///
    /// Acceleration takes a share of the jerk on a curve, `3·q″·v·a`; it leaves at least [`JERK_KEPT`] of the jerk that
    /// the path has without it.
    #[inline]
    pub fn room(&self, v: f64) -> Room {
        if let Some(drive) = self.straight {
            return Room { a: drive.a, j: [drive.j; 2] };
        }
        let (v, w, cube) = (v as f32, (v * v) as f32, (v * v * v) as f32);
        let [_, least_along, least_push] = LEAST_INVERSE.map(|least| least as f32);
        let still = |twist: f32| larger(LEAST_LEFT, 1.0 - twist * cube);
        let mut most = [Drive::MOST.j as f32; FOUR];
        for shares in self.shares() {
            for i in 0..FOUR {
                most[i] = smaller(most[i], still(shares.twist[i]) / larger(least_push, shares.push[i]));
            }
        }
        let most = least_of(most);
        let kept = JERK_KEPT * most;
        let mut a = [Drive::MOST.a as f32; FOUR];
        for shares in self.shares() {
            for i in 0..FOUR {
                let left = larger(LEAST_LEFT, 1.0 - shares.bend[i] * w);
                a[i] = smaller(a[i], left / larger(least_along, shares.along[i]));
                let swings = still(shares.twist[i]) - kept * larger(least_push, shares.push[i]);
                a[i] = smaller(a[i], swings / larger(least_along, shares.swing[i] * v));
            }
        }
        let a = least_of(a);
        let mut least = [most; FOUR];
        for shares in self.shares() {
            for i in 0..FOUR {
                let left = still(shares.twist[i]) - shares.swing[i] * v * a;
                least[i] = smaller(least[i], left / larger(least_push, shares.push[i]));
            }
        }
        // That is what `a` leaves, but for rounding.
        let least = larger(kept, least_of(least));
        Room { a: f64::from(a), j: [most, least].map(f64::from) }
    }

    /// Largest share of acceleration or jerk that the curve alone takes from the path at `v` and `a`.
    pub fn taken(&self, v: f64, a: f64) -> f64 {
        self.used_of(v, a, 0.0, 0.0)
    }

    /// Largest share of acceleration or jerk used at `v`, `a` and `j`.
    #[inline]
    pub fn used(&self, v: f64, a: f64, j: f64) -> f64 {
        self.used_of(v, a, a, j)
    }

    /// The same, where `along` is the acceleration that the path itself takes.
    #[inline]
    fn used_of(&self, v: f64, a: f64, along: f64, j: f64) -> f64 {
        let (w, v, a, along, j) = ((v * v) as f32, v as f32, a as f32, along as f32, j as f32);
        let mut most = [0.0; FOUR];
        for shares in self.shares() {
            for i in 0..FOUR {
                let acceleration = shares.bend[i] * w + shares.along[i] * along;
                let jerk = (shares.twist[i] * w + shares.swing[i] * a) * v + shares.push[i] * j;
                most[i] = larger(larger(most[i], acceleration), jerk);
            }
        }
        f64::from(most_of(most))
    }
}

/// The largest of four.
#[inline]
fn most_of([a, b, c, d]: Four) -> f32 {
    larger(larger(a, c), larger(b, d))
}

/// The least of four.
#[inline]
fn least_of([a, b, c, d]: Four) -> f32 {
    smaller(smaller(a, c), smaller(b, d))
}

/// What is left to the path at a speed.
#[derive(Clone, Copy, PartialEq, Debug, Default)]
pub(crate) struct Room {
    /// Acceleration, mm/s².
    pub a: f64,
    /// Jerk at no acceleration and at that one, mm/s³.
    pub j: [f64; 2],
}

impl Room {
    /// What both leave.
    pub fn min(self, other: Room) -> Room {
        let j = [smaller(self.j[0], other.j[0]), smaller(self.j[1], other.j[1])];
        Room { a: smaller(self.a, other.a), j }
    }
}

/// See [`Load::room`].
const JERK_KEPT: f32 = 0.4;

/// Least share of the jerk that is left to a path, whatever the curve takes.
const LEAST_LEFT: f32 = 0.02;

/// The limits in the form that planning multiplies with, for one kind of move.
#[derive(Clone, Copy, Debug)]
pub(crate) struct Inverse {
    velocity: [f64; AXES],
    pub acceleration: [f64; AXES],
    pub jerk: [f64; AXES],
    /// Of acceleration and jerk along the path; 0 where they are not limited.
    pub along: [f64; 2],
}

/// The limits of both kinds of move.
#[derive(Clone, Debug)]
pub(crate) struct Inverses {
    positioning: Inverse,
    cutting: Inverse,
    /// What keeps both.
    both: Inverse,
}

impl Inverses {
    pub fn new(limits: &Limits) -> Inverses {
        let inverse = |velocity: &[f64; AXES], ramps: &Ramps, along: [f64; 2]| Inverse {
            velocity: velocity.map(f64::recip),
            acceleration: ramps.acceleration.map(|a| (a * PATH_SHARE).recip()),
            jerk: ramps.jerk.map(|j| (j * PATH_SHARE).recip()),
            along: along.map(f64::recip),
        };
        let positioning = inverse(&limits.rapid, &limits.positioning, [f64::INFINITY; 2]);
        let cutting = inverse(&limits.velocity, &limits.cutting, limits.along);
        Inverses { both: positioning.and(&cutting), positioning, cutting }
    }

    /// Those that hold for `class`.
    #[inline]
    pub fn of(&self, class: Class) -> &Inverse {
        if class == Class::Rapid { &self.positioning } else { &self.cutting }
    }

    /// Those that hold where moves of these kinds meet.
    #[inline]
    pub fn beside(&self, class: Class, next: Class) -> &Inverse {
        if (class == Class::Rapid) == (next == Class::Rapid) { self.of(class) } else { &self.both }
    }
}

/// The larger of both, axis by axis.
fn largest<const N: usize>(x: &[f64; N], y: &[f64; N]) -> [f64; N] {
    std::array::from_fn(|i| larger(x[i], y[i]))
}

/// Largest of `|xᵢ|·yᵢ`.
#[inline]
pub(crate) fn peak<const N: usize>(x: &[f64; N], y: &[f64; AXES]) -> f64 {
    x.iter().zip(y).fold(0.0, |m, (x, y)| larger(m, x.abs() * y))
}

/// To `f32`, never smaller.
#[inline]
fn up(x: f64) -> f32 {
    (x * (1.0 + 2e-7)) as f32
}

impl Inverse {
    /// What keeps both.
    fn and(&self, other: &Inverse) -> Inverse {
        Inverse {
            velocity: largest(&self.velocity, &other.velocity),
            acceleration: largest(&self.acceleration, &other.acceleration),
            jerk: largest(&self.jerk, &other.jerk),
            along: largest(&self.along, &other.along),
        }
    }

    /// Highest speed along a piece by the velocity of the axes alone, mm/s.
    pub fn velocity<const N: usize>(&self, d: &[f64; N]) -> f64 {
        larger(LEAST_INVERSE[0], peak(d, &self.velocity)).recip()
    }

    /// Highest speed along a piece, mm/s.
    pub fn speed(&self, rates: &Rates) -> f64 {
        self.curve_speed(rates, self.velocity(&rates.first))
    }

    /// The same, where `along` is that by the velocity of the axes alone.
    pub fn curve_speed<const N: usize>(&self, rates: &Rates<N>, along: f64) -> f64 {
        let bend = peak(&rates.second, &self.acceleration);
        let twist = peak(&rates.third, &self.jerk);
        let by_bend = (CURVE_SHARE / larger(1e-15, bend)).sqrt();
        smaller(smaller(along, by_bend), cube_root(TWIST_SHARE / larger(1e-20, twist)))
    }

    /// What a piece takes of the limits.
    #[inline]
    pub fn load<const N: usize>(&self, rates: &Rates<N>) -> Load {
        let mut load = Load { shares: Default::default(), count: 0, straight: None };
        let Rates { first, second, third } = rates;
        for i in 0..N {
            let (d, q, r) = (first[i].abs(), second[i].abs(), third[i].abs());
            // Few have a limit along the path, which is a fourth share.
            if N >= FOUR && d == 0.0 && q == 0.0 && r == 0.0 {
                continue;
            }
            let (shares, n) = load.next();
            shares.along[n] = up(d * self.acceleration[i]);
            shares.bend[n] = up(q * self.acceleration[i]);
            shares.push[n] = up(d * self.jerk[i]);
            shares.swing[n] = up(3.0 * q * self.jerk[i]);
            shares.twist[n] = up(r * self.jerk[i]);
        }
        if self.along != [0.0; 2] {
            let (shares, n) = load.next();
            (shares.along[n], shares.push[n]) = (up(self.along[0]), up(self.along[1]));
        }
        if second.iter().chain(third).all(|c| *c == 0.0) {
            load.straight = Some(self.straight(first));
        }
        load
    }

    /// What a straight piece in direction `d` leaves.
    pub fn straight<const N: usize>(&self, d: &[f64; N]) -> Drive {
        Drive {
            a: peak(d, &self.acceleration).max(self.along[0]).max(LEAST_INVERSE[1]).recip(),
            j: peak(d, &self.jerk).max(self.along[1]).max(LEAST_INVERSE[2]).recip(),
        }
    }

    /// Whether nothing that moves in direction `d` has a limit of jerk.
    pub fn is_free_of_jerk<const N: usize>(&self, d: &[f64; N]) -> bool {
        self.along[1] == 0.0 && peak(d, &self.jerk) == 0.0
    }

    /// With a jerk for axes that have no limit of it, by which curves within `tolerance` are smoothed: at `A·√(A/δ)` what is
    /// smoothed away over `v·(δ/J)^⅓` is smoothed away over `v·(δ/A)^½`, on which a wave of the size `δ` takes the
    /// acceleration `A`.
    pub fn with_some_jerk(&self, tolerance: f64) -> Inverse {
        let mut soft = *self;
        for (jerk, acceleration) in soft.jerk.iter_mut().zip(self.acceleration) {
            if *jerk == 0.0 {
                *jerk = acceleration * (acceleration * tolerance).sqrt();
            }
        }
        soft
    }

    /// [`change_time`](Self::change_time), where the path, whose velocity changes by `change`, has a limit too.
    pub fn turn_time(&self, d: &[f64; AXES], change: f64) -> f64 {
        self.change_time(d).max(self.along[0] * change)
    }

    /// Time that the axes need at least to change their velocity by `d`, s.
    pub fn change_time(&self, d: &[f64; AXES]) -> f64 {
        peak(d, &self.acceleration)
    }
}
