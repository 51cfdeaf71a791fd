//! In which order tools come into the spindle: with as few changes as what waits for what allows.
//!
//! Nothing is won by leaving a chain for later that the tool in the spindle may cut, since what is cut only makes others
//! free. So the order of the tools alone is to be found, and it is looked for in all orders at once, the shortest
//! first: what is cut after each of them is told by kinds of chains, of which drawings have few. A chain that needs no
//! tool is cut with the one that is there.

use super::nest::Nest;
use rustc_hash::{FxHashMap, FxHashSet};

/// What is looked at in all; more leave the order of the tools to that of the drawing.
const MOST_LOOKED_AT: usize = 10_000_000;

/// Chains of a tool that wait for the same chains of other tools: all of them are free at the same moment.
#[derive(PartialEq, Eq, Hash)]
struct Kind {
    tool: Option<u32>,
    /// Numbers of kinds, in rising order.
    waits_for: Vec<u32>,
}

/// The tools in the order in which they come, given that of each chain; `None` where there is too much to tell. Of
/// several orders with as few changes it is that in which tools come that can cut all they have left, and then those
/// that come first in the drawing.
pub fn turns(tools: &[Option<u32>], nest: &Nest) -> Option<Vec<u32>> {
    let mut looked_at = 0;
    let kinds = kinds(tools, nest, &mut looked_at)?;
    let mut known = FxHashSet::default();
    let tools: Vec<u32> = tools.iter().copied().flatten().filter(|tool| known.insert(*tool)).collect();
    // What is cut, the last tool, and from which of these it was reached.
    let nothing = vec![0; kinds.len().div_ceil(64)];
    let mut reached = vec![(cut_by(None, nothing, &kinds, &mut looked_at), 0, 0)];
    let mut seen = FxHashSet::default();
    let mut at = 0;
    loop {
        let (cut, ..) = reached.get(at)?;
        let cut = cut.clone();
        if (0..kinds.len() as u32).all(|kind| is_in(&cut, kind)) {
            break;
        }
        let mut next = Vec::new();
        for tool in &tools {
            let now = cut_by(Some(*tool), cut.clone(), &kinds, &mut looked_at);
            if now == cut {
                continue;
            }
            let mut own = (0u32..).zip(&kinds).filter(|(_, kind)| kind.tool == Some(*tool));
            let is_done = own.all(|(number, _)| is_in(&now, number));
            if is_done {
                // It has to come once more in any case, and what it cuts only makes others free.
                next.clear();
            }
            next.push((now, *tool, at));
            if is_done {
                break;
            }
        }
        reached.extend(next.into_iter().filter(|(now, ..)| seen.insert(now.clone())));
        if looked_at > MOST_LOOKED_AT {
            return None;
        }
        at += 1;
    }
    let mut turns = Vec::new();
    while at > 0 {
        let (_, tool, before) = reached.get(at)?;
        turns.push(*tool);
        at = *before;
    }
    turns.reverse();
    Some(turns)
}

fn is_in(set: &[u64], kind: u32) -> bool {
    set.get(kind as usize / 64).is_some_and(|word| word & 1 << (kind % 64) != 0)
}

/// What is cut after a turn of a tool, of these kinds, each of which stands behind those that it waits for.
fn cut_by(tool: Option<u32>, mut cut: Vec<u64>, kinds: &[Kind], looked_at: &mut usize) -> Vec<u64> {
    for (number, kind) in (0u32..).zip(kinds).filter(|(_, kind)| kind.tool.is_none() || kind.tool == tool) {
        *looked_at += 1 + kind.waits_for.len();
        if kind.waits_for.iter().all(|other| is_in(&cut, *other))
            && let Some(word) = cut.get_mut(number as usize / 64)
        {
            *word |= 1 << (number % 64);
        }
    }
    *looked_at += kinds.len();
    cut
}

/// The kinds of chains, each behind those that it waits for.
fn kinds(tools: &[Option<u32>], nest: &Nest, looked_at: &mut usize) -> Option<Vec<Kind>> {
    let mut waiting = vec![0u32; tools.len()];
    for (_, around) in nest.pairs() {
        *waiting.get_mut(around as usize)? += 1;
    }
    let mut waits_for: Vec<Vec<u32>> = vec![Vec::new(); tools.len()];
    let mut numbers: FxHashMap<Kind, u32> = FxHashMap::default();
    // Each after all that is inside of it: what is around has the larger area, so that all have their turn.
    let mut next: Vec<u32> =
        (0u32..).zip(&waiting).filter(|(_, count)| **count == 0).map(|(i, _)| i).collect();
    while let Some(chain) = next.pop() {
        let tool = *tools.get(chain as usize)?;
        let mut own = std::mem::take(waits_for.get_mut(chain as usize)?);
        own.sort_unstable();
        own.dedup();
        let count = numbers.len() as u32;
        let number = *numbers.entry(Kind { tool, waits_for: own.clone() }).or_insert(count);
        for around in nest.around(chain) {
            let waits = waits_for.get_mut(*around as usize)?;
            if tools.get(*around as usize) == Some(&tool) {
                // It is cut in the same turn, once what this one waits for is.
                waits.extend(&own);
                *looked_at += own.len();
            } else {
                waits.push(number);
            }
            let count = waiting.get_mut(*around as usize)?;
            *count = count.saturating_sub(1);
            if *count == 0 {
                next.push(*around);
            }
        }
        *looked_at += 1 + nest.around(chain).len();
        if *looked_at > MOST_LOOKED_AT {
            return None;
        }
    }
    let mut kinds: Vec<(u32, Kind)> = numbers.into_iter().map(|(kind, number)| (number, kind)).collect();
    kinds.sort_unstable_by_key(|(number, _)| *number);
    Some(kinds.into_iter().map(|(_, kind)| kind).collect())
}
