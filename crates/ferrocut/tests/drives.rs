//! `run --realtime` on the drives of a real machine: a board that is simulated down to the edge stands at the other end of
//! a line. Its time goes on with the setpoints, so that a computer under load makes no difference.
#![allow(missing_docs, clippy::unwrap_used, clippy::panic)]

#[path = "../../controller/tests/common/board.rs"]
mod board;
mod common;

use board::{Able, Board, frame_of};
use common::{Answer, ferrocut, json};
use ferrocut_machine::Machine;
use std::io::{Read, Write};
use std::net::TcpListener;
use std::thread;

const PROGRAM: &str = "G21 G90 G94\nM03 S2000\nG1 X4 Y2 F3000\nG2 X8 Y2 I2 J0\nG0 Z-3\nM05\nM30\n";

/// The length of a servo period, ns.
const MS: f64 = 1e6;

/// Runs the program with the drives at a board, which `meddle` sees before each of its periods; what the command said,
/// and the board behind it.
fn run(mut meddle: impl FnMut(&mut Board) + Send + 'static) -> (Answer, Board) {
    let listener = TcpListener::bind("127.0.0.1:0").unwrap();
    let folder = tempfile::tempdir().unwrap();
    let machine = Machine::DEMO_MILL
        .replace("[[axes]]\n", "[[axes]]\nin_position = 0.02\n")
        .replace("public_programs", "# public_programs");
    let drives = format!(
        "[drives]\nkind = \"pulse\"\nlink = \"tcp:{}\"\nbuffer = 8\nwatchdog_ms = 10000.0\nabsolute = true\naxes = [\n\
         {{ name = \"X\", steps = 400.0 }},\n{{ name = \"Y\", steps = 400.0, reversed = true }},\n\
         {{ name = \"Z\", steps = 800.0 }},\n]\n",
        listener.local_addr().unwrap()
    );
    let path = |name: &str| folder.path().join(name).to_str().unwrap().to_owned();
    std::fs::write(path("mill.toml"), format!("{machine}\n{drives}")).unwrap();
    std::fs::write(path("part.nc"), PROGRAM).unwrap();
    let board = thread::spawn(move || {
        let mut board = Board::new(Able::default());
        let (mut line, _) = listener.accept().unwrap();
        line.set_nodelay(true).unwrap();
        let (mut bytes, mut part) = ([0; 4096], Vec::new());
        loop {
            let count = line.read(&mut bytes).unwrap_or(0);
            if count == 0 {
                // Its time goes on without the control.
                (0..500).for_each(|_| board.run(MS));
                return board;
            }
            for byte in bytes.iter().take(count) {
                board.feed(&[*byte]);
                part.push(*byte);
                if *byte != 0 {
                    continue;
                }
                part.pop();
                let is_setpoint = frame_of(&std::mem::take(&mut part)).is_some_and(|frame| frame[0] == 3);
                if is_setpoint {
                    meddle(&mut board);
                    board.run(MS);
                }
                let answers = board.take();
                // The control may have gone.
                if !answers.is_empty() {
                    let _ = line.write_all(&answers);
                }
            }
        }
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
