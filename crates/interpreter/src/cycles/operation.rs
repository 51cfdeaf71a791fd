//! One operation of a cycle: what is made at a point with one tool.

use super::area::profile::ProfileMilling;
use super::area::{BossFinish, BossRough, Facing, PocketFinish, PocketRough, Slot};
use super::bore_milling::BoreMilling;
use super::boring::{Bore, Way};
use super::drilling::Hole;
use super::pocket::PocketCut;
use super::tapping::TappedHole;
use super::thread_milling::ThreadMilling;
use super::tool::{Count, Frame, Take, Tool};
use ferrocut_geometry::Turn;

/// Most acts of one operation. A step or pitch that needs more is a slip of the pen.
const MOST_ACTS: u32 = 200_000;

/// What is made.
#[derive(Clone, PartialEq, Debug)]
#[allow(missing_docs)]
pub enum Work {
    Hole(Hole),
    TappedHole(TappedHole),
    Bore(Bore),
    BoreMilling(BoreMilling),
    ThreadMilling(ThreadMilling),
    PocketRough(PocketRough),
    PocketFinish(PocketFinish),
    BossRough(BossRough),
    BossFinish(BossFinish),
    Facing(Facing),
    Slot(Slot),
    Profile(ProfileMilling),
    ProfilePocket(PocketCut),
}

/// An operation.
#[derive(Clone, PartialEq, Debug)]
pub struct Operation {
    /// What is made.
    pub work: Work,
    /// The frame of it, for the point [0, 0].
    pub frame: Frame,
    /// +1 where the part lies towards minus, −1 where it lies towards plus.
    pub up: f64,
    /// Level that the tool goes to at rapid before all else, where that is not its own start.
    pub reference: Option<f64>,
}

impl Operation {
    /// What is made in a frame.
    pub fn new(work: Work, frame: Frame, up: f64) -> Operation {
        Operation { work, frame, up, reference: None }
    }

    /// The same in a frame that is not turned.
    pub fn plain(work: Work, up: f64) -> Operation {
        Operation::new(work, Frame::new([0.0; 2], 0.0, Turn::CounterClockwise), up)
    }

    /// Where the tool must stand when it begins, for an operation at a point; none where it finds its way
    /// itself.
    pub fn start(&self, at: [f64; 2]) -> Option<[f64; 2]> {
        let local = match &self.work {
            Work::ProfilePocket(_) => return None,
            Work::BossRough(boss) => boss.start(),
            Work::BossFinish(boss) => boss.start(),
            Work::Facing(facing) => facing.start(),
            Work::Slot(slot) => slot.start(),
            Work::Profile(profile) => profile.path.start,
            _ => [0.0; 2],
        };
        Some(self.frame.shifted(at).world(local))
    }

    /// Whether it takes more acts than can be meant.
    pub fn is_endless(&self) -> bool {
        // Planned with a limit of its own.
        if matches!(self.work, Work::ProfilePocket(_)) {
            return false;
        }
        self.run([0.0; 2], [0.0; 3], &mut Count::of(MOST_ACTS)).is_err()
    }

    /// Whether it goes into the hole with the spindle stopped.
    pub fn begins_stopped(&self) -> bool {
        matches!(&self.work, Work::Bore(bore) if matches!(bore.way, Way::InAside(_)))
    }

    /// Makes it at a point, with the tool standing over its start at `from`.
    pub fn run<T: Take>(&self, at: [f64; 2], from: [f64; 3], taker: &mut T) -> Result<(), T::Error> {
        if let Work::ProfilePocket(pocket) = &self.work {
            return pocket.cut(from, taker);
        }
        let frame = self.frame.shifted(at);
        let mut tool = Tool::new(frame, from, self.up, taker);
        if let Some(reference) = self.reference {
            tool.rapid_z(reference)?;
        }
        match &self.work {
            Work::Hole(hole) => hole.drill(&mut tool),
            Work::TappedHole(hole) => hole.tap(&mut tool),
            Work::Bore(bore) => bore.bore(&mut tool),
            Work::BoreMilling(bore) => bore.mill(&mut tool),
            Work::ThreadMilling(thread) => thread.mill(frame, &mut tool),
            Work::PocketRough(pocket) => pocket.cut(&mut tool),
            Work::PocketFinish(pocket) => pocket.cut(&mut tool),
            Work::BossRough(boss) => boss.cut(&mut tool),
            Work::BossFinish(boss) => boss.cut(&mut tool),
            Work::Facing(facing) => facing.cut(&mut tool),
            Work::Slot(slot) => slot.cut(&mut tool),
            Work::Profile(profile) => profile.cut(&mut tool),
            Work::ProfilePocket(_) => Ok(()),
        }
    }
}
