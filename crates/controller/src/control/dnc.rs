//! DNC: a program from outside (GSK990MC part 2, 11.3), in as many parts as it comes.
//!
//! What is whole before cycle start is held and runs as any program, as often as it is started. What is not is run while
//! it comes: of it the next megabyte is kept and no more, whatever its length. A part for which there is no room is
//! refused, to be sent again; jumps in such a program are alarms, since its lines are not kept.

use super::{Control, Loaded, alarm};
use crate::api::Reply;
use ferrocut_machine::{Alarm, Fault};
use ferrocut_program::{MOST_KEPT, Refused, Text};

/// The program of DNC.
#[derive(Debug, Default)]
pub(super) struct Dnc {
    /// What came before cycle start.
    held: Vec<u8>,
    /// Nothing follows.
    is_whole: bool,
    /// It runs while it comes.
    is_sent: bool,
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
        if last {
            self.dnc.is_whole = true;
            self.cnc.end_text();
        }
        Ok(Reply::Done)
    }

    /// Loads what came for cycle start.
    pub(super) fn start_dnc(&mut self) -> Result<(), Box<Alarm>> {
        if self.dnc.is_sent || self.dnc.held.is_empty() {
            return Err(Box::new(alarm(Fault::NothingToRun)));
        }
        if self.dnc.is_whole {
            let text = Text::from_bytes(self.dnc.held.clone());
            let text = text.map_err(|_| alarm(Fault::FileNotText).with("file", "DNC"))?;
            self.load_text("DNC", text, true)?;
        } else {
            self.load_text("DNC", Text::sent(), true)?;
            let held = std::mem::take(&mut self.dnc.held);
            self.dnc.is_sent = true;
            // There is room for as much as is held.
            self.cnc.append(&held).map_err(|_| alarm(Fault::LineTooLong))?;
        }
        self.loaded = Loaded::Dnc;
        Ok(())
    }
}
