//! The cases of the manual and of the conformance suite, in coordinates of the plane.

use super::*;
use ferrocut_geometry::vector;
use std::f64::consts::{FRAC_PI_2, SQRT_2};

/// Expected: end, arc (centre, sweep in degrees), payload, inserted.
type Step = ([f64; 2], Option<([f64; 2], f64)>, usize, bool);

fn line(x: f64, y: f64, block: usize) -> Step {
    ([x, y], None, block, false)
}

fn piece(x: f64, y: f64, block: usize) -> Step {
    ([x, y], None, block, true)
}

fn round(x: f64, y: f64, center: [f64; 2], degrees: f64, block: usize) -> Step {
    ([x, y], Some((center, degrees)), block, false)
}

fn expect_with(rules: Rules, start: [f64; 2], ops: &[Op], steps: &[Step], tol: f64) {
    let (got, fault) = run(rules, start, ops);
    assert_eq!(fault, None);
    let moves: Vec<_> = got.iter().filter(|o| matches!(o, Out::Move { .. })).collect();
    assert_eq!(moves.len(), steps.len(), "{got:#?}");
    for (o, (end, arc, block, piece)) in moves.into_iter().zip(steps) {
        let Out::Move { to, shape, payload, inserted } = o else { unreachable!() };
        assert!(vector::distance(*to, *end) <= tol, "{to:?} is not {end:?}: {got:#?}");
        assert_eq!((payload, inserted), (block, piece), "{got:#?}");
        match (shape, arc) {
            (Shape::Line, None) => {}
            (Shape::Arc { center, sweep }, Some((c, degrees))) => {
                assert!(vector::distance(*center, *c) <= tol, "{got:#?}");
                assert!((sweep.to_degrees() - degrees).abs() <= tol, "{sweep} {degrees}");
            }
            _ => panic!("{shape:?} is not {arc:?}: {got:#?}"),
        }
    }
}

fn expect(start: [f64; 2], ops: &[Op], steps: &[Step]) {
    expect_with(Rules::default(), start, ops, steps, 1e-9);
}

fn fault(rules: Rules, start: [f64; 2], ops: &[Op]) -> Option<(Fault, usize)> {
    run(rules, start, ops).1.map(|f| (f.fault, f.at))
}

fn type_b() -> Rules {
    Rules { start_up: StartUp::B, ..Rules::default() }
}

use Op::{Ccw, Cw, Flush, G39, Pass, Suspend, To};

// ---- conformance/gsk990mc

#[test]
fn comp_outside() {
    let rectangle =
        [g41(6.0), To([0.0, 0.0]), To([0.0, 40.0]), To([60.0, 40.0]), To([60.0, 0.0]), To([0.0, 0.0]), G40];
    let mut ops = rectangle.to_vec();
    ops.push(To([-20.0, -10.0]));
    let steps = [
        line(-6.0, 0.0, 1),
        line(-6.0, 46.0, 2),
        line(66.0, 46.0, 3),
        line(66.0, -6.0, 4),
        line(0.0, -6.0, 5),
        line(-20.0, -10.0, 7),
    ];
    expect([-20.0, -10.0], &ops, &steps);
}

#[test]
fn comp_example() {
    let ops = [
        g41(20.0),
        To([250.0, 550.0]),
        To([250.0, 900.0]),
        To([450.0, 900.0]),
        Ccw([500.0, 1150.0], [-150.0, 1150.0]),
        Cw([900.0, 1150.0], [700.0, 1300.0]),
        Ccw([950.0, 900.0], [1550.0, 1150.0]),
        To([1150.0, 900.0]),
        To([1150.0, 550.0]),
        To([700.0, 650.0]),
        To([250.0, 550.0]),
        G40,
        To([0.0, 0.0]),
    ];
    // The acute corner at (1150,550), 77.5°: both offset lines run on by 20.
    let back = vector::unit([-450.0, 100.0]).unwrap();
    let join = vector::along([1150.0, 550.0], vector::sub(vector::left(back), back), 20.0);
    let steps = [
        line(230.0, 550.0, 1),
        line(230.0, 920.0, 2),
        line(436.51513, 920.0, 3),
        round(479.96669, 1143.52206, [-150.0, 1150.0], 20.82332, 4),
        round(920.03331, 1143.52206, [700.0, 1300.0], -250.8375, 5),
        round(963.48487, 920.0, [1550.0, 1150.0], 20.82332, 6),
        line(1170.0, 920.0, 7),
        line(1170.0, 530.0, 8),
        piece(join[0], join[1], 8),
        line(700.0, 629.51212, 9),
        line(254.33861, 530.47626, 10),
        line(0.0, 0.0, 12),
    ];
    expect_with(Rules::default(), [0.0, 0.0], &ops, &steps, 1e-5);
}

#[test]
fn comp_tangent_arcs() {
    let ops = [
        g42(4.0),
        To([0.0, 0.0]),
        To([50.0, 0.0]),
        Ccw([50.0, 40.0], [50.0, 20.0]),
        To([0.0, 40.0]),
        Ccw([0.0, 0.0], [0.0, 20.0]),
        G40,
        To([-20.0, -10.0]),
    ];
    let steps = [
        line(0.0, -4.0, 1),
        line(50.0, -4.0, 2),
        round(50.0, 44.0, [50.0, 20.0], 180.0, 3),
        line(0.0, 44.0, 4),
        round(0.0, -4.0, [0.0, 20.0], 180.0, 5),
        line(-20.0, -10.0, 7),
    ];
    expect([-20.0, -10.0], &ops, &steps);
}

#[test]
fn comp_type_a_and_b() {
    let ops = [g41(5.0), To([0.0, 0.0]), To([0.0, -40.0]), To([-30.0, -40.0]), G40, To([-30.0, 0.0])];
    let a = [line(5.0, 0.0, 1), line(5.0, -45.0, 2), line(-30.0, -45.0, 3), line(-30.0, 0.0, 5)];
    let b = [line(5.0, 5.0, 1), line(5.0, -45.0, 2), line(-35.0, -45.0, 3), line(-30.0, 0.0, 5)];
    expect([-30.0, 0.0], &ops, &a);
    expect_with(type_b(), [-30.0, 0.0], &ops, &b, 1e-9);
}

#[test]
fn comp_type_a_acute() {
    let ops = [g41(5.0), To([0.0, 0.0]), To([-40.0, -30.0]), G40, To([-26.0, 18.0])];
    let steps = [line(3.0, -4.0, 1), line(-37.0, -34.0, 2), line(-26.0, 18.0, 4)];
    expect([-30.0, 0.0], &ops, &steps);
}

#[test]
fn comp_z_block() {
    let ops = [
        g41(5.0),
        To([0.0, 0.0]),
        To([40.0, 0.0]),
        Pass,
        To([40.0, 40.0]),
        To([0.0, 40.0]),
        G40,
        To([-10.0, 50.0]),
    ];
    let steps = [
        line(0.0, 5.0, 1),
        line(35.0, 5.0, 2),
        line(35.0, 35.0, 4),
        line(0.0, 35.0, 5),
        line(-10.0, 50.0, 7),
    ];
    expect([-10.0, -10.0], &ops, &steps);
    // It is executed where the block before it ended.
    let (got, _) = run(Rules::default(), [-10.0, -10.0], &ops);
    assert_eq!(got.iter().position(|o| matches!(o, Out::Other(3))), Some(2));
}

#[test]
fn comp_g39() {
    let ops = [
        g41(4.0),
        To([0.0, 0.0]),
        To([10.0, 0.0]),
        G39,
        To([10.0, -10.0]),
        To([40.0, -10.0]),
        G40,
        To([60.0, -10.0]),
    ];
    let steps = [
        line(0.0, 4.0, 1),
        line(10.0, 4.0, 2),
        ([14.0, 0.0], Some(([10.0, 0.0], -90.0)), 3, true),
        line(14.0, -6.0, 4),
        line(40.0, -6.0, 5),
        line(60.0, -10.0, 7),
    ];
    expect([-20.0, -15.0], &ops, &steps);
}

#[test]
fn comp_small_arc_41() {
    let ops = [
        g41(5.0),
        To([10.0, 0.0]),
        To([57.0, 0.0]),
        Ccw([60.0, 3.0], [57.0, 3.0]),
        To([60.0, 40.0]),
        To([0.0, 40.0]),
        G40,
        To([10.0, 20.0]),
    ];
    assert_eq!(fault(Rules::default(), [10.0, 20.0], &ops), Some((Fault::Interference, 3)));
    // Without the check the theoretical path is run (figure 4-7-3-26): the arc on the far side of its centre.
    let off = Rules { interference: false, ..Rules::default() };
    let (got, none) = run(off, [10.0, 20.0], &ops);
    assert_eq!(none, None);
    let Out::Move { to, .. } = got[2] else { panic!() };
    assert!(vector::distance(to, [55.0, 3.0]) < 1e-9);
}

#[test]
fn comp_arc_start_34() {
    let start = [g41(2.0), Cw([10.0, 10.0], [10.0, 0.0]), To([30.0, 10.0])];
    assert_eq!(fault(Rules::default(), [0.0, 0.0], &start), Some((Fault::StartOrCancelInArc, 1)));
    let cancel = [g41(2.0), To([10.0, 0.0]), To([20.0, 0.0]), G40, Ccw([20.0, 20.0], [20.0, 10.0])];
    assert_eq!(fault(Rules::default(), [0.0, 0.0], &cancel), Some((Fault::StartOrCancelInArc, 4)));
}

/// Steps below the least increment have no direction, one alone or so many that they lead somewhere.
#[test]
fn steps_below_the_least_increment_make_no_corner() {
    let ops = [
        g42(5.0),
        To([10.0, 0.0]),
        To([20.0, 0.0]),
        To([19.999_99, 0.0]),
        To([40.0, 0.0]),
        G40,
        To([50.0, 0.0]),
    ];
    let steps = [line(10.0, -5.0, 1), line(20.0, -5.0, 2), line(40.0, -5.0, 4), line(50.0, 0.0, 6)];
    expect([0.0, 0.0], &ops, &steps);
    let ops = [
        g42(5.0),
        To([10.0, 0.0]),
        Cw([20.0, 10.0], [20.0, 0.0]),
        To([20.0, 10.000_01]),
        To([20.0, 10.0]),
        To([40.0, 10.0]),
        G40,
        To([50.0, 10.0]),
    ];
    let steps = [
        line(15.0, 0.0, 1),
        round(20.0, 5.0, [20.0, 0.0], -90.0, 2),
        line(40.0, 5.0, 5),
        line(50.0, 10.0, 7),
    ];
    let rules = Rules { start_up: StartUp::A, ..Rules::default() };
    expect_with(rules, [10.0, -20.0], &ops, &steps, 1e-3);
    let mut ops = vec![g42(5.0), To([10.0, 0.0])];
    ops.extend((1..=30_000).map(|k| To([10.0 + f64::from(k) * 4e-4, 0.0])));
    ops.extend([To([22.0, 10.0]), G40, To([22.0, 20.0])]);
    let (got, fault) = run(Rules::default(), [0.0, 0.0], &ops);
    assert!(fault.is_none());
    let ends = got.iter().filter_map(|o| if let Out::Move { to, .. } = o { Some(*to) } else { None });
    let furthest = ends.fold(0.0_f64, |most, [x, y]| if y < 0.0 { most.max(x) } else { most });
    assert!((furthest - 27.0).abs() < 1e-3, "{furthest}");
}

#[test]
fn g10_tool_offsets() {
    let ops = [g41(6.5), To([0.0, 0.0]), To([0.0, 30.0]), To([20.0, 30.0]), G40, To([40.0, 40.0])];
    let steps = [line(-6.5, 0.0, 1), line(-6.5, 36.5, 2), line(20.0, 36.5, 3), line(40.0, 40.0, 5)];
    expect([-10.0, -10.0], &ops, &steps);
}

// ---- conformance/weihong

#[test]
fn weihong_reversal() {
    let rules = Rules { reversal: Reversal::Fault, long_start_up: false, ..Rules::default() };
    let ops = |y| [g41(3.0), To([10.0, 10.0]), To([20.0, 10.0]), G40, To([0.0, y])];
    assert_eq!(fault(rules, [0.0, 0.0], &ops(10.0)), Some((Fault::Reversal, 4)));
    let steps = [line(10.0, 13.0, 1), line(20.0, 13.0, 2), line(0.0, 0.0, 4)];
    expect_with(rules, [0.0, 0.0], &ops(0.0), &steps, 1e-9);
}

#[test]
fn weihong_slot_outline() {
    let ops = [
        g41(6.0),
        To([45.0, 15.0]),
        Cw([45.0, 65.0], [45.0, 40.0]),
        To([135.0, 65.0]),
        Cw([135.0, 15.0], [135.0, 40.0]),
        To([45.0, 15.0]),
        G40,
        To([0.0, 0.0]),
    ];
    let steps = [
        line(45.0, 9.0, 1),
        round(45.0, 71.0, [45.0, 40.0], -180.0, 2),
        line(135.0, 71.0, 3),
        round(135.0, 9.0, [135.0, 40.0], -180.0, 4),
        line(45.0, 9.0, 5),
        line(0.0, 0.0, 7),
    ];
    expect([0.0, 0.0], &ops, &steps);
}

#[test]
fn weihong_example_3() {
    let ops = [
        g41(7.0),
        To([40.0, 30.0]),
        To([40.0, 100.0]),
        Cw([60.0, 120.0], [60.0, 100.0]),
        To([100.0, 120.0]),
        To([100.0, 70.0]),
        To([140.0, 70.0]),
        To([140.0, 120.0]),
        To([210.0, 120.0]),
        To([210.0, 80.0]),
        Ccw([160.0, 30.0], [210.0, 30.0]),
        To([40.0, 30.0]),
        G40,
        To([0.0, 0.0]),
    ];
    let steps = [
        line(33.0, 30.0, 1),
        line(33.0, 100.0, 2),
        round(60.0, 127.0, [60.0, 100.0], -90.0, 3),
        line(107.0, 127.0, 4),
        line(107.0, 77.0, 5),
        line(133.0, 77.0, 6),
        line(133.0, 127.0, 7),
        line(217.0, 127.0, 8),
        line(217.0, 73.0, 9),
        piece(210.0, 73.0, 9),
        round(167.0, 30.0, [210.0, 30.0], 90.0, 10),
        piece(167.0, 23.0, 10),
        line(40.0, 23.0, 11),
        line(0.0, 0.0, 13),
    ];
    expect([0.0, 0.0], &ops, &steps);
}

// ---- 4.7.3 point 1: start-up

#[test]
fn start_up_inside_is_square_to_the_next_block() {
    for rules in [Rules::default(), type_b()] {
        let ops = [g41(2.0), To([10.0, 0.0]), To([10.0, 10.0]), To([0.0, 10.0])];
        expect_with(
            rules,
            [0.0, 0.0],
            &ops,
            &[line(8.0, 0.0, 1), line(8.0, 8.0, 2), line(0.0, 8.0, 3)],
            1e-9,
        );
    }
}

#[test]
fn type_b_line_to_arc() {
    // Obtuse (90°): the crossing of the tangents, a straight piece to the arc's start. The cancel mirrors it.
    let ops = [g41(2.0), To([0.0, 0.0]), Cw([-10.0, -10.0], [-10.0, 0.0]), G40, To([-10.0, 10.0])];
    let steps = [
        line(2.0, 2.0, 1),
        piece(2.0, 0.0, 1),
        round(-10.0, -12.0, [-10.0, 0.0], -90.0, 2),
        piece(-12.0, -12.0, 2),
        line(-10.0, 10.0, 4),
    ];
    expect_with(type_b(), [-20.0, 0.0], &ops, &steps, 1e-9);
}

#[test]
fn type_b_acute_goes_round_as_in_the_mode() {
    let ops = [g41(5.0), To([0.0, 0.0]), To([-40.0, -30.0]), G40, To([-26.0, 18.0])];
    let t = vector::unit([14.0, 48.0]).unwrap();
    let n = vector::left(t);
    let last = vector::along(vector::along([-40.0, -30.0], n, 5.0), t, -5.0);
    let steps = [
        line(5.0, 5.0, 1),
        piece(3.0 + 4.0, -4.0 + 3.0, 1),
        line(-37.0 - 4.0, -34.0 - 3.0, 2),
        piece(last[0], last[1], 2),
        line(-26.0, 18.0, 4),
    ];
    expect_with(type_b(), [-30.0, 0.0], &ops, &steps, 1e-9);
}

#[test]
fn type_b_needle_below_one_degree_is_square() {
    let (s, c) = (0.5_f64.to_radians().sin(), 0.5_f64.to_radians().cos());
    let ops = [g41(2.0), To([0.0, 0.0]), To([-100.0 * c, -100.0 * s])];
    let (got, _) = run(type_b(), [-30.0, 0.0], &ops);
    let Out::Move { to, .. } = got[0] else { panic!() };
    assert!(vector::distance(to, [2.0 * s, -2.0 * c]) < 1e-9);
    assert_eq!(got.len(), 2);
}

#[test]
fn start_up_without_movement_is_made_by_the_next_move() {
    let ops = [g41(2.0), Pass, To([10.0, 0.0]), To([10.0, 10.0])];
    expect([0.0, 0.0], &ops, &[line(8.0, 0.0, 2), line(8.0, 10.0, 3)]);
}

#[test]
fn start_up_shorter_than_the_radius_interferes() {
    let ops = [g41(5.0), To([4.0, 0.0]), To([4.0, 40.0])];
    assert_eq!(fault(Rules::default(), [0.0, 0.0], &ops), Some((Fault::Interference, 1)));
    let lax = Rules { long_start_up: false, ..Rules::default() };
    assert_eq!(fault(lax, [0.0, 0.0], &ops), None);
}

// ---- 4.7.3 point 2: the mode

const LEAD: [Op; 2] = [Op::Set(Some(Offset { side: Side::Left, radius: 2.0 })), To([0.0, 0.0])];

fn mode(rules: Rules, ops: &[Op], steps: &[Step]) {
    let all: Vec<_> = LEAD.iter().chain(ops).copied().collect();
    let start = [line(0.0, 2.0, 1)];
    let expected: Vec<_> = start.iter().chain(steps).copied().collect();
    expect_with(rules, [-20.0, 0.0], &all, &expected, 1e-9);
}

#[test]
fn outside_acute_line_line() {
    let t = [-0.5_f64.sqrt(), -0.5_f64.sqrt()];
    let v = vector::sub(vector::left(t), t);
    let steps = [
        line(12.0, 2.0, 2),
        piece(10.0 + 2.0 * v[0], 2.0 * v[1], 2),
        line(-10.0 + SQRT_2, -20.0 - SQRT_2, 3),
    ];
    mode(Rules::default(), &[To([10.0, 0.0]), To([-10.0, -20.0])], &steps);
}

#[test]
fn outside_line_arc_line_obtuse() {
    let ops = [To([20.0, 0.0]), Cw([10.0, -10.0], [10.0, 0.0]), To([10.0, 30.0])];
    // Line to arc at 90°, arc to line at 90°: tangents with straight pieces to the arc.
    let steps = [
        line(22.0, 2.0, 2),
        piece(22.0, 0.0, 2),
        round(10.0, -12.0, [10.0, 0.0], -90.0, 3),
        piece(8.0, -12.0, 3),
        line(8.0, 30.0, 4),
    ];
    mode(Rules::default(), &ops, &steps);
}

#[test]
fn outside_arc_arc_acute_has_four_vectors() {
    // Down at (20,-10), on up to the left: a turn of 135° to the right.
    let h = 10.0 * 0.5_f64.sqrt();
    let ops = [
        To([10.0, 0.0]),
        Cw([20.0, -10.0], [10.0, -10.0]),
        Cw([20.0 + h - h, -10.0 + h + h], [20.0 + h, -10.0 + h]),
    ];
    let steps = [
        line(10.0, 2.0, 2),
        round(22.0, -10.0, [10.0, -10.0], -90.0, 3),
        piece(22.0, -12.0, 3),
        piece(20.0, -10.0 - 2.0 * SQRT_2, 3),
        piece(20.0 - SQRT_2, -10.0 - SQRT_2, 3),
        round(20.0 - SQRT_2, -10.0 + 2.0 * h + SQRT_2, [20.0 + h, -10.0 + h], -90.0, 4),
    ];
    mode(Rules::default(), &ops, &steps);
}

#[test]
fn outside_with_arcs_rule() {
    let rules = Rules { outside: Outside::Arc, ..Rules::default() };
    let steps =
        [line(10.0, 2.0, 2), ([12.0, 0.0], Some(([10.0, 0.0], -90.0)), 2, true), line(12.0, -10.0, 3)];
    mode(rules, &[To([10.0, 0.0]), To([10.0, -10.0])], &steps);
}

#[test]
fn inside_corners_of_lines_and_arcs() {
    // A circle of 7 about (10,4) run counter-clockwise below the line y = 0, the tool outside it on 9.
    let ops = [
        g42(2.0),
        To([0.0, 0.0]),
        To([10.0 - 33.0_f64.sqrt(), 0.0]),
        Ccw([10.0 + 33.0_f64.sqrt(), 0.0], [10.0, 4.0]),
        To([40.0, 0.0]),
    ];
    let x = (81.0_f64 - 36.0).sqrt();
    let sweep = 2.0 * (x / 6.0).atan();
    let steps = [
        line(0.0, -2.0, 1),
        line(10.0 - x, -2.0, 2),
        round(10.0 + x, -2.0, [10.0, 4.0], sweep.to_degrees(), 3),
        line(40.0, -2.0, 4),
    ];
    expect([-20.0, 0.0], &ops, &steps);
}

#[test]
fn collinear_and_tangent_joints_have_no_pieces() {
    let d = 1e-9;
    let ops = [
        To([10.0, 0.0]),
        To([20.0, d]),
        Cw([30.0, -10.0], [20.0, -10.0 + d]),
        Ccw([40.0, -20.0], [40.0, -10.0]),
    ];
    let (got, fault) = run(Rules::default(), [-20.0, 0.0], &[&LEAD[..], &ops].concat());
    assert_eq!(fault, None);
    assert_eq!(got.len(), 5);
    assert!(got.iter().all(|o| matches!(o, Out::Move { inserted: false, .. })));
}

#[test]
fn exactly_back_goes_round_the_end() {
    let steps = [line(12.0, 2.0, 2), piece(12.0, -2.0, 2), line(-5.0, -2.0, 3)];
    mode(Rules::default(), &[To([10.0, 0.0]), To([-5.0, 0.0])], &steps);
}

#[test]
fn cusps_are_told_by_their_curvature() {
    // The arc leaves below the line: round the tip.
    let ops = [To([10.0, 0.0]), Ccw([5.0, -5.0], [10.0, -5.0])];
    let steps = [
        line(12.0, 2.0, 2),
        piece(12.0, -2.0, 2),
        piece(10.0, -2.0, 2),
        round(7.0, -5.0, [10.0, -5.0], 90.0, 3),
    ];
    mode(Rules::default(), &ops, &steps);
    // It leaves above: into the wedge as far as the tool goes.
    let x = 40.0_f64.sqrt();
    let taken = (x / 3.0).atan().to_degrees();
    let ops = [To([10.0, 0.0]), Cw([10.0, 10.0], [10.0, 5.0])];
    let steps = [line(10.0 - x, 2.0, 2), round(10.0, 12.0, [10.0, 5.0], taken - 180.0, 3)];
    mode(Rules::default(), &ops, &steps);
}

// ---- 4.7.3 point 3: no crossing

#[test]
fn line_and_arc_without_crossing() {
    // The line touches a small circle's inside: the tool of radius 2 fits the circle of 3 but cannot get there.
    let ops = [
        g41(2.9),
        To([0.0, 0.0]),
        To([10.0, 0.0]),
        Ccw([10.0, 0.0], [10.0 - 3.0 * 0.999_f64.sqrt(), 3.0 * 0.001_f64.sqrt()]),
        To([10.0, -30.0]),
    ];
    let f = fault(Rules::default(), [-20.0, 0.0], &ops);
    assert!(matches!(f, Some((Fault::NoIntersection | Fault::Interference, _))), "{f:?}");
}

#[test]
fn arc_of_the_tool_radius_is_38() {
    let ops = [g41(3.0), To([0.0, 0.0]), To([57.0, 0.0]), Ccw([60.0, 3.0], [57.0, 3.0]), To([60.0, 40.0])];
    assert_eq!(fault(Rules::default(), [-20.0, 0.0], &ops), Some((Fault::ArcCenterOvercut, 3)));
}

// ---- 4.7.3 point 5: change of side

#[test]
fn change_of_side_line_line_crosses() {
    // Left of +X, then right of −Y: y = 2 and x = 8 cross at (8,2).
    let ops = [To([10.0, 0.0]), g42(2.0), To([10.0, -20.0]), To([30.0, -20.0])];
    let steps = [line(8.0, 2.0, 2), line(8.0, -22.0, 4), line(30.0, -22.0, 5)];
    mode(Rules::default(), &ops, &steps);
}

#[test]
fn change_of_side_straight_on_is_square_to_the_next() {
    let ops = [To([10.0, 0.0]), g42(2.0), To([30.0, 0.0]), To([30.0, 20.0])];
    let steps = [line(10.0, -2.0, 2), line(32.0, -2.0, 4), line(32.0, 20.0, 5)];
    mode(Rules::default(), &ops, &steps);
}

#[test]
fn change_of_side_arc_arc_without_crossing() {
    // An S of two half circles: from inside the first to inside the second.
    let ops = [To([10.0, 0.0]), Ccw([10.0, 20.0], [10.0, 10.0]), g42(2.0), Cw([10.0, 40.0], [10.0, 30.0])];
    let steps = [
        line(10.0, 2.0, 2),
        round(10.0, 18.0, [10.0, 10.0], 180.0, 3),
        piece(10.0, 22.0, 3),
        round(10.0, 38.0, [10.0, 30.0], -180.0, 5),
    ];
    mode(Rules::default(), &ops, &steps);
}

#[test]
fn full_circle_with_changes_of_side() {
    // 4.7.3 point 5 vi: N5 G01 G42, N6 G41 G02 full circle, N7 G42 G01.
    let ops = [
        g42(20.0),
        To([0.0, 0.0]),
        To([500.0, -700.0]),
        g41(20.0),
        Cw([500.0, -700.0], [500.0, -1200.0]),
        g42(20.0),
        To([1000.0, 0.0]),
    ];
    assert_eq!(fault(Rules::default(), [-100.0, 0.0], &ops), Some((Fault::Interference, 4)));
    let rules = Rules { over_turn: OverTurn::Shorten, ..Rules::default() };
    let (got, none) = run(rules, [-100.0, 0.0], &ops);
    assert_eq!(none, None);
    let Out::Move { to: p1, .. } = got[1] else { panic!() };
    let Out::Move { to: p2, shape: Shape::Arc { sweep, .. }, .. } = got[2] else { panic!() };
    assert!(sweep < 0.0 && sweep > -FRAC_PI_2, "{sweep}");
    assert!((p1[0] + p2[0] - 1000.0).abs() < 1e-6 && p1[0] < p2[0]);
}

#[test]
fn negative_radius_changes_sides() {
    let ops = |o| [o, To([0.0, 0.0]), To([10.0, 0.0]), To([10.0, 10.0])];
    assert_eq!(
        run(Rules::default(), [-9.0, 0.0], &ops(g41(-2.0))),
        run(Rules::default(), [-9.0, 0.0], &ops(g42(2.0)))
    );
}

#[test]
fn radius_zero_follows_the_program() {
    let ops = [
        g41(0.0),
        To([0.0, 0.0]),
        To([10.0, 0.0]),
        Ccw([10.0, 4.0], [10.0, 2.0]),
        To([3.0, 3.0]),
        G40,
        To([0.0, 9.0]),
    ];
    let steps = [
        line(0.0, 0.0, 1),
        line(10.0, 0.0, 2),
        round(10.0, 4.0, [10.0, 2.0], 180.0, 3),
        line(3.0, 3.0, 4),
        line(0.0, 9.0, 6),
    ];
    expect([-5.0, 0.0], &ops, &steps);
}

// ---- 4.7.3 point 6: temporary cancel

#[test]
fn temporary_cancel_and_restart() {
    let ops = [
        To([10.0, 0.0]),
        Suspend,
        To([20.0, 20.0]), // to the intermediate point, vector 0
        Pass,             // the reference point return
        To([30.0, 20.0]), // start-up again
        To([30.0, 40.0]),
    ];
    let steps = [line(10.0, 2.0, 2), line(20.0, 20.0, 4), line(28.0, 20.0, 6), line(28.0, 40.0, 7)];
    mode(Rules::default(), &ops, &steps);
}

// ---- 4.7.3 point 7: G41/G42 given again

#[test]
fn restated_side_ends_square() {
    let ops = [To([10.0, 0.0]), Flush, To([10.0, 20.0]), To([-10.0, 20.0])];
    let steps = [line(10.0, 2.0, 2), line(8.0, 18.0, 4), line(-10.0, 18.0, 5)];
    mode(Rules::default(), &ops, &steps);
}

// ---- 4.7.3 point 8: blocks without movement

#[test]
fn ten_idle_blocks_change_nothing_and_eleven_are_42() {
    let mut ops = vec![To([10.0, 0.0])];
    ops.extend([Pass; 10]);
    ops.push(To([10.0, 20.0]));
    mode(Rules::default(), &ops, &[line(8.0, 2.0, 2), line(8.0, 20.0, 13)]);
    ops.insert(1, Pass);
    let all = [&LEAD[..], &ops].concat();
    assert_eq!(fault(Rules::default(), [-20.0, 0.0], &all), Some((Fault::TooManyIdleBlocks, 13)));
}

#[test]
fn a_control_that_sees_one_block_ends_square_before_two() {
    let rules = Rules { blind_from: Some(2), ..Rules::default() };
    let ops = [To([10.0, 0.0]), Pass, Pass, To([10.0, 20.0])];
    mode(rules, &ops, &[line(10.0, 2.0, 2), line(8.0, 20.0, 5)]);
    mode(rules, &[To([10.0, 0.0]), Pass, To([10.0, 20.0])], &[line(8.0, 2.0, 2), line(8.0, 20.0, 4)]);
}

#[test]
fn what_starts_up_and_is_handed_out_leads_to_the_next_start() {
    // Square to itself at (0, 2), then to where a line up begins.
    let ops = [Flush, To([0.0, 20.0])];
    mode(Rules::default(), &ops, &[piece(-2.0, 0.0, 1), line(-2.0, 20.0, 3)]);
    // So many blocks without movement that no more is read ahead change nothing there.
    let rules = Rules { blind_from: Some(2), ..Rules::default() };
    let all = [&LEAD[..], &[Pass, Pass, To([0.0, 20.0])]].concat();
    expect_with(rules, [-20.0, 0.0], &all, &[line(-2.0, 0.0, 1), line(-2.0, 20.0, 4)], 1e-9);
}

#[test]
fn zero_move_ends_square() {
    let ops = [To([10.0, 0.0]), To([10.0, 0.0]), To([10.0, 20.0])];
    mode(Rules::default(), &ops, &[line(10.0, 2.0, 2), line(8.0, 20.0, 4)]);
    let idle = Rules { zero_move: ZeroMove::Idle, ..Rules::default() };
    mode(idle, &ops, &[line(8.0, 2.0, 2), line(8.0, 20.0, 4)]);
}

#[test]
fn cancel_alone_ends_square() {
    let ops = [To([10.0, 0.0]), Flush, G40, Pass, To([10.0, -20.0])];
    mode(type_b(), &ops, &[line(10.0, 2.0, 2), line(10.0, -20.0, 6)]);
    // With the move, type B goes round.
    mode(type_b(), &[To([10.0, 0.0]), G40, To([10.0, -20.0])], &[line(12.0, 2.0, 2), line(10.0, -20.0, 4)]);
}

// ---- 4.7.3 point 10: interference

#[test]
fn groove_narrower_than_the_tool() {
    let groove = |w: f64| {
        [To([10.0, 0.0]), To([10.0, -9.0]), To([10.0 + w, -9.0]), To([10.0 + w, 0.0]), To([40.0, 0.0])]
    };
    let all = |w| [&LEAD[..], &groove(w)].concat();
    assert_eq!(fault(Rules::default(), [-20.0, 0.0], &all(3.9)), Some((Fault::Interference, 4)));
    assert_eq!(fault(Rules::default(), [-20.0, 0.0], &all(4.0)), None);
}

#[test]
fn linear_step_smaller_than_the_radius_passes() {
    // Point 12 d 3: a straight step is machined without alarm.
    let up = [To([10.0, 0.0]), To([10.0, 1.0]), To([30.0, 1.0])];
    mode(Rules::default(), &up, &[line(8.0, 2.0, 2), line(8.0, 3.0, 3), line(30.0, 3.0, 4)]);
    let down = [To([10.0, 0.0]), To([10.0, -1.0]), To([30.0, -1.0])];
    mode(Rules::default(), &down, &[line(12.0, 2.0, 2), line(12.0, 1.0, 3), line(30.0, 1.0, 4)]);
}

#[test]
fn vector_pairs_are_left_out() {
    // An acute corner carried on past the crossing that ends the short block after it.
    let t = [-0.6, -0.8];
    let p = [10.0 + t[0], t[1]];
    // From the short block's end a sharp left turn: its inside crossing lies before the block.
    let q = vector::along(p, [0.8, -0.6], 40.0);
    let r = vector::along(p, [0.95, -0.312_249_899_919_919_9], 40.0);
    for end in [q, r] {
        let all = [&LEAD[..], &[To([10.0, 0.0]), To(p), To(end)]].concat();
        let (got, fault) = run(Rules::default(), [-20.0, 0.0], &all);
        assert_eq!(fault, None, "{got:?}");
    }
}

// ---- 4.7.3 point 12: D in the mode

#[test]
fn new_radius_is_reached_at_the_end_of_its_block() {
    let ops = [To([10.0, 0.0]), g41(3.0), To([10.0, 20.0]), To([-10.0, 20.0])];
    let steps = [line(8.0, 2.0, 2), line(7.0, 17.0, 4), line(-10.0, 17.0, 5)];
    mode(Rules::default(), &ops, &steps);
}

// ---- streaming

#[test]
fn a_barrier_ends_square_and_goes_on_round_the_corner() {
    let ops = [To([10.0, 0.0]), Flush, Pass, To([10.0, -20.0]), To([30.0, -20.0])];
    let steps = [line(10.0, 2.0, 2), piece(12.0, 2.0, 2), line(12.0, -18.0, 5), line(30.0, -18.0, 6)];
    mode(Rules::default(), &ops, &steps);
}

#[test]
fn two_moves_wait() {
    let mut stage = Compensator::new(Rules::default());
    stage.set(Some(Offset { side: Side::Left, radius: 1.0 }));
    let mut from = [0.0, 0.0];
    for i in 0..100_usize {
        let to = [from[0] + 5.0, if i % 2 == 0 { 0.0 } else { 3.0 }];
        let mut n = 0;
        stage
            .push(PlaneMove { from, to, shape: Shape::Line }, i, &mut |o| {
                let Out::Move { payload, .. } = o else { panic!() };
                assert!(payload + 2 == i);
                n += 1;
            })
            .unwrap();
        assert!(n >= usize::from(i > 1));
        from = to;
    }
    assert!(stage.in_mode());
}
