//! Cycles and figures as forms: the interpreter's tables, with what each parameter means.

use crate::fields::{self, Group, Measure, Standard};
use crate::texts::Texts;
use ferrocut_interpreter::cycles::described::{DescribedCycle, Kind, Parameter, Part};
use ferrocut_interpreter::dialects::fagor8065::DIALECT;
use ferrocut_machine::Language;
use serde::Serialize;

/// A value that a fresh form holds.
#[derive(Clone, Copy, PartialEq, Debug, Serialize)]
#[cfg_attr(feature = "typescript", derive(ts_rs::TS))]
#[serde(untagged)]
pub enum Fresh {
    /// A number.
    Number(f64),
    /// A word or name.
    Word(&'static str),
}

/// A choice of a field.
#[derive(Clone, PartialEq, Eq, Debug, Serialize)]
#[cfg_attr(feature = "typescript", derive(ts_rs::TS))]
pub struct Choice {
    /// The word in a block.
    pub value: &'static str,
    /// What it is called.
    pub title: String,
}

/// A field of a form.
#[derive(Clone, PartialEq, Debug, Serialize)]
#[cfg_attr(feature = "typescript", derive(ts_rs::TS))]
pub struct FormField {
    /// Key of its value: the parameter's name, behind its stage and a point where that is not the cycle itself
    /// (`ZS`, `rough.F`).
    pub name: String,
    /// The stage: `cycle`, `drill`, `rough`, `semi` or `finish`.
    pub stage: &'static str,
    /// The manual's symbol, `Fz`; empty for choices.
    pub symbol: &'static str,
    /// What it means.
    pub meaning: String,
    /// What it stands with: `place`, `shape`, `planes`, `cutting` or `tool`.
    pub group: &'static str,
    /// What it measures: `length`, `angle`, `feed`, `speed`, `time`, `count`, `factor`, `tool`, `number`,
    /// `choice`, `name`.
    pub kind: &'static str,
    /// Sign of its unit.
    pub unit: &'static str,
    /// Least value; none for words.
    pub minimum: Option<f64>,
    /// Greatest value.
    pub maximum: Option<f64>,
    /// What a fresh form holds; none where it is empty.
    pub standard: Option<Fresh>,
    /// The words of a choice.
    pub choices: Vec<Choice>,
}

/// A figure of positions.
#[derive(Clone, PartialEq, Debug, Serialize)]
#[cfg_attr(feature = "typescript", derive(ts_rs::TS))]
pub struct FigureForm {
    /// `LINE`, `ARC`, `RECT`, `GRID` or `POINTS`.
    pub kind: &'static str,
    /// What it is called.
    pub title: String,
    /// Its fields; none where it is a list of points.
    pub parameters: Vec<FormField>,
    /// Points that it may list at most; 0 where it has none.
    pub points: usize,
}

/// What a cycle needs of a profile.
#[derive(Clone, Copy, PartialEq, Eq, Debug, Serialize)]
#[cfg_attr(feature = "typescript", derive(ts_rs::TS))]
#[serde(rename_all = "lowercase")]
pub enum ProfileUse {
    /// Nothing.
    None,
    /// Points joined by lines, up to 25, with corners (4.20).
    Points,
    /// One contour of lines and arcs, open or closed (4.21).
    Path,
    /// A closed contour and islands (4.15).
    Contours,
    /// The same, with profiles of depth (4.16).
    Depths,
}

/// A cycle as a form.
#[derive(Clone, PartialEq, Debug, Serialize)]
#[cfg_attr(feature = "typescript", derive(ts_rs::TS))]
pub struct Form {
    /// `G281` to `G299`, `P2D`, `P3D`.
    pub id: &'static str,
    /// Key of its group: `axis`, `pockets`, `bosses`, `milling` or `profiles`.
    pub group: &'static str,
    /// What the group is called.
    pub group_title: String,
    /// What it is called.
    pub title: String,
    /// Its stages in order.
    pub stages: Vec<Choice>,
    /// Its fields.
    pub parameters: Vec<FormField>,
    /// Figures that it may be repeated on.
    pub positions: Vec<FigureForm>,
    /// What it needs of a profile.
    pub profile: ProfileUse,
}

/// The group of a cycle (3.2).
fn group(id: &str) -> &'static str {
    match id {
        "G287" | "G288" | "G289" | "G296" => "pockets",
        "G291" | "G292" => "bosses",
        "G290" | "G295" => "milling",
        "G293" | "G294" | "P2D" | "P3D" => "profiles",
        _ => "axis",
    }
}

/// What a cycle needs of a profile.
pub fn profile_use(id: &str) -> ProfileUse {
    match id {
        "G293" => ProfileUse::Points,
        "G294" => ProfileUse::Path,
        "P2D" => ProfileUse::Contours,
        "P3D" => ProfileUse::Depths,
        _ => ProfileUse::None,
    }
}

/// The name of a part in a form.
pub fn stage(part: Part) -> &'static str {
    match part {
        Part::Main => "cycle",
        Part::Drill => "drill",
        Part::Rough => "rough",
        Part::Semi => "semi",
        Part::Finish => "finish",
    }
}

/// The key of a parameter's value.
pub fn value_name(part: Part, name: &str) -> String {
    match part {
        Part::Main => name.to_owned(),
        _ => format!("{}.{name}", stage(part)),
    }
}

/// The cycle of a name.
pub fn cycle(id: &str) -> Option<&'static DescribedCycle> {
    DIALECT.described_cycles.iter().find(|cycle| cycle.id == id)
}

/// A field, with the place at which a form shows it; none for the points of a profile or figure, which are no
/// field.
fn form_field(of: &str, part: Part, parameter: &Parameter, texts: &Texts) -> Option<(usize, FormField)> {
    let (place, field) = fields::field(of, parameter.name)?;
    if parameter.kind == Kind::Point {
        return None;
    }
    let choices: Vec<Choice> = match parameter.kind {
        Kind::Word(words) => {
            let choice = |word: &&'static str| {
                let own = texts.find(&format!("choice-{}-{word}", parameter.name));
                Choice { value: word, title: own.unwrap_or_else(|| texts.get(&format!("choice-{word}"))) }
            };
            words.iter().map(choice).collect()
        }
        _ => Vec::new(),
    };
    let is_number = !matches!(field.measure, Measure::Choice | Measure::Name);
    // A drilling in a pocket has the pocket's planes where it does not give its own (4.15).
    let inherits = part == Part::Drill && field.group == Group::Planes && parameter.name != "DP";
    let made = FormField {
        name: value_name(part, parameter.name),
        stage: stage(part),
        symbol: field.symbol,
        meaning: texts.get(&format!("field-{}", field.key)),
        group: field.group.name(),
        kind: field.measure.name(),
        unit: field.measure.unit(),
        minimum: is_number.then_some(field.range.0),
        maximum: is_number.then_some(field.range.1),
        standard: match field.standard {
            _ if inherits => None,
            // Who wants no drilling leaves its tool at 0.
            _ if part == Part::Drill && parameter.name == "T" => Some(Fresh::Number(0.0)),
            Standard::Empty => None,
            Standard::Number(value) => Some(Fresh::Number(value)),
            Standard::Word(word) => Some(Fresh::Word(word)),
        },
        choices,
    };
    Some((place, made))
}

/// Fields in the order in which a form shows them.
fn form_fields(of: &str, part: Part, parameters: &'static [Parameter], texts: &Texts) -> Vec<FormField> {
    let mut all: Vec<_> = parameters.iter().filter_map(|p| form_field(of, part, p, texts)).collect();
    all.sort_by_key(|(place, _)| *place);
    all.into_iter().map(|(_, field)| field).collect()
}

/// Every figure.
fn figures(texts: &Texts) -> Vec<FigureForm> {
    let figure = |figure: &ferrocut_interpreter::cycles::described::DescribedFigure| FigureForm {
        kind: figure.name,
        title: texts.get(&format!("figure-{}", figure.name)),
        parameters: form_fields(figure.name, Part::Main, figure.parameters, texts),
        points: figure.parameters.iter().filter(|p| p.kind == Kind::Point).count(),
    };
    DIALECT.described_figures.iter().map(figure).collect()
}

/// Every cycle as a form, in a language.
pub fn forms(language: Language) -> Vec<Form> {
    let texts = Texts::of(language);
    let form = |cycle: &'static DescribedCycle| {
        let group = group(cycle.id);
        Form {
            id: cycle.id,
            group,
            group_title: texts.get(&format!("group-{group}")),
            title: texts.get(&format!("cycle-{}", cycle.id)),
            stages: cycle
                .parts
                .iter()
                .map(|(part, _)| Choice {
                    value: stage(*part),
                    title: texts.get(&format!("stage-{}", stage(*part))),
                })
                .collect(),
            parameters: cycle
                .parts
                .iter()
                .flat_map(|(part, parameters)| form_fields(cycle.id, *part, parameters, texts))
                .collect(),
            positions: if cycle.repeats { figures(texts) } else { Vec::new() },
            profile: profile_use(cycle.id),
        }
    };
    let mut all: Vec<Form> = DIALECT.described_cycles.iter().map(form).collect();
    let order = ["axis", "pockets", "bosses", "milling", "profiles"];
    all.sort_by_key(|form| (order.iter().position(|group| *group == form.group), form.id));
    all
}
