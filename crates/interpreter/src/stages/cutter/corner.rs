//! Joining two blocks: the tool-centre points about one programmed corner.
//!
//! At the corner the path turns from unit tangent `t₁` to `t₂` by the angle θ. With the offset on the outer
//! side of the turn the corner is *outside*, of α = 180° − θ in the manual's figures; else it is *inside*
//! (α ≥ 180°). The tool passes one to four *tips* there, each the end of a vector from the corner:
//!
//! ```text
//! square to the blocks      d·n₁            d·n₂
//! crossing of the tangents  d·(n₁ + n₂) / (1 + cos θ)
//! carried on by r           d·n₁ + r·t₁     d·n₂ − r·t₂
//! ```
//!
//! | corner | tips |
//! |---|---|
//! | inside | the crossing of the offset curves |
//! | outside, α ≥ 90° | (d·n₁ after an arc,) crossing of the tangents (, d·n₂ before an arc) |
//! | outside, α < 90° | (d·n₁ after an arc,) both carried on (, d·n₂ before an arc) |
//! | start-up | d·n₂; outside with type B as in the mode |
//! | cancel | d·n₁; outside with type B as in the mode |
//!
//! Source: GSK990MC 4.7.3 points 1, 2, 4, 5, 7; outside corners in the mode, whose figures its text lacks,
//! as Fanuc 0i-M cutter compensation C.

use super::offset::{Element, Track};
use super::{Fault, Outside, Reversal, Rules, Shape, StartUp};
use ferrocut_geometry::vector::{Point, add, along, angle, cross, distance, dot, finite, left, scale};

/// A path that runs back runs exactly back where the two blocks part by less than this, mm: the rounding of
/// their coordinates.
const REVERSAL_MM: f64 = 1e-3;

/// And where they turn by no less than this, 172°: a move as short as the rounding of its coordinates may
/// point anywhere.
const REVERSAL_COS: f64 = -0.99;

/// With an acute corner below 1°, line to line, start-up and cancel of type B go straight to the square
/// point (4.7.3 points 1 d, 4 d).
const NEEDLE_COS: f64 = -0.999_847_695_156_391_2;

/// An inside corner without a crossing is passed over where the tool would cut by no more than this, mm:
/// joints that are tangent but for the rounding of their coordinates.
const UNSEEN_CUT_MM: f64 = 5e-4;

/// Tips of one corner closer than this on both axes are one, mm. Half the least increment: a move from one to the other
/// would vanish in rounding.
const SAME_TIP_MM: f64 = 5e-4;

/// An arc this little beyond a half circle is one, rad: the rounding of its ends.
const HALF_CIRCLE_RAD: f64 = 1e-6;

/// A crossing may lie so far on the wrong side of the corner by rounding, mm.
const WRONG_SIDE_MM: f64 = 1e-6;

/// A change of side uses the crossing of the offset curves up to this many radii from the corner: for lines
/// that turn by θ it lies at `r / sin(θ/2)`, so from 29° on. (Figure 4-7-3-10 has crossings at 54°.) Flatter,
/// the crossing runs away and the vector square to the next block is taken instead.
const SIDE_CHANGE_REACH: f64 = 4.0;

/// Square, carried on, carried on, square; and the one before where the tool stands already.
const MOST_TIPS: usize = 5;

/// Which rule joins the two blocks.
#[derive(Clone, Copy, PartialEq, Eq, Debug)]
pub(super) enum How {
    StartUp,
    Mode,
    Cancel,
    /// The first block ends square whatever follows.
    Square,
    /// The same of the start-up.
    StartedUp,
    /// G39: an arc about the corner.
    Round,
}

/// The points that the tool passes about a corner, and what the corner takes from the arcs it joins.
#[derive(Clone, Copy, Debug)]
pub(super) struct Corner {
    tips: [Point; MOST_TIPS],
    first: usize,
    after_last: usize,
    /// Angle taken from the end of the arc before (negative: added), rad.
    pub trim_before: f64,
    /// Angle taken from the start of the arc after, rad.
    pub trim_after: f64,
    /// The two tips are joined by an arc about the corner with this signed sweep.
    pub round: Option<(Point, f64)>,
    /// The side changes here.
    pub crosses: bool,
    /// No tip may be left out: the tool stands at the first, or passes from side to side.
    pub rigid: bool,
}

impl Corner {
    const EMPTY: Corner = Corner {
        tips: [[0.0; 2]; MOST_TIPS],
        first: 0,
        after_last: 0,
        trim_before: 0.0,
        trim_after: 0.0,
        round: None,
        crosses: false,
        rigid: false,
    };

    /// A corner with the one tip `p`, as a start from a standing tool has.
    pub fn at(p: Point) -> Corner {
        Corner::EMPTY.then(p)
    }

    /// With one tip more.
    fn then(mut self, p: Point) -> Corner {
        if let Some(slot) = self.tips.get_mut(self.after_last) {
            *slot = p;
            self.after_last += 1;
        }
        self
    }

    fn then_if(self, wanted: bool, p: Point) -> Corner {
        if wanted { self.then(p) } else { self }
    }

    pub fn tips(&self) -> &[Point] {
        self.tips.get(self.first..self.after_last).unwrap_or(&[])
    }

    /// Where the block before ends.
    pub fn entry(&self) -> Point {
        self.tips().first().copied().unwrap_or_default()
    }

    /// Where the block after starts.
    pub fn exit(&self) -> Point {
        self.tips().last().copied().unwrap_or_default()
    }

    /// Leaves out the first tip, unless it is the only one.
    pub fn drop_entry(&mut self) -> bool {
        let can = !self.rigid && self.round.is_none() && self.tips().len() > 1;
        self.first += usize::from(can);
        can
    }

    /// Leaves out the last tip, unless it is the only one.
    pub fn drop_exit(&mut self) -> bool {
        let can = !self.rigid && self.round.is_none() && self.tips().len() > 1;
        self.after_last -= usize::from(can);
        can
    }

    /// Of tips closer than the limit on both axes the later is left out. To keep the exit the earlier goes instead.
    fn thin(self, limit: f64, keep_exit: bool) -> Corner {
        let near = |a: Point, b: Point| (a[0] - b[0]).abs() <= limit && (a[1] - b[1]).abs() <= limit;
        let mut thin = Corner { first: 0, after_last: 0, ..self };
        for &p in self.tips() {
            let first = thin.tips().is_empty();
            thin = thin.then_if(first || !near(thin.exit(), p), p);
        }
        if keep_exit {
            thin.after_last = thin.after_last.saturating_sub(1);
            thin = thin.then(self.exit());
        }
        thin
    }

    /// GSK990MC 4.7.3 point 9: going round an outside corner, of vectors closer than ΔV on both axes the later is ignored,
    /// but not before more than half a circle, which would be lost. A lesser arc goes from where the tool stands.
    fn ignore_later(self, b: &Element, rules: &Rules) -> Corner {
        let beyond_half = match b.shape {
            Shape::Arc { sweep, .. } => sweep.abs() > std::f64::consts::PI + HALF_CIRCLE_RAD,
            Shape::Line => false,
        };
        if self.round.is_some() || beyond_half {
            return self;
        }
        let mut thin = self.thin(rules.corner_limit, false);
        if b.is_arc() && thin.exit() != self.exit() {
            let (_, behind) = b.start_track(b.radius).ahead(thin.exit());
            thin.trim_after = shortest(behind);
        }
        thin
    }

    fn finite(self) -> Result<Corner, Fault> {
        let fine = self.tips().iter().all(|&p| finite(p)) && (self.trim_before + self.trim_after).is_finite();
        if fine { Ok(self) } else { Err(Fault::NoIntersection) }
    }
}

/// Which way the path turns, as seen by the tool.
#[derive(Clone, Copy, PartialEq, Eq)]
enum Turn {
    Inside,
    Outside,
}

/// Joins block `a` to block `b` with the radius of `a`: a new D takes effect at the end of the block that
/// carries it (4.7.3 point 12 b).
pub(super) fn join(a: &Element, b: &Element, how: How, rules: &Rules) -> Result<Corner, Fault> {
    let r = a.radius;
    let turn = turn(a, b, rules)?;
    let corner = match how {
        How::StartUp => start_up(a, b, r, turn, rules),
        How::Cancel => cancel(a, b, r, turn, rules),
        How::Square => square(a, b, r, turn, rules),
        How::StartedUp => started_up(a, b, r, turn, rules),
        _ if a.side != b.side => change_side(a, b, r),
        How::Round => round(a, b, r, turn)?,
        How::Mode => match turn {
            Turn::Inside => inside(a, b, r)?,
            Turn::Outside => outside(a, b, r, rules),
        },
    };
    let corner = corner.thin(SAME_TIP_MM, b.is_arc());
    let corner = match turn {
        Turn::Outside if a.side == b.side => corner.ignore_later(b, rules),
        _ => corner,
    };
    corner.finite()
}

/// Exactly back, the curvatures decide: `b` bends to the tool's side of `a` (inside) where `d·(κ₁ + κ₂) < 0`.
fn turn(a: &Element, b: &Element, rules: &Rules) -> Result<Turn, Fault> {
    let (sine, cosine) = (cross(a.end, b.start), dot(a.end, b.start));
    let inside = if cosine < REVERSAL_COS && sine.abs() * a.length().min(b.length()) < REVERSAL_MM {
        if rules.reversal == Reversal::Fault {
            return Err(Fault::Reversal);
        }
        b.side * (a.curvature() + b.curvature()) < 0.0
    } else {
        b.side * sine > 0.0
    };
    Ok(if inside { Turn::Inside } else { Turn::Outside })
}

fn start_up(a: &Element, b: &Element, r: f64, turn: Turn, rules: &Rules) -> Corner {
    match turn {
        Turn::Outside if goes_round(a, b, rules) => outside(a, b, r, rules),
        _ => Corner::at(b.start_tip(r)),
    }
}

fn cancel(a: &Element, b: &Element, r: f64, turn: Turn, rules: &Rules) -> Corner {
    match turn {
        Turn::Outside if goes_round(a, b, rules) => outside(a, b, r, rules),
        _ => Corner::at(a.end_tip(r)),
    }
}

/// Type B, but not round a needle.
fn goes_round(a: &Element, b: &Element, rules: &Rules) -> bool {
    let needle = !a.is_arc() && !b.is_arc() && dot(a.end, b.start) < NEEDLE_COS;
    rules.start_up == StartUp::B && a.side == b.side && !needle
}

/// The block before has ended square; outside, the tool still goes round the corner from there. Inside, a
/// line starts where the tool stands and an arc is reached by a straight piece (4.7.3 points 7 and 8).
fn square(a: &Element, b: &Element, r: f64, turn: Turn, rules: &Rules) -> Corner {
    let stand = Corner::at(a.end_tip(r));
    let corner = match turn {
        Turn::Outside if a.side == b.side => {
            let way = outside(a, b, r, rules);
            way.tips().iter().fold(Corner { round: way.round, ..stand }, |c, &p| c.then_if(p != c.exit(), p))
        }
        _ => stand.then_if(b.is_arc(), b.start_tip(r)),
    };
    Corner { rigid: true, ..corner }
}

/// The start-up has ended square to itself, which is on no contour: inside, the tool goes to where the next block starts.
fn started_up(a: &Element, b: &Element, r: f64, turn: Turn, rules: &Rules) -> Corner {
    match turn {
        Turn::Outside if a.side == b.side => square(a, b, r, turn, rules),
        _ => Corner { rigid: true, ..joint(a, b, r) },
    }
}

fn outside(a: &Element, b: &Element, r: f64, rules: &Rules) -> Corner {
    if rules.outside == Outside::Arc {
        return arc_about(a, b, r);
    }
    let (square_a, square_b) = (a.end_tip(r), b.start_tip(r));
    let cosine = dot(a.end, b.start);
    let start = Corner::EMPTY.then_if(a.is_arc(), square_a);
    let way = if cosine >= 0.0 {
        let bisector = scale(add(left(a.end), left(b.start)), a.side);
        start.then(along(a.to, bisector, r / (1.0 + cosine)))
    } else {
        start.then(along(square_a, a.end, r)).then(along(square_b, b.start, -r))
    };
    way.then_if(b.is_arc(), square_b)
}

/// From square to square, straight.
fn joint(a: &Element, b: &Element, r: f64) -> Corner {
    Corner::at(a.end_tip(r)).then(b.start_tip(r))
}

/// From square to square on an arc about the corner, with the turn of the path.
fn arc_about(a: &Element, b: &Element, r: f64) -> Corner {
    let sweep = -a.side * angle(a.end, b.start).abs();
    Corner { round: Some((a.to, sweep)), ..joint(a, b, r) }
}

/// G39 (4.7.4). It has no arc to make inside a corner.
fn round(a: &Element, b: &Element, r: f64, turn: Turn) -> Result<Corner, Fault> {
    match turn {
        Turn::Outside => Ok(arc_about(a, b, r)),
        Turn::Inside if nearly_tangent(a, b, r) => Ok(joint(a, b, r)),
        Turn::Inside => Err(Fault::Interference),
    }
}

/// Whether passing over an inside corner from square to square cuts nothing that counts: `r·(1 − cos θ)`.
fn nearly_tangent(a: &Element, b: &Element, r: f64) -> bool {
    let cosine = dot(a.end, b.start);
    cosine > 0.0 && r * (1.0 - cosine) <= UNSEEN_CUT_MM
}

/// The crossing of the offset curves that the tool meets first: the one nearest to the corner, back along
/// `a` and ahead along `b`.
fn inside(a: &Element, b: &Element, r: f64) -> Result<Corner, Fault> {
    let (end, start) = (a.end_track(r), b.start_track(r));
    let joint = joint(a, b, r);
    // Tangent but for rounding, or a path that is theory only because the check is off.
    if joint.thin(SAME_TIP_MM, false).tips().len() == 1 || !end.exists() || !start.exists() {
        return Ok(joint);
    }
    if let Some(corner) = nearest(&end, &start) {
        return Ok(corner);
    }
    if nearly_tangent(a, b, r) { Ok(joint) } else { Err(Fault::NoIntersection) }
}

fn nearest(end: &Track, start: &Track) -> Option<Corner> {
    let mut best: Option<(f64, Corner)> = None;
    for p in end.crossings(start)? {
        let ((back, trim_before), (ahead, trim_after)) = (end.behind(p), start.ahead(p));
        let way = back + ahead;
        if back >= -WRONG_SIDE_MM && ahead >= -WRONG_SIDE_MM && best.is_none_or(|(w, _)| way < w) {
            best = Some((way, Corner { trim_before, trim_after, ..Corner::at(p) }));
        }
    }
    best.map(|(_, corner)| corner)
}

/// From one side of the path to the other there is no inside nor outside (4.7.3 point 5): the curves cross,
/// or the vector stands square to the next block. A line leads to it straight, an arc ends square first.
fn change_side(a: &Element, b: &Element, r: f64) -> Corner {
    let (end, start) = (a.end_track(r), b.start_track(r));
    let mut best: Option<(f64, Corner)> = None;
    if end.exists() && start.exists() {
        for p in end.crossings(&start).unwrap_or([[f64::NAN; 2]; 2]) {
            let reach = distance(p, a.to);
            let ((back, before), (ahead, after)) = (end.behind(p), start.ahead(p));
            let (before, after) = (shortest(before), shortest(after));
            let on_lines = (a.is_arc() || back <= a.length()) && (b.is_arc() || ahead <= b.length());
            if on_lines && reach <= SIDE_CHANGE_REACH * r && best.is_none_or(|(d, _)| reach < d) {
                best = Some((reach, Corner { trim_before: before, trim_after: after, ..Corner::at(p) }));
            }
        }
    }
    let corner = match best {
        Some((_, corner)) => corner,
        None if a.is_arc() => joint(a, b, r),
        None => Corner::at(start.tip),
    };
    Corner { crosses: true, rigid: true, ..corner }
}

/// An angle 0…2π as the shorter way, −π…π.
fn shortest(a: f64) -> f64 {
    use std::f64::consts::{PI, TAU};
    if a > PI { a - TAU } else { a }
}
