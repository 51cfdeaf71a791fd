//! A page of lexed program: blocks, words and expression nodes in flat arrays.
//!
//! A page holds the blocks of up to 64 KiB of text. Blocks point into the page's words, words into
//! its nodes; nothing is allocated per block. Offsets are counted from the page's first byte, so that
//! a word takes 16 bytes; [`Page::span`] turns them into spans of the file.

use crate::expression::Node;
use crate::span::{FileId, Span};

/// A range of [`Page::nodes`]: one expression in postfix order.
#[derive(Clone, Copy, PartialEq, Eq, Debug, Default)]
pub struct ExprRange {
    /// First node.
    pub start: u32,
    /// Number of nodes.
    pub len: u32,
}

/// A piece of text within a page.
#[derive(Clone, Copy, PartialEq, Eq, Debug, Default)]
pub struct TextRange {
    /// Offset of its first byte in the page.
    pub at: u32,
    /// Length, bytes.
    pub len: u32,
}

/// Value of a word.
#[derive(Clone, Copy, PartialEq, Debug)]
pub enum Value {
    /// A number as written.
    Number(f64),
    /// A variable or expression.
    Expression(ExprRange),
    /// Text, without its quotes or brackets.
    Text(TextRange),
}

/// An address and its value.
#[derive(Clone, Copy, PartialEq, Debug)]
pub struct Word {
    /// Number bits, or an expression's range.
    bits: u64,
    /// Offset in the page of the address letter, or of the comma before it.
    pub at: u32,
    /// Length from there to the end of the value, bytes.
    pub len: u16,
    /// The address in upper case; for one of several letters the byte that stands for it
    /// ([`Syntax::long_addresses`](crate::Syntax::long_addresses)).
    pub letter: u8,
    flags: u8,
}

const COMMA: u8 = 1;
const POINT: u8 = 2;
const EXPRESSION: u8 = 4;
const TEXT: u8 = 8;

impl Word {
    /// A word with a number; `point` tells whether it was written with a decimal point, `comma`
    /// whether a comma stood before the letter (`,R5`).
    pub fn number(letter: u8, value: f64, point: bool, comma: bool, at: u32, len: u16) -> Word {
        let flags = if point { POINT } else { 0 } | if comma { COMMA } else { 0 };
        Word { bits: value.to_bits(), at, len, letter, flags }
    }

    /// A word with an expression.
    pub fn expression(letter: u8, range: ExprRange, comma: bool, at: u32, len: u16) -> Word {
        let flags = EXPRESSION | if comma { COMMA } else { 0 };
        Word { bits: u64::from(range.start) << 32 | u64::from(range.len), at, len, letter, flags }
    }

    /// A word with text.
    pub fn text(letter: u8, text: TextRange, at: u32, len: u16) -> Word {
        Word { bits: u64::from(text.at) << 32 | u64::from(text.len), at, len, letter, flags: TEXT }
    }

    /// What stands behind the address.
    #[inline]
    pub fn value(&self) -> Value {
        let (first, second) = ((self.bits >> 32) as u32, self.bits as u32);
        if self.flags & (EXPRESSION | TEXT) == 0 {
            Value::Number(f64::from_bits(self.bits))
        } else if self.flags & TEXT == 0 {
            Value::Expression(ExprRange { start: first, len: second })
        } else {
            Value::Text(TextRange { at: first, len: second })
        }
    }

    /// Whether the number was written with a decimal point.
    pub fn has_point(&self) -> bool {
        self.flags & POINT != 0
    }

    /// Whether a comma stood before the letter.
    #[inline]
    pub fn has_comma(&self) -> bool {
        self.flags & COMMA != 0
    }
}

/// A statement of the macro language, as read; what it does is the interpreter's.
#[derive(Clone, Copy, PartialEq, Debug)]
pub enum Statement {
    /// `#i = value`. `target` computes the variable's number.
    Assign {
        /// Number of the variable.
        target: ExprRange,
        /// What it is set to.
        value: ExprRange,
    },
    /// `GOTO n`, or with a condition `IF [c] GOTO n`.
    Goto {
        /// Jump only if this holds.
        condition: Option<ExprRange>,
        /// Sequence number.
        target: ExprRange,
    },
    /// `IF [c] THEN #i = value`.
    IfAssign {
        /// Assign only if this holds.
        condition: ExprRange,
        /// Number of the variable.
        target: ExprRange,
        /// What it is set to.
        value: ExprRange,
    },
    /// `WHILE [c] DO n`, or `DO n` without a condition.
    While {
        /// Loop while this holds.
        condition: Option<ExprRange>,
        /// Number that pairs it with its end.
        label: u16,
    },
    /// `END n`.
    EndWhile {
        /// Number that pairs it with its beginning.
        label: u16,
    },
    /// `$IF c`: the blocks behind it are run if it holds.
    If {
        /// The condition.
        condition: ExprRange,
    },
    /// `$ELSEIF c`.
    ElseIf {
        /// The condition.
        condition: ExprRange,
    },
    /// `$ELSE`.
    Else,
    /// `$ENDIF`.
    EndIf,
    /// `$FOR Pn = first, last, step`.
    For {
        /// Number of the variable that counts.
        target: ExprRange,
        /// What it starts with.
        first: ExprRange,
        /// What it does not pass.
        last: ExprRange,
        /// What is added each time; 1 where it is not given.
        step: Option<ExprRange>,
    },
    /// `$ENDFOR`.
    EndFor,
    /// `$WHILE c`.
    WhileBlock {
        /// Loop while this holds.
        condition: ExprRange,
    },
    /// `$ENDWHILE`.
    EndWhileBlock,
    /// `$BREAK`: out of the innermost loop.
    Break,
    /// `$CONTINUE`: to the end of its present pass.
    Continue,
    /// `#…`, by its place in [`Page::directives`].
    Directive(u32),
    /// `O… word`, by its place in [`Page::o_words`].
    OWord(u32),
}

/// What the label of an O word is.
#[derive(Clone, Copy, PartialEq, Eq, Debug)]
pub enum Label {
    /// `O100`.
    Number(u32),
    /// `O<name>`, by its number in [`Names`](crate::Names).
    Name(u32),
    /// `O#1` or `O[…]`: a number that is computed.
    Computed(ExprRange),
}

/// What an O word commands.
#[derive(Clone, Copy, PartialEq, Eq, Debug)]
#[allow(missing_docs)]
pub enum OKeyword {
    Sub,
    EndSub,
    Call,
    Return,
    Do,
    While,
    EndWhile,
    If,
    ElseIf,
    Else,
    EndIf,
    Break,
    Continue,
    Repeat,
    EndRepeat,
    /// None: a program begins, called by M98.
    Program,
}

/// A line with an O word.
#[derive(Clone, Copy, PartialEq, Eq, Debug)]
pub struct OWord {
    /// What it is called by.
    pub label: Label,
    /// What it commands.
    pub keyword: OKeyword,
    /// First of the values behind it, in [`Page::values`].
    pub first: u32,
    /// How many.
    pub count: u16,
}

/// A directive, `#CYCLE G281 [X=10, mode=depth]`.
#[derive(Clone, Copy, PartialEq, Eq, Debug)]
pub struct Directive {
    /// First of its names in [`Page::names`]: `CYCLE` and `G281`.
    pub first_name: u32,
    /// How many.
    pub names: u16,
    /// Number of its arguments.
    pub arguments: u16,
    /// The first of them in [`Page::arguments`].
    pub first_argument: u32,
}

/// An argument of a directive.
#[derive(Clone, Copy, PartialEq, Eq, Debug)]
pub struct Argument {
    /// What stands before `=`; empty where nothing does.
    pub name: TextRange,
    /// The value as written.
    pub text: TextRange,
    /// The value, where it can be read as an expression. What may be a name too is the dialect's to tell.
    pub value: Option<ExprRange>,
    /// The items of a list in brackets, `[50, 25]`, in [`Page::items`]: the first, and how many.
    pub items: Option<(u32, u16)>,
}

/// What is wrong with a piece of text.
#[derive(Clone, Copy, PartialEq, Eq, Debug)]
pub enum DefectKind {
    /// A character that no block may hold.
    IllegalCharacter,
    /// A number without an address before it.
    NumberWithoutAddress,
    /// An address without a value behind it.
    AddressWithoutNumber,
    /// A sign where none may stand.
    MisplacedSign,
    /// A decimal point where none may stand.
    MisplacedPoint,
    /// A number too large for any control.
    NumberTooLarge,
    /// A line longer than the control takes, which then is one block without words; or a block with
    /// more words than any control takes.
    LineTooLong,
    /// A comment that is not closed.
    UnclosedComment,
    /// Brackets that do not pair.
    UnbalancedBracket,
    /// Brackets, or signs or `#`, nested too deep.
    BracketsTooDeep,
    /// An expression that cannot be read.
    MalformedExpression,
    /// A function that the language does not have.
    UnknownFunction,
    /// A statement that cannot be read.
    MalformedStatement,
    /// Words and a statement in one block.
    MixedStatement,
    /// A variable name that the language does not have.
    UnknownVariable,
    /// Text whose quote or bracket is not closed.
    UnclosedText,
}

/// A defect and where it stands.
#[derive(Clone, Copy, PartialEq, Eq, Debug)]
pub struct Defect {
    /// Index of its block in the page.
    pub block: u32,
    /// What is wrong.
    pub kind: DefectKind,
    /// Offset in the page.
    pub at: u32,
    /// Length, bytes.
    pub len: u32,
}

/// One block.
#[derive(Clone, Copy, PartialEq, Debug, Default)]
pub struct Block {
    /// Offset of its first byte in the page.
    pub at: u32,
    /// Length to the end of its last word, statement or defect, bytes.
    pub len: u32,
    /// Line, counted from 1.
    pub line: u32,
    /// First word.
    pub first_word: u32,
    /// Number of words.
    pub words: u16,
    /// How many `/` stand before it, at most 255.
    pub skip: u8,
    /// Whether it is the mark `%` behind a program. One before the first block of a file opens the
    /// program and is no block.
    pub is_mark: bool,
    /// Whether the page lists defects of it.
    pub is_defective: bool,
    /// Statement of the macro language; words then are at most an N word before it.
    pub statement: Option<u16>,
    /// Condition without which the block does nothing.
    pub guard: Option<u16>,
}

/// Lexed blocks of a stretch of text.
#[derive(Clone, PartialEq, Debug, Default)]
pub struct Page {
    /// The file that the text is of.
    pub file: FileId,
    /// Offset of the page's first byte in the file.
    pub offset: u64,
    /// Blocks in order.
    pub blocks: Vec<Block>,
    /// Words of all blocks.
    pub words: Vec<Word>,
    /// Nodes of all expressions.
    pub nodes: Vec<Node>,
    /// Statements of all blocks.
    pub statements: Vec<Statement>,
    /// Conditions of all blocks.
    pub guards: Vec<ExprRange>,
    /// Directives of all blocks.
    pub directives: Vec<Directive>,
    /// Their names.
    pub names: Vec<TextRange>,
    /// Their arguments.
    pub arguments: Vec<Argument>,
    /// Items of lists among these; they have no name and no items.
    pub items: Vec<Argument>,
    /// O words of all blocks.
    pub o_words: Vec<OWord>,
    /// Values behind these.
    pub values: Vec<ExprRange>,
    /// Defects of all blocks, in order of blocks.
    pub defects: Vec<Defect>,
}

impl Page {
    /// The O word of a block.
    #[inline]
    pub fn o_word(&self, block: &Block) -> Option<&OWord> {
        match self.statement(block)? {
            Statement::OWord(at) => self.o_words.get(*at as usize),
            _ => None,
        }
    }

    /// The values behind an O word.
    #[inline]
    pub fn values(&self, word: &OWord) -> &[ExprRange] {
        let first = word.first as usize;
        self.values.get(first..first + usize::from(word.count)).unwrap_or(&[])
    }

    /// Words of a block.
    #[inline]
    pub fn words(&self, block: &Block) -> &[Word] {
        let first = block.first_word as usize;
        self.words.get(first..first + usize::from(block.words)).unwrap_or(&[])
    }

    /// Nodes of an expression.
    #[inline]
    pub fn nodes(&self, range: ExprRange) -> &[Node] {
        let start = range.start as usize;
        self.nodes.get(start..start + range.len as usize).unwrap_or(&[])
    }

    /// The macro statement of a block.
    pub fn statement(&self, block: &Block) -> Option<&Statement> {
        self.statements.get(usize::from(block.statement?))
    }

    /// The condition without which a block does nothing.
    pub fn guard(&self, block: &Block) -> Option<ExprRange> {
        self.guards.get(usize::from(block.guard?)).copied()
    }

    /// A directive.
    pub fn directive(&self, place: u32) -> Option<&Directive> {
        self.directives.get(place as usize)
    }

    /// Where the names of a directive stand.
    pub fn directive_names(&self, directive: &Directive) -> &[TextRange] {
        let first = directive.first_name as usize;
        self.names.get(first..first + usize::from(directive.names)).unwrap_or(&[])
    }

    /// The arguments of a directive.
    pub fn directive_arguments(&self, directive: &Directive) -> &[Argument] {
        let first = directive.first_argument as usize;
        self.arguments.get(first..first + usize::from(directive.arguments)).unwrap_or(&[])
    }

    /// The items of a list.
    pub fn list(&self, argument: &Argument) -> &[Argument] {
        let Some((first, count)) = argument.items else { return &[] };
        let first = first as usize;
        self.items.get(first..first + usize::from(count)).unwrap_or(&[])
    }

    /// Defects of the block with this index.
    pub fn defects(&self, block: usize) -> impl Iterator<Item = &Defect> {
        let first = self.defects.partition_point(|d| (d.block as usize) < block);
        self.defects.iter().skip(first).take_while(move |d| d.block as usize == block)
    }

    /// Span in the file of `len` bytes from offset `at` of the page on, in `block`.
    #[inline]
    pub fn span(&self, block: &Block, at: u32, len: u32) -> Span {
        Span { file: self.file, offset: self.offset + u64::from(at), len, line: block.line }
    }

    /// Span of a whole block.
    #[inline]
    pub fn block_span(&self, block: &Block) -> Span {
        self.span(block, block.at, block.len)
    }

    /// Span of a word.
    #[inline]
    pub fn word_span(&self, block: &Block, word: &Word) -> Span {
        self.span(block, word.at, u32::from(word.len))
    }
}
