//! The cycles of the editor as forms, and as text in any control's language.
//!
//! In: a form as it was filled in ([`Request`]). Out: the cycle as text in the language at hand, and what is wrong
//! with each field ([`Written`]). The Fagor control has these cycles as such and gets a `#CYCLE` block. Any other
//! gets its own canned cycle where that makes the same motion, else the moves, block by block.
//!
//! The way of the data: [`form`] and [`fields`] (what can be filled in, from the interpreter's tables) →
//! [`request`] → [`block`] (the `#CYCLE` block) → [`run`] (what it does, and what the control has against it) →
//! [`own`] or [`expand`] (the same in another language) → [`motion`] (what was written is run again, and given out
//! only if it does the same). [`profile`] makes contours from drawings.

pub mod block;
pub mod expand;
pub mod fields;
pub mod finding;
pub mod form;
pub mod motion;
pub mod own;
pub mod profile;
pub mod request;
pub mod run;
pub mod style;
pub mod texts;

pub use finding::{Finding, Wrong};
pub use form::{Form, forms};
pub use profile::{FromDrawing, from_dxf};
pub use request::Request;

use expand::{Unwritten, Writer};
use ferrocut_geometry::Position;
use ferrocut_interpreter::Dialect;
use ferrocut_interpreter::dialects::fagor8065;
use ferrocut_machine::{Fault, Memory};
use ferrocut_toolpath::Step;
use request::Value;
use run::Ran;
use style::{OWN_STATE, Style};

/// What a form comes to.
#[derive(Clone, PartialEq, Debug, Default)]
pub struct Written {
    /// The text; empty where the cycle cannot be made.
    pub text: String,
    /// It is moves, block by block, and no cycle.
    pub is_expanded: bool,
    /// What is wrong, or worth knowing.
    pub wrong: Vec<Wrong>,
}

/// What the cycle of a form does: the steps behind `G17 G71 G90` from beside the part, in coordinates of the
/// program, and what is wrong with it.
pub struct Made {
    /// The `#CYCLE` block.
    pub block: String,
    /// The steps; empty where it cannot be made.
    pub steps: Vec<Step>,
    /// There are no more of them than are kept.
    pub is_whole: bool,
    /// Where the tool is before them.
    pub start: Position,
    /// What is wrong, or worth knowing.
    pub wrong: Vec<Wrong>,
}

impl Made {
    /// Whether nothing forbids it.
    pub fn is_possible(&self) -> bool {
        !self.wrong.iter().any(Wrong::is_error)
    }
}

/// A control that is to run a cycle: its parameters say how its own cycles move, and its tools what a mill clears.
#[derive(Clone, Copy)]
pub struct Control<'a> {
    /// Its language.
    pub dialect: &'static Dialect,
    /// What it remembers, in that language.
    pub memory: &'a Memory,
}

/// Makes the cycle of a form. `machine` has the tools that the form does not describe itself.
pub fn make(request: &Request, machine: Option<Control<'_>>) -> Made {
    let (block, mut wrong) = block::block(request);
    let level = match request.values.get("Z") {
        Some(Value::Number(z)) if z.is_finite() => *z,
        _ => 0.0,
    };
    let start = run::start(level);
    let (mut steps, mut is_whole) = (Vec::new(), true);
    if !wrong.iter().any(Wrong::is_error) {
        let program = format!("{OWN_STATE} G94 G54\n{block}M30\n");
        let memory = run::fagor_desk(machine, request);
        let Ran { steps: made, alarms, is_cut_short } =
            run::run(&fagor8065::DIALECT, &program, memory, start, true);
        wrong.extend(alarms.into_iter().map(Wrong::of));
        is_whole = !is_cut_short;
        if !wrong.iter().any(Wrong::is_error) {
            steps = made;
        }
    }
    Made { block, steps, is_whole, start, wrong }
}

/// Writes the cycle of a form in a control's language. `machine` is the control that is to run it; without one it is
/// one as delivered.
pub fn write(request: &Request, dialect: &'static Dialect, machine: Option<Control<'_>>) -> Written {
    let made = make(request, machine);
    if !made.is_possible() {
        return Written { wrong: made.wrong, ..Written::default() };
    }
    if dialect.name == fagor8065::DIALECT.name {
        let text = format!("{OWN_STATE}\n{}", made.block);
        return Written { text, is_expanded: false, wrong: made.wrong };
    }
    let mut wrong = made.wrong.clone();
    match elsewhere(request, &made, dialect, machine) {
        Ok((text, is_expanded)) => Written { text, is_expanded, wrong },
        Err(refused) => {
            wrong.push(*refused);
            Written { wrong, ..Written::default() }
        }
    }
}

/// The text in another language, and whether it is expanded.
fn elsewhere(
    request: &Request,
    made: &Made,
    dialect: &'static Dialect,
    machine: Option<Control<'_>>,
) -> Result<(String, bool), Box<Wrong>> {
    if !made.is_whole {
        return Err(Box::new(Wrong::new(Fault::CycleTooLong, "").with("limit", run::MOST_STEPS as f64)));
    }
    let style = Style::of(dialect.name)
        .ok_or_else(|| Box::new(Wrong::new(Fault::NoWriter, "").with("name", dialect.name)))?;
    let memory = run::desk(dialect, machine);
    let rules = (dialect.rules)(&memory.parameters);
    let other = || Box::new(Wrong::new(Fault::CycleNotWritten, "").with("name", dialect.name));
    let wanted = motion::motions(&made.steps, made.start).ok_or_else(other)?;
    let makes_it = |text: &str| {
        let program = program(style, text);
        let ran = run::run(dialect, &program, memory.clone(), made.start, false);
        let done =
            motion::motions(&ran.steps, made.start).filter(|_| ran.alarms.is_empty() && !ran.is_cut_short);
        done.is_some_and(|done| motion::difference(&wanted, &done).is_none())
    };
    let safety = match request.values.get("ZS") {
        Some(Value::Number(safety)) => *safety,
        _ => 0.0,
    };
    let head = |text: &str| {
        let mut writer = Writer::new(style, &rules, safety);
        writer.comment(&heading(request));
        // What it was filled in with goes along, so that it can be opened again.
        for line in made.block.lines() {
            writer.comment(line);
        }
        writer.line(style.state);
        let mut end = Writer::new(style, &rules, safety);
        end.comment(&format!("END {}", request.cycle));
        format!("{}{text}{}", writer.text, end.text)
    };
    let candidates = style.holes.iter().filter(|words| words.of == request.cycle);
    if let Some(holes) = own::Holes::of(&made.steps, safety) {
        for words in candidates {
            let text = own::text(request, &made.steps, &holes, style, &rules, words).map(|text| head(&text));
            if let Some(text) = text.filter(|text| makes_it(text)) {
                return Ok((text, false));
            }
        }
    }
    let mut writer = Writer::new(style, &rules, safety);
    writer.steps(&made.steps).map_err(|unwritten| match unwritten {
        Unwritten::Synchronised => {
            Box::new(Wrong::new(Fault::CycleSynchronised, "type").with("name", dialect.name))
        }
        Unwritten::Other => other(),
    })?;
    let text = head(&writer.text);
    if makes_it(&text) { Ok((text, true)) } else { Err(other()) }
}

/// A whole program of a text, for trying it.
pub fn program(style: &Style, text: &str) -> String {
    let number = if matches!(style.dialect, "gsk990mc" | "kaitong") { "O0001\n" } else { "" };
    format!("{number}{text}M30\n")
}

/// What a comment says of the cycle that the blocks were.
fn heading(request: &Request) -> String {
    let form = form::cycle(&request.cycle).map_or("", |cycle| cycle.id);
    let title = texts::Texts::of(ferrocut_machine::Language::En).get(&format!("cycle-{form}"));
    format!("{form} {}", title.to_uppercase())
}
