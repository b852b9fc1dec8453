//! How invariants moved over a run, for its pictures.

use crate::drift::MAX_OWN;
use crate::invariant::Invariant;

/// The most parts that a history is kept in.
const PARTS: usize = 2048;

/// The deviation of a quantity from its value at the start, over time: the least and the largest in each of at most 2048 parts.
///
/// A part is one state until there are 2048 of them; then two parts become one, and each part is of twice as many states.
#[derive(Clone, Debug)]
pub struct History {
    parts: Vec<Part>,
    /// Time and deviation of the first and the last state.
    ends: [(f64, f64); 2],
    /// States in a part, and those that the last part still takes.
    each: u64,
    room: u64,
}

#[derive(Clone, Copy, Debug)]
pub(super) struct Part {
    pub(super) times: [f64; 2],
    pub(super) least: f64,
    pub(super) most: f64,
    /// Whether one of them was no finite number.
    pub(super) lost: bool,
}

impl Part {
    fn with(self, other: Part) -> Part {
        Part {
            times: [self.times[0], other.times[1]],
            least: self.least.min(other.least),
            most: self.most.max(other.most),
            lost: self.lost || other.lost,
        }
    }
}

impl History {
    pub(super) fn new() -> Self {
        History { parts: Vec::new(), ends: [(f64::NAN, f64::NAN); 2], each: 1, room: 0 }
    }

    pub(super) fn see(&mut self, t: f64, deviation: f64) {
        if self.parts.is_empty() {
            self.ends[0] = (t, deviation);
        }
        self.ends[1] = (t, deviation);
        let lost = !deviation.is_finite();
        // What min and max pass over.
        let x = if lost { f64::NAN } else { deviation };
        let seen = Part { times: [t; 2], least: x, most: x, lost };
        if self.room > 0
            && let Some(last) = self.parts.last_mut()
        {
            *last = last.with(seen);
            self.room -= 1;
            return;
        }
        if self.parts.len() == PARTS {
            self.parts = self.parts.chunks(2).map(|two| two[0].with(two[two.len() - 1])).collect();
            self.each *= 2;
        }
        self.parts.push(seen);
        self.room = self.each - 1;
    }

    pub(super) fn ends(&self) -> [(f64, f64); 2] {
        self.ends
    }

    pub(super) fn parts(&self) -> &[Part] {
        &self.parts
    }
}

/// The histories of the invariants that a run watches.
#[derive(Clone, Debug, Default)]
pub(super) struct Histories {
    known: [Option<History>; Invariant::ALL.len()],
    own: Vec<Option<History>>,
}

impl Histories {
    pub(super) fn see(&mut self, invariant: Invariant, t: f64, deviation: f64) {
        self.known[invariant as usize].get_or_insert_with(History::new).see(t, deviation);
    }

    /// That of the number `k` of the law's own.
    pub(super) fn see_own(&mut self, k: usize, t: f64, deviation: f64) {
        if self.own.len() <= k {
            self.own.resize(MAX_OWN.max(k + 1), None);
        }
        self.own[k].get_or_insert_with(History::new).see(t, deviation);
    }

    /// Adds that of a quantity of the run, which is counted after those of the law.
    pub(super) fn add(&mut self, k: usize, history: History) {
        if self.own.len() <= k {
            self.own.resize(k + 1, None);
        }
        self.own[k] = Some(history);
    }

    pub(super) fn of(&self, invariant: Invariant) -> Option<&History> {
        self.known[invariant as usize].as_ref()
    }

    pub(super) fn of_own(&self, k: usize) -> Option<&History> {
        self.own.get(k)?.as_ref()
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
            assert!(parts[0].times[0] == 0.0 && parts[parts.len() - 1].times[1] == f64::from(states - 1));
            assert_eq!(history.ends(), [0, states - 1].map(|k| (f64::from(k), value(k))));
            assert!(parts.windows(2).all(|two| two[0].times[1] + 1.0 == two[1].times[0]));
            for part in parts {
                let within = part.times[0] as u32..=part.times[1] as u32;
                let (least, most) = within.map(value).fold((f64::MAX, f64::MIN), |(a, b), x| (a.min(x), b.max(x)));
                assert_eq!((part.least, part.most, part.lost), (least, most, false));
            }
        }
    }

    #[test]
    fn what_is_no_number_is_told_and_hides_nothing() {
        let mut history = History::new();
        for k in 0..3 * PARTS {
            history.see(k as f64, if k % 2 == 0 { f64::NAN } else { k as f64 });
        }
        assert!(history.parts().iter().all(|part| part.lost && part.most >= part.least));
    }
}
