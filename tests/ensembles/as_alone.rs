//! The same bits as alone: schemes × laws.

use dmech::extend::{Masses, Rides};
use dmech::prelude::*;
use dmech::scheme::Adaptive;

use crate::laws::{
    Beads, Bottle, Clones, Clusters, Contact, Cords, Creatures, Damped, Driven, Each, Fluid, Herds, Hung, Ions, Loops,
    Many, Molecules, Orbit, Packs, Pair, Plummer, Rope, Saddle, Stars, Tethers, Tides, Tied, Traps, Vapours,
};

/// No multiple of any power of two.
const MEMBERS: usize = 83;

/// Of scenes, that take long in a build without optimisations.
const FEWER: usize = 29;

fn mass(k: usize) -> f64 {
    1.1 + 0.01 * (k % 7) as f64
}

/// Members of which each has its own law, mass, start and time of the start, and so its own number of steps.
pub(crate) fn as_alone<L, S, const D: usize>(scheme: S, name: &str, prepare: impl Fn(Settings) -> Settings)
where
    L: Each<D>,
    S: Rides<L::Law, D> + Sync,
{
    let Settings { dt, every, end, members } =
        prepare(Settings { dt: Some(0.05), every: 3, end: 2.0, members: MEMBERS });
    let ensemble = Ensemble::of(members).law(L::law).start(L::begin).mass(mass).scheme(scheme).look_every(every);
    let ensemble = match dt {
        Some(dt) => ensemble.dt(dt),
        None => ensemble,
    };
    let run = ensemble.clone().run_until(end).unwrap();
    let few = ensemble.lanes(7).threads(1).watch_work().run_until(end).unwrap();
    are_alone(name, members, [&run, &few], &|k| {
        let alone = Simulation::new(L::law(k), L::begin(k)).mass(mass(k)).scheme(scheme).record_every(every);
        let alone = match dt {
            Some(dt) => alone.dt(dt),
            None => alone,
        };
        alone.run_until(end).unwrap()
    });
}

/// Members without the work of their steps, and with it, are what each is alone.
fn are_alone<const D: usize>(
    name: &str,
    members: usize,
    [run, few]: [&EnsembleRun<State<D>>; 2],
    alone: &dyn Fn(usize) -> Run<State<D>>,
) {
    assert_eq!(run.checksum(), few.checksum(), "{name}");
    let mut steps = 0;
    for k in 0..members {
        let alone = alone(k);
        steps += alone.steps();
        for (run, works) in [(run, false), (few, true)] {
            let member = run.member(k).unwrap();
            assert_eq!((member.steps(), member.last()), (alone.steps(), alone.last()), "{name}, member {k}");
            assert_eq!(member.report().dt_range(), alone.report().dt_range(), "{name}, member {k}");
            assert_eq!(member.report().rough(), alone.report().rough(), "{name}, member {k}");
            let effort = |run: &Run<State<D>>| [run.report().evaluations(), run.report().iterations()];
            assert_eq!(effort(member), effort(&alone), "{name}, member {k}");
            for invariant in Invariant::ALL {
                let drift = alone.drift(invariant).filter(|_| works || invariant != Invariant::WorkEnergy);
                assert_eq!(run.drift(k, invariant), drift, "{name}, member {k}: {invariant}");
            }
            assert_eq!(run.drift_of(k, "twice"), alone.drift_of("twice"), "{name}, member {k}");
        }
    }
    assert!(steps > 10 * members as u64, "{name}: {steps} steps in all");
}

#[derive(Clone, Copy)]
pub(crate) struct Settings {
    pub(crate) dt: Option<f64>,
    pub(crate) every: u64,
    pub(crate) end: f64,
    /// More than twice as many as ride side by side.
    pub(crate) members: usize,
}

macro_rules! table {
    (until $end:literal: $($test:ident: $scheme:expr, [$($law:ty),*];)*) => {$(
        #[test]
        fn $test() {
            let settings = |settings| Settings { end: $end, ..settings };
            $(as_alone::<$law, _, _>($scheme, stringify!($test $law), settings);)*
        }
    )*};
}

table! { until 2.0:
    leapfrog: Leapfrog, [Orbit, Saddle, Contact, Driven, Plummer];
    compensated_leapfrog: CompensatedLeapfrog, [Saddle];
    composed_leapfrog: Composed::order4(Leapfrog), [Orbit, Driven];
    nystrom: Nystrom::order6(), [Orbit, Plummer, Contact];
    force_gradient: ForceGradient::order4(), [Saddle];
    explicit: Explicit, [Orbit, Damped, Bottle];
    boris: Boris, [Bottle];
    composed_boris: Composed::order4(Boris), [Bottle];
    implicit: Implicit, [Orbit, Saddle, Contact, Driven, Damped, Bottle];
    discrete_gradient: DiscreteGradient, [Orbit, Saddle, Contact, Driven, Damped, Bottle, Plummer];
    kanatani: Kanatani, [Orbit, Saddle, Contact];
    composed_implicit: Composed::order4(Implicit), [Saddle, Damped];
    composed_discrete_gradient: Composed::order6(DiscreteGradient), [Orbit, Saddle, Bottle];
    gauss: Gauss::order16(), [Orbit, Saddle, Contact, Damped, Bottle];
    line_integral: LineIntegral::order6(), [Orbit, Driven];
    runge_kutta_nystrom: RungeKuttaNystrom::order12(), [Orbit, Saddle, Contact, Driven, Plummer];
    relaxed: Relaxed::order6(), [Orbit];
}

table! { until 1.0:
    leapfrog_of_few: Leapfrog, [Stars, Molecules, Clusters, Fluid, Loops, Tied];
    nystrom_of_few: Nystrom::order6(), [Stars, Molecules, Fluid];
    force_gradient_of_few: ForceGradient::order4(), [Stars, Molecules];
    runge_kutta_nystrom_of_few: RungeKuttaNystrom::order12(), [Stars, Clusters];
    explicit_of_few: Explicit, [Creatures, Rope, Packs, Hung];
    boris_of_few: Boris, [Ions, Rope, Beads];
    implicit_of_few: Implicit, [Stars, Rope, Creatures, Ions, Molecules, Packs, Loops, Tied];
    discrete_gradient_of_few: Composed::order4(DiscreteGradient), [Stars, Rope, Creatures, Ions, Clusters];
    discrete_gradient_of_molecules: DiscreteGradient, [Molecules, Beads, Packs, Tied, Hung];
    discrete_gradient_in_boxes: DiscreteGradient, [Fluid, Loops];
    gauss_of_few: Gauss::order16(), [Stars, Rope, Creatures, Ions, Molecules, Tied];
}

// Others of the bodies are test bodies in each member, all and none too.
table! { until 1.0:
    leapfrog_restricted: Leapfrog, [Clones, Tethers, Vapours];
    nystrom_restricted: Nystrom::order6(), [Clones];
    force_gradient_restricted: ForceGradient::order4(), [Clones];
    relaxed_restricted: Relaxed::order6(), [Clones];
    explicit_restricted: Explicit, [Herds];
    boris_restricted: Boris, [Traps, Cords];
    implicit_restricted: Implicit, [Herds, Tethers];
    discrete_gradient_restricted: DiscreteGradient, [Clones, Cords, Traps, Vapours];
    gauss_restricted: Gauss::order16(), [Clones, Herds];
}

/// A look after every step, and none but at the end.
#[test]
fn looks_that_are_many_or_few() {
    for every in [1, 7, 1000] {
        as_alone::<Orbit, _, 2>(Leapfrog, "look", |settings| Settings { every, ..settings });
        as_alone::<Saddle, _, 2>(DiscreteGradient, "look", |settings| Settings { every, ..settings });
    }
}

/// Steps that follow each motion, with a longest and without.
fn follow<L: Each<D>, S: Rides<L::Law, D> + Sync, const D: usize>(scheme: S, name: &str) {
    follow_some::<L, S, D>(scheme, name, MEMBERS);
}

fn follow_some<L: Each<D>, S: Rides<L::Law, D> + Sync, const D: usize>(scheme: S, name: &str, members: usize) {
    as_alone::<L, S, D>(scheme, name, |settings| Settings { dt: None, end: 13.0, members, ..settings });
    as_alone::<L, S, D>(scheme, name, |settings| Settings { dt: Some(0.07), end: 1.5, members, ..settings });
}

/// In rows of equal steps, and each another.
#[test]
fn adaptive() {
    for tolerance in [1e-5, 1e-9] {
        follow::<Orbit, _, 2>(Adaptive::new(Composed::order6(DiscreteGradient), tolerance), "composed");
        follow::<Saddle, _, 2>(Adaptive::new(Nystrom::order6(), tolerance), "Nystrom");
        follow::<Saddle, _, 2>(Adaptive::new(Composed::order4(Leapfrog), 1e3 * tolerance), "leap-frog");
    }
    follow::<Plummer, _, 3>(Adaptive::new(DiscreteGradient, 1e-3), "exact");
    follow::<Saddle, _, 2>(Adaptive::new(ForceGradient::order4(), 1e-5), "force-gradient");
    follow::<Orbit, _, 2>(Adaptive::new(RungeKuttaNystrom::order12(), 1e-9), "order 12");
    follow::<Bottle, _, 2>(Adaptive::new(Composed::order4(Boris), 1e-4), "Boris");
    follow::<Bottle, _, 2>(Adaptive::new(DiscreteGradient, 1e-2), "workless");
    follow::<Orbit, _, 2>(Adaptive::new(Implicit, 1e-4), "implicit");
    follow::<Orbit, _, 2>(Adaptive::new(Gauss::order16(), 1e-10), "Gauss");
    // Steps that are shortened, each member's by itself.
    follow::<Plummer, _, 3>(Adaptive::new(Gauss::order16(), 1e-7), "Gauss, shortened");
    follow::<Damped, _, 1>(Adaptive::new(LineIntegral::order10(), 1e-7), "line integral");
    let driven = |settings| Settings { dt: Some(0.1), end: 3.0, ..settings };
    as_alone::<Driven, _, 1>(Adaptive::new(Nystrom::order6(), 1e-6), "driven", driven);
}

#[test]
fn adaptive_of_few() {
    follow_some::<Stars, _, 6>(Adaptive::new(Nystrom::order6(), 1e-7), "stars", FEWER);
    follow_some::<Creatures, _, 6>(Adaptive::new(Gauss::order16(), 1e-9), "creatures", FEWER);
    follow_some::<Ions, _, 6>(Adaptive::new(Boris, 1e-2), "ions", FEWER);
    let driven = |settings| Settings { dt: Some(0.1), end: 3.0, members: FEWER, ..settings };
    as_alone::<Rope, _, 4>(Adaptive::new(Composed::order4(DiscreteGradient), 1e-4), "rope", driven);
    as_alone::<Molecules, _, 8>(Adaptive::new(Nystrom::order6(), 1e-7), "molecules", driven);
    as_alone::<Tied, _, 8>(Adaptive::new(Nystrom::order6(), 1e-7), "tied", driven);
    as_alone::<Loops, _, 6>(Adaptive::new(Nystrom::order6(), 1e-6), "loops", driven);
    as_alone::<Clones, _, 8>(Adaptive::new(Nystrom::order6(), 1e-6), "clones", driven);
}

/// Matrices of many coordinates.
#[test]
fn adaptive_by_matrices() {
    let short = |settings| Settings { dt: Some(0.1), end: 0.5, members: FEWER, ..settings };
    as_alone::<Packs, _, 6>(Adaptive::new(DiscreteGradient, 1e-3), "packs", short);
    as_alone::<Tides, _, 6>(Adaptive::new(Implicit, 1e-3), "tides", short);
    let longer = |settings| Settings { end: 1.1, ..short(settings) };
    as_alone::<Hung, _, 8>(Adaptive::new(Gauss::order16(), 1e-8), "hung", longer);
    as_alone::<Herds, _, 6>(Adaptive::new(Gauss::order16(), 1e-8), "herds", longer);
}

/// Each coordinate of each member with a mass of its own: two bodies on a plane that pull on each other.
#[test]
fn masses_of_coordinates() {
    fn check<S: Rides<Masses<Pair, 4>, 4> + Sync>(scheme: S, dt: f64, name: &str) {
        let masses = |k: usize| {
            let [a, b] = [1.3 + 0.01 * k as f64, 0.4 + 0.03 * (k % 11) as f64];
            [a, a, b, b]
        };
        let pairs = Ensemble::of(MEMBERS).law(Pair::member).masses(masses).mass(mass).start(Pair::start).scheme(scheme);
        let run = pairs.dt(dt).look_every(3).run_until(2.0).unwrap();
        for k in 0..MEMBERS {
            let alone = Simulation::new(Pair::member(k), Pair::start(k)).masses(masses(k)).mass(mass(k));
            let alone = alone.scheme(scheme).dt(dt).record_every(3).run_until(2.0).unwrap();
            assert_eq!(run.last(k).unwrap(), *alone.last(), "{name}, member {k}");
            for invariant in [Invariant::Energy, Invariant::DiscreteEnergy, Invariant::AngularMomentum] {
                assert_eq!(run.drift(k, invariant), alone.drift(invariant), "{name}, member {k}: {invariant}");
            }
            assert!(run.drift(k, Invariant::Energy).is_some());
        }
    }
    check(Leapfrog, 0.01, "leap-frog");
    check(Nystrom::order6(), 0.05, "Nystrom");
    check(DiscreteGradient, 0.05, "exact");
    check(Composed::order4(Implicit), 0.05, "implicit");
    check(Gauss::order16(), 0.1, "Gauss");
    check(Adaptive::new(ForceGradient::order4(), 1e-5), 1.0, "adaptive");

    // Where one turns and its neighbour, with two masses, does not, each goes its own way.
    fn bottles<S: Rides<Masses<Bottle, 2>, 2> + Sync>(scheme: S) {
        let masses = |k: usize| [1.0, if k.is_multiple_of(3) { 1.0 } else { 1.0 + 0.1 * k as f64 }];
        let run = Ensemble::of(MEMBERS).law(Bottle::member).masses(masses).start(Bottle::start).scheme(scheme);
        let run = run.dt(0.05).run(100).unwrap();
        for k in 0..MEMBERS {
            let alone = Simulation::new(Bottle::member(k), Bottle::start(k)).masses(masses(k)).scheme(scheme).dt(0.05);
            assert_eq!(run.last(k).unwrap(), *alone.run(100).unwrap().last(), "{k}");
        }
    }
    bottles(Boris);
    bottles(Composed::order4(Boris));
    bottles(Adaptive::new(Boris, 1e-4));

    let refused = |k: usize| if k == 5 { [1.0, -1.0, 1.0, 1.0] } else { [1.0; 4] };
    let run = Ensemble::of(9).law(Pair::member).masses(refused).start(Pair::start).scheme(Leapfrog).dt(0.01).run(10);
    let failures: Vec<_> = run.unwrap().failures().collect();
    assert_eq!(failures, [(5, Error::Mass { mass: -1.0 })]);
}
