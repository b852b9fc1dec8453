//! How invariants moved over a run, in numbers.

use std::collections::BTreeMap;

use dmech::models::{Kepler, Pendulum, pairs};
use dmech::prelude::*;
use dmech::{History, Interrupted};

/// A spring with a drag, and a number of the motion.
#[derive(Clone, Copy, Debug)]
struct Damped {
    k: f64,
    c: f64,
}

#[dmech::law]
impl Damped {
    #[potential]
    fn energy(&self, q: [f64; 1]) -> f64 {
        0.5 * self.k * q[0] * q[0]
    }
    #[force]
    fn drag(&self, v: [f64; 1]) -> [f64; 1] {
        [-self.c * v[0]]
    }
    #[invariant]
    fn twice_the_place(&self, q: [f64; 1], v: [f64; 1]) -> f64 {
        2.0 * q[0] + 0.0 * v[0]
    }
}

fn planet() -> Simulation<Kepler, State<2>> {
    Simulation::new(Kepler { gm: 1.0 }, State::new([0.5, 0.0], [0.0, 1.63]))
}

/// The largest deviation in it; of those that are no number the last word is theirs, as in a drift.
fn largest(history: &History) -> f64 {
    let lost = history.parts().iter().any(|part| !part.is_finite());
    let size = history.parts().iter().fold(0.0, |most: f64, part| most.max(part.most()).max(-part.least()));
    if lost { f64::NAN } else { size }
}

/// A run's numbers are those that a stepper has after the same steps: at every state, at some, and in parts of several states.
#[test]
fn the_numbers_are_those_of_a_stepper() {
    let mut several = 0;
    for (steps, every) in [(0, 1), (1, 1), (2, 7), (100, 1), (100, 7), (2047, 1), (5000, 1), (20_000, 3)] {
        let run = planet().scheme(Leapfrog).dt(0.01).record_every(every).run(steps).unwrap();
        let history = run.history(Invariant::Energy).unwrap();
        let mut stepper = planet().scheme(Leapfrog).dt(0.01).stepper().unwrap();
        let start = stepper.energy().unwrap();
        let mut seen = vec![(0.0, 0.0)];
        for k in 1..=steps {
            stepper.step().unwrap();
            if k % every == 0 || k == steps {
                seen.push((stepper.t(), stepper.energy().unwrap() - start));
            }
        }
        let each = history.states_in_a_part() as usize;
        several += usize::from(each > 1);
        let rows: Vec<_> = seen.chunks(each).collect();
        assert_eq!(history.parts().len(), rows.len(), "{steps} {every}");
        for (part, row) in history.parts().iter().zip(&rows) {
            assert_eq!(part.times(), [row[0].0, row[row.len() - 1].0]);
            assert_eq!(part.first(), row[0].1);
            let (least, most) = row.iter().fold((f64::MAX, f64::MIN), |(a, b), (_, x)| (a.min(*x), b.max(*x)));
            assert_eq!([part.least(), part.most()], [least, most]);
        }
        let mut points: Vec<_> = rows.iter().map(|row| row[0]).collect();
        points.extend(seen.last().filter(|last| Some(*last) != points.last()));
        assert_eq!(history.points().collect::<Vec<_>>(), points, "{steps} {every}");
    }
    assert!(several > 1);
}

/// Whatever is watched, the extremes are those of the report; there is a history where there is a drift, and nowhere else.
fn as_reported<X>(run: &Run<X>, seen: &mut BTreeMap<String, u32>) {
    for invariant in Invariant::ALL {
        let (drift, history) = (run.drift(invariant), run.history(invariant));
        assert_eq!(drift.is_some(), history.is_some(), "{invariant}");
        if let (Some(drift), Some(history)) = (drift, history) {
            assert_eq!(largest(history), drift.max_abs(), "{invariant}");
            // Not −0, which a table would show.
            assert_eq!(history.points().next().map(|(_, x)| x.to_bits()), Some(0), "{invariant}");
            *seen.entry(invariant.to_string()).or_default() += u32::from(drift.max_abs() > 0.0);
        }
    }
    for (name, drift) in run.report().own_drifts() {
        let history = run.history_of(name).unwrap();
        assert_eq!((largest(history), history.points().next().unwrap().1), (drift.max_abs(), 0.0), "{name}");
        *seen.entry(name.to_owned()).or_default() += u32::from(drift.max_abs() > 0.0);
    }
    assert!(run.history_of("nothing of this name").is_none());
}

#[test]
fn extremes_are_those_of_the_drifts() {
    let mut seen = BTreeMap::new();
    for steps in [0, 1, 3000] {
        let damped =
            Simulation::new(Damped { k: 2.0, c: 0.1 }, State::new([1.0], [0.2])).scheme(DiscreteGradient).dt(0.05);
        as_reported(&damped.watch("speed", |s| s.v[0]).watch("place", |s| s.q[0]).run(steps).unwrap(), &mut seen);
        as_reported(&planet().scheme(Kanatani).dt(0.01).run(steps).unwrap(), &mut seen);
        as_reported(
            &planet().scheme(Nystrom::order6()).adaptive(1e-5).record_dt(0.3).run_until(9.0).unwrap(),
            &mut seen,
        );
        let precise = State::of([0.5, 0.0].map(DoubleDouble::from), [0.0, 1.63].map(DoubleDouble::from));
        as_reported(
            &Simulation::new(Kepler { gm: 1.0 }, precise).scheme(Leapfrog).dt(0.01).run(steps).unwrap(),
            &mut seen,
        );
        let scene = Scene::new()
            .body(1.0, [0.0, 0.0], [0.1, 0.0])
            .body(2.0, [1.3, 0.2], [0.0, 0.3])
            .chain(pairs::Spring { k: 10.0, length: 1.0 });
        let scene = Simulation::scene(scene).scheme(Leapfrog).dt(0.01).watch("first", |s| s.q[0][0]);
        as_reported(&scene.stream(Csv::new(std::io::sink())).run(steps).unwrap(), &mut seen);
    }
    let all = Invariant::ALL.map(|invariant| invariant.to_string()).into_iter();
    for name in all.chain(["twice_the_place", "speed", "place", "first"].map(str::to_owned)) {
        assert!(seen.get(&name).is_some_and(|&moved| moved > 0), "{name} never moved: {seen:?}");
    }
}

/// The quantities of the run come after those of the law, and each is its own.
#[test]
fn quantities_are_told_apart() {
    let damped = Simulation::new(Damped { k: 2.0, c: 0.1 }, State::new([1.0], [0.2])).scheme(DiscreteGradient).dt(0.05);
    let run = damped.watch("speed", |s| s.v[0]).watch("time", |s| s.t).run(50).unwrap();
    for (k, state) in run.states().iter().enumerate() {
        let at = |name| run.history_of(name).unwrap().points().nth(k).unwrap();
        assert_eq!(at("speed"), (state.t, state.v[0] - 0.2));
        assert_eq!(at("time"), (state.t, state.t));
        assert_eq!(at("twice_the_place"), (state.t, 2.0 * state.q[0] - 2.0));
    }
    assert_eq!(run.states().len(), 51);
}

/// States between steps are not looked at, but the ends of the steps in which they lie.
#[test]
fn recorded_at_times_it_is_of_the_ends_of_steps() {
    let run =
        planet().scheme(Leapfrog).dt(0.01).record_at([0.0, 0.123, 0.124, 0.5]).watch("x", |s| s.q[0]).run(70).unwrap();
    let all = planet().scheme(Leapfrog).dt(0.01).watch("x", |s| s.q[0]).run(70).unwrap();
    assert_eq!(run.states().len(), 4);
    let ends = [0, 13, 50, 70];
    for both in
        [[run.history(Invariant::Energy), all.history(Invariant::Energy)], [run.history_of("x"), all.history_of("x")]]
    {
        let [few, all] = both.map(|history| history.unwrap().points().collect::<Vec<_>>());
        assert_eq!(few, ends.map(|k| all[k]));
        assert!(few.iter().skip(1).all(|point| point.1 != 0.0));
    }
}

#[test]
fn a_run_that_failed_has_its_history() {
    // It falls into the centre.
    let fall =
        || Simulation::new(Kepler { gm: 1.0 }, State::new([0.5, 0.0], [0.0, 0.0])).scheme(DiscreteGradient).dt(0.01);
    let failed: Interrupted<_> = fall().run(5000).unwrap_err();
    let run = failed.run();
    let energy = run.history(Invariant::Energy).unwrap();
    assert!(run.steps() > 5 && energy.parts().len() as u64 == run.steps() + 1, "{failed}");
    assert_eq!(largest(energy), run.drift(Invariant::Energy).unwrap().max_abs());
    // Refused before there was a state.
    let refused = fall().dt(-1.0).run(3).unwrap_err();
    assert!(refused.run().history(Invariant::Energy).is_none() && refused.run().history_of("x").is_none());
}

#[test]
fn what_is_no_number_is_said() {
    let swing = || Simulation::new(Pendulum { k: 1.0 }, State::new([0.8], [0.0])).scheme(Leapfrog).dt(0.1);
    let root = swing().watch("root", |s| s.q[0].sqrt()).run(60).unwrap();
    let history = root.history_of("root").unwrap();
    let lost = history.parts().iter().filter(|part| !part.is_finite()).count();
    let left = root.states().iter().filter(|state| state.q[0] < 0.0).count();
    assert!(lost == left && left > 10 && lost < 50, "{lost} {left}");
    assert_eq!(history.points().filter(|(_, x)| x.is_nan()).count(), left);
    assert!(root.drift_of("root").unwrap().max_abs().is_nan());
    // From the start.
    for start in [f64::NAN, f64::INFINITY] {
        let run = swing().watch("none", |s| if s.t == 0.0 { start } else { 1.0 }).run(3).unwrap();
        let parts = run.history_of("none").unwrap().parts();
        assert!(parts.len() == 4 && parts.iter().all(|part| !part.is_finite() && part.most().is_nan()), "{parts:?}");
    }
}

/// A number of the motion that is none at the start.
#[derive(Clone, Copy, Debug)]
struct Rooted;

#[dmech::law]
impl Rooted {
    #[potential]
    fn energy(&self, q: [f64; 1]) -> f64 {
        0.5 * q[0] * q[0]
    }
    #[invariant]
    fn root(&self, q: [f64; 1]) -> f64 {
        q[0].sqrt()
    }
}

#[test]
fn a_law_may_start_with_no_number() {
    let run = Simulation::new(Rooted, State::new([-1.0], [0.0])).scheme(Leapfrog).dt(0.1).run(3).unwrap();
    let parts = run.history_of("root").unwrap().parts();
    assert!(run.drift_of("root").unwrap().max_abs().is_nan() && parts.len() == 4);
    assert!(parts.iter().all(|part| !part.is_finite() && part.least().is_nan()), "{parts:?}");
    assert!(run.history(Invariant::Energy).unwrap().parts().iter().all(|part| part.is_finite()));
}

/// Of many motions none keeps one: each would be larger than a run.
#[test]
fn members_of_ensembles_keep_none() {
    let alone = |k: usize| planet().scheme(Leapfrog).dt(0.01 + 0.001 * k as f64).watch("x", |s: &State<2>| s.q[0]);
    let each = Ensemble::each(5, alone).run(40).unwrap();
    let of = Ensemble::of(5).law(|_| Kepler { gm: 1.0 }).start(|_| State::new([0.5, 0.0], [0.0, 1.63]));
    let of =
        of.with(|_, member| member.watch("x", |s| s.q[0])).scheme(Leapfrog).dt(0.01).look_every(1).run(40).unwrap();
    for run in each.members().chain(of.members()).map(Result::unwrap) {
        assert!(run.drift(Invariant::Energy).is_some() && run.drift_of("x").is_some());
        assert!(run.history(Invariant::Energy).is_none() && run.history_of("x").is_none());
    }
    assert!(alone(0).run(40).unwrap().history_of("x").is_some());
}

#[test]
fn it_is_not_written() {
    let run = planet().scheme(Leapfrog).dt(0.01).run(10).unwrap();
    let read: Run<State<2>> = serde_json::from_str(&serde_json::to_string(&run).unwrap()).unwrap();
    assert!(run.history(Invariant::Energy).is_some() && read.history(Invariant::Energy).is_none());
    assert!(read.drift(Invariant::Energy).is_some());
}
