//! Members of which some have a law and others none: free motion beside all else, to the bit what each is alone.

use core::marker::PhantomData;

use dmech::extend::{Adaptable, Masses, Rides, StoreError};
use dmech::models::pairs::{LennardJones, Spring};
use dmech::prelude::*;
use dmech::scene::{OnChain, OnEach, OnNear, Periodic};
use dmech::scheme::Adaptive;

use crate::as_alone::{Settings, as_alone};
use crate::laws::{
    Bottle, Clones, Contact, Damped, Driven, Each, Many, Molecules, Orbit, Pair, Plummer, Saddle, Stars,
};
use crate::same::the_same;
use crate::store::Place;

/// Members of a kind, two of three with their law; the first has none.
struct Some2Of3<L>(PhantomData<L>);

impl<L: Each<D>, const D: usize> Each<D> for Some2Of3<L> {
    type Law = Option<L::Law>;

    fn law(k: usize) -> Option<L::Law> {
        (!k.is_multiple_of(3)).then(|| L::law(k))
    }
    fn begin(k: usize) -> State<D> {
        L::begin(k)
    }
}

macro_rules! table {
    ($($test:ident: $scheme:expr, [$($law:ty),*];)*) => {$(
        #[test]
        fn $test() {
            $(as_alone::<Some2Of3<$law>, _, _>($scheme, stringify!($test $law), |settings| settings);)*
        }
    )*};
}

table! {
    leapfrog: Leapfrog, [Orbit];
    force_gradient: ForceGradient::order4(), [Saddle];
    explicit: Explicit, [Damped];
    boris: Composed::order4(Boris), [Bottle];
    implicit: Implicit, [Orbit, Driven, Damped];
    discrete_gradient: DiscreteGradient, [Saddle, Contact, Bottle];
    kanatani: Kanatani, [Saddle];
    composed: Composed::order4(DiscreteGradient), [Plummer];
    gauss: Gauss::order16(), [Contact];
    runge_kutta_nystrom: RungeKuttaNystrom::order12(), [Saddle];
    scenes: Nystrom::order6(), [Molecules];
    scenes_exactly: DiscreteGradient, [Stars];
    restricted_scenes: DiscreteGradient, [Clones];
}

/// Steps that follow the motion; of those that are free, the longest.
#[test]
fn adaptive() {
    fn follow<L: Each<D>, S: Adaptable, const D: usize>(scheme: S, tolerance: f64, name: &str)
    where
        Adaptive<S>: Rides<Option<L::Law>, D> + Sync,
    {
        let settings = |settings| Settings { dt: Some(0.07), end: 3.0, ..settings };
        as_alone::<Some2Of3<L>, _, D>(Adaptive::new(scheme, tolerance), name, settings);
    }
    follow::<Saddle, _, 2>(Nystrom::order6(), 1e-6, "Nystrom");
    follow::<Orbit, _, 2>(Composed::order4(DiscreteGradient), 1e-5, "exact");
    follow::<Bottle, _, 2>(Boris, 1e-3, "Boris");
    follow::<Stars, _, 6>(Nystrom::order6(), 1e-6, "stars");
    // Without a longest they have no time scale, and the others are what they are.
    let law = |k: usize| (k % 5 != 2).then(|| Orbit::member(k));
    let run = Ensemble::of(40).law(law).start(Orbit::start).scheme(Nystrom::order6()).adaptive(1e-6);
    let run = run.watch_work().run_until(2.0).unwrap();
    for k in 0..40 {
        let alone = Simulation::new(law(k), Orbit::start(k)).scheme(Nystrom::order6()).adaptive(1e-6).run_until(2.0);
        assert_eq!(ended(run.member(k)), ended(alone.as_ref()), "{k}");
    }
    assert_eq!(run.failures().count(), 8);
}

/// How a run has ended, as text, where NaN is NaN.
fn ended<const D: usize>(run: Result<&Run<State<D>>, &Interrupted<State<D>>>) -> String {
    let cause = run.err().map(Interrupted::cause);
    let run = run.unwrap_or_else(Interrupted::run);
    let drifts: Vec<_> = Invariant::ALL.into_iter().map(|invariant| run.drift(invariant)).collect();
    let report = run.report();
    format!("{cause:?} {:?} {} {drifts:?} {} {}", run.last(), run.steps(), report.evaluations(), report.iterations())
}

/// Nobody has a law, all have, one has, one has not; free ones lie in the centre of the law of others, rest, fly off to infinity and
/// begin nowhere.
#[test]
fn free_members_of_every_kind() {
    const MEMBERS: usize = 43;
    let start = |k: usize| match k {
        4 => State::new([0.0, 0.0], [0.0, 0.0]),
        12 => State::new([-0.0, 0.0], [1.0, -0.0]),
        20 => State::new([0.3, 0.1], [f64::MAX, 0.0]),
        28 => State::new([f64::NAN, 0.0], [0.0, 0.0]),
        36 => State::new([1e150, 0.0], [0.0, 1e150]),
        _ => Saddle::start(k),
    };
    let patterns: [fn(usize) -> bool; 6] =
        [|_| false, |_| true, |k| k == 0, |k| k != 0, |k| !k.is_multiple_of(4), |k| k == 42 || k == 9];
    fn check<S: Rides<Option<Saddle>, 2> + Rides<Option<Orbit>, 2> + Sync>(
        scheme: S,
        start: impl Fn(usize) -> State<2> + Sync,
        there: fn(usize) -> bool,
    ) {
        macro_rules! of {
            ($law:ident) => {
                let law = |k: usize| there(k).then(|| $law::member(k));
                for lanes in [3, usize::MAX] {
                    let ensemble = Ensemble::of(MEMBERS).law(law).start(&start).scheme(scheme).dt(0.05).look_every(3);
                    let run = ensemble.lanes(lanes).watch_work().run(60).unwrap();
                    for k in 0..MEMBERS {
                        let alone = Simulation::new(law(k), start(k)).scheme(scheme).dt(0.05).record_every(3).run(60);
                        assert_eq!(ended(run.member(k)), ended(alone.as_ref()), "{k} in {lanes} lanes");
                    }
                }
            };
        }
        of!(Saddle);
        of!(Orbit);
    }
    for there in patterns {
        check(Leapfrog, start, there);
        check(DiscreteGradient, start, there);
        check(Gauss::order16(), start, there);
    }
    let one = |there: bool| {
        let law = move |_| there.then(|| Saddle::member(0));
        Ensemble::of(1).law(law).start(Saddle::start).scheme(DiscreteGradient).dt(0.05).run(9).unwrap()
    };
    assert!([true, false].into_iter().all(|there| one(there).failures().count() == 0));
}

/// Masses of coordinates, with and without a law.
#[test]
fn masses_of_coordinates() {
    fn check<S: Rides<Masses<Option<Pair>, 4>, 4> + Sync>(scheme: S) {
        let law = |k: usize| (k % 4 != 1).then(|| Pair::member(k));
        let masses = |k: usize| [1.3, 1.3, 0.4 + 0.1 * k as f64, 0.7];
        let run = Ensemble::of(45).law(law).masses(masses).start(Pair::start).scheme(scheme).dt(0.03);
        let run = run.look_every(2).watch_work().run(50).unwrap();
        for k in 0..45 {
            let alone = Simulation::new(law(k), Pair::start(k)).masses(masses(k)).scheme(scheme).dt(0.03);
            let alone = alone.record_every(2).run(50);
            assert_eq!(ended(run.member(k)), ended(alone.as_ref()), "{k}");
        }
    }
    check(Leapfrog);
    check(DiscreteGradient);
    check(Composed::order4(Implicit));
}

/// Members that are driven by a wind that blows for some of them, in scenes: on each body, on pairs with a cut-off, on the chain.
type Blown = dmech_tests::few::FewInBox<OfBlown, (), 2, 3, 6>;
type OfBlown = ((((), OnEach<Option<Saddle>>), OnChain<Option<Spring>>), OnNear<Option<LennardJones>>);

fn scene(k: usize) -> Scene<2, (), OfBlown, Periodic<2>> {
    let x = 0.01 * k as f64;
    Scene::<2>::new()
        .body(1.0 + x, [0.1, 0.2 + x], [0.3, 0.1])
        .body(1.5, [1.2, 0.3], [-0.1, 0.4 - x])
        .body(0.7, [0.4, 1.3], [0.0, x])
        .field((k % 2 == 1).then(|| Saddle::member(k)))
        .chain((!k.is_multiple_of(3)).then_some(Spring { k: 3.0, length: 1.0 - x }))
        .pairs((k % 5 < 3).then_some(LennardJones { epsilon: 0.2, sigma: 0.8 }))
        .cutoff(1.6)
        .periodic([9.0; 2])
}

#[test]
fn laws_of_a_scene() {
    macro_rules! check {
        ($($scheme:expr, $dt:expr;)*) => {$(
            let law = |k: usize| -> Blown { scene(k).as_law() };
            let run = Ensemble::of(45).scene(law).scheme($scheme).dt($dt).watch_work().run_until(2.0).unwrap();
            for k in 0..45 {
                let alone = Simulation::new(law(k), law(k).start()).scheme($scheme).dt($dt).run_until(2.0);
                assert_eq!(ended(run.member(k)), ended(alone.as_ref()), "{k}");
                let whole = Simulation::scene(scene(k)).scheme($scheme).dt($dt).run_until(2.0).unwrap();
                let (few, many) = (run.last(k).unwrap().bodies::<2>(), whole.last());
                for (few, many) in few.q.iter().flatten().zip(many.q.iter().flatten()) {
                    assert!((few - many).abs() < 1e-9, "{k}: {few} {many}");
                }
            }
        )*};
    }
    check! {
        Leapfrog, 0.01;
        DiscreteGradient, 0.02;
        Adaptive::new(Nystrom::order6(), 1e-6), 0.1;
    }
}

/// A store tells of each member whether it has a law.
#[test]
fn a_store_tells_who_has_one() {
    let place = Place::new("optional");
    let law = |k: usize| (k % 3 != 1).then(|| Orbit::member(k));
    let ensemble = || Ensemble::of(20).start(Orbit::start).scheme(Leapfrog).dt(0.01).look_every(5);
    let plain = ensemble().law(law).run_until(1.0).unwrap();
    let kept = || ensemble().law(law).store(place.file()).run_until(1.0).unwrap();
    the_same(&plain, &kept());
    place.sql("DELETE FROM last WHERE k % 4 = 1; DELETE FROM drift WHERE k % 4 = 1");
    the_same(&plain, &kept());
    assert_eq!(place.number("SELECT COUNT(*) FROM member WHERE law_there = 1 AND law_gm > 0.8"), 13);
    assert_eq!(place.number("SELECT COUNT(*) FROM member WHERE law_there = 0"), 7);
    let refused = ensemble().law(|k| law(k).filter(|_| k != 8)).store(place.file()).run_until(1.0).unwrap_err();
    let column = dmech::extend::Name::of(&["law_there"]);
    assert_eq!(refused, Error::Store(StoreError::Member { member: 8, column, store: 1.0, here: 0.0 }));
}
