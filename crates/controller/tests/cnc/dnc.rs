//! DNC: a program from outside, whole or while it comes.

use crate::common::shop::{Shop, person};
use ferrocut_controller::Mode;
use ferrocut_controller::api::{Activity, Command};

fn dnc(text: &str, first: bool, last: bool) -> Command {
    Command::Dnc { text: text.into(), first, last }
}

#[test]
fn a_program_longer_than_what_is_kept_runs_while_it_comes() {
    let mut shop = Shop::new(&[]);
    shop.mode(Mode::Dnc);
    // 1.9 MB, each line 0.01 or 0.02 mm.
    let remark = "x".repeat(100);
    let line =
        |n: u32| format!("G91 G1 X{} F6000 ({remark})\n", if n.is_multiple_of(2) { "0.01" } else { "0.02" });
    let mut lines = (0..15_000).map(line);
    shop.say(dnc("G94\n", true, false));
    shop.say(dnc(&lines.next().unwrap(), false, false));
    // There is no end to what is held before it is started.
    let half = "\n".repeat(600_000);
    shop.say(dnc(&half, false, false));
    assert_eq!(shop.refused(dnc(&half, false, false)), "FC-1418");
    shop.say(dnc("G94\n", true, false));
    shop.start();
    let mut refused = 0;
    for line in lines {
        while let Err(refusal) = shop.control.command(dnc(&line, false, false), &person()) {
            let events = shop.control.events();
            assert_eq!(refusal.alarm.id, "FC-1418", "{:?} {events:?}", shop.control.status());
            refused += 1;
            shop.wait(20);
        }
    }
    assert!(refused > 0, "it was never full");
    assert_eq!(shop.refused(dnc("G0", true, true)), "FC-1401", "another one meanwhile");
    shop.say(dnc("M30\n", false, true));
    let status = shop.until_it_stops();
    assert_eq!((status.activity, status.counters.parts), (Activity::Idle, 1));
    // 7500 odd lines of 0.02 and 7499 even ones of 0.01: the first was taken back.
    assert!((shop.x() - (7500.0 * 0.02 + 7499.0 * 0.01)).abs() < 1e-6, "{}", shop.x());
    // It is gone: nothing of it is kept to run again.
    shop.told();
    shop.start();
    assert_eq!(shop.told(), ["FC-1403"]);
}

#[test]
fn a_sender_that_is_late_costs_a_stop_and_reset_gives_up() {
    let mut shop = Shop::new(&[]);
    shop.mode(Mode::Dnc);
    shop.say(dnc("G91 G1 X5 F6000\n", true, false));
    shop.start();
    let status = shop.wait(2000);
    assert_eq!((status.activity, status.feed.actual, shop.x()), (Activity::Running, 0.0, 5.0));
    // What came is counted, so that who lost his connection goes on behind it.
    let told = |shop: &mut Shop| shop.wait(1).dnc.map(|dnc| (dnc.taken, dnc.tail, dnc.awaited));
    assert_eq!(told(&mut shop), Some((16, "G91 G1 X5 F6000\n".into(), true)));
    shop.say(dnc("X5\nGOTO 10\nX5\n", false, false));
    assert_eq!(told(&mut shop).unwrap().0, 30);
    let status = shop.until_it_stops();
    // Lines are not kept, so that nothing can be jumped to.
    assert_eq!((status.activity, shop.x()), (Activity::Alarm, 10.0));
    assert_eq!(shop.told().last().unwrap(), "gsk990mc:0123");
    shop.say(Command::Reset);
    shop.wait(10);
    assert_eq!(shop.refused(dnc("X5\n", false, false)), "FC-1401");
    assert!(!told(&mut shop).unwrap().2, "it was given up");
    // What is whole before it starts is held: it jumps, and runs as often as it is started.
    shop.say(dnc("G91 G1 X1 F6000\nGOTO 10\nX100\n", true, false));
    assert_eq!(told(&mut shop), Some((29, "G91 G1 X1 F6000\nGOTO 10\nX100\n".into(), true)));
    shop.say(dnc("N10 X1\nM30\n", false, true));
    assert_eq!(told(&mut shop).map(|(taken, _, awaited)| (taken, awaited)), Some((40, false)));
    shop.say(dnc(&"中".repeat(100), true, false));
    let (taken, tail, _) = told(&mut shop).unwrap();
    assert_eq!((taken, tail), (300, "中".repeat(21)));
    shop.say(dnc("G91 G1 X1 F6000\nGOTO 10\nX100\n", true, false));
    shop.say(dnc("N10 X1\nM30\n", false, true));
    for run in 1..=2 {
        shop.start();
        assert_eq!((shop.until_it_stops().counters.parts, shop.x()), (run, 10.0 + 2.0 * run as f64));
    }
}

#[test]
fn a_megabyte_of_blocks_that_do_nothing_is_run_through() {
    let mut shop = Shop::new(&[]);
    shop.mode(Mode::Dnc);
    let remark = "x".repeat(200);
    let part = format!("G4 X0 ({remark})\n").repeat(600);
    shop.say(dnc("G91 G1 X1 F6000\n", true, false));
    let mut parts = 20;
    while parts > 0 && shop.control.command(dnc(&part, false, false), &person()).is_ok() {
        parts -= 1;
    }
    assert!((1..15).contains(&parts), "never full: {parts}");
    shop.start();
    let mut waits = 0;
    while parts > 0 {
        match shop.control.command(dnc(&part, false, false), &person()) {
            Ok(_) => parts -= 1,
            Err(refusal) => {
                assert_eq!(refusal.alarm.id, "FC-1418");
                waits += 1;
                assert!(waits < 2000, "nothing is taken any more");
                shop.wait(20);
            }
        }
    }
    shop.say(dnc("X1\nM30\n", false, true));
    assert_eq!((shop.until_it_stops().counters.parts, shop.x()), (1, 2.0));
}

/// GSK990MC part 2, 11.1.4: M99 is M30 there.
#[test]
fn m99_ends_it() {
    let mut shop = Shop::new(&[]);
    shop.mode(Mode::Dnc);
    for (made, parts) in [(1, &["G90 G0 X3\nG0 X0\nM99\n"][..]), (2, &["G0 X3\nM98 P7\n", "X1\nM99\n"])] {
        shop.store("O7", "G91 G0 X1\nG90\nM99\n");
        let whole = parts.len() == 1;
        shop.say(dnc(parts[0], true, whole));
        shop.start();
        for (number, part) in parts.iter().enumerate().skip(1) {
            shop.say(dnc(part, false, number + 1 == parts.len()));
        }
        let status = shop.until_it_stops();
        assert_eq!((status.activity, status.counters.parts), (Activity::Idle, made), "{:?}", shop.told());
    }
    assert_eq!(shop.x(), 1.0);
}

/// What is sent leads on, even where the line that it would jump to has come.
#[test]
fn no_jump_in_what_is_sent_depends_on_what_has_come() {
    for jump in ["GOTO 10", "IF[1EQ1]GOTO 10", "WHILE[1EQ1]DO1\nEND1", "GOTO 1"] {
        let mut shop = Shop::new(&[]);
        shop.mode(Mode::Dnc);
        shop.say(dnc(&format!("N1 G0 X1\n{jump}\nX5\nN10 G0 X7\nM30\n"), true, false));
        shop.start();
        let status = shop.until_it_stops();
        assert_eq!(
            (status.activity, shop.x(), shop.told()),
            (Activity::Alarm, 1.0, vec!["gsk990mc:0123".into()]),
            "{jump}"
        );
    }
}
