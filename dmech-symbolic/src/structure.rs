//! What a potential is beside being smooth; the cost of a step follows from it.

use crate::calculus;
use crate::degree::degree;
use crate::expression::{Expr, Graph, Node, Number, Substitution, Symbol};

/// What was found.
#[derive(Clone, Debug)]
pub struct Structure {
    /// There is a choice by the coordinates: the gradient or its derivatives may jump.
    pub piecewise: bool,
    /// The Hessian does not depend on the coordinates, and nowhere jumps: implicit steps are linear.
    pub constant_hessian: bool,
    /// The Hessian is diagonal and no choice takes several coordinates: they do not interact.
    pub diagonal_hessian: bool,
    /// Φ is a polynomial of at most this [degree](mod@crate::degree) in the coordinates.
    pub degree: Option<u32>,
    /// Φ is a function of s = |q|² alone, for at least two coordinates.
    pub central: Option<Central>,
}

/// Φ as a function of the squared distance from the origin.
#[derive(Clone, Copy, Debug)]
pub struct Central {
    /// Φ(s).
    pub potential: Expr,
    /// s.
    pub s: Symbol,
}

impl Structure {
    /// Looks at Φ and its Hessian in the given coordinates.
    pub fn of(graph: &mut Graph, phi: Expr, hessian: &[Vec<Expr>], coordinates: &[Symbol]) -> Self {
        let moves = graph.dependence(coordinates);
        let choices = graph.choices(phi, coordinates);
        let piecewise = !choices.is_empty();
        let constant_hessian = !piecewise && hessian.iter().flatten().all(|e| !moves[e.index()]);
        let couples = |&e: &Expr| coordinates.iter().filter(|&&q| graph.depends_on(e, &[q])).count() > 1;
        let diagonal_hessian = !choices.iter().any(couples)
            && (0..coordinates.len()).all(|i| (0..coordinates.len()).all(|j| i == j || graph.is_zero(hessian[i][j])));
        let degree = degree(graph, phi, &coordinates.iter().map(|&q| (q, 1)).collect::<Vec<_>>());
        let central = if coordinates.len() > 1 { central(graph, phi, coordinates) } else { None };
        Self { piecewise, constant_hessian, diagonal_hessian, degree, central }
    }

    /// Φ(s), where an implicit step is one equation in s that is not linear. Across a seam its solver, which takes s ↦ c to
    /// be smooth, does not apply.
    pub fn one_unknown(&self) -> Option<&Central> {
        self.central.as_ref().filter(|_| !self.constant_hessian && !self.piecewise)
    }
}

impl Central {
    /// c(s) = 2 Φ′(s), so that ∇Φ = c q.
    pub fn coefficient(&self, graph: &mut Graph) -> Expr {
        let slope = calculus::derivative(graph, self.potential, self.s);
        graph.scale(2.0, slope)
    }

    /// C(sₐ, s_b) = Φ[sₐ, s_b], so that ∇̄Φ = C·(a + b).
    pub fn discrete_coefficient(&self, graph: &mut Graph, s_a: Symbol, s_b: Symbol) -> Expr {
        let mut ends = calculus::TwoPoints::new(graph, &[self.s], &[s_a], &[s_b]);
        calculus::discrete_gradient(graph, self.potential, &mut ends)[0]
    }
}

/// qᵢ².
pub(crate) fn squares(graph: &mut Graph, coordinates: &[Symbol]) -> Vec<Expr> {
    graph.symbols(coordinates).into_iter().map(|q| graph.square(q)).collect()
}

/// Replaces Σ qᵢ² by s wherever it stands in a sum; central if no coordinate is left.
fn central(graph: &mut Graph, phi: Expr, coordinates: &[Symbol]) -> Option<Central> {
    let s = graph.squared_distance("s");
    let squared_distance = graph.symbol(s);
    let squares = squares(graph, coordinates);
    // The distance may first appear after an inner sum has been replaced: repeat until nothing changes.
    let mut current = phi;
    loop {
        let pairs: Vec<_> = graph
            .reachable(&[current])
            .into_iter()
            .filter_map(|e| Some((e, with_distance(graph, e, &squares, squared_distance)?)))
            .collect();
        if pairs.is_empty() {
            break;
        }
        let next = Substitution::of_expressions(pairs).apply(graph, current);
        if next == current {
            break;
        }
        current = next;
    }
    (graph.depends_on(current, &[s]) && !graph.depends_on(current, coordinates))
        .then_some(Central { potential: current, s })
}

/// A sum Σ f qᵢ² + rest as f s + rest, where all coordinates have the same cofactor f.
fn with_distance(graph: &mut Graph, e: Expr, squares: &[Expr], s: Expr) -> Option<Expr> {
    let Node::Sum { constant, terms } = graph.node(e).clone() else { return None };
    let mut rest: Vec<(Number, Expr)> = terms.to_vec();
    let mut cofactor: Option<(Number, Expr)> = None;
    for &square in squares {
        let (base, _) = graph.factors(square).1[0];
        let found = rest.iter().enumerate().find_map(|(k, &(c, t))| {
            let (own, mut factors) = graph.factors(t);
            let i = factors.iter().position(|&(f, n)| f == base && n == 2)?;
            factors.remove(i);
            let others = graph.product_of(own, factors);
            cofactor.is_none_or(|known| known == (c, others)).then_some((k, c, others))
        });
        let (k, c, others) = found?;
        cofactor = Some((c, others));
        rest.remove(k);
    }
    let (c, others) = cofactor?;
    let distance = graph.mul(&[others, s]);
    rest.push((c, distance));
    rest.push((constant, graph.one()));
    Some(graph.linear_combination(&rest))
}
