//! Scenes whose steps follow the motion.

use approx::relative_eq;
use dmech::extend::{Carried, Saved, Setup};
use dmech::models::pairs::Gravity;
use dmech::prelude::*;

use super::setups::*;

/// Sun, planet, and a comet of eccentricity 0.97.
fn comet() -> Scene<2> {
    let e: f64 = 0.97;
    let speed = ((1.0 + e) / (1.0 - e)).sqrt();
    Scene::new().body(1.0, [0.0, 0.0], [0.0, 0.0]).body(1e-3, [-5.2, 0.0], [0.0, -(1.0_f64 / 5.2).sqrt()]).body(
        1e-9,
        [1.0 - e, 0.0],
        [0.0, speed],
    )
}

/// Burrau's problem: masses 3, 4 and 5 at rest at the corners of the Pythagorean triangle.
fn burrau() -> Scene<2> {
    Scene::new().body(3.0, [1.0, 3.0], [0.0; 2]).body(4.0, [-2.0, -1.0], [0.0; 2]).body(5.0, [1.0, -1.0], [0.0; 2])
}

const GRAVITY: Gravity = Gravity { g: 1.0 };

/// A finer tolerance errs less in the same proportion, and adaptive steps reach an error with fewer forces than equal ones.
#[test]
fn a_comet_is_followed_through_its_pericentre() {
    let adaptive = |tolerance: f64| {
        let run = Simulation::scene(comet().pairs(GRAVITY)).scheme(Nystrom::order8()).adaptive(tolerance);
        run.record_every(1000).run_until(30.0).expect("resolved")
    };
    let exact = adaptive(1e-13);
    let [coarse, fine] = [1e-6, 1e-9].map(|tolerance| (adaptive(tolerance), tolerance));
    let error = |run: &Run<SceneState<2>>| apart(run.last(), exact.last());
    let equal = Simulation::scene(comet().pairs(GRAVITY)).scheme(Nystrom::order8()).dt(0.01).record_every(1000);
    let equal = equal.run_until(30.0).expect("resolved");
    for (run, tolerance) in [&coarse, &fine] {
        println!("tolerance {tolerance:e}: error {:.1e}, {} forces", error(run), run.report().evaluations());
        // At the pericentre what the phase is off is eight times as far as at the start.
        assert!(error(run) < 5e3 * tolerance, "{:e} for {tolerance:e}", error(run));
        let [shortest, longest] = run.report().dt_range().expect("more than one step");
        assert!(longest > 50.0 * shortest, "{shortest} to {longest}: nothing to follow");
    }
    let gain = error(&coarse.0) / error(&fine.0);
    assert!((200.0..5000.0).contains(&gain), "a thousandth of the tolerance gains {gain}");
    println!("equal steps: error {:.1e}, {} forces", error(&equal), equal.report().evaluations());
    assert!(error(&fine.0) < error(&equal) && fine.0.report().evaluations() < equal.report().evaluations() / 4);
}

/// A planet and its sun make the steps that one body of the reduced mass makes in the field of a fixed sun.
#[test]
fn two_bodies_make_the_steps_of_one() {
    let e: f64 = 0.97;
    let speed = ((1.0 + e) / (1.0 - e)).sqrt();
    for tolerance in [1e-5, 1e-7, 1e-9] {
        let law = dmech::models::Kepler { gm: 1.0 };
        let one = Simulation::new(law, State::new([1.0 - e, 0.0], [0.0, speed])).scheme(Nystrom::order8());
        let two = Scene::new().body(0.6, [0.0, 0.0], [0.0, -0.4 * speed]).body(0.4, [1.0 - e, 0.0], [0.0, 0.6 * speed]);
        let two = Simulation::scene(two.pairs(GRAVITY)).scheme(Nystrom::order8());
        let (one, two) =
            (one.adaptive(tolerance).run(300).expect("resolved"), two.adaptive(tolerance).run(300).expect("resolved"));
        assert!(relative_eq!(one.last().t, two.last().t, max_relative = 1e-6), "{} and {}", one.last().t, two.last().t);
        assert!(one.last().t > 6.0);
    }
}

/// Whatever the steps, the energy-exact schemes keep the energy, through all of Burrau's encounters.
#[test]
fn the_pythagorean_problem_ends_with_its_energy() {
    for tolerance in [1e-6, 1e-8] {
        let scene = burrau().pairs(GRAVITY);
        let run = Simulation::scene(scene).scheme(Composed::order6(DiscreteGradient)).adaptive(tolerance);
        let run = run.run_until(70.0).expect("no collision");
        let r = |q: &[[f64; 2]], a: usize, b: usize| (q[a][0] - q[b][0]).hypot(q[a][1] - q[b][1]);
        let closest = |s: &SceneState<2>| r(&s.q, 0, 1).min(r(&s.q, 0, 2)).min(r(&s.q, 1, 2));
        let closest = run.states().iter().map(closest).fold(f64::INFINITY, f64::min);
        let [shortest, longest] = run.report().dt_range().expect("more than one step");
        for invariant in [Invariant::Energy, Invariant::LinearMomentum, Invariant::AngularMomentum] {
            let drift = run.drift(invariant).expect("a closed system");
            let off = (drift.last() - drift.start()).abs();
            println!("{tolerance:e}: {invariant} {off:.1e}, dt from {shortest:.1e} to {longest:.1e}");
            // Rounding is that of the energies in the closest encounter, of masses 4 and 5.
            assert!(closest < 1e-2 && off < 1e-13 * 20.0 / closest, "{invariant}: {off:e}, {closest:e}");
        }
        assert!(longest > 500.0 * shortest);
        println!("closest {closest:.1e}");
    }
    // The lightest is thrown out, the others stay together (V. Szebehely and C. F. Peters, Astron. J. 72 (1967) 876).
    let scene = Simulation::scene(burrau().pairs(GRAVITY)).scheme(Nystrom::order8()).adaptive(1e-12);
    let run = scene.record_every(100_000).run_until(70.0).expect("no collision");
    let q = &run.last().q;
    let r = |a: usize, b: usize| (q[a][0] - q[b][0]).hypot(q[a][1] - q[b][1]);
    println!("at the end {:.2} {:.2} {:.2}, {} forces", r(0, 1), r(0, 2), r(1, 2), run.report().evaluations());
    assert!(r(1, 2) < 1.0 && r(0, 1) > 3.0 && r(0, 2) > 3.0);
}

/// A saved adaptive run of a scene goes on bit for bit, from within a row of equal steps as well.
#[test]
fn saved_steps_go_on() {
    fn check<X, S>(set_up: impl Fn() -> Simulation<(), X, S>)
    where
        X: Setup<()>,
        X::System: Saved<Scalar = f64>,
        X::State: PartialEq,
        S: Scheme<X::System>,
        S::Memory: Carried,
    {
        for first in [0, 1, 7, 150] {
            let mut whole = set_up().stepper().expect("a start");
            whole.advance(first + 200).expect("resolved");
            let mut part = set_up().stepper().expect("a start");
            part.advance(first).expect("resolved");
            let mut resumed = set_up().resume(&part.checkpoint()).expect("the same simulation");
            resumed.advance(200).expect("resolved");
            assert_eq!(resumed.state(), whole.state(), "{} saved after {first}", S::NAME);
            assert_eq!(resumed.evaluations(), whole.evaluations());
        }
    }
    macro_rules! check {
        ($($scheme:expr),*) => {
            $(check(|| Simulation::scene(comet().pairs(GRAVITY)).scheme($scheme).adaptive(1e-7));)*
        };
    }
    check!(DiscreteGradient, Implicit, Composed::order4(DiscreteGradient), Composed::order6(Implicit));
    check!(Composed::order6(Leapfrog), Nystrom::order6(), ForceGradient::order4());
}

/// Bodies that nothing accelerates tell no time scale, as one law does not.
#[test]
fn free_bodies_need_a_longest_step() {
    let scene = || Scene::new().body(1.0, [0.0; 2], [0.1, 0.0]).body(2.0, [1.0, 0.0], [0.0; 2]);
    let free = || Simulation::scene(scene().pairs(Gravity { g: 0.0 })).scheme(Nystrom::order4());
    let refused = free().adaptive(1e-6).run_until(1.0).expect_err("no step").cause();
    assert!(matches!(refused, Error::NoTimeScale { step: 1, .. }), "{refused}");
    assert_eq!(free().dt(0.3).adaptive(1e-6).run_until(1.0).expect("equal steps").last().t, 1.0);
}
