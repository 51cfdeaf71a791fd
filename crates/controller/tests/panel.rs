//! The whole control with the standard ladder and the simulated machine, played through the keys of the panel alone.
#![allow(missing_docs, clippy::unwrap_used, clippy::panic, clippy::indexing_slicing)]

use ferrocut_controller::api::{Activity, Command, Event, Reply, Status};
use ferrocut_controller::{Control, Mode, Parts, Plant};
use ferrocut_geometry::Position;
use ferrocut_machine::Machine;
use ferrocut_memory::{Author, Session};
use ferrocut_plc::{Limits, Program};

const LADDER: &str = include_str!("../../../machines/standard.lad");

struct Mill {
    control: Control,
    events: Vec<Event>,
}

impl Mill {
    fn power_on() -> Mill {
        let machine = Machine::demo_mill();
        let parts = Parts {
            ladder: Some(Program::from_text(LADDER.as_bytes(), &Limits::default()).unwrap()),
            drives: Some(Box::new(Plant::new(&machine, Position::ZERO, Position::ZERO))),
            ..Parts::default()
        };
        let mut mill = Mill { control: Control::new(&machine, parts).unwrap(), events: Vec::new() };
        mill.say(Command::Switch { switch: "SWITCH_FEED".into(), position: 10 });
        mill.say(Command::Switch { switch: "SWITCH_SPINDLE".into(), position: 5 });
        mill.wait(100);
        mill.press("KEY_R_100");
        mill
    }

    fn say(&mut self, command: Command) -> Reply {
        let author = Author::Person { session: Session::OPERATOR, name: "panel".into() };
        self.control.command(command, &author).unwrap()
    }

    fn wait(&mut self, periods: usize) -> Status {
        for _ in 0..periods {
            self.control.tick();
        }
        self.events.extend(self.control.events());
        self.control.status()
    }

    fn key(&mut self, key: &str, down: bool) {
        self.say(Command::Key { key: key.into(), down });
        self.wait(60);
    }

    fn press(&mut self, key: &str) {
        self.key(key, true);
        self.key(key, false);
    }

    fn until(&mut self, what: &str, is: impl Fn(&Status) -> bool) -> Status {
        for _ in 0..4000 {
            let status = self.wait(50);
            if is(&status) {
                return status;
            }
        }
        panic!("never {what}: {:?}\n{:?}", self.control.status(), self.events);
    }
}

#[test]
fn a_shift_through_the_keys() {
    let mut mill = Mill::power_on();
    mill.press("KEY_EDIT");
    assert_eq!(mill.wait(1).mode, Mode::Edit);
    assert!(mill.wait(1).referenced.is_empty() || !mill.wait(1).referenced.contains(&'X'));

    // Every axis to its reference point; the lamps tell.
    mill.press("KEY_HOME");
    for key in ["KEY_Z+", "KEY_X+", "KEY_Y+"] {
        mill.key(key, true);
        mill.wait(200);
        mill.key(key, false);
    }
    let status =
        mill.until("homed", |status| ['X', 'Y', 'Z'].iter().all(|axis| status.referenced.contains(axis)));
    assert!(status.lamps.contains(&"LAMP_HOME".to_owned()), "{:?}", status.lamps);

    // Jog, with a lamp for the mode.
    mill.press("KEY_JOG");
    let before = mill.wait(1).position.machine[&'X'];
    mill.key("KEY_X-", true);
    mill.wait(600);
    mill.key("KEY_X-", false);
    let status = mill.until("at rest", |status| status.activity == Activity::Idle);
    assert!(status.position.machine[&'X'] < before - 5.0, "{before} {:?}", status.position);

    // MDI: the spindle by the ladder.
    mill.press("KEY_MDI");
    mill.say(Command::Mdi { text: "M3 S600\nG4 X1\nM5".into() });
    mill.press("KEY_START");
    mill.until("turning", |status| status.spindle.told == 600.0);
    let status = mill.until("done", |status| status.activity == Activity::Idle);
    assert_eq!(status.spindle.told, 0.0);

    // AUTO with hold and single block.
    mill.press("KEY_AUTO");
    let text = "G91 G1 X-20 F1200\nX-5\nM30\n".to_owned();
    mill.say(Command::Store { program: "O0001".into(), text });
    mill.say(Command::Select { program: "O1".into() });
    let from = mill.wait(1).position.machine[&'X'];
    mill.press("KEY_START");
    mill.wait(200);
    mill.press("KEY_HOLD");
    let status = mill.until("held", |status| status.activity == Activity::Held && status.feed.actual == 0.0);
    assert!(status.lamps.contains(&"LAMP_HOLD".to_owned()), "{:?}", status.lamps);
    mill.press("KEY_SINGLE");
    mill.press("KEY_START");
    let status = mill.until("at the end of the block", |status| status.activity == Activity::BlockEnd);
    assert!((status.position.machine[&'X'] - from + 20.0).abs() < 1e-9);
    mill.press("KEY_SINGLE");
    mill.press("KEY_START");
    let status = mill.until("done", |status| status.activity == Activity::Idle);
    assert_eq!(status.counters.parts, 1);
    assert!((status.position.machine[&'X'] - from + 25.0).abs() < 1e-9);

    // Emergency stop in a cut; nothing moves until it is released and reset.
    mill.press("KEY_START");
    mill.wait(200);
    mill.say(Command::EmergencyStop { pressed: true });
    let status = mill.wait(300);
    assert_eq!((status.activity, status.feed.actual), (Activity::Emergency, 0.0));
    mill.press("KEY_START");
    assert_eq!(mill.wait(100).position.machine, status.position.machine);
    mill.say(Command::EmergencyStop { pressed: false });
    mill.wait(50);
    mill.say(Command::Reset);
    mill.until("well", |status| status.activity == Activity::Idle && status.alarms.is_empty());
}
