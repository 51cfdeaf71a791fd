//! Who is in command, and who asks for it: one commands, others watch, and nobody takes command from another.

use crate::told::Asking;
use std::collections::HashMap;
use std::time::{Duration, Instant};

/// How long who was declined, or took back what he asked, waits until he may ask again.
pub const AGAIN: Duration = Duration::from_secs(5);

/// A person: all connections of one session, or one connection that has no session.
#[derive(Clone, Copy, PartialEq, Eq, Hash, Debug)]
pub enum Person {
    /// A browser's session, by its number.
    Session(u64),
    /// A connection, by its number.
    Connection(u64),
}

/// Who is in command, and who asks for it.
#[derive(Default)]
pub struct Helm {
    holder: Option<u64>,
    /// Those who ask, first come first.
    asking: Vec<(Person, Asking)>,
    /// Since when those wait who may not ask again yet.
    waiting: HashMap<Person, Instant>,
}

impl Helm {
    /// The connection in command.
    pub fn holder(&self) -> Option<u64> {
        self.holder
    }

    /// Those who ask for command.
    pub fn asking(&self) -> Vec<Asking> {
        self.asking.iter().map(|(_, asking)| asking.clone()).collect()
    }

    /// A connection takes command, which nobody has. Whether it did not have it before; else who has it.
    pub fn take(&mut self, connection: u64) -> Result<bool, u64> {
        match self.holder {
            Some(other) if other != connection => Err(other),
            Some(_) => Ok(false),
            None => {
                self.holder = Some(connection);
                Ok(true)
            }
        }
    }

    /// Command is nobody's. Who asked for it may take it now, if he still wants it: it is given to none by itself.
    pub fn leave(&mut self) {
        self.holder = None;
        self.asking.clear();
    }

    /// A connection asks the one in command for it; a code where it may not. `Ok(false)`: it asks already.
    pub fn ask(&mut self, person: Person, asking: Asking, now: Instant) -> Result<bool, &'static str> {
        self.waiting.retain(|_, since| now.saturating_duration_since(*since) < AGAIN);
        match self.holder {
            None => return Err("free"),
            Some(holder) if holder == asking.connection => return Err("in_command"),
            Some(_) => {}
        }
        match self.asking.iter().find(|(other, _)| *other == person) {
            Some((_, pending)) if pending.connection == asking.connection => return Ok(false),
            Some(_) => return Err("asks_already"),
            None => {}
        }
        if self.waiting.contains_key(&person) {
            return Err("asked_lately");
        }
        self.asking.push((person, asking));
        Ok(true)
    }

    /// What a connection asked is done with, whatever came of it; he waits until he may ask again. Whether it did ask.
    pub fn settle(&mut self, connection: u64, now: Instant) -> bool {
        let at = self.asking.iter().position(|(_, asking)| asking.connection == connection);
        let Some(at) = at else { return false };
        let (person, _) = self.asking.remove(at);
        self.waiting.insert(person, now);
        true
    }

    /// The one in command hands over to one who asks for it. Others go on asking.
    pub fn hand_over(&mut self, from: u64, to: u64) -> Result<(), &'static str> {
        self.may_answer(from, to)?;
        self.asking.retain(|(_, asking)| asking.connection != to);
        self.holder = Some(to);
        Ok(())
    }

    /// The one in command declines what another asks.
    pub fn decline(&mut self, from: u64, to: u64, now: Instant) -> Result<(), &'static str> {
        self.may_answer(from, to)?;
        self.settle(to, now);
        Ok(())
    }

    /// Whether a connection is in command and the other asks for it; else the code of what is wrong.
    pub fn may_answer(&self, from: u64, to: u64) -> Result<(), &'static str> {
        match () {
            () if self.holder != Some(from) => Err("not_in_command"),
            () if self.asking.iter().all(|(_, asking)| asking.connection != to) => Err("does_not_ask"),
            () => Ok(()),
        }
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    fn asking(connection: u64) -> Asking {
        Asking { connection, from: String::new(), level: 0 }
    }

    #[test]
    fn command_goes_to_who_asks_by_the_hand_of_who_has_it_alone() {
        let (mut helm, now) = (Helm::default(), Instant::now());
        let ask = |helm: &mut Helm, number| helm.ask(Person::Connection(number), asking(number), now);
        assert_eq!(ask(&mut helm, 2), Err("free"));
        assert_eq!((helm.take(1), helm.take(1), helm.take(2)), (Ok(true), Ok(false), Err(1)));
        assert_eq!(ask(&mut helm, 1), Err("in_command"));
        assert_eq!(helm.hand_over(1, 2), Err("does_not_ask"));
        assert_eq!(
            (ask(&mut helm, 2), ask(&mut helm, 2), ask(&mut helm, 3)),
            (Ok(true), Ok(false), Ok(true))
        );
        for thief in [2, 3, 4] {
            assert_eq!(helm.hand_over(thief, 2), Err("not_in_command"));
            assert_eq!(helm.decline(thief, 3, now), Err("not_in_command"));
            assert_eq!(helm.take(thief), Err(1));
        }
        assert_eq!(helm.hand_over(1, 2), Ok(()));
        assert_eq!((helm.holder(), helm.asking()), (Some(2), vec![asking(3)]));
        assert_eq!(helm.hand_over(1, 3), Err("not_in_command"));
        helm.leave();
        assert_eq!((helm.holder(), helm.asking()), (None, vec![]));
    }

    #[test]
    fn a_person_asks_once_and_not_again_at_once() {
        let (mut helm, now) = (Helm::default(), Instant::now());
        let person = Person::Session(7);
        helm.take(1).unwrap();
        assert_eq!(helm.ask(person, asking(2), now), Ok(true));
        assert_eq!(helm.ask(person, asking(3), now), Err("asks_already"), "in another window");
        assert_eq!(helm.decline(1, 2, now), Ok(()));
        let soon = now + AGAIN - Duration::from_millis(1);
        assert_eq!(helm.ask(person, asking(3), soon), Err("asked_lately"));
        assert_eq!(helm.ask(Person::Session(8), asking(4), soon), Ok(true));
        assert_eq!(helm.ask(person, asking(3), now + AGAIN), Ok(true));
        // Its connection ends.
        assert!(helm.settle(3, now + AGAIN) && !helm.settle(3, now + AGAIN));
        assert_eq!(helm.asking(), [asking(4)]);
        assert_eq!(helm.ask(person, asking(5), now + AGAIN), Err("asked_lately"));
    }
}
