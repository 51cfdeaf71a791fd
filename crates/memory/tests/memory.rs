//! What is kept, how it is logged, and who may change it.
#![allow(missing_docs, clippy::unwrap_used, clippy::panic, clippy::expect_used)]

mod common;

use common::{CONTROL, all, key, number, open, owner, parameter, program, settings, something, variable};
use ferrocut_geometry::{Axis, AxisSet, Position};
use ferrocut_machine::{Alarm, Fault, Memory, ToolOffset, WorkOffset};
use ferrocut_memory::{
    AlarmEntry, Author, Change, Counter, Error, InterruptedRun, Item, LastPosition, Level, OpenError,
    PlcArea, Seat, Session, Settings, Store, control, items,
};
use ferrocut_program::Span;
use proptest::prelude::*;
use std::time::{Duration, Instant};
use tempfile::tempdir;

fn person(session: Session) -> Author {
    Author::Person { session, name: "Li Wei".to_owned() }
}

fn operator() -> Author {
    person(Session::OPERATOR)
}

#[test]
fn everything_is_there_after_power_off() {
    let folder = tempdir().unwrap();
    let last = LastPosition {
        time: 5,
        position: Position::xyz(1.0, 2.0, 3.0),
        referenced: [Axis::X, Axis::Z].into_iter().collect::<AxisSet>(),
        work_system: Some(WorkOffset::Additional(2)),
        own_zero: Some(Position::xyz(-0.1, 7.25, 1.0 / 3.0)),
    };
    let alarm = Alarm::core(Fault::SoftLimit, Span::default()).with("axis", "X").with("limit", 500.0);
    let alarm = AlarmEntry::of(&alarm, "O1234", 7);
    let run = InterruptedRun {
        time: 6,
        program: "O1234".to_owned(),
        from_line: 1,
        file: "O0002".to_owned(),
        line: 7,
        block: 31,
        text: "G1 X3".to_owned(),
        at: Some(Position::xyz(3.0, -4.5, 0.25)),
    };
    let before = {
        let store = open(folder.path());
        store.commit(&owner(), something(3)).unwrap();
        let more = vec![
            Change::LastPosition(last.clone()),
            Change::Alarm(alarm.clone()),
            Change::Interrupted(Some(run.clone())),
        ];
        store.commit(&Author::Control, more).unwrap();
        all(&store)
    };
    let store = open(folder.path());
    let after = all(&store);
    assert_eq!(before, after);
    assert_eq!(after.last_position, Some(last));
    assert_eq!(after.interrupted, Some(run));
    assert_eq!(after.alarms, [alarm]);
    assert_eq!(after.alarms[0].alarm_id(), Some(ferrocut_machine::AlarmId::Core(Fault::SoftLimit)));
    assert_eq!(after.programs["O1234"].text, b"O1234 (PART 3)\nG0 X3\nM30\n");
    assert_eq!(after.parameters[&key("P270")], 3.5);
    assert_eq!(after.offsets[&4].length, 103.0);
    assert_eq!(after.offsets[&4].radius_wear, -0.003);
    assert_eq!(after.work_zeros[&WorkOffset::Standard(1)], Position::xyz(3.0, -3.0, 0.1 * 3.0));
    assert_eq!(after.work_zeros[&WorkOffset::Additional(4)], Position::xyz(0.0, 3.0, 0.0));
    assert_eq!(after.reference_points[&2], Position::xyz(0.0, 0.0, 3.0));
    assert_eq!(after.variables[&number(503)], 3.0 * 0.1);
    assert_eq!(after.pitch[&(Axis::X, 3)], 0.0001 * 3.0);
    assert_eq!(after.plc[&PlcArea::D][3..7], [3, 0, 0, 0]);
    assert_eq!(after.plc[&PlcArea::K][0], 3);
    assert_eq!(after.counters[&Counter::Parts], 3.0);
    assert_eq!(after.ladder.as_deref(), Some("; ladder 3\nEND1\nEND2\n"));
    assert_eq!(store.reader().alarms(10).unwrap().len(), 1);
    assert_eq!(store.reader().check(folder.path()), Ok(store.reader().commits().unwrap()));
    store.commit(&Author::Control, vec![Change::Interrupted(None)]).unwrap();
    assert_eq!(all(&store).interrupted, None);
}

#[test]
fn an_empty_variable_is_not_zero() {
    let folder = tempdir().unwrap();
    let store = open(folder.path());
    let part = Author::Program { name: "O1".to_owned() };
    store.commit(&part, vec![variable(500, Some(0.0)), variable(501, Some(1.0))]).unwrap();
    store.commit(&part, vec![variable(501, None), variable(502, Some(f64::NAN))]).unwrap();
    let kept = all(&store).variables;
    assert_eq!(kept.get(&number(500)), Some(&0.0));
    assert_eq!((kept.get(&number(501)), kept.get(&number(502))), (None, None));
    for wrong in [variable(0, Some(1.0)), variable(500, Some(f64::INFINITY))] {
        assert!(matches!(store.commit(&part, vec![wrong]), Err(Error::Value(_))));
    }
}

#[test]
fn who_exchanges_the_ladder_or_forces_a_signal_stands_in_the_log() {
    let folder = tempdir().unwrap();
    let store = open(folder.path());
    let ladder = |text: Option<&str>| Change::Ladder { text: text.map(str::to_owned) };
    let force = |value| Change::Force { signal: "X20.3".to_owned(), value };
    for change in [ladder(Some("END1")), force(Some(true))] {
        let refused = store.commit(&operator(), vec![change]);
        assert!(matches!(refused, Err(Error::Right { needed: Level::Builder, .. })));
    }
    let huge = "x".repeat(items::limits::LADDER + 1);
    assert!(matches!(store.commit(&owner(), vec![ladder(Some(&huge))]), Err(Error::Full(Item::Ladder))));
    store.commit(&owner(), vec![ladder(Some("END1\nEND2\n")), force(Some(true))]).unwrap();
    store.commit(&owner(), vec![force(None)]).unwrap();
    // The control takes one out itself that fails: that is logged like what persons do.
    store.commit(&Author::Control, vec![ladder(None)]).unwrap();
    assert_eq!(all(&store).ladder, None);
    let log: Vec<_> = store.reader().log(4).unwrap().into_iter().rev().collect();
    let shown: Vec<_> = log.iter().map(|e| (e.item.as_str(), e.name.as_str(), e.to.as_str())).collect();
    assert_eq!((shown[0].0, shown[0].1), ("ladder", "exchanged"));
    assert!(shown[0].2.starts_with("10 "), "{}", shown[0].2);
    assert_eq!(shown[1..3], [("plc", "X20.3", "forced 1"), ("plc", "X20.3", "released")]);
    assert_eq!((log[3].from.as_str(), log[3].to.as_str(), log[3].who.as_str()), (shown[0].2, "", "control"));
}

#[test]
fn changes_come_together_or_not_at_all() {
    let folder = tempdir().unwrap();
    let store = open(folder.path());
    let together = vec![variable(500, Some(1.0)), parameter("P270", -1.0)];
    assert!(matches!(store.commit(&owner(), together), Err(Error::Parameter(_))));
    assert!(all(&store).variables.is_empty());
    // The error of a change that nobody waited for comes with the next flush, once.
    store.put(&owner(), vec![variable(501, Some(1.0))]).unwrap();
    store.put(&owner(), vec![parameter("P3", 1.0)]).unwrap();
    store.put(&owner(), vec![variable(502, Some(2.0))]).unwrap();
    assert!(matches!(store.flush(), Err(Error::Parameter(_))));
    store.flush().unwrap();
    assert_eq!(all(&store).variables.len(), 2);
}

#[test]
fn a_burst_costs_few_commits() {
    let folder = tempdir().unwrap();
    let store = open(folder.path());
    let part = Author::Program { name: "O1".to_owned() };
    let before = store.reader().commits().unwrap();
    for n in 0..20_000u32 {
        store.put(&part, vec![variable(500 + n % 500, Some(f64::from(n)))]).unwrap();
    }
    let last = store.flush().unwrap();
    assert_eq!(all(&store).variables[&number(999)], 19_999.0);
    assert!(last - before < 10_000, "{} commits", last - before);
}

#[test]
fn the_log_says_who_changed_what_from_what_to_what() {
    let folder = tempdir().unwrap();
    let store = open(folder.path());
    let offset = ToolOffset { length: 50.0, length_wear: -0.02, ..ToolOffset::ZERO };
    store.commit(&operator(), vec![Change::Offset { number: 12, offset }]).unwrap();
    store.commit(&operator(), vec![variable(500, Some(2.5))]).unwrap();
    // Set to what it is: nothing to tell.
    store.commit(&operator(), vec![Change::Offset { number: 12, offset }]).unwrap();
    let part = Author::Program { name: "O7".to_owned() };
    store.commit(&part, vec![variable(500, Some(3.0)), parameter("P270", 1.5)]).unwrap();
    store.commit(&owner(), vec![parameter("P270", 3.0), program("O1", "M30")]).unwrap();
    let log: Vec<_> = store.reader().log(100).unwrap().into_iter().rev().collect();
    let told: Vec<_> = log
        .iter()
        .map(|e| (e.level, e.who.as_str(), e.item.as_str(), e.name.as_str(), e.from.as_str(), e.to.as_str()))
        .collect();
    let level = Some(Level::Operator);
    assert_eq!(
        told,
        [
            (level, "Li Wei", "offsets", "12 length", "0", "50"),
            (level, "Li Wei", "offsets", "12 length_wear", "0", "-0.02"),
            (level, "Li Wei", "variables", "#500", "", "2.5"),
            // The parameter's value as delivered is 2.
            (None, "O7", "parameters", "P270", "2", "1.5"),
            (None, "test", "parameters", "P270", "1.5", "3"),
            (None, "test", "programs", "O1", "", "3"),
        ]
    );
    assert!(log.iter().all(|entry| entry.time > 0));
    let cleared = store.commit(&operator(), vec![Change::ClearLog]);
    assert_eq!(cleared, Err(Error::Right { needed: Level::Commissioning, level: Level::Operator }));
    store.commit(&owner(), vec![Change::ClearLog]).unwrap();
    let log = store.reader().log(100).unwrap();
    assert_eq!((log.len(), log[0].name.as_str(), log[0].from.as_str()), (1, "all", "6"));
}

#[test]
fn histories_are_bounded_and_newest_first() {
    let folder = tempdir().unwrap();
    let store = open(folder.path());
    let most = items::limits::ALARMS;
    for time in 0..most + 25 {
        let alarm =
            AlarmEntry { time, id: "FC-0302".into(), program: String::new(), line: 0, arguments: vec![] };
        store.put(&Author::Control, vec![Change::Alarm(alarm)]).unwrap();
    }
    store.flush().unwrap();
    let alarms = all(&store).alarms;
    assert_eq!(alarms.len() as i64, most);
    assert_eq!((alarms[0].time, alarms.last().unwrap().time), (most + 24, 25));
}

#[test]
fn a_parameter_that_is_another_name_of_a_zero_is_one_value() {
    let folder = tempdir().unwrap();
    let store = open(folder.path());
    // P15 is the zero of G54 in X, P46 the first reference point in Y.
    store.commit(&owner(), vec![parameter("P15", 12.5), parameter("P46", -3.0)]).unwrap();
    let kept = all(&store);
    assert!(kept.parameters.is_empty());
    assert_eq!(kept.work_zeros[&WorkOffset::Standard(1)], Position::xyz(12.5, 0.0, 0.0));
    assert_eq!(kept.reference_points[&1], Position::xyz(0.0, -3.0, 0.0));
    assert_eq!(store.reader().log(1).unwrap()[0].name, "P046".replace("P0", "P"));
}

#[test]
fn an_operator_changes_the_work_and_not_the_machine() {
    let folder = tempdir().unwrap();
    let store = open(folder.path());
    let offset = ToolOffset { length: 1.0, ..ToolOffset::ZERO };
    let zero = Change::WorkZero { name: WorkOffset::Standard(2), zero: Position::xyz(1.0, 0.0, 0.0) };
    for change in [
        Change::Offset { number: 1, offset },
        zero.clone(),
        variable(500, Some(1.0)),
        program("O1", "M30"),
        Change::Counter { counter: Counter::Parts, value: 0.0 },
    ] {
        store.commit(&operator(), vec![change]).unwrap();
    }
    for (change, needed) in [
        (parameter("P270", 1.0), Level::Shop),
        (parameter("P88", 1.0), Level::Commissioning),
        (Change::Pitch { axis: Axis::X, point: 1, value: 0.01 }, Level::Commissioning),
        (Change::ClearAlarms, Level::Commissioning),
        (Change::Plc { area: PlcArea::K, first: 0, bytes: vec![1] }, Level::Builder),
        (Change::Counter { counter: Counter::PowerOnTime, value: 0.0 }, Level::Builder),
    ] {
        let refused = Err(Error::Right { needed, level: Level::Operator });
        assert_eq!(store.commit(&operator(), vec![change]), refused);
    }
    let part = Author::Program { name: "O1".to_owned() };
    assert_eq!(store.commit(&part, vec![program("O2", "M30")]), Err(Error::NotByThis));
    // 29#0 to 29#3 and P211, P212 close offsets, variables and zeros to the panel.
    let wear = ToolOffset { length_wear: 0.1, ..offset };
    let cases = [
        ("NO29.0", Change::Offset { number: 1, offset: wear }),
        ("NO29.1", Change::Offset { number: 1, offset: ToolOffset { length: 2.0, ..offset } }),
        ("NO29.2", variable(500, Some(2.0))),
        ("NO29.3", zero),
    ];
    for (name, change) in &cases {
        store.commit(&owner(), vec![parameter(name, 1.0)]).unwrap();
        assert_eq!(store.commit(&operator(), vec![change.clone()]), Err(Error::Protected((*name).into())));
        store.commit(&owner(), vec![parameter(name, 0.0)]).unwrap();
        store.commit(&operator(), vec![change.clone()]).unwrap();
    }
    store.commit(&owner(), vec![parameter("NO29.1", 1.0)]).unwrap();
    // Wear alone stays open.
    store
        .commit(
            &operator(),
            vec![Change::Offset { number: 3, offset: ToolOffset { length_wear: 0.5, ..ToolOffset::ZERO } }],
        )
        .unwrap();
    store
        .commit(&owner(), vec![parameter("NO29.1", 0.0), parameter("P211", 10.0), parameter("P212", 2.0)])
        .unwrap();
    for (number, open) in [(9, true), (10, false), (11, false), (12, true)] {
        let done = store.commit(&operator(), vec![Change::Offset { number, offset }]);
        assert_eq!(done.is_ok(), open, "{number}");
    }
}

#[test]
fn programs_are_locked_by_level_and_by_number() {
    let folder = tempdir().unwrap();
    let store = open(folder.path());
    // 27#0 and 27#4 are 1 as delivered.
    for (name, by) in [("O80000", "NO27.0"), ("O89999", "NO27.0"), ("90000", "NO27.4"), ("o99999", "NO27.4")]
    {
        let refused = Err(Error::Protected(by.into()));
        assert_eq!(store.commit(&operator(), vec![program(name, "M99")]), refused, "{name}");
    }
    store
        .commit(&operator(), vec![program("O79999", "M99"), program("O100000", "M99"), program("O8X", "M99")])
        .unwrap();
    store.commit(&owner(), vec![parameter("NO27.0", 0.0)]).unwrap();
    store.commit(&operator(), vec![program("O80000", "M99")]).unwrap();
    let lock = |locked| Change::LockProgram { name: "O79999".to_owned(), locked };
    store.commit(&owner(), vec![lock(true)]).unwrap();
    for change in [program("O79999", "M30"), Change::DeleteProgram { name: "O79999".to_owned() }] {
        assert_eq!(store.commit(&operator(), vec![change]), Err(Error::Locked(Level::Maker)));
    }
    let entry = store.reader().programs().unwrap().into_iter().find(|p| p.name == "O79999").unwrap();
    assert_eq!((entry.locked, entry.bytes), (Some(Level::Maker), 3));
    store.commit(&owner(), vec![lock(false)]).unwrap();
    store.commit(&operator(), vec![Change::DeleteProgram { name: "O79999".to_owned() }]).unwrap();
    assert_eq!(store.reader().program("O79999").unwrap(), None);
}

#[test]
fn a_program_keeps_its_time_of_creation() {
    let folder = tempdir().unwrap();
    let store = open(folder.path());
    store.commit(&operator(), vec![program("O1", "M30")]).unwrap();
    let first = store.reader().program("O1").unwrap().unwrap();
    std::thread::sleep(Duration::from_millis(3));
    store.commit(&operator(), vec![program("O1", "M02")]).unwrap();
    let second = store.reader().program("O1").unwrap().unwrap();
    assert_eq!(second.created, first.created);
    assert!(second.changed > first.changed && second.text == b"M02");
    let large = Change::Program {
        name: "O2".into(),
        text: vec![b' '; items::limits::PROGRAM + 1],
        comment: String::new(),
    };
    assert_eq!(store.commit(&operator(), vec![large]), Err(Error::Full(Item::Programs)));
    for name in ["", "O1\n", &"O".repeat(200)] {
        assert!(matches!(store.commit(&operator(), vec![program(name, "M30")]), Err(Error::Value(_))));
    }
}

#[test]
fn a_new_control_has_no_password_that_works() {
    let folder = tempdir().unwrap();
    let store = open(folder.path());
    for level in [Level::Maker, Level::Builder, Level::Commissioning, Level::Shop] {
        for password in ["", "0", "1234", "gsk", "password", "admin"] {
            let refused = store.log_in(level, password, Seat::Machine, "Li");
            assert_eq!(refused, Err(Error::NoPassword(level)));
        }
    }
    // Not from afar, not a lower level first, not too short.
    let set =
        |author: &Author, level, password: &str, seat| store.set_password(author, level, password, seat);
    let right = |level| Err(Error::Right { needed: level, level: Level::Operator });
    assert_eq!(set(&operator(), Level::Maker, "correct horse", Seat::Network), right(Level::Maker));
    assert_eq!(set(&operator(), Level::Shop, "correct horse", Seat::Machine), right(Level::Shop));
    assert_eq!(set(&operator(), Level::Maker, "short", Seat::Machine), Err(Error::PasswordLength));
    set(&operator(), Level::Maker, "correct horse", Seat::Machine).unwrap();
    // Claimed once.
    assert_eq!(set(&operator(), Level::Maker, "battery staple", Seat::Machine), right(Level::Maker));
    let maker = person(store.log_in(Level::Maker, "correct horse", Seat::Network, "Li").unwrap());
    set(&maker, Level::Commissioning, "nine millimetres", Seat::Network).unwrap();
    let session = store.log_in(Level::Commissioning, "nine millimetres", Seat::Machine, "Li").unwrap();
    let commissioning = person(session);
    assert_eq!(
        set(&commissioning, Level::Builder, "nine millimetres", Seat::Machine),
        Err(Error::Right { needed: Level::Builder, level: Level::Commissioning })
    );
    set(&commissioning, Level::Shop, "shop shop shop", Seat::Network).unwrap();
    store.commit(&commissioning, vec![parameter("P88", 6000.0)]).unwrap();
    assert_eq!(
        store.reader().levels_with_password().unwrap(),
        [Level::Maker, Level::Commissioning, Level::Shop]
    );
    // Hashed, and never written in the clear.
    drop(store);
    for file in ["memory.db", "memory.db-wal"] {
        let bytes = std::fs::read(folder.path().join(file)).unwrap_or_default();
        let holds = |word: &[u8]| bytes.windows(word.len()).any(|w| w == word);
        assert!(!holds(b"correct horse") && !holds(b"nine millimetres"), "{file}");
        assert!(file != "memory.db" || holds(b"$argon2id$v=19$"));
    }
    let store = open(folder.path());
    assert!(store.log_in(Level::Maker, "correct horse", Seat::Machine, "Li").is_ok());
    let told: Vec<String> =
        store.reader().log(100).unwrap().into_iter().map(|e| e.name + " " + &e.to).collect();
    assert!(told.contains(&"password 1 set".to_owned()) && told.contains(&"log in 1 right".to_owned()));
}

#[test]
fn wrong_passwords_must_wait_longer_and_longer() {
    let folder = tempdir().unwrap();
    let store = open(folder.path());
    store.set_password(&owner(), Level::Shop, "correct horse", Seat::Machine).unwrap();
    let try_it = |store: &Store, password: &str, seat| store.log_in(Level::Shop, password, seat, "x");
    for _ in 0..3 {
        assert_eq!(try_it(&store, "wrong", Seat::Network), Err(Error::WrongPassword));
    }
    // Not even the right one, until the time is over.
    let Err(Error::Wait(left)) = try_it(&store, "correct horse", Seat::Network) else { panic!() };
    assert!(left <= Duration::from_secs(1) && left > Duration::from_millis(500));
    // Whoever stands at the machine is not kept out by someone far away.
    assert!(try_it(&store, "correct horse", Seat::Machine).is_ok());
    // A restart does not help.
    drop(store);
    let store = open(folder.path());
    let begin = Instant::now();
    assert!(matches!(try_it(&store, "correct horse", Seat::Network), Err(Error::Wait(_))));
    while let Err(error) = try_it(&store, "correct horse", Seat::Network) {
        assert!(matches!(error, Error::Wait(_)), "{error}");
        std::thread::sleep(Duration::from_millis(20));
    }
    assert!(begin.elapsed() > Duration::from_millis(900));
    let wrong = store.reader().log(100).unwrap().iter().filter(|e| e.to == "wrong").count();
    assert_eq!(wrong, 3);
}

#[test]
fn one_process_writes_and_one_control() {
    let folder = tempdir().unwrap();
    let store = open(folder.path());
    assert!(matches!(Store::open(folder.path(), settings()), Err(OpenError::Busy)));
    let beside = ferrocut_memory::Reader::open(folder.path()).unwrap();
    store.commit(&owner(), vec![variable(500, Some(1.0))]).unwrap();
    assert_eq!(beside.contents(&[Item::Variables]).unwrap().variables.len(), 1);
    drop(store);
    match Store::open(folder.path(), Settings::new("weihong")) {
        Err(OpenError::OtherControl(name)) => assert_eq!(name, CONTROL),
        _ => panic!(),
    }
}

#[test]
fn the_memory_of_the_running_control_is_a_copy() {
    let folder = tempdir().unwrap();
    let store = open(folder.path());
    let mut machine = Memory::new(CONTROL);
    let empty = machine.clone();
    machine.set_parameter(&key("P270"), 1.25).unwrap();
    machine.set_parameter(&key("NO43.1"), 0.0).unwrap();
    machine.set_parameter(&key("P15"), 7.0).unwrap();
    machine.work.additional[1] = Position::xyz(1.0, 2.0, 3.0);
    machine.tools.get_mut(7).unwrap().radius = 4.0;
    machine.variables.set(100, Some(1.0)).unwrap();
    machine.variables.set(500, Some(0.0)).unwrap();
    machine.reference_points[1] = Position::xyz(0.0, 0.0, 9.0);
    let changes = control::changes(&empty, &machine);
    store.commit(&Author::Control, changes).unwrap();
    // Typed by a person, who is told in the log.
    let typed = Change::Variable { name: number(150), value: Some(3.0) };
    store.commit(&operator(), vec![typed]).unwrap();
    let kept = store.reader().contents(&control::ENTERED).unwrap();
    let mut again = Memory::new(CONTROL);
    assert_eq!(control::enter(&kept, &mut again), [""; 0]);
    assert_eq!(control::changes(&machine, &again), []);
    // #100 to #199 are lost with the power.
    assert_eq!([100, 150, 500].map(|number| again.variables.get(number)), [None, None, Some(0.0)]);
    assert_eq!(again.work.standard[0], Position::xyz(7.0, 0.0, 0.0));
    let mut small = Memory::new("weihong");
    assert!(!control::enter(&kept, &mut small).is_empty());
}

fn any_change() -> impl Strategy<Value = Change> {
    let value = prop_oneof![Just(0.0), Just(-0.0), -1e9..1e9f64, Just(1e-300), Just(0.1 + 0.2)];
    prop_oneof![
        (500u32..520, proptest::option::of(value.clone())).prop_map(|(n, v)| variable(n, v)),
        (1u16..6, value.clone(), value.clone()).prop_map(|(number, a, b)| Change::Offset {
            number,
            offset: ToolOffset { length: a, tip_radius: b, ..ToolOffset::ZERO }
        }),
        (1u8..=6, value.clone()).prop_map(|(n, v)| Change::WorkZero {
            name: WorkOffset::Standard(n),
            zero: Position::xyz(v, 0.0, -v)
        }),
        (0u16..9990, proptest::collection::vec(any::<u8>(), 0..200)).prop_map(|(first, mut bytes)| {
            bytes.truncate(10_000 - usize::from(first));
            Change::Plc { area: PlcArea::D, first, bytes }
        }),
        ("O[0-9]{1,2}", proptest::collection::vec(any::<u8>(), 0..50))
            .prop_map(|(name, text)| Change::Program { name, text, comment: "c".into() }),
        (0u16..9, value).prop_map(|(point, value)| Change::Pitch { axis: Axis::C, point, value }),
    ]
}

proptest! {
    #![proptest_config(ProptestConfig { cases: 24, ..ProptestConfig::default() })]

    /// Whatever is written is read, across power-off and a backup, as a plain map would have it.
    #[test]
    fn what_is_written_is_read(changes in proptest::collection::vec(any_change(), 1..60)) {
        let folder = tempdir().unwrap();
        let mut variables = std::collections::BTreeMap::new();
        let mut bytes = vec![0u8; 10_000];
        for change in &changes {
            match change {
                Change::Variable { name, value: Some(value) } => drop(variables.insert(name.clone(), *value + 0.0)),
                Change::Variable { name, value: None } => drop(variables.remove(name)),
                Change::Plc { first, bytes: new, .. } => {
                    bytes[usize::from(*first)..usize::from(*first) + new.len()].copy_from_slice(new);
                }
                _ => {}
            }
        }
        let store = open(folder.path());
        for pair in changes.chunks(3) {
            store.put(&owner(), pair.to_vec()).unwrap();
        }
        store.flush().unwrap();
        let kept = all(&store);
        prop_assert_eq!(&kept.variables, &variables);
        let data = kept.plc.get(&PlcArea::D).cloned().unwrap_or_default();
        prop_assert_eq!(&bytes[..data.len()], &data[..]);
        prop_assert!(bytes[data.len()..].iter().all(|b| *b == 0));
        let file = folder.path().join("all.backup");
        store.reader().back_up(&file, &Item::ALL).unwrap();
        drop(store);
        prop_assert_eq!(&all(&open(folder.path())), &kept);
        let other = tempdir().unwrap();
        let store = open(other.path());
        let backup = ferrocut_memory::Backup::open(&file).unwrap();
        backup.restore(&store, &owner(), &Item::ALL[..10]).unwrap();
        let mut restored = all(&store);
        restored.log = kept.log.clone();
        prop_assert_eq!(&restored, &kept);
    }
}

/// A process that another thread is starting has a copy of the lock's file for a moment: that must not keep it.
#[test]
fn a_memory_can_be_opened_again_while_processes_are_started() {
    let folder = tempdir().unwrap();
    std::thread::scope(|scope| {
        let starter = scope.spawn(|| {
            for _ in 0..500 {
                std::process::Command::new("true").status().unwrap();
            }
        });
        while !starter.is_finished() {
            drop(open(folder.path()));
        }
    });
}

/// What is in no file is judged and read alike, by any thread, and each is one of its own.
#[test]
fn a_memory_that_is_not_kept_does_the_same() {
    let store = Store::in_memory("gsk990mc").unwrap();
    let other = Store::in_memory("gsk990mc").unwrap();
    assert_eq!(store.folder(), None);
    let value = |value| Change::Parameter { key: "P86".parse().unwrap(), value: Some(value) };
    assert!(matches!(store.commit(&operator(), vec![value(5.0)]), Err(Error::Right { .. })));
    // Reading and writing at once: neither is told that the other is at it.
    std::thread::scope(|scope| {
        let reads = scope.spawn(|| (0..500).all(|_| store.reader().contents(&[Item::Variables]).is_ok()));
        for n in 0..500 {
            store.commit(&Author::Control, vec![variable(500, Some(f64::from(n)))]).unwrap();
        }
        assert!(reads.join().unwrap());
    });
    let found = store.reader().contents(&[Item::Variables]).unwrap();
    assert_eq!(found.variables[&number(500)], 499.0);
    assert_eq!((store.reader().commits().unwrap(), other.reader().commits().unwrap()), (500, 0));
}
