//! What holds for every input: no panic, no hang, bounded memory, finite steps, alarms that point into
//! the text. In test builds overflow is a panic too.
#![allow(missing_docs, clippy::unwrap_used, clippy::panic)]

mod common;

use ferrocut_interpreter::cycles::described::{DescribedCycle, Kind, Parameter, Part};
use ferrocut_interpreter::{Dialect, Interpreter, Options, dialects};
use ferrocut_machine::{Alarm, Fault};
use ferrocut_toolpath::{Dwell, Feed, Op, Step};
use proptest::prelude::*;
use std::time::{Duration, Instant};

/// Steps and alarms read of one program. A program may be meant to run for ever.
const ENOUGH: usize = 2_000;

/// Longest time that a program may take for that; work that grows without bound takes more. Generous,
/// so that a busy machine fails nothing.
const PATIENCE: Duration = Duration::from_secs(60);

fn finite(op: &Op) -> bool {
    let feed_is_good = |feed: &Feed| match *feed {
        Feed::PerMinute(f) | Feed::PerRevolution(f) | Feed::Duration(f) => f.is_finite() && f > 0.0,
        Feed::Held { programmed, at } => programmed > 0.0 && at.is_finite() && at > 0.0,
    };
    let target = op.target().is_none_or(|to| to.is_finite());
    target
        && match op {
            Op::Feed { feed, .. } | Op::Skip { feed, .. } => feed_is_good(feed),
            Op::Arc { center, sweep, feed, .. } => {
                center.iter().all(|c| c.is_finite())
                    && sweep.is_finite()
                    && *sweep != 0.0
                    && feed_is_good(feed)
            }
            Op::Tap { pitch, rpm, .. } => pitch.is_finite() && rpm.is_finite(),
            Op::Dwell(Dwell::Seconds(t) | Dwell::Revolutions(t)) => t.is_finite() && *t > 0.0,
            Op::Message(_) => true,
            // Whatever else holds numbers.
            other => {
                let text = format!("{other:?}");
                !text.contains("NaN") && !text.contains("inf")
            }
        }
}

/// An arc's end lies on its circle, as far as the control's tolerance lets it leave it.
fn arc_is_round(step: &Step, interpreter: &Interpreter, from: ferrocut_geometry::Position) -> bool {
    let Some(arc) = step.op.arc(from) else { return true };
    let radius = |p: ferrocut_geometry::Position| {
        let [a, b] = arc.plane.of(p);
        (a - arc.center[0]).hypot(b - arc.center[1])
    };
    let (start, end) = (radius(arc.start), radius(arc.end));
    // Large coordinates leave fewer digits.
    let digits = 1e-9 * (1.0 + start.abs() + end.abs() + arc.center[0].abs() + arc.center[1].abs());
    // RS274/NGC allows large arcs a thousandth.
    let share = if interpreter.dialect().name == "rs274" { 0.001 * start.max(end) } else { 0.0 };
    (start - end).abs() <= interpreter.rules().arc_tolerance.max(share) + 1e-5 + digits
}

fn points_into(text: &[u8], alarm: &Alarm) -> bool {
    let span = alarm.span;
    // A text without a single block has no line to show.
    let has_line = span.line >= 1 || span.len == 0 && alarm.fault == Fault::NoProgramEnd;
    has_line && span.offset + u64::from(span.len) <= text.len() as u64
}

/// Reads a program to its end, or enough of it, and holds every rule against it.
fn holds(dialect: &'static Dialect, text: &[u8], setup: &str, options: Options) {
    // A picture is refused before: nothing to interpret.
    let Some(mut interpreter) = common::interpreter_of(dialect, text, setup, options) else { return };
    let shown = format!("{}: {}", dialect.name, String::from_utf8_lossy(text));
    let began = Instant::now();
    let mut at = interpreter.position();
    let mut alarms = 0;
    for _ in 0..ENOUGH {
        match interpreter.next() {
            None => {
                assert!(interpreter.next().is_none(), "goes on behind the end: {shown}");
                break;
            }
            Some(Ok(step)) => {
                assert!(alarms == 0 || options.keep_going, "goes on behind an alarm: {shown}");
                assert!(finite(&step.op), "{:?} of {shown}", step.op);
                // Behind an alarm a checker takes the point as reached where the faulty block was to end.
                assert!(alarms > 0 || arc_is_round(&step, &interpreter, at), "{:?} of {shown}", step.op);
                at = match step.op {
                    Op::Datum { at } => at,
                    ref op => op.target().copied().unwrap_or(at),
                };
            }
            Some(Err(alarm)) => {
                assert!(points_into(text, &alarm), "{alarm:?} of {shown}");
                alarms += 1;
            }
        }
    }
    assert!(began.elapsed() < PATIENCE, "{:?} for {shown}", began.elapsed());
}

fn holds_every_way(text: &[u8]) {
    let options = Options::default();
    for dialect in dialects::ALL {
        holds(dialect, text, "", options);
        let tolerant = Options { keep_going: true, block_skip: true, optional_stop: true, ..options };
        holds(dialect, text, "", tolerant);
    }
}

/// Addresses with a value from the whole range and beyond, in the forms that people write.
fn word() -> impl Strategy<Value = String> {
    let known_g = prop::sample::select(vec![
        0, 1, 2, 3, 4, 10, 15, 16, 17, 18, 19, 20, 21, 28, 29, 30, 31, 40, 43, 44, 49, 50, 51, 52, 53, 54,
        55, 59, 60, 61, 63, 64, 65, 68, 69, 73, 74, 76, 80, 81, 82, 83, 84, 85, 86, 87, 88, 89, 90, 91, 92,
        94, 95, 98, 99,
    ]);
    let known_m = prop::sample::select(vec![0, 1, 2, 3, 4, 5, 6, 8, 9, 19, 30, 98, 99]);
    let value = prop_oneof![
        6 => (-200i32..200).prop_map(|v| format!("{v}")),
        4 => (-99_999_999i64..99_999_999).prop_map(|v| format!("{}.{:03}", v / 1000, (v % 1000).abs())),
        1 => (-99_999i32..99_999).prop_map(|v| format!("{v}.")),
        1 => any::<f64>().prop_filter("written", |v| v.is_finite() && v.abs() < 1e30).prop_map(|v| format!("{v}")),
        1 => prop::sample::select(vec!["0", "-0.", ".5", "+1", "99999999", "-99999999", "", "-", "."])
            .prop_map(str::to_owned),
        1 => (0u32..40).prop_map(|n| format!("#{n}")),
        1 => (-50i32..50, 1i32..9).prop_map(|(a, b)| format!("[{a}/{b}*SIN[{a}]]")),
    ];
    // K apart: most repeats of a cycle would only take time.
    let letter = prop::sample::select(b"XYZXYZXYZABIJRRFSTHDPQLE".to_vec());
    prop_oneof![
        4 => known_g.prop_map(|g| format!("G{g}")),
        1 => (0u32..1200).prop_map(|g| format!("G{}.{}", g / 10, g % 10)),
        2 => known_m.prop_map(|m| format!("M{m}")),
        1 => (0u32..70_000).prop_map(|m| format!("M{m}")),
        12 => (letter, value).prop_map(|(l, v)| format!("{}{v}", l as char)),
        1 => (-300i32..300).prop_map(|k| format!("K{k}")),
    ]
}

/// What controls write that know names, texts, guards and programs that stand for codes.
fn named() -> impl Strategy<Value = String> {
    const PIECES: &[&str] = &[
        "X=#1+2",
        "X#1+SIN(#2)",
        "Y=-#3*2",
        "X5",
        "Z-3 R2",
        "I10 J30 K5",
        "P2",
        "L3",
        "Q0.5",
        "F200",
        "IF(#1>0)G1X5",
        "IF(#CURTOOL==1)",
        "G65 P\"A\" L2",
        "G65 P202",
        "M98 P\"A\" L3",
        "M17",
        "M99",
        "G92 X1",
        "G921 X1 Y2",
        "G922 X3",
        "G923 X1",
        "G992 X2",
        "G68 X1 Y2 R30",
        "G69",
        "G51.1 X5",
        "G50.1 Y",
        "G51 X0 Y0 P2",
        "G50",
        "G34 X1 I10 K5",
        "G35 X1 Y2 I5 J30 K4",
        "G36 I9 J10 P20 K3",
        "G37 I3 P4 J2 K3",
        "G73 Z-5 R1 Q1",
        "G83 Z-5 R1 Q2 X4",
        "G76 Z-5 R1 I0.2 P100",
        "G87 Z-5 R-6 I1",
        "G88 Z-5 R1 P10",
        "G903",
        "G904 FX100 PX4 LX1 X5",
        "G906 PLC[4] LEVEL1 P5",
        "G905",
        "G907",
        "G908",
        "G916",
        "G918 X5",
        "G919 Z5",
        "M801 PLC[4] LEVEL1",
        "M801 MT1 DT2",
        "M802 P131072",
        "M901 PLC[4] LEVEL1",
        "M902 H0",
        "#FC1=5",
        "#FC1",
        "#SAFEHEIGHT=5",
        "#SAFEHEIGHT",
        "#UNIT.YR=1",
        "{#1=2;#2=#1/0}",
        "#[#1]=3",
        "'a word",
        "\u{2018}a word\u{2019}",
        "(a word)",
        "\"A\"",
        "G02 X5 Y5 R5 Z-3 K1",
        "G41 D1",
        "G43 H1",
        "#CYCLE G281 [X=1, Y=2, ZS=5, P=3, F=100]",
        "#TOOL AX [Z+]",
        "#SET AX [X,Y,Z]",
        "$IF P1==2",
        "$FOR P1=1,3,1",
        "$ENDFOR",
        "V.C.Z=-2",
        "P1=P2+3",
        "G160 A30 I5 K3",
        "G88 G99 X1 Y2 Z2 I-6 J9 B3 F100",
        "NR2",
    ];
    prop::collection::vec(prop::sample::select(PIECES), 1..5).prop_map(|pieces| pieces.join(" "))
}

fn block() -> impl Strategy<Value = String> {
    let words = || prop::collection::vec(word(), 1..7).prop_map(|w| w.join(" "));
    prop_oneof![
        6 => named(),
        1 => prop::sample::select(vec!["O\"A\"", "O240", "O681", "O202", "O781"]).prop_map(str::to_owned),
        20 => words(),
        2 => (1u32..5, 0u32..4).prop_map(|(p, l)| format!("M98 P{p} L{l}")),
        1 => (1u32..5).prop_map(|o| format!("O{o}")),
        1 => (1u32..40, -9i32..9).prop_map(|(n, v)| format!("#{n}=#{n}+{v}")),
        1 => (1u32..9).prop_map(|n| format!("N{n} G91")),
        1 => words().prop_map(|w| format!("/{w}")),
        1 => Just("%".to_owned()),
        2 => Just("S500 M3 G90 G54".to_owned()),
    ]
}

fn program() -> impl Strategy<Value = String> {
    let end =
        prop::sample::select(vec!["M30\n", "M99\n", "", "M30\nO1\nG91 X1\nM99\nO2\nM98 P1 L3\nM2\n%\n"]);
    (prop::collection::vec(block(), 1..16), end).prop_map(|(b, end)| format!("{}\n{end}", b.join("\n")))
}

/// The example programs, cut to a size at which a change is likely to be met.
fn examples() -> Vec<Vec<u8>> {
    let files =
        |folder: &str| -> Vec<_> { std::fs::read_dir(folder).unwrap().map(|e| e.unwrap().path()).collect() };
    let mut paths: Vec<_> = Vec::new();
    for dialect in dialects::ALL {
        let folder = format!("{}/../../examples/{}", env!("CARGO_MANIFEST_DIR"), dialect.name);
        let before = paths.len();
        paths.extend(files(&folder).into_iter().filter(|p| p.extension().is_some_and(|e| e == "nc")));
        assert!(paths.len() >= before + 2, "the examples are in {folder}");
    }
    paths.sort();
    let cut = |path: &std::path::PathBuf| {
        let mut bytes = std::fs::read(path).unwrap();
        bytes.truncate(4000);
        bytes
    };
    paths.iter().map(cut).collect()
}

/// An example with some bytes changed, put in and taken out, and blocks exchanged.
fn mutated() -> impl Strategy<Value = Vec<u8>> {
    let change = (any::<prop::sample::Index>(), 0..6u8, any::<u8>(), any::<prop::sample::Index>());
    (prop::sample::select(examples()), prop::collection::vec(change, 1..24)).prop_map(|(text, changes)| {
        let mut text = text;
        for (at, kind, byte, other) in changes {
            if text.is_empty() {
                break;
            }
            let at = at.index(text.len());
            match kind {
                0 => text[at] = byte,
                1 => text.insert(at, byte),
                2 => drop(text.remove(at)),
                3 => text[at] = b"0123456789.-XYZRIJKGM#[]"[usize::from(byte) % 24],
                4 => text.insert(at, b"\n;[](#-+./%O\"'=<&"[usize::from(byte) % 17]),
                _ => {
                    let mut lines: Vec<&[u8]> = text.split(|b| *b == b'\n').collect();
                    let (a, b) = (at % lines.len(), other.index(lines.len()));
                    lines.swap(a, b);
                    text = lines.join(&b'\n');
                }
            }
        }
        text
    })
}

/// Tools and profiles for cycles that directives describe.
const SHOP: &str = "[tools.1]\nradius = 5\ncutting_length = 20\n[tools.2]\nradius = 3\ncutting_length = 15\n\
    entry_angle = 10\n[tools.3]\nradius = 1\ntip_radius = 1\n";

const PROFILES: &str = "#PROFILE A [XY]\nG0 X0 Y0\nG1 X60\nY40\nG36 I4\nX0\nY0\nG39 I3\n\
    G0 X20 Y20\nG2 X20 Y20 I5 J0\n#ENDPROFILE\n#PROFILE B [XY]\nG0 X0 Y0\nG37 I5\nG1 X30\nG36 I6\nG3 X30 Y30 R15\n\
    G1 X-10 Y40\nG38 I5\n#ENDPROFILE\n#PROFILE C [XZ]\nG0 X0 Z0\nG1 X4 Z-8\n#ENDPROFILE\n";

/// A number that a machinist would give a parameter, in eighths, and now and then any other.
fn figure(name: &str) -> BoxedStrategy<String> {
    let (low, high) = match name {
        "L" | "H" | "LX" | "LY" | "X1" | "Y1" | "XN" | "YN" => (16, 640),
        "R" | "phi" | "phiK" | "Q" => (40, 320),
        "P" | "DP" => (4, 120),
        "N" | "NX" | "NY" => (0, 3),
        "step" => (0, 48),
        "I" | "I1" | "I2" | "B" | "K" | "IX" | "IY" => (-48, 64),
        "delta" | "deltaz" | "t" | "DS" | "E" => (0, 12),
        "beta" | "theta" => (0, 160),
        "alpha" | "tau" => (-1440, 1440),
        "S" => (800, 40_000),
        "D" | "KF" => (1, 1),
        "r" | "R1" | "RN" => (0, 40),
        "eps" => (4, 40),
        _ => (0, 400),
    };
    let whole = matches!(name, "N" | "NX" | "NY" | "D" | "KF");
    let usual = (low..=high)
        .prop_map(move |v: i32| if whole { v.to_string() } else { format!("{}", f64::from(v) / 8.0) });
    let edge = prop::sample::select(vec![
        "0",
        "1",
        "-1",
        "0.001",
        "1000000000",
        "99999",
        "-99999",
        "0.0000001",
        "P1",
    ]);
    let any = any::<f64>().prop_filter("written", |v| v.is_finite() && v.abs() < 1e12);
    prop_oneof![
        40 => usual,
        2 => edge.prop_map(str::to_owned),
        1 => any.prop_map(|v| format!("{v}")),
    ]
    .boxed()
}

fn argument(parameter: &'static Parameter) -> BoxedStrategy<String> {
    let name = parameter.name;
    match (parameter.kind, name) {
        // Tools of the table, mostly, and feeds above 0.
        (_, "T") => prop::sample::select(vec!["T=1", "T=2", "T=3", "T=1", "T=0", "T=7"])
            .prop_map(str::to_owned)
            .boxed(),
        (_, "F") => {
            prop_oneof![9 => Just("F=500".to_owned()), 1 => figure(name).prop_map(|v| format!("F={v}"))]
                .boxed()
        }
        // Planes that leave something to cut.
        (_, "Z") => {
            prop_oneof![9 => Just("Z=0".to_owned()), 1 => figure(name).prop_map(|v| format!("Z={v}"))].boxed()
        }
        (_, "ZS") => {
            prop_oneof![9 => Just("ZS=5".to_owned()), 1 => figure(name).prop_map(|v| format!("ZS={v}"))]
                .boxed()
        }
        (Kind::Length | Kind::Number | Kind::NextTool, _) => {
            figure(name).prop_map(move |v| format!("{name}={v}")).boxed()
        }
        (Kind::Word(words), _) => {
            prop::sample::select(words).prop_map(move |w| format!("{name}={w}")).boxed()
        }
        (Kind::Name, "Z1" | "Z2" | "Z3" | "Z4") => Just(format!("{name}=C")).boxed(),
        (Kind::Name, _) => prop::sample::select(vec!["A", "A", "B", "C", "D"])
            .prop_map(move |n| format!("{name}={n}"))
            .boxed(),
        (Kind::Point, _) => (figure("X"), figure("Y"), 0..8u8, figure("r"))
            .prop_map(move |(x, y, kind, size)| match kind {
                0 => format!("{name}=[{x},{y},round,{size}]"),
                1 => format!("{name}=[{x},{y},chamfer,{size}]"),
                _ => format!("{name}=[{x},{y}]"),
            })
            .boxed(),
    }
}

/// Parameters in brackets, each given mostly; of 25 points a few.
fn arguments(parameters: &'static [Parameter]) -> impl Strategy<Value = String> {
    let one = |parameter: &'static Parameter| {
        let is_late_point =
            parameter.kind == Kind::Point && !["P1", "P2", "P3", "P4"].contains(&parameter.name);
        let share = match parameter.name {
            _ if is_late_point => 0.02,
            "M1" | "M2" | "M3" | "M4" | "next" | "mode" => 0.02,
            "Z1" | "Z2" | "Z3" | "Z4" => 0.3,
            "P" | "L" | "H" | "R" | "F" | "T" | "ZS" | "phi" | "P1" | "P2" | "profile" | "S" | "r" => 0.99,
            "DP" => 0.2,
            _ => 0.8,
        };
        prop::option::weighted(share, argument(parameter))
    };
    parameters
        .iter()
        .map(one)
        .collect::<Vec<_>>()
        .prop_map(|all| format!("[{}]", all.into_iter().flatten().collect::<Vec<_>>().join(", ")))
}

/// A cycle that directives describe, with its parts and maybe positions.
fn described() -> impl Strategy<Value = String> {
    let cycles: Vec<&'static DescribedCycle> = dialects::fagor8065::DIALECT.described_cycles.iter().collect();
    prop::sample::select(cycles).prop_flat_map(|cycle| {
        let parts = cycle.parts.iter().map(|(part, parameters)| {
            let share = if *part == Part::Drill { 0.3 } else { 0.95 };
            let head = match part {
                Part::Main => format!("#CYCLE {} ", cycle.id),
                Part::Drill => "#DRILL ".to_owned(),
                Part::Rough => "#ROUGH ".to_owned(),
                Part::Semi => "#SEMI ".to_owned(),
                Part::Finish => "#FINISH ".to_owned(),
            };
            let line = arguments(parameters).prop_map(move |a| format!("{head}{a}\n"));
            match part {
                Part::Main => line.prop_map(Some).boxed(),
                _ => prop::option::weighted(share, line).boxed(),
            }
        });
        let figures: Vec<_> = dialects::fagor8065::DIALECT.described_figures.iter().collect();
        let figure = prop::sample::select(figures).prop_flat_map(|figure| {
            arguments(figure.parameters).prop_map(|a| format!("#MULTI {} {a}\n", figure.name))
        });
        (parts.collect::<Vec<_>>(), prop::option::weighted(if cycle.repeats { 0.2 } else { 0.01 }, figure))
            .prop_map(|(parts, figure)| parts.into_iter().flatten().chain(figure).collect::<String>())
    })
}

/// As many cases as a property wants, or as PROPTEST_CASES asks for.
fn cases(cases: u32) -> ProptestConfig {
    let asked = std::env::var("PROPTEST_CASES").ok().and_then(|asked| asked.parse().ok());
    let cases = asked.unwrap_or(cases);
    // Failing inputs are printed; nothing is written into the tree.
    ProptestConfig { cases, failure_persistence: None, ..ProptestConfig::default() }
}

proptest! {
    #![proptest_config(cases(4000))]

    #[test]
    fn random_bytes(text in prop::collection::vec(any::<u8>(), 0..400)) {
        holds_every_way(&text);
    }

    #[test]
    fn random_text(text in "[A-Z0-9.# \\-+*/\\[\\]()=;\n%'\"<>]{0,300}") {
        holds_every_way(text.as_bytes());
    }

    #[test]
    fn random_words(text in program()) {
        holds_every_way(text.as_bytes());
    }
}

proptest! {
    #![proptest_config(cases(1500))]

    #[test]
    fn mutated_examples(text in mutated()) {
        holds_every_way(&text);
    }
}

proptest! {
    #![proptest_config(cases(1000))]

    #[test]
    fn described_cycles(cycles in prop::collection::vec(described(), 1..3)) {
        let text = format!("P1=5\n{PROFILES}{}M30\n", cycles.concat());
        let fagor = &dialects::fagor8065::DIALECT;
        for keep_going in [false, true] {
            holds(fagor, text.as_bytes(), SHOP, Options { keep_going, ..Options::default() });
        }
    }
}

proptest! {
    #![proptest_config(cases(300))]

    /// A move and its way back end where they began, whatever the units and the system.
    #[test]
    fn incremental_ways_there_and_back_meet(
        ways in prop::collection::vec((-9000i32..9000, -9000i32..9000, -9000i32..9000), 1..20),
        head in prop::sample::select(vec!["G21", "G20", "G55", "G92 X5 Y7", "G43 H1"]),
    ) {
        let there: Vec<String> = ways.iter().map(|(x, y, z)| way(*x, *y, *z)).collect();
        let back: Vec<String> = ways.iter().rev().map(|(x, y, z)| way(-x, -y, -z)).collect();
        let program = format!("{head}\nG1 F1000 G91\n{}\n{}\nM30\n", there.join("\n"), back.join("\n"));
        let (steps, alarm) = common::run(&program, "[tools.1]\nlength = 12.5\n[work_offsets]\nG55 = { x = 3 }");
        prop_assert_eq!(alarm, None);
        let targets: Vec<_> = steps.iter().filter_map(|s| s.op.target()).collect();
        let first = match head { "G43 H1" => 12.5, _ => 0.0 };
        if let Some(last) = targets.last() {
            prop_assert!((last.0[0].abs() + last.0[1].abs() + (last.0[2] - first).abs()) < 1e-6, "{:?}", last);
        }
    }
}

fn way(x: i32, y: i32, z: i32) -> String {
    let mm = |v: i32| f64::from(v) / 100.0;
    format!("X{} Y{} Z{}", mm(x), mm(y), mm(z))
}

fn ends_with(program: &str, fault: Fault) {
    let began = Instant::now();
    let mut interpreter = common::interpreter(program.as_bytes(), "", Options::default()).unwrap();
    let alarm = interpreter.by_ref().find_map(Result::err);
    assert_eq!(alarm.map(|a| a.fault), Some(fault), "{program}");
    assert!(interpreter.next().is_none());
    assert!(began.elapsed() < PATIENCE, "{program}");
}

#[test]
fn endless_programs_end_in_an_alarm() {
    // A program that calls itself, two that call each other, with and without steps between.
    ends_with("O1\nM98 P1\nM30\n", Fault::CallsTooDeep);
    ends_with("O1\nX1\nM98 P1\nM30\n", Fault::CallsTooDeep);
    ends_with("O1\nM98 P2\nM30\nO2\nG91 X1\nM98 P3\nM99\nO3\nM98 P2\nM99\n", Fault::CallsTooDeep);
    // Repeats of repeats without a step: 9999^4 passes.
    let calls: String = (1..4).map(|n| format!("O{n}\nM98 P{} L9999\nM99\n", n + 1)).collect();
    ends_with(&format!("M98 P1 L9999\nM30\n{calls}O4\nM99\n"), Fault::EndlessProgram);
    // Passes of a main program lead to no end, each having another state than those before.
    let program = b"O1\n#1=#1+1\nIF[#1 LT 0]GOTO9\nG91 G0 X0.001\nM99\nN9 M30\n";
    assert_eq!(
        common::interpreter(program, "", Options::default()).unwrap().filter_map(Result::ok).count(),
        2
    );
}

#[test]
fn repeats_that_move_nothing_end() {
    // Without Z there is no hole, and X5 is where the tool is: 99 999 repeats of nothing in every pass.
    let began = Instant::now();
    let program = b"O1\nS100\nG81 X5 R1 K99999\n#1=#1+1\nM99\n";
    let interpreter = common::interpreter(program, "", Options::default()).unwrap();
    assert!(interpreter.filter_map(Result::err).next().is_none() && began.elapsed() < PATIENCE);
    // GSK990MC 4.4 allows K99999 at most.
    ends_with("O1\nS100\nG81 X5 R1 K100000\nM30\n", Fault::WordOutOfRange);
}

#[test]
fn holes_on_a_line_are_given_out_one_by_one() {
    let program = b"G99 G83 X99999 R0 Z-999 Q0.1 L99999 F10\nM30\n";
    let kaitong = &dialects::kaitong::DIALECT;
    let interpreter = common::interpreter_of(kaitong, program, "", Options::default()).unwrap();
    assert_eq!(interpreter.take(100_000).filter(Result::is_ok).count(), 100_000);
    // A line of no length makes no steps, and ends all the same.
    let program = b"O1\nG81 R0 L99999\n#1=#1+1\nM99\n";
    let interpreter = common::interpreter_of(kaitong, program, "", Options::default()).unwrap();
    assert!(interpreter.filter_map(Result::err).next().is_none());
}

#[test]
fn a_repeated_cycle_takes_no_memory_for_its_repeats() {
    // 99 999 holes with 9 999 pecks each: given out one by one.
    let program = b"S100 M3\nG91 G99 G83 X0.1 Z-99.99 R0 Q0.01 K99999 F10\nM30\n";
    let interpreter = common::interpreter(program, "", Options::default()).unwrap();
    assert_eq!(interpreter.take(100_000).filter(Result::is_ok).count(), 100_000);
}
