//! Random laws through the real macro: the generated code is held against the methods as they stand in the program. `build.rs`
//! writes them.

use dmech::Potential;

/// a, b, the scale of the secant identity, the scale of Φ(a).
type Pair<const D: usize> = ([f64; D], [f64; D], f64, f64);

/// ∂f/∂xᵢ by differences on both sides, and how far it may be off; none where they do not settle.
fn slope<const D: usize>(f: &dyn Fn([f64; D]) -> f64, q: [f64; D], i: usize) -> Option<(f64, f64)> {
    let h = 1e-4 * q[i].abs().max(1e-2);
    let at = |s: f64| {
        let mut q = q;
        q[i] += s;
        f(q)
    };
    let one_sided = |s: f64| (at(s) - at(0.0)) / s;
    let [up, down, up_near, down_near] = [h, -h, h / 8.0, -h / 8.0].map(one_sided);
    let noise = 1e-13 * (at(0.0).abs() + 1e-3) / h;
    let settles = (up_near - down_near).abs() <= 0.5 * (up - down).abs() + noise;
    let (coarse, fine) = ((up + down) / 2.0, (up_near + down_near) / 2.0);
    let allowed = 4.0 * (coarse - fine).abs() + (up_near - down_near).abs() + noise + 1e-9 * fine.abs();
    (settles && fine.is_finite() && coarse.is_finite() && fine.abs() <= 1.5 * coarse.abs() + noise)
        .then_some((fine, allowed))
}

fn check<const D: usize>(
    k: usize,
    law: &impl Potential<D>,
    declared: impl Fn([f64; D]) -> f64,
    pairs: &[Pair<D>],
) -> usize {
    let mut compared = 0;
    for &(a, b, scale, value_scale) in pairs {
        let (value, generated) = (declared(a), law.potential(a));
        let miss = (generated - value).abs();
        assert!(miss <= 8.0 * f64::EPSILON * value_scale, "law {k} at {a:?} is {generated:e}, declared {value:e}");
        let gradient = law.gradient(a);
        for i in 0..D {
            let Some((slope, allowed)) = slope(&declared, a, i) else { continue };
            let miss = (gradient[i] - slope).abs();
            assert!(
                miss <= allowed,
                "law {k}: slope {i} at {a:?} is {:e}, by differences {slope:e} ± {allowed:e}",
                gradient[i]
            );
            compared += 1;
        }
        let discrete = law.discrete_gradient(a, b);
        let work: f64 = (0..D).map(|i| discrete[i] * (b[i] - a[i])).sum();
        let rise = declared(b) - value;
        let rounding: f64 = (0..D).map(|i| (discrete[i] * (b[i] - a[i])).abs()).sum();
        let allowed = f64::EPSILON * (8.0 * scale + 2.0 * rounding + 8.0 * value_scale + declared(b).abs());
        assert!(
            (work - rise).abs() <= allowed,
            "law {k}: between {a:?} and {b:?} {work:e} of {rise:e}, allowed {allowed:e}"
        );
    }
    compared
}

#[allow(warnings, clippy::all)]
mod written {
    use dmech::prelude::*;

    include!(concat!(env!("OUT_DIR"), "/random_laws.rs"));
}

#[test]
fn generated_code_agrees_with_the_users_methods() {
    let compared: usize = written::ALL.iter().map(|law| law()).sum();
    assert!(compared > 500, "{compared} slopes compared");
}
