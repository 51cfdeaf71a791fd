//! The plot as SVG: panels under each other over one axis of time.
//!
//! Letters are text, so that every language can be written. Colours are those of paper, on a dark screen
//! those of a dark one; what is dashed is a limit, without colours too.

use super::gauge::{AxisGauge, Gauge, Peak};
use super::series::Series;
use crate::view::scale::{decimals, fixed, round_up, short, ticks};
use crate::view::svg::{escape, path_data};
use ferrocut_machine::{Argument, Catalogue};
use std::fmt::Write;

/// Everything in pixels.
const LEFT: f64 = 90.0;
const WIDE: f64 = 1200.0;
const RIGHT: f64 = 20.0;
const TOP: f64 = 64.0;
const HIGH: f64 = 96.0;
const GAP: f64 = 30.0;
const BOTTOM: f64 = 44.0;
const LINE: f64 = 16.0;
/// Least distance of two labels.
const TICK_HIGH: f64 = 24.0;
const TICK_WIDE: f64 = 100.0;

/// Heights closer than this are the same.
const LEVEL: f64 = 0.005;

const STYLE: &str = "<style>svg{background:#fff;color:#222831;font:12px sans-serif}\
    text{fill:currentColor}.s{fill-opacity:.7}.e{text-anchor:end}.m{text-anchor:middle}.t{font-size:16px}\
    path{fill:none;stroke-linejoin:round}.f,.g{stroke:#808a96;stroke-width:.7}.g{stroke-opacity:.35}\
    .d{stroke:#1f5fa8}.l{stroke:#b5460f;stroke-dasharray:6 4}\
    @media screen and (prefers-color-scheme:dark){svg{background:#1c2026;color:#dde2e8}\
    .d{stroke:#79b0ea}.l{stroke:#f0935c}}</style>\n";

/// A quantity with what limits it.
struct Panel<'a> {
    title: String,
    series: &'a Series,
    /// Limits that change with time.
    varying: Option<&'a Series>,
    /// Limits that do not, 0 for none.
    fixed: [f64; 2],
    /// Whether the sign counts.
    signed: bool,
    peak: &'a Peak,
}

/// Draws what was measured of `program` on `machine`.
pub fn draw(gauge: &Gauge, program: &str, machine: &str, catalogue: &Catalogue) -> String {
    let label = |key: &str, arguments: &[(&str, Argument)]| catalogue.label(key, arguments);
    let panels = panels(gauge, catalogue);
    let (width, high) = (LEFT + WIDE + RIGHT, TOP + panels.len() as f64 * (HIGH + GAP) + BOTTOM);
    let title = label("label-plot-title", &[("program", program.into()), ("machine", machine.into())]);
    let ms = |periods: f64| short(periods * gauge.period * 1000.0);
    let window = [("period", ms(1.0).into()), ("window", ms(gauge.apart as f64 + 2.0).into())];
    let note = label("label-plot-note", &window);
    let mut out = format!(
        "<svg xmlns=\"http://www.w3.org/2000/svg\" width=\"{width}\" height=\"{high}\" \
         viewBox=\"0 0 {width} {high}\" role=\"img\" aria-labelledby=\"title\">\n<title id=\"title\">"
    );
    escape(&mut out, &title);
    out.push_str("</title>\n<desc>");
    escape(&mut out, &note);
    out.push_str("</desc>\n");
    out.push_str(STYLE);
    text(&mut out, [LEFT, 24.0], "t", &title);
    text(&mut out, [LEFT, 24.0 + LINE], "s", &note);
    // The time of a column is the end of its first period.
    let periods = gauge.speed.columns().last().map_or(1, |(at, _)| at + 1).max(2);
    let begin = gauge.span[0].max(gauge.period);
    let end = begin + (periods - 1) as f64 * gauge.period;
    let x_of = |time: f64| LEFT + (time - begin) / (end - begin) * WIDE;
    let step = round_up((end - begin) * TICK_WIDE / WIDE);
    let times: Vec<f64> = ticks(begin, end, step).collect();
    for (place, panel) in panels.iter().enumerate() {
        let top = TOP + place as f64 * (HIGH + GAP) + LINE;
        draw_panel(&mut out, panel, top, &times, &x_of, &|at| begin + at as f64 * gauge.period, catalogue);
    }
    let foot = high - BOTTOM + LINE;
    for time in times {
        text(&mut out, [x_of(time), foot], "s m", &fixed(time, decimals(step)));
    }
    text(&mut out, [LEFT + WIDE, foot + LINE], "s e", &label("label-plot-time", &[]));
    out.push_str("</svg>\n");
    out
}

fn panels<'a>(gauge: &'a Gauge, catalogue: &Catalogue) -> Vec<Panel<'a>> {
    let speed = Panel {
        title: catalogue.label("label-plot-speed", &[]),
        series: &gauge.speed,
        varying: Some(&gauge.feed),
        fixed: [0.0; 2],
        signed: false,
        peak: &gauge.speed_peak,
    };
    let mut panels = vec![speed];
    for quantity in 0..super::gauge::QUANTITIES.len() {
        panels.extend(gauge.axes.iter().filter_map(|axis| axis_panel(axis, quantity, catalogue)));
    }
    panels.push(Panel {
        title: catalogue.label("label-plot-error", &[]),
        series: &gauge.error,
        varying: Some(&gauge.tolerance),
        fixed: [0.0; 2],
        signed: false,
        peak: &gauge.error_peak,
    });
    panels
}

fn axis_panel<'a>(axis: &'a AxisGauge, quantity: usize, catalogue: &Catalogue) -> Option<Panel<'a>> {
    let name = super::gauge::QUANTITIES.get(quantity)?;
    let length = if axis.is_rotary { "°" } else { "mm" };
    let letter = axis.axis.letter().to_string();
    let arguments = [("axis", letter.into()), ("length", length.into())];
    let limit = *axis.limits.get(quantity)?;
    Some(Panel {
        title: catalogue.label(&format!("label-plot-{name}"), &arguments),
        series: axis.series.get(quantity)?,
        varying: None,
        fixed: [limit, if quantity == 0 { axis.rapid } else { 0.0 }],
        signed: true,
        peak: axis.peaks.get(quantity)?,
    })
}

fn draw_panel(
    out: &mut String,
    panel: &Panel,
    top: f64,
    times: &[f64],
    x_of: &dyn Fn(f64) -> f64,
    time_of: &dyn Fn(u64) -> f64,
    catalogue: &Catalogue,
) {
    let highest = |series: &Series| series.extent().map_or(0.0, |[low, high]| high.max(-low));
    let mut most = panel.fixed.into_iter().fold(highest(panel.series), f64::max);
    most = most.max(panel.varying.map_or(0.0, highest));
    let most = if most > 0.0 { most * 1.08 } else { 1.0 };
    let least = if panel.signed { -most } else { 0.0 };
    let y_of = |value: f64| top + HIGH * (most - value) / (most - least);
    let of = |at: u64, value: f64| [x_of(time_of(at)), y_of(value)];
    out.push_str("<g><title>");
    escape(out, &panel.title);
    out.push_str("</title>");
    text(out, [LEFT, top - 5.0], "", &panel.title);
    let peak = panel.peak;
    let share = peak.share().map_or_else(String::new, |share| format!(" ({} %)", short(share * 100.0)));
    let said = [
        ("value", format!("{}{share}", short(peak.value)).into()),
        ("time", short(peak.time).into()),
        ("line", peak.line.to_string().into()),
    ];
    text(out, [LEFT + WIDE, top - 5.0], "s e", &catalogue.label("label-plot-peak", &said));
    let step = round_up((most - least) * TICK_HIGH / HIGH);
    let mut grid = String::new();
    for value in ticks(least, most, step) {
        path_data(&mut grid, &[[LEFT, y_of(value)], [LEFT + WIDE, y_of(value)]]);
        text(out, [LEFT - 6.0, y_of(value) + 4.0], "s e", &fixed(value, decimals(step)));
    }
    for time in times {
        path_data(&mut grid, &[[x_of(*time), top], [x_of(*time), top + HIGH]]);
    }
    path(out, "g", &grid);
    let (right, low) = (LEFT + WIDE, top + HIGH);
    path(out, "f", &format!("M{LEFT} {top}H{right}V{low}H{LEFT}z"));
    let mut limits = String::new();
    for limit in panel.fixed.into_iter().filter(|limit| *limit > 0.0) {
        for limit in [limit, -limit].into_iter().take(if panel.signed { 2 } else { 1 }) {
            path_data(&mut limits, &[[LEFT, y_of(limit)], [right, y_of(limit)]]);
        }
    }
    if let Some(varying) = panel.varying {
        curve(&mut limits, varying, &of);
    }
    path(out, "l", &limits);
    let mut data = String::new();
    curve(&mut data, panel.series, &of);
    path(out, "d", &data);
    out.push_str("</g>\n");
}

/// Path data of a series: from the lowest to the highest of each column and on to the next, with breaks at gaps.
fn curve(out: &mut String, series: &Series, of: &dyn Fn(u64, f64) -> [f64; 2]) {
    let mut line: Vec<[f64; 2]> = Vec::new();
    for (at, column) in series.columns() {
        let Some([low, high]) = column else {
            path_data(out, &line);
            line.clear();
            continue;
        };
        let (low, high) = (of(at, low), of(at, high));
        // The end that is nearer to where the line stands comes first.
        let is_above = line.last().is_some_and(|last| (last[1] - high[1]).abs() < (last[1] - low[1]).abs());
        let ends = if is_above { [high, low] } else { [low, high] };
        for end in ends {
            // A level stretch is one line.
            if let [.., before, last] = line.as_mut_slice()
                && (before[1] - end[1]).abs().max((last[1] - end[1]).abs()) < LEVEL
            {
                *last = end;
                continue;
            }
            line.push(end);
        }
    }
    path_data(out, &line);
}

fn path(out: &mut String, class: &str, data: &str) {
    if !data.is_empty() {
        // Writing to a String cannot fail, here and below.
        let _ = write!(out, "<path class=\"{class}\" d=\"{data}\"/>");
    }
}

fn text(out: &mut String, [x, y]: [f64; 2], class: &str, text: &str) {
    let _ = write!(out, "<text x=\"{x:.1}\" y=\"{y:.1}\"");
    if !class.is_empty() {
        let _ = write!(out, " class=\"{class}\"");
    }
    out.push('>');
    escape(out, text);
    out.push_str("</text>\n");
}
