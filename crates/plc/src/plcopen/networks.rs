//! Ladder diagrams to instructions.

use super::diagram::{self, Edge, Element, Id, Input, Kind, Storage};
use super::path::{Part, Paths, Series};
use super::xml::{Document, Node};
use crate::address::{Address, Area};
use crate::fault::{Error, Fault, Span};
use crate::instruction::{Basic, Code, EDGES, FIXED_TIMERS, Instruction, Name, Output, Parameter, Row};
use crate::lexer::Word;
use crate::list::{Ladder, Symbol, function};
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
    /// Signals that were declared, by their name.
    declared: FxHashMap<String, Address>,
    /// Subprograms by the name of their POU.
    subprograms: FxHashMap<String, i64>,
    /// Labels of the POU at hand, by their name.
    labels: FxHashMap<String, i64>,
    next_label: i64,
    next_relay: u32,
    next_edge: i64,
    next_timer: i64,
    /// Outputs of blocks and contacts with an edge, by their element in the POU at hand.
    results: FxHashMap<Id, Address>,
}

/// Reads all POUs of a document.
pub(super) fn ladder(document: &Document, errors: &mut Vec<Error>) -> Ladder {
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
        declared: FxHashMap::default(),
        subprograms: FxHashMap::default(),
        labels: FxHashMap::default(),
        next_label: 1,
        next_relay: 0,
        next_edge: EDGES,
        next_timer: FIXED_TIMERS,
        results: FxHashMap::default(),
    };
    let pous: Vec<Node> = root.descendants().filter(|node| node.name() == "pou").collect();
    if pous.is_empty() {
        import.error(Fault::FileFormat, start, "pou");
    }
    for node in root.descendants().filter(|node| node.name() == "globalVars") {
        import.declare(node);
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

    /// Takes the variables of a list.
    fn declare(&mut self, list: Node) {
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
                None => match self.relay(span) {
                    Some(address) => address,
                    None => return,
                },
            };
            self.declared.insert(name.clone(), address);
            self.symbols.push(Symbol { name, address, meaning: String::new(), span });
        }
    }

    /// A relay that nothing else uses.
    fn relay(&mut self, span: Span) -> Option<Address> {
        let (byte, bit) = (self.next_relay / 8, self.next_relay % 8);
        self.next_relay += 1;
        let byte = u16::try_from(byte).ok().map(|n| RELAYS.0.saturating_add(n)).filter(|n| *n <= RELAYS.1);
        let Some(byte) = byte else {
            self.error(Fault::TooLarge, span, &format!("R{:04}", RELAYS.1));
            return None;
        };
        Some(Address { area: Area::R, byte, bit: u8::try_from(bit).ok() })
    }

    fn signal(&mut self, name: &str, span: Span) -> Option<Address> {
        if name.is_empty() {
            self.errors.push(Error::new(Fault::NoAddress, span));
            return None;
        }
        let parsed = Address::parse(name).ok().or_else(|| located(name));
        let address = self.declared.get(name).copied().or(parsed);
        match address {
            Some(address) if address.bit.is_some() => Some(address),
            _ => {
                self.error(Fault::WrongEntry, span, name);
                None
            }
        }
    }

    fn pou(&mut self, pou: Node) {
        let name = pou.attribute("name").unwrap_or_default();
        if let Some(interface) = pou.child("interface") {
            for list in interface.children() {
                self.declare(list);
            }
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
            let Some(()) = self.conditions(&["ACT"], inputs, span, paths, done, depth) else { return };
            return self.numbered(Name::Call, number, span);
        }
        match upper.as_str() {
            "SR" | "RS" => return self.bistable(element, &upper, inputs, paths, done, depth),
            _ => {}
        }
        let (row, words): (Option<&'static Row>, Vec<String>) = match upper.as_str() {
            "TON" => {
                let number = self.next_timer;
                self.next_timer -= 1;
                let Some(time) = self.operand(inputs, "PT", span, paths).and_then(|text| milliseconds(&text))
                else {
                    return self.error(Fault::WrongFormat, span, "PT");
                };
                (Row::by_text("TMRB"), vec![number.to_string(), time.to_string()])
            }
            "R_TRIG" | "F_TRIG" => {
                let Some(number) = self.edge_number(span) else { return };
                let row = Row::by_text(if upper == "R_TRIG" { "DIFU" } else { "DIFD" });
                (row, vec![number.to_string()])
            }
            _ => {
                let row = Row::by_text(&upper);
                let words = (1..).map_while(|n| self.operand(inputs, &format!("P{n}"), span, paths));
                let words = words.collect::<Vec<_>>();
                (row, words)
            }
        };
        let Some(row) = row else { return self.error(Fault::UnknownFunction, span, name) };
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
        let Some(()) = self.conditions(row.conditions, inputs, span, paths, done, depth) else { return };
        // Parameters may hold several words: the values of a table.
        let parts =
            words.iter().flat_map(|word| word.split([' ', ',', '\t'])).filter(|word| !word.is_empty());
        let words = parts.map(|text| Word { text, span }).collect();
        let Some(instruction) = function(row, span, words, self.errors) else { return };
        self.instructions.push(instruction);
        if row.output != Output::Never {
            let Some(relay) = self.relay(span) else { return };
            self.basic(Basic::Wrt, Some(relay), span);
            self.results.insert(element.id, relay);
        }
    }

    /// Stacks the conditions of a function. One that is not connected is off; of ACT that is a fault.
    fn conditions(
        &mut self,
        names: &[&str],
        inputs: &[Input],
        span: Span,
        paths: &mut Paths,
        done: &mut FxHashSet<Id>,
        depth: usize,
    ) -> Option<()> {
        // What other blocks give must be there before the first of them is stacked.
        let mut ways = Vec::new();
        for name in names {
            let is_it = |input: &&Input| {
                let given = input.name.to_ascii_uppercase();
                given == *name || (*name == "ACT" && matches!(given.as_str(), "EN" | "IN" | "CLK"))
            };
            let Some(input) = inputs.iter().find(is_it) else {
                if *name == "ACT" {
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
        let input = inputs.iter().find(|input| input.name.eq_ignore_ascii_case(name))?;
        let wire = input.wires.first()?;
        let element = paths.element(wire.from)?;
        let Kind::Variable(text) = &element.kind else {
            self.error(Fault::WrongFormat, span, name);
            return None;
        };
        Some(self.declared.get(text).map_or_else(
            || located(text).map_or_else(|| text.clone(), |address| address.to_string()),
            Address::to_string,
        ))
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
