//! What a change does: whether it may be made, the rows that it writes, and its entry in the log.

use crate::author::Author;
use crate::database::Database;
use crate::error::{Error, Finding};
use crate::items::{Change, Item, LogEntry, PlcArea, Program, SignalSize, Time, limits};
use crate::rights::{self, Level};
use crate::rows::{self, BLOCK};
use crate::table::{
    ALARM, COUNTER, Cell, FileSum, INTERRUPTED, LADDER, LAST_POSITION, LOG, PARAMETER, PITCH, PROGRAM,
    REFERENCE_POINT, Row, SIGNAL, TOOL_OFFSET, Table, VARIABLE, WORK_ZERO,
};
use ferrocut_geometry::{Axis, Position};
use ferrocut_machine::setup::VariableName;
use ferrocut_machine::{Memory, ParameterKey, Place, ToolOffset, ToolTable, WorkOffset};
use std::collections::HashSet;

/// The database, and what is needed to judge changes.
pub struct Applier {
    /// The database.
    pub database: Database,
    /// Parameters with their present values, to judge new ones by and to know which change is protected.
    judge: Memory,
    /// What it is as long as nobody has set anything.
    delivered: Memory,
    control: String,
}

/// Bytes that an entry of the log shows.
const SHOWN: usize = 16;

impl Applier {
    /// Takes a database over.
    pub fn new(database: Database, control: &str) -> Result<Applier, Error> {
        let judge = Memory::new(control);
        let mut applier = Applier { database, delivered: judge.clone(), judge, control: control.to_owned() };
        applier.read_parameters()?;
        Ok(applier)
    }

    /// Takes this as the memory in which nobody has set anything.
    pub fn deliver(&mut self, delivered: Memory) -> Result<(), Error> {
        self.delivered = delivered;
        self.read_parameters()
    }

    /// Reads the parameters again, after changes were taken back or restored.
    pub fn read_parameters(&mut self) -> Result<(), Error> {
        let mut stored = Vec::new();
        self.database.rows(&PARAMETER, |row| {
            stored.extend(rows::parameter(&row));
            Ok(())
        })?;
        self.judge = self.delivered.clone();
        for (key, value) in stored {
            // A parameter that this version of the list refuses keeps its row and does not count.
            let _ = self.judge.parameters.set(&key, value);
        }
        Ok(())
    }

    /// Whether a change may be made. Nothing is written.
    pub fn check(&self, author: &Author, change: &Change) -> Result<(), Error> {
        self.check_author(author, change)?;
        if let Author::Person { .. } = author {
            self.check_protection(change)?;
        }
        self.check_value(change)
    }

    fn check_author(&self, author: &Author, change: &Change) -> Result<(), Error> {
        match author {
            Author::Maintenance { .. } | Author::Control => Ok(()),
            Author::Program { .. } => match change {
                Change::Parameter { .. }
                | Change::Offset { .. }
                | Change::WorkZero { .. }
                | Change::ReferencePoint { .. }
                | Change::Variable { .. } => Ok(()),
                _ => Err(Error::NotByThis),
            },
            Author::Person { session, .. } => {
                let needed = rights::needed(self.judge.parameters.table(), change);
                if !session.level.covers(needed) {
                    return Err(Error::Right { needed, level: session.level });
                }
                let name = match change {
                    Change::Program { name, .. }
                    | Change::DeleteProgram { name }
                    | Change::RenameProgram { name, .. }
                    | Change::LockProgram { name, .. } => name,
                    _ => return Ok(()),
                };
                match self.locked(name)? {
                    Some(by) if !session.level.covers(by) => Err(Error::Locked(by)),
                    _ => Ok(()),
                }
            }
        }
    }

    fn locked(&self, name: &str) -> Result<Option<Level>, Error> {
        let row = self.database.get(&PROGRAM, &[name.into()])?;
        Ok(row.and_then(rows::program).and_then(|(_, program)| program.locked))
    }

    /// What parameters forbid persons at the panel, whatever their level; whoever may change the parameter may
    /// lift it (GSK990MC 27#0, 27#4, 29#0 to 29#3, P211, P212).
    fn check_protection(&self, change: &Change) -> Result<(), Error> {
        if self.control != "gsk990mc" {
            return Ok(());
        }
        let forbidden = |number, bit| self.forbidden(number, bit);
        let of_number = |name: &str| match rights::closing_bit(name) {
            Some((number, bit)) => forbidden(number, bit),
            None => Ok(()),
        };
        match change {
            Change::Program { name, .. }
            | Change::DeleteProgram { name }
            | Change::LockProgram { name, .. } => of_number(name),
            Change::RenameProgram { name, to, .. } => of_number(name).and_then(|()| of_number(to)),
            Change::Offset { number, offset } => {
                let data = |number| self.judge.parameters.data(number);
                let (first, place) = (data(211), f64::from(*number));
                if place >= first && place < first + data(212) {
                    return Err(Error::Protected("P211".into()));
                }
                let old = self.offset(*number)?;
                let wear = |o: &ToolOffset| (o.length_wear, o.radius_wear);
                if wear(&old) != wear(offset) {
                    forbidden(29, 0)?;
                }
                match (ToolOffset { length_wear: old.length_wear, radius_wear: old.radius_wear, ..*offset })
                    == old
                {
                    true => Ok(()),
                    false => forbidden(29, 1),
                }
            }
            Change::Variable { .. } => forbidden(29, 2),
            Change::WorkZero { .. } => forbidden(29, 3),
            _ => Ok(()),
        }
    }

    fn check_value(&self, change: &Change) -> Result<(), Error> {
        let named = |good: bool, name: &str| match good {
            true => Ok(()),
            false => Err(Error::Value(rows::cut(name).into())),
        };
        match change {
            Change::Program { name, text, comment } => {
                named(rows::is_name(name) && comment.len() <= limits::TEXT, name)?;
                match text.len() <= limits::PROGRAM {
                    true => Ok(()),
                    false => Err(Error::Full(Item::Programs)),
                }
            }
            Change::RenameProgram { name, to, text } => {
                let exists =
                    |name: &str| Ok::<_, Error>(self.database.get(&PROGRAM, &[name.into()])?.is_some());
                named(exists(name)?, name)?;
                named(rows::is_name(to) && !exists(to)?, to)?;
                match text.len() <= limits::PROGRAM {
                    true => Ok(()),
                    false => Err(Error::Full(Item::Programs)),
                }
            }
            Change::DeleteProgram { name } | Change::LockProgram { name, .. } => {
                named(self.database.get(&PROGRAM, &[name.as_str().into()])?.is_some(), name)
            }
            Change::Parameter { key, value } => {
                let value = value.unwrap_or_else(|| self.delivered.parameter(key));
                self.judge.parameters.check(key, value).map_err(Error::Parameter)
            }
            Change::Offset { number, offset } => {
                let finite = rows::offset_values(offset).iter().all(|(_, value)| value.is_finite());
                let exists = (1..=self.judge.tools.last().min(ToolTable::LARGEST)).contains(number);
                named(finite && exists, &format!("offset {number}"))
            }
            Change::WorkZero { name, zero } => {
                let exists = self.judge.work.get(*name).is_some();
                named(zero.is_finite() && exists, &name.to_string())
            }
            Change::ReferencePoint { number, position } => {
                let good = (1..=4).contains(number) && position.is_finite();
                named(good, &format!("reference point {number}"))
            }
            Change::Variable { name, value } => {
                let text = rows::variable_name(name);
                let finite = value.is_none_or(|v| v.is_nan() || v.is_finite());
                let exists = rows::is_name(&text) && *name != VariableName::Number(0);
                named(finite && exists && text.parse().as_ref() == Ok(name), &text)
            }
            Change::Pitch { axis, point, value } => {
                named(value.is_finite(), &format!("pitch {} {point}", axis.name()))
            }
            Change::Plc { area, first, bytes } => {
                let good = usize::from(*first).saturating_add(bytes.len()) <= limits::AREA;
                named(good, &format!("{}{first}", area.name()))
            }
            Change::Signal { area, first, size, value } => {
                let (bytes, most) = match size {
                    SignalSize::Bit(bit) => (u32::from(*bit < 8), 1),
                    SignalSize::Bytes(bytes) => (u32::from(*bytes), u32::MAX),
                };
                let fits = bytes >= 4 || u64::from(*value) < 1 << (8 * bytes);
                let exists = usize::from(*first) + bytes as usize <= limits::AREA;
                let good = (1..=4).contains(&bytes) && exists && fits && *value <= most;
                named(good, &signal_shown(*area, *first, *size))
            }
            Change::Ladder { text: Some(text) } if text.len() > limits::LADDER => {
                Err(Error::Full(Item::Ladder))
            }
            Change::Force { signal, .. } => named(rows::is_name(signal), signal),
            Change::Counter { counter, value } => named(value.is_finite() && *value >= 0.0, counter.name()),
            Change::Alarm(alarm) => named(rows::fits(alarm), &alarm.id),
            Change::LastPosition(last) => named(last.position.is_finite(), "position"),
            Change::MachineZero { from, to, .. } => named(from.is_finite() && to.is_finite(), "position"),
            Change::Ladder { .. }
            | Change::Interrupted(_)
            | Change::Session(_)
            | Change::ClearAlarms
            | Change::ClearLog => Ok(()),
        }
    }

    /// Writes a change that was checked, and what the log says of it.
    pub fn write(&mut self, author: &Author, change: &Change, time: Time) -> Result<(), Error> {
        let mut log = Log { author, time, all: author.is_logged() };
        match change {
            Change::Program { name, text, comment } => {
                let program = Program { text: text.clone(), comment: comment.clone(), ..Program::default() };
                self.write_program(&log, name, program)
            }
            Change::DeleteProgram { name } => {
                let old = self.program(name)?;
                self.database.delete(&PROGRAM, &[name.as_str().into()])?;
                let size = old.map_or(String::new(), |old| old.text.len().to_string());
                log.changed(self, Item::Programs, name, size, String::new())
            }
            Change::RenameProgram { name, to, text } => {
                let Some(program) = self.program(name)? else { return Ok(()) };
                let program = Program { text: text.clone(), changed: time, ..program };
                self.database.delete(&PROGRAM, &[name.as_str().into()])?;
                self.database.put(&PROGRAM, &rows::program_row(to, &program))?;
                log.changed(self, Item::Programs, to, name.clone(), to.clone())
            }
            Change::LockProgram { name, locked } => {
                let Some(mut program) = self.program(name)? else { return Ok(()) };
                let shown =
                    |by: Option<Level>| by.map_or(String::new(), |l| format!("locked {}", l.number()));
                let old = shown(program.locked);
                program.locked = locked.then(|| author.level().unwrap_or(Level::Maker));
                self.database.put(&PROGRAM, &rows::program_row(name, &program))?;
                log.changed(self, Item::Programs, name, old, shown(program.locked))
            }
            Change::Parameter { key, value } => self.write_parameter(&mut log, key, *value),
            Change::Offset { number, offset } => self.write_offset(&log, *number, offset),
            Change::WorkZero { name, zero } => self.write_zero(&log, *name, zero),
            Change::ReferencePoint { number, position } => self.write_reference(&log, *number, position),
            Change::Variable { name, value } => self.write_variable(&log, name, *value),
            Change::Pitch { axis, point, value } => {
                let row = rows::pitch_row(*axis, *point, *value);
                let old = self.number(&PITCH, &row)?.unwrap_or(0.0);
                self.put(&PITCH, &row, Item::Pitch)?;
                log.numbers(self, Item::Pitch, &format!("{} {point}", axis.name()), old, *value)
            }
            Change::Plc { area, first, bytes } => self.write_signals(&log, *area, *first, bytes),
            Change::Signal { area, first, size, value } => {
                self.write_signal(&log, *area, *first, *size, *value)
            }
            Change::Ladder { text } => self.write_ladder(&mut log, text.as_deref()),
            Change::Force { signal, value } => {
                log.all = true;
                let shown = value.map_or("released".to_owned(), |on| format!("forced {}", u8::from(on)));
                log.changed(self, Item::Plc, signal, String::new(), shown)
            }
            Change::Counter { counter, value } => {
                let row = rows::counter_row(*counter, *value);
                let old = self.number(&COUNTER, &row)?.unwrap_or(0.0);
                self.database.put(&COUNTER, &row)?;
                log.numbers(self, Item::Counters, counter.name(), old, *value)
            }
            Change::Alarm(alarm) => {
                let number = self.database.highest(&ALARM)?.saturating_add(1);
                self.database.put(&ALARM, &rows::alarm_row(number, alarm))?;
                self.drop_oldest(&ALARM, limits::ALARMS)
            }
            Change::ClearAlarms => {
                let old = self.database.count(&ALARM).to_string();
                self.database.clear(&ALARM)?;
                log.changed(self, Item::Alarms, "all", old, "0".to_owned())
            }
            Change::Session(note) => {
                let (name, to) = note.names();
                let (level, who) = (author.level(), author.name().to_owned());
                let (item, from) = ("rights".to_owned(), String::new());
                let entry = LogEntry { time: log.time, level, who, item, name: name.to_owned(), from, to };
                self.log(&entry)
            }
            // It stands there even where the place keeps its name: the axis is referenced from then on.
            Change::MachineZero { axis, from, to } => {
                log.all = true;
                let name = format!("machine zero {}", axis.letter());
                log.changed(self, Item::LastPosition, &name, from.to_string(), to.to_string())
            }
            Change::ClearLog => {
                let old = self.database.count(&LOG).to_string();
                self.database.clear(&LOG)?;
                log.all = true;
                log.changed(self, Item::Log, "all", old, "0".to_owned())
            }
            Change::LastPosition(last) => self.database.put(&LAST_POSITION, &rows::last_position_row(last)),
            Change::Interrupted(Some(run)) => self.database.put(&INTERRUPTED, &rows::interrupted_row(run)),
            Change::Interrupted(None) => {
                self.database.delete(&INTERRUPTED, &[rows::INTERRUPTED_KEY.into()]).map(drop)
            }
        }
    }

    fn drop_oldest(&mut self, table: &'static Table, most: i64) -> Result<(), Error> {
        while self.database.count(table) > most
            && let Some(first) = self.database.first_key(table)?
        {
            self.database.delete(table, &[first.into()])?;
        }
        Ok(())
    }

    /// Adds an entry to the log.
    pub fn log(&mut self, entry: &LogEntry) -> Result<(), Error> {
        let number = self.database.highest(&LOG)?.saturating_add(1);
        self.database.put(&LOG, &rows::log_row(number, entry))?;
        self.drop_oldest(&LOG, limits::LOG)
    }

    /// Takes a row out where it stands for nothing, else writes it.
    fn put_unless(
        &mut self,
        is_nothing: bool,
        table: &'static Table,
        row: &[Cell],
        item: Item,
    ) -> Result<(), Error> {
        match is_nothing {
            true => self.database.delete(table, row.get(..table.keys).unwrap_or(row)).map(drop),
            false => self.put(table, row, item),
        }
    }

    /// Writes a row. One of zeros too: a set-up or machine file may have something else for who has set nothing.
    fn put(&mut self, table: &'static Table, row: &[Cell], item: Item) -> Result<(), Error> {
        self.database.put(table, row)?;
        match self.database.count(table) > rows::most_rows(item) {
            true => Err(Error::Full(item)),
            false => Ok(()),
        }
    }

    /// The number in the last cell of the row with the key of `row`.
    fn number(&self, table: &Table, row: &[Cell]) -> Result<Option<f64>, Error> {
        let key = row.get(..table.keys).unwrap_or(row);
        Ok(match self.database.get(table, key)?.as_ref().and_then(|row| row.last()) {
            Some(Cell::Real(value)) => Some(*value),
            _ => None,
        })
    }

    fn program(&self, name: &str) -> Result<Option<Program>, Error> {
        let row = self.database.get(&PROGRAM, &[name.into()])?;
        Ok(row.and_then(rows::program).map(|(_, program)| program))
    }

    fn write_program(&mut self, log: &Log, name: &str, mut program: Program) -> Result<(), Error> {
        let old = self.program(name)?;
        program.created = old.as_ref().map_or(log.time, |old| old.created);
        program.changed = log.time;
        program.locked = old.as_ref().and_then(|old| old.locked);
        self.put(&PROGRAM, &rows::program_row(name, &program), Item::Programs)?;
        let size = old.map_or(String::new(), |old| old.text.len().to_string());
        log.changed(self, Item::Programs, name, size, program.text.len().to_string())
    }

    fn write_parameter(
        &mut self,
        log: &mut Log,
        key: &ParameterKey,
        value: Option<f64>,
    ) -> Result<(), Error> {
        let delivered = self.delivered.parameter(key);
        let new = value.unwrap_or(delivered);
        // Who changed a parameter is always worth knowing.
        log.all = true;
        let name = self.judge.parameters.table().name(key);
        if let Some((place, axis)) = self.judge.place(key) {
            let mut position = self.position(place)?;
            let old = std::mem::replace(&mut position[axis], new);
            self.put_position(place, &position)?;
            return log.numbers(self, Item::Parameters, &name, old, new);
        }
        let row = rows::parameter_row(key, new);
        let old = self.number(&PARAMETER, &row)?.unwrap_or(delivered);
        // What is set to the value as delivered holds with another machine file too.
        self.put_unless(value.is_none(), &PARAMETER, &row, Item::Parameters)?;
        // It was checked.
        let _ = self.judge.parameters.set(key, new);
        log.numbers(self, Item::Parameters, &name, old, new)
    }

    fn position(&self, place: Place) -> Result<Position, Error> {
        Ok(match place {
            Place::Work(name) => self
                .database
                .get(&WORK_ZERO, &[name.to_string().into()])?
                .and_then(|row| rows::zero(&row))
                .map_or_else(|| self.delivered.work.get(name).unwrap_or_default(), |(_, zero)| zero),
            Place::Reference(n) => self
                .database
                .get(&REFERENCE_POINT, &[Cell::Whole(n as i64 + 1)])?
                .and_then(|row| rows::reference(&row))
                .map_or_else(
                    || self.delivered.reference_points.get(n).copied().unwrap_or_default(),
                    |row| row.1,
                ),
        })
    }

    fn put_position(&mut self, place: Place, position: &Position) -> Result<(), Error> {
        match place {
            Place::Work(name) => self.put(&WORK_ZERO, &rows::zero_row(name, position), Item::WorkZeros),
            Place::Reference(n) => {
                let row = rows::reference_row(u8::try_from(n + 1).unwrap_or(u8::MAX), position);
                self.put(&REFERENCE_POINT, &row, Item::ReferencePoints)
            }
        }
    }

    fn offset(&self, number: u16) -> Result<ToolOffset, Error> {
        let row = self.database.get(&TOOL_OFFSET, &[number.into()])?;
        let delivered = || self.delivered.tools.get(number).copied().unwrap_or(ToolOffset::ZERO);
        Ok(row.and_then(|row| rows::offset(&row)).map_or_else(delivered, |(_, offset)| offset))
    }

    fn write_offset(&mut self, log: &Log, number: u16, offset: &ToolOffset) -> Result<(), Error> {
        let old = match log.all {
            true => self.offset(number)?,
            false => ToolOffset::ZERO,
        };
        self.put(&TOOL_OFFSET, &rows::offset_row(number, offset), Item::Offsets)?;
        for ((name, from), (_, to)) in rows::offset_values(&old).into_iter().zip(rows::offset_values(offset))
        {
            log.numbers(self, Item::Offsets, &format!("{number} {name}"), from, to)?;
        }
        Ok(())
    }

    fn write_zero(&mut self, log: &Log, name: WorkOffset, zero: &Position) -> Result<(), Error> {
        let old = self.position(Place::Work(name))?;
        self.put_position(Place::Work(name), zero)?;
        for axis in Axis::ALL {
            log.numbers(self, Item::WorkZeros, &format!("{name} {}", axis.name()), old[axis], zero[axis])?;
        }
        Ok(())
    }

    fn write_reference(&mut self, log: &Log, number: u8, point: &Position) -> Result<(), Error> {
        let place = Place::Reference(usize::from(number).saturating_sub(1));
        let old = self.position(place)?;
        self.put_position(place, point)?;
        for axis in Axis::ALL {
            let name = format!("{number} {}", axis.name());
            log.numbers(self, Item::ReferencePoints, &name, old[axis], point[axis])?;
        }
        Ok(())
    }

    fn write_variable(&mut self, log: &Log, name: &VariableName, value: Option<f64>) -> Result<(), Error> {
        // No number is an empty variable, as in the running control.
        let value = value.filter(|value| !value.is_nan());
        let row = rows::variable_row(name, value.unwrap_or(0.0));
        let old = match log.all {
            true => self.number(&VARIABLE, &row)?,
            false => None,
        };
        self.put_unless(value.is_none(), &VARIABLE, &row, Item::Variables)?;
        let shown = |value: Option<f64>| value.map_or(String::new(), |value| value.to_string());
        log.changed(self, Item::Variables, &rows::variable_name(name), shown(old), shown(value))
    }

    fn write_signals(&mut self, log: &Log, area: PlcArea, first: u16, bytes: &[u8]) -> Result<(), Error> {
        let before = self.replace_bytes(area, first, bytes)?;
        let shown = |bytes: &[u8]| bytes.iter().take(SHOWN).map(|b| format!("{b:02x}")).collect::<String>();
        log.changed(self, Item::Plc, &format!("{}{first}", area.name()), shown(&before), shown(bytes))
    }

    fn write_signal(
        &mut self,
        log: &Log,
        area: PlcArea,
        first: u16,
        size: SignalSize,
        value: u32,
    ) -> Result<(), Error> {
        let before = match size {
            SignalSize::Bit(bit) => {
                let block = self.signal_block(area, usize::from(first) / BLOCK)?;
                let byte = block.get(usize::from(first) % BLOCK).copied().unwrap_or(0);
                let cleared = byte & !(1 << bit);
                self.replace_bytes(area, first, &[if value == 0 { cleared } else { byte | 1 << bit }])?;
                u32::from(byte >> bit & 1)
            }
            SignalSize::Bytes(count) => {
                let bytes = value.to_le_bytes();
                let before = self.replace_bytes(area, first, bytes.get(..count.into()).unwrap_or(&bytes))?;
                before.iter().rev().fold(0, |all, byte| all << 8 | u32::from(*byte))
            }
        };
        log.changed(self, Item::Plc, &signal_shown(area, first, size), before.to_string(), value.to_string())
    }

    /// A block of bytes that the ladder keeps.
    fn signal_block(&self, area: PlcArea, block: usize) -> Result<Vec<u8>, Error> {
        let number = u16::try_from(block).unwrap_or(u16::MAX);
        let row = self.database.get(&SIGNAL, &[area.name().into(), number.into()])?;
        match row.as_deref() {
            Some([_, _, Cell::Bytes(kept)]) if kept.len() == BLOCK => Ok(kept.clone()),
            Some(_) => Err(Error::damaged(Finding::Row { table: SIGNAL.name })),
            None => Ok(vec![0; BLOCK]),
        }
    }

    /// Writes bytes that the ladder keeps; what they were.
    fn replace_bytes(&mut self, area: PlcArea, first: u16, bytes: &[u8]) -> Result<Vec<u8>, Error> {
        let mut at = usize::from(first);
        let mut left = bytes;
        let mut before: Vec<u8> = Vec::new();
        while !left.is_empty() {
            let (block, within) = (at / BLOCK, at % BLOCK);
            let (now, rest) = left.split_at(left.len().min(BLOCK - within));
            let mut kept = self.signal_block(area, block)?;
            for (to, from) in kept.iter_mut().skip(within).zip(now) {
                before.push(std::mem::replace(to, *from));
            }
            let number = u16::try_from(block).unwrap_or(u16::MAX);
            self.put(&SIGNAL, &rows::signal_row(area, number, kept), Item::Plc)?;
            (at, left) = (at + now.len(), rest);
        }
        Ok(before)
    }

    fn write_ladder(&mut self, log: &mut Log, text: Option<&str>) -> Result<(), Error> {
        // GSK990MC operation 3.7: the log has what was changed in the ladder, whoever did it.
        log.all = true;
        let key = [rows::LADDER_KEY.into()];
        let row = self.database.get(&LADDER, &key)?;
        let old = row.as_deref().and_then(rows::ladder).map(ladder_shown).unwrap_or_default();
        match text {
            Some(text) => self.database.put(&LADDER, &rows::ladder_row(text))?,
            None => self.database.delete(&LADDER, &key).map(drop)?,
        }
        log.changed(self, Item::Ladder, "exchanged", old, text.map(ladder_shown).unwrap_or_default())
    }

    /// Replaces an item by rows of a backup: programs are put beside those that there are, histories are merged,
    /// all else becomes what the backup has.
    pub fn clear_for_restore(&mut self, item: Item) -> Result<(), Error> {
        match item {
            Item::Programs | Item::Alarms | Item::Log => Ok(()),
            _ => self.database.clear(rows::table(item)),
        }
    }

    /// Whether an item may be put back as a whole: not by a person where any row of it is closed.
    pub fn check_restore(&self, author: &Author, item: Item) -> Result<(), Error> {
        if !matches!(author, Author::Person { .. }) || self.control != "gsk990mc" {
            return Ok(());
        }
        match item {
            Item::Offsets if self.judge.parameters.data(212) > 0.0 => Err(Error::Protected("P211".into())),
            Item::Offsets => self.forbidden(29, 0).and_then(|()| self.forbidden(29, 1)),
            Item::Variables => self.forbidden(29, 2),
            Item::WorkZeros => self.forbidden(29, 3),
            _ => Ok(()),
        }
    }

    /// What this bit forbids persons at the panel.
    fn forbidden(&self, number: u16, bit: u8) -> Result<(), Error> {
        match self.judge.parameters.bit(number, bit) {
            true => Err(Error::Protected(format!("NO{number}.{bit}").into())),
            false => Ok(()),
        }
    }

    /// Whether a row of a backup is one that the control takes, and the author may write.
    pub fn check_row(&self, author: &Author, item: Item, row: &Row) -> Result<(), Error> {
        let change = match item {
            Item::Programs => match row.first() {
                Some(Cell::Text(name)) => {
                    let change = Change::DeleteProgram { name: name.clone() };
                    // Locked or protected programs stay what they are.
                    self.check_author(author, &change)?;
                    return match author {
                        Author::Person { .. } => self.check_protection(&change),
                        _ => Ok(()),
                    };
                }
                _ => None,
            },
            Item::Parameters => rows::parameter(row).and_then(|(key, value)| {
                // These are kept as the zeros that they are other names of.
                let is_itself = self.judge.place(&key).is_none();
                is_itself.then_some(Change::Parameter { key, value: Some(value) })
            }),
            Item::Offsets => rows::offset(row).map(|(number, offset)| Change::Offset { number, offset }),
            Item::WorkZeros => rows::zero(row).map(|(name, zero)| Change::WorkZero { name, zero }),
            _ => return Ok(()),
        };
        match change {
            Some(change) => self.check_value(&change),
            None => Err(Error::Value(item.name().into())),
        }
    }

    /// Writes a row of a backup.
    pub fn restore_row(&mut self, item: Item, row: &Row) -> Result<(), Error> {
        self.put(rows::table(item), row, item)
    }

    /// Merges a history with that of a backup: both in the order of time, what is in both once, the newest kept.
    pub fn merge_history(&mut self, item: Item, other: Vec<Row>) -> Result<(), Error> {
        let table = rows::table(item);
        let mut all = other;
        self.database.rows(table, |row| {
            all.push(row);
            Ok(())
        })?;
        // The second cell is the time; the first counts, and is counted anew.
        let time = |row: &Row| match row.get(1) {
            Some(Cell::Whole(time)) => *time,
            _ => 0,
        };
        all.sort_by_key(time);
        let mut seen = HashSet::new();
        let mut merged: Vec<Row> = Vec::with_capacity(all.len());
        for mut row in all {
            if let Some(first) = row.first_mut() {
                *first = Cell::Whole(0);
            }
            if seen.insert(table.sum(&row)) {
                merged.push(row);
            }
        }
        self.database.clear(table)?;
        let most = usize::try_from(rows::most_rows(item)).unwrap_or(0);
        let skipped = merged.len().saturating_sub(most);
        for (number, mut row) in (1i64..).zip(merged.into_iter().skip(skipped)) {
            if let Some(first) = row.first_mut() {
                *first = number.into();
            }
            self.database.put(table, &row)?;
        }
        Ok(())
    }
}

/// `D0012`, `K0003.2`.
fn signal_shown(area: PlcArea, first: u16, size: SignalSize) -> String {
    match size {
        SignalSize::Bit(bit) => format!("{}{first:04}.{bit}", area.name()),
        SignalSize::Bytes(_) => format!("{}{first:04}", area.name()),
    }
}

/// How the log tells ladders apart: bytes, and the head of the sum over them.
fn ladder_shown(text: &str) -> String {
    let mut sum = FileSum::default();
    sum.add(text.as_bytes());
    format!("{} {:.12}", text.len(), sum.finish())
}

/// How a change goes into the log.
struct Log<'a> {
    author: &'a Author,
    time: Time,
    /// Whether it goes there at all.
    all: bool,
}

impl Log<'_> {
    fn numbers(&self, to: &mut Applier, item: Item, name: &str, old: f64, new: f64) -> Result<(), Error> {
        match old == new {
            true => Ok(()),
            false => self.changed(to, item, name, old.to_string(), new.to_string()),
        }
    }

    fn changed(
        &self,
        to: &mut Applier,
        item: Item,
        name: &str,
        old: String,
        new: String,
    ) -> Result<(), Error> {
        if !self.all {
            return Ok(());
        }
        to.log(&LogEntry {
            time: self.time,
            level: self.author.level(),
            who: self.author.name().to_owned(),
            item: item.name().to_owned(),
            name: name.to_owned(),
            from: old,
            to: new,
        })
    }
}
