//! What the tests share: two syntaxes, blocks as readable text, what holds for every page, and an
//! evaluator of expressions that knows nothing of the parser.

#![allow(dead_code, missing_docs, clippy::unwrap_used, clippy::panic)]

use ferrocut_program::expression::MAX_STACK;
use ferrocut_program::{
    Binary, Block, Defect, DefectKind, ExprRange, FileId, Function, Keyword, Node, Page, ProgramMemory,
    Statement, Syntax, Unary, Value, Word, lexer,
};
use std::fmt::Write;
use std::sync::Arc;

/// Macro B as Fanuc and GSK have it (GSK990MC 4.9.5): AND binds like `*`, OR and XOR like `+`.
pub const MACRO_B: Syntax = Syntax {
    paren_comments: true,
    paren_groups: false,
    keywords: &[
        ("IF", Keyword::If),
        ("THEN", Keyword::Then),
        ("GOTO", Keyword::Goto),
        ("WHILE", Keyword::While),
        ("DO", Keyword::Do),
        ("END", Keyword::End),
    ],
    functions: &[
        ("SIN", Function::Sin),
        ("SI", Function::Sin),
        ("COS", Function::Cos),
        ("CO", Function::Cos),
        ("TAN", Function::Tan),
        ("TA", Function::Tan),
        ("ASIN", Function::Asin),
        ("AS", Function::Asin),
        ("ACOS", Function::Acos),
        ("AC", Function::Acos),
        ("ATAN", Function::Atan),
        ("AT", Function::Atan),
        ("SQRT", Function::Sqrt),
        ("SQ", Function::Sqrt),
        ("ABS", Function::Abs),
        ("AB", Function::Abs),
        ("ROUND", Function::Round),
        ("RO", Function::Round),
        ("FIX", Function::Fix),
        ("FI", Function::Fix),
        ("FUP", Function::Fup),
        ("FU", Function::Fup),
        ("LN", Function::Ln),
        ("EXP", Function::Exp),
        ("EX", Function::Exp),
        ("BIN", Function::Bin),
        ("BI", Function::Bin),
        ("BCD", Function::Bcd),
        ("BC", Function::Bcd),
    ],
    operators: &[
        ("EQ", Binary::Equal, 1),
        ("NE", Binary::NotEqual, 1),
        ("GT", Binary::Greater, 1),
        ("GE", Binary::GreaterEqual, 1),
        ("LT", Binary::Less, 1),
        ("LE", Binary::LessEqual, 1),
        ("+", Binary::Add, 2),
        ("-", Binary::Subtract, 2),
        ("OR", Binary::Or, 2),
        ("XOR", Binary::Xor, 2),
        ("*", Binary::Multiply, 3),
        ("/", Binary::Divide, 3),
        ("MOD", Binary::Modulo, 3),
        ("AND", Binary::And, 3),
    ],
    max_line: 4096,
    max_brackets: 5,
    ..Syntax::WORDS
};

/// Round brackets group, six precedences, brackets as deep as the parser goes.
pub const GROUPS: Syntax = Syntax {
    paren_comments: false,
    paren_groups: true,
    keywords: MACRO_B.keywords,
    functions: MACRO_B.functions,
    operators: &[
        ("||", Binary::LogicalOr, 1),
        ("&&", Binary::LogicalAnd, 2),
        (">=", Binary::GreaterEqual, 3),
        (">", Binary::Greater, 3),
        ("==", Binary::Equal, 3),
        ("+", Binary::Add, 4),
        ("-", Binary::Subtract, 4),
        ("**", Binary::Power, 6),
        ("*", Binary::Multiply, 5),
        ("/", Binary::Divide, 5),
    ],
    max_line: usize::MAX,
    max_brackets: u8::MAX,
    ..Syntax::WORDS
};

/// What the other two lack: comments to the end of the line, `X=…`, guards, text, long addresses, names.
pub const NAMES: Syntax = Syntax {
    paren_comments: false,
    paren_groups: true,
    keywords: &[("IF", Keyword::If)],
    functions: &[
        ("SIN", Function::Sin),
        ("LOG", Function::Ln),
        ("ABS", Function::Abs),
        ("INT", Function::Floor),
        ("CTG", Function::Cot),
    ],
    operators: &[
        ("||", Binary::LogicalOr, 1),
        ("&&", Binary::LogicalAnd, 1),
        ("==", Binary::Equal, 2),
        (">", Binary::Greater, 2),
        ("+", Binary::Add, 3),
        ("-", Binary::Subtract, 3),
        ("*", Binary::Multiply, 4),
        ("/", Binary::Divide, 4),
    ],
    max_line: 4096,
    max_brackets: 20,
    line_comments: &[b"'", b"\xE2\x80\xB2", b"\xA1\xE4"],
    equals_in_words: true,
    blanks_in_expressions: false,
    bare_arguments: true,
    logical_not: true,
    if_guards_block: true,
    texts: true,
    text_address: Some(b'a'),
    long_addresses: &[("MSG", b'a'), ("PLC", b'b'), ("FX", b'c')],
    named_variables: &[("SAFE", 5001), ("POS.X", 5002)],
    variable_families: &[("FC", 6000, 100)],
    ..Syntax::WORDS
};

/// Parameters without a sign, keywords with one, directives, axes with a digit.
pub const SIGNS: Syntax = Syntax {
    paren_comments: true,
    keywords: &[
        ("IF", Keyword::If),
        ("ELSEIF", Keyword::ElseIf),
        ("ELSE", Keyword::Else),
        ("ENDIF", Keyword::EndIf),
        ("FOR", Keyword::For),
        ("ENDFOR", Keyword::EndFor),
        ("WHILE", Keyword::While),
        ("ENDWHILE", Keyword::EndWhile),
        ("GOTO", Keyword::Goto),
        ("BREAK", Keyword::Break),
        ("CONTINUE", Keyword::Continue),
    ],
    functions: &[("SIN", Function::Sin)],
    operators: &[
        ("==", Binary::Equal, 1),
        ("<", Binary::Less, 1),
        ("+", Binary::Add, 2),
        ("-", Binary::Subtract, 2),
        ("*", Binary::Multiply, 3),
    ],
    max_line: lexer::MAX_LINE,
    line_comments: &[b";"],
    equals_in_words: true,
    long_addresses: &[("NR", b'm')],
    long_values: true,
    named_variables: &[("V.C.Z", 5000)],
    variable_families: &[("P", 1, 100)],
    parameter_letter: Some(b'P'),
    keyword_sign: Some(b'$'),
    directives: true,
    numbered_axes: true,
    ..Syntax::WORDS
};

/// Lexes a text that is all of its file, and checks what holds for every page.
pub fn page(text: &[u8], syntax: &Syntax) -> Page {
    let lexed = lexer::lex(text, FileId(0), 0, 1, true, syntax);
    assert_eq!(lexed.consumed, text.len());
    check(text, &lexed.page);
    lexed.page
}

/// Pages of a file, in order.
pub fn pages(memory: &mut ProgramMemory, file: FileId) -> Vec<Arc<Page>> {
    (0..).map_while(|number| memory.page(file, number).unwrap()).collect()
}

/// Blocks as one line each: line, skips, text, words with their text, statement, defects with theirs.
pub fn show(text: &[u8], syntax: &Syntax) -> Vec<String> {
    let page = page(text, syntax);
    let blocks = page.blocks.iter().enumerate();
    blocks.map(|(at, block)| show_block(text, &page, at, block)).collect()
}

fn show_block(text: &[u8], page: &Page, index: usize, block: &Block) -> String {
    let mut out = format!("{}", block.line);
    if block.skip > 0 {
        write!(out, " skip{}", block.skip).unwrap();
    }
    if block.is_mark {
        out += " mark";
    }
    write!(out, " «{}»", cut(text, block.at, block.len)).unwrap();
    for word in page.words(block) {
        let comma = if word.has_comma() { "," } else { "" };
        let point = if word.has_point() { " point" } else { "" };
        let letter = char::from(word.letter);
        let value = match word.value() {
            Value::Number(n) => format!("{n}"),
            Value::Expression(range) => format!("({})", postfix(page, range)),
            Value::Text(range) => format!("\"{}\"", cut(text, range.at, range.len)),
        };
        write!(out, " {comma}{letter}={value}{point} «{}»", cut(text, word.at, word.len.into())).unwrap();
    }
    if let Some(guard) = page.guard(block) {
        write!(out, " if {}", postfix(page, guard)).unwrap();
    }
    if let Some(statement) = page.statement(block) {
        write!(out, " {}", show_statement(page, statement)).unwrap();
    }
    for defect in page.defects(index) {
        write!(out, " {:?} «{}»", defect.kind, cut(text, defect.at, defect.len)).unwrap();
    }
    out
}

pub fn show_statement(page: &Page, statement: &Statement) -> String {
    let show = |range: &ExprRange| postfix(page, *range);
    match statement {
        Statement::Assign { target, value } => format!("#({}) = {}", show(target), show(value)),
        Statement::Goto { condition: None, target } => format!("goto {}", show(target)),
        Statement::Goto { condition: Some(c), target } => format!("if {} goto {}", show(c), show(target)),
        Statement::IfAssign { condition, target, value } => {
            format!("if {} #({}) = {}", show(condition), show(target), show(value))
        }
        Statement::While { condition: None, label } => format!("do {label}"),
        Statement::While { condition: Some(c), label } => format!("while {} do {label}", show(c)),
        Statement::EndWhile { label } => format!("end {label}"),
        Statement::If { condition } => format!("if {}", show(condition)),
        Statement::ElseIf { condition } => format!("elseif {}", show(condition)),
        Statement::WhileBlock { condition } => format!("while {}", show(condition)),
        Statement::For { target, first, last, step } => {
            let step = step.as_ref().map_or("1".to_string(), &show);
            format!("for #({}) = {} to {} by {step}", show(target), show(first), show(last))
        }
        Statement::Else => "else".to_string(),
        Statement::EndIf => "endif".to_string(),
        Statement::EndFor => "endfor".to_string(),
        Statement::EndWhileBlock => "endwhile".to_string(),
        Statement::Break => "break".to_string(),
        Statement::Continue => "continue".to_string(),
        Statement::OWord(place) => {
            let word = page.o_words.get(*place as usize).unwrap();
            let values: Vec<String> = page.values(word).iter().map(&show).collect();
            format!("o {:?} {:?} {values:?}", word.label, word.keyword)
        }
        Statement::Directive(place) => {
            let directive = page.directive(*place).unwrap();
            let names: Vec<u32> = page.directive_names(directive).iter().map(|n| n.len).collect();
            let arguments = page.directive_arguments(directive).iter();
            let arguments: Vec<String> = arguments
                .map(|a| {
                    format!("{}:{}:{}", a.name.len, a.text.len, a.value.map_or("text".into(), |v| show(&v)))
                })
                .collect();
            format!("directive {names:?} {arguments:?}")
        }
    }
}

pub fn cut(text: &[u8], at: u32, len: u32) -> String {
    String::from_utf8_lossy(&text[at as usize..(at + len) as usize]).into_owned()
}

pub fn postfix(page: &Page, range: ExprRange) -> String {
    let nodes = page.nodes(range).iter();
    nodes
        .map(|node| match node {
            Node::Number(n) => format!("{n}"),
            Node::VariableAt(n) => format!("#{n}"),
            Node::Variable => "#".to_string(),
            Node::Unary(u) => format!("{u:?}"),
            Node::Binary(b) => format!("{b:?}"),
            Node::Call(f) => format!("{f:?}"),
            Node::Exists(name) => format!("exists {name}"),
        })
        .collect::<Vec<_>>()
        .join(" ")
}

/// What holds for the page of any text: `text` is what the page's offsets count in.
pub fn check(text: &[u8], page: &Page) {
    let mut end = 0;
    let mut next_word = 0;
    let mut line_start = 0;
    let mut line = page.blocks.first().map_or(1, |b| b.line);
    for (index, block) in page.blocks.iter().enumerate() {
        let (at, block_end) = (block.at as usize, (block.at + block.len) as usize);
        assert!(end <= at && at <= block_end && block_end <= text.len(), "block {block:?} behind {end}");
        if index > 0 {
            line += line_ends(&text[line_start..at]);
        }
        assert_eq!(block.line, line, "line of {block:?}");
        line_start = at;
        let inside = &text[at..block_end];
        assert!(!inside.iter().any(|b| matches!(b, b'\n' | b'\r')), "line end in {block:?}");
        assert_eq!(block.first_word, next_word);
        next_word += u32::from(block.words);
        assert_eq!(page.words(block).len(), usize::from(block.words));
        let mut word_end = at;
        for word in page.words(block) {
            let (at, end) = (word.at as usize, word.at as usize + usize::from(word.len));
            assert!(word_end <= at && at < end && end <= block_end, "{word:?} in {block:?}");
            word_end = end;
            let letter = if word.has_comma() {
                assert_eq!(text[at], b',');
                // Blanks may stand behind it.
                *text[at + 1..].iter().find(|byte| !matches!(byte, b' ' | b'\t')).unwrap()
            } else {
                text[at]
            };
            // A small letter stands for an address of several, or of none; a byte beyond for an axis with a
            // digit.
            let numbered = ferrocut_program::numbered_axis_name(word.letter);
            assert!(
                word.letter == letter.to_ascii_uppercase()
                    || word.letter.is_ascii_lowercase()
                    || numbered.is_some_and(|[own, _]| own == letter.to_ascii_uppercase())
            );
            assert!(word.letter.is_ascii_alphabetic() || numbered.is_some());
            match word.value() {
                Value::Number(n) => assert!(n.is_finite()),
                Value::Expression(range) => check_expression(page, range),
                Value::Text(range) => {
                    let (from, to) = (range.at as usize, (range.at + range.len) as usize);
                    assert!(at < from && from <= to && to < end, "{word:?} in {block:?}");
                }
            }
        }
        assert_eq!(block.guard.is_some(), page.guard(block).is_some());
        if let Some(guard) = page.guard(block) {
            check_expression(page, guard);
        }
        if let Some(statement) = page.statement(block) {
            for range in ranges(statement) {
                check_expression(page, range);
            }
            check_directive(text, page, block, statement);
            assert!(block.words <= 1);
        }
        assert_eq!(block.statement.is_some(), page.statement(block).is_some());
        let defects: Vec<&Defect> = page.defects(index).collect();
        assert_eq!(block.is_defective, !defects.is_empty());
        for defect in defects {
            let (from, to) = (defect.at as usize, (defect.at + defect.len) as usize);
            assert!(at <= from && from <= to && to <= block_end, "{defect:?} in {block:?}");
            assert!(defect.len > 0 || defect.kind == DefectKind::LineTooLong, "{defect:?}");
        }
        end = block_end;
    }
    assert_eq!(next_word as usize, page.words.len());
    assert!(page.defects.is_sorted_by_key(|d| d.block));
    assert!(page.defects.last().is_none_or(|d| (d.block as usize) < page.blocks.len()));
}

/// Names and arguments of a directive lie within its block, and their expressions have one value.
fn check_directive(text: &[u8], page: &Page, block: &Block, statement: &Statement) {
    let Statement::Directive(place) = statement else { return };
    let directive = page.directive(*place).unwrap();
    let within = |range: ferrocut_program::TextRange| {
        let end = range.at + range.len;
        range == ferrocut_program::TextRange::default()
            || block.at <= range.at && end <= block.at + block.len && end as usize <= text.len()
    };
    assert!(!page.directive_names(directive).is_empty());
    assert!(page.directive_names(directive).iter().all(|name| within(*name)));
    for argument in page.directive_arguments(directive) {
        for part in page.list(argument).iter().chain([argument]) {
            assert!(within(part.name) && within(part.text), "{part:?}");
            if let Some(range) = part.value {
                check_expression(page, range);
            }
        }
    }
}

/// Line ends in a text: LF, CR LF, or CR alone.
pub fn line_ends(text: &[u8]) -> u32 {
    let ends = text.iter().enumerate();
    ends.filter(|(at, b)| **b == b'\n' || **b == b'\r' && text.get(at + 1) != Some(&b'\n')).count() as u32
}

pub fn ranges(statement: &Statement) -> Vec<ExprRange> {
    match *statement {
        Statement::Assign { target, value } => vec![target, value],
        Statement::Goto { condition, target } => condition.into_iter().chain([target]).collect(),
        Statement::IfAssign { condition, target, value } => vec![condition, target, value],
        Statement::While { condition, .. } => condition.into_iter().collect(),
        Statement::If { condition }
        | Statement::ElseIf { condition }
        | Statement::WhileBlock { condition } => vec![condition],
        Statement::For { target, first, last, step } => {
            [target, first, last].into_iter().chain(step).collect()
        }
        _ => vec![],
    }
}

/// One value comes out, operands are always there, and the stack stays within what is promised.
fn check_expression(page: &Page, range: ExprRange) {
    assert!(range.len > 0 && range.start as usize + range.len as usize <= page.nodes.len());
    assert!(deepest(page.nodes(range)) <= MAX_STACK);
}

/// The deepest stack in evaluating an expression.
pub fn deepest(nodes: &[Node]) -> usize {
    let mut depth = 0usize;
    let mut most = 0;
    for node in nodes {
        let operands = match node {
            Node::Number(_) | Node::VariableAt(_) | Node::Exists(_) => 0,
            Node::Variable | Node::Unary(_) => 1,
            Node::Call(Function::Atan2) | Node::Binary(_) => 2,
            Node::Call(_) => 1,
        };
        assert!(operands <= depth, "operands of {node:?} missing");
        depth = depth - operands + 1;
        most = most.max(depth);
    }
    assert_eq!(depth, 1, "one value comes out");
    most
}

/// Evaluates an expression; variables are worth ten times their number.
pub fn evaluate(nodes: &[Node]) -> f64 {
    let mut stack: Vec<f64> = Vec::new();
    for node in nodes {
        let value = match *node {
            Node::Number(n) => n,
            Node::VariableAt(n) => f64::from(n) * 10.0,
            Node::Exists(_) => 0.0,
            Node::Variable => stack.pop().unwrap().trunc() * 10.0,
            Node::Unary(Unary::Negate) => -stack.pop().unwrap(),
            Node::Unary(Unary::Plus) => stack.pop().unwrap(),
            Node::Unary(Unary::Not) => f64::from(u8::from(stack.pop().unwrap() == 0.0)),
            Node::Binary(operator) => {
                let b = stack.pop().unwrap();
                let a = stack.pop().unwrap();
                binary(operator, a, b)
            }
            Node::Call(Function::Atan2) => {
                let b = stack.pop().unwrap();
                stack.pop().unwrap().atan2(b).to_degrees()
            }
            Node::Call(f) => function(f, stack.pop().unwrap()),
        };
        stack.push(value);
    }
    assert_eq!(stack.len(), 1);
    stack[0]
}

pub fn binary(operator: Binary, a: f64, b: f64) -> f64 {
    let truth = |t: bool| f64::from(u8::from(t));
    match operator {
        Binary::Add => a + b,
        Binary::Subtract => a - b,
        Binary::Multiply => a * b,
        Binary::Divide => a / b,
        Binary::Modulo => a % b,
        Binary::Power => a.powf(b),
        Binary::And => (a as i64 & b as i64) as f64,
        Binary::Or => (a as i64 | b as i64) as f64,
        Binary::Xor => (a as i64 ^ b as i64) as f64,
        Binary::Equal => truth(a == b),
        Binary::NotEqual => truth(a != b),
        Binary::Greater => truth(a > b),
        Binary::GreaterEqual => truth(a >= b),
        Binary::Less => truth(a < b),
        Binary::LessEqual => truth(a <= b),
        Binary::LogicalAnd => truth(a != 0.0 && b != 0.0),
        Binary::LogicalOr => truth(a != 0.0 || b != 0.0),
        Binary::LogicalXor => truth((a != 0.0) != (b != 0.0)),
    }
}

pub fn function(function: Function, x: f64) -> f64 {
    match function {
        Function::Sin => x.to_radians().sin(),
        Function::Cos => x.to_radians().cos(),
        Function::Tan => x.to_radians().tan(),
        Function::Cot => 1.0 / x.to_radians().tan(),
        Function::Floor => x.floor(),
        Function::Ceil => x.ceil(),
        Function::Asin => x.asin().to_degrees(),
        Function::Acos => x.acos().to_degrees(),
        Function::Atan => x.atan().to_degrees(),
        Function::Sqrt => x.sqrt(),
        Function::Abs => x.abs(),
        Function::Round => x.round(),
        Function::Fix => x.trunc(),
        Function::Fup => x.abs().ceil().copysign(x),
        Function::Ln => x.ln(),
        Function::Exp => x.exp(),
        Function::Bin => (0..8).map(|d| ((x as i64 >> (4 * d)) & 15) * 10i64.pow(d)).sum::<i64>() as f64,
        Function::Bcd => (0..8).map(|d| (x as i64 / 10i64.pow(d) % 10) << (4 * d)).sum::<i64>() as f64,
        Function::Atan2 | Function::Exists => unreachable!(),
    }
}

/// Words of a block with places in the file, values by their bits, expressions by their nodes.
type FlatWord = (u64, u16, u8, bool, bool, String);

/// A block without what depends on how the text was cut into pages.
#[derive(Clone, PartialEq, Debug)]
pub struct FlatBlock {
    pub offset: u64,
    pub len: u32,
    pub line: u32,
    pub skip: u8,
    pub is_mark: bool,
    pub words: Vec<FlatWord>,
    pub statement: Option<String>,
    pub guard: Option<String>,
    pub defects: Vec<(DefectKind, u64, u32)>,
}

/// Blocks of pages in a form that does not depend on where the pages start.
pub fn flat<'a>(pages: impl IntoIterator<Item = &'a Page>) -> Vec<FlatBlock> {
    let mut out = Vec::new();
    for page in pages {
        for (index, block) in page.blocks.iter().enumerate() {
            let word = |w: &Word| {
                let value = match w.value() {
                    Value::Number(n) => format!("{:x}", n.to_bits()),
                    Value::Expression(range) => postfix(page, range),
                    Value::Text(range) => format!("{} {}", page.offset + u64::from(range.at), range.len),
                };
                (page.word_span(block, w).offset, w.len, w.letter, w.has_comma(), w.has_point(), value)
            };
            out.push(FlatBlock {
                offset: page.block_span(block).offset,
                len: block.len,
                line: block.line,
                skip: block.skip,
                is_mark: block.is_mark,
                words: page.words(block).iter().map(word).collect(),
                statement: page.statement(block).map(|s| show_statement(page, s)),
                guard: page.guard(block).map(|g| postfix(page, g)),
                defects: page
                    .defects(index)
                    .map(|d| (d.kind, page.offset + u64::from(d.at), d.len))
                    .collect(),
            });
        }
    }
    out
}
