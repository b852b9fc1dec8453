//! Where steps that follow the motion are, for one motion or for several side by side.

use dmech_scalar::{Compensated, Mask, Real, Rows, RowsMask};

use super::Adaptive;
use crate::scheme::{Adaptable, ByLane};
use crate::span::TOLD_APART;
use crate::system::Look;

/// The last step, the next, and the time.
#[derive(Clone, Copy, Debug)]
pub(crate) struct Pacing<R: Real = f64> {
    /// ρ, the density of the steps: it is h = ε/ρ.
    pub(super) density: R,
    /// ε, that of the tolerance or what was left of it.
    pub(super) angle: R,
    /// The last step, at the start the next.
    pub(super) last: R,
    /// The next step.
    pub(crate) dt: R,
    /// How many more of the same follow.
    pub(super) left: R,
    /// Whether that ends at the end.
    pub(super) landing: R::Mask,
    pub(crate) time: Compensated<R>,
    /// The shortest and the longest step so far, but for the one that was shortened to land.
    pub(super) range: [R; 2],
}

/// ρ/ω stays between these, at the ends of steps.
const BAND: [f64; 2] = [2.0 / 3.0, 1.5];

/// The same in the middle of steps, where ω of their end differs: no step is negative.
pub(super) const MIDDLE: [f64; 2] = [0.25, 4.0];

/// Steps that turn the motion by so little see how ω changes, on smooth motions.
const SEES: f64 = 0.3;

impl<R: Real> Pacing<R> {
    /// The smallest ω that counts, where a step is this long at most.
    pub(crate) fn least(&self, longest: R) -> R {
        self.angle / longest
    }

    /// How many times as long as the last the next step is.
    pub(crate) fn ratio(&self) -> R {
        self.dt / self.last
    }

    /// Where there is a shorter step for one that has not seen ω change.
    #[inline(always)]
    pub(crate) fn may_shorten(&self) -> R::Mask {
        R::from_f64(SEES).less(self.angle)
    }

    /// Steps are half as long from here on.
    pub(super) fn shorten(&mut self) {
        self.angle = (R::from_f64(0.5) * self.angle).max(R::from_f64(SEES));
    }

    /// Where the next step is one: longer than the rounding of the time, and a number.
    pub(crate) fn moves_on(&self) -> R::Mask {
        let (time, dt) = (self.time.value(), self.dt);
        (time.abs() * R::EPSILON).less(dt).and(dt.finite()).or(self.landing)
    }
}

impl<S: Adaptable> Adaptive<S> {
    /// Chooses the next step.
    #[inline(always)]
    pub(crate) fn plan<R: Real>(&self, longest: R, pacing: &mut Pacing<R>) {
        let dt = (pacing.angle / pacing.density).min(longest);
        let left = self.left(pacing);
        // A little longer rather than another step that is nothing but rounding.
        pacing.landing = dt.finite().and(left.less_or_equal(dt * R::from_f64(1.0 + 1e-9)));
        pacing.dt = R::either(pacing.landing, left, dt);
    }

    /// The step was made: where the law is to be looked at, at the end of a row and, so that no contact is passed unseen, before
    /// more than the longest step has gone by.
    #[inline(always)]
    pub(crate) fn made<R: Real>(&self, longest: R, pacing: &mut Pacing<R>) -> R::Mask {
        let Pacing { dt, landing, range: [least, most], .. } = *pacing;
        pacing.last = dt;
        pacing.left -= R::ONE;
        pacing.time.add(dt);
        let Compensated { hi, lo } = pacing.time;
        let (end, either) = (R::from_f64(self.end), |yes, no| R::either(landing, yes, no));
        pacing.time = Compensated { hi: either(end, hi), lo: either(R::ZERO, lo) };
        pacing.range = [either(least, least.min(dt)), either(most, most.max(dt))];
        let ends = pacing.left.less(R::ONE);
        if !longest.finite().any() {
            return ends;
        }
        let steps = (longest / dt).floor();
        ends.or((pacing.left - steps * (pacing.left / steps).floor()).equal(R::ZERO))
    }

    /// ρ follows what the law was seen to be like, where that was looked at: at the end of a row, and within one where the motion has
    /// become so fast that the row ends.
    #[inline(always)]
    pub(crate) fn looked<R: Real>(&self, look: &Look<R>, due: R::Mask, pacing: &mut Pacing<R>) {
        let fast = pacing.density.less(look.within(BAND, pacing.density));
        let ends = due.and(pacing.left.less(R::ONE).or(fast));
        let (density, left) = (self.follow(pacing, look), R::from_f64(self.row));
        pacing.density = R::either(ends, density, pacing.density);
        pacing.left = R::either(ends, left, pacing.left);
    }

    /// By how much ρ grows in half a row.
    #[inline(always)]
    fn half_growth<R: Real>(&self, pacing: &Pacing<R>, look: &Look<R>) -> R {
        R::from_f64(0.5 * self.row) * pacing.angle * look.growth
    }

    /// Where a step has not seen ω change as it did, and may be shorter. One that is far too long may have left for where nothing acts.
    #[inline(always)]
    pub(crate) fn is_too_long<R: Real>(&self, look: &Look<R>, pacing: &Pacing<R>) -> R::Mask {
        let amid = pacing.density + self.half_growth(pacing, look);
        pacing.may_shorten().and(look.outruns(BAND[0], amid).or(look.outlasts(MIDDLE[1], amid)))
    }

    /// ρ of the next step from that of the last.
    #[inline(always)]
    pub(super) fn follow<R: Real>(&self, pacing: &Pacing<R>, look: &Look<R>) -> R {
        let half = self.half_growth(pacing, look);
        let amid = pacing.density + half;
        let astray = look.outruns(BAND[0], amid);
        let amid = if astray.any() { R::either(astray, look.rate(), amid) } else { amid };
        look.within(MIDDLE, look.within(BAND, amid) + half)
    }

    /// Where as many steps as of equal steps may be would come to the end, were all as long as the longest so far. Near t = 0 the
    /// rounding of the time tells nothing of it.
    pub(crate) fn is_in_reach<R: Real>(&self, pacing: &Pacing<R>) -> R::Mask {
        let Pacing { dt, range: [_, most], .. } = *pacing;
        let (end, steps) = (R::from_f64(self.end), R::from_f64(TOLD_APART));
        let left = end - pacing.time.value();
        end.finite().not().or(left.less_or_equal(most.max(dt) * steps))
    }

    /// Where the end is reached, not only as far as a rounded time tells.
    pub(crate) fn has_arrived<R: Real>(&self, pacing: &Pacing<R>) -> R::Mask {
        self.left(pacing).less_or_equal(R::ZERO)
    }

    /// The time that is left to the end.
    #[inline(always)]
    fn left<R: Real>(&self, pacing: &Pacing<R>) -> R {
        (R::from_f64(self.end) - pacing.time.hi) - pacing.time.lo
    }
}

impl<const W: usize> ByLane<Pacing, W> for Pacing<Rows<W>> {
    fn alike(one: &Pacing) -> Self {
        let Pacing { density, angle, last, dt, left, landing, time: Compensated { hi, lo }, range } = *one;
        let [density, angle, last, dt, left, hi, lo] = [density, angle, last, dt, left, hi, lo].map(Rows::from_f64);
        let (landing, range) = (Rows::from_f64(f64::from(landing)).equal(Rows::ONE), range.map(Rows::from_f64));
        Pacing { density, angle, last, dt, left, landing, time: Compensated { hi, lo }, range }
    }

    fn lane(&self, lane: usize) -> Pacing {
        let Pacing { density, angle, last, dt, left, landing, time: Compensated { hi, lo }, range } = *self;
        Pacing {
            density: density[lane],
            angle: angle[lane],
            last: last[lane],
            dt: dt[lane],
            left: left[lane],
            landing: Rows::either(landing, Rows::ONE, Rows::ZERO)[lane] > 0.0,
            time: Compensated { hi: hi[lane], lo: lo[lane] },
            range: range.map(|step| step[lane]),
        }
    }
    fn set(&mut self, lane: usize, one: &Pacing) {
        let mut landing = Rows::either(self.landing, Rows::ONE, Rows::ZERO);
        landing[lane] = f64::from(one.landing);
        self.landing = landing.equal(Rows::ONE);
        self.density[lane] = one.density;
        self.angle[lane] = one.angle;
        self.last[lane] = one.last;
        self.dt[lane] = one.dt;
        self.left[lane] = one.left;
        (self.time.hi[lane], self.time.lo[lane]) = (one.time.hi, one.time.lo);
        self.range.set(lane, &one.range);
    }

    fn put(&mut self, which: RowsMask<W>, other: &Self) {
        (0..Rows::<W>::COUNT).filter(|&lane| Rows::either(which, Rows::ONE, Rows::ZERO)[lane] > 0.0).for_each(|lane| {
            self.set(lane, &other.lane(lane));
        });
    }
}
