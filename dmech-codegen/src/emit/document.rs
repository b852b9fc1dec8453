//! The derivation as documentation of the generated functions.

use std::borrow::Cow;
use std::fmt::Write;

use dmech_symbolic::expression::{Expr, Graph};
use dmech_symbolic::kernel::{self, ForcedKernels, Kernels, Step, Way};
use dmech_symbolic::program::Program;

use crate::Derivation;
use crate::diagnostics::counted;
use crate::lower::{Parameter, Source};

/// The paragraphs above the functions of `Potential` at a point, or between two.
pub(super) fn pointwise_texts(graph: &Graph, kernels: &Kernels) -> [Vec<String>; 5] {
    let formulas = Formulas { graph, dimension: kernels.formulas.gradient.len(), lines: vec![] };
    texts("The potential.", "", &formulas, &kernels.formulas, kernels.pointwise.each())
}

/// The same with the title of the potential, and how ends are named.
pub(super) fn texts(
    title: &str,
    ends: &str,
    formulas: &Formulas<'_>,
    found: &kernel::Formulas,
    programs: [&Program; 5],
) -> [Vec<String>; 5] {
    let [potential, gradient, hessian, discrete, jacobian] = programs;
    [
        block(title, &[("Φ".to_owned(), shown(formulas.graph, found.potential))], potential),
        block("The gradient.", &formulas.components("∂Φ/∂", "", &found.gradient), gradient),
        costly("The Hessian.", hessian),
        block(
            "The discrete gradient, exact for any gap between the ends a and b.",
            &formulas.components("∇̄Φ", ends, &found.discrete_gradient),
            discrete,
        ),
        costly(OF_THE_END, jacobian),
    ]
}

/// What is said of the Jacobian of the discrete gradient.
pub(super) const OF_THE_END: &str = "∂∇̄Φ/∂b.";

/// A formula with what it is called.
pub(super) type Line = (String, String);

/// A title, formulas, and what they cost.
pub(super) fn block(title: &str, lines: &[Line], program: &Program) -> Vec<String> {
    let mut text = vec![format!(" {title}"), String::new(), " ```text".to_owned()];
    text.extend(lines.iter().map(|(left, right)| format!(" {left} = {right}")));
    text.extend([" ```".to_owned(), String::new(), format!(" Cost: {}.", program.cost())]);
    text
}

/// A title and what it costs, where formulas would be too long.
pub(super) fn costly(title: &str, program: &Program) -> Vec<String> {
    vec![format!(" {title} Cost: {}.", program.cost())]
}

/// The paragraphs above `force`, `force_dq` and `force_dv`; of a Jacobian the entries that are not zero.
pub(super) fn force_texts(graph: &Graph, forced: &ForcedKernels) -> [Vec<String>; 3] {
    let found = &forced.formulas;
    let formulas = || Formulas { graph, dimension: found.force.len(), lines: vec![] };
    let jacobian = |title: &str, by: &str, rows: &[Vec<Expr>], program: &Program| {
        let mut formulas = formulas();
        formulas.jacobian(by, rows);
        match &formulas.lines[..] {
            [] => vec![format!(" {title} It vanishes.")],
            lines => block(title, lines, program),
        }
    };
    [
        block("The force.", &formulas().components("F", "", &found.force), &forced.force),
        jacobian("∂F/∂q.", "∂", &found.force_dq, &forced.force_dq),
        jacobian("∂F/∂v.", "∂v", &found.force_dv, &forced.force_dv),
    ]
}

/// The line above the function that solves a step.
pub(super) fn increment(what: &str, step: &Step) -> String {
    format!(" The increment Δ of {what}. {}", way(step))
}

/// How a step is solved, which follows from the structure of the law.
fn way(step: &Step) -> &'static str {
    match step.way {
        Way::Linear => "It is linear in Δ: one solve, no iteration.",
        Way::Central => "The force is along q: one unknown, s = |q + Δ|²; here its coefficient and two derivatives.",
        Way::Newton => "One Newton correction.",
    }
}

/// The whole derivation as a text.
pub(super) fn derivation(derivation: &Derivation) -> String {
    let Derivation { model, lowered, kernels, forced, .. } = derivation;
    let mut formulas = Formulas { graph: &lowered.graph, dimension: model.dimension, lines: vec![] };
    let mut costs = vec![("kick", &kernels.kick)];
    if model.potential.is_some() {
        formulas.potential(&kernels.formulas);
        costs.extend([("gradient", &kernels.pointwise.gradient), ("hessian", &kernels.pointwise.hessian)]);
        costs.push(("discrete gradient", &kernels.pointwise.discrete_gradient));
    }
    if let Some(forced) = forced {
        formulas.force(&forced.formulas.force);
        formulas.jacobian("∂", &forced.formulas.force_dq);
        formulas.jacobian("∂v", &forced.formulas.force_dv);
        costs[0].1 = &forced.kick;
        costs.push(("force", &forced.force));
    }
    let kept = model.invariants.iter().zip(&lowered.invariants);
    formulas.lines.extend(kept.map(|(method, &e)| (method.ident.to_string(), shown(&lowered.graph, e))));
    let title = format!("{}, {}", model.name, counted(model.dimension, "coordinate"));
    text(title, formulas.lines, structure(derivation), &costs)
}

/// A title, formulas, findings and costs as one text.
pub(super) fn text(title: String, formulas: Vec<Line>, found: Vec<Cow<'_, str>>, costs: &[(&str, &Program)]) -> String {
    let formulas = formulas.into_iter().map(|(left, right)| format!("  {left} = {right}"));
    let found = found.into_iter().map(|line| format!("  {line}"));
    let costs = costs.iter().map(|(what, program)| format!("  {what:<18} {}", program.cost()));
    let lines = [title].into_iter().chain(formulas).chain(["structure".to_owned()]).chain(found);
    lines.chain(["cost".to_owned()]).chain(costs).collect::<Vec<_>>().join("\n")
}

/// What the engine found out about a law, in words.
fn structure(derivation: &Derivation) -> Vec<Cow<'static, str>> {
    let Derivation { lowered, kernels, forced, .. } = derivation;
    let mut found: Vec<Cow<'_, str>> = vec![Cow::Borrowed(match forced {
        Some(forced) if forced.workless => "F·v = 0: the force does no work, the energy is kept",
        Some(forced) if forced.depends_on_velocity => "the force depends on the velocity",
        Some(_) => "the force does not depend on the velocity",
        None if kernels.structure.constant_hessian => "linear: implicit steps need no iteration",
        None if kernels.structure.one_unknown().is_some() => "central: implicit steps have one scalar unknown",
        None if kernels.structure.central.is_some() => "central, with a choice: Newton in all coordinates",
        None if kernels.structure.diagonal_hessian && kernels.formulas.gradient.len() > 1 => {
            "the coordinates do not interact: implicit steps are solved one by one"
        }
        None => "no special structure: Newton in all coordinates",
    })];
    found.extend(of_degree(kernels.structure.degree.filter(|_| forced.is_none())));
    if forced.as_ref().map_or(kernels.structure.piecewise, |forced| forced.piecewise) {
        found.push("piecewise: across a seam the discrete gradient is the quotient of what it must make up".into());
    }
    let acting = || lowered.force.iter().flatten().chain([&lowered.potential]);
    let acts = |p: &&Parameter| acting().any(|&e| lowered.graph.depends_on(e, &[p.symbol]));
    found.extend(of_time(lowered.parameters.iter().filter(acts)));
    found
}

/// The degree of a potential that is a polynomial.
pub(super) fn of_degree(degree: Option<u32>) -> Option<Cow<'static, str>> {
    Some(format!("a polynomial of degree {}", degree?).into())
}

/// What follows from naming the time.
pub(super) fn of_time<'a>(mut parameters: impl Iterator<Item = &'a Parameter>) -> Option<Cow<'static, str>> {
    let names_time = parameters.any(|p| matches!(p.source, Source::Time));
    names_time.then_some("names the time: the energy is not kept".into())
}

/// Formulas of a law, each with what it is called.
pub(super) struct Formulas<'a> {
    pub(super) graph: &'a Graph,
    pub(super) dimension: usize,
    pub(super) lines: Vec<Line>,
}

impl Formulas<'_> {
    fn add(&mut self, left: String, right: Expr) {
        self.lines.push((left, shown(self.graph, right)));
    }

    /// One formula for each coordinate.
    pub(super) fn components(&self, what: &str, of: &str, list: &[Expr]) -> Vec<Line> {
        let line = |(i, &e)| (format!("{what}{}{of}", subscript(i, self.dimension)), shown(self.graph, e));
        list.iter().enumerate().map(line).collect()
    }

    /// Φ, its gradient, half of its Hessian, its discrete gradient.
    pub(super) fn potential(&mut self, formulas: &kernel::Formulas) {
        self.add("Φ".to_owned(), formulas.potential);
        self.lines.extend(self.components("∂Φ/∂", "", &formulas.gradient));
        let name = |i: usize| subscript(i, formulas.gradient.len());
        for (i, row) in formulas.hessian.iter().enumerate() {
            for (j, &e) in row.iter().enumerate().skip(i) {
                self.add(format!("∂²Φ/∂{}∂{}", name(i), name(j)), e);
            }
        }
        self.lines.extend(self.components("∇̄Φ", "(a, b)", &formulas.discrete_gradient));
    }

    pub(super) fn force(&mut self, force: &[Expr]) {
        self.lines.extend(self.components("F", "", force));
    }

    /// The entries of ∂F/∂… that are not zero.
    pub(super) fn jacobian(&mut self, by: &str, rows: &[Vec<Expr>]) {
        let name = |i: usize| subscript(i, rows.len());
        for (i, row) in rows.iter().enumerate() {
            for (j, &e) in row.iter().enumerate().filter(|(_, e)| !self.graph.is_zero(**e)) {
                let line = (format!("∂F{}/{by}{}", name(i), name(j)), shown(self.graph, e));
                self.lines.push(line);
            }
        }
    }
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
