//! Sweeps over eight stages to rounding.

use dmech_scalar::{Count, Mask, Real};

use super::ended::{Ended, Which};
use crate::newton::{Counts, NotConverged};
use crate::system::Tableau;
use crate::system::{Staged, stages};

/// A change of the pushes that is this many times too large may be left by rounding.
const ROUNDING: f64 = 3e4;
/// Sweeps that may fail to come nearer, and sweeps of one step.
const STALLS: f64 = 3.0;
const SWEEPS: u32 = 60;

/// What moves, and by which coefficients.
pub(super) type With<'a, Y> = (&'a Y, &'a Tableau);

/// Sweeps that came no nearer: the last change of a push.
pub(super) struct Stalled(pub(super) f64);

/// Where steps are made, and what they have cost.
pub struct Sweeps<Y: Staged> {
    pub(super) aim: Y::Aim,
    /// Somebody asks how the steps went.
    pub(super) watched: bool,
    /// Sweeps of this step.
    pub(super) made: u32,
    /// Evaluations by each of several side by side.
    pub(super) of_each: Counts<Y::Scalar>,
}

impl<Y: Staged> Sweeps<Y> {
    pub(super) fn new(system: &Y) -> Self {
        Sweeps { aim: system.aims(), watched: false, made: 0, of_each: Count::of(0) }
    }

    pub(super) fn gave_up(&self, residual: f64) -> NotConverged {
        NotConverged { iterations: self.made.into(), residual }
    }
}

impl<Y: Staged> Clone for Sweeps<Y> {
    fn clone(&self) -> Self {
        Sweeps { aim: self.aim.clone(), ..*self }
    }
}

impl<Y: Staged> core::fmt::Debug for Sweeps<Y> {
    fn fmt(&self, f: &mut core::fmt::Formatter<'_>) -> core::fmt::Result {
        f.debug_struct("Sweeps").field("aim", &self.aim).field("watched", &self.watched).finish()
    }
}

#[inline(always)]
pub(super) fn finite<Y: Staged>(pushes: &Y::Pushes) -> Which<Y> {
    stages::are_finite::<Y::Scalar>(Y::eights(pushes))
}

/// A step from the pushes of the last, `ratio` times as long, or from a guess if that is 0; where its sweeps end, position and
/// velocity are moved. Whether the force was seen to bend in it.
#[inline(always)]
pub(super) fn whole<Y: Staged>(
    (system, tableau): With<'_, Y>,
    stride: &Y::Stride,
    (t, ratio): (Y::Scalar, Y::Scalar),
    [q, v]: [&mut Y::Sum; 2],
    pushes: &mut Y::Pushes,
    sweeps: &mut Sweeps<Y>,
) -> Result<Which<Y>, Stalled> {
    stages::go_on(Y::eights_mut(pushes), tableau, ratio);
    let guessed = ratio.equal(Y::Scalar::ZERO);
    sweeps.of_each = Count::of(0);
    if Y::eights(pushes).len() > 1 && guessed.any() {
        from_guess((system, tableau), stride, t, [&*q, &*v], guessed, pushes, sweeps);
    }
    system.aim(tableau, stride, t, q, v, pushes, &mut sweeps.aim);
    until_rounding(system, tableau, stride, pushes, sweeps)?;
    Y::settle_pushes(tableau, stride, pushes, [q, v]);
    let looks = Y::PIECEWISE || sweeps.watched;
    Ok(if looks {
        stages::bends::<Y::Scalar>(tableau, Y::eights(pushes), Y::coordinates(Y::value(q)))
    } else {
        Mask::of(false)
    })
}

/// The same with copies of which nobody else knows, so that they stay in registers.
#[inline(always)]
pub(super) fn whole_in_registers<Y: Staged>(
    with: With<'_, Y>,
    stride: &Y::Stride,
    at: (Y::Scalar, Y::Scalar),
    [q, v]: [&mut Y::Sum; 2],
    pushes: &mut Y::Pushes,
    sweeps: &mut Sweeps<Y>,
) -> Result<Which<Y>, Stalled> {
    let (mut place, mut speed, mut near) = (q.clone(), v.clone(), pushes.clone());
    let mut here = Sweeps { watched: sweeps.watched, ..Sweeps::new(with.0) };
    let bent = whole(with, stride, at, [&mut place, &mut speed], &mut near, &mut here);
    (*q, *v, *pushes) = (place, speed, near);
    (sweeps.made, sweeps.of_each) = (here.made, here.of_each);
    bent
}

/// Sweeps two by two, from a guess that tells little of how coordinates will move: one at rest on which nothing acts may be moved by
/// another, and what changes in one sweep and what changes in the next are then not the same. Until two together come no nearer.
#[cold]
#[inline(never)]
fn from_guess<Y: Staged>(
    (system, tableau): With<'_, Y>,
    stride: &Y::Stride,
    t: Y::Scalar,
    [q, v]: [&Y::Sum; 2],
    guessed: Which<Y>,
    pushes: &mut Y::Pushes,
    Sweeps { aim, made, of_each, .. }: &mut Sweeps<Y>,
) {
    let (mut ended, mut last) = (Ended::<Y>::none(), Y::Scalar::from_f64(f64::INFINITY));
    ended.add(guessed.not(), pushes, 0);
    for pair in 1..=SWEEPS / 2 {
        system.aim(tableau, stride, t, q, v, pushes, aim);
        system.sweep(tableau, stride, aim, pushes);
        let change = Y::nearing(aim).change();
        system.sweep(tableau, stride, aim, pushes);
        let change = change.max(Y::nearing(aim).change());
        *made += 2;
        let counts = Y::Scalar::ONE.less(change).and(change.less(last)).and(Mask::of(pair < SWEEPS / 2));
        last = change;
        if ended.add(ended.or(counts).not(), pushes, 2 * pair) {
            break;
        }
    }
    *of_each = ended.evaluations;
}

#[inline(always)]
fn until_rounding<Y: Staged>(
    system: &Y,
    tableau: &Tableau,
    stride: &Y::Stride,
    pushes: &mut Y::Pushes,
    Sweeps { aim, made, of_each, .. }: &mut Sweeps<Y>,
) -> Result<(), Stalled> {
    let (mut ended, mut stalls) = (Ended::<Y>::none(), Y::Scalar::ZERO);
    for sweep in 1..=SWEEPS {
        *made += 1;
        let goes_on = ended.or(system.sweep(tableau, stride, aim, pushes));
        if goes_on.all() {
            continue;
        }
        let finite = finite::<Y>(pushes);
        if !goes_on.or(finite).all() {
            return Err(Stalled(f64::NAN));
        }
        let near = goes_on.or(Y::nearing(aim).is_near(Y::eights(pushes), ROUNDING));
        if ended.add(near.and(goes_on.not()), pushes, sweep) {
            *of_each += ended.evaluations;
            return Ok(());
        }
        stalls += Y::Scalar::either(near, Y::Scalar::ZERO, Y::Scalar::ONE);
        if stalls.equal(Y::Scalar::from_f64(STALLS)).any() {
            return Err(Stalled(Y::nearing(aim).change().to_f64()));
        }
    }
    // Where nothing tells what counts, rounding itself may go to and fro.
    let near = finite::<Y>(pushes).and(Y::nearing(aim).is_near(Y::eights(pushes), ROUNDING));
    if near.all() && !Ended::<Y>::MANY { Ok(()) } else { Err(Stalled(Y::nearing(aim).change().to_f64())) }
}

/// A step that is made now and then: one copy of it for all that make such.
#[cold]
#[inline(never)]
pub(super) fn apart<Y: Staged>(
    with: With<'_, Y>,
    stride: &Y::Stride,
    at: (Y::Scalar, Y::Scalar),
    place: [&mut Y::Sum; 2],
    pushes: &mut Y::Pushes,
    sweeps: &mut Sweeps<Y>,
) -> Result<Which<Y>, Stalled> {
    whole(with, stride, at, place, pushes, sweeps)
}
