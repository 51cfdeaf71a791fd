//! What requests ask by: language and control language.

use super::Shared;
use super::problem::Problem;
use ferrocut_controller::control::Desk;
use ferrocut_interpreter::{Dialect, dialects};
use ferrocut_machine::{Catalogue, Language};
use serde::Deserialize;

/// The language of texts, and the control language of a program.
#[derive(Deserialize, Default)]
pub(crate) struct Spoken {
    /// Tag of the language: `en`, `zh`; English where it is missing.
    pub language: Option<String>,
    /// Name of the control language; the control's own where it is missing.
    pub dialect: Option<String>,
}

impl Spoken {
    /// The texts.
    pub fn catalogue(&self) -> Result<Catalogue, Problem> {
        catalogue(self.language.as_deref())
    }

    /// The control language.
    pub fn dialect(&self, shared: &Shared) -> Result<&'static Dialect, Problem> {
        let name = self.dialect.as_deref().unwrap_or(&shared.machine.dialect);
        dialects::by_name(name).ok_or_else(|| Problem::Unreadable("dialect".to_owned()))
    }
}

/// The texts in a language.
pub(crate) fn catalogue(tag: Option<&str>) -> Result<Catalogue, Problem> {
    let language = tag.map_or(Some(Language::En), Language::from_tag);
    language.map(Catalogue::new).ok_or_else(|| Problem::Unreadable("language".to_owned()))
}

/// What programs are interpreted with at the moment.
pub(crate) async fn desk(shared: &Shared) -> Result<Desk, Problem> {
    let hub = shared.hub.clone();
    let desk = tokio::task::spawn_blocking(move || hub.look(|panel| panel.control().desk())).await;
    desk.ok().flatten().ok_or(Problem::NoMachine("no_machine"))
}
