//! The whole control, played as an operator plays it, without a ladder: inputs are given as it would give them.

use ferrocut_controller::api::{Activity, Command, Event, Reply, Status};
use ferrocut_controller::signals::Inputs;
use ferrocut_controller::{Control, Mode, Parts};
use ferrocut_machine::Machine;
use ferrocut_memory::{Author, Session};

pub fn person() -> Author {
    Author::Person { session: Session::OPERATOR, name: "panel".into() }
}

/// An operator at a control.
pub struct Shop {
    pub control: Control,
    pub inputs: Inputs,
    pub events: Vec<Event>,
}

impl Shop {
    pub fn new(parameters: &[(&str, f64)]) -> Shop {
        let mut machine = Machine::demo_mill();
        machine.spindle.acceleration_rpm_s = 40_000.0;
        for (name, value) in parameters {
            machine.parameters.insert((*name).to_owned(), *value);
        }
        Shop::of(&machine, Parts::default())
    }

    /// With a machine of another language.
    pub fn in_language(dialect: &str) -> Shop {
        Shop::of(&Machine { dialect: dialect.into(), ..Machine::demo_mill() }, Parts::default())
    }

    /// With a machine and parts of its own.
    pub fn of(machine: &Machine, parts: Parts) -> Shop {
        let control = Control::new(machine, parts).unwrap();
        let mut shop = Shop { control, inputs: Control::free_inputs(Mode::Edit), events: Vec::new() };
        shop.wait(2);
        shop
    }

    pub fn wait(&mut self, periods: usize) -> Status {
        for _ in 0..periods {
            self.control.set_inputs(self.inputs.clone());
            self.control.tick();
        }
        self.events.extend(self.control.events());
        self.control.status()
    }

    pub fn mode(&mut self, mode: Mode) {
        self.inputs.mode = mode;
        self.wait(2);
    }

    pub fn start(&mut self) {
        self.inputs.cycle_start = true;
        self.wait(5);
        self.inputs.cycle_start = false;
        self.wait(1);
    }

    pub fn hold(&mut self) {
        self.inputs.feed_hold = true;
        self.wait(5);
        self.inputs.feed_hold = false;
        self.wait(1);
    }

    pub fn say(&mut self, command: Command) -> Reply {
        self.control.command(command, &person()).unwrap()
    }

    pub fn refused(&mut self, command: Command) -> String {
        self.control.command(command, &person()).unwrap_err().alarm.id
    }

    pub fn store(&mut self, program: &str, text: &str) {
        self.say(Command::Store { program: program.into(), text: text.into() });
    }

    pub fn select(&mut self, program: &str) {
        self.mode(Mode::Auto);
        self.say(Command::Select { program: program.into() });
    }

    /// Until the control does something else than run.
    pub fn until_it_stops(&mut self) -> Status {
        for _ in 0..3000 {
            let status = self.wait(100);
            let is_at_rest = status.feed.actual == 0.0;
            if is_at_rest
                && !matches!(status.activity, Activity::Running | Activity::Returning | Activity::Resetting)
            {
                return status;
            }
        }
        panic!("never stops: {:?}", self.control.status());
    }

    pub fn x(&self) -> f64 {
        self.control.status().position.machine[&'X']
    }

    /// The refusals and alarms told since the last look.
    pub fn told(&mut self) -> Vec<String> {
        let told = std::mem::take(&mut self.events).into_iter().filter_map(|event| match event {
            Event::Alarm { alarm } | Event::Refused { alarm } => Some(alarm.id),
            _ => None,
        });
        told.collect()
    }
}
