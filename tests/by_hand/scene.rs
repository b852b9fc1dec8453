//! Scenes with laws written by hand.

use crate::gravity::Gravity;
use dmech_core::prelude::*;

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

/// More bodies than a dense matrix of theirs would find room for, half of them pinned one by one.
#[test]
fn explicit_steps_and_pins_take_no_longer_than_the_bodies() {
    let n = 200_000;
    let bodies = (0..n).fold(Scene::<1>::new(), |scene, i| scene.body(1.0, [i as f64], [0.0]));
    let scene = (0..n).step_by(2).fold(bodies, |scene, i| scene.pin(i));
    let clock = std::time::Instant::now();
    let mut stepper = Simulation::scene(scene.chain(Gravity { g: 1.0 })).scheme(Leapfrog).dt(0.01).stepper().unwrap();
    stepper.step().unwrap();
    // Looking for each body among the pins takes a minute here without optimisation.
    assert!(clock.elapsed().as_secs() < 10, "{:?}", clock.elapsed());
    assert!((0..n).step_by(2).all(|i| stepper.q().get(i) == [i as f64]));
}

/// As for one body: an end before the start, a time that stands still, more steps than there are times.
#[test]
fn a_scene_that_cannot_advance_in_time_is_refused() {
    let at = |t| Simulation::scene(triple().at_time(t).pairs(Gravity { g: 1.3 })).scheme(Leapfrog).dt(0.1);
    assert_eq!(at(2.0).run_until(1.0).unwrap_err().cause(), Error::Span { start: 2.0, end: 1.0 });
    let still = Error::TimeStandsStill { time: 1e17, dt: 0.1 };
    assert_eq!(at(1e17).run(1).unwrap_err().cause(), still);
    assert_eq!(at(1e17).stepper().unwrap_err(), still);
    let mut stepper = at(0.0).stepper().unwrap();
    stepper.advance(2).unwrap();
    assert!(matches!(stepper.advance(u64::MAX), Err(Error::TimeStandsStill { .. })));
    assert_eq!(stepper.steps(), 2);
}
