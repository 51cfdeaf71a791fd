//! The way to the board: UDP, TCP or a serial line. Nothing here waits once it is open.
//!
//! What is broken is opened anew by a thread of its own, since the system may wait for that.

use ferrocut_machine::LinkAt;
use rustix::fs::{Mode, OFlags};
use rustix::termios::{ControlModes, OptionalActions, QueueSelector, tcflush, tcgetattr, tcsetattr};
use std::fs::File;
use std::io::{self, ErrorKind, Read, Write};
use std::net::{Ipv4Addr, Ipv6Addr, SocketAddr, TcpStream, ToSocketAddrs, UdpSocket};
use std::sync::mpsc::{Receiver, TryRecvError, sync_channel};
use std::time::Duration;

/// How long the system may take to open a connection.
const PATIENCE: Duration = Duration::from_secs(2);

/// A way for bytes to the board and back. Neither call waits: `WouldBlock` says that nothing could be sent, or that
/// nothing has come.
pub trait Link: Send {
    /// Sends bytes; how many were taken. Where frames travel in packets, all of them are taken or none.
    fn send(&mut self, bytes: &[u8]) -> io::Result<usize>;

    /// Takes bytes that came.
    fn receive(&mut self, into: &mut [u8]) -> io::Result<usize>;

    /// Opens it anew, as far as it is broken. It may take its time for that, in which nothing comes.
    fn reopen(&mut self) {}
}

/// An open way.
enum Way {
    Udp(UdpSocket),
    Tcp(TcpStream),
    Serial(File),
}

/// A way to the board that a machine file names.
pub struct Port {
    at: LinkAt,
    way: Option<Way>,
    opening: Option<Receiver<io::Result<Way>>>,
}

impl Port {
    /// Opens it.
    ///
    /// # Errors
    /// Those of the system: no such host or port, nobody who listens, no right.
    pub fn open(at: &LinkAt) -> io::Result<Port> {
        Ok(Port { at: at.clone(), way: Some(open(at)?), opening: None })
    }

    /// The way, once it is open.
    fn way(&mut self) -> io::Result<&mut Way> {
        if let Some(opening) = &self.opening {
            match opening.try_recv() {
                Ok(Ok(way)) => (self.way, self.opening) = (Some(way), None),
                Ok(Err(error)) => {
                    self.opening = None;
                    return Err(error);
                }
                Err(TryRecvError::Empty) => return Err(ErrorKind::WouldBlock.into()),
                Err(TryRecvError::Disconnected) => self.opening = None,
            }
        }
        self.way.as_mut().ok_or_else(|| ErrorKind::NotConnected.into())
    }
}

fn open(at: &LinkAt) -> io::Result<Way> {
    match at {
        LinkAt::Udp(place) => {
            let to = address(place)?;
            let from = if to.is_ipv4() {
                SocketAddr::from((Ipv4Addr::UNSPECIFIED, 0))
            } else {
                SocketAddr::from((Ipv6Addr::UNSPECIFIED, 0))
            };
            let socket = UdpSocket::bind(from)?;
            socket.connect(to)?;
            socket.set_nonblocking(true)?;
            Ok(Way::Udp(socket))
        }
        LinkAt::Tcp(place) => {
            let stream = TcpStream::connect_timeout(&address(place)?, PATIENCE)?;
            // Each setpoint on its way at once.
            stream.set_nodelay(true)?;
            stream.set_nonblocking(true)?;
            Ok(Way::Tcp(stream))
        }
        LinkAt::Serial(path, baud) => {
            let flags = OFlags::RDWR | OFlags::NOCTTY | OFlags::NONBLOCK | OFlags::CLOEXEC;
            let file = File::from(rustix::fs::open(path.as_str(), flags, Mode::empty())?);
            let mut settings = tcgetattr(&file)?;
            settings.make_raw();
            settings.control_modes |= ControlModes::CLOCAL | ControlModes::CREAD;
            settings.set_speed(*baud)?;
            tcsetattr(&file, OptionalActions::Now, &settings)?;
            // What stands in it is of another time.
            tcflush(&file, QueueSelector::IOFlush)?;
            Ok(Way::Serial(file))
        }
    }
}

fn address(place: &str) -> io::Result<SocketAddr> {
    place.to_socket_addrs()?.next().ok_or_else(|| ErrorKind::NotFound.into())
}

impl Link for Port {
    fn send(&mut self, bytes: &[u8]) -> io::Result<usize> {
        match self.way()? {
            Way::Udp(socket) => refused_is_silence(socket.send(bytes)),
            Way::Tcp(stream) => stream.write(bytes),
            Way::Serial(file) => file.write(bytes),
        }
    }

    fn receive(&mut self, into: &mut [u8]) -> io::Result<usize> {
        let count = match self.way()? {
            Way::Udp(socket) => return refused_is_silence(socket.recv(into)),
            Way::Tcp(stream) => stream.read(into)?,
            Way::Serial(file) => file.read(into)?,
        };
        if count == 0 { Err(ErrorKind::ConnectionAborted.into()) } else { Ok(count) }
    }

    fn reopen(&mut self) {
        if matches!(self.way, Some(Way::Udp(_))) || self.opening.is_some() {
            return;
        }
        self.way = None;
        let at = self.at.clone();
        let (answer, opening) = sync_channel(1);
        let opens = std::thread::Builder::new().name("drives".to_owned()).spawn(move || {
            let _ = answer.send(open(&at));
        });
        // Without a thread it stays closed, which is said as any other break is.
        self.opening = opens.ok().map(|_| opening);
    }
}

/// A packet that nobody listens for comes back as a refusal: the board is not there yet, or away for a moment. The
/// watchdog judges that.
fn refused_is_silence(result: io::Result<usize>) -> io::Result<usize> {
    result.map_err(|error| match error.kind() {
        ErrorKind::ConnectionRefused => ErrorKind::WouldBlock.into(),
        _ => error,
    })
}
