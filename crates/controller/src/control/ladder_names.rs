//! What the control reads of a ladder in every period or tells of it, looked up by name once for each ladder that runs.

use super::Control;
use super::commands::named;
use crate::api::Event;
use crate::signals;
use ferrocut_machine::Fault;
use ferrocut_memory::Item;
use ferrocut_plc::list::Symbol;
use ferrocut_plc::{Address, Area, Plc, Program};
use std::collections::BTreeMap;

/// The key of the panel that releases overtravel, by the ladder's name.
const OVERTRAVEL_KEY: &str = "KEY_OT";

/// The first of the signals by which a ladder passes home switches on, all in one byte.
const HOME_SWITCH: &str = "*DEC1";

/// A message of the machine, area A.
struct Message {
    name: String,
    address: Address,
    is_on: bool,
    /// When the history last got it, ms since 1970.
    logged: i64,
}

/// A message that comes again within this time, ms, is the same in the history: one that flickers would push the
/// others out of it.
const SAME_MESSAGE: i64 = 10_000;

/// What was looked up.
#[derive(Default)]
pub(super) struct LadderNames {
    /// The ladder that it is of: how often it was exchanged; none before the first look.
    exchanges: Option<u64>,
    overtravel_key: Option<Address>,
    /// Whether it writes the home switches.
    pub has_home_switches: bool,
    messages: Vec<Message>,
    /// Lamps of the panel and of the tower, and the panel's switches.
    lamps: Vec<(String, Address)>,
    switches: Vec<(String, Address)>,
}

impl LadderNames {
    /// Whether the key that releases overtravel is pressed.
    pub fn releases_overtravel(&self, plc: &Plc) -> bool {
        self.overtravel_key.is_some_and(|key| plc.memory().bit(key))
    }

    /// Whether names are of another ladder than the one that runs.
    fn is_old(&self, plc: &Plc) -> bool {
        self.exchanges != Some(plc.exchanges())
    }

    /// Looks names up anew. Messages that this ladder does not have have gone: their names are given.
    fn renew(&mut self, plc: &Plc) -> Vec<String> {
        self.exchanges = Some(plc.exchanges());
        let program: &Program = plc.program();
        self.overtravel_key = program.signal(OVERTRAVEL_KEY).filter(|key| key.bit.is_some());
        self.has_home_switches =
            signals::signal(HOME_SWITCH).is_some_and(|first| program.writes(first.address));
        let before = std::mem::take(&mut self.messages);
        let was_on = |name: &str| before.iter().any(|message| message.is_on && message.name == name);
        let symbols = program.symbols().iter();
        self.messages = symbols
            .filter(|symbol| symbol.address.area == Area::A && symbol.address.bit.is_some())
            .map(|symbol| Message {
                name: symbol.name.clone(),
                address: symbol.address,
                is_on: was_on(&symbol.name),
                logged: 0,
            })
            .collect();
        let named = |is_one: fn(&Symbol) -> bool| {
            let symbols = program.symbols().iter().filter(|symbol| is_one(symbol));
            symbols.map(|symbol| (symbol.name.clone(), symbol.address)).collect()
        };
        self.lamps = named(|symbol| {
            let is_lamp = ["LAMP_", "TOWER_"].iter().any(|kind| symbol.name.starts_with(kind));
            is_lamp && symbol.address.area == Area::Y && symbol.address.bit.is_some()
        });
        self.switches = named(|symbol| {
            symbol.name.starts_with("SWITCH_")
                && symbol.address.area == Area::X
                && symbol.address.bit.is_none()
        });
        let is_there = |name: &str| self.messages.iter().any(|message| message.name == name);
        before.iter().filter(|old| old.is_on && !is_there(&old.name)).map(|old| old.name.clone()).collect()
    }

    /// Messages that stand.
    pub(super) fn standing(&self) -> impl Iterator<Item = &str> {
        self.messages.iter().filter(|message| message.is_on).map(|message| message.name.as_str())
    }

    /// Lamps that are lit.
    pub(super) fn lit(&self, plc: &Plc) -> Vec<String> {
        let lit = self.lamps.iter().filter(|(_, lamp)| plc.memory().bit(*lamp));
        lit.map(|(name, _)| name.clone()).collect()
    }

    /// Positions of the panel's switches.
    pub(super) fn switches(&self, plc: &Plc) -> BTreeMap<String, u8> {
        self.switches.iter().map(|(name, switch)| (name.clone(), plc.memory().byte(*switch))).collect()
    }
}

impl Control {
    /// Names of another ladder, once one has come: whoever draws it is told.
    pub(super) fn renew_ladder_names(&mut self) {
        let Some(plc) = self.plc.as_ref().filter(|plc| self.ladder_names.is_old(plc)) else { return };
        let is_first = self.ladder_names.exchanges.is_none();
        for name in self.ladder_names.renew(plc) {
            self.event(Event::MachineMessage { name, on: false });
        }
        if !is_first {
            self.event(Event::Changed { item: Item::Ladder.name().to_owned() });
        }
    }

    /// Messages of the ladder: those with a name come and go as events, and their coming stands in the history of
    /// alarms (GSK990MC part 2, 3.7). Allocates only as they do.
    pub(super) fn tell_machine_messages(&mut self) {
        let Some(plc) = &self.plc else { return };
        let mut told = Vec::new();
        for message in &mut self.ladder_names.messages {
            let on = plc.memory().bit(message.address);
            if std::mem::replace(&mut message.is_on, on) != on {
                let now = ferrocut_memory::items::now();
                // A clock that was set back makes it another one.
                let is_logged = on && !(0..SAME_MESSAGE).contains(&now.saturating_sub(message.logged));
                message.logged = if is_logged { now } else { message.logged };
                told.push((message.name.clone(), on, is_logged));
            }
        }
        for (name, on, is_logged) in told {
            if is_logged {
                let program = self.running_program();
                if let Some(keeping) = &mut self.keeping {
                    keeping.alarm(&named(Fault::MachineMessage, &*name), &program);
                }
            }
            self.event(Event::MachineMessage { name, on });
        }
    }
}
