//! Whether what is stepped is what was written.

use core::panic::AssertUnwindSafe;
use std::panic::catch_unwind;

use super::tracked::{MARGIN, ROUNDING};
use super::{OwnValues, Values, Written};
use crate::drift::MAX_OWN;
use crate::error::{Culprit, Disagreement};

/// Where a law is looked at; of a law between two bodies `q` is d = q_a − q_b, and there are two velocities and masses.
#[derive(Clone, Copy, Debug)]
pub struct Probe<const D: usize> {
    /// The position, or the separation.
    pub q: [f64; D],
    /// The velocities.
    pub v: [[f64; D]; 2],
    /// The masses.
    pub m: [f64; 2],
    /// The time.
    pub t: f64,
}

/// How well both agree at one place.
#[derive(Clone, Copy, Debug)]
pub enum Agreement {
    /// The largest difference, over the one that rounding may make.
    Compared(f64, Disagreement),
    /// Only one of the two is a number there, as where a factor that is 0/0 has cancelled.
    OneSided(Disagreement),
    /// Neither is: nothing to compare.
    Nowhere,
}

/// Compares at the start of a motion and at places around it, in position, velocity, mass and time.
///
/// Around it, because at a special start, at rest in a minimum at t = 0, many laws agree. That is looked at once for a law and
/// not on every body that it acts on: `closely`. Where only one of the two is finite it counts as a difference if there is no
/// place at all where both are, or if the author's method panics at the start.
///
/// # Errors
/// The first [`Disagreement`].
pub(crate) fn agree<const D: usize>(law: &dyn Written<D>, start: &Probe<D>, closely: bool) -> Result<(), Disagreement> {
    const PLACES: usize = 8;
    let (mut compared, mut one_sided) = (false, None);
    for k in 0..=PLACES {
        let place = if k == 0 { *start } else { start.displaced(k) };
        match agreement(law, &place) {
            // A panic is printed each time.
            Agreement::OneSided(panicked) if k == 0 && panicked.panics() => return Err(panicked),
            Agreement::Compared(ratio, difference) if ratio > 1.0 => return Err(difference),
            Agreement::Compared(..) if !closely => return Ok(()),
            Agreement::Compared(..) => compared = true,
            Agreement::OneSided(difference) => one_sided = one_sided.or(Some(difference)),
            Agreement::Nowhere => {}
        }
    }
    match one_sided {
        Some(difference) if !compared => Err(difference),
        _ => Ok(()),
    }
}

/// Compares Φ, the components of F and the law's own invariants at one place.
///
/// ```text
/// |written − derived| ≤ 64 (ε + noise)
/// ```
///
/// ε is the error bound of the derived formula by running error analysis ([`Tracked`](super::Tracked)), with every number that goes in
/// off by a rounding: that knows what cancels in it, and how steep it is. Normal forms may have lost a cancellation that the method still
/// has, as of (1 + q) − 1; it shows as noise of the method between places that are side by side, and is looked for only where the first
/// bound does not do.
pub fn agreement<const D: usize>(law: &dyn Written<D>, place: &Probe<D>) -> Agreement {
    let (own, derived) = (own(law, place), All::of(law.derived(place)));
    let names = law.names();
    let mut tracked = None;
    let (mut worst, mut one_sided, mut compared) = (None::<(f64, usize)>, None, false);
    for i in 0..=D + names.len().min(MAX_OWN) {
        let (written, value) = (own.get(i), derived.get(i));
        match (written.is_finite(), value.is_finite()) {
            (true, true) => compared = true,
            (false, false) => continue,
            _ => {
                one_sided = one_sided.or(Some(i));
                continue;
            }
        }
        let difference = (written - value).abs();
        if difference <= MARGIN * ROUNDING * written.abs().min(value.abs()) {
            continue;
        }
        let tracked = tracked.get_or_insert_with(|| All::of(law.tracked(place)));
        let error = tracked.get(i).error();
        let mut bound = MARGIN * ROUNDING * error;
        if difference > bound {
            bound += MARGIN * noise(law, place, i);
        }
        let ratio = difference / bound;
        // Where the bound is no number, rounding may do anything.
        if worst.is_none_or(|(worst, _)| ratio > worst) && !ratio.is_nan() {
            worst = Some((ratio, i));
        }
    }
    let here = |i: usize| Disagreement {
        quantity: match i.checked_sub(D + 1) {
            Some(k) => names[k],
            None if i == 0 => "potential",
            None => "force",
        },
        written: own.get(i),
        panics: own.panics[usize::from(i > D)],
        derived: derived.get(i),
        time: place.t,
        place: core::array::from_fn(|k| place.q.get(k).copied().unwrap_or_default()),
        dimension: D as u32,
        culprit: Culprit::Alone,
    };
    match (worst, one_sided) {
        (Some((ratio, i)), _) if ratio > 1.0 => Agreement::Compared(ratio, here(i)),
        (_, Some(i)) => Agreement::OneSided(here(i)),
        (Some((ratio, i)), None) => Agreement::Compared(ratio, here(i)),
        (None, None) if compared => Agreement::Compared(0.0, here(0)),
        (None, None) => Agreement::Nowhere,
    }
}

/// What the author's method gives. One that panics, as `clamp` does between ends in the wrong order, gives no number.
fn own<const D: usize>(law: &dyn Written<D>, place: &Probe<D>) -> All<D> {
    let acting = catch_unwind(AssertUnwindSafe(|| law.own(place)));
    let kept = catch_unwind(AssertUnwindSafe(|| law.own_invariants(place)));
    let panics = [acting.is_err(), kept.is_err()];
    let acting = acting.unwrap_or(Values { potential: f64::NAN, force: [f64::NAN; D] });
    All { acting, kept: kept.unwrap_or([f64::NAN; MAX_OWN]), panics }
}

/// What a law gives, and what it says it keeps.
struct All<const D: usize, R = f64> {
    acting: Values<D, R>,
    kept: OwnValues<R>,
    /// Whether a method panics of those that act, and of the invariants.
    panics: [bool; 2],
}

impl<const D: usize, R: Copy> All<D, R> {
    fn of((acting, kept): (Values<D, R>, OwnValues<R>)) -> Self {
        All { acting, kept, panics: [false; 2] }
    }

    /// Φ, F₁, F₂, …, the invariants.
    fn get(&self, i: usize) -> R {
        match i {
            0 => self.acting.potential,
            _ if i <= D => self.acting.force[i - 1],
            _ => self.kept[i - D - 1],
        }
    }
}

/// The noise of the author's method: sixth differences of seven places in a row, over √(12!)/6! of which they have as much
/// more. What is smooth has next to none at such distances, of 2⁻¹² to 2⁻³⁶ of the size of the position. A method that is off
/// by more than that, as (1 + q) − 1 at q = 10⁻¹⁵, has lost all its digits, and shows none.
///
/// # Reference
/// J. J. Moré and S. M. Wild, "Estimating computational noise", SIAM J. Sci. Comput. 33 (2011) 1292–1314.
fn noise<const D: usize>(law: &dyn Written<D>, place: &Probe<D>, i: usize) -> f64 {
    const BINOMIALS: [f64; 7] = [1.0, -6.0, 15.0, -20.0, 15.0, -6.0, 1.0];
    const GROWTH: f64 = 30.397_368_307_141_33;
    let at = |n: usize| {
        // Where one distance is in step with the roundings another is not. Nor do they lie evenly about the place, where
        // roundings to both sides could be opposite.
        let distance = f64::exp2(-(n as f64)) * (1.0 + fraction(n));
        let row = BINOMIALS.iter().enumerate().map(|(k, binomial)| {
            let place = place.moved(distance * (k as f64 - 2.4), |i| 0.5 + fraction(i));
            binomial * own(law, &place).get(i)
        });
        (row.sum::<f64>() / GROWTH).abs()
    };
    (12..36).map(at).filter(|noise| noise.is_finite()).fold(0.0, f64::max)
}

/// Numbers in [0, 1) that have nothing to do with each other.
fn fraction(i: usize) -> f64 {
    ((i + 7) * 389 % 1009) as f64 / 1009.0
}

impl<const D: usize> Probe<D> {
    /// The k-th place around this one, off by up to a quarter of the sizes here.
    fn displaced(&self, k: usize) -> Self {
        self.moved(0.5, |i| fraction(i + 37 * k) - 0.47)
    }

    /// Every number moved by a part of the largest of its kind, or of 1 where all are 0, times a weight of its own.
    fn moved(&self, part: f64, weight: impl Fn(usize) -> f64) -> Self {
        let mut place = *self;
        let Probe { q, v: [va, vb], m: [ma, mb], t } = &mut place;
        let mut count = 0;
        for numbers in
            [q.as_mut_slice(), va, vb, core::slice::from_mut(ma), core::slice::from_mut(mb), core::slice::from_mut(t)]
        {
            let largest = numbers.iter().fold(0.0, |size: f64, x| size.max(x.abs()));
            let size = if largest > 0.0 { largest } else { 1.0 };
            for x in numbers {
                *x += part * size * weight(count);
                count += 1;
            }
        }
        place
    }
}
