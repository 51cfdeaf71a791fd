//! 3D profile pockets: walls that slope along depth profiles (Fagor 4.16).
//!
//! **Roughing**, level by level: as a 2D pocket whose walls are where they stand at that level, so that a flat
//! tool's edge keeps δ off them. **Semi-finishing** goes round the walls at levels between, which takes off
//! the steps; levels that roughing has cut with the same radius are left out. **Finishing** follows the depth
//! profiles, with the tip's radius taken into account.
//!
//! Between stages the tool is at the approach plane, at the end at Zs.

use super::clear::{Clearing, Level};
use super::contours::Contours;
use super::depth_profile::{DepthProfile, Lean};
use super::descent::{Slope as EntrySlope, slope};
use super::finish::{Finish, finishes_in};
use super::passes::{levels, width};
use super::pen::{APPROACH, Pen, Planes, PocketSink};
use super::problem::{MAX_MOVES, PocketFault, Problem, Stage, in_range, not_negative};
use super::profile::Profile;
use super::segment::Segment;
use super::slopes::{self, Pass, Slope, WallDirection};
use super::store::{Kind, Reader, Writer};
use super::tool::Tool;
use super::walls::Walls;

/// Parameters of a 3D pocket, mm and degrees.
#[derive(Clone, PartialEq, Debug)]
pub struct Pocket3d {
    /// P.XY: the outer profile at the surface.
    pub outer: Profile,
    /// P.XY: the islands at the floor.
    pub islands: Vec<Profile>,
    /// P.Z1…P.Z4: depth profiles of the first four contours, the outer one first.
    pub depth_profiles: Vec<Option<DepthProfile>>,
    /// Z: part surface.
    pub surface: f64,
    /// Zs: safety plane.
    pub safety: f64,
    /// P: total depth. Its sign counts only where Z and Zs are one (4.1.2).
    pub depth: f64,
    /// δ: stock for finishing on the walls.
    pub wall_stock: f64,
    /// Roughing; none for T0.
    pub rough: Option<Rough3d>,
    /// Semi-finishing; none for T0.
    pub semi: Option<Semi3d>,
    /// Finishing; none for T0.
    pub finish: Option<Finish3d>,
}

/// Parameters of roughing.
#[derive(Clone, Copy, PartialEq, Debug)]
pub struct Rough3d {
    /// T with its data.
    pub tool: Tool,
    /// Δ: greatest width of a pass; 0 for three quarters of the diameter.
    pub step: f64,
    /// I1: depth of a pass, with its sign; 0 for the cutting length.
    pub depth_step: f64,
    /// β: entry angle; 0 for the tool's.
    pub entry_angle: f64,
}

/// Parameters of semi-finishing.
#[derive(Clone, Copy, PartialEq, Debug)]
pub struct Semi3d {
    /// T with its data.
    pub tool: Tool,
    /// I2: depth of a pass, with its sign; 0 for the cutting length.
    pub depth_step: f64,
}

/// Parameters of finishing.
#[derive(Clone, Copy, PartialEq, Debug)]
pub struct Finish3d {
    /// T with its data.
    pub tool: Tool,
    /// ε: distance of passes along the contour; 0 for a quarter of the tool radius.
    pub width: f64,
    /// Which way the wall is cut.
    pub direction: WallDirection,
}

/// The contours of a pocket at one height.
#[derive(Debug)]
pub(super) struct Cross {
    pub height: f64,
    pub walls: Walls,
}

/// A 3D pocket ready to be cut.
#[derive(Debug)]
pub struct Plan3d {
    pub(super) planes: Planes,
    pub(super) slopes: Vec<Slope>,
    pub(super) rough: Vec<(Cross, Clearing)>,
    pub(super) rough_slope: EntrySlope,
    pub(super) semi: Vec<(Cross, Vec<Finish>)>,
    pub(super) semi_slope: EntrySlope,
    pub(super) finish: Vec<Vec<Pass>>,
    words: Pocket3d,
    /// Hash of the parameters.
    inputs: [u8; 16],
}

/// Contours with depth profiles at most.
const SLOPING: usize = 4;

/// What is known before any path is computed.
struct Frame {
    planes: Planes,
    depth: f64,
    clockwise: bool,
    slopes: Vec<Slope>,
    rough_slope: EntrySlope,
    semi_slope: EntrySlope,
}

impl Pocket3d {
    /// The plan, or what forbids it.
    pub fn plan(&self) -> Result<Plan3d, PocketFault> {
        let frame = self.frame()?;
        let rough = match &self.rough {
            Some(words) => self.rough_plan(words, &frame).map_err(|fault| fault.in_stage(Stage::Rough))?,
            None => Vec::new(),
        };
        let semi = match &self.semi {
            Some(words) => {
                self.semi_plan(words, &frame, &rough).map_err(|fault| fault.in_stage(Stage::Semi))?
            }
            None => Vec::new(),
        };
        let finish = match &self.finish {
            Some(words) => finish_plan(words, &frame).map_err(|fault| fault.in_stage(Stage::Finish))?,
            None => Vec::new(),
        };
        Ok(self.complete(frame, rough, semi, finish))
    }

    /// The plan that [`Plan3d::save`] made of the very same parameters; nothing from any other bytes.
    pub fn load(&self, bytes: &[u8]) -> Option<Plan3d> {
        let mut reader = Reader::file(bytes, Kind::Deep, &self.inputs())?;
        let frame = self.frame().ok()?;
        let rough = reader.list(24, |r| {
            let cross = Cross::new(&frame.slopes, r.number()?).ok()?;
            Some((cross, r.clearing()?))
        })?;
        let semi = reader.list(16, |r| {
            let cross = Cross::new(&frame.slopes, r.number()?).ok()?;
            Some((cross, r.finishes()?))
        })?;
        let finish = reader.list(8, Reader::passes)?;
        reader.is_at_end().then(|| self.complete(frame, rough, semi, finish))
    }

    /// The hash of all that the plan depends on.
    fn inputs(&self) -> [u8; 16] {
        let mut writer = Writer::inputs();
        writer.segments(&self.outer.segments);
        writer.profiles(self.islands.iter());
        writer.count(self.depth_profiles.len());
        for profile in &self.depth_profiles {
            writer.byte(u8::from(profile.is_some()));
            if let Some(profile) = profile {
                writer.segments(&profile.segments);
                writer.count(profile.axis);
            }
        }
        writer.numbers([self.surface, self.safety, self.depth, self.wall_stock]);
        writer.byte(u8::from(self.rough.is_some()));
        if let Some(rough) = &self.rough {
            writer.tool(&rough.tool);
            writer.numbers([rough.step, rough.depth_step, rough.entry_angle]);
        }
        writer.byte(u8::from(self.semi.is_some()));
        if let Some(semi) = &self.semi {
            writer.tool(&semi.tool);
            writer.number(semi.depth_step);
        }
        writer.byte(u8::from(self.finish.is_some()));
        if let Some(finish) = &self.finish {
            writer.tool(&finish.tool);
            writer.number(finish.width);
            writer.byte(finish.direction as u8);
        }
        writer.hash()
    }

    fn frame(&self) -> Result<Frame, PocketFault> {
        let surface = in_range(self.surface, "Z")?;
        let safety = in_range(self.safety, "ZS")?;
        let depth = in_range(self.depth, "P")?;
        Problem::DepthMissing.when(depth.abs() < 1e-6, "P")?;
        not_negative(self.wall_stock, "delta")?;
        let tools = (self.rough.iter().map(|r| (r.tool, Stage::Rough)))
            .chain(self.semi.iter().map(|s| (s.tool, Stage::Semi)))
            .chain(self.finish.iter().map(|f| (f.tool, Stage::Finish)));
        for (tool, stage) in tools {
            tool.checked().map_err(|fault| fault.in_stage(stage))?;
        }
        let planes = Planes::new(surface, safety, depth);
        let depth = depth.abs();
        let contours = Contours::checked(&self.outer, &self.islands)?;
        let clockwise = contours.outer.area() < 0.0;
        let slopes = self.slopes(&contours, planes, depth)?;
        let beta = self.rough.as_ref().map_or(0.0, |r| r.entry_angle);
        let entry = |tool: Option<Tool>| tool.map_or(Ok(None), |t| slope(beta, t.entry_angle, "beta"));
        let rough_slope = entry(self.rough.as_ref().map(|r| r.tool))?;
        let semi_slope = entry(self.semi.as_ref().map(|s| s.tool))?;
        Ok(Frame { planes, depth, clockwise, slopes, rough_slope, semi_slope })
    }

    fn complete(
        &self,
        frame: Frame,
        rough: Vec<(Cross, Clearing)>,
        semi: Vec<(Cross, Vec<Finish>)>,
        finish: Vec<Vec<Pass>>,
    ) -> Plan3d {
        let Frame { planes, slopes, rough_slope, semi_slope, .. } = frame;
        let (words, inputs) = (self.clone(), self.inputs());
        Plan3d { planes, slopes, rough, rough_slope, semi, semi_slope, finish, words, inputs }
    }

    fn slopes(&self, contours: &Contours, planes: Planes, depth: f64) -> Result<Vec<Slope>, PocketFault> {
        const NAMES: [&str; SLOPING] = ["Z1", "Z2", "Z3", "Z4"];
        if self.depth_profiles.iter().skip(SLOPING).any(Option::is_some) {
            return Err(Problem::TooManyDepthProfiles.of("Z4"));
        }
        let all = std::iter::once(&contours.outer).chain(&contours.islands);
        all.enumerate()
            .map(|(n, contour)| {
                let start = contour.segments.first().map_or([0.0; 2], Segment::from);
                let lean = match (self.depth_profiles.get(n).and_then(Option::as_ref), NAMES.get(n)) {
                    (Some(profile), Some(name)) => {
                        Lean::new(profile, start, planes, depth, n > 0).map_err(|problem| problem.of(name))?
                    }
                    _ => Lean::upright(),
                };
                let pocket_left = (contour.area() > 0.0) == (n == 0);
                let contour = if pocket_left { contour.clone() } else { contour.reversed() };
                Ok(Slope::new(contour, lean, n > 0))
            })
            .collect()
    }

    fn rough_plan(&self, words: &Rough3d, frame: &Frame) -> Result<Vec<(Cross, Clearing)>, PocketFault> {
        let Frame { slopes, rough_slope: entry, .. } = frame;
        let width = width(words.step, words.tool.radius, "step")?;
        let levels = levels(frame.depth, words.depth_step, words.tool.cutting_length, "I1")?;
        let mut heights: Vec<f64> = levels.depths().map(|depth| -depth).collect();
        // Islands that end below the surface get a level on their tops.
        heights.extend(slopes.iter().filter(|s| s.is_island && s.lean.top < 0.0).map(|s| s.lean.top));
        heights.sort_by(|a, b| b.total_cmp(a));
        heights.dedup_by(|a, b| (*a - *b).abs() < 1e-6);
        let mut rough: Vec<(Cross, Clearing)> = Vec::new();
        let mut moves = 0.0;
        let mut above = APPROACH;
        for height in heights {
            let cross = Cross::new(slopes, height)?;
            let sizes = (words.tool.radius, self.wall_stock, width);
            let clearing = match rough.last() {
                // Upright walls are the same at every level.
                Some((last, clearing)) if last.walls.contours == cross.walls.contours => clearing.clone(),
                _ => Clearing::new(&cross.walls, frame.clockwise, sizes, ["T", "step"])?,
            };
            moves += clearing.moves(above + APPROACH - height, *entry);
            above = height;
            Problem::TooManyMoves.when(moves > MAX_MOVES, "beta")?;
            rough.push((cross, clearing));
        }
        Ok(rough)
    }

    fn semi_plan(
        &self,
        words: &Semi3d,
        frame: &Frame,
        rough: &[(Cross, Clearing)],
    ) -> Result<Vec<(Cross, Vec<Finish>)>, PocketFault> {
        let Frame { slopes, semi_slope: entry, .. } = frame;
        let radius = words.tool.radius;
        let roughing = self.rough.as_ref();
        let same = roughing.is_some_and(|r| (r.tool.radius - radius).abs() < 1e-9);
        let levels = levels(frame.depth, words.depth_step, words.tool.cutting_length, "I2")?;
        let mut semi = Vec::new();
        let mut moves = 0.0;
        for height in levels.depths().map(|depth| -depth) {
            if same && rough.iter().any(|(cross, _)| (cross.height - height).abs() < 1e-6) {
                continue;
            }
            let cross = Cross::new(slopes, height)?;
            // What roughing has opened at this height is what it cut on the next level down.
            let below = rough.iter().find(|(cross, _)| cross.height <= height + 1e-6);
            let from = roughing.map_or(f64::INFINITY, |r| r.tool.radius.max(radius) + self.wall_stock);
            let open = |p: [f64; 2]| below.is_some_and(|(cross, _)| cross.walls.has(p, from));
            let walls = finishes_in(&cross.walls, frame.clockwise, radius, self.wall_stock, 0.0, &open)
                .map_err(|problem| problem.of("profile"))?;
            let one: f64 = walls.iter().map(|w| w.level_moves(APPROACH - height, *entry)).sum();
            moves += one;
            Problem::TooManyMoves.when(moves > MAX_MOVES, "I2")?;
            semi.push((cross, walls));
        }
        Ok(semi)
    }
}

fn finish_plan(words: &Finish3d, frame: &Frame) -> Result<Vec<Vec<Pass>>, PocketFault> {
    let (slopes, floor) = (&frame.slopes, -frame.depth);
    let width = not_negative(words.width, "eps")?;
    let width = if width == 0.0 { words.tool.radius / 4.0 } else { width };
    let mut all = Vec::new();
    let mut moves = 0.0;
    for (n, slope) in slopes.iter().enumerate() {
        let way = slope.lean.way_down(floor, &words.tool, slope.is_island);
        let reach = way.iter().fold(0.0f64, |most, [_, d]| most.max(d.abs()));
        moves += slopes::count(&slope.contour, width, reach) * (way.len() as f64 + 8.0);
        Problem::TooManyMoves.when(moves > MAX_MOVES, "eps")?;
        let mut passes = slopes::passes(slopes, n, floor, &words.tool, width);
        if frame.clockwise {
            passes.reverse();
        }
        all.push(passes);
    }
    Ok(all)
}

impl Cross {
    /// Where the walls stand at a height: each contour inset by its depth profile, an island that ends below
    /// left out.
    pub fn new(slopes: &[Slope], height: f64) -> Result<Cross, PocketFault> {
        const NAMES: [&str; SLOPING] = ["Z1", "Z2", "Z3", "Z4"];
        let (mut outer, mut islands): (Vec<Profile>, Vec<Profile>) = (Vec::new(), Vec::new());
        for (n, slope) in slopes.iter().enumerate() {
            let name = NAMES.get(n).copied().unwrap_or("profile");
            if slope.is_island && slope.lean.top < 0.0 && height >= slope.lean.top - 1e-9 {
                continue;
            }
            let inset = slope.lean.inset(height);
            let inside = if inset < 1e-6 {
                vec![slope.contour.clone()]
            } else {
                // The inset lies inside the contour, whichever side the pocket is on.
                let own = Walls::new([&slope.contour], &[]);
                let rings = own.paths(inset).map_err(|problem| problem.of(name))?;
                rings.into_iter().map(|ring| Profile { segments: ring.segments }).collect()
            };
            if slope.is_island {
                islands.extend(inside);
            } else {
                Problem::WallsMeet.when(inside.is_empty(), name)?;
                outer = inside;
            }
        }
        let start = |p: &Profile| p.segments.first().map_or([f64::NAN; 2], Segment::from);
        for (n, island) in islands.iter().enumerate() {
            let home = outer.iter().any(|o| o.contains(start(island)));
            let meets = outer.iter().chain(islands.iter().take(n)).any(|other| other.touches(island));
            Problem::WallsMeet.when(!home || meets, "Z1")?;
        }
        Ok(Cross { height, walls: Walls::new(&outer, &islands) })
    }
}

impl Plan3d {
    /// Whether there is roughing, semi-finishing and finishing.
    pub fn stages(&self) -> [bool; 3] {
        [self.words.rough.is_some(), self.words.semi.is_some(), self.words.finish.is_some()]
    }

    /// Roughing, from where the tool stands (plane coordinates and tool axis) to the approach plane, or
    /// where nothing follows to the safety plane.
    pub fn rough<S: PocketSink>(&self, from: [f64; 3], sink: &mut S) -> Result<(), S::Error> {
        if self.rough.is_empty() {
            return Ok(());
        }
        let mut pen = Pen::new(self.planes, from, sink);
        let mut inside = false;
        let mut open = self.planes.approach() - APPROACH;
        for (cross, clearing) in &self.rough {
            // Walls lean back: what is free at this level was free at the one above.
            let level =
                Level { bottom: cross.height, open, open_from: clearing.nearest, slope: self.rough_slope };
            clearing.cut(&mut pen, &cross.walls, level, &mut inside)?;
            pen.rapid_height((cross.height + APPROACH).min(self.planes.approach()))?;
            open = cross.height;
        }
        self.leave(&mut pen, self.words.semi.is_some() || self.words.finish.is_some())
    }

    /// Semi-finishing, likewise.
    pub fn semi<S: PocketSink>(&self, from: [f64; 3], sink: &mut S) -> Result<(), S::Error> {
        if self.words.semi.is_none() {
            return Ok(());
        }
        let mut pen = Pen::new(self.planes, from, sink);
        for (cross, walls) in &self.semi {
            for wall in walls {
                wall.cut_level(&mut pen, cross.height, self.semi_slope)?;
            }
        }
        self.leave(&mut pen, self.words.finish.is_some())
    }

    /// Finishing, from where the tool stands to the safety plane.
    pub fn finish<S: PocketSink>(&self, from: [f64; 3], sink: &mut S) -> Result<(), S::Error> {
        let Some(words) = &self.words.finish else { return Ok(()) };
        let mut pen = Pen::new(self.planes, from, sink);
        let rough = self.words.rough.as_ref();
        let from =
            rough.map_or(f64::INFINITY, |r| r.tool.radius.max(words.tool.radius) + self.words.wall_stock);
        let open = |p: [f64; 2], height: f64| {
            let below = self.rough.iter().find(|(cross, _)| cross.height <= height + 1e-6);
            below.is_some_and(|(cross, _)| cross.walls.has(p, from))
        };
        for passes in &self.finish {
            slopes::cut(&mut pen, &self.slopes, &words.tool, passes, words.direction, &open)?;
        }
        pen.rapid_height(self.planes.safety)
    }

    /// The computed paths as bytes, to be kept and loaded again.
    pub fn save(&self) -> Vec<u8> {
        let mut writer = Writer::file(Kind::Deep, &self.inputs);
        writer.count(self.rough.len());
        for (cross, clearing) in &self.rough {
            writer.number(cross.height);
            writer.clearing(clearing);
        }
        writer.count(self.semi.len());
        for (cross, finishes) in &self.semi {
            writer.number(cross.height);
            writer.finishes(finishes);
        }
        writer.count(self.finish.len());
        self.finish.iter().for_each(|passes| writer.passes(passes));
        writer.finish()
    }

    fn leave<S: PocketSink>(&self, pen: &mut Pen<'_, S>, more: bool) -> Result<(), S::Error> {
        pen.rapid_height(if more { self.planes.approach() } else { self.planes.safety })
    }
}
