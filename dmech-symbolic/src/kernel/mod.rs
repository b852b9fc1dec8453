//! The programs that schemes need of a law, made for its structure.

mod forced;
mod mean;
mod newton;
mod pair;
mod vanishes;
mod variables;

pub use forced::{ForceFormulas, ForcedKernels, ForcedStep};
pub use mean::KickByMean;
pub use pair::{PairForce, PairFormulas, PairKernels, PairLaw, PairPotential, PairVariables, Radial};
pub use variables::{Variables, exchange};

use crate::calculus::{self, TwoPoints};
use crate::expression::{Expr, Graph, Substitution, Symbol};
use crate::linear::Corrections;
use crate::program::Program;
use crate::structure::{Central, Structure};

use newton::{Force, correction, dot, mirrored};

/// How an implicit step is solved.
#[derive(Clone, Debug)]
pub enum Step {
    /// Constant Hessian: one correction from Δ = 0 is the solution. Outputs: as of Newton's method.
    Linear(Program),
    /// Newton's method in all coordinates. Outputs of one correction: δ, G + J δ of the trapezoidal step; δ, G, J δ of the
    /// energy-exact steps; and then what is positive only where the solution [has grown](crate::linear::Solution::positive) from
    /// that of a step of no length.
    Newton(Program),
    /// One scalar unknown. Outputs: the coefficient of the force and its first two derivatives.
    Central(Program),
}

/// Everything generated for one potential.
#[derive(Clone, Debug)]
pub struct Kernels {
    /// Expressions, for display and tests.
    pub formulas: Formulas,
    /// What was detected.
    pub structure: Structure,
    /// Φ(q).
    pub potential: Program,
    /// ∇Φ(q).
    pub gradient: Program,
    /// The Hessian, row by row.
    pub hessian: Program,
    /// v − c ∇Φ(q).
    pub kick: Program,
    /// v − c ∇Φ(q) + e H ∇Φ(q).
    pub gradient_kick: Program,
    /// ∇̄Φ(a, b), symmetric to the bit.
    pub discrete_gradient: Program,
    /// ∂∇̄Φ/∂b, row by row.
    pub discrete_gradient_jacobian: Program,
    /// The trapezoidal step.
    pub implicit: Step,
    /// The energy-exact steps.
    pub discrete: Step,
}

/// The formulas behind the programs.
#[derive(Clone, Debug)]
pub struct Formulas {
    /// Φ(q).
    pub potential: Expr,
    /// ∇Φ(q).
    pub gradient: Vec<Expr>,
    /// ∂²Φ/∂q∂q.
    pub hessian: Vec<Vec<Expr>>,
    /// ∇̄Φ(a, b).
    pub discrete_gradient: Vec<Expr>,
    /// ∂∇̄Φ/∂b.
    pub discrete_gradient_jacobian: Vec<Vec<Expr>>,
}

impl Kernels {
    /// Derives everything from Φ, written in `variables.q`.
    pub fn new(graph: &mut Graph, phi: Expr, variables: &Variables) -> Self {
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
        let exchange = exchange(graph, variables);
        Self {
            potential: Program::schedule(graph, &[phi]),
            gradient: Program::schedule(graph, &formulas.gradient),
            hessian: Program::schedule(graph, &formulas.hessian.concat()),
            kick,
            gradient_kick,
            discrete_gradient: Program::schedule_symmetric(graph, &formulas.discrete_gradient, exchange),
            discrete_gradient_jacobian: Program::schedule(graph, &formulas.discrete_gradient_jacobian.concat()),
            implicit,
            discrete,
            formulas,
            structure,
        }
    }

    /// The programs at a point, or between two: potential, gradient, Hessian, discrete gradient and its Jacobian.
    pub fn pointwise(&self) -> [&Program; 5] {
        let Self { potential, gradient, hessian, discrete_gradient, discrete_gradient_jacobian, .. } = self;
        [potential, gradient, hessian, discrete_gradient, discrete_gradient_jacobian]
    }
}

impl Formulas {
    fn new(
        graph: &mut Graph,
        potential: Expr,
        gradient: Vec<Expr>,
        hessian: Vec<Vec<Expr>>,
        variables: &Variables,
    ) -> Self {
        let mut ends = TwoPoints::new(graph, &variables.q, &variables.a, &variables.b);
        let discrete_gradient = calculus::discrete_gradient(graph, potential, &mut ends);
        let discrete_gradient_jacobian = calculus::jacobian(graph, &discrete_gradient, &variables.b);
        Self { potential, gradient, hessian, discrete_gradient, discrete_gradient_jacobian }
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
    let directions: Vec<_> = along.iter().map(|&u| graph.symbol(u)).collect();
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
        return Step::Central(with_two_derivatives(graph, coefficient, central.s, variables.s));
    }
    let at_b: Vec<_> = variables.b.iter().map(|&b| graph.symbol(b)).collect();
    let mut moved = Substitution::new(graph, variables.q.iter().copied().zip(at_b));
    let force: Vec<_> = formulas.gradient.iter().map(|&e| moved.apply(graph, e)).collect();
    let jacobian: Vec<Vec<_>> =
        formulas.hessian.iter().map(|row| row.iter().map(|&e| moved.apply(graph, e)).collect()).collect();
    let program =
        correction(graph, &force, &jacobian, Corrections::of(structure.constant_hessian), Force::Rounded, variables);
    if structure.constant_hessian { Step::Linear(program) } else { Step::Newton(program) }
}

fn discrete_step(graph: &mut Graph, formulas: &Formulas, structure: &Structure, variables: &Variables) -> Step {
    if let Some(central) = structure.one_unknown() {
        let coefficient = central.discrete_coefficient(graph, variables.s_a, variables.s_b);
        return Step::Central(with_two_derivatives(graph, coefficient, variables.s_b, variables.s_b));
    }
    let (force, jacobian) = (&formulas.discrete_gradient, &formulas.discrete_gradient_jacobian);
    if structure.constant_hessian {
        Step::Linear(correction(graph, force, &mirrored(jacobian), Corrections::One, Force::InParts, variables))
    } else {
        Step::Newton(correction(graph, force, jacobian, Corrections::Several, Force::InParts, variables))
    }
}

/// f, f′, f″ with respect to one symbol, which is then called by another name.
fn with_two_derivatives(graph: &mut Graph, f: Expr, symbol: Symbol, name: Symbol) -> Program {
    let first = calculus::tangent(graph, f, &[symbol])[0];
    let second = calculus::tangent(graph, first, &[symbol])[0];
    let new_name = graph.symbol(name);
    let mut renamed = Substitution::new(graph, [(symbol, new_name)]);
    let outputs = [f, first, second].map(|e| renamed.apply(graph, e));
    Program::schedule(graph, &outputs)
}
