//! Pockets: rectangular, round, and round with an open middle (Fagor 1.8, 1.9, 4.11 to 4.14).
//!
//! The frame's origin is the middle of the pocket, its u lies along the longer side.

use super::clear;
use super::enter::Entry;
use super::outline::{Corner, Outline};
use super::{Cut, Planes, retreat};
use crate::cycles::depth::Levels;
use crate::cycles::parameter::{WrongParameter, refuse};
use crate::cycles::tool::{Take, Tool};
use ferrocut_geometry::SAME_POINT_MM;
use ferrocut_machine::Fault;

/// Where the tool goes between the levels of a pocket, over its middle.
#[derive(Clone, Copy, PartialEq, Eq, Debug)]
pub enum PocketSteps {
    /// To just above the level just cut.
    AboveLevel,
    /// To the approach level.
    Approach,
}

/// Roughing of a pocket, and where the control has it so, its wall level by level.
#[derive(Clone, Copy, PartialEq, Debug)]
pub struct PocketRough {
    /// The wall.
    pub wall: Outline,
    /// Radius of the open middle; 0 for none.
    pub emptied: f64,
    /// Levels.
    pub planes: Planes,
    /// Passes in depth.
    pub levels: Levels,
    /// The tool.
    pub cut: Cut,
    /// Left on the wall.
    pub stock: f64,
    /// The area is cleared; else the wall alone is cut.
    pub clears: bool,
    /// Feed of a pass along the wall itself at every level; none for no such pass.
    pub wall_feed: Option<f64>,
    /// The way in.
    pub entry: Entry,
    /// Between levels.
    pub between: PocketSteps,
}

/// Whether corners fit their rectangle.
pub(crate) fn check_corner(outline: &Outline, word: &'static str) -> Result<(), WrongParameter> {
    let [a, b] = outline.half;
    let (Corner::Round(size) | Corner::Chamfer(size)) = outline.corner else { return Ok(()) };
    refuse(!(size >= 0.0), Fault::CycleParameter, word)?;
    if size > a.min(b) + SAME_POINT_MM {
        return Err(WrongParameter::beyond(Fault::MillCornerTooLarge, word, size, a.min(b)));
    }
    Ok(())
}

/// Whether a tool fits a pocket with what is left on its wall.
fn check_fit(wall: &Outline, radius: f64, stock: f64) -> Result<(), WrongParameter> {
    let room = wall.room() - stock;
    if radius > room + SAME_POINT_MM {
        return Err(WrongParameter::beyond(Fault::CycleToolTooLarge, "T", radius, room.max(0.0)));
    }
    Ok(())
}

/// Whether what is left is a length.
pub(crate) fn check_stock(stock: f64, word: &'static str) -> Result<(), WrongParameter> {
    refuse(!(stock >= 0.0 && stock.is_finite()), Fault::CycleParameter, word)
}

impl PocketRough {
    /// Whether the pocket can be cut.
    pub fn check(&self, entry: &'static str) -> Result<(), WrongParameter> {
        let cleared = if self.clears { self.stock } else { 0.0 };
        check_fit(&self.wall, self.cut.radius, cleared)?;
        if self.emptied > 0.0 && self.cut.radius > self.emptied + SAME_POINT_MM {
            let (radius, room) = (self.cut.radius, self.emptied);
            return Err(WrongParameter::beyond(Fault::CycleToolTooLarge, "T", radius, room));
        }
        let depth = self.levels.depths().next().unwrap_or(0.0);
        self.entry.check(depth + super::CLEAR, entry)
    }

    /// Cuts the pocket from over its middle, and ends there on the safety level.
    pub fn cut<T: Take>(&self, tool: &mut Tool<'_, T>) -> Result<(), T::Error> {
        tool.rapid_z(self.planes.approach)?;
        for depth in self.levels.depths() {
            let level = tool.above(self.planes.surface, -depth);
            tool.set_feed(self.cut.plunge);
            self.entry.enter(tool, level)?;
            tool.set_feed(self.cut.feed);
            self.clear(tool)?;
            if let Some(feed) = self.wall_feed {
                tool.set_feed(feed);
                self.wall.inset(self.cut.radius).finish_inside(tool, self.cut.radius)?;
            }
            match self.between {
                PocketSteps::AboveLevel => retreat(tool, [0.0; 2])?,
                PocketSteps::Approach => {
                    tool.rapid_z(self.planes.approach)?;
                    tool.rapid([0.0; 2])?;
                }
            }
        }
        tool.rapid_z(self.planes.safety)
    }

    fn clear<T: Take>(&self, tool: &mut Tool<'_, T>) -> Result<(), T::Error> {
        if !self.clears {
            return Ok(());
        }
        let (radius, step) = (self.cut.radius, self.cut.step);
        let path = self.wall.inset(radius + self.stock);
        match self.emptied > 0.0 {
            true => clear::ring(tool, self.emptied - radius, path.half[0], step, radius),
            false => clear::inside(tool, &path, step, radius),
        }
    }
}

/// Finishing of a pocket: its floor, then its wall.
#[derive(Clone, Copy, PartialEq, Debug)]
pub struct PocketFinish {
    /// The wall.
    pub wall: Outline,
    /// Levels.
    pub planes: Planes,
    /// Where the first rapid ends: just above the roughed floor, or on the approach level.
    pub above_floor: f64,
    /// Depth of the floor.
    pub depth: f64,
    /// Passes in depth along the wall.
    pub wall_levels: Levels,
    /// The tool.
    pub cut: Cut,
    /// Left on the wall until it is finished.
    pub stock: f64,
    /// The way in.
    pub entry: Entry,
}

impl PocketFinish {
    /// Whether the pocket can be finished.
    pub fn check(&self, entry: &'static str) -> Result<(), WrongParameter> {
        check_fit(&self.wall, self.cut.radius, self.stock)?;
        let floor = self.planes.surface - self.depth * (self.planes.safety - self.planes.surface).signum();
        self.entry.check((self.above_floor - floor).abs(), entry)
    }

    /// Finishes the pocket from over its middle, and ends there on the safety level.
    pub fn cut<T: Take>(&self, tool: &mut Tool<'_, T>) -> Result<(), T::Error> {
        let Cut { radius, step, feed, plunge } = self.cut;
        tool.rapid_z(self.above_floor)?;
        tool.set_feed(plunge);
        let floor = tool.above(self.planes.surface, -self.depth);
        self.entry.enter(tool, floor)?;
        tool.set_feed(feed);
        clear::inside(tool, &self.wall.inset(radius + self.stock), step, radius)?;
        tool.rapid_z(self.planes.approach)?;
        tool.rapid([0.0; 2])?;
        for depth in self.wall_levels.depths() {
            let level = tool.above(self.planes.surface, -depth);
            down(tool, level, plunge)?;
            tool.set_feed(feed);
            self.wall.inset(radius).finish_inside(tool, radius)?;
            retreat(tool, [0.0; 2])?;
        }
        tool.rapid_z(self.planes.safety)
    }
}

/// Down through what is cut already: at rapid to just above a level, then at feed.
pub(crate) fn down<T: Take>(tool: &mut Tool<'_, T>, level: f64, plunge: f64) -> Result<(), T::Error> {
    let near = tool.above(level, super::CLEAR);
    if tool.height(tool.z(), near) > 0.0 {
        tool.rapid_z(near)?;
    }
    tool.set_feed(plunge);
    tool.feed_z(level)
}
