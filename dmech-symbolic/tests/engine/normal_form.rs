//! Normal forms: numbers folded only where that is exact, values kept, nothing left to rewrite.

use std::cell::Cell;

use crate::common::algebra::{Algebra, Big, big, narrow};
use crate::common::evaluate::evaluate;
use crate::common::laws::{Law, cases};
use crate::common::{Worst, for_all};
use dmech_symbolic::expression::{Graph, Node, Substitution};
use dmech_symbolic::kernel::exchange;
use proptest::prelude::*;

fn numbers() -> impl Strategy<Value = f64> {
    prop_oneof![
        2 => (-40_i32..40, -6_i32..6).prop_map(|(n, k)| f64::from(n) * 2f64.powi(k)),
        1 => -5.0..5.0_f64,
        1 => prop::sample::select(vec![0.1, 1.0 / 3.0, 1e-30, 1e30, 1e17, 3.0]),
    ]
}

/// An expression keeps its very value, for any scalar type: what is exact becomes one number, what is not stays.
#[test]
fn numbers_are_folded_only_if_exact() {
    let (folded, kept) = (Cell::new(0), Cell::new(0));
    for_all(4000, &(numbers(), numbers(), 0..5_i32), |(x, y, operation)| {
        let mut g = Graph::new();
        let (u, w) = (g.number(x), g.number(y));
        let (e, exact, rounded) = match operation {
            0 => (g.add(&[u, w]), big(x) + big(y), x + y),
            1 => (g.sub(u, w), big(x) - big(y), x - y),
            2 => (g.mul(&[u, w]), big(x) * big(y), x * y),
            3 if y != 0.0 => (g.div(u, w), big(x) / big(y), x / y),
            4 => (g.powi(u, 3), big(x) * big(x) * big(x), x * x * x),
            _ => return,
        };
        let value = evaluate::<Big>(&g, &[e], &|_| unreachable!())[0].clone();
        let difference = narrow(&(value - &exact)).abs();
        assert!(difference <= 1e-70 * narrow(&exact).abs(), "{x} {y} {operation}: {}", g.display(e));
        match g.as_number(e) {
            Some(number) => {
                assert!(big(number) == exact, "{x} {y} {operation}: {number}");
                folded.set(folded.get() + 1);
            }
            None => {
                assert!(big(rounded) != exact, "{x} {y} {operation}: {}", g.display(e));
                kept.set(kept.get() + 1);
            }
        }
    });
    println!("{} folded, {} kept", folded.get(), kept.get());
    assert!(folded.get() > 500 && kept.get() > 500);
}

/// The normal form of a law has the value of the tree it was built from, to 60 digits.
#[test]
fn normal_forms_keep_the_value_of_random_laws() {
    let worst = Worst::new();
    for_all(400, &cases(), |case| {
        let law = Law::new(&case.tree, case.dimension());
        let at: Vec<_> = case.a.iter().map(|&x| big(x)).collect();
        let plain = case.tree.evaluate(&at);
        let rewritten = evaluate(&law.graph, &[law.phi], &law.values(big, &at, &[], &[]))[0].clone();
        let error = narrow(&plain.minus(&rewritten)).abs();
        worst.see(error / (narrow(&plain).abs() + 1e-6) * 1e60, || law.graph.display(law.phi).to_string());
    });
    worst.at_most(1.0, "normal form against the tree, in units of 1e-60");
}

/// Normal forms are fixed points: rebuilding an expression gives the same one, and exchanging the ends of a step twice
/// too. (Symmetric programs rest on it: the image of an expression must be found again.)
#[test]
fn rebuilding_changes_nothing() {
    let nodes = Cell::new(0);
    for_all(250, &cases(), |case| {
        let mut law = Law::new(&case.tree, case.dimension());
        let formulas = law.kernels().formulas;
        let g = &mut law.graph;
        let all = g.reachable(&[formulas.discrete_gradient.clone(), formulas.gradient].concat());
        let mut identity = Substitution::default();
        let (mut there, mut back) = (exchange(g, &law.variables), exchange(g, &law.variables));
        for e in all {
            let rebuilt = identity.apply(g, e);
            assert_eq!(rebuilt, e, "{} becomes {}", g.display(e), g.display(rebuilt));
            let image = there.apply(g, e);
            let again = back.apply(g, image);
            assert_eq!(again, e, "{} becomes {} by way of {}", g.display(e), g.display(again), g.display(image));
            nodes.set(nodes.get() + 1);
        }
        for e in formulas.discrete_gradient {
            let image = there.apply(g, e);
            assert_eq!(image, e, "{} is not symmetric: {}", g.display(e), g.display(image));
        }
    });
    assert!(nodes.get() > 5_000, "{}", nodes.get());
}

/// What the documentation of a node promises of its parts.
#[test]
fn nodes_are_in_normal_form() {
    for_all(250, &cases(), |case| {
        let mut law = Law::new(&case.tree, case.dimension());
        let formulas = law.kernels().formulas;
        let roots =
            [formulas.discrete_gradient, formulas.discrete_gradient_jacobian.concat(), formulas.hessian.concat()]
                .concat();
        let g = &law.graph;
        for e in g.reachable(&roots) {
            assert!(g.children(e).iter().all(|c| c.index() < e.index()), "children are older than {}", g.display(e));
            match g.node(e) {
                Node::Sum { terms, .. } => {
                    assert!(terms.windows(2).all(|t| t[0].1 <= t[1].1), "sorted: {}", g.display(e));
                    for (c, t) in terms {
                        // A sum inside a sum is one that is multiplied: 3·(x + y).
                        let flat = !matches!(g.node(*t), Node::Sum { .. }) || c.value().abs() != 1.0;
                        assert!(c.value() != 0.0 && flat, "{}", g.display(e));
                        if let Node::Product { coefficient, .. } = g.node(*t) {
                            assert_eq!(coefficient.value(), 1.0, "term {} of {}", g.display(*t), g.display(e));
                        }
                    }
                }
                Node::Product { coefficient, factors } => {
                    assert!(coefficient.value() != 0.0);
                    assert!(factors.windows(2).all(|f| f[0].0 < f[1].0), "sorted: {}", g.display(e));
                    assert!(factors.iter().all(|(f, n)| *n != 0 && !matches!(g.node(*f), Node::Product { .. })));
                }
                _ => {}
            }
        }
    });
}
