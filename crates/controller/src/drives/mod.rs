//! What moves the axes, and what they feel on the way: switches, markers, a probe.

pub mod plant;
pub mod pulse;
mod simulated;
mod wires;

pub use plant::{Block, Plant, Trouble};
pub use pulse::Pulse;
pub use simulated::Simulated;

use crate::signals::Inputs;
use ferrocut_geometry::{Axis, AxisSet, Position};
use ferrocut_machine::{Alarm, DrivesConfig, Machine};
use ferrocut_program::Span;

/// The switches of the axes and the probe, as they stand now.
#[derive(Clone, Copy, PartialEq, Eq, Debug, Default)]
pub struct Switches {
    /// Axes whose home switch is open. Most open where they are reached; which do not, the machine file says.
    pub home: AxisSet,
    /// Axes beyond their upper travel switch.
    pub above: AxisSet,
    /// Axes beyond their lower travel switch.
    pub below: AxisSet,
    /// The probe touches.
    pub skip: bool,
}

impl Switches {
    /// The switches as the ladder says that they stand, for a machine with these axes in the order of its file, whose
    /// home switches go through the ladder, or do not (GSK990MC 6#5), and whose probe is on while it touches nothing, or
    /// is not (4#7).
    pub fn of(
        inputs: &Inputs,
        axes: impl IntoIterator<Item = Axis>,
        homes_through_ladder: bool,
        probe_opens: bool,
    ) -> Switches {
        let mut switches = Switches { skip: inputs.skip != probe_opens, ..Switches::default() };
        let home = match homes_through_ladder {
            true => inputs.on_home_switch_by_ladder,
            false => inputs.on_home_switch,
        };
        let ways = inputs.at_limit.iter().zip(home);
        for (axis, (at_limit, on_home_switch)) in axes.into_iter().zip(ways) {
            for (set, is_in) in [
                (&mut switches.home, on_home_switch),
                (&mut switches.above, at_limit.plus),
                (&mut switches.below, at_limit.minus),
            ] {
                if is_in {
                    *set = set.with(axis);
                }
            }
        }
        switches
    }
}

/// What a probe is waited for.
#[derive(Clone, Copy, PartialEq, Eq, Debug)]
pub enum Contact {
    /// That it touches.
    Made,
    /// That it is free.
    Lost,
}

/// The drives of a machine, asked once a servo period. Positions are mm and degrees, by the names that the axes have.
///
/// Places of markers, edges and touches are kept by the drives themselves, which sample faster than a servo period
/// lasts.
pub trait Drives: Send {
    /// Commands a position and returns where the axes are.
    fn exchange(&mut self, commanded: &Position) -> Position;

    /// The place where the axes are commanded to be is called by these positions from here on. Drives that count for
    /// themselves take them over; to others, which are told positions alone, it is nothing.
    fn rename(&mut self, _at: &Position) {}

    /// Whether they need a setpoint each period, whatever else the computer does. Simulated ones wait for theirs, so that
    /// a run is the same on a slow computer.
    fn keeps_time(&self) -> bool {
        false
    }

    /// Whether it is known from power-on where the axes are.
    fn knows_places(&self) -> bool {
        true
    }

    /// Whether an axis that is moving when the power fails comes to rest nobody knows where.
    fn loses_place_with_power(&self) -> bool {
        true
    }

    /// The switches that drives read themselves.
    fn switches(&self) -> Switches {
        Switches::default()
    }

    /// An axis is to keep the place of the next marker that its encoder passes.
    fn arm_marker(&mut self, _axis: Axis) {}

    /// That place, once it was passed.
    fn marker(&self, _axis: Axis) -> Option<f64> {
        None
    }

    /// Where the home switch of an axis changed last.
    fn home_edge(&self, _axis: Axis) -> Option<f64> {
        None
    }

    /// Whether a probe is fitted.
    fn has_probe(&self) -> bool {
        false
    }

    /// Whether the input of the probe is on while it touches nothing.
    fn probe_opens(&self) -> bool {
        false
    }

    /// Keeps where the axes are when the probe touches next, or is free; at once if it is so now.
    fn arm_probe(&mut self, _until: Contact) {}

    /// That place, once it was so.
    fn probe(&self) -> Option<Position> {
        None
    }

    /// Inputs X of the machine: byte, bit and state of each.
    fn read(&self, _put: &mut dyn FnMut(u16, u8, bool)) {}

    /// Outputs Y to the machine, by byte and bit, for the next period.
    fn write(&mut self, _is_on: &dyn Fn(u16, u8) -> bool) {}

    /// The speed that the spindle is to have, r/min; clockwise positive.
    fn turn_spindle(&mut self, _rpm: f64) {}

    /// Whether the spindle follows angles: it can be oriented, and tap in step with the axes.
    fn leads_spindle(&self) -> bool {
        true
    }

    /// The amplifiers are to be on or off; told only while the axes stand. Whether it is known still where the
    /// axes are.
    fn enable(&mut self, _on: bool) -> bool {
        true
    }

    /// Whether they have stopped by themselves, and follow no command until they are restarted.
    fn has_failed(&self) -> bool {
        false
    }

    /// Why, as the alarm of a block.
    fn failure(&self, _span: Span) -> Option<Box<Alarm>> {
        None
    }

    /// Whoever was told of it wants to go on: they begin anew, from where the axes stand.
    fn restart(&mut self) {}

    /// The simulated machine, where these drives move one.
    fn plant(&mut self) -> Option<&mut Plant> {
        None
    }
}

/// The drives that a machine file describes, ready, with the axes called `at`; `None` where it describes none, so that
/// the machine is a simulated one.
///
/// # Errors
/// [`ferrocut_machine::Fault::DrivesSilent`] and those behind it: the drives are not there, or cannot do what the machine
/// file asks for.
pub fn connect(machine: &Machine, at: Position) -> Result<Option<Box<dyn Drives>>, Box<Alarm>> {
    match &machine.drives {
        None => Ok(None),
        Some(DrivesConfig::Pulse(config)) => Ok(Some(Box::new(Pulse::connect(machine, config, at)?))),
    }
}
