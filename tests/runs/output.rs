//! Output at given times: every scheme, on laws and on scenes, with its order and without moving its steps.

use dmech::extend::{Scheme, Setup};
use dmech::models::pairs::Gravity;
use dmech::models::{Kepler, Pendulum};
use dmech::prelude::*;

const LAW: Kepler = Kepler { gm: 1.3 };

fn planet() -> Simulation<Kepler, State<2>> {
    Simulation::new(LAW, LAW.pericentre(0.9, 0.4).at_time(0.7))
}

fn three_bodies() -> Scene<2, (), ((), dmech::scene::OnPairs<Gravity>)> {
    Scene::new()
        .body(1.3, [0.0, 0.0], [0.0, -0.1])
        .body(0.4, [1.1, 0.0], [0.0, 1.1])
        .body(0.2, [-2.3, 0.3], [0.1, -0.7])
        .pairs(Gravity { g: 1.0 })
}

/// The largest distance between two lists of positions.
fn distance(a: &[[f64; 2]], b: &[[f64; 2]]) -> f64 {
    a.iter().zip(b).map(|(a, b)| (a[0] - b[0]).hypot(a[1] - b[1])).fold(0.0, f64::max)
}

/// Runs with and without output between the steps end in the same state, to the bit.
fn leaves_the_steps_where_they_are<L, X, S>(simulation: &dyn Fn() -> Simulation<L, X, S>) -> Run<X::State>
where
    X: Setup<L>,
    X::State: PartialEq,
    S: Scheme<X::System>,
{
    let plain = simulation().run_until(5.0).unwrap();
    let seen = simulation().record_at((0..40).map(|k| 0.7 + 0.11 * f64::from(k))).run_until(5.0).unwrap();
    assert_eq!(seen.last(), plain.last());
    assert_eq!((seen.steps(), plain.steps()), (plain.steps(), seen.steps()));
    assert!(seen.report().evaluations() > plain.report().evaluations());
    seen
}

/// The error between the steps of a scheme at a step and at half of it.
macro_rules! of_order {
    ($($scheme:expr, $dt:expr;)*) => {{ let mut count = 0; $({
        let fine = planet().scheme(Nystrom::order8()).dt(0.002).record_at((0..40).map(|k| 0.7 + 0.11 * f64::from(k)));
        let truth: Vec<_> = fine.run_until(5.0).unwrap().states().to_vec();
        let error = |dt: f64| {
            let run = leaves_the_steps_where_they_are(&|| planet().scheme($scheme).dt(dt));
            assert_eq!(run.states().len(), 40);
            run.states().iter().zip(&truth).fold(0.0_f64, |worst, (state, truth)| {
                assert_eq!(state.t, truth.t);
                let v = distance(&[state.v], &[truth.v]);
                worst.max(distance(&[state.q], &[truth.q])).max(v)
            })
        };
        let [coarse, half] = [error($dt), error(0.5 * $dt)];
        let (order, scheme) = ((coarse / half).log2(), $scheme);
        let expected = f64::from(order_of(&scheme));
        // Some gain an order or two where the error of the phase is small.
        assert!(order > expected - 0.5, "{scheme:?}: {coarse:e}, {half:e}: order {order:.2}");
        count += 1;
    })* count }};
}

fn order_of<M: Method>(_: &M) -> u32 {
    M::ORDER
}

#[test]
fn every_scheme_has_its_order_between_its_steps() {
    let count = of_order! {
        Leapfrog, 0.02;
        CompensatedLeapfrog, 0.02;
        Implicit, 0.02;
        DiscreteGradient, 0.02;
        Kanatani, 0.02;
        Nystrom::order4(), 0.1;
        Nystrom::order6(), 0.15;
        Relaxed::order6(), 0.15;
        ForceGradient::order4(), 0.1;
        ForceGradient::order6(), 0.15;
        Composed::order4(Leapfrog), 0.1;
        Composed::order4(DiscreteGradient), 0.1;
        Composed::order6(DiscreteGradient), 0.15;
        Composed::order4(Implicit), 0.1;
    };
    assert_eq!(count, 14);
}

#[test]
fn adaptive_steps_do_not_move() {
    leaves_the_steps_where_they_are(&|| planet().scheme(Nystrom::order6()).adaptive(1e-9));
    leaves_the_steps_where_they_are(&|| planet().scheme(Composed::order4(DiscreteGradient)).adaptive(1e-6));
    leaves_the_steps_where_they_are(&|| {
        Simulation::scene(three_bodies().at_time(0.7)).scheme(Nystrom::order8()).adaptive(1e-9)
    });
}

/// A scene gives between its steps what it gives in steps that end there.
#[test]
fn scenes_have_states_between_their_steps() {
    let times = [0.0, 0.013, 0.5, 0.517, 1.999, 2.0];
    let run =
        Simulation::scene(three_bodies()).scheme(Nystrom::order8()).dt(0.05).record_at(times).run_until(2.0).unwrap();
    assert_eq!(run.states().iter().map(|state| state.t).collect::<Vec<_>>(), times);
    for state in &run.states()[1..] {
        let alone = Simulation::scene(three_bodies()).scheme(Nystrom::order8()).dt(state.t / 200.0).run(200).unwrap();
        assert!(distance(&state.q, &alone.last().q) < 1e-11 && distance(&state.v, &alone.last().v) < 1e-11);
    }
    for scheme_has in [
        leaves_the_steps_where_they_are(&|| Simulation::scene(three_bodies().at_time(0.7)).scheme(Leapfrog).dt(0.01)),
        leaves_the_steps_where_they_are(&|| Simulation::scene(three_bodies().at_time(0.7)).scheme(Kanatani).dt(0.01)),
        leaves_the_steps_where_they_are(&|| {
            Simulation::scene(three_bodies().at_time(0.7)).scheme(DiscreteGradient).dt(0.01)
        }),
    ] {
        assert_eq!(scheme_has.states().len(), 40);
    }
}

/// The start, the end, equal times, times in any order, times that rounding puts beside a step.
#[test]
fn times_at_the_edges_are_recorded() {
    let times = |run: &Run<State<2>>| run.states().iter().map(|state| state.t).collect::<Vec<_>>();
    let simulation = || planet().scheme(Leapfrog).dt(0.1);
    let run = simulation().record_at([1.7, 0.7, 0.8, 1.25, 1.25, 0.7]).run_until(1.7).unwrap();
    assert_eq!(times(&run), [0.7, 0.7, 0.8, 1.25, 1.25, 1.7]);
    assert_eq!(run.states()[0], run.states()[1]);
    assert_eq!(run.states()[3], run.states()[4]);
    // 0.7 + 10 · 0.1 is not 1.7 in `f64`, and the run ends before or after it by a rounding.
    let all: Vec<_> = (0..=1000).map(|k| 0.7 + 0.1 * f64::from(k)).collect();
    assert_eq!(times(&simulation().record_at(all.iter().copied()).run_until(100.7).unwrap()), all);
    let every = simulation().record_every(1).run_until(100.7).unwrap();
    for (state, at) in every.states().iter().zip(simulation().record_dt(0.1).run_until(100.7).unwrap().states()) {
        assert!((state.t - at.t).abs() < 1e-13 && distance(&[state.q], &[at.q]) < 1e-11);
    }
    // Those beyond the end are not reached; nothing, and no step.
    assert_eq!(times(&simulation().record_at([0.75, 9.0]).run(1).unwrap()), [0.75]);
    assert!(simulation().record_at([]).run(3).unwrap().states().is_empty());
    assert_eq!(times(&simulation().record_at([0.7, 0.71]).run(0).unwrap()), [0.7]);
    assert_eq!(times(&simulation().record_dt(0.25).run(4).unwrap()).len(), 2);
}

#[test]
fn times_that_cannot_be_are_refused() {
    let simulation = || planet().scheme(Leapfrog).dt(0.1);
    let cause = |simulation: Simulation<Kepler, State<2>, Leapfrog>| simulation.run(3).unwrap_err().cause();
    assert_eq!(cause(simulation().record_at([0.9, 0.3])), Error::RecordAt { time: 0.3, start: 0.7 });
    assert!(matches!(cause(simulation().record_at([0.9, f64::NAN])), Error::RecordAt { time, .. } if time.is_nan()));
    assert!(matches!(cause(simulation().record_at([f64::INFINITY])), Error::RecordAt { .. }));
    for dt in [0.0, -0.1, f64::NAN, f64::INFINITY] {
        assert!(matches!(cause(simulation().record_dt(dt)), Error::RecordDt { .. }));
    }
    let message = cause(simulation().record_at([0.3])).to_string();
    assert_eq!(
        message,
        "no state can be recorded at t = 0.3: times are finite, and none is before the start at t = 0.7"
    );
}

/// What no memory holds is refused before the first step, and written by a stream.
#[test]
fn records_that_do_not_fit_are_refused_at_once() {
    let simulation = || planet().scheme(Leapfrog).dt(0.1);
    let states = 1 << 50;
    let refused = simulation().run(states - 1).unwrap_err();
    assert_eq!(refused.cause(), Error::Recording { states, bytes: 40 * states });
    assert_eq!(refused.run().steps(), 0);
    let scene = Simulation::scene(three_bodies()).scheme(Leapfrog).dt(0.1);
    assert!(matches!(scene.run(states).unwrap_err().cause(), Error::Recording { bytes, .. } if bytes > 96 * states));
    let stopped = simulation().observe(9, |_| core::ops::ControlFlow::Break(()));
    assert_eq!(stopped.stream(Csv::new(std::io::sink())).run(states).unwrap().steps(), 9);
}

/// What is recorded between steps does not weaken what is said of the invariants, and is itself as exact.
#[test]
fn invariants_hold_between_the_steps() {
    let energy =
        |state: &State<2>| 0.5 * (state.v[0].powi(2) + state.v[1].powi(2)) - 1.3 / state.q[0].hypot(state.q[1]);
    let run = planet().scheme(DiscreteGradient).dt(0.05).record_dt(0.013).run_until(20.0).unwrap();
    let first = energy(&run.states()[0]);
    assert!(run.states().len() > 1000);
    assert!(run.states().iter().all(|state| (energy(state) / first - 1.0).abs() < 1e-13));
    assert!(run.drift(Invariant::Energy).unwrap().max_relative() < 1e-13);
    assert!(run.drift(Invariant::WorkEnergy).unwrap().max_relative() < 1e-13);
}

#[test]
fn a_stepper_has_the_states_of_its_next_step() {
    let mut stepper = planet().scheme(Nystrom::order8()).dt(0.1).stepper().unwrap();
    stepper.advance(13).unwrap();
    let (t, state) = (stepper.t(), stepper.state());
    let middle = stepper.at(t + 0.04).unwrap();
    assert_eq!(middle.t, t + 0.04);
    assert_eq!(stepper.at(t).unwrap(), state);
    let end = stepper.at(t + 0.1).unwrap();
    assert_eq!(stepper.state(), state);
    stepper.step().unwrap();
    assert!(distance(&[end.q], &[stepper.q()]) < 1e-14);
    let t = stepper.t();
    assert_eq!(stepper.at(t - 0.01), Err(Error::OutsideStep { time: t - 0.01, from: t, to: t + 0.1 }));
    assert!(stepper.at(t + 0.11).is_err() && stepper.at(f64::NAN).is_err());
    let adaptive = planet().scheme(Nystrom::order8()).adaptive(1e-9).stepper().unwrap();
    assert!(adaptive.at(0.7 + 0.5 * adaptive.next_dt()).is_ok());
}

/// The end of the next step by the stepper's own clock, t₀ + (k + 1) h, which t + h misses by a rounding now and then.
#[test]
fn the_end_of_the_next_step_belongs_to_it() {
    fn missed<S: Scheme<Particle<Kepler, 2>> + Copy>(planet: Simulation<Kepler, State<2>, S>) -> usize {
        let stepper = || planet.clone().stepper().unwrap();
        let (mut before, mut after) = (stepper(), stepper());
        let late = |_| {
            after.step().unwrap();
            let (sum, end) = (before.t() + before.next_dt(), before.at(after.t()).unwrap());
            assert_eq!(end.t, after.t());
            assert!(distance(&[end.q], &[after.q()]) < 1e-9, "t = {}", end.t);
            before.step().unwrap();
            sum != end.t
        };
        (0..300).map(late).filter(|late| *late).count()
    }
    // It must have something to see, also where the time comes to 0 from far before.
    for start in [0.0, 0.7, -9.0] {
        let planet = || planet().starting_from(&planet().start().at_time(start));
        assert!(missed(planet().scheme(Leapfrog).dt(0.03)) > 9);
        assert!(missed(planet().scheme(Nystrom::order8()).adaptive(1e-9)) > 9);
    }
}

/// Between recorded states, at their ends, beside them and outside; on unequal steps, at the end that was not due.
#[test]
fn a_run_has_the_states_between_those_that_it_recorded() {
    let truth = |t: f64| planet().scheme(Nystrom::order8()).dt((t - 0.7) / 400.0).run(400).unwrap().last().q;
    let run = planet().scheme(Nystrom::order8()).dt(0.02).run_until(5.0).unwrap();
    let adaptive = planet().scheme(Nystrom::order8()).adaptive(1e-12).run_until(5.0).unwrap();
    for t in [0.7001, 0.712, 1.0, 2.345_678, 4.98, 4.9999] {
        for run in [&run, &adaptive] {
            let state = run.at(t).unwrap();
            assert!(distance(&[state.q], &[truth(t)]) < 1e-10, "{t} {:e}", distance(&[state.q], &[truth(t)]));
            assert_eq!(state.t, t);
        }
    }
    assert_eq!(run.at(run.states()[7].t).as_ref(), Some(&run.states()[7]));
    assert_eq!((run.at(0.6999), run.at(5.1), run.at(f64::NAN)), (None, None, None));
    // The last state, which was not due; two states; one.
    let few = planet().scheme(Leapfrog).dt(0.01).record_every(30).run(40).unwrap();
    assert!(distance(&[few.at(1.09).unwrap().q], &[truth(1.09)]) < 1e-3);
    assert_eq!((few.at(few.last().t).as_ref(), few.at(few.last().t.next_up())), (Some(few.last()), None));
    let two = planet().scheme(Leapfrog).dt(0.01).run(1).unwrap();
    assert!(distance(&[two.at(0.705).unwrap().q], &[truth(0.705)]) < 1e-5);
    let one = planet().scheme(Leapfrog).dt(0.01).run(0).unwrap();
    assert!(one.at(0.7).is_some() && one.at(0.705).is_none());
    let stopped =
        planet().scheme(Leapfrog).dt(0.01).stop_when(|state| state.q[1] - 0.1, Crossing::Any).run(400).unwrap();
    assert!(stopped.stopped() && stopped.at(stopped.last().t).as_ref() == Some(stopped.last()));
    let scene = Simulation::scene(three_bodies()).scheme(Nystrom::order6()).dt(0.02).run_until(1.0).unwrap();
    let between =
        Simulation::scene(three_bodies()).scheme(Nystrom::order6()).dt(0.02).record_at([0.437]).run_until(1.0).unwrap();
    let (a, b) = (scene.at(0.437).unwrap(), &between.states()[0]);
    assert!(distance(&a.q, &b.q) < 1e-8 && distance(&a.v, &b.v) < 1e-6);
}

/// Steps of a radian of the motion: no polynomial through them is exact, and those through many went astray by up to 10⁷.
#[test]
fn between_long_steps_a_run_does_not_go_astray() {
    fn check<S: dmech::extend::Adaptable + Scheme<Particle<Kepler, 2>>>(scheme: S, e: f64, most: f64) {
        let law = Kepler { gm: 1.3 };
        let motion = Simulation::new(law, law.pericentre(1.0, e));
        let run = motion.clone().scheme(scheme).adaptive(1e-9).run_until(20.0).unwrap();
        let middles = run.states().windows(2).map(|two| 0.5 * (two[0].t + two[1].t));
        let exact = motion.scheme(Gauss::order16()).adaptive(1e-13).record_at(middles).run_until(20.0).unwrap();
        let off = |state: &State<2>| distance(&[run.at(state.t).unwrap().q], &[state.q]);
        let worst = exact.states().iter().map(off).fold(0.0, f64::max);
        println!("{} at e = {e}: {worst:.1e} between {} steps", S::NAME, run.steps());
        assert!(worst < most && run.steps() < 200, "{} at e = {e}: {worst:e}", S::NAME);
    }
    check(Gauss::order16(), 0.1, 1e-5);
    check(Gauss::order16(), 0.6, 1e-2);
    check(Gauss::order16(), 0.9, 0.2);
    check(RungeKuttaNystrom::order12(), 0.6, 1e-4);
    check(RungeKuttaNystrom::order12(), 0.9, 1e-3);
    check(Nystrom::order8(), 0.9, 1e-5);
}

/// A step that fails keeps what was recorded before; a law that is not finite between two steps fails the output.
#[test]
fn a_failed_run_keeps_its_output() {
    let falling = State::new([1.0, 0.0], [0.0, 0.0]);
    let failed = Simulation::new(LAW, falling).scheme(DiscreteGradient).dt(0.05).record_dt(0.02).run_until(10.0);
    let failed = failed.unwrap_err();
    assert!(failed.run().states().len() > 10, "{failed}");
    assert!(failed.run().last().t < 10.0 && failed.run().steps() > 0);
}

/// States that all but coincide do not spoil what lies beside them.
#[test]
fn close_states_do_not_spoil_those_between() {
    let truth = |t: f64| planet().scheme(Nystrom::order8()).dt((t - 0.7) / 400.0).run(400).unwrap().last().q;
    let close = [0.7, 0.75, 0.8, 0.8_f64.next_up(), 0.8 + 1e-12, 0.9, 1.0, 1.1];
    let run = planet().scheme(Nystrom::order8()).dt(0.05).record_at(close).run_until(1.1).unwrap();
    for t in [0.72, 0.78, 0.83, 0.86, 0.95, 1.08] {
        let error = distance(&[run.at(t).unwrap().q], &[truth(t)]);
        assert!(error < 1e-6, "{t} {error:e}");
    }
    // A run that ends a rounding after its last record, and one that stops right after a step.
    for end in [0.3, 0.6, 0.7, 1.2, 1.4] {
        let run = planet().scheme(Nystrom::order8()).dt(0.1).record_dt(0.1).run_until(0.7 + end).unwrap();
        let t = 0.7 + end - 0.04;
        assert!(distance(&[run.at(t).unwrap().q], &[truth(t)]) < 1e-5, "{end}");
    }
    let stop = planet().scheme(Nystrom::order8()).dt(0.1).stop_when(|state| state.t - (1.2 + 1e-9), Crossing::Any);
    let run = stop.run_until(9.0).unwrap();
    assert!(run.stopped() && distance(&[run.at(1.15).unwrap().q], &[truth(1.15)]) < 1e-5);
}

/// What is recorded at the end of a step is that state, to the bit.
#[test]
fn output_at_the_end_of_a_step_is_its_state() {
    let every = planet().scheme(Nystrom::order6()).dt(0.125).run(40).unwrap();
    let at = planet().scheme(Nystrom::order6()).dt(0.125).record_at(every.states().iter().map(|state| state.t)).run(40);
    assert_eq!(at.unwrap().states(), every.states());
    // Positions beside the end of a step go over into it, also where the first step was made backward.
    let beside = |t: f64| {
        let run = planet().scheme(Kanatani.start(Start::BackwardStep)).dt(0.125).record_at([t]).run(9).unwrap();
        run.states()[0]
    };
    let [before, there, after] = [1.2_f64.next_down(), 1.2, 1.2_f64.next_up()].map(beside);
    for near in [before, after] {
        assert!(distance(&[near.q], &[there.q]) < 1e-14 && distance(&[near.v], &[there.v]) < 1e-13);
    }
    // Invariants are looked at after every step in which something is recorded.
    let looked = planet().scheme(Leapfrog).dt(0.05).record_dt(0.05).run_until(4.0).unwrap();
    let last = planet().scheme(Leapfrog).dt(0.05).record_at([]).run_until(4.0).unwrap();
    let drift = |run: &Run<State<2>>| run.drift(Invariant::Energy).unwrap().max_abs();
    assert!(drift(&looked) > drift(&last) && drift(&last) > 0.0);
}

#[test]
fn distances_that_the_time_cannot_tell_are_refused() {
    let dt = 1e-17;
    let refused = planet().scheme(Leapfrog).dt(0.1).record_dt(dt).run(3).unwrap_err();
    assert_eq!(refused.cause(), Error::RecordDt { dt });
    let many = planet().scheme(Leapfrog).dt(0.1).record_dt(1e-12).run_until(1e4).unwrap_err();
    assert!(matches!(many.cause(), Error::Recording { .. }), "{many}");
    // Of steps that follow the motion only their end is known.
    let follow = planet().scheme(Implicit).adaptive(1e-3).record_dt(1e-12).run_until(1e4).unwrap_err();
    assert!(matches!(follow.cause(), Error::Recording { states: 9_999_300_000_000_000, .. }), "{follow}");
    let law = Kepler { gm: 1.3 };
    let late = Simulation::new(law, law.pericentre(0.9, 0.4)).scheme(Leapfrog).dt(1e3).record_dt(3e-14).run(9);
    assert!(late.is_err());
}

/// Where a step is hardly more than the rounding of the time, no state beyond the last is recorded.
#[test]
fn nothing_beyond_the_end() {
    for (start, dt) in [(1e9, 3e-7), (1e15, 0.3), (1e6, 1e-9), (0.0, 0.1)] {
        let state = State::new([0.3], [1.1]).at_time(start);
        let run = Simulation::new(Pendulum { k: 1.3 }, state).scheme(Leapfrog).dt(dt).record_dt(dt).run(4).unwrap();
        assert_eq!(run.states().len(), 5, "from {start}");
        assert_eq!(run.states()[4], *run.last(), "from {start}");
    }
}
