//! O words: subprograms, loops and conditions (LinuxCNC, O codes), and M98 and M99.
//!
//! Lines are taken as they come, and what leads elsewhere is looked for when it is first met: the end of a loop
//! that is left, the next branch of a condition, the subprogram of a call. Where it led is remembered by the
//! line that it led from, so that no text is looked through twice. A call takes a place on a stack that is kept.

use crate::Fallible;
use crate::execute::fault_of;
use crate::interpreter::Interpreter;
use ferrocut_machine::Fault;
use ferrocut_program::{Block, DefectKind, FileId, Label, OKeyword, OWord, Page, Place, Span};
use rustc_hash::FxHashMap;

/// Calls within each other at most (LinuxCNC, O codes).
const MAX_CALLS: usize = 9;

/// Local parameters: #1 and on.
const LOCALS: u32 = 30;

/// Lines remembered; a program that computes its labels must not fill the memory.
const MAX_REMEMBERED: usize = 1 << 16;

/// What an O word is called by, once it is known.
#[derive(Clone, Copy, PartialEq, Eq, Hash, Debug)]
enum Name {
    Number(u32),
    Name(u32),
}

/// A loop or condition that was met.
#[derive(Clone, Copy, Debug)]
struct Known {
    place: Place,
    keyword: OKeyword,
    /// Passes that a repeat still has to do, this one included.
    passes: u64,
}

/// A subprogram that is known.
#[derive(Clone, Copy, Debug)]
struct Subprogram {
    /// Its first block.
    start: Place,
    /// Number of its labels.
    scope: u32,
    /// What it begins with.
    keyword: OKeyword,
}

/// A subprogram being run.
#[derive(Clone, Debug)]
struct Frame {
    /// Block after the call.
    back: Place,
    /// First block of the subprogram.
    start: Place,
    /// The subprogram, which its loops and conditions belong to.
    scope: u32,
    /// How often it is still to be run again.
    repeats: u32,
    /// The caller's local parameters; none where the call shares them (M98).
    locals: Option<[f64; LOCALS as usize]>,
}

/// Subprograms, loops and conditions.
#[derive(Clone, Debug, Default)]
pub(crate) struct OWords {
    calls: Vec<Frame>,
    /// Subprograms that are known.
    subprograms: FxHashMap<Name, Subprogram>,
    /// Loops and conditions of each scope.
    known: FxHashMap<(u32, Name), Known>,
    /// Where a line leads that ends a pass, a branch, or the definition of a subprogram.
    leads: FxHashMap<Place, Place>,
    /// A branch that was jumped to, since those before do not hold.
    branch: Option<Place>,
    /// Values of a call.
    arguments: Vec<f64>,
}

impl OWords {
    /// Subprograms being run.
    pub(crate) fn depth(&self) -> usize {
        self.calls.len()
    }

    fn scope(&self) -> u32 {
        self.calls.last().map_or(0, |frame| frame.scope)
    }
}

/// A line behind the present one, as a search sees it.
enum Seen {
    /// Not the one.
    Pass,
    /// The one.
    Found,
    /// The search ends with a fault.
    Fault(Fault),
}

impl Interpreter {
    /// Runs a line with an O word.
    pub(super) fn ngc_o_word(&mut self, page: &Page, block: &Block, word: OWord) -> Fallible<()> {
        let span = page.block_span(block);
        let name = self.ngc_label(page, word.label).map_err(|fault| self.alarm(fault, span))?;
        let at = self.flow.executing();
        match word.keyword {
            OKeyword::Sub => self.o_sub(name, at, span),
            OKeyword::EndSub | OKeyword::Return => self.o_return(page, &word, span),
            OKeyword::Call => self.o_call(page, &word, name, span),
            OKeyword::If => {
                self.o_meet(name, OKeyword::If, at, span)?;
                match self.o_value(page, &word, span)? != 0.0 {
                    true => Ok(()),
                    false => self.o_next_branch(name, at, span),
                }
            }
            OKeyword::ElseIf | OKeyword::Else | OKeyword::EndIf => {
                self.o_known(name, &[OKeyword::If], span)?;
                let is_next = self.ngc.o_words.branch.take() == Some(at);
                match word.keyword {
                    OKeyword::EndIf => Ok(()),
                    OKeyword::Else if is_next => Ok(()),
                    OKeyword::ElseIf if is_next => match self.o_value(page, &word, span)? != 0.0 {
                        true => Ok(()),
                        false => self.o_next_branch(name, at, span),
                    },
                    // Reached from the branch before, which is done.
                    _ => self.o_skip(at, name, &[OKeyword::EndIf], span),
                }
            }
            OKeyword::While => match self.o_find(name) {
                // The end of `do`.
                Some(known) if known.keyword == OKeyword::Do => {
                    if self.o_value(page, &word, span)? != 0.0 {
                        self.flow.jump(known.place);
                    }
                    Ok(())
                }
                _ => {
                    self.o_meet(name, OKeyword::While, at, span)?;
                    match self.o_value(page, &word, span)? != 0.0 {
                        true => Ok(()),
                        false => self.o_skip_behind(at, name, &[OKeyword::EndWhile], span),
                    }
                }
            },
            OKeyword::Do => self.o_meet(name, OKeyword::Do, at, span),
            OKeyword::EndWhile => {
                let known = self.o_known(name, &[OKeyword::While], span)?;
                self.flow.jump(known.place);
                Ok(())
            }
            OKeyword::Repeat => self.o_repeat(page, &word, name, at, span),
            OKeyword::EndRepeat => {
                let known = self.o_known(name, &[OKeyword::Repeat], span)?;
                if known.passes > 1 {
                    let key = (self.ngc.o_words.scope(), name);
                    if let Some(known) = self.ngc.o_words.known.get_mut(&key) {
                        known.passes -= 1;
                    }
                    self.flow.jump(behind(known.place));
                }
                Ok(())
            }
            OKeyword::Break | OKeyword::Continue => {
                let known = self.o_known(name, &[OKeyword::While, OKeyword::Do], span)?;
                let end = match known.keyword {
                    OKeyword::Do => OKeyword::While,
                    _ => OKeyword::EndWhile,
                };
                match word.keyword {
                    OKeyword::Break => self.o_skip_behind(at, name, &[end], span),
                    _ => self.o_skip(at, name, &[end], span),
                }
            }
            // A program that M98 calls begins here; read from above it means nothing.
            OKeyword::Program => Ok(()),
        }
    }

    fn ngc_label(&mut self, page: &Page, label: Label) -> Result<Name, Fault> {
        Ok(match label {
            Label::Number(number) => Name::Number(number),
            Label::Name(name) => Name::Name(name),
            Label::Computed(range) => {
                Name::Number(super::expressions::parameter_number(self.ngc_value(page, range)?)?)
            }
        })
    }

    fn o_value(&mut self, page: &Page, word: &OWord, span: Span) -> Fallible<f64> {
        match page.values(word) {
            [range, ..] => self.ngc_value(page, *range).map_err(|fault| self.alarm(fault, span)),
            [] => Ok(0.0),
        }
    }

    fn o_find(&self, name: Name) -> Option<Known> {
        self.ngc.o_words.known.get(&(self.ngc.o_words.scope(), name)).copied()
    }

    /// Notes the beginning of a loop or condition. Its label is its own within its subprogram.
    fn o_meet(&mut self, name: Name, keyword: OKeyword, place: Place, span: Span) -> Fallible<()> {
        let words = &mut self.ngc.o_words;
        let key = (words.scope(), name);
        match words.known.get(&key) {
            Some(known) if known.place == place => return Ok(()),
            Some(_) => return Err(self.alarm(Fault::LabelRepeated, span)),
            None => {}
        }
        if words.known.len() >= MAX_REMEMBERED {
            return Err(self.alarm(Fault::TooManyLabels, span));
        }
        words.known.insert(key, Known { place, keyword, passes: 0 });
        Ok(())
    }

    /// The loop or condition with a label, which is one of some kinds.
    fn o_known(&self, name: Name, kinds: &[OKeyword], span: Span) -> Fallible<Known> {
        match self.o_find(name) {
            Some(known) if kinds.contains(&known.keyword) => Ok(known),
            _ => Err(self.alarm(Fault::LabelMissing, span)),
        }
    }

    fn o_repeat(&mut self, page: &Page, word: &OWord, name: Name, at: Place, span: Span) -> Fallible<()> {
        let passes = self.o_value(page, word, span)?.round();
        self.o_meet(name, OKeyword::Repeat, at, span)?;
        if !(passes >= 1.0) {
            return self.o_skip_behind(at, name, &[OKeyword::EndRepeat], span);
        }
        let key = (self.ngc.o_words.scope(), name);
        if let Some(known) = self.ngc.o_words.known.get_mut(&key) {
            // Beyond 2⁵³ passes no count is exact, nor ever reached.
            known.passes = passes.min(9e15) as u64;
        }
        Ok(())
    }

    /// A condition does not hold: its next branch, or its end.
    fn o_next_branch(&mut self, name: Name, at: Place, span: Span) -> Fallible<()> {
        self.o_skip(at, name, &[OKeyword::ElseIf, OKeyword::Else, OKeyword::EndIf], span)?;
        self.ngc.o_words.branch = Some(self.flow.next_place());
        Ok(())
    }

    /// Goes on at the next line with this label and one of these words.
    fn o_skip(&mut self, at: Place, name: Name, to: &[OKeyword], span: Span) -> Fallible<()> {
        let target = self.o_lead(at, name, to, span)?;
        self.flow.jump(target);
        Ok(())
    }

    /// Goes on behind it.
    fn o_skip_behind(&mut self, at: Place, name: Name, to: &[OKeyword], span: Span) -> Fallible<()> {
        let target = self.o_lead(at, name, to, span)?;
        self.flow.jump(behind(target));
        Ok(())
    }

    fn o_lead(&mut self, at: Place, name: Name, to: &[OKeyword], span: Span) -> Fallible<Place> {
        if let Some(target) = self.ngc.o_words.leads.get(&at) {
            return Ok(*target);
        }
        let is_sub = to == [OKeyword::EndSub];
        let found = self.o_search(at.file, behind(at), |own, keyword| {
            if is_sub && keyword == OKeyword::Sub {
                return Seen::Fault(Fault::SubprogramNested);
            }
            if own == name && to.contains(&keyword) { Seen::Found } else { Seen::Pass }
        })?;
        // The text ends before: the fault of a program without an end, at its last line.
        let Some(target) = found else {
            let last = self.programs.last_line(at.file).unwrap_or(span);
            return Err(self.alarm(Fault::NoProgramEnd, last));
        };
        if self.ngc.o_words.leads.len() < MAX_REMEMBERED {
            self.ngc.o_words.leads.insert(at, target);
        }
        Ok(target)
    }

    /// Looks through the lines of a file for one with an O word. Lines passed over are read for their comments
    /// alone.
    fn o_search(
        &mut self,
        file: FileId,
        from: Place,
        see: impl Fn(Name, OKeyword) -> Seen,
    ) -> Fallible<Option<Place>> {
        let mut at = from;
        loop {
            let page = match self.programs.page(file, at.page) {
                Ok(Some(page)) => page,
                Ok(None) => break,
                Err(error) => return Err(self.unreadable(error, self.words.block_span())),
            };
            for (index, block) in page.blocks.iter().enumerate().skip(at.block as usize) {
                let span = page.block_span(block);
                if block.is_defective
                    && let Some(defect) =
                        page.defects(index).find(|defect| defect.kind == DefectKind::UnclosedComment)
                {
                    return Err(self.alarm(fault_of(defect.kind), span));
                }
                let Some(word) = page.o_word(block).copied().filter(|_| !self.is_skipped(block)) else {
                    continue;
                };
                let Ok(name) = self.ngc_label(&page, word.label) else { continue };
                match see(name, word.keyword) {
                    Seen::Pass => {}
                    Seen::Found => return Ok(Some(Place { file, page: at.page, block: index as u32 })),
                    Seen::Fault(fault) => return Err(self.alarm(fault, span)),
                }
            }
            at = Place { page: at.page + 1, block: 0, ..at };
        }
        Ok(None)
    }

    /// A subprogram's definition is passed over; coming to one that is known already is a fault.
    fn o_sub(&mut self, name: Name, at: Place, span: Span) -> Fallible<()> {
        if self.ngc.o_words.subprograms.contains_key(&name) {
            return Err(self.alarm(Fault::LabelRepeated, span));
        }
        self.o_define(name, OKeyword::Sub, at, span)?;
        self.o_skip_behind(at, name, &[OKeyword::EndSub], span)
    }

    fn o_define(&mut self, name: Name, keyword: OKeyword, start: Place, span: Span) -> Fallible<Subprogram> {
        let words = &mut self.ngc.o_words;
        if words.subprograms.len() >= MAX_REMEMBERED {
            return Err(self.alarm(Fault::TooManyLabels, span));
        }
        let known = Subprogram { start, scope: words.subprograms.len() as u32 + 1, keyword };
        words.subprograms.insert(name, known);
        Ok(known)
    }

    /// The subprogram with a name: one that was met, one in a file of its name, or one further down.
    fn o_subprogram(&mut self, name: Name, wanted: OKeyword, span: Span) -> Fallible<Subprogram> {
        if let Some(known) = self.ngc.o_words.subprograms.get(&name).copied() {
            if known.keyword == wanted {
                return Ok(known);
            }
            let at = self.o_span(known.start).unwrap_or(span);
            return Err(self.alarm(Fault::CallForm, at));
        }
        let text = match name {
            Name::Number(number) => number.to_string(),
            Name::Name(name) => self.programs.names().text(name).unwrap_or_default().to_owned(),
        };
        let from = match self.programs.file_named(&format!("{text}.ngc")) {
            Some(file) => Place { file, page: 0, block: 0 },
            None => behind(self.flow.executing()),
        };
        let found = self.o_search(from.file, from, |own, keyword| match own == name {
            true if keyword == wanted => Seen::Found,
            // `O… sub` is not for M98, nor a program of M98 for `call`.
            true if matches!(keyword, OKeyword::Sub | OKeyword::Program) => Seen::Fault(Fault::CallForm),
            _ => Seen::Pass,
        })?;
        match found {
            Some(place) => self.o_define(name, wanted, place, span),
            None => {
                let mut alarm = self.alarm(Fault::ProgramMissing, span);
                alarm.arguments.push(("program", format!("O{text}").into()));
                Err(alarm)
            }
        }
    }

    /// Where a block stands in its text.
    fn o_span(&mut self, place: Place) -> Option<Span> {
        let page = self.programs.page(place.file, place.page).ok()??;
        page.blocks.get(place.block as usize).map(|block| page.block_span(block))
    }

    fn o_call(&mut self, page: &Page, word: &OWord, name: Name, span: Span) -> Fallible<()> {
        let mut arguments = std::mem::take(&mut self.ngc.o_words.arguments);
        arguments.clear();
        for range in page.values(word) {
            let value = self.ngc_value(page, *range).map_err(|fault| self.alarm(fault, span))?;
            arguments.push(value);
        }
        let done = self.o_enter(name, OKeyword::Sub, Some(&arguments), 0, span);
        self.ngc.o_words.arguments = arguments;
        done
    }

    fn o_enter(
        &mut self,
        name: Name,
        wanted: OKeyword,
        arguments: Option<&[f64]>,
        repeats: u32,
        span: Span,
    ) -> Fallible<()> {
        let Subprogram { start, scope, .. } = self.o_subprogram(name, wanted, span)?;
        if self.ngc.o_words.calls.len() >= MAX_CALLS {
            return Err(self.alarm(Fault::CallsTooDeep, span));
        }
        let locals = arguments.map(|arguments| {
            let mut kept = [0.0; LOCALS as usize];
            for ((number, slot), place) in (1..=LOCALS).zip(&mut kept).zip(0..) {
                *slot = self.memory.variables.get(number).unwrap_or(0.0);
                // There is room for the first ones.
                let _ = self.memory.variables.set(number, Some(arguments.get(place).copied().unwrap_or(0.0)));
            }
            self.ngc.named.enter();
            kept
        });
        let back = self.flow.next_place();
        self.ngc.o_words.calls.push(Frame { back, start, scope, repeats, locals });
        self.flow.jump(behind(start));
        Ok(())
    }

    /// Back to the caller, with a value where one is given.
    fn o_return(&mut self, page: &Page, word: &OWord, span: Span) -> Fallible<()> {
        let is_call = self.ngc.o_words.calls.last().is_some_and(|frame| frame.locals.is_some());
        if !is_call {
            return Err(self.alarm(Fault::OutsideSubprogram, span));
        }
        let value = match word.count {
            0 => None,
            _ => Some(self.o_value(page, word, span)?),
        };
        self.o_leave();
        self.ngc.returned = value;
        Ok(())
    }

    fn o_leave(&mut self) {
        self.ngc_leave_saved();
        let Some(frame) = self.ngc.o_words.calls.pop() else { return };
        if let Some(locals) = frame.locals {
            for (number, value) in (1..=LOCALS).zip(locals) {
                let _ = self.memory.variables.set(number, Some(value));
            }
            self.ngc.named.leave();
            self.variable_writes += 1;
        }
        self.flow.jump(frame.back);
    }

    /// M98 P L: runs a program with the parameters of its caller.
    pub(super) fn ngc_program_call(&mut self) -> Fallible<()> {
        let span = self.words.block_span();
        let Some(number) = self.words.get(b'P') else {
            return Err(self.alarm(Fault::CallWithoutProgram, span));
        };
        let name = super::expressions::parameter_number(number)
            .map(Name::Number)
            .map_err(|_| self.alarm_at(Fault::WordNotWhole, b'P'))?;
        let times = self.words.get(b'L').unwrap_or(1.0).round();
        if times < 1.0 {
            return Ok(());
        }
        self.o_enter(name, OKeyword::Program, None, (times - 1.0).min(f64::from(u32::MAX)) as u32, span)
    }

    /// M99: back from a program that M98 called, or once more. False where none was.
    pub(super) fn ngc_program_return(&mut self) -> bool {
        match self.ngc.o_words.calls.last_mut() {
            Some(frame) if frame.locals.is_none() => {
                if frame.repeats > 0 {
                    frame.repeats -= 1;
                    let start = frame.start;
                    self.flow.jump(behind(start));
                } else {
                    self.o_leave();
                }
                true
            }
            _ => false,
        }
    }
}

/// The block after one.
fn behind(place: Place) -> Place {
    Place { block: place.block + 1, ..place }
}
