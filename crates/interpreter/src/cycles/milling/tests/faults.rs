//! Every alarm of the cycles, one fault at a time (alarms 185 to 195).

use super::super::{CircleFinish, CycleFault, Plan, Problem, RectFinish, RectPocket, RoundPocket, Side};
use super::{circle_finish_example, rect_example, rect_finish_example, round_example};

fn number(problem: Problem) -> u32 {
    match problem {
        Problem::StepTooSmall => 185,
        Problem::StepTooLarge => 186,
        Problem::ToolTooLarge => 187,
        Problem::CornerTooLarge => 188,
        Problem::CornerTooSmall => 189,
        Problem::GapMissing => 190,
        Problem::FirstDepthMissing => 191,
        Problem::DepthMissing => 192,
        Problem::SizeMissing => 193,
        Problem::SecondSizeMissing => 194,
        Problem::ToolMissing => 195,
        Problem::BottomNotBelowR => 49,
        Problem::OutOfRange => 0,
        Problem::TooManyMoves => 1,
    }
}

fn raises(what: &str, plan: Result<Plan, CycleFault>, want: u32, letter: u8) {
    let fault = plan.err().unwrap_or_else(|| panic!("{what} is accepted"));
    assert_eq!((number(fault.problem), fault.letter.unwrap_or(0) as char), (want, letter as char), "{what}");
}

fn round(change: impl Fn(&mut RoundPocket)) -> Result<Plan, CycleFault> {
    let mut words = round_example();
    change(&mut words);
    words.plan()
}

fn rect(change: impl Fn(&mut RectPocket)) -> Result<Plan, CycleFault> {
    let mut words = rect_example();
    change(&mut words);
    words.plan()
}

fn circle_finish(side: Side, change: impl Fn(&mut CircleFinish)) -> Result<Plan, CycleFault> {
    let mut words = circle_finish_example(side);
    change(&mut words);
    words.plan()
}

fn rect_finish(side: Side, change: impl Fn(&mut RectFinish)) -> Result<Plan, CycleFault> {
    let mut words = rect_finish_example(side);
    change(&mut words);
    words.plan()
}

#[test]
fn round_pocket() {
    for (want, letter, word) in
        [(193, b'I', None), (193, b'I', Some(0.0)), (187, b'D', Some(9.9)), (187, b'D', Some(-50.0))]
    {
        raises(&format!("G22 I{word:?}"), round(|w| w.radius = word), want, letter);
    }
    for (want, word) in [(185, None), (185, Some(0.0)), (185, Some(-1.0)), (186, Some(10.1))] {
        raises(&format!("G22 L{word:?}"), round(|w| w.roughing.step = word), want, b'L');
    }
    for word in [None, Some(0.0), Some(-1.0)] {
        raises(&format!("G22 W{word:?}"), round(|w| w.roughing.first_depth = word), 191, b'W');
        raises(&format!("G22 Q{word:?}"), round(|w| w.roughing.depth = word), 192, b'Q');
        raises(&format!("G22 V{word:?}"), round(|w| w.roughing.gap = word), 190, b'V');
        raises(&format!("G22 D{word:?}"), round(|w| w.tool_radius = word), 195, b'D');
    }
    // Helix 1.5·5 beyond 12 − 5, and at the limit.
    raises("G22 P269", round(|w| w.radius = Some(12.0)), 187, b'D');
    assert!(round(|w| w.radius = Some(12.5)).is_ok());
    raises("G22 Z", round(|w| w.bottom = 5.0), 49, b'Z');
    raises("P269 = 0", round(|w| w.roughing.helix_factor = 0.0), 0, 0);
    raises("G22 X", round(|w| w.center[0] = 1e9), 0, b'X');
    raises("G22 I", round(|w| w.radius = Some(f64::NAN)), 0, b'I');
    raises("G22 Q small", round(|w| w.roughing.depth = Some(1e-3)), 1, b'Q');
    raises("G22 L small", round(|w| w.roughing.step = Some(1e-4)), 1, b'L');
    raises("G22 W deep", round(|w| (w.roughing.first_depth, w.bottom) = (Some(1e7), -1e7)), 1, b'W');
}

#[test]
fn rect_pocket() {
    for (want, letter, word) in
        [(193, b'I', None), (193, b'I', Some(0.0)), (187, b'D', Some(9.9)), (187, b'D', Some(-70.0))]
    {
        raises(&format!("G33 I{word:?}"), rect(|w| (w.sizes[0], w.corner) = (word, None)), want, letter);
    }
    for (want, letter, word) in
        [(194, b'J', None), (194, b'J', Some(0.0)), (187, b'D', Some(9.9)), (187, b'D', Some(24.9))]
    {
        raises(&format!("G33 J{word:?}"), rect(|w| (w.sizes[1], w.corner) = (word, None)), want, letter);
    }
    for (want, word) in [(185, None), (185, Some(0.0)), (186, Some(10.1)), (186, Some(-10.1))] {
        raises(&format!("G33 L{word:?}"), rect(|w| w.roughing.step = word), want, b'L');
    }
    assert!(rect(|w| w.roughing.step = Some(-8.0)).is_ok(), "the sign of L is left aside");
    for word in [None, Some(0.0), Some(-1.0)] {
        raises(&format!("G33 W{word:?}"), rect(|w| w.roughing.first_depth = word), 191, b'W');
        raises(&format!("G33 Q{word:?}"), rect(|w| w.roughing.depth = word), 192, b'Q');
        raises(&format!("G33 V{word:?}"), rect(|w| w.roughing.gap = word), 190, b'V');
        raises(&format!("G33 D{word:?}"), rect(|w| w.tool_radius = word), 195, b'D');
    }
    raises("G33 U26", rect(|w| w.corner = Some(26.0)), 188, b'U');
    raises("G33 U-26", rect(|w| w.corner = Some(-26.0)), 188, b'U');
    raises("G33 U26 of I", rect(|w| (w.sizes[0], w.corner) = (Some(51.0), Some(25.6))), 188, b'U');
    raises("G33 U4", rect(|w| w.corner = Some(4.0)), 189, b'U');
    assert!(rect(|w| w.corner = Some(0.0)).is_ok() && rect(|w| w.corner = None).is_ok());
    assert!(rect(|w| w.sizes = [Some(25.0), Some(25.0)]).is_ok());
}

#[test]
fn circle_finishes() {
    for side in [Side::Inside, Side::Outside] {
        for word in [None, Some(0.0)] {
            raises(&format!("{side:?} I{word:?}"), circle_finish(side, |w| w.radius = word), 193, b'I');
            raises(&format!("{side:?} D{word:?}"), circle_finish(side, |w| w.tool_radius = word), 195, b'D');
        }
        raises("no J", circle_finish(side, |w| w.start = None), 194, b'J');
        assert!(circle_finish(side, |w| (w.radius, w.start) = (Some(-50.0), w.start.map(|j| -j))).is_ok());
    }
    assert!(circle_finish(Side::Inside, |w| w.start = Some(0.0)).is_ok());
    assert!(circle_finish(Side::Inside, |w| w.start = Some(45.0)).is_ok());
    raises("G24 J46", circle_finish(Side::Inside, |w| w.start = Some(45.1)), 187, b'D');
    raises(
        "G24 I4",
        circle_finish(Side::Inside, |w| (w.radius, w.start) = (Some(4.0), Some(0.0))),
        187,
        b'D',
    );
    raises("G26 J0", circle_finish(Side::Outside, |w| w.start = Some(0.0)), 194, b'J');
    raises("G26 J4", circle_finish(Side::Outside, |w| w.start = Some(4.9)), 187, b'D');
    assert!(circle_finish(Side::Outside, |w| w.start = Some(5.0)).is_ok());
}

#[test]
fn rect_finishes() {
    for side in [Side::Inside, Side::Outside] {
        for word in [None, Some(0.0)] {
            raises(&format!("{side:?} I{word:?}"), rect_finish(side, |w| w.sizes[0] = word), 193, b'I');
            raises(&format!("{side:?} J{word:?}"), rect_finish(side, |w| w.sizes[1] = word), 194, b'J');
            raises(&format!("{side:?} D{word:?}"), rect_finish(side, |w| w.tool_radius = word), 195, b'D');
            raises(&format!("{side:?} L{word:?}"), rect_finish(side, |w| w.distance = word), 185, b'L');
        }
        raises("L4", rect_finish(side, |w| w.distance = Some(4.9)), 185, b'L');
        raises("U26", rect_finish(side, |w| w.corner = Some(25.1)), 188, b'U');
        raises("U4", rect_finish(side, |w| w.corner = Some(-4.9)), 189, b'U');
        assert!(rect_finish(side, |w| w.sizes = [Some(-80.0), Some(-50.0)]).is_ok());
    }
    raises("G35 L > J", rect_finish(Side::Inside, |w| w.distance = Some(50.1)), 186, b'L');
    raises(
        "G35 L > I",
        rect_finish(Side::Inside, |w| (w.sizes, w.distance) = ([Some(50.0), Some(80.0)], Some(50.1))),
        186,
        b'L',
    );
    raises(
        "G35 start in the far side",
        rect_finish(Side::Inside, |w| (w.sizes, w.distance) = ([Some(50.0), Some(80.0)], Some(45.1))),
        186,
        b'L',
    );
    raises("G35 L-30", rect_finish(Side::Inside, |w| w.distance = Some(-30.0)), 185, b'L');
    raises(
        "G35 J9",
        rect_finish(Side::Inside, |w| (w.sizes[1], w.distance, w.corner) = (Some(9.9), Some(5.0), None)),
        187,
        b'D',
    );
    raises(
        "G35 I9",
        rect_finish(Side::Inside, |w| (w.sizes[0], w.distance, w.corner) = (Some(9.9), Some(5.0), None)),
        187,
        b'D',
    );
    assert!(rect_finish(Side::Outside, |w| w.distance = Some(-30.0)).is_ok(), "the sign of L is left aside");
    assert!(rect_finish(Side::Outside, |w| w.distance = Some(500.0)).is_ok());
}
