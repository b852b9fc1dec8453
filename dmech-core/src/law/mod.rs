//! What a scheme needs to know of a law.

#[cfg(feature = "scene")]
mod cut_off;
mod differences;
mod field;
mod fields;
mod masses;
mod numbers;
mod optional;
mod pair;
mod perhaps;
mod potential;
#[doc(hidden)]
pub mod radial;
pub mod rotation;
#[doc(hidden)]
pub mod written;

#[cfg(feature = "scene")]
pub use cut_off::CutOff;
pub use field::Field;
pub use fields::{Fields, Numbered, PairFields};
pub use masses::Masses;
pub use numbers::Numbers;
#[cfg(feature = "scene")]
pub use pair::LinkLaw;
pub use pair::{Between, PairLaw, Reads, Symmetric};
pub use potential::{Force, Potential};

use dmech_scalar::Real;

use written::Written;

/// The derivation of a law in readable mathematics, written by the macro.
pub trait Derivation {
    /// Potential, gradient, Hessian, discrete gradient, force, the structure that was found, and what the kernels cost.
    fn derivation(&self) -> &'static str;
}

/// Nothing but the potential acts: no `#[force]`, no time, no mass in the law.
///
/// A potential written by hand declares it with `impl Conservative for MyLaw {}` and is then a [`Law`].
#[diagnostic::on_unimplemented(
    message = "`{Self}` is not known to be a conservative law",
    note = "a potential written by hand becomes a law with `impl Conservative for {Self} {{}}`"
)]
pub trait Conservative {}

/// The force does not depend on the velocity, so that positions and velocities may stand half a step apart
/// (Greenspan §3, last sentence).
#[diagnostic::on_unimplemented(
    message = "the force of `{Self}` depends on the velocity, and this scheme has no velocity where it needs the force",
    label = "this scheme cannot step a velocity-dependent force",
    note = "leap-frog, Kanatani's scheme, `Nystrom`, `RungeKuttaNystrom`, `Relaxed` and `ForceGradient` kick at a position, where they have no velocity of that time",
    note = "use `Boris` where the force is linear in the velocity, else `Gauss::order16()`, `DiscreteGradient`, `Implicit` or `Explicit`"
)]
pub trait VelocityIndependent {}

#[diagnostic::do_not_recommend]
impl<P: Conservative> VelocityIndependent for P {}

/// The force on a body is linear in its own velocity, F = f + S v, and depends on no other: v × B, a friction −c v, or no
/// velocity at all. [`Boris`](crate::Boris) steps it without an equation.
///
/// `#[dmech::law]` finds it in the expression: ∂²F/∂v∂v = 0.
#[diagnostic::on_unimplemented(
    message = "the force of `{Self}` is not linear in the velocity of each body by itself",
    label = "`Boris` cannot step this force",
    note = "`Boris` solves for the mean velocity of each body by itself, in closed form: v × B and −c v can be had so, |v| v and a friction between two bodies cannot",
    note = "use `Gauss::order16()`, `DiscreteGradient`, `Implicit` or `Explicit` for this law"
)]
pub trait LinearInVelocity {}

#[diagnostic::do_not_recommend]
impl<P: Conservative> LinearInVelocity for P {}

/// The law does not name the mass `m`, so that each coordinate may have a mass of its own
/// ([`Simulation::masses`](crate::Simulation::masses)).
#[diagnostic::on_unimplemented(
    message = "`{Self}` names the mass `m`, which is one number, and here each coordinate has its own",
    label = "this law has one mass",
    note = "give the masses that the law needs as fields of `{Self}`, or set one mass with `.mass(m)`",
    note = "a scene as one law has the masses of its bodies"
)]
pub trait MassIndependent {}

#[diagnostic::do_not_recommend]
impl<P: Conservative> MassIndependent for P {}

/// A law that a simulation can run: at each moment, for each mass, it is a [`Field`].
///
/// Every [`Conservative`] potential is a law that is the same at all times and for all masses; a law with a force, or
/// one that names `t` or `m`, gives the field that acts then.
#[diagnostic::on_unimplemented(
    message = "`{Self}` is not a law in {D} coordinates over `{R}`",
    note = "declare one with `#[dmech::law]` and a `#[potential]` or a `#[force]` of a position with {D} coordinates",
    note = "a potential written by hand (`impl Potential<{D}> for …`) also needs `impl Conservative for … {{}}`",
    note = "a law between two bodies acts in a scene, `Scene::new().body(m, q, v).body(m, q, v).pairs(law)`, and `Simulation::scene(scene)` moves it"
)]
pub trait Law<const D: usize, R: Real = f64> {
    /// What acts at one moment.
    type Field<'a>: Field<D, R>
    where
        Self: 'a;

    /// The law does not name the time.
    const AUTONOMOUS: bool = true;

    /// The coordinates are those of bodies with so many each, one body after another; of one body, if nothing is said.
    const BODY: usize = D;
    /// Σ m v over the bodies is kept: they act on each other alone, with opposite forces.
    const LINEAR_MOMENTUM: bool = false;
    /// Σ m (q v − v q) over the bodies is kept. Of one body this is said by [`Potential::CENTRAL`].
    const ANGULAR_MOMENTUM: bool = false;

    /// No coordinate is that of a test body, which counts in no energy: no weight is 0.
    #[doc(hidden)]
    const ALL_COUNT: bool = true;

    /// The names of the law's own invariants, the first [`MAX_OWN`](crate::extend::MAX_OWN) of which a run watches:
    /// the methods that are marked `#[invariant]`.
    const INVARIANTS: &'static [&'static str] = &[];

    /// What acts on a particle of mass `mass` at time `t`.
    fn field(&self, mass: R, t: R) -> Self::Field<'_>;

    /// The value of the k-th of [`INVARIANTS`](Law::INVARIANTS).
    fn invariant(&self, _k: usize, _q: [R; D], _v: [R; D], _t: R) -> R {
        R::ZERO
    }

    /// Why it cannot be run, if it cannot.
    #[doc(hidden)]
    fn refused(&self) -> Option<crate::error::Error> {
        None
    }

    /// A coordinate that stays where it is, whatever acts: of a body that is pinned. Its row of all that acts is 0.
    #[doc(hidden)]
    fn pinned(&self, _i: usize) -> bool {
        false
    }

    /// The mass of each coordinate over that of the particle: 1, except in [`Masses`](crate::Masses).
    #[inline(always)]
    fn mass_ratios(&self) -> [f64; D] {
        [1.0; D]
    }

    /// By which each coordinate counts in energies, momenta and work, in the scalar in use: the same, and 0 for test bodies.
    #[doc(hidden)]
    #[inline(always)]
    fn weights(&self) -> [R; D] {
        self.mass_ratios().map(R::from_f64)
    }

    /// The methods that a macro has made this of; a law written by hand is its own.
    #[doc(hidden)]
    fn written(&self) -> Option<&dyn Written<D>> {
        None
    }

    /// The numbers that make the law what it is, by name, as far as they are known.
    #[doc(hidden)]
    fn tell(&self, see: &mut dyn FnMut(&'static str, f64)) {
        if let Some(written) = self.written() {
            written.fields(see);
        }
    }
}

#[diagnostic::do_not_recommend]
impl<const D: usize, R: Real, P: Potential<D, R> + Conservative> Law<D, R> for P {
    type Field<'a>
        = &'a P
    where
        P: 'a;

    #[inline(always)]
    fn field(&self, _mass: R, _t: R) -> &P {
        self
    }
}
