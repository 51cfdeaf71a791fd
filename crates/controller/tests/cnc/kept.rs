//! Programs and data that somebody entered: found under the name that was given, run as they stand, and kept.

use crate::common::shop::{Shop, person};
use ferrocut_controller::api::{Activity, Command, Reply};
use ferrocut_controller::{Mode, Parts};
use ferrocut_machine::Machine;
use ferrocut_memory::{Author, Settings, Store};
use std::path::Path;
use std::sync::Arc;

/// A control of this language on a durable memory.
fn shop(folder: &Path, dialect: &str) -> Shop {
    let mut machine = Machine::demo_mill();
    machine.dialect = dialect.to_owned();
    machine.parameters.clear();
    let store = Arc::new(Store::open(folder, Settings::new(dialect)).unwrap());
    Shop::of(&machine, Parts { store: Some(store), ..Parts::default() })
}

/// The power goes and comes.
fn again(mut before: Shop, folder: &Path, dialect: &str) -> Shop {
    before.control.flush().unwrap();
    drop(before);
    shop(folder, dialect)
}

fn variable(shop: &Shop, number: u32) -> Option<f64> {
    shop.control.interpreter().memory().variables.get(number)
}

fn mdi(shop: &mut Shop, text: &str) {
    shop.mode(Mode::Mdi);
    shop.say(Command::Mdi { text: text.into() });
    shop.start();
    assert_eq!(shop.until_it_stops().activity, Activity::Idle, "{:?}", shop.told());
}

fn by_control(shop: &mut Shop, command: Command) {
    shop.control.command(command, &Author::Control).unwrap();
}

fn text(shop: &mut Shop, program: &str) -> String {
    let Reply::Program { text, .. } = shop.say(Command::Read { program: program.into() }) else { panic!() };
    text
}

#[test]
fn a_subprogram_runs_as_it_stands_when_the_program_begins() {
    let mut shop = Shop::new(&[]);
    shop.store("O1", "O1\nM98 P2\nM30\n");
    shop.store("O2", "O2\n#500=1\nM99\n");
    shop.select("O1");
    let run = |shop: &mut Shop| {
        shop.mode(Mode::Auto);
        shop.start();
        (shop.until_it_stops().activity, variable(shop, 500), shop.told())
    };
    assert_eq!(run(&mut shop), (Activity::Idle, Some(1.0), vec![]));
    shop.store("O2", "O2\n#500=2\nM99\n");
    assert_eq!(run(&mut shop), (Activity::Idle, Some(2.0), vec![]));
    shop.say(Command::Rename { program: "O2".into(), to: "O3".into() });
    assert_eq!(run(&mut shop), (Activity::Alarm, Some(2.0), vec!["gsk990mc:0078".to_owned()]));
    shop.say(Command::Reset);
    shop.say(Command::Rename { program: "O3".into(), to: "O2".into() });
    shop.select("O1");
    assert_eq!(run(&mut shop).1, Some(2.0));
    shop.say(Command::Delete { program: "O2".into() });
    assert_eq!(run(&mut shop).2, ["gsk990mc:0078"]);
}

#[test]
fn a_program_is_found_by_the_name_that_it_was_stored_under() {
    let folder = tempfile::tempdir().unwrap();
    let mut shop = shop(folder.path(), "gsk990mc");
    for (number, name) in
        ["o1", "o0005", "O00007", "O000002", "3", "PartA", "Ärger", "O99999999999"].into_iter().enumerate()
    {
        let body = format!("(N{number})\nM30\n");
        shop.store(name, &body);
        assert_eq!(text(&mut shop, name), body, "{name}");
        shop.select(name);
        shop.mode(Mode::Edit);
    }
    // O1 is O0001, however it is written.
    let Reply::Programs { programs, .. } = shop.say(Command::Programs) else { panic!() };
    let count = programs.len();
    for name in ["O1", "O001", "O0001", "o00001", "1", "parta", "PARTA", "PartA"] {
        shop.store(name, &format!("({name})\nM30\n"));
        assert_eq!(text(&mut shop, name), format!("({name})\nM30\n"));
    }
    shop.say(Command::Rename { program: "3".into(), to: "o0033".into() });
    assert_eq!(text(&mut shop, "O33"), "(N4)\nM30\n");
    let Reply::Programs { programs, .. } = shop.say(Command::Programs) else { panic!() };
    assert_eq!(programs.len(), count, "{programs:?}");
    for program in programs {
        shop.say(Command::Delete { program: program.name });
    }
}

#[test]
fn what_is_asked_for_at_once_builds_on_what_is_on_its_way() {
    let folder = tempfile::tempdir().unwrap();
    let mut shop = shop(folder.path(), "gsk990mc");
    shop.store("O5", "(OLD)\nM30\n");
    shop.store("O9", "G91 G1 X50 F300\nM30\n");
    shop.select("O9");
    shop.start();
    shop.wait(100);
    shop.store("O5", "(NEW)\nM30\n");
    shop.say(Command::Rename { program: "O5".into(), to: "O6".into() });
    shop.store("O7", "(SEVEN)\nM30\n");
    shop.say(Command::Rename { program: "O7".into(), to: "O8".into() });
    shop.store("O11", "(A)\nM30\n");
    shop.store("O0011", "(B)\nM30\n");
    shop.store("O12", "(GONE)\nM30\n");
    shop.say(Command::Delete { program: "O12".into() });
    shop.until_it_stops();
    for (name, is) in [("O6", "(NEW)\nM30\n"), ("O8", "(SEVEN)\nM30\n"), ("O11", "(B)\nM30\n")] {
        assert_eq!(text(&mut shop, name), is);
    }
    let Reply::Programs { programs, .. } = shop.say(Command::Programs) else { panic!() };
    let mut names: Vec<String> = programs.into_iter().map(|program| program.name).collect();
    names.sort();
    assert_eq!(names, ["O11", "O6", "O8", "O9"]);
}

#[test]
fn reference_points_that_a_program_sets_are_kept_with_all_else() {
    let folder = tempfile::tempdir().unwrap();
    let mut shop = shop(folder.path(), "gsk990mc");
    mdi(&mut shop, "#600=7\nG10 L10 P3 R55.5\nG10 L2 P2 X10 Y3\nG10 L51\nN45 R12.5\nG11");
    let shop = again(shop, folder.path(), "gsk990mc");
    let memory = shop.control.interpreter().memory();
    assert_eq!((variable(&shop, 600), memory.tools.get(3).unwrap().length), (Some(7.0), 55.5));
    assert_eq!(memory.parameter(&"P45".parse().unwrap()), 12.5);
    assert_eq!(memory.parameter(&"P20".parse().unwrap()), 10.0);
}

#[test]
fn systems_of_rs274_are_kept_with_their_turns_and_the_one_in_force() {
    let folder = tempfile::tempdir().unwrap();
    let mut shop = shop(folder.path(), "rs274");
    mdi(&mut shop, "G10 L2 P2 X10 Y0 R45\nG10 L2 P7 X3\nG55 G0 X0\nG28.1\n#600=7");
    assert_eq!(shop.wait(1).position.system.as_deref(), Some("G55"));
    let mut shop = again(shop, folder.path(), "rs274");
    assert_eq!((variable(&shop, 5250), variable(&shop, 600)), (Some(45.0), Some(7.0)));
    let status = shop.wait(1);
    assert_eq!(status.position.system.as_deref(), Some("G55"));
    let [work, machine] = [&status.position.work, &status.position.machine].map(|at| [at[&'X'], at[&'Y']]);
    let turned = [work[0] - work[1], work[0] + work[1]].map(|at| at * 0.5_f64.sqrt());
    let off = [machine[0] - turned[0] - 10.0, machine[1] - turned[1]];
    assert!(off.iter().all(|off| off.abs() < 1e-9), "{work:?} {machine:?}");
    mdi(&mut shop, "G59.1 G0 X0");
    assert_eq!(shop.wait(1).position.system.as_deref(), Some("G54 P1"));
}

#[test]
fn counters_that_are_set_or_restored_are_what_was_set_or_restored() {
    let folder = tempfile::tempdir().unwrap();
    let mut shop = shop(folder.path(), "gsk990mc");
    by_control(&mut shop, Command::Backup { file: "new.backup".into(), items: vec!["counters".into()] });
    for (name, value) in [("P355", 44.0), ("P360", 9.0), ("P356", 5.0)] {
        by_control(&mut shop, Command::SetParameter { name: name.into(), value: Some(value) });
    }
    let mut shop = again(shop, folder.path(), "gsk990mc");
    let parameter = |shop: &Shop, number| shop.control.interpreter().memory().parameters.data(number);
    // A start more.
    assert_eq!((parameter(&shop, 355), parameter(&shop, 360), parameter(&shop, 356)), (45.0, 9.0, 5.0));
    by_control(&mut shop, Command::Restore { file: "new.backup".into(), items: vec!["counters".into()] });
    assert_eq!((shop.wait(1).counters.parts, parameter(&shop, 356), parameter(&shop, 360)), (0, 0.0, 0.0));
}

#[test]
fn what_is_closed_to_persons_is_closed_to_their_backups_and_left_by_delete_all() {
    let folder = tempfile::tempdir().unwrap();
    let mut shop = shop(folder.path(), "gsk990mc");
    let items = ["offsets", "zeros", "variables"];
    by_control(&mut shop, Command::SetParameter { name: "NO27.0".into(), value: Some(0.0) });
    shop.store("O4", "M30\n");
    shop.store("O80001", "M30\n");
    shop.say(Command::Backup { file: "old.backup".into(), items: items.map(str::to_owned).to_vec() });
    for (bits, item) in
        [(&["NO29.0", "NO29.1"][..], "offsets"), (&["NO29.3"], "zeros"), (&["NO29.2"], "variables")]
    {
        let restore = Command::Restore { file: "old.backup".into(), items: vec![item.into()] };
        for bit in bits {
            by_control(&mut shop, Command::SetParameter { name: (*bit).into(), value: Some(1.0) });
            assert_eq!(shop.refused(restore.clone()), "FC-1214", "{bit}");
            by_control(&mut shop, Command::SetParameter { name: (*bit).into(), value: Some(0.0) });
        }
        shop.say(restore);
    }
    by_control(&mut shop, Command::SetParameter { name: "NO27.0".into(), value: Some(1.0) });
    shop.control.command(Command::DeleteAll, &person()).unwrap();
    let Reply::Programs { programs, .. } = shop.say(Command::Programs) else { panic!() };
    assert_eq!(programs.len(), 1);
    assert_eq!(programs[0].name, "O80001");
}

#[test]
fn a_zero_that_a_person_sets_on_rs274_is_the_one_that_programs_run_in() {
    let folder = tempfile::tempdir().unwrap();
    let mut shop = shop(folder.path(), "rs274");
    let set = |shop: &mut Shop, system: &str, x| {
        let axes = [('X', x)].into();
        shop.say(Command::SetZero { system: system.into(), axes, add: false });
    };
    set(&mut shop, "G54", 20.0);
    mdi(&mut shop, "G54 G0 X0");
    assert_eq!((shop.x(), shop.wait(1).position.work[&'X']), (20.0, 0.0));
    mdi(&mut shop, "G55 G0 X3");
    set(&mut shop, "G55", 5.0);
    set(&mut shop, "G54", 30.0);
    assert_eq!((shop.x(), shop.wait(1).position.work[&'X']), (3.0, -2.0));
    mdi(&mut shop, "G0 X1");
    assert_eq!((shop.x(), shop.wait(1).position.work[&'X']), (6.0, 1.0));
    // What a backup puts back is in force at once, with the system and its turn.
    let items = ["zeros", "variables"].map(str::to_owned).to_vec();
    mdi(&mut shop, "G10 L2 P2 R90");
    by_control(&mut shop, Command::Backup { file: "turned.backup".into(), items: items.clone() });
    mdi(&mut shop, "G10 L2 P2 R0\nG92 X0\nG54");
    by_control(&mut shop, Command::Restore { file: "turned.backup".into(), items });
    assert_eq!(shop.wait(1).position.system.as_deref(), Some("G55"));
    mdi(&mut shop, "G0 X0 Y0\nX7");
    assert_eq!(shop.wait(1).position.machine[&'X'].round(), 5.0);
    assert_eq!(shop.wait(1).position.machine[&'Y'].round(), 7.0);
}

#[test]
fn a_program_on_its_way_to_the_disk_is_chosen_and_runs_once_it_is_there() {
    let folder = tempfile::tempdir().unwrap();
    let mut shop = shop(folder.path(), "gsk990mc");
    shop.store("O1", "#500=1\nM30\n");
    shop.select("O1");
    // Axes that move by hand must not wait for the disk.
    shop.mode(Mode::Jog);
    shop.inputs.jog[0].plus = true;
    shop.wait(100);
    shop.mode(Mode::Edit);
    shop.store("O1", "#500=2\nM30\n");
    shop.store("O7", "#500=7\nM30\n");
    shop.say(Command::Select { program: "O7".into() });
    shop.inputs.jog[0].plus = false;
    shop.wait(500);
    for (program, value) in [("O7", 7.0), ("O1", 2.0)] {
        shop.select(program);
        shop.start();
        shop.until_it_stops();
        assert_eq!(variable(&shop, 500), Some(value), "{:?}", shop.told());
    }
}

#[test]
fn counters_are_set_by_nobody_and_names_are_answered_as_they_were_asked() {
    let mut shop = Shop::new(&[("P86", 3000.0)]);
    let mut given = |names: &[&str]| {
        let names = names.iter().map(|name| (*name).to_owned()).collect();
        let Reply::Parameters { parameters, given, .. } = shop.say(Command::Parameters { names }) else {
            panic!()
        };
        (parameters.len(), given)
    };
    assert_eq!(given(&["P0086", "P355", "P356"]), (3, vec!["P0086".to_owned()]));
    assert_eq!(given(&[]).1, ["P86"]);
}
