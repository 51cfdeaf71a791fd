//! Comments to the end of the line, `X=…`, guards, text, addresses of several letters, named variables.

#![allow(missing_docs, clippy::unwrap_used)]

mod common;

use common::{GROUPS, NAMES, show};
use ferrocut_program::{ProgramId, ProgramMemory, Text};

fn shows(text: &str, expected: &[&str]) {
    assert_eq!(show(text.as_bytes(), &NAMES), expected, "{text}");
}

#[test]
fn words_take_expressions_behind_an_equals_sign() {
    shows("X=1+2*#3Y4", &["1 «X=1+2*#3Y4» X=(1 2 #3 Multiply Add) «X=1+2*#3» Y=4 «Y4»"]);
    shows("Z = -2", &["1 «Z = -2» Z=(2 Negate) «Z = -2»"]);
    shows("X=log6", &["1 «X=log6» X=(6 Ln) «X=log6»"]);
    shows("X=!0+ctg#2", &["1 «X=!0+ctg#2» X=(0 Not #2 Cot Add) «X=!0+ctg#2»"]);
    // A blank ends an expression; what follows must be a word.
    shows("X=5 -3", &["1 «X=5 -3» X=(5) «X=5» NumberWithoutAddress «-3»"]);
    shows("X=(5 -3)", &["1 «X=(5 -3)» MalformedExpression « »"]);
    shows("X=", &["1 «X=» MalformedExpression «=»"]);
    let plain = show(b"X=1", &GROUPS);
    assert_eq!(plain, ["1 «X=1» AddressWithoutNumber «X» IllegalCharacter «=» NumberWithoutAddress «1»"]);
}

#[test]
fn equal_ranks_group_to_the_left() {
    shows("X=1||0&&0", &["1 «X=1||0&&0» X=(1 0 LogicalOr 0 LogicalAnd) «X=1||0&&0»"]);
    shows("X=1+2>2", &["1 «X=1+2>2» X=(1 2 Add 2 Greater) «X=1+2>2»"]);
}

#[test]
fn comments_run_to_the_end_of_the_line_in_every_encoding() {
    shows("G1 X2 'X3; Y4\nZ1", &["1 «G1 X2» G=1 «G1» X=2 «X2»", "2 «Z1» Z=1 «Z1»"]);
    shows("X2;\u{2032}Y4", &["1 «X2» X=2 «X2»"]);
    assert_eq!(show(b"X2\xA1\xE4\xC7\xD0Y4\r\nX1", &NAMES), ["1 «X2» X=2 «X2»", "2 «X1» X=1 «X1»"]);
    shows("#1=2 'two", &["1 «#1=2 » #(1) = 2"]);
    shows("X?'; Y", &["1 «X?» AddressWithoutNumber «X» IllegalCharacter «?»"]);
}

#[test]
fn a_guard_rules_over_its_block() {
    shows(
        "N5IF(#1>3&&!#2)G1X2",
        &["1 «N5IF(#1>3&&!#2)G1X2» N=5 «N5» G=1 «G1» X=2 «X2» if #1 3 Greater #2 Not LogicalAnd"],
    );
    shows("IF(#1) #2=3", &["1 «IF(#1) #2=3» if #1 #(2) = 3"]);
    shows("IF(#1)", &["1 «IF(#1)» if #1"]);
    shows("X1 IF(#1)", &["1 «X1 IF(#1)» X=1 «X1» MixedStatement «IF(#1)»"]);
    shows("IF(1)IF(2)X1", &["1 «IF(1)IF(2)X1» MixedStatement «IF(2)»"]);
}

#[test]
fn addresses_of_several_letters_and_text() {
    shows(
        "FX-6.5PLC[04] PLC=3+1",
        &["1 «FX-6.5PLC[04] PLC=3+1» c=-6.5 point «FX-6.5» b=\"04\" «PLC[04]» b=(3 1 Add) «PLC=3+1»"],
    );
    shows("M801 MSG\"a b\"", &["1 «M801 MSG\"a b\"» M=801 «M801» a=\"a b\" «MSG\"a b\"»"]);
    shows("M801 \u{201c}Hello\u{201d}", &["1 «M801 “Hello”» M=801 «M801» a=\"Hello\" «“Hello”»"]);
    shows("MSG\"a\nX1", &["1 «MSG\"a» UnclosedText «MSG\"a»", "2 «X1» X=1 «X1»"]);
    shows("PLC", &["1 «PLC» AddressWithoutNumber «PLC»"]);
    shows(
        "PLCX1",
        &["1 «PLCX1» X=1 «X1» AddressWithoutNumber «P» AddressWithoutNumber «L» AddressWithoutNumber «C»"],
    );
}

#[test]
fn variables_have_names() {
    shows("#FC50=#safe-#pos.x", &["1 «#FC50=#safe-#pos.x» #(6050) = #5001 #5002 Subtract"]);
    shows("X=#FC100", &["1 «X=#FC100» UnknownVariable «FC100»"]);
    shows("X=#NONE", &["1 «X=#NONE» UnknownVariable «NONE»"]);
    assert_eq!(NAMES.variable(b"fc7"), Some(6007));
    assert_eq!(NAMES.variable_name(6007), "#FC7");
    assert_eq!((NAMES.variable_name(5002), NAMES.variable_name(7)), ("#POS.X".to_owned(), "#7".to_owned()));
}

#[test]
fn programs_are_found_by_their_names() {
    let text = Text::from_bytes(b"G65 P\"up\"\nM30\nO\"UP\"\nM17\nO\"9002\"\nM17\n".to_vec()).unwrap();
    let mut memory = ProgramMemory::new("main", text, &NAMES);
    let mut block_of = |id| memory.find_program(&id).unwrap().map(|place| place.block);
    assert_eq!(block_of(ProgramId::named("Up")), Some(2));
    assert_eq!(block_of(ProgramId::Number(9002)), Some(4));
    assert_eq!(block_of(ProgramId::named("9002")), Some(4));
    assert_eq!(block_of(ProgramId::named("down")), None);
}
