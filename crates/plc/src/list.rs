//! Words to instructions: the mnemonic list.
//!
//! A line is `NAME = X8.4 ; meaning` (a signal gets a name), a basic instruction with its bit, or a function
//! by its name or number with its parameters (`TMR 5`, `SUB 3 5`). Parameters may go on in the lines that
//! follow, with or without `PRM` before them, as a PMC prints them. AND and OR are functions where a number
//! follows and basic instructions where a bit does; subtraction in BCD is `SUB 20`.

use crate::address::{Address, AddressError};
use crate::fault::{Error, Fault, Span};
use crate::instruction::{Basic, Bytes, Code, FUNCTIONS, Instruction, Kind, Name, Parameter, Row};
use crate::lexer::{Line, Word, lines};
use rustc_hash::FxHashMap;

/// A signal that the ladder gives a name.
#[derive(Clone, Debug)]
pub struct Symbol {
    /// Its name.
    pub name: String,
    /// The signal.
    pub address: Address,
    /// What its line says of it.
    pub meaning: String,
    /// Where it is named.
    pub span: Span,
}

/// A ladder as it is written.
#[derive(Clone, Debug, Default)]
pub struct Ladder {
    /// Named signals, in the order of the text.
    pub symbols: Vec<Symbol>,
    /// Its instructions.
    pub instructions: Vec<Instruction>,
    /// The last line of the text, for what is missing at the end.
    pub end: Span,
}

/// Values of tables in all, as many as 4,700 steps could name.
pub const MOST_TABLE_VALUES: usize = 4096;

/// Largest text, bytes: 24,000 steps with a comment each are half of it.
pub const MOST_BYTES: usize = 4 << 20;

/// Reads ladder text.
pub fn read(bytes: &[u8], errors: &mut Vec<Error>) -> Ladder {
    if bytes.len() > MOST_BYTES {
        let start = Span { line: 1, ..Span::default() };
        errors.push(Error::about(Fault::FileFormat, start, format!("> {} MiB", MOST_BYTES >> 20)));
        return Ladder::default();
    }
    let lines = lines(bytes, errors);
    let mut reader = Reader { ladder: Ladder::default(), names: FxHashMap::default(), errors, values: 0 };
    for line in &lines {
        reader.definition(line);
    }
    let mut open: Option<Call> = None;
    for line in &lines {
        reader.line(line, &mut open);
    }
    reader.close(open);
    reader.ladder.end = lines.last().and_then(|l| l.words.last()).map_or_else(Span::default, |w| w.span);
    reader.ladder
}

/// A function of another source than ladder text, with its parameters as words.
pub(crate) fn function(
    row: &'static Row,
    span: Span,
    words: Vec<Word>,
    errors: &mut Vec<Error>,
) -> Option<Instruction> {
    let mut reader = Reader { ladder: Ladder::default(), names: FxHashMap::default(), errors, values: 0 };
    reader.close(Some(Call { row, span, words }));
    reader.ladder.instructions.pop()
}

/// A function whose parameters are being read.
struct Call<'a> {
    row: &'static Row,
    span: Span,
    words: Vec<Word<'a>>,
}

struct Reader<'e> {
    ladder: Ladder,
    names: FxHashMap<String, Address>,
    errors: &'e mut Vec<Error>,
    values: usize,
}

fn is_definition(line: &Line) -> bool {
    line.words.get(1).is_some_and(|w| w.text == "=")
}

impl Reader<'_> {
    fn error(&mut self, fault: Fault, span: Span) {
        self.errors.push(Error::new(fault, span));
    }

    fn definition(&mut self, line: &Line) {
        if !is_definition(line) {
            return;
        }
        let [name, _, value] = line.words.as_slice() else {
            let span = line.words.last().map_or_else(Span::default, |w| w.span);
            return self.error(Fault::WrongEntry, span);
        };
        let address = match Address::parse(value.text) {
            Ok(address) => address,
            Err(error) => return self.error(fault_of(error), value.span),
        };
        // A name that could be an address or an instruction would be read as one.
        let is_taken = self.names.contains_key(name.text) || is_reserved(name.text);
        if is_taken {
            return self.error(Fault::WrongEntry, name.span);
        }
        self.names.insert(name.text.to_owned(), address);
        self.ladder.symbols.push(Symbol {
            name: name.text.to_owned(),
            address,
            meaning: line.comment.to_owned(),
            span: name.span,
        });
    }

    fn line<'a>(&mut self, line: &Line<'a>, open: &mut Option<Call<'a>>) {
        let Some((first, rest)) = line.words.split_first() else { return };
        if is_definition(line) {
            return;
        }
        let mark = first.text.eq_ignore_ascii_case("PRM");
        if let Some(call) = open.as_mut().filter(|_| mark || self.is_parameter(first.text)) {
            let words = if mark { rest } else { line.words.as_slice() };
            return call.words.extend_from_slice(words);
        }
        if let Some(call) = open.take() {
            self.close(Some(call));
        }
        let is_number = rest.first().is_some_and(|w| w.text.starts_with(|c: char| c.is_ascii_digit()));
        if let Some(basic) = Basic::by_text(first.text).filter(|_| !is_number) {
            return self.basic(basic, first, rest);
        }
        let (row, parameters) = match first.text.eq_ignore_ascii_case("SUB") {
            false => (Row::by_text(first.text), rest),
            true => match rest.split_first() {
                None => return self.error(Fault::NoFunctionName, first.span),
                Some((number, rest)) => (number.text.parse().ok().and_then(Row::by_number), rest),
            },
        };
        match row {
            Some(row) => *open = Some(Call { row, span: first.span, words: parameters.to_vec() }),
            // A contact whose address was mistaken for a number.
            None if Basic::by_text(first.text).is_some() => self.error(Fault::WrongEntry, first.span),
            None => {
                let name = if first.text.eq_ignore_ascii_case("SUB") { rest.first() } else { Some(first) };
                self.error(Fault::UnknownFunction, name.map_or(first.span, |w| w.span));
                // It may have been the output of its network, which is then no fault of its own.
                let is_contact = |i: &Instruction| matches!(i.code, Code::Basic(b, _) if !b.is_coil());
                if self.ladder.instructions.last().is_some_and(is_contact) {
                    let code = Code::Basic(Basic::Wrt, None);
                    self.ladder.instructions.push(Instruction { code, span: first.span });
                }
            }
        }
    }

    /// Whether a line that begins so goes on with parameters.
    fn is_parameter(&self, text: &str) -> bool {
        text.starts_with(|c: char| c.is_ascii_digit() || c == '+' || c == '-')
            || self.names.contains_key(text)
            || !matches!(Address::parse(text), Err(AddressError::Form))
    }

    fn basic(&mut self, basic: Basic, word: &Word, rest: &[Word]) {
        let needs_bit = !matches!(basic, Basic::AndStk | Basic::OrStk);
        let address = match rest.first() {
            None if needs_bit => {
                self.error(Fault::NoAddress, word.span);
                None
            }
            None => None,
            Some(extra) if !needs_bit => {
                self.error(Fault::WrongFormat, extra.span);
                None
            }
            Some(operand) => self.bit(operand),
        };
        if let Some(extra) = rest.get(1) {
            self.error(Fault::WrongFormat, extra.span);
        }
        // A contact with a fault stays in its network, so that the network raises none of its own.
        self.ladder.instructions.push(Instruction { code: Code::Basic(basic, address), span: word.span });
    }

    fn address(&mut self, word: &Word) -> Option<Address> {
        if let Some(address) = self.names.get(word.text) {
            return Some(*address);
        }
        Address::parse(word.text).map_err(|error| self.error(fault_of(error), word.span)).ok()
    }

    fn bit(&mut self, word: &Word) -> Option<Address> {
        let address = self.address(word)?;
        if address.bit.is_none() {
            self.error(Fault::WrongEntry, word.span);
            return None;
        }
        Some(address)
    }

    /// Takes a function with all its words.
    fn close(&mut self, call: Option<Call>) {
        let Some(Call { row, span, words }) = call else { return };
        let mut parameters = Vec::with_capacity(row.parameters.len());
        let mut words = words.iter();
        let mut is_whole = true;
        for kind in row.parameters {
            let Some(word) = words.next() else {
                if let Kind::OptionalNumber(.., absent) = kind {
                    parameters.push(Parameter::Number(*absent));
                    continue;
                }
                self.error(Fault::ParameterMissing, span);
                is_whole = false;
                break;
            };
            match self.parameter(*kind, word, row, &parameters) {
                Some(parameter) => parameters.push(parameter),
                // Those that follow may depend on it.
                None => {
                    is_whole = false;
                    break;
                }
            }
        }
        let mut table = Vec::new();
        if is_whole {
            let values = table_values(row, &parameters);
            let bounds = table_bounds(row, &parameters);
            for _ in 0..values {
                let Some(word) = words.next() else {
                    self.error(Fault::ParameterMissing, span);
                    break;
                };
                if let Some(value) = self.number(word, bounds) {
                    table.push(value);
                }
            }
            self.values += table.len();
            if self.values > MOST_TABLE_VALUES {
                self.values = 0;
                self.error(Fault::TablesFull, span);
            }
            if let Some(extra) = words.next() {
                self.error(Fault::WrongFormat, extra.span);
            }
        }
        self.ladder.instructions.push(Instruction { code: Code::Function(row, parameters, table), span });
    }

    fn parameter(&mut self, kind: Kind, word: &Word, row: &Row, before: &[Parameter]) -> Option<Parameter> {
        let width = || i64::from(width_of(row, before));
        match kind {
            Kind::Number(least, most) | Kind::OptionalNumber(least, most, _) => {
                self.number(word, (least, most)).map(Parameter::Number)
            }
            Kind::Target(letter, most) => {
                let digits = word.text.strip_prefix([letter, letter.to_ascii_lowercase()]);
                let word = Word { text: digits.unwrap_or(word.text), span: word.span };
                self.number(&word, (1, most)).map(Parameter::Number)
            }
            Kind::Mask => {
                if word.text.len() != 4 || word.text.bytes().any(|b| !matches!(b, b'0' | b'1')) {
                    self.error(Fault::WrongFormat, word.span);
                    return None;
                }
                i64::from_str_radix(word.text, 2).ok().map(Parameter::Number)
            }
            Kind::Width => self.format(word, |n| matches!(n, 1 | 2 | 4)),
            Kind::DecodeWidth => {
                // SB7: `0nn1` decodes nn groups of eight; without nn it is one.
                self.format(word, |n| matches!(n % 10, 1 | 2 | 4) && n < 1000)
            }
            Kind::OperandWidth => {
                self.format(word, |n| matches!(n % 1000, 1 | 2 | 4) && matches!(n / 1000, 0 | 1))
            }
            Kind::OperandFormat => self.format(word, |n| matches!(n, 0 | 1)),
            Kind::Read(bytes) => self.place(word, bytes, row, before, false),
            Kind::Write(bytes) => self.place(word, bytes, row, before, true),
            Kind::Operand(bytes) => match operand_is_address(row, before) {
                true => self.place(word, bytes, row, before, false),
                false if bytes == Bytes::Width => {
                    self.number(word, constant_bounds(width())).map(Parameter::Number)
                }
                false => self.number(word, (0, 9999)).map(Parameter::Number),
            },
            Kind::Constant => self.number(word, constant_bounds(width())).map(Parameter::Number),
            Kind::Bcd => self.number(word, (0, 9999)).map(Parameter::Number),
        }
    }

    fn format(&mut self, word: &Word, fits: impl Fn(i64) -> bool) -> Option<Parameter> {
        match word.text.parse::<i64>() {
            Ok(number) if number >= 0 && fits(number) => Some(Parameter::Number(number)),
            _ => {
                self.error(Fault::WrongFormat, word.span);
                None
            }
        }
    }

    fn number(&mut self, word: &Word, (least, most): (i64, i64)) -> Option<i64> {
        let digits = word.text.strip_prefix(['+', '-']).unwrap_or(word.text);
        if digits.is_empty() || !digits.bytes().all(|b| b.is_ascii_digit()) {
            // An address where a constant must stand is of the wrong kind; anything else is a slip.
            let is_address = self.names.contains_key(word.text) || Address::parse(word.text).is_ok();
            let fault = if is_address { Fault::WrongFormat } else { Fault::WrongEntry };
            self.error(fault, word.span);
            return None;
        }
        match word.text.parse() {
            Ok(number) if (least..=most).contains(&number) => Some(number),
            _ => {
                self.error(Fault::ParameterRange, word.span);
                None
            }
        }
    }

    /// An address of the bytes that the function reads or writes.
    fn place(
        &mut self,
        word: &Word,
        bytes: Bytes,
        row: &Row,
        before: &[Parameter],
        is_written: bool,
    ) -> Option<Parameter> {
        if word.text.starts_with(|c: char| c.is_ascii_digit() || c == '-' || c == '+') {
            self.error(Fault::WrongFormat, word.span);
            return None;
        }
        let address = self.address(word)?;
        // A function takes bytes, and writes no input.
        if address.bit.is_some() || (is_written && (address.area.is_input() || address.is_system())) {
            self.error(Fault::WrongFormat, word.span);
            return None;
        }
        let len = bytes_of(bytes, row, before);
        // Two digits may stand in the last byte of an area: BYT says so while the ladder runs.
        let needs = if bytes == Bytes::Fixed(2) && row.conditions.contains(&"BYT") { 1 } else { len };
        let needs = if bytes == Bytes::FirstWords { first_of(before) } else { needs };
        if !address.holds(needs) {
            self.error(Fault::ParameterRange, word.span);
            return None;
        }
        Some(Parameter::At(address))
    }
}

fn fault_of(error: AddressError) -> Fault {
    match error {
        AddressError::Form => Fault::WrongEntry,
        AddressError::Range => Fault::OutOfRange,
    }
}

fn is_reserved(text: &str) -> bool {
    let text = text.to_ascii_uppercase();
    text == "="
        || matches!(text.as_str(), "SUB" | "PRM")
        || text.starts_with(|c: char| c.is_ascii_digit() || c == '+' || c == '-')
        || Basic::by_text(&text).is_some()
        || FUNCTIONS.iter().any(|row| row.text == text)
        || !matches!(Address::parse(&text), Err(AddressError::Form))
}

/// The ladder as text that reads the same, with the names of signals as comments.
pub fn to_text(ladder: &Ladder) -> String {
    let mut names: FxHashMap<Address, &str> = FxHashMap::default();
    for symbol in &ladder.symbols {
        names.entry(symbol.address).or_insert(&symbol.name);
    }
    let mut text = String::new();
    for instruction in &ladder.instructions {
        match &instruction.code {
            Code::Basic(basic, address) => {
                text.push_str(basic.text());
                if let Some(address) = address {
                    text.push_str(&format!(" {address}"));
                    if let Some(name) = names.get(address) {
                        // A comment ends with its line.
                        let name: String = name.chars().filter(|c| !c.is_control()).collect();
                        text.push_str(&format!(" ; {name}"));
                    }
                }
            }
            Code::Function(row, parameters, table) => {
                text.push_str(row.text);
                for (kind, parameter) in row.parameters.iter().zip(parameters) {
                    match (kind, parameter) {
                        (Kind::Mask, Parameter::Number(mask)) => text.push_str(&format!(" {mask:04b}")),
                        (_, Parameter::Number(number)) => text.push_str(&format!(" {number}")),
                        (_, Parameter::At(address)) => text.push_str(&format!(" {address}")),
                    }
                }
                for value in table {
                    text.push_str(&format!("\n{value}"));
                }
            }
        }
        text.push('\n');
    }
    text
}

/// The first parameter of a function, where that is a number.
fn first_of(parameters: &[Parameter]) -> u32 {
    match parameters.first() {
        Some(Parameter::Number(first)) => u32::try_from(*first).unwrap_or(0),
        _ => 0,
    }
}

/// How many bytes a parameter of a function is the first of at most.
pub(crate) fn bytes_of(bytes: Bytes, row: &Row, parameters: &[Parameter]) -> u32 {
    let first = first_of(parameters);
    match bytes {
        Bytes::Fixed(bytes) => u32::from(bytes),
        Bytes::Width => width_of(row, parameters),
        Bytes::Decoded => (first / 10 % 100).max(1),
        Bytes::First => first,
        Bytes::FirstWords => first.saturating_mul(2),
    }
}

/// Bytes of the data of a function, as its format says.
pub fn width_of(row: &Row, parameters: &[Parameter]) -> u32 {
    let formats = row.parameters.iter().zip(parameters);
    let format = formats.into_iter().find_map(|(kind, parameter)| match (kind, parameter) {
        (Kind::Width | Kind::DecodeWidth | Kind::OperandWidth, Parameter::Number(n)) => Some(n % 10),
        _ => None,
    });
    format.and_then(|n| u32::try_from(n).ok()).unwrap_or(1)
}

/// Whether the operand of a function is an address, as its format says.
fn operand_is_address(row: &Row, parameters: &[Parameter]) -> bool {
    row.parameters.iter().zip(parameters).any(|(kind, parameter)| match (kind, parameter) {
        (Kind::OperandFormat, Parameter::Number(n)) => *n == 1,
        (Kind::OperandWidth, Parameter::Number(n)) => *n >= 1000,
        _ => false,
    })
}

/// How many values follow the parameters.
fn table_values(row: &Row, parameters: &[Parameter]) -> i64 {
    let at = match row.name {
        Name::Cod => 0,
        Name::Codb => 1,
        _ => return 0,
    };
    match parameters.get(at) {
        Some(Parameter::Number(values)) => *values,
        _ => 0,
    }
}

fn table_bounds(row: &Row, parameters: &[Parameter]) -> (i64, i64) {
    match row.name {
        Name::Cod => (0, 9999),
        _ => constant_bounds(i64::from(width_of(row, parameters))),
    }
}

/// What a constant of so many bytes may be: a number with a sign, or a pattern of bits without.
fn constant_bounds(bytes: i64) -> (i64, i64) {
    match bytes {
        1 => (i64::from(i8::MIN), i64::from(u8::MAX)),
        2 => (i64::from(i16::MIN), i64::from(u16::MAX)),
        _ => (i64::from(i32::MIN), i64::from(u32::MAX)),
    }
}
