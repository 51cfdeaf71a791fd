//! Connections that go away: what is held stops, and what runs goes on.
#![allow(missing_docs, clippy::unwrap_used, clippy::panic, clippy::indexing_slicing)]

mod common;

use common::{Place, Socket, control, set_up};
use ferrocut_controller::Tick;
use ferrocut_controller::api::Command;
use ferrocut_geometry::Axis;
use ferrocut_memory::{Author, Session};
use serde_json::json;
use std::net::Shutdown;
use std::sync::atomic::{AtomicU64, Ordering};
use std::sync::{Arc, Mutex};
use std::time::{Duration, Instant};

/// Times for which the computer held up who wanted to run: a thread that sleeps for a millisecond at a time finds
/// them, and the machine's. It ends with its last owner.
#[derive(Clone)]
struct Stalls(Arc<Mutex<Vec<(Instant, Duration)>>>);

impl Stalls {
    /// Later than this is a stall.
    const LATE: Duration = Duration::from_millis(2);

    fn new() -> Stalls {
        let stalls = Stalls(Arc::default());
        let own = Arc::downgrade(&stalls.0);
        std::thread::spawn(move || {
            let mut last = Instant::now();
            while let Some(stalls) = own.upgrade().map(Stalls) {
                std::thread::sleep(Duration::from_millis(1));
                last = stalls.look(last);
            }
        });
        stalls
    }

    /// Notes by how much more than a millisecond has gone since the last look.
    fn look(&self, last: Instant) -> Instant {
        let now = Instant::now();
        let late = (now - last).saturating_sub(Duration::from_millis(1));
        if late > Self::LATE {
            self.0.lock().unwrap().push((now, late));
        }
        now
    }

    /// How long everything may have been held up in a time that began at a moment.
    fn since(&self, moment: Instant, time: Duration) -> Duration {
        let stalls = self.0.lock().unwrap();
        let (from, to) = (moment, moment + time);
        let within = |(end, late): &(Instant, Duration)| {
            let begin = (*end - *late).max(from);
            (*end).min(to).saturating_duration_since(begin)
        };
        stalls.iter().map(within).sum()
    }
}

/// How the X axis moves, as the machine's thread sees it.
#[derive(Clone)]
struct Motion {
    stalls: Stalls,
    began: Instant,
    /// When the axis was last being sped up or kept going, us since `began`.
    pushed: Arc<AtomicU64>,
    /// Periods for which it has stood still.
    rests: Arc<AtomicU64>,
}

impl Motion {
    fn new() -> (Motion, impl FnMut(&Tick) + Send + 'static) {
        let stalls = Stalls::new();
        let motion = Motion { stalls, began: Instant::now(), pushed: Arc::default(), rests: Arc::default() };
        let own = motion.clone();
        let mut last = Instant::now();
        let (mut at, mut velocity, mut acceleration) = (0.0f64, 0.0f64, 0.0f64);
        let watcher = move |tick: &Tick| {
            last = own.stalls.look(last);
            let now = tick.position[Axis::X];
            let (v, was) = ((now - at).abs(), velocity);
            let a = v - was;
            // A stop begins with acceleration that goes down; on its way its end comes up again, below zero.
            if v > 1e-9 && a > -1e-9 && a > acceleration - 1e-9 {
                own.pushed.store(own.began.elapsed().as_micros() as u64, Ordering::Relaxed);
            }
            match v == 0.0 {
                true => own.rests.fetch_add(1, Ordering::Relaxed),
                false => own.rests.swap(0, Ordering::Relaxed),
            };
            (at, velocity, acceleration) = (now, v, a);
        };
        (motion, watcher)
    }

    fn gets_going(&self) {
        let until = Instant::now() + Duration::from_secs(10);
        while self.rests.load(Ordering::Relaxed) != 0 {
            assert!(Instant::now() < until, "it does not move");
            std::thread::sleep(Duration::from_millis(1));
        }
    }

    fn comes_to_rest(&self) {
        let until = Instant::now() + Duration::from_secs(10);
        while self.rests.load(Ordering::Relaxed) < 50 {
            assert!(Instant::now() < until, "it runs and runs");
            std::thread::sleep(Duration::from_millis(1));
        }
    }

    /// How long after a moment, at which it was on its way, the axis was still being pushed.
    fn pushed_after(&self, moment: Instant) -> Taken {
        let pushed = self.began + Duration::from_micros(self.pushed.load(Ordering::Relaxed));
        assert!(pushed + Duration::from_millis(100) > moment, "it did not move");
        self.taken(moment, pushed.saturating_duration_since(moment))
    }

    fn taken(&self, moment: Instant, time: Duration) -> Taken {
        Taken { time, held_up: self.stalls.since(moment, time) }
    }
}

fn jogging(place: &Place) {
    let mut socket = place.socket();
    set_up(&mut socket);
    socket.press("KEY_JOG");
    socket.until("in JOG", |status| status["mode"] == json!("jog"));
}

/// Whether a key is pressed, as the ladder has it.
fn is_pressed(place: &Place, key: &'static str) -> bool {
    let look = place.hub.look(move |panel| {
        let plc = panel.control().plc_mut().unwrap();
        let address = plc.program().signal(key).unwrap();
        plc.memory().bit(address)
    });
    look.unwrap()
}

fn hold(socket: &mut Socket, key: &str) {
    socket.take_command();
    socket.tell(json!({ "do": "key", "key": key, "down": true }));
}

/// How long something took, and for how much of that the computer is known to have let nobody run.
#[derive(Clone, Copy, PartialEq, Eq, PartialOrd, Ord, Debug)]
struct Taken {
    time: Duration,
    held_up: Duration,
}

/// Every one of these is in time. What the computer held up everybody is no work of the machine and is taken off; on
/// one that has nothing else to do that is nothing.
fn assert_below(what: &str, mut times: Vec<Taken>, bound: Duration) {
    times.sort();
    let at = |share: usize| times[(times.len() * share / 100).min(times.len() - 1)].time;
    let held_up = times.iter().map(|taken| taken.held_up).max();
    eprintln!(
        "{what}: {} times, half below {:?}, 99 % {:?}, worst {:?}; held up at most {held_up:?}",
        times.len(),
        at(50),
        at(99),
        at(100)
    );
    let late: Vec<_> = times.iter().filter(|taken| taken.time > bound + taken.held_up).collect();
    assert!(late.is_empty(), "{what}: late are {late:?}");
}

#[test]
fn a_jog_stops_when_its_key_is_let_go_and_when_its_connection_is_lost() {
    let (motion, watcher) = Motion::new();
    let place = Place::watched(watcher);
    jogging(&place);
    let (mut released, mut lost, mut silent) = (Vec::new(), Vec::new(), Vec::new());
    for round in 0..12 {
        let key = if round % 2 == 0 { "KEY_X+" } else { "KEY_X-" };
        let mut socket = place.socket();
        hold(&mut socket, key);
        std::thread::sleep(Duration::from_millis(150));
        let moment = Instant::now();
        socket.say(json!({ "do": "key", "key": key, "down": false }));
        motion.comes_to_rest();
        released.push(motion.pushed_after(moment));

        hold(&mut socket, key);
        std::thread::sleep(Duration::from_millis(150));
        let moment = Instant::now();
        socket.socket.get_ref().shutdown(Shutdown::Both).unwrap();
        motion.comes_to_rest();
        lost.push(motion.pushed_after(moment));

        let mut socket = place.socket();
        hold(&mut socket, key);
        // A page that hangs, or a cable that is pulled: nothing comes any more.
        let moment = Instant::now();
        motion.comes_to_rest_after(Duration::from_millis(100));
        silent.push(motion.pushed_after(moment));
    }
    let is_held = |taken: &Taken| taken.time >= Duration::from_millis(100);
    assert!(silent.iter().all(is_held), "not held at all: {silent:?}");
    assert_below("released", released, Duration::from_millis(50));
    assert_below("lost", lost, Duration::from_millis(250));
    assert_below("silent", silent, Duration::from_millis(250));
}

#[test]
fn a_jog_stops_when_its_key_is_let_go_behind_what_takes_long() {
    let (motion, watcher) = Motion::new();
    let place = Place::watched(watcher);
    jogging(&place);
    // A ladder that takes long to look at.
    let mut long = String::new();
    while long.len() < 3_000_000 {
        long += "RD X0.0\nWRT R0.0\n";
    }
    let mut socket = place.socket();
    let mut released = Vec::new();
    for key in ["KEY_X+", "KEY_X-", "KEY_X+"] {
        hold(&mut socket, key);
        std::thread::sleep(Duration::from_millis(150));
        let moment = Instant::now();
        let check = socket.say(json!({ "do": "check_ladder", "text": long }));
        let let_go = socket.say(json!({ "do": "key", "key": key, "down": false }));
        motion.comes_to_rest();
        released.push(motion.pushed_after(moment));
        // Both are answered, the long one behind.
        let ids: Vec<_> = std::iter::repeat_with(|| socket.hear()["id"].clone())
            .filter(|id| *id == json!(check) || *id == json!(let_go))
            .take(2)
            .collect();
        assert_eq!(ids, [json!(let_go), json!(check)]);
    }
    assert_below("released behind what takes long", released, Duration::from_millis(100));
}

impl Motion {
    /// Waits until it stands still, but first for a time in which it gets going.
    fn comes_to_rest_after(&self, time: Duration) {
        std::thread::sleep(time);
        self.comes_to_rest();
    }
}

#[test]
fn a_thousand_dropped_connections_leave_no_key_pressed_and_no_axis_running() {
    let (motion, watcher) = Motion::new();
    let place = Place::watched(watcher);
    jogging(&place);
    let (mut gone, mut stops) = (Vec::new(), Vec::new());
    for round in 0..1100u64 {
        let key = if round % 2 == 0 { "KEY_X+" } else { "KEY_X-" };
        let mut socket = place.socket();
        hold(&mut socket, key);
        // The axis is on its way in ten rounds of eleven, in the others it may be.
        let runs = round % 11 != 3;
        match runs {
            true => motion.gets_going(),
            false => std::thread::sleep(Duration::from_millis(round * 7 % 10)),
        }
        let moment = Instant::now();
        let mut kept = None;
        match round % 100 {
            // Nothing comes any more; the connection stays.
            99 => kept = Some(socket),
            n if n % 3 == 0 => drop(socket),
            n if n % 3 == 1 => drop(socket.socket.close(None)),
            _ => drop(socket.socket.get_ref().shutdown(Shutdown::Write)),
        }
        while is_pressed(&place, key) {
            assert!(moment.elapsed() < Duration::from_secs(5), "{key} is pressed by nobody, round {round}");
            std::thread::sleep(Duration::from_millis(1));
        }
        gone.push(motion.taken(moment, moment.elapsed()));
        if runs {
            motion.comes_to_rest();
            stops.push(motion.pushed_after(moment));
        }
        drop(kept);
    }
    assert_below("let go", gone, Duration::from_millis(250));
    assert_eq!(stops.len(), 1000);
    assert_below("the stop began", stops, Duration::from_millis(250));
    motion.comes_to_rest();
    // All have left, and the control is as usable as before.
    let mut socket = place.socket();
    socket.take_command();
    let status = socket.until("at rest", |status| status["activity"] == json!("idle"));
    assert_eq!(status["mode"], json!("jog"));
}

/// Positions of each period, as bits.
type Samples = Arc<Mutex<Vec<[u64; 3]>>>;

fn sampler() -> (Samples, impl FnMut(&Tick) + Send + 'static) {
    let samples = Samples::default();
    let own = samples.clone();
    let sample = move |tick: &Tick| {
        let at = [Axis::X, Axis::Y, Axis::Z].map(|axis| tick.position[axis].to_bits());
        own.lock().unwrap().push(at);
    };
    (samples, sample)
}

/// From the first period that moved to the last.
fn moved(samples: &[[u64; 3]]) -> &[[u64; 3]] {
    let first = samples.windows(2).position(|two| two[0] != two[1]).unwrap();
    let last = samples.windows(2).rposition(|two| two[0] != two[1]).unwrap();
    &samples[first..=last + 1]
}

/// About 20 s of lines and arcs.
fn job() -> String {
    let mut text = "G90 G54 G17 G21\n".to_owned();
    for n in 0..20 {
        let x = 2.0 * f64::from(n);
        text += &format!("G1 X{x} Y0 F3000\nG3 X{} Y10 R10\nG1 X{x} Y20\nG2 X{x} Y0 R10\n", x + 10.0);
    }
    text + "M30\n"
}

/// The job without anybody who looks on, as fast as it goes.
fn undisturbed() -> Vec<[u64; 3]> {
    let (samples, mut sample) = sampler();
    let mut control = control(None);
    let author = Author::Person { session: Session::OPERATOR, name: "test".into() };
    let mut say = |control: &mut ferrocut_controller::Control, command: Command, periods: usize| {
        control.command(command, &author).unwrap();
        (0..periods).for_each(|_| sample(&control.tick()));
    };
    let key = |key: &str, down| Command::Key { key: key.into(), down };
    say(&mut control, Command::Switch { switch: "SWITCH_FEED".into(), position: 10 }, 1);
    say(&mut control, Command::Switch { switch: "SWITCH_SPINDLE".into(), position: 5 }, 100);
    for name in ["KEY_R_100", "KEY_AUTO"] {
        say(&mut control, key(name, true), 60);
        say(&mut control, key(name, false), 60);
    }
    say(&mut control, Command::Store { program: "O0001".into(), text: job() }, 1);
    say(&mut control, Command::Select { program: "O0001".into() }, 1);
    say(&mut control, key("KEY_START", true), 60);
    say(&mut control, key("KEY_START", false), 120_000);
    let samples = samples.lock().unwrap();
    moved(&samples).to_vec()
}

#[test]
fn a_hundred_reloads_change_no_sample_of_a_job() {
    let wanted = undisturbed();
    assert!((5_000..60_000).contains(&wanted.len()), "{} periods", wanted.len());
    let (samples, sample) = sampler();
    let place = Place::watched(sample);
    let mut page = place.socket();
    set_up(&mut page);
    page.press("KEY_AUTO");
    page.tell(json!({ "do": "store", "program": "O0001", "text": job() }));
    page.tell(json!({ "do": "select", "program": "O0001" }));
    page.press("KEY_START");
    let running = |status: &serde_json::Value| status["activity"] == json!("running");
    page.until("running", running);
    for reload in 0..100 {
        // What a page does when it is loaded, and then it is gone: closed, or just away.
        match reload % 2 {
            0 => drop(page.socket.close(None)),
            _ => drop(page.socket.get_ref().shutdown(Shutdown::Both)),
        }
        assert_eq!(place.get("/").status, 200);
        page = place.socket();
        page.tell(json!({ "do": "watch", "events": true, "status": true }));
        page.ask(json!({ "do": "programs" }));
        page.ask(json!({ "do": "read", "program": "O0001" }));
        page.ask(json!({ "do": "offsets", "from": 1, "to": 32 }));
        if reload % 4 == 0 {
            assert_eq!(place.get("/api/path?program=O0001").status, 200);
        }
        page.take_command();
    }
    let status = page.status();
    assert!(running(&status), "the job ended before the reloads: {status}");
    page.until("done", |status| status["activity"] == json!("idle"));
    std::thread::sleep(Duration::from_millis(100));
    let samples = samples.lock().unwrap();
    let found = moved(&samples);
    let first = wanted.iter().zip(found).position(|(one, other)| one != other);
    assert_eq!((first, wanted.len()), (None, found.len()), "the first sample that differs");
}
