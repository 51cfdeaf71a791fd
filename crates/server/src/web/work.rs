//! Work that takes a while: on threads apart, few at once, and ended when nobody waits for it any more.

use super::problem::Problem;
use std::sync::Arc;
use std::sync::atomic::{AtomicBool, AtomicUsize, Ordering};
use std::time::{Duration, Instant};
use tokio::sync::Semaphore;

/// Works at once, and those that may wait for their turn.
const AT_ONCE: usize = 2;
const MOST_WAITING: usize = 8;

/// How long one may take.
const LONGEST: Duration = Duration::from_secs(20);

/// Steps of a program between two looks whether somebody still waits for what is made of it.
pub(super) const LOOK_STEPS: u64 = 256;

static TURNS: Semaphore = Semaphore::const_new(AT_ONCE);
static WAITING: AtomicUsize = AtomicUsize::new(0);

/// Whether a work is still wanted.
#[derive(Clone)]
pub(crate) struct Wanted {
    gone: Arc<AtomicBool>,
    until: Instant,
}

impl Wanted {
    /// False once who asked for it is gone, or it has taken too long.
    pub fn is(&self) -> bool {
        !self.gone.load(Ordering::Relaxed) && Instant::now() < self.until
    }
}

/// Set when it is dropped: with the request.
struct Request(Arc<AtomicBool>);

impl Drop for Request {
    fn drop(&mut self) {
        self.0.store(true, Ordering::Relaxed);
    }
}

/// A place in the queue, given back when dropped.
struct Place;

impl Place {
    fn take() -> Option<Place> {
        let place = Place;
        // The place gives itself back where there was no room.
        (WAITING.fetch_add(1, Ordering::Relaxed) < MOST_WAITING + AT_ONCE).then_some(place)
    }
}

impl Drop for Place {
    fn drop(&mut self) {
        WAITING.fetch_sub(1, Ordering::Relaxed);
    }
}

/// Does a work on a thread apart. It asks now and then whether it is still wanted.
pub(crate) async fn work<T: Send + 'static>(
    work: impl FnOnce(&Wanted) -> T + Send + 'static,
) -> Result<T, Problem> {
    let place = Place::take().ok_or(Problem::Busy)?;
    let turn = TURNS.acquire().await.map_err(|_| Problem::Busy)?;
    let gone = Arc::new(AtomicBool::new(false));
    let request = Request(gone.clone());
    let wanted = Wanted { gone, until: Instant::now() + LONGEST };
    // The turn ends with the work, not with the request.
    let done = tokio::task::spawn_blocking(move || {
        let done = work(&wanted);
        drop((turn, place));
        done
    });
    let done = done.await.map_err(|_| Problem::Busy);
    drop(request);
    done
}
