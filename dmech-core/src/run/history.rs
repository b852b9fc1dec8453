//! How invariants moved over a run.

use crate::drift::Drifts;
use crate::invariant::Invariant;

/// The most parts that a history is kept in.
const PARTS: usize = 2048;

/// How far a quantity was from its value at the start, over the states at which a run looked at its invariants: the first, the
/// recorded ones and the last; of states [at given times](crate::Simulation::record_at), the ends of the steps in which they lie.
///
/// It has at most 2048 parts. A part is one state until there are more of them; then two parts become one, and each part is of
/// twice as many states.
///
/// ```
/// use dmech_core::prelude::*;
#[doc = include_str!("../examples/quartic.md")]
/// let quartic = Simulation::new(Quartic { k: 1.7 }, State::new([1.0], [0.3]));
/// let run = quartic.scheme(Leapfrog).dt(0.01).run(1000)?;
/// let energy = run.history(Invariant::Energy).unwrap();
///
/// // As comma-separated values, to a file or, here, into a text.
/// let mut table = String::from("t,deviation\n");
/// for (t, deviation) in energy.points() {
///     table += &format!("{t},{deviation}\n");
/// }
/// assert!(table.starts_with("t,deviation\n0,0\n0.01,") && table.lines().count() == 1002);
///
/// // The extremes, of which none is lost however many states there are.
/// let largest = energy.parts().iter().fold(0.0, |most: f64, part| most.max(part.most()).max(-part.least()));
/// assert_eq!(largest, run.drift(Invariant::Energy).unwrap().max_abs());
/// # Ok::<(), Box<dyn std::error::Error>>(())
/// ```
#[derive(Clone, Debug)]
pub struct History {
    parts: Vec<HistoryPart>,
    /// The deviation in the last state.
    last: f64,
    /// States in a part, and those that the last part still takes.
    each: u64,
    room: u64,
}

/// States in a row of a [`History`]: when they were, and how far the quantity was from its value at the start.
#[derive(Clone, Copy, Debug)]
pub struct HistoryPart {
    times: [f64; 2],
    first: f64,
    /// The least above the most, where no deviation was a finite number.
    least: f64,
    most: f64,
    /// Whether one of them was no finite number.
    lost: bool,
}

impl HistoryPart {
    /// The times of its first and its last state.
    pub fn times(&self) -> [f64; 2] {
        self.times
    }

    /// The deviation in its first state.
    pub fn first(&self) -> f64 {
        self.first
    }

    /// The least deviation that is a finite number; NaN where there is none.
    pub fn least(&self) -> f64 {
        if self.least <= self.most { self.least } else { f64::NAN }
    }

    /// The largest deviation that is a finite number; NaN where there is none.
    pub fn most(&self) -> f64 {
        if self.least <= self.most { self.most } else { f64::NAN }
    }

    /// Whether all deviations in it are finite numbers.
    pub fn is_finite(&self) -> bool {
        !self.lost
    }

    fn at(t: f64, deviation: f64) -> HistoryPart {
        let mut part =
            HistoryPart { times: [t; 2], first: deviation, least: f64::INFINITY, most: f64::NEG_INFINITY, lost: false };
        part.see(t, deviation);
        part
    }

    #[inline]
    fn see(&mut self, t: f64, deviation: f64) {
        self.times[1] = t;
        if deviation.is_finite() {
            self.least = if deviation < self.least { deviation } else { self.least };
            self.most = if deviation > self.most { deviation } else { self.most };
        } else {
            self.lost = true;
        }
    }

    fn with(self, other: HistoryPart) -> HistoryPart {
        HistoryPart {
            times: [self.times[0], other.times[1]],
            first: self.first,
            least: self.least.min(other.least),
            most: self.most.max(other.most),
            lost: self.lost || other.lost,
        }
    }
}

impl History {
    pub(super) fn new() -> Self {
        History { parts: Vec::new(), last: f64::NAN, each: 1, room: 0 }
    }

    #[inline]
    fn see(&mut self, t: f64, deviation: f64) {
        self.last = deviation;
        match self.parts.last_mut() {
            Some(last) if self.room > 0 => {
                last.see(t, deviation);
                self.room -= 1;
            }
            _ => self.begin_a_part(t, deviation),
        }
    }

    #[cold]
    #[inline(never)]
    fn begin_a_part(&mut self, t: f64, deviation: f64) {
        if self.parts.len() == PARTS {
            self.parts = self.parts.chunks(2).map(|two| two[0].with(two[two.len() - 1])).collect();
            self.each *= 2;
        }
        self.parts.push(HistoryPart::at(t, deviation));
        self.room = self.each - 1;
    }

    /// Its parts, in the order of time.
    pub fn parts(&self) -> &[HistoryPart] {
        &self.parts
    }

    /// How many states are in a part; in the last there may be fewer.
    pub fn states_in_a_part(&self) -> u64 {
        self.each
    }

    /// Time and deviation of every state; of more than 2048 states those of the first in each part, and of the last of all. Between
    /// those the deviation may have been larger: [`parts`](History::parts).
    pub fn points(&self) -> impl Iterator<Item = (f64, f64)> + '_ {
        let last = self.parts.last().filter(|_| self.room + 1 < self.each).map(|part| (part.times[1], self.last));
        self.parts.iter().map(|part| (part.times[0], part.first)).chain(last)
    }
}

/// The histories of the invariants that a run watches.
#[derive(Clone, Debug, Default)]
pub(super) struct Histories {
    known: [Option<History>; Invariant::ALL.len()],
    /// Of the law's own, then of the quantities of the run.
    own: Vec<History>,
}

impl Histories {
    /// Of a run that has these invariants.
    pub(super) fn of_those(drifts: &Drifts) -> Self {
        let known = drifts.each_ref().map(|drift| drift.map(|_| History::new()));
        Histories { known, own: Vec::new() }
    }

    /// The deviation of each, by `Invariant as usize`, of those that there are; apart from what computes them, of which runs that
    /// keep none are made as well.
    #[inline(never)]
    pub(super) fn see(&mut self, t: f64, deviations: &[f64; Invariant::ALL.len()]) {
        for (history, &deviation) in self.known.iter_mut().zip(deviations) {
            if let Some(history) = history {
                history.see(t, deviation);
            }
        }
    }

    /// Those of the law, then of the run, are seen one after another.
    pub(super) fn see_own(&mut self, k: usize, t: f64, deviation: f64) {
        if self.own.len() == k {
            self.own.push(History::new());
        }
        if let Some(history) = self.own.get_mut(k) {
            history.see(t, deviation);
        }
    }

    pub(super) fn of(&self, invariant: Invariant) -> Option<&History> {
        self.known[invariant as usize].as_ref()
    }

    pub(super) fn of_own(&self, k: usize) -> Option<&History> {
        self.own.get(k)
    }
}

#[cfg(test)]
mod tests {
    use super::{History, PARTS};

    /// Of any number of states the parts are few and follow one another, and no extreme is lost.
    #[test]
    fn a_history_keeps_every_extreme_in_few_parts() {
        for states in [1_u32, 2, 2047, 2048, 2049, 5000, 1_000_000] {
            let mut history = History::new();
            let value = |k: u32| f64::from(k.wrapping_mul(2_654_435_761) >> 8) - 8e6;
            (0..states).for_each(|k| history.see(f64::from(k), value(k)));
            let parts = history.parts();
            assert!(parts.len() <= PARTS && parts.len() >= (states as usize).min(PARTS / 2));
            assert_eq!((parts[0].times()[0], parts[parts.len() - 1].times()[1]), (0.0, f64::from(states - 1)));
            assert!(parts.windows(2).all(|two| two[0].times()[1] + 1.0 == two[1].times()[0]));
            for (part, is_last) in parts.iter().rev().zip([true].into_iter().chain(core::iter::repeat(false))) {
                let within = part.times()[0] as u32..=part.times()[1] as u32;
                let many = u64::from(within.end() - within.start()) + 1;
                assert!(if is_last { many <= history.states_in_a_part() } else { many == history.states_in_a_part() });
                assert_eq!(part.first(), value(*within.start()));
                let (least, most) = within.map(value).fold((f64::MAX, f64::MIN), |(a, b), x| (a.min(x), b.max(x)));
                assert_eq!((part.least(), part.most(), part.is_finite()), (least, most, true));
            }
        }
    }

    /// Points are states as they were, at equal distances, from the first to the last, each once.
    #[test]
    fn points_are_states_from_the_first_to_the_last() {
        for states in [0_u32, 1, 2, 2048, 2049, 2050, 4096, 4097, 10_000] {
            let mut history = History::new();
            let value = |k: u32| f64::from(k * k);
            (0..states).for_each(|k| history.see(f64::from(k), value(k)));
            let each = history.states_in_a_part() as usize;
            let mut expected: Vec<u32> = (0..states).step_by(each).collect();
            if states > 0 && !(states as usize - 1).is_multiple_of(each) {
                expected.push(states - 1);
            }
            let expected: Vec<_> = expected.into_iter().map(|k| (f64::from(k), value(k))).collect();
            assert_eq!(history.points().collect::<Vec<_>>(), expected, "{states}");
            assert_eq!(each == 1, states as usize <= PARTS);
        }
    }

    #[test]
    fn what_is_no_number_is_told_and_hides_nothing() {
        let mut history = History::new();
        for k in 0..3 * PARTS {
            history.see(k as f64, if k % 2 == 0 { f64::NAN } else { k as f64 });
        }
        assert!(history.states_in_a_part() > 1);
        for part in history.parts() {
            let odd = part.times().map(|t| if t % 2.0 == 0.0 { t + 1.0 } else { t });
            assert!(!part.is_finite() && part.first().is_nan());
            assert_eq!([part.least(), part.most()], [odd[0], part.times()[1]]);
        }
        let mut lost = History::new();
        [f64::NEG_INFINITY, f64::INFINITY, f64::NAN].into_iter().for_each(|x| lost.see(0.0, x));
        for part in lost.parts() {
            assert!(!part.is_finite() && part.least().is_nan() && part.most().is_nan());
        }
        assert_eq!(lost.parts().len(), 3);
    }
}
