//! A program that reckons for long does not keep the control from its other work, and what was refused stays so.

use crate::common::shop::{Shop, person};
use ferrocut_controller::Mode;
use ferrocut_controller::api::{Activity, Command};
use std::time::{Duration, Instant};

const ENDLESS: [&str; 5] = [
    "G0 X1\nM99\n",
    "N1 G0 X1\nGOTO 1\n",
    "G0 X1\nWHILE[1EQ1]DO1\n#1=#1+1\nEND1\nM30\n",
    "WHILE[1EQ1]DO1\n#1100=1\n#1100=0\nEND1\nM30\n",
    "M98 P7\nM30\n",
];

/// A shop on a real clock, its programs read in the period or beside.
fn shop(beside: bool) -> Shop {
    let mut shop = Shop::new(&[]);
    match beside {
        true => shop.control.work_beside().unwrap(),
        false => shop.control.keep_time().unwrap(),
    }
    shop
}

/// Far more than a period takes, and far less than a loop without an end.
const SHORT: Duration = Duration::from_millis(500);

/// Periods of a millisecond, as long as threads beside have for their work.
fn pass(shop: &mut Shop, periods: usize) -> Duration {
    let mut longest = Duration::ZERO;
    for _ in 0..periods {
        let began = Instant::now();
        shop.wait(1);
        longest = longest.max(began.elapsed());
        std::thread::sleep(Duration::from_millis(1));
    }
    longest
}

/// Passes until it is so.
fn soon(shop: &mut Shop, wanted: Activity, what: &str) {
    let began = Instant::now();
    while shop.wait(1).activity != wanted {
        assert!(began.elapsed() < 4 * SHORT, "{what} {:?} {:?}", shop.wait(1).activity, shop.told());
        std::thread::sleep(Duration::from_millis(1));
    }
}

#[test]
fn loops_without_an_end_are_stopped_at_once() {
    for beside in [false, true] {
        for text in ENDLESS {
            let what = format!("{text} {beside}");
            let mut shop = shop(beside);
            shop.store("O7", "N1 G0 X1\nGOTO 1\nM99\n");
            shop.store("O1", text);
            shop.select("O1");
            pass(&mut shop, 20);
            shop.start();
            soon(&mut shop, Activity::Running, &what);
            let longest = pass(&mut shop, 200);
            assert!(longest < SHORT && shop.wait(1).activity == Activity::Running, "{what} {longest:?}");
            shop.say(Command::EmergencyStop { pressed: true });
            soon(&mut shop, Activity::Emergency, &what);
            pass(&mut shop, 200);
            assert_eq!(shop.wait(1).feed.actual, 0.0, "{what}");
            shop.say(Command::EmergencyStop { pressed: false });
            shop.say(Command::Reset);
            soon(&mut shop, Activity::Idle, &what);
        }
    }
}

#[test]
fn what_is_reckoned_in_many_periods_is_the_same_and_moves_before_it_are_run_to_their_ends() {
    let mut shop = shop(false);
    let loops = "#1=0\nWHILE[#1LT300000]DO1\n#1=#1+1\nEND1\n";
    shop.store("O1", &format!("G90 G1 X10 F6000\n{loops}#500=#1\nG1 X20\nM30\n"));
    shop.select("O1");
    shop.start();
    let status = shop.wait(400);
    let number = |shop: &Shop| shop.control.cnc().interpreter().memory().variables.get(500);
    assert_eq!((status.activity, shop.x(), number(&shop)), (Activity::Running, 10.0, None));
    let status = shop.until_it_stops();
    assert_eq!((status.activity, shop.x(), number(&shop)), (Activity::Idle, 20.0, Some(300_000.0)));
    // A few hundred blocks between two moves cost no stop.
    let text: String =
        (1..40).map(|x| format!("G1 X{}\n#1=0\nWHILE[#1LT50]DO1\n#1=#1+1\nEND1\n", 20 + 10 * x)).collect();
    shop.store("O2", &format!("G90 F6000\n{text}M30\n"));
    shop.select("O2");
    shop.start();
    shop.wait(300);
    let mut slowest = f64::INFINITY;
    while shop.x() < 400.0 {
        slowest = slowest.min(shop.wait(1).feed.actual);
    }
    assert!(slowest > 5999.0, "{slowest}");
}

#[test]
fn a_program_that_was_refused_is_refused_each_time() {
    let mut shop = Shop::new(&[]);
    for (program, text) in [("O1", "G90 G0 X60\nM30\n"), ("O2", "G90 G0 X550\nM30\n")] {
        shop.store(program, text);
    }
    shop.select("O1");
    shop.start();
    shop.until_it_stops();
    shop.select("O2");
    for _ in 0..3 {
        shop.told();
        shop.start();
        let status = shop.until_it_stops();
        assert_eq!(
            (status.activity, shop.x(), shop.told()),
            (Activity::Alarm, 60.0, vec!["gsk990mc:0501".into()])
        );
        shop.say(Command::Reset);
        shop.wait(10);
    }
    // Typed, and the other way.
    shop.mode(Mode::Mdi);
    for text in ["G90 G0 X550", "G91 G0 X600", "G90 G0 X-550", "G90 G0 X100 Y450"] {
        shop.told();
        shop.say(Command::Mdi { text: text.into() });
        shop.start();
        let status = shop.until_it_stops();
        assert_eq!((status.activity, shop.x(), shop.told().len()), (Activity::Alarm, 60.0, 1), "{text}");
        shop.say(Command::Reset);
        shop.wait(10);
    }
}

#[test]
fn counters_take_what_can_be_counted() {
    let mut shop = Shop::new(&[]);
    let mut set = |counter: &str, value: f64| {
        let command = Command::SetCounter { counter: counter.into(), value };
        shop.control.command(command, &person()).map_err(|refusal| refusal.alarm.id).err()
    };
    for (counter, value) in [("parts", -1.0), ("parts", 1.5), ("parts", 1e9), ("cutting-time", -5.0)] {
        assert_eq!(set(counter, value).as_deref(), Some("FC-1409"), "{counter} {value}");
    }
    assert_eq!((set("parts", 3.0), set("cutting-time", 2.5)), (None, None));
}

#[test]
fn s_in_force_is_the_surface_speed_under_g96() {
    let mut shop = Shop::new(&[("NO61.0", 1.0)]);
    shop.mode(Mode::Mdi);
    let mut speed_behind = |text: &str| {
        shop.say(Command::Mdi { text: text.into() });
        shop.start();
        shop.until_it_stops().spindle.programmed
    };
    assert_eq!(speed_behind("G90 G0 X10\nG92 S500\nG96 P1 S6000 M3"), 6000.0);
    assert_eq!(speed_behind("G97 S300"), 300.0);
    assert_eq!(speed_behind("G96 P1 S5000"), 5000.0);
    assert_eq!(speed_behind("G20"), 5000.0 / 25.4);
    // A person sets it in the same unit, however fast the spindle may turn.
    shop.say(Command::SpindleSpeed { speed: 20_000.0 });
    let programmed = shop.wait(2).spindle.programmed;
    assert!((programmed - 20_000.0).abs() < 1e-9, "{programmed}");
}
