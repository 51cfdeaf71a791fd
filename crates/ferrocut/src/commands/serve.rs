//! `ferrocut serve`: the machine for others.

use super::plc::Source;
use crate::cli::ServeArgs;
use crate::job::{Exit, Failure, Shop};
use ferrocut_controller::control::{Control, Parts, as_delivered};
use ferrocut_machine::{Alarm, Fault, Memory};
use ferrocut_memory::Store;
use ferrocut_plc::{Limits, Program};
use ferrocut_program::Span;
use ferrocut_server::grbl::Grbl;
use ferrocut_server::hub::{self, Hub};
use ferrocut_server::lines;
use ferrocut_server::link::{self, Terminal};
use ferrocut_server::mill::Mill;
use ferrocut_server::panel::{self, Panel};
use ferrocut_server::remote::Remote;
use ferrocut_server::runner::Timing;
use ferrocut_server::signals;
use ferrocut_server::web::{Certificate, Settings, StartError, Web};
use std::fmt;
use std::io::Write;
use std::net::TcpListener;
use std::str::FromStr;
use std::sync::Arc;
use std::sync::atomic::{AtomicBool, Ordering};
use std::time::Duration;

/// Where Grbl senders connect.
#[derive(Clone, Copy, PartialEq, Eq, Debug)]
pub enum GrblAt {
    /// A TCP port of this computer.
    Tcp(u16),
    /// A pseudo-terminal.
    Terminal,
}

impl FromStr for GrblAt {
    type Err = String;

    fn from_str(text: &str) -> Result<GrblAt, String> {
        match text.split_once(':') {
            None if text == "pty" => Ok(GrblAt::Terminal),
            Some(("tcp", port)) => {
                port.parse().map(GrblAt::Tcp).map_err(|_| "give a port: tcp:2323".to_owned())
            }
            _ => Err("give tcp:PORT or pty".to_owned()),
        }
    }
}

impl fmt::Display for GrblAt {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        match self {
            GrblAt::Tcp(port) => write!(f, "tcp:{port}"),
            GrblAt::Terminal => f.write_str("pty"),
        }
    }
}

/// The ladder of a machine that names none.
const STANDARD: &str = include_str!("../../../../machines/standard.lad");

/// The program of its tool change, and the control language that this is written in.
const TOOL_CHANGE: (&str, &str) = ("gsk990mc", include_str!("../../../../machines/tool-change.nc"));

/// Runs the command.
pub fn run(args: &ServeArgs) -> Result<Exit, Failure> {
    let shop = Shop::open(&args.common())?;
    match args.grbl {
        Some(place) => serve_grbl(args, &shop, place),
        None => serve_control(args, &shop),
    }
}

fn cannot(place: impl fmt::Display) -> impl Fn(std::io::Error) -> Failure {
    move |error| Failure::cannot_serve(&place.to_string(), &error.to_string())
}

/// The machine for Grbl senders, until the process ends.
fn serve_grbl(args: &ServeArgs, shop: &Shop, place: GrblAt) -> Result<Exit, Failure> {
    if shop.machine.drives.is_some() {
        // Its homing knows no switches.
        return Err(Failure::setting(Box::new(Alarm::core(Fault::DrivesNotMeant, Span::default()))));
    }
    let mut memory = Memory::new(ferrocut_interpreter::dialects::rs274::DIALECT.name);
    shop.setup
        .apply(&mut memory)
        .map_err(|error| Failure::config("setup", &error.told(shop.diagnostics.catalogue())))?;
    let mill = Mill::new(&shop.machine, memory, shop.options());
    let mut grbl = Grbl::new(&shop.machine);
    let stops = AtomicBool::new(false);
    let start = || Remote::start(&shop.machine, mill, args.priority).map_err(cannot(place));
    match place {
        GrblAt::Tcp(port) => {
            let listener = link::listen(port).map_err(cannot(place))?;
            let at = listener.local_addr().map_err(cannot(place))?;
            let (runner, mut machine) = start()?;
            say(&format!("grbl tcp {at}"));
            tell_timing(args.timing, runner.timing());
            link::serve_tcp(&listener, &mut grbl, &mut machine, &stops).map_err(cannot(place))?;
        }
        GrblAt::Terminal => {
            let terminal = Terminal::open().map_err(cannot(place))?;
            let (runner, mut machine) = start()?;
            say(&format!("grbl pty {}", terminal.path().display()));
            tell_timing(args.timing, runner.timing());
            link::serve_terminal(&terminal, &mut grbl, &mut machine, &stops).map_err(cannot(place))?;
        }
    }
    Ok(Exit::Fine)
}

/// The whole control for JSON lines, until its thread ends.
fn serve_control(args: &ServeArgs, shop: &Shop) -> Result<Exit, Failure> {
    if let Some(address) = args.tcp.filter(|address| !address.ip().is_loopback()) {
        return Err(Failure::cannot_serve(&address.to_string(), "not an address of this computer alone"));
    }
    let ladder = match &args.ladder {
        None => Program::from_text(STANDARD.as_bytes(), &Limits::default()).ok(),
        Some(path) => Source::open(path)?.program(&shop.diagnostics),
    };
    // Its faults were told.
    let Some(ladder) = ladder else { return Ok(Exit::Finding) };
    let (language, standard) = TOOL_CHANGE;
    let with_ladder = args.ladder.is_none() && shop.machine.dialect == language;
    let tool_change = shop.tool_change()?.or_else(|| with_ladder.then(|| standard.as_bytes().to_vec()));
    let store = match &args.memory {
        None => {
            // Whoever sees it run would take what he writes as kept.
            let nothing = Alarm::core(Fault::NothingKept, Span::default()).as_warning();
            shop.diagnostics.report(&nothing, "", None);
            // Rights and histories are the same.
            Store::in_memory(&shop.machine.dialect)
                .map_err(|error| Failure::setting(Box::new(error.alarm())))?
        }
        Some(folder) => super::memory::open(folder, &shop.machine.dialect)?,
    };
    let store = Arc::new(store);
    let mut memory = as_delivered(&shop.machine).map_err(Failure::setting)?;
    shop.setup
        .apply(&mut memory)
        .map_err(|error| Failure::config("setup", &error.told(shop.diagnostics.catalogue())))?;
    let parts = Parts {
        memory: Some(memory),
        store: Some(store.clone()),
        public: shop.public_programs()?,
        tool_change,
        ladder: Some(ladder),
        ..Parts::default()
    };
    // The ladder looks at switches: a machine that its file does not describe has those of a simulated one.
    let mut machine = shop.machine.clone();
    if machine.drives.is_none() {
        machine.plant.get_or_insert_default();
    }
    let control = Control::new(&machine, parts).map_err(Failure::setting)?;
    let period = Duration::from_secs_f64(shop.machine.servo_period_ms / 1000.0);
    let aside = Some(panel::aside(Some(store.clone())));
    let (runner, hub) =
        hub::start(Panel::new(control), period, args.priority, aside).map_err(cannot("thread"))?;
    if let Some(path) = &args.socket {
        let listener = lines::listen_at(path).map_err(cannot(path.display()))?;
        lines::serve(hub.clone(), listener).map_err(cannot(path.display()))?;
        say(&format!("socket {}", path.display()));
    }
    if let Some(address) = args.tcp {
        let listener = TcpListener::bind(address).map_err(cannot(address))?;
        let at = listener.local_addr().map_err(cannot(address))?;
        lines::serve(hub.clone(), listener).map_err(cannot(address))?;
        say(&format!("tcp {at}"));
    }
    let told = signals::hear().map_err(cannot("signals"))?;
    let kept = store.clone();
    // It serves for as long as it is there.
    let _web = if args.headless {
        None
    } else {
        Some(serve_panel(args, shop, store, hub).inspect_err(|_| forget_socket(args))?)
    };
    tell_timing(args.timing, runner.timing());
    while runner.is_alive() {
        if told.load(Ordering::Relaxed) {
            forget_socket(args);
            // The control ends first, and writes what it still has.
            drop(runner);
            return Ok(last_state(&kept, shop));
        }
        std::thread::sleep(Duration::from_millis(50));
    }
    Ok(Exit::Finding)
}

/// Leaves a good state of the memory. Connections that end later still have it, so that it does not end by itself before
/// the process does.
fn last_state(store: &Store, shop: &Shop) -> Exit {
    match store.snapshot() {
        Ok(_) => Exit::Fine,
        Err(error) => {
            shop.diagnostics.report(&error.alarm(), "", None);
            Exit::Finding
        }
    }
}

/// Nobody can connect at the socket any more.
fn forget_socket(args: &ServeArgs) {
    if let Some(path) = &args.socket {
        let _ = std::fs::remove_file(path);
    }
}

/// The panel for browsers.
fn serve_panel(
    args: &ServeArgs,
    shop: &Shop,
    store: Arc<Store>,
    hub: Arc<Hub<Panel>>,
) -> Result<Web, Failure> {
    let certificate = match (&args.tls_cert, &args.tls_key) {
        (Some(chain), Some(key)) => Some(Certificate::Files { chain: chain.clone(), key: key.clone() }),
        _ => args.tls_self_signed.then(|| Certificate::Own(args.memory.clone())),
    };
    let settings = Settings {
        address: args.http,
        certificate,
        names: args.http_name.clone(),
        machine: shop.machine.clone(),
        store: Some(store),
    };
    let web = Web::start(settings, hub).map_err(|error| {
        let place = args.http.to_string();
        let alarm = |fault| Box::new(Alarm::core(fault, Span::default()).with("place", place.as_str()));
        match error {
            StartError::Io(error) => cannot(&place)(error),
            StartError::NotEncrypted => Failure::setting(alarm(Fault::PanelNotEncrypted)),
            StartError::WithoutPassword => Failure::setting(alarm(Fault::PanelWithoutPassword)),
            StartError::Certificate(unusable) => {
                let alarm = Alarm::core(Fault::Certificate, Span::default());
                let file = unusable.file.to_string_lossy().into_owned();
                Failure::setting(Box::new(alarm.with("file", file).with("reason", unusable.reason)))
            }
        }
    })?;
    if !Web::has_panel() {
        shop.diagnostics.report(&Alarm::core(Fault::PanelMissing, Span::default()).as_warning(), "", None);
    }
    say(&format!("panel {}", web.url()));
    if let Some(fingerprint) = web.fingerprint() {
        say(&format!("certificate {fingerprint}"));
    }
    Ok(web)
}

/// Says how the periods went, now and then.
fn tell_timing(every: Option<u64>, timing: Arc<Timing>) {
    let Some(seconds) = every else { return };
    std::thread::spawn(move || {
        loop {
            std::thread::sleep(Duration::from_secs(seconds.max(1)));
            eprintln!("{timing}");
        }
    });
}

/// A line for whoever started it. One that does not listen is no fault.
fn say(line: &str) {
    let mut out = std::io::stdout().lock();
    let _ = writeln!(out, "{line}").and_then(|()| out.flush());
}
