//! Cycles that directives describe: what the dialogue of a control keeps, written as text.
//!
//! ```text
//! #CYCLE G287 [X=0, Y=0, …]      collected ─▶ Description ─▶ the dialect's build ─▶ Plan
//! #ROUGH [step=6, …]                                            │
//! #FINISH [delta=0.5, …]         when another block comes ──────┴▶ run, a stage at a point at a time
//! #MULTI LINE [alpha=45, …]
//! ```
//!
//! What a cycle's parameters are, and what they make, is the dialect's table; this file reads, keeps and
//! runs it. All its moves carry the block of the cycle.

use super::acts::FeedUnit;
use super::operation::Operation;
use super::parameter::WrongParameter;
use super::pocket::KeptPockets;
use super::positions::Figure;
use super::zone::ToolData;
use crate::Fallible;
use crate::dialect::MFunction;
use crate::directives::Profiles;
use crate::interpreter::Interpreter;
use crate::stages::corner::CornerKind;
use ferrocut_geometry::Turn;
use ferrocut_machine::{Alarm, Fault};
use ferrocut_program::Span;
use ferrocut_toolpath::{Op, Speed, SpindleState};

/// A part of a described cycle.
#[derive(Clone, Copy, PartialEq, Eq, Debug)]
pub enum Part {
    /// The cycle itself.
    Main,
    /// Drilling before it.
    Drill,
    /// Roughing.
    Rough,
    /// Semi-finishing.
    Semi,
    /// Finishing.
    Finish,
}

/// Most offsets of a tool.
const MOST_EDGE: f64 = 99.0;

/// Number of parts.
const PARTS: usize = 5;

/// What a parameter holds.
#[derive(Clone, Copy, PartialEq, Eq, Debug)]
pub enum Kind {
    /// A length or coordinate, or a feed.
    Length,
    /// An angle, a count, a speed, a time.
    Number,
    /// The tool that is made ready for after the cycle. It may stand with the finishing too.
    NextTool,
    /// One of these words.
    Word(&'static [&'static str]),
    /// A name.
    Name,
    /// A point, and what is made of the corner there.
    Point,
}

/// A parameter.
#[derive(Clone, Copy, PartialEq, Eq, Debug)]
pub struct Parameter {
    /// Its name.
    pub name: &'static str,
    /// What it holds.
    pub kind: Kind,
}

/// Its value.
#[derive(Clone, PartialEq, Debug)]
pub enum Entry {
    /// Lengths in mm.
    Number(f64),
    /// One of the words it takes.
    Word(&'static str),
    /// A name.
    Name(Box<str>),
    /// A point and its corner, mm.
    Point([f64; 2], Option<(CornerKind, f64)>),
}

/// The parameters of a part.
#[derive(Clone, PartialEq, Debug, Default)]
pub struct Section {
    entries: Vec<(&'static str, Entry)>,
}

impl Section {
    /// Keeps a value; false where there is one of this name already.
    pub fn put(&mut self, name: &'static str, entry: Entry) -> bool {
        if self.entry(name).is_some() {
            return false;
        }
        self.entries.push((name, entry));
        true
    }

    /// Takes a value out.
    fn take(&mut self, name: &str) -> Option<Entry> {
        let at = self.entries.iter().position(|(n, _)| *n == name)?;
        Some(self.entries.remove(at).1)
    }

    fn entry(&self, name: &str) -> Option<&Entry> {
        self.entries.iter().find(|(n, _)| *n == name).map(|(_, entry)| entry)
    }

    /// A number, where it is given.
    pub fn given(&self, name: &str) -> Option<f64> {
        match self.entry(name)? {
            Entry::Number(value) => Some(*value),
            _ => None,
        }
    }

    /// A number; 0 where it is not given.
    pub fn number(&self, name: &str) -> f64 {
        self.given(name).unwrap_or(0.0)
    }

    /// A word; `default` where it is not given.
    pub fn word(&self, name: &str, default: &'static str) -> &'static str {
        match self.entry(name) {
            Some(Entry::Word(word)) => word,
            _ => default,
        }
    }

    /// A name.
    pub fn name(&self, name: &str) -> Option<&str> {
        match self.entry(name)? {
            Entry::Name(text) => Some(text),
            _ => None,
        }
    }

    /// A point and its corner.
    pub fn point(&self, name: &str) -> Option<([f64; 2], CornerSize)> {
        match self.entry(name)? {
            Entry::Point(at, corner) => Some((*at, *corner)),
            _ => None,
        }
    }
}

/// The corner made at a point, and its size; none for a sharp one.
pub type CornerSize = Option<(CornerKind, f64)>;

/// A kind of described cycle: a row of the dialect's table.
#[derive(Debug)]
pub struct DescribedCycle {
    /// What the control calls it.
    pub id: &'static str,
    /// The parameters of its parts.
    pub parts: &'static [(Part, &'static [Parameter])],
    /// It may be repeated on a figure.
    pub repeats: bool,
    /// Makes a plan of them.
    pub build: fn(&Description<'_>) -> Result<Plan, WrongParameter>,
}

/// A kind of figure.
#[derive(Debug)]
pub struct DescribedFigure {
    /// What the control calls it.
    pub name: &'static str,
    /// Its parameters.
    pub parameters: &'static [Parameter],
    /// Makes a figure of them that begins at a point.
    pub build: fn(&Section, [f64; 2]) -> Result<Figure, WrongParameter>,
}

/// What a plan is made of.
pub struct Description<'a> {
    sections: &'a [Option<Section>; PARTS],
    /// The profiles of the program.
    pub profiles: &'a Profiles,
    /// Where computed pockets are kept, if anywhere.
    pub kept: Option<&'a dyn KeptPockets>,
    tools: &'a dyn Fn(f64, f64) -> ToolData,
}

/// An empty part, for one that is not given.
static NOTHING: Section = Section { entries: Vec::new() };

impl Description<'_> {
    /// The parameters of a part; none of them where it is not given.
    pub fn part(&self, part: Part) -> &Section {
        self.sections.get(part as usize).and_then(Option::as_ref).unwrap_or(&NOTHING)
    }

    /// Whether a part is given.
    pub fn has(&self, part: Part) -> bool {
        self.sections.get(part as usize).is_some_and(Option::is_some)
    }

    /// A tool of the table with an offset; number 0 is the one in the spindle.
    pub fn tool(&self, number: f64, edge: f64) -> ToolData {
        (self.tools)(number, edge)
    }
}

/// What a described cycle does.
#[derive(Clone, PartialEq, Debug)]
pub struct Plan {
    /// Its point.
    pub at: [f64; 2],
    /// Level on which the tool travels.
    pub safety: f64,
    /// What it does there.
    pub stages: Vec<Stage>,
    /// Tool that is chosen for afterwards.
    pub next_tool: Option<u32>,
    /// What a check is to say of it.
    pub warnings: Vec<WrongParameter>,
}

/// An operation with a tool.
#[derive(Clone, PartialEq, Debug)]
pub struct Stage {
    /// Number of the tool; 0 for the one in the spindle.
    pub tool: f64,
    /// Its offset.
    pub edge: f64,
    /// Speed, r/min.
    pub speed: f64,
    /// Sense of the spindle; none where it is stopped at an angle instead.
    pub turn: Option<Turn>,
    /// M functions before it.
    pub m: [Option<f64>; 4],
    /// What is done.
    pub operation: Operation,
    /// What its feeds are measured by.
    pub unit: FeedUnit,
}

/// A cycle being collected.
#[derive(Clone)]
struct Collected {
    cycle: &'static DescribedCycle,
    sections: [Option<Section>; PARTS],
    figure: Option<(&'static DescribedFigure, Section)>,
    span: Span,
}

/// A cycle being run.
#[derive(Clone)]
struct Running {
    plan: Plan,
    figure: Option<Figure>,
    span: Span,
    point: u32,
    stage: usize,
    /// Where the tool stood when the stage began, and how many of its acts are made.
    from: [f64; 3],
    made: u32,
}

/// Described cycles: what is collected, run and kept.
#[derive(Clone, Default)]
pub(crate) struct Described {
    collected: Option<Box<Collected>>,
    running: Option<Box<Running>>,
    pub profiles: Profiles,
    /// Codes of canned cycles are those of another kind of machine (`#LATHECY ON`).
    pub other_cycles: bool,
}

impl Described {
    /// Whether a cycle is being run.
    #[inline]
    pub fn is_running(&self) -> bool {
        self.running.is_some()
    }

    /// Whether a cycle is collected that runs when another block comes.
    #[inline]
    pub fn is_collecting(&self) -> bool {
        self.collected.is_some()
    }

    /// Forgets everything.
    pub fn reset(&mut self) {
        *self = Described::default();
    }
}

impl Interpreter {
    /// Begins a cycle. One before it was run when this block was reached.
    pub(crate) fn begin_described(
        &mut self,
        cycle: &'static DescribedCycle,
        main: Section,
        span: Span,
    ) -> Fallible<()> {
        let mut sections = [const { None }; PARTS];
        if let Some(slot) = sections.first_mut() {
            *slot = Some(main);
        }
        self.described.collected = Some(Box::new(Collected { cycle, sections, figure: None, span }));
        Ok(())
    }

    /// The parameters that a part of the cycle being collected has; none where it has no such part, or has it
    /// already.
    pub(crate) fn part_of_described(&self, part: Part) -> Option<&'static [Parameter]> {
        let collected = self.described.collected.as_ref()?;
        let taken = collected.sections.get(part as usize).is_some_and(Option::is_some);
        let row = collected.cycle.parts.iter().find(|(p, _)| *p == part);
        row.filter(|_| !taken).map(|(_, parameters)| *parameters)
    }

    /// The parameter of the cycle itself that stands in a part too: the dialogue asks for the next tool with the finishing
    /// (Fagor 4.12).
    pub(crate) fn shared_with_part(&self, part: Part) -> Option<&'static Parameter> {
        let cycle = self.described.collected.as_ref()?.cycle;
        let (_, main) = cycle.parts.iter().find(|(p, _)| *p == Part::Main)?;
        main.iter().find(|p| part == Part::Finish && p.kind == Kind::NextTool)
    }

    /// Adds a part. What it shares with the cycle itself goes there; false where that has it already.
    pub(crate) fn add_part(&mut self, part: Part, mut section: Section) -> bool {
        let shared = self.shared_with_part(part).and_then(|p| Some((p.name, section.take(p.name)?)));
        let Some(collected) = &mut self.described.collected else { return true };
        let [main, parts @ ..] = &mut collected.sections;
        if let Some(slot) = (part as usize).checked_sub(1).and_then(|at| parts.get_mut(at)) {
            *slot = Some(section);
        }
        shared.is_none_or(|(name, entry)| main.get_or_insert_default().put(name, entry))
    }

    /// Whether the cycle being collected may be repeated on a figure, and is not yet.
    pub(crate) fn takes_figure(&self) -> bool {
        self.described.collected.as_ref().is_some_and(|c| c.cycle.repeats && c.figure.is_none())
    }

    /// Adds a figure.
    pub(crate) fn add_figure(&mut self, figure: &'static DescribedFigure, section: Section) {
        if let Some(collected) = &mut self.described.collected {
            collected.figure = Some((figure, section));
        }
    }

    /// The block of the cycle being collected.
    pub(crate) fn described_span(&self) -> Option<Span> {
        self.described.collected.as_ref().map(|c| c.span)
    }

    /// Runs the cycle that was collected.
    pub(crate) fn run_described(&mut self) -> Fallible<()> {
        let Some(collected) = self.described.collected.take() else { return Ok(()) };
        self.words.start_at(collected.span);
        self.output.start_block();
        // An active cycle of the program is gone (4.1.2).
        self.cancel_cycle();
        let span = collected.span;
        let (in_spindle, in_force) = (self.technology.in_spindle, self.technology.edge);
        let tools = |number: f64, edge: f64| match number == 0.0 {
            true => self.tool_data(in_spindle, in_force),
            false => self.tool_data(number.clamp(0.0, f64::from(u32::MAX)) as u32, edge),
        };
        let description = Description {
            sections: &collected.sections,
            profiles: &self.described.profiles,
            kept: self.kept_pockets.as_deref().map(|kept| kept as &dyn KeptPockets),
            tools: &tools,
        };
        let plan = (collected.cycle.build)(&description)
            .and_then(|plan| {
                let figure = collected
                    .figure
                    .as_ref()
                    .map(|(figure, section)| (figure.build)(section, plan.at))
                    .transpose();
                figure.map_err(|wrong| wrong.of_part("#MULTI")).map(|figure| (plan, figure))
            })
            .map_err(|wrong| self.wrong_parameter(wrong, span));
        let (plan, figure) = match plan {
            Ok(made) => made,
            Err(alarm) => return self.give_up_described(alarm),
        };
        if let Err(alarm) = self.check_stages(&plan, span) {
            return self.give_up_described(alarm);
        }
        if self.tells() {
            for wrong in &plan.warnings {
                let warning = self.wrong_parameter(*wrong, span).as_warning();
                self.note(Box::new(warning));
            }
        }
        let from = self.in_plane_axes();
        let running = Running { plan, figure, span, point: 1, stage: 0, from, made: 0 };
        self.described.running = Some(Box::new(running));
        Ok(())
    }

    fn give_up_described(&mut self, alarm: Box<Alarm>) -> Fallible<()> {
        self.described.running = None;
        if !self.options.keep_going {
            return Err(alarm);
        }
        self.note(alarm);
        Ok(())
    }

    /// What forbids a plan before its first move.
    fn check_stages(&self, plan: &Plan, span: Span) -> Fallible<()> {
        let is_number = |number: f64, most| number.fract() == 0.0 && (0.0..=most).contains(&number);
        let mut speed = self.technology.speed.unwrap_or(0.0);
        for stage in &plan.stages {
            if stage.operation.is_endless() {
                return Err(self.alarm(Fault::MillTooManyMoves, span));
            }
            if !is_number(stage.tool, self.rules.max_tool) {
                return Err(self.alarm(Fault::ToolNumber, span));
            }
            let wrong_m = ["M1", "M2", "M3", "M4"].into_iter().zip(stage.m).find_map(|(name, code)| {
                let row = self.dialect.m_code(code.filter(|code| is_number(*code, 999.0))? as u16)?;
                // The moves of the cycle would come behind the program's end, or with another tool.
                matches!(row.function, MFunction::ProgramEnd | MFunction::End | MFunction::ToolChange)
                    .then_some(name)
            });
            let wrong = match wrong_m {
                _ if !(stage.speed >= 0.0) => Some("S"),
                _ if !is_number(stage.edge, MOST_EDGE) => Some("D"),
                wrong => wrong,
            };
            if let Some(word) = wrong {
                return Err(self.wrong_parameter(WrongParameter::new(Fault::CycleParameter, word), span));
            }
            // The manual has the spindle started and does not say at what speed without S: it would stand, and the tool
            // be fed into the part.
            if stage.speed > 0.0 {
                speed = stage.speed;
            }
            if stage.turn.is_some() && speed <= 0.0 {
                return Err(self.wrong_parameter(WrongParameter::new(Fault::CycleNoSpindle, "S"), span));
            }
        }
        Ok(())
    }

    /// Runs the next stage of the cycle at its point, or what is left of it.
    pub(crate) fn next_described(&mut self) -> Fallible<()> {
        let Some(running) = self.described.running.take() else { return Ok(()) };
        match self.run_stage(running) {
            Ok(left) => {
                self.described.running = left;
                Ok(())
            }
            Err(alarm) => self.give_up_described(alarm),
        }
    }

    fn run_stage(&mut self, mut running: Box<Running>) -> Fallible<Option<Box<Running>>> {
        self.words.start_at(running.span);
        let at = running.figure.as_ref().map_or(running.plan.at, |figure| figure.point(running.point));
        let points = running.figure.as_ref().map_or(1, Figure::count);
        if let Some(stage) = running.plan.stages.get(running.stage) {
            let operation = &stage.operation;
            if running.made == 0 {
                let first = running.point == 1;
                self.use_tool(stage, first)?;
                self.prepare_tool(&running, points);
                if let Some(start) = operation.start(at) {
                    self.rapid_over(start, running.plan.safety, operation.up)?;
                }
                running.from = self.in_plane_axes();
            }
            if let Some(made) = self.make_portion(operation, at, running.from, running.made, stage.unit)? {
                running.made = made;
                return Ok(Some(running));
            }
        }
        running.made = 0;
        running.stage += 1;
        if running.stage >= running.plan.stages.len() {
            running.stage = 0;
            running.point += 1;
        }
        Ok((running.point <= points).then_some(running))
    }

    /// The tool behind the cycle is made ready (3.1), once the one in the spindle is the last that the cycle needs.
    fn prepare_tool(&mut self, running: &Running, points: u32) {
        let Some(next) = running.plan.next_tool else { return };
        let stages = &running.plan.stages;
        let left = if running.point < points { &stages[..] } else { &stages[running.stage..] };
        let is_last =
            left.iter().all(|stage| stage.tool == 0.0 || stage.tool == f64::from(self.technology.in_spindle));
        if is_last && self.technology.tool != next {
            self.technology.tool = next;
            self.emit(Op::Select(next));
        }
    }

    /// Puts the tool of a stage in the spindle, where it is not, and turns it. At points behind the `first` a spindle that
    /// is to stand at its angle does so (4.6.1).
    fn use_tool(&mut self, stage: &Stage, first: bool) -> Fallible<()> {
        let number = stage.tool as u32;
        let mut stands = !first && self.technology.spindle == SpindleState::Off;
        if number != 0 && number != self.technology.in_spindle {
            stands = false;
            if self.technology.tool != number {
                self.technology.tool = number;
                self.emit(Op::Select(number));
            }
            self.spindle(SpindleState::Off);
            self.emit(Op::Change(number));
            self.tool_changed(Some(stage.edge));
        } else if number != 0 && stage.edge != self.technology.edge {
            self.edge_chosen(stage.edge);
        }
        if stage.speed > 0.0 {
            self.technology.speed = Some(stage.speed.min(self.rules.max_spindle_rpm));
        }
        for code in stage.m.into_iter().flatten() {
            let known = (0.0..=f64::from(u16::MAX)).contains(&code) && code.fract() == 0.0;
            let row = known.then(|| self.dialect.m_code(code as u16)).flatten();
            let Some(row) = row else {
                return Err(self.alarm(Fault::UnknownMCode, self.words.block_span()));
            };
            self.m_function(row, self.words.block_span())?;
        }
        let rpm = self.technology.speed.unwrap_or(0.0);
        match stage.turn {
            Some(turn) => self.spindle(SpindleState::turning(turn, Speed::Rpm(rpm))),
            None if stands => {}
            None => {
                self.technology.spindle = SpindleState::Off;
                self.emit(Op::Orient(0.0));
            }
        }
        Ok(())
    }
}
