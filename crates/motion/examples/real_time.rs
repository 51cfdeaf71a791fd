//! Runs a demanding program of nine axes on the real clock, planner and interpolator in a thread each, and prints what
//! the period took, how late the thread woke up, and how often the planner was late.
//!
//! `real_time [SECONDS]`, 60 if not given, at 1 kHz. With real-time priority for all threads: `chrt -f 80 real_time`.
#![allow(missing_docs)]

#[path = "../tests/common/demanding.rs"]
mod demanding;

use demanding::{Asked, Blocks, Hands, Times, machine};
use ferrocut_geometry::Position;
use ferrocut_motion::servo::Kind;
use ferrocut_motion::{Motion, Planner, Servo};
use std::sync::atomic::{AtomicBool, Ordering};
use std::time::{Duration, Instant};

/// How long the planner sleeps when it has nothing to do: a quarter of a period.
const NAP: Duration = Duration::from_micros(250);

/// Fills the interpolator until the run is over; what a planning period took at most.
fn plan(mut planner: Planner, is_over: &AtomicBool) -> (Planner, Times) {
    let (mut blocks, mut hands) = (Blocks::new(1), Hands::new(2));
    let mut times = Times::default();
    while !is_over.load(Ordering::Relaxed) {
        while planner.is_due() {
            let began = Instant::now();
            while planner.free() > 0 {
                let Some(block) = blocks.next() else { continue };
                if planner.push(&block).is_err() {
                    break;
                }
            }
            match hands.next() {
                Some(Asked::Override(feed, rapid)) => planner.set_override(feed, rapid),
                Some(Asked::Hold) => planner.hold(),
                Some(Asked::Resume) => planner.resume(),
                None => {}
            }
            planner.tick();
            times.add(began.elapsed().as_nanos() as u64);
        }
        std::thread::sleep(NAP);
    }
    (planner, times)
}

fn main() {
    let seconds: u64 = std::env::args().nth(1).and_then(|s| s.parse().ok()).unwrap_or(60);
    let machine = machine();
    let (planner, mut interpolator) = Motion::halves(&machine, Position::ZERO);
    let mut servo = Servo::new(&machine, Position::ZERO);
    let period = Duration::from_secs_f64(machine.servo_period_ms / 1000.0);
    let (mut work, mut wake) = (Times::default(), Times::default());
    let (mut still, mut way, mut sum) = (0u64, 0.0, 0.0);
    let is_over = AtomicBool::new(false);
    let planned = std::thread::scope(|scope| {
        let thread = scope.spawn(|| plan(planner, &is_over));
        let mut due = Instant::now() + period;
        for _ in 0..seconds * 1000 {
            // Sleeping ends late by what the system needs; the last part is waited for awake.
            while let Some(left) = due.checked_duration_since(Instant::now()) {
                if left > Duration::from_micros(150) {
                    std::thread::sleep(left - Duration::from_micros(120));
                } else {
                    std::hint::spin_loop();
                }
            }
            let began = Instant::now();
            let sample = interpolator.tick();
            let command = servo.tick(&sample.position, Kind::Cutting);
            let fault = servo.supervise(&command.drive);
            work.add(began.elapsed().as_nanos() as u64);
            wake.add((began - due).as_nanos() as u64);
            still += u64::from(sample.velocity == 0.0);
            way += sample.velocity * period.as_secs_f64();
            sum += command.drive.0.iter().sum::<f64>() + f64::from(u8::from(fault.is_some()));
            due += period;
            // The process was stopped: no period is made up for.
            let now = Instant::now();
            if now > due + Duration::from_secs(1) {
                due = now;
            }
        }
        is_over.store(true, Ordering::Relaxed);
        thread.join()
    });
    println!(
        "{seconds} s of periods of {} ms, {way:.0} mm, at rest in {still} (sum {sum:.3})",
        machine.servo_period_ms
    );
    println!("work of a period: {}", work.text());
    println!("woken up late by: {}", wake.text());
    if let Ok((planner, times)) = planned {
        println!("planning:         {}", times.text());
        println!("periods that were not decided in time: {}", planner.late());
    }
}
