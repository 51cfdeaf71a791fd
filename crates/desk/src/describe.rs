//! What the tables say of a thing, put together on a page.

use crate::asked::Asked;
use crate::book::Book;
use crate::names::range;
use crate::page::{Page, in_unit, with_unit};
use ferrocut_interpreter::dialect::Variable;
use ferrocut_machine::{
    AlarmClass, AlarmId, Argument, Fault, GCodeRow, Meaning, ParameterKey, Subject, VariableRow, WorkOffset,
    alarm_table, g_code_name,
};

impl Book {
    /// The page of a thing; none for places, which are read elsewhere.
    pub fn page(&self, asked: &Asked) -> Option<Page> {
        Some(match asked {
            Asked::Subject(Subject::G(tenths)) => self.g_code(*tenths),
            Asked::Subject(Subject::M(code)) => self.m_code(*code),
            Asked::Subject(Subject::Parameter(key)) => self.parameter(key)?,
            Asked::Subject(Subject::Alarm(number)) => self.alarm(*number),
            Asked::Subject(Subject::Variable(number)) => self.variable(*number),
            Asked::Form(tenths, form) => {
                self.form(self.reference?.forms(*tenths).find(|r| *r.form == **form)?)
            }
            Asked::Fault(fault) => self.fault(*fault),
            Asked::Address(letter) => self.address(*letter),
            Asked::MacroWord(word) => self.macro_word(word)?,
            Asked::Place(..) => return None,
        })
    }

    /// A text of the tables in the language of the book.
    pub fn words<'a>(&self, english: &'a str) -> &'a str {
        self.catalogue.of_reference(english)
    }

    /// What an address letter stands for; empty where it is none.
    pub fn address_meaning(&self, letter: u8) -> &'static str {
        self.reference.and_then(|r| r.address(letter)).map_or("", |text| self.words(text))
    }

    fn label(&self, key: &str, arguments: &[(&str, Argument)]) -> String {
        self.catalogue.label(key, arguments)
    }

    fn g_code(&self, tenths: u16) -> Page {
        let row = self.reference.and_then(|r| r.g_code(tenths));
        let name = g_code_name(tenths);
        let meaning = row.map_or("", |r| self.words(&r.meaning));
        let mut page = Page::new("g-code", name, title(meaning));
        if let Some(row) = row {
            page.say("form", &*row.format);
            self.say_group(&mut page, row);
            if title(meaning).len() < meaning.len() {
                page.say("does", meaning);
            }
            page.say("section", &*row.section);
        } else if let Some(code) = self.dialect.g_code(tenths) {
            page.say("group", format!("{:02}", code.group_number));
        }
        if !self.carries_out(tenths) {
            page.tell("note", self.label("label-explain-not-done", &[]), "not carried out");
        }
        if let Some(reference) = self.reference {
            let form = |r: &GCodeRow| (r.format.to_string(), self.words(&r.meaning).to_owned());
            page.list("forms", reference.forms(tenths).map(form).collect());
        }
        self.add_related(&mut page, &Subject::G(tenths));
        page
    }

    fn say_group(&self, page: &mut Page, row: &GCodeRow) {
        let at_power_on = match self.dialect.g_code(row.tenths) {
            // What the parameters choose, rather than what the manual prints.
            Some(code) => {
                let modal = (self.dialect.power_on)(&self.memory.parameters);
                code.group_number > 0 && modal.codes().any(|c| c.tenths == row.tenths)
            }
            None => row.at_power_on,
        };
        let duration = self.label(
            match row.is_modal {
                Some(true) => "label-explain-modal",
                Some(false) => "label-explain-one-block",
                None => "label-explain-modal-depends",
            },
            &[],
        );
        let mut text = format!("{}, {duration}", row.group);
        if at_power_on {
            text += &format!(", {}", self.label("label-explain-at-power-on", &[]));
        }
        page.tell("group", text, &*row.group);
        page.note("modal", row.is_modal);
        page.note("power_on", at_power_on);
        let Some(reference) = self.reference.filter(|_| row.group_number() != Some(0)) else { return };
        let others = reference.g_codes().iter().filter(|r| r.form.is_empty() && r.group == row.group);
        let others: Vec<String> = others.filter(|r| r.tenths != row.tenths).map(GCodeRow::name).collect();
        page.tell("replaces", others.join(" "), others.clone());
    }

    fn form(&self, row: &GCodeRow) -> Page {
        let meaning = self.words(&row.meaning);
        let mut page = Page::new("g-code", row.name(), title(meaning));
        page.say("form", &*row.format);
        if title(meaning).len() < meaning.len() {
            page.say("does", meaning);
        }
        page.say("section", &*row.section);
        if !self.carries_out(row.tenths) {
            page.tell("note", self.label("label-explain-not-done", &[]), "not carried out");
        }
        self.add_related(&mut page, &Subject::G(row.tenths));
        page
    }

    /// Whether this version runs the code.
    fn carries_out(&self, tenths: u16) -> bool {
        let described = || self.dialect.described_cycles.iter().any(|cycle| cycle.id == g_code_name(tenths));
        self.dialect.g_code(tenths).is_some() || tenths == self.dialect.macro_call || described()
    }

    fn m_code(&self, code: u16) -> Page {
        let row = self.reference.and_then(|r| r.m_code(code));
        let meaning = row.map_or("", |r| self.words(&r.meaning));
        let name = format!("M{code:02}");
        let mut page = match meaning {
            "" => Page::new("m-code", name, self.label("label-explain-no-meaning", &[])),
            _ => Page::new("m-code", name, title(meaning)),
        };
        if title(meaning).len() < meaning.len() {
            page.say("does", meaning);
        }
        let own = self.dialect.m_code(code);
        if let Some(after) = row.map(|r| r.after_motion).or(own.map(|m| m.after_motion)) {
            let (key, json) = match after {
                true => ("label-explain-after-motion", "after"),
                false => ("label-explain-with-motion", "with"),
            };
            page.tell("timing", self.label(key, &[]), json);
        }
        if let Some(row) = row {
            page.tell("class", self.label(&format!("label-explain-{}", row.class), &[]), &*row.class);
        }
        if own.is_some_and(|m| m.controls_program) {
            page.tell("alone", self.label("label-explain-own-block", &[]), true);
        }
        page.say("section", row.map_or("", |r| &*r.section));
        self.add_related(&mut page, &Subject::M(code));
        page
    }

    /// The page of a parameter; none where the control has no such.
    pub fn parameter(&self, key: &ParameterKey) -> Option<Page> {
        let value = self.memory.parameter(key);
        let definition = self.table().get(key)?;
        let mut page = Page::new("parameter", &*definition.name, &*definition.symbol);
        match &definition.meaning {
            Meaning::Value(text) => page.say("meaning", self.words(text)),
            Meaning::Bit { one, zero } => {
                page.say("one", self.words(one));
                page.say("zero", self.words(zero));
            }
        }
        page.tell("value", with_unit(value, definition), value);
        page.tell("default", with_unit(definition.default, definition), definition.default);
        page.note("changed", value != definition.default);
        let bounds = match (definition.min, definition.max) {
            _ if matches!(key, ParameterKey::Bit { .. }) => self.label("label-explain-bit", &[]),
            (min, max) => match range(min, max) {
                Some(range) => in_unit(&range, definition),
                None => self.label("label-explain-no-range", &[]),
            },
        };
        page.tell("range", bounds, serde_json::json!([definition.min, definition.max]));
        page.note("unit", &*definition.unit);
        page.say("axis", &*definition.axis);
        let room = &*definition.applies_to;
        let mut part = self.label(&format!("label-room-{room}"), &[]);
        if !definition.used {
            part = self.label("label-explain-other-room", &[("room", part.into())]);
        }
        page.tell("room", part, room);
        self.add_related(&mut page, &Subject::Parameter(key.clone()));
        Some(page)
    }

    fn alarm(&self, number: u16) -> Page {
        let catalogue = self.catalogue;
        let id = AlarmId::Dialect(self.dialect.name, number);
        let mut page = Page::new("alarm", id.to_string(), catalogue.text(id).unwrap_or_default());
        page.say("help", catalogue.help_of(id).unwrap_or_default());
        if let Some(row) = alarm_table(self.dialect.name).iter().find(|row| row.id == id) {
            let class = class_name(row.class);
            page.tell("source", self.label(&format!("label-class-{class}"), &[]), class);
        }
        let raises = self.dialect.alarms.iter().filter(|(_, n)| *n == number);
        let raises = raises.map(|(fault, _)| core_alarm(self, *fault)).collect();
        page.list("raised_by", raises);
        self.add_related(&mut page, &Subject::Alarm(number));
        page
    }

    fn fault(&self, fault: Fault) -> Page {
        let catalogue = self.catalogue;
        let id = AlarmId::Core(fault);
        let mut page = Page::new("alarm", id.to_string(), catalogue.text(id).unwrap_or_default());
        page.say("help", catalogue.help_of(id).unwrap_or_default());
        match self.dialect.alarm_number(fault) {
            None => page.tell("shown_as", id.to_string(), id.to_string()),
            Some(number) => {
                let id = AlarmId::Dialect(self.dialect.name, number);
                page.tell("shown_as", id.to_string(), id.to_string());
                self.add_related(&mut page, &Subject::Alarm(number));
            }
        }
        page
    }

    fn variable(&self, number: u32) -> Page {
        let rows = self.reference.map(|r| r.variable(number)).unwrap_or_default();
        let mut rows = rows.into_iter();
        let row = rows.next();
        let name = self.dialect.syntax.variable_name(number);
        let mut page = Page::new("variable", name, row.map_or("", |r| self.words(&r.meaning)));
        if let Some(row) = row {
            page.say("numbers", self.range_of_variables(row));
            let access = match &*row.access {
                "read" => "label-explain-read",
                "write" => "label-explain-write",
                "read/write" => "label-explain-read-write",
                _ => "label-explain-access-unknown",
            };
            page.tell("access", self.label(access, &[]), &*row.access);
        }
        let stands_for = (self.dialect.variable)(number);
        match stands_for {
            None => page.tell("note", self.label("label-explain-no-variable", &[]), "not carried out"),
            Some(variable) => page.say("this_one", self.variable_meaning(variable)),
        }
        page.say("notes", row.map_or("", |r| self.words(&r.notes)));
        let line = |r: &VariableRow| (self.range_of_variables(r), self.words(&r.meaning).to_owned());
        page.list("part_of", rows.map(line).collect());
        self.add_related(&mut page, &Subject::Variable(number));
        page
    }

    /// `#100-#199`, or `P0-P99` where variables have names without a sign.
    fn range_of_variables(&self, row: &VariableRow) -> String {
        let syntax = self.dialect.syntax;
        match syntax.parameter_letter {
            None => row.name(),
            Some(_) => {
                let [first, last] =
                    [row.numbers.start(), row.numbers.end()].map(|number| syntax.variable_name(*number));
                format!("{first}-{last}")
            }
        }
    }

    /// Which axis, offset or system one variable of a range is of.
    fn variable_meaning(&self, variable: Variable) -> String {
        let order = (self.dialect.rules)(&self.memory.parameters).axis_order;
        let axis =
            |index: u8| order.get(usize::from(index)).map_or(String::new(), |a| a.letter().to_string());
        match variable {
            Variable::ToolLength(n) | Variable::LengthWear(n) => format!("H{n}"),
            Variable::ToolRadius(n) | Variable::RadiusWear(n) => format!("D{n}"),
            Variable::BlockEnd(index)
            | Variable::MachinePosition(index)
            | Variable::WorkPosition(index)
            | Variable::TipPosition(index)
            | Variable::SkipPosition(index)
            | Variable::LengthOffset(index)
            | Variable::ServoOffset(index) => axis(index),
            Variable::WorkZero(system, index) => {
                let system = match system {
                    WorkOffset::External => self.label("label-explain-external", &[]),
                    other => other.to_string(),
                };
                format!("{system} {}", axis(index))
            }
            _ => String::new(),
        }
    }

    fn address(&self, letter: u8) -> Page {
        let meaning = self.address_meaning(letter);
        let mut page = Page::new("address", char::from(letter).to_string(), title(meaning));
        if title(meaning).len() < meaning.len() {
            page.say("does", meaning);
        }
        self.say_range(&mut page, letter);
        page
    }

    /// What an address may hold.
    pub fn say_range(&self, page: &mut Page, letter: u8) {
        if let Some(address) = self.dialect.address(letter) {
            let mut text = format!("{} … {}", address.min, address.max);
            if address.whole {
                text += &format!(", {}", self.label("label-explain-whole", &[]));
            }
            page.tell("range", text, serde_json::json!([address.min, address.max]));
            page.note("whole", address.whole);
        }
    }

    fn macro_word(&self, word: &str) -> Option<Page> {
        let row = self.reference?.macro_word(word)?;
        let mut page = Page::new("macro", &*row.word, self.words(&row.meaning));
        page.say("form", &*row.format);
        Some(page)
    }

    /// Parameters, codes and alarms that have to do with a thing.
    fn add_related(&self, page: &mut Page, subject: &Subject) {
        let Some(reference) = self.reference else { return };
        let parameters = reference.parameters_of(subject).into_iter();
        page.parameters = parameters.map(|d| (d, self.memory.parameter(&d.key))).collect();
        let codes = reference.codes_of(subject).into_iter();
        page.list("codes", codes.filter_map(|code| self.code_line(&code)).collect());
        if !matches!(subject, Subject::Alarm(_)) {
            let catalogue = self.catalogue;
            let line = |id: AlarmId| (id.to_string(), catalogue.text(id).unwrap_or_default());
            page.list("alarms", reference.alarms_of(subject).into_iter().map(line).collect());
        }
    }

    /// Name and title of a G code, or of a form of one.
    pub(crate) fn row_line(&self, row: &GCodeRow) -> (String, String) {
        (row.name(), title(self.words(&row.meaning)).to_owned())
    }

    /// Name and title of a code.
    pub fn code_line(&self, code: &Subject) -> Option<(String, String)> {
        let reference = self.reference?;
        match code {
            Subject::G(tenths) => reference.g_code(*tenths).map(|row| self.row_line(row)),
            Subject::M(code) => {
                let row = reference.m_code(*code)?;
                Some((format!("M{:02}", row.code), title(self.words(&row.meaning)).to_owned()))
            }
            _ => None,
        }
    }
}

fn core_alarm(book: &Book, fault: Fault) -> (String, String) {
    let id = AlarmId::Core(fault);
    (id.to_string(), book.catalogue.text(id).unwrap_or_default())
}

/// What a thing is: its meaning up to the first semicolon.
fn title(meaning: &str) -> &str {
    meaning.split(';').next().unwrap_or_default().trim()
}

fn class_name(class: AlarmClass) -> &'static str {
    match class {
        AlarmClass::Program => "program",
        AlarmClass::Macro => "macro",
        AlarmClass::Operation => "operation",
        AlarmClass::Homing => "homing",
        AlarmClass::Storage => "storage",
        AlarmClass::Servo => "servo",
        AlarmClass::Spindle => "spindle",
        AlarmClass::Overtravel => "overtravel",
        AlarmClass::Plc => "plc",
        AlarmClass::System => "system",
    }
}
