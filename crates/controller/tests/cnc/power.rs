//! What survives the power: a control on a durable memory, put off between two sentences, or killed.

use crate::common::random::Random;
use ferrocut_controller::api::{Command, Event, OffsetValues, Reply};
use ferrocut_controller::{Control, Mode, Parts, Plant};
use ferrocut_geometry::Position;
use ferrocut_machine::{Machine, PitchErrors, WorkOffset};
use ferrocut_memory::{Author, Change, Item, PlcArea, Session, Settings, Store};
use ferrocut_plc::{Address, Limits, Program};
use std::io::{BufRead, BufReader};
use std::path::Path;
use std::process::{Command as Process, Stdio};
use std::sync::Arc;

/// Names the folder to the child.
const FOLDER: &str = "FERROCUT_POWER_FOLDER";

fn person() -> Author {
    Author::Person { session: Session::OPERATOR, name: "panel".into() }
}

fn control(folder: &Path) -> Control {
    let store = Arc::new(Store::open(folder, Settings::new("gsk990mc")).unwrap());
    let parts = Parts { store: Some(store), ..Parts::default() };
    Control::new(&Machine::demo_mill(), parts).unwrap()
}

fn wait(control: &mut Control, periods: usize) {
    for _ in 0..periods {
        control.tick();
    }
}

fn say(control: &mut Control, command: Command) -> Reply {
    control.command(command, &person()).unwrap()
}

fn mode(control: &mut Control, mode: Mode) {
    control.set_inputs(Control::free_inputs(mode));
    wait(control, 2);
}

fn start(control: &mut Control, mode: Mode) {
    let mut inputs = Control::free_inputs(mode);
    inputs.cycle_start = true;
    control.set_inputs(inputs.clone());
    wait(control, 2);
    inputs.cycle_start = false;
    control.set_inputs(inputs);
    wait(control, 2);
}

fn offset(length: f64) -> Command {
    let values = OffsetValues { length: Some(length), ..OffsetValues::default() };
    Command::SetOffset { number: 3, values, add: false }
}

#[test]
fn what_was_entered_run_and_counted_is_there_after_the_power() {
    let folder = tempfile::tempdir().unwrap();
    {
        let mut control = control(folder.path());
        mode(&mut control, Mode::Auto);
        let text = "#500=#500+1\nG10 L2 P1 X-5\nG53 G0 X7\nM30\n".to_owned();
        say(&mut control, Command::Store { program: "O0001".into(), text });
        say(&mut control, Command::Select { program: "O1".into() });
        say(&mut control, offset(-12.5));
        // An operator may not change the machine; the refusal says what is needed.
        mode(&mut control, Mode::Mdi);
        let set = Command::SetParameter { name: "P66".into(), value: Some(1.0) };
        assert_eq!(control.command(set.clone(), &person()).unwrap_err().alarm.id, "gsk990mc:0068");
        say(&mut control, Command::ParameterSwitch { on: true });
        assert_eq!(control.command(set, &person()).unwrap_err().alarm.id, "FC-1213");
        say(&mut control, Command::ParameterSwitch { on: false });
        mode(&mut control, Mode::Auto);
        for _ in 0..2 {
            start(&mut control, Mode::Auto);
            wait(&mut control, 3000);
        }
        assert_eq!(control.status().counters.parts, 2);
        // An alarm for the history.
        say(&mut control, Command::Store { program: "O0002".into(), text: "G7777\nM30\n".into() });
        say(&mut control, Command::Select { program: "O2".into() });
        start(&mut control, Mode::Auto);
        wait(&mut control, 100);
        assert!(
            control
                .command(Command::Backup { file: "../x.backup".into(), items: vec![] }, &person())
                .is_err()
        );
        control.flush().unwrap();
    }
    let mut control = control(folder.path());
    mode(&mut control, Mode::Edit);
    let status = control.status();
    assert_eq!((status.counters.parts, status.position.machine[&'X']), (2, 7.0));
    assert_eq!(control.interpreter().memory().parameters.data(356), 2.0);
    assert!(status.counters.run_time > 0.1 && status.counters.power_on_time > 6.0);
    let Reply::Variables { variables } = say(&mut control, Command::Variables { from: 500, to: 999 }) else {
        panic!()
    };
    assert_eq!(variables[&500], 2.0);
    let Reply::Offsets { offsets } = say(&mut control, Command::Offsets { from: 3, to: 3 }) else { panic!() };
    assert_eq!(offsets[&3].length, Some(-12.5));
    let Reply::Zeros { zeros } = say(&mut control, Command::Zeros) else { panic!() };
    assert_eq!(zeros["G54"][&'X'], -5.0);
    let Reply::Programs { programs, most, room } = say(&mut control, Command::Programs) else { panic!() };
    assert!(most == Some(10_000) && room.is_some_and(|bytes| bytes > 0));
    assert_eq!(programs.iter().map(|p| p.name.as_str()).collect::<Vec<_>>(), ["O0001", "O0002"]);
    let Reply::AlarmHistory { alarms } = say(&mut control, Command::AlarmHistory { most: 9 }) else {
        panic!()
    };
    assert_eq!((alarms.len(), alarms[0].program.as_str(), alarms[0].line), (2, "O0002", 1));
    assert_eq!(alarms[1].id, "gsk990mc:0100");
    let Reply::OperationLog { entries } = say(&mut control, Command::OperationLog { most: 99 }) else {
        panic!()
    };
    let entered = entries.iter().find(|entry| entry.name == "3 length").unwrap();
    assert_eq!((entered.who.as_str(), entered.from.as_str(), entered.to.as_str()), ("panel", "0", "-12.5"));
    // A backup, another value, and the old one again.
    say(&mut control, Command::Backup { file: "shift.backup".into(), items: vec!["offsets".into()] });
    say(&mut control, offset(1.0));
    say(&mut control, Command::Restore { file: "shift.backup".into(), items: vec!["offsets".into()] });
    let Reply::Offsets { offsets } = say(&mut control, Command::Offsets { from: 3, to: 3 }) else { panic!() };
    assert_eq!(offsets[&3].length, Some(-12.5));
}

const LADDER: &str = include_str!("../../../../machines/standard.lad");

/// All that is restored holds at once, not only after the next power-on.
#[test]
fn each_item_holds_at_once_when_it_was_restored() {
    let folder = tempfile::tempdir().unwrap();
    let store = Arc::new(Store::open(folder.path(), Settings::new("gsk990mc")).unwrap());
    let machine = Machine::demo_mill();
    let parts = Parts {
        store: Some(store),
        ladder: Some(Program::from_text(LADDER.as_bytes(), &Limits::default()).unwrap()),
        drives: Some(Box::new(Plant::new(&machine, Position::ZERO, Position::ZERO))),
        ..Parts::default()
    };
    let mut control = Control::new(&machine, parts).unwrap();
    wait(&mut control, 100);
    let by_control = |control: &mut Control, command: Command| {
        control.command(command, &Author::Control).unwrap();
        wait(control, 1);
        control.flush().unwrap();
    };
    let address = |text: &str| Address::parse(text).unwrap();
    let keep = |control: &mut Control, values: [u8; 2]| {
        let memory = control.plc_mut().unwrap().memory_mut();
        memory.set_byte(address("K99"), values[0]);
        memory.set_byte(address("D5000"), values[1]);
    };
    let kept = |control: &mut Control| {
        let memory = control.plc_mut().unwrap().memory();
        [memory.byte(address("K99")), memory.byte(address("D5000"))]
    };
    let pitch = |value| Command::SetPitch { axis: 'X', points: [(1, value)].into() };
    let program = |text: &str| Command::Store { program: "O0001".into(), text: text.into() };
    keep(&mut control, [0b1, 7]);
    by_control(&mut control, pitch(0.003));
    by_control(&mut control, program("G0 X1\nM30\n"));
    by_control(&mut control, Command::Backup { file: "all.backup".into(), items: vec![] });
    keep(&mut control, [0b10, 9]);
    by_control(&mut control, pitch(0.005));
    by_control(&mut control, program("G0 X2\nM30\n"));
    let items = ["plc", "pitch", "programs"].map(str::to_owned).to_vec();
    by_control(&mut control, Command::Restore { file: "all.backup".into(), items });
    assert_eq!(kept(&mut control), [0b1, 7]);
    let Reply::Pitch { points, .. } = say(&mut control, Command::Pitch { axis: 'X' }) else { panic!() };
    assert_eq!(points[&1], 0.003);
    let Reply::Program { text, .. } = say(&mut control, Command::Read { program: "O1".into() }) else {
        panic!()
    };
    assert_eq!(text, "G0 X1\nM30\n");
    // No items are all that the backup has.
    by_control(&mut control, pitch(0.005));
    by_control(&mut control, program("G0 X3\nM30\n"));
    by_control(&mut control, Command::Restore { file: "all.backup".into(), items: vec![] });
    let Reply::Program { text, .. } = say(&mut control, Command::Read { program: "O1".into() }) else {
        panic!()
    };
    assert_eq!(text, "G0 X1\nM30\n");
    let Reply::Pitch { points, .. } = say(&mut control, Command::Pitch { axis: 'X' }) else { panic!() };
    assert_eq!(points[&1], 0.003);
    // What the ladder changes from there on is kept, too, and nothing else of before.
    keep(&mut control, [0b10, 7]);
    control.flush().unwrap();
    drop(control);
    let store = Store::open(folder.path(), Settings::new("gsk990mc")).unwrap();
    let found = store.reader().contents(&[Item::Plc]).unwrap().plc;
    assert_eq!((found[&PlcArea::K][99], found[&PlcArea::D][5000]), (0b10, 7));
}

/// What is restored changes nothing else: neither what other items have nor what no backup has.
#[test]
fn a_restore_of_one_item_leaves_all_the_rest() {
    let folder = tempfile::tempdir().unwrap();
    let store = Arc::new(Store::open(folder.path(), Settings::new("gsk990mc")).unwrap());
    let machine = Machine::demo_mill();
    let mut memory = ferrocut_machine::Memory::new("gsk990mc");
    let setup = "[parameters]\nP86 = 1234\n[tools.7]\nlength = 70.0\n[work_offsets]\nG55 = { x = 5.0 }\n";
    ferrocut_machine::Setup::from_toml(setup).unwrap().apply(&mut memory).unwrap();
    let parts = Parts { store: Some(store), memory: Some(memory), ..Parts::default() };
    let mut control = Control::new(&machine, parts).unwrap();
    say(&mut control, offset(-12.5));
    mode(&mut control, Mode::Mdi);
    let text = "#100=1.5\n#199=2\n#150=#0\n#500=3\n#999=4\nG10 L2 P1 X-5\nG10 L2 P3 Y8\nM2\n";
    say(&mut control, Command::Mdi { text: text.into() });
    start(&mut control, Mode::Mdi);
    wait(&mut control, 1000);
    say(&mut control, Command::Backup { file: "all.backup".into(), items: vec![] });
    let all = |control: &Control| format!("{:?}", control.interpreter().memory());
    let before = all(&control);
    let values = |control: &Control| {
        let variables = &control.interpreter().memory().variables;
        [100, 150, 199, 500, 999].map(|number| variables.get(number))
    };
    assert_eq!(values(&control), [Some(1.5), None, Some(2.0), Some(3.0), Some(4.0)]);
    for item in Item::ALL {
        let restore = Command::Restore { file: "all.backup".into(), items: vec![item.name().into()] };
        // Not all items are such that they are put back.
        let _ = control.command(restore, &Author::Control);
        wait(&mut control, 10);
        assert_eq!(values(&control), [Some(1.5), None, Some(2.0), Some(3.0), Some(4.0)], "{item:?}");
        assert!(all(&control) == before, "{item:?}");
    }
    // And what is restored is as it was, the rest as it is.
    say(&mut control, Command::Mdi { text: "#100=7\n#500=8\nG10 L2 P1 X9\nM2\n".into() });
    start(&mut control, Mode::Mdi);
    wait(&mut control, 1000);
    let items = vec!["variables".into()];
    control.command(Command::Restore { file: "all.backup".into(), items }, &Author::Control).unwrap();
    assert_eq!(values(&control), [Some(7.0), None, Some(2.0), Some(3.0), Some(4.0)]);
    let Reply::Zeros { zeros } = say(&mut control, Command::Zeros) else { panic!() };
    assert_eq!(zeros["G54"][&'X'], 9.0);
}

/// The position of another moment is none for axes of which the control knows where they are: nothing of such a restore
/// is done.
#[test]
fn a_running_control_takes_no_position_from_a_backup() {
    let folder = tempfile::tempdir().unwrap();
    let mut control = control(folder.path());
    by_maintenance(&mut control, Command::Backup { file: "all.backup".into(), items: Vec::new() });
    say(&mut control, offset(-3.5));
    let at = control.status().position.machine;
    for items in [vec!["position".to_owned()], vec!["offsets".to_owned(), "position".to_owned()]] {
        let restore = Command::Restore { file: "all.backup".into(), items };
        assert_eq!(control.command(restore, &Author::Control).unwrap_err().alarm.id, "FC-1221");
    }
    assert_eq!(control.status().position.machine, at);
    assert_eq!(control.interpreter().memory().tools.get(3).unwrap().length, -3.5);
}

/// A backup that is not there is no fault of the disk.
#[test]
fn a_backup_that_is_not_there_is_named() {
    let folder = tempfile::tempdir().unwrap();
    let mut control = control(folder.path());
    let restore = Command::Restore { file: "nosuch.backup".into(), items: vec!["offsets".into()] };
    let alarm = control.command(restore, &Author::Control).unwrap_err().alarm;
    assert_eq!((alarm.id.as_str(), alarm.values["name"].as_str()), ("FC-1407", "nosuch.backup"));
}

/// A control with the standard ladder on the memory of a folder.
fn with_ladder(folder: &Path) -> Control {
    let store = Arc::new(Store::open(folder, Settings::new("gsk990mc")).unwrap());
    let machine = Machine::demo_mill();
    let parts = Parts {
        store: Some(store),
        ladder: Some(Program::from_text(LADDER.as_bytes(), &Limits::default()).unwrap()),
        drives: Some(Box::new(Plant::new(&machine, Position::ZERO, Position::ZERO))),
        ..Parts::default()
    };
    Control::new(&machine, parts).unwrap()
}

/// By who is no person, and kept.
fn by_maintenance(control: &mut Control, command: Command) -> Reply {
    let author = Author::Maintenance { name: "builder".into() };
    let reply = control.command(command, &author).unwrap();
    wait(control, 100);
    control.flush().unwrap();
    reply
}

fn ladder_text(control: &mut Control) -> String {
    let Reply::Text { text } = say(control, Command::Ladder) else { panic!() };
    text
}

/// The alarms that were told.
fn told(control: &mut Control) -> Vec<String> {
    let events = control.events();
    let alarm = |event| match event {
        Event::Alarm { alarm } => Some(alarm.id),
        _ => None,
    };
    events.into_iter().filter_map(alarm).collect()
}

/// GSK990MC operation 3.4.4 and 3.7.
#[test]
fn a_ladder_that_was_exchanged_while_it_ran_runs_after_the_power() {
    let folder = tempfile::tempdir().unwrap();
    let one = format!("{LADDER}\n; one\n");
    let two = format!("{LADDER}\n; two\n");
    {
        let mut control = with_ladder(folder.path());
        assert_eq!(told(&mut control), [""; 0]);
        by_maintenance(&mut control, Command::ExchangeLadder { text: one.clone() });
        let events = control.events();
        let changed = |event: &&Event| **event == Event::Changed { item: "ladder".into() };
        assert_eq!(events.iter().filter(changed).count(), 1, "those who draw it follow");
        by_maintenance(&mut control, Command::Backup { file: "one.backup".into(), items: vec![] });
    }
    {
        let mut control = with_ladder(folder.path());
        assert_eq!(told(&mut control), ["FC-1424"]);
        assert!(ladder_text(&mut control) == one);
        by_maintenance(&mut control, Command::ExchangeLadder { text: two.clone() });
        by_maintenance(&mut control, Command::RollBackLadder);
        assert!(ladder_text(&mut control) == one);
        by_maintenance(&mut control, Command::RollBackLadder);
    }
    {
        // What was rolled back last is as it was left.
        let mut control = with_ladder(folder.path());
        assert!(ladder_text(&mut control) == two);
        by_maintenance(
            &mut control,
            Command::Restore { file: "one.backup".into(), items: vec!["ladder".into()] },
        );
        assert!(ladder_text(&mut control) == one);
        by_maintenance(&mut control, Command::Force { signal: "X20.3".into(), value: Some(true) });
        let forced = |control: &mut Control| -> Vec<(String, bool)> {
            let Reply::Forced { signals } = say(control, Command::Forced) else { panic!() };
            signals.into_iter().map(|one| (one.address, one.value)).collect()
        };
        assert_eq!(forced(&mut control), [("X0020.3".into(), true)]);
        assert!(control.events().contains(&Event::Changed { item: "forced".into() }));
        by_maintenance(&mut control, Command::Force { signal: "X20.3".into(), value: None });
        assert_eq!(forced(&mut control), []);
    }
    {
        let mut control = with_ladder(folder.path());
        assert!(ladder_text(&mut control) == one);
        // The machine's own ladder is what an exchange that was kept is rolled back to, after power-on too.
        by_maintenance(&mut control, Command::RollBackLadder);
        assert!(ladder_text(&mut control) == LADDER);
        // One that stops is taken out again, and is never kept.
        told(&mut control);
        let endless = "END1\nLBL 1\nRD.NOT R9.7\nWRT R9.1\nRD.NOT R9.7\nJMPB 1\nEND2\n".to_owned();
        by_maintenance(&mut control, Command::ExchangeLadder { text: endless });
        wait(&mut control, 1000);
        assert_eq!(
            (told(&mut control), ladder_text(&mut control).as_str()),
            (vec!["FC-1426".into()], LADDER)
        );
    }
    let mut control = with_ladder(folder.path());
    assert_eq!(told(&mut control), [""; 0]);
    assert!(ladder_text(&mut control) == LADDER);
    let Reply::OperationLog { entries } = say(&mut control, Command::OperationLog { most: 99 }) else {
        panic!()
    };
    let lines = |item: &str| -> Vec<(String, String, String)> {
        let of_item = entries.iter().rev().filter(|entry| entry.item == item);
        of_item.map(|entry| (entry.who.clone(), entry.name.clone(), entry.to.clone())).collect()
    };
    let ladder = lines("ladder");
    assert_eq!(ladder.len(), 5, "{ladder:?}");
    assert!(ladder.iter().all(|(who, name, _)| who == "builder" && name == "exchanged"));
    assert_eq!((&ladder[1].2, &ladder[0].2), (&ladder[3].2, &ladder[2].2));
    assert_eq!(ladder[4].2, "");
    let forced = lines("plc").into_iter().map(|(who, name, to)| format!("{who} {name} {to}"));
    assert_eq!(forced.collect::<Vec<_>>(), ["builder X20.3 forced 1", "builder X20.3 released"]);
}

/// GSK990MC operation 3.4.5: data of the ladder are for level 2.
#[test]
fn data_of_the_ladder_that_a_person_sets_survive_the_power_and_stand_in_the_log() {
    let (folder, killed) = (tempfile::tempdir().unwrap(), tempfile::tempdir().unwrap());
    let set = |signal: &str, value, bytes| Command::SetSignal { signal: signal.into(), value, bytes };
    let read = |control: &mut Control, names: &[&str]| -> Vec<i64> {
        let names: Vec<String> = names.iter().map(|name| (*name).to_owned()).collect();
        let Reply::Signals { signals } = say(control, Command::Signals { names: names.clone() }) else {
            panic!()
        };
        names.iter().map(|name| signals[name]).collect()
    };
    let places = ["D5012", "D5013", "T90", "T91", "C80", "C81", "K90.3", "K90.4", "K91", "D5020", "D5023"];
    let wanted = [0x34, 0x12, 0xFF, 0x7F, 0xFE, 0xFF, 1, 0, 0xA5, 0xD6, 0xFF];
    {
        let mut control = with_ladder(folder.path());
        let refusal = control.command(set("D5012", 1, None), &person()).unwrap_err();
        assert_eq!(refusal.alarm.id, "FC-1213");
        let builder = Author::Maintenance { name: "builder".into() };
        for (signal, value, bytes, id) in [
            ("R100", 1, None, "FC-1428"),
            ("X1.0", 1, None, "FC-1428"),
            ("NOTHING", 1, None, "FC-1407"),
            ("D10000", 1, None, "FC-1407"),
            ("D9999", 1, Some(2), "FC-1409"),
            ("D5012", 256, None, "FC-1409"),
            ("D5012", -129, None, "FC-1409"),
            ("D5012", 65536, Some(2), "FC-1409"),
            ("D5012", 1, Some(3), "FC-1409"),
            ("K90.3", 2, None, "FC-1409"),
            ("K90.3", -1, None, "FC-1409"),
            ("K90.3", 1, Some(1), "FC-1409"),
            ("D5012", i64::MIN, Some(4), "FC-1409"),
        ] {
            let refusal = control.command(set(signal, value, bytes), &builder).unwrap_err();
            assert_eq!(refusal.alarm.id, id, "{signal} {value} {bytes:?}");
        }
        let values = control.command(set("D5012", 256, None), &builder).unwrap_err().alarm.values;
        assert_eq!((values["min"].to_string(), values["max"].to_string()), ("-128".into(), "255".into()));
        told(&mut control);
        for (signal, value, bytes) in [
            ("D5012", 0x1234, Some(2)),
            ("T90", 32_767, None),
            ("C80", -2, None),
            ("K90.3", 1, None),
            ("K91", 0xA5, None),
            ("D5020", -42, Some(4)),
        ] {
            assert_eq!(control.command(set(signal, value, bytes), &builder).unwrap(), Reply::Done);
        }
        assert_eq!(read(&mut control, &places), wanted);
        let changed = Event::Changed { item: "plc".into() };
        assert_eq!(control.events().iter().filter(|event| **event == changed).count(), 6);
        // What is on the disk now is what a kill would leave.
        let files = std::fs::read_dir(folder.path()).unwrap().map(Result::unwrap);
        for file in files.filter(|file| file.file_type().unwrap().is_file()) {
            std::fs::copy(file.path(), killed.path().join(file.file_name())).unwrap();
        }
    }
    let mut control = with_ladder(killed.path());
    assert_eq!(read(&mut control, &places), wanted);
    let Reply::OperationLog { entries } = say(&mut control, Command::OperationLog { most: 99 }) else {
        panic!()
    };
    let of_plc = entries.iter().rev().filter(|entry| entry.item == "plc");
    let lines: Vec<String> = of_plc.map(|e| format!("{} {} {} {}", e.who, e.name, e.from, e.to)).collect();
    assert_eq!(
        lines,
        [
            "builder D5012 0 4660",
            "builder T0090 0 32767",
            "builder C0080 0 65534",
            "builder K0090.3 0 1",
            "builder K0091 0 165",
            "builder D5020 0 4294967254",
        ]
    );
}

#[test]
fn a_kept_ladder_that_cannot_be_run_gives_way_to_the_machines_own() {
    let folder = tempfile::tempdir().unwrap();
    {
        let store = Store::open(folder.path(), Settings::new("gsk990mc")).unwrap();
        let ladder = Change::Ladder { text: Some("RD NOTHING_HAS_THIS_NAME\n".into()) };
        store.commit(&Author::Control, vec![ladder]).unwrap();
    }
    let mut control = with_ladder(folder.path());
    assert_eq!(told(&mut control), ["FC-1425"]);
    assert!(ladder_text(&mut control) == LADDER);
    wait(&mut control, 100);
    control.flush().unwrap();
    drop(control);
    // It stays what is kept until another takes its place.
    assert_eq!(told(&mut with_ladder(folder.path())), ["FC-1425"]);
}

/// Points that were kept when the control started, and that a restore takes away, are not shown any more.
#[test]
fn pitch_points_that_a_restore_takes_away_are_gone_at_once() {
    let folder = tempfile::tempdir().unwrap();
    let pitch =
        |points: &[(u16, f64)]| Command::SetPitch { axis: 'X', points: points.iter().copied().collect() };
    let backup = || Command::Backup { file: "few.backup".into(), items: vec!["pitch".into()] };
    {
        let mut control = with_ladder(folder.path());
        by_maintenance(&mut control, pitch(&[(1, 0.003)]));
        by_maintenance(&mut control, backup());
        by_maintenance(&mut control, pitch(&[(1, 0.004), (2, 0.005)]));
    }
    let mut control = with_ladder(folder.path());
    let shown = |control: &mut Control| {
        let Reply::Pitch { points, .. } = say(control, Command::Pitch { axis: 'X' }) else { panic!() };
        points.into_iter().collect::<Vec<_>>()
    };
    assert_eq!(shown(&mut control), [(1, 0.004), (2, 0.005)]);
    by_maintenance(&mut control, Command::Restore { file: "few.backup".into(), items: vec!["pitch".into()] });
    assert_eq!(shown(&mut control), [(1, 0.003)]);
}

#[test]
fn a_change_while_axes_move_does_not_wait_for_the_disk() {
    let folder = tempfile::tempdir().unwrap();
    let mut control = control(folder.path());
    mode(&mut control, Mode::Auto);
    say(&mut control, Command::Store { program: "O0001".into(), text: "G1 X50 F3000\nM30\n".into() });
    say(&mut control, Command::Select { program: "O1".into() });
    start(&mut control, Mode::Auto);
    wait(&mut control, 300);
    assert_eq!(say(&mut control, offset(2.5)), Reply::OnItsWay);
    let mut changed = false;
    for _ in 0..1000 {
        wait(&mut control, 1);
        changed |= control.events().contains(&Event::Changed { item: "offsets".into() });
        if changed {
            break;
        }
        std::thread::sleep(std::time::Duration::from_millis(1));
    }
    assert!(changed);
    assert_eq!(control.interpreter().memory().tools.get(3).unwrap().length, 2.5);
}

/// Waits until so many changes of offsets are made.
fn until_changed(control: &mut Control, mut times: usize) {
    for _ in 0..20_000 {
        wait(control, 1);
        let is_change = |event: &Event| *event == Event::Changed { item: "offsets".into() };
        times = times.saturating_sub(control.events().iter().filter(|event| is_change(event)).count());
        if times == 0 {
            return;
        }
        std::thread::sleep(std::time::Duration::from_millis(1));
    }
    panic!("{times} changes are missing");
}

#[test]
fn quick_changes_of_one_row_while_axes_move_are_made_in_their_order_and_all_logged() {
    let folder = tempfile::tempdir().unwrap();
    {
        let mut control = control(folder.path());
        mode(&mut control, Mode::Auto);
        let text = "#500=7\nG1 X400 F1200\nM30\n".to_owned();
        say(&mut control, Command::Store { program: "O0001".into(), text });
        say(&mut control, Command::Select { program: "O1".into() });
        start(&mut control, Mode::Auto);
        let set = |control: &mut Control, values: OffsetValues, add: bool| {
            assert_eq!(say(control, Command::SetOffset { number: 3, values, add }), Reply::OnItsWay);
        };
        let (length, radius) = (OffsetValues::default(), OffsetValues::default());
        set(&mut control, OffsetValues { length: Some(1.0), ..length }, false);
        set(&mut control, OffsetValues { radius: Some(5.0), ..radius }, false);
        set(&mut control, OffsetValues { length: Some(2.0), ..length }, false);
        set(&mut control, OffsetValues { length: Some(0.5), ..length }, true);
        set(&mut control, OffsetValues { length: Some(0.25), ..length }, true);
        let zero = |x| Command::SetZero { system: "external".into(), axes: [('X', x)].into(), add: true };
        // 7.2: zeros are not changed while a program runs.
        assert!(control.command(zero(1.0), &person()).is_err());
        until_changed(&mut control, 5);
        let row = *control.interpreter().memory().tools.get(3).unwrap();
        assert_eq!((row.length, row.radius), (2.75, 5.0));
        control.flush().unwrap();
    }
    let mut control = control(folder.path());
    let memory = control.interpreter().memory();
    let row = memory.tools.get(3).unwrap();
    assert_eq!((row.length, row.radius), (2.75, 5.0));
    // What the program wrote before is not lost among them.
    assert_eq!(memory.variables.get(500), Some(7.0));
    let Reply::OperationLog { entries } = say(&mut control, Command::OperationLog { most: 99 }) else {
        panic!()
    };
    let of_offset = entries.iter().rev().filter(|entry| entry.name.starts_with("3 "));
    let logged: Vec<String> =
        of_offset.map(|entry| format!("{} {}>{}", entry.name, entry.from, entry.to)).collect();
    assert_eq!(
        logged,
        ["3 length 0>1", "3 radius 0>5", "3 length 1>2", "3 length 2>2.5", "3 length 2.5>2.75"]
    );
}

/// A program that writes offsets while a person does: what the control runs with is what the disk has.
#[test]
fn a_program_and_a_person_who_write_the_same_rows_leave_memory_and_disk_alike() {
    let folder = tempfile::tempdir().unwrap();
    let mut random = Random::new(5);
    for pass in 0..3 {
        let store = Arc::new(Store::open(folder.path(), Settings::new("gsk990mc")).unwrap());
        let parts = Parts { store: Some(store.clone()), ..Parts::default() };
        let mut control = Control::new(&Machine::demo_mill(), parts).unwrap();
        mode(&mut control, Mode::Auto);
        let text = "#1=0\nWHILE[#1 LT 40]DO1\n#1=#1+1\nG10 L10 P3 R[100+#1]\nG10 L12 P4 R#1\nG91 G1 X0.2 F3000\nG90\nG4 X0.01\n\
                    G10 L2 P1 X#1\nEND1\nM30\n";
        say(&mut control, Command::Store { program: "O0001".into(), text: text.into() });
        say(&mut control, Command::Select { program: "O1".into() });
        start(&mut control, Mode::Auto);
        let mut asked = 0;
        for _ in 0..5000 {
            wait(&mut control, 1 + random.below(30));
            if !control.cnc().is_under_way() {
                break;
            }
            let number = 3 + random.below(3) as u16;
            let value = Some(random.below(50) as f64);
            let values = match random.below(2) {
                0 => OffsetValues { length: value, ..OffsetValues::default() },
                _ => OffsetValues { radius: value, ..OffsetValues::default() },
            };
            let add = random.below(3) == 0;
            say(&mut control, Command::SetOffset { number, values, add });
            asked += 1;
            if random.below(4) == 0 {
                // The disk is sometimes quick.
                std::thread::sleep(std::time::Duration::from_micros(300));
            }
        }
        assert!(asked > 20 && control.cnc().is_idle(), "{asked} {:?}", control.status());
        control.flush().unwrap();
        // Idle, it waits for what is on its way.
        say(&mut control, Command::Version);
        control.flush().unwrap();
        let kept = store.reader().contents(&[Item::Offsets]).unwrap().offsets;
        for number in 3..=5 {
            let runs_with = *control.interpreter().memory().tools.get(number).unwrap();
            let on_disk = kept.get(&number).copied().unwrap_or_default();
            assert_eq!(on_disk, runs_with, "offset {number}, pass {pass}");
        }
    }
}

/// The child: counts #500 up by a program, again and again, and an offset by hand; says what a person was told is kept.
#[test]
#[ignore = "the child of the kill test"]
fn child() {
    let Some(folder) = std::env::var_os(FOLDER) else { return };
    let mut control = control(Path::new(&folder));
    mode(&mut control, Mode::Auto);
    if control.interpreter().memory().variables.get(500).is_none() {
        let text = "#500=#500+1\n#501=#500*2\nM30\n".to_owned();
        say(&mut control, Command::Store { program: "O0001".into(), text });
    }
    say(&mut control, Command::Select { program: "O1".into() });
    for n in 1.. {
        start(&mut control, Mode::Auto);
        wait(&mut control, 150);
        assert_eq!(say(&mut control, offset(f64::from(n))), Reply::Done);
        eprintln!("kept {n}");
    }
}

#[test]
fn a_kill_at_any_instant_loses_nothing_that_was_said_to_be_kept() {
    let kills: u32 = std::env::var("FERROCUT_KILLS").ok().and_then(|text| text.parse().ok()).unwrap_or(8);
    let folder = tempfile::tempdir().unwrap();
    let mut counted = 0.0;
    for kill in 0..kills {
        let mut child = Process::new(std::env::current_exe().unwrap())
            .args(["--exact", "power::child", "--ignored", "--nocapture"])
            .env(FOLDER, folder.path())
            .stdout(Stdio::null())
            .stderr(Stdio::piped())
            .spawn()
            .unwrap();
        let mut said = BufReader::new(child.stderr.take().unwrap()).lines();
        let mut last = 0.0;
        for _ in 0..3 + kill % 5 {
            let line = said.next().unwrap().unwrap();
            last = line.strip_prefix("kept ").unwrap_or_else(|| panic!("{line}")).parse().unwrap();
        }
        std::thread::sleep(std::time::Duration::from_micros(u64::from(kill % 7) * 700));
        child.kill().unwrap();
        for line in said.map_while(Result::ok) {
            last = line.strip_prefix("kept ").and_then(|n| n.parse().ok()).unwrap_or(last);
        }
        child.wait().unwrap();
        let control = control(folder.path());
        let memory = control.interpreter().memory();
        let length = memory.tools.get(3).unwrap().length;
        assert!(length == last || length == last + 1.0, "{length} of {last}");
        let (one, two) = (memory.variables.get(500).unwrap_or(0.0), memory.variables.get(501).unwrap_or(0.0));
        // Written by the program before the offset was: the same writer, in the order of the calls.
        assert!(
            one >= counted + last && (one * 2.0 - two).abs() <= 2.0,
            "{one} {two} after {counted} and {last}"
        );
        counted = one;
    }
}

/// Where an axis was moving when the power failed nobody knows where it came to rest; one that stood is where it was.
#[test]
fn an_axis_that_moved_when_the_power_failed_is_to_be_homed() {
    let folder = tempfile::tempdir().unwrap();
    let other = tempfile::tempdir().unwrap();
    // Absolute encoders (20#6): all is known when it is switched on first.
    let control = |folder: &Path| {
        let mut machine = Machine::demo_mill();
        machine.plant.get_or_insert_default();
        machine.parameters.insert("NO20.6".into(), 1.0);
        let store = Arc::new(Store::open(folder, Settings::new("gsk990mc")).unwrap());
        Control::new(&machine, Parts { store: Some(store), ..Parts::default() }).unwrap()
    };
    let copied = |at: &Path| {
        for file in std::fs::read_dir(folder.path()).unwrap() {
            let file = file.unwrap();
            let _ = std::fs::copy(file.path(), at.join(file.file_name()));
        }
        control(at)
    };
    let mut control = control(folder.path());
    mode(&mut control, Mode::Mdi);
    say(&mut control, Command::Mdi { text: "G0 X20\nG91 G1 X-100 F3000\nG1 Y-5 X-5".into() });
    start(&mut control, Mode::Mdi);
    let all: Vec<char> = control.status().referenced.into_iter().collect();
    assert!(all.contains(&'X') && all.contains(&'Y'));
    while control.status().position.machine[&'X'] > -20.0 {
        control.tick();
    }
    control.flush().unwrap();
    let known = |control: &Control| -> Vec<char> { control.status().referenced.into_iter().collect() };
    let without =
        |axes: &[char]| -> Vec<char> { all.iter().copied().filter(|axis| !axes.contains(axis)).collect() };
    assert_eq!(known(&copied(other.path())), without(&['X']));
    // The set grows with the axes that begin.
    while control.status().position.machine[&'Y'] > -2.0 {
        control.tick();
    }
    control.flush().unwrap();
    let other = tempfile::tempdir().unwrap();
    assert_eq!(known(&copied(other.path())), without(&['X', 'Y']));
    wait(&mut control, 3000);
    control.flush().unwrap();
    let other = tempfile::tempdir().unwrap();
    let rested = copied(other.path());
    assert_eq!(known(&rested), all);
    assert_eq!(rested.status().position.machine, control.status().position.machine);
}

/// GSK990MC part 2, 3.4.1 and 10.2.5: programs stay closed until somebody with the right opens them.
/// GSK990MC 4.2.8, 3).
#[test]
fn the_work_coordinate_system_is_the_one_before_the_power() {
    for (block, system) in [("G55", "G55"), ("G54 P3", "G54 P3"), ("G59", "G59"), ("G54", "G54")] {
        let folder = tempfile::tempdir().unwrap();
        {
            let mut control = control(folder.path());
            mode(&mut control, Mode::Mdi);
            say(&mut control, Command::Mdi { text: format!("{block}\n") });
            start(&mut control, Mode::Mdi);
            wait(&mut control, 200);
            control.flush().unwrap();
        }
        let mut control = control(folder.path());
        wait(&mut control, 1);
        let status = control.status();
        assert_eq!(status.position.system.as_deref(), Some(system), "{block}");
        // Its code is the one in force.
        let code = system.split(' ').next().unwrap();
        assert!(
            status.program.g_codes.iter().any(|in_force| in_force == code),
            "{:?}",
            status.program.g_codes
        );
    }
}

/// GSK990MC 4.2.8, 3 and 4.2.11: the system that G92 made outlasts the power, until one of the table is called or axes are sent to
/// their reference points by hand.
#[test]
fn the_system_that_g92_made_is_the_one_before_the_power() {
    let folder = tempfile::tempdir().unwrap();
    let mdi = |control: &mut Control, text: &str| {
        mode(control, Mode::Mdi);
        say(control, Command::Mdi { text: format!("{text}\n") });
        start(control, Mode::Mdi);
        wait(control, 200);
    };
    let work = |control: &Control| {
        let status = control.status();
        let at = |letter: char| status.position.work[&letter];
        ([at('X'), at('Y'), at('Z')], status.position.system.clone())
    };
    {
        let mut control = control(folder.path());
        mdi(&mut control, "G55");
        mdi(&mut control, "G92 X12.5 Z-3");
        control.flush().unwrap();
        assert_eq!(work(&control), ([12.5, 0.0, -3.0], None));
    }
    let kept = |control: &Control| control.interpreter().own_zero().unwrap();
    {
        let mut control = control(folder.path());
        wait(&mut control, 1);
        assert_eq!(work(&control), ([12.5, 0.0, -3.0], None));
        assert_eq!(kept(&control).0[0], control.status().position.machine[&'X'] - 12.5);
        // The system behind it is the one before.
        assert!(control.status().program.g_codes.iter().any(|code| code == "G55"));
    }
    let mut control = control(folder.path());
    wait(&mut control, 1);
    assert_eq!(work(&control).0, [12.5, 0.0, -3.0]);
    mdi(&mut control, "G55");
    assert_eq!(work(&control).1.as_deref(), Some("G55"));
    control.flush().unwrap();
    drop(control);
    let mut control = self::control(folder.path());
    wait(&mut control, 1);
    assert_eq!((work(&control).1.as_deref(), control.interpreter().own_zero()), (Some("G55"), None));
}

#[test]
fn the_program_switch_stands_after_the_power_as_it_was_left() {
    let folder = tempfile::tempdir().unwrap();
    let turn = |on: bool| Command::SetParameter { name: "NO54.6".into(), value: Some(f64::from(on)) };
    let refused = |control: &mut Control, command| control.command(command, &person()).unwrap_err().alarm.id;
    let program = || Command::Store { program: "O0001".into(), text: "M30\n".into() };
    {
        let mut control = control(folder.path());
        mode(&mut control, Mode::Mdi);
        say(&mut control, program());
        by_maintenance(&mut control, turn(false));
        assert_eq!(refused(&mut control, program()), "FC-1427");
    }
    let mut control = control(folder.path());
    assert_eq!(control.status().switches.programs, Some(false));
    assert_eq!(refused(&mut control, program()), "FC-1427");
    mode(&mut control, Mode::Mdi);
    assert_eq!(refused(&mut control, turn(true)), "FC-1213");
    // Nor does a backup bring programs.
    by_maintenance(&mut control, Command::Backup { file: "all.backup".into(), items: Vec::new() });
    let restore = |item: &str| Command::Restore { file: "all.backup".into(), items: vec![item.into()] };
    assert_eq!(refused(&mut control, restore("programs")), "FC-1427");
    say(&mut control, restore("variables"));
    by_maintenance(&mut control, turn(true));
    say(&mut control, program());
    // A program that may not be deleted stays selected.
    mode(&mut control, Mode::Auto);
    say(&mut control, Command::Select { program: "O1".into() });
    mode(&mut control, Mode::Edit);
    let lock = |locked| Command::Lock { program: "O0001".into(), locked };
    by_maintenance(&mut control, lock(true));
    let delete = || Command::Delete { program: "O0001".into() };
    refused(&mut control, delete());
    assert_eq!(control.status().program.selected.as_deref(), Some("O0001"));
    // Of all programs it is the one that stays (10.1.3).
    say(&mut control, Command::Store { program: "O0002".into(), text: "M30\n".into() });
    let names = |control: &mut Control| match say(control, Command::Programs) {
        Reply::Programs { programs, .. } => programs.into_iter().map(|program| program.name).collect(),
        _ => Vec::new(),
    };
    assert!(names(&mut control).contains(&"O0002".to_owned()));
    say(&mut control, Command::DeleteAll);
    control.flush().unwrap();
    assert_eq!(names(&mut control), ["O0001"]);
    by_maintenance(&mut control, lock(false));
    say(&mut control, delete());
    control.flush().unwrap();
    wait(&mut control, 100);
    assert_eq!(control.status().program.selected, None);
}

/// GSK990MC part 2, 3.7: messages of the ladder stand in the history, with when they came. One that comes and goes in
/// quick succession is one.
#[test]
fn messages_of_the_ladder_stand_in_the_history() {
    let folder = tempfile::tempdir().unwrap();
    let store = Arc::new(Store::open(folder.path(), Settings::new("gsk990mc")).unwrap());
    // One that stands, and one that comes and goes with every scan.
    let text =
        "MSG_STANDS = A0.0\nMSG_FLICKERS = A0.1\nRD R9091.1\nWRT A0.0\nRD.NOT A0.1\nWRT A0.1\nEND1\nEND2\n";
    let ladder = Some(Program::from_text(text.as_bytes(), &Limits::default()).unwrap());
    let parts = Parts { store: Some(store), ladder, ..Parts::default() };
    let mut control = Control::new(&Machine::demo_mill(), parts).unwrap();
    wait(&mut control, 500);
    control.flush().unwrap();
    let Reply::AlarmHistory { alarms } = say(&mut control, Command::AlarmHistory { most: 99 }) else {
        panic!()
    };
    let of = |name: &str| {
        let told = alarms.iter().filter(|past| past.values.values().any(|value| value == name));
        told.map(|past| past.id.clone()).collect::<Vec<_>>()
    };
    assert_eq!((of("MSG_STANDS"), of("MSG_FLICKERS")), (vec!["FC-1446".into()], vec!["FC-1446".to_owned()]));
}

/// GSK990MC part 2, 3.4.5: a ladder that stopped is started by level 2; the setter is calibrated by level 3, and
/// whoever may not hears it before anything moves.
#[test]
fn rights_are_asked_before_anything_happens() {
    let folder = tempfile::tempdir().unwrap();
    let mut control = with_ladder(folder.path());
    let calibrate = serde_json::json!({"do": "measure_tool", "mode": "calibrate_length", "length": 80.0});
    for command in [Command::StartLadder, serde_json::from_value(calibrate).unwrap()] {
        let refusal = control.command(command, &person()).unwrap_err();
        assert_eq!(refusal.alarm.id, "FC-1213");
    }
    let builder = Author::Maintenance { name: "builder".into() };
    assert_eq!(control.command(Command::StartLadder, &builder).unwrap(), Reply::Done);
}

fn shown<const N: usize>(control: &mut Control, names: [&str; N]) -> [f64; N] {
    let asked = Command::Parameters { names: names.map(str::to_owned).to_vec() };
    let Reply::Parameters { parameters, .. } = say(control, asked) else { panic!() };
    names.map(|name| parameters[name])
}

/// Appendix 1: P355, P358 to P360.
#[test]
fn starts_and_times_go_on_behind_the_power() {
    let folder = tempfile::tempdir().unwrap();
    for (starts, hours) in [(1.0, [0.0, 0.0, 0.0]), (2.0, [26.0, 1.0, 3.0]), (3.0, [26.0, 1.0, 3.0])] {
        let mut control = control(folder.path());
        assert_eq!(shown(&mut control, ["P355"]), [starts]);
        assert_eq!(shown(&mut control, ["P358", "P359", "P360"]), hours);
        for (counter, value) in [("power-on-time", 26.5 * 3600.0), ("all-cutting-time", 3.2 * 3600.0)] {
            let set = Command::SetCounter { counter: counter.into(), value };
            control.command(set, &Author::Control).unwrap();
        }
        wait(&mut control, 5);
        control.flush().unwrap();
    }
}

/// 0000: what the machine is built of holds from the next power-on.
#[test]
fn parameters_that_are_restored_are_told_where_the_power_is_to_be_cut() {
    let folder = tempfile::tempdir().unwrap();
    let alarms =
        |control: &Control| control.status().alarms.into_iter().map(|alarm| alarm.id).collect::<Vec<_>>();
    let mut one = control(folder.path());
    let mut by_control = |command| drop(one.command(command, &Author::Control).unwrap());
    let set = |value| Command::SetParameter { name: "P98".into(), value: Some(value) };
    by_control(set(800.0));
    by_control(Command::Backup { file: "all.backup".into(), items: vec!["parameters".into()] });
    by_control(set(2000.0));
    assert_eq!(alarms(&one), [""; 0]);
    one.command(Command::Restore { file: "all.backup".into(), items: vec![] }, &Author::Control).unwrap();
    assert_eq!((alarms(&one), shown(&mut one, ["P98"])), (vec!["gsk990mc:0000".to_owned()], [800.0]));
    one.flush().unwrap();
    drop(one);
    let mut again = control(folder.path());
    assert_eq!((alarms(&again), shown(&mut again, ["P98"])), (vec![], [800.0]));
}

#[test]
fn what_cycles_ask_of_a_tool_is_entered_within_its_range_and_kept() {
    let folder = tempfile::tempdir().unwrap();
    let none = OffsetValues::default();
    let set = |control: &mut Control, values, add| {
        control.command(Command::SetOffset { number: 7, values, add }, &person())
    };
    {
        let mut control = control(folder.path());
        let known = OffsetValues {
            cutting_length: Some(22.0),
            entry_angle: Some(3.0),
            tip_radius: Some(0.5),
            ..none
        };
        set(&mut control, known, false).unwrap();
        set(&mut control, OffsetValues { tip_radius: Some(0.25), ..none }, true).unwrap();
        for (wrong, add) in [
            (OffsetValues { cutting_length: Some(-1.0), ..none }, false),
            (OffsetValues { length: Some(-10_000.0), ..none }, false),
            (OffsetValues { radius: Some(99_999_999.0), ..none }, false),
            // P267.
            (OffsetValues { radius_wear: Some(400.5), ..none }, false),
            (OffsetValues { length_wear: Some(-400.5), ..none }, true),
            (OffsetValues { entry_angle: Some(90.5), ..none }, false),
            (OffsetValues { entry_angle: Some(-3.5), ..none }, true),
            (OffsetValues { tip_radius: Some(-1.0), ..none }, true),
            (OffsetValues { tip_radius: Some(f64::NAN), ..none }, false),
        ] {
            assert_eq!(set(&mut control, wrong, add).unwrap_err().alarm.id, "FC-1409", "{wrong:?}");
        }
        let far = Command::SetZero { system: "G54".into(), axes: [('X', -1e4)].into(), add: false };
        assert_eq!(control.command(far, &person()).unwrap_err().alarm.id, "FC-1409");
        control.flush().unwrap();
    }
    let mut control = control(folder.path());
    let Reply::Offsets { offsets } = say(&mut control, Command::Offsets { from: 7, to: 7 }) else { panic!() };
    let row = offsets[&7];
    assert_eq!((row.cutting_length, row.entry_angle, row.tip_radius), (Some(22.0), Some(3.0), Some(0.75)));
    assert_eq!((row.length, row.radius), (Some(0.0), Some(0.0)));
}

/// What somebody sets is kept as that, be it the value of the control's list; as delivered is what the machine file says.
#[test]
fn parameters_of_the_machine_file_hold_until_one_is_set_and_when_it_is_taken_back() {
    let folder = tempfile::tempdir().unwrap();
    let mut machine = Machine::demo_mill();
    machine.parameters.insert("P86".into(), 1500.0);
    machine.parameters.insert("NO27.0".into(), 1.0);
    let power_on = || {
        let store = Arc::new(Store::open(folder.path(), Settings::new("gsk990mc")).unwrap());
        Control::new(&machine, Parts { store: Some(store), ..Parts::default() }).unwrap()
    };
    let set = |control: &mut Control, value| {
        let set = Command::SetParameter { name: "P86".into(), value };
        control.command(set, &Author::Control).unwrap();
        control.flush().unwrap();
    };
    let mut one = power_on();
    assert_eq!(shown(&mut one, ["P86"]), [1500.0]);
    // 27#0 of the machine file forbids persons as if they had set it.
    let store = Command::Store { program: "O80001".into(), text: "M30\n".into() };
    assert!(one.command(store, &person()).is_err());
    // The list's own value.
    set(&mut one, Some(5000.0));
    drop(one);
    let mut two = power_on();
    assert_eq!(shown(&mut two, ["P86"]), [5000.0]);
    set(&mut two, None);
    assert_eq!(shown(&mut two, ["P86"]), [1500.0]);
    drop(two);
    assert_eq!(shown(&mut power_on(), ["P86"]), [1500.0]);
}

/// A parameter that the machine file goes before says so until somebody sets it, then it holds from the next power-on.
#[test]
fn parameters_that_nobody_has_set_are_left_to_the_machine_file() {
    let folder = tempfile::tempdir().unwrap();
    let left = |control: &mut Control| {
        let Reply::Parameters { left_to_file, .. } = say(control, Command::Parameters { names: vec![] })
        else {
            panic!()
        };
        left_to_file
    };
    let is_given = |control: &mut Control| {
        let Reply::Parameters { given, .. } = say(control, Command::Parameters { names: vec!["P88".into()] })
        else {
            panic!()
        };
        given
    };
    let mut one = control(folder.path());
    let of_file = left(&mut one);
    for name in ["P88", "P94", "P105", "P125", "NO17.1"] {
        assert!(of_file.iter().any(|left| left == name), "{name} {of_file:?}");
    }
    for name in ["P86", "P96", "P98", "P100", "P270"] {
        assert!(!of_file.iter().any(|left| left == name), "{name} {of_file:?}");
    }
    // As delivered, but set.
    one.command(Command::SetParameter { name: "P88".into(), value: Some(5000.0) }, &Author::Control).unwrap();
    assert!(!left(&mut one).contains(&"P88".to_owned()));
    assert_eq!(is_given(&mut one), ["P88"]);
    assert!(one.status().alarms.iter().any(|alarm| alarm.id == "gsk990mc:0000"));
    one.flush().unwrap();
    drop(one);
    let rapid = |control: &mut Control| {
        mode(control, Mode::Mdi);
        say(control, Command::Mdi { text: "G91 G0 X100".into() });
        start(control, Mode::Mdi);
        wait(control, 250);
        let speed = control.status().feed.actual;
        wait(control, 5000);
        speed
    };
    let mut two = control(folder.path());
    assert!(two.status().alarms.is_empty());
    assert_eq!(rapid(&mut two), 5000.0);
    two.command(Command::SetParameter { name: "P88".into(), value: None }, &Author::Control).unwrap();
    assert!(left(&mut two).contains(&"P88".to_owned()) && is_given(&mut two).is_empty());
    two.flush().unwrap();
    drop(two);
    assert!(rapid(&mut control(folder.path())) > 9000.0);
}

/// What a set-up and the machine file say is there as long as nobody has set anything else, be it 0 or the same.
#[test]
fn what_is_set_to_zero_is_zero_behind_a_set_up_too() {
    let folder = tempfile::tempdir().unwrap();
    let mut machine = Machine::demo_mill();
    machine.axes[0].pitch_errors = Some(PitchErrors {
        start: Some(-500.0),
        interval: Some(50.0),
        corrections: vec![0.0, 0.002, 0.003],
        opposite: Vec::new(),
    });
    let power_on = |is_set_up: bool| {
        let mut memory = ferrocut_controller::control::as_delivered(&machine).unwrap();
        if is_set_up {
            *memory.work.get_mut(WorkOffset::Standard(1)).unwrap() = Position::xyz(1.0, 2.0, 3.0);
            memory.tools.get_mut(3).unwrap().length = -12.0;
            memory.tools.get_mut(4).unwrap().length = -13.0;
        }
        let store = Arc::new(Store::open(folder.path(), Settings::new("gsk990mc")).unwrap());
        let parts = Parts { store: Some(store), memory: Some(memory), ..Parts::default() };
        Control::new(&machine, parts).unwrap()
    };
    let states = |control: &mut Control| {
        let memory = control.interpreter().memory();
        let lengths = [3, 4].map(|number| memory.tools.get(number).unwrap().length);
        let zero = memory.work.get(WorkOffset::Standard(1)).unwrap();
        let Reply::Pitch { points, .. } = say(control, Command::Pitch { axis: 'X' }) else { panic!() };
        (lengths, zero, points.into_iter().collect::<Vec<_>>())
    };
    let mut one = power_on(true);
    assert_eq!(states(&mut one).0, [-12.0, -13.0]);
    say(&mut one, offset(0.0));
    let again = OffsetValues { length: Some(-13.0), ..OffsetValues::default() };
    say(&mut one, Command::SetOffset { number: 4, values: again, add: false });
    for command in [
        // X of G54 by the parameter that is another name of it.
        Command::SetParameter { name: "P15".into(), value: Some(0.0) },
        Command::SetPitch { axis: 'X', points: [(2, 0.0)].into() },
    ] {
        one.command(command, &Author::Control).unwrap();
    }
    let set = ([0.0, -13.0], Position::xyz(0.0, 2.0, 3.0), vec![(1, 0.002)]);
    assert_eq!(states(&mut one), set);
    one.flush().unwrap();
    drop(one);
    assert_eq!(states(&mut power_on(true)), set);
    // Without the set-up what was set holds all the same.
    let mut without = power_on(false);
    assert_eq!(states(&mut without), set);
    drop(without);
    // Taken back it is what the set-up says.
    let mut with = power_on(true);
    with.command(Command::SetParameter { name: "P15".into(), value: None }, &Author::Control).unwrap();
    assert_eq!(states(&mut with).1, Position::xyz(1.0, 2.0, 3.0));
    with.flush().unwrap();
    drop(with);
    assert_eq!(states(&mut power_on(true)).1, Position::xyz(1.0, 2.0, 3.0));
}
