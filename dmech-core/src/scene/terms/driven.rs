//! All terms of a scene in which bodies move along given paths.

use core::any::{Any, TypeId};

use super::stencil::Stencil;
use super::sweep::Kicked;
use super::{Acts, Fault, Laws, Moving};
use crate::error::Error;
use crate::scene::drives::Drives;
use crate::scene::matrix::Matrix;
use crate::scene::topology::Topology;
use crate::scene::vectors::Vectors;
use crate::system::{Frequency, LinearVelocities, WithoutVelocities};

/// What acts, with driven bodies where they are at the time at which it is asked for: laws that act on the others depend on the
/// time through them, and are taken by every scheme as laws that name the time are.
#[derive(Clone, Debug)]
pub struct Driven<const D: usize, A> {
    pub(in crate::scene) acts: A,
    pub(in crate::scene) drives: Drives<D>,
}

impl<const D: usize, A> Driven<D, A> {
    /// Asks with all bodies where they are at t.
    #[inline(always)]
    fn at<X>(&self, t: f64, q: &Vectors<D>, ask: impl FnOnce(&A, &Vectors<D>) -> X) -> X {
        let q = self.drives.positions(q, t);
        let said = ask(&self.acts, &q);
        self.drives.back(q);
        said
    }

    /// The same with their velocities.
    #[inline(always)]
    fn moving<X>(
        &self,
        t: f64,
        q: &Vectors<D>,
        v: &Vectors<D>,
        ask: impl FnOnce(&A, &Vectors<D>, &Vectors<D>) -> X,
    ) -> X {
        let v = self.drives.velocities(v, t);
        let said = self.at(t, q, |acts, q| ask(acts, q, &v));
        self.drives.back(v);
        said
    }

    /// The first path that is not finite at one of these times.
    pub(in crate::scene) fn lost(&self, times: impl IntoIterator<Item = f64>) -> Option<Fault> {
        let is_lost = |[q, v]: [[f64; D]; 2]| q.iter().chain(&v).any(|x| !x.is_finite());
        times.into_iter().find_map(|at| {
            let (body, _) = self.drives.at(at).find(|&(_, place)| is_lost(place))?;
            Some(Fault::Path { body, at })
        })
    }
}

impl<const D: usize, A: WithoutVelocities> WithoutVelocities for Driven<D, A> {}
impl<const D: usize, A: LinearVelocities> LinearVelocities for Driven<D, A> {}

impl<const D: usize, A: Laws> Laws for Driven<D, A> {
    fn law(&mut self, of: TypeId, on: Option<usize>) -> Option<&mut dyn Any> {
        self.acts.law(of, on)
    }
}

impl<const D: usize, A: Acts<D>> Acts<D> for Driven<D, A> {
    const FORCED: bool = A::FORCED;
    const CONSERVES_ENERGY: bool = A::CONSERVES_ENERGY;
    const AUTONOMOUS: bool = A::AUTONOMOUS;
    const LINEAR_MOMENTUM: bool = A::LINEAR_MOMENTUM;
    const ANGULAR_MOMENTUM: bool = A::ANGULAR_MOMENTUM;
    const LINEAR: bool = A::LINEAR;
    const PIECEWISE: bool = A::PIECEWISE;
    const DEGREE: Option<u32> = A::DEGREE;
    const NOTHING: bool = A::NOTHING;
    const AT_ONCE: bool = A::AT_ONCE;
    const CHAIN: bool = A::CHAIN;

    fn potential(&self, q: &Vectors<D>, t: f64) -> f64 {
        self.at(t, q, |acts, q| acts.potential(q, t))
    }

    fn add_gradient(&self, q: &Vectors<D>, t: f64, out: &mut Vectors<D>) {
        self.at(t, q, |acts, q| acts.add_gradient(q, t, out));
    }

    #[inline]
    fn set_gradient(&self, q: &Vectors<D>, t: f64, out: &mut Vectors<D>) {
        self.at(t, q, |acts, q| acts.set_gradient(q, t, out));
    }

    #[inline]
    fn kick(&self, q: &Vectors<D>, t: f64, kick: Kicked<'_, D>) {
        self.at(t, q, |acts, q| acts.kick(q, t, kick));
    }

    #[inline]
    fn kick_and_drift(&self, a: f64, q: &mut Vectors<D>, t: f64, kick: Kicked<'_, D>) {
        self.acts.kick_and_drift(a, q, t, kick);
    }

    #[inline]
    fn at_once(&self) -> bool {
        self.drives.is_empty() && self.acts.at_once()
    }

    #[inline]
    fn subtract_force(&self, c: f64, q: &Vectors<D>, v: &Vectors<D>, t: f64, out: &mut Vectors<D>) {
        if A::FORCED {
            self.moving(t, q, v, |acts, q, v| acts.subtract_force(c, q, v, t, out));
        }
    }

    fn add_force_dv(&self, q: &Vectors<D>, t: f64, out: &mut [[[f64; D]; D]]) {
        self.at(t, q, |acts, q| acts.add_force_dv(q, t, out));
    }

    fn add_discrete_gradient(&self, a: &Vectors<D>, b: &Vectors<D>, t: f64, out: &mut Vectors<D>) {
        self.at(t, a, |_, a| self.at(t, b, |acts, b| acts.add_discrete_gradient(a, b, t, out)));
    }

    #[inline]
    fn set_discrete_gradient(&self, a: &Vectors<D>, b: &Vectors<D>, t: f64, out: &mut Vectors<D>) {
        self.at(t, a, |_, a| self.at(t, b, |acts, b| acts.set_discrete_gradient(a, b, t, out)));
    }

    fn add_hessian(&self, c: f64, q: &Vectors<D>, t: f64, out: &mut Matrix<D>) {
        self.at(t, q, |acts, q| acts.add_hessian(c, q, t, out));
    }

    fn add_turned(&self, c: f64, q: &Vectors<D>, w: &Vectors<D>, t: f64, out: &mut Vectors<D>) {
        self.at(t, q, |acts, q| acts.add_turned(c, q, w, t, out));
    }

    fn add_discrete_jacobian(&self, a: &Vectors<D>, b: &Vectors<D>, t: f64, out: &mut Matrix<D>) {
        self.at(t, a, |_, a| self.at(t, b, |acts, b| acts.add_discrete_jacobian(a, b, t, out)));
    }

    fn subtract_force_jacobian(&self, c: f64, q: &Vectors<D>, v: &Vectors<D>, t: f64, rate: f64, out: &mut Matrix<D>) {
        if A::FORCED {
            self.moving(t, q, v, |acts, q, v| acts.subtract_force_jacobian(c, q, v, t, rate, out));
        }
    }

    /// Not asked where bodies are driven: see [`links`](Acts::links).
    #[inline(always)]
    fn add_stencil(&self, q: &Vectors<D>, t: f64, first: usize, out: &mut Stencil<D>) {
        self.acts.add_stencil(q, t, first, out);
    }

    #[inline(always)]
    fn add_discrete_stencil(&self, a: &Vectors<D>, b: &Vectors<D>, t: f64, first: usize, out: &mut Stencil<D>) {
        self.acts.add_discrete_stencil(a, b, t, first, out);
    }

    fn frequency(&self, at: &Moving<'_, D>) -> Frequency {
        self.moving(at.t, at.q, at.v, |acts, q, v| acts.frequency(&Moving { q, v, ..*at }))
    }

    fn links(&self, bodies: usize) -> Topology {
        match self.acts.links(bodies) {
            // A chain is solved piece by piece; all bodies are placed at once.
            Topology::Chain if !self.drives.is_empty() => Topology::Near,
            topology => topology,
        }
    }

    fn fields(&self, see: &mut dyn FnMut(&'static str, f64)) {
        self.acts.fields(see);
        self.drives.bodies().for_each(|i| see("driven bodies", i as f64));
    }

    fn as_written(&self, bodies: &dyn Fn(usize) -> [[f64; D]; 2], t: f64) -> Result<(), Error> {
        self.acts.as_written(bodies, t)
    }

    fn fault(&self, from: Option<&Vectors<D>>, q: &Vectors<D>, v: &Vectors<D>, t: f64) -> Option<Fault> {
        if let Some(lost) = self.lost([t]) {
            return Some(lost);
        }
        self.moving(t, q, v, |acts, q, v| match from {
            None => acts.fault(None, q, v, t),
            Some(from) => self.at(t, from, |_, from| acts.fault(Some(from), q, v, t)),
        })
    }
}
