//! Laws that depend on |q| alone: one scalar unknown, in any number of dimensions.
//!
//! With s = |q|² the gradient is c(s) q and the discrete gradient C(|a|², |b|²)(a + b). Both steps then read
//!
//! ```text
//! Q (1 + g c(s)) = w,   s = |Q − base|²,     Q = base + q + Δ,  w = base + q + drift − frozen
//! ```
//!
//! with base = 0 for the trapezoid and base = a for the energy-exact steps: Q is along w, and s is the one unknown.
//! Newton acts on F(s) = s P² − |w − base P|², P = 1 + g c. With x = q + Δ and the residual ρ = Q P − w this is
//! 2P x·ρ − ρ·ρ at s = |x|², which does not cancel. The new force c(s + ds) w / P(s + ds) is c + dc/(P + g dc) times w/P.

use dmech_scalar::{Count, Mask, Real};

use super::settle::Astray;
use super::settled::Settled;
use super::{Correction, Equation, Increment, NotConverged, continuation};
use crate::vector::{by_component, difference, dot, scaled, sum};

/// Evaluations before the fast path gives up.
const PATIENCE: u32 = 6;

/// Solves the trapezoidal step for a central law, given s ↦ [c, c′, c″] with ∇Φ(q) = c(|q|²) q.
///
/// # Errors
/// [`NotConverged`] when no root that is continuous with a shorter step can be reached.
#[inline(always)]
pub fn implicit<const D: usize, R: Real>(
    equation: &Equation<D, R>,
    mut factor: impl FnMut(R) -> [R; 3],
) -> Result<Increment<D, R>, NotConverged> {
    solve::<false, D, R>(equation, |_, s| factor(s))
}

/// Solves the energy-exact step for a central law, given (|a|², s) ↦ [C, ∂C/∂s, ∂²C/∂s²] with
/// ∇̄Φ(a, b) = C(|a|², |b|²) (a + b), s = |b|².
///
/// # Errors
/// [`NotConverged`] when no root that is continuous with a shorter step can be reached.
#[inline(always)]
pub fn discrete<const D: usize, R: Real>(
    equation: &Equation<D, R>,
    factor: impl FnMut(R, R) -> [R; 3],
) -> Result<Increment<D, R>, NotConverged> {
    solve::<true, D, R>(equation, factor)
}

/// One evaluation of the law is enough when the guess is good: the Newton step ds is followed by a second-order update
/// of c, and accepted when what was neglected is below rounding.
///
/// The order of operations keeps the chain from c to the force short: all products of vectors are formed before c is
/// known, 1/P and 1/F′ are taken side by side.
#[inline(always)]
fn solve<const BETWEEN: bool, const D: usize, R: Real>(
    equation: &Equation<D, R>,
    mut factor: impl FnMut(R, R) -> [R; 3],
) -> Result<Increment<D, R>, NotConverged> {
    let Equation { q, a, g, .. } = *equation;
    let (half, two) = (R::from_f64(0.5), R::from_f64(2.0));
    let known = equation.known();
    let w: [R; D] = by_component!(|i| if BETWEEN { a[i] + q[i] } else { q[i] } + known[i]);
    let (aa, aw) = if BETWEEN { (dot(a, a), dot(a, w)) } else { (R::ZERO, R::ZERO) };
    let mut delta = equation.guess;
    let mut last = R::ZERO;
    let mut all = Settled::<D, R>::none();
    for iteration in 1..=PATIENCE {
        let x = equation.end(delta);
        let s = dot(x, x);
        let excess = difference(delta, known);
        let (xe, ee) = (dot(x, excess), dot(excess, excess));
        let (xq, eq, qq) = if BETWEEN {
            let sum = sum(a, x);
            (dot(x, sum), dot(excess, sum), dot(sum, sum))
        } else {
            (s, xe, s)
        };
        let [c, c1, c2] = factor(aa, s);

        let gc = g * c;
        let p = g.mul_add(c, R::ONE);
        let x_rho = gc.mul_add(xq, xe);
        let rho_rho = gc.mul_add(gc.mul_add(qq, two * eq), ee);
        let f = (two * p).mul_add(x_rho, -rho_rho);
        // With y = w − base P: F′ = P² + 2P′(s P + y·base).
        let lever = if BETWEEN { p.mul_add(s - aa, aw) } else { p * s };
        let f1 = (two * g * c1).mul_add(lever, p * p);
        let ds = -f / f1;

        let u = p.recip();
        let uc1 = u * c1;
        let half_c2 = half * c2;
        let dc_over_p = ds * (u * half_c2).mul_add(ds, uc1);
        // Of the energy-exact steps it is not added to c: it is often less than half an ulp and of one sign, would be lost
        // and become a drift of the energy (10⁻²⁰ a step, 2·10⁻¹³ in 10⁷).
        let correction = dc_over_p * (-g * uc1).mul_add(ds, R::ONE);
        let (mut gradient, mut parts) = ([R::ZERO; D], [[R::ZERO; D]; 2]);
        for i in 0..D {
            let along = u * w[i];
            if BETWEEN {
                let (main, rest) = c.product(along);
                let rest = correction.mul_add(along, rest);
                (gradient[i], parts[0][i], parts[1][i]) = (main + rest, main, rest);
            } else {
                gradient[i] = (c + correction) * along;
            }
        }
        delta = equation.increment(gradient);

        // Neglected: the third-order term of c, taken as the second in the ratio of the second to the first, and the
        // second-order error of ds, F″ds²/2F′, as it acts on c. Below rounding by a margin: these errors keep their sign
        // from step to step, and would add up to a drift.
        let ulp = R::from_f64(1.0 / 16.0) * R::EPSILON * c.abs();
        let (first, second) = (c1 * ds, half_c2 * ds * ds);
        let third = second.abs().less_or_equal(ulp).or((second * second).less_or_equal(half * ulp * first.abs()));
        let curved = two * g.abs() * ((p * first * first).abs() + (second * c1 * lever).abs());
        // Nothing is neglected where c does not vary, or so it seems: in units in which r measures 10⁶⁵ its derivative, of
        // the order of c/r², may be below the smallest number. Then ds itself tells.
        let size = ds.abs();
        let varies = c1.equal(R::ZERO).not().or(size.less_or_equal(R::from_f64(4.0) * R::EPSILON * s));
        let exact = third.and(curved.less_or_equal(ulp * f1)).and(varies);
        // The branch that starts at h → 0 has P > 0 and F′ > 0; a change of s by half is a leap.
        let mut steady = R::from_f64(0.25).less(p).and(R::ZERO.less(f1)).and(size.less_or_equal(half * s));
        if iteration > 1 {
            steady = steady.and(size.less_or_equal(half * last).or(exact));
        }
        if !all.or(steady).all() {
            return Increment::apart(lengthen::<BETWEEN, D, R>(*equation, iteration, factor));
        }
        let made = Count::of(iteration);
        let next = Increment { delta, gradient, parts, evaluations: made, iterations: made };
        if let Some(found) = all.add(exact, next) {
            return Ok(found);
        }
        last = size;
    }
    Increment::apart(lengthen::<BETWEEN, D, R>(*equation, PATIENCE, factor))
}

/// The rare case: the vector equation, with the step lengthened gradually. By value: the equation then needs no place
/// in memory before.
#[cold]
#[inline(never)]
fn lengthen<const BETWEEN: bool, const D: usize, R: Real>(
    equation: Equation<D, R>,
    spent: u32,
    mut factor: impl FnMut(R, R) -> [R; 3],
) -> Result<Increment<D, R>, NotConverged> {
    let astray = Astray { evaluations: spent, residual: f64::NAN, elsewhere: false };
    if Settled::<D, R>::MANY {
        return Err(astray.into());
    }
    continuation::follow::<false, D, R>(equation, astray, |equation, delta, x| {
        let sum = if BETWEEN { sum(equation.a, x) } else { x };
        let [c, c1, _] = factor(dot(equation.a, equation.a), dot(x, x));
        rank_one(equation, delta, x, sum, c, c1 + c1)
    })
}

/// The correction for G = c Q with J = c + k Q⊗x, by the formula of Sherman and Morrison.
fn rank_one<const D: usize, R: Real>(
    equation: &Equation<D, R>,
    delta: [R; D],
    x: [R; D],
    sum: [R; D],
    c: R,
    k: R,
) -> Correction<D, R> {
    let g = equation.g;
    let gradient = scaled(c, sum);
    let residual = equation.rest(delta, gradient);
    let p = R::ONE + g * c;
    let across = p + g * k * dot(x, sum);
    let along = dot(x, residual) / across;
    let change = by_component!(|i| (residual[i] - g * k * along * sum[i]) / p);
    let turned = by_component!(|i| c * change[i] + k * along * sum[i]);
    Correction::in_parts(change, gradient, turned).if_positive([p, across])
}
