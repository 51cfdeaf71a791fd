//! How the controls write what a cycle is made of.

/// A control's way of writing.
#[derive(Clone, Copy, PartialEq, Eq, Debug)]
pub struct Style {
    /// Name of the control language.
    pub dialect: &'static str,
    /// The state that the text relies on.
    pub state: &'static str,
    /// Before and behind a comment.
    pub comment: [&'static str; 2],
    /// Decimals of a coordinate.
    pub decimals: usize,
    /// Address of a dwell in seconds.
    pub dwell: char,
    /// A block that goes in step with the spindle and comes back, K mm a turn; none where there is none.
    pub there_and_back: Option<&'static str>,
    /// What a hole is tried with, by the cycle.
    pub holes: &'static [HoleWords],
}

/// A canned cycle that may be the same as one of the editor. Braces hold what is put in: `{t}` dwell in the unit
/// of P, `{I}` peck, `{S}` speed, `{pitch}` mm a turn, `{turn}` the code of its sense, `{tap}` the tapping code of it, `{aside}` the clearing move, `{f}` feed.
#[derive(Clone, Copy, PartialEq, Eq, Debug)]
pub struct HoleWords {
    /// The cycle of the editor.
    pub of: &'static str,
    /// A block before it; empty for none.
    pub before: &'static str,
    /// Its code and own words.
    pub words: &'static str,
    /// What F holds.
    pub feed: &'static str,
}

const fn hole(of: &'static str, words: &'static str) -> HoleWords {
    HoleWords { of, before: "", words, feed: "{f}" }
}

const fn tap(before: &'static str, words: &'static str, feed: &'static str) -> HoleWords {
    HoleWords { of: "G284", before, words, feed }
}

/// Drilling, boring and tapping as the Fanuc-like controls have them; which one makes the motion of a cycle is
/// found by running it.
const FANUC_HOLES: &[HoleWords] = &[
    hole("G281", "G81"),
    hole("G281", "G82 P{t}"),
    hole("G282", "G81"),
    hole("G282", "G82 P{t}"),
    hole("G282", "G83 Q{I}"),
    hole("G283", "G81"),
    hole("G283", "G83 Q{I}"),
    hole("G283", "G73 Q{I}"),
    tap("M29 S{S}", "{tap}", "{f}"),
    tap("M29 S{S}", "{tap} P{t}", "{f}"),
    tap("S{S} {turn}", "{tap}", "{pitch}"),
    tap("S{S} {turn}", "{tap}", "{f}"),
    tap("", "{tap}", "{pitch}"),
    tap("", "{tap}", "{f}"),
    tap("", "{tap} P{t}", "{f}"),
    hole("G285", "G85"),
    hole("G285", "G89 P{t}"),
    hole("G286", "G85"),
    hole("G286", "G89 P{t}"),
    hole("G286", "G86"),
    hole("G286", "G86 P{t}"),
    hole("G286", "G88 P{t}"),
    hole("G297", "G76 Q{aside}"),
    hole("G297", "G76 Q{aside} P{t}"),
];

/// The state that a block of the editor's own control relies on: a cycle is carried out in the plane and the unit in
/// force (3.1).
pub const OWN_STATE: &str = "G17 G71 G90";

/// The controls that cycles are written for, besides the one that has them.
const STYLES: &[Style] = &[
    Style {
        dialect: "gsk990mc",
        state: "G17 G21 G90 G94 G40 G80",
        comment: ["(", ")"],
        decimals: 4,
        dwell: 'X',
        there_and_back: None,
        holes: FANUC_HOLES,
    },
    Style {
        dialect: "kaitong",
        state: "G17 G21 G90 G94 G40 G80",
        comment: ["(", ")"],
        decimals: 4,
        dwell: 'X',
        there_and_back: None,
        holes: FANUC_HOLES,
    },
    Style {
        dialect: "weihong",
        state: "G17 G21 G90 G40 G80",
        comment: ["'", ""],
        decimals: 5,
        dwell: 'X',
        there_and_back: None,
        holes: FANUC_HOLES,
    },
    Style {
        dialect: "rs274",
        state: "G17 G21 G90 G94 G40 G80",
        comment: ["(", ")"],
        decimals: 5,
        dwell: 'P',
        there_and_back: Some("G33.1"),
        holes: FANUC_HOLES,
    },
];

impl Style {
    /// The style of a control language; none where cycles are not written in it.
    pub fn of(dialect: &str) -> Option<&'static Style> {
        STYLES.iter().find(|style| style.dialect == dialect)
    }
}
