//! The elements of an XML document, with the line of each.
//!
//! They are kept in one list, each with the number of its parent, so that neither reading nor dropping a
//! document goes down as deep as the document does.

use crate::fault::{Error, Fault, Span};
use quick_xml::XmlVersion;
use quick_xml::escape::resolve_predefined_entity;
use quick_xml::events::{BytesStart, Event};
use quick_xml::reader::Reader;

/// Most elements of a document: those of a ladder of 24,000 steps many times over.
const MOST_ELEMENTS: usize = 500_000;
/// Deepest nesting: a diagram needs 15.
const DEEPEST: usize = 64;

struct Item {
    name: String,
    attributes: Vec<(String, String)>,
    text: String,
    span: Span,
    /// The number behind the last element within this one.
    end: usize,
}

/// A document.
pub(super) struct Document {
    items: Vec<Item>,
}

/// An element of a document.
#[derive(Clone, Copy)]
pub(super) struct Node<'a> {
    document: &'a Document,
    at: usize,
    item: &'a Item,
}

impl Document {
    /// Reads a document.
    pub(super) fn read(text: &str) -> Result<Document, Error> {
        let starts: Vec<usize> = std::iter::once(0)
            .chain(text.bytes().enumerate().filter(|(_, b)| *b == b'\n').map(|(at, _)| at + 1))
            .collect();
        let span = |at: usize, len: usize| {
            let line = starts.partition_point(|start| *start <= at);
            let len = len.min(text.len().saturating_sub(at));
            Span { offset: at.min(text.len()), len, line: u32::try_from(line).unwrap_or(u32::MAX) }
        };
        let mut reader = Reader::from_str(text);
        let mut items: Vec<Item> = Vec::new();
        // Elements that are not closed yet.
        let mut open: Vec<usize> = Vec::new();
        loop {
            let at = usize::try_from(reader.buffer_position()).unwrap_or(usize::MAX);
            let event = reader.read_event().map_err(|error| {
                let at = usize::try_from(reader.error_position()).unwrap_or(usize::MAX);
                Error::about(Fault::FileFormat, span(at, 1), error.to_string())
            })?;
            let add = match &event {
                Event::Start(start) | Event::Empty(start) => Some(start),
                _ => None,
            };
            if let Some(start) = add {
                let place = span(at, 1 + start.name().as_ref().len());
                let is_second_root = open.is_empty() && !items.is_empty();
                if items.len() == MOST_ELEMENTS || open.len() == DEEPEST || is_second_root {
                    return Err(Error::about(Fault::FileFormat, place, start.name().as_ref()));
                }
                if matches!(event, Event::Start(_)) {
                    open.push(items.len());
                }
                items.push(item(start, place, items.len() + 1)?);
                continue;
            }
            let len = items.len();
            let mut add_text = |more: &str| {
                if let Some(item) = open.last().and_then(|open| items.get_mut(*open)) {
                    item.text.push_str(more);
                }
            };
            match event {
                Event::End(_) => {
                    if let Some(item) = open.pop().and_then(|open| items.get_mut(open)) {
                        item.end = len;
                    }
                }
                Event::Text(more) => add_text(&more),
                Event::CData(more) => add_text(&more),
                Event::GeneralRef(name) => {
                    let character = name.resolve_char_ref().ok().flatten();
                    let wrong = || Error::about(Fault::FileFormat, span(at, 1), format!("&{};", &*name));
                    match (character, resolve_predefined_entity(&name)) {
                        (Some(character), _) => add_text(character.encode_utf8(&mut [0; 4])),
                        (None, Some(text)) => add_text(text),
                        (None, None) => return Err(wrong()),
                    }
                }
                // Entities of its own could stand for anything, a thousand times over.
                Event::DocType(_) => {
                    return Err(Error::about(Fault::FileFormat, span(at, 1), "DOCTYPE"));
                }
                Event::Eof => break,
                _ => {}
            }
        }
        match (open.last().and_then(|open| items.get(*open)), items.is_empty()) {
            (Some(item), _) => Err(Error::about(Fault::FileFormat, item.span, item.name.as_str())),
            (None, true) => Err(Error::new(Fault::FileFormat, span(0, 0))),
            (None, false) => Ok(Document { items }),
        }
    }

    /// The outermost element.
    pub(super) fn root(&self) -> Option<Node<'_>> {
        self.node(0)
    }

    fn node(&self, at: usize) -> Option<Node<'_>> {
        self.items.get(at).map(|item| Node { document: self, at, item })
    }
}

fn item(start: &BytesStart, span: Span, end: usize) -> Result<Item, Error> {
    let wrong = |error: String| Error::about(Fault::FileFormat, span, error);
    let mut attributes = Vec::new();
    for attribute in start.attributes() {
        let attribute = attribute.map_err(|error| wrong(error.to_string()))?;
        let value =
            attribute.normalized_value(XmlVersion::Implicit1_0).map_err(|error| wrong(error.to_string()))?;
        attributes.push((attribute.key.local_name().as_ref().to_owned(), value.into_owned()));
    }
    let name = start.local_name().as_ref().to_owned();
    Ok(Item { name, attributes, text: String::new(), span, end })
}

impl<'a> Node<'a> {
    /// Its name without the prefix of its namespace.
    pub(super) fn name(self) -> &'a str {
        &self.item.name
    }

    /// Its tag.
    pub(super) fn span(self) -> Span {
        self.item.span
    }

    /// The text directly within it.
    pub(super) fn text(self) -> &'a str {
        self.item.text.trim()
    }

    /// An attribute by its name.
    pub(super) fn attribute(self, name: &str) -> Option<&'a str> {
        self.item.attributes.iter().find(|(key, _)| key == name).map(|(_, value)| value.as_str())
    }

    /// All elements within it.
    pub(super) fn descendants(self) -> impl Iterator<Item = Node<'a>> {
        (self.at + 1..self.item.end).filter_map(move |at| self.document.node(at))
    }

    /// The elements directly within it.
    pub(super) fn children(self) -> impl Iterator<Item = Node<'a>> {
        let mut at = self.at + 1;
        std::iter::from_fn(move || {
            let child = self.document.node(at).filter(|_| at < self.item.end)?;
            at = child.item.end;
            Some(child)
        })
    }

    /// The first element of a name directly within it.
    pub(super) fn child(self, name: &str) -> Option<Node<'a>> {
        self.children().find(|child| child.name() == name)
    }
}
