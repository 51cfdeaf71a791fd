//! What leads from the rail to an element: contacts in series, and groups of them in parallel.

use super::diagram::{Element, Id, Kind, Wire};
use super::networks::is_of_iec;
use crate::fault::{Error, Fault, Span};
use rustc_hash::{FxHashMap, FxHashSet};
use std::rc::Rc;

/// Contacts in series on one way to the rail.
const LONGEST: usize = 128;
/// Contacts of a network, those of all its ways together.
const MOST: usize = 512;

/// A part of a series.
#[derive(Clone, PartialEq, Eq, Debug)]
pub(super) enum Part {
    /// A contact.
    Contact(Id),
    /// The output of a block.
    Block(Id),
    /// Series of which one must conduct, and how many contacts they are together.
    Parallel(Vec<Series>, usize),
}

impl Part {
    fn contacts(&self) -> usize {
        match self {
            Part::Contact(_) | Part::Block(_) => 1,
            Part::Parallel(_, contacts) => *contacts,
        }
    }
}

/// Contacts of parts, those of all their ways together.
fn contacts(parts: &[Part]) -> usize {
    parts.iter().map(Part::contacts).sum()
}

/// Parts that must all conduct; none is the rail itself.
pub(super) type Series = Rc<Vec<Part>>;

/// Finds the ways in one diagram.
pub(super) struct Paths<'a> {
    pub elements: &'a [Element],
    pub places: &'a FxHashMap<Id, usize>,
    known: FxHashMap<Id, Series>,
    /// The first connector of each name, by its place.
    connectors: FxHashMap<&'a str, usize>,
}

impl<'a> Paths<'a> {
    pub(super) fn new(elements: &'a [Element], places: &'a FxHashMap<Id, usize>) -> Paths<'a> {
        let mut connectors = FxHashMap::default();
        for (place, element) in elements.iter().enumerate() {
            if let Kind::Connector(name) = &element.kind {
                connectors.entry(name.as_str()).or_insert(place);
            }
        }
        Paths { elements, places, known: FxHashMap::default(), connectors }
    }

    pub(super) fn element(&self, id: Id) -> Option<&'a Element> {
        self.elements.get(*self.places.get(&id)?)
    }

    /// What leads along the wires.
    pub(super) fn along(&mut self, wires: &[Wire], span: Span) -> Result<Series, Error> {
        self.merge(wires, span, 0)
    }

    fn merge(&mut self, wires: &[Wire], span: Span, depth: usize) -> Result<Series, Error> {
        if wires.is_empty() {
            return Err(Error::new(Fault::LineOpen, span));
        }
        let mut ways: Vec<Series> = Vec::with_capacity(wires.len());
        for wire in wires {
            self.is_power(wire, span)?;
            let way = self.behind(wire.from, span, depth)?;
            if !ways.contains(&way) {
                ways.push(way);
            }
            if ways.len() > MOST {
                return Err(Error::about(Fault::TooManyRows, span, MOST.to_string()));
            }
        }
        if let [way] = ways.as_slice() {
            return Ok(way.clone());
        }
        // What all ways begin with is not parallel.
        let common = common_length(&ways);
        let mut series: Vec<Part> =
            ways.first().and_then(|way| way.get(..common)).unwrap_or_default().to_vec();
        let rests: Vec<Series> =
            ways.iter().map(|way| Rc::new(way.get(common..).unwrap_or_default().to_vec())).collect();
        if rests.iter().any(|rest| rest.is_empty()) {
            return Err(Error::new(Fault::ParallelLine, span));
        }
        let parallel = rests.iter().map(|rest| contacts(rest)).sum();
        series.push(Part::Parallel(rests, parallel));
        if contacts(&series) > MOST {
            return Err(Error::about(Fault::TooManyRows, span, MOST.to_string()));
        }
        Ok(Rc::new(series))
    }

    /// Of the outputs of a block only W1 is a line; others carry data. ENO of a block of IEC 61131-3 is not its Q.
    fn is_power(&self, wire: &Wire, span: Span) -> Result<(), Error> {
        let Some(Kind::Block { name: block, .. }) = self.element(wire.from).map(|e| &e.kind) else {
            return Ok(());
        };
        match wire.output.to_ascii_uppercase().as_str() {
            "" | "W1" | "Q" | "Q1" => Ok(()),
            "ENO" if !is_of_iec(block) => Ok(()),
            _ => Err(Error::about(Fault::Unsupported, span, wire.output.as_str())),
        }
    }

    /// What leads to the output of an element.
    fn behind(&mut self, id: Id, span: Span, depth: usize) -> Result<Series, Error> {
        if let Some(known) = self.known.get(&id) {
            return Ok(known.clone());
        }
        // A ring of wires is as long as any.
        if depth > LONGEST {
            let about = match self.leads_to_itself(id) {
                true => format!("localId {id}"),
                false => LONGEST.to_string(),
            };
            return Err(Error::about(Fault::Unsupported, span, about));
        }
        let Some(element) = self.element(id) else {
            return Err(Error::about(Fault::LineOpen, span, format!("localId {id}")));
        };
        let found = match &element.kind {
            Kind::Rail => Rc::new(Vec::new()),
            Kind::Block { .. } => Rc::new(vec![Part::Block(id)]),
            // Behind a coil the line goes on as before it.
            Kind::Coil { .. } => self.merge(&element.wires, element.span, depth + 1)?,
            Kind::Contact { .. } => {
                let before = self.merge(&element.wires, element.span, depth + 1)?;
                if before.len() >= LONGEST {
                    return Err(Error::about(Fault::Unsupported, element.span, LONGEST.to_string()));
                }
                let mut series = before.as_ref().clone();
                series.push(Part::Contact(id));
                Rc::new(series)
            }
            Kind::Continuation(name) => {
                let place = self.connectors.get(name.as_str());
                let Some(connector) = place.and_then(|place| self.elements.get(*place)) else {
                    return Err(Error::about(Fault::LineOpen, element.span, name.as_str()));
                };
                self.merge(&connector.wires, connector.span, depth + 1)?
            }
            Kind::Variable(_) | Kind::Output { .. } | Kind::Jump(_) | Kind::Label(_) | Kind::Connector(_) => {
                return Err(Error::new(Fault::Unsupported, element.span));
            }
        };
        self.known.insert(id, found.clone());
        Ok(found)
    }
}

impl Paths<'_> {
    /// Whether one comes back to an element on the lines that lead to it.
    fn leads_to_itself(&self, id: Id) -> bool {
        let (mut seen, mut next) = (FxHashSet::default(), vec![id]);
        while let Some(at) = next.pop() {
            for wire in self.element(at).into_iter().flat_map(|element| &element.wires) {
                if wire.from == id {
                    return true;
                }
                if seen.insert(wire.from) {
                    next.push(wire.from);
                }
            }
        }
        false
    }
}

fn common_length(ways: &[Series]) -> usize {
    let Some((first, others)) = ways.split_first() else { return 0 };
    let same = |n: &usize| others.iter().all(|way| way.get(*n) == first.get(*n));
    (0..first.len()).take_while(same).count()
}
