//! All terms of a scene in which bodies move along given paths.

use super::drives::Drives;
use super::matrix::Matrix;
use super::terms::{Acts, Fault};
use super::topology::Topology;
use super::vectors::Vectors;

/// What acts, with driven bodies where they are at the time at which it is asked for: laws that act on the others depend on the
/// time through them, and are taken by every scheme as laws that name the time are.
#[derive(Clone, Debug)]
pub(super) struct Driven<const D: usize, A> {
    pub(super) terms: A,
    pub(super) drives: Drives<D>,
}

impl<const D: usize, A> Driven<D, A> {
    /// Asks with all bodies where they are at t.
    #[inline(always)]
    pub(super) fn at<X>(&self, t: f64, q: &Vectors<D>, ask: impl FnOnce(&A, &Vectors<D>) -> X) -> X {
        let q = self.drives.positions(q, t);
        let said = ask(&self.terms, &q);
        self.drives.back(q);
        said
    }

    /// The same with their velocities.
    #[inline(always)]
    pub(super) fn moving<X>(
        &self,
        t: f64,
        q: &Vectors<D>,
        v: &Vectors<D>,
        ask: impl FnOnce(&A, &Vectors<D>, &Vectors<D>) -> X,
    ) -> X {
        let v = self.drives.velocities(v, t);
        let said = self.at(t, q, |terms, q| ask(terms, q, &v));
        self.drives.back(v);
        said
    }

    /// The first path that is not finite at one of these times.
    pub(super) fn lost(&self, times: impl IntoIterator<Item = f64>) -> Option<Fault> {
        let is_lost = |[q, v]: [[f64; D]; 2]| q.iter().chain(&v).any(|x| !x.is_finite());
        times.into_iter().find_map(|at| {
            let (body, _) = self.drives.at(at).find(|&(_, place)| is_lost(place))?;
            Some(Fault::Path { body, at })
        })
    }
}

/// What is asked in more than one place, as [`Acts`] has it.
impl<const D: usize, A: Acts<D>> Driven<D, A> {
    #[inline]
    pub(super) fn set_gradient(&self, q: &Vectors<D>, t: f64, out: &mut Vectors<D>) {
        self.at(t, q, |terms, q| terms.set_gradient(q, t, out));
    }

    #[inline]
    pub(super) fn subtract_force(&self, c: f64, q: &Vectors<D>, v: &Vectors<D>, t: f64, out: &mut Vectors<D>) {
        if A::FORCED {
            self.moving(t, q, v, |terms, q, v| terms.subtract_force(c, q, v, t, out));
        }
    }

    #[inline]
    pub(super) fn set_discrete_gradient(&self, a: &Vectors<D>, b: &Vectors<D>, t: f64, out: &mut Vectors<D>) {
        self.at(t, a, |_, a| self.at(t, b, |terms, b| terms.set_discrete_gradient(a, b, t, out)));
    }

    pub(super) fn add_discrete_jacobian(&self, a: &Vectors<D>, b: &Vectors<D>, t: f64, out: &mut Matrix<D>) {
        self.at(t, a, |_, a| self.at(t, b, |terms, b| terms.add_discrete_jacobian(a, b, t, out)));
    }

    pub(super) fn subtract_force_jacobian(
        &self,
        c: f64,
        q: &Vectors<D>,
        v: &Vectors<D>,
        t: f64,
        rate: f64,
        out: &mut Matrix<D>,
    ) {
        if A::FORCED {
            self.moving(t, q, v, |terms, q, v| terms.subtract_force_jacobian(c, q, v, t, rate, out));
        }
    }

    pub(super) fn links(&self, bodies: usize) -> Topology {
        match self.terms.links(bodies) {
            // A chain is solved piece by piece; all bodies are placed at once.
            Topology::Chain if !self.drives.is_empty() => Topology::Near,
            topology => topology,
        }
    }

    pub(super) fn fault(&self, from: Option<&Vectors<D>>, q: &Vectors<D>, v: &Vectors<D>, t: f64) -> Option<Fault> {
        self.lost([t]).or_else(|| {
            self.moving(t, q, v, |terms, q, v| match from {
                None => terms.fault(None, q, v, t),
                Some(from) => self.at(t, from, |_, from| terms.fault(Some(from), q, v, t)),
            })
        })
    }
}
