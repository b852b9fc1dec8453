//! Programs for laws with a force beside, or in place of, a potential.
//!
//! The velocity at the end of a step is eliminated by (v + v′)/2 = Δ/h (Greenspan (2.1)), v′ = v + (2/h)(Δ − h v); its
//! share of the Jacobian is (2/h) ∂F/∂v. A force that does no work needs the mean velocity Δ/h alone.

use crate::calculus::{self, TwoPoints};
use crate::expression::{Expr, Graph, Substitution, Symbol};
use crate::linear::{self, Corrections, Solution};
use crate::program::Program;

use super::mean::{KickByMean, LinearForce};
use super::newton::{correction, dot, mirrored, newton_matrix};
use super::step::{Given, Step};
use super::vanishes::vanishes;
use super::variables::Variables;

/// Everything generated for a force.
#[derive(Clone, Debug)]
pub struct ForcedKernels {
    /// Expressions, for display and tests.
    pub formulas: ForceFormulas,
    /// F(q, v).
    pub force: Program,
    /// ∂F/∂q, row by row.
    pub force_dq: Program,
    /// ∂F/∂v, row by row.
    pub force_dv: Program,
    /// ∇Φ − F.
    pub slope: Program,
    /// F/2, the share of the start of a step in the mean force; 0 where the force does no work.
    pub half_force: Program,
    /// v − c (∇Φ − F).
    pub kick: Program,
    /// v′ = v − c (∇Φ − F(q, (v + v′)/2)); none where the force does not depend on the velocity, or not linearly.
    pub kick_by_mean: Option<KickByMean>,
    /// v − c s + e J s, with s = ∇Φ − F and J = ∂s/∂q; none where the force depends on the velocity.
    pub gradient_kick: Option<Program>,
    /// The trapezoidal step, with the end velocity eliminated.
    pub implicit: Step,
    /// The energy-exact step.
    pub discrete: ForcedStep,
    /// The force depends on the velocity.
    pub depends_on_velocity: bool,
    /// The force is linear in the velocity, if only as it does not depend on it.
    pub linear_in_velocity: bool,
    /// The potential or the force is a choice between branches: the slope may jump.
    pub piecewise: bool,
    /// F·v = 0 for every v: the force turns the velocity and does no work.
    pub workless: bool,
}

/// The energy-exact step for a law with a force.
#[derive(Clone, Debug)]
pub enum ForcedStep {
    /// ∇̄Φ and the mean force.
    Mean(Step),
    /// A force that does no work, at the mean position and mean velocity.
    ///
    /// It does none in the step if it is at right angles to the very increment that the velocity follows from. The
    /// residual is therefore not part of a formula, where g G would be rounded in another way: it is formed of G as
    /// computed, and given back as `rhs`.
    Middle {
        /// G.
        slope: Program,
        /// From the residual as `rhs`: δ, J δ, and what is asked.
        change: Step,
    },
}

/// The formulas behind the programs.
#[derive(Clone, Debug)]
pub struct ForceFormulas {
    /// F(q, v).
    pub force: Vec<Expr>,
    /// ∂F/∂q.
    pub force_dq: Vec<Vec<Expr>>,
    /// ∂F/∂v.
    pub force_dv: Vec<Vec<Expr>>,
}

impl ForcedKernels {
    /// Derives everything from Φ and F, written in `variables.q` and `variables.v`; `time` is the symbol of the time
    /// where the law names it.
    pub fn new(graph: &mut Graph, phi: Expr, force: &[Expr], time: Option<Symbol>, variables: &Variables) -> Self {
        let Variables { q, v, a, b, .. } = variables;
        let phi = calculus::with_whole_choices(graph, phi);
        let gradient = calculus::gradient(graph, phi, q);
        let force_dq = calculus::jacobian(graph, force, q);
        let force_dv = calculus::jacobian(graph, force, v);
        // As they are written, and so wherever they are placed.
        let symmetric = linear::is_symmetric(&force_dq) && linear::is_symmetric(&force_dv);
        let depends_on_velocity = force.iter().any(|&f| graph.depends_on(f, v));
        let workless = depends_on_velocity && does_no_work(graph, force, v);
        let slope: Vec<_> = gradient.iter().zip(force).map(|(&g, &f)| graph.sub(g, f)).collect();
        let kick = super::kick(graph, &slope, variables);
        let linear = LinearForce::of(graph, force, &force_dv, v);
        let linear_in_velocity = linear.is_some();
        let linear = linear.filter(|_| depends_on_velocity);
        let kick_by_mean = linear.map(|linear| linear.kick(graph, &gradient, variables));
        let gradient_kick = (!depends_on_velocity).then(|| {
            let jacobian = calculus::jacobian(graph, &slope, q);
            super::jacobian_kick(graph, &slope, &jacobian, variables)
        });
        let moving: Vec<_> = q.iter().chain(v).copied().collect();
        let piecewise = slope.iter().chain([&phi]).any(|&e| !graph.choices(e, &moving).is_empty());
        let share = if workless { 0.0 } else { 0.5 };
        let half_force: Vec<_> = force.iter().map(|&f| graph.scale(share, f)).collect();

        let end = Point::at_end(graph, variables);
        let implicit = {
            let here: Vec<_> = slope.iter().map(|&e| end.place(graph, e, variables)).collect();
            let (jacobian, constant) = by_increment(graph, &here, variables);
            let linear = constant && !piecewise;
            // The Hessian is symmetric.
            let jacobian = if symmetric { mirrored(&jacobian) } else { jacobian };
            correction(graph, &here, &jacobian, Corrections::of(linear), Given::Rounded, variables)
        };
        let discrete = {
            let mut ends = TwoPoints::new(graph, q, a, b);
            let conservative = calculus::discrete_gradient(graph, phi, &mut ends);
            let point = if workless { Point::in_the_middle(graph, variables) } else { end };
            let later = time.filter(|_| !workless).map(|t| (t, graph.symbol(variables.t_end)));
            let mut at_end_time = Substitution::new(graph, later);
            let share = if workless { 1.0 } else { 0.5 };
            let total: Vec<_> = conservative
                .iter()
                .zip(force)
                .map(|(&slope, &f)| {
                    let placed = point.place(graph, f, variables);
                    let placed = at_end_time.apply(graph, placed);
                    let placed = graph.scale(share, placed);
                    graph.sub(slope, placed)
                })
                .collect();
            let (jacobian, constant) = by_increment(graph, &total, variables);
            let linear = constant && !piecewise;
            // The discrete gradient of a quadratic potential has half its Hessian.
            let jacobian = if linear && symmetric { mirrored(&jacobian) } else { jacobian };
            let corrections = Corrections::of(linear);
            if workless {
                let change = change(graph, &jacobian, corrections, variables);
                ForcedStep::Middle { slope: Program::schedule(graph, &total), change }
            } else {
                ForcedStep::Mean(correction(graph, &total, &jacobian, corrections, Given::InParts, variables))
            }
        };
        Self {
            force: Program::schedule(graph, force),
            force_dq: Program::schedule(graph, &force_dq.concat()),
            force_dv: Program::schedule(graph, &force_dv.concat()),
            slope: Program::schedule(graph, &slope),
            half_force: Program::schedule(graph, &half_force),
            kick,
            kick_by_mean,
            gradient_kick,
            implicit,
            discrete,
            depends_on_velocity,
            linear_in_velocity,
            piecewise,
            workless,
            formulas: ForceFormulas { force: force.to_vec(), force_dq, force_dv },
        }
    }
}

/// Where in a step a force is taken.
struct Point {
    position: Vec<Expr>,
    velocity: Vec<Expr>,
}

impl Point {
    /// (q′, v′), with v′ = v + (2/h)(Δ − h v).
    fn at_end(graph: &mut Graph, variables: &Variables) -> Self {
        let rate = graph.symbol(variables.rate);
        let Variables { v, b, delta, drift, .. } = variables;
        let velocity = v
            .iter()
            .zip(delta)
            .zip(drift)
            .map(|((&v, &delta), &drift)| {
                let (v, delta, drift) = (graph.symbol(v), graph.symbol(delta), graph.symbol(drift));
                let turned = graph.sub(delta, drift);
                let turned = graph.mul(&[rate, turned]);
                graph.add(&[v, turned])
            })
            .collect();
        Self { position: graph.symbols(b), velocity }
    }

    /// ((q + q′)/2, Δ/h).
    ///
    /// Not (v + v′)/2 by way of v′: the rounding of 2/h would enter as a force of its own, which works in one sense at
    /// every step. As a factor of the whole velocity it does not matter.
    fn in_the_middle(graph: &mut Graph, variables: &Variables) -> Self {
        let rate = graph.symbol(variables.rate);
        let ends = variables.a.iter().zip(&variables.b);
        let position = ends
            .map(|(&a, &b)| {
                let (a, b) = (graph.symbol(a), graph.symbol(b));
                graph.mean(a, b)
            })
            .collect();
        let moved = variables.delta.iter().map(|&delta| {
            let delta = graph.symbol(delta);
            let moved = graph.mul(&[rate, delta]);
            graph.scale(0.5, moved)
        });
        Self { velocity: moved.collect(), position }
    }

    fn place(&self, graph: &mut Graph, e: Expr, variables: &Variables) -> Expr {
        let positions = variables.q.iter().copied().zip(self.position.iter().copied());
        let velocities = variables.v.iter().copied().zip(self.velocity.iter().copied());
        let pairs: Vec<_> = positions.chain(velocities).collect();
        Substitution::new(graph, pairs).apply(graph, e)
    }
}

/// J = ∂G/∂Δ of a force that depends on Δ through the end b = q + Δ and through the velocity.
///
/// The second value says whether the equation is linear: then one correction from Δ = 0 solves it.
fn by_increment(graph: &mut Graph, force: &[Expr], variables: &Variables) -> (Vec<Vec<Expr>>, bool) {
    let by_position = calculus::jacobian(graph, force, &variables.b);
    let by_increment = calculus::jacobian(graph, force, &variables.delta);
    let jacobian: Vec<Vec<_>> = by_position
        .iter()
        .zip(&by_increment)
        .map(|(p, d)| p.iter().zip(d).map(|(&p, &d)| graph.add(&[p, d])).collect())
        .collect();
    let unknowns: Vec<_> = variables.b.iter().chain(&variables.delta).copied().collect();
    let linear = !jacobian.iter().flatten().any(|&e| graph.depends_on(e, &unknowns));
    (jacobian, linear)
}

/// δ and J δ with (1 + g J) δ = rhs.
fn change(graph: &mut Graph, jacobian: &[Vec<Expr>], corrections: Corrections, variables: &Variables) -> Step {
    let matrix = newton_matrix(graph, jacobian, variables);
    let residual = graph.symbols(&variables.rhs);
    let Solution { x: delta, positive, asked } = linear::solve(graph, &matrix, &residual, corrections);
    let turned: Vec<_> = jacobian.iter().map(|row| dot(graph, row, &delta)).collect();
    let program = Program::schedule(graph, &[delta, turned, positive].concat());
    Step { way: corrections.into(), given: Given::InParts, asked, program }
}

/// Whether F·v vanishes identically: decided on the expression, products over sums expanded.
fn does_no_work(graph: &mut Graph, force: &[Expr], velocity: &[Symbol]) -> bool {
    let powers: Vec<_> = force
        .iter()
        .zip(velocity)
        .map(|(&f, &v)| {
            let v = graph.symbol(v);
            graph.mul(&[f, v])
        })
        .collect();
    let power = graph.add(&powers);
    vanishes(graph, power)
}
