//! The contours of a pocket: one outer profile and the islands in it.

use super::problem::{PocketFault, Problem};
use super::profile::Profile;
use super::segment::Segment;

/// Contours that are legal, and exact.
#[derive(Clone, PartialEq, Debug)]
pub(crate) struct Contours {
    pub outer: Profile,
    pub islands: Vec<Profile>,
}

impl Contours {
    /// All contours closed and simple, every island inside the outer profile and outside the others, none
    /// touching another (Fagor 4.15, 4.16).
    pub fn checked(outer: &Profile, islands: &[Profile]) -> Result<Contours, PocketFault> {
        let exact = |(n, p): (usize, &Profile)| p.checked().map_err(|problem| problem.of_contour(n));
        let outer = exact((0, outer))?;
        let islands: Vec<Profile> =
            islands.iter().enumerate().map(|(n, p)| exact((n + 1, p))).collect::<Result<_, _>>()?;
        let start = |p: &Profile| p.segments.first().map_or([f64::NAN; 2], Segment::from);
        for (n, island) in islands.iter().enumerate() {
            if outer.touches(island) {
                return Err(Problem::IslandCrosses.of_contour(n + 1));
            }
            if !outer.contains(start(island)) {
                return Err(Problem::IslandOutside.of_contour(n + 1));
            }
        }
        for (n, island) in islands.iter().enumerate() {
            let own = island.bounds();
            for other in islands.iter().take(n) {
                let apart = (0..2).any(|k| {
                    let b = other.bounds();
                    own.high[k] < b.low[k] - 1.0 || b.high[k] < own.low[k] - 1.0
                });
                if !apart
                    && (island.touches(other)
                        || island.contains(start(other))
                        || other.contains(start(island)))
                {
                    return Err(Problem::IslandCrosses.of_contour(n + 1));
                }
            }
        }
        Ok(Contours { outer, islands })
    }
}
