//! What the parameters say of the drives: backlash, pitch errors, following error, the spindle's encoder (appendix 1).
//!
//! P201 chooses among modes A, B and C of backlash compensation, of which nothing but the letters is printed; it
//! is kept. What P201 to P235 do is otherwise what their names say, and Fanuc 0i-M where they say no more.

use super::acceleration;
use ferrocut_machine::config::{SpindleConfig, TappingGear};
use ferrocut_machine::manual::ManualConfig;
use ferrocut_machine::restart::RestartConfig;
use ferrocut_machine::{
    AxisConfig, AxisHoming, DrivesConfig, GearConfig, HomingConfig, Machine, ParameterKey, Parameters,
};

/// An encoder counts both edges of both of its tracks.
const COUNTS_A_LINE: f64 = 4.0;

/// A manual rapid speed of 0 is one that does not move, mm/min.
const LEAST_SPEED: f64 = 1e-3;

/// P189 counts ten-thousandths.
const REVERSAL_UNIT: f64 = 1e-4;

/// Writes the parameters over what the machine file says of path and axes.
pub fn machine_parameters(parameters: &Parameters, machine: &mut Machine) {
    spindle(parameters, &mut machine.spindle);
    // P202.
    machine.handshake.finish_width_ms = parameters.data(202).max(0.0);
    manual(parameters, &mut machine.manual);
    acceleration::machine_parameters(parameters, machine);
    let period = machine.servo_period_ms;
    homing(parameters, &mut machine.homing);
    restart(parameters, &mut machine.restart);
    probe(parameters, machine);
    for (k, name) in (0u8..).zip(parameters.axis_names()) {
        let Some(axis) = machine.axes.iter_mut().find(|axis| axis.name == name) else { continue };
        backlash(parameters, k, axis, period);
        // P170 to P174.
        axis.manual_rapid = Some(parameters.data(170 + u16::from(k)).max(LEAST_SPEED));
        axis.homing = axis_homing(parameters, k);
        pitch_errors(parameters, k, axis);
        // 17#7, P131; in look-ahead 15#3, P141.
        let (is_checked, window) =
            if parameters.bit(15, 0) { (parameters.bit(15, 3), 141) } else { (parameters.bit(17, 7), 131) };
        if axis.in_position_cutting.is_none() && is_checked {
            axis.in_position_cutting = Some(parameters.data(window));
        }
        // 3.3.5: P445, 50 mm as delivered.
        if axis.following_error == 0.0 {
            axis.following_error = parameters.data(445).max(0.0);
        }
    }
}

/// 4#7: SKIP is given while its input is 0, or while it is 1. A machine file that says how the probe is wired is right.
fn probe(parameters: &Parameters, machine: &mut Machine) {
    let opens = !parameters.bit(4, 7);
    if let Some(plant) = &mut machine.plant {
        plant.probe_opens.get_or_insert(opens);
    }
    if let Some(DrivesConfig::Pulse(board)) = &mut machine.drives {
        board.probe_opens.get_or_insert(opens);
    }
}

/// P93, P98, P151, P155 and bits 12#4, 56#0, 56#7: moving by hand (part 2, 4.1, 5.1.3, 6.1.3).
fn manual(parameters: &Parameters, manual: &mut ManualConfig) {
    let p = |number: u16| parameters.data(number).max(0.0);
    (manual.jog, manual.step) = (p(98), p(155));
    manual.handwheel_keeps = parameters.bit(56, 0);
    // P151 holds where counts may be lost; else the axis may follow as fast as it can.
    manual.handwheel = if manual.handwheel_keeps { f64::INFINITY } else { p(151) };
    manual.handwheel_reversed = !parameters.bit(56, 7);
    manual.rapid_f0 = if parameters.bit(12, 4) { 0.0 } else { p(93) };
}

/// Bits of 5, 6, 11, 12, 14 and 20: machine zero return (part 2, chapter 9). Of 5#4 and 6#4 the manual has the names:
/// high-speed return is that of the Fanuc 0i, to a point that is known and without its switch; what is remembered is
/// known from then on (14#1), through power-off too.
fn homing(parameters: &Parameters, homing: &mut HomingConfig) {
    let bit = |number, bit| parameters.bit(number, bit);
    (homing.marker, homing.before, homing.twice) = (bit(6, 6), bit(6, 1), bit(6, 7));
    homing.one_at_a_time = bit(6, 2);
    homing.remembers = bit(6, 4);
    homing.known_at_rapid = bit(5, 4) || bit(6, 4);
    homing.at_manual_rapid = bit(14, 1);
    homing.absolute = bit(20, 6);
    homing.limits_before = bit(11, 6);
    homing.rapid_before = bit(12, 0);
    homing.ignores_switches = bit(61, 6);
    // Fanuc 3006#0 (GDC): *DEC at G196 instead of X9.
    homing.through_ladder = bit(6, 5);
    (homing.needed, homing.not_by_program) = (bit(6, 0), bit(6, 3));
}

/// P99 to P104, P180 to P183, P342 to P346 and bits of 2 and 7 of axis `k`.
fn axis_homing(parameters: &Parameters, k: u8) -> AxisHoming {
    let of_axis = |first: u16| parameters.data(first + u16::from(k));
    AxisHoming {
        fast: of_axis(100).max(LEAST_SPEED),
        slow: of_axis(342).max(LEAST_SPEED),
        search: parameters.data(99).max(LEAST_SPEED),
        negative: parameters.bit(7, k),
        closes: parameters.bit(2, k),
        // Upwards, as Fanuc 1850; P184 is no fifth of them.
        shift: if k < 4 { of_axis(180) } else { 0.0 },
    }
}

/// P86, P376 and bit 49#0: the way to a restart (part 2, 10.1.9). The digits of P376 are the axes by their numbers,
/// the first to move first; 0 is none.
fn restart(parameters: &Parameters, restart: &mut RestartConfig) {
    let (axes, digits) = (parameters.axis_names(), parameters.data(376).max(0.0) as u32);
    let digit = |place: u32| (digits / 10u32.pow(place) % 10) as usize;
    let named = (0..5).rev().map(digit).filter(|digit| *digit > 0);
    restart.order = named.filter_map(|number| axes.get(number - 1).copied()).collect();
    // One that names no axis is refused, and not as none given.
    if restart.order.is_empty() {
        restart.order = axes.iter().take(1).copied().collect();
    }
    restart.speed = parameters.data(86).max(0.0);
    restart.cuts_z = parameters.bit(49, 0);
}

/// P261, P286 to P305 and bits 38#6, 38#7, 44#1, 45#2: encoder of the spindle, and rigid tapping in each gear.
fn spindle(parameters: &Parameters, spindle: &mut SpindleConfig) {
    spindle.tapping = (0..4).map(|gear| tapping(parameters, gear, spindle)).collect();
    if let Some(first) = spindle.tapping.first() {
        spindle.encoder_counts = first.encoder_counts;
        [spindle.tapping_rpm_s, spindle.tapping_retract_rpm_s] = first.rpm_s;
    }
    gears(parameters, &mut spindle.gears);
}

/// Rigid tapping in a gear, counted from 0.
fn tapping(parameters: &Parameters, gear: u16, spindle: &SpindleConfig) -> TappingGear {
    let p = |first: u16| parameters.data(first + gear);
    // Turns of the encoder in one of the spindle.
    let ratio = match parameters.bit(44, 1) {
        true => p(286) / p(290),
        false => f64::from(1 << (u8::from(parameters.bit(38, 6)) + 2 * u8::from(parameters.bit(38, 7)))),
    };
    let counts = COUNTS_A_LINE * parameters.data(261) * ratio;
    // The time constant leads to the highest speed of the gear (Fanuc 5241, 5261). 45#2: one for both ways.
    let (inwards, outwards) = (p(298), if parameters.bit(45, 2) { p(298) } else { p(302) });
    let rate = |ms: f64| if ms > 0.0 && p(294) > 0.0 { p(294) / ms * 1000.0 } else { f64::INFINITY };
    TappingGear {
        max_rpm: p(294),
        encoder_counts: if counts.is_finite() && counts >= 1.0 { counts } else { spindle.encoder_counts },
        rpm_s: [spindle.tapping_rpm_s.min(rate(inwards)), spindle.tapping_retract_rpm_s.min(rate(outwards))],
    }
}

/// P242, P246 to P249, P262 and bits 1#2, 37#2, 37#3, 38#0, 38#5 (part 2, 4.2.4; part 1, 6.1 to 6.3). Where the machine
/// file says how fast the gears are, those of P246 to P249 that nobody has set leave it.
fn gears(parameters: &Parameters, gears: &mut GearConfig) {
    let is_of_file = gears.max_rpm.iter().any(|rpm| *rpm > 0.0);
    for (number, max_rpm) in (246..).zip(&mut gears.max_rpm) {
        if !is_of_file || parameters.is_given(&ParameterKey::Data(number)) {
            *max_rpm = parameters.data(number).max(0.0);
        }
    }
    gears.chosen_by_ladder = parameters.bit(38, 5);
    gears.switched = parameters.bit(1, 2);
    gears.jog_rpm = parameters.data(242).max(0.0);
    gears.least_override = parameters.data(262).clamp(0.0, 1.0);
    gears.cutting_waits = parameters.bit(38, 0);
    gears.clamped_behind_override = parameters.bit(37, 3);
    gears.surface_follows_rapid = parameters.bit(37, 2);
}

/// P190 to P200 and P231 to P235 of axis `k`, bits 18#0, 18#6, 18#7; an axis for which they are 0 has what the
/// machine file says.
fn backlash(parameters: &Parameters, k: u8, axis: &mut AxisConfig, period_ms: f64) {
    let of_axis = |first: u16| parameters.data(first + u16::from(k));
    let cutting = of_axis(190);
    let rapid = parameters.bit(18, 6).then(|| of_axis(231));
    if cutting == 0.0 && rapid.unwrap_or(0.0) == 0.0 {
        return;
    }
    let play = &mut axis.backlash;
    (play.cutting, play.rapid) = (cutting, rapid);
    // A step of P195 to P199 in each servo period.
    let step = of_axis(195);
    play.rate = if parameters.bit(18, 7) { 0.0 } else { step / period_ms * 60_000.0 };
    play.time_ms = parameters.data(200);
    play.reversal_step = parameters.data(189) * REVERSAL_UNIT;
    // Printed for Z; without it a reversal at creeping speed would never be compensated on the others.
    play.reversal_way = parameters.data(188);
    play.homes_negative = parameters.bit(7, k);
    // Bit 18#0 and the tolerance of P371 to P375.
    play.waits = parameters.bit(18, 0) && cutting.abs() > of_axis(371);
}

/// Bits 37#0 and 37#1, P216 to P230 of axis `k`, for a table that does not say itself where it lies.
fn pitch_errors(parameters: &Parameters, k: u8, axis: &mut AxisConfig) {
    let Some(table) = axis.pitch_errors.as_mut().filter(|t| t.start.is_none() || t.interval.is_none()) else {
        return;
    };
    let of_axis = |first: u16| parameters.data(first + u16::from(k));
    let interval = of_axis(226);
    if !parameters.bit(37, 0) || interval <= 0.0 {
        axis.pitch_errors = None;
        return;
    }
    // P45 to P49: the reference point, which has the number of P216 to P220.
    let number = of_axis(216);
    table.start = Some(of_axis(45) - number * interval);
    table.interval = Some(interval);
    if !parameters.bit(37, 1) {
        table.opposite.clear();
    } else if table.opposite.is_empty() {
        // P221 to P225: the value at the reference point coming from the other direction. Without a table of
        // that direction the one there is goes through it.
        let last = table.corrections.len().saturating_sub(1);
        let at_reference = table.corrections.get((number as usize).min(last)).copied().unwrap_or(0.0);
        let shift = of_axis(221) - at_reference;
        table.opposite = table.corrections.iter().map(|c| c + shift).collect();
        if parameters.bit(7, k) {
            // The one there is belongs to the homing direction, here the negative one.
            std::mem::swap(&mut table.corrections, &mut table.opposite);
        }
    }
}

#[cfg(test)]
mod tests {
    use super::*;
    use ferrocut_geometry::Axis;
    use ferrocut_machine::{ParameterTable, PathConfig, PitchErrors};

    /// The demo mill with parameters set.
    fn machine(set: &[(&str, f64)], change: impl Fn(&mut Machine)) -> Machine {
        let mut parameters = Parameters::new(ParameterTable::of("gsk990mc").unwrap());
        for (name, value) in set {
            parameters.set(&name.parse().unwrap(), *value).unwrap();
        }
        let mut machine = Machine::demo_mill();
        change(&mut machine);
        machine_parameters(&parameters, &mut machine);
        machine
    }

    #[test]
    fn as_delivered_nothing_is_compensated_or_smoothed() {
        let (machine, demo) = (machine(&[], |_| {}), Machine::demo_mill());
        for (axis, before) in machine.axes.iter().zip(&demo.axes) {
            assert_eq!(axis.backlash, before.backlash);
            assert_eq!((&axis.pitch_errors, axis.smoothing()), (&None, before.smoothing()));
            assert_eq!((axis.in_position, axis.in_position_cutting), (0.0, Some(0.03)));
            assert_eq!(axis.following_error, 50.0);
        }
        // The clamp of feeds aside, which is no compensation.
        let feeds = (machine.path.lowest_feed, machine.path.highest_feed);
        assert_eq!(feeds, (0.0, Some(6000.0)));
        let (lowest_feed, highest_feed) = feeds;
        assert_eq!(machine.path, PathConfig { lowest_feed, highest_feed, ..demo.path });
    }

    #[test]
    fn look_ahead_has_a_window_of_its_own_for_cutting() {
        let window = |set: &[(&str, f64)]| machine(set, |_| {}).axes[0].in_position_cutting;
        assert_eq!(window(&[("P131", 0.1)]), Some(0.1));
        assert_eq!(window(&[("NO17.7", 0.0)]), None);
        assert_eq!(window(&[("NO15.0", 1.0)]), None);
        assert_eq!(window(&[("NO15.0", 1.0), ("NO15.3", 1.0), ("P141", 0.2)]), Some(0.2));
    }

    #[test]
    fn the_way_to_a_restart_is_read() {
        let restart = |set: &[(&str, f64)]| {
            let machine = machine(set, |_| {});
            let order = machine.restart.order_of(&machine).unwrap_or_default();
            (
                order.iter().map(|a| a.letter()).collect::<String>(),
                machine.restart.speed,
                machine.restart.cuts_z,
            )
        };
        // As delivered X Y Z A, at the speed of dry run, Z positioned.
        assert_eq!(restart(&[]), ("XYZA".to_owned(), 5000.0, false));
        assert_eq!(
            restart(&[("P376", 31245.0), ("P86", 800.0), ("NO49.0", 1.0)]),
            ("ZXYA".to_owned(), 800.0, true)
        );
        assert_eq!(restart(&[("P376", 42301.0)]).0, "AYZX");
        // Each axis once: else it is alarm 0236.
        for wrong in [0.0, 123.0, 11345.0, 45.0, 99999.0] {
            assert_eq!(restart(&[("P376", wrong)]).0, "", "{wrong}");
        }
    }

    #[test]
    fn backlash_is_read_by_axis() {
        let set = [("P191", 0.012), ("P232", 0.02), ("NO18.6", 1.0), ("P196", 0.002), ("NO7.1", 1.0)];
        let fixed = machine(&set, |machine| machine.servo_period_ms = 2.0);
        let play = &fixed.axis(Axis::Y).unwrap().backlash;
        // 0.002 mm in 2 ms is 60 mm/min.
        assert_eq!(
            (play.cutting, play.rapid, play.rate, play.homes_negative),
            (0.012, Some(0.02), 60.0, true)
        );
        assert!((play.reversal_step - 1e-6).abs() < 1e-18 && play.reversal_way == 0.02 && !play.waits);
        assert_eq!(fixed.axis(Axis::X).unwrap().backlash, Default::default());
        // 18#0 waits where the value is above the tolerance of P371 to P375, 0.015 as delivered.
        for (value, waits) in [(0.012, false), (0.016, true), (-0.016, true)] {
            let machine =
                machine(&[("P190", value), ("NO18.0", 1.0), ("NO18.7", 1.0), ("P200", 30.0)], |_| {});
            let play = &machine.axis(Axis::X).unwrap().backlash;
            assert_eq!((play.waits, play.rate, play.time_ms, play.rapid), (waits, 0.0, 30.0, None));
        }
    }

    #[test]
    fn pitch_tables_lie_where_the_parameters_say() {
        let table = PitchErrors { corrections: vec![0.0, 0.01, 0.03], ..PitchErrors::default() };
        let with = |set: &[(&str, f64)]| {
            let machine = machine(set, |machine| machine.axes[2].pitch_errors = Some(table.clone()));
            machine.axis(Axis::Z).unwrap().pitch_errors.clone()
        };
        assert_eq!(with(&[]), None);
        let set = [("NO37.0", 1.0), ("P218", 2.0), ("P228", 50.0), ("P47", 10.0)];
        let found = with(&set).unwrap();
        // Point 2 at the reference point 10, every 50.
        assert_eq!((found.start, found.interval, found.opposite.len()), (Some(-90.0), Some(50.0), 0));
        let both = with(&[&set[..], &[("NO37.1", 1.0), ("P223", 0.05)]].concat()).unwrap();
        let close = |a: &[f64], b: &[f64]| a.iter().zip(b).all(|(a, b)| (a - b).abs() < 1e-12);
        assert!(close(&both.opposite, &[0.02, 0.03, 0.05]) && both.corrections == table.corrections);
        let negative =
            with(&[&set[..], &[("NO37.1", 1.0), ("P223", 0.05), ("NO7.2", 1.0)]].concat()).unwrap();
        assert_eq!(negative.opposite, table.corrections);
    }

    #[test]
    fn homing_is_what_bits_and_speeds_say() {
        let delivered = machine(&[], |_| {});
        let homing = &delivered.homing;
        // 6 = 1110 0000.
        assert!(homing.marker && homing.twice && !homing.before && !homing.remembers && !homing.needed);
        let y = &delivered.axis(Axis::Y).unwrap().homing;
        assert_eq!((y.fast, y.slow, y.search, y.negative, y.closes), (4000.0, 200.0, 40.0, false, false));
        let set = [("NO6.6", 0.0), ("NO6.1", 1.0), ("NO6.7", 0.0), ("NO6.2", 1.0), ("NO6.4", 1.0)];
        let homing = machine(&set, |_| {}).homing;
        assert!(!homing.marker && homing.before && !homing.twice && homing.one_at_a_time);
        assert!(homing.remembers && homing.known_at_rapid && !homing.at_manual_rapid);
        let set = [("NO5.4", 1.0), ("NO14.1", 1.0), ("NO20.6", 1.0), ("NO11.6", 1.0), ("NO12.0", 1.0)];
        let homing = machine(&set, |_| {}).homing;
        assert!(homing.known_at_rapid && !homing.remembers && homing.at_manual_rapid && homing.absolute);
        assert!(homing.limits_before && homing.rapid_before);
        let set =
            [("NO7.1", 1.0), ("NO2.1", 1.0), ("P101", 3000.0), ("P343", 150.0), ("P99", 30.0), ("P181", 2.5)];
        let set = [&set[..], &[("NO6.0", 1.0), ("NO6.3", 1.0)]].concat();
        let found = machine(&set, |_| {});
        let y =
            AxisHoming { fast: 3000.0, slow: 150.0, search: 30.0, negative: true, closes: true, shift: 2.5 };
        assert_eq!(found.axis(Axis::Y).unwrap().homing, y);
        let x = AxisHoming { search: 30.0, ..AxisHoming::default() };
        assert_eq!(found.axis(Axis::X).unwrap().homing, x);
        assert!(found.homing.needed && found.homing.not_by_program);
    }

    #[test]
    fn gears_are_as_fast_as_the_machine_file_says_until_a_parameter_is_set() {
        let gears = |of_file: [f64; 4], set: &[(&str, f64)]| {
            machine(set, |machine| machine.spindle.gears.max_rpm = of_file).spindle.gears.max_rpm
        };
        assert_eq!(gears([0.0; 4], &[]), [6000.0; 4]);
        assert_eq!(gears([0.0; 4], &[("P247", 2000.0)]), [6000.0, 2000.0, 6000.0, 6000.0]);
        let of_file = [500.0, 2000.0, 5000.0, 0.0];
        assert_eq!(gears(of_file, &[]), of_file);
        assert_eq!(gears(of_file, &[("P247", 1800.0)]), [500.0, 1800.0, 5000.0, 0.0]);
    }

    #[test]
    fn the_spindle_has_an_encoder_and_a_time_constant_for_tapping() {
        let spindle = |set: &[(&str, f64)]| machine(set, |_| {}).spindle;
        // 1024 lines, 1:1; 6000 r/min in 200 ms are more than the spindle does.
        let found = spindle(&[]);
        assert_eq!((found.encoder_counts, found.tapping_rpm_s, found.acceleration_rpm_s), (4096.0, 3e4, 4e3));
        let set = [("P261", 2500.0), ("NO38.7", 1.0), ("P298", 4000.0), ("P302", 6000.0), ("P294", 3000.0)];
        let found = spindle(&set);
        assert_eq!((found.encoder_counts, found.tapping_rpm_s), (40_000.0, 750.0));
        assert_eq!(found.tapping_retract_rpm_s, 500.0);
        let found = spindle(&[&set[..], &[("NO45.2", 1.0), ("NO44.1", 1.0), ("P286", 2.0)]].concat());
        assert_eq!((found.encoder_counts, found.tapping_retract_rpm_s), (20_000.0, 750.0));
        // 38#7 and 38#6: 1:1, 2:1, 4:1, 8:1; with 44#1 the teeth count alone.
        for (high, low, ratio) in [(0.0, 0.0, 1.0), (0.0, 1.0, 2.0), (1.0, 0.0, 4.0), (1.0, 1.0, 8.0)] {
            let bits = [("NO38.7", high), ("NO38.6", low)];
            assert_eq!(spindle(&bits).encoder_counts, ratio * 4096.0, "{bits:?}");
            let teeth = [&bits[..], &[("NO44.1", 1.0), ("P286", 3.0)]].concat();
            assert_eq!(spindle(&teeth).encoder_counts, 3.0 * 4096.0, "{bits:?}");
        }
        assert_eq!(spindle(&[("P261", 0.0), ("P298", 0.0)]).encoder_counts, 4096.0);
        assert_eq!(spindle(&[("P298", 0.0)]).tapping_rpm_s, f64::INFINITY);
    }
}
