//! Forms hold what the interpreter's tables hold, and what a fresh form says can be made.
#![allow(clippy::unwrap_used, clippy::panic)]

use ferrocut_editor::fields::{FIELDS, field};
use ferrocut_editor::form::{ProfileUse, value_name};
use ferrocut_editor::request::ToolData;
use ferrocut_editor::request::{
    Contour, Corner, CornerKind, Depth, DepthPlane, Element, Positions, Profile, Value,
};
use ferrocut_editor::{Form, Request, forms, make, texts};
use ferrocut_interpreter::cycles::described::{Kind, Parameter, Part};
use ferrocut_interpreter::dialects::fagor8065::DIALECT;
use ferrocut_machine::Language;
use std::collections::BTreeSet;

/// Every parameter of cycles and figures, by what it is of.
fn parameters() -> Vec<(&'static str, Part, &'static Parameter)> {
    let cycles = DIALECT.described_cycles.iter().flat_map(|cycle| {
        cycle.parts.iter().flat_map(|(part, all)| all.iter().map(|p| (cycle.id, *part, p)))
    });
    let figures = DIALECT
        .described_figures
        .iter()
        .flat_map(|figure| figure.parameters.iter().map(|p| (figure.name, Part::Main, p)));
    cycles.chain(figures).collect()
}

#[test]
fn every_parameter_of_the_interpreter_has_a_field_and_every_field_a_parameter() {
    let mut used = BTreeSet::new();
    for (of, part, parameter) in parameters() {
        let (place, row) =
            field(of, parameter.name).unwrap_or_else(|| panic!("{of} {part:?} {}", parameter.name));
        used.insert(place);
        let measure = row.measure.name();
        let fits = match parameter.kind {
            Kind::Word(_) => measure == "choice",
            Kind::Name => measure == "name",
            Kind::Point => measure == "point",
            Kind::Length => matches!(measure, "length" | "feed"),
            Kind::NextTool => measure == "tool",
            Kind::Number => !matches!(measure, "length" | "choice" | "name" | "point"),
        };
        assert!(fits, "{of} {}: {measure}", parameter.name);
    }
    let idle: Vec<_> =
        FIELDS.iter().enumerate().filter(|(n, _)| !used.contains(n)).map(|(_, f)| (f.name, f.of)).collect();
    assert!(idle.is_empty(), "{idle:?}");
}

#[test]
fn a_form_has_the_fields_of_its_cycle_and_no_others() {
    for form in forms(Language::En) {
        let cycle = DIALECT.described_cycles.iter().find(|cycle| cycle.id == form.id).unwrap();
        let known: BTreeSet<String> = cycle
            .parts
            .iter()
            .flat_map(|(part, all)| {
                all.iter().filter(|p| p.kind != Kind::Point).map(|p| value_name(*part, p.name))
            })
            .collect();
        let shown: BTreeSet<String> = form.parameters.iter().map(|field| field.name.clone()).collect();
        assert_eq!(known, shown, "{}", form.id);
        assert_eq!(shown.len(), form.parameters.len(), "{}: a field stands twice", form.id);
        assert_eq!(form.positions.is_empty(), !cycle.repeats, "{}", form.id);
    }
    assert_eq!(forms(Language::En).len(), DIALECT.described_cycles.len());
}

#[test]
fn texts_are_complete_in_every_language() {
    let keys = |language: Language| -> BTreeSet<&'static str> {
        let lines = texts::source(language).lines().filter(|line| !line.starts_with('#'));
        lines.filter_map(|line| line.split_once(" = ").map(|(key, _)| key)).collect()
    };
    let english = keys(Language::En);
    for language in Language::ALL {
        assert_eq!(keys(language), english, "{language:?}");
        let catalogue = texts::Texts::of(language);
        for key in &english {
            assert!(catalogue.find(key).is_some_and(|text| !text.trim().is_empty()), "{language:?} {key}");
        }
        for form in forms(language) {
            let fields = form.parameters.iter().chain(form.positions.iter().flat_map(|p| &p.parameters));
            for field in fields {
                assert!(!field.meaning.starts_with("field-"), "{} {}", form.id, field.name);
                for choice in &field.choices {
                    assert!(
                        !choice.title.starts_with("choice-"),
                        "{} {} {}",
                        form.id,
                        field.name,
                        choice.value
                    );
                }
            }
        }
    }
}

#[test]
fn alarms_of_forms_have_a_text_in_every_language() {
    use ferrocut_machine::{AlarmId, Catalogue, Fault};
    let own = Fault::ALL.iter().filter(|fault| (1520..1540).contains(&(**fault as u16)));
    let english = Catalogue::new(Language::En);
    for fault in own {
        for language in Language::ALL {
            let (text, help) = (
                |c: Catalogue| c.text(AlarmId::Core(*fault)),
                |c: Catalogue| c.help_of(AlarmId::Core(*fault)),
            );
            let catalogue = Catalogue::new(language);
            assert!(text(catalogue).is_some() && help(catalogue).is_some(), "{fault:?} {language:?}");
            assert!(language == Language::En || text(catalogue) != text(english), "{fault:?} {language:?}");
        }
    }
}

fn square(size: f64, corner: Option<Corner>) -> Contour {
    let to = [[size, -size], [size, size], [-size, size], [-size, -size]];
    let elements = to.map(|to| Element::Line { to, corner }).to_vec();
    Contour { start: [-size, -size], elements, entry: 0.0, exit: 0.0 }
}

/// A fresh form, with the profile that its cycle needs and a mill of 8.
fn fresh(form: &Form) -> Request {
    let values = form.parameters.iter().filter_map(|field| {
        let value = serde_json::to_value(field.standard?).unwrap();
        Some((field.name.clone(), serde_json::from_value(value).unwrap()))
    });
    let round = Some(Corner { kind: CornerKind::Round, size: 8.0 });
    let mut request = Request { cycle: form.id.to_owned(), values: values.collect(), ..Request::default() };
    request.tools = vec![ToolData {
        number: 1,
        diameter: Some(8.0),
        cutting_length: Some(20.0),
        entry_angle: Some(5.0),
        tip_radius: Some(0.0),
    }];
    let mut path = square(40.0, None);
    match form.profile {
        ProfileUse::None => {}
        ProfileUse::Points | ProfileUse::Path => {
            path.elements.pop();
            request.profile = Some(Profile { contours: vec![path] });
        }
        ProfileUse::Contours | ProfileUse::Depths => {
            request.profile = Some(Profile { contours: vec![square(40.0, round)] });
        }
    }
    if form.profile == ProfileUse::Depths {
        request.values.insert("Z1".into(), Value::Text("SLOPE".into()));
        // The corner between end and start would move the start, where the depth profile begins.
        let to = [[-40.0, -40.0], [40.0, -40.0], [40.0, 40.0], [-40.0, 40.0]];
        let mut elements = to.map(|to| Element::Line { to, corner: round }).to_vec();
        elements.push(Element::Line { to: [-40.0, 0.0], corner: None });
        let outer = Contour { start: [-40.0, 0.0], elements, entry: 0.0, exit: 0.0 };
        request.profile = Some(Profile { contours: vec![outer] });
        // The words of an arc's centre are those of the plane that it is in.
        let arc = Element::Arc { to: [-33.0, -10.0], center: [-39.0, -10.0], clockwise: true, corner: None };
        let elements = vec![Element::Line { to: [-39.0, -4.0], corner: None }, arc];
        let contour = Contour { start: [-40.0, 0.0], elements, entry: 0.0, exit: 0.0 };
        request.depths = vec![Depth { plane: DepthPlane::Xz, contour }];
    }
    request
}

#[test]
fn a_fresh_form_can_be_made() {
    for form in forms(Language::En) {
        let made = make(&fresh(&form), None);
        assert!(made.wrong.is_empty(), "{}: {:?}\n{}", form.id, made.wrong, made.block);
        assert!(made.steps.len() > 3, "{}", form.id);
    }
}

/// Every field of every form is given a value by itself, at both ends of its range and each of its choices: the
/// interpreter knows it, whatever it has against the value.
#[test]
fn every_field_is_known_to_the_interpreter() {
    use ferrocut_machine::Fault;
    let unknown =
        [Fault::UnknownParameter, Fault::ParameterKind, Fault::UnknownDirective, Fault::DirectiveMisplaced];
    for form in forms(Language::En) {
        for field in &form.parameters {
            let mut values: Vec<Value> =
                field.choices.iter().map(|choice| Value::Text(choice.value.into())).collect();
            if field.minimum.is_some() {
                // Sizes that would be a million passes are left to the test of what cannot be made.
                values.push(Value::Number(field.maximum.unwrap().min(1.0)));
            } else if values.is_empty() {
                values.push(Value::Text("NAME_1".into()));
            }
            for value in values {
                let mut request = Request { cycle: form.id.to_owned(), ..Request::default() };
                request.values.insert(field.name.clone(), value.clone());
                let (block, _) = ferrocut_editor::block::block(&request);
                assert!(block.contains(field.name.rsplit('.').next().unwrap()), "{block}");
                let start = ferrocut_editor::run::start(0.0);
                let memory = ferrocut_machine::Memory::new("fagor8065");
                let ran = ferrocut_editor::run::run(&DIALECT, &format!("{block}M30\n"), memory, start, true);
                let wrong: Vec<_> =
                    ran.alarms.iter().filter(|alarm| unknown.contains(&alarm.fault)).collect();
                assert!(wrong.is_empty(), "{block}: {wrong:?}");
            }
        }
    }
}

#[test]
fn figures_repeat_a_cycle() {
    let all = forms(Language::En);
    let form = all.iter().find(|form| form.id == "G281").unwrap();
    let holes = |request: &Request| {
        let made = make(request, None);
        assert!(made.wrong.is_empty(), "{:?}\n{}", made.wrong, made.block);
        made.steps.iter().filter(|step| matches!(step.op, ferrocut_toolpath::Op::Feed { .. })).count()
    };
    assert_eq!(holes(&fresh(form)), 1);
    for (figure, count) in form.positions.iter().zip([3, 3, 6, 6, 3]) {
        let values = figure.parameters.iter().filter_map(|field| {
            let value = serde_json::to_value(field.standard?).unwrap();
            Some((field.name.clone(), serde_json::from_value(value).unwrap()))
        });
        let points = if figure.points > 0 { vec![[20.0, 0.0], [40.0, 10.0]] } else { Vec::new() };
        let positions = Positions { kind: figure.kind.to_owned(), values: values.collect(), points };
        let request = Request { positions: vec![positions], ..fresh(form) };
        assert_eq!(holes(&request), count, "{}", figure.kind);
    }
}

#[test]
fn faults_are_told_of_their_fields() {
    let all = forms(Language::En);
    let of = |id: &str, change: &dyn Fn(&mut Request)| {
        let mut request = fresh(all.iter().find(|form| form.id == id).unwrap());
        change(&mut request);
        let made = make(&request, None);
        let wrong: Vec<(String, String)> =
            made.wrong.iter().map(|wrong| (wrong.parameter.clone(), wrong.alarm.id.to_string())).collect();
        assert!(made.steps.is_empty() || made.is_possible());
        wrong
    };
    let set = |name: &'static str, value: Value| {
        move |request: &mut Request| {
            request.values.insert(name.to_owned(), value.clone());
        }
    };
    let one = |name: &str, id: &str| vec![(name.to_owned(), id.to_owned())];
    assert_eq!(of("G287", &set("L", Value::Number(1e9))), one("L", "FC-1521"));
    assert_eq!(of("G287", &set("rough.T", Value::Number(1.5))), one("rough.T", "FC-1521"));
    assert_eq!(of("G287", &set("corner", Value::Text("blunt".into()))), one("corner", "FC-1522"));
    assert_eq!(of("P2D", &set("pocket", Value::Text("../x".into()))), one("pocket", "FC-1523"));
    assert_eq!(of("G290", &|r| r.positions = vec![Positions::default()]), one("positions", "FC-1524"));
    assert_eq!(of("P2D", &|r| r.profile = None), one("profile", "FC-1525"));
    assert_eq!(of("G287", &|r| r.cycle = "G999".into()), one("", "FC-1520"));
    // The interpreter's own, of the stage that it names.
    let wide = of("G287", &set("rough.step", Value::Number(50.0)));
    assert_eq!(wide.first().map(|(name, _)| name.as_str()), Some("rough.step"), "{wide:?}");
    let line = Positions {
        kind: "LINE".into(),
        values: [("N".to_owned(), Value::Number(3.0))].into(),
        points: Vec::new(),
    };
    let figure = of("G281", &|r| r.positions = vec![line.clone()]);
    assert!(
        figure.iter().all(|(name, _)| name.starts_with("positions.")) && !figure.is_empty(),
        "{figure:?}"
    );
}
