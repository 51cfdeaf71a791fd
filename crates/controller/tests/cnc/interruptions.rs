//! Feed hold, reset and overrides at any moment.

use crate::common::{ACTIVITIES, Hand, Run, cnc, cnc_with, machine, run, run_with};
use ferrocut_controller::{Activity, State};
use ferrocut_geometry::{Axis, Position};
use ferrocut_machine::Machine;
use proptest::prelude::*;
use std::sync::OnceLock;

/// Straight, round and helical cuts with corners and tangent joints, short moves, positioning, dwell,
/// spindle and tool change.
const PROGRAM: &str = "G0 X20 Y10 Z5\nS800 M3\nG1 Z-1 F1500\nX60 F5000\nG3 X70 Y20 R10\nG1 Y40\nX60 Y41\n\
                       X59.8 Y41.1\nX59.6 Y41.3\nX59.4 Y41.6\nX30 Y30\nG2 I-10 Z-3\nG4 X0.15\nX25 Y10 R60\nG0 Z10\n\
                       T2 M6\nG0 X0 Y0 A45\nS900 M4\nG1 X10 Y5 F2000\nG0 X-20\nM30\n";

/// 12#1: G00 along a straight line. Where each axis positions on its own, the way is one of many.
const STRAIGHT: &str = "[parameters]\n\"NO12.1\" = 1";

/// How far the chord of a period leaves the way, with some room: at full acceleration a·t²/8 is 0.25 µm.
const CHORD: f64 = 0.001;

/// How far a rounded corner is beside its vertex: the tolerance of the machine.
const ROUNDING: f64 = 0.01;

fn shop() -> Machine {
    let mut machine = machine();
    // Short pauses, so that most ticks are motion.
    machine.tool_change.time_s = 0.2;
    machine.spindle.acceleration_rpm_s = 20_000.0;
    machine
}

/// The program run through without a hand on it.
fn reference() -> &'static (Run, [f64; 5], u64) {
    static REFERENCE: OnceLock<(Run, [f64; 5], u64)> = OnceLock::new();
    REFERENCE.get_or_init(|| {
        let mut cnc = cnc_with(&shop(), PROGRAM, STRAIGHT);
        let run = run(&mut cnc);
        assert_eq!(cnc.state(), &State::Ended);
        run.check_limits(&shop(), false);
        let times = ACTIVITIES.map(|a| cnc.report().time(a));
        (run, times, cnc.report().moves)
    })
}

fn cases(cases: u32) -> ProptestConfig {
    ProptestConfig { cases, failure_persistence: None, ..ProptestConfig::default() }
}

fn ticks() -> usize {
    reference().0.ticks.len()
}

proptest! {
    #![proptest_config(cases(150))]

    #[test]
    fn hold_and_cycle_start_change_the_time_and_nothing_else(
        holds in prop::collection::vec((any::<prop::sample::Index>(), 1usize..600), 1..6),
    ) {
        let machine = shop();
        let (through, times, moves) = reference();
        let mut at = 0;
        let mut holds: Vec<(usize, usize)> = holds.iter().map(|(i, n)| (i.index(ticks()), *n)).collect();
        holds.sort_unstable();
        let mut hands = Vec::new();
        for (tick, length) in holds {
            let tick = tick.max(at);
            hands.extend([(tick, Hand::Hold), (tick + length, Hand::CycleStart)]);
            at = tick + length + 1;
        }
        let mut cnc = cnc_with(&machine, PROGRAM, STRAIGHT);
        let run = run_with(&mut cnc, &hands);
        prop_assert_eq!(cnc.state(), &State::Ended);
        prop_assert_eq!(run.end(), through.end());
        run.check_limits(&machine, false);
        run.follows(through, CHORD);
        prop_assert_eq!(cnc.report().moves, *moves);
        prop_assert_eq!(cnc.report().parts, 1);
        prop_assert_eq!(&run.events, &through.events);
        for (activity, time) in ACTIVITIES.into_iter().zip(times) {
            let found = cnc.report().time(activity);
            match activity {
                // What stands still is not made longer or shorter by a hold.
                Activity::Dwell | Activity::Spindle | Activity::ToolChange => {
                    prop_assert!((found - time).abs() < 1e-9, "{activity:?} {found} {time}");
                }
                // What is planned anew from rest may be planned a little better.
                _ => prop_assert!(found >= 0.95 * time, "{activity:?} {found} {time}"),
            }
        }
    }

    #[test]
    fn reset_comes_to_rest_on_the_way_and_forgets_the_rest(
        at in any::<prop::sample::Index>(),
        held in any::<bool>(),
    ) {
        let machine = shop();
        let (through, ..) = reference();
        let at = at.index(ticks());
        let mut cnc = cnc_with(&machine, PROGRAM, STRAIGHT);
        let mut hands = vec![(at, Hand::Reset)];
        if held {
            hands.insert(0, (at.saturating_sub(3), Hand::Hold));
        }
        let run = run_with(&mut cnc, &hands);
        prop_assert_eq!(cnc.state(), if at + 1 < ticks() { &State::Reset } else { cnc.state() });
        run.check_limits(&machine, false);
        run.follows(through, CHORD);
        // From the highest speed of an axis to rest takes velocity / acceleration; a curve leaves a
        // part of the acceleration for braking.
        prop_assert!(run.ticks.len() - at.min(run.ticks.len()) < 600, "{} ticks", run.ticks.len() - at);
        let rest = run.end();
        let reported = cnc.report().clone();
        for press in [true, false] {
            if press {
                cnc.cycle_start();
            } else {
                cnc.feed_hold();
            }
            for _ in 0..20 {
                let tick = cnc.tick();
                prop_assert_eq!((tick.position, tick.velocity, tick.moving), (rest, 0.0, false));
            }
        }
        prop_assert_eq!(cnc.report(), &reported);
        if cnc.state() == &State::Reset {
            prop_assert_eq!(cnc.report().parts, 0);
        }
    }

    #[test]
    fn overrides_at_any_moment_keep_limits_way_and_end(
        turns in prop::collection::vec((any::<prop::sample::Index>(), 0.0..2.2f64, 0.0..1.2f64), 1..8),
    ) {
        let machine = shop();
        let (through, ..) = reference();
        let mut hands: Vec<(usize, Hand)> =
            turns.iter().map(|(i, f, r)| (i.index(ticks()), Hand::Override(*f, *r))).collect();
        // Not for ever at nought.
        hands.push((ticks(), Hand::Override(1.0, 1.0)));
        let mut cnc = cnc_with(&machine, PROGRAM, STRAIGHT);
        let run = run_with(&mut cnc, &hands);
        prop_assert_eq!(cnc.state(), &State::Ended);
        prop_assert_eq!(run.end(), through.end());
        run.check_limits(&machine, false);
        // A corner that would take more than ten times as long is not rounded but a stop in its vertex.
        let slow = turns.iter().any(|(_, feed, rapid)| feed.min(*rapid) < 0.1);
        run.follows(through, CHORD + if slow { ROUNDING } else { 0.0 });
    }

    #[test]
    fn axes_that_position_on_their_own_keep_limits_and_end(
        hands in prop::collection::vec((any::<prop::sample::Index>(), 0..4u8, 0.0..2.0f64, 0.0..1.0f64), 1..8),
    ) {
        let machine = shop();
        let mut hands: Vec<(usize, Hand)> = hands
            .iter()
            .map(|(i, kind, feed, rapid)| {
                let hand = match kind {
                    0 => Hand::Hold,
                    1 => Hand::CycleStart,
                    _ => Hand::Override(*feed, *rapid),
                };
                (i.index(ticks()), hand)
            })
            .collect();
        hands.extend([(ticks(), Hand::Override(1.0, 1.0)), (ticks() + 1, Hand::CycleStart)]);
        let mut cnc = cnc(&machine, PROGRAM);
        let run = run_with(&mut cnc, &hands);
        prop_assert_eq!(cnc.state(), &State::Ended);
        prop_assert_eq!(run.end(), reference().0.end());
        run.check_limits(&machine, false);
    }
}

#[test]
fn hold_stands_still_for_as_long_as_it_lasts() {
    let machine = machine();
    let mut cnc = cnc(&machine, "M3 S1000\nG1 X300 F6000\nM30\n");
    let run = run_with(&mut cnc, &[(800, Hand::Hold), (5000, Hand::CycleStart)]);
    // 100 mm/s at 2000 mm/s² and 50000 mm/s³: at rest after 90 ms.
    let held = &run.ticks[900..5000];
    assert!(held[0].position[Axis::X] > 0.0);
    assert!(held.iter().all(|t| t.position == held[0].position && t.velocity == 0.0));
    assert_eq!(run.end()[Axis::X], 300.0);
}

#[test]
fn hold_stops_a_dwell_and_not_a_spindle() {
    let machine = machine();
    let mut control = cnc(&machine, "G4 X1\nM30\n");
    let run = run_with(&mut control, &[(300, Hand::Hold), (2300, Hand::CycleStart)]);
    assert_eq!(run.ticks.len(), 1000 + 2000 + 1);
    assert_eq!(control.report().time(Activity::Dwell), 1.0);
    let mut control = cnc(&machine, "M3 S4000\nM30\n");
    // It runs up within the hold: 1 s up, 1 s down at the end of the program.
    let run = run_with(&mut control, &[(300, Hand::Hold), (2300, Hand::CycleStart)]);
    assert_eq!(run.ticks.len(), 2300 + 1000 + 1);
    assert_eq!(control.report().time(Activity::Spindle), 2.0);
}

#[test]
fn reset_from_every_state() {
    let machine = machine();
    let reset = |control: &mut ferrocut_controller::Cnc, expected: &State| {
        control.reset();
        for _ in 0..3 {
            control.tick();
        }
        assert_eq!(control.state(), expected);
    };
    reset(&mut cnc(&machine, "G0 X1\nM30\n"), &State::Reset);
    let mut stopped = cnc(&machine, "G0 X1\nM0\nX2\nM30\n");
    run(&mut stopped);
    reset(&mut stopped, &State::Reset);
    assert_eq!(stopped.tick().position, Position::xyz(1.0, 0.0, 0.0));
    let mut alarmed = cnc(&machine, "G0 X1\nG77\nM30\n");
    run(&mut alarmed);
    reset(&mut alarmed, &State::Reset);
    let mut done = cnc(&machine, "G0 X1\nM30\n");
    run(&mut done);
    reset(&mut done, &State::Ended);
}
