//! The command line.

use crate::commands::explain::ExplainArgs;
use crate::commands::machine::MachineArgs;
use crate::commands::memory::MemoryArgs;
use crate::commands::plc::PlcArgs;
use crate::view::{DEFAULT_WIDTH, WIDTHS};
use clap::{Args, CommandFactory, FromArgMatches, Parser, Subcommand, ValueEnum};
use ferrocut_machine::Language;
use std::path::{Path, PathBuf};

/// What `ferrocut` is asked to do.
#[derive(Parser)]
#[command(
    name = "ferrocut",
    version,
    about = "An open CNC: check, simulate, time and run part programs",
    long_about = "An open CNC: check, simulate, time and run part programs of industrial milling controls.\n\n\
        The same engine interprets a program at a desk and on a machine: what `check` says is what the\n\
        machine does.\n\n\
        Exit status: 0 fine, 1 an alarm or a finding, 2 wrong use.",
    after_help = "Examples:\n  \
        ferrocut check part.nc                    every fault of a program, not only the first\n  \
        ferrocut run part.nc                      run it on a simulated machine and report times\n  \
        ferrocut time part.nc --machine mill.toml how long it takes on your machine\n  \
        ferrocut view part.nc -o part.png         a picture of the path\n  \
        ferrocut plot part.nc -o part.svg         velocity, acceleration, jerk, path error over time\n  \
        ferrocut import plate.dxf -o plate.nc     a drawing to a part program\n  \
        ferrocut explain G84                      what a code is, and which parameters bear on it\n  \
        cat part.nc | ferrocut trace -            every step as a line of JSON"
)]
pub struct Cli {
    /// The command.
    #[command(subcommand)]
    pub command: Command,
}

impl Cli {
    /// Reads the command line. A drawing has no blocks that a switch could leave out or stop at.
    pub fn read() -> Cli {
        let switches = ["block_skip", "optional_stop"];
        let refuse = |import: clap::Command, switch| {
            import.mut_arg(switch, |switch| switch.hide(true).conflicts_with("file"))
        };
        let command =
            Cli::command().mut_subcommand("import", |import| switches.into_iter().fold(import, refuse));
        Cli::from_arg_matches(&command.get_matches()).unwrap_or_else(|error| error.exit())
    }
}

/// The commands.
#[derive(Subcommand)]
pub enum Command {
    /// Run a part program on the machine (simulated, as fast as it can)
    Run(RunArgs),
    /// Find every fault of part programs: syntax, alarms, travel limits, spindle, tools
    Check(CheckArgs),
    /// Print the steps of a part program as JSON lines
    Trace(TraceArgs),
    /// Predict how long a part program takes
    Time(TimeArgs),
    /// Draw the tool path (PNG or SVG)
    View(ViewArgs),
    /// Plot velocity, acceleration, jerk and path error over time (SVG)
    #[command(
        long_about = "Plot velocity, acceleration, jerk and path error over time (SVG), to tune a machine.\n\n\
            The program is run as `run` runs it. Panels under each other show the speed along the path with\n\
            the programmed feed, velocity, acceleration and jerk of each axis with the limits of the machine\n\
            file, and how far the axes are from the programmed lines and arcs.\n\n\
            Quantities are differences over the servo period, jerk a mean over the shortest window in which\n\
            rounding stays below 1 % of the limit; the plot says how long. A long run becomes columns of\n\
            lowest and highest, so no peak is lost; --from and --to look closer.\n\n\
            --format json gives the highest of each in numbers: with time, line and share of the limit.",
        after_help = "Examples:\n  \
            ferrocut plot part.nc > part.svg\n  \
            ferrocut plot part.nc --machine mill.toml --axes XY --from 12 --to 12.5 -o corner.svg\n  \
            ferrocut plot part.nc --machine mill.toml --format json"
    )]
    Plot(PlotArgs),
    /// Turn a drawing (PLT, DXF) into a part program
    #[command(
        long_about = "Turn a drawing (PLT, DXF) into a part program.\n\n\
            Lines and arcs stay what they are; ellipses and splines become arcs within --tolerance.\n\
            Curves that meet are joined, what lies inside a contour is cut before the contour, tools are\n\
            changed as seldom as that allows, and the ways between are kept short (--order as-drawn keeps\n\
            the order of the drawing).\n\n\
            The drawing's zero is the work zero of G54. Depths are work Z. What is not given is cut at\n\
            Z-1 with 600 mm/min, lowered with 300 mm/min, and crossed over at Z5.\n\n\
            A set-up file can say the same in a table [import], with format = \"plt\" or \"dxf\" for --from,\n\
            pen_up for --safe and pen_down for --depth; options of the command line win. Every command\n\
            that takes a program takes a drawing too, and runs it in the order of the drawing.",
        after_help = "Examples:\n  \
            ferrocut import plate.dxf -o plate.nc --depth=-3 --feed 800 --spindle 6000\n  \
            ferrocut import plate.dxf --layer HOLES=-6,1 --layer OUTLINE=-6.2,2,F500 --layer ENGRAVING=skip\n  \
            ferrocut import sign.plt --to weihong --pen 2=-0.5 -o sign.nc --picture sign.svg\n  \
            ferrocut trace plate.dxf                  the drawing as steps, without a program"
    )]
    Import(Box<ImportArgs>),
    /// Explain a code, parameter, alarm, macro variable or word of a program
    Explain(ExplainArgs),
    /// Machine files, and the parameters of the control in them
    Machine(MachineArgs),
    /// What a control keeps while its power is off: show, check, back up, restore, recover
    Memory(MemoryArgs),
    /// Ladders of the PLC: check them, run them at a desk, import them from PLCopen XML
    Plc(PlcArgs),
    /// Run the control with its panel in a browser, or offer the machine to other programs on this computer
    #[command(
        long_about = "Run the control with its panel in a browser, or offer the machine to other programs.\n\n\
            The panel is at http://127.0.0.1:8080 and can be reached from this computer only. With --http another\n\
            address is taken; beyond this computer connections must be encrypted (--tls-cert, --tls-self-signed), and\n\
            people log in with a password of the memory. Ctrl-C ends it.\n\n\
            With --headless there is no panel:\n\n\
            With --grbl the machine speaks the protocol of Grbl 1.1, so that senders made for it connect,\n\
            home, jog, stream programs, hold, override and read positions. Programs are RS274/NGC as Grbl\n\
            takes it, run with look-ahead, within the limits of the machine file, at true speed.\n\n\
            tcp:PORT listens on this computer only (0 lets the system choose); pty makes a pseudo-terminal\n\
            that looks like a serial port. What was opened is printed in one line: `grbl tcp 127.0.0.1:2323`.\n\n\
            With --socket or --tcp it is the whole control with ladder, modes and memory, and takes the commands\n\
            of docs/api.md as JSON lines.\n\n\
            docs/serve.md has both protocols, how each sender is connected, and what differs from Grbl.",
        after_help = "Examples:\n  \
            ferrocut serve --memory /var/lib/ferrocut\n  \
            ferrocut serve --memory /var/lib/ferrocut --http 0.0.0.0:8443 --tls-self-signed\n  \
            ferrocut serve --headless --grbl tcp:2323\n  \
            ferrocut serve --headless --socket /run/ferrocut.sock --memory /var/lib/ferrocut\n  \
            ferrocut serve --headless --grbl pty --machine mill.toml"
    )]
    Serve(ServeArgs),
}

/// What every command that reads a program takes.
#[derive(Args, Clone, Default)]
pub struct Common {
    /// Control language of the program [default: that of the set-up file; else guessed from the program, the
    /// machine's before others]
    #[arg(long, value_name = "NAME")]
    pub dialect: Option<String>,
    /// Machine file: axes, limits, speeds [default: the built-in demo mill]
    #[arg(long, value_name = "FILE")]
    pub machine: Option<PathBuf>,
    /// Programs that come with the machine and may stand for codes (public.dat) [default: those of the
    /// machine file]
    #[arg(long, value_name = "FILE")]
    pub public: Option<PathBuf>,
    /// Set-up file: work offsets, tool offsets, parameters, start position
    #[arg(long, value_name = "FILE")]
    pub setup: Option<PathBuf>,
    /// Tool table of LinuxCNC (.tbl), in mm; for programs of rs274
    #[arg(long, value_name = "FILE")]
    pub tool_table: Option<PathBuf>,
    /// Parameter file of LinuxCNC (.var), in mm; for programs of rs274
    #[arg(long, value_name = "FILE")]
    pub var_file: Option<PathBuf>,
    /// How results are printed.
    #[command(flatten)]
    pub show: Show,
    /// Leave out blocks with a single `/`, as with the operator's switch on
    #[arg(long)]
    pub block_skip: bool,
    /// Stop at M01, as with the operator's switch on
    #[arg(long)]
    pub optional_stop: bool,
}

impl Common {
    /// The files that are read beside the program.
    pub fn files(&self) -> impl Iterator<Item = &Path> {
        let files = [&self.machine, &self.public, &self.setup, &self.tool_table, &self.var_file];
        files.into_iter().filter_map(|file| file.as_deref())
    }
}

/// How results are printed, by every command.
#[derive(Args, Clone, Default)]
pub struct Show {
    /// How results are printed; JSON is one object a line
    #[arg(long, value_enum, default_value_t = Format::Text)]
    pub format: Format,
    /// Language of labels and messages: en, zh, ru, es or tr [default: from LANG]
    #[arg(long, value_name = "LANGUAGE", value_parser = language)]
    pub language: Option<String>,
}

impl Show {
    /// What a command that reads no program shares with those that do.
    pub fn common(&self, machine: Option<PathBuf>, dialect: Option<String>) -> Common {
        Common { machine, dialect, show: self.clone(), ..Common::default() }
    }
}

/// The form of results.
#[derive(Clone, Copy, PartialEq, Eq, Default, ValueEnum)]
pub enum Format {
    /// For people
    #[default]
    Text,
    /// For programs
    Json,
}

/// `ferrocut run`
#[derive(Args)]
pub struct RunArgs {
    /// The part program; - reads standard input
    #[arg(value_name = "FILE")]
    pub file: PathBuf,
    /// What every command takes.
    #[command(flatten)]
    pub common: Common,
    /// Run at true speed instead of as fast as possible
    #[arg(long)]
    pub realtime: bool,
    /// Take the program up at this line, of a subprogram too: what lies before it is interpreted without motion,
    /// then the axes go there one by one. PASS says the how manieth time a line that is run several times is
    /// reached; FILE names a file beside the program
    #[arg(long, value_name = "[FILE:]LINE[:PASS]", value_parser = Place::parse)]
    pub from: Option<Place>,
    /// Write the position of every axis each servo period to this CSV file; - is standard output
    #[arg(long, value_name = "FILE")]
    pub samples: Option<PathBuf>,
    /// Feed override in percent, 1 to 200
    #[arg(long, value_name = "PERCENT", default_value_t = 100.0, value_parser = percent::<200>)]
    pub feed_override: f64,
    /// Rapid override in percent, 1 to 100
    #[arg(long, value_name = "PERCENT", default_value_t = 100.0, value_parser = percent::<100>)]
    pub rapid_override: f64,
}

/// `ferrocut check`
#[derive(Args)]
pub struct CheckArgs {
    /// The part programs; - reads standard input
    #[arg(value_name = "FILE", required = true)]
    pub files: Vec<PathBuf>,
    /// What every command takes.
    #[command(flatten)]
    pub common: Common,
}

/// `ferrocut trace`
#[derive(Args)]
pub struct TraceArgs {
    /// The part program; - reads standard input
    #[arg(value_name = "FILE")]
    pub file: PathBuf,
    /// What every command takes.
    #[command(flatten)]
    pub common: Common,
}

/// `ferrocut time`
#[derive(Args)]
pub struct TimeArgs {
    /// The part program; - reads standard input
    #[arg(value_name = "FILE")]
    pub file: PathBuf,
    /// What every command takes.
    #[command(flatten)]
    pub common: Common,
}

/// `ferrocut view`
#[derive(Args)]
pub struct ViewArgs {
    /// The part program; - reads standard input
    #[arg(value_name = "FILE")]
    pub file: PathBuf,
    /// The picture: a .png or .svg file
    #[arg(short, long, value_name = "FILE")]
    pub output: PathBuf,
    /// What every command takes.
    #[command(flatten)]
    pub common: Common,
    /// Width of the picture in pixels, 400 to 10000
    #[arg(long, default_value_t = DEFAULT_WIDTH, value_parser = clap::value_parser!(u32).range(WIDTHS))]
    pub width: u32,
}

/// `ferrocut plot`
#[derive(Args)]
pub struct PlotArgs {
    /// The part program; - reads standard input
    #[arg(value_name = "FILE")]
    pub file: PathBuf,
    /// The SVG file to write; - is standard output, which leaves standard error for JSON [default: standard output;
    /// none with --format json]
    #[arg(short, long, value_name = "FILE")]
    pub output: Option<PathBuf>,
    /// Axes by their letters, such as XYZ [default: those that move]
    #[arg(long, value_name = "LETTERS")]
    pub axes: Option<String>,
    /// Where the plot begins, seconds since motion began
    #[arg(long, value_name = "SECONDS", default_value_t = 0.0, value_parser = seconds)]
    pub from: f64,
    /// Where it ends [default: with the program]
    #[arg(long, value_name = "SECONDS", value_parser = seconds)]
    pub to: Option<f64>,
    /// Feed override in percent, 1 to 200
    #[arg(long, value_name = "PERCENT", default_value_t = 100.0, value_parser = percent::<200>)]
    pub feed_override: f64,
    /// Rapid override in percent, 1 to 100
    #[arg(long, value_name = "PERCENT", default_value_t = 100.0, value_parser = percent::<100>)]
    pub rapid_override: f64,
    /// What every command takes.
    #[command(flatten)]
    pub common: Common,
}

/// `ferrocut serve`
#[derive(Args)]
#[command(group(clap::ArgGroup::new("others").multiple(true)))]
pub struct ServeArgs {
    /// Without a panel
    #[arg(long, requires = "others")]
    pub headless: bool,
    /// Where browsers find the panel; port 0 lets the system choose
    #[arg(long, value_name = "ADDRESS", default_value = "127.0.0.1:8080", conflicts_with = "headless")]
    pub http: std::net::SocketAddr,
    /// Encrypt the panel's connections with this certificate chain (PEM)
    #[arg(long, value_name = "FILE", requires = "tls_key", conflicts_with = "headless")]
    pub tls_cert: Option<PathBuf>,
    /// Private key of the certificate (PEM)
    #[arg(long, value_name = "FILE", requires = "tls_cert")]
    pub tls_key: Option<PathBuf>,
    /// Encrypt them with a certificate that this computer makes for itself, kept with the memory
    #[arg(long, conflicts_with_all = ["tls_cert", "headless"])]
    pub tls_self_signed: bool,
    /// A name that browsers may call this computer by, beside its own. May be given several times
    #[arg(long, value_name = "NAME", conflicts_with = "headless")]
    pub http_name: Vec<String>,
    /// Where Grbl senders connect, who have the machine for themselves: tcp:PORT or pty
    #[arg(long, value_name = "WHERE", requires = "headless", group = "others")]
    pub grbl: Option<crate::commands::serve::GrblAt>,
    /// Unix socket of the control's own commands, as JSON lines
    #[arg(long, value_name = "PATH", conflicts_with = "grbl", group = "others")]
    pub socket: Option<PathBuf>,
    /// The same over TCP on this computer, such as 127.0.0.1:7878; port 0 lets the system choose
    #[arg(long, value_name = "ADDRESS", conflicts_with = "grbl", group = "others")]
    pub tcp: Option<std::net::SocketAddr>,
    /// Folder of what the control keeps without power [default: nothing is kept]
    #[arg(long, value_name = "DIR", conflicts_with = "grbl", value_parser = crate::commands::memory::folder())]
    pub memory: Option<PathBuf>,
    /// Ladder of the machine, a mnemonic list or PLCopen XML [default: the standard one]
    #[arg(long, value_name = "FILE", conflicts_with = "grbl")]
    pub ladder: Option<PathBuf>,
    /// Run the machine before all other work of this computer, where it lets us: 1 to 99 (SCHED_FIFO)
    #[arg(long, value_name = "PRIORITY", value_parser = clap::value_parser!(u8).range(1..=99))]
    pub priority: Option<u8>,
    /// Say on standard error every so many seconds how long the periods took and how late they began
    #[arg(long, value_name = "SECONDS")]
    pub timing: Option<u64>,
    /// Machine file: axes, limits, speeds, control language [default: the built-in demo mill]
    #[arg(long, value_name = "FILE")]
    pub machine: Option<PathBuf>,
    /// Programs that come with the machine and may stand for codes (public.dat) [default: those of the
    /// machine file]
    #[arg(long, value_name = "FILE", conflicts_with = "grbl")]
    pub public: Option<PathBuf>,
    /// Set-up file for a control that keeps nothing: work offsets, tool offsets, parameters and variables at its start
    #[arg(long, value_name = "FILE", conflicts_with = "memory")]
    pub setup: Option<PathBuf>,
    /// How results are printed.
    #[command(flatten)]
    pub show: Show,
    /// Leave out blocks with a single `/` that a Grbl sender streams
    #[arg(long, requires = "headless", conflicts_with_all = ["socket", "tcp"])]
    pub block_skip: bool,
    /// Stop at M01 of a Grbl sender
    #[arg(long, requires = "headless", conflicts_with_all = ["socket", "tcp"])]
    pub optional_stop: bool,
}

impl ServeArgs {
    /// What it shares with the commands that read a program.
    pub fn common(&self) -> Common {
        Common {
            public: self.public.clone(),
            setup: self.setup.clone(),
            block_skip: self.block_skip,
            optional_stop: self.optional_stop,
            ..self.show.common(self.machine.clone(), None)
        }
    }
}

/// `ferrocut import`
#[derive(Args)]
pub struct ImportArgs {
    /// The drawing; - reads standard input
    #[arg(value_name = "FILE")]
    pub file: PathBuf,
    /// The part program to write [default: standard output]
    #[arg(short, long, value_name = "FILE")]
    pub output: Option<PathBuf>,
    /// Control language of the program: gsk990mc, kaitong or weihong [default: that of --dialect, set-up or machine]
    #[arg(long, value_name = "NAME")]
    pub to: Option<String>,
    /// Draw the path too: a .png or .svg file
    #[arg(long, value_name = "FILE")]
    pub picture: Option<PathBuf>,
    /// Width of the picture in pixels, 400 to 10000
    #[arg(long, default_value_t = DEFAULT_WIDTH, value_parser = clap::value_parser!(u32).range(WIDTHS))]
    pub width: u32,
    /// Kind of drawing, plt or dxf, where neither name nor content tell
    #[arg(long, value_name = "KIND")]
    pub from: Option<String>,
    /// How far arcs may lie from ellipses and splines, mm [default: 0.01]
    #[arg(long, value_name = "MM", help_heading = "Shape")]
    pub tolerance: Option<f64>,
    /// shortest, or as-drawn [default: shortest]
    #[arg(long, value_name = "ORDER", help_heading = "Shape")]
    pub order: Option<String>,
    /// Factor on top of the unit [default: 1]
    #[arg(long, value_name = "FACTOR", help_heading = "Shape")]
    pub scale: Option<f64>,
    /// Unit of a DXF drawing: mm, cm, m, inch, foot, mil, um [default: as the drawing says, else mm]
    #[arg(long, value_name = "UNIT", help_heading = "Shape")]
    pub units: Option<String>,
    /// Units of a PLT drawing in one mm [default: 40]
    #[arg(long, value_name = "NUMBER", help_heading = "Shape")]
    pub units_per_mm: Option<f64>,
    /// Values of a PLT point, 2 or 3; the third is work Z in units of the drawing [default: 2]
    #[arg(long, value_name = "NUMBER", value_parser = clap::value_parser!(u8).range(2..=3), help_heading = "Shape")]
    pub dims: Option<u8>,
    /// Z at which the tool crosses over the work, mm; above every depth [default: 5]
    #[arg(long, value_name = "Z", allow_negative_numbers = true, help_heading = "Cutting")]
    pub safe: Option<f64>,
    /// Z of the cut, mm [default: -1]
    #[arg(long, value_name = "Z", allow_negative_numbers = true, help_heading = "Cutting")]
    pub depth: Option<f64>,
    /// Feed along the drawing, mm/min [default: 600]
    #[arg(long, value_name = "FEED", help_heading = "Cutting")]
    pub feed: Option<f64>,
    /// Feed into the material, mm/min [default: 300]
    #[arg(long, value_name = "FEED", help_heading = "Cutting")]
    pub plunge: Option<f64>,
    /// Spindle speed, r/min [default: the spindle is left alone]
    #[arg(long, value_name = "RPM", help_heading = "Cutting")]
    pub spindle: Option<f64>,
    /// Tool number [default: the tool in the spindle]
    #[arg(long, value_name = "NUMBER", help_heading = "Cutting")]
    pub tool: Option<u32>,
    /// How a layer of a DXF drawing is cut: NAME=DEPTH,TOOL, then words F feed, P plunge, S spindle; or
    /// NAME=skip. May be given several times
    #[arg(long = "layer", value_name = "NAME=DEPTH,TOOL", help_heading = "Cutting")]
    pub layers: Vec<String>,
    /// The same for a pen of a PLT drawing: NUMBER=DEPTH,TOOL
    #[arg(long = "pen", value_name = "NUMBER=DEPTH,TOOL", help_heading = "Cutting")]
    pub pens: Vec<String>,
    /// What every command takes.
    #[command(flatten)]
    pub common: Common,
}

fn seconds(text: &str) -> Result<f64, String> {
    match text.parse::<f64>() {
        Ok(value) if (0.0..=1e9).contains(&value) => Ok(value),
        _ => Err("give seconds from 0 on".to_owned()),
    }
}

/// A line of a program or of a file beside it, and in which pass.
#[derive(Clone, PartialEq, Eq, Debug)]
pub struct Place {
    /// The file; none for the program's own.
    pub file: Option<String>,
    /// Counted from 1.
    pub line: u32,
    /// Counted from 1.
    pub pass: u64,
}

impl Place {
    fn parse(text: &str) -> Result<Place, String> {
        let number = |part: &str| part.parse::<u64>().ok().filter(|n| *n > 0);
        let wrong = || "give a line, or LINE:PASS, both counted from 1; FILE: may go before".to_owned();
        let parts: Vec<&str> = text.rsplitn(3, ':').collect();
        let (file, line, pass) = match parts.as_slice() {
            [line] => (None, *line, "1"),
            [pass, line] if number(line).is_some() => (None, *line, *pass),
            [line, file] => (Some(file.to_string()), *line, "1"),
            [pass, line, file] if number(line).is_some() => (Some(file.to_string()), *line, *pass),
            [line, ..] => (text.rsplit_once(':').map(|(file, _)| file.to_owned()), *line, "1"),
            [] => return Err(wrong()),
        };
        let line = number(line).and_then(|line| u32::try_from(line).ok()).ok_or_else(wrong)?;
        Ok(Place { file: file.filter(|file| !file.is_empty()), line, pass: number(pass).ok_or_else(wrong)? })
    }
}

/// The tag of a language that there are texts in.
fn language(text: &str) -> Result<String, String> {
    Language::from_tag(text).map(|_| text.to_owned()).ok_or_else(|| "give en, zh, ru, es or tr".to_owned())
}

fn percent<const MOST: u32>(text: &str) -> Result<f64, String> {
    match text.trim_end_matches('%').parse::<f64>() {
        // At 0 the machine would stand still for ever.
        Ok(value) if (1.0..=f64::from(MOST)).contains(&value) => Ok(value),
        _ => Err(format!("give a number from 1 to {MOST}")),
    }
}
