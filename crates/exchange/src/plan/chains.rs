//! Curves that meet end to end, joined into chains.

use super::{Cut, MEET};
use ferrocut_geometry::vector::{Point, cross, distance, sub};
use rustc_hash::FxHashMap;

/// Curves in the order in which they run on from one to the next, chain after chain.
#[derive(Clone, PartialEq, Debug, Default)]
pub struct Chains {
    cuts: Vec<Cut>,
    /// Where each chain ends in `cuts`, and whether its last curve ends where its first starts.
    ends: Vec<(u32, bool)>,
}

/// One chain: its curves, each from where the one before ends.
#[derive(Clone, Copy, PartialEq, Debug)]
pub struct Chain<'a> {
    /// The curves.
    pub cuts: &'a [Cut],
    /// Whether the last ends where the first starts.
    pub is_closed: bool,
}

impl Chains {
    /// How many there are.
    pub fn len(&self) -> usize {
        self.ends.len()
    }

    /// Whether there is none.
    pub fn is_empty(&self) -> bool {
        self.ends.is_empty()
    }

    /// The chain with this number.
    pub fn get(&self, number: usize) -> Option<Chain<'_>> {
        let (end, is_closed) = *self.ends.get(number)?;
        let before = number.checked_sub(1).and_then(|before| self.ends.get(before));
        let start = before.map_or(0, |(end, _)| *end);
        Some(Chain { cuts: self.cuts.get(start as usize..end as usize)?, is_closed })
    }

    /// The chains in order.
    pub fn iter(&self) -> impl Iterator<Item = Chain<'_>> {
        (0..self.len()).filter_map(|number| self.get(number))
    }
}

impl Chain<'_> {
    /// Where it starts.
    pub fn from(&self) -> Point {
        self.cuts.first().map_or([0.0; 2], |cut| cut.curve.from)
    }

    /// Where it ends.
    pub fn to(&self) -> Point {
        self.cuts.last().map_or([0.0; 2], |cut| cut.curve.to)
    }

    /// Number of its layer.
    pub fn layer(&self) -> u32 {
        self.cuts.first().map_or(0, |cut| cut.layer)
    }

    /// Smallest and largest coordinates.
    pub fn extent(&self) -> [Point; 2] {
        let mut all = [[f64::INFINITY; 2], [f64::NEG_INFINITY; 2]];
        for cut in self.cuts {
            let [low, high] = cut.curve.extent();
            for i in 0..2 {
                all[0][i] = all[0][i].min(low[i]);
                all[1][i] = all[1][i].max(high[i]);
            }
        }
        all
    }

    /// Whether a point lies inside of the closed chain: a ray from it crosses an odd number of sides. The
    /// chords make a polygon; each arc adds or takes away the piece between it and its chord.
    pub fn holds(&self, p: Point) -> bool {
        let mut inside = false;
        for Cut { curve, .. } in self.cuts {
            let (a, b) = (curve.from, curve.to);
            if (a[1] > p[1]) != (b[1] > p[1]) {
                let x = a[0] + (b[0] - a[0]) * ((p[1] - a[1]) / (b[1] - a[1]));
                inside ^= p[0] < x;
            }
            if let Some(bend) = curve.bend {
                let within = distance(bend.center, p) < curve.radius();
                let is_circle = a == b;
                // The arc bulges to the right of its chord if it turns counter-clockwise.
                let side = cross(sub(b, a), sub(p, a)) * bend.sweep;
                inside ^= within && (is_circle || side < 0.0);
            }
        }
        inside
    }
}

/// Runs curves backwards.
fn reverse(cuts: &mut [Cut]) {
    cuts.reverse();
    for cut in cuts {
        cut.curve = cut.curve.reversed();
    }
}

/// Ends of curves, found by place.
struct Ends {
    /// The first end of each cell of the plane: twice the number of the curve, plus one for its `to`.
    heads: FxHashMap<(u32, i64, i64), u32>,
    /// The next end in the same cell.
    next: Vec<u32>,
}

const NONE: u32 = u32::MAX;

fn cell(p: Point) -> (i64, i64) {
    // Coordinates are below a hundred metres: the cells' numbers are far from the ends of i64.
    ((p[0] / MEET).floor() as i64, (p[1] / MEET).floor() as i64)
}

impl Ends {
    fn of(cuts: &[Cut]) -> Ends {
        let mut ends = Ends { heads: FxHashMap::default(), next: vec![NONE; cuts.len() * 2] };
        // From behind, so that the first curve of the file comes first.
        for (i, cut) in cuts.iter().enumerate().rev() {
            for (end, p) in [(1, cut.curve.to), (0, cut.curve.from)] {
                let (x, y) = cell(p);
                let number = i as u32 * 2 + end;
                let head = ends.heads.entry((cut.layer, x, y)).or_insert(NONE);
                if let Some(next) = ends.next.get_mut(number as usize) {
                    *next = *head;
                }
                *head = number;
            }
        }
        ends
    }

    /// An end of a curve that is not used yet, on this layer, at `p`. Ends of used curves are taken out
    /// on the way, so that each is passed once.
    fn take_at(&mut self, layer: u32, p: Point, cuts: &[Cut], used: &[bool]) -> Option<(usize, bool)> {
        let (x, y) = cell(p);
        for (dx, dy) in [(0, 0), (-1, 0), (1, 0), (0, -1), (0, 1), (-1, -1), (1, -1), (-1, 1), (1, 1)] {
            let key = (layer, x + dx, y + dy);
            let Some(head) = self.heads.get_mut(&key) else { continue };
            while *head != NONE && used.get(*head as usize / 2).copied().unwrap_or(true) {
                *head = self.next.get(*head as usize).copied().unwrap_or(NONE);
            }
            let mut end = *head;
            while end != NONE {
                let after = self.next.get(end as usize).copied().unwrap_or(NONE);
                let (index, is_to) = (end as usize / 2, end % 2 == 1);
                let cut = cuts.get(index)?;
                let at = if is_to { cut.curve.to } else { cut.curve.from };
                if !used.get(index).copied().unwrap_or(true) && distance(at, p) <= MEET {
                    return Some((index, is_to));
                }
                // The one behind is taken out if it is used.
                let behind = self.next.get(after as usize).copied().unwrap_or(NONE);
                let is_used = after != NONE && used.get(after as usize / 2).copied().unwrap_or(true);
                if let Some(next) = self.next.get_mut(end as usize).filter(|_| is_used) {
                    *next = behind;
                } else {
                    end = after;
                }
            }
        }
        None
    }
}

/// Joins curves of one layer whose ends meet.
pub fn join(cuts: &[Cut]) -> Chains {
    let mut ends = Ends::of(cuts);
    let mut used = vec![false; cuts.len()];
    let mut chains = Chains { cuts: Vec::with_capacity(cuts.len()), ends: Vec::new() };
    for (i, cut) in cuts.iter().enumerate() {
        if std::mem::replace(used.get_mut(i).unwrap_or(&mut true), true) {
            continue;
        }
        let start = chains.cuts.len();
        chains.cuts.push(*cut);
        let mut is_closed = cut.curve.bend.is_some() && cut.curve.from == cut.curve.to;
        // Forwards from the end, then backwards from the start.
        for _ in 0..2 {
            while !is_closed
                && let Some(last) = chains.cuts.last()
                && let Some((next, is_to)) = ends.take_at(cut.layer, last.curve.to, cuts, &used)
                && let (Some(found), Some(used)) = (cuts.get(next), used.get_mut(next))
            {
                *used = true;
                let curve = if is_to { found.curve.reversed() } else { found.curve };
                chains.cuts.push(Cut { curve, ..*found });
                let first = chains.cuts.get(start).map_or(curve.to, |first| first.curve.from);
                is_closed = distance(first, curve.to) <= MEET;
            }
            reverse(chains.cuts.get_mut(start..).unwrap_or(&mut []));
        }
        chains.ends.push((chains.cuts.len() as u32, is_closed));
    }
    chains
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::curve::Curve;
    use ferrocut_program::Span;

    pub fn lines(points: &[[Point; 2]]) -> Vec<Cut> {
        points
            .iter()
            .map(|[a, b]| Cut { curve: Curve::line(*a, *b), layer: 0, span: Span::default() })
            .collect()
    }

    #[test]
    fn scattered_sides_make_a_square_and_a_tail() {
        let sides = [
            [[0.0, 0.0], [1.0, 0.0]],
            [[1.0, 1.0], [0.0, 1.0]],
            [[5.0, 5.0], [6.0, 5.0]],
            [[1.0, 1.0], [1.0, 0.0]],
            [[0.0, 0.0], [0.0, 1.0]],
            [[5.0, 5.0004], [4.0, 4.0]],
        ];
        let chains = join(&lines(&sides));
        let chains: Vec<Chain> = chains.iter().collect();
        let sizes: Vec<_> = chains.iter().map(|c| (c.cuts.len(), c.is_closed)).collect();
        assert_eq!(sizes, [(4, true), (2, false)]);
        for chain in &chains {
            for pair in chain.cuts.windows(2) {
                assert!(distance(pair[0].curve.to, pair[1].curve.from) <= MEET);
            }
        }
        assert_eq!(chains[1].from(), [4.0, 4.0]);
        assert_eq!(chains[0].from(), [0.0, 0.0], "a chain keeps the sense of its first curve");
    }

    #[test]
    fn inside_is_told_with_arcs_too() {
        let whole = Curve::circle([0.0; 2], [10.0, 0.0]);
        let circle =
            Chain { cuts: &[Cut { curve: whole, layer: 0, span: Span::default() }], is_closed: true };
        assert!(circle.holds([9.99, 0.0]) && circle.holds([7.0, 7.0]));
        assert!(!circle.holds([10.01, 0.0]) && !circle.holds([7.1, 7.1]));
        // A square with one side pushed in and one out by half circles.
        let mut cuts = lines(&[[[0.0, 0.0], [4.0, 0.0]], [[4.0, 4.0], [0.0, 4.0]]]);
        let arc = |from, along, to| Cut { curve: Curve::tangent(from, along, to), ..cuts[0] };
        let (right, left) =
            (arc([4.0, 0.0], [1.0, 0.0], [4.0, 4.0]), arc([0.0, 4.0], [1.0, 0.0], [0.0, 0.0]));
        cuts.insert(1, right);
        cuts.push(left);
        let slot = Chain { cuts: &cuts, is_closed: true };
        assert!(slot.holds([5.9, 2.0]) && !slot.holds([6.1, 2.0]));
        assert!(!slot.holds([1.9, 2.0]) && slot.holds([2.1, 2.0]) && slot.holds([0.5, 0.02]));
    }
}
