//! Computed pockets that are kept between runs (Fagor 4.15.1, 4.16.1).
//!
//! Where they are kept is the business of whoever runs the program: nothing here knows of files, and a program
//! only says what a pocket is called. What is kept is computed again whenever anything that it depends on
//! differs ([`Pocket2d::load`](super::Pocket2d::load)), so that it never changes what is cut.

use super::problem::PocketFault;
pub use super::store::Kind as PocketKind;

/// A place where computed pockets are kept.
pub trait KeptPockets: Send + Sync {
    /// What is kept of a pocket, by its name and kind; none where there is nothing, or it cannot be read.
    fn load(&self, name: &str, kind: PocketKind) -> Option<Vec<u8>>;

    /// Keeps a pocket. One that cannot be kept is computed again the next time.
    fn keep(&self, name: &str, kind: PocketKind, bytes: &[u8]);
}

/// How a plan is made, and made of what was kept.
pub struct Planning<'a, P> {
    /// The plan of these bytes; none where they are not of the very same pocket.
    pub load: &'a dyn Fn(&[u8]) -> Option<P>,
    /// The plan computed.
    pub plan: &'a dyn Fn() -> Result<P, PocketFault>,
    /// What is kept of it.
    pub save: fn(&P) -> Vec<u8>,
}

impl<P> Planning<'_, P> {
    /// The plan that is kept under a name, else the computed one, which is kept from then on.
    pub fn with(
        &self,
        kept: Option<&dyn KeptPockets>,
        name: Option<&str>,
        kind: PocketKind,
    ) -> Result<P, PocketFault> {
        let Some((kept, name)) = kept.zip(name) else { return (self.plan)() };
        if let Some(plan) = kept.load(name, kind).and_then(|bytes| (self.load)(&bytes)) {
            return Ok(plan);
        }
        let plan = (self.plan)()?;
        kept.keep(name, kind, &(self.save)(&plan));
        Ok(plan)
    }
}
