//! The two sequences of the milling cycles: roughing a pocket and finishing a wall.
//!
//! Both begin with the tool over [`Plan::start`] at the initial level, where the caller has brought it
//! at rapid (and has taken up a change of tool length), and end at the return level over wherever the
//! work ended: with G99 that is the R level, with G98 the initial one. Repeats are the caller's.
//!
//! **Roughing** (GSK990MC 4.6.1, 4.6.4)
//! 1. the start is on the circle of the helix, on the −X side of the middle (caller);
//! 2. rapid to R;
//! 3. helix of the first depth W, feed to the middle: straight in a rectangular pocket, in a round one
//!    on the half circle that leads from the helix into the spiral without a corner;
//! 4. clear the area from the middle outward;
//! 5. rapid to R, 6. rapid to where the next pass goes down: the middle of a round pocket, the start
//!    again in a rectangular one;
//! 7. rapid to V above the material left, 8. feed down through V + Q, feed to the middle;
//! 9. on from 4 until the bottom is cut; 10. rapid to the return level.
//!
//! **Finishing** (4.6.2, 4.6.3, 4.6.5, 4.6.6)
//! 1. the start lies beside the wall, on the X axis through the middle (caller);
//! 2. rapid to R, 3. feed to the bottom;
//! 4. half circle onto the wall, 5. once round, 6. half circle back to the start;
//! 7. rapid to the return level.

use super::circle;
use super::cutter::{Cutter, CycleMove};
use super::depths::Depths;
use super::fault::{CycleFault, MAX_MOVES, Problem};
use super::helix;
use super::rectangle::Rectangle;
use super::tangent::Tangent;
use crate::cycles::tool::{Frame, Take};

/// A cycle whose words are legal, ready to be cut.
#[derive(Clone, Copy, PartialEq, Debug)]
pub struct Plan {
    frame: Frame,
    work: Work,
}

#[derive(Clone, Copy, PartialEq, Debug)]
enum Work {
    Rough(Rough),
    Finish(Finish),
}

/// A pocket to rough. Lengths of the tool centre's path.
#[derive(Clone, Copy, PartialEq, Debug)]
pub(crate) struct Rough {
    pub depths: Depths,
    /// Radius of the entry helix.
    pub helix: f64,
    pub tool_radius: f64,
    /// Step over.
    pub step: f64,
    pub area: Area,
}

/// The area that the tool centre covers.
#[derive(Clone, Copy, PartialEq, Debug)]
pub(crate) enum Area {
    /// Radius.
    Circle(f64),
    Rectangle(Rectangle),
}

/// A wall to finish.
#[derive(Clone, Copy, PartialEq, Debug)]
pub(crate) struct Finish {
    pub r: f64,
    pub bottom: f64,
    pub tangent: Tangent,
    pub contour: Contour,
}

/// The path of the tool centre along a wall.
#[derive(Clone, Copy, PartialEq, Debug)]
pub(crate) enum Contour {
    /// Its radius is where the tangent meets it.
    Circle,
    Rectangle(Rectangle),
}

impl Plan {
    pub(crate) fn rough(frame: Frame, work: Rough) -> Result<Plan, CycleFault> {
        work.check_size()?;
        Ok(Plan { frame, work: Work::Rough(work) })
    }

    pub(crate) fn finish(frame: Frame, work: Finish) -> Plan {
        Plan { frame, work: Work::Finish(work) }
    }

    /// X and Y where the cycle begins.
    pub fn start(&self) -> [f64; 2] {
        self.frame.world(self.local_start())
    }

    /// The moves, from over the start at the initial level to `return_z`.
    pub fn moves<S: Take<CycleMove>>(&self, return_z: f64, sink: &mut S) -> Result<(), S::Error> {
        let (at, r) = match &self.work {
            Work::Rough(work) => (self.local_start(), work.depths.r),
            Work::Finish(work) => (self.local_start(), work.r),
        };
        // Wherever the initial level is, the move to R is made and said; the level is not known here.
        let mut cutter = Cutter::new(self.frame, at, f64::INFINITY, sink);
        cutter.rapid_z(r)?;
        match &self.work {
            Work::Rough(work) => work.cut(&mut cutter)?,
            Work::Finish(work) => work.cut(&mut cutter)?,
        }
        cutter.rapid_z(return_z)
    }

    fn local_start(&self) -> [f64; 2] {
        match &self.work {
            Work::Rough(work) => [-work.helix, 0.0],
            Work::Finish(work) => [work.tangent.start, 0.0],
        }
    }
}

impl Rough {
    fn cut<S: Take<CycleMove>>(&self, cutter: &mut Cutter<'_, S>) -> Result<(), S::Error> {
        let middle = [0.0, 0.0];
        let down = match self.area {
            Area::Circle(_) => middle,
            Area::Rectangle(_) => [-self.helix, 0.0],
        };
        helix::entry(cutter, self.helix, self.depths.level(0), self.pitch())?;
        match self.area {
            Area::Circle(_) => cutter.half_circle(middle, [-self.helix / 2.0, 0.0], 1.0)?,
            Area::Rectangle(_) => cutter.feed(middle)?,
        }
        self.clear(cutter)?;
        for pass in 1..self.depths.passes() as u32 {
            cutter.rapid_z(self.depths.r)?;
            cutter.rapid(down)?;
            cutter.rapid_z(self.depths.rapid_level(pass))?;
            cutter.feed_z(self.depths.level(pass))?;
            cutter.feed(middle)?;
            self.clear(cutter)?;
        }
        Ok(())
    }

    fn clear<S: Take<CycleMove>>(&self, cutter: &mut Cutter<'_, S>) -> Result<(), S::Error> {
        match &self.area {
            Area::Circle(radius) => circle::clear(cutter, *radius, self.step),
            Area::Rectangle(rectangle) => rectangle.clear(cutter, self.step),
        }
    }

    /// Depth of one turn of the helix. The manual does not say; half the tool radius makes a slope of 3°
    /// at the factor 1.5 that P269 comes with, and a steeper one where P269 asks for a narrower helix.
    fn pitch(&self) -> f64 {
        self.tool_radius / 2.0
    }

    fn check_size(&self) -> Result<(), CycleFault> {
        let turns = helix::turns(self.depths.r - self.depths.level(0), self.pitch());
        let area = match &self.area {
            Area::Circle(radius) => circle::moves(*radius, self.step),
            Area::Rectangle(rectangle) => rectangle.moves(self.step),
        };
        let passes = self.depths.passes();
        // A pass has 5 moves besides the area.
        if turns + passes * (area + 5.0) + 2.0 <= MAX_MOVES {
            return Ok(());
        }
        let letter = match () {
            () if turns > passes * area => b'W',
            () if passes > area => b'Q',
            () => b'L',
        };
        Err(Problem::TooManyMoves.of(letter))
    }
}

impl Finish {
    fn cut<S: Take<CycleMove>>(&self, cutter: &mut Cutter<'_, S>) -> Result<(), S::Error> {
        cutter.feed_z(self.bottom)?;
        self.tangent.approach(cutter)?;
        match &self.contour {
            Contour::Circle => circle::contour(cutter)?,
            Contour::Rectangle(rectangle) => rectangle.contour(cutter)?,
        }
        self.tangent.departure(cutter)
    }
}
