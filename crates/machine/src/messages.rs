//! The texts of alarms, in the languages that people read.
//!
//! Texts live in Fluent catalogues under `messages/<language>/`: `core.ftl`, `cycles.ftl`, `drawings.ftl`, `ladder.ftl`
//! and `memory.ftl` for the faults common to all controls (`FC-0302`), one further file for each control with alarm numbers of its own
//! (`gsk990mc-0045`). A message has
//!
//! - a value: what is wrong, in one sentence without a full stop and without arguments;
//! - `.help`: what to do, without arguments; may be missing;
//! - `.detail`, `.detail-2` …: the values at hand, such as `X to 512.3, limit 500`. The first whose
//!   arguments the alarm carries is shown behind the sentence; none, where none is complete. So a text
//!   never has a hole, whatever an alarm carries.
//!
//! A control's message without a detail takes that of the fault. Where nothing else fits, an argument
//! `detail` is shown as it is. Every language has every message, with the same arguments; a test holds that.
//!
//! # Arguments
//!
//! Lengths are mm, feeds mm/min, speeds r/min; `number`, `tool`, `speed` and `feed` come without their
//! address. Arguments not listed are not shown.
//!
//! | fault | arguments |
//! |---|---|
//! | any | `detail`: a finished piece of text |
//! | `IllegalCharacter` | `character` |
//! | `NumberWithoutAddress`, `AddressWithoutNumber`, `MisplacedSign`, `MisplacedPoint`, `NumberTooLarge` | `word` |
//! | `LineTooLong` | `limit` in bytes |
//! | `BracketsTooDeep`, `TooManyMCodes`, `TooManyHelicalAxes`, `CallsTooDeep` | `limit` |
//! | `MalformedExpression`, `MalformedStatement`, `MixedStatement`, `UnclosedText`, `LengthInArc` | `word` |
//! | `UnknownFunction` | `name` |
//! | `UnknownGCode`, `UnknownMCode`, `UnknownAddress`, `RepeatedAddress`, `WordNotWhole`, `WordNegative`, `NeedsOwnBlock`, `NotSupported`, `LengthWithCode`, `TappingPitchTwice`, `WordMissing`, `CycleBesideCode` | `word` |
//! | `RepeatedGroup`, `ProgramCodesTogether` | `first`, `second`: the words |
//! | `WordOutOfRange` | `word`, `min`, `max`; or `word` alone |
//! | `UnknownAxis`, `ArcAxisBesidePlane`, `IntermediateMissing` | `axis` |
//! | `ArcRadiusMismatch` | `start`, `end`: radii; `limit` |
//! | `ArcRadiusTooSmall` | `radius`; `least`: the smallest that reaches |
//! | `NegativeDwell`, `FeedOutOfRange` | `word` |
//! | `CoordinateTooLarge` | `axis`, `position` |
//! | `OffsetNumber` | `number`, `limit` |
//! | `ScaleFactor` | `min`, `max` |
//! | `WorkOffsetNumber` | `name` |
//! | `CyclePlane` | `plane` |
//! | `CycleDepthAboveR` | `depth`, `r`: Z levels |
//! | `CycleNoPeck` | `word`: the missing address |
//! | `ReferenceInCycle` | `word` |
//! | `ProgramMissing`, `ProgramNumber`, `ProgramRepeated` | `program` |
//! | `TooManyRepeats` | `repeats`, `limit` |
//! | `SequenceMissing`, `JumpTargetMissing` | `number` |
//! | `FunctionDomain` | `name`, `value` |
//! | `UnknownVariable`, `VariableNotWritable` | `variable` |
//! | `CycleParameter` to `CycleNoFeed`, `MillToolMissing`, `MillTooManyMoves`, `TappingSpeed`, `PatternNotWhole` to `PatternForm`, `UnknownParameter`, `ParameterKind`, `ProfileMissing` to `ProfileWay`, `ProfileEmpty` to `NoEntryAngle` | `parameter`: its name; `value` and `limit` of it, or `contour`: which one of the profile |
//! | `NoCycleParameter` | `variable` |
//! | `UnknownDirective`, `DirectiveMisplaced` | `word` |
//! | `PlaneAxes` | `axis` |
//! | `SoftLimit` | `axis`, `position`, `limit`: machine positions |
//! | `FollowingError`, `NotInPosition` | `axis`, `distance`, `limit` |
//! | `HomeSwitch`, `HomeMarker`, `HomingStopped`, `NotReferenced`, `ReferenceNeeded`, `ReferenceByProgram` | `axis` |
//! | `HardLimit` | `axis`, `side`: `+` or `-` |
//! | `PitchPoint` | `axis`, `position`, `limit`: machine positions |
//! | `ToolMissing` | `tool` |
//! | `SpindleTooFast` | `speed`, `limit` |
//! | `FeedNotReachable` | `feed`, `limit` |
//! | `TappingFeedHeld` | `feed`, `limit`; `speed` of a spindle that keeps the pitch |
//! | `FileUnreadable`, `ConfigUnusable` | `file`, `reason`; or one of them |
//! | `FileUnwritable` | `file`, `reason` |
//! | `FileNotText`, `FileEmpty`, `PictureFormat`, `NoDrawing` | `file` |
//! | `UnknownDialect`, `BlockInItself`, `BlockMissing`, `NoWriter` | `name` |
//! | `DrawingTooLarge` | the highest number: of `megabytes`, `curves`, `points` or `inserts` |
//! | `DrawingTooFar` | `position`, `limit` |
//! | `DxfGroupCode`, `DxfValue`, `DxfEntity`, `PltInstruction`, `PltArguments` | `word` |
//! | `EntityLeftOut` | `kind`, `count` |
//! | `LayerLeftOut` | `name`, `count` |
//! | `NothingOnLayer` | `name`, `names` |
//! | `HiddenLeftOut` | `count` |
//! | `PltLeftOut`, `PltUnknown` | `instruction` |
//! | `ImportSetting`, `LadderSetting`, `PlotSetting` | `setting`, `value`, `allowed` |
//! | `Ladder` | `word` |
//! | `LadderUnusable` | `line` |
//! | `ControlMode`, `ControlInterrupted` | `mode` |
//! | `NotFitted`, `NoSuchName`, `ProgramInUse`, `SignalNotData`, `MachineMessage` | `name` |
//! | `ValueImpossible` | `name`; with it `min` and `max` where they are known |
//! | `MemoryValue` | `name`, `value`, `min`, `max`: as many as there are; or `whole`, `value`: the name of what is whole; or `unknown`: a name |
//! | `NoSuchLine` | `line` |
//! | `NotKept` | `reason` |
//! | `RestartOtherProgram`, `RestartChanged`, `RestartNotAsProgram` | `name` |
//! | `RestartNotReferenced`, `MeasureNotReferenced` | `axis` |
//! | `ProbeMissing`, `PointsUnusable`, `MeasureSetting`, `MeasureForbidden` | `name` |
//! | `ProbeMissed`, `SetterMissed` | `axis`, `position` |
//! | `MeasuredSize` | `value`, `nominal`, `limit` |
//! | `MemoryOfOther`, `BackupOfOther` | `name` |
//! | `MemoryDisk` | `reason` |
//! | `CannotServe` | `place`, `reason` |
//! | `CheckEnded` | `line` |
//! | `MemoryDamaged` | `detail`; `commits`, `time` and `command` of the newest good state, where there is one |
//! | `PanelNotEncrypted`, `PanelWithoutPassword` | `place` |
//! | `Certificate` | `file`, `reason` |
//! | `MemoryMissing` | `file`: the folder |
//! | `NotABackup` | `file`; `version` of a later one |
//! | `BackupDamaged` | `file`, `line` |
//! | `RightMissing` | `needed`, `level`: their numbers |
//! | `ChangeProtected` | `parameter` |
//! | `ProgramLocked`, `LevelWithoutPassword` | `level` |
//! | `PasswordWait` | `time` in s |
//! | `CodeNotFinished` | `word`: the code |
//! | `CaptureSetting` | `value` |
//! | `RestartBlockMissing` | `line` |
//! | `RestartNotReached` | `line`, `passes`: how often it was reached |
//! | `RestartUnknown` | `count` |
//! | `DrivesSilent`, `DrivesCut` | `place`, `reason` |
//! | `DrivesLost`, `DriveWatchdog` | `time` in ms |
//! | `DrivesUnsuited` | `name`: the key of the machine file; `value`, `limit` |
//! | `StepRate` | `axis`; `value`, `limit` in steps/s |
//! | `DriveFrameLost` | `count` |
//! | `DriveTooFast`, `DriveAmplifier` | `axis` |
//! | `DriveStopped` | `code` |
//! | `CycleUnknown`, `CycleSynchronised`, `CycleNotWritten` | `name` |
//! | `CycleValue` | `parameter`, `value`, `min`, `max` |
//! | `CycleChoice`, `CycleName` | `parameter` |
//! | `CycleTooLong` | `limit` |

use crate::alarm::{Alarm, AlarmId, Argument, Fault};
use crate::reference_texts::in_language;
use fluent_bundle::concurrent::FluentBundle;
use fluent_bundle::{FluentArgs, FluentMessage, FluentResource};
use std::collections::BTreeMap;
use std::sync::OnceLock;
use unic_langid::LanguageIdentifier;

/// The files of a language's catalogue.
macro_rules! catalogue {
    ($language:literal) => {
        &[
            include_str!(concat!("../messages/", $language, "/core.ftl")),
            include_str!(concat!("../messages/", $language, "/drawings.ftl")),
            include_str!(concat!("../messages/", $language, "/cycles.ftl")),
            include_str!(concat!("../messages/", $language, "/ladder.ftl")),
            include_str!(concat!("../messages/", $language, "/memory.ftl")),
            include_str!(concat!("../messages/", $language, "/labels.ftl")),
            include_str!(concat!("../messages/", $language, "/signals.ftl")),
            include_str!(concat!("../messages/", $language, "/gsk990mc.ftl")),
        ]
    };
}

/// A language that people read.
#[derive(Clone, Copy, PartialEq, Eq, Hash, Debug, Default)]
pub enum Language {
    /// English.
    #[default]
    En,
    /// Chinese, simplified.
    Zh,
    /// Russian.
    Ru,
    /// Spanish.
    Es,
    /// Turkish.
    Tr,
}

impl Language {
    /// Every language.
    pub const ALL: [Language; 5] = [Language::En, Language::Zh, Language::Ru, Language::Es, Language::Tr];

    /// The language of a tag or locale: `zh`, `zh-Hans`, `zh_CN.UTF-8`; `C` and `POSIX` are English.
    /// None for a language that there is no text in.
    pub fn from_tag(tag: &str) -> Option<Language> {
        let name = tag.split(['-', '_', '.', '@']).next().unwrap_or_default().to_ascii_lowercase();
        match name.as_str() {
            "c" | "posix" => Some(Language::En),
            _ => Language::ALL.into_iter().find(|language| language.tag() == name),
        }
    }

    /// The tag: `en`.
    pub fn tag(self) -> &'static str {
        match self {
            Language::En => "en",
            Language::Zh => "zh",
            Language::Ru => "ru",
            Language::Es => "es",
            Language::Tr => "tr",
        }
    }

    /// What its catalogue is read from.
    fn sources(self) -> &'static [&'static str] {
        match self {
            Language::En => catalogue!("en"),
            Language::Zh => catalogue!("zh"),
            Language::Ru => catalogue!("ru"),
            Language::Es => catalogue!("es"),
            Language::Tr => catalogue!("tr"),
        }
    }
}

/// Alarms that a program sets itself share one text: `G65 H99 Pn` raises 3000 + n (GSK990MC 4.9.4).
const SET_BY_PROGRAM: (&str, std::ops::RangeInclusive<u16>, &str) =
    ("gsk990mc", 3000..=3999, "gsk990mc-3000");

/// The texts in one language.
#[derive(Clone, Copy)]
pub struct Catalogue {
    language: Language,
    texts: &'static Texts,
}

static TEXTS: [OnceLock<Texts>; 5] = [const { OnceLock::new() }; 5];

impl Catalogue {
    /// The texts in `language`. They are read at the first use and kept.
    pub fn new(language: Language) -> Catalogue {
        let texts = &TEXTS[language as usize];
        Catalogue { language, texts: texts.get_or_init(|| Texts::read(language)) }
    }

    /// The language asked for.
    pub fn language(self) -> Language {
        self.language
    }

    /// What a text of the reference tables is in this language.
    pub fn of_reference(self, english: &str) -> &str {
        in_language(english, self.language)
    }

    /// What is wrong, in one sentence without a full stop, with the values at hand.
    pub fn message(self, alarm: &Alarm) -> String {
        let arguments = arguments(alarm);
        let given = alarm.arguments.iter().find(|(name, _)| *name == "detail").map(|(_, a)| shown(a));
        self.sentence(alarm.id, &[alarm.fault], &arguments, given)
    }

    /// The same of an alarm that somebody was told of by its number and values, as fronts are. `faults` are the broken
    /// rules that the number may stand for.
    pub fn told(self, id: AlarmId, faults: &[Fault], values: &BTreeMap<String, String>) -> String {
        let of = |text: &String| match text.parse::<f64>() {
            Ok(number) if number.to_string() == *text => short(number),
            _ => text.clone(),
        };
        let arguments: FluentArgs = values.iter().map(|(name, text)| (name.clone(), of(text))).collect();
        self.sentence(id, faults, &arguments, values.get("detail").map(of))
    }

    fn sentence(
        self,
        id: AlarmId,
        faults: &[Fault],
        arguments: &FluentArgs,
        given: Option<String>,
    ) -> String {
        let ids = || [id].into_iter().chain(faults.iter().map(|fault| AlarmId::Core(*fault)));
        let Some(text) = ids().find_map(|id| self.text(id)) else { return id.to_string() };
        match ids().find_map(|id| self.detail(id, arguments)).or(given) {
            Some(detail) => self.joined(&text, &detail).unwrap_or(text),
            None => text,
        }
    }

    /// What to do about it, in whole sentences.
    pub fn help(self, alarm: &Alarm) -> Option<String> {
        self.help_of(alarm.id).or_else(|| self.help_of(AlarmId::Core(alarm.fault)))
    }

    /// What an alarm says without its values, for lists; none where no text is known.
    pub fn text(self, id: AlarmId) -> Option<String> {
        self.find(id, |texts, message| texts.complete(&message, None, None))
    }

    /// What to do about an alarm, for lists; none where no text is known.
    pub fn help_of(self, id: AlarmId) -> Option<String> {
        self.find(id, |texts, message| texts.complete(&message, Some("help"), None))
    }

    /// A text of `labels.ftl`, which holds what is shown beside alarms; the key itself where there is
    /// none or an argument of it is missing.
    pub fn label(self, key: &str, arguments: &[(&str, Argument)]) -> String {
        let mut named = FluentArgs::new();
        for (name, argument) in arguments {
            match argument {
                Argument::Number(number) => named.set(*name, *number),
                Argument::Text(text) => named.set(*name, text.to_string()),
            }
        }
        let found = self.look_up(key, &|texts, message| texts.complete(&message, None, Some(&named)));
        found.unwrap_or_else(|| key.to_owned())
    }

    fn detail(self, id: AlarmId, arguments: &FluentArgs) -> Option<String> {
        self.find(id, |texts, message| {
            let mut details = message.attributes().filter(|a| a.id().starts_with("detail"));
            details.find_map(|a| texts.complete(&message, Some(a.id()), Some(arguments)))
        })
    }

    fn joined(self, text: &str, detail: &str) -> Option<String> {
        let mut arguments = FluentArgs::new();
        arguments.set("text", text.to_owned());
        arguments.set("detail", detail.to_owned());
        self.look_up("with-detail", &|texts, message| texts.complete(&message, None, Some(&arguments)))
    }

    /// What `read` makes of the alarm's message.
    fn find(
        self,
        id: AlarmId,
        read: impl Fn(&'static Texts, FluentMessage<'static>) -> Option<String>,
    ) -> Option<String> {
        let key = match id {
            AlarmId::Dialect(dialect, number) => format!("{dialect}-{number:04}"),
            AlarmId::Core(_) => id.to_string(),
        };
        let own = self.look_up(&key, &read);
        own.or_else(|| match (id, SET_BY_PROGRAM) {
            (AlarmId::Dialect(dialect, number), (of, numbers, key))
                if dialect == of && numbers.contains(&number) =>
            {
                self.look_up(key, &read)
            }
            _ => None,
        })
    }

    fn look_up(
        self,
        key: &str,
        read: &impl Fn(&'static Texts, FluentMessage<'static>) -> Option<String>,
    ) -> Option<String> {
        read(self.texts, self.texts.bundle.get_message(key)?)
    }
}

/// One language's catalogue as read.
struct Texts {
    bundle: FluentBundle<FluentResource>,
}

impl Texts {
    /// Reads the catalogue. A message that cannot be read is left out; a test holds that there is none.
    fn read(language: Language) -> Texts {
        // An unreadable tag would only be an unknown language to Fluent; nothing here depends on it.
        let locale = language.tag().parse::<LanguageIdentifier>().unwrap_or_default();
        let mut bundle = FluentBundle::new_concurrent(vec![locale]);
        // Marks that keep directions of writing apart: none of the languages needs them, and they would
        // show in a terminal and in JSON.
        bundle.set_use_isolating(false);
        for source in language.sources() {
            let resource = FluentResource::try_new((*source).to_owned()).unwrap_or_else(|(read, _)| read);
            // A repeated message keeps its first text.
            let _ = bundle.add_resource(resource);
        }
        Texts { bundle }
    }

    /// The text of a message or of one of its attributes; none where an argument of it is missing.
    fn complete(
        &self,
        message: &FluentMessage,
        attribute: Option<&str>,
        arguments: Option<&FluentArgs>,
    ) -> Option<String> {
        let pattern = match attribute {
            None => message.value()?,
            Some(name) => message.get_attribute(name)?.value(),
        };
        let mut errors = Vec::new();
        let text = self.bundle.format_pattern(pattern, arguments, &mut errors);
        errors.is_empty().then(|| text.into_owned())
    }
}

fn arguments(alarm: &Alarm) -> FluentArgs<'static> {
    alarm.arguments.iter().map(|(name, argument)| (*name, shown(argument))).collect()
}

/// An argument as it is shown.
fn shown(argument: &Argument) -> String {
    match argument {
        Argument::Text(text) => text.to_string(),
        Argument::Number(number) => short(*number),
    }
}

/// Above this a number has no decimals that matter.
const LARGEST_PLAIN: f64 = 1e15;

/// A number to 0.0001, the finest increment of the controls, without idle zeros.
fn short(number: f64) -> String {
    if number.is_nan() || number.abs() >= LARGEST_PLAIN {
        return format!("{number:e}");
    }
    let text = format!("{number:.4}");
    match text.trim_end_matches('0').trim_end_matches('.') {
        "-0" => "0".to_owned(),
        short => short.to_owned(),
    }
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::alarm_table::alarm_table;
    use ferrocut_program::Span;
    use std::collections::BTreeSet;

    fn ids() -> Vec<AlarmId> {
        let core = Fault::ALL.iter().map(|fault| AlarmId::Core(*fault));
        core.chain(alarm_table("gsk990mc").iter().map(|row| row.id)).collect()
    }

    #[test]
    fn catalogues_have_no_errors_and_no_message_twice() {
        for language in Language::ALL {
            let mut bundle = FluentBundle::new_concurrent(vec![language.tag().parse().unwrap()]);
            for source in language.sources() {
                let resource = FluentResource::try_new((*source).to_owned()).map_err(|(_, errors)| errors);
                assert_eq!(bundle.add_resource(resource.unwrap()), Ok(()), "{language:?}");
            }
        }
    }

    #[test]
    fn every_label_is_in_every_language() {
        let labels = |language: Language| -> BTreeSet<&'static str> {
            let lines = language.sources().iter().flat_map(|source| source.lines());
            lines
                .filter(|line| line.starts_with("label-"))
                .filter_map(|line| line.split(" =").next())
                .collect()
        };
        assert!(labels(Language::En).contains("label-time"));
        for language in Language::ALL {
            assert_eq!(labels(Language::En), labels(language), "{language:?}");
        }
        let catalogue = Catalogue::new(Language::En);
        let checked = |findings: f64| {
            let arguments =
                [("files", 2.0.into()), ("machine", "Demo mill".into()), ("findings", findings.into())];
            catalogue.label("label-checked", &arguments)
        };
        assert_eq!(checked(0.0), "2 files checked on Demo mill: no findings");
        assert_eq!(checked(1.0), "2 files checked on Demo mill: 1 finding");
        assert_eq!(checked(5.0), "2 files checked on Demo mill: 5 findings");
    }

    #[test]
    fn catalogues_hold_the_alarms_and_nothing_else() {
        let key = |id: AlarmId| id.to_string().replace(':', "-");
        let mut known: BTreeSet<String> = ids().into_iter().map(key).collect();
        assert_eq!(known.len(), ids().len(), "alarm ids are unique");
        known.extend(["with-detail", "gsk990mc-3000"].map(str::to_owned));
        for language in Language::ALL {
            let messages = language.sources().iter().flat_map(|source| source.lines()).filter_map(|line| {
                let (name, _) = line.split_once(" =")?;
                (!name.starts_with([' ', '#']) && !name.starts_with("label-")).then(|| name.to_owned())
            });
            let written: BTreeSet<_> = messages.collect();
            assert_eq!(known.symmetric_difference(&written).collect::<Vec<_>>(), [""; 0], "{language:?}");
        }
    }

    #[test]
    fn every_alarm_has_a_text() {
        for language in Language::ALL {
            let texts = Texts::read(language);
            for id in ids() {
                let key = id.to_string().replace(':', "-");
                let message = texts.bundle.get_message(&key).unwrap();
                let text = texts.complete(&message, None, None).unwrap();
                assert!(!text.is_empty() && !text.contains("{$"), "{key}: {text}");
                assert!(!text.ends_with(['.', '。']), "{key}: a message has no full stop: {text}");
                let help = texts.complete(&message, Some("help"), None);
                assert!(matches!(id, AlarmId::Dialect(..)) || help.is_some(), "{key}: no help");
                let full_stop = |help: String| help.ends_with(['.', '。']) && !help.contains("{$");
                assert!(help.is_none_or(full_stop), "{key}: help is whole sentences");
            }
        }
    }

    /// The arguments that each text names, by its message and attribute.
    fn arguments_named(language: Language) -> BTreeMap<String, BTreeSet<&'static str>> {
        let mut named: BTreeMap<String, BTreeSet<&str>> = BTreeMap::new();
        let (mut message, mut key) = ("", String::new());
        for line in language.sources().iter().flat_map(|source| source.lines()) {
            match line.split_once(" =") {
                Some((name, _)) if !line.starts_with([' ', '#']) => {
                    (message, key) = (name, name.to_owned());
                }
                Some((name, _)) if line.trim_start().starts_with('.') => {
                    key = format!("{message}{}", name.trim());
                }
                _ if line.starts_with('#') => continue,
                _ => {}
            }
            let places = line.split("{ $").skip(1).filter_map(|rest| rest.split(' ').next());
            named.entry(key.clone()).or_default().extend(places);
        }
        named
    }

    #[test]
    fn every_text_is_in_every_language_with_the_same_values() {
        let english = arguments_named(Language::En);
        assert_eq!(english["FC-0206.detail"], BTreeSet::from(["word", "min", "max"]));
        for language in Language::ALL {
            let own = arguments_named(language);
            for (key, arguments) in &english {
                assert_eq!(own.get(key), Some(arguments), "{language:?} {key}");
            }
            assert_eq!(own.len(), english.len(), "{language:?}");
        }
    }

    /// Every alarm says what to do about it.
    #[test]
    fn alarms_have_help() {
        for language in Language::ALL {
            for row in alarm_table("gsk990mc") {
                assert!(Catalogue::new(language).help_of(row.id).is_some(), "{language:?} {}", row.id);
            }
        }
    }

    #[test]
    fn texts_are_in_their_language() {
        let english = Catalogue::new(Language::En);
        for id in ids() {
            let texts = |catalogue: Catalogue| [catalogue.text(id), catalogue.help_of(id)];
            assert!(english.text(id).is_some_and(|text| text.is_ascii()), "{id}");
            for language in [Language::Zh, Language::Ru, Language::Es, Language::Tr] {
                for (own, english) in texts(Catalogue::new(language)).iter().zip(texts(english)) {
                    assert_eq!(own.is_some(), english.is_some(), "{language:?} {id}");
                    let Some((own, english)) = own.as_ref().zip(english) else { continue };
                    assert_ne!(*own, english, "{language:?} {id}");
                    // Chinese and Russian are written in other letters.
                    let is_other = !matches!(language, Language::Zh | Language::Ru) || !own.is_ascii();
                    assert!(is_other, "{language:?} {id}");
                }
            }
        }
    }

    #[test]
    fn details_stand_behind_the_sentence_when_they_are_complete() {
        let alarm = Alarm::core(Fault::SoftLimit, Span::default());
        let message = |alarm: &Alarm, language| Catalogue::new(language).message(alarm);
        let plain = message(&alarm, Language::En);
        let alarm = alarm.with("position", 512.3);
        assert_eq!(message(&alarm, Language::En), plain);
        let alarm = alarm.with("axis", "X");
        assert_eq!(message(&alarm, Language::En), format!("{plain} (X)"));
        let alarm = alarm.with("limit", 500.0);
        assert_eq!(message(&alarm, Language::En), format!("{plain} (X to 512.3, limit 500)"));
        assert!(message(&alarm, Language::Zh).ends_with('）'));
        assert!(Catalogue::new(Language::En).help(&alarm).is_some());
    }

    #[test]
    fn an_alarm_of_a_control_takes_what_its_fault_knows() {
        let english = Catalogue::new(Language::En);
        let id = AlarmId::Dialect("gsk990mc", 20);
        let alarm = Alarm::new(id, Fault::ArcRadiusMismatch, Span::default());
        let alarm = alarm.with("start", 10.0).with("end", 10.2).with("limit", 0.05);
        let message = english.message(&alarm);
        assert!(message.contains("10.2") && message.starts_with(&english.text(id).unwrap()), "{message}");
        // A number without a text of its own.
        let id = AlarmId::Dialect("weihong", 7);
        let alarm = Alarm::new(id, Fault::NoFeed, Span::default());
        assert_eq!(Some(english.message(&alarm)), english.text(AlarmId::Core(Fault::NoFeed)));
        assert_eq!(english.text(id), None);
    }

    #[test]
    fn any_alarm_may_bring_a_detail_of_its_own() {
        let id = AlarmId::Dialect("gsk990mc", 3007);
        let alarm = Alarm::new(id, Fault::NoFeed, Span::default()).with("detail", "PART MISSING");
        let english = Catalogue::new(Language::En);
        let text = english.text(id).unwrap();
        assert_eq!(english.message(&alarm), format!("{text} (PART MISSING)"));
    }

    #[test]
    fn every_detail_is_documented() {
        let documented = include_str!("messages.rs");
        for language in Language::ALL {
            let (core, dialect) = language.sources().split_first().unwrap();
            for piece in core.split("{ $").skip(1) {
                let name = piece.split(' ').next().unwrap();
                assert!(name == "text" || documented.contains(&format!("`{name}`")), "{name}");
            }
            let alarms = dialect.iter().flat_map(|text| text.lines()).filter(|l| !l.starts_with("label-"));
            // Plurals of a label go over several lines, which begin with blanks and a bracket.
            let alarms =
                alarms.filter(|line| line.starts_with("gsk") || line.trim_start().starts_with(".help"));
            assert!(alarms.into_iter().all(|line| !line.contains("{ $")));
        }
    }

    #[test]
    fn languages_are_found_by_their_locale() {
        for (tag, language) in [
            ("en", Some(Language::En)),
            ("en_GB.UTF-8", Some(Language::En)),
            ("C.UTF-8", Some(Language::En)),
            ("zh_CN.UTF-8", Some(Language::Zh)),
            ("zh-Hans", Some(Language::Zh)),
            ("RU", Some(Language::Ru)),
            ("es@euro", Some(Language::Es)),
            ("tr", Some(Language::Tr)),
            ("de", None),
            ("", None),
        ] {
            assert_eq!(Language::from_tag(tag), language, "{tag}");
        }
    }

    #[test]
    fn numbers_are_short() {
        for (number, text) in [
            (1.0, "1"),
            (-0.00001, "0"),
            (0.1 + 0.2, "0.3"),
            (100.0, "100"),
            (12.34567, "12.3457"),
            (1e300, "1e300"),
            (f64::NAN, "NaN"),
        ] {
            assert_eq!(short(number), text);
        }
    }
}
