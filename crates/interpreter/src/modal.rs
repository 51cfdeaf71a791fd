//! Modal state: one code of every group is in force.

use crate::dialect::{GCode, Meaning};
use ferrocut_geometry::Plane;

/// A modal group in terms common to all controls. The number a control gives it is in its table of
/// codes ([`GCode::group_number`]).
#[derive(Clone, Copy, PartialEq, Eq, Debug)]
#[repr(u8)]
pub enum Group {
    /// G00 G01 G02 G03.
    Motion,
    /// G17 G18 G19.
    Plane,
    /// G90 G91.
    Distance,
    /// G94 G95.
    FeedMode,
    /// G54…
    WorkOffset,
    /// G20 G21.
    Units,
    /// G40 G41 G42.
    Cutter,
    /// G43 G44 G49.
    Length,
    /// G80, drilling and milling cycles.
    Cycle,
    /// G98 G99.
    Return,
    /// G15 G16.
    Polar,
    /// G50 G51.
    Scaling,
    /// G68 G69.
    Rotation,
    /// G50.1 G51.1.
    Mirror,
    /// G61 to G64.
    PathControl,
    /// G96 G97.
    SurfaceSpeed,
    /// G12 G13.
    StrokeCheck,
    /// G90.1 G91.1.
    CentreDistance,
    /// G7 G8.
    Diameter,
    /// Codes in force in their block only.
    NonModal,
}

impl Group {
    /// Number of groups that are modal.
    pub const COUNT: usize = Group::NonModal as usize;
}

/// The code in force in every modal group.
#[derive(Clone, Copy, PartialEq, Debug)]
pub struct Modal {
    active: [&'static GCode; Group::COUNT],
}

impl Modal {
    /// A state in which every group has one of `codes`; groups that none of them is of keep `other`.
    pub fn new(other: &'static GCode, codes: impl IntoIterator<Item = &'static GCode>) -> Modal {
        let mut modal = Modal { active: [other; Group::COUNT] };
        for code in codes {
            modal.set(code);
        }
        modal
    }

    /// Puts a code in force. A code that is not modal changes nothing.
    #[inline]
    pub fn set(&mut self, code: &'static GCode) {
        if let Some(slot) = self.active.get_mut(code.group as usize) {
            *slot = code;
        }
    }

    /// The state after a reset that puts the groups for which `clears` holds, by the manual's number,
    /// back to their code of `initial`.
    pub fn reset_to(&self, initial: &Modal, clears: impl Fn(u8) -> bool) -> Modal {
        let mut modal = *self;
        for code in initial.codes().filter(|code| clears(code.group_number)) {
            modal.set(code);
        }
        modal
    }

    /// The code in force in a group.
    pub fn code(&self, group: Group) -> Option<&'static GCode> {
        self.active.get(group as usize).copied()
    }

    /// What the code in force in a group means.
    #[inline]
    pub fn meaning(&self, group: Group) -> Meaning {
        // NonModal is the one group without a slot.
        self.active.get(group as usize).map_or(Meaning::Rapid, |code| code.meaning)
    }

    /// The codes in force, by group; a group that the control does not have has none.
    pub fn codes(&self) -> impl Iterator<Item = &'static GCode> {
        let own = |(at, code): (usize, &'static GCode)| (code.group as usize == at).then_some(code);
        self.active.into_iter().enumerate().filter_map(own)
    }

    /// Working plane.
    #[inline]
    pub fn plane(&self) -> Plane {
        match self.meaning(Group::Plane) {
            Meaning::Plane(plane) => plane,
            _ => Plane::Xy,
        }
    }

    /// G91.
    #[inline]
    pub fn is_incremental(&self) -> bool {
        self.meaning(Group::Distance) == Meaning::Incremental
    }

    /// G20.
    #[inline]
    pub fn is_inch(&self) -> bool {
        self.meaning(Group::Units) == Meaning::Inch
    }

    /// G95.
    #[inline]
    pub fn is_feed_per_revolution(&self) -> bool {
        self.meaning(Group::FeedMode) == Meaning::FeedPerRevolution
    }
}
