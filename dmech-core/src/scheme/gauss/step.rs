//! A step of eight stages: sweeps to rounding.

use dmech_scalar::{Count, Mask, Real};

use super::ended::{Ended, Which};
use super::tableau::Tableau;
use super::{Gauss, LineIntegral};
use crate::invariant::{Invariant, Kept};
use crate::newton::{Counts, NotConverged};
use crate::scheme::by_lane::by_lane;
use crate::scheme::memory::{memory, q_and_v};
use crate::scheme::{Effort, Method, Reached, Scheme};
use crate::system::stages;
use crate::system::{Beginning, Staged};

memory! {
    /// What [`Gauss`] and [`LineIntegral`] carry.
    pub struct GaussMemory<Y: Staged with Pushes, Scalar> {
        /// Position.
        pub q: Y::Sum,
        /// Velocity.
        pub v: Y::Sum,
        /// Pushes of the last step, from which those of the next are guessed.
        pub pushes: Y::Pushes,
        /// The next step in units of the last; 0 where the pushes are a guess already.
        ratio: Y::Scalar,
        /// Steps that were no smooth motion, or too long: see [`Report::rough`](crate::Report::rough).
        rough: Y::Scalar,
    }
    lists {}
    uncarried {
        /// The length of the last step.
        dt: Y::Scalar,
        /// The work of a step that was made in parts.
        in_parts: Option<Y::Scalar>,
    }
}

by_lane! { GaussMemory of Staged with Pushes { q, v, pushes, ratio, rough, dt } afresh { in_parts }; }

/// A change of the pushes that is this many times too large may be left by rounding.
const ROUNDING: f64 = 3e4;
/// Sweeps that may fail to come nearer, and sweeps of one step.
const STALLS: f64 = 3.0;
const SWEEPS: u32 = 60;
/// How often a step is halved where its sweeps do not come nearer.
const HALVINGS: u32 = 6;

/// Bytes of pushes that stay in registers through a step, those of one coordinate. Of more, copies would be made in memory: steps of two
/// coordinates took 3 % more time, of three and of six 10 %; in place those of one take 2 to 24 %.
const FEW: usize = 64;

/// A method with eight stages.
pub(crate) trait Stages: Method {
    /// Its coefficients.
    const TABLEAU: &'static Tableau;
}

/// Sweeps that came no nearer: the last change of a push.
struct Astray(f64);

/// Where steps are made, and what they have cost.
pub struct Sweeps<Y: Staged> {
    aim: Y::Aim,
    /// Somebody asks how the steps went.
    watched: bool,
    /// Sweeps of this step.
    made: u32,
    /// Evaluations by each of several side by side.
    of_each: Counts<Y::Scalar>,
}

impl<Y: Staged> Sweeps<Y> {
    fn new(system: &Y) -> Self {
        Sweeps { aim: system.aims(), watched: false, made: 0, of_each: Count::of(0) }
    }

    fn gave_up(&self, residual: f64) -> NotConverged {
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
fn finite<Y: Staged>(pushes: &Y::Pushes) -> Which<Y> {
    stages::are_finite::<Y::Scalar>(Y::eights(pushes))
}

/// A step from the pushes of the last, `ratio` times as long, or from a guess if that is 0; where its sweeps end, position and
/// velocity are moved. Whether the force was seen to bend in it.
#[inline(always)]
fn whole<Y: Staged>(
    (system, tableau): (&Y, &Tableau),
    stride: &Y::Stride,
    (t, ratio): (Y::Scalar, Y::Scalar),
    [q, v]: [&mut Y::Sum; 2],
    pushes: &mut Y::Pushes,
    sweeps: &mut Sweeps<Y>,
) -> Result<Which<Y>, Astray> {
    stages::go_on(Y::eights_mut(pushes), tableau, ratio);
    system.aim(tableau, stride, t, q, v, pushes, &mut sweeps.aim);
    until_rounding(system, tableau, stride, pushes, sweeps)?;
    Y::settle_pushes(tableau, stride, pushes, [q, v]);
    let looks = Y::PIECEWISE || sweeps.watched;
    Ok(if looks { stages::bends::<Y::Scalar>(tableau, Y::eights(pushes)) } else { stages::nowhere::<Y::Scalar>() })
}

/// The same with copies of which nobody else knows, so that they stay in registers.
#[inline(always)]
fn whole_in_registers<Y: Staged>(
    with: (&Y, &Tableau),
    stride: &Y::Stride,
    at: (Y::Scalar, Y::Scalar),
    [q, v]: [&mut Y::Sum; 2],
    pushes: &mut Y::Pushes,
    sweeps: &mut Sweeps<Y>,
) -> Result<Which<Y>, Astray> {
    let (mut place, mut speed, mut near) = (q.clone(), v.clone(), pushes.clone());
    let mut here = Sweeps { watched: sweeps.watched, ..Sweeps::new(with.0) };
    let bent = whole(with, stride, at, [&mut place, &mut speed], &mut near, &mut here);
    (*q, *v, *pushes) = (place, speed, near);
    (sweeps.made, sweeps.of_each) = (here.made, here.of_each);
    bent
}

#[inline(always)]
fn until_rounding<Y: Staged>(
    system: &Y,
    tableau: &Tableau,
    stride: &Y::Stride,
    pushes: &mut Y::Pushes,
    Sweeps { aim, made, of_each, .. }: &mut Sweeps<Y>,
) -> Result<(), Astray> {
    let (mut ended, mut stalls) = (Ended::<Y>::none(), Y::Scalar::ZERO);
    for _ in 0..SWEEPS {
        *made += 1;
        let goes_on = ended.or(system.sweep(tableau, stride, aim, pushes));
        if goes_on.all() {
            continue;
        }
        let finite = finite::<Y>(pushes);
        if !goes_on.or(finite).all() {
            return Err(Astray(f64::NAN));
        }
        let near = goes_on.or(Y::nearing(aim).is_near(Y::eights(pushes), ROUNDING));
        if ended.add(near.and(goes_on.not()), pushes, *made) {
            *of_each = ended.evaluations;
            return Ok(());
        }
        stalls += Y::Scalar::either(near, Y::Scalar::ZERO, Y::Scalar::ONE);
        if stalls.equal(Y::Scalar::from_f64(STALLS)).any() {
            return Err(Astray(Y::nearing(aim).change()));
        }
    }
    // Where nothing tells what counts, rounding itself may go to and fro.
    let near = finite::<Y>(pushes).and(Y::nearing(aim).is_near(Y::eights(pushes), ROUNDING));
    if near.all() && !Ended::<Y>::MANY { Ok(()) } else { Err(Astray(Y::nearing(aim).change())) }
}

/// A step that is made now and then: one copy of it for all that make such.
#[cold]
#[inline(never)]
fn apart<Y: Staged>(
    with: (&Y, &Tableau),
    stride: &Y::Stride,
    at: (Y::Scalar, Y::Scalar),
    place: [&mut Y::Sum; 2],
    pushes: &mut Y::Pushes,
    sweeps: &mut Sweeps<Y>,
) -> Result<Which<Y>, Astray> {
    whole(with, stride, at, place, pushes, sweeps)
}

/// A step in two halves, of which each may be halved again. Returns the work done; the pushes become those of a force that stays
/// as it is.
#[cold]
fn in_parts<Y: Staged>(
    with @ (system, tableau): (&Y, &Tableau),
    stride: &Y::Stride,
    t: Y::Scalar,
    [q, v]: [&mut Y::Sum; 2],
    pushes: &mut Y::Pushes,
    sweeps: &mut Sweeps<Y>,
    halvings: u32,
) -> Result<Y::Scalar, Astray> {
    let half = system.stage(stride, Y::Scalar::from_f64(0.5), 0.0);
    let (mut slope, mut work) = (system.zero(), Y::Scalar::ZERO);
    for t in [t, t + Y::dt(&half)] {
        system.slope(t, Y::value(q), Y::value(v), &mut slope);
        *pushes = system.pushes(&half, &slope);
        let before = Y::value(v).clone();
        if let Err(astray) = apart(with, &half, (t, Y::Scalar::ZERO), [&mut *q, &mut *v], pushes, sweeps) {
            if halvings < HALVINGS {
                work += in_parts(with, &half, t, [&mut *q, &mut *v], pushes, sweeps, halvings + 1)?;
                continue;
            }
            // Where a force jumps between two sides there may be no solution: the last guess is as good as any.
            if !(Y::PIECEWISE && finite::<Y>(pushes).all()) {
                return Err(astray);
            }
            Y::settle_pushes(tableau, &half, pushes, [&mut *q, &mut *v]);
        }
        work += system.work_of_pushes(tableau, Y::dt(&half), &before, pushes);
    }
    system.slope(t + Y::dt(stride), Y::value(q), Y::value(v), &mut slope);
    *pushes = system.pushes(stride, &slope);
    Ok(work)
}

macro_rules! stepped_by_stages {
    ($($scheme:ty, <$(const $s:ident: usize)?>;)*) => {$(
        impl<$(const $s: usize,)? Y: Staged> Scheme<Y> for $scheme {
            const SEES_ROUGH: bool = true;

            type Memory = GaussMemory<Y>;
            type Workspace = Sweeps<Y>;

            fn workspace(&self, system: &Y, _: &Y::Stride) -> Sweeps<Y> {
                Sweeps::new(system)
            }

            #[inline(always)]
            fn watch(&self, watched: bool, sweeps: &mut Sweeps<Y>) {
                sweeps.watched = watched;
            }

            fn begin(
                &self,
                system: &Y,
                stride: &Y::Stride,
                start: &Beginning<'_, Y>,
                _: &mut Sweeps<Y>,
            ) -> Result<Self::Memory, NotConverged> {
                let (q, v, pushes) = (Y::sum(start.q), Y::sum(start.v), system.pushes(stride, start.slope));
                let none = Y::Scalar::ZERO;
                Ok(GaussMemory { q, v, pushes, ratio: none, rough: none, dt: Y::dt(stride), in_parts: None })
            }

            #[inline(always)]
            fn step(
                &self,
                system: &Y,
                stride: &Y::Stride,
                t: Y::Scalar,
                memory: &mut Self::Memory,
                sweeps: &mut Sweeps<Y>,
            ) -> Result<Effort<Y::Scalar>, NotConverged> {
                let GaussMemory { q, v, pushes, ratio, rough, dt, in_parts: parts } = memory;
                let (with, at) = ((system, Self::TABLEAU), (t, *ratio));
                let (zero, one) = (Y::Scalar::ZERO, Y::Scalar::ONE);
                (*ratio, *dt, *parts, sweeps.made) = (one, Y::dt(stride), None, 0);
                let made = if Y::IN_REGISTERS && size_of::<Y::Pushes>() <= FEW && !Ended::<Y>::MANY {
                    whole_in_registers(with, stride, at, [q, v], pushes, sweeps)
                } else {
                    whole(with, stride, at, [q, v], pushes, sweeps)
                };
                match made {
                    Ok(bent) => {
                        if bent.any() {
                            *rough += Y::Scalar::either(bent, one, zero);
                        }
                    }
                    Err(Astray(residual)) if Ended::<Y>::MANY => {
                        return Err(sweeps.gave_up(residual));
                    }
                    Err(_) => {
                        (*ratio, *rough) = (zero, *rough + one);
                        let made = in_parts(with, stride, t, [q, v], pushes, sweeps, 1);
                        *parts = Some(made.map_err(|Astray(residual)| sweeps.gave_up(residual))?);
                    }
                }
                let evaluations = if Ended::<Y>::MANY { sweeps.of_each } else { Count::of(8 * sweeps.made) };
                Ok(Effort { evaluations, iterations: Count::of(0) })
            }

            /// As the first step from there.
            fn within(
                &self,
                system: &Y,
                dt: Y::Scalar,
                from: &Beginning<'_, Y>,
            ) -> Result<Reached<Y>, NotConverged> {
                let (with, t, mut sweeps) = ((system, Self::TABLEAU), from.t, Sweeps::new(system));
                let stride = system.stride(dt, <Self as Scheme<Y>>::SHARE);
                let GaussMemory { mut q, mut v, mut pushes, ratio, .. } =
                    self.begin(system, &stride, from, &mut sweeps)?;
                let made = apart(with, &stride, (t, ratio), [&mut q, &mut v], &mut pushes, &mut sweeps);
                if made.is_err() {
                    let made = in_parts(with, &stride, t, [&mut q, &mut v], &mut pushes, &mut sweeps, 1);
                    made.map_err(|Astray(residual)| sweeps.gave_up(residual))?;
                }
                let effort = Effort { evaluations: Count::of(8 * sweeps.made), iterations: Count::of(0) };
                Ok(([Y::value(&q).clone(), Y::value(&v).clone()], effort))
            }

            #[inline(always)]
            fn stretch(
                &self,
                _: &Y,
                _: &Y::Stride,
                _: Y::Scalar,
                ratio: Y::Scalar,
                memory: &mut Self::Memory,
                _: &mut Sweeps<Y>,
            ) -> u32 {
                memory.ratio *= ratio;
                0
            }

            q_and_v! { Y::value }

            /// Σ bᵢ h F(Qᵢ)·Ṽᵢ.
            fn work(&self, system: &Y, _: &Y::Stride, before: &Self::Memory, after: &Self::Memory) -> Y::Scalar {
                let whole = || {
                    system.work_of_pushes(Self::TABLEAU, after.dt, Y::value(&before.v), &after.pushes)
                };
                after.in_parts.unwrap_or_else(whole)
            }

            fn rough(&self, memory: &Self::Memory) -> u64 {
                memory.rough.to_f64() as u64
            }

            fn kept(_: &Y, invariant: Invariant) -> Kept {
                Self::kept_by(Y::DEGREE, invariant)
            }
        }
    )*};
}

stepped_by_stages! {
    Gauss, <>;
    LineIntegral<S>, <const S: usize>;
}
