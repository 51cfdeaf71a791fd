//! A canned cycle that was broken off in one of its holes: it goes on with that hole and not with the first.
//!
//! A block that drills several holes (K or L with G91) is one block. What it does is divided where the tool is positioned
//! over the next hole: by positioning across the tool alone, at or above the level where cutting begins, so that what was
//! passed is only ever left out between two holes, with the tool out of the part. The hole under way is the one on whose
//! axis the axes came to rest, or to which they were on their way. Where that is not clear (holes one in the other, axes
//! that stand elsewhere, a block that does more than drill) the block begins with its first hole, as ever.

use ferrocut_geometry::{Axis, Position};
use ferrocut_interpreter::Interpreter;
use ferrocut_toolpath::{Op, Step};

/// Steps of a block that are looked at; a cycle of more begins with its first hole.
const MOST_STEPS: usize = 20_000;

/// Places nearer than this are one, mm.
const SAME: f64 = 1e-4;

/// What of a block is left out.
#[derive(Clone, Copy, PartialEq, Debug)]
pub(super) struct Left {
    /// How many steps.
    pub steps: usize,
    /// Where the axes stand behind them.
    pub position: Position,
    /// The hole with which it begins, counted from 1.
    pub hole: u32,
}

fn across(a: Position, b: Position) -> f64 {
    (a[Axis::X] - b[Axis::X]).hypot(a[Axis::Y] - b[Axis::Y])
}

/// What the block that comes has done already when the axes came to rest at `at`; none where it begins as a whole.
pub(super) fn done_before(interpreter: &Interpreter, start: Position, at: Position) -> Option<Left> {
    let mut ahead = interpreter.looking_ahead();
    let block = interpreter.blocks_begun() + 1;
    let mut steps: Vec<Step> = Vec::new();
    while let Some(Ok(step)) = ahead.next() {
        if step.block != block {
            break;
        }
        if steps.len() >= MOST_STEPS || !is_of_hole(&step.op) {
            return None;
        }
        steps.push(step);
    }
    // Where each step begins.
    let mut from = Vec::with_capacity(steps.len());
    let mut place = start;
    for step in &steps {
        from.push(place);
        place = step.op.target().copied().unwrap_or(place);
    }
    let cuts =
        steps.iter().zip(&from).filter(|(step, _)| matches!(step.op, Op::Feed { .. } | Op::Tap { .. }));
    let clear =
        cuts.map(|(step, from)| step.op.target().map_or(from[Axis::Z], |to| to[Axis::Z].max(from[Axis::Z])));
    let clear = clear.fold(f64::NEG_INFINITY, f64::max);
    let is_over = |(step, from): (&Step, &Position)| match &step.op {
        Op::Rapid { to, .. } => {
            let moves = across(*to, *from) > SAME && (to[Axis::Z] - from[Axis::Z]).abs() < SAME;
            moves && from[Axis::Z] >= clear - SAME
        }
        _ => false,
    };
    let begins: Vec<usize> =
        steps.iter().zip(&from).enumerate().filter(|(_, pair)| is_over(*pair)).map(|(n, _)| n).collect();
    // A cycle whose first hole is where the tool stands has no way to it.
    let first = match (begins.first(), clear.is_finite()) {
        (_, false) | (None, _) => return None,
        (Some(first), true) => {
            steps.iter().take(*first).any(|step| matches!(step.op, Op::Feed { .. } | Op::Tap { .. }))
        }
    };
    let is_here = |begin: &usize| {
        let (Some(step), Some(from)) = (steps.get(*begin), from.get(*begin)) else { return false };
        let Some(to) = step.op.target() else { return false };
        let is_on_axis = across(*to, at) < SAME;
        // On the way there, at its level.
        let detour = across(*from, at) + across(at, *to) - across(*from, *to);
        let is_on_way =
            detour < SAME && (at[Axis::Z] - from[Axis::Z]).abs() < SAME && across(*from, at) > SAME;
        is_on_axis || is_on_way
    };
    let mut here = begins.iter().enumerate().filter(|(_, begin)| is_here(begin));
    let ((number, begin), None) = (here.next()?, here.next()) else { return None };
    let hole = u32::try_from(number).ok()? + 1 + u32::from(first);
    (hole > 1).then_some(())?;
    Some(Left { steps: *begin, position: *from.get(*begin)?, hole })
}

/// What a cycle that makes holes does; anything else is no such cycle.
fn is_of_hole(op: &Op) -> bool {
    matches!(
        op,
        Op::Rapid { .. } | Op::Feed { .. } | Op::Tap { .. } | Op::Dwell(_) | Op::Spindle(_) | Op::Orient(_)
    )
}
