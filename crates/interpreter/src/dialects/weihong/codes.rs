//! Tables of G codes (4.8), M codes (4.2) and addresses (3.1).

use crate::cycles::{CycleKind, HoleCycle, Pattern, Peck, Retract};
use crate::dialect::{Address, GCode, MCode, MFunction, Meaning, g};
use crate::dialects::fanuc::{count, positive, signed};
use crate::modal::Group;
use ferrocut_geometry::Plane;
use ferrocut_machine::Fault;

const fn hole(tenths: u16, peck: Peck, dwell: bool, retract: Retract) -> GCode {
    g(tenths, Meaning::Cycle(CycleKind::Hole(HoleCycle { peck, dwell, retract })), Group::Cycle, 9)
}

/// A code of its block alone.
const fn once(tenths: u16, meaning: Meaning) -> GCode {
    g(tenths, meaning, Group::NonModal, 0)
}

/// 4.8, and G916 to G919 and G923 of 4.3. The numbers of the groups are Fanuc's: the manual numbers group 01
/// alone.
pub static G_CODES: &[GCode] = &[
    g(0, Meaning::Rapid, Group::Motion, 1),
    g(10, Meaning::Linear, Group::Motion, 1),
    g(20, Meaning::ArcClockwise, Group::Motion, 1),
    g(30, Meaning::ArcCounterClockwise, Group::Motion, 1),
    once(40, Meaning::Dwell),
    g(170, Meaning::Plane(Plane::Xy), Group::Plane, 2),
    g(180, Meaning::Plane(Plane::Zx), Group::Plane, 2),
    g(190, Meaning::Plane(Plane::Yz), Group::Plane, 2),
    g(200, Meaning::Inch, Group::Units, 6),
    g(210, Meaning::Metric, Group::Units, 6),
    once(280, Meaning::ReferenceReturn),
    // Named in 4.3 among the codes that scaling forbids; as on Fanuc.
    once(290, Meaning::ReturnFromReference),
    once(340, Meaning::Pattern(Pattern::Circle)),
    once(350, Meaning::Pattern(Pattern::Line)),
    once(360, Meaning::Pattern(Pattern::Arc)),
    once(370, Meaning::Pattern(Pattern::Grid)),
    g(400, Meaning::CutterOff, Group::Cutter, 7),
    g(410, Meaning::CutterLeft, Group::Cutter, 7),
    g(420, Meaning::CutterRight, Group::Cutter, 7),
    g(430, Meaning::LengthPlus, Group::Length, 8),
    g(440, Meaning::LengthMinus, Group::Length, 8),
    g(490, Meaning::LengthOff, Group::Length, 8),
    g(500, Meaning::ScalingOff, Group::Scaling, 11),
    g(501, Meaning::MirrorOff, Group::Mirror, 22),
    g(510, Meaning::ScalingOn, Group::Scaling, 11),
    g(511, Meaning::MirrorOn, Group::Mirror, 22),
    once(530, Meaning::MachinePosition),
    g(540, Meaning::WorkOffset(1), Group::WorkOffset, 14),
    g(550, Meaning::WorkOffset(2), Group::WorkOffset, 14),
    g(560, Meaning::WorkOffset(3), Group::WorkOffset, 14),
    g(570, Meaning::WorkOffset(4), Group::WorkOffset, 14),
    g(580, Meaning::WorkOffset(5), Group::WorkOffset, 14),
    g(590, Meaning::WorkOffset(6), Group::WorkOffset, 14),
    once(650, Meaning::Call),
    g(680, Meaning::RotationOn, Group::Rotation, 16),
    g(690, Meaning::RotationOff, Group::Rotation, 16),
    g(700, Meaning::Inch, Group::Units, 6),
    g(710, Meaning::Metric, Group::Units, 6),
    hole(730, Peck::ChipBreak, false, Retract::Rapid),
    g(740, Meaning::Cycle(CycleKind::Tap { left: true }), Group::Cycle, 9),
    g(760, Meaning::Cycle(CycleKind::FineBore), Group::Cycle, 9),
    g(800, Meaning::CycleOff, Group::Cycle, 9),
    hole(810, Peck::None, false, Retract::Rapid),
    hole(820, Peck::None, true, Retract::Rapid),
    hole(830, Peck::Clear, false, Retract::Rapid),
    g(840, Meaning::Cycle(CycleKind::Tap { left: false }), Group::Cycle, 9),
    hole(850, Peck::None, false, Retract::Feed),
    hole(860, Peck::None, false, Retract::SpindleStopped),
    g(870, Meaning::Cycle(CycleKind::BackBore), Group::Cycle, 9),
    hole(880, Peck::None, true, Retract::FeedSpindleStopped),
    hole(890, Peck::None, true, Retract::Feed),
    g(900, Meaning::Absolute, Group::Distance, 3),
    g(910, Meaning::Incremental, Group::Distance, 3),
    once(920, Meaning::SetPosition),
    g(980, Meaning::ReturnInitial, Group::Return, 10),
    g(990, Meaning::ReturnR, Group::Return, 10),
    once(9030, Meaning::FullFeed),
    once(9040, Meaning::MoveUntilInput),
    // A given F always goes before the default one here.
    once(9050, Meaning::NoEffect),
    once(9060, Meaning::WaitForInput),
    once(9070, Meaning::ShortestWay),
    once(9080, Meaning::InDegrees),
    once(9160, Meaning::EncoderLatch),
    once(9180, Meaning::EncoderLatch),
    once(9190, Meaning::EncoderLatch),
    once(9210, Meaning::SetPositionOfOne),
    once(9220, Meaning::SetWorkZero),
    once(9230, Meaning::SetToolLength),
    once(9920, Meaning::SetPositionForNow),
];

/// Starts with the block's motion.
const fn with(code: u16, function: MFunction) -> MCode {
    MCode { code, function, after_motion: false, controls_program: false }
}

/// Waits for its end. Any M codes may stand together (4.7, N14 of example 1).
const fn after(code: u16, function: MFunction) -> MCode {
    MCode { code, function, after_motion: true, controls_program: false }
}

/// Table 4-1.
pub static M_CODES: &[MCode] = &[
    after(0, MFunction::Stop),
    after(1, MFunction::OptionalStop),
    after(2, MFunction::ProgramEnd),
    with(3, MFunction::SpindleClockwise),
    with(4, MFunction::SpindleCounterClockwise),
    with(5, MFunction::SpindleOff),
    after(6, MFunction::ToolChange),
    with(8, MFunction::CoolantOn),
    with(9, MFunction::CoolantOff),
    with(10, MFunction::Machine),
    with(11, MFunction::Machine),
    after(17, MFunction::End),
    after(30, MFunction::ProgramEnd),
    after(98, MFunction::Call),
    after(99, MFunction::Return),
    with(801, MFunction::Message),
    with(802, MFunction::Internal),
    with(901, MFunction::SetOutput),
    with(902, MFunction::ReferenceReached),
    with(903, MFunction::ToolNumber),
];

/// The manual bounds no coordinate.
const COORDINATE: f64 = 9_999_999.0;

/// Numbers of the control itself go up to that of M802.
const NUMBER: f64 = 99_999_999.0;

/// 3.1. G, M, N and O are read apart.
pub static ADDRESSES: &[Address] = &[
    signed(b'A', COORDINATE),
    signed(b'B', COORDINATE),
    signed(b'C', COORDINATE),
    // 4.3: D00 to D07, H00 to H07; H is also an axis or a port.
    count(b'D', 7.0, Fault::OffsetNumber),
    positive(b'F', NUMBER, Fault::FeedOutOfRange),
    count(b'H', 65_535.0, Fault::WordOutOfRange),
    signed(b'I', COORDINATE),
    signed(b'J', COORDINATE),
    signed(b'K', COORDINATE),
    signed(b'L', NUMBER),
    signed(b'P', NUMBER),
    signed(b'Q', COORDINATE),
    signed(b'R', COORDINATE),
    positive(b'S', 999_999.0, Fault::WordOutOfRange),
    count(b'T', 9999.0, Fault::ToolNumber),
    signed(b'X', COORDINATE),
    signed(b'Y', COORDINATE),
    signed(b'Z', COORDINATE),
];
