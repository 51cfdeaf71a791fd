//! Program memory: finding programs, pages and their boundaries, files held and read in windows.

#![allow(missing_docs, clippy::unwrap_used, clippy::panic)]

mod common;

use common::{FlatBlock, MACRO_B, flat, pages};
use ferrocut_program::{
    DefectKind, FileId, OpenError, Place, ProgramId, ProgramMemory, Span, Syntax, Text, lexer,
};
use std::fmt::Write as _;
use std::fs;
use std::io::{self, Read};
use std::path::Path;

fn held(text: &str) -> Text {
    Text::from_bytes(text.as_bytes().to_vec()).unwrap()
}

fn write(folder: &Path, name: &str, text: impl AsRef<[u8]>) {
    fs::write(folder.join(name), text).unwrap();
}

/// Where a program starts: name of its file and text of its block.
fn find(memory: &mut ProgramMemory, id: ProgramId) -> Option<(String, String)> {
    let place = memory.find_program(&id).unwrap()?;
    let page = memory.page(place.file, place.page).unwrap().unwrap();
    let block = page.blocks.get(place.block as usize).copied().unwrap_or_default();
    let name = Path::new(memory.file_name(place.file)).file_name().unwrap().to_string_lossy().into_owned();
    Some((name, memory.slice(page.block_span(&block))))
}

fn number(memory: &mut ProgramMemory, number: u32) -> Option<(String, String)> {
    find(memory, ProgramId::Number(number))
}

fn named(memory: &mut ProgramMemory, name: &str) -> Option<(String, String)> {
    find(memory, ProgramId::Name(name.into()))
}

fn at(file: &str, block: &str) -> Option<(String, String)> {
    Some((file.to_string(), block.to_string()))
}

#[test]
fn programs_in_the_main_file() {
    let text = "%\nO1\nM98 P2\nM30\nO0002 (a)\nM99\n/o3 X1\n#1=2\nN5 O4\nO-5\nO6.5\nO#7\nO2 X9\nO8\n%\n";
    let mut memory = ProgramMemory::new("main.nc", held(text), &MACRO_B);
    assert_eq!(number(&mut memory, 1), at("main.nc", "O1"));
    assert_eq!(number(&mut memory, 2), at("main.nc", "O0002"));
    assert_eq!(number(&mut memory, 3), at("main.nc", "/o3 X1"));
    for missing in [0, 4, 5, 6, 7, 9] {
        assert_eq!(number(&mut memory, missing), None, "{missing}");
    }
    assert_eq!(number(&mut memory, 8), at("main.nc", "O8"));
    assert_eq!(named(&mut memory, "main"), None);
}

#[test]
fn a_file_that_is_only_shown_holds_no_program() {
    let mut memory = ProgramMemory::new("main.nc", held("O1\nM30\n"), &MACRO_B);
    let shown = memory.add_shown("O200.plt", held("PU0,0;\nO7 X1\n"));
    assert_eq!((number(&mut memory, 200), number(&mut memory, 7)), (None, None));
    assert_eq!(named(&mut memory, "o200"), None);
    let span = Span { offset: 0, len: 6, line: 1, file: shown };
    assert_eq!(memory.slice(span), "PU0,0;");
}

#[test]
fn programs_in_the_folder() {
    let folder = tempfile::tempdir().unwrap();
    let beside = |name: &str, text: &str| write(folder.path(), name, text);
    beside("main.nc", "O1 X0\nO2 X0\nM30\n");
    beside("O1002.nc", "(no O word)\nX1002\nM99\n");
    beside("1003.NC", "O1003 X1003\nM99\n");
    beside("library.nc", "X-1\nO2 X-2\nO5 X5\nO1004 X-4\nM99\n");
    beside("O1004.tap", "X1004\nM99\n");
    beside("o01005.cnc", "X1005\nO1005 Y1005\n");
    beside("+7.nc", "X7\n");
    beside("notes.md", "O77\n");
    beside("empty.nc", "");
    beside("Bohren.nc", "X99\nM99\n");
    fs::create_dir(folder.path().join("O1009.nc")).unwrap();
    write(folder.path(), "picture.txt", b"\x89PNG\r\n\x1a\n\0\0\0\rIHDR");

    let mut memory = ProgramMemory::open(&folder.path().join("main.nc"), &MACRO_B).unwrap();
    // Opening a library by name must not change what a number means later.
    assert_eq!(named(&mut memory, "library"), at("library.nc", "X-1"));
    let cases = [
        (1, at("main.nc", "O1 X0")),
        (2, at("main.nc", "O2 X0")),
        (1002, at("O1002.nc", "X1002")),
        (1003, at("1003.NC", "O1003 X1003")),
        (1004, at("O1004.tap", "X1004")),
        (1005, at("o01005.cnc", "O1005 Y1005")),
        (5, at("library.nc", "O5 X5")),
        (7, None),
        (77, None),
        (1009, None),
        (4_000_000_000, None),
    ];
    for (n, expected) in cases.iter().chain(cases.iter().rev()) {
        assert_eq!(number(&mut memory, *n), *expected, "{n}");
    }
    assert_eq!(named(&mut memory, "BOHREN"), at("Bohren.nc", "X99"));
    assert_eq!(named(&mut memory, "bohren"), at("Bohren.nc", "X99"));
    assert_eq!(named(&mut memory, "o1002"), at("O1002.nc", "X1002"));
    for missing in ["empty", "notes", "picture", "", "main", "nothing"] {
        assert_eq!(named(&mut memory, missing), None, "{missing}");
    }
}

#[test]
fn a_file_of_the_folder_is_opened_once() {
    let folder = tempfile::tempdir().unwrap();
    write(folder.path(), "main.nc", "M30\n");
    write(folder.path(), "1002.nc", "X1\n");
    write(folder.path(), "1003.nc", "X1\n");
    let mut memory = ProgramMemory::open(&folder.path().join("main.nc"), &MACRO_B).unwrap();
    for _ in 0..100 {
        let id = ProgramId::Number(1003);
        assert_eq!(memory.find_program(&id).unwrap(), Some(Place { file: FileId(1), page: 0, block: 0 }));
        let id = ProgramId::Name("1002".into());
        assert_eq!(memory.find_program(&id).unwrap(), Some(Place { file: FileId(2), page: 0, block: 0 }));
    }
    assert_eq!(memory.file_name(FileId(3)), "");
    // One that is gone before it is opened is a program that is not there.
    write(folder.path(), "1004.nc", "X1\n");
    let mut memory = ProgramMemory::open(&folder.path().join("main.nc"), &MACRO_B).unwrap();
    assert_eq!(number(&mut memory, 1), None);
    fs::remove_file(folder.path().join("1004.nc")).unwrap();
    assert_eq!(number(&mut memory, 1004), None);
}

#[test]
fn programs_in_files_added() {
    let mut memory = ProgramMemory::new("1.nc", held("O5 X5\nM30\n"), &MACRO_B);
    let library = memory.add("lib/Parts.nc", held("X1\nO5 X-5\nO6 X6\n"));
    memory.add("O7.nc", held("X7\n"));
    memory.add("O6.nc", held("(six)\nX66\n"));
    assert_eq!(library, FileId(1));
    assert_eq!(number(&mut memory, 5), at("1.nc", "O5 X5"));
    assert_eq!(number(&mut memory, 6), at("O6.nc", "X66"));
    assert_eq!(number(&mut memory, 7), at("O7.nc", "X7"));
    assert_eq!(named(&mut memory, "parts"), at("Parts.nc", "X1"));
    assert_eq!(number(&mut memory, 1), None);
    for _ in 4..u16::MAX {
        assert!(memory.add("", held("X1")) < FileId(u16::MAX));
    }
    let over = memory.add("", held("X1"));
    assert_eq!(over, FileId(u16::MAX));
    assert!(memory.page(over, 0).unwrap().is_none() && memory.text(over).is_none());
}

/// A program of mixed blocks with this line end, about `bytes` long.
fn program(bytes: usize, end: &str) -> String {
    let mut text = format!("%{end}O1000 (铣削){end}");
    let mut i = 0;
    while text.len() < bytes {
        let x = f64::from(i) * 0.1;
        match i % 7 {
            0 => write!(text, "N{i} G01 X{x:.3} Y{:.3};Z{:.3}{end}", x * 0.5, -x).unwrap(),
            1 => write!(text, "#1=#[{i}]*SIN[#2]{end}").unwrap(),
            2 => write!(text, "/2X[#1+{i}],R5 (换刀 {i}){end}{end}").unwrap(),
            3 => write!(text, "IF[#1GT{i}]GOTO{i}{end}").unwrap(),
            4 => write!(text, "X1.2.3 @ {}{end}", "(long)".repeat(i as usize % 50)).unwrap(),
            5 => write!(text, ";;{end}X1(open{end}").unwrap(),
            _ => write!(text, "{}X{i}{end}", " ".repeat(i as usize % 5000)).unwrap(),
        }
        i += 1;
    }
    write!(text, "M30{end}%{end}").unwrap();
    text
}

fn whole(text: &[u8]) -> Vec<FlatBlock> {
    let lexed = lexer::lex(text, FileId(0), 0, 1, true, &MACRO_B);
    assert_eq!(lexed.consumed, text.len());
    common::check(text, &lexed.page);
    flat([&lexed.page])
}

fn streamed(text: Text) -> Vec<FlatBlock> {
    let mut memory = ProgramMemory::new("", text, &MACRO_B);
    let pages = pages(&mut memory, FileId(0));
    flat(pages.iter().map(|p| &**p))
}

#[test]
fn pages_neither_split_nor_lose_a_block() {
    for end in ["\n", "\r\n", "\r"] {
        let text = program(lexer::MAX_TEXT - 20_000, end);
        assert!(text.len() > 200_000 && text.len() <= lexer::MAX_TEXT);
        let expected = whole(text.as_bytes());
        assert_eq!(streamed(held(&text)), expected, "{end:?}");
        // Every position of the boundary within a line.
        for shift in 0..60 {
            let text = format!("{}{}", " ".repeat(shift), &text[..100_000]);
            assert_eq!(streamed(held(&text)), whole(text.as_bytes()), "{end:?} {shift}");
        }
    }
}

#[test]
fn files_held_and_read_in_windows_give_the_same() {
    let text = program(5 << 20, "\r\n");
    let folder = tempfile::tempdir().unwrap();
    write(folder.path(), "big.nc", &text);
    let expected = streamed(held(&text));
    assert_eq!(expected.last().map(|b| b.is_mark), Some(true));
    assert_eq!(streamed(Text::open(&folder.path().join("big.nc")).unwrap()), expected);
    let pipe = Slow(text.as_bytes());
    let pipe = Text::from_reader(pipe).unwrap();
    assert_eq!((pipe.len(), pipe.encoding().name()), (text.len() as u64, "UTF-8"));
    assert_eq!(streamed(pipe), expected);
    let small = program(1000, "\n");
    assert_eq!(streamed(Text::from_reader(Slow(small.as_bytes())).unwrap()), streamed(held(&small)));
}

/// A reader that gives odd pieces, as a pipe does.
struct Slow<'a>(&'a [u8]);

impl Read for Slow<'_> {
    fn read(&mut self, buffer: &mut [u8]) -> io::Result<usize> {
        let len = buffer.len().min(4099);
        self.0.read(&mut buffer[..len])
    }
}

#[test]
fn a_page_given_up_is_lexed_again_the_same() {
    let text = program(1 << 20, "\n") + &"#1=#2+3 X@\nN1G1X1Y2Z3\n".repeat(1 << 20);
    let mut memory = ProgramMemory::new("", held(&text), &MACRO_B);
    let first: Vec<_> = (0..5).map(|n| memory.page(FileId(0), n).unwrap().unwrap()).collect();
    let count = pages(&mut memory, FileId(0)).len();
    assert!(count > 300);
    for (number, page) in first.iter().enumerate() {
        let again = memory.page(FileId(0), number as u32).unwrap().unwrap();
        assert!(!std::sync::Arc::ptr_eq(&again, page), "page {number} was kept");
        assert_eq!(again, *page);
    }
    assert_eq!(pages(&mut memory, FileId(0)).len(), count);
    assert!(memory.page(FileId(0), u32::MAX).unwrap().is_none());
    assert!(memory.page(FileId(9), 0).unwrap().is_none());
}

#[test]
fn a_line_longer_than_a_page_is_one_defect_and_the_next_is_read() {
    const PAGE: usize = 1 << 16;
    for end in ["\n", "\r\n", "\r"] {
        // Where the line ends: around the end of its page and of those after it.
        for len in (PAGE - 4..PAGE + 4).chain(2 * PAGE - 4..2 * PAGE + 4).chain([5 * PAGE]) {
            for head in ["", "G0 X1"] {
                let before = if head.is_empty() { String::new() } else { format!("{head}{end}") };
                let text = format!("{before}{}{end}{end}G1 X2{end}", "X1".repeat(len / 2));
                let blocks = streamed(held(&text));
                let line = if head.is_empty() { 1 } else { 2 };
                let found: Vec<_> = blocks.iter().map(|b| (b.line, b.words.len(), b.defects.len())).collect();
                let mut expected = vec![(line, 0, 1), (line + 2, 2, 0)];
                if !head.is_empty() {
                    expected.insert(0, (1, 2, 0));
                }
                assert_eq!(found, expected, "{end:?} {len} {head:?}");
                let defect = blocks[expected.len() - 2].defects[0];
                assert_eq!(defect, (DefectKind::LineTooLong, before.len() as u64, 80));
                let last = blocks.last().unwrap();
                assert_eq!(last.offset as usize, text.len() - 5 - end.len());
            }
        }
    }
    assert_eq!(streamed(held(&"X1".repeat(300_000))).len(), 1);
}

#[test]
fn the_longest_line_of_a_page_is_read() {
    const WIDE: Syntax = Syntax { max_line: usize::MAX, ..MACRO_B };
    for end in ["\n", "\r\n", "\r"] {
        for (len, defects) in [(lexer::MAX_LINE, 0), (lexer::MAX_LINE + 1, 1)] {
            let text = format!("G0{end}G1 X{}5{end}G2{end}", "0".repeat(len - 5));
            let mut memory = ProgramMemory::new("", held(&text), &WIDE);
            let blocks = flat(pages(&mut memory, FileId(0)).iter().map(|p| &**p));
            assert_eq!(blocks.len(), 3, "{end:?}");
            assert_eq!(blocks[1].defects.len(), defects, "{end:?} {len}");
            if defects == 0 {
                assert_eq!(usize::from(blocks[1].words[1].1), len - 3);
            }
        }
    }
}

#[test]
fn a_mark_behind_pages_of_comments_opens_the_program() {
    let text = format!("{}%\nO1\nM30\n%\n", "(tool list)\n".repeat(20_000));
    let blocks = streamed(held(&text));
    let found: Vec<_> = blocks.iter().map(|b| (b.line, b.is_mark)).collect();
    assert_eq!(found, [(20_002, false), (20_003, false), (20_004, true)]);
}

#[test]
fn byte_order_marks_and_encodings() {
    let text = "% \nO1 (铣削平面 精加工)\nG0 X1\nM30\n%\n";
    let gb = encoding_rs::GB18030.encode(text).0.into_owned();
    let with = |mark: &[u8], text: &[u8]| [mark, text].concat();
    for (bytes, name, mark) in [
        (text.as_bytes().to_vec(), "UTF-8", 0),
        (with(b"\xEF\xBB\xBF", text.as_bytes()), "UTF-8", 3),
        (gb.clone(), "gb18030", 0),
        (with(b"\x84\x31\x95\x33", &gb), "gb18030", 4),
        // Chinese far behind the first 64 KiB.
        (with(&b"G0 X1\n".repeat(100_000), &gb), "gb18030", 0),
    ] {
        let text = Text::from_bytes(bytes).unwrap();
        assert_eq!((text.encoding().name(), text.encoding().mark), (name, mark));
        let mut memory = ProgramMemory::new("", text, &MACRO_B);
        let blocks = flat(pages(&mut memory, FileId(0)).iter().map(|p| &**p));
        assert!(blocks.iter().all(|b| b.defects.is_empty()));
        let last = blocks.last().unwrap();
        assert!(last.is_mark && !blocks[0].is_mark && blocks.iter().filter(|b| b.is_mark).count() < 3);
        let place = memory.find_program(&ProgramId::Number(1)).unwrap().unwrap();
        let page = memory.page(place.file, place.page).unwrap().unwrap();
        let block = page.blocks[place.block as usize];
        let span = Span { len: 40, ..page.block_span(&block) };
        assert!(memory.slice(span).starts_with("O1 (铣削平面 精加工)\n"), "{}", memory.slice(span));
    }
}

#[test]
fn what_is_no_program_text_is_told() {
    let kind = |bytes: &[u8]| match Text::from_bytes(bytes.to_vec()) {
        Ok(_) => "text",
        Err(OpenError::Empty) => "empty",
        Err(OpenError::NotText) => "not text",
        Err(OpenError::Utf16) => "utf-16",
        Err(_) => "other",
    };
    for (bytes, expected) in [
        (&b""[..], "empty"),
        (b" \r\n\t", "empty"),
        (b"\xEF\xBB\xBF\n", "empty"),
        (b"\0\0\n\0", "empty"),
        (b"G0", "text"),
        (b"\0\0\n\0G0\n\0\0", "text"),
        (b"G0 X1\n\x1A", "text"),
        (b"\xFF\xFEG\x000\x00", "utf-16"),
        (b"G\x000\x00\n\x00", "not text"),
        (b"\x7FELF\x02\x01\x01\0\0", "not text"),
        (b"\x89PNG\r\n\x1a\n\0\0\0\rIHDR", "not text"),
    ] {
        assert_eq!(kind(bytes), expected, "{bytes:?}");
    }
    assert_eq!(kind(&vec![0; 5 << 20]), "not text");
    let folder = tempfile::tempdir().unwrap();
    assert!(matches!(Text::open(folder.path()), Err(OpenError::Folder)));
    assert!(matches!(Text::open(&folder.path().join("none")), Err(OpenError::Io(_))));
    write(folder.path(), "empty.nc", "");
    assert!(matches!(Text::open(&folder.path().join("empty.nc")), Err(OpenError::Empty)));
    // An endless device ends in a result.
    if cfg!(target_os = "linux") {
        assert!(matches!(Text::open(Path::new("/dev/zero")), Err(OpenError::NotText)));
        assert!(matches!(Text::open(Path::new("/dev/urandom")), Err(OpenError::NotText)));
        assert!(matches!(Text::open(Path::new("/dev/null")), Err(OpenError::Empty)));
    }
}

#[test]
fn a_file_that_becomes_shorter_ends_there() {
    let folder = tempfile::tempdir().unwrap();
    let path = folder.path().join("big.nc");
    fs::write(&path, "G0 X1\n".repeat(1 << 20)).unwrap();
    let mut memory = ProgramMemory::open(&path, &MACRO_B).unwrap();
    let first = memory.page(FileId(0), 0).unwrap().unwrap();
    let end = first.blocks.len() * 6;
    fs::OpenOptions::new().write(true).open(&path).unwrap().set_len(end as u64 + 4).unwrap();
    let rest = pages(&mut memory, FileId(0));
    assert_eq!(rest.len(), 2);
    assert_eq!((rest[1].blocks.len(), rest[1].blocks[0].is_defective), (1, true));
    let beyond = Span { offset: 1 << 21, len: 5, line: 1, file: FileId(0) };
    let text = memory.text(FileId(0)).unwrap();
    assert_eq!(text.slice(beyond).unwrap(), b"");
    assert_eq!(text.line_of(beyond, 100).unwrap(), (Vec::new(), 0));
}

#[test]
fn the_line_of_a_span_is_shown() {
    let text = held("\u{FEFF}G0 X1\r\nG1 Y2 Z3\rM30\n");
    let line = |offset: u64, most| {
        let span = Span { offset, len: 1, line: 1, file: FileId(0) };
        let (bytes, at) = text.line_of(span, most).unwrap();
        (String::from_utf8(bytes).unwrap(), at)
    };
    assert_eq!(line(3, 100), ("G0 X1".to_string(), 0));
    assert_eq!(line(6, 100), ("G0 X1".to_string(), 3));
    assert_eq!(line(13, 100), ("G1 Y2 Z3".to_string(), 3));
    assert_eq!(line(13, 4), ("1 Y2".to_string(), 2));
    assert_eq!(line(10, 4), ("G1 Y".to_string(), 0));
    assert_eq!(line(13, 0), (String::new(), 0));
    assert_eq!(line(13, usize::MAX), ("G1 Y2 Z3".to_string(), 3));
    assert_eq!(line(19, 100), ("M30".to_string(), 0));
    assert_eq!(line(9999, 100), (String::new(), 0));
}

#[test]
fn a_text_can_be_read_from_several_threads() {
    let mut bytes = Vec::new();
    for i in 0..700_000 {
        writeln_to(&mut bytes, i);
    }
    let text = Text::from_reader(bytes.as_slice()).unwrap();
    std::thread::scope(|scope| {
        for thread in 0..4 {
            let text = &text;
            scope.spawn(move || {
                for i in (thread..700_000).step_by(997) {
                    let span = Span { offset: i * 10, len: 9, line: 1, file: FileId(0) };
                    assert_eq!(text.slice(span).unwrap(), format!("N{i:08}").as_bytes());
                }
            });
        }
    });
}

fn writeln_to(bytes: &mut Vec<u8>, i: u64) {
    use std::io::Write;
    writeln!(bytes, "N{i:08}").unwrap();
}

#[test]
fn another_main_program_leaves_the_others_read() {
    let mut memory = ProgramMemory::new("1.nc", held("O1\nX1\nM30\n"), &MACRO_B);
    let added = memory.add("added", held("O7\nY1\nM99\nO8\nM99\n"));
    memory.look_for_programs().unwrap();
    let read = memory.page(added, 0).unwrap().unwrap();
    let mut other = memory.with_main("2.nc", held("O2\nX2\nM30\n"));
    let page = other.page(added, 0).unwrap().unwrap();
    assert!(std::sync::Arc::ptr_eq(&read, &page));
    let found = |memory: &mut ProgramMemory| [1, 2, 8].map(|id| find(memory, ProgramId::Number(id)));
    let at = |name: &str, block: &str| Some((name.to_owned(), block.to_owned()));
    assert_eq!(found(&mut other), [None, at("2.nc", "O2"), at("added", "O8")]);
    assert_eq!(found(&mut memory), [at("1.nc", "O1"), None, at("added", "O8")]);
}
