//! What a discrete gradient must be, over random laws of all functions and gaps from 1 to 0: exact along the secant,
//! symmetric to the bit, the gradient where the points meet. The plain quotient is none of these.

use std::cell::{Cell, RefCell};
use std::collections::BTreeMap;

use crate::common::algebra::{Algebra, Big, big, narrow};
use crate::common::bounds::{Bound, bound};
use crate::common::laws::{Case, Law, cases};
use crate::common::notation::squared;
use crate::common::tree::{FUNCTIONS, Tree};
use crate::common::{U, Worst, for_all, ratio};
use dmech_symbolic::expression::Unary;
use dmech_symbolic::kernel::Kernels;

const GAPS: [f64; 11] = [1.0, 0.3, 1e-1, 1e-2, 1e-3, 1e-5, 1e-7, 1e-9, 1e-12, 1e-14, 1e-16];

fn exact(tree: &Tree, q: &[f64]) -> Big {
    tree.evaluate(&q.iter().map(|&x| big(x)).collect::<Vec<_>>())
}

/// |G·(b − a) − (Φ(b) − Φ(a))|, the last three operations without rounding.
fn secant_error(g: &[f64], a: &[f64], b: &[f64], rise: &Big) -> f64 {
    if g.iter().any(|x| !x.is_finite()) {
        return f64::INFINITY;
    }
    let work = (0..a.len()).fold(big(0.0), |sum, i| sum.plus(&big(g[i]).times(&big(b[i]).minus(&big(a[i])))));
    narrow(&work.minus(rise)).abs()
}

/// ∇Φ from 77 digits: a central difference whose own error is far below anything seen here.
fn exact_gradient(tree: &Tree, q: &[f64]) -> Vec<f64> {
    (0..q.len())
        .map(|i| {
            let shifted = |step: f64| {
                let mut at: Vec<_> = q.iter().map(|&x| big(x)).collect();
                at[i] = at[i].plus(&big(step));
                tree.evaluate(&at)
            };
            let step = 2f64.powi(-80);
            narrow(&shifted(step).minus(&shifted(-step)).over(&big(2.0 * step)))
        })
        .collect()
}

/// The three laws at once, and how well they are kept.
///
/// - Along the secant, |G·(b − a) − ΔΦ| in units of Σ εᵢ|bᵢ − aᵢ| u (see `common::bounds`), which vanishes with the gap;
///   and in ulp of E(a) + E(b), the magnitudes that enter Φ: |Φ| and, through the slopes, every intermediate value.
/// - Exchange of a and b: no bit may change.
/// - At a = b: |Gᵢ − ∂Φ/∂xᵢ| in units of εᵢ u.
#[test]
fn secant_identity_symmetry_and_limit() {
    let (along, in_ulps, unscaled, limit) = (Worst::new(), Worst::new(), Worst::new(), Worst::new());
    let counts = RefCell::new(BTreeMap::new());
    let moving = Cell::new(0);
    for_all(1000, &cases(), |case| {
        let mut law = Law::new(&case.tree, case.dimension());
        if !law.graph.depends_on(law.phi, &law.variables.q) {
            return;
        }
        moving.set(moving.get() + 1);
        case.tree.count(&mut counts.borrow_mut());
        let program = law.kernels().pointwise.discrete_gradient;
        let name = || law.graph.display(law.phi).to_string();
        let a = &case.a;
        let phi_a = exact(&case.tree, a);
        for gap in GAPS {
            let b = &case.b(gap);
            let g = program.run(law.at(a, b));
            let exchanged = program.run(law.at(b, a));
            for (x, y) in g.iter().zip(&exchanged) {
                assert!(x.is_finite() && x.to_bits() == y.to_bits(), "{x:e} {y:e} at {a:?}, {b:?}: {}", name());
            }
            let error = secant_error(&g, a, b, &exact(&case.tree, b).minus(&phi_a));
            let bound = bound(&case.tree, a, b);
            let place = || format!("{} at {a:?}, {b:?}", name());
            let sum = |ends: [f64; 2]| 2.0 * U * (ends[0].abs() + ends[1].abs());
            along.see(ratio(error, U * bound.secant_error(a, b)), place);
            in_ulps.see(ratio(error, sum(bound.value_error) + sum(bound.ends)), place);
            unscaled.see(ratio(error, sum(bound.ends)), place);
        }
        let g = program.run(law.at(a, a));
        let gradient = exact_gradient(&case.tree, a);
        let Bound { error, .. } = bound(&case.tree, a, a);
        for i in 0..a.len() {
            limit.see(ratio((g[i] - gradient[i]).abs(), U * error[i]), || format!("{} at {a:?}", name()));
        }
    });
    println!("{} laws that move; functions: {:?}", moving.get(), counts.borrow());
    for f in FUNCTIONS {
        assert!(counts.borrow().get(f.method()).is_some_and(|&n| n >= 10), "{f:?} hardly tried");
    }
    for name in ["+", "-", "*", "/", "powi", "powf", "atan2", "min", "max", "hypot"] {
        assert!(counts.borrow().get(name).is_some_and(|&n| n >= 10), "{name} hardly tried");
    }
    println!("secant identity unscaled: at most {:.1} ulp of |Φ(a)| + |Φ(b)|", unscaled.figure());
    in_ulps.at_most(8.0, "secant identity, ulp of |Φ(a)| + |Φ(b)|, condition-scaled");
    along.at_most(4.0, "secant identity, roundings along the secant");
    limit.at_most(4.0, "limit at a = b, roundings");
}

/// (Φ(b₁…bᵢ, aᵢ₊₁…) − Φ(b₁…bᵢ₋₁, aᵢ…))/(bᵢ − aᵢ): the plain quotient along the path that takes the coordinates in turn.
fn plain_quotient(law: &Law, kernels: &Kernels, a: &[f64], b: &[f64]) -> Vec<f64> {
    let mut at = a.to_vec();
    (0..a.len())
        .map(|i| {
            let before = kernels.pointwise.potential.run(law.at(&at, &at))[0];
            at[i] = b[i];
            let after = kernels.pointwise.potential.run(law.at(&at, &at))[0];
            (after - before) / (b[i] - a[i])
        })
        .collect()
}

/// The same three laws, tried on the plain quotient: it must fail each, or the test above proves nothing.
#[test]
fn the_plain_quotient_fails() {
    let (along, limit) = (Worst::new(), Worst::new());
    let (asymmetric, several) = (Cell::new(0), Cell::new(0));
    for_all(160, &cases(), |case| {
        let mut law = Law::new(&case.tree, case.dimension());
        if (0..case.dimension()).any(|i| !law.graph.depends_on(law.phi, &[law.variables.q[i]])) {
            return;
        }
        let kernels = law.kernels();
        let a = &case.a;
        for gap in GAPS {
            let b = &case.b(gap);
            let g = plain_quotient(&law, &kernels, a, b);
            if a == b || g.iter().any(|x| !x.is_finite()) {
                continue;
            }
            let rise = exact(&case.tree, b).minus(&exact(&case.tree, a));
            let allowed = U * bound(&case.tree, a, b).secant_error(a, b);
            along.see(ratio(secant_error(&g, a, b, &rise), allowed), || format!("{case:?} gap {gap}"));
            if gap == 1.0 && a.len() > 1 {
                several.set(several.get() + 1);
                let exchanged = plain_quotient(&law, &kernels, b, a);
                asymmetric.set(asymmetric.get() + usize::from(exchanged != g));
            }
        }
        let g = plain_quotient(&law, &kernels, a, a);
        assert!(g.iter().all(|x| x.is_nan()), "0/0 at a = b");
        let near = case.b(1e-12);
        let g = plain_quotient(&law, &kernels, a, &near);
        let Bound { error, .. } = bound(&case.tree, a, &near);
        for (i, exact) in exact_gradient(&case.tree, a).into_iter().enumerate() {
            limit.see(ratio((g[i] - exact).abs(), U * error[i]), String::new);
        }
    });
    println!("plain quotient: {:.1e} roundings along the secant, {:.1e} at the limit", along.figure(), limit.figure());
    println!("plain quotient: asymmetric in {} laws of {}", asymmetric.get(), several.get());
    assert!(along.figure() > 1e6 && limit.figure() > 1e6, "the plain quotient passes");
    assert!(several.get() >= 10 && 2 * asymmetric.get() > several.get(), "the plain quotient is symmetric");
}

/// cos(3θ) r² about the origin, across the cut of θ and over wide angles: Δθ is taken as the potential takes it.
#[test]
fn angles_turn_over_the_cut() {
    let mut law = Law::build(2, |q, p| p[1] * squared(q) * (3.0 * q[1].atan2(q[0])).cos());
    let kernels = law.kernels();
    let (identity, wide) = (Worst::new(), Cell::new(0));
    for i in 0..40 {
        for j in 0..40 {
            let point = |k: i32, r: f64| {
                let angle = 0.05 + std::f64::consts::TAU * f64::from(k) / 40.0;
                [r * angle.cos(), r * angle.sin()]
            };
            let (a, b) = (point(i, 0.9), point(j, 1.3));
            let turn = (a[0] * b[1] - a[1] * b[0]).abs().atan2(a[0] * b[0] + a[1] * b[1]);
            wide.set(wide.get() + usize::from(turn > 1.0));
            let at = law.at(&a, &b);
            let g = kernels.pointwise.discrete_gradient.run(&at);
            let exchanged = kernels.pointwise.discrete_gradient.run(law.at(&b, &a));
            assert_eq!(g, exchanged);
            let phi = |q: &[f64; 2]| kernels.pointwise.potential.run(law.at(q, q))[0];
            let (start, end) = (phi(&a), phi(&b));
            let error = (g[0] * (b[0] - a[0]) + g[1] * (b[1] - a[1]) - (end - start)).abs();
            // |Φ| ≤ p r²; its value inherits three ulp of 3θ, and the secant as many as a turn has radians.
            let scale = 1.9 * (0.81 + 1.69) * 3.0 * std::f64::consts::PI;
            identity.see(error / (2.0 * U * scale), || format!("{a:?} {b:?}"));
        }
    }
    assert!(wide.get() > 100);
    identity.at_most(2.0, "angle, ulp");
}

/// The same law for every scalar type: binary32 is as symmetric, and differs by its own roundings.
#[test]
fn binary32_and_binary64_agree() {
    let (gradient, secant) = (Worst::new(), Worst::new());
    for_all(200, &cases(), |case: Case| {
        let mut law = Law::new(&case.tree, case.dimension());
        let kernels = law.kernels();
        let rounded = |q: &[f64]| q.iter().map(|&x| x as f32).collect::<Vec<f32>>();
        let wide = |q: &[f32]| q.iter().map(|&x| f64::from(x)).collect::<Vec<f64>>();
        for gap in [1.0, 1e-2, 1e-4, 0.0] {
            let (a32, b32) = (rounded(&case.a), rounded(&case.b(gap)));
            let (a, b) = (wide(&a32), wide(&b32));
            // Parameters and numbers are rounded too: another error of each leaf, which the figures do not contain.
            let Bound { error, variation, .. } = bound(&case.tree, &a, &b);
            let run = |x: &[f32], y: &[f32]| kernels.pointwise.discrete_gradient.run(law.values(|x| x as f32, x, x, y));
            let (narrow, exchanged) = (run(&a32, &b32), run(&b32, &a32));
            let exact = kernels.pointwise.discrete_gradient.run(law.at(&a, &b));
            for i in 0..a.len() {
                assert_eq!(narrow[i].to_bits(), exchanged[i].to_bits());
                let allowed = f64::from(f32::EPSILON / 2.0) * (error[i] + variation[i]);
                let place = || format!("{} at {a:?}, {b:?}", law.graph.display(law.phi));
                secant.see(ratio((f64::from(narrow[i]) - exact[i]).abs(), allowed), place);
            }
            let slope32 = kernels.pointwise.gradient.run(law.values(|x| x as f32, &a32, &a32, &b32));
            let slope = kernels.pointwise.gradient.run(law.at(&a, &a));
            let Bound { error, variation, .. } = bound(&case.tree, &a, &a);
            for i in 0..a.len() {
                let allowed = f64::from(f32::EPSILON / 2.0) * (error[i] + variation[i]);
                let place = || format!("{} at {a:?}", law.graph.display(law.phi));
                gradient.see(ratio((f64::from(slope32[i]) - slope[i]).abs(), allowed), place);
            }
        }
    });
    gradient.at_most(4.0, "gradient in binary32, roundings");
    secant.at_most(4.0, "discrete gradient in binary32, roundings");
}

/// The secant of tanh between ends so far apart that sinh and cosh overflow in binary32, in which the closed form is ∞/∞.
/// The rounding of b − a is that of an exponent there, and counts |b − a| times.
#[test]
fn tanh_in_binary32_over_any_distance() {
    let mut law = Law::build(1, |q, _| q[0].of(Unary::Tanh));
    let kernels = law.kernels();
    for [a, b] in [
        [-3.0_f64, 2.0],
        [-30.0, 30.0],
        [-31.9, 32.1],
        [-40.0, 40.0],
        [-44.5, 44.0],
        [-50.0, 50.0],
        [-1.0, 89.0],
        [-200.0, 0.5],
    ] {
        for (a, b) in [(a, b), (b, a)] {
            let [near, far] = [[a as f32], [b as f32]];
            let slope = kernels.pointwise.discrete_gradient.run(law.values(|x| x as f32, &near, &near, &far))[0];
            let expected =
                (f64::from(far[0]).tanh() - f64::from(near[0]).tanh()) / (f64::from(far[0]) - f64::from(near[0]));
            let miss = (f64::from(slope) - expected).abs();
            let allowed = f64::from(f32::EPSILON / 2.0) * (8.0 + (b - a).abs()) * expected;
            assert!(miss <= allowed, "tanh from {a} to {b}: {slope:e} for {expected:e}");
        }
    }
}
