//! Threads cut by a tap (Fagor 1.5, 4.6).

use super::parameter::{WrongParameter, refuse};
use super::tool::{Act, Take, Tool};
use ferrocut_geometry::Turn;
use ferrocut_machine::Fault;

/// A tapped hole. Levels are coordinates of the tool axis, mm.
#[derive(Clone, Copy, PartialEq, Debug)]
pub struct TappedHole {
    /// Where rapid ends and the thread begins.
    pub reference: f64,
    /// Where it ends.
    pub bottom: f64,
    /// Where the tool returns to.
    pub top: f64,
    /// Pause at the bottom with the spindle at rest, s.
    pub dwell: f64,
    /// Sense of the spindle into the thread.
    pub turn: Turn,
    /// How feed and spindle go together.
    pub holder: Holder,
}

/// How the tap is held.
#[derive(Clone, Copy, PartialEq, Debug)]
pub enum Holder {
    /// In a chuck that gives way: the spindle is reversed for the way out.
    Floating {
        /// Feed both ways.
        feed: f64,
    },
    /// Feed and spindle are one motion.
    Rigid {
        /// Travel a turn, mm, without the sign of the thread.
        pitch: f64,
        /// Speed into the thread, r/min.
        rpm: f64,
        /// What the speed out of it is of that.
        back: f64,
        /// The spindle is stopped at an angle before the cycle; else behind it.
        orients_first: bool,
    },
}

impl TappedHole {
    /// Whether feed, pitch and speeds are numbers that a spindle can turn by; of extreme ones quotient and
    /// product are none. `speed` is the parameter to blame.
    pub fn check(&self, speed: &'static str) -> Result<(), WrongParameter> {
        let numbers = match self.holder {
            Holder::Floating { feed } => [feed, feed],
            Holder::Rigid { pitch, rpm, back, .. } => [pitch, rpm * back],
        };
        refuse(numbers.iter().any(|n| !(*n > 0.0 && n.is_finite())), Fault::TappingSpeed, speed)
    }

    /// Cuts the thread where the tool stands. Spindle and plane are the caller's until then.
    pub fn tap<T: Take>(&self, tool: &mut Tool<'_, T>) -> Result<(), T::Error> {
        tool.rapid_z(self.reference)?;
        match self.holder {
            Holder::Floating { feed } => {
                tool.set_feed(feed);
                tool.feed_z(self.bottom)?;
                self.pause(tool)?;
                tool.act(Act::Start(self.turn.reversed()))?;
                tool.feed_z(self.reference)?;
                tool.act(Act::Start(self.turn))?;
            }
            Holder::Rigid { pitch, rpm, back, orients_first } => {
                let pitch = match self.turn {
                    Turn::Clockwise => pitch,
                    Turn::CounterClockwise => -pitch,
                };
                tool.tap_z(self.bottom, pitch, rpm)?;
                self.pause(tool)?;
                tool.tap_z(self.reference, pitch, rpm * back)?;
                if !orients_first {
                    tool.act(Act::Orient(0.0))?;
                }
            }
        }
        tool.rapid_z(self.top)
    }

    fn pause<T: Take>(&self, tool: &mut Tool<'_, T>) -> Result<(), T::Error> {
        if self.dwell <= 0.0 {
            return Ok(());
        }
        tool.act(Act::Stop)?;
        tool.dwell(self.dwell)
    }
}
