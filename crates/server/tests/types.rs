//! The browser's types of commands, answers, events and status: written from those of the control.
//!
//! `FERROCUT_WRITE=1 cargo test -p ferrocut-server types` writes the file, those of HTTP besides; without it a
//! difference fails.
#![allow(missing_docs, clippy::unwrap_used, clippy::panic)]

use ferrocut_controller::Mode;
use ferrocut_controller::api::*;
use std::path::Path;
use ts_rs::{Config, TS};

/// What may be left out of a command or an answer; serde tells it, the type does not.
const LEFT_OUT: [(&str, &str); 17] = [
    ("\nlength: number | null", "\nlength?: number"),
    ("\nlength_wear: number | null", "\nlength_wear?: number"),
    ("\nradius: number | null", "\nradius?: number"),
    ("\nradius_wear: number | null", "\nradius_wear?: number"),
    ("\ncutting_length: number | null", "\ncutting_length?: number"),
    ("\nentry_angle: number | null", "\nentry_angle?: number"),
    ("\ntip_radius: number | null", "\ntip_radius?: number"),
    ("\nadd: boolean", "\nadd?: boolean"),
    ("\ntyped: boolean", "\ntyped?: boolean"),
    ("\npass: number, \n/**\n * ", "\npass?: number, \n/**\n * "),
    ("\nevery: number", "\nevery?: number"),
    ("\nforget: boolean", "\nforget?: boolean"),
    ("\nbefore: number", "\nbefore?: number"),
    ("\npositive: boolean", "\npositive?: boolean"),
    ("\npace: MeasurePace", "\npace?: MeasurePace"),
    ("\nh: number, ", "\nh?: number, "),
    ("\nd: number, ", "\nd?: number, "),
];

const HEAD: &str = "\
// Commands, answers, events and status of the control (docs/api.md).
// Written from crates/controller/src/api by `FERROCUT_WRITE=1 cargo test -p ferrocut-server --test types`.

/** Values by the letters of axes. */
export type ByAxis = { [axis: string]: number };
";

/// What a front says: whatever may be null may be left out.
fn said<T: TS>(config: &Config) -> String {
    let text = declared::<T>(config);
    let optional = |line: &str| match line.contains(" | null") && !line.trim_start().starts_with('*') {
        true => line.replacen(": ", "?: ", 1),
        false => line.to_owned(),
    };
    text.split('\n').map(optional).collect::<Vec<_>>().join("\n")
}

fn declared<T: TS>(config: &Config) -> String {
    let docs = T::docs().unwrap_or_default();
    format!("\n{docs}export {}\n", T::decl(config))
}

fn written() -> String {
    let config = Config::new().with_large_int("number");
    let mut text = HEAD.to_owned();
    macro_rules! declare {
        ($how:ident: $($name:ty),+ $(,)?) => { $(text += &$how::<$name>(&config);)+ };
    }
    declare!(
        declared:
        Mode,
        Activity,
        RelativeTo,
        OffsetValues,
        AlarmInfo,
        Refusal,
        ProgramInfo,
        PastAlarm,
        LogLine,
        ForcedSignal,
        NamedSignal,
        NextBlock,
        StopAt,
        Positions,
        FeedStatus,
        SpindleStatus,
        ProgramStatus,
        SwitchStatus,
        Counters,
        DncStatus,
        Status,
        ToolMode,
        Measurement,
        InterruptedBlock,
        RestartDifference,
        RestartMove,
        RestartPlan,
        Reply,
        Event,
    );
    declare!(said: TraceEdge, TraceTrigger, CaptureTrigger, MeasureForm, MeasurePace, MeasureWork, MeasureTool, Command);
    for (always, optional) in LEFT_OUT {
        assert!(text.contains(always), "{always:?} is not there any more");
        text = text.replace(always, optional);
    }
    // Nothing is said behind the end of a line.
    text.lines().map(|line| format!("{}\n", line.trim_end())).collect()
}

#[test]
fn the_browser_has_the_types_of_the_control() {
    let file = Path::new(env!("CARGO_MANIFEST_DIR")).join("../../hmi/src/lib/api/types.ts");
    let text = written();
    if std::env::var_os("FERROCUT_WRITE").is_some() {
        std::fs::create_dir_all(file.parent().unwrap()).unwrap();
        std::fs::write(&file, &text).unwrap();
    }
    let found = std::fs::read_to_string(&file).unwrap_or_default();
    assert!(found == text, "{} is not that of the control: write it anew", file.display());
}

#[test]
fn every_type_that_is_named_is_declared() {
    let text = written();
    for name in
        ["Status", "AlarmInfo", "ProgramInfo", "PastAlarm", "LogLine", "Mode", "Activity", "OffsetValues"]
    {
        assert!(text.contains(&format!("export type {name} = ")), "{name}");
    }
    assert!(!text.contains("bigint"), "numbers of JSON are numbers");
}
