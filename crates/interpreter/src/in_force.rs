//! What is in force behind the blocks that were run, for whoever shows it.

use crate::dialect::{Dialect, Meaning};
use crate::dialects::rs274::system_name;
use crate::interpreter::{Interpreter, Location, Technology};
use crate::modal::{Group, Modal};
use crate::stages::units;
use ferrocut_geometry::Position;
use ferrocut_machine::WorkOffset;
use ferrocut_toolpath::SpindleState;

/// Words in force.
#[derive(Clone, Copy, PartialEq, Debug)]
pub struct InForce {
    /// What the spindle was told.
    pub spindle: SpindleState,
    /// S, r/min.
    pub speed: f64,
    /// F, in units of the program; per minute, per revolution or inverse time as its code says.
    pub feed: f64,
    /// T.
    pub tool: u32,
    /// M08.
    pub flood: bool,
    /// M07.
    pub mist: bool,
    /// Machine position of the programmed zero: coordinate system, shifts and tool length.
    pub zero: Position,
    /// Tool length in force along the axes, mm.
    pub length: Position,
    /// G92 and G52 of RS274/NGC, mm.
    pub shift: Position,
    /// Machine position where the last probe of RS274/NGC ended, and whether it found something.
    pub probed: Option<(Position, bool)>,
}

/// What a page shows as in force (GSK990MC part 2, 3.1.2).
#[derive(Clone, Copy, Debug)]
pub struct Shown {
    modal: Modal,
    /// The last F word, mm/min.
    pub feed: f64,
    /// S as it was programmed: r/min, or under G96 the surface speed in mm/min or inch/min.
    pub speed: f64,
    /// Number of the tool length in force.
    pub h: u16,
    /// Number of the cutter radius in force.
    pub d: f64,
    /// Number of the tool length that is compensated (G43, G44).
    pub length: Option<u16>,
    /// Number of the cutter radius that is compensated (G41, G42).
    pub radius: Option<f64>,
    /// The tool in the spindle.
    pub tool: u32,
    /// The tool that was called last.
    pub called_tool: u32,
    /// The work coordinate system; none for one that the program made.
    pub system: Option<WorkOffset>,
}

impl Shown {
    pub(crate) fn new(
        dialect: &Dialect,
        modal: &Modal,
        location: &Location,
        technology: &Technology,
    ) -> Shown {
        let is_ngc = dialect.blocks.is_some();
        let is_surface = modal.meaning(Group::SurfaceSpeed) == Meaning::SurfaceSpeed;
        Shown {
            modal: *modal,
            feed: technology.feed_per_minute,
            speed: match is_surface {
                true => technology.surface_speed.unwrap_or(0.0) / units::length_mm(1.0, modal.is_inch()),
                false => technology.speed.unwrap_or(0.0),
            },
            h: location.length.number,
            d: technology.radius_number,
            length: (modal.meaning(Group::Length) != Meaning::LengthOff).then_some(location.length.number),
            radius: (modal.meaning(Group::Cutter) != Meaning::CutterOff).then_some(technology.radius_number),
            tool: technology.in_spindle,
            called_tool: technology.tool,
            // RS274/NGC has its systems for itself.
            system: match modal.meaning(Group::WorkOffset) {
                Meaning::WorkOffset(number) if is_ngc => Some(system_name(number)),
                _ => location.system(),
            },
        }
    }

    /// The G codes, in tenths, by the order of groups.
    pub fn g_codes(&self) -> impl Iterator<Item = u16> {
        self.modal.codes().map(|code| code.tenths)
    }
}

impl Interpreter {
    /// What is in force behind the blocks that were read.
    pub fn shown(&self) -> Shown {
        Shown::new(self.dialect, &self.modal, &self.location, &self.technology)
    }

    /// Words in force behind the blocks that were run. G codes are [`codes_in_force`](Self::codes_in_force).
    pub fn words_in_force(&self) -> InForce {
        let technology = &self.technology;
        let is_ngc = self.dialect.blocks.is_some();
        let per_revolution = self.modal.is_feed_per_revolution();
        InForce {
            spindle: technology.spindle,
            speed: technology.speed.unwrap_or(0.0),
            feed: match (is_ngc, per_revolution) {
                (true, _) => self.ngc.feed,
                (false, true) => technology.feed_per_revolution,
                (false, false) => technology.feed_per_minute,
            },
            tool: technology.tool,
            flood: technology.coolant,
            mist: self.ngc.mist,
            zero: match is_ngc {
                true => self.ngc.machine_of(Position::ZERO),
                false => self.location.machine_of(Position::ZERO),
            },
            length: if is_ngc { self.ngc.length } else { self.location.length.vector },
            shift: if is_ngc { self.ngc.shift } else { Position::ZERO },
            probed: self.ngc.probed,
        }
    }
}
