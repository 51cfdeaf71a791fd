//! Blocks written out in their places, down to lines and arcs.
//!
//! An entity on layer `0` of a block lies on the layer that the block is inserted on. What is frozen
//! with the layer of an insertion is everything in it; what is switched off with it is what lies on
//! that layer.

use super::entities::{Body, Insert, Shape};
use super::{Entity, File};
use crate::affine::{Affine, Vector};
use crate::curve::Curve;
use crate::drawing::{Drawing, LayerNames};
use crate::limits::Limits;
use crate::settings::{Format, ROUNDING, Settings};
use crate::spline;
use ferrocut_machine::{Alarm, Fault};
use ferrocut_program::Span;
use rustc_hash::FxHashMap;
use std::collections::BTreeMap;

/// Blocks in blocks in blocks at most: far beyond any drawing's.
const MOST_LEVELS: usize = 64;

/// The share of the tolerance that is kept for arcs whose centre is too far away to be written.
const LARGE_ARC_SHARE: f64 = 0.2;

/// Model space on its way to lines and arcs.
struct Writer<'a> {
    file: &'a File,
    settings: &'a Settings,
    limits: &'a mut Limits,
    drawing: &'a mut Drawing,
    names: LayerNames,
    /// The drawing's number of a layer of the file; `None` if it is not shown.
    layers: FxHashMap<u32, u32>,
    /// Layers that are not shown, with the number of entities and the first.
    unseen: BTreeMap<u32, (u64, Span)>,
    /// Blocks that are not there.
    missing: BTreeMap<u32, Span>,
    /// Blocks being written out, outermost first.
    open: Vec<u32>,
    curves: Vec<Curve>,
}

/// Writes out model space.
pub fn write_out(
    file: &File,
    scale: f64,
    settings: &Settings,
    limits: &mut Limits,
    drawing: &mut Drawing,
) -> Result<(), Box<Alarm>> {
    let mut writer = Writer {
        file,
        settings,
        limits,
        drawing,
        names: LayerNames::default(),
        layers: FxHashMap::default(),
        unseen: BTreeMap::new(),
        missing: BTreeMap::new(),
        open: Vec::new(),
        curves: Vec::new(),
    };
    let place = Affine::scale([scale; 3]);
    for entity in &file.model {
        writer.entity(entity, &place, None, entity.span)?;
    }
    let Writer { unseen, missing, drawing, .. } = writer;
    let name = |bytes: &[u8]| super::names::decode(bytes, file.page);
    for (layer, (count, span)) in unseen {
        let warning = Alarm::core(Fault::LayerLeftOut, span).with("name", name(file.layers.bytes(layer)));
        drawing.warnings.push(warning.with("count", count as f64).as_warning());
    }
    for (block, span) in missing {
        let warning =
            Alarm::core(Fault::BlockMissing, span).with("name", name(file.block_names.bytes(block)));
        drawing.warnings.push(warning.as_warning());
    }
    Ok(())
}

impl Writer<'_> {
    /// Writes out one entity. `on` is the layer of the insertion that it is part of; `span` is what in
    /// model space causes it.
    fn entity(
        &mut self,
        entity: &Entity,
        place: &Affine,
        on: Option<u32>,
        span: Span,
    ) -> Result<(), Box<Alarm>> {
        let layer = match on {
            Some(on) if self.file.layers.bytes(entity.layer) == b"0" => on,
            _ => entity.layer,
        };
        let state = self.file.layer_states.get(&layer).copied().unwrap_or_default();
        match &entity.body {
            Body::Insert(insert) if !state.is_frozen => self.insert(insert, place, layer, span),
            Body::Shape(shape) if !state.is_frozen && !state.is_off => self.shape(shape, place, layer, span),
            _ => {
                let (count, _) = self.unseen.entry(layer).or_insert((0, span));
                *count += 1;
                Ok(())
            }
        }
    }

    fn insert(&mut self, insert: &Insert, place: &Affine, layer: u32, span: Span) -> Result<(), Box<Alarm>> {
        let file = self.file;
        let Some(block) = file.blocks.get(&insert.block).filter(|block| block.is_defined) else {
            self.missing.entry(insert.block).or_insert(span);
            return Ok(());
        };
        if self.open.contains(&insert.block) || self.open.len() >= MOST_LEVELS {
            let name = super::names::decode(file.block_names.bytes(insert.block), file.page);
            return Err(Box::new(Alarm::core(Fault::BlockInItself, span).with("name", name)));
        }
        self.open.push(insert.block);
        let base = Affine::shift(block.base.map(|c| -c));
        let [columns, rows] = insert.count;
        for row in 0..rows {
            for column in 0..columns {
                self.limits.insert().map_err(|refused| refused.at(span))?;
                let [across, up] = insert.step;
                let step: Vector =
                    std::array::from_fn(|i| across[i] * f64::from(column) + up[i] * f64::from(row));
                let inner = place.after(&Affine::shift(step).after(&insert.place.after(&base)));
                for entity in &block.entities {
                    self.entity(entity, &inner, Some(layer), span)?;
                }
            }
        }
        self.open.pop();
        Ok(())
    }

    fn shape(&mut self, shape: &Shape, place: &Affine, layer: u32, span: Span) -> Result<(), Box<Alarm>> {
        let layer = self.layer(layer);
        if self.drawing.layers.get(layer as usize).is_none_or(|layer| layer.cutting.is_none()) {
            return Ok(());
        }
        // What is left for arcs that are too large to be written adds to what fitting them took.
        let whole = self.settings.tolerance - ROUNDING;
        let chords = whole * LARGE_ARC_SHARE;
        let tolerance = whole - chords;
        let mut curves = std::mem::take(&mut self.curves);
        let made = match shape {
            Shape::Line(from, to) => {
                let flat = |p: &Vector| {
                    let [x, y, _] = place.point(*p);
                    [x, y]
                };
                curves.push(Curve::line(flat(from), flat(to)));
                Ok(())
            }
            Shape::Ellipse(ellipse) => ellipse.placed(place).curves(tolerance, self.limits, &mut curves),
            Shape::Spline(spline) => {
                spline::curves(&spline.placed(|p| place.point(p)), tolerance, self.limits, &mut curves)
            }
        };
        made.map_err(|refused| refused.at(span))?;
        for curve in curves.drain(..) {
            // What is seen edge on is a point.
            if curve.length() > 0.0 || curve.bend.is_some() {
                self.drawing.cut(curve, chords, layer, span, self.limits)?;
            }
        }
        self.curves = curves;
        Ok(())
    }

    fn layer(&mut self, number: u32) -> u32 {
        if let Some(layer) = self.layers.get(&number) {
            return *layer;
        }
        let name = super::names::decode(self.file.layers.bytes(number), self.file.page);
        let settings = self.settings;
        let layer = self.names.number(&name, self.drawing, || settings.of_layer(Format::Dxf, &name));
        self.layers.insert(number, layer);
        layer
    }
}
