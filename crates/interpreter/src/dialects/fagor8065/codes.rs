//! Tables of G codes, M codes and addresses.

use super::{figures, iso};
use crate::cycles::CycleKind;
use crate::cycles::zone::{FigureFormat, WordFormat};
use crate::dialect::{Address, GCode, MCode, MFunction, Meaning, g};
use crate::dialects::fanuc::{after, count, positive, signed, with};
use crate::modal::Group;
use ferrocut_geometry::Plane;
use ferrocut_machine::Fault;

const fn cycle(tenths: u16, format: &'static WordFormat) -> GCode {
    g(tenths, Meaning::Cycle(CycleKind::Words(format)), Group::Cycle, 9)
}

/// A code of its block alone.
const fn once(tenths: u16, meaning: Meaning) -> GCode {
    g(tenths, meaning, Group::NonModal, 0)
}

const fn figure(tenths: u16, format: &'static FigureFormat) -> GCode {
    once(tenths, Meaning::Figure(format))
}

/// The cycles of the manual, and the common codes that stand around them. The manual numbers no groups: the
/// numbers are Fanuc's.
pub static G_CODES: &[GCode] = &[
    g(0, Meaning::Rapid, Group::Motion, 1),
    g(10, Meaning::Linear, Group::Motion, 1),
    g(20, Meaning::ArcClockwise, Group::Motion, 1),
    g(30, Meaning::ArcCounterClockwise, Group::Motion, 1),
    once(40, Meaning::Dwell),
    g(50, Meaning::CuttingMode, Group::PathControl, 15),
    g(70, Meaning::ExactStop, Group::PathControl, 15),
    g(170, Meaning::Plane(Plane::Xy), Group::Plane, 2),
    g(180, Meaning::Plane(Plane::Zx), Group::Plane, 2),
    g(190, Meaning::Plane(Plane::Yz), Group::Plane, 2),
    once(200, Meaning::ChooseAxes),
    once(300, Meaning::PolarOrigin),
    once(360, Meaning::ProfileRound),
    once(370, Meaning::ProfileEntry),
    once(380, Meaning::ProfileExit),
    once(390, Meaning::ProfileChamfer),
    g(400, Meaning::CutterOff, Group::Cutter, 7),
    g(410, Meaning::CutterLeft, Group::Cutter, 7),
    g(420, Meaning::CutterRight, Group::Cutter, 7),
    g(500, Meaning::CuttingMode, Group::PathControl, 15),
    g(540, Meaning::WorkOffset(1), Group::WorkOffset, 14),
    g(550, Meaning::WorkOffset(2), Group::WorkOffset, 14),
    g(560, Meaning::WorkOffset(3), Group::WorkOffset, 14),
    g(570, Meaning::WorkOffset(4), Group::WorkOffset, 14),
    g(580, Meaning::WorkOffset(5), Group::WorkOffset, 14),
    g(590, Meaning::WorkOffset(6), Group::WorkOffset, 14),
    g(600, Meaning::ExactStop, Group::PathControl, 15),
    g(610, Meaning::CuttingMode, Group::PathControl, 15),
    g(700, Meaning::Inch, Group::Units, 6),
    g(710, Meaning::Metric, Group::Units, 6),
    once(740, Meaning::HomeSearch),
    g(800, Meaning::CycleOff, Group::Cycle, 9),
    cycle(810, &iso::DRILLING),
    cycle(820, &iso::VARIABLE_PECKS),
    cycle(830, &iso::CONSTANT_PECKS),
    cycle(840, &iso::TAPPING),
    cycle(850, &iso::REAMING),
    cycle(860, &iso::BORING),
    cycle(870, &iso::RECTANGULAR_POCKET),
    cycle(880, &iso::CIRCULAR_POCKET),
    g(900, Meaning::Absolute, Group::Distance, 3),
    g(910, Meaning::Incremental, Group::Distance, 3),
    g(940, Meaning::FeedPerMinute, Group::FeedMode, 5),
    g(950, Meaning::FeedPerRevolution, Group::FeedMode, 5),
    g(980, Meaning::ReturnInitial, Group::Return, 10),
    g(990, Meaning::ReturnR, Group::Return, 10),
    figure(1600, &figures::LINE),
    figure(1610, &figures::PARALLELOGRAM),
    figure(1620, &figures::GRID),
    figure(1630, &figures::CIRCLE),
    figure(1640, &figures::ARC),
    figure(1650, &figures::CHORD),
    cycle(2100, &iso::BORE_MILLING),
    cycle(2110, &iso::INTERNAL_THREAD),
    cycle(2120, &iso::EXTERNAL_THREAD),
];

/// M codes in rising order; any other goes to the machine. The tool is there for the move of the block.
pub static M_CODES: [MCode; 11] = [
    after(0, MFunction::Stop),
    after(1, MFunction::OptionalStop),
    after(2, MFunction::ProgramEnd),
    with(3, MFunction::SpindleClockwise),
    with(4, MFunction::SpindleCounterClockwise),
    with(5, MFunction::SpindleOff),
    with(6, MFunction::ToolChange),
    with(8, MFunction::CoolantOn),
    with(9, MFunction::CoolantOff),
    with(19, MFunction::Orient),
    after(30, MFunction::ProgramEnd),
];

/// The manual bounds no coordinate.
const COORDINATE: f64 = 99_999_999.0;

/// Addresses. G, M, N and O are read apart.
pub static ADDRESSES: &[Address] = &[
    signed(b'A', COORDINATE),
    signed(b'B', COORDINATE),
    signed(b'C', COORDINATE),
    count(b'D', 99.0, Fault::OffsetNumber),
    positive(b'F', COORDINATE, Fault::FeedOutOfRange),
    signed(b'I', COORDINATE),
    signed(b'J', COORDINATE),
    signed(b'K', COORDINATE),
    signed(b'Q', COORDINATE),
    signed(b'R', COORDINATE),
    positive(b'S', 999_999.0, Fault::WordOutOfRange),
    count(b'T', 9999.0, Fault::ToolNumber),
    signed(b'U', COORDINATE),
    signed(b'V', COORDINATE),
    signed(b'W', COORDINATE),
    signed(b'X', COORDINATE),
    signed(b'Y', COORDINATE),
    signed(b'Z', COORDINATE),
];
