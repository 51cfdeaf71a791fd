//! What somebody asks about: from the words of the command line to a thing with a number.

use crate::book::Book;
use crate::names::{self, NameError, name_error, near, with_near};
use ferrocut_machine::{
    AlarmId, Catalogue, Fault, ParameterKey, Subject, VariableRow, alarm_table, g_code_name,
};
use std::path::PathBuf;

/// Codes offered for a word that some of them speak of.
const OFFERED: usize = 6;

/// A thing to explain.
#[derive(Clone, PartialEq, Debug)]
pub enum Asked {
    /// A code, parameter, alarm or variable of the control.
    Subject(Subject),
    /// A form of a G code with a row of its own, such as `G10 L2`.
    Form(u16, String),
    /// An alarm of this system.
    Fault(Fault),
    /// An address letter.
    Address(u8),
    /// A word of the macro language.
    MacroWord(String),
    /// What stands at a place of a program; every word of the line where no column is given. Line 0 is that of a file
    /// that is named alone.
    Place(PathBuf, u32, Option<usize>),
}

/// A word that stands for nothing, and why, in a sentence.
pub type Unknown = String;

/// A word before a number that says what the number is of.
const KINDS: [&str; 4] = ["alarm", "parameter", "variable", "code"];

/// The things that words ask about. `is_file` says whether a name is that of a file, such as a program's in front of a
/// line number.
pub fn read(
    words: &[String],
    book: &Book,
    is_file: &dyn Fn(&str) -> bool,
) -> Vec<Result<Vec<Asked>, Unknown>> {
    let mut asked = Vec::new();
    let mut words = words.iter();
    while let Some(word) = words.next() {
        let word = word.trim();
        let kind = KINDS.into_iter().find(|kind| word.eq_ignore_ascii_case(kind));
        asked.push(match (kind, word.split_once(' ')) {
            (Some(kind), _) => match words.next() {
                Some(number) => of_kind(kind, number.trim(), book),
                None => one(word, book, is_file),
            },
            (None, Some((kind, number))) if KINDS.iter().any(|k| kind.eq_ignore_ascii_case(k)) => {
                of_kind(kind, number.trim(), book)
            }
            _ => one(word, book, is_file),
        });
    }
    asked
}

fn of_kind(kind: &str, number: &str, book: &Book) -> Result<Vec<Asked>, Unknown> {
    match kind.to_ascii_lowercase().as_str() {
        "alarm" => alarm(number, book),
        "parameter" => parameters(number, book),
        "variable" => variable(number.trim_start_matches('#'), book),
        _ => one(number, book, &|_| false),
    }
}

fn one(word: &str, book: &Book, is_file: &dyn Fn(&str) -> bool) -> Result<Vec<Asked>, Unknown> {
    let upper = word.to_ascii_uppercase();
    let digits = |t: &str| !t.is_empty() && t.bytes().all(|b| b.is_ascii_digit());
    let is_number = |t: &str| t.starts_with(|c: char| c.is_ascii_digit());
    if let Some(place) = place(word, book, is_file) {
        return Ok(vec![place]);
    }
    if word.contains(['.', '/', '\\']) && is_file(word) {
        return Ok(vec![Asked::Place(word.into(), 0, None)]);
    }
    if upper.starts_with("FC-") || upper.contains(':') || digits(word) {
        return alarm(word, book);
    }
    if let Some(number) = upper.strip_prefix('#').filter(|t| digits(t)) {
        return variable(number, book);
    }
    if let Some(name) = upper.strip_prefix('#').filter(|name| !name.is_empty()) {
        return named_variable(name, book);
    }
    if let Some(number) = book.unsigned_variable(word) {
        return Ok(vec![Asked::Subject(Subject::Variable(number))]);
    }
    // Behind a comma it is the same address; its meaning there is told with the others.
    if let [letter @ b'A'..=b'Z'] | [b',', letter @ b'A'..=b'Z'] = upper.as_bytes() {
        return Ok(vec![Asked::Address(*letter)]);
    }
    let spaced = upper.split_once(' ').map_or((upper.as_str(), ""), |(code, form)| (code, form.trim()));
    if let Some(number) = spaced.0.strip_prefix('G').filter(|t| is_number(t) && !t.contains('_')) {
        return g_code(number, spaced.1, book);
    }
    if let Some(number) = upper.strip_prefix('M').filter(|t| digits(t)) {
        return m_code(number, book);
    }
    let sign = book.dialect.syntax.keyword_sign.map(char::from);
    let bare = sign.and_then(|sign| upper.strip_prefix(sign)).unwrap_or(&upper);
    if book.reference.is_some_and(|r| r.macro_word(bare).is_some()) {
        return Ok(vec![Asked::MacroWord(bare.to_owned())]);
    }
    let numbered = upper.strip_prefix("NO").or_else(|| upper.strip_prefix('P'));
    if is_number(word) || numbered.is_some_and(is_number) {
        return parameters(word, book);
    }
    match names::parameters(word, book.table()) {
        Ok(keys) => Ok(of_keys(keys)),
        Err(error @ NameError::Ambiguous(..)) => Err(name_error(&error, book.dialect.name, book.catalogue)),
        _ if is_file(word) => Ok(vec![Asked::Place(word.into(), 0, None)]),
        _ => Err(unknown(word, book)),
    }
}

/// `part.nc:12:5`, `part.nc:12`; not `gsk990mc:0045`.
fn place(word: &str, book: &Book, is_file: &dyn Fn(&str) -> bool) -> Option<Asked> {
    let (rest, last) = word.rsplit_once(':')?;
    let last = last.parse::<u32>().ok()?;
    match rest.rsplit_once(':').and_then(|(file, line)| Some((file, line.parse().ok()?))) {
        Some((file, line)) if !file.is_empty() => {
            Some(Asked::Place(file.into(), line, Some(usize::try_from(last).ok()?)))
        }
        _ if rest.is_empty() || rest.eq_ignore_ascii_case(book.dialect.name) => None,
        // A place without a column, of a file that there is or of what no control is called; else the alarm of another control.
        _ => {
            let is_path = is_file(rest) || rest.contains(['.', '/', '\\']);
            is_path.then(|| Asked::Place(rest.into(), last, None))
        }
    }
}

/// `45`, `0045`, `gsk990mc:0045`, `FC-0302`.
fn alarm(word: &str, book: &Book) -> Result<Vec<Asked>, Unknown> {
    let name = book.dialect.name;
    let no_alarm = |near: &[String]| {
        let arguments = [("name", word.into()), ("dialect", name.into())];
        let text = book.catalogue.label("label-no-alarm", &arguments);
        with_near(text, near, book.catalogue)
    };
    if let Some(number) = word.to_ascii_uppercase().strip_prefix("FC-") {
        let number: Option<u16> = number.parse().ok();
        let fault = Fault::ALL.iter().find(|f| Some(**f as u16) == number);
        let ids = Fault::ALL.iter().map(|f| AlarmId::Core(*f).to_string());
        return fault.map(|f| vec![Asked::Fault(*f)]).ok_or_else(|| no_alarm(&near(word, ids)));
    }
    let number = match word.split_once(':') {
        Some((dialect, number)) if dialect.eq_ignore_ascii_case(name) => number,
        Some(_) => return Err(no_alarm(&[])),
        None => word,
    };
    let id = number.parse::<u16>().ok().map(|n| AlarmId::Dialect(name, n));
    match id.filter(|id| book.catalogue.text(*id).is_some()).and_then(AlarmId::number) {
        Some(number) => Ok(vec![Asked::Subject(Subject::Alarm(number))]),
        None => {
            let padded = format!("{number:0>4}");
            let listed = alarm_table(name).iter().filter_map(|row| Some(format!("{:04}", row.id.number()?)));
            Err(no_alarm(&near(&padded, listed)))
        }
    }
}

fn variable(number: &str, book: &Book) -> Result<Vec<Asked>, Unknown> {
    if let Some(number) = book.unsigned_variable(number) {
        return Ok(vec![Asked::Subject(Subject::Variable(number))]);
    }
    if let Some(letter) = book.dialect.syntax.parameter_letter {
        let name = format!("{}{number}", char::from(letter));
        let arguments = [("name", name.into()), ("dialect", book.dialect.name.into())];
        return Err(book.catalogue.label("label-no-sign", &arguments));
    }
    let known = number.parse::<u32>().ok().filter(|n| match book.reference {
        Some(reference) => !reference.variable(*n).is_empty(),
        None => (book.dialect.variable)(*n).is_some(),
    });
    known.map(|n| vec![Asked::Subject(Subject::Variable(n))]).ok_or_else(|| {
        let arguments = [("name", number.into()), ("dialect", book.dialect.name.into())];
        let text = book.catalogue.label("label-no-variable", &arguments);
        with_near(text, &near_variables(number, book), book.catalogue)
    })
}

/// `#FC7`, `#SAFEHEIGHT`: a word of the macro language, or a parameter.
fn named_variable(name: &str, book: &Book) -> Result<Vec<Asked>, Unknown> {
    let word = book.full_name(name);
    if book.reference.is_some_and(|r| r.macro_word(&word).is_some()) {
        return Ok(vec![Asked::MacroWord(word)]);
    }
    match names::parameters(name, book.table()) {
        Ok(keys) => Ok(of_keys(keys)),
        _ => Err(unknown(&format!("#{name}"), book)),
    }
}

/// The ranges before and behind a number.
fn near_variables(number: &str, book: &Book) -> Vec<String> {
    let (Ok(number), Some(reference)) = (number.parse::<u32>(), book.reference) else { return Vec::new() };
    let rows = || reference.variables().iter();
    let before = rows().filter(|r| *r.numbers.end() < number).max_by_key(|r| *r.numbers.end());
    let behind = rows().filter(|r| *r.numbers.start() > number).min_by_key(|r| *r.numbers.start());
    before.into_iter().chain(behind).map(VariableRow::name).collect()
}

fn parameters(name: &str, book: &Book) -> Result<Vec<Asked>, Unknown> {
    let bare = name.bytes().all(|b| b.is_ascii_digit());
    let name = if bare { format!("P{name}") } else { name.to_owned() };
    let found = names::parameters(&name, book.table());
    found.map(of_keys).map_err(|error| name_error(&error, book.dialect.name, book.catalogue))
}

fn of_keys(keys: Vec<ParameterKey>) -> Vec<Asked> {
    keys.into_iter().map(|key| Asked::Subject(Subject::Parameter(key))).collect()
}

/// `84` or `54.1`, and a form of it, `L2` or `P3`.
fn g_code(number: &str, form: &str, book: &Book) -> Result<Vec<Asked>, Unknown> {
    let (whole, tenth) = number.split_once('.').unwrap_or((number, "0"));
    let tenths = whole.parse::<u16>().ok().zip(tenth.parse::<u16>().ok().filter(|t| *t < 10));
    let tenths = tenths.and_then(|(whole, tenth)| whole.checked_mul(10)?.checked_add(tenth));
    let known = tenths.filter(|t| book.knows_g(*t));
    let Some(tenths) = known else { return Err(no_code(&format!("G{number}"), book)) };
    if form.is_empty() {
        return Ok(vec![Asked::Subject(Subject::G(tenths))]);
    }
    let forms = || book.reference.into_iter().flat_map(|r| r.forms(tenths));
    match forms().find(|row| row.is_form(form)) {
        Some(row) => Ok(vec![Asked::Form(tenths, row.form.to_string())]),
        None => {
            let name = format!("{} {form}", g_code_name(tenths));
            let alike = forms().filter(|row| row.form.get(..1) == form.get(..1)).map(|row| row.name());
            let near = near(&name, alike);
            let arguments = [("name", name.into()), ("dialect", book.dialect.name.into())];
            let text = book.catalogue.label("label-no-code", &arguments);
            Err(with_near(text, &near, book.catalogue))
        }
    }
}

fn m_code(number: &str, book: &Book) -> Result<Vec<Asked>, Unknown> {
    let known = number.parse::<u16>().ok().filter(|code| book.knows_m(*code));
    known
        .map(|code| vec![Asked::Subject(Subject::M(code))])
        .ok_or_else(|| no_code(&format!("M{number}"), book))
}

fn no_code(name: &str, book: &Book) -> Unknown {
    let g = book.g_codes().into_iter().map(g_code_name);
    let m = book.m_codes().into_iter().map(|code| format!("M{code:02}"));
    let arguments = [("name", name.into()), ("dialect", book.dialect.name.into())];
    let text = book.catalogue.label("label-no-code", &arguments);
    // `G54.1` of another control is likely meant as a `G54`.
    let whole = name.split('.').next().unwrap_or(name);
    let shown = match whole.split_at_checked(1) {
        Some((letter, number)) => format!("{letter}{number:0>2}"),
        None => name.to_owned(),
    };
    with_near(text, &near(&shown, g.chain(m)), book.catalogue)
}

/// A word that names nothing: names like it, else codes whose meaning speaks of it.
fn unknown(word: &str, book: &Book) -> Unknown {
    let label = |key, near: &[String], texts: Catalogue| {
        let arguments = [("name", word.into()), ("dialect", book.dialect.name.into())];
        with_near(texts.label(key, &arguments), near, texts)
    };
    let Some(reference) = book.reference else { return label("label-unknown", &[], book.catalogue) };
    let symbols = book.table().iter().map(|d| d.symbol.to_string());
    let words = reference.macro_words().iter().map(|row| row.word.to_string());
    let mut found = near(word, symbols.chain(words));
    let asked = word.to_lowercase();
    let speaks = |meaning: &str| asked.len() >= 4 && meaning.to_lowercase().contains(&asked);
    if found.is_empty() {
        let g =
            reference.g_codes().iter().filter(|r| r.form.is_empty() && speaks(&r.meaning)).map(|r| r.name());
        let m = reference.m_codes().iter().filter(|r| speaks(&r.meaning)).map(|r| format!("M{:02}", r.code));
        found = g.chain(m).take(OFFERED).collect();
    }
    label("label-unknown", &found, book.catalogue)
}
