//! Nothing, and several terms together.

use core::any::{Any, TypeId};

use super::stencil::Stencil;
use super::sweep::Kicked;
use super::{Acts, Fault, Laws, Moving, Term};
use crate::error::Error;
use crate::scene::bodies::Bodies;
use crate::scene::both::{of_both, of_nothing};
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
    fn law(&mut self, _: TypeId, _: Option<usize>) -> Option<&mut dyn Any> {
        None
    }
}

impl<A: Laws, B: Laws> Laws for (A, B) {
    fn law(&mut self, of: TypeId, on: Option<usize>) -> Option<&mut dyn Any> {
        match self.0.law(of, on) {
            Some(law) => Some(law),
            None => self.1.law(of, on),
        }
    }
}

/// The functions that add to what they are given.
macro_rules! that_add {
    ($whose:ident) => {
        $whose! {
            add_gradient(q: &Vectors<D>, t: f64, out: &mut Vectors<D>);
            subtract_force(c: f64, q: &Vectors<D>, v: &Vectors<D>, t: f64, out: &mut Vectors<D>);
            add_force_dv(q: &Vectors<D>, t: f64, out: &mut [[[f64; D]; D]]);
            add_discrete_gradient(a: &Vectors<D>, b: &Vectors<D>, t: f64, out: &mut Vectors<D>);
            add_hessian(c: f64, q: &Vectors<D>, t: f64, out: &mut Matrix<D>);
            add_turned(c: f64, q: &Vectors<D>, w: &Vectors<D>, t: f64, out: &mut Vectors<D>);
            add_discrete_jacobian(a: &Vectors<D>, b: &Vectors<D>, t: f64, out: &mut Matrix<D>);
            subtract_force_jacobian(c: f64, q: &Vectors<D>, v: &Vectors<D>, t: f64, rate: f64, out: &mut Matrix<D>);
            #[inline(always)]
            add_stencil(q: &Vectors<D>, t: f64, first: usize, out: &mut Stencil<D>);
            #[inline(always)]
            add_discrete_stencil(a: &Vectors<D>, b: &Vectors<D>, t: f64, first: usize, out: &mut Stencil<D>);
            fields(see: &mut dyn FnMut(&'static str, f64));
        }
    };
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
    that_add!(of_nothing);
    fn frequency(&self, at: &Moving<'_, D>) -> Frequency {
        at.nothing()
    }
    fn links(&self, _: usize) -> Topology {
        Topology::Chain
    }
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
    #[inline]
    fn set_discrete_gradient(&self, a: &Vectors<D>, b: &Vectors<D>, t: f64, out: &mut Vectors<D>) {
        if A::NOTHING {
            self.1.set_discrete_gradient(a, b, t, out);
        } else {
            self.0.set_discrete_gradient(a, b, t, out);
            self.1.add_discrete_gradient(a, b, t, out);
        }
    }
    that_add!(of_both);
    fn frequency(&self, at: &Moving<'_, D>) -> Frequency {
        self.0.frequency(at).and(self.1.frequency(at))
    }
    fn links(&self, bodies: usize) -> Topology {
        self.0.links(bodies).and(self.1.links(bodies))
    }
    fn as_written(&self, bodies: &dyn Fn(usize) -> [[f64; D]; 2], t: f64) -> Result<(), Error> {
        self.0.as_written(bodies, t)?;
        self.1.as_written(bodies, t)
    }

    fn fault(&self, from: Option<&Vectors<D>>, q: &Vectors<D>, v: &Vectors<D>, t: f64) -> Option<Fault> {
        self.0.fault(from, q, v, t).or_else(|| self.1.fault(from, q, v, t))
    }
}
