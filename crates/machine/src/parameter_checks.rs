//! What two parameters together must not say: each is in its range, and the pair means nothing.
//!
//! Source: GSK990MC appendix 1 (notes at the parameters) and alarms 0168 and 0250.

use crate::parameters::{ParameterKey, Parameters};

/// Two parameters that contradict each other.
#[derive(Clone, PartialEq, Debug)]
pub struct Contradiction {
    /// How.
    pub kind: ContradictionKind,
    /// One.
    pub first: ParameterKey,
    /// The other.
    pub second: ParameterKey,
}

/// How two parameters contradict each other.
#[derive(Clone, Copy, PartialEq, Eq, Debug)]
pub enum ContradictionKind {
    /// The first is a lower limit and above the second.
    LowerAboveUpper,
    /// Both name the same axis.
    SameAxis,
    /// Both bits are set, of which one may be.
    BothBits,
}

/// Lower and upper limits; equal ones are a contradiction where `true`.
const LIMITS: &[(u16, u16, bool)] = &[
    (66, 67, false),
    (68, 69, false),
    (70, 71, false),
    (72, 73, false),
    (74, 75, false),
    (76, 77, false),
    (78, 79, false),
    (80, 81, false),
    (82, 83, false),
    (84, 85, false),
    (95, 94, false),
    (97, 96, false),
    // Alarm 0168: the shortest dwell must be less than the longest.
    (281, 282, true),
];

/// Bits of which one may be set: G18 and G19 at power-on; high-speed mode with what it rules out.
const BITS: &[[(u16, u8); 2]] = &[[(31, 1), (31, 2)], [(0, 7), (15, 0)], [(0, 7), (17, 0)]];

/// The contradictions among the parameters of a control; none where its list is not known.
pub fn contradictions(parameters: &Parameters) -> Vec<Contradiction> {
    if parameters.table().is_empty() || parameters.table().get(&ParameterKey::Data(66)).is_none() {
        return Vec::new();
    }
    let mut found = Vec::new();
    let mut add = |kind, first, second| found.push(Contradiction { kind, first, second });
    let data = ParameterKey::Data;
    for &(lower, upper, strictly) in LIMITS {
        let (a, b) = (parameters.data(lower), parameters.data(upper));
        if a > b || strictly && a == b {
            add(ContradictionKind::LowerAboveUpper, data(lower), data(upper));
        }
    }
    for &[(n, b), (m, c)] in BITS {
        if parameters.bit(n, b) && parameters.bit(m, c) {
            let bit = |number, bit| ParameterKey::Bit { number, bit };
            add(ContradictionKind::BothBits, bit(n, b), bit(m, c));
        }
    }
    // Alarm 0250; the axes that the control carries (P5, at least four).
    let last = if parameters.data(5) >= 5.0 { 179 } else { 178 };
    for first in 175..=last {
        for second in first + 1..=last {
            if parameters.data(first) == parameters.data(second) {
                add(ContradictionKind::SameAxis, data(first), data(second));
            }
        }
    }
    found
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::parameters::ParameterTable;

    fn found(set: &[(&str, f64)]) -> Vec<String> {
        let mut p = Parameters::new(ParameterTable::of("gsk990mc").unwrap());
        for (name, value) in set {
            p.set(&name.parse().unwrap(), *value).unwrap();
        }
        contradictions(&p).iter().map(|c| format!("{:?} {} {}", c.kind, c.first, c.second)).collect()
    }

    #[test]
    fn a_control_as_delivered_contradicts_itself_nowhere() {
        assert_eq!(found(&[]), [] as [&str; 0]);
        assert_eq!(contradictions(&Parameters::new(ParameterTable::empty())), []);
    }

    #[test]
    fn pairs_that_mean_nothing_are_found() {
        assert_eq!(found(&[("P66", 10.0), ("P67", 5.0)]), ["LowerAboveUpper P66 P67"]);
        assert_eq!(found(&[("P281", 1000.0), ("P282", 1000.0)]), ["LowerAboveUpper P281 P282"]);
        assert_eq!(found(&[("NO31.1", 1.0), ("NO31.2", 1.0)]), ["BothBits NO31.1 NO31.2"]);
        assert_eq!(found(&[("P178", 1.0)]), ["SameAxis P176 P178"]);
        // The fifth counts where it is carried.
        assert_eq!(found(&[("P178", 4.0)]), [] as [&str; 0]);
        assert_eq!(found(&[("P178", 4.0), ("P5", 5.0)]), ["SameAxis P178 P179"]);
    }
}
