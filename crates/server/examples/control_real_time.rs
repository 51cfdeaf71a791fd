//! The whole control on the real clock, with the standard ladder, the simulated machine and the thread that `ferrocut
//! serve` runs it on: what the periods took, and how late they were woken. Beside it, on a thread of the same kind, a
//! computation that is always the same: what it takes longer at times is the computer's doing and not that of the software,
//! and so is as much of what the control takes.
//!
//! `control_real_time [SECONDS] [PRIORITY] [BOUND]`: 60 s if not given, at 1 kHz, the bracket and a demanding program in turn.
//! With a priority (1 to 99; 0 for none) the machine's thread, and the planner's with it, run before all others. With a
//! bound in µs it is an error if the control computes longer than that in one of 10,000 periods, less what the computer
//! adds to the fixed computation there, or for a period or longer at any time.
#![allow(missing_docs)]

#[path = "../../controller/examples/shared/demanding.rs"]
mod program;

use ferrocut_controller::api::{Activity, Command, Status};
use ferrocut_controller::{Control, Parts};
use ferrocut_machine::{Machine, PlantConfig};
use ferrocut_memory::{Author, Seat, Session};
use ferrocut_plc::{Limits, Program};
use ferrocut_server::panel::Panel;
use ferrocut_server::runner::{Owned, Runner, Times};
use ferrocut_server::service::{Caller, Request, Served};
use std::hint::black_box;
use std::process::ExitCode;
use std::sync::Arc;
use std::sync::mpsc::sync_channel;
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
    let machine = Machine { plant: Some(PlantConfig::default()), ..Machine::demo_mill() };
    let Ok(ladder) = Program::from_text(LADDER.as_bytes(), &Limits::default()) else {
        return failed(format_args!("the ladder is wrong"));
    };
    let mut control = match Control::new(&machine, Parts { ladder: Some(ladder), ..Parts::default() }) {
        Ok(control) => control,
        Err(alarm) => return failed(format_args!("{alarm:?}")),
    };
    let operator = Author::Person { session: Session::OPERATOR, name: "bench".to_owned() };
    for (program, text) in [("O0001", BRACKET.to_owned()), ("O0002", program::demanding(12))] {
        if let Err(why) = control.command(Command::Store { program: program.to_owned(), text }, &operator) {
            return failed(format_args!("{why:?}"));
        }
    }
    let (events, _heard) = sync_channel(1024);
    let period = Duration::from_secs_f64(machine.servo_period_ms / 1000.0);
    let runner =
        match Runner::start(Served::<Panel>::new(Panel::new(control).timed(), events), period, priority) {
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
    drop(runner);
    // What the computer adds to a computation that is always the same.
    let added = fixed.computing.below(0.9999).saturating_sub(fixed.computing.below(0.5));
    let own = timing.computing.below(0.9999).saturating_sub(added);
    match bound {
        Some(bound) if own >= bound => failed(format_args!("99.99 %: {own:?} of its own, {bound:?} allowed")),
        Some(_) if timing.computing.worst() >= period => {
            failed(format_args!("a period was missed by computing"))
        }
        _ => ExitCode::SUCCESS,
    }
}
