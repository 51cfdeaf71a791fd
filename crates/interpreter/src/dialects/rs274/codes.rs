//! Tables of G codes, M codes and addresses (LinuxCNC, G-code overview, modal groups).

use crate::cycles::{CycleKind, HoleCycle, Peck, Retract};
use crate::dialect::{Address, GCode, MCode, MFunction, Meaning, g};
use crate::dialects::fanuc::signed;
use crate::modal::Group;
use ferrocut_geometry::Plane;

/// G80.
pub static CYCLE_OFF: GCode = g(800, Meaning::CycleOff, Group::Motion, 1);

/// G49.
pub static LENGTH_OFF: GCode = g(490, Meaning::LengthOff, Group::Length, 8);

/// A code of its block alone. Of these, too, a block takes but one.
const fn once(tenths: u16, meaning: Meaning) -> GCode {
    g(tenths, meaning, Group::NonModal, 0)
}

const fn motion(tenths: u16, meaning: Meaning) -> GCode {
    g(tenths, meaning, Group::Motion, 1)
}

const fn hole(tenths: u16, peck: Peck, dwell: bool, retract: Retract) -> GCode {
    motion(tenths, Meaning::Cycle(CycleKind::Hole(HoleCycle { peck, dwell, retract })))
}

const fn system(tenths: u16, number: u8) -> GCode {
    g(tenths, Meaning::WorkOffset(number), Group::WorkOffset, 12)
}

/// The codes with the numbers of their groups, in rising order.
pub static G_CODES: &[GCode] = &[
    motion(0, Meaning::Rapid),
    motion(10, Meaning::Linear),
    motion(20, Meaning::ArcClockwise),
    motion(30, Meaning::ArcCounterClockwise),
    once(40, Meaning::Dwell),
    motion(50, Meaning::CubicSpline),
    motion(51, Meaning::QuadraticSpline),
    motion(52, Meaning::Nurbs),
    motion(53, Meaning::NurbsEnd),
    g(70, Meaning::DiameterMode, Group::Diameter, 15),
    g(80, Meaning::RadiusMode, Group::Diameter, 15),
    once(100, Meaning::DataSetting),
    g(170, Meaning::Plane(Plane::Xy), Group::Plane, 2),
    g(171, Meaning::PlaneOfUvw(Plane::Xy), Group::Plane, 2),
    g(180, Meaning::Plane(Plane::Zx), Group::Plane, 2),
    g(181, Meaning::PlaneOfUvw(Plane::Zx), Group::Plane, 2),
    g(190, Meaning::Plane(Plane::Yz), Group::Plane, 2),
    g(191, Meaning::PlaneOfUvw(Plane::Yz), Group::Plane, 2),
    g(200, Meaning::Inch, Group::Units, 6),
    g(210, Meaning::Metric, Group::Units, 6),
    once(280, Meaning::ReferenceReturn),
    once(281, Meaning::SaveReference),
    once(300, Meaning::FurtherReferenceReturn),
    once(301, Meaning::SaveReference),
    motion(330, Meaning::Synchronised),
    motion(331, Meaning::RigidTap),
    motion(382, Meaning::Probe { away: false, needs_contact: true }),
    motion(383, Meaning::Probe { away: false, needs_contact: false }),
    motion(384, Meaning::Probe { away: true, needs_contact: true }),
    motion(385, Meaning::Probe { away: true, needs_contact: false }),
    g(400, Meaning::CutterOff, Group::Cutter, 7),
    g(410, Meaning::CutterLeft, Group::Cutter, 7),
    g(411, Meaning::CutterLeftOf, Group::Cutter, 7),
    g(420, Meaning::CutterRight, Group::Cutter, 7),
    g(421, Meaning::CutterRightOf, Group::Cutter, 7),
    g(430, Meaning::LengthPlus, Group::Length, 8),
    g(431, Meaning::LengthOf, Group::Length, 8),
    g(432, Meaning::LengthMore, Group::Length, 8),
    g(490, Meaning::LengthOff, Group::Length, 8),
    once(520, Meaning::LocalZero),
    once(530, Meaning::MachinePosition),
    system(540, 1),
    system(550, 2),
    system(560, 3),
    system(570, 4),
    system(580, 5),
    system(590, 6),
    system(591, 7),
    system(592, 8),
    system(593, 9),
    g(610, Meaning::ExactPath, Group::PathControl, 13),
    g(611, Meaning::ExactStop, Group::PathControl, 13),
    g(640, Meaning::CuttingMode, Group::PathControl, 13),
    motion(700, Meaning::LatheCycle),
    motion(710, Meaning::LatheCycle),
    motion(711, Meaning::LatheCycle),
    motion(712, Meaning::LatheCycle),
    motion(720, Meaning::LatheCycle),
    motion(721, Meaning::LatheCycle),
    motion(722, Meaning::LatheCycle),
    hole(730, Peck::ChipBreak, false, Retract::Rapid),
    motion(740, Meaning::Cycle(CycleKind::Tap { left: true })),
    motion(760, Meaning::Threading),
    CYCLE_OFF,
    hole(810, Peck::None, false, Retract::Rapid),
    hole(820, Peck::None, true, Retract::Rapid),
    hole(830, Peck::Clear, false, Retract::Rapid),
    motion(840, Meaning::Cycle(CycleKind::Tap { left: false })),
    hole(850, Peck::None, false, Retract::Feed),
    hole(860, Peck::None, true, Retract::SpindleStopped),
    motion(870, Meaning::Cycle(CycleKind::BackBore)),
    hole(880, Peck::None, true, Retract::ByHand),
    hole(890, Peck::None, true, Retract::Feed),
    g(900, Meaning::Absolute, Group::Distance, 3),
    g(901, Meaning::CentreAbsolute, Group::CentreDistance, 4),
    g(910, Meaning::Incremental, Group::Distance, 3),
    g(911, Meaning::CentreIncremental, Group::CentreDistance, 4),
    once(920, Meaning::SetPosition),
    once(921, Meaning::ShiftCleared),
    once(922, Meaning::ShiftSuspended),
    once(923, Meaning::ShiftRestored),
    g(930, Meaning::InverseTime, Group::FeedMode, 5),
    g(940, Meaning::FeedPerMinute, Group::FeedMode, 5),
    g(950, Meaning::FeedPerRevolution, Group::FeedMode, 5),
    g(960, Meaning::SurfaceSpeed, Group::SurfaceSpeed, 14),
    g(970, Meaning::SpindleSpeed, Group::SurfaceSpeed, 14),
    g(980, Meaning::ReturnInitial, Group::Return, 10),
    g(990, Meaning::ReturnR, Group::Return, 10),
];

const fn m(code: u16, function: MFunction) -> MCode {
    MCode { code, function, after_motion: false, controls_program: false }
}

const fn stop(code: u16, function: MFunction) -> MCode {
    MCode { code, function, after_motion: true, controls_program: true }
}

/// The M codes in rising order.
pub static M_CODES: &[MCode] = &[
    stop(0, MFunction::Stop),
    stop(1, MFunction::OptionalStop),
    stop(2, MFunction::ProgramEnd),
    m(3, MFunction::SpindleClockwise),
    m(4, MFunction::SpindleCounterClockwise),
    m(5, MFunction::SpindleOff),
    m(6, MFunction::ToolChange),
    m(7, MFunction::Machine),
    m(8, MFunction::CoolantOn),
    m(9, MFunction::CoolantOff),
    m(19, MFunction::Orient),
    stop(30, MFunction::ProgramEnd),
    m(48, MFunction::Machine),
    m(49, MFunction::Machine),
    m(50, MFunction::Machine),
    m(51, MFunction::Machine),
    m(52, MFunction::Machine),
    m(53, MFunction::Machine),
    stop(60, MFunction::Stop),
    m(61, MFunction::ToolChange),
    m(62, MFunction::SetOutput),
    m(63, MFunction::SetOutput),
    m(64, MFunction::SetOutput),
    m(65, MFunction::SetOutput),
    m(66, MFunction::Machine),
    m(67, MFunction::SetOutput),
    m(68, MFunction::SetOutput),
    m(70, MFunction::Internal),
    m(71, MFunction::Internal),
    m(72, MFunction::Internal),
    m(73, MFunction::Internal),
    stop(98, MFunction::Call),
    stop(99, MFunction::Return),
];

/// Modal groups of M codes. Of one group a block takes but one (LinuxCNC, modal groups).
pub fn m_group(code: u16) -> Option<MGroup> {
    Some(match code {
        0 | 1 | 2 | 30 | 60 | 98 | 99 => MGroup::Stop,
        // Saving the modal state counts among these.
        3 | 4 | 5 | 19 | 70..=73 => MGroup::Spindle,
        6 | 61 => MGroup::Tool,
        7..=9 => MGroup::Coolant,
        48..=53 => MGroup::Override,
        62..=68 => MGroup::Io,
        100..=199 => MGroup::User,
        _ => return None,
    })
}

/// A modal group of M codes, in the order in which a block executes them.
#[derive(Clone, Copy, PartialEq, Eq, Debug)]
#[repr(u8)]
pub enum MGroup {
    /// Inputs and outputs.
    Io,
    /// Tool change.
    Tool,
    /// Spindle; modal state saved and restored.
    Spindle,
    /// Coolant.
    Coolant,
    /// Overrides.
    Override,
    /// M100 to M199.
    User,
    /// Stops, ends, and calls of programs.
    Stop,
}

impl MGroup {
    /// How many there are.
    pub const COUNT: usize = MGroup::Stop as usize + 1;
}

/// The language bounds no word; what leads further than any machine reaches is refused where it is used.
const COORDINATE: f64 = super::motion::LARGEST_COORDINATE;

/// Addresses. G, M, N and O are read apart.
pub static ADDRESSES: &[Address] = &[
    signed(b'A', COORDINATE),
    signed(b'B', COORDINATE),
    signed(b'C', COORDINATE),
    signed(b'D', COORDINATE),
    signed(b'E', COORDINATE),
    signed(b'F', COORDINATE),
    signed(b'H', COORDINATE),
    signed(b'I', COORDINATE),
    signed(b'J', COORDINATE),
    signed(b'K', COORDINATE),
    signed(b'L', COORDINATE),
    signed(b'P', COORDINATE),
    signed(b'Q', COORDINATE),
    signed(b'R', COORDINATE),
    signed(b'S', COORDINATE),
    signed(b'T', COORDINATE),
    signed(b'U', COORDINATE),
    signed(b'V', COORDINATE),
    signed(b'W', COORDINATE),
    signed(b'X', COORDINATE),
    signed(b'Y', COORDINATE),
    signed(b'Z', COORDINATE),
];

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn every_m_code_has_a_group() {
        assert!(M_CODES.iter().all(|m| m_group(m.code).is_some()));
    }
}
