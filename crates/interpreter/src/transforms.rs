//! G50, G51, G50.1, G51.1, G68 and G69 of a control that keeps transformations as a stack (Weihong 4.3).
//!
//! When the stack changes the tool stands where it stands: its programmed place is reckoned anew.

use crate::Fallible;
use crate::dialect::Meaning;
use crate::interpreter::Interpreter;
use crate::stages::distance;
use crate::stages::nesting::{Nested, Transform};
use crate::stages::rotation::Rotation;
use ferrocut_geometry::{Axis, AxisSet, Position};
use ferrocut_machine::Fault;
use ferrocut_program::Span;

/// Range of a scale factor (Weihong 4.3, G51).
const FACTOR: std::ops::RangeInclusive<f64> = 0.000_001..=99.999_999;

/// Transformations that may be in force together; a loop that only adds ends here.
const MOST: usize = 256;

impl Interpreter {
    /// Carries out a code of scaling, mirror or rotation.
    pub(crate) fn nested_transform(&mut self, meaning: Meaning, span: Span) -> Fallible<()> {
        let linear: AxisSet = [Axis::X, Axis::Y, Axis::Z].into_iter().collect();
        let axes = self.words.axes(self.rules.axes).and(linear);
        match meaning {
            Meaning::ScalingOn => self.nested_scaling(axes, span)?,
            Meaning::ScalingOff => self.transforms.retain(|t| !matches!(t, Transform::Scaling { .. })),
            Meaning::MirrorOn => self.nested_mirror(axes, span)?,
            Meaning::MirrorOff => self.nested_mirror_off(axes),
            Meaning::RotationOn => self.nested_rotation(span)?,
            // G69 takes the latest rotation back, wherever it stands in the stack.
            _ => {
                let latest = self.transforms.iter().rposition(|t| matches!(t, Transform::Rotation(_)));
                if let Some(at) = latest {
                    self.transforms.remove(at);
                }
            }
        }
        if self.transforms.len() > MOST {
            return Err(self.alarm(Fault::TooManyTransforms, span));
        }
        self.location.nested = Nested::of(&self.transforms);
        self.location.take_machine();
        Ok(())
    }

    /// Centre coordinates of the block, those of the present place where it gives none. They are work
    /// coordinates, also with G91.
    fn given_center(&self, axes: AxisSet) -> Position {
        distance::end_point(&self.words, axes, self.location.programmed, false, self.inch_axes())
    }

    /// G51: P for the axes listed, or I, J, K. An axis that has no factor here keeps the one it had.
    fn nested_scaling(&mut self, axes: AxisSet, span: Span) -> Fallible<()> {
        if self.output.in_cutter_mode() {
            return Err(self.alarm(Fault::ScalingInCutter, span));
        }
        let (common, own) = (self.words.get(b'P'), [b'I', b'J', b'K'].map(|letter| self.words.get(letter)));
        if common.is_some() == own.iter().any(Option::is_some) {
            // Neither, or both.
            return Err(self.alarm(Fault::ScaleForm, self.words.block_span()));
        }
        if common.is_some() && axes.is_empty() {
            return Err(self.alarm(Fault::ScaleForm, self.words.block_span()));
        }
        let here = self.given_center(axes);
        let before = self.transforms.iter().position(|t| matches!(t, Transform::Scaling { .. }));
        let (mut factors, mut center) = match before.and_then(|at| self.transforms.get(at)) {
            Some(Transform::Scaling { factors, center }) => (*factors, *center),
            _ => ([1.0; 3], [0.0; 3]),
        };
        let rows = [(Axis::X, b'I'), (Axis::Y, b'J'), (Axis::Z, b'K')].into_iter().zip(own);
        for (((axis, letter), own), (factor, center)) in rows.zip(factors.iter_mut().zip(&mut center)) {
            let is_listed = axes.contains(axis);
            let given = common.filter(|_| is_listed).or(own);
            if let Some(given) = given {
                if !FACTOR.contains(&given) {
                    let at = if common.is_some() { b'P' } else { letter };
                    return Err(self.scale_factor(at, &FACTOR));
                }
                // Where no centre is given: that of the scaling in force, else the present place.
                if is_listed || *factor == 1.0 {
                    *center = here[axis];
                }
                *factor = given;
            } else if is_listed {
                *center = here[axis];
            }
        }
        let scaling = Transform::Scaling { factors, center };
        match before.and_then(|at| self.transforms.get_mut(at)) {
            Some(slot) => *slot = scaling,
            None => self.transforms.push(scaling),
        }
        Ok(())
    }

    /// G51.1: one mirror an axis; given again it moves.
    fn nested_mirror(&mut self, axes: AxisSet, span: Span) -> Fallible<()> {
        if axes.is_empty() {
            return Err(self.alarm(Fault::MirrorForm, span));
        }
        let center = self.given_center(axes);
        for axis in axes.iter() {
            self.drop_mirror(axis);
            self.transforms.push(Transform::Mirror { axis: axis.index(), center: center[axis] });
        }
        Ok(())
    }

    /// G50.1: of the axes named; of all where none is.
    fn nested_mirror_off(&mut self, axes: AxisSet) {
        for axis in [Axis::X, Axis::Y, Axis::Z] {
            if axes.is_empty() || axes.contains(axis) {
                self.drop_mirror(axis);
            }
        }
    }

    fn drop_mirror(&mut self, axis: Axis) {
        let is_it = |t: &Transform| matches!(t, Transform::Mirror { axis: of, .. } if *of == axis.index());
        self.transforms.retain(|t| !is_it(t));
    }

    /// G68 about a point of the plane.
    fn nested_rotation(&mut self, span: Span) -> Fallible<()> {
        let plane = self.modal.plane();
        let axes = self.words.axes(self.rules.axes);
        let degrees = self.words.get(b'R').unwrap_or(self.rules.rotation_angle);
        let limit = self.rules.max_rotation;
        if degrees.abs() > limit {
            let alarm = self.alarm_at(Fault::WordOutOfRange, b'R');
            return Err(Box::new(alarm.with("min", -limit).with("max", limit)));
        }
        self.refuse_rotary_plane(plane, span)?;
        let center = plane.of(self.given_center(axes));
        self.transforms.push(Transform::Rotation(Rotation { plane, center, degrees }));
        Ok(())
    }

    /// Whether a scaling that nests changes lengths along Z, which canned cycles do not allow
    /// (Weihong 4.3, G51).
    pub(crate) fn is_nested_on_z(&self) -> bool {
        let scales = |t: &Transform| matches!(t, Transform::Scaling { factors: [_, _, z], .. } if *z != 1.0);
        self.transforms.iter().any(scales)
    }

    /// G28, G29, G53 and G92 cannot be used while scaling is in force (Weihong 4.3, G51).
    pub(crate) fn refuse_in_nested_scaling(&self, span: Span) -> Fallible<()> {
        match self.transforms.iter().any(|t| matches!(t, Transform::Scaling { .. })) {
            true => Err(self.alarm(Fault::CodeInScaling, span)),
            false => Ok(()),
        }
    }
}
