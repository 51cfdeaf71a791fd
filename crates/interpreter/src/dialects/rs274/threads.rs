//! Moves in step with the spindle (LinuxCNC, G33, G33.1, G76).

use crate::Fallible;
use crate::interpreter::Interpreter;
use ferrocut_geometry::{Axis, AxisSet, Position};
use ferrocut_machine::Fault;

/// Most passes of a thread: what needs more is a slip of the pen.
const MOST_PASSES: u32 = 10_000;

/// A thread that is cut in passes. Lengths in mm; X is the axis of the depth, Z that of the thread.
struct Thread {
    /// Where the tool stands before the thread, and returns to after each pass.
    drive: Position,
    /// +1 outside, where depth lies towards minus, −1 inside.
    outward: f64,
    /// From the drive line to the crest.
    crest: f64,
    /// Depth of the whole thread below the crest.
    full: f64,
    /// Depths grow with this power of the number of the pass.
    growth: f64,
    /// Tangent of the angle along which the tool goes deeper, with the sign of the way.
    slope: f64,
    /// Length of a tapered end with the sign of the way, and which ends have one.
    taper: f64,
    tapers_in: bool,
    tapers_out: bool,
    end: f64,
    pitch: f64,
    rpm: f64,
}

impl Interpreter {
    /// G33: straight, so far a turn as K says. G33.1: there, and back with the spindle reversed.
    pub(super) fn ngc_synchronised(&mut self, axes: AxisSet, returns: bool) -> Fallible<()> {
        if self.output.in_cutter_mode() {
            return Err(self.ngc_alarm(Fault::NotInCutter));
        }
        let Some(pitch) = self.ngc_length_word(b'K') else {
            return Err(self.ngc_missing(b'K'));
        };
        self.ngc_turning()?;
        let rpm = self.technology.speed.unwrap_or(0.0);
        let (from, to) = (self.ngc.at, self.ngc_end_point(axes));
        self.ngc_tap(to, pitch, rpm)?;
        if returns {
            // I is how much faster the spindle turns on the way back.
            let faster = self.words.get(b'I').filter(|i| *i > 0.0).unwrap_or(1.0);
            self.ngc_tap(from, pitch, rpm * faster)?;
        }
        Ok(())
    }

    /// G76: a thread along Z in passes, each deeper on the side of X.
    pub(super) fn ngc_thread(&mut self, axes: AxisSet) -> Fallible<()> {
        if self.output.in_cutter_mode() {
            return Err(self.ngc_alarm(Fault::NotInCutter));
        }
        let word = |letter| self.ngc_length_word(letter).ok_or_else(|| self.ngc_missing(letter));
        let (pitch, crest, first, full) = (word(b'P')?, word(b'I')?, word(b'J')?, word(b'K')?);
        self.ngc_turning()?;
        if !(crest != 0.0 && first > 0.0 && full > first) {
            return Err(self.ngc_alarm(Fault::ThreadDepths));
        }
        let (drive, to) = (self.ngc.at, self.ngc_end_point(axes));
        let way = if to[Axis::Z] > drive[Axis::Z] { -1.0 } else { 1.0 };
        let slope = self.words.get(b'Q').unwrap_or(0.0).to_radians().tan() * way;
        let taper = self.ngc_length_word(b'E').unwrap_or(0.0).max(0.0) * way;
        let ends = self.words.get(b'L').unwrap_or(0.0).max(0.0) as u32;
        let thread = Thread {
            drive,
            outward: if crest > 0.0 { -1.0 } else { 1.0 },
            crest: crest.abs(),
            full,
            growth: 1.0 / self.words.get(b'R').unwrap_or(1.0).max(1.0),
            slope,
            taper,
            tapers_in: ends & 1 != 0,
            tapers_out: ends & 2 != 0,
            end: to[Axis::Z] + full * slope,
            pitch,
            rpm: self.technology.speed.unwrap_or(0.0),
        };
        let spring = self.words.get(b'H').unwrap_or(0.0).max(0.0);
        let passes = (full / first).powf(1.0 / thread.growth);
        if !(passes + spring <= f64::from(MOST_PASSES)) {
            let alarm = self.alarm_at(Fault::WordOutOfRange, b'J');
            return Err(Box::new(alarm.with("min", 0.0).with("max", full)));
        }
        let mut depth = first;
        for pass in 2..=MOST_PASSES {
            // From the drive line, so that rounding does not make a pass of a pass at full depth (LinuxCNC).
            if thread.crest + depth >= thread.crest + full {
                break;
            }
            self.ngc_thread_pass(&thread, depth)?;
            depth = first * f64::from(pass).powf(thread.growth);
        }
        for _ in 0..=spring as u32 {
            self.ngc_thread_pass(&thread, full)?;
        }
        self.ngc_rapid_exactly(to)
    }

    /// One pass at a depth below the crest: back to the start, in, along the thread, out.
    fn ngc_thread_pass(&mut self, thread: &Thread, depth: f64) -> Fallible<()> {
        let Thread { drive, outward, crest, full, taper, pitch, rpm, .. } = *thread;
        let along = depth * thread.slope;
        let at = |below: f64, z: f64| {
            let mut point = drive;
            point[Axis::X] -= outward * below;
            point[Axis::Z] = z - along;
            point
        };
        let bottom = crest + depth;
        // The tool keeps the distance of the full depth from the drive line.
        let away = depth - full;
        let is_tapered = taper != 0.0;
        let steeper = if is_tapered { pitch * taper.hypot(full) / taper.abs() } else { pitch };
        let (start, end) = (drive[Axis::Z], thread.end);
        self.ngc_rapid_exactly(at(away, start))?;
        if is_tapered && thread.tapers_in {
            self.ngc_tap(at(bottom - full, start), steeper, rpm)?;
            self.ngc_tap(at(bottom, start - taper), steeper, rpm)?;
        } else {
            self.ngc_rapid_exactly(at(bottom, start))?;
        }
        if is_tapered && thread.tapers_out {
            self.ngc_tap(at(bottom, end + taper), pitch, rpm)?;
            self.ngc_tap(at(bottom - full, end), steeper, rpm)?;
        } else {
            self.ngc_tap(at(bottom, end), pitch, rpm)?;
        }
        self.ngc_rapid_exactly(at(away, end))
    }

    /// A move in step with the spindle, which M3 or M4 keeps turning behind it (LinuxCNC, G33).
    fn ngc_tap(&mut self, to: Position, pitch: f64, rpm: f64) -> Fallible<()> {
        let machine = self.ngc.machine_of(to);
        self.ngc_check_reach(machine)?;
        self.ngc.at = to;
        self.tap_machine(machine, pitch, rpm, true);
        Ok(())
    }
}
