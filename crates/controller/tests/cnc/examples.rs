//! Every example, with all that an operator may do at random instants: the limits of every axis at any instant, the programmed

//! path, the end. Without them: nothing rests that need not.

use crate::common::parts::{Part, parts};
use crate::common::random::Random;
use ferrocut_controller::{Activity, Cnc, DryRun, Programmed, State, Way};
use ferrocut_geometry::{Axis, Position};
use ferrocut_machine::Machine;
use std::collections::VecDeque;

/// Finite differences are means of the true derivative and never overstate it.
const SLACK: f64 = 1.001;

/// Moves before the one being run, and behind it, that the axes may be on: joints, and short ones between two periods.
const BESIDE: usize = 8;

/// Periods after which a run is taken as hanging: an hour and a half of machine time.
const HANGS: usize = 5_400_000;

/// Periods between two hands, on average.
const APART: usize = 1500;

/// The last four setpoints, and of how many of them in a row the path is planned: in a thread the axes follow the pulses
/// of the spindle's encoder.
struct Judge<'a> {
    name: &'a str,
    machine: &'a Machine,
    period: f64,
    last: [Position; 4],
    planned: usize,
    moves: VecDeque<Programmed>,
    judged: usize,
}

impl<'a> Judge<'a> {
    fn new(name: &'a str, machine: &'a Machine, at: Position) -> Judge<'a> {
        let period = machine.servo_period_ms / 1000.0;
        Judge { name, machine, period, last: [at; 4], planned: 4, moves: VecDeque::new(), judged: 0 }
    }

    /// Velocity, acceleration and jerk over one, two and three periods.
    fn judge(&mut self, at: Position, in_thread: bool) {
        self.last = [self.last[1], self.last[2], self.last[3], at];
        self.planned = if in_thread { 0 } else { self.planned + 1 };
        if self.planned < 4 {
            return;
        }
        self.judged += 1;
        let t = self.period;
        for axis in &self.machine.axes {
            let [a, b, c, d] = self.last.map(|p| p[axis.name]);
            let velocity = (d - c) / t;
            let acceleration = ((d - c) - (c - b)) / (t * t);
            let jerk = ((d - c) - 2.0 * (c - b) + (b - a)) / (t * t * t);
            // Positions of some hundred millimetres are known to 1e-13.
            let rounding = 8.0 * (1.0 + d.abs()) * 4e-16;
            let most = [
                (velocity, axis.velocity.max(axis.rapid) / 60.0, rounding / t),
                (acceleration, axis.acceleration, rounding / (t * t)),
                (jerk, if axis.jerk > 0.0 { axis.jerk } else { f64::INFINITY }, rounding / (t * t * t)),
            ];
            for (order, (value, limit, rounding)) in (1..).zip(most) {
                assert!(
                    value.abs() <= limit * SLACK + rounding,
                    "{}, {} at {:?}: {value} of order {order} above {limit}",
                    self.name,
                    axis.name.letter(),
                    self.last
                );
            }
        }
    }

    /// Distance from the lines and arcs about the one being run.
    fn judge_path(&mut self, cnc: &Cnc, at: Position) {
        let known = self.moves.back().map_or(0, |last| last.number);
        self.moves.extend(cnc.moves().filter(|m| m.number > known).copied());
        let Some(run) = cnc.moves().next().map(|m| m.number) else { return };
        while self.moves.len() > 1 && self.moves[0].number + (BESIDE as u64) < run {
            self.moves.pop_front();
        }
        let near = || self.moves.iter().filter(|m| m.number <= run + BESIDE as u64);
        if near().any(|m| m.way == Way::Apart) {
            return;
        }
        let tolerance = near().filter_map(|m| m.tolerance).fold(self.machine.path.tolerance, f64::max);
        let off = near().filter_map(|m| m.distance(at)).fold(f64::INFINITY, f64::min);
        assert!(off <= tolerance * SLACK, "{}, move {run}: {off} mm from the path at {at:?}", self.name);
    }
}

/// Something that an operator does, or the ladder. Nothing that keeps the axes from moving stays for long: it may go with the
/// next hand.
fn lay_hands_on(cnc: &mut Cnc, random: &mut Random) {
    match random.below(8) {
        0 => cnc.feed_hold(),
        1 => cnc.set_override(random.one(&[0.1, 0.5, 1.0, 1.2, 2.0]), random.one(&[0.25, 0.5, 1.0])),
        2 => cnc.set_override(0.1 + 1.9 * random.unit(), random.unit()),
        3 => cnc.set_override(random.one(&[0.0, 1.0, 1.0]), random.one(&[0.0, 1.0, 1.0])),
        4 => cnc.set_single_block(random.one(&[true, false, false])),
        5 => cnc.finish_block(),
        6 => cnc.set_may_move(random.one(&[true, true, false])),
        _ => {
            let dry = DryRun {
                speed: 20.0 + 50.0 * random.unit(),
                cutting: true,
                rapid: random.one(&[true, false]),
                tapping: random.one(&[true, false]),
            };
            cnc.set_dry_run(random.one(&[Some(dry), None, None]));
        }
    }
}

/// Runs a part to its end, with hands so many periods apart on average; where the axes stand then.
fn end_of(part: &Part, mut random: Option<Random>, apart: usize) -> Position {
    let mut cnc = Cnc::new(&part.machine, part.interpreter());
    let mut judge = Judge::new(&part.name, &part.machine, cnc.tick().position);
    let mut angle = cnc.spindle().angle();
    cnc.cycle_start();
    let mut next = 0;
    for tick in 0..HANGS {
        if let Some(random) = random.as_mut().filter(|_| tick >= next) {
            next = tick + 1 + random.below(2 * apart);
            lay_hands_on(&mut cnc, random);
        }
        let waits_long = tick + 1 >= next;
        match cnc.state() {
            State::Stopped(_) => cnc.cycle_start(),
            State::Held | State::BlockEnd if waits_long => cnc.cycle_start(),
            _ => {}
        }
        let position = cnc.tick().position;
        let spindle = cnc.spindle();
        // A spindle that axes are in step with has no speed of its own, and turns.
        let in_thread = spindle.actual_rpm() == 0.0 && spindle.angle() != angle;
        angle = spindle.angle();
        judge.judge(position - cnc.renamed(), in_thread);
        if cnc.renamed() == Position::ZERO && !in_thread {
            judge.judge_path(&cnc, position);
        }
        match cnc.state() {
            State::Ended => {
                assert!(judge.judged > 1000, "{}: {}", part.name, judge.judged);
                return position;
            }
            State::Running | State::Held | State::Stopped(_) | State::BlockEnd => {}
            state => panic!("{}: {state:?}", part.name),
        }
    }
    panic!("{} does not end", part.name);
}

#[test]
fn every_example_keeps_the_limits_and_the_path_whatever_the_operator_does() {
    let parts: Vec<Part> = parts().into_iter().filter(|part| part.is_example).collect();
    assert!(parts.len() > 15);
    std::thread::scope(|scope| {
        for half in 0..2 {
            let parts = &parts;
            scope.spawn(move || {
                for (k, part) in parts.iter().enumerate().filter(|(k, _)| k % 2 == half) {
                    let plain = end_of(part, None, APART);
                    let disturbed = end_of(part, Some(Random::new(k as u64 + 1)), APART);
                    let gap = Axis::ALL.map(|axis| (plain[axis] - disturbed[axis]).abs());
                    assert!(gap.iter().all(|gap| *gap < 1e-9), "{}: {plain:?} {disturbed:?}", part.name);
                }
            });
        }
    });
}

/// Blocks are taken up again inside rounded corners, close to the next one.
#[test]
fn short_lines_that_are_taken_up_beside_them_keep_the_tolerance() {
    let mut random = Random::new(7);
    for round in 0..40 {
        let mut text = "G21 G90 G17 G64 P0.1\nF3000\n".to_owned();
        let (mut at, mut heading) = ([0.0, 0.0], 0.0_f64);
        for _ in 0..60 {
            let length = random.one(&[0.3, 0.6, 1.0, 2.0, 4.0]) * (0.8 + 0.4 * random.unit());
            heading += (2.0 * random.unit() - 1.0) * 2.0;
            at = [at[0] + length * heading.cos(), at[1] + length * heading.sin()];
            text += &format!("G1 X{:.4} Y{:.4}\n", at[0], at[1]);
        }
        text += "M2\n";
        let part = Part::new(&format!("short lines {round}"), "rs274", "", &text);
        end_of(&part, Some(Random::new(round)), 60);
    }
}

/// Where a move begins or ends and the direction that it has there; `None` where no line is programmed.
fn end(programmed: &Programmed, is_last: bool) -> Option<(Position, Position)> {
    match programmed.way {
        Way::Apart => None,
        Way::Line(from, to) => Some((if is_last { to } else { from }, to - from)),
        Way::Arc(arc) => {
            let at = if is_last { arc.end } else { arc.start };
            let [a, b] = arc.plane.of(at);
            let (first, second) = (arc.plane.first(), arc.plane.second());
            let mut along = Position::ZERO;
            along[first] = -(b - arc.center[1]) * arc.sweep;
            along[second] = (a - arc.center[0]) * arc.sweep;
            along[arc.plane.normal()] = arc.end[arc.plane.normal()] - arc.start[arc.plane.normal()];
            Some((at, along))
        }
    }
}

/// Why the path may rest between two moves: what the moves themselves ask for.
fn may_rest(before: &Programmed, next: &Programmed, machine: &Machine) -> bool {
    if before.is_rapid || next.is_rapid {
        return true;
    }
    let tolerance = |m: &Programmed| m.tolerance.unwrap_or(machine.path.tolerance);
    let Some(((_, one), (_, other))) = end(before, true).zip(end(next, false)) else { return true };
    let dot = |a: Position, b: Position| {
        Axis::ALL.into_iter().filter(|a| a.is_linear()).map(|axis| a[axis] * b[axis]).sum::<f64>()
    };
    let cosine = dot(one, other) / (dot(one, one) * dot(other, other)).sqrt();
    // What nearly turns back cannot be rounded, and an exact path not at all.
    cosine < -0.9 || tolerance(before).min(tolerance(next)) < 1e-4 && cosine < 1.0 - 1e-9
}

/// Rests of a part between two cuts, and those of them without a reason.
fn rests(part: &Part) -> (usize, Vec<String>) {
    let mut cnc = Cnc::new(&part.machine, part.interpreter());
    let standing = |cnc: &Cnc| {
        [Activity::Dwell, Activity::ToolChange, Activity::Spindle].map(|activity| cnc.report().time(activity))
    };
    // The last move that was run, and the one before a rest with what there was to do until then.
    let mut last: Option<Programmed> = None;
    let mut rest = None;
    let (mut is_moving, mut between_cuts, mut needless) = (false, 0, Vec::new());
    for _ in 0..HANGS {
        if matches!(cnc.state(), State::Ready | State::Stopped(_)) {
            cnc.cycle_start();
            (last, is_moving) = (None, false);
        }
        let done = standing(&cnc);
        let tick = cnc.tick();
        match cnc.state() {
            State::Ended => return (between_cuts, needless),
            State::Running | State::Stopped(_) => {}
            state => panic!("{}: {state:?}", part.name),
        }
        let now = cnc.moves().next().copied().or(last);
        // Of a stop within the limits of jerk a sample is no faster than this.
        let moves = tick.velocity > 0.01;
        if is_moving && !moves {
            rest = last.map(|last| (last, tick.position, done));
        } else if moves
            && !is_moving
            && let Some(((before, at, done), next)) = rest.take().zip(now)
        {
            between_cuts += usize::from(!before.is_rapid && !next.is_rapid);
            if standing(&cnc) == done && !may_rest(&before, &next, &part.machine) {
                needless.push(format!("{} at {at:?}: {before:?}, {next:?}", part.name));
            }
        }
        (is_moving, last) = (moves, now);
    }
    panic!("{} does not end", part.name);
}

#[test]
fn no_example_rests_without_a_reason() {
    let mut between_cuts = 0;
    for part in parts().iter().filter(|part| part.is_example) {
        let (rests, needless) = rests(part);
        between_cuts += rests;
        assert!(needless.is_empty(), "{}", needless.join("\n"));
    }
    assert!(between_cuts > 50, "{between_cuts}");
}
