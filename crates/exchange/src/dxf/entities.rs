//! What an entity is: the sieve before the `dxf` crate, and what is made of what the crate reads.

use super::pairs::{Pair, Pairs};
use super::{Entity, File, Owner};
use crate::affine::{Affine, Vector, norm, sin_cos, vector_product};
use crate::alarm;
use crate::ellipse::Ellipse;
use crate::limits::Refused;
use crate::spline::Spline;
use dxf::entities::{EntityType, Insert as DxfInsert, Polyline, Vertex};
use ferrocut_machine::{Alarm, Fault};
use ferrocut_program::Span;
use std::f64::consts::TAU;
use std::fmt::Write;

/// A curve in space.
pub enum Shape {
    /// A straight line.
    Line(Vector, Vector),
    /// A circle, an ellipse, or an arc of them.
    Ellipse(Ellipse),
    /// A spline.
    Spline(Box<Spline>),
}

/// A block in its place.
pub struct Insert {
    /// Number of the block.
    pub block: u32,
    /// What places the block's coordinates, without its base point.
    pub place: Affine,
    /// Columns and rows of an array.
    pub count: [u32; 2],
    /// From one column, and one row, to the next.
    pub step: [Vector; 2],
}

/// What an entity is.
pub enum Body {
    /// Something to cut.
    Shape(Shape),
    /// A block.
    Insert(Box<Insert>),
}

/// Kinds that are cut, and INSERT.
const KINDS: &[&[u8]] =
    &[b"LINE", b"LWPOLYLINE", b"POLYLINE", b"ARC", b"CIRCLE", b"ELLIPSE", b"SPLINE", b"INSERT"];

/// Group codes with real numbers that the kinds use.
const REALS: &[i32] =
    &[10, 11, 12, 13, 20, 21, 22, 23, 30, 31, 32, 33, 38, 40, 41, 42, 43, 44, 45, 50, 51, 210, 220, 230];
/// Group codes with whole numbers of 16 bits that the kinds use.
const WHOLES: &[i32] = &[70, 71, 72, 73, 74];

/// Text given to the crate at a time, bytes: a few megabytes of entities.
const PIECE: usize = 1 << 18;

/// Points of one entity.
const MOST_POINTS: u32 = 200_000;

/// What is known of an entity beside what the crate reads.
#[derive(Clone, Copy)]
struct Record {
    owner: Owner,
    layer: u32,
    span: Span,
    block: u32,
    /// Where its text starts in the piece.
    start: usize,
}

/// Collects entities in a form that the crate reads for certain.
#[derive(Default)]
pub struct Sieve {
    text: String,
    records: Vec<Record>,
    /// A POLYLINE whose vertices are being collected, and whether they are kept; how many.
    polyline: Option<(bool, u32)>,
}

impl Sieve {
    /// Takes the entity whose kind was just read.
    pub fn entity(
        &mut self,
        kind: &[u8],
        span: Span,
        owner: Owner,
        pairs: &mut Pairs<'_>,
        found: &mut File,
    ) -> Result<(), Box<Alarm>> {
        match (kind, self.polyline) {
            (b"VERTEX", Some((is_kept, count))) => {
                self.polyline = Some((is_kept, count + 1));
                if count >= MOST_POINTS {
                    return Err(Refused::TooMany("points", f64::from(MOST_POINTS)).at(span));
                }
                let start = self.text.len();
                self.text.push_str("0\nVERTEX\n");
                self.values(false, pairs, found)?;
                if !is_kept {
                    self.text.truncate(start);
                }
                return Ok(());
            }
            (_, Some((is_kept, _))) => {
                if is_kept {
                    self.text.push_str("0\nSEQEND\n");
                }
                self.polyline = None;
            }
            _ => {}
        }
        if self.text.len() >= PIECE {
            self.read(found)?;
        }
        if !KINDS.contains(&kind) {
            // The parts of other entities belong to them.
            let is_hidden = skip(pairs)?;
            if !is_hidden && !matches!(kind, b"VERTEX" | b"SEQEND" | b"ATTRIB") {
                found.left_out(kind, owner, span);
            }
            return Ok(());
        }
        let start = self.text.len();
        let kind = String::from_utf8_lossy(kind);
        // Writing to a string cannot fail.
        let _ = write!(self.text, "0\n{kind}\n5\n{:X}\n", self.records.len() + 1);
        if kind == "POLYLINE" {
            self.text.push_str("66\n1\n");
        }
        let about = self.values(kind == "SPLINE", pairs, found)?;
        let is_mesh = kind == "POLYLINE" && about.flags & (16 | 64) != 0;
        let is_kept = !about.is_hidden && !is_mesh;
        if kind == "POLYLINE" {
            self.polyline = Some((is_kept, 0));
        }
        if is_kept {
            self.records.push(Record { owner, layer: about.layer, span, block: about.name, start });
            return Ok(());
        }
        self.text.truncate(start);
        match is_mesh {
            true => found.left_out(b"POLYLINE (mesh)", owner, span),
            false => found.hide(span),
        }
        Ok(())
    }

    /// Passes on the values of an entity that are known to be good.
    fn values(
        &mut self,
        is_spline: bool,
        pairs: &mut Pairs<'_>,
        found: &mut File,
    ) -> Result<About, Box<Alarm>> {
        let mut about = About { layer: found.layers.number(b"0"), name: 0, flags: 0, is_hidden: false };
        let mut points = 0;
        // Points of a spline without a height lie at 0; the crate counts them by their heights.
        let mut height = None;
        loop {
            let pair = pairs.next()?;
            if let Some(height) = height.take().filter(|height| *height != pair.code) {
                let _ = write!(self.text, "{height}\n0\n");
            }
            match pair.code {
                0 => {
                    pairs.put_back(pair);
                    return Ok(about);
                }
                2 => about.name = found.block_names.number(pair.value),
                8 => about.layer = found.layers.number(pair.value),
                // A group of an application.
                102 if pair.value.starts_with(b"{") => skip_group(pairs)?,
                60 | 67 => about.is_hidden |= pair.whole()? != 0,
                code if REALS.contains(&code) => {
                    if code == 10 || code == 11 {
                        points += 1;
                    }
                    if points > MOST_POINTS {
                        return Err(Refused::TooMany("points", f64::from(MOST_POINTS)).at(pair.span));
                    }
                    self.real(&pair)?;
                    height = (is_spline && matches!(code, 20 | 21)).then_some(code + 10);
                }
                // Counts say nothing that the points do not, and may be larger than the crate takes.
                72..=74 if is_spline => {
                    pair.whole()?;
                }
                code if WHOLES.contains(&code) => {
                    let whole = pair.whole()?;
                    let whole = i16::try_from(whole).map_err(|_| alarm(Fault::DxfValue, pair.span))?;
                    if code == 70 {
                        about.flags = whole;
                    }
                    let _ = write!(self.text, "{code}\n{whole}\n");
                }
                _ => {}
            }
        }
    }

    fn real(&mut self, pair: &Pair<'_>) -> Result<(), Box<Alarm>> {
        pair.number()?;
        // A number is ASCII.
        if let Ok(text) = std::str::from_utf8(pair.value) {
            let _ = write!(self.text, "{}\n{text}\n", pair.code);
        }
        Ok(())
    }

    /// Reads what was collected.
    pub fn read(&mut self, found: &mut File) -> Result<(), Box<Alarm>> {
        if let Some((true, _)) = self.polyline.take() {
            self.text.push_str("0\nSEQEND\n");
        }
        let records = std::mem::take(&mut self.records);
        let text = std::mem::take(&mut self.text);
        let Some(drawing) = load(&text, 1, records.len()) else {
            return Err(alarm(Fault::DxfEntity, culprit(&text, &records)));
        };
        for (entity, record) in drawing.entities().zip(records) {
            convert(entity, record, found)?;
        }
        Ok(())
    }
}

/// What the sieve itself reads of an entity.
struct About {
    layer: u32,
    /// Number of the name that an INSERT gives.
    name: u32,
    flags: i16,
    is_hidden: bool,
}

/// Passes over the values of an entity; whether it is invisible or lies in paper space.
fn skip(pairs: &mut Pairs<'_>) -> Result<bool, Box<Alarm>> {
    let mut is_hidden = false;
    loop {
        let pair = pairs.next()?;
        match pair.code {
            0 => {
                pairs.put_back(pair);
                return Ok(is_hidden);
            }
            60 | 67 => is_hidden |= pair.value != b"0",
            _ => {}
        }
    }
}

/// Passes over a group of an application, to its `}`.
fn skip_group(pairs: &mut Pairs<'_>) -> Result<(), Box<Alarm>> {
    loop {
        let pair = pairs.next()?;
        if pair.code == 0 {
            pairs.put_back(pair);
            return Ok(());
        }
        if pair.code == 102 {
            return Ok(());
        }
    }
}

/// A drawing with these entities, so many, whose handles count from `first`; `None` if the crate gives up.
fn load(entities: &str, first: u64, count: usize) -> Option<dxf::Drawing> {
    let text = format!("0\nSECTION\n2\nENTITIES\n{entities}0\nENDSEC\n0\nEOF\n");
    // The sieve lets nothing through that is known to make the crate panic. A panic that is not known
    // must not end the program either: the crate is given bytes and gives back values, so that nothing
    // half done can be left behind.
    let drawing = std::panic::catch_unwind(|| dxf::Drawing::load(&mut text.as_bytes()).ok()).ok()??;
    // Each must be the one that was given in its place, and none may be missing.
    let is_own = |(entity, number): (&dxf::entities::Entity, u64)| entity.common.handle.0 == number;
    let is_whole = drawing.entities().count() == count && drawing.entities().zip(first..).all(is_own);
    is_whole.then_some(drawing)
}

/// Where the entity stands that the crate does not read: they are given to it one by one.
fn culprit(text: &str, records: &[Record]) -> Span {
    let ends = records.iter().skip(1).map(|record| record.start).chain([text.len()]);
    let mut single = records.iter().zip(ends).zip(1u64..);
    let unread = single.find(|((record, end), number)| {
        let alone = text.get(record.start..*end).unwrap_or("");
        load(alone, *number, 1).is_none()
    });
    unread.map(|((record, _), _)| record).or(records.first()).map_or(Span::default(), |record| record.span)
}

fn vector(v: &dxf::Vector) -> Vector {
    [v.x, v.y, v.z]
}

fn point(p: &dxf::Point) -> Vector {
    [p.x, p.y, p.z]
}

/// Makes of an entity what is cut.
fn convert(entity: &dxf::entities::Entity, record: Record, found: &mut File) -> Result<(), Box<Alarm>> {
    let elevation = entity.common.elevation;
    let mut add = |body| found.add(record.owner, Entity { layer: record.layer, span: record.span, body });
    let shape = match &entity.specific {
        EntityType::Line(line) => Shape::Line(point(&line.p1), point(&line.p2)),
        EntityType::Circle(circle) => {
            let place = Affine::extrusion(vector(&circle.normal));
            Shape::Ellipse(round(point(&circle.center), circle.radius, 0.0, TAU).placed(&place))
        }
        EntityType::Arc(arc) => {
            let place = Affine::extrusion(vector(&arc.normal));
            let turned = (arc.end_angle - arc.start_angle).rem_euclid(360.0);
            let turned = if turned == 0.0 { 360.0 } else { turned };
            Shape::Ellipse(
                round(point(&arc.center), arc.radius, arc.start_angle, turned.to_radians()).placed(&place),
            )
        }
        EntityType::Ellipse(ellipse) => {
            let u = vector(&ellipse.major_axis);
            let normal = vector(&ellipse.normal);
            let length = norm(normal);
            let normal = if length > 0.0 { normal.map(|c| c / length) } else { [0.0, 0.0, 1.0] };
            let v = vector_product(normal, u).map(|c| c * ellipse.minor_axis_ratio);
            let run = (ellipse.end_parameter - ellipse.start_parameter).rem_euclid(TAU);
            // Whole turns are written with as many digits as their writer has.
            let sweep = if run < 1e-9 || TAU - run < 1e-9 { TAU } else { run };
            Shape::Ellipse(Ellipse {
                center: point(&ellipse.center),
                u,
                v,
                from: ellipse.start_parameter,
                sweep,
            })
        }
        EntityType::Spline(spline) => {
            let given = |p: &dxf::Point| Some(point(p)).filter(|p| norm(*p) > 0.0);
            let spline = if spline.control_points.is_empty() {
                let through: Vec<Vector> = spline.fit_points.iter().map(point).collect();
                match spline.is_closed() {
                    true => Spline::through_closed(&through),
                    false => {
                        Spline::through(&through, given(&spline.start_tangent), given(&spline.end_tangent))
                    }
                }
            } else {
                let control = spline.control_points.iter().map(point).collect();
                let degree = usize::try_from(spline.degree_of_curve).unwrap_or(0);
                Spline::new(degree, spline.knot_values.clone(), control, spline.weight_values.clone())
            };
            Shape::Spline(Box::new(spline.ok_or_else(|| alarm(Fault::SplineForm, record.span))?))
        }
        EntityType::LwPolyline(polyline) => {
            let place = Affine::extrusion(vector(&polyline.extrusion_direction));
            let vertices = polyline.vertices.iter().map(|v| ([v.x, v.y, elevation], v.bulge));
            return polygon(vertices, polyline.flags & 1 != 0, &place, |shape| add(Body::Shape(shape)));
        }
        EntityType::Polyline(polyline) => {
            let is_in_space = polyline.flags & 8 != 0;
            let place =
                if is_in_space { Affine::IDENTITY } else { Affine::extrusion(vector(&polyline.normal)) };
            let height = polyline.location.z;
            let vertices = polyline.vertices().filter(|v| !is_frame(v)).map(|v| {
                let p = point(&v.location);
                let bulge = if is_in_space { 0.0 } else { v.bulge };
                (if is_in_space { p } else { [p[0], p[1], height] }, bulge)
            });
            return polygon(vertices, is_closed(polyline), &place, |shape| add(Body::Shape(shape)));
        }
        EntityType::Insert(insert) => return add(Body::Insert(Box::new(placed(insert, record.block)))),
        // The sieve lets no other kind through.
        _ => return Ok(()),
    };
    add(Body::Shape(shape))
}

/// Whether a vertex is of the frame of a fitted curve and not of the curve.
fn is_frame(vertex: &Vertex) -> bool {
    vertex.flags & 16 != 0
}

fn is_closed(polyline: &Polyline) -> bool {
    polyline.flags & 1 != 0
}

/// The circle about `center`, from an angle in degrees on.
fn round(center: Vector, radius: f64, start: f64, sweep: f64) -> Ellipse {
    let (sin, cos) = sin_cos(start);
    let (u, v) = ([radius * cos, radius * sin, 0.0], [-radius * sin, radius * cos, 0.0]);
    Ellipse { center, u, v, from: 0.0, sweep }
}

/// Lines and arcs through vertices with bulges.
fn polygon(
    vertices: impl Iterator<Item = (Vector, f64)>,
    is_closed: bool,
    place: &Affine,
    mut add: impl FnMut(Shape) -> Result<(), Box<Alarm>>,
) -> Result<(), Box<Alarm>> {
    let mut first: Option<Vector> = None;
    let mut last: Option<(Vector, f64)> = None;
    let mut side = |from: Vector, bulge: f64, to: Vector| {
        if from == to {
            return Ok(());
        }
        // A bulge this small is a straight line to a thousandth of its length's millionth.
        add(if bulge.abs() < 1e-9 {
            Shape::Line(place.point(from), place.point(to))
        } else {
            Shape::Ellipse(Ellipse::bulged(from, to, bulge).placed(place))
        })
    };
    for (to, bulge) in vertices {
        if let Some((from, bulge)) = last {
            side(from, bulge, to)?;
        }
        first.get_or_insert(to);
        last = Some((to, bulge));
    }
    match (first, last) {
        (Some(to), Some((from, bulge))) if is_closed => side(from, bulge, to),
        _ => Ok(()),
    }
}

/// The place of an inserted block: scaled, turned, moved, and seen along the extrusion direction. The
/// steps of an array are turned and not scaled.
fn placed(insert: &DxfInsert, block: u32) -> Insert {
    let own = Affine::extrusion(vector(&insert.extrusion_direction));
    let turned = own.after(&Affine::turn(insert.rotation));
    let scale = [insert.x_scale_factor, insert.y_scale_factor, insert.z_scale_factor];
    let scaled = Affine::turn(insert.rotation).after(&Affine::scale(scale));
    let place = own.after(&Affine::shift(point(&insert.location)).after(&scaled));
    let count = |n: i16| u32::try_from(n.max(1)).unwrap_or(1);
    Insert {
        block,
        place,
        count: [count(insert.column_count), count(insert.row_count)],
        step: [
            turned.vector([insert.column_spacing, 0.0, 0.0]),
            turned.vector([0.0, insert.row_spacing, 0.0]),
        ],
    }
}
