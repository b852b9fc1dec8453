//! The mass `m` and the time `t` as arguments.

use super::oracle::agrees;
use dmech::prelude::*;

/// A pulsating sun that pulls on the mass.
#[derive(Clone, Copy)]
struct Pulsar {
    gm: f64,
    omega: f64,
}

#[dmech::law]
impl Pulsar {
    #[potential]
    fn energy(&self, t: f64, q: [f64; 2], m: f64) -> f64 {
        -m * self.gm * (1.0 + 0.3 * (self.omega * t).cos()) / q[0].hypot(q[1])
    }
}

/// The same law at rest.
#[derive(Clone, Copy)]
struct Sun {
    gm: f64,
}

#[dmech::law]
impl Sun {
    #[potential]
    fn energy(&self, q: [f64; 2], m: f64) -> f64 {
        -m * self.gm / q[0].hypot(q[1])
    }
}

const PULSAR: Pulsar = Pulsar { gm: 1.3, omega: 2.1 };
const SUN: Sun = Sun { gm: 1.3 };

fn start() -> State<2> {
    State::new([0.9, 0.2], [-0.1, 1.1])
}

#[test]
fn a_law_gives_the_potential_of_one_moment() {
    for (m, t) in [(1.0, 0.0), (1.7, 0.4), (0.3, -2.5)] {
        let field = dmech::Law::<2>::field(&PULSAR, m, t);
        agrees("pulsar", &field, |q| PULSAR.energy(t, q, m), [0.9, 0.4], 0.4);
        let field = dmech::Law::<2>::field(&SUN, m, t);
        agrees("sun", &field, |q| SUN.energy(q, m), [0.9, 0.4], 0.4);
    }
}

/// A law that names the time keeps no energy and promises none; one that names the mass does.
#[test]
fn what_depends_on_time_has_no_energy_to_keep() {
    fn check<S: Scheme<Particle<Pulsar, 2>> + Scheme<Particle<Sun, 2>>>(scheme: S) {
        let moving = Simulation::new(PULSAR, start()).mass(1.7).scheme(scheme).dt(0.01).run(500).unwrap();
        assert!(moving.drift(Invariant::Energy).is_none() && moving.drift(Invariant::DiscreteEnergy).is_none());
        // The force is along q at all times.
        assert!(moving.drift(Invariant::AngularMomentum).is_some());
        let resting = Simulation::new(SUN, start()).mass(1.7).scheme(scheme).dt(0.01).run(500).unwrap();
        assert!(resting.drift(Invariant::Energy).is_some());
    }
    check(Explicit);
    check(Leapfrog);
    check(Implicit);
    check(DiscreteGradient);
    check(Kanatani);
    let run = Simulation::new(SUN, start()).mass(1.7).scheme(DiscreteGradient).dt(0.01).run(5000).unwrap();
    assert!(run.drift(Invariant::Energy).unwrap().max_relative() < 1e-14);
}

/// All masses fall alike where the potential is proportional to the mass; the mass of the simulation is the law's `m`.
#[test]
fn the_mass_of_the_simulation_reaches_the_law() {
    fn end<S: Scheme<Particle<Pulsar, 2>>>(scheme: S, mass: f64) -> [f64; 2] {
        Simulation::new(PULSAR, start()).mass(mass).scheme(scheme).dt(0.01).run(300).unwrap().last().q
    }
    fn check<S: Scheme<Particle<Pulsar, 2>>>(scheme: S) {
        let (light, heavy) = (end(scheme, 0.4), end(scheme, 3.1));
        for i in 0..2 {
            assert!((light[i] - heavy[i]).abs() < 1e-12, "{}: {light:?} {heavy:?}", S::NAME);
        }
    }
    check(Explicit);
    check(Leapfrog);
    check(Implicit);
    check(DiscreteGradient);
    check(Kanatani);
}

/// The second order is that of the law with its time, and not of one that is frozen: halving the step quarters the error.
#[test]
fn the_time_of_each_step_reaches_the_law() {
    fn order<S: Scheme<Particle<Pulsar, 2>>>(scheme: S) -> f64 {
        let end = |steps: u64| {
            let run = Simulation::new(PULSAR, start()).scheme(scheme).dt(1.0 / steps as f64).run(steps).unwrap();
            run.last().q
        };
        let distance = |a: [f64; 2], b: [f64; 2]| (a[0] - b[0]).hypot(a[1] - b[1]);
        let [one, two, four] = [400, 800, 1600].map(end);
        (distance(one, two) / distance(two, four)).log2()
    }
    for (order, declared) in [
        (order(Explicit), 1.0),
        (order(Leapfrog), 2.0),
        (order(Implicit), 2.0),
        (order(DiscreteGradient), 2.0),
        (order(Kanatani), 2.0),
    ] {
        assert!((order - declared).abs() < 0.05, "{order}");
    }
}
