//! Motions whose ends are published.

use dmech::extend::Real;
use dmech::prelude::*;
use dmech_tests::motion::distance;
use dmech_tests::published::{ClosedOrbit, MOON, PLEIADES_END, four_loops, pleiades};

type Wide = DoubleDouble;

/// Start and period of [`four_loops`], to the digits to which they are published.
const SPEED: &str = "-2.00158510637908252240537862224";
const PERIOD: &str = "17.0652165601579625588917206249";

fn number(text: &str) -> Wide {
    text.parse().expect("a number")
}

/// With numbers of 31 digits it closes to the digits to which its start is published.
#[test]
fn arenstorf_closes() {
    let start = State::of([number("0.994"), Wide::ZERO], [Wide::ZERO, number(SPEED)]);
    let period = number(PERIOD);
    let end = |n: u32| {
        let dt = period.to_f64() / f64::from(n);
        let late = Wide::from(f64::from(n)) * Wide::from(dt) - period;
        let run = Simulation::new(MOON, start).scheme(Gauss::order16()).dt(dt).record_every(100_000).run(n.into());
        let State { q, v, .. } = *run.unwrap().last();
        [0, 1].map(|k| (q[k] - late * v[k] - start.q[k]).abs().to_f64()).into_iter().fold(0.0, f64::max)
    };
    let errors = [6000, 12000].map(end);
    println!("{errors:?}");
    assert!(errors[1] < 1e-14 && errors[0] > 1e4 * errors[1], "{errors:?}");
}

/// In `f64`, where the passages by the lighter body are seen by the steps: twelve digits of the way are ten at the end.
#[test]
fn arenstorf_by_steps_that_follow_it() {
    let ClosedOrbit { start, period, end } = four_loops();
    let error = |tolerance: f64| {
        let run = Simulation::new(MOON, start).scheme(Gauss::order16()).adaptive(tolerance).dt(0.5);
        let run = run.run_until(period).unwrap();
        let [shortest, longest] = run.report().dt_range().unwrap();
        assert!(longest > 30.0 * shortest && run.report().rough() == 0);
        println!("{tolerance:e}: {:e} in {} steps", distance(run.last().q, end.q), run.steps());
        distance(run.last().q, end.q)
    };
    let [coarse, fine] = [1e-6, 1e-13].map(error);
    assert!(fine < 1e-9 && coarse < 1e-1, "{coarse:e} {fine:e}");
}

/// Of all seven stars, places and velocities.
#[test]
fn pleiades_end_where_they_must() {
    let stars = || Simulation::scene(pleiades()).scheme(Gauss::order16());
    let error = |run: &Run<SceneState<2>>| {
        let last = run.last().q.iter().zip(&run.last().v);
        let miss = last.zip(PLEIADES_END).map(|((q, v), end)| distance(*q, end.0).max(distance(*v, end.1)));
        miss.fold(0.0, f64::max)
    };
    let runs = [stars().adaptive(1e-13).run_until(3.0).unwrap(), stars().dt(3.0 / 3000.0).run(3000).unwrap()];
    for run in &runs {
        println!("{:e} in {} steps, {:?}", error(run), run.steps(), run.report().dt_range());
        assert!(error(run) < 1e-11 && run.drift(Invariant::Energy).unwrap().max_relative() < 1e-12, "{:e}", error(run));
    }
}
