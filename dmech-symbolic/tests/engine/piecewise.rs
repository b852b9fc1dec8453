//! Piecewise laws: within a branch its own discrete gradient, across the seam the secant identity still exact, central
//! laws still central.

use crate::common::laws::Law;
use crate::common::notation::{E, choose, norm};
use crate::common::{U, Worst};
use dmech_symbolic::kernel::Kernels;

/// Points on a seam, each with a direction that crosses it there.
type Crossings = Vec<(Vec<f64>, Vec<f64>)>;

/// A law with its seam.
struct Seam {
    name: &'static str,
    law: Law,
    crossings: Crossings,
    central: bool,
}

fn seam(name: &'static str, crossings: &Crossings, phi: impl FnOnce(&[E], &[E]) -> E) -> Seam {
    let law = Law::build(crossings[0].0.len(), phi);
    Seam { name, law, crossings: crossings.clone(), central: name.contains("of r") }
}

/// k (u − c)²/2, to be used on the far side of the seam u = c.
fn spring(u: E, c: E, k: E) -> E {
    k * (u - c).powi(2) / 2.0
}

/// Laws that are continuous across u = p₀ = 0.7.
fn seams() -> Vec<Seam> {
    let line = &vec![(vec![0.7], vec![1.0]), (vec![0.7], vec![-0.37])];
    let sphere = &vec![
        (vec![0.7 * 0.6, 0.0, 0.7 * 0.8], vec![0.6, 0.1, 0.8]),
        (vec![0.0, 0.7, 0.0], vec![0.9, -0.4, 0.2]),
        (vec![-0.42, 0.56, 0.0], vec![0.1, -0.3, 1.0]),
    ];
    let bowl = &vec![(vec![0.38, 0.8], vec![1.0, 0.3]), (vec![0.7, 0.0], vec![-0.6, 0.5])];
    let bend = |q: &[E]| q[0] + q[1].powi(2) / 2.0;
    vec![
        seam("one-sided spring", line, |q, p| choose(q[0].less(p[0]), 0.3, 0.3 + spring(q[0], p[0], p[2]))),
        seam("double contact", line, |q, p| {
            let inside = choose(q[0].less(-p[0]), spring(q[0], -p[0], p[1]), 0.0);
            choose(p[0].less(q[0]), spring(q[0], p[0], p[2]), inside)
        }),
        seam("between two walls", line, |q, p| {
            let between = E::from(-5.0).less(q[0]).and(p[0].less(q[0]).negated());
            choose(between, 0.0, spring(q[0], p[0], p[2]))
        }),
        seam("soft core of r", sphere, |q, p| choose(norm(q).at_most(p[0]), spring(norm(q), p[0], p[1]), 0.0)),
        seam("linear beyond, of r", sphere, |q, p| {
            // k r²/2 up to r = p₀, then the tangent: continuous with its slope.
            let r = norm(q);
            choose(r.less(p[0]), p[1] * r * r / 2.0, p[1] * p[0] * r - p[1] * p[0] * p[0] / 2.0)
        }),
        seam("quartic in the square of r", sphere, |q, p| {
            // Normal form flattens s + s² into the terms of s.
            let s = norm(q).powi(2);
            let edge = p[0] * p[0];
            choose(norm(q).at_most(p[0]), s.powi(2) + s - edge.powi(2) - edge, 0.0)
        }),
        seam("quartic down in the square of r", sphere, |q, p| {
            let s = norm(q).powi(2);
            let edge = p[0] * p[0];
            choose(norm(q).at_most(p[0]), s.powi(2) - s - edge.powi(2) + edge, 0.0)
        }),
        seam("what both branches share", sphere, |q, p| {
            let shared = q[1] - q[0];
            (shared + norm(q).powi(2) - p[0] * p[0]).max(shared)
        }),
        seam("through one inner expression", bowl, |q, p| choose(bend(q).less(p[0]), 0.0, spring(bend(q), p[0], p[2]))),
        seam("several coordinates", bowl, |q, p| {
            let wave = q[1].sin();
            choose(bend(q).less(p[0]), wave, wave + spring(bend(q), p[0], p[2]) * q[1].exp())
        }),
        seam("absolute value", line, |q, p| p[1] * (q[0] - p[0]).abs()),
        seam("max", line, |q, p| q[0].powi(2).max(p[0] * q[0])),
        seam("min", line, |q, p| q[0].powi(2).min(p[0] * q[0])),
        seam("clamp", line, |q, p| p[2] * q[0].clamp(-p[0], p[0]).powi(2)),
    ]
}

fn ends(crossing: &(Vec<f64>, Vec<f64>), before: f64, after: f64) -> (Vec<f64>, Vec<f64>) {
    let along = |step: f64| crossing.0.iter().zip(&crossing.1).map(|(q, d)| q + step * d).collect();
    (along(-before), along(after))
}

fn value(law: &Law, kernels: &Kernels, q: &[f64]) -> f64 {
    kernels.pointwise.potential.run(law.at(q, q))[0]
}

/// |G·(b − a) − ΔΦ| within 4 ulp of |Φ(a)| + |Φ(b)| and of the slopes times the gap, symmetric, for steps that end
/// on the seam, cross it, or stay on one side.
#[test]
fn the_secant_identity_is_exact_across_the_seam() {
    for Seam { name, mut law, crossings, central } in seams() {
        let kernels = law.kernels();
        let (identity, moment) = (Worst::new(), Worst::new());
        for crossing in &crossings {
            for gap in [1.0, 0.4, 1e-1, 1e-3, 1e-6, 1e-9, 1e-12, 1e-15] {
                for (before, after) in [(0.5, 0.5), (0.3, 0.7), (0.0, 1.0), (1.0, 0.0), (-0.1, 1.0), (1.0, -0.2)] {
                    let (a, b) = ends(crossing, before * gap, after * gap);
                    let g = kernels.pointwise.discrete_gradient.run(law.at(&a, &b));
                    let exchanged = kernels.pointwise.discrete_gradient.run(law.at(&b, &a));
                    // To the bit, but for the sign of a zero: 0/(b − a) has that of the gap.
                    assert_eq!(g, exchanged, "{name}");
                    let rise = value(&law, &kernels, &b) - value(&law, &kernels, &a);
                    let work: f64 = (0..a.len()).map(|i| g[i] * (b[i] - a[i])).sum();
                    let path: f64 = (0..a.len()).map(|i| (g[i] * (b[i] - a[i])).abs()).sum();
                    // Values that enter Φ before they cancel: 1 covers the parameters' products here.
                    let scale = value(&law, &kernels, &a).abs() + value(&law, &kernels, &b).abs() + path + 1.0;
                    identity.see((work - rise).abs() / (2.0 * U * scale), || format!("{name}: {a:?} {b:?} {g:?}"));
                    if central {
                        // G is along a + b: no moment about the centre.
                        let sum: Vec<_> = a.iter().zip(&b).map(|(a, b)| a + b).collect();
                        for (i, j) in [(0, 1), (1, 2), (2, 0)] {
                            let (one, two) = (g[i] * sum[j], g[j] * sum[i]);
                            let size =
                                g.iter().map(|x| x.abs()).sum::<f64>() * sum.iter().map(|x| x.abs()).sum::<f64>();
                            let figure = if one == two { 0.0 } else { (one - two).abs() / (2.0 * U * size) };
                            moment.see(figure, || format!("{name}: {a:?} {b:?} {g:?}"));
                        }
                    }
                }
            }
        }
        identity.at_most(4.0, &format!("{name}, ulp"));
        if central {
            moment.at_most(2.0, &format!("{name}, moment, ulp"));
            assert!(kernels.structure.central.is_some(), "{name}");
        }
    }
}

/// On one side of the seam nothing is seen of it: the branch's own discrete gradient, and its gradient at a = b.
#[test]
fn each_branch_keeps_its_own_form() {
    let mut law = Law::build(1, |q, p| choose(q[0].less(p[0]), 0.3, 0.3 + spring(q[0], p[0], p[2])));
    let kernels = law.kernels();
    let [c, k] = [0.7, 3.3];
    for (a, b) in [(0.1, 0.6), (-2.0, 0.69), (0.5, 0.5)] {
        assert_eq!(kernels.pointwise.discrete_gradient.run(law.at(&[a], &[b])), [0.0]);
    }
    for (a, b) in [(0.8, 2.9), (0.71, 0.7100001), (1.3, 1.3)] {
        let expected = k * ((a + b) / 2.0 - c);
        let g = kernels.pointwise.discrete_gradient.run(law.at(&[a], &[b]))[0];
        assert!((g - expected).abs() <= 4.0 * U * k * (a + b + c), "{g} {expected}");
    }
    // Across: the plain quotient.
    let g = kernels.pointwise.discrete_gradient.run(law.at(&[0.2], &[1.2]))[0];
    assert!((g - k * 0.25 / 2.0).abs() < 1e-15, "{g}");
    // The gradient and the Hessian are those of the branch.
    assert_eq!(kernels.pointwise.gradient.run(law.at(&[0.2], &[0.2])), [0.0]);
    let slope = kernels.pointwise.gradient.run(law.at(&[1.2], &[1.2]))[0];
    assert!((slope - k * 0.5).abs() < 1e-15, "{slope}");
    assert_eq!(kernels.pointwise.hessian.run(law.at(&[1.2], &[1.2])), [k]);
    assert_eq!(kernels.pointwise.hessian.run(law.at(&[0.2], &[0.2])), [0.0]);
}

/// The tangent-continued oscillator is smooth in its slope: its discrete gradient approaches the gradient from both
/// sides of the seam as the gap closes, at first order.
#[test]
fn the_quotient_approaches_the_gradient() {
    let Seam { mut law, crossings, .. } =
        seams().into_iter().find(|s| s.name == "linear beyond, of r").expect("listed");
    let kernels = law.kernels();
    for crossing in &crossings {
        let slope = kernels.pointwise.gradient.run(law.at(&crossing.0, &crossing.0));
        let error = |gap: f64| -> f64 {
            let (a, b) = ends(crossing, 0.5 * gap, 0.5 * gap);
            let g = kernels.pointwise.discrete_gradient.run(law.at(&a, &b));
            g.iter().zip(&slope).map(|(x, y)| (x - y).abs()).fold(0.0, f64::max)
        };
        let (coarse, fine) = (error(1e-2), error(1e-4));
        assert!(coarse < 1e-1 && fine < 1.2e-2 * coarse, "{coarse} {fine}");
    }
}

/// Up to a flat seam nothing changes, from there on the branch has its own form: ∇̄Φ = (1 − λ) ∇̄no(p, b) with p on the seam.
/// What the branch would be on the other side is huge here, and no number.
#[test]
fn what_a_branch_would_be_elsewhere_does_not_matter() {
    let mut law = Law::build(4, |q, p| {
        choose(q[0].less(p[0]), 0.0, (q[0] - p[0]) * (q[1] * q[2] + q[3] * q[1] * q[2] * q[0].sqrt()))
    });
    let kernels = law.kernels();
    let (a, b) = ([-3.3, 26.8, -6.9, 4.2], [0.9, -0.6, 0.5, 1.3]);
    let share = (0.7 - a[0]) / (b[0] - a[0]);
    let p: Vec<f64> = a.iter().zip(&b).map(|(a, b)| a + share * (b - a)).collect();
    let g = kernels.pointwise.discrete_gradient.run(law.at(&a, &b));
    let beyond = kernels.pointwise.discrete_gradient.run(law.at(&p, &b));
    for (i, (g, beyond)) in g.iter().zip(&beyond).enumerate() {
        let expected = (1.0 - share) * beyond;
        assert!(beyond.abs() > 1e-3 && (g - expected).abs() <= 1e-14 * expected.abs(), "{i}: {g} {expected}");
    }
}

/// A nucleus at the edge of a field: what both branches have is formed as it is without the field, so that the moment about the
/// normal is kept to rounding, and the way between the ends may pass through the centre.
#[test]
fn what_both_branches_have_is_not_cut() {
    let mut law = Law::build(3, |q, p| {
        let well = -p[1] / norm(q);
        choose(q[2].at_most(0.0), well, well + p[2] * q[2])
    });
    let kernels = law.kernels();
    let a = [0.3, -0.7, 0.4];
    for b in [[0.5, -0.4, -0.3], [-0.2, 0.9, -1.1], [-0.3, 0.7, -0.4], [-0.3, 0.7, -0.4 - 1e-9]] {
        let g = kernels.pointwise.discrete_gradient.run(law.at(&a, &b));
        let rise = value(&law, &kernels, &b) - value(&law, &kernels, &a);
        let work: f64 = (0..3).map(|i| g[i] * (b[i] - a[i])).sum();
        assert!((work - rise).abs() < 16.0 * U * 10.0, "{b:?}: {g:?} makes {work} of {rise}");
        let moment = g[0] * (a[1] + b[1]) - g[1] * (a[0] + b[0]);
        assert!(moment.abs() <= 8.0 * U * g[0].hypot(g[1]), "{b:?}: {g:?} has a moment of {moment:e}");
    }
}

/// The same with a capped well, which is a choice itself: by b = −a the way between the ends passes through its centre, and what
/// both branches have has no part in the crossing.
#[test]
fn what_both_branches_have_may_be_singular_on_the_seam() {
    let mut law = Law::build(2, |q, p| {
        let capped = E::from(1.0).min(4.0 * (q[0].powi(-12) - q[0].powi(-6)));
        choose(q[1].at_most(0.0), capped, capped + p[2] * q[1].powi(3) * q[0].cos())
    });
    let kernels = law.kernels();
    for a in [[1.4, 1.2], [-0.9, 0.3], [2.0, -1.1]] {
        let b = a.map(|x: f64| -x);
        let g = kernels.pointwise.discrete_gradient.run(law.at(&a, &b));
        let rise = value(&law, &kernels, &b) - value(&law, &kernels, &a);
        let work: f64 = (0..2).map(|i| g[i] * (b[i] - a[i])).sum();
        assert!((work - rise).abs() < 16.0 * U * 10.0, "from {a:?} to its opposite {g:?} makes {work} of {rise}");
        let jacobian = kernels.pointwise.discrete_gradient_jacobian.run(law.at(&a, &b));
        assert!(jacobian.iter().all(|x| x.is_finite()), "from {a:?} to its opposite {jacobian:?}");
    }
}

/// A contact whose overlap is a sum: at two places where it is 0 but for rounding the sums at the ends differ by less than
/// their rounding, and the sum that is their difference may be 0 where they are not.
#[test]
fn ends_within_rounding_of_a_contact_are_finite() {
    let mut met = 0;
    for exponent in [1.25, 4.0 / 3.0, 1.5, 2.5] {
        let mut law = Law::build(2, |q, p| (p[0] - (q[0] + 2.0 * q[1])).max(E::from(0.0)).powf(E::from(exponent)));
        let kernels = law.kernels();
        let touching = |k: u32| {
            let y = (f64::from(k) * 0.618_033_988_749).fract() * 3.0 - 1.5;
            [(0..k % 4).fold(0.7 - 2.0 * y, |x, _| x.next_down()), y]
        };
        for k in 0..200 {
            let (a, b) = (touching(k), touching(k + 71));
            let overlaps = [a, b].map(|[x, y]| 0.7 - (x + 2.0 * y));
            met += u32::from(overlaps[0] != overlaps[1] && overlaps[0].max(overlaps[1]) > 0.0);
            for program in [&kernels.pointwise.discrete_gradient, &kernels.pointwise.discrete_gradient_jacobian] {
                let found = program.run(law.at(&a, &b));
                assert!(found.iter().all(|x| x.is_finite()), "u^{exponent} from {a:?} to {b:?}: {found:?}");
            }
        }
    }
    assert!(met > 100, "{met} pairs with different overlaps");
}
