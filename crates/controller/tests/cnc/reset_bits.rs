//! What each bit of the parameters keeps or clears at reset and at emergency stop (GSK990MC 10#3, 10#7, 28#7, 34#7, 35,

//! 36), in a program that is under way and behind one that has ended.

use crate::common::shop::Shop;
use ferrocut_controller::Mode;
use ferrocut_controller::api::{Activity, Command, Event, OffsetValues, RelativeTo, Reply};
use ferrocut_controller::signals::Ways;

/// How a run is given up.
#[derive(Clone, Copy, PartialEq, Debug)]
enum Stop {
    Reset,
    Emergency,
}

/// Where it is by then.
#[derive(Clone, Copy, PartialEq, Debug)]
enum When {
    /// Stopped on its way, by M00.
    UnderWay,
    Ended,
    /// The same, and an axis is moved by hand.
    Jogging,
}

const CASES: [(Stop, When); 6] = [
    (Stop::Reset, When::UnderWay),
    (Stop::Reset, When::Ended),
    (Stop::Emergency, When::UnderWay),
    (Stop::Emergency, When::Ended),
    (Stop::Reset, When::Jogging),
    (Stop::Emergency, When::Jogging),
];

fn stop(shop: &mut Shop, how: Stop) {
    match how {
        Stop::Reset => drop(shop.say(Command::Reset)),
        Stop::Emergency => {
            shop.say(Command::EmergencyStop { pressed: true });
            shop.wait(50);
            shop.say(Command::EmergencyStop { pressed: false });
        }
    }
    for _ in 0..100 {
        if shop.wait(50).activity == Activity::Idle {
            return;
        }
    }
    panic!("{how:?}: {:?}", shop.control.status());
}

/// A control that ran these blocks in MDI, and was stopped.
fn stopped(parameters: &[(&str, f64)], blocks: &str, (how, when): (Stop, When)) -> Shop {
    let mut shop = Shop::new(parameters);
    shop.mode(Mode::Mdi);
    shop.say(Command::SetOffset {
        number: 3,
        values: OffsetValues { length: Some(5.0), radius: Some(1.0), ..OffsetValues::default() },
        add: false,
    });
    let end = if when == When::UnderWay { "\nM00\nM00" } else { "" };
    shop.say(Command::Mdi { text: format!("{blocks}{end}") });
    shop.start();
    let activity = shop.until_it_stops().activity;
    let wanted = if when == When::UnderWay { Activity::Stopped } else { Activity::Idle };
    assert_eq!(activity, wanted, "{blocks}: {:?}", shop.told());
    if when == When::Jogging {
        shop.mode(Mode::Jog);
        shop.inputs.jog[0] = Ways { plus: true, minus: false };
        assert_eq!(shop.wait(300).activity, Activity::ByHand);
        shop.inputs.jog[0] = Ways::default();
    }
    stop(&mut shop, how);
    shop
}

fn codes(shop: &Shop) -> Vec<u16> {
    shop.control.interpreter().codes_in_force().collect()
}

/// 35#1 to 36#7: each clears its group, and no other.
#[test]
fn each_group_of_codes_is_kept_or_cleared_by_its_bit() {
    let speed = [("NO61.0", 1.0)];
    for (bit, blocks, before, after) in [
        ("NO35.1", "G01 X1 F500", 10, 0),
        ("NO35.2", "G18", 180, 170),
        ("NO35.3", "G91", 910, 900),
        ("NO35.4", "G95", 950, 940),
        ("NO35.5", "G55", 550, 540),
        ("NO35.7", "G01 G41 D3 X9 Y9 F2000", 410, 400),
        ("NO36.0", "G43 H3 Z-1", 430, 490),
        ("NO36.1", "S900 M03\nG99 G81 X1 Y1 Z-2 R-1 F500", 810, 800),
        ("NO36.2", "G99", 990, 980),
        ("NO36.3", "G16", 160, 150),
        ("NO36.4", "G51 X0 Y0 P2", 510, 500),
        ("NO36.5", "G68 X0 Y0 R90", 680, 690),
        ("NO36.6", "G61", 610, 640),
        ("NO36.7", "G96 P1 S100", 960, 970),
    ] {
        for case in CASES {
            // 20 is of group 6, which no bit clears.
            let blocks = format!("G20\n{blocks}");
            for (value, is, is_not) in [(0.0, before, after), (1.0, after, before)] {
                let parameters = [&speed[..], &[(bit, value)]].concat();
                let found = codes(&stopped(&parameters, &blocks, case));
                assert!(found.contains(&is) && !found.contains(&is_not), "{bit} {value} {case:?}: {found:?}");
                assert!(found.contains(&200), "{bit} {value} {case:?}: {found:?}");
            }
        }
    }
}

/// The manual has no 35#6: nothing clears inch and metric, and nobody can set it.
#[test]
fn there_is_no_bit_for_inch_and_metric() {
    let mut machine = ferrocut_machine::Machine::demo_mill();
    machine.parameters.insert("NO35.6".into(), 1.0);
    assert!(ferrocut_controller::Control::new(&machine, ferrocut_controller::Parts::default()).is_err());
}

/// What is kept acts: a rotation, a scaling and polar coordinates lead the next move elsewhere. What is cleared does not.
#[test]
fn what_is_kept_of_coordinates_acts_and_what_is_cleared_does_not() {
    for (bit, blocks, next, kept, cleared) in [
        ("NO36.3", "G16", "G90 G00 X10 Y90", [0.0, 10.0], [10.0, 90.0]),
        ("NO36.4", "G51 X0 Y0 P2", "G90 G00 X10 Y5", [20.0, 10.0], [10.0, 5.0]),
        ("NO36.5", "G68 X0 Y0 R90", "G90 G00 X10 Y0", [0.0, 10.0], [10.0, 0.0]),
    ] {
        for case in CASES {
            for (value, wanted) in [(0.0, kept), (1.0, cleared)] {
                let mut shop = stopped(&[(bit, value)], blocks, case);
                shop.mode(Mode::Mdi);
                shop.say(Command::Mdi { text: next.into() });
                shop.start();
                shop.until_it_stops();
                let at = shop.control.status().position.machine;
                let apart = (at[&'X'] - wanted[0]).abs().max((at[&'Y'] - wanted[1]).abs());
                assert!(apart < 1e-6, "{bit} {value} {case:?}: {at:?}");
            }
        }
    }
}

/// 36#1: the data of a hole go with its cycle (4.4, table 4-4-2).
#[test]
fn the_data_of_a_hole_are_kept_or_cleared_with_its_cycle() {
    for case in CASES {
        for (value, depth) in [(0.0, -2.0), (1.0, 0.0)] {
            let mut shop = stopped(&[("NO36.1", value)], "S900 M03\nG90 G98 G81 X1 Y1 Z-2 R-1 F500", case);
            shop.mode(Mode::Mdi);
            shop.say(Command::Mdi { text: "S900 M03\nX9".into() });
            shop.start();
            let mut deepest = 0.0_f64;
            for _ in 0..3000 {
                deepest = deepest.min(shop.wait(1).position.machine[&'Z']);
            }
            assert!((deepest - depth).abs() < 1e-6, "{value} {case:?}: {deepest}");
        }
    }
}

/// 34#7: F, H and D.
#[test]
fn f_h_and_d_are_kept_or_cleared() {
    for case in CASES {
        for (value, wanted) in [(0.0, (432.0, 3, 3.0)), (1.0, (0.0, 0, 0.0))] {
            // The groups of H and D are kept by bits of their own.
            let parameters = [("NO34.7", value), ("NO35.7", 0.0), ("NO36.0", 0.0)];
            let shop = stopped(&parameters, "G43 H3\nG01 G41 D3 X9 Y9 F432", case);
            let interpreter = shop.control.interpreter();
            let shown = interpreter.shown();
            let (h, d) = (shown.h, shown.d);
            let feed = interpreter.program_state().feed_per_minute;
            let default = Shop::new(&[]).control.interpreter().program_state().feed_per_minute;
            let wanted = if value == 1.0 { (default, wanted.1, wanted.2) } else { wanted };
            assert_eq!((feed, h, d), wanted, "{value} {case:?}");
        }
    }
}

/// 28#7: the program of MDI.
#[test]
fn a_reset_in_mdi_deletes_its_program_or_not() {
    for (value, told, x) in [(0.0, vec![], 2.0), (1.0, vec!["FC-1403".to_owned()], 1.0)] {
        let mut shop = stopped(&[("NO28.7", value)], "G91 G00 X1", (Stop::Reset, When::Ended));
        shop.told();
        shop.start();
        shop.until_it_stops();
        assert_eq!((shop.told(), shop.x()), (told, x), "{value}");
    }
    // In another mode it stays.
    let mut shop = stopped(&[("NO28.7", 1.0)], "G91 G00 X1", (Stop::Emergency, When::Ended));
    shop.mode(Mode::Auto);
    shop.say(Command::Reset);
    shop.mode(Mode::Mdi);
    shop.start();
    shop.until_it_stops();
    assert_eq!(shop.x(), 2.0);
}

/// What cycle start runs in MDI, and how often it was told to be another since the last look.
fn mdi(shop: &mut Shop) -> (String, String, usize) {
    shop.wait(1);
    let changed = Event::Changed { item: "mdi".into() };
    let told = std::mem::take(&mut shop.events).into_iter().filter(|event| *event == changed).count();
    match shop.say(Command::MdiText) {
        Reply::MdiText { text, block } => (text, block, told),
        other => panic!("{other:?}"),
    }
}

/// 8.1, 28#4, 28#7: whoever shows the text of MDI shows the one that runs.
#[test]
fn what_runs_in_mdi_is_told_and_that_it_is_another() {
    let now = |text: &str, block: &str, told: usize| (text.to_owned(), block.to_owned(), told);
    let mut shop = Shop::new(&[("NO28.4", 1.0), ("NO28.7", 1.0)]);
    shop.mode(Mode::Mdi);
    assert_eq!(mdi(&mut shop), now("", "", 0));
    shop.say(Command::Mdi { text: "G91 G0 X1\n".into() });
    assert_eq!(mdi(&mut shop), now("G91 G0 X1\n", "", 1));
    shop.say(Command::MdiBlock { block: "G91 G0 X4".into() });
    assert_eq!(mdi(&mut shop), now("G91 G0 X1\n", "G91 G0 X4", 1));
    // The block runs once, the text again and again.
    shop.start();
    shop.until_it_stops();
    assert_eq!((mdi(&mut shop), shop.x()), (now("G91 G0 X1\n", "", 1), 4.0));
    shop.start();
    shop.until_it_stops();
    assert_eq!((mdi(&mut shop), shop.x()), (now("G91 G0 X1\n", "", 0), 5.0));
    // It is of no other mode.
    shop.mode(Mode::Auto);
    assert_eq!(shop.refused(Command::Mdi { text: "G0 X9".into() }), "FC-1400");
    assert_eq!(mdi(&mut shop), now("G91 G0 X1\n", "", 0));
    // A reset there forgets the block alone.
    shop.mode(Mode::Mdi);
    shop.say(Command::MdiBlock { block: "G0 X9".into() });
    shop.mode(Mode::Auto);
    shop.say(Command::Reset);
    assert_eq!(mdi(&mut shop), now("G91 G0 X1\n", "", 2));
    // 28#7.
    shop.mode(Mode::Mdi);
    shop.say(Command::Reset);
    assert_eq!(mdi(&mut shop), now("", "", 1));
    shop.say(Command::Reset);
    shop.until_it_stops();
    assert_eq!(mdi(&mut shop), now("", "", 0));
    // 28#4.
    shop.say(Command::Mdi { text: "G91 G0 X1\nM30\n".into() });
    assert_eq!(mdi(&mut shop).2, 1);
    shop.start();
    shop.until_it_stops();
    assert_eq!((mdi(&mut shop), shop.x()), (now("", "", 1), 6.0));
}

/// 10#3: relative coordinates are those of the machine again.
#[test]
fn a_reset_cancels_relative_coordinates_or_not() {
    let emergency = Command::EmergencyStop { pressed: true };
    let cases = [Command::Reset, emergency].map(|stop| [(0.0, 42.0, stop.clone()), (1.0, 3.0, stop)]);
    for (value, wanted, stop) in cases.into_iter().flatten() {
        let mut shop = Shop::new(&[("NO10.3", value)]);
        shop.mode(Mode::Mdi);
        shop.say(Command::Mdi { text: "G00 X3".into() });
        shop.start();
        shop.until_it_stops();
        shop.say(Command::Relative { axis: 'X', to: RelativeTo::Value(42.0) });
        shop.wait(2);
        shop.say(stop.clone());
        assert_eq!(shop.wait(5).position.relative[&'X'], wanted, "{value} {stop:?}");
    }
}

/// 10#7: the cursor of the program.
#[test]
fn a_reset_puts_the_cursor_to_the_start_or_leaves_it() {
    for (value, mode, wanted) in
        [(0.0, Mode::Auto, 2), (1.0, Mode::Auto, 1), (1.0, Mode::Edit, 2), (1.0, Mode::Mdi, 1)]
    {
        let mut shop = Shop::new(&[("NO10.7", value)]);
        shop.store("O0007", "O7\nG00 X1\nX2\nM30\n");
        shop.select("O7");
        shop.say(Command::Cursor { line: 2 });
        shop.mode(mode);
        shop.say(Command::Reset);
        assert_eq!(shop.wait(5).program.cursor, wanted, "{value} {mode:?}");
    }
}
