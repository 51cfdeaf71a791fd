//! Programs that stand for codes, by which a shop gives a code another meaning or makes one of its own
//! (Weihong 4.3 "custom canned cycles", 6).
//!
//! Which there are is found before the first block, in program memory. Such a program runs where the code
//! would have acted; the block it stood in is set aside and goes on behind it. Within the program its own
//! code is the built-in one.

use crate::Fallible;
use crate::cycles::{CycleKind, CycleState};
use crate::dialect::{CustomPrograms, GCode, MCode, MFunction, Meaning};
use crate::execute::{Part, Rest};
use crate::interpreter::Interpreter;
use crate::modal::Group;
use crate::stages::units;
use crate::words::{Code, Words};
use ferrocut_geometry::{Axis, MM_PER_INCH};
use ferrocut_machine::{Alarm, Fault};
use ferrocut_program::{ProgramId, ProgramMemory, Span};
use std::io;

/// Codes of one letter that programs can stand for.
const MOST: usize = 400;

/// Rows of M codes that no table has.
static ROWS: [MCode; MOST] = {
    let row = MCode { code: 0, function: MFunction::Machine, after_motion: false, controls_program: false };
    let mut rows = [row; MOST];
    let mut code = 0;
    while code < MOST {
        rows[code].code = code as u16;
        code += 1;
    }
    rows
};

/// Rows of G codes that no table has: cycles that the shop made.
static CYCLES: [GCode; MOST] = {
    let row =
        GCode { tenths: 0, meaning: Meaning::Cycle(CycleKind::Own), group: Group::Cycle, group_number: 0 };
    let mut rows = [row; MOST];
    let mut code = 0;
    while code < MOST {
        rows[code].tenths = 10 * code as u16;
        code += 1;
    }
    rows
};

/// The codes that programs stand for.
#[derive(Clone, Debug)]
pub(crate) struct CustomCodes {
    programs: CustomPrograms,
    g: [bool; MOST],
    m: [bool; MOST],
    speed: bool,
}

/// A code that a program stands for.
#[derive(Clone, Copy, PartialEq, Eq, Debug)]
pub(crate) enum Custom {
    /// A G code by its whole number.
    G(u16),
    /// An M code.
    M(u16),
    /// An S word.
    Speed,
    /// The tool change of the machine.
    ToolChange,
}

/// A block set aside while the program of one of its codes runs.
#[derive(Clone)]
pub(crate) struct Suspended {
    code: Custom,
    words: Words,
    rest: Rest,
    cycle: (CycleState, &'static GCode),
}

impl std::fmt::Debug for Suspended {
    fn fmt(&self, f: &mut std::fmt::Formatter<'_>) -> std::fmt::Result {
        f.debug_struct("Suspended").field("code", &self.code).finish_non_exhaustive()
    }
}

impl Suspended {
    pub(crate) fn code(&self) -> Custom {
        self.code
    }
}

impl CustomCodes {
    /// The codes that programs of the memory stand for; `None` where there are none.
    pub(crate) fn find(
        programs: CustomPrograms,
        memory: &mut ProgramMemory,
    ) -> io::Result<Option<Box<CustomCodes>>> {
        let (first, end) = (programs.m.min(programs.g), programs.m.max(programs.g) + programs.count);
        let mut codes = CustomCodes { programs, g: [false; MOST], m: [false; MOST], speed: false };
        let mut any = false;
        for number in memory.numbers_within(first..end)? {
            any = true;
            let within = |from: u32| number.checked_sub(from).filter(|n| *n < programs.count);
            let slot = match number {
                n if n == programs.speed => &mut codes.speed,
                _ => match (within(programs.m), within(programs.g)) {
                    (Some(code), _) if number < programs.g || programs.g < programs.m => {
                        codes.m.get_mut(code as usize).unwrap_or(&mut codes.speed)
                    }
                    (_, Some(code)) => codes.g.get_mut(code as usize).unwrap_or(&mut codes.speed),
                    _ => continue,
                },
            };
            *slot = true;
        }
        Ok(any.then(|| Box::new(codes)))
    }

    /// The whole number of a code.
    fn whole(value: f64) -> Option<u16> {
        (value.fract() == 0.0 && (0.0..MOST as f64).contains(&value)).then_some(value as u16)
    }

    fn has_g(&self, code: u16) -> bool {
        self.g.get(usize::from(code)).copied().unwrap_or(false)
    }

    /// The row of a G code that no table has and a program stands for: it repeats like the canned cycle that the manual
    /// says such programs are for (Weihong 4.3, "custom canned cycles").
    pub(crate) fn g_code(&self, value: f64) -> Option<&'static GCode> {
        let code = CustomCodes::whole(value).filter(|code| self.has_g(*code))?;
        CYCLES.get(usize::from(code))
    }

    fn has_m(&self, code: u16) -> bool {
        self.m.get(usize::from(code)).copied().unwrap_or(false)
    }

    /// The row of an M code that a program stands for.
    pub(crate) fn m_code(&self, code: u16) -> Option<&'static MCode> {
        ROWS.get(usize::from(code)).filter(|_| self.has_m(code))
    }

    fn program(&self, code: Custom) -> Option<u32> {
        match code {
            Custom::G(n) => Some(self.programs.g + u32::from(n)),
            Custom::M(n) => Some(self.programs.m + u32::from(n)),
            Custom::Speed => Some(self.programs.speed),
            Custom::ToolChange => None,
        }
    }
}

impl Interpreter {
    /// Whether a program stands for a code here: not within that program.
    fn is_custom(&self, code: Custom) -> bool {
        let Some(codes) = &self.custom else { return false };
        let has = match code {
            Custom::G(n) => codes.has_g(n),
            Custom::M(n) => codes.has_m(n),
            Custom::Speed => codes.speed,
            Custom::ToolChange => false,
        };
        has && !self.flow.runs_custom(code)
    }

    /// The program that stands for an M code. Calls and returns keep their meaning.
    pub(crate) fn custom_m(&self, row: &MCode) -> Option<Custom> {
        if row.function == MFunction::ToolChange && self.is_auxiliary_locked() {
            return None;
        }
        // A change to the tool that is in the spindle changes nothing (GSK990MC 8.1). A program of the shop for M06 itself
        // goes before that of the machine (Weihong 5).
        if row.function == MFunction::ToolChange
            && self.options.tool_change_program.is_some()
            && !self.custom.as_ref().is_some_and(|codes| codes.has_m(row.code))
            && self.technology.in_spindle != self.technology.tool
            && !self.flow.runs_custom(Custom::ToolChange)
        {
            return Some(Custom::ToolChange);
        }
        let code = Custom::M(row.code);
        let is_fixed = matches!(row.function, MFunction::Call | MFunction::Return | MFunction::End);
        (!is_fixed && self.is_custom(code)).then_some(code)
    }

    /// The program that stands for S words.
    pub(crate) fn custom_speed(&self) -> Option<Custom> {
        self.is_custom(Custom::Speed).then_some(Custom::Speed)
    }

    /// The program that stands for a G code which is no cycle.
    pub(crate) fn custom_g(&self, row: &GCode) -> Option<Custom> {
        if self.custom.is_none() || !row.tenths.is_multiple_of(10) || matches!(row.meaning, Meaning::Cycle(_))
        {
            return None;
        }
        let code = Custom::G(row.tenths / 10);
        self.is_custom(code).then_some(code)
    }

    /// The program that stands for the cycle in force.
    pub(crate) fn custom_cycle(&self) -> Option<Custom> {
        self.custom_of_cycle(self.modal.code(Group::Cycle)?)
    }

    fn custom_of_cycle(&self, row: &GCode) -> Option<Custom> {
        self.custom.as_ref()?;
        let code = Custom::G(row.tenths / 10);
        (matches!(row.meaning, Meaning::Cycle(_)) && self.is_custom(code)).then_some(code)
    }

    /// Refuses two cycles in a block where a program of the shop stands for one of them: it would go for nothing, or the other
    /// would. Of those that the control has the last counts, as on Fanuc; the manual (Weihong 4.3) says nothing of either.
    pub(crate) fn refuse_beside_own(&self, before: Code<GCode>, row: &GCode) -> Fallible<()> {
        let is_own = |row: &GCode| {
            row.meaning == Meaning::Cycle(CycleKind::Own) || self.custom_of_cycle(row).is_some()
        };
        if before.row.meaning != Meaning::CycleOff && (is_own(before.row) || is_own(row)) {
            return Err(self.alarm(Fault::NeedsOwnBlock, before.span));
        }
        Ok(())
    }

    /// Sets the block aside and runs the program of one of its codes; `rest` is done behind it.
    pub(crate) fn call_custom(&mut self, code: Custom, rest: &mut Rest, span: Span) -> Fallible<()> {
        let number = match code {
            Custom::ToolChange => self.options.tool_change_program,
            code => self.custom.as_ref().and_then(|codes| codes.program(code)),
        };
        let Some(number) = number else { return Ok(()) };
        if let Custom::G(_) = code {
            self.pass_words(rest.part == Part::Holes);
        }
        // P beside an M code of the shop is its own and no dwell.
        if matches!(code, Custom::M(_) | Custom::ToolChange) {
            self.words.take(b'P');
        }
        let id = ProgramId::Number(number);
        self.call(&id, 1, None, span)?;
        let off = self.dialect.cycle_off;
        let cycle = (std::mem::take(&mut self.cycle), self.modal.code(Group::Cycle).unwrap_or(off));
        self.modal.set(off);
        let words = std::mem::replace(&mut self.words, Words::new());
        self.flow.suspend(Suspended { code, words, rest: std::mem::take(rest), cycle });
        Ok(())
    }

    /// Goes on with a block that was set aside.
    pub(crate) fn resume(&mut self, suspended: Suspended) -> Fallible<()> {
        let Suspended { words, mut rest, cycle: (state, row), .. } = suspended;
        self.words = words;
        self.cycle = state;
        self.modal.set(row);
        self.output.start_block();
        match self.finish_block(&mut rest) {
            Err(alarm) => self.give_up_block(alarm),
            done => done,
        }
    }

    /// The words of the block as variables, in the program's units: levels of a cycle as levels, places as
    /// the block's G90 or G91 has them (Weihong 5, list of `#FC`).
    fn pass_words(&mut self, of_cycle: bool) {
        let Some(programs) = self.custom.as_ref().map(|codes| codes.programs) else { return };
        let (inch, incremental) = (self.modal.is_inch(), self.modal.is_incremental());
        let unit = if inch { MM_PER_INCH } else { 1.0 };
        let here = self.location.programmed;
        let place = of_cycle.then(|| self.place_of_next_hole());
        let data = of_cycle.then(|| self.cycle.data());
        // I, J and K of a figure say where its holes are, of which each is a call by itself.
        let is_own = self.is_own_cycle();
        let in_figure = of_cycle && self.cycle.is_in_figure();
        for (letter, variable) in programs.arguments {
            let word = self.words.get(*letter);
            let value = match (*letter, &data) {
                // Without a level the axis is where it is.
                (b'Z', Some(data)) => data.z.or(is_own.then_some(here[Axis::Z])).map(|z| z / unit),
                (b'R', Some(data)) => data.r.map(|r| r / unit),
                (b'Q', Some(data)) => data.q.map(|q| q / unit),
                (b'P', Some(data)) => data.p.map(|p| p / self.rules.dwell_p_unit_s),
                (b'I' | b'J', _) if in_figure => None,
                (b'K', _) if in_figure => Some(1.0),
                (b'K', Some(_)) if !is_own => Some(self.repeats()),
                (b'F', _) => word.or(Some(self.technology.feed_per_minute / unit)),
                (b'X' | b'Y' | b'Z', _) => {
                    let axis = Axis::from_letter(*letter).unwrap_or(Axis::X);
                    let inch_axes = self.inch_axes();
                    let given = word.map(|word| units::coordinate(axis, word, inch_axes));
                    let value = match (place, incremental) {
                        (Some(place), true) => Some(place[axis] - here[axis]),
                        (Some(place), false) => Some(place[axis]),
                        (None, true) => given,
                        (None, false) => given.or(Some(here[axis])),
                    };
                    value.map(|value| self.in_words(axis, value))
                }
                _ => word,
            };
            self.set_own_variable(*variable, value.unwrap_or(0.0));
        }
        let to_r = self.modal.meaning(Group::Return) == Meaning::ReturnR;
        let initial = if of_cycle { self.cycle.data().initial } else { here[Axis::Z] };
        self.set_own_variable(programs.returns_to_r, f64::from(u8::from(to_r)));
        self.set_own_variable(programs.incremental, f64::from(u8::from(incremental)));
        self.set_own_variable(programs.initial, initial / unit);
    }

    fn set_own_variable(&mut self, number: u32, value: f64) {
        // There is room: these few are the first of all.
        let _ = self.memory.variables.set(number, Some(value));
        self.variable_writes += 1;
    }

    /// The alarm of programs that cannot be read while codes are looked for.
    pub(crate) fn unreadable_programs(error: &io::Error) -> Box<Alarm> {
        let alarm = Alarm::core(Fault::FileUnreadable, Span { line: 1, ..Span::default() });
        Box::new(alarm.with("reason", error.to_string()))
    }
}
