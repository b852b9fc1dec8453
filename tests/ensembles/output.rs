//! States at given times, and members as they come.

use std::ops::ControlFlow;

use dmech::extend::Company;
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

/// So many adaptive steps without a longest: how many states there will be is not known before, in lanes and alone.
#[test]
fn states_at_equal_distances_of_steps_without_a_longest() {
    let adaptive = dmech::scheme::Adaptive::new(Nystrom::order6(), 1e-6);
    let alone = Simulation::new(Orbit::member(3), Orbit::start(3)).scheme(adaptive).record_dt(0.1).run(10).unwrap();
    assert!(alone.states().len() > 3);
    for lanes in [1, 8] {
        let run = Ensemble::of(9).law(Orbit::member).start(Orbit::start).scheme(adaptive).record_dt(0.1).lanes(lanes);
        assert_eq!(run.run(10).unwrap().member(3).unwrap().states(), alone.states());
    }
}

/// More states than there is memory for are refused before a member moves, in lanes and alone.
#[test]
fn more_states_than_there_is_memory_for() {
    const STEPS: u64 = 1 << 50;
    fn refused<S: dmech::extend::Rides<Orbit, 2> + Copy + Sync>(scheme: S, lanes: usize) {
        let alone = Simulation::new(Orbit::member(3), Orbit::start(3)).scheme(scheme).dt(0.01).record_dt(0.005);
        let alone = alone.run(STEPS).unwrap_err().cause();
        assert!(matches!(alone, Error::Recording { .. }), "{alone}");
        let ensemble = Ensemble::of(9).law(Orbit::member).start(Orbit::start).scheme(scheme).dt(0.01).lanes(lanes);
        // Those who would move would do so once.
        let once = |_, member: Company<State<2>>| member.observe(1, |_| ControlFlow::Break(()));
        let run = ensemble.record_dt(0.005).with(once).run(STEPS).unwrap();
        assert_eq!(run.failures().collect::<Vec<_>>(), [0, 1, 2, 3, 4, 5, 6, 7, 8].map(|k| (k, alone)));
    }
    refused(Leapfrog, 8);
    refused(Leapfrog, 1);
    refused(Gauss::order16(), 8);
    refused(Relaxed::order6(), 8);
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

/// A row for each member, as text and for NumPy; NaN of one that failed.
#[test]
fn members_are_written_as_a_table() {
    let start = |k: usize| if k == 5 { State::new([0.0; 2], [0.0; 2]) } else { Orbit::start(k) };
    let run = Ensemble::of(12).law(Orbit::member).start(start).scheme(Leapfrog).dt(0.01).run(30).unwrap();
    let (mut csv, mut npy) = (Vec::new(), std::io::Cursor::new(Vec::new()));
    run.write(Csv::new(&mut csv)).unwrap();
    run.write(Npy::new(&mut npy)).unwrap();
    let csv = String::from_utf8(csv).unwrap();
    let (head, rows) = csv.split_once('\n').unwrap();
    assert_eq!((head, rows.lines().count()), ("k,t,q0,q1,v0,v1", 12));
    let npy = npy.into_inner();
    assert!(npy[..128].windows(7).any(|shape| shape == b"(12, 6)"));
    let numbers: Vec<f64> = npy[128..].chunks(8).map(|x| f64::from_le_bytes(x.try_into().unwrap())).collect();
    assert_eq!(numbers.len(), 12 * 6);
    for (k, (row, numbers)) in rows.lines().zip(numbers.chunks(6)).enumerate() {
        let read: Vec<f64> = row.split(',').map(|x| x.parse().unwrap()).collect();
        assert_eq!(format!("{read:?}"), format!("{numbers:?}"));
        match run.last(k) {
            Ok(last) => assert_eq!(read, [k as f64, last.t, last.q[0], last.q[1], last.v[0], last.v[1]]),
            Err(_) => assert!(k == 5 && read[0] == 5.0 && read[1..].iter().all(|x| x.is_nan())),
        }
    }
    assert_eq!(run.failures().count(), 1);
}

/// With columns of one's own, and each state that was recorded; what is written of members is what their runs have.
#[test]
fn members_are_written_with_more() {
    let start = |k: usize| if k == 5 { State::new([0.0; 2], [0.0; 2]) } else { Orbit::start(k) };
    let ensemble = || Ensemble::of(12).law(Orbit::member).start(start).scheme(Leapfrog).dt(0.01);
    let run = ensemble().record_dt(0.1).run(30).unwrap();
    let beside = |k: usize, run: &Run<State<2>>| [0.5 * k as f64, run.steps() as f64];
    let mut csv = Vec::new();
    run.write_with(["half", "steps made"], beside, Csv::new(&mut csv)).unwrap();
    let csv = String::from_utf8(csv).unwrap();
    let (head, rows) = csv.split_once('\n').unwrap();
    assert_eq!((head, rows.lines().count()), ("k,half,steps made,t,q0,q1,v0,v1", 12));
    for (k, row) in rows.lines().enumerate() {
        let read: Vec<f64> = row.split(',').map(|x| x.parse().unwrap()).collect();
        assert!(
            read[..3] == [k as f64, 0.5 * k as f64, if k == 5 { 0.0 } else { 30.0 }] && (read[3].is_nan() == (k == 5))
        );
    }
    for name in ["a,b", "a\"b", "a\nb"] {
        let refused = run.write_with([name], |_, _| [0.0], Csv::new(Vec::new())).unwrap_err();
        assert_eq!(refused.kind(), std::io::ErrorKind::InvalidInput);
    }
    let mut npy = std::io::Cursor::new(Vec::new());
    run.write_states(Npy::new(&mut npy)).unwrap();
    let npy = npy.into_inner();
    let numbers: Vec<f64> = npy[128..].chunks(8).map(|x| f64::from_le_bytes(x.try_into().unwrap())).collect();
    let states = run.members().enumerate().flat_map(|(k, member)| {
        let states = member.unwrap_or_else(Interrupted::run).states();
        states.iter().map(move |state| [k as f64, state.t, state.q[0], state.q[1], state.v[0], state.v[1]])
    });
    let states: Vec<f64> = states.flatten().collect();
    assert!(states.len() >= 11 * 3 * 6 && numbers == states, "{}", states.len());
    // Nothing was recorded, and nothing is written.
    let mut nothing = Vec::new();
    ensemble().run(3).unwrap().write_states(Csv::new(&mut nothing)).unwrap();
    assert!(nothing.is_empty());
}

/// A bar counts members, also where some are in a store.
#[test]
fn a_bar_counts_members() {
    let hidden = || indicatif::ProgressBar::with_draw_target(None, indicatif::ProgressDrawTarget::hidden());
    let ensemble = || Ensemble::of(100).law(Orbit::member).start(Orbit::start).scheme(Leapfrog).dt(0.01);
    let file = std::env::temp_dir().join(format!("dmech-bar-{}.sqlite", std::process::id()));
    let _ = std::fs::remove_file(&file);
    let quiet = ensemble().run(20).unwrap().checksum();
    let bars = [hidden(), hidden(), hidden(), hidden()];
    let each = |k| Simulation::new(Orbit::member(k), Orbit::start(k)).scheme(Leapfrog).dt(0.01);
    let each = Ensemble::each(100, each).with_progress_bar(bars[3].clone());
    assert_eq!(each.run(20).unwrap().checksum(), quiet);
    assert_eq!(ensemble().with_progress_bar(bars[0].clone()).run(20).unwrap().checksum(), quiet);
    for bar in &bars[1..3] {
        let kept = ensemble().with_progress_bar(bar.clone()).store(&file);
        assert_eq!(kept.run(20).unwrap().checksum(), quiet);
    }
    let refused = hidden();
    ensemble().with_progress_bar(refused.clone()).store(&file).run(21).unwrap_err();
    std::fs::remove_file(&file).unwrap();
    for bar in bars {
        assert_eq!((bar.length(), bar.position(), bar.is_finished()), (Some(100), 100, true));
    }
    assert_eq!((refused.position(), refused.is_finished()), (0, true));
    assert_eq!(ensemble().with_progress("orbits").run(20).unwrap().checksum(), quiet);
}
