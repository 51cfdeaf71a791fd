//! The simulated machine: axes with lag, encoders and switches, a probe among blocks of metal, and what stands about
//! them. It has drives as a real one has them, and the inputs and outputs of the standard ladder.
//!
//! In: commanded positions and outputs Y. Out: where the axes are, and inputs X. Nothing of it is random, and a
//! period allocates nothing.
//!
//! Axes have names that the control gives to places, and physical places. Both are the same once the machine was
//! homed.

mod axis;
mod periphery;

use super::wires::AxisWires;
use super::{Contact, Drives, Switches};
use axis::{PlantedAxis, Where};
use ferrocut_geometry::{AXES, Axis, AxisSet, Position};
pub use ferrocut_machine::PlantBlock as Block;
use ferrocut_machine::{AxisConfig, Machine, PlantAxis, PlantConfig};
use periphery::Periphery;

/// What can go wrong with an axis.
#[derive(Clone, Copy, PartialEq, Eq, Debug)]
pub enum Trouble {
    /// It does not move.
    Stuck(bool),
    /// Its encoder gives no marker.
    NoMarker(bool),
    /// Its home switch is always on, or never; or it works again.
    HomeSwitch(Option<bool>),
}

/// Way outside the software limits to the travel switches, mm or degrees.
const TO_SWITCH: f64 = 10.0;
/// Part of the way from marker to marker between the home switch and the marker that is searched.
const OFF_SWITCH: f64 = 0.4;
/// Length of a home switch, mm or degrees.
const HOME_SWITCH: f64 = 30.0;
/// Way from the reference point to where an axis stands at power-on, mm or degrees.
const TO_REFERENCE: f64 = 80.0;

/// A simulated machine.
#[derive(Clone, Debug)]
pub struct Plant {
    axes: [Option<PlantedAxis>; AXES],
    /// Axes whose home switch is closed where it is reached.
    home_closes: AxisSet,
    absolute: bool,
    periphery: Periphery,
    blocks: Vec<Block>,
    armed: Option<Contact>,
    touches: bool,
    touched: Option<Position>,
    wires: AxisWires,
}

impl Plant {
    /// The machine of a file whose control takes it to stand at `called`, and has its reference point at `reference`.
    pub fn new(machine: &Machine, called: Position, reference: Position) -> Plant {
        let usual = PlantConfig::default();
        let config = machine.plant.as_ref().unwrap_or(&usual);
        let mut axes = [const { None }; AXES];
        for (axis, of) in machine.axes.iter().filter_map(|axis| Some((axis, axes_place(axis.name)?))) {
            if let Some(place) = axes.get_mut(of) {
                *place = Some(planted(machine, config, axis, called[axis.name], reference[axis.name]));
            }
        }
        let mut plant = Plant {
            axes,
            home_closes: machine.axes.iter().filter(|a| a.homing.closes).map(|a| a.name).collect(),
            absolute: machine.homing.absolute,
            periphery: Periphery::new(config, machine.servo_period_ms),
            blocks: Vec::new(),
            armed: None,
            touches: false,
            touched: None,
            wires: AxisWires::new(machine, &config.wiring, config.probe_opens.unwrap_or(false)),
        };
        config.blocks.iter().for_each(|block| plant.place(*block));
        plant
    }

    /// These axes stand where the control takes them to be: their places and names are the same.
    pub fn stand_as_called(&mut self, axes: AxisSet) {
        for axis in axes.iter() {
            if let Some(Some(axis)) = self.axes.get_mut(axis.index()) {
                axis.stand_as_called();
            }
        }
    }

    /// Puts a block into the machine that the probe can touch.
    pub fn place(&mut self, block: Block) {
        self.blocks.push(block);
        self.touches = self.is_inside(self.places());
    }

    /// Takes all blocks out.
    pub fn clear(&mut self) {
        self.blocks.clear();
        self.touches = false;
    }

    /// Where the axes are, physically.
    pub fn places(&self) -> Position {
        Position(std::array::from_fn(|i| self.axis_at(i).map_or(0.0, |axis| axis.place)))
    }

    /// Something goes wrong with an axis, or is right again.
    pub fn trouble(&mut self, axis: Axis, trouble: Trouble) {
        let Some(Some(axis)) = self.axes.get_mut(axis.index()) else { return };
        match trouble {
            Trouble::Stuck(is) => axis.stuck = is,
            Trouble::NoMarker(is) => axis.no_marker = is,
            Trouble::HomeSwitch(stays) => axis.home_stays = stays,
        }
    }

    /// The tool in the spindle, 0 for none, and the pocket of the magazine at the spindle.
    pub fn tool_and_pocket(&self) -> (u32, u32) {
        (self.periphery.tool(), self.periphery.pocket())
    }

    /// The tool that is in the spindle, 0 for none, and the pocket that is at it, counted from 1; every other tool is in the
    /// pocket of its number.
    pub fn stand_with(&mut self, tool: u32, pocket: u32) {
        self.periphery.stand_with(tool, pocket);
    }

    /// Opens or closes the door; whether it let itself be moved, which it does not while it is locked.
    pub fn move_door(&mut self, open: bool) -> bool {
        self.periphery.move_door(open)
    }

    /// Whether the door is open.
    pub fn door_is_open(&self) -> bool {
        self.periphery.door_is_open
    }

    /// Whether the emergency stop is pressed.
    pub fn emergency_stop_is_pressed(&self) -> bool {
        self.periphery.emergency_stop
    }

    /// Presses the emergency stop, or lets it out.
    pub fn press_emergency_stop(&mut self, pressed: bool) {
        self.periphery.emergency_stop = pressed;
    }

    /// A level or pressure by the name of its input (`AIR_PRESSURE`) is as it should be, or not; whether there is
    /// such an input.
    pub fn set_level(&mut self, name: &str, is_well: bool) -> bool {
        self.periphery.set_level(name, is_well)
    }

    fn axis_at(&self, index: usize) -> Option<&PlantedAxis> {
        self.axes.get(index).and_then(Option::as_ref)
    }

    fn set_of(&self, is: impl Fn(&PlantedAxis) -> bool) -> AxisSet {
        Axis::ALL.into_iter().filter(|axis| self.axis_at(axis.index()).is_some_and(&is)).collect()
    }

    fn is_inside(&self, place: Position) -> bool {
        let [x, y, z, ..] = place.0;
        let inside = |block: &Block| {
            [x, y, z].iter().zip(block.min).zip(block.max).all(|((at, min), max)| (min..=max).contains(at))
        };
        self.blocks.iter().any(inside)
    }

    /// The parts of this period's way from and to which the probe touches a block, where it does.
    fn contact(&self, block: &Block) -> Option<(f64, f64)> {
        let of = |i: usize| self.axis_at(i).map_or((0.0, 0.0), |axis| (axis.before, axis.place));
        let (mut enter, mut leave) = (0.0_f64, 1.0_f64);
        for (i, (min, max)) in block.min.into_iter().zip(block.max).enumerate() {
            let (from, to) = of(i);
            let step = to - from;
            if step == 0.0 {
                if from < min || from > max {
                    return None;
                }
            } else {
                let (near, far) = ((min - from) / step, (max - from) / step);
                (enter, leave) = (enter.max(near.min(far)), leave.min(near.max(far)));
            }
        }
        (enter <= leave).then_some((enter, leave))
    }

    /// The part of this period's way after which the probe touches first.
    fn touch(&self) -> Option<f64> {
        let contacts = self.blocks.iter().filter_map(|block| self.contact(block));
        contacts.map(|(enter, _)| enter).min_by(f64::total_cmp)
    }

    /// The part of it after which the probe is free; none where it touches something at the end.
    fn freed(&self) -> Option<f64> {
        let contacts = self.blocks.iter().filter_map(|block| self.contact(block));
        let last = contacts.map(|(_, leave)| leave).fold(0.0, f64::max);
        (!self.touches).then_some(last)
    }

    /// What the encoders count at a part of this period's way.
    fn counted(&self, part: f64) -> Position {
        Position(std::array::from_fn(|i| {
            self.axis_at(i).map_or(0.0, |axis| axis.called(axis.before + part * (axis.place - axis.before)))
        }))
    }
}

/// What a position loop of this gain, 1/s, leaves of its lag after a time, s.
pub(crate) fn kept(gain: f64, time: f64) -> f64 {
    let [[kept, _], _] = axis::over(gain, 0.0, time);
    kept
}

fn axes_place(axis: Axis) -> Option<usize> {
    Some(axis.index()).filter(|index| *index < AXES)
}

/// An axis of the machine file, with what is usual where the file says nothing.
fn planted(
    machine: &Machine,
    config: &PlantConfig,
    axis: &AxisConfig,
    called: f64,
    reference: f64,
) -> PlantedAxis {
    let usual = PlantAxis::new(axis.name);
    let found = config.axes.iter().find(|found| found.name == axis.name).unwrap_or(&usual);
    let up = if axis.homing.negative { -1.0 } else { 1.0 };
    let marker = found.marker.unwrap_or(reference - axis.homing.shift);
    // The way in which the axis leaves the switch: onwards, or back to its near side.
    let leaves = if machine.homing.before { -up } else { up };
    let edge = reference
        - axis.homing.shift
        - leaves * if machine.homing.marker { OFF_SWITCH * found.pitch } else { 0.0 };
    let far = edge - leaves * HOME_SWITCH;
    // An axis that is known from power-on stands where it is said to.
    let at = if machine.homing.absolute { called } else { reference - up * TO_REFERENCE };
    let place = Where {
        marker,
        home: found.home.unwrap_or([edge.min(far), edge.max(far)]),
        limits: found.limits.unwrap_or([axis.min - TO_SWITCH, axis.max + TO_SWITCH]),
        at: found.at.unwrap_or(at),
        called,
    };
    PlantedAxis::new(found, machine.servo_period_ms / 1000.0, &place)
}

impl Drives for Plant {
    fn exchange(&mut self, commanded: &Position) -> Position {
        let mut actual = *commanded;
        for ((axis, commanded), actual) in self.axes.iter_mut().zip(commanded.0).zip(&mut actual.0) {
            if let Some(axis) = axis {
                *actual = axis.follow(commanded);
            }
        }
        self.periphery.tick();
        self.touches = self.is_inside(self.places());
        let part = self.armed.and_then(|until| match until {
            Contact::Made => self.touch(),
            Contact::Lost => self.freed(),
        });
        if let Some(part) = part {
            self.touched = Some(self.counted(part));
            self.armed = None;
        }
        actual
    }

    fn rename(&mut self, at: &Position) {
        for (axis, at) in self.axes.iter_mut().zip(at.0) {
            if let Some(axis) = axis {
                axis.rename(at);
            }
        }
    }

    fn knows_places(&self) -> bool {
        self.absolute
    }

    fn switches(&self) -> Switches {
        let on = self.set_of(PlantedAxis::is_home);
        let is_open = |axis: &Axis| on.contains(*axis) != self.home_closes.contains(*axis);
        Switches {
            home: Axis::ALL.into_iter().filter(is_open).collect(),
            above: self.set_of(|axis| axis.is_beyond()[1]),
            below: self.set_of(|axis| axis.is_beyond()[0]),
            skip: self.touches,
        }
    }

    fn arm_marker(&mut self, axis: Axis) {
        if let Some(Some(axis)) = self.axes.get_mut(axis.index()) {
            axis.arm();
        }
    }

    fn marker(&self, axis: Axis) -> Option<f64> {
        self.axis_at(axis.index()).and_then(PlantedAxis::passed)
    }

    fn home_edge(&self, axis: Axis) -> Option<f64> {
        self.axis_at(axis.index()).and_then(PlantedAxis::edge)
    }

    fn has_probe(&self) -> bool {
        true
    }

    fn probe_opens(&self) -> bool {
        self.wires.probe_opens
    }

    fn arm_probe(&mut self, until: Contact) {
        let is_so = self.touches == (until == Contact::Made);
        self.touched = is_so.then(|| self.counted(1.0));
        self.armed = (!is_so).then_some(until);
    }

    fn probe(&self) -> Option<Position> {
        self.touched
    }

    fn read(&self, put: &mut dyn FnMut(u16, u8, bool)) {
        self.periphery.read(put);
        self.wires.put(&self.switches(), put);
    }

    fn write(&mut self, is_on: &dyn Fn(u16, u8) -> bool) {
        self.periphery.write(is_on);
    }

    fn plant(&mut self) -> Option<&mut Plant> {
        Some(self)
    }
}
