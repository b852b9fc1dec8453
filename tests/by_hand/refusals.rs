//! Bad input, and runs that cannot go on.

use crate::common::{Kepler, SUN, greenspan_orbit};
use approx::assert_abs_diff_eq;
use dmech_core::prelude::*;

type Outcome = Result<Run<State<2>>, Interrupted<State<2>>>;

fn cause(outcome: Outcome) -> Error {
    let interrupted = outcome.unwrap_err();
    assert!(interrupted.run().states().is_empty() && interrupted.run().steps() == 0);
    assert_eq!(interrupted.to_string(), interrupted.cause().to_string());
    interrupted.cause()
}

#[test]
fn bad_input_is_refused_before_the_first_step() {
    let orbit = || Simulation::new(SUN, greenspan_orbit()).scheme(Leapfrog);
    for dt in [0.0, -0.0, -0.1, f64::NAN, f64::INFINITY, f64::NEG_INFINITY] {
        assert!(matches!(cause(orbit().dt(dt).run(10)), Error::TimeStep { .. }), "{dt}");
        assert!(cause(orbit().dt(dt).run(10)).to_string().contains(&format!("dt = {dt}")));
        assert!(orbit().dt(dt).stepper().is_err());
    }
    for mass in [0.0, -1.0, f64::NAN, f64::INFINITY] {
        assert!(matches!(cause(orbit().mass(mass).dt(0.1).run(10)), Error::Mass { .. }), "{mass}");
    }
    assert_eq!(cause(orbit().run(10)), Error::MissingTimeStep);
    assert_eq!(cause(orbit().dt(0.1).record_every(0).run(10)), Error::RecordEvery);
    for end in [f64::NAN, f64::INFINITY, 1e300] {
        assert!(matches!(cause(orbit().dt(0.1).run_until(end)), Error::EndTime { .. }), "{end}");
    }
    for bad in [f64::NAN, f64::INFINITY] {
        for (start, quantity) in [
            (State::new([0.5, bad], [0.0, 1.63]), "q"),
            (State::new([0.5, 0.0], [bad, 1.63]), "v"),
            (greenspan_orbit().at_time(bad), "t"),
        ] {
            let error = cause(Simulation::new(SUN, start).scheme(Leapfrog).dt(0.1).run(10));
            assert!(matches!(error, Error::State { quantity: q, .. } if q == quantity), "{error}");
        }
    }
    let at_the_sun = Simulation::new(SUN, State::new([0.0, 0.0], [0.0, 1.0])).scheme(Leapfrog).dt(0.1);
    assert!(matches!(cause(at_the_sun.run(10)), Error::Law { quantity: "potential", .. }));
    // A time step or a mass that the scalar in use cannot hold.
    let single: State<2, f32> = State::of([0.5, 0.0], [0.0, 1.63]);
    let narrow = || Simulation::new(SUN, single).scheme(Leapfrog);
    assert_eq!(narrow().dt(1e-60).stepper().unwrap_err(), Error::TimeStep { dt: 1e-60 });
    assert_eq!(narrow().dt(0.1).mass(1e60).stepper().unwrap_err(), Error::Mass { mass: 1e60 });
    for (error, told) in [
        (
            Error::TimeStep { dt: 1e-60 },
            "the time step, dt = 1e-60, is no positive, finite number of the scalar of the motion",
        ),
        (Error::Mass { mass: 1e60 }, "the mass, 1e60, is no positive, finite number of the scalar of the motion"),
    ] {
        let text = error.to_string();
        assert!(text.starts_with(told) && text.contains("`f32`"), "{text}");
    }
    assert_eq!(Error::Mass { mass: -0.5 }.to_string(), "the mass must be positive and finite, not -0.5");
}

/// x/r³ is 0 at 10¹⁵⁰, where −k/r still has a slope: without a force the planet would leave in a straight line.
#[test]
fn a_force_below_the_smallest_number_is_refused() {
    let start = State::new([0.0, 0.5e150], [1.63, 0.0]);
    let error = cause(Simulation::new(Kepler::<true> { k: 1.3e150 }, start).scheme(Leapfrog).dt(1e148).run(10));
    let Error::Underflow { coordinate, slope, time } = error else { panic!("{error}") };
    assert!((coordinate, time) == (1, 0.0) && (slope / 5.2e-150 - 1.0).abs() < 0.01, "{error}");
}

/// The velocity of leap-frog is the mean of two that are finite, and finite.
#[test]
fn speeds_near_the_largest_number_are_recorded() {
    fn check<S: Scheme<Particle<Kepler<true>, 2>>>(scheme: S) {
        let start = State::new([1e200, 2.0], [1.2e308, 0.0]);
        let run = Simulation::new(Kepler::<true> { k: 1e-3 }, start).scheme(scheme).dt(1e-100).run(3).unwrap();
        assert!(run.states().iter().all(|s| s.q[0].is_finite() && s.v == [1.2e308, 0.0]), "{:?}", run.last());
    }
    check(Leapfrog);
    check(Composed::order4(Leapfrog));
}

/// Straight into the centre: each scheme either passes or stops, and what it did until then is there.
#[test]
fn a_run_that_fails_keeps_what_it_has() {
    fn fall<S: Scheme<Particle<Kepler<true>, 2>>>(scheme: S) -> Outcome {
        Simulation::new(SUN, State::new([0.5, 0.0], [0.0, 0.0])).scheme(scheme).dt(0.05).record_every(3).run(100_000)
    }
    let mut failed = 0;
    for outcome in [fall(Explicit), fall(Leapfrog), fall(Implicit), fall(DiscreteGradient), fall(Kanatani)] {
        let Err(interrupted) = outcome else { continue };
        failed += 1;
        let run = interrupted.run();
        println!("{interrupted}");
        assert_eq!(run.states().len() as u64, 1 + run.steps() / 3);
        assert_eq!(run.states()[0].q, [0.5, 0.0]);
        assert_abs_diff_eq!(run.last().t, 0.05 * run.steps() as f64, epsilon = 1e-15);
        assert!(run.states().iter().chain([run.last()]).all(|s| s.q.iter().chain(&s.v).all(|x| x.is_finite())));
        assert!(run.drift(Invariant::Energy).is_some());
        assert!(interrupted.to_string().contains(&format!("step {}", run.steps() + 1)), "{interrupted}");
        match interrupted.cause() {
            Error::NotConverged { step, time, dt, iterations, residual } => {
                assert_eq!((step, dt), (run.steps() + 1, 0.05));
                assert_eq!(time, run.last().t);
                assert!(iterations > 0 && residual > 0.0);
            }
            Error::NotFinite { step, .. } => assert_eq!(step, run.steps() + 1),
            other => panic!("{other}"),
        }
        let boxed: Box<dyn std::error::Error + Send + Sync> = Box::new(interrupted);
        assert!(boxed.to_string().contains("states recorded"));
    }
    assert!(failed >= 2, "only {failed} schemes failed");
}

/// A stepper that fails stays where it was, and fails in the same way again.
#[test]
fn a_stepper_that_fails_stays_where_it_was() {
    let start = State::new([0.5, 0.0], [0.0, 0.0]);
    let mut stepper = Simulation::new(SUN, start).scheme(Implicit).dt(0.05).stepper().unwrap();
    let error = (0..1000).find_map(|_| stepper.step().err()).expect("the fall ends");
    let (state, steps) = (stepper.state(), stepper.steps());
    assert_eq!(stepper.step().unwrap_err(), error);
    assert_eq!((stepper.state(), stepper.steps()), (state, steps));
}

#[test]
fn recording_is_as_asked() {
    let orbit = || Simulation::new(SUN, greenspan_orbit().at_time(2.0)).scheme(Leapfrog).dt(0.01);
    let all = orbit().run(1005).unwrap();
    let some = orbit().record_every(10).run(1005).unwrap();
    assert_eq!((all.states().len(), some.states().len()), (1006, 101));
    for (k, state) in some.states().iter().enumerate() {
        assert_eq!(*state, all.states()[10 * k]);
        assert_eq!(state.t, 2.0 + (10 * k) as f64 * 0.01);
    }
    assert_eq!((some.last(), some.steps()), (all.last(), 1005));
    assert_ne!(some.last(), some.states().last().unwrap());
    // Also without a step there is a first and last state.
    let none = orbit().run_until(2.0).unwrap();
    assert_eq!((none.states().len(), none.steps(), *none.last()), (1, 0, greenspan_orbit().at_time(2.0)));
    // 0.3/0.1 is 2.9999999999999996 and 0.7/0.1 is 6.999999999999999: neither needs a step more, nor a step less.
    for (end, dt, steps) in [(2.3, 0.1, 3), (2.7, 0.1, 7), (2.35, 0.1, 4), (352.0, 0.01, 35_000), (3.0, 1.0 / 3.0, 3)] {
        let run = Simulation::new(SUN, greenspan_orbit().at_time(2.0)).scheme(Leapfrog).dt(dt).run_until(end).unwrap();
        assert_eq!(run.steps(), steps, "until {end}");
    }
}

/// Twice the mass in twice the field moves the same way, under every scheme.
#[test]
fn mass_and_field_may_be_doubled() {
    fn check<S: Scheme<Particle<Kepler<true>, 2>>>(scheme: S) {
        let light = Simulation::new(Kepler { k: 1.3 }, greenspan_orbit()).mass(0.7).scheme(scheme).dt(0.01).run(1000);
        let heavy = Simulation::new(Kepler { k: 2.6 }, greenspan_orbit()).mass(1.4).scheme(scheme).dt(0.01).run(1000);
        let (light, heavy) = (light.unwrap(), heavy.unwrap());
        for (s, u) in light.states().iter().zip(heavy.states()) {
            assert!((s.q[0] - u.q[0]).abs() < 1e-12 && (s.v[1] - u.v[1]).abs() < 1e-12);
        }
        let ratio = heavy.drift(Invariant::Energy).unwrap().start() / light.drift(Invariant::Energy).unwrap().start();
        assert_abs_diff_eq!(ratio, 2.0, epsilon = 1e-15);
    }
    check(Explicit);
    check(Leapfrog);
    check(Implicit);
    check(DiscreteGradient);
    check(Kanatani);
}

/// Where the motion ends before it starts, and where time does not move on: for every way to step.
#[test]
fn a_run_that_cannot_advance_in_time_is_refused() {
    let orbit = |t: f64| Simulation::new(SUN, greenspan_orbit().at_time(t)).scheme(DiscreteGradient);
    let span = Error::Span { start: 2.0, end: 1.0 };
    assert_eq!(cause(orbit(2.0).dt(0.1).run_until(1.0)), span);
    assert_eq!(cause(orbit(2.0).adaptive(1e-6).run_until(1.0)), span);
    assert!(span.to_string().contains("from t = 2 to t = 1"), "{span}");

    let still = Error::TimeStandsStill { time: 1e17, dt: 0.1, next: 16.0 };
    assert_eq!(cause(orbit(1e17).dt(0.1).run(10)), still);
    assert_eq!(cause(orbit(1e17).dt(0.1).run_until(2e17)), still);
    assert_eq!(orbit(1e17).dt(0.1).stepper().unwrap_err(), still);
    assert_eq!(
        still.to_string().split(';').next().unwrap(),
        "at t = 1e17 time stands still in steps of 0.1: the next number is 16 later"
    );
    assert_eq!(orbit(1e17).dt(32.0).run_until(1e17 + 320.0).unwrap().steps(), 10);
}

/// More steps than there are numbers to count them, or times for them.
#[test]
fn a_number_of_steps_beyond_all_bounds_is_refused() {
    let orbit = || Simulation::new(SUN, greenspan_orbit()).scheme(Leapfrog).dt(0.25);
    let mut stepper = orbit().stepper().unwrap();
    stepper.advance(3).unwrap();
    let error = stepper.advance(u64::MAX).unwrap_err();
    assert!(matches!(error, Error::TimeStandsStill { dt: 0.25, .. }), "{error}");
    assert_eq!(stepper.steps(), 3);
    stepper.advance(2).unwrap();
    assert_eq!((stepper.steps(), stepper.t()), (5, 1.25));
    assert!(matches!(cause(orbit().run(u64::MAX)), Error::TimeStandsStill { .. }));
    // Steps that follow the motion end by themselves: here in a collision.
    let fall = Simulation::new(SUN, State::new([0.5, 0.0], [0.0, 0.0])).scheme(Nystrom::order4()).adaptive(1e-3);
    let mut stepper = fall.stepper().unwrap();
    stepper.advance(3).unwrap();
    let error = stepper.advance(u64::MAX).unwrap_err();
    assert!(matches!(error, Error::StepVanished { .. }), "{error}");
}

/// Near t = 0 each step changes the time, however short it is; an end that no number of them comes to is refused there as elsewhere.
#[test]
fn an_end_beyond_the_reach_of_steps_that_follow_the_motion_is_refused() {
    // A period of 2π·10⁻³⁰.
    let oscillator = |t| Simulation::new(Bowl { broken: &[] }, State { t, ..State::new([0.3], [0.0]) }).mass(1e-60);
    for t in [0.0, -1e-35, 1e-300, 1.0] {
        let adaptive = oscillator(t).scheme(Nystrom::order8()).adaptive(1e-9);
        let failed = adaptive.clone().run_until(2.0).unwrap_err();
        assert!(matches!(failed.cause(), Error::StepVanished { dt, .. } if dt < 1e-29), "from {t}: {failed}");
        assert_eq!(failed.run().steps() > 1000, t != 1.0, "from {t}: {failed}");
        if t != 1.0 {
            // One that comes to it, and none.
            assert!(adaptive.clone().run_until(t + 1e-25).unwrap().steps() > 10_000);
            assert_eq!(adaptive.run(10_000).unwrap().steps(), 10_000);
        }
    }
    // A motion that begins so fast, and does not stay so.
    let thrown = State::new([1e-22, 0.0], [3e11, 0.0]);
    let run = Simulation::new(SUN, thrown).scheme(Nystrom::order4()).adaptive(1e-3).run_until(2.0).unwrap();
    assert!(run.report().dt_range().unwrap()[0] < 1e-17 * run.last().t);
}

/// x²/2, of which some quantities are not a number beyond x = 1/2.
#[derive(Clone, Copy, Debug)]
pub(crate) struct Bowl {
    pub(crate) broken: &'static [&'static str],
}

impl Bowl {
    fn unless_broken(&self, quantity: &str, at: f64, value: f64) -> f64 {
        if at > 0.5 && self.broken.contains(&quantity) { f64::NAN } else { value }
    }
}

impl Conservative for Bowl {}
impl Potential<1> for Bowl {
    fn potential(&self, [x]: [f64; 1]) -> f64 {
        self.unless_broken("potential", x, 0.5 * x * x)
    }
    fn gradient(&self, [x]: [f64; 1]) -> [f64; 1] {
        [self.unless_broken("force", x, x)]
    }
    fn hessian(&self, [x]: [f64; 1]) -> [[f64; 1]; 1] {
        [[self.unless_broken("second derivative", x, 1.0)]]
    }
    fn discrete_gradient(&self, [a]: [f64; 1], [b]: [f64; 1]) -> [f64; 1] {
        [self.unless_broken("discrete gradient", b, 0.5 * (a + b))]
    }
    fn discrete_gradient_jacobian(&self, _: [f64; 1], [b]: [f64; 1]) -> [[f64; 1]; 1] {
        [[self.unless_broken("Jacobian of the discrete gradient", b, 0.5)]]
    }
}

/// A number that is none is named, with its place, and not called a lack of convergence.
#[test]
fn a_law_that_is_not_finite_in_a_step_is_named() {
    fn check<S: Scheme<Particle<Bowl, 1>>>(scheme: S, broken: &'static [&'static str]) {
        let motion = |broken| Simulation::new(Bowl { broken }, State::new([0.0], [1.0])).scheme(scheme).dt(0.1);
        assert_eq!(motion(&[]).run(100).unwrap().steps(), 100);
        let interrupted = motion(broken).run(100).unwrap_err();
        let Error::LawInStep { quantity, value, place, step, time, dt } = interrupted.cause() else {
            panic!("{interrupted}")
        };
        assert!(quantity == broken[0] && value.is_nan(), "{interrupted}");
        assert_eq!((step, dt), (interrupted.run().steps() + 1, 0.1));
        assert_eq!(time, interrupted.run().last().t);
        let [x] = *place.first() else { panic!("{place:?}") };
        assert!(x > 0.5 && x < 0.6, "{interrupted}");
        let told = format!("the {quantity} of the law is NaN at q = 0.5");
        assert!(interrupted.to_string().contains(&told), "{interrupted}");
    }
    check(DiscreteGradient, &["discrete gradient"]);
    check(DiscreteGradient, &["Jacobian of the discrete gradient"]);
    check(DiscreteGradient, &["potential", "discrete gradient"]);
    check(Implicit, &["force"]);
    check(Implicit, &["second derivative"]);
    check(Kanatani, &["discrete gradient"]);
}

/// A law that is changed on the way is told where it has no value, which is not the start.
#[test]
fn a_law_that_was_changed_is_told_where_it_stands() {
    let motion = Simulation::new(Bowl { broken: &[] }, State::new([0.0], [1.0])).scheme(DiscreteGradient).dt(0.1);
    let mut stepper = motion.stepper().unwrap();
    stepper.advance(8).unwrap();
    stepper.law_mut().broken = &["force"];
    let told = stepper.step().unwrap_err().to_string();
    assert_eq!(told, "the force of the law is NaN where the motion begins or goes on, at t = 0.8");
}

/// Where the equation of a step is singular, its corrections are no numbers: then they are beyond all bounds.
#[test]
fn a_law_that_is_finite_is_not_blamed() {
    /// −8 (x² + y²), for which 1 + h² ∂∇̄Φ/2 is 0 at h = 1/2.
    #[derive(Clone, Copy, Debug)]
    struct Hill;
    impl Conservative for Hill {}
    impl Potential<2> for Hill {
        fn potential(&self, q: [f64; 2]) -> f64 {
            -8.0 * (q[0] * q[0] + q[1] * q[1])
        }
        fn gradient(&self, q: [f64; 2]) -> [f64; 2] {
            q.map(|x| -16.0 * x)
        }
        fn hessian(&self, _: [f64; 2]) -> [[f64; 2]; 2] {
            [[-16.0, 0.0], [0.0, -16.0]]
        }
        fn discrete_gradient(&self, a: [f64; 2], b: [f64; 2]) -> [f64; 2] {
            [-8.0 * (a[0] + b[0]), -8.0 * (a[1] + b[1])]
        }
        fn discrete_gradient_jacobian(&self, _: [f64; 2], _: [f64; 2]) -> [[f64; 2]; 2] {
            [[-8.0, 0.0], [0.0, -8.0]]
        }
    }
    let motion = |dt| Simulation::new(Hill, State::new([0.5, 0.0], [1.0, 0.0])).scheme(DiscreteGradient).dt(dt);
    assert_eq!(motion(0.25).run(3).unwrap().steps(), 3);
    let interrupted = motion(0.5).run(3).unwrap_err();
    let Error::NotConverged { step, dt, residual, .. } = interrupted.cause() else { panic!("{interrupted}") };
    assert_eq!((step, dt, residual), (1, 0.5, f64::INFINITY), "{interrupted}");
    assert!(interrupted.to_string().ends_with("take shorter steps (0 steps done, 1 states recorded)"), "{interrupted}");
}
