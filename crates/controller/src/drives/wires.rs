//! Where switches of the axes and the probe stand among the inputs X: the places of the standard ladder (Fanuc 0i),
//! unless the machine file wires them otherwise.

use super::Switches;
use ferrocut_geometry::Axis;
use ferrocut_machine::Machine;
use std::collections::BTreeMap;

/// Byte and bit.
pub(super) type Wire = (u16, u8);

const SKIP: (&str, Wire) = ("SKIP", (4, 7));
const HOME: [(&str, Wire); 8] = [
    ("*DEC_X", (9, 0)),
    ("*DEC_Y", (9, 1)),
    ("*DEC_Z", (9, 2)),
    ("*DEC_A", (9, 3)),
    ("*DEC_5", (9, 4)),
    ("*DEC_6", (9, 5)),
    ("*DEC_7", (9, 6)),
    ("*DEC_8", (9, 7)),
];
/// The travel switches of the first four axes, upper ones first.
const LIMITS: [(&str, Wire); 8] = [
    ("*LX+", (0, 0)),
    ("*LX-", (0, 1)),
    ("*LY+", (0, 2)),
    ("*LY-", (0, 3)),
    ("*LZ+", (0, 4)),
    ("*LZ-", (0, 5)),
    ("*LA+", (0, 6)),
    ("*LA-", (0, 7)),
];

/// The wire of a signal: that of the machine file, `X1.0` or `Y1.0`, or that of the standard ladder.
pub(super) fn wire(wiring: &BTreeMap<String, String>, name: &str, usual: Wire) -> Wire {
    let place = |text: &str| {
        let text = text.strip_prefix(['X', 'Y', 'x', 'y'])?;
        let (byte, bit) = text.split_once('.')?;
        let bit = bit.parse::<u8>().ok().filter(|bit| *bit < 8)?;
        Some((byte.parse().ok()?, bit))
    };
    wiring.get(name).and_then(|text| place(text)).unwrap_or(usual)
}

/// The wires of a machine.
#[derive(Clone, Debug)]
pub(super) struct AxisWires {
    /// Axes in the order of the machine file, which signals are numbered by.
    order: Vec<Axis>,
    home: [Wire; HOME.len()],
    limits: [Wire; LIMITS.len()],
    skip: Wire,
    /// The probe is on while it touches nothing.
    pub probe_opens: bool,
}

impl AxisWires {
    pub fn new(machine: &Machine, wiring: &BTreeMap<String, String>, probe_opens: bool) -> AxisWires {
        AxisWires {
            order: machine.axes.iter().map(|axis| axis.name).collect(),
            home: HOME.map(|(name, usual)| wire(wiring, name, usual)),
            limits: LIMITS.map(|(name, usual)| wire(wiring, name, usual)),
            skip: wire(wiring, SKIP.0, SKIP.1),
            probe_opens,
        }
    }

    /// Puts the switches where the ladder looks at them.
    pub fn put(&self, switches: &Switches, put: &mut dyn FnMut(u16, u8, bool)) {
        for (axis, (byte, bit)) in self.order.iter().zip(self.home) {
            put(byte, bit, !switches.home.contains(*axis));
        }
        let sides = self.order.iter().flat_map(|axis| [(axis, switches.above), (axis, switches.below)]);
        for ((axis, beyond), (byte, bit)) in sides.zip(self.limits) {
            put(byte, bit, !beyond.contains(*axis));
        }
        let (byte, bit) = self.skip;
        put(byte, bit, switches.skip != self.probe_opens);
    }
}
