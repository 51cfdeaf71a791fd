//! What a front (panel, socket, test) says to the control and hears of it: one type of commands, one of answers, one
//! of events, and the status. `docs/api.md` has them for those who write fronts.
//!
//! As JSON a command is an object whose field `do` names it, an answer one with `reply`, an event one with `event`.
//! Lengths are mm, angles degrees, feeds mm/min, speeds r/min, times s, overrides factors, unless a field says
//! otherwise. Axes are called by their letters. Numbers of a control's own tables (parameters) are in the control's
//! own units.

mod command;
mod event;
mod reply;
mod status;

pub use command::*;
pub use event::*;
pub use reply::*;
pub use status::*;

use std::collections::BTreeMap;

/// Version of this interface. It counts up when a field changes its meaning or goes; new fields may come without.
pub const API_VERSION: u32 = 1;

/// Values by the letters of axes.
pub type ByAxis = BTreeMap<char, f64>;

#[cfg(test)]
mod tests {
    use super::*;
    use crate::signals::Mode;

    #[test]
    fn commands_are_objects_named_by_do() {
        for (command, json) in [
            (Command::Reset, r#"{"do":"reset"}"#),
            (Command::StopByHand, r#"{"do":"stop_by_hand"}"#),
            (
                Command::Key { key: "KEY_START".into(), down: true },
                r#"{"do":"key","key":"KEY_START","down":true}"#,
            ),
            (
                Command::SetOffset {
                    number: 3,
                    values: OffsetValues { length: Some(-100.5), ..OffsetValues::default() },
                    add: false,
                },
                r#"{"do":"set_offset","number":3,"length":-100.5,"add":false}"#,
            ),
            (
                Command::Relative { axis: 'X', to: RelativeTo::Value(20.0) },
                r#"{"do":"relative","axis":"X","to":{"value":20.0}}"#,
            ),
            (Command::SpindleSpeed { speed: 1200.0 }, r#"{"do":"spindle_speed","speed":1200.0}"#),
            (
                Command::SetZero { system: "G54".into(), axes: ByAxis::from([('X', 1.5)]), add: false },
                r#"{"do":"set_zero","system":"G54","axes":{"X":1.5},"add":false}"#,
            ),
            (
                Command::SetPitch { axis: 'Y', points: BTreeMap::from([(2, 0.0035)]) },
                r#"{"do":"set_pitch","axis":"Y","points":{"2":0.0035}}"#,
            ),
        ] {
            assert_eq!(serde_json::to_string(&command).unwrap(), json);
            assert_eq!(serde_json::from_str::<Command>(json).unwrap(), command);
        }
        let short = r#"{"do":"set_zero","system":"G54","axes":{}}"#;
        assert!(matches!(serde_json::from_str(short).unwrap(), Command::SetZero { add: false, .. }));
        for bad in [
            "{}",
            r#"{"do":"dance"}"#,
            r#"{"do":"key","key":"KEY_START"}"#,
            "7",
            "[]",
            r#"{"do":"set_pitch","axis":"Y","points":{"-2":0.1}}"#,
        ] {
            assert!(serde_json::from_str::<Command>(bad).is_err(), "{bad}");
        }
    }

    #[test]
    fn events_and_replies_are_objects_named_by_event_and_reply() {
        let event = Event::Mode { mode: Mode::Mdi };
        assert_eq!(serde_json::to_string(&event).unwrap(), r#"{"event":"mode","mode":"mdi"}"#);
        assert_eq!(serde_json::to_string(&Reply::Done).unwrap(), r#"{"reply":"done"}"#);
        let level = Reply::Level { level: 5 };
        assert_eq!(serde_json::to_string(&level).unwrap(), r#"{"reply":"level","level":5}"#);
    }

    /// The variants of an enum of a file with the names of their fields.
    fn variants(source: &'static str, name: &str) -> Vec<(&'static str, Vec<&'static str>)> {
        let (_, body) = source.split_once(&format!("pub enum {name} {{")).unwrap();
        let is_name = |text: &str| text.bytes().all(|b| b.is_ascii_lowercase() || b == b'_');
        let mut all: Vec<(&str, Vec<&str>)> = Vec::new();
        for line in body.split_once("\n}\n").unwrap().0.lines() {
            if let Some((field, _)) = line.strip_prefix("        ").and_then(|line| line.split_once(": ")) {
                if is_name(field) {
                    all.last_mut().unwrap().1.push(field);
                }
            } else if let Some(variant) = line.strip_prefix("    ")
                && variant.starts_with(|c: char| c.is_ascii_uppercase())
            {
                all.push((variant.trim_end_matches([' ', '{', ',']), Vec::new()));
            }
        }
        all
    }

    const DOCUMENT: &str = include_str!("../../../../docs/api.md");

    #[test]
    fn every_field_of_a_command_is_in_the_document() {
        let commands = variants(include_str!("command.rs"), "Command");
        let fields: Vec<&str> = commands.into_iter().flat_map(|(_, fields)| fields).collect();
        for field in fields.iter().filter(|field| **field != "values") {
            assert!(DOCUMENT.contains(&format!("`{field}`")), "docs/api.md lacks {field}");
        }
        assert!(fields.len() > 80, "{fields:?}");
    }

    #[test]
    fn every_event_is_in_the_document_with_its_fields() {
        let section = DOCUMENT.split_once("## Events").unwrap().1.split("\n## ").next().unwrap();
        let events = variants(include_str!("event.rs"), "Event");
        for (event, fields) in &events {
            // As serde writes it.
            let mut name = String::new();
            for c in event.chars() {
                if c.is_ascii_uppercase() && !name.is_empty() {
                    name.push('_');
                }
                name.push(c.to_ascii_lowercase());
            }
            let row = section.lines().find(|line| line.starts_with(&format!("| `{name}` |")));
            let row = row.unwrap_or_else(|| panic!("docs/api.md lacks the event {name}"));
            let told: Vec<String> = fields.iter().map(|field| format!("`{field}`")).collect();
            assert_eq!(row.split('|').nth(2).unwrap().trim(), told.join(", "), "{name}");
        }
        assert!(events.len() > 10, "{events:?}");
    }
}
