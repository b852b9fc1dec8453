//! What the exact solutions need of elliptic functions, by the arithmetic-geometric mean.

/// Steps of the mean: it converges quadratically, and six reach round-off for every m < 1 − 10⁻¹⁶.
const STEPS: usize = 9;

/// The arithmetic-geometric mean of 1 and b, 0 < b: K(m) = π/(2 agm(√(1 − m))).
pub(crate) fn agm(b: f64) -> f64 {
    let (mut a, mut b) = (1.0, b);
    for _ in 0..STEPS {
        (a, b) = (0.5 * (a + b), (a * b).sqrt());
    }
    a
}

/// Jacobi's sn, cn, dn of u with parameter 0 ≤ m < 1 (Abramowitz and Stegun, 16.4).
pub(crate) fn jacobi(u: f64, m: f64) -> [f64; 3] {
    let (mut a, mut b) = (1.0, (1.0 - m).sqrt());
    let mut ratio = [0.0; STEPS];
    let mut phi = u;
    for r in &mut ratio {
        let c = 0.5 * (a - b);
        (a, b) = (0.5 * (a + b), (a * b).sqrt());
        *r = c / a;
        phi *= 2.0;
    }
    phi *= a;
    for r in ratio.iter().rev() {
        phi = 0.5 * (phi + (r * phi.sin()).asin());
    }
    let (sn, cn) = phi.sin_cos();
    [sn, cn, (1.0 - m * sn * sn).sqrt()]
}

#[cfg(test)]
mod tests {
    use super::*;

    /// K(1/2) = Γ(1/4)²/(4√π), the values at K/2 with the complementary modulus, and the limit m = 0.
    #[test]
    fn known_values() {
        let k = core::f64::consts::FRAC_PI_2 / agm(0.5_f64.sqrt());
        assert!((k - 1.854_074_677_301_372).abs() < 1e-15);
        for m in [0.1_f64, 0.5, 0.93] {
            let kc = (1.0 - m).sqrt();
            let [sn, cn, dn] = jacobi(0.5 * core::f64::consts::FRAC_PI_2 / agm(kc), m);
            assert!((sn - (1.0 + kc).recip().sqrt()).abs() < 1e-15, "{m}: {sn}");
            assert!((cn - (kc / (1.0 + kc)).sqrt()).abs() < 1e-15 && (dn - kc.sqrt()).abs() < 1e-15, "{m}");
        }
        let [sn, cn, dn] = jacobi(0.7, 0.0);
        assert!((sn - 0.7_f64.sin()).abs() < 1e-15 && (cn - 0.7_f64.cos()).abs() < 1e-15 && dn == 1.0);
    }
}
