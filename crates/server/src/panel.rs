//! The whole control for sockets (`docs/api.md` has its commands).

use crate::hub::Hub;
use crate::service::{Aside, Caller, Need, Service};
use ferrocut_controller::Tick;
use ferrocut_controller::api::{API_VERSION, Command, Event, Refusal, Reply, Status};
use ferrocut_controller::control::{Control, check_ladder, ladder_of};
use ferrocut_controller::diagnosis::{named_in, table};
use ferrocut_machine::{Alarm, Fault};
use ferrocut_memory::{Author, Level, SessionNote, Store};
use ferrocut_program::Span;
use std::sync::Arc;

/// A control whose connections are operators until they log in.
pub struct Panel {
    control: Control,
    watcher: Option<Watcher>,
    is_timed: bool,
}

/// Sees what each period came to.
pub type Watcher = Box<dyn FnMut(&Tick) + Send>;

/// The override switches at 100 % (`docs/plc.md`): a panel on a screen has no knobs that stand somewhere when the
/// machine is switched on, and at 0 % nothing would move.
const SWITCHES: [(&str, u8); 2] = [("SWITCH_FEED", 10), ("SWITCH_SPINDLE", 5)];

impl Panel {
    /// Serves a control, whose override switches stand at 100 % until somebody turns them.
    pub fn new(mut control: Control) -> Panel {
        for (switch, position) in SWITCHES {
            // A ladder of other names has switches of its own.
            let _ =
                control.command(Command::Switch { switch: switch.to_owned(), position }, &Author::Control);
        }
        Panel { control, watcher: None, is_timed: false }
    }

    /// The same with what takes long done beside even where simulated drives would wait: to see how long periods take.
    #[must_use]
    pub fn timed(self) -> Panel {
        Panel { is_timed: true, ..self }
    }

    /// The same for somebody who looks at each period, on the machine's thread: at setpoints as they go to the drives.
    pub fn watched(control: Control, watcher: Watcher) -> Panel {
        Panel { watcher: Some(watcher), ..Panel::new(control) }
    }

    /// The control.
    pub fn control(&mut self) -> &mut Control {
        &mut self.control
    }
}

/// Looks at ladders, their names and passwords on a thread of whoever gives them, since that takes many periods.
/// What was found of a password is told to the control, which has the rights from then on.
pub fn aside(store: Option<Arc<Store>>) -> Aside<Panel> {
    Box::new(move |hub, command, from| {
        match command {
            Command::CheckLadder { text } => return Some(Ok(check_ladder(text))),
            Command::ExchangeLadder { text } => return exchange(hub, text, from),
            Command::SignalTable { area, language } => {
                let (area, language) = named_in(*area, language.as_deref())?;
                let copy = |panel: &mut Panel| {
                    let plc = panel.control().plc_mut()?;
                    Some((plc.program().clone(), plc.memory().clone()))
                };
                let (program, memory) = hub.look(copy).flatten()?;
                return Some(Ok(Reply::SignalTable { signals: table(area, language, &program, &memory) }));
            }
            _ => {}
        }
        let store = store.as_ref()?;
        let done = match command {
            Command::LogIn { level, password } => match level_of(*level) {
                Ok(Level::Operator) => return None,
                Ok(level) => store.log_in(level, password, from.seat, &from.name).map(Some),
                Err(refusal) => return Some(Err(refusal)),
            },
            Command::SetPassword { level, password } => match level_of(*level) {
                Ok(level) => {
                    let name = from.name.clone();
                    let rights = hub.look(move |panel| panel.control().rights_of(&name));
                    // Those that he logged in with, or those of his session: the control takes the higher ones too.
                    let taken = rights.flatten().filter(|taken| taken.level().covers(from.session.level()));
                    let session = taken.unwrap_or_else(|| from.session.clone());
                    let author = Author::Person { session, name: from.name.clone() };
                    store.set_password(&author, level, password, from.seat).map(|()| None)
                }
                Err(refusal) => return Some(Err(refusal)),
            },
            _ => return None,
        };
        Some(match done {
            Err(error) => Err(Refusal::from(error.alarm())),
            Ok(None) => Ok(Reply::Done),
            Ok(Some(session)) => {
                let (name, level) = (from.name.clone(), session.level().number());
                let reply = hub.look(move |panel| panel.control().admit(&name, session));
                Ok(reply.unwrap_or(Reply::Level { level }))
            }
        })
    })
}

/// Puts a ladder in the place of the one that runs. Who may not is told that before it is looked at.
fn exchange(hub: &Hub<Panel>, text: &str, from: &Caller) -> Option<Result<Reply, Refusal>> {
    let (asks, gives) = (from.author(), from.author());
    if let Err(refusal) = hub.look(move |panel| panel.control().may_exchange_ladder(&asks))? {
        return Some(Err(refusal));
    }
    match ladder_of(text) {
        Ok(program) => hub.look(move |panel| panel.control().take_ladder(program, &gives)),
        Err(refusal) => Some(Err(refusal)),
    }
}

fn level_of(number: u8) -> Result<Level, Refusal> {
    let impossible = || Alarm::core(Fault::ValueImpossible, Span::default()).with("name", number.to_string());
    Level::of(number.into()).ok_or_else(|| Refusal::from(impossible()))
}

impl Service for Panel {
    type Command = Command;
    type Reply = Reply;
    type Refusal = Refusal;
    type Event = Event;
    type Status = Status;

    const VERSION: u32 = API_VERSION;

    fn begin(&mut self) {
        // Without threads for it all is done in the period.
        let _ = if self.is_timed { self.control.work_beside() } else { self.control.keep_time() };
    }

    fn tick(&mut self) {
        let tick = self.control.tick();
        if let Some(watcher) = &mut self.watcher {
            watcher(&tick);
        }
    }

    fn prepare(&mut self) {
        self.control.prepare();
    }

    fn end(&mut self) {
        // Nobody is connected any more who could be told; what fails now is found at the next start.
        let _ = self.control.flush();
    }

    fn command(&mut self, command: Command, from: &Caller) -> Result<Reply, Refusal> {
        // Rights that were taken belong to the connection: its number, and so its name, comes but once.
        self.control.command(command, &from.author())
    }

    fn events(&mut self) -> Vec<Event> {
        self.control.events()
    }

    fn status(&mut self) -> Status {
        self.control.status()
    }

    fn need(command: &Command) -> Need {
        match command {
            // Whoever sees danger stops the machine.
            Command::EmergencyStop { pressed: true } => Need::Nothing,
            Command::Key { key, .. } if key == "KEY_HOLD" => Need::Nothing,
            Command::Programs
            | Command::Read { .. }
            | Command::MdiText
            | Command::Offsets { .. }
            | Command::Zeros
            | Command::Variables { .. }
            | Command::Parameters { .. }
            | Command::AlarmHistory { .. }
            | Command::OperationLog { .. }
            | Command::Signals { .. }
            | Command::SignalTable { .. }
            | Command::Forced
            | Command::Ladder
            | Command::LadderFlow
            | Command::CheckLadder { .. }
            | Command::Captured { .. }
            | Command::Traced { .. }
            | Command::Restarts
            | Command::ReferencePoints
            | Command::Pitch { .. }
            | Command::Points
            | Command::Measured
            | Command::Status
            | Command::Timing { forget: false }
            | Command::Version => Need::Nothing,
            _ => Need::Command,
        }
    }

    fn key(command: &Command) -> Option<(&str, bool)> {
        match command {
            Command::Key { key, down } => Some((key, *down)),
            _ => None,
        }
    }

    fn takes_long(command: &Command) -> bool {
        matches!(
            command,
            Command::LogIn { .. }
                | Command::SetPassword { .. }
                | Command::CheckLadder { .. }
                | Command::ExchangeLadder { .. }
                | Command::SignalTable { .. }
        )
    }

    fn release(key: &str) -> Command {
        Command::Key { key: key.to_owned(), down: false }
    }

    fn commanded(&mut self, from: &Caller, note: SessionNote) {
        self.control.note_session(&from.author(), note);
    }

    fn abandoned() -> Option<Command> {
        Some(Command::StopByHand)
    }

    fn farewell() -> Option<Command> {
        Some(Command::LogOut)
    }
}
