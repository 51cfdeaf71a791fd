//! What a run took: times, distances, extents.

use ferrocut_geometry::Position;

/// Tools of a run for which there is room from the start, since a change is noted in the servo period.
const TOOLS: usize = 1024;

/// What the machine spends time on.
#[derive(Clone, Copy, PartialEq, Eq, Debug)]
pub enum Activity {
    /// Cutting moves.
    Cutting,
    /// Positioning moves.
    Rapid,
    /// Dwells.
    Dwell,
    /// Tool changes.
    ToolChange,
    /// Spindle run-up and braking.
    Spindle,
}

impl Activity {
    const COUNT: usize = 5;
}

/// What a run took so far.
#[derive(Clone, PartialEq, Debug)]
pub struct Report {
    period: f64,
    periods: [u64; Activity::COUNT],
    /// Periods by tool, in the order of first use.
    tools: Vec<(u32, u64)>,
    tool: u32,
    /// Length of cutting moves over X, Y, Z, mm.
    pub cutting_mm: f64,
    /// Length of positioning moves over X, Y, Z, mm.
    pub rapid_mm: f64,
    /// Smallest and largest machine coordinates of the moves; `None` before the first.
    pub extent: Option<(Position, Position)>,
    /// Parts finished.
    pub parts: u32,
    /// Moves run.
    pub moves: u64,
}

impl Report {
    /// An empty report; `period` in s.
    pub fn new(period: f64) -> Report {
        Report {
            period,
            periods: [0; Activity::COUNT],
            tools: Vec::with_capacity(TOOLS),
            tool: 0,
            cutting_mm: 0.0,
            rapid_mm: 0.0,
            extent: None,
            parts: 0,
            moves: 0,
        }
    }

    /// Counts a servo period.
    #[inline]
    pub(crate) fn period(&mut self, activity: Activity) {
        if let Some(periods) = self.periods.get_mut(activity as usize) {
            *periods += 1;
        }
        match self.tools.iter_mut().find(|(tool, _)| *tool == self.tool) {
            Some((_, periods)) => *periods += 1,
            None => self.tools.push((self.tool, 1)),
        }
    }

    /// The tool that time counts for from now on.
    pub(crate) fn change_tool(&mut self, tool: u32) {
        self.tool = tool;
    }

    /// Counts a finished move.
    pub(crate) fn finished(&mut self, activity: Activity, length: f64, min: Position, max: Position) {
        self.moves += 1;
        match activity {
            Activity::Cutting => self.cutting_mm += length,
            _ => self.rapid_mm += length,
        }
        self.extent = Some(match self.extent {
            None => (min, max),
            Some((least, most)) => (least.min(min), most.max(max)),
        });
    }

    /// Time of one activity, s.
    pub fn time(&self, activity: Activity) -> f64 {
        self.periods.get(activity as usize).map_or(0.0, |n| *n as f64 * self.period)
    }

    /// Time of the whole run, s.
    pub fn total(&self) -> f64 {
        self.periods.iter().sum::<u64>() as f64 * self.period
    }

    /// Tools in the order of first use, with the time of each, s.
    pub fn tools(&self) -> impl Iterator<Item = (u32, f64)> {
        self.tools.iter().map(|(tool, periods)| (*tool, *periods as f64 * self.period))
    }

    /// The tool in the spindle.
    pub fn tool(&self) -> u32 {
        self.tool
    }
}
