//! The way back from manual intervention (GSK990MC part 2, 4.1.4) is stopped by whatever stops axes, at any moment, without

//! a jump; and what is forbidden to axes is so to every way that they are moved by hand.

use crate::common::shop::Shop;
use ferrocut_controller::api::{Activity, ByAxis, Command, Status};
use ferrocut_controller::signals::Ways;
use ferrocut_controller::{Mode, Parts};
use ferrocut_machine::Machine;

const PLUS: Ways = Ways { plus: true, minus: false };
const MINUS: Ways = Ways { plus: false, minus: true };

const PART: &str = "M3 S900\nG90 G0 Z0\nG1 X80 F3000\nM30\n";

/// The part held in its cut, with Y and Z moved away by hand.
fn away() -> (Shop, Status) {
    let mut shop = Shop::new(&[]);
    shop.store("O0001", PART);
    shop.select("O1");
    shop.start();
    shop.wait(400);
    shop.hold();
    let held = shop.until_it_stops();
    assert_eq!(held.activity, Activity::Held);
    shop.mode(Mode::Jog);
    shop.inputs.jog[1] = PLUS;
    shop.inputs.jog[2] = MINUS;
    shop.wait(1500);
    shop.inputs.jog = Default::default();
    let aside = shop.until_it_stops();
    assert!(far(&aside, &held) > 20.0);
    shop.mode(Mode::Auto);
    (shop, held)
}

/// The farthest that an axis is from where it was, mm.
fn far(one: &Status, other: &Status) -> f64 {
    let (one, other): (&ByAxis, &ByAxis) = (&one.position.machine, &other.position.machine);
    one.iter().map(|(axis, at)| (at - other[axis]).abs()).fold(0.0, f64::max)
}

#[derive(Clone, Copy, PartialEq, Eq, Debug)]
enum Stop {
    Hold,
    Interlock,
    Jog,
    Edit,
    Reset,
    Emergency,
}

const STOPS: [Stop; 6] = [Stop::Hold, Stop::Interlock, Stop::Jog, Stop::Edit, Stop::Reset, Stop::Emergency];

/// Goes on by periods, in none of which an axis goes farther than at its fastest.
fn smoothly(shop: &mut Shop, periods: usize) -> Status {
    let fastest = Machine::demo_mill().axes.iter().map(|axis| axis.rapid).fold(0.0, f64::max) / 60.0;
    let mut before = shop.control.status();
    for _ in 0..periods {
        let now = shop.wait(1);
        assert!(far(&now, &before) <= 1.01e-3 * fastest, "a jump of {}", far(&now, &before));
        before = now;
    }
    before
}

#[test]
fn whatever_stops_the_way_back_stops_it_without_a_jump_and_keeps_the_rest_of_it() {
    let (mut shop, _) = away();
    shop.start();
    // Behind its middle the axes brake as hard as they may, so that a stop is the end of the way.
    let whole = (0..).find(|_| shop.wait(1).activity != Activity::Returning).unwrap();
    for stop in STOPS {
        for after in [1, 7, whole / 6, whole / 4, whole / 3, 2 * whole / 5] {
            let case = format!("{stop:?} after {after}");
            let (mut shop, held) = away();
            shop.start();
            assert_eq!(smoothly(&mut shop, after).activity, Activity::Returning, "{case}");
            match stop {
                Stop::Hold => shop.inputs.feed_hold = true,
                Stop::Interlock => shop.inputs.axes_may_move = false,
                Stop::Jog => shop.inputs.mode = Mode::Jog,
                Stop::Edit => shop.inputs.mode = Mode::Edit,
                Stop::Reset => drop(shop.say(Command::Reset)),
                Stop::Emergency => drop(shop.say(Command::EmergencyStop { pressed: true })),
            }
            let stopped = smoothly(&mut shop, 1000);
            assert!(far(&stopped, &held) > 1.0, "{case}: it went on to its end");
            shop.inputs.feed_hold = false;
            shop.inputs.axes_may_move = true;
            shop.inputs.mode = Mode::Auto;
            let stands = smoothly(&mut shop, 200);
            assert_eq!(stands.position.machine, stopped.position.machine, "{case}: moves on");
            if matches!(stop, Stop::Reset | Stop::Emergency) {
                assert!(!matches!(stands.activity, Activity::Held | Activity::Running), "{case}");
                continue;
            }
            // Cycle start goes the rest of the way, and then on.
            assert_eq!(stands.activity, Activity::Held, "{case}");
            shop.start();
            let mut nearest = f64::INFINITY;
            for _ in 0..1500 {
                nearest = nearest.min(far(&smoothly(&mut shop, 1), &held));
            }
            assert!(nearest < 1e-4, "{case}: passes the point where it was held");
            let ended = shop.until_it_stops();
            assert_eq!((ended.activity, ended.position.machine[&'X']), (Activity::Idle, 80.0), "{case}");
        }
    }
}

fn mdi(shop: &mut Shop, text: &str) {
    shop.mode(Mode::Mdi);
    shop.say(Command::Mdi { text: text.into() });
    shop.start();
    shop.until_it_stops();
}

/// Jogs an axis for so many periods, at rapid speed.
fn jog(shop: &mut Shop, axis: usize, way: Ways, periods: usize) -> Status {
    shop.mode(Mode::Jog);
    shop.inputs.manual_rapid = true;
    shop.inputs.jog[axis] = way;
    shop.wait(periods);
    shop.inputs.jog = Default::default();
    shop.until_it_stops()
}

/// A box from 20 to 60 on X, -50 to 50 on Y and Z is forbidden.
const BOX: &str = "G12 X60 Y50 Z50 I20 J-50 K-50";

#[test]
fn the_way_back_leads_through_no_area_that_is_forbidden() {
    let mut shop = Shop::new(&[("NO11.0", 0.0)]);
    mdi(&mut shop, &format!("G90 G0 X0 Y0\n{BOX}"));
    shop.store("O0001", "M3 S900\nG91 G1 X-5 F100\nG13\nM30\n");
    shop.select("O1");
    shop.start();
    shop.wait(200);
    shop.hold();
    shop.until_it_stops();
    // Round the box to its other side.
    let round = [(1, PLUS, 900), (0, PLUS, 1200), (1, MINUS, 900)];
    let mut there = shop.wait(1);
    for (axis, way, periods) in round {
        there = jog(&mut shop, axis, way, periods);
    }
    assert!(
        there.position.machine[&'X'] > 60.0 && there.position.machine[&'Y'].abs() < 50.0,
        "{:?} {:?}",
        there.position.machine,
        shop.told()
    );
    shop.mode(Mode::Auto);
    shop.told();
    shop.start();
    assert_eq!(shop.told(), ["FC-0440"]);
    assert_eq!(shop.wait(500).position.machine, there.position.machine);
    // The way that he came there is free.
    for (axis, way, periods) in [(1, PLUS, 900), (0, MINUS, 1200)] {
        jog(&mut shop, axis, way, periods);
    }
    shop.mode(Mode::Auto);
    shop.start();
    assert_eq!(shop.until_it_stops().activity, Activity::Idle);
    assert_eq!(shop.told(), [""; 0]);
}

#[test]
fn an_axis_that_an_override_of_0_has_stopped_keeps_out_when_it_goes_on() {
    let mut shop = Shop::new(&[("NO11.0", 0.0)]);
    mdi(&mut shop, &format!("G90 G0 X0 Y0\n{BOX}"));
    shop.mode(Mode::Jog);
    shop.inputs.jog[0] = PLUS;
    shop.wait(200);
    shop.inputs.manual_override = 0.0;
    let stands = shop.wait(500).position.machine[&'X'];
    assert!(stands > 0.0 && stands < 20.0);
    shop.inputs.manual_override = 2.0;
    shop.wait(5000);
    assert_eq!(shop.x(), 20.0);
}

#[test]
fn a_known_reference_point_is_gone_to_round_what_is_forbidden() {
    // 5#4: positioned where it is known.
    let mut shop = Shop::new(&[("NO5.4", 1.0), ("NO11.0", 0.0)]);
    mdi(&mut shop, &format!("G90 G0 X90 Y0\n{BOX}"));
    // Both at once go to it through the box from where each alone would not.
    let mut both = Shop::new(&[("NO5.4", 1.0), ("NO11.0", 0.0)]);
    mdi(&mut both, &format!("G90 G0 X90 Y60\n{BOX}"));
    both.mode(Mode::Home);
    both.told();
    (both.inputs.jog[0], both.inputs.jog[1]) = (PLUS, PLUS);
    both.wait(5000);
    assert_eq!(both.told(), ["FC-0440"]);
    let at = both.wait(1).position.machine;
    assert_eq!((at[&'X'], at[&'Y']), (0.0, 60.0));
    let home = |shop: &mut Shop| {
        shop.mode(Mode::Home);
        shop.inputs.jog[0] = PLUS;
        shop.wait(3000);
        shop.inputs.jog = Default::default();
        shop.until_it_stops();
        shop.x()
    };
    shop.told();
    assert_eq!(home(&mut shop), 90.0);
    assert_eq!(shop.told(), ["FC-0440"]);
    mdi(&mut shop, "G0 Y60");
    shop.told();
    assert_eq!(home(&mut shop), 0.0);
}

/// Holds the program after so many periods, and turns Y by 20 mm.
fn hold_and_turn(shop: &mut Shop, periods: usize) {
    shop.select("O1");
    shop.start();
    shop.wait(periods);
    shop.hold();
    shop.until_it_stops();
    shop.mode(Mode::Handle);
    (shop.inputs.handwheel_axis, shop.inputs.increment) = (Some(1), 2);
    shop.wait(2);
    shop.say(Command::Handwheel { counts: 200 });
}

#[test]
fn a_program_beside_its_path_stops_at_what_is_forbidden() {
    let mut shop = Shop::new(&[("NO56.3", 1.0), ("NO11.0", 0.0)]);
    mdi(&mut shop, &format!("G90 G0 X0 Y-60\n{BOX}"));
    shop.store("O0001", "M3 S900\nG90 G1 X5 F300\nX70\nG13\nM30\n");
    hold_and_turn(&mut shop, 300);
    assert_eq!(shop.until_it_stops().position.machine[&'Y'], -40.0);
    shop.mode(Mode::Auto);
    shop.told();
    shop.start();
    let status = shop.until_it_stops();
    assert_eq!((status.activity, shop.told()), (Activity::Alarm, vec!["FC-0440".to_owned()]));
    let x = status.position.machine[&'X'];
    assert!((20.0..21.0).contains(&x), "{x}");
}

#[test]
fn more_than_ten_turns_of_the_handwheel_never_wait() {
    // 56#0: all counts are run.
    let mut shop = Shop::new(&[("NO56.0", 1.0)]);
    shop.mode(Mode::Handle);
    (shop.inputs.handwheel_axis, shop.inputs.increment) = (Some(0), 2);
    shop.wait(2);
    for _ in 0..10 {
        shop.say(Command::Handwheel { counts: i32::MAX });
        shop.wait(1);
    }
    let x = shop.until_it_stops().position.machine[&'X'];
    assert!((100.0..101.0).contains(&x), "{x}");
}

#[test]
fn a_jog_key_that_is_held_behind_the_handwheel_waits_until_its_way_is_done() {
    let mut shop = Shop::new(&[("NO56.3", 1.0), ("NO56.0", 1.0)]);
    shop.store("O0001", PART);
    hold_and_turn(&mut shop, 400);
    shop.wait(200);
    // The axis is on its way yet, and the key is pressed already.
    shop.inputs.jog[1] = PLUS;
    shop.inputs.mode = Mode::Jog;
    let turned = shop.wait(2).position.machine[&'Y'];
    assert!(turned > 0.0 && turned < 20.0);
    shop.wait(1500);
    shop.inputs.jog = Default::default();
    let there = shop.until_it_stops().position;
    assert!(there.machine[&'Y'] > 20.0 && there.interruption[&'Y'] < 20.0, "{there:?}");
    // The way of the key is gone back, that of the wheel stays.
    shop.mode(Mode::Auto);
    shop.start();
    let ended = shop.until_it_stops().position;
    assert_eq!((ended.machine[&'X'], ended.machine[&'Y']), (80.0, there.interruption[&'Y']));
    assert!(there.interruption[&'Y'] > 0.0);
}

#[test]
fn steps_and_counts_end_with_their_mode_and_with_who_gave_them() {
    for by_mode in [false, true] {
        // 56#0: all counts are run.
        let mut shop = Shop::of(&Machine::demo_mill(), Parts::default());
        shop.mode(Mode::Handle);
        (shop.inputs.handwheel_axis, shop.inputs.increment) = (Some(0), 2);
        shop.wait(2);
        // More than ten turns never wait.
        shop.say(Command::Handwheel { counts: i32::MAX });
        let runs = shop.wait(300);
        assert_ne!(runs.feed.actual, 0.0);
        match by_mode {
            true => shop.mode(Mode::Edit),
            false => drop(shop.say(Command::StopByHand)),
        }
        let stands = shop.wait(500).position.machine[&'X'];
        assert!(stands > 0.0 && stands < 99.0, "{stands}");
        assert_eq!(shop.wait(1000).position.machine[&'X'], stands);
    }
}

/// Without the permission of the interlock the way back does not begin, and the program stays where it is.
#[test]
fn no_axis_goes_back_under_an_interlock() {
    let (mut shop, held) = away();
    let aside = shop.control.status();
    shop.inputs.axes_may_move = false;
    shop.wait(5);
    shop.start();
    let still = shop.wait(500);
    assert_eq!((still.activity, still.position.machine.clone()), (Activity::Held, aside.position.machine));
    shop.inputs.axes_may_move = true;
    shop.wait(5);
    assert_eq!(shop.wait(500).position.machine, still.position.machine);
    shop.start();
    assert_eq!(shop.wait(2).activity, Activity::Returning);
    let ended = shop.until_it_stops();
    assert_eq!((ended.counters.parts, ended.position.machine[&'Y']), (1, held.position.machine[&'Y']));
}
