//! End points and straight moves (LinuxCNC, G0, G1, G53).

use crate::Fallible;
use crate::dialect::Meaning;
use crate::interpreter::Interpreter;
use crate::modal::Group;
use ferrocut_geometry::{Axis, AxisSet, MM_PER_INCH, Position};
use ferrocut_machine::Fault;
use ferrocut_toolpath::{Feed, Op, PathMode};

/// Machine coordinates beyond this are no length of a machine; `f64` still resolves a tenth of a micrometre.
pub(super) const LARGEST_COORDINATE: f64 = 1e8;

impl Interpreter {
    /// Millimetres in the unit of length in force.
    #[inline]
    pub(super) fn ngc_unit(&self) -> f64 {
        if self.modal.is_inch() { MM_PER_INCH } else { 1.0 }
    }

    /// A word of an axis in mm or degrees.
    #[inline]
    pub(super) fn ngc_axis_word(&self, axis: Axis) -> Option<f64> {
        let value = self.words.get(axis.letter() as u8)?;
        let is_diameter = axis == Axis::X && self.modal.meaning(Group::Diameter) == Meaning::DiameterMode;
        let value = if is_diameter { value / 2.0 } else { value };
        Some(if axis.is_linear() { value * self.ngc_unit() } else { value })
    }

    /// A word that is a length, in mm.
    #[inline]
    pub(super) fn ngc_length_word(&self, letter: u8) -> Option<f64> {
        Some(self.words.get(letter)? * self.ngc_unit())
    }

    /// The programmed point that the axis words of the block lead to.
    pub(super) fn ngc_end_point(&self, axes: AxisSet) -> Position {
        if self.ngc.in_machine {
            let mut machine = self.ngc.machine_of(self.ngc.at);
            for axis in axes.iter() {
                machine[axis] = self.ngc_axis_word(axis).unwrap_or(machine[axis]);
            }
            return self.ngc.program_of(machine);
        }
        let mut to = self.ngc.at;
        let incremental = self.modal.is_incremental();
        for axis in axes.iter() {
            let Some(value) = self.ngc_axis_word(axis) else { continue };
            to[axis] = if incremental { to[axis] + value } else { value };
        }
        to
    }

    /// The feed in force.
    pub(super) fn ngc_feed(&self) -> Fallible<Feed> {
        let feed = self.ngc.feed;
        match self.modal.meaning(Group::FeedMode) {
            Meaning::InverseTime => match self.ngc.has_feed_word && feed > 0.0 {
                true => Ok(Feed::Duration(60.0 / feed)),
                false => Err(self.alarm(Fault::NoFeed, self.words.block_span())),
            },
            _ if feed <= 0.0 => Err(self.alarm(Fault::NoFeed, self.words.block_span())),
            Meaning::FeedPerRevolution if self.ngc_spindle_speed() == 0.0 => {
                Err(self.alarm(Fault::SpindleAtRest, self.words.block_span()))
            }
            Meaning::FeedPerRevolution => Ok(Feed::PerRevolution(feed * self.ngc.feed_unit)),
            _ => Ok(Feed::PerMinute(feed * self.ngc.feed_unit)),
        }
    }

    /// The S word in force, whether the spindle turns or not.
    pub(super) fn ngc_spindle_speed(&self) -> f64 {
        match self.modal.meaning(Group::SurfaceSpeed) {
            Meaning::SurfaceSpeed => self.technology.surface_speed.unwrap_or(0.0),
            _ => self.technology.speed.unwrap_or(0.0),
        }
    }

    /// How moves join. G61 rests only where the path cannot be run through exactly (LinuxCNC, G61); G61.1 at every
    /// end.
    pub(super) fn ngc_path(&self) -> PathMode {
        match self.modal.meaning(Group::PathControl) {
            Meaning::ExactStop => PathMode::ExactStop,
            Meaning::ExactPath => PathMode::ContinuousWithin(0.0),
            _ => self.ngc.tolerance.map_or(PathMode::Continuous, PathMode::ContinuousWithin),
        }
    }

    /// Refuses a machine position that no machine has.
    pub(super) fn ngc_check_reach(&self, machine: Position) -> Fallible<()> {
        match machine.0.iter().all(|c| c.abs() <= LARGEST_COORDINATE) {
            true => Ok(()),
            false => Err(self.alarm(Fault::CoordinateTooLarge, self.words.block_span())),
        }
    }

    /// Positions to a programmed point, and on into the next move as G61 and G64 say.
    pub(super) fn ngc_rapid(&mut self, to: Position) -> Fallible<()> {
        self.ngc_rapid_in(to, self.ngc_path())
    }

    /// Positions to a programmed point without leaving the path: cycles are in exact path mode (LinuxCNC, G81 and on).
    pub(super) fn ngc_rapid_exactly(&mut self, to: Position) -> Fallible<()> {
        self.ngc_rapid_in(to, PathMode::ON_PATH)
    }

    fn ngc_rapid_in(&mut self, to: Position, path: PathMode) -> Fallible<()> {
        let machine = self.ngc.machine_of(to);
        self.ngc_check_reach(machine)?;
        self.ngc.at = to;
        if machine != self.location.machine || self.output.takes_still_moves() {
            self.location.machine = machine;
            self.emit(Op::Rapid { to: machine, straight: true, speed: None, path });
        }
        Ok(())
    }

    /// Cuts straight to a programmed point.
    pub(super) fn ngc_cut(&mut self, to: Position) -> Fallible<()> {
        self.ngc_cut_in(to, self.ngc_path())
    }

    /// Cuts straight to a programmed point and comes to rest there.
    pub(super) fn ngc_cut_exactly(&mut self, to: Position) -> Fallible<()> {
        self.ngc_cut_in(to, PathMode::ExactStop)
    }

    fn ngc_cut_in(&mut self, to: Position, path: PathMode) -> Fallible<()> {
        let machine = self.ngc.machine_of(to);
        self.ngc_check_reach(machine)?;
        let mut feed = self.ngc_feed()?;
        if self.ngc.feed_unit != 1.0
            && let Feed::PerMinute(degrees) | Feed::PerRevolution(degrees) = &mut feed
            && Axis::ALL.into_iter().all(|axis| !axis.is_linear() || to[axis] == self.ngc.at[axis])
        {
            // Where nothing but rotary axes moves it is degrees.
            *degrees = self.ngc.feed;
        }
        self.ngc.at = to;
        if machine != self.location.machine || self.output.takes_still_moves() {
            self.location.machine = machine;
            self.emit(Op::Feed { to: machine, feed, path });
        }
        Ok(())
    }
}
