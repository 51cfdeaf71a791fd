//! The standard ladder through the keys of the panel: X and F as machine and NC set them, Y and G as they see them.
#![allow(missing_docs, clippy::unwrap_used, clippy::panic)]

mod common;

use ferrocut_plc::{Address, Area, Limits, Pace, Plc, Program};

const LADDER: &str = include_str!("../../../machines/standard.lad");
const TABLE: &str = include_str!("../../../docs/plc.md");

/// The machine with its NC: signals by the names that the ladder gives them.
struct Machine(Plc);

impl Machine {
    /// All is well, the spindle stands, the magazine is away; the NC is ready.
    fn new() -> Machine {
        let program = Program::from_text(LADDER.as_bytes(), &Limits::default()).unwrap();
        let mut machine = Machine(Plc::new(program, Pace::default()));
        for axis in ["X", "Y", "Z", "A"] {
            machine.set(&format!("*L{axis}+"), 1);
            machine.set(&format!("*L{axis}-"), 1);
        }
        for input in [
            "DOOR_CLOSED",
            "LUBE_LEVEL",
            "LUBE_PRESSURE",
            "AIR_PRESSURE",
            "COOLANT_LEVEL",
            "CONVEYOR_OK",
            "DRIVE_OK",
            "TOOL_CLAMPED",
            "A_CLAMPED",
            "MAG_AWAY",
            "*ESP_BUTTON",
            "MA",
            "SA",
            "SSTA",
        ] {
            machine.set(input, 1);
        }
        machine.run(5);
        machine
    }

    /// Power is cut and comes on again: what is kept stays, and so do the inputs.
    fn cut_power(&mut self) {
        let program = Program::from_text(LADDER.as_bytes(), &Limits::default()).unwrap();
        let mut plc = Plc::new(program, Pace::default());
        let memory = self.0.memory();
        let inputs =
            (0..32).map(|byte| Address { area: Area::X, byte, bit: None }).map(|at| (at, memory.byte(at)));
        let kept: Vec<(Address, u8)> = memory.kept().chain(inputs).collect();
        kept.into_iter().for_each(|(at, value)| plc.memory_mut().set_byte(at, value));
        self.0 = plc;
        for named in ["MA", "SA", "SSTA"] {
            self.set(named, 1);
        }
    }

    fn at(&self, name: &str) -> Address {
        self.0.program().signal(name).unwrap_or_else(|| panic!("no signal {name}"))
    }

    /// Sets an input of the machine, or what the NC says; nothing else.
    fn set(&mut self, name: &str, value: u8) {
        let address = self.at(name);
        assert!(matches!(address.area, Area::X | Area::F | Area::K | Area::D), "{name}");
        match address.bit {
            Some(_) => self.0.memory_mut().set_bit(address, value != 0),
            None => self.0.memory_mut().set_byte(address, value),
        }
    }

    fn is(&self, name: &str) -> bool {
        self.0.memory().bit(self.at(name))
    }

    fn byte(&self, name: &str) -> u8 {
        self.0.memory().byte(self.at(name))
    }

    fn word(&self, name: &str) -> u16 {
        let low = self.at(name);
        let high = Address { byte: low.byte + 1, ..low };
        u16::from_le_bytes([self.0.memory().byte(low), self.0.memory().byte(high)])
    }

    fn run(&mut self, ms: u32) {
        for _ in 0..ms {
            assert_eq!(self.0.scan().stop, None);
        }
    }

    fn press(&mut self, key: &str) {
        self.set(key, 1);
        self.run(5);
        self.set(key, 0);
        self.run(5);
    }

    /// The NC hands an M code over; whether it is done at once.
    fn m(&mut self, code: u8) -> bool {
        self.set("M_CODE", code);
        self.set("MF", 1);
        self.run(3);
        self.is("FIN")
    }

    /// The NC takes its code away when it is done.
    fn done(&mut self) {
        assert!(self.is("FIN"));
        for strobe in ["MF", "SF", "TF"] {
            self.set(strobe, 0);
        }
        self.run(3);
        assert!(!self.is("FIN"));
    }

    /// What is on among the names.
    fn on<'a>(&self, names: &[&'a str]) -> Vec<&'a str> {
        names.iter().copied().filter(|name| self.is(name)).collect()
    }
}

#[test]
fn the_ladder_compiles_and_leaves_room() {
    let machine = Machine::new();
    let program = machine.0.program();
    assert!(program.steps() < 4_700 && program.first_level_steps() < 100, "{}", program.steps());
    let most = program.symbols().iter().map(|s| s.meaning.len()).min();
    assert!(most > Some(2), "a signal without a meaning");
}

#[test]
fn the_table_of_addresses_is_that_of_the_ladder() {
    let machine = Machine::new();
    let mut rows = 0;
    for symbol in machine.0.program().symbols() {
        // Relays are the ladder's own.
        if symbol.address.area == Area::R {
            continue;
        }
        let row = format!("| `{}` | `{}` | {} |", shown(symbol.address), symbol.name, symbol.meaning);
        assert!(TABLE.contains(&row), "docs/plc.md lacks\n{row}");
        rows += 1;
    }
    let first_cell = |line: &'static str| line.strip_prefix("| `")?.split('`').next();
    // What else the NC has stands in a chapter of its own.
    let of_ladder = TABLE.split("\n## Further signals").next().unwrap();
    let written = of_ladder.lines().filter_map(first_cell).filter(|cell| Address::parse(cell).is_ok());
    assert_eq!(written.count(), rows, "docs/plc.md has rows that the ladder lacks");
}

fn shown(address: Address) -> String {
    let bit = address.bit.map_or_else(String::new, |bit| format!(".{bit}"));
    format!("{:?}{}{bit}", address.area, address.byte)
}

#[test]
fn emergency_stop_and_limits_act_in_level_1() {
    let mut m = Machine::new();
    assert_eq!(
        m.on(&["*ESP", "*ESPA", "*SP", "*IT", "TOWER_RED", "TOWER_YELLOW"]),
        ["*ESP", "*ESPA", "*SP", "*IT", "TOWER_YELLOW"]
    );
    m.set("*ESP_BUTTON", 0);
    m.run(1);
    assert!(!m.is("*ESP") && !m.is("*ESPA") && m.is("TOWER_RED"));
    m.set("*ESP_BUTTON", 1);
    m.run(2);
    // +X on its switch: the NC is told, the key +X is dead, -X leads away.
    m.set("*LX+", 0);
    m.run(2);
    let limits = ["*L1+", "*L1-", "MIT1+", "MIT1-", "LAMP_OT"];
    assert_eq!(m.on(&limits), ["*L1-", "MIT1+", "LAMP_OT"]);
    // In AUTO the key releases nothing.
    m.press("KEY_AUTO");
    m.set("KEY_OT", 1);
    m.run(2);
    assert!(!m.is("*L1+"));
    m.press("KEY_JOG");
    m.set("KEY_OT", 1);
    m.set("KEY_X+", 1);
    m.run(2);
    assert_eq!(m.on(&["*L1+", "JX+", "JX-"]), ["*L1+"]);
    assert!(m.is("MIT1+"), "nor does the handwheel lead on");
    m.set("KEY_X+", 0);
    m.set("KEY_X-", 1);
    m.run(2);
    assert_eq!(m.on(&["*L1+", "JX+", "JX-"]), ["*L1+", "JX-"]);
    m.set("*LX+", 1);
    m.run(2);
    assert!(!m.is("LAMP_OT"));
}

#[test]
fn modes_are_those_of_their_keys() {
    let mut m = Machine::new();
    let bits = ["MD4", "MD2", "MD1", "DNCI", "STEPI", "ZRN"];
    // After power-on JOG.
    assert_eq!(m.on(&bits), ["MD4", "MD1"]);
    for (key, wanted) in [
        ("KEY_AUTO", &["MD1"][..]),
        ("KEY_EDIT", &["MD2", "MD1"]),
        ("KEY_MDI", &[]),
        ("KEY_DNC", &["MD1", "DNCI"]),
        ("KEY_HOME", &["MD4", "MD1", "ZRN"]),
        ("KEY_JOG", &["MD4", "MD1"]),
        ("KEY_STEP", &["MD4", "STEPI"]),
        ("KEY_MPG", &["MD4"]),
    ] {
        m.press(key);
        assert_eq!(m.on(&bits), wanted, "{key}");
    }
    // Lamps tell what the NC says.
    for (says, lamp) in [
        ("MMEM", "LAMP_AUTO"),
        ("MEDT", "LAMP_EDIT"),
        ("MMDI", "LAMP_MDI"),
        ("MRMT", "LAMP_DNC"),
        ("MREF", "LAMP_HOME"),
        ("MJ", "LAMP_JOG"),
        ("MINC", "LAMP_STEP"),
        ("MH", "LAMP_MPG"),
        ("STL", "LAMP_START"),
        ("SPL", "LAMP_HOLD"),
        ("ZP_X", "LAMP_ZERO_X"),
        ("ZP_A", "LAMP_ZERO_A"),
        ("MMLK", "LAMP_MLOCK"),
        ("MDRN", "LAMP_DRY"),
    ] {
        assert!(!m.is(lamp));
        m.set(says, 1);
        m.run(1);
        assert!(m.is(lamp), "{lamp}");
        m.set(says, 0);
        m.run(1);
        assert!(!m.is(lamp), "{lamp}");
    }
}

#[test]
fn switches_turn_over_in_their_modes() {
    let mut m = Machine::new();
    let table = [
        ("KEY_SINGLE", "SBK", "KEY_MDI", "KEY_JOG"),
        ("KEY_SKIP", "BDT", "KEY_AUTO", "KEY_EDIT"),
        ("KEY_OPTSTOP", "OPTS", "KEY_DNC", "KEY_STEP"),
        ("KEY_DRY", "DRN", "KEY_AUTO", "KEY_HOME"),
        ("KEY_MLOCK", "MLK", "KEY_JOG", "KEY_EDIT"),
        ("KEY_AUXLOCK", "AFL", "KEY_AUTO", "KEY_MPG"),
        ("KEY_RESTART", "SRN", "KEY_AUTO", "KEY_MDI"),
        ("KEY_HDRV", "HDRV", "KEY_AUTO", "KEY_MDI"),
    ];
    for (key, signal, mode, other) in table {
        m.press(mode);
        for wanted in [true, false, true] {
            m.press(key);
            assert_eq!(m.is(signal), wanted, "{key}");
        }
        // Held, it turns over once.
        m.set(key, 1);
        m.run(500);
        assert!(!m.is(signal));
        m.set(key, 0);
        m.press(other);
        m.press(key);
        assert!(!m.is(signal), "{key} in a wrong mode");
    }
    for (key, signal) in [("KEY_LIGHT", "LIGHT"), ("KEY_RAPID", "RT")] {
        m.press(key);
        assert!(m.is(signal));
        m.press(key);
        assert!(!m.is(signal));
    }
}

/// GSK990MC part 2, 10.1.9 note 3: after reset the key is pressed anew.
#[test]
fn reset_turns_program_restart_off() {
    let mut m = Machine::new();
    m.press("KEY_AUTO");
    m.press("KEY_RESTART");
    assert!(m.is("SRN"));
    m.set("RESET", 1);
    m.run(20);
    m.set("RESET", 0);
    m.run(20);
    assert!(!m.is("SRN") && !m.is("LAMP_RESTART"));
    m.press("KEY_RESTART");
    assert!(m.is("SRN") && m.is("LAMP_RESTART"));
}

#[test]
fn cycle_start_has_its_interlocks() {
    let mut m = Machine::new();
    m.set("KEY_START", 1);
    m.run(2);
    assert!(!m.is("ST"), "not in JOG");
    m.press("KEY_AUTO");
    m.set("KEY_START", 1);
    m.run(2);
    assert!(m.is("ST"));
    for (input, missing) in [("DOOR_CLOSED", 0), ("AIR_PRESSURE", 0), ("LUBE_LEVEL", 0), ("DRIVE_OK", 0)] {
        m.set(input, missing);
        m.run(3);
        assert!(!m.is("ST") && m.is("STLK"), "{input}");
        m.set(input, 1);
        m.press("RESET");
        m.run(3);
        assert!(m.is("ST"), "{input}");
    }
    m.set("KEY_START", 0);
    // External keys count where K5.1 says so.
    m.set("EXT_START", 1);
    m.run(2);
    assert!(!m.is("ST"));
    m.set("K_EXTERNAL", 1);
    m.run(2);
    assert!(m.is("ST") && m.is("*SP"));
    m.set("EXT_HOLD", 1);
    m.run(2);
    assert!(!m.is("*SP"));
    m.set("EXT_HOLD", 0);
    m.set("KEY_HOLD", 1);
    m.run(1);
    assert!(!m.is("*SP"));
}

#[test]
fn an_open_door_holds_the_feed_and_stops_the_spindle() {
    let mut m = Machine::new();
    m.press("KEY_AUTO");
    m.set("OP", 1);
    m.set("STL", 1);
    m.m(3);
    m.set("SSTA", 0);
    m.set("SARA", 1);
    m.run(2);
    m.done();
    assert_eq!(m.on(&["SPINDLE_CW", "DOOR_LOCK", "TOWER_GREEN"]), ["SPINDLE_CW", "DOOR_LOCK", "TOWER_GREEN"]);
    m.set("DOOR_CLOSED", 0);
    m.run(3);
    assert_eq!(m.on(&["*SP", "SPINDLE_CW", "SFRA", "*SSTP", "MSG_DOOR"]), ["MSG_DOOR"]);
    // Closed again, nothing starts by itself, and the message waits for reset.
    m.set("DOOR_CLOSED", 1);
    m.run(3);
    assert_eq!(m.on(&["*SP", "SPINDLE_CW", "MSG_DOOR"]), ["*SP", "MSG_DOOR"]);
    m.press("RESET");
    assert!(!m.is("MSG_DOOR"));
    // A machine without a door switch.
    m.set("DOOR_CLOSED", 0);
    m.set("K_NO_DOOR", 1);
    m.run(3);
    assert!(m.is("*SP") && m.is("*SSTP") && !m.is("MSG_DOOR"));
    // Unlocked once the program is over and the spindle stands.
    m.set("OP", 0);
    m.set("STL", 0);
    m.run(2);
    assert!(m.is("DOOR_LOCK"));
    m.set("SSTA", 1);
    m.run(2);
    assert!(!m.is("DOOR_LOCK"));
}

#[test]
fn gears_are_shifted_while_the_spindle_stands_and_codes_wait_for_them() {
    let mut m = Machine::new();
    let valves = ["GEAR_SHIFT_1", "GEAR_SHIFT_2", "GEAR_SHIFT_3"];
    m.set("GEAR_IN_1", 1);
    m.press("KEY_AUTO");
    // A machine without gears has none to wait for, whatever the NC asks for.
    m.set("GR2O", 1);
    m.run(3);
    assert!(m.on(&valves).is_empty() && m.is("*SSTP"));
    m.set("GR2O", 0);
    m.set("K_GEARS", 1);
    // It turns in gear 1, as the NC asks.
    m.set("GR1O", 1);
    assert!(!m.m(3));
    m.set("SSTA", 0);
    m.set("SARA", 1);
    m.run(3);
    m.done();
    assert_eq!(m.on(&["SFRA", "*SSTP", "SAR", "GR1", "GR2"]), ["SFRA", "*SSTP", "SAR"]);
    // A speed of gear 3: the spindle is stopped first, its sense stays.
    m.set("GR1O", 0);
    m.set("GR3O", 1);
    m.set("SF", 1);
    m.run(3);
    assert_eq!(m.on(&["SFRA", "*SSTP", "SAR", "FIN"]), ["SFRA"]);
    assert_eq!(m.on(&valves), Vec::<&str>::new());
    m.set("SARA", 0);
    m.set("SSTA", 1);
    m.run(3);
    assert_eq!(m.on(&valves), ["GEAR_SHIFT_3"]);
    m.set("GEAR_IN_1", 0);
    m.run(3);
    assert!(!m.is("FIN"));
    m.set("GEAR_IN_3", 1);
    m.run(3);
    assert_eq!(m.on(&["FIN", "*SSTP", "SFRA", "GR1", "GR2", "SAR"]), ["FIN", "*SSTP", "SFRA", "GR2"]);
    m.set("SF", 0);
    m.run(3);
    assert!(!m.is("FIN"));
    // The valve holds it while the spindle turns; an emergency stop lets go.
    m.set("SSTA", 0);
    m.run(3);
    assert_eq!(m.on(&valves), ["GEAR_SHIFT_3"]);
    m.set("SSTA", 1);
    m.m(5);
    m.done();
    // Gears that the ladder chooses by M41 to M43.
    m.set("GR3O", 0);
    assert!(!m.m(42));
    assert_eq!((m.on(&valves), m.is("*SSTP")), (vec!["GEAR_SHIFT_2"], false));
    m.set("GEAR_IN_3", 0);
    m.set("GEAR_IN_2", 1);
    m.run(3);
    m.done();
    assert_eq!(m.on(&["GR1", "GR2", "*SSTP", "GEAR_SHIFT_2"]), ["GR1", "*SSTP", "GEAR_SHIFT_2"]);
    // It stays in it.
    m.run(50);
    assert_eq!(m.on(&valves), ["GEAR_SHIFT_2"]);
}

#[test]
fn m_codes_of_the_spindle_wait_for_it() {
    let mut m = Machine::new();
    let outputs = ["SPINDLE_CW", "SPINDLE_CCW", "SFRA", "SRVA", "ORCMA"];
    m.press("KEY_AUTO");
    assert!(!m.m(3), "waits for the speed");
    assert_eq!(m.on(&outputs), ["SPINDLE_CW", "SFRA"]);
    m.set("SSTA", 0);
    m.set("SARA", 1);
    m.run(3);
    assert!(m.is("SAR"));
    m.done();
    assert!(m.is("SPINDLE_CW") && m.is("LAMP_SP_CW"));
    m.set("SARA", 0);
    assert!(!m.m(4));
    assert_eq!(m.on(&outputs), ["SPINDLE_CCW", "SRVA"]);
    m.set("SARA", 1);
    m.run(3);
    m.done();
    assert!(!m.m(5), "waits for standstill");
    assert_eq!(m.on(&outputs), Vec::<&str>::new());
    m.set("SSTA", 1);
    m.set("SARA", 0);
    m.run(3);
    m.done();
    // Orientation and its end.
    assert!(!m.m(19));
    assert_eq!(m.on(&outputs), ["ORCMA"]);
    m.set("ORARA", 1);
    m.run(3);
    m.done();
    assert!(m.m(18));
    m.done();
    m.set("ORARA", 0);
    assert!(!m.is("ORCMA"));
    // Rigid tapping.
    assert!(!m.m(29) && m.is("RGTAP"));
    m.set("RTAP", 1);
    m.run(3);
    m.done();
    assert!(m.is("RGTAP"));
    assert!(m.m(28) && !m.is("RGTAP"));
    m.done();
    // Where K0.1 says so, M03 does not wait.
    m.set("K_NO_SPEED", 1);
    assert!(m.m(3));
    m.done();
    // The end of the program stops the spindle, and is done once that stands.
    m.set("DM30", 1);
    m.set("SSTA", 0);
    assert!(!m.m(30));
    assert_eq!(m.on(&outputs), Vec::<&str>::new());
    m.set("SSTA", 1);
    m.run(3);
    m.done();
}

#[test]
fn the_spindle_keys_act_in_manual_modes() {
    let mut m = Machine::new();
    let outputs = ["SPINDLE_CW", "SPINDLE_CCW", "ORCMA", "LAMP_SP_STOP"];
    for mode in ["KEY_JOG", "KEY_STEP", "KEY_MPG"] {
        m.press(mode);
        m.press("KEY_SP_CW");
        assert_eq!(m.on(&outputs), ["SPINDLE_CW"], "{mode}");
        m.press("KEY_SP_CCW");
        assert_eq!(m.on(&outputs), ["SPINDLE_CCW"]);
        m.press("KEY_SP_STOP");
        assert_eq!(m.on(&outputs), ["LAMP_SP_STOP"]);
        m.press("KEY_SP_ORIENT");
        assert_eq!(m.on(&outputs), ["ORCMA"]);
        m.press("KEY_SP_ORIENT");
        assert_eq!(m.on(&outputs), ["LAMP_SP_STOP"]);
    }
    // Jog: only while the key is held.
    m.press("KEY_SP_JOG");
    assert!(m.is("SJOG") && m.is("LAMP_SP_JOG"));
    m.set("KEY_SP_CCW", 1);
    m.run(3);
    assert_eq!(m.on(&outputs), ["SPINDLE_CCW"]);
    m.set("KEY_SP_CCW", 0);
    m.run(3);
    assert_eq!(m.on(&outputs), ["LAMP_SP_STOP"]);
    m.press("KEY_SP_JOG");
    // In AUTO they do nothing, also not the stop key.
    m.press("KEY_SP_CW");
    m.press("KEY_AUTO");
    m.press("KEY_SP_STOP");
    m.press("KEY_SP_CCW");
    assert_eq!(m.on(&outputs), ["SPINDLE_CW"]);
    // Interlocks.
    for input in ["TOOL_CLAMPED", "DRIVE_OK", "*ESP_BUTTON"] {
        m.press("KEY_JOG");
        m.press("KEY_SP_CW");
        assert!(m.is("SPINDLE_CW"));
        m.set(input, 0);
        m.run(3);
        assert_eq!(m.on(&outputs), ["LAMP_SP_STOP"], "{input}");
        m.press("KEY_SP_CW");
        assert_eq!(m.on(&outputs), ["LAMP_SP_STOP"], "{input}");
        m.set(input, 1);
        m.run(3);
    }
}

#[test]
fn auxiliaries_follow_their_codes_and_keys() {
    let mut m = Machine::new();
    for (on, off, output) in [(8, 9, "COOLANT"), (26, 27, "FLUSH"), (35, 36, "CONVEYOR"), (44, 45, "BLOW")] {
        assert!(m.m(on), "M{on}");
        m.done();
        assert!(m.is(output), "M{on}");
        assert!(m.m(off));
        m.done();
        assert!(!m.is(output), "M{off}");
    }
    for (key, output, lamp) in
        [("KEY_COOLANT", "COOLANT", "LAMP_COOLANT"), ("KEY_CHIP", "CONVEYOR", "LAMP_CHIP")]
    {
        m.press(key);
        assert!(m.is(output) && m.is(lamp));
        m.press(key);
        assert!(!m.is(output) && !m.is(lamp));
    }
    // What a program turned on, a key turns off.
    m.m(8);
    m.done();
    m.press("KEY_COOLANT");
    assert!(!m.is("COOLANT"));
    // Reset ends all of them, M30 all but the conveyor.
    for (end, left) in [("RESET", &[][..]), ("DM02", &["CONVEYOR"]), ("DM30", &["CONVEYOR"])] {
        for code in [8, 26, 35, 44] {
            m.m(code);
            m.done();
        }
        m.press(end);
        assert_eq!(m.on(&["COOLANT", "FLUSH", "CONVEYOR", "BLOW"]), left, "{end}");
    }
    // What is missing stops them.
    for code in [8, 26, 35, 44] {
        m.m(code);
        m.done();
    }
    for input in ["COOLANT_LEVEL", "CONVEYOR_OK", "AIR_PRESSURE"] {
        m.set(input, 0);
    }
    m.run(3);
    assert_eq!(m.on(&["COOLANT", "FLUSH", "CONVEYOR", "BLOW"]), Vec::<&str>::new());
    assert_eq!(
        m.on(&["MSG_AIR", "MSG_COOLANT", "MSG_CONVEYOR", "*IT"]),
        ["MSG_AIR", "MSG_COOLANT", "MSG_CONVEYOR"]
    );
    // Codes of nobody are done at once; S too.
    assert!(m.m(50));
    m.done();
    m.set("SF", 1);
    m.run(3);
    m.done();
}

#[test]
fn the_fourth_axis_is_released_and_clamped() {
    let mut m = Machine::new();
    assert!(m.is("A_CLAMP") && !m.is("A_RELEASE"));
    assert!(!m.m(10));
    assert_eq!(m.on(&["A_CLAMP", "A_RELEASE"]), ["A_RELEASE"]);
    m.set("A_CLAMPED", 0);
    m.set("A_LOOSE", 1);
    m.run(3);
    m.done();
    assert!(!m.m(11));
    assert_eq!(m.on(&["A_CLAMP", "A_RELEASE"]), ["A_CLAMP"]);
    m.set("A_LOOSE", 0);
    m.set("A_CLAMPED", 1);
    m.run(3);
    m.done();
}

#[test]
fn overrides_follow_their_switches_and_keys() {
    let mut m = Machine::new();
    for (position, percent) in [(0, 0), (1, 10), (10, 100), (20, 200)] {
        m.set("SWITCH_FEED", 0b1110_0000 | position);
        m.run(2);
        assert_eq!(!m.byte("*FV"), percent);
        assert_eq!(!m.word("*JV"), u16::from(percent) * 100);
    }
    // A position between two contacts is none: the last one stays.
    m.set("SWITCH_FEED", 31);
    m.run(2);
    assert_eq!(!m.byte("*FV"), 200);
    for (position, percent) in [(0, 50), (5, 100), (7, 120)] {
        m.set("SWITCH_SPINDLE", position);
        m.run(2);
        assert_eq!(m.byte("SOV"), percent);
    }
    let rapid = ["ROV1", "ROV2", "LAMP_R_F0", "LAMP_R_25", "LAMP_R_50", "LAMP_R_100"];
    assert_eq!(m.on(&rapid), ["ROV2", "LAMP_R_25"]);
    for (key, wanted) in [
        ("KEY_R_50", &["ROV1", "LAMP_R_50"][..]),
        ("KEY_R_100", &["LAMP_R_100"]),
        ("KEY_R_F0", &["ROV1", "ROV2", "LAMP_R_F0"]),
        ("KEY_R_25", &["ROV2", "LAMP_R_25"]),
    ] {
        m.press(key);
        assert_eq!(m.on(&rapid), wanted, "{key}");
    }
    let wheel = ["HS1A", "HS1B", "HS1C"];
    for (key, wanted) in [
        ("KEY_WY", &["HS1B"][..]),
        ("KEY_WZ", &["HS1A", "HS1B"]),
        ("KEY_WA", &["HS1C"]),
        ("KEY_WX", &["HS1A"]),
    ] {
        m.press(key);
        assert_eq!(m.on(&wheel), wanted, "{key}");
    }
    for (key, wanted) in
        [("KEY_S1", &["MP1"][..]), ("KEY_S2", &["MP2"]), ("KEY_S3", &["MP1", "MP2"]), ("KEY_S0", &[])]
    {
        m.press(key);
        assert_eq!(m.on(&["MP1", "MP2"]), wanted, "{key}");
    }
    for key in ["X+", "X-", "Y+", "Y-", "Z+", "Z-", "A+", "A-"] {
        m.set(&format!("KEY_{key}"), 1);
        m.run(2);
        assert!(m.is(&format!("J{key}")));
        m.set(&format!("KEY_{key}"), 0);
        m.run(2);
        assert!(!m.is(&format!("J{key}")));
    }
}

/// The magazine passes a pocket.
fn pocket(m: &mut Machine) {
    m.set("POCKET_PULSE", 1);
    m.run(20);
    m.set("POCKET_PULSE", 0);
    m.run(20);
}

#[test]
fn a_tool_is_changed_by_its_codes() {
    let mut m = Machine::new();
    m.press("KEY_AUTO");
    // The program of M06: orient, magazine to the spindle, release, turn, clamp, away.
    m.m(19);
    m.set("ORARA", 1);
    m.run(3);
    m.done();
    assert!(!m.m(21) && m.is("MAG_TO_SPINDLE"));
    m.set("MAG_AWAY", 0);
    m.set("MAG_AT_SPINDLE", 1);
    m.run(3);
    m.done();
    // A magazine that holds the tool that is clamped cannot turn, nor go away.
    m.set("T_CODE", 14);
    m.set("TF", 1);
    m.run(3);
    assert_eq!(m.on(&["MAG_CW", "MAG_CCW", "FIN", "MSG_MAGAZINE"]), ["MSG_MAGAZINE"]);
    // Nor is a tool there that is called, be it that of the pocket at the spindle.
    m.set("TF", 0);
    m.run(3);
    m.set("T_CODE", 1);
    m.set("TF", 1);
    m.run(3);
    assert_eq!(m.on(&["MAG_CW", "MAG_CCW", "FIN", "MSG_MAGAZINE"]), ["MSG_MAGAZINE"]);
    m.set("TF", 0);
    m.run(3);
    assert!(!m.is("MSG_MAGAZINE"));
    m.set("T_CODE", 14);
    assert!(!m.m(16) && m.is("TOOL_RELEASE"));
    m.set("TOOL_CLAMPED", 0);
    m.set("TOOL_LOOSE", 1);
    m.run(3);
    m.done();
    assert!(m.is("*IT"), "Z leaves the tool in the magazine");
    assert_eq!((m.byte("TOOL"), m.byte("TSP")), (0, 1), "none");
    // Where it turns the spindle would be in its way.
    m.set("TF", 1);
    m.run(3);
    assert_eq!(m.on(&["MAG_CW", "MAG_CCW", "FIN", "MSG_MAGAZINE"]), ["MSG_MAGAZINE"]);
    m.set("ZP_Z", 1);
    // From pocket 1 to 14 of 16: three backward, over the end.
    m.run(3);
    assert_eq!(m.on(&["MAG_CW", "MAG_CCW", "FIN"]), ["MAG_CCW"]);
    for wanted in [16, 15] {
        pocket(&mut m);
        assert_eq!(m.byte("POCKET"), wanted);
        assert!(!m.is("FIN"));
    }
    pocket(&mut m);
    assert_eq!((m.byte("POCKET"), m.on(&["MAG_CW", "MAG_CCW", "FIN"])), (14, vec!["FIN"]));
    m.done();
    assert!(!m.m(17) && !m.is("TOOL_RELEASE"));
    m.set("TOOL_LOOSE", 0);
    m.set("TOOL_CLAMPED", 1);
    m.run(3);
    m.done();
    assert_eq!((m.byte("TOOL"), m.byte("TSP")), (14, 15));
    assert!(!m.m(22) && !m.is("MAG_TO_SPINDLE"));
    m.set("MAG_AT_SPINDLE", 0);
    m.set("MAG_AWAY", 1);
    m.run(3);
    m.done();
    // Forward over the end: 14 to 2 are four.
    m.set("T_CODE", 2);
    m.set("TF", 1);
    m.run(3);
    assert!(m.is("MAG_CW"));
    for _ in 0..4 {
        assert!(!m.is("FIN"));
        pocket(&mut m);
    }
    assert_eq!(m.byte("POCKET"), 2);
    m.done();
    // There already.
    m.set("TF", 1);
    m.run(3);
    m.done();
    // A pocket that there is not.
    for code in [0, 17] {
        m.set("T_CODE", code);
        m.set("TF", 1);
        m.run(10);
        assert_eq!(m.on(&["MAG_CW", "MAG_CCW", "FIN", "MSG_POCKET"]), ["MSG_POCKET"]);
        m.set("TF", 0);
        m.run(3);
        assert!(!m.is("MSG_POCKET"));
    }
}

/// A magazine of 16 pockets, whose switch is on for a tenth of the way on both sides of a pocket; a pin draws it there.
struct Magazine {
    /// Parts of the way from a pocket to the next, from pocket 1.
    at: i32,
    /// Its way, as it is told since a period.
    way: i32,
}

impl Magazine {
    const WAY: i32 = 20;
    const SWITCH: i32 = 2;

    /// The pocket that is nearest, from 1.
    fn pocket(&self) -> u8 {
        u8::try_from((self.at + Self::WAY / 2).div_euclid(Self::WAY).rem_euclid(16) + 1).unwrap()
    }

    /// A period: it turns as it was told by the period before the last, and its switch is read.
    fn run(&mut self, m: &mut Machine) {
        self.at += self.way;
        self.way = i32::from(m.is("MAG_CW")) - i32::from(m.is("MAG_CCW"));
        let from_pocket = (self.at + Self::WAY / 2).rem_euclid(Self::WAY) - Self::WAY / 2;
        let is_there = from_pocket.abs() <= Self::SWITCH;
        if is_there && self.way == 0 {
            self.at -= from_pocket;
        }
        m.set("POCKET_PULSE", is_there.into());
        m.run(1);
    }
}

/// Turns to the pocket `to`, for so many periods at most, until it is told to be there; how many periods that took.
fn turn(m: &mut Machine, magazine: &mut Magazine, to: u8, periods: usize) -> usize {
    m.set("T_CODE", to);
    m.set("TF", 1);
    let took = (0..periods).take_while(|_| {
        magazine.run(m);
        !m.is("FIN")
    });
    took.count()
}

/// Breaks turning off by `stop` in any period, turns on, breaks that off, and turns to a pocket.
fn break_turning_off(stop: fn(&mut Machine)) {
    let breaks = |m: &mut Machine, magazine: &mut Magazine, to: u8, period: usize| {
        turn(m, magazine, to, period);
        stop(m);
        m.set("TF", 0);
        (0..5).for_each(|_| magazine.run(m));
    };
    let way = usize::try_from(Magazine::WAY).unwrap();
    for [first, second, last] in [[3, 2, 1], [3, 1, 2], [3, 16, 3], [3, 3, 1], [15, 16, 1], [15, 1, 16]] {
        for period in 1..way + 5 {
            for other in 1..2 * way {
                let (mut m, mut magazine) = (Machine::new(), Magazine { at: 0, way: 0 });
                breaks(&mut m, &mut magazine, first, period);
                breaks(&mut m, &mut magazine, second, other);
                let place = format!("T{first} to period {period}, T{second} to {other}, T{last}");
                assert!(turn(&mut m, &mut magazine, last, 1_000) < 1_000, "{place}");
                assert_eq!((m.byte("POCKET"), magazine.pocket()), (last, last), "{place}");
            }
        }
    }
}

#[test]
fn pockets_are_counted_where_turning_is_broken_off_in_any_period() {
    break_turning_off(|m| m.set("TF", 0));
}

#[test]
fn pockets_are_counted_where_power_is_cut_in_any_period() {
    break_turning_off(Machine::cut_power);
}

/// The magazine has the tool, or the spindle has it, whenever power is cut.
#[test]
fn the_tool_is_known_where_power_is_cut_as_it_is_loose_or_clamps() {
    let mut m = Machine::new();
    m.m(21);
    m.set("MAG_AWAY", 0);
    m.set("MAG_AT_SPINDLE", 1);
    m.run(3);
    m.done();
    m.m(16);
    m.set("TOOL_CLAMPED", 0);
    m.set("TOOL_LOOSE", 1);
    m.run(3);
    assert_eq!(m.byte("TOOL"), 0);
    m.cut_power();
    m.set("TOOL_LOOSE", 0);
    m.run(3);
    // Without power nothing holds the clamp open; the magazine does not go with the tool in it.
    assert_eq!(m.on(&["TOOL_RELEASE", "MAG_TO_SPINDLE"]), ["MAG_TO_SPINDLE"]);
    m.cut_power();
    m.set("TOOL_CLAMPED", 1);
    m.run(3);
    assert_eq!((m.byte("TOOL"), m.is("MAG_TO_SPINDLE")), (1, true));
    m.m(22);
    assert!(!m.is("MAG_TO_SPINDLE"));
    // Nothing moves a magazine that is on its way as power comes on.
    m.set("MAG_AT_SPINDLE", 0);
    m.cut_power();
    m.run(3);
    assert!(!m.is("MAG_TO_SPINDLE"));
}

#[test]
fn a_tool_is_not_released_where_it_would_fall() {
    let mut m = Machine::new();
    // No magazine at the spindle.
    assert!(!m.m(16));
    assert!(!m.is("TOOL_RELEASE"));
    // After 30 s the operator is told.
    m.run(29_000);
    assert!(!m.is("MSG_TOOL"));
    m.run(1_100);
    assert!(m.is("MSG_TOOL") && !m.is("FIN"));
    m.set("MF", 0);
    m.press("RESET");
    assert!(!m.is("MSG_TOOL"));
    // A spindle that turns.
    m.set("MAG_AT_SPINDLE", 1);
    m.set("SSTA", 0);
    assert!(!m.m(16));
    assert!(!m.is("TOOL_RELEASE"));
    m.set("SSTA", 1);
    m.run(3);
    assert!(m.is("TOOL_RELEASE"));
}

#[test]
fn lubrication_runs_by_key_and_by_time() {
    let mut m = Machine::new();
    m.set("KEY_LUBE", 1);
    m.run(3);
    assert!(m.is("LUBE") && m.is("LAMP_LUBE"));
    m.set("KEY_LUBE", 0);
    m.run(3);
    assert!(!m.is("LUBE"));
    // Every two minutes for 15 s.
    m.set("LUBE_MINUTES", 2);
    m.run(119_900);
    assert!(!m.is("LUBE"));
    m.run(200);
    assert!(m.is("LUBE"));
    m.run(14_500);
    assert!(m.is("LUBE"));
    m.run(600);
    assert!(!m.is("LUBE"));
    m.run(105_000);
    assert!(m.is("LUBE"));
    // Without pressure the operator is told after 10 s.
    m.set("LUBE_PRESSURE", 0);
    m.run(9_500);
    assert!(!m.is("MSG_LUBE"));
    m.run(700);
    assert!(m.is("MSG_LUBE") && m.is("STLK"));
    m.set("LUBE_PRESSURE", 1);
    m.run(10);
    assert!(m.is("MSG_LUBE"));
    m.press("RESET");
    assert!(!m.is("MSG_LUBE"));
}

/// A machine that has less than this ladder says so once, and is well without it.
#[test]
fn what_keep_relays_say_that_the_machine_lacks_is_taken_to_be_well() {
    let mut m = Machine::new();
    let messages = ["MSG_AIR", "MSG_LUBE", "MSG_COOLANT", "MSG_CONVEYOR", "MSG_DRIVE"];
    for (input, relay, message) in [
        ("LUBE_LEVEL", "K_NO_LUBE_LEVEL", "MSG_LUBE"),
        ("AIR_PRESSURE", "K_NO_AIR", "MSG_AIR"),
        ("COOLANT_LEVEL", "K_NO_COOLANT", "MSG_COOLANT"),
        ("CONVEYOR_OK", "K_NO_CONVEYOR", "MSG_CONVEYOR"),
        ("DRIVE_OK", "K_NO_DRIVE", "MSG_DRIVE"),
    ] {
        m.set(input, 0);
        m.run(3);
        assert_eq!(m.on(&messages), [message]);
        m.set(relay, 1);
        m.press("RESET");
        assert!(m.on(&messages).is_empty(), "{relay}");
    }
    // The clamp: axes and spindle.
    m.set("TOOL_CLAMPED", 0);
    m.run(3);
    assert!(m.on(&["*IT", "*SSTP"]).is_empty());
    m.set("K_NO_CLAMP", 1);
    m.run(3);
    assert_eq!(m.on(&["*IT", "*SSTP"]), ["*IT", "*SSTP"]);
    m.press("KEY_AUTO");
    m.set("KEY_START", 1);
    m.run(3);
    assert!(m.is("ST"));
    m.set("KEY_START", 0);
    let outputs = ["SPINDLE_CW", "COOLANT", "FLUSH", "CONVEYOR", "BLOW"];
    for code in [8, 26, 35, 44, 17] {
        assert!(m.m(code), "M{code}");
        m.done();
    }
    assert!(!m.m(3));
    m.set("SARA", 1);
    m.run(3);
    m.done();
    assert_eq!(m.on(&outputs), outputs);
    // The clamp of the fourth axis.
    for input in ["A_CLAMPED", "A_LOOSE"] {
        m.set(input, 0);
    }
    for code in [10, 11] {
        m.set("K_NO_A_CLAMP", 0);
        assert!(!m.m(code), "M{code}");
        m.set("K_NO_A_CLAMP", 1);
        m.run(3);
        m.done();
    }
}

#[test]
fn lubrication_without_a_switch_of_its_pressure_runs_by_time() {
    for (relay, has_message) in [(0, true), (1, false)] {
        let mut m = Machine::new();
        m.set("LUBE_PRESSURE", 0);
        m.set("LUBE_MINUTES", 1);
        m.set("K_NO_LUBE_PRESSURE", relay);
        m.run(60_500);
        assert!(m.is("LUBE") && !m.is("MSG_LUBE"));
        m.run(10_000);
        assert!(m.is("LUBE") && m.is("MSG_LUBE") == has_message);
        m.run(5_000);
        assert!(!m.is("LUBE"));
    }
}

#[test]
fn without_a_magazine_a_tool_is_there_at_once() {
    let mut m = Machine::new();
    m.set("MAG_AWAY", 0);
    for tool in [7, 99] {
        m.set("K_NO_MAGAZINE", 0);
        m.set("T_CODE", tool);
        m.set("TF", 1);
        m.run(3);
        assert!(!m.is("FIN") && m.is("MSG_MAGAZINE"));
        m.set("K_NO_MAGAZINE", 1);
        m.run(3);
        assert_eq!(m.on(&["MSG_MAGAZINE", "MSG_POCKET", "MAG_CW", "MAG_CCW"]), Vec::<&str>::new());
        m.done();
        assert!(m.m(6));
        m.done();
        assert_eq!((m.word("TOOL"), m.word("TSP")), (u16::from(tool), u16::from(tool) + 1));
    }
}

/// Drives of the axes that stop by themselves end what M codes began: nobody leads the cut any more.
#[test]
fn drives_that_failed_end_spindle_and_coolant() {
    let mut m = Machine::new();
    m.press("KEY_AUTO");
    m.m(8);
    m.done();
    m.m(3);
    m.set("SARA", 1);
    m.run(3);
    m.done();
    let outputs = ["SPINDLE_CW", "COOLANT", "MRDYA", "*SSTP"];
    assert_eq!(m.on(&outputs), outputs);
    m.set("SA", 0);
    m.run(3);
    assert_eq!(m.on(&outputs), Vec::<&str>::new());
    m.set("SA", 1);
    m.run(3);
    assert_eq!(m.on(&outputs), ["MRDYA", "*SSTP"]);
}
