//! How far the axes are from the programmed lines and arcs.
//!
//! A point is compared with the moves about the place where the point before it was, so that a path that
//! comes by there another time does not count. That place goes on along the program, never back, and not
//! beyond the move that is being run. It may be behind it by as long as acceleration after interpolation lags.

use ferrocut_controller::{Cnc, Programmed, Way};
use ferrocut_geometry::{Position, SAME_POINT_MM};
use std::collections::VecDeque;

/// Moves ahead that a point is compared with: a rounding may pass over short moves.
const AHEAD: usize = 8;

/// How far blocks may end off the line of those before them to be one with them, all together, mm.
const OFF: f64 = 1e-7;

/// A move, or blocks that go on one line: a corner is rounded over as many of them as it needs.
#[derive(Clone, Copy)]
struct Stretch {
    /// The last of them, over the way of all.
    programmed: Programmed,
    /// Number of the first.
    first: u64,
    /// How far the blocks end off it at most, mm.
    off: f64,
}

impl Stretch {
    fn new(programmed: Programmed) -> Stretch {
        Stretch { programmed, first: programmed.number, off: 0.0 }
    }

    /// Goes on with `next`, if that is a block of the same line.
    fn go_on(&mut self, next: &Programmed) -> bool {
        let own = &self.programmed;
        let (Way::Line(from, middle), Way::Line(begin, to)) = (own.way, next.way) else { return false };
        let are_alike = (own.is_rapid, own.feed, own.tolerance) == (next.is_rapid, next.feed, next.tolerance);
        let product = |a: Position, b: Position| a.0.iter().zip(b.0).map(|(a, b)| a * b).sum::<f64>();
        let whole = Programmed { way: Way::Line(from, to), ..*next };
        let goes_on = are_alike
            && middle == begin
            && middle.0[3..] == to.0[3..]
            && product(middle - from, to - middle) > 0.0;
        let off = self.off + whole.distance(middle).unwrap_or(f64::INFINITY);
        if !goes_on || off > OFF {
            return false;
        }
        (self.programmed, self.off) = (whole, off);
        true
    }
}

/// The moves about the place where the axes are.
#[derive(Default)]
pub struct PathError {
    /// The nearest one first.
    moves: VecDeque<Stretch>,
    /// Number of the last move seen.
    seen: u64,
    /// Number of the move being run.
    running: u64,
    /// Periods that the axes may be behind.
    lag: usize,
    /// The moves that were run in these periods, the oldest first.
    ran: VecDeque<u64>,
}

impl PathError {
    /// For axes that may be behind by this many periods.
    pub fn new(lag: usize) -> PathError {
        PathError { lag, ..PathError::default() }
    }

    /// Takes the moves that were given to motion since the last call.
    pub fn follow(&mut self, cnc: &Cnc) {
        if let Some(first) = cnc.moves().next().map(|m| m.number) {
            self.running = first;
            // Numbers are consecutive.
            let known = (self.seen + 1).saturating_sub(first);
            for programmed in cnc.moves().skip(usize::try_from(known).unwrap_or(usize::MAX)) {
                self.seen = programmed.number;
                if !self.moves.back_mut().is_some_and(|last| last.go_on(programmed)) {
                    self.moves.push_back(Stretch::new(*programmed));
                }
            }
        }
        self.ran.push_back(self.running);
        if self.ran.len() > self.lag + 1 {
            self.ran.pop_front();
        }
        // A joint may be rounded while the move behind it is run already.
        let last = self.ran.front().map_or(0, |ran| ran.saturating_sub(1));
        while self.moves.front().is_some_and(|m| m.programmed.number < last) {
            self.moves.pop_front();
        }
    }

    /// Forgets all moves: the place has another name.
    pub fn forget(&mut self) {
        self.moves.clear();
    }

    /// The move that the axes are on.
    pub fn now(&self) -> Option<&Programmed> {
        self.moves.front().map(|stretch| &stretch.programmed)
    }

    /// Distance of `point` from the programmed path; `None` where none is programmed.
    pub fn at(&mut self, point: Position) -> Option<f64> {
        self.leave_positioning();
        loop {
            let least = self.moves.front()?.programmed.distance(point)?;
            let (mut nearest, mut least) = (0, least);
            for (place, stretch) in self.moves.iter().enumerate().take(1 + AHEAD).skip(1) {
                // Behind positioning of every axis on its own the path begins anew.
                let Some(distance) = stretch.programmed.distance(point) else { break };
                // Where a path comes back on itself the later move counts.
                if distance < least + SAME_POINT_MM && stretch.first <= self.running {
                    nearest = place;
                }
                least = least.min(distance);
            }
            if nearest == 0 {
                return Some(least);
            }
            self.moves.drain(..nearest);
        }
    }

    /// Leaves what is before positioning of every axis on its own, which begins at rest, and it too once it is over.
    fn leave_positioning(&mut self) {
        let ran = self.moves.iter().take_while(|m| m.first <= self.running).enumerate();
        let Some((place, number)) =
            ran.filter(|(_, m)| m.programmed.way == Way::Apart).map(|(at, m)| (at, m.first)).last()
        else {
            return;
        };
        let end = if number < self.running { place + 1 } else { place };
        self.moves.drain(..end);
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    fn point(x: f64, y: f64) -> Position {
        Position::xyz(x, y, 0.0)
    }

    fn line(number: u64, from: Position, to: Position) -> Programmed {
        Programmed { number, way: Way::Line(from, to), is_rapid: false, feed: None, tolerance: None }
    }

    /// Along X to 10, along Y to 10, back above the first line at a distance of 0.5.
    fn hairpin(running: u64) -> PathError {
        let corners = [point(0.0, 0.0), point(10.0, 0.0), point(10.0, 0.5), point(0.0, 0.5)];
        let moves = corners.windows(2).zip(1..).map(|(c, number)| Stretch::new(line(number, c[0], c[1])));
        PathError { moves: moves.collect(), seen: 3, running, ..PathError::default() }
    }

    #[test]
    fn a_rounded_corner_is_as_far_as_the_nearer_line() {
        // 0.03 before the corner and 0.01 beside: the first line is nearer; then the second.
        let mut error = hairpin(1);
        assert!((error.at(point(9.97, 0.01)).unwrap() - 0.01).abs() < 1e-12);
        error.running = 2;
        assert!((error.at(point(9.98, 0.04)).unwrap() - 0.02).abs() < 1e-12);
        assert_eq!(error.now().unwrap().number, 2);
    }

    #[test]
    fn a_path_never_goes_back_to_a_move_that_was_left() {
        let mut error = hairpin(3);
        assert_eq!(error.at(point(10.0, 0.2)), Some(0.0));
        assert_eq!(error.at(point(8.0, 0.5)), Some(0.0));
        // 0.4 from the last line, although only 0.1 from the first.
        assert!((error.at(point(5.0, 0.1)).unwrap() - 0.4).abs() < 1e-12);
    }

    #[test]
    fn a_path_that_comes_back_on_itself_is_left_all_the_same() {
        // Twenty times down and up a hole, then away along X.
        let (top, bottom) = (point(0.0, 0.0), Position::xyz(0.0, 0.0, -5.0));
        let strokes = (0..20).flat_map(|_| [(top, bottom), (bottom, top)]).chain([(top, point(9.0, 0.0))]);
        let of = |((from, to), number)| Stretch::new(line(number, from, to));
        let moves = strokes.zip(1..).map(of).collect();
        let mut error = PathError { moves, running: 40, ..PathError::default() };
        assert_eq!(error.at(top), Some(0.0));
        error.running = 41;
        assert_eq!(error.at(point(7.0, 0.0)), Some(0.0));
    }

    #[test]
    fn a_lagging_point_stays_on_the_move_it_is_on() {
        let mut error = hairpin(3);
        assert_eq!(error.at(point(4.0, 0.0)), Some(0.0));
        assert_eq!(error.now().unwrap().number, 1);
    }

    #[test]
    fn blocks_of_one_line_are_the_line() {
        let mut stretch = Stretch::new(line(1, point(0.0, 0.0), point(0.1, 0.2)));
        assert!(stretch.go_on(&line(2, point(0.1, 0.2), point(0.3, 0.6))));
        assert!(!stretch.go_on(&line(3, point(0.3, 0.6), point(0.4, 0.7))), "it turns");
        assert!(!stretch.go_on(&line(3, point(0.3, 0.6), point(0.2, 0.4))), "it turns back");
        assert_eq!((stretch.first, stretch.programmed.number), (1, 2));
        assert_eq!(stretch.programmed.way, Way::Line(point(0.0, 0.0), point(0.3, 0.6)));
    }

    #[test]
    fn positioning_of_every_axis_on_its_own_has_no_path() {
        let mut error = hairpin(1);
        error.moves[0].programmed.way = Way::Apart;
        assert_eq!(error.at(point(4.0, 3.0)), None);
        error.running = 2;
        assert!((error.at(point(9.9, 0.25)).unwrap() - 0.1).abs() < 1e-12);
        // Nor has it any while what is before it is known.
        let mut error = hairpin(2);
        error.moves[1].programmed.way = Way::Apart;
        assert_eq!(error.at(point(9.0, 0.3)), None);
    }
}
