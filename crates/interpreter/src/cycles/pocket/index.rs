//! A spatial index of segments: which are near a point or a box, without asking each.

use super::segment::{Bounds, Segment};
use rstar::{AABB, PointDistance, RTree, RTreeObject};

/// A segment with its place in its list.
#[derive(Clone, Copy, Debug)]
pub(crate) struct Piece {
    pub segment: Segment,
    pub number: usize,
    envelope: AABB<[f64; 2]>,
}

impl RTreeObject for Piece {
    type Envelope = AABB<[f64; 2]>;
    fn envelope(&self) -> Self::Envelope {
        self.envelope
    }
}

impl PointDistance for Piece {
    fn distance_2(&self, p: &[f64; 2]) -> f64 {
        let d = self.segment.distance(*p);
        // A search drops what lies beyond the nearest face of a box that it has seen. Where that face is
        // the end of a segment both distances are the same but for rounding, which must not decide.
        d * d * (1.0 - 1e-12)
    }
}

/// The index of segments, numbered in their order.
pub(crate) fn index<'a>(segments: impl IntoIterator<Item = &'a Segment>) -> RTree<Piece> {
    let piece = |(number, segment): (usize, &Segment)| Piece {
        segment: *segment,
        number,
        envelope: envelope(segment.bounds()),
    };
    RTree::bulk_load(segments.into_iter().enumerate().map(piece).collect())
}

pub(crate) fn envelope(bounds: Bounds) -> AABB<[f64; 2]> {
    AABB::from_corners(bounds.low, bounds.high)
}
