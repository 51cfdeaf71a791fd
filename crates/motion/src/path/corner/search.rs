//! Which swing a corner between two lines takes ([`crate::path::swing`]).
//!
//! Of what makes a swing, in proportion ([`Proportions`]), some are tried, each with each, and from the best of them on what is
//! a step beside it. What counts is what the corner costs between the lines beside it ([`Lines`]). For a corner that is like
//! one of the last ([`Recent`]), as at the ends of the rows of a raster, what was found for that is taken.

use super::{Corner, Directions, Form, norm, pace_below, paced};
use crate::limits::{Drive, Inverse};
use crate::path::swing::Swing;
use crate::timing::ramp::{Foot, Phases, STOP_ROOM};
use ferrocut_geometry::{AXES, Position};

/// What is tried at first, each with each.
struct Tries {
    /// Jerks of the second half of the middle, as parts of that of the first.
    leans: &'static [f64],
    /// Jerks out, and at the end, as parts of one another.
    jerks: &'static [[f64; 2]],
    /// Of the share at which a swing is as far out as in.
    parts: &'static [f64],
    /// Shares of the reach that the tolerance allows.
    sizes: &'static [f64],
}

/// Of ways that swing out.
const SWINGING: Tries = Tries {
    leans: &[1.0, 0.5, 0.25, -0.25],
    jerks: &[[0.12, 0.5], [0.25, 1.0], [0.5, 0.5], [0.25, -0.25], [0.12, -0.25], [0.5, -0.5], [1.0, -0.5]],
    parts: &[1.0, 0.97, 0.93, 0.87, 0.7],
    sizes: &[1.0],
};

/// Of those that do not, and turn the most at the vertex.
const LEANING: Tries = Tries {
    leans: &[0.75, 0.5, 0.25, 0.0, -0.1, -0.25],
    jerks: &[[0.0, 0.0]],
    parts: &[0.0],
    sizes: &[1.0, 0.8],
};

/// Steps about the best of them.
const STEPS: [f64; 6] = [0.5, 0.5, 0.3, 0.15, 0.07, 0.03];

/// What makes a swing, in proportion.
#[derive(Clone, Copy, Debug)]
struct Proportions {
    /// `μ₂` to `μ₁`.
    lean: f64,
    /// `σ` to `ν`.
    out: f64,
    end: f64,
    /// Of the share at which it is as far out as in.
    part: f64,
    /// Of the reach that the tolerance allows.
    size: f64,
}

impl Proportions {
    /// How many are beside it.
    const BESIDE: usize = 10;

    /// One of those.
    fn beside(self, k: usize, step: f64) -> Proportions {
        let step = if k.is_multiple_of(2) { step } else { -step };
        match k / 2 {
            0 => Proportions { part: (self.part + 0.12 * step).clamp(0.0, 1.0), ..self },
            1 => Proportions { lean: (self.lean + 0.5 * step).min(1.0), ..self },
            2 => Proportions { end: self.end + step, ..self },
            3 => Proportions { size: (self.size * (1.0 + 0.5 * step)).min(1.0), ..self },
            _ => Proportions { out: self.out * (1.0 + step), ..self },
        }
    }
}

/// Share of the way to stop that there is between two swings: the path can be stopped behind the second or third.
const SLOWING: f64 = 0.6;

/// Share of the tolerance that a swing takes, for rounding.
const SWING_SHARE: f64 = 0.9999;

/// A swing must be worth this.
const WORTH: f64 = 0.99;

/// Places in which the speed of a swing is looked at.
const LOOKS: u32 = 64;

/// The lines beside a corner, by which a swing is chosen.
#[derive(Clone, Copy, Debug)]
pub(crate) struct Lines {
    pub tolerance: f64,
    /// The one before and the one behind it.
    pub sides: [Side; 2],
}

/// One of them.
#[derive(Clone, Copy, PartialEq, Debug)]
pub(crate) struct Side {
    /// mm.
    pub len: f64,
    /// The speed that it is run with, mm/s.
    pub feed: f64,
    pub drive: Drive,
    pub end: Far,
}

/// What is at the other end of a line beside a corner.
#[derive(Clone, Copy, PartialEq, Eq, Debug)]
pub(crate) enum Far {
    /// A corner like it.
    Corner,
    Rest,
    /// Something that the path is to be stopped before.
    Other,
}

impl Side {
    /// Whether it is long enough for this corner, at this pace, at both its ends: between them the acceleration is taken back
    /// and built up again.
    fn fits(&self, corner: &Corner, pace: f64) -> bool {
        let foot = paced(corner.foot, pace.min(pace_below(corner.foot, self.feed, self.drive.j)));
        let way = match self.end {
            Far::Corner => {
                let way = 2.0 * foot.distance(foot.top(self.drive.j), self.drive).unwrap_or(f64::INFINITY);
                way.max(SLOWING * foot.room(self.drive))
            }
            Far::Rest | Far::Other => STOP_ROOM * foot.room(self.drive),
        };
        self.taken(corner.reach) + way <= self.len
    }

    /// How much of it such corners take.
    fn taken(&self, reach: f64) -> f64 {
        if self.end == Far::Rest { reach } else { 2.0 * reach }
    }

    /// What a corner costs on it that begins or ends with this state and reach: where the line is too short to get to the feed,
    /// up to where the ramps of two such corners meet.
    pub(super) fn lost(&self, foot: Foot, reach: f64) -> f64 {
        let &Side { len, feed, drive, .. } = self;
        let half = (0.5 * len - reach).max(0.0);
        let way = foot.distance(feed, drive).unwrap_or(0.0);
        if way <= half {
            return Phases::new(foot, feed, drive).total() - (way + reach) / feed;
        }
        let top = foot.reached(half, drive).clamp(foot.top(drive.j).min(feed), feed);
        Phases::new(foot, top, drive).total() - 0.5 * len / feed
    }
}

/// Corners that are remembered.
const RECENT: usize = 8;

/// Numbers that differ by no more than this share of the larger are alike, and directions by this distance.
const ALIKE: f64 = 0.01;

/// What was found for the last corners of a path: a swing for one that is like another may differ by a little from what would be
/// found for itself, within all limits.
#[derive(Debug, Default)]
pub(crate) struct Recent {
    known: [Option<(Likeness, Option<Proportions>)>; RECENT],
    next: usize,
}

impl Recent {
    pub fn clear(&mut self) {
        *self = Recent::default();
    }

    /// What was found for one like this: a swing, or that it is quicker without.
    fn find(&self, corner: &Likeness) -> Option<Option<Proportions>> {
        let known = self.known.iter().flatten().find(|(known, _)| known.is_like(corner));
        known.map(|(_, found)| *found)
    }

    fn keep(&mut self, corner: Likeness, found: Option<Proportions>) {
        if let Some(place) = self.known.get_mut(self.next) {
            *place = Some((corner, found));
        }
        self.next = (self.next + 1) % RECENT;
    }
}

/// By what corners are alike.
#[derive(Clone, Copy, Debug)]
struct Likeness {
    lines: Lines,
    /// Both directions, each axis turned so that the first is not negative.
    directions: [[f64; 2]; AXES],
}

impl Likeness {
    fn new(d1: &[f64; AXES], d2: &[f64; AXES], lines: &Lines) -> Likeness {
        let turned = |i: usize| if d1[i] < 0.0 || d1[i] == 0.0 && d2[i] < 0.0 { -1.0 } else { 1.0 };
        let directions = std::array::from_fn(|i| [turned(i) * d1[i], turned(i) * d2[i]]);
        Likeness { lines: *lines, directions }
    }

    fn is_like(&self, other: &Likeness) -> bool {
        let near = |a: f64, b: f64| (a - b).abs() <= ALIKE * a.max(b);
        let lines = self.lines.sides.iter().zip(&other.lines.sides).all(|(one, other)| {
            one.end == other.end
                && near(one.len, other.len)
                && near(one.feed, other.feed)
                && near(one.drive.a, other.drive.a)
                && near(one.drive.j, other.drive.j)
        });
        let apart = |axis: usize| {
            let ([a, b], [c, d]) = (self.directions[axis], other.directions[axis]);
            (a - c) * (a - c) + (b - d) * (b - d)
        };
        self.lines.tolerance == other.lines.tolerance
            && lines
            && (0..AXES).map(apart).sum::<f64>() <= ALIKE * ALIKE
    }
}

impl Corner {
    /// The same corner between two lines that swings out, if that is quicker.
    pub fn swinging(self, lines: &Lines, inverse: &Inverse, recent: &mut Recent) -> Corner {
        if self.form != Form::Cubic {
            return self;
        }
        let (d1, d2) = (self.before.slope(0.0), self.after.slope(0.0));
        let turn = norm(&(d2 - d1).0);
        let sine = off_line(&d1, &d2).max(off_line(&d2, &d1));
        let directions = Directions::new(d1, d2, inverse);
        // Jerks, and the share at which it is as far out as in.
        let even = |Proportions { lean, out, end, .. }: Proportions| {
            let middle = directions.jerk(-lean, 1.0).max(directions.jerk(-1.0, lean)).max(1e-12).recip();
            // As much of both as one axis has.
            let most = directions.jerk(end, out).max(directions.jerk(out, end)).max(1e-12).recip();
            let jerks = [out * most, middle, lean * middle, end * most];
            let is_out = |share: f64| {
                Swing::new(share, jerks).is_none_or(|swing| swing.depth() * sine > swing.at(0.5)[0] * turn)
            };
            (jerks, largest(is_out))
        };
        // The corner with these jerks and this share, and what it costs.
        let swung = |jerks: [f64; 4], share: f64, size: f64| {
            let swing = Swing::new(share, jerks)?;
            let depth = (swing.at(0.5)[0] * turn).max(swing.depth() * sine);
            if !(depth > 0.0) {
                return None;
            }
            let reach = size * SWING_SHARE * lines.tolerance / depth;
            if lines.sides.iter().any(|side| side.taken(reach) > side.len) {
                return None;
            }
            let corner = self.swung(swing, reach, &directions);
            Some((corner, corner.loss_within(lines)?))
        };
        let likeness = Likeness::new(&d1.0, &d2.0, lines);
        let known = recent.find(&likeness).and_then(|known| {
            let Some(to) = known else { return Some(self) };
            let (jerks, even) = even(to);
            swung(jerks, to.part * even, to.size).map(|(corner, _)| corner.with_haste())
        });
        if let Some(known) = known {
            return known;
        }
        // The best of those that are tried at first, and of what is found in steps from there.
        let search = |tries: Tries| {
            let (mut best, mut at) = ((self, f64::INFINITY), None);
            let mut look = |jerks: [f64; 4], even: f64, to: Proportions| {
                let Some(found) = swung(jerks, to.part * even, to.size).filter(|(_, loss)| *loss < best.1)
                else {
                    return false;
                };
                best = found;
                true
            };
            for lean in tries.leans.iter().copied() {
                for [out, end] in tries.jerks.iter().copied() {
                    let first = Proportions { lean, out, end, part: 1.0, size: 1.0 };
                    let (jerks, even) = even(first);
                    for (part, size) in
                        tries.parts.iter().flat_map(|part| tries.sizes.iter().map(move |size| (*part, *size)))
                    {
                        let to = Proportions { part, size, ..first };
                        if look(jerks, even, to) {
                            at = Some(to);
                        }
                    }
                }
            }
            for step in STEPS {
                for k in 0..Proportions::BESIDE {
                    let Some(from) = at else { break };
                    let to = from.beside(k, step);
                    let (jerks, even) = even(to);
                    if look(jerks, even, to) {
                        at = Some(to);
                    }
                }
            }
            (best, at)
        };
        let swinging = search(SWINGING);
        let leaning = search(LEANING);
        let ((best, loss), at) = if leaning.0.1 < swinging.0.1 { leaning } else { swinging };
        let is_worth = self.loss_within(lines).is_none_or(|own| loss < WORTH * own);
        let found = at.filter(|_| is_worth);
        recent.keep(likeness, found);
        if found.is_some() { best.with_haste() } else { self }
    }

    /// The same with the highest speed in it as it is: a swing may be faster between its ends.
    fn with_haste(self) -> Corner {
        let fastest = (1..LOOKS).map(|k| self.speed(f64::from(k) / f64::from(LOOKS))).fold(0.0, f64::max);
        Corner { haste: (fastest / self.foot.v).max(1.0), ..self }
    }

    /// The same with this way of its sides.
    fn swung(self, swing: Swing, reach: f64, directions: &Directions) -> Corner {
        let [start, out, half, back, end] = swing.bends();
        let [first, rise, fall, last] = swing.jerks();
        let square = [[end, start], [back, out], [half, half], [out, back], [start, end]]
            .map(|[left, gone]| directions.acceleration(left, gone))
            .into_iter()
            .fold(0.0, f64::max);
        // The left side is run backward: its third derivative has the other sign.
        let cube = [[last, first], [fall, rise], [rise, fall], [first, last]]
            .map(|[left, gone]| directions.jerk(-left, gone))
            .into_iter()
            .fold(0.0, f64::max);
        let time = (reach * square).sqrt().max((reach * cube).cbrt());
        let [_, slope, bend] = swing.at(1.0);
        let foot = Foot { v: reach * slope / time, a: reach * bend / (time * time) };
        Corner { form: Form::Swing(swing), reach, time, foot, ..self }
    }

    /// What it costs between two lines: at the highest pace for which they are long enough. `None` where they are for none.
    fn loss_within(&self, lines: &Lines) -> Option<f64> {
        let sides = lines.sides.each_ref();
        let fits = |pace: f64| sides.iter().all(|side| side.fits(self, pace));
        if fits(1.0) {
            return Some(self.loss_at(sides, 1.0));
        }
        let (mut low, mut high) = (0.0, 1.0);
        for _ in 0..5 {
            let middle = 0.5 * (low + high);
            if fits(middle) { low = middle } else { high = middle }
        }
        (low > 0.0).then(|| self.loss_at(sides, low))
    }
}

/// How far a step of `d` leads off the line in the direction `line`: `sin θ` for two that are one long, which those are not
/// in which rotary axes turn.
fn off_line(d: &Position, line: &Position) -> f64 {
    let product = |a: &Position, b: &Position| a.0.iter().zip(b.0).map(|(a, b)| a * b).sum::<f64>();
    let along = product(d, line) / product(line, line);
    norm(&d.zip(*line, |d, line| d - along * line).0)
}

/// The highest share of a swing, up to a third, that is not `too_far`.
fn largest(too_far: impl Fn(f64) -> bool) -> f64 {
    let (mut low, mut high) = (0.0, 1.0 / 3.0);
    for _ in 0..8 {
        let middle = 0.5 * (low + high);
        if too_far(middle) {
            high = middle;
        } else {
            low = middle;
        }
    }
    low
}
