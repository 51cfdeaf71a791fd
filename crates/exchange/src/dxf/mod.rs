//! DXF, the drawing exchange format of AutoCAD: lines, arcs, circles, ellipses, splines, polylines, and
//! blocks of them.
//!
//! The way of the data: `pairs` (lines of the file, two by two) → here (sections, layers, which
//! entities there are and whom they belong to) → `entities` (what an entity is, read by the `dxf`
//! crate) → `blocks` (blocks written out in their places) → lines and arcs.
//!
//! # The `dxf` crate behind a sieve
//!
//! The crate knows the entities and the defaults of their parts. It is given nothing but those entities
//! that are cut, and of these nothing but group codes with checked numbers, a piece of the drawing at a
//! time: it rejects whole files for a header variable that nobody needs, ends silently at an entity that
//! it cannot read, and panics on some strings. Names never reach it. Each entity carries its number
//! as handle, so that one that does not come back is noticed and its place in the file is known.
//!
//! # What is cut
//!
//! Model space seen from above; Z is ignored. Layers that are frozen or off, entities that are invisible
//! or in paper space, and other kinds are left out, and said so.

mod blocks;
mod entities;
mod names;
mod pairs;

use crate::drawing::Drawing;
use crate::limits::{Limits, MOST_CURVES, Refused};
use crate::settings::{Format, Settings};
use crate::{affine::Vector, alarm};
use encoding_rs::Encoding;
use entities::{Body, Sieve};
use ferrocut_machine::{Alarm, Fault};
use ferrocut_program::{FileId, Span};
use names::Names;
use pairs::{Pair, Pairs};
use rustc_hash::FxHashMap;
use std::collections::BTreeMap;

/// Length of the units of `$INSUNITS`, mm, from 0 on. 0 is no unit: mm (as in the Weihong set-up).
const UNITS: &[f64] = &[
    1.0,
    25.4,
    304.8,
    1_609_344.0,
    1.0,
    10.0,
    1000.0,
    1e6,
    25.4e-6,
    0.0254,
    914.4,
    1e-7,
    1e-6,
    1e-3,
    100.0,
    1e4,
    1e5,
    1e12,
    149_597_870_700e3,
    9.460_730_472_580_8e18,
    3.085_677_581_491_367e19,
    1_200_000.0 / 3937.0,
    100_000.0 / 3937.0,
    3_600_000.0 / 3937.0,
    6_336_000_000.0 / 3937.0,
];

/// Layers that nothing is drawn on.
#[derive(Clone, Copy, Default)]
struct LayerState {
    is_frozen: bool,
    is_off: bool,
}

/// An entity that is cut or inserts a block.
struct Entity {
    layer: u32,
    span: Span,
    body: Body,
}

/// A block.
#[derive(Default)]
struct Block {
    base: Vector,
    entities: Vec<Entity>,
    is_defined: bool,
}

/// Whom an entity belongs to: model space, or the block with this number.
type Owner = Option<u32>;

/// What a file holds.
#[derive(Default)]
struct File {
    /// mm
    unit: Option<f64>,
    page: Option<&'static Encoding>,
    layers: Names,
    layer_states: FxHashMap<u32, LayerState>,
    block_names: Names,
    blocks: FxHashMap<u32, Block>,
    model: Vec<Entity>,
    count: usize,
    /// Kinds of entities that are not cut, with their number and the first of them.
    others: BTreeMap<Box<[u8]>, (u64, Span)>,
    hidden: Option<(u64, Span)>,
}

impl File {
    fn add(&mut self, owner: Owner, entity: Entity) -> Result<(), Box<Alarm>> {
        self.count += 1;
        if self.count > MOST_CURVES {
            return Err(Refused::TooMany("curves", MOST_CURVES as f64).at(entity.span));
        }
        match owner {
            None => self.model.push(entity),
            Some(block) => self.blocks.entry(block).or_default().entities.push(entity),
        }
        Ok(())
    }

    fn left_out(&mut self, kind: &[u8], owner: Owner, span: Span) {
        // Random bytes must not make a list of their own.
        const MOST_KINDS: usize = 100;
        // Further sheets are blocks that nothing inserts.
        let sheet = owner.is_some_and(|block| {
            self.block_names.bytes(block).to_ascii_uppercase().starts_with(b"*PAPER_SPACE")
        });
        if sheet {
            return;
        }
        if let Some((count, _)) = self.others.get_mut(kind) {
            *count += 1;
        } else if self.others.len() < MOST_KINDS {
            self.others.insert(kind.into(), (1, span));
        }
    }

    fn hide(&mut self, span: Span) {
        let (count, _) = self.hidden.get_or_insert((0, span));
        *count += 1;
    }
}

/// Reads a drawing.
pub fn read(bytes: &[u8], file: FileId, settings: &Settings) -> Result<Drawing, Box<Alarm>> {
    if bytes.starts_with(b"AutoCAD Binary DXF") {
        return Err(alarm(Fault::DxfBinary, Span { line: 1, file, ..Span::default() }));
    }
    let mut pairs = Pairs::new(bytes, file);
    let mut found = File::default();
    loop {
        let pair = pairs.next()?;
        if pair.is(0, b"EOF") {
            break;
        }
        if !pair.is(0, b"SECTION") {
            continue;
        }
        let name = pairs.next()?;
        match (name.code, name.value) {
            (2, b"HEADER") => header(&mut pairs, &mut found)?,
            (2, b"TABLES") => tables(&mut pairs, &mut found)?,
            (2, b"BLOCKS" | b"ENTITIES") => section(&mut pairs, &mut found)?,
            _ => skip_section(&mut pairs, name)?,
        }
    }
    let mut drawing = Drawing::new(Format::Dxf);
    drawing.end = pairs.here();
    let scale = settings.scale * settings.unit.or(found.unit).unwrap_or(1.0);
    blocks::write_out(&found, scale, settings, &mut Limits::new(), &mut drawing)?;
    for (kind, (count, span)) in &found.others {
        let kind = String::from_utf8_lossy(kind).into_owned();
        let warning =
            Alarm::core(Fault::EntityLeftOut, *span).with("kind", kind).with("count", *count as f64);
        drawing.warnings.push(warning.as_warning());
    }
    if let Some((count, span)) = found.hidden {
        let warning = Alarm::core(Fault::HiddenLeftOut, span).with("count", count as f64);
        drawing.warnings.push(warning.as_warning());
    }
    drawing.warnings.sort_by_key(|warning| warning.span.line);
    Ok(drawing)
}

fn skip_section<'a>(pairs: &mut Pairs<'a>, first: Pair<'a>) -> Result<(), Box<Alarm>> {
    pairs.put_back(first);
    while let pair = pairs.next()?
        && !pair.is(0, b"ENDSEC")
    {
        if pair.is(0, b"EOF") {
            pairs.put_back(pair);
            break;
        }
    }
    Ok(())
}

/// `$INSUNITS` and `$DWGCODEPAGE`.
fn header(pairs: &mut Pairs<'_>, found: &mut File) -> Result<(), Box<Alarm>> {
    let mut variable: &[u8] = b"";
    loop {
        let pair = pairs.next()?;
        match (pair.code, variable) {
            (0, _) if pair.is(0, b"ENDSEC") => return Ok(()),
            (0, _) => return Err(alarm(Fault::DrawingTruncated, pair.span)),
            (9, _) => variable = pair.value,
            (70, b"$INSUNITS") => {
                let number = usize::try_from(pair.whole()?).ok();
                let unit = number.and_then(|number| UNITS.get(number));
                found.unit = Some(*unit.ok_or_else(|| alarm(Fault::DxfValue, pair.span))?);
            }
            (3, b"$DWGCODEPAGE") => found.page = names::code_page(pair.value),
            _ => {}
        }
    }
}

/// Layers that are frozen or off.
fn tables(pairs: &mut Pairs<'_>, found: &mut File) -> Result<(), Box<Alarm>> {
    let mut layer: Option<u32> = None;
    let mut is_layer = false;
    loop {
        let pair = pairs.next()?;
        if pair.code == 0 {
            if pair.value == b"ENDSEC" {
                return Ok(());
            }
            if pair.value == b"EOF" {
                return Err(alarm(Fault::DrawingTruncated, pair.span));
            }
            is_layer = pair.value == b"LAYER";
            layer = None;
            continue;
        }
        if !is_layer {
            continue;
        }
        match (pair.code, layer) {
            (2, _) => layer = Some(found.layers.number(pair.value)),
            (70, Some(layer)) => {
                found.layer_states.entry(layer).or_default().is_frozen = pair.whole()? & 1 != 0;
            }
            (62, Some(layer)) => found.layer_states.entry(layer).or_default().is_off = pair.whole()? < 0,
            _ => {}
        }
    }
}

/// The entities of model space, or the blocks with theirs.
fn section(pairs: &mut Pairs<'_>, found: &mut File) -> Result<(), Box<Alarm>> {
    let mut sieve = Sieve::default();
    let mut owner: Owner = None;
    loop {
        let pair = pairs.next()?;
        match (pair.code, pair.value) {
            (0, b"ENDSEC") => break,
            (0, b"EOF") => return Err(alarm(Fault::DrawingTruncated, pair.span)),
            (0, b"BLOCK") => owner = Some(block(pairs, found)?),
            (0, b"ENDBLK") => owner = None,
            (0, kind) => sieve.entity(kind, pair.span, owner, pairs, found)?,
            // What stands behind the end of an entity, or behind ENDBLK.
            _ => {}
        }
    }
    sieve.read(found)
}

/// Name and base point of a block.
fn block(pairs: &mut Pairs<'_>, found: &mut File) -> Result<u32, Box<Alarm>> {
    let mut block = Block { is_defined: true, ..Block::default() };
    let mut number = None;
    loop {
        let pair = pairs.next()?;
        match pair.code {
            0 => {
                pairs.put_back(pair);
                break;
            }
            2 => number = Some(found.block_names.number(pair.value)),
            10 => block.base[0] = pair.number()?,
            20 => block.base[1] = pair.number()?,
            30 => block.base[2] = pair.number()?,
            _ => {}
        }
    }
    // A block without a name cannot be inserted.
    let number = number.unwrap_or_else(|| found.block_names.number(b""));
    found.blocks.insert(number, block);
    Ok(number)
}
