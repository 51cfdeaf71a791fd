//! Travel switches of the simulated machine, in programs and by hand, and an axis that is stuck.

use crate::common::{interpreter, machine};
use ferrocut_controller::drives::{Plant, Switches, Trouble};
use ferrocut_controller::{Cnc, JogSpeed, JogWay, State};
use ferrocut_geometry::{Axis, AxisSet, Position};
use ferrocut_machine::{AlarmId, Fault, Machine, PlantAxis, PlantConfig};

/// A machine with absolute encoders whose X has its switches 60 mm on both sides, inside the software limits.
fn close() -> Machine {
    let mut machine = machine();
    let x = PlantAxis { limits: Some([-60.0, 60.0]), ..PlantAxis::new(Axis::X) };
    machine.plant = Some(PlantConfig { axes: vec![x], ..PlantConfig::default() });
    machine
}

const ABSOLUTE: &str = "[parameters]\n\"NO20.6\" = 1\n";

fn on_plant(machine: &Machine, program: &str, setup: &str) -> Cnc {
    let interpreter = interpreter(program, &format!("{ABSOLUTE}{setup}"));
    let mut absolute = machine.clone();
    absolute.homing.absolute = true;
    let plant = Plant::new(&absolute, interpreter.position(), Position::ZERO);
    Cnc::with_drives(machine, interpreter, Box::new(plant))
}

fn run(cnc: &mut Cnc, periods: usize) -> Position {
    (0..periods).map(|_| cnc.tick().position).last().unwrap()
}

fn number(cnc: &Cnc) -> Option<u16> {
    match cnc.state() {
        State::Alarmed(alarm) => alarm.id.number(),
        _ => None,
    }
}

#[test]
fn a_program_stops_in_its_block_with_all_axes() {
    let machine = close();
    let mut cnc = on_plant(&machine, "G0 X10\nG1 X100 Y90 F6000\nX0\nM30\n", "");
    cnc.cycle_start();
    let end = run(&mut cnc, 5000);
    let State::Alarmed(alarm) = cnc.state().clone() else { panic!("{:?}", cnc.state()) };
    assert_eq!(
        (alarm.id, alarm.fault, alarm.span.line),
        (AlarmId::Dialect("gsk990mc", 511), Fault::HardLimit, 2)
    );
    assert_eq!(alarm.arguments[1], ("side", "+".into()));
    // 70.7 mm/s of X: a period late, 0.04 s of lag and braking of 70.7²/4000 mm and what the jerk adds.
    assert!(end[Axis::X] > 60.0 && end[Axis::X] < 65.0, "{end:?}");
    // On the line all the while.
    assert!((end[Axis::Y] - (end[Axis::X] - 10.0)).abs() < 1e-6, "{end:?}");
    assert_eq!(run(&mut cnc, 100), end);
}

#[test]
fn by_hand_the_release_lets_the_axis_go_back_only() {
    for (way, back, alarm, side) in
        [(JogWay::Plus, JogWay::Minus, 511, 1.0), (JogWay::Minus, JogWay::Plus, 510, -1.0)]
    {
        let machine = close();
        let mut cnc = on_plant(&machine, "G0 X1\nM30\n", "");
        assert!(cnc.jog(Axis::X, way, JogSpeed::Rapid) && cnc.jog(Axis::Y, JogWay::Plus, JogSpeed::Feed));
        let end = run(&mut cnc, 3000);
        assert_eq!(number(&cnc), Some(alarm));
        assert!(end[Axis::X] * side > 60.0 && end[Axis::X] * side < 66.0, "{end:?}");
        // Neither by hand nor by reset without the release.
        assert!(!cnc.jog(Axis::X, back, JogSpeed::Feed));
        cnc.reset();
        assert_eq!((run(&mut cnc, 200), number(&cnc)), (end, Some(alarm)));
        // With it not onwards, in no way.
        cnc.release_overtravel(true);
        cnc.jog(Axis::X, way, JogSpeed::Feed);
        cnc.jog_step(Axis::X, side as i64, 1.0);
        cnc.handwheel(Axis::X, side as i64 * 10, 0.1);
        assert_eq!(run(&mut cnc, 500), end);
        assert!(cnc.jog(Axis::X, back, JogSpeed::Feed));
        let off = run(&mut cnc, 1000);
        cnc.jog(Axis::X, JogWay::Stop, JogSpeed::Feed);
        assert!(off[Axis::X] * side < 50.0, "{off:?}");
        run(&mut cnc, 500);
        cnc.release_overtravel(false);
        run(&mut cnc, 10);
        assert_eq!(cnc.state(), &State::Reset);
        assert!(cnc.jog(Axis::X, way, JogSpeed::Feed));
    }
}

#[test]
fn an_axis_that_is_released_does_not_go_on_over_its_switch() {
    let machine = close();
    let mut cnc = on_plant(&machine, "M30\n", "");
    cnc.release_overtravel(true);
    cnc.jog(Axis::X, JogWay::Plus, JogSpeed::Feed);
    let end = run(&mut cnc, 6000);
    assert!(end[Axis::X] > 60.0 && end[Axis::X] < 63.0 && number(&cnc).is_none(), "{end:?}");
    // Let go, it is the alarm.
    cnc.release_overtravel(false);
    run(&mut cnc, 10);
    assert_eq!(number(&cnc), Some(511));
}

#[test]
fn a_program_ends_on_a_switch_under_the_release_too() {
    let machine = close();
    let mut cnc = on_plant(&machine, "G1 X100 F6000\nM30\n", "");
    cnc.release_overtravel(true);
    cnc.cycle_start();
    let end = run(&mut cnc, 3000)[Axis::X];
    assert!(number(&cnc) == Some(511) && end > 60.0 && end < 66.0, "{end}");
}

#[test]
fn switches_of_the_ladder_count_and_can_be_left_out() {
    let machine = close();
    let on = |axis: Axis| [axis].into_iter().collect::<AxisSet>();
    let mut cnc = on_plant(&machine, "G1 X30 F600\nM30\n", "");
    cnc.cycle_start();
    run(&mut cnc, 500);
    cnc.set_switches(Some(Switches { below: on(Axis::Z), ..Switches::default() }));
    run(&mut cnc, 500);
    assert_eq!(number(&cnc), Some(514));
    // 61#6.
    let mut cnc = on_plant(&machine, "G1 X100 F6000\nM30\n", "\"NO61.6\" = 1");
    cnc.cycle_start();
    assert_eq!(run(&mut cnc, 3000)[Axis::X], 100.0);
    assert_eq!(cnc.state(), &State::Ended);
}

#[test]
fn a_stuck_axis_is_found_by_its_distance_from_the_command() {
    let machine = close();
    // P445: at 6000 mm/min 2 % of 100/50 mm lag; stuck, it is 5 mm behind after 50 ms.
    let mut cnc = on_plant(&machine, "G1 Y300 F6000\nM30\n", "P445 = 5");
    cnc.cycle_start();
    run(&mut cnc, 600);
    assert_eq!(cnc.state(), &State::Running);
    let lag = |cnc: &mut Cnc| {
        let tick = cnc.tick();
        tick.position[Axis::Y] - tick.actual[Axis::Y]
    };
    assert!((lag(&mut cnc) - 0.04).abs() < 2e-3);
    let at = cnc.tick().position[Axis::Y];
    cnc.drives().plant().unwrap().trouble(Axis::Y, Trouble::Stuck(true));
    let end = run(&mut cnc, 500)[Axis::Y];
    assert_eq!(number(&cnc), Some(121));
    assert!(end > at + 5.0 && end < at + 15.0, "{at} {end}");
}
