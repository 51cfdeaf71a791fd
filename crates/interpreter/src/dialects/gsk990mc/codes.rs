//! Tables of G codes (4-1-2), M codes (5-1) and addresses (3-1-3-1): what stands here beside the codes of all
//! Fanuc-like languages.

use crate::cycles::milling::Side;
use crate::cycles::{CycleKind, MillShape};
use crate::dialect::{Address, GCode, MCode, MFunction, Meaning};
use crate::dialects::fanuc::{self, code, count, cycle, positive, signed, with};
use crate::modal::Group;
use ferrocut_geometry::Turn;
use ferrocut_machine::Fault;

const fn mill(tenths: u16, shape: MillShape, turn: Turn) -> GCode {
    cycle(tenths, CycleKind::Mill { shape, turn })
}

/// Table 4-1-2.
pub static G_CODES: [GCode; 78] = fanuc::g_codes(OWN_G, GROUPS);

/// The numbers of the groups.
const GROUPS: &[(Group, u8)] = &[
    (Group::Motion, 1),
    (Group::Plane, 2),
    (Group::Distance, 3),
    (Group::FeedMode, 4),
    (Group::WorkOffset, 5),
    (Group::Units, 6),
    (Group::Cutter, 7),
    (Group::Length, 8),
    (Group::Cycle, 9),
    (Group::Return, 10),
    (Group::Polar, 11),
    (Group::Scaling, 12),
    (Group::Rotation, 13),
    (Group::PathControl, 14),
    (Group::SurfaceSpeed, 15),
    (Group::StrokeCheck, 16),
];

const OWN_G: [GCode; 20] = [
    code(120, Meaning::StrokeCheckOn, Group::StrokeCheck),
    code(130, Meaning::StrokeCheckOff, Group::StrokeCheck),
    mill(220, MillShape::RoundPocket, Turn::CounterClockwise),
    mill(230, MillShape::RoundPocket, Turn::Clockwise),
    mill(240, MillShape::Circle(Side::Inside), Turn::CounterClockwise),
    mill(250, MillShape::Circle(Side::Inside), Turn::Clockwise),
    mill(260, MillShape::Circle(Side::Outside), Turn::CounterClockwise),
    mill(320, MillShape::Circle(Side::Outside), Turn::Clockwise),
    mill(330, MillShape::RectPocket, Turn::CounterClockwise),
    mill(340, MillShape::RectPocket, Turn::Clockwise),
    mill(350, MillShape::Rectangle(Side::Inside), Turn::CounterClockwise),
    mill(360, MillShape::Rectangle(Side::Inside), Turn::Clockwise),
    mill(370, MillShape::Rectangle(Side::Outside), Turn::CounterClockwise),
    mill(380, MillShape::Rectangle(Side::Outside), Turn::Clockwise),
    code(390, Meaning::CornerArc, Group::NonModal),
    code(500, Meaning::ScalingOff, Group::Scaling),
    code(510, Meaning::ScalingOn, Group::Scaling),
    code(600, Meaning::OneWay, Group::NonModal),
    code(960, Meaning::SurfaceSpeed, Group::SurfaceSpeed),
    code(970, Meaning::SpindleSpeed, Group::SurfaceSpeed),
];

/// Table 5-1 and the codes named in 1.2. Those that start with the motion are the ladder's (5.1), those that
/// wait for its end are in 5.2 and 4.4.1 note 1 (alarm 0119).
pub static M_CODES: [MCode; 33] = fanuc::m_codes(OWN_M);

const OWN_M: [MCode; 20] = [
    with(10, MFunction::Machine),
    with(11, MFunction::Machine),
    with(16, MFunction::Machine),
    with(17, MFunction::Machine),
    with(18, MFunction::Machine),
    with(20, MFunction::Machine),
    with(21, MFunction::Machine),
    with(22, MFunction::Machine),
    with(23, MFunction::Machine),
    with(24, MFunction::Machine),
    with(26, MFunction::Machine),
    with(27, MFunction::Machine),
    with(28, MFunction::RigidTappingOff),
    with(29, MFunction::RigidTapping),
    with(35, MFunction::Machine),
    with(36, MFunction::Machine),
    with(44, MFunction::Machine),
    with(45, MFunction::Machine),
    with(50, MFunction::Machine),
    with(51, MFunction::Machine),
];

const COORDINATE: f64 = 99_999.999_9;
const VECTOR: f64 = 99_999_999.0;

/// Table 3-1-3-1. G, M, N and O are read apart.
pub static ADDRESSES: &[Address] = &[
    signed(b'A', COORDINATE),
    signed(b'B', COORDINATE),
    signed(b'C', COORDINATE),
    count(b'D', 255.0, Fault::OffsetNumber),
    positive(b'F', 99_999.999, Fault::FeedOutOfRange),
    count(b'H', 255.0, Fault::OffsetNumber),
    signed(b'I', VECTOR),
    signed(b'J', VECTOR),
    signed(b'K', VECTOR),
    signed(b'L', VECTOR),
    signed(b'P', 99_999.999_9),
    signed(b'Q', COORDINATE),
    signed(b'R', VECTOR),
    // P205 says how many digits S has.
    count(b'S', 999_999.0, Fault::SpindleTooFast),
    count(b'T', 9999.0, Fault::ToolNumber),
    signed(b'U', COORDINATE),
    signed(b'V', COORDINATE),
    signed(b'W', COORDINATE),
    signed(b'X', COORDINATE),
    signed(b'Y', COORDINATE),
    signed(b'Z', COORDINATE),
];
