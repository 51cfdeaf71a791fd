//! Profile pockets of the Fagor editor (4.15, 4.16) as whole programs, with values worked out by hand from its
//! manual, and what parameters its cycles do not take.
#![allow(missing_docs, clippy::unwrap_used, clippy::panic)]

mod common;

use common::{lines_on, run_on, told_on};
use ferrocut_geometry::Position;
use ferrocut_interpreter::dialects::fagor8065::DIALECT;
use ferrocut_machine::{Argument, Catalogue, Fault, Language, Severity};
use ferrocut_toolpath::{Feed, Op, Step};

/// T1 of radius 5, T2 of radius 4, T3 a drill of 5, T4 a ball of 3, T5 without a cutting length, T6 that may
/// enter at 3 degrees.
const TOOLS: &str = "[start]\nz = 50.0\n[tools.1]\nradius = 5\ncutting_length = 30\n[tools.2]\nradius = 4\n\
    cutting_length = 30\n[tools.3]\nradius = 2.5\ncutting_length = 40\n[tools.4]\nradius = 3\ntip_radius = 3\n\
    cutting_length = 30\n[tools.5]\nradius = 2.5\n[tools.6]\nradius = 5\ncutting_length = 30\nentry_angle = 3\n";

/// 100 by 60, counter-clockwise from the lower left.
const RECTANGLE: &str = "#PROFILE R [XY]\nG0 X0 Y0\nG1 X100\nY60\nX0\nY0\n#ENDPROFILE\n";

/// The same with a round island of 10 about the middle.
const ISLAND: &str =
    "#PROFILE R [XY]\nG0 X0 Y0\nG1 X100\nY60\nX0\nY0\nG0 X40 Y30\nG2 X40 Y30 I10 J0\n#ENDPROFILE\n";

const MAIN: &str = "#CYCLE P2D [pocket=A, profile=R, Z=0, ZS=5, P=10]\n";
const ROUGH: &str = "#ROUGH [T=1, D=1, S=1000, F=600, FZ=100, I=5, step=6]\n";

fn steps(program: &str) -> Vec<Step> {
    let (steps, alarm) = run_on(&DIALECT, &format!("{program}M30\n"), TOOLS);
    assert_eq!(alarm, None, "{program}");
    steps
}

/// Cuts with where they begin, and the feed.
fn cuts(steps: &[Step]) -> Vec<(Position, Position, f64)> {
    let mut at = Position::xyz(0.0, 0.0, 50.0);
    let mut cuts = Vec::new();
    for step in steps {
        let Some(to) = step.op.target().copied() else { continue };
        if let Op::Feed { feed: Feed::PerMinute(f), .. } | Op::Arc { feed: Feed::PerMinute(f), .. } = step.op
        {
            cuts.push((at, to, f));
        }
        at = to;
    }
    cuts
}

/// Levels on which something is cut, in order of first appearance.
fn levels(steps: &[Step]) -> Vec<f64> {
    let mut levels: Vec<f64> = Vec::new();
    for (from, to, _) in cuts(steps) {
        let z = (to.0[2] * 1e4).round() / 1e4;
        if (from.0[2] - to.0[2]).abs() < 1e-9 && !levels.contains(&z) {
            levels.push(z);
        }
    }
    levels
}

/// Extremes of ends of cuts in the plane; arcs here end at their quarters.
fn extents(steps: &[Step]) -> [f64; 4] {
    let all = cuts(steps);
    let axis = |k: usize| all.iter().map(move |(_, to, _)| to.0[k]);
    let (low, high) =
        (|k| axis(k).fold(f64::INFINITY, f64::min), |k| axis(k).fold(f64::NEG_INFINITY, f64::max));
    [low(0), low(1), high(0), high(1)].map(|c| (c * 1e4).round() / 1e4)
}

#[test]
fn a_pocket_is_roughed_level_by_level() {
    let steps = steps(&format!("{RECTANGLE}{MAIN}{ROUGH}#FINISH [delta=0.5, deltaz=0.2]\n"));
    // P − δz in two equal levels; δ off the wall although finishing is T0.
    assert_eq!(levels(&steps), [-4.9, -9.8]);
    assert_eq!(extents(&steps), [5.5, 5.5, 94.5, 54.5]);
    let ops = common::short(&steps, Position::xyz(0.0, 0.0, 50.0));
    assert_eq!(ops[..3], ["select 1", "change 1", "spindle cw 1000"]);
    // From above first in the plane, then to Zs and to the approach plane (4.15.2).
    assert!(ops[3].starts_with("rapid X") && ops[4] == "rapid Z5" && ops[5] == "rapid Z1", "{ops:?}");
    assert_eq!(ops[6], "feed Z-4.9 F100");
    // 1 mm above each level, and at the end to Zs.
    assert!(ops.contains(&"rapid Z-3.9".to_owned()) && ops.contains(&"rapid Z-8.8".to_owned()));
    assert_eq!(ops[ops.len() - 3..], ["rapid Z5", "spindle off", "end M30"]);
}

/// 4.1.3: FZ 0 is half of each stage's own F; I 0 the cutting length; step 0 three quarters of the diameter.
#[test]
fn zero_stands_for_something() {
    let steps = steps(&format!(
        "{RECTANGLE}#CYCLE P2D [pocket=A, profile=R, ZS=5, P=40]\n#ROUGH [T=1, F=600, S=1000]\n\
         #FINISH [T=2, F=300, S=1500, delta=0.5, deltaz=0.5, N=0]\n"
    ));
    // 39.5 of at most 30 are two levels; the walls two as well, of 40.
    assert_eq!(levels(&steps), [-19.75, -39.5, -40.0, -20.0]);
    let down = |feed: f64| {
        cuts(&steps).iter().any(|(from, to, f)| to.0[2] < from.0[2] - 0.5 && (f - feed).abs() < 1e-9)
    };
    assert!(down(300.0) && down(150.0) && !down(600.0));
    // Passes 7.5 wide at most over 30 − 5.5 are four of 6.125.
    let rings = cuts(&steps)
        .iter()
        .filter(|(a, b, f)| *f == 600.0 && (a.0[0] - b.0[0]).abs() < 1e-9)
        .map(|(a, ..)| a.0[0])
        .fold(Vec::new(), |mut rings: Vec<f64>, x| {
            if x < 50.0 && rings.iter().all(|r| (r - x).abs() > 1e-6) {
                rings.push(x);
            }
            rings
        });
    let mut rings = rings;
    rings.sort_by(f64::total_cmp);
    assert!((rings[0] - 5.5).abs() < 1e-6 && (rings[1] - 11.625).abs() < 1e-3, "{rings:?}");
}

/// β is kept all the way down, limited by the tool table, which also stands for 0 (4.1.3, 4.15).
#[test]
fn the_way_down_keeps_the_angle() {
    for (tool, beta, angle) in [(1, 5.0, 5.0_f64), (6, 0.0, 3.0), (6, 10.0, 3.0)] {
        let steps =
            steps(&format!("{RECTANGLE}{MAIN}#ROUGH [T={tool}, S=1000, F=600, FZ=100, I=5, beta={beta}]\n"));
        let (mut at, mut steepest) = (Position::ZERO, 0.0_f64);
        for step in &steps {
            let Some(to) = step.op.target().copied() else { continue };
            let along = match step.op {
                Op::Feed { .. } => Some((to.0[0] - at.0[0]).hypot(to.0[1] - at.0[1])),
                Op::Arc { center, sweep, .. } => {
                    Some((to.0[0] - center[0]).hypot(to.0[1] - center[1]) * sweep.abs())
                }
                _ => None,
            };
            if let Some(along) = along.filter(|_| at.0[2] - to.0[2] > 1e-6) {
                steepest = steepest.max((at.0[2] - to.0[2]).atan2(along).to_degrees());
                assert!(matches!(step.op, Op::Feed { feed: Feed::PerMinute(f), .. }
                    | Op::Arc { feed: Feed::PerMinute(f), .. } if f == 100.0));
            }
            at = to;
        }
        assert!((steepest - angle).abs() < 1e-3, "{steepest} for {angle}");
    }
}

/// Below Zs the part lies above, and the pocket is cut towards plus (4.1.2).
#[test]
fn the_planes_say_which_way() {
    let cycle = |planes: &str| format!("{RECTANGLE}#CYCLE P2D [pocket=A, profile=R, {planes}]\n{ROUGH}");
    assert_eq!(levels(&steps(&cycle("Z=0, ZS=-5, P=10"))), [5.0, 10.0]);
    assert_eq!(levels(&steps(&cycle("Z=2, ZS=2, P=-10"))), [7.0, 12.0]);
    assert_eq!(levels(&steps(&cycle("Z=2, ZS=2, P=10"))), [-3.0, -8.0]);
}

/// The outer contour is cut as it was defined, the island the other way, whichever way that was (4.15.2).
#[test]
fn directions_are_those_of_the_outer_contour() {
    let reversed = ISLAND.replace("G1 X100\nY60\nX0\nY0\n", "G1 Y60\nX100\nY0\nX0\n");
    for (profile, sense) in [(ISLAND, -1.0), (reversed.as_str(), 1.0)] {
        for island in ["G2", "G3"] {
            let steps = steps(&format!("{}{MAIN}{ROUGH}", profile.replace("G2", island)));
            let about = |s: &&Step| matches!(s.op, Op::Arc { center, .. } if (center[0] - 50.0).abs() < 1e-6);
            let sweeps: Vec<f64> = steps
                .iter()
                .filter(about)
                .filter_map(|s| if let Op::Arc { sweep, .. } = s.op { Some(sweep) } else { None })
                .collect();
            assert!(!sweeps.is_empty() && sweeps.iter().all(|s| s.signum() == sense), "{sweeps:?}");
        }
    }
}

/// Corners are rounded and chamfered, that between the last element and the first too.
#[test]
fn corners_of_a_contour() {
    let round =
        "#PROFILE R [XY]\nG0 X0 Y0\nG1 X100\nG36 I12\nY60\nG36 I12\nX0\nG36 I12\nY0\nG36 I12\n#ENDPROFILE\n";
    let wall = "#FINISH [T=1, F=300, S=1000, N=1]\n";
    let steps = steps(&format!("{round}{MAIN}{ROUGH}{wall}"));
    // 12 − 5 is left of the radius at the wall, in each corner once on the floor and once at the wall.
    let centers = [[88.0, 12.0], [88.0, 48.0], [12.0, 48.0], [12.0, 12.0]];
    for [x, y] in centers {
        let is_corner = |s: &&Step| match s.op {
            Op::Arc { center, sweep, to, feed: Feed::PerMinute(f), .. } => {
                let radius = (to.0[0] - center[0]).hypot(to.0[1] - center[1]);
                f == 300.0
                    && (center[0] - x).abs() < 1e-4
                    && (center[1] - y).abs() < 1e-4
                    && (radius - 7.0).abs() < 1e-4
                    && (sweep.to_degrees() - 90.0).abs() < 1e-3
            }
            _ => false,
        };
        assert_eq!(steps.iter().filter(is_corner).count(), 2, "about {x} {y}");
    }
}

/// In inches, in another plane, and along another axis.
#[test]
fn units_and_planes() {
    let inch = "G70\n#PROFILE R [XY]\nG0 X0 Y0\nG1 X4\nY2\nX0\nY0\n#ENDPROFILE\n\
        #CYCLE P2D [profile=R, Z=0, ZS=0.2, P=0.4]\n#ROUGH [T=1, S=1000, F=20, I=0.2]\n";
    let found = steps(inch);
    assert_eq!(levels(&found), [-5.08, -10.16]);
    assert_eq!(extents(&found), [5.0, 5.0, 96.6, 45.8]);
    // G18: abscissa Z, ordinate X, longitudinal axis Y.
    let (steps, alarm) = run_on(
        &DIALECT,
        &format!("G18\n{RECTANGLE}{MAIN}{ROUGH}M30\n"),
        "[start]\ny = 50\n[tools.1]\nradius = 5\n",
    );
    assert_eq!(alarm, None);
    let far =
        |axis: usize| steps.iter().filter_map(|s| s.op.target()).map(|to| to.0[axis]).fold(0.0, f64::max);
    let deep = steps.iter().filter_map(|s| s.op.target()).map(|to| to.0[1]).fold(0.0, f64::min);
    assert_eq!((far(2).round(), far(0).round(), deep), (95.0, 55.0, -10.0));
}

/// Before the pocket holes are drilled where the tool goes down (4.15): two lobes and a neck too narrow.
#[test]
fn drilled_where_the_tool_goes_down() {
    let lobes = "#PROFILE R [XY]\nG0 X0 Y0\nG1 X30\nY12\nX40\nY0\nX70\nY30\nX40\nY18\nX30\nY30\nX0\nY0\n#ENDPROFILE\n";
    let drill = "#DRILL [T=3, S=2000, F=150, I=10, M1=8]\n";
    let finish = "#FINISH [deltaz=0.5]\n";
    let steps = steps(&format!("{lobes}{MAIN}{drill}{ROUGH}{finish}"));
    let change = steps.iter().position(|s| s.op == Op::Change(1)).unwrap();
    let (holes, mill) = steps.split_at(change);
    assert!(holes.iter().any(|s| s.op == Op::Change(3)));
    assert_eq!(holes.iter().filter(|s| matches!(s.op, Op::Coolant(true))).count(), 1);
    // To the floor that roughing leaves.
    let bottoms: Vec<[f64; 2]> = cuts(holes)
        .iter()
        .filter(|(_, to, f)| *f == 150.0 && (to.0[2] + 9.5).abs() < 1e-9)
        .map(|(_, to, _)| [to.0[0], to.0[1]])
        .collect();
    assert_eq!(bottoms.len(), 2, "{bottoms:?}");
    let plunges = cuts(mill);
    let plunges = plunges.iter().filter(|(from, to, f)| *f == 100.0 && to.0[2] < from.0[2]);
    for (_, to, _) in plunges {
        assert!(bottoms.iter().any(|[x, y]| (x - to.0[0]).abs() < 1e-9 && (y - to.0[1]).abs() < 1e-9));
    }
    // Without roughing nothing but the floor is left to drill for, and T0 drills nothing.
    let none = common::short(&self::steps(&format!("{lobes}{MAIN}#DRILL [I=10]\n{ROUGH}")), Position::ZERO);
    assert!(!none.contains(&"change 3".to_owned()));
}

const DEEP: &str = "#PROFILE D [XZ]\nG0 X0 Z0\nG1 X5 Z-10\n#ENDPROFILE\n";
const MAIN_3D: &str = "#CYCLE P3D [pocket=B, profile=R, Z1=D, Z=0, ZS=5, P=10]\n";

/// The wall stands 2.5 further in at −5 and 5 at −10, and a flat tool keeps off it there (4.16).
#[test]
fn a_sloping_wall() {
    let rough = "#ROUGH [T=1, S=1000, F=600, FZ=100, I1=5, step=6]\n";
    let semi = "#SEMI [T=1, S=1000, F=400, I2=2.5]\n";
    let finish = "#FINISH [T=4, S=2000, F=300, delta=0.2, eps=2, wall=zigzag]\n";
    // The axes may stand without brackets.
    let bare =
        self::steps(&format!("{RECTANGLE}{}{MAIN_3D}{rough}{semi}{finish}", DEEP.replace("[XZ]", "xz")));
    let steps = steps(&format!("{RECTANGLE}{DEEP}{MAIN_3D}{rough}{semi}{finish}"));
    assert!(bare.iter().map(|step| &step.op).eq(steps.iter().map(|step| &step.op)));
    let of = |feed: f64| -> Vec<_> { cuts(&steps).into_iter().filter(|c| c.2 == feed).collect() };
    let low = |feed: f64, z: f64| {
        of(feed)
            .iter()
            .filter(|c| (c.1.0[2] - z).abs() < 1e-6)
            .map(|c| c.1.0[0])
            .fold(f64::INFINITY, f64::min)
    };
    // 2.5 + 5 + 0.2 and 5 + 5 + 0.2.
    assert!((low(600.0, -5.0) - 7.7).abs() < 1e-3 && (low(600.0, -10.0) - 10.2).abs() < 1e-3);
    // Semi-finishing leaves out what roughing has cut: −5 and −10.
    assert!((low(400.0, -2.5) - 6.45).abs() < 1e-3 && (low(400.0, -7.5) - 8.95).abs() < 1e-3);
    let semi_levels: Vec<f64> = of(400.0).iter().map(|c| c.1.0[2]).collect();
    assert!(
        semi_levels.iter().all(|z| (z + 2.5).abs() < 1e-6 || (z + 7.5).abs() < 1e-6 || *z > -1.5),
        "{semi_levels:?}"
    );
    // The ball touches the wall: 1 in 2, of radius 3, with its middle 3 above the tip.
    for (_, to, _) in of(300.0) {
        let [x, y, z] = [to.0[0], to.0[1], to.0[2]];
        let wall = x.min(100.0 - x).min(y).min(60.0 - y);
        if z < -1.0 && wall < 12.0 {
            // Distance of the ball's middle from the plane of the wall.
            let off = (wall - (-(z + 3.0)).max(0.0) / 2.0) / 1.25_f64.sqrt();
            assert!(off > 3.0 - 2e-3 || z + 3.0 > 0.0, "{off} at {x} {y} {z}");
        }
    }
    let changes: Vec<&Op> = steps.iter().map(|s| &s.op).filter(|op| matches!(op, Op::Change(_))).collect();
    assert_eq!(changes, [&Op::Change(1), &Op::Change(4)]);
    assert_eq!(
        common::short(&steps, Position::ZERO).iter().rev().nth(2).map(String::as_str),
        Some("rapid Z5")
    );
}

/// A pocket of more moves than are made at a time goes on where it stopped.
#[test]
fn a_pocket_of_many_moves() {
    let teeth: String = (0..400).map(|k| format!("X{k} Y{}\n", 200 + 2 * (k % 2))).collect();
    let profile = format!("#PROFILE R [XY]\nG0 X0 Y0\nG1 Y200\n{teeth}X399 Y0\nX0 Y0\n#ENDPROFILE\n");
    let cycle = "#CYCLE P2D [profile=R, ZS=5, P=20]\n#ROUGH [T=4, S=1000, F=600, I=0.5, step=1]\n";
    let steps = steps(&format!("{profile}{cycle}"));
    assert!(steps.len() > 60_000, "{}", steps.len());
    let downs: Vec<f64> = levels(&steps);
    assert_eq!(downs.len(), 40);
    assert_eq!(steps.iter().filter(|s| matches!(s.op, Op::Change(_))).count(), 1);
}

/// Fault, the parameter that it names, the contour of a profile, and the program.
type Wrong = (Fault, &'static str, Option<f64>, String);

fn wrong_pockets() -> Vec<Wrong> {
    let rectangle = RECTANGLE;
    let flat = |rough: &str, finish: &str| {
        format!("{rectangle}{MAIN}#ROUGH [S=1000, {rough}]\n#FINISH [{finish}]\n")
    };
    let whole = "T=1, F=600, I=5";
    let profile = |elements: &str| format!("#PROFILE R [XY]\n{elements}\n#ENDPROFILE\n{MAIN}{ROUGH}");
    let outer = "G0 X0 Y0\nG1 X100\nY60\nX0\nY0\n";
    let deep = |depth: &str, main: &str| format!("{rectangle}{depth}{main}#ROUGH [T=1, S=1, F=600, I1=5]\n");
    vec![
        (Fault::CycleToolTooLarge, "#ROUGH T", None, profile("G0 X0 Y0\nG1 X100\nY8\nX0\nY0")),
        (
            Fault::CycleToolTooLarge,
            "#FINISH T",
            None,
            format!(
                "{}{MAIN}#FINISH [T=1, F=9]\n",
                profile("G0 X0 Y0\nG1 X100\nY8\nX0\nY0").replace(MAIN, "").replace(ROUGH, "")
            ),
        ),
        (Fault::CycleStepTooWide, "#ROUGH step", None, flat("T=1, F=600, I=5, step=10.1", "T=0")),
        (Fault::CycleStepTooWide, "#FINISH step", None, flat(whole, "T=2, F=300, step=8.1")),
        (Fault::CycleEntryAngle, "#ROUGH beta", None, flat("T=1, F=600, I=5, beta=91", "T=0")),
        (Fault::CycleEntryAngle, "#ROUGH beta", None, flat("T=1, F=600, I=5, beta=-1", "T=0")),
        (Fault::CycleEntryAngle, "#FINISH theta", None, flat(whole, "T=2, F=300, theta=91")),
        (Fault::CycleNoCuttingLength, "#ROUGH I", None, flat("T=5, F=600", "T=0")),
        (Fault::CycleParameter, "#FINISH N", None, flat(whole, "T=2, F=300, N=1.5")),
        (Fault::CycleParameter, "#FINISH N", None, flat(whole, "T=2, F=300, N=-1")),
        (Fault::CycleParameter, "#FINISH delta", None, flat(whole, "delta=-0.1")),
        (Fault::CycleParameter, "#FINISH deltaz", None, flat(whole, "deltaz=10")),
        (Fault::CycleNoFeed, "#ROUGH F", None, flat("T=1, I=5", "T=0")),
        (Fault::CycleNoFeed, "#FINISH F", None, flat(whole, "T=2")),
        (Fault::MillToolMissing, "#ROUGH T", None, flat("T=9, F=600, I=5", "T=0")),
        (Fault::MillTooManyMoves, "#ROUGH step", None, flat("T=1, F=600, I=5, step=0.001", "T=0")),
        (Fault::MillTooManyMoves, "#ROUGH I", None, flat("T=1, F=600, I=0.0001", "T=0")),
        (Fault::CycleNoDepth, "P", None, format!("{rectangle}{}{ROUGH}", MAIN.replace("P=10", "P=0"))),
        (
            Fault::CycleToolTooLarge,
            "#DRILL T",
            None,
            format!("{rectangle}{MAIN}#DRILL [T=1, F=9, I=5]\n{}", ROUGH.replace("T=1", "T=2")),
        ),
        // Its diameter against the radius of the mill, 5.
        (
            Fault::CycleToolTooLarge,
            "#DRILL T",
            None,
            format!("{rectangle}{MAIN}#DRILL [T=2, F=9, I=5]\n{ROUGH}"),
        ),
        (
            Fault::CycleNoCuttingLength,
            "#DRILL I",
            None,
            format!("{rectangle}{MAIN}#DRILL [T=5, F=9]\n{ROUGH}"),
        ),
        (Fault::CycleNoFeed, "#DRILL F", None, format!("{rectangle}{MAIN}#DRILL [T=3, I=5]\n{ROUGH}")),
        (Fault::CycleParameterMissing, "profile", None, format!("#CYCLE P2D [ZS=5, P=10]\n{ROUGH}")),
        (Fault::ProfileMissing, "profile", None, format!("{MAIN}{ROUGH}")),
        (
            Fault::ProfileForm,
            "profile",
            None,
            format!("#PROFILE R [XZ]\nG0 X0 Z0\nG1 X5\n#ENDPROFILE\n{MAIN}{ROUGH}"),
        ),
        (Fault::ProfileOpen, "profile", Some(1.0), profile("G0 X0 Y0\nG1 X100\nY60\nX0")),
        (Fault::ProfileOpen, "profile", Some(2.0), profile(&format!("{outer}G0 X40 Y30\nG1 X50\nY40"))),
        (
            Fault::ProfileCrosses,
            "profile",
            Some(1.0),
            profile("G0 X0 Y0\nG1 X100 Y60\nX100 Y0\nX0 Y50\nX0 Y0"),
        ),
        (
            Fault::ProfileCrosses,
            "profile",
            Some(2.0),
            profile(&format!("{outer}G0 X90 Y20\nG1 X110\nY40\nX90\nY20")),
        ),
        (
            Fault::ProfileCrosses,
            "profile",
            Some(3.0),
            profile(&format!("{outer}G0 X40 Y30\nG2 X40 Y30 I10\nG0 X50 Y30\nG2 X50 Y30 I10")),
        ),
        (Fault::ProfileEmpty, "profile", Some(1.0), profile("G0 X0 Y0\nG1 X100\nX0")),
        (
            Fault::IslandOutside,
            "profile",
            Some(2.0),
            profile(&format!("{outer}G0 X140 Y30\nG2 X140 Y30 I10")),
        ),
        (Fault::ProfileCorner, "profile", Some(1.0), profile("G0 X0 Y0\nG1 X100\nY60\nX0\nY0\nG36 I61")),
        (Fault::ProfileMissing, "Z1", None, deep("", MAIN_3D)),
        (
            Fault::ProfileForm,
            "Z1",
            None,
            deep("#PROFILE D [XY]\nG0 X0 Y0\nG1 X5 Y-10\n#ENDPROFILE\n", MAIN_3D),
        ),
        (Fault::DepthProfile, "Z1", None, deep(&DEEP.replace("G0 X0", "G0 X1"), MAIN_3D)),
        (Fault::DepthProfile, "Z1", None, deep(&DEEP.replace("X5 Z-10", "X5 Z-5\nX4 Z-10"), MAIN_3D)),
        (Fault::DepthProfile, "Z2", None, deep(DEEP, &MAIN_3D.replace("Z1=D", "Z2=D"))),
        (Fault::WallsMeet, "Z1", None, deep(&DEEP.replace("X5 Z-10", "X40 Z-10"), MAIN_3D)),
        (Fault::CycleNoFeed, "#SEMI F", None, format!("{}#SEMI [T=1, I2=2]\n", deep(DEEP, MAIN_3D))),
        (
            Fault::MillTooManyMoves,
            "#FINISH eps",
            None,
            format!("{}#FINISH [T=4, F=300, eps=0.00001]\n", deep(DEEP, MAIN_3D)),
        ),
    ]
}

/// The other cycles: what a tool, a step or an angle cannot be, and what has no end.
fn wrong_cycles() -> Vec<Wrong> {
    let cycle = |text: &str| format!("{text}\n");
    vec![
        (
            Fault::CycleToolTooLarge,
            "#ROUGH T",
            None,
            cycle("#CYCLE G287 [L=8, H=40, ZS=5, P=5]\n#ROUGH [T=1, F=9, I=5]"),
        ),
        (
            Fault::CycleToolTooLarge,
            "#ROUGH T",
            None,
            cycle("#CYCLE G288 [R=4, ZS=5, P=5]\n#ROUGH [T=1, F=9, I=5]"),
        ),
        (
            Fault::CycleStepTooWide,
            "#ROUGH step",
            None,
            cycle("#CYCLE G288 [R=40, ZS=5, P=5]\n#ROUGH [T=1, F=9, I=5, step=11]"),
        ),
        (
            Fault::CycleStepTooWide,
            "step",
            None,
            cycle("#CYCLE G289 [L=80, H=40, ZS=5, P=5, T=1, F=9, I=5, step=11]"),
        ),
        (
            Fault::CycleEntryAngle,
            "#ROUGH beta",
            None,
            cycle("#CYCLE G287 [L=80, H=40, ZS=5, P=5]\n#ROUGH [T=1, F=9, I=5, beta=91]"),
        ),
        (
            Fault::CycleNoCuttingLength,
            "#ROUGH I",
            None,
            cycle("#CYCLE G287 [L=80, H=40, ZS=5, P=5]\n#ROUGH [T=5, F=9]"),
        ),
        (
            Fault::CycleToolsDiffer,
            "#FINISH N",
            None,
            cycle("#CYCLE G287 [L=80, H=40, ZS=5, P=5]\n#ROUGH [T=1, F=9, I=5]\n#FINISH [T=5, F=9]"),
        ),
        // A depth, a step, a speed that no axis and no spindle can tell from none.
        (
            Fault::CycleNoDepth,
            "P",
            None,
            cycle(
                "#CYCLE G299 [P=0.0000000000000000000000000002, F=500, T=1, phi=14, K=0.6, B=0.1, tool=single]",
            ),
        ),
        (
            Fault::MillTooManyMoves,
            "#ROUGH I",
            None,
            cycle("#CYCLE G290 [L=80, H=40, ZS=5, P=5]\n#ROUGH [T=1, F=9, I=0.0000000001]"),
        ),
        (
            Fault::MillTooManyMoves,
            "",
            None,
            cycle("#CYCLE G291 [L=80, H=40, ZS=5, P=5, Q=9]\n#ROUGH [T=1, F=9, I=5, step=0.0000000001]"),
        ),
        (
            Fault::TappingSpeed,
            "S",
            None,
            cycle(&format!("#CYCLE G284 [P=5, F=500, S=0.{}1, type=rigid]", "0".repeat(306))),
        ),
    ]
}

#[test]
fn wrong_parameters_are_named() {
    for (fault, parameter, contour, program) in wrong_pockets().into_iter().chain(wrong_cycles()) {
        let text = format!("S1000\n{program}G0 X7\nM30\n");
        let (_, alarm) = run_on(&DIALECT, &text, TOOLS);
        let alarm = alarm.unwrap_or_else(|| panic!("no alarm: {program}"));
        assert_eq!(alarm.fault, fault, "{:?}: {program}", alarm.arguments);
        let given =
            |name: &str| alarm.arguments.iter().find(|(n, _)| *n == name).map(|(_, value)| value.clone());
        let named = (!parameter.is_empty()).then(|| Argument::from(parameter));
        assert_eq!((given("parameter"), given("contour")), (named, contour.map(Argument::from)), "{program}");
        // All of a group is told of the line of its #CYCLE.
        let line = 1 + text.lines().position(|line| line.starts_with("#CYCLE")).unwrap();
        assert_eq!(alarm.span.line as usize, line, "{program}");
        for language in [Language::En, Language::Zh] {
            let catalogue = Catalogue::new(language);
            assert!(catalogue.help(&alarm).is_some(), "{fault:?} does not say what to do");
            assert!(catalogue.message(&alarm).contains(parameter), "{}", catalogue.message(&alarm));
        }
    }
}

/// The angle of an entry may be missing: then the tool goes straight down (4.1.3).
#[test]
fn no_angle_is_straight_down() {
    let lines = lines_on(&DIALECT, &format!("{RECTANGLE}{MAIN}{ROUGH}M30\n"), TOOLS);
    assert!(lines.contains(&"feed Z-5 F100".to_owned()), "{lines:?}");
    // Where a program is checked, it is said.
    let said = |text: &str, tools: &str| {
        told_on(&DIALECT, text, tools).iter().map(|a| (a.fault, a.severity)).collect::<Vec<_>>()
    };
    let program = format!("{RECTANGLE}{MAIN}{ROUGH}M30\n");
    assert_eq!(said(&program, TOOLS), [(Fault::NoEntryAngle, Severity::Warning)]);
    assert_eq!(said(&program.replace("T=1", "T=1, beta=5"), TOOLS), []);
    assert_eq!(said(&program, &TOOLS.replace("[tools.1]\n", "[tools.1]\nentry_angle = 10\n")), []);
    // A room of 9 mm behind a narrow door takes the finishing tool alone, which goes down into what was not roughed.
    let room = "#PROFILE R [XY]\nG0 X0 Y0\nG1 X100\nY28\nX105\nY25.5\nX135\nY34.5\nX105\nY32\nX100\nY60\nX0\nY0\n\
        #ENDPROFILE\n";
    let rough = ROUGH.replace("T=1", "T=1, beta=5");
    let finish =
        |angle: &str| format!("#FINISH [T=2, D=1, S=1000, F=600{angle}, delta=0, deltaz=0, step=4, N=0]\n");
    let drill = "#DRILL [T=3, D=1, S=1000, F=100, I=5]\n";
    let tools = TOOLS.replacen("radius = 2.5\n", "radius = 2\n", 1);
    let of = |profile: &str, rough: &str, angle: &str, drill: &str| {
        said(&format!("{profile}{MAIN}{drill}{rough}{}M30\n", finish(angle)), &tools)
    };
    let warning = [(Fault::NoEntryAngle, Severity::Warning)];
    assert_eq!(of(room, &rough, "", ""), warning);
    assert_eq!(of(room, &rough, ", theta=5", ""), []);
    assert_eq!(of(RECTANGLE, &rough, "", ""), []);
    // It is drilled where roughing goes down, and without roughing where finishing does.
    assert_eq!(of(room, ROUGH, "", drill), warning);
    assert_eq!(of(room, "", "", ""), warning);
    assert_eq!(of(room, "", "", drill), []);
}
