//! The texts of the reference tables in the languages that people read.
//!
//! The tables under `data/` say in English what codes, parameters, variables and words are. What that is in another language
//! stands in `data/texts/<language>.csv`: `english,text`. One text serves every table that says the same.

use crate::messages::Language;
use std::collections::HashMap;
use std::sync::OnceLock;

type Texts = HashMap<Box<str>, Box<str>>;

static TEXTS: [OnceLock<Texts>; 5] = [const { OnceLock::new() }; 5];

/// What a text of the tables is in `language`; itself where it is not known.
pub(crate) fn in_language(english: &str, language: Language) -> &str {
    let csv = match language {
        Language::En => return english,
        Language::Zh => include_str!("../data/texts/zh.csv"),
        Language::Ru => include_str!("../data/texts/ru.csv"),
        Language::Es => include_str!("../data/texts/es.csv"),
        Language::Tr => include_str!("../data/texts/tr.csv"),
    };
    let texts = TEXTS[language as usize].get_or_init(|| read(csv));
    texts.get(english).map_or(english, |text| text)
}

fn read(csv: &str) -> Texts {
    let rows = csv::Reader::from_reader(csv.as_bytes()).into_records();
    rows.flatten().filter_map(|row| Some((row.get(0)?.into(), row.get(1)?.into()))).collect()
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::parameters::{Meaning, ParameterTable};
    use crate::reference::Reference;
    use std::collections::BTreeSet;

    /// Every text of every table.
    fn english() -> BTreeSet<String> {
        let mut texts = BTreeSet::new();
        let mut add = |text: &str| texts.insert(text.to_owned());
        for dialect in ["gsk990mc", "kaitong", "weihong", "fagor8065", "rs274"] {
            let reference = Reference::of(dialect).unwrap();
            reference.g_codes().iter().for_each(|row| _ = add(&row.meaning));
            reference.m_codes().iter().for_each(|row| _ = add(&row.meaning));
            reference.macro_words().iter().for_each(|row| _ = add(&row.meaning));
            for row in reference.variables() {
                add(&row.meaning);
                add(&row.notes);
            }
            (b'A'..=b'Z').filter_map(|letter| reference.address(letter)).for_each(|text| _ = add(text));
            for definition in ParameterTable::of(dialect).into_iter().flat_map(ParameterTable::iter) {
                match &definition.meaning {
                    Meaning::Value(text) => _ = add(text),
                    Meaning::Bit { one, zero } => {
                        add(one);
                        add(zero);
                    }
                }
            }
        }
        texts.remove("");
        texts
    }

    #[test]
    fn every_text_is_in_every_language_and_no_other() {
        let english = english();
        assert!(english.contains("Whole part"));
        for language in [Language::Zh, Language::Ru, Language::Es, Language::Tr] {
            for text in &english {
                let own = in_language(text, language);
                assert!(!own.is_empty(), "{language:?}: {text}");
                assert_eq!(
                    own.matches(';').count(),
                    text.matches(';').count(),
                    "{language:?}: {text}: {own}"
                );
                let is_other = !matches!(language, Language::Zh | Language::Ru) || !own.is_ascii();
                let is_sign = !text.contains(char::is_lowercase);
                assert!(is_sign || is_other, "{language:?}: {text}: {own}");
            }
            let known = TEXTS[language as usize].get().unwrap();
            let strange = known.keys().find(|text| !english.contains(&***text));
            assert_eq!((strange, known.len()), (None, english.len()), "{language:?}");
        }
    }
}
