//! What is promised of a law, tried at points.
//!
//! | | |
//! |---|---|
//! | secant | \|∇̄Φ·(b − a) − (Φ(b) − Φ(a))\| within 8 ulp of S (see [`Scale`]), Φ and the sum in double-double |
//! | symmetry | ∇̄Φ(a, b) = ∇̄Φ(b, a) to the bit, the sign of a zero apart |
//! | limit | ∇̄Φ(a, a) = ∇Φ(a) within 8 ulp of S for a unit step, unless a lies on a seam |
//! | finite | ∇̄Φ wherever S is, ∇Φ, Hessian and Jacobian wherever differences settle |
//! | slopes | ∇Φ against differences of Φ, Hessian of ∇Φ, Jacobian of ∇̄Φ, where differences settle |
//! | structure | a law called linear has ∇Φ(b) − ∇Φ(a) = H (b − a); one called apart or central, a gradient that is |

use dmech_scalar::{DoubleDouble, Real};

use super::differences::derivatives;
use super::engine::{Engine, Second};
use super::grow::Law;
use super::points::Place;
use super::promise::{Failure, Promise, ULPS, UNDERFLOW, all_finite, failed, lift, size_of};
use super::scale::{ROUNDING, Scale};

/// What a pair of points showed.
#[derive(Clone, Debug, Default)]
pub struct Outcome {
    /// The first promise that was not kept.
    pub failure: Option<Failure>,
    /// The error of the secant identity in ulp of its scale.
    pub ulps: f64,
    /// The law, or the scale, is not finite there: nothing was tried.
    pub unbounded: bool,
    /// Whether the ends lie in different branches.
    pub crosses: bool,
    /// How many derivatives had differences that settle.
    pub slopes: usize,
}

/// A miss that is no number exceeds everything.
fn exceeds(miss: f64, allowed: f64) -> bool {
    miss.is_nan() || miss > allowed
}

/// Tries a law between two points; derivatives too, if `slopes` says so.
pub fn try_pair(law: &Law, engine: &Engine, a: &[f64], b: &[f64], slopes: bool) -> Outcome {
    let mut outcome = Outcome::default();
    let step: Vec<f64> = a.iter().zip(b).map(|(a, b)| b - a).collect();
    let scale = Scale::of(&law.tree, a, b, &step);
    if !scale.is_finite() {
        outcome.unbounded = true;
        return outcome;
    }
    outcome.crosses = scale.crosses;
    outcome.failure = (|| {
        secant(law, engine, a, b, &scale, &mut outcome.ulps)?;
        if a == b {
            limit(law, engine, a)?;
        }
        structure(law, engine, a, b)?;
        if slopes { derivatives(law, engine, a, b, &scale, &mut outcome.slopes) } else { Ok(()) }
    })()
    .err();
    outcome
}

fn secant(law: &Law, engine: &Engine, a: &[f64], b: &[f64], scale: &Scale, ulps: &mut f64) -> Result<(), Failure> {
    let g = engine.between(&engine.discrete_gradient, a, b);
    if !all_finite(&g) {
        // The tip of a cone, or the foot of a vertical root.
        if scale.vertical {
            return Ok(());
        }
        return failed(Promise::Finite, format!("the discrete gradient is {g:?}"));
    }
    let exchanged = engine.between(&engine.discrete_gradient, b, a);
    if g.iter().zip(&exchanged).any(|(x, y)| x.to_bits() != y.to_bits() && [*x, *y] != [0.0; 2]) {
        return failed(Promise::Symmetry, format!("from a to b {g:?}, from b to a {exchanged:?}"));
    }
    let (wide_a, wide_b) = (lift(a), lift(b));
    let rise = law.tree.value(&wide_b) - law.tree.value(&wide_a);
    let work = (0..a.len()).fold(DoubleDouble::ZERO, |sum, i| sum + DoubleDouble::from(g[i]) * (wide_b[i] - wide_a[i]));
    let error = (work - rise).to_f64().abs();
    // The truth has digits of its own, 2⁻⁹⁸ of what enters it.
    let own = 2f64.powi(-45) * (scale.value_error[0] + scale.value_error[1]);
    *ulps = if error <= UNDERFLOW { 0.0 } else { error / (2.0 * ROUNDING * (scale.error + own)) };
    if exceeds(*ulps, ULPS) {
        let (work, rise) = (work.to_f64(), rise.to_f64());
        return failed(
            Promise::Secant,
            format!(
                "the discrete gradient {g:?} makes {work:e} of a rise of {rise:e}: off by {error:e}, {ulps:.3e} ulp of {:e}",
                scale.error
            ),
        );
    }
    Ok(())
}

fn limit(law: &Law, engine: &Engine, a: &[f64]) -> Result<(), Failure> {
    let (g, gradient) = (engine.between(&engine.discrete_gradient, a, a), engine.at(&engine.gradient, a));
    for i in 0..a.len() {
        let scale = Scale::along(law, a, i);
        if !scale.is_finite() || scale.doubtful || scale.vertical {
            continue;
        }
        let miss = (g[i] - gradient[i]).abs();
        if exceeds(miss, ULPS * 2.0 * ROUNDING * scale.error + UNDERFLOW) {
            return failed(
                Promise::Limit,
                format!("at a = b the discrete gradient is {g:?}, the gradient {gradient:?}, scale {:e}", scale.error),
            );
        }
    }
    Ok(())
}

/// A law that is called linear, apart or central must be so between any two points.
fn structure(law: &Law, engine: &Engine, a: &[f64], b: &[f64]) -> Result<(), Failure> {
    let d = a.len();
    let Some(Second { structure, hessian, .. }) = &engine.second else { return Ok(()) };
    let separate = structure.diagonal_hessian && d > 1;
    if !structure.constant_hessian && !separate && structure.central.is_none() {
        return Ok(());
    }
    let (at_a, at_b) = (engine.at(&engine.gradient, a), engine.at(&engine.gradient, b));
    let size = size_of;
    let reach = size(a) + size(b);
    if structure.constant_hessian {
        let hessian = engine.at(hessian, a);
        let allowed = 1e-12 * (size(&at_a) + size(&at_b) + size(&hessian) * reach);
        for i in 0..d {
            let turn: f64 = (0..d).map(|j| hessian[i * d + j] * (b[j] - a[j])).sum();
            let change = at_b[i] - at_a[i];
            if exceeds((turn - change).abs(), allowed) {
                let words = format!("called linear, but ∇Φ changes by {change:e} where H (b − a) is {turn:e}");
                return failed(Promise::Structure, words);
            }
        }
    }
    if separate {
        // What happens in one coordinate may not depend on where the others are.
        let mut mixed = b.to_vec();
        mixed[0] = a[0];
        let slope = engine.at(&engine.gradient, &mixed)[0];
        if all_finite(&[slope, at_a[0]]) && (slope - at_a[0]).abs() > 1e-12 * (size(&at_a) + size(&at_b)) {
            let words = format!("called apart, but ∂Φ/∂x at the same x is {:e} and {slope:e}", at_a[0]);
            return failed(Promise::Structure, words);
        }
    }
    if structure.central.is_some() {
        // The slopes may cancel.
        let terms = (0..d).map(|i| Scale::along(law, a, i).error).fold(0.0, f64::max);
        let terms = if terms.is_finite() { ULPS * 2.0 * ROUNDING * terms } else { 0.0 };
        for i in 1..d {
            let twist = at_a[0] * a[i] - at_a[i] * a[0];
            if all_finite(&at_a) && twist.abs() > (1e-12 * size(&at_a) + 2.0 * terms + UNDERFLOW) * size(a) {
                let words = format!("called central, but ∇Φ = {at_a:?} is not along the position");
                return failed(Promise::Structure, words);
            }
        }
    }
    Ok(())
}

/// Whether second derivatives are tried of law k: they cost four times as much as the rest.
pub(crate) fn tries_second(k: u64) -> bool {
    k.is_multiple_of(6)
}

/// Whether differences are taken at a pair of this kind.
pub(crate) fn takes_differences(place: Place) -> bool {
    matches!(place, Place::Generic | Place::Round | Place::SameOnSeam | Place::Origin | Place::Far | Place::Near)
}
