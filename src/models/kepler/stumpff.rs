//! Stumpff's functions, which are sine and cosine, their hyperbolic kin and the powers between them at once.

/// G_n(b, s) = sⁿ c_n(b s²), n = 0 … 3: G₀ = cos √b s, G₁ = sin(√b s)/√b, and each the integral of the one before it.
///
/// For b < 0 they are cosh √−b s, … and for b = 0 the powers sⁿ/n!; nothing happens where b changes its sign.
/// # Source
/// K. Stumpff, *Himmelsmechanik* I (1959), §37; J. M. A. Danby, *Fundamentals of Celestial Mechanics* (1988), §6.9.
#[derive(Clone, Copy, Debug)]
pub(super) struct Functions {
    pub(super) g0: f64,
    pub(super) g1: f64,
    pub(super) g2: f64,
    pub(super) g3: f64,
}

/// Below this |b s²| the series are taken: at 4 nothing cancels in either form.
const NEAR: f64 = 4.0;

/// The first neglected term of c₃ is 4¹²/27! = 1.5e−21 there.
const TERMS: u32 = 12;

impl Functions {
    pub(super) fn at(b: f64, s: f64) -> Self {
        let z = b * s * s;
        let [g0, c1, c2, c3] = if z.abs() < NEAR { series(z) } else { closed(z) };
        Functions { g0, g1: s * c1, g2: s * s * c2, g3: s * s * (s * c3) }
    }

    /// Those at s + δ, for a δ whose square is lost: the rounding of s itself costs s ulp(s), this does not.
    pub(super) fn moved(self, b: f64, delta: f64) -> Self {
        let Functions { g0, g1, g2, g3 } = self;
        Functions { g0: g0 - b * g1 * delta, g1: g1 + g0 * delta, g2: g2 + g1 * delta, g3: g3 + g2 * delta }
    }
}

/// c₀ … c₃ as nested sums: c_n = (1 − z/((n+1)(n+2)) (1 − z/((n+3)(n+4)) (…)))/n!.
fn series(z: f64) -> [f64; 4] {
    let nested = |n: u32| {
        (0..TERMS).rev().fold(1.0, |sum, k| {
            let first = f64::from(n + 2 * k + 1);
            1.0 - z * sum / (first * (first + 1.0))
        })
    };
    let [c2, c3] = [nested(2) / 2.0, nested(3) / 6.0];
    [1.0 - z * c2, 1.0 - z * c3, c2, c3]
}

fn closed(z: f64) -> [f64; 4] {
    let x = z.abs().sqrt();
    if z > 0.0 {
        let [c1, half] = [x.sin() / x, (0.5 * x).sin()];
        [x.cos(), c1, 2.0 * half * half / z, (1.0 - c1) / z]
    } else {
        let [c1, half] = [x.sinh() / x, (0.5 * x).sinh()];
        [x.cosh(), c1, -2.0 * half * half / z, (1.0 - c1) / z]
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    /// Where the two forms meet they agree, on either side of the parabola, and G₀² + b G₁² = 1.
    #[test]
    fn both_forms_agree() {
        for z in [-NEAR, -3.7, 3.7, NEAR] {
            for (a, b) in series(z).into_iter().zip(closed(z)) {
                assert!((a / b - 1.0).abs() < 1e-15, "{z}: {a} {b}");
            }
        }
        for (b, s) in [(0.3, 1.2), (0.0, 2.0), (-0.3, 1.2), (1.0, 3.0), (-1.0, 3.0), (1e-30, 1e10)] {
            let Functions { g0, g1, g2, g3 } = Functions::at(b, s);
            assert!((g0 * g0 + b * g1 * g1 - 1.0).abs() < 2e-15 * (g0 * g0).max(1.0), "{b} {s}");
            assert!((g1 - s + b * g3).abs() < 1e-15 * s.max(g1) && (g2 > 0.0) && (g3 > 0.0));
        }
    }
}
