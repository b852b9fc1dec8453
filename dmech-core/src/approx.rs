//! Comparisons for tests, as the crate `approx` has them (feature `approx`).
//!
//! ```
//! use approx::{assert_abs_diff_eq, assert_relative_eq, assert_ulps_ne};
//! use dmech_core::State;
//!
//! let (here, beside) = (State::new([0.5, 0.0], [0.0, 1.63]), State::new([0.5, 1e-13], [0.0, 1.63]));
//! assert_abs_diff_eq!(here, beside, epsilon = 1e-12);
//! assert_relative_eq!(here, beside, epsilon = 1e-12);
//! assert_ulps_ne!(here, beside, epsilon = 0.0);
//! ```

use approx::{AbsDiffEq, RelativeEq, UlpsEq};

use crate::drift::Drift;
#[cfg(feature = "scene")]
use crate::scene::SceneState;
use crate::snapshot::Snapshot;
use crate::state::State;

/// Numbers that are compared one by one.
trait Alike {
    /// Whether there are as many of them, and all are the same to `same`.
    fn alike(&self, other: &Self, same: impl Fn(&f64, &f64) -> bool) -> bool;
}

/// Time, positions and velocities.
impl<X: Snapshot<Scalar = f64>> Alike for X {
    fn alike(&self, other: &Self, same: impl Fn(&f64, &f64) -> bool) -> bool {
        let lists = self.lists().into_iter().zip(other.lists());
        let all = |(x, y): (&[f64], &[f64])| x.len() == y.len() && x.iter().zip(y).all(|(x, y)| same(x, y));
        same(&self.time(), &other.time()) && lists.into_iter().all(all)
    }
}

/// The values at the start and at the end, and the largest deviation.
impl Alike for Drift {
    fn alike(&self, other: &Self, same: impl Fn(&f64, &f64) -> bool) -> bool {
        let numbers = |drift: &Drift| [drift.start(), drift.last(), drift.max_abs()];
        numbers(self).iter().zip(&numbers(other)).all(|(x, y)| same(x, y))
    }
}

macro_rules! compared {
    ($($(#[$only:meta])? [$($generics:tt)*] $of:ty;)*) => {$(
        $(#[$only])?
        impl<$($generics)*> AbsDiffEq for $of {
            type Epsilon = f64;

            fn default_epsilon() -> f64 {
                f64::default_epsilon()
            }
            fn abs_diff_eq(&self, other: &Self, epsilon: f64) -> bool {
                self.alike(other, |x, y| x.abs_diff_eq(y, epsilon))
            }
        }

        $(#[$only])?
        impl<$($generics)*> RelativeEq for $of {
            fn default_max_relative() -> f64 {
                f64::default_max_relative()
            }
            fn relative_eq(&self, other: &Self, epsilon: f64, max_relative: f64) -> bool {
                self.alike(other, |x, y| x.relative_eq(y, epsilon, max_relative))
            }
        }

        $(#[$only])?
        impl<$($generics)*> UlpsEq for $of {
            fn default_max_ulps() -> u32 {
                f64::default_max_ulps()
            }
            fn ulps_eq(&self, other: &Self, epsilon: f64, max_ulps: u32) -> bool {
                self.alike(other, |x, y| x.ulps_eq(y, epsilon, max_ulps))
            }
        }
    )*};
}

compared! {
    [const D: usize] State<D>;
    #[cfg(feature = "scene")] [const D: usize] SceneState<D>;
    [] Drift;
}
