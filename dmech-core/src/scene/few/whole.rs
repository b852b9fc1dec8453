//! Few bodies at one moment, as a field of all their coordinates.

use dmech_scalar::Real;

use super::among::{Among, AmongFew, Places};
use super::sides::{Mutual, Sides};
use crate::law::{Field, Potential};
use crate::look::{Course, Frequency};
use crate::vector::scaled;

/// What acts among few bodies at one moment, the rows of each divided by its mass: that of a particle of mass 1.
pub struct Whole<A: AmongFew<D, N, S>, const D: usize, const N: usize, const K: usize, R: Real, S: Sides = Mutual> {
    pub(super) acts: A::Moment<R>,
    /// Those of the bodies; of pinned ones infinite.
    pub(super) inertia: [R; N],
    pub(super) t: R,
}

/// The coordinates of each body.
#[inline(always)]
fn bodies<const D: usize, const N: usize, const K: usize, R: Real>(x: [R; K]) -> Places<D, N, R> {
    let mut all = [[R::ZERO; D]; N];
    for i in 0..K {
        all[i / D][i % D] = x[i];
    }
    all
}

impl<A: AmongFew<D, N, S>, const D: usize, const N: usize, const K: usize, R: Real, S: Sides> Whole<A, D, N, K, R, S> {
    /// What is added up for each body, divided by its mass.
    #[inline(always)]
    fn rows(&self, add: impl FnOnce(&mut Places<D, N, R>)) -> [R; K] {
        let mut of_bodies = [[R::ZERO; D]; N];
        add(&mut of_bodies);
        let mut all = [R::ZERO; K];
        for i in 0..K {
            all[i] = of_bodies[i / D][i % D] / self.inertia[i / D];
        }
        all
    }

    /// ∇Φ − F of each body.
    #[inline(always)]
    fn slopes(&self, q: [R; K], v: [R; K]) -> Places<D, N, R> {
        let (q, mut slopes) = (bodies(q), [[R::ZERO; D]; N]);
        if A::FORCED {
            self.acts.add_force(&q, &bodies(v), self.t, &mut slopes);
            slopes = slopes.map(|x| scaled(-R::ONE, x));
        }
        self.acts.add_gradient(&q, &mut slopes);
        slopes
    }

    /// The same of a matrix.
    #[inline(always)]
    fn matrix(&self, add: impl FnOnce(&mut [[R; K]; K])) -> [[R; K]; K] {
        let mut all = [[R::ZERO; K]; K];
        add(&mut all);
        for i in 0..K {
            all[i] = scaled(self.inertia[i / D].recip(), all[i]);
        }
        all
    }
}

impl<A: AmongFew<D, N, S>, const D: usize, const N: usize, const K: usize, R: Real, S: Sides> Potential<K, R>
    for Whole<A, D, N, K, R, S>
{
    const LINEAR: bool = A::LINEAR && !A::FORCED;
    const PIECEWISE: bool = A::PIECEWISE;
    const DEGREE: Option<u32> = if A::FORCED { None } else { A::DEGREE };

    #[inline(always)]
    fn potential(&self, q: [R; K]) -> R {
        self.acts.potential(&bodies(q))
    }
    #[inline(always)]
    fn gradient(&self, q: [R; K]) -> [R; K] {
        self.rows(|out| self.acts.add_gradient(&bodies(q), out))
    }
    fn hessian(&self, q: [R; K]) -> [[R; K]; K] {
        self.matrix(|out| self.acts.add_hessian(&bodies(q), out))
    }
    #[inline(always)]
    fn discrete_gradient(&self, a: [R; K], b: [R; K]) -> [R; K] {
        self.rows(|out| self.acts.add_discrete_gradient(&bodies(a), &bodies(b), out))
    }
    fn discrete_gradient_jacobian(&self, a: [R; K], b: [R; K]) -> [[R; K]; K] {
        self.matrix(|out| self.acts.add_discrete_jacobian(&bodies(a), &bodies(b), out))
    }
}

impl<A: AmongFew<D, N, S>, const D: usize, const N: usize, const K: usize, R: Real, S: Sides> Field<K, R>
    for Whole<A, D, N, K, R, S>
{
    const FORCED: bool = A::FORCED;
    const CONSERVES_ENERGY: bool = A::CONSERVES_ENERGY;

    #[inline(always)]
    fn slope(&self, q: [R; K], v: [R; K]) -> [R; K] {
        self.rows(|out| *out = self.slopes(q, v))
    }
    #[inline(always)]
    fn force(&self, q: [R; K], v: [R; K], t: R) -> [R; K] {
        self.rows(|out| self.acts.add_force(&bodies(q), &bodies(v), t, out))
    }
    fn force_dq(&self, q: [R; K], v: [R; K], t: R) -> [[R; K]; K] {
        let mut beside = [[R::ZERO; K]; K];
        self.matrix(|out| self.acts.add_force_jacobians(&bodies(q), &bodies(v), t, [out, &mut beside]))
    }
    fn force_dv(&self, q: [R; K], v: [R; K], t: R) -> [[R; K]; K] {
        let mut beside = [[R::ZERO; K]; K];
        self.matrix(|out| self.acts.add_force_jacobians(&bodies(q), &bodies(v), t, [&mut beside, out]))
    }
    /// With h/m of each body, as a scene has it: one quotient in place of D.
    #[inline(always)]
    fn kick(&self, c: R, q: [R; K], v: [R; K]) -> [R; K] {
        let slope = self.slopes(q, v);
        let mut to = v;
        for i in 0..N {
            let c = c / self.inertia[i];
            for k in 0..D {
                to[D * i + k] = v[D * i + k] - c * slope[i][k];
            }
        }
        to
    }
    #[inline(always)]
    fn time(&self) -> R {
        self.t
    }

    /// As a scene has it, of each link and each body by itself.
    fn frequency(from_now: impl Fn(R) -> Option<Self>, mass: R, t: R, course: Course<K, R>) -> Frequency<R> {
        let Course { q, v, fall, least, .. } = course;
        let (q, v, fall): (Places<D, N, R>, Places<D, N, R>, Places<D, N, R>) = (bodies(q), bodies(v), bodies(fall));
        let Some(Whole { acts, inertia, .. }) = from_now(R::ZERO) else { return Frequency::none(least) };
        let none = [R::ZERO; D];
        let mut bodies = [Course { q: none, v: none, fall: none, per_mass: R::ZERO, least }; N];
        for i in 0..N {
            let per_mass = (mass * inertia[i]).recip();
            bodies[i] = Course { q: q[i], v: v[i], fall: fall[i], per_mass, least };
        }
        acts.frequency(&|s| Some(from_now(s)?.acts), t, &bodies)
    }
}
