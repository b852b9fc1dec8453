//! What the steps of a law with a force are known to be: linear in the increment or not, with velocities or without, with
//! work or without.

use crate::common::laws::Law;
use crate::common::notation::{E, choose, squared, within};
use dmech_symbolic::kernel::{ForcedKernels, ForcedStep, Way};

/// F in q, v and parameters.
type Force = fn(&[E], &[E], &[E]) -> Vec<E>;

/// A force beside a potential, in q, v and parameters, and whether its steps are solved by one correction.
struct Example {
    name: &'static str,
    dimension: usize,
    phi: fn(&[E]) -> E,
    force: Force,
    implicit_is_linear: bool,
    discrete_is_linear: bool,
    workless: bool,
}

fn nothing(_: &[E]) -> E {
    E::from(0.0)
}

fn well(q: &[E]) -> E {
    squared(q) / 2.0
}

/// A magnetic field of strength b: b (v_y, −v_x).
fn turned(b: E, v: &[E]) -> Vec<E> {
    vec![b * v[1], -(b * v[0])]
}

fn examples() -> Vec<Example> {
    let linear = |name, phi, force| Example {
        name,
        dimension: 1,
        phi,
        force,
        implicit_is_linear: true,
        discrete_is_linear: true,
        workless: false,
    };
    let newton =
        |name, phi, force| Example { implicit_is_linear: false, discrete_is_linear: false, ..linear(name, phi, force) };
    let magnetic = |name, phi, force, is_linear| Example {
        dimension: 2,
        implicit_is_linear: is_linear,
        discrete_is_linear: is_linear,
        workless: true,
        ..linear(name, phi, force)
    };
    vec![
        linear("constant", nothing, |_, _, p| vec![p[0]]),
        linear("spring", nothing, |q, _, p| vec![-p[0] * q[0]]),
        linear("drag", nothing, |_, v, p| vec![-p[0] * v[0]]),
        linear("drag in a well", well, |q, v, p| vec![-p[0] * v[0] - p[1] * q[0]]),
        // Curved in the velocity alone: the Jacobian depends on the increment and on no position.
        newton("quadratic drag", nothing, |_, v, p| vec![-p[0] * v[0] * v[0].abs()]),
        newton("cubic drag", nothing, |_, v, p| vec![-p[0] * v[0].powi(3)]),
        newton("cubic drag in a well", well, |_, v, p| vec![-p[0] * v[0].powi(3)]),
        newton("saturating drag", well, |_, v, p| vec![-p[0] * v[0] / (1.0 + v[0].powi(2)).sqrt()]),
        // And in the position alone, and in both.
        newton("cubic spring", nothing, |q, _, p| vec![-p[0] * q[0].powi(3)]),
        newton("drag in a place", nothing, |q, v, p| vec![-p[0] * q[0].powi(2) * v[0]]),
        magnetic("uniform field", well, |_, v, p| turned(p[0], v), true),
        magnetic("field of the speed", well, |_, v, p| turned(p[0] * squared(v), v), false),
        magnetic("field of the place", well, |q, v, p| turned(p[0] * q[0], v), false),
        magnetic(
            "field in a half-plane",
            well,
            |q, v, p| turned(p[0], v).into_iter().map(|f| choose(q[0].less(p[1]), f, 0.0)).collect(),
            false,
        ),
    ]
}

#[test]
fn steps_are_linear_where_their_jacobian_is_constant() {
    for Example { name, dimension, phi, force, implicit_is_linear, discrete_is_linear, workless } in examples() {
        let mut law = Law::build(dimension, |q, _| phi(q));
        let parameters = law.parameters.clone();
        let list = [&law.variables.q, &law.variables.v, &parameters];
        let [q, v, p] = list.map(|names| names.iter().map(|&s| E(law.graph.symbol(s))).collect::<Vec<_>>());
        let force: Vec<_> = within(&mut law.graph, || force(&q, &v, &p)).iter().map(|e| e.0).collect();
        let forced = ForcedKernels::new(&mut law.graph, law.phi, &force, None, &law.variables);
        let (ForcedStep::Mean(discrete) | ForcedStep::Middle { change: discrete, .. }) = &forced.discrete;
        assert_eq!(forced.implicit.way == Way::Linear, implicit_is_linear, "{name}: the trapezoidal step");
        assert_eq!(discrete.way == Way::Linear, discrete_is_linear, "{name}: the energy-exact step");
        assert_eq!(forced.workless, workless, "{name}: work");
    }
}
