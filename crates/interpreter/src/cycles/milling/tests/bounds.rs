//! Any words at all: a plan or a fault, never a panic, never without end.

use super::super::fault::MAX_MOVES;
use super::super::{
    CircleFinish, CycleFault, CycleMove, Plan, RectFinish, RectPocket, Roughing, RoundPocket, Side,
};
use ferrocut_geometry::Turn;
use proptest::prelude::*;

/// Plausible values, round ones, and any bit pattern.
fn value() -> impl Strategy<Value = f64> {
    prop_oneof![
        4 => -60.0..60.0f64,
        2 => (-30i32..30).prop_map(f64::from),
        1 => (-9.0..9.0f64).prop_map(|e| 10f64.powf(e)),
        1 => any::<f64>(),
    ]
}

/// Mostly what a word must be: present and above 0.
fn word() -> impl Strategy<Value = Option<f64>> {
    prop_oneof![
        6 => (0.0..40.0f64).prop_map(Some),
        2 => (-9.0..9.0f64).prop_map(|e| Some(10f64.powf(e))),
        1 => value().prop_map(Some),
        1 => Just(None),
    ]
}

fn bounded(plan: Result<Plan, CycleFault>) -> Result<(), TestCaseError> {
    let Ok(plan) = plan else { return Ok(()) };
    let mut count = 0.0;
    let mut finite = plan.start().iter().all(|c| c.is_finite());
    plan.moves(100.0, &mut |step| -> Result<(), std::convert::Infallible> {
        count += 1.0;
        finite &= match step {
            CycleMove::Rapid { to } | CycleMove::Feed { to } => to.iter().all(|c| c.is_finite()),
            CycleMove::Arc { to, center, sweep } => {
                to.iter().chain(&center).all(|c| c.is_finite()) && sweep.is_finite()
            }
        };
        Ok(())
    })
    .unwrap();
    prop_assert!(finite && count <= MAX_MOVES, "{count} moves of {plan:?}");
    Ok(())
}

proptest! {
    #![proptest_config(ProptestConfig { cases: 3000, ..ProptestConfig::default() })]

    #[test]
    fn any_words(
        xy in prop::array::uniform2(value()),
        rz in prop::array::uniform2(value()),
        ij in prop::array::uniform2(word()),
        lwqv in prop::array::uniform4(word()),
        ud in prop::array::uniform2(word()),
        helix_factor in prop_oneof![4 => 0.01..3.0, 1 => value()],
        clockwise in any::<bool>(),
        outside in any::<bool>(),
    ) {
        let turn = if clockwise { Turn::Clockwise } else { Turn::CounterClockwise };
        let side = if outside { Side::Outside } else { Side::Inside };
        let [r, bottom] = rz;
        let [step, first_depth, depth, gap] = lwqv;
        let [corner, tool_radius] = ud;
        let roughing = Roughing { step, first_depth, depth, gap, helix_factor };
        bounded(RoundPocket { center: xy, r, bottom, radius: ij[0], roughing, tool_radius, turn }.plan())?;
        bounded(RectPocket { center: xy, r, bottom, sizes: ij, roughing, corner, tool_radius, turn }.plan())?;
        let (radius, start) = (ij[0], ij[1]);
        bounded(CircleFinish { side, center: xy, r, bottom, radius, start, tool_radius, turn }.plan())?;
        let words = RectFinish { side, start: xy, r, bottom, sizes: ij, distance: step, corner, tool_radius, turn };
        bounded(words.plan())?;
    }
}

/// An error of the taker ends the cycle at once.
#[test]
fn stops_when_refused() {
    let mut count = 0;
    let result = super::round_example().plan().unwrap().moves(5.0, &mut |_| {
        count += 1;
        if count == 7 { Err("limit") } else { Ok(()) }
    });
    assert_eq!((result, count), (Err("limit"), 7));
}
