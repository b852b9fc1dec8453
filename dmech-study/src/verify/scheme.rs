//! A scheme put through its checks.

use dmech_core::extend::{Particle, Scheme};
use dmech_core::{Simulation, State};
#[cfg(feature = "scene")]
use dmech_core::{extend::Setup, scene::Scene};

use super::bowl::Bowl;
use super::report::{Check, Verification};
use super::trial::Trial;
use crate::motion::{Repeatable, Scales};

/// The scene that a scheme is verified in.
#[cfg(feature = "scene")]
type Trio = Scene<2, (), ((), dmech_core::scene::OnPairs<Bowl>)>;

/// A scheme for one law in one and in two coordinates, and for a scene: those that [`verify_scheme`] takes.
#[cfg(feature = "scene")]
pub trait Tested: Scheme<Particle<Bowl, 1>> + Scheme<Particle<Bowl, 2>> + Scheme<<Trio as Setup<()>>::System> {}

#[cfg(feature = "scene")]
impl<S> Tested for S where S: Scheme<Particle<Bowl, 1>> + Scheme<Particle<Bowl, 2>> + Scheme<<Trio as Setup<()>>::System>
{}

/// A scheme for one law in one and in two coordinates: those that [`verify_scheme`] takes.
#[cfg(not(feature = "scene"))]
pub trait Tested: Scheme<Particle<Bowl, 1>> + Scheme<Particle<Bowl, 2>> {}

#[cfg(not(feature = "scene"))]
impl<S> Tested for S where S: Scheme<Particle<Bowl, 1>> + Scheme<Particle<Bowl, 2>> {}

/// Puts a scheme through its checks: on a nonlinear law in one and in two coordinates, and on three bodies of different masses
/// with that law between any two.
///
/// Measured are the order that it declares, what it says to keep of each invariant, whether it finds the way back if it says
/// to be symmetric.
///
/// ```
/// use dmech_core::prelude::*;
/// dmech_study::verify_scheme(Composed::order4(Implicit)).assert();
/// ```
pub fn verify_scheme<S: Tested>(scheme: S) -> Verification {
    const BOWL: Bowl = Bowl { k: 1.3, l: 0.7 };
    let mut checks = Vec::new();
    let [line, plane] = ["one coordinate", "two coordinates"];
    check(scheme, Simulation::new(BOWL, State::new([0.9], [0.4])).mass(1.7), line, &mut checks);
    check(scheme, Simulation::new(BOWL, State::new([0.9, -0.3], [0.2, 0.8])).mass(0.6), plane, &mut checks);
    #[cfg(feature = "scene")]
    {
        let trio = Scene::new()
            .body(1.0, [1.0, 0.0], [0.0, 0.9])
            .body(0.7, [-1.1, 0.2], [-0.1, -0.8])
            .body(1.9, [0.1, -1.3], [-0.5, 0.0])
            .pairs(BOWL);
        check(scheme, Simulation::scene(trio), "three bodies", &mut checks);
    }
    Verification { of: (), checks }
}

fn check<L: Clone, X: Repeatable<L>, S: Scheme<X::System>>(
    scheme: S,
    motion: Simulation<L, X>,
    name: &str,
    checks: &mut Vec<Check>,
) {
    match motion.clone().scheme(scheme).dt(1e-3).stepper() {
        Ok(stepper) => {
            let scales = Scales::of(stepper.system(), &motion.start());
            Trial { motion, scheme, scales, one_way: None }.check(name, checks);
        }
        Err(error) => checks.push(Check::failed(name, error.to_string())),
    }
}
