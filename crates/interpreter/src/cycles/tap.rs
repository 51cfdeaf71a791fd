//! Tapping cycles (GSK990MC 4.4.5, 4.5; Kaitong appendix 7, 2.2 and 2.7).
//!
//! Rigid tapping makes feed and spindle one motion. Its pitch is F/S (G94) or F (G95), or where the control
//! has it so, F itself. Else the tap sits in a floating holder and the spindle is reversed at the bottom.

use super::{CycleKind, Tapping};
use crate::Fallible;
use crate::interpreter::Interpreter;
use ferrocut_geometry::{Axis, MM_PER_INCH, Position, SAME_POINT_MM, Turn};
use ferrocut_machine::Fault;
use ferrocut_toolpath::{Feed, Op, PathMode, SpindleState};

/// A thread cut in steps. A step ends with a draw-back (high-speed) or at the R level (standard), by
/// 44#5 of the GSK990MC.
struct Steps {
    depth: f64,
    retract: f64,
    are_fast: bool,
}

impl Interpreter {
    /// Taps one hole.
    pub(super) fn tap(&mut self, left: bool) -> Fallible<()> {
        let Some((r, z)) = self.levels()? else { return Ok(()) };
        if z >= r {
            return Err(self.level_alarm(Fault::CycleDepthAboveR));
        }
        let speed = self.technology.speed.unwrap_or(0.0);
        // F belongs to the S of the program, however much of it the spindle turns at.
        let rpm = self.held_speed(speed);
        let Tapping::Feed { rigid_speeds, rigid_retract, rigid_orients, steps_are_fast, retract, .. } =
            self.rules.cycles.tapping
        else {
            return match self.rules.cycles.tapping {
                Tapping::Floating => {
                    self.position_over_hole()?;
                    self.approach(r)?;
                    self.tap_floating(r, z, None, left)?;
                    self.rapid_z(self.top(r))
                }
                _ => self.tap_by_pitch(r, z, rpm, left),
            };
        };
        let steps = self.cycle.q.filter(|q| *q > 0.0).map(|depth| Steps {
            depth,
            retract: self.cycle.v.unwrap_or(retract),
            are_fast: steps_are_fast,
        });
        if let Some(steps) = &steps {
            self.check_pecks(r - z, steps.depth)?;
        }
        let rigid = self.taps_rigidly();
        // S is a gear then, of which no pitch can be made (GSK990MC 6.2).
        if rigid {
            self.check_orients()?;
        }
        let limit = if rigid { rigid_speeds.limit(rpm) } else { self.rules.cycles.max_tapping_rpm };
        if rpm <= 0.0 || rpm > limit {
            return Err(self.alarm(Fault::TappingSpeed, self.cycle_span()));
        }
        if rigid && !self.feed_was_given() {
            return Err(self.alarm(Fault::TappingFeed, self.cycle_span()));
        }
        self.position_over_hole()?;
        self.approach(r)?;
        if rigid {
            if rigid_orients {
                self.emit(Op::Orient(0.0));
            }
            // The spindle is an axis of the tapping from here on, and stands still after it (4.5.1).
            self.technology.spindle = SpindleState::Off;
            let pitch = match self.feed()? {
                Feed::PerMinute(feed) | Feed::Held { programmed: feed, .. } => feed / speed,
                Feed::PerRevolution(feed) => feed,
                Feed::Duration(_) => 0.0,
            };
            let rpm = self.rpm_of_thread(pitch, rpm);
            let pitch = if left { -pitch } else { pitch };
            // Faster by its override, but no faster than the spindle may be.
            let out_rpm = (rpm * rigid_retract).min(limit);
            self.tap_strokes(r, z, steps, |interpreter, z| {
                let down = z < interpreter.location.programmed[Axis::Z];
                interpreter.tap_z(z, pitch, if down { rpm } else { out_rpm })
            })?;
        } else {
            if let Ok(Feed::Held { programmed, at }) = self.feed()
                && programmed > at
            {
                self.tell_feed_held(programmed, None);
            }
            self.tap_floating(r, z, steps, left)?;
        }
        self.rapid_z(self.top(r))
    }

    /// The speed at which a rigid thread is cut. F beyond P96 counts as P96 (GSK990MC 4.4.5, 4.5.1), and the pitch is F/S all
    /// the same: the spindle, an axis of the tapping, turns as much slower. The manual does not say so; a thread of another
    /// pitch is never meant, and Fanuc refuses the block.
    fn rpm_of_thread(&mut self, pitch: f64, rpm: f64) -> f64 {
        let feed = pitch * rpm;
        // The pitch is a quotient that was rounded.
        if feed <= self.rules.max_feed * (1.0 + 1e-9) {
            return rpm;
        }
        let held = self.rules.max_feed / pitch;
        self.tell_feed_held(feed, Some(held));
        held
    }

    /// Tells a check of a tapping whose `feed` in mm/min is held at the highest one, and the speed of a spindle that follows;
    /// once for all holes that are cut so.
    fn tell_feed_held(&mut self, feed: f64, rpm: Option<f64>) {
        if self.cycle.told.replace((feed, rpm)) == Some((feed, rpm)) {
            return;
        }
        let span = if self.words.has(b'F') { self.words.span(b'F') } else { self.cycle_span() };
        let warning = self.alarm(Fault::TappingFeedHeld, span);
        let warning = warning.with("feed", feed).with("limit", self.rules.max_feed);
        self.tell(match rpm {
            Some(rpm) => warning.with("speed", rpm),
            None => warning,
        });
    }

    /// Whether tapping cycles that are fed by F are rigid now.
    pub(super) fn taps_rigidly(&self) -> bool {
        self.technology.rigid_tapping
            && matches!(self.rules.cycles.tapping, Tapping::Feed { rigid: true, .. })
    }

    /// Whether a feed of the kind in force was ever programmed.
    fn feed_was_given(&self) -> bool {
        match self.modal.is_feed_per_revolution() {
            true => self.technology.feed_per_revolution > 0.0,
            false => self.technology.feed_per_minute_was_given,
        }
    }

    /// A tap whose pitch is programmed itself. The spindle turns into the thread before and after it.
    fn tap_by_pitch(&mut self, r: f64, z: f64, rpm: f64, left: bool) -> Fallible<()> {
        if rpm <= 0.0 || rpm > self.rules.cycles.max_tapping_rpm {
            return Err(self.alarm(Fault::TappingSpeed, self.cycle_span()));
        }
        let Some(pitch) = self.technology.tap_pitch else {
            return Err(self.alarm(Fault::TappingPitchMissing, self.cycle_span()));
        };
        let pitch = if left { -pitch } else { pitch };
        self.position_over_hole()?;
        self.approach(r)?;
        let (inward, _) = self.tap_turns(left);
        self.spindle(inward);
        self.tap_strokes(r, z, None, |interpreter, z| interpreter.tap_z(z, pitch, rpm))?;
        self.rapid_z(self.top(r))
    }

    /// Whether F and I of the block are those of a thread.
    pub(crate) fn is_pitch_block(&self) -> bool {
        let by_pitch = matches!(self.rules.cycles.tapping, Tapping::Pitch { .. });
        by_pitch && matches!(self.cycle_kind(), Some(CycleKind::Tap { .. }))
    }

    /// F in mm, also with G20, or I in threads per inch (Kaitong appendix 7, 2.2).
    pub(crate) fn pitch_words(&mut self) -> Fallible<()> {
        let Tapping::Pitch { pitch, threads } = self.rules.cycles.tapping else { return Ok(()) };
        let (letter, value, (min, max)) = match (self.words.get(b'F'), self.words.get(b'I')) {
            (None, None) => return Ok(()),
            (Some(_), Some(_)) => return Err(self.alarm_at(Fault::TappingPitchTwice, b'I')),
            (Some(mm), None) => (b'F', mm, pitch),
            (None, Some(per_inch)) => (b'I', per_inch, threads),
        };
        if !(min..=max).contains(&value) {
            let alarm = self.alarm_at(Fault::WordOutOfRange, letter);
            return Err(Box::new(alarm.with("min", min).with("max", max)));
        }
        self.technology.tap_pitch = Some(if letter == b'F' { value } else { MM_PER_INCH / value });
        Ok(())
    }

    /// The strokes of a tap, in one go or in steps. `stroke` moves to a level, up or down.
    fn tap_strokes(
        &mut self,
        r: f64,
        z: f64,
        steps: Option<Steps>,
        mut stroke: impl FnMut(&mut Interpreter, f64) -> Fallible<()>,
    ) -> Fallible<()> {
        if let Some(steps) = steps {
            let mut depth = r - steps.depth;
            while depth > z + SAME_POINT_MM {
                stroke(self, depth)?;
                let back = (depth + steps.retract).min(r);
                if !steps.are_fast {
                    stroke(self, r)?;
                }
                stroke(self, back)?;
                depth -= steps.depth;
            }
        }
        stroke(self, z)?;
        self.cycle_dwell();
        stroke(self, r)?;
        self.cycle_dwell();
        Ok(())
    }

    /// A rigid stroke.
    fn tap_z(&mut self, z: f64, pitch: f64, rpm: f64) -> Fallible<()> {
        let mut to = self.location.programmed;
        to[Axis::Z] = z;
        self.tap_at(to, pitch, rpm)
    }

    /// Moves to a programmed point in step with the spindle.
    pub(super) fn tap_at(&mut self, to: Position, pitch: f64, rpm: f64) -> Fallible<()> {
        let machine = self.location.machine_of(to);
        self.check_reach(machine)?;
        self.location.programmed = to;
        self.tap_machine(machine, pitch, rpm, false);
        Ok(())
    }

    /// Moves to a machine point in step with the spindle; not at all to where the axes stand. The programmed
    /// point is the caller's to set. Whether the spindle `goes_on` turning behind the thread is the language's matter.
    pub(crate) fn tap_machine(&mut self, to: Position, pitch: f64, rpm: f64, goes_on: bool) {
        if to != self.location.machine {
            self.location.machine = to;
            self.emit(Op::Tap { to, pitch, rpm, goes_on });
        }
    }

    /// Tapping with a floating holder: the spindle turns into the thread and is reversed for the way
    /// out. A spindle at rest is started at the R level. Overrides and feed hold have no effect in the thread (GSK990MC
    /// 4.4.5), as in the mode of G63.
    fn tap_floating(&mut self, r: f64, z: f64, steps: Option<Steps>, left: bool) -> Fallible<()> {
        let (inward, outward) = self.tap_turns(left);
        self.tap_strokes(r, z, steps, |interpreter, z| {
            let down = z < interpreter.location.programmed[Axis::Z];
            interpreter.spindle(if down { inward } else { outward });
            let mut to = interpreter.location.programmed;
            to[Axis::Z] = z;
            interpreter.cut_as(to, PathMode::Tapping)
        })?;
        self.spindle(inward);
        Ok(())
    }

    /// The spindle into the thread and out of it.
    fn tap_turns(&self, left: bool) -> (SpindleState, SpindleState) {
        let speed = self.speed();
        let inward = if left { Turn::CounterClockwise } else { Turn::Clockwise };
        (SpindleState::turning(inward, speed), SpindleState::turning(inward.reversed(), speed))
    }
}
