//! The end of a run that is not known to its end: from where on it goes on.

use super::{Point, STANDING_CONTROLS, STANDING_KNOTS, Smoother, Vector};
use crate::path::pace::reach;
use ferrocut_geometry::AXES;

/// Spans at the end of an unfinished run that still change with what follows.
const TAIL: usize = 8;

/// So many times the reach of smoothing at the end of an unfinished run changes too.
const OPEN_REACH: f64 = 2.5;

impl Smoother {
    /// One behind the last span to be put out.
    pub(super) fn last(&self, open: bool) -> usize {
        let spans = self.knots.len().saturating_sub(5);
        if !open {
            return spans;
        }
        // The last knot that span `k` needs is a point that is kept: thinning out goes on from it as it did before.
        let is_kept =
            |k: usize| self.chords.binary_search_by(|chord| chord.0.total_cmp(&self.knots[k + 5])).is_ok();
        // What the end does bears on what is close to it; where the last chord ends depends on what follows, and how knots lie
        // about its begin. Something must go on, better no more than half of it.
        let close = self.knots[spans + 2] - self.open_reach();
        let begun = self.chords.len().checked_sub(3).map_or(0.0, |i| self.chords[i].0);
        let most = spans.saturating_sub(TAIL);
        let until = |to: f64| (1..=most).rev().find(|k| self.knots[k + 5] <= to && is_kept(*k));
        let half = self.points[self.points.len() / 2].u;
        [begun.min(close), begun.min(half), begun, f64::INFINITY].into_iter().find_map(until).unwrap_or(0)
    }

    /// How far the end of an open run bears on it, mm.
    fn open_reach(&self) -> f64 {
        let [.., begin, _] = self.points.as_slice() else { return 0.0 };
        let [(from, a), .., (to, b)] = self.chords.as_slice() else { return 0.0 };
        OPEN_REACH * self.reach_along((*from, a), (*to, b), begin)
    }

    /// How far a wave is smoothed away on the way between two places, each with its length, at the feed and within the tolerance of
    /// the line that begins at a point, mm.
    fn reach_along(&self, from: (f64, &Vector), to: (f64, &Vector), begin: &Point) -> f64 {
        let mut direction = [0.0; AXES];
        for k in 0..self.count {
            direction[k] = (to.1[k] - from.1[k]) / (to.0 - from.0);
        }
        reach(begin.pace(), begin.programmed, self.soft.straight(&direction).j)
    }

    /// Keeps what the spans from `next` on need.
    pub(super) fn keep_from(&mut self, next: usize) {
        // Span `next` needs knots next−2…next+3 and control points next−1…next+2.
        let begin = self.t(next);
        let u = self.knots[next + 5];
        let i =
            self.chords.iter().skip(1).take_while(|chord| chord.0 <= u).count().min(self.chords.len() - 2);
        let (a, b) = (&self.chords[i], &self.chords[i + 1]);
        let share = (u - a.0) / (b.0 - a.0);
        self.anchor_reach = self.reach(i);
        self.anchor_size = self.size(i);
        self.anchor = (u, std::array::from_fn(|k| a.1[k] + (b.1[k] - a.1[k]) * share));
        self.knots.copy_within(next..next + STANDING_KNOTS, 0);
        self.knots.truncate(STANDING_KNOTS);
        self.is_dense.copy_within(next..next + STANDING_KNOTS - 3, 0);
        self.is_dense.truncate(STANDING_KNOTS - 3);
        self.controls.copy_within(next..next + STANDING_CONTROLS, 0);
        self.controls.truncate(STANDING_CONTROLS);
        self.goes_on = true;
        let first = self.segment(begin, 0).saturating_sub(1);
        self.points.drain(..first);
        self.standing = self.points.len();
    }
}
