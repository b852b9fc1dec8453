//! Runs: between the steps, along long ellipses, changed, saved and resumed.

use std::f64::consts::TAU;

use dmech::models::Kepler;
use dmech::models::pairs::Gravity;
use dmech::prelude::*;
use dmech_tests::motion::distance;

use crate::laws::for_each_order;

const LAW: Kepler = Kepler { gm: 1.3 };

/// What lies between the steps is as accurate as what lies at their ends, and costs the steps nothing.
#[test]
fn between_the_steps() {
    let (half_axis, e) = (0.9, 0.4);
    let start = LAW.pericentre(half_axis, e);
    let dt = LAW.period(half_axis) / 40.0;
    let times = || (1..400).map(|k| 0.037 * f64::from(k));
    let run = Simulation::new(LAW, start).scheme(Gauss::order16()).dt(dt).record_at(times()).run_until(15.0).unwrap();
    let plain = Simulation::new(LAW, start).scheme(Gauss::order16()).dt(dt).run_until(15.0).unwrap();
    let error = |s: &State<2>| distance(s.q, LAW.exact(half_axis, e, s.t));
    let [between, ends] = [&run, &plain].map(|run| run.states().iter().map(error).fold(0.0, f64::max));
    println!("between {between:e}, ends {ends:e}");
    assert!(run.states().len() == 399 && between < ends + 1e-13 && between < 1e-11, "{between:e} {ends:e}");
    assert_eq!(run.report().steps(), plain.report().steps());

    let mut stepper = Simulation::new(LAW, start).scheme(Gauss::order16()).dt(dt).stepper().unwrap();
    stepper.advance(17).unwrap();
    let now = stepper.state();
    for part in [0.0, 0.3, 0.7, 1.0] {
        assert!(error(&stepper.at(now.t + part * dt).unwrap()) < 1e-11);
    }
    assert_eq!(stepper.state(), now);
    assert!(stepper.at(now.t + 1.1 * dt).is_err());
    // Passages through the line of apsides, to rounding of the time.
    let run = Simulation::new(LAW, start).scheme(Gauss::order16()).dt(dt);
    let run = run.event(|s| s.q[1], Crossing::Falling).run_until(60.0).unwrap();
    let period = LAW.period(half_axis);
    assert!(run.events().len() > 10);
    for (n, event) in run.events().iter().enumerate() {
        let late = event.state().t - period * (n as f64 + 0.5);
        assert!(late.abs() < 1e-11, "{late:e}");
    }
}

fn from_apocentre(e: f64) -> State<2> {
    State::new([-1.0 - e, 0.0], [0.0, -((1.0 - e) / (1.0 + e)).sqrt()])
}

/// Comets: a law, and a sun and a comet of the same motion, with the same steps.
#[test]
fn comets_are_followed() {
    let sun = Kepler { gm: 1.0 };
    let (e, turns) = (0.9, 20.0);
    // A few tolerances a revolution.
    for (e, tolerance, most, evaluations) in
        [(e, 1e-9, 4.0, 78), (e, 1e-12, 4.0, 66), (0.99, 1e-9, 30.0, 76), (0.99, 1e-12, 30.0, 66)]
    {
        let most = most * turns * tolerance;
        let State { q, v, .. } = from_apocentre(e);
        let run = Simulation::new(sun, from_apocentre(e)).scheme(Gauss::order16()).adaptive(tolerance);
        let run = run.run_until(turns * TAU).unwrap();
        let [error, energy, angular] = [
            distance(run.last().q, q),
            run.drift(Invariant::Energy).unwrap().max_relative(),
            run.drift(Invariant::AngularMomentum).unwrap().max_relative(),
        ];
        println!("e = {e}, {tolerance:e}: {error:e}, {energy:e}, {angular:e} in {} steps", run.steps());
        // Of the larger of the products of which it is the difference, at the pericentre.
        let rounding = if e > 0.95 { 3e-13 } else { 3e-14 };
        assert!(error < most && angular < rounding, "e = {e}: {error:e} {angular:e}");
        let [shortest, longest] = run.report().dt_range().unwrap();
        assert!(longest > 20.0 * shortest && run.report().rough() == 0);
        // The guess goes on from step to step, whatever their ratio: with another one it takes half a sweep more at least.
        let taken = run.report().evaluations() as f64 / run.steps() as f64;
        assert!(taken < f64::from(evaluations), "e = {e}, {tolerance:e}: {taken} a step");

        let part = |share: f64| ([share * q[0], share * q[1]], [share * v[0], share * v[1]]);
        let (a, b) = (part(-0.4), part(0.6));
        let pair = Scene::new().body(0.6, a.0, a.1).body(0.4, b.0, b.1).pairs(Gravity { g: 1.0 });
        let scene =
            Simulation::scene(pair).scheme(Gauss::order16()).adaptive(tolerance).run_until(turns * TAU).unwrap();
        let error = distance(scene.last().q[1], b.0);
        assert!(error < most && scene.steps().abs_diff(run.steps()) <= 1, "{error:e} in {} steps", scene.steps());
        let [more, less] = [&scene.report().evaluations(), &run.report().evaluations()].map(|n| *n as f64);
        assert!((more / less - 1.0).abs() < 0.05, "{more} evaluations for {less}");
    }
    // A finer tolerance is a better motion at any order.
    macro_rules! better {
        ($scheme:expr, $_:tt) => {{
            let error = |tolerance: f64| {
                let run = Simulation::new(sun, from_apocentre(0.7)).scheme($scheme).adaptive(tolerance);
                distance(run.run_until(3.0 * TAU).unwrap().last().q, from_apocentre(0.7).q)
            };
            let [coarse, fine] = [error(1e-4), error(1e-10)];
            assert!(fine < 0.1 * coarse && fine < 1e-4, "{coarse:e} {fine:e}");
        }};
    }
    for_each_order!(better! { 0 });
}

/// Saved after any step and resumed: the run that never stopped, to the bit, through steps that are made in halves as well.
#[test]
fn saved_through_halves() {
    let (steps, mut rough) = (24, 0);
    macro_rules! resumed {
        ($scheme:expr, $_:tt) => {{
            let long = Simulation::new(LAW, LAW.pericentre(0.9, 0.3)).scheme($scheme).dt(LAW.period(0.9));
            let mut whole = long.clone().stepper().unwrap();
            whole.advance(steps).unwrap();
            for saved in [0, 1, 2, 11, 23] {
                let mut first = long.clone().stepper().unwrap();
                first.advance(saved).unwrap();
                let text = serde_json::to_string(&first.checkpoint()).unwrap();
                let mut second = long.clone().resume(&serde_json::from_str(&text).unwrap()).unwrap();
                assert_eq!(second.state(), first.state());
                second.advance(steps - saved).unwrap();
                assert_eq!(
                    (second.state(), second.evaluations()),
                    (whole.state(), whole.evaluations()),
                    "after {saved}"
                );
                assert_eq!(second.checkpoint(), whole.checkpoint());
            }
            let run = long.run(steps).unwrap();
            assert_eq!(*run.last(), whole.state());
            rough += run.report().rough();
        }};
    }
    for_each_order!(resumed! { 0 });
    assert!(rough > 60, "{rough}");
}

/// One by one and many at once are the same, and a step that fails leaves the next as it was.
#[test]
fn one_by_one() {
    let simulation = || Simulation::new(LAW, LAW.pericentre(0.9, 0.6)).scheme(Gauss::order16()).dt(0.2);
    let (mut one, mut many) = (simulation().stepper().unwrap(), simulation().stepper().unwrap());
    many.advance(200).unwrap();
    for k in 0..200 {
        if k == 77 {
            one.law_mut().gm = f64::NAN;
            assert!(one.step().is_err());
            one.law_mut().gm = LAW.gm;
            one.set_state(one.state()).unwrap();
            many = simulation().stepper().unwrap();
            many.advance(77).unwrap();
            many.set_state(many.state()).unwrap();
            many.advance(123).unwrap();
        }
        one.step().unwrap();
    }
    assert_eq!((one.state(), one.steps()), (many.state(), many.steps()));
}

/// In single precision: as near to the motion as that has digits, whatever the step.
#[test]
fn single_precision() {
    let start = LAW.pericentre(0.9, 0.4);
    let narrow = State::<2, f32>::of(start.q.map(|x| x as f32), start.v.map(|x| x as f32));
    macro_rules! single {
        ($scheme:expr, $_:tt) => {{
            let dt = LAW.period(0.9) / 128.0;
            let run = Simulation::new(LAW, narrow).mass(1.0).scheme($scheme).dt(dt).run(128).unwrap();
            let error = distance(run.last().q.map(f64::from), start.q);
            assert!(error < 3e-5 && error > 0.0 && run.report().rough() == 0, "{error:e}");
            let sweeps = run.report().evaluations() as f64 / (8.0 * 128.0);
            assert!(sweeps < 8.0, "{sweeps}");
        }};
    }
    for_each_order!(single! { 0 });
}
