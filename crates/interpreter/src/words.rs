//! Stage 1, words: a block's words by address, its G and M codes looked up.

use crate::Fallible;
use crate::custom::CustomCodes;
use crate::dialect::{Address, Dialect, GCode, MCode, MFunction, Meaning};
use crate::interpreter::{Interpreter, MachineCodes};
use crate::modal::Group;
use ferrocut_geometry::{Axis, AxisName, AxisNames, AxisSet};
use ferrocut_machine::{Alarm, Fault};
use ferrocut_program::syntax::FIRST_NUMBERED;
use ferrocut_program::{Block, Page, Span, TextRange, Value as WordValue, Word, numbered_axis_name};
use smallvec::SmallVec;

/// Most G and M codes of one block; more are refused.
const MAX_CODES: usize = 16;

/// Tables of a dialect by direct index, made once.
#[derive(Clone)]
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

    /// Takes a letter away that is not the name of an axis here.
    pub(crate) fn without(mut self, axes: AxisSet) -> Tables {
        for axis in axes.iter() {
            let index = usize::from((axis.letter() as u8).wrapping_sub(b'A'));
            if let Some(slot) = self.addresses.get_mut(index) {
                *slot = None;
            }
        }
        self
    }
}

/// A code of the block and the word it stands in.
#[derive(Clone, Copy)]
pub(crate) struct Code<T: 'static> {
    pub row: &'static T,
    pub span: Span,
}

/// A word with text, or of an address of several letters.
#[derive(Clone, Copy)]
pub(crate) struct LongWord {
    letter: u8,
    value: Long,
    span: Span,
}

/// What it holds.
#[derive(Clone, Copy)]
enum Long {
    Number(f64),
    /// The place of the text without its quotes.
    Text(Span),
}

/// The bytes that stand for addresses of several letters.
pub mod long {
    #![allow(missing_docs)]
    pub const MSG: u8 = b'a';
    pub const PLC: u8 = b'b';
    pub const LEVEL: u8 = b'c';
    pub const FX: u8 = b'd';
    pub const FY: u8 = b'e';
    pub const FZ: u8 = b'f';
    pub const PX: u8 = b'g';
    pub const PY: u8 = b'h';
    pub const PZ: u8 = b'i';
    pub const LX: u8 = b'j';
    pub const LY: u8 = b'k';
    pub const LZ: u8 = b'l';
    pub const NR: u8 = b'm';
}

/// Values by letter.
#[derive(Clone, Copy, PartialEq, Debug, Default)]
pub struct WordValues {
    values: [f64; 26],
    present: u32,
}

impl WordValues {
    /// The value of a letter.
    pub fn get(&self, letter: u8) -> Option<f64> {
        let value = self.values.get(usize::from(letter.wrapping_sub(b'A')))?;
        (self.present & bit(letter) != 0).then_some(*value)
    }

    /// Gives a letter a value.
    pub fn put(&mut self, letter: u8, value: f64) {
        if let Some(slot) = self.values.get_mut(usize::from(letter.wrapping_sub(b'A'))) {
            *slot = value;
            self.present |= bit(letter);
        }
    }
}

/// What an axis with a digit in its name may be programmed to.
const ANY_COORDINATE: Address = crate::dialects::fanuc::signed(0, 99_999_999.0);

/// Words of the block being executed.
#[derive(Clone)]
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
    /// Whether it stands behind G10, and is a number of what is set.
    pub sequence_of_data: bool,
    /// A word with a comma before it: letter, value, span.
    pub comma: Option<(u8, f64, Span)>,
    /// Words with text, and those of several letters.
    long: SmallVec<[LongWord; 2]>,
    /// Letters that belong to a code of this block, behind it.
    owned: u32,
    /// Their values.
    pub own: WordValues,
    own_places: [(u32, u16); 26],
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
            sequence_of_data: false,
            comma: None,
            long: SmallVec::new(),
            owned: 0,
            own: WordValues::default(),
            own_places: [(0, 0); 26],
            block: Span::default(),
            page_offset: 0,
        }
    }

    /// Empties for the next block.
    #[inline]
    pub(crate) fn start(&mut self, page: &Page, block: &Block) {
        self.clear();
        self.block = page.block_span(block);
        self.page_offset = page.offset;
    }

    /// Empties for what stands at `span` and is no block of words.
    pub(crate) fn start_at(&mut self, span: Span) {
        self.clear();
        self.block = span;
        self.page_offset = 0;
    }

    #[inline]
    fn clear(&mut self) {
        self.present = 0;
        self.g.clear();
        self.m.clear();
        self.sequence = None;
        self.sequence_of_data = false;
        self.comma = None;
        self.long.clear();
        self.owned = 0;
        self.own.present = 0;
    }

    /// Span of a word that belongs to a code of the block.
    pub(crate) fn own_span(&self, letter: u8) -> Span {
        match self.own_places.get(usize::from(letter.wrapping_sub(b'A'))) {
            Some(&(at, len)) if self.own.get(letter).is_some() => {
                Span { offset: self.page_offset + u64::from(at), len: u32::from(len), ..self.block }
            }
            _ => self.block,
        }
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

    /// Puts a word with its value in; false where the block has the address already.
    #[inline]
    pub(crate) fn put_word(&mut self, word: &Word, value: f64) -> bool {
        let index = usize::from(word.letter.wrapping_sub(b'A'));
        if self.has(word.letter) {
            return false;
        }
        if let (Some(slot), Some(place)) = (self.values.get_mut(index), self.places.get_mut(index)) {
            self.present |= bit(word.letter);
            *slot = value;
            *place = (word.at, word.len);
        }
        true
    }

    /// Puts an address in that the block has in another form.
    pub(crate) fn add(&mut self, letter: u8, value: f64) {
        self.put(letter, value);
        self.present |= bit(letter);
        if let Some(place) = self.places.get_mut(usize::from(letter.wrapping_sub(b'A'))) {
            *place = (self.block.offset.saturating_sub(self.page_offset) as u32, self.block.len as u16);
        }
    }

    /// Value of an address that no one after asks for.
    pub(crate) fn take(&mut self, letter: u8) -> Option<f64> {
        let value = self.get(letter);
        self.present &= !bit(letter);
        value
    }

    /// Gives a word of the block another value.
    pub(crate) fn put(&mut self, letter: u8, value: f64) {
        if let Some(slot) = self.values.get_mut(usize::from(letter.wrapping_sub(b'A'))) {
            *slot = value;
        }
    }

    /// Whether the block has a word of several letters, or with text.
    pub(crate) fn has_long(&self, letter: u8) -> bool {
        self.long.iter().any(|word| word.letter == letter)
    }

    /// Value of a word of several letters.
    pub(crate) fn long(&self, letter: u8) -> Option<f64> {
        self.long.iter().find_map(|word| match word.value {
            Long::Number(value) if word.letter == letter => Some(value),
            _ => None,
        })
    }

    /// Place of the text of a word.
    pub(crate) fn text(&self, letter: u8) -> Option<Span> {
        self.long.iter().find_map(|word| match word.value {
            Long::Text(span) if word.letter == letter => Some(span),
            _ => None,
        })
    }

    /// Span of a word of several letters or with text; the whole block's where it is not there.
    pub(crate) fn long_span(&self, letter: u8) -> Span {
        self.long.iter().find(|word| word.letter == letter).map_or(self.block, |word| word.span)
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

    /// Whether a code of the block takes the place of the motion in force. G11 only ends G10 (GSK990MC 4.1 note 3); what
    /// Weihong has for the block's motion stands beside it (4.4).
    pub(crate) fn stands_for_motion(&self) -> bool {
        use Meaning::{
            DataSettingOff, EncoderLatch, FullFeed, InDegrees, NoEffect, ShortestWay, WaitForInput,
        };
        let stands_beside = |row: &GCode| {
            matches!(row.meaning, DataSettingOff | EncoderLatch | FullFeed | InDegrees)
                || matches!(row.meaning, NoEffect | ShortestWay | WaitForInput)
        };
        self.g.iter().any(|g| g.row.group == Group::NonModal && !stands_beside(g.row))
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
    /// Whether the block stands among data that are set.
    pub sets_data: bool,
    pub max_m_code: f64,
    /// M codes that the machine has beside those of the language.
    pub machine_codes: &'a MachineCodes,
    pub distance_is_exclusive: bool,
    /// One-way positioning, where it is a motion code.
    pub one_way: Option<&'static GCode>,
    pub custom: Option<&'a CustomCodes>,
    /// Axis of the tool, for codes that own its word.
    pub tool_axis: Axis,
    /// Names of axes with a digit.
    pub axis_names: AxisNames,
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
        if words.owned != 0 && self.own_word(words, word, value)? {
            return Ok(());
        }
        match word.letter {
            b'G' => self.g_word(words, word, value),
            b'M' => self.m_word(words, word, value),
            b'N' => {
                self.whole_word(word, value)?;
                if value.fract() != 0.0 {
                    return Err(self.alarm(Fault::WordNotWhole, word));
                }
                // Among data a line may have a number beside that of its parameter.
                let sets_data =
                    || self.sets_data || self.block_has(|meaning| meaning == Meaning::DataSetting);
                if self.repeats_are_alarms && words.sequence.is_some() && !sets_data() {
                    return Err(self.alarm(Fault::RepeatedAddress, word));
                }
                words.sequence_of_data = words.g.iter().any(|g| g.row.meaning == Meaning::DataSetting);
                words.sequence = Some(value);
                Ok(())
            }
            b'O' => self.whole_word(word, value),
            letter if letter.is_ascii_lowercase() => {
                self.long_word(words, word, Long::Number(value));
                Ok(())
            }
            letter if letter >= FIRST_NUMBERED => {
                let Some(axis) = self.numbered_axis(letter) else {
                    return Err(self.alarm(Fault::UnknownAxis, word));
                };
                self.plain_word(words, word, value, axis.letter() as u8, &Some(ANY_COORDINATE))
            }
            letter => {
                let index = usize::from(letter.wrapping_sub(b'A'));
                match self.tables.addresses.get(index) {
                    Some(address) => self.plain_word(words, word, value, letter, address),
                    None => Err(self.alarm(Fault::UnknownAddress, word)),
                }
            }
        }
    }

    /// Whether a G code with such a meaning stands in the block, before or behind what is read.
    fn block_has(&self, is_it: impl Fn(Meaning) -> bool) -> bool {
        self.numbers(b'G').any(|value| {
            let tenths = value * 10.0;
            let row =
                (tenths >= 0.0).then(|| self.tables.g.get(tenths as usize).copied().flatten()).flatten();
            tenths.fract() == 0.0 && row.is_some_and(|row| is_it(row.meaning))
        })
    }

    /// Whether the block calls a subprogram.
    fn block_calls(&self) -> bool {
        let calls = |row: &MCode| row.function == MFunction::Call;
        self.numbers(b'M').any(|value| self.dialect.m_code(value as u16).is_some_and(calls))
    }

    /// The numbers behind this letter in the block.
    fn numbers(&self, letter: u8) -> impl Iterator<Item = f64> {
        self.page.words(self.block).iter().filter(move |word| word.letter == letter).filter_map(|word| {
            match word.value() {
                WordValue::Number(number) => Some(number),
                _ => None,
            }
        })
    }

    /// The axis that a letter with a digit names.
    fn numbered_axis(&self, letter: u8) -> Option<Axis> {
        let [letter, digit] = numbered_axis_name(letter)?;
        self.axis_names.find(AxisName::numbered(letter, digit)?)
    }

    /// Puts a word into those of a code that stands before it, where it is one of these. Behind the code's own D or M another one
    /// is the offset or the function that ends the block (Fagor 1.1.3).
    fn own_word(&self, words: &mut Words, word: &Word, value: f64) -> Fallible<bool> {
        let letter = match word.letter {
            letter if letter >= FIRST_NUMBERED => match self.numbered_axis(letter) {
                Some(axis) => axis.letter() as u8,
                None => return Ok(false),
            },
            letter if letter.is_ascii_uppercase() => letter,
            _ => return Ok(false),
        };
        if words.owned & bit(letter) == 0 {
            return Ok(false);
        }
        if words.own.get(letter).is_some() {
            return match letter {
                b'D' | b'M' => Ok(false),
                _ => Err(self.alarm(Fault::RepeatedAddress, word)),
            };
        }
        words.own.put(letter, value);
        if let Some(place) = words.own_places.get_mut(usize::from(letter.wrapping_sub(b'A'))) {
            *place = (word.at, word.len);
        }
        Ok(true)
    }

    #[inline]
    fn plain_word(
        &self,
        words: &mut Words,
        word: &Word,
        value: f64,
        letter: u8,
        address: &Option<Address>,
    ) -> Fallible<()> {
        let index = usize::from(letter.wrapping_sub(b'A'));
        let (Some(address), Some(slot), Some(place)) =
            (address, words.values.get_mut(index), words.places.get_mut(index))
        else {
            return Err(self.alarm(Fault::UnknownAddress, word));
        };
        // What an argument means its program says.
        let is_argument = || {
            (self.dialect.argument)(letter).is_some() && self.block_has(|meaning| meaning == Meaning::Call)
        };
        let is_in_range = value >= address.min && value <= address.max;
        if !is_in_range && !is_argument() {
            let returns =
                |meaning| matches!(meaning, Meaning::ReferenceReturn | Meaning::FurtherReferenceReturn);
            return Err(match letter {
                b'P' if value > 0.0 && self.block_calls() => self.alarm(Fault::ProgramNumberTooLarge, word),
                _ if bit(letter) & AXIS_LETTERS != 0 && self.block_has(returns) => {
                    self.alarm(Fault::IntermediateTooLarge, word)
                }
                _ => self.out_of_range(address, word, value),
            });
        }
        let mut value = value;
        if address.whole && (value.fract() != 0.0 || word.has_point()) && !is_argument() {
            // What a variable says is rounded to the unit of S, as Fanuc has it; a speed has no point.
            if letter != b'S' || word.has_point() {
                return Err(self.alarm(Fault::WordNotWhole, word));
            }
            value = value.round();
        }
        if words.present & bit(letter) != 0 && self.repeats_are_alarms {
            return Err(self.alarm(Fault::RepeatedAddress, word));
        }
        words.present |= bit(letter);
        *slot = value;
        *place = (word.at, word.len);
        Ok(())
    }

    /// Puts a word with text into `words`.
    pub(crate) fn text(&self, words: &mut Words, word: &Word, text: TextRange) -> Fallible<()> {
        let takes_text = word.letter.is_ascii_lowercase() || matches!(word.letter, b'O' | b'P');
        if !takes_text {
            return Err(self.alarm(Fault::AddressWithoutNumber, word));
        }
        self.long_word(words, word, Long::Text(self.page.span(self.block, text.at, text.len)));
        Ok(())
    }

    fn long_word(&self, words: &mut Words, word: &Word, value: Long) {
        let span = self.page.word_span(self.block, word);
        words.long.push(LongWord { letter: word.letter, value, span });
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
        let Some(row) = row.or_else(|| self.custom?.g_code(value)) else {
            return Err(self.alarm(Fault::UnknownGCode, word));
        };
        let row = self.one_way.filter(|_| row.meaning == Meaning::OneWay).unwrap_or(row);
        let same_group = |c: &Code<GCode>| c.row.group == row.group;
        let is_exclusive =
            self.repeats_are_alarms || self.distance_is_exclusive && row.group == Group::Distance;
        if is_exclusive && words.g.iter().any(same_group) {
            return Err(self.alarm(Fault::RepeatedGroup, word));
        }
        if words.g.len() == MAX_CODES {
            return Err(self.alarm(Fault::RepeatedGroup, word));
        }
        words.g.push(Code { row, span: self.page.word_span(self.block, word) });
        if row.group == Group::Cycle || row.group == Group::NonModal {
            // A plane of the same block has another tool axis.
            let plane = words.g.iter().rev().find_map(|g| match g.row.meaning {
                Meaning::Plane(plane) => Some(plane.normal()),
                _ => None,
            });
            let tool_axis = plane.unwrap_or(self.tool_axis).letter() as u8;
            words.owned = Interpreter::owned_letters(row.meaning, tool_axis);
        }
        Ok(())
    }

    fn m_word(&self, words: &mut Words, word: &Word, value: f64) -> Fallible<()> {
        self.whole_word(word, value)?;
        if value > self.max_m_code {
            return Err(self.alarm(Fault::UnknownMCode, word));
        }
        let code =
            (value >= 0.0 && value.fract() == 0.0 && value <= f64::from(u16::MAX)).then_some(value as u16);
        let known = code.and_then(|c| self.dialect.m_code(c));
        let custom = || code.and_then(|c| self.custom?.m_code(c));
        let of_machine = || code.and_then(|c| self.machine_codes.row(c));
        let Some(row) = known.or_else(custom).or_else(of_machine) else {
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
