//! DNC: a program from outside (GSK990MC part 2, 11.3), in as many parts as it comes.
//!
//! What is whole before cycle start is held and runs as any program, as often as it is started. What is not is run while
//! it comes: of it the next megabyte is kept and no more, whatever its length. A part for which there is no room is
//! refused, to be sent again; jumps in such a program are alarms, since its lines are not kept.

use super::programs::Source;
use super::{Control, Loaded, alarm};
use crate::api::{DncStatus, Reply};
use ferrocut_machine::{Alarm, Fault};
use ferrocut_program::{MOST_KEPT, Refused, Text};

/// Bytes of the end of what came that are told: by them who sends it knows his file again.
const TAIL: usize = 64;

/// The program of DNC.
#[derive(Debug, Default)]
pub(super) struct Dnc {
    /// What came before cycle start.
    held: Vec<u8>,
    /// Nothing follows.
    is_whole: bool,
    /// It runs while it comes.
    is_sent: bool,
    /// Bytes that came of it.
    taken: u64,
    /// The end of what came.
    tail: String,
}

impl Dnc {
    /// Counts a part that was taken.
    fn count(&mut self, text: &str) {
        self.taken = self.taken.saturating_add(text.len() as u64);
        self.tail
            .push_str(text.get(text.floor_char_boundary(text.len().saturating_sub(TAIL))..).unwrap_or(text));
        let before = self.tail.ceil_char_boundary(self.tail.len().saturating_sub(TAIL));
        self.tail.drain(..before);
    }
}

impl Control {
    pub(super) fn take_dnc(&mut self, text: &str, first: bool, last: bool) -> Result<Reply, Box<Alarm>> {
        let busy = || Box::new(alarm(Fault::ControlBusy));
        if self.cnc.is_under_way() && self.loaded == Loaded::Dnc {
            return match self.dnc.is_sent && !first && !self.dnc.is_whole {
                true => self.send_on(text, last),
                false => Err(busy()),
            };
        }
        if first {
            self.dnc = Dnc::default();
        } else if self.dnc.is_sent || self.dnc.is_whole {
            // What it would go on was given up, or has its end.
            return Err(busy());
        }
        if self.dnc.held.len().saturating_add(text.len()) > MOST_KEPT {
            return Err(Box::new(alarm(Fault::NoRoomYet)));
        }
        self.dnc.held.extend_from_slice(text.as_bytes());
        self.dnc.count(text);
        self.dnc.is_whole = last;
        Ok(Reply::Done)
    }

    /// A further part of a program that runs.
    fn send_on(&mut self, text: &str, last: bool) -> Result<Reply, Box<Alarm>> {
        self.cnc.append(text.as_bytes()).map_err(|refused| match refused {
            Refused::Full => Box::new(alarm(Fault::NoRoomYet)),
            Refused::LineTooLong => Box::new(alarm(Fault::LineTooLong)),
            Refused::Ended => Box::new(alarm(Fault::ControlBusy)),
        })?;
        self.dnc.count(text);
        if last {
            self.dnc.is_whole = true;
            self.cnc.end_text();
        }
        Ok(Reply::Done)
    }

    /// How far the program has come.
    pub fn dnc_status(&self) -> Option<DncStatus> {
        let dnc = &self.dnc;
        let runs = self.cnc.is_under_way() && self.loaded == Loaded::Dnc;
        let awaited = !dnc.is_whole && (runs || !dnc.is_sent);
        (dnc.taken > 0).then(|| DncStatus { taken: dnc.taken, tail: dnc.tail.clone(), awaited })
    }

    /// Loads what came for cycle start.
    pub(super) fn start_dnc(&mut self) -> Result<(), Box<Alarm>> {
        if self.dnc.is_sent || self.dnc.held.is_empty() {
            return Err(Box::new(alarm(Fault::NothingToRun)));
        }
        if self.dnc.is_whole {
            let text = Text::from_bytes(self.dnc.held.clone());
            let text = text.map_err(|_| alarm(Fault::FileNotText).with("file", "DNC"))?;
            self.load_text("DNC", text, Source::Dnc)?;
        } else {
            self.load_text("DNC", Text::sent(), Source::Dnc)?;
            let held = std::mem::take(&mut self.dnc.held);
            self.dnc.is_sent = true;
            // There is room for as much as is held.
            self.cnc.append(&held).map_err(|_| alarm(Fault::LineTooLong))?;
        }
        self.loaded = Loaded::Dnc;
        Ok(())
    }
}
