//! Backups of the durable memory.

use super::super::{Control, alarm};
use super::{Answer, BACKUPS, named};
use crate::api::{Event, Reply};
use ferrocut_machine::{Alarm, Fault};
use ferrocut_memory::items::limits;
use ferrocut_memory::{Author, Backup, Item};
use std::path::{Path, PathBuf};

impl Control {
    pub(super) fn items(names: &[String]) -> Result<Vec<Item>, Box<Alarm>> {
        let missing = |name: &String| Box::new(named(Fault::NoSuchName, name.as_str()));
        let item = |name: &String| Item::named(name).ok_or_else(|| missing(name));
        names.iter().map(item).collect()
    }

    pub(super) fn back_up(&mut self, file: &str, items: &[String]) -> Answer {
        let items = Control::items(items)?;
        let items = if items.is_empty() { Item::ALL.to_vec() } else { items };
        if self.tick.moving || self.cnc.is_under_way() {
            return Err(Box::new(alarm(Fault::ControlBusy)));
        }
        self.flush()?;
        let store = self.kept()?;
        let written = store.reader().back_up(&backup_in(folder_of(&store)?, file)?, &items);
        written.map_err(|error| error.alarm())?;
        self.event(Event::Changed { item: BACKUPS.to_owned() });
        Ok(Reply::Done)
    }

    /// What was restored holds at once, save what the drives are made of.
    pub(super) fn restore(&mut self, file: &str, items: &[String], author: &Author) -> Answer {
        let items = Control::items(items)?;
        if self.tick.moving || !self.cnc.is_idle() {
            return Err(Box::new(alarm(Fault::ControlBusy)));
        }
        // It would give places of axes that stand where they are the names of another moment, and be written over as soon
        // as one has moved.
        if items.contains(&Item::LastPosition) {
            return Err(Box::new(alarm(Fault::PositionInUse)));
        }
        self.flush()?;
        let store = self.kept()?;
        let path = backup_in(folder_of(&store)?, file)?;
        if !path.is_file() {
            return Err(Box::new(named(Fault::NoSuchName, file)));
        }
        let backup = Backup::open(&path).map_err(|error| error.alarm())?;
        let items = if items.is_empty() { backup.items() } else { items };
        if items.contains(&Item::Programs) {
            self.may_edit_programs(author)?;
        }
        backup.restore(&store, author, &items).map_err(|error| error.alarm())?;
        self.read_again(&items)?;
        for item in items {
            self.event(Event::Changed { item: item.name().to_owned() });
        }
        Ok(Reply::Done)
    }
}

/// The folder that backups lie in; none where nothing is kept.
fn folder_of(store: &ferrocut_memory::Store) -> Result<&Path, Box<Alarm>> {
    store.folder().ok_or_else(|| Box::new(named(Fault::NotFitted, "memory")))
}

/// The file of a backup: nothing that a front names may lie outside the folder, or be anything else in it.
///
/// # Errors
/// The name is that of no backup.
pub fn backup_in(folder: &Path, name: &str) -> Result<PathBuf, Box<Alarm>> {
    let is_plain = |c: char| c.is_alphanumeric() || matches!(c, '-' | '_' | '.' | ' ');
    let is_bare = name.len() <= limits::NAME && name.chars().all(is_plain) && !name.starts_with(['.', ' ']);
    match is_bare && name.ends_with(".backup") {
        true => Ok(folder.join(name)),
        false => Err(Box::new(named(Fault::ValueImpossible, name))),
    }
}
