//! Where something is 0 or infinite and the law is not: choices and products of roots have the limits that they should.

use dmech_symbolic::calculus;
use dmech_symbolic::expression::Unary;
use dmech_symbolic::kernel::Pointwise;
use dmech_symbolic::program::{Operation, Program};

use crate::common::laws::Law;
use crate::common::notation::{E, choose, norm, squared};
use crate::common::tree::PARAMETERS;

/// A law in coordinates and parameters.
type Formula = fn(&[E], &[E]) -> E;

fn gradient(law: &mut Law, q: &[f64]) -> Vec<f64> {
    law.kernels().pointwise.gradient.run(law.at(q, q))
}

/// A power that undoes a root goes into the branches: (cosh x ∛x)³ is x cosh³ x, also where it is clamped; a spring on a
/// distance that is capped has no root at all.
#[test]
fn powers_undo_roots_within_choices() {
    let mut cubed = Law::build(1, |q, _| (q[0].of(Unary::Cosh) * q[0].cbrt()).clamp(-0.5, 2.0).powi(3));
    assert_eq!(gradient(&mut cubed, &[0.0]), [1.0]);
    let mut capped = Law::build(2, |q, p| p[1] * norm(q).min(p[0]).powi(2));
    assert_eq!(gradient(&mut capped, &[0.0, 0.0]), [0.0, 0.0]);
    assert_eq!(gradient(&mut capped, &[0.3, 0.0]), [2.0 * 1.9 * 0.3, 0.0]);
    assert_eq!(gradient(&mut capped, &[3.0, 4.0]), [0.0, 0.0]);
}

/// (x y) ∛(x y) is (x y)^{4/3}, (x y) √(x y) is (x y)^{3/2}: between ends at which one factor or the other is nearly 0 the
/// discrete gradient is as large as the slopes are on the way, and not the steep slope of the root times the means of the
/// factors.
#[test]
fn roots_of_products_are_joined_with_their_factors() {
    for root in [Unary::Cbrt, Unary::Sqrt] {
        let mut law = Law::build(2, |q, _| (q[0] * q[1]).of(root) * (q[0] * q[1]));
        let kernels = law.kernels();
        let (a, b) = ([0.25, 1e-9], [1e-9, 0.5]);
        let g = kernels.pointwise.discrete_gradient.run(law.at(&a, &b));
        assert!(g.iter().all(|g| g.abs() < 1e-2), "{root:?}: {g:?}");
    }
}

/// A root that vanishes on the seam of its branch: the step passes there, and the Newton matrix is finite.
#[test]
fn roots_may_vanish_on_a_seam() {
    let mut smooth = Law::build(2, |q, _| choose(q[1].less(0.0), 0.0, norm(q).of(Unary::Sinh) * q[1].powi(2)));
    let jacobian = smooth.kernels().pointwise.discrete_gradient_jacobian.run(smooth.at(&[0.0, 0.25], &[0.0, -1.0]));
    assert!(jacobian.iter().all(|x| x.is_finite()), "through the centre {jacobian:?}");
    let mut law = Law::build(2, |q, _| choose(q[1].at_most(0.0), (q[0] * q[1]).hypot(q[1]), 0.0));
    let kernels = law.kernels();
    let mut vanished = 0;
    for k in 1..200 {
        let (a, b) = ([-1.7, 0.37 * f64::from(k)], [0.23, -0.86]);
        let jacobian = kernels.pointwise.discrete_gradient_jacobian.run(law.at(&a, &b));
        assert!(jacobian.iter().all(|x| x.is_finite()), "{a:?} to {b:?}: {jacobian:?}");
        let share = a[1] / (a[1] - b[1]);
        vanished += u32::from((1.0 - share) * a[1] + share * b[1] == 0.0);
    }
    assert!(vanished > 3, "in {vanished} steps the seam was met exactly");
}

/// A well that is infinite at its centre and capped there: the value that the choice is made by is infinite, not no number,
/// whatever the slopes of the law have in common with it.
#[test]
fn what_is_capped_may_be_infinite() {
    for power in [1, 3] {
        let mut law = Law::build(2, |q, _| E::from(10.0).min(norm(q).powi(-power)));
        assert_eq!(gradient(&mut law, &[0.0, 0.0]), [0.0, 0.0], "1/r^{power}");
        let slope = gradient(&mut law, &[2.0, 0.0]);
        assert_eq!(slope, [-f64::from(power) * 0.5_f64.powi(power + 1), -0.0], "1/r^{power}");
    }
}

/// What is no number stays none where it is clamped, as in Rust, and in each derivative; `max` and `min` give the other of the two.
#[test]
fn what_is_no_number_is_not_clamped() {
    let root = |q: &[E]| (1.0 - q[0].powi(2)).sqrt();
    let mut clamped = Law::build(1, |q, _| root(q).clamp(0.0, 0.9));
    let mut beside = Law::build(2, |q, _| (root(q) + q[1]).clamp(0.0, 0.9));
    for law in [&mut clamped, &mut beside] {
        let (inside, outside) = ([0.6, 0.05], [1.5, 0.05]);
        let n = law.variables.q.len();
        let kernels = law.kernels();
        let Pointwise { potential, gradient, discrete_gradient, .. } = &kernels.pointwise;
        for kernel in [potential, gradient] {
            assert!(kernel.run(law.at(&inside[..n], &inside[..n]))[0].is_finite());
            assert!(kernel.run(law.at(&outside[..n], &outside[..n]))[0].is_nan());
        }
        for [a, b] in [[inside, outside], [outside, inside]] {
            assert!(discrete_gradient.run(law.at(&a[..n], &b[..n]))[0].is_nan());
        }
    }
    let mut larger = Law::build(1, |q, _| root(q).max(0.25));
    assert_eq!(larger.kernels().pointwise.potential.run(larger.at(&[1.5], &[1.5])), [0.25]);
}

/// A power that went into a choice loses no digits: an odd one compares the powers themselves, and an even one stays outside
/// where the root that the choice is made by would remain.
#[test]
fn powers_within_choices_keep_their_digits() {
    let mut odd = Law::build(2, |q, _| q[1].min(q[0].cbrt()).clamp(0.0, 0.5).powi(3));
    let mut even = Law::build(2, |q, _| ((q[1].powi(2) + q[0]).sqrt() / q[1].powi(2)).clamp(-1.0, 1.0).powi(2));
    let far = [[246.42340084359557, -1510.9167798084866], [-1.6005803964763388, -1.3592586450085888]];
    for (law, [a, b], allowed) in [(&mut odd, [[1e-9, 0.25], [-1.0, 0.25]], 1e-24), (&mut even, far, 1e-11)] {
        let kernels = law.kernels();
        let g = kernels.pointwise.discrete_gradient.run(law.at(&a, &b));
        let [start, end] = [a, b].map(|q| kernels.pointwise.potential.run(law.at(&q, &q))[0]);
        let work: f64 = (0..2).map(|i| g[i] * (b[i] - a[i])).sum();
        assert!((work - (end - start)).abs() < allowed, "{g:?} makes {work:e} of {:e}", end - start);
    }
}

/// cos k|q|, cosh k|q| and its inverse are as smooth at the centre as elsewhere: the Newton matrix there is the derivative of the discrete
/// gradient, and half of the Hessian where both ends meet.
#[test]
fn even_functions_of_a_distance_are_smooth_at_the_centre() {
    let distance = |q: &[E]| (q[0].powi(2) + 4.0 * q[1].powi(2)).sqrt();
    for (f, n, scaled) in
        [(Unary::Cos, 1, false), (Unary::Cosh, 1, false), (Unary::Cos, 1, true), (Unary::Cosh, -1, true)]
    {
        let mut law = Law::build(2, |q, p| {
            let r = distance(q);
            (if scaled { 0.7 * r / p[1] } else { r }).of(f).powi(n)
        });
        assert_eq!(gradient(&mut law, &[0.0, 0.0]), [0.0, 0.0], "{f:?}");
        let kernels = law.kernels();
        let secant = |a: &[f64], b: &[f64]| kernels.pointwise.discrete_gradient.run(law.at(a, b));
        let hessian = kernels.pointwise.hessian.run(law.at(&[0.0, 0.0], &[0.0, 0.0]));
        for a in [[0.0, 0.0], [0.3, -0.2], [1.1, 0.7]] {
            let jacobian = kernels.pointwise.discrete_gradient_jacobian.run(law.at(&a, &[0.0, 0.0]));
            for j in 0..2 {
                let [mut low, mut high] = [[0.0, 0.0]; 2];
                (low[j], high[j]) = (-1e-5, 1e-5);
                let (low, high) = (secant(&a, &low), secant(&a, &high));
                for i in 0..2 {
                    let difference = (high[i] - low[i]) / 2e-5;
                    let found = jacobian[2 * i + j];
                    assert!((found - difference).abs() < 1e-8, "{f:?} from {a:?}: {found} and {difference}");
                    assert!(a != [0.0, 0.0] || found == 0.5 * hessian[2 * i + j], "{found} {hessian:?}");
                }
            }
        }
    }
}

/// What is of an order above the first where a root in it vanishes: by its factors, its function, or what is below it. At rest there
/// nothing acts.
#[test]
fn roots_of_a_higher_order_have_a_centre() {
    let laws: [fn(&[E]) -> E; 13] = [
        |q| (q[0].abs().powi(3) + q[1].powi(4)).sqrt(),
        |q| (q[0].abs().powf(2.8) + q[1].powi(4)).sqrt(),
        |q| norm(q) * norm(q).of(Unary::Tanh),
        |q| norm(q).sqrt().powi(3),
        |q| squared(q).cbrt().powi(2),
        |q| norm(q) * norm(q).sin(),
        |q| norm(q).of(Unary::Tanh).powi(2),
        |q| norm(q) * (q[0] - 2.0 * q[1]),
        |q| (q[0].powi(4) + q[1].powi(4)).sqrt(),
        |q| (q[0].powi(4) + 3.0 * q[1].powi(6)).cbrt(),
        |q| 0.5 * (q[0].powi(4) + q[1].powi(4)).sqrt() + q[0].powi(2),
        |q| (norm(q).powi(3) + q[1].powi(4)).sqrt(),
        |q| norm(q).of(Unary::Sinh) * norm(q).of(Unary::Asinh),
    ];
    for (k, formula) in laws.into_iter().enumerate() {
        let mut law = Law::build(2, |q, _| formula(q));
        let kernels = law.kernels();
        let centre = law.at(&[0.0, 0.0], &[0.0, 0.0]);
        assert_eq!(kernels.pointwise.discrete_gradient.run(&centre), [0.0, 0.0], "{k}");
        assert_eq!(gradient(&mut law, &[0.0, 0.0]), [0.0, 0.0], "{k}");
        assert!(kernels.pointwise.hessian.run(&centre).iter().all(|x| x.is_finite()), "{k}");
        for (a, b) in
            [([0.0, 0.0], [0.0, 0.0]), ([0.0, 0.0], [0.3, -0.2]), ([0.3, -0.2], [0.0, 0.0]), ([0.3, 0.0], [0.2, 0.0])]
        {
            let slope = kernels.pointwise.discrete_gradient.run(law.at(&a, &b));
            let work: f64 = (0..2).map(|i| slope[i] * (b[i] - a[i])).sum();
            let [start, end] = [a, b].map(|q| kernels.pointwise.potential.run(law.at(&q, &q))[0]);
            assert!((work - (end - start)).abs() < 1e-15, "{k} from {a:?} to {b:?}");
            let matrix = kernels.pointwise.discrete_gradient_jacobian.run(law.at(&a, &b));
            assert!(matrix.iter().all(|x| x.is_finite()), "{k} from {a:?} to {b:?}: {matrix:?}");
        }
    }
}

/// What is of an order above the first only as a whole, such as eʳ − r − 1, has a slope of 0 where r vanishes, and the second derivative
/// that it comes to there; with a slope of its own, however small, it has none.
#[test]
fn wholes_of_a_higher_order_have_a_centre() {
    fn elsewhere(q: &[E], p: &[E]) -> E {
        let r = ((q[0] - p[1]).powi(2) + 4.0 * (q[1] - p[2]).powi(2)).sqrt();
        p[0] * (r.exp() - r)
    }
    let at_rest: [(Formula, [f64; 2]); 26] = [
        (|q, p| p[0] * (norm(q).exp() - norm(q) - 1.0), [1.0, 1.0]),
        (|q, p| p[0] * ((p[1] * norm(q)).exp() - p[1] * norm(q)) / p[1].powi(2), [1.0, 1.0]),
        (|q, p| p[0] * (norm(q) - (1.0 + norm(q)).ln()), [1.0, 1.0]),
        (|q, p| p[0] * (norm(q) / p[1] - (norm(q) / p[1]).of(Unary::Ln1p)) * p[1].powi(2), [1.0, 1.0]),
        (|q, p| p[0] * (norm(q) - norm(q).sin()), [0.0, 0.0]),
        (|q, p| p[0] * (norm(q) - norm(q).of(Unary::Tanh)), [0.0, 0.0]),
        (|q, p| 0.5 * p[0] * (1.0 - (-norm(q)).exp()).powi(2), [1.0, 1.0]),
        (|q, p| p[0] * (norm(q) + 1.0 / (1.0 + norm(q))), [2.0, 2.0]),
        (|q, p| p[0] * norm(q) * norm(q).sin(), [2.0, 2.0]),
        (|q, p| p[0] * (norm(q).exp() - norm(q)) + q[0].powi(2) * norm(q), [1.0, 1.0]),
        (|q, p| p[0] * (norm(q).exp() - norm(q) * (1.0 - q[0])), [1.0, 1.0]),
        (|q, p| p[0] * choose(q[1].less(2.0), norm(q).exp() - norm(q), 1.0), [1.0, 1.0]),
        // Choices by the distance itself: a plateau, Wendland's kernel, one of three pieces, with another variable beside.
        (|q, p| p[0] * choose(norm(q).less(0.5), norm(q).exp() - norm(q), 0.5_f64.exp() - 0.5), [1.0, 1.0]),
        (
            |q, p| p[0] * choose(norm(q).less(0.5), (1.0 - 2.0 * norm(q)).powi(4) * (1.0 + 8.0 * norm(q)), 0.0),
            [-80.0, -80.0],
        ),
        (|q, p| p[0] * (norm(q) - (1.0 + norm(q)).ln()).min(0.04), [1.0, 1.0]),
        (
            |q, p| {
                let within = choose(norm(q).less(0.25), norm(q) - norm(q).sin(), 0.25 - 0.25_f64.sin());
                p[0] * choose(norm(q).less(0.5), within, (norm(q) - 0.5).powi(2) + 0.25 - 0.25_f64.sin())
            },
            [0.0, 0.0],
        ),
        (
            |q, p| {
                let depth = norm(q).exp() - norm(q) - (0.5_f64.exp() - 0.5);
                p[0] * choose(norm(q).less(0.5), depth * (1.0 + q[0].powi(2)), 0.0)
            },
            [1.0 + 2.0 * (1.5 - 0.5_f64.exp()), 1.0],
        ),
        // Choices that have a cusp of their own, and not with what stands beside them.
        (|q, p| p[0] * (1.0 - 2.0 * norm(q)).max(0.0).powi(4) * (1.0 + 8.0 * norm(q)), [-80.0, -80.0]),
        (
            |q, p| {
                let wide = (p[1] - norm(q)).max(0.0).powi(4) * (p[1] + 4.0 * norm(q));
                let narrow = (1.0 - 2.0 * norm(q)).max(0.0) * (2.0 * norm(q)).exp();
                p[0] * (wide + narrow)
            },
            [-20.0 * PARAMETERS[1].powi(3) - 4.0; 2],
        ),
        (|q, p| p[0] * (q[0] + 2.0) * (0.5 - norm(q)).max(0.0) * (2.0 * norm(q)).exp() - p[0] * q[0] / 2.0, [-4.0; 2]),
        // With squares and coordinates of each end beside its root.
        (|q, p| p[0] * ((norm(q) + squared(q)).exp() - norm(q)), [3.0, 3.0]),
        (|q, p| p[0] * ((q[0] + norm(q)).exp() - norm(q) * q[0].exp()) - p[0] * q[0], [2.0, 1.0]),
        (|q, p| p[0] * (norm(q).exp() - norm(q)) / (2.0 + q[0]) - p[0] / (2.0 + q[0]), [0.5, 0.5]),
        (|q, p| p[0] * ((1.0 + norm(q)).powf(p[1]) - p[1] * norm(q)), [PARAMETERS[1] * (PARAMETERS[1] - 1.0); 2]),
        (
            |q, p| {
                let r = (squared(q) + squared(q).powi(2)).sqrt();
                p[0] * (r.exp() - r)
            },
            [1.0, 1.0],
        ),
        (|q, p| p[0] * norm(q) * q[0] + p[0] * (norm(q).exp() - norm(q)), [1.0, 1.0]),
    ];
    let elsewhere: (Formula, [f64; 2]) = (elsewhere, [1.0, 4.0]);
    let laws = at_rest.into_iter().map(|law| (law, [0.0; 2])).chain([(elsewhere, [PARAMETERS[1], PARAMETERS[2]])]);
    for (k, ((formula, second), centre)) in laws.enumerate() {
        let mut law = Law::build(2, formula);
        assert_eq!(gradient(&mut law, &centre), [0.0, 0.0], "{k}");
        let kernels = law.kernels().pointwise;
        let second = second.map(|x| x * PARAMETERS[0]);
        let there = law.at(&centre, &centre);
        let close = |found: &[f64], factor: f64| {
            let expected = [second[0] * factor, 0.0, 0.0, second[1] * factor];
            (0..4).all(|i| (found[i] - expected[i]).abs() < 1e-14)
        };
        let hessian = kernels.hessian.run(&there);
        assert!(close(&hessian, 1.0), "{k}: {hessian:?}");
        assert_eq!(kernels.discrete_gradient.run(&there), [0.0, 0.0], "{k}");
        let matrix = kernels.discrete_gradient_jacobian.run(&there);
        assert!(close(&matrix, 0.5), "{k}: {matrix:?}");
        let places = [[0.0, 0.0], [0.3, -0.2], [0.0, 0.7], [1e-5, 0.0], [0.0, 1e-9], [3e-160, 4e-160]];
        let places = places.map(|place| [centre[0] + place[0], centre[1] + place[1]]);
        for (a, b) in places.iter().flat_map(|a| places.iter().map(move |b| (a, b))) {
            let slope = kernels.discrete_gradient.run(law.at(a, b));
            let work: f64 = (0..2).map(|i| slope[i] * (b[i] - a[i])).sum();
            let [start, end] = [a, b].map(|q| kernels.potential.run(law.at(q, q))[0]);
            assert!((work - (end - start)).abs() < 1e-14, "{k} from {a:?} to {b:?}: {work}, {}", end - start);
            let matrix = kernels.discrete_gradient_jacobian.run(law.at(a, b));
            assert!(matrix.iter().all(|x| x.is_finite()), "{k} from {a:?} to {b:?}: {matrix:?}");
        }
    }
    // Between there and where the quotient has its digits the Hessian keeps its own.
    let mut law = Law::build(2, |q, p| p[0] * (norm(q).exp() - norm(q)));
    let hessian = law.kernels().pointwise.hessian;
    for k in 1..320 {
        let q = [0.6 * 10f64.powi(-k), -0.8 * 10f64.powi(-k)];
        let found = hessian.run(law.at(&q, &q));
        let bound = PARAMETERS[0] * (2.0 * 10f64.powi(-k)).max(1e-7);
        let right = [PARAMETERS[0], 0.0, 0.0, PARAMETERS[0]];
        assert!((0..4).all(|i| (found[i] - right[i]).abs() < bound), "at {q:?}: {found:?}");
    }
    for k in 1..19 {
        let q = [0.6 * 10f32.powi(-k), -0.8 * 10f32.powi(-k)];
        let found = hessian.run(law.values(|x| x as f32, &q, &q, &q));
        let right = [PARAMETERS[0] as f32, 0.0, 0.0, PARAMETERS[0] as f32];
        let bound = right[0] * (2.0 * 10f32.powi(-k)).max(3e-3);
        assert!((0..4).all(|i| (found[i] - right[i]).abs() < bound), "at {q:?}: {found:?}");
    }
    let cusps: [Formula; 13] = [
        |q, p| p[0] * (1.0 - 2.0 * norm(q)).max(0.0).powi(4) * (1.0 + 7.0 * norm(q)),
        |q, _| norm(q).exp() - 0.999 * norm(q),
        |q, p| norm(q).exp() - p[0] * norm(q),
        |q, _| norm(q) - 2.0 * (1.0 + norm(q)).ln(),
        |q, _| norm(q).sin() + q[0],
        |q, _| norm(q).exp() - norm(q) * (1.0 - norm(q).sin() / norm(q)),
        |q, _| norm(q).sqrt().exp() - norm(q).sqrt(),
        |q, _| norm(q).sin() + q[0] * norm(q),
        |q, _| norm(q).of(Unary::Tanh) + q[0] * norm(q) + q[1].powi(2),
        |q, _| norm(q) * (q[0] - 1.0),
        |q, p| norm(q).sin() * (q[0] + p[1]),
        |q, _| norm(q) * (q[0] + 1.0) * (q[1] + 2.0),
        |q, _| norm(q) * ((q[0] - 1.0).powi(2) + q[1].powi(2)).sqrt(),
    ];
    for (k, formula) in cusps.into_iter().enumerate() {
        let mut law = Law::build(2, formula);
        let found = gradient(&mut law, &[0.0, 0.0]);
        assert!(found.iter().any(|x| !x.is_finite()), "{k}: {found:?}");
    }
}

/// Where the slope along r is 0 for the direction, on a line through the centre, and not for the distance, the second derivatives are
/// those of the law: nothing there is a limit.
#[test]
fn lines_through_a_centre_are_none() {
    fn shifted(q: &[E], p: &[E]) -> E {
        ((q[0] - p[1]).powi(2) + 4.0 * (q[1] - p[2]).powi(2)).sqrt()
    }
    let laws: [Formula; 14] = [
        |q, p| (q[0] - p[1]) * shifted(q, p),
        |q, p| (q[0] - p[1]) * shifted(q, p).exp(),
        |q, p| (q[0] - p[1]) * (shifted(q, p).exp() - shifted(q, p)),
        |q, p| (q[0] - p[1]) * (q[1] - p[2]) * (shifted(q, p).exp() - shifted(q, p)),
        |q, p| p[0] * (q[0] - p[1]).powi(2) * (shifted(q, p).sin() - shifted(q, p)),
        |q, p| (q[0] - p[1]) * shifted(q, p).exp() - (q[1] - p[2]) * shifted(q, p).exp(),
        |q, p| {
            (q[0] - p[1]) * (shifted(q, p).exp() - shifted(q, p))
                + (q[1] - p[2]) * (shifted(q, p).exp() - shifted(q, p))
        },
        |q, p| (q[0] - p[1]) * (q[1] + p[2]) * (1.0 - shifted(q, p)).max(0.0).powi(4) * (1.0 + 4.0 * shifted(q, p)),
        |q, _| q[0] * norm(q).exp(),
        |q, p| p[0] * q[0] * (norm(q).exp() - norm(q)),
        |q, p| p[0] * q[0] * (norm(q).exp() - norm(q)) - p[0] * q[1] * (norm(q).exp() - norm(q)),
        |q, p| q[0].sin() * (norm(q) - norm(q).sin()) + p[0] * q[1] * (norm(q) - norm(q).sin()),
        |q, p| p[0] * (q[0] * norm(q).exp() + norm(q).exp() - norm(q)) + q[1] * (1.0 + norm(q)).ln(),
        |q, p| (1.0 + p[0] * q[0] * q[1]) * (norm(q).exp() - norm(q)),
    ];
    for (k, formula) in laws.into_iter().enumerate() {
        let mut law = Law::build(2, formula);
        let [x, y] = if k < 8 { [PARAMETERS[1], PARAMETERS[2]] } else { [0.0; 2] };
        let kernels = law.kernels().pointwise;
        for [u, w] in [[0.0, 0.25], [0.125, 0.0], [-0.25, 0.25], [0.25, 0.25], [0.125, -0.125], [0.1875, 0.25]] {
            let (a, b) = ([x + u, y + w], [x - 2.0 * u, y + 1.5 * w]);
            let across = [x - u, y + 1.5 * w];
            let h = 1e-4;
            let hessian = kernels.hessian.run(law.at(&a, &a));
            let [straight, crossed] = [b, across].map(|b| kernels.discrete_gradient_jacobian.run(law.at(&a, &b)));
            for j in 0..2 {
                // Of fourth order.
                let mut rise = |of: &mut dyn FnMut(&mut Law, [f64; 2]) -> Vec<f64>, from: [f64; 2]| {
                    let mut at = |s: f64| {
                        let mut q = from;
                        q[j] += s * h;
                        of(&mut law, q)
                    };
                    let [p2, p1, m1, m2] = [2.0, 1.0, -1.0, -2.0].map(&mut at);
                    [0, 1].map(|i| (8.0 * (p1[i] - m1[i]) - (p2[i] - m2[i])) / (12.0 * h))
                };
                let slopes = rise(&mut |law, q| kernels.gradient.run(law.at(&q, &q)), a);
                let [along, aside] =
                    [b, across].map(|b| rise(&mut |law, q| kernels.discrete_gradient.run(law.at(&a, &q)), b));
                for i in 0..2 {
                    for (found, right) in [(&hessian, slopes[i]), (&straight, along[i]), (&crossed, aside[i])]
                        .map(|(m, r)| (m[2 * i + j], r))
                    {
                        assert!(
                            (found - right).abs() < 1e-9 * (1.0 + right.abs()),
                            "{k} at {u}, {w}: {found}, {right}"
                        );
                    }
                }
            }
        }
    }
}

/// |q|^p with a parameter p > 1 is least at the centre, whatever units |q| has, and no slope is infinite on the way there.
#[test]
fn powers_of_distances_have_a_centre() {
    for p in [1.25, 2.0, 3.0, 4.0] {
        for scaled in [false, true] {
            let mut law = Law::build(2, |q, f| {
                let r = norm(q);
                (if scaled { r / f[1] } else { r }).powf(0.5 * p * f[1].of(Unary::Round))
            });
            assert_eq!(gradient(&mut law, &[0.0, 0.0]), [0.0, 0.0], "p = {p}");
            let kernels = law.kernels();
            let centre = [0.0, 0.0];
            for place in [[0.0, 0.0], [0.3, -0.2], [1e-9, 0.0], [3e-70, 4e-70]] {
                let slope = kernels.pointwise.discrete_gradient.run(law.at(&place, &centre));
                let work: f64 = (0..2).map(|i| slope[i] * place[i]).sum();
                let [here, there] = [place, centre].map(|q| kernels.pointwise.potential.run(law.at(&q, &q))[0]);
                assert!((work - (here - there)).abs() <= 1e-14 * here, "p = {p} from {place:?}: {slope:?}");
                assert!(
                    kernels.pointwise.hessian.run(law.at(&place, &place)).iter().all(|x| x.is_finite()),
                    "p = {p} at {place:?}"
                );
                for (a, b) in [(place, centre), (centre, place)] {
                    let matrix = kernels.pointwise.discrete_gradient_jacobian.run(law.at(&a, &b));
                    assert!(matrix.iter().all(|x| x.is_finite()), "p = {p} from {a:?} to {b:?}: {matrix:?}");
                }
            }
        }
    }
}

/// A motion in |q|³ or |q|^p that has died away: the Newton matrix is that of lengths which vanish.
#[test]
fn powers_of_nearly_nothing_have_a_newton_matrix() {
    let mut cube = Law::build(1, |q, _| 0.5 * q[0].powi(2) + q[0].abs().powi(3));
    let mut square = Law::build(1, |q, p| q[0].abs().powf(p[1].of(Unary::Round)));
    for (law, slope) in [(&mut cube, 0.5), (&mut square, 1.0)] {
        let matrix = law.kernels().pointwise.discrete_gradient_jacobian;
        for k in (10..1000).step_by(7) {
            let a = 2f64.powi(-k);
            for part in [1.0, 0.9, 1.3, 0.999] {
                let same = matrix.run(law.at(&[a], &[part * a]))[0];
                assert!((same - slope).abs() < 5.0 * a + 1e-6, "from {a:e} to {:e}: {same}", part * a);
                assert!(matrix.run(law.at(&[a], &[-part * a]))[0].is_finite(), "from {a:e} to {:e}", -part * a);
            }
        }
    }
}

/// x^w for w < 1 has an infinite slope at 0, and is not said to have none: 0 is the limit where x² + y² stands in the place of x.
#[test]
fn an_infinite_slope_is_told() {
    let exponents: [fn(&[E]) -> E; 2] = [|p| p[0], |_| 0.75.into()];
    for exponent in exponents {
        for mut plain in [
            Law::build(1, |q, p| q[0].powf(exponent(p))),
            Law::build(1, |q, p| (q[0] - 2.0).powf(exponent(p))),
            Law::build(1, |q, p| (3.0 * q[0]).powf(exponent(p))),
        ] {
            let slopes = [0.0, 2.0].map(|x| gradient(&mut plain, &[x])[0]);
            assert!(slopes.contains(&f64::INFINITY), "{slopes:?}");
        }
        let mut round = Law::build(2, |q, p| squared(q).powf(exponent(p)));
        assert_eq!(gradient(&mut round, &[0.0, 0.0]), [0.0; 2]);
    }
}

/// The bounds below which an inverse is lost are those of the scalar: motions in |q|^p that have died away in binary32.
#[test]
fn bounds_follow_the_scalar() {
    let laws: [Formula; 5] = [
        |q, p| norm(q).powf(p[1].of(Unary::Round)),
        |q, _| norm(q).powf(2.7),
        |q, _| norm(q).powi(3),
        |q, _| q[0].abs().powf(1.3) + q[1].powi(2),
        |q, _| q[1].powi(2) + (q[0] - q[1]).abs(),
    ];
    for (i, phi) in laws.into_iter().enumerate() {
        let mut law = Law::build(2, phi);
        let matrix = law.kernels().pointwise.discrete_gradient_jacobian;
        for k in 8..45_i32 {
            let a = [10f32.powi(-k), 0.0];
            for part in [1.0, 1.1, -0.7, 1e-10, 0.0] {
                let found = matrix.run(law.values(|x| x as f32, &a, &a, &[part * a[0], 0.0]));
                assert!(found.iter().all(|x| x.is_finite()), "{i} from {a:?}, {part}: {found:?}");
            }
        }
    }
}

/// Forces |v|^p v of velocities whose squares are hardly numbers any more.
#[test]
fn drags_of_hardly_any_velocity_are_finite() {
    let sizes: [fn(&[E]) -> E; 4] =
        [norm, |v| norm(v).powf(0.7), |v| norm(v).sqrt(), |v| norm(v).powf(1.5) / (1.0 + norm(v))];
    for (i, size) in sizes.into_iter().enumerate() {
        let mut law = Law::build(2, |v, _| size(v));
        let v = law.variables.q.clone();
        let force: Vec<_> = v.iter().map(|&v| (law.phi, law.graph.symbol(v))).collect();
        let force: Vec<_> = force.into_iter().map(|(size, v)| law.graph.mul(&[size, v])).collect();
        let jacobian = calculus::jacobian(&mut law.graph, &force, &v).concat();
        let program = Program::schedule(&mut law.graph, &jacobian);
        let mut last = f64::INFINITY;
        for k in 0..320 {
            let small = [0.6 * 10f64.powi(-k), -0.8 * 10f64.powi(-k)];
            let found = program.run(law.at(&small, &small));
            let largest = found.iter().fold(0.0, |size: f64, x| if x.is_nan() { *x } else { size.max(x.abs()) });
            assert!(largest <= last, "{i} at {small:?}: {found:?}");
            last = largest;
        }
        assert_eq!(last, 0.0, "{i}");
    }
    let mut cube_root = Law::build(1, |v, _| v[0].cbrt());
    let slope = calculus::tangent(&mut cube_root.graph, cube_root.phi, &cube_root.variables.q);
    assert_eq!(Program::schedule(&mut cube_root.graph, &slope).run(cube_root.at(&[-1.0], &[0.0])), [1.0 / 3.0]);
}

/// The angle from the origin, where none is, and through it: the discrete gradient goes along the way and makes the work.
#[test]
fn angles_reach_the_origin() {
    let laws: [fn(&[E]) -> E; 2] = [|q| q[1].atan2(q[0]), |q| squared(q) * (1.0 + q[1].atan2(q[0]))];
    for (i, phi) in laws.into_iter().enumerate() {
        let mut law = Law::build(2, |q, _| phi(q));
        let kernels = law.kernels();
        let mut places =
            vec![[0.0, 0.0], [0.3, -0.2], [0.0, 0.7], [-1.1, 0.4], [0.6, -0.4], [0.2, 0.3], [0.0, 0.2], [0.5, 0.0]];
        places.extend([[-0.15, 0.1], [0.0, -0.35], [1.65, -0.6], [-0.5, 0.0]]);
        let mut through = 0;
        for (a, b) in places.iter().flat_map(|a| places.iter().map(move |b| (a, b))) {
            let slope = kernels.pointwise.discrete_gradient.run(law.at(a, b));
            let work: f64 = (0..2).map(|i| slope[i] * (b[i] - a[i])).sum();
            let [start, end] = [a, b].map(|q| kernels.pointwise.potential.run(law.at(q, q))[0]);
            assert!((work - (end - start)).abs() < 1e-14, "{i} from {a:?} to {b:?}: {slope:?}");
            if a == b && *a != places[0] {
                let tangent = kernels.pointwise.gradient.run(law.at(a, a));
                assert!((0..2).all(|i| (slope[i] - tangent[i]).abs() < 1e-14), "at {a:?}: {slope:?}, {tangent:?}");
            }
            // Elsewhere it goes around.
            let dot = a[0] * b[0] + a[1] * b[1];
            let opposite = (a[0] * b[1] - a[1] * b[0]).abs() < -1e-15 * dot;
            through += usize::from(opposite);
            let around = i == 1 || opposite || [a, b].contains(&&places[0]);
            let out: f64 = (0..2).map(|i| slope[i] * (a[i] + b[i])).sum();
            assert!(around || out.abs() < 1e-14, "from {a:?} to {b:?}: {slope:?}");
            let matrix = kernels.pointwise.discrete_gradient_jacobian.run(law.at(a, b));
            assert!(matrix.iter().all(|x| x.is_finite()), "{i} from {a:?} to {b:?}: {matrix:?}");
        }
        assert!(through >= 8, "{through} ways lead through the origin");
        let hessian = kernels.pointwise.hessian.run(law.at(&[0.0; 2], &[0.0; 2]));
        assert!(i == 0 || hessian.iter().all(|x| x.is_finite()), "{i}: {hessian:?}");
    }
}

/// A centre elsewhere is one too; where a square is only nearly 0, or what a power is of passes through it, none is.
#[test]
fn orders_are_those_of_the_place() {
    let shifted: [Formula; 2] = [
        |q, p| ((q[0] - p[1]).powi(2) + (2.0 * q[1] - p[2]).powi(2)).powf(0.75),
        |q, p| ((q[0] - p[1]).powi(2) + (2.0 * q[1] - p[2]).powi(2)).powf(p[1].of(Unary::Round) * 0.375),
    ];
    for phi in shifted {
        let mut law = Law::build(2, phi);
        let centre = [PARAMETERS[1], 0.5 * PARAMETERS[2]];
        assert_eq!(gradient(&mut law, &centre), [0.0; 2]);
    }
    for mut passing in [
        Law::build(1, |q, _| (1.0 - q[0].powi(2)).powf(0.75)),
        Law::build(1, |q, _| (1.0 - q[0].powi(2)).powf(0.7)),
        Law::build(1, |q, _| (q[0].of(Unary::Sinh) - 1.0f64.sinh()).powf(0.7)),
        Law::build(1, |q, _| (q[0].abs() - 1.0).powf(0.7)),
    ] {
        assert_eq!(gradient(&mut passing, &[1.0])[0].abs(), f64::INFINITY);
    }
    let mut round = Law::build(2, |q, p| squared(q).powf(p[0]));
    assert_eq!(round.kernels().pointwise.discrete_gradient.run(round.at(&[0.0; 2], &[0.0; 2])), [0.0; 2]);
    let mut below = Law::build(2, |q, _| squared(q).cbrt() * norm(q).sqrt().sqrt());
    assert_ne!(gradient(&mut below, &[0.0; 2]), [0.0; 2]);
    let mut steep = Law::build(2, |q, _| norm(q) * q[0].powi(2).max(1.0));
    assert_ne!(gradient(&mut steep, &[0.0; 2]), [0.0; 2]);
    let mut higher = Law::build(2, |q, p| (q[0].powi(4) + q[1].powi(4)).powf(0.5 * p[1].of(Unary::Round) - 0.7));
    assert_eq!(gradient(&mut higher, &[0.0; 2]), [0.0; 2]);
}

/// What touches 0 has no slope there, wherever that is: a power of it from the first order on has none either.
#[test]
fn what_touches_zero_is_flat_there() {
    let ring = |q: &[E]| (norm(&q[..2]) - 1.0).powi(2) + q[2].powi(2);
    let laws: [(&str, [f64; 3], Formula); 10] = [
        ("a ring", [0.6, 0.8, 0.0], |q, p| p[0] * ((norm(&q[..2]) - 1.0).powi(2) + q[2].powi(2)).powf(0.75)),
        ("a ring, p", [0.6, 0.8, 0.0], |q, p| {
            ((norm(&q[..2]) - 1.0).powi(2) + q[2].powi(2)).powf(p[1].of(Unary::Round) * 0.375)
        }),
        ("a valley", [1.0, 0.0, 0.0], |q, _| {
            let u = (q[0].powi(2) - 1.0).powi(2) + q[1].powi(2);
            u * u.sqrt()
        }),
        ("1 − cos", [0.0; 3], |q, p| p[0] * (1.0 - q[0].of(Unary::Cos)).powi(2).cbrt()),
        ("(1 − cos)^w", [0.0; 3], |q, _| (1.0 - q[0].of(Unary::Cos)).powf(0.7)),
        ("(1 − cos)√(1 − cos)", [0.0; 3], |q, p| {
            let u = 1.0 - q[0].of(Unary::Cos);
            p[0] * u * u.sqrt()
        }),
        ("two of them", [0.0; 3], |q, _| (2.0 - q[0].of(Unary::Cos) - q[1].of(Unary::Cos)).powf(0.75)),
        ("with a square", [0.0; 3], |q, _| (2.0 - 2.0 * q[0].of(Unary::Cos) + q[1].powi(2)).powf(0.75)),
        ("cosh − 1", [0.0; 3], |q, _| (3.0 * q[0].of(Unary::Cosh) - 3.0).powf(0.75)),
        ("1 − sin", [core::f64::consts::FRAC_PI_2, 0.3, 0.2], |q, _| (1.0 - q[0].of(Unary::Sin)).powf(0.75)),
    ];
    for (name, place, phi) in laws {
        let mut law = Law::build(3, phi);
        assert!(gradient(&mut law, &place).iter().all(|&x| x == 0.0), "{name}");
        let beside = place.map(|x| x + 1e-3);
        let kernels = law.kernels();
        for (a, b) in [(place, place), (place, beside), (beside, place)] {
            let secant = kernels.pointwise.discrete_gradient.run(law.at(&a, &b));
            assert!(secant.iter().all(|x| x.is_finite()), "{name}: {secant:?}");
        }
    }
    // What passes through 0, and what is not known to touch it.
    let infinite: [(&str, [f64; 3], Formula); 4] = [
        ("2 − cos beside", [1.0, 0.0, 0.0], |q, _| (q[0].powi(2) - 2.0 + q[1].of(Unary::Cos)).powf(0.75)),
        ("1 + 2 cos", [0.0, 1.0, 0.0], |q, _| (q[1] + 1.0 - 2.0 * q[0].of(Unary::Cos)).powf(0.7)),
        ("another's root", [0.7, 0.0, 0.0], |q, _| (1.0 - q[0].of(Unary::Cos)) * (1.0 - q[1].of(Unary::Cos)).sqrt()),
        ("two that differ", [0.6, 0.8, 0.0], |q, _| {
            (norm(&q[..2]) - 1.0).powi(2).sqrt() * (norm(&q[..2]) + q[2] - 1.0).powf(0.5)
        }),
    ];
    for (name, place, phi) in infinite {
        let mut law = Law::build(3, phi);
        let slopes = gradient(&mut law, &place);
        assert!(slopes.iter().any(|x| !x.is_finite()), "{name}: {slopes:?}");
    }
    let passing: [Formula; 2] = [
        |q, _| (3.0 - 3.0 * q[0].of(Unary::Cosh) + q[1].powi(2)).powf(0.75),
        |q, _| (1.0 - q[0].of(Unary::Cos) - q[1].powi(2)).powf(0.75),
    ];
    for phi in passing {
        assert_eq!(Law::build(2, phi).kernels().pointwise.gradient.cost().choices, 0);
    }
    let mut torus = Law::build(3, |q, _| ring(q).sqrt());
    assert!(gradient(&mut torus, &[0.6, 0.8, 0.0]).iter().any(|x| !x.is_finite()), "a distance has no slope at 0");
}

/// Where a law has no centre, nothing is paid for one: springs with a length, softened forces, molecules.
#[test]
fn what_has_no_centre_chooses_nothing() {
    let laws: [Formula; 5] = [
        |q, _| squared(q) * (q[0] + (1.0 + squared(q)).sqrt()),
        |q, p| p[0] * (norm(q) - p[1]).powi(2) + (norm(&[q[0] - 3.0, q[1]]) - p[1]).powi(2),
        |q, p| (squared(q) + p[0].powi(2)).sqrt(),
        |q, _| (1.0 + q[0].powi(4)).sqrt() + q[1],
        |q, p| p[0] * (1.0 - (p[1] - norm(q)).exp()).powi(2),
    ];
    for (i, phi) in laws.into_iter().enumerate() {
        let mut law = Law::build(2, phi);
        let kernels = law.kernels();
        let choices = |program: &Program| program.cost().choices;
        let [_, gradient, hessian, secant, matrix] = kernels.pointwise.each().map(choices);
        assert_eq!([gradient, hessian, choices(&kernels.gradient_kick)], [0; 3], "{i}");
        // The exponential has its own choice, and one for each of its slopes.
        assert_eq!([secant, matrix], if i == 4 { [1, 5] } else { [0; 2] }, "{i}");
    }
    let mut round = Law::build(2, |q, _| norm(q) * norm(q).of(Unary::Tanh));
    let kernels = round.kernels();
    let choices = kernels.pointwise.each().map(|program| program.cost().choices);
    assert_eq!(choices[1..4], [1, 6, 2]);
    assert_eq!(kernels.pointwise.gradient.cost().multiplications, 6, "√s·1/√s cancels");
    let mut chain = Law::build(4, |q, p| (norm(&[q[0] - q[2], q[1] - q[3]]) - p[0]).powi(2));
    assert_eq!(chain.kernels().gradient_kick.cost().choices, 0);
    let mut soft = Law::build(2, |q, p| (p[1].powi(2) + squared(q)).powf(p[0]));
    assert_eq!(soft.kernels().pointwise.gradient.cost().choices, 0, "a parameter squared is not known to vanish");
    let mut soft = Law::build(1, |q, p| (1.0 + q[0].powi(2)).powf(p[0]));
    let kernels = soft.kernels();
    assert_eq!(kernels.pointwise.gradient.cost().choices, 0);
    for program in kernels.pointwise.each() {
        let finite = |operation: &Operation| !matches!(operation, Operation::Number(x) if !x.value().is_finite());
        assert!(program.operations.iter().all(finite));
    }
}
