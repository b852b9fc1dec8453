//! Whether what is left of an equation is rounding, told by how it scatters.
//!
//! Forces that cancel, as those that hold a body at rest, and forces with a quotient that cancels are known to many more roundings than
//! their own size tells, and no number in the equation says to how many. It shows along a line: what is rounding is no smoother there the
//! nearer one looks, while all else is straight.

/// A last correction that is this part of the position, or less, may be rounding.
pub(crate) const NEAR: f64 = 1e-6;
/// Corrections to where they no longer shrink.
pub(crate) const PATIENCE: usize = 8;

/// Values in a row: of their third differences one that is off, as at a pole, a jump or a bend, spoils four of ten.
const VALUES: usize = 13;
const DIFFERENCES: usize = VALUES - 3;
/// How far apart they are, in units of what is left. Where a position has not as many digits, only the far ones differ.
const SPACINGS: [f64; 5] = [4e2, 3e4, 2e6, 1e8, 7e9];
/// A part of a position, and of its move, in which no force waves: rounding is told within it alone. Waves scatter too where they are looked at
/// far apart.
const SMALL: f64 = 1e-5;
/// By how much of the way what is left falls: less is no equation that says where the root is, and where it is more, rounding that hardly
/// moves the root is a velocity.
const FALLS: [f64; 2] = [1e-2, 1e6];
/// What is left may be so many times as large as the middle one of the third differences.
const SCATTERS: f64 = 16.0;
/// So many times as far apart they are no larger than so many times: the rounding of the values themselves grows with the way.
const FURTHER: f64 = 16.0;
const GROWS: f64 = 5.0;
/// Rounding changes its sign nearly always, what is smooth does not.
const CHANGES: usize = 4;
/// By how much of the fall between two values one may be off the straight line.
const STRAIGHT: f64 = 0.25;
/// Where rounding has hit upon next to nothing, what it makes shows beside what was left before, so many times as much.
const LARGER: f64 = 1e5;

/// What is left of an equation Δ = f(Δ).
pub(crate) struct Left<'a> {
    /// What some corrections have left of it; the last counts.
    pub(crate) lengths: &'a [f64],
    /// The length of the position and of its move.
    pub(crate) reach: f64,
    /// The rounding of a number.
    pub(crate) epsilon: f64,
}

impl Left<'_> {
    /// Whether it is rounding. `at`(k, s) says how much of f(Δ) − Δ there is, in the direction of the k-th of those that were left, where Δ
    /// is longer by s times that: as far as nothing is neglected it falls by c s of it, with c = 1 − f′.
    ///
    /// # Reference
    /// J. J. Moré and S. M. Wild, "Estimating computational noise", SIAM J. Sci. Comput. 33 (2011) 1292–1314: tables of differences.
    pub(crate) fn is_rounding(&self, mut at: impl FnMut(usize, f64) -> f64) -> bool {
        let Some(&last) = self.lengths.last() else { return false };
        if last == 0.0 {
            return true;
        }
        let mut looked_at = 0.0;
        (0..self.lengths.len()).rev().any(|k| {
            let unit = self.lengths[k];
            let looks = unit >= LARGER * looked_at;
            looked_at = if looks { unit } else { looked_at };
            let mut value = |s: f64| at(k, s) / unit;
            let within = |spacing: &&f64| FURTHER * VALUES as f64 * **spacing * unit <= SMALL * self.reach;
            looks && SPACINGS.iter().filter(within).any(|&spacing| self.scatters(last / unit, spacing, &mut value))
        })
    }

    /// Whether values so far apart scatter about a line.
    fn scatters(&self, here: f64, spacing: f64, value: &mut impl FnMut(f64) -> f64) -> bool {
        // Where there is none, that shows at its end or in the middle most often.
        let (end, middle) = (value((VALUES - 1) as f64 * spacing), value((VALUES / 2) as f64 * spacing));
        let line = Line { from: here, fall: (here - end) / (VALUES - 1) as f64 };
        let [least, most] = FALLS.map(|c| c * spacing);
        if !(line.fall >= least && line.fall <= most && line.has(VALUES / 2, middle)) {
            return false;
        }
        let values = Values::of(here, spacing, value);
        let own = SCATTERS * VALUES as f64 * line.fall.max(spacing) * self.epsilon;
        values.0.iter().enumerate().all(|(j, &value)| line.has(j, value))
            && values.change_sign()
            && values.middle() >= own.max(here / SCATTERS)
            && Values::of(here, FURTHER * spacing, value).middle() <= GROWS * values.middle()
    }
}

/// A line, by its values at 0, 1, 2, …
struct Line {
    from: f64,
    fall: f64,
}

impl Line {
    fn has(&self, j: usize, value: f64) -> bool {
        (value - (self.from - self.fall * j as f64)).abs() <= STRAIGHT * self.fall
    }
}

/// Values in a row.
struct Values([f64; VALUES]);

impl Values {
    fn of(here: f64, spacing: f64, value: &mut impl FnMut(f64) -> f64) -> Self {
        Values(core::array::from_fn(|j| if j == 0 { here } else { value(j as f64 * spacing) }))
    }

    fn third_differences(&self) -> [f64; DIFFERENCES] {
        let Values(x) = self;
        core::array::from_fn(|j| (x[j + 3] - x[j]) - 3.0 * (x[j + 2] - x[j + 1]))
    }

    /// The middle one of their sizes; infinite where one is no number.
    fn middle(&self) -> f64 {
        let mut sizes = self.third_differences().map(|x| if x.is_nan() { f64::INFINITY } else { x.abs() });
        sizes.sort_by(f64::total_cmp);
        sizes[DIFFERENCES / 2]
    }

    /// Whether they change their sign as those of numbers that scatter do.
    fn change_sign(&self) -> bool {
        self.third_differences().windows(2).filter(|two| two[0] * two[1] < 0.0).count() >= CHANGES
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    /// A noise of ±1/2, the same for the same number.
    fn noise(x: f64) -> f64 {
        let hash = x.to_bits().wrapping_mul(0x9e37_79b9_7f4a_7c15);
        ((hash ^ (hash >> 29)).wrapping_mul(0xbf58_476d_1ce4_e5b9) >> 11) as f64 / (1_u64 << 53) as f64 - 0.5
    }

    fn is_rounding(at: impl Fn(f64) -> f64) -> bool {
        is_rounding_within(1e9, at)
    }

    fn is_rounding_within(reach: f64, at: impl Fn(f64) -> f64) -> bool {
        let left = Left { lengths: &[1e-9], reach, epsilon: f64::EPSILON };
        left.is_rounding(|_, s| 1e-9 * at(s))
    }

    #[test]
    fn rounding_scatters() {
        let mut told = 0;
        for k in 0..1000 {
            let (slope, from) = (0.1 + 0.003 * f64::from(k), 0.37 * f64::from(k));
            told += usize::from(is_rounding(|s| 1.0 - slope * s + noise(s + from)));
            // Less than a sixteenth of what is left.
            assert!(!is_rounding(|s| 1.0 - slope * s + 0.01 * noise(s + from)));
        }
        assert_eq!(told, 1000);
    }

    #[test]
    fn what_is_smooth_or_breaks_does_not() {
        for k in 1..400 {
            let at = 0.09 * f64::from(k) * SPACINGS[0];
            for size in [1e-12, 1e-6, 1e-3, 1.0, 1e3] {
                let bent = |s: f64| 1.0 - s + size * (s - at).max(0.0);
                let jumps = |s: f64| if s < at { 1.0 - s } else { 1.0 + size - s };
                let curved = |s: f64| 1.0 - s + size * (s / at) * (s / at);
                let cubic = |s: f64| 1.0 - s + size * (s / at).powi(3);
                let pole = |s: f64| size / (s - at);
                for left in [&bent as &dyn Fn(f64) -> f64, &jumps, &curved, &cubic, &pole] {
                    assert!(!is_rounding(left), "{k} {size:e}");
                }
            }
            // A matrix that is another one a little further on, or a root that is left behind.
            assert!(!is_rounding(|s| (1.0 - s / at) * (2.0 - s / at) + noise(s)), "{k}");
            assert!(!is_rounding(|s| 1.0 + s + noise(s)));
        }
    }

    /// Each has all that rounding has but for one thing.
    #[test]
    fn one_thing_that_rounding_does_not_do_is_enough() {
        let mut grows = 0;
        for k in 1..100 {
            let (from, at) = (0.37 * f64::from(k), 1.3e3 + 20.0 * f64::from(k));
            assert!(!is_rounding(|s| 1.0 - s + 30.0 * (1.0 + s + from).ln()), "one sign");
            // More of it further on, where that is seen at one spacing. Here chance decides.
            grows += usize::from(is_rounding_within(10.0, |s| 1.0 - s + 1e-3 * s * noise(s + from)));
            assert!(!is_rounding_within(1e3, |s| 1.0 - s + 0.9 * (s - at).max(0.0) + noise(s + from)), "a bend");
            assert!(is_rounding_within(1e3, |s| 1.0 - s + noise(s + from)));
            assert!(!is_rounding_within(1e-3, |s| 1.0 - s + noise(s + from)), "too large beside the position");
        }
        assert!(grows < 20, "{grows} of 99");
    }

    #[test]
    fn nothing_is_told_of_what_is_too_stiff_or_no_number() {
        assert!(!is_rounding(|s| 1.0 - 1e7 * s + noise(s)));
        assert!(!is_rounding(|_| f64::NAN));
    }
}
