//! Parameters by the names that people give them, and names that are near to a wrong one.

pub use ferrocut_machine::parameters::range;
use ferrocut_machine::{Argument, Catalogue, ParameterDef, ParameterError, ParameterKey, ParameterTable};

/// Names offered for a wrong one.
const OFFERED: usize = 4;

/// Why a name stands for no parameter.
#[derive(Debug, PartialEq)]
pub enum NameError {
    /// The control has no such parameter; these are near.
    Unknown(String, Vec<String>),
    /// Several parameters carry this symbol.
    Ambiguous(String, Vec<String>),
    /// A bit parameter as a whole where one value is meant.
    WholeBits(String),
    /// The control has no parameters.
    None,
}

/// What a name of a parameter stands for: one, or all bits of a bit parameter (`NO43`).
///
/// Beside the names of set-up files (`P270`, `NO43.1`), `43#1` is read as the manual prints it, and the
/// symbol of the list (`ODI`, `g73_retract`).
pub fn parameters(text: &str, table: &ParameterTable) -> Result<Vec<ParameterKey>, NameError> {
    if table.is_empty() {
        return Err(NameError::None);
    }
    let text = text.trim();
    let whole = |t: &str| if t.bytes().all(|b| b.is_ascii_digit()) { t.parse::<u16>().ok() } else { None };
    let upper = text.to_ascii_uppercase();
    let bits_of = |number: u16| -> Vec<ParameterKey> {
        let is_bit = |key: &ParameterKey| matches!(key, ParameterKey::Bit { number: n, .. } if *n == number);
        table.iter().map(|d| d.key.clone()).filter(is_bit).collect()
    };
    let number = upper.strip_prefix("NO").or_else(|| upper.strip_suffix('#'));
    if let Some(number) = number.map(|n| n.trim_end_matches('#')).and_then(whole) {
        let bits = bits_of(number);
        return if bits.is_empty() { Err(unknown(&upper, table)) } else { Ok(bits) };
    }
    // `P018` of a control that writes its bits `P018.4`.
    if let Some(number) = upper.strip_prefix('P').and_then(whole)
        && table.get(&ParameterKey::Data(number)).is_none()
        && table.name_of_bits(number).starts_with('P')
        && let bits = bits_of(number)
        && !bits.is_empty()
    {
        return Ok(bits);
    }
    let starts_with_digit = upper.as_bytes().first().is_some_and(u8::is_ascii_digit);
    let named = if starts_with_digit && upper.contains('#') { format!("NO{upper}") } else { upper };
    match named.parse::<ParameterKey>() {
        Ok(key @ ParameterKey::Named(_)) if table.get(&key).is_some() => Ok(vec![key]),
        Ok(ParameterKey::Named(_)) => by_symbol(text, table),
        Ok(key) if table.get(&key).is_some() => Ok(vec![key]),
        Ok(key) => Err(unknown(&table.name(&key), table)),
        Err(_) => Err(unknown(text, table)),
    }
}

/// The one parameter of a name.
pub fn parameter(text: &str, table: &ParameterTable) -> Result<ParameterKey, NameError> {
    match parameters(text, table)?.as_slice() {
        [ParameterKey::Bit { number, .. }, _, ..] => Err(NameError::WholeBits(table.name_of_bits(*number))),
        [key, ..] => Ok(key.clone()),
        [] => Err(unknown(text, table)),
    }
}

fn by_symbol(text: &str, table: &ParameterTable) -> Result<Vec<ParameterKey>, NameError> {
    let has_it = |d: &&ParameterDef| d.symbol.eq_ignore_ascii_case(text);
    let keys: Vec<_> = table.iter().filter(has_it).map(|d| d.key.clone()).collect();
    match keys.as_slice() {
        [] => Err(unknown(text, table)),
        [_] => Ok(keys),
        _ => Err(NameError::Ambiguous(text.to_owned(), keys.iter().map(|key| table.name(key)).collect())),
    }
}

fn unknown(text: &str, table: &ParameterTable) -> NameError {
    let is_number = |t: &str| t.bytes().any(|b| b.is_ascii_digit()) && !t.contains('_');
    let names = table.iter().flat_map(|d| {
        let has_name = matches!(d.key, ParameterKey::Named(_));
        let key = (has_name || is_number(text)).then(|| d.name.to_string());
        let symbol = (has_name || !is_number(text)).then(|| d.symbol.to_string());
        [key, symbol].into_iter().flatten()
    });
    NameError::Unknown(text.to_owned(), near(text, names))
}

/// The names most like a wrong one: least letters to change, then the nearest number.
pub fn near(text: &str, names: impl IntoIterator<Item = String>) -> Vec<String> {
    let text = text.to_ascii_uppercase();
    let most = if text.len() <= 5 { 1 } else { 3 };
    let mut found: Vec<(usize, u32, String)> = names
        .into_iter()
        .map(|name| (changes(&text, &name.to_ascii_uppercase()), digits(&name).abs_diff(digits(&text)), name))
        .filter(|(changes, ..)| *changes <= most)
        .collect();
    found.sort();
    found.dedup();
    found.into_iter().map(|(.., name)| name).take(OFFERED).collect()
}

/// The digits of a name as one number.
fn digits(name: &str) -> u32 {
    let digits = name.chars().filter_map(|c| c.to_digit(10));
    digits.fold(0, |number: u32, digit| number.saturating_mul(10).saturating_add(digit))
}

/// Letters to put in, take out or replace between two names (Levenshtein's distance).
fn changes(a: &str, b: &str) -> usize {
    let mut row: Vec<usize> = (0..=b.len()).collect();
    for (i, x) in a.bytes().enumerate() {
        let mut diagonal = i;
        let mut left = i + 1;
        if let Some(first) = row.first_mut() {
            *first = left;
        }
        for (cell, y) in row.iter_mut().skip(1).zip(b.bytes()) {
            let above = *cell;
            left = (diagonal + usize::from(x != y)).min(left + 1).min(above + 1);
            diagonal = above;
            *cell = left;
        }
    }
    row.last().copied().unwrap_or(0)
}

/// The error in words.
pub fn name_error(error: &NameError, dialect: &str, texts: Catalogue) -> String {
    let label = |key: &str, arguments: &[(&str, Argument)]| texts.label(key, arguments);
    match error {
        NameError::Unknown(name, near) => {
            let arguments = [("name", name.as_str().into()), ("dialect", dialect.into())];
            with_near(label("label-no-parameter", &arguments), near, texts)
        }
        NameError::Ambiguous(name, keys) => {
            let arguments = [("name", name.as_str().into()), ("names", keys.join(", ").into())];
            label("label-several-parameters", &arguments)
        }
        NameError::WholeBits(name) => label("label-whole-bits", &[("name", name.as_str().into())]),
        NameError::None => label("label-no-parameters", &[("dialect", dialect.into())]),
    }
}

/// A sentence with the names that may have been meant.
pub fn with_near(text: String, near: &[String], texts: Catalogue) -> String {
    if near.is_empty() {
        return text;
    }
    let arguments = [("text", text.into()), ("names", near.join(", ").into())];
    texts.label("label-near", &arguments)
}

/// Why a parameter cannot be set, in words.
pub fn parameter_error(error: &ParameterError, dialect: &str, texts: Catalogue) -> String {
    match error {
        ParameterError::Unknown(name) => {
            texts.label("label-no-parameter", &[("name", (&**name).into()), ("dialect", dialect.into())])
        }
        error => error.told(texts),
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    fn table() -> &'static ParameterTable {
        ParameterTable::of("gsk990mc").unwrap()
    }

    #[test]
    fn names_are_read_as_the_manual_prints_them() {
        let key = |text: &str| parameter(text, table()).map(|k| k.to_string());
        for (text, name) in [
            ("P270", "P270"),
            ("p0270", "P270"),
            ("43#1", "NO43.1"),
            ("NO43#1", "NO43.1"),
            ("no43.1", "NO43.1"),
        ] {
            assert_eq!(key(text), Ok(name.to_owned()), "{text}");
        }
        assert_eq!(key("odi"), Ok("NO40.7".to_owned()));
        assert_eq!(key("g73_retract"), Ok("P270".to_owned()));
        assert_eq!(key("NO43"), Ok("NO43.1".to_owned()));
        assert_eq!(key("NO47"), Err(NameError::WholeBits("NO47".into())));
        assert_eq!(parameters("47#", table()).unwrap().len(), 5);
        let several = vec!["NO0.1".to_owned(), "NO3.0".to_owned()];
        assert_eq!(key("INM"), Err(NameError::Ambiguous("INM".into(), several)));
    }

    #[test]
    fn bits_that_are_written_like_numbers_are_found() {
        let table = ParameterTable::of("kaitong").unwrap();
        let names = |text: &str| {
            parameters(text, table).map(|keys| keys.iter().map(|k| table.name(k)).collect::<Vec<_>>())
        };
        assert_eq!(names("P018"), Ok(vec!["P018.4".to_owned(), "P018.5".to_owned()]));
        assert_eq!(names("p18.4"), Ok(vec!["P018.4".to_owned()]));
        assert_eq!(names("P230"), Ok(vec!["P230".to_owned()]));
        assert_eq!(parameter("P018", table), Err(NameError::WholeBits("P018".into())));
        let near = |text| names(text).err();
        let Some(NameError::Unknown(_, offered)) = near("P018.6") else { panic!("P018.6 is known") };
        assert_eq!(offered.first().map(String::as_str), Some("P018.5"));
    }

    #[test]
    fn wrong_names_find_near_ones() {
        let near = |text: &str| match parameters(text, table()) {
            Err(NameError::Unknown(_, near)) => near,
            other => panic!("{other:?}"),
        };
        assert_eq!(near("P272").first().map(String::as_str), Some("P271"));
        assert_eq!(near("NO43.2").first().map(String::as_str), Some("NO43.1"));
        assert_eq!(near("g73_retrat"), ["g73_retract"]);
        assert!(near("nonsense_altogether").is_empty());
    }

    #[test]
    fn changes_are_counted() {
        for (a, b, n) in [("", "", 0), ("a", "", 1), ("G77", "G76", 1), ("kitten", "sitting", 3)] {
            assert_eq!(changes(a, b), n);
        }
    }
}
