//! The end of a step of eight stages.

use dmech_scalar::{Real, two_sum};

use super::abreast::{Abreast, abreast};
use super::{Staging, Tableau};

/// q′ = q + h v + Σ (1 − cⱼ) Lⱼ and v′ = v + Σ Lⱼ/h of all coordinates: of q, of what its rounding left out, and of v and that.
#[inline(always)]
pub(crate) fn settle<R: Staging>(tableau: &Tableau, dt: R, pushes: &[R::Eight], mut moved: [&mut [R]; 4]) {
    let rate = dt.recip();
    // A step so short that it has no reciprocal moves no velocity.
    let rates = [dt, R::either(rate.finite(), rate, R::ZERO)];
    abreast!(R, pushes.len(), settle_at(tableau, rates, pushes, &mut moved));
}

/// The same of the coordinates from `at` on.
#[inline(always)]
fn settle_at<R: Staging, A: Abreast<R>>(
    at: usize,
    tableau: &Tableau,
    [dt, rate]: [R; 2],
    pushes: &[R::Eight],
    [q, q_low, v, v_low]: &mut [&mut [R]; 4],
) {
    let here = |x: &[R]| A::gather(x, at);
    let sums = A::sums(&tableau.rests, pushes, at);
    let start = [(here(q), here(q_low)), (here(v), here(v_low))];
    let [(place, place_low), (speed, speed_low)] = settled([dt, rate].map(A::alike), start, sums);
    A::scatter(place, q, at);
    A::scatter(place_low, q_low, at);
    A::scatter(speed, v, at);
    A::scatter(speed_low, v_low, at);
}

/// q + h v + Σ (1 − cⱼ) Lⱼ and v + Σ Lⱼ/h from both sums, for numbers that carry their rounding.
#[inline(always)]
fn settled<R: Real>([dt, rate]: [R; 2], [q, v]: [(R, R); 2], [place, speed]: [R; 2]) -> [(R, R); 2] {
    let (path, rest) = path(dt, v);
    // With what it leaves out: by a rounded 1/h alone it would be wrong by the same relative amount in each step.
    let (gain, left) = speed.quotient(dt, rate);
    [moved(q, path, rest + place), moved(v, gain, left)]
}

/// x + Δ + δ for a small δ, in two parts. The second has digits of its own: of a Δ + δ that is rounded first nothing would be left
/// of δ.
#[inline(always)]
fn moved<R: Real>((x, low): (R, R), by: R, rest: R) -> (R, R) {
    let (sum, lost) = two_sum(x, by);
    two_sum(sum, lost + (low + rest))
}

/// The path h v of a velocity that carries its rounding, rounded, and what that leaves out.
///
/// A path of the rounded velocity alone would be off by what that velocity decides, and for many h (0.2, 0.15, close to short
/// fractions) in the mean to one side; as do quotients by h. Energy then grows like the number of steps and not like its root.
#[inline(always)]
pub(crate) fn path<R: Real>(dt: R, (v, v_low): (R, R)) -> (R, R) {
    let (path, rest) = dt.product(v);
    (path, dt.mul_add(v_low, rest))
}

/// The same rounded once, on targets without fused instructions too: h v and h times the low part, each rounded, are off to one side
/// for many h.
#[inline(always)]
pub(crate) fn drift<R: Real>(dt: R, v: (R, R)) -> R {
    let (path, rest) = path(dt, v);
    path + rest
}
