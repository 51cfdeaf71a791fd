//! A machining centre with the standard ladder: what its valves, contactors and keys do to its switches.

use ferrocut_controller::signals::{Inputs, Mode, Outputs};
use ferrocut_controller::{Cnc, Event, State, Tick};
use ferrocut_geometry::{Axis, Position};
use ferrocut_interpreter::Interpreter;
use ferrocut_machine::Machine;
use ferrocut_plc::{Address, Limits, Pace, Plc, Program};

const LADDER: &str = include_str!("../../../../machines/standard.lad");
pub const TOOL_CHANGE: &str = include_str!("../../../../machines/tool-change.nc");

/// How long a clamp, a magazine's way and a pocket take, ms.
const CLAMP_MS: u32 = 120;
const WAY_MS: u32 = 400;
const POCKET_MS: u32 = 250;
const PULSE_MS: u32 = 40;

/// Something that moves between two ends in some time.
#[derive(Clone, Copy, Debug, Default)]
struct Way {
    at: u32,
}

impl Way {
    fn to(&mut self, end: bool, ms: u32) {
        self.at = if end { (self.at + 1).min(ms) } else { self.at.saturating_sub(1) };
    }
}

pub struct Mill {
    pub plc: Plc,
    pub cnc: Cnc,
    pub inputs: Inputs,
    pub outputs: Outputs,
    pub events: Vec<Event>,
    /// What runs a period of the NC.
    pub period: fn(&mut Cnc) -> Tick,
    pub at: Position,
    /// Valves and doors as they stand.
    tool: Way,
    magazine: Way,
    a_clamp: Way,
    rotation: u32,
    /// The pocket that stands at the spindle in truth.
    pub pocket: u32,
    /// The axes that stand on a switch: bits of X0.
    pub limits: u8,
    reset_ms: u32,
    pub ms: u32,
    /// M codes in the order in which they were strobed.
    pub codes: Vec<u32>,
}

/// A program with a set-up, on a machine with the standard ladder.
pub fn interpreter(program: &str, setup: &str) -> Interpreter {
    crate::common::interpreter_with(&format!("{program}\n{TOOL_CHANGE}"), setup, |options| {
        options.every_code = true;
        options.tool_change_program = Some(9001);
    })
}

impl Mill {
    pub fn new(program: &str) -> Mill {
        Mill::with(program, "", |_| {})
    }

    pub fn with(program: &str, setup: &str, change: impl Fn(&mut Machine)) -> Mill {
        let mut machine = crate::common::machine();
        machine.handshake.strobe_delay_ms = 2.0;
        change(&mut machine);
        let mut cnc = Cnc::new(&machine, interpreter(program, setup));
        cnc.connect_ladder(&machine);
        let ladder = Program::from_text(LADDER.as_bytes(), &Limits::default()).unwrap();
        let mut mill = Mill {
            plc: Plc::new(ladder, Pace::default()),
            cnc,
            inputs: Inputs::default(),
            outputs: Outputs::default(),
            events: Vec::new(),
            period: Cnc::tick,
            at: Position::ZERO,
            tool: Way { at: CLAMP_MS },
            magazine: Way::default(),
            a_clamp: Way { at: CLAMP_MS },
            rotation: 0,
            pocket: 1,
            limits: 0xFF,
            reset_ms: 0,
            ms: 0,
            codes: Vec::new(),
        };
        for well in [
            "DOOR_CLOSED",
            "LUBE_LEVEL",
            "LUBE_PRESSURE",
            "AIR_PRESSURE",
            "COOLANT_LEVEL",
            "CONVEYOR_OK",
            "DRIVE_OK",
            "*ESP_BUTTON",
        ] {
            mill.machine(well, true);
        }
        for axis in ["*DEC_X", "*DEC_Y", "*DEC_Z", "*DEC_A"] {
            let signal = ferrocut_controller::signals::signal(axis).unwrap();
            mill.plc.memory_mut().set_bit(signal.address, true);
        }
        // The switches of feed 100 % and spindle 100 %.
        mill.turn("SWITCH_FEED", 10);
        mill.turn("SWITCH_SPINDLE", 5);
        mill.run(20);
        mill.press("KEY_R_100");
        mill
    }

    pub fn address(&self, name: &str) -> Address {
        let of_nc = || ferrocut_controller::signals::signal(name).map(|signal| signal.address);
        self.plc.program().signal(name).or_else(of_nc).unwrap_or_else(|| panic!("no signal {name}"))
    }

    /// An input of the machine.
    pub fn machine(&mut self, name: &str, on: bool) {
        let address = self.address(name);
        self.plc.memory_mut().set_bit(address, on);
    }

    pub fn turn(&mut self, switch: &str, position: u8) {
        let address = self.address(switch);
        self.plc.memory_mut().set_byte(address, position);
    }

    pub fn is(&self, name: &str) -> bool {
        self.plc.memory().bit(self.address(name))
    }

    pub fn byte(&self, name: &str) -> u8 {
        self.plc.memory().byte(self.address(name))
    }

    /// What is on among the names.
    pub fn on<'a>(&self, names: &[&'a str]) -> Vec<&'a str> {
        names.iter().copied().filter(|name| self.is(name)).collect()
    }

    pub fn press(&mut self, key: &str) {
        self.machine(key, true);
        self.run(30);
        self.machine(key, false);
        self.run(30);
    }

    /// The key RESET, which is the NC's own.
    pub fn reset(&mut self) {
        self.cnc.reset();
        self.reset_ms = 200;
        self.run(300);
    }

    /// The signal of a reset alone: no program is under way.
    pub fn reset_signal(&mut self) {
        self.reset_ms = 200;
        self.run(300);
    }

    pub fn run(&mut self, ms: u32) {
        for _ in 0..ms {
            self.tick();
        }
    }

    /// Goes on until something is so; how long it took, ms.
    pub fn until(&mut self, what: impl Fn(&Mill) -> bool) -> u32 {
        let begin = self.ms;
        while !what(self) {
            self.tick();
            let state = self.cnc.state();
            assert!(self.ms - begin < 300_000, "never so: {state:?}, codes {:?}", self.outputs.m);
        }
        self.ms - begin
    }

    /// AUTO, cycle start.
    pub fn start(&mut self) {
        self.press("KEY_AUTO");
        self.press("KEY_START");
    }

    /// The program to its end.
    pub fn run_program(&mut self) {
        self.start();
        self.until(|mill| *mill.cnc.state() != State::Running);
        assert_eq!(self.cnc.state(), &State::Ended);
    }

    fn plant(&mut self) {
        let on = |mill: &Mill, name: &str| mill.is(name);
        let (release, to_spindle) = (on(self, "TOOL_RELEASE"), on(self, "MAG_TO_SPINDLE"));
        self.tool.to(!release, CLAMP_MS);
        self.magazine.to(to_spindle, WAY_MS);
        self.a_clamp.to(on(self, "A_CLAMP") && !on(self, "A_RELEASE"), CLAMP_MS);
        let (forward, backward) = (on(self, "MAG_CW"), on(self, "MAG_CCW"));
        assert!(!(forward && backward), "both ways at once");
        if forward || backward {
            assert!(self.magazine.at == 0 || self.tool.at == 0, "the magazine turns with the tool in it");
            self.rotation = (self.rotation + 1) % POCKET_MS;
            if self.rotation == POCKET_MS - PULSE_MS {
                let on = if forward { 0 } else { 14 };
                self.pocket = (self.pocket + on) % 16 + 1;
            }
        } else if self.rotation >= POCKET_MS - PULSE_MS {
            // A notch takes it from the pulse to its place.
            self.rotation = (self.rotation + 1) % POCKET_MS;
        }
        assert!(!(self.tool.at < CLAMP_MS && self.magazine.at < WAY_MS), "the tool falls");
        for (name, is_so) in [
            ("TOOL_CLAMPED", self.tool.at == CLAMP_MS),
            ("TOOL_LOOSE", self.tool.at == 0),
            ("MAG_AT_SPINDLE", self.magazine.at == WAY_MS),
            ("MAG_AWAY", self.magazine.at == 0),
            ("A_CLAMPED", self.a_clamp.at == CLAMP_MS),
            ("A_LOOSE", self.a_clamp.at == 0),
            ("POCKET_PULSE", self.rotation >= POCKET_MS - PULSE_MS),
        ] {
            self.machine(name, is_so);
        }
        let limits = self.address("*LX+");
        self.plc.memory_mut().set_byte(Address { bit: None, ..limits }, self.limits);
    }

    /// One servo period: machine to ladder, ladder to NC, NC to ladder.
    pub fn tick(&mut self) {
        self.ms += 1;
        self.plant();
        assert_eq!(self.plc.scan().stop, None);
        let inputs = Inputs::read(self.plc.memory());
        self.obey(&inputs);
        self.cnc.hear(&inputs);
        let tick = (self.period)(&mut self.cnc);
        self.at = tick.position;
        self.events.extend(self.cnc.events());
        self.inputs = inputs;
        self.tell();
        self.outputs.write(self.plc.memory_mut());
    }

    /// What a panel asks of the NC.
    fn obey(&mut self, inputs: &Inputs) {
        let was = &self.inputs;
        if inputs.emergency_stop {
            if !was.emergency_stop {
                self.cnc.emergency_stop();
            }
            return;
        }
        if inputs.feed_hold {
            self.cnc.feed_hold();
        } else if was.cycle_start && !inputs.cycle_start && inputs.mode.is_automatic() && !inputs.start_lock {
            self.cnc.cycle_start();
        }
        self.cnc.set_override(inputs.feed_override, inputs.rapid_override.factor().unwrap_or(0.1));
    }

    fn tell(&mut self) {
        let state = self.cnc.state();
        let (inputs, o) = (&self.inputs, &mut self.outputs);
        let strobe = o.m.strobe;
        self.reset_ms = self.reset_ms.saturating_sub(1);
        let alarm = matches!(state, State::Alarmed(_)) || inputs.emergency_stop;
        *o = Outputs {
            mode: inputs.mode,
            ready: true,
            servo_ready: !inputs.emergency_stop,
            alarm,
            reset: self.reset_ms > 0,
            automatic: matches!(state, State::Running | State::Held | State::Stopped(_)),
            running: *state == State::Running,
            held: *state == State::Held,
            dry_run: inputs.dry_run,
            block_skip: inputs.block_skip,
            machine_lock: inputs.machine_lock,
            single_block: inputs.single_block,
            auxiliary_lock: inputs.auxiliary_lock,
            ..Outputs::default()
        };
        o.at_reference[2] = self.at[Axis::Z] == 0.0;
        self.cnc.tell(o);
        if o.m.strobe && !strobe {
            self.codes.push(o.m.code);
        }
    }

    pub fn mode(&self) -> Mode {
        self.outputs.mode
    }
}
