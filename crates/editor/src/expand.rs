//! Steps of a cycle as blocks of rapid, straight cut and arc, which every control has.
//!
//! Coordinates are absolute, mm, and stand with all their decimals in a point notation that no control takes for
//! increments. The first block goes to the safety plane, which by its meaning is free everywhere (4.1.2), so that
//! the text may stand behind any block.

use crate::run::{feed_a_minute, xyz};
use crate::style::Style;
use ferrocut_geometry::{Plane, Turn};
use ferrocut_interpreter::Rules;
use ferrocut_toolpath::{Dwell, Feed, Op, Speed, SpindleState, Step};
use std::f64::consts::TAU;
use std::fmt::Write;

/// Why steps cannot be written.
#[derive(Clone, Copy, PartialEq, Eq, Debug)]
pub enum Unwritten {
    /// A motion in step with the spindle, which blocks of their own cannot make.
    Synchronised,
    /// Another kind of step.
    Other,
}

/// Blocks being written.
pub struct Writer<'a> {
    style: &'a Style,
    /// The feed of a helix counts along its circle.
    feed_along_circle: bool,
    /// The text so far.
    pub text: String,
    at: [Option<f64>; 3],
    motion: Option<&'static str>,
    feed: Option<String>,
    spindle: Option<SpindleState>,
    /// A tool whose length is still to be put in force.
    length: Option<u32>,
    /// Level of the tool before the first move.
    level: f64,
    /// Where the tool stood beside the part when the steps were made, which is nowhere in particular.
    beside: [f64; 2],
}

impl<'a> Writer<'a> {
    /// A writer whose tool goes to a level first.
    pub fn new(style: &'a Style, rules: &Rules, level: f64) -> Writer<'a> {
        Writer {
            style,
            feed_along_circle: rules.helix_feed_along_circle,
            text: String::new(),
            at: [None; 3],
            motion: None,
            feed: None,
            spindle: None,
            length: None,
            level,
            beside: crate::run::BESIDE,
        }
    }

    /// Writes steps.
    pub fn steps(&mut self, steps: &[Step]) -> Result<(), Unwritten> {
        let taps = steps.iter().any(|step| matches!(step.op, Op::Tap { .. }));
        let mut steps = steps.iter();
        while let Some(step) = steps.next() {
            match (&step.op, self.style.there_and_back) {
                (Op::Tap { to, pitch, rpm, .. }, Some(code)) => {
                    let back = steps.next().map(|step| &step.op);
                    self.there_and_back(code, xyz(to), [*pitch, *rpm], back)?;
                }
                // Such a block starts from a turning spindle.
                (Op::Orient(_), Some(_)) if taps => {}
                (op, _) => self.step(op)?,
            }
        }
        Ok(())
    }

    /// A tap and its withdrawal as one block.
    fn there_and_back(
        &mut self,
        code: &'static str,
        to: [f64; 3],
        [pitch, rpm]: [f64; 2],
        back: Option<&Op>,
    ) -> Result<(), Unwritten> {
        let Some(Op::Tap { to: end, pitch: out, rpm: faster, .. }) = back else {
            return Err(Unwritten::Synchronised);
        };
        // K has no sign (LinuxCNC, G33.1): a left-hand thread is not in it.
        if pitch < 0.0 || self.at != xyz(end).map(|c| Some(self.rounded(c))) || *out != pitch {
            return Err(Unwritten::Synchronised);
        }
        self.spindle(SpindleState::turning(Turn::Clockwise, Speed::Rpm(rpm)))?;
        let mut words = format!(" Z{} K{}", self.decimal(to[2]), self.decimal(pitch));
        if *faster != rpm {
            let _ = write!(words, " I{}", self.decimal(faster / rpm));
        }
        self.line(&format!("{code}{words}"));
        self.motion = None;
        Ok(())
    }

    fn step(&mut self, op: &Op) -> Result<(), Unwritten> {
        match op {
            Op::Rapid { to, .. } => self.straight("G0", xyz(to), None),
            Op::Feed { to, feed, .. } => self.straight("G1", xyz(to), Some(self.per_minute(*feed)?)),
            Op::Arc { to, plane: Plane::Xy, center, sweep, feed, .. } => {
                let feed = self.per_minute(*feed)?;
                self.arc(xyz(to), *center, *sweep, feed)?;
            }
            Op::Dwell(Dwell::Seconds(seconds)) => {
                let block = format!("G4 {}{}", self.style.dwell, self.decimal(*seconds));
                self.line(&block);
            }
            Op::Spindle(state) => self.spindle(*state)?,
            Op::Orient(angle) => {
                let block =
                    if *angle == 0.0 { "M19".to_owned() } else { format!("M19 R{}", self.decimal(*angle)) };
                self.line(&block);
                self.spindle = None;
            }
            Op::Change(tool) => self.change(*tool),
            // Chosen ahead of its change, which the block of the change does again.
            Op::Select(_) | Op::Barrier => {}
            Op::Coolant(on) => self.line(if *on { "M8" } else { "M9" }),
            Op::Machine(code) => self.line(&format!("M{code}")),
            Op::Message(_) => {}
            Op::Tap { .. } => return Err(Unwritten::Synchronised),
            _ => return Err(Unwritten::Other),
        }
        Ok(())
    }

    /// A line of its own.
    pub fn line(&mut self, block: &str) {
        self.text.push_str(block);
        self.text.push('\n');
    }

    /// A comment, without what would end it.
    pub fn comment(&mut self, text: &str) {
        let [before, behind] = self.style.comment;
        let clean: String =
            text.chars().map(|c| if c.is_control() || "()".contains(c) { ' ' } else { c }).collect();
        self.line(&format!("{before}{}{behind}", clean.trim()));
    }

    /// The tool goes to the level that its way begins on, with a new tool's length.
    pub fn to_level(&mut self) {
        let z = self.at[2].unwrap_or(self.level);
        let length = self.length.take();
        if length.is_none() && self.at[2].is_some() {
            return;
        }
        let length = length.map_or(String::new(), |tool| format!(" G43 H{tool}"));
        let block = format!("G0{length} Z{}", self.decimal(z));
        self.line(&block);
        self.motion = Some("G0");
        self.at[2] = Some(z);
    }

    fn change(&mut self, tool: u32) {
        self.line(&format!("T{tool} M6"));
        self.length = Some(tool);
        self.spindle = None;
        self.motion = None;
    }

    fn spindle(&mut self, state: SpindleState) -> Result<(), Unwritten> {
        if self.spindle == Some(state) {
            return Ok(());
        }
        self.spindle = Some(state);
        let block = match (state, state.turn()) {
            (SpindleState::Off, _) | (_, None) => "M5".to_owned(),
            (_, Some(turn)) => {
                let code = if turn == Turn::Clockwise { "M3" } else { "M4" };
                match state.speed() {
                    Some(Speed::Rpm(rpm)) if rpm > 0.0 => format!("S{} {code}", crate::block::short(rpm)),
                    Some(Speed::Rpm(_)) => code.to_owned(),
                    _ => return Err(Unwritten::Other),
                }
            }
        };
        self.line(&block);
        Ok(())
    }

    fn per_minute(&self, feed: Feed) -> Result<f64, Unwritten> {
        feed_a_minute(feed, self.spindle).ok_or(Unwritten::Other)
    }

    /// A number with a decimal point, whatever the control takes numbers without one for.
    pub fn decimal(&self, value: f64) -> String {
        let text = format!("{value:.*}", self.style.decimals);
        let text = text.trim_end_matches('0');
        let text = if text.ends_with('.') { format!("{text}0") } else { text.to_owned() };
        if text == "-0.0" { "0.0".to_owned() } else { text }
    }

    fn rounded(&self, value: f64) -> f64 {
        let unit = 10f64.powi(self.style.decimals as i32);
        (value * unit).round() / unit
    }

    fn straight(&mut self, code: &'static str, to: [f64; 3], feed: Option<f64>) {
        self.to_level();
        let mut words = String::new();
        // Only up or down from wherever the tool is.
        let stays = self.at[0].is_none() && [to[0], to[1]] == self.beside;
        for ((letter, to), axis) in ["X", "Y", "Z"].into_iter().zip(to).zip(0..) {
            if stays && axis < 2 {
                continue;
            }
            let to = self.rounded(to);
            let Some(at) = self.at.get_mut(axis) else { continue };
            if *at != Some(to) {
                *at = Some(to);
                let _ = write!(words, " {letter}{}", self.decimal(to));
            }
        }
        if !words.is_empty() {
            self.block(code, &words, feed);
        }
    }

    fn block(&mut self, code: &'static str, words: &str, feed: Option<f64>) {
        let head = if self.motion == Some(code) { "" } else { code };
        self.motion = Some(code);
        let mut line = format!("{head}{words}");
        if let Some(feed) = feed.map(crate::block::short).filter(|feed| self.feed.as_ref() != Some(feed)) {
            let _ = write!(line, " F{feed}");
            self.feed = Some(feed);
        }
        self.line(line.trim_start());
    }

    /// An arc, turn by turn.
    fn arc(&mut self, to: [f64; 3], center: [f64; 2], sweep: f64, feed: f64) -> Result<(), Unwritten> {
        self.to_level();
        let [Some(x), Some(y), Some(z)] = self.at else { return Err(Unwritten::Other) };
        let (mut x, mut y) = (x, y);
        let radius = (x - center[0]).hypot(y - center[1]);
        let circle = radius * sweep.abs();
        let climb = to[2] - z;
        let feed = match self.feed_along_circle && climb != 0.0 && circle > 0.0 {
            true => feed * circle / circle.hypot(climb),
            false => feed,
        };
        // A hair above whole turns is none more.
        let turns = (sweep.abs() / TAU - 1e-9).ceil().max(1.0);
        let turned = (sweep.abs() - (turns - 1.0) * TAU) / sweep.abs();
        let code = if sweep > 0.0 { "G3" } else { "G2" };
        let mut done = turned;
        for turn in 0..turns as u64 {
            let is_last = turn as f64 == turns - 1.0;
            // What is no whole turn comes first; the whole ones behind it end where they begin.
            let level = if is_last { to[2] } else { z + climb * done };
            let end = [self.rounded(to[0]), self.rounded(to[1]), self.rounded(level)];
            let mut words = format!(" X{} Y{}", self.decimal(end[0]), self.decimal(end[1]));
            if self.at[2] != Some(end[2]) {
                let _ = write!(words, " Z{}", self.decimal(end[2]));
            }
            let (i, j) = (self.rounded(center[0] - x), self.rounded(center[1] - y));
            let _ = write!(words, " I{} J{}", self.decimal(i), self.decimal(j));
            self.at = end.map(Some);
            self.block(code, &words, Some(feed));
            [x, y] = [end[0], end[1]];
            done += (1.0 - turned) / (turns - 1.0).max(1.0);
        }
        Ok(())
    }
}
