//! The control: takes steps as far ahead as motion looks, and each servo period moves the axes or
//! does what a step asks beside.
//!
//! A move goes to motion as soon as there is room. Any other step (dwell, spindle, tool change, stop)
//! waits until motion is at rest on the end of the move before it; nothing is taken beyond it until
//! then, so that the step acts on a machine in the state that the program means. An alarm waits in
//! the same way: the moves before it are finished, the one at fault does not begin. An output in step
//! with motion alone does not wait, nor does a message: they are kept for the move behind them (`program_outputs`,
//! `messages`).

mod awaited_input;
mod block_end;
mod drive_failure;
mod giving;
mod interpreting;
mod interruption;
mod ladder;
mod lent;
mod loading;
mod messages;
mod overtravel;
mod planning;
mod program_outputs;
mod program_spindle;
mod reference;
mod retracing;
mod sent;
mod skip;
mod switches;
mod taking_up;
mod tapping;
mod touching;

pub use interruption::Interruption;
pub use switches::DryRun;

use crate::auxiliary::Auxiliary;
use crate::capture::Chain;
use crate::drives::{self, Drives, Simulated};
use crate::homing::Homing;
use crate::manual::{JogSpeed, JogWay, Manual};
use crate::programmed::Programmed;
use crate::report::{Activity, Report};
use crate::spindle::Spindle;
use crate::supervision::Supervisor;
use awaited_input::AwaitedInput;
use block_end::{Block, Blocks};
use ferrocut_geometry::{Axis, AxisSet, Position};
use ferrocut_interpreter::{AtRest, Interpreter, Shown};
use ferrocut_machine::config::SpindleConfig;
use ferrocut_machine::{Alarm, Fault, Machine, Ramp};
use ferrocut_motion::servo::{Kind, Servo, ServoFault, ServoFaultKind};
use ferrocut_motion::synchron::Synchron;
use ferrocut_motion::{Move, Sample};
use ferrocut_program::Span;
use ferrocut_toolpath::{Dwell, Op, SpindleState, Step};
use interpreting::{Frame, Interpreting};
use interruption::Aside;
use messages::Messages;
use overtravel::Overtravel;
use planning::Planning;
use program_outputs::ProgramOutputs;
use program_spindle::ProgramSpindle;
use retracing::Retrace;
use sent::Sent;
use skip::Probing;
use std::collections::VecDeque;
use std::sync::Arc;
use std::time::Instant;
use switches::Switches;
use tapping::{Asked, InThread, Stroke};

/// Events for which there is room from the start, as they come in the servo period and are fetched behind it.
const EVENTS: usize = 256;

/// Moves that the control keeps for each that motion has room for: where short ones follow each other in a line, motion
/// leaves most of them out, and has room for more.
const MOVES_A_PLACE: usize = 8;

/// What the control is doing.
#[derive(Clone, PartialEq, Debug)]
pub enum State {
    /// A program is loaded and waits for cycle start.
    Ready,
    /// The program runs.
    Running,
    /// Feed hold: at rest or coming to rest, goes on with cycle start.
    Held,
    /// Stopped by M00 or M01; goes on with cycle start.
    Stopped(u32),
    /// Stopped at the end of a block, by single block or since that was asked for; goes on with cycle start.
    BlockEnd,
    /// Reset: comes to rest, the rest of the program is forgotten.
    Resetting,
    /// Reset is done.
    Reset,
    /// Stopped by an alarm.
    Alarmed(Box<Alarm>),
    /// The program has ended.
    Ended,
}

/// What happened beside motion.
#[derive(Clone, PartialEq, Debug)]
pub enum Event {
    /// Something worth knowing that does not stop the program. It comes in the servo period, which allocates nothing.
    Warning(Alarm),
    /// Text of the program for the operator.
    Message(Box<str>),
    /// A tool was put into the spindle.
    ToolChange(u32),
}

/// The machine at the end of a servo period.
#[derive(Clone, Copy, PartialEq, Debug)]
pub struct Tick {
    /// Commanded position of every axis, mm and degrees: after acceleration after interpolation, without what
    /// compensates backlash and pitch errors.
    pub position: Position,
    /// Where the axes are, by the same measure.
    pub actual: Position,
    /// Speed along the path, mm/s.
    pub velocity: f64,
    /// The block being run.
    pub span: Span,
    /// Whether motion was under way in this period.
    pub moving: bool,
}

/// A move given to motion.
#[derive(Clone, Copy, Debug)]
struct Given {
    tag: u64,
    /// The number of its block.
    number: u64,
    span: Span,
    activity: Activity,
    length: f64,
    min: Position,
    max: Position,
    to: Position,
    /// Its end is reached exactly before the next move begins: positioning, G09, G61.
    stops: bool,
    programmed: Programmed,
    /// The block it belongs to.
    block: Block,
    /// As motion was given it, dry run aside.
    motion: Move,
    /// Its length along the path and how much of that was run, mm or degrees.
    path_length: f64,
    travelled: f64,
    /// What was in force when it was given out.
    frame: Frame,
    /// The share of it that motion is to be given, where a part was run before it was taken back.
    left: f64,
    /// How far beside it the axes stood then, mm.
    beside: f64,
}

impl Given {
    fn kind(&self) -> Kind {
        if self.activity == Activity::Rapid { Kind::Rapid } else { Kind::Cutting }
    }
}

/// What waits for motion to come to rest.
#[derive(Debug)]
enum Waiting {
    Step(Step),
    /// The end of a skip move.
    Skip,
    Alarm(Box<Alarm>),
}

/// What the control is busy with while the axes stand still.
#[derive(Clone, Copy, Debug)]
struct Busy {
    activity: Activity,
    periods: u64,
    /// It ends as soon as this input comes.
    until: Option<AwaitedInput>,
}

/// A control with its machine.
pub struct Cnc {
    interpreter: Interpreting,
    supervisor: Supervisor,
    motion: Planning,
    /// Steps taken from the interpreter in a period at most.
    steps_a_period: usize,
    /// How many are left in this one.
    steps_left: usize,
    /// When to look ahead no further, where that matters.
    ahead_until: Option<Instant>,
    servo: Servo,
    synchron: Synchron,
    /// Speed of the spindle that motion was told, r/min.
    told_rpm: f64,
    /// The one that feeds of moves are given for, r/min.
    given_rpm: f64,
    manual: Manual,
    homing: Homing,
    /// The axes of the machine.
    machine_axes: AxisSet,
    /// Their software limits.
    travel: (Position, Position),
    /// Slowest and fastest cutting that motion holds, mm/min.
    feeds: [f64; 2],
    /// What the ladder says of the switches.
    wired: Option<drives::Switches>,
    overtravel: Overtravel,
    probing: Option<Probing>,
    /// By how much the skip moves of this block ended beside what is programmed.
    skip_shift: Position,
    thread: Option<InThread>,
    stroke: Option<Stroke>,
    /// The spindle with its gears.
    spindle_config: SpindleConfig,
    /// How long after its command the spindle may come to rest, s.
    patience: f64,
    /// What the axes moved for last.
    kind: Kind,
    exact_stop: bool,
    drives: Box<dyn Drives>,
    spindle: Spindle,
    period: f64,
    tool_change_s: f64,
    state: State,
    /// What a reset clears is cleared once axes moved by hand stand.
    clears: bool,
    hold: bool,
    /// End of the last move given to motion.
    commanded: Position,
    /// By how much places were renamed, all in all.
    renamed: Position,
    given: VecDeque<Given>,
    /// What pages show of the block that is run, or was run last.
    shown: Shown,
    next_tag: u64,
    waiting: Option<Waiting>,
    busy: Option<Busy>,
    /// What the servo chain was given in the last servo period.
    setpoint: Position,
    /// Where the axes were in it.
    actual: Position,
    span: Span,
    /// Line of its block in the main program: within a subprogram that of the call. 0 before the first.
    main_line: u32,
    report: Report,
    events: VecDeque<Event>,
    /// What was wrong with an axis, once they have come to rest.
    failed: Option<Box<Alarm>>,
    /// The alarm of drives that stopped by themselves was given.
    drives_failed: bool,
    /// The amplifiers are on.
    is_powered: bool,
    /// The ladder, where the machine has one.
    auxiliary: Option<Box<Auxiliary>>,
    taking_up: taking_up::TakingUp,
    /// Touches of a probe in the place of a program.
    touches: Option<Box<touching::Touches>>,
    blocks: Blocks,
    aside: Aside,
    retrace: Retrace,
    switches: Switches,
    /// Speed along the path in the last period, mm/s.
    velocity: f64,
    /// Least acceleration and jerk of an axis, mm/s² and mm/s³.
    braking: [f64; 2],
    /// The code that the program ended by.
    ended_by: Option<u32>,
    sent: Sent,
    program_spindle: ProgramSpindle,
    program_outputs: ProgramOutputs,
    messages: Messages,
    /// Whether the input came that the program waited for, until it is told.
    input_came: Option<bool>,
}

impl Cnc {
    /// A control that is about to run a program on simulated drives. The axes stand where the
    /// interpreter starts.
    pub fn new(machine: &Machine, interpreter: Interpreter) -> Cnc {
        Cnc::with_drives(machine, interpreter, Box::new(Simulated))
    }

    /// The same with other drives.
    pub fn with_drives(machine: &Machine, mut interpreter: Interpreter, drives: Box<dyn Drives>) -> Cnc {
        interpreter.set_machine(Arc::new(machine.clone()));
        let mut machine = machine.clone();
        (interpreter.dialect().machine_parameters)(&interpreter.memory().parameters, &mut machine);
        let machine = &machine;
        let start = interpreter.position();
        let period = machine.servo_period_ms / 1000.0;
        let motion = Planning::new(machine, start);
        let room = MOVES_A_PLACE * (motion.free() + 1);
        let knows_places = drives.knows_places() || machine.homing.absolute;
        let mut cnc = Cnc {
            supervisor: Supervisor::new(machine, interpreter.dialect(), start).runs(),
            given: VecDeque::with_capacity(room),
            shown: interpreter.shown(),
            motion,
            steps_a_period: usize::MAX,
            steps_left: usize::MAX,
            ahead_until: None,
            servo: Servo::new(machine, start),
            synchron: Synchron::new(machine, start),
            told_rpm: 0.0,
            given_rpm: 0.0,
            manual: Manual::new(machine, start),
            homing: Homing::new(machine),
            machine_axes: machine.axis_set(),
            travel: machine.limits(),
            feeds: [machine.path.lowest_feed, machine.path.highest_feed.unwrap_or(f64::INFINITY)],
            wired: None,
            overtravel: Overtravel::new(machine.homing.ignores_switches),
            probing: None,
            skip_shift: Position::ZERO,
            thread: None,
            stroke: None,
            spindle_config: machine.spindle.clone(),
            patience: machine.servo.in_position_ms / 1000.0,
            kind: Kind::Cutting,
            exact_stop: machine.path.exact_stop,
            taking_up: taking_up::TakingUp::new(interpreter.tools()),
            interpreter: Interpreting::new(interpreter),
            drives,
            spindle: Spindle::new(machine),
            period,
            tool_change_s: machine.tool_change.time_s,
            state: State::Ready,
            clears: false,
            hold: false,
            commanded: start,
            renamed: Position::default(),
            next_tag: 1,
            waiting: None,
            busy: None,
            setpoint: start,
            actual: start,
            span: Span::default(),
            main_line: 0,
            report: Report::new(period),
            events: VecDeque::with_capacity(EVENTS),
            failed: None,
            drives_failed: false,
            is_powered: true,
            auxiliary: None,
            touches: None,
            blocks: Blocks::new(room),
            aside: Aside::default(),
            retrace: Retrace::new(),
            switches: Switches::new(start),
            velocity: 0.0,
            braking: braking(machine),
            ended_by: None,
            sent: Sent::default(),
            program_spindle: ProgramSpindle::default(),
            program_outputs: ProgramOutputs::new(room),
            messages: Messages::new(),
            input_came: None,
        };
        if !knows_places {
            cnc.set_referenced(AxisSet::EMPTY);
        }
        cnc.fit_interpreter();
        cnc
    }

    /// The drives, for what they have beside the axes.
    pub fn drives(&mut self) -> &mut dyn Drives {
        self.drives.as_mut()
    }

    /// Line of the main program that is run, counted from 1: within a subprogram that of its call. 0 before the first.
    pub fn main_line(&self) -> u32 {
        self.main_line
    }

    /// What the control is doing.
    pub fn state(&self) -> &State {
        &self.state
    }

    /// What the run took so far.
    pub fn report(&self) -> &Report {
        &self.report
    }

    /// The spindle.
    pub fn spindle(&self) -> &Spindle {
        &self.spindle
    }

    /// The moves as they were programmed, the one being run first, the others as far as motion looks ahead.
    pub fn moves(&self) -> impl Iterator<Item = &Programmed> {
        let stroke = self.stroke.as_ref().map(|stroke| &stroke.programmed);
        stroke.into_iter().chain(self.given.iter().map(|given| &given.programmed))
    }

    /// By how much the program renamed the place where the axes stand, all in all: without it, positions go on
    /// from one period to the next.
    pub fn renamed(&self) -> Position {
        self.renamed
    }

    /// Machine position of the program's zero for the move being run, tool length included.
    pub fn program_zero(&self) -> Position {
        self.frame().zero
    }

    /// A machine position in the work coordinate system of the move being run: the tip of the tool.
    pub fn in_work(&self, machine: Position) -> Position {
        let frame = self.frame();
        frame.turn.undo(machine - frame.zero)
    }

    /// What tool length compensation adds for the move being run.
    pub fn tool_length(&self) -> Position {
        self.frame().length
    }

    /// What pages show as in force: of the block that is run or was run last; between programs and behind an alarm what is
    /// in force now.
    pub fn shown(&self) -> Shown {
        let is_between = matches!(self.state, State::Ready | State::Ended | State::Reset | State::Alarmed(_));
        if is_between { self.interpreter.shown() } else { self.shown }
    }

    /// What is in force for the move being run.
    fn frame(&self) -> Frame {
        self.given.front().map_or_else(|| self.interpreter.frame(), |given| given.frame)
    }

    /// What is left to the end of the move being run, mm and degrees.
    pub fn to_go(&self) -> Position {
        match self.given.front() {
            Some(given) if self.is_under_way() => given.motion.to() - self.motion.position(),
            _ => Position::ZERO,
        }
    }

    /// What is between interpolator and drives in the last servo period.
    pub fn chain(&self) -> Chain {
        Chain { setpoint: self.setpoint, compensation: self.servo.added(), to_go: self.to_go() }
    }

    /// The code by which the program has ended: 2, 30 or 99; none where its text did.
    pub fn ended_by(&self) -> Option<u32> {
        self.ended_by
    }

    /// Takes what happened since the last call.
    pub fn events(&mut self) -> Vec<Event> {
        self.events.drain(..).collect()
    }

    /// The first thing of those that happened, which is told no more.
    pub(crate) fn next_event(&mut self) -> Option<Event> {
        self.events.pop_front()
    }

    /// Starts the program, or goes on after feed hold, M00 or M01. Not while axes are moved by hand.
    pub fn cycle_start(&mut self) {
        // Homing that a program began goes on with it.
        let homes = self.state == State::Held && self.homing.is_active();
        if self.goes_forward() {
            return;
        }
        if !homes && (self.manual.is_active || self.return_to_path()) {
            return;
        }
        self.manual.stop();
        if self.state == State::Ready {
            self.shown = self.interpreter.shown();
            self.forget_passed();
            self.tell_unreferenced();
            // Someone may have started it by hand, or a program before this one.
            self.supervisor.finds_spindle(self.spindle.told() != 0.0);
            if let Some(auxiliary) = &self.auxiliary {
                // So there is room for them before the periods in which the program reads them.
                self.interpreter.own().set_ports(auxiliary.macro_inputs());
            }
            // One that is taken up has the spindle that its codes are about to turn.
            if !self.is_leading_in() {
                self.finds_spindle();
                // One that turns already is the program's from here on, with its M03 or without.
                self.program_spindle = ProgramSpindle::taken_up(self.interpreter.words_in_force().spindle);
            }
        }
        self.forget_hold_behind_thread();
        self.begin_journal();
        if matches!(self.state, State::Ready | State::BlockEnd | State::Stopped(_)) {
            self.blocks.begin();
        }
        if matches!(self.state, State::Ready | State::Held | State::BlockEnd | State::Stopped(_)) {
            self.state = State::Running;
            self.hold = false;
            self.hold_motion();
        }
    }

    /// Brings the axes to rest on the path; cycle start goes on. A tool in a thread comes out first (GSK990MC
    /// 4.5.1).
    pub fn feed_hold(&mut self) {
        self.hold_return();
        if self.state == State::Held {
            self.stop_retrace();
        }
        if self.state == State::Running && !self.waits_in_thread(Asked::Hold) {
            self.state = State::Held;
            self.hold = true;
            self.hold_motion();
        }
    }

    /// Brings the axes to rest and forgets the rest of the program. A tool in a thread comes out first (GSK990MC
    /// 4.5.1).
    pub fn reset(&mut self) {
        self.manual.stop();
        self.homing.abort();
        // The alarm of drives that failed comes first.
        let is_failing = self.drives_failed && self.state == State::Resetting;
        if is_failing
            || matches!(self.state, State::Ended | State::Reset)
            || self.waits_in_thread(Asked::Reset)
        {
            if self.manual.is_active && matches!(self.state, State::Ended | State::Reset) {
                self.spindle.command(SpindleState::Off, &self.commanded);
                self.clears = true;
            }
            return;
        }
        self.restart_drives();
        self.come_to_rest();
    }

    /// Brings axes and spindle to rest at once, in a thread in step, and forgets the rest of the program.
    pub fn emergency_stop(&mut self) {
        self.manual.stop();
        // The alarm of drives that failed stands whatever is pressed beside it: reset starts them anew behind it.
        if self.drives_failed && matches!(self.state, State::Alarmed(_)) {
            self.spindle.command(SpindleState::Off, &self.commanded);
            return;
        }
        let drives = self.failed.take().filter(|_| self.drives_failed);
        let homing = self.stop_homing();
        if homing.is_some() || !matches!(self.state, State::Ended | State::Reset) {
            self.come_to_rest();
            self.spindle.command(SpindleState::Off, &self.commanded);
            self.failed = drives.or(homing);
        } else {
            // With nothing under way it clears what a reset does (GSK990MC 34#7, 35, 36).
            self.spindle.command(SpindleState::Off, &self.commanded);
            self.clears = self.manual.is_active;
            self.clear();
        }
    }

    fn come_to_rest(&mut self) {
        self.break_off_lead_in();
        self.hold_return();
        self.manual.stop();
        self.homing.abort();
        self.probing = None;
        self.forget_held();
        self.synchron.stop();
        self.thread = None;
        self.motion.abort();
        self.retrace.give_up();
        if let Some(auxiliary) = &mut self.auxiliary {
            auxiliary.cancel();
        }
        self.waiting = None;
        (self.busy, self.input_came) = (None, None);
        self.failed = None;
        self.forget_blocks();
        self.state = State::Resetting;
    }

    /// Feed override 0 to 2 and rapid override 0 to 1, as factors.
    pub fn set_override(&mut self, feed: f64, rapid: f64) {
        self.set_overrides(feed, rapid, feed, rapid);
    }

    /// Speed that no axis exceeds in positioning, mm/s or degrees/s, besides the rapid override; none at infinity.
    pub fn set_rapid_speed(&mut self, speed: f64) {
        self.motion.set_rapid_speed(speed);
    }

    /// The same with factors of their own for axes moved by hand.
    pub fn set_overrides(&mut self, feed: f64, rapid: f64, manual_feed: f64, manual_rapid: f64) {
        self.motion.set_override(feed, rapid);
        if self.manual.overrides() == (manual_feed, manual_rapid) {
            return;
        }
        if self.manual.is_held() && self.take_by_hand() {
            // An axis that an override of 0 has stopped begins anew.
            let begins =
                self.machine_axes.iter().filter(|axis| self.manual.holds(*axis) && self.manual.stands(*axis));
            let begins: AxisSet = begins.collect();
            begins.iter().for_each(|axis| self.keep_out_beside(axis, begins));
        }
        self.manual.set_override(manual_feed, manual_rapid);
    }

    /// A jog key of an axis: pressed, changed or released ([`JogWay::Stop`]). Whether axes may be moved by hand now: not
    /// while a program is under way, nor after an alarm before reset. An axis comes to rest on its software limit.
    pub fn jog(&mut self, axis: Axis, way: JogWay, speed: JogSpeed) -> bool {
        let takes = self.take_by_hand();
        if takes {
            self.keep_out(axis);
            self.manual.jog(axis, self.off_switch(axis, way), speed);
        }
        takes
    }

    /// Moves an axis by `steps` increments, mm or degrees; whether axes may be moved by hand now.
    pub fn jog_step(&mut self, axis: Axis, steps: i64, increment: f64) -> bool {
        let takes = self.take_by_hand();
        if takes {
            self.keep_out(axis);
            self.manual.step(axis, self.steps_off_switch(axis, steps, increment), increment);
        }
        takes
    }

    /// Moves an axis by counts of the handwheel, each an increment, mm or degrees; whether axes may be moved by
    /// hand now.
    pub fn handwheel(&mut self, axis: Axis, counts: i64, increment: f64) -> bool {
        let takes = self.take_by_hand();
        if takes {
            self.keep_out(axis);
            let counts = self.manual.way_of_wheel(counts);
            self.manual.wheel(axis, self.steps_off_switch(axis, counts, increment), increment);
        }
        takes
    }

    /// Axes that steps, counts or keys move by hand come to rest; keys must be pressed anew.
    pub fn stop_by_hand(&mut self) {
        if self.manual.is_active && !self.homing.is_active() && !self.returns() {
            self.manual.stop();
        }
    }

    /// Gives the axes to whoever moves them by hand, if no program has them.
    fn take_by_hand(&mut self) -> bool {
        if self.may_be_moved_back() {
            self.interpreter.own().reset(self.commanded);
            self.state = State::Reset;
        }
        // Axes that a program homes are nobody else's.
        let interrupts = self.may_be_interrupted() && !self.homing.is_active();
        let takes = self.may_move()
            && (interrupts || matches!(self.state, State::Ready | State::Ended | State::Reset));
        if takes {
            if interrupts {
                self.interrupt();
            }
            self.manual.take(self.beside(self.motion.position()));
        }
        takes
    }

    /// Periods that were not planned in time, all in all.
    pub fn late_plans(&self) -> u64 {
        self.motion.late()
    }

    /// Goes on by one servo period.
    pub fn tick(&mut self) -> Tick {
        self.fetch();
        self.steps_left = self.steps_a_period;
        self.serve_ladder();
        self.follow_tool();
        self.wait_for_more();
        self.override_spindle();
        self.tell_motion_of_spindle();
        let tick = self.period();
        if self.stroke.is_none_or(|stroke| !stroke.has_begun) {
            self.spindle.tick(self.period);
        }
        self.drives.turn_spindle(self.spindle.told());
        tick
    }

    fn period(&mut self) -> Tick {
        match self.state {
            State::Running if self.manual.is_active => return self.move_by_hand(),
            State::Running if self.retrace.is_behind() => return self.catch_up(),
            State::Running => {}
            State::Held | State::Resetting => return self.slow_down(),
            State::BlockEnd if !self.manual.is_active => return self.slow_down(),
            _ if self.manual.is_active => return self.move_by_hand(),
            _ => return self.at_rest(),
        }
        loop {
            let done = self.auxiliary.as_mut().and_then(|auxiliary| auxiliary.take_done());
            self.watch_spindle(done.is_some());
            if let Some(step) = done {
                self.done(&step.op);
            }
            self.watch_block_end();
            self.take_steps();
            if self.state != State::Running {
                return self.slow_down();
            }
            if self.busy.is_some() {
                self.count_busy();
                return self.at_rest();
            }
            if self.stroke.is_some() {
                return self.cut_thread();
            }
            if self.must_settle_now() {
                return self.settle();
            }
            if self.motion.is_empty() && self.motion.at_rest() {
                if let Some(last) = self.given.back().map(|given| given.tag) {
                    // What ran in less than a period has begun too.
                    self.comes_to_move(last);
                }
                self.finish_moves(u64::MAX);
                self.rest_floating();
                if self.state != State::Running {
                    return self.slow_down();
                }
                if self.waits_for_ladder() {
                    return self.wait_for_ladder();
                }
                if self.is_at_block_end() {
                    self.end_block();
                    return self.at_rest();
                }
                if !self.interpreter.is_here() {
                    return self.wait_for_interpreter();
                }
                match self.waiting.take() {
                    Some(waiting) => self.act(waiting),
                    // The program goes on in the next period.
                    None if self.steps_left == 0 || self.interpreter.is_paused() => return self.at_rest(),
                    None if self.is_between_lines() => return self.at_rest(),
                    None if self.hands_over_speed() => {}
                    None => self.end_program(None),
                }
                if self.state != State::Running {
                    return self.at_rest();
                }
                if self.manual.is_active {
                    // Axes search their reference points; the program waits.
                    return self.move_by_hand();
                }
                continue;
            }
            if self.motion.at_rest() && self.cutting_waits() {
                self.report.period(Activity::Spindle);
                return self.at_rest();
            }
            if self.motion.at_rest() && self.tap_waits() {
                self.report.period(Activity::Spindle);
                return self.at_rest();
            }
            return self.move_on();
        }
    }

    /// A period of motion.
    fn move_on(&mut self) -> Tick {
        let setpoint = self.motion.tick();
        self.velocity = setpoint.velocity;
        if !self.follow_retrace(&setpoint) {
            self.follow(&setpoint);
        }
        let position = self.exchange(&self.beside(setpoint.position));
        self.watch_probe();
        let (actual, velocity) = (self.actual, setpoint.velocity);
        Tick { position, actual, velocity, span: self.span, moving: true }
    }

    /// Follows the program as the axes run it.
    fn follow(&mut self, setpoint: &Sample) {
        self.finish_moves(setpoint.tag);
        self.comes_to_move(setpoint.tag);
        if let Some(given) = self.given.front_mut() {
            given.travelled += setpoint.velocity * self.period;
            let given = *given;
            self.follow_floating(&given);
            (self.span, self.shown) = (given.span, given.frame.shown);
            self.main_line = given.block.main_line;
            self.comes_to(given.number, given.span);
            self.kind = given.kind();
            self.report.period(given.activity);
            let (running, block) = (given.tag, given.block);
            self.runs(block);
            self.arm_probe(running);
        }
    }

    /// A period of moving by hand. Once the axes stand, the program goes on from there.
    fn move_by_hand(&mut self) -> Tick {
        self.home_on();
        let (at, velocity) = self.manual.tick();
        self.note_cut_short();
        self.kind = self.manual.kind();
        let position = self.exchange(&at);
        let tick = Tick { position, actual: self.actual, velocity, span: self.span, moving: true };
        // A failed axis may never come to its place.
        let stand = self.manual.is_at_rest() && !self.homing.is_active();
        if stand && (self.servo.is_at_rest() || self.failed.is_some()) {
            self.manual.is_active = false;
            let at = self.name_homed(at);
            if self.stop_aside(at) {
                return tick;
            }
            let at = at - self.aside.shift;
            self.motion.rename(at);
            self.supervisor.moved_to(at);
            self.commanded = at;
            self.interpreter.own().came_to_rest(&AtRest::new(at, self.actual));
            // The spindle stopped at once; one that was started since goes on.
            if std::mem::take(&mut self.clears) && self.is_idle() {
                self.clear_codes();
            }
        }
        tick
    }

    /// Whether the axes are still to come to where motion stands before it goes on.
    fn must_settle_now(&self) -> bool {
        // What the axes come through again on the way back was not all of the move that is held.
        let is_behind = self.retrace.is_behind() || self.retrace.is_before();
        self.motion.at_rest() && !self.servo.is_at_rest() && (is_behind || self.must_settle())
    }

    /// Whether the axes must be where motion has come to rest before anything else begins: a step that waits,
    /// cutting after positioning and positioning after anything, a move behind an exact stop, and any move
    /// where backlash is to be taken up first (GSK990MC 18#0).
    fn must_settle(&self) -> bool {
        // A move that goes nowhere is none.
        let mut next = self.given.iter().skip(1).filter(|given| given.min != given.max);
        match (self.given.front(), next.next()) {
            (Some(run), Some(next)) => run.stops || run.kind() != next.kind() || !self.servo.has_taken_up(),
            _ => self.motion.is_empty(),
        }
    }

    /// A period in which motion stands on the end of a move, and the axes come there.
    fn settle(&mut self) -> Tick {
        if let Some(given) = self.given.front() {
            self.report.period(given.activity);
        }
        let at = self.beside(self.motion.position());
        let position = self.exchange(&at);
        Tick { position, actual: self.actual, velocity: 0.0, span: self.span, moving: true }
    }

    /// Commands the drives; where the axes shall be. Sets where they are, both without compensation.
    fn exchange(&mut self, setpoint: &Position) -> Position {
        self.setpoint = *setpoint;
        let command = self.servo.tick(setpoint, self.kind);
        let drive = self.switches.drive(command.drive);
        let mut actual = self.drives.exchange(&drive);
        if self.switches.is_locked() {
            // Positions go on as if the axes did (7.7).
            actual = command.drive;
        }
        let fault = command.fault.or(self.servo.supervise(&actual));
        self.actual = match actual == command.drive {
            true => command.position,
            false => actual - self.servo.added(),
        };
        if self.drives.has_failed() {
            self.fail_drives();
        } else if let Some(fault) = fault {
            self.fail(&fault);
        }
        self.watch_switches();
        self.watch_cut_short(setpoint);
        self.watch_strokes(&command.position);
        self.note_reference(&command.position);
        command.position
    }

    /// An axis went wrong: all come to rest, then it is an alarm.
    fn fail(&mut self, fault: &ServoFault) {
        if matches!(self.state, State::Alarmed(_)) || self.failed.is_some() {
            return;
        }
        let dialect = self.interpreter.dialect();
        let number = self.servo.number(fault.axis);
        let (id, rule) = match fault.kind {
            ServoFaultKind::BelowLimit => (dialect.soft_limit_id(number, false), Fault::SoftLimit),
            ServoFaultKind::AboveLimit => (dialect.soft_limit_id(number, true), Fault::SoftLimit),
            ServoFaultKind::FollowingError => {
                (dialect.alarm_id(Fault::FollowingError), Fault::FollowingError)
            }
            ServoFaultKind::NotInPosition => (dialect.alarm_id(Fault::NotInPosition), Fault::NotInPosition),
            ServoFaultKind::BesidePitchPoints => (dialect.alarm_id(Fault::PitchPoint), Fault::PitchPoint),
        };
        let value = match rule {
            Fault::SoftLimit | Fault::PitchPoint => "position",
            _ => "distance",
        };
        let axis = fault.axis.letter().to_string();
        let alarm = Alarm::new(id, rule, self.span).with("axis", axis);
        let alarm = alarm.with(value, fault.value).with("limit", fault.limit);
        self.come_to_rest();
        self.failed = Some(Box::new(alarm));
    }

    /// A period in which nothing is to be done but what the interpreter reads beside, or may do so once it is back.
    fn wait_for_interpreter(&mut self) -> Tick {
        if self.waiting.is_some() {
            self.interpreter.call_back();
        }
        self.at_rest()
    }

    /// A period in which the axes stand still.
    fn at_rest(&mut self) -> Tick {
        let at = self.beside(self.motion.position());
        let position = self.exchange(&at);
        Tick { position, actual: self.actual, velocity: 0.0, span: self.span, moving: false }
    }

    /// A period of coming to rest, or of standing still until cycle start.
    fn slow_down(&mut self) -> Tick {
        if self.manual.is_active {
            return self.move_by_hand();
        }
        if self.state == State::Held {
            self.turn();
        }
        // A failed axis may never come to its place.
        let can_settle = self.failed.is_none();
        // What is given up is forgotten by motion before the place of the axes gets its coordinates.
        let forgets = self.state == State::Resetting && !self.motion.is_empty();
        if !self.motion.is_still() || forgets || self.retrace.goes_back() {
            return if can_settle && self.must_settle_now() { self.settle() } else { self.move_on() };
        }
        match self.stroke {
            Some(stroke) if stroke.has_begun => return self.cut_thread(),
            // The spindle brakes all the same.
            Some(_) if self.state == State::Resetting => self.stroke = None,
            _ => {}
        }
        if can_settle && !self.servo.is_at_rest() {
            return self.settle();
        }
        if self.state == State::Resetting {
            if !self.interpreter.is_here() {
                // The axes stand; what is forgotten of the program waits for the end of the block that is read.
                return self.at_rest();
            }
            self.given.clear();
            self.absorb();
            self.commanded = self.motion.position();
            self.state = match self.failed.take() {
                Some(alarm) => State::Alarmed(alarm),
                None => {
                    self.forget_program();
                    State::Reset
                }
            };
        } else if let Some(Busy { activity: Activity::Spindle | Activity::ToolChange, .. }) = self.busy {
            // Hold stops the axes and dwells; a spindle or changer under way comes to its end.
            self.count_busy();
        }
        self.at_rest()
    }

    fn count_busy(&mut self) {
        if let Some(busy) = &mut self.busy {
            busy.periods -= 1;
            self.report.period(busy.activity);
            let is_over = busy.periods == 0;
            if let Some(awaited) = busy.until {
                self.look_for_input(awaited, is_over);
            } else if is_over {
                self.busy = None;
            }
        }
    }

    /// Does what waited, the axes being at rest.
    fn act(&mut self, waiting: Waiting) {
        self.forget_passed();
        self.tell_messages(self.next_tag);
        let block = self.blocks.waiting.take();
        if let Some(block) = block.filter(|block| block.main_line > 0) {
            self.main_line = block.main_line;
        }
        let step = match waiting {
            Waiting::Alarm(alarm) => {
                self.span = alarm.span;
                // Those before it are done; before the first one nothing was run.
                let has_begun = self.taking_up.at.1.line > 0;
                if let Some(number) = block.and_then(|block| block.number()).filter(|_| has_begun) {
                    let frame = self.interpreter.frame();
                    self.comes_to(number, if number == frame.begun { frame.last } else { alarm.span });
                }
                self.state = State::Alarmed(alarm);
                return;
            }
            Waiting::Skip => return self.end_probing(),
            Waiting::Step(step) => step,
        };
        (self.span, self.shown) = (step.span, self.interpreter.frame_of(&step).shown);
        self.comes_to(step.block, step.span);
        if let Some(block) = block {
            self.runs(block);
        }
        self.note_spindle(&step.op);
        self.keep_tools(&step.op);
        if self.is_kept_back(&step.op) || self.is_for_ladder(&step) {
            return;
        }
        if matches!(step.op, Op::Tap { .. } | Op::Orient(_)) && !self.drives.leads_spindle() {
            self.state = State::Alarmed(Box::new(Alarm::core(Fault::SpindleNotLed, step.span)));
            return;
        }
        match step.op {
            Op::Dwell(Dwell::Seconds(seconds)) => self.keep_busy(Activity::Dwell, seconds),
            Op::Dwell(Dwell::Revolutions(turns)) => {
                let rpm = self.feed_rpm();
                if rpm == 0.0 {
                    self.state = State::Alarmed(Box::new(Alarm::core(Fault::FeedNotReachable, step.span)));
                } else {
                    self.keep_busy(Activity::Dwell, turns * 60.0 / rpm);
                }
            }
            Op::Barrier => {
                self.skip_shift = Position::ZERO;
                let (commanded, actual) = (self.commanded, self.actual);
                let input = self.input_came.take();
                let inputs = self.auxiliary.as_ref().map(|auxiliary| auxiliary.macro_inputs());
                self.tell_program(&AtRest { commanded, actual, skip: None, input, inputs });
                // A program that waits for an input in a loop lets time go on.
                self.keep_busy(Activity::Dwell, self.period);
            }
            Op::Wait { port, value, is_edge, timeout, must_come } => {
                self.wait_for_input(&port, AwaitedInput::new(value != 0.0, is_edge, must_come), timeout);
            }
            Op::Datum { at } => {
                self.renamed = self.renamed + at - self.motion.position();
                self.motion.rename(at);
                self.servo.rename(at);
                // Locked, the drives stand where their axes are called as before.
                if !self.is_locked() {
                    self.drives.rename(&(at + self.servo.added()));
                }
                self.commanded = at;
            }
            Op::Spindle(state) => {
                let seconds = self.spindle.command(state, &self.commanded);
                self.keep_busy(Activity::Spindle, seconds);
            }
            Op::Tap { to, pitch, rpm, goes_on } => self.begin_stroke(to, pitch, rpm, goes_on),
            Op::Orient(degrees) => {
                let seconds = self.spindle.orient(degrees);
                self.keep_busy(Activity::Spindle, seconds);
            }
            Op::Message(text) => self.events.push_back(Event::Message(text)),
            Op::Output { port, value, with_next_move: true } => {
                self.program_outputs.wait_for(self.next_tag, &port, value);
            }
            Op::Output { port, value, with_next_move: false } => self.program_outputs.set(&port, value),
            op => {
                self.done(&op);
                if matches!(op, Op::Change(_)) {
                    self.keep_busy(Activity::ToolChange, self.tool_change_s);
                }
            }
        }
    }

    /// What is so once the machine has done a step.
    fn done(&mut self, op: &Op) {
        match *op {
            Op::Select(tool) => self.taking_up.tools.1 = tool,
            Op::Change(tool) => {
                self.taking_up.tools = (tool, tool);
                self.report.change_tool(tool);
                self.events.push_back(Event::ToolChange(tool));
            }
            Op::ToolNumber(tool) => {
                self.taking_up.tools = (tool, tool);
                self.report.change_tool(tool);
            }
            Op::Home(axes) => self.home_by_program(axes),
            Op::Stop(code) => self.state = State::Stopped(code),
            Op::End(code) => {
                // M99 in the main program starts it again and counts no part (GSK990MC 5.2.5).
                if code != 99 {
                    self.report.parts += 1;
                }
                self.end_program(Some(code));
            }
            _ => {}
        }
    }

    fn end_program(&mut self, code: Option<u32>) {
        (self.ended_by, self.thread) = (code, None);
        self.program_outputs.forget_waiting();
        self.messages.forget();
        self.state = State::Ended;
    }

    /// Keeps the axes at rest for some time, rounded up to whole periods.
    fn keep_busy(&mut self, activity: Activity, seconds: f64) {
        // What a sum of decimals is above a whole number of periods is no further period.
        let periods = (seconds / self.period - 1e-9).ceil();
        if periods >= 1.0 {
            self.busy = Some(Busy { activity, periods: periods as u64, until: None });
        }
    }
}

/// Least acceleration and jerk of an axis or of the path, by which it is judged where the path surely comes to rest.
fn braking(machine: &Machine) -> [f64; 2] {
    let own = machine.axes.iter().map(|axis| Ramp { acceleration: axis.acceleration, jerk: axis.jerk });
    let set = machine.axes.iter().flat_map(|axis| [axis.before_rapid, axis.before_cutting]);
    let ramps = own.chain(set.chain([machine.path.ramp]).flatten());
    ramps.fold([1e6, 1e6], |[acceleration, jerk], ramp| {
        let bound = if ramp.jerk > 0.0 { ramp.jerk.max(1.0) } else { f64::INFINITY };
        [ramp.acceleration.min(acceleration), bound.min(jerk)]
    })
}
