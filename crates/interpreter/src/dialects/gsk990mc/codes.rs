//! Tables of G codes (4-1-2), M codes (5-1) and addresses (3-1-3-1).

use crate::cycles::milling::Side;
use crate::cycles::{CycleKind, HoleCycle, MillShape, Peck, Retract};
use crate::dialect::{Address, GCode, MCode, MFunction, Meaning, g};
use crate::modal::Group;
use ferrocut_geometry::{Plane, Turn};
use ferrocut_machine::Fault;

const fn hole(tenths: u16, peck: Peck, dwell: bool, retract: Retract) -> GCode {
    g(tenths, Meaning::Cycle(CycleKind::Hole(HoleCycle { peck, dwell, retract })), Group::Cycle, 9)
}

const fn mill(tenths: u16, shape: MillShape, turn: Turn) -> GCode {
    g(tenths, Meaning::Cycle(CycleKind::Mill { shape, turn }), Group::Cycle, 9)
}

/// G80.
pub static CYCLE_OFF: GCode = g(800, Meaning::CycleOff, Group::Cycle, 9);

/// G49.
pub static LENGTH_OFF: GCode = g(490, Meaning::LengthOff, Group::Length, 8);

/// G60 where 48#0 makes it modal.
pub static ONE_WAY_MODAL: GCode = g(600, Meaning::OneWay, Group::Motion, 1);

/// Table 4-1-2, in rising order.
pub static G_CODES: &[GCode] = &[
    g(0, Meaning::Rapid, Group::Motion, 1),
    g(10, Meaning::Linear, Group::Motion, 1),
    g(20, Meaning::ArcClockwise, Group::Motion, 1),
    g(30, Meaning::ArcCounterClockwise, Group::Motion, 1),
    g(40, Meaning::Dwell, Group::NonModal, 0),
    g(100, Meaning::DataSetting, Group::NonModal, 0),
    g(110, Meaning::DataSettingOff, Group::NonModal, 0),
    g(120, Meaning::StrokeCheckOn, Group::StrokeCheck, 16),
    g(130, Meaning::StrokeCheckOff, Group::StrokeCheck, 16),
    g(150, Meaning::PolarOff, Group::Polar, 11),
    g(160, Meaning::PolarOn, Group::Polar, 11),
    g(170, Meaning::Plane(Plane::Xy), Group::Plane, 2),
    g(180, Meaning::Plane(Plane::Zx), Group::Plane, 2),
    g(190, Meaning::Plane(Plane::Yz), Group::Plane, 2),
    g(200, Meaning::Inch, Group::Units, 6),
    g(210, Meaning::Metric, Group::Units, 6),
    mill(220, MillShape::RoundPocket, Turn::CounterClockwise),
    mill(230, MillShape::RoundPocket, Turn::Clockwise),
    mill(240, MillShape::Circle(Side::Inside), Turn::CounterClockwise),
    mill(250, MillShape::Circle(Side::Inside), Turn::Clockwise),
    mill(260, MillShape::Circle(Side::Outside), Turn::CounterClockwise),
    g(270, Meaning::ReferenceCheck, Group::NonModal, 0),
    g(280, Meaning::ReferenceReturn, Group::NonModal, 0),
    g(290, Meaning::ReturnFromReference, Group::NonModal, 0),
    g(300, Meaning::FurtherReferenceReturn, Group::NonModal, 0),
    g(310, Meaning::Skip, Group::NonModal, 0),
    mill(320, MillShape::Circle(Side::Outside), Turn::Clockwise),
    mill(330, MillShape::RectPocket, Turn::CounterClockwise),
    mill(340, MillShape::RectPocket, Turn::Clockwise),
    mill(350, MillShape::Rectangle(Side::Inside), Turn::CounterClockwise),
    mill(360, MillShape::Rectangle(Side::Inside), Turn::Clockwise),
    mill(370, MillShape::Rectangle(Side::Outside), Turn::CounterClockwise),
    mill(380, MillShape::Rectangle(Side::Outside), Turn::Clockwise),
    g(390, Meaning::CornerArc, Group::NonModal, 0),
    g(400, Meaning::CutterOff, Group::Cutter, 7),
    g(410, Meaning::CutterLeft, Group::Cutter, 7),
    g(420, Meaning::CutterRight, Group::Cutter, 7),
    g(430, Meaning::LengthPlus, Group::Length, 8),
    g(440, Meaning::LengthMinus, Group::Length, 8),
    g(490, Meaning::LengthOff, Group::Length, 8),
    g(500, Meaning::ScalingOff, Group::Scaling, 12),
    g(510, Meaning::ScalingOn, Group::Scaling, 12),
    g(530, Meaning::MachinePosition, Group::NonModal, 0),
    g(540, Meaning::WorkOffset(1), Group::WorkOffset, 5),
    g(550, Meaning::WorkOffset(2), Group::WorkOffset, 5),
    g(560, Meaning::WorkOffset(3), Group::WorkOffset, 5),
    g(570, Meaning::WorkOffset(4), Group::WorkOffset, 5),
    g(580, Meaning::WorkOffset(5), Group::WorkOffset, 5),
    g(590, Meaning::WorkOffset(6), Group::WorkOffset, 5),
    g(600, Meaning::OneWay, Group::NonModal, 0),
    g(610, Meaning::ExactStop, Group::PathControl, 14),
    g(620, Meaning::CornerOverride, Group::PathControl, 14),
    g(630, Meaning::TappingMode, Group::PathControl, 14),
    g(640, Meaning::CuttingMode, Group::PathControl, 14),
    g(680, Meaning::RotationOn, Group::Rotation, 13),
    g(690, Meaning::RotationOff, Group::Rotation, 13),
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
    hole(880, Peck::None, true, Retract::ByHand),
    hole(890, Peck::None, true, Retract::Feed),
    g(900, Meaning::Absolute, Group::Distance, 3),
    g(910, Meaning::Incremental, Group::Distance, 3),
    g(920, Meaning::SetPosition, Group::NonModal, 0),
    g(940, Meaning::FeedPerMinute, Group::FeedMode, 4),
    g(950, Meaning::FeedPerRevolution, Group::FeedMode, 4),
    g(960, Meaning::SurfaceSpeed, Group::SurfaceSpeed, 15),
    g(970, Meaning::SpindleSpeed, Group::SurfaceSpeed, 15),
    g(980, Meaning::ReturnInitial, Group::Return, 10),
    g(990, Meaning::ReturnR, Group::Return, 10),
];

/// Starts with the block's motion (section 5.1: codes of the ladder).
const fn with(code: u16, function: MFunction) -> MCode {
    MCode { code, function, after_motion: false, controls_program: false }
}

/// Runs after the block's motion, alone among M codes (sections 5.2 and 4.4.1 note 1, alarm 0119).
const fn after(code: u16, function: MFunction) -> MCode {
    MCode { code, function, after_motion: true, controls_program: true }
}

/// Table 5-1 and the codes named in 1.2, in rising order.
pub static M_CODES: &[MCode] = &[
    after(0, MFunction::Stop),
    after(1, MFunction::OptionalStop),
    after(2, MFunction::End),
    with(3, MFunction::SpindleClockwise),
    with(4, MFunction::SpindleCounterClockwise),
    with(5, MFunction::SpindleOff),
    after(6, MFunction::ToolChange),
    with(8, MFunction::CoolantOn),
    with(9, MFunction::CoolantOff),
    with(10, MFunction::Machine),
    with(11, MFunction::Machine),
    with(16, MFunction::Machine),
    with(17, MFunction::Machine),
    with(18, MFunction::Machine),
    with(19, MFunction::Orient),
    with(20, MFunction::Machine),
    with(21, MFunction::Machine),
    with(22, MFunction::Machine),
    with(23, MFunction::Machine),
    with(24, MFunction::Machine),
    with(26, MFunction::Machine),
    with(27, MFunction::Machine),
    with(28, MFunction::RigidTappingOff),
    with(29, MFunction::RigidTapping),
    after(30, MFunction::End),
    with(35, MFunction::Machine),
    with(36, MFunction::Machine),
    with(44, MFunction::Machine),
    with(45, MFunction::Machine),
    with(50, MFunction::Machine),
    with(51, MFunction::Machine),
    after(98, MFunction::Call),
    after(99, MFunction::Return),
];

/// A number within ± `limit`.
const fn signed(letter: u8, limit: f64) -> Address {
    Address { letter, min: -limit, max: limit, whole: false, beyond: Fault::WordOutOfRange }
}

/// A whole number from 0 to `max`, beyond which there is an alarm of its own.
const fn count(letter: u8, max: f64, beyond: Fault) -> Address {
    Address { letter, min: 0.0, max, whole: true, beyond }
}

/// A number from 0 to `max`, beyond which there is an alarm of its own.
const fn positive(letter: u8, max: f64, beyond: Fault) -> Address {
    Address { letter, min: 0.0, max, whole: false, beyond }
}

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
    positive(b'S', 999_999.0, Fault::SpindleTooFast),
    count(b'T', 9999.0, Fault::ToolNumber),
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
    fn tables_are_in_rising_order_so_that_look_ups_find_every_row() {
        assert!(G_CODES.windows(2).all(|w| w[0].tenths < w[1].tenths));
        assert!(M_CODES.windows(2).all(|w| w[0].code < w[1].code));
        assert!(ADDRESSES.windows(2).all(|w| w[0].letter < w[1].letter));
    }
}
