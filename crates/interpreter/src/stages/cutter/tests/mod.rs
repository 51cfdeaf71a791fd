//! The manual's cases by hand, and properties against plain geometry.

mod manual;
mod one_ahead;
mod properties;

use super::*;
use ferrocut_geometry::vector;

/// One block for the stage.
#[derive(Clone, Copy, Debug)]
pub enum Op {
    /// G41 with this radius (negative: G42), or G40.
    Set(Option<Offset>),
    To([f64; 2]),
    /// End, centre, sense.
    Ccw([f64; 2], [f64; 2]),
    Cw([f64; 2], [f64; 2]),
    Pass,
    G39,
    Suspend,
    Flush,
}

pub fn g41(radius: f64) -> Op {
    Op::Set(Some(Offset { side: Side::Left, radius }))
}

pub fn g42(radius: f64) -> Op {
    Op::Set(Some(Offset { side: Side::Right, radius }))
}

pub const G40: Op = Op::Set(None);

/// The arc as a program gives it: end in the direction of the start is a full circle.
pub fn arc(from: [f64; 2], to: [f64; 2], center: [f64; 2], sense: f64) -> PlaneMove {
    use std::f64::consts::TAU;
    let a = sense * vector::angle(vector::sub(from, center), vector::sub(to, center));
    let a = if a <= 1e-9 { a + TAU } else { a };
    PlaneMove { from, to, shape: Shape::Arc { center, sweep: sense * a } }
}

/// Runs a program; the payload is the index of the block.
pub fn run(rules: Rules, start: [f64; 2], ops: &[Op]) -> (Vec<Out<usize>>, Option<FaultAt<usize>>) {
    let mut stage = Compensator::new(rules);
    let mut steps = Vec::new();
    let mut at = start;
    let mut fault = None;
    for (i, op) in ops.iter().enumerate() {
        let mut out = |o| steps.push(o);
        let done = match *op {
            Op::Set(o) => {
                stage.set(o);
                Ok(())
            }
            Op::To(to) => {
                let m = PlaneMove { from: at, to, shape: Shape::Line };
                at = to;
                stage.push(m, i, &mut out)
            }
            Op::Ccw(to, center) | Op::Cw(to, center) => {
                let m = arc(at, to, center, if matches!(op, Op::Ccw(..)) { 1.0 } else { -1.0 });
                at = to;
                stage.push(m, i, &mut out)
            }
            Op::Pass => stage.pass(i, true, &mut out),
            Op::G39 => stage.corner_arc(i),
            Op::Suspend => {
                stage.suspend();
                Ok(())
            }
            Op::Flush => stage.flush(&mut out),
        };
        if let Err(f) = done {
            fault = Some(f);
            break;
        }
    }
    if fault.is_none() {
        fault = stage.flush(&mut |o| steps.push(o)).err();
    }
    (steps, fault)
}
