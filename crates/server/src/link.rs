//! Connections of Grbl senders: TCP on this computer, or a pseudo-terminal that looks like a serial port.
//!
//! One sender at a time has the machine. Bytes are taken as they come, and answers are sent as fast as they are taken;
//! whoever takes none for five seconds is cut off.

use crate::grbl::{Grbl, Machine};
use rustix::fs::{OFlags, fcntl_getfl, fcntl_setfl};
use rustix::pty::{OpenptFlags, grantpt, openpt, ptsname, unlockpt};
use rustix::termios::{OptionalActions, QueueSelector, tcflush, tcgetattr, tcsetattr};
use std::fs::File;
use std::io::{self, ErrorKind, Read, Write};
use std::net::{IpAddr, Ipv4Addr, SocketAddr, TcpListener, TcpStream};
use std::path::{Path, PathBuf};
use std::sync::atomic::{AtomicBool, Ordering};
use std::time::{Duration, Instant};

/// Time between two looks at a connection.
const LOOK: Duration = Duration::from_millis(1);

/// Time between two looks for a sender.
const ACCEPT: Duration = Duration::from_millis(20);

/// How long a reader may take nothing of what it is sent.
const PATIENCE: Duration = Duration::from_secs(5);

/// Bytes taken at once.
const CHUNK: usize = 4096;

/// A port on this computer; 0 lets the system choose. Nobody else can reach it.
pub fn listen(port: u16) -> io::Result<TcpListener> {
    TcpListener::bind(SocketAddr::new(IpAddr::V4(Ipv4Addr::LOCALHOST), port))
}

/// How a connection goes on.
#[derive(Clone, Copy, PartialEq, Eq, Debug)]
enum Goes {
    On,
    Ended,
}

/// A connection with what is still to be sent.
struct Line<L> {
    link: L,
    unsent: Vec<u8>,
    /// Since when nothing of it was taken.
    stuck: Option<Instant>,
    buffer: Vec<u8>,
}

impl<L: Read + Write> Line<L> {
    fn new(link: L) -> Line<L> {
        Line { link, unsent: Vec::new(), stuck: None, buffer: vec![0; CHUNK] }
    }

    /// Takes what came, does what can be done, sends what there is to say.
    fn step(&mut self, grbl: &mut Grbl, machine: &mut dyn Machine) -> Goes {
        match self.link.read(&mut self.buffer) {
            Ok(0) => return Goes::Ended,
            Ok(count) => grbl.receive(self.buffer.get(..count).unwrap_or(&[]), machine),
            Err(error) if is_later(&error) => {}
            Err(_) => return Goes::Ended,
        }
        grbl.poll(machine);
        if self.unsent.is_empty() {
            self.unsent = grbl.take_output().into_bytes();
        }
        if self.unsent.is_empty() {
            self.stuck = None;
            return Goes::On;
        }
        match self.link.write(&self.unsent) {
            Ok(0) => return Goes::Ended,
            Ok(count) => {
                self.unsent.drain(..count.min(self.unsent.len()));
                self.stuck = None;
            }
            Err(error) if is_later(&error) => {
                let since = *self.stuck.get_or_insert_with(Instant::now);
                if since.elapsed() > PATIENCE {
                    return Goes::Ended;
                }
            }
            Err(_) => return Goes::Ended,
        }
        Goes::On
    }
}

fn is_later(error: &io::Error) -> bool {
    matches!(error.kind(), ErrorKind::WouldBlock | ErrorKind::Interrupted | ErrorKind::TimedOut)
}

/// Serves one sender after the other, until `stops`.
pub fn serve_tcp(
    listener: &TcpListener,
    grbl: &mut Grbl,
    machine: &mut dyn Machine,
    stops: &AtomicBool,
) -> io::Result<()> {
    listener.set_nonblocking(true)?;
    let mut line: Option<Line<TcpStream>> = None;
    let mut looked = Instant::now();
    while !stops.load(Ordering::Relaxed) {
        if line.is_none() || looked.elapsed() > ACCEPT {
            looked = Instant::now();
            if let Ok((stream, _)) = listener.accept() {
                match line {
                    None => {
                        // Each answer on its way at once.
                        stream.set_nodelay(true)?;
                        stream.set_nonblocking(true)?;
                        grbl.connect(machine);
                        line = Some(Line::new(stream));
                    }
                    Some(_) => {
                        let _ = (&stream).write_all(b"[MSG:Another sender has the machine]\r\n");
                    }
                }
            }
        }
        match &mut line {
            None => {
                grbl.poll(machine);
                std::thread::sleep(ACCEPT);
            }
            Some(open) => {
                if open.step(grbl, machine) == Goes::Ended {
                    grbl.disconnect(machine);
                    line = None;
                } else {
                    std::thread::sleep(LOOK);
                }
            }
        }
    }
    Ok(())
}

/// A pseudo-terminal whose other end looks like a serial port.
#[derive(Debug)]
pub struct Terminal {
    near: File,
    /// Kept open, so that a sender may come and go.
    far: File,
    path: PathBuf,
}

impl Terminal {
    /// Opens one.
    pub fn open() -> io::Result<Terminal> {
        let near = openpt(OpenptFlags::RDWR | OpenptFlags::NOCTTY | OpenptFlags::CLOEXEC)?;
        grantpt(&near)?;
        unlockpt(&near)?;
        let path = ptsname(&near, Vec::new())?;
        let path = PathBuf::from(path.to_string_lossy().into_owned());
        let far = File::options().read(true).write(true).open(&path)?;
        // Bytes as they are: no echo, no line ends made of others.
        let mut attributes = tcgetattr(&far)?;
        attributes.make_raw();
        tcsetattr(&far, OptionalActions::Now, &attributes)?;
        fcntl_setfl(&near, fcntl_getfl(&near)? | OFlags::NONBLOCK)?;
        Ok(Terminal { near: File::from(near), far, path })
    }

    /// What senders open.
    pub fn path(&self) -> &Path {
        &self.path
    }
}

/// Serves the senders at a pseudo-terminal, until `stops`. They come and go unseen: like a controller on a serial port
/// it greets at its start, and behind a reset.
pub fn serve_terminal(
    terminal: &Terminal,
    grbl: &mut Grbl,
    machine: &mut dyn Machine,
    stops: &AtomicBool,
) -> io::Result<()> {
    let mut line = Line::new(&terminal.near);
    grbl.connect(machine);
    while !stops.load(Ordering::Relaxed) {
        if line.step(grbl, machine) == Goes::Ended {
            // Nobody reads: what was said is forgotten, and nothing goes on unseen.
            grbl.disconnect(machine);
            let _ = tcflush(&terminal.far, QueueSelector::IFlush);
            line = Line::new(&terminal.near);
        }
        std::thread::sleep(LOOK);
    }
    Ok(())
}
