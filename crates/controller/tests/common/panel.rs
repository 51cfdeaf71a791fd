//! The whole control with the standard ladder and the simulated machine, by the keys of its panel.

use ferrocut_controller::api::{Activity, Command, Event, Measurement, Reply, Status};
use ferrocut_controller::signals::ROWS;
use ferrocut_controller::{Control, Parts, Plant};
use ferrocut_geometry::Position;
use ferrocut_machine::Machine;
use ferrocut_memory::{Author, Session, Store};
use ferrocut_plc::{Limits, Program};
use std::collections::BTreeSet;
use std::sync::Arc;

pub const LADDER: &str = include_str!("../../../../machines/standard.lad");

/// A machining centre with its operator.
pub struct Mill {
    pub control: Control,
    /// The rows of signals that were on once, by their first names.
    pub told: BTreeSet<&'static str>,
    pub events: Vec<Event>,
}

impl Mill {
    pub fn power_on() -> Mill {
        let machine = Machine::demo_mill();
        Mill::of(&machine, Plant::new(&machine, Position::ZERO, Position::ZERO), None)
    }

    pub fn of(machine: &Machine, plant: Plant, store: Option<Arc<Store>>) -> Mill {
        let parts = Parts { drives: Some(Box::new(plant)), store, ..Parts::default() };
        let mut mill = Mill::with_ladder(machine, LADDER, parts);
        mill.say(Command::Switch { switch: "SWITCH_FEED".into(), position: 10 });
        mill.say(Command::Switch { switch: "SWITCH_SPINDLE".into(), position: 5 });
        mill.wait(100);
        mill.press("KEY_R_100");
        mill
    }

    /// With another ladder.
    pub fn with_ladder(machine: &Machine, ladder: &str, parts: Parts) -> Mill {
        let ladder = Some(Program::from_text(ladder.as_bytes(), &Limits::default()).unwrap());
        let control = Control::new(machine, Parts { ladder, ..parts }).unwrap();
        Mill { control, told: BTreeSet::new(), events: Vec::new() }
    }

    pub fn say(&mut self, command: Command) -> Reply {
        let author = Author::Person { session: Session::OPERATOR, name: "panel".into() };
        self.control.command(command, &author).unwrap()
    }

    pub fn wait(&mut self, periods: usize) -> Status {
        for _ in 0..periods {
            self.control.tick();
            let memory = self.control.plc_mut().unwrap().memory();
            for row in ROWS.iter().filter(|row| !row.is_read()) {
                let is_on = |n: usize| match row.bytes() {
                    0 => memory.bit(row.address(n)),
                    _ => memory.byte(row.address(n)) != 0,
                };
                if (0..row.names.len()).any(is_on) {
                    self.told.insert(row.names[0]);
                }
            }
        }
        self.events.extend(self.control.events());
        self.control.status()
    }

    pub fn key(&mut self, key: &str, down: bool) {
        self.say(Command::Key { key: key.into(), down });
        self.wait(60);
    }

    pub fn press(&mut self, key: &str) {
        self.key(key, true);
        self.key(key, false);
    }

    /// Every axis to its reference point.
    pub fn home(&mut self) -> Status {
        self.press("KEY_HOME");
        for key in ["KEY_Z+", "KEY_X+", "KEY_Y+"] {
            self.key(key, true);
            self.wait(200);
            self.key(key, false);
        }
        self.until("homed", |status| ['X', 'Y', 'Z'].iter().all(|axis| status.referenced.contains(axis)))
    }

    /// Blocks of MDI, run to their end.
    pub fn mdi(&mut self, text: &str) {
        self.press("KEY_MDI");
        self.say(Command::Mdi { text: text.into() });
        self.press("KEY_START");
        self.until(text, |status| status.activity == Activity::Idle);
    }

    /// Measures in AUTO.
    pub fn measure(&mut self, command: serde_json::Value) -> Measurement {
        self.press("KEY_AUTO");
        self.events.clear();
        self.say(serde_json::from_value(command).unwrap());
        self.press("KEY_START");
        self.until("measured", |status| status.activity == Activity::Idle && !status.measure_ready);
        let measured = self.events.iter().find_map(|event| match event {
            Event::Measured { measured } => Some(measured.clone()),
            _ => None,
        });
        measured.unwrap_or_else(|| panic!("{:?}", self.events))
    }

    pub fn until(&mut self, what: &str, is: impl Fn(&Status) -> bool) -> Status {
        for _ in 0..20_000 {
            let status = self.wait(50);
            if is(&status) {
                return status;
            }
        }
        panic!("never {what}: {:?}\n{:?}", self.control.status(), self.events);
    }
}
