//! What the path beside a rounded corner allows: at which pace the corner can be run.
//!
//! Sections on either side of a corner are planned apart, so behind it, and by symmetry before it, there is always to be
//! room to stop: on all that is known of the path, on what of it is fast and straight, or on a curve that is slowed down to.

use crate::limits::Drive;
use crate::path::corner::paced;
use crate::timing::piece::{State, step};
use crate::timing::queue::{Node, Pass};
use crate::timing::ramp::{Foot, STOP_ROOM, distance};

/// How many cells beside a corner are looked at.
pub(crate) const CELLS: usize = 24;

/// Speeds up to this many times that of a corner count there.
const NEAR_CORNER: f64 = 4.0;

/// The same where the path is only slowed down beside it.
const CALM_CORNER: f64 = 2.0;

/// Share of the highest speed at which a curve is come to from a corner: at the highest it leaves nothing to the path.
const THROUGH: f64 = 0.8;

/// Share of the jerk that a curve leaves to the path that a corner beside it counts on.
const SIDE_SHARE: f64 = 0.7;

/// Steps of a plan are about so long, s.
const SHORT_RAMP: f64 = 0.004;

/// The pace of a corner is found to this share of it.
const NARROW: f64 = 1e-7;

/// And no less than this.
const LEAST: f64 = 1e-6;

/// Ways to stop on one side of a corner, of which one is enough.
#[derive(Clone, Copy, Debug)]
pub(crate) struct Beside([Side; 4]);

impl Beside {
    /// The path beside a corner as far as it is known, no further than stopping can take: all of it; what lies before the
    /// first place that is slower than the corner needs, before which the path can be stopped too; and as far as it is
    /// straight as well, where the path can be stopped, or slowed down to what the rest is run with and stopped in that.
    /// Nothing is known of what is not there yet.
    ///
    /// `cap` is the highest speed of the corner, `top` that of a cell; `is_bold` counts the acceleration that the ramp from the
    /// corner has where it is, not that at the corner at a multiple of the speed.
    pub fn new<'a>(
        nodes: impl Iterator<Item = &'a Node>,
        foot: Foot,
        is_bold: bool,
        cap: f64,
        top: impl Fn(&Node) -> f64,
    ) -> Beside {
        let mut all = Side::none(NEAR_CORNER * foot.v, cap);
        let mut calm = Side::none(CALM_CORNER * foot.v, cap);
        let (mut first, mut clear) = (None, None);
        let mut beyond = Beyond::NONE;
        let mut is_line = true;
        // Of the acceleration allowed, the least share that the corner asks for.
        let mut share: f64 = 1.0;
        let mut state = State { v: foot.v, a: foot.a };
        let whole = |side: Side, share: f64, is_line: bool| {
            let share = if is_bold { share } else { side.drive.a / foot.a };
            let mut drive = side.drive;
            if !is_line {
                // Steps on a curve need some room below the cap.
                drive.j *= SIDE_SHARE;
            }
            // The acceleration falls with the square of the pace.
            Side { drive, pace: share.min(1.0).sqrt(), ..side }
        };
        for node in nodes.take(CELLS).take_while(|node| node.pass == Pass::Path) {
            if all.len > STOP_ROOM * foot.room(all.drive) {
                break;
            }
            let top = top(node);
            let is_slow = top < foot.top(all.drive.j);
            if first.is_none() && all.len > 0.0 && is_slow {
                first = Some(whole(all, share, is_line));
            }
            if clear.is_none() && all.len > 0.0 && (is_slow || !node.load.is_straight()) {
                clear = Some(whole(calm, share, is_line));
            }
            if clear.is_some() && !beyond.is_enough() {
                beyond.add(node, top);
            }
            is_line &= node.load.is_straight();
            if is_bold && state.a > 0.0 {
                // The ramp that takes the acceleration back.
                let j = SIDE_SHARE * node.load.most().j;
                let back = state.a / j;
                let peak = state.v + 0.5 * state.a * back;
                let way = back * (state.v + state.a * back / 3.0);
                let to = if way > node.len { step(state, -j, node.len) } else { State { v: peak, a: 0.0 } };
                share = share.min(node.load.room(top.min(to.v)).a / state.a);
                state = to;
            }
            all.add(node, top);
            calm.add(node, top);
        }
        if all.len == 0.0 {
            return Beside([Side { len: f64::INFINITY, ..all }; 4]);
        }
        let all = whole(all, share, is_line);
        let clear = clear.unwrap_or(all);
        let through = if beyond.is_enough() { Side { to: beyond.speed, ..clear } } else { clear };
        Beside([all, first.unwrap_or(all), clear, through])
    }

    /// The same if the path went on as it is where it is not known any more.
    pub fn endless(&self) -> Beside {
        Beside(self.0.map(|side| Side { len: f64::INFINITY, ..side }))
    }

    /// The path begins at rest `len` before the corner.
    pub fn begins_at_rest(&mut self, len: f64) {
        for side in self.0.iter_mut().filter(|side| len < side.len) {
            (side.len, side.to) = (len, 0.0);
        }
    }
}

/// Highest pace, up to 1, of a corner with these sides.
pub(crate) fn pace<'a>(foot: Foot, sides: impl Iterator<Item = &'a Beside> + Clone) -> f64 {
    let fits = |pace: f64| sides.clone().all(|beside| beside.0.iter().any(|side| side.fits(foot, pace)));
    largest(0.0, 1.0, fits).max(LEAST)
}

/// What the path beside a corner allows.
#[derive(Clone, Copy, Debug)]
struct Side {
    /// How long it is known to go on.
    len: f64,
    /// What it leaves to the path all along.
    drive: Drive,
    /// Highest speed all along.
    cap: f64,
    /// Highest pace at which the acceleration at the corner is allowed there.
    pace: f64,
    /// Up to which speed that holds.
    near: f64,
    /// What of the speed need not be gone at its end: the path can be stopped from it behind that.
    to: f64,
}

impl Side {
    /// Nothing yet, at speeds up to `near`, of which none is above `cap`.
    fn none(near: f64, cap: f64) -> Side {
        Side { len: 0.0, drive: Drive::MOST, cap, pace: 1.0, near, to: 0.0 }
    }

    /// Goes on with a cell that is run at no more than `top`.
    fn add(&mut self, node: &Node, top: f64) {
        self.cap = self.cap.min(top);
        // On a curve, what is left at the highest speed.
        let room = node.load.room(top.min(self.near));
        self.drive = self.drive.min(Drive { a: room.a, j: room.j[1] });
        self.len += node.len;
    }

    /// Whether a corner run at this pace leaves room to stop here.
    fn fits(&self, foot: Foot, pace: f64) -> bool {
        let foot = paced(foot, pace);
        let top = foot.top(self.drive.j);
        // A ramp to the corner that is shorter than a step is not planned to where it begins.
        let over = (top - foot.v).min(0.5 * self.drive.j * SHORT_RAMP * SHORT_RAMP);
        pace <= self.pace
            && top + over <= self.cap * (1.0 + 1e-9)
            && top <= self.near
            && foot.room_to(self.to, self.drive) * STOP_ROOM <= self.len
    }
}

/// What lies behind the straight and fast way beside a corner.
#[derive(Clone, Copy, Debug)]
struct Beyond {
    len: f64,
    /// At which speed it is come to, mm/s, and what it leaves to the path at that.
    speed: f64,
    drive: Drive,
}

impl Beyond {
    const NONE: Beyond = Beyond { len: 0.0, speed: f64::INFINITY, drive: Drive::MOST };

    /// Goes on with a cell that is run at no more than `top`.
    fn add(&mut self, node: &Node, top: f64) {
        // Cells before are no worse at a lower speed.
        self.speed = self.speed.min(THROUGH * top);
        let room = node.load.room(self.speed);
        self.drive = self.drive.min(Drive { a: room.a, j: room.j[1] });
        self.len += node.len;
    }

    /// Whether the path can be stopped in it.
    fn is_enough(&self) -> bool {
        self.len > 0.0 && STOP_ROOM * distance(0.0, self.speed, self.drive) <= self.len
    }
}

/// A number from `low`, for which `fits` holds, up to `most` for which it holds too; for one larger by [`NARROW`] it does not.
pub(crate) fn largest(low: f64, most: f64, fits: impl Fn(f64) -> bool) -> f64 {
    if fits(most) {
        return most;
    }
    let (mut low, mut high) = (low, most);
    for _ in 0..40 {
        if high - low <= NARROW * high {
            break;
        }
        let middle = 0.5 * (low + high);
        if fits(middle) {
            low = middle;
        } else {
            high = middle;
        }
    }
    low
}
