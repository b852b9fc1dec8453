//! Ensembles that several processes move; here each is a thread, and messages go through channels.

use std::path::PathBuf;
use std::sync::mpsc::{Receiver, Sender, channel};
use std::sync::{Arc, Mutex};
use std::thread;
use std::time::Duration;

use dmech::extend::{Fields, Ranks, Rides};
use dmech::models::HenonHeiles;
use dmech::prelude::*;

use crate::laws::{Contact, Damped, Driven, Many, Orbit};
use crate::same::{of, the_same};

type Message = (usize, Vec<u8>);

/// One of several that send one another messages.
pub(crate) struct Mailbox {
    rank: usize,
    boxes: Vec<Sender<Message>>,
    come: Receiver<Message>,
    /// Bytes that were sent, and the longest message.
    sent: Arc<Mutex<[usize; 2]>>,
    /// The longest that may be sent by the first rank.
    short: usize,
}

impl Ranks for Mailbox {
    fn rank(&self) -> usize {
        self.rank
    }

    fn count(&self) -> usize {
        self.boxes.len()
    }

    fn send(&self, to: usize, message: &[u8]) {
        assert!(self.rank > 0 || message.len() <= self.short, "{} bytes from the first rank", message.len());
        let mut sent = self.sent.lock().unwrap();
        *sent = [sent[0] + message.len(), sent[1].max(message.len())];
        self.boxes[to].send((self.rank, message.to_vec())).unwrap();
    }

    fn receive(&self) -> Option<Message> {
        self.come.try_recv().ok()
    }
}

/// What comes back from each rank.
pub(crate) fn on_ranks<T: Send>(count: usize, program: impl Fn(&Mailbox) -> T + Sync) -> Vec<T> {
    let (boxes, come): (Vec<_>, Vec<_>) = (0..count).map(|_| channel()).unzip();
    let sent = Arc::default();
    let ranks: Vec<_> = come
        .into_iter()
        .enumerate()
        .map(|(rank, come)| Mailbox { rank, boxes: boxes.clone(), come, sent: Arc::clone(&sent), short: 600 })
        .collect();
    thread::scope(|scope| {
        let program = &program;
        let threads: Vec<_> = ranks.into_iter().map(|rank| scope.spawn(move || program(&rank))).collect();
        threads.into_iter().map(|thread| thread.join().unwrap()).collect()
    })
}

/// On 1, 2 and 4 ranks with 1 and 2 threads each, all that can be seen of every member is what one process gives.
fn the_same_on_all<L, S, const D: usize>(scheme: S, end: f64)
where
    L: Many<D> + Fields<D>,
    S: Rides<L, D> + Sync,
{
    let members = 1003;
    let ensemble = of::<L, S, D>(members, scheme).dt(0.05).look_every(7);
    let whole = ensemble.clone().run_until(end).unwrap();
    for (ranks, threads) in [(1, 1), (1, 2), (2, 1), (2, 2), (4, 1), (4, 2)] {
        let runs = on_ranks(ranks, |rank| ensemble.clone().threads(threads).ranks(rank).run_until(end).unwrap());
        assert!(runs[1..].iter().all(Option::is_none));
        the_same(&whole, runs[0].as_ref().unwrap());
    }
}

#[test]
fn the_results_are_those_of_one_process() {
    the_same_on_all::<Orbit, _, _>(Nystrom::order6(), 1.0);
    the_same_on_all::<Driven, _, _>(Leapfrog, 1.0);
    the_same_on_all::<Contact, _, _>(DiscreteGradient, 0.5);
    the_same_on_all::<Damped, _, _>(Implicit, 0.5);
    the_same_on_all::<Orbit, _, _>(Gauss::order16(), 0.5);
}

/// Recorded states, own invariants, adaptive steps, masses.
#[test]
fn what_is_recorded_comes_home() {
    let ensemble = of::<Orbit, _, _>(203, Composed::order4(Leapfrog)).adaptive(1e-5).mass(|k| 1.0 + 0.01 * k as f64);
    let ensemble = ensemble.record_at([0.4, 0.41, 0.77, 1.5]);
    let whole = ensemble.clone().run_until(2.0).unwrap();
    assert_eq!(whole.member(200).unwrap().states().len(), 4);
    let runs = on_ranks(3, |rank| ensemble.clone().ranks(rank).run_until(2.0).unwrap());
    the_same(&whole, runs[0].as_ref().unwrap());
}

/// Members that cannot start, fail at once, or fail late, with the cause and all that they had come to.
#[test]
fn failures_come_home_with_their_numbers() {
    let start = |k: usize| match k % 50 {
        3 => State::new([0.0, 0.0], [0.0, 0.0]),
        17 => State::new([f64::NAN, 0.0], [0.0, 0.0]),
        30 => State::new([1.0, 0.0], [0.0, f64::MAX]),
        40 => State::new([1e-3, 0.0], [0.0, 0.0]),
        44 => State::new([1e-200, 0.0], [0.0, 0.0]),
        _ => Orbit::start(k),
    };
    fn check<S: Rides<Orbit, 2> + Sync>(scheme: S, start: impl Fn(usize) -> State<2> + Sync) {
        let ensemble = || Ensemble::of(300).law(Orbit::member).start(&start).scheme(scheme).dt(0.02);
        let whole = ensemble().run(400).unwrap();
        let runs = on_ranks(3, |rank| ensemble().ranks(rank).run(400).unwrap());
        the_same(&whole, runs[0].as_ref().unwrap());
        assert!(whole.failures().count() >= 18);
    }
    check(Leapfrog, start);
    check(DiscreteGradient, start);
    check(Gauss::order16(), start);
    // Over the pass of a cubic potential, and down faster and faster, until there is no number for it.
    let law = |k: usize| HenonHeiles { lambda: 1.0 + 0.001 * k as f64 };
    let start = |k: usize| State::new([0.1, 0.9 + 0.004 * k as f64], [0.0, 0.1]);
    let ensemble = || Ensemble::of(100).law(law).start(start).scheme(Leapfrog).dt(0.05);
    let whole = ensemble().run(1000).unwrap();
    let runs = on_ranks(2, |rank| ensemble().ranks(rank).run(1000).unwrap());
    assert!(whole.members().any(|member| member.is_err_and(|failed| failed.run().steps() > 50)));
    the_same(&whole, runs[0].as_ref().unwrap());
}

/// The first rank sees every member, in order, and no other rank sees any.
#[test]
fn the_first_rank_sees_all_in_order() {
    let seen = on_ranks(3, |rank| {
        let mut seen = Vec::new();
        let ensemble = of::<Driven, _, _>(2500, Leapfrog).dt(0.1).ranks(rank);
        ensemble.for_each_until(1.0, |k, outcome| seen.push((k, outcome.is_ok()))).unwrap();
        seen
    });
    assert!(seen[0].iter().copied().eq((0..2500).map(|k| (k, true))));
    assert!(seen[1].is_empty() && seen[2].is_empty());
}

/// Ensembles one after another do not disturb each other, however unlike the ranks are in speed.
#[test]
fn several_in_a_row() {
    let sums = on_ranks(4, |rank| {
        let sweep = |members: usize| {
            if rank.rank() == 2 {
                thread::sleep(Duration::from_millis(20));
            }
            let run = of::<Orbit, _, _>(members, Leapfrog).dt(0.01).threads(1).ranks(rank).run(50).unwrap();
            run.map(|run| run.checksum())
        };
        [0, 1, 7, 64, 1000, 33].map(sweep)
    });
    let alone = [0, 1, 7, 64, 1000, 33].map(|n| of::<Orbit, _, _>(n, Leapfrog).dt(0.01).run(50).unwrap().checksum());
    assert_eq!(sums[0].map(Option::unwrap), alone);
}

/// A rank that has another ensemble is named, and nobody waits for ever.
#[test]
fn another_ensemble_is_refused() {
    let with = |members: usize, end: f64, gm: f64| {
        on_ranks(3, |rank| {
            let odd = rank.rank() == 2;
            let law = move |_: usize| Orbit { gm: if odd { gm } else { 1.5 } };
            let ensemble = Ensemble::of(if odd { members } else { 500 }).law(law).start(Orbit::start).scheme(Leapfrog);
            let run = ensemble.dt(0.01).ranks(rank).run_until(if odd { end } else { 1.0 });
            run.map(|run| run.map(|run| run.len()))
        })
    };
    assert_eq!(with(500, 1.0, 1.5), [Ok(Some(500)), Ok(None), Ok(None)]);
    for other in [with(501, 1.0, 1.5), with(500, 1.1, 1.5), with(500, 1.0, 1.6)] {
        assert_eq!(other, [Err(Error::OtherEnsemble { rank: 2 }), Err(Error::FirstRank), Err(Error::FirstRank)]);
    }
    // What all refuse, each refuses.
    let refused = on_ranks(2, |rank| of::<Orbit, _, _>(5, Leapfrog).dt(-1.0).ranks(rank).run(3).err());
    assert_eq!(refused, [Some(Error::TimeStep { dt: -1.0 }); 2]);
}

/// The first rank alone writes the store; a sweep goes on with another number of ranks, and one that is refused ends them all.
#[test]
fn a_store_is_written_by_the_first() {
    let path: PathBuf = std::env::temp_dir().join(format!("dmech-ranks-{}.sqlite", std::process::id()));
    let _ = std::fs::remove_file(&path);
    let ensemble = |dt: f64| of::<Orbit, _, _>(700, Leapfrog).dt(dt).store(&path);
    let whole = of::<Orbit, _, _>(700, Leapfrog).dt(0.01).run(300).unwrap();
    let database = || rusqlite::Connection::open(&path).unwrap();
    let on = |ranks: usize| on_ranks(ranks, |rank| ensemble(0.01).ranks(rank).run(300).unwrap());
    the_same(&whole, on(3)[0].as_ref().unwrap());
    // Holes, as kills leave them.
    for table in ["last", "drift"] {
        database().execute_batch(&format!("DELETE FROM {table} WHERE k % 2 = 1 OR k > 600")).unwrap();
    }
    the_same(&whole, on(4)[0].as_ref().unwrap());
    let moved: i64 = database().query_row("SELECT COUNT(*) FROM last", [], |row| row.get(0)).unwrap();
    assert_eq!(moved, 700);
    let refused = on_ranks(3, |rank| ensemble(0.02).ranks(rank).run(300).unwrap_err());
    assert!(matches!(refused[0], Error::Store(_)), "{:?}", refused[0]);
    assert_eq!(refused[1..], [Error::FirstRank; 2]);
    let _ = std::fs::remove_file(&path);
}

/// What a member costs on its way: some hundred bytes.
#[test]
fn messages_are_short() {
    let (members, sent) = (2000, Mutex::new([0; 2]));
    on_ranks(2, |rank| {
        let run = of::<Orbit, _, _>(members, Leapfrog).dt(0.01).ranks(rank).run(1000).unwrap();
        *sent.lock().unwrap() = *rank.sent.lock().unwrap();
        run.map(|run| run.len())
    });
    let [all, longest] = sent.into_inner().unwrap();
    assert!(all > 0 && all < 400 * members && longest < 512 * 400, "{all} bytes, the longest message {longest}");
}
