//! Programs for laws between two bodies a and b, in the separation d = q_a − q_b.
//!
//! A potential of the distance is one of s = |d|² alone, in any number of dimensions: its gradient is c d with c = 2Φ′(s),
//! its discrete gradient C·(d₀ + d₁) with C = Φ[s₀, s₁], and only the coefficients need programs.

use crate::calculus;
use crate::degree::degree;
use crate::expression::{Expr, Graph, Substitution, Symbol, Unary};
use crate::program::Program;
use crate::structure::{Central, Structure};

use super::pointwise::{Formulas, Pointwise};
use super::vanishes::vanishes;
use super::variables::Variables;

/// The variables of a pair law besides those of a potential in d.
#[derive(Clone, Debug)]
pub struct PairVariables {
    /// The velocity of a.
    pub va: Vec<Symbol>,
    /// The velocity of b.
    pub vb: Vec<Symbol>,
    /// |d|², of a separation and of the two ends of a step.
    pub s: Symbol,
    /// |d|² at the one end.
    pub s_a: Symbol,
    /// |d|² at the other end.
    pub s_b: Symbol,
}

/// A law between two bodies as expressions.
#[derive(Clone, Debug)]
pub struct PairLaw {
    /// Φ in `variables.q`, which is d, and in `pair.s`; none where the law is a force and nothing else.
    pub potential: Option<Expr>,
    /// The force on a from b in d, v_a and v_b.
    pub force: Option<Vec<Expr>>,
    /// What the law reads of a, each with the same of b.
    pub exchange: Vec<(Symbol, Symbol)>,
}

/// Everything generated for a law between two bodies.
#[derive(Clone, Debug)]
pub struct PairKernels {
    /// The potential, if there is one.
    pub potential: Option<PairPotential>,
    /// The force, if there is one.
    pub force: Option<PairForce>,
    /// Φ(d; a, b) = Φ(−d; b, a).
    pub symmetric: bool,
}

/// The potential of two bodies.
#[derive(Clone, Debug)]
pub struct PairPotential {
    /// What it depends on, as expressions.
    pub formulas: PairFormulas,
    /// The programs; of a potential of the distance for c in place of the gradient, c and c′ in place of the Hessian, and so C, and C
    /// and ∂C/∂s_b.
    pub pointwise: Pointwise,
    /// The force is linear in d: the Hessian does not depend on it.
    pub linear: bool,
    /// The potential is a choice between branches: its gradient may jump.
    pub piecewise: bool,
    /// Φ is a polynomial of at most this [degree](mod@crate::degree) in d: |d|² has degree 2, and |d| is none.
    pub degree: Option<u32>,
}

/// What a potential of two bodies depends on.
#[derive(Clone, Debug)]
pub enum PairFormulas {
    /// The distance alone.
    Radial(Radial),
    /// The separation.
    Separation(Formulas),
}

/// A potential of the distance.
#[derive(Clone, Copy, Debug)]
pub struct Radial {
    /// Φ(s).
    pub potential: Expr,
    /// c(s) = 2Φ′(s).
    pub coefficient: Expr,
    /// C(s_a, s_b) = Φ[s_a, s_b].
    pub discrete_coefficient: Expr,
}

/// The force on a from b.
#[derive(Clone, Debug)]
pub struct PairForce {
    /// F(d, v_a, v_b).
    pub formulas: Vec<Expr>,
    /// ∂F/∂d, ∂F/∂v_a, ∂F/∂v_b.
    pub derivatives: [Vec<Vec<Expr>>; 3],
    /// F.
    pub force: Program,
    /// The three Jacobians, each row by row.
    pub jacobians: Program,
    /// The force depends on a velocity.
    pub depends_on_velocity: bool,
    /// The force is a choice between branches: its slope may jump.
    pub piecewise: bool,
    /// F(d, v_a, v_b; a, b) = −F(−d, v_b, v_a; b, a): the force on b is opposite.
    pub reciprocal: bool,
}

impl PairVariables {
    /// The variables for D dimensions; none of the velocities where D is any.
    pub fn new(graph: &mut Graph, dimension: usize) -> Self {
        let mut velocity = |body: &str| -> Vec<Symbol> {
            let letters = dimension <= 3;
            let name =
                |i: usize| if letters { format!("v{}{body}", ["x", "y", "z"][i]) } else { format!("v{body}{i}") };
            (0..dimension).map(|i| graph.coordinate(&name(i))).collect()
        };
        let (va, vb) = (velocity("a"), velocity("b"));
        let [s, s_a, s_b] = ["r2", "ra2", "rb2"].map(|name| graph.squared_distance(name));
        Self { va, vb, s, s_a, s_b }
    }

    /// r = √s.
    pub fn distance(&self, graph: &mut Graph) -> Expr {
        let s = graph.symbol(self.s);
        graph.unary(Unary::Sqrt, s)
    }

    /// Φ, c or C with r for √s, as people write it.
    pub fn in_distance(&self, graph: &mut Graph, e: Expr) -> Expr {
        let mut pairs = vec![];
        for (s, name) in [(self.s, "r"), (self.s_a, "ra"), (self.s_b, "rb")] {
            let (s, r) = (graph.symbol(s), graph.coordinate(name));
            let (root, r) = (graph.unary(Unary::Sqrt, s), graph.symbol(r));
            pairs.extend([(root, r), (s, graph.square(r))]);
        }
        Substitution::of_expressions(pairs).apply(graph, e)
    }
}

impl PairKernels {
    /// Derives everything.
    pub fn new(graph: &mut Graph, law: &PairLaw, variables: &Variables, pair: &PairVariables) -> Self {
        let potential = law.potential.map(|phi| PairPotential::new(graph, phi, variables, pair));
        let mut exchanged = exchange_bodies(graph, law, variables, pair);
        let symmetric = law.potential.is_none_or(|phi| {
            let other = exchanged.apply(graph, phi);
            let difference = graph.sub(phi, other);
            phi == other || vanishes(graph, difference)
        });
        let force = law.force.as_ref().map(|force| PairForce::new(graph, force, &mut exchanged, variables, pair));
        Self { potential, force, symmetric }
    }
}

impl PairPotential {
    fn new(graph: &mut Graph, phi: Expr, variables: &Variables, pair: &PairVariables) -> Self {
        let phi = calculus::with_whole_choices(graph, phi);
        let coordinates = variables.q.iter().map(|&d| (d, 1));
        let degree = degree(graph, phi, &coordinates.chain([(pair.s, 2)]).collect::<Vec<_>>());
        if !graph.depends_on(phi, &variables.q) {
            return Self::of_distance(graph, Central { potential: phi, s: pair.s }, degree, pair);
        }
        let gradient = calculus::gradient(graph, phi, &variables.q);
        let hessian = calculus::hessian(graph, phi, &variables.q);
        let structure = Structure::of(graph, phi, &hessian, &variables.q);
        if let Some(central) = structure.central {
            return Self::of_distance(graph, central, degree, pair);
        }
        let formulas = Formulas::new(graph, phi, gradient, hessian, variables);
        Self {
            pointwise: formulas.programs(graph, variables),
            linear: structure.constant_hessian,
            piecewise: structure.piecewise,
            degree,
            formulas: PairFormulas::Separation(formulas),
        }
    }

    /// From Φ(s), whatever s is called there.
    fn of_distance(graph: &mut Graph, central: Central, degree: Option<u32>, pair: &PairVariables) -> Self {
        let s = graph.symbol(pair.s);
        let potential = Substitution::new(graph, [(central.s, s)]).apply(graph, central.potential);
        let central = Central { potential, s: pair.s };
        let piecewise = !graph.choices(potential, &[pair.s]).is_empty();
        let coefficient = central.coefficient(graph);
        let slope = calculus::tangent(graph, coefficient, &[pair.s])[0];
        let discrete_coefficient = central.discrete_coefficient(graph, pair.s_a, pair.s_b);
        let discrete_slope = calculus::tangent(graph, discrete_coefficient, &[pair.s_b])[0];
        let (s_a, s_b) = (graph.symbol(pair.s_a), graph.symbol(pair.s_b));
        let exchange = Substitution::new(graph, [(pair.s_a, s_b), (pair.s_b, s_a)]);
        Self {
            formulas: PairFormulas::Radial(Radial { potential, coefficient, discrete_coefficient }),
            pointwise: Pointwise {
                potential: Program::schedule(graph, &[potential]),
                gradient: Program::schedule(graph, &[coefficient]),
                hessian: Program::schedule(graph, &[coefficient, slope]),
                discrete_gradient: Program::schedule_symmetric(graph, &[discrete_coefficient], exchange),
                discrete_gradient_jacobian: Program::schedule(graph, &[discrete_coefficient, discrete_slope]),
            },
            linear: !piecewise && !graph.depends_on(coefficient, &[pair.s]),
            piecewise,
            degree,
        }
    }
}

impl PairForce {
    fn new(
        graph: &mut Graph,
        force: &[Expr],
        exchanged: &mut Substitution,
        variables: &Variables,
        pair: &PairVariables,
    ) -> Self {
        let derivatives = [&variables.q, &pair.va, &pair.vb].map(|by| calculus::jacobian(graph, force, by));
        let velocities: Vec<_> = pair.va.iter().chain(&pair.vb).copied().collect();
        let reciprocal = force.iter().all(|&f| {
            let other = exchanged.apply(graph, f);
            let sum = graph.add(&[f, other]);
            vanishes(graph, sum)
        });
        Self {
            force: Program::schedule(graph, force),
            jacobians: Program::schedule(graph, &derivatives.iter().flatten().flatten().copied().collect::<Vec<_>>()),
            depends_on_velocity: force.iter().any(|&f| graph.depends_on(f, &velocities)),
            piecewise: {
                let moving: Vec<_> = variables.q.iter().copied().chain([pair.s]).chain(velocities).collect();
                force.iter().any(|&f| !graph.choices(f, &moving).is_empty())
            },
            reciprocal,
            formulas: force.to_vec(),
            derivatives,
        }
    }
}

/// d → −d, v_a ↔ v_b, and what is read of the bodies.
fn exchange_bodies(graph: &mut Graph, law: &PairLaw, variables: &Variables, pair: &PairVariables) -> Substitution {
    let mut pairs = vec![];
    for &d in &variables.q {
        let value = graph.symbol(d);
        pairs.push((d, graph.neg(value)));
    }
    let velocities = pair.va.iter().copied().zip(pair.vb.iter().copied());
    for (a, b) in velocities.chain(law.exchange.iter().copied()) {
        pairs.push((a, graph.symbol(b)));
        pairs.push((b, graph.symbol(a)));
    }
    Substitution::new(graph, pairs)
}
