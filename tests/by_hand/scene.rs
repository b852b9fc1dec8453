//! Scenes with laws written by hand.

use std::time::Instant;

use crate::gravity::Gravity;
use crate::refusals::Bowl;
use dmech_core::prelude::*;
use dmech_core::{Between, PairLaw, Reads, Real, Symmetric};
use dmech_tests::memory::peak;

/// A star and two planets that stay apart. Where bodies meet, the last digit of a step decides how closely, and whether the
/// meeting is too fast for the step.
fn triple() -> Scene<3> {
    Scene::new().body(1.0, [1.2, 0.0, 0.2], [0.0, 2.4, 0.0]).body(6.0, [0.0, 0.1, 0.0], [0.0, -0.15, 0.02]).body(
        0.5,
        [0.0, 4.0, -0.5],
        [-1.4, 0.0, 0.1],
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

#[test]
fn the_csv_of_a_scene_names_bodies_and_components() {
    let run = Simulation::scene(triple().pairs(Gravity { g: 1.3 })).scheme(Leapfrog).dt(0.003).record_every(2).run(5);
    let run = run.unwrap();
    let mut bytes = Vec::new();
    run.write_csv(&mut bytes).unwrap();
    let text = String::from_utf8(bytes).unwrap();
    let mut lines = text.lines();
    let names = "t,q0_0,q0_1,q0_2,q1_0,q1_1,q1_2,q2_0,q2_1,q2_2,v0_0,v0_1,v0_2,v1_0,v1_1,v1_2,v2_0,v2_1,v2_2";
    assert_eq!(lines.next(), Some(names));
    let mut rows = 0;
    for (line, state) in lines.zip(run.states()) {
        let row: Vec<f64> = line.split(',').map(|x| x.parse().unwrap()).collect();
        let numbers = [&[state.t], state.q.as_flattened(), state.v.as_flattened()].concat();
        assert_eq!(row, numbers);
        rows += 1;
    }
    assert_eq!((rows, text.lines().count()), (3, 4));
}

/// A pin takes up momentum: what a free scene keeps, a pinned one does not claim.
#[test]
fn a_pinned_scene_claims_no_momenta() {
    let scene = || {
        let bodies = Scene::<2>::new().body(2.0, [0.0, 0.0], [0.0, 0.0]).body(1.0, [1.0, 0.2], [0.0, 1.1]);
        bodies.pairs(Gravity { g: 1.0 })
    };
    for pinned in [false, true] {
        let scene = if pinned { scene().pin(0) } else { scene() };
        let run = Simulation::scene(scene).scheme(DiscreteGradient).dt(0.01).run(100).unwrap();
        for invariant in [Invariant::LinearMomentum, Invariant::AngularMomentum] {
            assert_eq!(run.drift(invariant).is_none(), pinned, "{invariant}");
        }
        assert!(run.drift(Invariant::Energy).unwrap().max_relative() < 1e-14);
    }
}

/// More bodies than a dense matrix of theirs would find room for. Half of them pinned one by one they take as long as free ones:
/// 50 times as long where each body is looked for among the pins.
#[test]
fn explicit_steps_and_pins_take_no_longer_than_the_bodies() {
    let n = 200_000;
    let seconds = |pins: usize| {
        let bodies = (0..n).fold(Scene::<1>::new(), |scene, i| scene.body(1.0, [i as f64], [0.0]));
        let scene = (0..pins).fold(bodies, |scene, i| scene.pin(2 * i)).chain(Gravity { g: 1.0 });
        let clock = Instant::now();
        let mut stepper = Simulation::scene(scene).scheme(Leapfrog).dt(0.01).stepper().unwrap();
        stepper.step().unwrap();
        let seconds = clock.elapsed().as_secs_f64();
        assert!((0..pins).all(|i| stepper.q().get(2 * i) == [2.0 * i as f64]));
        seconds
    };
    let least = |pins| (0..5).map(|_| seconds(pins)).fold(f64::INFINITY, f64::min);
    let [free, pinned] = [0, n / 2].map(least);
    println!("free in {free:.4} s, pinned in {pinned:.4} s");
    assert!(pinned < 8.0 * free, "free in {free:.4} s, pinned in {pinned:.4} s");
}

/// Not even for a moment: the matrix of a thousand bodies, each of which attracts each, takes 8 MB.
#[test]
fn explicit_steps_make_no_matrix() {
    let n = 1000;
    let bodies = (0..n).fold(Scene::<1>::new(), |scene, i| scene.body(1.0, [f64::from(i)], [0.0]));
    macro_rules! most {
        ($scheme:expr) => {
            peak(|| {
                let simulation = Simulation::scene(bodies.clone().pairs(Gravity { g: 1e-6 })).scheme($scheme);
                simulation.dt(0.01).stepper().unwrap().step().unwrap();
            })
        };
    }
    for (name, taken) in [
        ("Explicit", most!(Explicit)),
        ("Leapfrog", most!(Leapfrog)),
        ("Nystrom", most!(Nystrom::order4())),
        ("Composed", most!(Composed::order4(Leapfrog))),
    ] {
        println!("{name}: {taken} bytes");
        assert!(taken < 1_000_000, "{name}: {taken} bytes");
    }
    assert!(most!(DiscreteGradient) > 8_000_000, "a matrix is seen where there is one");
}

/// As for one body: an end before the start, a time that stands still, more steps than there are times.
#[test]
fn a_scene_that_cannot_advance_in_time_is_refused() {
    let at = |t| Simulation::scene(triple().at_time(t).pairs(Gravity { g: 1.3 })).scheme(Leapfrog).dt(0.1);
    assert_eq!(at(2.0).run_until(1.0).unwrap_err().cause(), Error::Span { start: 2.0, end: 1.0 });
    let still = Error::TimeStandsStill { time: 1e17, dt: 0.1, next: 16.0 };
    assert_eq!(at(1e17).run(1).unwrap_err().cause(), still);
    assert_eq!(at(1e17).stepper().unwrap_err(), still);
    let mut stepper = at(0.0).stepper().unwrap();
    stepper.advance(2).unwrap();
    assert!(matches!(stepper.advance(u64::MAX), Err(Error::TimeStandsStill { .. })));
    assert_eq!(stepper.steps(), 2);
}

/// Nothing, but for a discrete gradient that is no number where the second distance is above 2.
#[derive(Clone, Copy, Debug)]
struct Loose;

impl<P> Reads<P> for Loose {
    type Numbers = [f64; 0];
    fn numbers(_: f64, _: &P) -> [f64; 0] {
        []
    }
}
impl<P, R: Real> PairLaw<1, P, R> for Loose {
    type Between<'a> = Self;
    fn between(&self, _: [R; 0], _: [R; 0], _: R) -> Self {
        Loose
    }
}
impl<R: Real> Potential<1, R> for Loose {
    fn potential(&self, _: [R; 1]) -> R {
        R::ZERO
    }
    fn gradient(&self, _: [R; 1]) -> [R; 1] {
        [R::ZERO]
    }
    fn hessian(&self, _: [R; 1]) -> [[R; 1]; 1] {
        [[R::ZERO]]
    }
    fn discrete_gradient(&self, _: [R; 1], [b]: [R; 1]) -> [R; 1] {
        [R::select(b.abs().less(R::from_f64(2.0)), || R::ZERO, || R::from_f64(f64::NAN))]
    }
    fn discrete_gradient_jacobian(&self, _: [R; 1], _: [R; 1]) -> [[R; 1]; 1] {
        [[R::ZERO]]
    }
}
impl<R: Real> Between<1, R> for Loose {}
impl Symmetric for Loose {}
impl VelocityIndependent for Loose {}

/// The discrete gradient alone is not a number: where, and whose.
#[test]
fn a_secant_that_is_not_finite_is_named() {
    let bodies = || Scene::<1>::new().body(1.0, [-1.43], [-0.1]).body(2.0, [0.0], [1.0]);
    let bowl = Bowl { broken: &["discrete gradient"] };
    let interrupted = Simulation::scene(bodies().field(bowl)).scheme(DiscreteGradient).dt(0.1).run(100).unwrap_err();
    let Error::Body { body: 1, value, place, step, .. } = interrupted.cause() else { panic!("{interrupted}") };
    assert!(value.is_nan() && place.first()[0] > 0.5 && place.first()[0] < 0.6, "{interrupted}");
    assert_eq!(step, interrupted.run().steps() + 1);
    let chain = Simulation::scene(bodies().chain(Loose)).scheme(DiscreteGradient).dt(0.1).run(100);
    let pairs = Simulation::scene(bodies().pairs(Loose)).scheme(DiscreteGradient).dt(0.1).run(100);
    for interrupted in [chain.unwrap_err(), pairs.unwrap_err()] {
        let Error::Link { a: 0, b: 1, distance, step, .. } = interrupted.cause() else { panic!("{interrupted}") };
        assert!(distance > 2.0 && distance < 2.2, "{interrupted}");
        assert_eq!((step, interrupted.run().steps()), (6, 5));
    }
}
