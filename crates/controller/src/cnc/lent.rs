//! A value that a thread beside works on: it goes there and comes back, so that nothing is shared and no period waits.

use rtrb::{Consumer, Producer, RingBuffer};
use std::thread::JoinHandle;
use std::time::Duration;

/// How long the thread sleeps before it looks for work again: far less than anybody is ahead. It is not woken, since
/// that takes the system longer than all else in a period.
const NAP: Duration = Duration::from_micros(500);

/// The thread.
pub(super) struct Beside<T: Send + 'static> {
    give: Producer<T>,
    take: Consumer<T>,
    thread: Option<JoinHandle<()>>,
}

impl<T: Send + 'static> Beside<T> {
    /// Starts it; it gets the priority of this one.
    pub fn start(name: &str, work: impl Fn(&mut T) + Send + 'static) -> std::io::Result<Beside<T>> {
        let (give, mut given) = RingBuffer::<T>::new(1);
        let (mut done, take) = RingBuffer::new(1);
        let thread = std::thread::Builder::new().name(name.to_owned()).spawn(move || {
            while !given.is_abandoned() {
                let Ok(mut value) = given.pop() else {
                    std::thread::park_timeout(NAP);
                    continue;
                };
                work(&mut value);
                // There is room: it is the only one.
                let _ = done.push(value);
            }
        })?;
        Ok(Beside { give, take, thread: Some(thread) })
    }

    /// Hands the value over. It comes back as an error where one is there already.
    pub fn lend(&mut self, value: T) -> Result<(), T> {
        self.give.push(value).map_err(|rtrb::PushError::Full(value)| value)
    }

    /// Takes it back, if it is done.
    pub fn fetch(&mut self) -> Option<T> {
        self.take.pop().ok()
    }

    /// Whether the thread has come to its end, so that nothing comes back any more.
    pub fn is_gone(&self) -> bool {
        self.take.is_abandoned()
    }
}

impl<T: Send + 'static> Drop for Beside<T> {
    fn drop(&mut self) {
        // What is told so ends it.
        self.give = RingBuffer::new(1).0;
        if let Some(thread) = self.thread.take() {
            thread.thread().unpark();
            let _ = thread.join();
        }
    }
}
