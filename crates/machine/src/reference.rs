//! What a control's manual says of its codes, variables and words, for people who ask.
//!
//! The interpreter does not read these tables: it has its own, of what codes do. A test of the command
//! line holds the two against each other. The texts are data files under `data/`, read once.
//!
//! What belongs together (the parameters that bear on a code, the alarms that it can raise) is found
//! from the texts themselves, which name codes, parameters and alarms as the manual does ([`mentions`]),
//! and from a list of what the manual says elsewhere (`related.csv`).

use crate::alarm::AlarmId;
use crate::alarm_table::alarm_table;
use crate::messages::{Catalogue, Language};
use crate::parameters::{Meaning, ParameterDef, ParameterKey, ParameterTable};
use std::ops::RangeInclusive;
use std::sync::OnceLock;

/// Data parameters below this number (ports, language) bear on no program, while `P1` to `P6` in a text
/// are words of a block.
const FIRST_MENTIONED: u16 = 10;

/// A G code, or one of its forms.
#[derive(Clone, PartialEq, Debug)]
pub struct GCodeRow {
    /// The number in tenths: G54 is 540.
    pub tenths: u16,
    /// What tells a form from the code itself, such as `L2` of `G10 L2`; empty for the code.
    pub form: Box<str>,
    /// Modal group as printed: `09`; `00/01` where a parameter decides.
    pub group: Box<str>,
    /// Whether it stays in force; none where that depends or is not said.
    pub is_modal: Option<bool>,
    /// Whether it is in force at power-on.
    pub at_power_on: bool,
    /// How it is written.
    pub format: Box<str>,
    /// What it does.
    pub meaning: Box<str>,
    /// Sections of the manual.
    pub section: Box<str>,
}

impl GCodeRow {
    /// `G84`, `G10 L2`.
    pub fn name(&self) -> String {
        let code = g_code_name(self.tenths);
        if self.form.is_empty() { code } else { format!("{code} {}", self.form) }
    }

    /// Whether it is the form of a code that stands with this word, `L2`, `H1` as `H01`, or `P7` as any `Pn`.
    pub fn is_form(&self, word: &str) -> bool {
        let split = |text: &str| {
            let (letter, number) = text.split_at_checked(1)?;
            Some((letter.to_ascii_uppercase(), number.parse::<u16>().ok()))
        };
        let (Some((own, number)), Some((letter, asked))) = (split(&self.form), split(word)) else {
            return false;
        };
        own == letter && number.is_none_or(|number| asked == Some(number))
    }

    /// Number of its modal group; 0 for codes that are not modal.
    pub fn group_number(&self) -> Option<u8> {
        self.group.split('/').next()?.parse().ok()
    }
}

/// `G84` of 840, `G54.1` of 541.
pub fn g_code_name(tenths: u16) -> String {
    match tenths % 10 {
        0 => format!("G{:02}", tenths / 10),
        tenth => format!("G{:02}.{tenth}", tenths / 10),
    }
}

/// An M code.
#[derive(Clone, PartialEq, Debug)]
pub struct MCodeRow {
    /// The number.
    pub code: u16,
    /// Who carries it out: `program-control`, `internal` or `plc`.
    pub class: Box<str>,
    /// Whether it waits for the end of the block's motion.
    pub after_motion: bool,
    /// What it does; empty where the manual names it only.
    pub meaning: Box<str>,
    /// Sections of the manual.
    pub section: Box<str>,
}

/// Macro variables with one meaning.
#[derive(Clone, PartialEq, Debug)]
pub struct VariableRow {
    /// First and last number.
    pub numbers: RangeInclusive<u32>,
    /// What they hold.
    pub meaning: Box<str>,
    /// `read`, `write` or `read/write`; empty where the manual does not say.
    pub access: Box<str>,
    /// What else is to know.
    pub notes: Box<str>,
}

impl VariableRow {
    /// `#5206-#5209`, `#3000`.
    pub fn name(&self) -> String {
        let (first, last) = (self.numbers.start(), self.numbers.end());
        if first == last { format!("#{first}") } else { format!("#{first}-#{last}") }
    }
}

/// A word of the macro language.
#[derive(Clone, PartialEq, Debug)]
pub struct MacroWordRow {
    /// The word in upper case.
    pub word: Box<str>,
    /// How it is written.
    pub format: Box<str>,
    /// What it does.
    pub meaning: Box<str>,
}

/// Something that has a number and texts.
#[derive(Clone, PartialEq, Eq, Debug)]
pub enum Subject {
    /// A G code, in tenths.
    G(u16),
    /// An M code.
    M(u16),
    /// A parameter.
    Parameter(ParameterKey),
    /// An alarm by the control's own number.
    Alarm(u16),
    /// A macro variable.
    Variable(u32),
}

/// What a text names. Ranges hold their ends.
#[derive(Clone, PartialEq, Eq, Debug)]
pub enum Mention {
    /// `G84`, `G17-G19`; in tenths.
    G(RangeInclusive<u16>),
    /// `G group 09`.
    Group(u8),
    /// `M29`.
    M(RangeInclusive<u16>),
    /// `P270`, `P335-P338`, `P216 to P230`.
    Data(RangeInclusive<u16>),
    /// `42#5`, `#15.0`, `NO43.1`, `P018.4`, `47#3-47#5`.
    Bits(u16, RangeInclusive<u8>),
    /// `alarm 0020`.
    Alarm(u16),
    /// `#5206`, `#100-#199`.
    Variables(RangeInclusive<u32>),
    /// `FIXEDCYCLE_BACK`: a word in capitals that may be the name of a parameter.
    Name(Box<str>),
}

/// What bears on a code although no text of either names the other.
#[derive(Debug)]
struct Related {
    code: Subject,
    parameters: Vec<Mention>,
    alarms: Vec<u16>,
}

/// The tables of a control.
#[derive(Debug)]
pub struct Reference {
    dialect: &'static str,
    parameters: &'static ParameterTable,
    g_codes: Vec<GCodeRow>,
    m_codes: Vec<MCodeRow>,
    variables: Vec<VariableRow>,
    addresses: Vec<(u8, Box<str>)>,
    macro_words: Vec<MacroWordRow>,
    related: Vec<Related>,
}

/// The tables of a control from its folder of data, and the words of its macro language from another where it
/// shares them.
macro_rules! tables_of {
    ($dialect:literal) => {
        tables_of!($dialect, $dialect)
    };
    ($dialect:literal, $words:literal) => {
        Reference {
            dialect: $dialect,
            parameters: ParameterTable::of($dialect).unwrap_or_else(ParameterTable::empty),
            g_codes: table(include_str!(concat!("../data/", $dialect, "/g-codes.csv")), g_code_row),
            m_codes: table(include_str!(concat!("../data/", $dialect, "/m-codes.csv")), m_code_row),
            variables: table(
                include_str!(concat!("../data/", $dialect, "/system-variables.csv")),
                variable_row,
            ),
            addresses: table(include_str!(concat!("../data/", $dialect, "/addresses.csv")), address_row),
            macro_words: table(include_str!(concat!("../data/", $words, "/macro-words.csv")), macro_word_row),
            related: table(include_str!(concat!("../data/", $dialect, "/related.csv")), related_row),
        }
    };
}

static GSK990MC: OnceLock<Reference> = OnceLock::new();
static KAITONG: OnceLock<Reference> = OnceLock::new();
static WEIHONG: OnceLock<Reference> = OnceLock::new();
static FAGOR8065: OnceLock<Reference> = OnceLock::new();
static RS274: OnceLock<Reference> = OnceLock::new();

impl Reference {
    /// The tables of the control that `dialect` belongs to; none where there are none.
    pub fn of(dialect: &str) -> Option<&'static Reference> {
        match dialect {
            "gsk990mc" => Some(GSK990MC.get_or_init(|| tables_of!("gsk990mc", "fanuc"))),
            "kaitong" => Some(KAITONG.get_or_init(|| tables_of!("kaitong", "fanuc"))),
            "weihong" => Some(WEIHONG.get_or_init(|| tables_of!("weihong"))),
            "fagor8065" => Some(FAGOR8065.get_or_init(|| tables_of!("fagor8065"))),
            "rs274" => Some(RS274.get_or_init(|| tables_of!("rs274"))),
            _ => None,
        }
    }

    /// Every G code, each before its forms.
    pub fn g_codes(&self) -> &[GCodeRow] {
        &self.g_codes
    }

    /// The code with this number in tenths, without its forms.
    pub fn g_code(&self, tenths: u16) -> Option<&GCodeRow> {
        self.g_codes.iter().find(|row| row.tenths == tenths && row.form.is_empty())
    }

    /// The forms of a code that have a row of their own.
    pub fn forms(&self, tenths: u16) -> impl Iterator<Item = &GCodeRow> {
        self.g_codes.iter().filter(move |row| row.tenths == tenths && !row.form.is_empty())
    }

    /// Every M code.
    pub fn m_codes(&self) -> &[MCodeRow] {
        &self.m_codes
    }

    /// The M code with this number.
    pub fn m_code(&self, code: u16) -> Option<&MCodeRow> {
        self.m_codes.iter().find(|row| row.code == code)
    }

    /// Every row of variables; rows overlap where a group has details.
    pub fn variables(&self) -> &[VariableRow] {
        &self.variables
    }

    /// The rows that hold a variable, the closest first.
    pub fn variable(&self, number: u32) -> Vec<&VariableRow> {
        let mut rows: Vec<&VariableRow> =
            self.variables.iter().filter(|row| row.numbers.contains(&number)).collect();
        rows.sort_by_key(|row| row.numbers.end() - row.numbers.start());
        rows
    }

    /// What an address letter stands for.
    pub fn address(&self, letter: u8) -> Option<&str> {
        self.addresses.iter().find(|(l, _)| *l == letter.to_ascii_uppercase()).map(|(_, text)| &**text)
    }

    /// Every word of the macro language.
    pub fn macro_words(&self) -> &[MacroWordRow] {
        &self.macro_words
    }

    /// A word of the macro language, in either case.
    pub fn macro_word(&self, word: &str) -> Option<&MacroWordRow> {
        self.macro_words.iter().find(|row| row.word.eq_ignore_ascii_case(word))
    }

    /// The parameters that bear on something, in the order of the list.
    pub fn parameters_of(&self, subject: &Subject) -> Vec<&'static ParameterDef> {
        let of = |d: &&ParameterDef| self.are_related(subject, &Subject::Parameter(d.key.clone()));
        self.parameters.iter().filter(of).collect()
    }

    /// The control's own alarms that have to do with something, by number.
    pub fn alarms_of(&self, subject: &Subject) -> Vec<AlarmId> {
        let ids = alarm_table(self.dialect).iter().map(|row| row.id);
        ids.filter(|id| id.number().is_some_and(|n| self.are_related(subject, &Subject::Alarm(n)))).collect()
    }

    /// The codes that have to do with something: G codes, then M codes.
    pub fn codes_of(&self, subject: &Subject) -> Vec<Subject> {
        let own = self.g_codes.iter().filter(|row| row.form.is_empty());
        let g = own.map(|row| Subject::G(row.tenths));
        let m = self.m_codes.iter().map(|row| Subject::M(row.code));
        g.chain(m).filter(|code| self.are_related(subject, code)).collect()
    }

    fn are_related(&self, a: &Subject, b: &Subject) -> bool {
        let names = |of: &Subject, other: &Subject| {
            self.texts(of).iter().any(|text| mentions(text).iter().any(|m| self.is_meant(m, other)))
        };
        a != b && (names(a, b) || names(b, a) || self.is_listed(a, b) || self.is_listed(b, a))
    }

    /// Whether `related.csv` names the two together.
    fn is_listed(&self, code: &Subject, other: &Subject) -> bool {
        self.related.iter().filter(|row| row.code == *code).any(|row| match other {
            Subject::Alarm(number) => row.alarms.contains(number),
            _ => row.parameters.iter().any(|m| self.is_meant(m, other)),
        })
    }

    fn is_meant(&self, mention: &Mention, subject: &Subject) -> bool {
        match (mention, subject) {
            (Mention::G(codes), Subject::G(tenths)) => codes.contains(tenths),
            (Mention::Group(group), Subject::G(tenths)) => {
                self.g_code(*tenths).and_then(GCodeRow::group_number) == Some(*group)
            }
            (Mention::M(codes), Subject::M(code)) => codes.contains(code),
            (Mention::Data(numbers), Subject::Parameter(ParameterKey::Data(n))) => numbers.contains(n),
            (Mention::Bits(of, bits), Subject::Parameter(ParameterKey::Bit { number, bit })) => {
                of == number && bits.contains(bit)
            }
            (Mention::Name(name), Subject::Parameter(ParameterKey::Named(n))) => name == n,
            (Mention::Alarm(number), Subject::Alarm(n)) => number == n,
            (Mention::Variables(numbers), Subject::Variable(n)) => numbers.contains(n),
            _ => false,
        }
    }

    /// What is written of something, in English.
    fn texts(&self, subject: &Subject) -> Vec<String> {
        match subject {
            Subject::G(tenths) => {
                self.g_codes.iter().filter(|r| r.tenths == *tenths).map(|r| r.meaning.to_string()).collect()
            }
            Subject::M(code) => self.m_code(*code).map(|r| r.meaning.to_string()).into_iter().collect(),
            Subject::Parameter(key) => match self.parameters.get(key).map(|d| &d.meaning) {
                None => Vec::new(),
                Some(Meaning::Value(text)) => vec![text.to_string()],
                Some(Meaning::Bit { one, zero }) => vec![one.to_string(), zero.to_string()],
            },
            Subject::Alarm(number) => {
                let id = AlarmId::Dialect(self.dialect, *number);
                let english = Catalogue::new(Language::En);
                [english.text(id), english.help_of(id)].into_iter().flatten().collect()
            }
            // The whole range of a group says nothing of one of its variables.
            Subject::Variable(number) => {
                let closest = self.variable(*number).into_iter().next();
                closest.map(|row| row.meaning.to_string()).into_iter().collect()
            }
        }
    }
}

/// Reads a table with a header. A row that cannot be read is left out; a test holds that there is none.
fn table<T>(text: &str, row: impl Fn(&csv::StringRecord) -> Option<T>) -> Vec<T> {
    csv::Reader::from_reader(text.as_bytes()).records().flatten().filter_map(|r| row(&r)).collect()
}

/// `code,group,modal,power_on_default,format,meaning,high_speed_mode,section`
fn g_code_row(row: &csv::StringRecord) -> Option<GCodeRow> {
    let code = row.get(0)?;
    let (code, form) = code.split_once(' ').unwrap_or((code, ""));
    let (whole, tenth) = code.strip_prefix('G')?.split_once('.').unwrap_or((code.strip_prefix('G')?, "0"));
    let (whole, tenth): (u16, u16) = (whole.parse().ok()?, tenth.parse().ok().filter(|tenth| *tenth < 10)?);
    Some(GCodeRow {
        tenths: whole.checked_mul(10)?.checked_add(tenth)?,
        form: form.into(),
        group: row.get(1)?.into(),
        is_modal: match row.get(2)? {
            "yes" => Some(true),
            "no" => Some(false),
            _ => None,
        },
        at_power_on: row.get(3)? == "yes",
        format: row.get(4)?.into(),
        meaning: row.get(5)?.into(),
        section: row.get(7)?.into(),
    })
}

/// `code,class,timing,meaning,section`
fn m_code_row(row: &csv::StringRecord) -> Option<MCodeRow> {
    Some(MCodeRow {
        code: row.get(0)?.strip_prefix('M')?.parse().ok()?,
        class: row.get(1)?.into(),
        after_motion: match row.get(2)? {
            "after" => true,
            "with" => false,
            _ => return None,
        },
        meaning: row.get(3)?.into(),
        section: row.get(4)?.into(),
    })
}

/// `number_range,meaning,read_write,notes`
fn variable_row(row: &csv::StringRecord) -> Option<VariableRow> {
    let number = |text: &str| text.strip_prefix('#')?.parse::<u32>().ok();
    let range = row.get(0)?;
    let (first, last) = range.split_once('-').unwrap_or((range, range));
    Some(VariableRow {
        numbers: number(first)?..=number(last)?,
        meaning: row.get(1)?.into(),
        access: row.get(2)?.into(),
        notes: row.get(3)?.into(),
    })
}

/// `letter,meaning`
fn address_row(row: &csv::StringRecord) -> Option<(u8, Box<str>)> {
    match row.get(0)?.as_bytes() {
        [letter] => Some((*letter, row.get(1)?.into())),
        _ => None,
    }
}

/// `word,form,meaning`
fn macro_word_row(row: &csv::StringRecord) -> Option<MacroWordRow> {
    Some(MacroWordRow { word: row.get(0)?.into(), format: row.get(1)?.into(), meaning: row.get(2)?.into() })
}

/// `code,parameters,alarms`
fn related_row(row: &csv::StringRecord) -> Option<Related> {
    let code = match mentions(row.get(0)?).as_slice() {
        [Mention::G(codes)] => Subject::G(*codes.start()),
        [Mention::M(codes)] => Subject::M(*codes.start()),
        _ => return None,
    };
    let alarms = row.get(2)?.split_whitespace().map(|n| n.parse().ok()).collect::<Option<_>>()?;
    Some(Related { code, parameters: mentions(row.get(1)?), alarms })
}

/// The codes, parameters, alarms and variables that a text names, in the ways of the manual.
pub fn mentions(text: &str) -> Vec<Mention> {
    let mut found = Vec::new();
    let mut rest = text;
    // Whether what stands before is not part of a name or number, and whether it is a G code: `P` behind
    // one is a word of the block (`G54 P1`).
    let (mut at_start, mut behind_code) = (true, false);
    while let Some(first) = rest.chars().next() {
        if at_start && let Some((mention, behind)) = mention(rest) {
            let is_word = behind_code && matches!(mention, Mention::Data(_));
            behind_code = matches!(mention, Mention::G(_));
            if !is_word && !is_word_of_a_block(&mention) {
                found.push(mention);
            }
            rest = behind;
            at_start = false;
            continue;
        }
        behind_code &= first == ' ';
        at_start = !first.is_alphanumeric() && first != '#';
        rest = rest.get(first.len_utf8()..).unwrap_or("");
    }
    found
}

fn is_word_of_a_block(mention: &Mention) -> bool {
    matches!(mention, Mention::Data(numbers) if *numbers.start() < FIRST_MENTIONED)
}

/// Letters of the shortest name of a parameter.
const SHORTEST_NAME: usize = 7;

/// What a text begins with, and the text behind it.
fn mention(text: &str) -> Option<(Mention, &str)> {
    if let Some(rest) = text.strip_prefix("G group ") {
        let (group, rest) = whole(rest)?;
        return Some((Mention::Group(group), rest));
    }
    if let Some(rest) = text.strip_prefix("alarm ") {
        let (number, rest) = whole(rest)?;
        return Some((Mention::Alarm(number), rest));
    }
    if let Some(((number, bit), rest)) = bit(text) {
        let (last, rest) = range(rest, bit, |t| {
            Some(self::bit(t)?).filter(|((n, _), _)| *n == number).map(|((_, b), r)| (b, r))
        });
        return Some((Mention::Bits(number, bit..=last), rest));
    }
    let end = text.find(|c: char| !(c.is_ascii_uppercase() || c.is_ascii_digit() || matches!(c, '_' | '.')));
    let name = text.get(..end.unwrap_or(text.len()))?.trim_end_matches('.');
    if name.len() >= SHORTEST_NAME && name.bytes().take(3).all(|b| b.is_ascii_uppercase()) {
        return Some((Mention::Name(name.into()), text.get(name.len()..)?));
    }
    let mut letters = text.chars();
    let letter = letters.next().filter(|l| matches!(l, 'G' | 'M' | 'P' | '#'))?;
    let number = |t| whole::<u32>(str::strip_prefix(t, letter)?);
    let (first, rest) = number(text)?;
    if rest.starts_with(|c: char| c.is_ascii_alphabetic()) {
        return None;
    }
    let (last, rest) = range(rest, first, number);
    let codes = |factor: u16| {
        let small = |n: u32| u16::try_from(n).ok()?.checked_mul(factor);
        Some(small(first)?..=small(last)?)
    };
    let mention = match letter {
        'G' => Mention::G(codes(10)?),
        'M' => Mention::M(codes(1)?),
        'P' => Mention::Data(codes(1)?),
        _ => Mention::Variables(first..=last),
    };
    Some((mention, rest))
}

/// The end of a range whose start is `first`, where the text goes on as one: `-P338`, ` to P338`.
fn range<'a, T: PartialOrd + Copy>(
    text: &'a str,
    first: T,
    read: impl Fn(&'a str) -> Option<(T, &'a str)>,
) -> (T, &'a str) {
    let behind = text.strip_prefix('-').or_else(|| text.strip_prefix(" to "));
    let last = behind.and_then(read).filter(|(last, _)| *last > first);
    last.unwrap_or((first, text))
}

/// `42#5`, `#15.0`, `NO43.1` or `P018.4`.
fn bit(text: &str) -> Option<((u16, u8), &str)> {
    let named = text.strip_prefix('#').or_else(|| text.strip_prefix("NO")).or_else(|| text.strip_prefix('P'));
    let (number, rest, mark) = match named {
        Some(rest) => whole(rest).map(|(n, rest)| (n, rest, '.'))?,
        None => whole(text).map(|(n, rest)| (n, rest, '#'))?,
    };
    let (bit, rest) = whole::<u8>(rest.strip_prefix(mark)?)?;
    (bit < 8).then_some(((number, bit), rest))
}

fn whole<T: std::str::FromStr>(text: &str) -> Option<(T, &str)> {
    let end = text.find(|c: char| !c.is_ascii_digit()).unwrap_or(text.len());
    let (digits, rest) = text.split_at_checked(end)?;
    Some((digits.parse().ok()?, rest))
}

#[cfg(test)]
mod tests {
    use super::*;

    fn gsk() -> &'static Reference {
        Reference::of("gsk990mc").unwrap()
    }

    fn key(text: &str) -> ParameterKey {
        text.parse().unwrap()
    }

    fn parameters_of(subject: Subject) -> Vec<String> {
        gsk().parameters_of(&subject).iter().map(|d| d.key.to_string()).collect()
    }

    /// The dialects that have tables, and the texts of these.
    macro_rules! files {
        ($($dialect:literal),+) => {
            [$((
                $dialect,
                [
                    include_str!(concat!("../data/", $dialect, "/g-codes.csv")),
                    include_str!(concat!("../data/", $dialect, "/m-codes.csv")),
                    include_str!(concat!("../data/", $dialect, "/system-variables.csv")),
                    include_str!(concat!("../data/", $dialect, "/addresses.csv")),
                    include_str!(concat!("../data/", $dialect, "/related.csv")),
                ],
            )),+]
        };
    }

    const FILES: [(&str, [&str; 5]); 5] = files!("gsk990mc", "kaitong", "weihong", "fagor8065", "rs274");

    #[test]
    fn every_row_of_the_files_is_read() {
        let lines = |text: &str| text.lines().count() - 1;
        for (dialect, files) in FILES {
            let r = Reference::of(dialect).unwrap();
            let read =
                [r.g_codes.len(), r.m_codes.len(), r.variables.len(), r.addresses.len(), r.related.len()];
            assert_eq!(read, files.map(lines), "{dialect}");
            let words = match dialect {
                "weihong" => include_str!("../data/weihong/macro-words.csv"),
                "fagor8065" => include_str!("../data/fagor8065/macro-words.csv"),
                "rs274" => include_str!("../data/rs274/macro-words.csv"),
                _ => include_str!("../data/fanuc/macro-words.csv"),
            };
            assert_eq!(r.macro_words.len(), lines(words), "{dialect}");
        }
        let r = gsk();
        assert_eq!((r.g_codes.len(), r.m_codes.len(), r.variables.len()), (115, 33, 77));
        assert!(Reference::of("sinumerik").is_none());
    }

    #[test]
    fn parameters_with_names_bear_on_codes() {
        let weihong = Reference::of("weihong").unwrap();
        let of =
            |subject| weihong.parameters_of(&subject).iter().map(|d| d.key.to_string()).collect::<Vec<_>>();
        assert_eq!(of(Subject::G(730)), ["FIXEDCYCLE_BACK"]);
        assert_eq!(of(Subject::G(9080)), ["ISYREVAXIS", "WPREVDIAM", "UNIT.YR"]);
        assert_eq!(
            weihong.codes_of(&Subject::Parameter(key("FIXEDCYCLE_OSS"))),
            [Subject::G(760), Subject::G(870)]
        );
        assert_eq!(weihong.g_code(501).unwrap().name(), "G50.1");
    }

    #[test]
    fn what_is_listed_as_related_exists() {
        let rows = |(dialect, _)| {
            let r = Reference::of(dialect).unwrap();
            r.related.iter().map(move |row| (r, row))
        };
        for (r, row) in FILES.into_iter().flat_map(rows) {
            match row.code {
                Subject::G(tenths) => assert!(r.g_code(tenths).is_some(), "{row:?}"),
                Subject::M(code) => assert!(r.m_code(code).is_some(), "{row:?}"),
                _ => panic!("{row:?}"),
            }
            for number in &row.alarms {
                assert!(alarm_table(r.dialect).iter().any(|a| a.id.number() == Some(*number)), "{row:?}");
            }
            for mention in &row.parameters {
                let meant = |d: &&ParameterDef| r.is_meant(mention, &Subject::Parameter(d.key.clone()));
                assert!(r.parameters.iter().filter(meant).count() > 0, "{row:?} {mention:?}");
            }
        }
    }

    #[test]
    fn texts_name_things_as_the_manual_does() {
        use Mention::*;
        for (text, expected) in [
            ("rapid; 12#1; 31#0 at power-on", vec![Bits(12, 1..=1), Bits(31, 0..=0)]),
            ("then #15.0 and #17.0", vec![Bits(15, 0..=0), Bits(17, 0..=0)]),
            ("47#3-47#5 per axis; NO43.1 = 0", vec![Bits(47, 3..=5), Bits(43, 1..=1)]),
            (
                "by P018.5 and P018.4, rapid back by P230.",
                vec![Bits(18, 5..=5), Bits(18, 4..=4), Data(230..=230)],
            ),
            ("dwell P334, overrun P335-P338", vec![Data(334..=334), Data(335..=338)]),
            ("Check P216 to P230.", vec![Data(216..=230)]),
            ("G54 P1 to P50 and P2, G54 P50", vec![G(540..=540), G(540..=540)]),
            ("group 09: G22-G26, G76/G87", vec![G(220..=260), G(760..=760), G(870..=870)]),
            ("clears G group 09 now", vec![Group(9)]),
            ("rigid after M29, alarm 0020", vec![M(29..=29), Alarm(20)]),
            ("position in #5016-#5019", vec![Variables(5016..=5019)]),
            ("P#i Q#j, Pxxxx, PG2 PG1, 10 %, MAPC, G", vec![]),
        ] {
            assert_eq!(mentions(text), expected, "{text}");
        }
    }

    #[test]
    fn what_bears_on_a_code_is_found() {
        assert_eq!(parameters_of(Subject::G(730)), ["NO36.1", "NO43.1", "P270", "P281", "P282"]);
        assert_eq!(parameters_of(Subject::G(980)), ["NO36.2"]);
        let tapping = parameters_of(Subject::G(840));
        assert!(tapping.contains(&"P257".to_owned()) && tapping.contains(&"NO44.5".to_owned()));
        let p = Subject::Parameter(key("P270"));
        assert_eq!(gsk().codes_of(&p), [Subject::G(730)]);
        assert_eq!(gsk().alarms_of(&Subject::Parameter(key("P214"))), [AlarmId::Dialect("gsk990mc", 20)]);
        assert_eq!(parameters_of(Subject::Variable(150)), ["NO52.6"]);
        assert!(gsk().codes_of(&Subject::Alarm(45)).contains(&Subject::G(830)));
    }

    #[test]
    fn variables_are_found_by_number_the_closest_row_first() {
        let rows: Vec<_> = gsk().variable(5206).iter().map(|r| r.name()).collect();
        assert_eq!(rows, ["#5206-#5209", "#5201-#5235"]);
        assert_eq!(gsk().variable(3000)[0].name(), "#3000");
        assert!(gsk().variable(200).is_empty());
    }

    #[test]
    fn letters_and_words_are_found_in_either_case() {
        assert!(gsk().address(b'f').unwrap().starts_with("Feed"));
        assert_eq!(gsk().macro_word("goto").unwrap().format.as_ref(), "GOTO n");
        assert_eq!((g_code_name(0), g_code_name(541)), ("G00".to_owned(), "G54.1".to_owned()));
        assert_eq!(gsk().forms(100).map(GCodeRow::name).next().unwrap(), "G10 L2");
    }
}
