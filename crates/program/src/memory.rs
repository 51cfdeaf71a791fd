//! Program memory: the main file, the programs inside it, and the files beside it.
//!
//! Files are lexed page by page when they are read. The pages last used are kept within a budget of
//! memory, so that a loop or a subprogram is lexed once, and a flat program of any size streams.

use crate::lexer;
use crate::page::Page;
use crate::span::{FileId, Span};
use crate::syntax::Syntax;
use crate::text::{OpenError, Text};
use std::collections::{HashMap, VecDeque};
use std::io;
use std::path::{Path, PathBuf};
use std::sync::Arc;

/// Bytes of text lexed at a time; also the longest line that can be read.
const PAGE_BYTES: usize = 1 << 16;

/// Lexed pages kept, bytes.
const PAGE_BUDGET: usize = 24 << 20;

/// Programs noted in one file, and files looked at in the folder: far beyond any shop's.
const MAX_PROGRAMS: usize = 100_000;
const MAX_FOLDER: usize = 10_000;

/// Extensions of part programs (lower case), for the files beside the main one.
pub const EXTENSIONS: &[&str] =
    &["nc", "cnc", "ncc", "ngc", "tap", "mpf", "spf", "eng", "mmg", "gcode", "txt", "sub"];

/// What a program is called by.
#[derive(Clone, PartialEq, Eq, Hash, Debug, PartialOrd, Ord)]
pub enum ProgramId {
    /// `O1002`
    Number(u32),
    /// `O"name"`, or the name of a file without extension; compared in lower case.
    Name(Box<str>),
}

/// A block of a file of program memory.
#[derive(Clone, Copy, PartialEq, Eq, Hash, Debug, Default)]
pub struct Place {
    /// The file.
    pub file: FileId,
    /// Its page.
    pub page: u32,
    /// The block in the page; may be one past the last.
    pub block: u32,
}

/// Where a page of a file starts.
#[derive(Debug)]
struct PageSlot {
    offset: u64,
    line: u32,
    page: Option<Arc<Page>>,
}

#[derive(Debug)]
struct ProgramFile {
    name: Box<str>,
    text: Text,
    slots: Vec<PageSlot>,
    /// Where the page after the last slot starts; `None` once the end is known.
    next: Option<(u64, u32)>,
    /// Programs found in the file, once they were asked for.
    programs: Option<HashMap<ProgramId, Place>>,
}

/// The programs that can be run and called.
#[derive(Debug)]
pub struct ProgramMemory {
    syntax: &'static Syntax,
    files: Vec<ProgramFile>,
    /// Pages in the order they were lexed, for giving up the oldest.
    kept: VecDeque<(FileId, u32, usize)>,
    kept_bytes: usize,
    buffer: Vec<u8>,
    /// Folder whose files can be called, and the main file's path within it.
    folder: Option<(PathBuf, PathBuf)>,
    /// Programs found in the folder, once something was asked that the files do not hold.
    folder_index: Option<HashMap<ProgramId, PathBuf>>,
}

impl ProgramMemory {
    /// Memory with one file, the main program's.
    pub fn new(name: &str, text: Text, syntax: &'static Syntax) -> ProgramMemory {
        let mut memory = ProgramMemory {
            syntax,
            files: Vec::new(),
            kept: VecDeque::new(),
            kept_bytes: 0,
            buffer: Vec::new(),
            folder: None,
            folder_index: None,
        };
        memory.add(name, text);
        memory
    }

    /// Memory with the file at `path` as main program; the part programs beside it can be called.
    pub fn open(path: &Path, syntax: &'static Syntax) -> Result<ProgramMemory, OpenError> {
        let mut memory = ProgramMemory::new(&path.to_string_lossy(), Text::open(path)?, syntax);
        let folder = path.parent().filter(|p| !p.as_os_str().is_empty()).unwrap_or(Path::new("."));
        memory.folder = Some((folder.to_path_buf(), path.to_path_buf()));
        Ok(memory)
    }

    /// Adds a file whose programs can be called.
    pub fn add(&mut self, name: &str, text: Text) -> FileId {
        let mark = text.encoding().mark as u64;
        let file =
            ProgramFile { name: name.into(), text, slots: Vec::new(), next: Some((mark, 1)), programs: None };
        self.files.push(file);
        FileId(u16::try_from(self.files.len() - 1).unwrap_or(u16::MAX))
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
        self.files.get(usize::from(file.0)).map(|f| &f.text)
    }

    /// The text of a span, decoded.
    pub fn slice(&self, span: Span) -> String {
        let Some(text) = self.text(span.file) else { return String::new() };
        text.slice(span).map(|bytes| text.encoding().decode(&bytes).into_owned()).unwrap_or_default()
    }

    /// The page with this number; `None` past the end of the file.
    pub fn page(&mut self, id: FileId, number: u32) -> io::Result<Option<Arc<Page>>> {
        loop {
            let Some(file) = self.files.get_mut(usize::from(id.0)) else { return Ok(None) };
            if let Some(slot) = file.slots.get(number as usize) {
                if let Some(page) = &slot.page {
                    return Ok(Some(page.clone()));
                }
                let (offset, line) = (slot.offset, slot.line);
                return self.lex(id, number, offset, line).map(Some);
            }
            let Some((offset, line)) = file.next else { return Ok(None) };
            if offset >= file.text.len() {
                file.next = None;
                return Ok(None);
            }
            let next = file.slots.len() as u32;
            file.slots.push(PageSlot { offset, line, page: None });
            self.lex(id, next, offset, line)?;
        }
    }

    /// Lexes a page whose slot exists and keeps it.
    fn lex(&mut self, id: FileId, number: u32, offset: u64, line: u32) -> io::Result<Arc<Page>> {
        let syntax = self.syntax;
        let Some(file) = self.files.get_mut(usize::from(id.0)) else { return Ok(Arc::default()) };
        let len = file.text.len();
        let is_last = offset + PAGE_BYTES as u64 >= len;
        let lexed = file.text.window(offset, PAGE_BYTES, &mut self.buffer, |bytes| {
            lexer::lex(bytes, id, offset, line, is_last, syntax)
        })?;
        // A file that became shorter while it is read ends here.
        let is_end = lexed.consumed == 0 || is_last;
        let mut end = (offset + lexed.consumed as u64, lexed.next_line);
        if !is_end && lexed.page.defects.iter().any(|d| d.kind == crate::DefectKind::LineTooLong) {
            end = skip_line_tail(&file.text, end, &mut self.buffer)?;
        }
        if number as usize + 1 == file.slots.len() {
            file.next = if is_end { None } else { Some(end) };
        }
        let page = Arc::new(lexed.page);
        if let Some(slot) = file.slots.get_mut(number as usize) {
            slot.page = Some(page.clone());
        }
        self.keep(id, number, bytes_of(&page));
        Ok(page)
    }

    /// Counts a page that was lexed, and gives up the oldest ones beyond the budget.
    fn keep(&mut self, id: FileId, number: u32, bytes: usize) {
        self.kept.push_back((id, number, bytes));
        self.kept_bytes += bytes;
        while self.kept_bytes > PAGE_BUDGET && self.kept.len() > 1 {
            let Some((id, number, bytes)) = self.kept.pop_front() else { return };
            self.kept_bytes -= bytes;
            let file = self.files.get_mut(usize::from(id.0));
            if let Some(slot) = file.and_then(|f| f.slots.get_mut(number as usize)) {
                slot.page = None;
            }
        }
    }

    /// The block at which a called program starts (the one with its `O` word): in the main file, then
    /// in the others, then in the part programs of the main file's folder.
    pub fn find_program(&mut self, id: &ProgramId) -> io::Result<Option<Place>> {
        for file in 0..self.files.len() {
            if let Some(place) = self.find_in_file(FileId(file as u16), id)? {
                return Ok(Some(place));
            }
        }
        let Some((folder, main)) = self.folder.clone() else { return Ok(None) };
        if self.folder_index.is_none() {
            self.folder_index = Some(self.index_folder(&folder, &main));
        }
        let Some(path) = self.folder_index.as_ref().and_then(|index| index.get(id)).cloned() else {
            return Ok(None);
        };
        // A file that cannot be opened any more is a program that is not there.
        let Ok(text) = Text::open(&path) else { return Ok(None) };
        if self.files.len() >= usize::from(u16::MAX) {
            return Ok(None);
        }
        let name = path.file_name().map(|n| n.to_string_lossy().into_owned()).unwrap_or_default();
        let file = self.add(&name, text);
        let inside = self.find_in_file(file, id)?;
        Ok(Some(inside.unwrap_or(Place { file, page: 0, block: 0 })))
    }

    fn find_in_file(&mut self, id: FileId, program: &ProgramId) -> io::Result<Option<Place>> {
        let known = self.files.get(usize::from(id.0)).is_some_and(|f| f.programs.is_some());
        if !known {
            let programs = self.index_file(id)?;
            if let Some(file) = self.files.get_mut(usize::from(id.0)) {
                file.programs = Some(programs);
            }
        }
        let programs = self.files.get(usize::from(id.0)).and_then(|f| f.programs.as_ref());
        Ok(programs.and_then(|p| p.get(program)).copied())
    }

    /// Finds the blocks that start with an O word; of two with one number the first counts.
    fn index_file(&mut self, id: FileId) -> io::Result<HashMap<ProgramId, Place>> {
        let mut programs = HashMap::new();
        let mut number = 0;
        while let Some(page) = self.page(id, number)? {
            for (at, program) in numbered_programs(&page) {
                let place = Place { file: id, page: number, block: at };
                programs.entry(ProgramId::Number(program)).or_insert(place);
            }
            if programs.len() > MAX_PROGRAMS {
                break;
            }
            number += 1;
        }
        Ok(programs)
    }

    /// Finds the programs in the part programs of a folder: by the name of the file, `O1002.nc` or
    /// `1002.nc` for a number, and by the O words in it.
    fn index_folder(&self, folder: &Path, main: &Path) -> HashMap<ProgramId, PathBuf> {
        let mut index = HashMap::new();
        let Ok(entries) = std::fs::read_dir(folder) else { return index };
        let mut paths: Vec<PathBuf> = entries
            .take(MAX_FOLDER)
            .filter_map(|e| e.ok().map(|e| e.path()))
            .filter(|p| p.file_name() != main.file_name() && is_part_program(p))
            .collect();
        paths.sort();
        for path in &paths {
            let stem = path.file_stem().map(|s| s.to_string_lossy().to_lowercase()).unwrap_or_default();
            let digits = stem.strip_prefix('o').unwrap_or(&stem);
            if let Ok(number) = digits.parse() {
                index.entry(ProgramId::Number(number)).or_insert_with(|| path.clone());
            }
            index.entry(ProgramId::Name(stem.into())).or_insert_with(|| path.clone());
        }
        for path in &paths {
            let Ok(text) = Text::open(path) else { continue };
            let mut alone = ProgramMemory::new("", text, self.syntax);
            for id in alone.index_file(FileId(0)).unwrap_or_default().into_keys() {
                index.entry(id).or_insert_with(|| path.clone());
            }
        }
        index
    }
}

fn is_part_program(path: &Path) -> bool {
    let extension = path.extension().map(|e| e.to_string_lossy().to_lowercase()).unwrap_or_default();
    EXTENSIONS.contains(&extension.as_str()) && path.is_file()
}

/// Blocks of a page that start with an O word, and their numbers.
fn numbered_programs(page: &Page) -> impl Iterator<Item = (u32, u32)> {
    page.blocks.iter().enumerate().filter_map(|(at, block)| {
        let first = page.words(block).first()?;
        match first.value() {
            crate::Value::Number(n) if first.letter == b'O' && n >= 0.0 && n <= f64::from(u32::MAX) => {
                Some((at as u32, n as u32))
            }
            _ => None,
        }
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
        + array(&page.defects)
}

/// Goes on to the end of a line that is longer than a page.
fn skip_line_tail(
    text: &Text,
    (mut offset, line): (u64, u32),
    buffer: &mut Vec<u8>,
) -> io::Result<(u64, u32)> {
    let last = if offset == 0 {
        None
    } else {
        text.slice(Span { offset: offset - 1, len: 1, ..Span::default() })?.pop()
    };
    if matches!(last, Some(b'\n' | b'\r')) {
        return Ok((offset, line));
    }
    while offset < text.len() {
        let (found, len) = text.window(offset, PAGE_BYTES, buffer, |bytes| {
            (bytes.iter().position(|b| *b == b'\n'), bytes.len())
        })?;
        match found {
            Some(at) => return Ok((offset + at as u64 + 1, line.saturating_add(1))),
            None if len == 0 => break,
            None => offset += len as u64,
        }
    }
    Ok((offset, line))
}
