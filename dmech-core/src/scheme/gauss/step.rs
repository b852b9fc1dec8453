//! A step of eight stages: sweeps to rounding.

use dmech_scalar::Real;

use super::tableau::Tableau;
use super::{Gauss, LineIntegral};
use crate::invariant::{Invariant, Kept};
use crate::newton::NotConverged;
use crate::scheme::memory::memory;
use crate::scheme::{Effort, Method, Scheme};
use crate::system::{Beginning, Staged};

memory! {
    /// What [`Gauss`] and [`LineIntegral`] carry.
    pub struct GaussMemory<Y: Staged with Pushes> {
        /// Position.
        pub q: Y::Sum,
        /// Velocity.
        pub v: Y::Sum,
        /// Pushes of the last step, from which those of the next are guessed.
        pub pushes: Y::Pushes,
        /// The next step in units of the last; 0 where the pushes are a guess already.
        ratio: f64,
        /// Steps that were no smooth motion, or too long: see [`Report::rough`](crate::Report::rough).
        rough: f64,
    }
    lists {}
    uncarried {
        /// The length of the last step.
        dt: Y::Scalar,
        /// The work of a step that was made in parts.
        in_parts: Option<Y::Scalar>,
    }
}

/// A change of the pushes that is this many times too large may be left by rounding.
const ROUNDING: f64 = 1e3;
/// Sweeps that may fail to come nearer, and sweeps of one step.
const STALLS: u32 = 3;
const SWEEPS: u32 = 60;
/// How often a step is halved where its sweeps do not come nearer.
const HALVINGS: u32 = 8;

/// A method with eight stages.
pub(crate) trait Stages: Method {
    /// Its coefficients.
    const TABLEAU: &'static Tableau;
}

/// What a step costs in sweeps of eight evaluations, or how it did not end.
type Swept = Result<u32, Astray>;

/// Sweeps that came no nearer.
struct Astray {
    sweeps: u32,
    change: f64,
}

/// From the guess in `pushes` to the pushes of a step.
#[inline(always)]
fn sweeps<Y: Staged>(
    system: &Y,
    tableau: &Tableau,
    stride: &Y::Stride,
    aim: &mut Y::Aim,
    pushes: &mut Y::Pushes,
) -> Swept {
    let mut stalls = 0;
    for sweep in 1..=SWEEPS {
        if system.sweep(tableau, stride, aim, pushes) {
            continue;
        }
        if !Y::are_finite(pushes) {
            return Err(Astray { sweeps: sweep, change: f64::NAN });
        }
        let change = Y::change(aim, pushes);
        if change < ROUNDING {
            return Ok(sweep);
        }
        stalls += 1;
        if stalls == STALLS {
            return Err(Astray { sweeps: sweep, change });
        }
    }
    Err(Astray { sweeps: SWEEPS, change: Y::change(aim, pushes) })
}

/// A step in two halves, of which each may be halved again: position and velocity at its end, its work and its sweeps. The
/// pushes become those of a force that stays as it is.
#[cold]
fn in_parts<Y: Staged>(
    system: &Y,
    tableau: &Tableau,
    stride: &Y::Stride,
    t: Y::Scalar,
    [q, v]: [&mut Y::Sum; 2],
    pushes: &mut Y::Pushes,
    halvings: u32,
) -> Result<(Y::Scalar, u32), Astray> {
    let half = system.stage(stride, Y::Scalar::from_f64(0.5), 0.0);
    let (mut slope, mut aim) = (system.zero(), system.aims());
    let (mut work, mut all) = (Y::Scalar::ZERO, 0);
    for t in [t, t + Y::dt(&half)] {
        system.slope(t, Y::value(q), Y::value(v), &mut slope);
        *pushes = system.pushes(&half, &slope);
        system.aim(tableau, &half, t, q, v, pushes, &mut aim);
        match sweeps(system, tableau, &half, &mut aim, pushes) {
            // Where a force jumps between two sides there may be no solution: the last guess is as good as any.
            Err(last) if halvings == HALVINGS && !(Y::PIECEWISE && Y::are_finite(pushes)) => return Err(last),
            Err(Astray { sweeps, .. }) if halvings < HALVINGS => {
                let (done, more) = in_parts(system, tableau, &half, t, [q, v], pushes, halvings + 1)?;
                work += done;
                all += sweeps + more;
            }
            Ok(sweeps) | Err(Astray { sweeps, .. }) => {
                work += system.work_of_pushes(tableau, Y::dt(&half), Y::value(v), pushes);
                Y::settle_pushes(tableau, &half, pushes, [q, v]);
                all += sweeps;
            }
        }
    }
    system.slope(t + Y::dt(stride), Y::value(q), Y::value(v), &mut slope);
    *pushes = system.pushes(stride, &slope);
    Ok((work, all))
}

macro_rules! stepped_by_stages {
    ($($scheme:ty, <$(const $s:ident: usize)?>;)*) => {$(
        impl<$(const $s: usize,)? Y: Staged> Scheme<Y> for $scheme {
            type Memory = GaussMemory<Y>;
            type Workspace = Y::Aim;

            fn workspace(&self, system: &Y, _: &Y::Stride) -> Y::Aim {
                system.aims()
            }

            fn begin(
                &self,
                system: &Y,
                stride: &Y::Stride,
                start: &Beginning<'_, Y>,
                _: &mut Y::Aim,
            ) -> Result<Self::Memory, NotConverged> {
                let (q, v, pushes) = (Y::sum(start.q), Y::sum(start.v), system.pushes(stride, start.slope));
                Ok(GaussMemory { q, v, pushes, ratio: 0.0, rough: 0.0, dt: Y::dt(stride), in_parts: None })
            }

            #[inline(always)]
            fn step(
                &self,
                system: &Y,
                stride: &Y::Stride,
                t: Y::Scalar,
                memory: &mut Self::Memory,
                aim: &mut Y::Aim,
            ) -> Result<Effort, NotConverged> {
                let tableau = Self::TABLEAU;
                let GaussMemory { q, v, pushes, ratio, rough, dt, in_parts: parts } = memory;
                if *ratio != 0.0 {
                    Y::go_on(pushes, tableau, Y::Scalar::from_f64(*ratio));
                }
                (*ratio, *dt, *parts) = (1.0, Y::dt(stride), None);
                system.aim(tableau, stride, t, q, v, pushes, aim);
                let all = match sweeps(system, tableau, stride, aim, pushes) {
                    Ok(sweeps) => {
                        Y::settle_pushes(tableau, stride, pushes, [q, v]);
                        if Y::PIECEWISE && Y::bends(tableau, aim, pushes) {
                            *rough += 1.0;
                        }
                        sweeps
                    }
                    Err(Astray { sweeps, .. }) => {
                        *ratio = 0.0;
                        *rough += 1.0;
                        let not_converged = |Astray { sweeps: more, change }| NotConverged {
                            iterations: (sweeps + more).into(),
                            residual: change,
                        };
                        let made = in_parts(system, tableau, stride, t, [q, v], pushes, 1);
                        let (work, more) = made.map_err(not_converged)?;
                        *parts = Some(work);
                        sweeps + more
                    }
                };
                Ok(Effort { evaluations: 8 * all, iterations: 0 })
            }

            #[inline(always)]
            fn stretch(
                &self,
                _: &Y,
                _: &Y::Stride,
                _: Y::Scalar,
                ratio: Y::Scalar,
                memory: &mut Self::Memory,
                _: &mut Y::Aim,
            ) -> u32 {
                memory.ratio *= ratio.to_f64();
                0
            }

            #[inline]
            fn position<'m>(&self, memory: &'m Self::Memory) -> &'m Y::Vector {
                Y::value(&memory.q)
            }

            #[inline]
            fn velocity(&self, _: &Y, _: &Y::Stride, _: Y::Scalar, memory: &Self::Memory) -> Y::Vector {
                Y::value(&memory.v).clone()
            }

            #[inline]
            fn finite(&self, memory: &Self::Memory) -> bool {
                Y::is_finite(Y::value(&memory.q)) && Y::is_finite(Y::value(&memory.v))
            }

            fn kinetic_energy(&self, system: &Y, memory: &Self::Memory) -> Y::Scalar {
                system.kinetic_energy(Y::value(&memory.v))
            }

            /// Σ bᵢ h F(Qᵢ)·Ṽᵢ.
            fn work(&self, system: &Y, _: &Y::Stride, before: &Self::Memory, after: &Self::Memory) -> Y::Scalar {
                let whole = || {
                    system.work_of_pushes(Self::TABLEAU, after.dt, Y::value(&before.v), &after.pushes)
                };
                after.in_parts.unwrap_or_else(whole)
            }

            fn rough(&self, memory: &Self::Memory) -> u64 {
                memory.rough as u64
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
