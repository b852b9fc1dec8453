//! The degree of a law as a polynomial: a table of its edges, and random laws whose differences vanish beyond it.

use std::cell::Cell;

use crate::common::algebra::{Algebra, Big, big, narrow};
use crate::common::for_all;
use crate::common::laws::{Law, cases};
use crate::common::notation::{E, choose, norm, squared, within};
use dmech_symbolic::calculus;
use dmech_symbolic::degree::degree;
use dmech_symbolic::expression::Unary;
use dmech_symbolic::kernel::{PairKernels, PairLaw, PairVariables};
use dmech_symbolic::structure::Structure;

/// Formulas of x, y and two parameters, the second of which may be the time: to the engine they are the same.
type Formula = fn(E, E, E, E) -> E;

/// A degree, and the formulas that have it.
type Row = (Option<u32>, &'static [(&'static str, Formula)]);
const FORMULAS: [Row; 8] = [
    (
        Some(0),
        &[
            ("0", |_, _, _, _| 0.0.into()),
            ("k", |_, _, k, _| k),
            ("√k, sin t", |_, _, k, t| k.sqrt() * t.sin()),
            ("x² − x²", |x, _, _, _| x * x - x.powi(2)),
            ("x⁰", |x, _, _, _| x.powi(0)),
            ("0 x", |x, _, _, _| 0.0 * x),
            ("0 √x", |x, _, _, _| 0.0 * x.sqrt()),
            ("x/x", |x, _, _, _| x * x.powi(-1)),
            ("k or t", |_, _, k, t| choose(k.less(t), k.abs(), t)),
            ("x or x, less x", |x, y, _, _| choose(x.less(y), x, x) - x),
        ],
    ),
    (
        Some(1),
        &[
            ("x", |x, _, _, _| x),
            ("1 − x", |x, _, _, _| 1.0 - x),
            ("x/k", |x, _, k, _| x / k),
            ("x/√(k + t)", |x, _, k, t| x / (k + t).sqrt()),
            ("x/k³", |x, _, k, _| x * k.powi(-3)),
            ("x sin t", |x, _, _, t| x * t.sin()),
            ("x²/x", |x, _, _, _| x * x / x),
            ("k x + t y", |x, y, k, t| k * x + t * y),
            ("x^1.0", |x, _, _, _| x.powf(1.0)),
            ("√x √x", |x, _, _, _| x.sqrt() * x.sqrt()),
            ("∛x³", |x, _, _, _| x.cbrt().powi(3)),
            ("|k| x", |x, _, k, _| k.abs() * x),
            ("(k or t) x", |x, _, k, t| choose(k.less(t), k, t) * x),
        ],
    ),
    (
        Some(2),
        &[
            ("k x²/2", |x, _, k, _| 0.5 * k * x * x),
            ("x y", |x, y, _, _| x * y),
            ("x³/x", |x, _, _, _| x.powi(3) / x),
            ("(x y)²/(x y)", |x, y, _, _| (x * y).powi(2) / (x * y)),
            ("|x|²", |x, _, _, _| x.abs().powi(2)),
            ("(√(x² + y²))²", |x, y, _, _| norm(&[x, y]).powi(2)),
            ("hypot²", |x, y, _, _| x.hypot(y).powi(2)),
            ("(x + 1)² − x²", |x, _, _, _| (x + 1.0).powi(2) - x * x),
            ("x² by a real power", |x, _, _, _| x.powf(2.0)),
            ("(x − t)²", |x, _, _, t| (x - t).powi(2)),
        ],
    ),
    (
        Some(3),
        &[
            ("(x + 1)³", |x, _, _, _| (x + 1.0).powi(3)),
            ("Hénon–Heiles", |x, y, k, _| squared(&[x, y]) / 2.0 + k * (x * x * y - y.powi(3) / 3.0)),
            ("x³ + y²", |x, y, _, _| x.powi(3) + y * y),
            ("y² + x³", |x, y, _, _| y * y + x.powi(3)),
        ],
    ),
    (
        Some(4),
        &[
            ("quartic", |x, _, k, _| k * x.powi(4)),
            ("a spring by Horner's rule", |x, _, k, t| x * x * (0.5 * k + x * (t / 3.0 + k * x / 4.0))),
            ("two wells", |x, _, k, _| (x * x - k).powi(2)),
            ("(x² + y²)²", |x, y, _, _| norm(&[x, y]).powi(4)),
            ("(x − y)⁴", |x, y, _, _| (x - y).powi(4)),
            ("x² y²", |x, y, _, _| x.powi(2) * y.powi(2)),
        ],
    ),
    (
        Some(12),
        &[
            ("((x² + 1)³)²", |x, _, _, _| (x * x + 1.0).powi(3).powi(2)),
            ("(x + y)⁵ (x − y)⁷", |x, y, _, _| (x + y).powi(5) * (x - y).powi(7)),
        ],
    ),
    (Some(2_000_000_000), &[("x²⁰⁰⁰⁰⁰⁰⁰⁰⁰", |x, _, _, _| x.powi(2_000_000_000))]),
    (
        None,
        &[
            ("1/x", |x, _, _, _| x.powi(-1)),
            ("1/(x + k)", |x, _, k, _| 1.0 / (x + k)),
            ("x⁴/y", |x, y, _, _| x.powi(4) / y),
            ("(x + 1)⁴/(x + 1)⁶", |x, _, _, _| (x + 1.0).powi(4) / (x + 1.0).powi(6)),
            ("√x", |x, _, _, _| x.sqrt()),
            ("√(x² + y²)", |x, y, _, _| norm(&[x, y])),
            ("(√(x² + y²) − k)²", |x, y, k, _| (norm(&[x, y]) - k).powi(2)),
            ("|x|", |x, _, _, _| x.abs()),
            ("|x|³", |x, _, _, _| x.abs().powi(3)),
            ("sin x", |x, _, _, _| x.sin()),
            ("1 − cos x", |x, _, _, _| 1.0 - x.cos()),
            ("exp x²", |x, _, _, _| (x * x).exp()),
            ("x^2.5", |x, _, _, _| x.powf(2.5)),
            ("x^k", |x, _, k, _| x.powf(k)),
            ("k^x", |x, _, k, _| k.powf(x)),
            ("atan2", |x, y, _, _| x.atan2(y)),
            ("min(x, y)", |x, y, _, _| x.min(y)),
            ("max(x, 0)²", |x, _, _, _| x.max(0.0).powi(2)),
            ("x² or y²", |x, y, _, _| choose(x.less(y), x * x, y * y)),
            ("0 or 1", |x, _, k, _| choose(x.less(k), 0.0, 1.0)),
            ("x² or y² by a parameter", |x, y, k, t| choose(k.less(t), x * x, y * y)),
            ("sign of x", |x, _, _, _| x.of(Unary::Signum)),
            ("floor of x", |x, _, _, _| x.of(Unary::Floor)),
            ("a quartic and a cosine", |x, y, _, _| x.powi(4) + y.cos()),
            ("a quartic by a cosine", |x, y, _, _| x.powi(4) * y.cos()),
            ("beyond all numbers", |x, y, _, _| {
                x.powi(2_000_000_000) * y.powi(2_000_000_000) * (x + y).powi(2_000_000_000)
            }),
            ("a power beyond all numbers", |x, _, _, _| (x * x + 1.0).powi(i32::MAX) * x.powi(2)),
        ],
    ),
];

#[test]
fn the_degree_is_that_of_the_formula() {
    for (expected, formulas) in FORMULAS {
        for (name, formula) in formulas {
            let mut law = Law::build(2, |q, p| formula(q[0], q[1], p[0], p[1]));
            let of = |e| degree(&law.graph, e, &[(law.variables.q[0], 1), (law.variables.q[1], 1)]);
            assert_eq!(of(law.phi), expected, "{name}: {}", law.graph.display(law.phi));
            let hessian = calculus::hessian(&mut law.graph, law.phi, &law.variables.q);
            let structure = Structure::of(&mut law.graph, law.phi, &hessian, &law.variables.q);
            assert_eq!(structure.degree, expected, "{name}");
            assert!(!structure.piecewise || structure.degree.is_none(), "{name}: a choice");
        }
    }
}

/// Written in r = |d| or in d; the degree is that in d.
#[test]
fn of_two_bodies_the_distance_is_a_root() {
    type Pair = fn(E, &[E], E) -> E;
    let laws: [(&str, Option<u32>, Pair); 19] = [
        ("nothing", Some(0), |_, _, _| 0.0.into()),
        ("k", Some(0), |_, _, k| k),
        ("k r²/2", Some(2), |r, _, k| 0.5 * k * r.powi(2)),
        ("r r", Some(2), |r, _, _| r * r),
        ("r⁴", Some(4), |r, _, _| r.powi(4)),
        ("r² (k + r²)", Some(4), |r, _, k| r * r * (k + r * r)),
        ("(r² − k²)²", Some(4), |r, _, k| (r * r - k * k).powi(2)),
        ("r⁶/r²", Some(4), |r, _, _| r.powi(6) / r.powi(2)),
        ("r", None, |r, _, _| r),
        ("r³", None, |r, _, _| r.powi(3)),
        ("1/r", None, |r, _, k| -k / r),
        ("1/r²", None, |r, _, k| -k / r.powi(2)),
        ("k (r − l)²/2", None, |r, _, k| 0.5 * k * (r - 1.3).powi(2)),
        ("min(r, 1)²", None, |r, _, _| r.min(1.0).powi(2)),
        ("d²", Some(2), |_, d, _| squared(d)),
        ("|d|² as a norm", Some(2), |_, d, k| k * norm(d).powi(2)),
        ("|d|", None, |_, d, k| k * norm(d)),
        ("a chain", Some(4), |_, d, k| d[0] * d[0] * (0.5 * k - d[0] * (k / 3.0 - k * d[0] / 4.0))),
        ("cubic in d", Some(3), |_, d, k| k * d[0].powi(3) + squared(d)),
    ];
    for dimension in 1..=3 {
        for (name, expected, phi) in laws {
            let Law { mut graph, variables, parameters, .. } = Law::build(dimension, |_, _| 0.0.into());
            let pair = PairVariables::new(&mut graph, dimension);
            let r = E(pair.distance(&mut graph));
            let d: Vec<_> = graph.symbols(&variables.q).into_iter().map(E).collect();
            let k = E(graph.symbol(parameters[0]));
            let potential = Some(within(&mut graph, || phi(r, &d, k)).0);
            let law = PairLaw { potential, force: None, exchange: vec![] };
            let potential = PairKernels::new(&mut graph, &law, &variables, &pair).potential.expect("a potential");
            assert_eq!(potential.degree, expected, "{name} in {dimension} dimensions");
            assert!(!potential.linear || potential.degree.is_some_and(|degree| degree <= 2), "{name}");
        }
    }
}

/// Along any line the difference of order ν + 1 of a polynomial of degree ν is 0.
#[test]
fn differences_of_random_laws_vanish_beyond_their_degree() {
    let seen = [const { Cell::new(0) }; 13];
    for_all(5000, &cases(), |case| {
        let law = Law::new(&case.tree, case.dimension());
        let coordinates: Vec<_> = law.variables.q.iter().map(|&q| (q, 1)).collect();
        let Some(found) = degree(&law.graph, law.phi, &coordinates) else { return };
        let Some(seen) = seen.get(found as usize) else { return };
        seen.set(seen.get() + 1);
        let steps = found as usize + 1;
        let mut values: Vec<Big> = (0..=steps)
            .map(|k| {
                let share = big(k as f64).over(&big(steps as f64));
                let on_the_way = |(a, d): (&f64, &f64)| big(*a).plus(&big(*d).times(&share));
                case.tree.evaluate(&case.a.iter().zip(&case.direction).map(on_the_way).collect::<Vec<_>>())
            })
            .collect();
        let scale = values.iter().map(|x| narrow(x).abs()).fold(1.0, f64::max);
        for _ in 0..steps {
            values = values.windows(2).map(|pair| pair[1].minus(&pair[0])).collect();
        }
        let left = narrow(&values[0]).abs();
        assert!(left <= 1e-55 * scale, "degree {found} of {}: {left:e}", law.graph.display(law.phi));
    });
    let seen = seen.map(Cell::into_inner);
    println!("laws of each degree: {seen:?}");
    assert!(seen[1..].iter().sum::<usize>() > 250, "{seen:?}");
}
