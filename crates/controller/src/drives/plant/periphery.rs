//! What stands about the axes of the simulated machine: tool clamp, clamp of the fourth axis, magazine without an
//! arm, lubrication, door, levels and pressures. Inputs X answer outputs Y after the time that the thing takes.

use crate::drives::wires::{Wire, wire};
use crate::signals::ESP_BUTTON;
use ferrocut_machine::PlantConfig;

/// Something that goes from one end to the other in some time, while it is driven, and back while it is not.
#[derive(Clone, Copy, Debug)]
struct Mover {
    /// 0 at one end, 1 at the other.
    at: f64,
    step: f64,
}

impl Mover {
    fn new(time_ms: f64, period_ms: f64) -> Mover {
        Mover { at: 0.0, step: if time_ms > period_ms { period_ms / time_ms } else { 1.0 } }
    }

    fn go(&mut self, there: bool) {
        let step = if there { self.step } else { -self.step };
        self.at = (self.at + step).clamp(0.0, 1.0);
        // What a sum of parts is beside an end.
        if (self.at - self.at.round()).abs() < self.step / 2.0 {
            self.at = self.at.round();
        }
    }

    fn is_there(&self) -> bool {
        self.at == 1.0
    }

    fn is_back(&self) -> bool {
        self.at == 0.0
    }
}

/// Part of the way to the next pocket on both sides of a pocket in which its switch is on.
const POCKET_SWITCH: f64 = 0.2;

/// The magazine: a disk of pockets that comes to the spindle.
#[derive(Clone, Debug)]
struct Magazine {
    way: Mover,
    /// Pockets passed upwards since power-on, in parts of one.
    turned: f64,
    step: f64,
    /// Tools by pocket, the first in place 0; 0 is none.
    tools: Vec<u32>,
}

impl Magazine {
    /// The pocket at the spindle, counted from 0.
    fn pocket(&self) -> usize {
        let pockets = self.tools.len().max(1) as f64;
        (self.turned.round().rem_euclid(pockets)) as usize
    }

    fn is_at_pocket(&self) -> bool {
        (self.turned - self.turned.round()).abs() <= POCKET_SWITCH
    }

    fn turn(&mut self, up: bool, down: bool) {
        if up != down {
            self.turned += if up { self.step } else { -self.step };
        } else if self.is_at_pocket() {
            // The indexing pin draws it on its place.
            self.turned = self.turned.round();
        }
    }
}

/// Gears of the spindle.
const GEARS: usize = 3;

/// All of it.
#[derive(Clone, Debug)]
pub(super) struct Periphery {
    release: Mover,
    axis_release: Mover,
    lubrication: Mover,
    /// The forks of the spindle's gears, each on its way in.
    gears: [Mover; GEARS],
    magazine: Magazine,
    in_spindle: u32,
    pub door_is_open: bool,
    door_is_locked: bool,
    pub emergency_stop: bool,
    /// Inputs by name that are not what they should be.
    faults: [bool; LEVELS.len()],
    wires: [Wire; NAMES.len()],
    driven: [bool; OUTPUTS.len()],
}

/// Outputs that the machine answers, and where they stand in the standard ladder.
const OUTPUTS: [(&str, Wire); 11] = [
    ("LUBE", (0, 6)),
    ("A_CLAMP", (1, 0)),
    ("A_RELEASE", (1, 1)),
    ("TOOL_RELEASE", (1, 2)),
    ("MAG_CW", (1, 3)),
    ("MAG_CCW", (1, 4)),
    ("MAG_TO_SPINDLE", (1, 5)),
    ("DOOR_LOCK", (1, 6)),
    ("GEAR_SHIFT_1", (1, 7)),
    ("GEAR_SHIFT_2", (2, 3)),
    ("GEAR_SHIFT_3", (2, 4)),
];

/// Inputs that are on while all is well.
const LEVELS: [(&str, Wire); 5] = [
    ("LUBE_LEVEL", (1, 1)),
    ("AIR_PRESSURE", (1, 3)),
    ("COOLANT_LEVEL", (1, 4)),
    ("CONVEYOR_OK", (1, 5)),
    ("DRIVE_OK", (1, 6)),
];

/// Inputs that answer.
const ANSWERS: [(&str, Wire); 13] = [
    ("DOOR_CLOSED", (1, 0)),
    ("LUBE_PRESSURE", (1, 2)),
    ("TOOL_CLAMPED", (2, 0)),
    ("TOOL_LOOSE", (2, 1)),
    ("A_CLAMPED", (2, 2)),
    ("A_LOOSE", (2, 3)),
    ("POCKET_PULSE", (2, 4)),
    ("MAG_AT_SPINDLE", (2, 5)),
    ("MAG_AWAY", (2, 6)),
    ESP_BUTTON,
    ("GEAR_IN_1", (3, 0)),
    ("GEAR_IN_2", (3, 1)),
    ("GEAR_IN_3", (3, 2)),
];

/// Everything that has a wire: outputs, levels, answers.
const NAMES: [(&str, Wire); OUTPUTS.len() + LEVELS.len() + ANSWERS.len()] = {
    let mut names = [("", (0, 0)); OUTPUTS.len() + LEVELS.len() + ANSWERS.len()];
    let mut n = 0;
    while n < names.len() {
        names[n] = if n < OUTPUTS.len() {
            OUTPUTS[n]
        } else if n < OUTPUTS.len() + LEVELS.len() {
            LEVELS[n - OUTPUTS.len()]
        } else {
            ANSWERS[n - OUTPUTS.len() - LEVELS.len()]
        };
        n += 1;
    }
    names
};

impl Periphery {
    pub fn new(config: &PlantConfig, period_ms: f64) -> Periphery {
        let pockets = config.pockets.max(1);
        let magazine = Magazine {
            way: Mover::new(config.magazine_ms, period_ms),
            turned: 0.0,
            step: Mover::new(config.pocket_ms, period_ms).step,
            tools: (1..=pockets).collect(),
        };
        let mut gears = [Mover::new(config.clamp_ms, period_ms); GEARS];
        // The first is in at power-on.
        gears[0].at = 1.0;
        let mut periphery = Periphery {
            gears,
            release: Mover::new(config.clamp_ms, period_ms),
            // Clamped at power-on.
            axis_release: Mover::new(config.clamp_ms, period_ms),
            lubrication: Mover::new(config.lube_ms, period_ms),
            magazine,
            in_spindle: 0,
            door_is_open: false,
            door_is_locked: false,
            emergency_stop: false,
            faults: [false; LEVELS.len()],
            wires: NAMES.map(|(name, usual)| wire(&config.wiring, name, usual)),
            driven: [false; OUTPUTS.len()],
        };
        periphery.stand_with(1, 1);
        periphery
    }

    /// A tool in the spindle, none where it is 0, and a pocket at it, counted from 1. All other tools are in the pockets of
    /// their numbers.
    pub fn stand_with(&mut self, tool: u32, pocket: u32) {
        self.magazine.turned = f64::from(pocket.saturating_sub(1));
        self.magazine.tools =
            (1..).zip(&self.magazine.tools).map(|(n, _)| if n == tool { 0 } else { n }).collect();
        self.in_spindle = tool;
    }

    /// The tool in the spindle; 0 is none.
    pub fn tool(&self) -> u32 {
        self.in_spindle
    }

    /// The pocket at the spindle, counted from 1.
    pub fn pocket(&self) -> u32 {
        self.magazine.pocket() as u32 + 1
    }

    /// An input that is on while all is well goes off or on; whether there is such a one.
    pub fn set_level(&mut self, name: &str, is_well: bool) -> bool {
        let place = LEVELS.iter().position(|(level, _)| *level == name);
        let fault = place.and_then(|at| self.faults.get_mut(at));
        match fault {
            Some(fault) => *fault = !is_well,
            None => return false,
        }
        true
    }

    /// Opens or closes the door; whether it let itself be moved.
    pub fn move_door(&mut self, open: bool) -> bool {
        let moves = !open || !self.door_is_locked;
        if moves {
            self.door_is_open = open;
        }
        moves
    }

    pub fn write(&mut self, is_on: &dyn Fn(u16, u8) -> bool) {
        for (driven, (byte, bit)) in self.driven.iter_mut().zip(self.wires) {
            *driven = is_on(byte, bit);
        }
    }

    /// Goes on by a period.
    pub fn tick(&mut self) {
        let [lube, a_clamp, a_release, tool_release, up, down, to_spindle, lock, shifts @ ..] = self.driven;
        // Without pressure a fork stays where it is; with one on each side too.
        if shifts.into_iter().filter(|shifts| *shifts).count() == 1 {
            self.gears.iter_mut().zip(shifts).for_each(|(gear, shifts)| gear.go(shifts));
        }
        self.door_is_locked = lock && !self.door_is_open;
        self.lubrication.go(lube);
        if a_clamp != a_release {
            self.axis_release.go(a_release);
        }
        self.magazine.way.go(to_spindle);
        self.magazine.turn(up, down);
        let (was_loose, was_clamped) = (self.release.is_there(), self.release.is_back());
        self.release.go(tool_release);
        // The tool stays in the pocket that holds it, and is taken out of the one that is there.
        if self.magazine.way.is_there() && self.magazine.is_at_pocket() {
            let at = self.magazine.pocket();
            if let Some(pocket) = self.magazine.tools.get_mut(at) {
                if !was_loose && self.release.is_there() && *pocket == 0 {
                    *pocket = std::mem::take(&mut self.in_spindle);
                } else if !was_clamped && self.release.is_back() && self.in_spindle == 0 {
                    self.in_spindle = std::mem::take(pocket);
                }
            }
        }
    }

    pub fn read(&self, put: &mut dyn FnMut(u16, u8, bool)) {
        let answers = [
            !self.door_is_open,
            self.lubrication.is_there(),
            self.release.is_back(),
            self.release.is_there(),
            self.axis_release.is_back(),
            self.axis_release.is_there(),
            self.magazine.is_at_pocket(),
            self.magazine.way.is_there(),
            self.magazine.way.is_back(),
            !self.emergency_stop,
        ];
        let answers = answers.into_iter().chain(self.gears.iter().map(Mover::is_there));
        let inputs = self.faults.into_iter().map(|fault| !fault).chain(answers);
        for ((byte, bit), is_on) in self.wires.into_iter().skip(OUTPUTS.len()).zip(inputs) {
            put(byte, bit, is_on);
        }
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    /// The machine with outputs on, by name, for some time, ms.
    fn run(machine: &mut Periphery, on: &[&str], ms: u32) {
        let wires: Vec<Wire> = OUTPUTS.iter().filter(|(n, _)| on.contains(n)).map(|(_, w)| *w).collect();
        machine.write(&|byte, bit| wires.contains(&(byte, bit)));
        (0..ms).for_each(|_| machine.tick());
    }

    fn inputs(machine: &Periphery) -> Vec<&'static str> {
        let mut on = Vec::new();
        machine.read(&mut |byte, bit, is_on| {
            let name = NAMES.iter().skip(OUTPUTS.len()).find(|(_, wire)| *wire == (byte, bit));
            on.extend(name.filter(|_| is_on).map(|(name, _)| *name));
        });
        on
    }

    const WELL: [&str; 8] = [
        "LUBE_LEVEL",
        "AIR_PRESSURE",
        "COOLANT_LEVEL",
        "CONVEYOR_OK",
        "DRIVE_OK",
        "DOOR_CLOSED",
        "*ESP_BUTTON",
        "GEAR_IN_1",
    ];

    /// Inputs beside those of a machine that is well.
    fn answers(machine: &Periphery) -> Vec<&'static str> {
        inputs(machine).into_iter().filter(|name| !WELL.contains(name)).collect()
    }

    #[test]
    fn a_tool_is_changed_by_the_outputs_of_the_ladder() {
        let mut machine = Periphery::new(&PlantConfig::default(), 1.0);
        run(&mut machine, &[], 1);
        assert_eq!(answers(&machine), ["TOOL_CLAMPED", "A_CLAMPED", "POCKET_PULSE", "MAG_AWAY"]);
        assert!(WELL.iter().all(|name| inputs(&machine).contains(name)));
        assert_eq!((machine.tool(), machine.pocket()), (1, 1));
        // 800 ms to the spindle.
        run(&mut machine, &["MAG_TO_SPINDLE"], 799);
        assert_eq!(answers(&machine), ["TOOL_CLAMPED", "A_CLAMPED", "POCKET_PULSE"]);
        run(&mut machine, &["MAG_TO_SPINDLE"], 1);
        assert!(answers(&machine).contains(&"MAG_AT_SPINDLE"));
        // 300 ms to let go.
        run(&mut machine, &["MAG_TO_SPINDLE", "TOOL_RELEASE"], 299);
        assert!(!answers(&machine).iter().any(|name| name.starts_with("TOOL")));
        run(&mut machine, &["MAG_TO_SPINDLE", "TOOL_RELEASE"], 1);
        assert!(answers(&machine).contains(&"TOOL_LOOSE") && machine.tool() == 0);
        // Three pockets back, 400 ms each: pocket 14 of 16. The switch is on when it stops, and once at each.
        let mut pulses = 0;
        let mut was_on = true;
        for _ in 0..1150 {
            run(&mut machine, &["MAG_TO_SPINDLE", "TOOL_RELEASE", "MAG_CCW"], 1);
            let is_on = answers(&machine).contains(&"POCKET_PULSE");
            pulses += u32::from(is_on && !was_on);
            was_on = is_on;
        }
        assert_eq!((pulses, machine.pocket()), (3, 14));
        run(&mut machine, &["MAG_TO_SPINDLE"], 300);
        assert!(answers(&machine).contains(&"TOOL_CLAMPED") && machine.tool() == 14);
        run(&mut machine, &[], 800);
        assert!(answers(&machine).contains(&"MAG_AWAY"));
        assert_eq!((machine.magazine.tools[0], machine.magazine.tools[13], machine.tool()), (1, 0, 14));
    }

    #[test]
    fn clamps_pressures_and_the_door_answer() {
        let mut wiring = std::collections::BTreeMap::new();
        wiring.insert("DOOR_CLOSED".to_owned(), "X11.3".to_owned());
        let config = PlantConfig { wiring, ..PlantConfig::default() };
        let mut machine = Periphery::new(&config, 2.0);
        run(&mut machine, &["A_RELEASE", "LUBE"], 250);
        assert!(answers(&machine).contains(&"A_LOOSE") && answers(&machine).contains(&"LUBE_PRESSURE"));
        run(&mut machine, &["A_CLAMP"], 149);
        assert!(!answers(&machine).contains(&"A_CLAMPED"));
        run(&mut machine, &["A_CLAMP", "DOOR_LOCK"], 1);
        assert!(answers(&machine).contains(&"A_CLAMPED"));
        let door = |machine: &Periphery| {
            let mut closed = None;
            machine.read(&mut |byte, bit, on| {
                if (byte, bit) == (11, 3) {
                    closed = Some(on);
                }
            });
            closed
        };
        assert!(!machine.move_door(true) && door(&machine) == Some(true));
        run(&mut machine, &[], 1);
        assert!(machine.move_door(true) && door(&machine) == Some(false));
        // From gear to gear; with nothing on a fork stays.
        let gears = |machine: &Periphery| {
            let on = inputs(machine);
            ["GEAR_IN_1", "GEAR_IN_2", "GEAR_IN_3"].map(|name| on.contains(&name))
        };
        run(&mut machine, &["GEAR_SHIFT_3"], 149);
        assert_eq!(gears(&machine), [false, false, false]);
        run(&mut machine, &["GEAR_SHIFT_3"], 1);
        run(&mut machine, &[], 10);
        assert_eq!(gears(&machine), [false, false, true]);
        run(&mut machine, &["GEAR_SHIFT_1"], 150);
        assert_eq!(gears(&machine), [true, false, false]);
        assert!(machine.set_level("AIR_PRESSURE", false) && !machine.set_level("DOOR_CLOSED", false));
        assert!(!inputs(&machine).contains(&"AIR_PRESSURE"));
    }
}
