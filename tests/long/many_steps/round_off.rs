//! Rounding makes the energy walk at random: its error grows like the square root of the number of steps (Brouwer's law), and
//! not like the number of steps, as it would if rounding did work of one sense. `examples/round_off.rs` shows all schemes.

#[path = "../../../examples/shared/growth.rs"]
mod growth;

use dmech::extend::Method;
use dmech::prelude::*;
use growth::{Any, Motion};

/// Half of an ulp of the energy does a step lose at most; what adds up to more than √n of them has a mean.
fn walks<S: Any + Method + Send>(motion: Motion, scheme: S, invariant: Invariant, decades: u32) {
    let (n, name) = (10_u64.pow(decades), S::NAME);
    let error = motion.error(scheme, invariant, n).unwrap();
    let in_ulps = error / (f64::EPSILON * (n as f64).sqrt());
    println!("{:<14} {name:<40} {error:.1e} after {n:.0e}: {in_ulps:.3} √n ulp", motion.name());
    assert!(in_ulps < 0.15 && error > f64::EPSILON, "{name}: {in_ulps} √n ulp");
}

#[test]
fn a_planet() {
    walks(Motion::Kepler, DiscreteGradient, Invariant::Energy, 7);
    walks(Motion::Kepler, Kanatani, Invariant::DiscreteEnergy, 7);
}

/// Newton's corrections of a force are often less than half an ulp of it, and of one sign: rounded away, they would be a drift
/// of 0.23 √n ulp here.
#[test]
fn a_planet_by_a_law_that_is_not_known_to_be_central() {
    walks(Motion::Components, DiscreteGradient, Invariant::Energy, 7);
}

#[test]
fn a_star_in_a_galaxy() {
    walks(Motion::HenonHeiles, DiscreteGradient, Invariant::Energy, 6);
    walks(Motion::HenonHeiles, Kanatani, Invariant::DiscreteEnergy, 6);
    walks(Motion::HenonHeiles, Composed::order4(DiscreteGradient), Invariant::Energy, 6);
}

#[test]
fn a_chain() {
    walks(Motion::Chain, DiscreteGradient, Invariant::Energy, 6);
    walks(Motion::Chain, Kanatani, Invariant::DiscreteEnergy, 6);
}
