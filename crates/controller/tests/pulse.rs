//! Step and direction: what a simulated board makes of a program, with a whole line, a bad one and a cut one.
#![allow(missing_docs, clippy::unwrap_used, clippy::panic)]

#[path = "common/board.rs"]
mod board;
mod common;

use assert_no_alloc::{AllocDisabler, assert_no_alloc};
use board::{Able, Board, frame_of};
use common::{in_language, interpreter};
use ferrocut_controller::drives::Drives;
use ferrocut_controller::drives::pulse::{Link, Port};
use ferrocut_controller::drives::{Pulse, connect};
use ferrocut_controller::{Cnc, JogSpeed, JogWay, State, Tick};
use ferrocut_geometry::{Axis, Position};
use ferrocut_interpreter::Interpreter;
use ferrocut_machine::{DrivesConfig, Fault, Machine, PulseConfig};
use std::collections::VecDeque;
use std::fs::File;
use std::io::{self, ErrorKind, Read, Write};
use std::net::{TcpListener, UdpSocket};
use std::sync::{Arc, Mutex};

#[global_allocator]
static ALLOCATOR: AllocDisabler = AllocDisabler;

const MS: f64 = 1e6;

/// The demo mill with a board that has X, Y, Z and A: 400, 400, 800 steps in a mm, 100 in a degree.
fn machine(change: &str) -> Machine {
    let axes = Machine::DEMO_MILL.replace("[[axes]]\n", "[[axes]]\nin_position = 0.02\n");
    let drives = format!(
        "[drives]\nkind = \"pulse\"\nlink = \"udp:127.0.0.1:7070\"\nbuffer = 8\nwatchdog_ms = 50.0\nprobe = true\n\
         inputs = [20, 21]\noutputs = [20]\n{change}\naxes = [\n\
         {{ name = \"X\", steps = 400.0, limits = true }},\n{{ name = \"Y\", steps = 400.0, reversed = true }},\n\
         {{ name = \"Z\", steps = 800.0, setup_ns = 20000 }},\n{{ name = \"A\", steps = 100.0 }},\n]\n"
    );
    Machine::from_toml(&format!("{axes}\n{drives}")).unwrap()
}

fn config(machine: &Machine) -> &PulseConfig {
    let Some(DrivesConfig::Pulse(config)) = &machine.drives else { panic!() };
    config
}

/// What is on the way.
#[derive(Default)]
struct Line {
    down: VecDeque<Vec<u8>>,
    up: VecDeque<u8>,
    is_cut: bool,
    is_blocked: bool,
}

struct Way(Arc<Mutex<Line>>);

impl Link for Way {
    fn send(&mut self, bytes: &[u8]) -> io::Result<usize> {
        let mut line = self.0.lock().unwrap();
        if line.is_blocked {
            return Err(ErrorKind::WouldBlock.into());
        }
        line.down.push_back(bytes.to_vec());
        Ok(bytes.len())
    }

    fn receive(&mut self, into: &mut [u8]) -> io::Result<usize> {
        let mut line = self.0.lock().unwrap();
        let count = into.len().min(line.up.len());
        for (place, byte) in into.iter_mut().zip(line.up.drain(..count)) {
            *place = byte;
        }
        if count == 0 { Err(ErrorKind::WouldBlock.into()) } else { Ok(count) }
    }
}

/// What becomes of the packets of a period, which is counted from when the board is ready.
type Meddling = Box<dyn FnMut(usize, Vec<Vec<u8>>) -> Vec<Vec<u8>>>;

/// A control and its board, period by period.
struct Bench {
    cnc: Cnc,
    board: Board,
    line: Arc<Mutex<Line>>,
    meddling: Meddling,
    /// Where the axes were commanded to be in the periods that went to the board, steps.
    told: Vec<[f64; 4]>,
    scales: [f64; 4],
    last: Tick,
}

impl Bench {
    fn new(machine: &Machine, program: &str, board: Board) -> Bench {
        Bench::with(machine, program, "", board)
    }

    fn with(machine: &Machine, program: &str, setup: &str, board: Board) -> Bench {
        Bench::of(machine, interpreter(program, setup), board)
    }

    fn of(machine: &Machine, interpreter: Interpreter, board: Board) -> Bench {
        let line = Arc::new(Mutex::new(Line::default()));
        let start = interpreter.position();
        let drives = Pulse::new(machine, config(machine), Box::new(Way(line.clone())), start);
        let mut cnc = Cnc::with_drives(machine, interpreter, Box::new(drives));
        let last = cnc.tick();
        let scales = [0, 1, 2, 3].map(|axis| config(machine).axes[axis].steps);
        let meddling: Meddling = Box::new(|_, packets| packets);
        Bench { cnc, board, line, meddling, told: Vec::new(), scales, last }
    }

    fn tick(&mut self) {
        let tick = self.cnc.tick();
        self.last = tick;
        let packets: Vec<Vec<u8>> = self.line.lock().unwrap().down.drain(..).collect();
        let is_setpoint = |packet: &Vec<u8>| {
            let frame = packet.split(|byte| *byte == 0).next().and_then(frame_of);
            frame.is_some_and(|frame| frame[0] == 3)
        };
        if packets.iter().any(is_setpoint) {
            let [x, y, z, a, ..] = tick.position.0;
            let mut scales = self.scales.iter();
            self.told.push([x, y, z, a].map(|at| at * scales.next().unwrap()));
        }
        let packets = (self.meddling)(self.told.len(), packets);
        if !self.line.lock().unwrap().is_cut {
            packets.iter().for_each(|packet| self.board.feed(packet));
        }
        // A period of the computer has a phase of its own.
        self.board.run(0.3 * MS);
        self.hand_up();
        self.board.run(0.7 * MS);
        self.hand_up();
    }

    fn hand_up(&mut self) {
        let answers = self.board.take();
        let mut line = self.line.lock().unwrap();
        if !line.is_cut {
            line.up.extend(answers);
        }
    }

    fn until(&mut self, most: usize, mut is: impl FnMut(&mut Bench) -> bool) {
        for _ in 0..most {
            if is(self) {
                return;
            }
            self.tick();
        }
        panic!(
            "not within {most} periods: {:?}, board {} {}",
            self.cnc.state(),
            self.board.doing,
            self.board.fault
        );
    }

    /// Until the board is ready, then the program from start to end.
    fn run(&mut self) {
        self.until(200, |bench| bench.board.doing == board::RUNNING);
        self.cnc.cycle_start();
        self.until(60_000, |bench| !matches!(bench.cnc.state(), State::Running | State::Resetting));
        // What lies within the window of in-position.
        (0..20).for_each(|_| self.tick());
    }

    fn alarm(&self) -> Fault {
        match self.cnc.state() {
            State::Alarmed(alarm) => alarm.fault,
            state => panic!("{state:?}"),
        }
    }

    /// Every pulse is one that a drive understands, and at every instant the steps made are those of the setpoints but
    /// for one.
    fn judge(&self) {
        let begun = &self.board.begun;
        for (number, axis) in self.board.axes.iter().enumerate() {
            let [pulse, space, setup, hold]: [f64; 4] = if number == 2 {
                [2500.0, 2500.0, 20_000.0, 5000.0]
            } else {
                [2500.0, 2500.0, 5000.0, 5000.0]
            };
            let mut count = 0i64;
            let mut frame = 0;
            let mut before: Option<board::Pulse> = None;
            for made in &axis.pulses {
                assert!(made.fall - made.rise >= pulse - 0.01, "{made:?}");
                if let Some(before) = before {
                    assert!(made.rise - before.fall >= space - 0.01, "{before:?} {made:?}");
                    if made.up != before.up {
                        assert!(made.turned - before.fall >= hold - 0.01, "{before:?} {made:?}");
                        assert!(made.rise - made.turned >= setup - 0.01, "{before:?} {made:?}");
                    }
                }
                while begun.get(frame + 1).is_some_and(|begin| *begin <= made.rise) {
                    frame += 1;
                }
                // Between the setpoint before and this one.
                let length = begun.get(frame + 1).map_or(MS, |next| next - begun[frame]);
                let part = ((made.rise - begun[frame]) / length).min(1.0);
                let (from, to) = (self.told[frame.max(1) - 1][number], self.told[frame][number]);
                let wanted = from + part * (to - from);
                let after = count + if made.up { 1 } else { -1 };
                for count in [count, after] {
                    let beside = (count as f64 - wanted).abs();
                    assert!(beside <= 1.0, "axis {number}, setpoint {frame}: {count} for {wanted}");
                }
                count = after;
                before = Some(*made);
            }
            assert_eq!((count, axis.wrong), (axis.count, 0));
        }
    }
}

const PROGRAM: &str = "G0 X20 Y10 Z5\nA30\nG1 Z-1 F1500\nX40 F6000\nG3 X50 Y20 R10\nG1 Y30\nX49.3 Y31.7\nX52\n\
                       G2 X52 Y30 R-15 F4000\nG1 G61 X30.0012\nG64 Y5 Z3\nG0 X0 Y0 Z0\nA-7.5\nM30\n";

#[test]
fn steps_are_those_of_the_setpoints_at_every_instant_and_at_the_end() {
    let mut bench = Bench::new(&machine(""), PROGRAM, Board::new(Able::default()));
    bench.run();
    assert_eq!(bench.cnc.state(), &State::Ended);
    let counts: Vec<i64> = bench.board.axes.iter().map(|axis| axis.count).collect();
    assert_eq!(counts, [0, 0, 0, -750]);
    bench.judge();
    let pulses: usize = bench.board.axes.iter().map(|axis| axis.pulses.len()).sum();
    assert!(pulses > 80_000 && bench.board.unreadable == 0, "{pulses}");
    // The rate that was agreed is kept, and no pulse waits longer than a change of direction takes.
    for axis in &bench.board.axes {
        assert!(axis.put_off <= 30_000.0, "{}", axis.put_off);
    }
}

#[test]
fn clocks_of_control_and_board_may_differ() {
    for drift in [-3e-4, 3e-4] {
        let mut board = Board::new(Able::default());
        (board.drift, board.keeps_pulses) = (drift, false);
        // 40 s: 12 periods more or less.
        let program = format!("{}M30\n", "G1 X100 F5000\nX0\n".repeat(16));
        let mut bench = Bench::new(&machine(""), &program, board);
        bench.run();
        assert_eq!((bench.cnc.state(), bench.board.axes[0].count), (&State::Ended, 0));
        assert!(bench.told.len() > 38_000);
        assert!((bench.board.level - 8.0).abs() < 1.0, "{}", bench.board.level);
    }
}

#[test]
fn setpoints_that_change_places_or_come_late_do_no_harm() {
    let mut bench = Bench::new(&machine(""), PROGRAM, Board::new(Able::default()));
    let mut late: Vec<Vec<u8>> = Vec::new();
    bench.meddling = Box::new(move |period, packets| {
        late.extend(packets);
        // Five periods nothing comes, then all of it, backwards and twice.
        if period > 100 && period % 12 < 5 {
            return Vec::new();
        }
        let mut all = std::mem::take(&mut late);
        all.extend(all.clone());
        all.reverse();
        all
    });
    bench.run();
    assert_eq!(bench.cnc.state(), &State::Ended);
    bench.judge();
    assert_eq!((bench.board.axes[3].count, bench.board.unreadable), (-750, 0));
}

/// The emergency stop of the control takes the amplifiers off once the axes stand; its release gives them
/// back.
#[test]
fn the_emergency_stop_takes_the_amplifiers_off_at_rest() {
    for (change, forgets) in [("", true), ("absolute = true", false)] {
        let mut bench = Bench::new(&machine(change), "G1 X100 Y50 F6000\nM30\n", Board::new(Able::default()));
        bench.until(200, |bench| bench.board.doing == board::RUNNING);
        let axes = bench.cnc.referenced();
        bench.cnc.set_referenced([Axis::X, Axis::Y].into_iter().collect());
        bench.cnc.cycle_start();
        bench.until(1000, |bench| bench.last.position[Axis::X] > 20.0);
        assert!(bench.board.enabled, "{axes:?}");
        bench.cnc.emergency_stop();
        let (mut count, mut braked) = (0, false);
        bench.until(1000, |bench| {
            bench.cnc.power_drives(false);
            braked |= bench.board.axes[0].count != count;
            let stands = bench.board.axes[0].count == count;
            assert!(bench.board.enabled || stands, "not while it moves");
            count = bench.board.axes[0].count;
            !bench.board.enabled
        });
        assert!(braked && bench.board.doing == board::RUNNING);
        assert_eq!(bench.cnc.referenced().is_empty(), forgets, "{change}");
        let at = bench.board.axes[0].count;
        (0..100).for_each(|_| bench.tick());
        bench.cnc.power_drives(true);
        (0..100).for_each(|_| bench.tick());
        assert!(bench.board.enabled && bench.board.axes[0].count == at);
        assert!(bench.cnc.jog(Axis::X, JogWay::Plus, JogSpeed::Feed));
        (0..500).for_each(|_| bench.tick());
        assert!(bench.board.axes[0].count > at + 100);
    }
}

/// The input X8.4 of the ladder, as the drives have it.
fn emergency_circuit(drives: &mut dyn Drives) -> Option<bool> {
    let mut closed = None;
    drives.read(&mut |byte, bit, is_on| {
        if (byte, bit) == (8, 4) {
            closed = Some(is_on);
        }
    });
    closed
}

#[test]
fn the_emergency_stop_of_the_board_is_that_of_the_ladder_and_takes_all_outputs_off() {
    let mut bench = Bench::new(&machine(""), "G1 X100 F6000\nM30\n", Board::new(Able::default()));
    bench.until(200, |bench| bench.board.doing == board::RUNNING);
    bench.cnc.drives().write(&|byte, bit| (byte, bit) == (20, 3));
    bench.cnc.cycle_start();
    bench.until(1000, |bench| bench.last.position[Axis::X] > 20.0);
    assert_eq!((bench.board.outputs[0], emergency_circuit(bench.cnc.drives())), (8, Some(true)));
    bench.board.emergency_stop = true;
    bench.until(1000, |bench| bench.board.doing == board::STOPPED);
    bench.until(1000, |bench| matches!(bench.cnc.state(), State::Alarmed(_)));
    assert_eq!((bench.alarm(), bench.board.outputs), (Fault::DriveEmergencyStop, [0; 8]));
    assert_eq!(emergency_circuit(bench.cnc.drives()), Some(false));
    // Let out again, the ladder hears it; the alarm stays until reset.
    bench.board.emergency_stop = false;
    (0..20).for_each(|_| bench.tick());
    assert_eq!(emergency_circuit(bench.cnc.drives()), Some(true));
    assert_eq!((bench.alarm(), bench.board.doing), (Fault::DriveEmergencyStop, board::STOPPED));
}

/// Power comes on with the button pressed: the control begins, with the alarm.
#[test]
fn a_board_whose_emergency_stop_is_pressed_is_a_board() {
    let mut board = Socketed::new();
    board.board.emergency_stop = true;
    let mut drives = board.connect();
    for _ in 0..20 {
        board.step();
        drives.exchange(&Position::ZERO);
    }
    assert_eq!(drives.failure(Default::default()).unwrap().fault, Fault::DriveEmergencyStop);
    assert_eq!(emergency_circuit(&mut *drives), Some(false));
}

/// Whoever presses the button of the control presses that.
#[test]
fn the_button_of_the_control_takes_the_amplifiers_off() {
    use ferrocut_controller::{Control, Mode, Parts};
    let machine = machine("");
    let line = Arc::new(Mutex::new(Line::default()));
    let drives = Pulse::new(&machine, config(&machine), Box::new(Way(line.clone())), Position::ZERO);
    let parts = Parts { drives: Some(Box::new(drives)), ..Parts::default() };
    let mut control = Control::new(&machine, parts).unwrap();
    let mut board = Board::new(Able::default());
    let mut inputs = Control::free_inputs(Mode::Jog);
    for (pressed, enabled) in [(false, true), (true, false), (false, true)] {
        inputs.emergency_stop = pressed;
        control.set_inputs(inputs.clone());
        for _ in 0..300 {
            control.tick();
            let packets: Vec<Vec<u8>> = line.lock().unwrap().down.drain(..).collect();
            packets.iter().for_each(|packet| board.feed(packet));
            board.run(MS);
            line.lock().unwrap().up.extend(board.take());
        }
        assert_eq!((board.enabled, board.doing), (enabled, board::RUNNING), "pressed: {pressed}");
    }
}

/// A bench whose line does something to the setpoints of period 400, when all axes move.
fn meddled(meddle: impl Fn(Vec<Vec<u8>>) -> Vec<Vec<u8>> + 'static) -> Bench {
    let mut bench = Bench::new(&machine(""), PROGRAM, Board::new(Able::default()));
    bench.meddling = Box::new(move |period, packets| if period == 400 { meddle(packets) } else { packets });
    bench.run();
    bench
}

#[test]
fn a_setpoint_that_is_lost_or_unreadable_is_an_alarm_and_a_stop() {
    for (unreadable, meddle) in [
        (0, Box::new(|_| Vec::new()) as Box<dyn Fn(Vec<Vec<u8>>) -> Vec<Vec<u8>>>),
        (
            1,
            Box::new(|mut packets: Vec<Vec<u8>>| {
                packets[0][12] ^= 0x40;
                packets
            }),
        ),
    ] {
        let mut bench = meddled(meddle);
        assert_eq!((bench.alarm(), bench.board.unreadable), (Fault::DriveFrameLost, unreadable));
        assert_eq!(bench.board.doing, board::STOPPED);
        assert!(!bench.board.enabled && bench.cnc.referenced().is_empty());
        // The steps of each axis grow apart no faster than its acceleration lets them: nothing is lost.
        for (axis, [acceleration, steps]) in
            bench.board.axes.iter().zip([[2000.0, 400.0], [2000.0, 400.0], [1500.0, 800.0], [500.0, 100.0]])
        {
            let times: Vec<f64> = axis.pulses.iter().rev().take(200).map(|pulse| pulse.rise).collect();
            let rates: Vec<f64> = times.windows(2).map(|w| 1e9 / (w[0] - w[1])).collect();
            let most = acceleration * steps * 1.05;
            for (pair, rates) in times.windows(3).zip(rates.windows(2)) {
                // Between pulses far from each other rates say nothing of an instant.
                let seconds = (pair[0] - pair[2]) / 2e9;
                let change = (rates[1] - rates[0]).abs();
                assert!(change <= most * (seconds + 0.002) + 0.02 * rates[1], "{change} in {seconds}");
            }
        }
        // Nothing moves any more, and reset brings the drives back from where they stand.
        let counts: Vec<i64> = bench.board.axes.iter().map(|axis| axis.count).collect();
        (0..300).for_each(|_| bench.tick());
        assert_eq!(counts, bench.board.axes.iter().map(|axis| axis.count).collect::<Vec<_>>());
        bench.cnc.reset();
        bench.until(500, |bench| bench.board.doing == board::RUNNING && bench.cnc.state() == &State::Reset);
        let (at, counts) = (bench.last.position, bench.board.axes[0].count);
        assert!(bench.cnc.jog(Axis::X, JogWay::Plus, JogSpeed::Of(1000.0)));
        (0..500).for_each(|_| bench.tick());
        bench.cnc.jog(Axis::X, JogWay::Stop, JogSpeed::Of(1000.0));
        bench.until(500, |bench| !bench.last.moving);
        (0..50).for_each(|_| bench.tick());
        let way = bench.last.position[Axis::X] - at[Axis::X];
        let steps = bench.board.axes[0].count - counts;
        assert!(way > 1.0 && (way * 400.0 - steps as f64).abs() <= 1.0, "{way} mm, {steps} steps");
    }
}

#[test]
fn a_cut_line_stops_both_ends() {
    let mut bench = Bench::new(&machine(""), PROGRAM, Board::new(Able::default()));
    let line = bench.line.clone();
    bench.meddling = Box::new(move |period, packets| {
        line.lock().unwrap().is_cut = period >= 400;
        packets
    });
    bench.run();
    // The board first runs dry, in motion.
    assert_eq!((bench.alarm(), bench.board.fault), (Fault::DrivesLost, 2));
    // 8 periods of setpoints, then braking from 100 mm/s at 2000 mm/s²; the control 50 ms after the last word.
    assert!(bench.board.begun.len() <= 410);
    (0..100).for_each(|_| bench.tick());
    assert_eq!(bench.board.doing, board::STOPPED);
    // As long as it is cut, reset leads to the next alarm.
    bench.cnc.reset();
    bench.until(3000, |bench| matches!(bench.cnc.state(), State::Alarmed(_)));
    assert_eq!(bench.alarm(), Fault::DrivesSilent);
    bench.meddling = Box::new(|_, packets| packets);
    bench.line.lock().unwrap().is_cut = false;
    bench.cnc.reset();
    bench.until(500, |bench| bench.board.doing == board::RUNNING && bench.cnc.state() == &State::Reset);
}

#[test]
fn a_board_that_hears_nothing_at_rest_stops_by_its_watchdog() {
    let mut bench = Bench::new(&machine(""), "M0\nM30\n", Board::new(Able::default()));
    bench.until(200, |bench| bench.board.doing == board::RUNNING);
    // Down is cut, up is not.
    bench.meddling = Box::new(|_, _| Vec::new());
    bench.until(100, |bench| matches!(bench.cnc.state(), State::Alarmed(_)));
    assert_eq!((bench.alarm(), bench.board.fault), (Fault::DriveWatchdog, 1));
}

#[test]
fn a_line_that_takes_nothing_is_an_alarm() {
    let mut bench = Bench::new(&machine(""), PROGRAM, Board::new(Able::default()));
    let line = bench.line.clone();
    bench.meddling = Box::new(move |period, packets| {
        line.lock().unwrap().is_blocked = period >= 400;
        packets
    });
    bench.run();
    assert!(matches!(bench.alarm(), Fault::DriveStarved | Fault::DrivesCut));
}

#[test]
fn emergency_stop_and_amplifier_stop_the_control() {
    for (fault, number) in [(Fault::DriveEmergencyStop, 5), (Fault::DriveAmplifier, 6)] {
        let mut bench = Bench::new(&machine(""), PROGRAM, Board::new(Able::default()));
        bench.until(200, |bench| bench.board.doing == board::RUNNING);
        bench.cnc.cycle_start();
        (0..300).for_each(|_| bench.tick());
        match number {
            5 => bench.board.emergency_stop = true,
            _ => bench.board.amplifier_fault = Some(1),
        }
        bench.until(2000, |bench| matches!(bench.cnc.state(), State::Alarmed(_)));
        let State::Alarmed(alarm) = bench.cnc.state() else { panic!() };
        assert_eq!((alarm.fault, bench.board.fault), (fault, number));
        let axis = alarm.arguments.iter().any(|(name, _)| *name == "axis");
        assert_eq!(axis, number == 6);
    }
}

/// One contact may be wired to the board and to the ladder: whichever comes first, the alarm of the drives stands, and
/// a reset starts them anew.
#[test]
fn an_emergency_stop_beside_a_failure_of_the_drives_leaves_its_alarm() {
    for (before, behind) in [(0, 1), (0, 3), (0, 2000), (1, 0), (3, 0)] {
        let mut bench = Bench::new(&machine(""), PROGRAM, Board::new(Able::default()));
        bench.until(200, |bench| bench.board.doing == board::RUNNING);
        bench.cnc.cycle_start();
        (0..300).for_each(|_| bench.tick());
        if before > 0 {
            bench.cnc.emergency_stop();
        }
        (0..before).for_each(|_| bench.tick());
        bench.board.emergency_stop = true;
        // Some periods go by until the board is heard.
        bench.until(2000, |bench| bench.cnc.drives_have_failed());
        (0..behind).for_each(|_| bench.tick());
        if behind > 0 {
            bench.cnc.emergency_stop();
        }
        bench.until(2000, |bench| matches!(bench.cnc.state(), State::Alarmed(_)));
        assert_eq!(bench.alarm(), Fault::DriveEmergencyStop, "{before} {behind}");
        bench.board.emergency_stop = false;
        bench.cnc.reset();
        bench.until(2000, |bench| *bench.cnc.state() == State::Reset);
        assert!(!bench.cnc.drives_have_failed());
        bench.until(2000, |bench| bench.board.doing == board::RUNNING);
    }
}

#[test]
fn a_board_that_cannot_do_what_is_asked_for_is_refused() {
    let able = Able::default;
    for (able, change, fault) in [
        (Able { rate: 90_000, ..able() }, "", Fault::StepRate),
        (Able { version: 2, ..able() }, "", Fault::DrivesUnsuited),
        (Able { axes: 3, ..able() }, "", Fault::DrivesUnsuited),
        (Able { inputs: 1, ..able() }, "", Fault::DrivesUnsuited),
        (Able { buffer: 7, ..able() }, "", Fault::DrivesUnsuited),
        (Able { period_ns: [2_000_000, 4_000_000], ..able() }, "", Fault::DrivesUnsuited),
    ] {
        let mut bench = Bench::new(&machine(change), PROGRAM, Board::new(able));
        bench.until(100, |bench| matches!(bench.cnc.state(), State::Alarmed(_)));
        assert_eq!(bench.alarm(), fault);
    }
    // Pulses too long for the speed: 400 steps/mm at 250 mm/s.
    let mut slow = machine("");
    let Some(DrivesConfig::Pulse(config)) = &mut slow.drives else { panic!() };
    config.axes[0].pulse_ns = 8_000;
    let mut bench = Bench::new(&slow, PROGRAM, Board::new(Able::default()));
    bench.until(100, |bench| matches!(bench.cnc.state(), State::Alarmed(_)));
    assert_eq!(bench.alarm(), Fault::StepRate);
}

#[test]
fn a_probe_stops_where_it_touched_and_switches_are_read() {
    let mut board = Board::new(Able::default());
    board.plane = Some((2, -4000));
    let mut bench = Bench::new(&machine(""), "G31 Z-10 F600\nG0 Z#5018\nM30\n", board);
    bench.run();
    assert_eq!(bench.cnc.state(), &State::Ended);
    // 800 steps in a mm: the touch is known to a part of a step, the last place to a step.
    assert_eq!(bench.board.axes[2].count, -4000);
    let board = &mut bench.board;
    board.inputs = [0b101, 0, 0, 0, 0, 0, 0, 0];
    board.axes[0].travel = Some([10, 100]);
    (0..20).for_each(|_| bench.tick());
    let mut on = Vec::new();
    bench.cnc.drives().read(&mut |byte, bit, is_on| {
        if is_on {
            on.push((byte, bit));
        }
    });
    // X+ and the home switches are closed, X- is open.
    for (wire, is_on) in [((20, 0), true), ((20, 1), false), ((20, 2), true), ((0, 0), true), ((0, 1), false)]
    {
        assert_eq!(on.contains(&wire), is_on, "{wire:?}");
    }
    let switches = bench.cnc.drives().switches();
    assert!(switches.below.contains(Axis::X) && switches.above.is_empty() && switches.home.is_empty());
    bench.cnc.drives().write(&|byte, bit| (byte, bit) == (20, 3));
    (0..20).for_each(|_| bench.tick());
    assert_eq!(bench.board.outputs[0], 8);
}

#[test]
fn a_probe_is_waited_for_as_it_is_wired_and_until_it_is_free() {
    for opens in [false, true] {
        let mut machine = machine("");
        let Some(DrivesConfig::Pulse(config)) = &mut machine.drives else { panic!() };
        config.probe_opens = Some(opens);
        let mut board = Board::new(Able::default());
        (board.plane, board.probe_opens) = (Some((2, -4000)), opens);
        // Down to the plane at -5 mm, on into it, and up until it is free again.
        let program =
            "G38.2 Z-10 F600\n#1 = #5063\nG1 Z-7 F600\nG38.4 Z0 F600\n#2 = #5063\nG0 X[-#1] Y[-#2]\nM2\n";
        let mut bench = Bench::of(&machine, in_language("rs274", program), board);
        bench.run();
        assert_eq!(bench.cnc.state(), &State::Ended, "{opens}");
        let at = bench.last.position;
        assert!((at[Axis::X] - 5.0).abs() < 2e-3 && (at[Axis::Y] - 5.0).abs() < 2e-3, "{at:?}");
    }
}

#[test]
fn axes_home_by_the_switches_and_markers_of_the_board() {
    let mut board = Board::new(Able::default());
    board.keeps_pulses = false;
    let marker = "[parameters]\n\"NO6.6\" = 1\n";
    let mut bench = Bench::with(&machine(""), "M30\n", marker, board);
    bench.until(200, |bench| bench.board.doing == board::RUNNING);
    assert!(bench.cnc.referenced().is_empty());
    // The switch stands at 20 to 50 mm; markers every 10 mm from −3.
    bench.board.axes[0].home = Some([8000, 20_000]);
    bench.board.axes[0].markers = Some(4000);
    assert!(bench.cnc.home(Axis::X));
    bench.until(60_000, |bench| bench.cnc.referenced().contains(Axis::X) && !bench.last.moving);
    (0..50).for_each(|_| bench.tick());
    let count = bench.board.axes[0].count;
    assert!(count % 4000 == 0 && count > 8000, "{count}");
    assert_eq!(bench.last.position[Axis::X], 0.0);
}

#[test]
fn the_spindle_gets_a_speed_and_cannot_be_led() {
    let mut bench = Bench::new(
        &machine(""),
        "M3 S3000\nG4 X0.1\nM29 S500\nG84 Z-5 R0 F500\nM30\n",
        Board::new(Able::default()),
    );
    bench.until(200, |bench| bench.board.doing == board::RUNNING);
    bench.cnc.cycle_start();
    let mut most = 0;
    bench.until(20_000, |bench| {
        most = most.max(bench.board.spindle);
        !matches!(bench.cnc.state(), State::Running)
    });
    // Half of 6000 r/min.
    assert_eq!(most, 16_384);
    assert_eq!(bench.alarm(), Fault::SpindleNotLed);
}

/// A board on a socket of its own, run by the test.
struct Socketed {
    socket: UdpSocket,
    board: Board,
    from: Option<std::net::SocketAddr>,
}

impl Socketed {
    fn new() -> Socketed {
        let socket = UdpSocket::bind("127.0.0.1:0").unwrap();
        socket.set_nonblocking(true).unwrap();
        Socketed { socket, board: Board::new(Able::default()), from: None }
    }

    /// The drives that find it.
    fn connect(&mut self) -> Box<dyn Drives> {
        let mut machine = machine("");
        let Some(DrivesConfig::Pulse(config)) = &mut machine.drives else { panic!() };
        config.link = format!("udp:{}", self.socket.local_addr().unwrap()).parse().unwrap();
        // It is looked for in the background.
        let waits = std::thread::spawn(move || connect(&machine, Position::ZERO).unwrap().unwrap());
        while !waits.is_finished() {
            self.step();
            std::thread::sleep(std::time::Duration::from_millis(1));
        }
        waits.join().unwrap()
    }

    fn step(&mut self) {
        let mut bytes = [0; 4096];
        while let Ok((count, from)) = self.socket.recv_from(&mut bytes) {
            self.from = Some(from);
            self.board.feed(&bytes[..count]);
        }
        self.board.run(MS);
        let answers = self.board.take();
        if let Some(from) = self.from.filter(|_| !answers.is_empty()) {
            let _ = self.socket.send_to(&answers, from);
        }
    }
}

#[test]
fn a_period_allocates_nothing() {
    let mut board = Socketed::new();
    let mut drives = board.connect();
    // Whoever waited for it has something else to do before his first period: longer than the watchdog waits.
    (0..100).for_each(|_| board.step());
    assert_eq!(board.board.fault, 0);
    let mut furthest = 0.0_f64;
    for period in 0..2000u32 {
        let at = Position::xyz(f64::from(period) * 0.05, f64::from(period) * -0.01, 0.0);
        furthest = assert_no_alloc(|| {
            let actual = drives.exchange(&at);
            drives.turn_spindle(1000.0);
            drives.write(&|_, bit| bit == 1);
            drives.read(&mut |_, _, _| {});
            (actual.0[0] - at.0[0]).abs().max(furthest)
        });
        assert!(!drives.has_failed(), "{:?}", drives.failure(Default::default()));
        board.step();
    }
    // 50 mm/s, and what waits in the board.
    assert!((0.4..0.7).contains(&furthest), "{furthest}");
    assert_eq!((board.board.outputs[0], board.board.axes[0].put_off < 10_000.0), (2, true));
    // Silence is found within a period too.
    assert_no_alloc(|| {
        for _ in 0..100 {
            drives.exchange(&Position::ZERO);
        }
    });
    assert!(drives.has_failed());
}

/// Moves X by 20 mm over a line of bytes, the board's end of which is `far`; whether it went well.
fn moves_over(drives: &mut Pulse, board: &mut Board, far: &mut (impl Read + Write), from: f64) {
    let mut bytes = [0; 4096];
    for period in 0..10_000u32 {
        let at = Position::xyz(from + f64::from(period.saturating_sub(300).min(400)) * 0.05, 0.0, 0.0);
        drives.exchange(&at);
        assert!(!drives.has_failed(), "{:?}", drives.failure(Default::default()));
        while let Ok(count) = far.read(&mut bytes) {
            if count == 0 {
                break;
            }
            board.feed(&bytes[..count]);
        }
        board.run(MS);
        let answers = board.take();
        if !answers.is_empty() {
            far.write_all(&answers).unwrap();
        }
        if period > 700 && board.axes[0].count == ((from + 20.0) * 400.0) as i64 {
            return;
        }
        // A terminal passes bytes on when it comes to it.
        std::thread::sleep(std::time::Duration::from_micros(100));
    }
    panic!("{} steps", board.axes[0].count);
}

#[test]
fn a_connection_over_tcp_is_made_anew_after_it_broke() {
    let listener = TcpListener::bind("127.0.0.1:0").unwrap();
    let at = format!("tcp:{}", listener.local_addr().unwrap()).parse().unwrap();
    // Ample, since what carries the bytes here is not of real time.
    let machine = machine("").clone();
    let mut config = config(&machine).clone();
    (config.buffer, config.watchdog_ms) = (100, 5000.0);
    let mut drives = Pulse::new(&machine, &config, Box::new(Port::open(&at).unwrap()), Position::ZERO);
    let mut board = Board::new(Able::default());
    let (mut far, _) = listener.accept().unwrap();
    far.set_nonblocking(true).unwrap();
    moves_over(&mut drives, &mut board, &mut far, 0.0);
    drop(far);
    let at = Position::xyz(20.0, 0.0, 0.0);
    while !drives.has_failed() {
        drives.exchange(&at);
    }
    assert_eq!(drives.failure(Default::default()).unwrap().fault, Fault::DrivesCut);
    drives.restart();
    assert!(!drives.has_failed());
    let (mut far, _) = listener.accept().unwrap();
    far.set_nonblocking(true).unwrap();
    moves_over(&mut drives, &mut board, &mut far, 20.0);
    // Nobody listens any more.
    drop((far, listener));
    while !drives.has_failed() {
        drives.exchange(&at);
    }
    drives.restart();
    while !drives.has_failed() {
        drives.exchange(&at);
        std::thread::sleep(std::time::Duration::from_millis(1));
    }
    assert_eq!(drives.failure(Default::default()).unwrap().fault, Fault::DrivesCut);
}

#[test]
fn a_serial_line_carries_it_too() {
    use rustix::pty::{OpenptFlags, grantpt, openpt, ptsname, unlockpt};
    let near = openpt(OpenptFlags::RDWR | OpenptFlags::NOCTTY).unwrap();
    grantpt(&near).unwrap();
    unlockpt(&near).unwrap();
    let path = ptsname(&near, Vec::new()).unwrap().to_string_lossy().into_owned();
    let flags = rustix::fs::fcntl_getfl(&near).unwrap();
    rustix::fs::fcntl_setfl(&near, flags | rustix::fs::OFlags::NONBLOCK).unwrap();
    let mut far = File::from(near);
    let machine = machine("");
    let mut config = config(&machine).clone();
    (config.buffer, config.watchdog_ms) = (100, 5000.0);
    config.link = format!("serial:{path}:2000000").parse().unwrap();
    let port = Port::open(&config.link).unwrap();
    let mut drives = Pulse::new(&machine, &config, Box::new(port), Position::ZERO);
    moves_over(&mut drives, &mut Board::new(Able::default()), &mut far, 0.0);
    // Four axes at 1 kHz are more than half a megabaud.
    config.link = format!("serial:{path}:500000").parse().unwrap();
    let port = Port::open(&config.link).unwrap();
    let mut drives = Pulse::new(&machine, &config, Box::new(port), Position::ZERO);
    let mut board = Board::new(Able::default());
    let mut bytes = [0; 4096];
    for _ in 0..1000 {
        drives.exchange(&Position::ZERO);
        if let Ok(count) = far.read(&mut bytes) {
            board.feed(&bytes[..count]);
            far.write_all(&board.take()).unwrap();
        }
        if drives.has_failed() {
            break;
        }
        std::thread::sleep(std::time::Duration::from_millis(1));
    }
    assert_eq!(drives.failure(Default::default()).unwrap().fault, Fault::DrivesUnsuited);
}
