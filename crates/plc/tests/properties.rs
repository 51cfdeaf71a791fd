//! Any bytes are a ladder or faults with lines, and what compiles runs.
#![allow(missing_docs, clippy::unwrap_used)]

mod common;

use ferrocut_plc::instruction::{BASICS, FUNCTIONS, Kind};
use ferrocut_plc::{Address, Limits, Pace, Plc, Program};
use proptest::prelude::*;

fn lines(text: &[u8]) -> u32 {
    text.split(|b| *b == b'\n').count() as u32
}

/// Compiles, and holds what is promised of faults.
fn compile(text: &[u8]) -> Option<Program> {
    match Program::from_text(text, &Limits::default()) {
        Ok(program) => Some(program),
        Err(errors) => {
            assert!(!errors.is_empty());
            for error in errors {
                let (from, to) = (error.span.offset, error.span.offset + error.span.len);
                assert!(error.span.line <= lines(text) && to <= text.len() && from <= to, "{error:?}");
                assert!((1001..=1042).contains(&error.fault.number()));
            }
            None
        }
    }
}

fn signal() -> impl Strategy<Value = String> {
    ("[XYFGRKTCDA]", 0u32..140, 0u32..8).prop_map(|(area, byte, bit)| format!("{area}{byte}.{bit}"))
}

fn byte() -> impl Strategy<Value = String> {
    ("[XYFGRKTCDA]", 0u32..9999).prop_map(|(area, byte)| format!("{area}{byte}"))
}

/// A word that may stand anywhere.
fn word() -> impl Strategy<Value = String> {
    prop_oneof![
        signal(),
        byte(),
        (-5i64..300).prop_map(|n| n.to_string()),
        Just("1001".to_owned()),
        Just("=".to_owned()),
        prop::sample::select(BASICS).prop_map(|(name, _)| name.to_owned()),
        prop::sample::select(FUNCTIONS).prop_map(|row| row.text.to_owned()),
        "[A-Z0-9.*;]{1,6}",
    ]
}

/// A network that is right more often than not.
fn network() -> impl Strategy<Value = String> {
    let contact = (prop::sample::select(vec!["AND", "OR", "AND.NOT", "OR.NOT"]), signal());
    let contacts = prop::collection::vec(contact, 0..4)
        .prop_map(|all| all.iter().map(|(what, signal)| format!("{what} {signal}\n")).collect::<String>());
    let output = prop_oneof![
        ("[YGRKD]", 0u32..100, 0u32..8, prop::sample::select(vec!["WRT", "WRT.NOT", "SET", "RST"]))
            .prop_map(|(area, byte, bit, what)| format!("{what} {area}{byte}.{bit}\n")),
        function(),
    ];
    (signal(), contacts, output)
        .prop_map(|(first, contacts, output)| format!("RD {first}\n{contacts}{output}"))
}

/// A function with parameters of its kinds, and conditions stacked before it.
fn function() -> impl Strategy<Value = String> {
    let numbers = prop::collection::vec((any::<u32>(), 0u32..9999), 8);
    (prop::sample::select(FUNCTIONS), numbers, signal()).prop_map(|(row, numbers, coil)| {
        let mut format = 1;
        let mut first = 0;
        let mut text: String = row.conditions.iter().skip(1).map(|_| "RD.STK X0.1\n").collect();
        text += row.text;
        for (n, (kind, (seed, byte))) in row.parameters.iter().zip(&numbers).enumerate() {
            let constant = i64::from(*seed % 100);
            let value = match kind {
                Kind::Number(least, most) | Kind::OptionalNumber(least, most, _) => {
                    (least + i64::from(*seed) % (most - least + 1)).min(400.max(*least)).to_string()
                }
                Kind::Target(..) => (seed % 4 + 1).to_string(),
                Kind::Mask => ["1111", "0000", "1010"][(seed % 3) as usize].to_owned(),
                Kind::Width | Kind::DecodeWidth => {
                    format = [1, 2, 4][(seed % 3) as usize];
                    format.to_string()
                }
                Kind::OperandWidth => {
                    format = [1, 1002, 4, 1001][(seed % 4) as usize];
                    format.to_string()
                }
                Kind::OperandFormat => {
                    format = [0, 1000][(seed % 2) as usize];
                    (format / 1000).to_string()
                }
                Kind::Read(_) => format!("D{byte}"),
                Kind::Write(_) => format!("R{byte}"),
                Kind::Operand(_) if format >= 1000 => format!("D{byte}"),
                Kind::Operand(_) | Kind::Constant | Kind::Bcd => constant.to_string(),
            };
            if n == 0 || (n == 1 && row.text == "CODB") {
                first = value.parse().unwrap_or(0);
            }
            text += " ";
            text += &value;
        }
        if row.text.starts_with("COD") {
            text += &" 7".repeat(first);
        }
        format!("{text}\nWRT {coil}\n")
    })
}

fn ladder() -> impl Strategy<Value = String> {
    let part = |most| prop::collection::vec(network(), 0..most).prop_map(|all| all.concat());
    (part(3), part(8), part(3), any::<bool>()).prop_map(|(first, second, sub, has_labels)| {
        let (label, jump) =
            if has_labels { ("LBL 1\nLBL 2\n", "RD X0.0\nJMPB 1\nRD X0.1\nCALL 1\n") } else { ("", "") };
        format!("{first}END1\n{label}{second}{jump}END2\nSP 1\n{sub}SPE\nSP 2\nSPE\nEND\n")
    })
}

/// Runs with inputs and data that change; no scan may take more than its steps.
fn exercise(program: Program, seed: u64) {
    let pace = Pace { steps: 200, cycle_steps: 5_000, ..Pace::default() };
    let longest = program.steps().max(200);
    let mut plc = Plc::new(program, pace);
    let mut seed = seed | 1;
    for n in 0..60u16 {
        for area in ["X", "F", "D", "C", "T", "K"] {
            seed = seed.wrapping_mul(6_364_136_223_846_793_005).wrapping_add(1_442_695_040_888_963_407);
            let at = Address::parse(&format!("{area}{}", seed >> 40 & 63)).unwrap();
            plc.memory_mut().set_byte(at, (seed >> 33) as u8);
        }
        plc.watch(n % 8 == 0);
        let scanned = plc.scan();
        assert!(scanned.steps <= 400 + 3 * longest + 3 * 2500, "{scanned:?}");
        if scanned.stop.is_some() {
            plc.restart();
        }
    }
}

proptest! {
    #![proptest_config(ProptestConfig { cases: 600, ..ProptestConfig::default() })]

    #[test]
    fn any_bytes_are_a_ladder_or_faults(bytes in prop::collection::vec(any::<u8>(), 0..400)) {
        compile(&bytes);
    }

    #[test]
    fn any_words_are_a_ladder_or_faults(
        lines in prop::collection::vec(prop::collection::vec(word(), 1..6), 0..30),
        seed in any::<u64>(),
    ) {
        let text: String = lines.iter().map(|line| line.join(" ") + "\n").collect();
        compile(text.as_bytes());
        if let Some(program) = compile(format!("END1\n{text}END2\n").as_bytes()) {
            exercise(program, seed);
        }
    }

    #[test]
    fn whatever_compiles_runs(text in ladder(), seed in any::<u64>()) {
        if let Some(program) = compile(text.as_bytes()) {
            exercise(program, seed);
        }
    }

    #[test]
    fn every_network_alone_runs_where_it_compiles(text in network(), seed in any::<u64>()) {
        if let Some(program) = compile(format!("END1\n{text}END2\n").as_bytes()) {
            exercise(program, seed);
        }
    }
}

/// The generator makes ladders that compile, so that the properties above have something to say.
#[test]
fn most_networks_compile() {
    use proptest::strategy::ValueTree;
    use proptest::test_runner::TestRunner;
    let mut runner = TestRunner::deterministic();
    let compiled = (0..1000)
        .filter(|_| {
            let network = network().new_tree(&mut runner).unwrap().current();
            compile(format!("END1\n{network}END2\n").as_bytes()).is_some()
        })
        .count();
    assert!(compiled > 250, "{compiled}");
}
