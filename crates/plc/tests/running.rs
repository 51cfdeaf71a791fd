//! The running ladder: levels, time, forcing, flow, trace, exchange.
#![allow(missing_docs, clippy::unwrap_used)]

mod common;

use assert_no_alloc::{AllocDisabler, assert_no_alloc};
use common::{at, bytes, get, plc, put, run, second, set};
use ferrocut_plc::{Limits, Maintenance, Pace, Plc, Program, Stop, TraceSettings, Trigger};

#[global_allocator]
static ALLOCATOR: AllocDisabler = AllocDisabler;

fn program(text: &str) -> Program {
    Program::from_text(text.as_bytes(), &Limits::default()).unwrap()
}

/// So many networks of two steps.
fn idle(networks: u32) -> String {
    (0..networks).map(|n| format!("RD X1.0\nWRT R{}.{}\n", 100 + n / 8, n % 8)).collect()
}

#[test]
fn level_2_is_divided_and_sees_its_inputs_unchanged() {
    // 50 steps a period: level 1 takes 4, level 2 of 200 networks more than 8 periods.
    let text = format!(
        "RD X0.0\nWRT Y0.0\nRD F0.0\nWRT Y0.1\nEND1\nRD X0.0\nWRT Y1.0\nRD F0.0\nWRT Y1.1\n{}RD X0.0\nWRT Y1.2\nRD F0.0\nWRT Y1.3\nEND2\n",
        idle(200)
    );
    let mut plc = Plc::new(program(&text), Pace { steps: 100, ..Pace::default() });
    // It is left only between networks, and begins again in the period after its end.
    let mut rounds = Vec::new();
    for period in 0..40 {
        if plc.scan().is_round {
            rounds.push(period);
        }
    }
    let round = rounds[1] - rounds[0];
    assert!((4..=8).contains(&round), "{rounds:?}");
    assert!(rounds.windows(2).all(|pair| pair[1] - pair[0] == round), "{rounds:?}");
    while !plc.scan().is_round {}
    plc.scan();
    // The inputs come on behind the first period of level 2.
    put(&mut plc, "X0", &[1]);
    put(&mut plc, "F0", &[1]);
    for _ in 1..round {
        plc.scan();
        assert_eq!((bytes(&plc, "Y0", 1), bytes(&plc, "Y1", 1)), (vec![0b11], vec![0]));
    }
    for _ in 0..round {
        plc.scan();
    }
    assert_eq!(bytes(&plc, "Y1", 1), [0b1111]);
}

#[test]
fn a_ladder_tells_which_bytes_it_writes() {
    let table = [
        ("RD G196.0\nWRT R0.0\nEND1\nEND2\n", false),
        ("RD R0.0\nWRT G196.3\nEND1\nEND2\n", true),
        ("RD R0.0\nWRT G195.3\nEND1\nRD R0.0\nSET G196.7\nEND2\n", true),
        ("RD R0.0\nMOVB X9 G196\nEND1\nEND2\n", true),
        ("RD R0.0\nMOVD D0 G193\nEND1\nEND2\n", true),
        ("RD R0.0\nMOVW D0 G193\nEND1\nEND2\n", false),
        ("RD R0.0\nMOVB G196 D0\nEND1\nEND2\n", false),
        ("RD R0.0\nRD.STK R0.1\nADDB 1004 D0 D4 G195\nEND1\nEND2\n", true),
    ];
    for (text, wanted) in table {
        assert_eq!(program(text).writes(at("G196.0")), wanted, "{text}");
    }
}

#[test]
fn both_levels_have_flags_of_their_own() {
    // Level 1 compares equal in each period, level 2 never; level 2 is left between COMPB and its flag.
    let text = format!(
        "RD R9091.1\nCOMPB 1 0 D0\nRD R9000.0\nWRT Y0.0\nEND1\nRD R9091.1\nCOMPB 1 1 D0\n{}RD R9000.0\nWRT Y0.1\nEND2\n",
        idle(300)
    );
    let mut plc = Plc::new(program(&text), Pace { steps: 100, ..Pace::default() });
    for _ in 0..50 {
        plc.scan();
        assert_eq!(bytes(&plc, "Y0", 1), [0b01]);
    }
}

#[test]
fn loops_end_in_an_alarm_with_all_outputs_off() {
    let forever = "RD X0.0\nWRT Y0.1\nEND1\nRD.NOT X0.7\nWRT Y0.0\nRD.NOT X0.7\nWRT G8.4\nLBL 1\nRD X0.0\nJMPB 1\nEND2\n";
    let mut plc = plc(forever);
    run(&mut plc, 100);
    assert_eq!((bytes(&plc, "Y0", 1), get(&plc, "G8.4")), (vec![1], true));
    set(&mut plc, "X0.0", true);
    let mut most = 0;
    let stopped = (0..1000).position(|_| {
        let scanned = plc.scan();
        most = most.max(scanned.steps);
        scanned.stop == Some(Stop::SecondLevel)
    });
    // 1,000,000 steps at 5,000 a period.
    assert_eq!(stopped, Some(200));
    assert!(most <= 5_010, "{most}");
    assert_eq!(
        (bytes(&plc, "Y0", 1), get(&plc, "G8.4"), plc.stopped()),
        (vec![0], false, Some(Stop::SecondLevel))
    );
    set(&mut plc, "X0.0", false);
    assert_eq!(plc.scan().stop, Some(Stop::SecondLevel));
    plc.restart();
    run(&mut plc, 1);
    assert_eq!(bytes(&plc, "Y0", 1), [1]);
    // Level 1 must end within its period.
    let mut plc = common::plc("LBL 1\nRD X0.0\nJMPB 1\nEND1\nEND2\n");
    run(&mut plc, 2);
    set(&mut plc, "X0.0", true);
    assert_eq!(plc.scan().stop, Some(Stop::FirstLevel));
    // Calls within calls: a hundred, each of a hundred, of a hundred …
    let calls = |to: u32| format!("CALLU {to}\n").repeat(100);
    let subprograms: String = (1..8).map(|n| format!("SP {n}\n{}SPE\n", calls(n + 1))).collect();
    let text = format!("END1\nCALLU 1\nEND2\n{subprograms}SP 8\n{}SPE\nEND\n", idle(1));
    let mut plc = common::plc(&text);
    let stopped = (0..1000).position(|_| plc.scan().stop == Some(Stop::SecondLevel));
    assert_eq!(stopped, Some(200));
}

#[test]
fn system_signals_tell_the_time() {
    let mut plc = second(
        "RD R9091.0\nWRT Y0.0\nRD R9091.1\nWRT Y0.1\nRD R9091.5\nWRT Y0.2\nRD R9091.6\nWRT Y0.3\nRD R9015.0\nWRT Y0.4\n",
    );
    for ms in 0..2_500u32 {
        plc.scan();
        let (fast, slow) = (ms % 200 < 104, ms % 1000 < 504);
        let wanted = 0b10 | u8::from(fast) << 2 | u8::from(slow) << 3 | u8::from(ms == 0) << 4;
        assert_eq!(bytes(&plc, "Y0", 1), [wanted], "{ms}");
    }
    assert_eq!(plc.now_us(), 2_499_000);
}

#[test]
fn a_scan_allocates_nothing() {
    let text = "END1\nRD X0.0\nTMRB 1 10\nWRT Y0.0\nRD X0.0\nRD.STK X0.0\nRD.STK X0.0\nDSCH 9 D10 D0 R10\nWRT Y0.1\n\
        RD X0.0\nCALL 1\nEND2\nSP 1\nRD X0.0\nDIFU 1\nWRT Y0.2\nSPE\nEND\n";
    let mut plc = plc(text);
    plc.set_trace(Some(&TraceSettings {
        signals: vec![at("Y0.0"), at("X0.0")],
        samples: 10,
        trigger: Some(Trigger::Rising(at("Y0.0"))),
        behind: 5,
        changes_only: false,
    }));
    plc.watch(true);
    let newer = Box::new(program("END1\nRD X0.0\nWRT Y0.0\nEND2\n"));
    assert_no_alloc(|| {
        for n in 0..100 {
            plc.memory_mut().set_bit(at("X0.0"), n % 30 > 5);
            plc.scan();
        }
        let old = plc.exchange(newer);
        assert!(old.is_none());
        plc.scan();
        plc.roll_back();
        plc.scan();
    });
}

#[test]
fn forced_signals_are_changed_by_nothing() {
    let mut plc =
        plc("RD X0.0\nWRT Y0.0\nRD.NOT X0.0\nWRT Y0.1\nEND1\nRD X0.0\nWRT Y0.2\nRD X0.1\nMOVB D0 Y1\nEND2\n");
    let right = Maintenance::granted();
    plc.force(&right, at("X0.0"), true);
    plc.force(&right, at("Y0.1"), true);
    plc.force(&right, at("Y1.7"), true);
    put(&mut plc, "D0", &[0x01]);
    for x in [0, 1, 2, 3] {
        put(&mut plc, "X0", &[x]);
        plc.scan();
        assert_eq!(bytes(&plc, "Y0", 1), [0b111]);
    }
    assert_eq!(bytes(&plc, "Y1", 1), [0x81]);
    assert!(plc.memory().is_forced(at("Y0.1")));
    plc.release(&right, at("X0.0"));
    plc.release(&right, at("Y0.1"));
    put(&mut plc, "X0", &[1]);
    plc.scan();
    assert_eq!(bytes(&plc, "Y0", 1), [0b101]);
}

#[test]
fn flow_is_recorded_for_a_time_after_it_was_asked_for() {
    let mut plc = plc("RD X0.0\nWRT Y0.0\nEND1\nEND2\n");
    let powered = |plc: &Plc| plc.flow().any(|flow| flow.is_powered);
    put(&mut plc, "X0", &[1]);
    plc.scan();
    assert!(!powered(&plc));
    let period_us = Pace::default().period_us;
    plc.watch_for(3 * period_us);
    plc.scan();
    assert!(powered(&plc));
    // Asked for again, it is not begun anew.
    plc.watch_for(3 * period_us);
    assert!(powered(&plc));
    for _ in 0..3 {
        plc.scan();
    }
    put(&mut plc, "X0", &[0]);
    plc.scan();
    assert!(powered(&plc), "what was recorded last stays");
    plc.watch_for(period_us);
    assert!(!powered(&plc));
}

#[test]
fn flow_is_seen_at_every_instruction() {
    let mut plc =
        second("RD X0.0\nAND.NOT X0.1\nOR X0.2\nWRT Y0.0\nRD X0.3\nJMP\nRD X0.0\nDIFU 1\nWRT Y0.1\nJMPE\n");
    plc.watch(true);
    put(&mut plc, "X0", &[0b1001]);
    plc.scan();
    plc.scan();
    let flow: Vec<String> = plc
        .flow()
        .map(|f| format!("{}{}{}", u8::from(f.is_reached), u8::from(f.is_on), u8::from(f.is_powered)))
        .collect();
    // END1; the contact conducts and the line is on: 111; the open OR lets the line be: 101; the coil was on.
    let wanted = ["000", "111", "111", "101", "111", "111", "111", "000", "000", "000", "000", "000"];
    assert_eq!(flow, wanted);
    put(&mut plc, "X0", &[0b0010]);
    plc.scan();
    let flow: Vec<bool> = plc.flow().map(|f| f.is_powered).collect();
    assert_eq!(flow, [false; 12]);
    assert!(plc.flow().nth(7).unwrap().is_reached);
}

#[test]
fn traces_keep_what_was_before_and_behind_the_trigger() {
    let mut plc = second("RD X0.0\nDIFU 1\nWRT Y0.0\n");
    let mut settings = TraceSettings {
        signals: vec![at("X0.0"), at("Y0.0")],
        samples: 6,
        trigger: Some(Trigger::Rising(at("X0.0"))),
        behind: 3,
        changes_only: false,
    };
    plc.set_trace(Some(&settings));
    for n in 0..40 {
        set(&mut plc, "X0.0", n >= 20 && n != 22);
        plc.scan();
    }
    let trace = plc.trace().unwrap();
    assert!(trace.is_done() && trace.triggered_us() == Some(20_000));
    let samples: Vec<(u64, u32)> = trace.samples().map(|s| (s.time_us / 1000, s.bits)).collect();
    assert_eq!(samples, [(18, 0), (19, 0), (20, 0b11), (21, 0b01), (22, 0), (23, 0b11)]);
    // Only what changes.
    settings.changes_only = true;
    settings.behind = 2;
    settings.trigger = Some(Trigger::Falling(at("X0.0")));
    plc.set_trace(Some(&settings));
    for n in 0..40 {
        set(&mut plc, "X0.0", !(10..=15).contains(&n));
        plc.scan();
    }
    let trace = plc.trace().unwrap();
    let samples: Vec<(u64, u32)> = trace.samples().map(|s| (s.time_us / 1000 - 40, s.bits)).collect();
    assert_eq!(samples, [(0, 0b01), (10, 0), (16, 0b11), (17, 0b01)]);
    assert!(trace.is_done());
    // Without a trigger the last samples are there.
    settings = TraceSettings { trigger: None, changes_only: false, ..settings };
    plc.set_trace(Some(&settings));
    run(&mut plc, 100);
    assert_eq!(plc.trace().unwrap().samples().count(), 6);
    assert!(!plc.trace().unwrap().is_done());
}

#[test]
fn a_ladder_is_exchanged_while_it_runs_and_rolled_back() {
    let text = |coil: &str| {
        format!(
            "END1\nRD X0.0\nTMRB 1 100\nWRT Y0.0\nRD X0.1\nSET R5.0\nRD X0.0\nDIFU 1\nWRT R5.1\nRD R5.1\n\
            RD.STK R5.1\nRD.STK R5.1\nRD.STK X0.0\nCTR 1\nRD R5.0\nWRT {coil}\nEND2\n"
        )
    };
    let mut plc = plc(&text("Y0.6"));
    put(&mut plc, "C0", &[5, 0]);
    put(&mut plc, "X0", &[0b11]);
    run(&mut plc, 60);
    put(&mut plc, "X0", &[0b01]);
    assert!(plc.exchange(Box::new(program(&text("Y0.7")))).is_none());
    // Timer and latch go on, and no edge comes again.
    run(&mut plc, 40);
    assert_eq!(bytes(&plc, "Y0", 1), [0b1100_0000]);
    run(&mut plc, 1);
    assert_eq!((bytes(&plc, "Y0", 1), get(&plc, "R5.1")), (vec![0b1100_0001], false));
    set(&mut plc, "Y0.6", false);
    assert!(plc.roll_back());
    set(&mut plc, "Y0.7", false);
    run(&mut plc, 1);
    assert_eq!(bytes(&plc, "Y0", 1), [0b0100_0001]);
    // Back and forth.
    assert!(plc.roll_back());
    run(&mut plc, 1);
    assert_eq!(bytes(&plc, "Y0", 1), [0b1100_0001]);
    assert!(!second("RD X0.0\nWRT Y0.0\n").roll_back());
}

#[test]
fn a_new_ladder_that_does_not_end_is_taken_out_again() {
    let mut plc = second("RD.NOT X0.0\nWRT Y0.0\n");
    run(&mut plc, 10);
    plc.exchange(Box::new(program("END1\nLBL 1\nRD.NOT X0.0\nWRT Y0.1\nRD.NOT X0.0\nJMPB 1\nEND2\n")));
    let mut rolled_back = 0;
    for _ in 0..1000 {
        let scanned = plc.scan();
        assert_eq!(scanned.stop, None);
        rolled_back += u32::from(scanned.rolled_back);
    }
    assert_eq!((rolled_back, get(&plc, "Y0.0"), plc.stopped()), (1, true, None));
    // Whoever brings the faulty one in again sees it taken out again.
    assert!(plc.roll_back() && plc.is_on_trial());
    let again = (0..1000).filter(|_| plc.scan().rolled_back).count();
    assert_eq!((again, get(&plc, "Y0.0"), plc.stopped()), (1, true, None));
    assert_eq!(plc.program().instructions().len(), 4);
}
