//! Concentric paths over an area, and which of them are needed.
//!
//! Paths lie at the distances dₖ = d₀ + k·s from the walls, d₀ the nearest that the tool may come and s the
//! equal pass. A point at the distance D between two paths is D − dₖ from path k, straight towards its
//! nearest wall, so that with s ≤ r (tool radius) everything is cut. Passes up to 2r are allowed, and then
//! paths alone leave spikes in corners and strips along the middle: points at D > dₖ + r that are farther
//! than r from path k + 1. A path at dₖ + r cuts all of them, being nearer than s − r ≤ r to each. It is made
//! of those rings only that come by such a place; in a rectangle at the usual 1.5 r there is none.

use super::index::index;
use super::passes::equal;
use super::problem::{MAX_MOVES, MAX_PASSES, PocketFault, Problem};
use super::ring::Ring;
use super::walls::Walls;

/// Rings at one distance from the walls.
#[derive(Debug)]
pub(crate) struct Layer {
    /// Distance, mm.
    pub d: f64,
    /// All rings at that distance, or of a layer between two passes those that are needed.
    pub rings: Vec<Ring>,
}

/// What paths that are exact to 2 µm must overlap to be sure that nothing stands between them, mm.
const COVERED: f64 = 2e-3;

/// Least overlap of two passes, mm. Passes of exactly the diameter would leave a fin of no thickness.
const OVERLAP: f64 = 0.01;

/// The layers from the nearest to the walls inwards; `width` is the widest pass.
///
/// `tool` and `step` are the parameters to blame.
pub(crate) fn layers(
    walls: &Walls,
    nearest: f64,
    radius: f64,
    width: f64,
    [tool, step]: [&'static str; 2],
) -> Result<Vec<Layer>, PocketFault> {
    let width = width.min(2.0 * radius - OVERLAP);
    let paths = |d: f64| walls.paths(d).map_err(|problem| problem.of("profile"));
    let first = paths(nearest)?;
    Problem::ToolTooLarge.when(first.is_empty(), tool)?;
    Problem::TooManyMoves.when(walls.bounds.width() / width > MAX_PASSES, step)?;
    let far = farthest(walls, nearest, width / 50.0);
    let (count, pass) = equal(far - nearest, width);
    let mut layers = vec![Layer { d: nearest, rings: first }];
    let mut total = 0.0;
    for k in 1..=count {
        let before = nearest + f64::from(k - 1) * pass;
        let d = nearest + f64::from(k) * pass;
        let rings = if k < count { paths(d)? } else { Vec::new() };
        if pass > radius {
            let between = needed(paths(before + radius)?, &rings, radius);
            if !between.is_empty() {
                layers.push(Layer { d: before + radius, rings: between });
            }
        }
        if !rings.is_empty() {
            layers.push(Layer { d, rings });
        }
        let last = layers.iter().rev().take(2).flat_map(|l| &l.rings).map(|r| r.segments.len() as f64);
        total += last.sum::<f64>();
        Problem::TooManyMoves.when(total > MAX_MOVES, step)?;
    }
    Ok(layers)
}

/// The greatest distance from the walls that any point has, from above, to `slack`.
fn farthest(walls: &Walls, from: f64, slack: f64) -> f64 {
    let (mut room, mut none) = (from, walls.bounds.width() / 2.0 + 1e-3);
    // Each halving gains a bit; no slack needs more.
    for _ in 0..60 {
        if none - room <= slack {
            break;
        }
        let middle = (room + none) / 2.0;
        if walls.has_room(middle) { room = middle } else { none = middle }
    }
    none.max(from)
}

/// Those rings that come by a place farther than the tool radius from the next path.
fn needed(rings: Vec<Ring>, next: &[Ring], radius: f64) -> Vec<Ring> {
    let next = index(next.iter().flat_map(|r| &r.segments));
    let covered = radius - COVERED;
    let passes_by = |ring: &Ring| {
        ring.segments.iter().any(|segment| {
            let long = segment.length();
            let mut gone = 0.0;
            // From a point that is c inside what the next path cuts, c further on all is.
            while gone < long {
                let p = segment.point(gone / long);
                let off = next.nearest_neighbor(p).map_or(f64::INFINITY, |n| n.segment.distance(p));
                if off > covered {
                    return true;
                }
                gone += (covered - off).max(radius / 100.0);
            }
            false
        })
    };
    rings.into_iter().filter(passes_by).collect()
}
