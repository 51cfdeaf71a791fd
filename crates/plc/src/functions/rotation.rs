//! ROT and ROTB: which way a turret or magazine turns, and how far.

use super::{Held, Line};
use crate::memory::{Memory, Width};

/// How a turn is asked for.
struct Asked {
    /// Number of the first position, 0 or 1.
    first: i64,
    /// Whether the shorter way is taken; else it is always forward.
    shorter: bool,
    /// Whether the position before the goal is meant, where the turn slows down.
    before: bool,
    /// Whether the number of steps is asked for, not the position.
    steps: bool,
}

/// What to give, and whether the way is backward; `None` where a position does not exist.
fn turn(positions: i64, current: i64, goal: i64, asked: &Asked) -> Option<(i64, bool)> {
    let exists = |position: i64| (asked.first..asked.first + positions).contains(&position);
    if positions < 1 || !exists(current) || !exists(goal) {
        return None;
    }
    let forward = (goal - current).rem_euclid(positions);
    let backward = positions - forward;
    // Two ways of the same length: forward.
    let is_backward = asked.shorter && forward > backward;
    let way = if is_backward { backward } else { forward };
    let way = if asked.before { (way - 1).max(0) } else { way };
    if asked.steps {
        return Some((way, is_backward));
    }
    let moved = if is_backward { current - way } else { current + way };
    Some(((moved - asked.first).rem_euclid(positions) + asked.first, is_backward))
}

/// RN0 ST5, BYT ST4, DIR ST3, POS ST2, INC ST1, ACT ST0. W1: backward.
pub(super) fn decimal(
    memory: &mut Memory,
    positions: u32,
    (current, goal, to): (u16, u16, u16),
    held: Held,
    line: Line,
) -> bool {
    let digits = line.digits(4);
    let asked =
        Asked { first: i64::from(line.st(5)), shorter: line.st(3), before: line.st(2), steps: line.st(1) };
    let found = match (line.st(0), memory.read_bcd(current, digits), memory.read_bcd(goal, digits)) {
        (true, Some(current), Some(goal)) => {
            turn(i64::from(positions), i64::from(current), i64::from(goal), &asked)
        }
        _ => None,
    };
    let Some((result, is_backward)) = found else { return held.read(memory) };
    memory.write_bcd(to, digits, u32::try_from(result).unwrap_or(0));
    is_backward
}

/// RN0 ST4, DIR ST3, POS ST2, INC ST1, ACT ST0. W1: backward. The number of positions is a signal too.
pub(super) fn binary(
    memory: &mut Memory,
    width: Width,
    positions: u16,
    (current, goal, to): (u16, u16, u16),
    held: Held,
    line: Line,
) -> bool {
    let asked =
        Asked { first: i64::from(line.st(4)), shorter: line.st(3), before: line.st(2), steps: line.st(1) };
    let value = |at| i64::from(memory.read(at, width));
    let found = if line.st(0) { turn(value(positions), value(current), value(goal), &asked) } else { None };
    let Some((result, is_backward)) = found else { return held.read(memory) };
    memory.write(to, width, result as i32);
    is_backward
}
