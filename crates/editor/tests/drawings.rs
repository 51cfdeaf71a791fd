//! Contours from drawings, and the pocket made of them.
#![allow(clippy::unwrap_used, clippy::panic)]

use ferrocut_editor::request::{Element, Profile, ToolData, Value};
use ferrocut_editor::{Request, from_dxf, make};

/// A DXF of lines, arcs and circles.
fn dxf(entities: &[&str]) -> Vec<u8> {
    let mut text = String::from("0\nSECTION\n2\nENTITIES\n");
    for entity in entities {
        let words: Vec<&str> = entity.split(' ').collect();
        let codes: &[u8] = match words.first() {
            Some(&"LINE") => &[0, 10, 20, 11, 21],
            Some(&"ARC") => &[0, 10, 20, 40, 50, 51],
            _ => &[0, 10, 20, 40],
        };
        for (code, word) in codes.iter().zip(&words) {
            text.push_str(&format!("{code}\n{word}\n"));
        }
        text.push_str("8\n0\n");
    }
    text.push_str("0\nENDSEC\n0\nEOF\n");
    text.into_bytes()
}

/// 80 by 50 with one rounded corner of 10, drawn in no order; an island of radius 8; an open line.
fn plate() -> Vec<u8> {
    dxf(&[
        "CIRCLE 40 25 8",
        "LINE 80 50 0 50",
        "LINE 0 0 70 0",
        "ARC 70 10 10 270 360",
        "LINE 0 50 0 0",
        "LINE 80 10 80 50",
        "LINE 200 0 200 20",
    ])
}

#[test]
fn curves_are_joined_into_contours() {
    let from = from_dxf(&plate());
    assert!(from.wrong.is_empty(), "{:?}", from.wrong);
    assert_eq!(from.closed, [true, true, false]);
    let [plate, island, line] = from.contours.as_slice() else { panic!("{:?}", from.contours) };
    assert_eq!((plate.elements.len(), line.elements.len()), (5, 1));
    assert_eq!(plate.elements.last().unwrap().to(), plate.start);
    assert!(plate.elements.iter().any(|e| matches!(e, Element::Arc { center: [70.0, 10.0], .. })));
    assert!(matches!(island.elements.as_slice(), [Element::Arc { center: [40.0, 25.0], .. }]));
}

#[test]
fn a_drawn_pocket_with_an_island_is_cleared() {
    let mut from = from_dxf(&plate());
    from.contours.truncate(2);
    let number = |name: &str, value: f64| (name.to_owned(), Value::Number(value));
    let text = |name: &str, value: &str| (name.to_owned(), Value::Text(value.to_owned()));
    let values = [
        text("profile", "PLATE"),
        text("pocket", "PLATE"),
        number("ZS", 5.0),
        number("P", 6.0),
        number("rough.T", 1.0),
        number("rough.I", 3.0),
        number("rough.F", 400.0),
        number("rough.S", 2000.0),
        number("rough.beta", 5.0),
    ];
    let request = Request {
        cycle: "P2D".into(),
        values: values.into(),
        profile: Some(Profile { contours: from.contours }),
        tools: vec![ToolData { number: 1, diameter: Some(6.0), ..ToolData::default() }],
        ..Request::default()
    };
    let made = make(&request, None);
    assert!(made.is_possible(), "{:?}\n{}", made.wrong, made.block);
    let cuts: Vec<_> = made.steps.iter().filter(|step| step.op.is_cutting()).collect();
    assert!(cuts.len() > 20);
    for step in cuts {
        let to = step.op.target().unwrap();
        let [x, y, _] = ferrocut_editor::run::xyz(to);
        assert!(
            (3.0 - 1e-6..=77.0 + 1e-6).contains(&x) && (3.0 - 1e-6..=47.0 + 1e-6).contains(&y),
            "{x} {y}"
        );
        assert!((x - 40.0).hypot(y - 25.0) > 11.0 - 1e-6, "{x} {y}");
    }
}

#[test]
fn what_is_no_drawing_is_told() {
    for bytes in [&b""[..], b"no drawing", b"0\nSECTION\n2\nENTITIES\n0\nENDSEC\n0\nEOF\n"] {
        let from = from_dxf(bytes);
        assert!(from.contours.is_empty() && from.wrong.iter().any(|wrong| wrong.is_error()));
    }
}
