//! Scenes with laws written by hand.
#![cfg(feature = "scene")]

use dmech_core::Real;
use dmech_core::prelude::*;
use dmech_core::{Between, PairLaw, Reads, Symmetric, radial};

/// Φ = −G ma mb/r.
#[derive(Clone, Copy, Debug)]
struct Gravity {
    g: f64,
}

#[derive(Clone, Copy, Debug)]
struct Attraction<R>(R);

impl<P> Reads<P> for Gravity {
    type Numbers = [f64; 1];
    fn numbers(&self, mass: f64, _: &P) -> [f64; 1] {
        [mass]
    }
}

impl<const D: usize, P, R: Real> PairLaw<D, P, R> for Gravity {
    type Between<'a> = Attraction<R>;
    fn between(&self, [ma]: [R; 1], [mb]: [R; 1], _: R) -> Attraction<R> {
        Attraction(R::from_f64(self.g) * ma * mb)
    }
}

impl<const D: usize, R: Real> Potential<D, R> for Attraction<R> {
    const CENTRAL: bool = true;
    fn potential(&self, d: [R; D]) -> R {
        -self.0 / radial::square(d).sqrt()
    }
    fn gradient(&self, d: [R; D]) -> [R; D] {
        let s = radial::square(d);
        radial::gradient(self.0 / (s * s.sqrt()), d)
    }
    fn hessian(&self, d: [R; D]) -> [[R; D]; D] {
        let s = radial::square(d);
        let c = self.0 / (s * s.sqrt());
        radial::hessian(c, R::from_f64(-1.5) * c / s, d)
    }
    fn discrete_gradient(&self, a: [R; D], b: [R; D]) -> [R; D] {
        let (x, y) = (radial::square(a).sqrt(), radial::square(b).sqrt());
        radial::discrete_gradient(self.0 / (x * y * (x + y)), a, b)
    }
    fn discrete_gradient_jacobian(&self, a: [R; D], b: [R; D]) -> [[R; D]; D] {
        let (x, y) = (radial::square(a).sqrt(), radial::square(b).sqrt());
        let c = self.0 / (x * y * (x + y));
        radial::discrete_gradient_jacobian(c, -c * (x + y + y) / ((y + y) * y * (x + y)), a, b)
    }
}
impl<const D: usize, R: Real> Between<D, R> for Attraction<R> {}
impl Symmetric for Gravity {}
impl VelocityIndependent for Gravity {}

fn triple() -> Scene<3> {
    Scene::new().body(1.0, [1.2, 0.0, 0.2], [0.0, 1.05, 0.0]).body(6.0, [0.0, 0.1, 0.0], [0.0, -0.15, 0.02]).body(
        0.5,
        [0.0, 4.0, -0.5],
        [-1.2, 0.0, 0.1],
    )
}

#[test]
fn the_energy_exact_schemes_keep_everything() {
    let run = Simulation::scene(triple().pairs(Gravity { g: 1.3 })).scheme(DiscreteGradient).dt(0.003).run(100_000);
    let run = run.unwrap();
    println!("{run}");
    assert!(run.drift(Invariant::Energy).unwrap().max_relative() < 1e-12);
    assert!(run.drift(Invariant::LinearMomentum).unwrap().max_abs() < 1e-12);
    assert!(run.drift(Invariant::AngularMomentum).unwrap().max_relative() < 1e-12);
    assert!(run.drift(Invariant::WorkEnergy).unwrap().max_relative() < 1e-11);
    let run = Simulation::scene(triple().pairs(Gravity { g: 1.3 })).scheme(Kanatani).dt(0.003).run(100_000).unwrap();
    println!("{run}");
    assert!(run.drift(Invariant::DiscreteEnergy).unwrap().max_relative() < 1e-12);
    for run in [
        Simulation::scene(triple().pairs(Gravity { g: 1.3 })).scheme(Implicit).dt(0.003).run(10_000).unwrap(),
        Simulation::scene(triple().pairs(Gravity { g: 1.3 })).scheme(Leapfrog).dt(0.003).run(10_000).unwrap(),
        Simulation::scene(triple().pairs(Gravity { g: 1.3 })).scheme(Explicit).dt(0.003).run(10_000).unwrap(),
    ] {
        println!("{run}");
        assert!(run.drift(Invariant::WorkEnergy).unwrap().max_relative() < 1e-11);
    }
}
