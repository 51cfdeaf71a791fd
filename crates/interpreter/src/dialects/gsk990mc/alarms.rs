//! The numbers that the manual's list of alarms gives the rules.

use ferrocut_machine::Fault;

/// Appendix 2.
pub const ALARMS: &[(Fault, u16)] = &[
    (Fault::NumberWithoutAddress, 4),
    (Fault::AddressWithoutNumber, 5),
    (Fault::MisplacedSign, 6),
    (Fault::WordNegative, 6),
    (Fault::MisplacedPoint, 7),
    (Fault::WordNotWhole, 7),
    (Fault::IllegalCharacter, 9),
    (Fault::UnknownAddress, 9),
    (Fault::UnknownGCode, 10),
    (Fault::NoFeed, 11),
    (Fault::FeedOutOfRange, 11),
    (Fault::ArcRadiusMismatch, 20),
    (Fault::ArcRadiusTooSmall, 20),
    (Fault::ArcWithoutCentre, 22),
    (Fault::LineTooLong, 26),
    (Fault::LengthWithCoordinateSet, 27),
    (Fault::OffsetNumber, 30),
    (Fault::WorkOffsetNumber, 30),
    (Fault::CycleNoPeck, 45),
    (Fault::CycleDepthAboveR, 49),
    (Fault::CallWithoutProgram, 76),
    (Fault::CallsTooDeep, 77),
    (Fault::ProgramMissing, 78),
    (Fault::PlaneInCycle, 86),
    (Fault::ResultTooLarge, 111),
    (Fault::DivisionByZero, 112),
    (Fault::UnknownFunction, 113),
    (Fault::UnknownVariable, 115),
    (Fault::VariableNotWritable, 116),
    (Fault::BracketsTooDeep, 118),
    (Fault::ProgramCodesTogether, 119),
    (Fault::TooManyMCodes, 119),
    (Fault::NoProgramEnd, 124),
    (Fault::MalformedExpression, 125),
    (Fault::MalformedStatement, 125),
    (Fault::UnbalancedBracket, 125),
    (Fault::MixedStatement, 127),
    (Fault::UnknownAxis, 133),
    (Fault::ProgramNumber, 172),
    (Fault::TooManyRepeats, 173),
    (Fault::CyclePlane, 175),
    (Fault::CycleNoSpindle, 178),
    (Fault::UnknownMCode, 181),
    (Fault::SpindleTooFast, 182),
    (Fault::ToolMissing, 184),
    (Fault::TooManyHelicalAxes, 232),
    (Fault::EndMarkReached, 235),
    (Fault::RepeatedAddress, 238),
    (Fault::RepeatedGroup, 238),
];

/// 0500 to 0507: the four axes of the control, negative side first.
pub fn soft_limit(axis: usize, upper: bool) -> Option<u16> {
    let axis = u16::try_from(axis).ok().filter(|a| *a < 4)?;
    Some(500 + 2 * axis + u16::from(upper))
}
