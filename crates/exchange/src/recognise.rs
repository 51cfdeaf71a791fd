//! Telling a drawing from a part program.

use crate::settings::Format;
use std::path::Path;

/// What a drawing was recognised by.
#[derive(Clone, Copy, PartialEq, Eq, Debug)]
pub enum By {
    /// The end of its name.
    Name,
    /// What it begins with.
    Content,
}

/// Bytes at the start of a file that are looked at.
pub const LOOKED_AT: usize = 4096;

/// Instructions that a plot begins with.
const FIRST: &[&[u8; 2]] = &[b"IN", b"DF", b"SP", b"PU", b"PD", b"PA", b"PR", b"VS", b"IP", b"PS", b"BP"];

/// The kind of drawing that a file is; `None` for what is no drawing.
pub fn recognise(path: &Path, start: &[u8]) -> Option<(Format, By)> {
    let extension = path.extension().map(|e| e.to_string_lossy().to_lowercase());
    let named = match extension.as_deref() {
        Some("plt" | "hpgl" | "hpg" | "hgl") => Some(Format::Plt),
        Some("dxf") => Some(Format::Dxf),
        _ => None,
    };
    if let Some(format) = named {
        return Some((format, By::Name));
    }
    let start = start.get(..LOOKED_AT).unwrap_or(start);
    if is_dxf(start) {
        return Some((Format::Dxf, By::Content));
    }
    is_plt(start).then_some((Format::Plt, By::Content))
}

/// A first pair `0`, `SECTION`, comments before it.
fn is_dxf(start: &[u8]) -> bool {
    if start.starts_with(b"AutoCAD Binary DXF") {
        return true;
    }
    let start = start.strip_prefix(b"\xEF\xBB\xBF").unwrap_or(start);
    let mut lines = start.split(|b| *b == b'\n').map(<[u8]>::trim_ascii);
    loop {
        match (lines.next(), lines.next()) {
            (Some(b"999"), Some(_)) => {}
            (Some(b"0"), Some(value)) => return value == b"SECTION",
            _ => return false,
        }
    }
}

/// Two instructions of plotters; no control's program begins with a word of two letters before numbers.
fn is_plt(start: &[u8]) -> bool {
    if start.starts_with(b"\x1B.") || start.starts_with(b"\x1B%") {
        return true;
    }
    let is_end = |b: &u8| matches!(b, b';' | b'\r' | b'\n');
    let mut parts = start.split(is_end).map(<[u8]>::trim_ascii).filter(|part| !part.is_empty());
    let instruction = |part: &[u8]| {
        let [a, b, rest @ ..] = part else { return false };
        let name = [a.to_ascii_uppercase(), b.to_ascii_uppercase()];
        let values = |b: &u8| b.is_ascii_digit() || matches!(b, b',' | b' ' | b'-' | b'+' | b'.');
        FIRST.contains(&&name) && rest.iter().all(values)
    };
    parts.next().is_some_and(instruction) && parts.next().is_none_or(instruction)
}

#[cfg(test)]
mod tests {
    use super::*;

    fn kind(name: &str, start: &str) -> Option<(Format, By)> {
        recognise(Path::new(name), start.as_bytes())
    }

    #[test]
    fn drawings_are_told_by_name_and_by_content() {
        assert_eq!(kind("a.PLT", ""), Some((Format::Plt, By::Name)));
        assert_eq!(kind("a.dxf", ""), Some((Format::Dxf, By::Name)));
        assert_eq!(kind("-", "IN;SP1;PU0,0;"), Some((Format::Plt, By::Content)));
        assert_eq!(kind("a.nc", "PU0,0;\nPD1,1"), Some((Format::Plt, By::Content)));
        assert_eq!(kind("a.nc", "\x1b.(;IN"), Some((Format::Plt, By::Content)));
        assert_eq!(kind("-", "999\nx\n  0\r\nSECTION\r\n"), Some((Format::Dxf, By::Content)));
    }

    #[test]
    fn programs_are_no_drawings() {
        for program in
            ["O1\nG0 X1\n", "%\nO1", "G0 X1", "IF[1EQ1]GOTO1", "(IN)", "PRG NAME\nG0", "", "0\n1\n", "#1=2"]
        {
            assert_eq!(kind("a.nc", program), None, "{program}");
        }
    }
}
