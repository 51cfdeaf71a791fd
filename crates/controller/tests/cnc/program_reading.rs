//! Texts of programs are read beside where periods must be short: cycle start waits for them, and runs what is there then.

use crate::common::shop::Shop;
use ferrocut_controller::api::{Activity, Command, Event, Status};
use ferrocut_controller::control::Library;
use ferrocut_controller::{Mode, Parts};
use ferrocut_machine::Machine;
use ferrocut_memory::{Settings, Store};
use std::sync::Arc;
use std::time::Duration;

/// A program of some megabytes that leaves a number in #500.
fn large(number: u32) -> String {
    format!("O1\n#500={number}\nG90 G1 X5 F6000\nM30\n{}", "(a remark that is never read)\n".repeat(100_000))
}

/// A control on a durable memory that works beside.
fn shop(folder: &std::path::Path) -> Shop {
    let store = Arc::new(Store::open(folder, Settings::new("gsk990mc")).unwrap());
    let mut shop = Shop::of(&Machine::demo_mill(), Parts { store: Some(store), ..Parts::default() });
    shop.control.work_beside().unwrap();
    shop
}

/// Periods in real time until something is so.
fn until(shop: &mut Shop, what: &str, is: impl Fn(&Shop, &Status) -> bool) {
    for _ in 0..60_000 {
        std::thread::sleep(Duration::from_micros(500));
        let status = shop.wait(1);
        if is(shop, &status) {
            return;
        }
    }
    panic!("never {what}: {:?}", shop.control.status());
}

/// Stores a program and waits until the control has been told that it is durable.
fn stored(shop: &mut Shop, program: &str, text: &str) {
    shop.events.clear();
    shop.store(program, text);
    until(shop, "stored", |shop, _| shop.events.iter().any(|event| matches!(event, Event::Changed { .. })));
    shop.events.clear();
}

fn number(shop: &Shop) -> Option<f64> {
    shop.control.interpreter().memory().variables.get(500)
}

#[test]
fn a_program_starts_when_its_text_has_come() {
    let folder = tempfile::tempdir().unwrap();
    let mut shop = shop(folder.path());
    stored(&mut shop, "O0001", &large(1));
    shop.select("O1");
    shop.start();
    until(&mut shop, "ended", |shop, status| status.activity == Activity::Idle && number(shop) == Some(1.0));
    shop.events.clear();
    // It is there: nothing is read anew.
    shop.start();
    assert_eq!(shop.wait(1).activity, Activity::Running);
    until(&mut shop, "ended again", |_, status| status.activity == Activity::Idle);

    // Another text under the same name, read ahead before it was changed.
    shop.select("O1");
    shop.mode(Mode::Edit);
    stored(&mut shop, "O0001", &large(2));
    shop.mode(Mode::Auto);
    shop.start();
    until(&mut shop, "ended anew", |shop, status| {
        status.activity == Activity::Idle && number(shop) == Some(2.0)
    });
}

#[test]
fn reset_emergency_stop_hold_and_another_mode_take_the_start_back() {
    let mut shop = Shop::new(&[]);
    shop.control.work_beside().unwrap();
    let takes_back: [fn(&mut Shop); 4] = [
        |shop| drop(shop.say(Command::Reset)),
        |shop| {
            shop.say(Command::EmergencyStop { pressed: true });
            shop.wait(2);
            shop.say(Command::EmergencyStop { pressed: false });
        },
        |shop| shop.hold(),
        |shop| {
            shop.mode(Mode::Mdi);
            shop.mode(Mode::Auto);
        },
    ];
    for take_back in takes_back {
        shop.store("O0001", "O1\n#500=3\nM30\n");
        shop.select("O1");
        // What was read ahead is its text no more, and the new one is held back.
        shop.store("O0001", "O1\n#500=3\nG4 P100\nM30\n");
        let Library::Held(programs) = shop.control.library() else { panic!() };
        let held_back = programs.lock().unwrap();
        shop.start();
        assert_eq!(shop.wait(100).activity, Activity::Idle);
        take_back(&mut shop);
        drop(held_back);
        std::thread::sleep(Duration::from_millis(200));
        let status = shop.wait(100);
        assert_eq!((status.activity, number(&shop)), (Activity::Idle, None));
    }
    shop.start();
    until(&mut shop, "ended", |shop, status| status.activity == Activity::Idle && number(shop) == Some(3.0));
}

#[test]
fn what_is_no_program_is_refused_when_it_was_read() {
    let folder = tempfile::tempdir().unwrap();
    let mut shop = shop(folder.path());
    stored(&mut shop, "O0001", "  \n");
    shop.select("O1");
    shop.start();
    let is_refusal = |event: &Event| matches!(event, Event::Refused { .. });
    until(&mut shop, "refused", |shop, _| shop.events.iter().any(is_refusal));
    assert_eq!(shop.told(), ["FC-0902"]);
    assert_eq!(shop.wait(100).activity, Activity::Idle);
}
