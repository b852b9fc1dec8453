//! Newton for laws written by hand: the force and its Jacobian are values, the linear solve is done here.

use crate::vector::{by_component, by_entry};

use dmech_scalar::Real;

use super::drive::solve;
use super::{Correction, Equation, Increment, NotConverged, doubt, elimination, once, twice};

/// Solves Δ + g G(q + Δ) = drift − frozen, given b ↦ (G(b), J(b)) with J = ∂G/∂b.
///
/// # Errors
/// [`NotConverged`] when no root that is continuous with a shorter step can be reached.
pub fn dense<const D: usize, R: Real>(
    equation: &Equation<D, R>,
    mut force: impl FnMut([R; D]) -> ([R; D], [[R; D]; D]),
) -> Result<Increment<D, R>, NotConverged> {
    dense_discrete(equation, |_, b| force(b))
}

/// As [`dense`], for a force (a, b) ↦ (G(a, b), ∂G/∂b) between two points.
///
/// # Errors
/// [`NotConverged`] when no root that is continuous with a shorter step can be reached.
pub fn dense_discrete<const D: usize, R: Real>(
    equation: &Equation<D, R>,
    mut force: impl FnMut([R; D], [R; D]) -> ([R; D], [[R; D]; D]),
) -> Result<Increment<D, R>, NotConverged> {
    let correct = |equation: &Equation<D, R>, delta, b| {
        let (gradient, jacobian) = force(equation.a, b);
        correction(equation, delta, gradient, &jacobian)
    };
    solve::<false, D, R>(equation, correct)
}

/// As [`dense`], for a force (equation, Δ, b, v′) ↦ (G, ∂G/∂b, ∂G/∂v′) that also depends on the velocity at the end of
/// the step, v′ = v + (2/h)(Δ − drift); its mean is Δ/h. The equation passed in may be that of a shorter step.
///
/// # Errors
/// [`NotConverged`] when no root that is continuous with a shorter step can be reached.
pub fn dense_forced<const D: usize, R: Real>(
    equation: &Equation<D, R>,
    mut force: impl FnMut(&Equation<D, R>, [R; D], [R; D], [R; D]) -> ([R; D], [[R; D]; D], [[R; D]; D]),
) -> Result<Increment<D, R>, NotConverged> {
    let correct = |equation: &Equation<D, R>, delta: [R; D], b| {
        let Equation { v, drift, rate, .. } = equation;
        let (gradient, by_position, by_velocity) =
            force(equation, delta, b, by_component!(|i| rate.mul_add(delta[i] - drift[i], v[i])));
        let jacobian = by_entry!(|i, j| rate.mul_add(by_velocity[i][j], by_position[i][j]));
        correction(equation, delta, gradient, &jacobian)
    };
    solve::<false, D, R>(equation, correct)
}

/// As [`dense_forced`], for a force that does no work: with increments rounded once.
///
/// # Errors
/// [`NotConverged`] when no root that is continuous with a shorter step can be reached.
pub fn dense_middle<const D: usize, R: Real>(
    equation: &Equation<D, R>,
    mut force: impl FnMut(&Equation<D, R>, [R; D], [R; D]) -> ([R; D], [[R; D]; D], [[R; D]; D]),
) -> Result<Increment<D, R>, NotConverged> {
    let correct = |equation: &Equation<D, R>, delta: [R; D], b| {
        let (slope, by_position, by_velocity) = force(equation, delta, b);
        let jacobian: [[R; D]; D] = by_entry!(|i, j| equation.rate.mul_add(by_velocity[i][j], by_position[i][j]));
        let (change, [continued, definite]) =
            doubt::solve(newton_matrix(equation.g, &jacobian), equation.residual(delta, slope));
        Correction { continued, definite, ..Correction::in_parts(change, slope, turned(&jacobian, change)) }
    };
    solve::<true, D, R>(equation, correct)
}

/// As [`dense`], for the gradient of a quadratic potential: one correction from Δ = 0 is the solution, if it continues that of
/// a shorter step, which the pivots of 1 + g J tell as J is symmetric, its rows divided by masses or not.
///
/// # Errors
/// As of [`once`].
pub fn linear<const D: usize, R: Real>(
    equation: &Equation<D, R>,
    mut force: impl FnMut([R; D]) -> ([R; D], [[R; D]; D]),
) -> Result<Increment<D, R>, NotConverged> {
    once(equation, |equation, delta, b| definite(equation, delta, force(b)))
}

/// As [`linear`], for a force (a, b) ↦ (G(a, b), ∂G/∂b) between two points.
///
/// # Errors
/// As of [`once`].
pub fn linear_discrete<const D: usize, R: Real>(
    equation: &Equation<D, R>,
    mut force: impl FnMut([R; D], [R; D]) -> ([R; D], [[R; D]; D]),
) -> Result<Increment<D, R>, NotConverged> {
    twice(equation, |equation, delta, b| definite(equation, delta, force(equation.a, b)))
}

/// The correction and the pivots of 1 + g J.
fn definite<const D: usize, R: Real>(
    equation: &Equation<D, R>,
    delta: [R; D],
    (gradient, jacobian): ([R; D], [[R; D]; D]),
) -> (Correction<D, R>, [R; D]) {
    let matrix = newton_matrix(equation.g, &jacobian);
    let (change, pivots) = elimination::solve_definite(matrix, equation.rest(delta, gradient));
    (Correction::in_parts(change, gradient, turned(&jacobian, change)), pivots)
}

fn correction<const D: usize, R: Real>(
    equation: &Equation<D, R>,
    delta: [R; D],
    gradient: [R; D],
    jacobian: &[[R; D]; D],
) -> Correction<D, R> {
    let (change, [continued, definite]) =
        doubt::solve(newton_matrix(equation.g, jacobian), equation.rest(delta, gradient));
    Correction { continued, definite, ..Correction::in_parts(change, gradient, turned(jacobian, change)) }
}

/// J δ.
fn turned<const D: usize, R: Real>(jacobian: &[[R; D]; D], change: [R; D]) -> [R; D] {
    by_component!(|i| (0..D).fold(R::ZERO, |sum, j| jacobian[i][j].mul_add(change[j], sum)))
}

/// 1 + g J.
fn newton_matrix<const D: usize, R: Real>(g: R, jacobian: &[[R; D]; D]) -> [[R; D]; D] {
    by_entry!(|i, j| g.mul_add(jacobian[i][j], if i == j { R::ONE } else { R::ZERO }))
}

/// Free motion: the drift.
pub(crate) fn free<const D: usize, R: Real>(equation: &Equation<D, R>) -> Result<Increment<D, R>, NotConverged> {
    linear(equation, |_| ([R::ZERO; D], [[R::ZERO; D]; D]))
}
