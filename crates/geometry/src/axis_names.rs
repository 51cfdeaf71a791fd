//! What the axes of a machine are called, where some have a digit behind their letter.

use crate::position::{AXES, Axis, AxisSet};

/// The name of an axis, such as `x` or `x2`.
#[derive(Clone, Copy, PartialEq, Eq, PartialOrd, Ord, Hash, Debug)]
pub struct AxisName {
    /// Letter in lower case.
    letter: u8,
    /// Digit from 1 to 9; 0 for none.
    digit: u8,
}

impl AxisName {
    /// Letter and digit, `X2`; none where that names no axis.
    pub fn numbered(letter: u8, digit: u8) -> Option<AxisName> {
        let is_axis = Axis::from_letter(letter).is_some() && (b'1'..=b'9').contains(&digit);
        is_axis.then_some(AxisName { letter: letter.to_ascii_lowercase(), digit: digit - b'0' })
    }

    /// The name as it stands in traces, in lower case.
    pub fn bytes(&self) -> impl Iterator<Item = u8> {
        let digit = (self.digit > 0).then_some(b'0' + self.digit);
        std::iter::once(self.letter).chain(digit)
    }
}

/// The names of the axes of a [`Position`](crate::Position).
///
/// An axis with a digit takes the place of a letter that the machine has no axis of.
#[derive(Clone, Copy, PartialEq, Eq, Debug, Default)]
pub struct AxisNames([Option<AxisName>; AXES]);

impl AxisNames {
    /// Places that axes with digits may take: linear ones, the last first.
    const PLACES: [Axis; 3] = [Axis::W, Axis::V, Axis::U];

    /// The name of an axis.
    pub fn name(&self, axis: Axis) -> AxisName {
        let own = AxisName { letter: axis.letter().to_ascii_lowercase() as u8, digit: 0 };
        self.0.get(axis.index()).copied().flatten().unwrap_or(own)
    }

    /// The axis with a digit in its name.
    pub fn find(&self, name: AxisName) -> Option<Axis> {
        Axis::ALL.into_iter().find(|axis| self.0.get(axis.index()).copied().flatten() == Some(name))
    }

    /// Gives an axis with a digit a place that is not `taken`; false where there is none.
    pub fn add(&mut self, name: AxisName, taken: AxisSet) -> bool {
        if self.find(name).is_some() {
            return true;
        }
        let free = |axis: &Axis| !taken.contains(*axis) && !self.renamed().contains(*axis);
        let Some(place) = AxisNames::PLACES.into_iter().find(free) else { return false };
        if let Some(slot) = self.0.get_mut(place.index()) {
            *slot = Some(name);
        }
        true
    }

    /// Axes whose letter is not their name.
    pub fn renamed(&self) -> AxisSet {
        Axis::ALL.into_iter().filter(|a| self.0.get(a.index()).is_some_and(Option::is_some)).collect()
    }
}

#[cfg(test)]
mod tests {
    #![allow(clippy::unwrap_used)]
    use super::*;

    #[test]
    fn numbered_axes_take_free_places() {
        let x2 = AxisName::numbered(b'X', b'2').unwrap();
        let y2 = AxisName::numbered(b'y', b'2').unwrap();
        let mut names = AxisNames::default();
        assert!(names.add(x2, AxisSet::EMPTY.with(Axis::W)));
        assert!(names.add(y2, AxisSet::EMPTY.with(Axis::W)));
        assert!(names.add(x2, AxisSet::EMPTY));
        assert_eq!([names.find(x2), names.find(y2)], [Some(Axis::V), Some(Axis::U)]);
        assert_eq!(names.name(Axis::V).bytes().collect::<Vec<_>>(), b"x2");
        assert_eq!(names.name(Axis::X).bytes().collect::<Vec<_>>(), b"x");
        let z3 = AxisName::numbered(b'Z', b'3').unwrap();
        assert!(!names.add(z3, AxisSet::EMPTY.with(Axis::W)), "no place is left");
        assert_eq!([AxisName::numbered(b'Q', b'1'), AxisName::numbered(b'X', b'0')], [None, None]);
    }
}
