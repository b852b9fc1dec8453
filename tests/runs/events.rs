//! Events: where, when, which, in what order, and what they leave alone.

use core::cell::Cell;
use core::f64::consts::{FRAC_PI_2, PI, TAU};
use core::ops::ControlFlow;

use dmech::extend::Scheme;
use dmech::models::pairs::Gravity;
use dmech::models::{Kepler, Pendulum};
use dmech::prelude::*;
use dmech_core::extend::Particle;

/// q = cos 2t.
#[derive(Clone, Copy, Debug)]
struct Spring {
    k: f64,
}

#[dmech::law]
impl Spring {
    #[potential]
    fn energy(&self, q: [f64; 1]) -> f64 {
        0.5 * self.k * q[0] * q[0]
    }
}

fn spring<S: Scheme<Particle<Spring, 1>>>(scheme: S, dt: f64) -> Simulation<Spring, State<1>, S> {
    Simulation::new(Spring { k: 4.0 }, State::new([1.0], [0.0])).scheme(scheme).dt(dt)
}

fn times<const D: usize>(run: &Run<State<D>>, which: usize) -> Vec<f64> {
    run.events().iter().filter(|event| event.which() == which).map(|event| event.state().t).collect()
}

/// The error of the times falls with the order of the scheme, down to rounding.
#[test]
fn times_have_the_order_of_the_scheme() {
    fn error<S: Scheme<Particle<Spring, 1>>>(scheme: S, dt: f64) -> f64 {
        let run = spring(scheme, dt).event(|state| state.q[0] - 0.3, Crossing::Any).run_until(3.0).unwrap();
        let exact = |n: i32| {
            let angle = 0.3_f64.acos();
            0.5 * if n % 2 == 0 { f64::from(n / 2) * TAU + angle } else { f64::from(n / 2 + 1) * TAU - angle }
        };
        assert_eq!(run.events().len(), 2);
        (0..2).fold(0.0, |worst: f64, n| worst.max((run.events()[n as usize].state().t - exact(n)).abs()))
    }
    for (order, [coarse, half]) in [
        (2, [error(Leapfrog, 0.05), error(Leapfrog, 0.025)]),
        (2, [error(DiscreteGradient, 0.05), error(DiscreteGradient, 0.025)]),
        (2, [error(Kanatani, 0.05), error(Kanatani, 0.025)]),
        (4, [error(Nystrom::order4(), 0.2), error(Nystrom::order4(), 0.1)]),
        (6, [error(Nystrom::order6(), 0.3), error(Nystrom::order6(), 0.15)]),
        (4, [error(Composed::order4(DiscreteGradient), 0.2), error(Composed::order4(DiscreteGradient), 0.1)]),
    ] {
        let measured = (coarse / half).log2();
        assert!((measured - f64::from(order)).abs() < 0.7, "{order}: {coarse:e} {half:e}");
    }
    assert!(error(Nystrom::order8(), 0.05) < 2e-13);
}

/// Directions, counts, numbers of events, their order within a step, and the steps, which do not move.
#[test]
fn many_events_come_in_the_order_of_their_times() {
    let simulation = || spring(Nystrom::order8(), 0.5).record_every(1);
    let run = simulation()
        .event(|state| state.q[0] - 0.1, Crossing::Falling)
        .event(|state| state.v[0], Crossing::Any)
        .event(|state| state.q[0] + 0.1, Crossing::Falling)
        .event(|state| state.q[0], Crossing::Rising)
        .event(|state| state.q[0], Crossing::Falling)
        .run_until(20.0)
        .unwrap();
    let expected: Vec<_> = (0..5).map(|which| times(&run, which).len()).collect();
    // 20 over the period π: six periods and 1.15 of the next, in which q falls through 0.1, 0 and −0.1 at 0.73 to 0.84.
    assert_eq!(expected, [7, 12, 7, 6, 7]);
    assert!(run.events().windows(2).all(|pair| pair[0].state().t <= pair[1].state().t));
    // Three of them lie in one step.
    let step = |t: f64| (t / 0.5).floor();
    let firsts: Vec<_> = run.events().iter().take(3).map(|event| (event.which(), step(event.state().t))).collect();
    assert_eq!(firsts, [(0, 1.0), (4, 1.0), (2, 1.0)]);
    // Zero, or as near as the time can be: the acceleration is 4 there, and the speed, 2 at most, has a rounding of its own.
    let rounding = |state: &State<1>| f64::EPSILON * (4.0 * (state.t + 0.5) + 2.0);
    for state in run.events().iter().filter(|event| event.which() == 1).map(Event::state) {
        assert!(state.v[0].abs() <= rounding(state), "{state:?}");
    }
    assert_eq!(run.events()[0].crossing(), Crossing::Falling);
    let plain = simulation().run_until(20.0).unwrap();
    assert_eq!(run.states(), plain.states());
    assert!(!run.stopped() && plain.events().is_empty());
}

/// A zero at the start is no event; one that falls on the end of a step is one; a zero that stays is not another.
#[test]
fn zeros_at_the_ends_of_steps_are_counted_once() {
    #[derive(Clone, Copy)]
    struct Free;
    impl Conservative for Free {}
    impl Potential<1> for Free {
        fn potential(&self, _: [f64; 1]) -> f64 {
            0.0
        }
        fn gradient(&self, _: [f64; 1]) -> [f64; 1] {
            [0.0]
        }
        fn hessian(&self, _: [f64; 1]) -> [[f64; 1]; 1] {
            [[0.0]]
        }
        fn discrete_gradient(&self, _: [f64; 1], _: [f64; 1]) -> [f64; 1] {
            [0.0]
        }
        fn discrete_gradient_jacobian(&self, _: [f64; 1], _: [f64; 1]) -> [[f64; 1]; 1] {
            [[0.0]]
        }
    }
    let flight = || Simulation::new(Free, State::new([-1.0], [1.0])).scheme(Leapfrog).dt(0.25);
    // −1, −0.75, …: 0 at the fourth step exactly.
    let run = flight().event(|state| state.q[0], Crossing::Any).run(12).unwrap();
    assert_eq!(times(&run, 0), [1.0]);
    let run = flight().event(|state| state.q[0] + 1.0, Crossing::Any).run(12).unwrap();
    assert!(run.events().is_empty());
    // Zero for a while.
    let clipped = |state: &State<1>| if state.q[0].abs() <= 0.5 { 0.0 } else { state.q[0] };
    assert_eq!(times(&flight().event(clipped, Crossing::Any).run(12).unwrap(), 0), [0.5]);
    // The end of the run, and a step that only rounding ends there.
    assert_eq!(times(&flight().event(|state| state.q[0], Crossing::Rising).run(4).unwrap(), 0), [1.0]);
    assert!(flight().event(|state| state.q[0], Crossing::Falling).run(12).unwrap().events().is_empty());
    // A function that is no number for a while has no zero there.
    let broken = |state: &State<1>| if state.q[0] < 0.1 { f64::NAN } else { state.q[0] - 0.6 };
    assert_eq!(times(&flight().event(broken, Crossing::Any).run(12).unwrap(), 0), [1.6]);
    // One that is never a number has none at all, and is seen where it is watched.
    let never = |_: &State<1>| f64::NAN;
    let run = flight().event(never, Crossing::Any).watch("never", never).run(12).unwrap();
    assert!(run.events().is_empty() && run.drift_of("never").unwrap().max_abs().is_nan());
    // At times where a rounding is large.
    let late = Simulation::new(Free, State::new([-1.0], [1.0]).at_time(1e12)).scheme(Leapfrog).dt(0.3);
    let run = late.event(|state| state.q[0], Crossing::Any).run(12).unwrap();
    assert!((times(&run, 0)[0] - 1e12 - 1.0).abs() <= 2e-4);
}

/// What stops a run ends it at its time: nothing after it is recorded or seen.
#[test]
fn a_stop_ends_the_run_where_it_happens() {
    let run = spring(Nystrom::order8(), 0.25)
        .event(|state| state.q[0] + 0.5, Crossing::Falling)
        .stop_when(|state| state.q[0], Crossing::Falling)
        .event(|state| state.q[0] - 0.1, Crossing::Any)
        .record_dt(0.1)
        .run_until(20.0)
        .unwrap();
    assert!(run.stopped());
    assert!((run.last().t - 0.5 * FRAC_PI_2).abs() < 1e-9 && run.last().q[0].abs() < 1e-15);
    assert_eq!(run.events().iter().map(Event::which).collect::<Vec<_>>(), [2, 1]);
    assert_eq!(run.events()[1].state(), run.last());
    assert_eq!((run.states().len(), run.steps()), (8, 4));
    assert!(run.states().iter().all(|state| state.t <= run.last().t));
    // Before the run ends by itself, and with nothing to stop it.
    let run = spring(Leapfrog, 0.01).stop_when(|state| state.q[0] - 2.0, Crossing::Any).run(1000).unwrap();
    assert!(!run.stopped() && run.steps() == 1000);
    // Adaptive steps that land on an end.
    let law = Kepler { gm: 1.0 };
    let ellipse = Simulation::new(law, law.pericentre(1.0, 0.8)).scheme(Nystrom::order8()).adaptive(1e-10);
    let run = ellipse.stop_when(|state| state.q[1], Crossing::Falling).run_until(100.0).unwrap();
    assert!((run.last().t - PI).abs() < 1e-8 && (run.last().q[0] + 1.8).abs() < 1e-8, "{:?}", run.last());
}

/// What goes on from where it was stopped does not stop there again: the state at an event is behind it, or on it.
#[test]
fn a_motion_goes_on_from_a_stop() {
    /// As many stops as there are, whatever the legs.
    fn legs<S: Scheme<Particle<Pendulum, 1>> + Copy>(scheme: S, dt: f64, level: f64, crossing: Crossing) -> Vec<f64> {
        let (end, mut last, mut stops) = (40.0, State::new([1.0], [0.1]), Vec::new());
        while last.t < end {
            let run = Simulation::new(Pendulum { k: 0.7 }, last)
                .scheme(scheme)
                .dt(dt)
                .stop_when(|state| state.q[0] - level, crossing)
                .run_until(end)
                .unwrap();
            last = *run.last();
            assert!(stops.len() < 40, "{scheme:?} stands at {last:?}");
            stops.extend(run.stopped().then_some(last.t));
        }
        stops
    }
    let mut seen = 0;
    for level in [0.0, 0.1, 0.3, -0.7, 0.5, 1e-9] {
        for crossing in [Crossing::Any, Crossing::Falling, Crossing::Rising] {
            for dt in [0.01, 0.17] {
                macro_rules! legs {
                    ($($scheme:expr),*) => {$({
                        let stops = legs($scheme, dt, level, crossing);
                        assert!(stops.windows(2).all(|pair| pair[1] > pair[0] + 0.1), "{stops:?}");
                        let whole = Simulation::new(Pendulum { k: 0.7 }, State::new([1.0], [0.1]))
                            .scheme($scheme)
                            .dt(dt)
                            .event(|state| state.q[0] - level, crossing)
                            .run_until(40.0)
                            .unwrap();
                        assert_eq!(stops.len(), times(&whole, 0).len(), "{level} {crossing:?} {dt}");
                        seen += stops.len();
                    })*};
                }
                legs!(Leapfrog, Nystrom::order6(), DiscreteGradient, Implicit, Gauss::order16());
            }
        }
    }
    assert!(seen > 1000, "{seen}");
}

/// Of two runs, one that is stopped and one that goes on from there, one tells of each event, also where several happen at once: in
/// whatever order they were asked for, and as an encounter.
#[test]
fn what_happens_as_a_run_is_stopped_is_told_once() {
    let line = || Scene::<1>::new().body(1.0, [0.0], [0.0]).body(1.0, [3.0], [-1.0]).body(0.3, [-9.0], [2.0]);
    let near = |at: f64| move |state: &SceneState<1>| state.q[1][0] - state.q[0][0] - at;
    let mut checked = 0;
    macro_rules! both {
        ($scheme:expr, $scene:expr, $end:expr, |$s:ident| $attended:expr) => {{
            let anew = |$s: Simulation<(), _>| $attended.scheme($scheme).dt(0.07).run_until($end).unwrap();
            let first = anew(Simulation::scene($scene));
            let last = first.last().clone();
            let second = anew(Simulation::scene($scene.starting_from(&last)));
            assert!(first.stopped() && first.events().iter().all(|event| event.state().t <= last.t));
            checked += 1;
            [first.events().to_vec(), second.events().to_vec()]
        }};
    }
    macro_rules! schemes {
        ($($scheme:expr),*) => {$(
            for at in [0.5, 0.7, 1.0 / 3.0, 0.1] {
                let told = |events: [Vec<Event<SceneState<1>>>; 2]| {
                    events.concat().iter().filter(|event| event.bodies() == Some([0, 1]) || event.which() == 1).count()
                };
                let end = 3.0 - at + 0.5;
                let events = both!($scheme, line(), end, |s| s.stop_when(near(at), Crossing::Falling).encounter(at));
                assert_eq!(told(events), 1, "{at}");
                let events = both!($scheme, line(), end, |s| s.stop_when(near(at), Crossing::Falling).event(near(at), Crossing::Any));
                assert_eq!(told(events), 1, "{at}");
                // The same but for the rounding of its values, and from below.
                let other = |state: &SceneState<1>| 3.0 * (at + state.q[0][0]) - 3.0 * state.q[1][0];
                let events = both!($scheme, line(), end, |s| s.stop_when(near(at), Crossing::Falling).event(other, Crossing::Rising));
                assert_eq!(told(events), 1, "{at}");
                // Later in the step of the stop, it is told by the second.
                let events = both!($scheme, line(), end, |s| s.stop_when(near(at), Crossing::Falling).event(near(at - 1e-9), Crossing::Any));
                assert_eq!(events.map(|events| events.iter().filter(|event| event.which() == 1).count()), [0, 1], "{at}");
            }
        )*};
    }
    schemes!(Leapfrog, Nystrom::order6(), DiscreteGradient, Gauss::order16());
    assert_eq!(checked, 64);
}

#[test]
fn observers_see_every_nth_state_and_may_stop() {
    let (seen, other) = (Cell::new(0), Cell::new(0));
    let run = spring(Leapfrog, 0.01)
        .observe(7, |state| {
            seen.set(seen.get() + 1);
            assert!((state.t - 0.07 * f64::from(seen.get())).abs() < 1e-12);
            if seen.get() == 5 { ControlFlow::Break(()) } else { ControlFlow::Continue(()) }
        })
        .observe(5, |_| {
            other.set(other.get() + 1);
            ControlFlow::Continue(())
        })
        .observe(0, |_| panic!("never"))
        .record_every(100)
        .run(1000)
        .unwrap();
    assert_eq!((run.steps(), run.stopped(), seen.get(), other.get()), (35, true, 5, 7));
    assert!((run.last().t - 0.35).abs() < 1e-15);
    let whole = spring(Leapfrog, 0.01).record_every(100).run(35).unwrap();
    assert_eq!(run.last(), whole.last());
    assert_eq!(run.drift(Invariant::Energy).unwrap().max_abs(), whole.drift(Invariant::Energy).unwrap().max_abs());
}

/// Encounters name the bodies; those that are near at the start have met before.
#[test]
fn encounters_name_the_bodies() {
    let scene = Scene::<2>::new()
        .body(1.0, [0.0, 0.0], [0.0, 0.0])
        .body(1.0, [0.1, 0.0], [0.0, 0.0])
        .body(1.0, [-3.0, 0.0], [1.0, 0.0])
        .body(1.0, [0.0, 5.0], [0.0, -1.0])
        .body(1.0, [10.0, 10.0], [0.0, 0.0]);
    let run = Simulation::scene(scene).scheme(Leapfrog).dt(0.07).encounter(0.5).run_until(6.0).unwrap();
    let met: Vec<_> = run.events().iter().map(|event| (event.bodies().unwrap(), event.state().t)).collect();
    let pairs: Vec<_> = met.iter().map(|&(pair, _)| pair).collect();
    assert_eq!(pairs, [[0, 2], [1, 2], [0, 3], [1, 3]]);
    for ((_, t), exact) in met.iter().zip([2.5, 2.6, 4.5, 5.0 - (0.25_f64 - 0.01).sqrt()]) {
        assert!((t - exact).abs() < 1e-12, "{t} {exact}");
    }
    // In a box the nearest image counts.
    let two = Scene::<1>::new().body(1.0, [0.5], [0.0]).body(1.0, [8.0], [1.0]).periodic([10.0]);
    let run = Simulation::scene(two).scheme(Leapfrog).dt(0.3).encounter(0.5).run_until(11.0).unwrap();
    assert_eq!(run.events().len(), 1);
    assert!((run.events()[0].state().t - 2.0).abs() < 1e-13);
    let lone = Scene::<2>::new().body(1.0, [0.0, 0.0], [1.0, 0.0]).pairs(Gravity { g: 1.0 });
    assert!(
        Simulation::scene(lone.clone()).scheme(Leapfrog).dt(0.1).encounter(0.5).run(9).unwrap().events().is_empty()
    );
    for distance in [0.0, -1.0, f64::NAN, f64::INFINITY] {
        let refused = Simulation::scene(lone.clone()).scheme(Leapfrog).dt(0.1).encounter(distance).run(9).unwrap_err();
        assert!(matches!(refused.cause(), Error::Scene(dmech::SceneError::Encounter { .. })));
    }
}

/// A pendulum that is never stopped keeps its events to rounding over many periods: none is lost, none is doubled.
#[test]
fn ten_thousand_events_lose_none() {
    let law = Pendulum { k: 1.0 };
    let simulation = Simulation::new(law, State::new([1.0], [0.0])).scheme(Nystrom::order6()).dt(0.1);
    let run = simulation.record_every(u64::MAX).event(|state| state.q[0], Crossing::Any).run_until(33_500.0).unwrap();
    assert!(run.events().len() > 9_900, "{}", run.events().len());
    let half = 3.349_914_735_000_2;
    let gaps = run.events().windows(2).map(|pair| pair[1].state().t - pair[0].state().t);
    let worst = gaps.fold(0.0, |worst: f64, gap| worst.max((gap - half).abs()));
    assert!(worst < 1e-4, "{worst:e}");
    let signs = run.events().windows(2).all(|pair| pair[0].crossing() != pair[1].crossing());
    assert!(signs);
}

/// The crossings of Hénon and Heiles's section at E = 1/8: times and places against a run in 31 digits, whose events it finds with
/// the same words.
#[test]
fn a_poincare_section_is_exact() {
    use dmech::models::HenonHeiles;
    let vx = (2.0_f64 * 0.125 - 0.16 * 0.16 + 2.0 / 3.0 * 0.16_f64.powi(3)).sqrt();
    let law = HenonHeiles { lambda: 1.0 };
    let run = Simulation::new(law, State::new([0.0, 0.16], [vx, 0.0])).scheme(Nystrom::order8()).dt(0.0625);
    let run = run.event(|state| state.q[0], Crossing::Rising).record_every(u64::MAX).run_until(200.0).unwrap();
    let exact = State::<2, DoubleDouble>::of([0.0, 0.16].map(Into::into), [vx, 0.0].map(Into::into));
    let exact = Simulation::new(law, exact).scheme(Nystrom::order8()).dt(0.03125).record_every(u64::MAX);
    let exact = exact.event(|state| state.q[0].to_f64(), Crossing::Rising).run_until(200.0).unwrap();
    assert_eq!((run.events().len(), exact.events().len()), (32, 32));
    for (event, exact) in run.events().iter().zip(exact.events()) {
        let (state, exact) = (event.state(), exact.state());
        assert!((state.t - exact.t).abs() < 1e-10, "{} {}", state.t, exact.t);
        assert!((state.q[1] - exact.q[1].to_f64()).abs() < 1e-10 && (state.v[1] - exact.v[1].to_f64()).abs() < 1e-10);
    }
}

/// Infinite values have a sign; what happens after a stop in the same step is no event; what stops a run is what it ends with.
#[test]
fn edges_of_events() {
    let broken = |state: &State<1>| if state.q[0] > 0.2 { f64::INFINITY } else { -1.0 };
    let run = spring(Nystrom::order8(), 0.1).event(broken, Crossing::Falling).run_until(1.0).unwrap();
    assert!((run.events()[0].state().t - 0.5 * 0.2_f64.acos()).abs() < 1e-9);
    let run = spring(Nystrom::order8(), 0.5)
        .stop_when(|state| state.q[0] - 0.1, Crossing::Falling)
        .event(|state| state.q[0], Crossing::Falling)
        .run_until(9.0)
        .unwrap();
    assert_eq!(run.events().iter().map(Event::which).collect::<Vec<_>>(), [0]);
    // The drift is that of what is recorded and of the last state, not of a step that goes on beyond the stop.
    let law = Kepler { gm: 1.3 };
    let fall = Simulation::new(law, State::new([1.0, 0.0], [0.0, 0.1])).scheme(Leapfrog).dt(0.05);
    let run = fall.stop_when(|state| state.q[0] - 0.1, Crossing::Falling).run_until(9.0).unwrap();
    let energy =
        |state: &State<2>| 0.5 * (state.v[0].powi(2) + state.v[1].powi(2)) - 1.3 / state.q[0].hypot(state.q[1]);
    let first = energy(&run.states()[0]);
    let most = run.states().iter().chain([run.last()]).map(|state| (energy(state) - first).abs()).fold(0.0, f64::max);
    let drift = run.drift(Invariant::Energy).unwrap().max_abs();
    assert!((drift / most - 1.0).abs() < 1e-12, "{drift} {most}");
    // A falling zero on the end of a step; output at the very time of a stop there.
    let clock = |to: f64| move |state: &State<1>| to - state.t;
    let run = spring(Leapfrog, 0.25).event(clock(0.5), Crossing::Falling).run(9).unwrap();
    assert_eq!(times(&run, 0), [0.5]);
    let run =
        spring(Leapfrog, 0.25).stop_when(clock(0.5), Crossing::Falling).record_at([0.25, 0.5, 0.75]).run(9).unwrap();
    assert_eq!((run.states().len(), run.steps(), run.last().t), (2, 2, 0.5));
    // Bodies that start at the distance of an encounter have met.
    let scene = Scene::<1>::new().body(1.0, [0.0], [0.0]).body(1.0, [0.5], [-0.1]);
    assert!(Simulation::scene(scene).scheme(Leapfrog).dt(0.1).encounter(0.5).run(9).unwrap().events().is_empty());
    // An event costs its shortened steps, each of which evaluates the force at its start as well.
    let without = spring(Leapfrog, 0.25).run(9).unwrap().report().evaluations();
    let with = spring(Leapfrog, 0.25).event(|state| state.q[0] - 0.1, Crossing::Falling).run(9).unwrap();
    let cost = with.report().evaluations() - without;
    assert!(cost.is_multiple_of(2) && (6..=24).contains(&cost), "{cost}");
}

/// The first shortened step ends on the pole itself, to the bit; the step that is made does not.
#[test]
fn an_event_on_a_pole_ends_no_run() {
    #[derive(Clone, Copy, Debug)]
    struct Between {
        a: f64,
    }
    #[dmech::law]
    impl Between {
        #[potential]
        fn energy(&self, q: f64) -> f64 {
            -self.a * (1.0 - q * q).ln()
        }
    }
    let run = || Simulation::new(Between { a: 0.001 }, State::new([0.3], [1.0])).scheme(Leapfrog).dt(0.3);
    // Beyond it there is no potential.
    let left = |failed: Result<Run<State<1>>, dmech::Interrupted<State<1>>>| {
        let failed = failed.unwrap_err();
        assert_eq!((failed.cause(), failed.run().steps()), (Error::LeftDomain { time: 6.0 }, 20));
        failed.into_run()
    };
    let watched = left(run().event(|state| state.q[0] - 1.0, Crossing::Rising).run(20));
    assert_eq!(watched.last(), left(run().run(20)).last());
    let passed = watched.events()[0].state();
    assert!(passed.q[0] >= 1.0 && (passed.t - 0.7).abs() < 0.01, "{passed:?}");
}

/// A force that jumps where the event is: shortened steps that would end on the seam have no solution, and the event is the first state
/// behind it that one has, within what the step knows of the seam. The steps are those of a run without events.
#[test]
fn on_a_seam_at_which_the_force_jumps() {
    #[derive(Clone, Copy, Debug, dmech::Law)]
    #[potential(|q: [f64; 1]| self.k * q[0].abs())]
    struct Ridge {
        k: f64,
    }

    /// Drag in the floor alone.
    #[derive(Clone, Copy, Debug)]
    struct Mud {
        g: f64,
        d: f64,
    }

    #[dmech::law]
    impl Mud {
        #[potential]
        fn energy(&self, q: [f64; 1]) -> f64 {
            self.g * q[0]
        }
        #[force]
        fn drag(&self, q: [f64; 1], v: [f64; 1]) -> [f64; 1] {
            [if q[0] < 0.0 { -self.d * v[0] } else { 0.0 }]
        }
    }

    fn check<L: Law<1> + Copy, S: Scheme<Particle<L, 1>>>(law: L, scheme: S, dt: f64, exact: impl Fn(f64) -> f64) {
        let mut found = 0;
        for k in 0..60 {
            let height = 1.0 + 0.013 * f64::from(k);
            let fall = Simulation::new(law, State::new([height], [0.0])).scheme(scheme).dt(dt);
            let Ok(alone) = fall.clone().run_until(2.3) else { continue };
            let run = fall.clone().event(|state| state.q[0], Crossing::Falling).run_until(2.3);
            let run = run.unwrap_or_else(|error| panic!("{}, from {height}: {error}", S::NAME));
            assert_eq!(run.states(), alone.states());
            let [event] = run.events() else { panic!("{}, from {height}: {} events", S::NAME, run.events().len()) };
            let State { t, q, v } = *event.state();
            assert!((t - exact(height)).abs() < dt * dt, "{}, from {height}: {t}", S::NAME);
            // By a sixteenth of a step the force differs by no more than its jump.
            assert!(q[0] <= 0.0 && q[0] > -(dt / 16.0).powi(2) && v[0] < 0.0, "{}, from {height}: {q:?}", S::NAME);
            // Output in the same steps.
            let times = (0..40).map(|n| 0.057 * f64::from(n));
            assert_eq!(fall.record_at(times).run_until(2.3).unwrap().states().len(), 40);
            found += 1;
        }
        assert!(found > 40, "{}: {found}", S::NAME);
    }

    let ridge = Ridge { k: 1.3 };
    let fall = |k: f64| move |height: f64| (2.0 * height / k).sqrt();
    check(ridge, Implicit, 0.1, fall(1.3));
    check(ridge, DiscreteGradient, 0.1, fall(1.3));
    let mud = Mud { g: 1.3, d: 20.0 };
    check(mud, Implicit, 0.07, fall(1.3));
    check(mud, DiscreteGradient, 0.07, fall(1.3));
    check(mud, Composed::order4(DiscreteGradient), 0.07, fall(1.3));
}

/// An event and a stop that are a rounding apart: what the stop is not behind is an event of the run that goes on, and of that alone.
#[test]
fn once_where_a_stop_is_a_rounding_away() {
    let (mut both, mut stopped) = (0, 0);
    for i in 0..400 {
        let event = 0.3 + 1e-3 * f64::from(i);
        for roundings in -3..=3 {
            let stop = event + f64::from(roundings) * 0.25 * f64::EPSILON;
            let run = |start| {
                Simulation::new(Spring { k: 4.0 }, start)
                    .scheme(Nystrom::order8())
                    .dt(0.2)
                    .event(move |state: &State<1>| state.q[0] - event, Crossing::Falling)
                    .stop_when(move |state: &State<1>| state.q[0] - stop, Crossing::Falling)
            };
            let first = run(State::new([1.0], [0.0])).run_until(3.0).unwrap();
            stopped += u32::from(first.stopped());
            let next = run(*first.last()).run(3).unwrap();
            assert_eq!(times(&first, 0).len() + times(&next, 0).len(), 1, "{event}, {roundings}");
            assert_eq!(times(&next, 1).len(), 0);
            both += times(&first, 0).len();
        }
    }
    assert!(stopped == 2800 && both > 1000 && both < 2700, "{both} of {stopped}");
}
