//! Runs that end early.

use super::Run;
use crate::error::Error;

/// A run that ended early: what it computed, and why it ended.
#[derive(Clone)]
pub struct Interrupted<X> {
    inner: Box<(Run<X>, Error)>,
}

impl<X> Interrupted<X> {
    pub(crate) fn new(run: Run<X>, cause: Error) -> Self {
        Interrupted { inner: Box::new((run, cause)) }
    }

    /// Everything up to the failed step; no states at all if the input was refused.
    pub fn run(&self) -> &Run<X> {
        &self.inner.0
    }

    /// The same, by value.
    pub fn into_run(self) -> Run<X> {
        self.inner.0
    }

    /// Why the run ended.
    pub fn cause(&self) -> Error {
        self.inner.1
    }
}

impl<X> core::fmt::Display for Interrupted<X> {
    fn fmt(&self, f: &mut core::fmt::Formatter<'_>) -> core::fmt::Result {
        let recorded = self.run().states().len();
        write!(f, "{}", self.cause())?;
        if recorded > 0 || self.run().steps() > 0 {
            write!(f, " ({} steps done, {recorded} states recorded)", self.run().steps())?;
        }
        Ok(())
    }
}

/// The cause in words and not every recorded state: this is what `unwrap` and a failing `main` print.
impl<X> core::fmt::Debug for Interrupted<X> {
    fn fmt(&self, f: &mut core::fmt::Formatter<'_>) -> core::fmt::Result {
        f.debug_tuple("Interrupted").field(&self.to_string()).finish()
    }
}

impl<X> std::error::Error for Interrupted<X> {}
