//! What the parameters say of acceleration and of corners (7.5, 7.6, appendix 1).
//!
//! **Time constants** lead from rest to the highest speed (figure 7-5-1): of positioning the axis's rapid speed, of
//! cutting that of P96. So a linear ramp has the acceleration `v/T`. An S has one time constant as well; its
//! acceleration rises with constant jerk in the first half of `T` and falls in the second: `2v/T` at most, with the
//! jerk `4v/T²`. Look-ahead has an acceleration instead (P134), which the S takes P135 to build up (Fanuc 1770 to 1772).
//!
//! Acceleration before interpolation of cutting is that of the path, of positioning that of each axis. What the
//! machine file says of an axis is never exceeded, save that a linear ramp has no jerk limit.

use super::rules::corner_rule;
use ferrocut_machine::{
    ArcSlowdown, AxisConfig, CornerSlowdown, Machine, ParameterKey, Parameters, PathConfig, Ramp, Smoothing,
};
use ferrocut_toolpath::CornerRule;

/// Writes the parameters over what the machine file says.
pub fn machine_parameters(parameters: &Parameters, machine: &mut Machine) {
    corners(parameters, &mut machine.path);
    feeds(parameters, &mut machine.path);
    let by = machine.servo.acceleration_by_parameters;
    let selects = |of: Of| by.unwrap_or_else(|| parameters.given().any(|(key, _)| of == Of::key(key)));
    let is_linear = selects(Of::Cutting) && path(parameters, &mut machine.path);
    if selects(Of::Clamp) {
        clamp(parameters, &mut machine.path);
    }
    if selects(Of::Arcs) {
        // Fanuc 1730 to 1732.
        let p = |number: u16| parameters.data(number);
        machine.path.arc = Some(ArcSlowdown { acceleration: p(148), lowest_feed: p(149) });
    }
    for (k, name) in (0u16..).zip(parameters.axis_names()) {
        let Some(axis) = machine.axes.iter_mut().find(|axis| axis.name == name) else { continue };
        rapid_speed(parameters, k, axis);
        if is_linear {
            axis.before_cutting = Some(Ramp { acceleration: axis.acceleration, jerk: 0.0 });
        }
        if selects(Of::Rapid) {
            before_rapid(parameters, k, axis);
        }
        after(parameters, k, axis, selects);
    }
}

/// What parameters of acceleration are of.
#[derive(Clone, Copy, PartialEq, Eq)]
enum Of {
    Rapid,
    Cutting,
    /// The highest acceleration of the path.
    Clamp,
    Arcs,
    Hand,
    Nothing,
}

impl Of {
    fn key(key: &ParameterKey) -> Of {
        match key {
            ParameterKey::Bit { number: 16, bit: 0..=2 } | ParameterKey::Data(105..=124) => Of::Rapid,
            ParameterKey::Bit { number: 17, bit: 0..=2 }
            | ParameterKey::Bit { number: 15, bit: 0 | 1 }
            | ParameterKey::Data(125..=128 | 133..=139) => Of::Cutting,
            ParameterKey::Bit { number: 17, bit: 6 } | ParameterKey::Data(150) => Of::Clamp,
            ParameterKey::Data(148 | 149) => Of::Arcs,
            ParameterKey::Bit { number: 17, bit: 3 | 5 } | ParameterKey::Data(152..=154 | 156..=158) => {
                Of::Hand
            }
            _ => Of::Nothing,
        }
    }
}

/// P88 to P92, P94: G00 of axis `k` is no faster than they say, where somebody has set them; as delivered they are
/// those of no machine in particular.
fn rapid_speed(parameters: &Parameters, k: u16, axis: &mut AxisConfig) {
    let of_axis = [88 + k, 94].map(ParameterKey::Data);
    for (_, speed) in parameters.given().filter(|(key, speed)| of_axis.contains(key) && *speed > 0.0) {
        axis.rapid = axis.rapid.min(speed);
    }
}

/// Whether cutting is accelerated before interpolation: 17#0, and always in look-ahead, 15#0.
fn is_before(parameters: &Parameters) -> bool {
    parameters.bit(15, 0) || !parameters.bit(17, 0)
}

/// The speed of cutting, overrides included, is held between P97 and P96 (4.2.2 note 1).
fn feeds(parameters: &Parameters, path: &mut PathConfig) {
    path.lowest_feed = parameters.data(97);
    path.highest_feed = Some(parameters.data(96).max(path.lowest_feed));
}

/// Corners slowed down for in look-ahead, where 16#7 has them: 15#2, P144 to P146.
fn corners(parameters: &Parameters, path: &mut PathConfig) {
    if parameters.bit(15, 0) && parameters.bit(16, 7) {
        let (angle, speed_difference) = match corner_rule(parameters) {
            CornerRule::Angle(angle) => (Some(angle), None),
            CornerRule::SpeedDifference(difference) => (None, Some(difference)),
        };
        path.corner = Some(CornerSlowdown { angle, speed_difference, lowest_feed: parameters.data(145) });
    }
}

/// Acceleration of the path while cutting, and how far the path may be left. Whether cutting has linear ramps
/// before interpolation, for which the axes may have no jerk limit.
fn path(parameters: &Parameters, path: &mut PathConfig) -> bool {
    let p = |number: u16| parameters.data(number);
    let (is_ahead, is_s) = (parameters.bit(15, 0), parameters.bit(17, 1));
    let highest = p(96) / 60.0;
    let ramp = match (is_ahead, is_s) {
        // Alarm 0239 is about an acceleration of 0; here the axes are left to limit it.
        (true, _) if p(134) <= 0.0 => None,
        (true, true) if p(135) > 0.0 => Some(Ramp { acceleration: p(134), jerk: p(134) / (p(135) / 1000.0) }),
        (true, _) => Some(Ramp { acceleration: p(134), jerk: 0.0 }),
        (false, _) if !is_before(parameters) => None,
        (false, true) => Some(s_ramp(highest, p(126))),
        (false, false) => Some(linear_ramp(highest, p(125))),
    };
    path.ramp = ramp.or(path.ramp);
    if is_before(parameters) {
        path.tolerance = if is_ahead { p(139) } else { p(133) };
    }
    ramp.is_some_and(|ramp| ramp.jerk == 0.0)
}

/// 17#6, P150: whatever accelerates, no faster than to P96 in this time.
fn clamp(parameters: &Parameters, path: &mut PathConfig) {
    let p = |number: u16| parameters.data(number);
    if parameters.bit(17, 6) && p(150) > 0.0 {
        let clamp = p(96) / 60.0 / (p(150) / 1000.0);
        let acceleration = path.ramp.map_or(clamp, |ramp| ramp.acceleration.min(clamp));
        // Without a ramp of its own the path keeps the jerk of its axes.
        let jerk = path.ramp.map_or(NO_JERK_LIMIT, |ramp| ramp.jerk);
        path.ramp = Some(Ramp { acceleration, jerk });
    }
}

/// Of the path alone: the axes have theirs.
const NO_JERK_LIMIT: f64 = 0.0;

/// 16#0, 16#1, P105 to P114: positioning of axis `k`.
fn before_rapid(parameters: &Parameters, k: u16, axis: &mut AxisConfig) {
    if !parameters.bit(16, 0) {
        let v = axis.rapid / 60.0;
        axis.before_rapid = Some(match parameters.bit(16, 1) {
            true => s_ramp(v, parameters.data(110 + k)),
            false => linear_ramp(v, parameters.data(105 + k)),
        });
    }
}

/// To `v` mm/s in `time` ms at constant acceleration.
fn linear_ramp(v: f64, time: f64) -> Ramp {
    Ramp { acceleration: v / (time / 1000.0), jerk: 0.0 }
}

/// The same along an S.
fn s_ramp(v: f64, time: f64) -> Ramp {
    let t = time / 1000.0;
    Ramp { acceleration: 2.0 * v / t, jerk: 4.0 * v / (t * t) }
}

/// Bits 16#0, 16#2, 17#0, 17#2, 17#3, 17#5 and the time constants after interpolation of axis `k`.
fn after(parameters: &Parameters, k: u16, axis: &mut AxisConfig, selects: impl Fn(Of) -> bool) {
    let p = |number: u16| parameters.data(number);
    let select = |is_after: bool, is_exponential: bool, linear: u16, exponential: u16, least: u16| match (
        is_after,
        is_exponential,
    ) {
        (false, _) => Smoothing::None,
        (true, false) => Smoothing::Linear { time_ms: p(linear) },
        (true, true) => Smoothing::Exponential { time_ms: p(exponential), least: p(least) },
    };
    if selects(Of::Rapid) {
        axis.after_rapid = select(parameters.bit(16, 0), parameters.bit(16, 2), 115 + k, 120 + k, 129);
    }
    if selects(Of::Cutting) {
        // 15#0: look-ahead has acceleration before and after interpolation, with constants of its own.
        axis.after_cutting = match parameters.bit(15, 0) {
            true => select(true, parameters.bit(15, 1), 136, 137, 138),
            false => select(parameters.bit(17, 0), parameters.bit(17, 2), 127, 128, 129),
        };
    }
    if selects(Of::Hand) {
        // 1.2: movements by hand are always accelerated after interpolation.
        axis.after_jog = select(true, parameters.bit(17, 3), 156, 157, 129);
        axis.after_wheel = Some(wheel(parameters));
    }
}

/// 17#5, P152, P153, P129: the handwheel. P154 clamps its acceleration, and P158 where counts may be lost (56#0 = 0), to its
/// highest speed in that time: so no time constant is shorter.
fn wheel(parameters: &Parameters) -> Smoothing {
    let p = |number: u16| parameters.data(number);
    let clamp = p(if parameters.bit(56, 0) { 154 } else { 158 });
    match parameters.bit(17, 5) {
        false => Smoothing::Linear { time_ms: p(152).max(clamp) },
        true => Smoothing::Exponential { time_ms: p(153).max(clamp), least: p(129) },
    }
}

#[cfg(test)]
mod tests {
    use super::*;
    use ferrocut_geometry::Axis;
    use ferrocut_machine::ParameterTable;

    /// The demo mill, accelerated by parameters, with some of them set.
    fn machine(set: &[(&str, f64)]) -> Machine {
        let mut parameters = Parameters::new(ParameterTable::of("gsk990mc").unwrap());
        for (name, value) in set {
            parameters.set(&name.parse().unwrap(), *value).unwrap();
        }
        let mut machine = Machine::demo_mill();
        machine.servo.acceleration_by_parameters = Some(true);
        machine_parameters(&parameters, &mut machine);
        machine
    }

    fn close(ramp: Option<Ramp>, acceleration: f64, jerk: f64) {
        let ramp = ramp.unwrap();
        let is_close = |a: f64, b: f64| (a - b).abs() <= 1e-9 * b.abs();
        assert!(is_close(ramp.acceleration, acceleration) && is_close(ramp.jerk, jerk), "{ramp:?}");
    }

    #[test]
    fn acceleration_after_interpolation_is_selected_by_bits() {
        let axis = |set: &[(&str, f64)]| {
            machine(set).axis(Axis::Y).unwrap().smoothing().map(|(_, smoothing)| smoothing)
        };
        let linear = |time_ms| Smoothing::Linear { time_ms };
        let exponential = |time_ms, least| Smoothing::Exponential { time_ms, least };
        // 16#0 = 0, 17#0 = 1, 17#2 = 0, 17#3 = 0, 17#5 = 1, P154 above P153.
        let wheel = exponential(100.0, 10.0);
        assert_eq!(axis(&[]), [Smoothing::None, linear(80.0), linear(100.0), wheel]);
        let set = [("NO16.0", 1.0), ("P116", 90.0), ("NO17.0", 0.0), ("NO17.3", 1.0), ("P129", 12.0)];
        let wheel = exponential(100.0, 12.0);
        assert_eq!(axis(&set), [linear(90.0), Smoothing::None, exponential(120.0, 12.0), wheel]);
        let set = [("NO16.0", 1.0), ("NO16.2", 1.0), ("P121", 50.0), ("NO17.2", 1.0), ("P128", 70.0)];
        assert_eq!(axis(&set)[..3], [exponential(50.0, 10.0), exponential(70.0, 10.0), linear(100.0)]);
        assert_eq!(axis(&[("NO15.0", 1.0), ("P136", 33.0)])[1], linear(33.0));
        // 15#1, in look-ahead alone.
        let look_ahead = [("NO15.1", 1.0), ("P137", 66.0), ("P138", 20.0), ("P129", 12.0)];
        assert_eq!(axis(&[&look_ahead[..], &[("NO15.0", 1.0)]].concat())[1], exponential(66.0, 20.0));
        assert_eq!(axis(&look_ahead)[1], linear(80.0));
        // The handwheel: linear P152, exponential P153, neither shorter than its clamp, P154 or P158 by 56#0.
        for (set, wanted) in [
            (vec![("NO17.5", 0.0)], linear(120.0)),
            (vec![("NO17.5", 0.0), ("P152", 40.0)], linear(100.0)),
            (vec![("NO17.5", 0.0), ("P152", 40.0), ("NO56.0", 0.0)], linear(50.0)),
            (vec![("P153", 200.0), ("P154", 300.0)], exponential(300.0, 10.0)),
            (vec![("P153", 200.0), ("P154", 300.0), ("NO56.0", 0.0)], exponential(200.0, 10.0)),
        ] {
            assert_eq!(axis(&set)[3], wanted, "{set:?}");
        }
    }

    #[test]
    fn positioning_reaches_the_rapid_speed_in_its_time_constant() {
        let rapid = |set: &[(&str, f64)]| machine(set).axis(Axis::Y).unwrap().before_rapid;
        // 16#1 = 1: an S in 60 ms to 15 m/min = 250 mm/s.
        close(rapid(&[]), 2.0 * 250.0 / 0.06, 4.0 * 250.0 / 0.0036);
        close(rapid(&[("P111", 200.0)]), 2500.0, 25_000.0);
        // Linear in 250 ms; P105 is the first axis's.
        close(rapid(&[("NO16.1", 0.0), ("P106", 250.0), ("P105", 400.0)]), 1000.0, 0.0);
        assert_eq!(rapid(&[("NO16.0", 1.0)]), None);
    }

    #[test]
    fn cutting_reaches_its_highest_speed_in_its_time_constant() {
        let path = |set: &[(&str, f64)]| machine(set).path;
        // 17#0 = 1: as the machine file says.
        assert_eq!((path(&[]).ramp, path(&[]).tolerance), (None, 0.01));
        // P96 is 6000 mm/min: 100 mm/s in 100 ms.
        let set = [("NO17.0", 0.0), ("P133", 0.02)];
        close(path(&set).ramp, 1000.0, 0.0);
        assert_eq!(path(&set).tolerance, 0.02);
        let axis = |set: &[(&str, f64)]| machine(set).axis(Axis::X).unwrap().before_cutting;
        assert_eq!(axis(&set), Some(Ramp { acceleration: 2000.0, jerk: 0.0 }));
        close(path(&[("NO17.0", 0.0), ("P125", 200.0), ("P96", 9000.0)]).ramp, 750.0, 0.0);
        // An S in 200 ms; the axes keep their own jerk.
        let s = [("NO17.0", 0.0), ("NO17.1", 1.0), ("P126", 200.0)];
        close(path(&s).ramp, 1000.0, 10_000.0);
        assert_eq!(axis(&s), None);
        // 17#6 clamps what there is: 100 mm/s in 250 ms are 400 mm/s².
        let clamp = [("NO17.6", 1.0), ("P150", 250.0)];
        close(path(&clamp).ramp, 400.0, 0.0);
        assert_eq!(axis(&clamp), None);
        close(path(&[&s[..], &clamp].concat()).ramp, 400.0, 10_000.0);
    }

    #[test]
    fn look_ahead_has_an_acceleration() {
        let path = |set: &[(&str, f64)]| machine(&[&[("NO15.0", 1.0)], set].concat()).path;
        close(path(&[]).ramp, 250.0, 0.0);
        close(path(&[("P134", 800.0), ("NO17.1", 1.0)]).ramp, 800.0, 8000.0);
        assert_eq!(path(&[("P134", 0.0)]).ramp, None);
        assert_eq!(path(&[("P139", 0.03), ("P133", 0.02)]).tolerance, 0.03);
        let arc = path(&[("P148", 500.0), ("P149", 300.0)]).arc;
        assert_eq!(arc, Some(ArcSlowdown { acceleration: 500.0, lowest_feed: 300.0 }));
    }

    #[test]
    fn look_ahead_slows_down_for_corners() {
        let corner = |set: &[(&str, f64)]| {
            let mut parameters = Parameters::new(ParameterTable::of("gsk990mc").unwrap());
            for (name, value) in set {
                parameters.set(&name.parse().unwrap(), *value).unwrap();
            }
            // Whether or not acceleration is that of the parameters.
            let mut machine = Machine::demo_mill();
            machine_parameters(&parameters, &mut machine);
            machine.path.corner
        };
        assert_eq!(corner(&[("NO16.7", 1.0)]), None);
        assert_eq!(corner(&[("NO15.0", 1.0)]), None);
        let both = [("NO15.0", 1.0), ("NO16.7", 1.0), ("P144", 100.0), ("P145", 90.0)];
        let found = corner(&both).unwrap();
        assert_eq!((found.angle, found.speed_difference, found.lowest_feed), (Some(100.0), None, 90.0));
        let found = corner(&[&both[..], &[("NO15.2", 1.0), ("P146", 300.0)]].concat()).unwrap();
        assert_eq!((found.angle, found.speed_difference), (None, Some(300.0)));
    }

    #[test]
    fn what_is_set_acts_and_what_is_not_is_the_machine_files() {
        let machine = |by: Option<bool>, set: &[(&str, f64)]| {
            let mut parameters = Parameters::new(ParameterTable::of("gsk990mc").unwrap());
            for (name, value) in set {
                parameters.set(&name.parse().unwrap(), *value).unwrap();
            }
            let mut machine = Machine::demo_mill();
            machine.servo.acceleration_by_parameters = by;
            machine_parameters(&parameters, &mut machine);
            machine
        };
        assert_eq!(Machine::demo_mill().servo.acceleration_by_parameters, None);
        let (of_file, untouched) = (machine(Some(false), &[]), machine(None, &[]));
        let shown = |machine: &Machine| format!("{:?} {:?}", machine.path, machine.axes);
        assert_eq!(shown(&untouched), shown(&of_file));
        // Positioning of all axes, and nothing of cutting.
        let set = [("NO16.1", 0.0), ("P105", 400.0), ("P88", 3000.0), ("P94", 6000.0)];
        let rapid = machine(None, &set);
        let x = rapid.axis(Axis::X).unwrap();
        assert_eq!((x.rapid, rapid.axis(Axis::Y).unwrap().rapid), (3000.0, 6000.0));
        close(x.before_rapid, 50.0 / 0.4, 0.0);
        assert_eq!(
            format!("{:?} {:?}", x.after_cutting, rapid.path),
            format!("{:?} {:?}", of_file.axes[0].after_cutting, of_file.path)
        );
        assert_eq!(machine(Some(false), &set).axis(Axis::X).unwrap().before_rapid, None);
        // Cutting, and nothing of positioning.
        let cutting = machine(None, &[("P127", 33.0)]);
        let x = cutting.axis(Axis::X).unwrap();
        assert_eq!((x.after_cutting, x.before_rapid), (Smoothing::Linear { time_ms: 33.0 }, None));
        assert!(machine(None, &[("P148", 500.0)]).path.arc.is_some_and(|arc| arc.acceleration == 500.0));
    }
}
