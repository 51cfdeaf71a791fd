//! Sharp corners between two moves, rounded in time.
//!
//! Slowing down for a corner ends with a ramp that takes the acceleration back to nothing at the vertex, and
//! leaving it begins with one that builds it up again. Inside the tolerance both can run at once: with `x` from 0
//! to 1 over the duration `T`, directions `d₁` and `d₂`, vertex `p`
//!
//! ```text
//! q(x) = p + r·( −d₁·(1−x)³ + d₂·x³ )
//! q̇    = v·( d₁·(1−x)² + d₂·x² )        v = 3r/T
//! q̈    = a·( −d₁·(1−x) + d₂·x )         a = 6r/T² = 2v/T
//! q⃛    = a·( d₁ + d₂ ) / T
//! ```
//!
//! It begins on the first line at the distance `r` with speed `v` and deceleration `a`, and ends on the second at
//! the same distance, with speed `v` and acceleration `a`: the path is never without acceleration, and what a
//! ramp down to rest would take is saved. The vertex is missed by `r/8·|d₂ − d₁|` in the middle, where the curve
//! is nearest to it. That is the tolerance `δ`; of speed and duration the acceleration and the jerk of the axes
//! decide:
//!
//! ```text
//! r = 8·δ/|d₂−d₁|      a ≤ A      a·|d₁+d₂|ᵢ ≤ Jᵢ·T      with T² = 6r/a
//! ```
//!
//! For a right angle this is the overlap of the two jerk ramps by `T = (48·δ/(√2·J))^⅓`; for a turn of nearly
//! 180° `|d₁+d₂|` vanishes and the corner is passed with the full acceleration.
//!
//! Where no jerk is limited that form has no use: braking is taken back in no time, and the acceleration may jump. Then
//! the corner has one acceleration all along, and is a parabola, entered and left at a steady speed:
//!
//! ```text
//! q(x) = p + r·( −d₁·(1−x)² + d₂·x² )
//! q̇    = v·( d₁·(1−x) + d₂·x )          v = 2r/T
//! q̈    = v/T·( d₂ − d₁ )                 r = 4·δ/|d₂−d₁|      v·|d₂−d₁|ᵢ ≤ Aᵢ·T
//! ```
//!
//! **Beside arcs** both moves run at once in the same way: the one before to its end by the length `r·(1−x)³`, the one
//! behind from its start by `r·x³`, each along its own curve, and what each goes is added. With `Q ≥ |q″|` and `R ≥ |q‴|`
//! within `r` of the vertex, and `v² = 3r·a/2`,
//!
//! ```text
//! acceleration   a·( |d| + Q·3r/2 )
//! jerk           a^{3/2}·( (|d₁+d₂| + 2r·Q)/√(6r) + 3Q·√(3r/2) + R·(3r/2)^{3/2} )
//! ```
//!
//! In the middle both are `u = r/8` from the vertex, and the curves bend by `κ₁`, `κ₂`: `u·|d₂−d₁| + 2u²·(κ₁+κ₂) ≤ δ`.
//!
//! **Between two lines** the way of each may go back a little first: the path then swings out within the tolerance before
//! it turns and behind it ([`crate::path::swing`]). Two corners with a **short line** between them are run as one
//! ([`crate::path::link`]).
//!
//! A corner run at the share `λ` of its pace has speed `λ·v` and acceleration `λ²·a`, its jerk is `λ³` of the whole.

mod search;

use crate::limits::{Drive, Inverse, Rates, peak};
use crate::path::link::{Link, Linked};
use crate::path::piece::{Piece, Reach};
use crate::path::swing::Swing;
use crate::quick::larger;
use crate::timing::ramp::{Foot, STOP_ROOM, distance, duration};
use ferrocut_geometry::{AXES, Position};
pub(crate) use search::{Far, Lines, Recent, Side};

/// What is the same all along a rounded corner.
#[derive(Clone, Copy, PartialEq, Debug)]
enum Form {
    /// The jerk.
    Cubic,
    /// The acceleration, where no jerk is limited.
    Parabola,
    /// The jerk, in parts: it swings out before and behind.
    Swing(Swing),
    /// The jerk, beside a short line and on it in parts.
    Link(Link),
}

impl Form {
    fn of(rates: &Rates, inverse: &Inverse) -> Form {
        if inverse.is_free_of_jerk(&rates.first) { Form::Parabola } else { Form::Cubic }
    }

    /// The share of the reach that both sides are from the vertex in the middle.
    fn depth(self) -> f64 {
        match self {
            Form::Cubic | Form::Link(_) => 1.0 / 8.0,
            Form::Parabola => 1.0 / 4.0,
            Form::Swing(swing) => swing.at(0.5)[0],
        }
    }

    /// How far a side is from the vertex, as shares of the reach, and how fast, of the speed at the ends.
    fn sides(self, x: f64) -> [[f64; 2]; 2] {
        let y = 1.0 - x;
        match self {
            Form::Cubic => [[y * y * y, x * x * x], [y * y, x * x]],
            Form::Parabola => [[y * y, x * x], [y, x]],
            Form::Swing(swing) => {
                let ([left, slower, _], [gone, faster, _]) = (swing.at(y), swing.at(x));
                let top = swing.at(1.0)[1];
                [[left, gone], [slower / top, faster / top]]
            }
            Form::Link(link) => {
                let [[left, slower], _, [gone, faster]] = link.at(x);
                [[left, gone], [slower, faster]]
            }
        }
    }

    /// How far it is on the line between its vertices, and how fast, for a duration of 1.
    fn middle(self, x: f64) -> Option<[Position; 2]> {
        let Form::Link(link) = self else { return None };
        let [_, way, _] = link.at(x);
        Some(way.map(|way| Position(link.d.0.map(|d| d * way))))
    }
}

/// A rounded corner, or two with a short line between them.
#[derive(Clone, Copy, Debug)]
pub(crate) struct Corner {
    form: Form,
    /// The first of them.
    vertex: Position,
    before: Reach,
    after: Reach,
    /// How far before and behind the vertex it begins and ends, mm.
    pub reach: f64,
    /// Duration at full pace, s.
    pub time: f64,
    /// State at both ends at full pace: speed and acceleration away from the corner.
    pub foot: Foot,
    /// Highest speed at its ends, mm/s, by the rules of corners.
    pub cap: f64,
    /// Programmed speed of the line between its vertices, mm/s; infinite where there is none.
    pub feed: f64,
    /// How many times the speed at its ends is the highest in it, if that is higher.
    pub haste: f64,
}

/// Share of the tolerance that a parabola takes: between setpoints that are a period apart drives do not see the jump of
/// its acceleration where it is.
const PARABOLA_SHARE: f64 = 0.99;

/// Corners that would take longer are stops, s.
const LONGEST: f64 = 10.0;

/// Corners that would be shorter than this are stops, mm.
const LEAST_REACH: f64 = 1e-7;

/// A corner beside an arc is no longer than this share of its radius.
const CURVE_ROOM: f64 = 0.4;

impl Corner {
    /// The corner between two moves within `tolerance`, taking at most `room` of either.
    pub fn new(
        before: &Piece,
        after: &Piece,
        tolerance: f64,
        room: f64,
        inverse: &Inverse,
    ) -> Option<Corner> {
        let len = before.len();
        let (d1, d2) = (before.tangent(len), after.tangent(0.0));
        let jump = d2 - d1;
        let (here, there) = (before.seen_from(len), after.seen_from(0.0));
        let bends = [norm(&before.bend(len).0), norm(&after.bend(0.0).0)];
        let room = room.min(CURVE_ROOM / bends[0].max(bends[1]).max(1e-9));
        let rates = both(&here.rates(room), &there.rates(room));
        let form = Form::of(&rates, inverse);
        let bend = bends[0] + bends[1];
        let turn = norm(&jump.0);
        let tolerance = if form == Form::Parabola { PARABOLA_SHARE * tolerance } else { tolerance };
        let depth = 2.0 * tolerance / (turn + (turn * turn + 8.0 * bend * tolerance).sqrt());
        let reach = (depth / form.depth()).min(room);
        if !(reach > LEAST_REACH) {
            return None;
        }
        let rates = both(&here.rates(reach), &there.rates(reach));
        let widened = |d: &Position, by: f64| std::array::from_fn(|i| d.0[i].abs() + by * rates.second[i]);
        let (time, foot) = match form {
            Form::Parabola => {
                let change: [f64; AXES] = widened(&jump, 4.0 * reach);
                let time = (2.0 * reach * inverse.turn_time(&change, turn + 4.0 * reach * bend)).sqrt();
                (time, Foot::still(2.0 * reach / time))
            }
            Form::Cubic | Form::Swing(_) | Form::Link(_) => {
                let straight =
                    Position(std::array::from_fn(|i| rates.first[i] + 1.5 * reach * rates.second[i]));
                // The jerk for an acceleration of 1.
                let sum = widened(&(d1 + d2), 2.0 * reach);
                let root = (1.5 * reach).sqrt();
                let jerk: [f64; AXES] = std::array::from_fn(|i| {
                    sum[i] / (6.0 * reach).sqrt()
                        + 3.0 * rates.second[i] * root
                        + rates.third[i] * root * root * root
                });
                let most = peak(&jerk, &inverse.jerk).max(1e-12).recip();
                let a = inverse.straight(&straight.0).a.min(most.cbrt() * most.cbrt());
                let time = (6.0 * reach / a).sqrt();
                (time, Foot { v: 0.5 * a * time, a })
            }
        };
        let is_possible = time > 0.0 && time < LONGEST && foot.v > 0.0 && foot.v.is_finite() && foot.a >= 0.0;
        is_possible.then_some(Corner {
            form,
            vertex: before.end(),
            before: here,
            after: there,
            reach,
            time,
            foot,
            cap: f64::INFINITY,
            feed: f64::INFINITY,
            haste: 1.0,
        })
    }

    /// This corner and the `next`, both between lines, run as one with the line of `len` in the direction `d` between them, if
    /// that is so short that they could not be run at their pace with a way to stop between them, and no shorter than they
    /// take.
    pub fn linked(&self, next: &Corner, d: Position, len: f64, inverse: &Inverse) -> Option<Corner> {
        let are_plain =
            self.form == Form::Cubic && next.form == Form::Cubic && self.reach <= next.reach * (1.0 + 1e-9);
        let drive = inverse.straight(&d.0);
        let foot = if self.foot.v > next.foot.v { self.foot } else { next.foot };
        if !are_plain || 2.0 * self.reach + STOP_ROOM * foot.room(drive) <= len {
            return None;
        }
        let sides = [self.before.slope(0.0), next.after.slope(0.0)];
        let linked = Linked::new(self.reach, d, len, sides, inverse)?;
        Some(Corner {
            form: Form::Link(linked.link),
            after: next.after,
            time: linked.time,
            foot: linked.foot,
            cap: self.cap.min(next.cap),
            haste: (linked.peak / linked.foot.v).max(1.0),
            ..*self
        })
    }

    /// The length between its vertices.
    fn between(&self) -> f64 {
        if let Form::Link(link) = self.form { link.len } else { 0.0 }
    }

    /// Whether it is more than one, which are never stopped at.
    pub fn is_link(&self) -> bool {
        matches!(self.form, Form::Link(_))
    }

    /// How far before its last vertex it begins.
    pub fn begin(&self) -> f64 {
        self.reach + self.between()
    }

    /// The same, run no faster than `cap`, mm/s.
    pub fn capped(self, cap: f64) -> Corner {
        Corner { cap, ..self }
    }

    /// The point at the share `x` of the duration.
    pub fn at(&self, x: f64) -> Position {
        let [[left, gone], _] = self.form.sides(x);
        let p = self.vertex + self.before.at(-left * self.reach) + self.after.at(gone * self.reach);
        self.form.middle(x).map_or(p, |[way, _]| p + way)
    }

    /// Bounds of the derivatives of the two moves, for a corner that is stopped at.
    pub fn rates(&self) -> Rates {
        let rates = both(&self.before.rates(self.reach), &self.after.rates(self.reach));
        let Form::Link(link) = self.form else { return rates };
        both(&rates, &Rates { first: link.d.0, second: [0.0; AXES], third: [0.0; AXES] })
    }

    /// The point at length `s` on the two moves.
    pub fn square(&self, s: f64) -> Position {
        let off = s - self.reach;
        if off < 0.0 {
            return self.vertex + self.before.at(off);
        }
        let Form::Link(link) = self.form else { return self.vertex + self.after.at(off) };
        let on = off.min(link.len);
        self.vertex + Position(link.d.0.map(|d| d * on)) + self.after.at(off - on)
    }

    /// Speed at the share `x`, at full pace.
    pub fn speed(&self, x: f64) -> f64 {
        let [[left, gone], [slower, faster]] = self.form.sides(x);
        let (before, after) = (self.before.slope(-left * self.reach), self.after.slope(gone * self.reach));
        let v: [f64; AXES] = std::array::from_fn(|i| before.0[i] * slower + after.0[i] * faster);
        let Some([_, way]) = self.form.middle(x) else { return norm(&v) * self.foot.v };
        let v: [f64; AXES] = std::array::from_fn(|i| v[i] * self.foot.v + way.0[i] / self.time);
        norm(&v)
    }

    /// What the corner costs against running on with speed `feed` on lines with `drive`, s.
    pub fn loss(&self, feed: f64, drive: Drive) -> f64 {
        let side = Side { len: f64::INFINITY, feed, drive, end: Far::Corner };
        self.loss_at([&side; 2], 1.0)
    }

    /// What it costs at the pace `most`, or at the highest below it that the speeds beside it allow.
    fn loss_at(&self, [before, after]: [&Side; 2], most: f64) -> f64 {
        let mut pace = most.min(pace_below(self.foot, before.feed, before.drive.j));
        if (after.feed, after.drive.j) != (before.feed, before.drive.j) {
            pace = pace.min(pace_below(self.foot, after.feed, after.drive.j));
        }
        let foot = paced(self.foot, pace);
        let lost = before.lost(foot, self.reach);
        self.time / pace + lost + if after == before { lost } else { after.lost(foot, self.reach) }
    }
}

/// The directions `d₁`, `d₂` of both sides on the axes that are in them, with what these allow.
struct Directions {
    /// `d₁`, `d₂`, and one by the bounds of acceleration and jerk.
    axes: [[f64; 4]; AXES],
    len: usize,
    /// One by the bounds along the path.
    along: [f64; 2],
}

impl Directions {
    fn new(d1: Position, d2: Position, inverse: &Inverse) -> Directions {
        let (mut axes, mut len) = ([[0.0; 4]; AXES], 0);
        for i in (0..AXES).filter(|i| d1.0[*i] != 0.0 || d2.0[*i] != 0.0) {
            axes[len] = [d1.0[i], d2.0[i], inverse.acceleration[i], inverse.jerk[i]];
            len += 1;
        }
        Directions { axes, len, along: inverse.along }
    }

    /// The share of the bounds that `gone·d₂ − left·d₁` takes as an acceleration (2) or a jerk (3).
    #[inline]
    fn share<const BOUND: usize>(&self, left: f64, gone: f64) -> f64 {
        let (mut most, mut square) = (0.0, 0.0);
        for axis in &self.axes[..self.len] {
            let c = gone * axis[1] - left * axis[0];
            most = larger(most, c.abs() * axis[BOUND]);
            square += c * c;
        }
        larger(most, square.sqrt() * self.along[BOUND - 2])
    }

    fn acceleration(&self, left: f64, gone: f64) -> f64 {
        self.share::<2>(left, gone)
    }

    fn jerk(&self, left: f64, gone: f64) -> f64 {
        self.share::<3>(left, gone)
    }
}

/// The share of the bounds that this acceleration takes.
pub(crate) fn of_acceleration(a: &Position, inverse: &Inverse) -> f64 {
    peak(&a.0, &inverse.acceleration).max(norm(&a.0) * inverse.along[0])
}

/// The same of a jerk.
pub(crate) fn of_jerk(j: &Position, inverse: &Inverse) -> f64 {
    peak(&j.0, &inverse.jerk).max(norm(&j.0) * inverse.along[1])
}

/// Bounds that hold for both.
fn both(a: &Rates, b: &Rates) -> Rates {
    let most = |x: &[f64; AXES], y: &[f64; AXES]| std::array::from_fn(|i| x[i].abs().max(y[i].abs()));
    Rates {
        first: most(&a.first, &b.first),
        second: most(&a.second, &b.second),
        third: most(&a.third, &b.third),
    }
}

/// What slowing down from `feed` to `v` and back costs, s.
pub(crate) fn valley_loss(v: f64, feed: f64, drive: Drive) -> f64 {
    2.0 * (duration(v, feed, drive) - distance(v, feed, drive) / feed)
}

/// The state at the share `pace`.
pub(crate) fn paced(foot: Foot, pace: f64) -> Foot {
    Foot { v: foot.v * pace, a: foot.a * pace * pace }
}

/// Highest pace, up to 1, at which the acceleration can be gone before `speed` is passed.
pub(crate) fn pace_below(foot: Foot, speed: f64, j: f64) -> f64 {
    // pace·v + pace⁴·b ≤ speed, a rising convex function: Newton from above, where either term alone has all.
    let b = foot.a * foot.a / (2.0 * j);
    if foot.v + b <= speed {
        return 1.0;
    }
    let mut pace = (speed / b).sqrt().sqrt().min(speed / foot.v).min(1.0);
    for _ in 0..30 {
        let cube = pace * pace * pace;
        let step = (pace * foot.v + pace * cube * b - speed) / (foot.v + 4.0 * cube * b);
        pace -= step;
        if step < 1e-9 * pace {
            break;
        }
    }
    pace.max(1e-6) * (1.0 - 1e-9)
}

pub(crate) fn norm(v: &[f64]) -> f64 {
    v.iter().map(|c| c * c).sum::<f64>().sqrt()
}
