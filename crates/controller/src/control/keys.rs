//! Keys of the panel on their way to the ladder.
//!
//! Level 2 of a ladder sees its inputs as they are when it begins, and may take several periods; whoever presses a key does
//! not know when. So each change of a key stands until level 2 has begun with it, and what comes meanwhile waits behind it:
//! a key that is pressed and let go between two scans is pressed for one of them. What level 2 has seen is let go at once,
//! so that keys that move axes while they are held are not held longer.

use ferrocut_plc::{Address, Memory};

/// Changes of one key that wait for level 2 at most, besides the one that stands. Of more, the last press and release that
/// wait fall away; what the key comes to stays.
const MOST: usize = 8;

/// A key whose last change level 2 has not seen.
#[derive(Clone, Copy, Debug)]
struct Unseen {
    key: Address,
    /// Whether it is pressed for the ladder now.
    is_down: bool,
    /// How many changes wait behind that; each is the contrary of the one before.
    waiting: usize,
}

/// The keys that are on their way.
#[derive(Debug, Default)]
pub(super) struct Keys {
    unseen: Vec<Unseen>,
}

impl Keys {
    /// A key is pressed or let go.
    pub fn change(&mut self, memory: &mut Memory, key: Address, down: bool) {
        match self.unseen.iter_mut().find(|unseen| unseen.key == key) {
            Some(unseen) => {
                let comes_to = unseen.is_down == unseen.waiting.is_multiple_of(2);
                if down != comes_to {
                    unseen.waiting = if unseen.waiting == MOST { MOST - 1 } else { unseen.waiting + 1 };
                }
            }
            None if memory.bit(key) == down => {}
            None => {
                memory.set_bit(key, down);
                self.unseen.push(Unseen { key, is_down: down, waiting: 0 });
            }
        }
    }

    /// Level 2 has begun, and seen what stood: what waits comes next.
    pub fn seen(&mut self, memory: &mut Memory) {
        self.unseen.retain_mut(|unseen| {
            let goes_on = unseen.waiting > 0;
            if goes_on {
                unseen.waiting -= 1;
                unseen.is_down = !unseen.is_down;
                memory.set_bit(unseen.key, unseen.is_down);
            }
            goes_on
        });
    }

    /// The ladder stands still and sees nothing: keys are as they are.
    pub fn settle(&mut self, memory: &mut Memory) {
        for unseen in self.unseen.drain(..) {
            memory.set_bit(unseen.key, unseen.is_down == unseen.waiting.is_multiple_of(2));
        }
    }
}
