//! The cycle editor over HTTP: forms, what they come to as text and as a path, drawings.
#![allow(missing_docs, clippy::unwrap_used, clippy::panic, clippy::indexing_slicing)]

mod common;

use common::{Answer, Place};
use serde_json::{Map, Value, json};

fn forms(place: &Place, language: &str) -> Vec<Value> {
    let answer = place.get(&format!("/api/cycles?language={language}"));
    assert_eq!(answer.status, 200, "{}", answer.text());
    answer.json().as_array().unwrap().clone()
}

/// A fresh form, as the panel shows it, for a tool of 8 mm.
fn fresh(place: &Place, cycle: &str) -> Value {
    let forms = forms(place, "en");
    let form = forms.iter().find(|form| form["id"] == json!(cycle)).unwrap();
    let fields = form["parameters"].as_array().unwrap().iter();
    let values: Map<String, Value> = fields
        .filter(|field| !field["standard"].is_null())
        .map(|field| (field["name"].as_str().unwrap().to_owned(), field["standard"].clone()))
        .collect();
    let tools: Vec<Value> = (1..=3)
        .map(|number| json!({ "number": number, "diameter": 8, "cutting_length": 20, "entry_angle": 0 }))
        .collect();
    json!({ "cycle": cycle, "values": values, "positions": [], "profile": null, "depths": [], "tools": tools })
}

fn post(place: &Place, path: &str, body: &Value) -> Answer {
    place.http("POST", path, &[("content-type", "application/json")], body.to_string().as_bytes())
}

/// What a form comes to: its text, and what is wrong.
fn written(place: &Place, query: &str, form: &Value) -> Value {
    let answer = post(place, &format!("/api/cycle{query}"), form);
    assert_eq!(answer.status, 200, "{}", answer.text());
    answer.json()
}

fn errors(written: &Value) -> Vec<&Value> {
    let findings = written["findings"].as_array().unwrap().iter();
    findings.filter(|finding| finding["severity"] == json!("error")).collect()
}

#[test]
fn every_cycle_is_a_form_in_every_language() {
    let place = Place::local();
    let english = forms(&place, "en");
    assert_eq!(english.len(), 21);
    for form in &english {
        let id = &form["id"];
        assert!(!form["parameters"].as_array().unwrap().is_empty(), "{id}");
        for field in form["parameters"].as_array().unwrap() {
            let is_choice = field["kind"] == json!("choice");
            assert_eq!(is_choice, !field["choices"].as_array().unwrap().is_empty(), "{id} {field}");
            assert!(!field["meaning"].as_str().unwrap().is_empty(), "{id} {field}");
        }
    }
    for language in ["zh", "ru", "es", "tr"] {
        for (form, english) in forms(&place, language).iter().zip(&english) {
            assert_eq!(form["id"], english["id"]);
            assert_ne!(form["title"], english["title"], "{language} {}", form["id"]);
        }
    }
    assert_eq!(place.get("/api/cycles?language=xx").status, 400);
}

#[test]
fn a_pocket_is_written_for_the_control_at_hand_and_passes_its_check() {
    let place = Place::local();
    let mut form = fresh(&place, "G287");
    form["values"]["L"] = json!(60);
    // The machine's own language has no such cycle: its blocks are moves.
    let own = written(&place, "", &form);
    assert_eq!((errors(&own).len(), &own["expanded"]), (0, &json!(true)), "{own}");
    let text = own["text"].as_str().unwrap();
    assert!(text.contains("G01") || text.contains("G1 "), "{text}");
    let program = format!("O0001\nG54 G90 M3 S1000\nG0 Z50.\n{text}\nM30\n");
    let check = place.http("POST", "/api/check", &[], program.as_bytes()).json();
    assert_eq!(check["findings"], json!([]), "{program}");
    // The control that it comes from is given the cycle itself.
    let fagor = written(&place, "?dialect=fagor8065", &form);
    assert_eq!(fagor["expanded"], json!(false));
    assert!(fagor["text"].as_str().unwrap().contains("#CYCLE"), "{fagor}");
    assert_ne!(fagor["text"], own["text"]);
    assert_eq!(post(&place, "/api/cycle?dialect=nothing", &form).status, 400);
}

#[test]
fn holes_are_the_cycle_of_the_control() {
    let place = Place::local();
    let mut form = fresh(&place, "G281");
    form["positions"] = json!([{ "kind": "POINTS", "values": {}, "points": [[30, 40]] }]);
    let own = written(&place, "", &form);
    assert!(errors(&own).is_empty(), "{own}");
    let text = own["text"].as_str().unwrap();
    assert_eq!(own["expanded"], json!(false));
    assert!(text.contains("G81") && text.contains("X30"), "{text}");
}

#[test]
fn a_fault_is_told_at_its_field_in_the_language_asked_for() {
    let place = Place::local();
    let mut form = fresh(&place, "G287");
    // A step wider than the tool leaves ridges.
    form["values"]["rough.step"] = json!(50);
    let english = written(&place, "?language=en", &form);
    let found = errors(&english);
    assert!(found.iter().any(|finding| finding["parameter"] == json!("rough.step")), "{english}");
    assert_eq!(english["text"], json!(""));
    let russian = written(&place, "?language=ru", &form);
    assert_eq!(errors(&russian).len(), found.len());
    form["values"]["rough.step"] = json!("wide");
    assert!(!errors(&written(&place, "", &form)).is_empty());
    let unknown = written(&place, "", &json!({ "cycle": "G999" }));
    assert_eq!(errors(&unknown)[0]["id"], json!("FC-1520"));
    for body in [json!({}), json!({ "cycle": "G287", "more": 1 }), json!([]), json!("G287")] {
        assert_eq!(post(&place, "/api/cycle", &body).status, 400, "{body}");
        assert_eq!(post(&place, "/api/cycle/path", &body).status, 400, "{body}");
    }
}

#[test]
fn the_way_of_a_pocket_stays_in_the_pocket_and_reaches_its_floor() {
    let place = Place::local();
    let mut form = fresh(&place, "G288");
    for (name, value) in [("XC", 100.0), ("YC", 50.0), ("R", 25.0), ("Z", 0.0), ("P", 6.0), ("ZS", 5.0)] {
        assert!(form["values"][name].is_number(), "{name}: {}", form["values"]);
        form["values"][name] = json!(value);
    }
    let answer = post(&place, "/api/cycle/path", &form);
    assert_eq!((answer.status, answer.head("content-type")), (200, Some("application/octet-stream")));
    let bytes = &answer.body;
    let word = |at: usize| u32::from_le_bytes(bytes[at..at + 4].try_into().unwrap());
    let n = word(4) as usize;
    assert_eq!((&bytes[..4], word(8), bytes.len()), (&b"FCP1"[..], 0, 64 + 21 * n));
    assert!(n > 100, "{n} points");
    let mut deepest = f32::MAX;
    for point in 0..n {
        let at = |axis: usize| f32::from_bits(word(64 + 12 * point + 4 * axis));
        deepest = deepest.min(at(2));
        // The edge of a tool of 8 mm touches the wall at 25 mm; 0.01 mm is the chords'.
        if bytes[64 + 20 * n + point] >= 2 {
            let away = (at(0) - 100.0).hypot(at(1) - 50.0);
            assert!(away < 21.011, "{away} mm from the centre at point {point}");
        }
    }
    assert!((deepest + 6.0).abs() < 1e-3, "{deepest}");
}

#[test]
fn contours_come_from_a_drawing_and_become_a_pocket() {
    let place = Place::local();
    let dxf = "0\nSECTION\n2\nENTITIES\n\
        0\nLINE\n8\n0\n10\n0\n20\n0\n11\n90\n21\n0\n0\nLINE\n8\n0\n10\n90\n20\n0\n11\n90\n21\n60\n\
        0\nLINE\n8\n0\n10\n90\n20\n60\n11\n0\n21\n60\n0\nLINE\n8\n0\n10\n0\n20\n60\n11\n0\n21\n0\n\
        0\nCIRCLE\n8\n0\n10\n45\n20\n30\n40\n10\n0\nENDSEC\n0\nEOF\n";
    let answer = place.http("POST", "/api/profile/dxf", &[], dxf.as_bytes());
    assert_eq!(answer.status, 200, "{}", answer.text());
    let drawing = answer.json();
    assert_eq!(drawing["findings"], json!([]));
    let contours = drawing["contours"].as_array().unwrap();
    assert_eq!(contours.iter().map(|one| one["closed"] == json!(true)).collect::<Vec<_>>(), [true, true]);
    let plain: Vec<Value> =
        contours.iter().map(|one| json!({ "start": one["start"], "elements": one["elements"] })).collect();
    let mut form = fresh(&place, "P2D");
    form["profile"] = json!({ "contours": plain });
    let own = written(&place, "", &form);
    assert!(errors(&own).is_empty() && !own["text"].as_str().unwrap().is_empty(), "{own}");
    let none = place.http("POST", "/api/profile/dxf", &[], b"no drawing").json();
    assert!(!none["findings"].as_array().unwrap().is_empty(), "{none}");
}
