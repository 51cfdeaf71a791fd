//! What is wrong with a file that says what a machine is, or what its control holds.

use crate::memory::VariableError;
use crate::messages::{Catalogue, Language};
use crate::offsets::WorkOffset;
use crate::parameters::{ParameterError, ParameterKey};
use std::fmt;

/// What is wrong with a machine or set-up file, or a table beside them, in words that say what to change.
///
/// Places are named by the keys of the file, which are the same in every language: `axes X: homing: fast`.
#[derive(Clone, PartialEq, Debug)]
pub struct ConfigError {
    reason: Box<Reason>,
    /// Section and key that it is about.
    place: Option<(&'static str, Box<str>)>,
}

#[derive(Clone, PartialEq, Debug)]
enum Reason {
    /// What the reader of TOML says, which is English whoever reads it.
    Toml(String),
    /// A text of `labels.ftl` with its values.
    Label { key: &'static str, values: Vec<(&'static str, String)> },
    /// A parameter of the table `[parameters]`.
    Parameter(ParameterError),
    /// A variable, and where it stands.
    Variable { place: String, error: VariableError },
}

impl ConfigError {
    fn of(reason: Reason) -> ConfigError {
        ConfigError { reason: Box::new(reason), place: None }
    }

    /// The same about a key of a section.
    pub(crate) fn at(mut self, section: &'static str, key: impl ToString) -> ConfigError {
        self.place = Some((section, key.to_string().into()));
        self
    }

    /// The line of `text`, the file that it is about, where that says what it cannot.
    pub fn line(&self, text: &str) -> Option<usize> {
        let (section, key) = self.place.as_ref()?;
        let file = toml::de::DeTable::parse(text).ok()?;
        let (_, section) = file.get_ref().iter().find(|(name, _)| name.get_ref() == section)?;
        let is_it = |name: &str| match section_key(name) {
            Some(name) => section_key(key) == Some(name),
            None => name.eq_ignore_ascii_case(key),
        };
        let (name, _) = section.get_ref().as_table()?.iter().find(|(name, _)| is_it(name.get_ref()))?;
        text.get(..name.span().start).map(|before| before.matches('\n').count() + 1)
    }

    /// A file that is no TOML, or has other keys or values than it may.
    pub(crate) fn toml(error: &toml::de::Error) -> ConfigError {
        ConfigError::of(Reason::Toml(error.to_string()))
    }

    /// A text of `labels.ftl`, to be given its values.
    pub(crate) fn label(key: &'static str) -> ConfigError {
        ConfigError::of(Reason::Label { key, values: Vec::new() })
    }

    /// The same with a value.
    pub(crate) fn with(mut self, name: &'static str, value: impl ToString) -> ConfigError {
        if let Reason::Label { values, .. } = &mut *self.reason {
            values.push((name, value.to_string()));
        }
        self
    }

    /// A parameter that cannot be set.
    pub fn parameter(error: ParameterError) -> ConfigError {
        let name = error.name().map(Box::from);
        let place = name.map(|name| ("parameters", name));
        ConfigError { place, ..ConfigError::of(Reason::Parameter(error)) }
    }

    /// A variable that cannot be set, and where it stands.
    pub(crate) fn variable(place: impl ToString, error: VariableError) -> ConfigError {
        ConfigError::of(Reason::Variable { place: place.to_string(), error })
    }

    /// What stands twice and may stand once.
    pub(crate) fn twice(what: impl ToString) -> ConfigError {
        ConfigError::label("label-config-twice").with("what", what)
    }

    /// As many of something as there may not be.
    pub(crate) fn count(what: impl ToString, count: usize, min: usize, max: usize) -> ConfigError {
        let error = ConfigError::label("label-config-count").with("what", what).with("value", count);
        error.with("min", min).with("max", max)
    }

    /// What is wrong, in the language of `texts`.
    pub fn told(&self, texts: Catalogue) -> String {
        let label = |key: &str, values: &[(&'static str, &str)]| {
            let values: Vec<_> = values.iter().map(|(name, value)| (*name, (*value).into())).collect();
            texts.label(key, &values)
        };
        match &*self.reason {
            Reason::Toml(text) => text.clone(),
            Reason::Label { key, values } => {
                let values: Vec<_> = values.iter().map(|(name, value)| (*name, value.as_str())).collect();
                label(key, &values)
            }
            Reason::Parameter(error) => label("label-config-parameter", &[("reason", &error.told(texts))]),
            Reason::Variable { place, error: VariableError::Null } => {
                label("label-config-null-variable", &[("what", place)])
            }
            Reason::Variable { place, error: VariableError::Full } => {
                label("label-config-variables", &[("what", place)])
            }
        }
    }
}

/// What keys that may be written in several ways stand for.
fn section_key(name: &str) -> Option<(Option<WorkOffset>, Option<ParameterKey>)> {
    let key = (name.parse().ok(), name.parse().ok());
    (key != (None, None)).then_some(key)
}

/// In English.
impl fmt::Display for ConfigError {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        f.write_str(&self.told(Catalogue::new(Language::En)))
    }
}

impl std::error::Error for ConfigError {}

/// A number that must not be `inf` or `nan`, which TOML has too.
pub(crate) fn finite(what: &str, value: f64) -> Result<(), ConfigError> {
    match value.is_finite() {
        true => Ok(()),
        false => Err(ConfigError::label("label-config-finite").with("what", what).with("value", value)),
    }
}

/// A number that must be above 0.
pub(crate) fn positive(what: &str, value: f64) -> Result<(), ConfigError> {
    finite(what, value)?;
    match value > 0.0 {
        true => Ok(()),
        false => Err(ConfigError::label("label-config-positive").with("what", what).with("value", value)),
    }
}

/// A number that must be 0 or more.
pub(crate) fn not_negative(what: &str, value: f64) -> Result<(), ConfigError> {
    finite(what, value)?;
    match value >= 0.0 {
        true => Ok(()),
        false => Err(ConfigError::label("label-config-not-negative").with("what", what).with("value", value)),
    }
}

/// A number that must lie between two others.
pub(crate) fn within(what: &str, value: f64, min: f64, max: f64) -> Result<(), ConfigError> {
    match (min..=max).contains(&value) {
        true => Ok(()),
        false => {
            let error = ConfigError::label("label-config-range").with("what", what).with("value", value);
            Err(error.with("min", min).with("max", max))
        }
    }
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::{Machine, Setup};

    #[test]
    fn reasons_are_told_in_the_language_of_the_reader() {
        let period = Machine::from_toml("name = \"m\"\nservo_period_ms = 20.0\naxes = []").unwrap_err();
        for (language, says) in [
            (Language::En, "servo_period_ms is 20: it must be 0.25 to 4"),
            (Language::Zh, "servo_period_ms 为 20：应为 0.25 至 4"),
            (Language::Ru, "servo_period_ms равно 20: должно быть от 0.25 до 4"),
            (Language::Es, "servo_period_ms es 20: debe ser de 0.25 a 4"),
            (Language::Tr, "servo_period_ms 20: 0.25 ile 4 arasında olmalı"),
        ] {
            assert_eq!(period.told(Catalogue::new(language)), says);
        }
        let setup = Setup::from_toml("[parameters]\nP270 = -1").unwrap();
        let parameter = setup.apply(&mut crate::Memory::new("gsk990mc")).unwrap_err();
        for language in Language::ALL {
            let told = parameter.told(Catalogue::new(language));
            assert!(
                told.contains("[parameters]") && told.contains("P270") && told.contains("999.9999"),
                "{told}"
            );
            assert!(language == Language::En || told != parameter.to_string(), "{told}");
        }
    }
}
