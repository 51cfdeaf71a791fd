//! Clearing the area of a pocket on one level.

use super::chains::{Chain, Entry, chains};
use super::descent::{Descent, Slope};
use super::pen::{APPROACH, Pen, PocketSink};
use super::problem::PocketFault;
use super::rings::layers;
use super::segment::Segment;
use super::walls::Walls;

/// The paths that clear an area.
#[derive(Clone, PartialEq, Debug)]
pub(crate) struct Clearing {
    pub chains: Vec<Chain>,
    /// Distance of the outermost path from the walls, mm.
    pub nearest: f64,
}

/// A level to be cleared.
#[derive(Clone, Copy, Debug)]
pub(crate) struct Level {
    /// Height of the level, below 0.
    pub bottom: f64,
    /// Height to which everything is open before, and the distance from the walls from which on it is.
    pub open: f64,
    /// Centres at least this far from the walls stand over the open part, mm.
    pub open_from: f64,
    /// Slope of the way down.
    pub slope: Slope,
}

impl Clearing {
    /// The paths of a tool between walls, `stock` off them. `clockwise` is the direction about the area.
    pub fn new(
        walls: &Walls,
        clockwise: bool,
        (radius, stock, width): (f64, f64, f64),
        names: [&'static str; 2],
    ) -> Result<Clearing, PocketFault> {
        let nearest = radius + stock;
        let mut layers = layers(walls, nearest, radius, width, names)?;
        // Across a strip in the middle the next path lies two passes off at most.
        let chains = chains(walls, &mut layers, clockwise, radius, 2.0 * width + 0.01);
        Ok(Clearing { chains, nearest })
    }

    /// Where the tool goes down into full material: where to drill before.
    pub fn entries(&self) -> impl Iterator<Item = [f64; 2]> + '_ {
        let solid = self.chains.iter().filter(|c| matches!(c.entry, Entry::Solid { .. }));
        solid.filter_map(|c| c.path.first().map(Segment::from))
    }

    /// Whether the tool goes down into full material where centres at least `open_from` from the walls stand over what is open.
    pub fn enters_solid(&self, walls: &Walls, open_from: f64) -> bool {
        self.entries().any(|point| !is_over_open(walls, point, open_from))
    }

    /// Moves that a level takes at most.
    pub fn moves(&self, height: f64, slope: Slope) -> f64 {
        let chain = |chain: &Chain| {
            let down = match &chain.entry {
                Entry::Solid { down } => Descent::new(down, height, slope).moves(),
                Entry::Cut => 1.0,
            };
            down + chain.path.len() as f64 + 6.0
        };
        self.chains.iter().map(chain).sum()
    }

    /// Clears a level. `inside` says whether the tool is in the pocket, over its open part, and is true
    /// afterwards.
    pub fn cut<S: PocketSink>(
        &self,
        pen: &mut Pen<'_, S>,
        walls: &Walls,
        level: Level,
        inside: &mut bool,
    ) -> Result<(), S::Error> {
        let approach = pen.planes().approach();
        let over_open = (level.open + APPROACH).min(approach);
        for chain in &self.chains {
            let Some(start) = chain.path.first().map(Segment::from) else { continue };
            match &chain.entry {
                Entry::Solid { down } => {
                    let open = Descent::new(down, over_open - level.bottom, level.slope);
                    let is_open = open.points().all(|p| is_over_open(walls, p, level.open_from));
                    let from = if is_open { over_open } else { approach };
                    let descent =
                        if is_open { open } else { Descent::new(down, from - level.bottom, level.slope) };
                    let clear =
                        is_open && *inside && walls.is_clear(pen.at(), descent.start(), level.open_from);
                    pen.travel(descent.start(), from, clear)?;
                    descent.go(pen, from, level.bottom)?;
                }
                Entry::Cut => {
                    let clear = *inside && walls.is_clear(pen.at(), start, level.open_from);
                    pen.travel(start, over_open, clear)?;
                    pen.rapid_height((level.bottom + APPROACH).min(over_open))?;
                    pen.plunge(level.bottom)?;
                }
            }
            pen.path(&chain.path)?;
            *inside = true;
        }
        Ok(())
    }
}

/// Whether a centre at this point stands over what is open.
fn is_over_open(walls: &Walls, point: [f64; 2], open_from: f64) -> bool {
    walls.distance(point) >= open_from - 1e-3
}
