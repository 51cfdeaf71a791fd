//! Parameters that are other names of what the interpreter and the machine know, by number and by name
//! (LinuxCNC, numbered parameters and predefined named parameters).

use super::coordinates::{SYSTEMS, system_name};
use crate::dialect::Meaning;
use crate::interpreter::Interpreter;
use crate::modal::Group;
use ferrocut_geometry::{Axis, Position};
use ferrocut_toolpath::SpindleState;

/// The coordinate system in force.
pub(super) const SYSTEM: u32 = 5220;

/// Whether the shift of G92 is in force.
pub(super) const SHIFT_IN_FORCE: u32 = 5210;

/// The shift of G92 of X, and of the other axes behind it.
pub(super) const FIRST_SHIFT: u32 = 5211;

/// Whether `(debug,…)` is shown.
pub(super) const SHOWS_DEBUG: u32 = 5599;

/// First parameter of G54, and how far those of the next system are away.
const FIRST_ZERO: u32 = 5221;
const SYSTEM_STEP: u32 = 20;

/// From here on numbers may be other names.
pub(super) const FIRST_SYSTEM_PARAMETER: u32 = 5161;

/// Parameters that a program cannot set.
pub(super) const READ_ONLY: std::ops::RangeInclusive<u32> = 5400..=5428;

/// The parameter of the turn of a coordinate system.
pub(super) fn turn_of_system(number: u8) -> u32 {
    FIRST_ZERO + 9 + SYSTEM_STEP * u32::from(number.saturating_sub(1))
}

/// The axis of the nth parameter of a row of nine.
fn axis(n: u32) -> Option<Axis> {
    Axis::ALL.into_iter().find(|axis| axis.index() as u32 == n)
}

impl Interpreter {
    /// A length of the machine, in mm, or an angle in degrees, in units of the program.
    fn in_units(&self, axis: Axis, value: f64) -> f64 {
        if axis.is_linear() { value / self.ngc_unit() } else { value }
    }

    /// The value of a parameter from [`FIRST_SYSTEM_PARAMETER`] on; none where it is one like others.
    pub(super) fn ngc_system_parameter(&self, number: u32) -> Option<f64> {
        let reference = |place: usize, first: u32| {
            let point = self.memory.reference_points.get(place)?;
            Some(point[axis(number - first)?])
        };
        match number {
            5161..=5169 => reference(0, 5161),
            5181..=5189 => reference(1, 5181),
            SYSTEM => Some(f64::from(self.ngc.system)),
            FIRST_ZERO..=5389 => {
                let (system, place) =
                    ((number - FIRST_ZERO) / SYSTEM_STEP, (number - FIRST_ZERO) % SYSTEM_STEP);
                let zero = self.memory.work.get(system_name(u8::try_from(system).ok()? + 1))?;
                Some(zero[axis(place)?])
            }
            5400 => Some(f64::from(self.technology.in_spindle)),
            5401..=5409 => Some(self.ngc_loaded().length[axis(number - 5401)?]),
            5410 => Some(self.ngc_loaded().diameter),
            5411 => Some(self.ngc_loaded().front_angle),
            5412 => Some(self.ngc_loaded().back_angle),
            5413 => Some(f64::from(self.ngc_loaded().orientation)),
            5420..=5428 => {
                let axis = axis(number - 5420)?;
                Some(self.in_units(axis, self.ngc.at[axis]))
            }
            SHOWS_DEBUG => Some(self.memory.variables.get(number).unwrap_or(1.0)),
            _ => None,
        }
    }

    /// Sets what a parameter is another name of.
    pub(super) fn ngc_set_system_parameter(&mut self, number: u32, value: f64) {
        match number {
            5161..=5169 | 5181..=5189 => {
                let (place, first) = if number < 5181 { (0, 5161) } else { (1, 5181) };
                if let (Some(point), Some(axis)) =
                    (self.memory.reference_points.get_mut(place), axis(number - first))
                {
                    point[axis] = value;
                }
            }
            FIRST_ZERO..=5389 => {
                let (system, place) =
                    ((number - FIRST_ZERO) / SYSTEM_STEP, (number - FIRST_ZERO) % SYSTEM_STEP);
                let number = u8::try_from(system).map_or(SYSTEMS, |n| n + 1);
                if let (Some(zero), Some(axis)) = (self.memory.work.get_mut(system_name(number)), axis(place))
                {
                    zero[axis] = value;
                }
            }
            _ => {}
        }
    }

    /// The value of a parameter with a name of the language.
    pub(super) fn ngc_predefined(&self, name: &str) -> Option<f64> {
        let modal = |group: Group| self.modal.code(group).map_or(0.0, |row| f64::from(row.tenths));
        let means = |group: Group, meaning: Meaning| truth(self.modal.meaning(group) == meaning);
        let technology = &self.technology;
        let tool = |number: u32| self.ngc_tool(number).map_or(0.0, |tool| f64::from(tool.pocket));
        Some(match name {
            // Version 2.9 is what this follows.
            "_vmajor" => 2.9,
            "_vminor" | "_task" | "_remap_level" => 0.0,
            "_line" => f64::from(self.words.block_span().line),
            "_motion_mode" => modal(Group::Motion),
            "_plane" => modal(Group::Plane),
            "_ccomp" => modal(Group::Cutter),
            "_metric" => means(Group::Units, Meaning::Metric),
            "_imperial" => means(Group::Units, Meaning::Inch),
            "_absolute" => means(Group::Distance, Meaning::Absolute),
            "_incremental" => means(Group::Distance, Meaning::Incremental),
            "_inverse_time" => means(Group::FeedMode, Meaning::InverseTime),
            "_units_per_minute" => means(Group::FeedMode, Meaning::FeedPerMinute),
            "_units_per_rev" => means(Group::FeedMode, Meaning::FeedPerRevolution),
            "_coord_system" => modal(Group::WorkOffset),
            "_tool_offset" => truth(self.ngc.length != Position::ZERO),
            "_retract_r_plane" => means(Group::Return, Meaning::ReturnR),
            "_retract_old_z" => means(Group::Return, Meaning::ReturnInitial),
            "_spindle_rpm_mode" => means(Group::SurfaceSpeed, Meaning::SpindleSpeed),
            "_spindle_css_mode" => means(Group::SurfaceSpeed, Meaning::SurfaceSpeed),
            "_ijk_absolute_mode" => means(Group::CentreDistance, Meaning::CentreAbsolute),
            "_lathe_diameter_mode" => means(Group::Diameter, Meaning::DiameterMode),
            "_lathe_radius_mode" => means(Group::Diameter, Meaning::RadiusMode),
            "_spindle_on" => truth(technology.spindle != SpindleState::Off),
            "_spindle_cw" => truth(matches!(technology.spindle, SpindleState::Clockwise(_))),
            "_mist" => truth(self.ngc.mist),
            "_flood" => truth(technology.coolant),
            "_speed_override" => truth(self.ngc.overrides.speed),
            "_feed_override" => truth(self.ngc.overrides.feed),
            "_adaptive_feed" => truth(self.ngc.overrides.adaptive),
            "_feed_hold" => truth(self.ngc.overrides.hold),
            "_feed" => self.ngc.feed,
            "_rpm" => technology.speed.unwrap_or(0.0),
            "_current_tool" => f64::from(technology.in_spindle),
            "_selected_tool" => f64::from(technology.tool),
            "_current_pocket" => tool(technology.in_spindle),
            "_selected_pocket" => tool(technology.tool),
            "_value" => self.ngc.returned.unwrap_or(0.0),
            "_value_returned" => truth(self.ngc.returned.is_some()),
            "_call_level" => self.ngc.o_words.depth() as f64,
            _ => return self.predefined_position(name),
        })
    }

    /// `_x` and others: the programmed point; `_abs_x`: that of the machine.
    fn predefined_position(&self, name: &str) -> Option<f64> {
        let letter = |text: &str| match text.as_bytes() {
            [letter] => Axis::from_letter(letter.to_ascii_uppercase()),
            _ => None,
        };
        if let Some(axis) = name.strip_prefix("_abs_").and_then(letter) {
            return Some(self.in_units(axis, self.location.machine[axis]));
        }
        let axis = name.strip_prefix('_').and_then(letter)?;
        Some(self.in_units(axis, self.ngc.at[axis]))
    }
}

fn truth(condition: bool) -> f64 {
    f64::from(u8::from(condition))
}
