//! Ladder diagrams to instructions.

use super::diagram::{self, Edge, Element, Id, Input, Kind, Storage};
use super::path::{Part, Paths, Series};
use super::xml::{Document, Node};
use crate::address::{Address, Area};
use crate::fault::{Error, Fault, Span};
use crate::instruction::{self, Basic, Code, EDGES, FIXED_TIMERS, Instruction, Name, Output, Parameter, Row};
use crate::lexer::Word;
use crate::list::{Ladder, Symbol, bytes_of, function};
use rustc_hash::{FxHashMap, FxHashSet};

/// First and last byte of the relays of variables without an address, and of results in between.
const RELAYS: (u16, u16) = (5_000, 7_999);
/// Parts of all networks together: more than the steps that a ladder may have.
const MOST_INSTRUCTIONS: usize = 100_000;

/// Blocks that hang behind one another.
const DEEPEST: usize = 64;

/// Always on (R9091.1).
const ON: Address = Address { area: Area::R, byte: 9091, bit: Some(1) };

/// What is made of a document.
struct Import<'e> {
    errors: &'e mut Vec<Error>,
    instructions: Vec<Instruction>,
    symbols: Vec<Symbol>,
    /// Signals that were declared for all POUs, by their name.
    globals: FxHashMap<String, Address>,
    /// Those of the POU at hand.
    locals: FxHashMap<String, Address>,
    /// Subprograms by the name of their POU.
    subprograms: FxHashMap<String, i64>,
    /// Labels of the POU at hand, by their name.
    labels: FxHashMap<String, i64>,
    next_label: i64,
    next_relay: u32,
    /// Bytes of R that the document uses itself.
    used: FxHashSet<u16>,
    next_edge: i64,
    next_timer: i64,
    /// Outputs of blocks and contacts with an edge, by their element in the POU at hand.
    results: FxHashMap<Id, Address>,
}

/// Reads all POUs of a document.
pub(super) fn ladder(document: &Document, errors: &mut Vec<Error>) -> Ladder {
    let mut used = named_relays(document);
    let mut found = Vec::new();
    let ladder = import(document, used.clone(), &mut found);
    // How far the data of a function reach is known once it is read.
    let named = used.len();
    used.extend(data_relays(&ladder));
    if used.len() == named {
        errors.append(&mut found);
        return ladder;
    }
    import(document, used, errors)
}

/// Bytes of R that a document names.
fn named_relays(document: &Document) -> FxHashSet<u16> {
    let mut used = FxHashSet::default();
    for node in document.root().into_iter().flat_map(Node::descendants) {
        let attributes = ["address", "name"].into_iter().filter_map(|name| node.attribute(name));
        for text in attributes.chain([node.text()]).flat_map(|text| text.split([' ', ',', '\t'])) {
            let address = located(text).or_else(|| Address::parse(text).ok());
            used.extend(address.filter(|address| address.area == Area::R).map(|address| address.byte));
        }
    }
    used
}

/// Bytes of R that functions of a ladder work on.
fn data_relays(ladder: &Ladder) -> FxHashSet<u16> {
    let mut used = FxHashSet::default();
    for instruction in &ladder.instructions {
        let Code::Function(row, parameters, _) = &instruction.code else { continue };
        for (kind, parameter) in row.parameters.iter().zip(parameters) {
            let Parameter::At(address) = parameter else { continue };
            if address.area == Area::R && address.byte <= RELAYS.1 {
                let bytes = match kind {
                    instruction::Kind::Read(bytes)
                    | instruction::Kind::Write(bytes)
                    | instruction::Kind::Operand(bytes) => bytes_of(*bytes, row, parameters),
                    _ => 1,
                };
                let last = u32::from(address.byte).saturating_add(bytes).min(u32::from(RELAYS.1) + 1);
                used.extend((u32::from(address.byte)..last).filter_map(|byte| u16::try_from(byte).ok()));
            }
        }
    }
    used
}

fn import(document: &Document, used: FxHashSet<u16>, errors: &mut Vec<Error>) -> Ladder {
    let Some(root) = document.root() else { return Ladder::default() };
    let start = root.span();
    if root.name() != "project" {
        errors.push(Error::about(Fault::FileFormat, start, root.name()));
        return Ladder::default();
    }
    let mut import = Import {
        errors,
        instructions: Vec::new(),
        symbols: Vec::new(),
        globals: FxHashMap::default(),
        locals: FxHashMap::default(),
        subprograms: FxHashMap::default(),
        labels: FxHashMap::default(),
        next_label: 1,
        next_relay: 0,
        used,
        next_edge: EDGES,
        next_timer: FIXED_TIMERS,
        results: FxHashMap::default(),
    };
    let pous: Vec<Node> = root.descendants().filter(|node| node.name() == "pou").collect();
    if pous.is_empty() {
        import.error(Fault::FileFormat, start, "pou");
    }
    for node in root.descendants().filter(|node| node.name() == "globalVars") {
        import.declare(node, None);
    }
    let name = |pou: Node| pou.attribute("name").unwrap_or_default().to_owned();
    let (programs, others): (Vec<Node>, Vec<Node>) =
        pous.iter().copied().partition(|pou| pou.attribute("pouType") == Some("program"));
    for pou in others.iter().copied() {
        match subprogram_number(&name(pou)) {
            Some(number) => {
                import.subprograms.insert(name(pou).to_ascii_uppercase(), number);
            }
            None => import.error(Fault::CallWrong, pou.span(), &name(pou)),
        }
    }
    let (first, second): (Vec<Node>, Vec<Node>) =
        programs.into_iter().partition(|pou| name(*pou).eq_ignore_ascii_case("LEVEL1"));
    for pou in first {
        import.pou(pou);
    }
    import.bare(Name::End1, start);
    for pou in second {
        import.pou(pou);
    }
    import.bare(Name::End2, start);
    for pou in others {
        let Some(number) = subprogram_number(&name(pou)) else { continue };
        let span = pou.span();
        import.numbered(Name::Sp, number, span);
        import.pou(pou);
        import.bare(Name::Spe, span);
    }
    import.bare(Name::End, start);
    Ladder { symbols: import.symbols, instructions: import.instructions, end: start }
}

/// `P1`, `SP1`, `P001`.
fn subprogram_number(name: &str) -> Option<i64> {
    let upper = name.to_ascii_uppercase();
    let digits = upper.strip_prefix("SP").or_else(|| upper.strip_prefix('P'))?;
    digits.parse().ok().filter(|number| (1..=crate::instruction::LABELS).contains(number))
}

/// `%IX8.4`, `%QX0.0`, `%MX10.3`, `%MB10`; which area stands for M is ours to choose.
fn located(text: &str) -> Option<Address> {
    let rest = text.strip_prefix('%')?;
    let (area, rest) = rest.split_at_checked(1)?;
    let area = match area {
        "I" => "X",
        "Q" => "Y",
        "M" => "R",
        _ => return None,
    };
    // A bit may stand without its X.
    let rest = rest.strip_prefix(['X', 'B']).unwrap_or(rest);
    Address::parse(&format!("{area}{rest}")).ok()
}

impl Import<'_> {
    fn error(&mut self, fault: Fault, span: Span, about: &str) {
        self.errors.push(Error::about(fault, span, about));
    }

    fn push(&mut self, code: Code, span: Span) {
        self.instructions.push(Instruction { code, span });
    }

    fn basic(&mut self, basic: Basic, address: Option<Address>, span: Span) {
        self.push(Code::Basic(basic, address), span);
    }

    fn bare(&mut self, name: Name, span: Span) {
        if let Some(row) = crate::instruction::FUNCTIONS.iter().find(|row| row.name == name) {
            self.push(Code::Function(row, Vec::new(), Vec::new()), span);
        }
    }

    fn numbered(&mut self, name: Name, number: i64, span: Span) {
        if let Some(row) = crate::instruction::FUNCTIONS.iter().find(|row| row.name == name) {
            self.push(Code::Function(row, vec![Parameter::Number(number)], Vec::new()), span);
        }
    }

    /// Takes the variables of a list: of a POU, else of all.
    fn declare(&mut self, list: Node, pou: Option<&str>) {
        for variable in list.children().filter(|child| child.name() == "variable") {
            let span = variable.span();
            let name = variable.attribute("name").unwrap_or_default().to_owned();
            let address = match variable.attribute("address") {
                Some(text) => match located(text).or_else(|| Address::parse(text).ok()) {
                    Some(address) => address,
                    None => {
                        self.error(Fault::WrongEntry, span, text);
                        continue;
                    }
                },
                // One that is written as an address is that address.
                None if Address::parse(&name).is_ok() => continue,
                // Declared elsewhere.
                None if list.name() == "externalVars" => {
                    if !self.globals.contains_key(&name) {
                        self.error(Fault::WrongEntry, span, &name);
                    }
                    continue;
                }
                None => match self.relay(span) {
                    Some(address) => address,
                    None => return,
                },
            };
            let scope = if pou.is_some() { &mut self.locals } else { &mut self.globals };
            scope.insert(name.clone(), address);
            // Two POUs may each have one of this name.
            let is_other = |symbol: &Symbol| symbol.name == name && symbol.address != address;
            let name = match pou {
                Some(pou) if self.symbols.iter().any(is_other) => format!("{pou}.{name}"),
                _ => name,
            };
            self.symbols.push(Symbol { name, address, meaning: String::new(), span });
        }
    }

    fn declared(&self, name: &str) -> Option<Address> {
        self.locals.get(name).or_else(|| self.globals.get(name)).copied()
    }

    /// A relay that nothing else uses.
    fn relay(&mut self, span: Span) -> Option<Address> {
        let byte_of = |relay: u32| u16::try_from(relay / 8).ok().map(|n| RELAYS.0.saturating_add(n));
        while byte_of(self.next_relay).is_some_and(|byte| self.used.contains(&byte)) {
            self.next_relay = (self.next_relay / 8 + 1) * 8;
        }
        let (byte, bit) = (byte_of(self.next_relay), self.next_relay % 8);
        self.next_relay += 1;
        let byte = byte.filter(|n| *n <= RELAYS.1);
        let Some(byte) = byte else {
            self.error(Fault::TooLarge, span, &format!("R{:04}", RELAYS.1));
            return None;
        };
        Some(Address { area: Area::R, byte, bit: u8::try_from(bit).ok() })
    }

    /// The bit of a name or address.
    fn bit(&self, name: &str) -> Option<Address> {
        let parsed = || Address::parse(name).ok().or_else(|| located(name));
        self.declared(name).or_else(parsed).filter(|address| address.bit.is_some())
    }

    fn signal(&mut self, name: &str, span: Span) -> Option<Address> {
        if name.is_empty() {
            self.errors.push(Error::new(Fault::NoAddress, span));
            return None;
        }
        let bit = self.bit(name);
        if bit.is_none() {
            self.error(Fault::WrongEntry, span, name);
        }
        bit
    }

    fn pou(&mut self, pou: Node) {
        let name = pou.attribute("name").unwrap_or_default();
        self.locals.clear();
        // Global ones were taken before.
        let lists = pou.child("interface").into_iter().flat_map(Node::children);
        for list in lists.filter(|list| list.name() != "globalVars") {
            self.declare(list, Some(name));
        }
        let Some(body) = pou.child("body") else {
            return self.error(Fault::Incomplete, pou.span(), name);
        };
        let Some(diagram) = body.children().next() else {
            return self.error(Fault::Incomplete, body.span(), name);
        };
        if diagram.name() != "LD" {
            // Written in another language: ST, FBD, SFC, IL.
            return self.error(Fault::Unsupported, diagram.span(), diagram.name());
        }
        let (elements, places) = diagram::read(diagram, self.errors);
        self.labels.clear();
        self.results.clear();
        for element in &elements {
            if let Kind::Label(name) = &element.kind {
                self.labels.insert(name.clone(), self.next_label);
                self.next_label += 1;
            }
        }
        // A contact that leads nowhere is a line that was forgotten.
        let led = |element: &Element| {
            let inputs = if let Kind::Block { inputs, .. } = &element.kind { inputs.as_slice() } else { &[] };
            let wires = element.wires.iter().chain(inputs.iter().flat_map(|input| &input.wires));
            wires.map(|wire| wire.from).collect::<Vec<Id>>()
        };
        let led: FxHashSet<Id> = elements.iter().flat_map(led).collect();
        for element in elements.iter().filter(|element| !led.contains(&element.id)) {
            if let Kind::Contact { signal, .. } = &element.kind {
                self.error(Fault::Incomplete, element.span, signal);
            }
        }
        let mut paths = Paths::new(&elements, &places);
        let mut order: Vec<&Element> = elements.iter().collect();
        order.sort_by_key(|element| element.position);
        // A result is read only where it was made before: below, or to the right.
        let mut done = FxHashSet::default();
        for element in order {
            self.element(element, &mut paths, &mut done, 0);
            if self.instructions.len() > MOST_INSTRUCTIONS {
                return self.error(Fault::TooLarge, element.span, name);
            }
        }
    }

    /// Carries an element over; what a block's inputs need of other blocks comes before it.
    fn element(&mut self, element: &Element, paths: &mut Paths, done: &mut FxHashSet<Id>, depth: usize) {
        let span = element.span;
        if depth > DEEPEST {
            return self.error(Fault::Unsupported, span, &DEEPEST.to_string());
        }
        if !done.insert(element.id) {
            return;
        }
        match &element.kind {
            Kind::Coil { signal, negated, edge, storage } => {
                let Some(target) = self.signal(signal, span) else { return };
                let Some(series) = self.series(&element.wires, span, paths, done, depth) else { return };
                self.network(&series, false, paths);
                if *edge != Edge::None {
                    // The coil is on for one scan.
                    let Some(number) = self.edge_number(span) else { return };
                    self.numbered(edge_name(*edge), number, span);
                }
                let basic = match (storage, negated) {
                    (Storage::Write, false) => Basic::Wrt,
                    (Storage::Write, true) => Basic::WrtNot,
                    (Storage::Set, _) => Basic::Set,
                    (Storage::Reset, _) => Basic::Rst,
                };
                self.basic(basic, Some(target), span);
            }
            Kind::Jump(label) => {
                let Some(number) = self.labels.get(label).copied() else {
                    return self.error(Fault::JumpWrong, span, label);
                };
                let Some(series) = self.series(&element.wires, span, paths, done, depth) else { return };
                self.network(&series, false, paths);
                self.numbered(Name::Jmpb, number, span);
            }
            Kind::Label(label) => {
                if let Some(number) = self.labels.get(label).copied() {
                    self.numbered(Name::Lbl, number, span);
                }
            }
            Kind::Block { name, inputs } => self.block(element, name, inputs, paths, done, depth),
            Kind::Output { signal, negated } => {
                let Some(series) = self.series(&element.wires, span, paths, done, depth) else { return };
                let Some(target) = self.bit(signal) else {
                    // Data of a block are written by its parameters.
                    return self.error(Fault::Unsupported, span, signal);
                };
                self.network(&series, false, paths);
                self.basic(if *negated { Basic::WrtNot } else { Basic::Wrt }, Some(target), span);
            }
            Kind::Variable(name) if !element.wires.is_empty() => {
                self.error(Fault::Unsupported, span, name);
            }
            Kind::Rail
            | Kind::Contact { .. }
            | Kind::Variable(_)
            | Kind::Connector(_)
            | Kind::Continuation(_) => {}
        }
    }

    fn edge_number(&mut self, span: Span) -> Option<i64> {
        let number = self.next_edge;
        self.next_edge -= 1;
        if number < 1 {
            self.error(Fault::EdgeTwice, span, &EDGES.to_string());
            return None;
        }
        Some(number)
    }

    /// What leads along wires, with the blocks and edges on the way carried over first.
    fn series(
        &mut self,
        wires: &[diagram::Wire],
        span: Span,
        paths: &mut Paths,
        done: &mut FxHashSet<Id>,
        depth: usize,
    ) -> Option<Series> {
        let series = match paths.along(wires, span) {
            Ok(series) => series,
            Err(error) => {
                self.errors.push(error);
                return None;
            }
        };
        self.prepare(&series, paths, done, depth).then_some(series)
    }

    fn prepare(
        &mut self,
        series: &Series,
        paths: &mut Paths,
        done: &mut FxHashSet<Id>,
        depth: usize,
    ) -> bool {
        series.iter().all(|part| match part {
            Part::Parallel(ways, _) => ways.iter().all(|way| self.prepare(way, paths, done, depth)),
            Part::Block(id) => {
                let Some(block) = paths.element(*id) else { return false };
                let faults = self.errors.len();
                self.element(block, paths, done, depth + 1);
                let has_result = self.results.contains_key(id);
                if !has_result && self.errors.len() == faults {
                    // It has no output, or needs its own.
                    self.errors.push(Error::new(Fault::Unsupported, block.span));
                }
                has_result
            }
            Part::Contact(id) => self.contact(*id, paths),
        })
    }

    /// Finds the signal of a contact; one with an edge gets a relay that has it.
    fn contact(&mut self, id: Id, paths: &Paths) -> bool {
        if self.results.contains_key(&id) {
            return true;
        }
        let Some(element) = paths.element(id) else { return false };
        let Kind::Contact { signal, edge, .. } = &element.kind else { return false };
        let Some(mut address) = self.signal(signal, element.span) else { return false };
        if *edge != Edge::None {
            let (Some(number), Some(relay)) = (self.edge_number(element.span), self.relay(element.span))
            else {
                return false;
            };
            self.basic(Basic::Rd, Some(address), element.span);
            self.numbered(edge_name(*edge), number, element.span);
            self.basic(Basic::Wrt, Some(relay), element.span);
            address = relay;
        }
        self.results.insert(id, address);
        true
    }

    /// Writes a series as the beginning of a network, or as a further condition on the stack.
    fn network(&mut self, series: &Series, is_stacked: bool, paths: &Paths) {
        let mut is_first = true;
        for part in series.iter() {
            match part {
                Part::Parallel(ways, _) => {
                    for (n, way) in ways.iter().enumerate() {
                        match (n, way.as_slice()) {
                            (0, _) => self.network(way, is_stacked || !is_first, paths),
                            (_, [Part::Contact(_) | Part::Block(_)]) => {
                                way.iter().for_each(|part| self.part(part, Basic::Or, Basic::OrNot, paths));
                            }
                            _ => {
                                self.network(way, true, paths);
                                self.basic(Basic::OrStk, None, self.last_span());
                            }
                        }
                    }
                    if !is_first {
                        self.basic(Basic::AndStk, None, self.last_span());
                    }
                }
                part if !is_first => self.part(part, Basic::And, Basic::AndNot, paths),
                part if is_stacked => self.part(part, Basic::RdStk, Basic::RdNotStk, paths),
                part => self.part(part, Basic::Rd, Basic::RdNot, paths),
            }
            is_first = false;
        }
        if is_first {
            // Straight from the rail.
            self.basic(if is_stacked { Basic::RdStk } else { Basic::Rd }, Some(ON), self.last_span());
        }
    }

    fn last_span(&self) -> Span {
        self.instructions.last().map_or_else(Span::default, |instruction| instruction.span)
    }

    fn part(&mut self, part: &Part, plain: Basic, not: Basic, paths: &Paths) {
        let (Part::Contact(id) | Part::Block(id)) = part else { return };
        let Some(element) = paths.element(*id) else { return };
        let address = self.results.get(id).copied();
        let is_not = matches!(&element.kind, Kind::Contact { negated: true, .. });
        self.basic(if is_not { not } else { plain }, address, element.span);
    }

    fn block(
        &mut self,
        element: &Element,
        name: &str,
        inputs: &[Input],
        paths: &mut Paths,
        done: &mut FxHashSet<Id>,
        depth: usize,
    ) {
        let span = element.span;
        let upper = name.to_ascii_uppercase();
        if let Some(number) = self.subprograms.get(&upper).copied() {
            self.known(inputs, &["ACT"], 0);
            let Some(()) = self.conditions(&["ACT"], inputs, span, paths, done, depth) else { return };
            return self.numbered(Name::Call, number, span);
        }
        match upper.as_str() {
            "SR" | "RS" => return self.bistable(element, &upper, inputs, paths, done, depth),
            "TON" | "TOF" | "TP" => return self.timer(element, &upper, inputs, paths, done, depth),
            "R_TRIG" | "F_TRIG" => {
                self.known(inputs, &["CLK"], 0);
                let Some(number) = self.edge_number(span) else { return };
                let Some(()) = self.conditions(&["CLK"], inputs, span, paths, done, depth) else { return };
                self.numbered(if upper == "R_TRIG" { Name::Difu } else { Name::Difd }, number, span);
                return self.result(element);
            }
            _ => {}
        }
        let Some(row) = Row::by_text(&upper) else { return self.error(Fault::UnknownFunction, span, name) };
        let is_structure = matches!(
            row.name,
            Name::End1
                | Name::End2
                | Name::End
                | Name::Sp
                | Name::Spe
                | Name::Lbl
                | Name::Jmpb
                | Name::Jmpc
                | Name::Call
                | Name::Callu
        );
        if is_structure {
            return self.error(Fault::Unsupported, span, name);
        }
        let parameters = (1..).take_while(|n| input_of(inputs, &format!("P{n}")).is_some()).count();
        self.known(inputs, row.conditions, parameters);
        let words = (1..=parameters).map_while(|n| self.operand(inputs, &format!("P{n}"), span, paths));
        let words = words.collect::<Vec<_>>();
        let Some(()) = self.conditions(row.conditions, inputs, span, paths, done, depth) else { return };
        // Parameters may hold several words: the values of a table.
        let parts =
            words.iter().flat_map(|word| word.split([' ', ',', '\t'])).filter(|word| !word.is_empty());
        let words = parts.map(|text| Word { text, span }).collect();
        let Some(instruction) = function(row, span, words, self.errors) else { return };
        self.instructions.push(instruction);
        if row.output != Output::Never {
            self.result(element);
        }
    }

    /// Puts what is on the line into a relay, for whatever is connected to a block.
    fn result(&mut self, element: &Element) {
        let Some(relay) = self.relay(element.span) else { return };
        self.basic(Basic::Wrt, Some(relay), element.span);
        self.results.insert(element.id, relay);
    }

    /// Refuses inputs that a block does not have: conditions, so many parameters, and EN is all that it has.
    fn known(&mut self, inputs: &[Input], names: &[&str], parameters: usize) {
        for input in inputs {
            let given = input.name.to_ascii_uppercase();
            let number = given.strip_prefix('P').and_then(|digits| digits.parse::<usize>().ok());
            let is_parameter = number.is_some_and(|n| (1..=parameters).contains(&n));
            if given != "EN" && !is_parameter && !names.contains(&given.as_str()) {
                self.error(Fault::Unsupported, input.span, &input.name);
            }
        }
    }

    /// EN beside the condition of a block: without it the block is not carried out, which a list has not. So it must
    /// be always on.
    fn enabled(&mut self, inputs: &[Input], paths: &mut Paths) -> Option<()> {
        let Some(input) = input_of(inputs, "EN").filter(|input| !input.wires.is_empty() || input.negated)
        else {
            return Some(());
        };
        match paths.along(&input.wires, input.span) {
            Ok(series) if series.is_empty() && !input.negated => return Some(()),
            Ok(_) => self.error(Fault::Unsupported, input.span, &input.name),
            Err(error) => self.errors.push(error),
        }
        None
    }

    /// TON, TOF and TP. Off and pulse have relays that say whether they are on.
    fn timer(
        &mut self,
        element: &Element,
        name: &str,
        inputs: &[Input],
        paths: &mut Paths,
        done: &mut FxHashSet<Id>,
        depth: usize,
    ) {
        let span = element.span;
        self.known(inputs, &["IN", "PT"], 0);
        let Some(time) = self.operand(inputs, "PT", span, paths).and_then(|text| milliseconds(&text)) else {
            return self.error(Fault::WrongFormat, span, "PT");
        };
        let number = self.next_timer;
        self.next_timer -= 1;
        let Some(()) = self.conditions(&["IN"], inputs, span, paths, done, depth) else { return };
        let text = [number.to_string(), time.to_string()];
        let words = text.iter().map(|text| Word { text, span }).collect();
        let Some(timer) = Row::by_text("TMRB").and_then(|row| function(row, span, words, self.errors)) else {
            return;
        };
        if name == "TON" {
            self.instructions.push(timer);
            return self.result(element);
        }
        let (Some(over), Some(on)) = (self.relay(span), self.relay(span)) else { return };
        if name == "TOF" {
            let Some(off) = self.relay(span) else { return };
            self.basic(Basic::WrtNot, Some(off), span);
            self.basic(Basic::Rd, Some(off), span);
            self.instructions.push(timer);
            self.basic(Basic::Wrt, Some(over), span);
            // Off until IN is on for the first time.
            self.basic(Basic::RdNot, Some(off), span);
            self.basic(Basic::Or, Some(on), span);
            self.basic(Basic::AndNot, Some(over), span);
            self.basic(Basic::Wrt, Some(on), span);
        } else {
            let Some(edge) = self.edge_number(span) else { return };
            self.numbered(Name::Difu, edge, span);
            self.basic(Basic::Set, Some(on), span);
            // The next pulse begins anew where it follows at once.
            self.basic(Basic::Rd, Some(on), span);
            self.basic(Basic::AndNot, Some(over), span);
            self.instructions.push(timer);
            self.basic(Basic::Wrt, Some(over), span);
            self.basic(Basic::Rst, Some(on), span);
        }
        self.results.insert(element.id, on);
    }

    /// Stacks the conditions of a function. One that is not connected is off; of ACT, IN and CLK that is a fault.
    /// EN is ACT where that is not given.
    fn conditions(
        &mut self,
        names: &[&str],
        inputs: &[Input],
        span: Span,
        paths: &mut Paths,
        done: &mut FxHashSet<Id>,
        depth: usize,
    ) -> Option<()> {
        let is_act = names.contains(&"ACT") && input_of(inputs, "ACT").is_none();
        if !is_act {
            self.enabled(inputs, paths)?;
        }
        // What other blocks give must be there before the first of them is stacked.
        let mut ways = Vec::new();
        for name in names {
            let given = if *name == "ACT" && is_act { "EN" } else { name };
            let Some(input) = input_of(inputs, given) else {
                if matches!(*name, "ACT" | "IN" | "CLK") {
                    self.error(Fault::NotConnected, span, name);
                    return None;
                }
                ways.push(None);
                continue;
            };
            let series = self.series(&input.wires, input.span, paths, done, depth)?;
            if input.negated {
                let relay = self.relay(input.span)?;
                self.network(&series, false, paths);
                self.basic(Basic::WrtNot, Some(relay), input.span);
                ways.push(Some((None, Some(relay), input.span)));
            } else {
                ways.push(Some((Some(series), None, input.span)));
            }
        }
        for (n, way) in ways.into_iter().enumerate() {
            let read = if n > 0 { Basic::RdStk } else { Basic::Rd };
            let read_not = if n > 0 { Basic::RdNotStk } else { Basic::RdNot };
            match way {
                Some((Some(series), _, _)) => self.network(&series, n > 0, paths),
                Some((None, relay, span)) => self.basic(read, relay, span),
                None => self.basic(read_not, Some(ON), span),
            }
        }
        Some(())
    }

    /// The text of the variable at an input, or at an output of that name.
    fn operand(&mut self, inputs: &[Input], name: &str, span: Span, paths: &Paths) -> Option<String> {
        let input = input_of(inputs, name)?;
        let wire = input.wires.first()?;
        if input.negated || input.wires.len() > 1 {
            self.error(Fault::Unsupported, input.span, name);
            return None;
        }
        let element = paths.element(wire.from)?;
        let Kind::Variable(text) = &element.kind else {
            self.error(Fault::WrongFormat, span, name);
            return None;
        };
        let address = self.declared(text).or_else(|| located(text));
        Some(address.map_or_else(|| text.clone(), |address| address.to_string()))
    }

    /// SR and RS: a relay that is set and reset; the input with the 1 wins, so it comes last.
    fn bistable(
        &mut self,
        element: &Element,
        name: &str,
        inputs: &[Input],
        paths: &mut Paths,
        done: &mut FxHashSet<Id>,
        depth: usize,
    ) {
        let span = element.span;
        let order: [(&[&str], Basic); 2] = match name {
            "SR" => [(&["R", "RESET"], Basic::Rst), (&["S1", "SET1"], Basic::Set)],
            _ => [(&["S", "SET"], Basic::Set), (&["R1", "RESET1"], Basic::Rst)],
        };
        let names = order.map(|(names, _)| names).concat();
        self.known(inputs, &names, 0);
        let Some(()) = self.enabled(inputs, paths) else { return };
        let Some(relay) = self.relay(span) else { return };
        for (names, basic) in order {
            let is_it = |input: &&Input| names.iter().any(|name| input.name.eq_ignore_ascii_case(name));
            let Some(input) = inputs.iter().find(is_it) else {
                return self.error(Fault::NotConnected, span, names.first().copied().unwrap_or_default());
            };
            let Some(series) = self.series(&input.wires, input.span, paths, done, depth) else { return };
            self.network(&series, false, paths);
            if input.negated {
                let Some(turned) = self.relay(input.span) else { return };
                self.basic(Basic::WrtNot, Some(turned), input.span);
                self.basic(Basic::Rd, Some(turned), input.span);
            }
            self.basic(basic, Some(relay), span);
        }
        self.results.insert(element.id, relay);
    }
}

/// Whether a block is one of IEC 61131-3, and no function of the list.
pub(super) fn is_of_iec(block: &str) -> bool {
    ["TON", "TOF", "TP", "R_TRIG", "F_TRIG", "SR", "RS"].iter().any(|name| block.eq_ignore_ascii_case(name))
}

/// The input of a name.
fn input_of<'a>(inputs: &'a [Input], name: &str) -> Option<&'a Input> {
    inputs.iter().find(|input| input.name.eq_ignore_ascii_case(name))
}

fn edge_name(edge: Edge) -> Name {
    if edge == Edge::Falling { Name::Difd } else { Name::Difu }
}

/// `T#1m2s500ms`, `TIME#0.5s`, or a number of milliseconds.
fn milliseconds(text: &str) -> Option<u64> {
    let upper = text.to_ascii_uppercase().replace('_', "");
    let Some(mut rest) = upper.strip_prefix("T#").or_else(|| upper.strip_prefix("TIME#")) else {
        return upper.parse().ok();
    };
    let mut total = 0.0;
    if rest.is_empty() {
        return None;
    }
    while !rest.is_empty() {
        let digits = rest.find(|c: char| !c.is_ascii_digit() && c != '.')?;
        let value: f64 = rest.get(..digits)?.parse().ok()?;
        rest = rest.get(digits..)?;
        let letters = rest.find(|c: char| c.is_ascii_digit()).unwrap_or(rest.len());
        let unit = match rest.get(..letters)? {
            "MS" => 1.0,
            "S" => 1e3,
            "M" => 60e3,
            "H" => 3600e3,
            "D" => 86_400e3,
            _ => return None,
        };
        total += value * unit;
        rest = rest.get(letters..)?;
    }
    Some(total.round() as u64)
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn times_and_places_of_iec_are_read() {
        for (text, ms) in [
            ("T#5s", Some(5000)),
            ("t#1m2s500ms", Some(62_500)),
            ("TIME#0.5s", Some(500)),
            ("T#1h", Some(3_600_000)),
            ("250", Some(250)),
            ("T#", None),
            ("T#5", None),
            ("T#5x", None),
            ("five", None),
        ] {
            assert_eq!(milliseconds(text), ms, "{text}");
        }
        for (text, address) in [
            ("%IX8.4", "X0008.4"),
            ("%QX0.7", "Y0000.7"),
            ("%MX10.3", "R0010.3"),
            ("%MB7", "R0007"),
            ("%I1.2", "X0001.2"),
        ] {
            assert_eq!(located(text).unwrap().to_string(), address);
        }
        for text in ["%MW10", "%IX8.9", "IX8.4", "%", "%KX1.1", "%IX999.0"] {
            assert_eq!(located(text), None, "{text}");
        }
        for (name, number) in
            [("P1", Some(1)), ("sp12", Some(12)), ("P001", Some(1)), ("P0", None), ("MAIN", None)]
        {
            assert_eq!(subprogram_number(name), number);
        }
    }
}
