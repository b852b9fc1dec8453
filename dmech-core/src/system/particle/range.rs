//! Forces that the scalar cannot hold.

use dmech_scalar::{Mask, Real};

use crate::law::Potential;

/// A coordinate along which the gradient is exactly 0 where the potential has a slope, and that slope.
///
/// A gradient has powers of the lengths that the potential does not have, and these may be too small for the scalar: of
/// −gm/r at r = 10¹⁵⁰ it is x/r³ with r³ = 10⁴⁵⁰. A motion without the force would look like any other. Infinite forces need
/// no such care: they are refused as they are.
///
/// The slope is that of a difference over a thousandth of the coordinate, told from rounding, from extrema, kinks and
/// points of inflection, where a gradient may be 0, by being the same on both sides and over half the distance.
///
/// A slope does not count if over the whole way to the origin it would change the kinetic energy by less than rounding does, as in the
/// far tail of a well. Pinned coordinates are left out: their gradient is 0 for another reason.
pub(crate) fn lost_force<P: Potential<D, R>, const D: usize, R: Real>(
    law: &P,
    q: [R; D],
    kinetic: f64,
    pinned: impl Fn(usize) -> bool,
) -> Option<(usize, f64)> {
    let gradient = law.gradient(q);
    if gradient.iter().all(|x| !x.equal(R::ZERO).any()) {
        return None;
    }
    let here = law.potential(q).to_f64();
    (0..D).find_map(|i| {
        let x = q[i].to_f64();
        if x == 0.0 || !gradient[i].equal(R::ZERO).any() || pinned(i) {
            return None;
        }
        let rise = |distance: f64| {
            let mut there = q;
            there[i] = R::from_f64(x + distance);
            law.potential(there).to_f64() - here
        };
        let far = x.abs() / 1024.0;
        let [down, up, half] = [-rise(-far), rise(far), rise(0.5 * far)];
        let told = up.abs() > 1024.0 * R::EPSILON.to_f64() * here.abs();
        let alike = |a: f64, b: f64| (a - b).abs() < 0.125 * up.abs();
        let felt = 1024.0 * up.abs() > R::EPSILON.to_f64() * kinetic;
        (told && felt && alike(down, up) && alike(2.0 * half, up)).then_some((i, up / far))
    })
}

#[cfg(test)]
mod tests {
    use super::lost_force;
    use crate::law::Potential;

    /// Φ by a function, with a gradient that is 0 everywhere.
    struct Flat(fn([f64; 2]) -> f64);

    impl Potential<2> for Flat {
        fn potential(&self, q: [f64; 2]) -> f64 {
            self.0(q)
        }
        fn gradient(&self, _: [f64; 2]) -> [f64; 2] {
            [0.0; 2]
        }
        fn hessian(&self, _: [f64; 2]) -> [[f64; 2]; 2] {
            [[0.0; 2]; 2]
        }
        fn discrete_gradient(&self, _: [f64; 2], _: [f64; 2]) -> [f64; 2] {
            [0.0; 2]
        }
        fn discrete_gradient_jacobian(&self, _: [f64; 2], _: [f64; 2]) -> [[f64; 2]; 2] {
            [[0.0; 2]; 2]
        }
    }

    #[test]
    fn a_slope_without_a_force_is_found() {
        for scale in [1.0, 1e-150, 1e150] {
            let (coordinate, slope) =
                lost_force(&Flat(|[x, y]| -1.0 / x.hypot(y)), [0.0, 3.0 * scale], 0.0, |_| false).unwrap();
            let expected = 1.0 / (9.0 * scale * scale);
            assert!(coordinate == 1 && (slope / expected - 1.0).abs() < 0.01, "{slope:e}, {expected:e}");
        }
        assert!(lost_force(&Flat(|[x, y]| 4.0 * (x.powi(-12) - x.powi(-6)) + y), [0.9, 0.0], 1.0, |_| false).is_some());
    }

    /// Far from a well of depth 1 whoever moves does not feel it; whoever rests would.
    #[test]
    fn a_slope_that_nobody_feels_is_not_missed() {
        let well = Flat(|[x, _]| -1.0 / (1.0 + x.exp()));
        assert_eq!(lost_force(&well, [360.0, 1.0], 1e-3, |_| false), None);
        assert!(lost_force(&well, [360.0, 1.0], 0.0, |_| false).is_none_or(|(coordinate, _)| coordinate == 0));
        let pull = Flat(|[x, y]| -1.0 / x.hypot(y));
        assert!(lost_force(&pull, [0.0, 3e150], 1e-150, |_| false).is_some());
        assert_eq!(lost_force(&pull, [0.0, 3e150], 1e-130, |_| false), None);
    }

    /// Where the gradient is 0 by right: a constant, a minimum, a maximum, a saddle, an inflection, the edges of a contact.
    #[test]
    fn a_point_without_a_slope_is_not() {
        let laws: [fn([f64; 2]) -> f64; 7] = [
            |_| 7.0,
            |[x, y]| 3.0 * (x - 1.0).powi(2) + (y - 2.0).powi(4),
            |[x, y]| 1e8 - 1e8 * (x - 1.0).powi(2) * y,
            |[x, y]| (x - 1.0) * (y - 2.0),
            |[x, _]| (x - 1.0).powi(3) - 1.0,
            |[x, y]| (x - 1.0).max(0.0).powi(2) + (y - 2.0).max(0.0),
            |[x, y]| (x - 1.0).abs() - (y - 2.0).abs(),
        ];
        for (k, law) in laws.into_iter().enumerate() {
            assert_eq!(lost_force(&Flat(law), [1.0, 2.0], 0.0, |_| false), None, "law {k}");
        }
    }
}
