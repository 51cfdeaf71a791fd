//! Bosses: what stands when the material around is cut (Fagor 4.17, 4.18).
//!
//! The tool goes down outside the material, beside the middle of the side in −v, and works inwards. Frame as
//! for pockets.

use super::clear;
use super::outline::Outline;
use super::pocket::{check_corner, check_stock, down};
use super::{CLEAR, Cut, Planes, retreat};
use crate::cycles::depth::Levels;
use crate::cycles::parameter::WrongParameter;
use crate::cycles::tool::{Take, Tool};

/// Roughing of a boss.
#[derive(Clone, Copy, PartialEq, Debug)]
pub struct BossRough {
    /// The boss.
    pub boss: Outline,
    /// Material around it.
    pub around: f64,
    /// Levels.
    pub planes: Planes,
    /// Passes in depth.
    pub levels: Levels,
    /// The tool.
    pub cut: Cut,
    /// Left on the wall.
    pub stock: f64,
}

/// Whether the sizes of a boss make sense: those of corner, material and stock.
pub fn check_boss(
    boss: &Outline,
    words: [&'static str; 3],
    around: f64,
    stock: f64,
) -> Result<(), WrongParameter> {
    let [corner, material, wall] = words;
    check_corner(boss, corner)?;
    check_stock(around, material)?;
    check_stock(stock, wall)
}

/// Where a tool goes down beside the material.
fn start(boss: &Outline, around: f64, radius: f64) -> [f64; 2] {
    [0.0, -(boss.half[1] + around + radius + CLEAR)]
}

impl BossRough {
    /// Where the tool goes down.
    pub fn start(&self) -> [f64; 2] {
        start(&self.boss, self.around, self.cut.radius)
    }

    /// Cuts from over the start, and ends there on the safety level.
    pub fn cut<T: Take>(&self, tool: &mut Tool<'_, T>) -> Result<(), T::Error> {
        tool.rapid_z(self.planes.approach)?;
        for depth in self.levels.depths() {
            let level = tool.above(self.planes.surface, -depth);
            tool.set_feed(self.cut.plunge);
            tool.feed_z(level)?;
            tool.set_feed(self.cut.feed);
            around(tool, &self.boss, self.stock, self.around, &self.cut)?;
            retreat(tool, self.start())?;
        }
        tool.rapid_z(self.planes.safety)
    }
}

fn around<T: Take>(
    tool: &mut Tool<'_, T>,
    boss: &Outline,
    stock: f64,
    material: f64,
    cut: &Cut,
) -> Result<(), T::Error> {
    for path in clear::around(boss, cut.radius + stock, material, cut.step, cut.radius) {
        tool.feed(path.start())?;
        path.contour(tool)?;
    }
    Ok(())
}

/// Finishing of a boss: the floor around it, then its wall.
#[derive(Clone, Copy, PartialEq, Debug)]
pub struct BossFinish {
    /// The boss.
    pub boss: Outline,
    /// Material around it.
    pub around: f64,
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
}

impl BossFinish {
    /// Where the tool goes down.
    pub fn start(&self) -> [f64; 2] {
        start(&self.boss, self.around, self.cut.radius)
    }

    /// Finishes from over the start, and ends there on the safety level.
    pub fn cut<T: Take>(&self, tool: &mut Tool<'_, T>) -> Result<(), T::Error> {
        let Cut { radius, feed, plunge, .. } = self.cut;
        tool.rapid_z(self.above_floor)?;
        tool.set_feed(plunge);
        let floor = tool.above(self.planes.surface, -self.depth);
        tool.feed_z(floor)?;
        tool.set_feed(feed);
        around(tool, &self.boss, self.stock, self.around, &self.cut)?;
        tool.rapid_z(self.planes.approach)?;
        tool.rapid(self.start())?;
        for depth in self.wall_levels.depths() {
            let level = tool.above(self.planes.surface, -depth);
            down(tool, level, plunge)?;
            tool.set_feed(feed);
            self.boss.outset(radius, radius).finish_outside(tool, radius)?;
            retreat(tool, self.start())?;
        }
        tool.rapid_z(self.planes.safety)
    }
}
