//! A control's own canned cycle in the place of one of the editor, where it makes the same motion.
//!
//! Which one does is not looked up but found out: each that may be is written, run in its language, and held
//! against the motion of the editor's cycle. So a control that is set to another peck clearance, or restarts its
//! spindle otherwise, is given blocks instead of a cycle that does something else.

use crate::expand::Writer;
use crate::request::{Request, Value};
use crate::run::{feed_a_minute, xyz};
use crate::style::{HoleWords, Style};
use ferrocut_interpreter::Rules;
use ferrocut_toolpath::{Op, Step};

/// Holes of a cycle: where they are, and their levels.
#[derive(Clone, PartialEq, Debug)]
pub struct Holes {
    /// Their places.
    pub at: Vec<[f64; 2]>,
    /// Where feed begins.
    pub reference: f64,
    /// The deepest point.
    pub bottom: f64,
    /// Where the tool travels.
    pub safety: f64,
    /// mm/min.
    pub feed: f64,
    /// mm a turn, where it is tapped in step.
    pub pitch: Option<f64>,
}

impl Holes {
    /// The holes that steps make; none where the steps are no holes.
    pub fn of(steps: &[Step], safety: f64) -> Option<Holes> {
        let mut holes =
            Holes { at: Vec::new(), reference: 0.0, bottom: safety, safety, feed: 0.0, pitch: None };
        let (mut level, mut spindle) = (None, None);
        for step in steps {
            if let Op::Spindle(state) = &step.op {
                spindle = Some(*state);
            }
            let Some(target) = step.op.target() else { continue };
            let [x, y, z] = xyz(target);
            match &step.op {
                Op::Rapid { .. } => level = Some(z),
                Op::Feed { .. } | Op::Tap { .. } => {
                    if holes.at.last() != Some(&[x, y]) {
                        holes.at.push([x, y]);
                        holes.reference = level?;
                    }
                    match &step.op {
                        Op::Feed { feed, .. } => holes.feed = feed_a_minute(*feed, spindle)?,
                        Op::Tap { pitch, .. } => holes.pitch = Some(pitch.abs()),
                        _ => return None,
                    }
                    let deeper = (safety - z).abs() > (safety - holes.bottom).abs();
                    holes.bottom = if deeper { z } else { holes.bottom };
                }
                _ => return None,
            }
        }
        (!holes.at.is_empty()).then_some(holes)
    }
}

/// The text of a candidate; none where it needs a value that there is none of.
pub fn text(
    request: &Request,
    steps: &[Step],
    holes: &Holes,
    style: &Style,
    rules: &Rules,
    words: &HoleWords,
) -> Option<String> {
    let mut writer = Writer::new(style, rules, holes.safety);
    // Tool and spindle as the blocks before the first move say.
    let head = steps.iter().position(|step| step.op.target().is_some()).unwrap_or(0);
    let spindle = steps.get(..head)?;
    let (before, _): (Vec<Step>, Vec<Step>) =
        spindle.iter().cloned().partition(|step| !matches!(step.op, Op::Orient(_)));
    writer.steps(&before).ok()?;
    writer.to_level();
    let number = |name: &str| match request.values.get(name) {
        Some(Value::Number(value)) => *value,
        _ => 0.0,
    };
    let word = |name: &str| match request.values.get(name) {
        Some(Value::Text(word)) => word.as_str(),
        _ => "",
    };
    let unit = rules.cycles.dwell_p_unit_s;
    let dwell = if unit == 1.0 {
        writer.decimal(number("t"))
    } else {
        crate::block::short((number("t") / unit).round())
    };
    let aside = number("dx").hypot(number("dy"));
    let put = |text: &str| {
        let text = text
            .replace("{tap}", if word("spindle") == "ccw" { "G74" } else { "G84" })
            .replace("{turn}", if word("spindle") == "ccw" { "M4" } else { "M3" })
            .replace("{t}", &dwell)
            .replace("{I}", &writer.decimal(number("I").abs()))
            .replace("{S}", &crate::block::short(number("S")))
            .replace("{aside}", &writer.decimal(aside));
        let feed = holes.pitch.map_or(holes.feed, |pitch| pitch * number("S"));
        text.replace("{f}", &crate::block::short(feed))
            .replace("{pitch}", &writer.decimal(holes.pitch.unwrap_or(0.0)))
    };
    let [before, cycle, feed] = [words.before, words.words, words.feed].map(put);
    let mut blocks: Vec<String> = Vec::with_capacity(holes.at.len() + 2);
    if !before.is_empty() {
        blocks.push(before);
    }
    for (number, [x, y]) in holes.at.iter().enumerate() {
        let place = format!("X{} Y{}", writer.decimal(*x), writer.decimal(*y));
        blocks.push(match number {
            0 => {
                let (z, r) = (writer.decimal(holes.bottom), writer.decimal(holes.reference));
                format!("G98 {cycle} {place} Z{z} R{r} F{feed}")
            }
            _ => place,
        });
    }
    blocks.push("G80".to_owned());
    for block in blocks {
        writer.line(&block);
    }
    Some(writer.text)
}
