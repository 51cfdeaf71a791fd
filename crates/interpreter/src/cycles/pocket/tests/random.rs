//! Profiles at random, simple by construction and then checked.

use super::super::{Profile, Segment};
use std::f64::consts::{PI, TAU};

/// A small generator of its own, so that a failing number can be run again.
pub struct Dice(u64);

impl Dice {
    pub fn new(seed: u64) -> Dice {
        Dice(seed.wrapping_mul(0x9e37_79b9_7f4a_7c15) ^ 0x5851_f42d_4c95_7f2d)
    }

    /// 0…1.
    pub fn unit(&mut self) -> f64 {
        self.0 = self.0.wrapping_add(0x9e37_79b9_7f4a_7c15);
        let mut z = self.0;
        z = (z ^ (z >> 30)).wrapping_mul(0xbf58_476d_1ce4_e5b9);
        z = (z ^ (z >> 27)).wrapping_mul(0x94d0_49bb_1331_11eb);
        ((z ^ (z >> 31)) >> 11) as f64 / (1u64 << 53) as f64
    }

    pub fn between(&mut self, low: f64, high: f64) -> f64 {
        low + self.unit() * (high - low)
    }

    pub fn one_in(&mut self, n: u32) -> bool {
        self.unit() * f64::from(n) < 1.0
    }
}

/// A star about a centre: corners at growing angles, joined by lines and by arcs that bulge in or out. In
/// whole millimetres if asked, as drawings are.
pub fn star(dice: &mut Dice, center: [f64; 2], radius: f64, whole: bool) -> Profile {
    let corners = 3 + (dice.unit() * 9.0) as usize;
    let round = |c: f64| if whole { c.round() } else { c };
    let points: Vec<[f64; 2]> = (0..corners)
        .map(|k| {
            let angle = TAU * (k as f64 + 0.6 * dice.unit()) / corners as f64;
            let r = radius * dice.between(0.35, 1.0);
            [round(center[0] + r * angle.cos()), round(center[1] + r * angle.sin())]
        })
        .collect();
    let mut segments = Vec::new();
    for (k, from) in points.iter().enumerate() {
        let to = points[(k + 1) % corners];
        let curved = dice.one_in(3);
        let sweep = if whole && dice.one_in(2) { PI / 2.0 } else { dice.between(0.1, 2.0) };
        let sweep = if dice.one_in(2) { sweep } else { -sweep };
        segments.push(if curved && to != *from {
            Segment::arc(*from, to, sweep)
        } else {
            Segment::Line { from: *from, to }
        });
    }
    Profile { segments }
}

/// A circle.
pub fn circle(center: [f64; 2], radius: f64) -> Profile {
    Profile { segments: vec![Segment::circle([center[0] + radius, center[1]], center, 1.0)] }
}

/// An axis-parallel rectangle.
pub fn rectangle(low: [f64; 2], high: [f64; 2]) -> Profile {
    polygon(&[low, [high[0], low[1]], high, [low[0], high[1]]])
}

/// Straight lines from point to point and back.
pub fn polygon(points: &[[f64; 2]]) -> Profile {
    let next = points.iter().cycle().skip(1);
    Profile { segments: points.iter().zip(next).map(|(a, b)| Segment::Line { from: *a, to: *b }).collect() }
}

/// An outer profile and islands in it, all legal; the number of the drawing decides everything.
pub fn drawing(number: u64) -> (Profile, Vec<Profile>, Dice) {
    let mut dice = Dice::new(number);
    loop {
        let whole = dice.one_in(2);
        let size = dice.between(6.0, 16.0);
        let outer = match (dice.unit() * 6.0) as u32 {
            0 => rectangle([-size, -(size * 0.7).round()], [size, (size * 0.6).round()]),
            1 => circle([0.0, 0.0], size),
            _ => star(&mut dice, [0.0, 0.0], size, whole),
        };
        let Ok(outer) = outer.checked() else { continue };
        let mut islands: Vec<Profile> = Vec::new();
        let wanted = (dice.unit() * 4.0) as usize;
        for _ in 0..wanted * 4 {
            let at = [dice.between(-size, size), dice.between(-size, size)];
            let radius = dice.between(0.08, 0.3) * size;
            let island = match (dice.unit() * 4.0) as u32 {
                0 => circle(at, radius),
                1 => rectangle(at, [at[0] + radius, at[1] + radius]),
                _ => star(&mut dice, at, radius, whole),
            };
            let Ok(island) = island.checked() else { continue };
            let inside = outer.contains(island.segments[0].from()) && !outer.touches(&island);
            let free = islands.iter().all(|other| {
                !other.touches(&island)
                    && !other.contains(island.segments[0].from())
                    && !island.contains(other.segments[0].from())
            });
            if inside && free && islands.len() < wanted {
                islands.push(island);
            }
        }
        let outer = if dice.one_in(2) { outer } else { outer.reversed() };
        let islands = islands.into_iter().map(|i| if dice.one_in(2) { i } else { i.reversed() }).collect();
        return (outer, islands, dice);
    }
}
