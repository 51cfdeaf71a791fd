//! What speed the spindle is told on a machine with a ladder (GSK990MC part 1, 5.1.1 and 6; part 2, 4.2).
//!
//! The NC knows the speed (S, surface speed, override, gears), the ladder says which way it turns and whether it
//! may. So M03 reaches the spindle by way of the ladder, as a key of the panel does.

use crate::signals::{Inputs, Outputs};
use crate::spindle::Spindle;
use ferrocut_geometry::{Position, Turn};
use ferrocut_machine::{GearConfig, Machine};
use ferrocut_toolpath::{Speed, SpindleState};

/// A spindle that is this near to the speed it was told has it, as a part of it.
const AT_SPEED: f64 = 0.02;

/// Slower than this it stands still, r/min.
const STANDSTILL_RPM: f64 = 0.5;

/// What the spindle does for the ladder.
#[derive(Clone, Copy, PartialEq, Debug)]
enum Doing {
    Stands,
    Turns,
    /// Comes to its angle, or holds it.
    Orients,
}

/// The way from S and the ladder to the spindle.
#[derive(Clone, Debug)]
pub struct SpindleControl {
    gears: GearConfig,
    max_rpm: f64,
    /// The speed of the program.
    speed: Speed,
    /// Angle of orientation, degrees, and the one that the spindle was told.
    angle: f64,
    oriented: f64,
    doing: Doing,
    /// The spindle is the NC's own: a thread is being tapped.
    taps: bool,
    /// Where G96 takes its radius from.
    surface_at: Position,
    /// Speed that the spindle was told, r/min.
    told: f64,
    gear: u8,
    /// The gear is to be chosen for a new speed.
    chooses: bool,
    /// It is to turn, whether it may or not.
    is_asked: bool,
}

impl SpindleControl {
    /// The spindle of a machine, at rest.
    pub fn new(machine: &Machine) -> SpindleControl {
        SpindleControl {
            gears: machine.spindle.gears.clone(),
            max_rpm: machine.spindle.max_rpm,
            speed: Speed::Rpm(0.0),
            angle: 0.0,
            doing: Doing::Stands,
            taps: false,
            surface_at: Position::ZERO,
            oriented: 0.0,
            told: 0.0,
            gear: 1,
            chooses: true,
            is_asked: false,
        }
    }

    /// The speed of the program from now on.
    pub fn set_speed(&mut self, speed: Speed) {
        self.speed = speed;
        self.chooses = true;
    }

    /// The angle of the next orientation, degrees.
    pub fn set_angle(&mut self, degrees: f64) {
        self.angle = degrees;
    }

    /// Which way the ladder lets the spindle turn.
    pub fn turns(&self, inputs: &Inputs) -> Option<Turn> {
        match (inputs.spindle_forward, inputs.spindle_reverse) {
            _ if !may_turn(inputs) || inputs.spindle_orient => None,
            (true, false) => Some(Turn::Clockwise),
            (false, true) => Some(Turn::CounterClockwise),
            _ => None,
        }
    }

    /// Whether cutting is to wait: the spindle is to turn and the ladder does not say that it has its speed.
    pub fn cutting_waits(&self, inputs: &Inputs) -> bool {
        self.gears.cutting_waits && self.is_asked && !inputs.spindle_at_speed
    }

    /// Goes on by a period. `taps`: the spindle belongs to a thread that is being tapped. `rapid_to`: the end of
    /// the positioning under way.
    pub fn tick(
        &mut self,
        inputs: &Inputs,
        taps: bool,
        at: &Position,
        rapid_to: Option<Position>,
        spindle: &mut Spindle,
    ) {
        self.surface_at = match rapid_to {
            Some(to) if !self.gears.surface_follows_rapid => to,
            _ => *at,
        };
        // Where the speed follows the axes (G96) no gear is shifted in a cut.
        if std::mem::take(&mut self.chooses) || self.gears.chosen_by_ladder {
            self.gear = self.gear(inputs);
        }
        let ended = std::mem::replace(&mut self.taps, taps) && !taps;
        if taps {
            return;
        }
        let may_turn = may_turn(inputs);
        if inputs.spindle_orient && may_turn {
            self.is_asked = false;
            if self.doing != Doing::Orients || ended || self.oriented != self.angle {
                (self.doing, self.told, self.oriented) = (Doing::Orients, 0.0, self.angle);
                spindle.orient(self.angle);
            }
            return;
        }
        let asked = self.rpm(inputs);
        self.is_asked = asked > 0.0 && inputs.spindle_forward != inputs.spindle_reverse;
        let rpm = if may_turn { asked } else { 0.0 };
        let state = match (inputs.spindle_forward, inputs.spindle_reverse) {
            (true, false) if rpm > 0.0 => SpindleState::Clockwise(Speed::Rpm(rpm)),
            (false, true) if rpm > 0.0 => SpindleState::CounterClockwise(Speed::Rpm(rpm)),
            _ => SpindleState::Off,
        };
        let doing = if state == SpindleState::Off { Doing::Stands } else { Doing::Turns };
        let told = match state {
            SpindleState::Off => 0.0,
            SpindleState::Clockwise(_) => rpm,
            SpindleState::CounterClockwise(_) => -rpm,
        };
        if doing != self.doing || told != self.told || ended {
            (self.doing, self.told) = (doing, told);
            spindle.command(state, at);
        }
    }

    /// The speed with its override within all limits, r/min.
    fn rpm(&self, inputs: &Inputs) -> f64 {
        let highest = self.highest();
        // GSK990MC part 2, 1.2.4.
        if inputs.spindle_jog && inputs.mode.is_manual() {
            return self.gears.jog_rpm.min(highest);
        }
        if self.gears.switched {
            // The number of a gear: its highest speed.
            return highest;
        }
        let factor = inputs.spindle_override.max(self.gears.least_override);
        let rpm = match self.speed {
            // 37#3: the clamp of G92 holds behind the override.
            Speed::Surface { mm_per_min, min_rpm, max_rpm, axis, center }
                if self.gears.clamped_behind_override =>
            {
                let unclamped = Speed::Surface { mm_per_min, min_rpm, max_rpm: None, axis, center };
                let wanted = match unclamped.rpm(&self.surface_at) {
                    // On the centre there is no speed but the highest.
                    0.0 if mm_per_min > 0.0 => max_rpm.unwrap_or(0.0),
                    rpm => rpm * factor,
                };
                wanted.min(max_rpm.unwrap_or(f64::MAX))
            }
            speed => speed.rpm(&self.surface_at) * factor,
        };
        rpm.min(highest)
    }

    /// Highest speed in the gear, r/min.
    fn highest(&self) -> f64 {
        let of_gear = usize::from(self.gear).checked_sub(1).and_then(|n| self.gears.max_rpm.get(n));
        match of_gear {
            Some(rpm) if *rpm > 0.0 => rpm.min(self.max_rpm),
            _ => self.max_rpm,
        }
    }

    /// The gear: what the ladder says, or what the speed needs. An S that is none leaves it.
    fn gear(&self, inputs: &Inputs) -> u8 {
        let kept = if self.gears.switched { self.gear } else { inputs.gear };
        self.gears.of_speed(self.speed.rpm(&self.surface_at)).unwrap_or(kept)
    }

    /// The gear that is engaged.
    pub fn engaged(&self) -> u8 {
        self.gear
    }

    /// Tells the ladder.
    pub fn tell(&self, inputs: &Inputs, spindle: &Spindle, outputs: &mut Outputs) {
        let rpm = spindle.actual_rpm();
        outputs.gear = if self.gears.chosen_by_ladder || self.gear > 3 { 0 } else { self.gear };
        outputs.spindle_enabled = self.told != 0.0;
        outputs.spindle_rpm = rpm.abs().round().clamp(0.0, 65_535.0) as u16;
        outputs.spindle_zero = !self.taps && rpm.abs() < STANDSTILL_RPM;
        let off = (rpm - self.told).abs();
        outputs.spindle_at_speed = self.doing == Doing::Turns && off <= AT_SPEED * self.told.abs();
        outputs.spindle_oriented = self.doing == Doing::Orients && !self.taps && spindle.is_oriented();
        outputs.surface_speed = matches!(self.speed, Speed::Surface { .. });
        outputs.rigid_tapping = inputs.rigid_tapping;
    }
}

/// Whether the ladder lets the spindle turn at all.
fn may_turn(inputs: &Inputs) -> bool {
    inputs.spindle_may_turn
        && inputs.spindle_drive_on
        && !inputs.spindle_emergency_stop
        && !inputs.emergency_stop
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::Control;
    use crate::signals::Mode;

    #[test]
    fn another_angle_is_come_to_while_the_ladder_still_asks_for_one() {
        let machine = Machine::demo_mill();
        let (mut control, mut spindle) = (SpindleControl::new(&machine), Spindle::new(&machine));
        let inputs =
            Inputs { spindle_orient: true, spindle_drive_on: true, ..Control::free_inputs(Mode::Auto) };
        for degrees in [90.0, 45.0, 0.0] {
            control.set_angle(degrees);
            for _ in 0..5000 {
                control.tick(&inputs, false, &Position::ZERO, None, &mut spindle);
                spindle.tick(0.001);
            }
            let off = spindle.encoder().turns.rem_euclid(1.0) * 360.0 - degrees;
            assert!(spindle.is_oriented() && off.abs() < 0.5, "{degrees}: {off}");
        }
    }
}
