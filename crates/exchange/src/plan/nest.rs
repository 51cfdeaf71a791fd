//! Which chain lies inside of which: a contour is cut after what is inside of it, so that nothing is
//! worked on that has come loose.

use super::chains::{Chain, Chains};
use ferrocut_geometry::vector::Point;
use rstar::primitives::{GeomWithData, Rectangle};
use rstar::{AABB, RTree};

/// Pairs of a chain and a contour around it that are looked at in all; more make the order by size.
const MOST_PAIRS: usize = 20_000_000;

/// Pairs that are kept.
const MOST_KEPT: usize = 4_000_000;

/// The closed chains around each chain. Contours that cross are not within each other, so that this is
/// no tree.
#[derive(Clone, PartialEq, Eq, Debug, Default)]
pub struct Nest {
    around: Vec<u32>,
    /// Where those around each chain end.
    ends: Vec<u32>,
}

impl Nest {
    /// Finds which chains lie within which; `None` if there are too many to tell.
    pub fn of(chains: &Chains) -> Option<Nest> {
        let extents: Vec<_> = chains.iter().map(|chain| Chain::extent(&chain)).collect();
        let boxes = chains.iter().zip(&extents).zip(0u32..).filter(|((chain, _), _)| chain.is_closed);
        let boxes =
            boxes.map(|((_, [low, high]), i)| GeomWithData::new(Rectangle::from_corners(*low, *high), i));
        let tree = RTree::bulk_load(boxes.collect());
        let area = |[low, high]: &[Point; 2]| (high[0] - low[0]) * (high[1] - low[1]);
        let mut looked_at = 0;
        let mut nest = Nest::default();
        for ((chain, own), number) in chains.iter().zip(&extents).zip(0u32..) {
            // The middle of a curve: ends are where contours may touch.
            let inside = chain.cuts.first().map_or([0.0; 2], |first| first.curve.at(0.5));
            for found in tree.locate_in_envelope_intersecting(AABB::from_point(inside)) {
                looked_at += 1;
                let (Some(other), Some(contour)) =
                    (extents.get(found.data as usize), chains.get(found.data as usize))
                else {
                    continue;
                };
                if found.data == number || !holds_box(other, own) || area(other) <= area(own) {
                    continue;
                }
                looked_at += contour.cuts.len();
                if contour.holds(inside) {
                    nest.around.push(found.data);
                }
            }
            if looked_at > MOST_PAIRS || nest.around.len() > MOST_KEPT {
                return None;
            }
            nest.ends.push(nest.around.len() as u32);
        }
        Some(nest)
    }

    /// The contours around a chain.
    pub fn around(&self, number: u32) -> &[u32] {
        let start = number.checked_sub(1).and_then(|before| self.ends.get(before as usize));
        let end = self.ends.get(number as usize).copied().unwrap_or(0);
        self.around.get(start.copied().unwrap_or(0) as usize..end as usize).unwrap_or(&[])
    }

    /// Every pair of a chain and a contour around it.
    pub fn pairs(&self) -> impl Iterator<Item = (u32, u32)> {
        (0..self.ends.len() as u32).flat_map(|own| self.around(own).iter().map(move |around| (own, *around)))
    }
}

fn holds_box([low, high]: &[Point; 2], [inner_low, inner_high]: &[Point; 2]) -> bool {
    (0..2).all(|i| low[i] <= inner_low[i] && high[i] >= inner_high[i])
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::curve::Curve;
    use crate::plan::Cut;
    use crate::plan::chains::join;
    use ferrocut_program::Span;

    fn circle(x: f64, radius: f64) -> Cut {
        let curve = Curve::circle([x, 0.0], [x + radius, 0.0]);
        Cut { curve, layer: 0, span: Span::default() }
    }

    #[test]
    fn contours_around_are_found() {
        let circles =
            [circle(0.0, 10.0), circle(0.0, 1.0), circle(5.0, 2.0), circle(0.0, 3.0), circle(9.0, 5.0)];
        // The last crosses the first; its middle, (4, 0), is inside and its box is not.
        let nest = Nest::of(&join(&circles)).unwrap();
        let mut pairs: Vec<_> = nest.pairs().collect();
        pairs.sort_unstable();
        assert_eq!(pairs, [(1, 0), (1, 3), (2, 0), (3, 0)]);
        assert_eq!((nest.around(0), nest.around(2)), (&[][..], &[0][..]));
    }
}
