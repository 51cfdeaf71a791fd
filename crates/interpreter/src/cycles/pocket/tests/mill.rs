//! A block of material in cells, and a flat tool that cuts it as the moves say.

use super::super::Segment;
use crate::cycles::milling::CycleMove;
use ferrocut_geometry::vector::{cross, distance, dot, sub};

/// Width of a cell, mm.
pub const CELL: f64 = 0.05;

/// Heights of the material at the middles of cells.
pub struct Block {
    pub low: [f64; 2],
    pub size: [usize; 2],
    pub height: Vec<f32>,
}

/// A piece short enough for plain tests: a line, or an arc of a quarter at most.
struct Sweep {
    segment: Segment,
    arc: Option<Quarter>,
}

/// An arc as its centre sees it.
struct Quarter {
    center: [f64; 2],
    /// Directions to both ends.
    ends: [[f64; 2]; 2],
    radius: f64,
    sense: f64,
}

impl Sweep {
    fn new(segment: Segment) -> Sweep {
        let arc = match segment {
            Segment::Line { .. } => None,
            Segment::Arc { from, to, center, sweep } => {
                let ends = [sub(from, center), sub(to, center)];
                Some(Quarter { center, ends, radius: distance(from, center), sense: sweep.signum() })
            }
        };
        Sweep { segment, arc }
    }

    fn covers(&self, p: [f64; 2], r: f64) -> bool {
        let near = |q: [f64; 2]| dot(sub(p, q), sub(p, q)) < r * r;
        match (&self.arc, &self.segment) {
            (Some(Quarter { center, ends: [a, b], radius, sense }), segment) => {
                let v = sub(p, *center);
                let square = dot(v, v);
                let (inner, outer) = ((radius - r).max(0.0), radius + r);
                // Not in the middle of a circle that is wider than the tool.
                let ring = square < outer * outer && (square > inner * inner || *radius < r);
                (ring && cross(*a, v) * sense >= 0.0 && cross(v, *b) * sense >= 0.0)
                    || near(segment.from())
                    || near(segment.to())
            }
            (None, Segment::Line { from, to }) => {
                let (d, v) = (sub(*to, *from), sub(p, *from));
                let (along, square) = (dot(v, d), dot(d, d));
                if along <= 0.0 {
                    return near(*from);
                }
                if along >= square {
                    return near(*to);
                }
                let off = cross(d, v);
                off * off < r * r * square
            }
            (None, Segment::Arc { .. }) => false,
        }
    }
}

impl Block {
    /// A block around a box, with its surface at 0.
    pub fn new(low: [f64; 2], high: [f64; 2]) -> Block {
        let low = low.map(|c| c - 3.0 * CELL);
        let size = [0, 1].map(|k| ((high[k] - low[k]) / CELL).ceil() as usize + 4);
        Block { low, size, height: vec![0.0; size[0] * size[1]] }
    }

    pub fn middle(&self, i: usize, j: usize) -> [f64; 2] {
        [self.low[0] + i as f64 * CELL, self.low[1] + j as f64 * CELL]
    }

    /// Calls for every cell that a disc of radius `r` moved along a segment covers.
    pub fn swept(&self, segment: &Segment, r: f64, mut cell: impl FnMut(usize, [f64; 2])) {
        let pieces = match segment {
            Segment::Line { .. } => (segment.length() / (2.0 * r).max(2.0)).ceil().max(1.0),
            Segment::Arc { sweep, .. } => (sweep.abs() / 1.5).ceil(),
        };
        for k in 0..pieces as usize {
            let piece = segment.part(k as f64 / pieces, (k + 1) as f64 / pieces);
            let bounds = piece.bounds().grown(r);
            let sweep = Sweep::new(piece);
            let index = |c: f64, k: usize| {
                (((c - self.low[k]) / CELL).floor().max(0.0) as usize).min(self.size[k] - 1)
            };
            for j in index(bounds.low[1], 1)..=index(bounds.high[1], 1) {
                for i in index(bounds.low[0], 0)..=index(bounds.high[0], 0) {
                    let p = self.middle(i, j);
                    if sweep.covers(p, r) {
                        cell(j * self.size[0] + i, p);
                    }
                }
            }
        }
    }

    /// Cuts along a segment from one height to another.
    fn cut(&mut self, segment: &Segment, r: f64, from: f64, to: f64) {
        // A slope is cut in steps of 0.1 mm, each at its upper end.
        let steps = ((from - to).abs() / 0.1).ceil().max(1.0);
        for k in 0..steps as usize {
            let part = segment.part(k as f64 / steps, (k + 1) as f64 / steps);
            let end = |k: usize| from + (to - from) * k as f64 / steps;
            let z = end(k).max(end(k + 1)) as f32;
            let mut cells = Vec::new();
            self.swept(&part, r, |cell, _| cells.push(cell));
            for cell in cells {
                self.height[cell] = self.height[cell].min(z);
            }
        }
    }

    /// The greatest height under a disc moved along a segment.
    fn highest(&self, segment: &Segment, r: f64) -> f32 {
        let mut highest = f32::MIN;
        self.swept(segment, r - 2.5e-3, |cell, _| highest = highest.max(self.height[cell]));
        highest
    }
}

/// What is asked of moves besides their result.
pub struct Rules {
    pub radius: f64,
    /// tan of the entry angle; none: straight down is allowed.
    pub slope: Option<f64>,
    /// What a rapid may find above its level: slopes are cut in steps, each at its upper end.
    pub slack: f32,
}

/// Runs moves over a block; tells of rapids into material and of ways down too steep.
pub fn run(block: &mut Block, start: [f64; 3], moves: &[CycleMove], rules: &Rules) -> Result<(), String> {
    let mut at = start;
    for step in moves {
        let (to, segment) = match *step {
            CycleMove::Rapid { to } | CycleMove::Feed { to } => {
                (to, Segment::Line { from: [at[0], at[1]], to: [to[0], to[1]] })
            }
            CycleMove::Arc { to, center, sweep } => {
                let (from, to2) = ([at[0], at[1]], [to[0], to[1]]);
                let gap = (distance(from, center) - distance(to2, center)).abs();
                if gap > 1e-6 || sweep.abs() > std::f64::consts::TAU + 1e-12 {
                    return Err(format!("no arc: {step:?} from {at:?}"));
                }
                (to, Segment::Arc { from, to: to2, center, sweep })
            }
        };
        let down = at[2] - to[2];
        let long = segment.length();
        match step {
            CycleMove::Rapid { .. } => {
                let lowest = at[2].min(to[2]) as f32;
                if lowest < 0.0 && block.highest(&segment, rules.radius) > lowest + rules.slack {
                    return Err(format!("rapid into material: {step:?} from {at:?}"));
                }
            }
            _ => {
                if let Some(tan) = rules.slope.filter(|tan| down > long * tan + 1e-6) {
                    let free = block.highest(&segment, rules.radius) <= to[2] as f32 + rules.slack;
                    if !free {
                        return Err(format!("steeper than {tan}: {step:?} from {at:?}"));
                    }
                }
                if to[2].min(at[2]) < 0.0 {
                    block.cut(&segment, rules.radius, at[2], to[2]);
                }
            }
        }
        at = to;
    }
    Ok(())
}

/// Distance in cells of every cell from the nearest one of a set, by the lower envelope of parabolas, rows
/// and then columns; squares.
pub fn squared_distances(size: [usize; 2], is_in: impl Fn(usize) -> bool) -> Vec<f32> {
    const FAR: f32 = 1e12;
    let mut grid: Vec<f32> = (0..size[0] * size[1]).map(|c| if is_in(c) { 0.0 } else { FAR }).collect();
    let mut line = Vec::new();
    let (mut hulls, mut bounds) = (Vec::new(), Vec::new());
    for (count, length, stride, next) in [(size[1], size[0], 1, size[0]), (size[0], size[1], size[0], 1)] {
        for n in 0..count {
            line.clear();
            line.extend((0..length).map(|k| grid[n * next + k * stride]));
            hulls.clear();
            bounds.clear();
            for q in 0..length {
                if line[q] >= FAR {
                    continue;
                }
                loop {
                    let Some(&v) = hulls.last() else {
                        hulls.push(q);
                        bounds.push(f32::NEG_INFINITY);
                        break;
                    };
                    let (fq, fv): (f32, f32) = (q as f32, v as f32);
                    let s = ((line[q] + fq * fq) - (line[v] + fv * fv)) / (2.0 * (fq - fv));
                    if s <= *bounds.last().unwrap() {
                        hulls.pop();
                        bounds.pop();
                    } else {
                        hulls.push(q);
                        bounds.push(s);
                        break;
                    }
                }
            }
            let mut k = 0;
            for q in 0..length {
                let d = if hulls.is_empty() {
                    FAR
                } else {
                    while k + 1 < hulls.len() && bounds[k + 1] < q as f32 {
                        k += 1;
                    }
                    let v = hulls[k];
                    (q as f32 - v as f32).powi(2) + line[v]
                };
                grid[n * next + q * stride] = d;
            }
        }
    }
    grid
}
