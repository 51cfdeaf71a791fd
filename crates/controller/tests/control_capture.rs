//! Waveforms by a front.
#![allow(missing_docs, clippy::unwrap_used, clippy::panic, clippy::indexing_slicing)]

mod common;

use common::shop::Shop;
use ferrocut_controller::Mode;
use ferrocut_controller::api::{CaptureTrigger, Command, Reply};

fn capture(quantities: &[&str], seconds: f64) -> Command {
    let quantities = quantities.iter().map(|name| (*name).to_owned()).collect();
    Command::Capture { quantities, seconds, every: 1, trigger: None, before: 0.0 }
}

fn captured(shop: &mut Shop) -> (bool, Option<f64>, u32, Vec<Vec<f64>>) {
    let (mut rows, mut from) = (Vec::new(), 0);
    loop {
        let Reply::Captured { done, triggered, samples, csv } =
            shop.say(Command::Captured { from, most: 100_000 })
        else {
            panic!()
        };
        let lines: Vec<&str> = csv.lines().skip(usize::from(from == 0)).collect();
        if lines.is_empty() {
            return (done, triggered, samples, rows);
        }
        from += lines.len() as u32;
        rows.extend(lines.iter().map(|line| line.split(',').map(|value| value.parse().unwrap()).collect()));
    }
}

#[test]
fn a_move_is_recorded_at_the_servo_period() {
    let mut shop = Shop::new(&[]);
    shop.mode(Mode::Mdi);
    shop.say(Command::Mdi { text: "G1 X10 F1200".into() });
    let trigger = CaptureTrigger { quantity: "commanded.X".into(), level: 5.0, rises: true };
    let quantities = ["commanded.X", "velocity.X", "velocity"].map(str::to_owned).to_vec();
    shop.say(Command::Capture { quantities, seconds: 0.2, every: 1, trigger: Some(trigger), before: 0.05 });
    let Reply::Captured { csv, .. } = shop.say(Command::Captured { from: 0, most: 10 }) else { panic!() };
    assert_eq!(csv, "t,commanded.X,velocity.X,velocity\n");
    shop.start();
    shop.until_it_stops();
    let (done, triggered, samples, rows) = captured(&mut shop);
    assert!(done && triggered.is_some());
    assert_eq!((samples, rows.len()), (200, 200));
    // The sample of the trigger is the 50th, at time 0; samples are a period apart, 20 mm/s before and behind it.
    assert!((rows[49][0]).abs() < 1e-9 && rows[49][1] >= 5.0 && rows[48][1] < 5.0, "{:?}", rows[49]);
    for pair in rows.windows(2) {
        assert!((pair[1][0] - pair[0][0] - 0.001).abs() < 1e-9);
        assert!((pair[1][1] - pair[0][1] - pair[1][2] * 0.001).abs() < 1e-9, "velocity is the difference");
    }
    assert!((rows[60][2] - 20.0).abs() < 1e-6 && (rows[60][3] - 20.0).abs() < 1e-6);
}

#[test]
fn a_recording_is_ended_and_what_cannot_be_is_refused() {
    let mut shop = Shop::new(&[]);
    assert_eq!(shop.refused(Command::Captured { from: 0, most: 1 }), "FC-1407");
    for bad in [
        capture(&[], 1.0),
        capture(&["commanded.Q"], 1.0),
        capture(&["commanded.V"], 1.0),
        capture(&["dance"], 1.0),
        capture(&["velocity"], f64::INFINITY),
        capture(&["velocity"], -1.0),
        capture(&["velocity"], 1e9),
        capture(&["velocity"], 0.0),
        capture(&["velocity"; 17], 1.0),
    ] {
        assert_eq!(shop.refused(bad.clone()), "FC-1422", "{bad:?}");
    }
    let json = r#"{"do":"capture","quantities":["velocity","spindle"],"seconds":10}"#;
    shop.say(serde_json::from_str(json).unwrap());
    shop.wait(7);
    shop.say(Command::EndCapture);
    shop.wait(7);
    let (done, triggered, samples, rows) = captured(&mut shop);
    assert_eq!((done, triggered, samples, rows.len()), (true, None, 7, 7));
    // An answer is bounded.
    shop.say(capture(&["velocity"], 5.0));
    shop.wait(5000);
    let Reply::Captured { csv, samples, .. } = shop.say(Command::Captured { from: 10, most: u32::MAX })
    else {
        panic!()
    };
    assert_eq!((csv.lines().count(), samples), (2000, 5000));
}
