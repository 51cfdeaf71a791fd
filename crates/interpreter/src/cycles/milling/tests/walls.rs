//! Finishing: the wall is left exactly, and met and left without a mark.

use super::super::{CircleFinish, CycleMove, RectFinish, Side};
use super::cut;
use super::model::{Path, Wall, distance};
use ferrocut_geometry::Turn;
use proptest::prelude::*;

/// Well below the 2 µm that are asked for.
const EXACT: f64 = 1e-6;

fn finishes(path: &Path, wall: Wall, side: Side, tool: f64, bottom: f64) {
    assert_eq!(path.depths(), [bottom]);
    let clear = |d: f64| if side == Side::Inside { -d } else { d } - tool;
    for s in path.cutting() {
        for [x, y, _] in s.points() {
            let d = clear(wall.distance([x, y]));
            assert!(d > -EXACT, "gouges by {d} at {x}, {y}: {s:?}");
        }
    }
    let wall = if side == Side::Inside { wall.reachable(tool) } else { wall };
    let level = path.at_level(bottom);
    for p in wall.points(60) {
        let d = distance(&level, p) - tool;
        assert!(d.abs() < EXACT, "{d} left on the wall at {p:?}");
    }
}

/// From the start onto the wall, round it and back: no corner on the way but those of the part and the
/// feet of straight lines, and back to where it began.
fn smooth(path: &Path, bottom: f64, sharp_corners: bool) {
    let level = path.at_level(bottom);
    let corners = level
        .windows(2)
        .filter(|w| {
            let (a, b) = (w[0].heading(1.0), w[1].heading(0.0));
            a[0] * b[0] + a[1] * b[1] < 1.0 - 1e-6
        })
        .count();
    let feet = if level.first().is_some_and(|s| !s.is_arc()) { 2 } else { 0 };
    assert!(corners <= feet + if sharp_corners { 4 } else { 0 }, "{corners} corners: {level:#?}");
    let (first, last) = (level.first().unwrap(), level.last().unwrap());
    assert!((0..2).all(|k| (first.from[k] - last.to()[k]).abs() < 1e-9));
}

/// Which way the moves along the wall go round its middle: 1 counter-clockwise, −1 clockwise.
fn way_round(path: &Path, wall: Wall, tool: f64) -> f64 {
    let [cx, cy] = wall.center;
    let along: Vec<f64> = path
        .cutting()
        .filter_map(|s| {
            let (p, [hx, hy]) = (s.point(0.5), s.heading(0.5));
            let on_wall = s.is_level() && (wall.distance([p[0], p[1]]).abs() - tool).abs() < 1e-6;
            on_wall.then(|| ((p[0] - cx) * hy - (p[1] - cy) * hx).signum())
        })
        .collect();
    assert!(along.len() >= 5 && along.iter().all(|w| *w == along[0]), "{along:?}");
    along[0]
}

fn sides() -> impl Strategy<Value = Side> {
    prop_oneof![Just(Side::Inside), Just(Side::Outside)]
}

fn turns() -> impl Strategy<Value = Turn> {
    prop_oneof![Just(Turn::Clockwise), Just(Turn::CounterClockwise)]
}

proptest! {
    #![proptest_config(ProptestConfig { cases: 500, ..ProptestConfig::default() })]

    #[test]
    fn circles(
        side in sides(),
        turn in turns(),
        center in prop::array::uniform2(-50.0..50.0),
        tool in 0.1..10.0f64,
        room in prop_oneof![9 => 0.01..60.0, 1 => Just(0.01)],
        start in prop_oneof![0.0..1.0, Just(1.0)],
        negative in any::<bool>(),
    ) {
        let radius = if side == Side::Inside { tool + room } else { 0.1 + room };
        let j = if side == Side::Inside { start * (radius - tool) } else { tool + start * 20.0 };
        let sign = if negative { -1.0 } else { 1.0 };
        let words = CircleFinish {
            side, center, r: 2.0, bottom: -3.0, radius: Some(sign * radius), start: Some(sign * j),
            tool_radius: Some(tool), turn,
        };
        let path = cut(words.plan(), 2.0);
        finishes(&path, Wall::circle(center, radius), side, tool, -3.0);
        smooth(&path, -3.0, false);
        let full: Vec<_> = path.cutting().filter_map(|s| match s.step {
            CycleMove::Arc { sweep, .. } if sweep.abs() > 6.0 => Some(sweep),
            _ => None,
        }).collect();
        prop_assert_eq!(full.len(), 1);
        prop_assert_eq!(full[0] > 0.0, turn == Turn::CounterClockwise);
    }

    #[test]
    fn rectangles(
        side in sides(),
        turn in turns(),
        start in prop::array::uniform2(-50.0..50.0),
        tool in 0.1..10.0f64,
        room in prop::array::uniform2(0.0..60.0),
        corner in prop::option::of(0.0..=1.0),
        distance in 0.0..=1.0f64,
    ) {
        let [i, j]: [f64; 2] = room.map(|room: f64| 2.0 * tool + room);
        let corner = corner.map(|part| tool + part * (i.min(j) / 2.0 - tool));
        let far = if side == Side::Inside { (i - tool).min(j) } else { 70.0 };
        let l = tool + distance * (far - tool);
        let words = RectFinish {
            side, start, r: 2.0, bottom: -3.0, sizes: [Some(i), Some(j)], distance: Some(l), corner,
            tool_radius: Some(tool), turn,
        };
        let plan = words.plan().unwrap();
        prop_assert!((plan.start()[0] - start[0]).abs() < 1e-9 && plan.start()[1] == start[1]);
        let path = cut(Ok(plan), 2.0);
        let middle = if side == Side::Inside { start[0] + l - i / 2.0 } else { start[0] - l - i / 2.0 };
        let wall = Wall::rectangle([middle, start[1]], [i, j], corner.unwrap_or(0.0));
        finishes(&path, wall, side, tool, -3.0);
        smooth(&path, -3.0, corner.is_none_or(|c| side == Side::Inside && c - tool < 1e-6));
        // The smallest pocket has no way round.
        if side == Side::Outside || i.min(j) > 2.1 * tool {
            let sign = if turn == Turn::CounterClockwise { 1.0 } else { -1.0 };
            prop_assert_eq!(way_round(&path, wall, tool), sign);
        }
    }
}

/// A hole as wide as the tool is plunged and no more.
#[test]
fn no_room_to_go_round() {
    let mut words = super::circle_finish_example(Side::Inside);
    (words.radius, words.start, words.tool_radius) = (Some(0.3), Some(0.0), Some(0.3));
    let path = cut(words.plan(), 5.0);
    assert_eq!((path.cutting().count(), path.depths().len()), (1, 0));
}

/// 0.3 − 0.1 is less than 0.2 in floating point; the tool starts on the wall and goes round once.
#[test]
fn room_to_the_last_bit() {
    let mut words = super::circle_finish_example(Side::Inside);
    (words.radius, words.start, words.tool_radius) = (Some(0.3), Some(0.1), Some(0.2));
    let path = cut(words.plan(), 5.0);
    assert_eq!(path.cutting().filter(|s| s.is_level()).count(), 1);
}
