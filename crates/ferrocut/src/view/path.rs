//! The path of the tool, gathered step by step and thinned as it comes.
//!
//! Points are kept as finely as the largest picture can show and no finer: a chord may leave the path
//! by a fraction of the part's size. That size only grows, so what was thin enough stays thin
//! enough, and what was kept before the part grew is thinned again when memory fills up. A program of
//! many millions of moves therefore takes the memory of its picture, not of its text.

use super::extent::{Extent, Point3, zip};
use super::thin::Thinner;
use ferrocut_geometry::{Arc, Axis, Position};
use ferrocut_toolpath::Op;
use std::f64::consts::TAU;

/// How a stretch of the path is run.
#[derive(Clone, Copy, PartialEq, Eq, Debug)]
pub enum Kind {
    /// Positioning.
    Rapid,
    /// Any other move.
    Cut,
}

/// A stretch of one kind: its points end before `end` in the list of all points.
struct Run {
    kind: Kind,
    end: usize,
}

/// What was moved, in numbers.
#[derive(Clone, Copy, Default, Debug)]
pub struct Tally {
    /// Positioning moves.
    pub rapids: u64,
    /// Cutting moves.
    pub cuts: u64,
    /// Length of the cutting moves over X, Y, Z, mm.
    pub cut_mm: f64,
}

/// Finest detail kept, as a part of the longest side: a third of a pixel in the widest picture.
const FINEST: f64 = 1.0 / 16384.0;
/// Coarsest detail kept, when there is more path than memory for it: below a pixel at 1600.
const COARSEST: f64 = 1.0 / 2048.0;
/// Points held before old ones are thinned again: 24 bytes each.
const MANY_POINTS: usize = 1 << 21;
/// Coordinates are held within this, mm, so that no square or difference of them overflows.
const FAR: f64 = 1e15;
/// Turns of one helix that are drawn; more make the same closed tube.
const MOST_TURNS: f64 = 2000.0;
/// Chords of one turn at most, at least.
const CHORDS: (f64, f64) = (512.0, 12.0);

/// The path of a program, in machine coordinates of X, Y and Z.
///
/// Memory is bounded by what a picture can show; only a path with more separate corners than that
/// (over two million) takes more. A rapid move is drawn as the straight line to its end, also where
/// each axis runs at its own rate: the bend depends on the machine.
pub struct PathModel {
    start: Point3,
    at: Position,
    zero: Option<Point3>,
    points: Vec<Point3>,
    runs: Vec<Run>,
    open: Option<Thinner>,
    detail: f64,
    room: usize,
    cut: Extent,
    rapid: Extent,
    /// The largest Z of cuts that move along the table too.
    highest_run: Option<f64>,
    tally: Tally,
}

impl PathModel {
    /// A path of axes that stand at `start`.
    pub fn new(start: Position) -> PathModel {
        let at = Position::ZERO.zip(start, keep_finite);
        PathModel {
            start: xyz(at),
            at,
            zero: None,
            points: Vec::new(),
            runs: Vec::new(),
            open: None,
            detail: FINEST,
            room: MANY_POINTS,
            cut: Extent::EMPTY,
            rapid: Extent::EMPTY,
            highest_run: None,
            tally: Tally::default(),
        }
    }

    /// Lets the picture count from the work zero at `zero`, machine coordinates, and mark it.
    /// Without it the picture shows machine coordinates.
    pub fn set_work_zero(&mut self, zero: Position) {
        self.zero = Some(xyz(Position::ZERO.zip(zero, keep_finite)));
    }

    /// Takes the next step; steps that move nothing are passed over.
    pub fn step(&mut self, op: &Op) {
        if let Op::Datum { at } = op {
            // The same place by another name: what follows is drawn from there.
            self.close();
            self.at = self.at.zip(*at, keep_finite);
        }
        let Some(target) = op.target() else { return };
        let from = self.at;
        let to = from.zip(*target, keep_finite);
        let kind = if op.is_cutting() { Kind::Cut } else { Kind::Rapid };
        match kind {
            Kind::Rapid => self.tally.rapids += 1,
            Kind::Cut => self.tally.cuts += 1,
        }
        let along_table = [Axis::X, Axis::Y].into_iter().any(|a| from[a] != to[a]);
        if kind == Kind::Cut && (along_table || matches!(op, Op::Arc { .. })) {
            let z = from[Axis::Z].max(to[Axis::Z]);
            self.highest_run = Some(self.highest_run.map_or(z, |highest| highest.max(z)));
        }
        self.begin(kind);
        match op.arc(from) {
            Some(arc) => self.arc(Arc { end: to, ..arc }),
            None => self.line(kind, from, to),
        }
        self.at = to;
        if self.points.len() >= self.room {
            self.thin_again();
        }
    }

    /// Where the axes stood first.
    pub fn start(&self) -> Point3 {
        self.start
    }

    /// Where the axes stand after the last step.
    pub fn end(&self) -> Point3 {
        xyz(self.at)
    }

    /// The work zero, if one was set.
    pub fn work_zero(&self) -> Option<Point3> {
        self.zero
    }

    /// What was moved.
    pub fn tally(&self) -> Tally {
        self.tally
    }

    /// The box of the cutting moves.
    pub fn cut_extent(&self) -> &Extent {
        &self.cut
    }

    /// The largest Z of the cuts that move along the table; `None` where all are plunges. A plunge
    /// begins in the air, so its start says nothing of the part.
    pub fn highest_run(&self) -> Option<f64> {
        self.highest_run
    }

    /// The box of the positioning moves.
    pub fn rapid_extent(&self) -> &Extent {
        &self.rapid
    }

    /// Every stretch of the path in order. Neighbours share a point.
    pub fn runs(&self) -> impl Iterator<Item = (Kind, impl Iterator<Item = Point3>)> {
        let mut first = 0;
        self.runs.iter().map(move |run| {
            let points = self.points.get(first..run.end).unwrap_or_default();
            first = run.end;
            // Only the last stretch can still be open.
            let open = (run.end == self.points.len()).then_some(self.open.as_ref()).flatten();
            (run.kind, points.iter().copied().chain(open.into_iter().flat_map(Thinner::pending)))
        })
    }

    fn line(&mut self, kind: Kind, from: Position, to: Position) {
        let extent = match kind {
            Kind::Rapid => &mut self.rapid,
            Kind::Cut => &mut self.cut,
        };
        extent.add(xyz(from));
        extent.add(xyz(to));
        if kind == Kind::Cut {
            self.tally.cut_mm += length(xyz(from), xyz(to));
        }
        self.point(xyz(to));
    }

    /// Flattens an arc into chords that stay within the detail kept.
    fn arc(&mut self, arc: Arc) {
        let radius = arc.start_radius().max(arc.end_radius());
        let usable = arc.sweep.is_finite() && radius < FAR;
        if !usable || arc.sweep == 0.0 {
            return self.line(Kind::Cut, arc.start, arc.end);
        }
        self.tally.cut_mm += arc.length();
        let turns = arc.sweep.abs() / TAU;
        let left_out = (turns - MOST_TURNS).ceil().max(0.0) * TAU;
        let drawn = Arc { sweep: arc.sweep - left_out.copysign(arc.sweep), ..arc };
        let (min, max) = drawn.extent();
        self.cut.add(xyz(min));
        self.cut.add(xyz(max));
        // Height of a chord over its arc: r·(1 − cos(φ/2)) ≈ r·φ²/8.
        let height = self.tolerance().max(f64::MIN_POSITIVE);
        let per_turn = (TAU / (8.0 * height / radius).sqrt()).clamp(CHORDS.1, CHORDS.0);
        let chords = (drawn.sweep.abs() / TAU * per_turn).ceil().max(1.0);
        let mut i = 1.0;
        while i < chords {
            let p = xyz(drawn.at(i / chords));
            // An arc whose sweep does not lead to its end may leave the box of its quadrants.
            self.cut.add(p);
            self.point(p);
            i += 1.0;
        }
        self.point(xyz(arc.end));
    }

    /// Starts a new stretch unless the last one is of this kind.
    fn begin(&mut self, kind: Kind) {
        if self.open.is_some() && self.runs.last().is_some_and(|r| r.kind == kind) {
            return;
        }
        self.close();
        let first = xyz(self.at);
        self.points.push(first);
        self.runs.push(Run { kind, end: self.points.len() });
        self.open = Some(Thinner::new(first, self.tolerance()));
    }

    fn point(&mut self, p: Point3) {
        let tolerance = self.tolerance();
        if let Some(thinner) = &mut self.open {
            thinner.set_tolerance(tolerance);
            self.points.extend(thinner.push(p));
        }
        self.mark_end();
    }

    fn close(&mut self) {
        if let Some(thinner) = self.open.take() {
            self.points.extend(thinner.pending());
        }
        self.mark_end();
    }

    fn mark_end(&mut self) {
        if let Some(run) = self.runs.last_mut() {
            run.end = self.points.len();
        }
    }

    /// How far what is kept may lie from the path, mm.
    fn tolerance(&self) -> f64 {
        let part = if self.cut.is_empty() { &self.rapid } else { &self.cut };
        // Half of it to the ray, half from the ray to the chord.
        part.longest() * self.detail / 2.0
    }

    /// Thins what was kept while the part was still small. Gives up detail, then memory, if that is
    /// not enough.
    fn thin_again(&mut self) {
        self.close();
        loop {
            self.thin_all();
            if self.points.len() <= self.room / 2 {
                break;
            }
            if self.detail >= COARSEST {
                self.room = self.points.len().saturating_mul(2);
                break;
            }
            self.detail *= 2.0;
        }
        // The last stretch goes on in a new one of its kind.
        if let Some(kind) = self.runs.last().map(|r| r.kind) {
            let first = xyz(self.at);
            self.points.push(first);
            self.runs.push(Run { kind, end: self.points.len() });
            self.open = Some(Thinner::new(first, self.tolerance()));
        }
    }

    fn thin_all(&mut self) {
        let tolerance = self.tolerance();
        let mut kept = Vec::with_capacity(self.room / 2);
        let mut first = 0;
        for run in &mut self.runs {
            let mut points = self.points.get(first..run.end).unwrap_or_default().iter().copied();
            first = run.end;
            if let Some(p) = points.next() {
                kept.push(p);
                let mut thinner = Thinner::new(p, tolerance);
                points.for_each(|p| kept.extend(thinner.push(p)));
                kept.extend(thinner.pending());
            }
            run.end = kept.len();
        }
        self.points = kept;
    }
}

fn xyz(p: Position) -> Point3 {
    [p[Axis::X], p[Axis::Y], p[Axis::Z]]
}

fn length(a: Point3, b: Point3) -> f64 {
    zip(a, b, |a, b| (b - a) * (b - a)).into_iter().sum::<f64>().sqrt()
}

/// A coordinate that can be drawn: `new` held within [`FAR`], or `old` where `new` is no number.
fn keep_finite(old: f64, new: f64) -> f64 {
    if new.is_nan() { old } else { new.clamp(-FAR, FAR) }
}

#[cfg(test)]
mod tests {
    use super::*;
    use ferrocut_geometry::Plane;
    use ferrocut_toolpath::{Feed, FeedAlong, PathMode};

    fn feed(x: f64, y: f64, z: f64) -> Op {
        let to = Position::xyz(x, y, z);
        Op::Feed { to, feed: Feed::PerMinute(100.0), path: PathMode::Continuous }
    }

    fn rapid(x: f64, y: f64, z: f64) -> Op {
        Op::Rapid { to: Position::xyz(x, y, z), straight: true, speed: None, path: PathMode::ON_PATH }
    }

    fn arc(to: Position, center: [f64; 2], sweep: f64) -> Op {
        Op::Arc {
            to,
            plane: Plane::Xy,
            center,
            sweep,
            feed: Feed::PerMinute(100.0),
            feed_along: FeedAlong::Path,
            path: PathMode::Continuous,
        }
    }

    fn runs(model: &PathModel) -> Vec<(Kind, Vec<Point3>)> {
        model.runs().map(|(kind, points)| (kind, points.collect())).collect()
    }

    #[test]
    fn axes_that_are_given_another_position_draw_no_line_there() {
        let mut model = PathModel::new(Position::ZERO);
        model.step(&feed(10.0, 0.0, 0.0));
        model.step(&Op::Datum { at: Position::xyz(100.0, 0.0, 0.0) });
        model.step(&feed(110.0, 0.0, 0.0));
        let cut = |from: f64, to: f64| (Kind::Cut, vec![[from, 0.0, 0.0], [to, 0.0, 0.0]]);
        assert_eq!(runs(&model), [cut(0.0, 10.0), cut(100.0, 110.0)]);
        assert_eq!(model.tally().cut_mm, 20.0);
    }

    #[test]
    fn rapids_and_cuts_are_stretches_that_share_a_point() {
        let mut model = PathModel::new(Position::ZERO);
        for op in [rapid(0.0, 0.0, 5.0), rapid(10.0, 0.0, 5.0), feed(10.0, 0.0, -1.0), feed(20.0, 0.0, -1.0)]
        {
            model.step(&op);
        }
        model.step(&Op::Coolant(true));
        let rapids = vec![[0.0; 3], [0.0, 0.0, 5.0], [10.0, 0.0, 5.0]];
        let cuts = vec![[10.0, 0.0, 5.0], [10.0, 0.0, -1.0], [20.0, 0.0, -1.0]];
        assert_eq!(runs(&model), [(Kind::Rapid, rapids), (Kind::Cut, cuts)]);
        assert_eq!((model.tally().rapids, model.tally().cuts), (2, 2));
        assert_eq!(model.tally().cut_mm, 16.0);
        assert_eq!(model.highest_run(), Some(-1.0));
        assert_eq!(model.cut_extent(), &Extent { min: [10.0, 0.0, -1.0], max: [20.0, 0.0, 5.0] });
    }

    #[test]
    fn chords_stay_on_their_circle() {
        let mut model = PathModel::new(Position::xyz(50.0, 0.0, 0.0));
        model.step(&arc(Position::xyz(50.0, 0.0, 0.0), [0.0, 0.0], TAU));
        let (_, points) = runs(&model).remove(0);
        assert!((40..1000).contains(&points.len()), "{} points", points.len());
        for pair in points.windows(2) {
            let middle = zip(pair[0], pair[1], |a, b| (a + b) / 2.0);
            assert!((middle[0].hypot(middle[1]) - 50.0).abs() < 100.0 * FINEST * 2.0);
        }
        assert_eq!(model.cut_extent().size(), [100.0, 100.0, 0.0]);
    }

    #[test]
    fn a_helix_of_a_million_turns_is_a_tube() {
        let mut model = PathModel::new(Position::xyz(10.0, 0.0, 0.0));
        model.step(&arc(Position::xyz(10.0, 0.0, -100.0), [0.0, 0.0], 1e6 * TAU));
        assert!(model.points.len() < 2_000_000);
        assert_eq!(model.end(), [10.0, 0.0, -100.0]);
    }

    #[test]
    fn many_moves_take_little_memory_and_keep_the_extremes() {
        let mut model = PathModel::new(Position::ZERO);
        for i in 0..6_000_000_u32 {
            let t = f64::from(i) * 1e-4;
            let spike = if i == 3_333_333 { 7.0 } else { 0.0 };
            model.step(&feed(t.cos() * (100.0 + spike), t.sin() * 100.0, -t * 1e-3));
        }
        assert!(model.points.capacity() <= 2 * MANY_POINTS);
        let mut kept = Extent::EMPTY;
        model.runs().for_each(|(_, points)| points.for_each(|p| kept.add(p)));
        let whole = model.cut_extent();
        for i in 0..3 {
            assert!((kept.min[i] - whole.min[i]).abs() <= whole.longest() * COARSEST);
            assert!((kept.max[i] - whole.max[i]).abs() <= whole.longest() * COARSEST);
        }
        assert_eq!(model.tally().cuts, 6_000_000);
    }

    #[test]
    fn corners_that_cannot_be_thinned_are_kept_all_the_same() {
        let mut model = PathModel::new(Position::ZERO);
        let many = MANY_POINTS as u32 + 1000;
        for i in 0..many {
            model.step(&feed(f64::from(i % 2) * 100.0, f64::from(i) * 1e-4, 0.0));
        }
        assert!(model.points.len() >= MANY_POINTS);
    }
}
