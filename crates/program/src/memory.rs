//! Program memory: the main file, the programs inside it, and the files beside it.
//!
//! Files are lexed page by page when they are read. The pages lexed last are kept within a budget of
//! memory, so that a loop or a subprogram is rarely lexed twice, and a flat program of any size
//! streams.

use crate::lexer::{self, Start};
use crate::names::Names;
use crate::page::{Page, Value};
use crate::sent::Refused;
use crate::span::{FileId, Span};
use crate::syntax::Syntax;
use crate::text::{OpenError, Text, given_back};
use std::collections::{HashMap, VecDeque};
use std::io;
use std::ops::Range;
use std::path::{Path, PathBuf};
use std::sync::{Arc, LazyLock, Mutex};

/// Bytes of text lexed at a time. A line with its end fits ([`lexer::MAX_LINE`]).
const PAGE_BYTES: usize = 1 << 16;

/// Lexed pages kept, bytes.
const PAGE_BUDGET: usize = 24 << 20;

/// Programs noted in one file or one folder: far beyond any shop's.
const MAX_PROGRAMS: usize = 100_000;

/// Bytes of a program's name.
const LONGEST_NAME: u32 = 255;

/// Part programs looked at in the folder.
const MAX_FOLDER: usize = 10_000;

/// Bytes of a file beyond which no program that stands for a code is looked for in it, and of all such
/// files of a folder together: those are short, and a folder may hold all that a shop ever cut.
const SMALL_FILE: u64 = 1 << 20;
const SMALL_FILES: u64 = 64 << 20;

/// Bytes of a file's end in which its last line is looked for.
const LONGEST_TAIL: u64 = 4096;

/// Extensions of part programs (lower case), for the files beside the main one.
pub const EXTENSIONS: &[&str] =
    &["nc", "cnc", "ncc", "ngc", "tap", "mpf", "spf", "eng", "mmg", "gcode", "txt", "sub"];

/// What a program is called by.
#[derive(Clone, PartialEq, Eq, Hash, Debug, PartialOrd, Ord)]
pub enum ProgramId {
    /// `O1002`
    Number(u32),
    /// The name of a file without extension. Capitals do not matter.
    Name(Box<str>),
}

impl ProgramId {
    /// The program called by a text; one of digits alone is a number.
    pub fn named(text: &str) -> ProgramId {
        let text = text.trim();
        let is_number = !text.is_empty() && text.bytes().all(|b| b.is_ascii_digit());
        match text.parse() {
            Ok(number) if is_number => ProgramId::Number(number),
            _ => ProgramId::Name(text.to_lowercase().into()),
        }
    }
}

/// Programs that can be called and are neither files added nor files of the folder: those of a control's memory.
pub trait Source: std::fmt::Debug + Send {
    /// The name and text of a program.
    fn find(&mut self, id: &ProgramId) -> Option<(String, Text)>;
}

/// A block of a file of program memory.
#[derive(Clone, Copy, PartialEq, Eq, Hash, Debug, Default, PartialOrd, Ord)]
pub struct Place {
    /// The file.
    pub file: FileId,
    /// Its page.
    pub page: u32,
    /// The block in the page; may be one past the last.
    pub block: u32,
}

/// Where a page of a file starts, and the page while it is kept.
#[derive(Clone, Debug)]
struct PageSlot {
    start: Start,
    page: Option<Arc<Page>>,
}

#[derive(Clone, Debug)]
struct ProgramFile {
    name: Box<str>,
    text: Arc<Text>,
    /// The pages from `first` on that were read.
    slots: VecDeque<PageSlot>,
    /// Number of the first page that is not given back.
    first: u32,
    /// Where the page after the last slot starts; `None` once the end is known.
    next: Option<Start>,
    /// Number of its last line, once the end is known.
    last_line: Option<u32>,
    /// Programs found in the file, once they were asked for.
    programs: Option<Arc<HashMap<ProgramId, Place>>>,
    /// Where in the folder it was found; `None` for the main file and those that were added.
    found_at: Option<PathBuf>,
    /// Holds no program, whatever its name and text.
    is_shown_only: bool,
}

impl ProgramFile {
    /// A file of which nothing was read.
    fn new(id: FileId, name: &str, text: Arc<Text>) -> ProgramFile {
        let next = Some(Start { file: id, offset: text.encoding().mark as u64, line: 1, is_head: true });
        ProgramFile {
            name: name.into(),
            text,
            slots: VecDeque::new(),
            first: 0,
            next,
            last_line: None,
            programs: None,
            found_at: None,
            is_shown_only: false,
        }
    }

    /// The text, to be changed; none while a copy of the memory has it too.
    fn text_mut(&mut self) -> Option<&mut Text> {
        Arc::get_mut(&mut self.text)
    }
}

/// The programs that can be run and called.
#[derive(Clone, Debug)]
pub struct ProgramMemory {
    syntax: &'static Syntax,
    names: Names,
    files: Vec<ProgramFile>,
    /// Pages in the order they were lexed, for giving up the oldest.
    kept: VecDeque<(FileId, u32, usize)>,
    kept_bytes: usize,
    /// Bytes of pages beyond which the oldest is given up.
    budget: usize,
    buffer: Vec<u8>,
    /// Folder whose files can be called, and the main file's path within it.
    folder: Option<(PathBuf, PathBuf)>,
    /// Programs found in the folder, once something was asked that the files do not hold.
    folder_index: Option<HashMap<ProgramId, PathBuf>>,
    /// Where else programs are found.
    source: Option<Arc<Mutex<Box<dyn Source>>>>,
    /// Programs with the number or name of one before them in their file, which nothing calls, and how many they are.
    repeated: HashMap<(FileId, ProgramId), Vec<Place>>,
    repeated_count: usize,
}

impl ProgramMemory {
    /// Memory with one file, the main program's.
    pub fn new(name: &str, text: Text, syntax: &'static Syntax) -> ProgramMemory {
        let mut memory = ProgramMemory {
            syntax,
            names: Names::default(),
            files: Vec::new(),
            kept: VecDeque::new(),
            kept_bytes: 0,
            budget: PAGE_BUDGET,
            buffer: Vec::new(),
            folder: None,
            folder_index: None,
            source: None,
            repeated: HashMap::new(),
            repeated_count: 0,
        };
        memory.add(name, text);
        memory
    }

    /// Memory with the file at `path` as main program; the part programs beside it can be called.
    pub fn open(path: &Path, syntax: &'static Syntax) -> Result<ProgramMemory, OpenError> {
        Ok(ProgramMemory::at(path, Text::open(path)?, syntax))
    }

    /// The same where the file's text was read already.
    pub fn at(path: &Path, text: Text, syntax: &'static Syntax) -> ProgramMemory {
        let mut memory = ProgramMemory::new(&path.to_string_lossy(), text, syntax);
        let folder = path.parent().filter(|p| !p.as_os_str().is_empty()).unwrap_or(Path::new("."));
        memory.folder = Some((folder.to_path_buf(), path.to_path_buf()));
        memory
    }

    /// The same files with another main program. What was read of the others is shared and not read again.
    pub fn with_main(&self, name: &str, text: Text) -> ProgramMemory {
        let mut memory = self.clone();
        memory.kept.retain(|(id, ..)| id.0 != 0);
        memory.kept_bytes = memory.kept.iter().map(|(.., bytes)| bytes).sum();
        if let Some(main) = memory.files.first_mut() {
            *main = ProgramFile::new(FileId(0), name, Arc::new(text));
        }
        memory
    }

    /// Looks for the programs in all files that are there, which reads those that hold any.
    pub fn look_for_programs(&mut self) -> io::Result<()> {
        (0..self.files.len())
            .map_while(|at| u16::try_from(at).ok())
            .try_for_each(|at| self.programs_in(FileId(at)).map(drop))
    }

    /// Adds a file that can be called, as can the programs in it. After 65 535 files no more are
    /// taken: the id returned then is of an empty file.
    pub fn add(&mut self, name: &str, text: Text) -> FileId {
        self.add_shared(name, Arc::new(text))
    }

    /// The same with a text that other memories have too.
    pub fn add_shared(&mut self, name: &str, text: Arc<Text>) -> FileId {
        let Some(file) = u16::try_from(self.files.len()).ok().filter(|n| *n < u16::MAX).map(FileId) else {
            return FileId(u16::MAX);
        };
        self.files.push(ProgramFile::new(file, name, text));
        file
    }

    /// Adds a file that is only shown, such as the drawing that the main program was made from. Nothing
    /// in it can be called.
    pub fn add_shown(&mut self, name: &str, text: Text) -> FileId {
        let id = self.add(name, text);
        if let Some(file) = self.files.get_mut(usize::from(id.0)) {
            file.is_shown_only = true;
            file.programs = Some(Arc::default());
        }
        id
    }

    /// Has programs that are nowhere else taken from `source`, when they are called first.
    pub fn set_source(&mut self, source: Box<dyn Source>) {
        self.source = Some(Arc::new(Mutex::new(source)));
    }

    /// Names that the programs read so far give to variables and subprograms.
    pub fn names(&self) -> &Names {
        &self.names
    }

    /// The file with this name among those added, else in the main file's folder, opened if it was not yet.
    pub fn file_named(&mut self, name: &str) -> Option<FileId> {
        let is_named = |path: &Path| path.file_name().is_some_and(|own| own == name);
        let added = |f: &ProgramFile| f.found_at.is_none() && !f.is_shown_only;
        if let Some(file) = self.position(1, |f| added(f) && is_named(Path::new(&*f.name))) {
            return Some(file);
        }
        let (folder, _) = self.folder.as_ref()?;
        let path = folder.join(name);
        if path.parent() != Some(folder) {
            return None;
        }
        if let Some(known) = self.position(1, |f| f.found_at.as_ref() == Some(&path)) {
            return Some(known);
        }
        let text = Text::open(&path).ok()?;
        let file = self.add(name, text);
        self.files.get_mut(usize::from(file.0))?.found_at = Some(path);
        Some(file)
    }

    /// The last line of a file that was read to its end.
    pub fn last_line(&self, id: FileId) -> Option<Span> {
        let file = self.files.get(usize::from(id.0))?;
        let line = file.last_line?;
        let len = file.text.len();
        let from = len.saturating_sub(LONGEST_TAIL);
        let tail = file.text.slice(Span { file: id, offset: from, len: (len - from) as u32, line }).ok()?;
        let text = tail.strip_suffix(b"\n").unwrap_or(&tail);
        let text = text.strip_suffix(b"\r").unwrap_or(text);
        let start = text.iter().rposition(|b| matches!(b, b'\n' | b'\r')).map_or(0, |at| at + 1);
        let len = (text.len() - start) as u32;
        Some(Span { file: id, offset: from + start as u64, len, line })
    }

    /// How the programs are written.
    pub fn syntax(&self) -> &'static Syntax {
        self.syntax
    }

    /// Name of a file as it was given.
    pub fn file_name(&self, file: FileId) -> &str {
        self.files.get(usize::from(file.0)).map_or("", |f| &f.name)
    }

    /// Bytes of a file.
    pub fn text(&self, file: FileId) -> Option<&Text> {
        self.files.get(usize::from(file.0)).map(|f| &*f.text)
    }

    /// The text of a span, decoded.
    pub fn slice(&self, span: Span) -> String {
        let Some(text) = self.text(span.file) else { return String::new() };
        text.slice(span).map(|bytes| text.encoding().decode(&bytes).into_owned()).unwrap_or_default()
    }

    /// More of a main program that is sent bit by bit. Refused as a whole where there is no room.
    pub fn append(&mut self, bytes: &[u8]) -> Result<(), Refused> {
        self.files
            .first_mut()
            .and_then(ProgramFile::text_mut)
            .map_or(Err(Refused::Ended), |text| text.append(bytes))
    }

    /// Nothing more of the main program comes.
    pub fn end_text(&mut self) {
        if let Some(text) = self.files.first_mut().and_then(ProgramFile::text_mut) {
            text.end();
        }
    }

    /// Lines of a main program that is sent are not needed any more before `offset`.
    pub fn give_back(&mut self, offset: u64) {
        let Some(file) = self.files.first_mut().filter(|file| file.text.is_sent()) else { return };
        // What was not read yet stays.
        let offset = file.next.map_or(offset, |next| next.offset.min(offset));
        let ends = |file: &ProgramFile| match file.slots.get(1) {
            Some(second) => Some(second.start.offset),
            None => file.next.map(|next| next.offset),
        };
        while !file.slots.is_empty() && ends(file).is_some_and(|end| end <= offset) {
            file.slots.pop_front();
            file.first = file.first.saturating_add(1);
        }
        if let Some(text) = file.text_mut() {
            text.give_back(offset);
        }
        let first = file.first;
        while let Some((_, _, bytes)) = self.kept.pop_front_if(|(id, number, _)| id.0 == 0 && *number < first)
        {
            self.kept_bytes -= bytes;
        }
    }

    /// How many lines of the main program were read.
    pub fn lines_read(&self) -> u32 {
        let next = self.files.first().and_then(|file| file.next);
        next.map_or(0, |next| next.line.saturating_sub(1))
    }

    /// Forgets what of a main program that is sent was not read; where the next line will stand.
    pub fn forget_unread(&mut self) -> Option<Place> {
        let file = self.files.first_mut().filter(|file| file.text.is_sent())?;
        let next = file.next?;
        let lines = file.text_mut()?.forget(next.offset);
        let line = next.line.saturating_add(lines);
        file.next = Some(Start { offset: file.text.len(), line, is_head: true, ..next });
        file.first = file.first.saturating_add(u32::try_from(file.slots.len()).unwrap_or(u32::MAX));
        file.slots.clear();
        Some(Place { file: FileId(0), page: file.first, block: 0 })
    }

    /// The page with this number, counted from 0; `None` past the end of the file. Pages before it that
    /// were not read yet are read first, to find where it starts.
    ///
    /// Of a text that is sent bit by bit, a page that did not come yet is [`io::ErrorKind::WouldBlock`], and one
    /// that was given back [`io::ErrorKind::NotSeekable`].
    pub fn page(&mut self, id: FileId, number: u32) -> io::Result<Option<Arc<Page>>> {
        loop {
            let Some(file) = self.files.get_mut(usize::from(id.0)) else { return Ok(None) };
            let Some(index) = number.checked_sub(file.first) else { return Err(given_back()) };
            if let Some(slot) = file.slots.get(index as usize) {
                if let Some(page) = &slot.page {
                    return Ok(Some(page.clone()));
                }
                let start = slot.start;
                return self.lex(number, start).map(Some);
            }
            let Some(start) = file.next else { return Ok(None) };
            if start.offset >= file.text.readable() {
                if file.text.is_open() {
                    return Err(io::Error::from(io::ErrorKind::WouldBlock));
                }
                file.next = None;
                return Ok(None);
            }
            let Some(next) = file.first.checked_add(file.slots.len() as u32) else {
                return Err(given_back());
            };
            self.lex(next, start)?;
        }
    }

    /// The first block of a file that stands on this line, counted from 1, or behind it; `None` past the end.
    pub fn block_from_line(&mut self, file: FileId, line: u32) -> io::Result<Option<Place>> {
        for number in 0.. {
            let Some(page) = self.page(file, number)? else { break };
            let found = page.blocks.iter().position(|block| page.block_span(block).line >= line);
            if let Some(block) = found.and_then(|at| u32::try_from(at).ok()) {
                return Ok(Some(Place { file, page: number, block }));
            }
        }
        Ok(None)
    }

    /// Lexes the page with this number, which is known or the next of its file, and keeps it.
    fn lex(&mut self, number: u32, start: Start) -> io::Result<Arc<Page>> {
        let (syntax, names) = (self.syntax, &mut self.names);
        let Some(file) = self.files.get_mut(usize::from(start.file.0)) else { return Ok(Arc::default()) };
        let (len, is_open) = (file.text.readable(), file.text.is_open());
        let most = usize::try_from(len.saturating_sub(start.offset)).unwrap_or(PAGE_BYTES).min(PAGE_BYTES);
        let (lexed, is_last, ends_line) =
            file.text.window(start.offset, most, &mut self.buffer, |bytes| {
                // Fewer bytes than asked for: the file became shorter while it is read, and ends here.
                let is_last = start.offset + PAGE_BYTES as u64 >= len || bytes.len() < PAGE_BYTES;
                let is_last = is_last && !is_open;
                let ends_line = matches!(bytes.last(), Some(b'\n' | b'\r'));
                (lexer::lex_from(bytes, start, is_last, syntax, names), is_last, ends_line)
            })?;
        if is_last {
            file.last_line = Some(lexed.next_line.saturating_sub(u32::from(ends_line)).max(1));
        }
        let page = Arc::new(lexed.page);
        if let Some(slot) = slot_mut(file, number) {
            slot.page = Some(page.clone());
        } else {
            let mut end = (start.offset + lexed.consumed as u64, lexed.next_line);
            if lexed.is_cut {
                end = skip_line_tail(&file.text, end, &mut self.buffer)?;
            }
            let is_head = start.is_head && page.blocks.is_empty();
            file.next = (!is_last).then_some(Start { offset: end.0, line: end.1, is_head, ..start });
            file.slots.push_back(PageSlot { start, page: Some(page.clone()) });
        }
        self.keep(start.file, number, bytes_of(&page));
        Ok(page)
    }

    /// Counts a page that was lexed, and gives up the oldest ones beyond the budget.
    fn keep(&mut self, id: FileId, number: u32, bytes: usize) {
        self.kept.push_back((id, number, bytes));
        self.kept_bytes += bytes;
        while self.kept_bytes > self.budget && self.kept.len() > 1 {
            let Some((id, number, bytes)) = self.kept.pop_front() else { return };
            self.kept_bytes -= bytes;
            let file = self.files.get_mut(usize::from(id.0));
            if let Some(slot) = file.and_then(|f| slot_mut(f, number)) {
                slot.page = None;
            }
        }
    }

    /// The block at which a called program starts: the one with its `O` word, or the first of a file of
    /// its name. Looked for in the main file, then in the files added, then among the part programs of
    /// the main file's folder; there, and among the files added, the name of a file comes first.
    pub fn find_program(&mut self, id: &ProgramId) -> io::Result<Option<Place>> {
        let id = &match id {
            ProgramId::Name(name) => ProgramId::Name(name.to_lowercase().into()),
            ProgramId::Number(number) => ProgramId::Number(*number),
        };
        if let Some(place) = self.find_in_file(FileId(0), id)? {
            return Ok(Some(place));
        }
        let added = |f: &ProgramFile| f.found_at.is_none() && !f.is_shown_only;
        if let Some(file) = self.position(1, |f| added(f) && names_of(Path::new(&*f.name)).contains(id)) {
            return self.start_in_file(file, id).map(Some);
        }
        let mut from = 1;
        while let Some(file) = self.position(from, added) {
            if let Some(place) = self.find_in_file(file, id)? {
                return Ok(Some(place));
            }
            from = usize::from(file.0) + 1;
        }
        match self.find_in_folder(id) {
            Some(file) => self.start_in_file(file, id).map(Some),
            None => match self.source.as_ref().and_then(|source| source.lock().ok()?.find(id)) {
                Some((name, text)) => {
                    let file = self.add(&name, text);
                    self.start_in_file(file, id).map(Some)
                }
                None => Ok(None),
            },
        }
    }

    /// Further programs with the number or name of one of a file; given out once.
    pub fn take_repeated(&mut self, file: FileId, id: &ProgramId) -> Vec<Place> {
        if self.repeated.is_empty() {
            return Vec::new();
        }
        self.repeated.remove(&(file, id.clone())).unwrap_or_default()
    }

    /// Numbers within a range that programs have: in the main file, in the files added, and among the small
    /// part programs of the main file's folder.
    pub fn numbers_within(&mut self, range: Range<u32>) -> io::Result<Vec<u32>> {
        let mut found = Vec::new();
        let mut take = |programs: &HashMap<ProgramId, Place>| {
            let numbers = programs.keys().filter_map(|id| match id {
                ProgramId::Number(number) if range.contains(number) => Some(*number),
                _ => None,
            });
            found.extend(numbers);
        };
        for at in 0..self.files.len() {
            let Ok(at) = u16::try_from(at) else { break };
            take(self.programs_in(FileId(at))?);
        }
        if let Some((folder, main)) = &self.folder {
            let mut left = SMALL_FILES;
            for path in part_programs(folder, main) {
                let len = std::fs::metadata(&path).map_or(u64::MAX, |about| about.len());
                if len > SMALL_FILE || len > left {
                    continue;
                }
                left -= len;
                let Ok(text) = Text::open(&path) else { continue };
                let mut alone = ProgramMemory::new("", text, self.syntax);
                take(alone.programs_in(FileId(0))?);
                // What a file is called by counts as what it holds.
                take(&names_of(&path).into_iter().map(|id| (id, Place::default())).collect());
            }
        }
        found.sort_unstable();
        found.dedup();
        Ok(found)
    }

    /// The first file from index `from` on that `is_it`.
    fn position(&self, from: usize, is_it: impl Fn(&ProgramFile) -> bool) -> Option<FileId> {
        let at = from + self.files.get(from..)?.iter().position(is_it)?;
        u16::try_from(at).ok().map(FileId)
    }

    /// The file of the folder that holds a program, opened if it was not yet.
    fn find_in_folder(&mut self, id: &ProgramId) -> Option<FileId> {
        let (folder, main) = self.folder.as_ref()?;
        let syntax = self.syntax;
        let index = self.folder_index.get_or_insert_with(|| index_folder(folder, main, syntax));
        let path = index.get(id)?.clone();
        if let Some(known) = self.position(1, |f| f.found_at.as_ref() == Some(&path)) {
            return Some(known);
        }
        // A file that cannot be opened any more is a program that is not there.
        let text = Text::open(&path).ok()?;
        // As it would be typed, beside the main program.
        let name = path.strip_prefix(".").unwrap_or(&path);
        let file = self.add(&name.to_string_lossy(), text);
        self.files.get_mut(usize::from(file.0))?.found_at = Some(path);
        Some(file)
    }

    /// Where a program starts in a file that is known to hold it, or to be it.
    fn start_in_file(&mut self, file: FileId, id: &ProgramId) -> io::Result<Place> {
        Ok(self.find_in_file(file, id)?.unwrap_or(Place { file, page: 0, block: 0 }))
    }

    fn find_in_file(&mut self, id: FileId, program: &ProgramId) -> io::Result<Option<Place>> {
        Ok(self.programs_in(id)?.get(program).copied())
    }

    /// The programs of a file, looked for once.
    fn programs_in(&mut self, id: FileId) -> io::Result<&HashMap<ProgramId, Place>> {
        static NONE: LazyLock<HashMap<ProgramId, Place>> = LazyLock::new(HashMap::new);
        let known = self.files.get(usize::from(id.0)).is_none_or(|f| f.programs.is_some());
        if !known {
            let programs = self.index_file(id)?;
            if let Some(file) = self.files.get_mut(usize::from(id.0)) {
                file.programs = Some(Arc::new(programs));
            }
        }
        let programs = self.files.get(usize::from(id.0)).and_then(|f| f.programs.as_deref());
        Ok(programs.unwrap_or_else(|| LazyLock::force(&NONE)))
    }

    /// Finds the blocks that start with an O word; of two with one number the first counts.
    fn index_file(&mut self, id: FileId) -> io::Result<HashMap<ProgramId, Place>> {
        let mut programs = HashMap::new();
        let mut number = 0;
        // What is being sent is not all there to be called.
        if self.text(id).is_some_and(Text::is_sent) {
            return Ok(programs);
        }
        if let Some(file) = self.files.get(usize::from(id.0))
            && !may_hold_programs(&file.text, &mut self.buffer)?
        {
            return Ok(programs);
        }
        while let Some(page) = self.page(id, number)? {
            for (at, program) in programs_of(&page) {
                let program = match program {
                    Heading::Number(number) => ProgramId::Number(number),
                    Heading::Name(span) => ProgramId::named(&self.slice(span)),
                };
                let place = Place { file: id, page: number, block: at };
                if programs.contains_key(&program) {
                    if self.repeated_count < MAX_PROGRAMS {
                        self.repeated_count += 1;
                        self.repeated.entry((id, program)).or_default().push(place);
                    }
                } else if programs.len() < MAX_PROGRAMS {
                    programs.insert(program, place);
                }
            }
            number += 1;
        }
        Ok(programs)
    }
}

/// The place of a page that is not given back.
fn slot_mut(file: &mut ProgramFile, number: u32) -> Option<&mut PageSlot> {
    file.slots.get_mut(number.checked_sub(file.first)? as usize)
}

/// Finds the programs in the part programs of a folder: by the names of the files, and by the O words
/// in them. Of two with one number or name the first file counts, in the order of their names.
fn index_folder(folder: &Path, main: &Path, syntax: &'static Syntax) -> HashMap<ProgramId, PathBuf> {
    let mut index = HashMap::new();
    let paths = part_programs(folder, main);
    for path in &paths {
        for id in names_of(path) {
            index.entry(id).or_insert_with(|| path.clone());
        }
    }
    for path in &paths {
        let Ok(text) = Text::open(path) else { continue };
        let mut alone = ProgramMemory::new("", text, syntax);
        alone.budget = 0;
        for id in alone.index_file(FileId(0)).unwrap_or_default().into_keys() {
            if index.len() < MAX_PROGRAMS {
                index.entry(id).or_insert_with(|| path.clone());
            }
        }
    }
    index
}

/// The part programs of a folder but the main one, in the order of their names.
fn part_programs(folder: &Path, main: &Path) -> Vec<PathBuf> {
    let Ok(entries) = std::fs::read_dir(folder) else { return Vec::new() };
    let mut paths: Vec<PathBuf> = entries
        .filter_map(|e| e.ok().map(|e| e.path()))
        .filter(|p| p.file_name() != main.file_name() && is_part_program(p))
        .take(MAX_FOLDER)
        .collect();
    paths.sort();
    paths
}

/// Whether any block of a text may start with an O word. Looks at bytes alone, so that a large flat program
/// is not lexed for nothing; a comment may look like one.
fn may_hold_programs(text: &Text, buffer: &mut Vec<u8>) -> io::Result<bool> {
    // Nothing of the block but blanks, skips, comments and its number was read.
    let (mut at_start, mut in_comment) = (true, false);
    let mut offset = 0;
    loop {
        let (found, len) = text.window(offset, PAGE_BYTES, buffer, |bytes| {
            for byte in bytes {
                match byte {
                    b'\n' | b'\r' => (at_start, in_comment) = (true, false),
                    b')' if in_comment => in_comment = false,
                    _ if in_comment => {}
                    b'(' => in_comment = true,
                    b'O' | b'o' if at_start => return (true, bytes.len()),
                    b';' => at_start = true,
                    // Padding too, and what a byte order mark is made of.
                    b'N' | b'n' | b'/' | b' ' | b'0'..=b'9' | b'.' | 0..=0x1F | 0x80.. => {}
                    _ => at_start = false,
                }
            }
            (false, bytes.len())
        })?;
        if found || len == 0 {
            return Ok(found);
        }
        offset += len as u64;
    }
}

/// What a file can be called by: `drill` for `drill.nc`, and for `O1002.nc` or `1002.nc` the number
/// too.
fn names_of(path: &Path) -> Vec<ProgramId> {
    let stem = path.file_stem().map(|s| s.to_string_lossy().to_lowercase()).unwrap_or_default();
    let digits = stem.strip_prefix('o').unwrap_or(&stem);
    let number = digits.parse().ok().filter(|_| digits.bytes().all(|b| b.is_ascii_digit()));
    let name = ProgramId::Name(stem.into());
    [Some(name), number.map(ProgramId::Number)].into_iter().flatten().collect()
}

fn is_part_program(path: &Path) -> bool {
    let extension = path.extension().map(|e| e.to_string_lossy().to_lowercase()).unwrap_or_default();
    EXTENSIONS.contains(&extension.as_str()) && path.is_file()
}

/// What a block that starts a program calls it.
enum Heading {
    Number(u32),
    Name(Span),
}

/// Blocks of a page that start with an O word, and the programs that they start.
fn programs_of(page: &Page) -> impl Iterator<Item = (u32, Heading)> {
    page.blocks.iter().enumerate().filter_map(|(at, block)| {
        let first = page.words(block).first().filter(|word| word.letter == b'O')?;
        let heading = match first.value() {
            Value::Number(n) if n.fract() == 0.0 && (0.0..=f64::from(u32::MAX)).contains(&n) => {
                Heading::Number(n as u32)
            }
            Value::Text(text) if text.len <= LONGEST_NAME => {
                Heading::Name(page.span(block, text.at, text.len))
            }
            _ => return None,
        };
        Some((at as u32, heading))
    })
}

/// Memory that a page takes.
fn bytes_of(page: &Page) -> usize {
    fn array<T>(v: &Vec<T>) -> usize {
        v.capacity() * size_of::<T>()
    }
    size_of::<Page>()
        + array(&page.blocks)
        + array(&page.words)
        + array(&page.nodes)
        + array(&page.statements)
        + array(&page.guards)
        + array(&page.o_words)
        + array(&page.values)
        + array(&page.defects)
}

/// Where the line ends that stands at `offset`, with its number, and the next one starts.
fn skip_line_tail(
    text: &Text,
    (mut offset, line): (u64, u32),
    buffer: &mut Vec<u8>,
) -> io::Result<(u64, u32)> {
    loop {
        let (end, len) = text.window(offset, PAGE_BYTES, buffer, |bytes| {
            (bytes.iter().position(|b| matches!(b, b'\n' | b'\r')), bytes.len())
        })?;
        match end {
            Some(at) => {
                let end = offset + at as u64;
                let is_crlf = text.window(end, 2, buffer, |bytes| bytes == b"\r\n")?;
                return Ok((end + 1 + u64::from(is_crlf), line.saturating_add(1)));
            }
            None if len == 0 => return Ok((offset, line)),
            None => offset += len as u64,
        }
    }
}
