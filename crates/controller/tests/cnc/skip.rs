//! Skip moves with a probe: where they end, what the program is told, what becomes of the rest.

use crate::common::{cnc, in_language, interpreter, machine};
use ferrocut_controller::drives::{Block, Plant};
use ferrocut_controller::{Cnc, DryRun, State, Tick};
use ferrocut_geometry::{Axis, Position};
use ferrocut_interpreter::Interpreter;
use ferrocut_machine::{Fault, Machine, PlantAxis, PlantConfig};
use proptest::prelude::*;

/// The demo mill, its axes known, among blocks of metal.
fn probing(machine: &Machine, interpreter: Interpreter, blocks: &[Block]) -> Cnc {
    let mut absolute = machine.clone();
    absolute.homing.absolute = true;
    let mut plant = Plant::new(&absolute, interpreter.position(), Position::ZERO);
    blocks.iter().for_each(|block| plant.place(*block));
    let mut cnc = Cnc::with_drives(machine, interpreter, Box::new(plant));
    cnc.set_referenced(machine.axis_set());
    cnc
}

fn run(cnc: &mut Cnc) -> Vec<Tick> {
    let mut ticks = vec![cnc.tick()];
    cnc.cycle_start();
    for _ in 0..200_000 {
        ticks.push(cnc.tick());
        if !matches!(cnc.state(), State::Running | State::Resetting) {
            return ticks;
        }
    }
    panic!("{:?}", cnc.state());
}

/// A wall from X upwards.
fn wall(x: f64) -> Block {
    Block { min: [x, -1e3, -1e3], max: [1e3, 1e3, 1e3] }
}

#[test]
fn the_move_ends_where_the_probe_touches() {
    let program = "G54 G90 G0 X0\nG31 X100 F600\n#100 = #5016\nG91 G1 Y10 F3000\nX1\nM30\n";
    let mut cnc = probing(&machine(), interpreter(program, ""), &[wall(40.0)]);
    let ticks = run(&mut cnc);
    assert_eq!(cnc.state(), &State::Ended);
    let end = ticks.last().unwrap().position;
    // 10 mm/s: lag of 0.2 · 0.02 mm, 8 ms until a stop begins, braking 2·√(10/50000)·10/2 = 0.14 mm, then 1 mm on.
    assert!(end[Axis::X] > 41.18 && end[Axis::X] < 41.28 && end[Axis::Y] == 10.0, "{end:?}");
    // The next block begins there, and no move turned back.
    assert!(ticks.windows(2).all(|w| w[1].position[Axis::X] >= w[0].position[Axis::X]));
    let touched = cnc.interpreter().memory().variables.get(100).unwrap();
    assert!((touched - 40.0).abs() < 1e-4, "{touched}");
    // Where there is nothing to touch it runs to its end, and tells the end.
    let mut cnc = probing(&machine(), interpreter(program, ""), &[wall(140.0)]);
    let end = run(&mut cnc).last().unwrap().position;
    assert_eq!((end[Axis::X], cnc.state()), (101.0, &State::Ended));
    assert_eq!(cnc.interpreter().memory().variables.get(100), Some(100.0));
}

#[test]
fn a_probe_that_touches_already_ends_the_move_where_it_begins() {
    let program = "G90 G31 X100 F600\nG91 G1 Z3 F600\nM30\n";
    let mut cnc = probing(&machine(), interpreter(program, ""), &[wall(-5.0)]);
    let end = run(&mut cnc).last().unwrap().position;
    assert!(end[Axis::X] < 1e-3 && end[Axis::Z] == 3.0, "{end:?}");
    // Touches of other moves are nothing.
    let mut cnc = probing(&machine(), interpreter("G1 X100 F6000\nG0 X0\nM30\n", ""), &[wall(40.0)]);
    run(&mut cnc);
    assert_eq!(cnc.state(), &State::Ended);
}

#[test]
fn without_a_probe_nothing_changes() {
    let program = "G90 G31 X50 F600\nG1 Y5 F600\nM30\n";
    let mut desk = cnc(&machine(), program);
    assert_eq!(run(&mut desk).last().unwrap().position, Position::xyz(50.0, 5.0, 0.0));
}

#[test]
fn a_signal_that_does_not_come_is_an_alarm_where_the_control_wants_one() {
    // Kaitong 21#3; LinuxCNC G38.2, and not G38.3.
    let missing = |cnc: &Cnc| match cnc.state() {
        State::Alarmed(alarm) => Some((alarm.fault, alarm.span.line)),
        _ => None,
    };
    let expected = Some((Fault::SkipWithoutSignal, 1));
    let program = "G38.2 X50 F600\nG1 Y5 F600\nM2\n";
    let mut touches = probing(&machine(), in_language("rs274", program), &[wall(20.0)]);
    run(&mut touches);
    assert_eq!(missing(&touches), None);
    let mut misses = probing(&machine(), in_language("rs274", program), &[]);
    let end = run(&mut misses).last().unwrap().position;
    assert_eq!((missing(&misses), end), (expected, Position::xyz(50.0, 0.0, 0.0)));
    let mut quiet = probing(&machine(), in_language("rs274", "G38.3 X50 F600\nG1 Y5 F600\nM2\n"), &[]);
    run(&mut quiet);
    assert_eq!(missing(&quiet), None);
    let found = "G38.3 X50 F600\n#1 = #5061\n#2 = #5070\nG1 X#1 Y#2 F600\nM2\n";
    let mut cnc = probing(&machine(), in_language("rs274", found), &[wall(20.0)]);
    let end = run(&mut cnc).last().unwrap().position;
    assert!((end[Axis::X] - 20.0).abs() < 1e-4 && end[Axis::Y] == 1.0, "{end:?}");
}

#[test]
fn a_probe_that_is_led_away_ends_the_move_where_it_comes_free() {
    // Out of a block that ends at X 25; the probe touches it from the start.
    let plate = Block { min: [-5.0, -1e3, -1e3], max: [25.0, 1e3, 1e3] };
    let program = "G38.4 X50 F600\n#1 = #5061\n#2 = #5070\nG1 X#1 Y#2 F600\nM2\n";
    let mut cnc = probing(&machine(), in_language("rs274", program), &[plate]);
    let ticks = run(&mut cnc);
    assert_eq!(cnc.state(), &State::Ended);
    let farthest = ticks.iter().map(|tick| tick.position[Axis::X]).fold(0.0, f64::max);
    assert!(farthest > 25.1 && farthest < 25.3, "{farthest}");
    let end = ticks.last().unwrap().position;
    assert!((end[Axis::X] - 25.0).abs() < 1e-4 && end[Axis::Y] == 1.0, "{end:?}");
    // Into a second block before it leaves the first: it is free behind both.
    let second = Block { min: [20.0, -1e3, -1e3], max: [31.0, 1e3, 1e3] };
    let mut cnc = probing(&machine(), in_language("rs274", program), &[plate, second]);
    assert!((run(&mut cnc).last().unwrap().position[Axis::X] - 31.0).abs() < 1e-4);
    // One that stays in contact: an alarm with G38.4, told by #5070 with G38.5.
    let alarmed = |cnc: &Cnc| matches!(cnc.state(), State::Alarmed(a) if a.fault == Fault::SkipWithoutSignal);
    let mut stays = probing(&machine(), in_language("rs274", program), &[wall(-5.0)]);
    run(&mut stays);
    assert!(alarmed(&stays), "{:?}", stays.state());
    let quiet = program.replace("G38.4", "G38.5");
    let mut stays = probing(&machine(), in_language("rs274", &quiet), &[wall(-5.0)]);
    assert_eq!(run(&mut stays).last().unwrap().position, Position::xyz(50.0, 0.0, 0.0));
    // One that has its signal before it begins: an alarm with G38.2 and G38.4, and no motion, also behind another move.
    for (program, blocks, at, braked) in [
        ("G38.4 X50 F600\nG1 Y5\nM2\n", [wall(20.0)], 0.0, 1e-9),
        ("G38.2 X50 F600\nG1 Y5\nM2\n", [wall(-5.0)], 0.0, 1e-9),
        ("G1 X10 F600\nG38.2 X50\nG1 Y5\nM2\n", [wall(5.0)], 10.0, 0.3),
    ] {
        let mut before = probing(&machine(), in_language("rs274", program), &blocks);
        let end = run(&mut before).last().unwrap().position;
        assert!(
            matches!(before.state(), State::Alarmed(a) if a.fault == Fault::SignalBefore),
            "{program} {:?} {end:?}",
            before.state()
        );
        assert!((end[Axis::X] - at).abs() < braked && end[Axis::Y] == 0.0, "{program} {end:?}");
    }
    let quiet = "G38.3 X50 F600\nG1 Y5 F600\nM2\n";
    let mut before = probing(&machine(), in_language("rs274", quiet), &[wall(-5.0)]);
    let end = run(&mut before).last().unwrap().position;
    assert_eq!((before.state(), end[Axis::X], end[Axis::Y]), (&State::Ended, 0.0, 5.0));
    // One that is free already moves nothing.
    let mut free = probing(&machine(), in_language("rs274", "G38.5 X50 F600\nM2\n"), &[wall(20.0)]);
    assert!(run(&mut free).iter().all(|tick| tick.position == Position::ZERO));
    assert_eq!(free.state(), &State::Ended);
}

#[test]
fn hold_and_reset_do_what_they_do_in_any_move() {
    let program = "G90 G31 X100 F600\nG91 G1 Y1 F600\nM30\n";
    let mut cnc = probing(&machine(), interpreter(program, ""), &[wall(40.0)]);
    cnc.cycle_start();
    let wait = |cnc: &mut Cnc, n: usize| (0..n).map(|_| cnc.tick().position).last().unwrap();
    wait(&mut cnc, 1000);
    cnc.feed_hold();
    let held = wait(&mut cnc, 500);
    assert_eq!((wait(&mut cnc, 100), cnc.state()), (held, &State::Held));
    cnc.cycle_start();
    let end = wait(&mut cnc, 6000);
    assert_eq!((end[Axis::X] > 40.0 && end[Axis::X] < 40.3, cnc.state()), (true, &State::Ended));
    let mut cnc = probing(&machine(), interpreter(program, ""), &[wall(40.0)]);
    cnc.cycle_start();
    wait(&mut cnc, 1000);
    cnc.reset();
    wait(&mut cnc, 500);
    assert_eq!(cnc.state(), &State::Reset);
}

/// What takes moves back to give them anew never gives back one that has touched.
#[test]
fn a_touch_stands_whenever_dry_run_is_switched() {
    let program = "G90 G31 X100 F600\n#100 = #5016\nG91 G1 Y1 F600\nM30\n";
    let touch = {
        let mut cnc = probing(&machine(), interpreter(program, ""), &[wall(10.0)]);
        cnc.cycle_start();
        (0..).find(|_| cnc.tick().position[Axis::X] >= 10.0).unwrap()
    };
    let dry = DryRun { speed: 10.0, cutting: false, rapid: true, tapping: false };
    for switched in touch - 150..touch + 40 {
        let mut cnc = probing(&machine(), interpreter(program, ""), &[wall(10.0)]);
        cnc.cycle_start();
        for tick in 0..6000 {
            if tick == switched {
                cnc.set_dry_run(Some(dry));
            }
            cnc.tick();
        }
        let end = cnc.tick().position;
        assert_eq!(cnc.state(), &State::Ended, "{switched}");
        // 10 mm/s: the probe's lag and braking, as in `the_move_ends_where_the_probe_touches`. An axis that swings over the
        // place where it was braked for dry run may touch too.
        assert!(end[Axis::X] > 9.99 && end[Axis::X] < 10.3, "{switched}: {end:?}");
        let touched = cnc.interpreter().memory().variables.get(100).unwrap();
        assert!((touched - 10.0).abs() < 1e-3, "{switched}: {touched}");
    }
}

proptest! {
    #![proptest_config(ProptestConfig { cases: 64, failure_persistence: None, ..ProptestConfig::default() })]

    /// In any direction and at any feed: the touch is that of the metal, the axes stay within their limits, and the
    /// next block begins where they came to rest.
    #[test]
    fn the_touch_is_where_the_metal_is(
        way in prop::array::uniform3(-80.0..80.0_f64),
        part in 0.05..0.95_f64,
        feed in 50.0..6000.0_f64,
        gain in 20.0..100.0_f64,
        feed_forward in 0.0..1.0_f64,
        sharp in any::<bool>(),
    ) {
        prop_assume!(way.iter().any(|d| d.abs() > 5.0));
        let round = |v: f64| (v * 1e4).round() / 1e4;
        let way = way.map(round);
        let mut machine = machine();
        let axes = [Axis::X, Axis::Y, Axis::Z].map(|name| PlantAxis {
            gain, feed_forward, lag_ms: 1.0, resolution: 0.0, ..PlantAxis::new(name)
        });
        machine.plant = Some(PlantConfig { axes: axes.to_vec(), ..PlantConfig::default() });
        if sharp {
            machine.axes[0].jerk = 0.0;
        }
        // A wall square to the longest axis, across the way.
        let farthest = (0..3).max_by(|a, b| way[*a].abs().total_cmp(&way[*b].abs())).unwrap();
        let face = way[farthest] * part;
        let (mut min, mut max) = ([-1e3; 3], [1e3; 3]);
        if way[farthest] > 0.0 { min[farthest] = face } else { max[farthest] = face }
        let [x, y, z] = way;
        let program = format!("G90 G31 X{x} Y{y} Z{z} F{feed:.3}\n#100=#5016\n#101=#5017\n#102=#5018\nG91 G1 X0.5 F600\nM30\n");
        let mut cnc = probing(&machine, interpreter(&program, ""), &[Block { min, max }]);
        let ticks = run(&mut cnc);
        prop_assert_eq!(cnc.state(), &State::Ended);
        let variables = &cnc.interpreter().memory().variables;
        let touched = [100, 101, 102].map(|n| variables.get(n).unwrap());
        prop_assert!((touched[farthest] - face).abs() < 2e-4, "{touched:?} {face}");
        // On the way, but for what the axes differ in lag while they run up.
        let t = machine.servo_period_ms / 1000.0;
        let rest = ticks.last().unwrap().position;
        let all: Vec<Position> = [ticks[0].position; 2].into_iter().chain(ticks.iter().map(|t| t.position)).chain([rest; 3]).collect();
        for w in all.windows(4) {
            for axis in &machine.axes {
                let [a, b, c, d] = [w[0], w[1], w[2], w[3]].map(|p| p[axis.name]);
                prop_assert!((c - 2.0 * b + a).abs() / (t * t) <= axis.acceleration * 1.001 + 1e-3);
                let jerk = if axis.jerk > 0.0 { axis.jerk } else { f64::INFINITY };
                prop_assert!((d - 3.0 * c + 3.0 * b - a).abs() / (t * t * t) <= jerk * 1.001 + 1.0);
            }
        }
        let beyond = (rest[Axis::Y] - touched[1]).abs().max((rest[Axis::Z] - touched[2]).abs());
        prop_assert!(beyond < 12.0, "{beyond}");
    }
}
