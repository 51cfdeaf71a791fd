//! Items as rows and back. A row that holds what no change could have stored is refused: it comes from damage or
//! from a foreign backup.

use crate::items::{
    AlarmEntry, Contents, Counter, InterruptedRun, Item, LastPosition, LogEntry, PlcArea, Program,
    ProgramEntry, Time, limits,
};
use crate::rights::Level;
use crate::table::{
    ALARM, COUNTER, Cell, INTERRUPTED, LADDER, LAST_POSITION, LOG, PARAMETER, PITCH, PROGRAM,
    REFERENCE_POINT, Row, SIGNAL, TOOL_OFFSET, Table, VARIABLE, WORK_ZERO,
};
use ferrocut_geometry::{Axis, AxisSet, Position};
use ferrocut_machine::setup::VariableName;
use ferrocut_machine::{ParameterKey, ToolOffset, ToolTable, WorkOffset, WorkOffsets};

/// Bytes of a row of the ladder's signals: a change of one writes little, and all are few rows.
pub const BLOCK: usize = 64;

/// The table of an item.
pub fn table(item: Item) -> &'static Table {
    match item {
        Item::Programs => &PROGRAM,
        Item::Parameters => &PARAMETER,
        Item::Offsets => &TOOL_OFFSET,
        Item::WorkZeros => &WORK_ZERO,
        Item::ReferencePoints => &REFERENCE_POINT,
        Item::Variables => &VARIABLE,
        Item::Pitch => &PITCH,
        Item::Plc => &SIGNAL,
        Item::Counters => &COUNTER,
        Item::Alarms => &ALARM,
        Item::Log => &LOG,
        Item::LastPosition => &LAST_POSITION,
        Item::Interrupted => &INTERRUPTED,
        Item::Ladder => &LADDER,
    }
}

/// The item that a table belongs to.
pub fn item(name: &str) -> Option<Item> {
    Item::ALL.into_iter().find(|item| table(*item).name == name)
}

/// Most rows of an item.
pub fn most_rows(item: Item) -> i64 {
    match item {
        Item::Programs => limits::PROGRAMS,
        Item::Parameters | Item::Variables | Item::Pitch => limits::VALUES,
        Item::Offsets => i64::from(ToolTable::LARGEST),
        Item::WorkZeros => i64::from(WorkOffsets::LARGEST) + 7,
        Item::ReferencePoints => 4,
        Item::Plc => 4 * (limits::AREA.div_ceil(BLOCK) as i64),
        Item::Counters => Counter::ALL.len() as i64,
        Item::Alarms => limits::ALARMS,
        Item::Log => limits::LOG,
        Item::LastPosition | Item::Interrupted | Item::Ladder => 1,
    }
}

/// Whether a name can be that of a program or a variable.
pub fn is_name(name: &str) -> bool {
    (1..=limits::NAME).contains(&name.len()) && !name.chars().any(char::is_control)
}

fn is_text(text: &str) -> bool {
    text.len() <= limits::TEXT
}

fn position_cells(position: &Position) -> impl Iterator<Item = Cell> {
    position.0.into_iter().map(Cell::from)
}

/// Cells of a position that may not be known.
const PLACE_CELLS: usize = 1 + Axis::ALL.len();

/// Such a position, and whether it is known.
fn place_cells(place: Option<&Position>) -> impl Iterator<Item = Cell> {
    let position = place.copied().unwrap_or_default();
    [u8::from(place.is_some()).into()].into_iter().chain(position.0.map(Cell::from))
}

/// The place in such cells.
fn place(cells: &[Cell]) -> Option<Option<Position>> {
    let [Cell::Whole(is_known @ (0 | 1)), axes @ ..] = cells else { return None };
    let position = position(axes)?;
    Some((*is_known == 1).then_some(position))
}

fn position(cells: &[Cell]) -> Option<Position> {
    let mut position = Position::ZERO;
    for axis in Axis::ALL {
        position[axis] = real(cells.get(axis.index())?)?;
    }
    Some(position)
}

fn real(cell: &Cell) -> Option<f64> {
    match cell {
        Cell::Real(value) if value.is_finite() => Some(*value),
        _ => None,
    }
}

fn level_cell(level: Option<Level>) -> Cell {
    level.map_or(0, Level::number).into()
}

fn level(number: i64) -> Option<Option<Level>> {
    match number {
        0 => Some(None),
        number => Level::of(number).map(Some),
    }
}

/// A program as a row.
pub fn program_row(name: &str, program: &Program) -> Row {
    vec![
        name.into(),
        program.comment.as_str().into(),
        program.created.into(),
        program.changed.into(),
        level_cell(program.locked),
        Cell::Bytes(program.text.clone()),
    ]
}

/// A program of a row.
pub fn program(row: Row) -> Option<(String, Program)> {
    let mut cells = row.into_iter();
    let mut next = || cells.next();
    let (
        Cell::Text(name),
        Cell::Text(comment),
        Cell::Whole(created),
        Cell::Whole(changed),
        Cell::Whole(locked),
    ) = (next()?, next()?, next()?, next()?, next()?)
    else {
        return None;
    };
    let Cell::Bytes(text) = next()? else { return None };
    let fits = is_name(&name) && is_text(&comment) && text.len() <= limits::PROGRAM;
    fits.then_some((name, Program { text, comment, created, changed, locked: level(locked)? }))
}

/// A program of a row without its text.
pub fn program_entry(row: Row, bytes: u64) -> Option<ProgramEntry> {
    let mut row = row;
    row.push(Cell::Bytes(Vec::new()));
    let (name, Program { comment, created, changed, locked, .. }) = program(row)?;
    Some(ProgramEntry { name, bytes, comment, created, changed, locked })
}

/// A parameter as a row.
pub fn parameter_row(key: &ParameterKey, value: f64) -> Row {
    vec![key.to_string().into(), value.into()]
}

/// A parameter of a row.
pub fn parameter(row: &[Cell]) -> Option<(ParameterKey, f64)> {
    let [Cell::Text(name), value] = row else { return None };
    // Names are written in one form only, or one parameter could have two rows.
    let key: ParameterKey = name.parse().ok().filter(|key: &ParameterKey| key.to_string() == *name)?;
    is_name(name).then_some((key, real(value)?))
}

/// A tool offset as a row.
pub fn offset_row(number: u16, offset: &ToolOffset) -> Row {
    let values = offset_values(offset).map(|(_, value)| Cell::from(value));
    [Cell::from(number)].into_iter().chain(values).collect()
}

/// The values of a tool offset by their names.
pub fn offset_values(offset: &ToolOffset) -> [(&'static str, f64); 7] {
    [
        ("length", offset.length),
        ("length_wear", offset.length_wear),
        ("radius", offset.radius),
        ("radius_wear", offset.radius_wear),
        ("cutting_length", offset.cutting_length),
        ("entry_angle", offset.entry_angle),
        ("tip_radius", offset.tip_radius),
    ]
}

/// A tool offset of a row.
pub fn offset(row: &[Cell]) -> Option<(u16, ToolOffset)> {
    let [Cell::Whole(number), l, lw, r, rw, cutting, entry, tip] = row else { return None };
    let number = u16::try_from(*number).ok().filter(|n| (1..=ToolTable::LARGEST).contains(n))?;
    let offset = ToolOffset {
        length: real(l)?,
        length_wear: real(lw)?,
        radius: real(r)?,
        radius_wear: real(rw)?,
        cutting_length: real(cutting)?,
        entry_angle: real(entry)?,
        tip_radius: real(tip)?,
    };
    Some((number, offset))
}

/// A work zero as a row.
pub fn zero_row(name: WorkOffset, zero: &Position) -> Row {
    [Cell::from(name.to_string())].into_iter().chain(position_cells(zero)).collect()
}

/// A work zero of a row.
pub fn zero(row: &[Cell]) -> Option<(WorkOffset, Position)> {
    let (Cell::Text(name), cells) = row.split_first()? else { return None };
    let offset: WorkOffset = name.parse().ok().filter(|offset: &WorkOffset| offset.to_string() == *name)?;
    let exists = !matches!(offset, WorkOffset::Additional(n) if n > WorkOffsets::LARGEST);
    exists.then_some((offset, position(cells)?))
}

/// A reference point as a row.
pub fn reference_row(number: u8, point: &Position) -> Row {
    [Cell::from(number)].into_iter().chain(position_cells(point)).collect()
}

/// A reference point of a row.
pub fn reference(row: &[Cell]) -> Option<(u8, Position)> {
    let (Cell::Whole(number), cells) = row.split_first()? else { return None };
    let number = u8::try_from(*number).ok().filter(|n| (1..=4).contains(n))?;
    Some((number, position(cells)?))
}

/// How a variable is written.
pub fn variable_name(name: &VariableName) -> String {
    match name {
        VariableName::Number(number) => format!("#{number}"),
        VariableName::Named(name) => name.to_string(),
    }
}

/// A variable as a row.
pub fn variable_row(name: &VariableName, value: f64) -> Row {
    vec![variable_name(name).into(), value.into()]
}

/// A variable of a row.
pub fn variable(row: &[Cell]) -> Option<(VariableName, f64)> {
    let [Cell::Text(name), value] = row else { return None };
    let key: VariableName = name.parse().ok().filter(|key| variable_name(key) == *name)?;
    let exists = is_name(name) && key != VariableName::Number(0);
    exists.then_some((key, real(value)?))
}

/// A point of a pitch table as a row.
pub fn pitch_row(axis: Axis, point: u16, value: f64) -> Row {
    vec![axis.name().into(), point.into(), value.into()]
}

/// A point of a pitch table of a row.
pub fn pitch(row: &[Cell]) -> Option<((Axis, u16), f64)> {
    let [Cell::Text(axis), Cell::Whole(point), value] = row else { return None };
    let axis = Axis::ALL.into_iter().find(|a| a.name() == axis)?;
    Some(((axis, u16::try_from(*point).ok()?), real(value)?))
}

/// A block of the ladder's signals as a row.
pub fn signal_row(area: PlcArea, block: u16, bytes: Vec<u8>) -> Row {
    vec![area.name().into(), block.into(), Cell::Bytes(bytes)]
}

/// A block of the ladder's signals of a row: area, first byte, bytes.
pub fn signal(row: &[Cell]) -> Option<(PlcArea, usize, &[u8])> {
    let [Cell::Text(area), Cell::Whole(block), Cell::Bytes(bytes)] = row else { return None };
    let first = usize::try_from(*block).ok()?.checked_mul(BLOCK)?;
    let fits = bytes.len() == BLOCK && first < limits::AREA;
    fits.then_some((PlcArea::named(area)?, first, bytes))
}

/// A counter as a row.
pub fn counter_row(counter: Counter, value: f64) -> Row {
    vec![counter.name().into(), value.into()]
}

/// A counter of a row.
pub fn counter(row: &[Cell]) -> Option<(Counter, f64)> {
    let [Cell::Text(name), value] = row else { return None };
    Some((Counter::named(name)?, real(value)?))
}

/// An alarm as a row.
pub fn alarm_row(number: i64, alarm: &AlarmEntry) -> Row {
    // Lists of texts always become JSON.
    let arguments = serde_json::to_string(&alarm.arguments).unwrap_or_else(|_| "[]".to_owned());
    vec![
        number.into(),
        alarm.time.into(),
        alarm.id.as_str().into(),
        alarm.program.as_str().into(),
        alarm.line.into(),
        arguments.into(),
    ]
}

/// An alarm of a row.
pub fn alarm(row: &[Cell]) -> Option<AlarmEntry> {
    let [
        Cell::Whole(_),
        Cell::Whole(time),
        Cell::Text(id),
        Cell::Text(program),
        Cell::Whole(line),
        Cell::Text(arguments),
    ] = row
    else {
        return None;
    };
    let short = is_name(id) && is_text(program) && arguments.len() <= 4 * limits::ARGUMENTS * limits::TEXT;
    let arguments: Vec<(String, String)> = short.then(|| serde_json::from_str(arguments).ok()).flatten()?;
    let entry = AlarmEntry {
        time: *time,
        id: id.clone(),
        program: program.clone(),
        line: u32::try_from(*line).ok()?,
        arguments,
    };
    fits(&entry).then_some(entry)
}

/// Whether an alarm is one that the history takes.
pub fn fits(alarm: &AlarmEntry) -> bool {
    is_name(&alarm.id)
        && is_text(&alarm.program)
        && alarm.arguments.len() <= limits::ARGUMENTS
        && alarm.arguments.iter().all(|(name, value)| is_text(name) && is_text(value))
}

/// An entry of the log as a row; texts that are too long are cut.
pub fn log_row(number: i64, entry: &LogEntry) -> Row {
    vec![
        number.into(),
        entry.time.into(),
        level_cell(entry.level),
        cut(&entry.who).into(),
        cut(&entry.item).into(),
        cut(&entry.name).into(),
        cut(&entry.from).into(),
        cut(&entry.to).into(),
    ]
}

/// An entry of the log of a row.
pub fn log(row: &[Cell]) -> Option<LogEntry> {
    let [
        Cell::Whole(_),
        Cell::Whole(time),
        Cell::Whole(number),
        Cell::Text(who),
        Cell::Text(item),
        Cell::Text(name),
        Cell::Text(from),
        Cell::Text(to),
    ] = row
    else {
        return None;
    };
    let short = [who, item, name, from, to].into_iter().all(|text| is_text(text));
    short.then_some(LogEntry {
        time: *time,
        level: level(*number)?,
        who: who.clone(),
        item: item.clone(),
        name: name.clone(),
        from: from.clone(),
        to: to.clone(),
    })
}

/// A text that a row takes: what is too long is cut between two characters.
pub fn cut(text: &str) -> &str {
    let mut end = text.len().min(limits::TEXT);
    while !text.is_char_boundary(end) {
        end -= 1;
    }
    text.get(..end).unwrap_or_default()
}

/// The last position as a row.
pub fn last_position_row(last: &LastPosition) -> Row {
    let referenced = last.referenced.iter().map(|axis| 1i64 << axis.index()).sum::<i64>();
    let system = last.work_system.map(|system| system.to_string()).unwrap_or_default();
    let named: [Cell; 4] = [1u8.into(), last.time.into(), referenced.into(), system.into()];
    named
        .into_iter()
        .chain(place_cells(last.own_zero.as_ref()))
        .chain(position_cells(&last.position))
        .collect()
}

/// The last position of version 4 of the schema, which knew no zero of G92, as one of today.
pub fn last_position_without_zero(mut row: Row) -> Row {
    let position = row.len().saturating_sub(Axis::ALL.len());
    row.splice(position..position, place_cells(None));
    row
}

/// The last position of a row.
pub fn last_position(row: &[Cell]) -> Option<LastPosition> {
    let [Cell::Whole(1), Cell::Whole(time), Cell::Whole(referenced), Cell::Text(system), rest @ ..] = row
    else {
        return None;
    };
    let (zero, axes) = rest.split_at_checked(PLACE_CELLS)?;
    let referenced = u16::try_from(*referenced).ok().filter(|bits| *bits < 1 << Axis::ALL.len())?;
    let work_system = match system.as_str() {
        "" => None,
        name => Some(name.parse().ok()?),
    };
    Some(LastPosition {
        time: Time::from(*time),
        position: position(axes)?,
        referenced: AxisSet::from_bits(referenced),
        work_system,
        own_zero: place(zero)?,
    })
}

/// A row of an item as it is today, of one that an older version wrote.
pub fn of_today(item: Item, row: Row) -> Row {
    let is_older = row.len() + PLACE_CELLS == table(item).columns.len();
    match item {
        Item::LastPosition if is_older => last_position_without_zero(row),
        Item::Interrupted if is_older => interrupted_without_place(row),
        _ => row,
    }
}

/// The key of the one row of an interrupted run.
pub const INTERRUPTED_KEY: u8 = 1;

/// An interrupted run as a row.
pub fn interrupted_row(run: &InterruptedRun) -> Row {
    let run_cells: [Cell; 8] = [
        INTERRUPTED_KEY.into(),
        run.time.into(),
        cut(&run.program).into(),
        i64::from(run.from_line).into(),
        cut(&run.file).into(),
        i64::from(run.line).into(),
        i64::try_from(run.block).unwrap_or(i64::MAX).into(),
        cut(&run.text).into(),
    ];
    run_cells.into_iter().chain(place_cells(run.at.as_ref())).collect()
}

/// A row of an interrupted run of version 2 of the schema, which knew no place, as one of today.
pub fn interrupted_without_place(mut row: Row) -> Row {
    row.extend(place_cells(None));
    row
}

/// The interrupted run of a row.
pub fn interrupted(row: &[Cell]) -> Option<InterruptedRun> {
    let [
        Cell::Whole(1),
        Cell::Whole(time),
        Cell::Text(program),
        Cell::Whole(from),
        Cell::Text(file),
        Cell::Whole(line),
        Cell::Whole(block),
        Cell::Text(text),
        at @ ..,
    ] = row
    else {
        return None;
    };
    let at = place(at)?;
    let is_short = [program, file, text].iter().all(|text| text.len() <= limits::TEXT);
    is_short.then_some(())?;
    Some(InterruptedRun {
        time: *time,
        program: program.clone(),
        from_line: u32::try_from(*from).ok()?,
        file: file.clone(),
        line: u32::try_from(*line).ok()?,
        block: u64::try_from(*block).ok()?,
        text: text.clone(),
        at,
    })
}

/// The key of the one row of the ladder.
pub const LADDER_KEY: u8 = 1;

/// A ladder as a row.
pub fn ladder_row(text: &str) -> Row {
    vec![LADDER_KEY.into(), text.into()]
}

/// The ladder of a row.
pub fn ladder(row: &[Cell]) -> Option<&str> {
    let [Cell::Whole(1), Cell::Text(text)] = row else { return None };
    (text.len() <= limits::LADDER).then_some(text)
}

/// Whether a row of an item's table holds what the item can hold.
pub fn is_valid(item: Item, row: &Row) -> bool {
    table(item).fits(row)
        && match item {
            Item::Programs => program(row.clone()).is_some(),
            Item::Parameters => parameter(row).is_some(),
            Item::Offsets => offset(row).is_some(),
            Item::WorkZeros => zero(row).is_some(),
            Item::ReferencePoints => reference(row).is_some(),
            Item::Variables => variable(row).is_some(),
            Item::Pitch => pitch(row).is_some(),
            Item::Plc => signal(row).is_some(),
            Item::Counters => counter(row).is_some(),
            Item::Alarms => alarm(row).is_some(),
            Item::Log => log(row).is_some(),
            Item::LastPosition => last_position(row).is_some(),
            Item::Interrupted => interrupted(row).is_some(),
            Item::Ladder => ladder(row).is_some(),
        }
}

impl Contents {
    /// Takes in a row of an item; false where it holds what the item cannot. Rows come in the order of their
    /// keys.
    pub(crate) fn take(&mut self, item: Item, row: Row) -> bool {
        fn put<T>(found: Option<T>, put: impl FnOnce(T)) -> bool {
            found.map(put).is_some()
        }
        match item {
            Item::Programs => put(program(row), |(name, program)| {
                self.programs.insert(name, program);
            }),
            Item::Parameters => put(parameter(&row), |(key, value)| {
                self.parameters.insert(key, value);
            }),
            Item::Offsets => put(offset(&row), |(number, row)| {
                self.offsets.insert(number, row);
            }),
            Item::WorkZeros => put(zero(&row), |(name, zero)| {
                self.work_zeros.insert(name, zero);
            }),
            Item::ReferencePoints => put(reference(&row), |(number, point)| {
                self.reference_points.insert(number, point);
            }),
            Item::Variables => put(variable(&row), |(name, value)| {
                self.variables.insert(name, value);
            }),
            Item::Pitch => put(pitch(&row), |(point, value)| {
                self.pitch.insert(point, value);
            }),
            Item::Plc => put(signal(&row), |(area, first, bytes)| {
                let kept = self.plc.entry(area).or_default();
                kept.resize(kept.len().max(first + bytes.len()).min(limits::AREA), 0);
                for (to, from) in kept.iter_mut().skip(first).zip(bytes) {
                    *to = *from;
                }
            }),
            Item::Counters => put(counter(&row), |(counter, value)| {
                self.counters.insert(counter, value);
            }),
            Item::Alarms => put(alarm(&row), |alarm| self.alarms.push(alarm)),
            Item::Log => put(log(&row), |entry| self.log.push(entry)),
            Item::LastPosition => put(last_position(&row), |last| self.last_position = Some(last)),
            Item::Interrupted => put(interrupted(&row), |run| self.interrupted = Some(run)),
            Item::Ladder => put(ladder(&row), |text| self.ladder = Some(text.to_owned())),
        }
    }
}
