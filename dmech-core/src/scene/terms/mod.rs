//! What acts in a scene: on each body, and along links between bodies.

mod cores;
mod each;
mod kernels;
mod linked;
mod links;
mod moving;
mod near;
mod numbers;
mod one_sided;
mod packed;
mod pairs;
mod separation;
mod staged;
pub(super) mod stencil;
mod stiffness;
mod sum;
mod sweep;
mod way;
mod whose;

#[cfg(test)]
mod tests;

pub use each::Each;
pub(in crate::scene) use each::EachReady;
pub use linked::Linked;
pub(in crate::scene) use linked::LinkedReady;
pub use links::{Bonds, Chain};
pub(in crate::scene) use links::{KnownLinks, Links};
pub use moving::Moving;
pub use near::Near;
pub use pairs::Pairs;
pub(in crate::scene) use staged::{ActsAtStages, BodyAtStages, Moments};
pub(in crate::scene) use stiffness::link_stiffness;
pub use sweep::Kicked;
pub(in crate::scene) use way::Way;
pub(in crate::scene) use whose::{List, OfBodies};
pub use whose::{One, Own};

use core::any::{Any, TypeId};

use stencil::Stencil;

use super::bodies::Bodies;
use super::matrix::Matrix;
use super::space::Open;
use super::topology::Topology;
use super::vectors::Vectors;
use crate::error::{Error, Place};
use crate::system::{Frequency, Look};

/// A term of a scene as it was declared, for bodies that carry a `P` in the space `B`.
pub trait Term<const D: usize, P, B = Open> {
    /// The term with what it reads of the bodies in columns.
    type Ready: Acts<D>;

    /// Reads the bodies.
    ///
    /// # Errors
    /// [`Error`] for links between bodies that are not there, and for a cut-off that does not fit.
    fn prepare(self, bodies: &Bodies<D, P>, space: B) -> Result<Self::Ready, Error>;
}

/// What acts in a scene, all terms together: a sum of potentials, and perhaps of forces.
///
/// Every function adds to what it is given.
pub trait Acts<const D: usize> {
    /// A force acts beside the potentials.
    const FORCED: bool;
    /// The energy Σ m v²/2 + Φ is kept while no potential names the time: no force acts, or those that do, do no work at any velocity.
    const CONSERVES_ENERGY: bool;
    /// No term names the time.
    const AUTONOMOUS: bool;
    /// Σ m v is kept while no body is pinned.
    const LINEAR_MOMENTUM: bool;
    /// Σ m q∧v is kept while no body is pinned.
    const ANGULAR_MOMENTUM: bool;
    /// Every Hessian is constant.
    const LINEAR: bool;
    /// What acts may bend or jump: [`Potential::PIECEWISE`](crate::Potential::PIECEWISE).
    const PIECEWISE: bool;
    /// The potential is a polynomial of at most this degree in the coordinates:
    /// [`Potential::DEGREE`](crate::Potential::DEGREE).
    const DEGREE: Option<u32>;

    /// Nothing acts.
    const NOTHING: bool = false;
    /// A kick needs no gradient that is stored before.
    const AT_ONCE: bool = false;
    /// No term links others than consecutive bodies: [`add_stencil`](Acts::add_stencil) may be asked for.
    const CHAIN: bool;

    /// Φ(q).
    fn potential(&self, q: &Vectors<D>, t: f64) -> f64;
    /// ∇Φ(q).
    fn add_gradient(&self, q: &Vectors<D>, t: f64, out: &mut Vectors<D>);
    /// The same, in place of what is there.
    fn set_gradient(&self, q: &Vectors<D>, t: f64, out: &mut Vectors<D>) {
        out.clear();
        self.add_gradient(q, t, out);
    }
    /// Kicks by all that acts as it is computed, in one pass over the bodies, where this can be done
    /// ([`AT_ONCE`](Acts::AT_ONCE)).
    fn kick(&self, _q: &Vectors<D>, _t: f64, _kick: Kicked<'_, D>) {}
    /// The same, and drifts by the new velocities, q += a v′, where [`at_once`](Acts::at_once) says so.
    fn kick_and_drift(&self, _a: f64, _q: &mut Vectors<D>, _t: f64, _kick: Kicked<'_, D>) {}
    /// A kick and a drift can be made in one pass, if no body is driven: all bodies act.
    fn at_once(&self) -> bool {
        false
    }
    /// −c F(q, v).
    fn subtract_force(&self, c: f64, q: &Vectors<D>, v: &Vectors<D>, t: f64, out: &mut Vectors<D>);
    /// ∂F/∂v of each body by its own velocity. Asked for only where every force is linear in it; a law between bodies then
    /// has none that depends on a velocity.
    fn add_force_dv(&self, _q: &Vectors<D>, _t: f64, _out: &mut [[[f64; D]; D]]) {}
    /// ∇̄Φ(a, b).
    fn add_discrete_gradient(&self, a: &Vectors<D>, b: &Vectors<D>, t: f64, out: &mut Vectors<D>);
    /// The same, in place of what is there.
    fn set_discrete_gradient(&self, a: &Vectors<D>, b: &Vectors<D>, t: f64, out: &mut Vectors<D>) {
        out.clear();
        self.add_discrete_gradient(a, b, t, out);
    }
    /// c ∂²Φ/∂q∂q.
    fn add_hessian(&self, c: f64, q: &Vectors<D>, t: f64, out: &mut Matrix<D>);
    /// c (∂²Φ/∂q∂q − ∂F/∂q) w, in one pass over the links and without a matrix: with w = M⁻¹(∇Φ − F) what the kicks of
    /// force-gradient schemes take. Asked for only where no force depends on a velocity.
    fn add_turned(&self, c: f64, q: &Vectors<D>, w: &Vectors<D>, t: f64, out: &mut Vectors<D>);
    /// ∂∇̄Φ(a, b)/∂b.
    fn add_discrete_jacobian(&self, a: &Vectors<D>, b: &Vectors<D>, t: f64, out: &mut Matrix<D>);
    /// −c (∂F/∂q + rate ∂F/∂v).
    fn subtract_force_jacobian(&self, c: f64, q: &Vectors<D>, v: &Vectors<D>, t: f64, rate: f64, out: &mut Matrix<D>);
    /// ∇Φ(q) and ∂²Φ/∂q∂q for the bodies of a chain from `first` on. Not asked where bonds or pairs act.
    fn add_stencil(&self, q: &Vectors<D>, t: f64, first: usize, out: &mut Stencil<D>);
    /// ∇̄Φ(a, b) and ∂∇̄Φ(a, b)/∂b for the same.
    fn add_discrete_stencil(&self, a: &Vectors<D>, b: &Vectors<D>, t: f64, first: usize, out: &mut Stencil<D>);
    /// How fast everything moves that is linked or in a field: ω¹² = Σ ω_l¹², in O(links).
    ///
    /// A link is a particle of reduced mass at q_a − q_b and a field acts on each body by itself, both with the accelerations
    /// of the whole scene; bodies that are pinned have infinite mass. [`Frequency::of`] and, of a link, [`Frequency::between`] have ω_l.
    fn frequency(&self, at: &Moving<'_, D>) -> Frequency;
    /// The time scale of a scene: ω¹² = Σ ω_l¹² + ω_least¹², and how ω grows. Under v → −v ω is even and its growth odd, to
    /// the bit, while no force depends on a velocity.
    fn look(&self, at: &Moving<'_, D>) -> Look {
        self.frequency(at).look(at.least)
    }
    /// Every pair of bodies that the Jacobian links; how far apart in the order of bodies says which solver fits.
    fn links(&self, bodies: usize) -> Topology;
    /// Every number that makes this what it is, by name: the fields of the laws, what they read of the bodies, listed links.
    #[doc(hidden)]
    fn fields(&self, see: &mut dyn FnMut(&'static str, f64));
    /// Compares laws of one body with their authors' methods on every body, where it is and how fast, and around the first. Laws between
    /// bodies are compared when they are [prepared](Term::prepare): what bodies carry is not kept.
    ///
    /// # Errors
    /// [`Error::NotAsWritten`]
    #[doc(hidden)]
    fn as_written(&self, _bodies: &dyn Fn(usize) -> [[f64; D]; 2], _t: f64) -> Result<(), Error> {
        Ok(())
    }
    /// The first link or body on which what acts is not finite at q, or ∇̄Φ from another position to q.
    fn fault(&self, from: Option<&Vectors<D>>, q: &Vectors<D>, v: &Vectors<D>, t: f64) -> Option<Fault>;
}

/// Terms whose laws can be found by their type.
pub trait Laws {
    /// The first law of a type: of those that are one for all, or, on a body, of those that each body has of its own.
    fn law(&mut self, of: TypeId, on: Option<usize>) -> Option<&mut dyn Any>;
}

/// The law, if it is of the type.
fn if_of<X: 'static>(law: &mut X, of: TypeId) -> Option<&mut dyn Any> {
    (TypeId::of::<X>() == of).then_some(law)
}

/// Where what acts is not finite.
#[derive(Clone, Copy, Debug, PartialEq)]
pub enum Fault {
    /// Between two bodies.
    Link {
        /// The first body.
        a: usize,
        /// The second body.
        b: usize,
        /// Their distance.
        distance: f64,
    },
    /// On one body.
    Body {
        /// The body.
        body: usize,
        /// A component of the force, or the potential.
        value: f64,
        /// Where the body is.
        place: Place,
    },
    /// The path that a body is driven along.
    Path {
        /// The body.
        body: usize,
        /// The time at which it is not finite.
        at: f64,
    },
}
