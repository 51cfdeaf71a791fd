//! What the software itself computes in the servo periods of the whole control, with the standard ladder and the simulated
//! machine, without what the computer does to it meanwhile: the same run is made several times, and the least time that
//! each of its periods took counts.
//!
//! `period_work [SECONDS] [RUNS] [BOUND] [RARE]`: 60 s of a demanding program from its selection and start on, five times, as
//! fast as it goes. With a bound in µs it fails where more than one of RARE periods (10,000 if not given) do not keep below.
//! What is planned and read beside is waited for outside of the periods; how things stand is asked for every 20 periods, as
//! for a panel.
#![allow(missing_docs)]

#[path = "shared/demanding.rs"]
mod program;

use ferrocut_controller::api::Command;
use ferrocut_controller::{Control, Parts};
use ferrocut_machine::{Machine, PlantConfig};
use ferrocut_memory::{Author, Session};
use ferrocut_plc::{Limits, Program};
use std::hint::black_box;
use std::process::ExitCode;
use std::time::{Duration, Instant};

const LADDER: &str = include_str!("../../../machines/standard.lad");

/// Periods from one of these to the next.
const APART: usize = 120;

fn say(control: &mut Control, command: Command) -> Option<()> {
    let operator = Author::Person { session: Session::OPERATOR, name: "bench".to_owned() };
    control.command(command, &operator).ok().map(drop)
}

/// What the operator does in the measured periods.
fn hand(control: &mut Control, period: usize) {
    let key = |down| Command::Key { key: "KEY_START".to_owned(), down };
    let _ = match period {
        0 => say(control, Command::Select { program: "O1".to_owned() }),
        APART => say(control, key(true)),
        _ if period == 2 * APART => say(control, key(false)),
        _ => None,
    };
}

/// A control with a program, ready in AUTO; `None` where it did not come so far.
fn ready() -> Option<Control> {
    let machine = Machine { plant: Some(PlantConfig::default()), ..Machine::demo_mill() };
    let ladder = Program::from_text(LADDER.as_bytes(), &Limits::default()).ok()?;
    let mut control = Control::new(&machine, Parts { ladder: Some(ladder), ..Parts::default() }).ok()?;
    control.work_beside().ok()?;
    let press = |control: &mut Control, key: &str| {
        for down in [true, false] {
            let _ = say(control, Command::Key { key: key.to_owned(), down });
            for _ in 0..APART {
                control.tick();
            }
        }
    };
    say(&mut control, Command::Store { program: "O0001".to_owned(), text: program::demanding(40) })?;
    for (switch, position) in [("SWITCH_FEED", 10), ("SWITCH_SPINDLE", 5)] {
        say(&mut control, Command::Switch { switch: switch.to_owned(), position })?;
    }
    for key in ["KEY_R_100", "KEY_HOME", "KEY_Z+", "KEY_X+", "KEY_Y+"] {
        press(&mut control, key);
    }
    for _ in 0..120_000 {
        control.tick();
        if ['X', 'Y', 'Z'].iter().all(|axis| control.status().referenced.contains(axis)) {
            break;
        }
    }
    press(&mut control, "KEY_AUTO");
    Some(control)
}

fn main() -> ExitCode {
    let mut words = std::env::args().skip(1).filter_map(|word| word.parse::<usize>().ok());
    let periods = 1000 * words.next().unwrap_or(60);
    let runs = words.next().unwrap_or(5);
    let (bound, rare) = (words.next(), words.next().unwrap_or(10_000));
    let mut least = vec![f64::INFINITY; periods];
    for _ in 0..runs {
        let Some(mut control) = ready() else {
            eprintln!("the machine is not homed");
            return ExitCode::FAILURE;
        };
        for (period, least) in least.iter_mut().enumerate() {
            control.await_beside();
            let began = Instant::now();
            hand(&mut control, period);
            control.tick();
            drop(black_box(control.events()));
            if period % 20 == 0 {
                black_box(control.status());
            }
            *least = least.min(began.elapsed().as_secs_f64() * 1e6);
            control.prepare();
            if period == 0 {
                // Its text is read as far as an operator is from the one key to the other.
                std::thread::sleep(Duration::from_millis(200));
            }
        }
        if !control.cnc().is_under_way() {
            eprintln!("the program has ended, or was stopped: {:?}", control.cnc().state());
            return ExitCode::FAILURE;
        }
    }
    least.sort_by(f64::total_cmp);
    println!("{periods} periods, the least of {runs} runs each");
    let below = |share: f64| {
        let at = ((share * periods as f64).ceil() as usize).clamp(1, periods) - 1;
        least.get(at).copied().unwrap_or_default()
    };
    for share in [0.5, 0.9, 0.99, 0.999, 0.9999, 1.0] {
        println!("{:7.2} %: {:6.1} us", share * 100.0, below(share));
    }
    match bound {
        Some(bound) if below(1.0 - 1.0 / rare as f64) >= bound as f64 => {
            eprintln!("all but one of {rare} periods are to take less than {bound} us");
            ExitCode::FAILURE
        }
        _ => ExitCode::SUCCESS,
    }
}
