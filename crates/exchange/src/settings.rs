//! How a drawing is cut: heights, feeds, tools, and what differs by layer or pen.

use crate::limits::FURTHEST;
use ferrocut_machine::setup::Number;
use ferrocut_machine::{Alarm, Argument, CuttingSetup, Fault, ImportSetup};
use ferrocut_program::Span;

/// Kind of drawing.
#[derive(Clone, Copy, PartialEq, Eq, Debug)]
pub enum Format {
    /// Plotter language (HP-GL).
    Plt,
    /// Drawing exchange format of AutoCAD.
    Dxf,
}

impl Format {
    /// The kind of this name.
    pub fn named(name: &str) -> Option<Format> {
        match name.to_ascii_lowercase().as_str() {
            "plt" | "hpgl" => Some(Format::Plt),
            "dxf" => Some(Format::Dxf),
            _ => None,
        }
    }

    /// Its name.
    pub fn name(self) -> &'static str {
        match self {
            Format::Plt => "PLT",
            Format::Dxf => "DXF",
        }
    }
}

/// In which order the lines of a drawing are cut.
#[derive(Clone, Copy, PartialEq, Eq, Debug, Default)]
pub enum Order {
    /// As they stand in the file.
    #[default]
    AsDrawn,
    /// Joined into chains, inner contours before outer, with short ways between.
    Shortest,
}

impl Order {
    /// The order of this name.
    pub fn named(name: &str) -> Option<Order> {
        match name {
            "as-drawn" => Some(Order::AsDrawn),
            "shortest" => Some(Order::Shortest),
            _ => None,
        }
    }
}

/// Units that a drawing may be in, and their length in mm.
const UNITS: &[(&str, f64)] = &[
    ("mm", 1.0),
    ("cm", 10.0),
    ("m", 1000.0),
    ("inch", 25.4),
    ("in", 25.4),
    ("foot", 304.8),
    ("ft", 304.8),
    ("um", 0.001),
    ("mil", 0.0254),
];

/// The length of the unit of this name, mm.
pub fn unit_named(name: &str) -> Option<f64> {
    UNITS.iter().find(|(known, _)| known.eq_ignore_ascii_case(name)).map(|(_, mm)| *mm)
}

/// How something is cut. Z values are work coordinates.
#[derive(Clone, Copy, PartialEq, Debug)]
pub struct Cutting {
    /// Z of the cut, mm.
    pub depth: f64,
    /// Tool; `None` leaves the one in the spindle.
    pub tool: Option<u32>,
    /// Feed along the drawing, mm/min.
    pub feed: f64,
    /// Feed into the material, mm/min.
    pub plunge: f64,
    /// Spindle speed, r/min; `None` leaves the spindle alone.
    pub spindle: Option<f64>,
}

/// What differs for a layer or pen.
#[derive(Clone, Copy, PartialEq, Debug, Default)]
pub struct Change {
    /// Z of the cut, mm.
    pub depth: Option<f64>,
    /// Tool.
    pub tool: Option<u32>,
    /// Feed along the drawing, mm/min.
    pub feed: Option<f64>,
    /// Feed into the material, mm/min.
    pub plunge: Option<f64>,
    /// Spindle speed, r/min.
    pub spindle: Option<f64>,
    /// Leaves it out.
    pub skip: bool,
}

/// How a drawing is turned into a program.
#[derive(Clone, PartialEq, Debug)]
pub struct Settings {
    /// Units of a PLT drawing in one mm (HP-GL: 0.025 mm).
    pub units_per_mm: f64,
    /// Unit of a DXF drawing, mm; `None`: as the drawing says, else mm.
    pub unit: Option<f64>,
    /// Factor on top of the unit.
    pub scale: f64,
    /// PLT points have a third coordinate, work Z.
    pub three_dimensional: bool,
    /// Z while the pen is up, mm.
    pub pen_up: f64,
    /// How everything is cut that has no row below.
    pub cutting: Cutting,
    /// How far arcs may lie from curves, mm.
    pub tolerance: f64,
    /// The order of cutting.
    pub order: Order,
    /// Layers by name.
    pub layers: Vec<(Box<str>, Change)>,
    /// Pens by number.
    pub pens: Vec<(Box<str>, Change)>,
}

/// Tolerances that arcs may be given, mm. Below a micrometre rounding to the control's increment would
/// count for more than the fit.
pub const TOLERANCES: std::ops::RangeInclusive<f64> = 0.001..=10.0;

/// What the rounding of a program's numbers may add to the distance from the curve, mm: half an increment
/// of 0.1 µm in X and Y, for ends and centres.
pub const ROUNDING: f64 = 2e-4;

impl Default for Settings {
    fn default() -> Settings {
        Settings {
            units_per_mm: 40.0,
            unit: None,
            scale: 1.0,
            three_dimensional: false,
            pen_up: 5.0,
            cutting: Cutting { depth: -1.0, tool: None, feed: 600.0, plunge: 300.0, spindle: None },
            tolerance: 0.01,
            order: Order::AsDrawn,
            layers: Vec::new(),
            pens: Vec::new(),
        }
    }
}

/// The orders of cutting.
pub const ORDERS: &str = "shortest, as-drawn";
/// Kinds of drawings.
pub const FORMATS: &str = "plt, dxf";
/// What a row of a layer or pen is, as on the command line.
pub const ROW: &str = "NAME=DEPTH,TOOL[,F…][,P…][,S…], NAME=skip";

/// The units of a drawing.
pub fn units() -> String {
    UNITS.iter().map(|(name, _)| *name).collect::<Vec<_>>().join(", ")
}

/// Largest scale, and units in a mm.
const LARGEST_SCALE: f64 = 1e9;
/// Fastest feed and spindle.
const FASTEST: f64 = 1e6;

/// What is wrong with a setting, and what it may be.
fn wrong(setting: &str, value: impl ToString, allowed: impl Into<Argument>) -> Box<Alarm> {
    let alarm = Alarm::core(Fault::ImportSetting, Span::default());
    Box::new(alarm.with("setting", setting).with("value", value.to_string()).with("allowed", allowed))
}

/// A number above 0 and up to another.
fn up_to(most: f64) -> String {
    format!("> 0, ≤ {most}")
}

impl Settings {
    /// Settings with those of a set-up file, and the format where it names one.
    pub fn of(setup: &ImportSetup, order: Order) -> Result<(Settings, Option<Format>), Box<Alarm>> {
        let mut settings = Settings { order, ..Settings::default() };
        let set = |place: &mut f64, value: Option<Number>| {
            if let Some(Number(value)) = value {
                *place = value;
            }
        };
        set(&mut settings.units_per_mm, setup.units_per_mm);
        set(&mut settings.scale, setup.scale);
        set(&mut settings.pen_up, setup.pen_up);
        set(&mut settings.cutting.depth, setup.pen_down);
        set(&mut settings.cutting.feed, setup.feed);
        set(&mut settings.cutting.plunge, setup.plunge);
        set(&mut settings.tolerance, setup.tolerance);
        settings.cutting.spindle = setup.spindle.map(|Number(n)| n);
        settings.cutting.tool = setup.tool.map(tool).transpose()?;
        if let Some(Number(dims)) = setup.dims {
            settings.three_dimensional = match dims {
                2.0 => false,
                3.0 => true,
                _ => return Err(wrong("dims", dims, "2, 3")),
            };
        }
        if let Some(name) = &setup.units {
            settings.unit = Some(unit_named(name).ok_or_else(|| wrong("units", name, units()))?);
        }
        if let Some(name) = &setup.order {
            settings.order = Order::named(name).ok_or_else(|| wrong("order", name, ORDERS))?;
        }
        let change = |(name, setup): (&String, &CuttingSetup)| Ok((name.as_str().into(), Change::of(setup)?));
        settings.layers = setup.layers.iter().map(change).collect::<Result<_, Box<Alarm>>>()?;
        settings.pens = setup.pens.iter().map(change).collect::<Result<_, Box<Alarm>>>()?;
        let format = |name: &String| Format::named(name).ok_or_else(|| wrong("format", name, FORMATS));
        let format = setup.format.as_ref().map(format).transpose()?;
        settings.check()?;
        Ok((settings, format))
    }

    /// Whether the settings can be used. The alarm names what cannot be as a set-up file has it.
    pub fn check(&self) -> Result<(), Box<Alarm>> {
        self.check_named(&|key| key)
    }

    /// The same where settings were given by other names: `named` has that of a key of the table `[import]`.
    pub fn check_named(&self, named: &dyn Fn(&'static str) -> &'static str) -> Result<(), Box<Alarm>> {
        let positive = [("units_per_mm", self.units_per_mm), ("scale", self.scale)];
        let unit = self.unit.map(|unit| ("units", unit));
        if let Some((name, value)) =
            positive.into_iter().chain(unit).find(|(_, v)| !(*v > 0.0 && *v <= LARGEST_SCALE))
        {
            return Err(wrong(named(name), value, up_to(LARGEST_SCALE)));
        }
        if !TOLERANCES.contains(&self.tolerance) {
            let allowed = format!("{} … {}", TOLERANCES.start(), TOLERANCES.end());
            return Err(wrong(named("tolerance"), self.tolerance, allowed));
        }
        if self.three_dimensional && self.order == Order::Shortest {
            return Err(wrong(named("order"), "shortest, dims 3", "as-drawn"));
        }
        let safe = named("pen_up");
        check_height(safe, self.pen_up)?;
        self.check_cutting(&self.cutting, safe, named)?;
        // A row has the same keys wherever it was given.
        let in_row = |key| if key == "pen_down" { "depth" } else { key };
        for (_, change) in self.layers.iter().chain(&self.pens).filter(|(_, change)| !change.skip) {
            self.check_cutting(&self.changed(change), safe, &in_row)?;
        }
        Ok(())
    }

    fn check_cutting(
        &self,
        cutting: &Cutting,
        safe: &str,
        named: &dyn Fn(&'static str) -> &'static str,
    ) -> Result<(), Box<Alarm>> {
        let depth = named("pen_down");
        check_height(depth, cutting.depth)?;
        // Ways are run at rapid; in space the drawing itself says how deep it is cut.
        if self.pen_up <= cutting.depth && !self.three_dimensional {
            let value = format!("{}, {depth} {}", self.pen_up, cutting.depth);
            return Err(wrong(safe, value, format!("> {}", cutting.depth)));
        }
        let rates =
            [("feed", Some(cutting.feed)), ("plunge", Some(cutting.plunge)), ("spindle", cutting.spindle)];
        let bad = |(_, rate): &(&'static str, Option<f64>)| {
            rate.is_some_and(|rate| !(rate > 0.0 && rate <= FASTEST))
        };
        match rates.into_iter().find(bad) {
            Some((name, rate)) => Err(wrong(named(name), rate.unwrap_or(0.0), up_to(FASTEST))),
            None => Ok(()),
        }
    }

    fn changed(&self, change: &Change) -> Cutting {
        let cutting = self.cutting;
        Cutting {
            depth: change.depth.unwrap_or(cutting.depth),
            tool: change.tool.or(cutting.tool),
            feed: change.feed.unwrap_or(cutting.feed),
            plunge: change.plunge.unwrap_or(cutting.plunge),
            spindle: change.spindle.or(cutting.spindle),
        }
    }

    /// How a layer or pen is cut; `None` if it is left out.
    pub fn of_layer(&self, format: Format, name: &str) -> Option<Cutting> {
        let rows = match format {
            Format::Dxf => &self.layers,
            Format::Plt => &self.pens,
        };
        // The last row wins: that of the command line.
        match rows.iter().rev().find(|(known, _)| is_layer(known, name)) {
            Some((_, change)) if change.skip => None,
            Some((_, change)) => Some(self.changed(change)),
            None => Some(self.cutting),
        }
    }
}

/// Whether two names are those of one layer: capitals do not count.
pub fn is_layer(one: &str, other: &str) -> bool {
    one == other || one.to_lowercase() == other.to_lowercase()
}

fn tool(Number(number): Number) -> Result<u32, Box<Alarm>> {
    if number.fract() == 0.0 && (0.0..=99_999_999.0).contains(&number) {
        Ok(number as u32)
    } else {
        Err(wrong("tool", number, "0 … 99999999"))
    }
}

fn check_height(name: &str, value: f64) -> Result<(), Box<Alarm>> {
    let allowed = || format!("-{FURTHEST} … {FURTHEST}");
    if value.abs() <= FURTHEST { Ok(()) } else { Err(wrong(name, value, allowed())) }
}

impl Change {
    fn of(setup: &CuttingSetup) -> Result<Change, Box<Alarm>> {
        let value = |number: Option<Number>| number.map(|Number(value)| value);
        Ok(Change {
            depth: value(setup.depth),
            tool: setup.tool.map(tool).transpose()?,
            feed: value(setup.feed),
            plunge: value(setup.plunge),
            spindle: value(setup.spindle),
            skip: setup.skip,
        })
    }

    /// Reads `depth,tool` and words behind them, as on the command line: `-3,2`, `-3,2,F500,S8000`,
    /// `Z-3,T2,P200`, `skip`. `None` if it cannot be read.
    pub fn parse(text: &str) -> Option<Change> {
        if text.trim().eq_ignore_ascii_case("skip") {
            return Some(Change { skip: true, ..Change::default() });
        }
        let mut change = Change::default();
        for (place, item) in text.split(',').map(str::trim).enumerate() {
            let letter = item.chars().next()?.to_ascii_uppercase();
            let (letter, value) = match (letter.is_ascii_alphabetic(), place) {
                (true, _) => (letter, item.get(1..)?),
                (false, 0) => ('Z', item),
                (false, 1) => ('T', item),
                _ => return None,
            };
            let number: f64 = value.trim().parse().ok().filter(|n: &f64| n.is_finite())?;
            let place = match letter {
                'Z' => &mut change.depth,
                'F' => &mut change.feed,
                'P' => &mut change.plunge,
                'S' => &mut change.spindle,
                'T' if change.tool.is_none() => {
                    change.tool = Some(tool(Number(number)).ok()?);
                    continue;
                }
                _ => return None,
            };
            if place.replace(number).is_some() {
                return None;
            }
        }
        Some(change)
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn a_layer_on_the_command_line() {
        let change = |text| Change::parse(text);
        let two = Change { depth: Some(-3.0), tool: Some(2), ..Change::default() };
        assert_eq!(change("-3,2"), Some(two));
        assert_eq!(change("Z-3, t2"), Some(two));
        assert_eq!(change("-3,2,F500,S8000,P100").unwrap().spindle, Some(8000.0));
        assert!(change("skip").unwrap().skip);
        for bad in ["", "-3,2,5", "x3", "-3,-2", "-3,T1.5", "-3,Z-4", "nan", "-3,,5", "é"] {
            assert_eq!(change(bad), None, "{bad}");
        }
    }

    #[test]
    fn the_last_row_of_a_layer_wins_and_capitals_do_not_count() {
        let deep = |depth| Change { depth: Some(depth), ..Change::default() };
        let settings = Settings {
            layers: vec![
                ("Outline".into(), deep(-2.0)),
                ("OUTLINE".into(), deep(-4.0)),
                ("x".into(), Change { skip: true, ..deep(0.0) }),
            ],
            ..Settings::default()
        };
        let depth = |name| settings.of_layer(Format::Dxf, name).map(|cutting| cutting.depth);
        assert_eq!(depth("outline"), Some(-4.0));
        assert_eq!((depth("X"), depth("other")), (None, Some(-1.0)));
    }

    #[test]
    fn settings_that_cannot_be_used_are_refused() {
        let sane = Settings::default();
        assert!(sane.check().is_ok());
        let row = |depth, skip| vec![("1".into(), Change { depth, skip, ..Change::default() })];
        // What is left out has no depth.
        assert!(Settings { layers: row(Some(6.0), true), ..sane.clone() }.check().is_ok());
        for bad in [
            Settings { scale: 0.0, ..sane.clone() },
            Settings { scale: f64::NAN, ..sane.clone() },
            Settings { units_per_mm: -40.0, ..sane.clone() },
            Settings { tolerance: 0.0, ..sane.clone() },
            Settings { pen_up: f64::INFINITY, ..sane.clone() },
            Settings { pen_up: -5.0, ..sane.clone() },
            Settings { pen_up: -1.0, ..sane.clone() },
            Settings { cutting: Cutting { depth: 10.0, ..sane.cutting }, ..sane.clone() },
            Settings { layers: row(Some(6.0), false), ..sane.clone() },
            Settings { pens: row(Some(5.0), false), ..sane.clone() },
            Settings { cutting: Cutting { feed: 0.0, ..sane.cutting }, ..sane.clone() },
            Settings { three_dimensional: true, order: Order::Shortest, ..sane.clone() },
        ] {
            assert!(bad.check().is_err(), "{bad:?}");
        }
    }
}
