//! Depth profiles: how a wall slopes (Fagor 4.16).
//!
//! A depth profile is drawn with one axis of the plane and the tool axis, from the point where its contour
//! begins: for the outer one at the surface, for an island at the floor. What counts of it is how far the
//! wall stands inside its contour at each height, all round: the inset
//!
//! ```text
//! i(h) = |x(h) − x(start)|,       h: height above the surface, ≤ 0
//! ```
//!
//! The outer wall's inset grows downwards, an island's upwards, so that both lean back from the tool and
//! nothing hangs over. Below the end of an outer profile the wall goes straight down; an island whose
//! profile ends below the surface ends there too, and one without a profile reaches the surface.

use super::pen::Planes;
use super::problem::Problem;
use super::segment::Segment;
use super::tool::Tool;
use ferrocut_geometry::vector::distance;

/// The slope of a wall as drawn: an open chain.
#[derive(Clone, PartialEq, Debug)]
pub struct DepthProfile {
    /// Elements in plane axis and tool axis, absolute, mm.
    pub segments: Vec<Segment>,
    /// Which axis of the plane it is drawn with: 0 the abscissa (XZ), 1 the ordinate (YZ).
    pub axis: usize,
}

/// A wall by heights: inset over height, straight between corners.
#[derive(Clone, PartialEq, Debug)]
pub(crate) struct Lean {
    /// Height and inset, from the lower end to the upper one; neighbours may share a height.
    corners: Vec<[f64; 2]>,
    /// Height at which it ends: 0 is the surface.
    pub top: f64,
}

/// How far a depth profile may begin from its contour's start, mm; coordinates are typed twice.
const SAME: f64 = 0.001;

/// Distance of a chord from its arc, mm.
const CHORD: f64 = 5e-4;

impl Lean {
    /// A vertical wall.
    pub fn upright() -> Lean {
        Lean { corners: vec![[0.0, 0.0]], top: 0.0 }
    }

    /// The wall of a depth profile. `start` is where its contour begins, `depth` the pocket's.
    pub fn new(
        profile: &DepthProfile,
        start: [f64; 2],
        planes: Planes,
        depth: f64,
        is_island: bool,
    ) -> Result<Lean, Problem> {
        let from = start.get(profile.axis).copied().ok_or(Problem::DepthProfileStart)?;
        let mut corners: Vec<[f64; 2]> = Vec::new();
        let mut at = None;
        for segment in &profile.segments {
            if !segment.is_finite() {
                return Err(Problem::OutOfRange);
            }
            if at.is_some_and(|at| distance(at, segment.from()) > SAME) {
                return Err(Problem::ProfileOpen);
            }
            at = Some(segment.to());
            let pieces = match *segment {
                Segment::Line { .. } => 1,
                Segment::Arc { from, center, sweep, .. } => {
                    let chord = (8.0 * CHORD / distance(from, center).max(CHORD)).sqrt();
                    (sweep.abs() / chord).ceil().clamp(1.0, 1e4) as u32
                }
            };
            let height = |p: [f64; 2]| [(p[1] - planes.surface) * planes.up, (p[0] - from).abs()];
            let first = u32::from(!corners.is_empty());
            corners.extend((first..=pieces).map(|k| height(segment.point(f64::from(k) / f64::from(pieces)))));
        }
        let begins = if is_island { -depth } else { 0.0 };
        match corners.first() {
            None => return Ok(Lean::upright()),
            Some([height, inset]) if (height - begins).abs() > SAME || *inset > SAME => {
                return Err(Problem::DepthProfileStart);
            }
            _ => {}
        }
        if !is_island {
            corners.reverse();
        }
        // On the way up the height never falls; the outer wall's inset shrinks, an island's grows.
        let sense = if is_island { 1.0 } else { -1.0 };
        let goes_back = |pair: &[[f64; 2]]| match pair {
            [a, b] => b[0] < a[0] - 1e-9 || (b[1] - a[1]) * sense < -1e-9,
            _ => false,
        };
        if corners.windows(2).any(goes_back) {
            return Err(Problem::DepthProfileTurnsBack);
        }
        // x on the other side of the start would make |x| turn back; a change of side is that too.
        let sides = |s: &Segment| [s.from()[0] - from, s.to()[0] - from];
        let (low, high) =
            profile.segments.iter().flat_map(sides).fold((0.0f64, 0.0f64), |(l, h), x| (l.min(x), h.max(x)));
        if low < -SAME && high > SAME {
            return Err(Problem::DepthProfileTurnsBack);
        }
        let top = if is_island { corners.last().map_or(0.0, |c| c[0].min(0.0)) } else { 0.0 };
        // Rounding of the axis' own coordinates must not make a wall end a hair below the surface.
        let top = if top > -SAME { 0.0 } else { top };
        Ok(Lean { corners, top })
    }

    /// The inset just above a height.
    pub fn inset(&self, height: f64) -> f64 {
        let (Some(first), Some(last)) = (self.corners.first(), self.corners.last()) else { return 0.0 };
        if height < first[0] {
            return first[1];
        }
        for pair in self.corners.windows(2) {
            if let [a, b] = pair
                && height < b[0]
            {
                let t = (height - a[0]) / (b[0] - a[0]);
                return a[1] + (b[1] - a[1]) * t.clamp(0.0, 1.0);
            }
        }
        last[1]
    }

    /// How far the axis of a tool keeps off the contour with its tip at a height: towards the pocket
    /// positive, below 0 over the slope of an island.
    ///
    /// A tool with a rounded tip of radius t has at the height y above its tip the radius
    /// ρ(y) = R − t + √(t² − (t − y)²), R above t. It clears the wall if at every y
    ///
    /// ```text
    /// outer:  d ≥ i(h + y) + ρ(y)            island:  d ≥ ρ(y) − i(h + y)
    /// ```
    ///
    /// On a straight piece of the wall, of slope m = |di/dh|, the greatest is where ρ′ = m, at
    /// t − y = t·m/√(1 + m²), or at an end of the piece.
    pub fn clearance(&self, tip: f64, tool: &Tool, is_island: bool) -> f64 {
        let sign = if is_island { -1.0 } else { 1.0 };
        let round = tool.tip_radius;
        let radius_at = |y: f64| {
            let u = (round - y).clamp(0.0, round);
            tool.radius - round + ((round - u) * (round + u)).max(0.0).sqrt()
        };
        let mut most = tool.radius + sign * self.inset(tip + round.max(1e-9));
        let mut take = |y: f64, inset: f64| {
            if y >= 0.0 {
                most = most.max(radius_at(y) + sign * inset);
            }
        };
        take(0.0, self.inset(tip));
        for pair in self.corners.windows(2) {
            let [a, b] = pair else { continue };
            let high = b[0] - a[0];
            if high <= 0.0 {
                continue;
            }
            // Just above the lower end and just below the upper one: a tip on a ledge is above it.
            take(a[0] - tip, a[1]);
            if b[0] - tip > 1e-9 {
                take(b[0] - tip, b[1]);
            }
            let m = (b[1] - a[1]).abs() / high;
            let y = round - round * m / (1.0 + m * m).sqrt();
            let t = (tip + y - a[0]) / high;
            if (0.0..=1.0).contains(&t) {
                take(y, a[1] + (b[1] - a[1]) * t);
            }
        }
        most
    }

    /// Tip heights and clearances along the wall from its top to the floor, straight between them.
    pub fn way_down(&self, floor: f64, tool: &Tool, is_island: bool) -> Vec<[f64; 2]> {
        /// Halvings of a piece between two bends at most.
        const HALVINGS: u32 = 10;
        let at = |height: f64| [height, self.clearance(height, tool, is_island)];
        let mut way: Vec<[f64; 2]> = Vec::new();
        for height in self.bends(floor, tool).into_iter().rev() {
            // From just above, and on a ledge on to just below.
            for next in [at(height), [height, at(height - 1e-8)[1]]] {
                let Some(last) = way.last().copied() else {
                    way.push(next);
                    continue;
                };
                let mut pieces = vec![(last, next, 0)];
                while let Some((a, b, halved)) = pieces.pop() {
                    let middle = at((a[0] + b[0]) / 2.0);
                    let off = (middle[1] - (a[1] + b[1]) / 2.0).abs();
                    if halved < HALVINGS && a[0] - b[0] > 1e-6 && off > CHORD {
                        pieces.push((middle, b, halved + 1));
                        pieces.push((a, middle, halved + 1));
                    } else if distance(a, b) > 1e-6 {
                        way.push(b);
                    }
                }
                if height <= floor {
                    break;
                }
            }
        }
        way
    }

    /// Heights between floor and surface at which the wall or the tool's way along it bends.
    pub fn bends(&self, floor: f64, tool: &Tool) -> Vec<f64> {
        let mut heights = vec![floor, self.top];
        for corner in &self.corners {
            heights.push(corner[0]);
            heights.push(corner[0] - tool.tip_radius);
        }
        heights.retain(|h| (floor..=self.top).contains(h));
        heights.sort_by(f64::total_cmp);
        heights.dedup_by(|a, b| (*a - *b).abs() < 1e-9);
        heights
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    const PLANES: Planes = Planes { surface: 0.0, safety: 5.0, up: 1.0 };

    fn profile(points: &[[f64; 2]]) -> DepthProfile {
        let segments = points.windows(2).map(|p| Segment::Line { from: p[0], to: p[1] }).collect();
        DepthProfile { segments, axis: 0 }
    }

    /// FAGOR-A of 4.16.3: from (20, 0) to (30, −20).
    fn slope() -> Lean {
        Lean::new(&profile(&[[20.0, 0.0], [30.0, -20.0]]), [20.0, 0.0], PLANES, 20.0, false).unwrap()
    }

    #[test]
    fn insets_of_the_examples() {
        assert_eq!([0.0, -5.0, -20.0].map(|h| slope().inset(h)), [0.0, 2.5, 10.0]);
        let island = profile(&[[62.5, -20.0], [77.5, 0.0]]);
        let island = Lean::new(&island, [62.5, 0.0], PLANES, 20.0, true).unwrap();
        assert_eq!([0.0, -20.0].map(|h| island.inset(h)), [15.0, 0.0]);
        assert!((island.inset(-20.0 / 3.0) - 10.0).abs() < 1e-12);
    }

    #[test]
    fn clearances_by_hand() {
        let flat = Tool { radius: 5.0, ..Tool::default() };
        assert!((slope().clearance(-10.0, &flat, false) - 10.0).abs() < 1e-6);
        // A ball of radius 5 on a slope of 1 in 2: the normal distance is 5, so that at the height of its
        // middle, 5 above the tip, its axis is 5·√(1 + ¼) beside the wall.
        let ball = Tool { tip_radius: 5.0, ..flat };
        let want = (10.0 - 5.0) / 2.0 + 5.0 * 1.25f64.sqrt();
        assert!((slope().clearance(-10.0, &ball, false) - want).abs() < 1e-9);
        assert!((Lean::upright().clearance(-3.0, &ball, true) - 5.0).abs() < 1e-9);
    }

    #[test]
    fn wrong_profiles() {
        let new = |points: &[[f64; 2]], is_island| {
            Lean::new(&profile(points), [20.0, 0.0], PLANES, 20.0, is_island).map(|_| ())
        };
        assert_eq!(new(&[[21.0, 0.0], [30.0, -20.0]], false), Err(Problem::DepthProfileStart));
        assert_eq!(new(&[[20.0, 0.0], [30.0, -20.0]], true), Err(Problem::DepthProfileStart));
        let back = [[20.0, 0.0], [30.0, -10.0], [25.0, -20.0]];
        assert_eq!(new(&back, false), Err(Problem::DepthProfileTurnsBack));
        let up = [[20.0, 0.0], [25.0, -10.0], [26.0, -5.0]];
        assert_eq!(new(&up, false), Err(Problem::DepthProfileTurnsBack));
        assert_eq!(new(&[[20.0, 0.0], [25.0, -5.0], [30.0, -5.0], [31.0, -20.0]], false), Ok(()));
    }
}
