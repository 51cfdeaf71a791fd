//! Finishing sloping walls along their depth profiles (Fagor 4.16).
//!
//! From point to point of a contour, no farther apart than ε, the tool follows the wall's profile in the
//! vertical plane through the contour's normal: down, up, or to and fro. With its tip at the height h the
//! axis is
//!
//! ```text
//! p(h) = s + d(h)·n        s: point of the contour, n: its normal into the pocket,
//!                          d(h): clearance of the tool there (depth_profile)
//! ```
//!
//! Where a normal of one contour comes nearer to another wall than that wall allows, or to another piece of
//! its own, the walls meet in a valley and the pass ends at it: a point counts only if every contour j has
//! at least its clearance dⱼ(h). About an outer corner of the material the normals fan out.

use super::depth_profile::Lean;
use super::index::{Piece, index};
use super::pen::{APPROACH, Pen, PocketSink};
use super::profile::Profile;
use super::tool::Tool;
use ferrocut_geometry::vector::{add, along, angle, cross, distance, left, turned};
use rstar::RTree;

/// In which direction the wall is cut (icon of 4.16).
#[derive(Clone, Copy, PartialEq, Eq, Debug, Default)]
pub enum WallDirection {
    /// Downwards.
    #[default]
    Down,
    /// Upwards.
    Up,
    /// To and fro.
    Zigzag,
}

/// A contour with its wall.
#[derive(Debug)]
pub(crate) struct Slope {
    /// With the pocket on its left.
    pub contour: Profile,
    pub lean: Lean,
    pub is_island: bool,
    tree: RTree<Piece>,
}

/// One pass: axis and tip height from the top of the wall downwards, and the normal into the pocket.
#[derive(Clone, PartialEq, Debug)]
pub(crate) struct Pass {
    pub points: Vec<[f64; 3]>,
    pub normal: [f64; 2],
}

/// What a clearance may be short of, mm.
const SLACK: f64 = 1e-3;

impl Slope {
    pub fn new(contour: Profile, lean: Lean, is_island: bool) -> Slope {
        let tree = index(&contour.segments);
        Slope { contour, lean, is_island, tree }
    }

    /// Distance of a point from the contour, into the pocket positive.
    pub fn distance(&self, p: [f64; 2]) -> f64 {
        let Some(piece) = self.tree.nearest_neighbor(p) else { return f64::INFINITY };
        let d = piece.segment.distance(p);
        if self.contour.contains(p) == self.is_island { -d } else { d }
    }
}

/// Whether the axis may stand at a point: every wall has its clearance.
pub(crate) fn is_free(slopes: &[Slope], clearances: &[f64], p: [f64; 2]) -> bool {
    slopes
        .iter()
        .zip(clearances)
        .all(|(slope, clearance)| *clearance == f64::NEG_INFINITY || slope.distance(p) >= clearance - SLACK)
}

/// Clearances of all walls with the tip at a height; a wall that ends below it asks for nothing.
pub(crate) fn clearances(slopes: &[Slope], tip: f64, tool: &Tool) -> Vec<f64> {
    let one = |slope: &Slope| {
        if tip >= slope.lean.top - 1e-9 && slope.is_island && slope.lean.top < 0.0 {
            return f64::NEG_INFINITY;
        }
        slope.lean.clearance(tip, tool, slope.is_island)
    };
    slopes.iter().map(one).collect()
}

/// The passes along the wall of one contour.
pub(crate) fn passes(slopes: &[Slope], own: usize, floor: f64, tool: &Tool, width: f64) -> Vec<Pass> {
    let Some(slope) = slopes.get(own) else { return Vec::new() };
    let way = slope.lean.way_down(floor, tool, slope.is_island);
    let needed: Vec<Vec<f64>> = way.iter().map(|[h, _]| clearances(slopes, *h, tool)).collect();
    let widest = way.iter().fold(0.0f64, |most, [_, d]| most.max(d.abs()));
    let mut passes = Vec::new();
    for (s, normal) in places(&slope.contour, width, widest) {
        let point = |[h, d]: [f64; 2]| {
            let [x, y] = along(s, normal, d);
            [x, y, h]
        };
        let mut run: Vec<[f64; 3]> = Vec::new();
        let mut last: Option<([f64; 2], bool)> = None;
        for (at, needed) in way.iter().zip(&needed) {
            let p = point(*at);
            let free = is_free(slopes, needed, [p[0], p[1]]);
            if let Some((before, was_free)) = last.filter(|(_, was)| *was != free) {
                // The valley is between the two.
                let (mut good, mut bad) = if was_free { (before, *at) } else { (*at, before) };
                for _ in 0..12 {
                    let middle = [(good[0] + bad[0]) / 2.0, (good[1] + bad[1]) / 2.0];
                    let q = point(middle);
                    let needed = clearances(slopes, middle[0], tool);
                    if is_free(slopes, &needed, [q[0], q[1]]) { good = middle } else { bad = middle }
                }
                run.push(point(good));
            }
            if free {
                run.push(p);
            } else {
                keep(&mut passes, &mut run, normal);
            }
            last = Some((*at, free));
        }
        keep(&mut passes, &mut run, normal);
    }
    passes
}

fn keep(passes: &mut Vec<Pass>, run: &mut Vec<[f64; 3]>, normal: [f64; 2]) {
    let points = std::mem::take(run);
    let long = points.windows(2).any(
        |p| matches!(p, [a, b] if (a[2] - b[2]).abs() > 1e-6 || distance([a[0], a[1]], [b[0], b[1]]) > 1e-6),
    );
    if long {
        passes.push(Pass { points, normal });
    }
}

/// Points of a contour no farther than `width` apart, with normals into the pocket; about an outer corner
/// the tips of normals of the length `reach` are no farther apart.
fn places(contour: &Profile, width: f64, reach: f64) -> Vec<([f64; 2], [f64; 2])> {
    let mut places = Vec::new();
    let before = contour.segments.iter().cycle().skip(contour.segments.len().saturating_sub(1));
    for (before, segment) in before.zip(&contour.segments) {
        let (from, to) = (left(before.direction(1.0)), left(segment.direction(0.0)));
        let turn = angle(from, to);
        if cross(from, to) < -1e-9 {
            let fan = (turn.abs() * reach / width).ceil().clamp(1.0, 1e4) as u32;
            places.extend(
                (0..fan).map(|k| (segment.from(), turned(from, turn * f64::from(k) / f64::from(fan)))),
            );
        } else if turn > 1e-9 {
            places.push((segment.from(), from));
        }
        let count = (segment.length() / width).ceil().clamp(1.0, 1e6) as u32;
        places.extend((0..count).map(|k| {
            let t = f64::from(k) / f64::from(count);
            (segment.point(t), left(segment.direction(t)))
        }));
    }
    places
}

/// Number of passes at most.
pub(crate) fn count(contour: &Profile, width: f64, reach: f64) -> f64 {
    let long: f64 = contour.segments.iter().map(|s| s.length() / width + 1.0).sum();
    let corners = contour.segments.len() as f64 * (std::f64::consts::PI * reach / width + 1.0);
    long + corners
}

/// Where the tool may go down beside a wall: whether a point is open down to a height.
pub(crate) type Open<'a> = &'a dyn Fn([f64; 2], f64) -> bool;

/// Cuts passes in a direction; the tool comes from anywhere and stays above the surface at the end.
pub(crate) fn cut<S: PocketSink>(
    pen: &mut Pen<'_, S>,
    slopes: &[Slope],
    tool: &Tool,
    passes: &[Pass],
    direction: WallDirection,
    open: Open<'_>,
) -> Result<(), S::Error> {
    let approach = pen.planes().approach();
    // Where the pass before has ended at its lower or upper end, still on the wall.
    let mut on_wall: Option<[f64; 3]> = None;
    let mut up = direction == WallDirection::Up;
    for pass in passes {
        let (Some(top), Some(bottom)) = (pass.points.first(), pass.points.last()) else { continue };
        let start = if up { bottom } else { top };
        let linked = on_wall.and_then(|at| link(slopes, tool, at, *start, pass.normal));
        match linked {
            Some(way) => {
                for p in way {
                    pen.slope([p[0], p[1]], p[2])?;
                }
            }
            None => {
                if up {
                    let beside = clear_beside(slopes, pass, *bottom, tool, open);
                    match beside {
                        Some(q) => {
                            down(pen, q, approach)?;
                            pen.rapid_height((bottom[2] + APPROACH).min(approach))?;
                            pen.plunge(bottom[2])?;
                            pen.slope([bottom[0], bottom[1]], bottom[2])?;
                        }
                        // Nowhere to go down beside it: this one is cut downwards.
                        None => up = false,
                    }
                }
                if !up {
                    down(pen, [top[0], top[1]], approach)?;
                    pen.plunge(top[2])?;
                }
            }
        }
        let forward = pass.points.iter().skip(1);
        let backward = pass.points.iter().rev().skip(1);
        let order: Box<dyn Iterator<Item = &[f64; 3]>> =
            if up { Box::new(backward) } else { Box::new(forward) };
        for p in order {
            pen.slope([p[0], p[1]], p[2])?;
        }
        on_wall = match direction {
            WallDirection::Zigzag => {
                let end = if up { *top } else { *bottom };
                up = !up;
                Some(end)
            }
            one => {
                up = one == WallDirection::Up;
                None
            }
        };
        if on_wall.is_none() {
            // Straight up from a wall that leans back nothing is in the way.
            pen.rapid_height(approach)?;
        }
    }
    pen.rapid_height(approach)
}

/// Over a point at the approach plane.
fn down<S: PocketSink>(pen: &mut Pen<'_, S>, p: [f64; 2], approach: f64) -> Result<(), S::Error> {
    // Neighbouring passes are a width apart, at the approach plane.
    let near = distance(pen.at(), p) < 10.0;
    if near {
        pen.rapid_height(approach)?;
        pen.rapid(p)
    } else {
        pen.over(p)?;
        pen.rapid_height(approach)
    }
}

/// A point beside the lower end of a pass that is open down to it, with nothing in the way from there.
fn clear_beside(
    slopes: &[Slope],
    pass: &Pass,
    bottom: [f64; 3],
    tool: &Tool,
    open: Open<'_>,
) -> Option<[f64; 2]> {
    /// Points tried, a quarter of the tool radius apart.
    const TRIED: u32 = 16;
    let needed = clearances(slopes, bottom[2], tool);
    let beside = |k| along([bottom[0], bottom[1]], pass.normal, tool.radius * f64::from(k) / 4.0);
    (1..=TRIED).map(beside).take_while(|q| is_free(slopes, &needed, *q)).find(|q| open(*q, bottom[2]))
}

/// From the end of one pass to the beginning of the next on the wall: straight, or where that would cut into
/// a wall bulging out, round it.
fn link(
    slopes: &[Slope],
    tool: &Tool,
    from: [f64; 3],
    to: [f64; 3],
    normal: [f64; 2],
) -> Option<Vec<[f64; 3]>> {
    let (a, b) = ([from[0], from[1]], [to[0], to[1]]);
    let gap = distance(a, b);
    if gap > 2.0 * tool.radius {
        return None;
    }
    let height = from[2].max(to[2]);
    let free = |p: [f64; 2], h: f64| {
        // A wall that ends lower is passed over at its own height.
        is_free(slopes, &clearances(slopes, h, tool), p)
    };
    let between =
        |a: [f64; 2], b: [f64; 2], t: f64| add([a[0] * (1.0 - t), a[1] * (1.0 - t)], [b[0] * t, b[1] * t]);
    let clear = |a: [f64; 2], b: [f64; 2]| (0..=8).all(|k| free(between(a, b, f64::from(k) / 8.0), height));
    let lifted = |p: [f64; 2]| [p[0], p[1], height];
    if clear(a, b) {
        return Some(vec![lifted(a), lifted(b), to]);
    }
    let aside = along(between(a, b, 0.5), normal, 0.4 * gap);
    (clear(a, aside) && clear(aside, b)).then(|| vec![lifted(a), lifted(aside), lifted(b), to])
}
