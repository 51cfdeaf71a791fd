//! Cycles run as a caller runs them, and the geometry that judges them.

mod area;
mod bounds;
mod cases;
mod faults;
mod model;
mod walls;

use super::{CircleFinish, CycleFault, CycleMove, Plan, RectFinish, RectPocket, Roughing, RoundPocket, Side};
use ferrocut_geometry::Turn;
use model::Path;

/// The example of GSK990MC 4.6.1.
pub fn round_example() -> RoundPocket {
    RoundPocket {
        center: [25.0, 25.0],
        r: 5.0,
        bottom: -50.0,
        radius: Some(50.0),
        roughing: roughing_example(),
        tool_radius: Some(5.0),
        turn: Turn::CounterClockwise,
    }
}

/// The example of 4.6.4.
pub fn rect_example() -> RectPocket {
    RectPocket {
        center: [25.0, 25.0],
        r: 5.0,
        bottom: -50.0,
        sizes: [Some(70.0), Some(50.0)],
        roughing: roughing_example(),
        corner: Some(5.0),
        tool_radius: Some(5.0),
        turn: Turn::CounterClockwise,
    }
}

fn roughing_example() -> Roughing {
    Roughing {
        step: Some(10.0),
        first_depth: Some(20.0),
        depth: Some(10.0),
        gap: Some(10.0),
        helix_factor: 1.5,
    }
}

/// The examples of 4.6.2 and 4.6.3.
pub fn circle_finish_example(side: Side) -> CircleFinish {
    CircleFinish {
        side,
        center: [25.0, 25.0],
        r: 5.0,
        bottom: -50.0,
        radius: Some(50.0),
        start: Some(if side == Side::Inside { 10.0 } else { 30.0 }),
        tool_radius: Some(5.0),
        turn: Turn::CounterClockwise,
    }
}

/// The examples of 4.6.5 and 4.6.6.
pub fn rect_finish_example(side: Side) -> RectFinish {
    RectFinish {
        side,
        start: [10.0, 0.0],
        r: 5.0,
        bottom: -50.0,
        sizes: [Some(80.0), Some(50.0)],
        distance: Some(30.0),
        corner: Some(10.0),
        tool_radius: Some(5.0),
        turn: Turn::CounterClockwise,
    }
}

/// All moves of a plan from the rapid over its start, between 50 and the return level.
pub fn cut(plan: Result<Plan, CycleFault>, return_z: f64) -> Path {
    let plan = plan.unwrap();
    let mut path = Path::from([50.0, 50.0, 50.0]);
    let [x, y] = plan.start();
    path.add(CycleMove::Rapid { to: [x, y, 50.0] });
    plan.moves(return_z, &mut |step| -> Result<(), std::convert::Infallible> {
        path.add(step);
        Ok(())
    })
    .unwrap();
    path
}
