//! A run that is saved after any number of steps and resumed is the run that never stopped, to the bit: every scheme, with
//! equal steps and with steps that follow the motion.

use std::cell::Cell;

use dmech::coefficients::{Chin4A, Chin4C, McLachlan4S4, TripleJump4};
use dmech::extend::{Adaptable, Carried};
use dmech::models::pairs::FermiPastaUlamTsingou;
use dmech::models::{DampedPendulum, Kepler, Pendulum};
use dmech::prelude::*;
use dmech::scene::{SceneSystem, Term};

/// Saved after 0, 1, …, and followed to the end.
const SAVED: usize = 40;
const STEPS: usize = 60;

/// Saves after each of the first steps, through JSON, and compares what follows with the whole run.
fn goes_on<T, B: PartialEq + std::fmt::Debug>(
    what: &str,
    start: impl Fn() -> T,
    resume: impl Fn(&Checkpoint) -> T,
    step: impl Fn(&mut T),
    save: impl Fn(&T) -> Checkpoint,
    state: impl Fn(&T) -> B,
) {
    let mut whole = start();
    let mut states = vec![state(&whole)];
    for _ in 0..STEPS {
        step(&mut whole);
        states.push(state(&whole));
    }
    let mut first = start();
    for saved in 0..SAVED {
        let text = serde_json::to_string(&save(&first)).unwrap();
        let mut second = resume(&serde_json::from_str(&text).unwrap());
        for (k, expected) in states.iter().enumerate().skip(saved) {
            assert_eq!(&state(&second), expected, "{what}, saved after {saved} steps, after {k} steps");
            if k < STEPS {
                step(&mut second);
            }
        }
        assert_eq!(save(&second), save(&whole), "{what}, saved after {saved} steps");
        step(&mut first);
    }
}

fn law<L: Law<D> + Clone, S: Scheme<Particle<L, D>>, const D: usize>(simulation: Simulation<L, State<D>, S>)
where
    S::Memory: Carried,
{
    goes_on(
        S::NAME,
        || simulation.clone().stepper().unwrap(),
        |saved| simulation.clone().resume(saved).unwrap(),
        |stepper| stepper.step().unwrap(),
        |stepper| stepper.checkpoint(),
        |stepper| {
            let state = stepper.state();
            (state.t.to_bits(), state.q.map(f64::to_bits), state.v.map(f64::to_bits), stepper.evaluations())
        },
    );
}

#[test]
fn equal_steps() {
    let checked = Cell::new(0);
    let pendulum = Simulation::new(Pendulum { k: 1.7 }, State::new([1.1], [0.3]).at_time(0.7)).mass(1.3).dt(0.2);
    macro_rules! each {
        ($($scheme:expr),* $(,)?) => {$(
            law(pendulum.clone().scheme($scheme));
            checked.set(checked.get() + 1);
        )*};
    }
    each!(Boris, Composed::order4(Boris));
    each!(Explicit, Leapfrog, CompensatedLeapfrog, Implicit, DiscreteGradient, Kanatani);
    each!(Implicit.with(Newton::from_previous()), Kanatani.start(Start::BackwardStep));
    each!(Composed::order4(Leapfrog), Composed::order4(Implicit), Composed::order4(DiscreteGradient));
    each!(Composed::order6(Leapfrog), Composed::order6(Implicit), Composed::order6(DiscreteGradient));
    each!(Composed::order8(Leapfrog), Composed::order8(Implicit), Composed::order8(DiscreteGradient));
    each!(Nystrom::order4(), Nystrom::order6(), Nystrom::order8(), Nystrom::new(McLachlan4S4));
    each!(Relaxed::order6(), Relaxed::order8(), RungeKuttaNystrom::order12());
    each!(ForceGradient::order4(), ForceGradient::order6(), ForceGradient::order8());
    each!(Gauss::order16(), LineIntegral::order4(), LineIntegral::order10());
    each!(ForceGradient::new(Chin4A), ForceGradient::new(Chin4C));
    let damped = Simulation::new(DampedPendulum { k: 1.7, alpha: 0.2 }, State::new([1.1], [0.3])).mass(1.3).dt(0.2);
    law(damped.clone().scheme(Implicit));
    law(damped.clone().scheme(DiscreteGradient));
    law(damped.clone().scheme(Boris));
    law(damped.clone().scheme(Gauss::order16()));
    law(damped.scheme(Composed::order4(DiscreteGradient)));
    assert_eq!(checked.get(), 34);
}

/// The tolerances are such that rows of equal steps are of one step, of a few, and longer than the run.
#[test]
fn steps_that_follow_the_motion() {
    let rows = Cell::new([0; 2]);
    fn adaptive<S>(scheme: S, tolerance: f64, rows: &Cell<[usize; 2]>)
    where
        S: Adaptable + Scheme<Particle<Pendulum, 1>>,
        dmech::extend::Adaptive<S>: Scheme<Particle<Pendulum, 1>>,
        <dmech::extend::Adaptive<S> as Scheme<Particle<Pendulum, 1>>>::Memory: Carried,
    {
        let simulation = Simulation::new(Pendulum { k: 1.7 }, State::new([2.1], [0.3])).mass(1.3);
        let simulation = simulation.scheme(scheme).adaptive(tolerance);
        let mut stepper = simulation.clone().stepper().unwrap();
        let mut lengths = vec![];
        for _ in 0..STEPS {
            let before = stepper.t();
            stepper.step().unwrap();
            lengths.push(stepper.t() - before);
        }
        let equal = lengths.windows(2).filter(|pair| (pair[0] - pair[1]).abs() < 1e-12 * pair[0]).count();
        let [some, other] = rows.get();
        rows.set([some + usize::from(equal > 0), other + usize::from(equal < STEPS - 1)]);
        law(simulation);
    }
    macro_rules! each {
        ($($scheme:expr => $($tolerance:literal)*),* $(,)?) => {$($( adaptive($scheme, $tolerance, &rows); )*)*};
    }
    each! {
        DiscreteGradient => 1e-1 1e-3 1e-5, Implicit => 1e-1 1e-3 1e-5, Boris => 1e-1 1e-3 1e-5,
        Composed::order4(DiscreteGradient) => 1e-2 1e-4 1e-6 1e-8, Composed::order4(Implicit) => 1e-2 1e-4 1e-6 1e-8,
        Composed::order6(DiscreteGradient) => 1e-4 1e-7 1e-10, Composed::order6(Implicit) => 1e-4 1e-7 1e-10,
        Composed::order8(DiscreteGradient) => 1e-4 1e-12, Composed::order4(Leapfrog) => 1e-4 1e-7,
        Composed::new(DiscreteGradient, TripleJump4) => 1e-4 1e-7,
        Nystrom::order4() => 1e-4 1e-7, Nystrom::order6() => 1e-4 1e-10, Nystrom::order8() => 1e-4 1e-12,
        ForceGradient::order4() => 1e-4 1e-7, ForceGradient::order6() => 1e-4 1e-10,
        ForceGradient::order8() => 1e-4 1e-12, RungeKuttaNystrom::order12() => 1e-4 1e-12,
        Gauss::order16() => 1e-3 1e-12 1e-30, LineIntegral::order6() => 1e-4 1e-9,
    }
    let [in_rows, changing] = rows.get();
    assert!(in_rows >= 10 && changing >= 25, "{in_rows} with equal steps, {changing} with others");
    // The planet of the first run that was lost so.
    let orbit = Simulation::new(Kepler { gm: 1.7 }, State::new([0.7, -0.4], [0.3, 0.8])).mass(1.3);
    law(orbit.clone().scheme(Composed::order4(DiscreteGradient)).adaptive(1e-6));
    law(orbit.scheme(Composed::order6(Implicit)).adaptive(1e-8));
}

const SPRING: FermiPastaUlamTsingou = FermiPastaUlamTsingou { k: 1.0, alpha: 0.25, beta: 0.0 };

/// An oscillating well, and friction.
#[derive(Clone, Copy, Debug)]
struct Well {
    k: f64,
}

#[dmech::law]
impl Well {
    #[potential]
    fn energy(&self, q: f64, t: f64) -> f64 {
        self.k * (1.5 + t.sin()) * q.powi(4)
    }
}

fn scene<L, S>(scene: &Scene<1, (), L>, scheme: S, what: &str)
where
    L: Term<1, ()> + Clone,
    S: Scheme<SceneSystem<1, L::Ready>>,
    S::Memory: Carried,
{
    let simulation = || Simulation::scene(scene.clone()).scheme(scheme).dt(0.1);
    goes_on(
        &format!("{}, {what}", S::NAME),
        || simulation().stepper().unwrap(),
        |saved| simulation().resume(saved).unwrap(),
        |stepper| stepper.step().unwrap(),
        |stepper| stepper.checkpoint(),
        |stepper| {
            let state = stepper.state();
            let numbers = state.q.into_iter().chain(state.v).flatten().chain([state.t]);
            (numbers.map(f64::to_bits).collect::<Vec<_>>(), stepper.evaluations(), stepper.iterations())
        },
    );
}

#[test]
fn scenes() {
    let bodies = (0..6).fold(Scene::new().at_time(0.4), |scene, i| {
        let f = f64::from(i);
        scene.body(1.0 + 0.1 * f, [0.7 * (0.9 * f).sin()], [if i == 2 { 0.0 } else { 0.1 * (2.0 * f).cos() }])
    });
    let chain = bodies.clone().chain(SPRING).field(Well { k: 0.1 }).pin(2);
    macro_rules! each {
        ($what:ident: $($scheme:expr),* $(,)?) => {$( scene(&$what, $scheme, stringify!($what)); )*};
    }
    each!(chain: Explicit, Leapfrog, Implicit, DiscreteGradient, Kanatani, Kanatani.start(Start::BackwardStep));
    each!(chain: Composed::order4(Leapfrog), Composed::order4(DiscreteGradient), Composed::order6(DiscreteGradient));
    each!(chain: Composed::order8(Leapfrog), Nystrom::order4(), Nystrom::order6(), Nystrom::order8());
    each!(chain: Gauss::order16(), LineIntegral::order6(), RungeKuttaNystrom::order12());
    let bonds = bodies.bonds(SPRING, [(0, 3), (3, 5), (4, 1), (1, 2)]);
    each!(bonds: Implicit, DiscreteGradient.with(Newton::from_previous()), Composed::order4(DiscreteGradient));
}
