//! How invariants moved.

use core::fmt;

use dmech_scalar::{Mask, Real};

use crate::invariant::Invariant;
use crate::text::Number;
use crate::words::Word;

/// The drift of each invariant, by `Invariant as usize`.
pub type Drifts = [Option<Drift>; Invariant::ALL.len()];

/// How many invariants of its own a law can have watched, and how many quantities a run.
pub const MAX_OWN: usize = 8;

/// The drifts of the invariants that a law declares itself, and of the quantities that a run watches, by name.
#[derive(Clone, Debug, Default)]
#[cfg_attr(feature = "serde", derive(serde::Serialize, serde::Deserialize))]
pub struct OwnDrifts(#[cfg_attr(feature = "serde", serde(deserialize_with = "named"))] Vec<(Word, Drift)>);

/// Drifts by names that are read.
#[cfg(feature = "serde")]
fn named<'de, D: serde::Deserializer<'de>>(deserializer: D) -> Result<Vec<(Word, Drift)>, D::Error> {
    #[derive(serde::Deserialize)]
    struct Named(#[serde(with = "crate::words")] Word, Drift);
    let list: Vec<Named> = serde::Deserialize::deserialize(deserializer)?;
    Ok(list.into_iter().map(|Named(name, drift)| (name, drift)).collect())
}

impl OwnDrifts {
    /// Each with its name, in the order in which they are declared.
    pub fn iter(&self) -> impl Iterator<Item = (&'static str, Drift)> + '_ {
        self.0.iter().copied()
    }

    pub(crate) fn iter_mut(&mut self) -> impl Iterator<Item = &mut Drift> {
        self.0.iter_mut().map(|(_, drift)| drift)
    }

    /// Adds one.
    pub(crate) fn add(&mut self, name: Word, drift: Drift) {
        self.0.push((name, drift));
    }

    /// That of one name.
    pub fn of(&self, name: &str) -> Option<Drift> {
        self.iter().find_map(|(own, drift)| (own == name).then_some(drift))
    }
}

/// How an invariant moved over the recorded states.
///
/// For the angular momentum of more than two coordinates the values are norms of a tensor, and deviations the norm of
/// the difference from the start.
///
/// `Display` shows it in a line, with the numbers of a report:
///
/// ```
/// use dmech_core::prelude::*;
#[doc = include_str!("examples/spring.md")]
/// let spring = Simulation::new(Spring { k: 4.0 }, State::new([1.0], [0.0]));
/// let run = spring.scheme(Leapfrog).dt(0.1).run(100)?;
/// println!("{}", run.drift(Invariant::Energy).unwrap());
/// // 2.000000000000000 at the start, moved by 2.00e-2 at most, relative 9.99e-3, per time +3.8e-5
/// # let line = run.drift(Invariant::Energy).unwrap().to_string();
/// # assert!(line.starts_with("2.000000000000000 at the start, moved by 2.00e-2 at most, relative 9.99e-3, per time "), "{line}");
/// # Ok::<(), Box<dyn std::error::Error>>(())
/// ```
#[derive(Clone, Copy, Debug, PartialEq)]
#[cfg_attr(feature = "serde", derive(serde::Serialize, serde::Deserialize))]
pub struct Drift<R = f64> {
    start: R,
    last: R,
    max_abs: R,
    samples: R,
    // Running means and moments of (t, value − start), after B. P. Welford, Technometrics 4 (1962) 419.
    mean_t: R,
    mean_x: R,
    moment_tt: R,
    moment_tx: R,
}

impl<R: Real> Drift<R> {
    pub(crate) fn new(t: R, start: R) -> Self {
        // What is no number at the start has not stayed where it was.
        let (max_abs, mean_t, [mean_x, moment_tt, moment_tx]) = ((R::ZERO * start).abs(), t, [R::ZERO; 3]);
        Drift { start, last: start, max_abs, samples: R::ONE, mean_t, mean_x, moment_tt, moment_tx }
    }

    /// A later value whose distance from the start is `deviation` (signed where that has a meaning).
    #[inline]
    pub(crate) fn observe(&mut self, t: R, value: R, deviation: R) {
        self.last = value;
        // max() would drop a NaN, which once seen is kept.
        let is_number = self.max_abs.equal(self.max_abs);
        let within = deviation.abs().less_or_equal(self.max_abs).or(is_number.not());
        self.max_abs = R::either(within, self.max_abs, deviation.abs());
        self.samples += R::ONE;
        let weight = R::ONE / self.samples;
        let from_t = t - self.mean_t;
        self.mean_t += weight * from_t;
        self.mean_x += weight * (deviation - self.mean_x);
        self.moment_tt += from_t * (t - self.mean_t);
        self.moment_tx += from_t * (deviation - self.mean_x);
    }
}

impl<R: Copy> Drift<R> {
    /// Its numbers, in order.
    pub(crate) fn fields(&self) -> [R; 8] {
        self.each_field().map(|&number| number)
    }

    /// Where they are.
    pub(crate) fn each_field(&self) -> [&R; 8] {
        let Drift { start, last, max_abs, samples, mean_t, mean_x, moment_tt, moment_tx } = self;
        [start, last, max_abs, samples, mean_t, mean_x, moment_tt, moment_tx]
    }

    /// The same, to be written to.
    pub(crate) fn each_field_mut(&mut self) -> [&mut R; 8] {
        let Drift { start, last, max_abs, samples, mean_t, mean_x, moment_tt, moment_tx } = self;
        [start, last, max_abs, samples, mean_t, mean_x, moment_tt, moment_tx]
    }

    /// Of its numbers.
    pub(crate) fn by_field(number: impl FnMut(usize) -> R) -> Self {
        let [start, last, max_abs, samples, mean_t, mean_x, moment_tt, moment_tx] = core::array::from_fn(number);
        Drift { start, last, max_abs, samples, mean_t, mean_x, moment_tt, moment_tx }
    }
}

impl Drift {
    /// The value in the first state.
    pub fn start(&self) -> f64 {
        self.start
    }

    /// The value in the last state.
    pub fn last(&self) -> f64 {
        self.last
    }

    /// The largest distance from the first value, in its units.
    pub fn max_abs(&self) -> f64 {
        self.max_abs
    }

    /// [`max_abs`](Drift::max_abs) over the first value; infinite if that is zero and the quantity moved.
    pub fn max_relative(&self) -> f64 {
        if self.max_abs == 0.0 { 0.0 } else { self.max_abs / self.start.abs() }
    }

    /// The trend: the slope of the least-squares line through the deviations, per unit of time.
    ///
    /// An error that only fluctuates has a slope near zero however long the run; one that accumulates does not.
    pub fn slope(&self) -> f64 {
        if self.moment_tt > 0.0 { self.moment_tx / self.moment_tt } else { 0.0 }
    }

    /// The number of states observed.
    pub fn samples(&self) -> u64 {
        self.samples as u64
    }

    /// As a report shows it: the start, the largest deviation, the same relative to the start, the slope.
    pub(crate) fn figures(&self) -> [String; 4] {
        let relative = self.max_relative();
        [
            format!("{:.15}", Number(self.start)),
            format!("{:.2e}", self.max_abs),
            // Nothing is relative to 0, where bodies at rest and closed systems start.
            if relative.is_finite() { format!("{relative:.2e}") } else { "–".to_owned() },
            format!("{:+.1e}", self.slope()),
        ]
    }
}

impl fmt::Display for Drift {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        let [start, largest, relative, slope] = self.figures();
        f.pad(&format!("{start} at the start, moved by {largest} at most, relative {relative}, per time {slope}"))
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    /// In a line, and in as many places as it is asked for; nothing is relative to 0, and no number is told as none.
    #[test]
    fn a_drift_is_a_line() {
        let mut moved = Drift::new(0.0, -2.5e7);
        moved.observe(1.0, -2.5e7 - 1.0, -1.0);
        let line = "-2.500000000000000e7 at the start, moved by 1.00e0 at most, relative 4.00e-8, per time -1.0e0";
        assert_eq!(moved.to_string(), line);
        assert_eq!(format!("{moved:>110}"), format!("{line:>110}"));
        let mut closed = Drift::new(0.0, 0.0);
        let still = "0.000000000000000 at the start, moved by 0.00e0 at most, relative 0.00e0, per time +0.0e0";
        assert_eq!(closed.to_string(), still);
        closed.observe(1.0, 1e-16, 1e-16);
        assert!(closed.to_string().contains("moved by 1.00e-16 at most, relative –"), "{closed}");
        let lost = Drift::new(0.0, f64::NAN).to_string();
        assert_eq!(lost, "NaN at the start, moved by NaN at most, relative –, per time +0.0e0");
    }

    /// A line comes back exactly, a symmetric wave has no slope, and a NaN is not lost.
    #[test]
    fn the_slope_is_that_of_the_least_squares_line() {
        let mut line = Drift::new(1.0, 5.0);
        let mut wave = Drift::new(-4.0, 2.0);
        for k in 1..=100 {
            let t = 1.0 + 0.3 * f64::from(k);
            line.observe(t, 5.0 - 0.7 * (t - 1.0), -0.7 * (t - 1.0));
        }
        for t in -3..=4 {
            let x = f64::from(t * t - 16);
            wave.observe(f64::from(t), 2.0 + x, x);
        }
        assert!((line.slope() + 0.7).abs() < 1e-13, "{}", line.slope());
        assert!((line.max_abs() - 21.0).abs() < 1e-13 && (line.max_relative() - 4.2).abs() < 1e-13);
        assert!(wave.slope().abs() < 1e-14 && wave.max_abs() == 16.0 && wave.samples() == 9);
        wave.observe(5.0, f64::NAN, f64::NAN);
        wave.observe(6.0, 2.0, 0.0);
        assert!(wave.max_abs().is_nan());
        for start in [f64::NAN, f64::INFINITY] {
            let lost = Drift::new(0.0, start);
            assert!(lost.max_abs().is_nan() && lost.max_relative().is_nan(), "{lost:?}");
        }
    }
}
