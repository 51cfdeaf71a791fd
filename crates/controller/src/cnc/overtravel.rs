//! Travel switches: an axis that comes onto one brings all to rest with an alarm. It leaves it by hand, while the
//! overtravel release is held, and only backwards (GSK990MC part 2, 2.5.1 and 2.5.3).
//!
//! Limits of axes moved by hand: one that is to go on over a software limit, or into an area that is forbidden, stands
//! there with an alarm, which moving it back ends (2.5.2, 2.6).

use super::{Cnc, State};
use crate::manual::JogWay;
use crate::supervision::ON_LIMIT;
use ferrocut_geometry::{AXES, Axis, AxisSet, Position};
use ferrocut_machine::{Alarm, Fault};

/// Way in a period that is no motion, mm.
const STANDS: f64 = 1e-9;

/// An axis that was to go on over a limit.
#[derive(Clone, Copy, PartialEq, Debug)]
struct CutShort {
    upper: bool,
    /// Where it stands.
    at: f64,
}

/// What the travel switches say, and the key.
#[derive(Clone, Copy, Debug, Default)]
pub(super) struct Overtravel {
    above: AxisSet,
    below: AxisSet,
    /// Ways that axes moved by hand may not go.
    no_plus: AxisSet,
    no_minus: AxisSet,
    /// The release is held.
    released: bool,
    /// Where the axes were to be a period ago.
    before: Position,
    /// No alarms of them (GSK990MC 61#6).
    ignored: bool,
    cut_short: [Option<CutShort>; AXES],
    /// Axes that the alarm of the switches is of: on the upper one, on the lower one.
    alarmed: (AxisSet, AxisSet),
}

impl Overtravel {
    pub fn new(ignored: bool) -> Overtravel {
        Overtravel { ignored, ..Overtravel::default() }
    }

    fn is_clear(&self) -> bool {
        self.released || self.ignored || self.above.is_empty() && self.below.is_empty()
    }

    /// Whether an axis may not go that way by hand.
    fn blocks(&self, axis: Axis, upwards: bool) -> bool {
        let (forbidden, switch) =
            if upwards { (self.no_plus, self.above) } else { (self.no_minus, self.below) };
        forbidden.contains(axis) || !self.ignored && switch.contains(axis)
    }
}

impl Cnc {
    /// The overtravel release is held or let go. Held, an axis on its travel switch may be moved back by hand, which
    /// ends the alarm.
    pub fn release_overtravel(&mut self, held: bool) {
        self.overtravel.released = held;
    }

    /// The axes that may not be moved upwards or downwards by hand, as long as that is not taken back: those under way
    /// come to rest.
    pub fn forbid_by_hand(&mut self, upwards: AxisSet, downwards: AxisSet) {
        (self.overtravel.no_plus, self.overtravel.no_minus) = (upwards, downwards);
        if self.manual.is_active && !self.homing.is_active() && !self.returns() {
            self.brake_blocked();
        }
    }

    /// Axes that move by hand on a way that they may not go come to rest.
    fn brake_blocked(&mut self) {
        for axis in self.machine_axes.iter() {
            let velocity = self.manual.velocity(axis);
            if velocity != 0.0 && self.overtravel.blocks(axis, velocity > 0.0) {
                self.manual.drive(axis, 0.0);
            }
        }
    }

    /// Whether the release keeps a switch from being an alarm: where axes are moved by hand, or nothing moves them. A
    /// program, the way back to it and homing end on a switch all the same.
    fn acts_release(&self) -> bool {
        // What is sent line by line waits for more, or jogs in lines.
        let by_hand =
            self.manual.is_active || !self.is_under_way() || self.is_jogging() || self.awaits_work();
        self.overtravel.released && by_hand && !self.homing.is_active() && !self.returns()
    }

    /// Looks at the travel switches, once a period.
    pub(super) fn watch_switches(&mut self) {
        let switches = self.switches();
        let (above, below) = (switches.above.and(self.machine_axes), switches.below.and(self.machine_axes));
        (self.overtravel.above, self.overtravel.below) = (above, below);
        let at = self.motion.position();
        let before = std::mem::replace(&mut self.overtravel.before, at);
        // A jog in lines brings an axis back from its switch, and ends where it leads one on.
        let leads_on = |axis: Axis| {
            let way = at[axis] - before[axis];
            above.contains(axis) && way > STANDS || below.contains(axis) && way < -STANDS
        };
        let jogs_on = self.is_jogging() && self.machine_axes.iter().any(leads_on);
        if above.is_empty() && below.is_empty() {
            return;
        }
        if self.overtravel.ignored || self.acts_release() && !jogs_on {
            // The release lets an axis go back, not on.
            self.brake_blocked();
        } else if !matches!(self.state, State::Alarmed(_)) && self.failed.is_none() {
            let upper = above.iter().next();
            let Some(axis) = upper.or(below.iter().next()) else { return };
            let alarm = self.axis_alarm(Fault::HardLimit, axis, upper.is_some());
            let alarm = alarm.with("side", if upper.is_some() { "+" } else { "-" });
            self.come_to_rest();
            self.failed = Some(Box::new(alarm));
            self.overtravel.alarmed = (above, below);
        }
    }

    /// The axes that the alarm of the travel switches is of, which may be moved back by hand while the release is held.
    pub fn leaves_switch(&self) -> AxisSet {
        let (above, below) = self.overtravel.alarmed;
        let of_them = |axis: &Axis| above.contains(*axis) || below.contains(*axis);
        match self.overtravel.released {
            true => self.machine_axes.iter().filter(of_them).collect(),
            false => AxisSet::EMPTY,
        }
    }

    /// Whether the axes that the alarm of the travel switches is of have left them. While the release is held the ladder may
    /// tell of a switch by the way alone that it keeps shut.
    pub fn has_left_switches(&self) -> bool {
        let (above, below) = self.overtravel.alarmed;
        let stays = above.iter().any(|axis| self.overtravel.blocks(axis, true))
            || below.iter().any(|axis| self.overtravel.blocks(axis, false));
        !stays && !matches!(self.state, State::Alarmed(_) | State::Resetting)
    }

    /// Axes moved by hand that stand at a limit although they were to go on, and at which: the upper ones have `true`.
    pub fn cut_short(&self) -> impl Iterator<Item = (Axis, bool)> {
        let axes = Axis::ALL.into_iter().zip(self.overtravel.cut_short);
        axes.filter_map(|(axis, cut)| cut.map(|cut| (axis, cut.upper)))
    }

    /// Nobody needs to know of them any more.
    pub fn forget_cut_short(&mut self) {
        self.overtravel.cut_short = [None; AXES];
    }

    /// The alarm of an axis that stands at a limit: of its software limits, or of an area that is forbidden.
    pub fn cut_short_alarm(&self, axis: Axis, upper: bool) -> Alarm {
        let at = self.place_by_hand();
        let (least, most) = self.manual.travel(axis).unwrap_or((f64::NEG_INFINITY, f64::INFINITY));
        let (low, high) = self.interpreter.stroke_room(axis, at, AxisSet::EMPTY, false);
        let (low, high) = (low.max(least), high.min(most));
        let (limit, is_on_it) = match upper {
            true => (high, at[axis] >= high - ON_LIMIT),
            false => (low, at[axis] <= low + ON_LIMIT),
        };
        match is_on_it {
            true => {
                let alarm = self.axis_alarm(Fault::SoftLimit, axis, upper);
                alarm.with("position", at[axis]).with("limit", limit)
            }
            false => Alarm::new(
                self.interpreter.dialect().alarm_id(Fault::StoredStroke),
                Fault::StoredStroke,
                self.span,
            ),
        }
    }

    /// Notes axes that stand at a limit although they were to go on by hand.
    pub(super) fn note_cut_short(&mut self) {
        if self.homing.is_active() || self.returns() {
            return;
        }
        for (axis, cut) in Axis::ALL.into_iter().zip(&mut self.overtravel.cut_short) {
            if let Some(upper) = self.manual.is_cut_short(axis) {
                *cut = Some(CutShort { upper, at: self.manual.at(axis) });
            }
        }
    }

    /// An axis that is elsewhere than at its limit is there no more.
    pub(super) fn watch_cut_short(&mut self, at: &Position) {
        for (axis, cut) in Axis::ALL.into_iter().zip(&mut self.overtravel.cut_short) {
            *cut = cut.filter(|cut| (cut.at - at[axis]).abs() <= ON_LIMIT);
        }
    }

    /// The alarm of axes that stand in a forbidden area.
    pub fn stroke_alarm_here(&self) -> Option<Box<Alarm>> {
        self.interpreter.stroke_alarm_at(self.place_by_hand())
    }

    /// Whether an alarm stands during which axes are moved back by hand: off a travel switch, or out of a forbidden area.
    pub(super) fn may_be_moved_back(&self) -> bool {
        let State::Alarmed(alarm) = &self.state else { return false };
        match alarm.fault {
            Fault::HardLimit => self.overtravel.is_clear(),
            Fault::StoredStroke => self.stroke_alarm_here().is_some(),
            _ => false,
        }
    }

    /// What becomes of a key that leads an axis onto its switch.
    pub(super) fn off_switch(&self, axis: Axis, way: JogWay) -> JogWay {
        let blocked = match way {
            JogWay::Plus => self.overtravel.blocks(axis, true),
            JogWay::Minus => self.overtravel.blocks(axis, false),
            JogWay::Stop => false,
        };
        if blocked { JogWay::Stop } else { way }
    }

    /// Steps or counts that do not lead an axis onto its switch.
    pub(super) fn steps_off_switch(&self, axis: Axis, steps: i64, increment: f64) -> i64 {
        let upwards = (steps > 0) == (increment > 0.0);
        if steps != 0 && self.overtravel.blocks(axis, upwards) { 0 } else { steps }
    }
}
