//! Holes along the tool axis: drilled, pecked, reamed (Fagor 1.2 to 1.4, 1.6, 4.2 to 4.4, 4.8).

use super::parameter::{WrongParameter, refuse};
use super::tool::{Act, Take, Tool};
use ferrocut_geometry::{SAME_POINT_MM, Turn};
use ferrocut_machine::Fault;

/// Most pecks of one hole; what needs more is a slip of the pen.
const MAX_PECKS: f64 = 10_000.0;

/// A hole. Levels are coordinates of the tool axis, mm.
#[derive(Clone, Copy, PartialEq, Debug)]
pub struct Hole {
    /// Where rapid ends and drilling begins.
    pub reference: f64,
    /// Where it ends.
    pub bottom: f64,
    /// Where the tool returns to.
    pub top: f64,
    /// Pecks; none for a hole in one go.
    pub pecks: Option<Pecks>,
    /// Pause at the bottom, s.
    pub dwell: f64,
    /// The way out.
    pub leave: Leave,
    /// Feed of drilling.
    pub feed: f64,
}

/// How the tool leaves a hole.
#[derive(Clone, Copy, PartialEq, Eq, Debug)]
pub enum Leave {
    /// At rapid.
    Rapid,
    /// At feed to the reference level, then at rapid.
    Feed,
    /// At rapid with the spindle stopped, which then turns this way again.
    Stopped(Turn),
}

/// Pecks. Distances are along the tool axis, mm.
#[derive(Clone, Copy, PartialEq, Debug)]
pub struct Pecks {
    /// Level that the first one counts from.
    pub surface: f64,
    /// The first one.
    pub first: f64,
    /// What each is of the one before.
    pub factor: f64,
    /// The smallest, where the factor is not 1.
    pub least: f64,
    /// How far the tool is drawn back.
    pub back: Back,
    /// How far above the last depth the way back at rapid ends.
    pub gap: f64,
}

/// How far a tool is drawn back after a peck.
#[derive(Clone, Copy, PartialEq, Debug)]
pub enum Back {
    /// To a level.
    To(f64),
    /// By a distance.
    By(f64),
    /// By a distance; after every so many to a level.
    ByAndTo {
        /// The distance.
        distance: f64,
        /// Every how many.
        every: u32,
        /// The level.
        level: f64,
    },
    /// To a level once the hole is as deep, before that to another.
    Once {
        /// The level.
        level: f64,
        /// The other.
        before: f64,
    },
}

impl Pecks {
    /// Whether these pecks can be made, by the names of their parameters.
    pub fn check(&self, step: &'static str, gap: &'static str) -> Result<(), WrongParameter> {
        refuse(!(self.first > 0.0 && self.first.is_finite()), Fault::CycleParameter, step)?;
        refuse(!(self.factor > 0.0 && self.factor.is_finite()), Fault::CycleParameter, "R")?;
        refuse(!(self.gap > 0.0 && self.gap.is_finite()), Fault::CycleParameter, gap)
    }
}

impl Hole {
    /// Whether the hole can be made.
    pub fn check(&self, step: &'static str) -> Result<(), WrongParameter> {
        let depth = (self.reference - self.bottom).abs();
        refuse(!(depth > 0.0 && depth.is_finite()), Fault::CycleNoDepth, step)?;
        let Some(pecks) = self.pecks else { return Ok(()) };
        let smallest = if pecks.factor < 1.0 { pecks.first.min(pecks.least) } else { pecks.first };
        refuse(!(depth / smallest <= MAX_PECKS), Fault::MillTooManyMoves, step)
    }

    /// Makes the hole where the tool stands.
    pub fn drill<T: Take>(&self, tool: &mut Tool<'_, T>) -> Result<(), T::Error> {
        tool.set_feed(self.feed);
        tool.rapid_z(self.reference)?;
        match &self.pecks {
            Some(pecks) => self.peck(pecks, tool)?,
            None => tool.feed_z(self.bottom)?,
        }
        tool.dwell(self.dwell)?;
        match self.leave {
            Leave::Rapid => tool.rapid_z(self.top),
            Leave::Feed => {
                tool.feed_z(self.reference)?;
                tool.rapid_z(self.top)
            }
            Leave::Stopped(turn) => {
                tool.act(Act::Stop)?;
                tool.rapid_z(self.top)?;
                tool.act(Act::Start(turn))
            }
        }
    }

    fn peck<T: Take>(&self, pecks: &Pecks, tool: &mut Tool<'_, T>) -> Result<(), T::Error> {
        // Depths below the surface of the first peck.
        let bottom = tool.height(pecks.surface, self.bottom);
        let (mut depth, mut step, mut made) = (pecks.first, pecks.first, 1u32);
        loop {
            if depth >= bottom - SAME_POINT_MM {
                return tool.feed_z(self.bottom);
            }
            let level = tool.above(pecks.surface, -depth);
            tool.feed_z(level)?;
            let back = match pecks.back {
                Back::To(level) => level,
                Back::By(distance) => tool.above(level, distance),
                Back::ByAndTo { every, level: to, .. } if made % every.max(1) == 0 => to,
                Back::ByAndTo { distance, .. } => tool.above(level, distance),
                Back::Once { level: to, .. } if tool.height(to, level) >= -SAME_POINT_MM => to,
                Back::Once { before, .. } => before,
            };
            // No way down is a way back: a level below the hole's present depth is not gone to.
            if tool.height(back, level) > 0.0 {
                tool.rapid_z(back)?;
            }
            let near = tool.above(level, pecks.gap);
            if tool.height(tool.z(), near) > 0.0 {
                tool.rapid_z(near)?;
            }
            (step, depth) = match pecks.factor == 1.0 {
                // Products and not sums, so that many pecks end where the drawing says.
                true => (step, pecks.first * f64::from(made + 1)),
                false => {
                    // The steps grow or shrink by themselves; the least is what is made of one.
                    let next = step * pecks.factor;
                    (next, depth + next.max(pecks.least))
                }
            };
            made = made.saturating_add(1);
        }
    }
}

#[cfg(test)]
mod tests {
    #![allow(clippy::unwrap_used, clippy::panic)]
    use super::*;
    use crate::cycles::tool::{Frame, up};

    fn levels(hole: Hole) -> Vec<String> {
        let mut out = Vec::new();
        let mut taker = |act: Act| {
            out.push(match act {
                Act::Rapid { to } => format!("rapid {}", (to[2] * 1e4).round() / 1e4),
                Act::Feed { to, feed } => format!("feed {} F{feed}", (to[2] * 1e4).round() / 1e4),
                other => format!("{other:?}"),
            });
            Ok::<(), ()>(())
        };
        let frame = Frame::new([0.0; 2], 0.0, Turn::CounterClockwise);
        hole.check("I").unwrap();
        hole.drill(&mut Tool::new(frame, [0.0, 0.0, 25.0], up(hole.bottom, hole.reference), &mut taker))
            .unwrap();
        out
    }

    const HOLE: Hole = Hole {
        reference: 1.0,
        bottom: -10.0,
        top: 1.0,
        pecks: None,
        dwell: 0.0,
        leave: Leave::Rapid,
        feed: 200.0,
    };
    const PECKS: Pecks =
        Pecks { surface: 0.0, first: 4.0, factor: 0.8, least: 3.0, back: Back::To(1.0), gap: 1.0 };

    #[test]
    fn pecks_shrink_to_the_least_and_the_last_takes_the_rest() {
        // 4, 3.2, then 2.56 raised to 3: -4 -7.2 -10.
        let back = Back::ByAndTo { distance: 3.0, every: 2, level: 1.0 };
        let made = levels(Hole { pecks: Some(Pecks { back, ..PECKS }), ..HOLE });
        let expected = [
            "rapid 1",
            "feed -4 F200",
            "rapid -1",
            "rapid -3",
            "feed -7.2 F200",
            "rapid 1",
            "rapid -6.2",
            "feed -10 F200",
            "rapid 1",
        ];
        assert_eq!(made, expected);
    }

    #[test]
    fn a_step_that_is_raised_to_the_least_grows_as_it_would() {
        // 2, 3 raised to 4, 4.5, 6.75, then the rest.
        let pecks = Pecks { first: 2.0, factor: 1.5, least: 4.0, back: Back::By(0.0), ..PECKS };
        let made = levels(Hole { bottom: -20.0, pecks: Some(pecks), ..HOLE });
        let feeds: Vec<_> = made.iter().filter(|act| act.starts_with("feed")).map(String::as_str).collect();
        let depths = ["feed -2 F200", "feed -6 F200", "feed -10.5 F200", "feed -17.25 F200", "feed -20 F200"];
        assert_eq!(feeds, depths);
    }

    #[test]
    fn upwards_is_the_same_upside_down() {
        let up = Hole { reference: -2.0, bottom: 8.0, top: -25.0, ..HOLE };
        assert_eq!(levels(up), ["rapid -2", "feed 8 F200", "rapid -25"]);
        let pecks = Pecks { surface: 0.0, first: 5.0, factor: 1.0, back: Back::By(2.0), ..PECKS };
        let made = levels(Hole { pecks: Some(pecks), ..up });
        assert_eq!(made, ["rapid -2", "feed 5 F200", "rapid 3", "rapid 4", "feed 8 F200", "rapid -25"]);
    }

    #[test]
    fn no_way_back_leads_deeper_and_no_approach_upwards() {
        let pecks = Pecks { factor: 1.0, first: 6.0, back: Back::To(-8.0), ..PECKS };
        let made = levels(Hole { pecks: Some(pecks), ..HOLE });
        assert_eq!(made, ["rapid 1", "feed -6 F200", "feed -10 F200", "rapid 1"]);
        let near = Pecks { back: Back::By(0.5), ..pecks };
        let made = levels(Hole { pecks: Some(near), ..HOLE });
        assert_eq!(made, ["rapid 1", "feed -6 F200", "rapid -5.5", "feed -10 F200", "rapid 1"]);
    }

    #[test]
    fn wrong_pecks_are_refused_by_name() {
        let wrong = |pecks: Pecks| pecks.check("B", "C").unwrap_err().word;
        assert_eq!(wrong(Pecks { first: 0.0, ..PECKS }), "B");
        assert_eq!(wrong(Pecks { gap: 0.0, ..PECKS }), "C");
        assert_eq!(wrong(Pecks { factor: -1.0, ..PECKS }), "R");
        let tiny = Pecks { first: 1e-6, factor: 1.0, ..PECKS };
        assert_eq!(Hole { pecks: Some(tiny), ..HOLE }.check("B").unwrap_err().fault, Fault::MillTooManyMoves);
        assert_eq!(Hole { bottom: 1.0, ..HOLE }.check("I").unwrap_err().fault, Fault::CycleNoDepth);
    }
}
