//! Borings whose tool may be moved off the wall with the spindle at an angle (Fagor 1.7, 4.9, 4.10).

use super::tool::{Act, Take, Tool};
use ferrocut_geometry::Turn;

/// A bore. Levels are coordinates of the tool axis, mm.
#[derive(Clone, Copy, PartialEq, Debug)]
pub struct Bore {
    /// Where rapid ends and boring begins.
    pub reference: f64,
    /// Where it ends.
    pub bottom: f64,
    /// Where the tool returns to.
    pub top: f64,
    /// Pause at the bottom, s.
    pub dwell: f64,
    /// Feed.
    pub feed: f64,
    /// Sense of the spindle while it bores.
    pub turn: Turn,
    /// How tool and spindle go in and out.
    pub way: Way,
}

/// How a boring tool goes in and out.
#[derive(Clone, Copy, PartialEq, Debug)]
pub enum Way {
    /// Out at feed, turning, to this level, and on at rapid.
    OutAtFeed(f64),
    /// Out at rapid, stopped.
    OutStopped,
    /// Out at rapid, stopped at an angle and moved off the wall.
    OutAside {
        /// The move.
        aside: Aside,
        /// Level on which it is moved back.
        back_at: f64,
    },
    /// In at feed, stopped at an angle and moved off the wall; out at rapid, turning.
    InAside(Aside),
}

/// A move off the wall.
#[derive(Clone, Copy, PartialEq, Debug)]
pub struct Aside {
    /// Angle of the spindle, degrees; none, and the tool is not moved either.
    pub angle: Option<f64>,
    /// Along abscissa and ordinate, mm.
    pub by: [f64; 2],
}

impl Bore {
    /// Bores where the tool stands: in a frame without turn about that place.
    pub fn bore<T: Take>(&self, tool: &mut Tool<'_, T>) -> Result<(), T::Error> {
        tool.set_feed(self.feed);
        if let Way::InAside(aside) = self.way {
            tool.act(Act::Stop)?;
            tool.rapid_z(self.reference)?;
            aside.orient(tool)?;
            tool.feed_z(self.bottom)?;
            tool.rapid([0.0; 2])?;
            tool.dwell(self.dwell)?;
            tool.act(Act::Start(self.turn))?;
            return tool.rapid_z(self.top);
        }
        tool.rapid_z(self.reference)?;
        tool.feed_z(self.bottom)?;
        tool.dwell(self.dwell)?;
        match self.way {
            Way::OutAtFeed(level) => {
                tool.feed_z(level)?;
                tool.rapid_z(self.top)
            }
            Way::OutStopped => {
                tool.act(Act::Stop)?;
                tool.rapid_z(self.top)?;
                tool.act(Act::Start(self.turn))
            }
            Way::OutAside { aside, back_at } => {
                tool.act(Act::Stop)?;
                aside.orient(tool)?;
                tool.rapid_z(back_at)?;
                tool.rapid([0.0; 2])?;
                tool.act(Act::Start(self.turn))?;
                tool.rapid_z(self.top)
            }
            Way::InAside(_) => Ok(()),
        }
    }
}

impl Aside {
    fn orient<T: Take>(&self, tool: &mut Tool<'_, T>) -> Result<(), T::Error> {
        let Some(angle) = self.angle else { return Ok(()) };
        tool.act(Act::Orient(angle))?;
        tool.rapid(self.by)
    }
}
