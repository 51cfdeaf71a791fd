//! Where the modes of path control come to rest, and where they run on.

use crate::common::{Run, in_language, machine, run};
use ferrocut_controller::{Cnc, State};
use ferrocut_geometry::Position;
use ferrocut_machine::Machine;

fn ended(machine: &Machine, program: &str) -> Run {
    let mut cnc = Cnc::new(machine, in_language("rs274", program));
    let run = run(&mut cnc);
    assert_eq!(cnc.state(), &State::Ended, "{program}");
    run
}

/// Where the axes come to rest between their start and their end. A setpoint is there.
fn rests(run: &Run) -> Vec<Position> {
    let stands = |at: &Position| *at != run.start && *at != run.end();
    let mut rests: Vec<Position> =
        run.ticks.iter().filter(|t| t.velocity == 0.0).map(|t| t.position).filter(stands).collect();
    rests.dedup();
    rests
}

/// A cubic spline, a parabola, and a NURBS, with corners between them.
const CURVES: &str =
    "G5 X20 Y0 I0 J10 P-10 Q-5 F2000\nG5.1 X40 Y0 I5 J10\nG5.2 P1 X40 Y10\nX50 Y10 P1\nX50 Y0 P1\nG5.3\n";

#[test]
fn a_curve_is_run_through_whatever_stops_at_its_end() {
    let program = |mode: &str| format!("G21 G17 S1000 M3\n{mode}\n{CURVES}M2\n");
    let ends = [Position::xyz(20.0, 0.0, 0.0), Position::xyz(40.0, 0.0, 0.0)];
    let free = ended(&machine(), &program("G64 P0.01"));
    assert_eq!(rests(&free), []);
    for mode in ["G61", "G61.1"] {
        let run = ended(&machine(), &program(mode));
        assert_eq!(rests(&run), ends, "{mode}");
        run.check_limits(&machine(), true);
        // Two ends more than without, and the finer joints: less than half a second.
        assert!(run.ticks.len() < free.ticks.len() + 500, "{mode} {} {}", run.ticks.len(), free.ticks.len());
    }
    // A machine that stops at the end of every move does so at the end of the curve.
    let mut stops = machine();
    stops.path.exact_stop = true;
    for mode in ["G61.1", "G64", "G64 P0.01"] {
        assert_eq!(rests(&ended(&stops, &program(mode))), ends, "{mode}");
    }
}

#[test]
fn exact_path_rests_only_where_the_path_cannot_be_run_through() {
    // A line, an arc tangent to it, two lines on, and a corner at (0, 20).
    let program =
        |mode: &str| format!("G21 G17 S1000 M3\n{mode}\nG1 X30 F1500\nG3 X30 Y20 J10\nG1 X15\nX0\nY0\nM2\n");
    let points = |all: &[[f64; 2]]| all.iter().map(|[x, y]| Position::xyz(*x, *y, 0.0)).collect::<Vec<_>>();
    // Where no jerk is limited tangents are run through.
    let mut free = machine();
    free.axes.iter_mut().for_each(|axis| axis.jerk = 0.0);
    let exact = ended(&free, &program("G61"));
    assert_eq!(rests(&exact), points(&[[0.0, 20.0]]));
    exact.check_limits(&free, true);
    // Where it is, not where the curvature jumps; what is straight on is.
    let exact = ended(&machine(), &program("G61"));
    assert_eq!(rests(&exact), points(&[[30.0, 0.0], [30.0, 20.0], [0.0, 20.0]]));
    exact.check_limits(&machine(), true);
    for machine in [free, machine()] {
        let stops = ended(&machine, &program("G61.1"));
        assert_eq!(rests(&stops), points(&[[30.0, 0.0], [30.0, 20.0], [15.0, 20.0], [0.0, 20.0]]));
    }
}
