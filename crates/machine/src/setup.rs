//! The set-up file: what an operator would have entered at the control before a program runs.
//!
//! Its keys are fixed; an unknown one is an error, since a misspelt offset would otherwise be a crash.
//! Positions are machine positions in mm and degrees; axes that are not named keep what they have.

use crate::config_error::ConfigError;
use crate::memory::Memory;
use crate::offsets::{ToolOffset, WorkOffset};
use crate::parameters::ParameterKey;
use ferrocut_geometry::{Axis, AxisName, AxisNames, AxisSet, Position};
use serde::de::{DeserializeOwned, Error};
use serde::{Deserialize, Deserializer};
use std::collections::BTreeMap;
use std::fmt::{self, Display};
use std::str::FromStr;

/// A set-up file.
#[derive(Clone, PartialEq, Debug, Default, Deserialize)]
#[serde(deny_unknown_fields, default)]
pub struct Setup {
    /// Control language of the programs that it is meant for.
    pub dialect: Option<String>,
    /// Machine position at the start.
    pub start: AxisValues,
    /// Zeros of the work coordinate systems.
    #[serde(deserialize_with = "by_name")]
    pub work_offsets: BTreeMap<WorkOffset, AxisValues>,
    /// Tool offsets by number.
    #[serde(deserialize_with = "tools_by_number")]
    pub tools: BTreeMap<u16, ToolSetup>,
    /// The control's own parameters.
    #[serde(deserialize_with = "numbers_by_name")]
    pub parameters: BTreeMap<ParameterKey, f64>,
    /// Macro variables.
    #[serde(deserialize_with = "numbers_by_name")]
    pub variables: BTreeMap<VariableName, f64>,
    /// Machine positions of the reference points.
    pub reference_points: ReferencePoints,
    /// Simulated inputs.
    pub signals: Signals,
    /// Switches of the operator's panel.
    pub options: Options,
    /// How a drawing is turned into a program, where the input is a drawing.
    pub import: Option<ImportSetup>,
}

/// Values for some axes, mm and degrees.
#[derive(Clone, PartialEq, Debug, Default)]
pub struct AxisValues {
    plain: Vec<(Axis, f64)>,
    /// Axes with a digit in their name.
    numbered: Vec<(AxisName, f64)>,
}

impl AxisValues {
    /// The values as a position, 0 where an axis is not named.
    pub fn position(&self) -> Position {
        self.position_of(&AxisNames::default())
    }

    /// The same on a machine whose axes have these names.
    pub fn position_of(&self, names: &AxisNames) -> Position {
        let mut position = Position::ZERO;
        self.write_to(&mut position, names);
        position
    }

    /// Writes the named axes of `position`.
    pub fn write_to(&self, position: &mut Position, names: &AxisNames) {
        for (axis, value) in self.iter() {
            position[axis] = value;
        }
        for (name, value) in &self.numbered {
            if let Some(axis) = names.find(*name) {
                position[axis] = *value;
            }
        }
    }

    /// The named axes with their values, those with a digit in their name left out.
    pub fn iter(&self) -> impl Iterator<Item = (Axis, f64)> {
        self.plain.iter().copied()
    }
}

/// One tool offset; what is not given stays as it is.
#[derive(Clone, PartialEq, Debug, Default, Deserialize)]
#[serde(deny_unknown_fields, default)]
pub struct ToolSetup {
    /// Geometry of the length, mm.
    pub length: Option<Number>,
    /// Wear of the length, mm.
    pub length_wear: Option<Number>,
    /// Geometry of the radius as it is entered in the control's table, mm.
    pub radius: Option<Number>,
    /// Wear of the radius, mm.
    pub radius_wear: Option<Number>,
    /// Length of the cutting edge, mm.
    pub cutting_length: Option<Number>,
    /// Steepest entry angle, degrees.
    pub entry_angle: Option<Number>,
    /// Radius of the tip, mm.
    pub tip_radius: Option<Number>,
}

impl ToolSetup {
    fn write_to(&self, row: &mut ToolOffset) {
        for (given, value) in [
            (self.length, &mut row.length),
            (self.length_wear, &mut row.length_wear),
            (self.radius, &mut row.radius),
            (self.radius_wear, &mut row.radius_wear),
            (self.cutting_length, &mut row.cutting_length),
            (self.entry_angle, &mut row.entry_angle),
            (self.tip_radius, &mut row.tip_radius),
        ] {
            if let Some(Number(given)) = given {
                *value = given;
            }
        }
    }
}

/// Machine positions of the reference points.
#[derive(Clone, PartialEq, Debug, Default, Deserialize)]
#[serde(deny_unknown_fields, default)]
pub struct ReferencePoints {
    /// The one that homing leads to.
    pub first: AxisValues,
    /// G30 P2.
    pub second: AxisValues,
    /// G30 P3.
    pub third: AxisValues,
    /// G30 P4.
    pub fourth: AxisValues,
}

/// Simulated inputs.
#[derive(Clone, PartialEq, Debug, Default, Deserialize)]
#[serde(deny_unknown_fields, default)]
pub struct Signals {
    /// When the skip signal comes; never, where not given.
    pub skip: Option<SkipSignal>,
    /// Inputs that keep one state, by the control's own addresses.
    #[serde(deserialize_with = "numbers_by_name")]
    pub inputs: BTreeMap<String, f64>,
}

/// The skip signal comes when an axis passes a machine position.
#[derive(Clone, Copy, PartialEq, Debug, Deserialize)]
#[serde(deny_unknown_fields)]
pub struct SkipSignal {
    /// The axis.
    #[serde(deserialize_with = "axis_name")]
    pub axis: Axis,
    /// Its machine position, mm or degrees.
    #[serde(deserialize_with = "number")]
    pub at: f64,
}

/// Switches of the operator's panel.
#[derive(Clone, Copy, PartialEq, Eq, Debug, Default, Deserialize)]
#[serde(deny_unknown_fields, default)]
pub struct Options {
    /// Blocks that begin with one `/` are left out.
    pub block_skip: bool,
    /// M01 stops.
    pub optional_stop: bool,
}

/// How a drawing is turned into a program. What is not given keeps the default of the importer.
#[derive(Clone, PartialEq, Debug, Default, Deserialize)]
#[serde(deny_unknown_fields, default)]
pub struct ImportSetup {
    /// Kind of drawing, `plt` or `dxf`; where it is not given, name and content of the drawing tell.
    pub format: Option<String>,
    /// Units of the drawing in one mm; for PLT 40 (HP-GL: 0.025 mm).
    pub units_per_mm: Option<Number>,
    /// Unit of a DXF drawing by name, in place of the one that it states.
    pub units: Option<String>,
    /// Factor on top of the unit.
    pub scale: Option<Number>,
    /// Coordinates of a PLT point, 2 or 3.
    pub dims: Option<Number>,
    /// Z while the pen is up, mm.
    pub pen_up: Option<Number>,
    /// Z while the pen is down, mm.
    pub pen_down: Option<Number>,
    /// Feed along the drawing, mm/min.
    pub feed: Option<Number>,
    /// Feed into the material, mm/min.
    pub plunge: Option<Number>,
    /// Spindle speed, r/min.
    pub spindle: Option<Number>,
    /// Tool number.
    pub tool: Option<Number>,
    /// How far arcs may lie from the curves of the drawing, mm.
    pub tolerance: Option<Number>,
    /// `as-drawn` or `shortest`.
    pub order: Option<String>,
    /// What differs on layers of a DXF drawing, by their names.
    pub layers: BTreeMap<String, CuttingSetup>,
    /// What differs for pens of a PLT drawing, by their numbers.
    pub pens: BTreeMap<String, CuttingSetup>,
}

/// How a layer or pen is cut where that differs from the rest of the drawing.
#[derive(Clone, PartialEq, Debug, Default, Deserialize)]
#[serde(deny_unknown_fields, default)]
pub struct CuttingSetup {
    /// Work Z, mm.
    pub depth: Option<Number>,
    /// Tool number.
    pub tool: Option<Number>,
    /// Feed along the drawing, mm/min.
    pub feed: Option<Number>,
    /// Feed into the material, mm/min.
    pub plunge: Option<Number>,
    /// Spindle speed, r/min.
    pub spindle: Option<Number>,
    /// Leaves it out.
    pub skip: bool,
}

/// The name of a macro variable.
#[derive(Clone, PartialEq, Eq, Hash, Debug, PartialOrd, Ord)]
pub enum VariableName {
    /// `#500`.
    Number(u32),
    /// A name of a control whose variables are not numbers, such as `P10` of Fagor.
    Named(Box<str>),
}

impl Display for VariableName {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        match self {
            VariableName::Number(number) => write!(f, "#{number}"),
            VariableName::Named(name) => f.write_str(name),
        }
    }
}

impl FromStr for VariableName {
    type Err = String;

    fn from_str(text: &str) -> Result<VariableName, String> {
        let digits = |t: &str| !t.is_empty() && t.bytes().all(|b| b.is_ascii_digit());
        match text.strip_prefix('#') {
            Some(number) if digits(number) => number
                .parse()
                .map(VariableName::Number)
                .map_err(|_| format!("{text:?} is beyond any variable")),
            None if digits(text) => Err(format!("{text:?} names no variable: write \"#{text}\"")),
            None if text.starts_with(|c: char| c.is_ascii_alphabetic()) => {
                Ok(VariableName::Named(text.into()))
            }
            _ => Err(format!("{text:?} names no variable: write \"#500\"")),
        }
    }
}

/// A finite number.
#[derive(Clone, Copy, PartialEq, Debug)]
pub struct Number(pub f64);

impl<'de> Deserialize<'de> for Number {
    fn deserialize<D: Deserializer<'de>>(from: D) -> Result<Number, D::Error> {
        #[derive(Deserialize)]
        #[serde(untagged, expecting = "expected a number")]
        enum Written {
            Number(f64),
        }
        let Written::Number(value) = Written::deserialize(from)?;
        finite(value).map(Number)
    }
}

fn finite<E: serde::de::Error>(value: f64) -> Result<f64, E> {
    match value.is_finite() {
        true => Ok(value),
        false => Err(E::custom(format!("{value} is no number that can be used"))),
    }
}

/// A number; `true` and `false` are read as 1 and 0, for bits and inputs.
struct NumberOrState(f64);

impl<'de> Deserialize<'de> for NumberOrState {
    fn deserialize<D: Deserializer<'de>>(from: D) -> Result<NumberOrState, D::Error> {
        #[derive(Deserialize)]
        #[serde(untagged, expecting = "expected a number")]
        enum Written {
            Number(f64),
            State(bool),
        }
        match Written::deserialize(from)? {
            Written::Number(value) => finite(value).map(NumberOrState),
            Written::State(state) => Ok(NumberOrState(f64::from(u8::from(state)))),
        }
    }
}

impl<'de> Deserialize<'de> for AxisValues {
    fn deserialize<D: Deserializer<'de>>(from: D) -> Result<AxisValues, D::Error> {
        let values: BTreeMap<AnyAxis, Number> = by_name(from)?;
        let mut axes = AxisValues::default();
        for (axis, Number(value)) in values {
            match axis {
                AnyAxis::Plain(axis) => axes.plain.push((axis, value)),
                AnyAxis::Numbered(name) => axes.numbered.push((name, value)),
            }
        }
        Ok(axes)
    }
}

#[derive(PartialEq, Eq, PartialOrd, Ord)]
enum AnyAxis {
    Plain(Axis),
    Numbered(AxisName),
}

impl FromStr for AnyAxis {
    type Err = String;

    fn from_str(text: &str) -> Result<AnyAxis, String> {
        let axis = match text.as_bytes() {
            [letter] => Axis::from_letter(*letter).map(AnyAxis::Plain),
            [letter, digit] => AxisName::numbered(*letter, *digit).map(AnyAxis::Numbered),
            _ => None,
        };
        axis.ok_or_else(|| format!("{text:?} is no axis: use one of x y z a b c u v w"))
    }
}

#[derive(PartialEq, Eq, PartialOrd, Ord)]
struct ToolNumber(u16);

impl FromStr for ToolNumber {
    type Err = String;

    fn from_str(text: &str) -> Result<ToolNumber, String> {
        let number = text.parse().ok().filter(|n| *n > 0).map(ToolNumber);
        number.ok_or_else(|| format!("{text:?} is no offset number: write [tools.1] and on"))
    }
}

/// A key read as the name it is, so that an error points at the key and not at its table, and its text.
struct Key<K>(K, String);

impl<'de, K: FromStr<Err: Display>> Deserialize<'de> for Key<K> {
    fn deserialize<D: Deserializer<'de>>(from: D) -> Result<Key<K>, D::Error> {
        let text = String::deserialize(from)?;
        let key = text.parse().map_err(D::Error::custom)?;
        Ok(Key(key, text))
    }
}

/// A table whose keys are names of one kind, each at most once however it is written.
fn by_name<'de, D, K, V>(from: D) -> Result<BTreeMap<K, V>, D::Error>
where
    D: Deserializer<'de>,
    K: FromStr<Err: Display> + Ord,
    V: DeserializeOwned,
{
    struct Entries<K, V>(std::marker::PhantomData<(K, V)>);

    impl<'de, K, V> serde::de::Visitor<'de> for Entries<K, V>
    where
        K: FromStr<Err: Display> + Ord,
        V: DeserializeOwned,
    {
        type Value = BTreeMap<K, V>;

        fn expecting(&self, f: &mut std::fmt::Formatter) -> std::fmt::Result {
            f.write_str("a table")
        }

        fn visit_map<A: serde::de::MapAccess<'de>>(self, mut entries: A) -> Result<Self::Value, A::Error> {
            let mut map = BTreeMap::new();
            while let Some(Key(key, name)) = entries.next_key()? {
                if map.insert(key, entries.next_value()?).is_some() {
                    return Err(A::Error::custom(format!("{name:?} stands twice in different forms")));
                }
            }
            Ok(map)
        }
    }

    from.deserialize_map(Entries(std::marker::PhantomData))
}

fn numbers_by_name<'de, D, K>(from: D) -> Result<BTreeMap<K, f64>, D::Error>
where
    D: Deserializer<'de>,
    K: FromStr<Err: Display> + Ord,
{
    let numbers: BTreeMap<K, NumberOrState> = by_name(from)?;
    Ok(numbers.into_iter().map(|(key, NumberOrState(value))| (key, value)).collect())
}

fn tools_by_number<'de, D: Deserializer<'de>>(from: D) -> Result<BTreeMap<u16, ToolSetup>, D::Error> {
    let tools: BTreeMap<ToolNumber, ToolSetup> = by_name(from)?;
    Ok(tools.into_iter().map(|(ToolNumber(number), tool)| (number, tool)).collect())
}

fn axis_name<'de, D: Deserializer<'de>>(from: D) -> Result<Axis, D::Error> {
    match String::deserialize(from)?.parse().map_err(D::Error::custom)? {
        AnyAxis::Plain(axis) => Ok(axis),
        AnyAxis::Numbered(_) => Err(D::Error::custom("the skip signal comes at one of x y z a b c u v w")),
    }
}

fn number<'de, D: Deserializer<'de>>(from: D) -> Result<f64, D::Error> {
    Number::deserialize(from).map(|Number(value)| value)
}

impl Setup {
    /// Reads a set-up file. The error shows the line and names the key.
    pub fn from_toml(text: &str) -> Result<Setup, ConfigError> {
        toml::from_str(text).map_err(|e| ConfigError::toml(&e))
    }

    /// The names of the machine's axes: an axis with a digit exists where the file names it.
    pub fn axis_names(&self) -> Result<AxisNames, ConfigError> {
        let points = &self.reference_points;
        let points = [&points.first, &points.second, &points.third, &points.fourth];
        let values = || std::iter::once(&self.start).chain(self.work_offsets.values()).chain(points);
        let taken: AxisSet = values().flat_map(AxisValues::iter).map(|(axis, _)| axis).collect();
        let mut names = AxisNames::default();
        for (name, _) in values().flat_map(|v| &v.numbered) {
            if !names.add(*name, taken) {
                let name: String = name.bytes().map(char::from).collect();
                return Err(ConfigError::label("label-config-no-place").with("name", name));
            }
        }
        Ok(names)
    }

    /// Enters the set-up into the memory of a control. The error names the section and the key.
    ///
    /// Parameters go first: an offset that also stands under `[work_offsets]` has the last word over
    /// the parameter that is another name of it.
    pub fn apply(&self, memory: &mut Memory) -> Result<(), ConfigError> {
        let names = self.axis_names()?;
        memory
            .set_parameters(self.parameters.iter().map(|(key, value)| (key, *value)))
            .map_err(ConfigError::parameter)?;
        for (name, values) in &self.work_offsets {
            let systems = memory.work.additional.len();
            let zero = memory.work.get_mut(*name).ok_or_else(|| {
                let error = ConfigError::label("label-config-work-offset").at("work_offsets", name);
                error.with("name", name).with("max", systems)
            })?;
            values.write_to(zero, &names);
        }
        for (number, tool) in &self.tools {
            let last = memory.tools.last();
            let row = memory.tools.get_mut(*number).ok_or_else(|| {
                let error = ConfigError::label("label-config-tool").at("tools", number);
                error.with("number", number).with("max", last)
            })?;
            tool.write_to(row);
        }
        for (name, value) in &self.variables {
            let set = match name {
                VariableName::Number(number) => memory.variables.set(*number, Some(*value)),
                VariableName::Named(name) => memory.variables.set_named(name, Some(*value)),
            };
            set.map_err(|e| ConfigError::variable("[variables]", e).at("variables", name))?;
        }
        let points = &self.reference_points;
        let points = [&points.first, &points.second, &points.third, &points.fourth];
        for (values, point) in points.into_iter().zip(&mut memory.reference_points) {
            values.write_to(point, &names);
        }
        Ok(())
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    /// Every section of the format in one file.
    const WHOLE: &str = r##"
dialect = "gsk990mc"

[start]
z = 50.0

[work_offsets]
G54 = { x = 10.0, Y = 10.0 }
"G54 P2" = { x = 1 }
external = { z = 1.0 }

[tools.1]
length = 4.0
length_wear = 0.0
radius = 5
radius_wear = 0.0
cutting_length = 20.0
entry_angle = 0.0
tip_radius = 1.5

[parameters]
P270 = 1.0
"NO43.1" = 0
"NO40#7" = false

[variables]
"#500" = 100.0
P10 = 2.0

[reference_points]
second = { z = 100.0 }

[signals]
skip = { axis = "x", at = 50.0 }
inputs = { "X04" = 1 }

[options]
block_skip = false
optional_stop = true
"##;

    #[test]
    fn a_whole_file_reaches_the_memory() {
        let setup = Setup::from_toml(WHOLE).unwrap();
        let mut memory = Memory::new("gsk990mc");
        setup.apply(&mut memory).unwrap();
        assert_eq!(setup.dialect.as_deref(), Some("gsk990mc"));
        assert_eq!(setup.start.position(), Position::xyz(0.0, 0.0, 50.0));
        assert_eq!(memory.work.standard[0], Position::xyz(10.0, 10.0, 0.0));
        assert_eq!(memory.work.additional[1], Position::xyz(1.0, 0.0, 0.0));
        assert_eq!(memory.work.external, Position::xyz(0.0, 0.0, 1.0));
        let tool = *memory.tools.get(1).unwrap();
        assert_eq!(
            tool,
            ToolOffset {
                length: 4.0,
                radius: 5.0,
                cutting_length: 20.0,
                tip_radius: 1.5,
                ..ToolOffset::ZERO
            }
        );
        assert_eq!(memory.parameters.data(270), 1.0);
        assert!(!memory.parameters.bit(43, 1) && !memory.parameters.bit(40, 7));
        assert_eq!(memory.variables.get(500), Some(100.0));
        assert_eq!(memory.variables.named("P10"), Some(2.0));
        assert_eq!(memory.reference_points[1], Position::xyz(0.0, 0.0, 100.0));
        assert_eq!(setup.signals.skip, Some(SkipSignal { axis: Axis::X, at: 50.0 }));
        assert_eq!(setup.signals.inputs.get("X04"), Some(&1.0));
        assert_eq!(setup.options, Options { block_skip: false, optional_stop: true });
    }

    #[test]
    fn everything_is_optional() {
        let setup = Setup::from_toml("").unwrap();
        assert_eq!(setup, Setup::default());
        setup.apply(&mut Memory::new("weihong")).unwrap();
    }

    #[test]
    fn what_is_not_named_stays() {
        let mut memory = Memory::new("gsk990mc");
        memory.work.standard[0] = Position::xyz(1.0, 2.0, 3.0);
        memory.tools.get_mut(3).unwrap().length = 9.0;
        let setup = Setup::from_toml("[work_offsets]\nG54 = { y = 5 }\n[tools.3]\nradius = 4.0\n").unwrap();
        setup.apply(&mut memory).unwrap();
        assert_eq!(memory.work.standard[0], Position::xyz(1.0, 5.0, 3.0));
        assert_eq!(memory.tools.get(3).map(|t| (t.length, t.radius)), Some((9.0, 4.0)));
    }

    #[test]
    fn a_bad_file_names_the_key() {
        for (text, says) in [
            ("strt = 1", "unknown field `strt`"),
            ("[start]\nq = 1.0", "\"q\" is no axis: use one of"),
            ("[start]\nxy = 1.0", "\"xy\" is no axis: use one of"),
            ("[start]\nx = \"1\"", "expected a number"),
            ("[start]\nx = nan", "NaN is no number"),
            ("[start]\nx = 1\nX = 2", "stands twice"),
            ("[work_offsets]\nG60 = { x = 1 }", "\"G60\" names no work offset: write external, G54"),
            ("[tools.0]\nlength = 1.0", "\"0\" is no offset number"),
            ("[tools.a]\nlength = 1.0", "\"a\" is no offset number"),
            ("[tools.1]\nlenght = 1.0", "unknown field `lenght`"),
            ("[tools.1]\nlength = true", "expected a number"),
            ("[start]\nx = false", "expected a number"),
            ("[variables]\n\"#500\" = inf", "inf is no number"),
            ("[parameters]\nNO43 = 1.0", "\"NO43\" names no parameter: write P270"),
            ("[parameters]\nP270 = 1.0\nP0270 = 2.0", " stands twice in different forms"),
            ("[variables]\n500 = 1.0", "write \"#500\""),
            ("[variables]\n\"#\" = 1.0", "\"#\" names no variable"),
            ("[reference_points]\nfifth = { x = 1 }", "unknown field `fifth`"),
            ("[signals]\nskip = { axis = \"x\" }", "missing field `at`"),
            ("[signals]\nskip = { axis = \"m\", at = 1 }", "\"m\" is no axis"),
            ("[options]\noptional_stop = 3", "invalid type"),
        ] {
            let error = Setup::from_toml(text).unwrap_err().to_string();
            assert!(error.contains(says), "{text}: {error}");
        }
    }

    #[test]
    fn what_the_control_does_not_have_names_the_key() {
        for (text, says) in [
            ("[parameters]\nP270 = -1", "[parameters] P270 cannot be -1: it must be 0 … 999.9999"),
            ("[parameters]\nP3 = 1", "[parameters] P3: the control has no such parameter"),
            ("[tools.256]\nlength = 1", "[tools.256]: the control has offset numbers 1 to 255"),
            ("[work_offsets]\n\"G54 P51\" = { x = 1 }", "G54 P51: the control has G54 P1 to P50"),
            ("[variables]\n\"#0\" = 1", "[variables]: #0 is always empty"),
        ] {
            let error = Setup::from_toml(text).unwrap().apply(&mut Memory::new("gsk990mc"));
            let error = error.unwrap_err().to_string();
            assert!(error.contains(says), "{text}: {error}");
        }
    }
}
