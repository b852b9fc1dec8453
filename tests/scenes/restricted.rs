//! A scene with test bodies as one law: what the scene does, in other roundings.

use dmech::SceneError;
use dmech::extend::{Law, Potential};
use dmech::models::pairs::Gravity;
use dmech::prelude::*;
use dmech::scene::{AmongFew, FewBodies, Sides};

use crate::few::{alike, derivatives, in_double_double, paced, verified};
use dmech_tests::restricted::{TESTS, clones, cords, herds, is_test, tethers, traps, vapours};

#[test]
fn the_same_motion_as_that_of_the_scene() {
    alike! { as_restricted_law:
        "clones": clones, 0..7, 4, 8, [
            Leapfrog, CompensatedLeapfrog, Composed::order6(Leapfrog), Nystrom::order6(), ForceGradient::order4(),
            RungeKuttaNystrom::order12(), Kanatani, Explicit
        ], 0.02, within 1e-11;
        "clones": clones, [0, 1, 4], 4, 8, [
            Implicit, DiscreteGradient, Composed::order6(DiscreteGradient), Gauss::order16(), LineIntegral::order6()
        ], 0.02, within 1e-11;
        "tethers": tethers, 0..10, 4, 8, [Leapfrog, ForceGradient::order4(), Implicit, DiscreteGradient, Gauss::order16()],
            0.01, within 1e-11;
        "cords": cords, 0..7, 4, 4, [Boris, Implicit, DiscreteGradient, Gauss::order16(), Explicit], 0.01, within 1e-11;
        "herds": herds, 0..7, 3, 6, [Explicit, Implicit, DiscreteGradient, Gauss::order16()], 0.02, within 1e-11;
        "traps": traps, 0..7, 3, 6, [Boris, Composed::order4(Boris), Implicit, DiscreteGradient], 0.02, within 1e-11;
        "vapours": vapours, 0..7, 4, 8, [Leapfrog, Nystrom::order6(), ForceGradient::order4(), DiscreteGradient],
            0.005, within 1e-9;
    }
}

/// Steps so long that what is corrected is no rounding: only the bodies that act are.
#[test]
fn test_bodies_are_not_corrected() {
    alike! { as_restricted_law:
        "clones": clones, 0..7, 4, 8, [Relaxed::order6(), Relaxed::order8()], 0.2, within 1e-10;
        "tethers": tethers, 0..7, 4, 8, [Relaxed::order6()], 0.1, within 1e-10;
    }
    // One that may be there counts in the same way.
    for k in [0, 3, 6] {
        let law = clones(k).as_restricted_law::<4, 8>();
        let run = Simulation::new(law, law.start()).scheme(Relaxed::order6()).dt(0.2).run(20).unwrap();
        let perhaps = Simulation::new(Some(law), law.start()).scheme(Relaxed::order6()).dt(0.2).run(20).unwrap();
        assert_eq!(perhaps.last(), run.last());
        let drifts = |run: &Run<State<8>>| Invariant::ALL.map(|invariant| run.drift(invariant));
        assert_eq!(drifts(&perhaps), drifts(&run));
        assert!(run.drift(Invariant::Energy).unwrap().max_abs() < 1e-14);
    }
}

#[test]
fn the_same_time_scale_as_that_of_the_scene() {
    paced! { as_restricted_law:
        clones, 0..7, 4, 8, Nystrom::order6(), 1e-8;
        tethers, 0..7, 4, 8, Nystrom::order6(), 1e-8;
        cords, 0..7, 4, 4, DiscreteGradient, 1e-2;
        herds, 0..7, 3, 6, Gauss::order16(), 1e-9;
        traps, 0..7, 3, 6, DiscreteGradient, 1e-3;
        vapours, 0..7, 4, 8, Nystrom::order6(), 1e-7;
    }
}

/// A test body moves as its mass did not matter under gravity, and its steps are as long: its own mass moves nothing.
#[test]
fn steps_do_not_ask_for_the_mass_of_a_test_body() {
    let star = |mass: f64, first: bool| {
        let scene = Scene::new().body(1.3, [0.0, 0.0], [0.0, 0.0]).body(0.4, [3.0, 0.2], [0.1, 0.6]);
        let (q, v) = ([0.7, 0.1], [-0.2, 1.1]);
        let scene = if first {
            Scene::new().test_body(mass, q, v).body(1.3, [0.0; 2], [0.0; 2])
        } else {
            scene.test_body(mass, q, v)
        };
        scene.pairs(Gravity { g: 1.1 })
    };
    let (light, heavy) = (0.5_f64.powi(14), 2.0_f64.powi(14));
    for first in [true, false] {
        let run = |mass| {
            let run =
                Simulation::scene(star(mass, first)).scheme(Nystrom::order6()).adaptive(1e-8).run_until(5.0).unwrap();
            (run.last().clone(), run.report().steps())
        };
        assert_eq!(run(light), run(heavy));
        assert!(run(1.0).1 > 20);
    }
    let run = |mass| {
        let law = star(mass, false).as_restricted_law::<3, 6>();
        let run = Simulation::new(law, law.start()).scheme(Nystrom::order6()).adaptive(1e-8).run_until(5.0).unwrap();
        (*run.last(), run.report().steps())
    };
    assert_eq!(run(light), run(heavy));
}

/// Rows of a Jacobian where the body of the row feels that of the column, and no others.
#[test]
fn derivatives_are_those_of_the_sums() {
    // Four bodies in the plane, of which t are test bodies: blocks on the diagonal, and of those that act the columns.
    let blocks = |n: usize, t: usize| if t == n { 0 } else { n - usize::from(n - t == 1) + (n - t) * (n - 1) };
    for k in 0..7 {
        let tests = TESTS[k].len();
        // The Hessian, and the Jacobian of the secant.
        assert_eq!(derivatives(&clones(k).as_restricted_law::<4, 8>()), 2 * 4 * blocks(4, tests), "{k}");
    }
    let compared: usize = (0..7)
        .map(|k| {
            derivatives(&cords(k).as_restricted_law::<4, 4>())
                + derivatives(&herds(k).as_restricted_law::<3, 6>())
                + derivatives(&tethers(k).as_restricted_law::<4, 8>())
                + derivatives(&traps(k).as_restricted_law::<3, 6>())
                + derivatives(&vapours(k).as_restricted_law::<4, 8>())
        })
        .sum();
    println!("{compared} derivatives that are not 0");
    assert!(compared > 1000);
}

#[test]
fn restricted_laws_are_verified() {
    let mut measured = 0;
    verified! { measured, as_restricted_law:
        clones, 0..7, 4, 8;
        cords, 0..7, 4, 4;
        herds, 0..7, 3, 6;
        tethers, 0..7, 4, 8;
        traps, 0..7, 3, 6;
    }
    assert!(measured > 200, "{measured}");
}

/// The same bits as alone: those that act do not know of test bodies.
#[test]
fn bodies_that_act_move_as_without_test_bodies() {
    let sun = |scene: Scene<2>| scene.body(1.3, [0.1, 0.0], [0.0, -0.1]);
    let planet = |scene: Scene<2>| scene.body(0.1, [1.0, 0.2], [-0.1, 1.1]);
    let test = |scene: Scene<2>, x: f64| scene.test_body(40.0, [x, 1.7], [-0.78, 0.4 * x]);
    let law = Gravity { g: 0.9 };
    macro_rules! same {
        ($bound:expr; $($scheme:expr),*) => {$({
            let two = planet(sun(Scene::new())).pairs(law).as_law::<2, 4>();
            let run = Simulation::new(two, two.start()).scheme($scheme).dt(0.01).run(200).unwrap();
            let alone = run.last().bodies::<2>();
            let orders = [
                (test(test(planet(sun(Scene::new())), 0.5), -0.8), [0, 1]),
                (test(planet(test(sun(Scene::new()), 0.5)), -0.8), [0, 2]),
                (planet(sun(test(test(Scene::new(), 0.5), -0.8))), [2, 3]),
            ];
            for (scene, acting) in orders {
                let four = scene.pairs(law).as_restricted_law::<4, 8>();
                let with = Simulation::new(four, four.start()).scheme($scheme).dt(0.01).run(200).unwrap();
                let bodies = with.last().bodies::<2>();
                for (i, at) in acting.into_iter().enumerate() {
                    for k in 0..2 {
                        assert!((bodies.q[at][k] - alone.q[i][k]).abs() <= $bound, "{}", run.report().scheme());
                        assert!((bodies.v[at][k] - alone.v[i][k]).abs() <= $bound, "{}", run.report().scheme());
                    }
                }
                for invariant in Invariant::ALL {
                    assert_eq!(with.drift(invariant).is_some(), run.drift(invariant).is_some());
                    let (Some(with), Some(run)) = (with.drift(invariant), run.drift(invariant)) else { continue };
                    assert!((with.start() - run.start()).abs() < 1e-15 && (with.max_abs() - run.max_abs()).abs() < 1e-13);
                }
            }
        })*};
    }
    same!(0.0; Leapfrog, Nystrom::order6(), ForceGradient::order4(), RungeKuttaNystrom::order12(), Explicit);
    same!(1e-13; Relaxed::order6(), Implicit, DiscreteGradient, Gauss::order16());
}

/// Of a scene without test bodies it is the law that it is without them, to the bit.
#[test]
fn without_test_bodies_it_is_the_other_law() {
    fn end<A: AmongFew<D, N, S>, S: Sides, C, const D: usize, const N: usize, const K: usize>(
        law: FewBodies<A, D, N, K, S>,
        scheme: C,
    ) -> (State<K>, [Option<Drift>; 5])
    where
        C: Scheme<dmech::extend::Particle<FewBodies<A, D, N, K, S>, K>>,
    {
        let run = Simulation::new(law, law.start()).mass(1.3).scheme(scheme).dt(0.02).run(60).unwrap();
        (*run.last(), Invariant::ALL.map(|invariant| run.drift(invariant)))
    }
    let none = TESTS.iter().position(|tests| tests.is_empty()).unwrap();
    macro_rules! same {
        ($($scene:ident, $n:literal, $k:literal, [$($scheme:expr),*];)*) => {$($(
            let [mutual, restricted] = [
                end($scene(none).as_law::<$n, $k>(), $scheme),
                end($scene(none).as_restricted_law::<$n, $k>(), $scheme),
            ];
            assert_eq!(mutual, restricted);
        )*)*};
    }
    same! {
        clones, 4, 8, [Leapfrog, Relaxed::order6(), ForceGradient::order4(), DiscreteGradient, Gauss::order16()];
        cords, 4, 4, [Boris, Implicit, DiscreteGradient];
        herds, 3, 6, [Explicit, Implicit, DiscreteGradient];
        tethers, 4, 8, [Leapfrog, DiscreteGradient];
        vapours, 4, 8, [Leapfrog, DiscreteGradient];
    }
}

/// All are test bodies, and two in one place: nothing acts, and nothing counts. One alone that acts is felt by all.
#[test]
fn nobody_acts_or_one_alone() {
    let all = TESTS.iter().position(|tests| tests.len() == 4).unwrap();
    macro_rules! every {
        ($($scheme:expr),*) => {$({
            let law = clones(all).as_restricted_law::<4, 8>();
            let start = law.start();
            assert_eq!([&start.q[4..6], &start.v[4..6]], [&start.q[6..8], &start.v[6..8]]);
            let run = Simulation::new(law, start).scheme($scheme).dt(0.05).run(40).unwrap();
            let end = run.last();
            assert_eq!(end.v, start.v, "{}", run.report().scheme());
            for i in 0..8 {
                let flown = (end.t - start.t).mul_add(start.v[i], start.q[i]);
                assert!((end.q[i] - flown).abs() < 1e-13, "{}", run.report().scheme());
            }
            for invariant in Invariant::ALL {
                let drift = run.drift(invariant);
                assert!(drift.is_none_or(|drift| drift.start() == 0.0 && drift.max_abs() == 0.0), "{invariant}");
            }
            // Two clones in one place stay together about what acts.
            let scene = Scene::<2>::new().body(1.0, [0.0; 2], [0.1, 0.0]);
            let scene = (0..2).fold(scene, |scene, _| scene.test_body(0.3, [1.0, 0.0], [0.0, 0.9]));
            let law = scene.pairs(Gravity { g: 1.0 }).as_restricted_law::<3, 6>();
            let run = Simulation::new(law, law.start()).scheme($scheme).dt(0.01).run(100).unwrap();
            let bodies = run.last().bodies::<2>();
            assert_eq!((bodies.q[1], bodies.v[1]), (bodies.q[2], bodies.v[2]));
            assert!(bodies.v[0] == [0.1, 0.0] && bodies.q[1][1] > 0.5, "{bodies:?}");
        })*};
    }
    every!(
        Leapfrog,
        Composed::order4(Leapfrog),
        ForceGradient::order4(),
        RungeKuttaNystrom::order12(),
        Relaxed::order6(),
        Kanatani,
        Implicit,
        DiscreteGradient,
        Gauss::order16(),
        Explicit
    );
}

/// In twice as many digits.
#[test]
fn restricted_laws_in_double_double() {
    for k in 0..7 {
        in_double_double!(k, clones(k).as_restricted_law::<4, 8>(), 0.005, 60, every 10);
    }
}

/// What counts, and by what a body is moved: also of one that is pinned.
#[test]
fn test_bodies_have_masses_and_no_weight() {
    for k in 0..10 {
        let (law, scene) = (tethers(k).as_restricted_law::<4, 8>(), tethers(k));
        let (masses, weights) = (Law::<8>::mass_ratios(&law), Law::<8>::weights(&law));
        for i in 0..8 {
            let (given, pinned) = (scene.masses()[i / 2], Law::<8>::pinned(&law, i));
            assert_eq!(pinned, k % 5 == i / 2);
            assert_eq!(weights[i], if is_test(k, i / 2) { 0.0 } else { given });
            assert_eq!(masses[i], if is_test(k, i / 2) && pinned { 1.0 } else { given });
        }
        let field = Law::<8>::field(&law, 1.0, law.start().t);
        let gradient = field.gradient(law.start().q);
        assert!((0..8).all(|i| k % 5 != i / 2 || gradient[i] == 0.0));
        let run = Simulation::new(law, law.start()).scheme(Implicit).dt(0.01).run(50).unwrap();
        assert!((0..8).all(|i| k % 5 != i / 2 || run.last().q[i] == law.start().q[i]));
    }
    // In another scalar a mass may be nothing.
    let scene = Scene::new().body(1.0, [0.0, 0.1], [0.0; 2]).test_body(1e-60, [1.0, 0.2], [0.0; 2]);
    let law = scene.pairs(Gravity { g: 1.0 }).as_restricted_law::<2, 4>();
    assert!(Simulation::new(law, law.start()).scheme(Leapfrog).dt(0.01).run(5).is_ok());
    let State { q, v, .. } = law.start();
    let small = Simulation::new(law, State::of(q.map(|x| x as f32), v.map(|x| x as f32))).scheme(Leapfrog).dt(0.01);
    assert_eq!(small.run(5).unwrap_err().cause(), Error::Mass { mass: 1e-60 });
}

#[test]
fn what_cannot_be_a_restricted_law_says_why() {
    let pairs = Gravity { g: 1.0 };
    let two = || Scene::new().body(1.0, [0.0, 0.2], [0.0, 0.1]).test_body(1.0, [1.0, 0.2], [0.0; 2]);
    let cause = |scene: Scene<2, (), ((), dmech::scene::OnPairs<Gravity>)>| {
        let law = scene.as_restricted_law::<3, 6>();
        let refused = Simulation::new(law, law.start()).scheme(Leapfrog).dt(0.01).run(10).unwrap_err();
        let member = Ensemble::of(2).scene(move |_| law).scheme(Leapfrog).dt(0.01).run(10).unwrap();
        assert_eq!(member.last(1).unwrap_err(), refused.cause());
        refused.cause()
    };
    let driven = two().body(1.0, [3.0, 0.0], [0.0; 2]).drive(2, |t| ([3.0 + t, 0.0], [1.0, 0.0]));
    assert_eq!(cause(driven.pairs(pairs)), SceneError::NotFree { body: 2 }.into());
    let driven = two().test_body(1.0, [3.0, 0.0], [0.0; 2]).drive(2, |t| ([3.0 + t, 0.0], [1.0, 0.0]));
    assert_eq!(cause(driven.pairs(pairs)), SceneError::NotFree { body: 2 }.into());
    assert_eq!(cause(two().pairs(pairs)), SceneError::NotSoMany { bodies: 2, declared: 3 }.into());
    let light = two().test_body(0.0, [3.0; 2], [0.0; 2]);
    assert_eq!(cause(light.pairs(pairs)), SceneError::Mass { body: 2, mass: 0.0 }.into());
    // In the other law none may be: the first is named.
    let law = two().test_body(1.0, [3.0; 2], [0.0; 2]).pairs(pairs).as_law::<3, 6>();
    let refused = Simulation::new(law, law.start()).scheme(Leapfrog).dt(0.01).run(10).unwrap_err().cause();
    assert_eq!(refused, SceneError::NotFree { body: 1 }.into());
    assert!(refused.to_string().contains("as_restricted_law"), "{refused}");
    // Where one that acts is met, what is felt is no number.
    let met = two().test_body(1.0, [0.0, 0.2], [0.0; 2]).pairs(pairs).as_restricted_law::<3, 6>();
    let cause = Simulation::new(met, met.start()).scheme(Leapfrog).dt(0.01).run(10).unwrap_err().cause();
    assert!(matches!(cause, Error::Law { quantity: "force", .. }), "{cause}");
}

/// A checkpoint knows who is a test body.
#[test]
fn another_test_body_is_another_law() {
    let scene = |test: bool| {
        let sun = Scene::<2>::new().body(1.0, [0.0; 2], [0.0; 2]);
        let (q, v) = ([1.0, 0.0], [0.0, 1.0]);
        let scene = if test { sun.test_body(0.5, q, v) } else { sun.body(0.5, q, v) };
        let law = scene.pairs(Gravity { g: 1.0 }).as_restricted_law::<2, 4>();
        Simulation::new(law, law.start()).scheme(Leapfrog).dt(0.01)
    };
    let mut begun = scene(true).stepper().unwrap();
    begun.advance(10).unwrap();
    let saved = begun.checkpoint();
    begun.advance(10).unwrap();
    let mut resumed = scene(true).resume(&saved).unwrap();
    resumed.advance(10).unwrap();
    assert_eq!(resumed.state(), begun.state());
    assert!(matches!(scene(false).resume(&saved), Err(Error::Checkpoint(_))));
}
