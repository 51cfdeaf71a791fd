//! The elements of a ladder diagram, as the file has them.

use super::xml::Node;
use crate::fault::{Error, Fault, Span};
use rustc_hash::FxHashMap;

/// Number of an element within its diagram (`localId`).
pub(super) type Id = u64;

/// Where power comes from: an element, and which output of it.
#[derive(Clone, Debug)]
pub(super) struct Wire {
    pub from: Id,
    pub output: String,
}

/// A coil's or contact's kind of edge.
#[derive(Clone, Copy, PartialEq, Eq, Debug)]
pub(super) enum Edge {
    None,
    Rising,
    Falling,
}

/// What a coil does.
#[derive(Clone, Copy, PartialEq, Eq, Debug)]
pub(super) enum Storage {
    Write,
    Set,
    Reset,
}

/// An input of a block.
#[derive(Clone, Debug)]
pub(super) struct Input {
    pub name: String,
    pub negated: bool,
    pub wires: Vec<Wire>,
    pub span: Span,
}

/// What an element is.
#[derive(Clone, Debug)]
pub(super) enum Kind {
    Rail,
    Contact {
        signal: String,
        negated: bool,
        edge: Edge,
    },
    Coil {
        signal: String,
        negated: bool,
        edge: Edge,
        storage: Storage,
    },
    Block {
        name: String,
        inputs: Vec<Input>,
    },
    /// A variable or constant that a block reads.
    Variable(String),
    /// A variable that is written: a coil where power leads to it.
    Output {
        signal: String,
        negated: bool,
    },
    Jump(String),
    Label(String),
    Connector(String),
    Continuation(String),
}

/// An element.
#[derive(Clone, Debug)]
pub(super) struct Element {
    pub id: Id,
    pub kind: Kind,
    /// What leads to it.
    pub wires: Vec<Wire>,
    /// Down, then to the right.
    pub position: (i64, i64),
    pub span: Span,
}

fn text<'a>(node: Node<'a>, name: &str) -> &'a str {
    node.child(name).map_or("", Node::text)
}

fn wires(node: Node) -> Vec<Wire> {
    let points = node.children().filter(|child| child.name() == "connectionPointIn");
    let connections = points.flat_map(|point| point.children());
    connections
        .filter(|child| child.name() == "connection")
        .filter_map(|child| {
            let from = child.attribute("refLocalId")?.parse().ok()?;
            let output = child.attribute("formalParameter").unwrap_or_default().to_owned();
            Some(Wire { from, output })
        })
        .collect()
}

fn is_negated(node: Node) -> bool {
    matches!(node.attribute("negated"), Some("true" | "1"))
}

fn edge(node: Node) -> Edge {
    match node.attribute("edge") {
        Some("rising") => Edge::Rising,
        Some("falling") => Edge::Falling,
        _ => Edge::None,
    }
}

/// Reads the elements of an `LD` body, and their places by their ids.
pub(super) fn read(body: Node, errors: &mut Vec<Error>) -> (Vec<Element>, FxHashMap<Id, usize>) {
    let mut elements = Vec::new();
    let mut places = FxHashMap::default();
    for node in body.children() {
        let span = node.span();
        let name = node.name();
        let kind = match name {
            // Nothing hangs on the right rail but what has been drawn before it.
            "rightPowerRail" | "comment" => continue,
            "leftPowerRail" => Kind::Rail,
            "contact" => Kind::Contact {
                signal: text(node, "variable").to_owned(),
                negated: is_negated(node),
                edge: edge(node),
            },
            "coil" => Kind::Coil {
                signal: text(node, "variable").to_owned(),
                negated: is_negated(node),
                edge: edge(node),
                storage: match node.attribute("storage") {
                    Some("set") => Storage::Set,
                    Some("reset") => Storage::Reset,
                    _ => Storage::Write,
                },
            },
            "block" => block(node, errors),
            "inVariable" | "inOutVariable" => Kind::Variable(text(node, "expression").to_owned()),
            "outVariable" => {
                Kind::Output { signal: text(node, "expression").to_owned(), negated: is_negated(node) }
            }
            "jump" => Kind::Jump(node.attribute("label").unwrap_or_default().to_owned()),
            "label" => Kind::Label(node.attribute("label").unwrap_or_default().to_owned()),
            "connector" => Kind::Connector(node.attribute("name").unwrap_or_default().to_owned()),
            "continuation" => Kind::Continuation(node.attribute("name").unwrap_or_default().to_owned()),
            _ => {
                errors.push(Error::about(Fault::Unsupported, span, name));
                continue;
            }
        };
        let Some(id) = node.attribute("localId").and_then(|id| id.parse::<Id>().ok()) else {
            errors.push(Error::about(Fault::FileFormat, span, "localId"));
            continue;
        };
        if places.insert(id, elements.len()).is_some() {
            errors.push(Error::about(Fault::FileFormat, span, format!("localId {id}")));
        }
        let number = |name| {
            let position = node.child("position").and_then(|p| p.attribute(name));
            position.and_then(|text| text.parse::<f64>().ok()).map_or(0, |value| value as i64)
        };
        let position = (number("y"), number("x"));
        elements.push(Element { id, kind, wires: wires(node), position, span });
    }
    (elements, places)
}

fn block(node: Node, errors: &mut Vec<Error>) -> Kind {
    let variables = |list: &str| {
        let list = node.child(list);
        list.into_iter().flat_map(|list| list.children()).filter(|v| v.name() == "variable")
    };
    let name = |variable: Node| variable.attribute("formalParameter").unwrap_or_default().to_owned();
    // Of what may stand at an input or output only a turned input is known.
    for variable in ["inputVariables", "inOutVariables", "outputVariables"].into_iter().flat_map(variables) {
        let is_set = variable.attribute("storage").is_some_and(|storage| storage != "none");
        let is_output = variable.child("connectionPointOut").is_some();
        if is_set || edge(variable) != Edge::None || is_output && is_negated(variable) {
            errors.push(Error::about(Fault::Unsupported, variable.span(), name(variable)));
        }
    }
    let inputs = variables("inputVariables").chain(variables("inOutVariables"));
    let inputs = inputs
        .map(|variable| Input {
            name: name(variable),
            negated: is_negated(variable),
            wires: wires(variable),
            span: variable.span(),
        })
        .collect();
    Kind::Block { name: node.attribute("typeName").unwrap_or_default().to_owned(), inputs }
}
