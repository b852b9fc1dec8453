//! A law in the engine: the programs that are tried.

use dmech_scalar::Real;
use dmech_symbolic::calculus::{self, TwoPoints};
use dmech_symbolic::expression::{Expr, Graph, Symbol};
use dmech_symbolic::kernel::{Variables, exchange};
use dmech_symbolic::program::Program;
use dmech_symbolic::structure::Structure;

use super::grow::Law;
use super::tree::PARAMETERS;

/// The programs of a law.
pub struct Engine {
    variables: Variables,
    parameters: Vec<Symbol>,
    /// Φ(q).
    pub potential: Program,
    /// ∇Φ(q).
    pub gradient: Program,
    /// ∇̄Φ(a, b).
    pub discrete_gradient: Program,
    /// What costs most to derive.
    pub second: Option<Second>,
}

/// Second derivatives, and what they show.
pub struct Second {
    /// What was detected.
    pub structure: Structure,
    /// The Hessian, row by row.
    pub hessian: Program,
    /// ∂∇̄Φ/∂b, row by row.
    pub jacobian: Program,
}

impl Engine {
    /// Derives what is tried of a law; second derivatives too, if `second` says so.
    pub fn new(law: &Law, second: bool) -> Self {
        let mut graph = Graph::new();
        let g = &mut graph;
        let variables = Variables::new(g, law.dimension);
        let parameters: Vec<_> = (0..PARAMETERS.len()).map(|i| g.parameter(&format!("p{i}"))).collect();
        let mut list = |names: &[Symbol]| names.iter().map(|&s| g.symbol(s)).collect::<Vec<Expr>>();
        let (q, p) = (list(&variables.q), list(&parameters));
        let phi = law.tree.build(g, &q, &p);
        let gradient = calculus::gradient(g, phi, &variables.q);
        let mut ends = TwoPoints::new(g, &variables.q, &variables.a, &variables.b);
        let discrete_gradient = calculus::discrete_gradient(g, phi, &mut ends);
        let second = second.then(|| {
            let hessian = calculus::hessian(g, phi, &variables.q);
            let jacobian = calculus::jacobian(g, &discrete_gradient, &variables.b).concat();
            Second {
                structure: Structure::of(g, phi, &hessian, &variables.q),
                hessian: Program::schedule(g, &hessian.concat()),
                jacobian: Program::schedule(g, &jacobian),
            }
        });
        let exchange = exchange(g, &variables);
        Self {
            potential: Program::schedule(g, &[phi]),
            gradient: Program::schedule(g, &gradient),
            discrete_gradient: Program::schedule_symmetric(g, &discrete_gradient, exchange),
            second,
            variables,
            parameters,
        }
    }

    /// The results of a program of one point.
    pub fn at<R: Real>(&self, program: &Program, q: &[R]) -> Vec<R> {
        self.between(program, q, q)
    }

    /// The results of a program of two points.
    pub fn between<R: Real>(&self, program: &Program, a: &[R], b: &[R]) -> Vec<R> {
        let Variables { q, a: at_a, b: at_b, .. } = &self.variables;
        program.run(|symbol| {
            let value = |names: &[Symbol], x: &[R]| names.iter().position(|&s| s == symbol).map(|i| x[i]);
            let parameter = || self.parameters.iter().position(|&s| s == symbol).map(|i| R::from_f64(PARAMETERS[i]));
            let found = value(at_a, a).or_else(|| value(at_b, b)).or_else(|| value(q, a)).or_else(parameter);
            found.expect("a law reads its coordinates and its parameters")
        })
    }
}
