//! When sweeps have come near enough.

use dmech_scalar::{Mask, Real};

use super::abreast::{Abreast, abreast, largest_number};
use super::{Eight, Part, Staging, largest_of, path};

/// A change of a push counts from this part of an ulp of it on: what sweeps leave has one sign, and adds up from step to step.
const COUNTS: f64 = 1.0 / 32.0;
/// A path h v counts as a push that is this part of it.
const PATH: f64 = 1.0 / 256.0;
/// What hardly moves beside the others has this part of their moves.
const LEAST: f64 = 1e-18;
/// The rounding of a position changes a push by a few parts of it.
const BY_PLACE: f64 = 4.0;

/// How coordinates move in a step: the path h v, the largest push or path that counts as one, and the larger of |q| and |h v|.
#[inline(always)]
pub(crate) fn moves<R: Staging>(dt: R, start: [&[R]; 3], pushes: &[R::Eight], mut moves: [&mut [R]; 3]) {
    abreast!(R, pushes.len(), moves_at(dt, start, pushes, &mut moves));
}

/// The same of the coordinates from `at` on.
#[inline(always)]
fn moves_at<R: Staging, A: Abreast<R>>(
    at: usize,
    dt: R,
    [q, v, v_low]: [&[R]; 3],
    pushes: &[R::Eight],
    [drifts, counts, reach]: &mut [&mut [R]; 3],
) {
    let (drift, rest) = path(A::alike(dt), (A::gather(v, at), A::gather(v_low, at)));
    let drift = drift + rest;
    A::scatter(drift, drifts, at);
    A::scatter(A::largest(pushes, at).larger_number((A::alike(R::from_f64(PATH)) * drift).abs()), counts, at);
    A::scatter(A::gather(q, at).abs().larger_number(drift.abs()), reach, at);
}

/// How near the sweeps of a step are: changes of pushes in units of what counts for their coordinate or body.
#[derive(Clone, Copy, Debug)]
pub struct Nearing<R: Staging> {
    /// The largest change of each stage in the last sweep.
    change: R::Eight,
    /// The same, or the least so far where rounding may have made it.
    before: R::Eight,
    /// What the rounding of a position may make of a push.
    rounding: R,
    /// 1, or 0 where nothing moves yet and nothing tells what counts.
    unit: R,
}

/// A push is taken for `floor` at least.
#[inline(always)]
fn measure_at<R: Staging, A: Abreast<R>>(at: usize, floor: R, counts: &mut [R], reach: &mut [R]) {
    let number = |x: f64| A::alike(R::from_f64(x) * R::EPSILON);
    let per_unit = (number(COUNTS) * A::alike(floor).larger_number(A::gather(counts, at))).recip();
    A::scatter(per_unit, counts, at);
    A::scatter(number(BY_PLACE) * A::gather(reach, at) * per_unit, reach, at);
}

impl<R: Staging> Nearing<R> {
    /// Before any step.
    pub(crate) fn none() -> Self {
        let none = R::Eight::splat(R::ZERO);
        Nearing { change: none, before: none, rounding: R::ZERO, unit: R::ZERO }
    }

    /// Before the sweeps of a step. `counts` are the largest push of each coordinate or body, or [what counts as one](moves), and
    /// become 1 over the change that counts; `reach` is at least |q| and |h v|, and becomes what the rounding of a position may make
    /// of a push.
    #[inline(always)]
    pub(crate) fn begin(counts: &mut [R], reach: &mut [R]) -> Self {
        let largest = largest_number(counts);
        let at_rest = largest.equal(R::ZERO);
        let unit = R::either(at_rest, R::ZERO, R::ONE);
        // What counts of a push has a finite reciprocal.
        let least = R::smallest() / (R::from_f64(COUNTS) * R::EPSILON);
        let floor = R::either(at_rest, R::ONE, R::from_f64(LEAST) * largest + least);
        abreast!(R, counts.len(), measure_at(floor, counts, reach));
        let [change, before] = [1.0, f64::INFINITY].map(|x| R::Eight::splat(R::from_f64(x)));
        Nearing { change, before, rounding: largest_number(reach), unit }
    }

    /// After a sweep with these changes in a part of the stages: whether some push has come nearer, and is not yet so near that by the
    /// last two changes another sweep would be lost.
    #[inline(always)]
    pub(crate) fn comes_nearer(&mut self, part: usize, change: Part<R>) -> R::Mask {
        let before = self.before.part(part);
        let least = self.change.part(part) * R::Eight::alike(self.unit);
        let shrinks = change.less(before);
        let nearer = least.less_or_equal(change * change).and(shrinks);
        // Roundings go to and fro: of eight stages one would come nearer to what it was before again and again. Of two choices neither
        // is the number that is there: to choose that is a store by mask, which with AVX2 took a sixteenth of a step of two coordinates.
        let no_rounding = R::Eight::alike(self.rounding).less(change);
        let most = Part::<R>::either(no_rounding, R::Eight::alike(R::from_f64(f64::INFINITY)), before);
        self.before.set(part, R::Eight::smaller(change, most));
        self.change.set(part, change);
        R::Eight::any(nearer)
    }

    /// Whether no push has changed in the last sweep by more than so many units; where nothing moved before, by more than so many of
    /// the largest.
    #[inline(always)]
    pub(crate) fn is_near(&self, pushes: &[R::Eight], units: f64) -> R::Mask {
        let mut units = R::from_f64(units);
        let at_rest = self.unit.equal(R::ZERO);
        if at_rest.any() {
            units = R::either(at_rest, units * largest_of::<R>(pushes), units);
        }
        let most = R::Eight::alike(self.rounding.larger_number(units));
        let near = |part| R::Eight::all(self.change.part(part).less_or_equal(most));
        (1..R::Eight::PARTS).fold(near(0), |all, part| all.and(near(part)))
    }

    /// What the rounding of a position may make of a push, in the same units.
    pub(crate) fn rounding(&self) -> R {
        self.rounding
    }

    /// The largest change in the last sweep.
    #[cold]
    pub(crate) fn change(&self) -> R {
        self.change.largest()
    }
}
