//! `/api/path`: the way of the tool as `FCP1`, a binary form that a browser draws without looking at each point.
//!
//! Little endian: `"FCP1"`, the number n of points (u32), flags (u32: 1 an alarm ended it, 2 a bound did), 0 (u32), the
//! box (six f64: smallest and largest x y z), then x y z of all points (f32), s since the start (f32), the line of the
//! program that leads there (u32; 0 where another program does), and its kind (u8): 0 a start or jump, 1 positioning,
//! 2 a line, 3 an arc. Machine coordinates, mm. Each point is joined to the one before it, except those of kind 0.
//!
//! Times are those of moves at their programmed speeds within the speeds of the axes, without acceleration.

use super::Shared;
use super::body::read;
use super::check::{LONGEST_PROGRAM, NAME};
use super::problem::Problem;
use super::query::{Spoken, desk};
use super::work::{LOOK_STEPS, Wanted, work};
use axum::Router;
use axum::body::Bytes;
use axum::extract::{Query, Request, State};
use axum::http::header::CONTENT_TYPE;
use axum::response::{IntoResponse, Response};
use axum::routing::get;
use ferrocut_controller::control::Desk;
use ferrocut_geometry::{Axis, Position};
use ferrocut_machine::{Alarm, Machine};
use ferrocut_toolpath::{Dwell, Feed, Op, SpindleState, Step};
use serde::Deserialize;
use std::sync::Arc;

/// Points of a path at most: 21 bytes each.
const MOST_POINTS: usize = 2 << 20;

/// How far chords may lie from an arc, mm; a program with more points than are held is drawn again more coarsely.
const TOLERANCE: f64 = 0.01;
const COARSER: [f64; 2] = [0.1, 1.0];

/// Chords of one turn, at least and at most; turns of one helix that are drawn.
const CHORDS: (f64, f64) = (12.0, 512.0);
const MOST_TURNS: f64 = 2000.0;

/// Coordinates are held within this, mm, so that none is infinite as f32.
const FAR: f64 = 1e9;

const ALARM: u32 = 1;
const BOUND: u32 = 2;

pub(super) fn routes() -> Router<Arc<Shared>> {
    Router::new().route("/api/path", get(of_program).post(of_text))
}

#[derive(Deserialize)]
struct Asked {
    program: String,
}

async fn of_program(
    State(shared): State<Arc<Shared>>,
    Query(asked): Query<Asked>,
) -> Result<Response, Problem> {
    let desk = desk(&shared).await?;
    let library = shared.library.clone();
    let found = work(move |wanted| {
        let (_, text) = library.typed(&asked.program)?;
        Some(draw(&desk, text, wanted))
    });
    let missing = || Problem::Missing;
    answer(found.await?.ok_or_else(missing)?)
}

async fn of_text(
    State(shared): State<Arc<Shared>>,
    Query(spoken): Query<Spoken>,
    request: Request,
) -> Result<Response, Problem> {
    let dialect = spoken.dialect(&shared)?;
    let text = read(request, LONGEST_PROGRAM).await?;
    let desk = desk(&shared).await?.speaking(dialect);
    answer(work(move |wanted| draw(&desk, text.to_vec(), wanted)).await?)
}

fn answer(path: Result<Vec<u8>, Box<Alarm>>) -> Result<Response, Problem> {
    let head = [(CONTENT_TYPE, "application/octet-stream")];
    Ok((head, Bytes::from(path?)).into_response())
}

/// The path of a program, as bytes.
fn draw(desk: &Desk, text: Vec<u8>, wanted: &Wanted) -> Result<Vec<u8>, Box<Alarm>> {
    let mut path = drawn(desk, text.clone(), TOLERANCE, wanted)?;
    for coarser in COARSER {
        // Only arcs become fewer points.
        if !path.is_full() || path.chords < MOST_POINTS / 2 || !wanted.is() {
            break;
        }
        path = drawn(desk, text.clone(), coarser, wanted)?;
    }
    Ok(path.bytes())
}

/// Points as they are found.
struct Path {
    flags: u32,
    low: [f64; 3],
    high: [f64; 3],
    places: Vec<f32>,
    times: Vec<f32>,
    lines: Vec<u32>,
    kinds: Vec<u8>,
    /// Points within arcs.
    chords: usize,
}

impl Path {
    fn add(&mut self, at: Position, time: f64, line: u32, kind: u8) {
        for (n, axis) in [Axis::X, Axis::Y, Axis::Z].into_iter().enumerate() {
            let value = if at[axis].is_finite() { at[axis].clamp(-FAR, FAR) } else { 0.0 };
            self.places.push(value as f32);
            if let (Some(low), Some(high)) = (self.low.get_mut(n), self.high.get_mut(n)) {
                (*low, *high) = (low.min(value), high.max(value));
            }
        }
        self.times.push(if time.is_finite() { time as f32 } else { f32::MAX });
        self.lines.push(line);
        self.kinds.push(kind);
    }

    fn is_full(&self) -> bool {
        self.kinds.len() >= MOST_POINTS
    }

    fn bytes(&self) -> Vec<u8> {
        let count = self.kinds.len();
        let mut bytes = Vec::with_capacity(64 + 21 * count);
        bytes.extend_from_slice(b"FCP1");
        let head = [u32::try_from(count).unwrap_or(u32::MAX), self.flags, 0];
        head.into_iter().for_each(|value| bytes.extend_from_slice(&value.to_le_bytes()));
        self.low.iter().chain(&self.high).for_each(|value| bytes.extend_from_slice(&value.to_le_bytes()));
        self.places.iter().chain(&self.times).for_each(|value| bytes.extend_from_slice(&value.to_le_bytes()));
        self.lines.iter().for_each(|value| bytes.extend_from_slice(&value.to_le_bytes()));
        bytes.extend_from_slice(&self.kinds);
        bytes
    }
}

fn drawn(desk: &Desk, text: Vec<u8>, tolerance: f64, wanted: &Wanted) -> Result<Path, Box<Alarm>> {
    let mut interpreter = desk.interpreter(NAME, text, false)?;
    let mut pen = Pen::new(desk.start(), desk.machine(), tolerance);
    let mut steps = 0u64;
    loop {
        let step = match interpreter.next() {
            None => break,
            Some(Err(_)) => {
                pen.path.flags |= ALARM;
                break;
            }
            Some(Ok(step)) => step,
        };
        steps += 1;
        if pen.path.is_full() || steps.is_multiple_of(LOOK_STEPS) && !wanted.is() {
            pen.path.flags |= BOUND;
            break;
        }
        let line = if step.span.file == interpreter.main_file() { step.span.line } else { 0 };
        pen.step(&step.op, line);
    }
    Ok(pen.path)
}

/// The path of steps that begin at a place, as bytes.
pub(super) fn of_steps<'a>(
    steps: impl Iterator<Item = &'a Step>,
    start: Position,
    machine: &Machine,
    is_cut_short: bool,
) -> Vec<u8> {
    let mut pen = Pen::new(start, machine, TOLERANCE);
    if is_cut_short {
        pen.path.flags |= BOUND;
    }
    for step in steps {
        if pen.path.is_full() {
            pen.path.flags |= BOUND;
            break;
        }
        pen.step(&step.op, step.span.line);
    }
    pen.path.bytes()
}

/// Draws steps.
struct Pen<'a> {
    path: Path,
    at: Position,
    time: f64,
    spindle: SpindleState,
    machine: &'a Machine,
    tolerance: f64,
}

impl<'a> Pen<'a> {
    fn new(at: Position, machine: &'a Machine, tolerance: f64) -> Pen<'a> {
        let mut path = Path {
            flags: 0,
            low: [f64::INFINITY; 3],
            high: [f64::NEG_INFINITY; 3],
            places: Vec::new(),
            times: Vec::new(),
            lines: Vec::new(),
            kinds: Vec::new(),
            chords: 0,
        };
        path.add(at, 0.0, 0, 0);
        Pen { path, at, time: 0.0, spindle: SpindleState::Off, machine, tolerance }
    }

    fn step(&mut self, op: &Op, line: u32) {
        match op {
            Op::Datum { at } => {
                self.at = *at;
                self.path.add(self.at, self.time, line, 0);
            }
            Op::Dwell(Dwell::Seconds(seconds)) => self.time += seconds.max(0.0),
            Op::Spindle(state) => self.spindle = *state,
            _ => {}
        }
        let Some(to) = op.target() else { return };
        let takes = duration(op, self.at, self.machine, self.spindle);
        match op.arc(self.at) {
            Some(arc) => {
                let chords = chords(arc.start_radius().max(arc.end_radius()), arc.sweep, self.tolerance);
                for n in 1..=chords {
                    if self.path.is_full() {
                        break;
                    }
                    let share = f64::from(n) / f64::from(chords);
                    self.path.add(arc.at(share), self.time + takes * share, line, 3);
                    self.path.chords += 1;
                }
            }
            None => {
                let kind = if matches!(op, Op::Rapid { .. }) { 1 } else { 2 };
                self.path.add(*to, self.time + takes, line, kind);
            }
        }
        self.time += takes;
        self.at = *to;
    }
}

/// How many chords an arc is drawn as.
fn chords(radius: f64, sweep: f64, tolerance: f64) -> u32 {
    let turns = (sweep.abs() / std::f64::consts::TAU).min(MOST_TURNS);
    // A chord over an angle a is r (1 - cos(a/2)) from its arc.
    let angle = 2.0 * (1.0 - tolerance / radius.max(tolerance)).clamp(-1.0, 1.0).acos();
    let in_a_turn = (std::f64::consts::TAU / angle.max(1e-9)).clamp(CHORDS.0, CHORDS.1);
    (turns * in_a_turn).ceil().clamp(1.0, MOST_TURNS * CHORDS.1) as u32
}

/// How long a move takes at its speed, s.
fn duration(op: &Op, from: Position, machine: &Machine, spindle: SpindleState) -> f64 {
    let Some(to) = op.target() else { return 0.0 };
    let slowest = |speed: &dyn Fn(&ferrocut_machine::AxisConfig) -> f64| {
        let times =
            machine.axes.iter().map(|axis| (to[axis.name] - from[axis.name]).abs() / speed(axis).max(1e-3));
        times.fold(0.0, f64::max) * 60.0
    };
    let length = op.length(from);
    let at = |speed: f64| if speed > 0.0 { length / speed * 60.0 } else { 0.0 };
    match op {
        Op::Rapid { speed, .. } => slowest(&|axis| axis.rapid).max(speed.map_or(0.0, at)),
        Op::Feed { feed, .. } | Op::Arc { feed, .. } | Op::Skip { feed, .. } => {
            let programmed = match feed {
                Feed::PerMinute(speed) | Feed::Held { at: speed, .. } => at(*speed),
                Feed::PerRevolution(pitch) => {
                    at(pitch * spindle.speed().map_or(0.0, |speed| speed.rpm(&from)))
                }
                Feed::Duration(seconds) => *seconds,
            };
            programmed.max(slowest(&|axis| axis.velocity))
        }
        Op::Tap { pitch, rpm, .. } => at((pitch * rpm).abs()).max(slowest(&|axis| axis.velocity)),
        _ => 0.0,
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn chords_keep_to_the_tolerance() {
        for radius in [0.5, 5.0, 50.0] {
            let count = f64::from(chords(radius, std::f64::consts::TAU, 0.01));
            let off = radius * (1.0 - (std::f64::consts::PI / count).cos());
            assert!(off <= 0.0101 && count >= 12.0, "{radius}: {count} chords, {off}");
        }
        assert_eq!(chords(0.0, 0.0, 0.01), 1);
        assert!(chords(f64::NAN, f64::INFINITY, 0.01) <= 2000 * 512);
    }
}
