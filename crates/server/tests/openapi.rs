//! What `openapi.json` says of requests and answers, held against what the server takes and gives.
#![allow(missing_docs, clippy::unwrap_used, clippy::panic, clippy::indexing_slicing)]

mod common;

use common::{Answer, Place, control};
use ferrocut_memory::{Author, Level, Seat, Settings, Store};
use ferrocut_server::panel::Panel;
use serde_json::{Value, json};
use std::collections::BTreeSet;
use std::sync::Arc;

/// What of JSON Schema the description uses; a word beyond these would be judged by nobody.
const WORDS: [&str; 14] = [
    "$ref",
    "additionalProperties",
    "allOf",
    "description",
    "enum",
    "format",
    "items",
    "maxItems",
    "maximum",
    "minItems",
    "minimum",
    "properties",
    "required",
    "type",
];

/// The description, and what of it was tried.
struct Described {
    all: Value,
    tried: BTreeSet<(String, String)>,
}

fn is_a(value: &Value, name: &str) -> bool {
    match name {
        "object" => value.is_object(),
        "array" => value.is_array(),
        "string" => value.is_string(),
        "boolean" => value.is_boolean(),
        "null" => value.is_null(),
        "number" => value.is_number(),
        "integer" => value.as_f64().is_some_and(|number| number.fract() == 0.0),
        other => panic!("no type {other:?}"),
    }
}

impl Described {
    fn of(place: &Place) -> Described {
        Described { all: place.get("/api/openapi.json").json(), tried: BTreeSet::new() }
    }

    /// The schema itself, where it is named.
    fn schema<'a>(&'a self, schema: &'a Value) -> &'a Value {
        match schema["$ref"].as_str() {
            Some(name) => self.all.pointer(name.trim_start_matches('#')).unwrap_or_else(|| panic!("{name}")),
            None => schema,
        }
    }

    /// The names of the properties that a schema says, those of its parts among them.
    fn names<'a>(&'a self, schema: &'a Value, names: &mut BTreeSet<&'a str>) {
        let schema = self.schema(schema);
        names.extend(schema["properties"].as_object().into_iter().flatten().map(|(name, _)| name.as_str()));
        schema["allOf"].as_array().into_iter().flatten().for_each(|part| self.names(part, names));
    }

    /// Where a value is not as its schema says. `closed`: what is not described may not be there.
    fn faults(&self, schema: &Value, value: &Value, at: &str, closed: bool, faults: &mut Vec<String>) {
        let schema = self.schema(schema);
        let mut fault = |what: String| faults.push(format!("{at}: {what}"));
        for word in schema.as_object().unwrap().keys() {
            assert!(WORDS.contains(&word.as_str()), "{at}: {word} is not judged");
        }
        let types: Vec<&str> = match &schema["type"] {
            Value::String(name) => vec![name],
            Value::Array(names) => names.iter().map(|name| name.as_str().unwrap()).collect(),
            _ => Vec::new(),
        };
        if !types.is_empty() && !types.iter().any(|name| is_a(value, name)) {
            return fault(format!("{value} is no {types:?}"));
        }
        if schema["enum"].as_array().is_some_and(|values| !values.contains(value)) {
            fault(format!("{value} is none of {}", schema["enum"]));
        }
        let bound = |name: &str| schema[name].as_f64();
        if let Some(number) = value.as_f64()
            && (bound("minimum").is_some_and(|least| number < least)
                || bound("maximum").is_some_and(|most| number > most))
        {
            fault(format!("{number} is out of range"));
        }
        if let Some(list) = value.as_array() {
            let count = list.len() as f64;
            if bound("minItems").is_some_and(|least| count < least)
                || bound("maxItems").is_some_and(|most| count > most)
            {
                fault(format!("{count} items"));
            }
            if let Some(items) = schema.get("items") {
                for (n, item) in list.iter().enumerate() {
                    self.faults(items, item, &format!("{at}/{n}"), closed, faults);
                }
            }
        }
        let Some(object) = value.as_object() else { return };
        for name in schema["required"].as_array().into_iter().flatten() {
            if !object.contains_key(name.as_str().unwrap()) {
                faults.push(format!("{at}: {name} is missing"));
            }
        }
        let mut names = BTreeSet::new();
        self.names(schema, &mut names);
        for (name, value) in object {
            let at = format!("{at}/{name}");
            match (schema["properties"].get(name), schema.get("additionalProperties")) {
                (Some(property), _) => self.faults(property, value, &at, closed, faults),
                (None, Some(more)) => self.faults(more, value, &at, closed, faults),
                (None, None) if closed && !names.is_empty() && !names.contains(name.as_str()) => {
                    faults.push(format!("{at}: is not described"));
                }
                (None, None) => {}
            }
        }
        for part in schema["allOf"].as_array().into_iter().flatten() {
            // What one part does not say another does: `names` has all.
            self.faults(part, value, at, false, faults);
        }
    }

    fn judge(&self, schema: &Value, value: &Value, what: &str) {
        let mut faults = Vec::new();
        self.faults(schema, value, what, true, &mut faults);
        assert!(faults.is_empty(), "{faults:#?}");
    }

    /// The operation of a request: the path of the description that its path is one of.
    fn operation(&self, method: &str, path: &str) -> (String, Value) {
        let path = path.split('?').next().unwrap();
        let fits = |described: &str| match described.split_once("{name}") {
            Some((before, _)) => path.starts_with(before),
            None => path == described,
        };
        let paths = self.all["paths"].as_object().unwrap();
        let (name, methods) =
            paths.iter().find(|(described, _)| fits(described)).unwrap_or_else(|| panic!("{path}"));
        let operation = &methods[method.to_lowercase()];
        assert!(operation.is_object(), "{method} {path} is not described");
        (name.clone(), operation.clone())
    }

    /// A request whose answer must be as it is described; so must its body and the names of its query.
    fn ask(&mut self, place: &Place, method: &str, path: &str, body: &[u8], cookie: &str) -> Answer {
        let (name, operation) = self.operation(method, path);
        let what = format!("{method} {path}");
        let answer = place.http(method, path, &[("cookie", cookie)], body);
        let described = &operation["responses"][answer.status.to_string()];
        assert!(described.is_object(), "{what}: {} is not described: {}", answer.status, answer.text());
        if answer.status < 300 {
            let parameters = operation["parameters"].as_array().into_iter().flatten();
            let known: Vec<&str> = parameters.map(|one| one["name"].as_str().unwrap()).collect();
            for pair in
                path.split_once('?').map_or("", |(_, query)| query).split('&').filter(|pair| !pair.is_empty())
            {
                assert!(known.contains(&pair.split('=').next().unwrap()), "{what}: {pair}");
            }
            if let Some(schema) = operation.pointer("/requestBody/content/application~1json/schema") {
                self.judge(schema, &serde_json::from_slice(body).unwrap(), &format!("{what}: request"));
            }
            self.tried.insert((method.to_lowercase(), name));
        }
        let kind = answer.head("content-type").unwrap_or_default().split(';').next().unwrap().to_owned();
        if let Some(content) = described["content"].as_object() {
            let content = content.get(&kind).unwrap_or_else(|| panic!("{what}: {kind} is not described"));
            if kind == "application/json" {
                self.judge(&content["schema"], &answer.json(), &what);
            }
        }
        answer
    }
}

/// A machine with a memory in which a password of commissioning is set.
fn place(folder: &std::path::Path) -> Place {
    let store = Arc::new(Store::open(folder, Settings::new("gsk990mc")).unwrap());
    let author = Author::Maintenance { name: "test".into() };
    store.set_password(&author, Level::Commissioning, "commissioning crew", Seat::Machine).unwrap();
    Place::new(Panel::new(control(Some(store.clone()))), Some(store), "127.0.0.1:0", None)
}

#[test]
fn what_is_asked_and_answered_is_as_it_is_described() {
    let folder = tempfile::tempdir().unwrap();
    let place = place(folder.path());
    let mut described = Described::of(&place);
    let cookie = described.ask(&place, "GET", "/api/session", b"", "").cookie();
    let log_in = json!({ "level": 3, "password": "commissioning crew" }).to_string();
    let cookie = described.ask(&place, "POST", "/api/session", log_in.as_bytes(), &cookie).cookie();
    let mut socket = common::Socket::new(place.address(), &[("cookie", cookie.as_str())]).unwrap();
    socket.take_command();
    let faulty = b"G1 X10 F100\nG999\nM98 P77\nM30\n";
    let drawing = b"0\nSECTION\n2\nENTITIES\n0\nCIRCLE\n8\n0\n10\n5\n20\n5\n40\n3\n0\nENDSEC\n0\nEOF\n";
    for language in ["en", "zh", "ru", "es", "tr"] {
        let checked =
            described.ask(&place, "POST", &format!("/api/check?language={language}"), faulty, &cookie);
        assert!(!checked.json()["findings"].as_array().unwrap().is_empty());
        let forms =
            described.ask(&place, "GET", &format!("/api/cycles?language={language}"), b"", &cookie).json();
        assert_eq!(forms.as_array().unwrap().len(), 21);
        for path in [
            "/api/alarm?id=FC-1201&",
            "/api/explain?word=G81&",
            "/api/explain?word=P258&",
            "/api/explain?word=%23500&",
            "/api/explain?word=nothing&",
            "/api/words?",
            "/api/parameters?",
            "/api/signals?",
            "/api/search?q=g8&",
            "/api/list?kind=code&",
            "/api/list?kind=parameter&",
            "/api/list?kind=alarm&",
            "/api/list?kind=variable&",
            "/api/list?kind=address&",
            "/api/list?kind=signal&",
        ] {
            described.ask(&place, "GET", &format!("{path}language={language}"), b"", &cookie);
        }
    }
    let stored = described.ask(&place, "PUT", "/api/programs/O0001", b"G1 X10 F100\nM30\n", &cookie);
    assert_eq!(stored.status, 200, "{}", stored.text());
    for path in ["/api/programs/O0001", "/api/path?program=O0001", "/api/openapi.json", "/api/programs/O9"] {
        described.ask(&place, "GET", path, b"", &cookie);
    }
    described.ask(&place, "POST", "/api/path", b"G1 X10 F100\nM30\n", &cookie);
    // A cycle of values that stand, and the findings of one that has none.
    for values in [json!({}), json!({ "ZS": 0, "Z": 5, "Q": "no" })] {
        let form =
            json!({ "cycle": "drilling", "values": values, "positions": [], "profile": null, "depths": [] });
        described.ask(&place, "POST", "/api/cycle", form.to_string().as_bytes(), &cookie);
    }
    let forms = described.ask(&place, "GET", "/api/cycles", b"", &cookie).json();
    for form in forms.as_array().unwrap() {
        let fields =
            form["parameters"].as_array().unwrap().iter().filter(|field| !field["standard"].is_null());
        let values: serde_json::Map<String, Value> = fields
            .map(|field| (field["name"].as_str().unwrap().to_owned(), field["standard"].clone()))
            .collect();
        let tools = json!([{ "number": 1, "diameter": 8, "cutting_length": 20, "entry_angle": 0 }]);
        let request = json!({
            "cycle": form["id"], "values": values, "positions": [], "profile": null, "depths": [], "tools": tools
        });
        let request = request.to_string();
        for path in ["/api/cycle", "/api/cycle/path"] {
            described.ask(&place, "POST", path, request.as_bytes(), &cookie);
        }
    }
    let contours = described.ask(&place, "POST", "/api/profile/dxf", drawing, &cookie).json();
    assert_eq!(contours["contours"].as_array().unwrap().len(), 1);
    socket.ask(json!({ "do": "backup", "file": "first.backup", "items": [] }));
    described.ask(&place, "GET", "/api/backups", b"", &cookie);
    let backup = described.ask(&place, "GET", "/api/backups/first.backup", b"", &cookie);
    assert_eq!(backup.status, 200, "{}", backup.text());
    described.ask(&place, "PUT", "/api/backups/second.backup", &backup.body, &cookie);
    described.ask(&place, "GET", "/api/dnc", b"", &cookie);
    described.ask(&place, "PUT", "/api/dnc/part.nc", b"G90\nM30\n", &cookie);
    described.ask(&place, "GET", "/api/dnc", b"", &cookie);
    described.ask(&place, "DELETE", "/api/dnc", b"", &cookie);
    described.ask(&place, "DELETE", "/api/session", b"", &cookie);
    // Nothing is described that was not tried; the socket is no answer of HTTP.
    for (path, methods) in described.all["paths"].as_object().unwrap() {
        let methods = methods.as_object().unwrap().keys().filter(|name| *name != "parameters");
        for method in methods.filter(|_| path != "/api/socket") {
            let tried = described.tried.contains(&(method.clone(), path.clone()));
            assert!(tried, "{method} {path} was never answered as it should be");
        }
    }
}

/// The routes of the server's sources, as `get /api/words`.
fn routes() -> BTreeSet<String> {
    let mut routes = BTreeSet::new();
    for file in std::fs::read_dir(concat!(env!("CARGO_MANIFEST_DIR"), "/src/web")).unwrap() {
        let file = file.unwrap().path();
        if file.extension().is_none_or(|extension| extension != "rs") {
            continue;
        }
        let source = std::fs::read_to_string(file).unwrap();
        assert_eq!(source.matches(".route(").count(), source.matches(".route(\"").count(), "one line each");
        for route in source.split(".route(\"").skip(1) {
            let (path, rest) = route.split_once("\", ").unwrap();
            // To the end of the line: one route stands on one line.
            let methods = rest.lines().next().unwrap();
            let known = ["get", "put", "post", "delete", "patch", "head", "any"];
            let has = |method: &&str| {
                methods.starts_with(&format!("{method}(")) || methods.contains(&format!(".{method}("))
            };
            let found: Vec<&str> = known.into_iter().filter(|method| has(method)).collect();
            assert!(!found.is_empty(), "{path}: {methods}");
            routes.extend(found.into_iter().map(|method| format!("{method} {path}")));
        }
    }
    routes
}

#[test]
fn every_route_is_described() {
    let place = Place::local();
    let described = Described::of(&place);
    let mut told = BTreeSet::new();
    for (path, methods) in described.all["paths"].as_object().unwrap() {
        let methods = methods.as_object().unwrap().keys().filter(|name| *name != "parameters");
        told.extend(methods.map(|method| format!("{method} {path}")));
    }
    let routes = routes();
    assert!(routes.len() > 20, "{routes:?}");
    assert_eq!(routes, told);
}

/// Every field that a request is said to need is needed, and one that is said to be of a type is of no other.
#[test]
fn bodies_are_refused_that_are_not_as_they_are_described() {
    let place = Place::local();
    let described = Described::of(&place);
    let good = [
        ("/api/session", json!({ "level": 3, "password": "x" })),
        ("/api/cycle", json!({ "cycle": "G287", "values": {}, "positions": [], "tools": [] })),
        ("/api/cycle/path", json!({ "cycle": "G287", "values": {}, "positions": [], "tools": [] })),
    ];
    for (path, good) in good {
        let (_, operation) = described.operation("POST", path);
        let schema = operation.pointer("/requestBody/content/application~1json/schema").unwrap();
        let needed = described.schema(schema)["required"].as_array().unwrap().clone();
        assert!(!needed.is_empty());
        for name in needed {
            let name = name.as_str().unwrap();
            let mut without = good.clone();
            without.as_object_mut().unwrap().remove(name);
            let mut other = good.clone();
            other[name] = json!([true]);
            for body in [without, other] {
                let answer = place.http("POST", path, &[], body.to_string().as_bytes());
                assert_eq!(answer.status, 400, "{path} {body}: {}", answer.text());
                described.judge(
                    &operation["responses"]["400"]["content"]["application/json"]["schema"],
                    &answer.json(),
                    path,
                );
            }
        }
    }
}

#[test]
fn the_judge_sees_what_is_wrong() {
    let described = Described {
        all: json!({ "components": { "schemas": { "N": { "type": "integer", "maximum": 3 } } } }),
        tried: BTreeSet::new(),
    };
    let schema = json!({ "type": "object", "required": ["a"], "properties": {
        "a": { "$ref": "#/components/schemas/N" }, "b": { "type": ["string", "null"], "enum": ["x", null] },
        "c": { "type": "array", "minItems": 1, "items": { "type": "number" } } } });
    let count = |value: Value| {
        let mut faults = Vec::new();
        described.faults(&schema, &value, "", true, &mut faults);
        faults.len()
    };
    assert_eq!(count(json!({ "a": 3, "b": null, "c": [1.5] })), 0);
    for wrong in [
        json!([]),
        json!({}),
        json!({ "a": 4 }),
        json!({ "a": 1.5 }),
        json!({ "a": 1, "b": "y" }),
        json!({ "a": 1, "c": [] }),
        json!({ "a": 1, "c": ["z"] }),
        json!({ "a": 1, "d": 1 }),
    ] {
        assert_eq!(count(wrong.clone()), 1, "{wrong}");
    }
}
