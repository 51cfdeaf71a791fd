//! The ladder that runs: the machine's own, or one that was put in its place while it ran, which is kept (GSK990MC
//! operation 3.4.4) and stands in the operation log (3.7).
//!
//! An exchange holds at once and is kept when the new ladder has run through for the first time. One that stops before is
//! taken out again and was never kept, so that no power-on meets it.

use super::commands::{Answer, named};
use super::keeping::{Keeping, kept_area};
use super::{Control, alarm};
use crate::api::{AlarmInfo, Event, ForcedSignal, Refusal, Reply};
use crate::signals::signals;
use ferrocut_machine::{Alarm, AlarmId, Fault};
use ferrocut_memory::{Author, Change, Level, SignalSize};
use ferrocut_plc::{Address, Area, Error, Limits, Maintenance, Plc, Program};
use ferrocut_program::Span;

/// Most faults of a ladder that one answer tells.
const MOST_FAULTS: usize = 100;

/// The control whose list of alarms has those of ladders (GSK990MC appendix 2, 1001 to 1042).
const CONTROL: &str = "gsk990mc";

/// What the event `changed` calls the signals that are forced.
const FORCED: &str = "forced";

/// What is on the disk of the ladder, or on its way there.
pub(super) struct Kept {
    /// Its text; none is the machine's own.
    text: Option<String>,
    /// Exchanges that were looked at.
    exchanges: u64,
}

impl Kept {
    pub fn of(text: Option<String>) -> Kept {
        Kept { text, exchanges: 0 }
    }
}

impl Keeping {
    /// Another ladder has come and runs: it is kept, by who exchanged it, or the control that took one out.
    pub fn look_at_exchanges(&mut self, plc: &Plc, own: &str, by: &mut Option<Author>) {
        if self.ladder.exchanges == plc.exchanges() || plc.is_on_trial() {
            return;
        }
        self.ladder.exchanges = plc.exchanges();
        let author = by.take().unwrap_or(Author::Control);
        let text = Some(plc.program().text()).filter(|text| text != own);
        if text != self.ladder.text {
            self.ladder.text.clone_from(&text);
            self.put(&author, vec![Change::Ladder { text }]);
        }
    }
}

/// Puts the ladder that was kept in the place of the machine's own, which it is rolled back to; and what is to be said
/// of it.
pub(super) fn at_power_on(kept: &str, plc: &mut Plc) -> Alarm {
    match Program::from_text(kept.as_bytes(), &Limits::default()) {
        Ok(program) => {
            plc.exchange(Box::new(program));
            alarm(Fault::LadderKept).as_warning()
        }
        Err(errors) => unusable(&errors),
    }
}

/// Looks at a ladder. It needs no machine, and takes longer than a period: whoever can does it on another thread.
pub fn check_ladder(text: &str) -> Reply {
    match Program::from_file(text.as_bytes(), &Limits::default()) {
        Ok(program) => Reply::LadderChecked {
            list: Some(program.text()),
            steps: program.steps(),
            faults: Vec::new(),
            count: 0,
        },
        Err(errors) => Reply::LadderChecked {
            list: None,
            steps: 0,
            faults: errors.iter().take(MOST_FAULTS).map(|error| AlarmInfo::of(&alarm_of(error))).collect(),
            count: u32::try_from(errors.len()).unwrap_or(u32::MAX),
        },
    }
}

/// A ladder that is to be run, of a list or of PLCopen XML; else why it cannot be: the alarm of its first fault. It takes
/// longer than a period, as [`check_ladder`].
pub fn ladder_of(text: &str) -> Result<Program, Refusal> {
    exchangeable(text).map_err(|alarm| Refusal::from(*alarm))
}

fn exchangeable(text: &str) -> Result<Program, Box<Alarm>> {
    let too_long = |text: &str| match text.len() > ferrocut_memory::items::limits::LADDER {
        true => Err(Box::new(named(Fault::ValueImpossible, "ladder"))),
        false => Ok(()),
    };
    too_long(text)?;
    let program = Program::from_file(text.as_bytes(), &Limits::default())
        .map_err(|errors| errors.first().map_or_else(|| alarm(Fault::Ladder), alarm_of))?;
    // What is kept of it is its list.
    too_long(&program.text())?;
    Ok(program)
}

fn alarm_of(error: &Error) -> Alarm {
    ladder_alarm(error, Span { line: error.span.line, ..Span::default() })
}

/// A fault of a ladder as the control's alarm, which points at `span`.
pub fn ladder_alarm(error: &Error, span: Span) -> Alarm {
    let alarm = Alarm::new(AlarmId::Dialect(CONTROL, error.fault.number()), Fault::Ladder, span);
    match &error.about {
        Some(about) => alarm.with("word", &**about),
        None => alarm,
    }
}

/// That a ladder that was kept cannot be run.
fn unusable(errors: &[Error]) -> Alarm {
    let line = errors.first().map_or(0, |error| error.span.line);
    alarm(Fault::LadderUnusable).with("line", f64::from(line)).as_warning()
}

impl Control {
    /// Puts the ladder that was restored in the place of the one that runs; the machine's own where none was kept.
    pub(super) fn exchange_for_kept(&mut self, kept: Option<String>) {
        let Some(plc) = &mut self.plc else { return };
        let text = kept.as_ref().unwrap_or(&self.own_ladder);
        let is_another = *text != plc.program().text();
        match Program::from_text(text.as_bytes(), &Limits::default()) {
            Ok(program) if is_another => drop(plc.exchange(Box::new(program))),
            Ok(_) => {}
            Err(errors) => {
                self.tell_of(&unusable(&errors));
            }
        }
        if let Some(keeping) = &mut self.keeping {
            keeping.ladder.text = kept;
        }
    }

    pub(super) fn exchange_ladder(&mut self, text: &str, author: &Author) -> Answer {
        self.fits_exchange(author)?;
        let program = exchangeable(text)?;
        self.put_ladder(program, author)
    }

    /// Whether somebody may exchange the ladder, on a control that has one. Who asks looks at the ladder himself
    /// ([`ladder_of`]), on another thread.
    pub fn may_exchange_ladder(&self, author: &Author) -> Result<(), Refusal> {
        self.fits_exchange(&self.with_rights(author)).map_err(|alarm| Refusal::from(*alarm))
    }

    /// Puts a ladder in the place of the one that runs.
    pub fn take_ladder(&mut self, program: Program, author: &Author) -> Result<Reply, Refusal> {
        self.put_ladder(program, &self.with_rights(author)).map_err(|alarm| Refusal::from(*alarm))
    }

    fn fits_exchange(&self, author: &Author) -> Result<(), Box<Alarm>> {
        self.needs_level(Level::Builder, author)?;
        match self.plc {
            Some(_) => Ok(()),
            None => Err(Box::new(named(Fault::NotFitted, "ladder"))),
        }
    }

    fn put_ladder(&mut self, program: Program, author: &Author) -> Answer {
        self.needs_level(Level::Builder, author)?;
        let plc = self.plc.as_mut().ok_or_else(|| named(Fault::NotFitted, "ladder"))?;
        plc.exchange(Box::new(program));
        self.exchanged_by = Some(author.clone());
        Ok(Reply::Done)
    }

    pub(super) fn roll_back_ladder(&mut self, author: &Author) -> Answer {
        self.needs_level(Level::Builder, author)?;
        let plc = self.plc.as_mut().ok_or_else(|| named(Fault::NotFitted, "ladder"))?;
        if !plc.roll_back() {
            return Err(Box::new(named(Fault::NoSuchName, "ladder")));
        }
        self.exchanged_by = Some(author.clone());
        Ok(Reply::Done)
    }

    pub(super) fn force(&mut self, signal: &str, value: Option<bool>, author: &Author) -> Answer {
        self.needs_level(Level::Builder, author)?;
        let address = self.address(signal)?;
        if let Some(plc) = &mut self.plc {
            let right = Maintenance::granted();
            match value {
                Some(value) => plc.force(&right, address, value),
                None => plc.release(&right, address),
            }
        }
        if let Some(keeping) = &mut self.keeping {
            keeping.put(author, vec![Change::Force { signal: signal.to_owned(), value }]);
        }
        self.event(Event::Changed { item: FORCED.to_owned() });
        Ok(Reply::Done)
    }

    /// 3.4.5: data of the ladder are for level 2.
    pub(super) fn set_signal(
        &mut self,
        signal: &str,
        value: i64,
        bytes: Option<u8>,
        author: &Author,
    ) -> Answer {
        self.needs_level(Level::Builder, author)?;
        let address = self.address(signal)?;
        let area = kept_area(address.area).ok_or_else(|| named(Fault::SignalNotData, signal))?;
        let impossible = || Box::new(named(Fault::ValueImpossible, signal));
        // Times and counts are words.
        let usual = if matches!(address.area, Area::T | Area::C) { 2 } else { 1 };
        let (size, bits) = match (address.bit, bytes) {
            (Some(bit), None) => (SignalSize::Bit(bit), 1),
            (None, bytes @ (None | Some(1 | 2 | 4))) => {
                let bytes = bytes.unwrap_or(usual);
                (SignalSize::Bytes(bytes), 8 * u32::from(bytes))
            }
            _ => return Err(impossible()),
        };
        let least = if bits == 1 { 0 } else { -(1i64 << (bits - 1)) };
        let most = (1i64 << bits) - 1;
        if !(least..=most).contains(&value) {
            let alarm = named(Fault::ValueImpossible, signal);
            return Err(Box::new(alarm.with("min", least as f64).with("max", most as f64)));
        }
        let fits = address.holds(bits.div_ceil(8));
        let value = u32::try_from(value & most).ok().filter(|_| fits).ok_or_else(impossible)?;
        self.change_data(author, Change::Signal { area, first: address.byte, size, value })
    }

    pub(super) fn forced(&self) -> Answer {
        let plc = self.plc.as_ref().ok_or_else(|| named(Fault::NotFitted, "ladder"))?;
        let symbols = plc.program().symbols();
        let name = |address| {
            let own =
                symbols.iter().find(|symbol| symbol.address == address).map(|symbol| symbol.name.clone());
            let of_nc = || signals().find(|signal| signal.address == address);
            own.or_else(|| of_nc().map(|signal| signal.name.to_owned())).unwrap_or_default()
        };
        let signal = |address: Address| ForcedSignal {
            address: address.to_string(),
            name: name(address),
            value: plc.memory().bit(address),
        };
        Ok(Reply::Forced { signals: plc.memory().forced().map(signal).collect() })
    }
}
