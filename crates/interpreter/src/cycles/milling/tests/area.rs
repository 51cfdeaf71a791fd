//! Pockets by area: nothing gouged, nothing left, at every level.

use super::super::{RectPocket, Roughing, RoundPocket};
use super::cut;
use super::model::{Path, Segment, Wall, distance};
use ferrocut_geometry::Turn;
use proptest::prelude::*;
use std::f64::consts::TAU;

/// Spacing of the points that must be cut, mm.
const GRID: f64 = 0.05;

/// Far below any cell, above rounding: points and distances are compared exactly, not by pixels.
const EXACT: f64 = 1e-7;

fn no_gouge(path: &Path, wall: Wall, tool: f64) {
    for s in path.cutting() {
        for [x, y, _] in s.points() {
            let d = wall.distance([x, y]) + tool;
            assert!(d < EXACT, "gouges by {d} at {x}, {y}: {s:?}");
        }
    }
}

fn nothing_left(segments: &[Segment], wall: Wall, tool: f64) {
    let wall = wall.reachable(tool);
    let cells = |half: f64| (half / GRID).ceil() as i32;
    // Neighbouring points are mostly cut by the same move: it is tried first.
    let mut last = segments[0];
    for i in -cells(wall.half[0])..=cells(wall.half[0]) {
        for j in -cells(wall.half[1])..=cells(wall.half[1]) {
            let p = [wall.center[0] + f64::from(i) * GRID, wall.center[1] + f64::from(j) * GRID];
            if wall.distance(p) > -EXACT || last.distance(p) < tool {
                continue;
            }
            match segments.iter().find(|s| s.distance(p) < tool + EXACT) {
                Some(s) => last = *s,
                None => panic!("{p:?} is left: {} away, tool {tool}", distance(segments, p)),
            }
        }
    }
}

/// Rapids go sideways at R or above only, and below R only where the tool has been at feed, at that
/// depth or deeper.
fn rapids_in_the_clear(path: &Path, r: f64, tool: f64) {
    for (n, s) in path.segments.iter().enumerate().filter(|(_, s)| !s.cuts()) {
        let low = s.from[2].min(s.to()[2]);
        if low >= r {
            continue;
        }
        assert!(s.from[0] == s.to()[0] && s.from[1] == s.to()[1], "sideways at rapid: {s:?}");
        let deep = |d: &&Segment| d.cuts() && d.from[2] <= low + 1e-9 && d.to()[2] <= low + 1e-9;
        let done: Vec<Segment> = path.segments[..n].iter().filter(deep).copied().collect();
        for k in 0..24 {
            for part in [0.0, 0.5, 1.0 - 1e-6] {
                let (sin, cos) = (f64::from(k) / 24.0 * TAU).sin_cos();
                let p = [s.to()[0] + tool * part * cos, s.to()[1] + tool * part * sin];
                assert!(distance(&done, p) < tool + EXACT, "rapid into material: {s:?}");
            }
        }
    }
}

fn clears(path: &Path, wall: Wall, tool: f64, r: f64, depths: &[f64]) {
    let seen = path.depths();
    assert_eq!(seen.len(), depths.len(), "{seen:?} instead of {depths:?}");
    assert!(seen.iter().zip(depths).all(|(a, b)| (a - b).abs() < 1e-9), "{seen:?} instead of {depths:?}");
    no_gouge(path, wall, tool);
    rapids_in_the_clear(path, r, tool);
    let plane = |s: &Segment| (s.from[0], s.from[1], s.to()[0], s.to()[1]);
    let mut checked: Vec<Vec<_>> = Vec::new();
    for z in seen {
        let segments = path.at_level(z);
        let shape: Vec<_> = segments.iter().map(plane).collect();
        if !checked.contains(&shape) {
            nothing_left(&segments, wall, tool);
            checked.push(shape);
        }
    }
}

/// Levels as 4.6.1 tells them, by walking down.
fn levels(r: f64, bottom: f64, w: f64, q: f64) -> Vec<f64> {
    let mut z = r - w;
    let mut levels = Vec::new();
    while z > bottom + 1e-6 {
        levels.push(z);
        z -= q;
    }
    levels.push(bottom);
    levels
}

fn turn() -> impl Strategy<Value = Turn> {
    prop_oneof![Just(Turn::Clockwise), Just(Turn::CounterClockwise)]
}

/// Tool radius, the part of its diameter stepped over (the whole now and then), and P269.
fn tools() -> impl Strategy<Value = (f64, f64, f64)> {
    (0.5..4.0, prop_oneof![3 => 0.15..1.0f64, 1 => Just(1.0)], 0.01..3.0)
}

/// W, Q, V and the depth below R.
fn depth_words() -> impl Strategy<Value = (f64, f64, f64, f64)> {
    (0.5..12.0, 0.5..5.0, 0.1..12.0, 1.0..20.0)
}

fn roughing(step: f64, (w, q, v, _): (f64, f64, f64, f64), helix_factor: f64) -> Roughing {
    Roughing { step: Some(step), first_depth: Some(w), depth: Some(q), gap: Some(v), helix_factor }
}

proptest! {
    #![proptest_config(ProptestConfig { cases: 300, ..ProptestConfig::default() })]

    #[test]
    fn round_pockets(
        center in prop::array::uniform2(-20.0..20.0),
        (tool, step, factor) in tools(),
        room in 0.0..1.0,
        words in depth_words(),
        r in -5.0..5.0,
        turn in turn(),
    ) {
        let least = (tool * (1.0 + factor)).max(2.0 * tool) + 1e-9;
        let radius = least + room * (15.0 - least).max(0.0);
        let bottom = r - words.3;
        let pocket = RoundPocket {
            center, r, bottom, radius: Some(radius), roughing: roughing(step * 2.0 * tool, words, factor),
            tool_radius: Some(tool), turn,
        };
        let path = cut(pocket.plan(), r);
        clears(&path, Wall::circle(center, radius), tool, r, &levels(r, bottom, words.0, words.1));
        // Everything turns as the code says.
        let sign = if turn == Turn::Clockwise { -1.0 } else { 1.0 };
        for s in path.cutting() {
            if let super::super::CycleMove::Arc { sweep, .. } = s.step {
                prop_assert!(sweep * sign > 0.0);
            }
        }
    }

    #[test]
    fn rect_pockets(
        center in prop::array::uniform2(-20.0..20.0),
        (tool, step, factor) in tools(),
        room in prop::array::uniform2(0.0..1.0),
        corner in prop::option::of(prop_oneof![Just(0.0), Just(1.0), 0.0..1.0]),
        words in depth_words(),
        r in -5.0..5.0,
        turn in turn(),
    ) {
        let least = 2.0 * tool * (1.0 + factor) + 1e-9;
        let [i, j]: [f64; 2] = room.map(|room: f64| least + room * (30.0 - least).max(0.0));
        let corner = corner.map(|part| tool + part * (i.min(j) / 2.0 - tool));
        let bottom = r - words.3;
        let pocket = RectPocket {
            center, r, bottom, sizes: [Some(i), Some(j)], roughing: roughing(step * 2.0 * tool, words, factor),
            corner, tool_radius: Some(tool), turn,
        };
        let path = cut(pocket.plan(), r);
        let wall = Wall::rectangle(center, [i, j], corner.unwrap_or(0.0));
        clears(&path, wall, tool, r, &levels(r, bottom, words.0, words.1));
    }
}

/// The helix keeps to its circle, sinks evenly and ends where it began.
#[test]
fn helix_stays_on_its_circle() {
    let path = cut(super::round_example().plan(), 5.0);
    let helix: Vec<_> = path.cutting().take_while(|s| !s.is_level()).collect();
    assert_eq!(helix.len(), 8);
    for (n, s) in helix.iter().enumerate() {
        assert_eq!(s.to(), [17.5, 25.0, 5.0 - 2.5 * (n + 1) as f64]);
        assert!(s.points().all(|p| ((p[0] - 25.0).hypot(p[1] - 25.0) - 7.5).abs() < 1e-9));
    }
}

/// In a round pocket the tool never turns a corner at feed, from the helix to the full circle.
#[test]
fn round_pocket_has_no_corners() {
    let path = cut(super::round_example().plan(), 5.0);
    let arcs = |s: &&[Segment]| s.iter().all(Segment::is_arc);
    for pair in path.segments.windows(2).filter(arcs) {
        let (a, b) = (pair[0].heading(1.0), pair[1].heading(0.0));
        assert!(a[0] * b[0] + a[1] * b[1] > 1.0 - 1e-9, "{pair:?}");
    }
    // All that cuts in the plane are arcs.
    assert!(path.cutting().all(|s| s.is_arc() || s.from[..2] == s.to()[..2]));
}
