//! Motions whose ends are published.

use dmech::extend::Real;
use dmech::models::pairs::Gravity;
use dmech::prelude::*;
use dmech_tests::motion::distance;

use crate::laws::Turning;

type Wide = DoubleDouble;

/// Arenstorf's orbit (E. Hairer, S. P. Nørsett and G. Wanner, Solving Ordinary Differential Equations I, II.0): start and period.
const MU: f64 = 0.012277471;
const SPEED: &str = "-2.00158510637908252240537862224";
const PERIOD: &str = "17.0652165601579625588917206249";

fn number(text: &str) -> Wide {
    text.parse().expect("a number")
}

/// With numbers of 31 digits it closes to the digits to which its start is published.
#[test]
fn arenstorf_closes() {
    let start = State::new([number("0.994"), Wide::ZERO], [Wide::ZERO, number(SPEED)]);
    let period = number(PERIOD);
    let end = |n: u32| {
        let dt = period.to_f64() / f64::from(n);
        let late = Wide::from(f64::from(n)) * Wide::from(dt) - period;
        let run = Simulation::new(Turning { mu: MU }, start)
            .scheme(Gauss::order16())
            .dt(dt)
            .record_every(100_000)
            .run(n.into());
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
    let start = State::new([0.994, 0.0], [0.0, number(SPEED).to_f64()]);
    let end = number(PERIOD).to_f64();
    let error = |tolerance: f64| {
        let run = Simulation::new(Turning { mu: MU }, start).scheme(Gauss::order16()).adaptive(tolerance).dt(0.5);
        let run = run.run_until(end).unwrap();
        let [shortest, longest] = run.report().dt_range().unwrap();
        assert!(longest > 30.0 * shortest && run.report().rough() == 0);
        println!("{tolerance:e}: {:e} in {} steps", distance(run.last().q, start.q), run.steps());
        distance(run.last().q, start.q)
    };
    let [coarse, fine] = [1e-6, 1e-13].map(error);
    assert!(fine < 1e-9 && coarse < 1e-1, "{coarse:e} {fine:e}");
}

/// Seven stars of masses 1 to 7 (Hairer, Nørsett and Wanner, II.10): the state at t = 3 as the Test Set for Initial Value
/// Problem Solvers has it.
#[test]
fn pleiades_end_where_they_must() {
    let at = [[3.0, 3.0], [3.0, -3.0], [-1.0, 2.0], [-3.0, 0.0], [2.0, 0.0], [-2.0, -4.0], [2.0, 4.0]];
    let moves = [[0.0, 0.0], [0.0, 0.0], [0.0, 0.0], [0.0, -1.25], [0.0, 1.0], [1.75, 0.0], [-1.5, 0.0]];
    let places = [
        [0.3706139143970502, -3.943437585517392],
        [3.237284092057233, -3.27138097397255],
        [-3.222559032418324, 5.225081843456543],
        [0.659709145577531, -2.59061243497747],
        [0.3425581707156584, 1.198213693392275],
        [1.562172101400631, -0.2429682344935824],
        [-0.7003092922212495, 1.09144924042898],
    ];
    let speeds = [
        [3.417003806314313, -3.74124496123401],
        [1.354584501625501, 0.377345968575063],
        [-2.590065597810775, 0.9386858869551073],
        [2.025053734714242, 0.3667922227200571],
        [-1.155815100160448, -0.347_404_635_380_849],
        [-0.8072988170223021, 2.344915448180937],
        [0.595239635420871, -1.947020434263292],
    ];
    let stars = || {
        let star = |scene: Scene<2>, i: usize| scene.body(i as f64 + 1.0, at[i], moves[i]);
        Simulation::scene((0..7).fold(Scene::new(), star).pairs(Gravity { g: 1.0 })).scheme(Gauss::order16())
    };
    let error = |run: &Run<SceneState<2>>| {
        let last = run.last();
        let miss = (0..7).map(|i| distance(last.q[i], places[i]).max(distance(last.v[i], speeds[i])));
        miss.fold(0.0, f64::max)
    };
    let runs = [stars().adaptive(1e-13).run_until(3.0).unwrap(), stars().dt(3.0 / 3000.0).run(3000).unwrap()];
    for run in &runs {
        println!("{:e} in {} steps, {:?}", error(run), run.steps(), run.report().dt_range());
        assert!(error(run) < 1e-11 && run.drift(Invariant::Energy).unwrap().max_relative() < 1e-12, "{:e}", error(run));
    }
}
