//! Waveforms by a front.

use crate::common::shop::Shop;
use ferrocut_controller::api::{CaptureTrigger, Command, Reply};
use ferrocut_controller::{Mode, Parts};
use ferrocut_machine::servo::Backlash;
use ferrocut_machine::{Machine, PlantConfig};

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

/// A move forth and back on axes with lag and play: what the drive is told, where its encoder is, what is left.
#[test]
fn the_servo_chain_is_recorded_from_the_interpolator_to_the_encoder() {
    let mut machine = Machine { plant: Some(PlantConfig::default()), ..Machine::demo_mill() };
    machine.homing.absolute = true;
    machine.axes[0].backlash = Backlash { cutting: 0.02, ..Backlash::default() };
    let mut shop = Shop::of(&machine, Parts::default());
    shop.mode(Mode::Mdi);
    shop.say(Command::Mdi { text: "G1 X10 F1200\nX5".into() });
    let names = ["commanded", "actual", "error", "setpoint", "compensation", "drive", "encoder", "to_go"]
        .map(|name| format!("{name}.X"));
    let before = shop.control.status().position.machine[&'X'];
    let quantities = names.to_vec();
    shop.say(Command::Capture { quantities, seconds: 1.5, every: 1, trigger: None, before: 0.0 });
    shop.start();
    shop.until_it_stops();
    shop.wait(1500);
    let (_, _, _, rows) = captured(&mut shop);
    let near = |one: f64, other: f64| (one - other).abs() < 1e-9;
    for row in &rows {
        let &[_, commanded, actual, error, _, compensation, drive, encoder, _] = &row[..] else { panic!() };
        assert!(near(drive, commanded + compensation) && near(encoder, actual + compensation), "{row:?}");
        assert!(near(error, commanded - actual), "{row:?}");
    }
    let most = |of: usize| rows.iter().map(|row| row[of].abs()).fold(0.0, f64::max);
    assert!(most(3) > 0.02, "the drive lags: {}", most(3));
    // The play is taken up on the way back alone.
    let turned = rows.iter().position(|row| row[5] != 0.0).unwrap();
    assert!(rows[turned - 1][1] > 9.9 && near(rows.last().unwrap()[5], -0.02), "{:?}", rows[turned - 1]);
    // What is left falls from the whole way to nothing, twice.
    let farthest = rows.iter().map(|row| row[8]).fold(0.0, f64::max);
    let back = rows.iter().map(|row| row[8]).fold(0.0, f64::min);
    assert!(farthest > 0.99 * (10.0 - before) && back < -4.95, "{farthest} {back}");
    assert_eq!((rows.last().unwrap()[8], rows.last().unwrap()[4]), (0.0, 5.0));
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
