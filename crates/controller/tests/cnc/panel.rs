//! The whole control with the standard ladder and the simulated machine, played through the keys of the panel alone.

use crate::common::panel::Mill;
use ferrocut_controller::api::{Activity, Command, Event, NamedSignal, Reply};
use ferrocut_controller::control::PublicPrograms;
use ferrocut_controller::drives::Block;
use ferrocut_controller::signals::ROWS;
use ferrocut_controller::{Mode, Parts, Plant};
use ferrocut_geometry::Position;
use ferrocut_machine::{Machine, PlantBlock, PlantConfig};
use ferrocut_memory::{Author, Settings, Store};
use ferrocut_plc::Address;
use ferrocut_program::Text;
use serde_json::json;
use std::sync::Arc;

/// A switch has no position behind its last: the ladder would take it for 0 %, or for another.
#[test]
fn a_switch_stands_where_it_can() {
    let mut mill = Mill::power_on();
    for (switch, last) in [("SWITCH_FEED", 20), ("SWITCH_SPINDLE", 7)] {
        let turn = |position| Command::Switch { switch: switch.into(), position };
        mill.say(turn(last));
        for position in [last + 1, 32, 255] {
            let alarm = mill.control.command(turn(position), &Author::Control).unwrap_err().alarm;
            assert_eq!((alarm.id.as_str(), &alarm.values["max"]), ("FC-1409", &last.to_string()), "{switch}");
        }
        assert_eq!(mill.wait(2).panel[switch], last, "{switch}");
    }
}

/// GSK990MC part 2, 3.1.2: S from 0 to P258 is set on the page of positions, in any mode, and keys turn the spindle at
/// it (4.2); one that turns follows at once. A program under way has its own.
#[test]
fn s_is_set_between_programs() {
    let author = Author::Person { session: ferrocut_memory::Session::OPERATOR, name: "panel".into() };
    let mut mill = Mill::power_on();
    mill.home();
    let refused = |mill: &mut Mill, speed: f64| {
        mill.control.command(Command::SpindleSpeed { speed }, &author).unwrap_err().alarm.id
    };
    for impossible in [-1.0, 1e6, f64::NAN] {
        refused(&mut mill, impossible);
    }
    mill.press("KEY_JOG");
    mill.say(Command::SpindleSpeed { speed: 800.0 });
    let status = mill.wait(200);
    assert_eq!((status.spindle.programmed, status.spindle.told), (800.0, 0.0), "it stands");
    mill.press("KEY_SP_CW");
    mill.until("turning", |status| status.spindle.told == 800.0);
    mill.say(Command::SpindleSpeed { speed: 950.0 });
    mill.until("the new speed", |status| status.spindle.told == 950.0);
    mill.press("KEY_SP_STOP");
    mill.until("standing", |status| status.spindle.told == 0.0);
    // A program starts at once behind it and has it in force; the same speed is another then.
    mill.press("KEY_MDI");
    mill.say(Command::Mdi { text: "M3\nG4 X1\nS500\nG4 X1\nM5".into() });
    mill.say(Command::SpindleSpeed { speed: 300.0 });
    mill.key("KEY_START", true);
    mill.wait(60);
    mill.key("KEY_START", false);
    mill.until("turning", |status| status.spindle.told == 300.0);
    assert_eq!(refused(&mut mill, 700.0), "FC-1401");
    mill.until("S of the program", |status| status.spindle.told == 500.0);
    let status = mill.until("done", |status| status.activity == Activity::Idle);
    assert_eq!((status.spindle.programmed, status.spindle.told), (500.0, 0.0));
}

/// A spindle that a program left turning at a speed is told the same speed again where a person changed it between.
#[test]
fn s_that_a_person_set_does_not_hide_that_of_the_next_program() {
    let mut mill = Mill::power_on();
    mill.home();
    mill.mdi("M3 S600\nG4 X0.1");
    mill.until("turning", |status| status.spindle.told == 600.0 && status.activity == Activity::Idle);
    mill.say(Command::SpindleSpeed { speed: 900.0 });
    mill.until("the new speed", |status| status.spindle.told == 900.0);
    mill.mdi("M3 S600\nG4 X0.1");
    mill.until("told again", |status| status.spindle.told == 600.0);
}

#[test]
fn a_shift_through_the_keys() {
    let mut mill = Mill::power_on();
    mill.press("KEY_EDIT");
    assert_eq!(mill.wait(1).mode, Mode::Edit);
    assert!(mill.wait(1).referenced.is_empty() || !mill.wait(1).referenced.contains(&'X'));

    // Every axis to its reference point; the lamps tell.
    let status = mill.home();
    assert!(status.lamps.contains(&"LAMP_HOME".to_owned()), "{:?}", status.lamps);

    // Jog, with a lamp for the mode.
    mill.press("KEY_JOG");
    let before = mill.wait(1).position.machine[&'X'];
    mill.key("KEY_X-", true);
    mill.wait(600);
    mill.key("KEY_X-", false);
    let status = mill.until("at rest", |status| status.activity == Activity::Idle);
    assert!(status.position.machine[&'X'] < before - 5.0, "{before} {:?}", status.position);

    // MDI: the spindle by the ladder.
    mill.press("KEY_MDI");
    mill.say(Command::Mdi { text: "M3 S600\nG4 X1\nM5".into() });
    mill.press("KEY_START");
    mill.until("turning", |status| status.spindle.told == 600.0);
    let status = mill.until("done", |status| status.activity == Activity::Idle);
    assert_eq!(status.spindle.told, 0.0);

    // AUTO with hold and single block.
    mill.press("KEY_AUTO");
    let text = "G91 G1 X-20 F1200\nX-5\nM30\n".to_owned();
    mill.say(Command::Store { program: "O0001".into(), text });
    mill.say(Command::Select { program: "O1".into() });
    let from = mill.wait(1).position.machine[&'X'];
    mill.press("KEY_START");
    mill.wait(200);
    mill.press("KEY_HOLD");
    let status = mill.until("held", |status| status.activity == Activity::Held && status.feed.actual == 0.0);
    assert!(status.lamps.contains(&"LAMP_HOLD".to_owned()), "{:?}", status.lamps);
    mill.press("KEY_SINGLE");
    mill.press("KEY_START");
    let status = mill.until("at the end of the block", |status| status.activity == Activity::BlockEnd);
    assert!((status.position.machine[&'X'] - from + 20.0).abs() < 1e-9);
    mill.press("KEY_SINGLE");
    mill.press("KEY_START");
    let status = mill.until("done", |status| status.activity == Activity::Idle);
    assert_eq!(status.counters.parts, 1);
    assert!((status.position.machine[&'X'] - from + 25.0).abs() < 1e-9);

    // Emergency stop in a cut; nothing moves until it is released and reset.
    mill.press("KEY_START");
    mill.wait(200);
    mill.say(Command::EmergencyStop { pressed: true });
    let status = mill.wait(300);
    assert_eq!((status.activity, status.feed.actual), (Activity::Emergency, 0.0));
    mill.press("KEY_START");
    assert_eq!(mill.wait(100).position.machine, status.position.machine);
    mill.say(Command::EmergencyStop { pressed: false });
    mill.wait(50);
    mill.say(Command::Reset);
    mill.until("well", |status| status.activity == Activity::Idle && status.alarms.is_empty());
}

/// GSK990MC part 2, 6.4.
/// Signals of the machine that are on, among some.
fn on<'a>(mill: &mut Mill, names: &[&'a str]) -> Vec<&'a str> {
    let plc = mill.control.plc_mut().unwrap();
    let is_on = |name: &&&str| plc.memory().bit(plc.program().signal(name).unwrap());
    names.iter().filter(is_on).copied().collect()
}

const MODES: [(&str, Mode); 8] = [
    ("KEY_EDIT", Mode::Edit),
    ("KEY_AUTO", Mode::Auto),
    ("KEY_MDI", Mode::Mdi),
    ("KEY_DNC", Mode::Dnc),
    ("KEY_HOME", Mode::Home),
    ("KEY_JOG", Mode::Jog),
    ("KEY_STEP", Mode::Step),
    ("KEY_MPG", Mode::Handle),
];

/// 4.3: coolant, chip conveyor and light turn over with their keys in any mode; lubrication runs while its key is held.
#[test]
fn keys_of_the_auxiliaries_act_in_any_mode() {
    let mut mill = Mill::power_on();
    let lamp = |mill: &mut Mill, lamp: &str| mill.wait(1).lamps.iter().any(|name| name == lamp);
    for (key, mode) in MODES {
        mill.press(key);
        assert_eq!(mill.wait(10).mode, mode);
        for (key, output, light) in [
            ("KEY_COOLANT", "COOLANT", "LAMP_COOLANT"),
            ("KEY_CHIP", "CONVEYOR", "LAMP_CHIP"),
            ("KEY_LIGHT", "LIGHT", "LAMP_LIGHT"),
        ] {
            for is_on in [true, false] {
                mill.press(key);
                assert_eq!(on(&mut mill, &[output]).len() == 1, is_on, "{key} in {mode:?}");
                assert_eq!(lamp(&mut mill, light), is_on, "{key} in {mode:?}");
            }
        }
        for is_down in [true, false] {
            mill.key("KEY_LUBE", is_down);
            assert_eq!(on(&mut mill, &["LUBE"]).len() == 1, is_down, "{mode:?}");
            assert_eq!(lamp(&mut mill, "LAMP_LUBE"), is_down, "{mode:?}");
        }
    }
}

/// M codes of what stands about the axes reach it and are done; reset ends them, and the end of a program all but the
/// conveyor. What is missing ends its own.
#[test]
fn codes_of_the_auxiliaries_reach_the_machine() {
    let mut mill = Mill::power_on();
    const ALL: [&str; 6] = ["COOLANT", "FLUSH", "CONVEYOR", "BLOW", "A_RELEASE", "A_CLAMP"];
    assert_eq!(on(&mut mill, &ALL), ["A_CLAMP"]);
    for (code, outputs) in [
        ("M08", &["COOLANT", "A_CLAMP"][..]),
        ("M09", &["A_CLAMP"]),
        ("M26", &["FLUSH", "A_CLAMP"]),
        ("M27", &["A_CLAMP"]),
        ("M35", &["CONVEYOR", "A_CLAMP"]),
        ("M36", &["A_CLAMP"]),
        ("M44", &["BLOW", "A_CLAMP"]),
        ("M45", &["A_CLAMP"]),
        ("M10", &["A_RELEASE"]),
        ("M11", &["A_CLAMP"]),
    ] {
        mill.mdi(code);
        assert_eq!(on(&mut mill, &ALL), outputs, "{code}");
        // The codes of the A axis are done once it is so.
        let clamps = on(&mut mill, &["A_CLAMPED", "A_LOOSE"]);
        assert_eq!(clamps, [if code == "M10" { "A_LOOSE" } else { "A_CLAMPED" }], "{code}");
    }
    let begin = "M08\nM26\nM35\nM44";
    mill.mdi(begin);
    mill.say(Command::Reset);
    mill.wait(300);
    assert_eq!(on(&mut mill, &ALL), ["A_CLAMP"]);
    mill.mdi(&format!("{begin}\nM30"));
    mill.wait(300);
    assert_eq!(on(&mut mill, &ALL), ["CONVEYOR", "A_CLAMP"]);
    // An empty tank, a jammed conveyor, no air.
    mill.mdi(begin);
    let inputs = ["COOLANT_LEVEL", "CONVEYOR_OK", "AIR_PRESSURE"];
    for input in inputs {
        force(&mut mill, input, Some(false));
    }
    assert_eq!(on(&mut mill, &ALL), ["A_CLAMP"]);
    let messages = mill.wait(20).messages;
    assert_eq!(messages, ["MSG_AIR", "MSG_COOLANT", "MSG_CONVEYOR"]);
    inputs.iter().for_each(|input| force(&mut mill, input, None));
    assert_eq!(mill.wait(20).messages, [""; 0]);
}

/// An input stands as it is told, whatever the machine says.
fn force(mill: &mut Mill, signal: &str, value: Option<bool>) {
    mill.control.command(Command::Force { signal: signal.into(), value }, &Author::Control).unwrap();
    mill.wait(20);
}

/// Interlocks hold a block that a change of mode is finishing: the key alone has no effect there (2.4 notes 1 to 4).
#[test]
fn the_door_holds_a_block_that_is_being_finished() {
    for (key, signal) in [("KEY_EDIT", "DOOR_CLOSED"), ("KEY_MDI", "DRIVE_OK"), ("KEY_DNC", "DOOR_CLOSED")] {
        let mut mill = Mill::power_on();
        mill.home();
        mill.press("KEY_AUTO");
        let text = "M3 S600\nG91 G1 X-40 F600\nX-5\nM30\n".to_owned();
        mill.say(Command::Store { program: "O0001".into(), text });
        mill.say(Command::Select { program: "O1".into() });
        mill.press("KEY_START");
        mill.until("cutting", |status| status.feed.actual > 500.0);
        mill.press(key);
        mill.press("KEY_HOLD");
        assert!(mill.wait(300).feed.actual > 500.0, "the key is none here");
        force(&mut mill, signal, Some(false));
        let held = mill.wait(500);
        assert_eq!(held.feed.actual, 0.0, "{key} {signal}");
        assert!(held.position.to_go[&'X'].abs() > 5.0);
        force(&mut mill, signal, None);
        assert_eq!(mill.wait(500).position.machine, held.position.machine);
        // It goes on in its own mode, once the spindle turns.
        mill.press("KEY_JOG");
        mill.press("KEY_SP_CW");
        mill.until("turning", |status| (status.spindle.actual.abs() - 600.0).abs() < 1.0);
        mill.press("KEY_AUTO");
        mill.press("KEY_START");
        let done = mill.until("done", |status| status.activity == Activity::Idle);
        assert_eq!(done.counters.parts, 1);
    }
}

/// The door is locked while a program runs; one that opens all the same holds the axes, stops the spindle and locks
/// cycle start, and nothing starts when it is closed.
#[test]
fn the_door_holds_the_program_and_locks_the_start() {
    let mut mill = Mill::power_on();
    mill.home();
    mill.press("KEY_AUTO");
    let text = "M3 S600\nG91 G1 X-40 F600\nM30\n".to_owned();
    mill.say(Command::Store { program: "O0001".into(), text });
    mill.say(Command::Select { program: "O1".into() });
    assert_eq!(on(&mut mill, &["DOOR_LOCK", "STLK"]), [""; 0]);
    // Open: nothing starts.
    force(&mut mill, "DOOR_CLOSED", Some(false));
    mill.press("KEY_START");
    assert_eq!((mill.wait(100).activity, on(&mut mill, &["STLK"])), (Activity::Idle, vec!["STLK"]));
    force(&mut mill, "DOOR_CLOSED", None);
    mill.press("KEY_START");
    mill.until("cutting", |status| status.feed.actual > 500.0);
    assert_eq!(on(&mut mill, &["DOOR_LOCK", "SPINDLE_CW"]), ["DOOR_LOCK", "SPINDLE_CW"]);
    force(&mut mill, "DOOR_CLOSED", Some(false));
    let held = mill.until("held", |status| status.activity == Activity::Held && status.feed.actual == 0.0);
    mill.until("standing", |status| status.spindle.actual.abs() < 0.5);
    assert_eq!(on(&mut mill, &["SPINDLE_CW", "MSG_DOOR", "STLK"]), ["MSG_DOOR", "STLK"]);
    assert!(mill.wait(1).messages.contains(&"MSG_DOOR".to_owned()));
    mill.press("KEY_START");
    force(&mut mill, "DOOR_CLOSED", None);
    let closed = mill.wait(300);
    assert_eq!((closed.activity, &closed.position.machine), (Activity::Held, &held.position.machine));
    assert_eq!((closed.spindle.actual.round(), on(&mut mill, &["SPINDLE_CW"])), (0.0, vec![]));
    // Cycle start goes on once the operator has turned the spindle on.
    assert_eq!(refused_start(&mut mill), ["FC-1417"]);
    assert_eq!(
        (mill.wait(300).activity, mill.wait(1).position.machine),
        (Activity::Held, held.position.machine)
    );
    for key in ["KEY_JOG", "KEY_SP_CW", "KEY_AUTO", "KEY_START"] {
        mill.press(key);
    }
    let done = mill.until("done", |status| status.activity == Activity::Idle);
    assert_eq!(done.counters.parts, 1);
    mill.wait(1000);
    assert_eq!(on(&mut mill, &["DOOR_LOCK"]), [""; 0]);
}

/// A spindle that turned before the program began is the program's too: it cuts with none that stands, or turns the other
/// way.
#[test]
fn a_program_that_found_the_spindle_turning_does_not_go_on_without_it() {
    for (turned_by, program) in [
        ("M3 S500", "G90 G1 X-80 F300\nX-60\nM30\n"),
        ("M3 S500", "M3 S500\nG90 G1 X-80 F300\nX-60\nM30\n"),
        ("", "M3 S500\nG90 G1 X-80 F300\nX-60\nM30\n"),
    ] {
        for other_way in [false, true] {
            let mut mill = Mill::power_on();
            mill.home();
            if !turned_by.is_empty() {
                mill.mdi(turned_by);
            }
            mill.press("KEY_AUTO");
            mill.say(Command::Store { program: "O0001".into(), text: program.to_owned() });
            mill.say(Command::Select { program: "O1".into() });
            mill.press("KEY_START");
            mill.until("cutting", |status| status.feed.actual > 290.0);
            ["KEY_HOLD", "KEY_JOG", "KEY_SP_STOP"].iter().for_each(|key| mill.press(key));
            if other_way {
                mill.press("KEY_SP_CCW");
            }
            mill.press("KEY_AUTO");
            let held = mill.wait(1500);
            assert_eq!(refused_start(&mut mill), ["FC-1417"], "{turned_by} {program} {other_way}");
            assert_eq!(mill.wait(500).position.machine, held.position.machine);
            for key in ["KEY_JOG", "KEY_SP_STOP", "KEY_SP_CW", "KEY_AUTO", "KEY_START"] {
                mill.press(key);
            }
            mill.until("done", |status| status.activity == Activity::Idle);
        }
    }
}

/// 4.2: the keys reach the spindle by way of the ladder only, which lets it turn with door, drive and clamp in order.
#[test]
fn the_keys_of_the_spindle_turn_it_only_where_the_ladder_lets_it() {
    let mut mill = Mill::power_on();
    mill.mdi("M3 S600\nM5");
    mill.press("KEY_JOG");
    const KEYS: [&str; 3] = ["KEY_SP_CW", "KEY_SP_CCW", "KEY_SP_ORIENT"];
    for input in ["DOOR_CLOSED", "DRIVE_OK", "TOOL_CLAMPED"] {
        force(&mut mill, input, Some(false));
        for jogs in [false, true] {
            for key in KEYS {
                mill.key(key, true);
                assert_eq!(mill.wait(300).spindle.actual, 0.0, "{key} {input}");
                mill.key(key, false);
            }
            // Jog alone turns it never.
            mill.press("KEY_SP_JOG");
            assert_eq!(on(&mut mill, &["SJOG"]).is_empty(), jogs);
            assert_eq!((mill.wait(300).spindle.told, mill.wait(1).spindle.actual), (0.0, 0.0), "{input}");
        }
        force(&mut mill, input, None);
    }
    // In order, each does its own.
    for (key, told) in [("KEY_SP_CW", 600.0), ("KEY_SP_CCW", -600.0)] {
        mill.press(key);
        let status = mill.wait(500);
        assert_eq!((status.spindle.told, status.spindle.actual.round()), (600.0, told), "{key}");
        mill.press("KEY_SP_STOP");
        assert_eq!(mill.wait(500).spindle.actual, 0.0);
    }
    mill.press("KEY_SP_JOG");
    assert_eq!(mill.wait(300).spindle.actual, 0.0);
    mill.key("KEY_SP_CCW", true);
    let jogged = mill.wait(300).spindle.actual;
    let jog_rpm = match mill.say(Command::Parameters { names: vec!["P242".into()] }) {
        Reply::Parameters { parameters, .. } => parameters["P242"],
        other => panic!("{other:?}"),
    };
    assert_eq!(jogged.round(), -jog_rpm);
    mill.key("KEY_SP_CCW", false);
    assert_eq!(mill.wait(300).spindle.actual, 0.0);
    mill.press("KEY_SP_JOG");
    mill.press("KEY_SP_ORIENT");
    mill.wait(500);
    assert_eq!(on(&mut mill, &["ORARA", "LAMP_SP_ORIENT"]), ["ORARA", "LAMP_SP_ORIENT"]);
}

/// An S that a program gives alone starts no spindle that keys or a lock left standing, and turns none round (3.1.2, 7.8).
#[test]
fn s_alone_turns_no_spindle() {
    let mut mill = Mill::power_on();
    mill.home();
    mill.mdi("M3 S300");
    mill.press("KEY_JOG");
    mill.press("KEY_SP_STOP");
    mill.until("standing", |status| status.spindle.actual == 0.0);
    mill.mdi("S600");
    assert_eq!(mill.wait(500).spindle.actual, 0.0);
    mill.press("KEY_JOG");
    mill.press("KEY_SP_CCW");
    mill.until("turning", |status| status.spindle.actual.round() == -600.0);
    mill.mdi("S450");
    mill.until("the new speed", |status| status.spindle.actual.round() == -450.0);
    mill.mdi("M5");
    mill.press("KEY_AUXLOCK");
    mill.mdi("M3 S500");
    mill.press("KEY_AUXLOCK");
    mill.mdi("S600");
    assert_eq!(mill.wait(500).spindle.actual, 0.0);
}

/// Behind a restart that sends the code of the spindle the program knows that it turns: an S counts, and a cycle that stops
/// it starts it again.
#[test]
fn a_program_taken_up_knows_that_its_spindle_turns() {
    for (behind, told) in [("S2000\nG1 X60", 2000.0), ("G86 X50 Z-5 R2 F600\nG80\nG1 X80 F600", 1000.0)] {
        let mut mill = Mill::power_on();
        mill.home();
        let text = format!("O1\nG54 G90 G0 X0\nM3 S1000\nG1 X40 F600\n{behind}\nM0\nM5\nM30\n");
        mill.press("KEY_EDIT");
        mill.say(Command::Store { program: "O0001".into(), text });
        mill.say(Command::Select { program: "O1".into() });
        mill.press("KEY_AUTO");
        mill.press("KEY_START");
        mill.until("cutting", |status| status.position.machine[&'X'] > 10.0);
        mill.say(Command::Reset);
        mill.until("the spindle stands", |status| status.spindle.actual == 0.0);
        mill.press("KEY_AUTO");
        mill.say(Command::Restart { line: None, pass: 1, file: None, sends: true, axis_by_axis: false });
        for _ in 0..2000 {
            std::thread::sleep(std::time::Duration::from_millis(1));
            if mill.wait(1).restart_ready {
                break;
            }
        }
        mill.press("KEY_START");
        let status = mill.until("M00", |status| status.activity == Activity::Stopped);
        assert_eq!((status.spindle.told, status.spindle.actual.round()), (told, told), "{behind}");
    }
}

/// What cycle start is refused for.
fn refused_start(mill: &mut Mill) -> Vec<String> {
    mill.events.clear();
    mill.press("KEY_START");
    let refused = mill.events.iter().filter_map(|event| match event {
        Event::Refused { alarm } => Some(alarm.id.clone()),
        _ => None,
    });
    refused.collect()
}

/// A mill that cuts along X with its spindle turning.
fn cutting(text: &str) -> Mill {
    let mut mill = Mill::power_on();
    mill.home();
    mill.press("KEY_AUTO");
    mill.say(Command::Store { program: "O0001".into(), text: text.into() });
    mill.say(Command::Select { program: "O1".into() });
    mill.press("KEY_START");
    mill.until("cutting", |status| status.feed.actual > 500.0);
    mill
}

const CUT: &str = "M3 S600\nG91 G1 X-60 F600\nM8\nX-5\nM30\n";

/// Whatever stopped the spindle beside the program: cycle start does not go on cutting with one that stands.
#[test]
fn a_program_goes_on_only_with_the_spindle_as_it_has_it() {
    type Stop = fn(&mut Mill);
    let hold = |mill: &mut Mill| mill.press("KEY_HOLD");
    let drive = |mill: &mut Mill| {
        force(mill, "DRIVE_OK", Some(false));
        mill.wait(100);
        force(mill, "DRIVE_OK", None);
    };
    let clamp = |mill: &mut Mill| {
        force(mill, "TOOL_CLAMPED", Some(false));
        mill.wait(500);
        force(mill, "TOOL_CLAMPED", None);
    };
    let key = |mill: &mut Mill| {
        ["KEY_HOLD", "KEY_JOG", "KEY_SP_STOP", "KEY_AUTO"].iter().for_each(|key| mill.press(key))
    };
    let other = |mill: &mut Mill| {
        ["KEY_HOLD", "KEY_JOG", "KEY_SP_STOP", "KEY_SP_CCW", "KEY_AUTO"]
            .iter()
            .for_each(|key| mill.press(key))
    };
    let stops: [(&str, Stop, bool); 5] = [
        ("hold", hold, true),
        ("drive", drive, false),
        ("clamp", clamp, false),
        ("key", key, false),
        ("the other way", other, false),
    ];
    for (name, stop, goes_on) in stops {
        let mut mill = cutting(CUT);
        stop(&mut mill);
        let held = mill.wait(1500);
        assert_eq!((held.activity, held.feed.actual), (Activity::Held, 0.0), "{name}");
        let refused = refused_start(&mut mill);
        let status = mill.wait(300);
        match goes_on {
            true => assert_eq!((status.activity, refused), (Activity::Running, vec![]), "{name}"),
            false => {
                assert_eq!(
                    (status.activity, refused),
                    (Activity::Held, vec!["FC-1417".to_owned()]),
                    "{name}"
                );
                assert_eq!(status.position.machine, held.position.machine, "{name}");
                for key in ["KEY_JOG", "KEY_SP_STOP", "KEY_SP_CW", "KEY_AUTO", "KEY_START"] {
                    mill.press(key);
                }
            }
        }
        let slowest = std::cell::Cell::new(f64::MAX);
        mill.until("done", |status| {
            if status.feed.actual > 100.0 {
                slowest.set(slowest.get().min(status.spindle.actual));
            }
            status.activity == Activity::Idle
        });
        assert!(slowest.get() > 500.0 && mill.wait(1).counters.parts == 1, "{name}: {slowest:?}");
    }
}

/// Where nobody cuts, or the program wants it to stand, a spindle at rest is none of cycle start's business.
#[test]
fn a_spindle_that_may_stand_refuses_no_start() {
    for (switches, text) in [
        (&["KEY_MLOCK"][..], CUT),
        (&["KEY_AUXLOCK"], CUT),
        (&["KEY_DRY"], CUT),
        (&[], "M3 S600\nM5\nG91 G1 X-60 F600\nM30\n"),
        (&[], "M3 S600\nM19\nG91 G1 X-60 F600\nM30\n"),
        // The ladder stops it for rigid tapping.
        (&[], "M3 S600\nM29 S300\nG91 G99 G84 X-60 Z-3 R-1 F300\nG80\nM28\nM30\n"),
    ] {
        let mut mill = Mill::power_on();
        mill.home();
        mill.press("KEY_AUTO");
        switches.iter().for_each(|key| mill.press(key));
        mill.say(Command::Store { program: "O0001".into(), text: text.into() });
        mill.say(Command::Select { program: "O1".into() });
        mill.press("KEY_START");
        mill.until("cutting", |status| status.feed.actual > 500.0);
        for key in ["KEY_HOLD", "KEY_JOG", "KEY_SP_STOP", "KEY_AUTO"] {
            mill.press(key);
        }
        let held = mill.wait(500);
        assert_eq!((held.activity, held.spindle.told), (Activity::Held, 0.0), "{switches:?} {text}");
        assert_eq!(refused_start(&mut mill), [""; 0], "{switches:?} {text}");
        mill.until("done", |status| status.counters.parts == 1 && status.activity == Activity::Idle);
    }
}

/// It comes and goes between programs alone: a key that is pressed in one locks nothing, then or later.
#[test]
fn the_key_of_machine_lock_does_nothing_while_a_program_is_under_way() {
    let mut mill = Mill::power_on();
    mill.home();
    mill.press("KEY_AUTO");
    mill.say(Command::Store { program: "O0001".into(), text: CUT.into() });
    mill.say(Command::Select { program: "O1".into() });
    mill.press("KEY_START");
    mill.until("cutting", |status| status.feed.actual > 500.0);
    mill.press("KEY_MLOCK");
    mill.press("KEY_HOLD");
    mill.press("KEY_MLOCK");
    mill.press("KEY_MLOCK");
    assert_eq!(mill.wait(300).activity, Activity::Held);
    mill.press("KEY_START");
    mill.until("done", |status| status.counters.parts == 1 && status.activity == Activity::Idle);
    assert!(!mill.wait(100).switches.machine_lock && !mill.control.cnc().is_locked());
    mill.press("KEY_MLOCK");
    assert!(mill.wait(100).switches.machine_lock && mill.control.cnc().is_locked());
}

#[test]
fn no_axis_is_sent_to_its_reference_point_under_machine_lock() {
    let mut mill = Mill::power_on();
    mill.home();
    // Away from the point, on which it would have arrived at once.
    mill.press("KEY_JOG");
    mill.key("KEY_X-", true);
    mill.wait(600);
    mill.key("KEY_X-", false);
    mill.wait(600);
    mill.press("KEY_HOME");
    mill.press("KEY_MLOCK");
    mill.events.clear();
    mill.press("KEY_X+");
    let status = mill.wait(100);
    let refused = |event: &&Event| matches!(event, Event::Refused { alarm } if alarm.id == "FC-1494");
    assert_eq!((mill.events.iter().filter(refused).count(), status.activity), (1, Activity::Idle));
    mill.press("KEY_MLOCK");
    mill.events.clear();
    mill.press("KEY_X+");
    assert_eq!((mill.events.iter().filter(refused).count(), mill.control.cnc().is_homing()), (0, true));
}

#[test]
fn the_handwheel_drives_a_program() {
    let mut mill = Mill::power_on();
    mill.home();
    mill.press("KEY_R_100");
    mill.press("KEY_AUTO");
    let text = "G91 G1 X-60 F1200\nG0 Y-10\nG1 X-4\nM30\n".to_owned();
    mill.say(Command::Store { program: "O0001".into(), text });
    mill.say(Command::Select { program: "O1".into() });
    mill.press("KEY_DRY");
    mill.press("KEY_HDRV");
    assert!(mill.wait(1).lamps.contains(&"LAMP_HDRV".to_owned()));
    let from = mill.wait(1).position.machine;
    mill.press("KEY_START");
    // Runs, and stands: neither time nor a wheel that is turned back moves an axis.
    for counts in [0, -5] {
        for _ in 0..100 {
            mill.say(Command::Handwheel { counts });
            mill.wait(10);
        }
        let status = mill.wait(1);
        assert_eq!((status.activity, &status.position.machine), (Activity::Running, &from));
    }
    // Turned twice as fast, it goes twice as fast; the rated speed is the programmed one.
    let turn = |mill: &mut Mill, counts: i32, times: usize| {
        let mut fastest: f64 = 0.0;
        for _ in 0..times {
            mill.say(Command::Handwheel { counts });
            fastest = fastest.max(mill.wait(10).feed.actual);
        }
        fastest
    };
    let slow = turn(&mut mill, 0, 1).max(turn(&mut mill, 1, 50));
    // The wheel stands: so does the program.
    turn(&mut mill, 0, 200);
    let stood = mill.wait(1).position.machine;
    assert_eq!(mill.wait(500).position.machine, stood);
    assert_ne!(stood, from);
    mill.press("KEY_SINGLE");
    let fast = turn(&mut mill, 2, 40);
    assert!(slow > 1000.0 && slow < 1400.0 && fast > 1.5 * slow, "{slow} {fast}");
    // Note 2: single block holds at its end, whatever the wheel does.
    turn(&mut mill, 1, 600);
    let status = mill.wait(1);
    assert_eq!(status.activity, Activity::BlockEnd);
    assert!((status.position.machine[&'X'] - from[&'X'] + 60.0).abs() < 1e-9);
    assert_eq!(status.position.machine[&'Y'], from[&'Y']);
    mill.wait(500);
    mill.press("KEY_SINGLE");
    mill.press("KEY_START");
    assert_eq!(mill.wait(500).position.machine[&'Y'], from[&'Y'], "positioning waits for the wheel, too");
    for _ in 0..1000 {
        turn(&mut mill, 1, 10);
        if mill.wait(1).activity == Activity::Idle {
            break;
        }
    }
    let at = mill.wait(1).position.machine;
    assert_eq!(mill.wait(1).counters.parts, 1);
    assert!((at[&'X'] - from[&'X'] + 64.0).abs() < 1e-9 && (at[&'Y'] - from[&'Y'] + 10.0).abs() < 1e-9);
    // Without it, dry run is what it was.
    mill.press("KEY_HDRV");
    mill.press("KEY_START");
    mill.until("done", |status| status.counters.parts == 2 && status.activity == Activity::Idle);
}

/// Signals that this machine has no cause to give, and where they are tried.
const NOT_HERE: [(&str, &str); 3] = [
    ("BF", "only M802 and M903 of Weihong have a number beside them; weihong.rs"),
    ("B_CODE", "the same"),
    ("ALMA", "control.rs: drives that failed"),
];

/// Nothing of what the ladder may be told is forgotten.
#[test]
fn every_signal_of_the_nc_is_told_once() {
    let mut machine = Machine::demo_mill();
    for (name, value) in [("P357", 1.0), ("NO61.0", 1.0)] {
        machine.parameters.insert(name.to_owned(), value);
    }
    let mut mill = Mill::of(&machine, Plant::new(&machine, Position::ZERO, Position::ZERO), None);
    mill.home();
    for key in ["KEY_EDIT", "KEY_DNC", "KEY_JOG", "KEY_STEP", "KEY_MPG"] {
        mill.press(key);
        mill.wait(10);
    }
    let goes_on = |mill: &mut Mill, times: usize| {
        for _ in 0..times {
            mill.until("stopped", |status| status.activity == Activity::Stopped);
            mill.press("KEY_START");
        }
        mill.until("done", |status| status.activity == Activity::Idle);
    };
    // Codes, stops, tapping, surface speed, outputs, reference points.
    mill.press("KEY_MDI");
    mill.press("KEY_OPTSTOP");
    let text = "G91 G0 Z-20\nG1 X-5 F1000\nT1\nM3 S300\nM0\nM1\nM19\nM18\n#1100=1\nG96 P1 S20000\nM3\nG4 X0.1\nG97 S300\n\
                M29 S300\nG98 G84 X0 Y0 Z-3 R-1 F300\nG80\nM28\nM5\nG90\nG30 P2 Z0\nG30 P3 Z0\nG30 P4 Z0\nM2\n";
    mill.say(Command::Mdi { text: text.into() });
    mill.press("KEY_START");
    goes_on(&mut mill, 2);
    // A program with switches, hold, restart.
    mill.press("KEY_AUTO");
    for (name, text) in [("O0001", "M30\n"), ("O0002", "G91 G1 X-20 F600\nX20\nM30\n")] {
        mill.say(Command::Store { program: name.into(), text: text.into() });
    }
    mill.say(Command::Select { program: "O1".into() });
    let switches = ["KEY_SINGLE", "KEY_SKIP", "KEY_DRY", "KEY_MLOCK", "KEY_AUXLOCK"];
    switches.iter().for_each(|key| mill.press(key));
    switches.iter().for_each(|key| mill.press(key));
    mill.press("KEY_START");
    mill.until("a part", |status| status.counters.parts == 1 && status.activity == Activity::Idle);
    mill.say(Command::Select { program: "O2".into() });
    mill.press("KEY_START");
    mill.press("KEY_HOLD");
    mill.until("held", |status| status.activity == Activity::Held);
    mill.say(Command::EmergencyStop { pressed: true });
    mill.wait(500);
    mill.say(Command::EmergencyStop { pressed: false });
    force(&mut mill, "G8.6", Some(true));
    force(&mut mill, "G8.6", None);
    mill.until("well", |status| status.activity == Activity::Idle && status.alarms.is_empty());
    mill.events.clear();
    // The reset signal lasts (P203).
    mill.wait(300);
    mill.press("KEY_RESTART");
    for _ in 0..5000 {
        if mill.wait(1).restart_ready {
            break;
        }
        std::thread::sleep(std::time::Duration::from_millis(1));
    }
    assert!(mill.wait(1).restart_ready, "{:?}", mill.events);
    let exceptions = NOT_HERE.map(|(name, _)| name);
    let forgotten = ROWS.iter().filter(|row| !row.is_read() && !mill.told.contains(row.names[0]));
    assert_eq!(forgotten.map(|row| row.names[0]).collect::<Vec<_>>(), exceptions);
}

const BRACKET: &str = include_str!("../../../../examples/gsk990mc/bracket.nc");
const TOOL_CHANGE: &str = include_str!("../../../../machines/tool-change.nc");

/// A mill of which nothing was stored, homed; with what comes with it.
fn fresh(machine: &Machine, parts: Parts) -> Mill {
    let plant = Plant::new(machine, Position::ZERO, Position::ZERO);
    let parts = Parts { drives: Some(Box::new(plant)), ..parts };
    let mut mill = Mill::with_ladder(machine, crate::common::panel::LADDER, parts);
    mill.say(Command::Switch { switch: "SWITCH_FEED".into(), position: 10 });
    mill.say(Command::Switch { switch: "SWITCH_SPINDLE".into(), position: 5 });
    mill.wait(100);
    mill.press("KEY_R_100");
    mill.home();
    mill
}

fn with_tool_change() -> Parts {
    Parts { tool_change: Some(TOOL_CHANGE.into()), ..Parts::default() }
}

/// The tool that is in the spindle of the machine, and the one that the control says.
fn tools(mill: &mut Mill) -> (u32, u32) {
    let shown = mill.control.status().spindle.tool;
    let (tool, _) = mill.control.plant_mut().unwrap().tool_and_pocket();
    (tool, shown)
}

/// The tool change comes with the machine (GSK990MC 8.1): nothing is stored for it. One of the memory goes before.
#[test]
fn a_fresh_control_changes_the_tool() {
    let mut mill = fresh(&Machine::demo_mill(), with_tool_change());
    mill.mdi("T2 M06");
    assert_eq!(tools(&mut mill), (2, 2));
    mill.press("KEY_EDIT");
    let text = "O0001\nT3 M06\nM30\n".to_owned();
    mill.say(Command::Store { program: "O0001".into(), text });
    let Reply::Programs { programs, .. } = mill.say(Command::Programs) else { panic!() };
    assert_eq!(programs.iter().map(|program| program.name.as_str()).collect::<Vec<_>>(), ["O0001"]);
    let shown = Reply::Program { program: "O9001".into(), text: TOOL_CHANGE.into() };
    assert_eq!(mill.say(Command::Read { program: "O9001".into() }), shown);
    mill.press("KEY_AUTO");
    mill.say(Command::Select { program: "O0001".into() });
    mill.press("KEY_START");
    mill.until("changed", |status| status.counters.parts == 1 && status.activity == Activity::Idle);
    assert_eq!(tools(&mut mill), (3, 3));

    // A change by hand, as the shop has it.
    let own = "O9001\n#510=#510+1\nM06\nM99\n".to_owned();
    mill.press("KEY_EDIT");
    mill.say(Command::Store { program: "O9001".into(), text: own.clone() });
    let shown = Reply::Program { program: "O9001".into(), text: own };
    assert_eq!(mill.say(Command::Read { program: "O9001".into() }), shown);
    mill.mdi("T4 M06");
    let Reply::Variables { variables } = mill.say(Command::Variables { from: 510, to: 510 }) else {
        panic!()
    };
    assert_eq!(variables[&510], 1.0);
    assert_eq!(tools(&mut mill), (3, 4), "the magazine did nothing");
    let plant = mill.control.plant_mut().unwrap();
    let (_, pocket) = plant.tool_and_pocket();
    plant.stand_with(4, pocket);
    mill.press("KEY_EDIT");
    mill.say(Command::Delete { program: "O9001".into() });
    mill.mdi("T5 M06");
    assert_eq!(tools(&mut mill), (5, 5));
}

/// GSK990MC alarm 0078: whoever went on would cut with another tool than the one that was called.
#[test]
fn a_tool_change_without_its_program_is_an_alarm() {
    let mut machine = Machine::demo_mill();
    for (dialect, wanted) in [("gsk990mc", "gsk990mc:0078"), ("kaitong", "FC-0602"), ("rs274", "FC-0622")] {
        machine.dialect = dialect.to_owned();
        let mut mill = fresh(&machine, Parts::default());
        let (tool, _) = tools(&mut mill);
        mill.press("KEY_MDI");
        mill.say(Command::Mdi { text: "T2 M06\nG91 G1 X-5 F500".into() });
        mill.press("KEY_START");
        let status = mill.until("in alarm", |status| status.activity == Activity::Alarm);
        assert_eq!(status.alarms[0].id, wanted);
        assert_eq!(tools(&mut mill), (tool, 0), "{dialect}");
        // The check at the panel says so before.
        let text = b"T2 M06\nM30\n".to_vec();
        let mut checked = mill.control.desk().interpreter("O0001", text, false).unwrap();
        let alarm = checked.find_map(Result::err).unwrap();
        assert_eq!(alarm.id.to_string(), wanted);
    }
}

/// A ladder that changes the tool by M06 itself has it handed over.
#[test]
fn a_ladder_may_change_the_tool_by_itself() {
    let mut machine = Machine::demo_mill();
    machine.tool_change.program = Some(0);
    for dialect in ["gsk990mc", "rs274"] {
        machine.dialect = dialect.to_owned();
        let mut mill = fresh(&machine, with_tool_change());
        mill.mdi("T2 M06");
        let status = mill.wait(10);
        assert_eq!((status.spindle.tool, status.alarms.len()), (2, 0), "{dialect}");
        assert!(mill.told.contains("MF"), "{:?}", mill.told);
    }
}

/// Weihong 5: the program of `public.dat` for M06 is the tool change there.
#[test]
fn a_program_of_the_shop_for_m06_is_the_tool_change() {
    let mut machine = Machine::demo_mill();
    machine.dialect = "weihong".to_owned();
    let text = Text::from_bytes(b"O206\nG91 G00 X-7\nG90\nM06\nM17\n".to_vec()).unwrap();
    let public = Some(PublicPrograms { name: "public.dat".to_owned(), text: Arc::new(text) });
    let mut mill = fresh(&machine, Parts { public, ..Parts::default() });
    let before = mill.wait(1).position.machine[&'X'];
    mill.mdi("T2 M06");
    let status = mill.wait(10);
    assert_eq!((status.spindle.tool, status.alarms.len()), (2, 0));
    assert!((status.position.machine[&'X'] - before + 7.0).abs() < 1e-9, "{status:?}");
}

/// Each time that the control does something else is told once, whatever it was at.
#[test]
fn what_the_control_does_is_told_once() {
    let mut mill = Mill::power_on();
    mill.home();
    let told = |mill: &mut Mill| -> Vec<Activity> {
        mill.wait(300);
        let events = std::mem::take(&mut mill.events).into_iter();
        let activity = |event| match event {
            Event::Activity { activity } => Some(activity),
            _ => None,
        };
        events.filter_map(activity).collect()
    };
    mill.press("KEY_MDI");
    mill.say(Command::Mdi { text: "G91 G1 X-50 F600".into() });
    told(&mut mill);
    mill.press("KEY_START");
    assert_eq!(told(&mut mill), [Activity::Running]);
    for _ in 0..2 {
        mill.say(Command::EmergencyStop { pressed: true });
        assert_eq!(told(&mut mill), [Activity::Emergency], "in a move, and at rest");
        mill.say(Command::EmergencyStop { pressed: false });
        assert_eq!(told(&mut mill), [Activity::Idle]);
    }
}

/// The setter: X, Y, and Z where a tool of no length touches it. Diameter of setter and probe.
const SETTER: [f64; 3] = [200.0, 100.0, -300.0];
const BALL: f64 = 2.0;
/// The first tool, and the bore that the zero is measured by.
const LENGTH: f64 = 90.0;
const CENTRE: [f64; 2] = [12.3, -7.8];
const RADIUS: f64 = 15.0;

/// The setter with the first tool over it, and the bore as the middle of the probe meets it on the lines through its
/// centre.
fn things() -> Vec<Block> {
    let [x, y, z] = SETTER;
    let (far, [cx, cy]) = (RADIUS - BALL / 2.0, CENTRE);
    let wall =
        |min: [f64; 2], max: [f64; 2]| Block { min: [min[0], min[1], -100.0], max: [max[0], max[1], -60.0] };
    vec![
        Block { min: [x - 8.0, y - 8.0, -400.0], max: [x + 8.0, y + 8.0, z + LENGTH] },
        wall([cx + far, cy - 5.0], [cx + far + 5.0, cy + 5.0]),
        wall([cx - far - 5.0, cy - 5.0], [cx - far, cy + 5.0]),
        wall([cx - 5.0, cy + far], [cx + 5.0, cy + far + 5.0]),
        wall([cx - 5.0, cy - far - 5.0], [cx + 5.0, cy - far]),
    ]
}

#[test]
fn a_shift_with_measuring_and_an_emergency_stop_in_a_cut() {
    let folder = tempfile::tempdir().unwrap();
    let store = Arc::new(Store::open(folder.path(), Settings::new("gsk990mc")).unwrap());
    let mut machine = Machine::demo_mill();
    for (name, value) in
        [("NO4.0", 1.0), ("P387", SETTER[0]), ("P388", SETTER[1]), ("P389", SETTER[2]), ("P391", BALL)]
    {
        machine.parameters.insert(name.to_owned(), value);
    }
    let mut plant = Plant::new(&machine, Position::ZERO, Position::ZERO);
    things().into_iter().for_each(|block| plant.place(block));
    let mut mill = Mill::of(&machine, plant, Some(store));
    mill.press("KEY_EDIT");
    for (name, text) in [("O1000", BRACKET), ("O9001", TOOL_CHANGE)] {
        mill.say(Command::Store { program: name.into(), text: text.into() });
    }
    mill.home();

    // The first tool, measured on the setter; the others are known.
    mill.mdi("T1 M06");
    assert_eq!(mill.control.status().spindle.tool, 1);
    let tool = mill.measure(json!({"do": "measure_tool", "mode": "length", "h": 1, "length": 88.0}));
    assert!((tool.sizes[0] - LENGTH).abs() < 5e-4 && tool.stored == ["H1"], "{tool:?}");
    for number in 2..=6 {
        let known = json!({"do": "set_offset", "number": number, "length": LENGTH});
        mill.say(serde_json::from_value(known).unwrap());
    }

    // The zero: X and Y by the bore, Z by a surface.
    mill.mdi(&format!("G90 G53 G0 Z-20\nG53 X{} Y{}", CENTRE[0], CENTRE[1]));
    let zero = json!({"do": "measure", "form": "hole", "diameter": 2.0 * RADIUS, "z": -70, "system": "G54",
        "tolerance": 0.05});
    let found = mill.measure(zero);
    assert!((found.sizes[0] - 2.0 * RADIUS).abs() < 1e-3 && found.stored == ["G54"], "{found:?}");
    // The top of a wall, which the first tool touches with its own length.
    mill.mdi(&format!("G90 G53 G0 Z-20\nG53 X{} Y{}", CENTRE[0] + RADIUS + 2.0, CENTRE[1]));
    let top = mill.measure(
        json!({"do": "measure", "form": "edge", "axis": "Z", "distance": 60.0, "h": 1, "system": "G54"}),
    );
    assert!(top.stored == ["G54"], "{top:?}");
    let Reply::Zeros { zeros } = mill.say(Command::Zeros) else { panic!() };
    let zero = zeros["G54"].clone();
    for (axis, wanted) in [('X', CENTRE[0]), ('Y', CENTRE[1]), ('Z', -150.0)] {
        assert!((zero[&axis] - wanted).abs() < 1e-3, "{zero:?}");
    }

    // The bracket: hold, another feed, an axis moved by hand and back.
    mill.press("KEY_AUTO");
    mill.say(Command::Select { program: "O1000".into() });
    mill.press("KEY_START");
    mill.until("facing", |status| status.program.line == 23 && status.feed.actual > 100.0);
    mill.press("KEY_HOLD");
    let held = mill.until("held", |status| status.activity == Activity::Held && status.feed.actual == 0.0);
    mill.press("KEY_JOG");
    mill.key("KEY_Y+", true);
    mill.wait(500);
    mill.key("KEY_Y+", false);
    let away = mill.until("at rest", |status| status.feed.actual == 0.0);
    assert!(away.position.machine[&'Y'] > held.position.machine[&'Y'] + 5.0);
    mill.press("KEY_AUTO");
    mill.say(Command::Switch { switch: "SWITCH_FEED".into(), position: 15 });
    mill.press("KEY_START");
    let runs =
        mill.until("faces on", |status| status.activity == Activity::Running && status.program.line == 23);
    let back = runs.position.machine[&'Y'] - held.position.machine[&'Y'];
    assert!(back.abs() < 1e-6, "the way went back first: {back}");
    assert_eq!(runs.feed.feed_override, 1.5);
    mill.say(Command::Switch { switch: "SWITCH_FEED".into(), position: 10 });

    // Emergency stop in the second level of the contour, on its long side.
    let deep = -150.0 + LENGTH - 12.0;
    mill.until("deep in the contour", |status| {
        status.program.line == 142 && status.position.machine[&'Z'] < deep && status.feed.actual > 100.0
    });
    mill.say(Command::EmergencyStop { pressed: true });
    let stopped = mill.wait(1000);
    assert_eq!((stopped.activity, stopped.feed.actual), (Activity::Emergency, 0.0));
    assert_eq!(stopped.spindle.told, 0.0);
    mill.press("KEY_START");
    assert_eq!(mill.wait(200).position.machine, stopped.position.machine);
    mill.say(Command::EmergencyStop { pressed: false });
    mill.wait(100);
    mill.say(Command::Reset);
    let status = mill.until("well", |status| status.activity == Activity::Idle && status.alarms.is_empty());
    let told = status.interrupted.unwrap();
    assert_eq!((told.program.as_str(), told.line, told.kept), ("O1000", 142, true));

    // Z up by hand, the restart prepared, cycle start.
    mill.press("KEY_JOG");
    mill.key("KEY_Z+", true);
    mill.wait(1000);
    mill.key("KEY_Z+", false);
    mill.until("at rest", |status| status.feed.actual == 0.0);
    mill.press("KEY_AUTO");
    mill.say(serde_json::from_value(json!({"do": "restart", "sends": true})).unwrap());
    for _ in 0..5000 {
        if mill.wait(1).restart_ready {
            break;
        }
        std::thread::sleep(std::time::Duration::from_millis(1));
    }
    let Reply::Restarts { ready, .. } = mill.say(Command::Restarts) else { panic!() };
    let plan = *ready.unwrap();
    assert_eq!((plan.line, plan.origin.as_str()), (142, "kept"));
    assert_eq!(plan.functions, ["M03 S4500", "M08"]);
    // Line 142 begins at X-70 Y48, and goes along X: Y may stand there already. Z comes last, at the second level.
    let wanted = [('X', zero[&'X'] - 70.0), ('Y', zero[&'Y'] + 48.0), ('Z', zero[&'Z'] + LENGTH - 12.5)];
    let stands = (stopped.position.machine[&'Y'] - wanted[1].1).abs() < 1e-9;
    let ways: Vec<_> = wanted.into_iter().filter(|(axis, _)| !(*axis == 'Y' && stands)).collect();
    assert_eq!(plan.approach.len(), ways.len(), "{:?}", plan.approach);
    for ((axis, to), way) in ways.into_iter().zip(&plan.approach) {
        assert!(way.axis == axis && (way.to - to).abs() < 1e-3, "{:?}", plan.approach);
    }
    mill.press("KEY_START");
    mill.until("goes on in the block", |status| status.program.line == 142 && status.feed.actual > 1000.0);
    let done = mill.until("done", |status| status.activity == Activity::Idle);

    // The part, the positions, the variables, the log.
    assert_eq!((done.counters.parts, done.alarms.len(), done.interrupted), (1, 0, None));
    for (axis, to) in [('X', zero[&'X'] - 70.0), ('Y', zero[&'Y'] + 30.0), ('Z', 150.0)] {
        assert!((done.position.machine[&axis] - to).abs() < 1e-6, "{:?}", done.position.machine);
    }
    assert_eq!(done.spindle.tool, 6);
    let Reply::Variables { variables } = mill.say(Command::Variables { from: 500, to: 500 }) else {
        panic!()
    };
    assert_eq!(variables[&500], 6.0, "the tool in the spindle, as O9001 keeps it");
    mill.control.flush().unwrap();
    let Reply::AlarmHistory { alarms } = mill.say(Command::AlarmHistory { most: 10 }) else { panic!() };
    assert_eq!(alarms.iter().filter(|past| past.id == "gsk990mc:0251").count(), 1, "{alarms:?}");
    assert_eq!(alarms[0].program, "O1000");
    let Reply::OperationLog { entries } = mill.say(Command::OperationLog { most: 100 }) else { panic!() };
    // All that was changed by hand or measured, from what to what, and nothing else.
    let length = LENGTH.to_string();
    let size = |text: &str| text.len().to_string();
    let lengths = (1..=6).map(|number| ("offsets", format!("{number} length"), "0", length.clone()));
    let measured = [("x", CENTRE[0]), ("y", CENTRE[1]), ("z", -150.0)]
        .map(|(axis, at)| ("zeros", format!("G54 {axis}"), "0", at.to_string()));
    let wanted: Vec<_> = [("O1000", BRACKET), ("O9001", TOOL_CHANGE)]
        .map(|(name, text)| ("programs", name.to_owned(), "", size(text)))
        .into_iter()
        .chain(lengths)
        .chain(measured)
        .collect();
    // Places that were touched are sums: what they are to a micrometre counts.
    let micrometres = |text: &str| match text.parse::<f64>() {
        Ok(value) => ((value * 1000.0).round() / 1000.0).to_string(),
        Err(_) => text.to_owned(),
    };
    assert!(entries.iter().all(|line| line.who == "panel" && line.level == Some(5)), "{entries:?}");
    let oldest_first = entries.iter().rev();
    let found: Vec<_> = oldest_first
        .map(|line| (line.item.as_str(), line.name.clone(), line.from.as_str(), micrometres(&line.to)))
        .collect();
    assert_eq!(found, wanted);
}

#[test]
fn a_key_that_is_pressed_and_let_go_between_two_scans_acts() {
    let mut mill = Mill::power_on();
    let tap = |mill: &mut Mill, key: &str| {
        mill.say(Command::Key { key: key.into(), down: true });
        mill.say(Command::Key { key: key.into(), down: false });
    };
    for (key, mode) in [("KEY_EDIT", Mode::Edit), ("KEY_JOG", Mode::Jog), ("KEY_MDI", Mode::Mdi)] {
        tap(&mut mill, key);
        mill.until(key, |status| status.mode == mode);
    }
    mill.say(Command::Mdi { text: "G91 G1 X-20 F600".into() });
    tap(&mut mill, "KEY_START");
    mill.until("moving", |status| status.activity == Activity::Running);
    tap(&mut mill, "KEY_HOLD");
    mill.until("holding", |status| status.activity == Activity::Held);
    tap(&mut mill, "KEY_START");
    mill.until("at rest", |status| status.activity == Activity::Idle);
    // An axis key moves its axis no longer than the ladder took to see it.
    tap(&mut mill, "KEY_JOG");
    mill.until("KEY_JOG", |status| status.mode == Mode::Jog);
    tap(&mut mill, "KEY_X-");
    let status = mill.wait(1000);
    assert_eq!(status.activity, Activity::Idle);
}

#[test]
fn signals_have_names_meanings_and_values_for_any_front() {
    let machine = Machine::demo_mill();
    let text = "KEY_A = X20.0 ; the key A\nRD KEY_A\nWRT Y0.0\nEND1\nEND2\n";
    let mut mill = Mill::with_ladder(&machine, text, Parts::default());
    mill.say(Command::Key { key: "KEY_A".into(), down: true });
    mill.wait(2);
    let of = |mill: &mut Mill, area, language: &str| match mill
        .say(Command::SignalTable { area, language: Some(language.into()) })
    {
        Reply::SignalTable { signals } => signals,
        reply => panic!("{reply:?}"),
    };
    let keys = of(&mut mill, 'X', "en");
    let key = keys.iter().find(|signal| signal.name == "KEY_A").unwrap();
    assert_eq!((&*key.address, &*key.meaning, key.value), ("X20.0", "the key A", 1));
    let ready = |signals: Vec<NamedSignal>| signals.into_iter().find(|signal| signal.name == "MA").unwrap();
    let [english, russian] = ["en", "ru"].map(|tag| ready(of(&mut mill, 'F', tag)));
    assert_eq!(english.value, 1);
    assert!(!english.meaning.is_empty() && english.meaning != russian.meaning, "{english:?} {russian:?}");
    for (area, language) in [('Q', "en"), ('X', "xx")] {
        let command = Command::SignalTable { area, language: Some(language.into()) };
        let refusal = mill.control.command(command, &Author::Control).unwrap_err();
        assert_eq!(refusal.alarm.id, "FC-1407");
    }
}

#[test]
fn level_2_sees_every_press_however_long_it_takes() {
    // Level 2 counts the presses in D0; its 10,000 networks take several periods.
    let idle: String = (0..10_000).map(|n| format!("RD X1.0\nWRT R{}.{}\n", 100 + n / 8, n % 8)).collect();
    let text = format!(
        "KEY_A = X20.0\nRD KEY_A\nWRT Y0.0\nEND1\nRD KEY_A\nDIFU 1\nWRT R0.0\n\
         RD.NOT R9091.1\nRD.STK R0.0\nADDB 1 D0 1 D0\n{idle}END2\n"
    );
    let machine = Machine::demo_mill();
    let mut mill = Mill::with_ladder(&machine, &text, Parts::default());
    let key = |mill: &mut Mill, down| mill.say(Command::Key { key: "KEY_A".into(), down });
    let signal = |mill: &mut Mill, name: &str| match mill.say(Command::Signals { names: vec![name.into()] }) {
        Reply::Signals { signals } => signals[name],
        reply => panic!("{reply:?}"),
    };
    // Pressed in the midst of level 2 and let go a period later: it counts, and so does each press of several at once.
    let mut presses = 0;
    for periods in [1, 2, 3, 1] {
        mill.wait(periods);
        key(&mut mill, true);
        mill.wait(1);
        key(&mut mill, false);
        mill.wait(40);
        presses += 1;
        assert_eq!((signal(&mut mill, "D0"), signal(&mut mill, "KEY_A")), (presses, 0));
    }
    for _ in 0..3 {
        key(&mut mill, true);
        key(&mut mill, false);
    }
    mill.wait(100);
    assert_eq!((signal(&mut mill, "D0"), signal(&mut mill, "KEY_A")), (presses + 3, 0));
    // However many come, the key is in the end what it is at last.
    for down in [true, false].iter().cycle().take(99) {
        key(&mut mill, *down);
    }
    mill.wait(400);
    assert_eq!(signal(&mut mill, "KEY_A"), 1);
    // What was seen is let go at once.
    key(&mut mill, false);
    assert_eq!(signal(&mut mill, "KEY_A"), 0);
}

/// 4#7: SKIP is given while X4.7 is 0, or 1. The probe of a machine file that says nothing else is wired so.
#[test]
fn the_skip_signal_has_the_level_of_its_parameter() {
    for given in [false, true] {
        let mut machine = Machine::demo_mill();
        machine.parameters.insert("NO4.7".to_owned(), f64::from(u8::from(given)));
        let block = PlantBlock { min: [10.0, -50.0, -50.0], max: [60.0, 50.0, 50.0] };
        machine.plant = Some(PlantConfig { blocks: vec![block], ..PlantConfig::default() });
        let mut mill = Mill::with_ladder(&machine, crate::common::panel::LADDER, Parts::default());
        mill.say(Command::Switch { switch: "SWITCH_FEED".into(), position: 10 });
        mill.wait(100);
        let level = |mill: &mut Mill| {
            mill.wait(1);
            mill.control.plc_mut().unwrap().memory().bit(Address::parse("X4.7").unwrap())
        };
        assert_eq!(level(&mut mill), !given);
        mill.press("KEY_R_100");
        mill.home();
        mill.mdi("G91 G31 X30 F600");
        let x = mill.control.status().position.machine[&'X'];
        assert!((10.0..10.5).contains(&x), "{given}: {x} {:?}", mill.events);
        assert_eq!(level(&mut mill), given);
    }
}
