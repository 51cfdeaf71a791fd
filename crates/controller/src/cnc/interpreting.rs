//! The interpreter, which reads blocks in the thread of the servo period, or in one beside it.
//!
//! Most blocks take microseconds; a pocket that is computed, a loop of macro statements or a file that is read may take
//! as long as it likes. Beside, the interpreter is handed over when steps are wanted and fills a ring with them: up to a
//! bound, or to a step that waits for rest. What it does behind that one may depend on the machine, so it goes on once
//! that step was taken. Steps are taken from the ring as they come; the interpreter itself comes back when it is done.
//!
//! While it is away a copy stands in its place, as it was when it went: whoever looks ([`Interpreting`] dereferences to
//! it) waits for nothing. The copy is made there as well, so that a period allocates nothing: as the interpreter comes
//! back, or, where something was changed since, before it goes to read. Both look at it meanwhile, and nobody changes it.
//! Whoever changes something ([`Interpreting::own`]) has it called back, and waits for the end of the few blocks that it is
//! at; in the servo period nothing is changed but at rest, when [`Interpreting::is_here`].
//!
//! In a period on a real clock no more than so many blocks are read, and as many ahead behind it, steps or not: keys, ladder and emergency stop do not
//! wait for a program that reckons. It goes on in the next one, so that the setpoints do not depend on the computer.
//!
//! A program that is sent bit by bit is read in the period: its text comes by the same thread, and is short.

use super::lent::Beside;
use super::{Cnc, State};
use crate::restart::Journal;
use ferrocut_geometry::Position;
use ferrocut_interpreter::{Interpreter, Shown, Turned};
use ferrocut_machine::{Alarm, Severity};
use ferrocut_program::{FileId, Span};
use ferrocut_toolpath::{Op, Step};
use rtrb::{Consumer, Producer, RingBuffer};
use std::ops::Deref;
use std::sync::Arc;
use std::sync::atomic::{AtomicBool, Ordering};
use std::time::{Duration, Instant};

/// Steps that are read ahead of motion's own look-ahead at most.
const STEPS: usize = 64;

/// Blocks read in a period on a real clock, and beside before it is looked whether somebody wants the interpreter: some tenths
/// of a millisecond.
const BLOCKS_AT_ONCE: u64 = 2000;

/// Steps taken in a period where it must be short: a microsecond or some each.
const STEPS_A_PERIOD: usize = 12;

/// Time for more of them once the period is over, as a part of it.
const AHEAD: f64 = 0.3;

/// What the interpreter gave out.
type Next = Option<Result<Step, Box<Alarm>>>;

/// What was in force when a step was given out.
#[derive(Clone, Copy, Debug)]
pub(super) struct Frame {
    /// Machine position of the program's zero, tool length included.
    pub zero: Position,
    /// How its coordinate system is turned.
    pub turn: Turned,
    /// What of it is tool length.
    pub length: Position,
    /// Whether stored stroke check 2 holds (G12).
    pub stroke_check: bool,
    /// Blocks begun, the last of them, and its line in the main program.
    pub begun: u64,
    pub last: Span,
    pub main_line: u32,
    /// What pages show.
    pub shown: Shown,
}

impl Frame {
    /// As a step of block `block` is given out, or as it is now.
    fn of(interpreter: &Interpreter, block: Option<u64>) -> Frame {
        Frame {
            shown: block.map_or_else(|| interpreter.shown(), |block| interpreter.shown_at(block)),
            zero: interpreter.program_zero(),
            turn: interpreter.program_turn(),
            length: interpreter.length_in_force(),
            stroke_check: interpreter.stroke_check(),
            begun: interpreter.blocks_begun(),
            last: interpreter.last_block(),
            main_line: interpreter.main_line(),
        }
    }
}

/// The same with what was in force.
struct Taken {
    next: Next,
    frame: Frame,
}

impl Taken {
    /// What comes of the next `blocks` ([`Interpreter::next_within`]).
    fn within(interpreter: &mut Interpreter, blocks: &mut u64) -> Taken {
        let next = interpreter.next_within(blocks);
        let block = next.as_ref().and_then(|next| next.as_ref().ok()).map(|step| step.block);
        Taken { next, frame: Frame::of(interpreter, block) }
    }
}

/// The interpreter on its way.
struct Work {
    interpreter: Arc<Interpreter>,
    /// A copy as it is when it comes back; on the way there one that nobody needs any more.
    copy: Option<Arc<Interpreter>>,
    /// A journal that nobody needs any more.
    old_journal: Option<Box<Journal>>,
    /// By how much places were renamed as a run begins of which a journal is wanted; and that.
    begins: Option<Position>,
    journal: Option<Box<Journal>>,
    steps: Producer<Taken>,
    /// Steps to take at most; none where only a copy is wanted.
    most: usize,
    /// It stopped for want of room, or since it was called back.
    goes_on: bool,
    called: Arc<AtomicBool>,
}

impl Work {
    fn read(&mut self) {
        // They are freed here and not in the period.
        (self.copy, self.old_journal) = (None, None);
        let begins = self.begins.take();
        self.journal = begins.map(|renamed| Box::new(Journal::begin(&self.interpreter, renamed)));
        if self.most > 0 {
            self.read_steps();
        }
        self.copy = Some(Arc::new(Interpreter::clone(&self.interpreter)));
    }

    fn read_steps(&mut self) {
        // Nobody else has it.
        let Some(interpreter) = Arc::get_mut(&mut self.interpreter) else { return };
        self.goes_on = true;
        let mut left = self.most;
        while left > 0 && !self.called.load(Ordering::Relaxed) && !self.steps.is_full() {
            let mut blocks = BLOCKS_AT_ONCE;
            let taken = Taken::within(interpreter, &mut blocks);
            if taken.next.is_none() && blocks == 0 {
                continue;
            }
            left -= 1;
            self.goes_on = taken.next.as_ref().is_some_and(runs_on);
            let _ = self.steps.push(taken);
            if !self.goes_on {
                break;
            }
        }
    }
}

/// Whether nothing behind it depends on what the machine does with it.
fn runs_on(next: &Result<Step, Box<Alarm>>) -> bool {
    match next {
        Ok(Step { op, .. }) => matches!(
            op,
            Op::Rapid { .. } | Op::Feed { .. } | Op::Arc { .. } | Op::Output { with_next_move: true, .. }
        ),
        Err(alarm) => alarm.severity == Severity::Warning,
    }
}

/// What is needed to read beside.
struct Elsewhere {
    thread: Beside<Work>,
    taken: Consumer<Taken>,
    called: Arc<AtomicBool>,
    /// The other end of the ring; it goes with the interpreter.
    steps: Option<Producer<Taken>>,
    /// A copy of the interpreter as it came back, and one that is to be freed where time is.
    copy: Option<Arc<Interpreter>>,
    old: Option<Arc<Interpreter>>,
    /// Something was changed since it came back: the copy is none any more.
    is_changed: bool,
    /// It stopped at a step that the path runs on over.
    goes_on: bool,
    /// What it has read and reads is not wanted any more.
    is_stale: bool,
    /// A journal is to be begun with the next reading ([`Work::begins`]), was, or is to be freed.
    begins: Option<Position>,
    journal: Option<Box<Journal>>,
    old_journal: Option<Box<Journal>>,
}

/// The interpreter.
pub(super) struct Interpreting {
    /// It, or while it reads elsewhere a copy.
    present: Arc<Interpreter>,
    elsewhere: Option<Elsewhere>,
    /// What was in force with the step taken last, while the interpreter is ahead of it.
    frame: Option<Frame>,
    /// No step has come yet, since the interpreter is not done.
    waits: bool,
    /// Blocks that may be read in a period, and in this one still.
    blocks_a_period: u64,
    blocks_left: u64,
    /// The program has given out all that it had.
    is_over: bool,
    /// Switches, and the block that the machine has come to, which it was not told of yet.
    switches: Option<(bool, bool)>,
    single: Option<bool>,
    stop_line: Option<Option<(FileId, u32)>>,
    /// Auxiliary lock as the switch stands, and as it is in force.
    lock: (Option<bool>, bool),
    passed: Option<u64>,
}

impl Deref for Interpreting {
    type Target = Interpreter;

    fn deref(&self) -> &Interpreter {
        &self.present
    }
}

impl Interpreting {
    pub fn new(interpreter: Interpreter) -> Interpreting {
        Interpreting {
            present: Arc::new(interpreter),
            elsewhere: None,
            frame: None,
            waits: false,
            blocks_a_period: u64::MAX,
            blocks_left: u64::MAX,
            is_over: false,
            switches: None,
            single: None,
            stop_line: None,
            lock: (None, false),
            passed: None,
        }
    }

    /// From now on blocks are read in a thread of their own, which has the priority of this one.
    pub fn read_beside(&mut self) -> std::io::Result<()> {
        if self.elsewhere.is_some() {
            return Ok(());
        }
        let (steps, taken) = RingBuffer::new(STEPS);
        self.elsewhere = Some(Elsewhere {
            thread: Beside::start("interpreter", Work::read)?,
            taken,
            called: Arc::new(AtomicBool::new(false)),
            steps: Some(steps),
            copy: None,
            old: None,
            is_changed: true,
            goes_on: false,
            is_stale: false,
            begins: None,
            journal: None,
            old_journal: None,
        });
        Ok(())
    }

    /// From now on no period reads more than a few blocks.
    pub fn read_in_short(&mut self) {
        self.blocks_a_period = BLOCKS_AT_ONCE;
    }

    /// Whether it reads on in the next period.
    pub fn is_paused(&self) -> bool {
        self.waits && self.blocks_left == 0
    }

    /// A run begins with the next block that is read: a journal of it is begun where blocks are read, before that. Here
    /// and now where they are read in the period.
    pub fn begin_journal(&mut self, renamed: Position) -> Option<Box<Journal>> {
        match &mut self.elsewhere {
            Some(elsewhere) => {
                elsewhere.begins = Some(renamed);
                None
            }
            None => Some(Box::new(Journal::begin(&self.present, renamed))),
        }
    }

    /// The journal that was begun, once it is here.
    pub fn take_journal(&mut self) -> Option<Box<Journal>> {
        self.elsewhere.as_mut()?.journal.take()
    }

    /// The same where it is needed now: begun here, if no block was read since it was asked for.
    pub fn await_journal(&mut self) -> Option<Box<Journal>> {
        if !self.is_here() {
            self.call_back();
            self.wait();
        }
        let elsewhere = self.elsewhere.as_mut()?;
        let begins = elsewhere.begins.take();
        let begun = begins.map(|renamed| Box::new(Journal::begin(&self.present, renamed)));
        elsewhere.journal.take().or(begun)
    }

    /// A journal is not needed any more: it is freed where time is, and none is begun.
    pub fn forget_journal(&mut self, journal: Option<Box<Journal>>) {
        if let Some(elsewhere) = &mut self.elsewhere {
            elsewhere.begins = None;
            elsewhere.old_journal = journal.or(elsewhere.old_journal.take());
        }
    }

    /// Whether it is here: then it may be changed without waiting for it. Where it was lost on its way the copy is all
    /// that is left, to be reset; no step comes of it.
    pub fn is_here(&self) -> bool {
        let is_lost = |elsewhere: &Elsewhere| elsewhere.is_stale && elsewhere.thread.is_gone();
        self.elsewhere.as_ref().is_none_or(|elsewhere| elsewhere.steps.is_some() || is_lost(elsewhere))
    }

    /// Whether the next step has not come yet.
    pub fn waits(&self) -> bool {
        self.waits
    }

    /// Takes it back, if it is done: at the beginning of each period.
    pub fn fetch(&mut self) {
        self.blocks_left = self.blocks_a_period;
        let Some(elsewhere) = &mut self.elsewhere else { return };
        let Some(work) = elsewhere.thread.fetch() else { return };
        if !Arc::ptr_eq(&self.present, &work.interpreter) {
            elsewhere.old = Some(std::mem::replace(&mut self.present, work.interpreter));
        }
        elsewhere.copy = work.copy;
        if work.journal.is_some() {
            elsewhere.journal = work.journal;
        }
        elsewhere.steps = Some(work.steps);
        elsewhere.goes_on = work.goes_on;
        elsewhere.is_changed = false;
        if std::mem::take(&mut elsewhere.is_stale) {
            elsewhere.goes_on = false;
            while elsewhere.taken.pop().is_ok() {}
        }
        self.tell();
    }

    /// Has it come back with the end of the block that it is at.
    pub fn call_back(&self) {
        if let Some(elsewhere) = &self.elsewhere {
            elsewhere.called.store(true, Ordering::Relaxed);
        }
    }

    /// Waits until it is back.
    pub fn wait(&mut self) {
        while !self.is_here() && self.elsewhere.as_ref().is_some_and(|elsewhere| !elsewhere.thread.is_gone())
        {
            std::thread::yield_now();
            self.fetch();
        }
    }

    /// The interpreter, to be changed. It is waited for where it is away.
    pub fn own(&mut self) -> &mut Interpreter {
        if !self.is_here() {
            self.call_back();
            self.wait();
        }
        if let Some(elsewhere) = &mut self.elsewhere {
            // What it reads next is asked for.
            (elsewhere.is_changed, elsewhere.goes_on) = (true, false);
        }
        (self.frame, self.is_over) = (None, false);
        self.change()
    }

    /// The interpreter, which nobody else has while it is here.
    fn change(&mut self) -> &mut Interpreter {
        Arc::make_mut(&mut self.present)
    }

    /// How the operator's switches stand, for the blocks that are read from now on.
    pub fn set_switches(&mut self, block_skip: bool, optional_stop: bool) {
        self.switches = Some((block_skip, optional_stop));
        self.tell();
    }

    /// Whether blocks that are read from now on are run one by one.
    pub fn set_single_block(&mut self, single: bool) {
        self.single = Some(single);
        self.tell();
    }

    /// The line behind which the run stops, for the blocks that are read from now on.
    pub fn set_stop_line(&mut self, line: Option<(FileId, u32)>) {
        self.stop_line = Some(line);
        self.tell();
    }

    /// Auxiliary lock as the switch stands, for the blocks that are read from now on. A tool change that is under way is
    /// finished as it was begun.
    pub fn set_auxiliary_lock(&mut self, locked: bool) {
        self.lock.0 = Some(locked);
        self.tell();
    }

    /// Whether auxiliary lock is in force.
    pub fn is_auxiliary_locked(&self) -> bool {
        self.lock.1
    }

    /// The machine is at this block: what is kept of those before it is not needed.
    pub fn forget_before(&mut self, block: u64) {
        self.passed = Some(block);
        self.tell();
    }

    /// Tells it what it is to know, if it is here. A copy of it needs none of that.
    fn tell(&mut self) {
        if !self.is_here() {
            return;
        }
        if let Some((block_skip, optional_stop)) = self.switches.take() {
            self.change().set_switches(block_skip, optional_stop);
        }
        if let Some(single) = self.single.take() {
            self.change().set_single_block(single);
        }
        if let Some(line) = self.stop_line.take() {
            self.change().set_stop_line(line);
        }
        if let Some(locked) = self.lock.0.filter(|_| !self.present.changes_tool()) {
            self.lock.1 = locked;
            self.change().set_auxiliary_lock(locked);
        }
        if let Some(block) = self.passed.take() {
            self.change().forget_before(block);
        }
    }

    /// What was in force with the step taken last.
    pub fn frame(&self) -> Frame {
        self.frame.unwrap_or_else(|| Frame::of(&self.present, None))
    }

    /// What was in force with a step that was just taken.
    pub fn frame_of(&self, step: &Step) -> Frame {
        self.frame.unwrap_or_else(|| Frame::of(&self.present, Some(step.block)))
    }

    /// The program is given up or begins anew: what was read is not wanted.
    pub fn forget(&mut self) {
        let is_away = !self.is_here();
        self.call_back();
        (self.frame, self.is_over) = (None, false);
        if let Some(elsewhere) = &mut self.elsewhere {
            elsewhere.goes_on = false;
            elsewhere.is_stale = is_away;
            while elsewhere.taken.pop().is_ok() {}
        }
    }

    /// The next step, if there is one now ([`waits`](Self::waits)). With `single` none is read ahead of it.
    pub fn next(&mut self, single: bool) -> Next {
        self.waits = false;
        let is_here = self.is_here();
        let Some(elsewhere) = &mut self.elsewhere else { return self.read() };
        if !elsewhere.is_stale
            && let Ok(taken) = elsewhere.taken.pop()
        {
            self.frame = Some(taken.frame);
            self.is_over = taken.next.is_none();
            return taken.next;
        }
        if is_here && self.present.is_open() {
            self.own();
            return self.read();
        }
        if !self.is_over {
            self.lend(single);
            self.waits = true;
        }
        None
    }

    /// Reads it in this period.
    fn read(&mut self) -> Next {
        let mut blocks = self.blocks_left;
        let next = self.change().next_within(&mut blocks);
        self.waits = next.is_none() && blocks == 0;
        self.blocks_left = blocks;
        next
    }

    /// Has more steps read where there is room, before they are wanted.
    pub fn look_ahead(&mut self, single: bool) {
        let wants = |elsewhere: &Elsewhere| elsewhere.goes_on && elsewhere.taken.slots() < STEPS / 2;
        if !single && self.elsewhere.as_ref().is_some_and(wants) {
            self.lend(single);
        }
    }

    fn lend(&mut self, single: bool) {
        let Some(elsewhere) = &mut self.elsewhere else { return };
        let Some(steps) = elsewhere.steps.take() else { return };
        elsewhere.called.store(false, Ordering::Relaxed);
        let copy = if elsewhere.is_changed { None } else { elsewhere.copy.take() };
        let (interpreter, old, most) = match copy {
            Some(copy) => {
                let most = if single { 1 } else { STEPS };
                (std::mem::replace(&mut self.present, copy), elsewhere.old.take(), most)
            }
            None => (self.present.clone(), elsewhere.copy.take(), 0),
        };
        let called = elsewhere.called.clone();
        let (begins, old_journal) = (elsewhere.begins.take(), elsewhere.old_journal.take());
        let work = Work {
            interpreter,
            copy: old,
            old_journal,
            begins,
            journal: None,
            steps,
            most,
            goes_on: false,
            called,
        };
        // There is room: it is the only one.
        if let Err(work) = elsewhere.thread.lend(work) {
            (self.present, elsewhere.steps) = (work.interpreter, Some(work.steps));
        }
    }
}

impl Cnc {
    /// The interpreter, for its program's text. While it reads blocks beside, a copy as it was when it began to.
    pub fn interpreter(&self) -> &Interpreter {
        &self.interpreter
    }

    /// The interpreter, to change what it remembers. Where it reads blocks beside, the end of the block that it is at is
    /// waited for ([`is_reading`](Self::is_reading)).
    pub fn interpreter_mut(&mut self) -> &mut Interpreter {
        self.interpreter.own()
    }

    /// Whether the interpreter is reading blocks beside, so that whoever wants to change something had better wait.
    pub fn is_reading(&self) -> bool {
        !self.interpreter.is_here()
    }

    /// How the operator's switches stand, for the blocks that are read from now on.
    pub fn set_block_skip(&mut self, block_skip: bool, optional_stop: bool) {
        self.interpreter.set_switches(block_skip, optional_stop);
    }

    /// What of the next period may take longer than a period: interpreting, and planning. Called as soon as a period is
    /// over, it leaves to [`tick`](Self::tick) what runs in the period; without it `tick` does all, with the same
    /// setpoints.
    pub fn prepare(&mut self) {
        self.fetch();
        self.steps_left = usize::MAX;
        if self.state != State::Running {
            return;
        }
        let is_short = self.steps_a_period != usize::MAX;
        self.ahead_until = is_short.then(|| Instant::now() + Duration::from_secs_f64(AHEAD * self.period));
        self.take_steps();
        self.ahead_until = None;
        let moves = self.state == State::Running && self.busy.is_none() && self.stroke.is_none();
        if moves && !self.motion.is_empty() && !self.must_settle_now() {
            self.motion.plan();
        }
    }

    /// Called by whoever is about to run periods on a real clock, in the thread that will: no period reads more than a few
    /// blocks from now on. Do the drives need a setpoint
    /// each period, whatever else the computer does ([`keeps_time`](crate::drives::Drives::keeps_time)), what takes long
    /// is done beside from now on ([`work_beside`](Self::work_beside)).
    ///
    /// # Errors
    /// The system gives no thread; then all is done in the period as before.
    pub fn keep_time(&mut self) -> std::io::Result<()> {
        self.interpreter.read_in_short();
        if self.drives.keeps_time() { self.work_beside() } else { Ok(()) }
    }

    /// From now on motion is planned and blocks are read in threads of their own, which get the priority of the one that
    /// calls this, and no period takes more than a few steps: for a clock at true speed, whose periods are short. The
    /// setpoints are the same as long as those threads are in time, save that a queue that is empty fills in some
    /// periods, and that a step which waits for rest is followed a period or two later.
    ///
    /// # Errors
    /// The system gives no thread; then all is done in the period as before.
    pub fn work_beside(&mut self) -> std::io::Result<()> {
        self.interpreter.read_in_short();
        self.motion.plan_beside()?;
        self.interpreter.read_beside()?;
        self.steps_a_period = STEPS_A_PERIOD;
        Ok(())
    }

    /// Whether it is so.
    pub fn works_beside(&self) -> bool {
        self.interpreter.elsewhere.is_some()
    }

    /// Takes back what is done beside.
    pub(super) fn fetch(&mut self) {
        self.motion.fetch();
        self.interpreter.fetch();
        self.take_up_journal();
        if self.state == State::Running {
            self.interpreter.look_ahead(self.blocks.is_single());
        }
    }

    /// Waits until what is due beside is done, for a clock that does not wait itself.
    pub fn await_beside(&mut self) {
        self.motion.await_planner();
        self.interpreter.wait();
    }
}
