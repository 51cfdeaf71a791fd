//! Compensation that looks one move ahead: expected values worked out by hand from the rule of each corner.

use super::*;
use ferrocut_geometry::vector;
use std::f64::consts::{PI, SQRT_2};

/// Runs a program with the payload of each block's index; G40 hands out what waits first.
fn run(start: [f64; 2], ops: &[Op]) -> (Vec<Out<usize>>, Option<FaultAt<usize>>) {
    let mut stage = OneAhead::new();
    let mut steps = Vec::new();
    let mut at = start;
    for (i, op) in ops.iter().enumerate() {
        let mut out = |o| steps.push(o);
        let done = match *op {
            Op::Set(None) => {
                let done = stage.finish(&mut out);
                stage.set(None);
                done
            }
            Op::Set(offset) => {
                stage.set(offset);
                Ok(())
            }
            Op::To(to) => {
                let m = PlaneMove { from: at, to, shape: Shape::Line };
                at = to;
                stage.push(m, i, &mut out)
            }
            Op::Ccw(to, center) | Op::Cw(to, center) => {
                let m = arc(at, to, center, if matches!(op, Op::Ccw(..)) { 1.0 } else { -1.0 });
                at = to;
                stage.push(m, i, &mut out)
            }
            Op::Pass => stage.pass(i, &mut out),
            Op::Flush => stage.flush(&mut out),
            Op::G39 | Op::Suspend => continue,
        };
        if let Err(fault) = done {
            return (steps, Some(fault));
        }
    }
    let fault = stage.flush(&mut |o| steps.push(o)).err();
    (steps, fault)
}

/// Steps in short lines: a letter of what came out, the end, and centre and degrees of an arc.
fn lines(start: [f64; 2], ops: &[Op]) -> Vec<String> {
    let (steps, fault) = run(start, ops);
    assert_eq!(fault, None);
    steps.iter().map(line).collect()
}

fn line(out: &Out<usize>) -> String {
    let round = |v: f64| (v * 1e4).round() / 1e4 + 0.0;
    let (letter, to, shape, block) = match out {
        Out::Move { to, shape, payload, .. } => ("move", to, shape, payload),
        Out::Corner { to, shape, payload } => ("corner", to, shape, payload),
        Out::Other(block) => return format!("other of {block}"),
    };
    let end = format!("{letter} of {block} to {} {}", round(to[0]), round(to[1]));
    match shape {
        Shape::Line => end,
        Shape::Arc { center, sweep } => {
            let [a, b] = center.map(round);
            format!("{end} about {a} {b} by {}", round(sweep.to_degrees()))
        }
    }
}

fn fault(start: [f64; 2], ops: &[Op]) -> Option<(Fault, usize)> {
    run(start, ops).1.map(|fault| (fault.fault, fault.at))
}

use Op::{Ccw, Cw, Flush, Pass, To};

#[test]
fn an_outside_corner_is_an_arc_and_an_inside_one_the_crossing() {
    let ops = [
        g41(2.0),
        To([0.0, 0.0]),
        To([0.0, 20.0]),
        To([20.0, 20.0]),
        To([20.0, 40.0]),
        G40,
        To([60.0, 50.0]),
    ];
    let expected = [
        // The entry runs along +X and the next block up: a turn to the left is inside.
        "move of 1 to -2 2",
        "move of 2 to -2 20",
        "corner of 3 to 0 22 about 0 20 by -90",
        "move of 3 to 18 22",
        "move of 4 to 18 40",
        "move of 6 to 60 50",
    ];
    assert_eq!(lines([-20.0, 0.0], &ops), expected);
}

#[test]
fn nearly_straight_goes_on_without_an_arc() {
    // 0.04 rad to the right, away from the tool: below the 0.05 rad of the language.
    let turn = 0.04f64;
    let end = [10.0 + 10.0 * turn.cos(), -10.0 * turn.sin()];
    let ops = [g41(1.0), To([0.0, 0.0]), To([10.0, 0.0]), To(end)];
    let made = lines([-5.0, 0.0], &ops);
    assert_eq!(made.len(), 3, "{made:?}");
    assert_eq!(made[1], "move of 2 to 10 1");
    let ops = [g41(1.0), To([0.0, 0.0]), To([10.0, 0.0]), To([20.0, -0.6])];
    assert!(lines([-5.0, 0.0], &ops)[2].starts_with("corner of 3"));
}

#[test]
fn lines_and_arcs_meet_where_their_tracks_cross() {
    // Tool inside a circle of 10 about the origin, radius 2: its track is a circle of 8. The line x = 6 upwards
    // begins where the track of the arc meets x = 4 on the way in.
    let y = -(8.0f64 * 8.0 - 4.0 * 4.0).sqrt();
    let ops = [g41(2.0), To([-10.0, 0.0]), Ccw([6.0, -8.0], [0.0, 0.0]), To([6.0, 8.0])];
    let (made, fault) = run([-10.0, 20.0], &ops);
    assert_eq!(fault, None);
    let Out::Move { to, .. } = made[1] else { panic!("{made:?}") };
    assert!(vector::distance(to, [4.0, y]) < 1e-9, "{to:?}");
    // And from the line into the circle: up along x = 6, then about the circle.
    let ops = [g41(2.0), To([6.0, -8.0]), To([6.0, 8.0]), Ccw([-10.0, 0.0], [0.0, 0.0])];
    let (made, fault) = run([6.0, -30.0], &ops);
    assert_eq!(fault, None);
    let Out::Move { to, .. } = made[1] else { panic!("{made:?}") };
    assert!(vector::distance(to, [4.0, -y]) < 1e-9, "{to:?}");
}

#[test]
fn two_arcs_meet_where_their_tracks_cross() {
    // Half circles of 5 side by side, the tool (radius 1) on their outside: tracks of 6 about (5, 0) and (15, 0)
    // cross above x = 10.
    let ops = [g41(1.0), To([0.0, 0.0]), Cw([10.0, 0.0], [5.0, 0.0]), Cw([20.0, 0.0], [15.0, 0.0])];
    let made = lines([0.0, -10.0], &ops);
    let y = (36.0f64 - 25.0).sqrt();
    let (sweep_a, sweep_b) = (PI - (5.0f64 / 6.0).acos(), PI - (5.0f64 / 6.0).acos());
    let expected = [
        "move of 1 to -1 0".to_owned(),
        format!("move of 2 to 10 {:.4} about 5 0 by {:.4}", y, -sweep_a.to_degrees()),
        format!("move of 3 to 21 0 about 15 0 by {:.4}", -sweep_b.to_degrees()),
    ];
    assert_eq!(made, expected);
}

#[test]
fn an_entry_arc_is_tangent_at_its_end() {
    // The quarter about (0, 10) from (10, 10) to (0, 20), tool 2 inside: it ends at (0, 18) with a horizontal
    // direction, on the circle through (10, 10) whose centre lies on x = 0: c = (10² + 10² - 18²…) from
    // 10² + (10 − c)² = (18 − c)², c = 124/16 = 7.75.
    let ops = [g41(2.0), Ccw([0.0, 20.0], [0.0, 10.0])];
    let made = lines([10.0, 10.0], &ops);
    let sweep = (10.0f64).atan2(2.25).to_degrees();
    assert_eq!(made, [format!("move of 1 to 0 18 about 0 7.75 by {:.4}", sweep)]);
}

#[test]
fn what_stands_still_waits_for_the_corner() {
    let ops = [g41(2.0), To([0.0, 0.0]), To([20.0, 0.0]), Pass, To([20.0, 0.0]), Pass, To([20.0, 30.0])];
    let made = lines([-20.0, 0.0], &ops);
    let expected = [
        "move of 1 to 0 2",
        "move of 2 to 18 2",
        "other of 3",
        // A move along the tool axis: it stands where the corner is.
        "move of 4 to 18 2",
        "other of 5",
        "move of 6 to 18 30",
    ];
    assert_eq!(made, expected);
    // Handed out before, it stays where it was, and the corner is not seen.
    let ops = [g41(2.0), To([0.0, 0.0]), To([20.0, 0.0]), Flush, To([20.0, 30.0])];
    let expected = ["move of 1 to 0 2", "move of 2 to 20 2", "move of 4 to 18 30"];
    assert_eq!(lines([-20.0, 0.0], &ops), expected);
}

#[test]
fn back_by_half_a_turn_goes_round() {
    let ops = [g42(1.0), To([0.0, 0.0]), To([10.0, 0.0]), To([0.0, 0.0])];
    let expected = [
        "move of 1 to 0 -1",
        "move of 2 to 10 -1",
        "corner of 3 to 10 1 about 10 0 by 180",
        "move of 3 to 0 1",
    ];
    assert_eq!(lines([-5.0, 0.0], &ops), expected);
}

#[test]
fn faults_are_those_of_the_language() {
    assert_eq!(fault([0.0, 0.0], &[g41(5.0), To([5.0, 0.0])]), Some((Fault::EntryTooShort, 1)));
    assert_eq!(fault([0.0, 0.0], &[g41(5.0), To([0.0, 0.0])]), Some((Fault::EntryTooShort, 1)));
    let small = [g41(5.0), To([20.0, 0.0]), Ccw([20.0, 8.0], [20.0, 4.0])];
    assert_eq!(fault([0.0, 0.0], &small), Some((Fault::ArcTooSmall, 2)));
    // A slot narrower than the tool: the short floor would be run backwards.
    let slot = [g41(5.0), To([20.0, 0.0]), To([20.0, -30.0]), To([24.0, -30.0]), To([24.0, 0.0])];
    assert_eq!(fault([0.0, 0.0], &slot), Some((Fault::Interference, 4)));
    let out = [g41(2.0), To([20.0, 0.0]), G40, Cw([20.0, 20.0], [20.0, 10.0])];
    assert_eq!(fault([0.0, 0.0], &out), Some((Fault::ArcAfterCancel, 3)));
    // The line passes the circle of the tool.
    let far = [g41(2.0), To([-10.0, 0.0]), Ccw([0.0, -10.0], [0.0, 0.0]), To([-SQRT_2, -9.0])];
    assert!(matches!(fault([-10.0, 20.0], &far), Some((Fault::NoIntersection | Fault::Interference, 3))));
    let endless = [g41(2.0), To([f64::NAN, 0.0])];
    assert_eq!(fault([0.0, 0.0], &endless), Some((Fault::NotFinite, 1)));
}

#[test]
fn a_radius_of_0_changes_nothing() {
    let ops = [g41(0.0), To([1.0, 0.0]), Ccw([1.0, 4.0], [1.0, 2.0]), G40, Cw([1.0, 0.0], [1.0, 2.0])];
    let made = lines([0.0, 0.0], &ops);
    assert_eq!(made[0], "move of 1 to 1 0");
    assert_eq!(made.len(), 3);
}
