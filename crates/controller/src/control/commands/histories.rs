//! Rights, and what happened.

use super::super::Control;
use super::{Answer, named};
use crate::api::{Event, LogLine, PastAlarm, Reply};
use ferrocut_machine::{Alarm, Fault};
use ferrocut_memory::password::Seat;
use ferrocut_memory::{Author, Level, Session};
use std::sync::Arc;

impl Control {
    pub(super) fn kept(&self) -> Result<Arc<ferrocut_memory::Store>, Box<Alarm>> {
        let keeping = self.keeping.as_ref().ok_or_else(|| named(Fault::NotFitted, "memory"))?;
        Ok(keeping.store.clone())
    }

    pub(super) fn log_in(&mut self, level: u8, password: &str, author: &Author) -> Answer {
        let level =
            Level::of(level.into()).ok_or_else(|| named(Fault::ValueImpossible, level.to_string()))?;
        let session = match level {
            Level::Operator => Session::OPERATOR,
            level => {
                let log_in = self.kept()?.log_in(level, password, Seat::Machine, author.name());
                log_in.map_err(|error| error.alarm())?
            }
        };
        Ok(self.admit(author.name(), session))
    }

    /// Gives somebody the rights of a session that the durable memory has given him, until he logs out. For whoever
    /// looks at passwords on another thread than the machine's: that takes longer than a period.
    pub fn admit(&mut self, name: &str, session: Session) -> Reply {
        let level = session.level().number();
        self.sessions.insert(name.to_owned(), session);
        self.event(Event::Level { level });
        Reply::Level { level }
    }

    /// The rights that somebody has logged in with.
    pub fn rights_of(&self, name: &str) -> Option<Session> {
        self.sessions.get(name).cloned()
    }

    pub(super) fn set_password(&mut self, level: u8, password: &str, author: &Author) -> Answer {
        let level =
            Level::of(level.into()).ok_or_else(|| named(Fault::ValueImpossible, level.to_string()))?;
        let set = self.kept()?.set_password(author, level, password, Seat::Machine);
        set.map(|_| Reply::Done).map_err(|error| Box::new(error.alarm()))
    }

    pub(super) fn alarm_history(&self, most: u32) -> Answer {
        let found = self.kept()?.reader().alarms(most.min(1000)).map_err(|error| error.alarm())?;
        let past = |entry: ferrocut_memory::AlarmEntry| PastAlarm {
            time: entry.time,
            id: entry.id,
            program: entry.program,
            line: entry.line,
            values: entry.arguments.into_iter().collect(),
        };
        Ok(Reply::AlarmHistory { alarms: found.into_iter().map(past).collect() })
    }

    pub(super) fn operation_log(&self, most: u32) -> Answer {
        let found = self.kept()?.reader().log(most.min(10_000)).map_err(|error| error.alarm())?;
        let line = |entry: ferrocut_memory::LogEntry| LogLine {
            time: entry.time,
            level: entry.level.map(Level::number),
            who: entry.who,
            item: entry.item,
            name: entry.name,
            from: entry.from,
            to: entry.to,
        };
        Ok(Reply::OperationLog { entries: found.into_iter().map(line).collect() })
    }
}
