//! When sweeps have come near enough.

use dmech_scalar::{Mask, Real};

use super::{Eight, Part, Staging, largest_of};

/// A change of a push counts from this part of an ulp of it on: what sweeps leave has one sign, and adds up from step to step.
const COUNTS: f64 = 1.0 / 32.0;
/// A path h v counts as a push that is this part of it.
const PATH: f64 = 1.0 / 256.0;
/// What hardly moves beside the others has this part of their moves.
const LEAST: f64 = 1e-18;
/// The rounding of a position changes a push by a few parts of it.
const BY_PLACE: f64 = 4.0;

/// The part of a path h v that counts as a push.
#[inline(always)]
pub(crate) fn of_path<R: Real>(drift: R) -> R {
    R::from_f64(PATH) * drift.abs()
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
    /// What a push is taken for at least.
    floor: R,
    /// 1, or 0 where nothing moves yet and nothing tells what counts.
    unit: R,
}

impl<R: Staging> Nearing<R> {
    /// Before any step.
    pub(crate) fn none() -> Self {
        let none = R::Eight::splat(R::ZERO);
        Nearing { change: none, before: none, rounding: R::ZERO, floor: R::ZERO, unit: R::ZERO }
    }

    /// Before the sweeps of a step; `largest` is the largest push, or [path](of_path).
    #[inline(always)]
    pub(crate) fn begin(largest: R) -> Self {
        let at_rest = largest.equal(R::ZERO);
        let unit = R::either(at_rest, R::ZERO, R::ONE);
        // What counts of a push has a finite reciprocal.
        let least = R::smallest() / (R::from_f64(COUNTS) * R::EPSILON);
        let floor = R::either(at_rest, R::ONE, R::from_f64(LEAST) * largest + least);
        let [change, before] = [1.0, f64::INFINITY].map(|x| R::Eight::splat(R::from_f64(x)));
        Nearing { change, before, rounding: R::ZERO, floor, unit }
    }

    /// 1 over the change that counts of a push, which is, or has a path that counts as, `push`; and what the rounding of a position
    /// may make of it, as |q| and |h v| are at most `reach`.
    #[inline(always)]
    pub(crate) fn per_unit(&self, push: R, reach: R) -> [R; 2] {
        let per_unit = (R::from_f64(COUNTS) * R::EPSILON * push.larger_number(self.floor)).recip();
        let by_place = R::from_f64(BY_PLACE) * R::EPSILON * reach;
        [per_unit, by_place * per_unit]
    }

    /// A rounding may be so large.
    #[inline(always)]
    pub(crate) fn allow(&mut self, rounding: R) {
        self.rounding = self.rounding.larger_number(rounding);
    }

    /// After a sweep with these changes in a part of the stages: whether some push has come nearer, and is not yet so near that by the
    /// last two changes another sweep would be lost.
    #[inline(always)]
    pub(crate) fn comes_nearer(&mut self, part: usize, change: Part<R>) -> R::Mask {
        let before = self.before.part(part);
        let least = self.change.part(part) * R::Eight::alike(self.unit);
        let nearer = least.less_or_equal(change * change).and(change.less(before));
        // Roundings go to and fro: of eight stages one would come nearer to what it was before again and again.
        let by_rounding = change.less_or_equal(R::Eight::alike(self.rounding)).and(before.less(change));
        self.before.set(part, Part::<R>::either(by_rounding, before, change));
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

    /// The largest change in the last sweep.
    #[cold]
    pub(crate) fn change(&self) -> f64 {
        self.change.largest().to_f64()
    }
}
