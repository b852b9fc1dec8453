//! Which forces are known to be linear in the velocity, and what their kick at the mean velocity is.

use crate::common::laws::Law;
use crate::common::notation::{E, choose, squared, within};
use dmech_symbolic::expression::Symbol;
use dmech_symbolic::kernel::{ForcedKernels, KickByMean};

/// What is known of a force: nothing, that it is linear, how its kick is made.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
enum Known {
    Nothing,
    NoVelocity,
    Solved,
    /// With so many outputs.
    Rotation(usize),
}

type Force = fn(&[E], &[E], &[E]) -> Vec<E>;

const EXAMPLES: [(&str, usize, Force, Known); 19] = [
    ("spring", 1, |q, _, p| vec![-p[0] * q[0]], Known::NoVelocity),
    ("drag", 1, |_, v, p| vec![-p[0] * v[0]], Known::Solved),
    ("drag in a place", 1, |q, v, p| vec![-p[0] * q[0].powi(2) * v[0] + p[1]], Known::Solved),
    // Linear when it is expanded.
    ("difference of squares", 1, |_, v, p| vec![p[0] * ((v[0] + 1.0).powi(2) - v[0].powi(2))], Known::Solved),
    // Nothing is known of what has no value at rest.
    ("difference of quotients", 1, |_, v, p| vec![p[0] * (v[0] + 1.0).powi(2) / v[0] - p[0] / v[0]], Known::Nothing),
    ("quotient", 1, |_, v, p| vec![p[0] * (v[0].powi(2) + v[0]) / v[0]], Known::Nothing),
    ("quadratic drag", 1, |_, v, p| vec![-p[0] * v[0] * v[0].abs()], Known::Nothing),
    ("cubic drag", 1, |_, v, p| vec![-p[0] * v[0].powi(3)], Known::Nothing),
    ("dry friction", 1, |_, v, p| vec![-p[0] * v[0].abs()], Known::Nothing),
    // Where it acts is not for the velocity to say.
    ("drag in a half-line", 1, |q, v, p| vec![choose(q[0].less(p[1]), -p[0] * v[0], 0.0)], Known::Solved),
    ("drag one way", 1, |_, v, p| vec![choose(v[0].less(p[1]), -p[0] * v[0], 0.0)], Known::Nothing),
    (
        "field in a half-plane",
        2,
        |q, v, p| {
            let inside = q[0].less(p[1]);
            vec![choose(inside.clone(), p[0] * v[1], 0.0), choose(inside, -p[0] * v[0], 0.0)]
        },
        Known::Rotation(1),
    ),
    (
        "fields of three regions",
        2,
        |q, v, p| {
            let (here, there) = (q[0].less(p[1]), q[1].less(p[0]));
            let field = |v: E, sign: f64| {
                choose(here.clone(), sign * p[0] * v, choose(there.clone(), sign * p[1] * q[0] * v, 0.0))
            };
            vec![field(v[1], 1.0), field(v[0], -1.0)]
        },
        Known::Rotation(1),
    ),
    ("uniform field", 2, |_, v, p| vec![p[0] * v[1], -p[0] * v[0]], Known::Rotation(1)),
    ("field of the place", 2, |q, v, p| vec![p[0] * q[0] * v[1], -p[0] * q[0] * v[0]], Known::Rotation(1)),
    ("crossed fields", 2, |_, v, p| vec![p[0] * v[1] + p[1], -p[0] * v[0]], Known::Rotation(3)),
    ("field of the speed", 2, |_, v, _| vec![squared(v) * v[1], -squared(v) * v[0]], Known::Nothing),
    (
        "field in space",
        3,
        |q, v, p| {
            let b = [p[0], q[2] * p[1], q[0] * q[1]];
            vec![v[1] * b[2] - v[2] * b[1], v[2] * b[0] - v[0] * b[2], v[0] * b[1] - v[1] * b[0]]
        },
        Known::Rotation(3),
    ),
    (
        "field and friction",
        3,
        |q, v, p| vec![p[0] * v[1] - p[1] * v[0] + q[1], -p[0] * v[0] - p[2] * v[1], q[0] * v[0] - v[2]],
        Known::Solved,
    ),
];

#[test]
fn forces_linear_in_the_velocity_are_known_and_kicked_at_its_mean() {
    for (name, dimension, force, known) in EXAMPLES {
        let mut law = Law::build(dimension, |q, _| if dimension == 3 { squared(q) / 2.0 } else { E::from(0.0) });
        if known == Known::Rotation(3) && dimension == 3 {
            law.phi = law.graph.number(0.0);
        }
        let parameters = law.parameters.clone();
        let list = [&law.variables.q, &law.variables.v, &parameters];
        let [q, v, p] = list.map(|names| names.iter().map(|&s| E(law.graph.symbol(s))).collect::<Vec<_>>());
        let force: Vec<_> = within(&mut law.graph, || force(&q, &v, &p)).iter().map(|e| e.0).collect();
        let forced = ForcedKernels::new(&mut law.graph, law.phi, &force, None, &law.variables);
        let found = match &forced.kick_by_mean {
            _ if !forced.linear_in_velocity => Known::Nothing,
            None => Known::NoVelocity,
            Some(KickByMean::Solved(_)) => Known::Solved,
            Some(KickByMean::Rotation(program)) => Known::Rotation(program.outputs.len()),
        };
        assert_eq!(found, known, "{name}");
        let Some(KickByMean::Solved(program)) = &forced.kick_by_mean else { continue };
        let (c, now, place) = (0.7, [0.4, -1.1, 0.6], [0.3, 0.8, -0.5]);
        let at = |v: &[f64]| {
            let (law, v) = (&law, v.to_vec());
            let position = law.at(&place[..dimension], &place[..dimension]);
            move |s: Symbol| match law.variables.v.iter().position(|&name| name == s) {
                Some(i) => v[i],
                None if s == law.variables.c => c,
                None => position(s),
            }
        };
        let next = program.run(at(&now));
        let mean: Vec<_> = next.iter().zip(now).map(|(x, y)| 0.5 * (x + y)).collect();
        let slope = forced.slope.run(at(&mean));
        for i in 0..dimension {
            let residual: f64 = next[i] - now[i] + c * slope[i];
            assert!(residual.abs() < 1e-14, "{name}: {residual:e}");
        }
    }
}
