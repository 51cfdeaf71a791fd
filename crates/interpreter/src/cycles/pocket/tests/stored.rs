//! Kept paths: the same moves again, and none from anything else.

use super::super::{Finish3d, Pocket2d, Pocket3d, PocketFeed, Semi3d, Tool, WallDirection};
use super::deep::fagor_b;
use super::flat::{finish_of, pocket, rough_of};
use crate::cycles::milling::CycleMove;
use std::convert::Infallible;

#[test]
fn the_same_moves_again() {
    for number in 0..40 {
        let (pocket, _) = pocket(number);
        let Ok(plan) = pocket.plan() else { continue };
        let again = pocket.load(&plan.save()).unwrap();
        assert_eq!(rough_of(&plan), rough_of(&again));
        assert_eq!(finish_of(&plan), finish_of(&again));
    }
}

/// Any change of a parameter, of the tool or of the profile is another pocket.
#[test]
fn other_inputs_load_nothing() {
    let base = (0..)
        .map(|n| pocket(n).0)
        .find(|p| p.rough.is_some() && p.finish.is_some() && p.plan().is_ok() && !p.islands.is_empty())
        .unwrap();
    let bytes = base.plan().unwrap().save();
    assert!(base.load(&bytes).is_some());
    let changes: [fn(&mut Pocket2d); 16] = [
        |p| p.surface += 1e-9,
        |p| p.safety += 1.0,
        |p| p.depth += 1e-6,
        |p| p.wall_stock += 1e-6,
        |p| p.floor_stock += 1e-6,
        |p| p.rough.as_mut().unwrap().tool.radius += 1e-6,
        |p| p.rough.as_mut().unwrap().tool.cutting_length += 1.0,
        |p| p.rough.as_mut().unwrap().tool.entry_angle += 1.0,
        |p| p.rough.as_mut().unwrap().step += 0.01,
        |p| p.rough.as_mut().unwrap().depth_step *= -1.0,
        |p| p.finish.as_mut().unwrap().tool.tip_radius += 0.1,
        |p| p.finish.as_mut().unwrap().passes += 1.0,
        |p| p.finish.as_mut().unwrap().entry_angle += 1.0,
        |p| p.finish = None,
        |p| p.outer = p.outer.reversed(),
        |p| {
            p.islands.pop();
        },
    ];
    for (n, change) in changes.iter().enumerate() {
        let mut other = base.clone();
        change(&mut other);
        assert!(other.load(&bytes).is_none(), "change {n}");
    }
}

#[test]
fn changed_bytes_load_nothing() {
    let base = (0..).map(|n| pocket(n).0).find(|p| p.plan().is_ok()).unwrap();
    let bytes = base.plan().unwrap().save();
    for n in 0..bytes.len().min(4000) {
        let mut other = bytes.clone();
        other[n] ^= 1 << (n % 8);
        assert!(base.load(&other).is_none(), "byte {n}");
    }
    for n in (0..bytes.len()).step_by(97) {
        assert!(base.load(&bytes[..n]).is_none(), "{n} bytes");
    }
    assert!(base.load(&[]).is_none());
}

#[test]
fn deep_pockets_too() {
    let tool = Tool { radius: 3.0, tip_radius: 1.0, cutting_length: 30.0, entry_angle: 0.0 };
    let pocket = Pocket3d {
        semi: Some(Semi3d { tool, depth_step: 3.0 }),
        finish: Some(Finish3d { tool, width: 4.0, direction: WallDirection::Zigzag }),
        ..fagor_b()
    };
    let plan = pocket.plan().unwrap();
    let again = pocket.load(&plan.save()).unwrap();
    let all = |plan: &super::super::Plan3d| {
        let mut moves = Vec::new();
        let mut sink = |step: CycleMove, feed: PocketFeed| -> Result<(), Infallible> {
            moves.push((step, feed));
            Ok(())
        };
        let Ok(()) = plan.rough([0.0; 3], &mut sink);
        let Ok(()) = plan.semi([0.0; 3], &mut sink);
        let Ok(()) = plan.finish([0.0; 3], &mut sink);
        moves
    };
    assert_eq!(all(&plan), all(&again));
    assert!(all(&plan).len() > 1000);
    let mut other = pocket.clone();
    other.depth_profiles[1] = None;
    assert!(other.load(&plan.save()).is_none());
}
