//! Observers.

use core::ops::ControlFlow;

use super::attend::Attend;
use super::simulation::{Attended, Simulation};
use crate::setup::Setup;

impl<L, X: Setup<L>, S, O> Simulation<L, X, S, O> {
    /// Shows the state after every n-th step to a function, which may stop the run. Nothing is kept of what it sees.
    ///
    /// ```
    /// use core::ops::ControlFlow;
    /// use dmech_core::prelude::*;
    #[doc = include_str!("../examples/spring.md")]
    /// let (mut farthest, mut seen) = (0.0_f64, 0);
    /// let run = Simulation::new(Spring { k: 4.0 }, State::new([1.0], [0.5]))
    ///     .scheme(Leapfrog)
    ///     .dt(0.01)
    ///     .record_every(1000)
    ///     .observe(5, |state| {
    ///         farthest = farthest.max(state.q[0].abs());
    ///         seen += 1;
    ///         if seen < 400 { ControlFlow::Continue(()) } else { ControlFlow::Break(()) }
    ///     })
    ///     .run(1_000_000)?;
    /// assert_eq!((run.steps(), run.stopped()), (2000, true));
    /// assert!((farthest - 1.0625_f64.sqrt()).abs() < 1e-3);
    /// # Ok::<(), Box<dyn std::error::Error>>(())
    /// ```
    ///
    /// With n = 0 it is never called.
    pub fn observe<F: FnMut(&X::State) -> ControlFlow<()>>(
        self,
        n: u64,
        function: F,
    ) -> Attended<L, X, S, O, Observer<F>> {
        self.attended(Observer::new(n, function))
    }
}

/// A function that sees the state after every n-th step.
#[derive(Clone)]
pub struct Observer<F> {
    n: u64,
    function: F,
}

impl<F> Observer<F> {
    pub(crate) fn new(n: u64, function: F) -> Self {
        Observer { n, function }
    }
}

impl<F> core::fmt::Debug for Observer<F> {
    fn fmt(&self, f: &mut core::fmt::Formatter<'_>) -> core::fmt::Result {
        f.debug_struct("Observer").field("n", &self.n).finish_non_exhaustive()
    }
}

impl<X, F: FnMut(&X) -> ControlFlow<()>> Attend<X> for Observer<F> {
    const OBSERVES: bool = true;

    fn observe(&mut self, steps: u64, now: &mut dyn FnMut() -> X) -> ControlFlow<()> {
        if self.n != 0 && steps.is_multiple_of(self.n) { (self.function)(&now()) } else { ControlFlow::Continue(()) }
    }
}
