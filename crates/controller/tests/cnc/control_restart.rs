//! Program restart by a front: a run is broken off, prepared, and taken up by cycle start (GSK990MC part 2, 10.1.9).

use crate::common::shop::Shop;
use ferrocut_controller::api::{Activity, Command, Event, OffsetValues, Reply, RestartPlan, Status};
use ferrocut_controller::{Mode, Parts};
use ferrocut_geometry::Axis;
use ferrocut_machine::Machine;
use ferrocut_memory::{Settings, Store};
use std::path::Path;
use std::sync::Arc;
use std::time::Duration;

/// Counts itself in #500, cuts three passes of a subprogram.
const PART: &str =
    "O1\n#500=#500+1\nT2 M6\nG54 G90 G0 Z10\nM3 S1200\nG1 Z0 F1200\nM98 P2 L3\nG0 Z10\nM5\nM30\n";
const PASS: &str = "O2\nG91 G1 Z-1 F600\nG90 X40\nX0\nM99\n";

fn restart(line: Option<u32>, sends: bool) -> Command {
    Command::Restart { line, pass: 1, file: None, sends, axis_by_axis: false }
}

/// Prepares a restart and waits until it is ready, or refused.
fn prepared(shop: &mut Shop, command: Command) -> Result<RestartPlan, String> {
    assert_eq!(shop.say(command), Reply::OnItsWay);
    for _ in 0..2000 {
        std::thread::sleep(Duration::from_millis(1));
        shop.wait(1);
        let Reply::Restarts { searching, ready, .. } = shop.say(Command::Restarts) else { panic!() };
        if !searching {
            return ready.map(|plan| *plan).ok_or_else(|| shop.told().pop().unwrap());
        }
    }
    panic!("searches for ever");
}

/// Runs the part until the second pass cuts, and presses the emergency stop there.
fn broken_off(shop: &mut Shop) -> Status {
    shop.store("O0002", PASS);
    shop.store("O0001", PART);
    shop.select("O1");
    shop.start();
    for _ in 0..200_000 {
        let status = shop.wait(1);
        let machine = &status.position.machine;
        if machine[&'Z'] < -1.5 && machine[&'X'] > 20.0 {
            break;
        }
    }
    shop.say(Command::EmergencyStop { pressed: true });
    let status = shop.wait(500);
    assert_eq!((status.activity, status.feed.actual), (Activity::Emergency, 0.0));
    shop.say(Command::EmergencyStop { pressed: false });
    shop.wait(5);
    shop.say(Command::Reset);
    shop.wait(20)
}

fn shop_on(folder: &Path) -> Shop {
    let store = Arc::new(Store::open(folder, Settings::new("gsk990mc")).unwrap());
    let parts = Parts { store: Some(store), ..Parts::default() };
    let mut machine = Machine::demo_mill();
    machine.spindle.acceleration_rpm_s = 40_000.0;
    Shop::of(&machine, parts)
}

#[test]
fn the_interrupted_block_is_taken_up_and_the_part_finished() {
    let mut shop = Shop::new(&[]);
    let status = broken_off(&mut shop);
    let told = status.interrupted.unwrap();
    assert_eq!((told.program.as_str(), told.file.as_str(), told.line), ("O0001", "O0002", 3));
    assert_eq!((told.text.as_str(), told.kept), ("G90 X40", true));
    assert!(shop.events.contains(&Event::Interrupted { program: "O0001".into(), line: 3 }));

    // The tool is out, the table cleared: X and Y are moved by hand.
    shop.mode(Mode::Mdi);
    shop.say(Command::Mdi { text: "G0 Z20\nX-15 Y5".into() });
    shop.start();
    shop.until_it_stops();
    shop.mode(Mode::Auto);
    let stands = shop.wait(1).position.machine;

    let plan = prepared(&mut shop, restart(None, false)).unwrap();
    assert_eq!((plan.file.as_str(), plan.line, plan.text.as_str()), ("O0002", 3, "G90 X40"));
    assert_eq!(plan.origin, "kept");
    assert_eq!([plan.position[&'X'], plan.position[&'Y'], plan.position[&'Z']], [0.0, 0.0, -2.0]);
    // X and Y, then Z (P376, here in the order of the axes).
    let axes: Vec<(char, f64)> = plan.approach.iter().map(|way| (way.axis, way.to)).collect();
    assert_eq!(axes, [('X', 0.0), ('Y', 0.0), ('Z', -2.0)]);
    assert!(plan.differences.iter().any(|d| d.of == "spindle" && d.program.as_deref() == Some("M03 S1200")));
    assert_eq!(plan.missing, ["M03 S1200"]);
    // Nothing moved; and nothing moves while the spindle stands.
    shop.start();
    assert_eq!(shop.wait(200).position.machine, stands);
    assert_eq!(shop.told().last().unwrap(), "FC-1417");

    // The operator types what is missing (10.1.9, 4).
    shop.mode(Mode::Mdi);
    shop.say(Command::Mdi { text: "M3 S1200".into() });
    shop.start();
    shop.until_it_stops();
    shop.mode(Mode::Auto);
    let Reply::Restarts { ready, .. } = shop.say(Command::Restarts) else { panic!() };
    assert_eq!(ready.unwrap().missing, Vec::<String>::new());
    shop.start();
    assert!(!shop.wait(1).restart_ready);
    let status = shop.until_it_stops();
    assert_eq!((status.activity, status.counters.parts), (Activity::Idle, 1));
    assert_eq!([status.position.machine[&'X'], status.position.machine[&'Z']], [0.0, 10.0]);
    assert_eq!(status.interrupted, None);
    let Reply::Variables { variables } = shop.say(Command::Variables { from: 500, to: 500 }) else {
        panic!()
    };
    assert_eq!(variables[&500], 1.0, "the run counts itself once");
}

#[test]
fn the_control_sends_and_each_axis_waits() {
    let mut shop = Shop::new(&[]);
    broken_off(&mut shop);
    shop.mode(Mode::Auto);
    let command = Command::Restart { line: None, pass: 1, file: None, sends: true, axis_by_axis: true };
    let plan = prepared(&mut shop, command).unwrap();
    assert_eq!(plan.missing, Vec::<String>::new());
    assert_eq!(plan.functions, ["M03 S1200"]);
    // The axes were braked behind the block's start: X alone has a way.
    assert_eq!(plan.approach.iter().map(|way| way.axis).collect::<String>(), "X");
    shop.start();
    let status = shop.until_it_stops();
    assert_eq!((status.activity, status.spindle.told), (Activity::Stopped, 1200.0));
    assert_eq!([status.position.machine[&'X'], status.position.machine[&'Z']], [0.0, -2.0]);
    shop.start();
    let status = shop.until_it_stops();
    assert_eq!((status.activity, status.counters.parts), (Activity::Idle, 1));
}

#[test]
fn any_line_is_taken_up_in_the_pass_that_is_asked_for() {
    let mut shop = Shop::new(&[]);
    shop.store("O0002", PASS);
    shop.store("O0001", PART);
    shop.select("O1");
    let command = Command::Restart {
        line: Some(4),
        pass: 3,
        file: Some("O0002".into()),
        sends: true,
        axis_by_axis: false,
    };
    // Before anything was run, from the present state.
    let plan = prepared(&mut shop, command.clone()).unwrap();
    assert_eq!((plan.line, plan.pass, plan.origin.as_str(), plan.position[&'Z']), (4, 3, "present", -3.0));
    let missing = Command::Restart {
        line: Some(4),
        pass: 1,
        file: Some("O0099".into()),
        sends: true,
        axis_by_axis: false,
    };
    assert_eq!(shop.refused(missing), "FC-1407");
    broken_off(&mut shop);
    shop.mode(Mode::Auto);
    let plan = prepared(&mut shop, command).unwrap();
    assert_eq!((plan.line, plan.pass, plan.position[&'X'], plan.position[&'Z']), (4, 3, 40.0, -3.0));
    // Reset forgets it (note 3); what was interrupted is still known.
    shop.say(Command::Reset);
    let status = shop.wait(2);
    assert!(!status.restart_ready && status.interrupted.is_some());
    // A pass that is not reached, and a line that is not there.
    let far = Command::Restart { line: Some(4), pass: 9, file: None, sends: true, axis_by_axis: false };
    assert_eq!(prepared(&mut shop, far).unwrap_err(), "FC-1441");
    assert_eq!(prepared(&mut shop, restart(Some(99), true)).unwrap_err(), "FC-1440");
    // A line of the main program, the spindle turned by the control.
    let plan = prepared(&mut shop, restart(Some(8), true)).unwrap();
    assert_eq!((plan.line, plan.text.as_str(), plan.position[&'Z']), (8, "G0 Z10", -3.0));
    shop.start();
    assert_eq!(shop.until_it_stops().counters.parts, 1);
}

/// 10.1.9, 2 and 5: the key, what is missing by MDI, the key, cycle start.
#[test]
fn the_key_prepares_what_was_interrupted_and_cycle_start_carries_it_out() {
    let mut shop = Shop::new(&[]);
    // Nothing was interrupted.
    shop.store("O0001", PART);
    shop.select("O1");
    shop.told();
    let key = |shop: &mut Shop, on: bool| {
        shop.inputs.restart = on;
        shop.wait(1);
    };
    key(&mut shop, true);
    assert_eq!(shop.told(), ["FC-1443"]);
    key(&mut shop, false);
    broken_off(&mut shop);
    // In another mode it says nothing; held while the mode changes it does not either.
    shop.mode(Mode::Mdi);
    key(&mut shop, true);
    shop.mode(Mode::Auto);
    assert!(!shop.wait(20).restart_ready && !shop.control.outputs().restarting);
    key(&mut shop, false);
    shop.told();
    let until_ready = |shop: &mut Shop| {
        for _ in 0..5000 {
            if shop.wait(1).restart_ready {
                return;
            }
            std::thread::sleep(Duration::from_millis(1));
        }
        panic!("never ready: {:?}", shop.told());
    };
    key(&mut shop, true);
    until_ready(&mut shop);
    assert!(shop.wait(1).restart_ready && shop.control.outputs().restarting);
    // Note 3: after reset it is to be pressed anew.
    shop.say(Command::Reset);
    assert!(!shop.wait(50).restart_ready && !shop.control.outputs().restarting);
    key(&mut shop, false);
    key(&mut shop, true);
    until_ready(&mut shop);
    // The spindle is not as the program has it: the operator sends it.
    shop.told();
    shop.start();
    assert_eq!(shop.told(), ["FC-1417"]);
    shop.mode(Mode::Mdi);
    shop.say(Command::Mdi { text: "M3 S1200".into() });
    shop.start();
    shop.until_it_stops();
    shop.mode(Mode::Auto);
    key(&mut shop, false);
    assert!(shop.wait(2).restart_ready, "the key is off, and what it prepared waits for cycle start");
    let z = shop.control.status().position.machine[&'Z'];
    shop.start();
    assert_eq!(shop.wait(1).activity, Activity::Running);
    let mut led = 0;
    while shop.control.outputs().restarting {
        led += 1;
        assert!(led < 100_000, "{:?}", shop.control.status());
        shop.wait(1);
    }
    // Cutting goes on where the tool came to, and not before.
    assert!(led > 10, "{led} from {z}");
    let done = shop.until_it_stops();
    assert_eq!((done.activity, done.counters.parts, done.interrupted), (Activity::Idle, 1, None));
    assert!(!shop.control.outputs().restarting);
}

/// Values that somebody enters while the program runs, waits or is held are in force from then on: in the run, and in the one
/// that takes it up.
#[test]
fn what_was_entered_under_way_holds_when_the_run_is_taken_up() {
    let folder = tempfile::tempdir().unwrap();
    // It sets G55 itself, behind the change of it, and counts in #501 from what was entered.
    let part = "O1\nG54 G90 G0 Z10\nM3 S1200\nG1 X10 F3000\nM0\nG10 L2 P2 X7 Y0 Z0\n#501=#501+1\nG1 X20\nX80 F600\nG43 H1 X100\nM30\n";
    let of = |shop: &Shop| {
        let memory = shop.control.interpreter().memory();
        let length = memory.tools.get(1).unwrap().length_wear;
        let zeros = memory.work.standard;
        (length, zeros[0][Axis::Y], zeros[1][Axis::X], memory.variables.get(501))
    };
    let entered = (0.5, 2.0, 7.0, Some(42.0));
    {
        let mut shop = shop_on(folder.path());
        shop.store("O0001", part);
        shop.select("O1");
        shop.start();
        let stopped = shop.until_it_stops();
        assert_eq!(stopped.activity, Activity::Stopped, "at M0");
        shop.mode(Mode::Mdi);
        shop.say(Command::SetZero { system: "G55".into(), axes: [('X', 3.0)].into(), add: false });
        shop.say(Command::SetVariable { number: 501, value: Some(41.0) });
        shop.control.flush().unwrap();
        shop.wait(50);
        shop.mode(Mode::Auto);
        shop.start();
        shop.wait(400);
        shop.hold();
        shop.until_it_stops();
        shop.mode(Mode::Mdi);
        shop.say(Command::SetOffset {
            number: 1,
            values: OffsetValues { length_wear: Some(0.5), ..OffsetValues::default() },
            add: false,
        });
        shop.say(Command::SetZero { system: "G54".into(), axes: [('Y', 2.0)].into(), add: false });
        shop.control.flush().unwrap();
        shop.wait(50);
        shop.mode(Mode::Auto);
        shop.start();
        shop.wait(200);
        assert_eq!(of(&shop), entered);
        shop.say(Command::EmergencyStop { pressed: true });
        shop.wait(500);
        shop.say(Command::EmergencyStop { pressed: false });
        shop.say(Command::Reset);
        shop.wait(20);
        let plan = prepared(&mut shop, restart(None, true)).unwrap();
        assert_eq!((plan.line, plan.changes), (9, 0));
        // What is entered behind the break takes the place of it.
        shop.mode(Mode::Mdi);
        let values = OffsetValues { length_wear: Some(0.7), ..OffsetValues::default() };
        shop.say(Command::SetOffset { number: 1, values, add: false });
        shop.control.flush().unwrap();
        shop.wait(50);
        shop.mode(Mode::Auto);
        prepared(&mut shop, restart(None, true)).unwrap();
        shop.start();
        shop.wait(100);
        let entered = (0.7, entered.1, entered.2, entered.3);
        assert_eq!(of(&shop), entered, "the run that takes it up");
        let ended = shop.until_it_stops();
        assert_eq!((ended.activity, of(&shop)), (Activity::Idle, entered));
        shop.control.flush().unwrap();
    }
    assert_eq!(of(&shop_on(folder.path())), (0.7, 2.0, 7.0, Some(42.0)), "on the disk");
}

#[test]
fn what_forbids_a_restart() {
    let mut shop = Shop::new(&[]);
    shop.mode(Mode::Auto);
    assert_eq!(shop.refused(restart(None, true)), "FC-1443");
    assert_eq!(shop.refused(restart(Some(1), true)), "FC-1403");
    broken_off(&mut shop);
    shop.mode(Mode::Jog);
    assert_eq!(shop.refused(restart(None, true)), "FC-1400");
    // 0210: another program is selected.
    shop.store("O0003", "G1 X5 F100\nM30\n");
    shop.select("O3");
    assert_eq!(shop.refused(restart(None, true)), "gsk990mc:0210");
    shop.select("O1");
    prepared(&mut shop, restart(None, true)).unwrap();
    // Data that are changed behind it: the place may be another.
    shop.say(Command::SetZero { system: "G54".into(), axes: [('X', 3.0)].into(), add: false });
    let stands = shop.wait(1).position.machine;
    shop.start();
    assert_eq!(shop.told().last().unwrap(), "FC-1416");
    assert_eq!(shop.wait(300).position.machine, stands);
    // Prepared anew it has them.
    let plan = prepared(&mut shop, restart(None, true)).unwrap();
    assert_eq!(plan.position[&'X'], 3.0);
    // While a program runs there is none.
    shop.say(Command::CancelRestart);
    shop.start();
    shop.wait(50);
    assert_eq!(shop.refused(restart(None, true)), "FC-1444");
    // 0098: axes that are not homed.
    let mut machine = Machine::demo_mill();
    machine.plant = Some(Default::default());
    let mut shop = Shop::of(&machine, Parts::default());
    shop.store("O0001", "G1 X5 F100\nM30\n");
    shop.select("O1");
    assert_eq!(shop.refused(restart(Some(1), true)), "gsk990mc:0098");
}

#[test]
fn the_place_survives_the_power() {
    let folder = tempfile::tempdir().unwrap();
    {
        let mut shop = shop_on(folder.path());
        broken_off(&mut shop);
        shop.control.flush().unwrap();
    }
    let mut shop = shop_on(folder.path());
    let told = shop.wait(1).interrupted.unwrap();
    assert_eq!(
        (told.program.as_str(), told.file.as_str(), told.line, told.kept),
        ("O0001", "O0002", 3, false)
    );
    shop.mode(Mode::Auto);
    let plan = prepared(&mut shop, restart(None, true)).unwrap();
    assert_eq!((plan.file.as_str(), plan.line, plan.origin.as_str()), ("O0002", 3, "present"));
    assert_eq!([plan.position[&'X'], plan.position[&'Z']], [0.0, -2.0], "in its pass");
    // What the program writes on the way is written again: it is said.
    assert_eq!(plan.changes, 1);
    shop.start();
    let status = shop.until_it_stops();
    assert_eq!((status.counters.parts, status.interrupted), (1, None));
    shop.control.flush().unwrap();
    drop(shop);
    let mut shop = shop_on(folder.path());
    assert_eq!(shop.wait(1).interrupted, None, "a run that came to its end is forgotten");
    // A program that is another one now has no such block.
    broken_off(&mut shop);
    shop.control.flush().unwrap();
    drop(shop);
    let mut shop = shop_on(folder.path());
    shop.store("O0002", "O2\nG91 G1 Z-1 F600\nG90 X41\nX0\nM99\n");
    shop.mode(Mode::Auto);
    assert_eq!(prepared(&mut shop, restart(None, true)).unwrap_err(), "FC-1416");
}

#[test]
fn power_that_fails_in_a_cut_leaves_the_place_of_a_moment_before() {
    let folder = tempfile::tempdir().unwrap();
    {
        let mut shop = shop_on(folder.path());
        shop.store("O0001", "G1 X100 F600\nX0\nM30\n");
        shop.select("O1");
        shop.start();
        shop.wait(4000);
        // No flush: what was written once a second is there.
    }
    let mut shop = shop_on(folder.path());
    let told = shop.wait(1).interrupted.unwrap();
    assert_eq!((told.line, told.text.as_str()), (1, "G1 X100 F600"));
}

#[test]
fn a_cycle_goes_on_with_its_hole_after_the_power_too() {
    let folder = tempfile::tempdir().unwrap();
    let holes = "G54 G90 G0 X0 Y0 Z5\nM3 S1000\nG91 G99 G81 X10 Z-8 R-6 F600 K5\nG90 G80 G0 Z5\nM5\nM30\n";
    {
        let mut shop = shop_on(folder.path());
        shop.store("O0001", holes);
        shop.select("O1");
        shop.start();
        // In the fourth hole; the power fails a second and more later, in the fourth or the fifth.
        for _ in 0..100_000 {
            if shop.wait(1).position.machine[&'X'] == 40.0 {
                break;
            }
        }
        shop.wait(1100);
    }
    let mut shop = shop_on(folder.path());
    shop.mode(Mode::Mdi);
    shop.say(Command::Mdi { text: "G90 G0 Z20\nX10".into() });
    shop.start();
    shop.until_it_stops();
    shop.control.flush().unwrap();
    drop(shop);
    // Once more: what was moved since says nothing of the run.
    let mut shop = shop_on(folder.path());
    shop.mode(Mode::Auto);
    let plan = prepared(&mut shop, restart(None, true)).unwrap();
    assert_eq!((plan.line, plan.origin.as_str()), (3, "present"));
    assert!(matches!(plan.hole, 4 | 5), "{plan:?}");
    assert_eq!(plan.position[&'X'], f64::from(plan.hole - 1) * 10.0);
}

#[test]
fn a_cycle_goes_on_with_the_hole_that_was_interrupted() {
    // Five holes in one block, ten apart, from R at Z -1 to -9.
    let holes = "G54 G90 G0 X0 Y0 Z5\nM3 S1000\nG91 G99 G81 X10 Z-8 R-6 F600 K5\nG90 G80 G0 Z5\nM5\nM30\n";
    let at_hole = |x: f64, below: f64| {
        move |status: &Status| {
            let machine = &status.position.machine;
            (machine[&'X'] - x).abs() < 1e-9 && machine[&'Z'] < below
        }
    };
    for (stops, hole, begins) in [
        // In the fourth, in the first, and on the way from the second to the third.
        (Box::new(at_hole(40.0, -4.0)) as Box<dyn Fn(&Status) -> bool>, 4, Some(30.0)),
        (Box::new(at_hole(10.0, -4.0)), 1, None),
        (Box::new(|status: &Status| status.position.machine[&'X'] > 24.0), 3, Some(20.0)),
    ] {
        let mut shop = Shop::new(&[]);
        shop.store("O0001", holes);
        shop.select("O1");
        shop.start();
        for _ in 0..100_000 {
            if stops(&shop.wait(1)) {
                break;
            }
        }
        shop.say(Command::Reset);
        shop.wait(300);
        shop.mode(Mode::Mdi);
        shop.say(Command::Mdi { text: "G90 G0 Z20".into() });
        shop.start();
        shop.until_it_stops();
        shop.mode(Mode::Auto);
        let plan = prepared(&mut shop, restart(None, true)).unwrap();
        assert_eq!((plan.line, plan.hole), (3, hole));
        // Over the hole before, where it was left: R, and the level of the start before the first.
        let (x, z) = begins.map_or((0.0, 5.0), |x| (x, -1.0));
        assert_eq!([plan.position[&'X'], plan.position[&'Z']], [x, z]);
        // The way there is broken off as well: the hole stays the one that it was.
        shop.start();
        shop.wait(120);
        shop.say(Command::Reset);
        shop.wait(300);
        let plan = prepared(&mut shop, restart(None, true)).unwrap();
        assert_eq!((plan.line, plan.hole), (3, hole));
        // The holes that are drilled now.
        let mut drilled = Vec::new();
        shop.start();
        for _ in 0..200_000 {
            let status = shop.wait(1);
            let machine = &status.position.machine;
            if machine[&'Z'] < -8.999 && drilled.last() != Some(&machine[&'X'].round()) {
                drilled.push(machine[&'X'].round());
            }
            if status.activity == Activity::Idle {
                break;
            }
        }
        let wanted: Vec<f64> = (hole..=5).map(|n| f64::from(n) * 10.0).collect();
        assert_eq!(drilled, wanted);
        assert_eq!(shop.wait(1).counters.parts, 1);
    }
}

#[test]
fn a_million_blocks_are_searched_while_the_control_goes_on() {
    let blocks = 1_000_000;
    let mut text = String::from("G91 G94 G1 F6000\n");
    for n in 0..blocks {
        text.push_str(if n % 2 == 0 { "X1\n" } else { "X-1\n" });
    }
    text.push_str("M30\n");
    let mut shop = Shop::new(&[]);
    shop.store("O0001", &text);
    shop.select("O1");
    let begun = std::time::Instant::now();
    assert_eq!(shop.say(restart(Some(blocks), true)), Reply::OnItsWay);
    let mut periods = 0;
    let ready = loop {
        shop.control.tick();
        periods += 1;
        let Reply::Restarts { searching, ready, .. } = shop.say(Command::Restarts) else { panic!() };
        if !searching {
            break ready.unwrap();
        }
        std::thread::sleep(Duration::from_micros(500));
    };
    println!("{blocks} blocks in {:.2} s, {periods} periods meanwhile", begun.elapsed().as_secs_f64());
    assert_eq!((ready.line, ready.position[&'X']), (blocks, 0.0));
    assert!(periods > 10);
    // One that is not wanted any more is given up.
    assert_eq!(shop.say(restart(Some(blocks), true)), Reply::OnItsWay);
    shop.say(Command::Reset);
    let Reply::Restarts { searching, ready, .. } = shop.say(Command::Restarts) else { panic!() };
    assert!(!searching && ready.is_none());
}

#[test]
fn a_program_that_never_began_was_interrupted_nowhere() {
    let mut shop = Shop::new(&[]);
    shop.store("O0001", "O1\nG90 G0 X1\nX2\nX3\nX4\nM30\n");
    shop.store("O0006", "O6\nG90 G0 X9000 Y10\nG1 Z-1 F600\nX5\nX6\nX7\nM30\n");
    shop.select("O1");
    shop.start();
    shop.until_it_stops();
    shop.select("O6");
    shop.events.clear();
    shop.start();
    let status = shop.until_it_stops();
    assert_eq!(status.activity, Activity::Alarm, "{status:?}");
    shop.say(Command::Reset);
    let status = shop.wait(20);
    assert_eq!(status.interrupted, None);
    assert!(!shop.events.iter().any(|event| matches!(event, Event::Interrupted { .. })));
}

#[test]
fn a_run_that_an_alarm_stopped_is_taken_up_at_its_block() {
    let mut shop = Shop::new(&[]);
    shop.store("O0001", "O1\nG90 G1 X10 F3000\nN20 M98 P777\nX20\nM30\n");
    shop.select("O1");
    shop.mode(Mode::Auto);
    shop.start();
    assert_eq!(shop.until_it_stops().activity, Activity::Alarm);
    shop.say(Command::Reset);
    let status = shop.until_it_stops();
    let interrupted = status.interrupted.unwrap();
    assert_eq!((interrupted.line, &interrupted.text[..]), (3, "N20 M98 P777"));
    assert_eq!(status.program.cursor, 3);
    shop.store("O0777", "O777\nG1 X15\nM99\n");
    prepared(&mut shop, restart(None, false)).unwrap();
    shop.start();
    let status = shop.until_it_stops();
    assert_eq!(
        (status.activity, status.position.machine[&'X'], status.counters.parts),
        (Activity::Idle, 20.0, 1)
    );
}
