//! The derivation of a law between two bodies as documentation.

use dmech_symbolic::expression::{Expr, Graph};
use dmech_symbolic::kernel::{PairPotential, PairVariables};
use dmech_symbolic::program::Program;

use super::document::{block, count, shown, subscript};
use crate::PairDerivation;
use crate::lower::Source;

/// The paragraphs above each function.
pub(super) struct Documents {
    /// In the order of `Potential`.
    pub(super) potential: [Vec<String>; 5],
    /// F and its Jacobians.
    pub(super) force: [Vec<String>; 2],
}

/// A formula with what it is called.
type Line = (String, String);

impl Documents {
    pub(super) fn new(derivation: &PairDerivation) -> Self {
        let lines = Lines::new(derivation);
        let dimension = derivation.model.dimension;
        let cost = |program: &Program| program.cost().to_string();
        let page = |title: &str, lines: &[Line], cost: String| {
            block(title, lines.iter().map(|(left, right)| format!(" {left} = {right}")).collect(), cost)
        };
        let Lines { energy, gradient, discrete, force, .. } = &lines;
        let potential = match &derivation.kernels.potential {
            PairPotential::None => Default::default(),
            PairPotential::Radial(radial) => [
                page("The potential, of r = |d|.", energy, cost(&radial.energy)),
                page("The gradient, c d.", gradient, cost(&radial.gradient)),
                vec![format!(" The Hessian, c 1 + 2 c′ d⊗d with c′ = dc/dr². Cost: {}.", cost(&radial.hessian))],
                page(
                    "The discrete gradient, C (a + b): exact for any gap between the ends a and b.",
                    discrete,
                    cost(&radial.discrete_gradient),
                ),
                vec![format!(" ∂∇̄Φ/∂b. Cost: {}.", cost(&radial.discrete_gradient_jacobian))],
            ],
            PairPotential::Separation(separation) => [
                page("The potential, of the separation d.", energy, cost(&separation.energy)),
                page("The gradient.", gradient, cost(&separation.gradient)),
                vec![format!(" The Hessian. Cost: {}.", cost(&separation.hessian))],
                page(
                    "The discrete gradient, exact for any gap between the ends a and b.",
                    discrete,
                    cost(&separation.discrete_gradient),
                ),
                vec![format!(" ∂∇̄Φ/∂b. Cost: {}.", cost(&separation.discrete_gradient_jacobian))],
            ],
        };
        let force = match &derivation.kernels.force {
            None => Default::default(),
            Some(kernels) => [
                page("The force on a from b.", force, cost(&kernels.force)),
                vec![format!(
                    " ∂F/∂d, ∂F/∂va, ∂F/∂vb in {}. Cost: {}.",
                    count(dimension, "coordinate"),
                    cost(&kernels.jacobians)
                )],
            ],
        };
        Self { potential, force }
    }
}

/// The whole derivation as a text.
pub(super) fn derivation(derivation: &PairDerivation) -> String {
    let PairDerivation { model, lowered, kernels, .. } = derivation;
    let Lines { energy, gradient, hessian, discrete, force, jacobians } = Lines::new(derivation);
    let place = match model.dimension {
        0 => "any number of dimensions".to_owned(),
        d => count(d, "dimension"),
    };
    let mut text = vec![format!("{}, between two bodies in {place}, d = q_a − q_b", model.name)];
    for (left, right) in [energy, gradient, hessian, discrete, force, jacobians].into_iter().flatten() {
        text.push(format!("  {left} = {right}"));
    }
    text.push("structure".to_owned());
    let mut found = vec![];
    match &kernels.potential {
        PairPotential::None => {}
        PairPotential::Radial(_) => found.push("a potential of the distance: the force is along d"),
        PairPotential::Separation(_) => found.push("a potential of the separation"),
    }
    if !matches!(kernels.potential, PairPotential::None) {
        found.push(if kernels.symmetric {
            "symmetric: neither body is the first"
        } else {
            "not symmetric: for chains and bonds, where one body is the first"
        });
    }
    if let Some(force) = &kernels.force {
        found.push(if force.depends_on_velocity {
            "the force depends on the velocity"
        } else {
            "the force does not depend on the velocity"
        });
        found.push(if force.reciprocal {
            "reciprocal: the force on b is opposite"
        } else {
            "not reciprocal: the linear momentum is not kept"
        });
    }
    if lowered.parameters.iter().any(|p| matches!(p.source, Source::Time)) {
        found.push("names the time: the energy is not kept");
    }
    text.extend(found.into_iter().map(|line| format!("  {line}")));
    text.push("cost".to_owned());
    let mut costs = vec![];
    match &kernels.potential {
        PairPotential::None => {}
        PairPotential::Radial(radial) => costs.extend([
            ("gradient", &radial.gradient),
            ("hessian", &radial.hessian),
            ("discrete gradient", &radial.discrete_gradient),
        ]),
        PairPotential::Separation(separation) => costs.extend([
            ("gradient", &separation.gradient),
            ("hessian", &separation.hessian),
            ("discrete gradient", &separation.discrete_gradient),
        ]),
    }
    if let Some(force) = &kernels.force {
        costs.extend([("force", &force.force), ("its Jacobians", &force.jacobians)]);
    }
    text.extend(costs.into_iter().map(|(what, program)| format!("  {what:<18} {}", program.cost())));
    text.join("\n")
}

/// All formulas.
struct Lines {
    energy: Vec<Line>,
    gradient: Vec<Line>,
    hessian: Vec<Line>,
    discrete: Vec<Line>,
    force: Vec<Line>,
    jacobians: Vec<Line>,
}

impl Lines {
    fn new(derivation: &PairDerivation) -> Self {
        let PairDerivation { model, lowered, pair, kernels } = derivation;
        let dimension = model.dimension;
        let name = |i: usize| subscript(i, dimension);
        // Formulas of the distance are shown in r, which the graph of the programs does not have.
        let mut graph = lowered.graph.clone();
        let mut lines = Self {
            energy: vec![],
            gradient: vec![],
            hessian: vec![],
            discrete: vec![],
            force: vec![],
            jacobians: vec![],
        };
        match &kernels.potential {
            PairPotential::None => {}
            PairPotential::Radial(radial) => {
                let mut line =
                    |left: &str, e: Expr| vec![(left.to_owned(), in_distance(&mut graph, &pair.variables, e))];
                lines.energy = line("Φ", radial.potential);
                lines.gradient = line("c", radial.coefficient);
                lines.discrete = line("C(a, b)", radial.discrete_coefficient);
            }
            PairPotential::Separation(separation) => {
                let formulas = &separation.formulas;
                let components = |what: &str, end: &str, list: &[Expr]| -> Vec<Line> {
                    let of = |(i, &e): (usize, &Expr)| (format!("{what}{}{end}", name(i)), shown(&graph, e));
                    list.iter().enumerate().map(of).collect()
                };
                lines.energy = vec![("Φ".to_owned(), shown(&graph, formulas.potential))];
                lines.gradient = components("∂Φ/∂", "", &formulas.gradient);
                lines.discrete = components("∇̄Φ", "(a, b)", &formulas.discrete_gradient);
                for (i, row) in formulas.hessian.iter().enumerate() {
                    for (j, &e) in row.iter().enumerate().skip(i) {
                        lines.hessian.push((format!("∂²Φ/∂{}∂{}", name(i), name(j)), shown(&graph, e)));
                    }
                }
            }
        }
        if let Some(force) = &kernels.force {
            lines.force =
                force.formulas.iter().enumerate().map(|(i, &e)| (format!("F{}", name(i)), shown(&graph, e))).collect();
            for (by, rows) in ["", "va", "vb"].iter().zip(&force.derivatives) {
                for (i, row) in rows.iter().enumerate() {
                    for (j, &e) in row.iter().enumerate().filter(|(_, e)| !graph.is_zero(**e)) {
                        lines.jacobians.push((format!("∂F{}/∂{by}{}", name(i), name(j)), shown(&graph, e)));
                    }
                }
            }
        }
        lines
    }
}

fn in_distance(graph: &mut Graph, pair: &PairVariables, e: Expr) -> String {
    let e = pair.in_distance(graph, e);
    shown(graph, e)
}
