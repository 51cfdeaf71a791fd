//! The path as a list of segments; distances to it and to walls.

use super::super::CycleMove;
use std::f64::consts::TAU;

#[derive(Clone, Copy, PartialEq, Debug)]
pub struct Segment {
    pub from: [f64; 3],
    pub step: CycleMove,
}

#[derive(Clone, Debug)]
pub struct Path {
    at: [f64; 3],
    pub segments: Vec<Segment>,
}

impl Path {
    pub fn from(at: [f64; 3]) -> Path {
        Path { at, segments: Vec::new() }
    }

    pub fn add(&mut self, step: CycleMove) {
        let segment = Segment { from: self.at, step };
        segment.check();
        self.at = segment.to();
        self.segments.push(segment);
    }

    pub fn cutting(&self) -> impl Iterator<Item = &Segment> {
        self.segments.iter().filter(|s| s.cuts())
    }

    /// Levels at which the tool moves sideways, in order, each once.
    pub fn depths(&self) -> Vec<f64> {
        let mut seen: Vec<f64> = Vec::new();
        for s in self.cutting().filter(|s| s.is_level()) {
            if seen.iter().all(|z| (z - s.to()[2]).abs() > 1e-6) {
                seen.push(s.to()[2]);
            }
        }
        seen
    }

    pub fn at_level(&self, z: f64) -> Vec<Segment> {
        self.cutting().filter(|s| s.is_level() && (s.to()[2] - z).abs() < 1e-9).copied().collect()
    }
}

impl Segment {
    pub fn to(&self) -> [f64; 3] {
        match self.step {
            CycleMove::Rapid { to } | CycleMove::Feed { to } | CycleMove::Arc { to, .. } => to,
        }
    }

    pub fn cuts(&self) -> bool {
        !matches!(self.step, CycleMove::Rapid { .. })
    }

    pub fn is_arc(&self) -> bool {
        matches!(self.step, CycleMove::Arc { .. })
    }

    /// Moves in the plane only.
    pub fn is_level(&self) -> bool {
        (self.to()[2] - self.from[2]).abs() < 1e-9
    }

    /// Every move says where it ends, and an arc truly ends there.
    fn check(&self) {
        assert!(self.to().iter().all(|c| c.is_finite()), "{self:?}");
        assert!(self.from != self.to() || self.is_arc(), "does not move: {self:?}");
        if self.is_arc() {
            let end = self.point(1.0);
            let big = self.to().iter().chain(&self.from).fold(1.0f64, |m, c| m.max(c.abs()));
            for k in 0..3 {
                assert!((end[k] - self.to()[k]).abs() < 1e-9 * big.max(10.0), "{self:?} ends at {end:?}");
            }
        }
    }

    pub fn point(&self, t: f64) -> [f64; 3] {
        let (a, b) = (self.from, self.to());
        let z = a[2] + (b[2] - a[2]) * t;
        match self.step {
            CycleMove::Arc { center, sweep, .. } => {
                let (x, y) = (a[0] - center[0], a[1] - center[1]);
                let angle = y.atan2(x) + sweep * t;
                let r = x.hypot(y);
                [center[0] + r * angle.cos(), center[1] + r * angle.sin(), z]
            }
            _ => [a[0] + (b[0] - a[0]) * t, a[1] + (b[1] - a[1]) * t, z],
        }
    }

    /// Direction in the plane at the start (0) or the end (1).
    pub fn heading(&self, t: f64) -> [f64; 2] {
        let p = self.point(t);
        let [x, y] = match self.step {
            CycleMove::Arc { center, sweep, .. } => {
                [-(p[1] - center[1]) * sweep.signum(), (p[0] - center[0]) * sweep.signum()]
            }
            _ => [self.to()[0] - self.from[0], self.to()[1] - self.from[1]],
        };
        let l = x.hypot(y);
        [x / l, y / l]
    }

    /// Points along the move, both ends among them, close enough that nothing hides between them.
    pub fn points(&self) -> impl Iterator<Item = [f64; 3]> {
        let n = match self.step {
            CycleMove::Arc { sweep, .. } => (sweep.abs() / 0.01).ceil() as usize,
            _ => 40,
        };
        (0..=n).map(move |i| self.point(i as f64 / n as f64))
    }

    /// Distance of a point of the plane from the move.
    pub fn distance(&self, p: [f64; 2]) -> f64 {
        let (a, b) = (self.from, self.to());
        let ends = (p[0] - a[0]).hypot(p[1] - a[1]).min((p[0] - b[0]).hypot(p[1] - b[1]));
        match self.step {
            CycleMove::Arc { center, sweep, .. } => {
                let start = (a[1] - center[1]).atan2(a[0] - center[0]);
                let angle = (p[1] - center[1]).atan2(p[0] - center[0]);
                let turned = ((angle - start) * sweep.signum()).rem_euclid(TAU);
                if turned <= sweep.abs() {
                    let r = (a[0] - center[0]).hypot(a[1] - center[1]);
                    ((p[0] - center[0]).hypot(p[1] - center[1]) - r).abs()
                } else {
                    ends
                }
            }
            _ => {
                let (dx, dy) = (b[0] - a[0], b[1] - a[1]);
                let l = dx * dx + dy * dy;
                let t = if l > 0.0 { ((p[0] - a[0]) * dx + (p[1] - a[1]) * dy) / l } else { 0.0 };
                if (0.0..=1.0).contains(&t) {
                    (p[0] - a[0] - t * dx).hypot(p[1] - a[1] - t * dy)
                } else {
                    ends
                }
            }
        }
    }
}

/// Distance of a point from the nearest of some moves.
pub fn distance(segments: &[Segment], p: [f64; 2]) -> f64 {
    segments.iter().map(|s| s.distance(p)).fold(f64::INFINITY, f64::min)
}

/// A wall: a circle (half sizes of 0 and a corner) or a rectangle with round corners.
#[derive(Clone, Copy, Debug)]
pub struct Wall {
    pub center: [f64; 2],
    pub half: [f64; 2],
    pub corner: f64,
}

impl Wall {
    pub fn circle(center: [f64; 2], radius: f64) -> Wall {
        Wall { center, half: [radius, radius], corner: radius }
    }

    pub fn rectangle(center: [f64; 2], [i, j]: [f64; 2], corner: f64) -> Wall {
        Wall { center, half: [i / 2.0, j / 2.0], corner }
    }

    /// With corners that a tool of that radius can reach from inside.
    pub fn reachable(self, tool: f64) -> Wall {
        Wall { corner: self.corner.max(tool), ..self }
    }

    /// Signed distance: below 0 inside.
    pub fn distance(&self, p: [f64; 2]) -> f64 {
        let qx = (p[0] - self.center[0]).abs() - self.half[0] + self.corner;
        let qy = (p[1] - self.center[1]).abs() - self.half[1] + self.corner;
        qx.max(0.0).hypot(qy.max(0.0)) + qx.max(qy).min(0.0) - self.corner
    }

    /// `n` points on the wall of each of its eight parts.
    pub fn points(&self, n: usize) -> Vec<[f64; 2]> {
        let (a, b, c) = (self.half[0] - self.corner, self.half[1] - self.corner, self.corner);
        let mut points = Vec::new();
        for i in 0..=n {
            let t = i as f64 / n as f64;
            let (sin, cos) = (t * TAU / 4.0).sin_cos();
            for (su, sv) in [(1.0, 1.0), (-1.0, 1.0), (-1.0, -1.0), (1.0, -1.0)] {
                points.push([su * (a + c * cos), sv * (b + c * sin)]);
                points.push([su * a * t, sv * self.half[1]]);
                points.push([su * self.half[0], sv * b * t]);
            }
        }
        points.iter().map(|p| [p[0] + self.center[0], p[1] + self.center[1]]).collect()
    }
}
