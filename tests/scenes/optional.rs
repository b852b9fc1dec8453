//! Laws between bodies that are there or not.

use dmech::models::pairs::{Charge, Coulomb, Gravity, LennardJones, Spring};
use dmech::prelude::*;
use dmech_tests::few::Damper;

const SPRING: Spring = Spring { k: 3.0, length: 0.9 };

fn bodies() -> Scene<2> {
    (0..11).fold(Scene::new(), |scene, i| {
        let x = f64::from(i);
        scene.body(0.6 + 0.1 * x, [0.8 * x, 0.3 * (2.1 * x).sin()], [0.2 * (1.3 * x).cos(), 0.1 * x.sin()])
    })
}

macro_rules! same {
    ($one:expr, $other:expr, $($scheme:expr),*) => {$({
        let run = |scene| Simulation::scene(scene).scheme($scheme).dt(0.01).run(60).unwrap();
        let (one, other) = (run($one), Simulation::scene($other).scheme($scheme).dt(0.01).run(60).unwrap());
        assert_eq!(one.last(), other.last(), "{}", stringify!($scheme));
        assert_eq!(one.drift(Invariant::Energy), other.drift(Invariant::Energy), "{}", stringify!($scheme));
        assert_eq!(one.drift(Invariant::AngularMomentum), other.drift(Invariant::AngularMomentum));
    })*};
}

/// A law that is there is stepped as it would be alone, to the bit; one that is not there is nothing.
#[test]
fn some_law_is_the_law() {
    let bonds = || [(0, 3), (2, 7), (9, 1)];
    same!(bodies().chain(Some(SPRING)), bodies().chain(SPRING), Leapfrog, Implicit, DiscreteGradient, Kanatani);
    same!(bodies().pairs(Some(SPRING)), bodies().pairs(SPRING), Leapfrog, DiscreteGradient, ForceGradient::order4());
    same!(bodies().bonds(Some(SPRING), bonds()), bodies().bonds(SPRING, bonds()), Implicit, DiscreteGradient);
    let atoms = LennardJones { epsilon: 0.2, sigma: 0.6 };
    same!(
        bodies().pairs(Some(atoms)).cutoff(1.5).periodic([9.0; 2]),
        bodies().pairs(atoms).cutoff(1.5).periodic([9.0; 2]),
        Leapfrog,
        DiscreteGradient
    );
    let damper = Damper { c: 0.4 };
    same!(
        bodies().chain(SPRING).chain(Some(damper)),
        bodies().chain(SPRING).chain(damper),
        Explicit,
        Implicit,
        DiscreteGradient
    );
    let gravity = Gravity { g: 0.4 };
    same!(
        bodies().pairs(gravity).chain(None::<Spring>).bonds(None::<Damper>, bonds()),
        bodies().pairs(gravity).chain(Spring { k: 0.0, length: 0.9 }).bonds(Damper { c: 0.0 }, bonds()),
        Explicit,
        Implicit
    );
}

/// Within a cut-off too, where the law stands in another one.
#[test]
fn a_law_that_is_cut_off_is_found() {
    let atoms = LennardJones { epsilon: 0.2, sigma: 0.6 };
    let boxed = |law: Option<LennardJones>| bodies().pairs(law).cutoff(1.5).periodic([9.0; 2]);
    let mut stepper = Simulation::scene(boxed(None)).scheme(DiscreteGradient).dt(0.01).stepper().unwrap();
    stepper.advance(40).unwrap();
    *stepper.law_mut::<Option<LennardJones>>().unwrap() = Some(atoms);
    let now = stepper.state();
    stepper.advance(60).unwrap();
    let run = Simulation::scene(boxed(Some(atoms)).starting_from(&now)).scheme(DiscreteGradient).dt(0.01).run(60);
    assert_eq!(run.unwrap().last().q, stepper.state().q);
    assert!(stepper.law_mut::<Spring>().is_none() && stepper.law_mut::<LennardJones>().is_none());

    let plain = bodies().pairs(atoms).cutoff(1.5);
    let mut stepper = Simulation::scene(plain).scheme(Leapfrog).dt(0.01).stepper().unwrap();
    stepper.law_mut::<LennardJones>().unwrap().epsilon = 0.0;
    let start = stepper.state();
    stepper.advance(10).unwrap();
    assert_eq!(stepper.state().v, start.v);
}

/// A bond that breaks and one that forms, on the way: from then on it is the motion of the scene without it or with it, also
/// where the law reads what the bodies carry.
#[test]
fn laws_come_and_go() {
    let ions = || {
        (0..5).fold(Scene::<2, Charge>::new(), |scene, i| {
            let x = f64::from(i);
            let q = if i % 2 == 0 { 0.7 } else { -0.4 };
            scene.body_with(1.0 + 0.1 * x, [1.1 * x, 0.2 * x * x], [0.1 * x.sin(), 0.0], Charge { q })
        })
    };
    let coulomb = Coulomb { k: 0.8 };
    let mut stepper = Simulation::scene(ions().pairs(None::<Coulomb>).chain(Some(SPRING)))
        .scheme(DiscreteGradient)
        .dt(0.02)
        .stepper()
        .unwrap();
    stepper.advance(50).unwrap();
    *stepper.law_mut::<Option<Coulomb>>().unwrap() = Some(coulomb);
    *stepper.law_mut::<Option<Spring>>().unwrap() = None;
    let now = stepper.state();
    let energy = stepper.energy().unwrap();
    // Up to where two of them meet.
    stepper.advance(25).unwrap();
    let alone = Simulation::scene(ions().pairs(coulomb).starting_from(&now)).scheme(DiscreteGradient).dt(0.02);
    let run = alone.run(25).unwrap();
    let apart = |x: &[[f64; 2]], y: &[[f64; 2]]| {
        x.iter().flatten().zip(y.iter().flatten()).map(|(x, y)| (x - y).abs()).fold(0.0, f64::max)
    };
    assert!(apart(&run.last().q, &stepper.state().q) < 1e-13);
    assert!((stepper.energy().unwrap() - energy).abs() < 1e-14);
    assert!(apart(&now.q, &run.last().q) > 0.05);
}
