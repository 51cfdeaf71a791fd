//! Reference points, pitch errors, renamed programs: by a front, with rights, over power-off.

use crate::common::shop::{Shop, person};
use ferrocut_controller::api::{Command, Event, Reply};
use ferrocut_controller::{Mode, Parts};
use ferrocut_machine::Machine;
use ferrocut_memory::{Author, Settings, Store};
use std::collections::BTreeMap;
use std::path::Path;
use std::sync::Arc;

fn shop_on(folder: &Path, parameters: &[(&str, f64)]) -> Shop {
    let store = Arc::new(Store::open(folder, Settings::new("gsk990mc")).unwrap());
    let mut machine = Machine::demo_mill();
    for (name, value) in parameters {
        machine.parameters.insert((*name).to_owned(), *value);
    }
    Shop::of(&machine, Parts { store: Some(store), ..Parts::default() })
}

fn maintenance() -> Author {
    Author::Maintenance { name: "commissioning".into() }
}

#[test]
fn a_reference_point_is_set_used_and_kept() {
    let folder = tempfile::tempdir().unwrap();
    let set = Command::SetReferencePoint { number: 2, axes: [('X', 33.0), ('Z', -5.0)].into() };
    {
        let mut shop = shop_on(folder.path(), &[]);
        shop.mode(Mode::Mdi);
        shop.say(Command::ParameterSwitch { on: true });
        let denied = shop.control.command(set.clone(), &person()).unwrap_err().alarm.id;
        assert_eq!(denied, "FC-1213", "an operator may not");
        shop.control.command(set.clone(), &maintenance()).unwrap();
        shop.wait(1);
        assert!(shop.events.contains(&Event::Changed { item: "reference-points".into() }));
        shop.say(Command::ParameterSwitch { on: false });
        shop.say(Command::Mdi { text: "G91 G30 P2 X0".into() });
        shop.start();
        assert_eq!(shop.until_it_stops().position.machine[&'X'], 33.0);
        // Of the other two likewise; the ladder hears where an axis stands.
        assert!(shop.control.outputs().at_further_reference[0][0]);
        for number in [3, 4] {
            shop.say(Command::ParameterSwitch { on: true });
            let axes = [('X', f64::from(number) * 7.0)].into();
            shop.control.command(Command::SetReferencePoint { number, axes }, &maintenance()).unwrap();
            shop.say(Command::ParameterSwitch { on: false });
            shop.say(Command::Mdi { text: format!("G91 G30 P{number} X0") });
            shop.start();
            assert_eq!(shop.until_it_stops().position.machine[&'X'], f64::from(number) * 7.0);
            let stands = shop.control.outputs().at_further_reference.map(|axes| axes[0]);
            assert_eq!(stands, [2, 3, 4].map(|of| of == number));
        }
        for bad in [0, 5] {
            let command = Command::SetReferencePoint { number: bad, axes: [('X', 1.0)].into() };
            let refused = shop.control.command(command, &maintenance()).unwrap_err();
            assert_eq!(refused.alarm.id, "FC-1407");
        }
        let command = Command::SetReferencePoint { number: 2, axes: [('Q', 1.0)].into() };
        assert!(shop.control.command(command, &maintenance()).is_err());
    }
    let mut shop = shop_on(folder.path(), &[]);
    let Reply::ReferencePoints { points } = shop.say(Command::ReferencePoints) else { panic!() };
    assert_eq!((points[&2][&'X'], points[&2][&'Z'], points[&3][&'X']), (33.0, -5.0, 21.0));
}

#[test]
fn pitch_errors_hold_from_the_next_start_on() {
    let folder = tempfile::tempdir().unwrap();
    // 37#0: compensated; X: the reference point has number 0, a point every 10 mm.
    let parameters = [("NO37.0", 1.0), ("P216", 0.0), ("P226", 10.0)];
    let table: BTreeMap<u16, f64> = [(1, 0.02), (2, 0.03)].into();
    {
        let mut shop = shop_on(folder.path(), &parameters);
        shop.mode(Mode::Mdi);
        let command = Command::SetPitch { axis: 'X', points: table.clone() };
        assert!(shop.control.command(command.clone(), &person()).is_err());
        shop.control.command(command, &maintenance()).unwrap();
        let bad = Command::SetPitch { axis: 'X', points: [(10_000, 0.1)].into() };
        assert_eq!(shop.control.command(bad, &maintenance()).unwrap_err().alarm.id, "FC-1409");
        let Reply::Pitch { points, .. } = shop.say(Command::Pitch { axis: 'X' }) else { panic!() };
        assert_eq!(points, table);
    }
    let mut shop = shop_on(folder.path(), &parameters);
    let Reply::Pitch { points, .. } = shop.say(Command::Pitch { axis: 'X' }) else { panic!() };
    assert_eq!(points, table);
    let Reply::Pitch { points, .. } = shop.say(Command::Pitch { axis: 'Y' }) else { panic!() };
    assert!(points.is_empty());
    // The drives are told what the table says.
    let table =
        shop.control.machine().axis(ferrocut_geometry::Axis::X).unwrap().pitch_errors.clone().unwrap();
    assert_eq!(table.corrections, [0.0, 0.02, 0.03]);
}

#[test]
fn a_program_gets_another_name() {
    let folder = tempfile::tempdir().unwrap();
    let kept = shop_on(folder.path(), &[]);
    for mut shop in [kept, Shop::new(&[])] {
        shop.store("O0001", "O1 (PLATE)\nG1 X5 F1000\nM30\n");
        shop.store("O0002", "O2\nM30\n");
        shop.select("O1");
        let rename = |to: &str| Command::Rename { program: "O1".into(), to: to.into() };
        assert_eq!(shop.refused(rename("O0002")), "FC-1409", "it would cover another");
        assert_eq!(shop.refused(rename(" ")), "FC-1409");
        shop.start();
        assert_eq!(shop.refused(rename("O0003")), "FC-1408");
        shop.until_it_stops();
        shop.say(rename("O0003"));
        let status = shop.wait(1);
        assert_eq!(status.program.selected.as_deref(), Some("O0003"));
        let Reply::Program { text, .. } = shop.say(Command::Read { program: "O3".into() }) else { panic!() };
        assert_eq!(text, "O0003 (PLATE)\nG1 X5 F1000\nM30\n");
        assert_eq!(shop.refused(Command::Read { program: "O1".into() }), "FC-1407");
        shop.start();
        assert_eq!(shop.until_it_stops().counters.parts, 2);
    }
}

/// GSK990MC part 2, 3.3.5 and 20#7: where the axes stand is machine zero, for encoders that know it from then on.
#[test]
fn machine_zero_is_set_by_hand_where_a_parameter_allows_it() {
    let folder = tempfile::tempdir().unwrap();
    let set = |axes: &[char]| Command::SetMachineZero { axes: axes.to_vec() };
    for (allowed, refusal) in [(1.0, None), (0.0, Some("FC-1406"))] {
        let mut shop = shop_on(folder.path(), &[("NO20.7", allowed)]);
        shop.mode(Mode::Mdi);
        shop.say(Command::Mdi { text: "G53 G90 G0 X12 Y-7".into() });
        shop.start();
        shop.until_it_stops();
        let from = shop.wait(1).position.machine;
        shop.say(Command::ParameterSwitch { on: true });
        let denied = shop.control.command(set(&['X']), &person()).unwrap_err().alarm.id;
        assert_eq!(denied, "FC-1213");
        let said = shop.control.command(set(&['X', 'Y']), &maintenance());
        assert_eq!(said.err().map(|why| why.alarm.id), refusal.map(str::to_owned));
        let status = shop.wait(5);
        let at = |axis: char| status.position.machine[&axis];
        match refusal {
            None => {
                assert_eq!((at('X'), at('Y'), at('Z')), (0.0, 0.0, from[&'Z']));
                assert!(
                    ['X', 'Y'].iter().all(|axis| status.referenced.contains(axis)),
                    "{:?}",
                    status.referenced
                );
                shop.control.flush().unwrap();
                let Reply::OperationLog { entries } = shop.say(Command::OperationLog { most: 9 }) else {
                    panic!()
                };
                let of = |axis: char| entries.iter().find(|line| line.name == format!("machine zero {axis}"));
                for (axis, from) in [('X', from[&'X']), ('Y', from[&'Y'])] {
                    let line = of(axis).unwrap_or_else(|| panic!("{entries:?}"));
                    assert_eq!((line.item.as_str(), line.to.as_str()), ("position", "0"));
                    assert_eq!(line.from.parse::<f64>().unwrap(), from);
                    assert!(line.who.contains("commissioning"), "{}", line.who);
                }
                assert!(of('Z').is_none());
                let lit = shop.control.outputs().at_reference;
                assert!(lit[0] && lit[1], "{lit:?}");
                // The next move is one of the new coordinates.
                shop.say(Command::ParameterSwitch { on: false });
                shop.say(Command::Mdi { text: "G53 G90 G0 X3".into() });
                shop.start();
                assert_eq!(shop.until_it_stops().position.machine[&'X'], 3.0);
                assert_eq!(shop.refused(set(&['X'])), "FC-1213");
            }
            Some(_) => assert_eq!(at('X'), from[&'X']),
        }
    }
}
