//! Members that go together.

use core::ops::Range;

use crate::run::{Interrupted, Run, Simulation};
use crate::span::Span;
use crate::state::State;

/// What becomes of a member: its run, or what it had come to when it failed.
pub type Outcome<X> = Result<Run<X>, Interrupted<X>>;

/// Some members in a row.
pub struct Block<'a, L, S, O, const D: usize> {
    pub(super) members: Range<usize>,
    pub(super) member: &'a (dyn Fn(usize) -> Simulation<L, State<D>, S, O> + Sync),
    pub(super) span: Span,
    /// The work of the steps is summed.
    pub(super) work: bool,
    /// How many side by side.
    pub(super) lanes: usize,
}

impl<L, S, O, const D: usize> core::fmt::Debug for Block<'_, L, S, O, D> {
    fn fmt(&self, f: &mut core::fmt::Formatter<'_>) -> core::fmt::Result {
        f.debug_struct("Block").field("members", &self.members).field("lanes", &self.lanes).finish_non_exhaustive()
    }
}
