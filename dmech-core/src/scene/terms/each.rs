//! A law on each body.

use core::any::{Any, TypeId};

use super::stencil::{Stencil, block};
use super::whose::{Given, OfBodies};
use super::{Acts, Fault, Laws, Moving, Term, if_of};
use crate::error::{Culprit, Error, Place};
use crate::law::written::{Probe, agree};
use crate::law::{Field, Law, LinearInVelocity, Potential, VelocityIndependent};
use crate::scene::acting::Acting;
use crate::scene::bodies::Bodies;
use crate::scene::matrix::Matrix;
use crate::scene::matrix::block::times;
use crate::scene::topology::Topology;
use crate::scene::vectors::Vectors;
use crate::system::{Frequency, LinearVelocities, Stiffness, WithoutVelocities};
use crate::vector::{difference, scaled, sum};

/// What acts on a body at one moment.
type OnBody<'a, const D: usize, W> = <<W as OfBodies>::Law as Law<D>>::Field<'a>;

/// A law that acts on each body by itself, one for all or each its own.
#[derive(Clone, Copy, Debug)]
pub struct Each<W> {
    pub(crate) laws: W,
}

/// A law that acts on each body, with their masses.
#[derive(Clone, Debug)]
pub struct EachReady<W> {
    pub(in crate::scene) laws: W,
    pub(in crate::scene) masses: Vec<f64>,
    acting: Acting,
}

impl<W: OfBodies<Law: VelocityIndependent>> WithoutVelocities for EachReady<W> {}
impl<W: OfBodies<Law: LinearInVelocity>> LinearVelocities for EachReady<W> {}

impl<const D: usize, P, W: Given<P, Laws: OfBodies<Law: Law<D>>>, B> Term<D, P, B> for Each<W> {
    type Ready = EachReady<W::Laws>;

    fn prepare(self, bodies: &Bodies<D, P>, _: B) -> Result<EachReady<W::Laws>, Error> {
        Ok(EachReady { laws: self.laws.laws(&bodies.data), masses: bodies.masses.clone(), acting: bodies.acting() })
    }
}

impl<W: OfBodies<Law: 'static>> Laws for EachReady<W> {
    fn law(&mut self, of: TypeId, on: Option<usize>) -> Option<&mut dyn Any> {
        if_of(self.laws.of_mut(on)?, of)
    }
}

impl<W: OfBodies> EachReady<W> {
    /// What acts on body i.
    #[inline(always)]
    fn field<const D: usize>(&self, i: usize, t: f64) -> OnBody<'_, D, W>
    where
        W::Law: Law<D>,
    {
        self.laws.of(i).field(self.masses[i], t)
    }

    fn fields<const D: usize>(&self, t: f64) -> impl Iterator<Item = (usize, OnBody<'_, D, W>)>
    where
        W::Law: Law<D>,
    {
        self.masses.iter().enumerate().map(move |(i, &mass)| (i, self.laws.of(i).field(mass, t)))
    }
}

impl<const D: usize, W: OfBodies<Law: Law<D>>> Acts<D> for EachReady<W> {
    const FORCED: bool = OnBody::<D, W>::FORCED;
    const CONSERVES_ENERGY: bool = OnBody::<D, W>::CONSERVES_ENERGY;
    const AUTONOMOUS: bool = <W::Law as Law<D>>::AUTONOMOUS;
    const LINEAR_MOMENTUM: bool = false;
    const ANGULAR_MOMENTUM: bool = OnBody::<D, W>::CENTRAL && !Self::FORCED;
    const LINEAR: bool = OnBody::<D, W>::LINEAR;
    const PIECEWISE: bool = OnBody::<D, W>::PIECEWISE;
    const DEGREE: Option<u32> = OnBody::<D, W>::DEGREE;
    const CHAIN: bool = true;

    fn potential(&self, q: &Vectors<D>, t: f64) -> f64 {
        // The energy is that of the bodies that act on others.
        let acting = self.fields(t).filter(|&(i, _)| self.acting.acts(i));
        acting.map(|(i, field)| field.potential(q.get(i))).sum()
    }

    fn add_gradient(&self, q: &Vectors<D>, t: f64, out: &mut Vectors<D>) {
        for (i, field) in self.fields(t) {
            out.add(i, field.gradient(q.get(i)));
        }
    }

    fn subtract_force(&self, c: f64, q: &Vectors<D>, v: &Vectors<D>, t: f64, out: &mut Vectors<D>) {
        if Self::FORCED {
            for (i, field) in self.fields(t) {
                let force = field.force(q.get(i), v.get(i), t);
                out.add(i, scaled(-c, force));
            }
        }
    }

    fn add_force_dv(&self, q: &Vectors<D>, t: f64, out: &mut [[[f64; D]; D]]) {
        if Self::FORCED {
            for ((i, field), out) in self.fields(t).zip(out) {
                let by_velocity = field.force_dv(q.get(i), [0.0; D], t);
                *out = core::array::from_fn(|k| sum(out[k], by_velocity[k]));
            }
        }
    }

    fn add_discrete_gradient(&self, a: &Vectors<D>, b: &Vectors<D>, t: f64, out: &mut Vectors<D>) {
        for (i, field) in self.fields(t) {
            out.add(i, field.discrete_gradient(a.get(i), b.get(i)));
        }
    }

    fn add_hessian(&self, c: f64, q: &Vectors<D>, t: f64, out: &mut Matrix<D>) {
        for (i, field) in self.fields(t) {
            out.add_block(i, i, field.hessian(q.get(i)).map(|row| row.map(|x| c * x)));
        }
    }

    fn add_turned(&self, c: f64, q: &Vectors<D>, w: &Vectors<D>, t: f64, out: &mut Vectors<D>) {
        for (i, field) in self.fields(t) {
            let (q, w) = (q.get(i), scaled(c, w.get(i)));
            let turned = times(&field.hessian(q), w);
            if Self::FORCED {
                let by_force = times(&field.force_dq(q, [0.0; D], t), w);
                out.add(i, difference(turned, by_force));
            } else {
                out.add(i, turned);
            }
        }
    }

    fn add_discrete_jacobian(&self, a: &Vectors<D>, b: &Vectors<D>, t: f64, out: &mut Matrix<D>) {
        for (i, field) in self.fields(t) {
            out.add_block(i, i, field.discrete_gradient_jacobian(a.get(i), b.get(i)));
        }
    }

    fn subtract_force_jacobian(&self, c: f64, q: &Vectors<D>, v: &Vectors<D>, t: f64, rate: f64, out: &mut Matrix<D>) {
        if Self::FORCED {
            for (i, field) in self.fields(t) {
                let (q, v) = (q.get(i), v.get(i));
                let (by_q, by_v) = (field.force_dq(q, v, t), field.force_dv(q, v, t));
                let block = |k: usize, l: usize| -c * rate.mul_add(by_v[k][l], by_q[k][l]);
                out.add_block(i, i, core::array::from_fn(|k| core::array::from_fn(|l| block(k, l))));
            }
        }
    }

    #[inline(always)]
    fn add_stencil(&self, q: &Vectors<D>, t: f64, first: usize, out: &mut Stencil<D>) {
        for i in block(first, q.bodies()) {
            let (field, q) = (self.field(i, t), q.get(i));
            out.add_own(i - first, field.gradient(q), field.hessian(q));
        }
    }

    #[inline(always)]
    fn add_discrete_stencil(&self, a: &Vectors<D>, b: &Vectors<D>, t: f64, first: usize, out: &mut Stencil<D>) {
        for i in block(first, b.bodies()) {
            let (field, a, b) = (self.field(i, t), a.get(i), b.get(i));
            out.add_own(i - first, field.discrete_gradient(a, b), field.discrete_gradient_jacobian(a, b));
        }
    }

    fn frequency(&self, at: &Moving<'_, D>) -> Frequency {
        let moving = self.masses.iter().enumerate().filter(|&(i, _)| at.per_mass[i] != 0.0);
        moving.fold(at.nothing(), |all, (i, &mass)| {
            all.and(Frequency::of(at.body(i), |s, q, v| Stiffness::of(&self.field(i, at.t + s), mass, at.t + s, q, v)))
        })
    }

    fn links(&self, _: usize) -> Topology {
        Topology::Chain
    }

    fn fields(&self, see: &mut dyn FnMut(&'static str, f64)) {
        self.laws.tell(see);
    }

    fn as_written(&self, bodies: &dyn Fn(usize) -> [[f64; D]; 2], t: f64) -> Result<(), Error> {
        self.masses.iter().enumerate().try_for_each(|(body, &mass)| {
            let Some(law) = self.laws.of(body).written() else { return Ok(()) };
            let [q, v] = bodies(body);
            let place = Probe { q, v: [v; 2], m: [mass; 2], t };
            let agreed = agree(law, &place, W::OWN || body == 0);
            agreed.map_err(|difference| Error::NotAsWritten(difference.on(Culprit::Body(body))))
        })
    }

    fn fault(&self, from: Option<&Vectors<D>>, q: &Vectors<D>, v: &Vectors<D>, t: f64) -> Option<Fault> {
        self.fields(t).find_map(|(body, field)| {
            let (q, v) = (q.get(body), v.get(body));
            let secant = from.map_or([0.0; D], |from| field.discrete_gradient(from.get(body), q));
            let values = field.slope(q, v).into_iter().chain([field.potential(q)]).chain(secant);
            let place = Place::new(&q);
            values.into_iter().find(|x| !x.is_finite()).map(|value| Fault::Body { body, value, place })
        })
    }
}
