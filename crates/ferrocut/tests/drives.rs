//! `run --realtime` on the drives of a real machine: a board that is simulated down to the edge stands at the other end of
//! a line. Its time goes on with the setpoints, so that a computer under load makes no difference.
#![allow(missing_docs, clippy::unwrap_used, clippy::panic)]

#[path = "../../controller/tests/common/board.rs"]
mod board;
mod common;

use board::{Able, Board, RUNNING, STOPPED, frame_of};
use common::served::{Front, Served};
use common::{Answer, ferrocut, json, with_input};
use ferrocut_machine::Machine;
use serde_json::{Value, json};
use std::io::{Read, Write};
use std::net::{TcpListener, TcpStream};
use std::sync::{Arc, Mutex};
use std::thread;
use std::time::{Duration, Instant};

const PROGRAM: &str = "G21 G90 G94\nM03 S2000\nG1 X4 Y2 F3000\nG2 X8 Y2 I2 J0\nG0 Z-3\nM05\nM30\n";

/// The length of a servo period, ns.
const MS: f64 = 1e6;

/// The demo mill with three of its axes at a board behind a listener: 400, 400 and 800 steps in a mm. A watchdog that
/// is ample, since what carries the bytes here is not of real time.
fn mill(listener: &TcpListener, keys: &str, of_axis: &str) -> String {
    let machine = Machine::DEMO_MILL
        .replace("[[axes]]\n", "[[axes]]\nin_position = 0.02\n")
        .replace("public_programs", "# public_programs");
    format!(
        "{machine}\n[drives]\nkind = \"pulse\"\nlink = \"tcp:{}\"\nbuffer = 8\nwatchdog_ms = 10000.0\n{keys}\naxes = [\n\
         {{ name = \"X\", steps = 400.0{of_axis} }},\n{{ name = \"Y\", steps = 400.0, reversed = true{of_axis} }},\n\
         {{ name = \"Z\", steps = 800.0{of_axis} }},\n]\n",
        listener.local_addr().unwrap()
    )
}

/// Leads a board at its end of a line until the other end is gone. Its time goes on by a period with each setpoint; while
/// none come it goes on with the requests to stop, one in eight periods.
fn lead(board: &Mutex<Board>, line: &mut TcpStream, mut meddle: impl FnMut(&mut Board)) {
    line.set_nodelay(true).unwrap();
    let (mut bytes, mut part) = ([0; 4096], Vec::new());
    loop {
        let count = line.read(&mut bytes).unwrap_or(0);
        let mut board = board.lock().unwrap();
        if count == 0 {
            // Its time goes on without the control.
            (0..500).for_each(|_| board.run(MS));
            return;
        }
        for byte in bytes.iter().take(count) {
            board.feed(&[*byte]);
            part.push(*byte);
            if *byte != 0 {
                continue;
            }
            part.pop();
            match frame_of(&std::mem::take(&mut part)).map(|frame| frame[0]) {
                Some(3) => {
                    meddle(&mut board);
                    board.run(MS);
                }
                _ => board.run(8.0 * MS),
            }
            let answers = board.take();
            // The control may have gone.
            if !answers.is_empty() {
                let _ = line.write_all(&answers);
            }
        }
    }
}

/// Runs the program with the drives at a board, which `meddle` sees before each of its periods; what the command said,
/// and the board behind it.
fn run(meddle: impl FnMut(&mut Board) + Send + 'static) -> (Answer, Board) {
    let listener = TcpListener::bind("127.0.0.1:0").unwrap();
    let folder = tempfile::tempdir().unwrap();
    let path = |name: &str| folder.path().join(name).to_str().unwrap().to_owned();
    std::fs::write(path("mill.toml"), mill(&listener, "absolute = true", "")).unwrap();
    std::fs::write(path("part.nc"), PROGRAM).unwrap();
    let board = thread::spawn(move || {
        let board = Mutex::new(Board::new(Able::default()));
        let (mut line, _) = listener.accept().unwrap();
        lead(&board, &mut line, meddle);
        board.into_inner().unwrap()
    });
    let answer = ferrocut(&[
        "run",
        &path("part.nc"),
        "--machine",
        &path("mill.toml"),
        "--realtime",
        "--format",
        "json",
    ]);
    (answer, board.join().unwrap())
}

#[test]
fn a_program_is_run_step_by_step_by_the_board() {
    let (answer, board) = run(|_| {});
    assert_eq!(answer.code, 0, "{}", answer.err);
    assert_eq!(json(&answer.out)["parts"], 1, "{}", answer.out);
    // 400, 400 and 800 steps in a mm.
    assert_eq!(board.axes.iter().map(|axis| axis.count).collect::<Vec<_>>(), [3200, 800, -2400]);
    assert_eq!((board.fault, board.unreadable), (0, 0));
    for axis in &board.axes {
        assert_eq!(axis.wrong, 0);
    }
    // The arc goes over Y 4: half a turn clockwise from (4, 2) about (6, 2).
    let mut y = 0_i64;
    let highest = board.axes[1].pulses.iter().map(|pulse| {
        y += if pulse.up { 1 } else { -1 };
        y
    });
    assert_eq!(highest.max(), Some(1600));
    assert_eq!(board.spindle, 0);
}

#[test]
fn an_emergency_stop_at_the_board_ends_the_run_with_its_alarm() {
    let (answer, board) =
        run(|board| board.emergency_stop |= board.axes.first().is_some_and(|x| x.count > 1000));
    assert_eq!(answer.code, 1, "{} {}", answer.err, answer.out);
    assert!(
        answer.err.contains("FC-1489") || answer.out.contains("FC-1489"),
        "{} {}",
        answer.out,
        answer.err
    );
    assert_eq!((board.fault, board.enabled), (5, false));
    assert!(board.axes[0].count > 1000 && board.axes[0].count < 3200, "{}", board.axes[0].count);
}

/// A router at a board: switches of the axes, a door, an emergency stop; no air, lubrication, clamp or magazine that tells
/// anything.
struct Router {
    board: Arc<Mutex<Board>>,
    front: Front,
    _served: Served,
    _folder: tempfile::TempDir,
}

/// The door, bit 0 of the board's first byte of inputs.
const DOOR_CLOSED: u8 = 1;
/// Its outputs: bits of Y0, of Y1 and of Y2.
const SPINDLE_CW: (usize, u8) = (0, 0);
const COOLANT: (usize, u8) = (0, 2);
const DOOR_LOCK: (usize, u8) = (1, 6);
const TOWER_RED: (usize, u8) = (2, 0);
const TOWER_YELLOW: (usize, u8) = (2, 1);

/// A folder in memory where the system has such: how long the disk of a busy computer takes is not looked at here.
fn folder() -> tempfile::TempDir {
    let memory = std::path::Path::new("/dev/shm");
    if memory.is_dir() { tempfile::tempdir_in(memory).unwrap() } else { tempfile::tempdir().unwrap() }
}

impl Router {
    /// Power comes on, with the emergency stop pressed.
    fn power_on() -> Router {
        let listener = TcpListener::bind("127.0.0.1:0").unwrap();
        let folder = folder();
        let path = |name: &str| folder.path().join(name).to_str().unwrap().to_owned();
        // Its motors have no markers: homing ends on the edge of the switch.
        let keys = "inputs = [1]\noutputs = [0, 1, 2]";
        let machine = mill(&listener, keys, ", limits = true") + "[parameters]\n\"NO6.6\" = 0.0\n";
        // Nor a magazine: M06 runs no program.
        assert!(machine.contains("[tool_change]\n"), "{machine}");
        let machine = machine.replace("[tool_change]\n", "[tool_change]\nprogram = 0\n");
        std::fs::write(path("mill.toml"), machine).unwrap();
        let able = Able { inputs: 1, outputs: 3, ..Able::default() };
        let mut board = Board::new(able);
        (board.emergency_stop, board.inputs[0], board.keeps_pulses) = (true, DOOR_CLOSED, false);
        let board = Arc::new(Mutex::new(board));
        let led = board.clone();
        thread::spawn(move || {
            for line in listener.incoming() {
                lead(&led, &mut line.unwrap(), |board| {
                    for axis in &mut board.axes {
                        // The home switch from 10 to 11 mm (5 to 5.5 mm of Z), travel switches far off on both sides.
                        (axis.home, axis.travel) = (Some([4000, 4400]), Some([-40_000, 20_000]));
                    }
                });
            }
        });
        let memory = path("memory");
        let password = ["memory", "password", &memory, "--level", "2", "--dialect", "gsk990mc"];
        assert_eq!(with_input(&password, "who built it\n").code, 0);
        let arguments = ["--tcp", "127.0.0.1:0", "--memory", &memory, "--machine", &path("mill.toml")];
        let served = Served::with(&arguments);
        let front = Front::new(&served);
        Router { board, front, _served: served, _folder: folder }
    }

    fn board<T>(&self, look: impl FnOnce(&mut Board) -> T) -> T {
        look(&mut self.board.lock().unwrap())
    }

    fn counts(&self) -> [i64; 3] {
        self.board(|board| std::array::from_fn(|axis| board.axes[axis].count))
    }

    fn is_on(&self, (byte, bit): (usize, u8)) -> bool {
        self.board(|board| board.outputs[byte] >> bit & 1 == 1)
    }

    /// Until the board is as it should be.
    fn awaits(&self, what: &str, is: impl Fn(&Router) -> bool) {
        let began = Instant::now();
        while !is(self) {
            assert!(began.elapsed() < Duration::from_secs(60), "never {what}");
            thread::sleep(Duration::from_millis(2));
        }
    }

    /// Changes what is kept. No period may wait for the disk, at rest neither: the board would take the control for lost.
    fn keep(&mut self, command: Value) {
        let began = Instant::now();
        let is_kept = |line: &Value| line["event"] == "changed";
        self.front.events.retain(|line| !is_kept(line));
        assert_eq!(self.front.ask(command.clone())["reply"], "on_its_way", "{command}");
        while !self.front.events.iter().any(is_kept) {
            assert!(began.elapsed() < Duration::from_secs(60), "{command}: {:?}", self.front.events);
            self.front.ask(json!({ "do": "alive" }));
            thread::sleep(Duration::from_millis(2));
        }
    }

    fn activity(&mut self, activity: &str) -> Value {
        self.front.until(activity, |status| status["activity"] == activity)
    }

    /// The emergency stop is let out, and its alarm reset.
    fn let_out_emergency_stop(&mut self) {
        self.activity("emergency");
        assert!(!self.board(|board| board.enabled));
        self.board(|board| board.emergency_stop = false);
        // What the board did by itself stays until reset.
        let status = self.activity("alarm");
        assert_eq!(status["alarms"][0]["id"], "FC-1489", "{status}");
        self.front.done(json!({ "do": "reset" }));
        self.activity("idle");
        self.awaits("on", |router| router.board(|board| board.enabled && board.doing == RUNNING));
    }

    fn start(&mut self) {
        self.front.press("KEY_AUTO");
        self.front.until("AUTO", |status| status["mode"] == "auto" && status["activity"] == "idle");
        self.front.press("KEY_START");
    }
}

/// The whole control with the standard ladder on a board.
#[test]
fn the_whole_control_drives_a_router() {
    let mut router = Router::power_on();
    router.let_out_emergency_stop();

    // Inputs that nobody wired are alarms of the ladder; relays say that the machine does not have them.
    let messages = |status: &Value| {
        let mut names: Vec<String> = serde_json::from_value(status["messages"].clone()).unwrap();
        names.sort();
        names
    };
    let told = ["MSG_AIR", "MSG_CONVEYOR", "MSG_COOLANT", "MSG_DRIVE", "MSG_LUBE"];
    router.front.until("told", |status| messages(status) == told);
    let log_in = router.front.ask(json!({ "do": "log_in", "level": 2, "password": "who built it" }));
    assert_eq!(log_in["level"], 2, "{log_in}");
    for relay in
        ["K_NO_LUBE_LEVEL", "K_NO_LUBE_PRESSURE", "K_NO_AIR", "K_NO_COOLANT", "K_NO_CONVEYOR", "K_NO_DRIVE"]
            .into_iter()
            .chain(["K_NO_CLAMP", "K_NO_A_CLAMP", "K_NO_MAGAZINE"])
    {
        router.keep(json!({ "do": "set_signal", "signal": relay, "value": 1 }));
    }
    router.front.done(json!({ "do": "reset" }));
    router.front.until("well", |status| messages(status).is_empty() && status["activity"] == "idle");

    // By the keys to the switches, whose far edges are the machine zero.
    router.front.press("KEY_R_100");
    router.front.press("KEY_HOME");
    ["KEY_Z+", "KEY_X+", "KEY_Y+"].iter().for_each(|key| router.front.hold(key));
    let is_homed = |status: &Value| status["referenced"] == json!(["X", "Y", "Z"]);
    router.front.until("homed", |status| is_homed(status) && status["activity"] == "idle");
    router.awaits("at zero", |router| router.counts() == [4400; 3]);

    // A program with a tool, the spindle and coolant.
    let text = "O1\nG90 G94 G21\nT2 M06\nM03 S1500\nG0 X-8 Y-4 Z-2\nM10\nM08\nG1 X-10 Y-5 F1200\nG3 X-14 Y-5 I-2 J0\n\
                G1 Z-5\nX-20\nM30\n";
    router.keep(json!({ "do": "store", "program": "O0001", "text": text }));
    router.front.press("KEY_AUTO");
    router.front.done(json!({ "do": "select", "program": "O1" }));
    router.start();
    router.awaits("cuts", |router| router.is_on(SPINDLE_CW) && router.is_on(COOLANT));
    // A quarter of 6000 r/min.
    assert_eq!((router.board(|board| board.spindle), router.is_on(DOOR_LOCK)), (8192, true));
    router.front.until("done", |status| status["counters"]["parts"] == 1 && status["activity"] == "idle");
    let wanted = [4400 - 20 * 400, 4400 - 5 * 400, 4400 - 5 * 800];
    router.awaits("there", |router| router.counts() == wanted);
    router.awaits("over", |router| ![SPINDLE_CW, COOLANT, DOOR_LOCK].iter().any(|at| router.is_on(*at)));
    router.board(|board| {
        assert_eq!((board.spindle, board.fault, board.unreadable, board.enabled), (0, 0, 0, true));
        assert!(board.axes.iter().all(|axis| axis.wrong == 0));
    });

    // The door is opened in a cut: feed and spindle stop, and nothing goes on before it is closed and started.
    let text = "O2\nM03 S2000\nM08\nG1 X20 F600\nM30\n";
    router.keep(json!({ "do": "store", "program": "O0002", "text": text }));
    router.front.done(json!({ "do": "select", "program": "O2" }));
    router.start();
    let passes = |place: i64| move |router: &Router| router.counts()[0] > place;
    router.awaits("on its way", passes(-3000));
    router.board(|board| board.inputs[0] &= !DOOR_CLOSED);
    let status = router.activity("held");
    assert_eq!(messages(&status), ["MSG_DOOR"]);
    router.awaits("at rest", |router| !router.is_on(SPINDLE_CW) && router.is_on(COOLANT));
    router.board(|board| board.inputs[0] |= DOOR_CLOSED);
    router.front.done(json!({ "do": "reset" }));
    router.activity("idle");

    // The emergency stop is pressed in a cut.
    router.start();
    router.awaits("goes on", passes(0));
    router.board(|board| board.emergency_stop = true);
    router.awaits("off", |router| router.board(|board| board.doing == STOPPED && !board.enabled));
    let status = router.activity("emergency");
    assert_eq!(status["referenced"], json!([]), "{status}");
    // The board has taken off all it had; the ladder has ended what the program began.
    assert_eq!(router.board(|board| (board.outputs, board.spindle)), ([0; 8], 0));
    let wanted = json!({ "COOLANT": 0, "SPINDLE_CW": 0, "TOWER_RED": 1, "*ESP": 0 });
    let names: Vec<&String> = wanted.as_object().unwrap().keys().collect();
    let signals = router.front.ask(json!({ "do": "signals", "names": names }));
    assert_eq!(signals["signals"], wanted);
    router.let_out_emergency_stop();
    router.awaits("quiet", |router| {
        router.is_on(TOWER_YELLOW) && ![SPINDLE_CW, COOLANT, TOWER_RED].iter().any(|at| router.is_on(*at))
    });
    let at = router.counts()[0];
    assert!((0..12_000).contains(&at), "{at}");
    router.board(|board| assert!(board.axes.iter().all(|axis| axis.wrong == 0)));
}
