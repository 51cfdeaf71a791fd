//! What forms are called, in the languages of the panel. What a language lacks is shown in English; a test holds
//! that none lacks anything.

use ferrocut_machine::Language;
use fluent_bundle::FluentResource;
use fluent_bundle::concurrent::FluentBundle;
use std::sync::OnceLock;
use unic_langid::LanguageIdentifier;

/// The texts of a language.
pub struct Texts {
    language: Language,
    bundle: FluentBundle<FluentResource>,
}

/// The catalogue of a language as written.
pub fn source(language: Language) -> &'static str {
    match language {
        Language::En => include_str!("../messages/en.ftl"),
        Language::Zh => include_str!("../messages/zh.ftl"),
        Language::Ru => include_str!("../messages/ru.ftl"),
        Language::Es => include_str!("../messages/es.ftl"),
        Language::Tr => include_str!("../messages/tr.ftl"),
    }
}

static TEXTS: [OnceLock<Texts>; 5] = [const { OnceLock::new() }; 5];

impl Texts {
    /// The texts in a language. They are read at the first use and kept.
    pub fn of(language: Language) -> &'static Texts {
        let place = Language::ALL.iter().position(|l| *l == language).unwrap_or(0);
        let [english, ..] = &TEXTS;
        TEXTS.get(place).unwrap_or(english).get_or_init(|| Texts::read(language))
    }

    fn read(language: Language) -> Texts {
        let locale = language.tag().parse::<LanguageIdentifier>().unwrap_or_default();
        let mut bundle = FluentBundle::new_concurrent(vec![locale]);
        bundle.set_use_isolating(false);
        let resource = FluentResource::try_new(source(language).to_owned()).unwrap_or_else(|(read, _)| read);
        // A repeated message keeps its first text; a test holds that there is none.
        let _ = bundle.add_resource(resource);
        Texts { language, bundle }
    }

    /// A text, where this language or English has it.
    pub fn find(&self, key: &str) -> Option<String> {
        let own = self.bundle.get_message(key).and_then(|message| message.value()).map(|pattern| {
            let mut errors = Vec::new();
            self.bundle.format_pattern(pattern, None, &mut errors).into_owned()
        });
        match own {
            None if self.language != Language::En => Texts::of(Language::En).find(key),
            own => own,
        }
    }

    /// A text; its key where there is none.
    pub fn get(&self, key: &str) -> String {
        self.find(key).unwrap_or_else(|| key.to_owned())
    }
}
