//! Steppers that change between steps: as a new simulation from the state now, for every scheme, on laws and on scenes.

use dmech::SceneError;
use dmech::extend::{DoubleDouble, Scheme, Watch};
use dmech::models::pairs::{Gravity, Spring};
use dmech::models::{Kepler, Pendulum};
use dmech::prelude::*;
use dmech::scene::{OnBonds, OnEach, OnPairs};
use dmech_core::extend::Particle;

const START: State<2> = State { t: 0.3, q: [0.8, 0.1], v: [0.0, 1.2] };

/// Law, state and step change; every time the motion is that of a new simulation, to the bit, and the time goes on.
fn law<S: Scheme<Particle<Kepler, 2>> + Copy>(scheme: S) {
    let begin =
        |gm, state: State<2>, dt| Simulation::new(Kepler { gm }, state).scheme(scheme).dt(dt).stepper().unwrap();
    let mut stepper = begin(1.3, START, 0.01);
    stepper.advance(37).unwrap();
    stepper.law_mut().gm = 0.9;
    assert_eq!(stepper.law().gm, 0.9);
    let mut other = begin(0.9, stepper.state(), 0.01);
    let same = |stepper: &mut dmech::Stepper<_, S>, other: &mut dmech::Stepper<_, S>| {
        for _ in 0..3 {
            stepper.step().unwrap();
            other.step().unwrap();
            assert_eq!(stepper.state(), other.state());
        }
        stepper.advance(20).unwrap();
        other.advance(20).unwrap();
        assert_eq!(stepper.state(), other.state());
    };
    same(&mut stepper, &mut other);
    stepper.set_dt(0.004).unwrap();
    same(&mut stepper, &mut begin(0.9, other.state(), 0.004));
    let moved = State { v: [0.1, -1.1], ..stepper.state() };
    stepper.set_state(moved).unwrap();
    assert_eq!(stepper.state(), moved);
    same(&mut stepper, &mut begin(0.9, moved, 0.004));
    assert_eq!(stepper.steps(), 37 + 3 * 23);
    assert!((stepper.t() - (0.3 + 0.37 + 0.23 + 2.0 * 23.0 * 0.004)).abs() < 1e-13);
    // What is refused changes nothing.
    let before = stepper.state();
    for dt in [0.0, -1.0, f64::NAN, f64::INFINITY] {
        assert!(matches!(stepper.set_dt(dt), Err(Error::TimeStep { .. })));
    }
    assert!(matches!(
        stepper.set_state(State { q: [f64::NAN, 0.0], ..before }),
        Err(Error::State { quantity: "q", .. })
    ));
    assert!(matches!(stepper.set_state(State { t: f64::INFINITY, ..before }), Err(Error::State { quantity: "t", .. })));
    assert!(stepper.set_state(State { q: [0.0; 2], ..before }).is_err());
    assert_eq!((stepper.state(), stepper.dt()), (before, 0.004));
    same(&mut stepper, &mut begin(0.9, moved, 0.004).advanced(23));
}

trait Advanced {
    fn advanced(self, steps: u64) -> Self;
}

impl<Y: dmech::extend::System, S: Scheme<Y>> Advanced for dmech::Stepper<Y, S> {
    fn advanced(mut self, steps: u64) -> Self {
        for _ in 0..3 {
            self.step().unwrap();
        }
        self.advance(steps - 3).unwrap();
        self
    }
}

#[test]
fn one_law_changes_under_every_scheme() {
    law(Leapfrog);
    law(CompensatedLeapfrog);
    law(Explicit);
    law(Implicit);
    law(DiscreteGradient);
    law(Kanatani);
    law(Kanatani.start(Start::BackwardStep));
    law(Nystrom::order6());
    law(Relaxed::order8());
    law(RungeKuttaNystrom::order12());
    law(ForceGradient::order6());
    law(Gauss::order16());
    law(LineIntegral::order6());
    law(Composed::order4(Leapfrog));
    law(Composed::order6(DiscreteGradient));
    law(Composed::order4(Implicit));
}

#[test]
fn adaptive_steppers_change_too() {
    let begin =
        |gm, state| Simulation::new(Kepler { gm }, state).scheme(Nystrom::order6()).adaptive(1e-8).stepper().unwrap();
    let mut stepper = begin(1.3, START);
    stepper.advance(40).unwrap();
    stepper.law_mut().gm = 0.9;
    let mut other = begin(0.9, stepper.state());
    for _ in 0..50 {
        stepper.step().unwrap();
        other.step().unwrap();
        assert_eq!(stepper.state(), other.state());
    }
    stepper.set_dt(1e-3).unwrap();
    stepper.step().unwrap();
    assert!((stepper.t() - other.t() - 1e-3).abs() < 1e-13, "{} {}", stepper.t(), other.t());
}

#[test]
fn the_energy_is_that_of_the_state() {
    let mut stepper = Simulation::new(Kepler { gm: 1.3 }, START).mass(1.7).scheme(Leapfrog).dt(0.01).stepper().unwrap();
    let energy = |gm: f64, state: State<2>| {
        0.5 * 1.7 * (state.v[0].powi(2) + state.v[1].powi(2)) - gm / state.q[0].hypot(state.q[1])
    };
    stepper.advance(11).unwrap();
    assert!((stepper.energy().unwrap() - energy(1.3, stepper.state())).abs() < 1e-15);
    stepper.law_mut().gm = 2.0;
    assert!((stepper.energy().unwrap() - energy(2.0, stepper.state())).abs() < 1e-15);
}

/// A law that has no value stands in the way of the next step, and a better one lets it go on.
#[test]
fn a_broken_law_is_told_by_the_next_step() {
    let mut stepper = Simulation::new(Kepler { gm: 1.3 }, START).scheme(Leapfrog).dt(0.01).stepper().unwrap();
    stepper.advance(5).unwrap();
    let state = stepper.state();
    stepper.law_mut().gm = f64::NAN;
    assert!(stepper.step().is_err() && stepper.advance(3).is_err());
    assert_eq!(stepper.state(), state);
    stepper.law_mut().gm = 1.3;
    stepper.step().unwrap();
    // Looking at it changes nothing.
    let same = stepper.clone();
    assert_eq!(stepper.law_mut().gm, 1.3);
    assert_eq!(stepper.steps(), same.steps());
    // On a body of a scene: after so many steps.
    let sun = Scene::new().body(1.0, START.q, START.v).field(Kepler { gm: 1.3 });
    let mut scene = Simulation::scene(sun).scheme(Leapfrog).dt(0.01).stepper().unwrap();
    scene.advance(5).unwrap();
    scene.law_mut::<Kepler>().unwrap().gm = f64::NAN;
    let told = scene.step().unwrap_err();
    assert!(matches!(told, Error::Body { body: 0, step: 5, time, .. } if time == scene.t()), "{told:?}");
}

type Laws = ((((), OnBonds<Spring>), OnPairs<Gravity>), OnEach<Wind>);

fn web() -> Scene<2, (), Laws> {
    Scene::new()
        .body(1.0, [0.0, 0.0], [0.0, 0.0])
        .body(1.3, [1.1, 0.0], [0.0, 0.3])
        .body(0.7, [2.0, 0.4], [0.1, 0.0])
        .pin(0)
        .bonds(Spring { k: 3.0, length: 1.0 }, [(0, 1), (1, 2)])
        .pairs(Gravity { g: 0.2 })
        .field(Wind { blow: 0.1 })
}

#[derive(Clone, Copy, Debug)]
struct Wind {
    blow: f64,
}

#[dmech::law]
impl Wind {
    #[potential]
    fn energy(&self, q: [f64; 2]) -> f64 {
        -self.blow * q[0]
    }
}

macro_rules! scene {
    ($scheme:expr) => {{
        let mut stepper = Simulation::scene(web()).scheme($scheme).dt(0.01).stepper().unwrap();
        stepper.advance(25).unwrap();
        stepper.set_body(1, [1.2, 0.2], [0.0, -0.2]).unwrap();
        stepper.set_body(0, [0.0, 0.1], [0.0, 0.0]).unwrap();
        stepper.law_mut::<Wind>().unwrap().blow = 0.4;
        stepper.law_mut::<Spring>().unwrap().k = 2.0;
        assert!(stepper.law_mut::<Kepler>().is_none());
        let state = stepper.state();
        assert_eq!((state.q[1], state.v[1], state.q[0]), ([1.2, 0.2], [0.0, -0.2], [0.0, 0.1]));
        // The same, set up anew.
        let scene = Scene::new()
            .body(1.0, state.q[0], state.v[0])
            .body(1.3, state.q[1], state.v[1])
            .body(0.7, state.q[2], state.v[2])
            .pin(0)
            .at_time(state.t)
            .bonds(Spring { k: 2.0, length: 1.0 }, [(0, 1), (1, 2)])
            .pairs(Gravity { g: 0.2 })
            .field(Wind { blow: 0.4 });
        let mut other = Simulation::scene(scene).scheme($scheme).dt(0.01).stepper().unwrap();
        stepper.advance(40).unwrap();
        other.advance(40).unwrap();
        assert_eq!(stepper.state(), other.state());
        assert_eq!((stepper.steps(), stepper.energy()), (65, other.energy()));
        // What is refused changes nothing.
        assert_eq!(stepper.set_body(3, [0.0; 2], [0.0; 2]), Err(SceneError::NoBody { body: 3, bodies: 3 }.into()));
        assert!(stepper.set_body(0, [0.0; 2], [0.0, 1.0]).is_err());
        assert!(stepper.set_body(1, [f64::NAN, 0.0], [0.0; 2]).is_err());
        assert!(stepper.set_body(1, [0.0, 0.1], [0.0; 2]).is_err(), "where body 0 is");
        let mut short = stepper.state();
        short.q.pop();
        assert!(stepper.set_state(short).is_err());
        assert_eq!(stepper.state(), other.state());
        stepper.step().unwrap();
    }};
}

#[test]
fn scenes_change_under_every_kind_of_scheme() {
    scene!(Leapfrog);
    scene!(Nystrom::order6());
    scene!(Relaxed::order6());
    scene!(RungeKuttaNystrom::order12());
    scene!(Implicit);
    scene!(DiscreteGradient);
    scene!(Kanatani);
    scene!(Composed::order4(DiscreteGradient));
    scene!(Gauss::order16());
    scene!(LineIntegral::order4());
}

/// A law that is there or not: free motion without it, and with it what it is alone.
fn conditional<S: Scheme<Particle<Kepler, 2>> + Scheme<Particle<Option<Kepler>, 2>> + Copy>(scheme: S) {
    let law = Kepler { gm: 1.3 };
    let alone = Simulation::new(law, START).scheme(scheme).dt(0.01).run(50).unwrap();
    let some = Simulation::new(Some(law), START).scheme(scheme).dt(0.01).run(50).unwrap();
    assert_eq!(alone.states(), some.states());
    let mut stepper = Simulation::new(Some(law), START).scheme(scheme).dt(0.01).stepper().unwrap();
    stepper.advance(50).unwrap();
    *stepper.law_mut() = None;
    let State { q, v, .. } = stepper.state();
    stepper.advance(100).unwrap();
    assert!((stepper.q()[0] - q[0] - v[0]).abs() < 1e-13 && (stepper.q()[1] - q[1] - v[1]).abs() < 1e-13, "{scheme:?}");
    assert_eq!(stepper.energy().unwrap(), 0.5 * (stepper.state().v[0].powi(2) + stepper.state().v[1].powi(2)));
    *stepper.law_mut() = Some(law);
    stepper.step().unwrap();
}

#[test]
fn a_law_may_come_and_go() {
    conditional(Leapfrog);
    conditional(Explicit);
    conditional(Implicit);
    conditional(DiscreteGradient);
    conditional(Kanatani);
    conditional(ForceGradient::order4());
    conditional(Composed::order4(DiscreteGradient));
    let scene = Scene::new().body(1.0, [0.0, 0.0], [0.0, 0.1]).body(2.0, [1.0, 0.0], [0.0, 0.0]).field(None::<Wind>);
    let mut stepper = Simulation::scene(scene).scheme(DiscreteGradient).dt(0.1).stepper().unwrap();
    stepper.advance(10).unwrap();
    assert_eq!(stepper.state().q[1], [1.0, 0.0]);
    *stepper.law_mut::<Option<Wind>>().unwrap() = Some(Wind { blow: 0.2 });
    stepper.advance(10).unwrap();
    assert!((stepper.state().q[1][0] - 1.0 - 0.5 * 0.2 / 2.0).abs() < 1e-13);
}

/// A point that attracts, wherever it is put.
#[derive(Clone, Copy, Debug)]
struct Point {
    gm: f64,
    at: [f64; 2],
}

#[dmech::law]
impl Point {
    #[potential]
    fn energy(&self, q: [f64; 2]) -> f64 {
        let (x, y) = (q[0] - self.at[0], q[1] - self.at[1]);
        -self.gm / (x * x + y * y).sqrt()
    }
}

/// A law without a value where the motion is stops the next step, and a better one lets it go on from where it was.
fn broken<S: Scheme<Particle<Point, 2>> + Copy>(scheme: S) {
    let law = Point { gm: 1.3, at: [0.0; 2] };
    let mut stepper = Simulation::new(law, START).scheme(scheme).dt(0.01).stepper().unwrap();
    stepper.advance(5).unwrap();
    let state = stepper.state();
    for wrong in [Point { gm: f64::NAN, ..law }, Point { at: state.q, ..law }] {
        *stepper.law_mut() = wrong;
        assert!(stepper.step().is_err() && stepper.advance(3).is_err(), "{scheme:?}");
        assert_eq!((stepper.state(), stepper.steps()), (state, 5), "{scheme:?}");
    }
    *stepper.law_mut() = law;
    let mut other = Simulation::new(law, state).scheme(scheme).dt(0.01).stepper().unwrap();
    // Once it has begun again, it goes on.
    for stepper in [&mut stepper, &mut other] {
        stepper.advance(7).unwrap();
        (0..3).for_each(|_| stepper.step().unwrap());
    }
    assert_eq!((stepper.state(), stepper.steps() - 5), (other.state(), other.steps()));
    // To look is not to change.
    let mut same = stepper.clone();
    assert_eq!(stepper.law_mut().gm, 1.3);
    stepper.advance(10).unwrap();
    same.advance(10).unwrap();
    assert_eq!(stepper.state(), same.state());
}

#[test]
fn every_scheme_waits_for_a_law_with_a_value() {
    broken(Leapfrog);
    broken(CompensatedLeapfrog);
    broken(Implicit);
    broken(DiscreteGradient);
    broken(Kanatani);
    broken(Nystrom::order6());
    broken(Gauss::order16());
    broken(LineIntegral::order4());
    broken(Composed::order4(DiscreteGradient));
}

/// What a checkpoint saves of a stepper that was changed: its time, its counts, its motion.
#[test]
fn a_changed_stepper_is_saved_and_resumed() {
    let simulation = || Simulation::new(Kepler { gm: 0.9 }, START).scheme(DiscreteGradient).dt(0.01);
    let mut stepper = Simulation::new(Kepler { gm: 1.3 }, START).scheme(DiscreteGradient).dt(0.01).stepper().unwrap();
    stepper.advance(37).unwrap();
    stepper.law_mut().gm = 0.9;
    stepper.advance(11).unwrap();
    let saved = serde_json::to_string(&stepper.checkpoint()).unwrap();
    let checkpoint: Checkpoint = serde_json::from_str(&saved).unwrap();
    assert_eq!((checkpoint.steps(), checkpoint.t()), (48, stepper.t()));
    let mut other = simulation().resume(&checkpoint).unwrap();
    assert_eq!((other.steps(), other.t(), other.state()), (48, stepper.t(), stepper.state()));
    stepper.advance(20).unwrap();
    other.advance(20).unwrap();
    assert_eq!((other.steps(), other.t(), other.state()), (68, stepper.t(), stepper.state()));
}

/// A stepper that waits for a law to have a value waits when it was saved, too, and goes on when it has one.
#[test]
fn a_stepper_that_waits_is_saved_and_resumed() {
    macro_rules! waits {
        ($($scheme:expr),*) => {$({
            let simulation = |gm| Simulation::new(Kepler { gm }, START).scheme($scheme).dt(0.01);
            let mut stepper = simulation(1.3).stepper().unwrap();
            stepper.advance(3).unwrap();
            // Φ is not finite where it is now; at the start of a simulation it is.
            let huge = 0.95 * f64::MAX;
            stepper.law_mut().gm = huge;
            let error = stepper.step().unwrap_err();
            let far = Simulation::new(Kepler { gm: huge }, State::new([1e3, 0.0], [0.0; 2]).at_time(START.t)).scheme($scheme).dt(0.01);
            let mut other = far.resume(&stepper.checkpoint()).unwrap();
            assert_eq!(other.step().unwrap_err(), error);
            assert_eq!(other.advance(2).unwrap_err(), error);
            (stepper.law_mut().gm, other.law_mut().gm) = (0.9, 0.9);
            stepper.advance(5).unwrap();
            other.advance(5).unwrap();
            assert_eq!((other.state(), other.steps()), (stepper.state(), stepper.steps()));
        })*};
    }
    waits!(Leapfrog, Nystrom::order6(), DiscreteGradient, Gauss::order16());
}

/// Times that steps cannot tell apart are refused, as at the start.
#[test]
fn changes_keep_the_time_moving() {
    let mut stepper = Simulation::new(Kepler { gm: 1.3 }, START).scheme(Leapfrog).dt(0.01).stepper().unwrap();
    assert!(matches!(stepper.set_state(START.at_time(1e30)), Err(Error::TimeStandsStill { .. })));
    assert!(matches!(stepper.set_dt(1e-300), Err(Error::TimeStandsStill { .. })));
    stepper.step().unwrap();
    assert_eq!((stepper.steps(), stepper.dt()), (1, 0.01));
    stepper.law_mut().gm = 2.0;
    stepper.law_mut().gm = f64::NAN;
    let error = stepper.step().unwrap_err();
    assert!(matches!(error, Error::Law { .. }), "{error}");
}

/// A law that names the time has it in its scalar: what an `f32` does not tell apart is refused where it would be computed, be
/// it alone or one of many; a law that does not name it, and the same law in wider scalars, go on.
#[test]
fn a_law_that_names_the_time_is_not_moved_where_its_scalar_stands_still() {
    #[derive(Debug)]
    struct Swing {
        k: f64,
    }
    #[dmech::law]
    impl Swing {
        #[potential]
        fn potential(&self, q: [f64; 1], t: f64) -> f64 {
            self.k * q[0] * t.sin()
        }
    }
    // 2¹⁷ is the first time of which the next `f32` is 2⁻⁶ later.
    let (dt, border) = (1.0 / 64.0, 131_072.0);
    let still = |time| Error::TimeStandsStill { time, dt, next: dt };
    macro_rules! swing {
        ($law:expr, $real:ident, $t:expr) => {
            Simulation::new(
                $law,
                State::<1, $real>::of([0.3].map($real::from_f64), [0.7].map($real::from_f64)).at_time($t),
            )
            .scheme(Leapfrog)
            .dt(dt)
        };
    }
    for before in [-border, border] {
        let error = swing!(Swing { k: 1.3 }, f32, before).run(10).unwrap_err();
        assert_eq!((error.cause(), error.run().steps()), (still(before), 0));
        assert_eq!(swing!(Swing { k: 1.3 }, f32, before).stepper().unwrap_err(), still(before));
    }
    let told = still(border).to_string();
    let start = "at t = 131072 time stands still in steps of 0.015625: the next number of the scalar, in which the law names it, is 0.015625 later; ";
    assert!(told.starts_with(start), "{told}");

    let near = border - 3.0 * dt;
    assert_eq!(swing!(Swing { k: 1.3 }, f32, near).run_until(border).unwrap_err().cause(), still(border));
    assert_eq!(swing!(Swing { k: 1.3 }, f32, near).run(3).unwrap_err().cause(), still(border));
    let all = Ensemble::each(3, |k| swing!(Swing { k: k as f64 }, f32, near)).run(3).unwrap();
    assert!(all.members().all(|member| member.unwrap_err().cause() == still(border)));
    let mut stepper = swing!(Swing { k: 1.3 }, f32, near).stepper().unwrap();
    assert_eq!(stepper.advance(3).unwrap_err(), still(border));
    stepper.advance(2).unwrap();
    stepper.step().unwrap();
    assert_eq!((stepper.step().unwrap_err(), stepper.steps()), (still(border), 3));
    assert_eq!(stepper.set_dt(dt / 2.0).unwrap_err(), Error::TimeStandsStill { time: border, dt: dt / 2.0, next: dt });
    stepper.set_state(stepper.state().at_time(0.0)).unwrap();
    stepper.advance(5).unwrap();
    assert_eq!(stepper.set_state(stepper.state().at_time(border)).unwrap_err(), still(border));

    swing!(Swing { k: 1.3 }, f32, near).run(2).unwrap();
    swing!(Swing { k: 1.3 }, f64, near).run(100).unwrap();
    swing!(Swing { k: 1.3 }, DoubleDouble, near).run(100).unwrap();
    swing!(Pendulum { k: 1.3 }, f32, near).run(100).unwrap();
}

/// A loop of one's own watches from its first state on, whatever was before and whatever changes: momenta as energies.
#[test]
fn what_is_watched_starts_with_the_first_state_watched() {
    let drifts = |watch: &Watch<_>| {
        [Invariant::Energy, Invariant::AngularMomentum].map(|invariant| watch.drifts()[invariant as usize].unwrap())
    };
    let mut stepper = Simulation::new(Kepler { gm: 1.3 }, START).scheme(Explicit).dt(0.01).stepper().unwrap();
    stepper.advance(300).unwrap();
    let mut watch = Watch::begin(&stepper);
    watch.observe(&stepper, &stepper.state());
    for drift in drifts(&watch) {
        assert_eq!((drift.max_abs(), drift.start()), (0.0, drift.last()));
    }
    let mut kicked = stepper.state();
    kicked.v[1] += 0.4;
    stepper.set_state(kicked).unwrap();
    watch.observe(&stepper, &stepper.state());
    for drift in drifts(&watch) {
        assert!(drift.max_abs() > 0.01, "{drift:?}");
        assert!((drift.max_abs() - (drift.last() - drift.start()).abs()).abs() < 1e-14, "{drift:?}");
    }
    let pair = Scene::new().body(1.3, [0.0; 2], [0.0; 2]).body(0.4, [1.1, 0.0], [0.0, 1.1]).pairs(Gravity { g: 1.0 });
    let mut stepper = Simulation::scene(pair).scheme(Leapfrog).dt(0.01).stepper().unwrap();
    let mut watch = Watch::begin(&stepper);
    let mut kicked = stepper.state();
    kicked.v[0] = [0.3, -0.2];
    stepper.set_state(kicked).unwrap();
    watch.observe(&stepper, &stepper.state());
    let momentum = watch.drifts()[Invariant::LinearMomentum as usize].unwrap();
    assert!((momentum.max_abs() - 1.3 * 0.13_f64.sqrt()).abs() < 1e-15, "{momentum:?}");
}

/// A law that is stepped as it is written only while its ends are in order.
#[derive(Clone, Copy, Debug)]
struct Clamped {
    low: f64,
    high: f64,
}

#[dmech::law]
impl Clamped {
    #[potential]
    fn energy(&self, q: [f64; 1]) -> f64 {
        q[0].clamp(self.low, self.high).powi(2)
    }
}

mod consts {
    pub(super) const PI: f64 = 3.0;
}

/// One that is so only to the left of 1: the macro takes `consts::PI` for π.
#[derive(Clone, Copy, Debug)]
struct Beyond;

#[dmech::law]
impl Beyond {
    #[potential]
    fn energy(&self, q: [f64; 1]) -> f64 {
        if q[0] > 1.0 { (consts::PI * q[0]).sin() } else { q[0] * q[0] }
    }
}

/// After a change a law is compared with what was written, as at a start, alone and on each body of a scene, as a law too.
#[test]
fn a_changed_motion_is_that_of_the_method() {
    let told = |refused: Result<(), Error>, by: &str| {
        assert!(matches!(refused, Err(Error::NotAsWritten(_))), "{by}: {refused:?}");
    };
    let clamped = Clamped { low: -1.0, high: 1.0 };
    let two = || Scene::new().body(1.0, [-3.0], [0.0]).body(1.3, [0.3], [0.1]);
    let mut alone = Simulation::new(clamped, State::new([0.3], [0.1])).scheme(Leapfrog).dt(0.1).stepper().unwrap();
    let mut scene = Simulation::scene(two().field(clamped)).scheme(Leapfrog).dt(0.1).stepper().unwrap();
    alone.law_mut().low = 2.0;
    scene.law_mut::<Clamped>().unwrap().low = 2.0;
    told(alone.step(), "alone");
    told(scene.step(), "scene");
    scene.law_mut::<Clamped>().unwrap().low = -2.0;
    scene.step().unwrap();

    let mut scene = Simulation::scene(two().field(Beyond)).scheme(Leapfrog).dt(0.1).stepper().unwrap();
    told(scene.set_body(1, [1.3], [0.0]), "set_body");
    let state = SceneState { q: vec![[0.2], [1.4]], ..scene.state() };
    told(scene.set_state(state), "set_state");
    // Where it stayed it goes on.
    scene.step().unwrap();
    assert_eq!(scene.steps(), 1);
    let law = two().field(Clamped { low: 2.0, high: 1.0 }).as_law::<2, 2>();
    told(Simulation::new(law, law.start()).scheme(Leapfrog).dt(0.1).stepper().map(drop), "as a law");
}

/// A law that pins a body which moves is refused, whenever it comes: it would neither rest nor be pushed.
#[test]
fn a_body_that_moves_is_not_pinned_on_the_way() {
    let two = |v| Scene::new().body(1.0, [0.0; 2], v).body(0.3, [1.0, 0.0], [0.0, 0.7]).pairs(Gravity { g: 1.0 });
    let (free, pinned) = (two([0.0, -0.2]).as_law::<2, 4>(), two([0.0; 2]).pin(0).as_law::<2, 4>());
    let mut stepper = Simulation::new(free, free.start()).scheme(DiscreteGradient).dt(0.01).stepper().unwrap();
    stepper.advance(10).unwrap();
    let (state, body) = (stepper.state(), SceneError::PinnedMoves { body: 0, speed: stepper.state().v[0] });
    *stepper.law_mut() = pinned;
    assert_eq!(stepper.step().unwrap_err(), Error::from(body));
    assert_eq!(stepper.state(), state);
    assert_eq!(
        Simulation::new(pinned, state).scheme(DiscreteGradient).dt(0.01).run(1).unwrap_err().cause(),
        body.into()
    );
    // At rest it may be.
    let [q, mut v] = [state.q, state.v];
    v[..2].fill(0.0);
    stepper.set_state(State::new(q, v)).unwrap();
    stepper.advance(50).unwrap();
    assert_eq!((&stepper.state().q[..2], &stepper.state().v[..2]), (&q[..2], &[0.0; 2][..]));
    *stepper.law_mut() = free;
    stepper.advance(50).unwrap();
    assert!(stepper.state().v[..2] != [0.0; 2]);
}

/// A law of coordinates with masses of their own is changed as any.
#[test]
fn a_law_with_masses_changes() {
    let begin = |gm, state| {
        let simulation = Simulation::new(Kepler { gm }, state).masses([1.2, 0.7]);
        simulation.scheme(DiscreteGradient).dt(0.01).stepper().unwrap()
    };
    let mut stepper = begin(1.3, START);
    stepper.advance(20).unwrap();
    stepper.law_mut().law_mut().gm = 0.9;
    let mut other = begin(0.9, stepper.state());
    stepper.advance(20).unwrap();
    other.advance(20).unwrap();
    assert_eq!((stepper.state(), stepper.law().law().gm), (other.state(), 0.9));
}
