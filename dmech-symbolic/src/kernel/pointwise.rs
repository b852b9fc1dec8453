//! A potential at a point, or between two.

use crate::calculus::{self, TwoPoints};
use crate::expression::{Expr, Graph};
use crate::program::Program;

use super::variables::{Variables, exchange};

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

/// The programs of a potential at a point, or between two.
#[derive(Clone, Debug)]
pub struct Pointwise {
    /// Φ(q).
    pub potential: Program,
    /// ∇Φ(q).
    pub gradient: Program,
    /// The Hessian, row by row.
    pub hessian: Program,
    /// ∇̄Φ(a, b), symmetric to the bit.
    pub discrete_gradient: Program,
    /// ∂∇̄Φ/∂b, row by row.
    pub discrete_gradient_jacobian: Program,
}

impl Formulas {
    pub(super) fn new(
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

    /// The programs that compute them.
    pub(super) fn programs(&self, graph: &mut Graph, variables: &Variables) -> Pointwise {
        let exchange = exchange(graph, variables);
        Pointwise {
            potential: Program::schedule(graph, &[self.potential]),
            gradient: Program::schedule(graph, &self.gradient),
            hessian: Program::schedule(graph, &self.hessian.concat()),
            discrete_gradient: Program::schedule_symmetric(graph, &self.discrete_gradient, exchange),
            discrete_gradient_jacobian: Program::schedule(graph, &self.discrete_gradient_jacobian.concat()),
        }
    }
}

impl Pointwise {
    /// All of them: potential, gradient, Hessian, discrete gradient and its Jacobian.
    pub fn each(&self) -> [&Program; 5] {
        let Self { potential, gradient, hessian, discrete_gradient, discrete_gradient_jacobian } = self;
        [potential, gradient, hessian, discrete_gradient, discrete_gradient_jacobian]
    }
}
