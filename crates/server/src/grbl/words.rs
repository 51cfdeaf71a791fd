//! A line of Grbl to words: what Grbl refuses by itself, and the same block for the interpreter.
//!
//! Nothing of a sender goes to the interpreter as it came. A block is written anew from its words, of which Grbl
//! knows letters, codes and decimal numbers, so that O words, expressions and named parameters of RS274/NGC cannot be
//! reached from a connection.

use super::codes::Error;
use std::fmt::Write;

/// Characters of a line without blanks and comments. Grbl's own 79 are too few for what some post processors write.
pub const LONGEST_LINE: usize = 255;

/// The highest line number (Grbl 1.1, N word).
const MAX_LINE_NUMBER: f64 = 9_999_999.0;

/// The highest tool number.
const MAX_TOOL: f64 = 255.0;

/// Coordinate systems, G54 to G59.
const SYSTEMS: f64 = 6.0;

/// A dwell that is none waits all the same: motion comes to its end before the answer.
const SHORTEST_DWELL: &str = "0.001";

/// A word: its letter, its value and how that was written.
#[derive(Clone, Copy, PartialEq, Debug)]
pub struct Word<'a> {
    /// Capital letter.
    pub letter: u8,
    /// Value.
    pub value: f64,
    /// Sign, digits and point.
    pub text: &'a str,
}

/// A line without blanks and comments, in capitals (Grbl 1.1, protocol).
pub fn strip(line: &[u8]) -> Vec<u8> {
    let mut out = Vec::with_capacity(line.len().min(LONGEST_LINE + 1));
    let mut in_comment = false;
    for byte in line {
        match byte {
            b')' => in_comment = false,
            _ if in_comment => {}
            b'(' => in_comment = true,
            b';' => break,
            // Blanks, control characters, the mark of blocks that may be left out.
            0..=b' ' | b'/' => {}
            _ => out.push(byte.to_ascii_uppercase()),
        }
        if out.len() > LONGEST_LINE {
            break;
        }
    }
    out
}

/// The words of a stripped line.
pub fn words(line: &[u8]) -> Result<Vec<Word<'_>>, Error> {
    let mut words = Vec::new();
    let mut rest = line;
    while let Some((letter, behind)) = rest.split_first() {
        if !letter.is_ascii_uppercase() {
            return Err(Error::NO_LETTER);
        }
        let is_number = |b: &u8| b.is_ascii_digit() || matches!(b, b'.' | b'+' | b'-');
        let len = behind.iter().position(|b| !is_number(b)).unwrap_or(behind.len());
        let (text, next) = behind.split_at(len);
        let text = std::str::from_utf8(text).map_err(|_| Error::NO_NUMBER)?;
        // A sign may stand at the front alone; `parse` wants a digit.
        let value = text.parse::<f64>().ok().filter(|v| v.is_finite()).ok_or(Error::NO_NUMBER)?;
        words.push(Word { letter: *letter, value, text });
        rest = next;
    }
    Ok(words)
}

/// A code with its number in tenths.
fn tenths(value: f64) -> Option<u16> {
    let tenths = (value * 10.0).round();
    ((value * 10.0 - tenths).abs() < 1e-6 && (0.0..=999.0).contains(&tenths)).then_some(tenths as u16)
}

/// Modal group of a G code in tenths (Grbl 1.1, supported G-codes); `None` for one that Grbl does not have.
fn g_group(tenths: u16) -> Option<u8> {
    Some(match tenths {
        40 | 100 | 280 | 281 | 300 | 301 | 530 | 920 | 921 => 0,
        0 | 10 | 20 | 30 | 382..=385 | 800 => 1,
        170 | 180 | 190 => 2,
        900 | 910 => 3,
        911 => 4,
        930 | 940 => 5,
        200 | 210 => 6,
        400 => 7,
        431 | 490 => 8,
        540 | 550 | 560 | 570 | 580 | 590 => 12,
        610 => 13,
        _ => return None,
    })
}

/// Modal group of an M code.
fn m_group(code: u16) -> Option<u8> {
    Some(match code {
        0 | 1 | 2 | 30 => 4,
        3..=5 => 7,
        7..=9 => 8,
        _ => return None,
    })
}

/// A block as Grbl takes it.
#[derive(Clone, PartialEq, Debug, Default)]
pub struct Block {
    /// The block for the interpreter; empty where nothing is left to do.
    pub text: String,
    /// N.
    pub number: Option<u32>,
    /// T.
    pub tool: Option<u32>,
    /// M2 or M30.
    pub ends: bool,
    /// G38.2 to G38.5; true where no contact is an alarm.
    pub probes: Option<bool>,
    /// G53.
    pub in_machine: bool,
}

/// What a block must know of the machine.
#[derive(Clone, Copy, Debug)]
pub struct Limits<'a> {
    /// Letters of the axes.
    pub axes: &'a [u8],
    /// Highest speed of the spindle, r/min; S beyond it is that.
    pub max_rpm: f64,
}

/// Checks a stripped line, and writes it for the interpreter.
pub fn block(line: &[u8], limits: &Limits<'_>) -> Result<Block, Error> {
    let words = words(line)?;
    let mut block = Block::default();
    let (mut groups, mut letters) = (0u32, 0u32);
    let (mut g43_1, mut takes_axes) = (false, 0);
    // A move, or none, that G53 cannot have.
    let mut is_other_move = false;
    for word in &words {
        let mut take_group = |group: u8, of: u32| match groups & 1 << (u32::from(group) + of) {
            0 => {
                groups |= 1 << (u32::from(group) + of);
                Ok(())
            }
            _ => Err(Error::GROUP),
        };
        match word.letter {
            b'G' => {
                let code = tenths(word.value).ok_or(Error::UNSUPPORTED)?;
                if matches!(code, 591..=593) {
                    return Err(Error::NO_SYSTEM);
                }
                let whole = code - code % 10;
                // Codes that there are with a fraction have no other.
                let has_fractions = matches!(whole, 280 | 300 | 380 | 430 | 610 | 900 | 910 | 920);
                let is_unknown = code == whole || has_fractions || g_group(whole).is_none();
                let group =
                    g_group(code).ok_or(if is_unknown { Error::UNSUPPORTED } else { Error::NOT_WHOLE })?;
                take_group(group, 0)?;
                block.in_machine |= code == 530;
                is_other_move |= matches!(code, 20 | 30 | 382..=385 | 800);
                g43_1 |= code == 431;
                if matches!(code, 382..=385) {
                    block.probes = Some(matches!(code, 382 | 384));
                }
                takes_axes += u32::from(matches!(code, 100 | 280 | 300 | 431 | 920));
                takes_axes += u32::from(matches!(code, 0 | 10 | 20 | 30 | 382..=385));
                // Exact path is how Grbl always runs; it never stops between blocks for it.
                if code != 610 {
                    write_code(&mut block.text, 'G', code);
                }
                continue;
            }
            b'M' => {
                let code = tenths(word.value).ok_or(Error::UNSUPPORTED)?;
                if code % 10 != 0 {
                    return Err(Error::NOT_WHOLE);
                }
                // M7 and M8 may both be on, and are of one group: a block has one of them.
                take_group(m_group(code / 10).ok_or(Error::UNSUPPORTED)?, 16)?;
                block.ends |= matches!(code, 20 | 300);
                // There is no switch for an optional stop.
                if code != 10 {
                    write_code(&mut block.text, 'M', code);
                }
                continue;
            }
            _ => {}
        }
        let bit = 1 << (word.letter - b'A');
        let is_axis = limits.axes.contains(&word.letter);
        if !is_axis && !matches!(word.letter, b'F' | b'I'..=b'L' | b'N' | b'P' | b'R' | b'S' | b'T') {
            return Err(Error::UNSUPPORTED);
        }
        if letters & bit != 0 {
            return Err(Error::REPEATED);
        }
        letters |= bit;
        if matches!(word.letter, b'F' | b'N' | b'P' | b'S' | b'T') && word.value < 0.0 {
            return Err(Error::NEGATIVE);
        }
        match word.letter {
            b'N' if word.value > MAX_LINE_NUMBER => return Err(Error::LINE_NUMBER),
            b'N' => block.number = Some(word.value as u32),
            b'T' if word.value > MAX_TOOL => return Err(Error::TOOL),
            b'T' => block.tool = Some(word.value as u32),
            b'L' if word.value.fract() != 0.0 => return Err(Error::NOT_WHOLE),
            b'P' if word.value == 0.0 && has_code(&words, 40) => {
                let _ = write!(block.text, "P{SHORTEST_DWELL}");
            }
            b'S' if word.value > limits.max_rpm => {
                let _ = write!(block.text, "S{}", limits.max_rpm);
            }
            letter => {
                block.text.push(char::from(letter));
                block.text.push_str(word.text);
            }
        }
    }
    let has_axes = limits.axes.iter().any(|letter| letters & 1 << (letter.wrapping_sub(b'A') % 32) != 0);
    if takes_axes > 1 && has_axes {
        return Err(Error::AXES_TWICE);
    }
    let has = |letter: u8| letters & 1 << (letter.wrapping_sub(b'A') % 32) != 0;
    if g43_1 && limits.axes.iter().any(|letter| has(*letter) != (*letter == b'Z')) {
        return Err(Error::LENGTH_AXIS);
    }
    if has_code(&words, 100) {
        let value = |letter| words.iter().find(|word| word.letter == letter).map(|word| word.value);
        if !has_axes {
            return Err(Error::NO_AXES);
        }
        let (Some(p), Some(l)) = (value(b'P'), value(b'L')) else { return Err(Error::MISSING) };
        if p > SYSTEMS {
            return Err(Error::NO_SYSTEM);
        }
        // There is no turn of a system.
        if !matches!(l, 2.0 | 20.0) || l == 2.0 && has(b'R') {
            return Err(Error::UNSUPPORTED);
        }
    }
    if block.in_machine && is_other_move {
        return Err(Error::MACHINE_MOVE);
    }
    Ok(block)
}

fn has_code(words: &[Word<'_>], code: u16) -> bool {
    words.iter().any(|word| word.letter == b'G' && tenths(word.value) == Some(code))
}

/// `G38.2`, `M30`.
fn write_code(text: &mut String, letter: char, tenths: u16) {
    let _ = match tenths % 10 {
        0 => write!(text, "{letter}{}", tenths / 10),
        part => write!(text, "{letter}{}.{part}", tenths / 10),
    };
}

#[cfg(test)]
mod tests {
    use super::*;

    const LIMITS: Limits<'static> = Limits { axes: b"XYZ", max_rpm: 8000.0 };

    fn of(line: &str) -> Result<String, u8> {
        block(&strip(line.as_bytes()), &LIMITS).map(|block| block.text).map_err(|error| error.0)
    }

    #[test]
    fn a_block_is_written_anew() {
        assert_eq!(of("g1 x1.50 y-2. f300 (to the left) z+.5 ; done").unwrap(), "G1X1.50Y-2.F300Z+.5");
        assert_eq!(of("/N10 G61 G90G0X1").unwrap(), "G90G0X1");
        assert_eq!(of("G4 P0").unwrap(), "G4P0.001");
        assert_eq!(of("M3 S90000 T3 M1").unwrap(), "M3S8000");
        let block = block(b"N12G38.2Z-5F10T4M30", &LIMITS).unwrap();
        assert_eq!(
            (block.number, block.tool, block.ends, block.probes),
            (Some(12), Some(4), true, Some(true))
        );
    }

    #[test]
    fn what_grbl_refuses_is_refused_with_its_number() {
        // Interface, error codes.
        for (line, error) in [
            ("1X2", 1),
            // A control character that Grbl does not leave out (protocol.c: those up to the blank).
            ("\x7F", 1),
            ("G1X2\x7F", 1),
            ("G1X#5", 2),
            ("#5=1", 1),
            ("O100 SUB", 2),
            ("GX1", 2),
            ("G1X1-2", 2),
            ("G1X-", 2),
            ("F-1", 4),
            ("G5X1", 20),
            ("G41D1", 20),
            ("M6T1", 20),
            ("G1U5", 20),
            ("G0G1X1", 21),
            ("M3M5", 21),
            ("M7M8", 21),
            ("G1.5X1", 23),
            ("M3.1", 23),
            ("G92G1X1", 24),
            ("G1X1X2", 25),
            ("N10000000", 27),
            ("G59.1", 29),
            ("G90.1", 20),
            ("G61.1", 20),
            ("G92.2", 20),
            ("G40.1", 23),
            ("G53G2X1I1", 30),
            ("G53G80X1", 30),
            ("G10", 26),
            ("G10L20P1", 26),
            ("G10P1X1", 28),
            ("G10L2X1", 28),
            ("G10L2P7X1", 29),
            ("G10L1P1Z1", 20),
            ("G10L2P1X1R45", 20),
            ("G43.1", 37),
            ("G43.1X1", 37),
            ("G43.1X1Z1", 37),
            ("T256", 38),
        ] {
            assert_eq!(of(line), Err(error), "{line}");
        }
    }

    #[test]
    fn a_long_line_is_cut_where_it_is_known_to_be_too_long() {
        assert_eq!(strip(&[b'X'; 100_000]).len(), LONGEST_LINE + 1);
        assert_eq!(strip(b" ( long ) g 1 \t x 2 ; rest"), b"G1X2");
    }
}
