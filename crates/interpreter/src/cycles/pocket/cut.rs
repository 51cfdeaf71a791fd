//! The stages of a planned pocket as acts of a cycle.

use super::pen::PocketFeed;
use super::pocket2d::Plan2d;
use super::pocket3d::Plan3d;
use super::problem::Stage;
use crate::cycles::milling::CycleMove;
use crate::cycles::tool::{Act, Take};
use std::sync::Arc;

/// A pocket of either kind, ready to be cut.
#[derive(Debug)]
pub enum PocketPlan {
    /// Its walls are upright.
    Flat(Plan2d),
    /// Its walls slope.
    Deep(Plan3d),
}

/// One stage of a pocket.
#[derive(Clone, Debug)]
pub struct PocketCut {
    /// The pocket, which its stages share.
    pub plan: Arc<PocketPlan>,
    /// Which stage.
    pub stage: Stage,
    /// Feed along, in the unit of the program's F.
    pub feed: f64,
    /// Feed downwards.
    pub plunge: f64,
}

impl PartialEq for PocketCut {
    fn eq(&self, other: &PocketCut) -> bool {
        Arc::ptr_eq(&self.plan, &other.plan)
            && (self.stage, self.feed, self.plunge) == (other.stage, other.feed, other.plunge)
    }
}

impl PocketCut {
    /// Cuts it, from wherever the tool stands.
    pub fn cut<T: Take>(&self, from: [f64; 3], taker: &mut T) -> Result<(), T::Error> {
        let mut sink = |step: CycleMove, feed: PocketFeed| {
            let feed = match feed {
                PocketFeed::Mill => self.feed,
                PocketFeed::Plunge => self.plunge,
            };
            taker.take(match step {
                CycleMove::Rapid { to } => Act::Rapid { to },
                CycleMove::Feed { to } => Act::Feed { to, feed },
                CycleMove::Arc { to, center, sweep } => Act::Arc { to, center, sweep, feed },
            })
        };
        match (&*self.plan, self.stage) {
            (PocketPlan::Flat(plan), Stage::Rough) => plan.rough(from, &mut sink),
            (PocketPlan::Flat(plan), Stage::Finish) => plan.finish(from, &mut sink),
            (PocketPlan::Flat(_), Stage::Semi) => Ok(()),
            (PocketPlan::Deep(plan), Stage::Rough) => plan.rough(from, &mut sink),
            (PocketPlan::Deep(plan), Stage::Semi) => plan.semi(from, &mut sink),
            (PocketPlan::Deep(plan), Stage::Finish) => plan.finish(from, &mut sink),
        }
    }
}
