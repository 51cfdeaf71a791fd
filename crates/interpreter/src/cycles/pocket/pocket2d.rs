//! 2D profile pockets: vertical walls, one outer profile and islands (Fagor 4.15).
//!
//! **Roughing**, level by level down to P − δz: down by I under the angle β at Fz, then the area to δ from
//! the walls at F, concentric, about the outer profile as it was defined and about islands the other way;
//! rapid to 1 mm above the level. At the end rapid to Zs.
//!
//! **Finishing**: rapid to 1 mm above the roughed floor; the floor likewise, at P; rapid to the approach
//! plane; the walls in N passes, on and off along tangents; rapid to Zs.
//!
//! Where finishing goes down into what its roughing could not reach, or where there was no roughing, it
//! begins above the surface: a rapid never trusts in work that this pocket has not done.

use super::clear::{Clearing, Level};
use super::contours::Contours;
use super::descent::{Slope, slope};
use super::finish::{Finish, finishes};
use super::passes::{equal_levels, levels, width};
use super::pen::{APPROACH, Pen, Planes, PocketSink};
use super::problem::{MAX_MOVES, PocketFault, Problem, Stage, in_range, not_negative};
use super::profile::Profile;
use super::store::{Kind, Reader, Writer};
use super::tool::Tool;
use super::walls::Walls;
use crate::cycles::depth::Levels;

/// Parameters of a 2D pocket, mm and degrees.
#[derive(Clone, PartialEq, Debug)]
pub struct Pocket2d {
    /// P.XY: the outer profile, in the plane.
    pub outer: Profile,
    /// P.XY: the islands.
    pub islands: Vec<Profile>,
    /// Z: part surface.
    pub surface: f64,
    /// Zs: safety plane.
    pub safety: f64,
    /// P: total depth. Its sign counts only where Z and Zs are one (4.1.2).
    pub depth: f64,
    /// δ: stock for finishing on the walls.
    pub wall_stock: f64,
    /// δz: stock for finishing on the floor.
    pub floor_stock: f64,
    /// Roughing; none for T0.
    pub rough: Option<Rough2d>,
    /// Finishing; none for T0.
    pub finish: Option<Finish2d>,
}

/// Parameters of roughing.
#[derive(Clone, Copy, PartialEq, Debug)]
pub struct Rough2d {
    /// T with its data.
    pub tool: Tool,
    /// Δ: greatest width of a pass; 0 for three quarters of the diameter.
    pub step: f64,
    /// I: depth of a pass, with its sign; 0 for the cutting length.
    pub depth_step: f64,
    /// β: entry angle; 0 for the tool's.
    pub entry_angle: f64,
}

/// Parameters of finishing.
#[derive(Clone, Copy, PartialEq, Debug)]
pub struct Finish2d {
    /// T with its data.
    pub tool: Tool,
    /// Δ: greatest width of a pass on the floor; 0 for three quarters of the diameter.
    pub step: f64,
    /// N: passes in depth along the walls; 0 for the fewest that the cutting length allows.
    pub passes: f64,
    /// θ: entry angle; 0 for the tool's.
    pub entry_angle: f64,
}

/// A 2D pocket ready to be cut.
#[derive(Debug)]
pub struct Plan2d {
    pub(super) planes: Planes,
    pub(super) walls: Walls,
    pub(super) depth: f64,
    pub(super) rough: Option<RoughPlan>,
    pub(super) finish: Option<FinishPlan>,
    /// Radius of the tool that goes down first.
    entering: f64,
    /// Hash of the parameters.
    inputs: [u8; 16],
}

#[derive(Debug)]
pub(super) struct RoughPlan {
    pub clearing: Clearing,
    pub levels: Levels,
    pub slope: Slope,
}

#[derive(Debug)]
pub(super) struct FinishPlan {
    pub floor: Clearing,
    pub walls: Vec<Finish>,
    pub levels: Levels,
    pub slope: Slope,
    /// Centres this far from the walls stand over the roughed floor; none did where nothing was roughed.
    pub open_from: f64,
    /// Height of the roughed floor.
    pub open: f64,
}

/// What is known before any path is computed.
struct Frame {
    contours: Contours,
    planes: Planes,
    depth: f64,
}

impl Pocket2d {
    /// The plan, or what forbids it.
    pub fn plan(&self) -> Result<Plan2d, PocketFault> {
        let (frame, walls) = self.frame()?;
        let clockwise = frame.contours.outer.area() < 0.0;
        let area = |tool: &Tool, step: f64| {
            let width = width(step, tool.radius, "step")?;
            Clearing::new(&walls, clockwise, (tool.radius, self.wall_stock, width), ["T", "step"])
        };
        let rough = self.rough.as_ref().map(|r| area(&r.tool, r.step)).transpose();
        let rough = rough.map_err(|fault| fault.in_stage(Stage::Rough))?;
        let finish = |finish: &Finish2d| {
            let radius = finish.tool.radius;
            // The floor is cleared as the levels above it are, where tool and step are the same.
            let floor = match (&self.rough, &rough) {
                (Some(r), Some(same)) if r.tool.radius == radius && r.step == finish.step => same.clone(),
                _ => area(&finish.tool, finish.step)?,
            };
            let walls = finishes(&walls, clockwise, radius, self.wall_stock);
            Ok((floor, walls.map_err(|problem| problem.of("profile"))?))
        };
        let finish = self.finish.as_ref().map(finish).transpose();
        let finish = finish.map_err(|fault: PocketFault| fault.in_stage(Stage::Finish))?;
        self.complete(frame, walls, rough, finish)
    }

    /// The plan that [`Plan2d::save`] made of the very same parameters; nothing from any other bytes.
    pub fn load(&self, bytes: &[u8]) -> Option<Plan2d> {
        let mut reader = Reader::file(bytes, Kind::Flat, &self.inputs())?;
        let rough = match reader.byte()? {
            0 => None,
            _ => Some(reader.clearing()?),
        };
        let finish = match reader.byte()? {
            0 => None,
            _ => Some((reader.clearing()?, reader.finishes()?)),
        };
        let whole = reader.is_at_end()
            && rough.is_some() == self.rough.is_some()
            && finish.is_some() == self.finish.is_some();
        let (frame, walls) = self.frame().ok().filter(|_| whole)?;
        self.complete(frame, walls, rough, finish).ok()
    }

    /// The hash of all that the plan depends on.
    fn inputs(&self) -> [u8; 16] {
        let mut writer = Writer::inputs();
        writer.segments(&self.outer.segments);
        writer.profiles(self.islands.iter());
        writer.numbers([self.surface, self.safety, self.depth, self.wall_stock, self.floor_stock]);
        writer.byte(u8::from(self.rough.is_some()));
        if let Some(rough) = &self.rough {
            writer.tool(&rough.tool);
            writer.numbers([rough.step, rough.depth_step, rough.entry_angle]);
        }
        writer.byte(u8::from(self.finish.is_some()));
        if let Some(finish) = &self.finish {
            writer.tool(&finish.tool);
            writer.numbers([finish.step, finish.passes, finish.entry_angle]);
        }
        writer.hash()
    }

    /// The checked contours, planes and walls.
    fn frame(&self) -> Result<(Frame, Walls), PocketFault> {
        let surface = in_range(self.surface, "Z")?;
        let safety = in_range(self.safety, "ZS")?;
        let depth = in_range(self.depth, "P")?;
        Problem::DepthMissing.when(depth.abs() < 1e-6, "P")?;
        not_negative(self.wall_stock, "delta")?;
        not_negative(self.floor_stock, "deltaz")?;
        Problem::OutOfRange.when(self.floor_stock >= depth.abs(), "deltaz")?;
        let contours = Contours::checked(&self.outer, &self.islands)?;
        let rough = self.rough.iter().map(|r| (r.tool, Stage::Rough));
        for (tool, stage) in rough.chain(self.finish.iter().map(|f| (f.tool, Stage::Finish))) {
            tool.checked().map_err(|fault| fault.in_stage(stage))?;
        }
        let walls = Walls::new([&contours.outer], &contours.islands);
        let frame = Frame { contours, planes: Planes::new(surface, safety, depth), depth: depth.abs() };
        Ok((frame, walls))
    }

    fn rough_plan(&self, words: &Rough2d, clearing: Clearing, depth: f64) -> Result<RoughPlan, PocketFault> {
        let depth = depth - self.floor_stock;
        let levels = levels(depth, words.depth_step, words.tool.cutting_length, "I")?;
        let slope = slope(words.entry_angle, words.tool.entry_angle, "beta")?;
        let one = clearing.moves(APPROACH + depth / levels.count(), slope);
        Problem::TooManyMoves.when(one * levels.count() > MAX_MOVES, "beta")?;
        Ok(RoughPlan { clearing, levels, slope })
    }

    fn finish_plan(
        &self,
        words: &Finish2d,
        (floor, walls): (Clearing, Vec<Finish>),
        depth: f64,
    ) -> Result<FinishPlan, PocketFault> {
        let levels = equal_levels(depth, words.passes, words.tool.cutting_length, "N")?;
        let slope = slope(words.entry_angle, words.tool.entry_angle, "theta")?;
        let height = APPROACH + depth;
        let moves: f64 = walls.iter().map(|w| w.moves(levels, height, slope)).sum();
        Problem::TooManyMoves.when(moves + floor.moves(height, slope) > MAX_MOVES, "theta")?;
        // The roughing tool's centre came that near; where the finishing tool is the larger one, its own
        // outermost path stands over what the smaller cut.
        let open_from = self
            .rough
            .as_ref()
            .map_or(f64::INFINITY, |r| r.tool.radius.max(words.tool.radius) + self.wall_stock);
        Ok(FinishPlan { floor, walls, levels, slope, open_from, open: self.floor_stock - depth })
    }

    /// Paths and parameters as a plan.
    fn complete(
        &self,
        frame: Frame,
        walls: Walls,
        rough: Option<Clearing>,
        finish: Option<(Clearing, Vec<Finish>)>,
    ) -> Result<Plan2d, PocketFault> {
        let depth = frame.depth;
        let rough = match (&self.rough, rough) {
            (Some(words), Some(clearing)) => Some(self.rough_plan(words, clearing, depth)),
            _ => None,
        };
        let finish = match (&self.finish, finish) {
            (Some(words), Some(paths)) => Some(self.finish_plan(words, paths, depth)),
            _ => None,
        };
        let rough = rough.transpose().map_err(|fault| fault.in_stage(Stage::Rough))?;
        let finish = finish.transpose().map_err(|fault| fault.in_stage(Stage::Finish))?;
        let first = self.rough.map(|r| r.tool).or(self.finish.map(|f| f.tool));
        let entering = first.map_or(0.0, |tool| tool.radius);
        Ok(Plan2d { planes: frame.planes, walls, depth, rough, finish, entering, inputs: self.inputs() })
    }
}

impl Plan2d {
    /// Where to drill before roughing, so that the tool need not cut downwards: each point at which it goes
    /// down into full material (4.15). Without roughing those of finishing the floor.
    pub fn drill_points(&self) -> Vec<[f64; 2]> {
        match (&self.rough, &self.finish) {
            (Some(rough), _) => rough.clearing.entries().collect(),
            (None, Some(finish)) => finish.floor.entries().collect(),
            (None, None) => Vec::new(),
        }
    }

    /// Whether finishing goes down into full material that no [`drill_points`](Self::drill_points) are in, somewhere: where the
    /// roughing tool did not fit, it does.
    pub fn finish_enters_solid(&self) -> bool {
        self.rough.is_some()
            && self
                .finish
                .as_ref()
                .is_some_and(|finish| finish.floor.enters_solid(&self.walls, finish.open_from))
    }

    /// The computed paths as bytes, to be kept and loaded again.
    pub fn save(&self) -> Vec<u8> {
        let mut writer = Writer::file(Kind::Flat, &self.inputs);
        writer.byte(u8::from(self.rough.is_some()));
        if let Some(rough) = &self.rough {
            writer.clearing(&rough.clearing);
        }
        writer.byte(u8::from(self.finish.is_some()));
        if let Some(finish) = &self.finish {
            writer.clearing(&finish.floor);
            writer.finishes(&finish.walls);
        }
        writer.finish()
    }

    /// [`drill_points`](Self::drill_points) for a drill of that radius, which is at most
    /// [`largest_drill`](Self::largest_drill).
    pub fn drilling(&self, radius: f64) -> Result<Vec<[f64; 2]>, PocketFault> {
        Problem::DrillTooLarge.when(radius > Self::largest_drill(self.entering) + 1e-7, "drill")?;
        Ok(self.drill_points())
    }

    /// The largest radius of a drill before a tool of that radius: its diameter is at most the radius of roughing, or
    /// where there is none of finishing the floor (4.15).
    pub fn largest_drill(entering: f64) -> f64 {
        entering / 2.0
    }

    /// Whether there is roughing, and whether there is finishing.
    pub fn stages(&self) -> (bool, bool) {
        (self.rough.is_some(), self.finish.is_some())
    }

    /// Roughing, from where the tool stands (plane coordinates and tool axis) to the safety plane.
    pub fn rough<S: PocketSink>(&self, from: [f64; 3], sink: &mut S) -> Result<(), S::Error> {
        let Some(rough) = &self.rough else { return Ok(()) };
        let mut pen = Pen::new(self.planes, from, sink);
        let mut inside = false;
        let mut open = self.planes.approach() - APPROACH;
        for depth in rough.levels.depths() {
            let open_from = rough.clearing.nearest;
            let level = Level { bottom: -depth, open, open_from, slope: rough.slope };
            rough.clearing.cut(&mut pen, &self.walls, level, &mut inside)?;
            pen.rapid_height((APPROACH - depth).min(self.planes.approach()))?;
            open = -depth;
        }
        pen.rapid_height(self.planes.safety)
    }

    /// Finishing of floor and walls, from where the tool stands to the safety plane.
    pub fn finish<S: PocketSink>(&self, from: [f64; 3], sink: &mut S) -> Result<(), S::Error> {
        let Some(finish) = &self.finish else { return Ok(()) };
        let mut pen = Pen::new(self.planes, from, sink);
        let mut inside = false;
        let level = Level {
            bottom: -self.depth,
            open: finish.open,
            open_from: finish.open_from,
            slope: finish.slope,
        };
        finish.floor.cut(&mut pen, &self.walls, level, &mut inside)?;
        pen.rapid_height(self.planes.approach())?;
        for wall in &finish.walls {
            wall.cut(&mut pen, &self.walls, finish.levels, finish.slope, finish.floor.nearest)?;
        }
        pen.rapid_height(self.planes.safety)
    }
}
