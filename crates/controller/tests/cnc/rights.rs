//! What each level may (GSK990MC operation 3.4.5, 3.7): every command of the API, tried by all five.

use crate::common::panel::Mill;
use ferrocut_controller::Plant;
use ferrocut_controller::api::{Command, Reply};
use ferrocut_geometry::Position;
use ferrocut_machine::Machine;
use ferrocut_memory::password::Seat;
use ferrocut_memory::{Author, Level, Session, Settings, Store};
use serde_json::{Value, json};
use std::collections::BTreeSet;
use std::sync::Arc;

/// The refusal for want of a right.
const RIGHT: &str = "FC-1213";

/// That of a program that somebody with more rights has locked.
const LOCKED: &str = "FC-1215";

/// A command; the lowest level that may; what the control says to those who may, empty where it does it.
type Row = (Value, u8, &'static str);

/// In the order in which they are said, in MDI, with the parameter switch on and nothing under way.
fn rows() -> Vec<Row> {
    let ladder = "RD X0.0\nWRT Y100.0\nEND1\nEND2\n";
    // Another mode; fewer points than a circle has.
    let (mode, points) = ("FC-1400", "FC-1473");
    vec![
        // The panel.
        (json!({"do": "key", "key": "KEY_LIGHT", "down": false}), 5, ""),
        (json!({"do": "switch", "switch": "SWITCH_FEED", "position": 10}), 5, ""),
        (json!({"do": "handwheel", "counts": 0}), 5, ""),
        (json!({"do": "stop_by_hand"}), 5, ""),
        (json!({"do": "emergency_stop", "pressed": false}), 5, ""),
        (json!({"do": "reset"}), 5, ""),
        // Programs.
        (json!({"do": "programs"}), 5, ""),
        (json!({"do": "store", "program": "O0007", "text": "O7\nM30\n"}), 5, ""),
        (json!({"do": "read", "program": "O0007"}), 5, ""),
        (json!({"do": "rename", "program": "O0007", "to": "O0008"}), 5, ""),
        (json!({"do": "lock", "program": "O0001", "locked": true}), 4, ""),
        (json!({"do": "lock", "program": "O0001", "locked": false}), 4, ""),
        (json!({"do": "delete", "program": "O0008"}), 5, ""),
        // Made, and locked, by commissioning.
        (json!({"do": "store", "program": "O0003", "text": "O3\nM30\n"}), 3, ""),
        (json!({"do": "delete", "program": "O0003"}), 3, ""),
        (json!({"do": "rename", "program": "O0004", "to": "O0005"}), 3, ""),
        (json!({"do": "select", "program": "O0001"}), 5, mode),
        (json!({"do": "retrace"}), 5, mode),
        (json!({"do": "cursor", "line": 1}), 5, ""),
        (json!({"do": "mdi", "text": "M0"}), 5, ""),
        (json!({"do": "mdi_block", "block": ""}), 5, ""),
        (json!({"do": "dnc", "text": "M30\n", "first": true, "last": true}), 5, ""),
        (json!({"do": "mdi_text"}), 5, ""),
        // No program is chosen.
        (json!({"do": "stop_at", "sequence": 3}), 5, "FC-1407"),
        (json!({"do": "restart"}), 5, mode),
        (json!({"do": "restarts"}), 5, ""),
        (json!({"do": "cancel_restart"}), 5, ""),
        // Data of the work, and of the machine.
        (json!({"do": "offsets", "from": 1, "to": 2}), 5, ""),
        (json!({"do": "set_offset", "number": 1, "length": 5.0}), 5, ""),
        (json!({"do": "zeros"}), 5, ""),
        (json!({"do": "set_zero", "system": "G54", "axes": {"X": 1.0}}), 5, ""),
        (json!({"do": "zero_here", "system": "G55", "axes": {"X": 0.0}}), 5, ""),
        (json!({"do": "variables", "from": 500, "to": 510}), 5, ""),
        (json!({"do": "set_variable", "number": 500, "value": 1.0}), 5, ""),
        (json!({"do": "parameters", "names": ["P86"]}), 5, ""),
        // Of the cycles; what protects programs; of the machine; of the setting page.
        (json!({"do": "set_parameter", "name": "P270", "value": 1.0}), 4, ""),
        (json!({"do": "set_parameter", "name": "NO27.0", "value": 1.0}), 3, ""),
        (json!({"do": "set_parameter", "name": "P86", "value": 1500.0}), 3, ""),
        (json!({"do": "set_parameter", "name": "NO54.6", "value": 1.0}), 4, ""),
        (json!({"do": "parameter_switch", "on": true}), 5, ""),
        (json!({"do": "accept_parameter_switch"}), 5, ""),
        (json!({"do": "reference_points"}), 5, ""),
        (json!({"do": "set_reference_point", "number": 2, "axes": {"Z": 10.0}}), 3, ""),
        (json!({"do": "set_machine_zero", "axes": ["X"]}), 3, ""),
        (json!({"do": "pitch", "axis": "X"}), 5, ""),
        (json!({"do": "set_pitch", "axis": "X", "points": {"1": 0.001}}), 3, ""),
        (json!({"do": "relative", "axis": "X", "to": "zero"}), 5, ""),
        (json!({"do": "spindle_speed", "speed": 0.0}), 5, ""),
        (json!({"do": "clear_interruption"}), 5, ""),
        (json!({"do": "set_counter", "counter": "parts", "value": 3.0}), 5, ""),
        (json!({"do": "set_counter", "counter": "all-parts", "value": 3.0}), 2, ""),
        (json!({"do": "set_counter", "counter": "power-on-time", "value": 3.0}), 2, ""),
        // Rights and histories.
        (json!({"do": "log_in", "level": 4, "password": WORDS[3]}), 5, ""),
        (json!({"do": "log_out"}), 5, ""),
        (json!({"do": "set_password", "level": 1, "password": WORDS[0]}), 1, ""),
        (json!({"do": "set_password", "level": 2, "password": WORDS[1]}), 2, ""),
        (json!({"do": "set_password", "level": 3, "password": WORDS[2]}), 3, ""),
        (json!({"do": "set_password", "level": 4, "password": WORDS[3]}), 4, ""),
        (json!({"do": "alarm_history", "most": 5}), 5, ""),
        (json!({"do": "operation_log", "most": 5}), 5, ""),
        (json!({"do": "clear_alarm_history"}), 3, ""),
        (json!({"do": "clear_operation_log"}), 3, ""),
        // The ladder.
        (json!({"do": "signals", "names": ["KEY_START"]}), 5, ""),
        (json!({"do": "signal_table", "area": "X"}), 5, ""),
        (json!({"do": "ladder"}), 5, ""),
        (json!({"do": "watch_ladder", "on": true}), 5, ""),
        (json!({"do": "ladder_flow"}), 5, ""),
        (json!({"do": "watch_ladder", "on": false}), 5, ""),
        (json!({"do": "trace", "signals": ["KEY_START"]}), 5, ""),
        (json!({"do": "traced"}), 5, ""),
        (json!({"do": "end_trace"}), 5, ""),
        (json!({"do": "force", "signal": "Y100.0", "value": true}), 2, ""),
        (json!({"do": "force", "signal": "Y100.0", "value": null}), 2, ""),
        (json!({"do": "forced"}), 5, ""),
        (json!({"do": "set_signal", "signal": "D500", "value": 1}), 2, ""),
        (json!({"do": "exchange_ladder", "text": ladder}), 2, ""),
        (json!({"do": "roll_back_ladder"}), 2, ""),
        (json!({"do": "check_ladder", "text": ladder}), 5, ""),
        (json!({"do": "start_ladder"}), 2, ""),
        // Diagnosis.
        (json!({"do": "capture", "quantities": ["velocity"], "seconds": 0.1}), 5, ""),
        (json!({"do": "end_capture"}), 5, ""),
        (json!({"do": "captured"}), 5, ""),
        (json!({"do": "timing", "forget": true}), 5, ""),
        (json!({"do": "status"}), 5, ""),
        (json!({"do": "version"}), 5, ""),
        // Measuring.
        (json!({"do": "touch_point", "number": 1}), 5, ""),
        (json!({"do": "points"}), 5, ""),
        (json!({"do": "clear_points"}), 5, ""),
        (json!({"do": "centre", "circle": true}), 5, points),
        (json!({"do": "measure", "form": "hole", "diameter": 30.0}), 5, mode),
        (json!({"do": "measure_tool", "mode": "length", "h": 1, "length": 88.0}), 5, mode),
        // It sets parameters of the machine.
        (json!({"do": "measure_tool", "mode": "calibrate_length", "length": 88.0}), 3, mode),
        (json!({"do": "cancel_measure"}), 5, ""),
        (json!({"do": "measured"}), 5, ""),
        // Backups: each item needs the level that may change all of it.
        (json!({"do": "backup", "file": "all.backup", "items": []}), 5, ""),
        (json!({"do": "restore", "file": "all.backup", "items": ["offsets"]}), 5, ""),
        (json!({"do": "restore", "file": "all.backup", "items": ["variables"]}), 5, ""),
        (json!({"do": "restore", "file": "all.backup", "items": ["programs"]}), 3, ""),
        (json!({"do": "restore", "file": "all.backup", "items": ["parameters"]}), 3, ""),
        (json!({"do": "restore", "file": "all.backup", "items": ["offsets", "plc"]}), 2, ""),
        // Those that may be.
        (json!({"do": "delete_all"}), 5, ""),
    ]
}

/// Passwords of levels 1 to 4.
const WORDS: [&str; 4] = ["the maker's word", "the builder's word", "the fitter's word", "the shop's word"];

/// The names of all commands, as whoever sends an unknown one is told them.
fn names() -> BTreeSet<String> {
    let told = serde_json::from_str::<Command>(r#"{"do": "dance"}"#).unwrap_err().to_string();
    // Each between two marks; the first is what was said.
    told.split('`').skip(3).step_by(2).map(str::to_owned).collect()
}

fn maintenance() -> Author {
    Author::Maintenance { name: "test".into() }
}

#[test]
fn every_command_is_for_the_level_of_the_manual_and_those_above() {
    judged(true);
}

/// The same where nothing is kept; there is no folder for backups then.
#[test]
fn every_command_is_for_the_same_level_where_nothing_is_kept() {
    judged(false);
}

fn judged(is_kept: bool) {
    let mut rows = rows();
    if !is_kept {
        let of_folder = rows.iter_mut().filter(|row| row.0.get("file").is_some());
        of_folder.for_each(|(_, lowest, otherwise)| (*lowest, *otherwise) = (5, "FC-1406"));
    }
    let tried: BTreeSet<String> = rows.iter().map(|row| row.0["do"].as_str().unwrap().to_owned()).collect();
    assert_eq!(tried.symmetric_difference(&names()).collect::<Vec<_>>(), [""; 0]);
    let machine = Machine::demo_mill();
    for level in Level::ALL {
        let folder = tempfile::tempdir().unwrap();
        let store = match is_kept {
            true => Store::open(folder.path(), Settings::new("gsk990mc")).unwrap(),
            false => Store::in_memory("gsk990mc").unwrap(),
        };
        let store = Arc::new(store);
        for (of, word) in Level::ALL.into_iter().zip(WORDS) {
            store.set_password(&maintenance(), of, word, Seat::Machine).unwrap();
        }
        let session = |level: Level| match level {
            Level::Operator => Session::OPERATOR,
            level => {
                store.log_in(level, WORDS[usize::from(level.number()) - 1], Seat::Machine, "test").unwrap()
            }
        };
        let plant = Plant::new(&machine, Position::ZERO, Position::ZERO);
        let mut mill = Mill::of(&machine, plant, Some(store.clone()));
        let fitter = Author::Person { session: session(Level::Commissioning), name: "fitter".into() };
        for (name, text) in [("O0001", "O1\nM30\n"), ("O0003", "O3\nM30\n"), ("O0004", "O4\nM30\n")] {
            mill.say(Command::Store { program: name.into(), text: text.into() });
        }
        for program in ["O0003", "O0004"] {
            let lock = Command::Lock { program: program.into(), locked: true };
            mill.control.command(lock, &fitter).unwrap();
        }
        mill.press("KEY_MDI");
        mill.say(Command::ParameterSwitch { on: true });
        mill.say(Command::AcceptParameterSwitch);
        let author = Author::Person { session: session(level), name: "person".into() };
        for (command, lowest, otherwise) in &rows {
            let is_locked = ["O0003", "O0004"].iter().any(|program| command["program"] == *program);
            let wanted = match (level.number() > *lowest, is_locked) {
                (true, true) => LOCKED,
                (true, false) => RIGHT,
                (false, _) => *otherwise,
            };
            let done = mill.control.command(serde_json::from_value(command.clone()).unwrap(), &author);
            let found = done.as_ref().err().map_or("", |refusal| refusal.alarm.id.as_str());
            assert_eq!(found, wanted, "level {} {command}: {done:?}", level.number());
            if let Err(refusal) = &done
                && wanted == RIGHT
            {
                let values = ["needed", "level"].map(|name| refusal.alarm.values[name].clone());
                assert_eq!(values, [lowest.to_string(), level.number().to_string()], "{command}");
            }
            let rights = match command["do"].as_str() {
                // The higher ones hold: who has them by his session keeps them.
                Some("log_in") => Some(4),
                Some("log_out") => Some(5),
                _ => None,
            };
            match done {
                Ok(Reply::Level { level }) => assert_eq!(Some(level), rights, "{command}"),
                _ => assert_eq!(rights, None, "{command}"),
            }
            mill.wait(10);
        }
    }
}
