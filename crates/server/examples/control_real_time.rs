//! The whole control on the real clock, with the standard ladder, the simulated machine and the thread that `ferrocut
//! serve` runs it on: what the periods took, and how late they were woken. Beside it, on a thread of the same kind, a
//! computation that is always the same: what it takes longer at times is the computer's doing and not that of the software,
//! and so is as much of what the control takes.
//!
//! `control_real_time [SECONDS] [PRIORITY] [BOUND] [RARE]`: 60 s if not given, at 1 kHz, the bracket and a demanding program in turn.
//! With a priority (1 to 99; 0 for none) the machine's thread, and the planner's with it, run before all others.
//!
//! Then the same is done once more without the clock: a control like it is told the same in the same periods, and what is
//! planned and read beside is waited for between them. What a period took in both, where its setpoint is the same, is its
//! own; what it took in one of them alone came from elsewhere (a guest's memory that its host fetches, interrupts: the
//! system counts both as computing).
//!
//! With a bound in µs it is an error if the control's own computing takes longer than that in more than one of RARE periods, or
//! if in as many of them it, or all computing by the clock, takes a period. RARE is 10,000 if not given, and the control's own
//! then may take a period at no time.
#![allow(missing_docs)]

#[path = "../../controller/examples/shared/demanding.rs"]
mod program;

use ferrocut_controller::api::{Activity, Command, Status};
use ferrocut_controller::{Control, Parts, Tick};
use ferrocut_machine::{Machine, PlantConfig};
use ferrocut_memory::{Author, Seat, Session};
use ferrocut_plc::{Limits, Program};
use ferrocut_server::panel::Panel;
use ferrocut_server::runner::{Owned, Runner, Times};
use ferrocut_server::service::{Caller, Request, Served};
use rustix::time::{ClockId, clock_gettime};
use std::hint::black_box;
use std::process::ExitCode;
use std::sync::mpsc::{Sender, channel, sync_channel};
use std::sync::{Arc, Mutex, PoisonError};
use std::time::{Duration, Instant};

const LADDER: &str = include_str!("../../../machines/standard.lad");
const BRACKET: &str = include_str!("../../../examples/gsk990mc/bracket.nc");

/// The same few microseconds of computing in each period, about as many as the control's.
struct Yardstick(f64);

impl Owned for Yardstick {
    type Command = ();
    type Snapshot = ();

    fn take(&mut self, (): ()) {}

    fn tick(&mut self) {
        for _ in 0..7000 {
            self.0 = black_box(self.0 * 0.999 + 1.0);
        }
    }

    fn has_news(&self) -> bool {
        false
    }

    fn snapshot(&mut self, _: u64) {}
}

/// What a period was and took.
#[derive(Clone, Copy)]
struct Period {
    took: Duration,
    /// The first three axes' setpoints, by their bits.
    setpoint: [u64; 3],
    /// How it stands was asked for.
    is_published: bool,
}

/// What was recorded: periods, and commands with the number of the period.
type Record = (Vec<Period>, Vec<(usize, Command)>);

/// A control with all that is needed to do the same again.
struct Recorded {
    served: Served<Panel>,
    setpoint: Arc<Mutex<[u64; 3]>>,
    began: Option<Duration>,
    is_published: bool,
    periods: Vec<Period>,
    /// With the number of the period.
    commands: Vec<(usize, Command)>,
    /// Where it goes in the end.
    done: Sender<Record>,
}

/// Time that this thread has computed, by the system's account of it.
fn computed() -> Duration {
    let time = clock_gettime(ClockId::ThreadCPUTime);
    Duration::new(u64::try_from(time.tv_sec).unwrap_or(0), u32::try_from(time.tv_nsec).unwrap_or(0))
}

impl Recorded {
    /// For so many periods.
    fn new(control: Control, periods: usize, done: Sender<Record>) -> Recorded {
        let setpoint = Arc::new(Mutex::new([0; 3]));
        let seen = setpoint.clone();
        let watcher = Box::new(move |tick: &Tick| {
            let [x, y, z, ..] = tick.position.0;
            *seen.lock().unwrap_or_else(PoisonError::into_inner) = [x, y, z].map(f64::to_bits);
        });
        let (events, _) = sync_channel(1024);
        Recorded {
            served: Served::new(Panel::watched(control, watcher).timed(), events),
            setpoint,
            began: None,
            is_published: false,
            periods: Vec::with_capacity(periods),
            commands: Vec::with_capacity(4096),
            done,
        }
    }

    /// The period begins with a command or with its tick.
    fn begun(&mut self) {
        self.began.get_or_insert_with(computed);
    }
}

impl Owned for Recorded {
    type Command = Request<Panel>;
    type Snapshot = Status;

    fn begin(&mut self) {
        self.served.begin();
    }

    fn take(&mut self, request: Request<Panel>) {
        if let Request::Command { command, .. } = &request {
            self.commands.push((self.periods.len(), command.clone()));
        }
        self.begun();
        self.served.take(request);
    }

    fn tick(&mut self) {
        self.begun();
        self.served.tick();
    }

    fn has_news(&self) -> bool {
        self.served.has_news()
    }

    fn snapshot(&mut self, taken: u64) -> Status {
        self.is_published = true;
        self.served.snapshot(taken)
    }

    fn prepare(&mut self) {
        if let Some(began) = self.began.take()
            && self.periods.len() < self.periods.capacity()
        {
            self.periods.push(Period {
                took: computed().saturating_sub(began),
                setpoint: *self.setpoint.lock().unwrap_or_else(PoisonError::into_inner),
                is_published: std::mem::take(&mut self.is_published),
            });
        }
        self.served.prepare();
    }
}

impl Drop for Recorded {
    fn drop(&mut self) {
        let _ = self.done.send((std::mem::take(&mut self.periods), std::mem::take(&mut self.commands)));
    }
}

/// Periods that the one may be behind the other.
const FAR: isize = 500;

/// Periods about one at rest that are looked at.
const ABOUT: usize = 20;

/// Of so many in a hundred periods it must be known what they took the other time.
const KNOWN: usize = 90;

/// A control with both programs.
fn control() -> Result<Control, String> {
    let machine = Machine { plant: Some(PlantConfig::default()), ..Machine::demo_mill() };
    let ladder = Program::from_text(LADDER.as_bytes(), &Limits::default());
    let ladder = ladder.map_err(|_| "the ladder is wrong".to_owned())?;
    let control = Control::new(&machine, Parts { ladder: Some(ladder), ..Parts::default() });
    let mut control = control.map_err(|alarm| format!("{alarm:?}"))?;
    let operator = Author::Person { session: Session::OPERATOR, name: "bench".to_owned() };
    for (program, text) in [("O0001", BRACKET.to_owned()), ("O0002", program::demanding(12))] {
        let store = Command::Store { program: program.to_owned(), text };
        control.command(store, &operator).map_err(|why| format!("{why:?}"))?;
    }
    Ok(control)
}

/// The same once more, without the clock; what is planned and read beside is waited for between the periods.
fn again(
    control: Control,
    periods: &[Period],
    commands: &[(usize, Command)],
    caller: &Caller,
) -> Vec<Period> {
    let (done, result) = channel();
    let mut same = Recorded::new(control, periods.len(), done);
    same.begin();
    let mut commands = commands.iter().peekable();
    for (k, period) in periods.iter().enumerate() {
        same.served.take(Request::Look(Box::new(|panel| panel.control().await_beside())));
        let mut selects = false;
        while let Some((_, command)) = commands.next_if(|(at, _)| *at == k) {
            selects |= matches!(command, Command::Select { .. });
            same.take(Request::Command { command: command.clone(), from: caller.clone(), answer: None });
        }
        same.tick();
        if period.is_published {
            black_box(same.snapshot(0));
        }
        same.prepare();
        if selects {
            // Its text is read as far as an operator is from the one key to the other.
            std::thread::sleep(Duration::from_millis(200));
        }
    }
    drop(same);
    result.recv().map(|(periods, _)| periods).unwrap_or_default()
}

/// What each period took of its own: no more than the other time. Beside, a program is made ready a few periods sooner or later:
/// what has the same setpoints is the same. With the axes at rest all have, and the longest of those about it counts, now
/// and by as much later; a period that took commands is that which took them. How many are known of both.
fn own(lived: &[Period], replayed: &[Period], commands: &[(usize, Command)]) -> (Vec<Duration>, usize) {
    let place = |k: usize, shift: isize| k.checked_add_signed(shift);
    let is_same = |k: usize, shift: isize| {
        let there = place(k, shift).and_then(|k| replayed.get(k)).map(|period| period.setpoint);
        lived.get(k).is_none_or(|here| Some(here.setpoint) == there)
    };
    let longest = |k: usize| {
        let about = replayed.get(k.saturating_sub(ABOUT)..(k + ABOUT).min(replayed.len())).unwrap_or(&[]);
        about.iter().map(|period| period.took).max()
    };
    let (mut shift, mut alike) = (0, 0);
    let mut commands = commands.iter().map(|(at, _)| *at).peekable();
    let own = lived.iter().enumerate().map(|(k, period)| {
        let mut is_told = false;
        while commands.next_if_eq(&k).is_some() {
            is_told = true;
        }
        if !is_same(k, shift) {
            let near = (0..FAR).flat_map(|far| [far, -far]);
            shift = near.into_iter().find(|shift| (k..k + 4).all(|k| is_same(k, *shift))).unwrap_or(shift);
        }
        if !is_same(k, shift) {
            return period.took;
        }
        alike += 1;
        let moves = lived.get(k + 1).is_some_and(|next| next.setpoint != period.setpoint);
        let again = match place(k, shift) {
            _ if is_told => replayed.get(k).map(|again| again.took),
            Some(there) if !moves => longest(k).max(longest(there)),
            there => there.and_then(|there| replayed.get(there)).map(|again| again.took),
        };
        again.map_or(period.took, |again| again.min(period.took))
    });
    let own = own.collect();
    (own, alike)
}

fn failed(why: std::fmt::Arguments) -> ExitCode {
    eprintln!("{why}");
    ExitCode::FAILURE
}

fn main() -> ExitCode {
    let mut words = std::env::args().skip(1).filter_map(|word| word.parse::<u64>().ok());
    let seconds = words.next().unwrap_or(60);
    let priority =
        words.next().and_then(|priority| u8::try_from(priority).ok()).filter(|priority| *priority > 0);
    let bound = words.next().map(Duration::from_micros);
    let may_be_rare = words.next();
    let one_of = may_be_rare.unwrap_or(10_000).max(1);
    let first = match control() {
        Ok(control) => control,
        Err(why) => return failed(format_args!("{why}")),
    };
    let period = Duration::from_secs_f64(Machine::demo_mill().servo_period_ms / 1000.0);
    // Homing takes its time before.
    let most = (Duration::from_secs(seconds + 180).as_secs_f64() / period.as_secs_f64()) as usize;
    let (done, recorded) = channel();
    let runner = match Runner::start(Recorded::new(first, most, done), period, priority) {
        Ok(runner) => runner,
        Err(error) => return failed(format_args!("{error}")),
    };
    let (commands, latest, timing) = (runner.commands(), runner.latest(), runner.timing());
    let caller = Caller { name: "bench".to_owned(), seat: Seat::Machine, session: Session::OPERATOR };
    let say = |command: Command| {
        let _ = commands.send(Request::Command { command, from: caller.clone(), answer: None });
    };
    let status = || -> Arc<Status> { latest.get() };
    let pause = |ms: u64| std::thread::sleep(Duration::from_millis(ms));
    let press = |key: &str| {
        say(Command::Key { key: key.to_owned(), down: true });
        pause(120);
        say(Command::Key { key: key.to_owned(), down: false });
        pause(120);
    };
    say(Command::Switch { switch: "SWITCH_FEED".to_owned(), position: 10 });
    say(Command::Switch { switch: "SWITCH_SPINDLE".to_owned(), position: 5 });
    pause(200);
    press("KEY_R_100");
    press("KEY_HOME");
    for key in ["KEY_Z+", "KEY_X+", "KEY_Y+"] {
        press(key);
    }
    let patience = Instant::now();
    while !['X', 'Y', 'Z'].iter().all(|axis| status().referenced.contains(axis)) {
        if patience.elapsed() > Duration::from_secs(120) {
            return failed(format_args!("not homed: {:?}", status().alarms));
        }
        pause(50);
    }
    let yardstick = match Runner::start(Yardstick(0.0), period, priority) {
        Ok(yardstick) => yardstick,
        Err(error) => return failed(format_args!("{error}")),
    };
    press("KEY_AUTO");
    let (began, mut runs, mut at) = (Instant::now(), 0u32, [0.0; 2]);
    while began.elapsed().as_secs() < seconds {
        pause(20);
        let now = status();
        if !now.alarms.is_empty() {
            return failed(format_args!("alarm: {:?}", now.alarms));
        }
        at[1] += f64::from(u8::from(now.activity == Activity::Running));
        at[0] += 1.0;
        if now.activity == Activity::Idle {
            runs += 1;
            say(Command::Select { program: if runs % 3 == 0 { "O1" } else { "O2" }.to_owned() });
            pause(50);
            press("KEY_START");
        }
    }
    println!("{runs} programs begun, running {:.0} % of {seconds} s", 100.0 * at[1] / at[0]);
    println!("{timing}");
    let fixed = yardstick.timing();
    println!("a fixed computation: {fixed}");
    for share in [0.5, 0.9, 0.99, 0.999, 0.9999] {
        let us = |times: &Times| times.below(share).as_secs_f64() * 1e6;
        println!(
            "{:7.2} %: computing {:6.0} us, fixed {:6.0} us; work {:6.0} us, looking ahead {:6.0} us, woken late {:6.0} us",
            share * 100.0,
            us(&timing.computing),
            us(&fixed.computing),
            us(&timing.work),
            us(&timing.ahead),
            us(&timing.lateness)
        );
    }
    drop((runner, yardstick));
    let Ok((lived, said)) = recorded.recv() else { return failed(format_args!("nothing was recorded")) };
    let replayed = match control() {
        Ok(control) => again(control, &lived, &said, &caller),
        Err(why) => return failed(format_args!("{why}")),
    };
    let (mut own, alike) = own(&lived, &replayed, &said);
    own.sort_unstable();
    let worst = own.last().copied().unwrap_or_default();
    let below = 1.0 - 1.0 / one_of as f64;
    let rare = own.get((own.len() as f64 * below) as usize).copied().unwrap_or_default();
    println!(
        "done again without the clock: {alike} of {} periods the same; of its own all but one of {one_of} {rare:?} worst {worst:?}",
        lived.len()
    );
    if alike * 100 < KNOWN * lived.len() {
        return failed(format_args!("too few periods are known of both times to tell what is its own"));
    }
    let longest = if may_be_rare.is_some() { rare } else { worst };
    match bound {
        Some(bound) if rare >= bound => {
            failed(format_args!("all but one of {one_of}: {rare:?} of its own, {bound:?} allowed"))
        }
        Some(_) if longest.max(timing.computing.below(below)) >= period => {
            failed(format_args!("a period was missed by computing"))
        }
        _ => ExitCode::SUCCESS,
    }
}
