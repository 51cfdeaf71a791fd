//! Back along the path while a program is held, and forward again.

use crate::common::{cnc, ended, machine};
use ferrocut_controller::{Cnc, DryRun, Interruption, JogSpeed, JogWay, State};
use ferrocut_geometry::{Axis, Position};
use ferrocut_machine::Smoothing;

const ALONG_X: &str = "G90 G1 X30 F3000\nX60\nM8\nX100\nM30\n";
const CORNERS: &str = "G90 G1 X10 F3000\nX20 Y10\nG2 X30 Y0 R10\nG1 X40\nX40 Y30\nG0 X0 Y0\nM30\n";

fn x(cnc: &mut Cnc) -> f64 {
    cnc.tick().position[Axis::X]
}

/// Runs until X is beyond a place, and holds there; where it then rests.
fn hold_beyond(cnc: &mut Cnc, place: f64) -> f64 {
    cnc.cycle_start();
    while x(cnc) < place {}
    cnc.feed_hold();
    rest(cnc)[Axis::X]
}

/// Goes on until the axes stand.
fn rest(cnc: &mut Cnc) -> Position {
    let mut before = cnc.tick().position;
    let mut still = 0;
    for _ in 0..200_000 {
        let tick = cnc.tick();
        still = if tick.position == before { still + 1 } else { 0 };
        before = tick.position;
        if still > 60 {
            return before;
        }
    }
    panic!("never at rest");
}

fn to_end(cnc: &mut Cnc) -> Vec<Position> {
    let mut places = Vec::new();
    for _ in 0..200_000 {
        places.push(cnc.tick().position);
        if !matches!(cnc.state(), State::Running | State::Held) {
            return places;
        }
    }
    panic!("does not end: {:?}", cnc.state());
}

#[test]
fn back_to_the_start_and_forward_to_the_end() {
    let mut cnc = cnc(&machine(), ALONG_X);
    assert!(!cnc.retrace());
    let held = hold_beyond(&mut cnc, 50.0);
    assert!(held < 60.0 && cnc.retrace() && cnc.is_retraced());
    let mut lines = Vec::new();
    loop {
        let tick = cnc.tick();
        lines.push(tick.span.line);
        if tick.position[Axis::X] == 0.0 {
            break;
        }
    }
    lines.dedup();
    assert_eq!(lines, [2, 1]);
    assert_eq!(rest(&mut cnc)[Axis::X], 0.0);
    assert!(!cnc.tick().moving);
    assert_eq!(cnc.state(), &State::Held);
    cnc.cycle_start();
    let places = to_end(&mut cnc);
    assert_eq!(places.last().unwrap()[Axis::X], 100.0);
    assert!(places.windows(2).all(|pair| pair[1][Axis::X] >= pair[0][Axis::X]));
    assert_eq!(cnc.report().parts, 1);
    assert_eq!(cnc.state(), &State::Ended);
    assert!(!cnc.is_retraced());
}

#[test]
fn not_back_over_what_is_no_move() {
    let mut cnc = cnc(&machine(), ALONG_X);
    hold_beyond(&mut cnc, 80.0);
    assert!(cnc.retrace());
    assert_eq!(rest(&mut cnc)[Axis::X], 60.0);
    // Back again from there is nowhere.
    assert!(cnc.retrace());
    assert_eq!(rest(&mut cnc)[Axis::X], 60.0);
    cnc.cycle_start();
    assert_eq!(to_end(&mut cnc).last().unwrap()[Axis::X], 100.0);
    assert_eq!(cnc.report().parts, 1);
}

#[test]
fn held_on_the_way_back_and_on_the_way_forward() {
    let (_, through) = ended(&machine(), CORNERS);
    let near = |at: &Position| {
        let least =
            through.ticks.iter().map(|tick| tick.position.distance(*at)).fold(f64::INFINITY, f64::min);
        assert!(least < 0.08, "{at:?} is {least} off the path");
    };
    // The tick at which the axes were nearest.
    let along = |at: &Position| {
        let distances = through.ticks.iter().map(|tick| tick.position.distance(*at)).enumerate();
        distances.min_by(|a, b| a.1.total_cmp(&b.1)).unwrap().0
    };
    for place in [5.0, 12.0, 18.0, 25.0, 31.0, 39.0] {
        let mut cnc = cnc(&machine(), CORNERS);
        hold_beyond(&mut cnc, place);
        let held = along(&cnc.tick().position);
        for round in 0..3 {
            assert!(cnc.retrace());
            for _ in 0..150 {
                near(&cnc.tick().position);
            }
            cnc.feed_hold();
            let back = rest(&mut cnc);
            near(&back);
            assert!(along(&back) < held || back == Position::ZERO, "{place}, {round}: {back:?}");
            cnc.cycle_start();
            for _ in 0..40 {
                near(&cnc.tick().position);
            }
            cnc.feed_hold();
            near(&rest(&mut cnc));
        }
        cnc.cycle_start();
        let places = to_end(&mut cnc);
        places.iter().for_each(near);
        assert_eq!(*places.last().unwrap(), through.ticks.last().unwrap().position, "{place}");
        assert_eq!((cnc.state(), cnc.report().parts), (&State::Ended, 1));
    }
}

#[test]
fn single_block_still_stops_on_the_end_of_the_block() {
    let mut cnc = cnc(&machine(), CORNERS);
    cnc.set_single_block(true);
    cnc.cycle_start();
    while cnc.state() == &State::Running {
        cnc.tick();
    }
    cnc.cycle_start();
    while x(&mut cnc) < 15.0 {}
    cnc.feed_hold();
    rest(&mut cnc);
    assert!(cnc.retrace());
    // Through the block before it, on whose end the path rested.
    let back = rest(&mut cnc);
    assert_eq!((back[Axis::X], back[Axis::Y]), (0.0, 0.0));
    cnc.cycle_start();
    while cnc.state() == &State::Running {
        cnc.tick();
    }
    let at = rest(&mut cnc);
    assert_eq!((cnc.state(), at[Axis::X], at[Axis::Y]), (&State::BlockEnd, 20.0, 10.0));
}

#[test]
fn a_reset_on_the_way_back_leaves_nothing_behind() {
    let mut cnc = cnc(&machine(), ALONG_X);
    hold_beyond(&mut cnc, 50.0);
    assert!(cnc.retrace());
    while x(&mut cnc) > 40.0 {}
    cnc.reset();
    let at = rest(&mut cnc);
    assert_eq!(cnc.state(), &State::Reset);
    assert!(!cnc.is_retraced() && !cnc.retrace() && at[Axis::X] > 20.0);
    assert_eq!(cnc.interpreter().position(), at);
}

#[test]
fn nobody_moves_the_axes_by_hand_behind_the_place() {
    let mut cnc = cnc(&machine(), ALONG_X);
    cnc.set_interruption(Interruption::Return);
    hold_beyond(&mut cnc, 50.0);
    assert!(cnc.retrace());
    while x(&mut cnc) > 40.0 {}
    cnc.feed_hold();
    rest(&mut cnc);
    assert!(!cnc.jog(Axis::Y, JogWay::Plus, JogSpeed::Feed));
}

#[test]
fn it_comes_to_rest_before_the_place_where_it_was_held() {
    let mut cnc = cnc(&machine(), ALONG_X);
    let held = hold_beyond(&mut cnc, 50.0);
    assert!(cnc.retrace());
    while x(&mut cnc) > 20.0 {}
    cnc.feed_hold();
    rest(&mut cnc);
    cnc.cycle_start();
    let mut before = x(&mut cnc);
    let stops: Vec<f64> = std::iter::from_fn(|| {
        let was = std::mem::replace(&mut before, x(&mut cnc));
        (cnc.state() == &State::Running).then_some((was, before))
    })
    .skip(50)
    .filter(|(was, is)| was == is && *is < 59.0)
    .map(|(_, is)| is)
    .collect();
    assert!(
        !stops.is_empty() && stops.iter().all(|at| (held - 20.0..=held).contains(at)),
        "{held} {stops:?}"
    );
}

#[test]
fn the_way_is_not_gone_with_the_axes_interlocked() {
    let mut cnc = cnc(&machine(), ALONG_X);
    let held = hold_beyond(&mut cnc, 50.0);
    cnc.set_may_move(false);
    assert!(!cnc.retrace());
    cnc.set_may_move(true);
    assert!(cnc.retrace());
    while x(&mut cnc) > 45.0 {}
    cnc.set_may_move(false);
    let there = rest(&mut cnc)[Axis::X];
    assert!(there > 20.0 && there < held);
    cnc.set_may_move(true);
    assert_eq!(rest(&mut cnc)[Axis::X], 0.0);
}

#[test]
fn dry_run_switched_behind_acts_before_the_place_is_passed() {
    let mut cnc = cnc(&machine(), "G90 G1 X100 F600\nM30\n");
    cnc.set_dry_run(Some(DryRun { speed: 100.0, cutting: true, rapid: false, tapping: false }));
    let held = hold_beyond(&mut cnc, 50.0);
    assert!(cnc.retrace());
    rest(&mut cnc);
    cnc.set_dry_run(None);
    cnc.cycle_start();
    let mut fastest: f64 = 0.0;
    while matches!(cnc.state(), State::Held | State::Running) {
        let tick = cnc.tick();
        if tick.position[Axis::X] > held + 0.01 {
            fastest = fastest.max(tick.velocity);
        }
    }
    assert!((9.9..10.01).contains(&fastest), "{fastest} mm/s");
}

#[test]
fn what_was_run_beside_a_handwheel_interruption_is_not_run_back() {
    let mut cnc = cnc(&machine(), ALONG_X);
    cnc.set_interruption(Interruption::Shift);
    hold_beyond(&mut cnc, 50.0);
    assert!(cnc.handwheel(Axis::Z, 5, 0.1));
    rest(&mut cnc);
    assert!(!cnc.retrace());
}

#[test]
fn a_program_given_up_behind_is_broken_off_where_it_was_held() {
    let mut cnc = cnc(&machine(), ALONG_X);
    hold_beyond(&mut cnc, 50.0);
    let lines = cnc.tick().span.line;
    assert!(cnc.retrace());
    while x(&mut cnc) > 10.0 {}
    cnc.reset();
    rest(&mut cnc);
    assert_eq!((cnc.state(), lines), (&State::Reset, 2));
    assert_eq!(cnc.report().parts, 0);
}

/// Acceleration after interpolation is run out at each rest that the axes come through, both ways.
#[test]
fn smoothed_axes_come_to_the_rests_of_the_path_both_ways() {
    let mut machine = machine();
    for axis in &mut machine.axes {
        axis.after_rapid = Smoothing::Linear { time_ms: 80.0 };
        axis.after_cutting = Smoothing::Linear { time_ms: 80.0 };
    }
    let corners = [Position::xyz(60.0, 40.0, 0.0), Position::xyz(60.0, 40.0, -20.0)];
    let mut cnc = cnc(&machine, "G90 G0 X60 Y40\nG0 Z-20\nG1 X100 F3000\nX140\nM30\n");
    hold_beyond(&mut cnc, 80.0);
    assert!(cnc.retrace());
    let mut back = Vec::new();
    for _ in 0..8000 {
        back.push(cnc.tick().position);
    }
    assert_eq!(back.last(), Some(&Position::ZERO));
    cnc.cycle_start();
    let forward = to_end(&mut cnc);
    for corner in corners {
        for (way, places) in [("back", &back), ("forward", &forward)] {
            let near = places.iter().map(|place| place.distance(corner)).fold(f64::INFINITY, f64::min);
            assert!(near < 1e-9, "{way}: {near} mm from {corner:?}");
        }
    }
}
