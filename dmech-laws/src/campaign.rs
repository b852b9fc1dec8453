//! Many laws, one after the other, each at many points.

use std::collections::BTreeMap;
use std::time::{Duration, Instant};

use super::engine::Engine;
use super::finding::Finding;
use super::grow::Law;
use super::points::{Place, pairs};
use super::promise::Promise;
use super::random::Random;
use super::shrink::shrunk;
use super::trial::{Outcome, takes_differences, tries_second, try_pair};

/// What many laws showed.
#[derive(Clone, Debug, Default)]
pub struct Tally {
    /// How many laws.
    pub laws: u64,
    /// How many had a choice that some pair of points crossed.
    pub crossed: u64,
    /// How often each kind of node was in a law.
    pub kinds: BTreeMap<&'static str, u64>,
    /// For each kind of place: pairs, pairs where the law is not finite, pairs that cross a seam.
    pub places: BTreeMap<Place, [u64; 3]>,
    /// Laws with a coordinate that is absent.
    pub absent: u64,
    /// How many derivatives were compared.
    pub slopes: u64,
    /// The largest error of a secant identity that was kept, in ulp of its scale.
    pub worst: f64,
    /// How many laws did not keep a promise, by the first that they broke.
    pub broken: BTreeMap<Promise, u64>,
    /// The first of each promise, a few.
    pub findings: Vec<Finding>,
    /// Time spent on trials; making findings smaller comes on top.
    pub time: Duration,
    /// The longest time for one law, and which it was.
    pub slowest: (Duration, u64),
}

/// Names the law on the way out of a panic.
struct Witness<'a>(u64, &'a Law);

impl Drop for Witness<'_> {
    fn drop(&mut self) {
        if std::thread::panicking() {
            eprintln!("while trying law {}: {} in {} coordinates", self.0, self.1.tree, self.1.dimension);
        }
    }
}

impl Tally {
    /// Tries law k of the series that belongs to a seed.
    pub fn try_law(&mut self, seed: u64, k: u64, shown: usize) {
        let clock = Instant::now();
        let mut random = Random::member(seed, k);
        let law = Law::random(&mut random);
        let _witness = Witness(k, &law);
        self.laws += 1;
        let mut kinds: Vec<_> = vec![];
        law.tree.visit(&mut |t| kinds.push(t.kind()));
        kinds.sort_unstable();
        kinds.dedup();
        kinds.into_iter().for_each(|kind| *self.kinds.entry(kind).or_default() += 1);
        self.absent += u64::from((0..law.dimension).any(|i| !law.tree.contains(i)));
        let second = tries_second(k);
        let engine = Engine::new(&law, second);
        let (mut crossed, mut found) = (false, None);
        for (place, a, b) in pairs(&law, &mut random) {
            let slopes = takes_differences(place);
            let outcome = try_pair(&law, &engine, &a, &b, slopes);
            let counts = self.places.entry(place).or_default();
            let Outcome { failure, ulps, unbounded, crosses, slopes: settled } = outcome;
            counts[0] += 1;
            counts[1] += u64::from(unbounded);
            counts[2] += u64::from(crosses);
            crossed |= crosses;
            self.slopes += settled as u64;
            let Some(failure) = failure else {
                self.worst = self.worst.max(ulps);
                continue;
            };
            let promise = failure.promise;
            *self.broken.entry(promise).or_default() += 1;
            if self.findings.iter().filter(|f| f.failure.promise == promise).count() < shown {
                found = Some((Finding { k, law: law.clone(), place, ends: [a, b], failure }, slopes));
            }
            break;
        }
        self.crossed += u64::from(crossed);
        let spent = clock.elapsed();
        self.time += spent;
        self.slowest = self.slowest.max((spent, k));
        self.findings.extend(found.map(|(finding, slopes)| shrunk(finding, second, slopes)));
    }

    /// Adds what another thread counted.
    pub fn merge(&mut self, other: Self) {
        self.laws += other.laws;
        self.crossed += other.crossed;
        self.absent += other.absent;
        self.slopes += other.slopes;
        self.worst = self.worst.max(other.worst);
        self.time += other.time;
        self.slowest = self.slowest.max(other.slowest);
        for (kind, n) in other.kinds {
            *self.kinds.entry(kind).or_default() += n;
        }
        for (promise, n) in other.broken {
            *self.broken.entry(promise).or_default() += n;
        }
        for (place, counts) in other.places {
            let mine = self.places.entry(place).or_default();
            (0..3).for_each(|i| mine[i] += counts[i]);
        }
        self.findings.extend(other.findings);
    }
}

/// Laws `first`…`first + count` of the series that belongs to a seed, with at most `shown` findings of each kind.
pub fn campaign(seed: u64, first: u64, count: u64, shown: usize) -> Tally {
    let mut tally = Tally::default();
    (first..first + count).for_each(|k| tally.try_law(seed, k, shown));
    tally
}
