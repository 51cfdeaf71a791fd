//! Computing profile pockets: the plan, and its moves on ten levels.

#![allow(clippy::unwrap_used)]

use divan::counter::ItemsCount;
use ferrocut_interpreter::cycles::milling::CycleMove;
use ferrocut_interpreter::cycles::pocket::{
    Finish2d, Plan2d, Pocket2d, PocketFeed, Profile, Rough2d, Segment, Tool,
};
use std::convert::Infallible;
use std::f64::consts::TAU;

fn main() {
    divan::main();
}

/// A closed wave about a centre, of lines and arcs in turn.
fn wave(center: [f64; 2], radius: f64, depth: f64, waves: u32, elements: u32) -> Profile {
    let at = |k: u32| {
        let angle = TAU * f64::from(k) / f64::from(elements);
        let r = radius + depth * (f64::from(waves) * angle).sin();
        [center[0] + r * angle.cos(), center[1] + r * angle.sin()]
    };
    let segment = |k: u32| {
        let (from, to) = (at(k), at(k + 1));
        if k.is_multiple_of(2) { Segment::Line { from, to } } else { Segment::arc(from, to, 0.05) }
    };
    let mut profile = Profile { segments: (0..elements).map(segment).collect() };
    // Once round, rounding must not leave a gap.
    let start = profile.segments.first().unwrap().from();
    if let Some(Segment::Line { to, .. } | Segment::Arc { to, .. }) = profile.segments.last_mut() {
        *to = start;
    }
    profile
}

/// 50 islands of 20 elements in an outer profile of 1000: 2000 elements.
fn large() -> Pocket2d {
    let islands = (0..50).map(|n| {
        let at = [f64::from(n % 10) * 36.0 - 162.0, f64::from(n / 10) * 36.0 - 72.0];
        wave(at, 8.0, 1.5, 4, 20)
    });
    let tool = Tool { radius: 4.0, cutting_length: 30.0, ..Tool::default() };
    Pocket2d {
        outer: wave([0.0, 0.0], 215.0, 4.0, 24, 1000),
        islands: islands.collect(),
        surface: 0.0,
        safety: 5.0,
        depth: 20.0,
        wall_stock: 0.3,
        floor_stock: 0.2,
        rough: Some(Rough2d { tool, step: 0.0, depth_step: 2.0, entry_angle: 3.0 }),
        finish: Some(Finish2d { tool, step: 0.0, passes: 2.0, entry_angle: 3.0 }),
    }
}

fn small() -> Pocket2d {
    let islands = vec![wave([-20.0, 0.0], 6.0, 1.0, 4, 20), wave([20.0, 5.0], 6.0, 1.0, 4, 20)];
    Pocket2d { outer: wave([0.0, 0.0], 50.0, 3.0, 8, 60), islands, ..large() }
}

fn moves(plan: &Plan2d) -> usize {
    let mut count = 0;
    let mut sink = |_: CycleMove, _: PocketFeed| -> Result<(), Infallible> {
        count += 1;
        Ok(())
    };
    let Ok(()) = plan.rough([0.0, 0.0, 50.0], &mut sink);
    let Ok(()) = plan.finish([0.0, 0.0, 50.0], &mut sink);
    count
}

#[divan::bench(sample_count = 5)]
fn fifty_islands_two_thousand_elements(bencher: divan::Bencher) {
    let pocket = large();
    let elements =
        pocket.outer.segments.len() + pocket.islands.iter().map(|i| i.segments.len()).sum::<usize>();
    assert_eq!(elements, 2000);
    bencher.counter(ItemsCount::new(elements)).bench(|| moves(&pocket.plan().unwrap()));
}

#[divan::bench(sample_count = 20)]
fn two_islands_a_hundred_elements(bencher: divan::Bencher) {
    let pocket = small();
    bencher.bench(|| moves(&pocket.plan().unwrap()));
}

#[divan::bench(sample_count = 20)]
fn loading_fifty_islands(bencher: divan::Bencher) {
    let pocket = large();
    let bytes = pocket.plan().unwrap().save();
    bencher.bench(|| pocket.load(&bytes).unwrap().drill_points().len());
}
