//! The bounds of a valley as the interior point method goes through them: several rows at once.
//!
//! Rows of a kind at [`LANES`] places that follow each other are one [`Block`], so that the same is done to all of them by one
//! instruction. The blocks of the same places follow each other: what they add to the matrix is summed up before it goes there.
//!
//! Numbers of rows have 24 bits. Bounds are shares of one, known to a thousandth at the end, and every piece of what comes out is
//! looked at by itself; in half the room twice as many are done at once. The control points and the matrix have 53.

use super::Valley;
use super::band::Band;
use crate::quick::larger;
use ferrocut_geometry::AXES;

/// Rows of a block.
pub(super) const LANES: usize = 16;

/// Numbers, one for each row of a block.
pub(super) type Lanes = [f32; LANES];

/// Places behind the last that blocks reach over.
pub(super) const PAD: usize = LANES + 2;

/// Kinds of rows: speed, and of each axis and of the path acceleration, and jerk behind and before a place.
const KINDS: usize = 1 + 3 * (AXES + 1);

/// Whether a row is one of jerk, and of which side of its place.
#[derive(Clone, Copy, PartialEq, Eq, Debug, Default)]
pub(super) enum Root {
    /// It is not: `c₀x₀ + c₁x₁`, at the place between both.
    #[default]
    None,
    /// Behind the place between `x₀` and `x₁`.
    Behind,
    /// Before the place between `x₁` and `x₂`.
    Before,
}

impl Root {
    /// How far the place is from the control point that the row begins with.
    pub fn place(self) -> usize {
        usize::from(self == Root::Before)
    }
}

/// Bounds of a kind at places that follow each other, on both sides: `|√Xᵖ·(c₀x₀ + c₁x₁ + c₂x₂)| ≤ 1`.
#[derive(Clone, Copy, Debug, Default)]
pub(super) struct Block {
    pub c: [Lanes; 3],
    /// Number of `x₀` of the first row.
    pub base: usize,
    pub root: Root,
    /// 1 where there is a bound, else 0.
    pub counts: Lanes,
    /// Slacks and multipliers of both sides, and `1/z`.
    pub z: [Lanes; 2],
    pub l: [Lanes; 2],
    pub inverse: [Lanes; 2],
    /// How they change.
    pub dz: [Lanes; 2],
    pub dl: [Lanes; 2],
    /// Value and gradient as of now.
    pub value: Lanes,
    pub g: [Lanes; 3],
}

/// The rows that are put in.
#[derive(Debug)]
pub(super) struct Rows {
    pub blocks: Vec<Block>,
    /// How many bounds there are.
    pub count: usize,
}

impl Rows {
    /// For so many places.
    pub fn new(places: usize) -> Rows {
        let blocks = Vec::with_capacity(KINDS * (places / LANES + 2));
        Rows { blocks, count: 0 }
    }

    pub fn clear(&mut self) {
        self.blocks.clear();
        self.count = 0;
    }

    /// Puts in the rows that begin with the control points from `base` on, where one `counts`: those that begin with earlier ones
    /// are in already.
    #[inline(always)]
    pub fn put(&mut self, root: Root, base: usize, counts: Lanes, c: [Lanes; 3]) {
        let count: f32 = counts.iter().sum();
        if count > 0.0 {
            self.blocks.push(Block { c, base, root, counts, z: [[1.0; LANES]; 2], ..Block::default() });
            self.count += count as usize;
        }
    }

    /// Makes bounds so many times as tight, place by place.
    pub fn tighten(&mut self, tighter: &[f64]) {
        for block in &mut self.blocks {
            let places = tighter.iter().skip(block.base + block.root.place());
            for (i, tighter) in places.take(LANES).enumerate() {
                for c in &mut block.c {
                    c[i] *= *tighter as f32;
                }
            }
        }
    }
}

/// The numbers from `i` on.
#[inline(always)]
fn from(x: &[f32], i: usize) -> &Lanes {
    x[i..].first_chunk().unwrap_or(&[0.0; LANES])
}

/// What rows are worked out from.
#[derive(Debug)]
pub(super) struct Speeds {
    /// The control points, and by how much they are to change.
    x: Vec<f32>,
    change: Vec<f32>,
    /// Speed between the steps, and what the control points before and behind bear on it.
    v: Vec<f32>,
    before: Vec<f32>,
    behind: Vec<f32>,
    /// Of the control points before and behind in `x` there.
    weights: [Vec<f32>; 2],
}

impl Speeds {
    pub fn new(places: usize) -> Speeds {
        let room = || Vec::with_capacity(places + PAD);
        Speeds {
            x: room(),
            change: room(),
            v: room(),
            before: room(),
            behind: room(),
            weights: [room(), room()],
        }
    }

    /// The lengths of the steps.
    pub fn begin(&mut self, h: &[f64]) {
        let Speeds { v, before, behind, weights: [first, second], .. } = self;
        for to in [v, before, behind, &mut *first, &mut *second] {
            to.clear();
            to.resize(h.len() + PAD, 0.0);
        }
        for (k, pair) in h.windows(2).enumerate() {
            let both = (pair[0] + pair[1]).recip();
            (first[k], second[k]) = ((pair[1] * both) as f32, (pair[0] * both) as f32);
        }
    }

    /// With these control points; behind them there is room for [`PAD`] more.
    #[inline(always)]
    fn set(&mut self, x: &[f64]) {
        self.x.clear();
        self.x.extend(x.iter().map(|x| *x as f32));
        let places = x.len() - PAD;
        let to = self.v[..places].iter_mut().zip(&mut self.before[..places]).zip(&mut self.behind[..places]);
        let weights = self.weights[0][..places].iter().zip(&self.weights[1][..places]);
        let from = self.x[..places].iter().zip(&self.x[1..]).zip(weights);
        for (((v, before), behind), ((x0, x1), (w0, w1))) in to.zip(from) {
            let root = larger(1e-12, x0 * w0 + x1 * w1).sqrt();
            let half = 0.5 / root;
            (*v, *before, *behind) = (root, w0 * half, w1 * half);
        }
    }
}

/// What rows add to the matrix and the right side: to the diagonal at the three control points of each, beside it at the first two,
/// to the outer diagonal at the first, and to the right side at all three.
const SUMS: usize = 9;

/// The sums of that over the rows that begin with a control point.
///
/// Each is kept by itself until all rows are in. Added to the matrix at once, each would go beside where the one before went, and a
/// processor waits for a number that it is to read together with others of which only some were written a moment ago.
#[derive(Debug)]
pub(super) struct Sums([Vec<f32>; SUMS]);

/// Control points before the first, of which there are no rows.
const BEFORE: usize = 2;

impl Sums {
    /// For so many control points.
    pub fn new(points: usize) -> Sums {
        Sums([0; SUMS].map(|_| Vec::with_capacity(BEFORE + points + PAD)))
    }

    #[inline(always)]
    fn clear(&mut self, points: usize) {
        for sums in &mut self.0 {
            sums.clear();
            sums.resize(BEFORE + points + PAD, 0.0);
        }
    }

    /// The sums of the rows from control point `base` on.
    #[inline(always)]
    fn put(&mut self, base: usize, sums: &[Lanes; SUMS]) {
        for (to, sums) in self.0.iter_mut().zip(sums) {
            to[BEFORE + base..BEFORE + base + LANES].copy_from_slice(sums);
        }
    }

    /// Adds them to the matrix and the right side.
    #[inline(always)]
    fn pour(&self, band: &mut Band, points: usize) {
        let [a0, a1, a2, b0, b1, c, r0, r1, r2] = &self.0;
        // What rows add that begin `k` control points before.
        let from = |k: usize| BEFORE - k..BEFORE - k + points;
        let Band { diagonals: [diagonal, beside, outer], right } = band;
        for (to, sums) in [(diagonal, [a0, a1, a2]), (right, [r0, r1, r2])] {
            let [first, second, third] = [0, 1, 2].map(|k| &sums[k][from(k)]);
            for ((to, x), (y, z)) in to.iter_mut().zip(first).zip(second.iter().zip(third)) {
                *to += f64::from(x + y + z);
            }
        }
        for ((to, x), y) in beside.iter_mut().zip(&b0[from(0)]).zip(&b1[from(1)]) {
            *to += f64::from(x + y);
        }
        for (to, x) in outer.iter_mut().zip(&c[from(0)]) {
            *to += f64::from(*x);
        }
    }
}

// Each of these is one loop over all rows of a block, which is what compilers make vectors of.
impl Block {
    /// Value and gradient at `x`.
    #[inline(always)]
    fn look(&mut self, speeds: &Speeds) {
        let [x0, x1, x2] = [0, 1, 2].map(|k| from(&speeds.x, self.base + k));
        let at = self.base + self.root.place();
        let [v, before, behind] = [&speeds.v, &speeds.before, &speeds.behind].map(|speeds| from(speeds, at));
        let Block { c: [c0, c1, c2], value, g: [g0, g1, g2], .. } = self;
        match self.root {
            Root::None => {
                for i in 0..LANES {
                    value[i] = c0[i] * x0[i] + c1[i] * x1[i];
                    (g0[i], g1[i], g2[i]) = (c0[i], c1[i], 0.0);
                }
            }
            Root::Behind => {
                for i in 0..LANES {
                    let line = c0[i] * x0[i] + c1[i] * x1[i] + c2[i] * x2[i];
                    value[i] = line * v[i];
                    g0[i] = c0[i] * v[i] + line * before[i];
                    g1[i] = c1[i] * v[i] + line * behind[i];
                    g2[i] = c2[i] * v[i];
                }
            }
            Root::Before => {
                for i in 0..LANES {
                    let line = c0[i] * x0[i] + c1[i] * x1[i] + c2[i] * x2[i];
                    value[i] = line * v[i];
                    g0[i] = c0[i] * v[i];
                    g1[i] = c1[i] * v[i] + line * before[i];
                    g2[i] = c2[i] * v[i] + line * behind[i];
                }
            }
        }
    }

    /// Slacks of at least `least`, and multipliers of which each product with its slack is `mu`.
    fn slacken(&mut self, least: f32, mu: f32) {
        for i in 0..LANES {
            let value = self.value[i];
            for (side, slack) in [1.0 - value, 1.0 + value].into_iter().enumerate() {
                self.z[side][i] = larger(least, slack);
                self.l[side][i] = self.counts[i] * mu / self.z[side][i];
            }
        }
    }

    /// Goes on to the new slacks and multipliers.
    #[inline(always)]
    fn step(&mut self, [far, far_l]: [f32; 2]) {
        let Block { z: [z0, z1], l: [l0, l1], dz: [dz0, dz1], dl: [dl0, dl1], .. } = self;
        for i in 0..LANES {
            z0[i] += far * dz0[i];
            z1[i] += far * dz1[i];
            l0[i] += far_l * dl0[i];
            l1[i] += far_l * dl1[i];
        }
    }

    /// Adds to the `sums` of the matrix and of the right side.
    #[inline(always)]
    fn assemble(&mut self, mu: f32, sums: &mut [Lanes; SUMS]) {
        let Block { z: [z0, z1], l: [l0, l1], inverse: [inverse0, inverse1], value, counts, .. } = self;
        let [g0, g1, g2] = &self.g;
        let [a0, a1, a2, b0, b1, c, r0, r1, r2] = sums;
        for i in 0..LANES {
            let (i0, i1) = (z0[i].recip(), z1[i].recip());
            (inverse0[i], inverse1[i]) = (i0, i1);
            let (w0, w1) = (l0[i] * i0, l1[i] * i1);
            let weight = w0 + w1;
            let push =
                mu * counts[i] * (i1 - i0) - w1 * (1.0 + value[i] - z1[i]) + w0 * (1.0 - value[i] - z0[i]);
            let (g0, g1, g2) = (g0[i], g1[i], g2[i]);
            let (w0, w1) = (weight * g0, weight * g1);
            a0[i] += w0 * g0;
            a1[i] += w1 * g1;
            a2[i] += weight * g2 * g2;
            b0[i] += w0 * g1;
            b1[i] += w1 * g2;
            c[i] += w0 * g2;
            r0[i] += push * g0;
            r1[i] += push * g1;
            r2[i] += push * g2;
        }
    }

    /// How slacks and multipliers change where control points do by `change`: the most that each of them falls by, as a share of
    /// itself, and the terms of their products.
    #[inline(always)]
    fn lead(&mut self, change: &[f32], mu: f32, most: &mut [Lanes; 2], products: &mut [Lanes; 4]) {
        let [d0, d1, d2] = [0, 1, 2].map(|k| from(change, self.base + k));
        let Block { z: [z0, z1], l: [l0, l1], inverse: [inverse0, inverse1], value, counts, .. } = self;
        let [g0, g1, g2] = &self.g;
        let ([dz0, dz1], [dl0, dl1]) = (&mut self.dz, &mut self.dl);
        let [most_z, most_l] = most;
        let [zl, dz_l, z_dl, both] = products;
        for i in 0..LANES {
            let to = g0[i] * d0[i] + g1[i] * d1[i] + g2[i] * d2[i] + value[i];
            let (a, b) = (1.0 - to - z0[i], 1.0 + to - z1[i]);
            let mu = mu * counts[i];
            let da = (mu - l0[i] * a) * inverse0[i] - l0[i];
            let db = (mu - l1[i] * b) * inverse1[i] - l1[i];
            (dz0[i], dz1[i], dl0[i], dl1[i]) = (a, b, da, db);
            most_z[i] = larger(larger(most_z[i], -a * inverse0[i]), -b * inverse1[i]);
            most_l[i] = larger(larger(most_l[i], -da / l0[i]), -db / l1[i]);
            zl[i] += z0[i] * l0[i] + z1[i] * l1[i];
            dz_l[i] += a * l0[i] + b * l1[i];
            z_dl[i] += z0[i] * da + z1[i] * db;
            both[i] += a * da + b * db;
        }
    }
}

/// What an iteration leads to.
#[derive(Clone, Copy, Debug)]
pub(super) struct Lead {
    /// The most that a slack and that a multiplier falls by, as a share of itself.
    pub most: [f64; 2],
    products: [f64; 4],
}

impl Lead {
    /// The sum of the products of slacks and multipliers behind a step.
    #[inline(always)]
    pub fn sum(&self, [far, far_l]: [f64; 2]) -> f64 {
        let [zl, dz_l, z_dl, both] = self.products;
        zl + far * dz_l + far_l * z_dl + far * far_l * both
    }
}

impl Valley {
    /// Value and gradient of every bound as of now.
    pub(super) fn look(&mut self) {
        let Valley { x, rows, speeds, .. } = self;
        speeds.set(x);
        for block in &mut rows.blocks {
            block.look(speeds);
        }
    }

    /// Slacks of at least `least` and multipliers at the plan as it is.
    pub(super) fn slacken_rows(&mut self, least: f64, mu: f64) {
        self.look();
        for block in &mut self.rows.blocks {
            block.slacken(least as f32, mu as f32);
        }
    }

    /// Goes on by the last step, and adds what the bounds ask for to the matrix and the right side.
    #[inline(always)]
    pub(super) fn assemble_rows(&mut self, step: [f64; 2], mu: f64) {
        let Valley { x, h, rows, speeds, band, sums: all, .. } = self;
        speeds.set(x);
        all.clear(h.len());
        let step = step.map(|step| step as f32);
        let (mut base, mut sums) = (0, [[0.0; LANES]; SUMS]);
        for block in &mut rows.blocks {
            if block.base != base {
                all.put(base, &sums);
                (base, sums) = (block.base, [[0.0; LANES]; SUMS]);
            }
            block.step(step);
            block.look(speeds);
            block.assemble(mu as f32, &mut sums);
        }
        all.put(base, &sums);
        all.pour(band, h.len());
    }

    /// Where the solution of the system leads.
    #[inline(always)]
    pub(super) fn lead(&mut self, mu: f64) -> Lead {
        let (mut most, mut products) = ([[0.0; LANES]; 2], [[0.0; LANES]; 4]);
        let change = &mut self.speeds.change;
        change.clear();
        change.extend(self.band.right.iter().map(|right| *right as f32));
        for block in &mut self.rows.blocks {
            block.lead(change, mu as f32, &mut most, &mut products);
        }
        Lead {
            most: most.map(|most| f64::from(most.into_iter().fold(0.0, larger))),
            products: products.map(|lanes| lanes.into_iter().map(f64::from).sum()),
        }
    }

    /// Goes on by the last step.
    #[inline(always)]
    pub(super) fn step_rows(&mut self, step: [f64; 2]) {
        for block in &mut self.rows.blocks {
            block.step(step.map(|step| step as f32));
        }
    }
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::timing::valley::solve::{FIRST_GAP, Solution};

    /// What is worked out with 24 bits, of numbers about 1.
    const EXACT: f64 = 1e-6;

    /// Bounds of every kind at places that are no multiple of a block.
    fn valley() -> Valley {
        let mut valley = Valley::new();
        let places = 2 * LANES + 3;
        let wave = |i: usize, by: f64| (i as f64 * by).sin();
        valley.h = (0..=places).map(|i| 0.1 + 0.03 * wave(i, 1.7)).collect();
        valley.x = (0..=places).map(|i| 90.0 + 40.0 * wave(i, 0.9)).collect();
        valley.x.resize(valley.h.len() + PAD, 0.0);
        valley.speeds.begin(&valley.h);
        let c = |i: usize, by: f64| [2e-3 * wave(i, by), -3e-3 * wave(i, by + 0.5), 1e-3 * wave(i, by + 1.0)];
        for base in (0..places).step_by(LANES) {
            for (root, by) in [(Root::Before, 0.4), (Root::None, 1.1), (Root::Behind, 2.3)] {
                let (mut counts, mut rows) = ([0.0; LANES], [[0.0; LANES]; 3]);
                let is_one = |k: usize| match root {
                    Root::None => k < places - 1 && !k.is_multiple_of(3),
                    Root::Behind => k < places - 1,
                    Root::Before => k < places - 2,
                };
                for i in (0..LANES).filter(|i| is_one(base + i)) {
                    counts[i] = 1.0;
                    let [c0, c1, c2] = c(base + i + root.place(), by);
                    let c2 = if root == Root::None { 0.0 } else { c2 };
                    (rows[0][i], rows[1][i], rows[2][i]) = (c0 as f32, c1 as f32, c2 as f32);
                }
                valley.rows.put(root, base, counts, rows);
            }
        }
        valley
    }

    /// The bound of row `i` of a block as the mathematics say.
    fn value(valley: &Valley, block: &Block, i: usize) -> f64 {
        let (x, h, base) = (&valley.x, &valley.h, block.base + i);
        let line: f64 = (0..3).map(|k| f64::from(block.c[k][i]) * x[base + k]).sum();
        let place = base + block.root.place();
        let at = (x[place] * h[place + 1] + x[place + 1] * h[place]) / (h[place] + h[place + 1]);
        if block.root == Root::None { line } else { line * at.sqrt() }
    }

    #[test]
    fn values_and_gradients_are_those_of_the_bounds() {
        let mut valley = valley();
        valley.look();
        let (blocks, mut seen) = (valley.rows.blocks.clone(), 0);
        for block in &blocks {
            for i in (0..LANES).filter(|i| block.counts[*i] > 0.0) {
                seen += 1;
                let now = value(&valley, block, i);
                assert!((f64::from(block.value[i]) - now).abs() < EXACT, "{} {now}", block.value[i]);
                for k in 0..3 {
                    let step = 1e-4;
                    let mut other = |by: f64| {
                        valley.x[block.base + i + k] += by;
                        let there = value(&valley, block, i);
                        valley.x[block.base + i + k] -= by;
                        there
                    };
                    let slope = (other(step) - other(-step)) / (2.0 * step);
                    assert!(
                        (f64::from(block.g[k][i]) - slope).abs() < EXACT,
                        "{:?} {k}: {} {slope}",
                        block.root,
                        block.g[k][i]
                    );
                }
            }
        }
        assert_eq!(seen, valley.rows.count);
    }

    #[test]
    fn the_processor_makes_no_difference() {
        let solved = |solve: fn(&mut Valley, f64) -> Solution| {
            let mut valley = valley();
            let planned = valley.slacken();
            let solution = solve(&mut valley, planned);
            (solution, valley.x.iter().map(|x| x.to_bits()).collect::<Vec<_>>())
        };
        // With the vectors that the processor has, and with those that all have.
        let dispatched = solved(|valley, planned| valley.solve(planned, FIRST_GAP));
        let plain = solved(|valley, planned| valley.iterate(planned, FIRST_GAP));
        assert_eq!(dispatched, plain);
    }

    #[test]
    fn rows_that_are_none_add_nothing() {
        let mut valley = valley();
        valley.slacken_rows(0.15, 1e-3);
        let n = valley.h.len() + PAD;
        valley.band.diagonals = [0; 3].map(|_| vec![0.0; n]);
        valley.band.right = vec![0.0; n];
        valley.assemble_rows([0.0; 2], 1e-3);
        // The sums are those of the bounds one by one.
        let mut expected = ([0; 3].map(|_| vec![0.0; n]), vec![0.0; n]);
        for block in &valley.rows.blocks {
            for i in (0..LANES).filter(|i| block.counts[*i] > 0.0) {
                let (value, g) = (f64::from(block.value[i]), block.g.map(|g| f64::from(g[i])));
                let [(w0, p0), (w1, p1)] = [(0, 1.0 - value), (1, 1.0 + value)].map(|(side, bound)| {
                    let (z, l) = (f64::from(block.z[side][i]), f64::from(block.l[side][i]));
                    (l / z, (1e-3 - l * (bound - z)) / z)
                });
                for row in 0..3 {
                    for column in row..3 {
                        expected.0[column - row][block.base + i + row] += (w0 + w1) * g[row] * g[column];
                    }
                    expected.1[block.base + i + row] += (p1 - p0) * g[row];
                }
            }
        }
        for (found, expected) in valley.band.diagonals.iter().flatten().zip(expected.0.iter().flatten()) {
            assert!((found - expected).abs() <= EXACT * expected.abs().max(EXACT), "{found} {expected}");
        }
        for (found, expected) in valley.band.right.iter().zip(&expected.1) {
            assert!((found - expected).abs() <= EXACT * expected.abs().max(EXACT), "{found} {expected}");
        }
        let right: Vec<f64> = valley.band.right.iter().map(|r| 1e-3 * r).collect();
        valley.band.right = right;
        let lead = valley.lead(1e-3);
        // Each product of slack and multiplier is what they began with.
        let all = 2.0 * valley.rows.count as f64 * 1e-3;
        assert!((lead.sum([0.0; 2]) - all).abs() < EXACT, "{} {all}", lead.sum([0.0; 2]));
        for block in &valley.rows.blocks {
            for i in (0..LANES).filter(|i| block.counts[*i] == 0.0) {
                assert_eq!([block.dl[0][i], block.dl[1][i], block.l[0][i], block.l[1][i]], [0.0; 4]);
            }
        }
        // The sum behind a step is what it says.
        let step = [0.7, 0.4];
        valley.step_rows(step);
        let mut sum = 0.0;
        for block in &valley.rows.blocks {
            for i in 0..LANES {
                let [z, l] = [block.z, block.l].map(|sides| sides.map(|side| f64::from(side[i])));
                sum += z[0] * l[0] + z[1] * l[1];
            }
        }
        assert!((lead.sum(step) - sum).abs() < EXACT, "{} {sum}", lead.sum(step));
    }
}
