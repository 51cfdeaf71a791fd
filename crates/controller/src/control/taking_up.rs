//! Program restart at the control (GSK990MC part 2, 10.1.9): the run that was broken off is remembered, also over
//! power-off; a restart is searched beside the machine, and carried out by cycle start in AUTO.

use super::{Control, Loaded, alarm, library};
use crate::api::{AlarmInfo, Event, InterruptedBlock, Reply, RestartDifference, RestartMove, RestartPlan};
use crate::cnc::State;
use crate::restart::told::{Compared, axis_moves, function};
use crate::restart::{At, How, Journal, Origin, Present, Restart};
use crate::signals::Mode;
use ferrocut_geometry::Axis;
use ferrocut_interpreter::Fallible;
use ferrocut_machine::{Alarm, Fault, Memory};
use ferrocut_memory::{InterruptedRun, items};
use ferrocut_program::FileId;
use std::sync::Arc;
use std::sync::atomic::{AtomicBool, Ordering};
use std::sync::mpsc::{Receiver, TryRecvError, sync_channel};
use std::thread;

/// Longest text of a block by which it is known again, characters.
const LONGEST_TEXT: usize = 200;

/// What is known of runs that can be taken up again.
#[derive(Default)]
pub(super) struct TakingUp {
    /// The run that was broken off.
    broken: Option<Broken>,
    search: Option<Search>,
    ready: Option<Box<Ready>>,
    /// The line from which the program of AUTO was started.
    pub from_line: u32,
}

struct Broken {
    at: InterruptedRun,
    /// What is kept of the run since power-on.
    journal: Option<Journal>,
}

/// What is asked for.
#[derive(Clone)]
struct Asked {
    program: String,
    from_line: u32,
    how: How,
    /// The block that it must be: by its line and text.
    expected: Option<(u32, String)>,
    /// The memory from which it was searched.
    memory: Memory,
}

/// A search that is under way in a thread of its own.
struct Search {
    asked: Asked,
    stop: Arc<AtomicBool>,
    found: Receiver<Fallible<Restart>>,
}

impl Drop for Search {
    fn drop(&mut self) {
        self.stop.store(true, Ordering::Relaxed);
    }
}

/// A restart that waits for cycle start.
struct Ready {
    asked: Asked,
    restart: Restart,
}

impl TakingUp {
    /// What was kept over power-off.
    pub fn of(kept: Option<InterruptedRun>) -> TakingUp {
        TakingUp { broken: kept.map(|at| Broken { at, journal: None }), from_line: 1, ..TakingUp::default() }
    }

    /// Whether cycle start carries out a restart.
    pub fn is_ready(&self) -> bool {
        self.ready.is_some()
    }

    /// The run that was broken off.
    pub fn interrupted(&self) -> Option<InterruptedBlock> {
        self.broken.as_ref().map(|Broken { at, journal }| InterruptedBlock {
            program: at.program.clone(),
            file: at.file.clone(),
            line: at.line,
            text: at.text.clone(),
            time: at.time,
            kept: journal.is_some(),
        })
    }

    /// A program was stored or deleted: what was kept of its text is no longer so.
    pub fn program_changed(&mut self) {
        if let Some(broken) = &mut self.broken {
            broken.journal = None;
        }
        (self.search, self.ready) = (None, None);
    }
}

/// What a restart asks for besides its place.
pub(super) struct Wanted {
    pub line: Option<u32>,
    pub pass: u32,
    pub file: Option<String>,
    pub how: How,
}

impl Control {
    /// The place of the run of AUTO that is under way or was just broken off.
    pub(super) fn place_of_run(&self) -> Option<InterruptedRun> {
        let Loaded::Auto(program) = &self.loaded else { return None };
        let (block, span) = self.cnc.block_run();
        let programs = self.cnc.interpreter().programs();
        (span.line > 0).then(|| InterruptedRun {
            time: items::now(),
            program: program.clone(),
            from_line: self.taking_up.from_line,
            file: programs.file_name(span.file).to_owned(),
            line: span.line,
            block,
            text: text_of(&programs.slice(span)),
            at: Some(self.cnc.broken_at().unwrap_or(self.tick.position)),
        })
    }

    /// Whether a run of AUTO is such that it is remembered where it is.
    pub(super) fn runs_remembered(&self) -> bool {
        let runs = self.cnc.is_under_way() || matches!(self.cnc.state(), State::Alarmed(_));
        runs && matches!(self.loaded, Loaded::Auto(_))
    }

    /// The NC came to another state: a run is over, or was broken off.
    pub(super) fn follow_run(&mut self, state: &State) {
        if !matches!(self.loaded, Loaded::Auto(_)) {
            return;
        }
        match state {
            State::Ended => self.forget_interrupted(),
            State::Reset => {
                let is_broken = |journal: &Journal| journal.interrupted().is_some();
                if !self.cnc.journal().is_some_and(is_broken) {
                    return;
                }
                let (Some(at), journal) = (self.place_of_run(), self.cnc.take_journal()) else { return };
                self.event(Event::Interrupted { program: at.program.clone(), line: at.line });
                self.keep_interrupted(Some(at.clone()));
                self.taking_up.broken = Some(Broken { at, journal });
            }
            _ => {}
        }
    }

    /// A program of AUTO begins, or came to its end: nothing of an older one is taken up.
    pub(super) fn forget_interrupted(&mut self) {
        self.forget_restart();
        if self.taking_up.broken.take().is_some() || matches!(self.cnc.state(), State::Ended) {
            self.keep_interrupted(None);
        }
    }

    /// What was prepared is forgotten, as by reset (10.1.9 note 3). The run that was broken off is not.
    pub(super) fn forget_restart(&mut self) {
        self.taking_up.search = None;
        if let Some(ready) = self.taking_up.ready.take() {
            self.event(Event::Restart { ready: false, line: ready.restart.span.line });
        }
    }

    /// Neither a restart nor a measuring that was prepared waits for cycle start any more.
    pub(super) fn forget_prepared(&mut self) {
        self.forget_restart();
        self.cancel_measure();
    }

    /// The key of program restart (10.1.9, 2): turned on in AUTO it prepares the block that was interrupted, unless
    /// somebody prepared another one (note 2). Turned off again it leaves what is prepared to cycle start (10.1.9, 5;
    /// Fanuc 0i, SRN); after reset it is to be turned on anew (note 3).
    pub(super) fn take_restart_key(&mut self) {
        let is_turned_on = self.inputs.restart && !self.before.restart && self.mode == Mode::Auto;
        if !is_turned_on || self.taking_up.is_ready() || self.taking_up.search.is_some() {
            return;
        }
        let how = How { sends: false, axis_by_axis: false };
        if let Err(why) = self.prepare_restart(Wanted { line: None, pass: 1, file: None, how }) {
            self.refuse(&why);
        }
    }

    /// Begins to search a place.
    pub(super) fn prepare_restart(&mut self, wanted: Wanted) -> Result<Reply, Box<Alarm>> {
        if self.cnc.is_under_way() || !self.cnc.is_idle() || self.tick.moving {
            return Err(Box::new(alarm(Fault::RestartMoving)));
        }
        if self.mode != Mode::Auto {
            return Err(Box::new(alarm(Fault::ControlMode).with("mode", super::name_of(self.mode))));
        }
        self.forget_prepared();
        let Wanted { line, pass, file, how } = wanted;
        let broken = self.taking_up.broken.as_ref();
        let (program, from_line, expected) = match line {
            None => {
                let at = &broken.ok_or_else(|| alarm(Fault::RestartNothing))?.at;
                if self.selected.as_ref().is_some_and(|selected| *selected != at.program) {
                    let alarm = self.own_alarm(Fault::RestartOtherProgram);
                    return Err(Box::new(alarm.with("name", at.program.as_str())));
                }
                (at.program.clone(), at.from_line, Some((at.block, at.line, at.text.clone())))
            }
            Some(_) => (self.selected.clone().ok_or_else(|| alarm(Fault::NothingToRun))?, 1, None),
        };
        // 10.1.9 note 4.
        self.must_be_homed(Fault::RestartNotReferenced)?;
        let kept = broken.filter(|broken| broken.at.program == program && broken.at.from_line == from_line);
        let mut journal = match kept.and_then(|broken| broken.journal.clone()) {
            Some(journal) => journal,
            None => {
                // Where the axes stood when the power failed says which hole of a cycle it was.
                let stood = broken.filter(|_| line.is_none()).and_then(|broken| broken.at.at);
                self.journal_of_present(&program, from_line)?.broken_at(stood)
            }
        };
        let at = match (line, &expected) {
            (Some(line), _) => {
                let file = match &file {
                    None => FileId(0),
                    Some(name) => journal
                        .file_of(&library::id_of(name))
                        .ok_or_else(|| alarm(Fault::NoSuchName).with("name", name.as_str()))?,
                };
                At::Line { file, line, pass: pass.into() }
            }
            (None, _) if journal.interrupted().is_some() => At::Interrupted,
            (None, Some((block, ..))) => At::Number(*block),
            (None, None) => At::Interrupted,
        };
        self.selected = Some(program.clone());
        let memory = self.cnc.interpreter().memory().clone();
        let expected = expected.map(|(_, line, text)| (line, text));
        let asked = Asked { program, from_line, how, expected, memory: memory.clone() };
        let stop = Arc::new(AtomicBool::new(false));
        let (give, found) = sync_channel(1);
        let stops = stop.clone();
        let search = move || {
            // Nobody may be there to hear it any more.
            let _ = give.send(journal.find_unless(at, &memory, &stops));
        };
        let begun = thread::Builder::new().name("restart".to_owned()).spawn(search);
        begun.map_err(|error| alarm(Fault::ConfigUnusable).with("reason", error.to_string()))?;
        self.taking_up.search = Some(Search { asked, stop, found });
        Ok(Reply::OnItsWay)
    }

    /// A program that was not run since power-on is searched from the present state.
    fn journal_of_present(&mut self, program: &str, from_line: u32) -> Result<Journal, Box<Alarm>> {
        self.load_auto(program)?;
        self.begin_at((from_line > 1).then_some(from_line))?;
        self.cnc.finds_spindle();
        Ok(Journal::of_present(self.cnc.interpreter(), self.cnc.renamed()))
    }

    /// Every linear axis has found its reference point.
    pub(super) fn must_be_homed(&self, fault: Fault) -> Result<(), Box<Alarm>> {
        let referenced = self.cnc.referenced();
        let axes = self.machine.axes.iter().map(|axis| axis.name);
        match axes.filter(|axis| is_linear(*axis)).find(|axis| !referenced.contains(*axis)) {
            None => Ok(()),
            Some(axis) => {
                let alarm = self.own_alarm(fault);
                Err(Box::new(alarm.with("axis", axis.letter().to_string())))
            }
        }
    }

    /// Once a period: whether a search has come to its end.
    pub(super) fn follow_search(&mut self) {
        let Some(search) = &self.taking_up.search else { return };
        let found = match search.found.try_recv() {
            Err(TryRecvError::Empty) => return,
            Err(TryRecvError::Disconnected) => Err(Box::new(alarm(Fault::RestartNothing))),
            Ok(found) => found,
        };
        let asked = search.asked.clone();
        self.taking_up.search = None;
        if let Err(why) = found.and_then(|restart| self.take_found(asked, restart)) {
            self.refuse(&why);
        }
    }

    fn take_found(&mut self, asked: Asked, restart: Restart) -> Fallible<()> {
        let text = text_of(&restart.interpreter().programs().slice(restart.span));
        let is_other = |(line, block): &(u32, String)| *line != restart.span.line || *block != text;
        if asked.expected.as_ref().is_some_and(is_other) {
            return Err(Box::new(alarm(Fault::RestartChanged).with("name", asked.program)));
        }
        // A way that cannot be gone is told before somebody relies on it.
        restart.lead_in(&self.cnc.present(), &self.machine, asked.how)?;
        let line = restart.span.line;
        self.cursor = if restart.span.file == FileId(0) { line } else { self.cursor };
        self.taking_up.ready = Some(Box::new(Ready { asked, restart }));
        self.event(Event::Restart { ready: true, line });
        Ok(())
    }

    /// What can be taken up, and what cycle start would do.
    pub(super) fn restarts(&self) -> Result<Reply, Box<Alarm>> {
        let ready = self.taking_up.ready.as_ref().map(|ready| self.plan_of(ready)).transpose()?;
        Ok(Reply::Restarts {
            interrupted: self.taking_up.interrupted(),
            searching: self.taking_up.search.is_some(),
            ready: ready.map(Box::new),
        })
    }

    fn plan_of(&self, ready: &Ready) -> Fallible<RestartPlan> {
        let Ready { asked, restart } = ready;
        let present = self.cnc.present();
        let programs = restart.interpreter().programs();
        let functions = restart.functions(&present.state);
        let difference = |difference: &crate::restart::Difference| RestartDifference {
            of: difference.of.name(),
            program: difference.program.text(),
            machine: difference.machine.text(),
        };
        let from = restart.renamed(&present);
        let approach = axis_moves(restart.approach(from, &self.machine)?.iter(), from);
        Ok(RestartPlan {
            program: asked.program.clone(),
            file: programs.file_name(restart.span.file).to_owned(),
            line: restart.span.line,
            pass: restart.pass,
            text: text_of(&programs.slice(restart.span)),
            hole: restart.hole,
            origin: match restart.origin() {
                Origin::Kept => "kept",
                Origin::Present => "present",
            }
            .to_owned(),
            position: self.by_axis(restart.position),
            differences: restart.differences(&present.state).iter().map(difference).collect(),
            functions: functions.iter().filter_map(|op| function(op, &restart.position)).collect(),
            sends: asked.how.sends,
            approach: approach
                .iter()
                .map(|way| RestartMove {
                    axis: way.axis.letter(),
                    to: way.to,
                    rapid: way.is_rapid,
                    speed: way.speed,
                })
                .collect(),
            axis_by_axis: asked.how.axis_by_axis || self.inputs.single_block,
            missing: missing(ready, &present),
            changes: u32::try_from(restart.changes(&asked.memory).len()).unwrap_or(u32::MAX),
            warning: restart.warning().as_ref().map(AlarmInfo::of),
        })
    }

    /// Cycle start with a restart prepared: functions, the axes one after the other, then the program.
    pub(super) fn start_restart(&mut self) -> Result<(), Box<Alarm>> {
        let Some(ready) = &self.taking_up.ready else { return Ok(()) };
        let Ready { asked, restart } = &**ready;
        self.must_be_homed(Fault::RestartNotReferenced)?;
        if self.selected.as_ref() != Some(&asked.program)
            || !asked.memory.changes_to(self.cnc.interpreter().memory()).is_empty()
        {
            return Err(Box::new(alarm(Fault::RestartChanged).with("name", asked.program.as_str())));
        }
        let present = self.cnc.present();
        let missing = missing(ready, &present);
        if !missing.is_empty() {
            return Err(Box::new(alarm(Fault::RestartNotAsProgram).with("name", missing.join(", "))));
        }
        // Explanation 2: with single block each axis waits.
        let how = How { axis_by_axis: asked.how.axis_by_axis || self.inputs.single_block, ..asked.how };
        let lead_in = restart.lead_in(&present, &self.machine, how)?;
        let (program, from_line) = (asked.program.clone(), asked.from_line);
        self.cnc.restart(restart.clone(), lead_in)?;
        self.taking_up.ready = None;
        self.taking_up.from_line = from_line;
        self.taking_up.broken = None;
        self.loaded = Loaded::Auto(program);
        // Parts were counted since the run began.
        self.show_counts();
        // What the search wrote is looked at by the durable memory.
        self.keep_all_of_program();
        Ok(())
    }
}

/// Tool and spindle that are not as the program has them, and that the control does not send.
fn missing(ready: &Ready, present: &Present) -> Vec<String> {
    if ready.asked.how.sends {
        return Vec::new();
    }
    let differences = ready.restart.differences(&present.state).into_iter();
    let cuts =
        differences.filter(|difference| matches!(difference.of, Compared::Spindle | Compared::InSpindle));
    let shown = |difference: crate::restart::Difference| {
        let text = difference.program.text().unwrap_or_default();
        match difference.of {
            Compared::InSpindle => format!("T{text} M06"),
            _ => text,
        }
    };
    cuts.map(shown).collect()
}

/// Axes along which a tool can be run into something.
fn is_linear(axis: Axis) -> bool {
    matches!(axis, Axis::X | Axis::Y | Axis::Z | Axis::U | Axis::V | Axis::W)
}

/// The text of a block, cut where it is long.
fn text_of(text: &str) -> String {
    text.trim().chars().take(LONGEST_TEXT).collect()
}
