//! Stage 1, words: a block's words by address, its G and M codes looked up.

use crate::Fallible;
use crate::dialect::{Address, Dialect, GCode, MCode, MFunction};
use ferrocut_geometry::AxisSet;
use ferrocut_machine::{Alarm, Fault};
use ferrocut_program::{Block, Page, Span, Word};

/// Most G and M codes of one block; more are refused.
const MAX_CODES: usize = 16;

/// Tables of a dialect by direct index, made once.
pub(crate) struct Tables {
    /// G codes by tenths.
    g: Vec<Option<&'static GCode>>,
    addresses: [Option<Address>; 26],
}

impl Tables {
    pub(crate) fn new(dialect: &Dialect) -> Tables {
        let size = dialect.g_codes.last().map_or(0, |g| usize::from(g.tenths) + 1);
        let g = (0..size).map(|t| u16::try_from(t).ok().and_then(|t| dialect.g_code(t))).collect();
        let addresses = std::array::from_fn(|i| dialect.address(b'A' + i as u8).copied());
        Tables { g, addresses }
    }
}

/// A code of the block and the word it stands in.
#[derive(Clone, Copy)]
pub(crate) struct Code<T: 'static> {
    pub row: &'static T,
    pub span: Span,
}

/// Words of the block being executed.
pub(crate) struct Words {
    values: [f64; 26],
    /// Place of each word in the block's text, for underlining.
    places: [(u32, u16); 26],
    present: u32,
    /// G codes, modal and not.
    pub g: Vec<Code<GCode>>,
    /// M codes.
    pub m: Vec<Code<MCode>>,
    /// Number of the N word, if there is one.
    pub sequence: Option<f64>,
    /// A word with a comma before it: letter, value, span.
    pub comma: Option<(u8, f64, Span)>,
    block: Span,
    page_offset: u64,
}

fn bit(letter: u8) -> u32 {
    1 << (letter.wrapping_sub(b'A') & 31)
}

impl Words {
    pub(crate) fn new() -> Words {
        Words {
            values: [0.0; 26],
            places: [(0, 0); 26],
            present: 0,
            g: Vec::with_capacity(MAX_CODES),
            m: Vec::with_capacity(MAX_CODES),
            sequence: None,
            comma: None,
            block: Span::default(),
            page_offset: 0,
        }
    }

    /// Empties for the next block.
    #[inline]
    pub(crate) fn start(&mut self, page: &Page, block: &Block) {
        self.present = 0;
        self.g.clear();
        self.m.clear();
        self.sequence = None;
        self.comma = None;
        self.block = page.block_span(block);
        self.page_offset = page.offset;
    }

    /// Span of the whole block.
    pub(crate) fn block_span(&self) -> Span {
        self.block
    }

    /// Whether the block has this address.
    #[inline]
    pub(crate) fn has(&self, letter: u8) -> bool {
        self.present & bit(letter) != 0
    }

    /// Whether the block has any of these addresses.
    #[inline]
    pub(crate) fn has_any(&self, letters: u32) -> bool {
        self.present & letters != 0
    }

    /// Value of an address.
    #[inline]
    pub(crate) fn get(&self, letter: u8) -> Option<f64> {
        if !self.has(letter) {
            return None;
        }
        self.values.get(usize::from(letter - b'A')).copied()
    }

    /// Value of an address that no one after asks for.
    pub(crate) fn take(&mut self, letter: u8) -> Option<f64> {
        let value = self.get(letter);
        self.present &= !bit(letter);
        value
    }

    /// Span of an address's word; the whole block's where it is not there.
    pub(crate) fn span(&self, letter: u8) -> Span {
        match self.places.get(usize::from(letter.wrapping_sub(b'A'))) {
            Some(&(at, len)) if self.has(letter) => {
                Span { offset: self.page_offset + u64::from(at), len: u32::from(len), ..self.block }
            }
            _ => self.block,
        }
    }

    /// Whether the block calls a subprogram, which P and L belong to then.
    pub(crate) fn calls(&self) -> bool {
        self.m.iter().any(|m| m.row.function == MFunction::Call)
    }

    /// The axes whose addresses the block has.
    #[inline]
    pub(crate) fn axes(&self, of: AxisSet) -> AxisSet {
        // X Y Z, A B C and U V W are neighbours in the alphabet and in the order of the axes.
        let three = |first: u8| (self.present >> (first - b'A') & 0b111) as u16;
        AxisSet::from_bits(three(b'X') | three(b'A') << 3 | three(b'U') << 6).and(of)
    }
}

/// Bits of the addresses that name axes.
pub(crate) const AXIS_LETTERS: u32 = letters(b"XYZABCUVW");

/// Bits of the axis addresses that are not `of` the control.
pub(crate) fn foreign_axes(of: AxisSet) -> u32 {
    of.iter().fold(AXIS_LETTERS, |bits, axis| bits & !bit(axis.letter() as u8))
}

/// The bits of some addresses, for [`Words::has_any`].
pub(crate) const fn letters(of: &[u8]) -> u32 {
    let mut bits = 0;
    let mut at = 0;
    while at < of.len() {
        bits |= 1 << (of[at] - b'A');
        at += 1;
    }
    bits
}

/// Everything that reading the words of a block needs to know.
pub(crate) struct Reader<'a> {
    pub dialect: &'static Dialect,
    pub tables: &'a Tables,
    pub page: &'a Page,
    pub block: &'a Block,
    pub repeats_are_alarms: bool,
    pub max_m_code: f64,
}

impl Reader<'_> {
    fn alarm(&self, fault: Fault, word: &Word) -> Box<Alarm> {
        alarm(self.dialect, fault, self.page.word_span(self.block, word))
    }

    /// Puts one word with its value into `words`.
    #[inline]
    pub(crate) fn word(&self, words: &mut Words, word: &Word, value: f64) -> Fallible<()> {
        if word.has_comma() {
            if words.comma.is_some() {
                return Err(self.alarm(Fault::CornerForm, word));
            }
            words.comma = Some((word.letter, value, self.page.word_span(self.block, word)));
            return Ok(());
        }
        match word.letter {
            b'G' => self.g_word(words, word, value),
            b'M' => self.m_word(words, word, value),
            b'N' => {
                self.whole_word(word, value)?;
                words.sequence = Some(value);
                Ok(())
            }
            b'O' => self.whole_word(word, value),
            letter => {
                let index = usize::from(letter.wrapping_sub(b'A'));
                let (Some(Some(address)), Some(slot), Some(place)) = (
                    self.tables.addresses.get(index),
                    words.values.get_mut(index),
                    words.places.get_mut(index),
                ) else {
                    return Err(self.alarm(Fault::UnknownAddress, word));
                };
                if !(value >= address.min && value <= address.max) {
                    return Err(self.out_of_range(address, word, value));
                }
                if address.whole && (value.fract() != 0.0 || word.has_point()) {
                    return Err(self.alarm(Fault::WordNotWhole, word));
                }
                if words.present & bit(letter) != 0 && self.repeats_are_alarms {
                    return Err(self.alarm(Fault::RepeatedAddress, word));
                }
                words.present |= bit(letter);
                *slot = value;
                *place = (word.at, word.len);
                Ok(())
            }
        }
    }

    fn out_of_range(&self, address: &Address, word: &Word, value: f64) -> Box<Alarm> {
        let fault = if value < 0.0 && address.min == 0.0 { Fault::WordNegative } else { address.beyond };
        let mut alarm = self.alarm(fault, word);
        alarm.arguments.push(("min", address.min.into()));
        alarm.arguments.push(("max", address.max.into()));
        alarm
    }

    /// A code or number that takes neither sign nor point.
    fn whole_word(&self, word: &Word, value: f64) -> Fallible<()> {
        if value < 0.0 {
            return Err(self.alarm(Fault::WordNegative, word));
        }
        if word.has_point() {
            return Err(self.alarm(Fault::WordNotWhole, word));
        }
        Ok(())
    }

    fn g_word(&self, words: &mut Words, word: &Word, value: f64) -> Fallible<()> {
        if value < 0.0 {
            return Err(self.alarm(Fault::WordNegative, word));
        }
        let tenths = value * 10.0;
        let row = (tenths >= 0.0 && tenths.fract() == 0.0)
            .then(|| self.tables.g.get(tenths as usize).copied().flatten())
            .flatten();
        let Some(row) = row else { return Err(self.alarm(Fault::UnknownGCode, word)) };
        let same_group = |c: &Code<GCode>| c.row.group == row.group;
        if self.repeats_are_alarms && words.g.iter().any(same_group) {
            return Err(self.alarm(Fault::RepeatedGroup, word));
        }
        if words.g.len() == MAX_CODES {
            return Err(self.alarm(Fault::RepeatedGroup, word));
        }
        words.g.push(Code { row, span: self.page.word_span(self.block, word) });
        Ok(())
    }

    fn m_word(&self, words: &mut Words, word: &Word, value: f64) -> Fallible<()> {
        self.whole_word(word, value)?;
        if value > self.max_m_code {
            return Err(self.alarm(Fault::UnknownMCode, word));
        }
        let code =
            (value >= 0.0 && value.fract() == 0.0 && value <= f64::from(u16::MAX)).then_some(value as u16);
        let Some(row) = code.and_then(|c| self.dialect.m_code(c)) else {
            return Err(self.alarm(Fault::UnknownMCode, word));
        };
        if words.m.len() == MAX_CODES {
            return Err(self.alarm(Fault::TooManyMCodes, word));
        }
        words.m.push(Code { row, span: self.page.word_span(self.block, word) });
        Ok(())
    }
}

/// An alarm under the dialect's own number, where its manual has one.
pub(crate) fn alarm(dialect: &Dialect, fault: Fault, span: Span) -> Box<Alarm> {
    Box::new(Alarm::new(dialect.alarm_id(fault), fault, span))
}
