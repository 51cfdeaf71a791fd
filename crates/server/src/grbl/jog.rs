//! `$J=`: a move by hand in a line, which leaves codes in force alone (Grbl 1.1, jogging).

use super::codes::Error;
use super::machine::Modal;
use super::words::{self, Limits, words};
use ferrocut_geometry::{Axis, AxisSet, MM_PER_INCH, Position};

/// A jog that was understood.
#[derive(Clone, Copy, PartialEq, Debug)]
pub struct Jog {
    /// Machine position, mm and degrees.
    pub to: Position,
    /// mm/min
    pub feed: f64,
}

/// Reads what stands behind `$J=`. `from` is where the jog before ends, in machine coordinates.
pub fn read(line: &[u8], axes: &[Axis], modal: &Modal, from: Position) -> Result<Jog, Error> {
    let mut is_inch = modal.is_inch();
    let mut is_incremental = modal.is_incremental();
    let (mut is_machine, mut feed) = (false, None);
    let mut values = Position::ZERO;
    let mut named = AxisSet::default();
    // What is wrong in any line is so here.
    let letters: Vec<u8> = axes.iter().map(|axis| axis.letter() as u8).collect();
    words::block(line, &Limits { axes: &letters, max_rpm: f64::INFINITY })?;
    let words = words(line)?;
    for word in &words {
        match (word.letter, word.value) {
            (b'G', 20.0) => is_inch = true,
            (b'G', 21.0) => is_inch = false,
            (b'G', 90.0) => is_incremental = false,
            (b'G', 91.0) => is_incremental = true,
            (b'G', 53.0) => is_machine = true,
            (b'G' | b'M', _) => return Err(Error::JOG),
            (b'F', value) if value > 0.0 => feed = Some(value),
            (b'F', _) => return Err(Error::NO_FEED),
            (b'N', _) => {}
            (letter, value) => {
                let of = |axis: &&Axis| axis.letter() as u32 == u32::from(letter);
                let axis = *axes.iter().find(of).ok_or(Error::UNUSED)?;
                named = named.iter().chain([axis]).collect();
                values[axis] = value;
            }
        }
    }
    if named.is_empty() {
        return Err(Error::NO_AXES);
    }
    let unit = if is_inch { MM_PER_INCH } else { 1.0 };
    let feed = feed.ok_or(Error::NO_FEED)? * unit;
    let mut to = from;
    for axis in named.iter() {
        let value = if axis.is_linear() { values[axis] * unit } else { values[axis] };
        to[axis] = match (is_machine, is_incremental) {
            (true, _) => value,
            (false, true) => from[axis] + value,
            (false, false) => modal.zero[axis] + value,
        };
    }
    Ok(Jog { to, feed })
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn a_jog_counts_as_its_own_words_say() {
        let axes = [Axis::X, Axis::Y, Axis::Z];
        let modal = Modal { zero: Position::xyz(100.0, 0.0, 0.0), ..Modal::default() };
        let from = Position::xyz(1.0, 2.0, 3.0);
        let of = |line: &str| {
            read(line.as_bytes(), &axes, &modal, from).map(|jog| (jog.to, jog.feed)).map_err(|error| error.0)
        };
        assert_eq!(of("X10F500"), Ok((Position::xyz(110.0, 2.0, 3.0), 500.0)));
        assert_eq!(of("G91X-1Z1F500"), Ok((Position::xyz(0.0, 2.0, 4.0), 500.0)));
        assert_eq!(of("G20G91Y1F10"), Ok((Position::xyz(1.0, 27.4, 3.0), 254.0)));
        assert_eq!(of("G53G91X5F1"), Ok((Position::xyz(5.0, 2.0, 3.0), 1.0)));
        for (line, error) in [
            ("X1", 22),
            ("X1F0", 22),
            ("F100", 26),
            ("G1X1F1", 16),
            ("X1M3F1", 16),
            ("X1X2F1", 25),
            ("X1F1F2", 25),
            ("G20G21X1F1", 21),
            ("G90G91X1F1", 21),
            ("X1F-5", 4),
            ("X1S5F1", 36),
            ("X1Q5F1", 20),
            ("XF1", 2),
        ] {
            assert_eq!(of(line), Err(error), "{line}");
        }
    }
}
