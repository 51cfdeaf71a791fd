//! Text to blocks and words: every form, with the exact text of each.

#![allow(missing_docs, clippy::unwrap_used, clippy::panic)]

mod common;

use common::{MACRO_B, show};
use ferrocut_program::{DefectKind, FileId, Syntax, lexer};

#[track_caller]
fn table(rows: &[(&str, &[&str])]) {
    for (text, blocks) in rows {
        assert_eq!(show(text.as_bytes(), &MACRO_B), *blocks, "{text:?}");
    }
}

#[test]
fn words() {
    table(&[
        ("", &[]),
        ("G0", &["1 «G0» G=0 «G0»"]),
        ("G01 X1.5 Y-2.", &["1 «G01 X1.5 Y-2.» G=1 «G01» X=1.5 point «X1.5» Y=-2 point «Y-2.»"]),
        ("g1x2y3", &["1 «g1x2y3» G=1 «g1» X=2 «x2» Y=3 «y3»"]),
        ("N10G00X1", &["1 «N10G00X1» N=10 «N10» G=0 «G00» X=1 «X1»"]),
        (" \t G0\tX1 \t", &["1 «G0\tX1» G=0 «G0» X=1 «X1»"]),
        ("X 1 Y - 2", &["1 «X 1 Y - 2» X=1 «X 1» Y=-2 «Y - 2»"]),
        ("G1,R5 ,C.5", &["1 «G1,R5 ,C.5» G=1 «G1» ,R=5 «,R5» ,C=0.5 point «,C.5»"]),
        (",r#1", &["1 «,r#1» ,R=(#1) «,r#1»"]),
        ("G01X1.Y2.F3", &["1 «G01X1.Y2.F3» G=1 «G01» X=1 point «X1.» Y=2 point «Y2.» F=3 «F3»"]),
        ("O1002(A)", &["1 «O1002» O=1002 «O1002»"]),
    ]);
}

#[test]
fn ends_of_blocks_and_lines() {
    table(&[
        ("G0\nG1", &["1 «G0» G=0 «G0»", "2 «G1» G=1 «G1»"]),
        ("G0\r\nG1\r\n", &["1 «G0» G=0 «G0»", "2 «G1» G=1 «G1»"]),
        ("G0\rG1\r", &["1 «G0» G=0 «G0»", "2 «G1» G=1 «G1»"]),
        ("\n\r\n\rG0\n\n\nG1", &["4 «G0» G=0 «G0»", "7 «G1» G=1 «G1»"]),
        ("G0;G1;;G2 ;\nG3;", &["1 «G0» G=0 «G0»", "1 «G1» G=1 «G1»", "1 «G2» G=2 «G2»", "2 «G3» G=3 «G3»"]),
        (";;;\n;\n", &[]),
        ("M30\n\x1A", &["1 «M30» M=30 «M30»"]),
        ("\0\0\0G0\0\nG1\x13", &["1 «\0\0\0G0» G=0 «G0»", "2 «G1» G=1 «G1»"]),
    ]);
}

#[test]
fn comments() {
    table(&[
        ("(all)", &[]),
        ("G0 (a) X1 (b)", &["1 «G0 (a) X1» G=0 «G0» X=1 «X1»"]),
        ("G0(;)X1", &["1 «G0(;)X1» G=0 «G0» X=1 «X1»"]),
        (
            "G0 X(a)-5 Y (b) (c) 1.",
            &["1 «G0 X(a)-5 Y (b) (c) 1.» G=0 «G0» X=-5 «X(a)-5» Y=1 point «Y (b) (c) 1.»"],
        ),
        ("X(a", &["1 «X(a» AddressWithoutNumber «X» UnclosedComment «(a»"]),
        ("(G0", &["1 «(G0» UnclosedComment «(G0»"]),
        ("G1 (two; G2\nG3", &["1 «G1 (two; G2» G=1 «G1» UnclosedComment «(two; G2»", "2 «G3» G=3 «G3»"]),
        ("(换刀) T1 (刀具；一号)", &["1 «(换刀) T1» T=1 «T1»"]),
        ("#1=2 (a)(b)", &["1 «#1=2 (a)(b)» #(1) = 2"]),
        ("#1=2 (a", &["1 «#1=2 (a» #(1) = 2 UnclosedComment «(a»"]),
    ]);
}

#[test]
fn comments_in_gb18030_hide_every_byte() {
    // Second bytes of these are letters, brackets and digits of ASCII.
    let text = "O1 (\u{4E02}\u{4E04}\u{4E8A}丂丗乕\u{3400}\u{20AC} 铣削平面)\nG0 (换刀) X1\n";
    let (bytes, _, unmappable) = encoding_rs::GB18030.encode(text);
    assert!(!unmappable);
    let blocks = show(&bytes, &MACRO_B);
    assert_eq!(blocks.len(), 2);
    assert_eq!(blocks[0], "1 «O1» O=1 «O1»");
    assert!(
        blocks[1].starts_with("2 «G0 (") && blocks[1].ends_with("X1» G=0 «G0» X=1 «X1»"),
        "{}",
        blocks[1]
    );
    // All of the two bytes and four bytes: no character ends or opens a comment.
    for c in (0x80..=0x1_FFFFu32).filter_map(char::from_u32) {
        let c = c.to_string();
        let (bytes, _, unmappable) = encoding_rs::GB18030.encode(&c);
        assert!(unmappable || !bytes.iter().any(|b| b")(;\r\n".contains(b)), "{c}");
    }
}

#[test]
fn marks() {
    table(&[
        ("%\nO1\nM30\n%\n", &["2 «O1» O=1 «O1»", "3 «M30» M=30 «M30»", "4 mark «%»"]),
        ("\n (leader) %\nG0\n%", &["3 «G0» G=0 «G0»", "4 mark «%»"]),
        ("\0\0%;O1;M30;%", &["1 «O1» O=1 «O1»", "1 «M30» M=30 «M30»", "1 mark «%»"]),
        ("%PROGRAM 12\nG0", &["2 «G0» G=0 «G0»"]),
        ("G0\n(end) % all )\nG1", &["1 «G0» G=0 «G0»", "2 mark «(end) %»", "3 «G1» G=1 «G1»"]),
        ("%\n%\nG0", &["3 «G0» G=0 «G0»"]),
        ("G0 %", &["1 «G0 %» G=0 «G0» IllegalCharacter «%»"]),
    ]);
}

#[test]
fn block_skip() {
    table(&[
        ("/G0", &["1 skip1 «/G0» G=0 «G0»"]),
        ("//G0", &["1 skip2 «//G0» G=0 «G0»"]),
        ("/ /G0", &["1 skip2 «/ /G0» G=0 «G0»"]),
        ("/2G0", &["1 skip1 «/2G0» G=0 «G0»"]),
        ("/2 N5 X1", &["1 skip1 «/2 N5 X1» N=5 «N5» X=1 «X1»"]),
        ("N5/G0", &["1 skip1 «N5/G0» N=5 «N5» G=0 «G0»"]),
        ("N5 //2 G0", &["1 skip2 «N5 //2 G0» N=5 «N5» G=0 «G0»"]),
        ("(a)/G0", &["1 skip1 «(a)/G0» G=0 «G0»"]),
        ("/", &["1 skip1 «/»"]),
        ("/#1=2", &["1 skip1 «/#1=2» #(1) = 2"]),
        ("G0/X1", &["1 «G0/X1» G=0 «G0» X=1 «X1» IllegalCharacter «/»"]),
    ]);
    assert_eq!(common::page(&[b'/'; 300], &MACRO_B).blocks[0].skip, 255);
}

#[test]
fn defects_underline_what_is_wrong() {
    table(&[
        ("G0 5 X1", &["1 «G0 5 X1» G=0 «G0» X=1 «X1» NumberWithoutAddress «5»"]),
        ("-1.5.2", &["1 «-1.5.2» NumberWithoutAddress «-1.5.2»"]),
        ("G0 X Y1", &["1 «G0 X Y1» G=0 «G0» Y=1 «Y1» AddressWithoutNumber «X»"]),
        ("X  ", &["1 «X» AddressWithoutNumber «X»"]),
        ("X- ", &["1 «X-» AddressWithoutNumber «X-»"]),
        ("X.", &["1 «X.» AddressWithoutNumber «X.»"]),
        (",R", &["1 «,R» AddressWithoutNumber «,R»"]),
        ("X- + Y1", &["1 «X- + Y1» Y=1 «Y1» MisplacedSign «- +» AddressWithoutNumber «X- +»"]),
        ("X--1", &["1 «X--1» X=1 «X--1» MisplacedSign «--»"]),
        ("X1.2.3", &["1 «X1.2.3» X=1.2 point «X1.2» MisplacedPoint «X1.2.3»"]),
        ("X1-2", &["1 «X1-2» X=1 «X1» MisplacedSign «X1-2»"]),
        ("X1,5", &["1 «X1,5» X=1 «X1» IllegalCharacter «,» NumberWithoutAddress «5»"]),
        ("G0 铣 X1", &["1 «G0 铣 X1» G=0 «G0» X=1 «X1» IllegalCharacter «铣»"]),
        ("G0；X1", &["1 «G0；X1» G=0 «G0» X=1 «X1» IllegalCharacter «；»"]),
        ("G0 @ &", &["1 «G0 @ &» G=0 «G0» IllegalCharacter «@» IllegalCharacter «&»"]),
        ("G0 ]", &["1 «G0 ]» G=0 «G0» UnbalancedBracket «]»"]),
        ("G0 X1]", &["1 «G0 X1]» G=0 «G0» X=1 «X1» UnbalancedBracket «]»"]),
        ("G0 ) X1", &["1 «G0 ) X1» G=0 «G0» X=1 «X1» IllegalCharacter «)»"]),
        ("X[1+2 Y3", &["1 «X[1+2 Y3» MalformedExpression «Y»"]),
        ("X[1+2", &["1 «X[1+2» UnbalancedBracket «[»"]),
        ("X[1+]", &["1 «X[1+]» MalformedExpression «]»"]),
        ("X[", &["1 «X[» MalformedExpression «[»"]),
        ("X#", &["1 «X#» MalformedExpression «#»"]),
        ("X#-1", &["1 «X#-1» MalformedExpression «#»"]),
        ("X[BAD[1]]", &["1 «X[BAD[1]]» UnknownFunction «BAD»"]),
        ("X[SIN 30]", &["1 «X[SIN 30]» MalformedExpression «SIN »"]),
    ]);
    let huge = format!("X{}", "9".repeat(400));
    assert_eq!(show(huge.as_bytes(), &MACRO_B), [format!("1 «{huge}» NumberTooLarge «{huge}»")]);
    let digits = "9".repeat(400);
    for text in [format!("X[{digits}]"), format!("X#{digits}")] {
        assert_eq!(show(text.as_bytes(), &MACRO_B), [format!("1 «{text}» NumberTooLarge «{digits}»")]);
    }
}

#[test]
fn every_defect_of_a_block_and_a_program_is_found() {
    table(&[(
        "X Y\n5\nG0",
        &[
            "1 «X Y» AddressWithoutNumber «X» AddressWithoutNumber «Y»",
            "2 «5» NumberWithoutAddress «5»",
            "3 «G0» G=0 «G0»",
        ],
    )]);
}

#[test]
fn an_over_long_line_is_one_defect() {
    let max = MACRO_B.max_line;
    for end in ["\n", "\r\n", "\r", ""] {
        let fits = format!("G1{}{end}G2", " ".repeat(max - 2));
        let over = format!("G0\nX1;#1=2;X@{}{end}", " ".repeat(max - 9));
        assert!(end.is_empty() || !common::page(fits.as_bytes(), &MACRO_B).blocks[0].is_defective);
        let text = format!("{over}{}", if end.is_empty() { "" } else { "G3 Y" });
        let page = common::page(text.as_bytes(), &MACRO_B);
        assert_eq!(page.blocks.len(), if end.is_empty() { 2 } else { 3 });
        let block = &page.blocks[1];
        assert_eq!((block.at, block.len, block.line, block.words), (3, max as u32 + 1, 2, 0));
        let defects: Vec<_> = page.defects(1).map(|d| (d.kind, d.at, d.len)).collect();
        assert_eq!(defects, [(DefectKind::LineTooLong, 3, 80)]);
        if !end.is_empty() {
            assert_eq!((page.blocks[2].line, page.words(&page.blocks[2])[0].letter), (3, b'G'));
            assert_eq!(page.defects(2).count(), 1);
        }
    }
    // Blanks and comments count too.
    let text = format!("({})\nG0", "x".repeat(max));
    assert_eq!(common::page(text.as_bytes(), &MACRO_B).blocks.len(), 2);
}

#[test]
fn a_block_with_too_many_words_is_refused() {
    for word in ["X1", ",R1"] {
        let page = common::page(word.repeat(1000).as_bytes(), &MACRO_B);
        assert_eq!(page.blocks.len(), 1);
        assert_eq!(page.blocks[0].words, 512);
        assert_eq!(page.defects[0].kind, DefectKind::LineTooLong);
        assert_eq!(page.defects[0].at as usize, 512 * word.len());
    }
}

#[test]
fn only_closed_lines_are_read_of_a_text_that_goes_on() {
    for (text, consumed, next_line, blocks) in [
        ("G0\nG1\nG2", 6, 3, 2),
        ("G0\r\nG1\r\nG2", 8, 3, 2),
        ("G0\rG1\rG2", 6, 3, 2),
        // Its LF may come next.
        ("G0\rG1\r", 3, 2, 1),
        ("G0\nG1\r", 3, 2, 1),
    ] {
        let lexed = lexer::lex(text.as_bytes(), FileId(0), 0, 1, false, &MACRO_B);
        let found = (lexed.consumed, lexed.next_line, lexed.page.blocks.len(), lexed.is_cut);
        assert_eq!(found, (consumed, next_line, blocks, false), "{text:?}");
    }
    for (text, consumed) in [("G0 X1", 5), ("G0 X1\r", 5)] {
        let lexed = lexer::lex(text.as_bytes(), FileId(0), 0, 7, false, &MACRO_B);
        assert_eq!((lexed.consumed, lexed.next_line, lexed.is_cut), (consumed, 7, true));
        assert_eq!(lexed.page.blocks.len(), 1);
        assert_eq!(lexed.page.defects[0].kind, DefectKind::LineTooLong);
    }
    let lexed = lexer::lex(b"", FileId(0), 0, 1, false, &MACRO_B);
    assert_eq!((lexed.consumed, lexed.is_cut), (0, false));
}

#[test]
fn spans_are_of_the_file() {
    let lexed = lexer::lex(b"G0\nX1 Y2", FileId(3), 5_000_000_000, 70, true, &Syntax::WORDS);
    let block = &lexed.page.blocks[1];
    let span = lexed.page.word_span(block, &lexed.page.words(block)[1]);
    assert_eq!((span.offset, span.len, span.line, span.file), (5_000_000_006, 2, 71, FileId(3)));
    assert_eq!(lexed.page.block_span(block).len, 5);
}
