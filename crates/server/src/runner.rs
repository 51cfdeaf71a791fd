//! The thread that owns the machine.
//!
//! It does a servo period at each deadline of the real clock, takes commands from a bounded queue between two of them,
//! and publishes how things stand. Nobody else touches the machine, and it waits for nobody: a snapshot that is being
//! looked at is published in the next period.
//!
//! Deadlines are absolute, so that a late period does not shift those after it. It measures its own work and how late it
//! was woken, since the two have other causes: the one is this software's, the other the computer's.

use rustix::mm::{MlockAllFlags, mlockall};
use rustix::process::{Resource, getrlimit};
use rustix::thread::{CapabilitySet, capabilities};
use rustix::time::{ClockId, clock_gettime};
use std::fmt;
use std::io;
use std::process::Stdio;
use std::sync::atomic::{AtomicBool, AtomicU64, Ordering};
use std::sync::mpsc::{Receiver, SyncSender, sync_channel};
use std::sync::{Arc, Mutex, PoisonError};
use std::thread::JoinHandle;
use std::time::{Duration, Instant};

/// Commands that wait at most.
const MOST_COMMANDS: usize = 256;

/// Commands done between two periods at most, so that many of them make no period late.
const COMMANDS_A_PERIOD: usize = 8;

/// Time between two snapshots where nothing happens, and the shortest where much does.
const PUBLISH: Duration = Duration::from_millis(20);
const PUBLISH_NEWS: Duration = Duration::from_millis(2);

/// A snapshot is put off for a period that took longer than this part of its time before it, so many periods at most.
const SHORT: u32 = 40;
const PUT_OFF: u32 = 4;

/// A machine on a thread of its own.
pub trait Owned: Send + 'static {
    /// What it is told.
    type Command: Send + 'static;
    /// How it stands.
    type Snapshot: Send + Sync + 'static;

    /// Called once, in the thread that it is on, before the first period.
    fn begin(&mut self) {}

    /// Does a command.
    fn take(&mut self, command: Self::Command);

    /// Goes on by one servo period.
    fn tick(&mut self);

    /// Looks ahead, in the time that a period leaves.
    fn prepare(&mut self) {}

    /// Called once, behind the last period.
    fn end(&mut self) {}

    /// Whether something happened that should not wait for the next snapshot in turn.
    fn has_news(&self) -> bool;

    /// How it stands, after `taken` commands in all.
    fn snapshot(&mut self, taken: u64) -> Self::Snapshot;
}

/// The newest snapshot.
#[derive(Debug)]
pub struct Latest<S>(Mutex<Arc<S>>);

impl<S> Latest<S> {
    /// The newest snapshot.
    pub fn get(&self) -> Arc<S> {
        self.0.lock().unwrap_or_else(PoisonError::into_inner).clone()
    }

    /// Publishes one, unless someone is just taking the last; whether it did.
    fn put(&self, snapshot: S) -> bool {
        match self.0.try_lock() {
            Ok(mut place) => {
                *place = Arc::new(snapshot);
                true
            }
            Err(_) => false,
        }
    }
}

/// Buckets of a histogram: eight to each doubling, from 1 ns on.
const BUCKETS: usize = 8 * 40;

/// Times, counted so that any share of them can be told within an eighth.
#[derive(Debug)]
pub struct Times {
    counts: Vec<AtomicU64>,
    worst: AtomicU64,
}

impl Default for Times {
    fn default() -> Times {
        Times { counts: (0..BUCKETS).map(|_| AtomicU64::new(0)).collect(), worst: AtomicU64::new(0) }
    }
}

impl Times {
    /// Counts a time.
    fn add(&self, time: Duration) {
        let ns = u64::try_from(time.as_nanos()).unwrap_or(u64::MAX).max(8);
        let doubling = ns.ilog2();
        // The three bits behind the first.
        let part = (ns >> (doubling - 3)) & 7;
        let bucket = (u64::from(doubling - 3) * 8 + part) as usize;
        if let Some(count) = self.counts.get(bucket.min(BUCKETS - 1)) {
            count.fetch_add(1, Ordering::Relaxed);
        }
        self.worst.fetch_max(ns, Ordering::Relaxed);
    }

    /// The longest.
    pub fn worst(&self) -> Duration {
        Duration::from_nanos(self.worst.load(Ordering::Relaxed))
    }

    /// The time that this share of all keeps below, 0 to 1.
    pub fn below(&self, share: f64) -> Duration {
        let counts: Vec<u64> = self.counts.iter().map(|count| count.load(Ordering::Relaxed)).collect();
        let all: u64 = counts.iter().sum();
        let wanted = (all as f64 * share).ceil() as u64;
        let mut sum = 0;
        for (bucket, count) in (0u64..).zip(&counts) {
            sum += count;
            if *count > 0 && sum >= wanted {
                // The upper end of the bucket.
                let ns = (8 + bucket % 8 + 1) << (bucket / 8);
                return Duration::from_nanos(ns).min(self.worst());
            }
        }
        self.worst()
    }

    /// How many were counted.
    pub fn count(&self) -> u64 {
        self.counts.iter().map(|count| count.load(Ordering::Relaxed)).sum()
    }
}

/// How the periods went.
#[derive(Debug, Default)]
pub struct Timing {
    /// Work of a period: commands, tick and snapshot.
    pub work: Times,
    /// What of it the thread computed, by the system's account of its time: without what others took meanwhile.
    pub computing: Times,
    /// Looking ahead behind it.
    pub ahead: Times,
    /// How late periods began.
    pub lateness: Times,
    /// Periods that were not done before the next was due.
    pub missed: AtomicU64,
}

impl fmt::Display for Timing {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        let us = |time: Duration| time.as_secs_f64() * 1e6;
        let shown = |f: &mut fmt::Formatter<'_>, name: &str, times: &Times| {
            write!(f, ", {name} 99.99% {:.0} us worst {:.0} us", us(times.below(0.9999)), us(times.worst()))
        };
        write!(f, "{} periods, {} missed", self.work.count(), self.missed.load(Ordering::Relaxed))?;
        shown(f, "work", &self.work)?;
        shown(f, "computing", &self.computing)?;
        shown(f, "looking ahead", &self.ahead)?;
        shown(f, "woken late", &self.lateness)
    }
}

/// A running machine.
#[derive(Debug)]
pub struct Runner<M: Owned> {
    commands: SyncSender<M::Command>,
    latest: Arc<Latest<M::Snapshot>>,
    timing: Arc<Timing>,
    stops: Arc<AtomicBool>,
    thread: Option<JoinHandle<()>>,
}

impl<M: Owned> Runner<M> {
    /// Starts the thread. With a priority (1 to 99) it runs before all others of the computer (SCHED_FIFO), where the
    /// system lets it; `chrt` of util-linux asks for it.
    pub fn start(mut machine: M, period: Duration, priority: Option<u8>) -> io::Result<Runner<M>> {
        let (commands, received) = sync_channel(MOST_COMMANDS);
        let latest = Arc::new(Latest(Mutex::new(Arc::new(machine.snapshot(0)))));
        let timing = Arc::new(Timing::default());
        let stops = Arc::new(AtomicBool::new(false));
        let mut owner = Owner {
            machine,
            received,
            latest: latest.clone(),
            timing: timing.clone(),
            stops: stops.clone(),
            taken: 0,
        };
        let thread = std::thread::Builder::new().name("machine".to_owned()).spawn(move || {
            if let Some(priority) = priority {
                lock_memory();
                run_before_others(priority, &[]);
            }
            // Its threads are in as much of a hurry as this one; those that come later are not.
            owner.machine.begin();
            if let Some(priority) = priority {
                run_before_others(priority, &["--reset-on-fork"]);
            }
            owner.run(period);
        })?;
        Ok(Runner { commands, latest, timing, stops, thread: Some(thread) })
    }

    /// What commands are given by.
    pub fn commands(&self) -> SyncSender<M::Command> {
        self.commands.clone()
    }

    /// What is published.
    pub fn latest(&self) -> Arc<Latest<M::Snapshot>> {
        self.latest.clone()
    }

    /// How the periods went.
    pub fn timing(&self) -> Arc<Timing> {
        self.timing.clone()
    }

    /// Whether the thread runs.
    pub fn is_alive(&self) -> bool {
        self.thread.as_ref().is_some_and(|thread| !thread.is_finished())
    }
}

impl<M: Owned> Drop for Runner<M> {
    fn drop(&mut self) {
        self.stops.store(true, Ordering::Relaxed);
        if let Some(thread) = self.thread.take() {
            let _ = thread.join();
        }
    }
}

/// Gives the calling thread real-time priority, if the system permits it.
fn run_before_others(priority: u8, how: &[&str]) {
    let thread = rustix::thread::gettid().as_raw_nonzero().to_string();
    let mut chrt = std::process::Command::new("chrt");
    chrt.args(how).args(["-f", "-p", &priority.to_string(), &thread]);
    // Without it the machine runs too, only later at times, which is measured.
    let _ = chrt.stdin(Stdio::null()).stdout(Stdio::null()).stderr(Stdio::null()).status();
}

/// Keeps all memory of the process in place from now on, if the system permits it without a bound: no period waits for a
/// page that it touches for the first time. A bound would refuse memory later, so that is left as it is.
fn lock_memory() {
    let may = capabilities(None).is_ok_and(|of| of.effective.contains(CapabilitySet::IPC_LOCK));
    if may || getrlimit(Resource::Memlock).current.is_none() {
        let _ = mlockall(MlockAllFlags::CURRENT | MlockAllFlags::FUTURE);
    }
}

/// Time that the calling thread has computed.
fn computed() -> Duration {
    let time = clock_gettime(ClockId::ThreadCPUTime);
    Duration::new(u64::try_from(time.tv_sec).unwrap_or(0), u32::try_from(time.tv_nsec).unwrap_or(0))
}

/// What the thread has.
struct Owner<M: Owned> {
    machine: M,
    received: Receiver<M::Command>,
    latest: Arc<Latest<M::Snapshot>>,
    timing: Arc<Timing>,
    stops: Arc<AtomicBool>,
    taken: u64,
}

impl<M: Owned> Owner<M> {
    fn run(mut self, period: Duration) {
        let mut due = Instant::now();
        let mut published = due;
        while !self.stops.load(Ordering::Relaxed) {
            due += period;
            let now = Instant::now();
            match due.checked_duration_since(now) {
                Some(left) => std::thread::sleep(left),
                // The computer slept: go on from here, not in a hurry.
                None if now - due > Duration::from_secs(1) => due = now,
                None => drop(self.timing.missed.fetch_add(1, Ordering::Relaxed)),
            }
            let (began, computed) = (Instant::now(), computed());
            self.timing.lateness.add(began.saturating_duration_since(due));
            let mut news = false;
            for command in self.received.try_iter().take(COMMANDS_A_PERIOD) {
                self.machine.take(command);
                self.taken += 1;
                news = true;
            }
            self.machine.tick();
            news |= self.machine.has_news();
            let wait = if news { PUBLISH_NEWS } else { PUBLISH };
            let since = began.saturating_duration_since(published);
            // A period that had much to do leaves it to the next, but not for ever.
            let may = began.elapsed() < period / SHORT || since >= wait + PUT_OFF * period;
            if since >= wait && may && self.latest.put(self.machine.snapshot(self.taken)) {
                published = began;
            }
            self.timing.work.add(began.elapsed());
            self.timing.computing.add(self::computed().saturating_sub(computed));
            let began = Instant::now();
            self.machine.prepare();
            self.timing.ahead.add(began.elapsed());
        }
        self.machine.end();
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    struct Counter(u64);

    impl Owned for Counter {
        type Command = u64;
        type Snapshot = (u64, u64);
        fn take(&mut self, command: u64) {
            self.0 = command;
        }
        fn tick(&mut self) {
            self.0 += 1;
        }
        fn has_news(&self) -> bool {
            false
        }
        fn snapshot(&mut self, taken: u64) -> (u64, u64) {
            (self.0, taken)
        }
    }

    /// Says that it has ended.
    struct Ends(SyncSender<u32>, u32);

    impl Owned for Ends {
        type Command = ();
        type Snapshot = ();
        fn take(&mut self, (): ()) {}
        fn tick(&mut self) {
            self.1 += 1;
        }
        fn end(&mut self) {
            self.0.send(self.1).unwrap();
        }
        fn has_news(&self) -> bool {
            false
        }
        fn snapshot(&mut self, _: u64) {}
    }

    #[test]
    fn the_machine_is_told_of_the_end_once_behind_the_last_period() {
        let (to, told) = sync_channel(2);
        let runner = Runner::start(Ends(to, 0), Duration::from_millis(1), None).unwrap();
        std::thread::sleep(Duration::from_millis(20));
        drop(runner);
        assert!(told.recv().unwrap() > 0 && told.recv().is_err());
    }

    #[test]
    fn it_runs_at_its_deadlines_and_takes_commands() {
        let runner = Runner::start(Counter(0), Duration::from_millis(1), None).unwrap();
        let began = Instant::now();
        runner.commands().send(1_000_000).unwrap();
        while runner.latest().get().0 < 1_000_050 {
            assert!(began.elapsed() < Duration::from_secs(20));
            std::thread::sleep(Duration::from_millis(1));
        }
        assert!(began.elapsed() >= Duration::from_millis(50) && runner.latest().get().1 == 1);
        assert!(runner.is_alive() && runner.timing().work.count() >= 50);
    }

    #[test]
    fn shares_of_times_are_right_within_an_eighth() {
        let times = Times::default();
        (1..=1000).for_each(|us| times.add(Duration::from_micros(us)));
        let at = |share| times.below(share).as_secs_f64() * 1e6;
        assert!((495.0..=565.0).contains(&at(0.5)), "{}", at(0.5));
        assert!((990.0..=1000.0).contains(&at(0.99)), "{}", at(0.99));
        assert_eq!((times.worst(), times.count()), (Duration::from_millis(1), 1000));
    }
}
