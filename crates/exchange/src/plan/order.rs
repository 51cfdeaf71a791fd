//! Which chain comes next: the nearest that is free, tool by tool.
//!
//! A chain is free once everything inside of it is cut. While the tool in the spindle has a free chain, the one whose
//! way is shortest comes next; then those that need no tool, which stay with the one that is there; then the tool whose
//! turn it is ([`tools`](super::tools)). A closed chain may be started at a few of its corners, an open one at either
//! end. Where the order of the drawing has less way and no more changes of the tool, and keeps what is inside before
//! what is around, it stays.

use super::Cut;
use super::chains::{Chain, Chains};
use super::nest::Nest;
use super::tools::turns;
use crate::curve::Curve;
use crate::drawing::Drawing;
use ferrocut_geometry::vector::{Point, distance};
use rstar::RTree;
use rstar::primitives::GeomWithData;
use std::collections::BTreeMap;

/// Corners at which a closed chain may be started.
const STARTS: usize = 4;

/// Where a chain may be started: its number and the index of the cut, or of the quadrant of a circle; for
/// an open chain 1 is its end.
type Start = GeomWithData<Point, (u32, u32)>;

/// The curves in the order of cutting; each chain starts where it is led to.
pub fn shortest(chains: &Chains, nest: Option<&Nest>, drawing: &Drawing, mut cut: impl FnMut(Cut)) {
    let tool = |chain: &Chain<'_>| {
        let layer = drawing.layers.get(chain.layer() as usize);
        layer.and_then(|layer| layer.cutting).and_then(|cutting| cutting.tool)
    };
    let Some(nest) = nest else { return by_size(chains, cut) };
    let of_chains: Vec<Option<u32>> = chains.iter().map(|chain| tool(&chain)).collect();
    let mut turns = turns(&of_chains, nest).unwrap_or_default().into_iter();
    let mut waiting = vec![0u32; chains.len()];
    for (_, around) in nest.pairs() {
        if let Some(count) = waiting.get_mut(around as usize) {
            *count += 1;
        }
    }
    // One tree a tool, of the chains that are free; the first chain of each tool tells its place.
    let mut free: BTreeMap<Option<u32>, (u32, RTree<Start>)> = BTreeMap::new();
    let mut starting: BTreeMap<Option<u32>, (u32, Vec<Start>)> = BTreeMap::new();
    for (chain, i) in chains.iter().zip(0u32..) {
        let (_, starts) = starting.entry(tool(&chain)).or_insert((i, Vec::new()));
        if waiting.get(i as usize) == Some(&0) {
            starts.extend(starts_of(&chain, i));
        }
    }
    for (tool, (first, starts)) in starting {
        free.insert(tool, (first, RTree::bulk_load(starts)));
    }
    let mut is_cut = vec![false; chains.len()];
    let mut sequence: Vec<Start> = Vec::with_capacity(chains.len());
    let (mut at, mut way, mut present) = ([0.0; 2], 0.0, None);
    loop {
        let has_one = |tool: &Option<u32>| free.get(tool).is_some_and(|(_, tree)| tree.size() > 0);
        let in_turn = [present, None].into_iter().find(has_one);
        let Some(next) = in_turn.or_else(|| turns.next().map(Some).filter(has_one)).or_else(|| {
            let with = free.iter().filter(|(_, (_, tree))| tree.size() > 0);
            with.min_by_key(|(_, (first, _))| *first).map(|(tool, _)| *tool)
        }) else {
            break;
        };
        present = next.or(present);
        let Some((_, tree)) = free.get_mut(&next) else { break };
        let Some(start) = tree.pop_nearest_neighbor(at) else { continue };
        let (number, place) = start.data;
        let (Some(done), Some(chain)) = (is_cut.get_mut(number as usize), chains.get(number as usize)) else {
            continue;
        };
        if std::mem::replace(done, true) {
            continue;
        }
        way += distance(at, *start.geom());
        at = end_from(&chain, *start.geom(), place);
        sequence.push(start);
        for around in nest.around(number) {
            let Some(count) = waiting.get_mut(*around as usize) else { continue };
            *count = count.saturating_sub(1);
            if *count == 0
                && let Some(freed) = chains.get(*around as usize)
                && let Some((_, tree)) = free.get_mut(&tool(&freed))
            {
                starts_of(&freed, *around).for_each(|start| tree.insert(start));
            }
        }
    }
    let sequence_tools = sequence.iter().filter_map(|start| of_chains.get(start.data.0 as usize).copied());
    if nest.pairs().all(|(own, around)| own < around)
        && changes(of_chains.iter().copied()) <= changes(sequence_tools)
        && way_of(chains) < way
    {
        return chains.iter().flat_map(|chain| chain.cuts).for_each(|c| cut(*c));
    }
    for start in sequence {
        let (number, place) = start.data;
        if let Some(chain) = chains.get(number as usize) {
            start_from(&chain, *start.geom(), place, &mut cut);
        }
    }
}

/// Where a chain ends that is started at one of its places.
fn end_from(chain: &Chain<'_>, start: Point, place: u32) -> Point {
    match (chain.is_closed, place) {
        (true, _) => start,
        (false, 1) => chain.from(),
        (false, _) => chain.to(),
    }
}

/// Small before large, which is inner before outer, where there is too much to tell more.
fn by_size(chains: &Chains, cut: impl FnMut(Cut)) {
    let mut sorted: Vec<Chain<'_>> = chains.iter().collect();
    sorted.sort_by_cached_key(|chain| {
        let [low, high] = chain.extent();
        // Areas are not negative, so their bits are in their order.
        ((high[0] - low[0]) * (high[1] - low[1])).max(0.0).to_bits()
    });
    sorted.into_iter().flat_map(|chain| chain.cuts.iter().copied()).for_each(cut);
}

/// How often a tool is put into the spindle.
fn changes(tools: impl Iterator<Item = Option<u32>>) -> usize {
    let mut tools: Vec<u32> = tools.flatten().collect();
    tools.dedup();
    tools.len()
}

/// Length of the ways between chains, from the zero on, mm.
pub fn way_of(chains: &Chains) -> f64 {
    let mut at = [0.0; 2];
    let mut way = 0.0;
    for chain in chains.iter() {
        way += distance(at, chain.from());
        at = chain.to();
    }
    way
}

/// Where a chain may be started.
fn starts_of(chain: &Chain<'_>, number: u32) -> impl Iterator<Item = Start> + use<> {
    let mut starts: Vec<Start> = Vec::with_capacity(STARTS);
    let mut add = |p: Point, place: usize| starts.push(GeomWithData::new(p, (number, place as u32)));
    match (chain.is_closed, chain.cuts) {
        (false, _) => {
            add(chain.from(), 0);
            add(chain.to(), 1);
        }
        (true, [alone]) => {
            let radius = alone.curve.radius();
            if let Some(bend) = alone.curve.bend {
                let [x, y] = bend.center;
                let quadrants = [[x + radius, y], [x, y + radius], [x - radius, y], [x, y - radius]];
                quadrants.into_iter().enumerate().for_each(|(i, p)| add(p, i));
            }
        }
        (true, cuts) => {
            let every = cuts.len().div_ceil(STARTS).max(1);
            cuts.iter().enumerate().step_by(every).for_each(|(i, cut)| add(cut.curve.from, i));
        }
    }
    starts.into_iter()
}

/// Gives out a chain from one of its places on.
fn start_from(chain: &Chain<'_>, p: Point, place: u32, cut: &mut impl FnMut(Cut)) {
    match (chain.is_closed, chain.cuts) {
        (false, cuts) if place == 1 => {
            cuts.iter().rev().for_each(|c| cut(Cut { curve: c.curve.reversed(), ..*c }));
        }
        (false, cuts) => cuts.iter().for_each(|c| cut(*c)),
        (true, [alone]) => cut(Cut { curve: Curve { from: p, to: p, ..alone.curve }, ..*alone }),
        (true, cuts) => {
            let (before, after) = cuts.split_at(cuts.len().min(place as usize));
            after.iter().chain(before).for_each(|c| cut(*c));
        }
    }
}
