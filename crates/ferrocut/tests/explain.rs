//! `explain`: what a code, parameter, alarm, variable or word is, from the tables of the control.
#![allow(missing_docs, clippy::unwrap_used, clippy::panic)]

mod common;

use common::{Answer, ferrocut, json, json_lines, with_input, write};
use ferrocut_interpreter::dialect::MFunction;
use ferrocut_interpreter::{Dialect, dialects};
use ferrocut_machine::{ParameterTable, Reference, Subject, alarm_table, g_code_name};
use ferrocut_program::{Binary, Keyword};

fn explain(what: &[&str]) -> Answer {
    ferrocut(&[&["explain"], what].concat())
}

/// The one page about something, which exists.
fn page(what: &str) -> String {
    let answer = explain(&[what]);
    assert_eq!((answer.code, answer.err.as_str()), (0, ""), "{what}");
    answer.out
}

/// The lines of a page without the blanks that align them.
fn lines(page: &str) -> Vec<String> {
    page.lines().map(|l| l.split_whitespace().collect::<Vec<_>>().join(" ")).collect()
}

fn assert_lines(what: &str, expected: &[&str]) {
    let found = lines(&page(what));
    for line in expected {
        assert!(found.iter().any(|l| l == line), "{what}: {line:?} is missing in {found:#?}");
    }
}

#[test]
fn the_manuals_tables_and_the_interpreters_agree() {
    for dialect in dialects::ALL {
        if let Some(reference) = Reference::of(dialect.name) {
            tables_agree(dialect, reference);
        }
    }
}

fn tables_agree(dialect: &Dialect, reference: &Reference) {
    for code in dialect.g_codes {
        let name = g_code_name(code.tenths);
        let row = reference.g_code(code.tenths).unwrap_or_else(|| panic!("{name} is not in the manual"));
        assert_eq!(row.group_number(), Some(code.group_number), "{name}");
    }
    for code in dialect.m_codes {
        let row =
            reference.m_code(code.code).unwrap_or_else(|| panic!("M{} is not in the manual", code.code));
        assert_eq!(row.after_motion, code.after_motion, "M{}", code.code);
        // What the control does itself is never handed to the ladder.
        let is_own = matches!(code.function, MFunction::SetOutput | MFunction::Internal);
        assert!(!is_own || &*row.class == "internal", "{} M{}", dialect.name, code.code);
    }
    assert!(reference.m_codes().iter().all(|row| dialect.m_code(row.code).is_some()));
    // What the manual says is in force at power-on, the parameters as delivered put in force; but G13,
    // which the default of 31#5 chooses although the table marks G12.
    let gsk = dialect.name == "gsk990mc";
    let table = ParameterTable::of(dialect.name).unwrap_or_else(ParameterTable::empty);
    let modal = (dialect.power_on)(&ferrocut_machine::Parameters::new(table));
    // A group in which a language has no code is filled all the same.
    let own = |tenths| dialect.g_code(tenths).is_some();
    for code in
        modal.codes().filter(|c| own(c.tenths)).filter(|c| !gsk || !matches!(c.tenths, 120 | 130 | 540 | 210))
    {
        let row = reference.g_code(code.tenths).unwrap();
        assert!(row.at_power_on, "{}", row.name());
    }
    // Operations of macro A.
    if reference.forms(650).next().is_some() {
        for operation in 0..=99 {
            let is_listed = reference.forms(650).any(|row| row.is_form(&format!("H{operation}")));
            assert_eq!(
                is_listed,
                dialect.arithmetic.has_operation(operation),
                "{} H{operation}",
                dialect.name
            );
        }
    }
    for address in dialect.addresses {
        assert!(reference.address(address.letter).is_some(), "{}", char::from(address.letter));
    }
    let syntax = dialect.syntax;
    let keywords = syntax.keywords.iter().map(|(word, _): &(&str, Keyword)| *word);
    let operators = syntax.operators.iter().map(|(word, ..): &(&str, Binary, u8)| *word);
    for word in keywords.chain(operators).filter(|w| w.starts_with(|c: char| c.is_ascii_alphabetic())) {
        assert!(reference.macro_word(word).is_some(), "{word}");
    }
    for row in reference.variables() {
        for number in row.numbers.clone() {
            // The fifth variable of each step of five is not described by the manual.
            let undescribed = gsk && matches!(number, 5001..=5235 | 7001..=7250) && number % 5 == 0;
            assert_eq!((dialect.variable)(number).is_some(), !undescribed, "#{number} of {}", row.name());
        }
    }
}

#[test]
fn a_g_code_is_explained_with_its_group_form_parameters_and_alarms() {
    assert_lines(
        "g73",
        &[
            "G73 High-speed peck drilling, retract d = P270",
            "form G73 X_ Y_ Z_ R_ Q_ F_ K_",
            "group 09, modal",
            "manual 4.4.1",
            "P270 2 mm Retract distance d of G73",
            "gsk990mc:0045 G73 or G83 without a depth of cut Q",
        ],
    );
    assert_lines(
        "G0",
        &["G00 Rapid positioning", "group 01, modal, in force at power-on", "group with G01 G02 G03"],
    );
    assert_lines("G04", &["group 00, in its block only"]);
    assert_lines("G54", &["P15-P19 0 mm G54 work zero offset of axis 1-5"]);
    assert_lines("G10 L20", &["G10 L20 Set offset of additional work system n (1-50)"]);
    assert_lines("G54 P7", &["G54 Pn Additional work coordinate system n"]);
    // An operation of macro A, by its number as it is written.
    for what in ["G65 H02", "g65 h2"] {
        assert_lines(what, &["G65 H02 Sum, #i = Q + R", "form G65 H02 P#i Q_ R_", "manual 4.9.4"]);
    }
    assert_lines("G65", &["G65 H86 P_ Q_ R_ Jump to block P if Q <= R"]);
    assert!(page("G84").contains("P257") && page("G84").contains("gsk990mc:0200"));
}

#[test]
fn an_m_code_is_explained_with_its_timing() {
    assert_lines(
        "m98",
        &[
            "when after the motion of its block",
            "done by the control, as order of the program",
            "manual 5.2.4, 3.2.2",
        ],
    );
    assert_lines("M3", &["M03 Spindle forward", "when starts with the motion of its block"]);
    assert!(page("M16").starts_with("M16  the manual names it without a meaning"));
}

#[test]
fn a_parameter_is_explained_under_all_its_names() {
    let expected = [
        "value 2 mm",
        "range 0 … 999.9999 mm",
        "part canned cycles",
        "G73 High-speed peck drilling, retract d = P270",
    ];
    for name in ["P270", "p0270", "g73_retract"] {
        assert_lines(name, &expected);
    }
    assert_eq!(lines(&explain(&["parameter", "270"]).out), lines(&page("P270")));
    for name in ["43#1", "NO43.1", "no43#1", "QZA", "NO43"] {
        assert_lines(name, &["1 G73/G83 without cut depth raises an alarm", "range 0 or 1", "value 1"]);
    }
    assert_eq!(lines(&page("NO47")).iter().filter(|l| l.starts_with("NO47.")).count(), 5);
    // Other rooms are told as such.
    assert!(page("P160").contains("servo drives and bus; kept with its value"));
    assert_lines("P380", &["range the manual prints none"]);
}

#[test]
fn a_machine_file_gives_the_values() {
    let folder = tempfile::tempdir().unwrap();
    let text = format!("{}\n[parameters]\nP270 = 1.5\n", ferrocut_machine::Machine::DEMO_MILL);
    let file = write(&folder, "mill.toml", text);
    let answer = explain(&["G73", "P270", "--machine", &file]);
    assert!(lines(&answer.out).contains(&"P270 1.5 mm (default 2) Retract distance d of G73".to_owned()));
    assert!(lines(&answer.out).contains(&"value 1.5 mm".to_owned()));
    let answer = explain(&["P270", "--machine", "no/such.toml"]);
    assert_eq!(answer.code, 2);
}

#[test]
fn an_alarm_is_explained_under_all_its_names() {
    for name in ["45", "0045", "gsk990mc:0045", "GSK990MC:45", "alarm 45"] {
        assert_lines(
            name,
            &[
                "gsk990mc:0045 G73 or G83 without a depth of cut Q",
                "from the part program",
                "FC-0503 The pecking cycle has no depth of cut",
                "G83 Chip-removing peck drilling, clearance d = P271",
            ],
        );
    }
    assert_eq!(lines(&explain(&["alarm", "45"]).out), lines(&page("45")));
    assert_lines("fc-302", &["shown as gsk990mc:0020"]);
    assert_lines(
        "FC-0302",
        &["P214 0.05 mm Allowed difference between start and end radius of an arc (alarm 0020)"],
    );
    assert!(page("3045").starts_with("gsk990mc:3045  "));
}

#[test]
fn a_variable_is_explained_with_its_range_and_its_own_axis() {
    assert_lines(
        "#5206",
        &[
            "#5206 G54 work offset",
            "numbers #5206-#5209",
            "access read and write",
            "this one G54 X",
            "#5201-#5235 Work offsets (whole range)",
        ],
    );
    assert_lines(
        "#150",
        &["NO52.6 0 1: Reset clears common variables #100-#199; 0: Reset keeps common variables #100-#199"],
    );
    assert_lines("variable 4001", &["access read only"]);
    assert_lines("#5210", &["note not described by the manual; programs cannot use it"]);
}

#[test]
fn letters_and_macro_words_are_explained() {
    // Of a chamfer and a corner arc, as they are written.
    for (written, letter) in [(",R", "R"), (",l", "L")] {
        assert_eq!(page(written), page(letter));
    }
    assert_lines("h", &["range 0 … 255, whole numbers"]);
    assert_lines("while", &["form WHILE [condition] DO m … END m"]);
}

const PROGRAM: &str = "O1 (TEST)\n\
    G90 G54 G0 X10 Y20 S1000 M3\n\
    (铣平面)\tG43 Z50 H1\n\
    G98 G84 X1 Y2 Z-10 R2 P100 F500 (TAP)\n\
    X5 Y6\n\
    G80\n\
    G1 X[#5206+SI[30]] F100\n\
    IF[#1EQ#2]GOTO 100\n\
    N100 #500=#100+1; G4 X1.5\n\
    M98 P2 L3\n\
    G65 H2 P#101 Q1 R2\n\
    G10 L2 P1 X5\n\
    M30\n";

#[test]
fn the_word_at_a_place_is_explained_where_it_stands() {
    let folder = tempfile::tempdir().unwrap();
    let (gb, ..) = (PROGRAM.replace("铣平面", "\u{1}"), 0);
    let mut bytes = Vec::new();
    for byte in gb.bytes() {
        // 铣平面 in GB18030.
        if byte == 1 { bytes.extend(b"\xCF\xB3\xC6\xBD\xC3\xE6") } else { bytes.push(byte) }
    }
    for file in [write(&folder, "utf8.nc", PROGRAM), write(&folder, "gb.nc", &bytes)] {
        for (place, title, others) in [
            ("2:12", "X10", &["read by G00 Rapid positioning", "form G00 X_ Y_ Z_"][..]),
            ("2:14", "X10", &[]),
            ("2:1", "G90", &["G90 Absolute programming"]),
            ("2:27", "M03", &[]),
            // The remark is 5 characters, the tab one.
            ("3:7", "G43", &[]),
            ("3:15", "H1", &["read by G43 Tool length compensation plus", "range 0 … 255, whole numbers"]),
            ("4:23", "P100", &["read by G84 Right-hand tapping"]),
            (
                "5:4",
                "Y6",
                &[
                    "read by G84 Right-hand tapping",
                    "in force G00 G17 G90 G94 G54 G21 G40 G43 G84 G98 G15 G50 G69 G64 G97 G13",
                ],
            ),
            ("7:4", "X[#5206+SI[30]]", &["read by G01 Straight cutting move"]),
            ("7:6", "#5206", &["this one G54 X"]),
            ("7:12", "SIN", &[]),
            ("8:1", "IF", &[]),
            ("8:7", "EQ", &[]),
            ("8:8", "#2", &["#2 Argument B of G65"]),
            ("9:2", "N100", &[]),
            ("9:8", "#500", &[]),
            ("9:24", "X1.5", &["read by G04 Dwell"]),
            ("10:6", "P2", &["read by M98 Subprogram call M98 P_ L_ (four nesting levels)"]),
            ("11:5", "H2", &["read by G65 H02 Sum, #i = Q + R", "form G65 H02 P#i Q_ R_"]),
            ("12:5", "L2", &["read by G10 L2 Set external work offset (P0) or offset of G54-G59 (P1-P6)"]),
        ] {
            let found = lines(&page(&format!("{file}:{place}")));
            assert!(found[0].starts_with(&format!("{title} ")), "{place}: {found:#?}");
            for line in others {
                assert!(found.iter().any(|l| l == line), "{place}: {line} in {found:#?}");
            }
        }
        let answer = explain(&[&format!("{file}:2")]);
        assert_eq!(answer.out.split("\n\n").count(), 7, "{}", answer.out);
        for (place, says) in [
            ("3:3", "column 3: a comment"),
            ("5:3", "column 3: there is no word; the words of the line and their columns: X5 (1), Y6 (4)"),
            ("40:1", "line 40: there is no block"),
        ] {
            let answer = explain(&[&format!("{file}:{place}")]);
            assert_eq!(answer.code, 2);
            assert!(answer.err.contains(says) && answer.err.lines().count() == 1, "{}", answer.err);
        }
    }
    let answer = with_input(&["explain", "--", "-:1:4"], "G1 X5\n");
    assert!(answer.out.starts_with("X5  "), "{}", answer.out);
    let answer = explain(&["no/such.nc:1:1"]);
    assert!(answer.code == 2 && answer.err.contains("no/such.nc"), "{}", answer.err);
}

#[test]
fn a_file_without_a_line_and_a_drawing_are_told_as_such() {
    let folder = tempfile::tempdir().unwrap();
    let program = write(&folder, "part.nc", PROGRAM);
    // Also where its name begins as something else does.
    for name in ["1234.nc", "G1.nc", "P12.nc"] {
        write(&folder, name, PROGRAM);
        let answer = common::answer(common::command(&["explain", name]).current_dir(folder.path()));
        let says = format!("error: {name} is a file: name a line of it");
        assert!(answer.code == 2 && answer.err.starts_with(&says), "{}", answer.err);
    }
    for what in [&program, &format!("{program}:0")] {
        let answer = explain(&[what]);
        let says = format!("error: {program} is a file: name a line of it, {program}:12, ");
        assert!(answer.code == 2 && answer.err.starts_with(&says), "{}", answer.err);
    }
    let dxf = "%\n0\nSECTION\n2\nENTITIES\n0\nENDSEC\n0\nEOF\n";
    for (name, text, kind) in
        [("a.dxf", dxf, "DXF"), ("a.plt", "IN;PU0,0;\n", "PLT"), ("a.nc", "IN;PU0,0;\n", "PLT")]
    {
        let file = write(&folder, name, text);
        for place in [&file, &format!("{file}:1"), &format!("{file}:1:1")] {
            let answer = explain(&[place]);
            assert_eq!((answer.code, answer.out.as_str()), (2, ""), "{place}");
            let says = format!("error: {file} is a {kind} drawing");
            assert!(
                answer.err.starts_with(&says) && answer.err.contains("ferrocut import"),
                "{}",
                answer.err
            );
        }
    }
}

#[test]
fn what_does_not_exist_is_told_in_a_sentence_with_near_matches() {
    for (what, says) in [
        ("G77", "error: gsk990mc has no code G77; near it: G76, G74, G73, G87\n"),
        ("G54.1", "error: gsk990mc has no code G54.1; near it: G54"),
        ("G10 L9", "error: gsk990mc has no code G10 L9; near it: G10 L2"),
        ("G65 H07", "error: gsk990mc has no code G65 H07; near it: G65 H05, G65 H04, G65 H03, G65 H02\n"),
        ("G65 P5", "error: gsk990mc has no code G65 P5\n"),
        ("M7", "error: gsk990mc has no code M7; near it: M06, M08"),
        ("P272", "error: gsk990mc has no parameter P272; near it: P271"),
        ("NO21.0", "error: gsk990mc has no parameter NO21.0; near it: "),
        ("g73_retrat", "error: g73_retrat is nothing that gsk990mc knows; near it: g73_retract\n"),
        ("2000", "error: gsk990mc has no alarm 2000"),
        ("FC-0999", "error: gsk990mc has no alarm FC-0999; near it: FC-09"),
        ("weihong:12", "error: gsk990mc has no alarm weihong:12\n"),
        ("#200", "error: gsk990mc has no variable #200; near it: #100-#199, #500-#999\n"),
        ("INM", "error: INM is the symbol of several parameters: NO0.1, NO3.0\n"),
        ("tapping", "error: tapping is nothing that gsk990mc knows; near it: G63, G74, G84, M28, M29\n"),
        ("nonsense", "error: nonsense is nothing that gsk990mc knows\n"),
        ("", "error:  is nothing that gsk990mc knows"),
        ("刀具", "error: 刀具 is nothing that gsk990mc knows\n"),
        ("G99999999", "error: gsk990mc has no code G99999999"),
        ("P99999", "error: gsk990mc has no parameter P99999"),
        ("#99999999999", "error: gsk990mc has no variable #99999999999"),
    ] {
        let answer = explain(&[what]);
        assert_eq!((answer.code, answer.out.as_str()), (2, ""), "{what}");
        assert!(answer.err.starts_with(says) && answer.err.lines().count() == 1, "{what}: {}", answer.err);
    }
    // What no control is called is a file that is not there.
    for what in ["nofile.nc:3", "no/such:3", "nofile.nc:3:1"] {
        let answer = explain(&[what]);
        assert!(answer.code == 2 && answer.err.contains("cannot be read"), "{what}: {}", answer.err);
    }
    // The others of a list are explained all the same.
    let answer = explain(&["G77", "G76"]);
    assert!(answer.code == 2 && answer.out.starts_with("G76  "));
    assert_eq!(explain(&[]).code, 2);
    assert_eq!(explain(&["G1", "--dialect", "nosuch"]).code, 2);
}

#[test]
fn pages_are_objects_for_programs() {
    let answer = explain(&["G84", "P270", "45", "#5206", "X", "--format", "json", "--language", "zh"]);
    let pages = json_lines(&answer.out);
    let kinds: Vec<_> = pages.iter().map(|p| p["kind"].as_str().unwrap()).collect();
    assert_eq!(kinds, ["g-code", "parameter", "alarm", "variable", "address"]);
    assert_eq!(
        (&pages[0]["group"], &pages[0]["modal"], &pages[0]["power_on"]),
        (&"09".into(), &true.into(), &false.into())
    );
    let tapping = pages[0]["parameters"].as_array().unwrap();
    assert!(tapping.iter().any(|p| p["name"] == "P257" && p["value"] == 2000.0 && p["unit"] == "r/min"));
    assert_eq!(pages[1]["range"], serde_json::json!([0.0, 999.9999]));
    assert_eq!(pages[2]["source"], "program");
    let wrong = explain(&["G77", "--format", "json"]);
    assert_eq!(json(&wrong.err)["severity"], "error");
}

#[test]
fn everything_in_the_tables_has_a_page_in_every_language() {
    for dialect in dialects::ALL {
        if let Some(reference) = Reference::of(dialect.name) {
            everything_has_a_page(dialect.name, reference);
        }
    }
    assert!(explain(&["G84", "--language", "zh"]).out.contains("相关参数"));
    // Neighbours that differ in the number of their axis alone are one row in every language.
    let of_axes = |language: &str| {
        let out = explain(&["G00", "--language", language]).out;
        out.lines().find(|line| line.trim_start().starts_with("P88-P92")).map(str::to_owned).unwrap_or(out)
    };
    for (language, text) in [("en", "axis 1-5"), ("ru", "1-5"), ("zh", "1-5"), ("es", "1-5"), ("tr", "1-5")] {
        assert!(of_axes(language).contains(text), "{language}: {}", of_axes(language));
    }
    // What is said of a code is related both ways.
    let reference = Reference::of("gsk990mc").unwrap();
    assert!(reference.codes_of(&Subject::Parameter("P257".parse().unwrap())).contains(&Subject::G(840)));
}

fn everything_has_a_page(dialect: &str, reference: &Reference) {
    let table = ParameterTable::of(dialect).unwrap_or_else(ParameterTable::empty);
    let codes = reference.g_codes().iter().map(|r| r.name());
    let m = reference.m_codes().iter().map(|r| format!("M{}", r.code));
    let parameters = table.iter().map(|d| d.name.to_string());
    let alarms = alarm_table(dialect).iter().map(|r| r.id.to_string());
    let syntax = dialects::by_name(dialect).unwrap().syntax;
    let variables = reference.variables().iter().map(|r| syntax.variable_name(*r.numbers.start()));
    let letters = (b'A'..=b'Z').map(|l| char::from(l).to_string());
    let words = reference.macro_words().iter().map(|r| r.word.to_string());
    let all: Vec<String> =
        codes.chain(m).chain(parameters).chain(alarms).chain(variables).chain(letters).chain(words).collect();
    for language in ["en", "zh", "ru", "es", "tr"] {
        let mut arguments = vec!["explain", "--dialect", dialect, "--language", language];
        arguments.extend(all.iter().map(String::as_str));
        let answer = ferrocut(&arguments);
        assert_eq!((answer.code, answer.err.as_str()), (0, ""));
        assert_eq!(answer.out.split("\n\n").count(), all.len());
        assert!(!answer.out.contains("label-"), "a label without a text");
        let longest = answer.out.lines().map(|l| l.chars().count()).max().unwrap();
        assert!(longest <= 110, "{longest}");
    }
}

#[test]
fn kaitong_is_explained_with_its_own_names() {
    let page = |what: &str| explain(&[what, "--dialect", "kaitong"]).out;
    let g81 = page("G81");
    assert!(g81.starts_with("G81  Drilling, spot drilling\n") && g81.contains("L_"), "{g81}");
    let g76 = page("G76");
    assert!(g76.contains("P018.4  0") && g76.contains("P018.5  0") && !g76.contains("P230"), "{g76}");
    let retract = page("P230");
    assert!(
        retract.contains("1000 × 0.001 mm")
            && retract.contains("≥ 0 × 0.001 mm")
            && retract.contains("G73")
            && retract.contains("G83"),
        "{retract}"
    );
    assert_eq!(page("P018").matches("shift_").count(), 2);
    assert!(page("FC-0528").contains("pitch") && page("G68").contains("P024.0"));
}

#[test]
fn weihong_is_explained_with_its_own_names() {
    let page = |what: &str| explain(&[what, "--dialect", "weihong"]).out;
    let g34 = page("G34");
    assert!(g34.starts_with("G34  ") && g34.contains("G34 X_ Y_ I_ J_ K_"), "{g34}");
    assert!(page("G921").contains("G921") && page("M801").contains("M801"));
    let height = page("SAFEHEIGHT");
    assert!(height.contains("safe_height") && height.contains("G28"), "{height}");
    assert_eq!(page("#SAFEHEIGHT"), height);
    assert!(page("#FC7").contains("#FC7") && page("FC-0443").contains("FC-0443"));
    // Codes of other controls are none here.
    assert_ne!(explain(&["G16", "--dialect", "weihong"]).code, 0);
}

#[test]
fn fagor_is_explained_with_its_own_names() {
    let page = |what: &str| explain(&[what, "--dialect", "fagor8065"]).out;
    let pocket = page("G287");
    assert!(pocket.starts_with("G287  Rectangular pocket with round or cut corners\n"), "{pocket}");
    assert!(pocket.contains("#FINISH [delta=_") && !pocket.contains("not carried out"), "{pocket}");
    let parameter = page("P7");
    assert!(parameter.starts_with("P7  Arithmetic parameters P0 to P19999"), "{parameter}");
    assert!(parameter.contains("P0-P19999") && page("V.C.I").contains("V.C.A-V.C.Z"), "{parameter}");
    // Where it stands: names of a directive, a parameter, a remark.
    let folder = tempfile::tempdir().unwrap();
    let file = folder.path().join("part.nc");
    std::fs::write(&file, "#CYCLE G282 [X=1, Z=0, ZS=2, P=P4]\nG1 XP3 F100 ; X5\nM30\n").unwrap();
    let at = |place: &str| {
        let place = format!("{}:{place}", file.display());
        let answer = explain(&[&place, "--dialect", "fagor8065"]);
        answer.out + &answer.err
    };
    assert!(at("1:9").starts_with("G282  Drilling"), "{}", at("1:9"));
    assert!(at("1:3").starts_with("CYCLE  "), "{}", at("1:3"));
    assert!(at("2:5").starts_with("P3  Arithmetic"), "{}", at("2:5"));
    assert!(at("2:16").contains("comment"), "{}", at("2:16"));
}

#[test]
fn a_control_without_parameters_says_so() {
    for (dialect, names) in [("rs274", &["P270", "NO43.1", "43#1"][..]), ("fagor8065", &["NO43.1", "43#1"])] {
        for name in names {
            let answer = explain(&[name, "--dialect", dialect]);
            let says = format!("error: {dialect} has no parameters\n");
            assert_eq!((answer.code, answer.out.as_str(), answer.err), (2, "", says), "{name}");
        }
        let answer = ferrocut(&["machine", "params", "get", "NO43.1", "--dialect", dialect]);
        assert_eq!((answer.code, answer.err), (2, format!("error: {dialect} has no parameters\n")));
    }
}

#[test]
fn fagors_keywords_and_parameters_are_asked_for_as_they_are_written() {
    let fagor = |what: &[&str]| explain(&[what, &["--dialect", "fagor8065"]].concat());
    for word in ["$IF", "$elseif", "$FOR", "$WHILE", "$GOTO", "$BREAK"] {
        assert_eq!(fagor(&[word]).out, fagor(&[&word[1..]]).out);
        assert_eq!(fagor(&[word]).code, 0, "{word}");
    }
    for what in [&["#100"][..], &["variable", "100"]] {
        let answer = fagor(what);
        let says = "error: fagor8065 writes its arithmetic parameters without a sign: P100\n";
        assert_eq!((answer.code, answer.out.as_str(), answer.err.as_str()), (2, "", says));
    }
    assert!(fagor(&["variable", "P100"]).out.starts_with("P100  Arithmetic parameters"));
    assert_eq!(explain(&["$IF"]).code, 2, "a keyword of GSK has no sign");
}

#[test]
fn a_line_of_macros_is_explained_piece_by_piece() {
    let folder = tempfile::tempdir().unwrap();
    let gsk =
        "O1\n#1=#1+SIN[30] (SQRT)\nIF [#1 EQ 2] GOTO 10\nWHILE [#1 LT 3] DO 1\nEND 1\nN10 G1 X[#1] F1\nM30\n";
    let fagor = "P1=2\n$IF P1 == 2 ; $ELSE\n$FOR P2=1,3,1\n$ENDFOR\n$GOTO N10\nM30\n";
    let ngc = "O100 sub\n#<a>=3\nO101 if [#1 EQ #<_x>]\nO101 endif\nO100 endsub\nM2\n";
    let weihong = "IF(#1==2) G1 X1 F100\n#5=sin(#CURWORKPOS.X)\nM30\n";
    for (dialect, program, expected) in [
        (
            "gsk990mc",
            gsk,
            &[
                (2, "#1 = SIN"),
                (3, "IF #1 EQ GOTO"),
                (4, "WHILE #1 LT DO"),
                (5, "END"),
                (6, "N10 G01 X[#1] F1"),
            ][..],
        ),
        ("fagor8065", fagor, &[(1, "P1 ="), (2, "IF P1"), (3, "FOR P2 ="), (4, "ENDFOR"), (5, "GOTO")]),
        ("rs274", ngc, &[(1, "SUB"), (2, "<name> ="), (3, "IF #1 EQ <_x>"), (4, "ENDIF"), (5, "ENDSUB")]),
        ("weihong", weihong, &[(1, "IF #1 G01 X1 F100"), (2, "#5 = SIN CURWORKPOS.X")]),
    ] {
        let file = write(&folder, "part.nc", program);
        for (line, titles) in expected {
            let answer = explain(&[&format!("{file}:{line}"), "--dialect", dialect]);
            let first = |page: &str| page.split_whitespace().next().unwrap_or_default().to_owned();
            let found: Vec<String> = answer.out.split("\n\n").map(first).collect();
            assert_eq!(
                (answer.code, found.join(" ").as_str()),
                (0, *titles),
                "{dialect} {line}: {}",
                answer.out
            );
        }
    }
    assert_eq!(lines(&explain(&["="]).out)[1], "form #i = value");
}

#[test]
fn rs274_is_explained_with_its_own_names() {
    let page = |what: &str| {
        let answer = explain(&[what, "--dialect", "rs274"]);
        assert_eq!((answer.code, answer.err.as_str()), (0, ""), "{what}");
        answer.out
    };
    assert!(page("G10 L2").starts_with("G10 L2  Sets zero and turn of system P\n"), "{}", page("G10 L2"));
    assert!(page("G10 L20").contains("G10 L20 P_ X_ Y_ Z_"));
    assert!(page("#<_x>").starts_with("<_x>  Programmed position on an axis, in units of the program\n"));
    assert!(page("#<_Metric>").contains("#<_metric>: G21"));
    assert!(page("#<_mine>").contains("one for all subprograms") && page("#<mine>").contains("has its own"));
    assert_eq!(explain(&["#<_x>"]).code, 2, "GSK has no such parameters");
}

#[test]
fn what_the_control_does_itself_is_not_done_by_the_ladder() {
    for (dialect, code, by) in [
        ("rs274", "M66", "the control"),
        ("rs274", "M61", "the control"),
        ("rs274", "M62", "the control"),
        ("rs274", "M70", "the control"),
        // No program of this language is run; with `program = 0` the ladder changes the tool.
        ("rs274", "M6", "the ladder of the machine"),
        ("rs274", "M48", "the ladder of the machine"),
        // It runs the program of the tool change, as on GSK.
        ("weihong", "M6", "the control"),
        ("fagor8065", "M6", "the control"),
        ("gsk990mc", "M6", "the control"),
    ] {
        let page = explain(&[code, "--dialect", dialect]).out;
        assert!(lines(&page).contains(&format!("done by {by}")), "{dialect} {code}: {page}");
    }
}
