//! Whatever the bytes: a drawing or one alarm, without a panic, in bounded time and memory.
#![allow(missing_docs, clippy::unwrap_used, clippy::panic)]

use ferrocut_exchange::write::{Ends, write};
use ferrocut_exchange::{Format, Order, Settings, Style, plan::plan, read};
use ferrocut_program::FileId;
use proptest::prelude::*;

const PLT: &str = "\x1b.(;IN;SP1;PU400,0;PD;AA0,0,90,5;AR-400,0,-180;PU800,800;CI200;EA1200,800;\n\
    ER-200,200;EW400,0,90;PA;PR10,10 20,20;LBtext\x03;PD1200 800,1200,1600;PU0,0;SP2;VS10;PD40.5,-.5;";

const DXF: &str = include_str!("everything.dxf");

/// Reads, plans both ways and writes; what comes out is sound.
fn whole_way(bytes: &[u8], format: Format) -> Result<(), TestCaseError> {
    for three_dimensional in [false, true] {
        let settings = Settings { three_dimensional, ..Settings::default() };
        let drawing = match read(bytes, format, FileId(1), &settings) {
            Ok(drawing) => drawing,
            Err(alarm) => {
                prop_assert!(alarm.span.offset <= bytes.len() as u64, "{:?}", alarm);
                continue;
            }
        };
        prop_assert!(drawing.warnings.len() < 1000);
        for order in [Order::AsDrawn, Order::Shortest] {
            let moves = plan(&drawing, order);
            let style = Style::of("gsk990mc").unwrap();
            let program = write(&moves, &drawing, &settings, style, "x", Ends::Raised);
            prop_assert_eq!(program.text.lines().count(), program.origins.len());
            prop_assert!(program.text.is_ascii() || !bytes.is_ascii());
            prop_assert!(!program.text.contains("NaN") && !program.text.contains("inf"));
        }
    }
    Ok(())
}

/// A file with some of its bytes changed, doubled or cut off.
fn mutated(text: &'static str) -> impl Strategy<Value = Vec<u8>> {
    let edit = (any::<prop::sample::Index>(), any::<prop::sample::Index>(), 0u8..6, any::<u8>());
    prop::collection::vec(edit, 1..12).prop_map(move |edits| {
        let mut bytes = text.as_bytes().to_vec();
        for (at, to, kind, byte) in edits {
            if bytes.is_empty() {
                break;
            }
            let (a, b) = (at.index(bytes.len()), to.index(bytes.len()));
            let (low, high) = (a.min(b), (a.max(b)).min(a.min(b) + 200));
            match kind {
                0 => bytes[a] = byte,
                1 => bytes[a] = b"0123456789-.;,\n"[usize::from(byte) % 15],
                2 => drop(bytes.drain(low..high)),
                3 => {
                    let piece = bytes[low..high].to_vec();
                    bytes.splice(b..b, piece);
                }
                4 => bytes.truncate(bytes.len() - a.min(40)),
                _ => bytes.insert(a, b"9e"[usize::from(byte) % 2]),
            }
        }
        bytes
    })
}

/// A DXF file with some of its values replaced by others that a file might hold.
fn other_values() -> impl Strategy<Value = Vec<u8>> {
    let values = prop::sample::select(vec![
        "0",
        "-1",
        "1",
        "3",
        "32767",
        "-32768",
        "2147483647",
        "1e308",
        "-1e308",
        "1e-308",
        "0.5",
        "B",
        "A",
        "^",
        "^x",
        "LINE",
        "SPLINE",
        "ENDSEC",
        "EOF",
        "BLOCK",
        "VERTEX",
        "SEQEND",
        "10",
        "40",
        "70",
        "\\U+0000",
        "",
    ]);
    prop::collection::vec((any::<prop::sample::Index>(), values), 1..20).prop_map(|edits| {
        let mut lines: Vec<&str> = DXF.lines().collect();
        for (at, value) in edits {
            let at = at.index(lines.len());
            lines[at] = value;
        }
        lines.join("\n").into_bytes()
    })
}

proptest! {
    #![proptest_config(ProptestConfig { failure_persistence: None, ..ProptestConfig::with_cases(2000) })]

    #[test]
    fn random_bytes(bytes in prop::collection::vec(any::<u8>(), 0..400)) {
        whole_way(&bytes, Format::Plt)?;
        whole_way(&bytes, Format::Dxf)?;
    }

    #[test]
    fn random_instructions(text in "((PU|PD|PA|PR|AA|AR|CI|EA|ER|EW|SP|LB|PE|DT|IN)[-0-9., ]{0,12};?){0,30}") {
        whole_way(text.as_bytes(), Format::Plt)?;
    }

    #[test]
    fn changed_plt(bytes in mutated(PLT)) {
        whole_way(&bytes, Format::Plt)?;
    }

    #[test]
    fn changed_dxf(bytes in mutated(DXF)) {
        whole_way(&bytes, Format::Dxf)?;
    }

    #[test]
    fn dxf_with_other_values(bytes in other_values()) {
        whole_way(&bytes, Format::Dxf)?;
    }
}

/// Every place at which a file may be cut off. A DXF drawing says where it ends; a plot does not.
#[test]
fn drawings_that_are_cut_off() {
    for len in 0..PLT.len() {
        whole_way(&PLT.as_bytes()[..len], Format::Plt).unwrap();
    }
    for len in 0..DXF.trim_end().len() {
        let cut = &DXF.as_bytes()[..len];
        assert!(read(cut, Format::Dxf, FileId(1), &Settings::default()).is_err(), "{len}");
    }
    assert!(read(DXF.as_bytes(), Format::Dxf, FileId(1), &Settings::default()).is_ok());
}
