//! Canned cycles (LinuxCNC, G73 to G89), in every plane and along U, V, W.
//!
//! The words of a cycle stay in force, as they were programmed, as long as the same code does. The hole lies
//! between the level R and the bottom, the word of the axis square to the plane. The tool moves over it at the
//! level of return, or higher where it stands higher, and returns to that level: R with G99, with G98 the
//! one on which the cycles began, where that is higher.
//!
//! Holes are made one by one, so that no number of repeats fills the memory.

use crate::Fallible;
use crate::cycles::{CycleKind, HoleCycle, Peck, Retract};
use crate::dialect::{MCode, Meaning};
use crate::interpreter::Interpreter;
use crate::modal::Group;
use ferrocut_geometry::{Axis, AxisSet, MM_PER_INCH, Plane};
use ferrocut_machine::Fault;
use ferrocut_toolpath::{Dwell, Op, SpindleState};

/// How far above the last depth pecking goes on at feed, and how far it draws back to break chips, inches.
const PECK_GAP_INCH: f64 = 0.010;

/// Most pecks of a hole: what needs more is a slip of the pen.
const MOST_PECKS: f64 = 10_000.0;

/// Most repeats of a block.
const MOST_REPEATS: f64 = 1e9;

/// The program stop of G88, during which the operator draws the tool out.
const STOP: u32 = 0;

/// Words of cycles in force, in the units of the program, and the block being carried out.
#[derive(Clone, Debug, Default)]
pub(crate) struct Cycles {
    r: f64,
    bottom: f64,
    q: f64,
    /// Dwell, s.
    p: f64,
    /// I, J, K.
    shift: [f64; 3],
    /// The level on which the cycles began.
    initial: Option<f64>,
    block: Option<Block>,
}

/// A block whose holes are being made. Coordinates are those of the program, in its units.
#[derive(Clone, Copy, Debug)]
struct Block {
    kind: CycleKind,
    left: u32,
    axes: [Axis; 3],
    /// Where the hole is, and the way to the next.
    at: [f64; 2],
    step: [f64; 2],
    r: f64,
    bottom: f64,
    /// Level of return.
    clear: f64,
    /// Level that back boring cuts up to, and how far the tool moves aside for it.
    middle: f64,
    aside: [f64; 2],
    /// The stop of the block, which waits for the last hole.
    stop: Option<&'static MCode>,
}

impl Cycles {
    /// Whether holes of a block are still to be made.
    #[inline]
    pub(crate) fn has_holes_left(&self) -> bool {
        self.block.is_some()
    }

    /// Another motion code ends the cycles.
    #[inline]
    pub(super) fn end(&mut self) {
        self.initial = None;
    }

    /// Leaves out the holes still to be made.
    pub(super) fn drop_holes(&mut self) {
        self.block = None;
    }

    /// Lets a stop of the block wait for its last hole; false where it has none.
    pub(super) fn defer(&mut self, stop: &'static MCode) -> bool {
        match &mut self.block {
            Some(block) => {
                block.stop = Some(stop);
                true
            }
            None => false,
        }
    }
}

impl Interpreter {
    /// Axes of the plane, and the one square to it.
    fn ngc_plane_axes(&self) -> [Axis; 3] {
        match self.modal.meaning(Group::Plane) {
            Meaning::PlaneOfUvw(Plane::Xy) => [Axis::U, Axis::V, Axis::W],
            Meaning::PlaneOfUvw(Plane::Zx) => [Axis::W, Axis::U, Axis::V],
            Meaning::PlaneOfUvw(Plane::Yz) => [Axis::V, Axis::W, Axis::U],
            _ => {
                let plane = self.modal.plane();
                [plane.first(), plane.second(), plane.normal()]
            }
        }
    }

    /// A block of a cycle. `goes_on`: its code was in force before.
    pub(super) fn ngc_cycle(&mut self, kind: CycleKind, axes: AxisSet, goes_on: bool) -> Fallible<()> {
        self.ngc_feed()?;
        if self.modal.meaning(Group::FeedMode) == Meaning::InverseTime {
            return Err(self.ngc_alarm(Fault::CycleInverseTime));
        }
        if self.output.in_cutter_mode() {
            return Err(self.ngc_alarm(Fault::NotInCutter));
        }
        let plane_axes = self.ngc_plane_axes();
        let own: AxisSet = plane_axes.into_iter().collect();
        if let Some(foreign) = axes.iter().find(|axis| !own.contains(*axis)) {
            let alarm = self.alarm_at(Fault::CycleAxis, foreign.letter() as u8);
            return Err(Box::new(alarm.with("axis", foreign.letter().to_string())));
        }
        let [first, second, normal] = plane_axes;
        let unit = self.ngc_unit();
        let word = |axis: Axis| self.words.get(axis.letter() as u8);
        let here = plane_axes.map(|axis| self.ngc.at[axis] / unit);
        let repeats = self.words.get(b'L').unwrap_or(1.0);
        let (r_word, bottom_word) = match (self.words.get(b'R'), word(normal)) {
            (None, _) if !goes_on => return Err(self.ngc_missing(b'R')),
            (_, None) if !goes_on => {
                return Err(self.ngc_missing(normal.letter() as u8));
            }
            (r, bottom) => (r.unwrap_or(self.ngc.cycles.r), bottom.unwrap_or(self.ngc.cycles.bottom)),
        };
        if !(1.0..=MOST_REPEATS).contains(&repeats) {
            let alarm = self.alarm_at(Fault::WordOutOfRange, b'L');
            return Err(Box::new(alarm.with("min", 1.0).with("max", MOST_REPEATS)));
        }
        let initial = *self.ngc.cycles.initial.get_or_insert(here[2]);
        let incremental = self.modal.is_incremental();
        let (r, bottom, at, step) = if incremental {
            let r = r_word + initial;
            let step = [word(first).unwrap_or(0.0), word(second).unwrap_or(0.0)];
            (r, r + bottom_word, [here[0], here[1]], step)
        } else {
            let at = [word(first).unwrap_or(here[0]), word(second).unwrap_or(here[1])];
            (r_word, bottom_word, at, [0.0; 2])
        };
        if r < bottom {
            let alarm = self.ngc_alarm(Fault::CycleDepthAboveR);
            return Err(Box::new(alarm.with("depth", bottom * unit).with("r", r * unit)));
        }
        // Out of the part before anything else.
        if initial < r {
            self.ngc_cycle_rapid(plane_axes, [here[0], here[1], r])?;
        }
        let (middle, aside) = self.ngc_cycle_words(kind, plane_axes, bottom, goes_on)?;
        let returns_to_r = self.modal.meaning(Group::Return) == Meaning::ReturnR;
        let clear = if returns_to_r { r } else { initial.max(r) };
        (self.ngc.cycles.r, self.ngc.cycles.bottom) = (r_word, bottom_word);
        self.ngc.cycles.block = Some(Block {
            kind,
            left: repeats as u32,
            axes: plane_axes,
            at,
            step,
            r,
            bottom,
            clear,
            middle,
            aside,
            stop: None,
        });
        Ok(())
    }

    /// Takes up the words P, Q, I, J, K that a cycle needs when its code is new. Returns what those of back boring
    /// come to.
    fn ngc_cycle_words(
        &mut self,
        kind: CycleKind,
        axes: [Axis; 3],
        bottom: f64,
        goes_on: bool,
    ) -> Fallible<(f64, [f64; 2])> {
        let needs: &[u8] = match kind {
            _ if goes_on => &[],
            CycleKind::Hole(HoleCycle { peck: Peck::ChipBreak | Peck::Clear, .. }) => b"Q",
            CycleKind::Hole(HoleCycle { dwell: true, .. }) => b"P",
            CycleKind::BackBore => b"IJK",
            _ => &[],
        };
        if let Some(letter) = needs.iter().find(|letter| !self.words.has(**letter)) {
            return Err(self.ngc_missing(*letter));
        }
        if let Some(q) = self.words.get(b'Q') {
            self.ngc.cycles.q = q;
        }
        if let Some(p) = self.words.get(b'P') {
            self.ngc.cycles.p = p;
        }
        if kind != CycleKind::BackBore {
            return Ok((bottom, [0.0; 2]));
        }
        for (slot, letter) in self.ngc.cycles.shift.iter_mut().zip([b'I', b'J', b'K']) {
            *slot = self.words.get(letter).unwrap_or(*slot);
        }
        let [i, j, k] = self.ngc.cycles.shift;
        // I, J, K belong to X, Y, Z and to U, V, W.
        let [a, b, up] = axes.map(|axis| match axis {
            Axis::X | Axis::U => i,
            Axis::Y | Axis::V => j,
            _ => k,
        });
        Ok((if self.modal.is_incremental() { bottom + up } else { up }, [a, b]))
    }

    /// Makes the next hole of the block.
    pub(crate) fn ngc_next_hole(&mut self) -> Fallible<()> {
        let Some(mut block) = self.ngc.cycles.block else { return Ok(()) };
        self.flow.count_hole();
        if let Err(alarm) = self.ngc_hole(&mut block) {
            self.ngc.cycles.drop_holes();
            if !self.options.keep_going {
                return Err(alarm);
            }
            self.note(alarm);
            return Ok(());
        }
        block.left -= 1;
        if block.left > 0 {
            self.ngc.cycles.block = Some(block);
            return Ok(());
        }
        self.ngc.cycles.block = None;
        match block.stop {
            Some(stop) => self.ngc_stop(stop),
            None => Ok(()),
        }
    }

    fn ngc_hole(&mut self, block: &mut Block) -> Fallible<()> {
        let Block { axes, r, bottom, clear, middle, .. } = *block;
        // With polar words each hole lies as much further out and round as the one before.
        let turned = self.modal.is_incremental().then(|| self.ngc.polar.step(block.at)).flatten();
        let [a, b] = turned.unwrap_or([block.at[0] + block.step[0], block.at[1] + block.step[1]]);
        block.at = [a, b];
        let [_, _, normal] = axes;
        let level = self.ngc.at[normal] / self.ngc_unit();
        self.ngc_cycle_rapid(axes, [a, b, level.max(clear)])?;
        self.ngc_cycle_rapid(axes, [a, b, r])?;
        let over = |level: f64| [a, b, level];
        match block.kind {
            CycleKind::Hole(cycle) => {
                match cycle.peck {
                    Peck::None => {}
                    peck => self.ngc_pecks(block, peck == Peck::Clear)?,
                }
                let turning = match cycle.retract {
                    Retract::Rapid | Retract::Feed => SpindleState::Off,
                    _ => self.ngc_turning()?,
                };
                self.ngc_cycle_feed(axes, over(bottom))?;
                if cycle.dwell {
                    self.ngc_cycle_dwell();
                }
                match cycle.retract {
                    Retract::Rapid => self.ngc_cycle_rapid(axes, over(clear))?,
                    // With a pause all the way out (G89), without one to R (G85).
                    Retract::Feed => {
                        self.ngc_cycle_feed(axes, over(if cycle.dwell { clear } else { r }))?;
                        self.ngc_cycle_rapid(axes, over(clear))?;
                    }
                    Retract::ByHand => {
                        self.spindle(SpindleState::Off);
                        self.emit(Op::Stop(STOP));
                        self.spindle(turning);
                        // The operator has drawn the tool out.
                        self.ngc.at[normal] = clear * self.ngc_unit();
                    }
                    Retract::SpindleStopped | Retract::FeedSpindleStopped => {
                        self.spindle(SpindleState::Off);
                        self.ngc_cycle_rapid(axes, over(clear))?;
                        self.spindle(turning);
                    }
                }
            }
            CycleKind::Tap { left } => {
                let (inward, outward) = self.ngc_tap_turns(left)?;
                self.ngc_cycle_feed(axes, over(bottom))?;
                self.spindle(outward);
                self.ngc_cycle_dwell();
                self.ngc_cycle_feed(axes, over(clear))?;
                self.spindle(inward);
            }
            CycleKind::BackBore => {
                let turning = self.ngc_turning()?;
                let aside = |level: f64| [a + block.aside[0], b + block.aside[1], level];
                self.ngc_cycle_rapid(axes, aside(r))?;
                self.ngc_orient_aside();
                self.ngc_cycle_rapid(axes, aside(bottom))?;
                self.ngc_cycle_rapid(axes, over(bottom))?;
                self.spindle(turning);
                self.ngc_cycle_feed(axes, over(middle))?;
                self.ngc_cycle_feed(axes, over(bottom))?;
                self.ngc_orient_aside();
                self.ngc_cycle_rapid(axes, aside(bottom))?;
                self.ngc_cycle_rapid(axes, aside(clear))?;
                self.ngc_cycle_rapid(axes, over(clear))?;
                self.spindle(turning);
            }
            _ => return Err(self.ngc_alarm(Fault::NotSupported)),
        }
        Ok(())
    }

    /// All pecks but the last. Depths are sums, as those of LinuxCNC are.
    fn ngc_pecks(&mut self, block: &Block, clears: bool) -> Fallible<()> {
        let Block { axes, at: [a, b], r, bottom, .. } = *block;
        let q = self.ngc.cycles.q;
        if !(q > 0.0 && (r - bottom) / q <= MOST_PECKS) {
            let alarm = self.alarm_at(Fault::WordOutOfRange, b'Q');
            return Err(Box::new(alarm.with("min", 0.0).with("max", r - bottom)));
        }
        let gap = if self.modal.is_inch() { PECK_GAP_INCH } else { PECK_GAP_INCH * MM_PER_INCH };
        let mut depth = r - q;
        while depth > bottom {
            self.ngc_cycle_feed(axes, [a, b, depth])?;
            if clears {
                self.ngc_cycle_rapid(axes, [a, b, r])?;
            }
            self.ngc_cycle_rapid(axes, [a, b, depth + gap])?;
            depth -= q;
        }
        Ok(())
    }

    fn ngc_cycle_rapid(&mut self, axes: [Axis; 3], to: [f64; 3]) -> Fallible<()> {
        let unit = self.ngc_unit();
        let mut point = self.ngc.at;
        for (axis, value) in axes.into_iter().zip(to) {
            point[axis] = value * unit;
        }
        self.ngc_rapid_exactly(point)
    }

    /// Cuts with an exact stop at the end.
    fn ngc_cycle_feed(&mut self, axes: [Axis; 3], to: [f64; 3]) -> Fallible<()> {
        let unit = self.ngc_unit();
        let mut point = self.ngc.at;
        for (axis, value) in axes.into_iter().zip(to) {
            point[axis] = value * unit;
        }
        self.ngc_cut_exactly(point)
    }

    fn ngc_cycle_dwell(&mut self) {
        if self.ngc.cycles.p > 0.0 {
            self.emit(Op::Dwell(Dwell::Seconds(self.ngc.cycles.p)));
        }
    }

    /// What the spindle does; an alarm where it stands.
    pub(super) fn ngc_turning(&self) -> Fallible<SpindleState> {
        match self.technology.spindle {
            SpindleState::Off => Err(self.ngc_alarm(Fault::SpindleNotTurning)),
            turning => Ok(turning),
        }
    }

    /// The spindle into a thread and out of it. It must turn into it already.
    fn ngc_tap_turns(&self, left: bool) -> Fallible<(SpindleState, SpindleState)> {
        match (self.ngc_turning()?, left) {
            (inward @ SpindleState::Clockwise(speed), false) => {
                Ok((inward, SpindleState::CounterClockwise(speed)))
            }
            (inward @ SpindleState::CounterClockwise(speed), true) => {
                Ok((inward, SpindleState::Clockwise(speed)))
            }
            _ => Err(self.ngc_alarm(Fault::SpindleWrongWay)),
        }
    }

    fn ngc_orient_aside(&mut self) {
        self.technology.spindle = SpindleState::Off;
        self.emit(Op::Orient(0.0));
    }
}
