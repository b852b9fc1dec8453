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

/// q + ℓ exp(−q/ℓ): a floor as stiff as a step of a tenth of a fall is long.
#[derive(Clone, Copy, Debug)]
struct Soft {
    l: f64,
}

#[dmech::law]
impl Soft {
    #[potential]
    fn energy(&self, q: f64) -> f64 {
        q + self.l * (-q / self.l).exp()
    }
}

/// A hard floor with a kink.
#[derive(Clone, Copy, Debug)]
struct Floor {
    k: f64,
}

#[dmech::law]
impl Floor {
    #[potential]
    fn energy(&self, q: f64) -> f64 {
        if q < 0.0 { q + 0.5 * self.k * q * q } else { q }
    }
}

/// In a stiff contact an ulp of the step is many of the energy. h² and h v must be rounded to no side there: of steps of most lengths
/// they were, and the energy moved by 2·10⁻¹² to 2·10⁻¹¹ in as many steps.
#[test]
fn a_ball_on_a_stiff_floor() {
    const STEPS: u64 = 200_000;
    fn moved<L: dmech::extend::Fields<1> + dmech::Law<1> + Copy + Sync>(law: L, dt: f64) -> f64 {
        let (q, v) = ([1.0], [0.0]);
        let alone = Simulation::new(law, State::new(q, v)).dt(dt).record_every(STEPS);
        let scene = Simulation::scene(Scene::<1>::new().body(1.0, q, v).field(law)).dt(dt).record_every(STEPS);
        let of =
            |drift: Option<dmech::Drift>| drift.map_or(f64::NAN, |drift| (drift.last() / drift.start() - 1.0).abs());
        let alone = of(alone.scheme(DiscreteGradient).run(STEPS).unwrap().drift(Invariant::Energy));
        let scene = of(scene.scheme(DiscreteGradient).run(STEPS).unwrap().drift(Invariant::Energy));
        println!("{dt}: {alone:.1e} alone, {scene:.1e} in a scene");
        alone.max(scene)
    }
    for dt in [0.1, 0.2] {
        let moved = moved(Soft { l: 0.01 }, dt);
        assert!(moved < 1e-12, "h = {dt}: {moved:e}");
    }
    for dt in [0.1, 0.2] {
        let moved = moved(Floor { k: 1e4 }, dt);
        assert!(moved < 2e-12, "h = {dt}: {moved:e}");
    }
}
