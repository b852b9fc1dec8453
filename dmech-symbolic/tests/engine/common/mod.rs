//! What the tests of the engine share: an evaluator over any kind of number, random laws, and error analysis.
#![allow(dead_code)]

pub(crate) mod algebra;
pub(crate) mod bounds;
pub(crate) mod evaluate;
pub(crate) mod laws;
pub(crate) mod notation;
pub(crate) mod tracked;
pub(crate) mod tree;

use proptest::strategy::Strategy;
use proptest::test_runner::{Config, RngAlgorithm, TestRng, TestRunner};

/// Half a unit in the last place, relative.
pub(crate) const U: f64 = f64::EPSILON / 2.0;

/// Runs a test on random cases, the same ones each time; a failing case is shrunk.
pub(crate) fn for_all<S: Strategy>(cases: u32, strategy: &S, test: impl Fn(S::Value)) {
    let config = Config { cases, failure_persistence: None, max_shrink_iters: 2000, ..Config::default() };
    let rng = TestRng::deterministic_rng(RngAlgorithm::ChaCha);
    let mut runner = TestRunner::new_with_rng(config, rng);
    let outcome = runner.run(strategy, |case| {
        test(case);
        Ok(())
    });
    if let Err(failure) = outcome {
        panic!("{failure}");
    }
}

/// The largest of the figures it is shown, and where it was.
pub(crate) struct Worst {
    figure: std::cell::Cell<f64>,
    place: std::cell::RefCell<String>,
    seen: std::cell::Cell<u64>,
}

impl Worst {
    pub(crate) fn new() -> Self {
        Self { figure: 0.0.into(), place: String::new().into(), seen: 0.into() }
    }

    /// NaN counts as infinitely bad.
    pub(crate) fn see(&self, figure: f64, place: impl FnOnce() -> String) {
        let figure = if figure.is_nan() { f64::INFINITY } else { figure };
        self.seen.set(self.seen.get() + 1);
        if figure > self.figure.get() {
            self.figure.set(figure);
            self.place.replace(place());
        }
    }

    pub(crate) fn figure(&self) -> f64 {
        self.figure.get()
    }

    pub(crate) fn place(&self) -> String {
        self.place.borrow().clone()
    }

    pub(crate) fn seen(&self) -> u64 {
        self.seen.get()
    }

    /// Prints the figure and holds it to a bound.
    pub(crate) fn at_most(&self, bound: f64, what: &str) {
        println!(
            "{what}: at most {:.2} (bound {bound}) over {} checks, {}",
            self.figure(),
            self.seen(),
            self.place.borrow()
        );
        assert!(self.seen() > 0, "{what}: nothing was checked");
        assert!(self.figure() <= bound, "{what}: {} > {bound}, {}", self.figure(), self.place.borrow());
    }
}

/// How often the allowed error is reached; nothing is allowed where nothing is to be had.
pub(crate) fn ratio(error: f64, allowed: f64) -> f64 {
    if error == 0.0 { 0.0 } else { error / allowed }
}
