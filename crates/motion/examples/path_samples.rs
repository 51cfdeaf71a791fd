//! Runs a path given as JSON and writes a setpoint every servo period, for judging motion apart from programs.
//!
//! `path_samples PATH.json OUT.csv [period_ms]`: a path has `start`, `segments` (`line` and `arc`, with `to`, `plane`,
//! `center`, `sweep` in degrees; `rapid` where only the axes limit the speed), `feed` in mm/min, `vmax`, `amax`, `jmax` of X, Y,
//! Z and `tolerance` in mm.
#![allow(missing_docs, clippy::unwrap_used)]

use ferrocut_geometry::{Plane, Position};
use ferrocut_machine::Machine;
use ferrocut_motion::{Motion, Move, State};
use ferrocut_toolpath::PathMode;
use serde_json::Value;
use std::fmt::Write;

fn main() {
    let arguments: Vec<String> = std::env::args().collect();
    let path: Value = serde_json::from_str(&std::fs::read_to_string(&arguments[1]).unwrap()).unwrap();
    let number = |v: &Value| v.as_f64().unwrap();
    let point = |v: &Value| Position::xyz(number(&v[0]), number(&v[1]), number(&v[2]));
    let mut machine = Machine::demo_mill();
    machine.servo_period_ms = arguments.get(3).map_or(1.0, |p| p.parse().unwrap());
    for i in 0..3 {
        let axis = &mut machine.axes[i];
        axis.velocity = number(&path["vmax"][i]) * 60.0;
        axis.rapid = axis.velocity;
        axis.acceleration = number(&path["amax"][i]);
        axis.jerk = path["jmax"].get(i).map_or(0.0, number);
    }
    let tolerance = path["tolerance"].as_f64().unwrap_or(0.0);
    let mode = PathMode::ContinuousWithin(tolerance);
    let start = point(&path["start"]);
    let mut moves = Vec::new();
    for (i, segment) in path["segments"].as_array().unwrap().iter().enumerate() {
        let feed = segment.get("feed").or(path["feed"].get(i)).unwrap_or(&path["feed"]);
        let is_rapid = segment["rapid"].as_bool().unwrap_or(false);
        let feed = if is_rapid { f64::INFINITY } else { number(feed) / 60.0 };
        let to = point(&segment["to"]);
        let m = if segment["kind"] == "line" {
            Move::line(to, feed, mode, i as u64 + 1)
        } else {
            let plane = match segment["plane"].as_str().unwrap() {
                "xy" => Plane::Xy,
                "zx" => Plane::Zx,
                _ => Plane::Yz,
            };
            let center = [number(&segment["center"][0]), number(&segment["center"][1])];
            Move::arc(to, plane, center, number(&segment["sweep"]).to_radians(), feed, mode, i as u64 + 1)
        };
        moves.extend(m);
    }
    let began = std::time::Instant::now();
    let mut motion = Motion::new(&machine, start);
    let mut samples = vec![start];
    let mut left = moves.iter();
    loop {
        while motion.free() > 0 {
            match left.next() {
                Some(m) => motion.push(m).unwrap(),
                None => {
                    motion.finish();
                    break;
                }
            }
        }
        let setpoint = motion.tick();
        samples.push(setpoint.position);
        if setpoint.state == State::Idle {
            break;
        }
    }
    let took = began.elapsed().as_secs_f64();
    let period = machine.servo_period_ms / 1e3;
    let mut text = String::from("t,x,y,z\n");
    for (k, p) in samples.iter().enumerate() {
        let _ = writeln!(text, "{:.6},{:.12},{:.12},{:.12}", k as f64 * period, p.0[0], p.0[1], p.0[2]);
    }
    std::fs::write(&arguments[2], text).unwrap();
    println!("{} moves, {:.4} s in {took:.4} s", moves.len(), (samples.len() - 1) as f64 * period);
}
