//! The order of cutting: everything once, what is inside before what is around it, and no more way than
//! the drawing's own order.
#![allow(missing_docs, clippy::unwrap_used, clippy::panic)]

use ferrocut_exchange::curve::Curve;
use ferrocut_exchange::drawing::{Action, Drawing, Layer, Move};
use ferrocut_exchange::limits::Limits;
use ferrocut_exchange::plan::plan;
use ferrocut_exchange::{Cutting, Format, Order, Settings};
use ferrocut_geometry::vector::{Point, distance};
use ferrocut_program::Span;
use proptest::prelude::*;
use std::time::Instant;

/// A drawing of these curves, each with its number as line, on layers with these tools; 0 is none.
fn drawing(curves: &[(Curve, u32)], tools: &[u32]) -> Drawing {
    let mut drawing = Drawing::new(Format::Dxf);
    for tool in tools {
        let cutting = Cutting { tool: Some(*tool).filter(|tool| *tool > 0), ..Settings::default().cutting };
        drawing.layers.push(Layer { name: tool.to_string().into(), cutting: Some(cutting) });
    }
    for (line, (curve, layer)) in (1..).zip(curves) {
        let span = Span { line, ..Span::default() };
        drawing.cut(*curve, 0.01, *layer, span, &Limits::new()).unwrap();
    }
    drawing
}

/// The numbers of the curves in the order of cutting.
fn order(moves: &[Move]) -> Vec<u32> {
    moves.iter().filter(|m| matches!(m.action, Action::Cut(_))).map(|m| m.span.line).collect()
}

fn way(moves: &[Move]) -> f64 {
    let (mut at, mut way) = ([0.0; 2], 0.0);
    for m in moves {
        match m.action {
            Action::Travel(to) => {
                way += distance(at, to);
                at = to;
            }
            Action::Cut(curve) => at = curve.to,
            _ => {}
        }
    }
    way
}

fn circle(center: Point, radius: f64) -> Curve {
    Curve::circle(center, [center[0] + radius, center[1]])
}

fn sides(center: Point, half: f64) -> [Curve; 4] {
    let corner = |x: f64, y: f64| [center[0] + x * half, center[1] + y * half];
    let corners = [corner(-1.0, -1.0), corner(1.0, -1.0), corner(1.0, 1.0), corner(-1.0, 1.0)];
    std::array::from_fn(|i| Curve::line(corners[i], corners[(i + 1) % 4]))
}

#[test]
fn holes_come_before_the_outline_whatever_tool_they_need() {
    let mut curves: Vec<(Curve, u32)> = sides([50.0, 50.0], 50.0).map(|side| (side, 0)).to_vec();
    curves.extend([[20.0, 20.0], [80.0, 20.0], [80.0, 80.0]].map(|center| (circle(center, 5.0), 1)));
    let moves = plan(&drawing(&curves, &[1, 2]), Order::Shortest);
    let cut = order(&moves);
    assert_eq!(cut[..3], [5, 6, 7], "the near hole first, then on");
    let mut outline = cut[3..].to_vec();
    outline.sort_unstable();
    assert_eq!(outline, [1, 2, 3, 4]);
    // One lowering for each contour.
    assert_eq!(moves.iter().filter(|m| m.action == Action::Lower).count(), 4);
}

/// The layers with a tool in the order in which they are cut, each once as long as it goes on.
fn turns(drawing: &Drawing) -> Vec<u32> {
    let moves = plan(drawing, Order::Shortest);
    let cuts = moves.iter().filter(|m| matches!(m.action, Action::Cut(_)));
    let has_tool = |layer: &u32| drawing.layers[*layer as usize].cutting.unwrap().tool.is_some();
    let mut layers: Vec<u32> = cuts.map(|m| m.layer).filter(has_tool).collect();
    layers.dedup();
    layers
}

#[test]
fn tools_change_no_more_often_than_what_is_inside_asks_for() {
    let ring = |x: f64, radius: f64, layer: u32| (circle([x, 0.0], radius), layer);
    // The outline that has no hole need not come before the holes of the others.
    let curves = [ring(0.0, 5.0, 0), ring(20.0, 5.0, 0), ring(20.0, 1.0, 1), ring(40.0, 5.0, 0)];
    assert_eq!(turns(&drawing(&curves, &[1, 2])), [1, 0]);
    // As drawn the way is the shortest there is, with a change at every contour.
    let pairs = (0..5).flat_map(|i| [ring(f64::from(i) * 20.0, 1.0, 1), ring(f64::from(i) * 20.0, 5.0, 0)]);
    assert_eq!(turns(&drawing(&pairs.collect::<Vec<_>>(), &[1, 2])), [1, 0]);
    // Three tools, of which the second waits for the third: whoever takes them as drawn comes back.
    let curves =
        [ring(0.0, 5.0, 0), ring(20.0, 5.0, 1), ring(20.0, 1.0, 2), ring(40.0, 5.0, 0), ring(40.0, 2.0, 1)];
    assert_eq!(turns(&drawing(&curves, &[1, 2, 3])), [2, 1, 0]);
    // Where nothing waits they come as drawn.
    let curves = [ring(0.0, 5.0, 1), ring(20.0, 5.0, 0), ring(40.0, 5.0, 1)];
    assert_eq!(turns(&drawing(&curves, &[1, 2])), [1, 0]);
    // What needs no tool is cut with the one that is there.
    let curves = [ring(0.0, 1.0, 0), ring(50.0, 3.0, 1), ring(0.0, 3.0, 2), ring(0.0, 6.0, 0)];
    assert_eq!(turns(&drawing(&curves, &[1, 2, 0])), [0, 1]);
    // Many tools, every other of which waits for the next and for no more.
    let groups = (0..10u32).flat_map(|i| {
        let x = f64::from(i) * 40.0;
        [ring(x, 5.0, 2 * i), ring(x + 20.0, 5.0, 2 * i), ring(x + 20.0, 1.0, 2 * i + 1)]
    });
    let tools: Vec<u32> = (1..=20).collect();
    assert_eq!(turns(&drawing(&groups.collect::<Vec<_>>(), &tools)).len(), 20);
}

#[test]
fn as_drawn_nothing_is_turned_round_or_joined_that_does_not_follow() {
    let side = sides([0.0; 2], 1.0);
    let curves = [(side[0], 0), (side[1], 0), (side[3].reversed(), 0)];
    let moves = plan(&drawing(&curves, &[1]), Order::AsDrawn);
    let kinds: String = moves
        .iter()
        .map(|m| match m.action {
            Action::Raise => 'R',
            Action::Travel(_) => 'T',
            Action::Lower => 'L',
            Action::Cut(_) => 'C',
        })
        .collect();
    assert_eq!(kinds, "RTLCCRTLCR");
}

#[test]
fn crowds_are_ordered_in_good_time() {
    let start = Instant::now();
    // All lines from one point; all circles about one; a thousand squares within each other.
    let star = (0..20_000).map(|i| {
        let (sin, cos) = (f64::from(i) * 0.001).sin_cos();
        (Curve::line([0.0; 2], [100.0 * cos, 100.0 * sin]), 0)
    });
    let rings =
        (0..4000).map(|i| (circle([500.0, 0.0], 1.0 + 0.1 * f64::from(i % 977) + f64::from(i) * 1e-3), 0));
    let boxes = (1..1000).rev().flat_map(|i| sides([0.0, 2000.0], f64::from(i))).map(|side| (side, 0));
    let curves: Vec<(Curve, u32)> = star.chain(rings).chain(boxes).collect();
    let moves = plan(&drawing(&curves, &[1]), Order::Shortest);
    assert_eq!(order(&moves).len(), curves.len());
    // Seconds would be the square of their number; this takes a fraction of one.
    assert!(start.elapsed().as_secs() < 30, "{:?}", start.elapsed());
}

/// A contour or an open line somewhere on a sheet.
fn figure() -> impl Strategy<Value = (Vec<Curve>, u32)> {
    let place = (0i32..40, 0i32..40, 1i32..25, 0u32..3, 0u8..3);
    place.prop_map(|(x, y, size, layer, kind)| {
        let (center, size) = ([f64::from(x) * 5.0, f64::from(y) * 5.0], f64::from(size) * 1.03);
        let curves = match kind {
            0 => vec![circle(center, size)],
            1 => sides(center, size).to_vec(),
            _ => vec![Curve::line(center, [center[0] + size, center[1] + 1.0])],
        };
        (curves, layer)
    })
}

/// The fewest turns of tools in which circles on layers can be cut, a tool each and one more without: all orders are
/// tried.
fn fewest(circles: &[(Point, f64, u32)], layers: u32) -> usize {
    let is_in = |a: &(Point, f64, u32), b: &(Point, f64, u32)| distance(a.0, b.0) + a.1 < b.1;
    let turn = |state: &[bool], layer: u32| {
        let mut cut = state.to_vec();
        // From the smallest on, so that each has had its turn before what is around it.
        let mut order: Vec<usize> =
            (0..circles.len()).filter(|i| [layer, layers].contains(&circles[*i].2)).collect();
        order.sort_by(|a, b| circles[*a].1.total_cmp(&circles[*b].1));
        for i in order {
            cut[i] |= (0..circles.len()).all(|j| cut[j] || j == i || !is_in(&circles[j], &circles[i]));
        }
        cut
    };
    let mut states = vec![turn(&vec![false; circles.len()], layers)];
    for count in 0.. {
        if states.iter().any(|cut| cut.iter().all(|cut| *cut)) {
            return count;
        }
        let mut next: Vec<Vec<bool>> = Vec::new();
        for (state, layer) in states.iter().flat_map(|state| (0..layers).map(move |layer| (state, layer))) {
            let cut = turn(state, layer);
            if !next.contains(&cut) {
                next.push(cut);
            }
        }
        states = next;
    }
    unreachable!()
}

proptest! {
    #![proptest_config(ProptestConfig { failure_persistence: None, ..ProptestConfig::with_cases(300) })]

    #[test]
    fn everything_is_cut_once_and_inner_before_outer(figures in prop::collection::vec(figure(), 1..40)) {
        let curves: Vec<(Curve, u32)> =
            figures.iter().flat_map(|(curves, layer)| curves.iter().map(|c| (*c, *layer))).collect();
        let drawing = drawing(&curves, &[1, 2, 1]);
        let moves = plan(&drawing, Order::Shortest);
        let cut = order(&moves);
        let mut sorted = cut.clone();
        sorted.sort_unstable();
        prop_assert_eq!(sorted, (1..=curves.len() as u32).collect::<Vec<_>>());
        // Lengths are kept, whichever way round.
        for m in &moves {
            if let Action::Cut(curve) = m.action {
                let (drawn, _) = curves[m.span.line as usize - 1];
                prop_assert!((curve.length() - drawn.length()).abs() < 1e-9);
                prop_assert_eq!(curve.bend.map(|b| b.center), drawn.bend.map(|b| b.center));
            }
        }
        // Circles tell who is inside of whom without doubt.
        let place = |line: u32| cut.iter().position(|l| *l == line).unwrap();
        for (i, (a, _)) in (1u32..).zip(&curves) {
            for (j, (b, _)) in (1u32..).zip(&curves) {
                let (Some(inner), Some(outer)) = (a.bend, b.bend) else { continue };
                if i != j && distance(inner.center, outer.center) + a.radius() < b.radius() - 0.01 {
                    prop_assert!(place(i) < place(j), "{} is in {}", i, j);
                }
            }
        }
        // One tool only: then the way is at most that of the drawing's order, if it keeps the rule.
        let one = self::drawing(&curves.iter().map(|(c, _)| (*c, 0)).collect::<Vec<_>>(), &[1]);
        let circles_only = curves.iter().all(|(c, _)| c.bend.is_none());
        if circles_only {
            prop_assert!(way(&plan(&one, Order::Shortest)) <= way(&plan(&one, Order::AsDrawn)) + 1e-9);
        }
    }

    #[test]
    fn tools_change_as_seldom_as_can_be(
        circles in prop::collection::vec((0..4, 0..4, 1u32..8, 0..4u32), 1..14)
    ) {
        // None touches another: places are far apart, radii at a place differ.
        let mut placed: Vec<(Point, f64, u32)> = Vec::new();
        for (x, y, radius, layer) in circles {
            let circle = ([f64::from(x) * 20.0, f64::from(y) * 20.0], f64::from(radius), layer);
            if placed.iter().all(|other| other.0 != circle.0 || other.1 != circle.1) {
                placed.push(circle);
            }
        }
        let curves: Vec<(Curve, u32)> =
            placed.iter().map(|(center, radius, layer)| (self::circle(*center, *radius), *layer)).collect();
        prop_assert_eq!(turns(&drawing(&curves, &[1, 2, 3, 0])).len(), fewest(&placed, 3));
    }
}
