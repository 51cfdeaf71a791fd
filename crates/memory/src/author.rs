//! Who makes a change.

use crate::rights::Level;

/// A person who is logged in with a level, until the level is given back or power goes off. Only
/// [`Store::log_in`](crate::Store::log_in) makes one of a level above the operator's.
#[derive(Clone, PartialEq, Eq, Debug)]
pub struct Session {
    pub(crate) level: Level,
}

impl Session {
    /// The level without a password, which everybody has from power-on (GSK990MC operation 3.4.5).
    pub const OPERATOR: Session = Session { level: Level::Operator };

    /// The level.
    pub fn level(&self) -> Level {
        self.level
    }
}

/// Who makes a change.
#[derive(Clone, PartialEq, Eq, Debug)]
pub enum Author {
    /// A person at a panel. What the level may not, and what parameters forbid, is refused; all is logged.
    Person {
        /// With which level.
        session: Session,
        /// How the log names the person.
        name: String,
    },
    /// A part program (G10, macro variables): parameters are logged.
    Program {
        /// Its name.
        name: String,
    },
    /// The control itself (positions, counters, relays, measured offsets): parameters are logged.
    Control,
    /// Whoever has the files of the control in hand, by the command line: may everything, all is logged.
    Maintenance {
        /// How the log names it.
        name: String,
    },
}

impl Author {
    /// The level that counts; none of who is no person.
    pub fn level(&self) -> Option<Level> {
        match self {
            Author::Person { session, .. } => Some(session.level),
            _ => None,
        }
    }

    /// The name in the log.
    pub fn name(&self) -> &str {
        match self {
            Author::Person { name, .. } | Author::Maintenance { name } => name,
            Author::Program { name } => name,
            Author::Control => "control",
        }
    }

    /// Whether all that it changes is logged, and not parameters alone.
    pub(crate) fn is_logged(&self) -> bool {
        matches!(self, Author::Person { .. } | Author::Maintenance { .. })
    }
}
