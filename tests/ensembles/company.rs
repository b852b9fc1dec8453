//! Events, observers, watched quantities and streams of members: what each sees alone.

use core::ops::ControlFlow;
use core::sync::atomic::{AtomicU64, Ordering::Relaxed as Loosely};

use dmech::extend::{Company, Fields, Ranks, Rides, StoreError};
use dmech::prelude::*;
use dmech::scheme::Adaptive;

use crate::laws::{Bottle, Contact, Damped, Driven, Many, Orbit, Plummer, Saddle};
use crate::ranks::on_ranks;
use crate::same::the_same;
use crate::store::Place;

const MEMBERS: usize = 83;

/// What an observer has seen of a motion, in its order.
#[derive(Default)]
struct Seen(AtomicU64);

impl Seen {
    fn see<const D: usize>(&self, State { t, q, v }: &State<D>) {
        let add = |sum: u64, x: &f64| (sum ^ x.to_bits()).wrapping_mul(0x0100_0000_01b3).rotate_left(17);
        self.0.store([t].into_iter().chain(q).chain(v).fold(self.0.load(Loosely), add), Loosely);
    }

    fn sum(&self) -> u64 {
        self.0.load(Loosely)
    }
}

/// A place near which a member begins, and a bit beside it: some come by, some begin there, some never do.
fn place<L: Many<D>, const D: usize>(k: usize) -> f64 {
    L::start(k).q[0] - 0.01 * (k % 5) as f64
}

/// So far from its start may a member go before it is stopped.
fn bound(k: usize) -> f64 {
    if k.is_multiple_of(4) { 0.05 + 0.01 * k as f64 } else { 1e9 }
}

/// By how much a member is beyond the distance from its start at which it is sent back, if it is.
fn beyond<const D: usize>(k: usize, first: f64, state: &State<D>) -> f64 {
    if k % 4 == 3 { (state.q[0] - first).abs() - 0.03 * (1 + k % 7) as f64 } else { -1.0 }
}

/// A wall of others, on the one side.
fn within<const D: usize>(k: usize, first: f64, state: &State<D>) -> f64 {
    if k % 4 == 1 { 0.02 * (1 + k % 5) as f64 - (state.q[0] - first) } else { 1.0 }
}

/// Sends it back, and not with all of its speed.
fn back<const D: usize>(state: &mut State<D>) {
    state.v = state.v.map(|v| -0.9 * v);
}

/// So many steps are observed before the observer has enough.
fn enough(k: usize) -> u64 {
    if k % 6 == 1 { 3 + k as u64 / 2 } else { u64::MAX }
}

/// Says the same of a member and of a simulation: of two places in one step the farther is asked for first.
macro_rules! accompany {
    ($company:expr, $k:expr, $seen:expr, $law:ident, $d:ident) => {{
        let (k, seen, place, first) = ($k, $seen, place::<$law, $d>($k), $law::start($k).q[0]);
        let mut left = enough(k);
        $company
            .event(move |state: &State<$d>| state.q[0] - place, Crossing::Any)
            .event(move |state: &State<$d>| state.q[0] - place - 1e-4, Crossing::Any)
            .event(move |state: &State<$d>| state.q[0] - place + 1e-4, Crossing::Any)
            .stop_when(move |state: &State<$d>| bound(k) - (state.q[0] - first).abs(), Crossing::Falling)
            .change_when(move |state: &State<$d>| beyond(k, first, state), Crossing::Rising, back)
            .bounce_off(move |state: &State<$d>| within(k, first, state), back)
            .watch("farthest", |state: &State<$d>| state.q[0] * state.q[0])
            .observe(3, move |state: &State<$d>| {
                seen.see(state);
                left -= 1;
                if left == 0 { ControlFlow::Break(()) } else { ControlFlow::Continue(()) }
            })
    }};
}

/// Events, stops, observers, changes: how many there were.
fn as_alone<L, S, const D: usize>(scheme: S, dt: Option<f64>, end: f64, name: &str) -> [usize; 4]
where
    L: Many<D> + Fields<D>,
    S: Rides<L, D> + Sync,
{
    let mut happened = [0; 4];
    for recorded in [false, true] {
        let seen: Vec<Seen> = (0..MEMBERS).map(|_| Seen::default()).collect();
        let few: Vec<Seen> = (0..MEMBERS).map(|_| Seen::default()).collect();
        let ensemble = |seen| {
            let ensemble = Ensemble::of(MEMBERS).law(L::member).start(L::start).scheme(scheme);
            let ensemble = if let Some(dt) = dt { ensemble.dt(dt) } else { ensemble };
            let ensemble = if recorded { ensemble.record_dt(0.13) } else { ensemble.look_every(4) };
            ensemble.with(move |k, member: Company<State<D>>| accompany!(member, k, &(seen as &Vec<Seen>)[k], L, D))
        };
        let runs =
            [ensemble(&seen), ensemble(&few).lanes(7).threads(1).watch_work()].map(|all| all.run_until(end).unwrap());
        for k in 0..MEMBERS {
            let by_itself = Seen::default();
            let alone = Simulation::new(L::member(k), L::start(k)).scheme(scheme);
            let alone = if let Some(dt) = dt { alone.dt(dt) } else { alone };
            let alone = if recorded { alone.record_dt(0.13) } else { alone.record_every(4) };
            let alone = accompany!(alone, k, &by_itself, L, D).run_until(end);
            let alone = alone.unwrap_or_else(|rests| {
                assert!(matches!(rests.cause(), Error::ComesToRest { .. }), "{name}, member {k}: {rests}");
                for member in runs.each_ref().map(|run| run.member(k).unwrap_err()) {
                    assert_eq!(member.cause(), rests.cause(), "{name}, member {k}");
                }
                rests.into_run()
            });
            for (run, seen) in runs.iter().zip([&seen, &few]) {
                let member = run.member(k).unwrap_or_else(|rests| rests.run());
                let of = |run: &Run<State<D>>| (run.steps(), run.stopped(), *run.last(), run.events().to_vec());
                assert_eq!(of(member), of(&alone), "{name}, member {k}");
                assert_eq!(seen[k].sum(), by_itself.sum(), "{name}, member {k}");
                assert_eq!(member.drift_of("farthest"), alone.drift_of("farthest"), "{name}, member {k}");
                assert_eq!(member.drift_of("twice"), alone.drift_of("twice"), "{name}, member {k}");
                assert_eq!(member.drift(Invariant::Energy), alone.drift(Invariant::Energy), "{name}, member {k}");
                if let Some(work) = member.drift(Invariant::WorkEnergy) {
                    assert_eq!(Some(work), alone.drift(Invariant::WorkEnergy), "{name}, member {k}");
                }
                if recorded {
                    assert_eq!(member.states(), alone.states(), "{name}, member {k}");
                }
                let told = |run: &Run<State<D>>| {
                    let report = run.report();
                    (report.evaluations(), report.iterations(), report.rough(), report.dt_range())
                };
                assert_eq!(told(member), told(&alone), "{name}, member {k}");
            }
            assert!(runs[1].drift(k, Invariant::WorkEnergy).is_some(), "{name}, member {k}");
            let in_order = |pair: &[Event<State<D>>]| pair[0].state().t <= pair[1].state().t;
            assert!(alone.events().windows(2).all(in_order), "{name}, member {k}");
            happened[0] += alone.events().len();
            happened[1] += usize::from(alone.stopped());
            happened[3] += alone.events().iter().filter(|event| event.which() >= 4).count();
            happened[2] += usize::from(by_itself.sum() != 0);
        }
    }
    happened
}

macro_rules! table {
    ($($test:ident: $scheme:expr, $dt:expr, $end:expr, [$($law:ident),*];)*) => {$(
        #[test]
        fn $test() {
            let happened = [$(as_alone::<$law, _, _>($scheme, $dt, $end, stringify!($test $law))),*];
            let [events, stops, observed, changes] = core::array::from_fn(|i| happened.iter().map(|all| all[i]).sum::<usize>());
            assert!(changes > 30, "{happened:?}");
            assert!(events > 20 && stops > 10 && observed > 2 * MEMBERS - 10, "{happened:?}");
        }
    )*};
}

table! {
    leapfrog: Leapfrog, Some(0.05), 2.0, [Orbit, Saddle, Contact, Driven, Plummer];
    nystrom: Nystrom::order6(), Some(0.05), 2.0, [Orbit, Driven];
    boris: Boris, Some(0.05), 2.0, [Bottle];
    implicit: Implicit, Some(0.05), 2.0, [Damped, Saddle];
    kanatani: Kanatani, Some(0.05), 2.0, [Saddle];
    discrete_gradient: DiscreteGradient, Some(0.05), 2.0, [Orbit, Contact, Bottle];
    gauss: Gauss::order16(), Some(0.2), 5.0, [Orbit, Saddle];
    relaxed: Relaxed::order6(), Some(0.05), 2.0, [Orbit];
    adaptive: Adaptive::new(Nystrom::order6(), 1e-6), None, 6.0, [Orbit, Saddle];
    adaptive_exact: Adaptive::new(Composed::order4(DiscreteGradient), 1e-5), Some(0.3), 6.0, [Orbit];
}

/// Members that fail on their way, with events before: told as alone, and seen once.
#[test]
fn those_that_fail() {
    let start = |k: usize| match k % 10 {
        // Into the centre, after the plane.
        3 => State::new([0.3, 1e-3], [-0.2, 0.0]),
        7 => State::new([1.0, 0.1], [f64::MAX / 4.0, 1.0]),
        _ => Orbit::start(k),
    };
    let seen: Vec<AtomicU64> = (0..40).map(|_| AtomicU64::new(0)).collect();
    let ensemble = Ensemble::of(40).law(Orbit::member).start(start).scheme(Nystrom::order6()).dt(0.02).look_every(5);
    let run = ensemble
        .with(|k, member| {
            let seen = &seen[k];
            member.event(|state| state.q[0] - 0.2, Crossing::Any).observe(1, move |_| {
                seen.fetch_add(1, Loosely);
                ControlFlow::Continue(())
            })
        })
        .run(400)
        .unwrap();
    let mut failed = 0;
    for k in 0..40 {
        let mut steps = 0;
        let alone = Simulation::new(Orbit::member(k), start(k)).scheme(Nystrom::order6()).dt(0.02).record_every(5);
        let alone = alone.event(|state| state.q[0] - 0.2, Crossing::Any).observe(1, |_| {
            steps += 1;
            ControlFlow::Continue(())
        });
        let alone = alone.run(400);
        let of = |outcome: Result<&Run<State<2>>, &Interrupted<State<2>>>| {
            let cause = outcome.err().map(Interrupted::cause);
            let run = outcome.unwrap_or_else(Interrupted::run);
            format!("{:?} {:?} {:?} {:?}", cause, run.steps(), run.last(), run.events())
        };
        assert_eq!(of(run.member(k)), of(alone.as_ref()), "{k}");
        assert_eq!(
            run.drift(k, Invariant::Energy).map(|d| format!("{d:?}")),
            alone.as_ref().unwrap_or_else(Interrupted::run).drift(Invariant::Energy).map(|d| format!("{d:?}")),
            "{k}"
        );
        assert_eq!(seen[k].load(Loosely), steps, "{k}");
        failed += usize::from(alone.is_err());
    }
    assert!(failed > 3 && failed < 20, "{failed}");
}

/// Members that begin where they are to end, beside others: nobody sees a state twice.
#[test]
fn those_that_have_nowhere_to_go() {
    let start = |k: usize| Orbit::start(k).at_time(if k.is_multiple_of(7) { 2.0 } else { 0.1 * (k % 3) as f64 });
    let seen: Vec<Seen> = (0..30).map(|_| Seen::default()).collect();
    let adaptive = Adaptive::new(Nystrom::order6(), 1e-6);
    let ensemble = Ensemble::of(30).law(Orbit::member).start(start).scheme(adaptive).record_dt(0.1);
    let watch = |seen: &Seen, state: &State<2>| {
        seen.see(state);
        ControlFlow::Continue(())
    };
    let (seen_by, watch) = (&seen, &watch);
    let run = ensemble.with(|k, member| member.observe(1, move |state| watch(&seen_by[k], state))).run_until(2.0);
    let run = run.unwrap();
    let mut still = 0;
    for (k, seen) in seen.iter().enumerate() {
        let by_itself = Seen::default();
        let alone = Simulation::new(Orbit::member(k), start(k)).scheme(adaptive).record_dt(0.1);
        let alone = alone.observe(1, |state| watch(&by_itself, state)).run_until(2.0).unwrap();
        let member = run.member(k).unwrap();
        assert_eq!((member.steps(), member.states()), (alone.steps(), alone.states()), "{k}");
        assert_eq!(seen.sum(), by_itself.sum(), "{k}");
        still += usize::from(alone.steps() == 0);
    }
    assert_eq!(still, 5);
}

/// A stream of each, of the states that are due.
#[test]
fn a_stream_of_each() {
    let files: Vec<std::sync::Mutex<Vec<u8>>> = (0..20).map(|_| std::sync::Mutex::default()).collect();
    struct Into<'a>(&'a std::sync::Mutex<Vec<u8>>);
    impl std::io::Write for Into<'_> {
        fn write(&mut self, bytes: &[u8]) -> std::io::Result<usize> {
            self.0.lock().unwrap().write(bytes)
        }
        fn flush(&mut self) -> std::io::Result<()> {
            Ok(())
        }
    }
    for by_time in [false, true] {
        let ensemble = Ensemble::of(20).law(Orbit::member).start(Orbit::start).scheme(Leapfrog).dt(0.01);
        let ensemble = if by_time { ensemble.record_dt(0.07) } else { ensemble.look_every(30) };
        let run = ensemble.with(|k, member| member.stream(Csv::new(Into(&files[k])))).run(100).unwrap();
        for (k, file) in files.iter().enumerate() {
            let alone = Simulation::new(Orbit::member(k), Orbit::start(k)).scheme(Leapfrog).dt(0.01);
            let alone = if by_time { alone.record_dt(0.07) } else { alone.record_every(30) };
            let mut table = Vec::new();
            let alone = alone.stream(Csv::new(&mut table)).run(100).unwrap();
            let file = core::mem::take(&mut *file.lock().unwrap());
            assert_eq!(String::from_utf8(file), String::from_utf8(table), "{k}");
            assert_eq!(run.last(k).unwrap(), *alone.last());
            assert!(run.member(k).unwrap().states().is_empty());
        }
    }
}

/// Events and watched quantities from a store and from other ranks are those that were seen.
#[test]
fn from_a_store_and_from_ranks() {
    let seen = AtomicU64::new(0);
    let bare = Ensemble::of(600).law(Saddle::member).start(Saddle::start).scheme(Nystrom::order6()).dt(0.05);
    let company = |_: usize, member: Company<State<2>>| {
        let passed = |state: &State<2>| {
            seen.fetch_add(1, Loosely);
            state.q[0]
        };
        member
            .event(passed, Crossing::Any)
            .watch("height", |state| state.q[1])
            .stop_when(|state| state.q[1] + 0.16, Crossing::Falling)
            .watch("speed", |state| state.v[0])
    };
    let whole = bare.clone().with(company).run_until(9.0).unwrap();
    let [events, stopped] =
        [|run: &Run<State<2>>| run.events().len(), |run: &Run<State<2>>| usize::from(run.stopped())]
            .map(|count| whole.members().flatten().map(count).sum::<usize>());
    assert!(events > 1000 && stopped > 50 && stopped < 550, "{events} events, {stopped} stopped");

    for (ranks, threads) in [(1, 1), (2, 2), (3, 1)] {
        let runs =
            on_ranks(ranks, |rank| bare.clone().with(company).threads(threads).ranks(rank).run_until(9.0).unwrap());
        the_same(&whole, runs[0].as_ref().unwrap());
    }
    let refused = on_ranks(2, |rank| match rank.rank() {
        0 => bare.clone().with(company).ranks(rank).run_until(9.0).map(|_| ()),
        _ => bare.clone().ranks(rank).run_until(9.0).map(|_| ()),
    });
    assert!(matches!(refused[0], Err(Error::OtherEnsemble { rank: 1 })), "{refused:?}");

    let place = Place::new("company");
    let kept = || bare.clone().with(company).store(place.file()).run_until(9.0);
    the_same(&whole, &kept().unwrap());
    assert_eq!(place.number("SELECT COUNT(*) FROM event"), events as i64);
    assert_eq!(place.number("SELECT SUM(stopped) FROM last"), stopped as i64);
    assert_eq!(place.number("SELECT COUNT(*) FROM drift WHERE invariant = 'speed'"), 600);
    let before = seen.load(Loosely);
    the_same(&whole, &kept().unwrap());
    assert_eq!(seen.load(Loosely), before, "what is in the store is not moved again");
    let without = bare.clone().store(place.file()).run_until(9.0).unwrap_err();
    let words = "2 events and 2 watched quantities";
    let none = "0 events and 0 watched quantities";
    let told = |store: &dmech::extend::Name, here: &str| store.to_string() == words && here == none;
    assert!(matches!(without, Error::Store(StoreError::Company { ref store, here }) if told(store, here)), "{without}");
    // An observer may stop a member: a store without one is another.
    let observed = |k: usize, member: Company<State<2>>| company(k, member).observe(1, |_| ControlFlow::Break(()));
    let observed = bare.clone().with(observed).store(place.file()).run_until(9.0).unwrap_err();
    assert!(matches!(observed, Error::Store(StoreError::Company { .. })), "{observed}");
    place.sql(
        &["last", "drift", "event", "change"].map(|table| format!("DELETE FROM {table} WHERE k % 3 = 1;")).concat(),
    );
    the_same(&whole, &kept().unwrap());
    for (change, back) in [
        ("UPDATE event SET which = which + 1", "UPDATE event SET which = which - 1"),
        ("UPDATE last SET stopped = 1 - stopped", "UPDATE last SET stopped = 1 - stopped"),
        (
            "UPDATE drift SET invariant = 'hight' WHERE k = 5 AND invariant = 'height'",
            "UPDATE drift SET invariant = 'height' WHERE k = 5 AND invariant = 'hight'",
        ),
        ("UPDATE event SET q0 = q0 + 1", "DROP TABLE event"),
    ] {
        let where_it_is = |sql: &str| if sql.contains(" AND ") || sql.contains("DROP") { "" } else { " WHERE k = 5" };
        place.sql(&format!("{change}{}", where_it_is(change)));
        let refused = kept().unwrap_err();
        assert!(matches!(refused, Error::Store(StoreError::Changed { member: 5, .. })), "{change}: {refused}");
        place.sql(&format!("{back}{}", where_it_is(back)));
    }
    assert!(matches!(kept().unwrap_err(), Error::Store(StoreError::NotAnEnsemble)));
}

/// What is in a store is not accompanied again: files that a company opens stay as they are.
#[test]
fn a_store_opens_no_files_again() {
    let (place, made) = (Place::new("files"), AtomicU64::new(0));
    let sweep = || {
        let ensemble = Ensemble::of(40).law(Orbit::member).start(Orbit::start).scheme(Leapfrog).dt(0.01).look_every(10);
        let company = |k: usize, member: Company<State<2>>| {
            made.fetch_add(1, Loosely);
            let file = std::fs::File::create(place.file().with_extension(k.to_string())).unwrap();
            member.stream(Csv::new(file))
        };
        ensemble.with(company).store(place.file()).run(100).unwrap()
    };
    let first = sweep();
    let bytes = |k: usize| std::fs::read(place.file().with_extension(k.to_string())).unwrap();
    let written: Vec<_> = (0..40).map(bytes).collect();
    assert!(written.iter().all(|bytes| bytes.len() > 500));
    assert_eq!(made.load(Loosely), 40);
    the_same(&first, &sweep());
    assert_eq!((made.load(Loosely), (0..40).map(bytes).collect::<Vec<_>>()), (40, written));
}
