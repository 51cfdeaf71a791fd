//! A computed pocket as bytes, to be kept beside the program (Fagor 4.15.1, 4.16.1: the .C2D and .C3D files).
//!
//! ```text
//! "FERROPOC"  kind  hash of all inputs (16)  paths …  hash of everything before (16)
//! ```
//!
//! The inputs are every number of the parameters, tools among them, and what computes the paths, since an
//! update of the software computes anew. Bytes with other inputs, or changed by anyone, are not this pocket: loading them
//! gives nothing, and the pocket is computed again. The hash is FNV-1a of 128 bits; it keeps out accidents,
//! not forgers.

use super::chains::{Chain, Entry};
use super::clear::Clearing;
use super::finish::{Finish, Tangent};
use super::profile::Profile;
use super::segment::Segment;
use super::slopes::Pass;
use super::tool::Tool;

const MAGIC: &[u8; 8] = b"FERROPOC";

/// What computes the paths, so that nothing that an older version of it computed is taken for the same.
const SOURCES: &[&[u8]] = &[
    include_bytes!("../../../../geometry/src/vector.rs"),
    include_bytes!("chains.rs"),
    include_bytes!("clear.rs"),
    include_bytes!("contours.rs"),
    include_bytes!("corner.rs"),
    include_bytes!("cut.rs"),
    include_bytes!("depth_profile.rs"),
    include_bytes!("descent.rs"),
    include_bytes!("finish.rs"),
    include_bytes!("index.rs"),
    include_bytes!("kept.rs"),
    include_bytes!("meet.rs"),
    include_bytes!("mod.rs"),
    include_bytes!("passes.rs"),
    include_bytes!("pen.rs"),
    include_bytes!("pocket2d.rs"),
    include_bytes!("pocket3d.rs"),
    include_bytes!("polygons.rs"),
    include_bytes!("problem.rs"),
    include_bytes!("profile.rs"),
    include_bytes!("ring.rs"),
    include_bytes!("rings.rs"),
    include_bytes!("segment.rs"),
    include_bytes!("slopes.rs"),
    include_bytes!("store.rs"),
    include_bytes!("tool.rs"),
    include_bytes!("walls.rs"),
];

/// Their hash, worked out when they are compiled.
#[allow(long_running_const_eval)]
const COMPUTED_BY: u128 = {
    let (mut sources, mut hash) = (SOURCES, BASIS);
    while let [first, rest @ ..] = sources {
        hash = fnv(hash, first);
        sources = rest;
    }
    hash
};

/// Raised when a library beside them gives other paths of the same inputs.
const REVISION: u32 = 1;

/// What kind of pocket is stored.
#[derive(Clone, Copy, PartialEq, Eq, Debug)]
pub enum Kind {
    /// 2D.
    Flat = 2,
    /// 3D.
    Deep = 3,
}

/// Whether bytes begin as a stored pocket does.
pub fn is_stored(bytes: &[u8]) -> bool {
    bytes.starts_with(MAGIC)
}

/// The hash of nothing.
const BASIS: u128 = 0x6c62_272e_07bb_0142_62b8_2175_6295_c58d;

/// A hash carried on over further bytes: FNV-1a, 128 bits.
const fn fnv(mut hash: u128, mut bytes: &[u8]) -> u128 {
    const PRIME: u128 = 0x0000_0000_0100_0000_0000_0000_0000_013b;
    while let [first, rest @ ..] = bytes {
        hash = (hash ^ *first as u128).wrapping_mul(PRIME);
        bytes = rest;
    }
    hash
}

/// The hash of bytes.
pub(crate) fn hash(bytes: &[u8]) -> [u8; 16] {
    fnv(BASIS, bytes).to_le_bytes()
}

/// Numbers one after another.
#[derive(Debug, Default)]
pub(crate) struct Writer {
    bytes: Vec<u8>,
}

impl Writer {
    /// The beginning of the inputs: what computes them.
    pub fn inputs() -> Writer {
        let mut writer = Writer::default();
        writer.bytes.extend_from_slice(env!("CARGO_PKG_VERSION").as_bytes());
        writer.count(REVISION as usize);
        writer.bytes.extend_from_slice(&COMPUTED_BY.to_le_bytes());
        writer
    }

    /// The beginning of a file.
    pub fn file(kind: Kind, inputs: &[u8; 16]) -> Writer {
        let mut writer = Writer::default();
        writer.bytes.extend_from_slice(MAGIC);
        writer.bytes.push(kind as u8);
        writer.bytes.extend_from_slice(inputs);
        writer
    }

    /// The hash of what was written.
    pub fn hash(&self) -> [u8; 16] {
        hash(&self.bytes)
    }

    /// The file with its end.
    pub fn finish(mut self) -> Vec<u8> {
        let end = self.hash();
        self.bytes.extend_from_slice(&end);
        self.bytes
    }

    pub fn number(&mut self, value: f64) {
        self.bytes.extend_from_slice(&value.to_bits().to_le_bytes());
    }

    pub fn numbers<const N: usize>(&mut self, values: [f64; N]) {
        values.into_iter().for_each(|value| self.number(value));
    }

    pub fn count(&mut self, value: usize) {
        self.bytes.extend_from_slice(&(value as u64).to_le_bytes());
    }

    pub fn byte(&mut self, value: u8) {
        self.bytes.push(value);
    }

    pub fn point(&mut self, point: [f64; 2]) {
        self.numbers(point);
    }

    pub fn segments(&mut self, segments: &[Segment]) {
        self.count(segments.len());
        for segment in segments {
            match *segment {
                Segment::Line { from, to } => {
                    self.byte(0);
                    self.point(from);
                    self.point(to);
                }
                Segment::Arc { from, to, center, sweep } => {
                    self.byte(1);
                    self.point(from);
                    self.point(to);
                    self.point(center);
                    self.number(sweep);
                }
            }
        }
    }

    pub fn profiles<'a>(&mut self, profiles: impl ExactSizeIterator<Item = &'a Profile>) {
        self.count(profiles.len());
        profiles.for_each(|p| self.segments(&p.segments));
    }

    pub fn tool(&mut self, tool: &Tool) {
        self.numbers([tool.radius, tool.tip_radius, tool.cutting_length, tool.entry_angle]);
    }

    pub fn clearing(&mut self, clearing: &Clearing) {
        self.number(clearing.nearest);
        self.count(clearing.chains.len());
        for chain in &clearing.chains {
            match &chain.entry {
                Entry::Cut => self.byte(0),
                Entry::Solid { down } => {
                    self.byte(1);
                    self.segments(down);
                }
            }
            self.segments(&chain.path);
        }
    }

    pub fn finishes(&mut self, finishes: &[Finish]) {
        self.count(finishes.len());
        for finish in finishes {
            match &finish.tangent {
                None => self.byte(0),
                Some(tangent) => {
                    self.byte(1);
                    self.point(tangent.center);
                    self.segments(&[tangent.on, tangent.off]);
                }
            }
            self.segments(&finish.path);
        }
    }

    pub fn passes(&mut self, passes: &[Pass]) {
        self.count(passes.len());
        for pass in passes {
            self.point(pass.normal);
            self.count(pass.points.len());
            pass.points.iter().for_each(|point| self.numbers(*point));
        }
    }
}

/// Numbers one after another, each of which may be missing.
#[derive(Debug)]
pub(crate) struct Reader<'a> {
    rest: &'a [u8],
}

impl<'a> Reader<'a> {
    /// The paths in a file of that kind with those inputs; nothing where anything differs.
    pub fn file(bytes: &'a [u8], kind: Kind, inputs: &[u8; 16]) -> Option<Reader<'a>> {
        let (before, end) = bytes.split_at_checked(bytes.len().checked_sub(16)?)?;
        let rest = before.strip_prefix(MAGIC)?.strip_prefix(&[kind as u8])?.strip_prefix(inputs)?;
        (hash(before) == end).then_some(Reader { rest })
    }

    /// Whether nothing is left.
    pub fn is_at_end(&self) -> bool {
        self.rest.is_empty()
    }

    fn take<const N: usize>(&mut self) -> Option<[u8; N]> {
        let (own, rest) = self.rest.split_first_chunk::<N>()?;
        self.rest = rest;
        Some(*own)
    }

    pub fn number(&mut self) -> Option<f64> {
        let value = f64::from_bits(u64::from_le_bytes(self.take()?));
        value.is_finite().then_some(value)
    }

    /// A count of things of at least `size` bytes: more than are left is none.
    pub fn count(&mut self, size: usize) -> Option<usize> {
        let count = usize::try_from(u64::from_le_bytes(self.take()?)).ok()?;
        (count <= self.rest.len() / size.max(1)).then_some(count)
    }

    pub fn byte(&mut self) -> Option<u8> {
        self.take::<1>().map(|[b]| b)
    }

    pub fn point(&mut self) -> Option<[f64; 2]> {
        Some([self.number()?, self.number()?])
    }

    /// A list of things of at least `size` bytes each.
    pub fn list<T>(&mut self, size: usize, one: impl Fn(&mut Self) -> Option<T>) -> Option<Vec<T>> {
        let count = self.count(size)?;
        (0..count).map(|_| one(self)).collect()
    }

    pub fn segments(&mut self) -> Option<Vec<Segment>> {
        self.list(33, |r| match r.byte()? {
            0 => Some(Segment::Line { from: r.point()?, to: r.point()? }),
            1 => Some(Segment::Arc {
                from: r.point()?,
                to: r.point()?,
                center: r.point()?,
                sweep: r.number()?,
            }),
            _ => None,
        })
    }

    pub fn clearing(&mut self) -> Option<Clearing> {
        let nearest = self.number()?;
        let chains = self.list(9, |r| {
            let entry = match r.byte()? {
                0 => Entry::Cut,
                1 => Entry::Solid { down: r.segments()? },
                _ => return None,
            };
            Some(Chain { entry, path: r.segments()? })
        })?;
        Some(Clearing { chains, nearest })
    }

    pub fn finishes(&mut self) -> Option<Vec<Finish>> {
        self.list(9, |r| {
            let tangent = match r.byte()? {
                0 => None,
                1 => {
                    let center = r.point()?;
                    match r.segments()?.as_slice() {
                        [on, off] => Some(Tangent { center, on: *on, off: *off }),
                        _ => return None,
                    }
                }
                _ => return None,
            };
            Some(Finish { tangent, path: r.segments()? })
        })
    }

    pub fn passes(&mut self) -> Option<Vec<Pass>> {
        self.list(24, |r| {
            let normal = r.point()?;
            let points = r.list(24, |r| Some([r.number()?, r.number()?, r.number()?]))?;
            Some(Pass { points, normal })
        })
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    /// A file of this folder that is not in the list would change paths unseen.
    #[test]
    fn every_source_counts() {
        let folder = concat!(env!("CARGO_MANIFEST_DIR"), "/src/cycles/pocket");
        let files = std::fs::read_dir(folder).unwrap().map(|entry| entry.unwrap().path());
        let sources: Vec<_> = files.filter(|path| path.extension().is_some_and(|e| e == "rs")).collect();
        // Vectors are of another crate.
        assert_eq!(sources.len() + 1, SOURCES.len());
        for path in sources {
            assert!(SOURCES.contains(&std::fs::read(&path).unwrap().as_slice()), "{path:?}");
        }
    }

    /// Known values of FNV-1a with 128 bits.
    #[test]
    fn hashes_as_published() {
        assert_eq!(u128::from_le_bytes(hash(b"")), 0x6c62272e07bb014262b821756295c58d);
        assert_eq!(u128::from_le_bytes(hash(b"a")), 0xd228cb696f1a8caf78912b704e4a8964);
    }
}
