//! What Grbl tells: status reports, codes in force, offsets (Grbl 1.1, interface).

use super::machine::{Modal, Offsets, Overrides, Pins, Status};
use super::settings::Settings;
use ferrocut_geometry::{Axis, MM_PER_INCH, Position};
use std::fmt::Write;

/// Status reports between two that tell the work zero: at rest and in motion. Overrides come in the one behind.
const ZERO_EVERY: [u8; 2] = [10, 30];
const OVERRIDES_EVERY: [u8; 2] = [10, 20];

/// Lines that the planner is said to hold; senders take Grbl's own number for known.
pub const PLANNER: usize = 15;

/// Bytes that the receive buffer is said to hold.
pub const RECEIVE: usize = 128;

/// What a status report says beside the machine's own status.
pub struct Shown<'a> {
    /// `Idle`, `Hold:0` …
    pub state: &'a str,
    /// Bytes received and not run yet.
    pub received: usize,
    /// N word of the block that is run.
    pub number: Option<u32>,
    /// Overrides.
    pub overrides: Overrides,
}

/// Writes status reports.
#[derive(Clone, Debug)]
pub struct Reporter {
    axes: Vec<Axis>,
    /// Reports until the work zero and the overrides are told again.
    zero_in: u8,
    overrides_in: u8,
    /// As told last.
    told: Option<(Position, Overrides, [bool; 3])>,
}

impl Reporter {
    /// A reporter of these axes.
    pub fn new(axes: Vec<Axis>) -> Reporter {
        Reporter { axes, zero_in: 0, overrides_in: 0, told: None }
    }

    /// The next reports tell everything, as behind a reset.
    pub fn start_again(&mut self) {
        (self.zero_in, self.overrides_in, self.told) = (0, 1, None);
    }

    /// The letters of the axes.
    pub fn letters(&self) -> Vec<u8> {
        self.axes.iter().map(|axis| axis.letter() as u8).collect()
    }

    /// `<Idle|MPos:…>`
    pub fn status(&mut self, out: &mut String, status: &Status, shown: &Shown<'_>, settings: &Settings) {
        let unit = unit(settings);
        let zero = status.modal.zero;
        let _ = write!(out, "<{}|", shown.state);
        match settings.shows_machine() {
            true => {
                out.push_str("MPos:");
                self.position(out, status.position, unit);
            }
            false => {
                out.push_str("WPos:");
                self.position(out, status.position - zero, unit);
            }
        }
        if settings.shows_buffers() {
            let _ =
                write!(out, "|Bf:{},{}", status.room.min(PLANNER), RECEIVE.saturating_sub(shown.received));
        }
        if let Some(number) = shown.number {
            let _ = write!(out, "|Ln:{number}");
        }
        let _ = write!(out, "|FS:{:.0},{:.0}", no_minus(status.feed / unit, 0), status.rpm.abs());
        self.pins(out, &status.pins);
        let state =
            (zero, shown.overrides, [status.modal.flood, status.modal.mist, status.modal.spindle == 5]);
        let is_busy = usize::from(shown.state != "Idle");
        if self.told.is_none_or(|(told, ..)| told != zero) {
            self.zero_in = 0;
        }
        if self.told.is_none_or(|(_, overrides, more)| (overrides, more) != (state.1, state.2)) {
            self.overrides_in = 0;
        }
        if self.zero_in == 0 {
            self.zero_in = ZERO_EVERY.get(is_busy).copied().unwrap_or(1);
            // Not both in one report.
            self.overrides_in = self.overrides_in.max(1);
            out.push_str("|WCO:");
            self.position(out, zero, unit);
            self.told =
                Some((zero, self.told.map_or(state.1, |told| told.1), self.told.map_or(state.2, |t| t.2)));
        } else if self.overrides_in == 0 {
            self.overrides_in = OVERRIDES_EVERY.get(is_busy).copied().unwrap_or(1);
            let Overrides { feed, rapid, spindle } = shown.overrides;
            let _ = write!(out, "|Ov:{feed},{rapid},{spindle}");
            accessories(out, &status.modal);
            self.told = Some(state);
        }
        self.zero_in = self.zero_in.saturating_sub(1);
        self.overrides_in = self.overrides_in.saturating_sub(1);
        out.push_str(">\r\n");
    }

    /// `|Pn:PXYZDR`, in the order in which Grbl writes them; nothing while all are off.
    fn pins(&self, out: &mut String, pins: &Pins) {
        let limits = self.axes.iter().map(|axis| (pins.limits.contains(*axis), axis.letter()));
        let all = [(pins.probe, 'P')].into_iter().chain(limits).chain([(pins.door, 'D'), (pins.reset, 'R')]);
        let mut on = all.filter(|(is_on, _)| *is_on).map(|(_, letter)| letter).peekable();
        if on.peek().is_some() {
            out.push_str("|Pn:");
            out.extend(on);
        }
    }

    /// `$#`
    pub fn offsets(&self, out: &mut String, status: &Status, settings: &Settings) {
        let unit = unit(settings);
        let Offsets { systems, references, shift, length } = &status.offsets;
        let names = ["G54", "G55", "G56", "G57", "G58", "G59", "G28", "G30", "G92"];
        for (name, at) in names.into_iter().zip(systems.iter().chain(references).chain([shift])) {
            let _ = write!(out, "[{name}:");
            self.position(out, *at, unit);
            out.push_str("]\r\n");
        }
        let _ = write!(out, "[TLO:{:.3}]\r\n", no_minus(length / unit, 3));
        self.probe(out, status, settings);
    }

    /// `[PRB:…]`
    pub fn probe(&self, out: &mut String, status: &Status, settings: &Settings) {
        out.push_str("[PRB:");
        self.position(out, status.probe.0, unit(settings));
        let _ = write!(out, ":{}]\r\n", u8::from(status.probe.1));
    }

    fn position(&self, out: &mut String, at: Position, unit: f64) {
        for (number, axis) in self.axes.iter().enumerate() {
            let comma = if number == 0 { "" } else { "," };
            let value = if axis.is_linear() { at[*axis] / unit } else { at[*axis] };
            let digits = if unit == 1.0 { 3 } else { 4 };
            let _ = write!(out, "{comma}{:.digits$}", no_minus(value, digits));
        }
    }
}

/// `|A:SFM`
fn accessories(out: &mut String, modal: &Modal) {
    let all = [(modal.spindle == 3, 'S'), (modal.spindle == 4, 'C'), (modal.flood, 'F'), (modal.mist, 'M')];
    if all.iter().any(|(is_on, _)| *is_on) {
        out.push_str("|A:");
        out.extend(all.iter().filter(|(is_on, _)| *is_on).map(|(_, letter)| letter));
    }
}

/// `[GC:…]`, T as the sender gave it.
pub fn codes(out: &mut String, modal: &Modal, tool: u32, is_inch: bool) {
    out.push_str("[GC:");
    for tenths in modal.codes {
        let _ = match tenths % 10 {
            0 => write!(out, "G{} ", tenths / 10),
            part => write!(out, "G{}.{part} ", tenths / 10),
        };
    }
    let coolant = match (modal.mist, modal.flood) {
        (false, false) => "M9",
        (true, false) => "M7",
        (false, true) => "M8",
        (true, true) => "M7 M8",
    };
    // F is shown in the unit of reports; it is kept in that of the program.
    let program = if modal.is_inch() { MM_PER_INCH } else { 1.0 };
    let feed = modal.feed * program / if is_inch { MM_PER_INCH } else { 1.0 };
    let digits = if is_inch { 1 } else { 0 };
    let _ = write!(out, "M{} {coolant} T{tool} F{feed:.digits$} S{:.0}]\r\n", modal.spindle, modal.speed);
}

fn unit(settings: &Settings) -> f64 {
    if settings.is_inch() { MM_PER_INCH } else { 1.0 }
}

/// A value that is 0 as it is shown has no sign.
fn no_minus(value: f64, digits: usize) -> f64 {
    if value.abs() * 10f64.powi(digits as i32) < 0.5 { 0.0 } else { value }
}

#[cfg(test)]
mod tests {
    use super::*;
    use ferrocut_geometry::AxisSet;
    use ferrocut_machine::Machine;

    #[test]
    fn reports_read_as_grbl_writes_them() {
        let mut settings = Settings::new(&Machine::demo_mill(), b"XYZ");
        let mut reporter = Reporter::new(vec![Axis::X, Axis::Y, Axis::Z]);
        let mut status =
            Status { position: Position::xyz(1.5, -0.0001, 3.0), feed: 499.6, ..Status::default() };
        status.modal.zero = Position::xyz(1.0, 0.0, 2.5);
        let overrides = Overrides::default();
        let shown = Shown { state: "Idle", received: 28, number: None, overrides };
        let mut report = |status: &Status, settings: &Settings| {
            let mut out = String::new();
            reporter.status(&mut out, status, &shown, settings);
            out
        };
        assert_eq!(
            report(&status, &settings),
            "<Idle|MPos:1.500,0.000,3.000|FS:500,0|WCO:1.000,0.000,2.500>\r\n"
        );
        assert_eq!(report(&status, &settings), "<Idle|MPos:1.500,0.000,3.000|FS:500,0|Ov:100,100,100>\r\n");
        assert_eq!(report(&status, &settings), "<Idle|MPos:1.500,0.000,3.000|FS:500,0>\r\n");
        status.pins.limits = AxisSet::EMPTY.with(Axis::Z).with(Axis::X);
        (status.pins.probe, status.pins.door, status.pins.reset) = (true, true, true);
        assert_eq!(report(&status, &settings), "<Idle|MPos:1.500,0.000,3.000|FS:500,0|Pn:PXZDR>\r\n");
        status.pins = Pins::default();
        settings.set(10, 2.0).unwrap();
        settings.set(13, 1.0).unwrap();
        (status.modal.spindle, status.modal.flood, status.room) = (3, true, 900);
        assert_eq!(
            report(&status, &settings),
            "<Idle|WPos:0.0197,0.0000,0.0197|Bf:15,100|FS:20,0|Ov:100,100,100|A:SF>\r\n"
        );
    }

    #[test]
    fn codes_in_force_read_as_grbl_writes_them() {
        let mut out = String::new();
        codes(&mut out, &Modal::default(), 0, false);
        assert_eq!(out, "[GC:G0 G54 G17 G21 G90 G94 M5 M9 T0 F0 S0]\r\n");
    }
}
