//! The panel in a browser: files, HTTP and the WebSocket, on threads of their own beside the machine's.
//!
//! In: requests. Out: answers, and what the machine is told through the [`Hub`], as over any other connection.
//!
//! `listen` takes connections and bounds them, `guard` says which requests are looked at, `session` who asks,
//! `assets` has the files of the panel. What is served under `/api` is a file each, with a function `routes`. Work
//! that takes a while is done in `work`, and programs are interpreted with a copy of the control's memory
//! (`query::desk`).

mod assets;
mod backups;
mod body;
mod check;
mod cycles;
mod dnc;
mod guard;
mod listen;
mod openapi;
mod path;
mod patient;
mod problem;
mod programs;
mod query;
mod session;
mod socket;
mod tables;
mod tls;
#[cfg(test)]
mod types;
mod work;

pub use tls::{Certificate, Unusable};

use crate::hub::Hub;
use crate::panel::Panel;
use axum::Router;
use axum::middleware::from_fn_with_state;
use ferrocut_controller::control::Library;
use ferrocut_machine::Machine;
use ferrocut_memory::Store;
use guard::Doors;
use session::Sessions;
use std::io;
use std::net::{SocketAddr, TcpListener};
use std::sync::Arc;
use std::thread::JoinHandle;
use std::time::Duration;
use tokio::runtime::{Builder, Runtime};
use tokio::sync::watch;

/// Threads that serve requests. Those that may compute are apart from them.
const THREADS: usize = 2;

/// Threads that may compute or wait, at most.
const MOST_WAITING_THREADS: usize = 64;

/// How much lower than the machine's thread these rank with the system (`nice`).
const NICE: i32 = 5;

/// How long connections may take to end when the server does.
const FAREWELL: Duration = Duration::from_secs(2);

/// How the panel is served.
#[derive(Clone)]
pub struct Settings {
    /// Where browsers connect; port 0 lets the system choose.
    pub address: SocketAddr,
    /// What connections are encrypted with.
    pub certificate: Option<Certificate>,
    /// Names that browsers may call this computer by, beside its own and its addresses.
    pub names: Vec<String>,
    /// The machine of the control.
    pub machine: Machine,
    /// The durable memory of the control, which has the passwords.
    pub store: Option<Arc<Store>>,
}

/// Why the panel is not served.
#[derive(Debug)]
pub enum StartError {
    /// The port cannot be opened.
    Io(io::Error),
    /// A certificate or key cannot be used.
    Certificate(Unusable),
    /// Other computers could connect, and connections are not encrypted.
    NotEncrypted,
    /// Other computers could connect, and nobody could log in.
    WithoutPassword,
}

impl From<io::Error> for StartError {
    fn from(error: io::Error) -> StartError {
        StartError::Io(error)
    }
}

/// What requests share.
pub(crate) struct Shared {
    /// The way to the machine.
    pub(crate) hub: Arc<Hub<Panel>>,
    /// The machine.
    pub(crate) machine: Machine,
    /// The programs of the control.
    pub(crate) library: Library,
    /// Whether a ladder runs.
    has_ladder: bool,
    store: Option<Arc<Store>>,
    sessions: Sessions,
    /// The file that DNC runs.
    dnc: dnc::Current,
    doors: Doors,
    stops: watch::Receiver<bool>,
}

/// A panel that is served, until it is dropped.
#[derive(Debug)]
pub struct Web {
    address: SocketAddr,
    fingerprint: Option<String>,
    stop: watch::Sender<bool>,
    thread: Option<JoinHandle<()>>,
}

impl Web {
    /// Opens the port and starts the threads. Beyond this computer it is opened only encrypted, and only where somebody
    /// has a password to log in with.
    pub fn start(settings: Settings, hub: Arc<Hub<Panel>>) -> Result<Web, StartError> {
        let is_local = settings.address.ip().is_loopback();
        let names = names(&settings.names);
        let has_password = || {
            let levels = settings.store.as_ref().map(|store| store.reader().levels_with_password());
            levels.is_some_and(|levels| levels.is_ok_and(|levels| !levels.is_empty()))
        };
        if !is_local && settings.certificate.is_none() {
            return Err(StartError::NotEncrypted);
        }
        if !is_local && !has_password() {
            return Err(StartError::WithoutPassword);
        }
        let opened = settings.certificate.as_ref().map(|certificate| tls::open(certificate, &names));
        let encryption = opened.transpose().map_err(StartError::Certificate)?;
        let listener = TcpListener::bind(settings.address)?;
        listener.set_nonblocking(true)?;
        let address = listener.local_addr()?;
        let runtime = runtime()?;
        let (stop, stops) = watch::channel(false);
        let look = hub.look(|panel| (panel.control().library(), panel.control().plc_mut().is_some()));
        let (library, has_ladder) = look.ok_or_else(|| io::Error::from(io::ErrorKind::NotConnected))?;
        let is_encrypted = encryption.is_some();
        let shared = Arc::new(Shared {
            hub,
            machine: settings.machine,
            library,
            has_ladder,
            store: settings.store,
            dnc: dnc::Current::default(),
            sessions: Sessions::new(!is_local, is_encrypted),
            doors: Doors { is_local, is_encrypted, names },
            stops: stops.clone(),
        });
        let (acceptor, fingerprint) =
            encryption.map_or((None, None), |made| (Some(made.acceptor), Some(made.fingerprint)));
        let thread = std::thread::Builder::new().name("web".to_owned()).spawn(move || {
            runtime.block_on(async {
                // Without a listener there is nothing to do; it was bound above.
                if let Ok(listener) = tokio::net::TcpListener::from_std(listener) {
                    listen::serve(listener, acceptor, router(shared), stops).await;
                }
            });
            runtime.shutdown_timeout(FAREWELL);
        })?;
        Ok(Web { address, fingerprint, stop, thread: Some(thread) })
    }

    /// Where it listens.
    pub fn address(&self) -> SocketAddr {
        self.address
    }

    /// What a browser is given.
    pub fn url(&self) -> String {
        let scheme = if self.fingerprint.is_some() { "https" } else { "http" };
        format!("{scheme}://{}", self.address)
    }

    /// SHA-256 of the certificate, by which people know it; none where connections are not encrypted.
    pub fn fingerprint(&self) -> Option<&str> {
        self.fingerprint.as_deref()
    }

    /// Whether the panel has been built into this program, or stands beside it in a debug build.
    pub fn has_panel() -> bool {
        assets::is_built()
    }
}

impl Drop for Web {
    fn drop(&mut self) {
        let _ = self.stop.send(true);
        if let Some(thread) = self.thread.take() {
            let _ = thread.join();
        }
    }
}

/// The names of this computer, with those given, in small letters.
fn names(given: &[String]) -> Vec<String> {
    let own = rustix::system::uname().nodename().to_string_lossy().to_ascii_lowercase();
    let mut names: Vec<String> = given.iter().map(|name| name.to_ascii_lowercase()).collect();
    let is_name = |name: &String| {
        !name.is_empty() && name.bytes().all(|b| b.is_ascii_alphanumeric() || b == b'-' || b == b'.')
    };
    names.extend([format!("{own}.local"), own]);
    names.retain(is_name);
    names
}

fn runtime() -> io::Result<Runtime> {
    Builder::new_multi_thread()
        .worker_threads(THREADS)
        .max_blocking_threads(MOST_WAITING_THREADS)
        .thread_name("web")
        .on_thread_start(|| {
            // Without it the machine runs too, only later at times.
            let _ = rustix::process::nice(NICE);
        })
        .enable_all()
        .build()
}

fn router(shared: Arc<Shared>) -> Router {
    Router::new()
        .merge(session::routes())
        .merge(socket::routes())
        .merge(check::routes())
        .merge(path::routes())
        .merge(cycles::routes())
        .merge(tables::routes())
        .merge(programs::routes())
        .merge(backups::routes())
        .merge(dnc::routes())
        .merge(openapi::routes())
        .fallback(assets::serve)
        .layer(from_fn_with_state(shared.clone(), guard::watch))
        .with_state(shared)
}
