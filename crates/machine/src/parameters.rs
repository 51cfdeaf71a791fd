//! The control's own parameters: what each one means, and the values set.
//!
//! The definitions are data files under `data/`, one pair per control, read once. Values are held flat
//! by number, since the interpreter asks for them block by block.

use crate::alarm::{Alarm, Argument, Fault};
use crate::messages::Catalogue;
use ferrocut_geometry::Axis;
use ferrocut_program::Span;
use std::collections::{BTreeMap, HashMap};
use std::fmt;
use std::str::FromStr;
use std::sync::OnceLock;

/// Highest number a parameter may carry; bounds the flat tables.
const LARGEST_NUMBER: u16 = 9999;

/// Most values kept for a control without a table; more can only be a damaged file.
const LARGEST_OPEN_TABLE: usize = 10_000;

/// The name of a parameter.
///
/// Its text form is that of set-up files: `P270`, `NO43.1` (also `NO43#1`), or a name such as
/// `FIXEDCYCLE_BACK`. Either case and leading zeros are read; `P024.0`, as some controls print their
/// bit parameters, is the same as `NO24.0`. [`ParameterTable::name`] writes it as the control does.
#[derive(Clone, PartialEq, Eq, Hash, Debug, PartialOrd, Ord)]
pub enum ParameterKey {
    /// One bit of a bit parameter.
    Bit {
        /// Number of the bit parameter.
        number: u16,
        /// Place of the bit, 0 is the lowest, 7 the highest.
        bit: u8,
    },
    /// A data parameter.
    Data(u16),
    /// A parameter that has a name instead of a number, in upper case.
    Named(Box<str>),
}

impl FromStr for ParameterKey {
    type Err = ParameterError;

    fn from_str(text: &str) -> Result<ParameterKey, ParameterError> {
        let upper = text.trim().to_ascii_uppercase();
        let starts_with_letter = upper.as_bytes().first().is_some_and(u8::is_ascii_alphabetic);
        let of_a_name = |b: u8| b.is_ascii_alphanumeric() || b"_.#".contains(&b);
        if !starts_with_letter || !upper.bytes().all(of_a_name) {
            return Err(ParameterError::Malformed(text.into()));
        }
        let numbered = upper.strip_prefix("NO").or_else(|| upper.strip_prefix('P'));
        let Some(rest) = numbered.filter(|r| r.as_bytes().first().is_some_and(u8::is_ascii_digit)) else {
            return Ok(ParameterKey::Named(upper.into()));
        };
        let malformed = || ParameterError::Malformed(text.into());
        let whole = |digits: &str| match digits.bytes().all(|b| b.is_ascii_digit()) {
            true => digits.parse::<u16>().map_err(|_| malformed()),
            false => Err(malformed()),
        };
        match rest.split_once(['.', '#']) {
            Some((number, bit)) => {
                let bit = u8::try_from(whole(bit)?).ok().filter(|b| *b < 8).ok_or_else(malformed)?;
                Ok(ParameterKey::Bit { number: whole(number)?, bit })
            }
            None if upper.starts_with('P') => Ok(ParameterKey::Data(whole(rest)?)),
            // A bit parameter as a whole is not a number anyone sets.
            None => Err(malformed()),
        }
    }
}

impl fmt::Display for ParameterKey {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        match self {
            ParameterKey::Bit { number, bit } => write!(f, "NO{number}.{bit}"),
            ParameterKey::Data(number) => write!(f, "P{number}"),
            ParameterKey::Named(name) => f.write_str(name),
        }
    }
}

/// `0 … 999.9999`, `≥ 0`; none where there is no bound.
pub fn range(min: Option<f64>, max: Option<f64>) -> Option<String> {
    match (min, max) {
        (Some(min), Some(max)) => Some(format!("{min} … {max}")),
        (Some(min), None) => Some(format!("≥ {min}")),
        (None, Some(max)) => Some(format!("≤ {max}")),
        (None, None) => None,
    }
}

/// Why a parameter cannot be set.
#[derive(Clone, PartialEq, Debug)]
pub enum ParameterError {
    /// Text that names no parameter.
    Malformed(Box<str>),
    /// A parameter that the control does not have.
    Unknown(Box<str>),
    /// A value outside the printed range.
    OutOfRange {
        /// Name of the parameter.
        name: Box<str>,
        /// The value that was to be set.
        value: f64,
        /// Smallest value, where there is one.
        min: Option<f64>,
        /// Largest value, where there is one.
        max: Option<f64>,
    },
    /// A bit that was to be neither 0 nor 1.
    NotABit(Box<str>, f64),
    /// A number of something, or of a choice, that was not to be whole.
    NotWhole(Box<str>, f64),
    /// More parameters than a control can have.
    TooMany,
}

impl ParameterError {
    /// The name of the parameter, where it is about one.
    pub fn name(&self) -> Option<&str> {
        match self {
            ParameterError::Malformed(name)
            | ParameterError::Unknown(name)
            | ParameterError::OutOfRange { name, .. }
            | ParameterError::NotABit(name, _)
            | ParameterError::NotWhole(name, _) => Some(name),
            ParameterError::TooMany => None,
        }
    }
}

impl fmt::Display for ParameterError {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        match self {
            ParameterError::Malformed(text) => {
                write!(f, "{text:?} names no parameter: write P270, NO43.1 or a name")
            }
            ParameterError::Unknown(name) => write!(f, "{name}: the control has no such parameter"),
            ParameterError::OutOfRange { name, value, min, max } => {
                write!(f, "{name} cannot be {value}: ")?;
                match (min, max) {
                    (Some(min), Some(max)) => write!(f, "it must be {min} to {max}"),
                    (Some(min), None) => write!(f, "it must be {min} or more"),
                    (None, Some(max)) => write!(f, "it must be {max} or less"),
                    (None, None) => write!(f, "it must be a number"),
                }
            }
            ParameterError::NotABit(name, value) => {
                write!(f, "{name} cannot be {value}: it is a bit, 0 or 1")
            }
            ParameterError::NotWhole(name, value) => {
                write!(f, "{name} cannot be {value}: it is a whole number")
            }
            ParameterError::TooMany => {
                write!(f, "too many parameters: no control has more than {LARGEST_OPEN_TABLE}")
            }
        }
    }
}

impl std::error::Error for ParameterError {}

impl ParameterError {
    /// Why it cannot be set, in the language of `texts`.
    pub fn told(&self, texts: Catalogue) -> String {
        let label = |key: &str, arguments: &[(&str, Argument)]| texts.label(key, arguments);
        let with_value = |key: &str, name: &str, value: f64| {
            label(key, &[("name", name.into()), ("value", value.to_string().into())])
        };
        match self {
            ParameterError::Malformed(text) => label("label-malformed-name", &[("name", (&**text).into())]),
            ParameterError::Unknown(name) => label("label-unknown-parameter", &[("name", (&**name).into())]),
            ParameterError::OutOfRange { name, value, min, max } => {
                let bounds = range(*min, *max).unwrap_or_else(|| label("label-any-number", &[]));
                let value = value.to_string();
                let arguments =
                    [("name", (&**name).into()), ("value", value.into()), ("range", bounds.into())];
                label("label-out-of-range", &arguments)
            }
            ParameterError::NotABit(name, value) => with_value("label-not-a-bit", name, *value),
            ParameterError::NotWhole(name, value) => with_value("label-not-whole", name, *value),
            ParameterError::TooMany => {
                let most = LARGEST_OPEN_TABLE.to_string();
                label("label-too-many-parameters", &[("max", most.into())])
            }
        }
    }

    /// The alarm that tells it, in the reader's language: `name` and `value`, with `min` and `max` as far as there are
    /// bounds; the name is called `whole` where only whole numbers mean something, `unknown` where there is no such
    /// parameter.
    pub fn alarm(&self) -> Alarm {
        let alarm = Alarm::core(Fault::MemoryValue, Span::default());
        let with_value = |name: &str, value: f64| alarm.clone().with("name", name).with("value", value);
        match self {
            ParameterError::Malformed(name) | ParameterError::Unknown(name) => alarm.with("unknown", &**name),
            ParameterError::OutOfRange { name, value, min, max } => {
                let bounds = [("min", min), ("max", max)];
                let known = bounds.into_iter().filter_map(|(of, bound)| Some((of, (*bound)?)));
                known.fold(with_value(name, *value), |alarm, (of, bound)| alarm.with(of, bound))
            }
            ParameterError::NotABit(name, value) => {
                with_value(name, *value).with("min", 0.0).with("max", 1.0)
            }
            ParameterError::NotWhole(name, value) => alarm.with("whole", &**name).with("value", *value),
            ParameterError::TooMany => alarm,
        }
    }
}

/// What the value of a parameter says.
#[derive(Clone, PartialEq, Debug)]
pub enum Meaning {
    /// A number.
    Value(Box<str>),
    /// One of two states.
    Bit {
        /// What 1 says.
        one: Box<str>,
        /// What 0 says.
        zero: Box<str>,
    },
}

/// One row of the control's parameter list.
#[derive(Clone, PartialEq, Debug)]
pub struct ParameterDef {
    /// The parameter.
    pub key: ParameterKey,
    /// Its name as the control writes it: `P270`, `NO43.1`, `P018.4`.
    pub name: Box<str>,
    /// Symbol of a bit as printed (`ODI`), a speaking name of a number (`g73_retract`).
    pub symbol: Box<str>,
    /// What it says.
    pub meaning: Meaning,
    /// Unit of a number as printed; empty where there is none.
    pub unit: Box<str>,
    /// Smallest value; none where the list prints none.
    pub min: Option<f64>,
    /// Largest value; none where the list prints none.
    pub max: Option<f64>,
    /// Value as delivered; 0 where the list prints none.
    pub default: f64,
    /// The axis it belongs to: `x`, `y`, `z`, or the axis' number; empty where it belongs to none.
    pub axis: Box<str>,
    /// The part of the control it acts on, such as `feed` or `canned-cycles`.
    pub applies_to: Box<str>,
    /// Whether the control does something with it; else it is kept with its value and nothing more.
    pub used: bool,
    /// Whether it counts or chooses, so that only whole numbers mean something.
    pub whole: bool,
}

impl ParameterDef {
    /// Whether the parameter may be `value`.
    fn check(&self, value: f64) -> Result<(), ParameterError> {
        if matches!(self.key, ParameterKey::Bit { .. }) {
            return match value == 0.0 || value == 1.0 {
                true => Ok(()),
                false => Err(ParameterError::NotABit(self.name.clone(), value)),
            };
        }
        // The list prints a default outside the range of a reserved parameter (P4).
        if value == self.default {
            return Ok(());
        }
        if self.whole && value.fract() != 0.0 {
            return Err(ParameterError::NotWhole(self.name.clone(), value));
        }
        let inside = value.is_finite()
            && self.min.is_none_or(|min| value >= min)
            && self.max.is_none_or(|max| value <= max);
        match inside {
            true => Ok(()),
            false => {
                let (min, max) = (self.min, self.max);
                Err(ParameterError::OutOfRange { name: self.name.clone(), value, min, max })
            }
        }
    }
}

/// The parameter list of a control.
#[derive(Debug, Default)]
pub struct ParameterTable {
    definitions: Vec<ParameterDef>,
    places: HashMap<ParameterKey, usize>,
    /// Definitions of the parameters with names, in the order of the list.
    named: Vec<usize>,
    /// Values as delivered, ready to be copied.
    delivered: Values,
    /// Names of bits are written like those of numbers, of three digits at least: `P018.4`.
    bits_like_numbers: bool,
}

static GSK990MC: OnceLock<ParameterTable> = OnceLock::new();
static KAITONG: OnceLock<ParameterTable> = OnceLock::new();
static WEIHONG: OnceLock<ParameterTable> = OnceLock::new();
static EMPTY: OnceLock<ParameterTable> = OnceLock::new();

impl ParameterTable {
    /// The list of the control that `dialect` belongs to; none where the control has no list here.
    pub fn of(dialect: &str) -> Option<&'static ParameterTable> {
        match dialect {
            "gsk990mc" => Some(GSK990MC.get_or_init(|| {
                ParameterTable::from_csv(
                    include_str!("../data/gsk990mc/bit-parameters.csv"),
                    include_str!("../data/gsk990mc/data-parameters.csv"),
                    false,
                )
            })),
            // What appendices 7, 10 and 11 of its manual name.
            "kaitong" => Some(KAITONG.get_or_init(|| {
                ParameterTable::from_csv(
                    include_str!("../data/kaitong/bit-parameters.csv"),
                    include_str!("../data/kaitong/data-parameters.csv"),
                    true,
                )
            })),
            "weihong" => Some(WEIHONG.get_or_init(|| {
                ParameterTable::of_names(include_str!("../data/weihong/named-parameters.csv"))
            })),
            _ => None,
        }
    }

    /// A list without a row. Parameters of such a control take every name and every number.
    pub fn empty() -> &'static ParameterTable {
        EMPTY.get_or_init(ParameterTable::default)
    }

    /// The name at a place among the parameters with names, counted from 0 in the order of the list.
    pub fn named_key(&self, place: u16) -> Option<&ParameterKey> {
        self.definitions.get(*self.named.get(usize::from(place))?).map(|definition| &definition.key)
    }

    /// Whether the parameter at a place among those with names is a length, or a feed, in mm.
    pub fn is_named_in_mm(&self, place: u16) -> bool {
        let definition = self.named.get(usize::from(place)).and_then(|at| self.definitions.get(*at));
        definition.is_some_and(|definition| definition.unit.starts_with("mm"))
    }

    /// Whether any name is taken, since no list says which exist.
    pub fn is_open(&self) -> bool {
        self.definitions.is_empty()
    }

    /// The name of a parameter as the control writes it.
    pub fn name(&self, key: &ParameterKey) -> String {
        match key {
            ParameterKey::Bit { number, bit } if self.bits_like_numbers => {
                format!("{}.{bit}", self.name_of_bits(*number))
            }
            key => key.to_string(),
        }
    }

    /// The name of a bit parameter with all its bits: `NO43`, `P018`.
    pub fn name_of_bits(&self, number: u16) -> String {
        if self.bits_like_numbers { format!("P{number:03}") } else { format!("NO{number}") }
    }

    /// The row of a parameter.
    pub fn get(&self, key: &ParameterKey) -> Option<&ParameterDef> {
        self.definitions.get(*self.places.get(key)?)
    }

    /// Every row: bits first, then numbers, each in the order of the list.
    pub fn iter(&self) -> impl Iterator<Item = &ParameterDef> {
        self.definitions.iter()
    }

    /// How many rows there are.
    pub fn len(&self) -> usize {
        self.definitions.len()
    }

    /// Whether there is no row.
    pub fn is_empty(&self) -> bool {
        self.definitions.is_empty()
    }

    /// Reads the two files of a control. A row that cannot be read is left out; a test holds that the
    /// files built in have none.
    fn from_csv(bits: &str, data: &str, bits_like_numbers: bool) -> ParameterTable {
        let mut table = ParameterTable { bits_like_numbers, ..ParameterTable::default() };
        for row in rows(bits) {
            if let Some(definition) = bit_row(&row) {
                table.add(definition);
            }
        }
        for row in rows(data) {
            if let Some(definition) = data_row(&row) {
                table.add(definition);
            }
        }
        table
    }

    /// Reads the file of a control whose parameters have names.
    fn of_names(data: &str) -> ParameterTable {
        let mut table = ParameterTable::default();
        for definition in rows(data).filter_map(|row| named_row(&row)) {
            table.add(definition);
        }
        table
    }

    fn add(&mut self, mut definition: ParameterDef) {
        definition.name = self.name(&definition.key).into();
        if let ParameterKey::Named(_) = definition.key {
            self.named.push(self.definitions.len());
            self.delivered.named.push(definition.default);
        }
        self.delivered.write(&definition.key, definition.default);
        self.places.insert(definition.key.clone(), self.definitions.len());
        self.definitions.push(definition);
    }
}

fn rows(text: &str) -> impl Iterator<Item = csv::StringRecord> {
    csv::Reader::from_reader(text.as_bytes()).into_records().flatten()
}

/// `no,bit,symbol,meaning_1,meaning_0,default,applies_to,used`
fn bit_row(row: &csv::StringRecord) -> Option<ParameterDef> {
    let number = row.get(0)?.parse().ok().filter(|n| *n <= LARGEST_NUMBER)?;
    let bit = row.get(1)?.parse().ok().filter(|b| *b < 8)?;
    Some(ParameterDef {
        key: ParameterKey::Bit { number, bit },
        name: "".into(),
        symbol: row.get(2)?.into(),
        meaning: Meaning::Bit { one: row.get(3)?.into(), zero: row.get(4)?.into() },
        unit: "".into(),
        min: Some(0.0),
        max: Some(1.0),
        default: number_or_none(row.get(5)?)?.unwrap_or(0.0),
        axis: "".into(),
        applies_to: row.get(6)?.into(),
        used: row.get(7) != Some("no"),
        whole: true,
    })
}

/// `no,name,meaning,unit,min,max,whole,default,axis,applies_to,used`
fn data_row(row: &csv::StringRecord) -> Option<ParameterDef> {
    let number = row.get(0)?.parse().ok().filter(|n| *n <= LARGEST_NUMBER)?;
    Some(ParameterDef {
        key: ParameterKey::Data(number),
        name: "".into(),
        symbol: row.get(1)?.into(),
        meaning: Meaning::Value(row.get(2)?.into()),
        unit: row.get(3)?.into(),
        min: number_or_none(row.get(4)?)?,
        max: number_or_none(row.get(5)?)?,
        whole: row.get(6)? == "yes",
        default: number_or_none(row.get(7)?)?.unwrap_or(0.0),
        axis: row.get(8)?.into(),
        applies_to: row.get(9)?.into(),
        used: row.get(10) != Some("no"),
    })
}

/// `name,symbol,meaning,unit,min,max,whole,default,axis,applies_to,used`
fn named_row(row: &csv::StringRecord) -> Option<ParameterDef> {
    // Behind the name stands what stands behind a number.
    let numbered: csv::StringRecord = std::iter::once("0").chain(row.iter().skip(1)).collect();
    Some(ParameterDef { key: ParameterKey::Named(row.get(0)?.into()), ..data_row(&numbered)? })
}

/// An empty cell is `Some(None)`, an unreadable one `None`.
fn number_or_none(cell: &str) -> Option<Option<f64>> {
    match cell.trim() {
        "" => Some(None),
        text => text.parse().ok().map(Some),
    }
}

/// Values flat by number.
#[derive(Clone, PartialEq, Debug, Default)]
struct Values {
    bits: Vec<u8>,
    data: Vec<f64>,
    /// By the place of the name in the list.
    named: Vec<f64>,
}

impl Values {
    fn read(&self, key: &ParameterKey) -> Option<f64> {
        match key {
            ParameterKey::Bit { number, bit } => {
                self.bits.get(usize::from(*number)).map(|byte| f64::from(byte >> (bit & 7) & 1))
            }
            ParameterKey::Data(number) => self.data.get(usize::from(*number)).copied(),
            ParameterKey::Named(_) => None,
        }
    }

    fn write(&mut self, key: &ParameterKey, value: f64) {
        match key {
            ParameterKey::Bit { number, bit } => {
                let place = usize::from(*number);
                if self.bits.len() <= place {
                    self.bits.resize(place + 1, 0);
                }
                if let Some(byte) = self.bits.get_mut(place) {
                    let mask = 1 << (bit & 7);
                    *byte = if value != 0.0 { *byte | mask } else { *byte & !mask };
                }
            }
            ParameterKey::Data(number) => {
                let place = usize::from(*number);
                if self.data.len() <= place {
                    self.data.resize(place + 1, 0.0);
                }
                if let Some(cell) = self.data.get_mut(place) {
                    *cell = value;
                }
            }
            ParameterKey::Named(_) => {}
        }
    }
}

/// The values of a control's parameters. Cloning copies a few kilobytes.
#[derive(Clone, Debug)]
pub struct Parameters {
    table: &'static ParameterTable,
    values: Values,
    /// What somebody has set, be it to the value as delivered; of a control without a list all that there is.
    given: BTreeMap<ParameterKey, f64>,
}

impl Parameters {
    /// The axes 1 to 5 by the names that P175 to P179 give them (GSK990MC 2.2 and appendix 1). Where two of
    /// the axes that the control carries (P5, at least four) have one name, they are X, Y, Z, A, B. A fifth
    /// name that is taken already is that of no axis.
    pub fn axis_names(&self) -> Vec<Axis> {
        let carried = if self.data(5) >= 5.0 { 5 } else { 4 };
        let mut names: Vec<Axis> = Vec::with_capacity(5);
        for number in 175..=179 {
            let name = Axis::ALL.get(self.data(number) as usize).copied();
            match name.filter(|name| !names.contains(name)) {
                Some(name) => names.push(name),
                None if names.len() < carried => return vec![Axis::X, Axis::Y, Axis::Z, Axis::A, Axis::B],
                None => {}
            }
        }
        names
    }

    /// The values as delivered.
    pub fn new(table: &'static ParameterTable) -> Parameters {
        Parameters { table, values: table.delivered.clone(), given: BTreeMap::new() }
    }

    /// The list of the control.
    pub fn table(&self) -> &'static ParameterTable {
        self.table
    }

    /// A bit of a bit parameter; false where the list has none.
    #[inline]
    pub fn bit(&self, number: u16, bit: u8) -> bool {
        self.values.bits.get(usize::from(number)).is_some_and(|byte| bit < 8 && byte >> bit & 1 == 1)
    }

    /// A data parameter in the unit of the list; 0 where the list has none.
    #[inline]
    pub fn data(&self, number: u16) -> f64 {
        self.values.data.get(usize::from(number)).copied().unwrap_or(0.0)
    }

    /// A named parameter; none where it was never set and the list has none.
    pub fn named(&self, name: &str) -> Option<f64> {
        let key = ParameterKey::Named(name.to_ascii_uppercase().into());
        match self.place_of(&key) {
            Some(place) => self.values.named.get(place).copied(),
            None => self.given.get(&key).copied(),
        }
    }

    /// The parameter at a place among those with names; 0 where there is none.
    #[inline]
    pub fn named_at(&self, place: u16) -> f64 {
        self.values.named.get(usize::from(place)).copied().unwrap_or(0.0)
    }

    /// The place of a name in the list.
    fn place_of(&self, key: &ParameterKey) -> Option<usize> {
        let definition = self.table.places.get(key)?;
        self.table.named.binary_search(definition).ok()
    }

    /// Any parameter; 0 where it was never set and the list has none.
    pub fn get(&self, key: &ParameterKey) -> f64 {
        match key {
            ParameterKey::Named(name) => self.named(name).unwrap_or(0.0),
            _ => self.values.read(key).unwrap_or(0.0),
        }
    }

    /// Whether a parameter may have a value.
    pub fn check(&self, key: &ParameterKey, value: f64) -> Result<(), ParameterError> {
        match self.table.get(key) {
            Some(definition) => definition.check(value),
            None if self.table.is_open() => self.check_open(key, value),
            None => Err(ParameterError::Unknown(self.table.name(key).into())),
        }
    }

    /// Sets a parameter, in the unit of the list.
    pub fn set(&mut self, key: &ParameterKey, value: f64) -> Result<(), ParameterError> {
        self.check(key, value)?;
        self.write(key, value);
        self.given.insert(key.clone(), value);
        Ok(())
    }

    fn write(&mut self, key: &ParameterKey, value: f64) {
        self.values.write(key, value);
        if let Some(slot) = self.place_of(key).and_then(|place| self.values.named.get_mut(place)) {
            *slot = value;
        }
    }

    /// A parameter has this value, and nobody has set it: it is as delivered, or shows what the control counts. Allocates
    /// nothing, since that goes on in the period.
    pub fn take_back(&mut self, key: &ParameterKey, value: f64) {
        if self.check(key, value).is_ok() {
            self.write(key, value);
            self.given.remove(key);
        }
    }

    fn check_open(&self, key: &ParameterKey, value: f64) -> Result<(), ParameterError> {
        let name = || Box::from(self.table.name(key));
        if let ParameterKey::Bit { number, .. } | ParameterKey::Data(number) = key
            && *number > LARGEST_NUMBER
        {
            return Err(ParameterError::Unknown(name()));
        }
        if matches!(key, ParameterKey::Bit { .. }) && value != 0.0 && value != 1.0 {
            return Err(ParameterError::NotABit(name(), value));
        }
        if !value.is_finite() {
            return Err(ParameterError::OutOfRange { name: name(), value, min: None, max: None });
        }
        if self.given.len() >= LARGEST_OPEN_TABLE && !self.given.contains_key(key) {
            return Err(ParameterError::TooMany);
        }
        Ok(())
    }

    /// Every row of the list with the present value.
    pub fn iter(&self) -> impl Iterator<Item = (&'static ParameterDef, f64)> {
        self.table.iter().map(|definition| (definition, self.get(&definition.key)))
    }

    /// Whether somebody has set it, be it to the value as delivered.
    pub fn is_given(&self, key: &ParameterKey) -> bool {
        self.given.contains_key(key)
    }

    /// What somebody has set, be it to the value as delivered.
    pub fn given(&self) -> impl Iterator<Item = (&ParameterKey, f64)> {
        self.given.iter().map(|(key, value)| (key, *value))
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    fn gsk() -> Parameters {
        Parameters::new(ParameterTable::of("gsk990mc").unwrap())
    }

    fn key(text: &str) -> ParameterKey {
        text.parse().unwrap()
    }

    #[test]
    fn names_are_read_in_every_form() {
        let bit = ParameterKey::Bit { number: 43, bit: 1 };
        for text in ["NO43.1", "NO43#1", "no43.1", "NO043.1", "P043.1"] {
            assert_eq!(key(text), bit, "{text}");
        }
        for text in ["P270", "p270", "P0270"] {
            assert_eq!(key(text), ParameterKey::Data(270), "{text}");
        }
        for text in ["FIXEDCYCLE_BACK", "CTP_POS.X", "PENUP", "NOTCH", "P"] {
            assert_eq!(key(text), ParameterKey::Named(text.into()));
            assert_eq!(key(&text.to_lowercase()).to_string(), text);
        }
        assert_eq!(bit.to_string(), "NO43.1");
        assert_eq!(ParameterKey::Data(270).to_string(), "P270");
        for text in ["", "43", "NO43", "NO43.8", "NO43.", "P27x", "P99999", "P1.2.3", "P+1", "a b", "Pä"] {
            let wrong = text.parse::<ParameterKey>();
            assert_eq!(wrong, Err(ParameterError::Malformed(text.into())));
        }
    }

    #[test]
    fn every_row_of_the_files_is_read_once() {
        let lines = |text: &str| text.lines().count() - 1;
        let files = [
            (
                "gsk990mc",
                include_str!("../data/gsk990mc/bit-parameters.csv"),
                include_str!("../data/gsk990mc/data-parameters.csv"),
                (224, 361),
            ),
            (
                "kaitong",
                include_str!("../data/kaitong/bit-parameters.csv"),
                include_str!("../data/kaitong/data-parameters.csv"),
                (22, 18),
            ),
        ];
        for (dialect, bits, data, counted) in files {
            let table = ParameterTable::of(dialect).unwrap();
            assert_eq!((lines(bits), lines(data)), counted, "{dialect}");
            assert_eq!(table.len(), lines(bits) + lines(data), "{dialect}");
            assert_eq!(table.places.len(), table.len(), "{dialect}");
        }
    }

    #[test]
    fn kaitong_writes_bits_like_numbers() {
        let mut p = Parameters::new(ParameterTable::of("kaitong").unwrap());
        // Appendix 7, 2.1 and 2.6: 1000 of 0.001 mm; appendix 11.
        assert_eq!((p.data(230), p.data(174), p.data(188)), (1000.0, 300.0, 5.0));
        p.set(&key("P018.4"), 1.0).unwrap();
        p.set(&key("P24.0"), 1.0).unwrap();
        assert!(p.bit(18, 4) && !p.bit(18, 5) && p.bit(24, 0));
        let names: Vec<_> = p.given().map(|(key, _)| p.table().name(key)).collect();
        assert_eq!(names, ["P018.4", "P024.0"]);
        assert_eq!(
            p.set(&key("P018.4"), 2.0).unwrap_err().to_string(),
            "P018.4 cannot be 2: it is a bit, 0 or 1"
        );
        assert_eq!(
            p.set(&key("P018.6"), 1.0).unwrap_err().to_string(),
            "P018.6: the control has no such parameter"
        );
        assert_eq!(p.table().name_of_bits(18), "P018");
        assert!(p.iter().all(|(definition, value)| definition.check(value).is_ok()));
    }

    #[test]
    fn values_as_delivered_lie_in_their_range() {
        for (definition, value) in gsk().iter() {
            assert_eq!(definition.check(value), Ok(()), "{}", definition.key);
            assert!(!definition.symbol.is_empty());
        }
        assert_eq!(gsk().given().count(), 0);
    }

    #[test]
    fn values_read_back() {
        let mut p = gsk();
        assert!(p.bit(40, 7) && p.bit(43, 1) && !p.bit(47, 7) && !p.bit(9999, 0) && !p.bit(43, 9));
        assert_eq!((p.data(270), p.data(214), p.data(3), p.data(60000)), (2.0, 0.05, 0.0, 0.0));
        p.set(&key("P270"), 1.5).unwrap();
        p.set(&key("NO40.7"), 0.0).unwrap();
        assert_eq!(p.data(270), 1.5);
        assert!(!p.bit(40, 7) && p.bit(40, 0) == gsk().bit(40, 0));
        // What is set to the value as delivered was set all the same.
        p.set(&key("P87"), 300.0).unwrap();
        let given = |p: &Parameters| p.given().map(|(k, v)| format!("{k}={v}")).collect::<Vec<_>>();
        assert_eq!(given(&p), ["NO40.7=0", "P87=300", "P270=1.5"]);
        p.take_back(&key("P270"), 2.0);
        assert_eq!((p.data(270), given(&p)), (2.0, vec!["NO40.7=0".to_owned(), "P87=300".to_owned()]));
        assert!(p.is_given(&key("P87")) && !p.is_given(&key("P270")));
    }

    #[test]
    fn wrong_values_are_refused_with_the_range() {
        let mut p = gsk();
        for (name, value, says) in [
            ("P270", -1.0, "P270 cannot be -1: it must be 0 to 999.9999"),
            ("P270", f64::NAN, "P270 cannot be NaN"),
            ("P380", f64::INFINITY, "P380 cannot be inf: it must be a number"),
            ("P206", 2.5, "P206 cannot be 2.5: it is a whole number"),
            ("NO40.7", 2.0, "NO40.7 cannot be 2: it is a bit, 0 or 1"),
            ("P3", 0.0, "P3: the control has no such parameter"),
            ("NO21.0", 0.0, "NO21.0: the control has no such parameter"),
            ("FIXEDCYCLE_BACK", 0.0, "FIXEDCYCLE_BACK: the control has no such parameter"),
        ] {
            let error = p.set(&key(name), value).unwrap_err().to_string();
            assert!(error.starts_with(says), "{error}");
        }
        assert_eq!(p.given().count(), 0);
        // The printed ranges of P339 and P340 are each other's; no range is printed of P380.
        assert!(p.set(&key("P340"), 65.0).is_err() && p.set(&key("P339"), -99.0).is_ok());
        assert_eq!(p.set(&key("P380"), 64.0), Ok(()));
    }

    /// What is refused is said in each language without a word of another.
    #[test]
    fn wrong_values_are_told_in_every_language() {
        use crate::messages::{Catalogue, Language};
        let p = gsk();
        for (name, value, english, chinese) in [
            ("P270", -1.0, "(P270 = -1: 0 to 999.9999)", "（P270 = -1：0 至 999.9999）"),
            ("P206", 2.5, "(P206 = 2.5: only whole numbers)", "（P206 = 2.5：只能是整数）"),
            ("NO40.7", 2.0, "(NO40.7 = 2: 0 to 1)", "（NO40.7 = 2：0 至 1）"),
            ("P3", 0.0, "(P3: the control has no such parameter)", "（P3：控制系统没有此参数）"),
            ("P380", f64::INFINITY, "(P380 = inf)", "（P380 = inf）"),
        ] {
            let alarm = p.check(&key(name), value).unwrap_err().alarm();
            for (language, says) in [(Language::En, english), (Language::Zh, chinese)] {
                let message = Catalogue::new(language).message(&alarm);
                assert!(message.ends_with(says), "{message}");
            }
        }
        let one_sided =
            |min, max| ParameterError::OutOfRange { name: "A".into(), value: 3.0, min, max }.alarm();
        let message = |alarm| Catalogue::new(Language::En).message(&alarm);
        assert!(message(one_sided(Some(4.0), None)).ends_with("(A = 3: 4 or more)"));
        assert!(message(one_sided(None, Some(2.0))).ends_with("(A = 3: 2 or less)"));
    }

    #[test]
    fn a_control_without_a_list_takes_any_name() {
        assert!(ParameterTable::of("rs274").is_none());
        let mut p = Parameters::new(ParameterTable::empty());
        p.set(&key("fixedcycle_back"), 1.0).unwrap();
        p.set(&key("P230"), 50.0).unwrap();
        p.set(&key("P024.0"), 1.0).unwrap();
        assert_eq!(p.named("FIXEDCYCLE_BACK"), Some(1.0));
        assert_eq!(p.named("SAFEHEIGHT"), None);
        assert_eq!((p.data(230), p.bit(24, 0), p.bit(24, 1)), (50.0, true, false));
        assert_eq!(p.given().count(), 3);
        assert!(p.set(&key("P1.0"), 0.5).is_err() && p.set(&key("P1"), f64::NAN).is_err());
        assert!(p.set(&ParameterKey::Data(10_000), 1.0).is_err());
    }
}
