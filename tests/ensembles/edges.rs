//! Members that fail, that do nothing, that are none; simulations of any kind.

use dmech::models::Kepler;
use dmech::models::pairs::Gravity;
use dmech::prelude::*;

use crate::laws::{Contact, Many, Orbit, Saddle};

/// Whether a motion has failed alone and as a member, which has the same end or the same cause after as many steps.
fn failed_alike(
    k: usize,
    alone: &Result<Run<State<2>>, Interrupted<State<2>>>,
    member: Result<&Run<State<2>>, &Interrupted<State<2>>>,
) -> bool {
    match (alone, member) {
        (Ok(alone), Ok(member)) => assert_eq!(alone.last(), member.last(), "{k}"),
        (Err(alone), Err(member)) => {
            // A cause may hold NaN, which is not itself.
            assert_eq!(format!("{:?}", alone.cause()), format!("{:?}", member.cause()), "{k}");
            assert_eq!(alone.run().steps(), member.run().steps(), "{k}");
        }
        (alone, member) => panic!("{k}: {} alone, {} together", alone.is_ok(), member.is_ok()),
    }
    alone.is_err()
}

/// Members that cannot start, that fall into the centre, that fly off to infinity: told as alone, and the others as they are.
#[test]
fn failures_are_told_and_cost_the_others_nothing() {
    let start = |k: usize| match k {
        3 => State::new([0.0, 0.0], [0.0, 0.0]),
        17 => State::new([f64::NAN, 0.0], [0.0, 0.0]),
        30 => State::new([1.0, 0.0], [0.0, f64::MAX]),
        44 => State::new([1e-200, 0.0], [0.0, 0.0]),
        _ => Orbit::start(k),
    };
    fn check<S: dmech::extend::Rides<Orbit, 2> + Sync>(scheme: S, start: impl Fn(usize) -> State<2> + Sync) {
        let run = Ensemble::of(50).law(Orbit::member).start(&start).scheme(scheme).dt(0.02).run(200).unwrap();
        let mut failed = 0;
        for k in 0..50 {
            let alone = Simulation::new(Orbit::member(k), start(k)).scheme(scheme).dt(0.02).run(200);
            failed += usize::from(failed_alike(k, &alone, run.member(k)));
        }
        assert_eq!(run.failures().count(), failed);
        assert!((3..10).contains(&failed), "{failed}");
    }
    check(Leapfrog, start);
    check(Nystrom::order6(), start);
    check(DiscreteGradient, start);
    check(Implicit, start);
    check(Gauss::order16(), start);
}

/// Steps so long that Newton cannot go the usual way: each goes the long one by itself.
#[test]
fn long_steps_are_solved_by_each_alone() {
    let law = |k: usize| Contact::member(k);
    for dt in [0.3, 0.9, 2.5] {
        let run = Ensemble::of(40).law(law).start(Contact::start).scheme(DiscreteGradient).dt(dt).run(60).unwrap();
        let implicit = Ensemble::of(40).law(law).start(Contact::start).scheme(Implicit).dt(dt).run(60).unwrap();
        for k in 0..40 {
            let alone = Simulation::new(law(k), Contact::start(k)).dt(dt);
            let exact = alone.clone().scheme(DiscreteGradient).run(60);
            assert_eq!(run.last(k).ok(), exact.ok().map(|run| *run.last()), "{k}, dt = {dt}");
            let trapezoid = alone.scheme(Implicit).run(60);
            assert_eq!(implicit.last(k).ok(), trapezoid.ok().map(|run| *run.last()), "{k}, dt = {dt}");
        }
    }
}

/// Steps so long that sweeps come no nearer in some of them: each makes these in parts by itself.
#[test]
fn long_steps_are_made_in_parts_by_each_alone() {
    let mut rough = 0;
    for dt in [0.4, 0.8, 1.6] {
        let run =
            Ensemble::of(45).law(Orbit::member).start(Orbit::start).scheme(Gauss::order16()).dt(dt).run(70).unwrap();
        for k in 0..45 {
            let alone = Simulation::new(Orbit::member(k), Orbit::start(k)).scheme(Gauss::order16()).dt(dt).run(70);
            let (Ok(member), Ok(alone)) = (run.member(k), &alone) else {
                assert_eq!(run.last(k).ok(), alone.ok().map(|run| *run.last()), "{k}, dt = {dt}");
                continue;
            };
            assert_eq!(member.last(), alone.last(), "{k}, dt = {dt}");
            assert_eq!(member.report().evaluations(), alone.report().evaluations(), "{k}, dt = {dt}");
            assert_eq!(member.report().rough(), alone.report().rough(), "{k}, dt = {dt}");
            rough += alone.report().rough();
        }
    }
    assert!(rough > 45, "{rough}");
}

#[test]
fn none_and_one_and_no_steps() {
    let ensemble = |n| Ensemble::of(n).law(Saddle::member).start(Saddle::start).scheme(Leapfrog).dt(0.1);
    assert!(ensemble(0).run(10).unwrap().is_empty());
    assert_eq!(ensemble(1).run(10).unwrap().len(), 1);
    let run = ensemble(9).run(0).unwrap();
    assert!((0..9).all(|k| run.last(k).unwrap() == Saddle::start(k)));
    assert!(run.drift(0, Invariant::Energy).is_some() && run.drift(0, Invariant::WorkEnergy).is_none());
    // What is wrong for all is told at once.
    assert_eq!(ensemble(9).dt(-1.0).run(1).unwrap_err(), Error::TimeStep { dt: -1.0 });
    let missing = Ensemble::of(9).law(Saddle::member).start(Saddle::start).scheme(Leapfrog).run(1);
    assert_eq!(missing.unwrap_err(), Error::MissingTimeStep);
    let tolerance = ensemble(9).scheme(DiscreteGradient).adaptive(0.0).run_until(1.0);
    assert_eq!(tolerance.unwrap_err(), Error::Tolerance { tolerance: 0.0 });
    let fine = ensemble(9).scheme(DiscreteGradient).adaptive(1e-300).run_until(1.0);
    assert!(matches!(fine.unwrap_err(), Error::TurnVanished { tolerance: 1e-300, .. }));
    // What is to be recorded, and when the end is.
    assert_eq!(ensemble(9).dt(0.1).look_every(0).run(1).unwrap_err(), Error::RecordEvery);
    assert_eq!(ensemble(9).dt(0.1).record_dt(0.0).run(1).unwrap_err(), Error::RecordDt { dt: 0.0 });
    assert!(matches!(ensemble(9).dt(0.1).record_at([f64::NAN]).run(1).unwrap_err(), Error::RecordAt { .. }));
    let endless = ensemble(9).dt(0.1).run_until(f64::INFINITY).unwrap_err();
    assert_eq!(endless, Error::EndTime { end: f64::INFINITY, dt: 0.1 });
    // An end before all starts; where some come before it, those run.
    let since = |first: f64| ensemble(9).start(move |k| Saddle::start(k).at_time(first + 0.5 * k as f64));
    let before = Error::Span { start: 1.0, end: 0.5 };
    assert_eq!(since(1.0).dt(0.1).run_until(0.5).unwrap_err(), before);
    assert_eq!(since(1.0).scheme(DiscreteGradient).adaptive(1e-3).run_until(0.5).unwrap_err(), before);
    assert_eq!(since(1.0).dt(0.1).for_each_until(0.5, |_, _| ()).unwrap_err(), before);
    assert_eq!(since(-0.5).dt(0.1).run_until(0.5).unwrap().failures().count(), 6);
    assert!(ensemble(0).dt(0.1).run_until(-1.0).unwrap().is_empty());
    // What no member reaches is not recorded, as alone.
    let late = ensemble(9).dt(0.1).record_at([0.5, 7.0]).run_until(1.0).unwrap();
    assert!(late.members().flatten().all(|run| run.states().len() == 1 && run.states()[0].t == 0.5));
}

/// Laws and starts that somebody has listed.
#[test]
fn members_of_a_list() {
    let members = (0..45).map(|k| (Orbit::member(k), Orbit::start(k)));
    let listed = Ensemble::over(members).scheme(DiscreteGradient).dt(0.05).run_until(4.0).unwrap();
    let numbered = Ensemble::of(45).law(Orbit::member).start(Orbit::start).scheme(DiscreteGradient).dt(0.05);
    assert_eq!(listed.len(), 45);
    assert_eq!(listed.checksum(), numbered.run_until(4.0).unwrap().checksum());
    let none = Ensemble::over(Vec::<(Orbit, State<2>)>::new()).scheme(Leapfrog).dt(0.05).run(3).unwrap();
    assert!(none.is_empty());
}

/// Steps of their own length.
#[test]
fn adaptive_members() {
    let ensemble = Ensemble::of(21).law(Orbit::member).start(Orbit::start).scheme(Composed::order6(DiscreteGradient));
    let run = ensemble.adaptive(1e-8).look_every(4).run_until(3.0).unwrap();
    for k in 0..21 {
        let alone = Simulation::new(Orbit::member(k), Orbit::start(k)).scheme(Composed::order6(DiscreteGradient));
        let alone = alone.adaptive(1e-8).record_every(4).run_until(3.0).unwrap();
        assert_eq!(
            (run.last(k).unwrap(), run.drift(k, Invariant::Energy)),
            (*alone.last(), alone.drift(Invariant::Energy))
        );
    }
}

/// One whose steps are too short to come to the end does not keep the others in its lanes.
#[test]
fn adaptive_members_beside_one_that_cannot_come_to_the_end() {
    let mass = |k: usize| if k == 5 { 1e-60 } else { 1.0 + k as f64 };
    let ensemble = Ensemble::of(11).law(Saddle::member).start(Saddle::start).mass(mass).scheme(Gauss::order16());
    let run = ensemble.adaptive(1e-9).run_until(2.0).unwrap();
    for k in 0..11 {
        let alone = Simulation::new(Saddle::member(k), Saddle::start(k)).mass(mass(k)).scheme(Gauss::order16());
        assert_eq!(failed_alike(k, &alone.adaptive(1e-9).run_until(2.0), run.member(k)), k == 5);
    }
    assert_eq!(run.failures().count(), 1);
}

/// Scenes, each of another size, with events that stop some of them.
#[test]
fn scenes_and_events() {
    let member = |k: usize| {
        let mut scene = Scene::<2>::new().body(1.0, [0.0, 0.0], [0.0, 0.0]);
        for i in 0..=k % 4 {
            scene = scene.body(0.01, [1.0 + i as f64, 0.0], [0.0, 1.0 / (1.0 + i as f64).sqrt()]);
        }
        Simulation::scene(scene.pairs(Gravity { g: 1.0 }))
            .scheme(Leapfrog)
            .dt(0.01)
            .record_every(100)
            .stop_when(move |state: &SceneState<2>| state.q[1][1] - 0.1 * k as f64, Crossing::Rising)
    };
    let run = Ensemble::each(30, member).threads(2).run_until(2.0).unwrap();
    let mut stopped = 0;
    for k in 0..30 {
        let alone = member(k).run_until(2.0).unwrap();
        let together = run.member(k).unwrap();
        assert_eq!((together.last(), together.states()), (alone.last(), alone.states()));
        stopped += usize::from(together.stopped());
    }
    assert!((4..30).contains(&stopped), "{stopped}");
    assert_eq!(run.checksum(), Ensemble::each(30, member).threads(1).run_until(2.0).unwrap().checksum());
}

/// More threads than there are to be had are as many as there may be.
#[test]
fn any_number_of_threads_gives_the_same() {
    let ensemble = |threads| {
        let members = Ensemble::of(20_000).law(Saddle::member).start(Saddle::start);
        members.scheme(Leapfrog).dt(0.1).threads(threads).run(2).unwrap().checksum()
    };
    let one = ensemble(1);
    assert!([0, 3, 20_000, usize::MAX].into_iter().all(|threads| ensemble(threads) == one));
}

/// A panic in a law, a start or what looks at members ends the ensemble, on any number of threads: nobody waits for ever.
#[test]
fn a_panic_goes_on() {
    let start = |k: usize| if k == 700 { panic!("no start for {k}") } else { Saddle::start(k) };
    for threads in [1, 2, 5] {
        let ensemble = || Ensemble::of(2000).law(Saddle::member).scheme(Leapfrog).dt(0.1).threads(threads);
        let run = std::panic::catch_unwind(|| ensemble().start(start).run(3).map(|run| run.len()));
        let words = run.unwrap_err();
        assert_eq!(words.downcast_ref::<String>().map(String::as_str), Some("no start for 700"), "{threads} threads");
        let look = std::panic::catch_unwind(|| {
            ensemble().start(Saddle::start).for_each_until(1.0, |k, _| assert!(k < 300, "seen enough"))
        });
        assert!(look.is_err(), "{threads} threads");
    }
}

/// What is said of all members: nothing is relative to an energy of 0, and no time is told that was not measured.
#[test]
fn what_is_said_of_members_are_numbers() {
    // On a parabola from 2, on ellipses from 1 and 1.5.
    let run = Ensemble::of(3)
        .law(|_| Kepler { gm: 1.0 })
        .start(|k| State::new([1.0 + 0.5 * k as f64, 0.0], [0.0, 1.0]))
        .scheme(Leapfrog)
        .dt(0.01)
        .run(200)
        .unwrap();
    let said = run.to_string();
    assert!(said.contains("energy               relative deviation at most") && !said.contains("inf"), "{said}");
    let said = run.member(2).unwrap().to_string();
    assert!(said.ends_with("not measured") && !said.contains("ns per step"), "{said}");
}
