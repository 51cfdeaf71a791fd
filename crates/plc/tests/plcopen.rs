//! Ladder diagrams of PLCopen XML.
#![allow(missing_docs, clippy::unwrap_used, clippy::panic)]

mod common;

use common::{bytes, put, run, set, shown};
use ferrocut_plc::{Limits, Pace, Plc, Program, list, plcopen};
use proptest::prelude::*;

/// A project of one program with the elements of a diagram.
fn project(elements: &str) -> String {
    format!(
        r#"<?xml version="1.0" encoding="utf-8"?>
<project xmlns="http://www.plcopen.org/xml/tc6_0201">
<types><dataTypes/><pous><pou name="MAIN" pouType="program">
<interface><localVars><variable name="START" address="%IX0.0"><type><BOOL/></type></variable>
<variable name="LATCH"><type><BOOL/></type></variable></localVars></interface>
<body><LD>
<leftPowerRail localId="1"><position x="0" y="0"/><connectionPointOut formalParameter=""/></leftPowerRail>
{elements}
</LD></body></pou></pous></types></project>"#
    )
}

fn wires(from: &[u32]) -> String {
    let connections: String = from.iter().map(|id| format!("<connection refLocalId=\"{id}\"/>")).collect();
    format!("<connectionPointIn>{connections}</connectionPointIn>")
}

fn element(kind: &str, attributes: &str, id: u32, y: u32, from: &[u32], signal: &str) -> String {
    let wires = wires(from);
    format!(
        "<{kind} localId=\"{id}\" {attributes}><position x=\"{id}\" y=\"{y}\"/>{wires}<connectionPointOut/><variable>{signal}</variable></{kind}>\n"
    )
}

fn contact(id: u32, y: u32, from: &[u32], signal: &str) -> String {
    element("contact", "", id, y, from, signal)
}

fn coil(id: u32, y: u32, from: &[u32], signal: &str) -> String {
    element("coil", "", id, y, from, signal)
}

fn block(id: u32, y: u32, name: &str, inputs: &[(&str, &str)]) -> String {
    let inputs: String = inputs
        .iter()
        .map(|(name, wires)| format!("<variable formalParameter=\"{name}\">{wires}</variable>"))
        .collect();
    format!(
        "<block localId=\"{id}\" typeName=\"{name}\"><position x=\"{id}\" y=\"{y}\"/><inputVariables>{inputs}</inputVariables><inOutVariables/>\
        <outputVariables><variable formalParameter=\"W1\"><connectionPointOut/></variable></outputVariables></block>\n"
    )
}

fn variable(id: u32, text: &str) -> String {
    format!(
        "<inVariable localId=\"{id}\"><position x=\"0\" y=\"0\"/><connectionPointOut/><expression>{text}</expression></inVariable>\n"
    )
}

fn text(elements: &str) -> String {
    let mut errors = Vec::new();
    let ladder = plcopen::read(project(elements).as_bytes(), &mut errors);
    assert!(errors.is_empty(), "{}", shown(&errors).join("\n"));
    list::to_text(&ladder)
}

fn faults(xml: &str) -> Vec<(u16, u32, Option<String>)> {
    match Program::from_plcopen(xml.as_bytes(), &Limits::default()) {
        Ok(_) => Vec::new(),
        Err(errors) => errors
            .iter()
            .map(|e| (e.fault.number(), e.span.line, e.about.as_deref().map(str::to_owned)))
            .collect(),
    }
}

fn plc(xml: &str) -> Plc {
    let program = Program::from_plcopen(xml.as_bytes(), &Limits::default());
    Plc::new(program.unwrap_or_else(|errors| panic!("{}", shown(&errors).join("\n"))), Pace::default())
}

#[test]
fn contacts_in_series_and_parallel_become_a_list() {
    // (START or Y0.0) and not X0.1 -> Y0.0, and straight to Y0.1 turned round.
    let diagram = contact(2, 0, &[1], "START")
        + &contact(3, 20, &[1], "Y0.0")
        + &element("contact", "negated=\"true\"", 4, 0, &[2, 3], "X0.1")
        + &coil(5, 0, &[4], "Y0.0")
        + &element("coil", "negated=\"true\"", 6, 10, &[4], "Y0.1");
    assert_eq!(
        text(&diagram),
        "END1\nRD X0000.0 ; START\nOR Y0000.0\nAND.NOT X0000.1\nWRT Y0000.0\n\
        RD X0000.0 ; START\nOR Y0000.0\nAND.NOT X0000.1\nWRT.NOT Y0000.1\nEND2\nEND\n"
    );
    // A and (B and C or D) and E: the branch of two is one of the stack.
    let diagram = contact(2, 0, &[1], "X0.0")
        + &contact(3, 0, &[2], "X0.1")
        + &contact(4, 0, &[3], "X0.2")
        + &contact(5, 20, &[2], "X0.3")
        + &contact(6, 0, &[4, 5], "X0.4")
        + &element("coil", "storage=\"set\"", 7, 0, &[6], "LATCH");
    assert_eq!(
        text(&diagram),
        "END1\nRD X0000.0 ; START\nRD.STK X0000.1\nAND X0000.2\nOR X0000.3\nAND.STK\nAND X0000.4\n\
        SET R5000.0 ; LATCH\nEND2\nEND\n"
    );
    let diagram = contact(2, 0, &[1], "X0.0")
        + &contact(3, 20, &[1], "X0.1")
        + &contact(4, 20, &[3], "X0.2")
        + &coil(5, 0, &[2, 4], "Y0.0")
        + &coil(6, 30, &[1], "Y0.1");
    assert_eq!(
        text(&diagram),
        "END1\nRD X0000.0 ; START\nRD.STK X0000.1\nAND X0000.2\nOR.STK\nWRT Y0000.0\nRD R9091.1\nWRT Y0000.1\nEND2\nEND\n"
    );
}

#[test]
fn what_is_imported_runs_as_it_is_drawn() {
    // Ten groups of two in series: as many ways as 1,024, and 20 contacts.
    let mut diagram = String::new();
    let (mut from, mut id) = (vec![1], 1);
    for n in 0..10 {
        id += 2;
        diagram += &contact(id, 0, &from, &format!("X{}.0", n));
        diagram += &contact(id + 1, 20, &from, &format!("X{}.1", n));
        from = vec![id, id + 1];
    }
    diagram += &coil(100, 0, &from, "Y0.0");
    let mut plc = plc(&project(&diagram));
    assert_eq!(plc.program().instructions().len(), 2 + 10 * 3 - 1 + 1 + 1);
    for n in 0..10u8 {
        put(&mut plc, &format!("X{n}"), &[1 + n % 2]);
    }
    run(&mut plc, 1);
    assert_eq!(bytes(&plc, "Y0", 1), [1]);
    put(&mut plc, "X7", &[0]);
    run(&mut plc, 1);
    assert_eq!(bytes(&plc, "Y0", 1), [0]);
}

#[test]
fn blocks_are_functions_with_conditions_by_name() {
    let diagram = contact(2, 0, &[1], "X0.0")
        + &contact(3, 10, &[1], "X0.1")
        + &variable(10, "2")
        + &variable(11, "D10")
        + &variable(12, "5")
        + &variable(13, "D12")
        + &block(
            4,
            0,
            "ADDB",
            &[
                ("ACT", &wires(&[2])),
                ("RST", &wires(&[3])),
                ("P1", &wires(&[10])),
                ("P2", &wires(&[11])),
                ("P3", &wires(&[12])),
                ("P4", &wires(&[13])),
            ],
        )
        + &contact(5, 0, &[4], "X0.2")
        + &coil(6, 0, &[5], "Y0.0");
    assert_eq!(
        text(&diagram),
        "END1\nRD X0000.1\nRD.STK X0000.0 ; START\nADDB 2 D0010 5 D0012\nWRT R5000.1\n\
        RD R5000.1\nAND X0000.2\nWRT Y0000.0\nEND2\nEND\n"
    );
    // TON, R_TRIG, SR and a contact with an edge.
    let diagram = contact(2, 0, &[1], "X0.0")
        + &variable(10, "T#20ms")
        + &block(4, 0, "TON", &[("IN", &wires(&[2])), ("PT", &wires(&[10]))])
        + &coil(6, 0, &[4], "Y0.0")
        + &block(7, 40, "R_TRIG", &[("CLK", &wires(&[2]))])
        + &coil(8, 40, &[7], "Y0.1")
        + &element("contact", "edge=\"falling\"", 9, 60, &[1], "X0.0")
        + &coil(11, 60, &[9], "Y0.2")
        + &block(12, 80, "SR", &[("S1", &wires(&[7])), ("R", &wires(&[9]))])
        + &coil(13, 80, &[12], "Y0.3");
    let mut plc = plc(&project(&diagram));
    set(&mut plc, "X0.0", true);
    run(&mut plc, 1);
    assert_eq!(bytes(&plc, "Y0", 1), [0b1010]);
    run(&mut plc, 20);
    assert_eq!(bytes(&plc, "Y0", 1), [0b1001]);
    set(&mut plc, "X0.0", false);
    run(&mut plc, 1);
    assert_eq!(bytes(&plc, "Y0", 1), [0b0100]);
}

fn output(id: u32, y: u32, from: &[u32], attributes: &str, text: &str) -> String {
    format!(
        "<outVariable localId=\"{id}\" {attributes}><position x=\"{id}\" y=\"{y}\"/>{}<expression>{text}</expression></outVariable>\n",
        wires(from)
    )
}

#[test]
fn timers_of_iec_run_as_iec_has_them() {
    let timer = |name: &str| {
        contact(2, 0, &[1], "X0.0")
            + &variable(10, "T#40ms")
            + &block(4, 0, name, &[("EN", &wires(&[1])), ("IN", &wires(&[2])), ("PT", &wires(&[10]))])
            + &coil(6, 0, &[4], "Y0.0")
    };
    /// The input on or off, for so many ms, and what the output is then.
    type Steps = &'static [(bool, u32, u8)];
    let runs: &[(&str, Steps)] = &[
        ("TON", &[(false, 100, 0), (true, 30, 0), (true, 20, 1), (false, 1, 0)]),
        (
            "TOF",
            &[
                (false, 1, 0),
                (false, 100, 0),
                (true, 1, 1),
                (false, 30, 1),
                (true, 1, 1),
                (false, 30, 1),
                (false, 20, 0),
                (true, 1, 1),
            ],
        ),
        (
            "TP",
            &[
                (false, 100, 0),
                (true, 1, 1),
                (false, 2, 1),
                (true, 20, 1),
                (true, 30, 0),
                (false, 1, 0),
                (true, 1, 1),
                (true, 60, 0),
            ],
        ),
    ];
    for (name, steps) in runs {
        let mut plc = plc(&project(&timer(name)));
        for (n, (on, scans, wanted)) in steps.iter().enumerate() {
            set(&mut plc, "X0.0", *on);
            run(&mut plc, *scans);
            assert_eq!(bytes(&plc, "Y0", 1), [*wanted], "{name} {n}");
        }
    }
}

#[test]
fn a_variable_that_power_is_led_to_is_a_coil() {
    let diagram = contact(2, 0, &[1], "X0.0")
        + &output(3, 0, &[2], "", "LATCH")
        + &output(4, 10, &[2], "negated=\"true\"", "%QX0.1");
    assert_eq!(
        text(&diagram),
        "END1\nRD X0000.0 ; START\nWRT R5000.0 ; LATCH\nRD X0000.0 ; START\nWRT.NOT Y0000.1\nEND2\nEND\n"
    );
}

#[test]
fn a_pou_sees_its_own_variables_and_those_of_all() {
    let pou = |name: &str, lists: &str, target: &str| {
        format!(
            "<pou name=\"{name}\" pouType=\"program\"><interface>{lists}</interface><body><LD><leftPowerRail localId=\"1\"/>{}</LD></body></pou>",
            coil(2, 0, &[1], "OWN") + &coil(3, 5, &[1], target)
        )
    };
    let list = |kind: &str, name: &str| format!("<{kind}><variable name=\"{name}\"/></{kind}>");
    let local = list("localVars", "OWN");
    let xml = |second: &str, target: &str| {
        format!(
            "<project><types><pous>{}{}</pous></types><globalVars><variable name=\"LAMP\" address=\"%QX0.3\"/><variable name=\"FLAG\"/></globalVars></project>",
            pou("A", &(local.clone() + &list("externalVars", "LAMP")), "LAMP"),
            pou("B", &(local.clone() + second), target),
        )
    };
    let mut errors = Vec::new();
    let ladder = plcopen::read(xml(&list("externalVars", "FLAG"), "FLAG").as_bytes(), &mut errors);
    assert!(errors.is_empty(), "{errors:?}");
    assert_eq!(
        list::to_text(&ladder),
        "END1\nRD R9091.1\nWRT R5000.1 ; OWN\nRD R9091.1\nWRT Y0000.3 ; LAMP\nRD R9091.1\nWRT R5000.2 ; B.OWN\n\
        RD R9091.1\nWRT R5000.0 ; FLAG\nEND2\nEND\n"
    );
    // One that nobody declares, and one of another POU.
    assert_eq!(faults(&xml(&list("externalVars", "NONE"), "FLAG"))[0], (1012, 3, Some("NONE".to_owned())));
    let of_a = xml("", "HIDDEN").replacen(
        "<variable name=\"OWN\"/>",
        "<variable name=\"OWN\"/><variable name=\"HIDDEN\"/>",
        1,
    );
    assert_eq!(faults(&of_a).last().unwrap().2.as_deref(), Some("HIDDEN"));
}

#[test]
fn relays_of_the_document_are_left_to_it() {
    // A coil in R5000, a word from R5001 on, a table of ten bytes from R5003 on.
    let diagram = coil(2, 0, &[1], "R5000.7")
        + &variable(10, "R5001")
        + &variable(11, "%MB5003")
        + &variable(12, "10")
        + &variable(13, "D0")
        + &block(4, 5, "MOVW", &[("ACT", &wires(&[1])), ("P1", &wires(&[10])), ("P2", &wires(&[13]))])
        + &block(
            5,
            6,
            "MOVN",
            &[("ACT", &wires(&[1])), ("P1", &wires(&[12])), ("P2", &wires(&[13])), ("P3", &wires(&[11]))],
        )
        + &coil(6, 10, &[1], "LATCH");
    let text = text(&diagram);
    assert!(text.contains("WRT R5013.0 ; LATCH"), "{text}");
}

#[test]
fn levels_subprograms_and_jumps_are_carried_over() {
    let pou = |name: &str, kind: &str, body: &str| {
        format!(
            "<pou name=\"{name}\" pouType=\"{kind}\"><body><LD><leftPowerRail localId=\"1\"/>{body}</LD></body></pou>"
        )
    };
    let jump =
        format!("<jump localId=\"20\" label=\"END\"><position x=\"0\" y=\"30\"/>{}</jump>", wires(&[2]));
    let main = contact(2, 0, &[1], "X0.0")
        + &block(3, 10, "P7", &[("EN", &wires(&[2]))])
        + &jump
        + &coil(4, 40, &[1], "Y0.1")
        + "<label localId=\"21\" label=\"END\"><position x=\"0\" y=\"50\"/></label>"
        + &coil(5, 60, &[1], "Y0.2");
    let xml = format!(
        "<project><types><pous>{}{}{}</pous></types></project>",
        pou("P7", "functionBlock", &coil(2, 0, &[1], "Y0.3")),
        pou("MAIN", "program", &main),
        pou("Level1", "program", &coil(2, 0, &[1], "Y0.0")),
    );
    let mut errors = Vec::new();
    assert_eq!(
        list::to_text(&plcopen::read(xml.as_bytes(), &mut errors)),
        "RD R9091.1\nWRT Y0000.0\nEND1\nRD X0000.0\nCALL 7\nRD X0000.0\nJMPB 1\nRD R9091.1\nWRT Y0000.1\nLBL 1\n\
        RD R9091.1\nWRT Y0000.2\nEND2\nSP 7\nRD R9091.1\nWRT Y0000.3\nSPE\nEND\n"
    );
    let mut plc = plc(&xml);
    set(&mut plc, "X0.0", true);
    run(&mut plc, 1);
    assert_eq!(bytes(&plc, "Y0", 1), [0b1101]);
}

#[test]
fn what_is_not_understood_is_told_with_its_line() {
    // Elements begin in line 8.
    let table: &[(String, u16, u32, Option<&str>)] = &[
        (contact(2, 0, &[1], "X0.0") + &coil(3, 0, &[], "Y0.0"), 1009, 9, None),
        (contact(2, 0, &[9], "X0.0") + &coil(3, 0, &[2], "Y0.0"), 1009, 8, Some("localId 9")),
        (coil(3, 0, &[1], ""), 1001, 8, None),
        (coil(3, 0, &[1], "MOTOR"), 1012, 8, Some("MOTOR")),
        (coil(3, 0, &[1], "X0.0"), 1006, 8, None),
        (contact(2, 0, &[1], "X0.0") + &coil(3, 0, &[1, 2], "Y0.0"), 1041, 9, None),
        (block(3, 0, "PID", &[("EN", &wires(&[1]))]), 1002, 8, Some("PID")),
        (block(3, 0, "END1", &[]), 1017, 8, Some("END1")),
        (block(3, 0, "DIFU", &[("P1", "")]), 1008, 8, Some("ACT")),
        (block(3, 0, "DIFU", &[("ACT", &wires(&[1]))]), 1020, 8, None),
        (block(3, 0, "TON", &[("IN", &wires(&[1]))]), 1011, 8, Some("PT")),
        ("<vendorElement localId=\"4\"/>".to_owned(), 1017, 8, Some("vendorElement")),
        (format!("<jump localId=\"4\" label=\"L\">{}</jump>", wires(&[1])), 1015, 8, Some("L")),
        // A ring of contacts, and one of blocks.
        (
            contact(2, 0, &[3], "X0.0") + &contact(3, 0, &[2], "X0.1") + &coil(4, 0, &[3], "Y0.0"),
            1017,
            9,
            Some("localId 2"),
        ),
        (
            block(2, 0, "R_TRIG", &[("CLK", &wires(&[3]))])
                + &block(3, 0, "R_TRIG", &[("CLK", &wires(&[2]))]),
            1017,
            8,
            None,
        ),
        // What would be another ladder: EN that is not always on, inputs that a block has not, data that is led out.
        (
            contact(2, 0, &[1], "X0.0")
                + &variable(10, "T#1s")
                + &block(3, 0, "TON", &[("EN", &wires(&[2])), ("IN", &wires(&[1])), ("PT", &wires(&[10]))]),
            1017,
            10,
            Some("EN"),
        ),
        (block(3, 0, "R_TRIG", &[("EN", &wires(&[1]))]), 1008, 8, Some("CLK")),
        (block(3, 0, "R_TRIG", &[("IN", &wires(&[1])), ("CLK", &wires(&[1]))]), 1017, 8, Some("IN")),
        (block(3, 0, "DIFU", &[("ACT", &wires(&[1])), ("RST", &wires(&[1]))]), 1017, 8, Some("RST")),
        (
            variable(10, "1")
                + &block(3, 0, "TMR", &[("ACT", &wires(&[1])), ("P1", &wires(&[10])), ("P3", &wires(&[10]))]),
            1017,
            9,
            Some("P3"),
        ),
        (block(3, 0, "SR", &[("S", &wires(&[1])), ("R", &wires(&[1]))]), 1017, 8, Some("S")),
        (contact(2, 0, &[1], "X0.0") + &output(3, 0, &[2], "", "D10"), 1017, 9, Some("D10")),
        (variable(2, "D5") + &output(3, 0, &[2], "", "D10"), 1017, 8, None),
        (
            contact(2, 0, &[1], "X0.0")
                + &block(3, 0, "R_TRIG", &[("CLK", &wires(&[2]))])
                + &coil(4, 0, &[3], "Y0.0")
                    .replace("refLocalId=\"3\"", "refLocalId=\"3\" formalParameter=\"ENO\""),
            1017,
            10,
            Some("ENO"),
        ),
        (
            block(3, 0, "R_TRIG", &[("CLK", &wires(&[1]))])
                .replace("formalParameter=\"W1\"", "formalParameter=\"Q\" negated=\"true\""),
            1017,
            8,
            Some("Q"),
        ),
        (coil(3, 0, &[1], "Y0.0") + &coil(3, 0, &[1], "Y0.1"), 1028, 9, Some("localId 3")),
        (coil(3, 0, &[1], "Y0.0") + &coil(4, 0, &[1], "Y0.0"), 1027, 9, Some("Y0000.0")),
    ];
    for (elements, number, line, about) in table {
        let found = faults(&project(elements));
        let wanted = (*number, *line, about.map(str::to_owned));
        assert!(found.contains(&wanted), "{wanted:?}: {found:?}\n{elements}");
    }
    for (xml, number, line) in [
        ("<project><types></project>", 1028, 1),
        ("<project>\n<a>\n</project>", 1028, 3),
        ("<html/>", 1028, 1),
        ("<project/>", 1028, 1),
        ("<project><pou name=\"A\" pouType=\"program\">\n<body><ST>x</ST></body></pou></project>", 1017, 2),
        ("<project>\n<pou name=\"A\" pouType=\"function\"/></project>", 1040, 2),
        ("<!DOCTYPE a [<!ENTITY b \"c\">]><project/>", 1028, 1),
    ] {
        assert!(faults(xml).iter().any(|f| (f.0, f.1) == (number, line)), "{xml}: {:?}", faults(xml));
    }
    assert!(!faults("\u{feff}<project").is_empty());
    assert!(plcopen::is_xml(b" \n<project/>") && !plcopen::is_xml(b"RD X0.0"));
}

#[test]
fn deep_files_do_no_harm() {
    let deep = "<a>".repeat(100_000);
    assert!(!faults(&format!("<project>{deep}")).is_empty());
    let closed = format!("<project>{deep}{}</project>", "</a>".repeat(100_000));
    assert!(!faults(&closed).is_empty());
    // 20,000 contacts in series.
    let long: String = (2..20_000u32).map(|id| contact(id, 0, &[id - 1], "X0.0")).collect();
    let found = faults(&project(&(long + &coil(500_000, 0, &[19_999], "Y0.0"))));
    assert_eq!(found[0].0, 1017);
}

fn name() -> impl Strategy<Value = String> {
    prop::sample::select(vec!["X0.0", "Y0.0", "START", "LATCH", "R1.1", "", "NONE", "F3.3", "D1"])
        .prop_map(str::to_owned)
}

fn any_element() -> impl Strategy<Value = String> {
    let ids = (1u32..12, prop::collection::vec(1u32..12, 0..3), 0u32..5);
    (
        ids,
        name(),
        0..9,
        prop::sample::select(vec![
            "DIFU", "TON", "TOF", "TP", "SR", "ADDB", "P1", "CTR", "MOVE", "PID", "JMP",
        ]),
    )
        .prop_map(|((id, from, y), signal, kind, function)| match kind {
            0 | 1 => contact(id, y, &from, &signal),
            2 => element("contact", "negated=\"true\" edge=\"rising\"", id, y, &from, &signal),
            3 => coil(id, y, &from, &signal),
            4 => element("coil", "storage=\"reset\" edge=\"falling\"", id, y, &from, &signal),
            5 => variable(id, &signal),
            6 => format!(
                "<jump localId=\"{id}\" label=\"A\">{}</jump><label localId=\"{}\" label=\"A\"/>",
                wires(&from),
                id + 30
            ),
            _ => {
                let wires = wires(&from);
                let inputs: &[(&str, &str)] = match function {
                    "SR" => &[("S1", &wires), ("R", &wires)],
                    "TON" | "TOF" | "TP" => &[("IN", &wires), ("PT", &wires)],
                    _ => &[("ACT", &wires), ("P1", &wires)],
                };
                block(id, y, function, inputs)
            }
        })
}

/// A file is a ladder that runs, with these inputs, or has faults that lie in it.
fn runs_or_is_told(xml: &[u8], x: u8) -> Result<(), TestCaseError> {
    match Program::from_plcopen(xml, &Limits::default()) {
        Ok(program) => {
            let mut plc = Plc::new(program, Pace::default());
            put(&mut plc, "X0", &[x]);
            (0..5).for_each(|_| {
                plc.scan();
            });
        }
        Err(errors) => {
            prop_assert!(!errors.is_empty());
            let lines = 1 + xml.iter().filter(|byte| **byte == b'\n').count();
            for error in errors {
                prop_assert!(error.span.line as usize <= lines, "{error:?}");
                prop_assert!(error.span.offset + error.span.len <= xml.len(), "{error:?}");
            }
        }
    }
    Ok(())
}

proptest! {
    #![proptest_config(ProptestConfig { cases: 500, ..ProptestConfig::default() })]

    #[test]
    fn any_diagram_is_a_ladder_or_faults(elements in prop::collection::vec(any_element(), 0..14), x in any::<u8>()) {
        runs_or_is_told(project(&elements.concat()).as_bytes(), x)?;
    }

    #[test]
    fn any_change_of_a_file_is_read_or_told(at in 0usize..1500, byte in any::<u8>(), cut in 0usize..40) {
        let mut xml = project(&(contact(2, 0, &[1], "X0.0") + &coil(3, 0, &[2], "Y0.0"))).into_bytes();
        let at = at.min(xml.len() - 1);
        xml[at] = byte;
        let end = (at + cut).min(xml.len());
        xml.drain(at..end);
        runs_or_is_told(&xml, 1)?;
    }

    #[test]
    fn what_is_imported_reads_back_the_same(elements in prop::collection::vec(any_element(), 1..10)) {
        let xml = project(&elements.concat());
        let mut errors = Vec::new();
        let ladder = plcopen::read(xml.as_bytes(), &mut errors);
        if Program::from_ladder(ladder.clone(), &Limits::default(), errors).is_ok() {
            let text = list::to_text(&ladder);
            let program = Program::from_text(text.as_bytes(), &Limits::default());
            let program = program.map_err(|e| TestCaseError::fail(format!("{e:?}\n{text}")))?;
            prop_assert_eq!(program.instructions().len(), ladder.instructions.len());
        }
    }
}

#[test]
fn a_contact_that_leads_nowhere_and_lines_in_a_ring_are_told() {
    let about = |diagram: String| -> Vec<(u16, Option<String>)> {
        faults(&project(&diagram)).into_iter().map(|(number, _, about)| (number, about)).collect()
    };
    let forgotten = contact(2, 0, &[1], "START") + &contact(3, 0, &[1], "X0.1") + &coil(5, 0, &[3], "Y0.0");
    assert_eq!(about(forgotten), [(1016, Some("START".into()))]);
    let ring = contact(2, 0, &[3], "START") + &contact(3, 0, &[2], "X0.1") + &coil(5, 0, &[3], "Y0.0");
    let [(1017, Some(id))] = &about(ring)[..] else { panic!() };
    assert!(["localId 2", "localId 3"].contains(&id.as_str()), "{id}");
}
