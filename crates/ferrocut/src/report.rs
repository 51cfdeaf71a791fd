//! What a run took, for people and as JSON.

use crate::commands::layout::{padded, width};
use crate::diagnostics::Diagnostics;
use ferrocut_controller::{Activity, Report};
use ferrocut_geometry::Position;
use ferrocut_machine::Machine;
use serde::Serialize;
use std::collections::BTreeMap;

/// Report of `time` and `run` as JSON.
#[derive(Serialize)]
pub struct JsonReport {
    total_s: f64,
    cutting_s: f64,
    rapid_s: f64,
    dwell_s: f64,
    tool_change_s: f64,
    spindle_s: f64,
    cutting_mm: f64,
    rapid_mm: f64,
    tools: Vec<JsonTool>,
    min: BTreeMap<&'static str, f64>,
    max: BTreeMap<&'static str, f64>,
    moves: u64,
    parts: u32,
}

#[derive(Serialize)]
struct JsonTool {
    t: u32,
    total_s: f64,
}

/// Rounds to a nanometre or nanosecond: sums of periods show no digits that mean nothing.
fn rounded(v: f64) -> f64 {
    (v * 1e9).round() / 1e9
}

impl JsonReport {
    /// The report of a run on `machine`.
    pub fn new(report: &Report, machine: &Machine) -> JsonReport {
        let time = |activity| rounded(report.time(activity));
        let side = |position: Option<Position>| {
            let axes = machine.axis_set();
            position.map_or_else(BTreeMap::new, |p| axes.iter().map(|a| (a.name(), rounded(p[a]))).collect())
        };
        JsonReport {
            total_s: rounded(report.total()),
            cutting_s: time(Activity::Cutting),
            rapid_s: time(Activity::Rapid),
            dwell_s: time(Activity::Dwell),
            tool_change_s: time(Activity::ToolChange),
            spindle_s: time(Activity::Spindle),
            cutting_mm: rounded(report.cutting_mm),
            rapid_mm: rounded(report.rapid_mm),
            tools: report.tools().map(|(t, s)| JsonTool { t, total_s: rounded(s) }).collect(),
            min: side(report.extent.map(|e| e.0)),
            max: side(report.extent.map(|e| e.1)),
            moves: report.moves,
            parts: report.parts,
        }
    }
}

/// Seconds as people read them: `3:07.4`, `1:02:03`.
pub fn clock(seconds: f64) -> String {
    let tenths = (seconds * 10.0).round().max(0.0) as u64;
    let (minutes, rest) = (tenths / 600, tenths % 600);
    if minutes < 60 {
        format!("{minutes}:{:02}.{}", rest / 10, rest % 10)
    } else {
        format!("{}:{:02}:{:02}", minutes / 60, minutes % 60, rest / 10)
    }
}

/// The report in lines.
pub fn text(report: &Report, machine: &Machine, diagnostics: &Diagnostics) -> String {
    let label = |key: &str| diagnostics.catalogue().label(key, &[]);
    let mut rows: Vec<(String, String)> = Vec::new();
    let parts = [
        (Activity::Cutting, "label-cutting"),
        (Activity::Rapid, "label-rapid"),
        (Activity::Dwell, "label-dwell"),
        (Activity::ToolChange, "label-tool-changes"),
        (Activity::Spindle, "label-spindle"),
    ];
    let spent: Vec<String> = parts
        .into_iter()
        .filter(|(activity, _)| report.time(*activity) > 0.0)
        .map(|(activity, key)| format!("{} {}", label(key), clock(report.time(activity))))
        .collect();
    let spent = if spent.is_empty() { String::new() } else { format!("  ({})", spent.join(", ")) };
    rows.push((label("label-time"), format!("{}{spent}", clock(report.total()))));
    let tools: Vec<String> = report
        .tools()
        .map(|(tool, seconds)| {
            let name = match tool {
                0 => label("label-no-tool"),
                _ => diagnostics.catalogue().label("label-tool", &[("tool", f64::from(tool).into())]),
            };
            format!("{name} {}", clock(seconds))
        })
        .collect();
    if tools.len() > 1 {
        rows.push((label("label-by-tool"), tools.join(", ")));
    }
    let distance = format!(
        "{} {:.1} mm, {} {:.1} mm",
        label("label-cutting"),
        report.cutting_mm,
        label("label-rapid"),
        report.rapid_mm
    );
    rows.push((label("label-distance"), distance));
    let extents = match report.extent {
        None => label("label-no-moves"),
        Some((min, max)) => {
            let moved = machine.axis_set().iter().filter(|a| min[*a] != max[*a]);
            let sides: Vec<String> =
                moved.map(|a| format!("{} {:.3} … {:.3}", a.letter(), min[a], max[a])).collect();
            sides.join("   ")
        }
    };
    rows.push((label("label-extents"), extents));
    rows.push((label("label-moves"), report.moves.to_string()));
    rows.push((label("label-parts"), report.parts.to_string()));
    let widest = rows.iter().map(|(name, _)| width(name)).max().unwrap_or(0);
    rows.iter().map(|(name, value)| format!("  {}  {value}\n", padded(name, widest))).collect()
}

#[cfg(test)]
mod tests {
    use super::clock;

    #[test]
    fn times_read_as_on_a_clock() {
        assert_eq!(clock(0.04), "0:00.0");
        assert_eq!(clock(187.44), "3:07.4");
        assert_eq!(clock(59.96), "1:00.0");
        assert_eq!(clock(3723.0), "1:02:03");
    }
}
