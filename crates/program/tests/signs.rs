//! Parameters without a sign, keywords with one, directives, axes with a digit, comments behind `;`.

#![allow(missing_docs, clippy::unwrap_used, clippy::panic)]

mod common;

use common::{SIGNS, cut, page, show};
use ferrocut_program::Statement;

fn shows(text: &str, expected: &[&str]) {
    assert_eq!(show(text.as_bytes(), &SIGNS), expected, "{text}");
}

#[test]
fn a_semicolon_begins_a_comment() {
    shows("G1 X2 ; X3 (Y4\nZ1", &["1 «G1 X2» G=1 «G1» X=2 «X2»", "2 «Z1» Z=1 «Z1»"]);
    shows("; a line\n;\nX1", &["3 «X1» X=1 «X1»"]);
    shows("P1=2 ; two", &["1 «P1=2 » #(2) = 2"]);
}

#[test]
fn parameters_are_set_and_read_without_a_sign() {
    shows("P0=1+P2*2", &["1 «P0=1+P2*2» #(1) = 1 #3 2 Multiply Add"]);
    shows(
        "XP1 Y-P[P2+1] Z=P3",
        &["1 «XP1 Y-P[P2+1] Z=P3» X=(#2) «XP1» Y=(1 #3 1 Add Add # Negate) «Y-P[P2+1]» Z=(#4) «Z=P3»"],
    );
    shows("P[2]=5", &["1 «P[2]=5» #(1 2 Add) = 5"]);
    shows("V.C.Z=V.C.Z-2", &["1 «V.C.Z=V.C.Z-2» #(5000) = #5000 2 Subtract"]);
    shows("P100=1", &["1 «P100=1» UnknownVariable «P100»"]);
    // Without an equals sign it is a word.
    shows("G160 P2.003 V50", &["1 «G160 P2.003 V50» G=160 «G160» P=2.003 point «P2.003» V=50 «V50»"]);
}

#[test]
fn a_line_may_set_several_and_go_on_with_words() {
    shows(
        "N5 P1=2 V.C.Z=3 X4",
        &["1 «N5 P1=2 » N=5 «N5» #(2) = 2", "1 «V.C.Z=3 » #(5000) = 3", "1 «X4» X=4 «X4»"],
    );
    shows("X4 P1=2", &["1 «X4» X=4 «X4»", "1 «P1=2» #(2) = 2"]);
    shows("/P1=2 X3", &["1 skip1 «/P1=2 » #(2) = 2", "1 skip1 «X3» X=3 «X3»"]);
}

#[test]
fn conditions_and_loops_are_lines_of_their_own() {
    shows(
        "$IF P1==2\n$ELSEIF P1<3\n$ELSE\n$ENDIF",
        &[
            "1 «$IF P1==2» if #2 2 Equal",
            "2 «$ELSEIF P1<3» elseif #2 3 Less",
            "3 «$ELSE» else",
            "4 «$ENDIF» endif",
        ],
    );
    shows(
        "$FOR P0=1,10,-P2\n$ENDFOR",
        &["1 «$FOR P0=1,10,-P2» for #(1) = 1 to 10 by #3 Negate", "2 «$ENDFOR» endfor"],
    );
    shows(
        "N10: $WHILE [P1<2] (why)\n$BREAK\n$CONTINUE\n$ENDWHILE",
        &[
            "1 «N10: $WHILE [P1<2] (why)» N=10 «N10» while #2 2 Less",
            "2 «$BREAK» break",
            "3 «$CONTINUE» continue",
            "4 «$ENDWHILE» endwhile",
        ],
    );
    shows("$GOTO N10", &["1 «$GOTO N10» goto 10"]);
    shows("$WHAT", &["1 «$WHAT» MalformedStatement «$WHAT»"]);
    shows("$FOR P0=1", &["1 «$FOR P0=1» MalformedStatement «1»"]);
    // Letters that are keywords elsewhere are words here.
    shows("IF5", &["1 «IF5» F=5 «F5» AddressWithoutNumber «I»"]);
}

#[test]
fn axes_may_have_a_digit() {
    let page = page(b"X2=25 X25 NR3", &SIGNS);
    let words: Vec<u8> = page.words(&page.blocks[0]).iter().map(|w| w.letter).collect();
    assert_eq!(ferrocut_program::numbered_axis_name(words[0]), Some([b'X', b'2']));
    assert_eq!(words[1..], [b'X', b'm']);
    assert_eq!(
        ferrocut_program::numbered_axis(b'w', b'9').and_then(ferrocut_program::numbered_axis_name),
        Some([b'W', b'9'])
    );
    assert_eq!(ferrocut_program::numbered_axis(b'X', b'0'), None);
}

#[test]
fn addresses_of_several_letters_take_expressions() {
    shows("NR[1+2]", &["1 «NR[1+2]» m=(1 2 Add) «NR[1+2]»"]);
    shows("X5NRP1", &["1 «X5NRP1» X=5 «X5» m=(#2) «NRP1»"]);
}

#[test]
fn what_is_at_fault_is_whole_characters() {
    shows("X=（5", &["1 «X=（5» MalformedExpression «（»"]);
}

#[test]
fn directives_have_names_and_arguments() {
    let text = b"#CYCLE G287 [X=-1.5, mode=depth, P2=[50,P1,round,5], pocket=FAGOR-A, 7 ] (why)";
    let page = page(text, &SIGNS);
    assert_eq!(page.defects.len(), 0);
    let Some(Statement::Directive(place)) = page.statement(&page.blocks[0]) else { panic!("no directive") };
    let directive = page.directive(*place).unwrap();
    let text_of = |range: ferrocut_program::TextRange| cut(text, range.at, range.len);
    let names: Vec<String> = page.directive_names(directive).iter().map(|n| text_of(*n)).collect();
    assert_eq!(names, ["CYCLE", "G287"]);
    let arguments: Vec<(String, String, bool)> = page
        .directive_arguments(directive)
        .iter()
        .map(|a| (text_of(a.name), text_of(a.text), a.value.is_some()))
        .collect();
    let expected = [
        ("X", "-1.5", true),
        ("mode", "depth", false),
        ("P2", "[50,P1,round,5]", false),
        ("pocket", "FAGOR-A", false),
        ("", "7", true),
    ];
    let expected: Vec<(String, String, bool)> =
        expected.iter().map(|(n, t, v)| ((*n).to_string(), (*t).to_string(), *v)).collect();
    assert_eq!(arguments, expected);
    let items = page.list(&page.directive_arguments(directive)[2]);
    let items: Vec<(String, bool)> = items.iter().map(|i| (text_of(i.text), i.value.is_some())).collect();
    assert_eq!(
        items,
        [("50".into(), true), ("P1".into(), true), ("round".into(), false), ("5".into(), true)]
    );
    shows("#CYCLE [X=1", &["1 «#CYCLE [X=1» UnbalancedBracket «[»"]);
    shows("#A", &["1 «#A» MalformedStatement «#»"]);
    shows("#TOOL AX [X+] G1", &["1 «#TOOL AX [X+] G1» MixedStatement «G1»"]);
}
