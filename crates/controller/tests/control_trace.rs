//! Signals of the ladder over time, by a front.
#![allow(missing_docs, clippy::unwrap_used, clippy::panic, clippy::indexing_slicing)]

mod common;

use common::shop::person;
use ferrocut_controller::api::{Command, Reply, TraceEdge, TraceTrigger};
use ferrocut_controller::{Control, Parts};
use ferrocut_machine::Machine;
use ferrocut_plc::{Limits, Program};

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
