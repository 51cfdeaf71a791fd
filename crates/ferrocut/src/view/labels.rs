//! What a picture says, in a language.

use super::font;
use super::marks::Mark;
use super::scale;
use ferrocut_machine::{Catalogue, Language};

/// The texts of a picture that do not depend on its path, and the catalogue of those that do.
pub struct Labels {
    catalogue: Catalogue,
    /// The view from above.
    pub top: String,
    /// The view in space.
    pub isometric: String,
    /// Where the axes stood first, where they end, and the zero of coordinates.
    start: String,
    end: String,
    zero: String,
    /// Positioning.
    pub rapid: String,
    /// Cuts of one depth, and of several.
    pub cut: String,
    pub depths: String,
    /// Nothing moves; nothing moves X, Y or Z.
    pub nothing: String,
    pub no_axes: String,
    /// What the colours of depth are of.
    pub depth: String,
    /// What coordinates count from.
    pub from_work: String,
    pub from_machine: String,
}

impl Labels {
    /// The texts of a catalogue.
    pub fn of(catalogue: Catalogue) -> Labels {
        let label = |key: &str| catalogue.label(&format!("label-view-{key}"), &[]);
        Labels {
            catalogue,
            top: label("top"),
            isometric: label("isometric"),
            start: label("start"),
            end: label("end"),
            zero: label("zero"),
            rapid: label("rapid"),
            cut: label("cut"),
            depths: label("depths"),
            nothing: label("nothing"),
            no_axes: label("no-axes"),
            depth: label("depth"),
            from_work: label("work"),
            from_machine: label("machine"),
        }
    }

    /// The same for a picture that has the letters of its own font alone: English where that does not have all.
    pub fn drawn(catalogue: Catalogue) -> Labels {
        let labels = Labels::of(catalogue);
        match labels.all().iter().all(|text| font::has(text)) {
            true => labels,
            false => Labels::of(Catalogue::new(Language::En)),
        }
    }

    fn all(&self) -> [&str; 13] {
        [
            &self.top,
            &self.isometric,
            &self.start,
            &self.end,
            &self.zero,
            &self.rapid,
            &self.cut,
            &self.depths,
            &self.nothing,
            &self.no_axes,
            &self.depth,
            &self.from_work,
            &self.from_machine,
        ]
    }

    /// The name of a mark.
    pub fn mark(&self, mark: Mark) -> &str {
        match mark {
            Mark::Start => &self.start,
            Mark::End => &self.end,
            Mark::WorkZero => &self.zero,
        }
    }

    /// So many moves.
    pub fn moves(&self, count: u64) -> String {
        let shown = scale::grouped(count);
        self.catalogue.label("label-view-moves", &[("count", count_of(count)), ("shown", shown.into())])
    }

    /// So many of them position.
    pub fn rapids(&self, count: u64) -> String {
        let shown = scale::grouped(count);
        self.catalogue.label("label-view-rapids", &[("count", count_of(count)), ("shown", shown.into())])
    }

    /// So many of them cut, over a length in mm.
    pub fn cuts(&self, count: u64, length: f64) -> String {
        let (shown, length) = (scale::grouped(count), scale::fixed(length, 1));
        let named = [("shown", shown.into()), ("length", length.into())];
        self.catalogue.label("label-view-cuts", &named)
    }

    /// A length.
    pub fn length(&self, length: &str) -> String {
        self.catalogue.label("label-view-length", &[("length", length.into())])
    }

    /// A length along each axis.
    pub fn along_axes(&self, length: &str) -> String {
        self.catalogue.label("label-view-along", &[("length", length.into())])
    }
}

/// A number by which a language chooses its form.
fn count_of(count: u64) -> ferrocut_machine::Argument {
    (count as f64).into()
}
