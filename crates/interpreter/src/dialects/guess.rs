//! Which language a program is written in, told from its text and the name of its file.
//!
//! Every language is held against the start of the text: a block that its syntax cannot read, or with a code
//! that its tables do not have, counts against it. Nothing here is written for one language, so that a new
//! one is guessed as soon as it has its tables.

use super::ALL;
use crate::dialect::{CustomPrograms, Dialect};
use ferrocut_program::{Block, FileId, Page, Text, Value, Word, lexer};
use std::collections::HashSet;

/// Bytes looked at: enough to meet what tells languages apart, and little to read.
const LOOKED_AT: usize = 1 << 17;

/// Blocks out of a hundred that a language must fail at, while another reads all, to be ruled out: less is a
/// slip of the pen.
const PROOF_PERCENT: u64 = 2;

/// The same where someone chose the language: what it cannot read is an alarm there, and so nothing is run by rules that it
/// was not written for. One wrong code of a program must not have all of it judged by another control's rules.
const FIRM_PROOF_PERCENT: u64 = 20;

/// What a language makes of a text.
#[derive(Clone, Copy, Debug)]
struct Reading {
    dialect: &'static Dialect,
    blocks: u64,
    /// Blocks that it cannot read.
    unread: u64,
    /// Blocks that it reads, but would whatever the number of their M code is: nothing to tell it by.
    vague: u64,
}

/// What a language makes of a block.
#[derive(Clone, Copy, PartialEq, Eq)]
enum Sense {
    None,
    Vague,
    Clear,
}

/// What a guess rests on.
#[derive(Clone, Copy, PartialEq, Eq, Debug)]
pub enum Reason {
    /// Nothing speaks against the language asked for first.
    Preferred,
    /// So many of so many blocks are not in the language asked for first, and all are in this one.
    Content {
        /// Blocks that are not.
        unread: u64,
        /// Blocks looked at.
        blocks: u64,
    },
    /// The extension of the file, which files of this language have.
    Extension,
}

/// A language and what it was told from.
#[derive(Clone, Copy, Debug)]
pub struct Guess {
    /// The language.
    pub dialect: &'static Dialect,
    /// What for.
    pub reason: Reason,
}

/// The language of a text. `preferred` is the one that nothing needs to be shown for; `is_firm` tells that
/// someone chose it, so that only the content counts against it, and not the extension of the file. `public`
/// are the programs that come with the machine, which may stand for codes.
pub fn guess(
    text: &Text,
    public: Option<&Text>,
    extension: Option<&str>,
    preferred: &'static Dialect,
    is_firm: bool,
) -> Guess {
    let kept = Guess { dialect: preferred, reason: Reason::Preferred };
    let public = public.and_then(|text| head(text, <[u8]>::to_vec)).unwrap_or_default();
    let readings = head(text, |bytes| ALL.iter().map(|d| read(bytes, &public, d)).collect::<Vec<Reading>>());
    let Some(readings) = readings else { return kept };
    let has_extension = |dialect: &Dialect| {
        extension.is_some_and(|e| dialect.extensions.iter().any(|own| own.eq_ignore_ascii_case(e)))
    };
    let Some(own) = readings.iter().find(|r| std::ptr::eq(r.dialect, preferred)) else { return kept };
    let proves = |other: &Reading| {
        let told = own.unread.saturating_sub(other.vague);
        let percent = if is_firm { FIRM_PROOF_PERCENT } else { PROOF_PERCENT };
        told > 0 && told * 100 >= own.blocks * percent
    };
    // Of several that read it all, one that it proves, the one whose extension it has, else the first.
    let best = readings.iter().filter(|r| r.unread == 0).max_by_key(|r| {
        let first = ALL.iter().rev().position(|d| std::ptr::eq(*d, r.dialect));
        (proves(r), has_extension(r.dialect), first)
    });
    match best {
        Some(best) if proves(best) => {
            let reason = Reason::Content { unread: own.unread, blocks: own.blocks };
            Guess { dialect: best.dialect, reason }
        }
        Some(best) if !is_firm && has_extension(best.dialect) && !has_extension(preferred) => {
            Guess { dialect: best.dialect, reason: Reason::Extension }
        }
        _ => kept,
    }
}

/// The start of a text.
fn head<T>(text: &Text, with: impl FnOnce(&[u8]) -> T) -> Option<T> {
    text.window(text.encoding().mark as u64, LOOKED_AT, &mut Vec::new(), with).ok()
}

fn read(bytes: &[u8], public: &[u8], dialect: &'static Dialect) -> Reading {
    let lex = |bytes: &[u8]| {
        let is_last = bytes.len() < LOOKED_AT;
        lexer::lex(bytes, FileId(0), 0, 1, is_last, dialect.syntax).page
    };
    let page = lex(bytes);
    // A program may define codes of its own, and so may the machine.
    let programs: HashSet<u32> = match dialect.custom {
        Some(_) => numbers(&page).chain(numbers(&lex(public))).collect(),
        None => HashSet::new(),
    };
    let (mut unread, mut vague) = (0, 0);
    for block in &page.blocks {
        match sense(&page, block, dialect, &programs) {
            Sense::None => unread += 1,
            Sense::Vague => vague += 1,
            Sense::Clear => {}
        }
    }
    Reading { dialect, blocks: page.blocks.len() as u64, unread, vague }
}

/// The numbers of the programs that begin in a page.
fn numbers(page: &Page) -> impl Iterator<Item = u32> {
    page.blocks.iter().filter_map(|block| {
        match page.words(block).first().filter(|w| w.letter == b'O')?.value() {
            Value::Number(n) if n.fract() == 0.0 && (0.0..f64::from(u32::MAX)).contains(&n) => Some(n as u32),
            _ => None,
        }
    })
}

/// Whether a block can be read and has only codes that the language has, or that one of `programs` stands for.
fn sense(page: &Page, block: &Block, dialect: &Dialect, programs: &HashSet<u32>) -> Sense {
    let custom = |number: f64, first: fn(&CustomPrograms) -> u32| {
        let is_program = |custom: &CustomPrograms| {
            number.fract() == 0.0
                && number < f64::from(custom.count)
                && programs.contains(&(first(custom) + number as u32))
        };
        dialect.custom.as_ref().is_some_and(is_program)
    };
    let clear = |is_known: bool| if is_known { Sense::Clear } else { Sense::None };
    let of_word = |word: &Word| {
        let Value::Number(number) = word.value() else { return Sense::Clear };
        let tenths = number * 10.0;
        match word.letter {
            b'G' if tenths.fract() == 0.0 && (0.0..f64::from(u16::MAX)).contains(&tenths) => {
                let tenths = tenths as u16;
                let known = dialect.g_code(tenths).is_some() || tenths == dialect.macro_call;
                clear(known || custom(number, |programs| programs.g))
            }
            b'M' if number.fract() == 0.0 && (0.0..f64::from(u16::MAX)).contains(&number) => {
                // A code that a language only hands on tells nothing.
                let code = number as u16;
                let known = dialect.m_codes.binary_search_by_key(&code, |m| m.code).is_ok();
                match known || custom(number, |programs| programs.m) {
                    false if dialect.m_code(code).is_some() => Sense::Vague,
                    known => clear(known),
                }
            }
            b'G' | b'M' => Sense::None,
            letter if letter.is_ascii_uppercase() => {
                clear(matches!(letter, b'N' | b'O') || dialect.address(letter).is_some())
            }
            _ => Sense::Clear,
        }
    };
    if block.is_defective {
        return Sense::None;
    }
    page.words(block).iter().map(of_word).fold(Sense::Clear, |all, word| match (all, word) {
        (Sense::None, _) | (_, Sense::None) => Sense::None,
        (Sense::Vague, _) | (_, Sense::Vague) => Sense::Vague,
        _ => Sense::Clear,
    })
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::dialects::{gsk990mc, kaitong, weihong};

    fn guessed(
        text: &str,
        extension: &str,
        preferred: &'static Dialect,
        is_firm: bool,
    ) -> (&'static str, Reason) {
        let text = Text::from_bytes(text.as_bytes().to_vec()).unwrap();
        let guess = guess(&text, None, Some(extension), preferred, is_firm);
        (guess.dialect.name, guess.reason)
    }

    #[test]
    fn what_only_one_language_can_read_is_of_it() {
        let (gsk, weihong) = (&gsk990mc::DIALECT, &weihong::DIALECT);
        let content = |unread, blocks| Reason::Content { unread, blocks };
        for is_firm in [false, true] {
            let program = "G90 G0 X1\nG65 P\"UP\" L=#1\nM30\nO\"UP\"\nM17\n";
            assert_eq!(guessed(program, "nc", gsk, is_firm), ("weihong", content(2, 5)));
            let program = "%\nO1 (PART)\n#1=2\nIF[#1GT3]GOTO5\nG0X1\nN5M30\n%\n";
            assert_eq!(guessed(program, "nc", weihong, is_firm).0, "gsk990mc");
        }
    }

    #[test]
    fn what_all_can_read_is_of_the_machine_unless_the_extension_says_else() {
        let (gsk, kaitong, weihong) = (&gsk990mc::DIALECT, &kaitong::DIALECT, &weihong::DIALECT);
        let plain = "G90 G0 X1\nG1 X2 F100\nM30\n";
        for dialect in [gsk, kaitong, weihong] {
            assert_eq!(guessed(plain, "nc", dialect, false), (dialect.name, Reason::Preferred));
        }
        assert_eq!(guessed(plain, "MMG", gsk, false), ("weihong", Reason::Extension));
        assert_eq!(guessed(plain, "mmg", gsk, true), ("gsk990mc", Reason::Preferred));
    }

    #[test]
    fn one_wrong_code_is_an_alarm_of_the_language_that_was_chosen() {
        let program = "G21 G90 G54\nM3 S1000\nG0 X0 Y0 Z5\nG93 G1 X10 F2\nG94\nM30\n";
        assert_eq!(guessed(program, "nc", &gsk990mc::DIALECT, true), ("gsk990mc", Reason::Preferred));
        assert_eq!(guessed(program, "nc", &gsk990mc::DIALECT, false).0, "rs274");
    }

    #[test]
    fn slips_of_the_pen_prove_nothing() {
        let gsk = &gsk990mc::DIALECT;
        let mut program = "G1 X1 F100\n".repeat(200);
        program += "X=5\nM30\n";
        assert_eq!(guessed(&program, "nc", gsk, true), ("gsk990mc", Reason::Preferred));
        // What none can read is of the machine.
        assert_eq!(guessed("G0 X=(5\nG77\n", "nc", gsk, false), ("gsk990mc", Reason::Preferred));
    }

    #[test]
    fn codes_that_the_program_defines_are_no_strangers() {
        let program = "M40\n'clamp\nM30\nO240\nG04 P5\nM17\n";
        assert_eq!(guessed(program, "nc", &gsk990mc::DIALECT, false).0, "weihong");
    }

    #[test]
    fn codes_that_the_machine_defines_are_no_strangers() {
        let weihong = &weihong::DIALECT;
        let text = |text: &str| Text::from_bytes(text.as_bytes().to_vec()).unwrap();
        let (program, public) = (text("M40\nG1 X1 F9\nM30\n"), text("O240\nG04 P5\nM17\n"));
        let guess = guess(&program, Some(&public), None, weihong, true);
        assert_eq!((guess.dialect.name, guess.reason), ("weihong", Reason::Preferred));
    }

    #[test]
    fn a_language_that_knows_every_m_code_is_not_told_by_one() {
        let program = "M40\nG1 X1 F9\nM30\n";
        for preferred in [&gsk990mc::DIALECT, &kaitong::DIALECT, &weihong::DIALECT] {
            assert_eq!(guessed(program, "nc", preferred, true), (preferred.name, Reason::Preferred));
        }
        // M801 is of the Weihong control; other words of it are no one else's.
        let program = "M801 PLC[4] LEVEL1\nG1 X1 F9\nM30\n";
        assert_eq!(guessed(program, "nc", &gsk990mc::DIALECT, true).0, "weihong");
    }
}
