//! The way of one side of a corner that swings out.
//!
//! A corner rounded in time ([`crate::path::corner`]) adds what is left of the first line, `−d₁·r·f(1−x)`, to what is gone
//! of the second, `d₂·r·f(x)`, with `f = x³`. That leaves the lines on the inside alone. If `f` goes back a little at
//! first, the path swings out to the other side before it turns, and what it has to turn in is longer and run faster:
//!
//! ```text
//! f‴ = −σ  for x < β        μ₁  up to ½        μ₂  up to 1 − β        ν  behind        f(0) = f′(0) = f″(0) = 0,  f(1) = 1
//! ```
//!
//! With `g = −min f` and the turn `θ`, the path leaves the lines by `r·g·sin θ` on the outside and passes the vertex at
//! `r·f(½)·|d₂ − d₁|`. Its jerk, for a duration of 1, is one of
//!
//! ```text
//! r·(ν·d₁ − σ·d₂)      r·(μ₂·d₁ + μ₁·d₂)      r·(μ₁·d₁ + μ₂·d₂)      r·(ν·d₂ − σ·d₁)
//! ```
//!
//! and the acceleration is linear between, so that both are known by their values in five places. With `μ₁ = μ₂` all the
//! jerk of the middle is along `d₁ + d₂`; with `μ₁ > μ₂` the acceleration across that is highest at the vertex, where the
//! jerk of the axes that turn back is used too. That is so without going back as well (`β = 0`): where there is too little of
//! the lines for a swing, all of the tolerance is taken at the vertex.

/// One side: how far it is along its line, as a share of the reach.
#[derive(Clone, Copy, PartialEq, Debug)]
pub(crate) struct Swing {
    /// `β`.
    share: f64,
    /// `−σ`, `μ₁`, `μ₂`, `ν`.
    jerks: [f64; 4],
    /// How far it goes back.
    depth: f64,
}

/// `f`, `f′` and `f″`.
type State = [f64; 3];

#[inline]
fn go_on([f, v, a]: State, jerk: f64, x: f64) -> State {
    [f + x * (v + x * (0.5 * a + x * jerk / 6.0)), v + x * (a + 0.5 * x * jerk), a + x * jerk]
}

/// How far from a state that goes back it turns round; infinite if it does not.
fn turn_from([_, v, a]: State, jerk: f64) -> f64 {
    // v + a·x + jerk·x²/2 = 0, with v ≤ 0.
    let root = (a * a - 2.0 * jerk * v).max(0.0).sqrt();
    let speed = a + root;
    if speed > 0.0 { -2.0 * v / speed } else { f64::INFINITY }
}

impl Swing {
    /// With `β` and the proportions `σ : μ₁ : μ₂ : ν`. `None` if it does not come to the end of its line speeding up.
    pub fn new(share: f64, [out, rise, fall, end]: [f64; 4]) -> Option<Swing> {
        let mut swing = Swing { share, jerks: [-out, rise, fall, end], depth: 0.0 };
        let [f, v, a] = swing.at(1.0);
        // Back is gone in the middle parts, and no more than that.
        if !(f > 0.0 && v > 0.0 && a >= 0.0 && share < 0.5) {
            return None;
        }
        if share == 0.0 {
            // It never goes back.
            swing.jerks = swing.jerks.map(|jerk| jerk / f);
            return (rise > 0.0).then_some(swing);
        }
        let back = swing.at(share);
        let mut turn = share + turn_from(back, rise);
        if turn > 0.5 {
            turn = 0.5 + turn_from(swing.at(0.5), fall);
        }
        if !(turn <= 1.0 - share) {
            return None;
        }
        swing.jerks = swing.jerks.map(|jerk| jerk / f);
        swing.depth = -swing.at(turn)[0];
        Some(swing)
    }

    /// `f`, `f′` and `f″` at `x`.
    #[inline]
    pub fn at(&self, x: f64) -> State {
        let [out, rise, fall, end] = self.jerks;
        let last = 1.0 - self.share;
        let state = go_on([0.0; 3], out, x.min(self.share));
        let state = go_on(state, rise, (x.min(0.5) - self.share).max(0.0));
        let state = go_on(state, fall, (x.min(last) - 0.5).max(0.0));
        go_on(state, end, (x - last).max(0.0))
    }

    /// How far it goes back.
    pub fn depth(&self) -> f64 {
        self.depth
    }

    /// `f″` where the jerk changes, and at the ends.
    pub fn bends(&self) -> [f64; 5] {
        [0.0, self.share, 0.5, 1.0 - self.share, 1.0].map(|x| self.at(x)[2])
    }

    /// `f‴` in its four parts.
    pub fn jerks(&self) -> [f64; 4] {
        self.jerks
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn it_goes_back_first_and_ends_at_one() {
        let swing = Swing::new(0.15, [0.7, 1.0, 0.6, 0.4]).unwrap();
        assert!((swing.at(1.0)[0] - 1.0).abs() < 1e-12);
        let least = (0..=10_000).map(|k| swing.at(f64::from(k) / 1e4)[0]).fold(f64::INFINITY, f64::min);
        assert!(least < -1e-3 && (least + swing.depth()).abs() < 1e-8, "{least} {}", swing.depth());
        // Its derivatives are the slopes of each other.
        for k in 1..100 {
            let (x, h) = (f64::from(k) / 100.0 + 1e-4, 1e-5);
            let (a, b, c) = (swing.at(x - h), swing.at(x), swing.at(x + h));
            for i in 0..2 {
                assert!(((c[i] - a[i]) / (2.0 * h) - b[i + 1]).abs() < 1e-6 * (1.0 + b[i + 1].abs()), "{x}");
            }
        }
    }

    #[test]
    fn without_a_swing_it_never_goes_back() {
        for lean in [1.0, 0.5, 0.0, -0.5, -0.9] {
            let swing = Swing::new(0.0, [0.0, 1.0, lean, 0.0]).unwrap();
            let mut before = 0.0;
            for k in 1..=1000 {
                let [f, v, a] = swing.at(f64::from(k) / 1000.0);
                assert!(f > before && v > 0.0 && a > -1e-12, "{lean} {k}");
                before = f;
            }
            assert!((before - 1.0).abs() < 1e-12 && swing.depth() == 0.0);
        }
        // It would come to the end of its line slowing down.
        assert_eq!(Swing::new(0.0, [0.0, 1.0, -1.1, 0.0]), None);
    }

    #[test]
    fn one_that_never_comes_back_is_none() {
        assert_eq!(Swing::new(0.45, [1.0, 1.0, 1.0, -1.0]), None);
    }
}
