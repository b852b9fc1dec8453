//! The work of the steps, where somebody asks for it: kinetic energy less work drifts to the bit as it does alone.

use dmech::extend::{Fields, Rides, StoreError};
use dmech::prelude::*;
use dmech::scheme::Adaptive;

use crate::laws::{Contact, Damped, Many, Orbit};
use crate::same::{of, the_same};
use crate::store::Place;

/// All drifts as text, where NaN is NaN.
fn drifts<X>(run: Result<&Run<X>, &Interrupted<X>>) -> String {
    let run = run.unwrap_or_else(Interrupted::run);
    let all: Vec<_> = Invariant::ALL.into_iter().map(|invariant| run.drift(invariant)).collect();
    format!("{} {all:?}", run.steps())
}

/// So many members in so many lanes, with looks by number or by time.
fn check<L, S, const D: usize>(scheme: S, dt: f64, [members, lanes]: [usize; 2])
where
    L: Many<D> + Fields<D>,
    S: Rides<L, D> + Sync,
{
    let ensemble = || of::<L, S, D>(members, scheme).dt(dt).lanes(lanes).watch_work();
    let alone = |k| Simulation::new(L::member(k), L::start(k)).scheme(scheme).dt(dt);
    for every in [1, 6, 1000] {
        let run = ensemble().look_every(every).run_until(1.5).unwrap();
        for k in 0..members {
            let alone = alone(k).record_every(every).run_until(1.5);
            assert_eq!(drifts(run.member(k)), drifts(alone.as_ref()), "{k} of {members} in {lanes}, {every}");
            let work = run.drift(k, Invariant::WorkEnergy).unwrap();
            assert!(work.start() != 0.0 && work.max_relative() < 1e-13, "{k}: {work:?}");
        }
    }
    let run = ensemble().record_dt(0.13).run_until(1.5).unwrap();
    for k in 0..members {
        let alone = alone(k).record_dt(0.13).run_until(1.5);
        assert_eq!(drifts(run.member(k)), drifts(alone.as_ref()), "{k} of {members} in {lanes}, by time");
    }
}

#[test]
fn few_and_many_in_few_and_many_lanes() {
    for size in [[0, 8], [1, 8], [2, 2], [2, 8], [9, 8], [61, 1], [61, 5], [61, usize::MAX]] {
        check::<Orbit, _, 2>(Leapfrog, 0.03, size);
        check::<Contact, _, 1>(DiscreteGradient, 0.05, size);
        // In rows of equal steps, of which some members begin one while others are within theirs.
        check::<Orbit, _, 2>(Adaptive::new(Composed::order4(Leapfrog), 1e-9), 0.5, size);
        check::<Damped, _, 1>(Gauss::order16(), 0.2, size);
    }
}

/// Nobody who does not ask for it has it, whatever moves the members.
#[test]
fn it_is_there_where_it_was_asked_for() {
    fn both<S: Rides<Orbit, 2> + Sync>(scheme: S) {
        for lanes in [1, 8] {
            let ensemble = || of::<Orbit, S, 2>(9, scheme).dt(0.05).lanes(lanes);
            let (without, with) = (ensemble().run(20).unwrap(), ensemble().watch_work().run(20).unwrap());
            assert!((0..9).all(|k| without.drift(k, Invariant::WorkEnergy).is_none()));
            assert!((0..9).all(|k| with.drift(k, Invariant::WorkEnergy).is_some()));
            assert!(with.to_string().contains("kinetic energy - work") && !without.to_string().contains("work"));
            assert_eq!(without.checksum(), with.checksum());
        }
    }
    both(Leapfrog);
    both(Relaxed::order6());
}

/// Members that cannot start, that fall into the centre, that fly off: the work up to there is what it is alone.
#[test]
fn of_those_that_fail() {
    let start = |k: usize| match k {
        3 => State::new([0.0, 0.0], [0.0, 0.0]),
        17 => State::new([f64::NAN, 0.0], [0.0, 0.0]),
        25 => State::new([0.3, 1e-4], [0.0, 0.0]),
        30 => State::new([1.0, 0.0], [0.0, f64::MAX]),
        _ => Orbit::start(k),
    };
    fn check<S: Rides<Orbit, 2> + Sync>(scheme: S, start: impl Fn(usize) -> State<2> + Sync) {
        let ensemble = Ensemble::of(50).law(Orbit::member).start(&start).scheme(scheme).dt(0.02).look_every(3);
        let run = ensemble.watch_work().run(200).unwrap();
        assert!((2..10).contains(&run.failures().count()));
        for k in 0..50 {
            let alone = Simulation::new(Orbit::member(k), start(k)).scheme(scheme).dt(0.02).record_every(3).run(200);
            assert_eq!(drifts(run.member(k)), drifts(alone.as_ref()), "{k}");
        }
    }
    check(Leapfrog, start);
    check(DiscreteGradient, start);
    check(Gauss::order16(), start);
}

/// Steps so long that each has to solve its own equations, or to make its step in parts.
#[test]
fn of_steps_that_are_made_alone() {
    for dt in [0.4, 0.9, 2.5] {
        fn check<L: Many<D> + Fields<D>, S: Rides<L, D> + Sync, const D: usize>(scheme: S, dt: f64) {
            let run = of::<L, S, D>(40, scheme).dt(dt).watch_work().run(60).unwrap();
            for k in 0..40 {
                let alone = Simulation::new(L::member(k), L::start(k)).scheme(scheme).dt(dt).run(60);
                assert_eq!(drifts(run.member(k)), drifts(alone.as_ref()), "{k}, dt = {dt}");
            }
        }
        check::<Contact, _, 1>(DiscreteGradient, dt);
        check::<Contact, _, 1>(Implicit, dt);
        check::<Orbit, _, 2>(Gauss::order16(), dt);
    }
}

/// A store keeps the drift, and is another one where nobody asked.
#[test]
fn a_store_tells_whether_it_was_summed() {
    let place = Place::new("work");
    let ensemble = || of::<Orbit, _, 2>(20, Leapfrog).dt(0.01).look_every(7);
    let plain = ensemble().watch_work().run_until(2.0).unwrap();
    let kept = || ensemble().watch_work().store(place.file()).run_until(2.0).unwrap();
    the_same(&plain, &kept());
    place.sql("DELETE FROM last WHERE k % 3 = 1; DELETE FROM drift WHERE k % 3 = 1");
    the_same(&plain, &kept());
    assert!((0..20).all(|k| plain.drift(k, Invariant::WorkEnergy).is_some()));
    let store = dmech::extend::Name::of(&["after every 7 steps, and the work of each step"]);
    let refused = ensemble().store(place.file()).run_until(2.0).unwrap_err();
    assert_eq!(refused, Error::Store(StoreError::Looks { store, here: "after every 7 steps" }));
}
