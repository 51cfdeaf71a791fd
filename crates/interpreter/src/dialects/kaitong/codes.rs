//! Tables of G codes, M codes and addresses: what stands here beside the codes of all Fanuc-like languages.

use crate::dialect::{Address, GCode, MCode, MFunction, Meaning};
use crate::dialects::fanuc::{self, code, count, positive, signed, with};
use crate::modal::Group;
use ferrocut_machine::Fault;

/// The group of G15 and G16.
pub const POLAR_GROUP: u8 = 17;

/// The group of the canned cycles.
pub const CYCLE_GROUP: u8 = 9;

/// The G codes.
pub static G_CODES: [GCode; 61] = fanuc::g_codes(OWN_G, GROUPS);

/// The numbers of the groups, which macro variables count them by: those of the Fanuc 0i-M.
const GROUPS: &[(Group, u8)] = &[
    (Group::Motion, 1),
    (Group::Plane, 2),
    (Group::Distance, 3),
    (Group::FeedMode, 5),
    (Group::Units, 6),
    (Group::Cutter, 7),
    (Group::Length, 8),
    (Group::Cycle, CYCLE_GROUP),
    (Group::Return, 10),
    (Group::WorkOffset, 14),
    (Group::PathControl, 15),
    (Group::Rotation, 16),
    (Group::Polar, POLAR_GROUP),
];

/// The local system of G52 is in appendix 9, 1.1; G142 and G143 are named in appendix 8, note 1.
const OWN_G: [GCode; 3] = [
    code(520, Meaning::LocalZero, Group::NonModal),
    code(1420, Meaning::Undescribed, Group::NonModal),
    code(1430, Meaning::Undescribed, Group::NonModal),
];

/// The M codes.
pub static M_CODES: [MCode; 15] = fanuc::m_codes(OWN_M);

/// Appendix 11: outputs that P021.6 and P279 name.
const OWN_M: [MCode; 2] = [with(20, MFunction::Machine), with(74, MFunction::Machine)];

const COORDINATE: f64 = 99_999.999;

/// G, M, N and O are read apart. Offset numbers are 1 to 24 (appendix 8, 1.1.3); F and I of a thread have
/// narrower ranges of their own (appendix 7, 2.2).
pub static ADDRESSES: &[Address] = &[
    signed(b'A', COORDINATE),
    count(b'D', 24.0, Fault::OffsetNumber),
    positive(b'F', COORDINATE, Fault::FeedOutOfRange),
    count(b'H', 24.0, Fault::OffsetNumber),
    signed(b'I', COORDINATE),
    signed(b'J', COORDINATE),
    signed(b'K', COORDINATE),
    count(b'L', 99_999.0, Fault::WordOutOfRange),
    signed(b'P', COORDINATE),
    signed(b'Q', COORDINATE),
    signed(b'R', COORDINATE),
    positive(b'S', 99_999.0, Fault::SpindleTooFast),
    count(b'T', 9999.0, Fault::ToolNumber),
    signed(b'X', COORDINATE),
    signed(b'Y', COORDINATE),
    signed(b'Z', COORDINATE),
];

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn every_modal_code_has_the_number_of_its_group() {
        for row in &G_CODES {
            assert_eq!(row.group_number == 0, row.group == Group::NonModal, "{}", row.tenths);
        }
    }
}
