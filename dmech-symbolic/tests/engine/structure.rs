//! What the engine sees in a law beside its being smooth, and the coefficients of central laws.

use crate::common::laws::Law;
use crate::common::notation::{E, norm, squared};
use crate::common::tree::FUNCTIONS;
use dmech_symbolic::expression::{Unary, evaluate};
use dmech_symbolic::kernel::{Kernels, Way};

/// A law by its construction, in parameters p₀, p₁, p₂, and what must be seen in it.
struct Example {
    name: &'static str,
    dimensions: &'static [usize],
    phi: fn(&[E], &[E]) -> E,
    constant: bool,
    diagonal: bool,
    central: bool,
}

fn example(name: &'static str, dimensions: &'static [usize], phi: fn(&[E], &[E]) -> E) -> Example {
    Example { name, dimensions, phi, constant: false, diagonal: false, central: false }
}

impl Example {
    fn constant(self) -> Self {
        Self { constant: true, ..self }
    }
    fn diagonal(self) -> Self {
        Self { diagonal: true, ..self }
    }
    fn central(self) -> Self {
        Self { central: true, ..self }
    }
    fn laws(&self) -> impl Iterator<Item = (Law, Kernels)> {
        self.dimensions.iter().map(|&dimension| {
            let mut law = Law::build(dimension, self.phi);
            let kernels = law.kernels();
            (law, kernels)
        })
    }
}

fn sum(terms: impl Iterator<Item = E>) -> E {
    terms.fold(E::from(0.0), |sum, term| sum + term)
}

fn examples() -> Vec<Example> {
    vec![
        example("inverse distance", &[2, 3, 5], |q, p| -p[0] / norm(q)).central(),
        example("softened", &[2, 3], |q, p| -p[0] / (squared(q) + p[1].powi(2)).sqrt()).central(),
        example("spring of length l", &[2, 3], |q, p| p[0] * (norm(q) - p[1]).powi(2) / 2.0).central(),
        example("Lennard-Jones in r", &[2, 3], |q, p| {
            4.0 * p[0] * ((p[1] / norm(q)).powi(12) - (p[1] / norm(q)).powi(6))
        })
        .central(),
        example("logarithm", &[2, 3], |q, p| p[0] * squared(q).ln()).central(),
        example("Gaussian well", &[2, 3], |q, p| p[0] * (-p[1] * squared(q)).exp()).central(),
        example("Yukawa", &[2, 3], |q, p| p[0] * (-norm(q) / p[1]).exp() / norm(q)).central(),
        example("power", &[2, 3], |q, p| p[0] * norm(q).powf(2.7)).central(),
        example("oscillator with a quartic", &[2, 3], |q, p| p[0] * squared(q) + p[1] * squared(q).powi(2)).central(),
        example("isotropic oscillator", &[2, 3], |q, p| p[0] * squared(q)).constant().diagonal().central(),
        // The squares stand term by term, each with the same cofactor.
        example("k x²/2 + k y²/2", &[2, 3], |q, p| sum(q.iter().map(|x| p[0] * x.powi(2) / 2.0)))
            .constant()
            .diagonal()
            .central(),
        example("anisotropic oscillator", &[2, 3], |q, p| sum(q.iter().zip(p).map(|(x, &k)| k * x.powi(2))))
            .constant()
            .diagonal(),
        example("coupled oscillators", &[2, 3], |q, p| p[0] * squared(q) + p[1] * q[0] * q[1]).constant(),
        example("weight", &[1, 2, 3], |q, p| p[0] * q[q.len() - 1]).constant().diagonal(),
        example("quartic on a line", &[1], |q, p| p[0] * q[0].powi(4)).diagonal(),
        example("Duffing in each coordinate", &[2, 3], |q, p| sum(q.iter().map(|x| p[0] * x.powi(4)))).diagonal(),
        example("one coordinate of two", &[2], |q, p| p[0] * q[0].powi(2).cos()).diagonal(),
        example("centre elsewhere", &[2], |q, p| -p[0] / norm(&[q[0] - p[1], q[1]])),
        example("Hénon–Heiles", &[2], |q, p| squared(q) / 2.0 + p[0] * (q[0].powi(2) * q[1] - q[1].powi(3) / 3.0)),
        example("central and tilted", &[2, 3], |q, p| 1.0 / norm(q) + p[0] * q[0]),
        example("elliptic", &[2], |q, p| -1.0 / (q[0].powi(2) + p[0] * q[1].powi(2)).sqrt()),
    ]
}

#[test]
fn structure_is_seen() {
    for example in examples() {
        for (law, kernels) in example.laws() {
            let structure = &kernels.structure;
            let seen = (structure.constant_hessian, structure.diagonal_hessian, structure.central.is_some());
            let expected = (example.constant, example.diagonal, example.central);
            assert_eq!(seen, expected, "{}: {}", example.name, law.graph.display(law.phi));
            let right = match (kernels.implicit.way, kernels.discrete.way) {
                (Way::Linear, Way::Linear) => example.constant,
                (Way::Central, Way::Central) => example.central && !example.constant,
                (Way::Newton, Way::Newton) => !example.central && !example.constant,
                _ => false,
            };
            assert!(right, "{}", example.name);
        }
    }
}

/// ∇Φ = c q and ∇̄Φ = C (a + b) for every central law, at every distance of the two ends and where they coincide: the
/// one unknown of a central step is enough.
#[test]
fn central_coefficients() {
    let mut tried = 0;
    for example in examples() {
        for (mut law, kernels) in example.laws() {
            let Some(central) = kernels.structure.central else { continue };
            let a = &[0.4, -0.7, 1.1, 0.9, -0.2][..law.variables.q.len()];
            let (s, sa, sb) = (central.s, law.variables.s_a, law.variables.s_b);
            let coefficients =
                [central.coefficient(&mut law.graph), central.discrete_coefficient(&mut law.graph, sa, sb)];
            for gap in [1.0, 1e-3, 1e-7, 1e-12, 0.0] {
                let b: Vec<f64> = a.iter().enumerate().map(|(i, x)| x + gap * (0.3 - 0.1 * i as f64)).collect();
                let length2 = |q: &[f64]| q.iter().map(|x| x * x).sum::<f64>();
                let (at, from, to) = (law.at(a, &b), length2(a), length2(&b));
                let [c, both] = coefficients.map(|e| {
                    evaluate(&law.graph, e, |name| {
                        if name == sb {
                            to
                        } else if name == s || name == sa {
                            from
                        } else {
                            at(name)
                        }
                    })
                });
                let (gradient, secant) =
                    (kernels.pointwise.gradient.run(&at), kernels.pointwise.discrete_gradient.run(&at));
                for i in 0..a.len() {
                    let close = |x: f64, y: f64| (x - y).abs() <= 32.0 * f64::EPSILON * (x.abs() + y.abs());
                    assert!(close(gradient[i], c * a[i]), "{}: {} {}", example.name, gradient[i], c * a[i]);
                    assert!(close(secant[i], both * (a[i] + b[i])), "{}: {secant:?} {both}", example.name);
                    tried += 1;
                }
            }
        }
    }
    assert!(tried > 100);
}

/// The central steps also read two derivatives of their coefficient: finite, and right, where both ends are equally far
/// from the centre (a circular orbit) and nearly so.
fn check_derivatives_of_the_coefficient(name: &str, law: &Law, kernels: &Kernels) -> usize {
    let Kernels { discrete, implicit, .. } = kernels;
    if (discrete.way, implicit.way) != (Way::Central, Way::Central) {
        return 0;
    }
    let (discrete, implicit) = (&discrete.program, &implicit.program);
    let at = |from: f64, to: f64| {
        let known = law.at(&[], &[]);
        let (s, a, b) = (law.variables.s, law.variables.s_a, law.variables.s_b);
        move |name| {
            if name == b {
                to
            } else if name == s || name == a {
                from
            } else {
                known(name)
            }
        }
    };
    for s in [0.5, 1.3, 2.1] {
        // C(s, s) = Φ′(s), C_b = Φ″/2, C_bb = Φ‴/3; and the trapezoid has c = 2 Φ′.
        let [c0, c1, c2]: [f64; 3] = implicit.run(at(s, s)).try_into().expect("three");
        let expected = [c0 / 2.0, c1 / 4.0, c2 / 6.0];
        let scale = expected.iter().map(|x| x.abs()).fold(0.0, f64::max);
        for gap in [0.0, 1e-15, 1e-12, 1e-9, 1e-6] {
            let found = discrete.run(at(s, s * (1.0 + gap)));
            for k in 0..3 {
                let error = (found[k] - expected[k]).abs();
                assert!(error <= (1e-13 + 30.0 * gap) * scale, "{name}, s = {s}, gap {gap}: {found:?} {expected:?}");
            }
        }
    }
    1
}

#[test]
fn derivatives_of_central_coefficients_meet_their_limits() {
    let mut tried = 0;
    for example in examples() {
        for (law, kernels) in example.laws() {
            tried += check_derivatives_of_the_coefficient(example.name, &law, &kernels);
        }
    }
    // Every function of the squared distance, and of the distance.
    for f in FUNCTIONS {
        for of in [squared, norm] {
            let low = if f == Unary::Acosh { 1.1 } else { 0.03 };
            let mut law = Law::build(3, |q, p| p[2] * (low + 0.3 * of(q)).of(f));
            let kernels = law.kernels();
            tried += check_derivatives_of_the_coefficient(&format!("{f:?}"), &law, &kernels);
        }
    }
    println!("{tried} central laws");
    assert!(tried >= 60);
}
