//! The derivation as documentation of the generated functions.

use std::fmt::Write;

use dmech_symbolic::expression::{Expr, Graph};
use dmech_symbolic::kernel::{ForcedKernels, Kernels, Step};
use dmech_symbolic::program::Program;

use crate::Derivation;
use crate::lower::Source;

/// The paragraphs above each function, in the order of the implementation.
pub(super) struct Documents {
    pub(super) texts: [Vec<String>; 9],
}

impl Documents {
    pub(super) fn new(graph: &Graph, kernels: &Kernels) -> Self {
        let formulas = &kernels.formulas;
        let dimension = formulas.gradient.len();
        let show = |e: Expr| shown(graph, e);
        let component = |list: &[Expr], what: &str| -> Vec<String> {
            list.iter().enumerate().map(|(i, &e)| format!(" {what}{} = {}", subscript(i, dimension), show(e))).collect()
        };
        let cost = |program: &Program| program.cost().to_string();
        Self {
            texts: [
                block("The potential.", vec![format!(" Φ = {}", show(formulas.potential))], cost(&kernels.potential)),
                block("The gradient.", component(&formulas.gradient, "∂Φ/∂"), cost(&kernels.gradient)),
                vec![format!(" The Hessian. Cost: {}.", cost(&kernels.hessian))],
                block(
                    "The discrete gradient, exact for any gap between the ends a and b.",
                    component(&formulas.discrete_gradient, "∇̄Φ"),
                    cost(&kernels.discrete_gradient),
                ),
                vec![format!(" ∂∇̄Φ/∂b. Cost: {}.", cost(&kernels.discrete_gradient_jacobian))],
                vec![" v − c ∇Φ(q).".to_owned()],
                vec![format!(" v − c ∇Φ(q) + e H ∇Φ(q), H the Hessian. Cost: {}.", cost(&kernels.gradient_kick))],
                vec![increment("the trapezoidal step: Δ + g ∇Φ(q + Δ) = c", &kernels.implicit)],
                vec![increment("the energy-exact steps: Δ + g ∇̄Φ(a, q + Δ) = c", &kernels.discrete)],
            ],
        }
    }
}

/// A title, formulas, and what they cost.
pub(super) fn block(title: &str, lines: Vec<String>, cost: String) -> Vec<String> {
    let mut text = vec![format!(" {title}"), String::new(), " ```text".to_owned()];
    text.extend(lines);
    text.push(" ```".to_owned());
    if !cost.is_empty() {
        text.extend([String::new(), format!(" Cost: {cost}.")]);
    }
    text
}

/// The paragraphs above `force`, `force_dq` and `force_dv`; of a Jacobian the entries that are not zero.
pub(super) fn force_texts(graph: &Graph, forced: &ForcedKernels) -> [Vec<String>; 3] {
    let formulas = &forced.formulas;
    let name = |i: usize| subscript(i, formulas.force.len());
    let force = formulas.force.iter().enumerate();
    let force = force.map(|(i, &e)| format!(" F{} = {}", name(i), shown(graph, e))).collect();
    let jacobian = |title: &str, by: &str, rows: &[Vec<Expr>], program: &Program| {
        let mut lines = vec![];
        for (i, row) in rows.iter().enumerate() {
            for (j, &e) in row.iter().enumerate().filter(|(_, e)| !graph.is_zero(**e)) {
                lines.push(format!(" ∂F{}/{by}{} = {}", name(i), name(j), shown(graph, e)));
            }
        }
        if lines.is_empty() {
            vec![format!(" {title} It vanishes.")]
        } else {
            block(title, lines, program.cost().to_string())
        }
    };
    [
        block("The force.", force, forced.force.cost().to_string()),
        jacobian("∂F/∂q.", "∂", &formulas.force_dq, &forced.force_dq),
        jacobian("∂F/∂v.", "∂v", &formulas.force_dv, &forced.force_dv),
    ]
}

/// The line above the function that solves a step.
pub(super) fn increment(what: &str, step: &Step) -> String {
    format!(" The increment Δ of {what}. {}", way(step))
}

/// How a step is solved, which follows from the structure of the law.
fn way(step: &Step) -> &'static str {
    match step {
        Step::Linear(_) => "It is linear in Δ: one solve, no iteration.",
        Step::Central(_) => {
            "The force is along q: one unknown, s = |q + Δ|²; here its coefficient and two derivatives."
        }
        Step::Newton(_) => "One Newton correction.",
    }
}

/// The whole derivation as a text.
pub(super) fn derivation(derivation: &Derivation) -> String {
    let Derivation { model, lowered, kernels, forced } = derivation;
    let graph = &lowered.graph;
    let dimension = model.dimension;
    let name = |i: usize| subscript(i, dimension);
    let mut text = Text { lines: vec![format!("{}, {}", model.name, count(dimension, "coordinate"))], graph };
    if model.potential.is_some() {
        let formulas = &kernels.formulas;
        text.formula("Φ".to_owned(), formulas.potential);
        for (i, &e) in formulas.gradient.iter().enumerate() {
            text.formula(format!("∂Φ/∂{}", name(i)), e);
        }
        for (i, row) in formulas.hessian.iter().enumerate() {
            for (j, &e) in row.iter().enumerate().skip(i) {
                text.formula(format!("∂²Φ/∂{}∂{}", name(i), name(j)), e);
            }
        }
        for (i, &e) in formulas.discrete_gradient.iter().enumerate() {
            text.formula(format!("∇̄Φ{}(a, b)", name(i)), e);
        }
    }
    if let Some(forced) = forced {
        let formulas = &forced.formulas;
        for (i, &e) in formulas.force.iter().enumerate() {
            text.formula(format!("F{}", name(i)), e);
        }
        for (what, rows) in [("∂", &formulas.force_dq), ("∂v", &formulas.force_dv)] {
            for (i, row) in rows.iter().enumerate() {
                for (j, &e) in row.iter().enumerate().filter(|(_, e)| !graph.is_zero(**e)) {
                    text.formula(format!("∂F{}/{what}{}", name(i), name(j)), e);
                }
            }
        }
    }
    text.lines.push("structure".to_owned());
    for found in structure(derivation) {
        text.lines.push(format!("  {found}"));
    }
    text.lines.push("cost".to_owned());
    let mut costs = vec![("kick", &kernels.kick)];
    if model.potential.is_some() {
        costs.extend([("gradient", &kernels.gradient), ("hessian", &kernels.hessian)]);
        costs.push(("discrete gradient", &kernels.discrete_gradient));
    }
    if let Some(forced) = forced {
        costs[0].1 = &forced.kick;
        costs.push(("force", &forced.force));
    }
    for (what, program) in costs {
        text.lines.push(format!("  {what:<18} {}", program.cost()));
    }
    text.lines.join("\n")
}

/// What the engine found out about a law, in words.
fn structure(derivation: &Derivation) -> Vec<&'static str> {
    let Derivation { lowered, kernels, forced, .. } = derivation;
    let mut found = vec![];
    match forced {
        Some(forced) => {
            if forced.workless {
                found.push("F·v = 0: the force does no work, the energy is kept");
            } else if forced.depends_on_velocity {
                found.push("the force depends on the velocity");
            } else {
                found.push("the force does not depend on the velocity");
            }
        }
        None if kernels.structure.constant_hessian => found.push("linear: implicit steps need no iteration"),
        None if kernels.structure.one_unknown().is_some() => {
            found.push("central: implicit steps have one scalar unknown");
        }
        None if kernels.structure.central.is_some() => found.push("central, with a choice: Newton in all coordinates"),
        None if kernels.structure.diagonal_hessian && kernels.formulas.gradient.len() > 1 => {
            found.push("the coordinates do not interact: implicit steps are solved one by one");
        }
        None => found.push("no special structure: Newton in all coordinates"),
    }
    if forced.as_ref().map_or(kernels.structure.piecewise, |forced| forced.piecewise) {
        found.push("piecewise: across a seam the discrete gradient is the quotient of what it must make up");
    }
    if lowered.parameters.iter().any(|p| matches!(p.source, Source::Time)) {
        found.push("names the time: the energy is not kept");
    }
    found
}

/// Lines of formulas.
struct Text<'a> {
    lines: Vec<String>,
    graph: &'a Graph,
}

impl Text<'_> {
    fn formula(&mut self, left: String, right: Expr) {
        let right = shown(self.graph, right);
        self.lines.push(format!("  {left} = {right}"));
    }
}

pub(super) fn count(n: usize, what: &str) -> String {
    format!("{n} {what}{}", if n == 1 { "" } else { "s" })
}

/// Long formulas explain nothing.
pub(super) fn shown(graph: &Graph, e: Expr) -> String {
    let mut page = Page { text: String::new(), left: 400 };
    // What does not fit is not even computed: written out, a formula can be far larger than its graph.
    if write!(page, "{}", graph.display(e)).is_err() {
        page.text.push_str(" …");
    }
    page.text
}

/// A text that refuses more than so many characters.
struct Page {
    text: String,
    left: usize,
}

impl Write for Page {
    fn write_str(&mut self, part: &str) -> std::fmt::Result {
        for character in part.chars() {
            self.left = self.left.checked_sub(1).ok_or(std::fmt::Error)?;
            self.text.push(character);
        }
        Ok(())
    }
}

pub(super) fn subscript(i: usize, dimension: usize) -> String {
    if dimension <= 3 { ["x", "y", "z"][i].to_owned() } else { format!("q{i}") }
}
