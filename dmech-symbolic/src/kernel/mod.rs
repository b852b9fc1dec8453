//! The programs that schemes need of a law, made for its structure.

mod forced;
mod mean;
mod newton;
mod pair;
mod pointwise;
mod step;
mod vanishes;
mod variables;

pub use forced::{ForceFormulas, ForcedKernels, ForcedStep};
pub use mean::KickByMean;
pub use pair::{PairForce, PairFormulas, PairKernels, PairLaw, PairPotential, PairVariables, Radial};
pub use pointwise::{Formulas, Pointwise};
pub use step::{Given, Step, Way};
pub use variables::{Variables, exchange};

use crate::calculus;
use crate::expression::{Expr, Graph, Substitution, Symbol};
use crate::linear::{Asked, Corrections};
use crate::program::Program;
use crate::structure::{Central, Structure};

use newton::{correction, dot, mirrored};

/// Everything generated for one potential.
#[derive(Clone, Debug)]
pub struct Kernels {
    /// Expressions, for display and tests.
    pub formulas: Formulas,
    /// What was detected.
    pub structure: Structure,
    /// The potential and its derivatives.
    pub pointwise: Pointwise,
    /// v − c ∇Φ(q).
    pub kick: Program,
    /// v − c ∇Φ(q) + e H ∇Φ(q).
    pub gradient_kick: Program,
    /// The trapezoidal step.
    pub implicit: Step,
    /// The energy-exact steps.
    pub discrete: Step,
}

impl Kernels {
    /// Derives everything from Φ, written in `variables.q`.
    pub fn new(graph: &mut Graph, phi: Expr, variables: &Variables) -> Self {
        let phi = calculus::with_whole_choices(graph, phi);
        let gradient = calculus::gradient(graph, phi, &variables.q);
        let hessian = calculus::hessian(graph, phi, &variables.q);
        let structure = Structure::of(graph, phi, &hessian, &variables.q);
        let formulas = Formulas::new(graph, phi, gradient, hessian, variables);
        let implicit = implicit_step(graph, &formulas, &structure, variables);
        let discrete = discrete_step(graph, &formulas, &structure, variables);
        let kick = kick(graph, &formulas.gradient, variables);
        let gradient_kick = match structure.central {
            Some(central) => central_gradient_kick(graph, central, variables),
            None => gradient_kick(graph, &formulas, variables),
        };
        let pointwise = formulas.programs(graph, variables);
        Self { pointwise, kick, gradient_kick, implicit, discrete, formulas, structure }
    }
}

fn kick(graph: &mut Graph, gradient: &[Expr], variables: &Variables) -> Program {
    let c = graph.symbol(variables.c);
    let kicked: Vec<_> = variables
        .v
        .iter()
        .zip(gradient)
        .map(|(&v, &slope)| {
            let (v, kick) = (graph.symbol(v), graph.mul(&[c, slope]));
            graph.sub(v, kick)
        })
        .collect();
    Program::schedule(graph, &kicked)
}

/// v − c ∇Φ + e H ∇Φ.
///
/// H u is the gradient of u·∇Φ with u held fixed, which costs a few gradients; row by row H costs one for each coordinate.
/// In few coordinates rows may still be shorter, as H is symmetric.
fn gradient_kick(graph: &mut Graph, formulas: &Formulas, variables: &Variables) -> Program {
    let gradient = &formulas.gradient;
    let along: Vec<_> = (0..gradient.len()).map(|i| graph.parameter(&format!("u{i}"))).collect();
    let directions = graph.symbols(&along);
    let change = dot(graph, &directions, gradient);
    let turned = calculus::tangent(graph, change, &variables.q);
    let mut itself = Substitution::new(graph, along.into_iter().zip(gradient.iter().copied()));
    let turned: Vec<_> = turned.into_iter().map(|e| itself.apply(graph, e)).collect();
    let whole = kick_and_turn(graph, gradient, &turned, variables);
    if gradient.len() > 3 {
        return whole;
    }
    let by_rows = jacobian_kick(graph, gradient, &formulas.hessian, variables);
    if whole.operations.len() < by_rows.operations.len() { whole } else { by_rows }
}

/// v − c s + e J s, with a slope s and its Jacobian J, which need not be symmetric.
fn jacobian_kick(graph: &mut Graph, slope: &[Expr], jacobian: &[Vec<Expr>], variables: &Variables) -> Program {
    let turned: Vec<_> = jacobian.iter().map(|row| dot(graph, row, slope)).collect();
    kick_and_turn(graph, slope, &turned, variables)
}

/// v − c s + e w.
fn kick_and_turn(graph: &mut Graph, slope: &[Expr], turned: &[Expr], variables: &Variables) -> Program {
    let [c, e] = [variables.c, variables.e].map(|s| graph.symbol(s));
    let kicked: Vec<_> = variables
        .v
        .iter()
        .zip(slope.iter().zip(turned))
        .map(|(&v, (&s, &w))| {
            let (v, kick, turn) = (graph.symbol(v), graph.mul(&[c, s]), graph.mul(&[e, w]));
            let kicked = graph.sub(v, kick);
            graph.add(&[kicked, turn])
        })
        .collect();
    Program::schedule(graph, &kicked)
}

/// With ∇Φ = f q, f a function of s = |q|²: |∇Φ|² = s f², so that H ∇Φ = f (f + 2 s f′) q, and one factor of q is the kick.
fn central_gradient_kick(graph: &mut Graph, central: Central, variables: &Variables) -> Program {
    let f = central.coefficient(graph);
    let slope = calculus::tangent(graph, f, &[central.s])[0];
    let s = graph.symbol(central.s);
    let rest = graph.mul(&[s, slope]);
    let rest = graph.scale(2.0, rest);
    let radial = graph.add(&[f, rest]);
    let [c, e] = [variables.c, variables.e].map(|s| graph.symbol(s));
    let change = graph.mul(&[e, radial]);
    let length = graph.sub(c, change);
    let factor = graph.mul(&[f, length]);
    let squares = crate::structure::squares(graph, &variables.q);
    let squared_distance = graph.add(&squares);
    let factor = Substitution::new(graph, [(central.s, squared_distance)]).apply(graph, factor);
    let coordinates = variables.v.iter().zip(&variables.q);
    let kicked: Vec<_> = coordinates
        .map(|(&v, &q)| {
            let (v, q) = (graph.symbol(v), graph.symbol(q));
            let kick = graph.mul(&[factor, q]);
            graph.sub(v, kick)
        })
        .collect();
    Program::schedule(graph, &kicked)
}

fn implicit_step(graph: &mut Graph, formulas: &Formulas, structure: &Structure, variables: &Variables) -> Step {
    if let Some(central) = structure.one_unknown() {
        let coefficient = central.coefficient(graph);
        return one_unknown(graph, coefficient, central.s, variables.s, Given::Rounded);
    }
    let at_b = graph.symbols(&variables.b);
    let mut moved = Substitution::new(graph, variables.q.iter().copied().zip(at_b));
    let force: Vec<_> = formulas.gradient.iter().map(|&e| moved.apply(graph, e)).collect();
    let jacobian: Vec<Vec<_>> =
        formulas.hessian.iter().map(|row| row.iter().map(|&e| moved.apply(graph, e)).collect()).collect();
    let corrections = Corrections::of(structure.constant_hessian);
    correction(graph, &force, &jacobian, corrections, Given::Rounded, variables)
}

fn discrete_step(graph: &mut Graph, formulas: &Formulas, structure: &Structure, variables: &Variables) -> Step {
    if let Some(central) = structure.one_unknown() {
        let coefficient = central.discrete_coefficient(graph, variables.s_a, variables.s_b);
        return one_unknown(graph, coefficient, variables.s_b, variables.s_b, Given::InParts);
    }
    let (force, jacobian) = (&formulas.discrete_gradient, &formulas.discrete_gradient_jacobian);
    let (linear, corrections) = (structure.constant_hessian, Corrections::of(structure.constant_hessian));
    let jacobian = if linear { &mirrored(jacobian) } else { jacobian };
    correction(graph, force, jacobian, corrections, Given::InParts, variables)
}

/// The step of a force along q: f, f′, f″ with respect to one symbol, which is then called by another name.
fn one_unknown(graph: &mut Graph, f: Expr, symbol: Symbol, name: Symbol, given: Given) -> Step {
    let first = calculus::tangent(graph, f, &[symbol])[0];
    let second = calculus::tangent(graph, first, &[symbol])[0];
    let new_name = graph.symbol(name);
    let mut renamed = Substitution::new(graph, [(symbol, new_name)]);
    let outputs = [f, first, second].map(|e| renamed.apply(graph, e));
    Step { way: Way::Central, given, asked: Asked::Positive, program: Program::schedule(graph, &outputs) }
}
