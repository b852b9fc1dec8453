//! What comes back from an ensemble.

use core::fmt;
use std::time::{Duration, Instant};

use super::Outcome;
use super::plan::{See, Tally};
use crate::drift::Drift;
use crate::error::Error;
use crate::fnv::Fnv;
use crate::invariant::Invariant;
use crate::run::{Columns, Interrupted, Run};

/// The members of an ensemble after their motions, in their order.
#[derive(Clone, Debug)]
pub struct EnsembleRun<X> {
    members: Vec<Outcome<X>>,
    /// What was moved now, in the time that it took.
    moved: Tally,
    elapsed: Duration,
}

impl<X: Clone> EnsembleRun<X> {
    /// All that are handed over, about so many, and how long it took.
    ///
    /// # Errors
    /// [`Error`] of what hands them over.
    pub(super) fn gathered(members: usize, go: &dyn Fn(See<'_, X>) -> Result<Tally, Error>) -> Result<Self, Error> {
        let (clock, mut members) = (Instant::now(), Vec::with_capacity(members));
        let moved = go(&mut |_, member| members.push(member))?;
        Ok(EnsembleRun { members, moved, elapsed: clock.elapsed() })
    }

    /// How many members there are.
    pub fn len(&self) -> usize {
        self.members.len()
    }

    /// Whether there is none.
    pub fn is_empty(&self) -> bool {
        self.members.is_empty()
    }

    /// The run of a member; of one that failed, what it had come to, with the cause. Side by side with others its time is not
    /// measured.
    ///
    /// # Errors
    /// [`Interrupted`]
    ///
    /// # Panics
    /// If there are not so many members.
    pub fn member(&self, k: usize) -> Result<&Run<X>, &Interrupted<X>> {
        self.members[k].as_ref()
    }

    /// Every member, in order.
    pub fn members(&self) -> impl ExactSizeIterator<Item = Result<&Run<X>, &Interrupted<X>>> {
        self.members.iter().map(Result::as_ref)
    }

    /// The last state of a member, or why it has none.
    ///
    /// # Errors
    /// What ended the run of this member.
    ///
    /// # Panics
    /// If there are not so many members.
    pub fn last(&self, k: usize) -> Result<X, Error> {
        self.member(k).map(|run| run.last().clone()).map_err(Interrupted::cause)
    }

    /// How an invariant of a member moved, up to where it failed if it did; `None` where the law, or the scheme, has no such
    /// invariant. [`Invariant::WorkEnergy`] is there where the work of the steps is summed:
    /// [`Ensemble::watch_work`](crate::Ensemble::watch_work), and always of [`Ensemble::each`](crate::Ensemble::each).
    ///
    /// # Panics
    /// If there are not so many members.
    pub fn drift(&self, k: usize, invariant: Invariant) -> Option<Drift> {
        self.member(k).unwrap_or_else(Interrupted::run).drift(invariant)
    }

    /// The same of an invariant that the law declares itself, by its name.
    ///
    /// # Panics
    /// Likewise.
    pub fn drift_of(&self, k: usize, name: &str) -> Option<Drift> {
        self.member(k).unwrap_or_else(Interrupted::run).drift_of(name)
    }

    /// The members that failed, each with the cause.
    pub fn failures(&self) -> impl Iterator<Item = (usize, Error)> {
        self.members.iter().enumerate().filter_map(|(k, member)| Some((k, member.as_ref().err()?.cause())))
    }

    /// Time that it took.
    pub fn elapsed(&self) -> Duration {
        self.elapsed
    }
}

impl<X: Columns> EnsembleRun<X> {
    /// A number that tells two sets of results apart: it depends on every bit of the last states, in their order, and on which members
    /// failed, not on how many lanes and threads have moved them.
    ///
    /// # Reference
    /// FNV-1a of 64 bits, over the bytes of the numbers (G. Fowler, L. C. Noll, K.-P. Vo, RFC 9923).
    pub fn checksum(&self) -> u64 {
        let mut sum = Checksum::default();
        self.members.iter().for_each(|member| sum.add(member.as_ref()));
        sum.value()
    }
}

/// [`EnsembleRun::checksum`] of members as they come, for those that are not all kept.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub struct Checksum(Fnv);

impl Default for Checksum {
    /// Of no member.
    fn default() -> Self {
        Checksum(Fnv::NOTHING)
    }
}

impl Checksum {
    /// Adds a member; they must come in order.
    pub fn add<X: Columns>(&mut self, member: Result<&Run<X>, &Interrupted<X>>) {
        let (run, failed) = match member {
            Ok(run) => (run, 0),
            Err(interrupted) => (interrupted.run(), 1),
        };
        self.word(failed);
        self.word(run.steps());
        run.last().parts(&mut |x| self.word(x.to_bits()));
    }

    /// Of all that were added.
    pub fn value(self) -> u64 {
        self.0.0
    }

    pub(super) fn word(&mut self, word: u64) {
        self.0.word(word);
    }

    /// Adds numbers, and how many they are.
    #[cfg(any(feature = "ranks", feature = "store"))]
    pub(super) fn list(&mut self, numbers: &[f64]) {
        self.word(numbers.len() as u64);
        numbers.iter().for_each(|x| self.word(x.to_bits()));
    }

    /// Adds letters, and how many they are.
    #[cfg(any(feature = "ranks", feature = "store"))]
    pub(super) fn text(&mut self, text: &str) {
        self.word(text.len() as u64);
        text.bytes().for_each(|byte| self.word(byte.into()));
    }
}

/// How many members, how many failed, and the largest deviation of each invariant; of members that came from a store how many there are,
/// and the time is that of the others.
impl<X> fmt::Display for EnsembleRun<X> {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        let failed = self.members.iter().filter(|member| member.is_err()).count();
        let steps: u64 = self.members.iter().flatten().map(Run::steps).sum();
        let (stored, made) = (self.members.len() - self.moved.members, self.moved.steps);
        let [members_of, steps_of] = match stored {
            0 => [String::new(), String::new()],
            _ => [format!(", {stored} from the store"), format!(", and {} steps from the store", steps - made)],
        };
        writeln!(f, "{} members, {failed} failed{members_of}", self.members.len())?;
        let seconds = self.elapsed.as_secs_f64();
        let each = if made == 0 { 0.0 } else { 1e9 * seconds / made as f64 };
        writeln!(f, "{made} steps in {seconds:.3} s, {each:.2} ns each{steps_of}")?;
        for invariant in Invariant::ALL {
            // Relative to 0 is no number.
            let drifts = self.members.iter().flatten().filter_map(|run| run.drift(invariant));
            let drifts = drifts.filter(|drift| drift.start() != 0.0);
            let worst = drifts.map(|drift| drift.max_relative()).reduce(|a, b| if a.is_nan() || a > b { a } else { b });
            if let Some(worst) = worst {
                writeln!(f, "{invariant:<20} relative deviation at most {worst:.2e}")?;
            }
        }
        Ok(())
    }
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::State;

    /// Nothing was made, and took no time each.
    #[test]
    fn no_step_takes_no_time() {
        let run: EnsembleRun<State<1>> =
            EnsembleRun { members: Vec::new(), moved: Tally::default(), elapsed: Duration::from_millis(3) };
        assert!(run.to_string().ends_with("0 steps in 0.003 s, 0.00 ns each\n"), "{run}");
    }
}
