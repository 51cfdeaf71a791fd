//! The order in which concentric paths are cut.
//!
//! From the inside outwards, so that each path has a cut one beside it. Straight towards the nearest wall a
//! path is followed by the next outer one, at the distance of a pass and with nothing in between: that step
//! leads from path to path and makes a tree of them, whose innermost leaves are where the tool goes down.
//!
//! ```text
//!   leaf ─▶ ring ─▶ ring ─┐                 a chain: from a leaf outwards
//!   leaf ─▶ ring ─────────┴▶ ring ─▶ ring   until a ring waits for another branch;
//!                                           the last branch goes on
//! ```
//!
//! A leaf that comes by a path cut before, as the innermost path round an island does, is entered from
//! there, level. Only others are entered from above into full material.

use super::index::{Piece, envelope, index};
use super::meet::closest;
use super::ring::{Place, Ring};
use super::rings::Layer;
use super::segment::Segment;
use super::walls::Walls;
use ferrocut_geometry::vector::{along, left, sub, unit};
use rstar::RTree;
use std::f64::consts::TAU;

/// A path cut without leaving its level.
#[derive(Clone, PartialEq, Debug)]
pub(crate) struct Chain {
    /// How the tool gets to where the path begins.
    pub entry: Entry,
    /// The path of the tool centre.
    pub path: Vec<Segment>,
}

/// How a path begins.
#[derive(Clone, PartialEq, Debug)]
pub(crate) enum Entry {
    /// In full material: down along a closed way, which ends where the path begins. It is a circle where
    /// there is room for one, else the innermost ring itself.
    Solid {
        /// The closed way.
        down: Vec<Segment>,
    },
    /// Where a path before has cut.
    Cut,
}

/// Exactness of where a step to the next path lands, mm: both lie within 2 µm of their distances.
const LANDS: f64 = 5e-3;

/// A ring by layer and number.
type Node = (usize, usize);

struct Tree<'a> {
    walls: &'a Walls,
    layers: &'a [Layer],
    /// Per layer an index of all segments and the ring of each.
    near: Vec<(RTree<Piece>, Vec<usize>)>,
    /// Per layer and ring the next outer ring.
    parents: Vec<Vec<Option<Node>>>,
    /// Rings of the next inner paths not yet cut.
    waiting: Vec<Vec<u32>>,
    cut: Vec<Vec<bool>>,
}

/// Rings in the order in which they are cut. `clockwise` is the direction about an area; `radius` that of
/// the tool, `reach` how far a level way in may lead through full material.
pub(crate) fn chains(
    walls: &Walls,
    layers: &mut [Layer],
    clockwise: bool,
    radius: f64,
    reach: f64,
) -> Vec<Chain> {
    if clockwise {
        for ring in layers.iter_mut().flat_map(|layer| &mut layer.rings) {
            *ring = ring.reversed();
        }
    }
    let mut tree = Tree::new(walls, layers);
    let mut chains = Vec::new();
    for leaf in tree.leaves() {
        let mut path = Vec::new();
        let entry = tree.enter(leaf, &mut path, clockwise, radius, reach);
        tree.climb(leaf, &mut path);
        chains.push(Chain { entry, path });
    }
    chains
}

impl<'a> Tree<'a> {
    fn new(walls: &'a Walls, layers: &'a [Layer]) -> Tree<'a> {
        let near = layers.iter().map(|layer| {
            let rings = layer.rings.iter().enumerate();
            let owners = rings.flat_map(|(n, r)| std::iter::repeat_n(n, r.segments.len())).collect();
            (index(layer.rings.iter().flat_map(|r| &r.segments)), owners)
        });
        let zero = layers.iter().map(|layer| vec![0; layer.rings.len()]);
        let not = layers.iter().map(|layer| vec![false; layer.rings.len()]);
        let none = layers.iter().map(|layer| vec![None; layer.rings.len()]);
        let mut tree = Tree {
            walls,
            layers,
            near: near.collect(),
            parents: none.collect(),
            waiting: zero.collect(),
            cut: not.collect(),
        };
        for (l, layer) in layers.iter().enumerate() {
            for (n, ring) in layer.rings.iter().enumerate() {
                let parent = tree.outward((l, n), ring.point(ring.middle())).map(|(node, _)| node);
                if let Some(slot) = tree.parents.get_mut(l).and_then(|p| p.get_mut(n)) {
                    *slot = parent;
                }
                if let Some(waiting) = parent.and_then(|node| tree.waiting_of(node)) {
                    *waiting += 1;
                }
            }
        }
        tree
    }

    fn ring(&self, (layer, number): Node) -> Option<&'a Ring> {
        self.layers.get(layer).and_then(|l| l.rings.get(number))
    }

    fn waiting_of(&mut self, (layer, number): Node) -> Option<&mut u32> {
        self.waiting.get_mut(layer).and_then(|w| w.get_mut(number))
    }

    fn is_cut(&self, (layer, number): Node) -> bool {
        self.cut.get(layer).and_then(|c| c.get(number)).copied().unwrap_or(false)
    }

    /// The next outer ring from a point of a ring, and where the step lands on it.
    fn outward(&self, (layer, _): Node, p: [f64; 2]) -> Option<(Node, Place)> {
        let toward = unit(sub(self.walls.foot(p), p))?;
        let own = self.layers.get(layer)?.d;
        for l in (0..layer).rev() {
            let (next, (near, owners)) = (self.layers.get(l)?, self.near.get(l)?);
            let landing = along(p, toward, own - next.d);
            let Some(piece) = near.nearest_neighbor(landing) else { continue };
            if piece.segment.distance(landing) > LANDS {
                // A ring between two passes that is not needed here.
                continue;
            }
            let number = *owners.get(piece.number)?;
            let (place, _) = next.rings.get(number)?.nearest(landing);
            return Some(((l, number), place));
        }
        None
    }

    /// Rings that wait for none, the branches with the deepest ones first.
    fn leaves(&self) -> Vec<Node> {
        let mut inner: Vec<Vec<Vec<Node>>> =
            self.layers.iter().map(|layer| vec![Vec::new(); layer.rings.len()]).collect();
        let mut height: Vec<Vec<u32>> = self.layers.iter().map(|layer| vec![0; layer.rings.len()]).collect();
        let mut stack = Vec::new();
        for (l, parents) in self.parents.iter().enumerate().rev() {
            for (n, parent) in parents.iter().enumerate() {
                let own = height.get(l).and_then(|h| h.get(n)).copied().unwrap_or(0);
                let Some((pl, pn)) = *parent else {
                    stack.push((own, (l, n)));
                    continue;
                };
                if let Some(of_parent) = height.get_mut(pl).and_then(|h| h.get_mut(pn)) {
                    *of_parent = (*of_parent).max(own + 1);
                }
                if let Some(list) = inner.get_mut(pl).and_then(|i| i.get_mut(pn)) {
                    list.push((l, n));
                }
            }
        }
        stack.sort();
        let mut leaves = Vec::new();
        while let Some((_, (l, n))) = stack.pop() {
            let children = inner.get(l).and_then(|i| i.get(n)).map(Vec::as_slice).unwrap_or_default();
            if children.is_empty() {
                leaves.push((l, n));
            }
            let from = stack.len();
            for child in children {
                let own = height.get(child.0).and_then(|h| h.get(child.1)).copied().unwrap_or(0);
                stack.push((own, *child));
            }
            if let Some(new) = stack.get_mut(from..) {
                new.sort();
            }
        }
        leaves
    }

    /// The way into a leaf and once round it.
    fn enter(&self, leaf: Node, path: &mut Vec<Segment>, clockwise: bool, radius: f64, reach: f64) -> Entry {
        let (Some(ring), Some(layer), Some(outermost)) =
            (self.ring(leaf), self.layers.get(leaf.0), self.layers.first())
        else {
            return Entry::Cut;
        };
        if let Some((from, to)) = self.way_in(leaf, ring, outermost.d, reach) {
            path.push(Segment::Line { from, to });
            path.extend(ring.once_round(ring.nearest(to).0));
            return Entry::Cut;
        }
        let place = ring.middle();
        let once = ring.once_round(place);
        path.extend_from_slice(&once);
        // Within the distance to the outermost path everything is free, so a circle of half of it is.
        let room = ((layer.d - outermost.d) / 2.0).min(radius);
        let start = ring.point(place);
        let heading = once.first().map_or([1.0, 0.0], |s| s.direction(0.0));
        let side = if clockwise { -1.0 } else { 1.0 };
        if room >= radius / 2.0 || (room > 1e-3 && TAU * room > ring.length()) {
            let center = along(start, left(heading), side * room);
            return Entry::Solid { down: vec![Segment::circle(start, center, side)] };
        }
        Entry::Solid { down: once }
    }

    /// The shortest level way from a path already cut to a leaf.
    fn way_in(&self, leaf: Node, ring: &Ring, nearest: f64, reach: f64) -> Option<([f64; 2], [f64; 2])> {
        let mut best: Option<(f64, [f64; 2], [f64; 2])> = None;
        // Between passes there may be one more layer.
        for l in leaf.0..(leaf.0 + 3).min(self.layers.len()) {
            let (near, owners) = self.near.get(l)?;
            for own in &ring.segments {
                for piece in near.locate_in_envelope_intersecting(envelope(own.bounds().grown(reach))) {
                    let other = (l, *owners.get(piece.number)?);
                    if other == leaf || !self.is_cut(other) {
                        continue;
                    }
                    let (d, from, to) = closest(&piece.segment, own);
                    if d <= reach && best.is_none_or(|b| d < b.0) && self.walls.is_clear(from, to, nearest) {
                        best = Some((d, from, to));
                    }
                }
            }
        }
        best.map(|(_, from, to)| (from, to))
    }

    /// From a ring that has been gone round, outwards as long as nothing else is waited for.
    fn climb(&mut self, leaf: Node, path: &mut Vec<Segment>) {
        let mut node = leaf;
        loop {
            if let Some(cut) = self.cut.get_mut(node.0).and_then(|c| c.get_mut(node.1)) {
                *cut = true;
            }
            let parent = self.parents.get(node.0).and_then(|p| p.get(node.1)).copied().flatten();
            let Some(next) = parent else { return };
            if let Some(waiting) = self.waiting_of(next) {
                *waiting = waiting.saturating_sub(1);
                if *waiting > 0 {
                    return;
                }
            }
            let (Some(ring), Some(outer)) = (self.ring(node), self.ring(next)) else { return };
            let mut at = path.last().map_or([0.0; 2], Segment::to);
            let landing = match self.outward(node, at) {
                Some((found, place)) if found == next => place,
                _ => {
                    // Elsewhere it leads to another ring; in its middle the ring is known to lead to this.
                    path.extend(ring.between(ring.nearest(at).0, ring.middle()));
                    at = path.last().map_or(at, Segment::to);
                    match self.outward(node, at) {
                        Some((found, place)) if found == next => place,
                        _ => return,
                    }
                }
            };
            path.push(Segment::Line { from: at, to: outer.point(landing) });
            path.extend(outer.once_round(landing));
            node = next;
        }
    }
}
