//! Signals of the ladder over time, by a front.

use crate::common::shop::person;
use ferrocut_controller::api::{Command, Reply, TraceEdge, TraceTrigger};
use ferrocut_controller::{Control, Parts};
use ferrocut_machine::Machine;
use ferrocut_memory::Author;
use ferrocut_plc::{Address, Limits, Program};

/// R0.1 is on for the one scan in which R0.0 comes.
const PULSE: &str = "GO = R1.0 ; begins\nONCE = R0.1 ; a pulse\nEND1\nRD GO\nDIFU 1\nWRT ONCE\nEND2\nEND\n";

fn control() -> Control {
    let ladder = Program::from_text(PULSE.as_bytes(), &Limits::default()).unwrap();
    Control::new(&Machine::demo_mill(), Parts { ladder: Some(ladder), ..Parts::default() }).unwrap()
}

fn trace(signals: &[&str], samples: u32, behind: Option<u32>) -> Command {
    let signals = signals.iter().map(|name| (*name).to_owned()).collect();
    let trigger = Some(TraceTrigger { signal: "ONCE".into(), edge: TraceEdge::Falling });
    Command::Trace { signals, samples, trigger, behind, changes_only: false }
}

#[test]
fn a_pulse_of_a_single_scan_is_seen_and_told() {
    let mut control = control();
    control.command(trace(&["GO", "ONCE"], 50, Some(10)), &person()).unwrap();
    let go = control.plc_mut().unwrap().program().signal("GO").unwrap();
    for period in 0..200 {
        control.plc_mut().unwrap().memory_mut().set_bit(go, period >= 120);
        control.tick();
    }
    let read = |control: &mut Control, from, most| match control
        .command(Command::Traced { from, most }, &person())
    {
        Ok(Reply::Traced { done, triggered, signals, samples, rows }) => {
            (done, triggered, signals, samples, rows)
        }
        other => panic!("{other:?}"),
    };
    let (done, triggered, signals, samples, rows) = read(&mut control, 0, 1000);
    assert_eq!(
        (done, samples, rows.len(), signals),
        (true, 50, 50, vec!["R0001.0".to_owned(), "R0000.1".to_owned()])
    );
    // Ten samples behind the scan in which the pulse was over.
    assert_eq!(triggered, Some(rows[39].0));
    let bits: Vec<u32> = rows.iter().map(|row| row.1).collect();
    assert_eq!(bits[36..42], [0, 0, 0b11, 0b01, 0b01, 0b01]);
    assert!(rows.windows(2).all(|pair| (pair[1].0 - pair[0].0 - 0.001).abs() < 1e-9));
    assert_eq!(read(&mut control, 38, 1).4, [rows[38]]);
    control.command(Command::EndTrace, &person()).unwrap();
    assert!(control.command(Command::Traced { from: 0, most: 1 }, &person()).is_err());
}

/// A word at D100, and what the NC has.
const VALUES: &str =
    "POCKET = D100 ; a word\nLOW = D104 ; a byte\nEND1\nRD R9091.0\nNUMEB 2 1 POCKET\nEND2\n";

#[test]
fn values_are_read_in_their_width_and_names_of_the_nc_are_known() {
    let ladder = Program::from_text(VALUES.as_bytes(), &Limits::default()).unwrap();
    let mut control =
        Control::new(&Machine::demo_mill(), Parts { ladder: Some(ladder), ..Parts::default() }).unwrap();
    let put = |control: &mut Control, first: &str, bytes: &[u8]| {
        let first = Address::parse(first).unwrap();
        for (n, byte) in (0..).zip(bytes) {
            let address = Address { byte: first.byte + n, ..first };
            control.plc_mut().unwrap().memory_mut().set_byte(address, *byte);
        }
    };
    put(&mut control, "D100", &[0x2C, 1, 0, 0, 7, 1]);
    put(&mut control, "G10", &[0xFE, 0xFF]);
    let names = ["POCKET", "D100", "LOW", "*JV", "S_CODE", "UO", "AR", "INP_X", "ZRF_X", "MVD_X"];
    let quantities = ["POCKET", "*JV", "INP_X"].map(str::to_owned).to_vec();
    let capture = Command::Capture { quantities, seconds: 0.001, every: 1, trigger: None, before: 0.0 };
    control.command(capture, &person()).unwrap();
    control.tick();
    put(&mut control, "F22", &[0x20, 3, 0, 0]);
    put(&mut control, "F40", &[0x10, 0x27]);
    put(&mut control, "F54", &[0, 0x80]);
    let names = Command::Signals { names: names.map(str::to_owned).to_vec() };
    let Ok(Reply::Signals { signals }) = control.command(names, &person()) else { panic!() };
    let value = |name: &str| signals[name];
    assert_eq!(["POCKET", "D100", "LOW"].map(value), [300, 0x2C, 7]);
    assert_eq!(["*JV", "S_CODE", "AR", "UO"].map(value), [0xFFFE, 800, 10_000, 0x8000]);
    assert!(["INP_X", "ZRF_X", "MVD_X"].map(value).iter().all(|bit| matches!(bit, 0 | 1)));
    let Ok(Reply::Captured { csv, .. }) = control.command(Command::Captured { from: 0, most: 9 }, &person())
    else {
        panic!()
    };
    let row: Vec<&str> = csv.lines().nth(1).unwrap().split(',').collect();
    assert_eq!(row[1..3], ["300", "65534"], "{csv}");
    // As bits they are traced, and forced.
    let trace = |name: &str| Command::Trace {
        signals: vec![name.to_owned()],
        samples: 5,
        trigger: None,
        behind: None,
        changes_only: false,
    };
    control.command(trace("ZRF_X"), &person()).unwrap();
    assert_eq!(control.command(trace("AR"), &person()).unwrap_err().alarm.id, "FC-1422");
    let force = |value| Command::Force { signal: "INP_X".to_owned(), value };
    control.command(force(Some(true)), &Author::Control).unwrap();
    let Ok(Reply::Forced { signals }) = control.command(Command::Forced, &person()) else { panic!() };
    assert_eq!((signals.len(), signals[0].name.as_str()), (1, "INP_X"));
    control.command(force(None), &Author::Control).unwrap();
}

#[test]
fn what_cannot_be_traced_is_refused() {
    let mut control = control();
    let many = vec!["GO"; 33];
    for (bad, id) in [
        (trace(&["HAT"], 50, None), "FC-1407"),
        (trace(&["R1"], 50, None), "FC-1422"),
        (trace(&[], 50, None), "FC-1422"),
        (trace(&many, 50, None), "FC-1422"),
        (trace(&["GO"], 0, None), "FC-1422"),
        (trace(&["GO"], 100_001, None), "FC-1422"),
        (trace(&["GO"], 50, Some(50)), "FC-1422"),
    ] {
        assert_eq!(control.command(bad, &person()).unwrap_err().alarm.id, id);
    }
    let mut bare = Control::new(&Machine::demo_mill(), Parts::default()).unwrap();
    assert_eq!(bare.command(trace(&["GO"], 50, None), &person()).unwrap_err().alarm.id, "FC-1406");
}

#[test]
fn the_flow_of_the_ladder_is_recorded_while_it_is_asked_for() {
    let mut control = control();
    let go = control.plc_mut().unwrap().program().signal("GO").unwrap();
    let flow = |control: &mut Control, periods: u32, is_on: bool| {
        for _ in 0..periods {
            control.plc_mut().unwrap().memory_mut().set_bit(go, is_on);
            control.tick();
        }
        match control.command(Command::LadderFlow, &person()) {
            Ok(Reply::LadderFlow { power }) => power.contains(&true),
            other => panic!("{other:?}"),
        }
    };
    assert!(!flow(&mut control, 10, true), "nobody has asked yet");
    assert!(flow(&mut control, 10, true));
    assert!(!flow(&mut control, 10, false));
    // A second after the last question nothing is recorded any more.
    assert!(!flow(&mut control, 1500, true));
    assert!(flow(&mut control, 500, true));
}
