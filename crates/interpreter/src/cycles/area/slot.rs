//! Slots at the corners of a part, and through it (Fagor 4.22).
//!
//! A slot at a corner is open towards −u and −v, with walls on the far sides; the origin is the corner of the
//! part. One through the part is open at both ends of u, with walls along u. The tool comes down beside the
//! part, its edge clear of it by the overrun.

use super::pocket::{check_stock, down};
use super::{Cut, Planes, passes};
use crate::cycles::depth::Levels;
use crate::cycles::parameter::{WrongParameter, positive, refuse};
use crate::cycles::tool::{Take, Tool};
use ferrocut_geometry::SAME_POINT_MM;
use ferrocut_machine::Fault;

/// Where a slot is.
#[derive(Clone, Copy, PartialEq, Eq, Debug)]
pub enum SlotKind {
    /// At a corner of the part.
    Corner,
    /// Through it.
    Through,
}

/// A slot, and a stage of it.
#[derive(Clone, Copy, PartialEq, Debug)]
pub struct Slot {
    /// Where it is.
    pub kind: SlotKind,
    /// Its sizes along u and v.
    pub size: [f64; 2],
    /// Levels.
    pub planes: Planes,
    /// Where the first rapid ends.
    pub first: f64,
    /// Passes in depth over the whole area.
    pub levels: Levels,
    /// Passes in depth along the walls; none where they are not finished.
    pub walls: Option<Levels>,
    /// The tool.
    pub cut: Cut,
    /// Left on the walls.
    pub stock: f64,
    /// How far the tool's edge runs beyond the part.
    pub overrun: f64,
    /// Walls are finished the other way round.
    pub reversed: bool,
}

impl Slot {
    /// Whether the slot can be cut.
    pub fn check(&self, words: [&'static str; 4]) -> Result<(), WrongParameter> {
        let [along, across, overrun, stock] = words;
        positive(self.size[0], along)?;
        positive(self.size[1], across)?;
        refuse(!(self.overrun >= 0.0 && self.overrun.is_finite()), Fault::CycleParameter, overrun)?;
        check_stock(self.stock, stock)?;
        let [u, v] = self.size;
        let room = match self.kind {
            SlotKind::Corner if self.stock >= u.min(v) => {
                return Err(WrongParameter::beyond(Fault::CycleParameter, stock, self.stock, u.min(v)));
            }
            SlotKind::Corner => return Ok(()),
            SlotKind::Through => v / 2.0 - self.stock,
        };
        if self.cut.radius > room + SAME_POINT_MM {
            let radius = self.cut.radius;
            return Err(WrongParameter::beyond(Fault::CycleToolTooLarge, "T", radius, room.max(0.0)));
        }
        Ok(())
    }

    fn beyond(&self) -> f64 {
        self.cut.radius + self.overrun
    }

    /// The v of the passes, the wall last.
    fn rows(&self) -> impl Iterator<Item = f64> + use<> {
        let (radius, stock, [_, v]) = (self.cut.radius, self.stock, self.size);
        let (first, count, width) = match self.kind {
            SlotKind::Corner => {
                let (count, width) = passes(v - stock, self.cut.step);
                (width - radius, count.saturating_sub(1), width)
            }
            SlotKind::Through => {
                let (count, width) = passes(v - 2.0 * (radius + stock), self.cut.step);
                (radius + stock, count, width)
            }
        };
        (0..=count).map(move |row| first + width * f64::from(row))
    }

    /// Where the tool goes down first.
    pub fn start(&self) -> [f64; 2] {
        [-self.beyond(), self.rows().next().unwrap_or(0.0)]
    }

    /// Cuts from over the start, and ends on the safety level: roughing over the start, finishing beside the wall that it
    /// left last (4.22.1, 4 and 10).
    pub fn cut<T: Take>(&self, tool: &mut Tool<'_, T>) -> Result<(), T::Error> {
        tool.rapid_z(self.first)?;
        for depth in self.levels.depths() {
            let level = tool.above(self.planes.surface, -depth);
            tool.set_feed(self.cut.plunge);
            tool.feed_z(level)?;
            tool.set_feed(self.cut.feed);
            self.area(tool)?;
            // Over the part only on the safety level.
            tool.rapid_z(self.planes.safety)?;
            let is_last = depth == self.levels.deepest();
            if !is_last || self.walls.is_none() {
                tool.rapid(self.start())?;
            }
            let near = tool.above(level, super::CLEAR);
            if !is_last && tool.height(tool.z(), near) > 0.0 {
                tool.rapid_z(near)?;
            }
        }
        if let Some(walls) = self.walls {
            for depth in walls.depths() {
                let level = tool.above(self.planes.surface, -depth);
                self.wall(tool, level)?;
            }
        }
        Ok(())
    }

    /// Everything but the stock on one level.
    fn area<T: Take>(&self, tool: &mut Tool<'_, T>) -> Result<(), T::Error> {
        let beyond = self.beyond();
        let [u, v] = self.size;
        let inset = self.cut.radius + self.stock;
        let end = match self.kind {
            SlotKind::Corner => u - inset,
            SlotKind::Through => u + beyond,
        };
        let mut outside = true;
        for row in self.rows() {
            tool.feed([if outside { -beyond } else { end }, row])?;
            tool.feed([if outside { end } else { -beyond }, row])?;
            outside = !outside;
        }
        if self.kind == SlotKind::Through {
            return Ok(());
        }
        // Rows leave scallops on the wall at their ends: once along it.
        if outside {
            tool.feed([-beyond, -beyond])?;
            tool.feed([end, -beyond])?;
            return tool.feed([end, v - inset]);
        }
        tool.feed([end, -beyond])
    }

    /// The walls on one level, from the safety level and back to it.
    fn wall<T: Take>(&self, tool: &mut Tool<'_, T>, level: f64) -> Result<(), T::Error> {
        let (radius, beyond, [u, v]) = (self.cut.radius, self.beyond(), self.size);
        let (end, low) = (u - radius, v - radius);
        let mut path = match self.kind {
            SlotKind::Corner => vec![[end, -beyond], [end, low], [-beyond, low]],
            SlotKind::Through => {
                vec![[-beyond, radius], [u + beyond, radius], [u + beyond, low], [-beyond, low]]
            }
        };
        if self.reversed {
            path.reverse();
        }
        let mut points = path.into_iter();
        if let Some(first) = points.next() {
            tool.rapid(first)?;
        }
        down(tool, level, self.cut.plunge)?;
        tool.set_feed(self.cut.feed);
        for point in points {
            tool.feed(point)?;
        }
        tool.rapid_z(self.planes.safety)
    }
}
