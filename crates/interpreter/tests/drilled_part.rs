//! One part in every language that drills: the same steps, whatever the words.
//!
//! Each program is written as its control has it; what differs (who calls rigid tapping or has none, how pitch
//! and repeats are given, what parameters set) must not show in the steps.
#![allow(missing_docs, clippy::unwrap_used, clippy::panic)]

mod common;

use common::short;
use ferrocut_geometry::Position;
use ferrocut_interpreter::dialects;
use ferrocut_toolpath::{Feed, Op, PathMode};

/// The control, the program, its set-up. Steps are compared with those of the first row.
const PARTS: &[(&str, &str, &str)] = &[
    (
        "gsk990mc",
        "O10
G17 G21 G40 G49 G80 G90 G94 G54
T1 M6
S2000 M3
G43 H1 G0 Z30
G99 G81 X20 Y10 R3 Z-2 F150
G91 X20 K3
G80 G90
G49 G0 Z30
T2 M6
S900 M3
G43 H2 G0 Z30
G98 G83 X20 Y10 R3 Z-25 Q10 F120
G99 G73 X40 Q10
G80
G49 G0 Z30
T3 M6
S400 M3
G43 H3 G0 Z30
M29
G98 G84 X20 Y10 R5 Z-18 P500 F500
X40
G80
G49 G0 Z30
T4 M6
S600 M3
G43 H4 G0 Z30
G98 G76 X60 Y10 R2 Z-12 Q0.5 P500 F60
G85 X80
G86 X80 Y40
G89 X60 P300
G80
G49 G0 Z30
M30
",
        "[parameters]\nP270 = 1\nP271 = 1\nP281 = 250\n",
    ),
    (
        "kaitong",
        "O10
G17 G21 G40 G49 G80 G90 G94 G54
T1 M6
S2000 M3
G43 H1 G0 Z30
G99 G81 X20 Y10 R3 Z-2 F150
X80 L3
G80
G49 G0 Z30
T2 M6
S900 M3
G43 H2 G0 Z30
G98 G83 X20 Y10 R3 Z-25 Q10 F120
G99 G73 X40
G80
G49 G0 Z30
T3 M6
S400 M3
G43 H3 G0 Z30
G98 G84 X20 Y10 R5 Z-18 P500 F1.25
X40
G80
G49 G0 Z30
T4 M6
S600 M3
G43 H4 G0 Z30
G98 G76 X60 Y10 R2 Z-12 Q0.5 P500 F60
G85 X80
G86 X80 Y40
G89 X60 P300
G80
G49 G0 Z30
M30
",
        "",
    ),
    (
        "weihong",
        "O10 'without rigid tapping: feed and spindle by themselves
G17 G21 G40 G49 G80 G90 G54
T1 M6
S2000 M3
G43 H1 G0 Z30
G99 G81 X20 Y10 R3 Z-2 F150
G91 X20 K3
G80 G90
G49 G0 Z30
T2 M6
S900 M3
G43 H2 G0 Z30
G98 G83 X20 Y10 R3 Z-25 Q10 F120
G99 G73 X40 Q10
G80
G49 G0 Z30
T3 M6
S400 M3
G43 H3 G0 Z30
G98 G84 X20 Y10 R5 Z-18 P500 F=1.25*400
X40
G80
G49 G0 Z30
T4 M6
S600 M3
G43 H4 G0 Z30
G98 G76 X60 Y10 R2 Z-12 Q0.5 P500 F60
G85 X80
G86 X80 Y40
G89 X60 P300
G80
G49 G0 Z30
M30
",
        "[parameters]\nFIXEDCYCLE_OSS = 1\nAUTOSTOPSPINDLE = 1\n",
    ),
];

/// The tools of the part.
const TOOLS: &str = "[start]\nz = 100.0\n[work_offsets]\nG54 = { x = -200.0, y = -100.0, z = -300.0 }\n\
    [tools.1]\nlength = 80.0\n[tools.2]\nlength = 120.5\n[tools.3]\nlength = 95.25\n[tools.4]\nlength = 110.0\n";

/// The tool that taps.
const TAP: u32 = 3;

/// The steps of a part, less the machine codes that only call a way of tapping, and the spindle within it and
/// behind it: one control leaves the spindle at rest after rigid tapping, another turning, and with a floating
/// holder it turns to and fro. A stroke of rigid tapping is shown as the cut at its feed.
fn steps(dialect: &str, program: &str, setup: &str) -> Vec<String> {
    let dialect = dialects::by_name(dialect).unwrap();
    let (mut steps, alarm) = common::run_on(dialect, program, &format!("{TOOLS}{setup}"));
    assert_eq!(alarm, None, "{}", dialect.name);
    let (mut tool, mut started) = (0, false);
    steps.retain(|step| {
        if let Op::Change(number) = step.op {
            (tool, started) = (number, false);
        }
        // The tap's spindle is started once.
        let is_spindle = matches!(step.op, Op::Spindle(_));
        let of_tapping = tool == TAP && is_spindle && started;
        started |= is_spindle;
        !of_tapping && !matches!(step.op, Op::Machine(_))
    });
    for step in &mut steps {
        if let Op::Tap { to, pitch, rpm, .. } = step.op {
            step.op = Op::Feed { to, feed: Feed::PerMinute(pitch * rpm), path: PathMode::Tapping };
        }
    }
    short(&steps, Position::xyz(0.0, 0.0, 100.0))
}

#[test]
fn the_part_is_the_same_in_every_language() {
    let [(dialect, program, setup), others @ ..] = PARTS else { panic!("no part") };
    let expected = steps(dialect, program, setup);
    // Spot drill four holes, deep drill two, tap two, bore four.
    let count = |start: &str| expected.iter().filter(|line| line.starts_with(start)).count();
    assert_eq!((count("orient"), count("dwell")), (1, 6), "{expected:#?}");
    assert_eq!(count("feed"), 4 + 3 + 3 + 4 + 1 + 2 + 1 + 2, "{expected:#?}");
    assert!(!others.is_empty());
    for (dialect, program, setup) in others {
        assert_eq!(steps(dialect, program, setup), expected, "{dialect}");
    }
}
