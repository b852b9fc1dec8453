//! Derivatives against differences of what they are derivatives of, where differences settle.
//!
//! Not asked for, because no formula has it:
//!
//! - a gradient where roots meet whose product is no smaller than what is below them (see [`roots_meet`]), and on the seam of a
//!   choice at which another bends too: which branch is taken there may be taken nowhere around;
//! - second derivatives where values exceed 10⁷⁵, as those of arctangents and their like take fourth powers, and where the
//!   argument of a sine is not known to a thousandth: neither the law nor its slope has a digit there;
//! - a derivative beside a seam that is nearer than the step of the difference;
//! - the Jacobian of a step through a corner, a point where two seams cross: each of the four ways past it is another.
//!
//! A derivative that cancels has the roundings of its terms. Those of a second derivative are the terms of the slope over the
//! distance from 0 on which powers change; the difference that it is held against has, in double-double, those of the slope,
//! and over a wide gap of the values at the ends, over its own step.

use dmech_scalar::{DoubleDouble, Real};

use super::analysis::Analysis;
use super::engine::{Engine, Second};
use super::forms::roots_meet;
use super::grow::Law;
use super::promise::{Failure, Promise, ULPS, UNDERFLOW, all_finite, failed, lift, size_of};
use super::scale::{ROUNDING, Scale};

/// Beyond this nothing is asked of second derivatives: those of arctangents and their like take fourth powers.
const SQUARABLE: f64 = 1e75;

/// ∂f/∂xⱼ by differences, and how far they may be off; none where they do not settle: at a kink, at the edge of a domain.
fn difference<R: Real>(f: &dyn Fn(R) -> R, x: f64, h: f64, noise: f64) -> Option<(f64, f64)> {
    let at = |s: f64| f(R::from_f64(x) + R::from_f64(s));
    let middle = at(0.0);
    let slope = |s: f64| ((at(s) - middle) / R::from_f64(s)).to_f64();
    let [up, down] = [slope(h), slope(-h)];
    let [up_near, down_near] = [slope(h / 16.0), slope(-h / 16.0)];
    if !all_finite(&[up, down, up_near, down_near]) {
        return None;
    }
    let grain = noise * middle.to_f64().abs() / h + UNDERFLOW / h;
    let (bend, bend_near) = ((up - down).abs(), (up_near - down_near).abs());
    if bend_near > 0.7 * bend + 64.0 * grain {
        return None;
    }
    let (coarse, fine) = (0.5 * (up + down), 0.5 * (up_near + down_near));
    // A vertical root.
    if fine.abs() > 1.5 * coarse.abs() + 64.0 * grain {
        return None;
    }
    let size = up_near.abs().max(down_near.abs());
    let allowed = 4.0 * (fine - coarse).abs() + 0.5 * bend_near.min(bend) + 64.0 * grain + 1e-11 * size;
    // A sine that turns many times within the steps may agree with itself by chance, but not at odd fractions as well.
    const ODD: f64 = 187.3;
    let finest = 0.5 * (slope(h / ODD) + slope(-h / ODD));
    ((finest - fine).abs() <= allowed + 64.0 * ODD * grain).then_some((fine, allowed))
}

/// q with coordinate j replaced.
fn moved<R: Real>(q: &[f64], j: usize, x: R) -> Vec<R> {
    q.iter().enumerate().map(|(i, &y)| if i == j { x } else { R::from_f64(y) }).collect()
}

/// The step of differences at x.
fn size(x: f64) -> f64 {
    x.abs().max(1e-3)
}

/// ∂Φ/∂xᵢ by differences in double-double.
fn slope_of_law(law: &Law, q: &[f64], i: usize) -> Option<(f64, f64)> {
    difference(&|x: DoubleDouble| law.tree.value(&moved(q, i, x)), q[i], 1e-9 * size(q[i]), 1e-30)
}

/// Directions that have nothing to do with any seam.
const DIRECTIONS: [[f64; 4]; 2] = [[0.83, 0.57, -0.71, 0.39], [-0.37, 0.91, 0.67, 0.53]];

/// How many choices take another side around a point than at it; the roots of squares are choices too.
fn seams_met(law: &Law, q: &[f64]) -> usize {
    let sides = |q: &[f64]| [law.tree.sides_taken(q), law.tree.signs_below_roots(q)].concat();
    let at = |s: f64, d: &[f64; 4]| sides(&q.iter().zip(d).map(|(x, d)| x + s * d).collect::<Vec<_>>());
    let around: Vec<_> = DIRECTIONS.iter().flat_map(|d| [at(1e-7, d), at(-1e-7, d)]).collect();
    let own = sides(q);
    (0..own.len()).filter(|&i| around.iter().any(|sides| sides[i] != own[i])).count()
}

/// Whether some choice is on its seam there and on one and the same side all around: its other branch is a single point.
fn is_touched(law: &Law, q: &[f64]) -> bool {
    let at = |s: f64, d: &[f64; 4]| law.tree.sides_taken(&q.iter().zip(d).map(|(x, d)| x + s * d).collect::<Vec<_>>());
    let around: Vec<_> = DIRECTIONS.iter().flat_map(|d| [at(1e-7, d), at(-1e-7, d)]).collect();
    let own = law.tree.sides_taken(q);
    (0..own.len()).any(|i| around.iter().all(|sides| sides[i] == around[0][i]) && own[i] != around[0][i])
}

/// Whether a seam lies within the step of a difference: what is beyond it may agree with itself, and with nothing here.
fn is_beside_seam(law: &Law, q: &[f64], j: usize) -> bool {
    let own = law.tree.sides_taken(q);
    let step = 1e-9 * size(q[j]);
    [step, -step, step / 16.0, -step / 16.0].iter().any(|s| law.tree.sides_taken(&moved(q, j, q[j] + s)) != own)
}

/// Whether the law has a gradient at a point on a seam: the slope along a direction is that of the partial ones.
fn is_smooth(law: &Law, q: &[f64]) -> bool {
    if is_touched(law, q) {
        return false;
    }
    let Some(slopes) = (0..q.len()).map(|i| slope_of_law(law, q, i)).collect::<Option<Vec<_>>>() else { return false };
    DIRECTIONS.iter().all(|direction| {
        let on_line = |s: DoubleDouble| {
            let at: Vec<_> = q.iter().zip(direction).map(|(&x, &d)| DoubleDouble::from(x) + s * d.into()).collect();
            law.tree.value(&at)
        };
        let Some((along, allowed)) = difference(&on_line, 0.0, 1e-12, 1e-30) else { return false };
        let sum: f64 = slopes.iter().zip(direction).map(|((s, _), d)| s * d).sum();
        let allowed = allowed + slopes.iter().map(|(s, allowed)| allowed + 1e-6 * s.abs()).sum::<f64>();
        (along - sum).abs() <= allowed
    })
}

/// A derivative: what was computed, and the function that it belongs to in the two kinds of number.
struct Derivative<'a> {
    promise: Promise,
    name: String,
    computed: f64,
    at: f64,
    narrow: &'a dyn Fn(f64) -> f64,
    wide: &'a dyn Fn(DoubleDouble) -> DoubleDouble,
    /// The same computed in double-double.
    exactly: &'a dyn Fn() -> f64,
    /// What rounding may change.
    rounding: f64,
}

impl Derivative<'_> {
    /// By differences: first in binary64, where that is in doubt in double-double. Whether there was something to compare.
    fn check(&self) -> Result<bool, Failure> {
        let Self { promise, name, computed, at, narrow, wide, exactly, rounding } = self;
        if let Some((slope, allowed)) = difference::<f64>(narrow, *at, 1e-4 * size(*at), 1e-15)
            && (slope - computed).abs() <= allowed
        {
            return Ok(true);
        }
        let Some((slope, allowed)) = self.settled(wide) else { return Ok(false) };
        let allowed = allowed + 1e-8 * slope.abs() + rounding;
        // What the formula loses by rounding is not looked at closely here.
        let exact = exactly();
        if (slope - computed).abs() <= allowed
            || (slope - exact).abs() <= allowed
                && (computed - exact).abs() <= 1e-6 * (exact.abs() + rounding / ROUNDING)
        {
            return Ok(true);
        }
        let words = format!("{name} is {computed:e}; by differences {slope:e} ± {allowed:.1e}");
        Err(Failure { promise: *promise, words })
    }

    fn settled(&self, wide: &dyn Fn(DoubleDouble) -> DoubleDouble) -> Option<(f64, f64)> {
        difference::<DoubleDouble>(wide, self.at, 1e-9 * size(self.at), 1e-30)
    }
}

/// Derivatives against differences of what they are derivatives of. On a seam the gradient is asked for if the law has one, and
/// second derivatives, which are those of one branch, to be finite if all of them settle.
pub(crate) fn derivatives(
    law: &Law,
    engine: &Engine,
    a: &[f64],
    b: &[f64],
    scale: &Scale,
    settled: &mut usize,
) -> Result<(), Failure> {
    let d = a.len();
    let gradient = engine.at(&engine.gradient, a);
    let special = scale.doubtful || scale.vertical;
    if (!special || is_smooth(law, a)) && !roots_meet(&law.tree, a) {
        for j in 0..d {
            // The slope of a vertical root times what vanishes with it may have a limit; not every one is found. On a seam
            // of one choice within another the branch that is taken may be taken nowhere else.
            let met = seams_met(law, a).max(Analysis::seams_at(&law.tree, a)) + usize::from(scale.vertical);
            if (scale.vertical && !gradient[j].is_finite()) || (scale.doubtful && met > 1) {
                continue;
            }
            let derivative = Derivative {
                promise: Promise::Gradient,
                name: format!("∂Φ/∂x{j} at a"),
                computed: gradient[j],
                at: a[j],
                narrow: &|x| law.tree.value(&moved(a, j, x)),
                wide: &|x| law.tree.value(&moved(a, j, x)),
                exactly: &|| engine.at(&engine.gradient, &lift(a))[j].to_f64(),
                // That of Φ in double-double over the step of the difference.
                rounding: 2f64.powi(-92) * scale.value_error[0] / (1e-9 * size(a[j]))
                    + ULPS * 2.0 * ROUNDING * Scale::along(law, a, j).error,
            };
            match derivative.check() {
                Err(_) if !special && is_beside_seam(law, a, j) => {}
                found => *settled += usize::from(found?),
            }
        }
    }
    let Some(Second { hessian: hessian_program, jacobian: jacobian_program, .. }) = &engine.second else {
        return Ok(());
    };
    if scale.largest > SQUARABLE || scale.unsettled {
        return Ok(());
    }
    let (hessian, jacobian) = (engine.at(hessian_program, a), engine.between(jacobian_program, a, b));
    let discrete = engine.between(&engine.discrete_gradient, a, b);
    let wide_a = lift(a);
    // The terms that the components of the gradients are summed of.
    let terms: Vec<f64> = (0..d).map(|i| Scale::along(law, a, i).error + Scale::along(law, b, i).error).collect();
    let gap = a.iter().zip(b).map(|(a, b)| (b - a).abs()).filter(|&gap| gap > 0.0).fold(f64::INFINITY, f64::min);
    let reach = a.iter().zip(b).map(|(a, b)| (b - a).abs()).fold(0.0, f64::max);
    for promise in [Promise::Hessian, Promise::Jacobian] {
        if promise == Promise::Jacobian && scale.corner {
            continue;
        }
        let (computed, q, name) = match promise {
            Promise::Hessian => (&hessian, a, "∂²Φ/∂x∂x at a"),
            _ => (&jacobian, b, "∂∇̄Φ/∂b"),
        };
        let mut undecided = 0;
        // Across a seam, and over a wide gap, the quotient of a rise and the gap may be what is differentiated.
        let quotient = match promise {
            Promise::Jacobian if scale.crosses || gap > 1e-2 => (size_of(&discrete) + scale.error / gap) / gap,
            _ => 0.0,
        };
        let values = match promise {
            Promise::Jacobian => scale.value_error[0] + scale.value_error[1],
            _ => 0.0,
        };
        let rounding =
            64.0 * ROUNDING * (size_of(computed) + quotient) + ROUNDING * (size_of(&discrete) + size_of(&gradient));
        for (i, j) in (0..d).flat_map(|i| (0..d).map(move |j| (i, j))) {
            // The terms may cancel, in binary64 and, over the step of the difference, in double-double; over a wide gap the
            // values at the ends may.
            let size = size(q[j]);
            let rise = if reach > 1e-2 { values / reach } else { 0.0 };
            let cancelled =
                ULPS * 2.0 * ROUNDING * terms[i] / size + 2f64.powi(-92) * (terms[i] + rise) / (1e-9 * size);
            let rounding = rounding + if cancelled.is_finite() { cancelled } else { 0.0 };
            let narrow = |x: f64| match promise {
                Promise::Hessian => engine.at(&engine.gradient, &moved(a, j, x))[i],
                _ => engine.between(&engine.discrete_gradient, a, &moved(b, j, x))[i],
            };
            let wide = |x: DoubleDouble| match promise {
                Promise::Hessian => engine.at(&engine.gradient, &moved(a, j, x))[i],
                _ => engine.between(&engine.discrete_gradient, &wide_a, &moved(b, j, x))[i],
            };
            let exactly = || match promise {
                Promise::Hessian => engine.at(hessian_program, &wide_a)[i * d + j].to_f64(),
                _ => engine.between(jacobian_program, &wide_a, &lift(b))[i * d + j].to_f64(),
            };
            let computed = computed[i * d + j];
            let name = format!("component {i} {j} of {name}");
            let derivative = Derivative {
                promise,
                name,
                computed,
                at: q[j],
                narrow: &narrow,
                wide: &wide,
                exactly: &exactly,
                rounding,
            };
            if !special {
                match derivative.check() {
                    Err(_) if is_beside_seam(law, q, j) => {}
                    found => *settled += usize::from(found?),
                }
            } else if derivative.settled(&wide).is_none() {
                undecided += 1;
            }
        }
        if special && !scale.vertical && undecided == 0 && !all_finite(computed) {
            return failed(promise, format!("{name} is {computed:?}"));
        }
    }
    Ok(())
}
