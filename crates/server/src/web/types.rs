//! The browser's types of what is asked and answered over HTTP: written from those of the server and the editor.
//!
//! `FERROCUT_WRITE=1 cargo test -p ferrocut-server types` writes the files, those of the control among them
//! (`tests/types.rs`); without it a difference fails.

use super::backups::Backup;
use super::check::Findings;
use super::cycles::{Drawing, Drawn, Written};
use super::dnc::DncFile;
use super::problem::Trouble;
use super::tables::{
    AlarmText, Bit, Explanation, Fact, Found, Parameter, ParameterKind, Signal, Table, Word,
};
use crate::told::{Asking, ConnectionCommand, ConnectionEvent, Hello, PanelInfo, SessionInfo};
use ferrocut_editor::form::{Choice, FigureForm, Form, FormField, Fresh, ProfileUse};
use ferrocut_editor::request::{
    Contour, Corner, CornerKind, Depth, DepthPlane, Element, Positions, Profile, Request, ToolData, Value,
};
use std::path::Path;
use ts_rs::{Config, TS};

const ANSWERS: &str = "\
// What the server answers over HTTP (docs/panel-api.md).
// Written from crates/server/src/web/ and crates/desk by `FERROCUT_WRITE=1 cargo test -p ferrocut-server types`.
import type { Refusal } from './types';
";

const CONNECTION: &str = "\
// What connections tell and are told besides the control's own (docs/serve.md).
// Written from crates/server/src/told.rs by `FERROCUT_WRITE=1 cargo test -p ferrocut-server types`.
";

const CYCLES: &str = "\
// What the cycle editor asks and is answered (docs/cycles.md).
// Written from crates/editor by `FERROCUT_WRITE=1 cargo test -p ferrocut-server types`.
";

/// What may be left out of a form that is sent; serde tells it, the type does not.
const LEFT_OUT: [(&str, &str); 8] = [
    ("\nentry: number", "\nentry?: number"),
    ("\nexit: number", "\nexit?: number"),
    ("\ndiameter: number | null", "\ndiameter?: number | null"),
    ("\ncutting_length: number | null", "\ncutting_length?: number | null"),
    ("\nentry_angle: number | null", "\nentry_angle?: number | null"),
    ("\ntip_radius: number | null", "\ntip_radius?: number | null"),
    ("\nprofile: Profile | null", "\nprofile?: Profile | null"),
    ("\ncorner: Corner | null", "\ncorner?: Corner | null"),
];

/// What only a browser's first line has.
const NOT_SAID: [(&str, &str); 2] = [
    ("\npanel: PanelInfo | null", "\npanel?: PanelInfo"),
    ("\nsession: SessionInfo | null", "\nsession?: SessionInfo"),
];

/// What is not always in an answer.
const NOT_TOLD: [(&str, &str); 5] = [
    ("\nerror: string | null", "\nerror?: string"),
    ("\ndetail: string | null", "\ndetail?: string"),
    ("\nrefused: Refusal | null", "\nrefused?: Refusal"),
    ("\nprogram: string | null", "\nprogram?: string"),
    ("\npage: unknown", "\npage?: unknown"),
];

fn declared<T: TS>(config: &Config) -> String {
    let docs = T::docs().unwrap_or_default();
    format!("\n{docs}export {}\n", T::decl(config))
}

macro_rules! written {
    ($head:expr; $($name:ty),+ $(,)?) => {{
        let config = Config::new().with_large_int("number");
        let mut text = $head.to_owned();
        $(text += &declared::<$name>(&config);)+
        text
    }};
}

/// A file with what may be left out of it. Nothing is said behind the end of a line.
fn finished(mut text: String, left_out: &[(&str, &str)]) -> String {
    for (always, optional) in left_out {
        assert!(text.contains(always), "{always:?} is not there any more");
        text = text.replace(always, optional);
    }
    text.lines().map(|line| format!("{}\n", line.trim_end())).collect()
}

fn answers() -> String {
    let text = written!(
        ANSWERS;
        Trouble,
        ferrocut_desk::finding::Finding,
        Findings,
        AlarmText,
        Fact,
        Table,
        Explanation,
        Word,
        Bit,
        ParameterKind,
        Parameter,
        Signal,
        Found,
        Backup,
        DncFile,
    );
    finished(text, &NOT_TOLD)
}

fn connection() -> String {
    let text =
        written!(CONNECTION; SessionInfo, PanelInfo, Hello, Asking, ConnectionEvent, ConnectionCommand);
    finished(text, &NOT_SAID)
}

fn cycles() -> String {
    let text = written!(
        CYCLES;
        Value,
        Fresh,
        Choice,
        FormField,
        FigureForm,
        ProfileUse,
        Form,
        CornerKind,
        Corner,
        Element,
        Contour,
        DepthPlane,
        Depth,
        Profile,
        Positions,
        ToolData,
        Request,
        ferrocut_editor::Finding,
        Written,
        Drawn,
        Drawing,
    );
    finished(text, &LEFT_OUT)
}

#[test]
fn the_browser_has_the_types_of_the_answers() {
    for (name, text) in [("answers", answers()), ("connection", connection()), ("cycles", cycles())] {
        assert!(!text.contains("bigint"), "numbers of JSON are numbers");
        let file = Path::new(env!("CARGO_MANIFEST_DIR")).join(format!("../../hmi/src/lib/api/{name}.ts"));
        if std::env::var_os("FERROCUT_WRITE").is_some() {
            std::fs::write(&file, &text).unwrap();
        }
        let found = std::fs::read_to_string(&file).unwrap_or_default();
        assert!(found == text, "{} is not that of the server: write it anew", file.display());
    }
}
