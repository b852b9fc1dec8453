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

use super::engine::{Engine, Second};
use super::grow::Law;
use super::points::Place;
use super::scale::{ROUNDING, Scale};

/// What was not kept.
#[derive(Clone, Copy, Debug, PartialEq, Eq, PartialOrd, Ord, Hash)]
#[allow(missing_docs)]
pub enum Promise {
    Secant,
    Finite,
    Symmetry,
    Limit,
    Gradient,
    Hessian,
    Jacobian,
    Structure,
}

/// A promise that was not kept, with both sides.
#[derive(Clone, Debug)]
pub struct Failure {
    /// Which one.
    pub promise: Promise,
    /// What was computed and what it should be.
    pub words: String,
}

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

/// What the secant identity may miss, in ulp of its scale.
pub const ULPS: f64 = 8.0;

/// Below this nothing is asked for: products that underflow lose more than roundings.
const UNDERFLOW: f64 = 1e-250;

fn lift(q: &[f64]) -> Vec<DoubleDouble> {
    q.iter().map(|&x| x.into()).collect()
}

/// A miss that is no number exceeds everything.
fn exceeds(miss: f64, allowed: f64) -> bool {
    miss.is_nan() || miss > allowed
}

fn size_of(values: &[f64]) -> f64 {
    values.iter().fold(0.0, |m: f64, x| m.max(x.abs()))
}

fn all_finite(values: &[f64]) -> bool {
    values.iter().all(|x| x.is_finite())
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
        structure(engine, a, b)?;
        if slopes { derivatives(law, engine, a, b, &scale, &mut outcome.slopes) } else { Ok(()) }
    })()
    .err();
    outcome
}

fn failed(promise: Promise, words: String) -> Result<(), Failure> {
    Err(Failure { promise, words })
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

/// The figures of ∂Φ/∂xᵢ.
fn along(law: &Law, q: &[f64], i: usize) -> Scale {
    let mut unit = vec![0.0; q.len()];
    unit[i] = 1.0;
    Scale::of(&law.tree, q, q, &unit)
}

fn limit(law: &Law, engine: &Engine, a: &[f64]) -> Result<(), Failure> {
    let (g, gradient) = (engine.between(&engine.discrete_gradient, a, a), engine.at(&engine.gradient, a));
    for i in 0..a.len() {
        let scale = along(law, a, i);
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
fn structure(engine: &Engine, a: &[f64], b: &[f64]) -> Result<(), Failure> {
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
        for i in 1..d {
            let twist = at_a[0] * a[i] - at_a[i] * a[0];
            if all_finite(&at_a) && twist.abs() > 1e-12 * size(&at_a) * size(a) {
                let words = format!("called central, but ∇Φ = {at_a:?} is not along the position");
                return failed(Promise::Structure, words);
            }
        }
    }
    Ok(())
}

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

/// How many choices take another side around a point than at it.
fn seams_met(law: &Law, q: &[f64]) -> usize {
    let at = |s: f64, d: &[f64; 4]| law.tree.sides_taken(&q.iter().zip(d).map(|(x, d)| x + s * d).collect::<Vec<_>>());
    let around: Vec<_> = DIRECTIONS.iter().flat_map(|d| [at(1e-7, d), at(-1e-7, d)]).collect();
    let own = law.tree.sides_taken(q);
    (0..own.len()).filter(|&i| around.iter().any(|sides| sides[i] != own[i])).count()
}

/// Whether some choice is on its seam there and on one and the same side all around: its other branch is a single point.
fn is_touched(law: &Law, q: &[f64]) -> bool {
    let at = |s: f64, d: &[f64; 4]| law.tree.sides_taken(&q.iter().zip(d).map(|(x, d)| x + s * d).collect::<Vec<_>>());
    let around: Vec<_> = DIRECTIONS.iter().flat_map(|d| [at(1e-7, d), at(-1e-7, d)]).collect();
    let own = law.tree.sides_taken(q);
    (0..own.len()).any(|i| around.iter().all(|sides| sides[i] == around[0][i]) && own[i] != around[0][i])
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
fn derivatives(
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
    if !special || is_smooth(law, a) {
        for j in 0..d {
            // The slope of a vertical root times what vanishes with it may have a limit; not every one is found. On a seam
            // of one choice within another the branch that is taken may be taken nowhere else.
            let met = seams_met(law, a) + usize::from(scale.vertical);
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
                    + ULPS * 2.0 * ROUNDING * along(law, a, j).error,
            };
            *settled += usize::from(derivative.check()?);
        }
    }
    let Some(Second { hessian: hessian_program, jacobian: jacobian_program, .. }) = &engine.second else {
        return Ok(());
    };
    let (hessian, jacobian) = (engine.at(hessian_program, a), engine.between(jacobian_program, a, b));
    let discrete = engine.between(&engine.discrete_gradient, a, b);
    let wide_a = lift(a);
    let gap = a.iter().zip(b).map(|(a, b)| (b - a).abs()).filter(|&gap| gap > 0.0).fold(f64::INFINITY, f64::min);
    for promise in [Promise::Hessian, Promise::Jacobian] {
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
        let rounding =
            64.0 * ROUNDING * (size_of(computed) + quotient) + ROUNDING * (size_of(&discrete) + size_of(&gradient));
        for (i, j) in (0..d).flat_map(|i| (0..d).map(move |j| (i, j))) {
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
                *settled += usize::from(derivative.check()?);
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

/// Whether second derivatives are tried of law k: they cost four times as much as the rest.
pub(crate) fn tries_second(k: u64) -> bool {
    k.is_multiple_of(6)
}

/// Whether differences are taken at a pair of this kind.
pub(crate) fn takes_differences(place: Place) -> bool {
    matches!(place, Place::Generic | Place::Round | Place::SameOnSeam | Place::Origin | Place::Far | Place::Near)
}
