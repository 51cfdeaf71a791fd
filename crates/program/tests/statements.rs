//! The macro language: statements and expressions as nodes, checked by values worked out by hand.

#![allow(missing_docs, clippy::unwrap_used, clippy::panic)]

mod common;

use common::{GROUPS, MACRO_B, binary, evaluate, function, page, show};
use ferrocut_program::{Binary, Function, Statement, Syntax, Value};
use proptest::prelude::*;

#[track_caller]
fn table(syntax: &Syntax, rows: &[(&str, &str)]) {
    for (text, block) in rows {
        let expected = format!("1 «{}» {block}", text.trim_end());
        assert_eq!(show(text.as_bytes(), syntax), [expected], "{text:?}");
    }
}

#[test]
fn statements() {
    table(
        &MACRO_B,
        &[
            ("#1=2", "#(1) = 2"),
            ("#1 = #2 + 3", "#(1) = #2 3 Add"),
            ("# 1=2", "#(1) = 2"),
            ("#[#1+1]=2", "#(#1 1 Add) = 2"),
            ("##1=2", "#(#1) = 2"),
            ("###1=2", "#(#1 #) = 2"),
            ("#1=##2", "#(1) = #2 #"),
            ("#1.5=2", "#(1.5) = 2"),
            ("#1=#2.", "#(1) = #2"),
            ("#1=#2.5", "#(1) = 2.5 #"),
            ("#1=-#2", "#(1) = #2 Negate"),
            ("#1=--2", "#(1) = 2 Negate Negate"),
            ("#1=+#2", "#(1) = #2 Plus"),
            ("#1=.5+5.", "#(1) = 0.5 5 Add"),
            ("GOTO1", "goto 1"),
            ("goto 99999", "goto 99999"),
            ("GOTO #10", "goto #10"),
            ("GOTO[#1+#2]", "goto #1 #2 Add"),
            ("IF[#1 GT 10]GOTO 2", "if #1 10 Greater goto 2"),
            ("IF [#1EQ#2] THEN #3=0", "if #1 #2 Equal #(3) = 0"),
            ("if[#1eq#2]then#3=0", "if #1 #2 Equal #(3) = 0"),
            ("WHILE[#2 LE 10]DO1", "while #2 10 LessEqual do 1"),
            ("DO 3", "do 3"),
            ("END 1", "end 1"),
            ("END1.", "end 1"),
        ],
    );
    assert_eq!(
        show(b"N1 IF[#2 GT 10]GOTO 2", &MACRO_B),
        ["1 «N1 IF[#2 GT 10]GOTO 2» N=1 «N1» if #2 10 Greater goto 2"]
    );
    assert_eq!(show(b"/N1#1=2;#3=4", &MACRO_B), ["1 skip1 «/N1#1=2» N=1 «N1» #(1) = 2", "1 «#3=4» #(3) = 4"]);
    assert_eq!(
        show(b"X#1 Y-#2 Z[#3*2] A-[1] B+##4", &MACRO_B),
        ["1 «X#1 Y-#2 Z[#3*2] A-[1] B+##4» X=(#1) «X#1» Y=(#2 Negate) «Y-#2» \
         Z=(#3 2 Multiply) «Z[#3*2]» A=(1 Negate) «A-[1]» B=(#4 #) «B+##4»"]
    );
    assert_eq!(show(b"G#1X[SIN[30]]", &MACRO_B), ["1 «G#1X[SIN[30]]» G=(#1) «G#1» X=(30 Sin) «X[SIN[30]]»"]);
    assert_eq!(show(b"#1=2\x1A\0", &MACRO_B).len(), 1);
    assert!(!page(b"#1=2\x1A\0", &MACRO_B).blocks[0].is_defective);
}

#[test]
fn what_is_wrong_with_a_statement() {
    table(
        &MACRO_B,
        &[
            ("#1", "MalformedStatement «1»"),
            ("#1=", "MalformedExpression «=»"),
            ("#1=2]", "MalformedStatement «]»"),
            ("#1=2 X3", "MixedStatement «X3»"),
            ("G0 #1=2", "G=0 «G0» MixedStatement «#1=2»"),
            ("N1 N2 #1=2", "N=1 «N1» N=2 «N2» MixedStatement «#1=2»"),
            ("X1 IF[#1EQ0]GOTO5", "X=1 «X1» MixedStatement «IF[#1EQ0]GOTO5»"),
            ("IF #1 GOTO 2", "MalformedStatement «#1 GOTO 2»"),
            ("IF[#1EQ0]", "MalformedStatement «]»"),
            ("IF[#1EQ0] M30", "MalformedStatement «M30»"),
            ("IF[#1EQ0]THEN X1", "MalformedStatement «X1»"),
            ("WHILE[#1]", "MalformedStatement «]»"),
            ("DO", "MalformedStatement «O»"),
            ("DO1.5", "MalformedStatement «1.5»"),
            ("DO-1", "MalformedStatement «-1»"),
            ("END 70000", "MalformedStatement «70000»"),
            ("THEN #1=2", "MalformedStatement «THEN #1=2»"),
            ("#1=[1", "UnbalancedBracket «[»"),
            ("#1=1 2", "MalformedStatement «2»"),
            ("#1=FOO[2]", "UnknownFunction «FOO»"),
            ("#1=SIN", "MalformedExpression «SIN»"),
            ("#1=@", "MalformedExpression «@»"),
            ("#1=2+ (a)", "MalformedExpression «(»"),
            ("GOTO", "MalformedExpression «O»"),
        ],
    );
}

#[test]
fn values_worked_out_by_hand() {
    // Variable #n is worth 10 n.
    for (text, value) in [
        ("1+2*3", 7.0),
        ("[1+2]*3", 9.0),
        ("10-4-3", 3.0),
        ("8/4/2", 1.0),
        ("2*3+4*5", 26.0),
        ("2+3*4-5", 9.0),
        ("#2+#3*SIN[90]", 50.0),
        ("-2*3+10", 4.0),
        ("10--2", 12.0),
        ("10*-2", -20.0),
        ("7 MOD 4*2", 6.0),
        ("6 AND 3+8", 10.0),
        ("8+6 AND 3", 10.0),
        ("1 OR 6 AND 2", 3.0),
        ("12 XOR 10 OR 1", 7.0),
        ("1+1 OR 4*2", 10.0),
        ("1+2 GT 2", 1.0),
        ("2 LT 1+1", 0.0),
        ("2 LE 1+1", 1.0),
        ("3 NE 3 EQ 0", 1.0),
        ("5GE5", 1.0),
        ("##1", 100.0),
        ("#[1+#1/5]", 30.0),
        ("-[-[-[1]]]", -1.0),
        ("SIN[30]*2", 1.0),
        ("SI[30]+CO[60]", 1.0),
        ("TAN[45]", 1.0),
        ("ASIN[1]-ACOS[0]", 0.0),
        ("ATAN[1]", 45.0),
        ("ATAN[1]/2", 22.5),
        ("ATAN[-1]/[-1]", -135.0),
        ("AT[1]/[0]*2", 180.0),
        ("ATAN[1] / [1] / 5", 9.0),
        ("SQRT[16]+SQ[9]", 7.0),
        ("ABS[-2]*AB[3]", 6.0),
        ("ROUND[1.5]", 2.0),
        ("FIX[-1.2]", -1.0),
        ("FUP[-1.2]", -2.0),
        ("FUP[1.2]-FIX[1.2]", 1.0),
        ("EXP[LN[5]]", 5.0),
        ("BCD[39]", 57.0),
        ("BIN[57]", 39.0),
        ("-SQRT[4]", -2.0),
        ("[[[[[5]]]]]", 5.0),
    ] {
        let found = value_of(text, &MACRO_B);
        assert!((found - value).abs() < 1e-9, "{text} is {found}, not {value}");
    }
    for (text, value) in [
        ("(1+2)*[3]", 9.0),
        ("2**3**2", 64.0),
        ("2*3**2", 18.0),
        ("1+2>2", 1.0),
        ("1>=1&&2>1||0", 1.0),
        ("(3>2)*5+(2==3)*7", 5.0),
        ("#(1+1)", 20.0),
        ("SIN(90)", 1.0),
    ] {
        assert_eq!(value_of(text, &GROUPS), value, "{text}");
    }
}

#[test]
fn round_brackets_are_groups_or_comments_as_the_syntax_has_it() {
    assert_eq!(
        show(b"X(1+2) Y-(#1)", &GROUPS),
        ["1 «X(1+2) Y-(#1)» X=(1 2 Add) «X(1+2)» Y=(#1 Negate) «Y-(#1)»"]
    );
    assert_eq!(show(b"#(1+2)=3", &GROUPS), ["1 «#(1+2)=3» #(1 2 Add) = 3"]);
    assert_eq!(show(b"IF(#1>2)GOTO3", &GROUPS), ["1 «IF(#1>2)GOTO3» if #1 2 Greater goto 3"]);
    assert_eq!(show(b"X(1+2)", &MACRO_B), ["1 «X» AddressWithoutNumber «X»"]);
}

#[test]
fn brackets_are_counted_without_signs_and_variables() {
    for (text, sound) in [
        ("[[[[[1]]]]]", true),
        ("[[[[[[1]]]]]]", false),
        ("-[-[-[-[-[1]]]]]", true),
        ("#[#[#[#[#[1]]]]]", true),
        ("SIN[COS[TAN[ABS[FIX[1]]]]]", true),
        ("SIN[COS[TAN[ABS[FIX[[1]]]]]]", false),
        ("1+[2*[3+[4*[5+[6]]]]]", true),
        ("------------------------------1", true),
        ("-------------------------------1", false),
    ] {
        let text = format!("#1={text}");
        assert_eq!(!page(text.as_bytes(), &MACRO_B).blocks[0].is_defective, sound, "{text}");
    }
    assert_eq!(show(b"#1=[[[[[[1]]]]]]", &MACRO_B), ["1 «#1=[[[[[[1]]]]]]» BracketsTooDeep «[»"]);
}

fn value_of(text: &str, syntax: &Syntax) -> f64 {
    let text = format!("#1={text}");
    let page = page(text.as_bytes(), syntax);
    match page.statement(&page.blocks[0]) {
        Some(Statement::Assign { value, .. }) => evaluate(page.nodes(*value)),
        _ => panic!("{text}: {:?}", page.defects),
    }
}

/// An expression as a tree, to be written and worked out apart from the parser.
#[derive(Clone, Debug)]
enum Tree {
    Number(u16),
    Variable(u16),
    Negate(Box<Tree>),
    Binary(usize, Box<Tree>, Box<Tree>),
    Call(usize, Box<Tree>),
}

/// Operators of [`MACRO_B`] and their bindings, by the manual and not by the table.
const OPERATORS: &[(&str, Binary, u8)] = &[
    ("+", Binary::Add, 2),
    ("-", Binary::Subtract, 2),
    ("*", Binary::Multiply, 3),
    ("/", Binary::Divide, 3),
    (" MOD ", Binary::Modulo, 3),
    (" AND ", Binary::And, 3),
    ("OR", Binary::Or, 2),
    ("XOR", Binary::Xor, 2),
    (" GE ", Binary::GreaterEqual, 1),
    ("NE", Binary::NotEqual, 1),
];

const FUNCTIONS: &[(&str, Function)] =
    &[("SIN", Function::Sin), ("ABS", Function::Abs), ("FIX", Function::Fix), ("SQ", Function::Sqrt)];

impl Tree {
    /// With no brackets but those that are needed.
    fn write(&self, least: u8) -> String {
        match self {
            Tree::Number(n) => n.to_string(),
            Tree::Variable(n) => format!("#{n}"),
            Tree::Negate(of) => format!("-{}", of.write(4)),
            Tree::Call(f, of) => format!("{}[{}]", FUNCTIONS[*f].0, of.write(0)),
            Tree::Binary(operator, a, b) => {
                let (name, _, binding) = OPERATORS[*operator];
                let text = format!("{}{name}{}", a.write(binding), b.write(binding + 1));
                if binding < least { format!("[{text}]") } else { text }
            }
        }
    }

    fn value(&self) -> f64 {
        match self {
            Tree::Number(n) => f64::from(*n),
            Tree::Variable(n) => f64::from(*n) * 10.0,
            Tree::Negate(of) => -of.value(),
            Tree::Call(f, of) => function(FUNCTIONS[*f].1, of.value()),
            Tree::Binary(operator, a, b) => binary(OPERATORS[*operator].1, a.value(), b.value()),
        }
    }
}

fn tree() -> impl Strategy<Value = Tree> {
    let leaf = prop_oneof![any::<u16>().prop_map(Tree::Number), any::<u16>().prop_map(Tree::Variable)];
    leaf.prop_recursive(8, 40, 2, |inner| {
        prop_oneof![
            inner.clone().prop_map(|t| Tree::Negate(Box::new(t))),
            (0..FUNCTIONS.len(), inner.clone()).prop_map(|(f, t)| Tree::Call(f, Box::new(t))),
            (0..OPERATORS.len(), inner.clone(), inner).prop_map(|(o, a, b)| Tree::Binary(
                o,
                Box::new(a),
                Box::new(b)
            )),
        ]
    })
}

proptest! {
    #![proptest_config(ProptestConfig::with_cases(3000))]
    #[test]
    fn what_is_written_is_what_is_read(tree in tree()) {
        const DEEP: Syntax = Syntax { max_brackets: 30, ..MACRO_B };
        let text = format!("X[{}]", tree.write(0));
        let page = page(text.as_bytes(), &DEEP);
        prop_assert!(!page.blocks[0].is_defective, "{text} {:?}", page.defects);
        let Value::Expression(range) = page.words[0].value() else { panic!("{text}") };
        let found = evaluate(page.nodes(range));
        prop_assert_eq!(found.to_bits(), tree.value().to_bits(), "{}", text);
    }
}
