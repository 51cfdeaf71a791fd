//! Any bytes end in a result: no panic, no hang, no memory beyond a page's, and what comes out holds.

#![allow(missing_docs, clippy::unwrap_used, clippy::panic)]

mod common;

use common::{GROUPS, MACRO_B, NAMES, SIGNS, check, deepest, flat, pages};
use ferrocut_program::expression::{MAX_NESTING, MAX_STACK};
use ferrocut_program::{Binary, DefectKind, FileId, Page, ProgramMemory, Statement, Syntax, Text, lexer};
use proptest::prelude::*;
use std::time::{Duration, Instant};

const SYNTAXES: [&Syntax; 5] = [&MACRO_B, &GROUPS, &NAMES, &SIGNS, &Syntax::WORDS];

/// Reads a file of any size by pages, checks each, and returns what it counted.
fn read(text: &[u8], syntax: &'static Syntax) -> (usize, usize) {
    let Ok(held) = Text::from_bytes(text.to_vec()) else { return (0, 0) };
    let mut memory = ProgramMemory::new("", held, syntax);
    let (mut blocks, mut defects, mut number) = (0, 0, 0);
    while let Some(page) = memory.page(FileId(0), number).unwrap() {
        check(&text[page.offset as usize..], &page);
        assert!(page_bytes(&page) < 16 << 20, "a page of {} bytes", page_bytes(&page));
        blocks += page.blocks.len();
        defects += page.defects.len();
        number += 1;
    }
    assert!(number as usize <= 2 * text.len() / 65_536 + 2, "{number} pages");
    (blocks, defects)
}

fn page_bytes(page: &Page) -> usize {
    32 * page.blocks.capacity()
        + 16 * (page.words.capacity() + page.nodes.capacity() + page.defects.capacity())
        + 48 * page.statements.capacity()
        + 8 * (page.guards.capacity() + page.names.capacity())
        + 40 * (page.arguments.capacity() + page.items.capacity())
        + 16 * page.directives.capacity()
}

#[test]
fn hostile_files_end_in_a_result() {
    let mb = |piece: &[u8], n: usize| piece.repeat((n << 20) / piece.len());
    let files: Vec<(&str, Vec<u8>)> = vec![
        ("O words only", mb(b"O1\n", 8)),
        ("ends of blocks in one line", mb(b";", 8)),
        ("ends of blocks in lines", mb(b";;;;;;;;;;;;;;;\n", 8)),
        ("empty lines", mb(b"\n", 8)),
        ("empty lines of a Mac", mb(b"\r", 8)),
        ("lines ended the wrong way", mb(b"\n\r", 8)),
        ("marks", mb(b"%\n", 8)),
        ("one line", mb(b"G1X1Y2", 8)),
        ("one line of letters", mb(b"G", 8)),
        ("one line of signs", mb(b"X-+", 8)),
        ("one number", mb(b"9", 8)),
        ("lines of letters", mb(&[&[b'A'; 60_000][..], b"\n"].concat(), 4)),
        ("keywords", mb(b"IF", 4)),
        ("keywords in lines", mb(b"IFWHILEGOTODOEND\n", 4)),
        ("long names", mb(&[b"#1=".as_slice(), &[b'S'; 4000], b"\n"].concat(), 4)),
        ("brackets in one line", mb(b"[", 4)),
        ("brackets", mb(&[b"X".as_slice(), &[b'['; 3000], b"\n"].concat(), 4)),
        ("round brackets", mb(&[b"#1=".as_slice(), &[b'('; 3000], b"\n"].concat(), 4)),
        ("comments not closed", mb(b"((((\n", 4)),
        ("comments not closed in one line", mb(b"(;", 4)),
        ("signs", mb(&[b"#1=".as_slice(), &[b'-'; 3000], b"1\n"].concat(), 4)),
        ("signs of a word", mb(&[b"X".as_slice(), &[b'-'; 3000], b"1\n"].concat(), 4)),
        ("signs and blanks", mb(&[b"X".as_slice(), &b"- ".repeat(1500), b"\n"].concat(), 4)),
        ("variables", mb(&[&[b'#'; 3000][..], b"1\n"].concat(), 4)),
        ("variables of a word", mb(&[b"X".as_slice(), &[b'#'; 3000], b"1\n"].concat(), 4)),
        ("a long sum", mb(&[b"#1=1".as_slice(), &b"+1".repeat(2000), b"\n"].concat(), 4)),
        ("a long power", mb(&[b"#1=1".as_slice(), &b"**1".repeat(1300), b"\n"].concat(), 4)),
        ("functions", mb(&[b"#1=".as_slice(), &b"SIN[".repeat(1000), b"\n"].concat(), 4)),
        ("quotients of arcs", mb(&[b"#1=".as_slice(), &b"ATAN[1]/".repeat(500), b"\n"].concat(), 4)),
        ("skips", mb(b"////////////////\n", 4)),
        ("commas", mb(b",,,,,,,,,,,,,,,\n", 4)),
        ("defects", mb(b"A;", 4)),
        ("defects in lines", mb(b"A\n", 4)),
        ("short statements", mb(b"DO1\n", 4)),
        ("short statements in a line", mb(b"DO1;DO1;DO1;DO1;DO1\n", 4)),
        ("short directives", mb(b"#AB\n", 4)),
        ("short parameters", mb(b"P1=1", 4)),
        ("short parameters in lines", mb(b"P1=1P2=2\n", 4)),
        ("arguments", mb(&[b"#AB[".as_slice(), &b"a,".repeat(2000), b"]\n"].concat(), 4)),
        ("lists", mb(&[b"#AB[".as_slice(), &b"a=[1,2],".repeat(400), b"]\n"].concat(), 4)),
        ("lists not closed", mb(&[b"#AB[".as_slice(), &[b'['; 3000], b"\n"].concat(), 4)),
        ("zero bytes inside", [b"G0".as_slice(), &[0; 1 << 20], b"G0"].concat()),
        ("high bytes", mb(b"\xFF\x80\x81", 4)),
        ("blanks", mb(b" ", 4)),
        ("blanks and letters", mb(&[b"X".as_slice(), &[b' '; 4000], b"\n"].concat(), 4)),
        ("points", mb(b"X.", 4)),
        ("quotes not closed", mb(b"\"\"\"\n", 4)),
        ("quotes of words", mb(&[b"P\"".repeat(1500).as_slice(), b"\n"].concat(), 4)),
        ("guards", mb(&[b"IF(1)".repeat(700).as_slice(), b"\n"].concat(), 4)),
        ("comments to the end of the line", mb(b"G0'X;1'\n", 4)),
        ("long addresses", mb(&[b"FX=1PLC[4]".repeat(300).as_slice(), b"\n"].concat(), 4)),
        ("names", mb(&[b"#FC1#SAFE".repeat(300).as_slice(), b"\n"].concat(), 4)),
        ("points in lines", mb(b"X......\n", 4)),
    ];
    for syntax in SYNTAXES {
        for (name, file) in &files {
            let start = Instant::now();
            read(file, syntax);
            // A generous bound against work that grows with the square of the text; not a measurement.
            assert!(start.elapsed() < Duration::from_secs(10), "{name} took {:?}", start.elapsed());
        }
    }
}

#[test]
fn a_single_line_of_100_mb_is_one_block() {
    for piece in [&b"G1 X1 "[..], b";", b"(", b"#", b"X"] {
        let text = piece.repeat((100 << 20) / piece.len());
        assert_eq!(read(&text, &MACRO_B), (1, 1));
    }
}

#[test]
fn indices_and_lengths_fit_their_types() {
    // The most statements that a call reads.
    let text = b"DO1;".repeat(lexer::MAX_TEXT / 4);
    let lines: Vec<u8> = b"DO1\n".repeat(lexer::MAX_TEXT / 4);
    let page = common::page(&lines, &MACRO_B);
    assert_eq!(page.statements.len(), 65_536);
    let last = page.blocks.last().unwrap();
    assert_eq!((last.statement, page.statement(last)), (Some(65_535), page.statements.last()));
    assert!(page.blocks.iter().all(|b| b.statement.is_some() && !b.is_defective));
    let page = common::page(&text, &MACRO_B);
    assert_eq!((page.blocks.len(), page.blocks[0].is_defective), (1, true));
    // More than a call reads is left for the next.
    let more = b"DO1\n".repeat(lexer::MAX_TEXT / 4 + 10);
    let lexed = lexer::lex(&more, FileId(0), 0, 1, true, &MACRO_B);
    assert_eq!((lexed.consumed, lexed.next_line, lexed.page.blocks.len()), (lexer::MAX_TEXT, 65_537, 65_536));
    let rest = lexer::lex(&more[lexed.consumed..], FileId(0), 0, lexed.next_line, true, &MACRO_B);
    assert_eq!(rest.page.blocks.len(), 10);
    // Words, in number and in length, in a line as long as a call.
    for piece in ["X1", ",R1", "X", "X1.2.3", "X[1]", "0", "1+"] {
        let text = format!("X[1+{}", piece.repeat(lexer::MAX_TEXT / piece.len() - 4));
        for text in [text.as_str(), &text[4..]] {
            let page = common::page(text.as_bytes(), &GROUPS);
            assert_eq!((page.blocks.len(), page.words.len(), page.defects.len()), (1, 0, 1));
        }
    }
    // Line numbers stop at the last there is.
    let lexed = lexer::lex(b"G0\nG0\nG0\n", FileId(0), 0, u32::MAX - 1, true, &MACRO_B);
    let lines: Vec<u32> = lexed.page.blocks.iter().map(|b| b.line).collect();
    assert_eq!(lines, [u32::MAX - 1, u32::MAX, u32::MAX]);
}

/// The expression that keeps the most values waiting: at every level one a precedence and the first
/// half of `ATAN[a]/[b]`.
fn worst(levels: usize, operators: &[&str]) -> String {
    let waiting: String = operators.iter().map(|o| format!("1{o}")).collect();
    match levels {
        0 => format!("{waiting}1"),
        _ => format!("{waiting}ATAN[1]/[{}]", worst(levels - 1, operators)),
    }
}

fn stack_of(text: &str, syntax: &Syntax) -> Result<usize, DefectKind> {
    let text = format!("#1={text}");
    let lexed = lexer::lex(text.as_bytes(), FileId(0), 0, 1, true, syntax);
    match lexed.page.statement(&lexed.page.blocks[0]) {
        Some(Statement::Assign { value, .. }) => Ok(deepest(lexed.page.nodes(*value))),
        _ => Err(lexed.page.defects[0].kind),
    }
}

#[test]
fn the_worst_expression_fits_the_stack() {
    let six = ["||", "&&", ">", "+", "*", "**"];
    let nesting = usize::from(MAX_NESTING);
    assert_eq!(stack_of(&worst(nesting, &six), &GROUPS), Ok(7 * nesting + 7));
    assert_eq!(stack_of(&worst(nesting + 1, &six), &GROUPS), Err(DefectKind::BracketsTooDeep));
    let three = ["GT", "+", "*"];
    assert_eq!(stack_of(&worst(4, &three), &MACRO_B), Ok(4 * 4 + 4));
    assert_eq!(stack_of(&worst(5, &three), &MACRO_B), Ok(4 * 5 + 4));
    assert_eq!(stack_of(&worst(6, &three), &MACRO_B), Err(DefectKind::BracketsTooDeep));
}

#[test]
fn no_table_of_operators_can_overflow_the_stack() {
    // One operator for each of 255 bindings.
    let names: Vec<&'static str> = (1..=255).map(|n| &*format!("<{n:03}>").leak()).collect();
    let operators: Vec<_> = names.iter().zip(1..=255).map(|(name, n)| (*name, Binary::Add, n)).collect();
    let syntax = Syntax { operators: operators.leak(), ..GROUPS };
    assert_eq!(stack_of(&worst(0, &names[..100]), &syntax), Ok(101));
    assert_eq!(stack_of(&worst(1, &names[..127]), &syntax), Ok(MAX_STACK));
    assert_eq!(stack_of(&worst(1, &names[..128]), &syntax), Err(DefectKind::BracketsTooDeep));
    assert_eq!(stack_of(&worst(0, &names), &syntax), Ok(MAX_STACK));
    assert_eq!(stack_of(&worst(20, &names), &syntax), Err(DefectKind::BracketsTooDeep));
    // The tightest binding groups to the left too, however long the chain.
    assert_eq!(stack_of(&format!("1{}", "<255>1".repeat(500)), &syntax), Ok(2));
}

/// Pieces that programs are made of, and some that they are not.
const PIECES: &[&str] = &[
    "G1",
    "G01",
    "X",
    "Y-1.5",
    "Z.5",
    "N10",
    "O1",
    "O1002",
    "F100.",
    "M30",
    ",R5",
    " ",
    "\t",
    "\n",
    "\r\n",
    "\r",
    ";",
    "/",
    "//2",
    "%",
    "(",
    ")",
    "(铣削)",
    "(a;b)",
    "#",
    "#1",
    "##2",
    "=",
    "[",
    "]",
    "+",
    "-",
    "*",
    "/",
    "1",
    "2.",
    ".",
    "0.25",
    "SIN[",
    "ATAN[1]/[2]",
    "AT",
    "AND",
    "OR",
    "GT",
    "IF[",
    "THEN",
    "GOTO",
    "WHILE[",
    "DO1",
    "END1",
    "DO",
    "#1=#2+3",
    "IF[#1EQ2]GOTO3",
    "WHILE[#1LT5]DO1",
    "\0",
    "\u{1A}",
    "铣",
    "\u{FEFF}",
    "**",
    "||",
    "X[1+2]",
    "E5",
    "'",
    "\"",
    "1e5",
    "IF(",
    "FX=",
    "PLC[04]",
    "P\"ab\"",
    "\u{201c}",
    "\u{2032}",
    "#FC1",
    "#POS.X",
    "LOG6",
    "!",
    "=",
];

fn pieces() -> impl Strategy<Value = Vec<u8>> {
    let piece = prop_oneof![
        20 => prop::sample::select(PIECES).prop_map(|p| p.as_bytes().to_vec()),
        1 => prop::collection::vec(any::<u8>(), 1..4),
    ];
    prop::collection::vec(piece, 0..60).prop_map(|p| p.concat())
}

const PROGRAM: &str = "%\nO1000 (铣削 A)\nN10 G90 G54 G0 X1.5 Y-.5;Z5.\n/N20 G1Z-1.F100\n#1=0\n\
    WHILE[#1 LT 10]DO1\nG1 X[#1*10+SIN[#1]] Y#[#1+1] ,R5\n#1=#1+1\nEND1\nIF[#1 EQ 10]THEN #2=ATAN[1]/[2]\n\
    IF[#1GE9]GOTO30\nN30 M98 P1002\nM30\nO1002\nM99\n%\n";

/// A sound program with some bytes changed, put in and taken out.
fn mutated() -> impl Strategy<Value = Vec<u8>> {
    let change = (any::<prop::sample::Index>(), 0..4u8, any::<u8>());
    prop::collection::vec(change, 0..12).prop_map(|changes| {
        let mut text = PROGRAM.as_bytes().to_vec();
        for (at, kind, byte) in changes {
            let at = at.index(text.len());
            match kind {
                0 => text[at] = byte,
                1 => text.insert(at, byte),
                2 => drop(text.remove(at)),
                _ => text.insert(at, b"\n;[](#-+./%"[usize::from(byte) % 11]),
            }
        }
        text
    })
}

/// Lexes a text in pieces cut where a reader of small windows would cut it.
fn in_windows(text: &[u8], window: usize, syntax: &Syntax) -> Vec<Page> {
    let (mut pages, mut at, mut line) = (Vec::new(), 0, 1);
    while at < text.len() {
        let mut len = window;
        let lexed = loop {
            let end = text.len().min(at + len);
            let lexed = lexer::lex(&text[at..end], FileId(0), at as u64, line, end == text.len(), syntax);
            if lexed.consumed > 0 && !lexed.is_cut {
                break lexed;
            }
            len += window;
        };
        check(&text[at..], &lexed.page);
        at += lexed.consumed;
        line = lexed.next_line;
        pages.push(lexed.page);
    }
    pages
}

fn holds(text: &[u8]) {
    for syntax in SYNTAXES {
        let whole = common::page(text, syntax);
        let expected = flat([&whole]);
        for window in [7, 64] {
            let pages = in_windows(text, window, syntax);
            // What a `%` is depends on the windows before; program memory knows, single calls do not.
            if !text.contains(&b'%') {
                assert_eq!(flat(&pages), expected, "window {window}");
            }
        }
        if let Ok(held) = Text::from_bytes(text.to_vec()) {
            let mark = held.encoding().mark;
            let mut memory = ProgramMemory::new("", held, syntax);
            let pages = pages(&mut memory, FileId(0));
            if mark == 0 {
                assert_eq!(flat(pages.iter().map(|p| &**p)), expected);
            }
        }
    }
}

proptest! {
    #![proptest_config(ProptestConfig::with_cases(3000))]

    #[test]
    fn random_bytes(text in prop::collection::vec(any::<u8>(), 0..300)) {
        holds(&text);
    }

    #[test]
    fn random_pieces(text in pieces()) {
        holds(&text);
    }

    #[test]
    fn mutated_programs(text in mutated()) {
        holds(&text);
    }
}

proptest! {
    #![proptest_config(ProptestConfig::with_cases(60))]

    #[test]
    fn long_texts_stream_as_they_are_lexed_whole(
        pieces in prop::collection::vec(pieces(), 1..40),
        repeat in 5usize..40,
        end in prop::sample::select(vec!["\n", "\r\n", "\r"]),
    ) {
        let mut text = Vec::new();
        for piece in pieces.iter().cycle().take(pieces.len() * repeat) {
            text.extend(piece.iter().filter(|b| **b >= b' '));
            text.extend_from_slice(end.as_bytes());
        }
        text.truncate(lexer::MAX_TEXT);
        let Ok(held) = Text::from_bytes(text.clone()) else { return Ok(()) };
        prop_assume!(held.encoding().mark == 0);
        let whole = common::page(&text, &MACRO_B);
        let mut memory = ProgramMemory::new("", held, &MACRO_B);
        let pages = pages_checked(&mut memory, &text);
        prop_assert_eq!(flat(pages.iter().map(|p| &**p)), flat([&whole]));
    }
}

fn pages_checked(memory: &mut ProgramMemory, text: &[u8]) -> Vec<std::sync::Arc<Page>> {
    let pages = pages(memory, FileId(0));
    for page in &pages {
        check(&text[page.offset as usize..], page);
    }
    pages
}
