//! The bounds of a window at the places between its steps.
//!
//! What they are worked out from is gathered place by place ([`Ground`]); the bounds themselves are those of [`LANES`] places at once.

use super::road::Road;
use super::rows::{LANES, Lanes, Root, Rows};
use super::{STEPS, Valley};
use crate::quick::{larger, smaller};
use crate::timing::queue::Node;
use ferrocut_geometry::AXES;
use pulp::{Arch, NullaryFnOnce};

/// Shares of acceleration and jerk that are used; the rest is for what lies between the places looked at.
const ACCELERATION_SHARE: f64 = 0.998;
const JERK_SHARE: f64 = 0.993;

/// Where a bound is far, it is none: less than the second share of it is used where `x` is the first times as much. A solution that is
/// faster somewhere is looked for again, with the bounds that are not far from it.
const FASTER: f64 = 3.0;
const HARMLESS: f64 = 0.95;

/// How far inside its bounds a solution is that a window begins with.
const INSIDE: f64 = 3e-3;

/// Along the path there is at least this much of a bound, 1 by the units of that.
const LEAST_INVERSE: f64 = 1e-12;

/// The path itself, which is one more axis that it is straight in.
const PATH: usize = AXES;

/// A number for each place, and room for a block behind the last one.
type Column = [f64; ROOM];
const ROOM: usize = STEPS + 2 + 2 * LANES;

/// What the bounds of a window are worked out from, place by place.
#[derive(Debug)]
pub(super) struct Ground {
    /// `q′`, `q″` and `q‴` of each axis and of the path, on the sides behind and before a place.
    derivatives: Vec<[[Column; PATH + 1]; 3]>,
    /// Inverse limits of acceleration and jerk, of each axis and of the path.
    inverse: Vec<[Column; PATH + 1]>,
    /// Whether the path has limits itself.
    limits_path: bool,
    /// Lowest speed allowed, curves aside, along the three steps that a control point bears on; infinite at those that are given.
    caps: Column,
    /// Lengths of the steps before the places, and 1 by those of both beside them.
    h: Column,
    both: Column,
    /// `x` there.
    x: Column,
    /// More than the path can do there: speed, acceleration and jerk. What stays below its bounds then is none.
    v: Column,
    a: Column,
    j: Column,
    /// Whether the bounds of jerk count on the sides behind and before, and those of acceleration: 1, else 0.
    has: [Column; 2],
    is_inner: Column,
}

/// Sides of a place.
const BEHIND: usize = 0;
const BEFORE: usize = 1;

impl Ground {
    pub fn new() -> Ground {
        const NONE: Column = [0.0; ROOM];
        let mut derivatives = vec![[[NONE; PATH + 1]; 3]; 2];
        for side in &mut derivatives {
            side[0][PATH] = [1.0; ROOM];
        }
        Ground {
            derivatives,
            inverse: vec![[NONE; PATH + 1]; 2],
            limits_path: false,
            caps: NONE,
            h: NONE,
            both: NONE,
            x: NONE,
            v: NONE,
            a: NONE,
            j: NONE,
            has: [NONE; 2],
            is_inner: NONE,
        }
    }

    /// Gathers what the path is like at these places, the first of which lies in cell `first`.
    fn survey<const N: usize>(
        &mut self,
        road: &Road<'_, N, impl Fn(&Node) -> f64>,
        first: u64,
        places: &[f64],
    ) {
        let mut cell = first;
        // Along the two steps before.
        let mut caps = [f64::INFINITY; 2];
        self.caps.fill(f64::INFINITY);
        self.limits_path = false;
        for (k, s) in places.iter().copied().enumerate() {
            cell = road.cell(cell, s);
            let node = road.queue.node(cell);
            if let Some(end) = places.get(k + 1) {
                let cap = road.least_cap(cell, *end);
                if k >= 2 {
                    self.caps[k] = smaller(smaller(caps[0], caps[1]), cap);
                }
                caps = [caps[1], cap];
            }
            let inverse = road.inverses.of(node.class);
            for i in 0..N {
                (self.inverse[0][i][k], self.inverse[1][i][k]) = (inverse.acceleration[i], inverse.jerk[i]);
            }
            (self.inverse[0][PATH][k], self.inverse[1][PATH][k]) = (inverse.along[0], inverse.along[1]);
            self.limits_path |= inverse.along != [0.0; 2];
            // A border belongs to both sides.
            let left = if s <= node.s + 1e-12 && k > 0 { road.side_before(cell, s) } else { cell };
            let behind = road.derivatives(cell, s);
            let before = if left == cell { behind } else { road.derivatives(left, s) };
            for (side, at) in self.derivatives.iter_mut().zip([behind, before]) {
                for (columns, at) in side.iter_mut().zip(at) {
                    for (column, d) in columns.iter_mut().zip(at) {
                        column[k] = d;
                    }
                }
            }
        }
    }

    /// What follows from that and the steps, of lengths `h`, which are run at `x`.
    #[inline(always)]
    fn level<const N: usize>(&mut self, h: &[f64], x: &[f64]) {
        let places = h.len() - 1;
        let all = places.next_multiple_of(LANES);
        self.h[..h.len()].copy_from_slice(h);
        self.h[h.len()..=all].fill(1.0);
        for k in 0..all {
            let (h0, h1) = (self.h[k], self.h[k + 1]);
            let both = (h0 + h1).recip();
            self.both[k] = both;
            self.x[k] = (x[k] * h1 + x[k + 1] * h0) * both;
            self.v[k] = larger(0.0, FASTER * self.x[k]).sqrt();
        }
        self.reach::<N>(all);
        // On a line the end of a step at which it is faster decides.
        let [behind, before] = [BEHIND, BEFORE].map(|side| &self.derivatives[side]);
        let bends = |side: &[[Column; PATH + 1]; 3], k: usize| {
            (0..N).fold(0.0, |sum, i| sum + side[1][i][k].abs() + side[2][i][k].abs())
        };
        for k in 0..all {
            let (here, next) = (self.x[k], self.x[k + 1]);
            self.has[BEHIND][k] = if bends(behind, k) > 0.0 || here >= next { 1.0 } else { 0.0 };
            self.has[BEFORE][k + 1] = if bends(before, k + 1) > 0.0 || next >= here { 1.0 } else { 0.0 };
        }
        // There is no step before the first place, and none behind the last one.
        self.has[BEFORE][0] = 0.0;
        self.has[BEHIND][places - 1..].fill(0.0);
        self.has[BEFORE][places..].fill(0.0);
        self.is_inner[..places - 1].fill(1.0);
        self.is_inner[0] = 0.0;
        self.is_inner[places - 1..].fill(0.0);
    }

    /// Highest acceleration and jerk along the path where it is no faster than `v`, by its derivatives on both sides: an axis has
    /// what its bounds leave it, and as much more as the curve takes the other way.
    #[inline(always)]
    fn reach<const N: usize>(&mut self, all: usize) {
        let Ground { derivatives, inverse, v, a, j, .. } = self;
        let [behind, before] = [BEHIND, BEFORE].map(|side| &derivatives[side]);
        let [a_most, j_most] = &inverse[..] else { return };
        for k in 0..all {
            a[k] = larger(LEAST_INVERSE, a_most[PATH][k]).recip();
            j[k] = larger(LEAST_INVERSE, j_most[PATH][k]).recip();
        }
        let most = |of: usize, i: usize, k: usize| larger(behind[of][i][k].abs(), before[of][i][k].abs());
        for i in 0..N {
            for k in 0..all {
                let left = 1.0 + most(1, i, k) * v[k] * v[k] * a_most[i][k];
                a[k] = smaller(a[k], left / (behind[0][i][k].abs() * a_most[i][k]));
            }
        }
        for i in 0..N {
            for k in 0..all {
                let curve = (most(2, i, k) * v[k] * v[k] + 3.0 * most(1, i, k) * a[k]) * v[k];
                let left = 1.0 + curve * j_most[i][k];
                j[k] = smaller(j[k], left / (behind[0][i][k].abs() * j_most[i][k]));
            }
        }
    }

    /// Puts in the bounds that begin with the control points from `base` on, of speed and then of axis after axis.
    #[inline(always)]
    fn put<const N: usize>(&self, base: usize, x: &[f64], rows: &mut Rows) {
        self.put_speed(base, x, rows);
        for i in (0..N).chain(self.limits_path.then_some(PATH)) {
            self.put_jerk(BEFORE, i, base, rows);
            self.put_acceleration(i, base, rows);
            self.put_jerk(BEHIND, i, base, rows);
        }
    }

    /// `X ≤ cap`: between three control points the spline lies below the highest.
    #[inline(always)]
    fn put_speed(&self, base: usize, x: &[f64], rows: &mut Rows) {
        let (mut counts, mut c) = ([0.0; LANES], [[0.0; LANES]; 3]);
        for i in 0..LANES {
            let cap = self.caps[base + i];
            let on = FASTER * x[base + i] > cap * cap;
            (counts[i], c[0][i]) = if on { (1.0, (1.0 / (cap * cap)) as f32) } else { (0.0, 0.0) };
        }
        rows.put(Root::None, base, counts, c);
    }

    /// `q″·X + q′·a`.
    #[inline(always)]
    fn put_acceleration(&self, axis: usize, base: usize, rows: &mut Rows) {
        let [d1, d2] = [0, 1].map(|of| from(&self.derivatives[BEHIND][of][axis], base));
        let inverse = from(&self.inverse[0][axis], base);
        let [v, a, both, has] = [&self.v, &self.a, &self.both, &self.is_inner].map(|of| from(of, base));
        let [h0, h1] = [0, 1].map(|k| from(&self.h, base + k));
        let (mut counts, mut c): (Lanes, [Lanes; 3]) = ([0.0; LANES], [[0.0; LANES]; 3]);
        for i in 0..LANES {
            let inverse = inverse[i] * (1.0 / ACCELERATION_SHARE);
            let used = (d2[i].abs() * v[i] * v[i] + d1[i].abs() * a[i]) * inverse;
            let on = has[i] * used > HARMLESS;
            // X and a by x of both steps.
            let part = both[i] * inverse;
            counts[i] = if on { 1.0 } else { 0.0 };
            c[0][i] = if on { ((d2[i] * h1[i] - d1[i]) * part) as f32 } else { 0.0 };
            c[1][i] = if on { ((d2[i] * h0[i] + d1[i]) * part) as f32 } else { 0.0 };
        }
        rows.put(Root::None, base, counts, c);
    }

    /// `q‴·X + 3·q″·a + q′·j/√X` on a side of the places.
    #[inline(always)]
    fn put_jerk(&self, side: usize, axis: usize, base: usize, rows: &mut Rows) {
        let root = if side == BEHIND { Root::Behind } else { Root::Before };
        let at = base + root.place();
        let [d1, d2, d3] = [0, 1, 2].map(|of| from(&self.derivatives[side][of][axis], at));
        let inverse = from(&self.inverse[1][axis], at);
        let [v, a, j, both] = [&self.v, &self.a, &self.j, &self.both].map(|of| from(of, at));
        let has = from(&self.has[side], at);
        let [h0, h1] = [0, 1].map(|k| from(&self.h, at + k));
        // Acceleration at the place behind minus that at the one before, over the length of the step between.
        let step = from(&self.h, base + 1);
        let [first, second] = [0, 1].map(|k| from(&self.both, base + k));
        let (mut counts, mut c): (Lanes, [Lanes; 3]) = ([0.0; LANES], [[0.0; LANES]; 3]);
        for i in 0..LANES {
            let inverse = inverse[i] * (1.0 / JERK_SHARE);
            let curve = (d3[i].abs() * v[i] * v[i] + 3.0 * d2[i].abs() * a[i]) * v[i];
            let on = has[i] * ((curve + d1[i].abs() * j[i]) * inverse) > HARMLESS;
            let push = d1[i] / step[i];
            let swing = 3.0 * d2[i];
            let own = [(d3[i] * h1[i] - swing) * both[i], (d3[i] * h0[i] + swing) * both[i]];
            let [p0, p1, p2] = [push * first[i], -push * (first[i] + second[i]), push * second[i]];
            let row =
                if side == BEHIND { [p0 + own[0], p1 + own[1], p2] } else { [p0, p1 + own[0], p2 + own[1]] };
            counts[i] = if on { 1.0 } else { 0.0 };
            for (c, row) in c.iter_mut().zip(row) {
                c[i] = if on { (row * inverse) as f32 } else { 0.0 };
            }
        }
        rows.put(root, base, counts, c);
    }
}

/// The numbers of the places from `at` on.
#[inline(always)]
fn from(column: &Column, at: usize) -> &[f64; LANES] {
    column[at..].first_chunk().unwrap_or(&[0.0; LANES])
}

/// Puts in all bounds of a window, with vectors as wide as the processor has them; in every bit the same.
struct Lay<'a, const N: usize>(&'a mut Valley);

impl<const N: usize> NullaryFnOnce for Lay<'_, N> {
    type Output = ();

    #[inline(always)]
    fn call(self) {
        let Valley { ground, rows, h, x, .. } = self.0;
        ground.level::<N>(h, x);
        for base in (0..h.len() - 1).step_by(LANES) {
            ground.put::<N>(base, x, rows);
        }
    }
}

impl Valley {
    /// The bounds at all places, in the order of the control points that they begin with.
    pub(super) fn bound<const N: usize>(&mut self, road: &Road<'_, N, impl Fn(&Node) -> f64>, first: u64) {
        self.rows.clear();
        self.speeds.begin(&self.h);
        self.ground.survey(road, first, &self.s);
        Arch::new().dispatch(Lay::<N>(self));
    }

    /// Whether it is so much faster than the plan somewhere that bounds which were far from that may be none of those set.
    pub(super) fn outgrew(&self) -> bool {
        let free = 2..self.h.len() - 2;
        self.x[free.clone()].iter().zip(&self.planned[free]).any(|(x, planned)| *x > FASTER * planned)
    }

    /// Bounds as tight as they were for the steps that are taken over, and as far as they were tightened since; looser where what was
    /// found for those steps is on one of them.
    pub(super) fn loosen(&mut self) {
        self.rows.tighten(&self.tighter);
        if self.taken == 0 {
            return;
        }
        self.look();
        for block in &mut self.rows.blocks {
            for i in (0..LANES).filter(|i| block.base + i + 2 <= self.taken) {
                let looser = ((1.0 - INSIDE as f32) / block.value[i].abs()).min(1.0);
                for c in &mut block.c {
                    c[i] *= looser;
                }
            }
        }
    }
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::limits::{Class, Inverses, Limits, Rates};
    use crate::path::shape::Cubic;
    use crate::timing::queue::{Pass, Queue};
    use ferrocut_machine::Machine;

    const CELLS: usize = 6;
    const LEN: f64 = 0.8;

    /// A curve of cubics of which the third derivative jumps where they meet.
    fn queue(inverses: &Inverses) -> Queue {
        let mut queue = Queue::new();
        let wave = |i: usize, by: f64| (i as f64 * by).sin();
        for k in 0..CELLS {
            let c = std::array::from_fn(|of| {
                let size = [0.0, 0.7, 0.08, 0.05][of];
                std::array::from_fn(|axis| size * (1.0 + wave(3 * k + axis, 1.7 + of as f64)))
            });
            let cubic = Cubic { c, len: LEN };
            let (rates, _): (Rates<3>, f64) = cubic.rates(1.0);
            let node = Node {
                s: k as f64 * LEN,
                len: LEN,
                load: inverses.of(Class::Cut).load(&rates),
                top: 200.0,
                most: 200.0,
                feed: 200.0,
                basis: 0.0,
                class: Class::Cut,
                pass: Pass::Path,
                turns_are_few: false,
                rests: k + 1 == CELLS,
            };
            queue.append_xyz(&cubic, &[0.0; AXES - 3], &node);
        }
        queue
    }

    #[test]
    fn rows_are_what_the_true_derivatives_take_of_the_bounds() {
        let inverses = Inverses::new(&Limits::new(&Machine::demo_mill()));
        let queue = queue(&inverses);
        let road = Road::<3, _> { queue: &queue, inverses: &inverses, cap: |node: &Node| node.most };
        // More places than there are in a block; some lie where cells meet.
        let places = 2 * LANES + 5;
        let all = CELLS as f64 * LEN;
        let mut valley = Valley::new();
        valley.s = (0..places).map(|k| all * k as f64 / (places - 1) as f64).collect();
        let step = |k: usize| valley.s[k + 1] - valley.s[k];
        valley.h =
            std::iter::once(step(0)).chain((0..places - 1).map(step)).chain([step(places - 2)]).collect();
        valley.x = (0..=places).map(|k| 2500.0 + 900.0 * (k as f64 * 0.4).sin()).collect();
        valley.x.resize(valley.h.len() + crate::timing::valley::PAD, 0.0);
        valley.bound(&road, 0);
        valley.look();
        let accelerated = |k: usize| (valley.x[k + 1] - valley.x[k]) / (valley.h[k] + valley.h[k + 1]);
        let inverse = inverses.of(Class::Cut);
        let mut seen = 0;
        for block in &valley.rows.blocks {
            for i in (0..LANES).filter(|i| block.counts[*i] > 0.0) {
                let k = block.base + i + block.root.place();
                let cell = road.cell(0, valley.s[k]);
                let side = if block.root == Root::Before && k > 0 && valley.s[k] <= queue.node(cell).s + 1e-12
                {
                    cell - 1
                } else {
                    cell
                };
                let [d1, d2, d3] = road.derivatives(side, valley.s[k]);
                let (x, a) = (valley.at(k).0, accelerated(k));
                let push = match block.root {
                    Root::None => 0.0,
                    Root::Behind => (accelerated(k + 1) - a) / valley.h[k + 1],
                    Root::Before => (a - accelerated(k - 1)) / valley.h[k],
                };
                let of_axis = |axis: usize| match block.root {
                    Root::None => {
                        (d2[axis] * x + d1[axis] * a) * inverse.acceleration[axis] / ACCELERATION_SHARE
                    }
                    Root::Behind | Root::Before => {
                        let line = d3[axis] * x + 3.0 * d2[axis] * a + d1[axis] * push;
                        line * x.sqrt() * inverse.jerk[axis] / JERK_SHARE
                    }
                };
                // One of the axes, or the speed.
                let value = f64::from(block.value[i]);
                let is_near = |expected: f64| (value - expected).abs() <= 1e-4 * (1.0 + expected.abs());
                let speed = valley.x[block.base + i] / (200.0 * 200.0);
                assert!(
                    (0..3).any(|axis| is_near(of_axis(axis))) || block.root == Root::None && is_near(speed),
                    "{:?} at {k}: {value}, {:?}",
                    block.root,
                    [0, 1, 2].map(of_axis)
                );
                seen += 1;
            }
        }
        assert!(seen == valley.rows.count && seen > 3 * places, "{seen} rows of {places} places");
    }
}
