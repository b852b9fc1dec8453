//! The derivation as documentation of the generated functions.

use dmech_symbolic::expression::{Expr, Graph};
use dmech_symbolic::kernel::Kernels;
use dmech_symbolic::program::Program;

/// The paragraphs above each function, in the order of the implementation.
pub(super) struct Documents {
    pub(super) texts: [Vec<String>; 8],
}

impl Documents {
    pub(super) fn new(graph: &Graph, kernels: &Kernels) -> Self {
        let formulas = &kernels.formulas;
        let dimension = formulas.gradient.len();
        let show = |e: Expr| shortened(graph.display(e).to_string());
        let component = |list: &[Expr], what: &str| -> Vec<String> {
            list.iter().enumerate().map(|(i, &e)| format!(" {what}{} = {}", subscript(i, dimension), show(e))).collect()
        };
        let block = |title: &str, lines: Vec<String>, cost: String| -> Vec<String> {
            let mut text = vec![format!(" {title}"), String::new(), " ```text".to_owned()];
            text.extend(lines);
            text.push(" ```".to_owned());
            if !cost.is_empty() {
                text.extend([String::new(), format!(" Cost: {cost}.")]);
            }
            text
        };
        let cost = |program: &Program| program.cost().to_string();
        let solution = |what: &str| vec![format!(" {what}")];
        Self {
            texts: [
                block("The potential.", vec![format!(" Φ = {}", show(formulas.potential))], cost(&kernels.potential)),
                block("The gradient.", component(&formulas.gradient, "∂Φ/∂"), cost(&kernels.gradient)),
                vec![format!(" The Hessian. Cost: {}.", cost(&kernels.hessian))],
                solution("v − c ∇Φ(q)."),
                block(
                    "The discrete gradient, exact for any gap between the ends a and b.",
                    component(&formulas.discrete_gradient, "∇̄Φ"),
                    cost(&kernels.discrete_gradient),
                ),
                vec![format!(" ∂∇̄Φ/∂b. Cost: {}.", cost(&kernels.discrete_gradient_jacobian))],
                solution("The increment of the trapezoidal step."),
                solution("The increment of the energy-exact steps."),
            ],
        }
    }
}

/// Long formulas explain nothing.
fn shortened(formula: String) -> String {
    const LONGEST: usize = 400;
    match formula.char_indices().nth(LONGEST) {
        Some((end, _)) => format!("{} …", &formula[..end]),
        None => formula,
    }
}

fn subscript(i: usize, dimension: usize) -> String {
    if dimension <= 3 { ["x", "y", "z"][i].to_owned() } else { format!("q{i}") }
}
