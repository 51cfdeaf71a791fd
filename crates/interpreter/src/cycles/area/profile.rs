//! Profiles that the tool follows level by level (Fagor 4.20, 4.21), and how they are put together of
//! elements and corners.

use super::{CLEAR, Planes};
use crate::cycles::depth::Levels;
use crate::cycles::tool::{Take, Tool};
use crate::stages::corner::{self, CornerKind, CornerRequest};
use crate::stages::cutter::{self, Compensator, Offset, Out, PlaneMove, Shape};
use ferrocut_geometry::{Arc, Plane, Position, SAME_POINT_MM, Turn};
use ferrocut_machine::Fault;
use ferrocut_program::Span;
use ferrocut_toolpath::{Feed, FeedAlong, Op, PathMode, Step};

/// A piece of a profile, from where the one before ends.
#[derive(Clone, Copy, PartialEq, Debug)]
pub enum Element {
    /// Straight.
    Line {
        /// End, mm.
        to: [f64; 2],
    },
    /// Circular.
    Arc {
        /// End, mm.
        to: [f64; 2],
        /// Centre.
        center: [f64; 2],
        /// Angle turned, radians, counter-clockwise positive.
        sweep: f64,
    },
}

/// What is wrong with a profile.
#[derive(Clone, Copy, PartialEq, Eq, Debug)]
pub enum ProfileError {
    /// It has no element.
    Empty,
    /// A rounding or chamfer that its elements have no room for, or that has no two elements beside it; where
    /// it stands.
    Corner(Span),
    /// The tangential way in does not fit: its radius is too large for where it begins.
    Entry,
    /// The same of the way out.
    Exit,
    /// The tool path beside it cannot be made.
    Beside(Fault),
}

/// A chain of elements.
#[derive(Clone, PartialEq, Debug, Default)]
pub struct Profile {
    /// Where it begins.
    pub start: [f64; 2],
    /// Its elements in order, corners made.
    pub elements: Vec<Element>,
}

impl Element {
    /// Its end.
    pub fn to(&self) -> [f64; 2] {
        match self {
            Element::Line { to } | Element::Arc { to, .. } => *to,
        }
    }

    /// Direction of travel at the start or the end, from where it begins.
    fn direction(&self, from: [f64; 2], at_end: bool) -> Option<[f64; 2]> {
        let unit = |[x, y]: [f64; 2]| {
            let length = x.hypot(y);
            (length > SAME_POINT_MM).then(|| [x / length, y / length])
        };
        match *self {
            Element::Line { to } => unit([to[0] - from[0], to[1] - from[1]]),
            Element::Arc { to, center, sweep } => {
                let at = if at_end { to } else { from };
                let [x, y] = unit([at[0] - center[0], at[1] - center[1]])?;
                Some(if sweep > 0.0 { [-y, x] } else { [y, -x] })
            }
        }
    }

    fn op(&self) -> Op {
        let (feed, path) = (Feed::PerMinute(1.0), PathMode::default());
        let place = |[x, y]: [f64; 2]| Position::xyz(x, y, 0.0);
        match *self {
            Element::Line { to } => Op::Feed { to: place(to), feed, path },
            Element::Arc { to, center, sweep } => {
                let feed_along = FeedAlong::Path;
                Op::Arc { to: place(to), plane: Plane::Xy, center, sweep, feed, feed_along, path }
            }
        }
    }

    fn of(op: &Op) -> Option<Element> {
        let to = Plane::Xy.of(*op.target()?);
        Some(match *op {
            Op::Arc { center, sweep, .. } => Element::Arc { to, center, sweep },
            _ => Element::Line { to },
        })
    }
}

impl Profile {
    /// A profile of elements, each with what is made of the corner behind it.
    pub fn new(
        start: [f64; 2],
        elements: impl IntoIterator<Item = (Element, Option<(CornerKind, f64, Span)>)>,
    ) -> Result<Profile, ProfileError> {
        let place = |[x, y]: [f64; 2]| Position::xyz(x, y, 0.0);
        let mut stage = corner::Corner::default();
        let (mut at, mut made) = (place(start), Vec::new());
        for (element, corner) in elements {
            let stays = (element.to()[0] - at.0[0]).hypot(element.to()[1] - at.0[1]) <= SAME_POINT_MM;
            if stays && matches!(element, Element::Line { .. }) {
                continue;
            }
            let span = corner.map_or(Span::default(), |(_, _, span)| span);
            let request = corner.filter(|(_, size, _)| *size > 0.0).map(|(kind, size, span)| CornerRequest {
                kind,
                size,
                plane: Plane::Xy,
                span,
            });
            let op = element.op();
            let end = op.target().copied().unwrap_or(at);
            stage
                .push(at, Step::new(op, span, 0), request, |_, step| made.extend(Element::of(&step.op)))
                .map_err(|(_, span)| ProfileError::Corner(span))?;
            at = end;
        }
        if let Some((_, span)) = stage.interrupted() {
            return Err(ProfileError::Corner(span));
        }
        match made.is_empty() {
            true => Err(ProfileError::Empty),
            false => Ok(Profile { start, elements: made }),
        }
    }

    /// Where it ends.
    pub fn end(&self) -> [f64; 2] {
        self.elements.last().map_or(self.start, Element::to)
    }

    /// Every element with where it begins.
    pub fn pieces(&self) -> impl Iterator<Item = ([f64; 2], &Element)> {
        let starts = std::iter::once(self.start).chain(self.elements.iter().map(Element::to));
        starts.zip(&self.elements)
    }

    /// The profile with a way to it from a point: straight, or on an arc of this radius that runs into it
    /// tangentially, and straight to the arc.
    fn entered(&self, from: [f64; 2], radius: f64) -> Result<Profile, ProfileError> {
        let mut elements = Vec::with_capacity(self.elements.len() + 2);
        if radius > 0.0 {
            let first = self.elements.first().ok_or(ProfileError::Empty)?;
            let direction = first.direction(self.start, false).ok_or(ProfileError::Entry)?;
            let (line, arc) = tangent_way(from, self.start, direction, radius).ok_or(ProfileError::Entry)?;
            elements.push(line);
            elements.extend(arc);
        } else {
            elements.push(Element::Line { to: self.start });
        }
        elements.extend(&self.elements);
        Ok(Profile { start: from, elements })
    }

    /// The profile with a way from its end to a point, as [`entered`](Self::entered).
    fn left(mut self, to: Option<[f64; 2]>, radius: f64, left_side: bool) -> Result<Profile, ProfileError> {
        if radius > 0.0 {
            let (at, last) = self.pieces().last().ok_or(ProfileError::Empty)?;
            let (direction, end) = (last.direction(at, true).ok_or(ProfileError::Exit)?, last.to());
            match to {
                Some(to) => {
                    // The way out is a way in, run backwards.
                    let back = [-direction[0], -direction[1]];
                    let (line, arc) = tangent_way(to, end, back, radius).ok_or(ProfileError::Exit)?;
                    let touch = line.to();
                    if let Some(Element::Arc { center, sweep, .. }) = arc {
                        self.elements.push(Element::Arc { to: touch, center, sweep: -sweep });
                    }
                    self.elements.push(Element::Line { to });
                }
                None => {
                    // No point to go to: a quarter circle away from the wall.
                    let side = if left_side { 1.0 } else { -1.0 };
                    let normal = [-direction[1] * side, direction[0] * side];
                    let center = [end[0] + normal[0] * radius, end[1] + normal[1] * radius];
                    let to = [center[0] + direction[0] * radius, center[1] + direction[1] * radius];
                    self.elements.push(Element::Arc {
                        to,
                        center,
                        sweep: side * std::f64::consts::FRAC_PI_2,
                    });
                }
            }
        } else if let Some(to) = to {
            self.elements.push(Element::Line { to });
        }
        Ok(self)
    }
}

/// A straight way from a point and an arc that arrives at `to` in a direction: the line alone where it does so
/// itself. None where the point lies within the arc's circle.
///
/// The circle lies beside the direction, on the side of the point. Seen from its centre the straight way
/// touches it `acos(R/d)` before the point, at the distance d.
fn tangent_way(
    from: [f64; 2],
    to: [f64; 2],
    direction: [f64; 2],
    radius: f64,
) -> Option<(Element, Option<Element>)> {
    let [dx, dy] = direction;
    let (vx, vy) = (from[0] - to[0], from[1] - to[1]);
    let side = if dx * vy - dy * vx >= 0.0 { 1.0 } else { -1.0 };
    let center = [to[0] - dy * side * radius, to[1] + dx * side * radius];
    let (px, py) = (from[0] - center[0], from[1] - center[1]);
    let distance = px.hypot(py);
    if !(distance > radius + SAME_POINT_MM) {
        return None;
    }
    let angle = side * (radius / distance).acos();
    let (sin, cos) = angle.sin_cos();
    let scale = radius / distance;
    let touch = [center[0] + (px * cos - py * sin) * scale, center[1] + (px * sin + py * cos) * scale];
    if (touch[0] - to[0]).hypot(touch[1] - to[1]) <= SAME_POINT_MM {
        return Some((Element::Line { to }, None));
    }
    let turn = if side > 0.0 { Turn::CounterClockwise } else { Turn::Clockwise };
    let place = |[x, y]: [f64; 2]| Position::xyz(x, y, 0.0);
    let sweep = Arc::about(Plane::Xy, place(touch), place(to), center, turn).sweep;
    Some((Element::Line { to: touch }, Some(Element::Arc { to, center, sweep })))
}

/// A profile to follow.
#[derive(Clone, PartialEq, Debug)]
pub struct ProfileMilling {
    /// The path of the tool centre, from where it goes down to where it comes up.
    pub path: Profile,
    /// Levels.
    pub planes: Planes,
    /// Passes in depth.
    pub levels: Levels,
    /// Feed along it, and along the tool axis.
    pub feeds: [f64; 2],
    /// Whether it ends over its start: a finishing pass ends over the end of the profile (4.20).
    pub returns: bool,
}

/// Ways to a profile and from it.
#[derive(Clone, Copy, PartialEq, Debug)]
pub struct Ways {
    /// Where the tool goes down.
    pub from: [f64; 2],
    /// Radius of a tangential way in; 0 for a straight one.
    pub entry: f64,
    /// Where the way out leads, if anywhere.
    pub to: Option<[f64; 2]>,
    /// Radius of a tangential way out; 0 for a straight one.
    pub exit: f64,
}

impl Ways {
    /// The path of the tool centre along a profile; beside it by an offset.
    pub fn path(&self, profile: &Profile, offset: Option<Offset>) -> Result<Profile, ProfileError> {
        let left_side = offset.is_none_or(|offset| offset.side == cutter::Side::Left);
        let path = profile.entered(self.from, self.entry)?.left(self.to, self.exit, left_side)?;
        let Some(offset) = offset else { return Ok(path) };
        let mut compensator = Compensator::new(cutter::Rules::default());
        let mut made = Vec::new();
        let mut out = |out: Out<()>| {
            if let Out::Move { to, shape, .. } = out {
                made.push(match shape {
                    Shape::Line => Element::Line { to },
                    Shape::Arc { center, sweep } => Element::Arc { to, center, sweep },
                });
            }
        };
        compensator.set(Some(offset));
        let refused = |at: cutter::FaultAt<()>| ProfileError::Beside(crate::output::fault_of(at.fault));
        let count = path.elements.len();
        for (number, (from, element)) in path.pieces().enumerate() {
            if number + 1 == count && self.to.is_some() {
                // The straight way out leaves the offset.
                compensator.set(None);
            }
            let (to, shape) = match *element {
                Element::Line { to } => (to, Shape::Line),
                Element::Arc { to, center, sweep } => (to, Shape::Arc { center, sweep }),
            };
            if from != to || matches!(shape, Shape::Arc { .. }) {
                compensator.push(PlaneMove { from, to, shape }, (), &mut out).map_err(refused)?;
            }
        }
        compensator.flush(&mut out).map_err(refused)?;
        Ok(Profile { start: self.from, elements: made })
    }
}

impl ProfileMilling {
    /// Follows the profile from over its start, and ends on the safety level. In a frame without turn or shift.
    pub fn cut<T: Take>(&self, tool: &mut Tool<'_, T>) -> Result<(), T::Error> {
        let [feed, plunge] = self.feeds;
        // Below the level before lies what nothing has cut yet.
        let mut near = self.planes.approach;
        let mut levels = self.levels.depths().peekable();
        while let Some(depth) = levels.next() {
            let level = tool.above(self.planes.surface, -depth);
            if tool.height(tool.z(), near) > 0.0 {
                tool.rapid_z(near)?;
            }
            near = tool.above(level, CLEAR);
            tool.set_feed(plunge);
            tool.feed_z(level)?;
            tool.set_feed(feed);
            for element in &self.path.elements {
                follow(tool, element)?;
            }
            tool.rapid_z(self.planes.safety)?;
            if self.returns || levels.peek().is_some() {
                tool.rapid(self.path.start)?;
            }
        }
        Ok(())
    }
}

fn follow<T: Take>(tool: &mut Tool<'_, T>, element: &Element) -> Result<(), T::Error> {
    match *element {
        Element::Line { to } => tool.feed(to),
        Element::Arc { to, center, sweep } => {
            let [x, y, _] = tool.at();
            match (x - to[0]).hypot(y - to[1]) <= SAME_POINT_MM {
                true => {
                    let z = tool.z();
                    tool.turns(center, sweep / std::f64::consts::TAU, z)
                }
                false => tool.arc(to, center, sweep),
            }
        }
    }
}
