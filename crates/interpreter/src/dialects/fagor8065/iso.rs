//! The ISO cycles G81 to G88 and G210 to G212 (1.2 to 1.12): from words to operations.

use crate::cycles::area::{Corner, Cut, Entry, Outline, Planes, PocketRough, PocketSteps};
use crate::cycles::bore_milling::{BoreMilling, BoreNames};
use crate::cycles::boring::{Aside, Bore, Way};
use crate::cycles::depth::Levels;
use crate::cycles::drilling::{Back, Hole, Leave, Pecks};
use crate::cycles::operation::{Operation, Work};
use crate::cycles::parameter::{WrongParameter, positive, refuse};
use crate::cycles::positions::whole;
use crate::cycles::tapping::{Holder, TappedHole};
use crate::cycles::thread_milling::{ThreadMilling, ThreadNames};
use crate::cycles::tool::{Frame, up};
use crate::cycles::zone::{Given, WordFormat};
use ferrocut_geometry::{SAME_POINT_MM, Turn};
use ferrocut_machine::Fault;

type Made = Result<Operation, WrongParameter>;

/// G81.
pub static DRILLING: WordFormat =
    WordFormat { letters: b"ZIKA", lengths: b"ZI", depth: Some(b'I'), build: drilling };

/// G82.
pub static VARIABLE_PECKS: WordFormat =
    WordFormat { letters: b"ZIDBHCJKRLA", lengths: b"ZIDBHCL", depth: Some(b'I'), build: variable_pecks };

/// G83. I is the peck.
pub static CONSTANT_PECKS: WordFormat =
    WordFormat { letters: b"ZIJBK", lengths: b"ZIB", depth: None, build: constant_pecks };

/// G84.
pub static TAPPING: WordFormat =
    WordFormat { letters: b"ZIKRJ", lengths: b"ZI", depth: Some(b'I'), build: tapping };

/// G85.
pub static REAMING: WordFormat =
    WordFormat { letters: b"ZIK", lengths: b"ZI", depth: Some(b'I'), build: reaming };

/// G86.
pub static BORING: WordFormat =
    WordFormat { letters: b"ZIKRAQDE", lengths: b"ZIDE", depth: Some(b'I'), build: boring };

/// G87.
pub static RECTANGULAR_POCKET: WordFormat = WordFormat {
    letters: b"ZIDAJKMQBCLHV",
    lengths: b"ZIDJKQBCLHV",
    depth: Some(b'I'),
    build: rectangular_pocket,
};

/// G88.
pub static CIRCULAR_POCKET: WordFormat =
    WordFormat { letters: b"ZIDJBCLHV", lengths: b"ZIDJBCLHV", depth: Some(b'I'), build: circular_pocket };

/// G210.
pub static BORE_MILLING: WordFormat =
    WordFormat { letters: b"ZDIJKB", lengths: b"ZDIJKB", depth: Some(b'I'), build: bore_milling };

/// G211.
pub static INTERNAL_THREAD: WordFormat =
    WordFormat { letters: b"ZDIJKBCLAEQ", lengths: b"ZDIJKBLAE", depth: Some(b'I'), build: internal_thread };

/// G212.
pub static EXTERNAL_THREAD: WordFormat =
    WordFormat { letters: b"ZDIJKBCLAEQ", lengths: b"ZDIJKBLAE", depth: Some(b'I'), build: external_thread };

impl Given<'_> {
    fn get(&self, letter: u8) -> Option<f64> {
        self.words.get(letter)
    }

    fn or(&self, letter: u8, default: f64) -> f64 {
        self.get(letter).unwrap_or(default)
    }

    /// A word without which there is no cycle.
    fn need(&self, letter: u8, word: &'static str) -> Result<f64, WrongParameter> {
        self.get(letter).ok_or(WrongParameter::new(Fault::CycleParameterMissing, word))
    }

    /// A word of which 0 stands for another value too.
    fn or_for_zero(&self, letter: u8, default: f64) -> f64 {
        self.get(letter).filter(|value| *value != 0.0).unwrap_or(default)
    }

    /// Which way "up" is over a bottom.
    fn up(&self, bottom: f64) -> f64 {
        up(bottom, self.reference)
    }

    fn dwell(&self) -> Result<f64, WrongParameter> {
        let seconds = self.or(b'K', 0.0);
        refuse(!(seconds >= 0.0 && seconds.is_finite()), Fault::CycleParameter, "K")?;
        Ok(seconds)
    }

    /// A word that says which: 0, 1 and on.
    fn choice(&self, letter: u8, word: &'static str, last: f64) -> Result<Option<u32>, WrongParameter> {
        let Some(value) = self.get(letter) else { return Ok(None) };
        refuse(value.fract() != 0.0 || !(0.0..=last).contains(&value), Fault::CycleParameter, word)?;
        Ok(Some(value as u32))
    }
}

/// A: the spindle is stopped for the way out (1.2, 1.3).
fn leave(given: &Given<'_>) -> Result<Leave, WrongParameter> {
    Ok(match given.choice(b'A', "A", 1.0)? {
        Some(1) => Leave::Stopped(given.turn),
        _ => Leave::Rapid,
    })
}

fn hole(given: &Given<'_>, bottom: f64, pecks: Option<Pecks>, leave: Leave) -> Made {
    let hole = Hole {
        reference: given.reference,
        bottom,
        top: given.top,
        pecks,
        dwell: given.dwell()?,
        leave,
        feed: given.feed,
    };
    hole.check("I")?;
    Ok(Operation::plain(Work::Hole(hole), given.up(bottom)))
}

/// 1.2.
fn drilling(given: &Given<'_>) -> Made {
    hole(given, given.need(b'I', "I")?, None, leave(given)?)
}

/// 1.3.
fn variable_pecks(given: &Given<'_>) -> Made {
    let bottom = given.need(b'I', "I")?;
    let up = given.up(bottom);
    let reference = given.reference;
    let every = given.or(b'J', 0.0);
    refuse(!((0.0..=1e6).contains(&every) && every.fract() == 0.0), Fault::CycleParameter, "J")?;
    let back = match (given.get(b'H'), every) {
        // H omitted: always to Z.
        (None, _) => Back::To(reference),
        (_, 1.0) => Back::To(reference),
        (Some(level), 0.0) => Back::To(level),
        (Some(distance), every) => {
            refuse(!(distance >= 0.0), Fault::CycleParameter, "H")?;
            Back::ByAndTo { distance, every: every as u32, level: reference }
        }
    };
    let pecks = Pecks {
        surface: reference - up * given.or(b'D', 0.0),
        first: given.need(b'B', "B")?,
        factor: given.or_for_zero(b'R', 1.0),
        least: given.or_for_zero(b'L', 1.0),
        back,
        // C0 is an error and not 1 mm.
        gap: given.or(b'C', 1.0),
    };
    pecks.check("B", "C")?;
    refuse(!(pecks.least > 0.0), Fault::CycleParameter, "L")?;
    hole(given, bottom, Some(pecks), leave(given)?)
}

/// 1.4: J pecks of I from Z; the sign of I is the way.
fn constant_pecks(given: &Given<'_>) -> Made {
    let peck = given.need(b'I', "I")?;
    let count = f64::from(whole(given.need(b'J', "J")?, 0.001, "J")?);
    let back = match given.get(b'B') {
        None => Back::To(given.reference),
        Some(distance) => {
            refuse(!(distance >= 0.0), Fault::CycleParameter, "B")?;
            Back::By(distance)
        }
    };
    let pecks =
        Pecks { surface: given.reference, first: peck.abs(), factor: 1.0, least: 0.0, back, gap: 1.0 };
    pecks.check("I", "I")?;
    hole(given, given.reference + peck * count, Some(pecks), Leave::Rapid)
}

/// 1.5.
fn tapping(given: &Given<'_>) -> Made {
    let holder = match given.choice(b'R', "R", 1.0)? {
        Some(1) => {
            refuse(!(given.rpm > 0.0), Fault::TappingSpeed, "S")?;
            let pitch = if given.feed_per_turn { given.feed } else { given.feed / given.rpm };
            let back = positive(given.or_for_zero(b'J', 1.0), "J")?;
            Holder::Rigid { pitch, rpm: given.rpm, back, orients_first: false }
        }
        _ => Holder::Floating { feed: given.feed },
    };
    let thread = TappedHole {
        reference: given.reference,
        bottom: given.need(b'I', "I")?,
        top: given.top,
        dwell: given.dwell()?,
        turn: given.turn,
        holder,
    };
    refuse((thread.bottom - thread.reference).abs() <= SAME_POINT_MM, Fault::CycleNoDepth, "I")?;
    thread.check("S")?;
    Ok(Operation::plain(Work::TappedHole(thread), given.up(thread.bottom)))
}

/// 1.6.
fn reaming(given: &Given<'_>) -> Made {
    hole(given, given.need(b'I', "I")?, None, Leave::Feed)
}

/// 1.7.
fn boring(given: &Given<'_>) -> Made {
    let bottom = given.need(b'I', "I")?;
    let aside = Aside { angle: given.get(b'Q'), by: [given.or(b'D', 0.0), given.or(b'E', 0.0)] };
    let way = match (given.choice(b'A', "A", 1.0)?, given.choice(b'R', "R", 1.0)?) {
        (Some(0), _) => Way::OutAside { aside, back_at: given.top },
        (Some(_), _) => Way::InAside(aside),
        (None, Some(1)) => Way::OutAtFeed(given.top),
        (None, _) => Way::OutStopped,
    };
    let bore = Bore {
        reference: given.reference,
        bottom,
        top: given.top,
        dwell: given.dwell()?,
        feed: given.feed,
        turn: given.turn,
        way,
    };
    refuse((bottom - given.reference).abs() <= SAME_POINT_MM, Fault::CycleNoDepth, "I")?;
    Ok(Operation::plain(Work::Bore(bore), given.up(bottom)))
}

/// J+ is clockwise, J− counter-clockwise.
fn turn_of(j: f64) -> Turn {
    if j < 0.0 { Turn::CounterClockwise } else { Turn::Clockwise }
}

/// 1.8.
fn rectangular_pocket(given: &Given<'_>) -> Made {
    let length = given.need(b'J', "J")?;
    let half = [positive(length.abs(), "J")?, positive(given.need(b'K', "K")?.abs(), "K")?];
    let corner = match given.choice(b'M', "M", 2.0)? {
        Some(1) => Corner::Round(given.need(b'Q', "Q")?),
        Some(2) => Corner::Chamfer(given.need(b'Q', "Q")?),
        _ => Corner::Sharp,
    };
    pocket(given, Outline { half, corner }, given.or(b'A', 0.0), turn_of(length), &half)
}

/// 1.9.
fn circular_pocket(given: &Given<'_>) -> Made {
    let radius = given.need(b'J', "J")?;
    let size = positive(radius.abs(), "J")?;
    pocket(given, Outline::circle(size), 0.0, turn_of(radius), &[size])
}

/// Pockets: all words but those of the outline. A width C of one of the `sizes` makes the wall alone.
fn pocket(given: &Given<'_>, wall: Outline, degrees: f64, turn: Turn, sizes: &[f64]) -> Made {
    let bottom = given.need(b'I', "I")?;
    let up = given.up(bottom);
    let surface = given.reference - up * given.or(b'D', 1.0);
    let depth = (surface - bottom) * up;
    let levels = Levels::by_step(depth, given.need(b'B', "B")?, "B")?;
    let width = given.or(b'C', 0.0);
    // As wide as half the pocket it is no pass but asks for the wall alone (1.8, 1.9), however small the tool is.
    let wall_alone = sizes.iter().any(|size| (size - width).abs() <= SAME_POINT_MM);
    let cut = Cut {
        radius: given.tool.radius,
        step: if wall_alone { 0.0 } else { width },
        feed: given.feed,
        plunge: given.or_for_zero(b'V', given.feed / 2.0),
    };
    let cut = cut.check("C")?;
    let stock = given.or(b'L', 0.0);
    refuse(!(stock >= 0.0 && stock.is_finite()), Fault::CycleParameter, "L")?;
    let finish = positive(given.or_for_zero(b'H', given.feed), "H")?;
    crate::cycles::area::pocket::check_corner(&wall, "Q")?;
    // The approach level lies 1 mm above the surface, or is Z where that is nearer.
    let above = surface + up;
    let approach = if (given.reference - above) * up < 0.0 { given.reference } else { above };
    let rough = PocketRough {
        wall: wall.lengthwise(),
        emptied: 0.0,
        planes: Planes { safety: given.top, approach, surface },
        levels,
        cut,
        stock,
        clears: !wall_alone,
        wall_feed: (wall_alone || stock > 0.0).then_some(finish),
        entry: Entry::Straight,
        between: PocketSteps::AboveLevel,
    };
    rough.check("V")?;
    Ok(Operation {
        work: Work::PocketRough(rough),
        frame: wall.frame(Frame::new([0.0; 2], degrees, turn)),
        up,
        reference: Some(given.reference),
    })
}

/// 1.10.
fn bore_milling(given: &Given<'_>) -> Made {
    let bottom = given.need(b'I', "I")?;
    let up = given.up(bottom);
    let diameter = given.need(b'J', "J")?;
    let pitch = given.need(b'B', "B")?;
    let bore = BoreMilling {
        reference: given.reference,
        surface: given.reference - up * given.or(b'D', 0.0),
        bottom,
        top: given.top,
        diameter: diameter.abs(),
        drilled: given.or(b'K', 0.0),
        pitch: pitch.abs(),
        mills_bottom: pitch > 0.0,
        tool_radius: given.tool.radius,
        feed: given.feed,
    };
    bore.check(BoreNames { diameter: "J", drilled: "K", pitch: "B", depth: "I" })?;
    let frame = Frame::new([0.0; 2], 0.0, turn_of(diameter));
    Ok(Operation::new(Work::BoreMilling(bore), frame, up))
}

/// 1.11.
fn internal_thread(given: &Given<'_>) -> Made {
    thread(given, true)
}

/// 1.12.
fn external_thread(given: &Given<'_>) -> Made {
    thread(given, false)
}

fn thread(given: &Given<'_>, internal: bool) -> Made {
    let bottom = given.need(b'I', "I")?;
    let up = given.up(bottom);
    let diameter = given.need(b'J', "J")?;
    let pitch = given.need(b'B', "B")?;
    let thread = ThreadMilling {
        reference: given.reference,
        surface: given.reference - up * given.or(b'D', 0.0),
        bottom,
        top: given.top,
        internal,
        diameter: diameter.abs(),
        depth: given.need(b'K', "K")?,
        pitch: pitch.abs(),
        downwards: pitch > 0.0,
        edges: given.choice(b'C', "C", 1000.0)?.unwrap_or(1),
        stock: given.or(b'L', 0.0),
        step: given.or(b'A', 0.0),
        approach: given.get(b'E'),
        angle: given.or(b'Q', 0.0),
        tool_radius: given.tool.radius,
        feed: given.feed,
    };
    let (step, approach, length) = ("A", "E", "I");
    thread.check(ThreadNames {
        diameter: "J",
        depth: "K",
        pitch: "B",
        stock: "L",
        step,
        approach,
        length,
    })?;
    // The angle counts from the abscissa whichever way the thread turns.
    let frame = Frame::new([0.0; 2], thread.angle, turn_of(diameter));
    Ok(Operation::new(Work::ThreadMilling(thread), frame, up))
}
