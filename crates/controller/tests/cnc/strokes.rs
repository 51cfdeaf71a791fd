//! Areas that are forbidden to programs are so to axes moved by hand (GSK990MC part 2, 2.6).

use crate::common::shop::Shop;
use ferrocut_controller::api::{Activity, Command};
use ferrocut_controller::signals::Ways;
use ferrocut_controller::{Mode, Parts};
use ferrocut_machine::Machine;

const PLUS: Ways = Ways { plus: true, minus: false };
const MINUS: Ways = Ways { plus: false, minus: true };

/// A box from 20 to 60 on X, -50 to 50 on Y and Z: forbidden inside, or outside.
fn shop(outside: bool, at: &str) -> Shop {
    let mut shop = Shop::new(&[("NO11.0", f64::from(u8::from(outside)))]);
    mdi(&mut shop, &format!("G90 G0 {at}\nG12 X60 Y50 Z50 I20 J-50 K-50"));
    shop
}

fn mdi(shop: &mut Shop, text: &str) {
    shop.mode(Mode::Mdi);
    shop.say(Command::Mdi { text: text.into() });
    shop.start();
    shop.until_it_stops();
}

/// Holds the keys of X and Y for a while, and lets them go.
fn jog(shop: &mut Shop, x: Ways, y: Ways) -> [f64; 2] {
    shop.mode(Mode::Jog);
    shop.inputs.manual_rapid = true;
    shop.inputs.jog[0] = x;
    shop.wait(40);
    shop.inputs.jog[1] = y;
    shop.wait(1500);
    shop.inputs.jog = Default::default();
    shop.until_it_stops();
    let machine = shop.wait(50).position.machine;
    [machine[&'X'], machine[&'Y']]
}

#[test]
fn an_axis_stops_at_the_box_and_passes_beside_it() {
    let none = Ways::default();
    let mut inside = shop(false, "X0 Y0");
    assert_eq!(jog(&mut inside, PLUS, none), [20.0, 0.0]);
    // Back, and from the other side.
    assert!(jog(&mut inside, MINUS, none)[0] < -100.0);
    let mut other = shop(false, "X90 Y0");
    assert_eq!(jog(&mut other, MINUS, none), [60.0, 0.0]);
    // Beside it there is room.
    let mut beside = shop(false, "X0 Y55");
    assert!(jog(&mut beside, PLUS, none)[0] > 60.0);
    // With G13 there is none to keep out of.
    let mut off = shop(false, "X0 Y0");
    mdi(&mut off, "G13");
    assert!(jog(&mut off, PLUS, none)[0] > 60.0);
}

#[test]
fn no_corner_is_cut_by_two_axes() {
    // X is on its way past the box when Y is sent towards it.
    let mut shop = shop(false, "X0 Y70");
    let [x, y] = jog(&mut shop, PLUS, MINUS);
    assert!(x > 60.0 && y == 50.0, "{x} {y}");
}

#[test]
fn the_outside_can_be_forbidden_and_steps_and_handwheel_keep_in() {
    let mut shop = shop(true, "X30 Y0");
    assert_eq!(jog(&mut shop, PLUS, Ways::default()), [60.0, 0.0]);
    assert_eq!(jog(&mut shop, MINUS, PLUS), [20.0, 50.0]);
    shop.mode(Mode::Handle);
    shop.inputs.handwheel_axis = Some(0);
    shop.wait(2);
    shop.say(Command::Handwheel { counts: -100_000 });
    shop.wait(3000);
    assert_eq!(shop.x(), 20.0);
    assert_eq!(jog(&mut shop, PLUS, Ways::default())[0], 60.0);
    shop.say(Command::Reset);
    // One that stands in a forbidden place comes out of it, but goes no deeper; the reset ends the alarm then (2.6, 6).
    mdi(&mut shop, "G13\nG0 X-10\nG12");
    assert_eq!(jog(&mut shop, MINUS, Ways::default())[0], -10.0);
    assert_eq!(jog(&mut shop, PLUS, Ways::default())[0], 60.0);
    assert_eq!(shop.wait(1).activity, Activity::Alarm);
    shop.start();
    assert_eq!(shop.wait(50).activity, Activity::Alarm);
    shop.say(Command::Reset);
    shop.until_it_stops();
    assert_eq!(shop.wait(1).activity, Activity::Idle);
}

/// 2.6, 7): it is an alarm as soon as G12 is in force.
#[test]
fn a_check_that_is_turned_on_where_the_axes_may_not_be_is_an_alarm() {
    for (outside, there, beside) in [(false, "X40 Y0", "X20 Y0"), (true, "X-10 Y0", "X20 Y0")] {
        let mut shop = shop(outside, "X30 Y60");
        let alarms = |shop: &mut Shop, text: &str| {
            shop.say(Command::Reset);
            shop.told();
            mdi(shop, text);
            shop.told()
        };
        let on = |at: &str| format!("G13\nG90 G0 {at}\nG12");
        assert_eq!(alarms(&mut shop, &on(there)), ["FC-0440"]);
        assert_eq!(shop.wait(1).activity, Activity::Alarm);
        // G12 stands all the same: nothing goes deeper.
        assert_eq!(alarms(&mut shop, "G91 G0 X1"), ["FC-0440"]);
        // On the bound is not inside.
        assert_eq!(alarms(&mut shop, &on(beside)), [""; 0]);
        // Another box about the place.
        assert_eq!(alarms(&mut shop, "G12 X10 I5"), if outside { vec!["FC-0440"] } else { vec![] });
    }
}

/// 2.6, 5): with 11#6 it is one as power comes on.
#[test]
fn axes_that_stand_in_the_box_as_power_comes_on_are_an_alarm() {
    let alarms = |lowest: f64, before: bool| {
        let mut machine = Machine::demo_mill();
        machine.homing.limits_before = before;
        let bounds =
            [("P76", lowest), ("P77", 10.0), ("P78", -10.0), ("P79", 10.0), ("P80", -10.0), ("P81", 10.0)];
        // G12 is in force as power comes on, and forbids the inside.
        machine.parameters.extend([("NO31.5".into(), 0.0), ("NO11.0".into(), 0.0)]);
        machine.parameters.extend(bounds.map(|(name, value)| (name.to_owned(), value)));
        let mut shop = Shop::of(&machine, Parts::default());
        let alarms = shop.wait(1).alarms.into_iter().map(|alarm| alarm.id).collect::<Vec<_>>();
        // Out of it, and the reset ends the alarm.
        if lowest < 0.0 {
            let x = jog(&mut shop, PLUS, Ways::default())[0];
            assert!(x > 10.0, "{x} {:?}", shop.wait(1).alarms);
        }
        shop.say(Command::Reset);
        assert!(shop.wait(50).alarms.is_empty());
        alarms
    };
    assert_eq!(alarms(-10.0, true), ["FC-0440"]);
    assert_eq!(alarms(5.0, true), [""; 0]);
    assert_eq!(alarms(-10.0, false), [""; 0]);
}

/// 2.5.2: an axis that is to go on over a software limit stands there with an alarm, which moving it back ends.
#[test]
fn an_axis_moved_by_hand_into_its_limit_is_an_alarm_until_it_is_moved_back() {
    let [min, max] = {
        let shop = Shop::new(&[]);
        let x = &shop.control.machine().axes[0];
        [x.min, x.max]
    };
    let alarms = |shop: &mut Shop| shop.wait(1).alarms.into_iter().map(|a| a.id).collect::<Vec<_>>();
    let move_to_limit = |shop: &mut Shop, mode: Mode, upper: bool| {
        let way = if upper { PLUS } else { MINUS };
        shop.mode(mode);
        (shop.inputs.handwheel_axis, shop.inputs.increment) = (Some(0), 3);
        shop.inputs.manual_rapid = true;
        match mode {
            Mode::Jog => shop.inputs.jog[0] = way,
            Mode::Step => {
                for _ in 0..6 {
                    shop.inputs.jog[0] = way;
                    shop.wait(20);
                    shop.inputs.jog[0] = Ways::default();
                    shop.wait(20);
                }
            }
            _ => {
                shop.wait(2);
                shop.say(Command::Handwheel { counts: if upper { 1000 } else { -1000 } });
            }
        }
        shop.wait(10_000);
        shop.inputs.jog = Default::default();
        shop.until_it_stops();
    };
    for (mode, upper, id) in [
        (Mode::Jog, true, "gsk990mc:0501"),
        (Mode::Jog, false, "gsk990mc:0500"),
        (Mode::Step, true, "gsk990mc:0501"),
        (Mode::Handle, false, "gsk990mc:0500"),
    ] {
        let mut shop = Shop::new(&[]);
        let (near, limit) = if upper { (max - 3.0, max) } else { (min + 3.0, min) };
        mdi(&mut shop, &format!("G53 G0 X{near}"));
        assert_eq!(shop.told(), [""; 0]);
        move_to_limit(&mut shop, mode, upper);
        assert_eq!(shop.x(), limit, "{mode:?}");
        // Told once, and it stands; no program begins.
        assert_eq!((shop.told(), alarms(&mut shop)), (vec![id.to_owned()], vec![id.to_owned()]), "{mode:?}");
        assert_eq!(shop.wait(1).activity, Activity::Alarm);
        shop.mode(Mode::Mdi);
        shop.say(Command::Mdi { text: "G91 G0 X0".into() });
        shop.start();
        assert_eq!(shop.told(), ["FC-1405"]);
        // Another axis does not end it, the way back does, without a reset.
        shop.mode(Mode::Jog);
        shop.inputs.jog[1] = PLUS;
        shop.wait(200);
        shop.inputs.jog = Default::default();
        assert_eq!(alarms(&mut shop), [id]);
        shop.inputs.jog[0] = if upper { MINUS } else { PLUS };
        shop.wait(200);
        shop.inputs.jog = Default::default();
        assert!((shop.x() - limit).abs() > 1.0);
        assert_eq!((alarms(&mut shop), shop.told()), (vec![], vec![]));
        assert_eq!(shop.until_it_stops().activity, Activity::Idle);
    }
    // An area that is forbidden; reset ends it as well.
    let mut shop = shop(false, "X0 Y0");
    shop.told();
    jog(&mut shop, PLUS, Ways::default());
    assert_eq!((shop.told(), alarms(&mut shop)), (vec!["FC-0440".to_owned()], vec!["FC-0440".to_owned()]));
    shop.say(Command::Reset);
    assert_eq!(alarms(&mut shop), [""; 0]);
    // A key that is let go before the limit says nothing.
    jog(&mut shop, MINUS, Ways::default());
    shop.say(Command::Reset);
    shop.told();
    shop.mode(Mode::Jog);
    shop.inputs.jog[0] = PLUS;
    shop.wait(100);
    shop.inputs.jog = Default::default();
    shop.until_it_stops();
    assert_eq!(shop.told(), [""; 0]);
}
