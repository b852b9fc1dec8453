//! What moves: coordinates side by side, what acts on them, and the instructions that a scheme is a program over.
//!
//! There are two systems: one law ([`Particle`]), whose vectors are arrays in registers, and the bodies of a scene
//! (`SceneSystem`), whose vectors are columns of numbers. A scheme cannot tell which it has.

mod implicit;
mod particle;
pub(crate) mod stages;
mod step;

use core::fmt::Debug;

pub use crate::look::{Course, EVALUATIONS, Frequency, Look, Stiffness};
pub use crate::newton::options::{Guess, Newton};
pub use implicit::ImplicitSteps;
pub use particle::{AtStages, Particle, ParticleFound, Stride};
#[cfg(feature = "scene")]
pub(crate) use particle::{PARTS, fall, not_converged};
pub(crate) use stages::tableau;
pub use stages::tableau::{Columns, Row, STAGES, Tableau};
pub use stages::{Eight, Nearing, Staged, Staging};
pub use step::{Ahead, Beginning, Effort, Kick, Step};

use dmech_scalar::Real;

use crate::error::Error;
use crate::invariant::Invariant;
use crate::newton::NotConverged;

/// A system of coordinates, and the instructions of schemes.
///
/// Slopes are ∇Φ − F: minus what acts. With M the masses, a kick in the time c moves the velocity by −c M⁻¹(∇Φ − F).
/// Instructions write where they are told to, so that a step of many bodies allocates nothing.
#[diagnostic::on_unimplemented(
    message = "`{Self}` is nothing that moves by itself",
    note = "what moves under a law `L` of D coordinates is `Particle<L, D>`, and its stepper `Stepper<Particle<L, D>, S>`; that of a scene is `SceneStepper<D, Laws, S>`"
)]
pub trait System: Sized {
    /// A number of the scalar in use.
    type Scalar: Real;
    /// A number for each coordinate: a position, a velocity, a slope.
    type Vector: Clone + Debug;
    /// The same with what rounding took from it so far.
    type Sum: Clone + Debug;
    /// Time, position and velocity, as they are recorded.
    type State: Clone + Debug;
    /// The length of a step, and h/m for each coordinate.
    type Stride: Clone + Debug;
    /// Work that is not yet summed over the coordinates.
    type Work: Clone + Debug;
    /// Where an explicit step works and nothing is carried on.
    type Room: Clone + Debug;

    /// Vectors are a few numbers in registers: a step works on a copy of what it changes.
    const IN_REGISTERS: bool;
    /// The number of coordinates of a body.
    const DIMENSION: usize;
    /// All that acts is a potential that is a polynomial of at most this degree in the coordinates:
    /// [`Potential::DEGREE`](crate::Potential::DEGREE). None where a force acts beside it.
    const DEGREE: Option<u32>;
    /// What acts may bend or jump: [`Potential::PIECEWISE`](crate::Potential::PIECEWISE).
    const PIECEWISE: bool;

    // The length of steps.

    /// Steps of length dt; in the equation of the step the unknown force has the coefficient `share` h²/m, 0 if there is none.
    fn stride(&self, dt: Self::Scalar, share: f64) -> Self::Stride;
    /// The same with another length.
    fn set_stride(&self, stride: &mut Self::Stride, dt: Self::Scalar, share: f64) {
        *stride = self.stride(dt, share);
    }
    /// Steps γ times as long, for the stages of a step; γ may be negative.
    fn stage(&self, stride: &Self::Stride, gamma: Self::Scalar, share: f64) -> Self::Stride;
    /// h.
    fn dt(stride: &Self::Stride) -> Self::Scalar;

    // States and vectors.

    /// Position and velocity of a state.
    fn vectors(&self, state: &Self::State) -> [Self::Vector; 2];
    /// The state of a time, a position and a velocity.
    fn state(&self, t: f64, q: &Self::Vector, v: &Self::Vector) -> Self::State;
    /// The time of a state.
    fn time(state: &Self::State) -> f64;
    /// The relative distance of times that the system tells apart: that of `f64`, and of a narrower scalar where the law names
    /// the time.
    #[inline(always)]
    fn resolution(&self) -> f64 {
        f64::EPSILON
    }
    /// The memory that a recorded state takes, in bytes.
    fn size(_state: &Self::State) -> usize {
        size_of::<Self::State>()
    }
    /// No vector.
    fn zero(&self) -> Self::Vector;
    /// The beginning of a compensated sum.
    fn sum(x: &Self::Vector) -> Self::Sum;
    /// Its value.
    fn value(x: &Self::Sum) -> &Self::Vector;
    /// x/2 + y/2: the sum of two finite numbers need not be finite.
    fn mean(x: &Self::Vector, y: &Self::Vector) -> Self::Vector;
    /// x *= c.
    fn scale(x: &mut Self::Vector, c: Self::Scalar);
    /// x += c y.
    fn add_scaled(x: &mut Self::Vector, c: Self::Scalar, y: &Self::Vector);
    /// out ← Σ wⱼ xⱼ.
    fn weigh(w: &[f64], x: &[Self::Vector], out: &mut Self::Vector);
    /// x ← 0 for bodies that count in no energy.
    #[inline(always)]
    fn leave_uncounted(&self, _x: &mut Self::Vector) {}
    /// Every component is finite.
    fn is_finite(x: &Self::Vector) -> bool;

    // What acts.

    /// Room for explicit steps.
    fn room(&self) -> Self::Room;
    /// Whether kicks in it must add up their work.
    #[inline(always)]
    fn watch(_watched: bool, _room: &mut Self::Room) {}
    /// Φ(q).
    fn potential(&self, t: Self::Scalar, q: &Self::Vector) -> Self::Scalar;
    /// Σ m v²/2.
    fn kinetic_energy(&self, v: &Self::Vector) -> Self::Scalar;
    /// Σ m v²/2 + Φ(q) of a state.
    fn energy(&self, state: &Self::State) -> Self::Scalar {
        let [q, v] = self.vectors(state);
        self.potential(Self::Scalar::from_f64(Self::time(state)), &q) + self.kinetic_energy(&v)
    }
    /// out ← ∇Φ − F.
    fn slope(&self, t: Self::Scalar, q: &Self::Vector, v: &Self::Vector, out: &mut Self::Vector);

    // Drifts and kicks.

    /// q += a v, in the time a.
    fn drift(q: &mut Self::Vector, a: Self::Scalar, v: &Self::Vector) {
        Self::add_scaled(q, a, v);
    }
    /// q += h (v + v′)/2.
    fn drift_by_mean(stride: &Self::Stride, q: &mut Self::Vector, v: &Self::Vector, next: &Self::Vector);
    /// to ← v − b (h/m) S + e (h³/m²) J S, at one position, with the whole slope S = ∇Φ − F and J = ∂S/∂q: the force may not depend on
    /// the velocity where e is not 0.
    fn kick(
        &self,
        room: &mut Self::Room,
        stride: &Self::Stride,
        kick: Kick<Self::Scalar>,
        q: &Self::Vector,
        v: &Self::Vector,
        to: &mut Self::Vector,
    );
    /// A kick and, with the new velocity, a drift in the time a, in one pass over the coordinates; the work of the kick is added,
    /// if it is [watched](System::watch).
    ///
    /// `BY_MEAN` is with the force at the mean velocity of the kick, to ← v − b (h/m)(∇Φ − F(q, (v + to)/2)): each body has one
    /// that is linear in its velocity. The kick has no force gradient then.
    #[expect(clippy::too_many_arguments, reason = "a whole stage in one pass")]
    fn kick_and_drift<const BY_MEAN: bool>(
        &self,
        room: &mut Self::Room,
        stride: &Self::Stride,
        kick: Kick<Self::Scalar>,
        a: Self::Scalar,
        q: &mut Self::Vector,
        v: &Self::Vector,
        to: &mut Self::Vector,
        work: &mut Self::Work,
    );
    /// The velocities half a kick before and half a kick after a state: `kick` is that half already, and is made backward and forward.
    fn kick_both_ways(
        &self,
        room: &mut Self::Room,
        stride: &Self::Stride,
        kick: Kick<Self::Scalar>,
        start: &Beginning<'_, Self>,
    ) -> [Self::Vector; 2];
    /// x += c y.
    fn add_to_sum(x: &mut Self::Sum, c: Self::Scalar, y: &Self::Vector);
    /// q += h v, with what both have in their low parts.
    fn drift_sum(stride: &Self::Stride, q: &mut Self::Sum, v: &Self::Sum);
    /// change ← −b (h/m)(∇Φ − F), and v += change.
    fn kick_sum(
        &self,
        stride: &Self::Stride,
        b: Self::Scalar,
        slope: &Self::Vector,
        v: &mut Self::Sum,
        change: &mut Self::Vector,
    );

    // Work.

    /// None.
    fn no_work(&self) -> Self::Work;
    /// Sets it to none.
    fn clear(work: &mut Self::Work);
    /// Adds that of a kick, F·(its time)(v + v′)/2 = Σ m (v′ − v)(v′ + v)/2.
    fn add_work(&self, work: &mut Self::Work, v: &Self::Vector, next: &Self::Vector);
    /// That of one kick.
    #[inline]
    fn work_of_kick(&self, v: &Self::Vector, next: &Self::Vector) -> Self::Scalar {
        let mut work = self.no_work();
        self.add_work(&mut work, v, next);
        self.total(&work)
    }
    /// Summed over the coordinates.
    fn total(&self, work: &Self::Work) -> Self::Scalar;
    /// −Σ (∇Φ − F)·Δq.
    fn work_along(&self, slope: &Self::Vector, moved: &Self::Vector) -> Self::Scalar;
    /// The same for Δq = after − before.
    fn work_between(&self, slope: &Self::Vector, before: &Self::Sum, after: &Self::Sum) -> Self::Scalar;
    /// The same for Δq = c (v + v′).
    fn work_at_speeds(
        &self,
        slope: &Self::Vector,
        c: Self::Scalar,
        v: &Self::Vector,
        next: &Self::Vector,
    ) -> Self::Scalar;

    // What a run asks.

    /// Refuses a state that is not one of this system, or not of numbers.
    ///
    /// # Errors
    /// [`Error::State`]; for scenes `Error::Scene`.
    fn check(&self, state: &Self::State) -> Result<(), Error>;
    /// Refuses a start from which nothing can be stepped; `slope` ← ∇Φ − F there.
    ///
    /// # Errors
    /// [`Error`] where what acts is not finite.
    fn prepare(&self, start: &Self::State, slope: &mut Self::Vector) -> Result<(), Error>;
    /// Refuses a potential that is not finite at the start, if that was not done before: runs watch it.
    ///
    /// # Errors
    /// [`Error`] says where.
    fn check_potential(&self, _start: &Self::State) -> Result<(), Error> {
        Ok(())
    }
    /// Whether what is moved along given paths has a finite place and velocity at t.
    #[inline(always)]
    fn is_placed(&self, _t: f64) -> bool {
        true
    }
    /// Why a step of length dt from time t, backward if that is negative, has no solution.
    fn unsolved(&self, step: u64, from: [&Self::Vector; 2], t: f64, dt: f64, cause: NotConverged) -> Error;
    /// Why a step led to what is not finite.
    fn not_finite(&self, step: u64, _to: [&Self::Vector; 2], t: f64, dt: f64) -> Error {
        Error::NotFinite { step, time: t, dt }
    }
    /// Whether the system keeps an invariant at all.
    fn conserves(&self, invariant: Invariant) -> bool;
    /// The names of the invariants that the law itself declares.
    fn own_invariants(&self) -> &'static [&'static str] {
        &[]
    }
    /// The value of the k-th of them.
    fn own_invariant(&self, _k: usize, _state: &Self::State) -> Self::Scalar {
        Self::Scalar::ZERO
    }
    /// A momentum of a state, and how far it is from that of the start.
    fn momentum(&self, invariant: Invariant, state: &Self::State, start: &Self::State) -> (Self::Scalar, Self::Scalar);
}

/// A system that tells how fast it moves, for steps that follow the motion.
#[diagnostic::on_unimplemented(
    message = "`{Self}` does not tell how fast it moves: adaptive steps and studies are of motions in `f64`",
    label = "this motion is in another scalar than `f64`",
    note = "start it from a `State` of `f64`, `State::new([0.5], [0.0])`, or give the step with `.dt(h)` in place of `.adaptive(tolerance)`"
)]
pub trait TimeScale: System<Scalar = f64> {
    /// Whether a law names the time, or a body moves along a path of it: what the motion meets later no look tells.
    fn names_the_time(&self) -> bool;

    /// The angular frequency of the linearised motion, and how it grows; `least` is the smallest that counts.
    fn look(&self, room: &mut Self::Room, t: f64, q: &Self::Vector, v: &Self::Vector, least: f64) -> Look;
}

/// No force of the system depends on the velocity, so that positions and velocities may stand half a step apart
/// (Greenspan §3, last sentence): the law of it, or every term of a scene, is
/// [`VelocityIndependent`](crate::VelocityIndependent).
pub trait WithoutVelocities {}

/// The force on each body of the system is linear in its own velocity, so that a kick by the mean velocity has a closed
/// form: the law of it, or every term of a scene, is [`LinearInVelocity`](crate::extend::LinearInVelocity).
pub trait LinearVelocities {}
