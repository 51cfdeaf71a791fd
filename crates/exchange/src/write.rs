//! A part program from what the pen does.
//!
//! Plain G0, G1, G2, G3 with I and J, which every control here reads alike; what differs, also by what its
//! parameters say, is in [`Style`]. Numbers are rounded to the control's increment before anything is decided by them, so that
//! an arc whose ends fall together is left out and never becomes a whole turn.

use crate::curve::Curve;
use crate::drawing::{Action, Drawing, Move};
use crate::settings::{Cutting, Format, Settings};
use ferrocut_geometry::vector::{Point, distance};
use ferrocut_machine::{Memory, ToolTable};
use ferrocut_program::Span;
use std::f64::consts::PI;
use std::fmt::Write;

/// How a control writes programs.
#[derive(Clone, Copy, PartialEq, Eq, Debug)]
pub struct Style {
    /// Name of the control language.
    pub dialect: &'static str,
    /// First line; none where programs have no number.
    pub number: Option<&'static str>,
    /// Before and behind a comment.
    pub comment: [&'static str; 2],
    /// State that the program relies on.
    pub state: &'static str,
    /// Decimals of a coordinate.
    pub decimals: u32,
    /// I and J are the centre in the work coordinate system; else from the start of the arc.
    pub centre_is_absolute: bool,
}

/// The controls that drawings are written for.
const STYLES: &[Style] = &[
    Style {
        dialect: "gsk990mc",
        number: Some("O0001"),
        comment: ["(", ")"],
        state: "G21 G17 G40 G49 G80 G90 G94 G54",
        decimals: 4,
        centre_is_absolute: false,
    },
    Style {
        dialect: "kaitong",
        number: Some("O0001"),
        comment: ["(", ")"],
        state: "G21 G17 G40 G49 G80 G90 G94 G54",
        decimals: 4,
        centre_is_absolute: false,
    },
    Style {
        dialect: "weihong",
        number: None,
        comment: ["'", ""],
        state: "G21 G17 G40 G49 G80 G90 G54",
        decimals: 6,
        centre_is_absolute: false,
    },
];

impl Style {
    /// The style of a control language; `None` where drawings are not written in it.
    pub fn of(dialect: &str) -> Option<&'static Style> {
        STYLES.iter().find(|style| style.dialect == dialect)
    }
}

/// What a program does, in numbers.
#[derive(Clone, Copy, PartialEq, Debug, Default)]
pub struct Summary {
    /// Straight cuts.
    pub lines: u64,
    /// Arcs.
    pub arcs: u64,
    /// Times that the pen is lowered.
    pub lowered: u64,
    /// Length of the cuts, mm.
    pub cut_mm: f64,
    /// Length of the ways in the air over X and Y, mm.
    pub way_mm: f64,
    /// Smallest and largest X and Y of the cuts, mm; `None` where nothing is cut.
    pub extent: Option<[Point; 2]>,
}

/// A part program made from a drawing.
#[derive(Clone, PartialEq, Debug)]
pub struct Program {
    /// Its text.
    pub text: String,
    /// For each line the piece of the drawing that caused it; line 0 where none did.
    pub origins: Vec<Span>,
    /// What it does.
    pub summary: Summary,
}

/// Whether the pen is raised before the first move and after the last.
#[derive(Clone, Copy, PartialEq, Eq, Debug)]
pub enum Ends {
    /// Only where the drawing says so, as the control runs a drawing itself (Weihong 7).
    AsDrawn,
    /// Always: a program that is kept starts from anywhere.
    Raised,
}

/// Writes a program. `name` is the drawing's, for a comment.
pub fn write(
    moves: &[Move],
    drawing: &Drawing,
    settings: &Settings,
    style: &Style,
    name: &str,
    ends: Ends,
) -> Program {
    let mut writer = Writer {
        drawing,
        settings,
        style,
        lengths: Memory::new(style.dialect).tools,
        unit: 10f64.powi(style.decimals as i32),
        program: Program { text: String::new(), origins: Vec::new(), summary: Summary::default() },
        at: [None; 2],
        z: None,
        place: [0.0; 2],
        code: None,
        feed: None,
        layer: None,
        tool: None,
        spindle: None,
    };
    if let Some(number) = style.number {
        writer.line(number, Span::default());
    }
    writer.comment(name, Span::default());
    writer.line(style.state, Span::default());
    if let (Ends::Raised, Some(first)) = (ends, moves.first()) {
        // With a tool's length still unknown nothing goes down to the height of crossing.
        let cut = moves.iter().find(|m| m.action != Action::Raise);
        if let Some(cut) = cut.filter(|cut| writer.cutting(cut).tool.is_some()) {
            writer.select(cut);
        }
        writer.rapid_z(settings.pen_up, first.span);
    }
    for m in moves {
        writer.step(m);
    }
    if ends == Ends::Raised {
        writer.rapid_z(settings.pen_up, drawing.end);
        if writer.spindle.is_some() {
            writer.line("M5", drawing.end);
        }
    }
    writer.line("M30", drawing.end);
    writer.program
}

struct Writer<'a> {
    drawing: &'a Drawing,
    settings: &'a Settings,
    style: &'a Style,
    /// The control's table of tool lengths.
    lengths: ToolTable,
    /// Increments in a mm.
    unit: f64,
    program: Program,
    /// X and Y in increments, where they are known.
    at: [Option<i64>; 2],
    /// Z in increments.
    z: Option<i64>,
    /// Where the pen is, mm, for the lengths of ways.
    place: Point,
    /// The G code in force of G0 to G3.
    code: Option<u8>,
    feed: Option<f64>,
    layer: Option<u32>,
    tool: Option<u32>,
    spindle: Option<f64>,
}

impl Writer<'_> {
    fn step(&mut self, m: &Move) {
        match m.action {
            Action::Raise => self.rapid_z(self.settings.pen_up, m.span),
            Action::Travel(to) => {
                self.select(m);
                self.travel(to, m);
            }
            Action::Lower => {
                let cutting = self.select(m);
                if self.at.contains(&None) {
                    // A plotter starts at its zero.
                    self.travel(self.place, m);
                }
                self.program.summary.lowered += 1;
                self.feed_z(cutting.depth, cutting.plunge, m.span);
            }
            Action::Cut(curve) => {
                let cutting = self.select(m);
                match m.z {
                    Some(z) => self.cut_in_space(curve.to, z, &cutting, m.span),
                    None => self.cut(&curve, &cutting, m.span),
                }
            }
        }
    }

    /// How the layer of a move is cut.
    fn cutting(&self, m: &Move) -> Cutting {
        let layer = self.drawing.layers.get(m.layer as usize);
        layer.and_then(|layer| layer.cutting).unwrap_or(self.settings.cutting)
    }

    /// Says the layer, and puts its tool and spindle speed in force where the settings give them.
    fn select(&mut self, m: &Move) -> Cutting {
        let layer = self.drawing.layers.get(m.layer as usize);
        let cutting = self.cutting(m);
        if self.layer == Some(m.layer) {
            return cutting;
        }
        self.layer = Some(m.layer);
        if let Some(layer) = layer.filter(|layer| !layer.name.is_empty()) {
            let kind = if self.drawing.format == Format::Plt { "PEN" } else { "LAYER" };
            let text = format!("{kind} {}", layer.name);
            self.comment(&text, m.span);
        }
        if let Some(tool) = cutting.tool.filter(|tool| self.tool != Some(*tool)) {
            if self.z.is_some() {
                self.rapid_z(self.settings.pen_up, m.span);
            }
            self.line(&format!("T{tool} M6"), m.span);
            self.tool = Some(tool);
            // Its length is taken up on the way to the height of crossing; a tool beyond the control's table has none.
            let length = match u16::try_from(tool).ok().and_then(|number| self.lengths.get(number)) {
                Some(_) => format!("G0 G43 H{tool}"),
                None => "G0 G49".to_owned(),
            };
            self.program.text.push_str(&length);
            let z = self.unit_of(self.settings.pen_up);
            self.number('Z', z);
            self.end(m.span);
            (self.code, self.z) = (Some(0), Some(z));
            // A new tool starts its spindle anew.
            self.spindle = None;
        }
        if let Some(rpm) = cutting.spindle.filter(|rpm| self.spindle != Some(*rpm)) {
            let speed = short(rpm);
            self.line(&format!("S{speed} M3"), m.span);
            self.spindle = Some(rpm);
        }
        cutting
    }

    fn travel(&mut self, to: Point, m: &Move) {
        self.program.summary.way_mm += distance(self.place, to);
        self.place = to;
        let target = self.units(to);
        let z = m.z.map(|z| self.unit_of(z));
        if self.at == target.map(Some) && (z.is_none() || z == self.z) {
            return;
        }
        self.code_word(0);
        self.coordinate('X', 0, target[0]);
        self.coordinate('Y', 1, target[1]);
        if let Some(z) = z.filter(|z| self.z != Some(*z)) {
            self.number('Z', z);
            self.z = Some(z);
        }
        self.end(m.span);
    }

    fn rapid_z(&mut self, z: f64, span: Span) {
        let z = self.unit_of(z);
        if self.z == Some(z) {
            return;
        }
        self.code_word(0);
        self.number('Z', z);
        self.z = Some(z);
        self.end(span);
    }

    fn feed_z(&mut self, z: f64, feed: f64, span: Span) {
        let z = self.unit_of(z);
        if self.z == Some(z) {
            return;
        }
        self.code_word(1);
        self.number('Z', z);
        self.z = Some(z);
        self.feed_word(feed);
        self.end(span);
    }

    /// Cuts along a curve at the layer's depth.
    fn cut(&mut self, curve: &Curve, cutting: &Cutting, span: Span) {
        self.feed_z(cutting.depth, cutting.plunge, span);
        self.measure(curve);
        self.place = curve.to;
        let from = self.units(curve.from);
        if self.at != from.map(Some) {
            // Curves that meet may be a hair apart.
            self.straight(from, cutting.feed, span);
        }
        let to = self.units(curve.to);
        let center = curve.bend.map(|bend| (self.units(bend.center), bend.sweep));
        let whole = curve.bend.is_some_and(|bend| bend.sweep.abs() > PI);
        match center {
            // Below half an increment an arc is its chord, and about its own start there is none.
            Some((center, sweep))
                if curve.sagitta() * self.unit >= 0.5 && center != from && (whole || to != from) =>
            {
                self.code_word(if sweep > 0.0 { 3 } else { 2 });
                self.number('X', to[0]);
                self.number('Y', to[1]);
                let origin = if self.style.centre_is_absolute { [0; 2] } else { from };
                self.number('I', center[0] - origin[0]);
                self.number('J', center[1] - origin[1]);
                self.at = to.map(Some);
                self.feed_word(cutting.feed);
                self.end(span);
                self.program.summary.arcs += 1;
            }
            _ if to != from => {
                self.straight(to, cutting.feed, span);
                self.program.summary.lines += 1;
            }
            _ => {}
        }
    }

    fn measure(&mut self, curve: &Curve) {
        let summary = &mut self.program.summary;
        summary.cut_mm += curve.length();
        let [low, high] = curve.extent();
        let [least, most] = summary.extent.get_or_insert([low, high]);
        for i in 0..2 {
            least[i] = least[i].min(low[i]);
            most[i] = most[i].max(high[i]);
        }
    }

    fn straight(&mut self, to: [i64; 2], feed: f64, span: Span) {
        self.code_word(1);
        self.coordinate('X', 0, to[0]);
        self.coordinate('Y', 1, to[1]);
        self.feed_word(feed);
        self.end(span);
    }

    /// A straight cut to a point in space. One that only goes down is lowering.
    fn cut_in_space(&mut self, to: Point, z: f64, cutting: &Cutting, span: Span) {
        self.measure(&Curve::line(self.place, to));
        self.place = to;
        let (target, z) = (self.units(to), self.unit_of(z));
        let stays = self.at == target.map(Some);
        if stays && self.z == Some(z) {
            return;
        }
        self.code_word(1);
        self.coordinate('X', 0, target[0]);
        self.coordinate('Y', 1, target[1]);
        let goes_down = self.z.is_none_or(|before| z < before);
        if self.z != Some(z) {
            self.number('Z', z);
            self.z = Some(z);
        }
        self.feed_word(if stays && goes_down { cutting.plunge } else { cutting.feed });
        self.end(span);
        self.program.summary.lines += 1;
    }

    fn unit_of(&self, mm: f64) -> i64 {
        // Coordinates are held to a hundred metres.
        (mm * self.unit).round() as i64
    }

    fn units(&self, p: Point) -> [i64; 2] {
        p.map(|c| self.unit_of(c))
    }

    /// The G code, unless it is in force.
    fn code_word(&mut self, code: u8) {
        if self.code != Some(code) {
            self.code = Some(code);
            self.program.text.push('G');
            self.program.text.push(char::from(b'0' + code));
        }
    }

    fn coordinate(&mut self, letter: char, axis: usize, value: i64) {
        let Some(at) = self.at.get_mut(axis) else { return };
        if *at != Some(value) {
            *at = Some(value);
            self.number(letter, value);
        }
    }

    /// Begins a word: a blank stands between two of a block.
    fn word(&mut self, letter: char) {
        let text = &mut self.program.text;
        if !text.ends_with('\n') {
            text.push(' ');
        }
        text.push(letter);
    }

    /// A word with a decimal point, whatever the control takes numbers without one for.
    fn number(&mut self, letter: char, value: i64) {
        self.word(letter);
        let text = &mut self.program.text;
        if value < 0 {
            text.push('-');
        }
        let unit = self.unit as u64;
        let (whole, mut part) = (value.unsigned_abs() / unit, value.unsigned_abs() % unit);
        // Writing to a string cannot fail.
        let _ = write!(text, "{whole}.");
        let mut place = unit / 10;
        loop {
            text.push(char::from(b'0' + (part / place.max(1)) as u8));
            part %= place.max(1);
            place /= 10;
            if part == 0 || place == 0 {
                break;
            }
        }
    }

    fn feed_word(&mut self, feed: f64) {
        if self.feed != Some(feed) {
            self.feed = Some(feed);
            self.word('F');
            self.program.text.push_str(&short(feed));
        }
    }

    /// Ends the block.
    fn end(&mut self, span: Span) {
        self.program.text.push('\n');
        self.program.origins.push(span);
    }

    fn comment(&mut self, text: &str, span: Span) {
        const LONGEST: usize = 80;
        // Brackets and line ends would end the comment.
        let clean = |c: char| if c.is_control() || matches!(c, '(' | ')') { ' ' } else { c };
        let text: String = text.chars().take(LONGEST).map(clean).collect();
        let [before, behind] = self.style.comment;
        self.line(&format!("{before}{}{behind}", text.trim()), span);
    }

    fn line(&mut self, block: &str, span: Span) {
        self.program.text.push_str(block);
        self.end(span);
    }
}

/// A number to four decimals without idle zeros.
fn short(value: f64) -> String {
    let text = format!("{value:.4}");
    text.trim_end_matches('0').trim_end_matches('.').to_owned()
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::curve::Bend;
    use crate::settings::Change;
    use std::f64::consts::{FRAC_PI_2, TAU};

    fn text(moves: &[Action], settings: &Settings, dialect: &str) -> Vec<String> {
        let mut drawing = Drawing::new(Format::Plt);
        for action in moves {
            drawing.push(*action, None, 0, Span::default()).unwrap();
        }
        let style = Style::of(dialect).unwrap();
        let program = write(&drawing.moves, &drawing, settings, style, "a(b)\nc", Ends::AsDrawn);
        assert_eq!(program.text.lines().count(), program.origins.len());
        program.text.lines().map(str::to_owned).collect()
    }

    const ARC: Curve = Curve {
        from: [10.0, 0.0],
        to: [0.0, 10.0],
        bend: Some(Bend { center: [0.0, 0.0], sweep: FRAC_PI_2 }),
    };

    #[test]
    fn a_program_is_readable() {
        let moves = [
            Action::Raise,
            Action::Travel([10.0, 0.0]),
            Action::Lower,
            Action::Cut(ARC),
            Action::Cut(Curve::line([0.0, 10.0], [-0.5, 10.0])),
            Action::Raise,
        ];
        let settings = Settings::default();
        let head = ["O0001", "(a b  c)", "G21 G17 G40 G49 G80 G90 G94 G54"];
        let body = [
            "G0 Z5.0",
            "X10.0 Y0.0",
            "G1 Z-1.0 F300",
            "G3 X0.0 Y10.0 I-10.0 J0.0 F600",
            "G1 X-0.5",
            "G0 Z5.0",
            "M30",
        ];
        assert_eq!(text(&moves, &settings, "gsk990mc"), [&head[..], &body].concat());
        let weihong = text(&moves, &settings, "weihong");
        assert_eq!((weihong[0].as_str(), &weihong[2..]), ("'a b  c", &body.map(str::to_owned)[..]));
    }

    #[test]
    fn arcs_that_rounding_closes_are_no_circles() {
        // A hundredth of an increment on a radius of 10, then a turn less the same.
        let tiny = 1e-7;
        let end = |angle: f64| [10.0 * angle.cos(), 10.0 * angle.sin()];
        let arc = |sweep: f64| {
            Action::Cut(Curve { to: end(sweep), bend: Some(Bend { center: [0.0; 2], sweep }), ..ARC })
        };
        let cut = |action| {
            let lines =
                text(&[Action::Travel([10.0, 0.0]), Action::Lower, action], &Settings::default(), "gsk990mc");
            lines[5..lines.len() - 1].to_vec()
        };
        assert_eq!(cut(arc(tiny)), [""; 0]);
        assert_eq!(cut(arc(TAU - tiny)), ["G3 X10.0 Y0.0 I-10.0 J0.0 F600"]);
        // Flatter than half an increment: a line.
        assert_eq!(cut(arc(0.002)), ["Y0.02 F600"]);
        // About its own start, when rounded.
        let dust = Curve::circle([10.00001, 0.0], [10.0, 0.0]);
        assert_eq!(cut(Action::Cut(dust)), [""; 0]);
    }

    #[test]
    fn layers_bring_their_tools() {
        let mut settings = Settings::default();
        let change =
            |tool| Change { tool: Some(tool), spindle: Some(8000.0), depth: Some(-2.5), ..Change::default() };
        settings.pens = vec![("1".into(), change(3)), ("2".into(), change(4))];
        let drawing =
            crate::plt::read(b"SP1;PU0,0;PD40,0;SP2;PD80,0;", ferrocut_program::FileId(1), &settings);
        let drawing = drawing.unwrap();
        let style = Style::of("gsk990mc").unwrap();
        let program = write(&drawing.moves, &drawing, &settings, style, "", Ends::Raised);
        let lines: Vec<&str> = program.text.lines().skip(3).collect();
        assert_eq!(
            lines,
            [
                "(PEN 1)",
                "T3 M6",
                "G0 G43 H3 Z5.0",
                "S8000 M3",
                "X0.0 Y0.0",
                "G1 Z-2.5 F300",
                "X1.0 F600",
                "(PEN 2)",
                "G0 Z5.0",
                "T4 M6",
                "G0 G43 H4 Z5.0",
                "S8000 M3",
                "G1 Z-2.5 F300",
                "X2.0 F600",
                "G0 Z5.0",
                "M5",
                "M30"
            ]
        );
    }
}
