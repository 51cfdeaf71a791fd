//! Threads milled on a helix (Fagor 1.11, 1.12, 4.7).
//!
//! ```text
//! radius of the path at the depth d of a pass   inside  J/2 − K + d − r   outside  J/2 − d + r
//! level over the angle φ from the start         z = z₀ ∓ |B|·φ/2π
//! ```
//!
//! `C = 0` is a tool with the whole thread in its edge: one turn. `C = 1` has one edge: one helix over the
//! whole depth. `C = n` cuts n threads at once: single turns, each n pitches from the next, the last one
//! ending at the bottom.
//!
//! Into a turn and out of it the tool goes on half a turn of half the pitch, tangent to it, so that depth
//! and pitch are those of the thread from its first point to its last.

use super::bore_milling::MAX_TURNS;
use super::milling::steps;
use super::parameter::{WrongParameter, positive, refuse};
use super::tool::{Frame, Take, Tool, up};
use ferrocut_geometry::SAME_POINT_MM;
use ferrocut_machine::Fault;
use std::f64::consts::{PI, TAU};

/// Most passes from the crest to the root.
const MAX_PASSES: f64 = 1000.0;

/// Clearance above the crest of an external thread where no approach distance is given, mm.
const CLEARANCE: f64 = 1.0;

/// A thread to mill. Lengths in mm, angles in degrees; levels are coordinates of the tool axis.
#[derive(Clone, Copy, PartialEq, Debug)]
pub struct ThreadMilling {
    /// Where the first rapid ends.
    pub reference: f64,
    /// Surface of the part.
    pub surface: f64,
    /// Where the thread ends.
    pub bottom: f64,
    /// Where the tool returns to.
    pub top: f64,
    /// A thread about the tool path; else the tool runs round it.
    pub internal: bool,
    /// Nominal diameter.
    pub diameter: f64,
    /// From crest to root.
    pub depth: f64,
    /// Pitch, without sign.
    pub pitch: f64,
    /// Machined from the surface to the bottom.
    pub downwards: bool,
    /// Edges of the tool: 0 for the whole thread in one, 1, or how many.
    pub edges: u32,
    /// Left for a last pass at the root.
    pub stock: f64,
    /// Largest radial step; 0 for one pass.
    pub step: f64,
    /// From the thread to where the tool comes down; none for the middle of an internal thread.
    pub approach: Option<f64>,
    /// Angle of the entry point.
    pub angle: f64,
    /// Radius of the tool.
    pub tool_radius: f64,
    /// Feed.
    pub feed: f64,
}

/// What a control calls the parameters.
#[derive(Clone, Copy, PartialEq, Eq, Debug)]
pub struct ThreadNames {
    /// Diameter.
    pub diameter: &'static str,
    /// Depth of the thread.
    pub depth: &'static str,
    /// Pitch.
    pub pitch: &'static str,
    /// Stock.
    pub stock: &'static str,
    /// Radial step.
    pub step: &'static str,
    /// Approach distance.
    pub approach: &'static str,
    /// Length of the thread.
    pub length: &'static str,
}

impl ThreadMilling {
    /// Which way "up" is: away from the bottom.
    pub fn up(&self) -> f64 {
        up(self.bottom, self.reference)
    }

    /// Whether the tool can mill the thread.
    pub fn check(&self, names: ThreadNames) -> Result<(), WrongParameter> {
        let diameter = positive(self.diameter, names.diameter)?;
        let depth = positive(self.depth, names.depth)?;
        positive(self.pitch, names.pitch)?;
        refuse(!(self.tool_radius > 0.0), Fault::MillToolMissing, "T")?;
        refuse(depth * 2.0 >= diameter, Fault::CycleParameter, names.depth)?;
        if self.internal {
            // The tool must come down within the crests.
            let hole = diameter / 2.0 - depth;
            if !(self.tool_radius < hole) {
                return Err(WrongParameter::beyond(Fault::CycleToolTooLarge, "T", self.tool_radius, hole));
            }
        }
        refuse(!(self.stock >= 0.0 && self.stock < depth), Fault::CycleParameter, names.stock)?;
        refuse(!(self.step >= 0.0 && self.step.is_finite()), Fault::CycleParameter, names.step)?;
        let approach = self.approach.unwrap_or(0.0);
        refuse(!(approach >= 0.0 && approach.is_finite()), Fault::CycleParameter, names.approach)?;
        let length = (self.surface - self.bottom).abs();
        refuse(!(length > 0.0 && length.is_finite()), Fault::CycleNoDepth, names.length)?;
        refuse(!(length / self.pitch <= MAX_TURNS), Fault::CycleParameter, names.pitch)?;
        let passes = if self.step > 0.0 { steps(depth - self.stock, self.step) } else { 1.0 };
        refuse(!(passes <= MAX_PASSES), Fault::CycleParameter, names.step)
    }

    /// Depths of the passes, from the crest: A, 2A … to K − L, then K.
    pub fn passes(&self) -> impl Iterator<Item = f64> {
        let rough = self.depth - self.stock;
        let step = if self.step > 0.0 { self.step } else { rough };
        let count = steps(rough, step).min(MAX_PASSES) as u32;
        let last = (self.stock > 0.0).then_some(self.depth);
        (1..=count).map(move |n| if n == count { rough } else { f64::from(n) * step }).chain(last)
    }

    /// Radius of the path at a depth from the crest.
    pub fn path_radius(&self, depth: f64) -> f64 {
        match self.internal {
            true => self.diameter / 2.0 - self.depth + depth - self.tool_radius,
            false => self.diameter / 2.0 - depth + self.tool_radius,
        }
    }

    /// Levels on which the turns of a pass begin and end, in order.
    pub fn turns(&self) -> impl Iterator<Item = [f64; 2]> {
        let up = self.up();
        let (bottom, pitch) = (self.bottom, self.pitch);
        let length = (self.surface - bottom) * up;
        let (count, distance, height) = match self.edges {
            0 => (1, 0.0, pitch),
            1 => (1, 0.0, length),
            edges => {
                let distance = f64::from(edges) * pitch;
                (steps(length, distance).min(MAX_TURNS) as u32, distance, pitch)
            }
        };
        let downwards = self.downwards;
        (0..count).map(move |turn| {
            // The last turn downwards ends at the bottom, the first upwards begins there.
            let above = if downwards { count - 1 - turn } else { turn };
            let low = bottom + up * f64::from(above) * distance;
            if downwards { [low + up * height, low] } else { [low, low + up * height] }
        })
    }

    /// Mills the thread about the origin of the frame, over which the tool stands. The frame turns the way
    /// that the thread is machined.
    pub fn mill<T: Take>(&self, frame: Frame, tool: &mut Tool<'_, T>) -> Result<(), T::Error> {
        tool.set_feed(self.feed);
        tool.rapid_z(self.reference)?;
        let mut passes = self.passes().peekable();
        while let Some(depth) = passes.next() {
            let radius = self.path_radius(depth);
            let clear = self.clear_radius(radius, depth);
            for levels in self.turns() {
                self.turn(frame, tool, [radius, clear], levels)?;
            }
            if !self.internal {
                tool.rapid_z(self.reference)?;
                continue;
            }
            // To the middle, and there to where the next pass begins (1.11, steps 7 and 8). Behind the last one there is none, and
            // the way up is the next step.
            tool.rapid([0.0; 2])?;
            if let Some(levels) = self.turns().next().filter(|_| passes.peek().is_some()) {
                tool.rapid_z(self.entry(levels))?;
            }
        }
        tool.rapid_z(self.top)?;
        tool.set_frame(frame);
        tool.rapid([0.0; 2])
    }

    /// Radius on which the tool comes down: off the thread by the approach distance, and clear of the crests
    /// in any case, so that no rapid meets the part.
    fn clear_radius(&self, radius: f64, depth: f64) -> f64 {
        match (self.internal, self.approach) {
            (true, Some(approach)) => (radius - approach.max(depth)).max(0.0),
            (true, None) => 0.0,
            (false, approach) => radius + approach.unwrap_or(depth + CLEARANCE).max(depth),
        }
    }

    /// By how much the tool sinks or rises in half a turn: half a pitch.
    fn half(&self, [from, to]: [f64; 2]) -> f64 {
        if to > from { self.pitch / 2.0 } else { -self.pitch / 2.0 }
    }

    /// The level at which the way into a turn begins.
    fn entry(&self, levels: [f64; 2]) -> f64 {
        levels[0] - self.half(levels)
    }

    /// One helix from the level `from` to `to`, with the ways in and out.
    fn turn<T: Take>(
        &self,
        frame: Frame,
        tool: &mut Tool<'_, T>,
        [radius, clear]: [f64; 2],
        [from, to]: [f64; 2],
    ) -> Result<(), T::Error> {
        let half = self.half([from, to]);
        let side = if self.internal { 1.0 } else { -1.0 };
        let middle = (radius + clear) / 2.0;
        tool.set_frame(frame);
        tool.rapid([clear, 0.0])?;
        tool.rapid_z(self.entry([from, to]))?;
        tool.half_circle([radius, 0.0], [middle, 0.0], side, from)?;
        let turns = (to - from).abs() / self.pitch;
        if (turns - turns.round()).abs() <= SAME_POINT_MM {
            tool.turns([0.0; 2], turns.round(), to)?;
            return tool.half_circle([clear, 0.0], [middle, 0.0], side, to + half);
        }
        let (sin, cos) = (turns * TAU).sin_cos();
        let at = |r: f64| [r * cos, r * sin];
        tool.helix(at(radius), [0.0; 2], turns * TAU, to)?;
        tool.helix(at(clear), at(middle), PI * side, to + half)
    }
}

#[cfg(test)]
mod tests {
    #![allow(clippy::unwrap_used, clippy::panic)]
    use super::*;
    use crate::cycles::tool::Act;
    use ferrocut_geometry::Turn;
    use proptest::prelude::*;

    fn acts(thread: &ThreadMilling, turn: Turn) -> Vec<Act> {
        let mut out = Vec::new();
        let mut taker = |act: Act| {
            out.push(act);
            Ok::<(), ()>(())
        };
        let frame = Frame::new([0.0; 2], thread.angle, turn);
        let mut tool = Tool::new(frame, [0.0, 0.0, 50.0], thread.up(), &mut taker);
        thread.mill(frame, &mut tool).unwrap();
        out
    }

    fn any_thread() -> impl Strategy<Value = ThreadMilling> {
        let sizes = (8.0..60.0f64, 0.3..1.5f64, 0.5..3.0f64, 4.0..30.0f64);
        let ways = (any::<bool>(), any::<bool>(), 0u32..6, any::<bool>());
        let steps = (0.0..0.29f64, 0.0..1.0f64, prop::option::of(0.0..4.0f64), -180.0..360.0f64, 1.0..3.0f64);
        (sizes, ways, steps).prop_map(
            |((d, k, pitch, length), (internal, down, edges, plus), (l, a, e, q, r))| {
                let up = if plus { -1.0 } else { 1.0 };
                ThreadMilling {
                    reference: 2.0 * up,
                    surface: 0.0,
                    bottom: -length * up,
                    top: 20.0 * up,
                    internal,
                    diameter: d,
                    depth: k,
                    pitch,
                    downwards: down,
                    edges,
                    stock: l,
                    step: if a < 0.1 { 0.0 } else { a },
                    approach: e,
                    angle: q,
                    tool_radius: r.min(d / 2.0 - k - 0.2),
                    feed: 100.0,
                }
            },
        )
    }

    proptest! {
        #![proptest_config(ProptestConfig { cases: 400, failure_persistence: None, ..ProptestConfig::default() })]

        /// Every helix about the middle has the thread's pitch, starts at its angle and lies on the radius of
        /// its pass; ways in and out touch it tangentially and have the same pitch.
        #[test]
        fn helices_are_those_of_the_formulas(thread in any_thread(), clockwise in any::<bool>()) {
            let names = ThreadNames { diameter: "J", depth: "K", pitch: "B", stock: "L", step: "A", approach: "E", length: "I" };
            prop_assume!(thread.tool_radius > 0.1 && thread.check(names).is_ok());
            let turn = if clockwise { Turn::Clockwise } else { Turn::CounterClockwise };
            let sign = if clockwise { -1.0 } else { 1.0 };
            let mut at = [0.0, 0.0, 50.0];
            let mut heading: Option<[f64; 2]> = None;
            let mut helices = Vec::new();
            for act in acts(&thread, turn) {
                match act {
                    Act::Arc { to, center, sweep, .. } => {
                        let tangent = |p: [f64; 3]| {
                            let (x, y) = (p[0] - center[0], p[1] - center[1]);
                            let r = x.hypot(y);
                            [-y / r * sweep.signum(), x / r * sweep.signum()]
                        };
                        if let Some(before) = heading {
                            let start = tangent(at);
                            let same = (before[0] - start[0]).hypot(before[1] - start[1]);
                            prop_assert!(same < 1e-6, "a corner of {same}");
                        }
                        heading = Some(tangent(to));
                        let climb = (to[2] - at[2]).abs();
                        let pitch = climb / (sweep.abs() / TAU);
                        prop_assert!((pitch - thread.pitch).abs() < 1e-6, "pitch {pitch}");
                        if center[0].hypot(center[1]) < 1e-9 {
                            prop_assert!(sweep.signum() == sign);
                            let angle = (at[1].atan2(at[0]).to_degrees() - thread.angle).rem_euclid(360.0);
                            prop_assert!(!(1e-6..=360.0 - 1e-6).contains(&angle), "starts at {angle}");
                            helices.push((at[0].hypot(at[1]), at[2], to[2], sweep.abs() / TAU));
                        }
                        at = to;
                    }
                    Act::Rapid { to } => {
                        heading = None;
                        // Down only clear of the thread.
                        let far = to[0].hypot(to[1]);
                        if (to[2] - at[2]).abs() > 1e-9 {
                            let clear = match thread.internal {
                                true => far + thread.tool_radius <= thread.diameter / 2.0 - thread.depth + 1e-6,
                                false => far < 1e-9 || far - thread.tool_radius >= thread.diameter / 2.0 - 1e-6,
                            };
                            prop_assert!(clear, "rapid at radius {far}");
                        }
                        at = to;
                    }
                    _ => {}
                }
            }
            let passes: Vec<f64> = thread.passes().collect();
            let turns: Vec<_> = thread.turns().collect();
            prop_assert_eq!(helices.len(), passes.len() * turns.len());
            for ((radius, from, to, count), (pass, turn)) in
                helices.iter().zip(passes.iter().flat_map(|p| turns.iter().map(move |t| (p, t)))) {
                prop_assert!((radius - thread.path_radius(*pass)).abs() < 1e-6);
                prop_assert!((from - turn[0]).abs() < 1e-9 && (to - turn[1]).abs() < 1e-9);
                match thread.edges {
                    1 => prop_assert!((count * thread.pitch - thread.bottom.abs()).abs() < 1e-6),
                    _ => prop_assert!((count - 1.0).abs() < 1e-9),
                }
            }
            // The deepest point of the thread is its bottom, the deepest pass its root.
            let deepest = turns.iter().flatten().map(|z| z * thread.up()).fold(f64::INFINITY, f64::min);
            prop_assert!((deepest - thread.bottom * thread.up()).abs() < 1e-9);
            prop_assert!((passes.last().unwrap() - thread.depth).abs() < 1e-9);
            // No gap between the turns of a tool with several edges.
            for pair in turns.windows(2) {
                let apart = (pair[0][0] - pair[1][0]).abs();
                prop_assert!((apart - f64::from(thread.edges) * thread.pitch).abs() < 1e-6);
            }
        }
    }
}
