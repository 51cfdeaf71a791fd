//! What planner and interpolator share: queues that neither waits at, and one word that says which period has begun.
//!
//! ```text
//! Planner                                        Interpolator
//!   stretches ─▶ ring ───────────────────────────▶ evaluated in closed form
//!   cells     ─▶ ring ───────────────────────────▶ where a length on the path lies
//!   marks     ─▶ ring ───────────────────────────▶ which block that is
//!   axes      ─▶ ring ───────────────────────────▶ a move of every axis on its own
//!   changes   ─▶ ring ───────────────────────────▶ from which period on what of it holds
//!                      gate: period ◀────────────  counted on as it begins
//! ```
//!
//! **Stretches are counted** from the first one on; the one being run has a number, and what follows it the next ones.
//! A new plan is a **course**: the stretches from some number on are others from now on. They lie in one piece in the
//! ring, so taking them over is noting where, however many there are.
//!
//! **The gate** decides whether a change comes in time. It is one word: how many periods have begun, and how many
//! changes hold. The interpolator adds a period, the planner adds changes only while the period that they are for has
//! not begun. Either comes first, and both know it: in time, the change holds from exactly that period on; else not at
//! all, and what runs goes on.
//!
//! Nobody waits, nothing is locked, and what is read is copied: nothing is freed in the period.

use crate::path::shape::{Cubic, Shape, Smooth};
use crate::timing::axes::AxesRun;
use crate::timing::plan::{STRETCHES, Stretch};
use crate::timing::queue::{CELLS, Cell, MARKS, Mark, Node};
use ferrocut_geometry::AXES;
use rtrb::{Consumer, Producer, RingBuffer};
use std::collections::VecDeque;
use std::sync::Arc;
use std::sync::atomic::{AtomicU64, Ordering};

/// Places in the rings: what the planner knows, and as much again that was passed or replaced meanwhile.
const CELL_PLACES: usize = 2 * CELLS;
const MARK_PLACES: usize = 2 * MARKS;
const STRETCH_PLACES: usize = 3 * STRETCHES;

/// Changes on their way: [`CHANGES_A_PERIOD`](crate::planner) for every period that the planner may be ahead.
const CHANGE_PLACES: usize = 4096;

/// Moves of every axis on its own on their way.
const RUN_PLACES: usize = 256;

/// Courses of which a part is still to be run. A new one is begun when 64 cells are new, or at the place being run.
const COURSES: usize = 256;

/// How often an attempt to add changes is repeated at most because a period began meanwhile.
const ATTEMPTS: usize = 8;

/// The word: periods that have begun above, changes that hold below.
#[derive(Debug, Default)]
pub(crate) struct Gate {
    word: AtomicU64,
    /// Periods that are over.
    done: AtomicU64,
}

const PERIOD: u64 = 1 << 16;

impl Gate {
    /// A period begins: its number from 0, and how many changes hold, modulo 2¹⁶.
    fn begin(&self) -> (u64, u16) {
        let word = self.word.fetch_add(PERIOD, Ordering::AcqRel);
        (word / PERIOD, (word % PERIOD) as u16)
    }

    fn end(&self, period: u64) {
        self.done.store(period + 1, Ordering::Release);
    }

    /// How many periods have begun.
    pub fn begun(&self) -> u64 {
        self.word.load(Ordering::Acquire) / PERIOD
    }

    /// How many periods are over.
    pub fn done(&self) -> u64 {
        self.done.load(Ordering::Acquire)
    }

    /// Makes `count` more changes hold, unless `period` has begun.
    fn add(&self, count: u16, period: u64) -> bool {
        let mut word = self.word.load(Ordering::Acquire);
        for _ in 0..ATTEMPTS {
            if word / PERIOD > period {
                return false;
            }
            let changes = ((word % PERIOD) as u16).wrapping_add(count);
            let new = word - word % PERIOD + u64::from(changes);
            match self.word.compare_exchange(word, new, Ordering::AcqRel, Ordering::Acquire) {
                Ok(_) => return true,
                Err(now) => word = now,
            }
        }
        false
    }
}

/// A cell, as interpolation needs it.
#[derive(Debug)]
pub(crate) struct Strip<'a> {
    /// Length at its start, mm.
    pub s: f64,
    pub len: f64,
    pub cell: &'a Cell,
}

impl<'a> Strip<'a> {
    pub fn new(node: &Node, cell: &'a Cell) -> Strip<'a> {
        Strip { s: node.s, len: node.len, cell }
    }
}

/// A cell on its way.
#[derive(Clone, Copy, Debug)]
struct Slip {
    s: f64,
    len: f64,
    rests: bool,
    form: Form,
    /// How many cells were handed over whole, up to this one.
    wholes: u64,
}

/// Most cells are of smoothed runs in X, Y and Z: what such a one has takes a third of the room that the largest has.
#[derive(Clone, Copy, Debug)]
enum Form {
    Xyz(Cubic<3>, [f64; AXES - 3]),
    /// A cell of its own.
    Whole,
}

impl Form {
    #[inline]
    fn of(cell: &Cell) -> Form {
        match &cell.shape {
            Shape::Smooth(Smooth::Xyz(cubic, others)) if cell.rest.is_none() && !cell.is_back => {
                Form::Xyz(*cubic, *others)
            }
            _ => Form::Whole,
        }
    }

    /// The cell that it is; `None` of one of its own.
    #[inline]
    fn cell(&self) -> Option<Cell> {
        let Form::Xyz(cubic, others) = self else { return None };
        Some(Cell::new(Shape::Smooth(Smooth::Xyz(*cubic, *others)), None))
    }
}

/// What holds from a period on.
#[derive(Clone, Copy, Debug)]
pub(crate) struct Course {
    /// The first stretch that is another, and how many there are from it on.
    pub from: u64,
    pub count: u64,
    /// Where in the ring they begin.
    place: u64,
    /// Cells and marks before these are of no more use.
    pub cell: u64,
    pub mark: u64,
    /// It begins at rest, with its first stretch.
    pub begins: bool,
}

#[derive(Clone, Copy, Debug)]
enum Change {
    Course(Course),
    /// The next move of every axis on its own is this one.
    Axes,
}

#[derive(Clone, Copy, Debug)]
struct Dated {
    period: u64,
    change: Change,
}

/// The planner's side.
#[derive(Debug)]
pub(crate) struct Sender {
    pub gate: Arc<Gate>,
    stretches: Producer<Stretch>,
    /// How many were put in.
    places: u64,
    cells: Producer<Slip>,
    /// Those of them that are handed over whole, and how many were.
    wholes: Producer<Cell>,
    count: u64,
    marks: Producer<Mark>,
    runs: Producer<AxesRun>,
    changes: Producer<Dated>,
    /// Changes put in that do not hold yet, or never will.
    open: u16,
}

impl Sender {
    /// Whether there is room for this many stretches, cells and marks, and for a change.
    pub fn has_room(&self, stretches: usize, cells: usize, marks: usize) -> bool {
        self.stretches.slots() >= stretches
            && self.cells.slots() >= cells
            && self.wholes.slots() >= cells
            && self.marks.slots() >= marks
            && self.changes.slots() >= 2
            && self.runs.slots() >= 1
            && self.open < u16::MAX - 2
    }

    /// Adds a cell; whether there was room.
    pub fn cell(&mut self, node: &Node, cell: &Cell) -> bool {
        if self.cells.is_full() {
            return false;
        }
        let form = Form::of(cell);
        if matches!(form, Form::Whole) {
            if self.wholes.push(*cell).is_err() {
                return false;
            }
            self.count += 1;
        }
        let slip = Slip { s: node.s, len: node.len, rests: node.rests, form, wholes: self.count };
        self.cells.push(slip).is_ok()
    }

    /// Adds marks; whether there was room.
    pub fn marks(&mut self, marks: &[Mark]) -> bool {
        self.marks.push_entire_slice(marks).is_ok()
    }

    /// Adds the stretches of a course, then the course itself. It does not hold before [`settle`](Self::settle).
    pub fn course(&mut self, period: u64, course: Course, stretches: &[Stretch]) -> bool {
        let course = Course { place: self.places, count: stretches.len() as u64, ..course };
        if self.stretches.push_entire_slice(stretches).is_err() {
            return false;
        }
        self.places += stretches.len() as u64;
        self.change(period, Change::Course(course))
    }

    /// Adds a move of every axis on its own, as it is at the start of the period.
    pub fn axes(&mut self, period: u64, run: &AxesRun) -> bool {
        self.runs.push(*run).is_ok() && self.change(period, Change::Axes)
    }

    fn change(&mut self, period: u64, change: Change) -> bool {
        let is_in = self.changes.push(Dated { period, change }).is_ok();
        self.open = self.open.wrapping_add(u16::from(is_in));
        is_in
    }

    /// What was added holds from `period` on, unless that has begun.
    pub fn settle(&mut self, period: u64) -> bool {
        let holds = self.gate.add(self.open, period);
        if holds {
            self.open = 0;
        }
        holds
    }
}

/// From a stretch on, where in the ring they lie.
#[derive(Clone, Copy, Debug)]
struct Run {
    from: u64,
    place: u64,
}

/// The interpolator's side.
#[derive(Debug)]
pub(crate) struct Receiver {
    gate: Arc<Gate>,
    stretches: Reader<Stretch>,
    cells: Reader<Slip>,
    wholes: Reader<Cell>,
    marks: Reader<Mark>,
    runs: Consumer<AxesRun>,
    changes: Consumer<Dated>,
    /// Changes that hold, as far as they were counted, and how many of them are still to come.
    counted: u16,
    due: u16,
    courses: VecDeque<Run>,
    /// The stretch being run, and the one behind the last.
    current: u64,
    end: u64,
    cell: u64,
    mark: u64,
}

/// What a period begins with.
#[derive(Debug, Default)]
pub(crate) struct News {
    /// The path begins anew.
    pub begins: bool,
    /// A move of every axis on its own.
    pub axes: Option<AxesRun>,
}

impl Receiver {
    /// A period begins: what changes with it.
    pub fn begin(&mut self) -> (u64, News) {
        let (period, count) = self.gate.begin();
        self.due = self.due.wrapping_add(count.wrapping_sub(self.counted));
        self.counted = count;
        let mut news = News::default();
        while self.due > 0 {
            let Some(dated) = self.changes.peek().ok().copied().filter(|dated| dated.period <= period) else {
                break;
            };
            let _ = self.changes.pop();
            self.due -= 1;
            // One that came too late stands before those that came in time.
            let holds = dated.period == period;
            match dated.change {
                Change::Axes => {
                    if let Some(run) = self.runs.pop().ok().filter(|_| holds) {
                        news.axes = Some(run);
                    }
                }
                Change::Course(course) if holds => {
                    self.take(course);
                    if course.begins {
                        news = News { begins: true, axes: None };
                    }
                }
                Change::Course(_) => {}
            }
        }
        (period, news)
    }

    fn take(&mut self, course: Course) {
        while self.courses.back().is_some_and(|run| run.from >= course.from) {
            self.courses.pop_back();
        }
        // There is always room, see COURSES; without it what runs would go on to its end.
        if self.courses.len() < COURSES {
            self.courses.push_back(Run { from: course.from, place: course.place });
            self.end = course.from + course.count;
            self.cell = self.cell.max(course.cell);
            self.mark = self.mark.max(course.mark);
        }
        self.leave_courses();
    }

    /// Leaves the courses behind whose last stretch it is.
    fn leave_courses(&mut self) {
        while self.courses.get(1).is_some_and(|next| next.from <= self.current) {
            self.courses.pop_front();
        }
    }

    /// The period is over: what was passed is given back.
    pub fn end(&mut self, period: u64) {
        if let Some(run) = self.courses.front() {
            let place = run.place + self.current.saturating_sub(run.from);
            self.stretches.release(place);
        }
        if let Some(passed) = self.cells.release(self.cell) {
            self.wholes.release(passed.wholes);
        }
        self.marks.release(self.mark);
        self.gate.end(period);
    }

    /// The block at `s`.
    pub fn tag_at(&mut self, s: f64) -> Option<u64> {
        self.mark = self.marks.pass(self.mark, |mark| mark.is_before(s));
        self.marks.with(self.mark, |mark| mark.tag)
    }

    /// The stretch being run.
    pub fn stretch(&mut self) -> Option<Stretch> {
        if self.current >= self.end {
            return None;
        }
        let run = self.courses.front()?;
        self.stretches.with(run.place + self.current.checked_sub(run.from)?, |stretch| *stretch)
    }

    /// Goes on to the next stretch.
    pub fn go_on(&mut self) {
        self.current += 1;
        self.leave_courses();
    }

    /// The cell in which `s` lies.
    pub fn pass(&mut self, s: f64) -> u64 {
        self.cell = self.cells.pass(self.cell, |slip| slip.s + slip.len < s && !slip.rests);
        self.cell
    }

    pub fn pass_to(&mut self, cell: u64) {
        self.cell = self.cell.max(cell);
    }

    /// Looks at a cell.
    pub fn cell<R>(&mut self, number: u64, look: impl FnOnce(&Strip) -> R) -> Option<R> {
        let wholes = &mut self.wholes;
        let look = |slip: &Slip| match slip.form.cell() {
            Some(cell) => Some(look(&Strip { s: slip.s, len: slip.len, cell: &cell })),
            None => wholes
                .with(slip.wholes.checked_sub(1)?, |cell| look(&Strip { s: slip.s, len: slip.len, cell })),
        };
        self.cells.with(number, look).flatten()
    }
}

/// The reading end of a ring, whose places are looked at by number.
#[derive(Debug)]
struct Reader<T> {
    ring: Consumer<T>,
    /// Number of the oldest place.
    first: u64,
}

impl<T: Copy> Reader<T> {
    /// Looks at place `number`.
    #[inline]
    fn with<R>(&mut self, number: u64, look: impl FnOnce(&T) -> R) -> Option<R> {
        let index = usize::try_from(number.checked_sub(self.first)?).ok()?;
        let chunk = self.ring.read_chunk(index + 1).ok()?;
        let (front, back) = chunk.as_slices();
        front.get(index).or_else(|| back.get(index - front.len())).map(look)
    }

    /// The first place from `number` on that is not passed; the newest is not.
    #[inline]
    fn pass(&mut self, number: u64, is_passed: impl Fn(&T) -> bool) -> u64 {
        let known = self.ring.slots();
        let Some(skip) = number.checked_sub(self.first).and_then(|skip| usize::try_from(skip).ok()) else {
            return number;
        };
        let Ok(chunk) = self.ring.read_chunk(known) else { return number };
        let (front, back) = chunk.as_slices();
        let from = front.get(skip.min(front.len())..).unwrap_or(&[]);
        let then = back.get(skip.saturating_sub(front.len()).min(back.len())..).unwrap_or(&[]);
        let left = (from.len() + then.len()).saturating_sub(1);
        number + from.iter().chain(then).take(left).take_while(|place| is_passed(place)).count() as u64
    }

    /// Gives back the places before `number`: what was in the last of them.
    fn release(&mut self, number: u64) -> Option<T> {
        let count = usize::try_from(number.saturating_sub(self.first)).unwrap_or(0).min(self.ring.slots());
        let chunk = self.ring.read_chunk(count).ok()?;
        let (front, back) = chunk.as_slices();
        let last = back.last().or(front.last()).copied();
        chunk.commit_all();
        self.first += count as u64;
        last
    }
}

/// Both sides; all memory is taken here.
pub(crate) fn pair() -> (Sender, Receiver) {
    let gate = Arc::new(Gate::default());
    let (stretches, stretches_out) = RingBuffer::new(STRETCH_PLACES);
    let (cells, cells_out) = RingBuffer::new(CELL_PLACES);
    let (wholes, wholes_out) = RingBuffer::new(CELL_PLACES);
    let (marks, marks_out) = RingBuffer::new(MARK_PLACES);
    let (runs, runs_out) = RingBuffer::new(RUN_PLACES);
    let (changes, changes_out) = RingBuffer::new(CHANGE_PLACES);
    let sender = Sender {
        gate: Arc::clone(&gate),
        stretches,
        places: 0,
        cells,
        wholes,
        count: 0,
        marks,
        runs,
        changes,
        open: 0,
    };
    let receiver = Receiver {
        gate,
        stretches: Reader { ring: stretches_out, first: 0 },
        cells: Reader { ring: cells_out, first: 0 },
        wholes: Reader { ring: wholes_out, first: 0 },
        marks: Reader { ring: marks_out, first: 0 },
        runs: runs_out,
        changes: changes_out,
        counted: 0,
        due: 0,
        courses: VecDeque::with_capacity(COURSES),
        current: 0,
        end: 0,
        cell: 0,
        mark: 0,
    };
    (sender, receiver)
}

impl Course {
    /// From a stretch on; where it lies is filled in as it is sent.
    pub fn new(from: u64, cell: u64, mark: u64, begins: bool) -> Course {
        Course { from, count: 0, place: 0, cell, mark, begins }
    }
}
