//! A particle under one law: the instructions in registers.

mod equation;
mod fault;
mod momentum;
mod range;
mod solve;
mod stages;
mod start;
mod stride;
mod workless;

pub use equation::ParticleFound;
use fault::Attempt;
#[cfg(feature = "scene")]
pub(crate) use fault::{PARTS, not_converged};
pub use stages::AtStages;
pub use stride::Stride;
#[cfg(feature = "scene")]
pub(crate) use stride::fall;

use dmech_scalar::{CompensatedVector, Real};

use super::{Beginning, Course, Kick, LinearVelocities, Look, System, TimeScale, WithoutVelocities};
use crate::error::Error;
use crate::invariant::Invariant;
use crate::law::{Field, Law, LinearInVelocity, Potential, VelocityIndependent};
use crate::newton::NotConverged;
use crate::state::State;
use crate::vector::{add_scaled, difference, finite, scaled, sum, weighted};

/// A particle of one mass, or of a mass for each coordinate, under a law in D coordinates.
#[derive(Clone, Copy, Debug)]
pub struct Particle<L, const D: usize, R = f64> {
    law: L,
    mass: R,
}

impl<L: Law<D, R>, const D: usize, R: Real> Particle<L, D, R> {
    /// A particle under a law.
    pub fn new(law: L, mass: f64) -> Self {
        Particle { law, mass: R::from_f64(mass) }
    }

    /// The same with a mass of the scalar.
    pub(crate) fn with_mass(law: L, mass: R) -> Self {
        Particle { law, mass }
    }

    /// The law.
    pub fn law(&self) -> &L {
        &self.law
    }

    /// The mass.
    pub fn mass(&self) -> R {
        self.mass
    }

    /// What acts at a time.
    #[inline(always)]
    pub(crate) fn field(&self, t: R) -> L::Field<'_> {
        self.law.field(self.mass, t)
    }

    /// The law, to be changed.
    pub(crate) fn law_mut(&mut self) -> &mut L {
        &mut self.law
    }
}

impl<L: VelocityIndependent, const D: usize, R> WithoutVelocities for Particle<L, D, R> {}
impl<L: LinearInVelocity, const D: usize, R> LinearVelocities for Particle<L, D, R> {}

impl<L: Law<D, R>, const D: usize, R: Real> System for Particle<L, D, R> {
    type Scalar = R;
    type Vector = [R; D];
    type Sum = CompensatedVector<D, R>;
    type State = State<D, R>;
    type Stride = Stride<R>;
    type Work = R;
    type Room = ();

    const IN_REGISTERS: bool = true;
    const DIMENSION: usize = D;
    const DEGREE: Option<u32> = if L::Field::<'_>::FORCED { None } else { L::Field::<'_>::DEGREE };
    const PIECEWISE: bool = L::Field::<'_>::PIECEWISE;

    #[inline(always)]
    fn stride(&self, dt: R, _: f64) -> Stride<R> {
        Stride::new(dt, self.mass)
    }
    #[inline(always)]
    fn stage(&self, stride: &Stride<R>, gamma: R, _: f64) -> Stride<R> {
        stride.times(gamma)
    }
    #[inline(always)]
    fn dt(stride: &Stride<R>) -> R {
        stride.dt
    }

    #[inline(always)]
    fn vectors(&self, state: &State<D, R>) -> [[R; D]; 2] {
        [state.q, state.v]
    }
    #[inline(always)]
    fn state(&self, t: f64, q: &[R; D], v: &[R; D]) -> State<D, R> {
        State { t, q: *q, v: *v }
    }
    #[inline(always)]
    fn time(state: &State<D, R>) -> f64 {
        state.t
    }
    #[inline(always)]
    fn resolution(&self) -> f64 {
        if L::AUTONOMOUS { f64::EPSILON } else { R::EPSILON.to_f64().max(f64::EPSILON) }
    }
    #[inline(always)]
    fn zero(&self) -> [R; D] {
        [R::ZERO; D]
    }
    #[inline(always)]
    fn sum(x: &[R; D]) -> CompensatedVector<D, R> {
        CompensatedVector::new(*x)
    }
    #[inline(always)]
    fn value(x: &CompensatedVector<D, R>) -> &[R; D] {
        &x.hi
    }
    #[inline(always)]
    fn mean(x: &[R; D], y: &[R; D]) -> [R; D] {
        let half = R::from_f64(0.5);
        sum(scaled(half, *x), scaled(half, *y))
    }
    #[inline(always)]
    fn scale(x: &mut [R; D], c: R) {
        *x = scaled(c, *x);
    }
    #[inline(always)]
    fn add_scaled(x: &mut [R; D], c: R, y: &[R; D]) {
        *x = add_scaled(*x, c, *y);
    }
    #[inline(always)]
    fn weigh(w: &[f64], x: &[[R; D]], out: &mut [R; D]) {
        let mut sum = [R::ZERO; D];
        for j in 0..w.len().min(x.len()) {
            sum = add_scaled(sum, R::from_f64(w[j]), x[j]);
        }
        *out = sum;
    }
    #[inline(always)]
    fn leave_uncounted(&self, x: &mut [R; D]) {
        if L::ALL_COUNT {
            return;
        }
        let weights = self.law.weights();
        for i in 0..D {
            x[i] = R::either(weights[i].equal(R::ZERO), R::ZERO, x[i]);
        }
    }
    #[inline(always)]
    fn is_finite(x: &[R; D]) -> bool {
        finite(*x)
    }

    fn room(&self) {}
    fn potential(&self, t: R, q: &[R; D]) -> R {
        self.field(t).potential(*q)
    }
    #[inline]
    fn kinetic_energy(&self, v: &[R; D]) -> R {
        R::from_f64(0.5) * self.mass * weighted(self.law.weights(), *v, *v)
    }
    #[inline(always)]
    fn slope(&self, t: R, q: &[R; D], v: &[R; D], out: &mut [R; D]) {
        *out = self.field(t).slope(*q, *v);
    }

    #[inline(always)]
    fn drift_by_mean(stride: &Stride<R>, q: &mut [R; D], v: &[R; D], next: &[R; D]) {
        *q = add_scaled(*q, R::from_f64(0.5) * stride.dt, sum(*v, *next));
    }
    #[inline(always)]
    fn kick(&self, _: &mut (), stride: &Stride<R>, kick: Kick<R>, q: &[R; D], v: &[R; D], to: &mut [R; D]) {
        let (field, c) = (self.field(kick.t), kick.b * stride.kick);
        *to = if kick.e == 0.0 {
            field.kick(c, *q, *v)
        } else {
            field.gradient_kick(c, R::from_f64(kick.e) * stride.dt * stride.kick * stride.kick, *q, *v)
        };
    }
    #[inline(always)]
    fn kick_and_drift<const BY_MEAN: bool>(
        &self,
        room: &mut (),
        stride: &Stride<R>,
        kick: Kick<R>,
        a: R,
        q: &mut [R; D],
        v: &[R; D],
        to: &mut [R; D],
        work: &mut R,
    ) {
        if BY_MEAN {
            *to = self.field(kick.t).kick_by_mean(kick.b * stride.kick, *q, *v);
        } else {
            self.kick(room, stride, kick, q, v, to);
        }
        self.add_work(work, v, to);
        *q = add_scaled(*q, a, *to);
    }
    fn kick_both_ways(
        &self,
        room: &mut (),
        stride: &Stride<R>,
        kick: Kick<R>,
        start: &Beginning<'_, Self>,
    ) -> [[R; D]; 2] {
        let mut kicked = |sign: f64| {
            let mut to = *start.v;
            let kick = Kick { b: R::from_f64(sign) * kick.b, e: sign * kick.e, ..kick };
            self.kick(room, stride, kick, start.q, start.v, &mut to);
            to
        };
        [kicked(-1.0), kicked(1.0)]
    }
    #[inline(always)]
    fn add_to_sum(x: &mut CompensatedVector<D, R>, c: R, y: &[R; D]) {
        x.add(scaled(c, *y));
    }
    #[inline(always)]
    fn drift_sum(stride: &Stride<R>, q: &mut CompensatedVector<D, R>, v: &CompensatedVector<D, R>) {
        q.add(stride.drift(v));
    }
    #[inline(always)]
    fn kick_sum(&self, stride: &Stride<R>, b: R, slope: &[R; D], v: &mut CompensatedVector<D, R>, change: &mut [R; D]) {
        *change = scaled(-b * stride.kick, *slope);
        v.add(*change);
    }

    #[inline(always)]
    fn no_work(&self) -> R {
        R::ZERO
    }
    #[inline(always)]
    fn clear(work: &mut R) {
        *work = R::ZERO;
    }
    #[inline(always)]
    fn add_work(&self, work: &mut R, v: &[R; D], next: &[R; D]) {
        *work += weighted(self.law.weights(), difference(*next, *v), sum(*next, *v));
    }
    #[inline(always)]
    fn total(&self, work: &R) -> R {
        R::from_f64(0.5) * self.mass * *work
    }
    #[inline(always)]
    fn work_along(&self, slope: &[R; D], moved: &[R; D]) -> R {
        -weighted(self.law.weights(), *slope, *moved)
    }
    #[inline(always)]
    fn work_between(&self, slope: &[R; D], before: &Self::Sum, after: &Self::Sum) -> R {
        self.work_along(slope, &sum(difference(after.hi, before.hi), difference(after.lo, before.lo)))
    }
    #[inline(always)]
    fn work_at_speeds(&self, slope: &[R; D], c: R, v: &[R; D], next: &[R; D]) -> R {
        c * self.work_along(slope, &sum(*v, *next))
    }

    fn check(&self, state: &State<D, R>) -> Result<(), Error> {
        self.check_state(state)
    }

    fn prepare(&self, start: &State<D, R>, slope: &mut [R; D]) -> Result<(), Error> {
        *slope = self.slope_at_the_start(start)?;
        Ok(())
    }

    #[cold]
    fn unsolved(&self, step: u64, [q, v]: [&[R; D]; 2], t: f64, dt: f64, cause: NotConverged) -> Error {
        Attempt { step, t, dt, mass: self.mass, q: *q, v: *v }.unsolved(&self.law, cause)
    }

    fn conserves(&self, invariant: Invariant) -> bool {
        match invariant {
            Invariant::Energy | Invariant::DiscreteEnergy => L::AUTONOMOUS && L::Field::<'_>::CONSERVES_ENERGY,
            Invariant::WorkEnergy => true,
            Invariant::LinearMomentum => L::LINEAR_MOMENTUM && self.moves_freely(),
            Invariant::AngularMomentum => {
                let central = L::Field::<'_>::CENTRAL && !L::Field::<'_>::FORCED;
                (central || L::ANGULAR_MOMENTUM) && L::BODY > 1 && self.moves_freely()
            }
        }
    }

    fn own_invariants(&self) -> &'static [&'static str] {
        L::INVARIANTS
    }

    fn own_invariant(&self, k: usize, state: &State<D, R>) -> R {
        self.law.invariant(k, state.q, state.v, R::from_f64(state.t))
    }

    fn momentum(&self, invariant: Invariant, state: &State<D, R>, start: &State<D, R>) -> (R, R) {
        self.momentum_since(invariant, state, start)
    }
}

impl<L: Law<D>, const D: usize> TimeScale for Particle<L, D> {
    #[inline]
    fn names_the_time(&self) -> bool {
        !L::AUTONOMOUS
    }

    #[inline]
    fn look(&self, (): &mut (), t: f64, q: &[f64; D], v: &[f64; D], least: f64) -> Look {
        self.look_along(t, *q, *v, least)
    }
}

impl<L: Law<D, R>, const D: usize, R: Real> Particle<L, D, R> {
    /// The angular frequency of the linearised motion, and how it grows; of several side by side that of each.
    #[inline]
    pub(crate) fn look_along(&self, t: R, q: [R; D], v: [R; D], least: R) -> Look<R> {
        let per_mass = self.mass.recip();
        let fall = scaled(-per_mass, self.field(t).slope(q, v));
        let course = Course { q, v, fall, per_mass, least };
        <L::Field<'_> as Field<D, R>>::frequency(|s| Some(self.field(t + s)), self.mass, t, course).look(least)
    }
}
