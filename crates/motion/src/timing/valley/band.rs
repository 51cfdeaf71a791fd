//! Systems of equations that are symmetric and have two diagonals on either side.
//!
//! `L·D·Lᵀ` is found from both ends at once, until two rows in the middle are left. The rows of either half wait for each other,
//! each for a division and what is multiplied behind it, but not for those of the other half: a processor does both in the time
//! of one.

/// Such a system.
#[derive(Debug)]
pub(super) struct Band {
    /// Entry `i` of each is in row `i`: on the diagonal, beside it, and beside that. Behind a solution the factors.
    pub diagonals: [Vec<f64>; 3],
    /// The right side, then what solves it.
    pub right: Vec<f64>,
}

/// What the rows that are done take from the next one, the last of them and the one before it, and from the one behind that: of the
/// diagonal, of what is beside it, of the right side.
#[derive(Clone, Copy, Default)]
struct Taken {
    next: [f64; 3],
    earlier: [f64; 2],
    behind: [f64; 2],
}

impl Taken {
    /// Does a row with these entries: `1/d`, its entries of `L`, and its right side. `None` if the matrix is not positive.
    #[inline(always)]
    fn row(&mut self, [d, e, f]: [f64; 3], right: f64) -> Option<([f64; 3], f64)> {
        // What is known last comes last: the next row waits for it.
        let (d, e) = ((d - self.earlier[0]) - self.next[0], e - self.next[1]);
        let right = (right - self.earlier[1]) - self.next[2];
        if !(d > 0.0) {
            return None;
        }
        let inverse = d.recip();
        let (l1, l2) = (e * inverse, f * inverse);
        self.next = [l1 * e, l1 * f, l1 * right];
        (self.earlier, self.behind) = (self.behind, [l2 * f, l2 * right]);
        Some(([inverse, l1, l2], right))
    }
}

impl Band {
    /// For so many rows.
    pub fn new(rows: usize) -> Band {
        let room = || Vec::with_capacity(rows);
        Band { diagonals: [room(), room(), room()], right: room() }
    }

    /// Solves the first `n` rows in place. `false` if the matrix is not positive.
    #[inline(always)]
    pub fn solve(&mut self, n: usize) -> bool {
        let [d, e, f] = self.diagonals.each_mut().map(|diagonal| &mut diagonal[..n]);
        let x = &mut self.right[..n];
        let Some(middle) = (n / 2).checked_sub(1) else { return false };
        let (mut above, mut below) = (Taken::default(), Taken::default());
        for i in 0..n - middle - 2 {
            // Below there is one more where their number is odd.
            let k = n - 1 - i;
            let Some((factors, right)) = below.row([d[k], e[k - 1], f[k - 2]], x[k]) else { return false };
            [d[k], e[k - 1], f[k - 2]] = factors;
            x[k] = right;
            if i < middle {
                let Some((factors, right)) = above.row([d[i], e[i], f[i]], x[i]) else { return false };
                [d[i], e[i], f[i]] = factors;
                x[i] = right;
            }
        }
        // What is left of the two rows in the middle.
        let (p, q) = (middle, middle + 1);
        let beside = e[p] - above.next[1] - below.next[1];
        let [above_next, below_next] =
            [above, below].map(|Taken { next, earlier, .. }| [next[0] + earlier[0], next[2] + earlier[1]]);
        let (d0, d1) = (d[p] - above_next[0] - below.behind[0], d[q] - above.behind[0] - below_next[0]);
        let (r0, r1) = (x[p] - above_next[1] - below.behind[1], x[q] - above.behind[1] - below_next[1]);
        let l = beside / d0;
        let rest = d1 - l * beside;
        if !(d0 > 0.0 && rest > 0.0) {
            return false;
        }
        x[q] = (r1 - l * r0) / rest;
        x[p] = r0 / d0 - l * x[q];
        for i in (0..n - middle - 2).rev() {
            let k = n - 1 - i;
            x[k] = (x[k] * d[k] - f[k - 2] * x[k - 2]) - e[k - 1] * x[k - 1];
            if i < middle {
                x[i] = (x[i] * d[i] - f[i] * x[i + 2]) - e[i] * x[i + 1];
            }
        }
        true
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn what_is_found_solves_it() {
        for n in 3..12 {
            let wave = |i: usize, by: f64| (i as f64 * by).sin();
            let mut band = Band::new(n);
            for i in 0..n {
                for (diagonal, entry) in
                    band.diagonals.iter_mut().zip([4.0 + wave(i, 1.3), wave(i, 0.7), 0.8 * wave(i, 2.1)])
                {
                    diagonal.push(entry);
                }
                band.right.push(wave(i, 0.4) - 0.2);
            }
            let ([d, e, f], right) = (band.diagonals.clone(), band.right.clone());
            assert!(band.solve(n));
            let x = &band.right;
            for i in 0..n {
                let above = |diagonal: &[f64], k: usize| {
                    i.checked_sub(k).map_or(0.0, |above| diagonal[above] * x[above])
                };
                let below =
                    |diagonal: &[f64], k: usize| x.get(i + k).map_or(0.0, |below| diagonal[i] * below);
                let sum = d[i] * x[i] + above(&e, 1) + above(&f, 2) + below(&e, 1) + below(&f, 2);
                assert!((sum - right[i]).abs() < 1e-12, "{n} {i}: {sum} {}", right[i]);
            }
        }
    }

    #[test]
    fn a_matrix_that_is_not_positive_is_told() {
        for bad in 0..6 {
            let mut band =
                Band { diagonals: [vec![2.0; 6], vec![0.1; 6], vec![0.1; 6]], right: vec![1.0; 6] };
            band.diagonals[0][bad] = -1.0;
            assert!(!band.solve(6), "{bad}");
        }
    }
}
