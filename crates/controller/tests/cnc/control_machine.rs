//! The whole control with ladder and simulated machine, by the keys of the panel: homing, travel switches, power-off.

use ferrocut_controller::api::{Activity, Command};
use ferrocut_controller::drives::Trouble;
use ferrocut_controller::{Control, Parts, Plant, State};
use ferrocut_geometry::{Axis, AxisSet};
use ferrocut_machine::{Fault, Machine, PlantAxis, PlantConfig};
use ferrocut_plc::{Address, Limits, Program};

const LADDER: &str = include_str!("../../../../machines/standard.lad");

fn control(machine: &Machine) -> Control {
    let ladder = Program::from_text(LADDER.as_bytes(), &Limits::default()).unwrap();
    let mut control = Control::new(machine, Parts { ladder: Some(ladder), ..Parts::default() }).unwrap();
    wait(&mut control, 100);
    control
}

/// The demo mill with its simulated machine, X with close travel switches.
fn machine() -> Machine {
    let x = PlantAxis { limits: Some([-120.0, 60.0]), ..PlantAxis::new(Axis::X) };
    Machine { plant: Some(PlantConfig { axes: vec![x], ..PlantConfig::default() }), ..Machine::demo_mill() }
}

fn wait(control: &mut Control, periods: usize) {
    (0..periods).for_each(|_| {
        control.tick();
    });
}

fn set(control: &mut Control, key: &str, on: bool) {
    let plc = control.plc_mut().unwrap();
    let address = plc.program().signal(key).unwrap();
    plc.memory_mut().set_bit(address, on);
}

fn is(control: &mut Control, name: &str) -> bool {
    let plc = control.plc_mut().unwrap();
    let address = plc.program().signal(name).unwrap();
    plc.memory().bit(address)
}

fn press(control: &mut Control, key: &str, periods: usize) {
    set(control, key, true);
    wait(control, periods);
    set(control, key, false);
    wait(control, 30);
}

fn until_homed(control: &mut Control) {
    for _ in 0..60_000 {
        control.tick();
        if !control.cnc().is_homing() {
            return wait(control, 50);
        }
    }
    panic!("homes for ever");
}

#[test]
fn the_keys_of_the_panel_home_the_axes_and_light_their_lamps() {
    let mut control = control(&machine());
    assert_eq!(control.cnc().referenced(), AxisSet::EMPTY);
    press(&mut control, "KEY_HOME", 50);
    press(&mut control, "KEY_R_100", 50);
    assert!(is(&mut control, "LAMP_HOME") && !is(&mut control, "LAMP_ZERO_X"));
    press(&mut control, "KEY_X+", 50);
    press(&mut control, "KEY_Z-", 50);
    assert!(control.cnc().is_homing());
    until_homed(&mut control);
    let lamps = ["LAMP_ZERO_X", "LAMP_ZERO_Y", "LAMP_ZERO_Z"].map(|lamp| is(&mut control, lamp));
    assert_eq!(lamps, [true, false, true]);
    assert_eq!(control.status().referenced, ['X', 'Z']);
    assert_eq!(control.status().position.machine[&'X'], 0.0);
    // Another mode ends what is not done.
    press(&mut control, "KEY_Y+", 50);
    assert!(control.cnc().is_homing());
    press(&mut control, "KEY_JOG", 50);
    wait(&mut control, 200);
    assert!(!control.cnc().is_homing() && !is(&mut control, "LAMP_ZERO_Y"));
    assert_eq!(control.status().referenced, ['X', 'Z']);
}

/// GSK990MC 6#5, in effect as delivered: the ladder says when an axis is on its home switch, here by an input of its own
/// choice. Without it, and under a ladder that has nothing to do with home switches, the switch is read where it is wired.
#[test]
fn home_switches_go_through_the_ladder_where_the_parameter_says_so() {
    let passed_on = "RD *DEC_X\nWRT *DEC1\n";
    let of_another = LADDER.replacen(passed_on, "RD X10.0\nWRT *DEC1\n", 1);
    let lines = LADDER.lines().filter(|line| !line.starts_with("WRT *DEC") && !line.starts_with("RD *DEC_"));
    let without: String = lines.map(|line| format!("{line}\n")).collect();
    assert!(of_another != LADDER && without.len() < LADDER.len());
    let homes_at = |ladder: &str, through: Option<f64>| {
        // The reference point is where the switch is left.
        let mut machine = machine();
        machine.parameters.insert("NO6.6".to_owned(), 0.0);
        machine.parameters.insert("NO6.7".to_owned(), 0.0);
        machine.parameters.extend(through.map(|bit| ("NO6.5".to_owned(), bit)));
        let ladder = Program::from_text(ladder.as_bytes(), &Limits::default()).unwrap();
        let mut control = Control::new(&machine, Parts { ladder: Some(ladder), ..Parts::default() }).unwrap();
        let input = Address::parse("X10.0").unwrap();
        let tick = |control: &mut Control| {
            let on_other = (20.0..30.0).contains(&control.status().position.machine[&'X']);
            control.plc_mut().unwrap().memory_mut().set_bit(input, !on_other);
            control.tick().position[Axis::X]
        };
        (0..100).for_each(|_| _ = tick(&mut control));
        for key in ["KEY_HOME", "KEY_R_100", "KEY_X+"] {
            set(&mut control, key, true);
            (0..60).for_each(|_| _ = tick(&mut control));
            set(&mut control, key, false);
            (0..60).for_each(|_| _ = tick(&mut control));
        }
        for _ in 0..60_000 {
            // As it is called until then: by the way from where power came.
            let at = tick(&mut control);
            if control.cnc().referenced().contains(Axis::X) {
                tick(&mut control);
                assert_eq!(tick(&mut control), 0.0);
                return at;
            }
        }
        panic!("X is not homed: {:?}", control.status().alarms);
    };
    let own = homes_at(LADDER, None);
    assert!(own > 60.0, "the switch itself is farther on: {own}");
    let by_ladder = homes_at(&of_another, None);
    assert!((by_ladder - 30.0).abs() < 0.5, "{by_ladder}");
    assert_eq!(homes_at(&of_another, Some(0.0)), own);
    assert_eq!(homes_at(&without, Some(1.0)), own);
}

#[test]
fn an_axis_leaves_its_travel_switch_by_the_release_key() {
    let mut control = control(&machine());
    press(&mut control, "KEY_JOG", 50);
    // 100 % of the jog feed: step 10 of the switch.
    let switch = control.plc_mut().unwrap().program().signal("SWITCH_FEED").unwrap();
    control.plc_mut().unwrap().memory_mut().set_byte(switch, 10);
    // X stands at -80, its switch is at -120.
    set(&mut control, "KEY_X-", true);
    wait(&mut control, 3000);
    let fault = |control: &Control| match control.cnc().state() {
        State::Alarmed(alarm) => Some(alarm.fault),
        _ => None,
    };
    assert_eq!(fault(&control), Some(Fault::HardLimit));
    assert!(is(&mut control, "LAMP_OT") && is(&mut control, "TOWER_RED"));
    set(&mut control, "KEY_X-", false);
    wait(&mut control, 20);
    let stands = control.status().position.machine[&'X'];
    // The release alone, and back; neither on nor with another axis.
    set(&mut control, "KEY_OT", true);
    wait(&mut control, 20);
    for key in ["KEY_X-", "KEY_Y+"] {
        set(&mut control, key, true);
        wait(&mut control, 300);
        set(&mut control, key, false);
        wait(&mut control, 20);
    }
    let at = |control: &Control| control.status().position.machine;
    assert!((at(&control)[&'X'] - stands).abs() < 1e-9 && at(&control)[&'Y'] == 0.0);
    assert_eq!(control.activity(), Activity::Alarm);
    set(&mut control, "KEY_X+", true);
    wait(&mut control, 30);
    // On its way, and still on the switch.
    assert!(at(&control)[&'X'] > stands && control.activity() == Activity::Alarm);
    wait(&mut control, 1000);
    set(&mut control, "KEY_X+", false);
    set(&mut control, "KEY_OT", false);
    wait(&mut control, 500);
    assert!(!is(&mut control, "LAMP_OT") && fault(&control).is_none());
    assert!(at(&control)[&'X'] > stands + 10.0);
    assert_eq!((control.activity(), control.status().alarms), (Activity::Idle, vec![]));
    // Let go too early, the alarm is there again; without it no key moves the axis.
    set(&mut control, "KEY_X-", true);
    wait(&mut control, 3000);
    set(&mut control, "KEY_X-", false);
    wait(&mut control, 20);
    let stands = at(&control)[&'X'];
    set(&mut control, "KEY_X+", true);
    wait(&mut control, 100);
    assert_eq!(at(&control)[&'X'], stands);
    set(&mut control, "KEY_OT", true);
    wait(&mut control, 30);
    set(&mut control, "KEY_OT", false);
    wait(&mut control, 1000);
    assert_eq!(fault(&control), Some(Fault::HardLimit));
    assert!(at(&control)[&'X'] < stands + 5.0 && control.activity() == Activity::Alarm);
}

fn operator() -> ferrocut_memory::Author {
    ferrocut_memory::Author::Person { session: ferrocut_memory::Session::OPERATOR, name: "panel".into() }
}

fn say(control: &mut Control, command: Command) {
    control.command(command, &operator()).unwrap();
}

fn set_byte(control: &mut Control, name: &str, value: u8) {
    let address = control.plc_mut().unwrap().program().signal(name).unwrap();
    control.plc_mut().unwrap().memory_mut().set_byte(address, value);
}

/// Part 2, 2.5.3: it is for axes that are moved by hand.
#[test]
fn the_release_key_keeps_neither_a_program_nor_homing_from_the_travel_switch() {
    let mut machine = machine();
    machine.parameters.insert("NO6.0".to_owned(), 0.0);
    let text = "G91 G1 X-70 F3000\nM30\n";
    for mode in ["KEY_MDI", "KEY_AUTO", "KEY_HOME"] {
        let ladder = Program::from_text(LADDER.as_bytes(), &Limits::default()).unwrap();
        let mut plant = Plant::new(&machine, Default::default(), Default::default());
        plant.trouble(Axis::X, Trouble::HomeSwitch(Some(false)));
        let parts = Parts { ladder: Some(ladder), drives: Some(Box::new(plant)), ..Parts::default() };
        let mut control = Control::new(&machine, parts).unwrap();
        wait(&mut control, 100);
        set_byte(&mut control, "SWITCH_FEED", 10);
        press(&mut control, "KEY_R_100", 50);
        press(&mut control, mode, 50);
        set(&mut control, "KEY_OT", true);
        match mode {
            "KEY_MDI" => say(&mut control, Command::Mdi { text: text.into() }),
            "KEY_AUTO" => {
                say(&mut control, Command::Store { program: "O0001".into(), text: text.into() });
                say(&mut control, Command::Select { program: "O0001".into() });
            }
            _ => press(&mut control, "KEY_X+", 50),
        }
        press(&mut control, "KEY_START", 50);
        for _ in 0..60_000 {
            control.tick();
            if control.activity() == Activity::Alarm {
                break;
            }
        }
        let State::Alarmed(alarm) = control.cnc().state() else {
            panic!("{mode}: {:?}", control.cnc().state())
        };
        assert_eq!((alarm.fault, control.cnc().is_homing()), (Fault::HardLimit, false), "{mode}");
        // It stands at the switch.
        let way = control.status().position.machine[&'X'];
        assert!((-46.0..-40.0).contains(&way) || (140.0..150.0).contains(&way), "{mode}: {way}");
    }
}

/// A travel switch that is released lets an axis go back by the handwheel, whichever way that is turned, and not on.
#[test]
fn the_handwheel_drives_no_axis_over_a_switch_that_is_released() {
    for reversed in [false, true] {
        let mut machine = machine();
        machine.parameters.insert("NO56.7".to_owned(), f64::from(u8::from(!reversed)));
        let mut control = control(&machine);
        set_byte(&mut control, "SWITCH_FEED", 10);
        press(&mut control, "KEY_R_100", 50);
        press(&mut control, "KEY_MPG", 50);
        press(&mut control, "KEY_WX", 50);
        press(&mut control, "KEY_S2", 50);
        set(&mut control, "KEY_OT", true);
        wait(&mut control, 50);
        let down = if reversed { 1 } else { -1 };
        let turn = |control: &mut Control, counts: i32, times: usize| {
            for _ in 0..times {
                say(control, Command::Handwheel { counts });
                wait(control, 20);
            }
            wait(control, 2000);
            control.status().position.machine[&'X']
        };
        // X stands at -80, its switch is at -120: 40 mm on. The counts that are left go, too.
        let at = turn(&mut control, down * 10, 60);
        assert!(is(&mut control, "LAMP_OT") && (-43.0..-40.0).contains(&at), "{at}");
        assert_eq!(turn(&mut control, down * 10, 20), at, "reversed {reversed}");
        assert_eq!(turn(&mut control, -down * 10, 10), at + 10.0, "reversed {reversed}");
        assert!(!is(&mut control, "LAMP_OT"));
    }
}

#[test]
fn the_text_of_the_ladder_is_that_of_the_one_that_runs() {
    use ferrocut_controller::api::{Command, Reply};
    let author = ferrocut_memory::Author::Maintenance { name: "builder".into() };
    let mut control = control(&machine());
    let mut text = |command: Command| {
        let reply = control.command(command, &author).unwrap();
        wait(&mut control, 20);
        match reply {
            Reply::Text { text } => text,
            other => format!("{other:?}"),
        }
    };
    let standard = text(Command::Ladder);
    let exchanged = format!("{LADDER}\n; a remark of the builder\n");
    text(Command::ExchangeLadder { text: exchanged.clone() });
    assert_eq!(text(Command::Ladder), exchanged);
    text(Command::RollBackLadder);
    assert_eq!(text(Command::Ladder), standard);
    // And back again, with its remarks.
    text(Command::RollBackLadder);
    assert_eq!(text(Command::Ladder), exchanged);
}

#[test]
fn a_ladder_is_looked_at_and_every_fault_of_it_is_told() {
    use ferrocut_controller::api::{Command, Reply};
    let author = ferrocut_memory::Author::Maintenance { name: "builder".into() };
    let mut control = control(&machine());
    let mut checked =
        |text: &str| match control.command(Command::CheckLadder { text: text.into() }, &author).unwrap() {
            Reply::LadderChecked { list, steps, faults, count } => {
                let faults: Vec<_> = faults.iter().map(|fault| (fault.id.clone(), fault.line)).collect();
                (list, steps, faults, count)
            }
            other => panic!("{other:?}"),
        };
    let fine = "RD X0.0\nWRT Y0.0\nEND1\nEND2\n";
    assert_eq!(checked(fine), (Some(fine.to_owned()), 4, vec![], 0));
    // No such instruction; a contact without an address; the same output at two places.
    let text = "RD X0.0\nWRONG X0.1\nWRT Y0.0\nRD\nWRT Y0.1\nRD X0.2\nWRT Y0.0\nEND1\nEND2\n";
    let (list, steps, faults, count) = checked(text);
    assert_eq!((list, steps, count), (None, 0, 3));
    for (number, line) in [(1002, 2), (1001, 4), (1027, 7)] {
        assert!(faults.contains(&(format!("gsk990mc:{number}"), line)), "{faults:?}");
    }
    // As many as one answer holds, and how many there are.
    let (_, _, faults, count) = checked(&"WRONG\n".repeat(500));
    assert_eq!((faults.len(), count >= 500), (100, true), "{count}");
    // What is looked at runs nowhere.
    assert!(control.plc_mut().unwrap().program().signal("KEY_START").is_some());
    let refused = control.command(Command::ExchangeLadder { text: text.into() }, &author).unwrap_err();
    assert_eq!((refused.alarm.id.as_str(), refused.alarm.line), ("gsk990mc:1002", 2));
}

/// A contact and a coil as an editor of PLCopen writes them.
const DIAGRAM: &str = r#"<?xml version="1.0" encoding="utf-8"?>
<project xmlns="http://www.plcopen.org/xml/tc6_0201">
<types><dataTypes/><pous><pou name="MAIN" pouType="program">
<interface><localVars><variable name="LIGHT_KEY" address="%IX21.7"><type><BOOL/></type></variable></localVars></interface>
<body><LD>
<leftPowerRail localId="1"><position x="0" y="0"/><connectionPointOut formalParameter=""/></leftPowerRail>
<contact localId="2"><position x="2" y="0"/><connectionPointIn><connection refLocalId="1"/></connectionPointIn>
<connectionPointOut/><variable>LIGHT_KEY</variable></contact>
<coil localId="3"><position x="3" y="0"/><connectionPointIn><connection refLocalId="2"/></connectionPointIn>
<connectionPointOut/><variable>Y100.0</variable></coil>
</LD></body></pou></pous></types></project>"#;

#[test]
fn a_ladder_of_plcopen_is_taken_as_its_list() {
    use ferrocut_controller::api::{Command, Reply};
    use ferrocut_plc::Address;
    let author = ferrocut_memory::Author::Maintenance { name: "builder".into() };
    let mut control = control(&machine());
    let say = |control: &mut Control, command| control.command(command, &author).unwrap();
    let check = Command::CheckLadder { text: DIAGRAM.into() };
    let Reply::LadderChecked { list: Some(list), faults, .. } = say(&mut control, check) else { panic!() };
    assert!(list.contains("RD X0021.7 ; LIGHT_KEY") && faults.is_empty(), "{list}");
    assert_eq!(say(&mut control, Command::ExchangeLadder { text: DIAGRAM.into() }), Reply::Done);
    wait(&mut control, 20);
    assert_eq!(say(&mut control, Command::Ladder), Reply::Text { text: list });
    for on in [true, false] {
        say(&mut control, Command::Key { key: "LIGHT_KEY".into(), down: on });
        wait(&mut control, 20);
        let memory = control.plc_mut().unwrap().memory();
        assert_eq!(memory.bit(Address::parse("Y100.0").unwrap()), on);
    }
    // A fault of the diagram has its line there.
    let wrong = DIAGRAM.replace("Y100.0", "X100.0");
    let Reply::LadderChecked { list: None, faults, .. } =
        control.command(Command::CheckLadder { text: wrong.clone() }, &author).unwrap()
    else {
        panic!()
    };
    assert_eq!(faults.iter().map(|fault| fault.line).collect::<Vec<_>>(), [9]);
    let refused = control.command(Command::ExchangeLadder { text: wrong }, &author).unwrap_err();
    assert_eq!(refused.alarm, faults[0]);
}

#[test]
fn messages_of_a_ladder_go_with_it() {
    use ferrocut_controller::Plant;
    use ferrocut_controller::api::{Command, Event};
    let author = ferrocut_memory::Author::Maintenance { name: "builder".into() };
    let machine = Machine::demo_mill();
    let mut plant = Plant::new(&machine, Default::default(), Default::default());
    assert!(plant.set_level("AIR_PRESSURE", false));
    let ladder = Program::from_text(LADDER.as_bytes(), &Limits::default()).unwrap();
    let parts = Parts { ladder: Some(ladder), drives: Some(Box::new(plant)), ..Parts::default() };
    let mut control = Control::new(&machine, parts).unwrap();
    let messages = |control: &mut Control| {
        wait(control, 100);
        let told = control.events().into_iter().filter_map(|event| match event {
            Event::MachineMessage { name, on } => Some((name, on)),
            _ => None,
        });
        told.collect::<Vec<_>>()
    };
    assert!(messages(&mut control).contains(&("MSG_AIR".to_owned(), true)));
    // The same ladder: the message stands, and is not told again. Who comes later finds it in the status.
    control.command(Command::ExchangeLadder { text: LADDER.into() }, &author).unwrap();
    assert_eq!(messages(&mut control), []);
    assert!(control.status().messages.contains(&"MSG_AIR".to_owned()));
    // One that calls it otherwise.
    let text = LADDER.replace("MSG_AIR", "MSG_AIR_LOW");
    control.command(Command::ExchangeLadder { text }, &author).unwrap();
    let told = messages(&mut control);
    assert!(
        told.contains(&("MSG_AIR".to_owned(), false)) && told.contains(&("MSG_AIR_LOW".to_owned(), true)),
        "{told:?}"
    );
    assert!(control.status().messages.contains(&"MSG_AIR_LOW".to_owned()));
    assert!(!control.status().messages.contains(&"MSG_AIR".to_owned()));
    control.command(Command::RollBackLadder, &author).unwrap();
    let told = messages(&mut control);
    assert!(
        told.contains(&("MSG_AIR".to_owned(), true)) && told.contains(&("MSG_AIR_LOW".to_owned(), false)),
        "{told:?}"
    );
}

#[test]
fn the_longest_times_are_told_and_forgotten() {
    use ferrocut_controller::api::{Command, Reply};
    use ferrocut_memory::Author;
    let mut control = control(&machine());
    let mut timing = |forget| match control.command(Command::Timing { forget }, &Author::Control).unwrap() {
        Reply::Timing {
            periods,
            worst_period_us,
            worst_work_us,
            worst_level_1_us,
            worst_level_2_us,
            level_2_periods,
            ..
        } => (periods, [worst_period_us, worst_work_us, worst_level_1_us, worst_level_2_us], level_2_periods),
        other => panic!("{other:?}"),
    };
    let (periods, [period, work, first, second], rounds) = timing(true);
    assert!(periods > 10 && rounds >= 1, "{periods} {rounds}");
    // A scan is part of the work, and that of its period.
    assert!(first > 0.0 && second > 0.0 && work >= first && work >= second && period > 0.0);
    assert_eq!(timing(false), (0, [0.0; 4], 0));
    for _ in 0..3 {
        control.tick();
    }
    std::thread::sleep(std::time::Duration::from_millis(30));
    control.tick();
    let Ok(Reply::Timing { periods, worst_period_us, .. }) =
        control.command(Command::Timing { forget: false }, &Author::Control)
    else {
        panic!()
    };
    assert!(periods == 4 && worst_period_us >= 30_000.0, "{worst_period_us}");
}

#[test]
fn cycle_start_while_the_ladder_has_the_end_of_the_program_starts_it_again() {
    let mut slow = machine();
    slow.handshake.strobe_delay_ms = 1000.0;
    let author =
        ferrocut_memory::Author::Person { session: ferrocut_memory::Session::OPERATOR, name: "panel".into() };
    let runs_of = |keys: &[&str]| {
        let mut control = control(&slow);
        press(&mut control, "KEY_EDIT", 50);
        let text = "#500=#500+1\nM30\n".into();
        control.command(Command::Store { program: "O0001".into(), text }, &author).unwrap();
        press(&mut control, "KEY_AUTO", 50);
        control.command(Command::Select { program: "O0001".into() }, &author).unwrap();
        press(&mut control, "KEY_START", 50);
        while !control.outputs().m30 {
            control.tick();
        }
        for key in keys {
            match *key {
                "RESET" => _ = control.command(Command::Reset, &author).unwrap(),
                key => press(&mut control, key, 50),
            }
        }
        wait(&mut control, 3000);
        assert_eq!(control.status().activity, Activity::Idle, "{keys:?}");
        control.cnc().interpreter().memory().variables.get(500)
    };
    assert_eq!(runs_of(&[]), Some(1.0));
    assert_eq!(runs_of(&["KEY_START"]), Some(2.0));
    assert_eq!(runs_of(&["KEY_START", "KEY_START"]), Some(2.0));
    assert_eq!(runs_of(&["KEY_START", "RESET"]), Some(1.0));
    assert_eq!(runs_of(&["KEY_START", "KEY_MDI", "KEY_AUTO"]), Some(1.0));
    assert_eq!(runs_of(&["KEY_START", "KEY_HOLD", "KEY_START"]), Some(1.0));
}

#[test]
fn the_ladder_shifts_the_gears_of_the_spindle_while_it_stands() {
    let mut geared = machine();
    for (name, value) in
        [("P246", 500.0), ("P247", 2000.0), ("P248", 6000.0), ("NO38.0", 1.0), ("NO6.0", 0.0)]
    {
        geared.parameters.insert(name.to_owned(), value);
    }
    let all_speeds = |control: &mut Control| {
        for (name, position) in [("SWITCH_SPINDLE", 5), ("SWITCH_FEED", 10)] {
            let switch = control.plc_mut().unwrap().program().signal(name).unwrap();
            control.plc_mut().unwrap().memory_mut().set_byte(switch, position);
        }
    };
    let mut control = control(&geared);
    set(&mut control, "K_GEARS", true);
    all_speeds(&mut control);
    press(&mut control, "KEY_MDI", 50);
    let author =
        ferrocut_memory::Author::Person { session: ferrocut_memory::Session::OPERATOR, name: "panel".into() };
    let say = |control: &mut Control, text: &str| {
        let mdi = ferrocut_controller::api::Command::Mdi { text: text.into() };
        control.command(mdi, &author).unwrap();
        press(control, "KEY_START", 50);
    };
    let valves = |control: &mut Control| [1, 2, 3].map(|n| is(control, &format!("GEAR_SHIFT_{n}")));
    say(&mut control, "M03 S400\nS3000\nG91 G1 X5 F600\nM05");
    let (mut before, mut shifted, mut cut) = (valves(&mut control), 0, false);
    for _ in 0..30_000 {
        let x = control.status().position.machine[&'X'];
        control.tick();
        let rpm = control.cnc().spindle().actual_rpm();
        let now = valves(&mut control);
        if now.into_iter().zip(before).any(|(now, before)| now && !before) {
            // No fork moves while the spindle turns.
            assert!(rpm.abs() < 1.0, "{rpm} {before:?} {now:?}");
            shifted += 1;
        }
        before = now;
        if control.status().position.machine[&'X'] != x && rpm != 0.0 {
            // Cutting waited for the gear and the speed.
            assert!(is(&mut control, "GEAR_IN_3") && rpm > 2900.0, "{rpm}");
            cut = true;
        }
        if control.cnc().state() == &State::Ended {
            break;
        }
    }
    assert_eq!((control.cnc().state(), shifted > 0, cut), (&State::Ended, true, true));
    assert_eq!(valves(&mut control), [false, false, true]);
    // M41 to M43 with 38#5: codes of the ladder, which the machine file adds to the language.
    let mut chosen = geared.clone();
    chosen.parameters.insert("NO38.5".to_owned(), 1.0);
    for codes in [vec![], vec![41, 42, 43]] {
        let has_them = !codes.is_empty();
        chosen.handshake.m_codes = codes;
        let mut control = self::control(&chosen);
        set(&mut control, "K_GEARS", true);
        all_speeds(&mut control);
        press(&mut control, "KEY_MDI", 50);
        let mut desk = control.desk().interpreter("O1", b"M42\nM30\n".to_vec(), false).unwrap();
        let refused = desk.find_map(Result::err);
        assert_eq!(
            refused.map(|alarm| alarm.id.to_string()),
            (!has_them).then(|| "gsk990mc:0181".to_owned())
        );
        say(&mut control, "M42\nM43\nM02");
        for _ in 0..30_000 {
            control.tick();
            if matches!(control.cnc().state(), State::Ended | State::Alarmed(_)) {
                break;
            }
        }
        assert_eq!(control.cnc().state() == &State::Ended, has_them);
        assert_eq!(valves(&mut control), [false, false, has_them]);
    }
    // 1#2 (part 1, 6.2): S1 to S3 are the gears themselves.
    geared.parameters.insert("NO1.2".to_owned(), 1.0);
    let mut control = self::control(&geared);
    set(&mut control, "K_GEARS", true);
    all_speeds(&mut control);
    press(&mut control, "KEY_MDI", 50);
    say(&mut control, "M03 S2\nG04 X2\nM05");
    let mut fastest = 0.0_f64;
    for _ in 0..30_000 {
        control.tick();
        fastest = fastest.max(control.cnc().spindle().actual_rpm());
        if control.cnc().state() == &State::Ended {
            break;
        }
    }
    assert_eq!(control.cnc().state(), &State::Ended);
    assert!(is(&mut control, "GEAR_IN_2") && (fastest - 2000.0).abs() < 1.0, "{fastest}");
}
