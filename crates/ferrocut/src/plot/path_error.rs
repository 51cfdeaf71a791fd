//! How far the axes are from the programmed lines and arcs.
//!
//! A point is compared with the moves about the place where the point before it was, so that a path that
//! comes by there another time does not count. That place goes on along the program, never back, and not
//! beyond the move that is being run. It may be behind it: acceleration after interpolation lags.

use ferrocut_controller::{Cnc, Programmed};
use ferrocut_geometry::Position;
use std::collections::VecDeque;

/// Moves ahead that a point is compared with: a rounding may pass over short moves.
const AHEAD: usize = 8;

/// Moves kept behind the one being run. Those of the longest lag, a second, at one a period.
const BEHIND: u64 = 10_000;

/// The moves about the place where the axes are.
#[derive(Default)]
pub struct PathError {
    /// The nearest one first.
    moves: VecDeque<Programmed>,
    /// Number of the last move seen.
    seen: u64,
    /// Number of the move being run.
    running: u64,
}

impl PathError {
    /// Takes the moves that were given to motion since the last call.
    pub fn follow(&mut self, cnc: &Cnc) {
        let Some(first) = cnc.moves().next().map(|m| m.number) else { return };
        self.running = first;
        // Numbers are consecutive.
        let known = (self.seen + 1).saturating_sub(first);
        let new = cnc.moves().skip(usize::try_from(known).unwrap_or(usize::MAX));
        for programmed in new {
            self.seen = programmed.number;
            self.moves.push_back(*programmed);
        }
        while self.moves.front().is_some_and(|m| m.number + BEHIND < first) {
            self.moves.pop_front();
        }
    }

    /// Forgets all moves: the place has another name.
    pub fn forget(&mut self) {
        self.moves.clear();
    }

    /// The move that the axes are on.
    pub fn now(&self) -> Option<&Programmed> {
        self.moves.front()
    }

    /// Distance of `point` from the programmed path; `None` where none is programmed.
    pub fn at(&mut self, point: Position) -> Option<f64> {
        loop {
            let (mut nearest, mut least) = (0, self.moves.front()?.distance(point)?);
            for (place, programmed) in self.moves.iter().enumerate().take(1 + AHEAD).skip(1) {
                // Behind positioning of every axis on its own the path begins anew.
                let Some(distance) = programmed.distance(point) else { break };
                if distance < least {
                    (nearest, least) = (place, distance);
                }
            }
            let may_leave = self.moves.get(1).is_some_and(|m| m.number <= self.running);
            if nearest == 0 || !may_leave {
                return Some(least);
            }
            while nearest > 0 && self.moves.get(1).is_some_and(|m| m.number <= self.running) {
                self.moves.pop_front();
                nearest -= 1;
            }
        }
    }

    /// Leaves positioning of every axis on its own, and what is before it, once it is over: it ends at rest.
    pub fn leave_positioning(&mut self) {
        let is_over = |m: &Programmed| m.number < self.running && m.distance(Position::default()).is_none();
        if let Some(last) = self.moves.iter().take(1 + AHEAD).rposition(is_over) {
            self.moves.drain(..=last);
        }
    }
}

#[cfg(test)]
mod tests {
    use super::*;
    use ferrocut_controller::Way;

    fn point(x: f64, y: f64) -> Position {
        Position::xyz(x, y, 0.0)
    }

    fn line(number: u64, from: Position, to: Position) -> Programmed {
        Programmed { number, way: Way::Line(from, to), is_rapid: false, feed: None, tolerance: None }
    }

    /// Along X to 10, along Y to 10, back above the first line at a distance of 0.5.
    fn hairpin(running: u64) -> PathError {
        let corners = [point(0.0, 0.0), point(10.0, 0.0), point(10.0, 0.5), point(0.0, 0.5)];
        let moves = corners.windows(2).zip(1..).map(|(c, number)| line(number, c[0], c[1]));
        PathError { moves: moves.collect(), seen: 3, running }
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
    fn a_lagging_point_stays_on_the_move_it_is_on() {
        let mut error = hairpin(3);
        assert_eq!(error.at(point(4.0, 0.0)), Some(0.0));
        assert_eq!(error.now().unwrap().number, 1);
    }

    #[test]
    fn positioning_of_every_axis_on_its_own_has_no_path() {
        let mut error = hairpin(1);
        error.moves[0].way = Way::Apart;
        assert_eq!(error.at(point(4.0, 3.0)), None);
        error.running = 2;
        error.leave_positioning();
        assert_eq!(error.at(point(9.0, 0.25)), Some(1.0));
    }
}
