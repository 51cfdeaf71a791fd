//! A board without metal on the real clock, for a control to drive: counts steps and judges every edge.
//!
//! `pulse_board udp PORT | tcp PORT | pty [SECONDS]` prints how it stands once a second.
#![allow(missing_docs)]

#[path = "../tests/common/board.rs"]
mod board;

use board::{Able, Board, STOPPED};
use std::fs::File;
use std::io::{self, ErrorKind, Read, Write};
use std::net::{SocketAddr, TcpListener, TcpStream, UdpSocket};
use std::time::{Duration, Instant};

/// The steps from and to which each home switch is reached, from where the axis stands as power comes.
const HOME: [i64; 2] = [8000, 8800];

/// Time between two looks at the line.
const LOOK: Duration = Duration::from_micros(200);

/// The line to the control.
enum Line {
    Udp(UdpSocket, Option<SocketAddr>),
    Tcp(TcpListener, Option<TcpStream>),
    Pty(File),
}

impl Line {
    fn open(words: &[String]) -> io::Result<Line> {
        let port = || words.get(1).and_then(|port| port.parse::<u16>().ok()).ok_or(ErrorKind::InvalidInput);
        match words.first().map(String::as_str) {
            Some("udp") => {
                let socket = UdpSocket::bind(("127.0.0.1", port()?))?;
                socket.set_nonblocking(true)?;
                println!("udp:{}", socket.local_addr()?);
                Ok(Line::Udp(socket, None))
            }
            Some("tcp") => {
                let listener = TcpListener::bind(("127.0.0.1", port()?))?;
                listener.set_nonblocking(true)?;
                println!("tcp:{}", listener.local_addr()?);
                Ok(Line::Tcp(listener, None))
            }
            Some("pty") => {
                use rustix::pty::{OpenptFlags, grantpt, openpt, ptsname, unlockpt};
                let near = openpt(OpenptFlags::RDWR | OpenptFlags::NOCTTY)?;
                grantpt(&near)?;
                unlockpt(&near)?;
                println!("serial:{}:2000000", ptsname(&near, Vec::new())?.to_string_lossy());
                let flags = rustix::fs::fcntl_getfl(&near)?;
                rustix::fs::fcntl_setfl(&near, flags | rustix::fs::OFlags::NONBLOCK)?;
                Ok(Line::Pty(File::from(near)))
            }
            _ => Err(ErrorKind::InvalidInput.into()),
        }
    }

    fn receive(&mut self, into: &mut [u8]) -> io::Result<usize> {
        match self {
            Line::Udp(socket, from) => {
                let (count, sender) = socket.recv_from(into)?;
                *from = Some(sender);
                Ok(count)
            }
            Line::Tcp(listener, stream) => {
                if let Ok((new, _)) = listener.accept() {
                    new.set_nodelay(true)?;
                    new.set_nonblocking(true)?;
                    *stream = Some(new);
                }
                stream.as_mut().map_or(Err(ErrorKind::WouldBlock.into()), |stream| stream.read(into))
            }
            Line::Pty(file) => file.read(into),
        }
    }

    fn send(&mut self, bytes: &[u8]) {
        // What a line does not take is lost, as on a wire.
        let _ = match self {
            Line::Udp(socket, Some(to)) => socket.send_to(bytes, *to),
            Line::Tcp(_, Some(stream)) => stream.write(bytes),
            Line::Pty(file) => file.write(bytes),
            _ => Ok(0),
        };
    }
}

fn main() -> io::Result<()> {
    let words: Vec<String> = std::env::args().skip(1).collect();
    let Ok(mut line) = Line::open(&words) else {
        eprintln!("pulse_board udp PORT | tcp PORT | pty [SECONDS]");
        std::process::exit(2);
    };
    let seconds: u64 =
        words.last().and_then(|text| text.parse().ok()).filter(|_| words.len() > 2).unwrap_or(u64::MAX);
    let mut board = Board::new(Able { outputs: 3, ..Able::default() });
    // One that runs for hours remembers no pulse, but judges each.
    board.keeps_pulses = false;
    // X1 and X2 of a machine that is well: all that it has, the tool and the A axis clamped, the magazine away.
    [board.inputs[0], board.inputs[1]] = [0b0111_1111, 0b0100_0101];
    let began = Instant::now();
    let (mut at, mut shown) = (began, 0);
    let mut bytes = [0; 4096];
    while began.elapsed().as_secs() < seconds {
        while let Ok(count) = line.receive(&mut bytes) {
            if count == 0 {
                break;
            }
            board.feed(bytes.get(..count).unwrap_or(&[]));
        }
        for axis in &mut board.axes {
            axis.home = Some(HOME);
        }
        let now = Instant::now();
        board.run((now - at).as_nanos() as f64);
        at = now;
        let answers = board.take();
        if !answers.is_empty() {
            line.send(&answers);
        }
        if began.elapsed().as_secs() != shown {
            shown = began.elapsed().as_secs();
            let counts: Vec<i64> = board.axes.iter().map(|axis| axis.count).collect();
            let wrong: u64 = board.axes.iter().map(|axis| axis.wrong).sum();
            let put_off = board.axes.iter().map(|axis| axis.put_off).fold(0.0, f64::max) / 1000.0;
            let doing = if board.doing == STOPPED { "stopped" } else { "" };
            println!(
                "{shown} s: steps {counts:?}, wrong pulses {wrong}, put off by {put_off:.1} us, {:.1} wait, unreadable {}, \
                 spindle {}, outputs {:02X?}, fault {} {doing}",
                board.level,
                board.unreadable,
                board.spindle,
                &board.outputs[..3],
                board.fault
            );
        }
        std::thread::sleep(LOOK);
    }
    Ok(())
}
