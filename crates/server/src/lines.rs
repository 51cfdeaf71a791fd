//! JSON lines over sockets of this computer: a command a line, an answer a line, events as they happen
//! (`docs/serve.md`).
//!
//! Two threads a connection: one reads commands and answers them (`Connection::converse`), one writes what waits for
//! it. What a slow reader has not taken waits in a bounded queue; once that is full the connection ends.

use crate::hub::{Hub, Incoming, LONGEST_LINE, LOOK, Line, Visitor, line_of};
use crate::service::Service;
use rustix::fs::Mode;
use serde_json::json;
use std::io::{self, ErrorKind, Read, Write};
use std::net::{Shutdown, TcpListener, TcpStream};
use std::os::unix::fs::FileTypeExt;
use std::os::unix::net::{UnixListener, UnixStream};
use std::path::Path;
use std::sync::Arc;
use std::sync::atomic::{AtomicBool, Ordering};
use std::time::{Duration, Instant};
use tokio::sync::mpsc;

/// How long a write may take.
const WRITE: Duration = Duration::from_secs(2);

/// Time until a listener that failed is tried again.
const AGAIN: Duration = Duration::from_millis(100);

/// A stream of bytes that can be shared between a reader and a writer.
pub trait Stream: Read + Write + Send + Sized + 'static {
    /// Another handle of it.
    fn again(&self) -> io::Result<Self>;
    /// How long reads and writes wait.
    fn patience(&self, read: Duration, write: Duration) -> io::Result<()>;
    /// Ends it for both.
    fn end(&self);
}

impl Stream for TcpStream {
    fn again(&self) -> io::Result<TcpStream> {
        self.try_clone()
    }
    fn patience(&self, read: Duration, write: Duration) -> io::Result<()> {
        self.set_nodelay(true)?;
        self.set_read_timeout(Some(read))?;
        self.set_write_timeout(Some(write))
    }
    fn end(&self) {
        let _ = self.shutdown(Shutdown::Both);
    }
}

impl Stream for UnixStream {
    fn again(&self) -> io::Result<UnixStream> {
        self.try_clone()
    }
    fn patience(&self, read: Duration, write: Duration) -> io::Result<()> {
        self.set_read_timeout(Some(read))?;
        self.set_write_timeout(Some(write))
    }
    fn end(&self) {
        let _ = self.shutdown(Shutdown::Both);
    }
}

/// Something that streams come from.
pub trait Listener: Send + 'static {
    /// What comes.
    type Stream: Stream;
    /// The next one.
    fn next(&self) -> io::Result<Self::Stream>;
}

impl Listener for TcpListener {
    type Stream = TcpStream;
    fn next(&self) -> io::Result<TcpStream> {
        self.accept().map(|(stream, _)| stream)
    }
}

impl Listener for UnixListener {
    type Stream = UnixStream;
    fn next(&self) -> io::Result<UnixStream> {
        self.accept().map(|(stream, _)| stream)
    }
}

/// A Unix socket that only its owner may use. One that a process left behind is replaced; one that is served is not.
pub fn listen_at(path: &Path) -> io::Result<UnixListener> {
    let is_socket = std::fs::symlink_metadata(path).is_ok_and(|about| about.file_type().is_socket());
    if is_socket && UnixStream::connect(path).is_err() {
        std::fs::remove_file(path)?;
    }
    // Never open to others, not even for the moment before its rights are set.
    let before = rustix::process::umask(Mode::from_raw_mode(0o177));
    let listener = UnixListener::bind(path);
    rustix::process::umask(before);
    listener
}

/// Takes connections, until the process ends.
pub fn serve<S: Service, L: Listener>(hub: Arc<Hub<S>>, listener: L) -> io::Result<()> {
    std::thread::Builder::new().name("sockets".to_owned()).spawn(move || {
        loop {
            match listener.next() {
                Ok(stream) => {
                    let hub = hub.clone();
                    // A connection that finds no thread is ended by being dropped.
                    let _ = std::thread::Builder::new()
                        .name("connection".to_owned())
                        .spawn(move || drop(connection(&hub, stream)));
                }
                // Out of descriptors: others will be given back.
                Err(_) => std::thread::sleep(AGAIN),
            }
        }
    })?;
    Ok(())
}

/// Talks with who connected.
fn connection<S: Service, L: Stream>(hub: &Arc<Hub<S>>, mut stream: L) -> io::Result<()> {
    stream.patience(LOOK, WRITE)?;
    let Some((connection, waiting)) = hub.join(Visitor::local()) else {
        return stream
            .write_all(format!("{}\n", line_of(&json!({ "end": "too_many_connections" }))).as_bytes());
    };
    let mut writer = stream.again()?;
    let slow = connection.slow();
    std::thread::Builder::new()
        .name("writer".to_owned())
        .spawn(move || write(&mut writer, waiting, &slow))?;
    let mut lines = Lines::of(stream.again()?);
    if connection.converse(&mut lines) != "closed" {
        // Time for the reason to be read.
        std::thread::sleep(LOOK);
    }
    stream.end();
    Ok(())
}

/// Writes what waits, until nobody can add to it. A write that takes too long ends the connection.
fn write(stream: &mut impl Stream, mut waiting: mpsc::Receiver<Line>, is_slow: &AtomicBool) {
    let mut bytes = Vec::new();
    while let Some(line) = waiting.blocking_recv() {
        bytes.clear();
        bytes.extend_from_slice(line.as_bytes());
        bytes.push(b'\n');
        if stream.write_all(&bytes).is_err() {
            is_slow.store(true, Ordering::Relaxed);
            return;
        }
    }
}

/// Lines of a stream, of bounded length.
struct Lines<L> {
    stream: L,
    bytes: Vec<u8>,
    /// Bytes of it in which no line end was found.
    searched: usize,
    /// When something came last.
    heard: Instant,
    buffer: Vec<u8>,
}

impl<L: Read> Lines<L> {
    fn of(stream: L) -> Lines<L> {
        Lines { stream, bytes: Vec::new(), searched: 0, heard: Instant::now(), buffer: vec![0; 1 << 14] }
    }

    fn cut(&mut self) -> Option<Vec<u8>> {
        let rest = self.bytes.get(self.searched..)?;
        match rest.iter().position(|byte| *byte == b'\n') {
            Some(at) => {
                let end = self.searched + at;
                self.searched = 0;
                let mut line: Vec<u8> = self.bytes.drain(..=end).collect();
                line.pop();
                Some(line)
            }
            None => {
                self.searched = self.bytes.len();
                None
            }
        }
    }
}

impl<L: Read> Incoming for Lines<L> {
    fn next(&mut self) -> io::Result<Option<Vec<u8>>> {
        if let Some(line) = self.cut() {
            return Ok(Some(line));
        }
        match self.stream.read(&mut self.buffer) {
            Ok(0) => Err(io::Error::from(ErrorKind::UnexpectedEof)),
            Ok(count) => {
                self.heard = Instant::now();
                self.bytes.extend_from_slice(self.buffer.get(..count).unwrap_or(&[]));
                let line = self.cut();
                if line.is_none() && self.bytes.len() > LONGEST_LINE {
                    return Err(io::Error::from(ErrorKind::FileTooLarge));
                }
                Ok(line)
            }
            Err(e)
                if matches!(
                    e.kind(),
                    ErrorKind::WouldBlock | ErrorKind::TimedOut | ErrorKind::Interrupted
                ) =>
            {
                Ok(None)
            }
            Err(e) => Err(e),
        }
    }

    fn heard(&self) -> Instant {
        self.heard
    }
}
