//! A form as a `#CYCLE` block, with every fault of its values.

use crate::fields::{self, FURTHEST, Field, Measure};
use crate::finding::Wrong;
use crate::form::{self, ProfileUse};
use crate::request::{Contour, Corner, CornerKind, DepthPlane, Element, Positions, Request, Value};
use ferrocut_interpreter::cycles::described::{Kind, Parameter, Part};
use ferrocut_interpreter::dialects::fagor8065::DIALECT;
use ferrocut_machine::Fault;
use std::fmt::Write;

/// Elements that the profiles of a cycle may have together.
pub const MOST_ELEMENTS: usize = 20_000;

/// Longest name of a profile or pocket.
const LONGEST_NAME: usize = 32;

/// A number without idle zeros, to five decimals (10 nm): finer than any control.
pub fn short(value: f64) -> String {
    let text = format!("{value:.5}");
    match text.trim_end_matches('0').trim_end_matches('.') {
        "-0" => "0".to_owned(),
        text => text.to_owned(),
    }
}

/// The block with its profiles, and what is wrong with the values. Where something is, the block is what is left
/// without it.
pub fn block(request: &Request) -> (String, Vec<Wrong>) {
    let Some(cycle) = form::cycle(&request.cycle) else {
        let name = request.cycle.chars().take(LONGEST_NAME).collect::<String>();
        return (String::new(), vec![Wrong::new(Fault::CycleUnknown, "").with("name", name)]);
    };
    let mut writer = Writer { of: cycle.id, text: String::new(), wrong: Vec::new() };
    writer.unknown_values(request, cycle.parts);
    let profile = form::profile_use(cycle.id);
    writer.profiles(request, profile);
    for (part, parameters) in cycle.parts {
        let mut arguments = writer.arguments(request, *part, parameters);
        if *part == Part::Main && profile == ProfileUse::Points {
            arguments.extend(writer.points_of_profile(request, parameters));
        }
        // A stage of which nothing is given is not there; the cycle itself always is.
        if arguments.is_empty() && *part != Part::Main {
            continue;
        }
        let head = match part {
            Part::Main => format!("#CYCLE {}", cycle.id),
            Part::Drill => "#DRILL".to_owned(),
            Part::Rough => "#ROUGH".to_owned(),
            Part::Semi => "#SEMI".to_owned(),
            Part::Finish => "#FINISH".to_owned(),
        };
        writer.line(&head, &arguments);
    }
    match request.positions.as_slice() {
        [] => {}
        [positions] if cycle.repeats => writer.figure(positions),
        _ => writer.wrong.push(Wrong::new(Fault::CyclePositions, "positions")),
    }
    (writer.text, writer.wrong)
}

struct Writer {
    of: &'static str,
    text: String,
    wrong: Vec<Wrong>,
}

impl Writer {
    fn line(&mut self, head: &str, arguments: &[String]) {
        // Writing to a string cannot fail.
        let _ = match arguments {
            [] => writeln!(self.text, "{head}"),
            _ => writeln!(self.text, "{head} [{}]", arguments.join(", ")),
        };
    }

    fn unknown_values(&mut self, request: &Request, parts: &[(Part, &[Parameter])]) {
        let is_known = |name: &str| {
            parts.iter().any(|(part, parameters)| {
                let fits = |p: &&Parameter| p.kind != Kind::Point && form::value_name(*part, p.name) == name;
                parameters.iter().any(|p| fits(&p))
            })
        };
        for name in request.values.keys().filter(|name| !is_known(name)) {
            let shown: String = name.chars().take(LONGEST_NAME).collect();
            self.wrong.push(Wrong::new(Fault::UnknownParameter, shown));
        }
    }

    /// What is given of a part, `name=value` each.
    fn arguments(&mut self, request: &Request, part: Part, parameters: &[Parameter]) -> Vec<String> {
        let mut all: Vec<(usize, String)> = Vec::new();
        for parameter in parameters.iter().filter(|p| p.kind != Kind::Point) {
            let name = form::value_name(part, parameter.name);
            let Some(value) = request.values.get(&name) else { continue };
            let Some((place, field)) = fields::field(self.of, parameter.name) else { continue };
            match written(parameter, field, value) {
                Ok(text) => all.push((place, format!("{}={text}", parameter.name))),
                Err(fault) => self.wrong.push(refused(fault, name, field, value)),
            }
        }
        all.sort_by_key(|(place, _)| *place);
        all.into_iter().map(|(_, text)| text).collect()
    }

    fn figure(&mut self, positions: &Positions) {
        let found = DIALECT.described_figures.iter().find(|figure| figure.name == positions.kind);
        let Some(figure) = found else {
            return self.wrong.push(Wrong::new(Fault::CyclePositions, "positions"));
        };
        let mut arguments = Vec::new();
        let points: Vec<&Parameter> = figure.parameters.iter().filter(|p| p.kind == Kind::Point).collect();
        if positions.points.len() > points.len() {
            self.wrong.push(Wrong::new(Fault::CyclePositions, "positions"));
        }
        for (parameter, point) in points.iter().zip(&positions.points) {
            self.check_point(*point, "positions");
            arguments.push(format!("{}=[{}]", parameter.name, pair(*point)));
        }
        for (name, value) in &positions.values {
            let shown = || format!("positions.{}", name.chars().take(LONGEST_NAME).collect::<String>());
            let parameter = figure.parameters.iter().find(|p| p.name == name && p.kind != Kind::Point);
            let Some((parameter, (_, field))) = parameter.zip(fields::field(figure.name, name)) else {
                self.wrong.push(Wrong::new(Fault::UnknownParameter, shown()));
                continue;
            };
            match written(parameter, field, value) {
                Ok(text) => arguments.push(format!("{name}={text}")),
                Err(fault) => self.wrong.push(refused(fault, shown(), field, value)),
            }
        }
        self.line(&format!("#MULTI {}", figure.name), &arguments);
    }

    fn check_point(&mut self, point: [f64; 2], parameter: &str) {
        if !point.iter().all(|c| c.abs() <= FURTHEST) {
            self.wrong
                .push(Wrong::new(Fault::CycleValue, parameter).with("min", -FURTHEST).with("max", FURTHEST));
        }
    }

    /// P1 to P25 with their corners (4.20).
    fn points_of_profile(&mut self, request: &Request, parameters: &[Parameter]) -> Vec<String> {
        let Some([contour]) = request.profile.as_ref().map(|profile| profile.contours.as_slice()) else {
            return Vec::new();
        };
        let names: Vec<&str> = parameters.iter().filter(|p| p.kind == Kind::Point).map(|p| p.name).collect();
        let is_line = |element: &Element| matches!(element, Element::Line { .. });
        if contour.elements.len() + 1 > names.len() || !contour.elements.iter().all(is_line) {
            self.wrong.push(Wrong::new(Fault::CycleProfile, "profile"));
            return Vec::new();
        }
        let start = (contour.start, None);
        let points = std::iter::once(start).chain(contour.elements.iter().map(|e| (e.to(), e.corner())));
        names
            .into_iter()
            .zip(points)
            .map(|(name, (point, corner))| match corner {
                None => format!("{name}=[{}]", pair(point)),
                Some(corner) => {
                    format!("{name}=[{}, {}, {}]", pair(point), corner_name(corner), short(corner.size))
                }
            })
            .collect()
    }

    /// The profiles that a cycle needs, before it.
    fn profiles(&mut self, request: &Request, profile: ProfileUse) {
        let contours = request.profile.as_ref().map_or(&[][..], |profile| &profile.contours);
        let count: usize =
            contours.iter().chain(request.depths.iter().map(|d| &d.contour)).map(elements).sum();
        let fits = match profile {
            ProfileUse::None => contours.is_empty(),
            ProfileUse::Points | ProfileUse::Path => contours.len() == 1,
            ProfileUse::Contours | ProfileUse::Depths => !contours.is_empty(),
        };
        let depths_fit = request.depths.is_empty()
            || profile == ProfileUse::Depths && request.depths.len() <= contours.len().min(4);
        if !fits || count > MOST_ELEMENTS || !depths_fit {
            self.wrong.push(Wrong::new(Fault::CycleProfile, "profile"));
            return;
        }
        for contour in contours {
            self.check_contour(contour);
        }
        if matches!(profile, ProfileUse::None | ProfileUse::Points) {
            return;
        }
        let name = match request.values.get("profile") {
            Some(Value::Text(name)) if is_name(name) => name.clone(),
            // Told of its field below.
            _ => return,
        };
        self.profile(&name, "XY", contours);
        for (number, depth) in request.depths.iter().enumerate() {
            self.check_contour(&depth.contour);
            let plane = match depth.plane {
                DepthPlane::Xz => "XZ",
                DepthPlane::Yz => "YZ",
            };
            let key = format!("Z{}", number + 1);
            match request.values.get(&key) {
                Some(Value::Text(name)) if is_name(name) => {
                    let name = name.clone();
                    self.profile(&name, plane, std::slice::from_ref(&depth.contour));
                }
                _ => self.wrong.push(Wrong::new(Fault::CycleName, key)),
            }
        }
    }

    fn check_contour(&mut self, contour: &Contour) {
        self.check_point(contour.start, "profile");
        let sizes = [contour.entry, contour.exit].into_iter();
        let corners = contour.elements.iter().filter_map(|e| e.corner()).map(|c| c.size);
        if !sizes.chain(corners).all(|size| (0.0..=FURTHEST).contains(&size)) {
            self.wrong.push(Wrong::new(Fault::CycleProfile, "profile"));
        }
        for element in &contour.elements {
            self.check_point(element.to(), "profile");
            if let Element::Arc { center, .. } = element {
                self.check_point(*center, "profile");
            }
        }
    }

    fn profile(&mut self, name: &str, axes: &str, contours: &[Contour]) {
        let (letters, centre) = match axes {
            "XZ" => (['X', 'Z'], ['I', 'K']),
            "YZ" => (['Y', 'Z'], ['J', 'K']),
            _ => (['X', 'Y'], ['I', 'J']),
        };
        let point = |[a, b]: [f64; 2]| format!("{}{} {}{}", letters[0], short(a), letters[1], short(b));
        let text = &mut self.text;
        let _ = writeln!(text, "#PROFILE {name} [{axes}]");
        for contour in contours {
            let _ = writeln!(text, "G0 {}", point(contour.start));
            if contour.entry > 0.0 {
                let _ = writeln!(text, "G37 I{}", short(contour.entry));
            }
            let mut at = contour.start;
            for element in &contour.elements {
                let _ = match element {
                    Element::Line { to, .. } => writeln!(text, "G1 {}", point(*to)),
                    Element::Arc { to, center, clockwise, .. } => {
                        let code = if *clockwise { "G2" } else { "G3" };
                        let [i, j] = [center[0] - at[0], center[1] - at[1]].map(short);
                        writeln!(text, "{code} {} {}{i} {}{j}", point(*to), centre[0], centre[1])
                    }
                };
                if let Some(corner) = element.corner().filter(|corner| corner.size > 0.0) {
                    let code = if corner.kind == CornerKind::Round { "G36" } else { "G39" };
                    let _ = writeln!(text, "{code} I{}", short(corner.size));
                }
                at = element.to();
            }
            if contour.exit > 0.0 {
                let _ = writeln!(text, "G38 I{}", short(contour.exit));
            }
        }
        text.push_str("#ENDPROFILE\n");
    }
}

fn elements(contour: &Contour) -> usize {
    contour.elements.len()
}

fn pair([x, y]: [f64; 2]) -> String {
    format!("{}, {}", short(x), short(y))
}

fn corner_name(corner: Corner) -> &'static str {
    match corner.kind {
        CornerKind::Round => "round",
        CornerKind::Chamfer => "chamfer",
    }
}

/// A name that stands in a block as it is.
fn is_name(text: &str) -> bool {
    let starts = text.bytes().next().is_some_and(|b| b.is_ascii_alphabetic());
    starts && text.len() <= LONGEST_NAME && text.bytes().all(|b| b.is_ascii_alphanumeric() || b == b'_')
}

/// A value as it stands in a block.
fn written(parameter: &Parameter, field: &Field, value: &Value) -> Result<String, Fault> {
    match (parameter.kind, value) {
        (Kind::Length | Kind::Number | Kind::NextTool, Value::Number(number)) => {
            let (least, most) = field.range;
            // The interpreter tells of what is whole; a form does so with the range at hand.
            let is_whole = !field.measure.is_whole() || number.fract() == 0.0;
            match is_whole && (least..=most).contains(number) {
                true => Ok(short(*number)),
                false => Err(Fault::CycleValue),
            }
        }
        (Kind::Word(words), Value::Text(text)) => {
            words.iter().find(|word| *word == text).map(|word| (*word).to_owned()).ok_or(Fault::CycleChoice)
        }
        (Kind::Name, Value::Text(text)) if is_name(text) => Ok(text.clone()),
        (Kind::Name, _) => Err(Fault::CycleName),
        (Kind::Word(_), _) => Err(Fault::CycleChoice),
        _ => Err(Fault::CycleValue),
    }
}

fn refused(fault: Fault, name: String, field: &Field, value: &Value) -> Wrong {
    let wrong = Wrong::new(fault, name);
    let is_number = !matches!(field.measure, Measure::Choice | Measure::Name);
    match value {
        Value::Number(value) if is_number => {
            wrong.with("value", *value).with("min", field.range.0).with("max", field.range.1)
        }
        _ => wrong,
    }
}
