//! Leap-frog.

use super::Method;
use super::splitting::{First, Splitting};
use crate::invariant::{Invariant, Kept};

/// Leap-frog: positions at whole steps, velocities at half steps (Greenspan (3.2)–(3.6); Kanatani (2.14)–(2.15)).
///
/// ```text
/// v½ = v + (h/2) a(q);   then   q′ = q + h v½,   v½′ = v½ + h a(q′)
/// ```
///
/// | order | energy | angular momentum | symplectic | reversible | per step |
/// |---|---|---|---|---|---|
/// | 2 | bounded, O(h²) | exact | yes | yes | 1 force |
///
/// The velocity of a state is the mean of the two half steps around it. It is computed only when a state is asked for; the half-step
/// velocities themselves are in [`SplittingMemory`](crate::scheme::SplittingMemory). Work is F_k·(q_{k+1} − q_{k−1})/2, with the kinetic
/// energy of the half steps, as Greenspan §3 suggests and Kanatani (3.3) carries out.
///
/// ```
/// use dmech_core::prelude::*;
#[doc = include_str!("../examples/quartic.md")]
/// let quartic = Simulation::new(Quartic { k: 1.7 }, State::new([1.0], [0.3]));
/// // The energy goes to and fro: by as much in 100 000 steps as in a hundred.
/// for end in [10.0, 10_000.0] {
///     let run = quartic.clone().scheme(Leapfrog).dt(0.1).run_until(end)?;
///     let moved = run.drift(Invariant::Energy).unwrap().max_relative();
///     assert!(4e-3 < moved && moved < 5e-3);
/// }
/// # Ok::<(), Box<dyn std::error::Error>>(())
/// ```
///
/// # Requires
/// Forces that do not depend on the velocity (Greenspan §3, last sentence).
/// # Reference
/// D. Greenspan, Univ. of Wisconsin, Computer Sciences TR 122 (1971), §3.
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq)]
pub struct Leapfrog;

impl Method for Leapfrog {
    const NAME: &'static str = "Leapfrog";
    const ORDER: u32 = 2;
    const SYMMETRIC: bool = true;

    fn keeps(invariant: Invariant) -> Kept {
        match invariant {
            Invariant::Energy => Kept::Bounded,
            Invariant::WorkEnergy | Invariant::AngularMomentum | Invariant::LinearMomentum => Kept::Exact,
            Invariant::DiscreteEnergy => Kept::No,
        }
    }
}

/// One drift and one kick: half a kick, a drift, half a kick, of which two are made as one.
impl Splitting<1> for Leapfrog {
    const FIRST: First = First::Kick;
    const DRIFTS: [f64; 1] = [1.0];
    const KICKS: [f64; 1] = [0.5];
}
