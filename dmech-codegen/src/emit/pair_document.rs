//! The derivation of a law between two bodies as documentation.

use dmech_symbolic::expression::Expr;
use dmech_symbolic::kernel::{PairForce, PairFormulas, PairPotential, Radial};

use super::document::{Formulas, Line, OF_THE_END, block, costly, of_degree, of_time, shown, text, texts};
use crate::PairDerivation;
use crate::diagnostics::counted;

/// The paragraphs above the functions of `Potential`.
pub(super) fn potential_texts(derivation: &PairDerivation, potential: &PairPotential) -> [Vec<String>; 5] {
    match &potential.formulas {
        PairFormulas::Radial(found) => {
            let [energy, gradient, hessian, discrete, jacobian] = potential.pointwise.each();
            let [phi, c, of_ends] = radial(derivation, found);
            [
                block("The potential, of r = |d|.", &[phi], energy),
                block("The gradient, c d.", &[c], gradient),
                costly("The Hessian, c 1 + 2 c′ d⊗d with c′ = dc/dr².", hessian),
                block(
                    "The discrete gradient, C (a + b): exact for any gap between the ends a and b.",
                    &[of_ends],
                    discrete,
                ),
                costly(OF_THE_END, jacobian),
            ]
        }
        PairFormulas::Separation(found) => {
            let title = "The potential, of the separation d.";
            texts(title, "(a, b)", &formulas(derivation), found, potential.pointwise.each())
        }
    }
}

/// The paragraphs above F and its Jacobians.
pub(super) fn force_texts(derivation: &PairDerivation, force: &PairForce) -> [Vec<String>; 2] {
    let title = format!("∂F/∂d, ∂F/∂va, ∂F/∂vb in {}.", counted(derivation.model.dimension, "coordinate"));
    let lines = formulas(derivation).components("F", "", &force.formulas);
    [block("The force on a from b.", &lines, &force.force), costly(&title, &force.jacobians)]
}

/// The whole derivation as a text.
pub(super) fn derivation(derivation: &PairDerivation) -> String {
    let PairDerivation { model, lowered, kernels, .. } = derivation;
    let place = match model.dimension {
        0 => "any number of dimensions".to_owned(),
        d => counted(d, "dimension"),
    };
    let (mut formulas, mut found, mut costs) = (formulas(derivation), vec![], vec![]);
    if let Some(potential) = &kernels.potential {
        found.push(match &potential.formulas {
            PairFormulas::Radial(of_distance) => {
                formulas.lines.extend(radial(derivation, of_distance));
                "a potential of the distance: the force is along d".into()
            }
            PairFormulas::Separation(of_separation) => {
                formulas.potential(of_separation);
                "a potential of the separation".into()
            }
        });
        found.push(if kernels.symmetric {
            "symmetric: neither body is the first".into()
        } else {
            "not symmetric: for chains and bonds, where one body is the first".into()
        });
        found.extend(of_degree(potential.degree.filter(|_| kernels.force.is_none())));
        costs.extend([("gradient", &potential.pointwise.gradient), ("hessian", &potential.pointwise.hessian)]);
        costs.push(("discrete gradient", &potential.pointwise.discrete_gradient));
    }
    if let Some(force) = &kernels.force {
        formulas.force(&force.formulas);
        for (by, rows) in ["∂", "∂va", "∂vb"].iter().zip(&force.derivatives) {
            formulas.jacobian(by, rows);
        }
        found.push(if force.depends_on_velocity {
            "the force depends on the velocity".into()
        } else {
            "the force does not depend on the velocity".into()
        });
        found.push(if force.reciprocal {
            "reciprocal: the force on b is opposite".into()
        } else {
            "not reciprocal: the linear momentum is not kept".into()
        });
        costs.extend([("force", &force.force), ("its Jacobians", &force.jacobians)]);
    }
    found.extend(of_time(lowered.parameters.iter()));
    let title = format!("{}, between two bodies in {place}, d = q_a − q_b", model.name);
    text(title, formulas.lines, found, &costs)
}

fn formulas(derivation: &PairDerivation) -> Formulas<'_> {
    Formulas { graph: &derivation.lowered.graph, dimension: derivation.model.dimension, lines: vec![] }
}

/// Φ, c and C of a potential of the distance, shown in r, which the graph of the programs does not have.
fn radial(derivation: &PairDerivation, radial: &Radial) -> [Line; 3] {
    let mut graph = derivation.lowered.graph.clone();
    let of = [("Φ", radial.potential), ("c", radial.coefficient), ("C(a, b)", radial.discrete_coefficient)];
    of.map(|(left, e): (&str, Expr)| {
        let e = derivation.pair.variables.in_distance(&mut graph, e);
        (left.to_owned(), shown(&graph, e))
    })
}
