//! Between path and drives: what every axis promises whatever the path does.
#![allow(missing_docs, clippy::unwrap_used)]

use ferrocut_geometry::{Axis, Position};
use ferrocut_machine::{Backlash, Machine, PitchErrors, Smoothing};
use ferrocut_motion::Servo;
use ferrocut_motion::servo::{Kind, ServoFaultKind};
use proptest::prelude::*;
use std::f64::consts::PI;

/// The demo mill, axis X changed.
fn machine(change: impl Fn(&mut ferrocut_machine::AxisConfig)) -> Machine {
    let mut machine = Machine::demo_mill();
    change(&mut machine.axes[0]);
    machine
}

const KINDS: [Kind; 3] = [Kind::Rapid, Kind::Cutting, Kind::Jog];

/// An axis on its way: moves from rest to rest at constant acceleration, one setpoint a period.
struct Way {
    at: f64,
    left: Vec<f64>,
}

impl Way {
    fn new() -> Way {
        Way { at: 0.0, left: Vec::new() }
    }

    /// A move to `to` with acceleration over `ramp` periods and cruise over `cruise`.
    fn go(&mut self, to: f64, ramp: u32, cruise: u32) {
        let speeds: Vec<f64> = (1..=ramp)
            .map(f64::from)
            .chain((0..cruise).map(|_| f64::from(ramp)))
            .chain((0..ramp).rev().map(f64::from))
            .collect();
        let all: f64 = speeds.iter().sum();
        let (from, mut way) = (self.at, 0.0);
        self.left.clear();
        for speed in speeds {
            way += speed;
            self.left.push(from + (to - from) * way / all);
        }
        if let Some(last) = self.left.last_mut() {
            *last = to;
        }
        self.left.reverse();
    }

    fn tick(&mut self) -> Option<Position> {
        self.at = self.left.pop()?;
        Some(Position::xyz(self.at, 0.0, 0.0))
    }
}

/// A move: how far, periods of acceleration and cruise, kind, periods of rest behind it.
type Leg = (f64, u32, u32, usize, u32);

fn legs() -> impl Strategy<Value = Vec<Leg>> {
    prop::collection::vec((-20.0..20.0f64, 1u32..40, 0u32..30, 0usize..3, 0u32..120), 1..12)
}

/// Smallest and largest difference of order `n` of a sequence, over period^n.
fn difference(x: &[f64], n: usize, period: f64) -> f64 {
    let mut d = x.to_vec();
    for _ in 0..n {
        d = d.windows(2).map(|w| w[1] - w[0]).collect();
    }
    d.iter().fold(0.0, |m: f64, v| m.max(v.abs())) / period.powi(n as i32)
}

/// Runs the legs; setpoints, positions and drive positions of X, padded with rest.
fn run(servo: &mut Servo, legs: &[Leg]) -> [Vec<f64>; 3] {
    let mut way = Way::new();
    let mut all = [vec![0.0; 4], vec![0.0; 4], vec![servo.added()[Axis::X]; 4]];
    let take = |servo: &mut Servo, setpoint: Position, kind: usize, all: &mut [Vec<f64>; 3]| {
        let command = servo.tick(&setpoint, KINDS[kind]);
        for (list, at) in all.iter_mut().zip([setpoint, command.position, command.drive]) {
            list.push(at[Axis::X]);
        }
    };
    let mut last = 1;
    for (to, ramp, cruise, kind, rest) in legs {
        way.go(*to, *ramp, *cruise);
        while let Some(setpoint) = way.tick() {
            take(servo, setpoint, *kind, &mut all);
        }
        for _ in 0..*rest {
            take(servo, Position::xyz(way.at, 0.0, 0.0), *kind, &mut all);
        }
        last = *kind;
    }
    for _ in 0..3000 {
        take(servo, Position::xyz(way.at, 0.0, 0.0), last, &mut all);
    }
    all
}

fn cases(cases: u32) -> ProptestConfig {
    ProptestConfig { cases, failure_persistence: None, ..ProptestConfig::default() }
}

proptest! {
    #![proptest_config(cases(200))]

    #[test]
    fn with_nothing_set_the_command_is_the_setpoint_bit_by_bit(x in prop::array::uniform9(-400.0..400.0f64)) {
        let mut servo = Servo::new(&Machine::demo_mill(), Position::ZERO);
        for sign in [1.0, -1.0] {
            let setpoint = Position(x.map(|v| v * sign));
            let command = servo.tick(&setpoint, Kind::Cutting);
            let bits = |p: &Position| p.0.map(f64::to_bits);
            prop_assert_eq!(bits(&command.position), bits(&setpoint));
            prop_assert_eq!(bits(&command.drive), bits(&setpoint));
            prop_assert!(servo.is_at_rest());
        }
    }

    /// A mean is nowhere faster than what it is the mean of, nor accelerated more, and it ends on it.
    #[test]
    fn smoothing_keeps_the_limits_of_the_path_and_ends_on_it(
        legs in legs(),
        times in prop::array::uniform3(0.0..150.0f64),
        kinds in prop::array::uniform3(0u8..3),
        one in any::<bool>(),
    ) {
        let smoothing = |k: usize| match kinds[k] {
            0 => Smoothing::None,
            1 => Smoothing::Linear { time_ms: times[k] },
            _ => Smoothing::Exponential { time_ms: times[k], least: 0.0 },
        };
        let machine = machine(|axis| {
            (axis.after_rapid, axis.after_cutting, axis.after_jog) = (smoothing(0), smoothing(1), smoothing(2));
        });
        let mut servo = Servo::new(&machine, Position::ZERO);
        let legs: Vec<Leg> = legs.iter().map(|l| (l.0, l.1, l.2, if one { 0 } else { l.3 }, l.4)).collect();
        let [setpoints, positions, drives] = run(&mut servo, &legs);
        prop_assert_eq!(&positions, &drives);
        prop_assert!(servo.is_at_rest());
        prop_assert_eq!(positions.last(), setpoints.last());
        let (before, after) = (setpoints.iter().copied(), positions.iter().copied());
        let range = |x: &mut dyn Iterator<Item = f64>| x.fold((0.0f64, 0.0f64), |r, v| (r.0.min(v), r.1.max(v)));
        let (in_range, out_range) = (range(&mut before.into_iter()), range(&mut after.into_iter()));
        if one {
            // The last thousandth of an exponential lag is run at constant speed.
            let step = 2e-6 / 0.001;
            prop_assert!(difference(&positions, 1, 0.001) <= difference(&setpoints, 1, 0.001) * (1.0 + 1e-9) + step);
            let most = difference(&setpoints, 2, 0.001) * (1.0 + 1e-9) + step / 0.001;
            prop_assert!(difference(&positions, 2, 0.001) <= most);
            prop_assert!(out_range.0 >= in_range.0 - 1e-9 && out_range.1 <= in_range.1 + 1e-9);
        }
        // Whatever follows whatever: no jump beyond what the kinds add up to.
        prop_assert!(difference(&positions, 1, 0.001) <= 3.0 * difference(&setpoints, 1, 0.001) + 0.01);
    }

    /// What is added runs from one value to the other and back, within the limits of the axis, and is exact.
    #[test]
    fn backlash_is_taken_up_monotonously_and_within_the_limits(
        legs in legs(),
        play in -0.05..0.3f64,
        rapid in prop::option::of(0.0..0.3f64),
        time_ms in 0.0..60.0f64,
        homes_negative in any::<bool>(),
    ) {
        let backlash = Backlash { cutting: play, rapid, time_ms, homes_negative, ..Backlash::default() };
        let machine = machine(|axis| axis.backlash = backlash.clone());
        let mut servo = Servo::new(&machine, Position::ZERO);
        let [_, positions, drives] = run(&mut servo, &legs);
        let added: Vec<f64> = drives.iter().zip(&positions).map(|(d, p)| d - p).collect();
        let home = if homes_negative { -1.0 } else { 1.0 };
        let values = [play, rapid.unwrap_or(play)].map(|b| [-1.0, 1.0].map(|side| (side * b - home * play) / 2.0));
        let all = || values.iter().flatten().copied();
        let (least, most) = (all().fold(0.0, f64::min), all().fold(0.0, f64::max));
        prop_assert!(added.iter().all(|a| *a >= least - 1e-9 && *a <= most + 1e-9));
        // At rest it is one of the four values, but for what the subtraction above rounds off.
        let last = *added.last().unwrap();
        prop_assert!(all().any(|v| (v - last).abs() < 1e-12), "{last} {values:?}");
        let x = &machine.axes[0];
        prop_assert!(difference(&added, 1, 0.001) <= x.rapid / 60.0 + 1e-6);
        prop_assert!(difference(&added, 2, 0.001) <= x.acceleration * 1.001 + 1e-2);
        prop_assert!(difference(&added, 3, 0.001) <= x.jerk * 1.001 + 10.0);
        if rapid.is_none() {
            // Between two turns of the axis it goes one way.
            let mut turns = 0;
            let mut side = 0.0f64;
            for w in positions.windows(2) {
                let d = w[1] - w[0];
                if d.abs() > 1e-6 && d.signum() != side {
                    side = d.signum();
                    turns += 1;
                }
            }
            let steps: Vec<f64> = added.windows(2).map(|w| w[1] - w[0]).filter(|d| d.abs() > 1e-10).collect();
            let changes = steps.windows(2).filter(|w| w[0].signum() != w[1].signum()).count();
            prop_assert!(changes <= turns, "{changes} changes, {turns} turns");
        }
    }

    /// A table adds what its points say, and the axis stays continuous over its points and its turns.
    #[test]
    fn pitch_errors_are_added_without_a_jump(
        legs in legs(),
        points in prop::collection::vec(-0.02..0.02f64, 1..20),
        back in prop::option::of(prop::collection::vec(-0.02..0.02f64, 20)),
    ) {
        let errors = PitchErrors {
            start: Some(-15.0),
            interval: Some(2.5),
            opposite: back.map_or(Vec::new(), |b| b[..points.len()].to_vec()),
            corrections: points,
        };
        let machine = machine(|axis| axis.pitch_errors = Some(errors.clone()));
        let mut servo = Servo::new(&machine, Position::ZERO);
        let [_, positions, drives] = run(&mut servo, &legs);
        let added: Vec<f64> = drives.iter().zip(&positions).map(|(d, p)| d - p).collect();
        // The steepest slope is 0.04 in 2.5 mm.
        let speed = difference(&positions, 1, 0.001) * 0.016;
        let ramp = machine.axes[0].rapid / 60.0;
        prop_assert!(difference(&added, 1, 0.001) <= speed + ramp + 1e-6);
        // On its own table once the turn is done.
        let value = |list: &[f64], at: f64| {
            let place = ((at + 15.0) / 2.5).clamp(0.0, (list.len() - 1) as f64);
            let below = place.floor() as usize;
            let next = (below + 1).min(list.len() - 1);
            list[below] + (place - below as f64) * (list[next] - list[below])
        };
        let at = *positions.last().unwrap();
        let last = *added.last().unwrap();
        let on = value(&errors.corrections, at);
        let back = if errors.opposite.is_empty() { on } else { value(&errors.opposite, at) };
        prop_assert!((last - on).abs() < 1e-12 || (last - back).abs() < 1e-12, "{last}: {on} or {back}");
    }
}

#[test]
fn a_million_random_moves_leave_no_drift() {
    let machine = machine(|axis| {
        axis.after_cutting = Smoothing::Linear { time_ms: 7.3 };
        axis.after_rapid = Smoothing::Exponential { time_ms: 5.0, least: 10.0 };
        axis.backlash = Backlash { cutting: 0.0123, time_ms: 5.0, ..Backlash::default() };
    });
    let mut servo = Servo::new(&machine, Position::ZERO);
    let mut random = 1u64;
    let mut at = 0.0;
    for k in 0..1_000_000u32 {
        random = random.wrapping_mul(6364136223846793005).wrapping_add(1442695040888963407);
        at = (at + ((random >> 33) as f64 / 2f64.powi(31) - 0.5) * 0.3f64).clamp(-400.0, 400.0);
        let setpoint = Position::xyz(at, 0.0, 0.0);
        servo.tick(&setpoint, KINDS[(random >> 60) as usize % 3]);
        if k % 1000 == 999 {
            for _ in 0..400 {
                servo.tick(&setpoint, Kind::Cutting);
            }
            let command = servo.tick(&setpoint, Kind::Cutting);
            assert!(servo.is_at_rest());
            assert_eq!(command.position, setpoint);
            let drive = command.drive[Axis::X];
            assert!(drive == at || drive == at - 0.0123, "{drive} {at}");
        }
    }
}

#[test]
fn a_circle_shrinks_by_what_the_documentation_says() {
    let (r, v, t) = (10.0, 100.0, 0.040);
    let linear = |u: f64| r * (1.0 - u.sin() / u);
    for (smoothing, shrinks) in [
        (Smoothing::Linear { time_ms: t * 1000.0 }, linear(v * t / (2.0 * r))),
        (
            Smoothing::Exponential { time_ms: t * 1000.0, least: 0.0 },
            r * (1.0 - (1.0 + (v * t / r).powi(2)).sqrt().recip()),
        ),
    ] {
        let mut machine = Machine::demo_mill();
        machine.servo_period_ms = 0.1;
        for axis in &mut machine.axes {
            axis.after_cutting = smoothing;
        }
        let mut servo = Servo::new(&machine, Position::xyz(r, 0.0, 0.0));
        let mut radius = 0.0;
        for k in 0..50_000 {
            let phi = v / r * f64::from(k) * 1e-4;
            let setpoint = Position::xyz(r * phi.cos(), r * phi.sin(), 0.0);
            let p = servo.tick(&setpoint, Kind::Cutting).position;
            radius = p[Axis::X].hypot(p[Axis::Y]);
        }
        let found = r - radius;
        assert!((found - shrinks).abs() < 0.02 * shrinks, "{smoothing:?}: {found} instead of {shrinks}");
    }
    // The rule of thumb, v²T²/24r, is off by u²/20.
    assert!((linear(v * t / (2.0 * r)) - v * v * t * t / (24.0 * r)).abs() < 1e-3);
}

#[test]
fn a_change_of_speed_takes_the_time_constant() {
    let machine = machine(|axis| axis.after_jog = Smoothing::Linear { time_ms: 20.0 });
    let mut servo = Servo::new(&machine, Position::ZERO);
    let mut before = 0.0;
    for k in 1..=40 {
        // From rest to 50 mm/s at once: 0.05 mm a period.
        let x = servo.tick(&Position::xyz(f64::from(k) * 0.05, 0.0, 0.0), Kind::Jog).position[Axis::X];
        let speed = 0.05 * f64::from(k.min(20)) / 20.0;
        assert!((x - before - speed).abs() < 1e-9, "period {k}: {}", x - before);
        before = x;
    }
}

#[test]
fn backlash_at_a_fixed_rate_adds_a_step_a_period() {
    // 180 mm/min are 0.003 mm in 1 ms.
    let machine = machine(|axis| {
        axis.backlash = Backlash { cutting: 0.010, rate: 180.0, waits: true, ..Backlash::default() };
    });
    let mut servo = Servo::new(&machine, Position::ZERO);
    assert_eq!(servo.tick(&Position::xyz(1.0, 0.0, 0.0), Kind::Cutting).drive[Axis::X], 1.0);
    let mut added = |x: f64| {
        let command = servo.tick(&Position::xyz(x, 0.0, 0.0), Kind::Cutting);
        (((command.drive - command.position)[Axis::X] * 1e6).round() / 1e6, servo.is_at_rest())
    };
    assert_eq!([added(0.9), added(0.9), added(0.9)], [(-0.003, false), (-0.006, false), (-0.009, false)]);
    assert_eq!([added(0.8), added(0.7), added(0.9)], [(-0.010, true), (-0.010, true), (-0.007, false)]);
}

#[test]
fn rapid_and_cutting_have_values_of_their_own() {
    // A = 0.01 cutting, B = 0.02 positioning, α = (A − B)/2 = −0.005.
    let machine = machine(|axis| {
        axis.backlash = Backlash { cutting: 0.01, rapid: Some(0.02), rate: 6e4, ..Backlash::default() };
    });
    let mut servo = Servo::new(&machine, Position::ZERO);
    let mut added = |x: f64, kind| {
        let command = servo.tick(&Position::xyz(x, 0.0, 0.0), kind);
        ((command.drive - command.position)[Axis::X] * 1e6).round() / 1e6
    };
    use Kind::{Cutting, Rapid};
    let found =
        [added(1.0, Cutting), added(2.0, Rapid), added(1.0, Rapid), added(0.5, Cutting), added(0.8, Rapid)];
    // Cutting to positioning −α, turn B, positioning to cutting α, turn into positioning B + α.
    assert_eq!(found, [0.0, 0.005, -0.015, -0.010, 0.005]);
}

#[test]
fn no_axis_goes_on_beyond_its_limits() {
    let machine = Machine::demo_mill();
    let mut servo = Servo::new(&machine, Position::ZERO);
    let mut at = |x: f64| servo.tick(&Position::xyz(x, 0.0, 0.0), Kind::Rapid).fault;
    assert_eq!([at(500.0), at(500.01)], [None, None]);
    let fault = at(500.02).unwrap();
    assert_eq!((fault.axis, fault.kind, fault.value), (Axis::X, ServoFaultKind::AboveLimit, 500.02));
    // Standing there or coming back is none, going on is.
    assert_eq!([at(500.02), at(500.015)], [None, None]);
    assert!(at(501.0).is_some());
    assert_eq!(at(-500.5).unwrap().kind, ServoFaultKind::BelowLimit);
}

#[test]
fn an_axis_that_does_not_follow_or_arrive_is_told() {
    let mut machine = machine(|axis| (axis.following_error, axis.in_position) = (0.5, 0.01));
    machine.servo.in_position_ms = 10.0;
    let mut servo = Servo::new(&machine, Position::ZERO);
    let mut period = |x: f64, behind: f64| {
        let drive = servo.tick(&Position::xyz(x, 0.0, 0.0), Kind::Cutting).drive;
        let fault = servo.supervise(&(drive - Position::xyz(behind, 0.0, 0.0)));
        (fault.map(|f| (f.kind, f.limit)), servo.is_at_rest())
    };
    assert_eq!(period(1.0, 0.5), (None, false));
    assert_eq!(period(2.0, -0.51), (Some((ServoFaultKind::FollowingError, 0.5)), false));
    assert_eq!(period(3.0, f64::NAN).0, Some((ServoFaultKind::FollowingError, 0.5)));
    for _ in 0..10 {
        assert_eq!(period(3.0, 0.02), (None, false));
    }
    assert_eq!(period(3.0, 0.02).0, Some((ServoFaultKind::NotInPosition, 0.01)));
    assert_eq!(period(3.0, 0.01), (None, true));
}

#[test]
fn an_axis_beside_the_pitch_points_is_told() {
    let machine = machine(|axis| {
        axis.pitch_errors = Some(PitchErrors {
            start: Some(0.0),
            interval: Some(10.0),
            corrections: vec![0.0, 0.01],
            opposite: Vec::new(),
        });
    });
    let mut servo = Servo::new(&machine, Position::ZERO);
    let mut at = |x: f64| servo.tick(&Position::xyz(x, 0.0, 0.0), Kind::Rapid).fault;
    assert_eq!([at(400.0), at(-4.9)], [None, None]);
    let fault = at(-5.1).unwrap();
    assert_eq!((fault.kind, fault.limit), (ServoFaultKind::BesidePitchPoints, 0.0));
}

#[test]
fn what_is_renamed_stands_still() {
    let machine = machine(|axis| {
        axis.after_cutting = Smoothing::Linear { time_ms: 20.0 };
        axis.backlash = Backlash { cutting: 0.02, ..Backlash::default() };
        axis.pitch_errors = Some(PitchErrors {
            start: Some(0.0),
            interval: Some(10.0),
            corrections: vec![0.0, 0.01],
            opposite: Vec::new(),
        });
    });
    let mut servo = Servo::new(&machine, Position::ZERO);
    servo.tick(&Position::xyz(5.0, 0.0, 0.0), Kind::Cutting);
    let at = Position::xyz(10.0, 0.0, 0.0);
    servo.rename(at);
    let command = servo.tick(&at, Kind::Cutting);
    assert_eq!((command.position, command.drive[Axis::X], servo.is_at_rest()), (at, 10.01, true));
}

/// GSK990MC P129: the lowest speed is that of what is left at the end, and of nothing before.
#[test]
fn the_lowest_speed_of_an_exponential_lag_is_its_end_alone() {
    let servo = |least: f64| {
        let mut machine = Machine::demo_mill();
        for axis in &mut machine.axes {
            axis.after_cutting = Smoothing::Exponential { time_ms: 60.0, least };
        }
        Servo::new(&machine, Position::ZERO)
    };
    // A circle with its quadrants, and a line that is nearly along X.
    let circle = |k: u32| {
        let phi = 2.0 * PI * (f64::from(k.min(1000)) / 1000.0);
        Position::xyz(20.0 * (1.0 - phi.cos()), 20.0 * phi.sin(), 0.0)
    };
    let line = |k: u32| {
        Position::xyz(100.0, 1.0, 0.0).zip(Position::ZERO, |to, _| to * f64::from(k.min(1000)) / 1000.0)
    };
    for least in [10.0, 600.0, 9999.0] {
        for (path, is_line) in [(&circle as &dyn Fn(u32) -> Position, false), (&line, true)] {
            let (mut with, mut without) = (servo(least), servo(0.0));
            let mut positions = Vec::new();
            for k in 1..=3000 {
                let position = with.tick(&path(k), Kind::Cutting).position;
                let other = without.tick(&path(k), Kind::Cutting).position;
                if k <= 1000 {
                    assert_eq!(position, other, "{least} {k}");
                }
                if is_line {
                    assert!(
                        (position[Axis::Y] - position[Axis::X] / 100.0).abs() < 1e-9,
                        "{least} {k} {position:?}"
                    );
                }
                positions.push(position);
            }
            assert!(with.is_at_rest() && positions.last() == Some(&path(3000)), "{least}");
            let end = &positions[1000..];
            let sharpest = end.windows(3).map(|p| {
                let change = |axis: Axis| (p[2][axis] - 2.0 * p[1][axis] + p[0][axis]).abs() * 1e6;
                change(Axis::X).max(change(Axis::Y))
            });
            assert!(sharpest.fold(0.0, f64::max) < 2000.0 * 1.001, "{least}");
        }
    }
}
