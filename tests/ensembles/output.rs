//! States at given times, and members as they come.

use dmech::prelude::*;

use crate::laws::{Driven, Many, Orbit};

/// The states of each member at times of its own grid and at given ones, also before its start, at its end and beyond.
#[test]
fn states_at_times_are_those_of_each_alone() {
    let times = [0.3, 0.31, 0.75, 1.0, 1.0, 1.2345, 1.5, 7.0];
    let ensemble = || Ensemble::of(37).law(Driven::member).start(Driven::start).scheme(Nystrom::order6()).dt(0.06);
    let alone = |k| Simulation::new(Driven::member(k), Driven::start(k)).scheme(Nystrom::order6()).dt(0.06);
    let at = ensemble().record_at(times).run_until(1.5).unwrap();
    let apart = ensemble().record_dt(0.17).run_until(1.5).unwrap();
    let mut states = 0;
    for k in 0..37 {
        for (run, alone) in [(&at, alone(k).record_at(times)), (&apart, alone(k).record_dt(0.17))] {
            let alone = alone.run_until(1.5).unwrap();
            assert_eq!(run.member(k).unwrap().states(), alone.states(), "{k}");
            assert_eq!(run.last(k).unwrap(), *alone.last());
            assert_eq!(run.drift(k, Invariant::Energy), alone.drift(Invariant::Energy));
            states += alone.states().len();
        }
    }
    assert!(states > 37 * 12, "{states}");
}

/// Members come in their order, on any number of threads, and their checksum is that of all together.
#[test]
fn members_come_in_order() {
    let ensemble =
        || Ensemble::of(1003).law(Orbit::member).start(Orbit::start).scheme(Leapfrog).dt(0.01).look_every(50);
    let all = ensemble().run_until(0.8).unwrap();
    for threads in [1, 2, 3, 8] {
        let (mut next, mut sum) = (0, dmech::extend::Checksum::default());
        let seen = ensemble().threads(threads).for_each_until(0.8, |k, member| {
            assert_eq!(k, next);
            assert_eq!(member.as_ref().unwrap().last(), &all.last(k).unwrap());
            sum.add(member.as_ref());
            next += 1;
        });
        seen.unwrap();
        assert_eq!((next, sum.value()), (1003, all.checksum()), "{threads} threads");
    }
}

/// A bit in one member is another checksum.
#[test]
fn a_checksum_sees_a_bit() {
    let run = |nudge: usize| {
        let start = move |k: usize| {
            let mut start = Orbit::start(k);
            if k == nudge {
                start.q[1] += 1e-13;
            }
            start
        };
        let run = Ensemble::of(20).law(Orbit::member).start(start).scheme(Leapfrog).dt(0.01).run(3).unwrap();
        run.checksum()
    };
    let sums: std::collections::BTreeSet<u64> = (0..=20).map(run).collect();
    assert_eq!(sums.len(), 21);
}
