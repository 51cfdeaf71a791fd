//! Paths of straight pieces, for the one wall in thousands whose arcs defeat the exact way.
//!
//! Chords of walls and of joints are a micrometre from their arcs, so that the path is within two of where it
//! should be.

use super::profile::Profile;
use super::ring::Ring;
use super::segment::Segment;
use ferrocut_geometry::vector::distance;
use i_overlay::mesh::float::outline::offset::OutlineOffset;
use i_overlay::mesh::float::style::{LineJoin, OutlineStyle};
use i_overlay::mesh::math::MathMode;

/// Distance of a chord from its arc, mm.
const CHORD: f64 = 1e-3;

/// The paths at the distance `d` on the left of closed chains.
pub(crate) fn paths(contours: &[Profile], d: f64) -> Vec<Ring> {
    let shape: Vec<Vec<[f64; 2]>> = contours.iter().map(|c| flattened(&c.segments)).collect();
    let style = OutlineStyle::new(-d).line_join(LineJoin::Round(angle(d))).math(MathMode::Float);
    let shapes = shape.outline_as::<i64>(&style);
    let ring = |points: &Vec<[f64; 2]>| {
        let next = points.iter().cycle().skip(1);
        Ring::new(points.iter().zip(next).map(|(a, b)| Segment::Line { from: *a, to: *b }).collect())
    };
    shapes.iter().flatten().filter_map(ring).collect()
}

/// Angle of a chord: the arc rises r(1 − cos(α/2)) ≈ rα²/8 above it.
fn angle(radius: f64) -> f64 {
    (8.0 * CHORD / radius.max(CHORD)).sqrt()
}

fn flattened(chain: &[Segment]) -> Vec<[f64; 2]> {
    let mut points = Vec::with_capacity(chain.len());
    for segment in chain {
        let pieces = match *segment {
            Segment::Line { .. } => 1.0,
            Segment::Arc { from, center, sweep, .. } => {
                (sweep.abs() / angle(distance(from, center))).ceil().clamp(1.0, 1e5)
            }
        };
        points.extend((0..pieces as u32).map(|k| segment.point(f64::from(k) / pieces)));
    }
    points
}
