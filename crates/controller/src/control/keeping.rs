//! What survives the power: how the running control and the durable memory stay the same.
//!
//! What a person changes is judged and committed by the memory first, and then holds. What a program, the ladder or
//! the control changes holds at once and follows within a moment; a kill in between leaves the memory as it was a
//! moment before, never half of it.

use super::machine_data::Pitch;
use super::settings::INPUT_UNIT;
use super::status::Count;
use super::taking_up::TakingUp;
use super::{Control, alarm, exchange, library};
use crate::api::Event;
use crate::cnc::Tick;
use ferrocut_geometry::{Axis, AxisSet, Position};
use ferrocut_interpreter::Interpreter;
use ferrocut_machine::{Alarm, Fault, Memory, MemoryChange, ParameterKey, ToolOffset, WorkOffset};
use ferrocut_memory::control::{ENTERED, changes, enter};
use ferrocut_memory::{
    AlarmEntry, Author, Change, Counter, InterruptedRun, Item, LastPosition, Pending, PlcArea, SessionNote,
    SignalSize, Store,
};
use ferrocut_plc::{Address, Area, Plc};
use ferrocut_program::FileId;
use std::collections::{BTreeMap, VecDeque};
use std::sync::Arc;

/// Time between looks at what a program has changed, s.
const LOOK_S: f64 = 0.1;

/// Time between looks at counters, at what the ladder keeps, and at the position of axes that move, s.
const SLOW_S: f64 = 1.0;

/// The durable memory of a running control.
pub(super) struct Keeping {
    pub store: Arc<Store>,
    /// What is on the disk, or on its way there.
    kept: Memory,
    /// Changes of the program that were looked at.
    writes: u64,
    plc: Vec<(Address, u8)>,
    pub ladder: exchange::Kept,
    counters: Count,
    position: Option<LastPosition>,
    /// The block of the run that was told last, and where the axes stood.
    block: u64,
    stood: Option<Position>,
    was_moving: bool,
    /// Where the axes stood last, and those that are on their way from there: should the power fail now, nobody knows
    /// where they come to rest.
    stands: Position,
    on_their_way: AxisSet,
    /// Changes of persons on their way.
    pending: VecDeque<Asked>,
    look_in: f64,
    slow_in: f64,
    /// The disk was told to be at fault, once.
    told: bool,
}

/// Changes that a person asked for and that the disk has not confirmed.
struct Asked {
    pending: Pending,
    changes: Vec<Change>,
    /// What the program wrote since: the disk has that behind them.
    written: Vec<Change>,
}

impl Asked {
    /// The changes over which the program has not written.
    fn stand(&self) -> impl DoubleEndedIterator<Item = &Change> {
        self.changes.iter().filter(|change| !is_of_one_of(change, &self.written))
    }
}

/// Whether a change is of the same value as one of others.
fn is_of_one_of(change: &Change, others: &[Change]) -> bool {
    use Change::{Offset, Parameter, ReferencePoint, Variable, WorkZero};
    others.iter().any(|other| match (change, other) {
        (Offset { number: one, .. }, Offset { number: other, .. }) => one == other,
        (WorkZero { name: one, .. }, WorkZero { name: other, .. }) => one == other,
        (Variable { name: one, .. }, Variable { name: other, .. }) => one == other,
        (Parameter { key: one, .. }, Parameter { key: other, .. }) => one == other,
        (ReferencePoint { number: one, .. }, ReferencePoint { number: other, .. }) => one == other,
        _ => false,
    })
}

/// What was kept.
#[derive(Default)]
pub(super) struct Found {
    pub counters: Count,
    pub position: Option<LastPosition>,
    pub interrupted: Option<InterruptedRun>,
    pub pitch: Pitch,
    /// What is to be said of a ladder that was kept.
    pub ladder: Option<Alarm>,
}

impl Keeping {
    /// Enters what was kept.
    pub fn open(
        store: Arc<Store>,
        memory: &mut Memory,
        plc: Option<&mut Plc>,
    ) -> Result<(Keeping, Found), Box<Alarm>> {
        let mut items = ENTERED.to_vec();
        items.extend([
            Item::Counters,
            Item::LastPosition,
            Item::Interrupted,
            Item::Plc,
            Item::Pitch,
            Item::Ladder,
        ]);
        let contents = store.reader().contents(&items).map_err(|error| error.alarm())?;
        store.deliver(memory).map_err(|error| error.alarm())?;
        // What this control does not take stays in the memory, for one that does.
        let _ = enter(&contents, memory);
        let of = |counter| contents.counters.get(&counter).copied().unwrap_or(0.0);
        let counters = Count {
            parts: of(Counter::Parts),
            all_parts: of(Counter::AllParts),
            run_time: of(Counter::RunTime),
            cutting_time: of(Counter::CuttingTime),
            all_cutting_time: of(Counter::AllCuttingTime),
            power_on_time: of(Counter::PowerOnTime),
            starts: of(Counter::Starts),
        };
        let position = contents.last_position;
        let (mut kept_plc, mut ladder) = (Vec::new(), None);
        if let Some(plc) = plc {
            ladder = contents.ladder.as_deref().map(|text| exchange::at_power_on(text, plc));
            kept_plc = enter_plc(contents.plc, plc);
        }
        let keeping = Keeping {
            store,
            kept: memory.clone(),
            writes: 0,
            plc: kept_plc,
            ladder: exchange::Kept::of(contents.ladder),
            counters,
            position: position.clone(),
            block: 0,
            stood: None,
            was_moving: false,
            stands: Position::ZERO,
            on_their_way: AxisSet::EMPTY,
            pending: VecDeque::new(),
            look_in: 0.0,
            slow_in: SLOW_S,
            told: false,
        };
        let (interrupted, pitch) = (contents.interrupted, contents.pitch);
        Ok((keeping, Found { counters, position, interrupted, pitch, ladder }))
    }

    /// Puts an alarm into the history.
    pub fn alarm(&mut self, alarm: &Alarm, program: &str) {
        let entry = AlarmEntry::of(alarm, program, ferrocut_memory::items::now());
        self.put(&Author::Control, vec![Change::Alarm(entry)]);
    }

    /// A parameter has this value, and it is kept elsewhere.
    pub fn has(&mut self, key: &ParameterKey, value: f64) {
        // The value is one that the control has taken.
        self.kept.parameters.take_back(key, value);
    }

    /// Changes that nobody waits for.
    pub fn put(&mut self, author: &Author, changes: Vec<Change>) {
        // Told by the flush that finds it, or by the next change that waits.
        self.told |= self.store.put(author, changes).is_err();
    }

    /// What the program changed since the last look.
    fn look_at_program(&mut self, interpreter: &Interpreter) {
        if self.writes == interpreter.writes() {
            return;
        }
        self.writes = interpreter.writes();
        let found = changes(&self.kept, interpreter.memory());
        if !found.is_empty() {
            self.kept = interpreter.memory().clone();
            self.pending.iter_mut().for_each(|asked| asked.written.extend_from_slice(&found));
            let name = interpreter.programs().file_name(FileId(0)).to_owned();
            self.put(&Author::Program { name }, found);
        }
    }

    fn look_at_ladder(&mut self, plc: &Plc) {
        let mut runs: Vec<(Address, Vec<u8>)> = Vec::new();
        for ((address, now), (_, before)) in plc.memory().kept().zip(&mut self.plc) {
            if *before == now {
                continue;
            }
            *before = now;
            match runs.last_mut() {
                Some((first, bytes))
                    if first.area == address.area
                        && usize::from(first.byte) + bytes.len() == usize::from(address.byte) =>
                {
                    bytes.push(now);
                }
                _ => runs.push((address, vec![now])),
            }
        }
        let change = |(first, bytes): (Address, Vec<u8>)| {
            Some(Change::Plc { area: kept_area(first.area)?, first: first.byte, bytes })
        };
        let found: Vec<Change> = runs.into_iter().filter_map(change).collect();
        if !found.is_empty() {
            self.put(&Author::Control, found);
        }
    }

    fn look_at_counters(&mut self, counters: &Count) {
        let found: Vec<Change> = counters
            .named()
            .zip(self.counters.named())
            .filter(|((_, now), (_, before))| now != before)
            .map(|((counter, value), _)| Change::Counter { counter, value })
            .collect();
        self.counters = *counters;
        if !found.is_empty() {
            self.put(&Author::Control, found);
        }
    }

    /// Whether an axis has left the place where it stood.
    fn follow(&mut self, tick: &Tick) -> bool {
        let before = self.on_their_way;
        if !tick.moving {
            (self.stands, self.on_their_way) = (tick.position, AxisSet::EMPTY);
            return false;
        }
        let left = |axis: &Axis| before.contains(*axis) || tick.position[*axis] != self.stands[*axis];
        self.on_their_way = Axis::ALL.into_iter().filter(left).collect();
        self.on_their_way != before
    }

    fn look_at_position(&mut self, at: LastPosition) {
        // Another time alone is nothing new.
        let is_another = |last: &LastPosition| LastPosition { time: at.time, ..last.clone() } != at;
        if self.position.as_ref().is_none_or(is_another) {
            self.position = Some(at.clone());
            self.put(&Author::Control, vec![Change::LastPosition(at)]);
        }
    }
}

impl Control {
    /// What changed goes to the durable memory.
    pub(super) fn keep(&mut self) {
        let seconds = self.machine.servo_period_ms / 1000.0;
        let Some(mut keeping) = self.keeping.take() else { return };
        keeping.look_in -= seconds;
        keeping.slow_in -= seconds;
        let came_to_rest = keeping.was_moving && !self.tick.moving;
        keeping.was_moving = self.tick.moving;
        if keeping.look_in <= 0.0 || came_to_rest || !keeping.pending.is_empty() {
            keeping.look_in = LOOK_S;
            keeping.look_at_program(self.cnc.interpreter());
        }
        let left = self.cnc.drives().loses_place_with_power() && keeping.follow(&self.tick);
        if keeping.slow_in <= 0.0 || came_to_rest || left {
            keeping.look_at_position(self.last_position(keeping.on_their_way));
            if self.runs_remembered()
                && let Some(at) = self.place_of_run()
                && (keeping.block, keeping.stood) != (at.block, at.at)
            {
                (keeping.block, keeping.stood) = (at.block, at.at);
                keeping.put(&Author::Control, vec![Change::Interrupted(Some(at))]);
            }
        }
        if keeping.slow_in <= 0.0 {
            keeping.slow_in = SLOW_S;
            keeping.look_at_counters(&self.counters);
            if let Some(plc) = &self.plc {
                keeping.look_at_ladder(plc);
            }
        }
        if let Some(plc) = &self.plc {
            keeping.look_at_exchanges(plc, &self.own_ladder, &mut self.exchanged_by);
        }
        let mut done = Vec::new();
        // In the order in which they were asked for: the last one is what holds. None while blocks are being read.
        while !self.cnc.is_reading()
            && let Some(answer) = keeping.pending.front().and_then(|asked| asked.pending.poll())
        {
            done.extend(keeping.pending.pop_front().map(|asked| (answer, asked)));
        }
        let told = std::mem::take(&mut keeping.told);
        self.keeping = Some(keeping);
        if told {
            self.tell_of(&alarm(Fault::NotKept));
        }
        for (answer, asked) in done {
            match answer {
                Ok(_) => self.apply(&asked.changes, &asked.written),
                Err(error) => self.refuse(&error.alarm()),
            }
        }
    }

    /// Where a run was broken off goes to the durable memory; none when it came to its end.
    pub(super) fn keep_interrupted(&mut self, at: Option<InterruptedRun>) {
        if let Some(keeping) = &mut self.keeping {
            (keeping.block, keeping.stood) = at.as_ref().map_or((0, None), |at| (at.block, at.at));
            keeping.put(&Author::Control, vec![Change::Interrupted(at)]);
        }
    }

    /// The memory of the program is another one: all of it is looked at.
    pub(super) fn keep_all_of_program(&mut self) {
        if let Some(keeping) = &mut self.keeping {
            keeping.writes = u64::MAX;
        }
    }

    fn last_position(&self, on_their_way: AxisSet) -> LastPosition {
        let referenced = self.cnc.referenced();
        LastPosition {
            time: ferrocut_memory::items::now(),
            position: self.tick.position,
            referenced: referenced.iter().filter(|axis| !on_their_way.contains(*axis)).collect(),
            work_system: self.cnc.interpreter().work_system(),
            own_zero: self.cnc.interpreter().own_zero(),
        }
    }

    /// What is to be kept is on the disk when this returns; before power goes off.
    pub fn flush(&mut self) -> Result<(), Box<Alarm>> {
        if let Some(keeping) = &mut self.keeping {
            (keeping.look_in, keeping.slow_in) = (0.0, 0.0);
        }
        self.keep();
        let Some(keeping) = &self.keeping else { return Ok(()) };
        keeping.store.flush().map(drop).map_err(|error| Box::new(error.alarm()))
    }

    /// Takes the data up again that the memory has, after a restore of these items. Not where the axes stood last,
    /// which is of another moment.
    pub(super) fn read_again(&mut self, restored: &[Item]) -> Result<(), Box<Alarm>> {
        let Some(keeping) = &self.keeping else { return Ok(()) };
        let mut items = ENTERED.to_vec();
        items.extend([Item::Counters, Item::Interrupted, Item::Plc, Item::Pitch, Item::Ladder]);
        let contents = keeping.store.reader().contents(&items).map_err(|error| error.alarm())?;
        let mut memory = self.delivered.clone();
        let _ = enter(&contents, &mut memory);
        // What no backup has is as it was.
        let present = self.cnc.interpreter().memory();
        memory.library.clone_from(&present.library);
        match restored.contains(&Item::Variables) {
            true => {
                let volatile =
                    present.variables.iter().filter(|(number, _)| !present.keeps_variable(*number));
                for (number, value) in volatile {
                    // There was room for it.
                    let _ = memory.variables.set(number, Some(value));
                }
            }
            false => memory.variables.clone_from(&present.variables),
        }
        for (counter, _) in Count::default().named() {
            self.counters.set(counter, contents.counters.get(&counter).copied().unwrap_or(0.0));
        }
        *self.cnc.interpreter_mut().memory_mut() = memory.clone();
        self.cnc.interpreter_mut().memory_restored();
        if let Some(keeping) = &mut self.keeping {
            keeping.kept = memory;
            keeping.counters = self.counters;
        }
        self.show_counts();
        self.parameters_changed();
        for item in restored {
            match item {
                Item::Plc => {
                    if let Some(plc) = &mut self.plc {
                        let kept = enter_plc(contents.plc.clone(), plc);
                        if let Some(keeping) = &mut self.keeping {
                            keeping.plc = kept;
                        }
                    }
                }
                Item::Ladder => self.exchange_for_kept(contents.ladder.clone()),
                Item::Pitch => self.pitch.clone_from(&contents.pitch),
                Item::Programs => self.taking_up.program_changed(),
                Item::Interrupted => self.taking_up = TakingUp::of(contents.interrupted.clone()),
                _ => {}
            }
        }
        self.loaded = super::Loaded::Nothing;
        self.reading.forget_all();
        Ok(())
    }

    /// What was asked for last of something, and is still on its way: what is asked for next goes on from there.
    fn on_its_way<T>(&self, of: impl Fn(&Change) -> Option<T>) -> Option<T> {
        let pending = self.keeping.iter().flat_map(|keeping| &keeping.pending);
        pending.rev().find_map(|asked| asked.stand().rev().find_map(&of))
    }

    /// The text of a program as persons have asked for it.
    pub(super) fn text_asked(&self, program: &str) -> Option<Vec<u8>> {
        let asked = self.on_its_way(|change| text_in(change, program).map(|text| text.map(<[u8]>::to_vec)));
        asked.unwrap_or_else(|| self.callable.library().text(program))
    }

    /// The name of the program that somebody means by this one, as persons have asked for it.
    pub(super) fn name_asked(&self, typed: &str) -> Option<String> {
        let asked = |name: &str| self.on_its_way(|change| text_in(change, name).map(|text| text.is_some()));
        let is_there = |name: &String| asked(name).unwrap_or_else(|| self.callable.library().has(name));
        let other = || self.callable.library().name_of(typed).filter(|name| asked(name) != Some(false));
        library::names_of(typed).into_iter().find(is_there).or_else(other)
    }

    /// Whether a program is about to have another text, which is not on the disk yet.
    pub(super) fn awaits_texts(&self) -> bool {
        self.on_its_way(|change| match change {
            Change::Program { .. } | Change::RenameProgram { .. } | Change::DeleteProgram { .. } => Some(()),
            _ => None,
        })
        .is_some()
    }

    /// A tool offset as persons have asked for it.
    pub(super) fn offset_asked(&self, number: u16) -> Option<ToolOffset> {
        let asked = self.on_its_way(|change| match change {
            Change::Offset { number: of, offset } if *of == number => Some(*offset),
            _ => None,
        });
        asked.or_else(|| self.cnc.interpreter().memory().tools.get(number).copied())
    }

    /// A work zero as persons have asked for it.
    pub(super) fn zero_asked(&self, name: WorkOffset) -> Option<Position> {
        let asked = self.on_its_way(|change| match change {
            Change::WorkZero { name: of, zero } if *of == name => Some(*zero),
            _ => None,
        });
        asked.or_else(|| self.cnc.interpreter().memory().work.get(name))
    }

    /// A reference point, from 1, as persons have asked for it.
    pub(super) fn reference_point_asked(&self, number: u8) -> Option<Position> {
        let asked = self.on_its_way(|change| match change {
            Change::ReferencePoint { number: of, position } if *of == number => Some(*position),
            _ => None,
        });
        let points = &self.cnc.interpreter().memory().reference_points;
        asked.or_else(|| points.get(usize::from(number).checked_sub(1)?).copied())
    }

    /// Has the memory judge and keep a change, then makes it. `Ok(false)`: it is on its way, since the axes must not
    /// wait for the disk; an event follows.
    pub(super) fn change(&mut self, author: &Author, change: Change) -> Result<bool, Box<Alarm>> {
        self.change_together(author, vec![change])
    }

    /// The same for changes that are made together or not at all.
    pub(super) fn change_together(
        &mut self,
        author: &Author,
        changes: Vec<Change>,
    ) -> Result<bool, Box<Alarm>> {
        let is_busy = self.must_not_wait() || self.is_in_period;
        if let Some(keeping) = &mut self.keeping {
            // What program and ladder wrote before is on the disk before, too.
            keeping.look_at_program(self.cnc.interpreter());
            let sets_signals = changes.iter().any(|change| matches!(change, Change::Signal { .. }));
            if let Some(plc) = self.plc.as_ref().filter(|_| sets_signals) {
                keeping.look_at_ladder(plc);
            }
            if is_busy {
                let pending = keeping.store.begin(author, changes.clone()).map_err(|error| error.alarm())?;
                keeping.pending.push_back(Asked { pending, changes, written: Vec::new() });
                return Ok(false);
            }
            keeping.store.commit(author, changes.clone()).map_err(|error| error.alarm())?;
        }
        self.apply(&changes, &[]);
        Ok(true)
    }

    /// Whether no period may wait for the disk: axes move or are about to, or the drives need a setpoint in each, at rest
    /// too.
    pub(super) fn must_not_wait(&mut self) -> bool {
        let is_busy = self.tick.moving || self.cnc.is_under_way() || self.cnc.is_reading();
        is_busy || self.cnc.drives().keeps_time()
    }

    /// Changes that are on their way are made before the next command sees the data, so that none takes back what the
    /// one before it set; not while axes may not wait for the disk.
    pub(super) fn settle_changes(&mut self) {
        if self.must_not_wait() {
            return;
        }
        let Some(keeping) = &mut self.keeping else { return };
        keeping.look_at_program(self.cnc.interpreter());
        for Asked { pending, changes, written } in std::mem::take(&mut keeping.pending) {
            match pending.wait() {
                Ok(_) => self.apply(&changes, &written),
                Err(error) => self.refuse(&error.alarm()),
            }
        }
    }

    /// Makes changes that were kept. What the program has `written` since they were asked for holds: the disk has it
    /// last.
    fn apply(&mut self, changes: &[Change], written: &[Change]) {
        for change in changes {
            let Some(item) = item_of(change) else { continue };
            if !is_of_one_of(change, written) {
                self.make(change);
            }
            if let Some(keeping) = &mut self.keeping {
                keeping.kept = self.cnc.interpreter().memory().clone();
            }
            self.event(Event::Changed { item: item.name().to_owned() });
        }
    }

    /// Makes a change where the control has what it is of.
    fn make(&mut self, change: &Change) {
        if let Some(change) = memory_change(change, &self.delivered) {
            self.cnc.change_memory(change);
        }
        if matches!(change, Change::Parameter { .. }) {
            self.parameters_changed();
        }
        match change {
            Change::Parameter { key, .. } if *key == INPUT_UNIT && !self.cnc.is_under_way() => {
                self.cnc.interpreter_mut().unit_changed();
            }
            Change::Counter { counter, value } => {
                self.counters.set(*counter, *value);
                self.show_counts();
            }
            Change::Signal { area, first, size, value } => {
                // What the ladder keeps is compared with the disk afterwards, as if the ladder had written it.
                if let Some(plc) = &mut self.plc {
                    set_signal(plc, area_of(*area), *first, *size, *value);
                }
            }
            Change::Pitch { axis, point, value } => {
                self.pitch.insert((*axis, *point), *value);
            }
            Change::RenameProgram { name, to, .. } => {
                if self.selected.as_ref() == Some(name) {
                    self.selected = Some(to.clone());
                }
                self.text_changed(name);
            }
            Change::Program { name, .. } | Change::DeleteProgram { name } => {
                // Not before: who may not delete it leaves it selected.
                if matches!(change, Change::DeleteProgram { .. }) && self.selected.as_ref() == Some(name) {
                    self.selected = None;
                }
                self.text_changed(name);
            }
            _ => {}
        }
    }

    /// Notes in the operation log, where one is kept, who commands.
    pub fn note_session(&mut self, author: &Author, note: SessionNote) {
        if let Some(keeping) = &mut self.keeping {
            keeping.put(author, vec![Change::Session(note)]);
        }
    }

    /// What was loaded and kept of the text of a program is no longer so.
    fn text_changed(&mut self, name: &str) {
        // One that it may have called is read anew too, before the next run.
        self.texts_changed = true;
        self.reading.forget(name, self.callable.changes_tools(name));
        self.taking_up.program_changed();
    }
}

/// The text that a change gives a program; none where it takes it away, and nothing where it is of another.
fn text_in<'a>(change: &'a Change, program: &str) -> Option<Option<&'a [u8]>> {
    match change {
        Change::Program { name, text, .. } if name == program => Some(Some(text)),
        Change::RenameProgram { to, text, .. } if to == program => Some(Some(text)),
        Change::RenameProgram { name, .. } | Change::DeleteProgram { name } if name == program => Some(None),
        _ => None,
    }
}

/// A change of what programs see of the memory. One of a parameter goes back to the one of `delivered`, be it that of the list or that of the machine file.
fn memory_change(change: &Change, delivered: &Memory) -> Option<MemoryChange> {
    use ferrocut_machine::setup::VariableName;
    Some(match change {
        Change::Offset { number, offset } => MemoryChange::ToolOffset(*number, *offset),
        Change::WorkZero { name, zero } => MemoryChange::WorkOffset(*name, *zero),
        Change::Variable { name: VariableName::Number(number), value } => {
            MemoryChange::Variable(*number, *value)
        }
        Change::Variable { name: VariableName::Named(name), value } => {
            MemoryChange::Named(name[..].into(), *value)
        }
        Change::Parameter { key, value: Some(value) } => MemoryChange::Parameter(key.clone(), *value),
        Change::Parameter { key, value: None } => {
            let value = delivered.parameter(key);
            match delivered.parameters.is_given(key) {
                true => MemoryChange::Parameter(key.clone(), value),
                false => MemoryChange::AsDelivered(key.clone(), value),
            }
        }
        Change::ReferencePoint { number, position } => {
            MemoryChange::ReferencePoint(usize::from(*number).checked_sub(1)?, *position)
        }
        _ => return None,
    })
}

/// What a change is of that fronts are told of.
fn item_of(change: &Change) -> Option<Item> {
    Some(match change {
        Change::Offset { .. } => Item::Offsets,
        Change::WorkZero { .. } => Item::WorkZeros,
        Change::Variable { .. } => Item::Variables,
        Change::Parameter { .. } => Item::Parameters,
        Change::Counter { .. } => Item::Counters,
        Change::Signal { .. } => Item::Plc,
        Change::ReferencePoint { .. } => Item::ReferencePoints,
        Change::Pitch { .. } => Item::Pitch,
        Change::RenameProgram { .. }
        | Change::Program { .. }
        | Change::DeleteProgram { .. }
        | Change::LockProgram { .. } => Item::Programs,
        Change::ClearAlarms => Item::Alarms,
        Change::ClearLog => Item::Log,
        _ => return None,
    })
}

/// Puts what a ladder keeps into its signals; what was never stored is off. All that it keeps then.
fn enter_plc(kept: BTreeMap<PlcArea, Vec<u8>>, plc: &mut Plc) -> Vec<(Address, u8)> {
    let memory = plc.memory_mut();
    let all: Vec<Address> = memory.kept().map(|(address, _)| address).collect();
    all.into_iter().for_each(|address| memory.set_byte(address, 0));
    for (area, bytes) in kept {
        let area = area_of(area);
        for (byte, value) in (0u16..).zip(bytes) {
            memory.set_byte(Address { area, byte, bit: None }, value);
        }
    }
    memory.kept().collect()
}

fn set_signal(plc: &mut Plc, area: Area, byte: u16, size: SignalSize, value: u32) {
    let memory = plc.memory_mut();
    match size {
        SignalSize::Bit(bit) => memory.set_bit(Address { area, byte, bit: Some(bit) }, value != 0),
        SignalSize::Bytes(bytes) => {
            for (byte, value) in (byte..).zip(value.to_le_bytes()).take(bytes.into()) {
                memory.set_byte(Address { area, byte, bit: None }, value);
            }
        }
    }
}

fn area_of(area: PlcArea) -> Area {
    match area {
        PlcArea::K => Area::K,
        PlcArea::T => Area::T,
        PlcArea::C => Area::C,
        PlcArea::D => Area::D,
    }
}

pub(super) fn kept_area(area: Area) -> Option<PlcArea> {
    match area {
        Area::K => Some(PlcArea::K),
        Area::T => Some(PlcArea::T),
        Area::C => Some(PlcArea::C),
        Area::D => Some(PlcArea::D),
        _ => None,
    }
}
