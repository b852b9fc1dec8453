//! Nothing, and several terms together.

use core::any::{Any, TypeId};

use super::stencil::Stencil;
use super::sweep::Kicked;
use super::{Acts, Fault, Laws, Moving, Term};
use crate::error::Error;
use crate::scene::bodies::Bodies;
use crate::scene::matrix::Matrix;
use crate::scene::topology::Topology;
use crate::scene::vectors::Vectors;
use crate::system::{Frequency, LinearVelocities, WithoutVelocities};

/// Nothing acts.
impl<const D: usize, P, B> Term<D, P, B> for () {
    type Ready = ();

    fn prepare(self, _: &Bodies<D, P>, _: B) -> Result<(), Error> {
        Ok(())
    }
}

impl Laws for () {
    fn law(&mut self, _: TypeId) -> Option<&mut dyn Any> {
        None
    }
}

impl<A: Laws, B: Laws> Laws for (A, B) {
    fn law(&mut self, of: TypeId) -> Option<&mut dyn Any> {
        match self.0.law(of) {
            Some(law) => Some(law),
            None => self.1.law(of),
        }
    }
}

impl<const D: usize> Acts<D> for () {
    const NOTHING: bool = true;
    const CHAIN: bool = true;
    const FORCED: bool = false;
    const CONSERVES_ENERGY: bool = true;
    const AUTONOMOUS: bool = true;
    const LINEAR_MOMENTUM: bool = true;
    const ANGULAR_MOMENTUM: bool = true;
    const LINEAR: bool = true;
    const PIECEWISE: bool = false;
    const DEGREE: Option<u32> = Some(0);

    fn potential(&self, _: &Vectors<D>, _: f64) -> f64 {
        0.0
    }
    fn add_gradient(&self, _: &Vectors<D>, _: f64, _: &mut Vectors<D>) {}
    fn subtract_force(&self, _: f64, _: &Vectors<D>, _: &Vectors<D>, _: f64, _: &mut Vectors<D>) {}
    fn add_discrete_gradient(&self, _: &Vectors<D>, _: &Vectors<D>, _: f64, _: &mut Vectors<D>) {}
    fn add_hessian(&self, _: f64, _: &Vectors<D>, _: f64, _: &mut Matrix<D>) {}
    fn add_turned(&self, _: f64, _: &Vectors<D>, _: &Vectors<D>, _: f64, _: &mut Vectors<D>) {}
    fn add_discrete_jacobian(&self, _: &Vectors<D>, _: &Vectors<D>, _: f64, _: &mut Matrix<D>) {}
    fn subtract_force_jacobian(&self, _: f64, _: &Vectors<D>, _: &Vectors<D>, _: f64, _: f64, _: &mut Matrix<D>) {}
    fn add_stencil(&self, _: &Vectors<D>, _: f64, _: usize, _: &mut Stencil<D>) {}
    fn add_discrete_stencil(&self, _: &Vectors<D>, _: &Vectors<D>, _: f64, _: usize, _: &mut Stencil<D>) {}
    fn frequency(&self, at: &Moving<'_, D>) -> Frequency {
        at.nothing()
    }
    fn links(&self, _: usize) -> Topology {
        Topology::Chain
    }
    fn fields(&self, _: &mut dyn FnMut(&'static str, f64)) {}
    fn fault(&self, _: Option<&Vectors<D>>, _: &Vectors<D>, _: &Vectors<D>, _: f64) -> Option<Fault> {
        None
    }
}

/// Two terms, or a list of them and one more.
impl<const D: usize, P, S: Copy, A: Term<D, P, S>, B: Term<D, P, S>> Term<D, P, S> for (A, B) {
    type Ready = (A::Ready, B::Ready);

    fn prepare(self, bodies: &Bodies<D, P>, space: S) -> Result<Self::Ready, Error> {
        Ok((self.0.prepare(bodies, space)?, self.1.prepare(bodies, space)?))
    }
}

impl<A: WithoutVelocities, B: WithoutVelocities> WithoutVelocities for (A, B) {}
impl WithoutVelocities for () {}
impl<A: LinearVelocities, B: LinearVelocities> LinearVelocities for (A, B) {}
impl LinearVelocities for () {}

impl<const D: usize, A: Acts<D>, B: Acts<D>> Acts<D> for (A, B) {
    const NOTHING: bool = A::NOTHING && B::NOTHING;
    const AT_ONCE: bool = A::NOTHING && B::AT_ONCE;
    const CHAIN: bool = A::CHAIN && B::CHAIN;
    const FORCED: bool = A::FORCED || B::FORCED;
    const CONSERVES_ENERGY: bool = A::CONSERVES_ENERGY && B::CONSERVES_ENERGY;
    const AUTONOMOUS: bool = A::AUTONOMOUS && B::AUTONOMOUS;
    const LINEAR_MOMENTUM: bool = A::LINEAR_MOMENTUM && B::LINEAR_MOMENTUM;
    const ANGULAR_MOMENTUM: bool = A::ANGULAR_MOMENTUM && B::ANGULAR_MOMENTUM;
    const LINEAR: bool = A::LINEAR && B::LINEAR;
    const PIECEWISE: bool = A::PIECEWISE || B::PIECEWISE;
    const DEGREE: Option<u32> = match (A::DEGREE, B::DEGREE) {
        (Some(a), Some(b)) => Some(if a > b { a } else { b }),
        _ => None,
    };

    fn potential(&self, q: &Vectors<D>, t: f64) -> f64 {
        self.0.potential(q, t) + self.1.potential(q, t)
    }
    fn add_gradient(&self, q: &Vectors<D>, t: f64, out: &mut Vectors<D>) {
        self.0.add_gradient(q, t, out);
        self.1.add_gradient(q, t, out);
    }
    #[inline]
    fn set_gradient(&self, q: &Vectors<D>, t: f64, out: &mut Vectors<D>) {
        if A::NOTHING {
            self.1.set_gradient(q, t, out);
        } else {
            self.0.set_gradient(q, t, out);
            self.1.add_gradient(q, t, out);
        }
    }
    fn kick(&self, q: &Vectors<D>, t: f64, kick: Kicked<'_, D>) {
        self.1.kick(q, t, kick);
    }
    #[inline]
    fn kick_and_drift(&self, a: f64, q: &mut Vectors<D>, t: f64, kick: Kicked<'_, D>) {
        self.1.kick_and_drift(a, q, t, kick);
    }
    #[inline]
    fn at_once(&self) -> bool {
        A::NOTHING && self.1.at_once()
    }
    fn subtract_force(&self, c: f64, q: &Vectors<D>, v: &Vectors<D>, t: f64, out: &mut Vectors<D>) {
        self.0.subtract_force(c, q, v, t, out);
        self.1.subtract_force(c, q, v, t, out);
    }
    fn add_force_dv(&self, q: &Vectors<D>, t: f64, out: &mut [[[f64; D]; D]]) {
        self.0.add_force_dv(q, t, out);
        self.1.add_force_dv(q, t, out);
    }
    fn add_discrete_gradient(&self, a: &Vectors<D>, b: &Vectors<D>, t: f64, out: &mut Vectors<D>) {
        self.0.add_discrete_gradient(a, b, t, out);
        self.1.add_discrete_gradient(a, b, t, out);
    }
    #[inline]
    fn set_discrete_gradient(&self, a: &Vectors<D>, b: &Vectors<D>, t: f64, out: &mut Vectors<D>) {
        if A::NOTHING {
            self.1.set_discrete_gradient(a, b, t, out);
        } else {
            self.0.set_discrete_gradient(a, b, t, out);
            self.1.add_discrete_gradient(a, b, t, out);
        }
    }
    fn add_hessian(&self, c: f64, q: &Vectors<D>, t: f64, out: &mut Matrix<D>) {
        self.0.add_hessian(c, q, t, out);
        self.1.add_hessian(c, q, t, out);
    }
    fn add_turned(&self, c: f64, q: &Vectors<D>, w: &Vectors<D>, t: f64, out: &mut Vectors<D>) {
        self.0.add_turned(c, q, w, t, out);
        self.1.add_turned(c, q, w, t, out);
    }
    fn add_discrete_jacobian(&self, a: &Vectors<D>, b: &Vectors<D>, t: f64, out: &mut Matrix<D>) {
        self.0.add_discrete_jacobian(a, b, t, out);
        self.1.add_discrete_jacobian(a, b, t, out);
    }
    fn subtract_force_jacobian(&self, c: f64, q: &Vectors<D>, v: &Vectors<D>, t: f64, rate: f64, out: &mut Matrix<D>) {
        self.0.subtract_force_jacobian(c, q, v, t, rate, out);
        self.1.subtract_force_jacobian(c, q, v, t, rate, out);
    }
    #[inline(always)]
    fn add_stencil(&self, q: &Vectors<D>, t: f64, first: usize, out: &mut Stencil<D>) {
        self.0.add_stencil(q, t, first, out);
        self.1.add_stencil(q, t, first, out);
    }
    #[inline(always)]
    fn add_discrete_stencil(&self, a: &Vectors<D>, b: &Vectors<D>, t: f64, first: usize, out: &mut Stencil<D>) {
        self.0.add_discrete_stencil(a, b, t, first, out);
        self.1.add_discrete_stencil(a, b, t, first, out);
    }
    fn frequency(&self, at: &Moving<'_, D>) -> Frequency {
        self.0.frequency(at).and(self.1.frequency(at))
    }
    fn links(&self, bodies: usize) -> Topology {
        self.0.links(bodies).and(self.1.links(bodies))
    }
    fn fields(&self, see: &mut dyn FnMut(&'static str, f64)) {
        self.0.fields(see);
        self.1.fields(see);
    }
    fn fault(&self, from: Option<&Vectors<D>>, q: &Vectors<D>, v: &Vectors<D>, t: f64) -> Option<Fault> {
        self.0.fault(from, q, v, t).or_else(|| self.1.fault(from, q, v, t))
    }
}
