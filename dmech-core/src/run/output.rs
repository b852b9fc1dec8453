//! Output: every n-th state, or those at given times.

use super::due::Due;
use super::simulation::Simulation;

impl<L, X, S, O> Simulation<L, X, S, O> {
    /// Records the state after every n-th step (default 1). The first state is always recorded.
    ///
    /// A run has one rule of what it records: of `record_every`, [`record_at`](Simulation::record_at) and
    /// [`record_dt`](Simulation::record_dt) the last that was said, as of [`dt`](Simulation::dt) and all that is set by a number. Then a
    /// simulation that is cloned can be given another.
    ///
    /// A state takes 8 (1 + 2 D) bytes, of a scene 16 D a body: a run of 10⁷ steps in the plane 400 MB. More than there is memory
    /// for is refused before the run, with [`Error::Recording`](crate::Error::Recording).
    pub fn record_every(self, n: u64) -> Self {
        self.with(|settings| settings.due = Due::Every(n))
    }

    /// Records the states at these times and no others, in the order of time; what was said before of what is recorded
    /// does not count. The steps do not move: a state between two of them
    /// is the end of a shortened step of the same scheme, made from the last, and has its order. Each costs about a step.
    ///
    /// Times that the run does not reach are not recorded; the invariants are looked at after the steps in which something is
    /// recorded.
    ///
    /// ```
    /// use dmech_core::prelude::*;
    #[doc = include_str!("../examples/spring.md")]
    /// let spring = Simulation::new(Spring { k: 4.0 }, State::new([1.0], [0.0])).scheme(Nystrom::order8()).dt(0.2);
    /// let run = spring.record_at([0.5, 1.0, 2.5]).run_until(3.0)?;
    /// for state in run.states() {
    ///     assert!((state.q[0] - (2.0 * state.t).cos()).abs() < 1e-9);
    /// }
    /// assert_eq!(run.states()[1].t, 1.0);
    /// # Ok::<(), Box<dyn std::error::Error>>(())
    /// ```
    ///
    /// # Errors
    /// When run: [`Error::RecordAt`](crate::Error::RecordAt) for times that are not finite or lie before the start.
    pub fn record_at(self, times: impl IntoIterator<Item = f64>) -> Self {
        let mut times: Vec<f64> = times.into_iter().collect();
        times.sort_by(f64::total_cmp);
        self.with(|settings| settings.due = Due::At(times))
    }

    /// Records the states at the times t₀ + k dt, as [`record_at`](Simulation::record_at), for as long as the run goes; what
    /// was said before of what is recorded does not count.
    ///
    /// # Errors
    /// When run: [`Error::RecordDt`](crate::Error::RecordDt) where dt is not positive and finite.
    pub fn record_dt(self, dt: f64) -> Self {
        self.with(|settings| settings.due = Due::Apart(dt))
    }
}
