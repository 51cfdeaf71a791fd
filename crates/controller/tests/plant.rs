//! The simulated machine under the standard ladder, and what of it may not allocate.
#![allow(missing_docs, clippy::unwrap_used, clippy::panic)]

mod common;

use assert_no_alloc::{AllocDisabler, assert_no_alloc};
use common::{interpreter, machine};
use ferrocut_controller::drives::{Block, Contact, Drives, Plant, Switches, Trouble};
use ferrocut_controller::signals::Inputs;
use ferrocut_controller::{Cnc, State};
use ferrocut_geometry::{Axis, AxisSet, Position};
use ferrocut_machine::{Machine, PlantConfig};
use ferrocut_plc::{Address, Area, Limits, Pace, Plc, Program};

#[global_allocator]
static ALLOCATOR: AllocDisabler = AllocDisabler;

const LADDER: &str = include_str!("../../../machines/standard.lad");

fn planted() -> Machine {
    Machine { plant: Some(PlantConfig::default()), ..machine() }
}

/// The machine with its ladder; the test is the NC.
struct Shop {
    plc: Plc,
    plant: Plant,
    at: Position,
}

impl Shop {
    fn new() -> Shop {
        let program = Program::from_text(LADDER.as_bytes(), &Limits::default()).unwrap();
        let plant = Plant::new(&planted(), Position::ZERO, Position::ZERO);
        let mut shop = Shop { plc: Plc::new(program, Pace::default()), plant, at: Position::ZERO };
        shop.set("MA", true);
        shop.set("SSTA", true);
        shop.set("ZP_Z", true);
        shop.run(1000);
        shop
    }

    fn at(&self, name: &str) -> Address {
        self.plc.program().signal(name).unwrap()
    }

    fn set(&mut self, name: &str, on: bool) {
        let address = self.at(name);
        self.plc.memory_mut().set_bit(address, on);
    }

    fn is(&self, name: &str) -> bool {
        self.plc.memory().bit(self.at(name))
    }

    fn run(&mut self, ms: u32) {
        let of = |area, byte, bit| Address { area, byte, bit: Some(bit) };
        for _ in 0..ms {
            self.plant.exchange(&self.at);
            let memory = self.plc.memory_mut();
            self.plant.read(&mut |byte, bit, on| memory.set_bit(of(Area::X, byte, bit), on));
            assert_eq!(self.plc.scan().stop, None);
            let memory = self.plc.memory();
            self.plant.write(&|byte, bit| memory.bit(of(Area::Y, byte, bit)));
        }
    }

    /// Hands a code over and waits until it is done, ms.
    fn code(&mut self, strobe: &str, code: &str, value: u8) -> u32 {
        let address = self.at(code);
        self.plc.memory_mut().set_byte(address, value);
        self.set(strobe, true);
        let mut ms = 0;
        while !self.is("FIN") {
            assert!(ms < 20_000, "{strobe}{value} is never done");
            self.run(1);
            ms += 1;
        }
        self.set(strobe, false);
        self.run(20);
        ms
    }

    fn m(&mut self, code: u8) -> u32 {
        self.code("MF", "M_CODE", code)
    }
}

#[test]
fn the_standard_ladder_changes_tools_on_the_machine() {
    let mut shop = Shop::new();
    // Pocket 1 is at the spindle, and the ladder knows it.
    let pocket = shop.at("POCKET");
    shop.plc.memory_mut().set_byte(pocket, 1);
    assert_eq!(shop.plant.tool_and_pocket(), (1, 1));
    for (tool, pockets) in [(5, 4), (16, 5), (2, 2)] {
        assert!((780..900).contains(&shop.m(21)));
        assert!((280..400).contains(&shop.m(16)));
        let ms = shop.code("TF", "T_CODE", tool);
        // 400 ms from pocket to pocket, the short way round.
        assert!((pockets * 400 - 150..pockets * 400 + 150).contains(&ms), "{tool}: {ms}");
        shop.m(17);
        shop.m(22);
        assert_eq!(shop.plant.tool_and_pocket(), (u32::from(tool), u32::from(tool)));
        assert_eq!(shop.plc.memory().byte(pocket), tool);
        assert_eq!(Inputs::read(shop.plc.memory()).tool_in_spindle, Some(u32::from(tool)));
        assert!(!shop.is("MSG_TOOL") && !shop.is("MSG_POCKET"));
    }
}

/// A magazine that is stopped anywhere, and then turned either way, is where the ladder counts it.
#[test]
fn a_magazine_that_is_stopped_between_two_pockets_is_counted_aright() {
    let mut shop = Shop::new();
    shop.m(21);
    shop.m(16);
    assert_eq!(
        (shop.plant.tool_and_pocket().0, Inputs::read(shop.plc.memory()).tool_in_spindle),
        (0, Some(0))
    );
    let pocket = shop.at("POCKET");
    let mut goal: u8 = 1;
    for ms in (1..1200).step_by(37) {
        let code = shop.at("T_CODE");
        shop.plc.memory_mut().set_byte(code, (goal + 4) % 16 + 1);
        shop.set("TF", true);
        shop.run(ms);
        shop.set("TF", false);
        shop.run(50);
        // Back, on, or to the pocket that was left.
        let at = shop.plc.memory().byte(pocket);
        goal = [at, at % 16 + 1, (at + 14) % 16 + 1][ms as usize % 3];
        shop.code("TF", "T_CODE", goal);
        shop.run(100);
        assert_eq!(
            (shop.plant.tool_and_pocket().1, shop.plc.memory().byte(pocket)),
            (goal.into(), goal),
            "{ms}"
        );
    }
}

#[test]
fn clamps_lubrication_door_and_limits_meet_the_ladder() {
    let mut shop = Shop::new();
    assert!((280..400).contains(&shop.m(10)) && (280..400).contains(&shop.m(11)));
    shop.set("KEY_LUBE", true);
    shop.run(600);
    assert!(shop.is("LUBE") && shop.is("LUBE_PRESSURE") && !shop.is("MSG_LUBE"));
    shop.set("KEY_LUBE", false);
    assert!(shop.plant.set_level("AIR_PRESSURE", false));
    shop.run(20);
    assert!(shop.is("MSG_AIR"));
    // The door is locked while the spindle turns.
    shop.set("SSTA", false);
    shop.run(20);
    assert!(shop.is("DOOR_LOCK") && !shop.plant.move_door(true));
    shop.set("SSTA", true);
    shop.run(20);
    assert!(shop.plant.move_door(true));
    shop.run(20);
    assert!(!shop.is("DOOR_CLOSED"));
    shop.plant.press_emergency_stop(true);
    shop.run(2);
    assert!(!shop.is("*ESP"));
    // Y up over its switch at 410; it stands at -80 when power comes and is called 0.
    assert!(shop.is("*L2+"));
    for _ in 0..5000 {
        shop.at[Axis::Y] += 0.1;
        shop.run(1);
    }
    shop.run(500);
    assert!(!shop.is("*LY+") && !shop.is("*L2+") && shop.is("*L2-") && shop.is("MIT2+"));
    // What the NC reads of it is what the drives say themselves.
    let inputs = Inputs::read(shop.plc.memory());
    let order = planted().axes.iter().map(|axis| axis.name).collect::<Vec<_>>();
    let read = Switches::of(&inputs, order.iter().copied(), true, false);
    assert_eq!(read, shop.plant.switches());
    assert_eq!(read.above, [Axis::Y].into_iter().collect());
    // On its home switch: 46 to 76 mm up.
    shop.at[Axis::X] = 60.0;
    shop.plant.place(Block { min: [-100.0; 3], max: [500.0; 3] });
    shop.run(2000);
    let read = Switches::of(&Inputs::read(shop.plc.memory()), order.iter().copied(), true, false);
    assert_eq!((read, read.home.contains(Axis::X), read.skip), (shop.plant.switches(), true, true));
}

#[test]
fn a_machine_file_says_what_the_probe_can_touch() {
    let file = |max: &str| {
        let block = format!("[[plant.blocks]]\nmin = [10.0, -5.0, -5.0]\nmax = {max}\n");
        Machine::from_toml(&format!("{}\n{block}", Machine::DEMO_MILL))
    };
    let machine = file("[20.0, 5.0, 5.0]").unwrap();
    let mut plant = Plant::new(&machine, Position::ZERO, Position::ZERO);
    plant.stand_as_called([Axis::X, Axis::Y, Axis::Z].into_iter().collect());
    assert_eq!(plant.probe(), None);
    plant.arm_probe(Contact::Made);
    for period in 0..4000 {
        let mut to = Position::ZERO;
        to[Axis::X] = 0.005 * f64::from(period);
        plant.exchange(&to);
    }
    let touched = plant.probe().unwrap();
    assert!((touched[Axis::X] - 10.0).abs() < 1e-3, "{touched:?}");
    let refused = file("[20.0, 5.0, -6.0]").unwrap_err().to_string();
    assert!(refused.contains("blocks: max is -6: it must be -5 to"), "{refused}");
}

#[test]
fn a_period_allocates_nothing() {
    let machine = planted();
    let mut plant = Plant::new(&machine, Position::ZERO, Position::ZERO);
    plant.place(Block { min: [20.0; 3], max: [30.0; 3] });
    let mut bits = 0u32;
    assert_no_alloc(|| {
        for k in 0..50_000u32 {
            let phi = f64::from(k) * 0.002;
            plant.exchange(&Position::xyz(phi.sin() * 600.0, phi.cos() * 90.0, phi.sin() * 50.0));
            if k % 1000 == 0 {
                plant.arm_probe(if k % 2000 == 0 { Contact::Made } else { Contact::Lost });
                plant.arm_marker(Axis::X);
            }
            plant.write(&|byte, bit| (u32::from(byte) + u32::from(bit) + k / 2000) % 3 == 0);
            plant.read(&mut |_, _, on| bits += u32::from(on));
            bits += u32::from(plant.probe().is_some() && plant.marker(Axis::X).is_some());
        }
    });
    assert!(bits > 100_000);

    // Nor does homing, in any of its legs, nor the alarm that ends a program where switches are.
    let mut cnc = on_plant(&machine);
    assert!(cnc.home(Axis::X) && cnc.home(Axis::Z));
    assert_no_alloc(|| {
        while cnc.is_homing() {
            cnc.tick();
        }
        for _ in 0..100 {
            cnc.tick();
        }
    });
    assert_eq!(cnc.referenced(), [Axis::X, Axis::Z].into_iter().collect::<AxisSet>());
    assert_eq!(cnc.state(), &State::Ready);
}

fn on_plant(machine: &Machine) -> Cnc {
    let plant = Plant::new(machine, Position::ZERO, Position::ZERO);
    Cnc::with_drives(machine, interpreter("M30\n", ""), Box::new(plant))
}

#[test]
fn the_same_commands_give_the_same_machine() {
    let run = || {
        let mut cnc = on_plant(&planted());
        cnc.home(Axis::X);
        cnc.home(Axis::Y);
        cnc.drives().plant().unwrap().trouble(Axis::Y, Trouble::NoMarker(true));
        (0..30_000).map(|_| cnc.tick()).map(|tick| (tick.position, tick.actual)).collect::<Vec<_>>()
    };
    assert_eq!(run(), run());
}
